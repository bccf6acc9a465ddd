(** * The theorem on regions, from the checks to Euclidean space *)
Require Import Reals Lra Psatz NArith Nnat ZArith List Lia Bool FunctionalExtensionality.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Facets Region Domain Bounds Euclid Transfer Checker Keys Soundness Delaunay RegionStatement Fast Grid RegionChecker RegionSoundness.
Import ListNotations.
Open Scope R_scope.

Section Ring.
Variables (A : Type) (aadd asub amul : A -> A -> A) (aofZ : Z -> A) (alt ale : A -> A -> bool).
Variable part : Z -> A -> Z.
Variable phi : A -> R.
Hypothesis phi_add : forall x y, phi (aadd x y) = (phi x + phi y)%R.
Hypothesis phi_sub : forall x y, phi (asub x y) = (phi x - phi y)%R.
Hypothesis phi_mul : forall x y, phi (amul x y) = (phi x * phi y)%R.
Hypothesis phi_Z : forall z, phi (aofZ z) = IZR z.
Hypothesis alt_ok : forall x y, alt x y = true -> (phi x < phi y)%R.
Hypothesis ale_ok : forall x y, ale x y = true -> (phi x <= phi y)%R.
Notation check_region := (check_region A aadd asub amul aofZ alt ale part).

Section Sound.
Variable c : cert A.
Let den := c_den A c.
Let h := IZR den.
Let vs := c_verts A c.
Let N := length (c_tets A c).
Let r := c_rank A c.
Notation phi3 := (phi3 A phi).
Notation phiT := (phiT A phi).
Notation kpos := (kpos A aadd aofZ).
Notation rp := (rp A aadd aofZ phi c).
Notation rtri := (rtri A aadd aofZ phi c).
Notation cT := (cT A aadd aofZ phi c).
Notation cM := (cM A c).
Notation piece := (Degree.piece cT h).
Notation valid := (Degree.valid N (latb r)).
Notation at_ := (pos A aadd aofZ den vs).
Notation separated := (chk_separated A aadd asub amul aofZ alt ale at_).
Notation uncovers := (chk_uncovered A aadd asub amul aofZ alt at_).
Notation facets := (open_facets (c_tets A c)).
Notation boundary := (Region.boundary N (latb r) cM).
Notation face := (Region.face cT h).
Hypothesis CHK : check_region c = true.

Lemma units_of_rank es : let u := units_of r den es in u_rank u = r /\ u_den u = den.
Proof.
  unfold units_of. cbv zeta. generalize (64 * fold_left (fun (n : Z) (_ : Z3) => Z.succ n) es 0 + 4096)%Z as most.
  generalize (Z.max 1 (fold_left (fun (m : Z) (e : Z3) => let '(x, y, z) := e in (m + x + y + z)%Z) es 0%Z / (3 * fold_left (fun (n : Z) (_ : Z3) => Z.succ n) es 0%Z))) as w.
  generalize 64%nat as fuel. intros fuel. induction fuel as [|fuel IH]; intros w most; cbn [wide_enough]; [split; reflexivity|].
  destruct (Z.leb _ _); [split; reflexivity|apply IH].
Qed.
Lemma chk_parts : based A aadd asub amul aofZ alt c /\ region_mates r (tabulate (c_tets A c)) 0%N (c_tets A c) = true /\ facets <> [] /\
  exists u, (u_rank u = r /\ u_den u = den) /\ (0 < u_cells u)%Z /\ (0 < u_width u)%Z /\
    chk_boundary A aadd asub amul aofZ alt ale part at_ u (c_tets A c) facets = true.
Proof.
  pose proof CHK as H. unfold RegionChecker.check_region in H. cbv zeta in H. fold den vs r in H.
  replace (fast_pos A aadd aofZ den (tabulate vs)) with at_ in H by (apply functional_extensionality; intros q; symmetry; apply fast_pos_eq).
  rewrite !andb_true_iff in H. destruct H as [[[[[H1 _] H3] H4] H5] [[[H6 H7] H8] H9]]. split; [|split; [|split]]; auto.
  - split; [apply Z.ltb_lt; auto|]. split; auto. intros t Ht. rewrite forallb_forall in H3. apply (H3 t Ht).
  - intros E. rewrite E in H6. discriminate.
  - eexists. split; [apply units_of_rank|]. split; [apply Z.ltb_lt, H7|]. split; [apply Z.ltb_lt, H8|]. exact H9.
Qed.
Lemma base : based A aadd asub amul aofZ alt c.
Proof. apply chk_parts. Qed.
Lemma hpos : 0 < h.
Proof. apply (h_pos A aadd asub amul aofZ alt c base). Qed.
Lemma rvol k : (k < N)%nat -> 0 < vol (cT k).
Proof. apply (cvol A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c base). Qed.
Lemma tet k : (k < N)%nat -> exists t, nth_error (c_tets A c) k = Some t /\ In t (c_tets A c) /\ cT k = phiT (kpos den vs t).
Proof. intros Hk. destruct (get A c k Hk) as [t [E I]]. exists t. split; auto. split; auto. apply cT_eq, E. Qed.

Lemma region_mates_spec tm : forall ts k, region_mates r tm k ts = true ->
  forall j t i, nth_error ts j = Some t -> In i I4 -> region_mate r tm (k + N.of_nat j)%N t i = true.
Proof.
  induction ts as [|t0 ts IH]; intros k H j t i E Hi; [destruct j; discriminate|].
  cbn [region_mates] in H. destruct (forallb _ I4) eqn:F; [|discriminate]. destruct j as [|j].
  - injection E as <-. rewrite forallb_forall in F. replace (k + N.of_nat 0)%N with k by lia. apply F, Hi.
  - replace (k + N.of_nat (S j))%N with (N.succ k + N.of_nat j)%N by lia. apply IH; auto.
Qed.
Lemma rmate k i : (k < N)%nat -> In i I4 ->
  match cM k i with
  | Some (k', i', d) =>
    (k' < N)%nat /\ In i' I4 /\ latb r d = true /\ cM k' i' = Some (k, i, zopp3 d) /\
    opposite (facet (cT k) i) (facet (translate (vec h d) (cT k')) i')
  | None => True
  end.
Proof.
  intros Hk Hi. destruct (tet k Hk) as [t [E [I ET]]]. destruct chk_parts as [_ [M _]].
  pose proof (region_mates_spec _ _ _ M k t i E Hi) as C. rewrite N.add_0_l in C.
  destruct (cM k i) as [[[k1 i1] d1]|] eqn:EM; auto. unfold Soundness.cM in EM. rewrite E in EM.
  destruct (mt t i) as [[[k' i'] d]|] eqn:Em; [|discriminate]. injection EM as <- <- <-.
  unfold region_mate in C. rewrite Em, !andb_true_iff, entry_tabulate in C. destruct C as [[C1 C0] C2]. apply N.ltb_lt in C1.
  destruct (nth_error (c_tets A c) (N.to_nat k')) as [t'|] eqn:E'; [|discriminate].
  apply andb_true_iff in C2 as [C2 C3]. apply meqb_t in C2. apply (codd_oddm A aadd aofZ phi phi_add phi_Z c) in C3.
  split; [|split; [|split; [|split]]]; auto.
  - apply nth_error_Some. rewrite E'. discriminate.
  - apply I4_lt. lia.
  - unfold Soundness.cM. rewrite E', C2. rewrite !Nnat.Nat2N.id. auto.
  - rewrite ET, (cT_eq A aadd aofZ phi c _ t' E'), facet_translate. rewrite !rtri_fc in C3. exact C3.
Qed.

(** ** Corners and boxes *)
Lemma facet_tet t i q : In q (facet_corners t i) -> In q (tet_corners t).
Proof. destruct i as [|[|[|i]]]; simpl; tauto. Qed.
Lemma rp_move n q : rp (cshift n q) = add (rp q) (vec h n).
Proof. apply rp_shift; auto. Qed.
Lemma corners_facet t i : corners (rtri (cfc t i)) = map rp (facet_corners t i).
Proof. destruct i as [|[|[|i]]]; reflexivity. Qed.
Lemma corners_moved t i n : corners (translate_triangle (vec h n) (rtri (cfc t i))) = map rp (map (cshift n) (facet_corners t i)).
Proof.
  rewrite corners_translate, corners_facet, !map_map. apply map_ext. intros q. symmetry. apply rp_move.
Qed.
Lemma face_eq k n i t : nth_error (c_tets A c) k = Some t -> face ((k, n), i) = translate_triangle (vec h n) (rtri (cfc t i)).
Proof.
  intros E. unfold Region.face, Degree.piece; cbn [fst snd]. rewrite facet_translate, (cT_eq A aadd aofZ phi c _ t E), rtri_fc. reflexivity.
Qed.
Lemma translate_twice a b f : translate_triangle (vec h a) (translate_triangle (vec h b) f) = translate_triangle (vec h (zadd3 a b)) f.
Proof.
  unfold translate_triangle; cbn [t1 t2 t3]. rewrite vec_add. rewrite <- !padd_assoc, (padd_comm (vec h b)). reflexivity.
Qed.
Lemma latb_opp n : latb r n = true -> latb r (zopp3 n) = true.
Proof. rewrite !latb_iff. destruct n as [[? ?] ?]. unfold in_lattice, zopp3. destruct r as [|[|[|]]]; lia. Qed.
Lemma boundary_facet k n i : boundary ((k, n), i) -> exists t, nth_error (c_tets A c) k = Some t /\ In t (c_tets A c) /\ In (N.of_nat k, t, i) facets /\ latb r n = true.
Proof.
  intros [[Hk Hn] [Hi U]]. cbn [fst snd] in *. destruct (tet k Hk) as [t [E [I _]]]. exists t. repeat split; auto. apply open_facets_In. rewrite Nnat.Nat2N.id. repeat split; auto.
  unfold Degree.paired in U; cbn [fst snd] in U. unfold Soundness.cM in U. rewrite E in U. destruct (mt t i) as [[[? ?] ?]|]; auto. exfalso; apply U; discriminate.
Qed.

(** ** 2. The hypotheses of Region.v *)
(** Corners in boxes, and what is not among the candidates. *)
Lemma corner_box u b l n q : u_rank u = r /\ u_den u = den ->
  chk_box A amul aofZ alt ale u b (map at_ l) = true -> latb r n = true -> In q l -> in_box u b n (rp (cshift n q)).
Proof.
  intros U B L Hq. rewrite rp_move. apply (box_move A c u U b n _ L).
  apply (box_sound A amul aofZ alt ale phi phi_mul phi_Z alt_ok ale_ok u b (map at_ l)); auto. apply in_map, Hq.
Qed.
Lemma boxed_In {X} u (corners : X -> list corner) l b x : In (b, x) (boxed A amul aofZ alt part at_ u corners l) <-> In x l /\ b = box_of A amul aofZ alt part u (map at_ (corners x)).
Proof.
  unfold boxed. rewrite fast_map_eq, in_map_iff. split.
  - intros [x' [E H]]. injection E as <- <-. auto.
  - intros [H ->]. exists x. auto.
Qed.
(** Two boundary facets; a boundary facet and a tile. *)
Definition splits (ps qs : list point) := exists w, affine w /\ (forall x, In x ps -> w x < 0) /\ (forall x, In x qs -> 0 < w x).
Lemma checked_pairs k t i : In (k, t, i) facets ->
  (forall k' t' i' n, In (k', t', i') facets -> latb r n = true -> ~ (k = k' /\ i = i' /\ n = z30) ->
    separated (facet_corners t i) (map (cshift n) (facet_corners t' i')) = true \/
    splits (map rp (facet_corners t i)) (map rp (map (cshift n) (facet_corners t' i')))) /\
  (forall k' t' n, nth_error (c_tets A c) (N.to_nat k') = Some t' -> latb r n = true -> ~ (k = k' /\ n = z30) ->
    uncovers (facet_corners t i) (moved_tet n t') = true \/ splits (map rp (facet_corners t i)) (map rp (map (cshift n) (tet_corners t')))).
Proof.
  intros Hf. destruct chk_parts as [_ [_ [_ [u [U [CP [WP H]]]]]]]. unfold chk_boundary in H. cbv zeta in H. rewrite !andb_true_iff in H.
  destruct H as [[HT HF] H]. unfold chk_boxed in HT, HF. rewrite forallb_forall in HT, HF, H.
  set (tets := boxed A amul aofZ alt part at_ u tet_of (numbered_tets (c_tets A c))) in *. set (fs := boxed A amul aofZ alt part at_ u facet_of facets) in *.
  set (bf := box_of A amul aofZ alt part u (map at_ (facet_corners t i))).
  assert (If : In (bf, (k, t, i)) fs) by (apply boxed_In; auto). pose proof (HF _ If) as Bf. cbn [fst snd] in Bf. unfold facet_of in Bf; cbn [fst snd] in Bf.
  specialize (H _ If). cbn [fst snd] in H. unfold chk_facet in H. apply andb_true_iff in H as [H1 H2]. rewrite forallb_forall in H1, H2.
  pose proof (box_proper A amul aofZ alt ale u _ _ Bf) as Pf. destruct U as [UR UD].
  assert (NE : forall f : corner -> point, map f (facet_corners t i) <> []) by (intros f; destruct i as [|[|[|?]]]; discriminate).
  assert (Z0 : forall x, In x (map rp (facet_corners t i)) -> in_box u bf z30 x).
  { intros x Hx. apply in_map_iff in Hx as [q [<- Hq]]. replace (rp q) with (rp (cshift z30 q)).
    - apply corner_box with (l := facet_corners t i); auto. apply latb_zero.
    - rewrite rp_move. apply point_eq; unfold vec, z30, add; cbn [px py pz]; ring. }
  split.
  - intros k' t' i' n Hg L Ne. set (bg := box_of A amul aofZ alt part u (map at_ (facet_corners t' i'))).
    assert (Ig : In (bg, (k', t', i')) fs) by (apply boxed_In; auto). pose proof (HF _ Ig) as Bg. cbn [fst snd] in Bg. unfold facet_of in Bg; cbn [fst snd] in Bg.
    pose proof (box_proper A amul aofZ alt ale u _ _ Bg) as Pg.
    destruct (meet (u_rank u) (u_cells u) n bf bg) eqn:M.
    + left. rewrite <- UR in L. pose proof (candidates_all (u_rank u) (u_cells u) CP fs bf bg (k', t', i') n Ig Pf Pg L M) as IC.
      specialize (H1 _ IC). cbv beta iota in H1. destruct (N.eqb k k' && Nat.eqb i i' && z3eqb n z30) eqn:E; auto. exfalso. apply Ne.
      rewrite !andb_true_iff, N.eqb_eq, Nat.eqb_eq, z3eqb_t in E. tauto.
    + right. apply (far_apart A c u (conj UR UD) WP hpos n bf bg); auto.
      * destruct i' as [|[|[|?]]]; discriminate.
      * intros x Hx. apply in_map_iff in Hx as [q' [<- Hq]]. apply in_map_iff in Hq as [q [<- Hq]]. apply corner_box with (l := facet_corners t' i'); auto.
  - intros k' t' n Hg L Ne. set (bg := box_of A amul aofZ alt part u (map at_ (tet_corners t'))).
    assert (Ig : In (bg, (k', t')) tets) by (apply boxed_In; split; auto; apply numbered_tets_In, Hg). pose proof (HT _ Ig) as Bg. cbn [fst snd] in Bg. unfold tet_of in Bg; cbn [fst snd] in Bg.
    pose proof (box_proper A amul aofZ alt ale u _ _ Bg) as Pg.
    destruct (meet (u_rank u) (u_cells u) n bf bg) eqn:M.
    + left. rewrite <- UR in L. pose proof (candidates_all (u_rank u) (u_cells u) CP tets bf bg (k', t') n Ig Pf Pg L M) as IC.
      specialize (H2 _ IC). cbv beta iota in H2. destruct (N.eqb k k' && z3eqb n z30) eqn:E; auto. exfalso. apply Ne.
      rewrite !andb_true_iff, N.eqb_eq, z3eqb_t in E. tauto.
    + right. apply (far_apart A c u (conj UR UD) WP hpos n bf bg); auto.
      * discriminate.
      * intros x Hx. apply in_map_iff in Hx as [q' [<- Hq]]. apply in_map_iff in Hq as [q [<- Hq]]. apply corner_box with (l := tet_corners t'); auto.
Qed.
Lemma rapart f g : boundary f -> boundary g -> f <> g -> exists w, separates w (face f) (face g).
Proof.
  destruct f as [[k n] i], g as [[k' n'] i']. intros Hf Hg Ne.
  destruct (boundary_facet k n i Hf) as [t [E [It [Ft Ln]]]]. destruct (boundary_facet k' n' i' Hg) as [t' [E' [It' [Ft' Ln']]]].
  set (m := zadd3 n' (zopp3 n)). assert (EM : n' = zadd3 n m) by (symmetry; apply zadd3_sub).
  assert (Lm : latb r m = true) by (apply latb_add; auto; apply latb_opp; auto).
  pose proof (face_eq k n i t E) as Q1. 
  assert (Q2 : face ((k', n'), i') = translate_triangle (vec h n) (translate_triangle (vec h m) (rtri (cfc t' i')))).
  { rewrite translate_twice, <- EM. apply face_eq, E'. }
  cut (exists w, separates w (translate_triangle (vec h n) (rtri (cfc t i))) (translate_triangle (vec h n) (translate_triangle (vec h m) (rtri (cfc t' i'))))).
  { intros [w S]. exists w. exact (eq_ind_r (fun F => separates w F _) (eq_ind_r (fun G => separates w _ G) S Q2) Q1). }
  cut (exists w, separates w (rtri (cfc t i)) (translate_triangle (vec h m) (rtri (cfc t' i')))).
  { intros [w S]. exists (fun x => w (sub x (vec h n))). apply separates_translate, S. }
  destruct (checked_pairs (N.of_nat k) t i Ft) as [P _]. destruct (P (N.of_nat k') t' i' m Ft' Lm) as [S|[w [Aw [X Y]]]].
  { intros [Ek [<- Z]]. apply Nnat.Nat2N.inj in Ek. subst k'. apply Ne. rewrite EM, Z, zadd3_30. reflexivity. }
  - apply (separated_sound A aadd asub amul aofZ alt ale phi phi_add phi_mul alt_ok ale_ok c (facet_corners t i) (map (cshift m) (facet_corners t' i'))); auto.
    + apply corners_facet.
    + apply corners_moved.
  - exists w. rewrite <- corners_facet in X. rewrite <- corners_moved in Y. split; auto. split; [|split; [|split]].
    + intros v Hv. specialize (X v Hv). split; [lra|]. intros; lra.
    + eexists. split; [left; reflexivity|]. apply X. left; reflexivity.
    + intros v Hv. specialize (Y v Hv). split; [lra|]. intros; lra.
    + eexists. split; [left; reflexivity|]. apply Y. left; reflexivity.
Qed.
Lemma moved_phiT m t : phiT (kpos den vs (moved_tet m t)) = translate (vec h m) (phiT (kpos den vs t)).
Proof.
  unfold Soundness.phiT, Checker.kpos, translate; cbn [Checker.ka Checker.kb Checker.kc Checker.kd va vb vc vd moved_tet q0 q1 q2 q3].
  f_equal; apply (rp_move m).
Qed.
Lemma runcovered f cc : boundary f -> valid cc -> cc <> fst f -> ~ closed (piece cc) (middle (face f)).
Proof.
  destruct f as [[k n] i], cc as [k' n']. intros Hf [Hk' Ln'] Ne C. cbn [fst snd] in *.
  destruct (boundary_facet k n i Hf) as [t [E [It [Ft Ln]]]]. destruct (tet k' Hk') as [t' [E' [It' ET']]].
  set (m := zadd3 n' (zopp3 n)). assert (EM : n' = zadd3 n m) by (symmetry; apply zadd3_sub).
  assert (Lm : latb r m = true) by (apply latb_add; auto; apply latb_opp; auto).
  pose proof (eq_ind _ (fun F => closed (piece (k', n')) (middle F)) C _ (face_eq k n i t E)) as C0. clear C. rename C0 into C.
  cbv beta in C. rewrite middle_translate in C.
  assert (PE : piece (k', n') = translate (vec h n) (translate (vec h m) (phiT (kpos den vs t')))).
  { unfold Degree.piece; cbn [fst snd]. rewrite ET', EM, ttr_ttr, vec_add, padd_comm. reflexivity. }
  rewrite PE in C. apply closed_translate in C. set (F := rtri (cfc t i)) in *. set (T := translate (vec h m) (phiT (kpos den vs t'))) in *.
  assert (MID : forall w, affine w -> w (middle F) = / 3 * (w (t1 F) + w (t2 F) + w (t3 F))).
  { intros w Aw. unfold middle. rewrite affine_combination3 by (auto; lra). ring. }
  assert (VT : 0 < vol T) by (unfold T; rewrite vol_ttr, <- ET'; apply rvol; auto).
  destruct (checked_pairs (N.of_nat k) t i Ft) as [_ P]. destruct (P (N.of_nat k') t' m) as [U|[w [Aw [W1 W2]]]].
  { rewrite Nnat.Nat2N.id. exact E'. }
  { exact Lm. }
  { intros [Ek Z]. apply Nnat.Nat2N.inj in Ek. subst k'. apply Ne. rewrite EM, Z, zadd3_30. reflexivity. }
  - unfold chk_uncovered in U. cbv zeta in U. rewrite existsl_eq in U. apply existsb_exists in U as [j [Hj U]].
    change (kat A at_ (moved_tet m t')) with (kpos den vs (moved_tet m t')) in U. apply alt_ok in U. rewrite (phi_zero A aofZ phi phi_Z) in U.
    specialize (C j Hj). rewrite (MID (coord T j)) in C by apply aff_o.
    assert (S : forall l, phi (fold_right (fun q s => aadd (kL A aadd asub amul (kpos den vs (moved_tet m t')) j (pos A aadd aofZ den vs q)) s) (zero A aofZ) l) =
      fold_right (fun q s => coord T j (rp q) + s) 0 l).
    { induction l as [|q l IH]; cbn [fold_right]; [apply (phi_zero A aofZ phi phi_Z)|].
      rewrite phi_add, IH. f_equal. rewrite (phi_L A aadd asub amul phi phi_add phi_sub phi_mul), moved_phiT. reflexivity. }
    rewrite S in U. assert (EQ : fold_right (fun q s => coord T j (rp q) + s) 0 (facet_corners t i) = coord T j (t1 F) + coord T j (t2 F) + coord T j (t3 F)).
    { unfold F. destruct i as [|[|[|i]]]; cbn [facet_corners cfc fold_right rtri Soundness.rtri t1 t2 t3]; ring. }
    rewrite EQ in U. lra.
  - assert (X : forall v, In v (corners F) -> w v < 0) by (intros v Hv; apply W1; unfold F in Hv; rewrite corners_facet in Hv; exact Hv).
    assert (Y : forall q, In q (tet_corners t') -> 0 < w (add (rp q) (vec h m))).
    { intros q Hq. rewrite <- rp_move. apply W2, in_map, in_map, Hq. }
    pose proof (X (t1 F)) as X1. pose proof (X (t2 F)) as X2. pose proof (X (t3 F)) as X3. unfold corners in X1, X2, X3. simpl in X1, X2, X3.
    pose proof (MID w Aw) as ME. pose proof (interpolate T w (middle F) Aw) as IE.
    assert (Z : forall j a, In j I4 -> 0 < a -> 0 <= coord T j (middle F) * a) by (intros j a Hj Ha; apply Rmult_le_pos; [apply C; auto|lra]).
    pose proof (Z 0%nat (w (va T)) ltac:(simpl; auto) (Y (q0 t') ltac:(simpl; auto))).
    pose proof (Z 1%nat (w (vb T)) ltac:(simpl; auto) (Y (q1 t') ltac:(simpl; auto))).
    pose proof (Z 2%nat (w (vc T)) ltac:(simpl; auto) (Y (q2 t') ltac:(simpl; auto))).
    pose proof (Z 3%nat (w (vd T)) ltac:(simpl; auto) (Y (q3 t') ltac:(simpl; auto))).
    assert (w (middle F) < 0) by (rewrite ME; specialize (X1 ltac:(auto)); specialize (X2 ltac:(auto)); specialize (X3 ltac:(auto)); lra). nra.
Qed.
Lemma rbounded : exists f, boundary f.
Proof.
  destruct chk_parts as [_ [_ [NE _]]]. destruct facets as [|[[k t] i] l] eqn:E; [congruence|].
  assert (H : In (k, t, i) facets) by (rewrite E; left; auto). apply open_facets_In in H as [H1 [H2 H3]].
  exists ((N.to_nat k, z30), i). repeat split; auto; cbn [fst snd].
  - apply nth_error_Some. congruence.
  - apply latb_zero.
  - unfold Degree.paired; cbn [fst snd]. unfold Soundness.cM. rewrite H1, H3. congruence.
Qed.

(** ** 3. In Euclidean space *)
Section Basis.
Variables l1 l2 l3 : point.
Hypothesis HG : has_gram (dgram A phi c) l1 l2 l3.
Let b1 := scale (/ h) l1.
Let b2 := scale (/ h) l2.
Let b3 := scale (/ h) l3.
Notation e := (E b1 b2 b3).
Notation back := (Einv b1 b2 b3).
Let P := Pk cT h l1 l2 l3.
Lemma rdet : det l1 l2 l3 <> 0.
Proof. apply (cdet A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c base l1 l2 l3 HG). Qed.
Lemma D0 : det b1 b2 b3 <> 0.
Proof. apply det_scl0; [apply hpos|apply rdet]. Qed.
Lemma e_back X : e (back X) = X.
Proof. apply E_Einv, D0. Qed.
Lemma back_e x : back (e x) = x.
Proof. apply Einv_E, D0. Qed.
Lemma rtile cc : tile l1 l2 l3 P cc = Et b1 b2 b3 (piece cc).
Proof. apply tile_piece, hpos. Qed.
Lemma pvol cc : valid cc -> 0 < vol (piece cc).
Proof. intros [H _]. unfold Degree.piece. rewrite vol_ttr. apply rvol; auto. Qed.
Lemma rhull cc x : valid cc -> (hull (tile l1 l2 l3 P cc) (e x) <-> closed (piece cc) x).
Proof. intros V. rewrite rtile, hull_Et by apply D0. apply hull_closed, pvol, V. Qed.

(** Closeness, in both coordinates. *)
Lemma near_affine_open d X (F : point -> point) : affine (fun y => px (F y)) -> affine (fun y => py (F y)) -> affine (fun y => pz (F y)) ->
  open (fun y => near d X (F y)).
Proof.
  intros A1 A2 A3.
  assert (K : forall g k, affine g -> open (fun y => Rabs (g y - k) < d)).
  { intros g k [a [b [c' [d' H]]]]. apply opn_ext with (U := fun y => 0 < d - (g y - k) /\ 0 < d + (g y - k)).
    - intros y. split; [intros [U V]; apply Rabs_def1; lra|]. intros U. apply Rabs_def2 in U. lra.
    - apply opn_and; apply aff_pos_opn; [exists (-a), (-b), (-c'), (d - d' + k) | exists a, b, c', (d + d' - k)]; intros y; rewrite H; ring. }
  unfold near. apply opn_and; [apply (K (fun y => px (F y))); auto|]. apply opn_and; [apply (K (fun y => py (F y))); auto|apply (K (fun y => pz (F y))); auto].
Qed.
Lemma close_transfer (S S0 : point -> Prop) x : (forall y, S (e y) <-> S0 y) ->
  ((forall d, 0 < d -> exists Y, near d (e x) Y /\ S Y) <-> (forall d, 0 < d -> exists y, near d x y /\ S0 y)).
Proof.
  intros H. split; intros CL d Hd.
  - assert (O : open (fun Y => near d x (back Y))).
    { pose proof D0 as DD. set (dl := det b1 b2 b3) in *. apply near_affine_open.
      - exists ((py b2 * pz b3 - pz b2 * py b3) / dl), ((pz b2 * px b3 - px b2 * pz b3) / dl), ((px b2 * py b3 - py b2 * px b3) / dl), 0.
        intros X. unfold Einv; cbn [px]. fold dl. unfold det. field. auto.
      - exists ((py b3 * pz b1 - pz b3 * py b1) / dl), ((pz b3 * px b1 - px b3 * pz b1) / dl), ((px b3 * py b1 - py b3 * px b1) / dl), 0.
        intros X. unfold Einv; cbn [py]. fold dl. unfold det. field. auto.
      - exists ((py b1 * pz b2 - pz b1 * py b2) / dl), ((pz b1 * px b2 - px b1 * pz b2) / dl), ((px b1 * py b2 - py b1 * px b2) / dl), 0.
        intros X. unfold Einv; cbn [pz]. fold dl. unfold det. field. auto. }
    destruct (O (e x)) as [d' [Hd' K]]; [rewrite back_e; apply near_refl; auto|]. destruct (CL d' Hd') as [Y [N1 SY]].
    exists (back Y). split; [apply K; auto|]. apply H. rewrite e_back. exact SY.
  - assert (O : open (fun y => near d (e x) (e y))).
    { apply near_affine_open; unfold E, at_coordinates, add, scale; cbn [px py pz].
      - exists (px b1), (px b2), (px b3), 0. intros y. ring.
      - exists (py b1), (py b2), (py b3), 0. intros y. ring.
      - exists (pz b1), (pz b2), (pz b3), 0. intros y. ring. }
    destruct (O x) as [d' [Hd' K]]; [apply near_refl; auto|]. destruct (CL d' Hd') as [y [N1 Sy]].
    exists (e y). split; [apply K; auto|]. apply H, Sy.
Qed.

(** Facets. *)
Lemma in_facet_Et t i x : In i I4 -> (in_facet (Et b1 b2 b3 t) i (e x) <-> on (facet t i) x).
Proof.
  intros Hi. split.
  - intros [a [b [c' [d [X1 [X2 [X3 [X4 [S [Q Z]]]]]]]]]]. rewrite E_comb4 in Q. apply E_inj in Q; [|apply D0]. rewrite Q. simpl in Hi.
    destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; cbv beta iota in Z; rewrite Z in *;
    [exists b, d, c' | exists a, c', d | exists a, d, b | exists a, b, c']; repeat split; auto; try lra;
    unfold combination3, combination; cbn [facet t1 t2 t3]; apply point_eq; unf; ring.
  - intros [a [b [c' [X1 [X2 [X3 [S ->]]]]]]]. simpl in Hi.
    destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; cbn [facet];
    [ exists 0, a, c', b | exists a, 0, b, c' | exists a, c', 0, b | exists a, b, c', 0 ]; repeat split; auto; try lra;
    rewrite E_comb4; f_equal; unfold combination3, combination; cbn [t1 t2 t3]; apply point_eq; unf; ring.
Qed.
Lemma facet_corner_vertices t i v : In i I4 -> (In (e v) (facet_vertices (Et b1 b2 b3 t) i) <-> In v (corners (facet t i))).
Proof.
  intros Hi. assert (K : forall u, e u = e v <-> u = v) by (intros u; split; [apply E_inj, D0|congruence]).
  simpl in Hi. destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; cbn [facet_vertices Et va vb vc vd facet corners t1 t2 t3 In]; unfold corners; cbn [facet t1 t2 t3 In]; rewrite !K; tauto.
Qed.
Lemma common_facet_Et t i t' i' x : In i I4 -> In i' I4 -> on (facet t i) x ->
  (forall v, carF (facet t i) x v -> carF (facet t' i') x v) -> common_facet_hull (Et b1 b2 b3 t) i (Et b1 b2 b3 t') i' (e x).
Proof.
  intros Hi Hi' [a [b [c' [X1 [X2 [X3 [S E0]]]]]]] H.
  assert (K : forall v, carF (facet t i) x v -> In (e v) (facet_vertices (Et b1 b2 b3 t') i')).
  { intros v Hv. apply facet_corner_vertices; auto. apply H in Hv as [? [? [? [_ [_ [_ [_ [_ V]]]]]]]]. unfold corners. simpl. intuition. }
  assert (K1 : 0 < a -> In (e (t1 (facet t i))) (facet_vertices (Et b1 b2 b3 t') i')) by (intros Q; apply K; exists a, b, c'; repeat split; auto).
  assert (K2 : 0 < b -> In (e (t2 (facet t i))) (facet_vertices (Et b1 b2 b3 t') i')) by (intros Q; apply K; exists a, b, c'; repeat split; auto).
  assert (K3 : 0 < c' -> In (e (t3 (facet t i))) (facet_vertices (Et b1 b2 b3 t') i')) by (intros Q; apply K; exists a, b, c'; repeat split; auto).
  rewrite E0. simpl in Hi. destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; cbn [facet t1 t2 t3] in *;
  [ exists 0, a, c', b | exists a, 0, b, c' | exists a, c', 0, b | exists a, b, c', 0 ];
  (split; [lra|]; split; [lra|]; split; [lra|]; split; [lra|]; split; [lra|]; split;
   [rewrite E_comb4; f_equal; unfold combination3, combination; cbn [t1 t2 t3]; apply point_eq; unf; ring|];
   split; [reflexivity|]; cbn [Et va vb vc vd]; repeat split; auto; intros Q; exfalso; lra).
Qed.
Lemma listed_boundary f : is_boundary_facet r N (listed_facets A c) f <-> boundary f.
Proof.
  destruct f as [[k n] i]. unfold is_boundary_facet; cbn [fst snd]. unfold is_tile; cbn [fst snd]. unfold listed_facets. split.
  - intros [[Hk Hn] H]. apply in_map_iff in H as [[[k' t] i'] [E H]]. injection E as <- <-. apply open_facets_In in H as [H1 [H2 H3]].
    split; [split; auto; apply latb_iff; auto|]. split; auto. unfold Degree.paired; cbn [fst snd]. unfold Soundness.cM. rewrite H1, H3. congruence.
  - intros B. destruct (boundary_facet k n i B) as [t [E [It [F Ln]]]]. split; [split; [apply B|apply latb_iff; auto]|].
    apply in_map_iff. exists (N.of_nat k, t, i). rewrite Nnat.Nat2N.id. auto.
Qed.

Theorem region_sound : face_to_face_region l1 l2 l3 r N (dtet A aofZ phi c l1 l2 l3) (listed_facets A c).
Proof.
  rewrite (dtet_cP A aadd asub amul aofZ alt phi phi_add phi_Z c base).
  change (face_to_face_region l1 l2 l3 r N P (listed_facets A c)).
  assert (VT : forall cc, is_tile r N cc <-> valid cc) by (intros; apply valid_is_tile).
  assert (RB : forall f X, in_boundary_facet l1 l2 l3 P f (e X) <-> (In (snd f) I4 -> on (face f) X) /\ (~ In (snd f) I4 -> in_boundary_facet l1 l2 l3 P f (e X))).
  { intros f X. destruct (in_dec Nat.eq_dec (snd f) I4) as [I|I]; [|tauto]. unfold in_boundary_facet. rewrite rtile, in_facet_Et by auto. unfold Region.face. tauto. }
  constructor.
  - apply rdet.
  - intros cc Hc. apply VT in Hc. rewrite rtile, vol_Et. pose proof (pvol cc Hc). pose proof D0. apply Rmult_integral_contrapositive_currified; lra.
  - intros M. destruct (Einv_bound h l1 l2 l3 hpos rdet M) as [M' HM]. destruct (range N cT h (latb r) hpos rvol M') as [K HK].
    exists (Degree.cells N (latb r) K). intros cc X Hc HX H. apply VT in Hc. rewrite <- (e_back X), rhull in H by auto. apply HK with (y := back X); auto.
  - intros X cc cc' Hc Hc' H H'. apply VT in Hc, Hc'. rewrite <- (e_back X) in H, H'. rewrite rhull in H' by auto. rewrite rtile, open_hull_Et in H by apply D0.
    apply open_hull_inter in H; [|apply pvol; auto].
    apply (region_disjoint N cT h (latb r) cM hpos (latb_add r) rvol rmate rapart runcovered rbounded (back X)); auto.
  - intros X cc cc' Hc Hc' H H'. apply VT in Hc, Hc'. rewrite <- (e_back X) in *. pose proof H as H0. rewrite rhull in H, H' by auto.
    rewrite !rtile in *. apply common_Et. rewrite hull_Et in H0 by apply D0.
    destruct H0 as [a [b [c0 [d [X1 [X2 [X3 [X4 [S Hx]]]]]]]]].
    exists a, b, c0, d. repeat split; auto; intros Q;
    apply carT_vert with (x := back X);
    (apply (region_face_to_face N cT h (latb r) cM hpos (latb_add r) rvol rmate rapart runcovered rbounded (back X) _ cc cc'); auto; exists a, b, c0, d; repeat split; auto).
  - destruct rbounded as [f Hf]. exists f. apply listed_boundary, Hf.
  - intros k i H. assert (B : exists t, In (N.of_nat k, t, i) facets).
    { unfold listed_facets in H. apply in_map_iff in H as [[[k' t] i'] [E H]]. injection E as <- ->. rewrite N2Nat.id. eauto. }
    destruct B as [t B]. apply open_facets_In in B as [B1 [B2 _]]. rewrite Nnat.Nat2N.id in B1. split; [apply nth_error_Some; congruence|]. apply I4_lt, B2.
  - intros X. rewrite <- (e_back X). set (x := back X).
    assert (RG : forall y, in_region l1 l2 l3 r N P (e y) <-> Region.region N cT h (latb r) y).
    { intros y. split; intros [cc [Hc H]]; exists cc; split; try (apply VT; auto); [apply rhull; auto; apply VT; auto|]. apply rhull; auto. }
    unfold topological_boundary. rewrite (close_transfer _ _ x RG).
    assert (NRG : forall y, ~ in_region l1 l2 l3 r N P (e y) <-> ~ Region.region N cT h (latb r) y) by (intros y; rewrite RG; tauto).
    rewrite (close_transfer (fun Y => ~ in_region l1 l2 l3 r N P Y) _ x NRG).
    rewrite <- (region_boundary N cT h (latb r) cM hpos (latb_add r) rvol rmate rapart runcovered rbounded x).
    split; intros [f [Bf Of]]; exists f.
    + split; [apply listed_boundary; auto|]. apply RB. split; auto. destruct Bf as [_ [I _]]. tauto.
    + apply listed_boundary in Bf. split; auto. apply RB in Of as [Of _]. apply Of, Bf.
  - intros X f g Bf Bg Of Og. apply listed_boundary in Bf, Bg. rewrite <- (e_back X) in *. set (x := back X) in *.
    apply RB in Of as [Of _]. apply RB in Og as [Og _]. specialize (Of (proj1 (proj2 Bf))). specialize (Og (proj1 (proj2 Bg))).
    rewrite !rtile. apply common_facet_Et; [apply Bf|apply Bg|exact Of|]. intros v Hv.
    apply (boundary_carrier N cT h (latb r) cM rapart f g x v); auto.
Qed.

(** Statements about single tetrahedra. *)
Lemma each_sound st : fast_statement A aadd asub amul aofZ alt ale c (positions A aadd aofZ c) (tabulate (positions A aadd aofZ c)) st = true ->
  match st with CDelaunay _ | CWeaklyDelaunay _ | CTCP _ => True | _ => holds l1 l2 l3 r N P (dstatement A phi st) end.
Proof.
  intros H. apply fast_statement_ok in H.
  destruct st as [| |rel sg p q|rel sg p q|rel p q|n p q hint| | | |]; auto; cbn [Checker.check_statement dstatement holds] in *; cbv zeta in H.
  - exact (each_angle A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c base l1 l2 l3 HG _ (fun x => x < PI / 2)
      (acute_sound A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c base l1 l2 l3 HG) H).
  - exact (each_angle A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c base l1 l2 l3 HG _ (fun x => x <= PI / 2)
      (nonobtuse_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z ale_ok c base l1 l2 l3 HG) H).
  - apply andb_true_iff in H as [B H]. apply (largest_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok c base l1 l2 l3 HG); auto.
  - apply andb_true_iff in H as [B H]. apply (smallest_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok c base l1 l2 l3 HG); auto.
  - apply andb_true_iff in H as [B H]. apply andb_true_iff in B as [B _]. apply Z.ltb_lt, IZR_lt in B.
    apply (radius_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok c base l1 l2 l3 HG); auto.
  - apply andb_true_iff in H as [B H]. apply Z.ltb_lt, IZR_lt in B.
    apply (uncrossed_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok c base l1 l2 l3 HG hint n p q B H).
  - apply (not_delaunay_sound A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c base l1 l2 l3 HG H).
Qed.

(** *** Tiles with a common facet *)
Let G := phiG A phi (c_gram A c).
(** Three different common vertices are those of a facet of each. *)
Lemma three_are_a_facet t u v w : 0 < vol t -> u <> v -> u <> w -> v <> w -> In u (verts t) -> In v (verts t) -> In w (verts t) ->
  exists i, In i I4 /\ forall x, In x (corners (facet t i)) <-> x = u \/ x = v \/ x = w.
Proof.
  intros V Nuv Nuw Nvw U W X. destruct t as [a b d f]. cbn [verts va vb vc vd In] in U, W, X.
  destruct U as [U|[U|[U|[U|[]]]]], W as [W|[W|[W|[W|[]]]]], X as [X|[X|[X|[X|[]]]]]; try congruence;
  first [ exists 0%nat; split; [simpl; auto|]; subst; intros; unfold corners; cbn [facet t1 t2 t3 va vb vc vd In]; solve [intuition congruence]
        | exists 1%nat; split; [simpl; auto|]; subst; intros; unfold corners; cbn [facet t1 t2 t3 va vb vc vd In]; solve [intuition congruence]
        | exists 2%nat; split; [simpl; auto|]; subst; intros; unfold corners; cbn [facet t1 t2 t3 va vb vc vd In]; solve [intuition congruence]
        | exists 3%nat; split; [simpl; auto|]; subst; intros; unfold corners; cbn [facet t1 t2 t3 va vb vc vd In]; solve [intuition congruence] ].
Qed.
Lemma tile_vertex cc v : valid cc -> In v (verts (tile l1 l2 l3 P cc)) -> exists x, In x (verts (piece cc)) /\ v = e x.
Proof.
  intros V H. rewrite rtile in H. cbn [Et verts va vb vc vd In] in H.
  destruct H as [<-|[<-|[<-|[<-|[]]]]]; eexists; (split; [|reflexivity]); simpl; auto.
Qed.
Lemma vertex_tile cc x : valid cc -> In x (verts (piece cc)) -> In (e x) (verts (tile l1 l2 l3 P cc)).
Proof. intros V H. rewrite rtile. cbn [verts va vb vc vd In] in H. simpl. intuition (subst; auto). Qed.
Lemma facet_mate cc cc' i : valid cc -> valid cc' -> In i I4 -> cc <> cc' ->
  (forall x, In x (corners (facet (piece cc) i)) -> In x (verts (piece cc'))) -> Degree.paired cM (cc, i) /\ fst (Degree.across cM (cc, i)) = cc'.
Proof.
  intros V V' Hi Ne H. destruct (facet_distinct (piece cc) i (pvol cc V) Hi) as [N12 [N13 N23]].
  destruct (three_are_a_facet (piece cc') (t1 (facet (piece cc) i)) (t2 (facet (piece cc) i)) (t3 (facet (piece cc) i))) as [i' [Hi' F']]; auto;
    try (apply H; simpl; auto); [apply pvol; auto|].
  apply (neighbours N cT h (latb r) cM hpos (latb_add r) rvol rmate rapart runcovered rbounded cc cc' i i'); auto.
  intros x Hx. apply F'. unfold corners in Hx. cbn [In] in Hx. unfold Region.face in Hx; cbn [fst snd] in Hx. intuition.
Qed.
Lemma common_valid cc cc' : have_a_common_facet l1 l2 l3 r N P cc cc' -> valid cc /\ valid cc'.
Proof. intros [u [v [w [_ [_ [_ [[V _] [V' _]]]]]]]]. split; apply valid_is_tile; auto. Qed.
Lemma common_facet_index cc cc' : have_a_common_facet l1 l2 l3 r N P cc cc' ->
  exists i, In i I4 /\ forall x, In x (corners (facet (piece cc) i)) -> In x (verts (piece cc')).
Proof.
  intros CF. destruct (common_valid cc cc' CF) as [V V']. destruct CF as [u [v [w [Nuv [Nuw [Nvw [[_ H] [_ H']]]]]]]].
  assert (K : forall y, In y [u; v; w] -> exists x, y = e x /\ In x (verts (piece cc)) /\ In x (verts (piece cc'))).
  { intros y Hy. destruct (tile_vertex cc y V (H y Hy)) as [x [Hx E1]]. destruct (tile_vertex cc' y V' (H' y Hy)) as [x' [Hx' E2]].
    rewrite E1 in E2. apply E_inj in E2; [|apply D0]. subst x'. eauto. }
  destruct (K u) as [u' [-> [Hu Hu']]]; [simpl; auto|]. destruct (K v) as [v' [-> [Hv Hv']]]; [simpl; auto|]. destruct (K w) as [w' [-> [Hw Hw']]]; [simpl; auto|].
  assert (Nuv' : u' <> v') by congruence. assert (Nuw' : u' <> w') by congruence. assert (Nvw' : v' <> w') by congruence.
  destruct (three_are_a_facet (piece cc) u' v' w') as [i [Hi F]]; auto; [apply pvol; auto|].
  exists i. split; auto. intros x Hx. apply F in Hx as [ -> | [ -> | -> ] ]; auto.
Qed.
(** The powers of the vertices of the neighbour. *)
Notation chk_power := (chk_power A aadd asub amul aofZ).
Lemma power_behind (less : A -> A -> bool) k t i : nth_error (c_tets A c) k = Some t ->
  chk_power less (c_gram A c) den (positions A aadd aofZ c) t (kpos den vs t) i = true ->
  match cM k i with
  | Some (k', i', d) => exists x, less x (zero A aofZ) = true /\ phi x = - (vol (cT k) * power G (cT k) (vx (translate (vec h d) (cT k')) i'))
  | None => True
  end.
Proof.
  intros E H. unfold Checker.chk_power in H. unfold Soundness.cM. rewrite E. destruct (mt t i) as [[[k' i'] d]|]; auto.
  unfold positions in H. fold den vs in H. rewrite nth_error_map in H.
  destruct (nth_error (c_tets A c) (N.to_nat k')) as [t'|] eqn:E'; [|discriminate]. cbn [option_map] in H.
  eexists. split; [exact H|]. rewrite (phi_power A aadd asub amul phi phi_add phi_sub phi_mul), (phi3_add A aadd phi phi_add), (phi3_ofZ A aofZ phi phi_Z), phi_vx, vx_translate'.
  fold h G. assert (Hk : (k < N)%nat) by (apply nth_error_Some; congruence).
  rewrite power_power_sum by (pose proof (rvol k Hk); lra).
  rewrite (cT_eq A aadd aofZ phi c k t E), (cT_eq A aadd aofZ phi c _ t' E'). fold den vs. ring.
Qed.
Lemma neighbour_power (less : A -> A -> bool) (Q : R -> Prop) k n t i cc' x :
  (forall a, less a (zero A aofZ) = true -> forall b d, 0 < b -> phi a = - (b * d) -> Q d) ->
  valid (k, n) -> valid cc' -> (k, n) <> cc' -> nth_error (c_tets A c) k = Some t -> In i I4 ->
  chk_power less (c_gram A c) den (positions A aadd aofZ c) t (kpos den vs t) i = true ->
  (forall x, In x (corners (facet (piece (k, n)) i)) -> In x (verts (piece cc'))) -> In x (verts (piece cc')) ->
  In x (verts (piece (k, n))) \/ Q (power G (piece (k, n)) x).
Proof.
  intros LQ V V' Ne Et Hi CK F Hx. destruct (facet_mate (k, n) cc' i V V' Hi Ne F) as [PA AC].
  destruct (Region.across_spec N cT h (latb r) cM (latb_add r) rmate (k, n) i V Hi PA) as [S1 [S2 [_ [S4 _]]]].
  pose proof PA as PA'. unfold Degree.paired in PA'; cbn [fst snd] in PA'.
  pose proof (power_behind less k t i Et CK) as CP.
  unfold Degree.across in AC, S1, S2, S4. destruct (cM k i) as [[[k' i'] d]|]; [|congruence]. cbn [fst snd] in *. subst cc'.
  assert (VX : exists j, In j I4 /\ x = vx (piece (k', zadd3 n d)) j).
  { cbn [verts va vb vc vd In] in Hx. destruct Hx as [<-|[<-|[<-|[<-|[]]]]]; [exists 0%nat|exists 1%nat|exists 2%nat|exists 3%nat]; (split; [simpl; auto|reflexivity]). }
  destruct VX as [j [Hj ->]]. destruct (Nat.eq_dec j i') as [->|Nj].
  - right. destruct CP as [a [C1 C2]]. apply (LQ a C1 (vol (cT k))); [apply rvol, V|]. rewrite C2. f_equal. f_equal.
    assert (E : vx (piece (k', zadd3 n d)) i' = add (vx (translate (vec h d) (cT k')) i') (vec h n)).
    { unfold Degree.piece; cbn [fst snd]. rewrite !vx_translate', vec_add, (padd_comm (vec h n)), padd_assoc. reflexivity. }
    rewrite E. symmetry. apply power_translate. pose proof (rvol k (proj1 V)). lra.
  - left. set (t' := piece (k', zadd3 n d)) in *. set (u := piece (k, n)) in *. clearbody u t'. clear - S2 S4 Hi Hj Nj.
    unfold opposite in S4. simpl in Hi, Hj, S2.
    destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; destruct S2 as [<-|[<-|[<-|[<-|[]]]]]; destruct Hj as [<-|[<-|[<-|[<-|[]]]]]; try congruence;
    cbn [facet t1 t2 t3 vx verts In] in *; intuition congruence.
Qed.
(** Squared distances to the centre of the circumscribed ball, by powers. *)
Lemma ball cc x : valid cc -> let C := circumcentre (tile l1 l2 l3 P cc) in let q := distance_squared (va (tile l1 l2 l3 P cc)) C in
  circumscribed (tile l1 l2 l3 P cc) C q /\ exists s, 0 < s /\ distance_squared (e x) C - q = s * power G (piece cc) x.
Proof.
  intros V. cbv zeta. split.
  - apply circumscribed_centre. rewrite rtile, vol_Et. pose proof (pvol cc V). pose proof D0. apply Rmult_integral_contrapositive_currified; lra.
  - exists (/ h * / h). split.
    + pose proof (Rinv_0_lt_compat h hpos). apply Rmult_lt_0_compat; auto.
    + rewrite rtile. apply (power_distance A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c base l1 l2 l3 HG (piece cc) x (pvol cc V)).
Qed.
Lemma all_checked (less : A -> A -> bool) (Q : R -> Prop) cc cc' x : (forall a, less a (zero A aofZ) = true -> forall b d, 0 < b -> phi a = - (b * d) -> Q d) ->
  chk_delaunay A aadd asub amul aofZ less c = true -> have_a_common_facet l1 l2 l3 r N P cc cc' -> In x (verts (piece cc')) ->
  In x (verts (piece cc)) \/ Q (power G (piece cc) x).
Proof.
  intros LQ H CF Hx. destruct (cell_eq_dec cc cc') as [->|Ne]; [auto|]. destruct (common_valid cc cc' CF) as [V V'].
  destruct (common_facet_index cc cc' CF) as [i [Hi F]]. destruct cc as [k n]. destruct (tet k (proj1 V)) as [t [E [It _]]].
  apply (neighbour_power less Q k n t i cc' x); auto.
  unfold Checker.chk_delaunay in H. rewrite forallb_forall in H. specialize (H t It). rewrite forallb_forall in H. apply (H i Hi).
Qed.
Lemma below_zero a b d : 0 < b -> phi a = - (b * d) -> (phi a <= 0 -> 0 <= d) /\ (phi a < 0 -> 0 < d).
Proof.
  intros Hb ->. split; intros H; [apply Rmult_le_reg_l with b|apply Rmult_lt_reg_l with b]; auto; lra.
Qed.
Theorem locally_weakly_sound : chk_delaunay A aadd asub amul aofZ ale c = true -> locally_weakly_delaunay l1 l2 l3 r N P.
Proof.
  intros H cc cc' CF. destruct (common_valid cc cc' CF) as [V V']. eexists. eexists. split; [apply (ball cc origin V)|].
  intros y Hy. apply tile_vertex in Hy as [x [Hx ->]]; auto. destruct (ball cc x V) as [CI [s [Hs B]]].
  destruct (all_checked ale (fun d => 0 <= d) cc cc' x) as [I|Q]; auto.
  - intros a L b d Hb E. apply ale_ok in L. rewrite (phi_zero A aofZ phi phi_Z) in L. apply (below_zero a b d Hb E), L.
  - right. rewrite (CI (e x)); [reflexivity|]. apply vertex_tile; auto.
  - assert (0 <= s * power G (piece cc) x) by (apply Rmult_le_pos; lra). lra.
Qed.
Theorem locally_sound : chk_delaunay A aadd asub amul aofZ alt c = true -> locally_delaunay l1 l2 l3 r N P.
Proof.
  intros H cc cc' CF. destruct (common_valid cc cc' CF) as [V V']. eexists. eexists. split; [apply (ball cc origin V)|].
  intros y Hy. apply tile_vertex in Hy as [x [Hx ->]]; auto. destruct (ball cc x V) as [CI [s [Hs B]]].
  destruct (all_checked alt (fun d => 0 < d) cc cc' x) as [I|Q]; auto.
  - intros a L b d Hb E. apply alt_ok in L. rewrite (phi_zero A aofZ phi phi_Z) in L. apply (below_zero a b d Hb E), L.
  - pose proof (vertex_tile cc x V I) as T. split; auto. right. rewrite (CI (e x) T). reflexivity.
  - assert (0 < s * power G (piece cc) x) by (apply Rmult_lt_0_compat; auto). split; [lra|]. intros; lra.
Qed.
(** For the plane: what the check of one facet says of the vertices behind it. *)
Theorem facet_behind (less : A -> A -> bool) (Q : R -> Prop) k n t i cc' :
  (forall a, less a (zero A aofZ) = true -> forall b d, 0 < b -> phi a = - (b * d) -> Q d) -> (forall s d, 0 < s -> Q d -> Q (s * d)) ->
  is_tile r N (k, n) -> is_tile r N cc' -> (k, n) <> cc' -> nth_error (c_tets A c) k = Some t -> In i I4 ->
  chk_power less (c_gram A c) den (positions A aadd aofZ c) t (kpos den vs t) i = true ->
  (forall v, In v (facet_vertices (tile l1 l2 l3 P (k, n)) i) -> In v (verts (tile l1 l2 l3 P cc'))) ->
  exists C s, circumscribed (tile l1 l2 l3 P (k, n)) C s /\
    forall v, In v (verts (tile l1 l2 l3 P cc')) -> In v (verts (tile l1 l2 l3 P (k, n))) \/ Q (distance_squared v C - s).
Proof.
  intros LQ QS V V' Ne Et Hi CK F. apply valid_is_tile in V, V'. eexists. eexists. split; [apply (ball (k, n) origin V)|].
  intros y Hy. apply tile_vertex in Hy as [x [Hx ->]]; auto. destruct (ball (k, n) x V) as [CI [s [Hs B]]].
  destruct (neighbour_power less Q k n t i cc' x) as [I|J]; auto.
  - intros z Hz. destruct (tile_vertex cc' (e z) V') as [z' [Hz' Ez]].
    + apply F. rewrite rtile. apply facet_corner_vertices; auto.
    + apply E_inj in Ez; [|apply D0]. subst z'. exact Hz'.
  - left. apply vertex_tile; auto.
  - right. rewrite B. apply QS; auto.
Qed.
End Basis.
End Sound.

Definition rdstatement (s : rstatement A) : region_statement :=
  match s with
  | Each _ s => Stated (dstatement A phi s)
  | CLocallyDelaunay _ => LocallyDelaunay
  | CLocallyWeaklyDelaunay _ => LocallyWeaklyDelaunay
  end.
(** A claim about a region, in the words of Statement.v and RegionStatement.v. *)
Definition region_meaning (G : gram) (r N : nat) (P : point -> point -> point -> nat -> tetrahedron) (listed : list (nat * nat)) (ss : list region_statement) : Prop :=
  (exists l1 l2 l3, has_gram G l1 l2 l3) /\
  forall l1 l2 l3, has_gram G l1 l2 l3 -> face_to_face_region l1 l2 l3 r N (P l1 l2 l3) listed /\
    forall s, In s ss -> holds_in_region l1 l2 l3 r N (P l1 l2 l3) s.
Theorem check_region_sound c ss : check_region_with A aadd asub amul aofZ alt ale part c ss = true ->
  region_meaning (dgram A phi c) (c_rank A c) (length (c_tets A c)) (dtet A aofZ phi c) (listed_facets A c) (map rdstatement ss).
Proof.
  unfold check_region_with. cbv zeta. destruct (check_region c) eqn:CHK; [|discriminate]. rewrite forallb_forall, fast_positions_eq. intros H. split.
  - apply gram_exists. apply (cgram A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c (base c CHK)).
  - intros l1 l2 l3 HG. split; [apply region_sound; auto|].
    intros s Hs. apply in_map_iff in Hs as [st [<- Hs]]. specialize (H st Hs).
    rewrite (dtet_cP A aadd asub amul aofZ alt phi phi_add phi_Z c (base c CHK)).
    destruct st as [st| |]; cbn [check_region_statement rdstatement holds_in_region] in *.
    + pose proof (each_sound c CHK l1 l2 l3 HG st) as E. destruct st; try discriminate; apply E, H.
    + rewrite fast_delaunay_eq in H. apply locally_sound; auto.
    + rewrite fast_delaunay_eq in H. apply locally_weakly_sound; auto.
Qed.
End Ring.
