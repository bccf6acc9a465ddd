(* The types of the theorems in this folder, written out: check.sh compiles this file. It fails if a theorem says
   something else. Only Coq's library and Statement.v are imported: no other file can change how this text is read.
   The sections are those of docs/lower-bound.md; angles are in radians. *)
From Coq Require Import Reals List.
From Acutile Require Import Statement.
From LowerBound Require Normals Corners Triangles Excess Steps Link Vertex Sanity.
Open Scope R_scope.

(* Section 4, Lemma 2: the faces have the names of the opposite vertices. *)
Check (LowerBound.Normals.lemma_2 : forall a b c d, vol (Tetrahedron a b c d) <> 0 -> forall xa xb xc xd,
  2 * (xc * xd * cos (dihedral a b c d) + xb * xd * cos (dihedral a c b d) + xb * xc * cos (dihedral a d b c)
     + xa * xd * cos (dihedral b c a d) + xa * xc * cos (dihedral b d a c) + xa * xb * cos (dihedral c d a b))
  <= xa ^ 2 + xb ^ 2 + xc ^ 2 + xd ^ 2).
(* (a), (b), (c), and strict *)
Check (LowerBound.Normals.corollary_a : forall a b c d theta, vol (Tetrahedron a b c d) <> 0 -> 0 <= theta < PI / 2 ->
  (forall x, In x (dihedrals (Tetrahedron a b c d)) -> x <= theta) ->
  forall x, In x (dihedrals (Tetrahedron a b c d)) -> cos x <= 1 - 4 * cos theta ^ 2 / (1 - cos theta)).
Check (LowerBound.Normals.corollary_a_strict : forall a b c d theta, vol (Tetrahedron a b c d) <> 0 -> 0 <= theta < PI / 2 ->
  (forall x, In x (dihedrals (Tetrahedron a b c d)) -> x < theta) ->
  forall x, In x (dihedrals (Tetrahedron a b c d)) -> cos x < 1 - 4 * cos theta ^ 2 / (1 - cos theta)).
Check (LowerBound.Normals.corollary_b : forall a b c d theta, vol (Tetrahedron a b c d) <> 0 -> 0 <= theta < PI / 2 ->
  forall p z, 0 < p -> 0 < z -> (forall x, In x (dihedrals (Tetrahedron a b c d)) -> x <= theta) ->
  cos (dihedral a b c d) + cos (dihedral a c b d) <= (p ^ 2 + 2 + z ^ 2 - cos theta * (2 + 2 * p * z + 4 * z)) / (2 * p)).
Check (LowerBound.Normals.corollary_b_strict : forall a b c d theta, vol (Tetrahedron a b c d) <> 0 -> 0 <= theta < PI / 2 ->
  forall p z, 0 < p -> 0 < z -> (forall x, In x (dihedrals (Tetrahedron a b c d)) -> x < theta) ->
  cos (dihedral a b c d) + cos (dihedral a c b d) < (p ^ 2 + 2 + z ^ 2 - cos theta * (2 + 2 * p * z + 4 * z)) / (2 * p)).
Check (LowerBound.Normals.corollary_c : forall a b c d theta, vol (Tetrahedron a b c d) <> 0 -> 0 <= theta < PI / 2 ->
  (forall x, In x (dihedrals (Tetrahedron a b c d)) -> x <= theta) ->
  cos (dihedral a b c d) + cos (dihedral a c b d) + cos (dihedral a d b c) <= (3 - 9 * cos theta ^ 2) / 2).
Check (LowerBound.Normals.corollary_c_strict : forall a b c d theta, vol (Tetrahedron a b c d) <> 0 -> 0 <= theta < PI / 2 ->
  (forall x, In x (dihedrals (Tetrahedron a b c d)) -> x < theta) ->
  cos (dihedral a b c d) + cos (dihedral a c b d) + cos (dihedral a d b c) < (3 - 9 * cos theta ^ 2) / 2).

(* Section 5, in the proof of Proposition 4 *)
Check (LowerBound.Normals.proposition_4_angles : forall a b c d, vol (Tetrahedron a b c d) <> 0 ->
  (forall x, In x (dihedrals (Tetrahedron a b c d)) -> x < acos ((sqrt 33 - 1) / 16)) ->
  forall x, In x (dihedrals (Tetrahedron a b c d)) -> PI / 3 < x).

(* Section 6, Steps A and B: angles of tetrahedra all of whose angles are at most theta_star *)
Definition theta_star := acos (sqrt 3 / 6).
Definition at_most_star t := forall x, In x (dihedrals t) -> x <= theta_star.
Definition possible x := exists a b c d, vol (Tetrahedron a b c d) <> 0 /\ at_most_star (Tetrahedron a b c d) /\ In x (dihedrals (Tetrahedron a b c d)).
Check (LowerBound.Steps.step_a_valence : forall l, (forall x, In x l -> possible x) -> fold_right Rplus 0 l = 2 * PI ->
  length l = 5%nat \/ length l = 6%nat).
Check (LowerBound.Steps.step_b_valence : forall u v w p r l m,
  vol (Tetrahedron u v w p) <> 0 -> at_most_star (Tetrahedron u v w p) ->
  vol (Tetrahedron u v w r) <> 0 -> at_most_star (Tetrahedron u v w r) ->
  length l = 4%nat -> (forall x, In x l -> possible x) -> dihedral u v w p + dihedral u v w r + fold_right Rplus 0 l = 2 * PI ->
  length m = 4%nat -> (forall x, In x m -> possible x) -> dihedral u w v p + dihedral u w v r + fold_right Rplus 0 m = 2 * PI -> False).

(* Section 8: what is used of a spherical triangle with the angles A, B, C and the opposite sides a, b, c *)
Definition side_rule (A B C a : R) := cos A + cos B * cos C = sin B * sin C * cos a.
Check (LowerBound.Corners.Build_spherical_triangle : forall A B C a b c,
  0 < A < PI -> 0 < B < PI -> 0 < C < PI -> 0 < a < PI -> 0 < b < PI -> 0 < c < PI ->
  side_rule A B C a -> side_rule B C A b -> side_rule C A B c -> LowerBound.Corners.spherical_triangle A B C a b c).
Notation spherical_triangle := LowerBound.Corners.spherical_triangle.
Check (LowerBound.Corners.corner : forall v p q r, vol (Tetrahedron v p q r) <> 0 ->
  spherical_triangle (dihedral v p q r) (dihedral v q r p) (dihedral v r p q)
    (angle (sub q v) (sub r v)) (angle (sub r v) (sub p v)) (angle (sub p v) (sub q v))).

(* The words of section 8: a0, x(l), the parts of the apex angle, K, C. The angle acot x in (0, 180) has the cotangent x. *)
Definition a0 theta := 2 * PI - 4 * theta.
Definition apex theta l := acos (sin theta ^ 2 * cos l - cos theta ^ 2).
Definition part g r := PI / 2 - atan (tan g * cos r).
Definition K theta := / sin (2 * theta).
Definition C theta xmin := (1 - cos theta) / 2 * tan theta * sin theta / (sin (a0 theta) * sin xmin).

(* Lemma 3 *)
Check (LowerBound.Triangles.lemma_3 : forall theta, 2 * PI / 5 < theta < 5 * PI / 12 ->
  forall a g g' l r r', spherical_triangle a g g' l r r' -> a <= theta -> g <= theta -> g' <= theta -> apex theta l <= a).
Check (LowerBound.Triangles.lemma_3_at_most : forall theta, 2 * PI / 5 < theta < 5 * PI / 12 ->
  forall A B C l m n, spherical_triangle A B C l m n -> 0 < A <= theta -> 0 < B <= theta -> 0 < C <= theta -> apex theta l <= theta).
Definition middle x := a0 theta_star <= x <= theta_star.
Check (LowerBound.Excess.lemma_3_at_least : forall A B C l m n, spherical_triangle A B C l m n -> middle A -> middle B -> middle C ->
  PI / 3 <= apex theta_star l /\ (apex theta_star l = PI / 3 -> A = a0 theta_star /\ B = a0 theta_star /\ C = a0 theta_star)).
(* Lemma 4: y(r)/2 is part theta r *)
Check (LowerBound.Triangles.lemma_4_sum : forall a g g' l r' r, spherical_triangle a g g' l r' r ->
  a < PI / 2 -> g < PI / 2 -> g' < PI / 2 -> a = part g r + part g' r').
Check (LowerBound.Triangles.lemma_4_bounds : forall theta, 2 * PI / 5 < theta < 5 * PI / 12 ->
  forall g r, PI / 4 <= g <= theta -> 0 < cos r -> part theta r <= part g r <= part theta r + K theta * (theta - g)).
(* Lemma 5 *)
Check (LowerBound.Triangles.lemma_5 : forall theta, 2 * PI / 5 < theta < 5 * PI / 12 ->
  forall a gu gt l rt ru xmin, spherical_triangle a gu gt l rt ru -> a <= theta ->
  a0 theta <= gu <= theta -> a0 theta <= gt <= theta -> 0 < xmin -> xmin <= apex theta l ->
  apex theta l / 2 - C theta xmin * (theta - gt) <= part gu ru).
Check (LowerBound.Excess.CT_below : 0 < C theta_star (PI / 3) < 1.416).
Check (LowerBound.Excess.T_range : 2 * PI / 5 < theta_star < 5 * PI / 12).

(* Section 9, Lemma 6 *)
Check (LowerBound.Excess.lemma_6_uuu : forall A B C a b c, spherical_triangle A B C a b c -> middle A -> middle B -> middle C ->
  let E x := x - a0 theta_star in
  2 * PI <= 2 * (apex theta_star a + apex theta_star b + apex theta_star c) - K theta_star * (E A + E B + E C) /\
  (2 * (apex theta_star a + apex theta_star b + apex theta_star c) - K theta_star * (E A + E B + E C) = 2 * PI -> E A = 0 /\ E B = 0 /\ E C = 0)).
Check (LowerBound.Excess.lemma_6_utt : forall A B C' a b c, spherical_triangle A B C' a b c -> middle A -> middle B -> middle C' ->
  let E x := x - a0 theta_star in
  PI <= 3 / 2 * (apex theta_star b + apex theta_star c) - K theta_star * E A - C theta_star (PI / 3) * (E B + E C') /\
  (3 / 2 * (apex theta_star b + apex theta_star c) - K theta_star * E A - C theta_star (PI / 3) * (E B + E C') = PI -> E A = 0 /\ E B = 0 /\ E C' = 0)).

(* Section 7: the tetrahedra at a vertex v. Link.v explains the words. *)
Definition tetrahedron_of {dart} v (tip : dart -> point) along d := Tetrahedron v (tip d) (tip (along d)) (tip (along (along d))).
Definition angle_of {dart} v (tip : dart -> point) along d := dihedral v (tip d) (tip (along d)) (tip (along (along d))).
Check (LowerBound.Link.Build_star : forall (dart : Type) v darts (turn along : dart -> dart) (tip : dart -> point) six,
  NoDup darts ->
  (forall d, In d darts -> In (turn d) darts) ->
  (forall d, In d darts -> In (along d) darts) ->
  (forall d, In d darts -> along (along (along d)) = d) ->
  (forall d, In d darts -> turn (along (turn (along d))) = d) ->
  (forall d, In d darts -> tip (turn d) = tip d) ->
  (forall d, In d darts -> vol (tetrahedron_of v tip along d) <> 0) ->
  (forall d, In d darts -> six (turn d) = six d) ->
  (forall d, In d darts -> six d = false -> turn (turn (turn (turn (turn d)))) = d) ->
  (forall d, In d darts -> six d = true -> turn (turn (turn (turn (turn (turn d))))) = d) ->
  (forall d, In d darts -> six d = true -> six (turn (along d)) = false) ->
  (exists d, In d darts /\ six d = true) ->
  (forall d, In d darts -> six d = false -> let a := angle_of v tip along in
    a d + a (turn d) + a (turn (turn d)) + a (turn (turn (turn d))) + a (turn (turn (turn (turn d)))) = 2 * PI) ->
  (forall d, In d darts -> six d = true -> let a := angle_of v tip along in
    a d + a (turn d) + a (turn (turn d)) + a (turn (turn (turn d))) + a (turn (turn (turn (turn d))))
    + a (turn (turn (turn (turn (turn d))))) = 2 * PI) ->
  LowerBound.Link.star dart v darts turn along tip six).
(* Section 11, Theorem 2 *)
Check (LowerBound.Link.theorem_2 : forall dart v darts turn along tip six, LowerBound.Link.star dart v darts turn along tip six ->
  exists d, In d darts /\ theta_star <= angle_of v tip along d).
(* Section 6, Step C: Theorem 1 at such a vertex *)
Check (LowerBound.Link.above_theta_star : forall dart v darts turn along tip six, LowerBound.Link.star dart v darts turn along tip six ->
  exists d, In d darts /\ exists x, In x (dihedrals (tetrahedron_of v tip along d)) /\ theta_star < x).

(* Steps A, B and C: the same with any valences, not all of them 5. [Nat.iter i turn d] is d, turned i times. *)
Check (LowerBound.Vertex.Build_vertex_star : forall (dart : Type) v darts (turn along : dart -> dart) (tip : dart -> point) valence,
  NoDup darts ->
  (forall d, In d darts -> In (turn d) darts) ->
  (forall d, In d darts -> In (along d) darts) ->
  (forall d, In d darts -> along (along (along d)) = d) ->
  (forall d, In d darts -> turn (along (turn (along d))) = d) ->
  (forall d, In d darts -> tip (turn d) = tip d) ->
  (forall d, In d darts -> vol (tetrahedron_of v tip along d) <> 0) ->
  (forall d, In d darts -> valence (turn d) = valence d) ->
  (forall d, In d darts -> Nat.iter (valence d) turn d = d) ->
  (forall d, In d darts ->
    fold_right Rplus 0 (map (angle_of v tip along) (map (fun i => Nat.iter i turn d) (seq 0 (valence d)))) = 2 * PI) ->
  LowerBound.Vertex.vertex_star dart v darts turn along tip valence).
Check (LowerBound.Vertex.theorem_1_at_a_vertex : forall dart v darts turn along tip valence,
  LowerBound.Vertex.vertex_star dart v darts turn along tip valence -> (exists d, In d darts /\ valence d <> 5%nat) ->
  exists d, In d darts /\ exists x, In x (dihedrals (tetrahedron_of v tip along d)) /\ theta_star < x).

(* Section 11: equality. A link with angles and lengths, and the example. *)
Check (LowerBound.Link.Build_link : forall (dart : Type) darts (turn along : dart -> dart) six ang len,
  NoDup darts ->
  (forall d, In d darts -> In (turn d) darts) ->
  (forall d, In d darts -> In (along d) darts) ->
  (forall d, In d darts -> along (along (along d)) = d) ->
  (forall d, In d darts -> turn (along (turn (along d))) = d) ->
  (forall d, In d darts -> six (turn d) = six d) ->
  (forall d, In d darts -> six d = false -> turn (turn (turn (turn (turn d)))) = d) ->
  (forall d, In d darts -> six d = true -> turn (turn (turn (turn (turn (turn d))))) = d) ->
  (forall d, In d darts -> six d = true -> six (turn (along d)) = false) ->
  (exists d, In d darts /\ six d = true) ->
  (forall d, In d darts -> spherical_triangle (ang d) (ang (along d)) (ang (along (along d))) (len (along d)) (len (along (along d))) (len d)) ->
  (forall d, In d darts -> len (turn (along d)) = len d) ->
  (forall d, In d darts -> six d = false ->
    ang d + ang (turn d) + ang (turn (turn d)) + ang (turn (turn (turn d))) + ang (turn (turn (turn (turn d)))) = 2 * PI) ->
  (forall d, In d darts -> six d = true ->
    ang d + ang (turn d) + ang (turn (turn d)) + ang (turn (turn (turn d))) + ang (turn (turn (turn (turn d))))
    + ang (turn (turn (turn (turn (turn d))))) = 2 * PI) ->
  LowerBound.Link.link dart darts turn along six ang len).
Check (LowerBound.Link.theorem_2_link : forall dart darts turn along six ang len, LowerBound.Link.link dart darts turn along six ang len ->
  exists d, In d darts /\ theta_star <= ang d).
Check (LowerBound.Sanity.equality_is_possible : let ang := LowerBound.Sanity.ang in let darts := seq 0 84 in
  LowerBound.Link.link nat darts LowerBound.Sanity.turn LowerBound.Sanity.along LowerBound.Sanity.six ang LowerBound.Sanity.len /\
  forall d, In d darts -> ang d <= theta_star).
