(* Points, determinants, tetrahedra and the crossing identity for one tetrahedron. *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing.
Import ListNotations.
Open Scope R_scope.

Lemma point_eq a b : px a = px b -> py a = py b -> pz a = pz b -> a = b.
Proof. destruct a, b; simpl; intros; subst; auto. Qed.

Definition lerp p q s := add p (scale s (sub q p)).

Definition orient a b c d := det (sub b a) (sub c a) (sub d a).

Ltac unf := unfold orient, det, lerp, sub, add, scale in *; cbn [px py pz] in *.

Record triangle := Triangle { t1 : point; t2 : point; t3 : point }.

(* facet i is opposite to vertex i and oriented so that vertex i is on the positive side *)
Definition facet (t : tetrahedron) (i : nat) : triangle :=
  match i with
  | 0 => Triangle (vb t) (vd t) (vc t)
  | 1 => Triangle (va t) (vc t) (vd t)
  | 2 => Triangle (va t) (vd t) (vb t)
  | _ => Triangle (va t) (vb t) (vc t)
  end%nat.
Definition I4 := [0; 1; 2; 3]%nat.
Definition vx (t : tetrahedron) (i : nat) : point :=
  match i with 0 => va t | 1 => vb t | 2 => vc t | _ => vd t end%nat.

Definition side (f : triangle) (x : point) := orient (t1 f) (t2 f) (t3 f) x.
Definition coord t i x := side (facet t i) x.

Definition closed t x := forall i, In i I4 -> 0 <= coord t i x.
Definition inside t x := forall i, In i I4 -> 0 < coord t i x.
Definition insideb t x := forallb (fun i => posb (coord t i x)) I4.

Lemma interb_t t x : insideb t x = true <-> inside t x.
Proof. unfold insideb, inside. rewrite forallb_forall. split; intros H i Hi; specialize (H i Hi); apply posb_t; auto. Qed.
Lemma inter_closed t x : inside t x -> closed t x.
Proof. intros H i Hi. specialize (H i Hi). lra. Qed.

Lemma L_sum t x : coord t 0 x + coord t 1 x + coord t 2 x + coord t 3 x = vol t.
Proof. unfold coord, side, vol, facet; cbn [t1 t2 t3]. unf. ring. Qed.

Lemma L_bary t x :
  scale (vol t) x = add (add (scale (coord t 0 x) (va t)) (scale (coord t 1 x) (vb t)))
                        (add (scale (coord t 2 x) (vc t)) (scale (coord t 3 x) (vd t))).
Proof. unfold coord, side, vol, facet; cbn [t1 t2 t3]. apply point_eq; unf; ring. Qed.

(* signed crossing number of the segment p q with an oriented triangle *)
Definition crp f p q : bool :=
  posb (- side f p) && posb (side f q) && posb (orient p q (t1 f) (t2 f)) && posb (orient p q (t2 f) (t3 f)) && posb (orient p q (t3 f) (t1 f)).
Definition crm f p q : bool :=
  posb (side f p) && posb (- side f q) && posb (- orient p q (t1 f) (t2 f)) && posb (- orient p q (t2 f) (t3 f)) && posb (- orient p q (t3 f) (t1 f)).
Definition crossing f p q : Z := (Z.b2z (crp f p q) - Z.b2z (crm f p q))%Z.

Lemma crp_t f p q : crp f p q = true <-> side f p < 0 /\ 0 < side f q /\ 0 < orient p q (t1 f) (t2 f) /\ 0 < orient p q (t2 f) (t3 f) /\ 0 < orient p q (t3 f) (t1 f).
Proof. unfold crp. bsimp. intuition lra. Qed.
Lemma crm_t f p q : crm f p q = true <-> 0 < side f p /\ side f q < 0 /\ orient p q (t1 f) (t2 f) < 0 /\ orient p q (t2 f) (t3 f) < 0 /\ orient p q (t3 f) (t1 f) < 0.
Proof. unfold crm. bsimp. intuition lra. Qed.

(* the segment p q is generic with respect to the triangle f *)
Definition generic_edge f p q := orient p q (t1 f) (t2 f) <> 0 /\ orient p q (t2 f) (t3 f) <> 0 /\ orient p q (t3 f) (t1 f) <> 0.

Definition prs t p q : list (R * R) := map (fun i => (coord t i p, coord t i q)) I4.


Definition mm t p q i j := m (coord t i p, coord t i q) (coord t j p, coord t j q).
Definition jx (i e : nat) : nat :=
  match i, e with
  | 0, 1 => 2 | 0, 2 => 1 | 0, _ => 3
  | 1, 1 => 3 | 1, 2 => 0 | 1, _ => 2
  | 2, 1 => 1 | 2, 2 => 0 | 2, _ => 3
  | _, 1 => 2 | _, 2 => 0 | _, _ => 1
  end%nat.
Lemma m_id t p q i : In i I4 ->
  mm t p q i (jx i 1) = vol t * orient p q (t1 (facet t i)) (t2 (facet t i)) /\
  mm t p q i (jx i 2) = vol t * orient p q (t2 (facet t i)) (t3 (facet t i)) /\
  mm t p q i (jx i 3) = vol t * orient p q (t3 (facet t i)) (t1 (facet t i)).
Proof.
  unfold I4, mm, m, vol, coord, side. cbn [fst snd].
  intros [<-|[<-|[<-|[<-|[]]]]]; cbn [facet t1 t2 t3 jx]; unf; repeat split; ring.
Qed.

Lemma mm_anti t p q i j : mm t p q i j = - mm t p q j i.
Proof. unfold mm, m. ring. Qed.

(* genericity of p q for the tetrahedron t *)
Record generic_for t p q : Prop := {
  g_p : forall i, In i I4 -> coord t i p <> 0;
  g_q : forall i, In i I4 -> coord t i q <> 0;
  g_e : forall i, In i I4 -> generic_edge (facet t i) p q }.

(** The weaker condition that the ray of Slices.v needs: a facet that is not met in
    general position is parallel to the segment or at least not crossed. *)
Record weakly_generic_for t p q : Prop := {
  w_p : forall i, In i I4 -> coord t i p <> 0;
  w_q : forall i, In i I4 -> coord t i q <> 0;
  w_e : forall i, In i I4 -> generic_edge (facet t i) p q \/ 0 < coord t i p * coord t i q }.
Lemma generic_weakly t p q : generic_for t p q -> weakly_generic_for t p q.
Proof. intros [A B C]. split; auto. Qed.

Lemma okF_prs t p q : 0 < vol t -> weakly_generic_for t p q -> okF (prs t p q).
Proof.
  intros V [Gp Gq Ge]. split.
  - intros x Hx. unfold prs in Hx. apply in_map_iff in Hx as [i [<- Hi]]. simpl; auto.
  - assert (NZ : forall i, In i I4 -> changes (coord t i p, coord t i q) -> mm t p q i (jx i 1) <> 0 /\ mm t p q i (jx i 2) <> 0 /\ mm t p q i (jx i 3) <> 0).
    { intros i Hi C. destruct (Ge i Hi) as [G|G]; [|unfold changes in C; simpl in C; lra].
      destruct (m_id t p q i Hi) as [-> [-> ->]]. destruct G as [A [B C']].
      repeat split; apply Rmult_integral_contrapositive_currified; lra. }
    assert (H0 := NZ 0%nat ltac:(simpl; auto)). assert (H1 := NZ 1%nat ltac:(simpl; auto)).
    assert (H2 := NZ 2%nat ltac:(simpl; auto)). assert (H3 := NZ 3%nat ltac:(simpl; auto)). cbn [jx] in *. unfold mm in *.
    assert (AN : forall x y, m x y <> 0 -> m y x <> 0) by (intros x y; unfold m; lra).
    unfold prs, I4; cbn [map]. repeat constructor; unfold apart; intros [C|C];
    try (apply H0 in C); try (apply H1 in C); try (apply H2 in C); try (apply H3 in C);
    first [ tauto | apply AN; tauto ].
Qed.

Lemma forallb_prs (P : R * R -> bool) t p q :
  forallb P (prs t p q) = forallb (fun i => P (coord t i p, coord t i q)) I4.
Proof. reflexivity. Qed.

Lemma posb_mull v x : 0 < v -> posb (v * x) = posb x.
Proof. intros. apply posb_ext. split; intros; nra. Qed.
Lemma posb_neg_flip x : x <> 0 -> negb (posb (- x)) = posb x.
Proof. intros. apply beq_iff. bsimp. lra. Qed.

Lemma term_cr t p q i : In i I4 -> 0 < vol t -> weakly_generic_for t p q ->
  term (prs t p q) (coord t i p, coord t i q) = crossing (facet t i) p q.
Proof.
  intros Hi V [Gp Gq Ge]. destruct (m_id t p q i Hi) as [E1 [E2 E3]]. destruct (Ge i Hi) as [[A [B C]]|SAME].
  2:{ unfold term, crossing. unfold coord in SAME.
      replace (ent (prs t p q) (coord t i p, coord t i q)) with false by (symmetry; apply bfalse; rewrite ent_true; unfold coord; cbn [fst snd]; nra).
      replace (lea (prs t p q) (coord t i p, coord t i q)) with false by (symmetry; apply bfalse; rewrite lea_true; unfold coord; cbn [fst snd]; nra).
      replace (crp (facet t i) p q) with false by (symmetry; apply bfalse; rewrite crp_t; nra).
      replace (crm (facet t i) p q) with false by (symmetry; apply bfalse; rewrite crm_t; nra). reflexivity. }
  set (d1 := orient p q (t1 (facet t i)) (t2 (facet t i))) in *.
  set (d2 := orient p q (t2 (facet t i)) (t3 (facet t i))) in *.
  set (d3 := orient p q (t3 (facet t i)) (t1 (facet t i))) in *.
  assert (Q : forall j, In j I4 -> j = i \/ j = jx i 1 \/ j = jx i 2 \/ j = jx i 3).
  { intros j Hj. clear - Hi Hj. simpl in Hi, Hj.
    destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; destruct Hj as [<-|[<-|[<-|[<-|[]]]]]; cbn; auto. }
  assert (J : In (jx i 1) I4 /\ In (jx i 2) I4 /\ In (jx i 3) I4).
  { clear - Hi. simpl in Hi. destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; cbn; tauto. }
  assert (S : mm t p q i i = 0) by (unfold mm; apply m_self).
  unfold term, crossing. apply (f_equal2 Z.sub); apply (f_equal Z.b2z).
  - apply beq_iff. rewrite ent_true, crp_t. cbn [fst snd]. fold d1 d2 d3. unfold coord at 1 2. split.
    + intros [H1 [H2 H3]].
      assert (H4 : forall j, In j I4 -> 0 <= mm t p q i j).
      { intros j Hj. apply H3. unfold prs. apply in_map_iff. eauto. }
      destruct J as [J1 [J2 J3]].
      pose proof (H4 _ J1); pose proof (H4 _ J2); pose proof (H4 _ J3). repeat split; auto; nra.
    + intros [H1 [H2 [H3 [H4 H5]]]]. repeat split; auto. intros y Hy.
      unfold prs in Hy. apply in_map_iff in Hy as [j [<- Hj]].
      change (0 <= mm t p q i j). destruct (Q j Hj) as [->|[->|[->| ->]]]; nra.
  - apply beq_iff. rewrite lea_true, crm_t. cbn [fst snd]. fold d1 d2 d3. unfold coord at 1 2. split.
    + intros [H1 [H2 H3]].
      assert (H4 : forall j, In j I4 -> mm t p q i j <= 0).
      { intros j Hj. apply H3. unfold prs. apply in_map_iff. eauto. }
      destruct J as [J1 [J2 J3]].
      pose proof (H4 _ J1); pose proof (H4 _ J2); pose proof (H4 _ J3). repeat split; auto; nra.
    + intros [H1 [H2 [H3 [H4 H5]]]]. repeat split; auto. intros y Hy.
      unfold prs in Hy. apply in_map_iff in Hy as [j [<- Hj]].
      change (mm t p q i j <= 0). destruct (Q j Hj) as [->|[->|[->| ->]]]; nra.
Qed.

Theorem tet_crossing_weak t p q : 0 < vol t -> weakly_generic_for t p q ->
  (Z.b2z (insideb t q) - Z.b2z (insideb t p) = zsum (fun i => crossing (facet t i) p q) I4)%Z.
Proof.
  intros V G. pose proof (crossing_identity 4 (prs t p q) eq_refl (okF_prs t p q V G)) as H.
  unfold claim in H.
  change (Ib (prs t p q)) with (insideb t q) in H. change (Ia (prs t p q)) with (insideb t p) in H.
  rewrite H. unfold prs at 2. rewrite zsum_map. apply zsum_ext. intros i Hi. apply term_cr; auto.
Qed.

Theorem tet_crossing t p q : 0 < vol t -> generic_for t p q ->
  (Z.b2z (insideb t q) - Z.b2z (insideb t p) = zsum (fun i => crossing (facet t i) p q) I4)%Z.
Proof. intros V G. apply tet_crossing_weak; auto. apply generic_weakly; auto. Qed.

(* affine behaviour along segments *)
Lemma o_lerp f p q s : side f (lerp p q s) = side f p + s * (side f q - side f p).
Proof. unfold side. unf. ring. Qed.

(* a crossed facet meets the segment in a point of the closed tetrahedron *)
Lemma cr_meets t i p q : In i I4 -> 0 < vol t -> crossing (facet t i) p q <> 0%Z ->
  exists s, 0 < s < 1 /\ closed t (lerp p q s) /\ coord t i (lerp p q s) = 0.
Proof.
  intros Hi V H.
  set (a := coord t i p). set (b := coord t i q).
  destruct (m_id t p q i Hi) as [E1 [E2 E3]].
  set (d1 := orient p q (t1 (facet t i)) (t2 (facet t i))) in *.
  set (d2 := orient p q (t2 (facet t i)) (t3 (facet t i))) in *.
  set (d3 := orient p q (t3 (facet t i)) (t1 (facet t i))) in *.
  assert (C : (a < 0 /\ 0 < b /\ 0 < d1 /\ 0 < d2 /\ 0 < d3) \/ (0 < a /\ b < 0 /\ d1 < 0 /\ d2 < 0 /\ d3 < 0)).
  { unfold crossing in H. destruct (crp (facet t i) p q) eqn:P1.
    - left. apply crp_t in P1. auto.
    - destruct (crm (facet t i) p q) eqn:P2.
      + right. apply crm_t in P2. auto.
      + simpl in H. congruence. }
  assert (N : b - a <> 0) by lra.
  exists (- a / (b - a)).
  assert (S : 0 < - a / (b - a) < 1).
  { split.
    - destruct C as [C|C]; [apply Rdiv_lt_0_compat; lra|].
      replace (- a / (b - a)) with (a / (a - b)) by (field; lra). apply Rdiv_lt_0_compat; lra.
    - apply Rminus_gt. replace (1 - - a / (b - a)) with (b / (b - a)) by (field; lra).
      destruct C as [C|C]; [apply Rdiv_lt_0_compat; lra|].
      replace (b / (b - a)) with (- b / (a - b)) by (field; lra). apply Rdiv_lt_0_compat; lra. }
  split; [exact S|].
  assert (LL : forall j, coord t j (lerp p q (- a / (b - a))) = mm t p q i j / (b - a)).
  { intros j. unfold coord at 1. rewrite o_lerp. unfold mm, m. cbn [fst snd]. fold (coord t j p) (coord t j q) a b. field; auto. }
  assert (Q : forall j, In j I4 -> j = i \/ j = jx i 1 \/ j = jx i 2 \/ j = jx i 3).
  { intros j Hj. clear - Hi Hj. simpl in Hi, Hj.
    destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; destruct Hj as [<-|[<-|[<-|[<-|[]]]]]; cbn; auto. }
  assert (S0 : mm t p q i i = 0) by (unfold mm; apply m_self).
  split.
  - intros j Hj. rewrite LL.
    assert (P : mm t p q i j = 0 \/ (0 < b - a /\ 0 < mm t p q i j) \/ (b - a < 0 /\ mm t p q i j < 0)).
    { destruct (Q j Hj) as [->|[->|[->| ->]]]; [left; auto| right..];
        (destruct C as [C|C]; [left|right]; split; nra). }
    destruct P as [P|[P|P]].
    + rewrite P. unfold Rdiv. lra.
    + apply Rlt_le, Rdiv_lt_0_compat; tauto.
    + replace (mm t p q i j / (b - a)) with (- mm t p q i j / (a - b)) by (field; lra).
      apply Rlt_le, Rdiv_lt_0_compat; lra.
  - rewrite LL, S0. unfold Rdiv. lra.
Qed.

(* odd matching of oriented triangles *)
Definition opposite (f g : triangle) : Prop :=
  (t1 f = t2 g /\ t2 f = t1 g /\ t3 f = t3 g) \/
  (t1 f = t1 g /\ t2 f = t3 g /\ t3 f = t2 g) \/
  (t1 f = t3 g /\ t2 f = t2 g /\ t3 f = t1 g).

Lemma D_swap34 p q a b : orient p q a b = - orient p q b a.
Proof. unf. ring. Qed.

Lemma oddm_o f g x : opposite f g -> side f x = - side g x.
Proof. intros [[A [B C]]|[[A [B C]]|[A [B C]]]]; unfold side; rewrite A, B, C; unf; ring. Qed.

Lemma oddm_cr f g p q : opposite f g -> crossing f p q = (- crossing g p q)%Z.
Proof.
  intros H. pose proof (oddm_o f g p H) as Op. pose proof (oddm_o f g q H) as Oq.
  assert (X : crp f p q = crm g p q /\ crm f p q = crp g p q).
  { split; apply beq_iff; rewrite crp_t, crm_t; rewrite Op, Oq;
    rewrite (D_swap34 p q (t1 g) (t2 g)), (D_swap34 p q (t2 g) (t3 g)), (D_swap34 p q (t3 g) (t1 g));
    destruct H as [[A [B C]]|[[A [B C]]|[A [B C]]]]; rewrite A, B, C; intuition lra. }
  destruct X as [X Y]. unfold crossing. rewrite X, Y. lia.
Qed.

(* convex combinations *)
Definition combination3 f a b c := add (add (scale a (t1 f)) (scale b (t2 f))) (scale c (t3 f)).

Lemma L_comb4 t a b c d : a + b + c + d = 1 ->
  coord t 0 (combination t a b c d) = a * vol t /\ coord t 1 (combination t a b c d) = b * vol t /\
  coord t 2 (combination t a b c d) = c * vol t /\ coord t 3 (combination t a b c d) = d * vol t.
Proof.
  intros H. replace a with (1 - b - c - d) by lra. clear.
  unfold combination, coord, side, vol, facet; cbn [t1 t2 t3]. unf. repeat split; ring.
Qed.

Lemma bary t x : 0 < vol t -> let v := vol t in
  x = combination t (coord t 0 x / v) (coord t 1 x / v) (coord t 2 x / v) (coord t 3 x / v)
  /\ coord t 0 x / v + coord t 1 x / v + coord t 2 x / v + coord t 3 x / v = 1.
Proof.
  intros V v. assert (N : v <> 0) by (unfold v; lra). split.
  - pose proof (L_bary t x) as B. fold v in B.
    assert (E : x = scale (/ v) (scale v x)).
    { apply point_eq; unfold scale; cbn [px py pz]; field; auto. }
    rewrite B in E. rewrite E at 1. unfold combination, add, scale. apply point_eq; cbn [px py pz]; field; auto.
  - pose proof (L_sum t x) as S. fold v in S. unfold Rdiv. rewrite <- !Rmult_plus_distr_r, S. field; auto.
Qed.

(* v is a vertex of t (of f) with positive weight in a convex combination equal to x *)
Definition carT t x v := exists a b c d,
  0 <= a /\ 0 <= b /\ 0 <= c /\ 0 <= d /\ a + b + c + d = 1 /\ x = combination t a b c d /\
  ((v = va t /\ 0 < a) \/ (v = vb t /\ 0 < b) \/ (v = vc t /\ 0 < c) \/ (v = vd t /\ 0 < d)).
Definition carF f x v := exists a b c,
  0 <= a /\ 0 <= b /\ 0 <= c /\ a + b + c = 1 /\ x = combination3 f a b c /\
  ((v = t1 f /\ 0 < a) \/ (v = t2 f /\ 0 < b) \/ (v = t3 f /\ 0 < c)).

Lemma carF_odd f g x v : opposite f g -> carF f x v -> carF g x v.
Proof.
  intros H [a [b [c [A [B [C [S [E V]]]]]]]]. unfold carF.
  destruct H as [[X [Y Z]]|[[X [Y Z]]|[X [Y Z]]]]; rewrite X, Y, Z in V;
   [exists b, a, c | exists a, c, b | exists c, b, a]; repeat split; try lra; try tauto;
   rewrite E; unfold combination3; rewrite X, Y, Z; apply point_eq; unf; ring.
Qed.

Lemma carF_carT t i x v : In i I4 -> carF (facet t i) x v -> carT t x v.
Proof.
  intros Hi [a [b [c [A [B [C [S [E V]]]]]]]]. simpl in Hi.
  destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; cbn [facet t1 t2 t3] in *; unfold carT;
  [ exists 0, a, c, b | exists a, 0, b, c | exists a, c, 0, b | exists a, b, c, 0 ];
  repeat split; try lra; try tauto;
  rewrite E; unfold combination3, combination; cbn [facet t1 t2 t3]; apply point_eq; unf; ring.
Qed.

Lemma carT_carF t i x v : In i I4 -> 0 < vol t -> coord t i x = 0 -> carT t x v -> carF (facet t i) x v.
Proof.
  intros Hi V Z [a [b [c [d [A [B [C [Dd [S [E W]]]]]]]]]]. simpl in Hi.
  destruct (L_comb4 t a b c d S) as [K0 [K1 [K2 K3]]]. rewrite <- E in *.
  destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; unfold carF; cbn [facet t1 t2 t3];
  [ assert (a = 0) by nra; subst a; exists b, d, c
  | assert (b = 0) by nra; subst b; exists a, c, d
  | assert (c = 0) by nra; subst c; exists a, d, b
  | assert (d = 0) by nra; subst d; exists a, b, c ];
  (repeat split; try lra; [rewrite E; unfold combination3, combination; cbn [t1 t2 t3]; apply point_eq; unf; ring |
   destruct W as [W|[W|[W|W]]]; (tauto || lra)]).
Qed.

(* decidable form *)
Definition ptb (a b : point) : bool :=
  (if Req_EM_T (px a) (px b) then true else false) && (if Req_EM_T (py a) (py b) then true else false)
  && (if Req_EM_T (pz a) (pz b) then true else false).
Lemma ptb_t a b : ptb a b = true <-> a = b.
Proof.
  unfold ptb. destruct (Req_EM_T (px a) (px b)), (Req_EM_T (py a) (py b)), (Req_EM_T (pz a) (pz b)); simpl;
  split; intros H; try discriminate; auto; try (subst; congruence). apply point_eq; auto.
Qed.
Definition closedb t x := forallb (fun i => negb (posb (- coord t i x))) I4.
Lemma closedb_t t x : closedb t x = true <-> closed t x.
Proof. unfold closedb, closed. rewrite forallb_forall. split; intros H i Hi; specialize (H i Hi); bsimp; lra. Qed.
Definition carb t x v := closedb t x && existsb (fun i => ptb v (vx t i) && posb (coord t i x)) I4.
Lemma carb_t t x v : 0 < vol t -> (carb t x v = true <-> carT t x v).
Proof.
  intros V. unfold carb. rewrite andb_true_iff, closedb_t, existsb_exists. split.
  - intros [C [i [Hi H]]]. apply andb_true_iff in H as [H1 H2]. apply ptb_t in H1. apply posb_t in H2.
    destruct (bary t x V) as [E S].
    assert (P : forall j, In j I4 -> 0 <= coord t j x / vol t).
    { intros j Hj. specialize (C j Hj). apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat; auto. }
    assert (P' : 0 < coord t i x / vol t) by (apply Rdiv_lt_0_compat; auto).
    exists (coord t 0 x / vol t), (coord t 1 x / vol t), (coord t 2 x / vol t), (coord t 3 x / vol t).
    repeat split; try (apply P; simpl; tauto); auto.
    simpl in Hi. destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; cbn [vx] in *; tauto.
  - intros [a [b [c [d [A [B [C [Dd [S [E W]]]]]]]]]].
    destruct (L_comb4 t a b c d S) as [K0 [K1 [K2 K3]]]. rewrite <- E in *. split.
    + intros i Hi. simpl in Hi. destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; nra.
    + destruct W as [[W P]|[[W P]|[[W P]|[W P]]]];
      [exists 0%nat | exists 1%nat | exists 2%nat | exists 3%nat]; (split; [simpl; tauto|]);
      (apply andb_true_iff; split; [apply ptb_t; auto | apply posb_t; nra]).
Qed.

(* translation *)
Lemma vol_ttr u t : vol (translate u t) = vol t.
Proof. unfold vol, translate; cbn. unf. ring. Qed.
