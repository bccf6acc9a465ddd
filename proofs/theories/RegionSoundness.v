(** * Soundness: "true" of [check_region] implies [face_to_face_region]

    1. What the checks of one pair say: [separated_sound], [far_apart].
    2. The hypotheses of Region.v, for all translates.
    3. The theorem, in Euclidean space. *)
Require Import Reals Lra Psatz NArith Nnat ZArith List Lia Bool FunctionalExtensionality.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Facets Region Domain Bounds Euclid Transfer Checker Keys Soundness RegionStatement RegionChecker.
Import ListNotations.
Open Scope R_scope.

(** ** Lists, lattice vectors *)
Lemma numbered_In {X} (l : list X) : forall s k x, In (k, x) (numbered s l) <-> (s <= k)%nat /\ nth_error l (k - s) = Some x.
Proof.
  induction l as [|y l IH]; intros s k x; cbn [numbered].
  - split; [intros []|]. intros [_ H]. destruct (k - s)%nat; discriminate.
  - cbn [In]. rewrite IH. split.
    + intros [E|[H1 H2]].
      * injection E as <- <-. split; [lia|]. rewrite Nat.sub_diag. reflexivity.
      * split; [lia|]. replace (k - s)%nat with (S (k - S s)) by lia. exact H2.
    + intros [H1 H2]. destruct (Nat.eq_dec s k) as [->|Ne].
      * left. rewrite Nat.sub_diag in H2. injection H2 as ->. reflexivity.
      * right. split; [lia|]. replace (k - s)%nat with (S (k - S s)) in H2 by lia. exact H2.
Qed.
Lemma zrange_In a b x : In x (zrange a b) <-> (a <= x <= b)%Z.
Proof.
  unfold zrange. rewrite in_map_iff. split.
  - intros [i [<- Hi]]. apply in_seq in Hi. lia.
  - intros H. exists (Z.to_nat (x - a)). split; [lia|]. apply in_seq. lia.
Qed.
Lemma range1_In m lo hi lo' hi' x : (lo <= hi' + x)%Z -> (lo' + x <= hi)%Z -> (m = false -> x = 0%Z) -> In x (range1 m lo hi lo' hi').
Proof.
  intros H1 H2 H3. unfold range1. destruct m; [apply zrange_In; lia|]. specialize (H3 eq_refl). subst x.
  destruct (Z.leb_spec lo hi'); [|lia]. destruct (Z.leb_spec lo' hi); [|lia]. simpl; auto.
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
  chk_direction A aadd amul aofZ alt ale den vs f g d = true -> exists w, separates w F G.
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
  chk_separated A aadd asub amul aofZ alt ale den vs f g = true -> exists w, separates w F G.
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
  destruct (chk_direction A aadd amul aofZ alt ale den vs f g d) eqn:E; [apply (direction_sound f g d) | apply (direction_sound f g _ F G CF CG P' Q' H)]; auto.
Qed.

(** Boxes that do not meet. *)
Definition in_box (b : box) (n : Z3) (x : point) :=
  let '((x1, y1, z1), (u, v, w)) := b in let '(i, j, k) := n in
  h * IZR (x1 + i) <= px x <= h * IZR (u + i) /\ h * IZR (y1 + j) <= py x <= h * IZR (v + j) /\ h * IZR (z1 + k) <= pz x <= h * IZR (w + k).
Hypothesis h_pos : 0 < h.
Lemma far_apart b b' n : latb r n = true -> ~ In n (shifts r b b') -> exists w, affine w /\
  (forall x, in_box b z30 x -> w x < 0) /\ (forall x, in_box b' n x -> 0 < w x).
Proof.
  destruct b as [[[x y] z] [[u v] w]], b' as [[[x' y'] z'] [[u' v'] w']], n as [[i j] k]. intros Hn H. apply latb_iff in Hn.
  assert (D : (u < x' + i \/ u' + i < x \/ v < y' + j \/ v' + j < y \/ w < z' + k \/ w' + k < z)%Z).
  { destruct (Z_lt_ge_dec u (x' + i)); [lia|]. destruct (Z_lt_ge_dec (u' + i) x); [lia|]. destruct (Z_lt_ge_dec v (y' + j)); [lia|].
    destruct (Z_lt_ge_dec (v' + j) y); [lia|]. destruct (Z_lt_ge_dec w (z' + k)); [lia|]. destruct (Z_lt_ge_dec (w' + k) z); [lia|].
    exfalso. apply H. unfold shifts. apply in_prod; [apply in_prod|]; apply range1_In; try lia.
    - destruct r as [|[|[|?]]]; cbn in *; try discriminate; lia.
    - destruct r as [|[|[|?]]]; cbn in *; try discriminate; lia.
    - destruct r as [|[|[|?]]]; cbn in *; try discriminate; lia. }
  assert (LT : forall a b', (a < b')%Z -> h * IZR a < h * ((IZR a + IZR b') / 2) < h * IZR b').
  { intros a b' L. apply IZR_lt in L. split; apply Rmult_lt_compat_l; lra. }
  unfold in_box, z30. destruct D as [D|[D|[D|[D|[D|D]]]]]; pose proof (LT _ _ D) as [L1 L2].
  - exists (fun p => px p - h * ((IZR u + IZR (x' + i)) / 2)). split; [exists 1, 0, 0, (- (h * ((IZR u + IZR (x' + i)) / 2))); intros; ring|].
    rewrite !Z.add_0_r. split; intros; lra.
  - exists (fun p => h * ((IZR (u' + i) + IZR x) / 2) - px p). split; [exists (-1), 0, 0, (h * ((IZR (u' + i) + IZR x) / 2)); intros; ring|].
    rewrite !Z.add_0_r. split; intros; lra.
  - exists (fun p => py p - h * ((IZR v + IZR (y' + j)) / 2)). split; [exists 0, 1, 0, (- (h * ((IZR v + IZR (y' + j)) / 2))); intros; ring|].
    rewrite !Z.add_0_r. split; intros; lra.
  - exists (fun p => h * ((IZR (v' + j) + IZR y) / 2) - py p). split; [exists 0, (-1), 0, (h * ((IZR (v' + j) + IZR y) / 2)); intros; ring|].
    rewrite !Z.add_0_r. split; intros; lra.
  - exists (fun p => pz p - h * ((IZR w + IZR (z' + k)) / 2)). split; [exists 0, 0, 1, (- (h * ((IZR w + IZR (z' + k)) / 2))); intros; ring|].
    rewrite !Z.add_0_r. split; intros; lra.
  - exists (fun p => h * ((IZR (w' + k) + IZR z) / 2) - pz p). split; [exists 0, 0, (-1), (h * ((IZR (w' + k) + IZR z) / 2)); intros; ring|].
    rewrite !Z.add_0_r. split; intros; lra.
Qed.
End Ring.
