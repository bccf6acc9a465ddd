(** * Decimals: sines and cosines of small angles, roots, pi *)
From Coq Require Import Reals Lra Psatz.
From LowerBound Require Import Calculus.
Open Scope R_scope.

Lemma sin_below y : 0 <= y -> sin y <= y.
Proof.
  intros Y. pose proof (grows_at_most sin (fun z => cos z * 1) 1 0 y Y (fun z _ => slope_sin _ z 1 (slope_id z))) as G. rewrite sin_0 in G.
  enough (sin y - 0 <= 1 * (y - 0)) by lra. apply G. intros z _. pose proof (COS_bound z). lra.
Qed.
Lemma cos_square y : 1 - y * y / 2 <= cos y.
Proof.
  replace (cos y) with (cos (2 * (y / 2))) by (f_equal; field). rewrite cos_2a_sin.
  assert (S : forall z, 0 <= z -> sin z * sin z <= z * z).
  { intros z Z. destruct (Rle_dec z 1) as [L|L].
    - pose proof (grows_at_most sin (fun z => cos z * 1) 1 0 z Z (fun z _ => slope_sin _ z 1 (slope_id z))) as G. rewrite sin_0 in G.
      assert (sin z <= z) by (enough (sin z - 0 <= 1 * (z - 0)) by lra; apply G; intros w _; pose proof (COS_bound w); lra).
      pose proof (sin_ge_0 z Z ltac:(pose proof PI2_3_2; lra)). apply Rmult_le_compat; lra.
    - pose proof (squares z). pose proof (Rle_0_sqr (cos z)). unfold Rsqr in *. nra. }
  destruct (Rle_dec 0 (y / 2)) as [L|L]; [pose proof (S _ L); lra|]. pose proof (S (- (y / 2)) ltac:(lra)) as Q. rewrite sin_neg in Q. lra.
Qed.
Lemma sin_cubic y : 0 <= y <= 1 -> y - y * y * y / 6 <= sin y <= y - y * y * y / 6 + y * y * y * (y * y) / 120.
Proof.
  intros Y. pose proof PI2_3_2. pose proof (pre_sin_bound y 0 ltac:(lra) ltac:(lra)) as B. unfold sin_approx, sin_term in B.
  cbn [sum_f_R0 Nat.mul Nat.add fact pow INR] in B. lra.
Qed.
Lemma cos_quartic y : 0 <= y <= 1 -> cos y <= 1 - y * y / 2 + y * y * (y * y) / 24.
Proof.
  intros Y. replace (cos y) with (cos (2 * (y / 2))) by (f_equal; field). rewrite cos_2a_sin. pose proof (sin_cubic (y / 2) ltac:(lra)) as [S _].
  set (z := y / 2) in *. assert (Z : 0 <= z <= 1 / 2) by (unfold z; lra). replace y with (2 * z) by (unfold z; field).
  assert (Z2 : 0 <= z * z <= 1) by (split; [apply Rmult_le_pos; lra|replace 1 with (1 * 1) by lra; apply Rmult_le_compat; lra]).
  set (w := z - z * z * z / 6) in *. assert (W0 : 0 <= w) by (unfold w; replace (z - z * z * z / 6) with (z * (1 - z * z / 6)) by field; apply Rmult_le_pos; lra).
  assert (W : w * w <= sin z * sin z) by (apply Rmult_le_compat; lra).
  assert (W' : z * z - z * z * (z * z) / 3 <= w * w).
  { replace (w * w) with (z * z - z * z * (z * z) / 3 + z * z * z * (z * z * z) / 36) by (unfold w; field).
    assert (0 <= z * z * z * (z * z * z)) by (repeat apply Rmult_le_pos; lra). lra. }
  lra.
Qed.

Lemma roots : 1.4142135 < sqrt 2 < 1.4142136 /\ 1.7320508 < sqrt 3 < 1.7320509.
Proof.
  pose proof (sqrt_sqrt 3 ltac:(lra)). pose proof (sqrt_lt_R0 3 ltac:(lra)). pose proof (sqrt_sqrt 2 ltac:(lra)). pose proof (sqrt_lt_R0 2 ltac:(lra)).
  repeat split; apply Rnot_le_lt; intros Z; nra.
Qed.
Lemma PI_between : 3.14159 < PI < 3.1418.
Proof.
  pose proof roots as [R2 R3]. pose proof PI2_3_2. pose proof PI_4.
  assert (S12 : sin (PI / 12) = sqrt 2 * (sqrt 3 - 1) / 4).
  { replace (PI / 12) with (PI / 3 - PI / 4) by field. rewrite sin_minus, cos_PI3, sin_PI3, cos_PI4, sin_PI4.
    replace (1 / sqrt 2) with (sqrt 2 / 2) by (apply Rmult_eq_reg_r with (sqrt 2); [pose proof (sqrt_sqrt 2 ltac:(lra)); field_simplify; lra|lra]). field. }
  assert (L1 : 1.4142135 * 0.7320508 <= sqrt 2 * (sqrt 3 - 1)) by (apply Rmult_le_compat; lra). assert (L2 : sqrt 2 * (sqrt 3 - 1) <= 1.4142136 * 0.7320509) by (apply Rmult_le_compat; lra).
  split; apply Rnot_le_lt; intros L.
  - pose proof (sin_le (PI / 12) (3.14159 / 12) ltac:(lra) ltac:(lra) ltac:(lra)) as S. pose proof (sin_cubic (3.14159 / 12) ltac:(lra)). lra.
  - pose proof (sin_le (3.1418 / 12) (PI / 12) ltac:(lra) ltac:(lra) ltac:(lra)) as S. pose proof (sin_cubic (3.1418 / 12) ltac:(lra)). lra.
Qed.
