(** * docs/lower-bound.md, section 4: Lemma 2, the normals of a tetrahedron

    The faces have the names of the opposite vertices: the edge ab lies on the faces c and d.
    So [dihedral a b c d] of Statement.v is the angle between the faces c and d. *)
From Coq Require Import Reals Lra List Psatz.
From Acutile Require Import Statement Tetrahedra Angles.
Open Scope R_scope.

(** ** The normals *)

Definition cross (u w : point) := Point (py u * pz w - pz u * py w) (pz u * px w - px u * pz w) (px u * py w - py u * px w).

Lemma norm_sqr u : norm u * norm u = dot u u.
Proof. apply sqrt_sqrt. unfold dot. nra. Qed.
Lemma norm_opp u : norm (scale (-1) u) = norm u.
Proof. unfold norm. f_equal. unfold dot. unf. ring. Qed.

(** The dihedral angle is the angle between the normals of the two half planes. *)
Lemma dihedral_normals a b c d : orient a b c d <> 0 ->
  let n := cross (sub b a) (sub c a) in let m := cross (sub b a) (sub d a) in
  0 < norm n /\ 0 < norm m /\ cos (dihedral a b c d) * (norm n * norm m) = dot n m.
Proof.
  intros H n m. destruct (dihedral_cos a b c d H) as [s [S1 [S2 S3]]].
  pose proof (A_pos a b c d H) as PA. pose proof (B_pos a b c d H) as PB.
  assert (EA : acpoly dot (sub b a) (sub c a) (sub c a) = dot n n) by (unfold n, cross, acpoly, dot; unf; ring).
  assert (EB : acpoly dot (sub b a) (sub d a) (sub d a) = dot m m) by (unfold m, cross, acpoly, dot; unf; ring).
  assert (EC : acpoly dot (sub b a) (sub c a) (sub d a) = dot n m) by (unfold n, m, cross, acpoly, dot; unf; ring).
  rewrite EA, EB in S2. rewrite EC in S3. rewrite EA in PA. rewrite EB in PB.
  assert (PN : 0 < norm n) by (apply sqrt_lt_R0; lra).
  assert (PM : 0 < norm m) by (apply sqrt_lt_R0; lra).
  repeat split; auto. rewrite <- S3. f_equal.
  assert (P : 0 < norm n * norm m) by (apply Rmult_lt_0_compat; auto).
  assert (Q : (norm n * norm m) * (norm n * norm m) = s * s) by (rewrite S2, <- (norm_sqr n), <- (norm_sqr m); ring).
  apply Rsqr_inj; unfold Rsqr; lra.
Qed.

Lemma dot_scale s r u w : dot (scale s u) (scale r w) = s * r * dot u w.
Proof. unfold dot. unf. ring. Qed.
Lemma dot_four A B C D : dot (add (add A B) (add C D)) (add (add A B) (add C D)) =
  dot A A + dot B B + dot C C + dot D D + 2 * (dot C D + dot B D + dot B C + dot A D + dot A C + dot A B).
Proof. unfold dot. unf. ring. Qed.

(** ** Lemma 2 *)

Section Tetrahedron.
Variables a b c d : point.
Hypothesis solid : orient a b c d <> 0.

(** The angle at the edge ab, and so on. *)
Definition ab := dihedral a b c d.
Definition ac := dihedral a c b d.
Definition ad := dihedral a d b c.
Definition bc := dihedral b c a d.
Definition bd := dihedral b d a c.
Definition cd := dihedral c d a b.
Lemma the_six : dihedrals (Tetrahedron a b c d) = ab :: ac :: ad :: bc :: bd :: cd :: nil.
Proof. reflexivity. Qed.

(** Normals of the faces, all outward or all inward. *)
Let nd := cross (sub b a) (sub c a).
Let nb := cross (sub c a) (sub d a).
Let nc := cross (sub d a) (sub b a).
Let na := cross (sub d b) (sub c b).

Lemma signed p q r s N M : orient p q r s <> 0 ->
  let n := cross (sub q p) (sub r p) in let m := cross (sub q p) (sub s p) in
  (n = scale (-1) M /\ m = N) \/ (n = M /\ m = scale (-1) N) ->
  0 < norm N /\ 0 < norm M /\ cos (dihedral p q r s) * (norm N * norm M) = - dot N M.
Proof.
  intros O n m H. destruct (dihedral_normals p q r s O) as [P1 [P2 E]]. fold n m in P1, P2, E.
  assert (F : cos (dihedral p q r s) * (norm N * norm M) = - dot N M /\ norm n = norm M /\ norm m = norm N).
  { destruct H as [[X Y]|[X Y]]; rewrite X, Y in E |- *; rewrite norm_opp in E |- *; repeat split; auto.
    - rewrite Rmult_comm with (r1 := norm N), E. unfold dot. unf. ring.
    - rewrite Rmult_comm with (r1 := norm N), E. unfold dot. unf. ring. }
  destruct F as [F [X Y]]. rewrite X in P1. rewrite Y in P2. repeat split; assumption.
Qed.
Ltac same := apply point_eq; unfold na, nb, nc, nd, cross; unf; ring.
Ltac turned := let H := fresh in intros H; apply solid; match type of H with ?x = 0 =>
  first [replace (orient a b c d) with x by (unf; ring) | replace (orient a b c d) with (- x) by (unf; ring)] end; lra.

Lemma outward : 0 < norm na /\ 0 < norm nb /\ 0 < norm nc /\ 0 < norm nd /\
  cos ab * (norm nc * norm nd) = - dot nc nd /\ cos ac * (norm nb * norm nd) = - dot nb nd /\
  cos ad * (norm nb * norm nc) = - dot nb nc /\ cos bc * (norm na * norm nd) = - dot na nd /\
  cos bd * (norm na * norm nc) = - dot na nc /\ cos cd * (norm na * norm nb) = - dot na nb.
Proof.
  pose proof (signed a b c d nc nd solid ltac:(right; split; same)) as [_ [_ E1]].
  pose proof (signed a c b d nb nd ltac:(turned) ltac:(left; split; same)) as [B [D E2]].
  pose proof (signed a d b c nb nc ltac:(turned) ltac:(right; split; same)) as [_ [C E3]].
  pose proof (signed b c a d na nd ltac:(turned) ltac:(right; split; same)) as [A [_ E4]].
  pose proof (signed b d a c na nc ltac:(turned) ltac:(left; split; same)) as [_ [_ E5]].
  pose proof (signed c d a b na nb ltac:(turned) ltac:(right; split; same)) as [_ [_ E6]].
  repeat split; assumption.
Qed.

Theorem lemma_2 xa xb xc xd :
  2 * (xc * xd * cos ab + xb * xd * cos ac + xb * xc * cos ad + xa * xd * cos bc + xa * xc * cos bd + xa * xb * cos cd)
  <= xa ^ 2 + xb ^ 2 + xc ^ 2 + xd ^ 2.
Proof.
  destruct outward as [A [B [C [D [E1 [E2 [E3 [E4 [E5 E6]]]]]]]]].
  pose proof (norm_sqr na) as NA. pose proof (norm_sqr nb) as NB. pose proof (norm_sqr nc) as NC. pose proof (norm_sqr nd) as ND.
  set (P := scale (xa / norm na) na). set (Q := scale (xb / norm nb) nb).
  set (V := scale (xc / norm nc) nc). set (W := scale (xd / norm nd) nd).
  assert (T : 0 <= dot (add (add P Q) (add V W)) (add (add P Q) (add V W))) by (unfold dot; nra).
  rewrite dot_four in T. unfold P, Q, V, W in T. rewrite !dot_scale in T.
  rewrite <- NA, <- NB, <- NC, <- ND in T.
  replace (dot nc nd) with (- (cos ab * (norm nc * norm nd))) in T by lra.
  replace (dot nb nd) with (- (cos ac * (norm nb * norm nd))) in T by lra.
  replace (dot nb nc) with (- (cos ad * (norm nb * norm nc))) in T by lra.
  replace (dot na nd) with (- (cos bc * (norm na * norm nd))) in T by lra.
  replace (dot na nc) with (- (cos bd * (norm na * norm nc))) in T by lra.
  replace (dot na nb) with (- (cos cd * (norm na * norm nb))) in T by lra.
  match type of T with 0 <= ?x => replace x with (xa ^ 2 + xb ^ 2 + xc ^ 2 + xd ^ 2
    - 2 * (xc * xd * cos ab + xb * xd * cos ac + xb * xc * cos ad + xa * xd * cos bc + xa * xc * cos bd + xa * xb * cos cd)) in T end.
  - lra.
  - field. repeat split; lra.
Qed.
End Tetrahedron.

(** ** The corollaries (a), (b), (c), and their strict forms *)

Section Corollaries.
Variables (a b c d : point) (theta : R).
Hypothesis solid : orient a b c d <> 0.
Hypothesis acute : 0 <= theta < PI / 2.
Let k := cos theta.
Let t := Tetrahedron a b c d.
Definition all_at_most := forall x, In x (dihedrals t) -> x <= theta.
Definition all_below := forall x, In x (dihedrals t) -> x < theta.

Lemma below_at_most : all_below -> all_at_most.
Proof. intros H x X. specialize (H x X). lra. Qed.
Lemma k_positive : 0 < k.
Proof. apply cos_gt_0; lra. Qed.
Lemma angle_range x : In x (dihedrals t) -> 0 <= x <= PI.
Proof. unfold t. rewrite the_six. simpl. intros [<-|[<-|[<-|[<-|[<-|[<-|[]]]]]]]; apply acos_bound. Qed.
Lemma cosines_at_least : all_at_most -> forall x, In x (dihedrals t) -> k <= cos x.
Proof. intros H x X. pose proof (angle_range x X). specialize (H x X). apply cos_decr_1; lra. Qed.
Lemma cosines_above : all_below -> forall x, In x (dihedrals t) -> k < cos x.
Proof. intros H x X. pose proof (angle_range x X). specialize (H x X). apply cos_decreasing_1; lra. Qed.

(** The six cosines and the inequality between them, in a form for lra and nra. *)
Ltac six H :=
  pose proof (H (ab a b c d) ltac:(unfold t; rewrite the_six; simpl; auto 10));
  pose proof (H (ac a b c d) ltac:(unfold t; rewrite the_six; simpl; auto 10));
  pose proof (H (ad a b c d) ltac:(unfold t; rewrite the_six; simpl; auto 10));
  pose proof (H (bc a b c d) ltac:(unfold t; rewrite the_six; simpl; auto 10));
  pose proof (H (bd a b c d) ltac:(unfold t; rewrite the_six; simpl; auto 10));
  pose proof (H (cd a b c d) ltac:(unfold t; rewrite the_six; simpl; auto 10)).

Lemma k_below_1 : all_at_most -> k < 1.
Proof.
  intros H. pose proof (cosines_at_least H) as Q. six Q. pose proof k_positive.
  pose proof (lemma_2 a b c d solid 1 1 1 1). lra.
Qed.

Section A.
Let y := 2 * k / (1 - k).
Lemma y_is : k < 1 -> 0 < y /\ y * (1 - k) = 2 * k /\ 1 - 4 * k ^ 2 / (1 - k) = 1 - 2 * k * y.
Proof. intros K. pose proof k_positive. unfold y. split; [apply Rdiv_lt_0_compat; lra|]. split; field; lra. Qed.

Theorem corollary_a : all_at_most -> forall x, In x (dihedrals t) -> cos x <= 1 - 4 * k ^ 2 / (1 - k).
Proof.
  intros H x X. pose proof (cosines_at_least H) as Q. pose proof k_positive.
  pose proof (k_below_1 H) as K. destruct (y_is K) as [Y1 [Y2 ->]].
  six Q. assert (Y3 : y * y * (1 - k) = 2 * k * y) by (rewrite Rmult_assoc, Y2; ring).
  unfold t in X. rewrite the_six in X. simpl in X. destruct X as [<-|[<-|[<-|[<-|[<-|[<-|[]]]]]]];
  [pose proof (lemma_2 a b c d solid y y 1 1) | pose proof (lemma_2 a b c d solid y 1 y 1)
  |pose proof (lemma_2 a b c d solid y 1 1 y) | pose proof (lemma_2 a b c d solid 1 y y 1)
  |pose proof (lemma_2 a b c d solid 1 y 1 y) | pose proof (lemma_2 a b c d solid 1 1 y y)];
  assert (forall z, k <= z -> y * k <= y * z /\ y * y * k <= y * y * z) as M by (intros z Z; split; apply Rmult_le_compat_l; nra);
  repeat match goal with L : k <= cos _ |- _ => apply M in L; destruct L end; nra.
Qed.
Theorem corollary_a_strict : all_below -> forall x, In x (dihedrals t) -> cos x < 1 - 4 * k ^ 2 / (1 - k).
Proof.
  intros H x X. pose proof (cosines_above H) as Q. pose proof k_positive.
  pose proof (k_below_1 (below_at_most H)) as K. destruct (y_is K) as [Y1 [Y2 ->]].
  six Q. assert (Y3 : y * y * (1 - k) = 2 * k * y) by (rewrite Rmult_assoc, Y2; ring).
  unfold t in X. rewrite the_six in X. simpl in X. destruct X as [<-|[<-|[<-|[<-|[<-|[<-|[]]]]]]];
  [pose proof (lemma_2 a b c d solid y y 1 1) | pose proof (lemma_2 a b c d solid y 1 y 1)
  |pose proof (lemma_2 a b c d solid y 1 1 y) | pose proof (lemma_2 a b c d solid 1 y y 1)
  |pose proof (lemma_2 a b c d solid 1 y 1 y) | pose proof (lemma_2 a b c d solid 1 1 y y)];
  assert (forall z, k < z -> y * k < y * z /\ y * y * k < y * y * z) as M by (intros z Z; split; apply Rmult_lt_compat_l; nra);
  repeat match goal with L : k < cos _ |- _ => apply M in L; destruct L end; nra.
Qed.
End A.

(** The angles at two edges of the face abc. *)
Theorem corollary_b p z : 0 < p -> 0 < z -> all_at_most ->
  cos (dihedral a b c d) + cos (dihedral a c b d) <= (p ^ 2 + 2 + z ^ 2 - k * (2 + 2 * p * z + 4 * z)) / (2 * p).
Proof.
  intros P Z H. pose proof (cosines_at_least H) as Q. six Q.
  pose proof (lemma_2 a b c d solid z 1 1 p) as L. fold (ab a b c d) (ac a b c d).
  apply Rmult_le_reg_l with (2 * p); [lra|].
  replace (2 * p * (_ / _)) with (p ^ 2 + 2 + z ^ 2 - k * (2 + 2 * p * z + 4 * z)) by (field; lra).
  assert (forall w, k <= w -> z * k <= z * w) as M by (intros; apply Rmult_le_compat_l; lra).
  assert (forall w, k <= w -> p * z * k <= p * z * w) as N by (intros; apply Rmult_le_compat_l; nra).
  pose proof (M (cos (bd a b c d)) ltac:(assumption)). pose proof (M (cos (cd a b c d)) ltac:(assumption)).
  pose proof (N (cos (bc a b c d)) ltac:(assumption)). nra.
Qed.
Theorem corollary_b_strict p z : 0 < p -> 0 < z -> all_below ->
  cos (dihedral a b c d) + cos (dihedral a c b d) < (p ^ 2 + 2 + z ^ 2 - k * (2 + 2 * p * z + 4 * z)) / (2 * p).
Proof.
  intros P Z H. pose proof (cosines_above H) as Q. six Q.
  pose proof (lemma_2 a b c d solid z 1 1 p) as L. fold (ab a b c d) (ac a b c d).
  apply Rmult_lt_reg_l with (2 * p); [lra|].
  replace (2 * p * (_ / _)) with (p ^ 2 + 2 + z ^ 2 - k * (2 + 2 * p * z + 4 * z)) by (field; lra).
  assert (forall w, k < w -> z * k < z * w) as M by (intros; apply Rmult_lt_compat_l; lra).
  assert (forall w, k < w -> p * z * k < p * z * w) as N by (intros; apply Rmult_lt_compat_l; nra).
  pose proof (M (cos (bd a b c d)) ltac:(assumption)). pose proof (M (cos (cd a b c d)) ltac:(assumption)).
  pose proof (N (cos (bc a b c d)) ltac:(assumption)). nra.
Qed.

(** The angles at the three edges of the vertex a. *)
Theorem corollary_c : all_at_most ->
  cos (dihedral a b c d) + cos (dihedral a c b d) + cos (dihedral a d b c) <= (3 - 9 * k ^ 2) / 2.
Proof.
  intros H. pose proof (cosines_at_least H) as Q. six Q. pose proof k_positive.
  pose proof (lemma_2 a b c d solid (3 * k) 1 1 1) as L. fold (ab a b c d) (ac a b c d) (ad a b c d).
  assert (forall w, k <= w -> 3 * k * k <= 3 * k * w) as M by (intros; apply Rmult_le_compat_l; lra).
  pose proof (M (cos (bc a b c d)) ltac:(assumption)). pose proof (M (cos (bd a b c d)) ltac:(assumption)).
  pose proof (M (cos (cd a b c d)) ltac:(assumption)). lra.
Qed.
Theorem corollary_c_strict : all_below ->
  cos (dihedral a b c d) + cos (dihedral a c b d) + cos (dihedral a d b c) < (3 - 9 * k ^ 2) / 2.
Proof.
  intros H. pose proof (cosines_above H) as Q. six Q. pose proof k_positive.
  pose proof (lemma_2 a b c d solid (3 * k) 1 1 1) as L. fold (ab a b c d) (ac a b c d) (ad a b c d).
  assert (forall w, k < w -> 3 * k * k < 3 * k * w) as M by (intros; apply Rmult_lt_compat_l; lra).
  pose proof (M (cos (bc a b c d)) ltac:(assumption)). pose proof (M (cos (bd a b c d)) ltac:(assumption)).
  pose proof (M (cos (cd a b c d)) ltac:(assumption)). lra.
Qed.
End Corollaries.

(** ** Section 5, the algebraic part of Proposition 4

    A tetrahedron with all angles below theta1 has all angles above 60 degrees. *)
Theorem proposition_4_angles a b c d : orient a b c d <> 0 ->
  all_below a b c d (acos ((sqrt 33 - 1) / 16)) -> forall x, In x (dihedrals (Tetrahedron a b c d)) -> PI / 3 < x.
Proof.
  intros O H x X. pose proof (sqrt_sqrt 33 ltac:(lra)) as S. pose proof (sqrt_lt_R0 33 ltac:(lra)) as S0.
  assert (S1 : 5 < sqrt 33 < 6) by (split; nra).
  set (k := (sqrt 33 - 1) / 16) in *. assert (K : 0 < k < 1) by (unfold k; lra).
  assert (E : cos (acos k) = k) by (apply cos_acos; lra).
  assert (T : 0 <= acos k < PI / 2).
  { pose proof (acos_bound k). split; [lra|]. apply Rnot_le_lt. intros L. pose proof PI_RGT_0.
    pose proof (cos_le_0 (acos k) L ltac:(lra)). lra. }
  pose proof (corollary_a_strict a b c d (acos k) O T H x X) as L. rewrite E in L.
  replace (1 - 4 * k ^ 2 / (1 - k)) with (1 / 2) in L.
  - pose proof (angle_range a b c d x X). pose proof PI_RGT_0. rewrite <- cos_PI3 in L. apply cos_decreasing_0; lra.
  - apply Rmult_eq_reg_r with (1 - k); [|lra]. replace ((1 - 4 * k ^ 2 / (1 - k)) * (1 - k)) with (1 - k - 4 * k ^ 2) by (field; lra).
    unfold k. nra.
Qed.

(** ** Section 6: theta*, and what (c) gives there *)

Definition theta_star := acos (sqrt 3 / 6).
Lemma root3 : sqrt 3 * sqrt 3 = 3 /\ 1.73205 < sqrt 3 < 1.73206.
Proof. pose proof (sqrt_sqrt 3 ltac:(lra)). pose proof (sqrt_lt_R0 3 ltac:(lra)). repeat split; nra. Qed.
Lemma cos_theta_star : cos theta_star = sqrt 3 / 6.
Proof. pose proof root3. apply cos_acos. lra. Qed.
Lemma theta_star_acute : 0 <= theta_star < PI / 2.
Proof.
  pose proof root3. pose proof cos_theta_star as E. unfold theta_star in *. pose proof (acos_bound (sqrt 3 / 6)). pose proof PI_RGT_0.
  split; [lra|]. apply Rnot_le_lt. intros L. pose proof (cos_le_0 _ L ltac:(lra)). lra.
Qed.

(** Step C: the angles at the three edges from a vertex do not all have the cosine 7/18, that of a0. *)
Theorem step_c a b c d : orient a b c d <> 0 -> all_at_most a b c d theta_star ->
  ~ (cos (dihedral a b c d) = 7 / 18 /\ cos (dihedral a c b d) = 7 / 18 /\ cos (dihedral a d b c) = 7 / 18).
Proof.
  intros O H [A [B C]]. pose proof (corollary_c a b c d theta_star O theta_star_acute H) as L. rewrite cos_theta_star, A, B, C in L.
  pose proof root3. lra.
Qed.
