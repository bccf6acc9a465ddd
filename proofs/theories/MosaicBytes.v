(** * Systems of patches: from a certificate to the checks of MosaicChecker.v, and back to its meaning *)
From Coq Require Import Reals Lra Lia NArith ZArith List Bool.
From Acutile Require Import Statement Tetrahedra Degree Domain Checker Euclid Soundness Numbers Fast Denote Pairing Format.
From Acutile Require MosaicStatement MosaicPoints MosaicPatches MosaicSides MosaicTiling MosaicChecker MosaicValences MosaicSpots MosaicSoundness MosaicSentences MosaicRotations MosaicTcp MosaicHints.
Import ListNotations.
Local Open Scope nat_scope.

(** ** The data *)
Section Ring.
Variables (A : Type) (aadd asub amul : A -> A -> A) (aofZ : Z -> A) (alt ale : A -> A -> bool).
Variables (content : list A -> Z) (quot : Z -> A -> A).
Variables (fit : number -> bool) (inn : number -> A).
Notation spot := (MosaicChecker.spot A).
Notation Spot := (MosaicChecker.Spot A).
Notation kpatch := (MosaicChecker.kpatch A).
Notation no_spot := (MosaicChecker.no_spot A aofZ).
(** A list of three coordinates. *)
Definition v3_of (l : list A) : v3 A := match l with [x; y; z] => V3 A x y z | _ => vzero A aofZ end.
Definition vertex_spot (w : patch_witness) (v : list number) : spot := Spot (aofZ (q_denominator w)) (v3_of (map inn v)).
Definition corner_spot (w : patch_witness) (q : Denote.corner) : spot :=
  MosaicChecker.spot_lift A aadd amul aofZ (shift3 (snd q)) (vertex_spot w (nth (N.to_nat (fst q)) (q_vertices w) [])).
Definition start_spot (T : polygon) (w : patch_witness) (o v : list number) : spot :=
  Spot (aofZ (q_denominator w * t_denominator T))
    (v3_of (map (fun x => amul (aofZ (t_denominator T)) (inn x)) o ++ map (fun x => amul (aofZ (q_denominator w)) (inn x)) v)).
Definition corners_of (w : patch_witness) (t : list Denote.corner) : MosaicChecker.corners A :=
  match map (corner_spot w) t with [p; q; r; s] => (p, q, r, s) | _ => (no_spot, no_spot, no_spot, no_spot) end.
Definition kpatch_of (Tw : polygon * patch_witness) : kpatch := let '(T, w) := Tw in
  MosaicChecker.KPatch A (map (fun e => let '(o, v, c) := e in (c, start_spot T w o v)) (combine (combine (q_offsets w) (t_vertices T)) (t_classes T)))
    (map (fun y => (corner_spot w (fst y), map (corner_spot w) (snd y))) (q_pyramids w)) (map (corners_of w) (q_simplices w)).
Definition names_of (w : patch_witness) : MosaicHints.names :=
  MosaicHints.Names (map (map corner3) (q_simplices w)) (map (fun y => (corner3 (fst y), map corner3 (snd y))) (q_pyramids w)).
Definition label_of (w : patch_witness) : MosaicValences.label A := let ns := names_of w in
  MosaicValences.Label A (map (vertex_spot w) (q_vertices w)) (MosaicHints.n_pieces ns) (MosaicHints.n_pyramids ns).
(** What the theorem needs of the form. *)
Definition fit_corner (w : patch_witness) (q : Denote.corner) : bool := N.ltb (fst q) (N.of_nat (length (q_vertices w))).
Definition fit_patch (r : nat) (Tw : polygon * patch_witness) : bool := let '(T, w) := Tw in
  Z.ltb 0 (t_denominator T) && Z.ltb 0 (q_denominator w) &&
  forallb (fun o => Nat.eqb (length o) r && forallb fit o) (q_offsets w) && forallb (fun v => Nat.eqb (length v) (3 - r) && forallb fit v) (t_vertices T) &&
  forallb (triple fit) (q_vertices w) &&
  forallb (fun y => fit_corner w (fst y) && forallb (fit_corner w) (snd y)) (q_pyramids w) &&
  forallb (fun t => Nat.eqb (length t) 4 && forallb (fit_corner w) t) (q_simplices w).
Definition fit_patch_sentence (s : sentence) : bool := match s with
  | FaceToFaceTiling | IsAcute | IsNonobtuse | IsDelaunay | IsWeaklyDelaunay | IsTCP => true
  | LargestAngle _ _ p _ | SmallestAngle _ _ p _ | SquaredRatio _ p _ => fit p
  | _ => false end.
Definition no_part (_ : Z) (_ : A) : Z := 0%Z.
Definition patches_proved (k : patches_claim) (ws : list patch_witness) : bool :=
  let r := fibre_rank k in let t := as_tiling k in
  if (Nat.eqb r 1 || Nat.eqb r 2) && gram_shape fit t && Nat.eqb (length ws) (length (polygons k)) && states_tiling t &&
    forallb (fit_patch r) (combine (polygons k) ws) && forallb fit_patch_sentence (patch_sentences k) then
    let g := gram3 A aofZ inn t in
    let system := map kpatch_of (combine (polygons k) ws) in
    let '(h, apexes, home) := MosaicHints.found A aadd asub amul aofZ ale content quot g r system (map names_of ws) in
    let turnings := MosaicHints.find_turnings A aadd asub amul aofZ ale content quot g r system in
    if MosaicChecker.check_system A aadd asub amul aofZ alt ale content quot g r system h apexes home then
      if forallb (MosaicChecker.check_sentence A aadd asub amul aofZ alt ale content quot g r system h apexes)
        (flat_map (statement_of A no_part inn) (filter (fun s => negb (is_tcp s)) (patch_sentences k))) then
        if MosaicChecker.check_heights A aadd asub amul aofZ alt ale content quot g r system turnings then
          if existsb is_tcp (patch_sentences k) then
            let labels := map label_of ws in
            MosaicValences.check_tcp A aadd asub amul aofZ alt ale content quot g r system h labels
              (MosaicHints.neighbours A aadd asub amul aofZ ale content quot g r system labels) (MosaicHints.find_samples A aadd amul aofZ turnings) turnings
          else true
        else false
      else false
    else false
  else false.
End Ring.

(** ** The link *)
Local Open Scope R_scope.
Section Link.
Variables (A : Type) (aadd asub amul : A -> A -> A) (aofZ : Z -> A) (alt ale : A -> A -> bool).
Variables (content : list A -> Z) (quot : Z -> A -> A).
Variables (fit : number -> bool) (inn : number -> A).
Variables (phi : A -> R) (a : valuation).
Hypothesis phi_add : forall x y, phi (aadd x y) = phi x + phi y.
Hypothesis phi_sub : forall x y, phi (asub x y) = phi x - phi y.
Hypothesis phi_mul : forall x y, phi (amul x y) = phi x * phi y.
Hypothesis phi_Z : forall z, phi (aofZ z) = IZR z.
Hypothesis alt_ok : forall x y, alt x y = true -> phi x < phi y.
Hypothesis ale_ok : forall x y, ale x y = true -> phi x <= phi y.
Hypothesis inn_ok : forall x, fit x = true -> phi (inn x) = value a x.
Notation rp := (MosaicSpots.rp A phi).
Notation pos := (MosaicSpots.pos A phi).

Lemma v3_point l : phi3 A phi (v3_of A aofZ l) = as_point (map phi l).
Proof.
  unfold v3_of. destruct l as [|x [|y [|z [|? ?]]]]; try reflexivity; unfold phi3, vzero, Checker.zero, origin; cbn; rewrite ?phi_Z; reflexivity.
Qed.
Lemma scaled_point d l : 0 < d -> as_point (map (fun x => x / d) l) = scale (/ d) (as_point l).
Proof.
  intros D. assert (O : origin = scale (/ d) origin) by (apply point_eq; unfold scale, origin; cbn; ring).
  destruct l as [|x [|y [|z [|? ?]]]]; cbn [map as_point]; auto. apply point_eq; unfold scale; cbn; unfold Rdiv; ring.
Qed.
Lemma fits_value l : forallb fit l = true -> map phi (map inn l) = map (value a) l.
Proof. rewrite forallb_forall. intros H. rewrite map_map. apply map_ext_in. intros x Hx. apply inn_ok, H, Hx. Qed.
Lemma vertex_pos w v : (0 < q_denominator w)%Z -> pos (vertex_spot A aofZ inn w v).
Proof. intros D. unfold MosaicSpots.pos, vertex_spot; cbn. rewrite phi_Z. apply IZR_lt, D. Qed.
Lemma vertex_ok w v : (0 < q_denominator w)%Z -> forallb fit v = true -> rp (vertex_spot A aofZ inn w v) = as_point (over_denominator a (q_denominator w) v).
Proof.
  intros D F. unfold MosaicSpots.rp, vertex_spot; cbn [MosaicChecker.weight MosaicChecker.numerators]. rewrite phi_Z, v3_point, (fits_value v F).
  unfold over_denominator. rewrite <- (map_map (value a) (fun x => x / IZR (q_denominator w))). symmetry. apply scaled_point, IZR_lt, D.
Qed.
Lemma corner_ok w q : (0 < q_denominator w)%Z -> forallb (triple fit) (q_vertices w) = true -> fit_corner w q = true ->
  rp (corner_spot A aadd amul aofZ inn w q) = patch_point a w q.
Proof.
  intros D V C. unfold corner_spot. rewrite (MosaicSpots.lift_ok A aadd amul aofZ phi phi_add phi_mul phi_Z) by (apply vertex_pos, D).
  unfold fit_corner in C. apply N.ltb_lt in C. rewrite forallb_forall in V.
  assert (I : In (nth (N.to_nat (fst q)) (q_vertices w) []) (q_vertices w)) by (apply nth_In; lia). specialize (V _ I).
  destruct (nth (N.to_nat (fst q)) (q_vertices w) []) as [|x [|y [|z [|? ?]]]] eqn:E; try discriminate.
  rewrite vertex_ok; [|exact D|cbn in *; rewrite !andb_true_iff in V; destruct V as [[-> ->] ->]; reflexivity].
  unfold patch_point. rewrite E. unfold over_denominator; cbn [map as_point].
  destruct (snd q) as [|s1 [|s2 [|s3 s]]]; cbn [shift3 moved as_point]; unfold MosaicPoints.lift, MosaicPoints.pt, z30; apply point_eq; unf; ring.
Qed.
Lemma start_ok T w o v : (0 < q_denominator w)%Z -> (0 < t_denominator T)%Z -> forallb fit o = true -> forallb fit v = true ->
  rp (start_spot A amul aofZ inn T w o v) = as_point (over_denominator a (q_denominator w) o ++ over_denominator a (t_denominator T) v).
Proof.
  intros D E Fo Fv. unfold MosaicSpots.rp, start_spot; cbn [MosaicChecker.weight MosaicChecker.numerators]. rewrite phi_Z, v3_point, map_app, !map_map.
  apply IZR_lt in D as D', E as E'. rewrite mult_IZR. rewrite <- scaled_point by (apply Rmult_lt_0_compat; auto). f_equal. rewrite map_app, !map_map. f_equal.
  - apply map_ext_in. intros x Hx. rewrite forallb_forall in Fo. rewrite phi_mul, phi_Z, inn_ok by (apply Fo, Hx). field. lra.
  - apply map_ext_in. intros x Hx. rewrite forallb_forall in Fv. rewrite phi_mul, phi_Z, inn_ok by (apply Fv, Hx). field. lra.
Qed.
Lemma patch_link r Tw : fit_patch fit r Tw = true -> MosaicSpots.rpatch A phi (kpatch_of A aadd amul aofZ inn Tw) = real_patch a Tw.
Proof.
  destruct Tw as [T w]. unfold fit_patch. rewrite !andb_true_iff, !Z.ltb_lt. intros [[[[[[DT DW] FO] FV] V] FP] FS].
  unfold MosaicSpots.rpatch, kpatch_of, real_patch, patch_edges; cbn [MosaicChecker.k_edges MosaicChecker.k_pyramids MosaicChecker.k_pieces]. rewrite !map_map. f_equal.
  - apply map_ext_in. intros [[o v] c] I. cbn [fst snd]. f_equal. apply in_combine_l in I.
    pose proof (in_combine_l _ _ _ _ I) as Io. pose proof (in_combine_r _ _ _ _ I) as Iv. rewrite forallb_forall in FO, FV. specialize (FO _ Io). specialize (FV _ Iv).
    apply andb_true_iff in FO as [_ FO]. apply andb_true_iff in FV as [_ FV]. apply start_ok; auto.
  - apply map_ext_in. intros y I. rewrite forallb_forall in FP. specialize (FP _ I). apply andb_true_iff in FP as [F1 F2]. cbn [fst snd]. f_equal; [apply corner_ok; auto|].
    rewrite map_map. apply map_ext_in. intros q Hq. rewrite forallb_forall in F2. apply corner_ok; auto.
  - apply map_ext_in. intros t I. rewrite forallb_forall in FS. specialize (FS _ I). apply andb_true_iff in FS as [L F]. apply Nat.eqb_eq in L. rewrite forallb_forall in F.
    destruct t as [|p [|q [|s [|u [|? ?]]]]]; try discriminate. unfold corners_of, patch_tetrahedron; cbn [map MosaicSpots.rtet].
    rewrite !corner_ok by (auto; apply F; cbn; auto). reflexivity.
Qed.
Lemma gram_right G : (exists l1 l2 l3, has_gram G l1 l2 l3) -> gpos G -> exists l1 l2 l3, has_gram G l1 l2 l3 /\ 0 < det l1 l2 l3.
Proof.
  intros [l1 [l2 [l3 HG]]] [_ [_ D]]. pose proof (gram_det _ _ _ _ HG) as E. destruct (Rlt_dec 0 (det l1 l2 l3)) as [P|N]; [eauto|].
  exists (scale (-1) l1), (scale (-1) l2), (scale (-1) l3). split.
  - destruct HG as [H1 [H2 [H3 [H4 [H5 H6]]]]]. unfold has_gram in *. rewrite <- H1, <- H2, <- H3, <- H4, <- H5, <- H6. unfold dot; cbn. repeat split; ring.
  - assert (X : det (scale (-1) l1) (scale (-1) l2) (scale (-1) l3) = - det l1 l2 l3) by (unf; ring). rewrite X. nra.
Qed.
Theorem patches_link k ws : patches_proved A aadd asub amul aofZ alt ale content quot fit inn k ws = true -> holds_over_mosaics a k ws.
Proof.
  unfold patches_proved. destruct (_ && _) eqn:S; [|discriminate]. rewrite !andb_true_iff in S. destruct S as [[[[[S1 S2] S3] S4] S5] S6].
  apply Nat.eqb_eq in S3. rewrite forallb_forall in S5, S6.
  assert (RK : fibre_rank k = 1%nat \/ fibre_rank k = 2%nat) by (apply orb_true_iff in S1; rewrite !Nat.eqb_eq in S1; exact S1).
  set (g := gram3 A aofZ inn (as_tiling k)). set (system := map (kpatch_of A aadd amul aofZ inn) (combine (polygons k) ws)).
  destruct (MosaicHints.found _ _ _ _ _ _ _ _ _ _ _ _) as [[h apexes] home].
  destruct (MosaicChecker.check_system _ _ _ _ _ _ _ _ _ _ _ _ _ _ _) eqn:CS; [|discriminate]. destruct (forallb _ (flat_map _ _)) eqn:CT; [|discriminate].
  rewrite forallb_forall in CT. set (turnings := MosaicHints.find_turnings _ _ _ _ _ _ _ _ _ _ _). set (labels := map _ ws). set (neighbours := MosaicHints.neighbours _ _ _ _ _ _ _ _ _ _ _ _).
  set (samples := MosaicHints.find_samples _ _ _ _ _). clearbody turnings labels neighbours samples. destruct (MosaicChecker.check_heights _ _ _ _ _ _ _ _ _ _ _ _ _) eqn:CH; [|discriminate]. intros TCP.
  assert (GE : gram_of (as_tiling k) a = phiG A phi g).
  { unfold gram_shape in S2. unfold g, gram3, gram_of. cbn [dimension as_tiling gram_rows] in *.
    destruct (base_gram k) as [|[|x [|y [|z [|? ?]]]] [|[|u [|v [|? ?]]] [|[|t [|? ?]] [|? ?]]]]; try discriminate.
    cbn [forallb] in S2. rewrite !andb_true_iff in S2. unfold phiG; cbn [k11 k22 k33 k12 k13 k23]. decompose [and] S2. rewrite !inn_ok by assumption. reflexivity. }
  assert (SE : system_of a k ws = map (MosaicSpots.rpatch A phi) system).
  { unfold system_of, system. rewrite map_map. apply map_ext_in. intros Tw I. symmetry. apply (patch_link (fibre_rank k)), S5, I. }
  unfold holds_over_mosaics. split; [exact S3|]. split.
  { apply (existsb_exists _ (patch_sentences k)) in S4 as [s [I F]]. destruct s; try discriminate. exact I. }
  assert (GP : gpos (phiG A phi g)).
  { pose proof CS as X. unfold MosaicChecker.check_system in X. rewrite !andb_true_iff in X. destruct X as [[[_ X] _] _]. unfold chk_gram in X. rewrite !andb_true_iff in X. destruct X as [[X1 X2] X3].
    apply alt_ok in X1, X2, X3. unfold Checker.zero in *. rewrite phi_Z in *. rewrite (phi_gdet A aadd asub amul phi phi_add phi_sub phi_mul) in X3. rewrite phi_sub, !phi_mul in X2. unfold gpos, phiG at 1 2 3 4 5; cbn. auto. }
  cbv zeta. rewrite GE. split; [apply gram_right; [apply gram_exists, GP|exact GP]|]. intros l1 l2 l3 HG RH. rewrite SE. split.
  - apply (MosaicRotations.heights_ok A aadd asub amul aofZ alt ale content quot phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok g (fibre_rank k) RK system h apexes home CS l1 l2 l3 HG RH turnings CH).
  - intros s Is. specialize (S6 s Is). unfold patches_sentence. rewrite GE, SE.
    assert (ST : is_tcp s = false -> forall c, In c (statement_of A (no_part A) inn s) -> MosaicChecker.check_sentence A aadd asub amul aofZ alt ale content quot g (fibre_rank k) system h apexes c = true).
    { intros NT c Ic. apply CT. apply in_flat_map. exists s. split; [apply filter_In; split; [exact Is|rewrite NT; reflexivity]|exact Ic]. }
    destruct s as [| | |rel sg p q|rel sg p q|rel p q|l p q| | | | | |]; cbn [fit_patch_sentence] in S6; try discriminate; cbn [statement_of In] in ST;
    try (specialize (ST eq_refl _ (or_introl eq_refl)); cbn [MosaicChecker.check_sentence] in ST).
    + apply (MosaicSentences.tiles_all A aadd asub amul aofZ alt ale content quot phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok g (fibre_rank k) RK system h apexes home CS); auto.
    + apply (MosaicSentences.acute_all A aadd asub amul aofZ alt ale content quot phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok g (fibre_rank k) RK system h apexes home CS); auto.
    + apply (MosaicSentences.nonobtuse_all A aadd asub amul aofZ alt ale content quot phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok g (fibre_rank k) RK system h apexes home CS); auto.
    + pose proof (MosaicSentences.largest_all A aadd asub amul aofZ alt ale content quot phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok g (fibre_rank k) RK system h apexes home CS l1 l2 l3 HG RH rel sg (inn p) q ST) as X.
      unfold dangle in X. rewrite inn_ok in X by assumption. exact X.
    + pose proof (MosaicSentences.smallest_all A aadd asub amul aofZ alt ale content quot phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok g (fibre_rank k) RK system h apexes home CS l1 l2 l3 HG RH rel sg (inn p) q ST) as X.
      unfold dangle in X. rewrite inn_ok in X by assumption. exact X.
    + pose proof (MosaicSentences.ratio_all A aadd asub amul aofZ alt ale content quot phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok g (fibre_rank k) RK system h apexes home CS l1 l2 l3 HG RH rel (inn p) q ST) as X.
      rewrite inn_ok in X by assumption. exact X.
    + apply (MosaicSentences.delaunay_all A aadd asub amul aofZ alt ale content quot phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok g (fibre_rank k) RK system h apexes home CS); auto.
    + apply (MosaicSentences.weakly_delaunay_all A aadd asub amul aofZ alt ale content quot phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok g (fibre_rank k) RK system h apexes home CS); auto.
    + assert (IT : existsb is_tcp (patch_sentences k) = true) by (apply existsb_exists; exists IsTCP; auto). rewrite IT in TCP.
      apply (MosaicTcp.tcp_all A aadd asub amul aofZ alt ale content quot phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok g (fibre_rank k) RK system h apexes home CS labels neighbours samples turnings TCP CH l1 l2 l3 HG RH).
Qed.
End Link.
