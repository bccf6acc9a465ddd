(** The numerical inequalities of docs/lower-bound.md, in real numbers.

    Sections 2, 5, 6, 8, 9 and 13: each lemma is one step that [acutile lower-bound] decides, with
    the same name. [interval] of CoqInterval proves inequalities; equations between square roots are
    proved by [field]. The boxes of section 14, the geometry and the combinatorics are not here.

    Build: make lower-bound-numbers. Needs Debian's libcoq-interval. *)

From Coq Require Import Reals Lra.
From Interval Require Import Tactic.
Local Open Scope R_scope.

(** An angle in degrees. *)
Definition deg (x : R) : R := x * PI / 180.

Definition c : R := sqrt 3 / 6.
Definition s : R := sqrt 11 / (2 * sqrt 3).
Definition ca : R := 8 * c ^ 4 - 8 * c ^ 2 + 1.
Definition sa : R := 4 * s * c * (1 - 2 * c ^ 2).
Definition K : R := / (2 * s * c).
Definition C : R := (1 - c) / 2 * s ^ 2 / c / (sa * sqrt 3 / 2).
Definition D1 : R := sa / s.
Definition D2 : R := D1 * c / (1 - c).
Definition cf : R := s ^ 2 * ca / sa * (1 + c) / s - c ^ 2.

Ltac numbers := unfold cf, D2, D1, C, K, sa, ca, s, c.

Lemma root3 : sqrt 3 * sqrt 3 = 3.
Proof. apply sqrt_sqrt; lra. Qed.
Lemma root11 : sqrt 11 * sqrt 11 = 11.
Proof. apply sqrt_sqrt; lra. Qed.
Lemma root3_positive : 0 < sqrt 3.
Proof. apply sqrt_lt_R0; lra. Qed.
Lemma root11_positive : 0 < sqrt 11.
Proof. apply sqrt_lt_R0; lra. Qed.

Lemma c_squared : c ^ 2 = 1 / 12.
Proof. unfold c. replace ((sqrt 3 / 6) ^ 2) with (sqrt 3 * sqrt 3 / 36) by field. rewrite root3. lra. Qed.
Lemma s_squared : s ^ 2 = 11 / 12.
Proof.
  unfold s. pose proof root3_positive.
  replace ((sqrt 11 / (2 * sqrt 3)) ^ 2) with (sqrt 11 * sqrt 11 / (4 * (sqrt 3 * sqrt 3))) by (field; lra).
  rewrite root3, root11. lra.
Qed.

(** ** Section 2 *)
Lemma sine : s ^ 2 = 1 - c ^ 2.
Proof. rewrite s_squared, c_squared. lra. Qed.
Lemma sine_is_positive : s > 0.
Proof. numbers; interval. Qed.
Lemma theta_below_90 : c > 0.
Proof. numbers; interval. Qed.
Lemma theta_above_45 : 2 * c ^ 2 < 1.
Proof. numbers; interval. Qed.
Lemma theta_above_72 : 4 * c ^ 2 + 2 * c < 1.
Proof. numbers; interval. Qed.
Lemma cosine_of_a0 : ca = 7 / 18.
Proof. unfold ca. replace (c ^ 4) with (c ^ 2 * c ^ 2) by ring. rewrite c_squared. lra. Qed.
Lemma s_times_c : s * c = sqrt 11 / 12.
Proof. unfold s, c. pose proof root3_positive. field. lra. Qed.
Lemma sine_of_a0 : sa = 5 * sqrt 11 / 18.
Proof.
  unfold sa. replace (4 * s * c * (1 - 2 * c ^ 2)) with (4 * (s * c) * (1 - 2 * c ^ 2)) by ring.
  rewrite s_times_c, c_squared. field.
Qed.
Lemma a0_above_60 : ca < 1 / 2.
Proof. numbers; interval. Qed.
Lemma a0_below_theta : ca > c.
Proof. numbers; interval. Qed.

(** ** Section 1: the decimals *)
Lemma theta_from_below : c < cos (deg 73.2213).
Proof. unfold deg; numbers; interval. Qed.
Lemma theta_from_above : c > cos (deg 73.2214).
Proof. unfold deg; numbers; interval. Qed.

(** ** Section 5 *)
Lemma angles_above_60 : let x := (sqrt 33 - 1) / 16 in 4 * x ^ 2 / (1 - x) = 1 / 2.
Proof.
  cbv zeta. assert (h : sqrt 33 * sqrt 33 = 33) by (apply sqrt_sqrt; lra).
  assert (p : sqrt 33 < 6) by interval.
  apply Rmult_eq_reg_r with (1 - (sqrt 33 - 1) / 16); [| lra].
  unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l by lra. nra.
Qed.
Lemma five_or_six : let x := cos (deg 74.7324) in 1 - 4 * x ^ 2 / (1 - x) < cos (deg (360 / 7)).
Proof. cbv zeta; unfold deg; interval with (i_prec 60). Qed.

(** ** Section 6 *)
Lemma angles_above_phi : 1 - 4 * c ^ 2 / (1 - c) < cos (deg 57.9).
Proof. unfold deg; numbers; interval with (i_prec 60). Qed.
Lemma no_two_sixes :
  let p := 1.09 in let z := 0.89 in
  2 * cos (deg (180 - 2 * 57.9)) * cos (deg (180 - 3 * 57.9))
  > (p ^ 2 + 2 + z ^ 2 - c * (2 + 2 * p * z + 4 * z)) / (2 * p).
Proof. cbv zeta; unfold deg; numbers; interval. Qed.
Lemma tetrahedron_with_three_a0 : 2 * 3 * ca + 2 * 3 * (3 * c) * c > 3 + (3 * c) ^ 2.
Proof. numbers; interval. Qed.

(** ** Section 8 *)
Lemma least_side : (ca + ca ^ 2) / sa ^ 2 = 7 / 11.
Proof.
  rewrite cosine_of_a0, sine_of_a0.
  replace ((5 * sqrt 11 / 18) ^ 2) with (25 * (sqrt 11 * sqrt 11) / 324) by field.
  rewrite root11. lra.
Qed.
Lemma least_apex_is_60 : s ^ 2 * (7 / 11) - c ^ 2 = 1 / 2.
Proof. rewrite s_squared, c_squared. lra. Qed.
Lemma greatest_apex_is_theta : s ^ 2 * c / (1 - c) - c ^ 2 = c.
Proof. rewrite sine. assert (c < 1) by (numbers; interval). field. lra. Qed.
Lemma K_is : K = 6 / sqrt 11.
Proof.
  unfold K. replace (2 * s * c) with (2 * (s * c)) by ring. rewrite s_times_c.
  pose proof root11_positive. field. lra.
Qed.
Lemma C_is_below : C < 1.416.
Proof. numbers; interval. Qed.

(** ** Section 9 *)
Lemma uuu_grows : 2 * (D1 + 2 * D2) > K.
Proof. numbers; interval. Qed.
Lemma utt_grows : 3 / 2 * (D1 + D2) > C.
Proof. numbers; interval. Qed.
Lemma f_limit : 3 / 2 * s ^ 2 * ca / sa / K = 77 / 240.
Proof.
  rewrite s_squared, cosine_of_a0, sine_of_a0, K_is.
  pose proof root11_positive. field. lra.
Qed.
Lemma f_grows_fast : ((1 - c) / 2) ^ 2 * (1 - cf ^ 2) < (77 / 240) ^ 2.
Proof. numbers; interval with (i_prec 60). Qed.

(** ** Section 13 *)
Section At73.
Let c' := cos (deg 73.29).
Let s' := sin (deg 73.29).
Let ca' := cos (deg (360 - 4 * 73.29)).
Let sa' := sin (deg (360 - 4 * 73.29)).
Let K' := / (2 * s' * c').
Let D1' := sa' / s'.
Let D2' := D1' * c' / (1 - c').
Let cosx := / (8 * c' ^ 2) - 1.
Let sinx := sqrt (1 - cosx ^ 2).
Let C' := (1 - c') / 2 * s' ^ 2 / c' / (sa' * sinx).
Let rate := 3 / 2 * (D1' + D2') - C'.
Let cf' := s' ^ 2 * ca' / sa' * (1 + c') / s' - c' ^ 2.
Ltac numbers' := unfold rate, cf', C', sinx, cosx, D2', D1', K', sa', ca', s', c', deg.

(** x0 is above 59.2; the claims below use this bound. *)
Lemma x0_above : cosx < cos (deg 59.2).
Proof. numbers'; interval with (i_prec 60). Qed.
Lemma refined_uuu_grows : 2 * (D1' + 2 * D2') > K'.
Proof. numbers'; interval. Qed.
Lemma refined_utt_grows : rate > 0.
Proof. numbers'; interval. Qed.
Lemma refined_f_grows_fast : (1 - c') / 2 * sqrt (1 - cf' ^ 2) * K' < 3 / 2 * s' ^ 2 * ca' / sa'.
Proof. numbers'; interval with (i_prec 60). Qed.
(** The angle b of section 13 is above 70. *)
Lemma b_above : (3 - 9 * c' ^ 2) / 2 - 2 * ca' < cos (deg 70).
Proof. numbers'; interval with (i_prec 60). Qed.
Lemma uuu_pays : 6 * (59.2 - 60) + (2 * (D1' + 2 * D2') - K') * (70 - 66.84) > 0.
Proof. numbers'; interval. Qed.
Lemma t_with_two_utt : 3 * (59.2 - 60) + rate * 6.45 > 0.
Proof. numbers'; interval. Qed.
Lemma t_with_one_utt : 2 * (59.2 - 60) + rate * 6.45 > 0.
Proof. numbers'; interval. Qed.
Lemma t_with_one_tt : 2 * (59.2 - 60) + D2' * 6.45 > 0.
Proof. numbers'; interval. Qed.
Lemma t_with_two_tt : 59.2 - 60 + D2' * 6.45 > 0.
Proof. numbers'; interval. Qed.
End At73.
