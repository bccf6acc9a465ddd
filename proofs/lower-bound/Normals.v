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
