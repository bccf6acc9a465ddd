(** * docs/lower-bound.md, section 9: Lemma 6, the 555 triangles; the third sentence of Lemma 3

    Here theta is theta* = arccos (sqrt 3 / 6).  All numbers lie in the field of sqrt 3 and sqrt 11. *)
From Coq Require Import Reals Lra Psatz.
From LowerBound Require Import Calculus Normals Corners Triangles Sides.
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
Lemma ca0 : cos (a0 T) = 7 / 18.
Proof. rewrite cos_a0, cT. pose proof root3 as [R _]. replace (sqrt 3 / 6) with (/ 6 * sqrt 3) by field. nra. Qed.
Lemma sin_2T : sin (2 * T) = sqrt 11 / 6.
Proof.
  rewrite sin_2a, sT, cT. pose proof root3 as [R _]. replace (2 * (sqrt 3 * sqrt 11 / 6) * (sqrt 3 / 6)) with (2 * (sqrt 3 * sqrt 3) * sqrt 11 / 36) by field.
  rewrite R. field.
Qed.
Lemma sa0 : sin (a0 T) = 5 * sqrt 11 / 18.
Proof.
  rewrite sin_a0, sT, cT. pose proof root3 as [R _].
  replace (4 * (sqrt 3 / 6) * (1 - 2 * (sqrt 3 / 6) ^ 2) * (sqrt 3 * sqrt 11 / 6)) with (4 * (sqrt 3 * sqrt 3) * (1 - sqrt 3 * sqrt 3 / 18) * sqrt 11 / 36) by field. rewrite R. field.
Qed.
(** theta* is between 72 and 75 degrees. *)
Lemma T_range : 2 * PI / 5 < T < 5 * PI / 12.
Proof. apply range_from; [exact T_acute|rewrite cT; pose proof root3; lra|rewrite ca0, cT; pose proof root3; lra]. Qed.

(** Angles in [a0, theta*], and x of the side opposite A. *)
Notation middle := (mid T).
Notation X := (xs T).
Lemma s2T : sin T ^ 2 = 11 / 12.
Proof. pose proof sT2. lra. Qed.

(** ** Lemma 3, the third sentence *)

Lemma acos_half : acos (1 / 2) = PI / 3.
Proof.
  rewrite <- cos_PI3. apply acos_cos. pose proof PI_RGT_0. lra.
Qed.
Lemma X_is A B C l : middle B -> middle C -> side_rule A B C l -> apex T l = X A B C.
Proof. intros HB HC R. unfold xs, apex. rewrite <- (side_cos_rule A B C l) by (auto; apply (mid_trig T T_range); assumption). reflexivity. Qed.
Lemma X_start : X (a0 T) (a0 T) (a0 T) = PI / 3.
Proof.
  unfold xs. rewrite <- acos_half, s2T, cT. f_equal. unfold side_cos. rewrite ca0, sa0. pose proof root11 as [R _]. pose proof root3 as [R3 _].
  replace (5 * sqrt 11 / 18 * (5 * sqrt 11 / 18)) with (25 * (sqrt 11 * sqrt 11) / 324) by field. rewrite R. lra.
Qed.
(** D1 and D2 of section 9 *)
Definition D1 := sin (a0 T) / sin T.
Definition D2 := D1 * (cos T / (1 - cos T)).
Lemma D1_is : D1 = 5 * sqrt 3 / 9.
Proof.
  pose proof root3 as [R3 R3']. pose proof root11 as [R R']. unfold D1. rewrite sa0, sT.
  apply Rmult_eq_reg_r with (sqrt 3 * sqrt 11 / 6); [|assert (0 < sqrt 3 * sqrt 11) by (apply Rmult_lt_0_compat; lra); lra].
  replace (5 * sqrt 11 / 18 / (sqrt 3 * sqrt 11 / 6) * (sqrt 3 * sqrt 11 / 6)) with (5 * sqrt 11 / 18) by (field; lra).
  replace (5 * sqrt 3 / 9 * (sqrt 3 * sqrt 11 / 6)) with (5 * (sqrt 3 * sqrt 3) * sqrt 11 / 54) by field. rewrite R3. field.
Qed.
Lemma D_numbers : 0.962 < D1 /\ 0.390 < D2.
Proof.
  pose proof root3 as [R3 R3']. unfold D2. rewrite D1_is, cT. split; [lra|].
  apply Rmult_lt_reg_r with (6 - sqrt 3); [lra|].
  replace (5 * sqrt 3 / 9 * (sqrt 3 / 6 / (1 - sqrt 3 / 6)) * (6 - sqrt 3)) with (5 * (sqrt 3 * sqrt 3) / 9) by (field; lra). lra.
Qed.
(** x is above 60 degrees. *)
Lemma X_above A B C : middle A -> middle B -> middle C ->
  PI / 3 + D1 * (A - a0 T) + D2 * ((B - a0 T) + (C - a0 T)) <= X A B C.
Proof. intros HA HB HC. rewrite <- X_start. exact (xs_above T T_range T (mid_theta T T_range) A B C HA HB HC). Qed.

(** Lemma 3: x(l) >= 60 degrees, with equality only if the three angles are all a0. *)
Theorem lemma_3_at_least A B C l m n : spherical_triangle A B C l m n -> middle A -> middle B -> middle C ->
  PI / 3 <= apex T l /\ (apex T l = PI / 3 -> A = a0 T /\ B = a0 T /\ C = a0 T).
Proof.
  intros H HA HB HC. rewrite (X_is A B C l) by (auto; apply H). pose proof (X_above A B C HA HB HC) as L. pose proof D_numbers.
  unfold mid in *. assert (0 <= D1 * (A - a0 T)) by (apply Rmult_le_pos; lra).
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
  pose proof D_numbers. pose proof KT_is as [_ K']. unfold excess, mid in *.
  set (S := A - a0 T + (B - a0 T) + (C - a0 T)) in *. assert (S0 : 0 <= S) by (unfold S; lra).
  assert (0 <= (2 * (D1 + 2 * D2) - KT - 1) * S) by (apply Rmult_le_pos; lra). unfold S in *. lra.
Qed.

Lemma f_fast : (KT + 0.001) * (1 - cos T) * sin (X (a0 T) T (a0 T)) <= 3 * sin T ^ 2 * (cos (a0 T) / sin (a0 T)).
Proof.
  pose proof root11 as [R R']. pose proof root3 as [R3 R3']. pose proof KT_is as [_ K']. pose proof (mid_theta T T_range) as HT. pose proof (mid_a T T_range) as H0.
  set (F := X (a0 T) T (a0 T)).
  assert (CF : cos F = (1 + 7 * sqrt 3) / 30).
  { unfold F. rewrite (f_end T T_range), ca0, sa0, sT, cT.
    replace (sqrt 3 * sqrt 11 / 6 * (7 / 18 / (5 * sqrt 11 / 18)) * (1 + sqrt 3 / 6) - (sqrt 3 / 6) ^ 2)
      with (7 * sqrt 3 / 30 + 7 * (sqrt 3 * sqrt 3) / 180 - sqrt 3 * sqrt 3 / 36) by (field; lra). rewrite R3. field. }
  destruct (xs_range T T_range T HT _ _ _ H0 HT H0) as [X1 _]. fold F in X1. pose proof T_acute. pose proof (sin_ge_0 F ltac:(lra) ltac:(lra)) as SF0.
  pose proof (squares F) as SF. rewrite CF in SF. assert (SF2 : sin F * sin F < 0.8995 * 0.8995) by lra.
  assert (SF1 : sin F < 0.8995) by (apply Rnot_le_lt; intros Z; pose proof (Rmult_le_compat 0.8995 (sin F) 0.8995 (sin F) ltac:(lra) ltac:(lra) Z Z); lra).
  rewrite s2T, ca0, sa0, cT.
  assert (G : 0.4221 <= 7 / 18 / (5 * sqrt 11 / 18)) by (apply Rmult_le_reg_r with (5 * sqrt 11 / 18); [lra|]; replace (7 / 18 / (5 * sqrt 11 / 18) * (5 * sqrt 11 / 18)) with (7 / 18) by (field; lra); lra).
  assert (P : (KT + 0.001) * (1 - sqrt 3 / 6) <= 1.8101 * 0.7114) by (apply Rmult_le_compat; lra).
  assert (P0 : 0 <= (KT + 0.001) * (1 - sqrt 3 / 6)) by (apply Rmult_le_pos; lra).
  assert ((KT + 0.001) * (1 - sqrt 3 / 6) * sin F <= 1.8101 * 0.7114 * 0.8995) by (apply Rmult_le_compat; lra). lra.
Qed.
(** utt', with u at A *)
Lemma utt_above A B C : middle A -> middle B -> middle C ->
  PI + 0.001 * (excess A + excess B + excess C) <= 3 / 2 * (X B C A + X C A B) - KT * excess A - CT * (excess B + excess C).
Proof.
  intros HA HB HC. pose proof KT_is as [_ K']. pose proof (utt_from_f T T_range A B C 0.001 HA HB HC ltac:(unfold KT in K'; lra) f_fast) as L.
  rewrite X_start in L. pose proof D_numbers. pose proof CT_below. fold D1 D2 in L. fold KT in L. unfold excess, mid in *.
  assert (0 <= (3 / 2 * (D1 + D2) - CT - 0.001) * (B - a0 T + (C - a0 T))) by (apply Rmult_le_pos; lra). lra.
Qed.

Theorem lemma_6_uuu A B C a b c : spherical_triangle A B C a b c -> middle A -> middle B -> middle C ->
  let E x := x - a0 T in
  2 * PI <= 2 * (apex T a + apex T b + apex T c) - KT * (E A + E B + E C) /\
  (2 * (apex T a + apex T b + apex T c) - KT * (E A + E B + E C) = 2 * PI -> E A = 0 /\ E B = 0 /\ E C = 0).
Proof.
  intros H HA HB HC E. rewrite (X_is A B C a), (X_is B C A b), (X_is C A B c) by (auto; apply H).
  pose proof (uuu_above A B C HA HB HC) as L. unfold excess in L. change (A - a0 T) with (E A) in L. change (B - a0 T) with (E B) in L. change (C - a0 T) with (E C) in L.
  assert (0 <= E A /\ 0 <= E B /\ 0 <= E C) by (unfold mid, E in *; lra). split; [|intros]; lra.
Qed.
(** The side a is that between the two t's. *)
Theorem lemma_6_utt A B C a b c : spherical_triangle A B C a b c -> middle A -> middle B -> middle C ->
  let E x := x - a0 T in
  PI <= 3 / 2 * (apex T b + apex T c) - KT * E A - CT * (E B + E C) /\
  (3 / 2 * (apex T b + apex T c) - KT * E A - CT * (E B + E C) = PI -> E A = 0 /\ E B = 0 /\ E C = 0).
Proof.
  intros H HA HB HC E. rewrite (X_is B C A b), (X_is C A B c) by (auto; apply H).
  pose proof (utt_above A B C HA HB HC) as L. unfold excess in L. change (A - a0 T) with (E A) in L. change (B - a0 T) with (E B) in L. change (C - a0 T) with (E C) in L.
  assert (0 <= E A /\ 0 <= E B /\ 0 <= E C) by (unfold mid, E in *; lra). split; [|intros]; lra.
Qed.
