(** * Facets of tetrahedra as triangles; separated triangles; crossings of a segment

    For Region.v: no lattice and no tiling is here. *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology.
Import ListNotations.
Open Scope R_scope.

(** ** Triangles *)
Definition corners (f : triangle) := [t1 f; t2 f; t3 f].
Definition on (f : triangle) (x : point) := exists a b c, 0 <= a /\ 0 <= b /\ 0 <= c /\ a + b + c = 1 /\ x = combination3 f a b c.
Definition inner (f : triangle) (x : point) := exists a b c, 0 < a /\ 0 < b /\ 0 < c /\ a + b + c = 1 /\ x = combination3 f a b c.
Definition middle (f : triangle) := combination3 f (/3) (/3) (/3).
(** w is at most 0 on f and at least 0 on g; zero, of the corners, at common ones only; not
    zero on all of f, nor on all of g. *)
Definition separates (w : point -> R) (f g : triangle) := affine w /\
  (forall v, In v (corners f) -> w v <= 0 /\ (w v = 0 -> In v (corners g))) /\ (exists v, In v (corners f) /\ w v < 0) /\
  (forall v, In v (corners g) -> 0 <= w v /\ (w v = 0 -> In v (corners f))) /\ (exists v, In v (corners g) /\ 0 < w v).

Lemma affine_combination3 w f a b c : affine w -> a + b + c = 1 -> w (combination3 f a b c) = a * w (t1 f) + b * w (t2 f) + c * w (t3 f).
Proof.
  intros [x [y [z [d H]]]] S. rewrite !H. unfold combination3; unf. replace d with ((a + b + c) * d) at 1 by (rewrite S; ring). ring.
Qed.
Lemma inner_on f x : inner f x -> on f x.
Proof. intros [a [b [c [A [B [C D]]]]]]. exists a, b, c. intuition lra. Qed.
Lemma middle_inner f : inner f (middle f).
Proof. exists (/3), (/3), (/3). repeat split; lra. Qed.

Lemma separates_inner w f g x : separates w f g -> inner f x -> w x < 0.
Proof.
  intros [A [F [[v [Hv Lv]] _]]] [a [b [c [A1 [B1 [C1 [S ->]]]]]]]. rewrite affine_combination3 by auto.
  destruct (F (t1 f)) as [F1 _]; [simpl; auto|]. destruct (F (t2 f)) as [F2 _]; [simpl; auto|]. destruct (F (t3 f)) as [F3 _]; [simpl; auto|].
  destruct Hv as [<-|[<-|[<-|[]]]]; nra.
Qed.
Lemma separates_on w f g x : separates w f g -> on g x -> 0 <= w x.
Proof.
  intros [A [_ [_ [G _]]]] [a [b [c [A1 [B1 [C1 [S ->]]]]]]]. rewrite affine_combination3 by auto.
  destruct (G (t1 g)) as [F1 _]; [simpl; auto|]. destruct (G (t2 g)) as [F2 _]; [simpl; auto|]. destruct (G (t3 g)) as [F3 _]; [simpl; auto|].
  pose proof (Rmult_le_pos _ _ A1 F1). pose proof (Rmult_le_pos _ _ B1 F2). pose proof (Rmult_le_pos _ _ C1 F3). lra.
Qed.
Lemma separates_sym w f g : separates w f g -> separates (fun x => - w x) g f.
Proof.
  intros [A [F [[v [Hv Lv]] [G [u [Hu Lu]]]]]]. split; [apply aff_opp; auto|]. split; [|split; [exists u; split; auto; lra|split; [|exists v; split; auto; lra]]].
  - intros y Hy. destruct (G y Hy). split; [lra|]. intros E. apply H0. lra.
  - intros y Hy. destruct (F y Hy). split; [lra|]. intros E. apply H0. lra.
Qed.

(** A corner of f with positive weight at a common point is a corner of g. *)
Lemma separates_carrier w f g x v : separates w f g -> on f x -> on g x -> carF f x v -> In v (corners g).
Proof.
  intros S _ Og [a [b [c [A1 [B1 [C1 [T [E V]]]]]]]]. pose proof (separates_on w f g x S Og) as P.
  destruct S as [A [F _]]. rewrite E, affine_combination3 in P by auto.
  destruct (F (t1 f)) as [F1 K1]; [simpl; auto|]. destruct (F (t2 f)) as [F2 K2]; [simpl; auto|]. destruct (F (t3 f)) as [F3 K3]; [simpl; auto|].
  assert (Q1 : a * w (t1 f) <= 0) by nra. assert (Q2 : b * w (t2 f) <= 0) by nra. assert (Q3 : c * w (t3 f) <= 0) by nra.
  destruct V as [[-> L]|[[-> L]|[-> L]]]; [apply K1 | apply K2 | apply K3]; nra.
Qed.

(** A point of f is a convex combination of the corners of positive weight; if they are corners of
    g, it has the same carrier in g. *)
Lemma on_carF f x : on f x -> exists v, carF f x v.
Proof.
  intros [a [b [c [A [B [C [S E]]]]]]]. unfold carF.
  destruct (Rlt_dec 0 a); [exists (t1 f); exists a, b, c; intuition lra|]. destruct (Rlt_dec 0 b); [exists (t2 f); exists a, b, c; intuition lra|].
  exists (t3 f); exists a, b, c; intuition lra.
Qed.
(** Weights of a corner of g in g. *)
Lemma corner_weights g v : In v (corners g) -> exists a b c, 0 <= a /\ 0 <= b /\ 0 <= c /\ a + b + c = 1 /\ v = combination3 g a b c /\
  ((v = t1 g /\ 0 < a) \/ (v = t2 g /\ 0 < b) \/ (v = t3 g /\ 0 < c)).
Proof.
  intros [<-|[<-|[<-|[]]]]; [exists 1, 0, 0 | exists 0, 1, 0 | exists 0, 0, 1]; (repeat split; try lra; [apply point_eq; unfold combination3; unf; ring | intuition lra]).
Qed.
Lemma carF_sub f g x v : carF f x v -> (forall u, carF f x u -> In u (corners g)) -> carF g x v.
Proof.
  intros [a [b [c [A [B [C [S [E V]]]]]]]] H.
  assert (W : forall s u, 0 <= s -> (0 < s -> In u (corners g)) -> exists a' b' c', 0 <= a' /\ 0 <= b' /\ 0 <= c' /\ a' + b' + c' = s /\
    scale s u = combination3 g a' b' c' /\ (0 < s -> (u = t1 g /\ 0 < a') \/ (u = t2 g /\ 0 < b') \/ (u = t3 g /\ 0 < c'))).
  { intros s u Hs Hu. destruct (Req_dec s 0) as [->|Ne].
    - exists 0, 0, 0. repeat split; try lra. apply point_eq; unfold combination3; unf; ring.
    - destruct (corner_weights g u) as [a' [b' [c' [A' [B' [C' [S' [E' V']]]]]]]]; [apply Hu; lra|].
      exists (s * a'), (s * b'), (s * c'). repeat split; try nra.
      + rewrite E' at 1. apply point_eq; unfold combination3; unf; ring.
      + intros Ps. destruct V' as [[Q P]|[[Q P]|[Q P]]]; pose proof (Rmult_lt_0_compat _ _ Ps P); auto. }
  destruct (W a (t1 f) A) as [a1 [b1 [c1 [A1 [B1 [C1 [S1 [E1 V1]]]]]]]]. { intros P. apply H. exists a, b, c. intuition. }
  destruct (W b (t2 f) B) as [a2 [b2 [c2 [A2 [B2 [C2 [S2 [E2 V2]]]]]]]]. { intros P. apply H. exists a, b, c. intuition. }
  destruct (W c (t3 f) C) as [a3 [b3 [c3 [A3 [B3 [C3 [S3 [E3 V3]]]]]]]]. { intros P. apply H. exists a, b, c. intuition. }
  exists (a1 + a2 + a3), (b1 + b2 + b3), (c1 + c2 + c3). repeat split; try lra.
  - rewrite E. unfold combination3 at 1. rewrite E1, E2, E3. apply point_eq; unfold combination3; unf; ring.
  - clear - A1 B1 C1 A2 B2 C2 A3 B3 C3 V V1 V2 V3.
    destruct V as [[-> P]|[[-> P]|[-> P]]]; [destruct (V1 P) as [[Q P']|[[Q P']|[Q P']]] | destruct (V2 P) as [[Q P']|[[Q P']|[Q P']]] | destruct (V3 P) as [[Q P']|[[Q P']|[Q P']]]];
    rewrite Q; [left|right; left|right; right|left|right; left|right; right|left|right; left|right; right]; (split; [auto|lra]).
Qed.

(** ** Facets of a tetrahedron *)
Lemma facet_on t i x : 0 < vol t -> In i I4 -> (on (facet t i) x <-> closed t x /\ coord t i x = 0).
Proof.
  intros V Hi. split.
  - intros [a [b [c [A [B [C [S ->]]]]]]].
    assert (K : exists a' b' c' d', 0 <= a' /\ 0 <= b' /\ 0 <= c' /\ 0 <= d' /\ a' + b' + c' + d' = 1 /\
       combination3 (facet t i) a b c = combination t a' b' c' d' /\ match i with 0 => a' | 1 => b' | 2 => c' | _ => d' end%nat = 0).
    { simpl in Hi. destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; cbn [facet];
      [ exists 0, a, c, b | exists a, 0, b, c | exists a, c, 0, b | exists a, b, c, 0 ]; repeat split; try lra;
      unfold combination3, combination; cbn [t1 t2 t3]; apply point_eq; unf; ring. }
    destruct K as [a' [b' [c' [d' [A' [B' [C' [D' [S' [-> Z]]]]]]]]]].
    destruct (L_comb4 t a' b' c' d' S') as [K0 [K1 [K2 K3]]]. split.
    + intros j Hj. simpl in Hj. destruct Hj as [<-|[<-|[<-|[<-|[]]]]]; nra.
    + simpl in Hi. destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; cbv beta iota in Z; rewrite ?K0, ?K1, ?K2, ?K3, Z; ring.
  - intros [C Z]. destruct (bary t x V) as [E S]. cbv zeta in *.
    assert (P : forall j, In j I4 -> 0 <= coord t j x / vol t).
    { intros j Hj. specialize (C j Hj). apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat; auto. }
    pose proof (P 0%nat ltac:(simpl; tauto)) as P0. pose proof (P 1%nat ltac:(simpl; tauto)) as P1.
    pose proof (P 2%nat ltac:(simpl; tauto)) as P2. pose proof (P 3%nat ltac:(simpl; tauto)) as P3. clear P.
    assert (Z' : coord t i x / vol t = 0) by (rewrite Z; unfold Rdiv; ring).
    set (a := coord t 0 x / vol t) in *. set (b := coord t 1 x / vol t) in *. set (c := coord t 2 x / vol t) in *. set (d := coord t 3 x / vol t) in *.
    simpl in Hi. destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; fold a b c d in Z';
    [exists b, d, c | exists a, c, d | exists a, d, b | exists a, b, c]; repeat split; auto; try lra;
    rewrite E; unfold combination3, combination; cbn [facet t1 t2 t3]; rewrite Z'; apply point_eq; unf; ring.
Qed.
Lemma facet_inner t i x : 0 < vol t -> In i I4 -> (inner (facet t i) x <-> coord t i x = 0 /\ forall j, In j I4 -> j <> i -> 0 < coord t j x).
Proof.
  intros V Hi. split.
  - intros [a [b [c [A [B [C [S ->]]]]]]].
    assert (K : exists a' b' c' d', a' + b' + c' + d' = 1 /\ (i <> 0%nat -> 0 < a') /\ (i <> 1%nat -> 0 < b') /\ (i <> 2%nat -> 0 < c') /\ (i <> 3%nat -> 0 < d') /\
       combination3 (facet t i) a b c = combination t a' b' c' d' /\ match i with 0 => a' | 1 => b' | 2 => c' | _ => d' end%nat = 0).
    { simpl in Hi. destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; cbn [facet];
      [ exists 0, a, c, b | exists a, 0, b, c | exists a, c, 0, b | exists a, b, c, 0 ]; repeat split; try lra; try lia; try (intros; lra);
      unfold combination3, combination; cbn [t1 t2 t3]; apply point_eq; unf; ring. }
    destruct K as [a' [b' [c' [d' [S' [A' [B' [C' [D' [-> Z]]]]]]]]]].
    destruct (L_comb4 t a' b' c' d' S') as [K0 [K1 [K2 K3]]]. split.
    + simpl in Hi. destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; cbv beta iota in Z; rewrite ?K0, ?K1, ?K2, ?K3, Z; ring.
    + intros j Hj Ne. simpl in Hj. destruct Hj as [<-|[<-|[<-|[<-|[]]]]]; rewrite ?K0, ?K1, ?K2, ?K3; apply Rmult_lt_0_compat; auto.
  - intros [Z C]. destruct (bary t x V) as [E S]. cbv zeta in *.
    assert (P : forall j, In j I4 -> j <> i -> 0 < coord t j x / vol t).
    { intros j Hj Ne. apply Rdiv_lt_0_compat; auto. }
    pose proof (P 0%nat ltac:(simpl; tauto)) as P0. pose proof (P 1%nat ltac:(simpl; tauto)) as P1.
    pose proof (P 2%nat ltac:(simpl; tauto)) as P2. pose proof (P 3%nat ltac:(simpl; tauto)) as P3. clear P.
    assert (Z' : coord t i x / vol t = 0) by (rewrite Z; unfold Rdiv; ring).
    set (a := coord t 0 x / vol t) in *. set (b := coord t 1 x / vol t) in *. set (c := coord t 2 x / vol t) in *. set (d := coord t 3 x / vol t) in *.
    simpl in Hi. destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; fold a b c d in Z';
    [exists b, d, c | exists a, c, d | exists a, d, b | exists a, b, c]; repeat split; auto; try lra; try (apply P0; lia); try (apply P1; lia); try (apply P2; lia); try (apply P3; lia);
    rewrite E; unfold combination3, combination; cbn [facet t1 t2 t3]; rewrite Z'; apply point_eq; unf; ring.
Qed.

(** ** Crossings, segments *)
(** A crossed facet meets the segment in its relative interior. *)
Lemma crossed_inner t i p q : In i I4 -> 0 < vol t -> crossing (facet t i) p q <> 0%Z ->
  exists s, 0 < s < 1 /\ inner (facet t i) (lerp p q s).
Proof.
  intros Hi V CR. destruct (cr_meets t i p q Hi V CR) as [s [Hs [C Z]]]. exists s. split; auto. apply facet_inner; auto. split; auto.
  intros j Hj Ne. destruct (Rle_lt_or_eq_dec _ _ (C j Hj)) as [|E]; auto. exfalso. symmetry in E.
  assert (M0 : mm t p q i j = 0).
  { unfold coord in E, Z. rewrite o_lerp in E, Z. unfold mm, m, coord; cbn [fst snd].
    set (a := side (facet t i) p) in *. set (b := side (facet t i) q) in *. set (aj := side (facet t j) p) in *. set (bj := side (facet t j) q) in *.
    assert (X : a = - (s * (b - a))) by lra. assert (Y : aj = - (s * (bj - aj))) by lra.
    replace (b * aj - a * bj) with ((b - a) * aj - a * (bj - aj)) by ring. rewrite X at 2. rewrite Y at 1. ring. }
  destruct (m_id t p q i Hi) as [E1 [E2 E3]].
  assert (D : orient p q (t1 (facet t i)) (t2 (facet t i)) <> 0 /\ orient p q (t2 (facet t i)) (t3 (facet t i)) <> 0 /\ orient p q (t3 (facet t i)) (t1 (facet t i)) <> 0).
  { unfold crossing in CR. destruct (crp (facet t i) p q) eqn:P1.
    - apply crp_t in P1. lra.
    - destruct (crm (facet t i) p q) eqn:P2; [apply crm_t in P2; lra|]. simpl in CR. congruence. }
  destruct D as [D1 [D2 D3]].
  assert (Q : j = jx i 1 \/ j = jx i 2 \/ j = jx i 3).
  { clear - Hi Hj Ne. simpl in Hi, Hj.
    destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; destruct Hj as [<-|[<-|[<-|[<-|[]]]]]; cbn; auto; congruence. }
  destruct Q as [->|[->| ->]]; [rewrite E1 in M0; apply Rmult_integral in M0 | rewrite E2 in M0; apply Rmult_integral in M0 | rewrite E3 in M0; apply Rmult_integral in M0]; lra.
Qed.

Lemma crossing_swap f p q : crossing f q p = (- crossing f p q)%Z.
Proof.
  assert (S : forall a b, orient q p a b = - orient p q a b) by (intros; unf; ring).
  assert (X : crp f q p = crm f p q /\ crm f q p = crp f p q).
  { split; apply beq_iff; rewrite crp_t, crm_t, !S; intuition lra. }
  destruct X as [X Y]. unfold crossing. rewrite X, Y. lia.
Qed.
Lemma generic_swap t p q : generic_for t p q -> generic_for t q p.
Proof.
  assert (S : forall a b, orient q p a b = - orient p q a b) by (intros; unf; ring).
  intros [A B C]. split; auto. intros i Hi. destruct (C i Hi) as [D [E F]]. unfold generic_edge. rewrite !S. repeat split; lra.
Qed.
Lemma orient_lerp p q s a b : orient p (lerp p q s) a b = s * orient p q a b.
Proof. unf. ring. Qed.
Lemma lerp_lerp p q s u : lerp p (lerp p q s) u = lerp p q (u * s).
Proof. apply point_eq; unf; ring. Qed.
Lemma lerp_swap p q s : lerp q p s = lerp p q (1 - s).
Proof. apply point_eq; unf; ring. Qed.
Lemma generic_part t p q s : 0 < s -> generic_for t p q -> (forall i, In i I4 -> coord t i (lerp p q s) <> 0) -> generic_for t p (lerp p q s).
Proof.
  intros Hs [A B C] D. split; auto. intros i Hi. destruct (C i Hi) as [E [F G]]. unfold generic_edge. rewrite !orient_lerp.
  repeat split; apply Rmult_integral_contrapositive_currified; auto; lra.
Qed.
Lemma crossing_part f p q s : 0 < s < 1 -> crossing f p (lerp p q s) <> 0%Z -> crossing f p q <> 0%Z.
Proof.
  intros Hs H. unfold crossing in *. pose proof (o_lerp f p q s) as OL.
  destruct (crp f p (lerp p q s)) eqn:P1.
  - apply crp_t in P1. rewrite !orient_lerp in P1. destruct P1 as [X1 [X2 [X3 [X4 X5]]]].
    replace (crp f p q) with true.
    2:{ symmetry. apply crp_t. repeat split; nra. }
    replace (crm f p q) with false; [simpl; lia|]. symmetry. apply bfalse. rewrite crm_t. lra.
  - destruct (crm f p (lerp p q s)) eqn:P2; [|simpl in H; congruence].
    apply crm_t in P2. rewrite !orient_lerp in P2. destruct P2 as [X1 [X2 [X3 [X4 X5]]]].
    replace (crm f p q) with true.
    2:{ symmetry. apply crm_t. repeat split; nra. }
    replace (crp f p q) with false; [simpl; lia|]. symmetry. apply bfalse. rewrite crp_t. lra.
Qed.

(** ** Finite lists *)
Lemma least {X} (f : X -> R) l : l <> [] -> exists x, In x l /\ forall y, In y l -> f x <= f y.
Proof.
  induction l as [|a l IH]; [congruence|]. intros _. destruct l as [|b l].
  - exists a. split; simpl; auto. intros y [<-|[]]. lra.
  - destruct IH as [x [Hx Lx]]; [congruence|]. destruct (Rle_dec (f a) (f x)).
    + exists a. split; [simpl; auto|]. intros y [<-|Hy]; [lra|]. specialize (Lx y Hy). lra.
    + exists x. split; [simpl; auto|]. intros y [<-|Hy]; [lra|auto].
Qed.
(** Just before b there is no member of the list. *)
Lemma just_before l : forall a b, a < b -> exists s, a < s < b /\ forall x, In x l -> x < b -> x < s.
Proof.
  induction l as [|y l IH]; intros a b H.
  - exists ((a + b) / 2). split; [lra|]. simpl; tauto.
  - destruct (Rlt_dec y b).
    + destruct (IH (Rmax a y) b) as [s [Hs L]]; [apply Rmax_lub_lt; auto|]. pose proof (Rmax_l a y). pose proof (Rmax_r a y).
      exists s. split; [lra|]. intros x [<-|Hx]; auto. lra.
    + destruct (IH a b H) as [s [Hs L]]. exists s. split; auto. intros x [<-|Hx]; auto. lra.
Qed.
Lemma lerp_close p q s e : 0 < e -> exists d, 0 < d /\ forall u, Rabs (u - s) < d -> near e (lerp p q s) (lerp p q u).
Proof.
  intros He. set (M := Rabs (px q - px p) + Rabs (py q - py p) + Rabs (pz q - pz p) + 1).
  pose proof (Rabs_pos (px q - px p)); pose proof (Rabs_pos (py q - py p)); pose proof (Rabs_pos (pz q - pz p)).
  assert (HM : 0 < M) by (unfold M; lra).
  exists (e / M). split; [apply Rdiv_lt_0_compat; auto|]. intros u Hu.
  assert (E : e / M * M = e) by (field; lra).
  assert (K : forall a b, Rabs (b - a) < M -> Rabs (a + u * (b - a) - (a + s * (b - a))) < e).
  { intros a b Hab. replace (a + u * (b - a) - (a + s * (b - a))) with ((u - s) * (b - a)) by ring. rewrite Rabs_mult.
    pose proof (Rabs_pos (u - s)). pose proof (Rabs_pos (b - a)). rewrite <- E. apply Rmult_le_0_lt_compat; auto. }
  unfold near, lerp, add, scale, sub; cbn [px py pz]. repeat split; apply K; unfold M; lra.
Qed.
