(** * docs/lower-bound.md, section 9: x of the sides of 555 triangles grows with their angles

    Here theta is any angle between 72 and 75 degrees.  The derivatives of section 9 appear as differences. *)
From Coq Require Import Reals Lra Psatz.
From LowerBound Require Import Calculus Corners Triangles.
Open Scope R_scope.

(** The cosine falls at most as fast as the sine of the end says, and at least as fast as that of the start. *)
Lemma cos_falls x y m : 0 <= x -> x <= y -> y <= m -> m <= PI / 2 -> cos x - cos y <= sin m * (y - x).
Proof.
  intros H1 H2 H3 H4.
  pose proof (grows (fun z => cos z) (fun z => - sin z * 1) (- sin m) x y H2 (fun z _ => slope_cos _ z 1 (slope_id z))) as G. cbv beta in G.
  enough (- sin m * (y - x) <= cos y - cos x) by lra. apply G. intros z Z. pose proof (sin_le z m ltac:(lra) ltac:(lra) H4). lra.
Qed.
Lemma cos_falls_at_least x y m : 0 <= m -> m <= x -> x <= y -> y <= PI / 2 -> sin m * (y - x) <= cos x - cos y.
Proof.
  intros H1 H2 H3 H4.
  pose proof (grows_at_most (fun z => cos z) (fun z => - sin z * 1) (- sin m) x y H3 (fun z _ => slope_cos _ z 1 (slope_id z))) as G. cbv beta in G.
  enough (cos y - cos x <= - sin m * (y - x)) by lra. apply G. intros z Z. pose proof (sin_le m z H1 ltac:(lra) ltac:(lra)). lra.
Qed.

(** The cosine of the side opposite A. *)
Definition side_cos (A B C : R) := (cos A + cos B * cos C) / (sin B * sin C).
Lemma side_cos_rule A B C l : 0 < sin B -> 0 < sin C -> side_rule A B C l -> cos l = side_cos A B C.
Proof. unfold side_rule, side_cos. intros H1 H2 ->. field. lra. Qed.

(** An angle between 72 and 75 degrees, by its cosine. *)
Lemma double_cos x : cos (2 * x) = 2 * cos x * cos x - 1.
Proof. rewrite cos_2a. pose proof (squares x). lra. Qed.
Lemma cos_a0 theta : cos (a0 theta) = 8 * cos theta ^ 4 - 8 * cos theta ^ 2 + 1.
Proof.
  unfold a0. rewrite cos_minus, cos_2PI, sin_2PI. replace (4 * theta) with (2 * (2 * theta)) by ring. rewrite !double_cos. ring.
Qed.
Lemma sin_a0 theta : sin (a0 theta) = 4 * cos theta * (1 - 2 * cos theta ^ 2) * sin theta.
Proof.
  unfold a0. rewrite sin_minus, cos_2PI, sin_2PI. replace (4 * theta) with (2 * (2 * theta)) by ring. rewrite sin_2a, !double_cos, sin_2a. ring.
Qed.
Lemma range_from theta : 0 < theta < PI / 2 -> 0.2589 < cos theta < 1 / 2 -> cos theta < cos (a0 theta) -> 2 * PI / 5 < theta < 5 * PI / 12.
Proof.
  intros A [C1 C2] C3. pose proof PI_RGT_0.
  assert (A1 : PI / 3 < theta).
  { apply Rnot_le_lt. intros L. pose proof (cos_le theta (PI / 3) ltac:(lra) L ltac:(lra)) as Q. rewrite cos_PI3 in Q. lra. }
  split; apply Rnot_le_lt; intros L.
  - pose proof (cos_le theta (a0 theta) ltac:(lra) ltac:(unfold a0; lra) ltac:(unfold a0; lra)). lra.
  - pose proof (cos_le (PI / 4 + PI / 6) theta ltac:(lra) ltac:(lra) ltac:(lra)) as Q.
    rewrite cos_plus, cos_PI4, sin_PI4, cos_PI6, sin_PI6 in Q. pose proof (sqrt_sqrt 2 ltac:(lra)) as S. pose proof (sqrt_lt_R0 2 ltac:(lra)) as S0.
    pose proof (sqrt_sqrt 3 ltac:(lra)) as S3. pose proof (sqrt_lt_R0 3 ltac:(lra)) as S4.
    assert (S1 : sqrt 2 < 1.41422) by nra. assert (S5 : 1.7 < sqrt 3 < 1.73206) by (split; nra).
    replace (1 / sqrt 2) with (sqrt 2 / 2) in Q by (apply Rmult_eq_reg_r with (sqrt 2); [field_simplify; lra|lra]).
    assert (sqrt 2 * (sqrt 3 - 1) <= 1.41422 * 0.73206) by (apply Rmult_le_compat; lra). lra.
Qed.

Section Sides.
Variable theta : R.
Hypothesis range : 2 * PI / 5 < theta < 5 * PI / 12.
Let c := cos theta.
Let s := sin theta.
Let a := a0 theta.
Definition mid (x : R) := a <= x <= theta.
(** x of the side opposite A. *)
Definition xs (A B C : R) := acos (s ^ 2 * side_cos A B C - c ^ 2).
Lemma xs_sym A B C : xs A B C = xs A C B.
Proof. unfold xs, side_cos. rewrite (Rmult_comm (sin C)), (Rmult_comm (cos C)). reflexivity. Qed.

Lemma numbers : 0 < c < 1 / 2 /\ 0 < s /\ s * s = 1 - c * c /\ 0 < sin a <= s /\ c <= cos a < 1 / 2 /\ sin a * sin a = 1 - cos a * cos a.
Proof.
  pose proof (between theta range) as [[B1 B2] [B3 B4]]. fold a in B1, B2, B3.
  pose proof (c_pos theta range) as C1. pose proof (c_below theta range) as C2. pose proof (s_pos theta range) as P.
  pose proof (squares theta) as S. pose proof (squares a) as S'. fold c in C1, C2, S. fold s in P, S.
  assert (cos a < 1 / 2) by (rewrite <- cos_PI3; apply cos_decreasing_1; lra).
  pose proof (sin_pos a ltac:(lra)). pose proof (sin_le a theta ltac:(lra) ltac:(lra) ltac:(lra)) as L1. pose proof (cos_le a theta ltac:(lra) ltac:(lra) ltac:(lra)) as L2. fold s in L1. fold c in L2.
  repeat split; lra.
Qed.
Lemma mid_trig x : mid x -> sin a <= sin x <= s /\ c <= cos x <= cos a /\ 0 < sin x.
Proof.
  intros [X Y]. pose proof (between theta range) as [[B1 B2] [B3 B4]]. fold a in B1, B2, B3. pose proof numbers.
  assert (sin a <= sin x) by (apply sin_le; lra). repeat split; try lra; first [apply sin_le; lra|apply cos_le; lra].
Qed.
Lemma mid_a : mid a.
Proof. pose proof (between theta range) as B. fold a in B. unfold mid. lra. Qed.

(** All angles are at most b. *)
Section Below.
Variable b : R.
Hypothesis mid_b : mid b.
Let k := cos b / (1 - cos b).
Definition upto (x : R) := a <= x <= b.
Lemma upto_mid x : upto x -> mid x.
Proof. unfold upto, mid in *. lra. Qed.
Lemma upto_trig x : upto x -> sin a <= sin x <= sin b /\ cos b <= cos x <= cos a /\ 0 < sin x.
Proof.
  intros [X Y]. pose proof (between theta range) as [[B1 B2] [B3 B4]]. fold a in B1, B2, B3. pose proof numbers. unfold mid in mid_b.
  assert (sin a <= sin x) by (apply sin_le; lra). repeat split; try lra; first [apply sin_le; lra|apply cos_le; lra].
Qed.
Lemma k_numbers : 0 < cos b < 1 /\ 0 < k /\ k * (1 - cos b * cos b) = cos b + cos b * cos b.
Proof.
  pose proof (mid_trig b mid_b). pose proof numbers. assert (0 < cos b < 1) by lra. split; [lra|]. split; [apply Rdiv_lt_0_compat; lra|].
  unfold k. field. lra.
Qed.
Lemma side_cos_range A B C : upto A -> upto B -> upto C -> k <= side_cos A B C <= cos a / (1 - cos a).
Proof.
  intros HA HB HC. destruct (upto_trig A HA) as [A1 [A2 A3]]. destruct (upto_trig B HB) as [B1 [B2 B3]]. destruct (upto_trig C HC) as [C1 [C2 C3]].
  pose proof k_numbers as [K1 [K2 K3]]. pose proof numbers as [N1 [N2 [N3 [N4 [N5 N6]]]]]. pose proof (squares b) as Sb. pose proof (mid_trig b mid_b) as [M1 [M2 M3]].
  assert (P : sin a * sin a <= sin B * sin C <= sin b * sin b) by (split; apply Rmult_le_compat; lra).
  assert (P0 : 0 < sin B * sin C) by (apply Rmult_lt_0_compat; lra).
  assert (Q : cos b * cos b <= cos B * cos C <= cos a * cos a) by (split; apply Rmult_le_compat; lra).
  unfold side_cos. split; apply Rmult_le_reg_r with (sin B * sin C); try lra;
  replace ((cos A + cos B * cos C) / (sin B * sin C) * (sin B * sin C)) with (cos A + cos B * cos C) by (field; lra).
  - apply Rle_trans with (k * (1 - cos b * cos b)); [apply Rmult_le_compat_l; lra|lra].
  - assert (E : cos a / (1 - cos a) * (1 - cos a * cos a) = cos a + cos a * cos a) by (field; lra).
    assert (0 < cos a / (1 - cos a)) by (apply Rdiv_lt_0_compat; lra).
    apply Rle_trans with (cos a / (1 - cos a) * (1 - cos a * cos a)); [lra|apply Rmult_le_compat_l; lra].
Qed.
Lemma xs_range A B C : upto A -> upto B -> upto C -> 0 <= xs A B C <= theta /\ cos (xs A B C) = s ^ 2 * side_cos A B C - c ^ 2.
Proof.
  intros HA HB HC. destruct (side_cos_range A B C HA HB HC) as [L U]. pose proof numbers as [N1 [N2 [N3 [N4 [N5 N6]]]]]. pose proof (mid_trig b mid_b) as [M1 [M2 M3]].
  assert (U' : side_cos A B C <= 1).
  { apply Rle_trans with (1 := U). apply Rmult_le_reg_r with (1 - cos a); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (L' : c / (1 - c) <= side_cos A B C).
  { apply Rle_trans with (2 := L). unfold k. apply Rmult_le_reg_r with ((1 - c) * (1 - cos b)); [apply Rmult_lt_0_compat; lra|].
    replace (c / (1 - c) * ((1 - c) * (1 - cos b))) with (c * (1 - cos b)) by (field; lra).
    replace (cos b / (1 - cos b) * ((1 - c) * (1 - cos b))) with (cos b * (1 - c)) by (field; lra). lra. }
  assert (S1 : s ^ 2 * side_cos A B C <= s ^ 2 * 1) by (apply Rmult_le_compat_l; nra).
  assert (S2 : s ^ 2 * (c / (1 - c)) <= s ^ 2 * side_cos A B C) by (apply Rmult_le_compat_l; nra).
  replace (s ^ 2 * (c / (1 - c))) with (c + c ^ 2) in S2 by (replace (s ^ 2) with (1 - c * c) by lra; field; lra).
  assert (E : cos (xs A B C) = s ^ 2 * side_cos A B C - c ^ 2) by (unfold xs; rewrite cos_acos; nra).
  split; [|exact E]. pose proof (acos_bound (s ^ 2 * side_cos A B C - c ^ 2)) as B0. fold (xs A B C) in B0. split; [lra|].
  pose proof (between theta range). pose proof PI_RGT_0. apply angle_le; [lra|lra|]. rewrite E. fold c. lra.
Qed.
Lemma xs_grows x y p q m : 0 <= x <= theta -> 0 <= y <= theta -> cos x = s ^ 2 * p - c ^ 2 -> cos y = s ^ 2 * q - c ^ 2 -> 0 <= m ->
  m <= p - q -> s * m <= y - x.
Proof.
  intros HX HY E1 E2 M L. pose proof numbers as [N1 [N2 [N3 _]]]. pose proof (between theta range). pose proof PI_RGT_0.
  assert (S : 0 < s ^ 2) by nra. assert (SL : s ^ 2 * m <= s ^ 2 * (p - q)) by (apply Rmult_le_compat_l; lra).
  assert (SM : 0 <= s ^ 2 * m) by (apply Rmult_le_pos; lra).
  assert (O : x <= y) by (apply angle_le; lra).
  pose proof (cos_falls x y theta ltac:(lra) O ltac:(lra) ltac:(lra)) as F. fold s in F.
  apply Rmult_le_reg_l with s; [lra|]. lra.
Qed.

(** By the own angle, at least D; by another angle, at least D k. *)
Let D := sin a / s.
Lemma D_pos : 0 < D.
Proof. pose proof numbers. apply Rdiv_lt_0_compat; lra. Qed.
Lemma own A A' B C : upto A -> upto A' -> upto B -> upto C -> A <= A' -> D * (A' - A) <= xs A' B C - xs A B C.
Proof.
  intros HA HA' HB HC L. destruct (xs_range A B C HA HB HC) as [R1 E1]. destruct (xs_range A' B C HA' HB HC) as [R2 E2].
  destruct (mid_trig B (upto_mid B HB)) as [B1 [_ B2]]. destruct (mid_trig C (upto_mid C HC)) as [C1 [_ C2]]. pose proof numbers as [N1 [N2 [N3 [N4 [N5 N6]]]]].
  assert (P : 0 < sin B * sin C <= s * s) by (split; [apply Rmult_lt_0_compat; lra|apply Rmult_le_compat; lra]).
  pose proof (between theta range) as BT. fold a in BT. unfold upto, mid in *.
  assert (F : sin a * (A' - A) <= cos A - cos A') by (apply cos_falls_at_least; lra).
  assert (F0 : 0 <= sin a * (A' - A)) by (apply Rmult_le_pos; lra). assert (SS : 0 < s * s) by nra.
  assert (M0 : 0 <= sin a * (A' - A) / (s * s)) by (apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]).
  pose proof (xs_grows (xs A B C) (xs A' B C) _ _ (sin a * (A' - A) / (s * s)) R1 R2 E1 E2 M0) as G.
  replace (D * (A' - A)) with (s * (sin a * (A' - A) / (s * s))) by (unfold D; field; lra). apply G.
  unfold side_cos. replace ((cos A + cos B * cos C) / (sin B * sin C) - (cos A' + cos B * cos C) / (sin B * sin C)) with ((cos A - cos A') / (sin B * sin C)) by (field; lra).
  apply Rmult_le_reg_r with (sin B * sin C); [lra|]. replace ((cos A - cos A') / (sin B * sin C) * (sin B * sin C)) with (cos A - cos A') by (field; lra).
  apply Rle_trans with (sin a * (A' - A) / (s * s) * (s * s)); [apply Rmult_le_compat_l; lra|].
  replace (sin a * (A' - A) / (s * s) * (s * s)) with (sin a * (A' - A)) by (field; lra). lra.
Qed.
Lemma other A B B' C : upto A -> upto B -> upto B' -> upto C -> B <= B' -> D * k * (B' - B) <= xs A B' C - xs A B C.
Proof.
  intros HA HB HB' HC L. destruct (xs_range A B C HA HB HC) as [R1 E1]. destruct (xs_range A B' C HA HB' HC) as [R2 E2].
  destruct (upto_trig A HA) as [A1 [A2 A3]]. destruct (upto_trig C HC) as [C1 [C2 C3]]. pose proof numbers as [N1 [N2 [N3 [N4 [N5 N6]]]]].
  pose proof (mid_trig A (upto_mid A HA)) as [A4 _]. pose proof (mid_trig C (upto_mid C HC)) as [C4 _]. pose proof (mid_trig b mid_b) as [M1 [M2 M3]].
  pose proof k_numbers as [K1 [K2 K3]]. pose proof (squares b) as Sb. assert (SS : 0 < s * s) by nra.
  (* the cosine of the side falls *)
  assert (F : sin a / (s * s) * k * (B' - B) <= side_cos A B C - side_cos A B' C).
  { set (f' := fun y => - ((cos C + cos A * cos y) / (sin y * sin y * sin C))).
    enough (side_cos A B' C - side_cos A B C <= - (sin a / (s * s) * k) * (B' - B)) by lra.
    apply (grows_at_most (fun y => side_cos A y C) f'); [exact L| |].
    - intros y Y. assert (HY : upto y) by (unfold upto in *; lra). destruct (upto_trig y HY) as [Y1 [Y2 Y3]]. eapply slope_eq.
      + unfold side_cos. apply slope_div.
        * apply slope_plus; [apply slope_const|]. apply slope_mult; [apply slope_cos, slope_id|apply slope_const].
        * apply slope_mult; [apply slope_sin, slope_id|apply slope_const].
        * apply Rmult_integral_contrapositive_currified; lra.
      + unfold f'. pose proof (squares y) as S.
        apply Rmult_eq_reg_r with (sin y * sin y * sin C); [|repeat apply Rmult_integral_contrapositive_currified; lra].
        replace (- ((cos C + cos A * cos y) / (sin y * sin y * sin C)) * (sin y * sin y * sin C)) with (- (cos C * (sin y * sin y + cos y * cos y) + cos A * cos y)) by (rewrite S; field; lra).
        field. lra.
    - intros y Y. assert (HY : upto y) by (unfold upto in *; lra). destruct (upto_trig y HY) as [Y1 [Y2 Y3]]. pose proof (mid_trig y (upto_mid y HY)) as [Y4 _]. unfold f'. apply Ropp_le_contravar.
      assert (P1 : 0 < sin y * sin C <= s * s) by (split; [apply Rmult_lt_0_compat; lra|apply Rmult_le_compat; lra]).
      assert (P2 : sin A * sin y <= sin b * sin b) by (apply Rmult_le_compat; lra).
      assert (P3 : cos b * cos b <= cos A * cos y) by (apply Rmult_le_compat; lra).
      (* k sin A sin y <= cos C + cos A cos y *)
      assert (U : k * (sin A * sin y) <= cos C + cos A * cos y) by (apply Rle_trans with (k * (1 - cos b * cos b)); [apply Rmult_le_compat_l; lra|lra]).
      apply Rmult_le_reg_r with (sin y * sin y * sin C); [repeat apply Rmult_lt_0_compat; lra|].
      replace ((cos C + cos A * cos y) / (sin y * sin y * sin C) * (sin y * sin y * sin C)) with (cos C + cos A * cos y) by (field; lra).
      apply Rle_trans with (k * (sin A * sin y)); [|exact U].
      replace (sin a / (s * s) * k * (sin y * sin y * sin C)) with (k * (sin a / (s * s) * (sin y * sin C) * sin y)) by ring.
      apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_r; [lra|].
      assert (0 < sin a / (s * s)) by (apply Rdiv_lt_0_compat; lra).
      apply Rle_trans with (sin a / (s * s) * (s * s)); [apply Rmult_le_compat_l; lra|].
      replace (sin a / (s * s) * (s * s)) with (sin a) by (field; lra). lra. }
  assert (N : 0 <= sin a / (s * s) * k * (B' - B)).
  { assert (0 < sin a / (s * s)) by (apply Rdiv_lt_0_compat; lra). apply Rmult_le_pos; [apply Rmult_le_pos|]; lra. }
  pose proof (xs_grows (xs A B C) (xs A B' C) _ _ _ R1 R2 E1 E2 N F) as G.
  replace (D * k * (B' - B)) with (s * (sin a / (s * s) * k * (B' - B))); [exact G|]. unfold D. field. lra.
Qed.
Lemma upto_a : upto a.
Proof. unfold upto, mid in *. lra. Qed.
(** All three together. *)
Lemma xs_above A B C : upto A -> upto B -> upto C -> xs a a a + D * (A - a) + D * k * ((B - a) + (C - a)) <= xs A B C.
Proof.
  intros HA HB HC. pose proof upto_a as H0.
  pose proof (own a A a a H0 HA H0 H0 ltac:(apply HA)) as L1.
  pose proof (other A a B a HA H0 HB H0 ltac:(apply HB)) as L2.
  pose proof (other A a C B HA H0 HC HB ltac:(apply HC)) as L3. rewrite (xs_sym A C B), (xs_sym A a B) in L3. lra.
Qed.
End Below.

(** ** utt', with u at A: first the angles at the t's fall to a0, then 3 f - K E grows. *)
Let D1 := sin a / s.
Let D2 := D1 * (c / (1 - c)).
Lemma mid_theta : mid theta.
Proof. pose proof (between theta range) as B. fold a in B. unfold mid. lra. Qed.
Definition half_cot (A : R) := cos (A / 2) / sin (A / 2).
Lemma f_side A : mid A -> side_cos a A a = cos a / sin a * half_cot A.
Proof.
  intros H. pose proof (between theta range) as [B1 [B2 B3]]. fold a in B1, B2. pose proof numbers as [N1 [N2 [N3 [N4 [N5 N6]]]]]. unfold side_cos, half_cot, mid in *.
  pose proof (sin_pos (A / 2) ltac:(lra)) as S. pose proof (cos_pos (A / 2) ltac:(lra)) as S1. pose proof (squares (A / 2)) as S2.
  replace (sin A) with (2 * sin (A / 2) * cos (A / 2)) by (rewrite <- sin_2a; f_equal; field).
  replace (cos A) with (1 - 2 * (sin (A / 2) * sin (A / 2))) by (replace (cos A) with (cos (2 * (A / 2))) by (f_equal; field); rewrite cos_2a_sin; ring).
  replace (cos a + (1 - 2 * (sin (A / 2) * sin (A / 2))) * cos a) with (2 * cos a * (cos (A / 2) * cos (A / 2))) by (replace (sin (A / 2) * sin (A / 2)) with (1 - cos (A / 2) * cos (A / 2)) by lra; ring).
  field. lra.
Qed.
(** The sine of f at A = theta comes from this cosine. *)
Lemma f_end : cos (xs a theta a) = s * (cos a / sin a) * (1 + c) - c ^ 2.
Proof.
  pose proof numbers as [N1 [N2 [N3 [N4 [N5 N6]]]]]. pose proof mid_theta as HT.
  destruct (xs_range theta HT a theta a (upto_a theta HT) ltac:(unfold upto, mid in *; lra) (upto_a theta HT)) as [_ E]. rewrite E.
  unfold side_cos. fold s c. replace (s ^ 2 * ((cos a + c * cos a) / (s * sin a))) with (s * (cos a / sin a) * (1 + c)) by (field; lra). reflexivity.
Qed.
Lemma f_above A eps : mid A -> 0 <= K theta + eps -> (K theta + eps) * (1 - c) * sin (xs a theta a) <= 3 * s ^ 2 * (cos a / sin a) ->
  3 * xs a a a + eps * (A - a) <= 3 * xs a A a - K theta * (A - a).
Proof.
  intros H K0 HK. pose proof (between theta range) as [[B0 B1] [B2 B3]]. fold a in B0, B1, B2. pose proof numbers as [N1 [N2 [N3 [N4 [N5 N6]]]]].
  pose proof mid_theta as HT. pose proof mid_a as H0.
  destruct (xs_range theta HT a theta a H0 HT H0) as [X1 _]. destruct (xs_range theta HT a A a H0 H H0) as [X2 E2]. destruct (xs_range theta HT a a a H0 H0 H0) as [X3 E3].
  set (F := xs a theta a) in *. pose proof D_pos as DP. pose proof (k_numbers theta HT) as [_ [KP _]].
  assert (DK : 0 <= sin a / s * (cos theta / (1 - cos theta))) by (apply Rmult_le_pos; lra).
  assert (O1 : xs a A a <= F) by (pose proof (other theta HT a A theta a H0 H HT H0 ltac:(apply H)) as L; fold F in L; pose proof (Rmult_le_pos _ (theta - A) DK ltac:(unfold mid in H; lra)); lra).
  assert (O2 : xs a a a <= xs a A a) by (pose proof (other theta HT a a A a H0 H0 H H0 ltac:(apply H)) as L; pose proof (Rmult_le_pos _ (A - a) DK ltac:(unfold mid in H; lra)); lra).
  pose proof (cos_falls (xs a a a) (xs a A a) F ltac:(lra) O2 O1 ltac:(lra)) as G. rewrite E2, E3, !f_side in G by assumption.
  (* cot (A/2) falls *)
  assert (H1 : sin (theta / 2) * sin (theta / 2) = (1 - c) / 2).
  { pose proof (cos_2a_sin (theta / 2)) as Q. replace (2 * (theta / 2)) with theta in Q by field. fold c in Q. lra. }
  assert (HC : / (1 - c) * (A - a) <= half_cot a - half_cot A).
  { enough (half_cot A - half_cot a <= - / (1 - c) * (A - a)) by lra.
    apply (grows_at_most half_cot (fun y => - (1 / 2) * / (sin (y / 2) * sin (y / 2)))); [apply H| |].
    - intros y Y. unfold mid in H. pose proof (sin_pos (y / 2) ltac:(lra)) as S. pose proof (squares (y / 2)) as S2. eapply slope_eq.
      + unfold half_cot. apply slope_div; [apply slope_cos, slope_div; [apply slope_id|apply slope_const|lra]|apply slope_sin, slope_div; [apply slope_id|apply slope_const|lra]|lra].
      + replace (- (1 / 2) * / (sin (y / 2) * sin (y / 2))) with (- (1 / 2) * (sin (y / 2) * sin (y / 2) + cos (y / 2) * cos (y / 2)) / (sin (y / 2) * sin (y / 2))) by (rewrite S2; field; lra). field. lra.
    - intros y Y. unfold mid in H. pose proof (sin_pos (y / 2) ltac:(lra)) as S. pose proof (sin_le (y / 2) (theta / 2) ltac:(lra) ltac:(lra) ltac:(lra)) as S3.
      assert (S4 : sin (y / 2) * sin (y / 2) <= (1 - c) / 2) by (rewrite <- H1; apply Rmult_le_compat; lra).
      assert (S5 : 0 < sin (y / 2) * sin (y / 2)) by (apply Rmult_lt_0_compat; lra).
      assert (/ ((1 - c) / 2) <= / (sin (y / 2) * sin (y / 2))) by (apply Rinv_le_contravar; lra).
      replace (/ (1 - c)) with (1 / 2 * / ((1 - c) / 2)) by (field; lra). lra. }
  set (e := A - a) in *. assert (e0 : 0 <= e) by (unfold e; unfold mid in H; lra).
  set (g := cos a / sin a) in *. assert (g0 : 0 < g) by (apply Rdiv_lt_0_compat; lra).
  set (x := xs a A a) in *. set (d := half_cot a - half_cot A) in *.
  assert (G1 : s ^ 2 * g * d <= sin F * (x - xs a a a)) by (unfold d; lra).
  assert (SG : 0 < s ^ 2 * g) by (apply Rmult_lt_0_compat; nra).
  assert (L1 : s ^ 2 * g * (/ (1 - c) * e) <= s ^ 2 * g * d) by (apply Rmult_le_compat_l; lra).
  destruct (Req_dec e 0) as [Z|Z]; [rewrite Z; lra|].
  assert (SF : 0 < sin F).
  { apply sin_pos. split; [|lra]. apply Rnot_le_lt. intros Y. assert (F = 0) by lra. assert (x - xs a a a = 0) by lra.
    assert (0 < s ^ 2 * g * (/ (1 - c) * e)) by (repeat apply Rmult_lt_0_compat; try lra; try nra; apply Rinv_0_lt_compat; lra). nra. }
  apply Rplus_le_reg_r with (K theta * e). apply Rmult_le_reg_l with (sin F); [lra|].
  assert (M : (K theta + eps) * (1 - c) * sin F * (/ (1 - c) * e) <= 3 * s ^ 2 * g * (/ (1 - c) * e)).
  { apply Rmult_le_compat_r; [|lra]. apply Rmult_le_pos; [left; apply Rinv_0_lt_compat; lra|lra]. }
  replace ((K theta + eps) * (1 - c) * sin F * (/ (1 - c) * e)) with (sin F * ((K theta + eps) * e)) in M by (field; lra). lra.
Qed.
Lemma utt_from_f A B C eps : mid A -> mid B -> mid C -> 0 <= K theta + eps -> (K theta + eps) * (1 - c) * sin (xs a theta a) <= 3 * s ^ 2 * (cos a / sin a) ->
  3 * xs a a a + eps * (A - a) + 3 / 2 * (D1 + D2) * ((B - a) + (C - a)) <= 3 / 2 * (xs B C A + xs C A B) - K theta * (A - a).
Proof.
  intros HA HB HC K0 HK. pose proof mid_a as H0. pose proof mid_theta as HT. pose proof (f_above A eps HA K0 HK) as L.
  pose proof (own theta HT a B a A H0 HB H0 HA ltac:(apply HB)) as L1. pose proof (other theta HT B a C A HB H0 HC HA ltac:(apply HC)) as L2.
  pose proof (own theta HT a C A a H0 HC HA H0 ltac:(apply HC)) as L3. pose proof (other theta HT C a B A HC H0 HB HA ltac:(apply HB)) as L4.
  rewrite (xs_sym a a A) in L1. rewrite (xs_sym C B A), (xs_sym C a A) in L4. fold c in L2, L4. fold D1 in L1, L2, L3, L4. fold D2 in L2, L4. lra.
Qed.
End Sides.
