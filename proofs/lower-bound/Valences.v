(** * docs/lower-bound.md, Proposition 5: with angles below 74.7324 degrees all valences are 5 or 6 *)
From Coq Require Import Reals Lra Psatz Lia List.
From Acutile Require Import Statement Tetrahedra.
From LowerBound Require Import Calculus Normals Sides Decimals Steps Tiling Around Theorem1.
Import ListNotations.
Open Scope R_scope.

Definition theta5 := 74.7324 * PI / 180.
Lemma theta5_acute : 0 <= theta5 < PI / 2.
Proof. pose proof PI_RGT_0. unfold theta5. lra. Qed.
Lemma cos_theta5 : 0.2633274 < cos theta5.
Proof.
  pose proof PI_between as P. set (d := 0.2676 * PI / 180). assert (D : 0.00467049 <= d <= 0.00468) by (unfold d; lra).
  replace theta5 with (PI / 4 + PI / 6 - d) by (unfold theta5, d; lra).
  rewrite cos_minus, cos_plus, sin_plus, cos_PI4, sin_PI4, cos_PI6, sin_PI6. pose proof roots as [R2 R3].
  replace (1 / sqrt 2) with (sqrt 2 / 2) by (apply Rmult_eq_reg_r with (sqrt 2); [pose proof (sqrt_sqrt 2 ltac:(lra)); field_simplify; lra|lra]).
  pose proof (cos_square d) as CD. pose proof (sin_cubic d ltac:(lra)) as [SD _].
  assert (DD : d * d <= 0.00468 * 0.00468) by (apply Rmult_le_compat; lra). assert (0.00467049 * (1 - 0.00468 * 0.00468 / 6) <= d * (1 - d * d / 6)) by (apply Rmult_le_compat; lra).
  assert (1.4142135 * 0.7320508 <= sqrt 2 * (sqrt 3 - 1)) by (apply Rmult_le_compat; lra). assert (1.4142135 * 2.7320508 <= sqrt 2 * (sqrt 3 + 1)) by (apply Rmult_le_compat; lra).
  assert (1.4142135 * 0.7320508 * (1 - 0.00468 * 0.00468 / 2) <= sqrt 2 * (sqrt 3 - 1) * cos d) by (apply Rmult_le_compat; lra).
  assert (1.4142135 * 2.7320508 * (0.00467049 * (1 - 0.00468 * 0.00468 / 6)) <= sqrt 2 * (sqrt 3 + 1) * sin d) by (apply Rmult_le_compat; lra). lra.
Qed.
(** The seventh part of a turn: 3 and 4 times this angle have the same cosine. *)
Lemma cos_seventh : 0.6234897 < cos (2 * PI / 7).
Proof.
  pose proof PI_RGT_0. set (x := 2 * PI / 7). set (y := cos x).
  assert (Y1 : 1 / 2 < y) by (unfold y; rewrite <- cos_PI3; apply cos_decreasing_1; unfold x; lra).
  assert (Y2 : y < 1) by (unfold y; rewrite <- cos_0; apply cos_decreasing_1; unfold x; lra).
  assert (E : cos (3 * x) = cos (2 * (2 * x))).
  { replace (3 * x) with (2 * PI - 2 * (2 * x)) by (unfold x; field). rewrite cos_minus, cos_2PI, sin_2PI. ring. }
  rewrite cos_triple, !double_cos in E. fold y in E.
  assert (F : (y - 1) * (8 * (y * y * y) + 4 * (y * y) - 4 * y - 1) = 0) by lra. apply Rmult_integral in F. destruct F as [F|F]; [lra|].
  apply Rnot_le_lt. intros L. assert (Z : 0 <= (0.6234897 - y) * (8 * (0.6234897 * 0.6234897 + 0.6234897 * y + y * y) + 4 * (0.6234897 + y) - 4)).
  { apply Rmult_le_pos; [lra|]. pose proof (Rle_0_sqr y). unfold Rsqr in *. lra. }
  lra.
Qed.
Lemma above_a_seventh a b c d x : orient a b c d <> 0 -> all_below a b c d theta5 -> In x (dihedrals (Tetrahedron a b c d)) -> 2 * PI / 7 < x < theta5.
Proof.
  intros O H X. split; [|apply H, X]. pose proof (corollary_a_strict a b c d theta5 O theta5_acute H x X) as L. pose proof cos_theta5 as K. pose proof cos_seventh as S.
  pose proof theta5_acute as TA. set (k := cos theta5) in *.
  assert (K2 : k < 1 / 2).
  { unfold k. rewrite <- cos_PI3. pose proof PI_RGT_0. apply cos_decreasing_1; unfold theta5 in *; lra. }
  assert (Q : 1 - 4 * k ^ 2 / (1 - k) <= 0.6234897).
  { apply Rmult_le_reg_r with (1 - k); [lra|]. replace ((1 - 4 * k ^ 2 / (1 - k)) * (1 - k)) with (1 - k - 4 * k ^ 2) by (field; lra).
    assert (0 <= (k - 0.2633274) * (4 * (k + 0.2633274) + 0.3765103)) by (apply Rmult_le_pos; lra). lra. }
  pose proof (Normals.angle_range a b c d x X) as B. pose proof PI_RGT_0. apply Rnot_le_lt. intros Z. pose proof (cos_le x (2 * PI / 7) ltac:(lra) Z ltac:(lra)). lra.
Qed.

Theorem proposition_5_space index (is_tile : index -> Prop) tile : space_tiling is_tile tile ->
  (forall c x, is_tile c -> In x (dihedrals (tile c)) -> x < 74.7324 * PI / 180) ->
  forall u v c, has_edge is_tile tile u v c -> u <> v -> edge_valence is_tile tile u v 5 \/ edge_valence is_tile tile u v 6.
Proof.
  intros tiling H u v c Ed Ne. destruct (edge_cycle tiling u v c Ed Ne) as [tiles [w [N [I [_ [A [_ S]]]]]]].
  assert (B : forall k, (k < length tiles)%nat -> 2 * PI / 7 < dihedral u v (w k) (w (Datatypes.S k)) < theta5).
  { intros k K. destruct (nth_error tiles k) as [j|] eqn:J; [|apply nth_error_None in J; lia]. pose proof (A k j J) as X.
    pose proof (nth_error_In _ _ J) as Ij. apply I in Ij. destruct Ij as [Tj _]. pose proof (space_solid _ _ tiling j Tj) as V. destruct (tile j) as [p q r s] eqn:Ej.
    apply (above_a_seventh p q r s); [exact V| |exact X]. intros y Y. apply (H j y Tj). rewrite Ej. exact Y. }
  assert (R : INR (length tiles) * (2 * PI / 7) <= 2 * PI /\ 2 * PI <= INR (length tiles) * theta5 /\ (0 < length tiles)%nat).
  { assert (G : forall n, (n <= length tiles)%nat -> let s := fold_right Rplus 0 (map (fun k => dihedral u v (w k) (w (Datatypes.S k))) (seq 0 n)) in INR n * (2 * PI / 7) <= s <= INR n * theta5).
    { assert (Q : forall z l, fold_right Rplus z l = fold_right Rplus 0 l + z) by (intros z l; induction l as [|t l IH]; cbn; lra).
      induction n as [|n IH]; intros L; [cbn; lra|]. rewrite seq_S, map_app, fold_right_app, Q, S_INR. specialize (IH ltac:(lia)). cbv zeta in IH. pose proof (B n ltac:(lia)). cbn [map fold_right]. rewrite Nat.add_0_l. lra. }
    specialize (G _ (le_n _)). cbv zeta in G. rewrite S in G. pose proof PI_RGT_0. split; [lra|]. split; [lra|]. destruct tiles; [cbn in G; lra|cbn; lia]. }
  destruct R as [R1 [R2 R3]]. pose proof PI_RGT_0. pose proof theta5_acute as TA.
  assert (L1 : INR (length tiles) <= 7) by (apply Rmult_le_reg_r with (2 * PI / 7); lra).
  assert (L2 : 4 < INR (length tiles)).
  { apply Rnot_le_lt. intros Z. assert (INR (length tiles) * theta5 <= 4 * theta5) by (apply Rmult_le_compat_r; lra). lra. }
  assert (L3 : length tiles <> 7%nat).
  { intros E. assert (Q : fold_right Rplus 0 (map (fun k => dihedral u v (w k) (w (Datatypes.S k))) (seq 0 (length tiles))) = 2 * PI) by exact S.
    pose proof (B 0%nat ltac:(lia)). pose proof (B 1%nat ltac:(lia)). pose proof (B 2%nat ltac:(lia)). pose proof (B 3%nat ltac:(lia)). pose proof (B 4%nat ltac:(lia)). pose proof (B 5%nat ltac:(lia)). pose proof (B 6%nat ltac:(lia)).
    rewrite E in Q. cbn [seq map fold_right] in Q. lra. }
  replace 7 with (INR 7) in L1 by (cbn; lra). replace 4 with (INR 4) in L2 by (cbn; lra). apply INR_le in L1. apply INR_lt in L2.
  assert (L4 : length tiles = 5%nat \/ length tiles = 6%nat) by lia.
  destruct L4 as [L4|L4]; [left|right]; exists tiles; auto.
Qed.
