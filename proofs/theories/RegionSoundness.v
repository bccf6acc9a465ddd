(** * Soundness: "true" of [check_region] implies [face_to_face_region]

    1. What the checks of one pair say: [separated_sound], [far_apart].
    2. The hypotheses of Region.v, for all translates.
    3. The theorem, in Euclidean space. *)
Require Import Reals Lra Psatz NArith Nnat ZArith List Lia Bool FunctionalExtensionality.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Facets Region Domain Bounds Euclid Transfer Checker Keys Soundness RegionStatement Fast Grid RegionChecker.
Import ListNotations.
Open Scope R_scope.

(** ** Lists, lattice vectors *)
Lemma collect_In {X Y} (f : N -> X -> list Y -> list Y) (P : N -> X -> Y -> Prop) :
  (forall k x l y, In y (f k x l) <-> P k x y \/ In y l) ->
  forall l k found y, In y (collect f k l found) <-> (exists j x, nth_error l j = Some x /\ P (k + N.of_nat j)%N x y) \/ In y found.
Proof.
  intros H. induction l as [|x l IH]; intros k found y; cbn [collect].
  - split; auto. intros [[[|j] [x [E _]]]|]; auto; discriminate.
  - rewrite IH, H. split.
    + intros [[j [x' [E P']]]|[P'|I]]; auto.
      * left. exists (S j), x'. split; auto. replace (k + N.of_nat (S j))%N with (N.succ k + N.of_nat j)%N by lia. exact P'.
      * left. exists 0%nat, x. split; auto. replace (k + N.of_nat 0)%N with k by lia. exact P'.
    + intros [[[|j] [x' [E P']]]|I]; auto.
      * injection E as <-. right; left. replace (k + N.of_nat 0)%N with k in P' by lia. exact P'.
      * left. exists j, x'. split; auto. replace (N.succ k + N.of_nat j)%N with (k + N.of_nat (S j))%N by lia. exact P'.
Qed.
Lemma numbered_tets_In ts k t : In (k, t) (numbered_tets ts) <-> nth_error ts (N.to_nat k) = Some t.
Proof.
  unfold numbered_tets. rewrite (collect_In _ (fun k t y => y = (k, t))).
  - split.
    + intros [[j [x [E X]]]|[]]. injection X as -> ->. rewrite ?N.add_0_l, Nnat.Nat2N.id. exact E.
    + intros E. left. exists (N.to_nat k), t. split; auto. rewrite N.add_0_l, N2Nat.id. reflexivity.
  - intros. simpl. intuition.
Qed.
Lemma open_facets_In ts k t i : In (k, t, i) (open_facets ts) <-> nth_error ts (N.to_nat k) = Some t /\ In i I4 /\ mt t i = None.
Proof.
  unfold open_facets. rewrite (collect_In _ (fun k t y => exists i, y = (k, t, i) /\ In i I4 /\ mt t i = None)).
  - split.
    + intros [[j [x [E [i' [X Y]]]]]|[]]. injection X as -> -> ->. rewrite ?N.add_0_l, Nnat.Nat2N.id. auto.
    + intros [E X]. left. exists (N.to_nat k), t. split; auto. exists i. rewrite N.add_0_l, N2Nat.id. auto.
  - intros k' t' l y. unfold I4. generalize [0; 1; 2; 3]%nat as is. induction is as [|i' is IH]; cbn [fold_right].
    + split; auto. intros [[? [_ [[] _]]]|]; auto.
    + unfold unmated. destruct (mt t' i') as [m|] eqn:E; [|cbn [In]]; rewrite IH; split.
      * intros [[i0 [H1 [H2 H3]]]|H]; auto. left. exists i0. simpl. auto.
      * intros [[i0 [H1 [[<-|H2] H3]]]|H]; auto; [congruence|]. left. exists i0. auto.
      * intros [<-|[[i0 [H1 [H2 H3]]]|H]]; auto; left; [exists i'|exists i0]; simpl; auto.
      * intros [[i0 [H1 [[<-|H2] H3]]]|H]; auto. right; left. exists i0. auto.
Qed.
Lemma zadd3_sub a b : zadd3 a (zadd3 b (zopp3 a)) = b.
Proof. destruct a as [[? ?] ?], b as [[? ?] ?]. cbn. repeat f_equal; lia. Qed.
Lemma zadd3_30 a : zadd3 a z30 = a.
Proof. destruct a as [[? ?] ?]. cbn. repeat f_equal; lia. Qed.
Lemma between_lists (la lb : list R) : la <> [] -> lb <> [] -> (forall a b, In a la -> In b lb -> a < b) ->
  exists c, (forall a, In a la -> a < c) /\ (forall b, In b lb -> c < b).
Proof.
  intros Na Nb H. destruct (least (fun x => - x) la Na) as [a [Ha La]]. destruct (least (fun x => x) lb Nb) as [b [Hb Lb]].
  specialize (H a b Ha Hb). exists ((a + b) / 2). split; [intros x Hx; specialize (La x Hx); lra | intros x Hx; specialize (Lb x Hx); lra].
Qed.
(** A segment, translated. *)
Lemma corners_translate u f : corners (translate_triangle u f) = map (fun v => add v u) (corners f).
Proof. reflexivity. Qed.
Lemma separates_translate w u f g : separates w f g -> separates (fun x => w (sub x u)) (translate_triangle u f) (translate_triangle u g).
Proof.
  assert (K : forall v, sub (add v u) u = v) by (intros; apply point_eq; unf; ring).
  assert (T : forall F v, In v (corners (translate_triangle u F)) <-> exists v', In v' (corners F) /\ v = add v' u).
  { intros F v. rewrite corners_translate, in_map_iff. split; intros [v' [X Y]]; exists v'; auto. }
  intros [A [F [[x [Hx Lx]] [G [y [Hy Ly]]]]]]. split; [|split; [|split; [|split]]].
  - destruct A as [a [b [c [d H]]]]. exists a, b, c, (d - a * px u - b * py u - c * pz u). intros v. rewrite H. unf. ring.
  - intros v Hv. apply T in Hv as [v' [Hv' ->]]. rewrite K. destruct (F v' Hv') as [F1 F2]. split; auto. intros E. apply T. exists v'. auto.
  - exists (add x u). rewrite K. split; auto. apply T. eauto.
  - intros v Hv. apply T in Hv as [v' [Hv' ->]]. rewrite K. destruct (G v' Hv') as [F1 F2]. split; auto. intros E. apply T. exists v'. auto.
  - exists (add y u). rewrite K. split; auto. apply T. eauto.
Qed.
Lemma on_translate u f x : on (translate_triangle u f) x <-> on f (sub x u).
Proof.
  split; intros [a [b [c [A [B [C [S E]]]]]]]; exists a, b, c; repeat split; auto.
  - rewrite E. replace a with (1 - b - c) by lra. apply point_eq; unfold combination3, translate_triangle; cbn [t1 t2 t3]; unf; ring.
  - transitivity (add (sub x u) u); [apply point_eq; unf; ring|]. rewrite E. replace a with (1 - b - c) by lra.
    apply point_eq; unfold combination3, translate_triangle; cbn [t1 t2 t3]; unf; ring.
Qed.
Lemma closed_translate u t x : closed (translate u t) (add x u) <-> closed t x.
Proof.
  assert (K : forall i, coord (translate u t) i (add x u) = coord t i x).
  { intros i. unfold coord. rewrite facet_translate. unfold side, translate_triangle; cbn [t1 t2 t3]. unf. ring. }
  unfold closed. split; intros H i Hi; specialize (H i Hi); rewrite K in *; auto.
Qed.
Lemma middle_translate u f : middle (translate_triangle u f) = add (middle f) u.
Proof. apply point_eq; unfold middle, combination3, translate_triangle; cbn [t1 t2 t3]; unf; field. Qed.

Definition rcoordinate (j : nat) (x : point) : R := match j with 0 => px x | 1 => py x | _ => pz x end%nat.
Definition shift_on (j : nat) (n : Z3) : Z := let '(x, y, z) := n in match j with 0 => x | 1 => y | _ => z end%nat.
Lemma latb_shift r n j : latb r n = true -> (j < 3)%nat -> Nat.ltb j r = false -> shift_on j n = 0%Z.
Proof.
  intros L J H. apply latb_iff in L. apply Nat.ltb_ge in H. destruct n as [[x y] z]. unfold shift_on.
  destruct r as [|[|[|r]]]; cbn in L; destruct j as [|[|[|j]]]; try lia; tauto.
Qed.

Section Ring.
Variables (A : Type) (aadd asub amul : A -> A -> A) (aofZ : Z -> A) (alt ale : A -> A -> bool).

Variable phi : A -> R.
Hypothesis phi_add : forall x y, phi (aadd x y) = (phi x + phi y)%R.
Hypothesis phi_sub : forall x y, phi (asub x y) = (phi x - phi y)%R.
Hypothesis phi_mul : forall x y, phi (amul x y) = (phi x * phi y)%R.
Hypothesis phi_Z : forall z, phi (aofZ z) = IZR z.
Hypothesis alt_ok : forall x y, alt x y = true -> (phi x < phi y)%R.
Hypothesis ale_ok : forall x y, ale x y = true -> (phi x <= phi y)%R.
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

(** ** 1. One pair *)
Lemma kdot_ok d v : phi (kdot A aadd amul d v) = dot (phi3 d) (phi3 v).
Proof. unfold kdot, dot, Soundness.phi3; cbn [px py pz]. rewrite !phi_add, !phi_mul. ring. Qed.
Lemma among_ok q l : among_corners q l = true <-> In q l.
Proof.
  unfold among_corners. rewrite existsb_exists. split; [intros [x [Hx E]]; apply ceqb_t in E; subst; auto|]. intros H. exists q. split; auto. apply ceqb_t; auto.
Qed.
Lemma dot_affine d : forall k, affine (fun x => dot d x - k).
Proof. intros k. exists (px d), (py d), (pz d), (- k). intros x. unfold dot. ring. Qed.

Lemma direction_sound f g d F G : corners F = map rp f -> corners G = map rp g ->
  (exists p, In p f /\ ~ In p g) -> (exists q, In q g /\ ~ In q f) ->
  chk_direction A aadd amul alt ale (pos A aadd aofZ den vs) f g d = true -> exists w, separates w F G.
Proof.
  intros CF CG [p0 [Hp0 Np0]] [q0 [Hq0 Nq0]] H. unfold chk_direction in H. rewrite forallb_forall in H.
  set (val := fun q => dot (phi3 d) (rp q)).
  assert (L : forall p q, In p f -> In q g -> val p <= val q /\ (~ (In p g /\ In q f) -> val p < val q)).
  { intros p q Hp Hq. specialize (H p Hp). rewrite forallb_forall in H. specialize (H q Hq).
    change (val p) with (dot (phi3 d) (phi3 (pos A aadd aofZ den vs p))). change (val q) with (dot (phi3 d) (phi3 (pos A aadd aofZ den vs q))).
    rewrite <- !kdot_ok. destruct (among_corners p g && among_corners q f) eqn:E.
    - apply andb_true_iff in E. rewrite !among_ok in E. apply ale_ok in H. split; [exact H|tauto].
    - apply alt_ok in H. split; [lra|auto]. }
  assert (K : exists k, (forall p, In p f -> (In p g -> val p = k) /\ (~ In p g -> val p < k)) /\ (forall q, In q g -> (In q f -> val q = k) /\ (~ In q f -> k < val q))).
  { destruct (existsb (fun p => among_corners p g) f) eqn:E.
    - apply existsb_exists in E as [p [Hp E]]. apply among_ok in E. exists (val p). split.
      + intros p' Hp'. split; [intros Hg; apply Rle_antisym; apply L; auto|]. intros Ng. apply L; auto. tauto.
      + intros q Hq. split; [intros Hf; apply Rle_antisym; apply L; auto|]. intros Nf. apply L; auto. tauto.
    - assert (NC : forall p, In p f -> ~ In p g).
      { intros p Hp Hg. assert (X : existsb (fun p => among_corners p g) f = true); [|congruence]. apply existsb_exists. exists p. split; auto. apply among_ok; auto. }
      destruct (between_lists (map val f) (map val g)) as [k [K1 K2]].
      { destruct f; [destruct Hp0|discriminate]. }
      { destruct g; [destruct Hq0|discriminate]. }
      { intros a b Ha Hb. apply in_map_iff in Ha as [p [<- Hp]]. apply in_map_iff in Hb as [q [<- Hq]]. apply L; auto. intros [X _]. apply (NC p); auto. }
      exists k. split.
      + intros p Hp. split; [intros X; destruct (NC p Hp X)|]. intros _. apply K1, in_map; auto.
      + intros q Hq. split; [intros X; destruct (NC q X Hq)|]. intros _. apply K2, in_map; auto. }
  destruct K as [k [K1 K2]]. exists (fun x => dot (phi3 d) x - k).
  assert (DEC : forall p l, In p l \/ ~ In p l) by (intros p l; destruct (among_corners p l) eqn:E; [left; apply among_ok; auto|right; rewrite <- among_ok; congruence]).
  split; [apply dot_affine|]. rewrite CF, CG. split; [|split; [|split]].
  - intros v Hv. apply in_map_iff in Hv as [p [<- Hp]]. fold (val p). destruct (K1 p Hp) as [X Y]. destruct (DEC p g) as [I|I].
    + rewrite X by auto. split; [lra|]. intros _. apply in_map; auto.
    + specialize (Y I). split; [lra|]. lra.
  - exists (rp p0). split; [apply in_map; auto|]. fold (val p0). destruct (K1 p0 Hp0) as [_ Y]. specialize (Y Np0). lra.
  - intros v Hv. apply in_map_iff in Hv as [p [<- Hp]]. fold (val p). destruct (K2 p Hp) as [X Y]. destruct (DEC p f) as [I|I].
    + rewrite X by auto. split; [lra|]. intros _. apply in_map; auto.
    + specialize (Y I). split; [lra|]. lra.
  - exists (rp q0). split; [apply in_map; auto|]. fold (val q0). destruct (K2 q0 Hq0) as [_ Y]. specialize (Y Nq0). lra.
Qed.
Lemma separated_sound f g F G : corners F = map rp f -> corners G = map rp g ->
  chk_separated A aadd asub amul aofZ alt ale (pos A aadd aofZ den vs) f g = true -> exists w, separates w F G.
Proof.
  intros CF CG H. unfold chk_separated in H. cbv zeta in H.
  destruct (filter (fun q => negb (among_corners q g)) f) as [|p own] eqn:E1; [discriminate|].
  destruct (filter (fun q => negb (among_corners q f)) g) as [|q oth] eqn:E2; [discriminate|].
  assert (P : In p (filter (fun q => negb (among_corners q g)) f)) by (rewrite E1; simpl; auto).
  assert (Q : In q (filter (fun q => negb (among_corners q f)) g)) by (rewrite E2; simpl; auto).
  apply filter_In in P as [P1 P2]. apply filter_In in Q as [Q1 Q2].
  assert (P' : exists p, In p f /\ ~ In p g) by (exists p; split; auto; rewrite <- among_ok; intros X; rewrite X in P2; discriminate).
  assert (Q' : exists q, In q g /\ ~ In q f) by (exists q; split; auto; rewrite <- among_ok; intros X; rewrite X in Q2; discriminate).
  rewrite existsl_eq in H. apply existsb_exists in H as [d [_ H]].
  destruct (chk_direction A aadd amul alt ale (pos A aadd aofZ den vs) f g d) eqn:E; [apply (direction_sound f g d) | apply (direction_sound f g _ F G CF CG P' Q' H)]; auto.
Qed.

(** Boxes that do not meet. *)
Variable u : units.
Hypothesis u_ok : u_rank u = r /\ u_den u = den.
Hypothesis w_pos : (0 < u_width u)%Z.
Hypothesis h_pos : 0 < h.
Let sc (j : nat) := IZR (step (u_rank u) (u_cells u) j).
Let wd (j : nat) := IZR (width u j).
Definition in_interval (j : nat) (i : interval) (m : Z) (x : point) :=
  wd j * IZR (fst i + step (u_rank u) (u_cells u) j * m) <= sc j * rcoordinate j x < wd j * IZR (snd i + step (u_rank u) (u_cells u) j * m + 1).
Definition in_box (b : box) (n : Z3) (x : point) :=
  let '(b0, b1, b2) := b in in_interval 0 b0 (shift_on 0 n) x /\ in_interval 1 b1 (shift_on 1 n) x /\ in_interval 2 b2 (shift_on 2 n) x.
Lemma wd_pos j : 0 < wd j.
Proof. unfold wd, width. destruct u_ok as [_ ->]. destruct (Nat.ltb j (u_rank u)); [apply h_pos|apply IZR_lt; auto]. Qed.
(** A box moves with its points. *)
Lemma interval_move j i n x : (Nat.ltb j r = false -> shift_on j n = 0%Z) -> rcoordinate j (vec h n) = h * IZR (shift_on j n) ->
  in_interval j i 0 x -> in_interval j i (shift_on j n) (add x (vec h n)).
Proof.
  intros Z0 V. unfold in_interval. rewrite Z.mul_0_r, !Z.add_0_r.
  assert (E : rcoordinate j (add x (vec h n)) = rcoordinate j x + rcoordinate j (vec h n)) by (destruct j as [|[|j]]; reflexivity).
  rewrite E, V, Rmult_plus_distr_l. set (m := shift_on j n) in *.
  assert (K : sc j * (h * IZR m) = wd j * IZR (step (u_rank u) (u_cells u) j * m)).
  { unfold sc, wd, width. destruct u_ok as [-> ->]. fold h. unfold step. destruct (Nat.ltb j r); [rewrite mult_IZR; unfold h; ring|].
    rewrite (Z0 eq_refl). rewrite Z.mul_0_r. ring. }
  rewrite K. set (M := (step (u_rank u) (u_cells u) j * m)%Z). replace (snd i + M + 1)%Z with (snd i + 1 + M)%Z by ring.
  rewrite !(plus_IZR _ M), !Rmult_plus_distr_l. lra.
Qed.
Lemma box_move b n x : latb r n = true -> in_box b z30 x -> in_box b n (add x (vec h n)).
Proof.
  intros L. destruct b as [[b0 b1] b2]. unfold in_box. intros [H0 [H1 H2]].
  assert (K : forall j, (j < 3)%nat -> rcoordinate j (vec h n) = h * IZR (shift_on j n)).
  { intros j _. destruct n as [[? ?] ?], j as [|[|[|j]]]; reflexivity. }
  split; [|split]; apply interval_move; auto; intros F; apply (latb_shift r); auto.
Qed.
Lemma coordinate_affine j k : affine (fun x => sc j * rcoordinate j x - k).
Proof.
  destruct j as [|[|j]].
  - exists (sc 0), 0, 0, (- k). intros x. cbn. ring.
  - exists 0, (sc 1), 0, (- k). intros x. cbn. ring.
  - exists 0, 0, (sc (S (S j))), (- k). intros x. cbn. ring.
Qed.
Lemma apart_below j i i' m m' (ps qs : list point) : (snd i + step (u_rank u) (u_cells u) j * m < fst i' + step (u_rank u) (u_cells u) j * m')%Z ->
  ps <> [] -> qs <> [] -> (forall x, In x ps -> in_interval j i m x) -> (forall x, In x qs -> in_interval j i' m' x) ->
  exists k, (forall x, In x ps -> sc j * rcoordinate j x < k) /\ (forall x, In x qs -> k < sc j * rcoordinate j x).
Proof.
  intros L Np Nq P Q. destruct (between_lists (map (fun x => sc j * rcoordinate j x) ps) (map (fun x => sc j * rcoordinate j x) qs)) as [k [K1 K2]].
  - destruct ps; [congruence|discriminate].
  - destruct qs; [congruence|discriminate].
  - intros a b Ha Hb. apply in_map_iff in Ha as [x [<- Hx]]. apply in_map_iff in Hb as [y [<- Hy]].
    destruct (P x Hx) as [_ P2]. destruct (Q y Hy) as [Q1 _].
    apply Rlt_le_trans with (1 := P2). apply Rle_trans with (2 := Q1). apply Rmult_le_compat_l; [pose proof (wd_pos j); lra|]. apply IZR_le. lia.
  - exists k. split; intros x Hx; [apply K1|apply K2]; apply (in_map (fun x => sc j * rcoordinate j x)), Hx.
Qed.
Lemma far_apart n b b' (ps qs : list point) : meet (u_rank u) (u_cells u) n b b' = false -> ps <> [] -> qs <> [] ->
  (forall x, In x ps -> in_box b z30 x) -> (forall x, In x qs -> in_box b' n x) ->
  exists w, affine w /\ (forall x, In x ps -> w x < 0) /\ (forall x, In x qs -> 0 < w x).
Proof.
  intros M Np Nq P Q.
  assert (ONE : forall j i i' m, meet1 (u_rank u) (u_cells u) j m i i' = false ->
    (forall x, In x ps -> in_interval j i 0 x) -> (forall x, In x qs -> in_interval j i' m x) ->
    exists w, affine w /\ (forall x, In x ps -> w x < 0) /\ (forall x, In x qs -> 0 < w x)).
  { intros j i i' m F P' Q'. unfold meet1 in F. apply andb_false_iff in F. rewrite !Z.leb_gt in F. destruct F as [F|F].
    - destruct (apart_below j i' i m 0 qs ps) as [k [K1 K2]]; auto; [lia|]. exists (fun x => - sc j * rcoordinate j x + k). split; [|split].
      + destruct (coordinate_affine j k) as [a [b0 [c0 [d H]]]]. exists (- a), (- b0), (- c0), (- d). intros x. specialize (H x). cbv beta in *. lra.
      + intros x Hx. specialize (K2 x Hx). lra.
      + intros x Hx. specialize (K1 x Hx). lra.
    - destruct (apart_below j i i' 0 m ps qs) as [k [K1 K2]]; auto; [lia|]. exists (fun x => sc j * rcoordinate j x - k). split; [apply coordinate_affine|].
      split; intros x Hx; [specialize (K1 x Hx)|specialize (K2 x Hx)]; lra. }
  destruct b as [[b0 b1] b2], b' as [[c0 c1] c2], n as [[x y] z]. unfold meet in M. apply andb_false_iff in M as [M|M]; [apply andb_false_iff in M as [M|M]|].
  - apply (ONE _ _ _ _ M); intros p Hp; [apply (P p Hp)|apply (Q p Hp)].
  - apply (ONE _ _ _ _ M); intros p Hp; [apply (P p Hp)|apply (Q p Hp)].
  - apply (ONE _ _ _ _ M); intros p Hp; [apply (P p Hp)|apply (Q p Hp)].
Qed.
(** What the check of a box says. *)
Lemma level_in_ok j v : phi (level_in A amul aofZ u j v) = sc j * rcoordinate j (phi3 v).
Proof.
  assert (E : phi (coordinate A j v) = rcoordinate j (phi3 v)) by (destruct j as [|[|j]]; reflexivity).
  unfold level_in, scaled_by. fold (sc j). destruct (Z.eqb_spec (step (u_rank u) (u_cells u) j) 1) as [S|S].
  - unfold sc. rewrite S, E. ring.
  - rewrite phi_mul, phi_Z, E. reflexivity.
Qed.
Lemma interval_sound j i v : chk_interval A amul aofZ alt ale u j i v = true -> in_interval j i 0 (phi3 v).
Proof.
  unfold chk_interval. cbv zeta. rewrite andb_true_iff. intros [H1 H2]. apply ale_ok in H1. apply alt_ok in H2.
  rewrite phi_Z, level_in_ok, mult_IZR in *. unfold in_interval. rewrite Z.mul_0_r, !Z.add_0_r. auto.
Qed.
Lemma box_sound b vs' v : chk_box A amul aofZ alt ale u b vs' = true -> In v vs' -> in_box b z30 (phi3 v).
Proof.
  destruct b as [[b0 b1] b2]. unfold chk_box. rewrite andb_true_iff, forallb_forall. intros [_ H] Hv. specialize (H v Hv).
  rewrite !andb_true_iff in H. destruct H as [[H0 H1] H2]. apply interval_sound in H0, H1, H2. unfold in_box, z30, shift_on. auto.
Qed.
Lemma box_proper b vs' : chk_box A amul aofZ alt ale u b vs' = true -> proper b = true.
Proof. destruct b as [[b0 b1] b2]. unfold chk_box. intros H. apply andb_true_iff in H as [H _]. exact H. Qed.
End Ring.
