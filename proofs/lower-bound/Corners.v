(** * docs/lower-bound.md, section 8: the corners of tetrahedra are spherical triangles

    All angles and sides are in radians. *)
From Coq Require Import Reals Lra Psatz.
From Acutile Require Import Statement Tetrahedra Angles.
From LowerBound Require Import Normals.
Open Scope R_scope.

(** ** What is used of a spherical triangle

    The angles A, B, C and the opposite sides a, b, c: [side_rule A B C a] is the cosine rule that gives a. *)
Definition side_rule (A B C a : R) := cos A + cos B * cos C = sin B * sin C * cos a.
Record spherical_triangle (A B C a b c : R) : Prop := {
  angle_A : 0 < A < PI; angle_B : 0 < B < PI; angle_C : 0 < C < PI;
  side_a : 0 < a < PI; side_b : 0 < b < PI; side_c : 0 < c < PI;
  rule_a : side_rule A B C a; rule_b : side_rule B C A b; rule_c : side_rule C A B c }.

(** A small sphere around v cuts the tetrahedron v, p, q, r in such a triangle: its angles are
    dihedral angles, and its sides are angles between edges. *)
Lemma angle_range u w : det u w (cross u w) <> 0 -> 0 < angle u w < PI.
Proof.
  intros D.
  assert (U : 0 < dot u u) by (apply dot_self_pos; intros ->; apply D; unfold cross; unf; ring).
  assert (W : 0 < dot w w) by (apply dot_self_pos; intros ->; apply D; unfold cross; unf; ring).
  pose proof (angle_cos u w U W) as E. pose proof (acos_bound (dot u w / (norm u * norm w))) as B. fold (angle u w) in B.
  assert (L : dot u w * dot u w + det u w (cross u w) = dot u u * dot w w) by (unfold cross, dot; unf; ring).
  pose proof (norm_sqr u) as NU. pose proof (norm_sqr w) as NW.
  assert (X : cos (angle u w) * cos (angle u w) * (dot u u * dot w w) = dot u w * dot u w) by (rewrite <- E, <- NU, <- NW; ring).
  assert (K : cos (angle u w) * cos (angle u w) <> 1) by (intros K; rewrite K in X; lra).
  split; apply Rnot_le_lt; intros Z; apply K.
  - replace (angle u w) with 0 by lra. rewrite cos_0. ring.
  - replace (angle u w) with PI by lra. rewrite cos_PI. ring.
Qed.
Lemma det_cross u w p : det u w p <> 0 -> det u w (cross u w) <> 0.
Proof.
  intros H Z. apply H. assert (E : det u w p = dot (cross u w) p) by (unfold cross, dot; unf; ring).
  assert (F : dot (cross u w) (cross u w) = 0) by (rewrite <- Z; unfold cross, dot; unf; ring).
  destruct (Req_dec (det u w p) 0) as [|N]; auto. exfalso.
  assert (P : 0 < dot (cross u w) (cross u w)) by (apply dot_self_pos; intros K; apply N; rewrite E, K; unfold dot; cbn [px py pz]; ring). lra.
Qed.
(** The dihedral angle at the edge vp is also the angle between the normals, so it lies in (0, 180). *)
Lemma dihedral_range v p q r : orient v p q r <> 0 -> 0 < dihedral v p q r < PI.
Proof.
  intros H. destruct (dihedral_normals v p q r H) as [N1 [N2 E]]. pose proof (acos_bound (dot (perp (sub p v) (sub q v)) (perp (sub p v) (sub r v)) / (norm (perp (sub p v) (sub q v)) * norm (perp (sub p v) (sub r v))))) as B.
  change (0 <= dihedral v p q r <= PI) in B.
  set (n := cross (sub p v) (sub q v)) in *. set (m := cross (sub p v) (sub r v)) in *.
  pose proof (norm_sqr n) as NN. pose proof (norm_sqr m) as MM.
  assert (L : dot n m * dot n m + orient v p q r * orient v p q r * dot (sub p v) (sub p v) = dot n n * dot m m) by (unfold n, m, cross, dot; unf; ring).
  assert (P : 0 < dot (sub p v) (sub p v)) by (apply dot_self_pos; intros K; apply H; unfold orient; rewrite K; unf; ring).
  assert (O : 0 < orient v p q r * orient v p q r) by nra.
  assert (X : cos (dihedral v p q r) * cos (dihedral v p q r) * (dot n n * dot m m) = dot n m * dot n m) by (rewrite <- E, <- NN, <- MM; ring).
  assert (Q : 0 < orient v p q r * orient v p q r * dot (sub p v) (sub p v)) by (apply Rmult_lt_0_compat; lra).
  assert (K : cos (dihedral v p q r) * cos (dihedral v p q r) <> 1) by (intros K; rewrite K in X; lra).
  split; apply Rnot_le_lt; intros Z; apply K.
  - replace (dihedral v p q r) with 0 by lra. rewrite cos_0. ring.
  - replace (dihedral v p q r) with PI by lra. rewrite cos_PI. ring.
Qed.
Lemma sin_from x N : 0 < x < PI -> 0 <= N -> N * N = 1 - cos x * cos x -> sin x = N.
Proof.
  intros X P E. pose proof (sin_gt_0 x ltac:(lra) ltac:(lra)). pose proof (sin2_cos2 x) as S. unfold Rsqr in S.
  apply Rsqr_inj; unfold Rsqr; lra.
Qed.

Section Corner.
Variables v p q r : point.
Hypothesis solid : orient v p q r <> 0.
Let u := sub p v.
Let w := sub q v.
Let x := sub r v.
Let D := Rabs (det u w x).
(** The rule for the side qr and the angle at p. *)
Lemma corner_rule : side_rule (dihedral v p q r) (dihedral v q p r) (dihedral v r p q) (angle (sub q v) (sub r v)).
Proof.
  assert (S1 : orient v q p r <> 0) by (intros Z; apply solid; replace (orient v p q r) with (- orient v q p r) by (unf; ring); lra).
  assert (S2 : orient v r p q <> 0) by (intros Z; apply solid; replace (orient v p q r) with (orient v r p q) by (unf; ring); lra).
  destruct (dihedral_normals v p q r solid) as [A1 [A2 EA]]. destruct (dihedral_normals v q p r S1) as [B1 [B2 EB]].
  destruct (dihedral_normals v r p q S2) as [C1 [C2 EC]]. fold u w x in A1, A2, EA, B1, B2, EB, C1, C2, EC.
  assert (NB1 : norm (cross w u) = norm (cross u w)) by (rewrite <- norm_opp; f_equal; apply point_eq; unfold cross; unf; ring).
  assert (NC1 : norm (cross x u) = norm (cross u x)) by (rewrite <- norm_opp; f_equal; apply point_eq; unfold cross; unf; ring).
  assert (NC2 : norm (cross x w) = norm (cross w x)) by (rewrite <- norm_opp; f_equal; apply point_eq; unfold cross; unf; ring).
  rewrite NB1 in B1, EB. rewrite NC1 in C1, EC. rewrite NC2 in C2, EC.
  set (n := norm (cross u w)) in *. set (m := norm (cross u x)) in *. set (l := norm (cross w x)) in *.
  assert (PU : 0 < dot u u) by (apply dot_self_pos; intros K; apply solid; unfold orient; fold u; rewrite K; unf; ring).
  assert (PW : 0 < dot w w) by (apply dot_self_pos; intros K; apply solid; unfold orient; fold w; rewrite K; unf; ring).
  assert (PX : 0 < dot x x) by (apply dot_self_pos; intros K; apply solid; unfold orient; fold x; rewrite K; unf; ring).
  pose proof (angle_cos w x PW PX) as E. pose proof (norm_sqr w) as NW. pose proof (norm_sqr x) as NX.
  assert (PNW : 0 < norm w) by (apply sqrt_lt_R0; auto). assert (PNX : 0 < norm x) by (apply sqrt_lt_R0; auto).
  pose proof (norm_sqr (cross u w)) as NN. pose proof (norm_sqr (cross u x)) as MM. pose proof (norm_sqr (cross w x)) as LL. fold n m l in NN, MM, LL.
  assert (DD : D * D = det u w x * det u w x) by (unfold D; rewrite <- Rabs_mult; apply Rabs_pos_eq; nra).
  assert (D0 : 0 <= D) by apply Rabs_pos.
  (* the sines are triple products *)
  assert (SB : sin (dihedral v q p r) = D * norm w / (n * l)).
  { apply sin_from; [apply dihedral_range; auto| |].
    - apply Rmult_le_pos; [nra|]. left. apply Rinv_0_lt_compat. nra.
    - replace (cos (dihedral v q p r)) with (dot (cross w u) (cross w x) / (n * l)) by (rewrite <- EB; field; lra).
      replace (D * norm w / (n * l) * (D * norm w / (n * l))) with (D * D * (norm w * norm w) / ((n * n) * (l * l))) by (field; lra).
      replace (1 - dot (cross w u) (cross w x) / (n * l) * (dot (cross w u) (cross w x) / (n * l)))
        with ((n * n * (l * l) - dot (cross w u) (cross w x) * dot (cross w u) (cross w x)) / (n * n * (l * l))) by (field; lra).
      f_equal. rewrite DD, NW, NN, LL. unfold cross, dot. unf. ring. }
  assert (SC : sin (dihedral v r p q) = D * norm x / (m * l)).
  { apply sin_from; [apply dihedral_range; auto| |].
    - apply Rmult_le_pos; [nra|]. left. apply Rinv_0_lt_compat. nra.
    - replace (cos (dihedral v r p q)) with (dot (cross x u) (cross x w) / (m * l)) by (rewrite <- EC; field; lra).
      replace (D * norm x / (m * l) * (D * norm x / (m * l))) with (D * D * (norm x * norm x) / ((m * m) * (l * l))) by (field; lra).
      replace (1 - dot (cross x u) (cross x w) / (m * l) * (dot (cross x u) (cross x w) / (m * l)))
        with ((m * m * (l * l) - dot (cross x u) (cross x w) * dot (cross x u) (cross x w)) / (m * m * (l * l))) by (field; lra).
      f_equal. rewrite DD, NX, MM, LL. unfold cross, dot. unf. ring. }
  unfold side_rule. fold w x. rewrite SB, SC.
  replace (cos (dihedral v p q r)) with (dot (cross u w) (cross u x) / (n * m)) by (rewrite <- EA; field; lra).
  replace (cos (dihedral v q p r)) with (dot (cross w u) (cross w x) / (n * l)) by (rewrite <- EB; field; lra).
  replace (cos (dihedral v r p q)) with (dot (cross x u) (cross x w) / (m * l)) by (rewrite <- EC; field; lra).
  replace (D * norm w / (n * l) * (D * norm x / (m * l)) * cos (angle w x))
    with (D * D * (cos (angle w x) * (norm w * norm x)) / (n * m * (l * l))) by (field; lra).
  rewrite E, DD.
  replace (dot (cross u w) (cross u x) / (n * m) + dot (cross w u) (cross w x) / (n * l) * (dot (cross x u) (cross x w) / (m * l)))
    with ((dot (cross u w) (cross u x) * (l * l) + dot (cross w u) (cross w x) * dot (cross x u) (cross x w)) / (n * m * (l * l))) by (field; lra).
  f_equal. rewrite LL. unfold cross, dot. unf. ring.
Qed.
End Corner.

Lemma dihedral_sym v p q r : dihedral v p q r = dihedral v p r q.
Proof. unfold dihedral, angle. rewrite (Rmult_comm (norm _)). do 2 f_equal. unfold dot. ring. Qed.
Lemma angle_sym u w : angle u w = angle w u.
Proof. unfold angle. rewrite (Rmult_comm (norm _)). do 2 f_equal. unfold dot. ring. Qed.

Theorem corner v p q r : orient v p q r <> 0 ->
  spherical_triangle (dihedral v p q r) (dihedral v q r p) (dihedral v r p q)
    (angle (sub q v) (sub r v)) (angle (sub r v) (sub p v)) (angle (sub p v) (sub q v)).
Proof.
  intros H.
  assert (H1 : orient v q r p <> 0) by (intros Z; apply H; replace (orient v p q r) with (orient v q r p) by (unf; ring); lra).
  assert (H2 : orient v r p q <> 0) by (intros Z; apply H; replace (orient v p q r) with (orient v r p q) by (unf; ring); lra).
  split; try (apply dihedral_range; assumption).
  - apply angle_range, det_cross with (sub p v). intros Z. apply H1. exact Z.
  - apply angle_range, det_cross with (sub q v). intros Z. apply H2. exact Z.
  - apply angle_range, det_cross with (sub r v). intros Z. apply H. exact Z.
  - rewrite (dihedral_sym v q r p). apply corner_rule. auto.
  - rewrite (dihedral_sym v r p q). apply corner_rule; auto.
  - rewrite (dihedral_sym v p q r). apply corner_rule; auto.
Qed.
