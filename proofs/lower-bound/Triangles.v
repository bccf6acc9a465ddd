(** * docs/lower-bound.md, section 8: Lemmas 3, 4 and 5 on spherical triangles

    Angles and sides are in radians.  Here theta is any angle between 72 and 75 degrees. *)
From Coq Require Import Reals Lra Psatz.
From LowerBound Require Import Calculus Corners.
Open Scope R_scope.

(** ** Section 8: the definitions

    [a0] and [kappa] of section 2, x(l), and the part of the apex angle at a base vertex: with the
    angle g there and the side r to the apex, its cotangent is tan g cos r.  So y(r) / 2 is [part theta r]. *)
Definition a0 (theta : R) := 2 * PI - 4 * theta.
Definition kappa (theta : R) := 5 * theta - 2 * PI.
Definition apex (theta l : R) := acos (sin theta ^ 2 * cos l - cos theta ^ 2).
Definition part (g r : R) := acot (tan g * cos r).
Definition K (theta : R) := / sin (2 * theta).
Definition C (theta xmin : R) := (1 - cos theta) / 2 * tan theta * sin theta / (sin (a0 theta) * sin xmin).

(** ** Lemma 4, the sum, for any three acute angles *)
Theorem lemma_4_sum a g g' l r' r : spherical_triangle a g g' l r' r -> a < PI / 2 -> g < PI / 2 -> g' < PI / 2 ->
  a = part g r + part g' r'.
Proof.
  intros [[A1 A2] [G1 G2] [H1 H2] _ R1 R2 _ Rg Rh] A G H. unfold side_rule in Rg, Rh.
  pose proof (sin_pos a ltac:(lra)) as SA. pose proof (sin_pos g ltac:(lra)) as SG. pose proof (sin_pos g' ltac:(lra)) as SH.
  pose proof (cos_pos a ltac:(lra)) as CA. pose proof (cos_pos g ltac:(lra)) as CG. pose proof (cos_pos g' ltac:(lra)) as CH.
  unfold part. set (p := acot (tan g * cos r)).
  assert (CC : 0 < cos a * cos g) by (apply Rmult_lt_0_compat; lra). assert (SS : 0 < sin a * sin g) by (apply Rmult_lt_0_compat; lra).
  assert (Cr : 0 < cos r) by (apply Rmult_lt_reg_l with (sin a * sin g); [lra|]; rewrite Rmult_0_r, <- Rh; lra).
  assert (T : 0 < tan g) by (unfold tan; apply Rdiv_lt_0_compat; lra).
  pose proof (acot_range (tan g * cos r)) as P. pose proof (acot_acute (tan g * cos r) ltac:(nra)) as P'. fold p in P, P'.
  pose proof (cot_acot (tan g * cos r)) as E. fold p in E. unfold tan in E.
  assert (E1 : cos p * cos g = sin g * cos r * sin p) by (rewrite E; field; lra).
  pose proof (sin_pos p ltac:(lra)) as SP.
  assert (E2 : cos g' * sin p = cos g * sin (a - p)).
  { rewrite sin_minus. replace (cos g') with (sin a * sin g * cos r - cos a * cos g) by lra.
    replace ((sin a * sin g * cos r - cos a * cos g) * sin p) with (sin a * (sin g * cos r * sin p) - cos a * cos g * sin p) by ring.
    rewrite <- E1. ring. }
  assert (SQ : 0 < sin (a - p)) by (apply Rmult_lt_reg_l with (cos g); [lra|]; rewrite Rmult_0_r, <- E2; nra).
  assert (Q : 0 < a - p).
  { apply Rnot_le_lt. intros L. pose proof (sin_ge_0 (p - a) ltac:(lra) ltac:(lra)). replace (a - p) with (- (p - a)) in SQ by ring. rewrite sin_neg in SQ. lra. }
  enough (a - p = acot (tan g' * cos r')) by lra.
  rewrite <- (acot_cot (a - p)) by lra. f_equal. set (q := a - p) in *.
  assert (E3 : sin p = sin a * cos q - cos a * sin q) by (rewrite <- sin_minus; f_equal; unfold q; ring).
  assert (QS : 0 < sin q * (sin a * sin g')) by (repeat apply Rmult_lt_0_compat; lra).
  apply Rmult_eq_reg_r with (sin q * (sin a * sin g')); [|lra]. unfold tan.
  replace (cos q / sin q * (sin q * (sin a * sin g'))) with (cos q * (sin a * sin g')) by (field; lra).
  replace (sin g' / cos g' * cos r' * (sin q * (sin a * sin g'))) with (sin g' * sin q * (sin g' * sin a * cos r') / cos g') by (field; lra).
  rewrite <- Rg. 
  replace (sin g' * sin q * (cos g + cos g' * cos a) / cos g') with (sin g' * ((cos g * sin q) / cos g' + sin q * cos a)) by (field; lra).
  rewrite <- E2, E3. field. lra.
Qed.

Section Lemmas.
Variable theta : R.
Hypothesis range : 2 * PI / 5 < theta < 5 * PI / 12.
Let c := cos theta.
Let s := sin theta.

Lemma between : 0 < a0 theta < theta /\ PI / 3 < a0 theta /\ theta < PI / 2.
Proof. unfold a0. lra. Qed.
Lemma c_pos : 0 < c.
Proof. apply cos_pos. lra. Qed.
Lemma s_pos : 0 < s.
Proof. apply sin_pos. lra. Qed.
Lemma c_below : c < 1 / 2.
Proof. unfold c. rewrite <- cos_PI3. apply cos_decreasing_1; lra. Qed.
Lemma apex_range l : 0 <= apex theta l <= PI.
Proof. apply acos_bound. Qed.
Lemma cos_apex l : cos (apex theta l) = s * s * cos l - c * c.
Proof.
  unfold apex. fold s c. pose proof (squares theta) as S. fold s c in S. pose proof (COS_bound l).
  rewrite cos_acos; [ring|]. pose proof c_pos. pose proof s_pos. assert (0 < s * s) by nra. nra.
Qed.

(** An angle of a triangle whose angles are at most theta. *)
Definition small (x : R) := 0 < x <= theta.
Lemma small_trig x : small x -> 0 < sin x <= s /\ c <= cos x.
Proof.
  intros [X Y]. split; [split|].
  - apply sin_pos. lra.
  - apply sin_le; lra.
  - apply cos_le; lra.
Qed.

Lemma side_acute A B C' a : small A -> small B -> small C' -> side_rule A B C' a -> c / (1 - c) <= cos a.
Proof.
  intros a1 a2 a3 H. unfold side_rule in H. destruct (small_trig A a1) as [A1 A2]. destruct (small_trig B a2) as [B1 B2]. destruct (small_trig C' a3) as [C1 C2].
  pose proof c_pos. pose proof c_below. pose proof s_pos. pose proof (squares theta) as S. fold s c in S.
  assert (P : 0 < sin B * sin C' <= s * s) by (split; [apply Rmult_lt_0_compat; lra|apply Rmult_le_compat; lra]).
  assert (Q : c * c <= cos B * cos C') by (apply Rmult_le_compat; lra).
  assert (X : 0 < cos a) by nra.
  assert (Y : c + c * c <= s * s * cos a) by nra.
  apply Rmult_le_reg_r with ((1 - c) * (1 + c)); [nra|].
  replace (c / (1 - c) * ((1 - c) * (1 + c))) with (c + c * c) by (field; lra). nra.
Qed.
Lemma least_cosine : 0 < c / (1 - c).
Proof. apply Rdiv_lt_0_compat; [apply c_pos|pose proof c_below; lra]. Qed.

(** ** Lemma 3

    The first two sentences, for every theta. *)
Theorem lemma_3 a g g' l r r' : spherical_triangle a g g' l r r' -> a <= theta -> g <= theta -> g' <= theta -> apex theta l <= a.
Proof.
  intros [[A1 A2] [G1 G2] [H1 H2] _ _ _ R _ _] A G H.
  pose proof (side_acute a g g' l (conj A1 A) (conj G1 G) (conj H1 H) R) as L. pose proof least_cosine as L0.
  destruct (small_trig g (conj G1 G)) as [S1 S2]. destruct (small_trig g' (conj H1 H)) as [S3 S4]. pose proof c_pos.
  apply angle_le; [apply apex_range|lra|]. rewrite cos_apex. unfold side_rule in R.
  assert (sin g * sin g' <= s * s) by (apply Rmult_le_compat; lra).
  assert (c * c <= cos g * cos g') by (apply Rmult_le_compat; lra).
  assert (sin g * sin g' * cos l <= s * s * cos l) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma apex_at_most A B C' l : small A -> small B -> small C' -> side_rule A B C' l -> apex theta l <= theta.
Proof.
  intros H1 H2 H3 R. pose proof (side_acute A B C' l H1 H2 H3 R) as L. pose proof c_below. pose proof c_pos. pose proof s_pos.
  apply angle_le; [apply apex_range|lra|]. rewrite cos_apex. fold c.
  pose proof (squares theta) as S. fold s c in S.
  assert (E : s * s * (c / (1 - c)) = (1 + c) * c) by (replace (s * s) with ((1 - c) * (1 + c)) by lra; field; lra). 
  assert (s * s * (c / (1 - c)) <= s * s * cos l) by (apply Rmult_le_compat_l; nra). nra.
Qed.
Theorem lemma_3_at_most A B C' l m n : spherical_triangle A B C' l m n -> small A -> small B -> small C' -> apex theta l <= theta.
Proof. intros T H1 H2 H3. apply (apex_at_most A B C'); auto. apply T. Qed.

(** ** Lemma 4, the bounds *)
Lemma K_bound g : PI / 4 <= g <= theta -> / (2 * (sin g * cos g)) <= K theta.
Proof.
  intros G. unfold K. replace (2 * (sin g * cos g)) with (sin (2 * g)) by (rewrite sin_2a; ring).
  apply Rinv_le_contravar; [apply sin_pos; lra|].
  replace (2 * g) with (PI / 2 - (PI / 2 - 2 * g)) by ring. replace (2 * theta) with (PI / 2 - (PI / 2 - 2 * theta)) by ring.
  rewrite !sin_shift, <- (cos_neg (_ - _)), <- (cos_neg (PI / 2 - 2 * g)). apply cos_le; lra.
Qed.
Theorem lemma_4_bounds g r : PI / 4 <= g <= theta -> 0 < cos r ->
  part theta r <= part g r <= part theta r + K theta * (theta - g).
Proof.
  intros G Cr. unfold part, acot. set (k := cos r) in *. pose proof (COS_bound r) as K1. fold k in K1.
  set (f := fun y => atan (sin y / cos y * k)).
  set (f' := fun y => / (1 + (sin y / cos y * k) ^ 2) * (k / (cos y * cos y))).
  assert (D : forall y, g <= y <= theta -> slope f y (f' y)).
  { intros y Y. pose proof (cos_pos y ltac:(lra)). eapply slope_eq.
    - apply slope_atan. apply slope_mult; [|apply slope_const].
      apply slope_div; [apply slope_sin, slope_id|apply slope_cos, slope_id|lra].
    - unfold f'. f_equal. rewrite Rmult_0_r, Rplus_0_r, !Rmult_1_r.
      replace (cos y * cos y - - sin y * sin y) with 1 by (pose proof (squares y); lra). field. lra. }
  assert (B : forall y, g <= y <= theta -> 0 <= f' y <= K theta).
  { intros y Y. pose proof (cos_pos y ltac:(lra)) as Cy. pose proof (sin_pos y ltac:(lra)) as Sy.
    assert (E : f' y = k / (cos y * cos y + sin y * sin y * (k * k))).
    { unfold f'. assert (0 < cos y * cos y) by nra. assert (0 <= sin y * sin y * (k * k)) by (apply Rmult_le_pos; nra).
      field. repeat split; nra. }
    assert (P : 0 < cos y * cos y) by nra. assert (P2 : 0 <= sin y * sin y * (k * k)) by (apply Rmult_le_pos; nra).
    rewrite E. split; [apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]|].
    eapply Rle_trans; [|apply (K_bound y); lra].
    assert (P3 : 0 < sin y * cos y) by nra.
    apply Rmult_le_reg_r with (2 * (sin y * cos y) * (cos y * cos y + sin y * sin y * (k * k))); [apply Rmult_lt_0_compat; lra|].
    replace (k / (cos y * cos y + sin y * sin y * (k * k)) * (2 * (sin y * cos y) * (cos y * cos y + sin y * sin y * (k * k)))) with (2 * (sin y * k) * cos y) by (field; lra).
    replace (/ (2 * (sin y * cos y)) * (2 * (sin y * cos y) * (cos y * cos y + sin y * sin y * (k * k)))) with (cos y * cos y + (sin y * k) * (sin y * k)) by (field; lra).
    pose proof (Rle_0_sqr (cos y - sin y * k)). unfold Rsqr in *. lra. }
  pose proof (grows f f' 0 g theta ltac:(lra) D (fun y Y => proj1 (B y Y))) as L1.
  pose proof (grows_at_most f f' (K theta) g theta ltac:(lra) D (fun y Y => proj2 (B y Y))) as L2.
  unfold f in L1, L2. unfold tan. lra.
Qed.

(** ** Lemma 5 *)

(** For a fixed base l: the triangle with the base angles p and q. *)
Section Base.
Variable l : R.
Hypothesis base : 0 < l < PI / 2.
Let apex_cos (p q : R) := sin p * sin q * cos l - cos p * cos q.
(** The cotangent of the side r from the vertex with the angle theta to the apex. *)
Let X (q : R) := (cos l * c + s * (cos q / sin q)) / sin l.
Let Zq (q : R) := s / c * cos (acot (X q)).
Let G (q : R) := acot (Zq q).

Lemma apex_sine q : 0 < q <= theta -> let a := acos (apex_cos theta q) in
  0 < sin a /\ cos a = apex_cos theta q /\ 0 <= a <= PI /\
  sin (acot (X q)) * sin a = sin q * sin l /\ cos (acot (X q)) * (s * sin a) = cos q + c * apex_cos theta q.
Proof.
  intros Q a. pose proof (sin_pos q ltac:(lra)) as Sq. pose proof (cos_pos q ltac:(lra)) as Cq.
  pose proof (sin_pos l ltac:(lra)) as Sl. pose proof (cos_pos l base) as Cl. pose proof c_pos. pose proof s_pos.
  pose proof (squares q) as Q2. pose proof (squares l) as L2. pose proof (squares theta) as T2. fold s c in T2.
  assert (E : 1 - apex_cos theta q * apex_cos theta q = sin l * sin q * (sin l * sin q) + (cos l * c * sin q + s * cos q) * (cos l * c * sin q + s * cos q)).
  { unfold apex_cos. fold s c.
    replace (sin l * sin q * (sin l * sin q)) with ((1 - cos l * cos l) * (1 - cos q * cos q)) by (rewrite <- L2 at 1; rewrite <- Q2 at 1; ring).
    replace ((cos l * c * sin q + s * cos q) * (cos l * c * sin q + s * cos q)) with (cos l * cos l * (c * c) * (sin q * sin q) + 2 * cos l * c * s * sin q * cos q + s * s * (cos q * cos q)) by ring.
    replace ((s * sin q * cos l - c * cos q) * (s * sin q * cos l - c * cos q)) with (s * s * (sin q * sin q) * (cos l * cos l) - 2 * cos l * c * s * sin q * cos q + c * c * (cos q * cos q)) by ring.
    replace (s * s) with (1 - c * c) by lra. replace (sin q * sin q) with (1 - cos q * cos q) by lra. ring. }
  assert (P : 0 < sin l * sin q) by nra.
  assert (N : 0 <= cos l * c * sin q + s * cos q) by (assert (0 < cos l * c) by nra; nra).
  assert (B : -1 <= apex_cos theta q <= 1) by (pose proof (square (sin l * sin q)); pose proof (square (cos l * c * sin q + s * cos q)); clear - E H1 H2; split; nra).
  assert (CA : cos a = apex_cos theta q) by (apply cos_acos; lra).
  pose proof (acos_bound (apex_cos theta q)) as AB. fold a in AB.
  assert (SA : sin a * sin a = 1 - apex_cos theta q * apex_cos theta q) by (rewrite <- CA; pose proof (squares a); lra).
  assert (SA0 : 0 < sin a) by (pose proof (sin_ge_0 a ltac:(lra) ltac:(lra)); nra).
  assert (Xq : X q * (sin l * sin q) = cos l * c * sin q + s * cos q) by (unfold X; field; lra).
  pose proof (sin_acot (X q)) as [SX SX2].
  assert (SR : sin (acot (X q)) * sin a = sin q * sin l).
  { apply Rsqr_inj; unfold Rsqr; [nra|nra|].
    replace (sin (acot (X q)) * sin a * (sin (acot (X q)) * sin a)) with (sin (acot (X q)) * sin (acot (X q)) * (sin a * sin a)) by ring.
    rewrite SA, E, <- Xq.
    replace (sin (acot (X q)) * sin (acot (X q)) * (sin l * sin q * (sin l * sin q) + X q * (sin l * sin q) * (X q * (sin l * sin q))))
      with (sin (acot (X q)) * sin (acot (X q)) * (1 + X q ^ 2) * (sin l * sin q * (sin l * sin q))) by ring.
    rewrite SX2. ring. }
  repeat split; auto; try lra.
  rewrite cot_acot. replace (X q * sin (acot (X q)) * (s * sin a)) with (s * (X q * (sin (acot (X q)) * sin a))) by ring.
  rewrite SR. replace (X q * (sin q * sin l)) with (cos l * c * sin q + s * cos q) by lra. unfold apex_cos. fold s c.
  replace (s * (cos l * c * sin q + s * cos q)) with (s * c * sin q * cos l + s * s * cos q) by ring.
  replace (s * s) with (1 - c * c) by lra. ring.
Qed.
(** tan theta cos r, from the apex angle. *)
Lemma Zq_is q : 0 < q <= theta -> Zq q * sin (acos (apex_cos theta q)) = cos q / c + apex_cos theta q.
Proof.
  intros Q. destruct (apex_sine q Q) as [A1 [A2 [A3 [A4 A5]]]]. pose proof c_pos. unfold Zq.
  replace (s / c * cos (acot (X q)) * sin (acos (apex_cos theta q))) with (cos (acot (X q)) * (s * sin (acos (apex_cos theta q))) / c) by (field; lra).
  rewrite A5. field. lra.
Qed.
Lemma G_at_theta : G theta = apex theta l / 2.
Proof.
  assert (Q : 0 < theta <= theta) by lra. pose proof (Zq_is theta Q) as E. destruct (apex_sine theta Q) as [A1 [A2 [A3 _]]].
  assert (A : acos (apex_cos theta theta) = apex theta l) by (unfold apex, apex_cos; f_equal; ring). rewrite A in *.
  set (x := apex theta l) in *. unfold G. fold c in E. rewrite <- A2 in E. pose proof c_pos.
  replace (c / c) with 1 in E by (field; lra).
  assert (X0 : x <> 0) by (intros Z; rewrite Z, sin_0 in A1; lra).
  assert (X1 : x <> PI) by (intros Z; rewrite Z, sin_PI in A1; lra).
  rewrite <- (acot_cot (x / 2)) by lra. f_equal.
  replace x with (2 * (x / 2)) in E by field. rewrite sin_2a, cos_2a in E.
  pose proof (sin_pos (x / 2) ltac:(lra)) as S. pose proof (cos_pos (x / 2) ltac:(lra)) as C1. pose proof (squares (x / 2)) as S2.
  assert (P : 0 < 2 * sin (x / 2) * cos (x / 2)) by (repeat apply Rmult_lt_0_compat; lra).
  apply Rmult_eq_reg_r with (2 * sin (x / 2) * cos (x / 2)); [|lra]. rewrite E.
  replace (cos (x / 2) / sin (x / 2) * (2 * sin (x / 2) * cos (x / 2))) with (2 * (cos (x / 2) * cos (x / 2))) by (field; lra). lra.
Qed.

(** The derivative of the part, as in the text. *)
Lemma G_slope q : 0 < q <= theta ->
  slope G q (/ (1 + Zq q ^ 2) * (s / c) * s * (sin (acot (X q)) * sin (acot (X q))) / (sin q * sin (acos (apex_cos theta q)))).
Proof.
  intros Q. destruct (apex_sine q Q) as [A1 [A2 [A3 [A4 A5]]]]. set (a := acos (apex_cos theta q)) in *.
  pose proof (sin_pos q ltac:(lra)) as Sq. pose proof (sin_pos l ltac:(lra)) as Sl. pose proof c_pos. pose proof s_pos.
  pose proof (sin_acot (X q)) as [SX SX2].
  pose proof (one_plus (X q)) as P. pose proof (one_plus (Zq q)) as PZ.
  eapply slope_eq.
  - unfold G. apply slope_acot. unfold Zq. apply slope_mult; [apply slope_const|]. apply slope_cos. apply slope_acot. unfold X.
    apply slope_div; [|apply slope_const|lra]. apply slope_plus; [apply slope_const|].
    apply slope_mult; [apply slope_const|]. apply slope_div; [apply slope_cos, slope_id|apply slope_sin, slope_id|lra].
  - fold (X q). fold (Zq q).
    assert (IX : / (1 + X q ^ 2) = sin (acot (X q)) * sin (acot (X q))) by (apply Rmult_eq_reg_r with (1 + X q ^ 2); [rewrite SX2; field|]; lra).
    rewrite IX. set (r := sin (acot (X q))) in *.
    replace (- sin q * 1 * sin q - cos q * 1 * cos q) with (- (1)) by (pose proof (squares q); lra).
    replace (r * r / (sin q * sin a)) with (r * r * r / (sin q * (r * sin a))) by (field; lra).
    replace (/ (1 + Zq q ^ 2) * (s / c) * s * (r * r) / (sin q * sin a)) with (/ (1 + Zq q ^ 2) * (s / c) * s * (r * r * r) / (sin q * (r * sin a))) by (field; lra).
    rewrite A4. field. lra.
Qed.
End Base.

Theorem lemma_5 a gu gt l rt ru xmin : spherical_triangle a gu gt l rt ru ->
  a <= theta -> a0 theta <= gu <= theta -> a0 theta <= gt <= theta -> 0 < xmin -> xmin <= apex theta l ->
  apex theta l / 2 - C theta xmin * (theta - gt) <= part gu ru.
Proof.
  intros T A Gu Gt X0 X1. pose proof between as [[B1 B2] [B3 B4]]. pose proof (lemma_3 _ _ _ _ _ _ T A (proj2 Gu) (proj2 Gt)) as L3.
  destruct T as [[a1 a2] [u1 u2] [t1 t2] [l1 l2] _ _ Ra Rt Ru].
  assert (Sa : small a) by (unfold small; lra). assert (Su : small gu) by (unfold small; lra). assert (St : small gt) by (unfold small; lra).
  pose proof (side_acute a gu gt l Sa Su St Ra) as L. pose proof least_cosine as L0.
  assert (base : 0 < l < PI / 2) by (split; [lra|apply acute_from; lra]).
  pose proof c_pos. pose proof s_pos. pose proof (cos_pos a ltac:(lra)) as Ca. pose proof (sin_pos a ltac:(lra)) as SAa.
  unfold side_rule in Ra, Ru.
  (* the apex angle at (theta, q) *)
  set (ac := fun q => sin theta * sin q * cos l - cos theta * cos q).
  assert (M : forall q, gt <= q <= theta -> cos a <= ac q <= s * s * cos l - c * c).
  { intros q Q. unfold ac. fold s c. destruct (small_trig q ltac:(unfold small; lra)) as [q1 q2].
    destruct (small_trig gu Su) as [u3 u4]. pose proof (sin_le gt q ltac:(lra) ltac:(lra) ltac:(lra)) as q3. pose proof (cos_le gt q ltac:(lra) ltac:(lra) ltac:(lra)) as q4.
    pose proof (sin_pos gt ltac:(lra)). pose proof (cos_pos gu ltac:(lra)). split.
    - assert (sin gu * sin gt <= s * sin q) by (apply Rmult_le_compat; lra).
      assert (c * cos q <= cos gu * cos gt) by (apply Rmult_le_compat; lra). nra.
    - assert (s * sin q <= s * s) by (apply Rmult_le_compat_l; lra). assert (c * c <= c * cos q) by (apply Rmult_le_compat_l; lra). nra. }
  assert (N : forall q, gt <= q <= theta -> let b := acos (ac q) in apex theta l <= b <= a /\ cos b = ac q /\ 0 < sin b).
  { intros q Q b. destruct (apex_sine l base q ltac:(lra)) as [E1 [E2 [E3 _]]]. change (0 < sin b) in E1. change (cos b = ac q) in E2. change (0 <= b <= PI) in E3.
    destruct (M q Q) as [M1 M2]. repeat split; auto.
    - apply angle_le; [apply apex_range|lra|]. rewrite cos_apex, E2. lra.
    - apply angle_le; [lra|lra|]. rewrite E2. lra. }
  set (Z := fun q => s / c * cos (acot ((cos l * c + s * (cos q / sin q)) / sin l))).
  assert (ZE : forall q, 0 < q <= theta -> Z q * sin (acos (ac q)) = cos q / c + ac q) by (intros q Q; exact (Zq_is l base q Q)).
  (* first the angle at u grows to theta *)
  assert (S1 : acot (Z gt) <= part gu ru).
  { unfold part. apply acot_decreasing. destruct (N gt ltac:(lra)) as [[N1 N2] [N3 N4]]. set (b := acos (ac gt)) in *.
    pose proof (ZE gt ltac:(lra)) as E. fold b in E. rewrite <- N3 in E.
    pose proof (cos_pos gu ltac:(lra)) as Cu. pose proof (cos_pos gt ltac:(lra)) as Ct. pose proof (sin_pos gu ltac:(lra)) as Sgu.
    assert (E' : tan gu * cos ru * sin a = cos gt / cos gu + cos a).
    { unfold tan. replace (sin gu / cos gu * cos ru * sin a) with (sin a * sin gu * cos ru / cos gu) by (field; lra). rewrite <- Ru. field. lra. }
    pose proof (cos_le b a ltac:(lra) N2 ltac:(lra)) as K1. pose proof (sin_le b a ltac:(lra) N2 ltac:(lra)) as K2.
    destruct (small_trig gu Su) as [_ K3].
    assert (K4 : cos gt / cos gu <= cos gt / c) by (apply Rmult_le_compat_l; [lra|]; apply Rinv_le_contravar; lra).
    assert (K5 : 0 < cos gt / cos gu) by (apply Rdiv_lt_0_compat; lra).
    apply Rmult_le_reg_r with (sin a); [lra|]. rewrite E'.
    apply Rle_trans with (Z gt * sin b); [lra|]. apply Rmult_le_compat_l; [|lra].
    apply Rmult_le_reg_r with (sin b); [lra|]. rewrite Rmult_0_l, E. lra. }
  (* then the angle at t *)
  set (f' := fun q => / (1 + Z q ^ 2) * (s / c) * s * (sin (acot ((cos l * c + s * (cos q / sin q)) / sin l)) * sin (acot ((cos l * c + s * (cos q / sin q)) / sin l))) / (sin q * sin (acos (ac q)))).
  assert (D : forall q, gt <= q <= theta -> slope (fun q => acot (Z q)) q (f' q)) by (intros q Q; exact (G_slope l base q ltac:(lra))).
  assert (E0 : acot (Z theta) = apex theta l / 2) by exact (G_at_theta l base).
  assert (F : forall q, gt <= q <= theta -> f' q <= C theta xmin).
  { intros q Q. destruct (N q Q) as [[N1 N2] [N3 N4]]. pose proof (ZE q ltac:(lra)) as E. unfold f'. set (b := acos (ac q)) in *. rewrite <- N3 in E.
    set (r := sin (acot ((cos l * c + s * (cos q / sin q)) / sin l))).
    assert (R2 : r * r <= 1) by (pose proof (squares (acot ((cos l * c + s * (cos q / sin q)) / sin l))) as W; fold r in W; pose proof (square (cos (acot ((cos l * c + s * (cos q / sin q)) / sin l)))); lra).
    pose proof (square r) as R0.
    destruct (small_trig q ltac:(unfold small; lra)) as [q1 q2].
    assert (K1 : 1 <= cos q / c) by (apply Rmult_le_reg_r with c; [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra).
    pose proof (cos_le b theta ltac:(lra) ltac:(lra) ltac:(lra)) as K2. pose proof (sin_le b theta ltac:(lra) ltac:(lra) ltac:(lra)) as K3. fold c in K2. fold s in K3.
    pose proof (squares theta) as S2. fold s c in S2. pose proof c_below.
    assert (Z1 : 1 + c <= Z q * s).
    { assert (0 < Z q) by (apply Rmult_lt_reg_r with (sin b); [lra|]; rewrite Rmult_0_l, E; lra).
      apply Rle_trans with (Z q * sin b); [lra|]. apply Rmult_le_compat_l; lra. }
    assert (Z2 : / (1 + Z q ^ 2) <= (1 - c) / 2).
    { assert (Y : (1 + c) * (1 + c) <= Z q * s * (Z q * s)) by (apply Rmult_le_compat; lra).
      pose proof (one_plus (Z q)). apply Rmult_le_reg_r with (1 + Z q ^ 2); [lra|]. rewrite Rinv_l by lra.
      assert (Y2 : (1 + c) * (1 + c) <= (Z q * Z q) * ((1 - c) * (1 + c))) by (replace ((1 - c) * (1 + c)) with (s * s) by lra; lra).
      assert (Y3 : 1 + c <= Z q * Z q * (1 - c)) by (apply Rmult_le_reg_r with (1 + c); lra). lra. }
    pose proof (sin_le (a0 theta) q ltac:(lra) ltac:(lra) ltac:(lra)) as K4. pose proof (sin_pos (a0 theta) ltac:(lra)) as K5.
    pose proof (sin_le xmin b ltac:(lra) ltac:(lra) ltac:(lra)) as K6. pose proof (sin_pos xmin ltac:(lra)) as K7.
    unfold C. change (sin theta) with s. change (cos theta) with c. replace (tan theta) with (s / c) by reflexivity.
    assert (K8 : / (sin q * sin b) <= / (sin (a0 theta) * sin xmin)) by (apply Rinv_le_contravar; [nra|]; apply Rmult_le_compat; lra).
    assert (K9 : 0 < / (sin q * sin b)) by (apply Rinv_0_lt_compat; nra).
    assert (V : 0 < s / c * s) by (apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat|]; lra).
    assert (U0 : 0 < / (1 + Z q ^ 2)) by (apply Rinv_0_lt_compat, one_plus).
    unfold Rdiv at 1. unfold Rdiv at 3. apply Rmult_le_compat; [|lra| |lra].
    - apply Rmult_le_pos; [|lra]. rewrite Rmult_assoc. apply Rmult_le_pos; lra.
    - rewrite (Rmult_assoc (/ _)), (Rmult_assoc ((1 - c) / 2)).
      replace (/ (1 + Z q ^ 2) * (s / c * s) * (r * r)) with ((/ (1 + Z q ^ 2) * (r * r)) * (s / c * s)) by ring.
      apply Rmult_le_compat_r; [lra|]. nra. }
  pose proof (grows_at_most (fun q => acot (Z q)) f' (C theta xmin) gt theta ltac:(lra) D F) as W. cbv beta in W. rewrite E0 in W. lra.
Qed.
End Lemmas.
