(** * The theorem on regions, from the checks to Euclidean space *)
Require Import Reals Lra Psatz NArith Nnat ZArith List Lia Bool FunctionalExtensionality.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Facets Region Domain Bounds Euclid Transfer Checker Keys Soundness RegionStatement RegionChecker RegionSoundness.
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
Notation box t := (box_of A part den (kpos den vs t)).
Notation separated := (chk_separated A aadd asub amul aofZ alt ale den vs).
Notation uncovers := (chk_uncovered A aadd asub amul aofZ alt den vs).
Notation boundary := (Region.boundary N (latb r) cM).
Notation face := (Region.face cT h).
Hypothesis CHK : check_region c = true.

Lemma facets_In k t i : In (k, (t, i)) (region_facets_of A c) <-> nth_error (c_tets A c) k = Some t /\ In i I4 /\ mt t i = None.
Proof.
  unfold region_facets_of. rewrite in_flat_map. split.
  - intros [[k' t'] [H1 H2]]. apply numbered_In in H1 as [_ H1]. rewrite Nat.sub_0_r in H1. cbn [fst snd] in H2.
    apply in_map_iff in H2 as [i' [E H2]]. injection E as <- <- <-. apply filter_In in H2 as [H2 H3].
    unfold unmated in H3. destruct (mt t' i') eqn:E; [discriminate|]. auto.
  - intros [H1 [H2 H3]]. exists (k, t). split; [apply numbered_In; rewrite Nat.sub_0_r; split; [lia|auto]|].
    apply in_map_iff. exists i. split; auto. apply filter_In. split; auto. cbn [fst snd]. unfold unmated. rewrite H3. auto.
Qed.
Lemma chk_parts : based A aadd asub amul aofZ alt c /\
  chk_region_mates A aadd amul aofZ ale r (c_tets A c) (kpos den vs) 0 (c_tets A c) = true /\
  (forall t, In t (c_tets A c) -> chk_box A aofZ ale den (kpos den vs t) (box t) = true) /\
  region_facets_of A c <> [] /\
  forall k t i, In (k, (t, i)) (region_facets_of A c) ->
    (forall k' t' i' n, In (k', (t', i')) (region_facets_of A c) -> In n (shifts r (box t) (box t')) -> ~ (k = k' /\ i = i' /\ n = z30) ->
      separated (facet_corners t i) (map (cshift n) (facet_corners t' i')) = true) /\
    (forall k' t' n, nth_error (c_tets A c) k' = Some t' -> In n (shifts r (box t) (box t')) -> ~ (k = k' /\ n = z30) ->
      uncovers (facet_corners t i) (moved_tet n t') = true).
Proof.
  pose proof CHK as H. unfold RegionChecker.check_region in H. cbv zeta in H. fold den vs r in H. rewrite !andb_true_iff in H.
  destruct H as [[[[[[[H1 _] H3] H4] H5] H6] H7] H8]. split; [|split; [|split; [|split]]]; auto.
  - split; [apply Z.ltb_lt; auto|]. split; auto. intros t Ht. rewrite forallb_forall in H3. apply H3. unfold positions. apply in_map; auto.
  - intros t Ht. rewrite forallb_forall in H6. apply (H6 t Ht).
  - intros E. rewrite E in H7. discriminate.
  - intros k t i Hf. rewrite forallb_forall in H8. specialize (H8 _ Hf). cbv beta iota in H8. apply andb_true_iff in H8 as [X Y].
    rewrite forallb_forall in X, Y. split.
    + intros k' t' i' n Hg Hn Ne. specialize (X _ Hg). cbv beta iota in X. rewrite forallb_forall in X. specialize (X n Hn). cbv beta in X.
      destruct (Nat.eqb k k' && Nat.eqb i i' && z3eqb n z30) eqn:E; auto. exfalso. apply Ne.
      rewrite !andb_true_iff, !Nat.eqb_eq, z3eqb_t in E. tauto.
    + intros k' t' n Hg Hn Ne. assert (Hg' : In (k', t') (numbered 0 (c_tets A c))) by (apply numbered_In; rewrite Nat.sub_0_r; split; [lia|auto]).
      specialize (Y _ Hg'). cbv beta iota in Y. rewrite forallb_forall in Y. specialize (Y n Hn). cbv beta in Y.
      destruct (Nat.eqb k k' && z3eqb n z30) eqn:E; auto. exfalso. apply Ne.
      rewrite !andb_true_iff, !Nat.eqb_eq, z3eqb_t in E. tauto.
Qed.
Lemma base : based A aadd asub amul aofZ alt c.
Proof. apply chk_parts. Qed.
Lemma hpos : 0 < h.
Proof. apply (h_pos A aadd asub amul aofZ alt c base). Qed.
Lemma rvol k : (k < N)%nat -> 0 < vol (cT k).
Proof. apply (cvol A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c base). Qed.
Lemma tet k : (k < N)%nat -> exists t, nth_error (c_tets A c) k = Some t /\ In t (c_tets A c) /\ cT k = phiT (kpos den vs t).
Proof. intros Hk. destruct (get A c k Hk) as [t [E I]]. exists t. split; auto. split; auto. apply cT_eq, E. Qed.

Lemma region_mates_spec ps : forall ts k, chk_region_mates A aadd amul aofZ ale r (c_tets A c) ps k ts = true ->
  forall j t i, nth_error ts j = Some t -> In i I4 -> mt t i = None \/ chk_mate A aadd amul aofZ ale r [] (c_tets A c) (k + j) t (ps t) i = true.
Proof.
  induction ts as [|t0 ts IH]; intros k H j t i E Hi.
  - destruct j; discriminate.
  - cbn [chk_region_mates] in H. apply andb_true_iff in H as [H1 H2]. destruct j as [|j].
    + injection E as <-. rewrite Nat.add_0_r. rewrite forallb_forall in H1. specialize (H1 i Hi). cbv beta in H1.
      unfold unmated in H1. destruct (mt t0 i); auto.
    + replace (k + S j)%nat with (S k + j)%nat by lia. apply (IH (S k)); auto.
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
  pose proof (region_mates_spec _ _ 0 M k t i E Hi) as C. cbn [Nat.add] in C.
  destruct (cM k i) as [[[k1 i1] d1]|] eqn:EM; auto. unfold Soundness.cM in EM. rewrite E in EM.
  destruct (mt t i) as [[[k' i'] d]|] eqn:Em; [|discriminate]. injection EM as <- <- <-. destruct C as [C|C]; [congruence|].
  unfold chk_mate in C. rewrite Em, !andb_true_iff in C. destruct C as [[C1 C0] C2]. apply N.ltb_lt in C1.
  destruct (nth_error (c_tets A c) (N.to_nat k')) as [t'|] eqn:E'; [|discriminate].
  apply andb_true_iff in C2 as [C2 C3]. apply meqb_t in C2. apply (codd_oddm A aadd aofZ phi phi_add phi_Z c) in C3.
  split; [|split; [|split; [|split]]]; auto.
  - apply nth_error_Some. rewrite E'. discriminate.
  - apply I4_lt. lia.
  - unfold Soundness.cM. rewrite E', C2. rewrite !Nnat.Nat2N.id. auto.
  - rewrite ET, (cT_eq A aadd aofZ phi c _ t' E'), facet_translate. rewrite !rtri_fc in C3. exact C3.
Qed.

(** ** Corners and boxes *)
Definition tet_corners (t : ctet) := [q0 t; q1 t; q2 t; q3 t].
Lemma facet_tet t i q : In q (facet_corners t i) -> In q (tet_corners t).
Proof. destruct i as [|[|[|i]]]; simpl; tauto. Qed.
Lemma rp_move n q : rp (cshift n q) = add (rp q) (vec h n).
Proof. apply rp_shift; auto. Qed.
Lemma corner_box t n q : In t (c_tets A c) -> In q (tet_corners t) -> in_box A c (box t) n (rp (cshift n q)).
Proof.
  intros Ht Hq. destruct chk_parts as [_ [_ [B _]]]. specialize (B t Ht). destruct (box t) as [[[x y] z] [[u v] w]] eqn:EB. clear EB.
  unfold chk_box in B. rewrite forallb_forall in B.
  assert (K : exists p, In p (kverts A (kpos den vs t)) /\ rp q = phi3 p).
  { unfold tet_corners in Hq. simpl in Hq. destruct Hq as [<-|[<-|[<-|[<-|[]]]]]; (eexists; split; [|reflexivity]); simpl; auto. }
  destruct K as [p [Hp E]]. specialize (B p Hp). rewrite !andb_true_iff in B. destruct B as [[[B1 B2] [B3 B4]] [B5 B6]].
  apply ale_ok in B1, B2, B3, B4, B5, B6. rewrite phi_Z, mult_IZR in B1, B2, B3, B4, B5, B6. fold h in B1, B2, B3, B4, B5, B6.
  rewrite rp_move, E. destruct n as [[i j] k]. unfold in_box. fold den h. rewrite !plus_IZR. unfold add, vec, Soundness.phi3; cbn [px py pz]. lra.
Qed.
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
Lemma boundary_facet k n i : boundary ((k, n), i) -> exists t, nth_error (c_tets A c) k = Some t /\ In t (c_tets A c) /\ In (k, (t, i)) (region_facets_of A c) /\ latb r n = true.
Proof.
  intros [[Hk Hn] [Hi U]]. cbn [fst snd] in *. destruct (tet k Hk) as [t [E [I _]]]. exists t. repeat split; auto. apply facets_In. repeat split; auto.
  unfold Degree.paired in U; cbn [fst snd] in U. unfold Soundness.cM in U. rewrite E in U. destruct (mt t i) as [[[? ?] ?]|]; auto. exfalso; apply U; discriminate.
Qed.

(** ** 2. The hypotheses of Region.v *)
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
  assert (ID : forall a b : Z3, {a = b} + {a <> b}) by (repeat decide equality).
  destruct (in_dec ID m (shifts r (box t) (box t'))) as [Im|Im].
  - apply (separated_sound A aadd asub amul aofZ alt ale phi phi_add phi_mul alt_ok ale_ok c (facet_corners t i) (map (cshift m) (facet_corners t' i'))).
    + apply corners_facet.
    + apply corners_moved.
    + destruct chk_parts as [_ [_ [_ [_ P]]]]. destruct (P k t i Ft) as [P1 _]. apply (P1 k' t' i' m); auto.
      intros [<- [<- Z]]. apply Ne. rewrite EM, Z, zadd3_30. reflexivity.
  - destruct (far_apart A c hpos (box t) (box t') m Lm Im) as [w [Aw [W1 W2]]]. exists w.
    assert (X : forall v, In v (corners (rtri (cfc t i))) -> w v < 0).
    { intros v Hv. rewrite corners_facet in Hv. apply in_map_iff in Hv as [q [<- Hq]]. apply W1.
      pose proof (corner_box t z30 q It (facet_tet t i q Hq)) as B. rewrite rp_move in B.
      replace (add (rp q) (vec h z30)) with (rp q) in B; auto. apply point_eq; unfold vec, z30, add; cbn [px py pz]; ring. }
    assert (Y : forall v, In v (corners (translate_triangle (vec h m) (rtri (cfc t' i')))) -> 0 < w v).
    { intros v Hv. rewrite corners_moved, map_map in Hv. apply in_map_iff in Hv as [q [<- Hq]]. apply W2, corner_box; auto. apply (facet_tet t' i'), Hq. }
    split; auto. split; [|split; [|split]].
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
  assert (ID : forall a b : Z3, {a = b} + {a <> b}) by (repeat decide equality).
  assert (MID : forall w, affine w -> w (middle F) = / 3 * (w (t1 F) + w (t2 F) + w (t3 F))).
  { intros w Aw. unfold middle. rewrite affine_combination3 by (auto; lra). ring. }
  assert (VT : 0 < vol T) by (unfold T; rewrite vol_ttr, <- ET'; apply rvol; auto).
  destruct (in_dec ID m (shifts r (box t) (box t'))) as [Im|Im].
  - destruct chk_parts as [_ [_ [_ [_ P]]]]. destruct (P k t i Ft) as [_ P2]. specialize (P2 k' t' m E' Im).
    assert (U : uncovers (facet_corners t i) (moved_tet m t') = true).
    { apply P2. intros [<- Z]. apply Ne. rewrite EM, Z, zadd3_30. reflexivity. }
    unfold chk_uncovered in U. cbv zeta in U. apply existsb_exists in U as [j [Hj U]]. apply alt_ok in U. rewrite (phi_zero A aofZ phi phi_Z) in U.
    specialize (C j Hj). rewrite (MID (coord T j)) in C by apply aff_o.
    assert (S : forall l, phi (fold_right (fun q s => aadd (kL A aadd asub amul (kpos den vs (moved_tet m t')) j (pos A aadd aofZ den vs q)) s) (zero A aofZ) l) =
      fold_right (fun q s => coord T j (rp q) + s) 0 l).
    { induction l as [|q l IH]; cbn [fold_right]; [apply (phi_zero A aofZ phi phi_Z)|].
      rewrite phi_add, IH. f_equal. rewrite (phi_L A aadd asub amul phi phi_add phi_sub phi_mul), moved_phiT. reflexivity. }
    rewrite S in U. assert (EQ : fold_right (fun q s => coord T j (rp q) + s) 0 (facet_corners t i) = coord T j (t1 F) + coord T j (t2 F) + coord T j (t3 F)).
    { unfold F. destruct i as [|[|[|i]]]; cbn [facet_corners cfc fold_right rtri Soundness.rtri t1 t2 t3]; ring. }
    rewrite EQ in U. lra.
  - destruct (far_apart A c hpos (box t) (box t') m Lm Im) as [w [Aw [W1 W2]]].
    assert (X : forall v, In v (corners F) -> w v < 0).
    { intros v Hv. unfold F in Hv. rewrite corners_facet in Hv. apply in_map_iff in Hv as [q [<- Hq]]. apply W1.
      pose proof (corner_box t z30 q It (facet_tet t i q Hq)) as B. rewrite rp_move in B.
      replace (add (rp q) (vec h z30)) with (rp q) in B; auto. apply point_eq; unfold vec, z30, add; cbn [px py pz]; ring. }
    assert (Y : forall q, In q (tet_corners t') -> 0 < w (add (rp q) (vec h m))).
    { intros q Hq. rewrite <- rp_move. apply W2, corner_box; auto. }
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
  destruct chk_parts as [_ [_ [_ [NE _]]]]. destruct (region_facets_of A c) as [|[k [t i]] l] eqn:E; [congruence|].
  assert (H : In (k, (t, i)) (region_facets_of A c)) by (rewrite E; left; auto). apply facets_In in H as [H1 [H2 H3]].
  exists ((k, z30), i). repeat split; auto; cbn [fst snd].
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
  - intros [[Hk Hn] H]. apply in_map_iff in H as [[k' [t i']] [E H]]. cbn [fst snd] in E. injection E as -> ->. apply facets_In in H as [H1 [H2 H3]].
    split; [split; auto; apply latb_iff; auto|]. split; auto. unfold Degree.paired; cbn [fst snd]. unfold Soundness.cM. rewrite H1, H3. congruence.
  - intros B. destruct (boundary_facet k n i B) as [t [E [It [F Ln]]]]. split; [split; [apply B|apply latb_iff; auto]|].
    apply in_map_iff. exists (k, (t, i)). auto.
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
    exists (cells N (latb r) K). intros cc X Hc HX H. apply VT in Hc. rewrite <- (e_back X), rhull in H by auto. apply HK with (y := back X); auto.
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
  - intros k i H. assert (B : exists t, In (k, (t, i)) (region_facets_of A c)).
    { unfold listed_facets in H. apply in_map_iff in H as [[k' [t i']] [E H]]. cbn [fst snd] in E. injection E as -> ->. eauto. }
    destruct B as [t B]. apply facets_In in B as [B1 [B2 _]]. split; [apply nth_error_Some; congruence|]. apply I4_lt, B2.
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
Theorem region_statement_sound st : check_region_statement A aadd asub amul aofZ alt ale c st = true ->
  holds l1 l2 l3 r N (dtet A aofZ phi c l1 l2 l3) (dstatement A phi st).
Proof.
  intros H. rewrite (dtet_cP A aadd asub amul aofZ alt phi phi_add phi_Z c base).
  destruct st as [| |rel sg p q|rel sg p q|rel p q| | |]; cbn [check_region_statement Checker.check_statement dstatement holds] in *; cbv zeta in H; try discriminate.
  - exact (each_angle A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c base l1 l2 l3 HG _ (fun x => x < PI / 2)
      (acute_sound A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c base l1 l2 l3 HG) H).
  - exact (each_angle A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c base l1 l2 l3 HG _ (fun x => x <= PI / 2)
      (nonobtuse_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z ale_ok c base l1 l2 l3 HG) H).
  - apply andb_true_iff in H as [B H]. apply (largest_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok c base l1 l2 l3 HG); auto.
  - apply andb_true_iff in H as [B H]. apply (smallest_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok c base l1 l2 l3 HG); auto.
  - apply andb_true_iff in H as [B H]. apply andb_true_iff in B as [B _]. apply Z.ltb_lt, IZR_lt in B.
    apply (radius_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok c base l1 l2 l3 HG); auto.
Qed.
End Basis.
End Sound.
Theorem region_basis_exists c : check_region c = true -> exists l1 l2 l3, has_gram (dgram A phi c) l1 l2 l3.
Proof. intros H. apply gram_exists. apply (cgram A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c (base c H)). Qed.
End Ring.
