(** * docs/lower-bound.md, section 6: Steps A and B

    All dihedral angles of the tetrahedra are at most theta here.  Step C is in Link.v, and Vertex.v has all three at a
    vertex.  At the end theta is theta*; Larger.v has another one. *)
From Coq Require Import Reals Lra Psatz Lia List.
From Acutile Require Import Statement Tetrahedra Angles.
From LowerBound Require Import Calculus Normals Corners Sides Excess.
Import ListNotations.
Open Scope R_scope.

Definition sum (l : list R) := fold_right Rplus 0 l.
(** An angle of a tetrahedron all of whose angles are at most theta. *)
Definition possible_at (theta x : R) := exists a b c d,
  vol (Tetrahedron a b c d) <> 0 /\ all_at_most a b c d theta /\ In x (dihedrals (Tetrahedron a b c d)).

Lemma cos_turned x : cos (PI - x) = - cos x.
Proof. rewrite cos_minus, cos_PI, sin_PI. ring. Qed.
Lemma cos_triple x : cos (3 * x) = 4 * cos x ^ 3 - 3 * cos x.
Proof.
  replace (3 * x) with (2 * x + x) by ring. rewrite cos_plus, double_cos, sin_2a.
  replace (2 * sin x * cos x * sin x) with (2 * cos x * (sin x * sin x)) by ring.
  replace (sin x * sin x) with (1 - cos x * cos x) by (pose proof (squares x); lra). ring.
Qed.

(** What is used of theta: the cosine q of the least angle phi is below 0.6, and (b) with these p and z fails for
    a + b <= 360 - 4 phi. *)
Definition least_cos (theta : R) := 1 - 4 * cos theta ^ 2 / (1 - cos theta).
Record good_bound (theta p z : R) : Prop := {
  good_acute : 0 < theta < PI / 2;
  good_least : 0 < least_cos theta < 0.6;
  good_p : 0 < p;
  good_z : 0 < z;
  good_b : let q := least_cos theta in
    (p ^ 2 + 2 + z ^ 2 - cos theta * (2 + 2 * p * z + 4 * z)) / (2 * p) < 2 * ((1 - 2 * q ^ 2) * (3 * q - 4 * q ^ 3)) }.

Section Steps.
Variables theta p z : R.
Hypothesis good : good_bound theta p z.
Notation possible := (possible_at theta).
Let q := least_cos theta.
Let phi := acos q.
Lemma q_range : 0 < q < 0.6.
Proof. exact (good_least _ _ _ good). Qed.
Lemma cos_phi : cos phi = q.
Proof. pose proof q_range. apply cos_acos. lra. Qed.
Lemma phi_range : 7 * PI / 24 < phi < PI / 2.
Proof.
  pose proof q_range as Q. pose proof (acos_bound q) as B. fold phi in B. pose proof PI_RGT_0.
  assert (P : phi < PI / 2).
  { apply Rnot_le_lt. intros Z. pose proof (cos_le_0 phi Z ltac:(lra)). rewrite cos_phi in *. lra. }
  split; [|exact P]. apply Rnot_le_lt. intros Z.
  pose proof (cos_le (2 * phi) (PI / 3 + PI / 4) ltac:(lra) ltac:(lra) ltac:(lra)) as L.
  rewrite double_cos, cos_phi, cos_plus, cos_PI3, cos_PI4, sin_PI3, sin_PI4 in L.
  pose proof (sqrt_sqrt 2 ltac:(lra)) as S. pose proof (sqrt_lt_R0 2 ltac:(lra)) as S0. pose proof root3.
  assert (S1 : 1.41421 < sqrt 2 < 1.41422) by (split; nra).
  assert (S2 : 1 / sqrt 2 = sqrt 2 / 2) by (apply Rmult_eq_reg_r with (sqrt 2); [field_simplify; lra|lra]).
  rewrite S2 in L. assert (S3 : sqrt 3 * sqrt 2 <= 1.73206 * 1.41422) by (apply Rmult_le_compat; lra). nra.
Qed.
Lemma possible_range x : possible x -> phi <= x <= theta.
Proof.
  intros [a [b [c [d [V [H X]]]]]]. split; [|exact (H x X)]. pose proof phi_range. pose proof (Normals.angle_range a b c d x X).
  pose proof (good_acute _ _ _ good). apply angle_le; [lra|lra|]. rewrite cos_phi. exact (corollary_a a b c d theta V ltac:(lra) H x X).
Qed.
Lemma sum_range l : (forall x, In x l -> possible x) -> INR (length l) * phi <= sum l <= INR (length l) * theta.
Proof.
  induction l as [|x l IH]; intros H; [cbn; lra|]. pose proof (possible_range x (H x (or_introl eq_refl))).
  destruct (IH (fun y Y => H y (or_intror Y))). unfold sum in *. cbn [length fold_right]. rewrite S_INR. lra.
Qed.

(** Step A: angles that add up to 360 degrees are five or six. *)
Lemma valence_at l : (forall x, In x l -> possible x) -> sum l = 2 * PI -> length l = 5%nat \/ length l = 6%nat.
Proof.
  intros H S. pose proof (sum_range l H) as B. rewrite S in B. pose proof phi_range. pose proof (good_acute _ _ _ good). pose proof PI_RGT_0.
  assert (L : 4 < INR (length l) < 7).
  { split; apply Rnot_le_lt; intros Z.
    - assert (INR (length l) * theta <= 4 * theta) by (apply Rmult_le_compat_r; lra). lra.
    - assert (7 * phi <= INR (length l) * phi) by (apply Rmult_le_compat_r; lra). lra. }
  destruct L as [L1 L2]. replace 4 with (INR 4) in L1 by (cbn; lra). replace 7 with (INR 7) in L2 by (cbn; lra). apply INR_lt in L1, L2. lia.
Qed.

(** Two angles with a small sum. *)
Lemma cosines_add_up a b : phi <= a -> phi <= b -> a + b <= 2 * PI - 4 * phi -> 2 * ((1 - 2 * q ^ 2) * (3 * q - 4 * q ^ 3)) <= cos a + cos b.
Proof.
  intros A B S. pose proof phi_range. pose proof q_range as Q. rewrite form1.
  assert (C1 : - cos (2 * phi) <= cos ((a + b) / 2)) by (rewrite <- cos_turned; apply cos_le; lra).
  assert (C2 : - cos (3 * phi) <= cos ((a - b) / 2)).
  { rewrite <- cos_turned. destruct (Rle_dec b a) as [O|O].
    - apply cos_le; lra.
    - rewrite <- (cos_neg ((a - b) / 2)). apply cos_le; lra. }
  rewrite double_cos, cos_phi in C1. rewrite cos_triple, cos_phi in C2.
  assert (Q2 : 0 <= q * q <= 0.36) by nra.
  assert (D2 : 0 <= 3 * q - 4 * q ^ 3) by (replace (3 * q - 4 * q ^ 3) with (q * (3 - 4 * (q * q))) by ring; apply Rmult_le_pos; lra).
  assert (M : (1 - 2 * q ^ 2) * (3 * q - 4 * q ^ 3) <= cos ((a + b) / 2) * cos ((a - b) / 2)) by (apply Rmult_le_compat; lra). lra.
Qed.

(** Step B: no triangle uvw has two edges of valence 6.  The two tetrahedra at the triangle have the fourth vertices p
    and r; the other angles at the edge uv are those of a list of four, and so are those at the edge uw. *)
Lemma two_sixes_at u v w t r l m :
  vol (Tetrahedron u v w t) <> 0 -> all_at_most u v w t theta ->
  vol (Tetrahedron u v w r) <> 0 -> all_at_most u v w r theta ->
  length l = 4%nat -> (forall x, In x l -> possible x) -> dihedral u v w t + dihedral u v w r + sum l = 2 * PI ->
  length m = 4%nat -> (forall x, In x m -> possible x) -> dihedral u w v t + dihedral u w v r + sum m = 2 * PI -> False.
Proof.
  intros V1 H1 V2 H2 L Pl Sl M Pm Sm. destruct good as [Ac _ Pp Pz Gb]. cbv zeta in Gb. fold q in Gb.
  pose proof (corollary_b u v w t theta V1 ltac:(lra) p z Pp Pz H1) as B1. pose proof (corollary_b u v w r theta V2 ltac:(lra) p z Pp Pz H2) as B2.
  pose proof (sum_range l Pl) as Rl. pose proof (sum_range m Pm) as Rm. rewrite L in Rl. rewrite M in Rm. cbn [INR] in Rl, Rm.
  assert (P : forall s (V : vol (Tetrahedron u v w s) <> 0) (H : all_at_most u v w s theta), phi <= dihedral u v w s /\ phi <= dihedral u w v s).
  { intros s V H. split; apply possible_range; exists u, v, w, s; (split; [exact V|split; [exact H|]]); [left|right; left]; reflexivity. }
  destruct (P t V1 H1) as [P1 P2]. destruct (P r V2 H2) as [P3 P4].
  destruct (Rle_dec (dihedral u v w t + dihedral u w v t) (2 * PI - 4 * phi)) as [Z|Z].
  - pose proof (cosines_add_up _ _ P1 P2 Z). lra.
  - pose proof (cosines_add_up (dihedral u v w r) (dihedral u w v r) P3 P4 ltac:(lra)). lra.
Qed.
End Steps.

(** ** theta* *)

Notation possible := (possible_at theta_star).
Lemma star_least : least_cos theta_star = (21 - 2 * sqrt 3) / 33.
Proof.
  unfold least_cos. rewrite cos_theta_star. pose proof root3 as [S S1]. apply Rmult_eq_reg_r with (1 - sqrt 3 / 6); [|lra].
  replace ((1 - 4 * (sqrt 3 / 6) ^ 2 / (1 - sqrt 3 / 6)) * (1 - sqrt 3 / 6)) with (1 - sqrt 3 / 6 - 4 * (sqrt 3 / 6) ^ 2) by (field; lra). nra.
Qed.
Lemma star_good : good_bound theta_star 1.09 0.89.
Proof.
  pose proof root3 as [S S1]. assert (Q : 0.53139 < (21 - 2 * sqrt 3) / 33 < 0.5314) by lra.
  split; [exact T_acute|rewrite star_least; lra|lra|lra|]. rewrite star_least, cos_theta_star. cbv zeta. set (q := (21 - 2 * sqrt 3) / 33) in *.
  assert (Q2 : 0.53139 * 0.53139 <= q * q <= 0.5314 * 0.5314) by (split; apply Rmult_le_compat; lra).
  assert (Q3 : 0.53139 * 1.87 <= q * (3 - 4 * (q * q))) by (apply Rmult_le_compat; lra).
  assert (0.435 * 0.99 <= (1 - 2 * q ^ 2) * (3 * q - 4 * q ^ 3)) by (apply Rmult_le_compat; lra). lra.
Qed.
Theorem step_a_valence l : (forall x, In x l -> possible x) -> sum l = 2 * PI -> length l = 5%nat \/ length l = 6%nat.
Proof. exact (valence_at _ _ _ star_good l). Qed.
Theorem step_b_valence u v w p r l m :
  vol (Tetrahedron u v w p) <> 0 -> all_at_most u v w p theta_star ->
  vol (Tetrahedron u v w r) <> 0 -> all_at_most u v w r theta_star ->
  length l = 4%nat -> (forall x, In x l -> possible x) -> dihedral u v w p + dihedral u v w r + sum l = 2 * PI ->
  length m = 4%nat -> (forall x, In x m -> possible x) -> dihedral u w v p + dihedral u w v r + sum m = 2 * PI -> False.
Proof. exact (two_sixes_at _ _ _ star_good u v w p r l m). Qed.
