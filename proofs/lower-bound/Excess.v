(** * docs/lower-bound.md, section 9: Lemma 6, the 555 triangles; the third sentence of Lemma 3

    Here theta is theta* = arccos (sqrt 3 / 6).  All numbers lie in the field of sqrt 3 and sqrt 11. *)
From Coq Require Import Reals Lra Psatz.
From LowerBound Require Import Calculus Normals Corners Triangles.
Open Scope R_scope.

(** ** Section 2: numbers at theta* *)

Notation T := theta_star.
Lemma root11 : sqrt 11 * sqrt 11 = 11 /\ 3.3166 < sqrt 11 < 3.3167.
Proof. pose proof (sqrt_sqrt 11 ltac:(lra)). pose proof (sqrt_lt_R0 11 ltac:(lra)). repeat split; nra. Qed.
Lemma cT : cos T = sqrt 3 / 6.
Proof. exact cos_theta_star. Qed.
Lemma T_acute : 0 < T < PI / 2.
Proof.
  destruct theta_star_acute as [A B]. split; [|exact B]. destruct A as [A|A]; [exact A|]. pose proof cT as E. rewrite <- A, cos_0 in E. pose proof root3. lra.
Qed.
Lemma sT2 : sin T * sin T = 11 / 12.
Proof. pose proof (squares T) as S. rewrite cT in S. pose proof root3 as [R _]. lra. Qed.
Lemma sT0 : 0 < sin T.
Proof. apply sin_pos. pose proof T_acute. lra. Qed.
Lemma sT : sin T = sqrt 3 * sqrt 11 / 6.
Proof.
  pose proof root3 as [R3 [P3 _]]. pose proof root11 as [R11 [P11 _]]. pose proof sT2. pose proof sT0.
  apply Rsqr_inj; unfold Rsqr; [lra|nra|].
  replace (sqrt 3 * sqrt 11 / 6 * (sqrt 3 * sqrt 11 / 6)) with ((sqrt 3 * sqrt 3) * (sqrt 11 * sqrt 11) / 36) by field. rewrite R3, R11. lra.
Qed.
(** cos a0 = 7/18, sin a0 = 5 sqrt 11 / 18. *)
Lemma double_cos x : cos (2 * x) = 2 * cos x * cos x - 1.
Proof. rewrite cos_2a. pose proof (squares x). lra. Qed.
Lemma c2T : 2 * cos T * cos T - 1 = - (5 / 6).
Proof. rewrite cT. pose proof root3 as [R _]. lra. Qed.
Lemma ca0 : cos (a0 T) = 7 / 18.
Proof.
  unfold a0. rewrite cos_minus, cos_2PI, sin_2PI. replace (4 * T) with (2 * (2 * T)) by ring. rewrite !double_cos, c2T. lra.
Qed.
Lemma sin_2T : sin (2 * T) = sqrt 11 / 6.
Proof.
  rewrite sin_2a, sT, cT. pose proof root3 as [R _]. replace (2 * (sqrt 3 * sqrt 11 / 6) * (sqrt 3 / 6)) with (2 * (sqrt 3 * sqrt 3) * sqrt 11 / 36) by field.
  rewrite R. field.
Qed.
Lemma sa0 : sin (a0 T) = 5 * sqrt 11 / 18.
Proof.
  unfold a0. rewrite sin_minus, cos_2PI, sin_2PI, Rmult_0_l. replace (4 * T) with (2 * (2 * T)) by ring.
  rewrite sin_2a, double_cos, sin_2T, c2T. field.
Qed.
(** theta* is between 72 and 75 degrees: cos 2 theta* = -5/6, and the multiples of theta* are located by their cosines. *)
Lemma T_range : 2 * PI / 5 < T < 5 * PI / 12.
Proof.
  pose proof T_acute as [A B]. pose proof root3 as [R [R1 R2]].
  assert (C2 : cos (2 * T) = - (5 / 6)) by (rewrite double_cos, cT; lra).
  assert (C4 : cos (4 * T) = 7 / 18) by (replace (4 * T) with (2 * (2 * T)) by ring; rewrite double_cos, C2; lra).
  (* 60 < T, as cos T < 1/2 *)
  assert (A1 : PI / 3 < T).
  { apply Rnot_le_lt. intros L. pose proof (cos_le T (PI / 3) ltac:(lra) L ltac:(lra)) as Q. rewrite cos_PI3, cT in Q. lra. }
  assert (S2 : 0 < sin (2 * T)) by (apply sin_pos; lra).
  (* T < 75, as cos 2T > cos 150 = - sqrt 3 / 2 *)
  assert (B1 : T < 5 * PI / 12).
  { apply Rnot_le_lt. intros L. pose proof (cos_le (PI - 2 * T) (PI / 6) ltac:(lra) ltac:(lra) ltac:(lra)) as Q.
    rewrite cos_PI6 in Q. rewrite cos_minus, cos_PI, sin_PI, C2 in Q. lra. }
  (* T > 72: in the interval 2 pi - 4T and T are acute, and cos (2 pi - 4T) = 7/18 > cos T *)
  split; [|lra]. apply Rnot_le_lt. intros L.
  pose proof (cos_le T (2 * PI - 4 * T) ltac:(lra) ltac:(lra) ltac:(lra)) as Q.
  rewrite cos_minus, cos_2PI, sin_2PI, C4, cT in Q. lra.
Qed.

(** Angles in [a0, theta*]. *)
Definition middle (x : R) := a0 T <= x <= T.
Lemma middle_small x : middle x -> small T x.
Proof. intros H. pose proof (between T T_range). unfold middle, small in *. lra. Qed.
Lemma middle_trig x : middle x -> 5 * sqrt 11 / 18 <= sin x <= sin T /\ sqrt 3 / 6 <= cos x <= 7 / 18.
Proof.
  intros H. pose proof (between T T_range) as [B1 [B2 B3]]. unfold middle in H. rewrite <- sa0, <- ca0, <- cT.
  repeat split; first [apply sin_le; lra|apply cos_le; lra].
Qed.

(** ** Lemma 3, the third sentence *)

Lemma acos_half : acos (1 / 2) = PI / 3.
Proof.
  rewrite <- cos_PI3. apply acos_cos. pose proof PI_RGT_0. lra.
Qed.
(** The cosine of the side opposite A, and x of this side. *)
Definition side_cos (A B C : R) := (cos A + cos B * cos C) / (sin B * sin C).
Lemma side_cos_rule A B C l : 0 < sin B -> 0 < sin C -> side_rule A B C l -> cos l = side_cos A B C.
Proof. unfold side_rule, side_cos. intros H1 H2 ->. field. lra. Qed.
Lemma side_cos_range A B C : middle A -> middle B -> middle C -> sqrt 3 / (6 - sqrt 3) <= side_cos A B C <= 7 / 11.
Proof.
  intros HA HB HC. destruct (middle_trig A HA) as [A1 A2]. destruct (middle_trig B HB) as [B1 B2]. destruct (middle_trig C HC) as [C1 C2].
  pose proof root3 as [R3 R3']. pose proof root11 as [R11 R11']. pose proof sT2.
  assert (P : 275 / 324 <= sin B * sin C <= 11 / 12).
  { split; [replace (275 / 324) with (5 * sqrt 11 / 18 * (5 * sqrt 11 / 18)) by lra|replace (11 / 12) with (sin T * sin T) by lra]; apply Rmult_le_compat; lra. }
  assert (Q : 1 / 12 <= cos B * cos C <= 49 / 324).
  { split; [replace (1 / 12) with (sqrt 3 / 6 * (sqrt 3 / 6)) by lra|replace (49 / 324) with (7 / 18 * (7 / 18)) by lra]; apply Rmult_le_compat; lra. }
  unfold side_cos. split.
  - apply Rmult_le_reg_r with (sin B * sin C); [lra|]. replace ((cos A + cos B * cos C) / (sin B * sin C) * (sin B * sin C)) with (cos A + cos B * cos C) by (field; split; intros Z; rewrite Z in P; lra).
    assert (E : sqrt 3 / (6 - sqrt 3) * (11 / 12) = sqrt 3 / 6 + 1 / 12).
    { apply Rmult_eq_reg_r with (6 - sqrt 3); [|lra]. replace (sqrt 3 / (6 - sqrt 3) * (11 / 12) * (6 - sqrt 3)) with (sqrt 3 * (11 / 12)) by (field; lra). lra. }
    assert (0 < sqrt 3 / (6 - sqrt 3)) by (apply Rdiv_lt_0_compat; lra).
    apply Rle_trans with (sqrt 3 / (6 - sqrt 3) * (11 / 12)); [apply Rmult_le_compat_l; lra|lra].
  - apply Rmult_le_reg_r with (sin B * sin C); [lra|]. replace ((cos A + cos B * cos C) / (sin B * sin C) * (sin B * sin C)) with (cos A + cos B * cos C) by (field; split; intros Z; rewrite Z in P; lra). lra.
Qed.
Definition X (A B C : R) := acos (11 / 12 * side_cos A B C - 1 / 12).
Lemma X_is A B C l : middle B -> middle C -> side_rule A B C l -> apex T l = X A B C.
Proof.
  intros HB HC R. destruct (middle_trig B HB) as [B1 _]. destruct (middle_trig C HC) as [C1 _]. pose proof root11. pose proof root3.
  unfold X, apex. rewrite <- (side_cos_rule A B C l) by (auto; lra). f_equal.
  replace (sin T ^ 2) with (11 / 12) by (pose proof sT2; lra). replace (cos T ^ 2) with (1 / 12) by (rewrite cT; lra). ring.
Qed.
Lemma X_range A B C : middle A -> middle B -> middle C -> PI / 3 <= X A B C <= T /\ cos (X A B C) = 11 / 12 * side_cos A B C - 1 / 12.
Proof.
  intros HA HB HC. destruct (side_cos_range A B C HA HB HC) as [L U]. pose proof root3 as [R3 R3']. pose proof T_range. pose proof PI_RGT_0.
  assert (0 < sqrt 3 / (6 - sqrt 3)) by (apply Rdiv_lt_0_compat; lra).
  assert (E : cos (X A B C) = 11 / 12 * side_cos A B C - 1 / 12) by (unfold X; rewrite cos_acos; lra).
  split; [|exact E]. pose proof (acos_bound (11 / 12 * side_cos A B C - 1 / 12)) as B0. fold (X A B C) in B0. split.
  - apply angle_le; [lra|lra|]. rewrite cos_PI3, E. lra.
  - apply angle_le; [lra|lra|]. rewrite E, cT.
    assert (F : sqrt 3 / (6 - sqrt 3) * (11 / 12) = sqrt 3 / 6 + 1 / 12).
    { apply Rmult_eq_reg_r with (6 - sqrt 3); [|lra]. replace (sqrt 3 / (6 - sqrt 3) * (11 / 12) * (6 - sqrt 3)) with (sqrt 3 * (11 / 12)) by (field; lra). lra. }
    lra.
Qed.
Lemma X_start : X (a0 T) (a0 T) (a0 T) = PI / 3.
Proof.
  unfold X. rewrite <- acos_half. f_equal. unfold side_cos. rewrite ca0, sa0. pose proof root11 as [R _].
  replace (5 * sqrt 11 / 18 * (5 * sqrt 11 / 18)) with (25 * (sqrt 11 * sqrt 11) / 324) by field. rewrite R. lra.
Qed.
Lemma X_sym A B C : X A B C = X A C B.
Proof. unfold X, side_cos. rewrite (Rmult_comm (sin C)), (Rmult_comm (cos C)). reflexivity. Qed.

(** ** Section 9: the derivatives, as differences *)

Definition D1 := 5 * sqrt 3 / 9.
Definition D2 := D1 * (sqrt 3 / (6 - sqrt 3)).
Lemma D_numbers : 0.962 < D1 /\ 0.390 < D2.
Proof.
  pose proof root3 as [R3 R3']. unfold D2, D1. split; [lra|].
  apply Rmult_lt_reg_r with (6 - sqrt 3); [lra|].
  replace (5 * sqrt 3 / 9 * (sqrt 3 / (6 - sqrt 3)) * (6 - sqrt 3)) with (5 * (sqrt 3 * sqrt 3) / 9) by (field; lra). lra.
Qed.
(** The cosine falls at most as fast as the sine of the end says. *)
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
(** From a difference of cosines of sides to a difference of x. *)
Lemma X_grows x y p q m : 0 <= x <= T -> 0 <= y <= T -> cos x = 11 / 12 * p - 1 / 12 -> cos y = 11 / 12 * q - 1 / 12 -> 0 <= m ->
  m <= p - q -> sin T * m <= y - x.
Proof.
  intros HX HY E1 E2 M L. pose proof sT2. pose proof sT0. pose proof T_acute.
  assert (O : x <= y) by (apply angle_le; lra).
  pose proof (cos_falls x y T ltac:(lra) O ltac:(lra) ltac:(lra)) as F.
  apply Rmult_le_reg_l with (sin T); [lra|]. replace (sin T * (sin T * m)) with (11 / 12 * m) by (rewrite <- sT2; ring). lra.
Qed.

(** By the own angle, at least D1; by another angle, at least D2. *)
Lemma own A A' B C : middle A -> middle A' -> middle B -> middle C -> A <= A' -> D1 * (A' - A) <= X A' B C - X A B C.
Proof.
  intros HA HA' HB HC L. destruct (X_range A B C HA HB HC) as [R1 E1]. destruct (X_range A' B C HA' HB HC) as [R2 E2].
  destruct (middle_trig B HB) as [B1 _]. destruct (middle_trig C HC) as [C1 _]. pose proof root11 as [Q1 Q2]. pose proof root3 as [Q3 Q4]. pose proof PI_RGT_0.
  pose proof sT2. pose proof sT0.
  assert (P : 0 < sin B * sin C <= 11 / 12).
  { split; [apply Rmult_lt_0_compat; lra|]. replace (11 / 12) with (sin T * sin T) by lra. apply Rmult_le_compat; lra. }
  assert (F : sin (a0 T) * (A' - A) <= cos A - cos A').
  { pose proof (between T T_range). pose proof T_acute. unfold middle in *. apply cos_falls_at_least; lra. }
  rewrite sa0 in F.
  pose proof (X_grows (X A B C) (X A' B C) _ _ (5 * sqrt 11 / 18 * (A' - A) * (12 / 11)) ltac:(lra) ltac:(lra) E1 E2) as G.
  replace (D1 * (A' - A)) with (sin T * (5 * sqrt 11 / 18 * (A' - A) * (12 / 11))).
  - apply G; [assert (0 <= sqrt 11 * (A' - A)) by (apply Rmult_le_pos; lra); lra|].
    unfold side_cos. replace ((cos A + cos B * cos C) / (sin B * sin C) - (cos A' + cos B * cos C) / (sin B * sin C)) with ((cos A - cos A') / (sin B * sin C)) by (field; split; intros Z; rewrite Z in P; lra).
    apply Rmult_le_reg_r with (sin B * sin C); [lra|]. replace ((cos A - cos A') / (sin B * sin C) * (sin B * sin C)) with (cos A - cos A') by (field; split; intros Z; rewrite Z in P; lra).
    assert (N : 0 <= 5 * sqrt 11 / 18 * (A' - A) * (12 / 11)) by (assert (0 <= sqrt 11 * (A' - A)) by (apply Rmult_le_pos; lra); lra).
    apply Rle_trans with (5 * sqrt 11 / 18 * (A' - A) * (12 / 11) * (11 / 12)); [apply Rmult_le_compat_l; lra|lra].
  - unfold D1. rewrite sT. replace (sqrt 3 * sqrt 11 / 6 * (5 * sqrt 11 / 18 * (A' - A) * (12 / 11))) with (sqrt 3 * (sqrt 11 * sqrt 11) * (5 * (A' - A)) / 99) by field. rewrite Q1. field.
Qed.
Lemma other A B B' C : middle A -> middle B -> middle B' -> middle C -> B <= B' -> D2 * (B' - B) <= X A B' C - X A B C.
Proof.
  intros HA HB HB' HC L. destruct (X_range A B C HA HB HC) as [R1 E1]. destruct (X_range A B' C HA HB' HC) as [R2 E2].
  destruct (middle_trig A HA) as [A1 A2]. destruct (middle_trig C HC) as [C1 C2]. pose proof root11 as [Q1 Q2]. pose proof root3 as [Q3 Q4]. pose proof PI_RGT_0.
  pose proof sT2. pose proof sT0. pose proof T_acute.
  set (k := sqrt 3 / (6 - sqrt 3)). assert (K0 : 0 < k) by (apply Rdiv_lt_0_compat; lra).
  assert (KE : k * (11 / 12) = sqrt 3 / 6 + 1 / 12).
  { unfold k. apply Rmult_eq_reg_r with (6 - sqrt 3); [|lra]. replace (sqrt 3 / (6 - sqrt 3) * (11 / 12) * (6 - sqrt 3)) with (sqrt 3 * (11 / 12)) by (field; lra). lra. }
  (* the cosine of the side falls *)
  assert (F : 5 * sqrt 11 / 18 * k * (12 / 11) * (B' - B) <= side_cos A B C - side_cos A B' C).
  { set (f' := fun y => - ((cos C + cos A * cos y) / (sin y * sin y * sin C))).
    enough (side_cos A B' C - side_cos A B C <= - (5 * sqrt 11 / 18 * k * (12 / 11)) * (B' - B)) by lra.
    apply (grows_at_most (fun y => side_cos A y C) f'); [exact L| |].
    - intros y Y. assert (HY : middle y) by (unfold middle in *; lra). destruct (middle_trig y HY) as [Y1 Y2]. eapply slope_eq.
      + unfold side_cos. apply slope_div.
        * apply slope_plus; [apply slope_const|]. apply slope_mult; [apply slope_cos, slope_id|apply slope_const].
        * apply slope_mult; [apply slope_sin, slope_id|apply slope_const].
        * apply Rmult_integral_contrapositive_currified; lra.
      + unfold f'. pose proof (squares y) as S. pose proof (squares C) as S'.
        apply Rmult_eq_reg_r with (sin y * sin y * sin C); [|repeat apply Rmult_integral_contrapositive_currified; lra].
        replace (- ((cos C + cos A * cos y) / (sin y * sin y * sin C)) * (sin y * sin y * sin C)) with (- (cos C * (sin y * sin y + cos y * cos y) + cos A * cos y)) by (rewrite S; field; lra).
        field. lra.
    - intros y Y. assert (HY : middle y) by (unfold middle in *; lra). destruct (middle_trig y HY) as [Y1 Y2]. unfold f'. apply Ropp_le_contravar.
      assert (P1 : 0 < sin y * sin y <= 11 / 12) by (split; [apply Rmult_lt_0_compat; lra|replace (11 / 12) with (sin T * sin T) by lra; apply Rmult_le_compat; lra]).
      assert (P2 : 0 < sin y * sin C <= 11 / 12) by (split; [apply Rmult_lt_0_compat; lra|replace (11 / 12) with (sin T * sin T) by lra; apply Rmult_le_compat; lra]).
      assert (P4 : sin A * sin y <= 11 / 12) by (replace (11 / 12) with (sin T * sin T) by lra; apply Rmult_le_compat; lra).
      assert (P3 : 1 / 12 <= cos A * cos y) by (replace (1 / 12) with (sqrt 3 / 6 * (sqrt 3 / 6)) by lra; apply Rmult_le_compat; lra).
      (* k sin A sin y <= cos C + cos A cos y, and sin a0 (12/11) sin y sin C <= sin A *)
      assert (U : k * (sin A * sin y) <= cos C + cos A * cos y) by (apply Rle_trans with (k * (11 / 12)); [apply Rmult_le_compat_l; lra|lra]).
      apply Rmult_le_reg_r with (sin y * sin y * sin C); [repeat apply Rmult_lt_0_compat; lra|].
      replace ((cos C + cos A * cos y) / (sin y * sin y * sin C) * (sin y * sin y * sin C)) with (cos C + cos A * cos y) by (field; lra).
      apply Rle_trans with (k * (sin A * sin y)); [|exact U].
      replace (5 * sqrt 11 / 18 * k * (12 / 11) * (sin y * sin y * sin C)) with (k * (5 * sqrt 11 / 18 * (12 / 11 * (sin y * sin C)) * sin y)) by ring.
      apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_r; [lra|].
      apply Rle_trans with (5 * sqrt 11 / 18 * 1); [apply Rmult_le_compat_l; lra|lra]. }
  assert (N : 0 <= 5 * sqrt 11 / 18 * k * (12 / 11) * (B' - B)).
  { assert (0 <= sqrt 11 * k) by (apply Rmult_le_pos; lra). assert (0 <= sqrt 11 * k * (B' - B)) by (apply Rmult_le_pos; lra). lra. }
  pose proof (X_grows (X A B C) (X A B' C) _ _ _ ltac:(lra) ltac:(lra) E1 E2 N F) as G.
  replace (D2 * (B' - B)) with (sin T * (5 * sqrt 11 / 18 * k * (12 / 11) * (B' - B))); [exact G|].
  unfold D2, D1. fold k. rewrite sT. replace (sqrt 3 * sqrt 11 / 6 * (5 * sqrt 11 / 18 * k * (12 / 11) * (B' - B))) with (sqrt 3 * (sqrt 11 * sqrt 11) * (5 * k * (B' - B)) / 99) by field. rewrite Q1. field.
Qed.

(** All three together: x above 60 degrees. *)
Lemma X_above A B C : middle A -> middle B -> middle C ->
  PI / 3 + D1 * (A - a0 T) + D2 * ((B - a0 T) + (C - a0 T)) <= X A B C.
Proof.
  intros HA HB HC. pose proof (between T T_range) as [[_ H] _]. assert (H0 : middle (a0 T)) by (unfold middle; lra).
  pose proof (own (a0 T) A (a0 T) (a0 T) H0 HA H0 H0 ltac:(apply HA)) as L1.
  pose proof (other A (a0 T) B (a0 T) HA H0 HB H0 ltac:(apply HB)) as L2.
  pose proof (other A (a0 T) C B HA H0 HC HB ltac:(apply HC)) as L3. rewrite (X_sym A C B), (X_sym A (a0 T) B) in L3.
  rewrite X_start in L1. lra.
Qed.

(** Lemma 3: x(l) >= 60 degrees, with equality only if the three angles are all a0. *)
Theorem lemma_3_at_least A B C l m n : spherical_triangle A B C l m n -> middle A -> middle B -> middle C ->
  PI / 3 <= apex T l /\ (apex T l = PI / 3 -> A = a0 T /\ B = a0 T /\ C = a0 T).
Proof.
  intros H HA HB HC. rewrite (X_is A B C l) by (auto; apply H). pose proof (X_above A B C HA HB HC) as L. pose proof D_numbers.
  unfold middle in *. assert (0 <= D1 * (A - a0 T)) by (apply Rmult_le_pos; lra).
  assert (0 <= D2 * (B - a0 T)) by (apply Rmult_le_pos; lra). assert (0 <= D2 * (C - a0 T)) by (apply Rmult_le_pos; lra).
  split; [lra|]. intros E.
  assert (Z : forall d x, 0 < d -> d * x = 0 -> x = 0) by (intros d x D Z; apply Rmult_integral in Z; destruct Z; lra).
  pose proof (Z D1 (A - a0 T) ltac:(lra) ltac:(lra)). pose proof (Z D2 (B - a0 T) ltac:(lra) ltac:(lra)). pose proof (Z D2 (C - a0 T) ltac:(lra) ltac:(lra)). lra.
Qed.

(** ** Lemma 6 *)

Definition KT := K T.
Definition CT := C T (PI / 3).
Lemma KT_is : KT = 6 / sqrt 11 /\ 1.8090 < KT < 1.8091.
Proof.
  unfold KT, K. rewrite sin_2T. pose proof root11 as [R R']. assert (E : / (sqrt 11 / 6) = 6 / sqrt 11) by (field; lra). rewrite E. split; [reflexivity|].
  split; apply Rmult_lt_reg_r with (sqrt 11); try lra; replace (6 / sqrt 11 * sqrt 11) with 6 by (field; lra); lra.
Qed.
(** C < 1.416. *)
Lemma CT_below : 0 < CT < 1.416.
Proof.
  unfold CT, C, tan. rewrite sin_PI3, sa0, cT. pose proof root11 as [R R']. pose proof root3 as [R3 R3'].
  replace ((1 - sqrt 3 / 6) / 2 * (sin T / (sqrt 3 / 6)) * sin T / (5 * sqrt 11 / 18 * (sqrt 3 / 2)))
    with ((1 - sqrt 3 / 6) / 2 * (6 * (sin T * sin T)) / (5 * sqrt 11 / 36 * (sqrt 3 * sqrt 3))) by (field; lra).
  rewrite sT2, R3.
  assert (P : 0 < 5 * sqrt 11 / 36 * 3) by lra. split.
  - apply Rdiv_lt_0_compat; lra.
  - apply Rmult_lt_reg_r with (5 * sqrt 11 / 36 * 3); [lra|].
    replace ((1 - sqrt 3 / 6) / 2 * (6 * (11 / 12)) / (5 * sqrt 11 / 36 * 3) * (5 * sqrt 11 / 36 * 3)) with ((1 - sqrt 3 / 6) / 2 * (6 * (11 / 12))) by (field; lra). lra.
Qed.

(** uuu: with the excesses E = angle - a0. *)
Definition excess (A : R) := A - a0 T.
Lemma uuu_above A B C : middle A -> middle B -> middle C ->
  2 * PI + 1 * (excess A + excess B + excess C) <= 2 * (X A B C + X B C A + X C A B) - KT * (excess A + excess B + excess C).
Proof.
  intros HA HB HC. pose proof (X_above A B C HA HB HC). pose proof (X_above B C A HB HC HA). pose proof (X_above C A B HC HA HB).
  pose proof D_numbers. pose proof KT_is as [_ K']. unfold excess, middle in *.
  set (S := A - a0 T + (B - a0 T) + (C - a0 T)) in *. assert (S0 : 0 <= S) by (unfold S; lra).
  assert (0 <= (2 * (D1 + 2 * D2) - KT - 1) * S) by (apply Rmult_le_pos; lra). unfold S in *. lra.
Qed.

(** utt', with u at A: first the angles at the t's fall to a0, then 3 f - K E is above 180. *)
Definition half_cot (A : R) := cos (A / 2) / sin (A / 2).
Lemma f_side A : middle A -> side_cos (a0 T) A (a0 T) = 7 / (5 * sqrt 11) * half_cot A.
Proof.
  intros H. pose proof (between T T_range) as [B1 [B2 B3]]. pose proof root11 as [R R']. unfold side_cos, half_cot, middle in *. rewrite ca0, sa0.
  pose proof (sin_pos (A / 2) ltac:(lra)) as S. pose proof (cos_pos (A / 2) ltac:(lra)) as S1. pose proof (squares (A / 2)) as S2.
  replace (sin A) with (2 * sin (A / 2) * cos (A / 2)) by (rewrite <- sin_2a; f_equal; field).
  replace (cos A) with (2 * (cos (A / 2) * cos (A / 2)) - 1) by (rewrite <- (Rmult_assoc 2), <- double_cos; f_equal; field).
  field. lra.
Qed.
Lemma f_end : cos (X (a0 T) T (a0 T)) = (1 + 7 * sqrt 3) / 30.
Proof.
  pose proof (between T T_range) as [B1 [B2 B3]]. pose proof root11 as [R R']. pose proof root3 as [R3 R3'].
  assert (HT : middle T) by (unfold middle; lra). assert (H0 : middle (a0 T)) by (unfold middle; lra).
  destruct (X_range (a0 T) T (a0 T) H0 HT H0) as [_ E]. rewrite E. unfold side_cos. rewrite ca0, sa0, sT, cT.
  replace ((7 / 18 + sqrt 3 / 6 * (7 / 18)) / (sqrt 3 * sqrt 11 / 6 * (5 * sqrt 11 / 18)))
    with ((7 / 18 + sqrt 3 / 6 * (7 / 18)) * sqrt 3 / ((sqrt 3 * sqrt 3) * (sqrt 11 * sqrt 11) * 5 / 108)) by (field; lra).
  rewrite R, R3. replace ((7 / 18 + sqrt 3 / 6 * (7 / 18)) * sqrt 3) with (7 / 18 * sqrt 3 + 7 / 108 * (sqrt 3 * sqrt 3)) by field. rewrite R3. field.
Qed.
Lemma f_above A : middle A -> PI + 0.001 * excess A <= 3 * X (a0 T) A (a0 T) - KT * excess A.
Proof.
  intros H. pose proof (between T T_range) as [[B0 B1] [B2 B3]]. pose proof root11 as [R R']. pose proof root3 as [R3 R3'].
  assert (HT : middle T) by (unfold middle; lra). assert (H0 : middle (a0 T)) by (unfold middle; lra).
  destruct (X_range (a0 T) T (a0 T) H0 HT H0) as [X1 _]. destruct (X_range (a0 T) A (a0 T) H0 H H0) as [X2 E2]. destruct (X_range (a0 T) (a0 T) (a0 T) H0 H0 H0) as [X3 E3].
  set (F := X (a0 T) T (a0 T)) in *.
  assert (O1 : X (a0 T) A (a0 T) <= F) by (pose proof (other (a0 T) A T (a0 T) H0 H HT H0 ltac:(apply H)) as L; fold F in L; pose proof D_numbers; assert (0 <= D2 * (T - A)) by (apply Rmult_le_pos; unfold middle in H; lra); lra).
  assert (O2 : X (a0 T) (a0 T) (a0 T) <= X (a0 T) A (a0 T)) by (pose proof (other (a0 T) (a0 T) A (a0 T) H0 H0 H H0 ltac:(apply H)) as L; pose proof D_numbers; assert (0 <= D2 * (A - a0 T)) by (apply Rmult_le_pos; unfold middle in H; lra); lra).
  pose proof (cos_falls (X (a0 T) (a0 T) (a0 T)) (X (a0 T) A (a0 T)) F ltac:(pose proof PI_RGT_0; lra) O2 O1 ltac:(lra)) as G. rewrite E2, E3, !f_side in G by assumption.
  (* the sine of F *)
  pose proof f_end as CF. fold F in CF. pose proof (squares F) as SF. rewrite CF in SF. pose proof (sin_pos F ltac:(pose proof PI_RGT_0; lra)) as SF0.
  assert (SF2 : sin F * sin F < 0.8995 * 0.8995) by lra.
  assert (SF1 : sin F < 0.8995) by (apply Rnot_le_lt; intros Z; pose proof (Rmult_le_compat 0.8995 (sin F) 0.8995 (sin F) ltac:(lra) ltac:(lra) Z Z); lra).
  (* cot (A/2) falls *)
  assert (H1 : sin (T / 2) * sin (T / 2) = (6 - sqrt 3) / 12).
  { pose proof (cos_2a_sin (T / 2)) as Q. replace (2 * (T / 2)) with T in Q by field. rewrite cT in Q. lra. }
  assert (HC : (6 / (6 - sqrt 3)) * (A - a0 T) <= half_cot (a0 T) - half_cot A).
  { enough (half_cot A - half_cot (a0 T) <= - (6 / (6 - sqrt 3)) * (A - a0 T)) by lra.
    apply (grows_at_most half_cot (fun y => - (1 / 2) * / (sin (y / 2) * sin (y / 2)))); [apply H| |].
    - intros y Y. unfold middle in H. pose proof (sin_pos (y / 2) ltac:(lra)) as S. pose proof (squares (y / 2)) as S2. eapply slope_eq.
      + unfold half_cot. apply slope_div; [apply slope_cos, slope_div; [apply slope_id|apply slope_const|lra]|apply slope_sin, slope_div; [apply slope_id|apply slope_const|lra]|lra].
      + replace (- (1 / 2) * / (sin (y / 2) * sin (y / 2))) with (- (1 / 2) * (sin (y / 2) * sin (y / 2) + cos (y / 2) * cos (y / 2)) / (sin (y / 2) * sin (y / 2))) by (rewrite S2; field; lra). field. lra.
    - intros y Y. unfold middle in H. pose proof (sin_pos (y / 2) ltac:(lra)) as S. pose proof (sin_le (y / 2) (T / 2) ltac:(lra) ltac:(lra) ltac:(lra)) as S3.
      assert (S4 : sin (y / 2) * sin (y / 2) <= (6 - sqrt 3) / 12) by (rewrite <- H1; apply Rmult_le_compat; lra).
      assert (S5 : 0 < sin (y / 2) * sin (y / 2)) by (apply Rmult_lt_0_compat; lra).
      assert (/ ((6 - sqrt 3) / 12) <= / (sin (y / 2) * sin (y / 2))) by (apply Rinv_le_contravar; lra).
      replace (6 / (6 - sqrt 3)) with (1 / 2 * / ((6 - sqrt 3) / 12)) by (field; lra). lra. }
  set (e := excess A) in *. assert (e0 : 0 <= e) by (unfold e, excess; unfold middle in H; lra). change (A - a0 T) with e in HC.
  rewrite X_start in *. pose proof KT_is as [KE K'].
  set (g := 7 / (5 * sqrt 11)) in *. assert (g0 : 0.4220 < g).
  { unfold g. apply Rmult_lt_reg_r with (5 * sqrt 11); [lra|]. replace (7 / (5 * sqrt 11) * (5 * sqrt 11)) with 7 by (field; lra). lra. }
  assert (h0 : 1.4056 < 6 / (6 - sqrt 3)).
  { apply Rmult_lt_reg_r with (6 - sqrt 3); [lra|]. replace (6 / (6 - sqrt 3) * (6 - sqrt 3)) with 6 by (field; lra). lra. }
  set (h := 6 / (6 - sqrt 3)) in *.
  set (x := X (a0 T) A (a0 T)) in *. set (d := half_cot (a0 T) - half_cot A) in *.
  assert (G1 : 11 / 12 * (g * d) <= sin F * (x - PI / 3)) by (unfold d; lra).
  assert (L1 : 1.4056 * e <= d) by (apply Rle_trans with (h * e); [apply Rmult_le_compat_r; lra|exact HC]).
  assert (L2 : 0.4220 * (1.4056 * e) <= g * d) by (apply Rmult_le_compat; lra).
  assert (L3 : sin F * (x - PI / 3) <= 0.8995 * (x - PI / 3)) by (apply Rmult_le_compat_r; lra).
  assert (L4 : KT * e <= 1.8091 * e) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma utt_above A B C : middle A -> middle B -> middle C ->
  PI + 0.001 * (excess A + excess B + excess C) <= 3 / 2 * (X B C A + X C A B) - KT * excess A - CT * (excess B + excess C).
Proof.
  intros HA HB HC. pose proof (between T T_range) as [[_ H] _]. assert (H0 : middle (a0 T)) by (unfold middle; lra).
  pose proof (f_above A HA) as L.
  (* X B C A >= X a0 A a0 + D1 E_B + D2 E_C *)
  pose proof (own (a0 T) B (a0 T) A H0 HB H0 HA ltac:(apply HB)) as L1. pose proof (other B (a0 T) C A HB H0 HC HA ltac:(apply HC)) as L2.
  pose proof (own (a0 T) C A (a0 T) H0 HC HA H0 ltac:(apply HC)) as L3. pose proof (other C (a0 T) B A HC H0 HB HA ltac:(apply HB)) as L4.
  rewrite (X_sym (a0 T) (a0 T) A) in L1. rewrite (X_sym C B A), (X_sym C (a0 T) A) in L4.
  pose proof D_numbers. pose proof CT_below. unfold excess, middle in *.
  assert (0 <= (3 / 2 * (D1 + D2) - CT - 0.001) * (B - a0 T + (C - a0 T))) by (apply Rmult_le_pos; lra). lra.
Qed.

Theorem lemma_6_uuu A B C a b c : spherical_triangle A B C a b c -> middle A -> middle B -> middle C ->
  let E x := x - a0 T in
  2 * PI <= 2 * (apex T a + apex T b + apex T c) - KT * (E A + E B + E C) /\
  (2 * (apex T a + apex T b + apex T c) - KT * (E A + E B + E C) = 2 * PI -> E A = 0 /\ E B = 0 /\ E C = 0).
Proof.
  intros H HA HB HC E. rewrite (X_is A B C a), (X_is B C A b), (X_is C A B c) by (auto; apply H).
  pose proof (uuu_above A B C HA HB HC) as L. unfold excess in L. change (A - a0 T) with (E A) in L. change (B - a0 T) with (E B) in L. change (C - a0 T) with (E C) in L.
  assert (0 <= E A /\ 0 <= E B /\ 0 <= E C) by (unfold middle, E in *; lra). split; [|intros]; lra.
Qed.
(** The side a is that between the two t's. *)
Theorem lemma_6_utt A B C a b c : spherical_triangle A B C a b c -> middle A -> middle B -> middle C ->
  let E x := x - a0 T in
  PI <= 3 / 2 * (apex T b + apex T c) - KT * E A - CT * (E B + E C) /\
  (3 / 2 * (apex T b + apex T c) - KT * E A - CT * (E B + E C) = PI -> E A = 0 /\ E B = 0 /\ E C = 0).
Proof.
  intros H HA HB HC E. rewrite (X_is B C A b), (X_is C A B c) by (auto; apply H).
  pose proof (utt_above A B C HA HB HC) as L. unfold excess in L. change (A - a0 T) with (E A) in L. change (B - a0 T) with (E B) in L. change (C - a0 T) with (E C) in L.
  assert (0 <= E A /\ 0 <= E B /\ 0 <= E C) by (unfold middle, E in *; lra). split; [|intros]; lra.
Qed.
