(* The types of the theorems in this folder, written out: check.sh compiles this file. It fails if a theorem says
   something else. Only Coq's library and Statement.v are imported: no other file can change how this text is read.
   The sections are those of docs/lower-bound.md; angles are in radians. *)
From Coq Require Import Reals List.
From Acutile Require Import Statement.
From LowerBound Require Normals Corners Triangles Excess Steps Link Vertex Tiling Around Theorem1 Larger Tcp Valences Sanity.
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

(* Section 1: locally finite face-to-face tilings of space, for any set of indices of tiles *)
Check (LowerBound.Tiling.Build_space_tiling : forall (index : Type) (is_tile : index -> Prop) (tile : index -> tetrahedron),
  (forall c, is_tile c -> vol (tile c) <> 0) ->
  (forall M, exists F, forall c X, is_tile c -> near M origin X -> hull (tile c) X -> In c F) ->
  (forall X, exists c, is_tile c /\ hull (tile c) X) ->
  (forall X c c', is_tile c -> is_tile c' -> open_hull (tile c) X -> hull (tile c') X -> c = c') ->
  (forall X c c', is_tile c -> is_tile c' -> hull (tile c) X -> hull (tile c') X -> common_hull (tile c) (tile c') X) ->
  LowerBound.Tiling.space_tiling is_tile tile).
Notation space_tiling := LowerBound.Tiling.space_tiling.
(* the tile c has the edge uv *)
Definition has_edge {index : Type} (is_tile : index -> Prop) (tile : index -> tetrahedron) u v c := is_tile c /\ In u (verts (tile c)) /\ In v (verts (tile c)).
(* The tiles at an edge form one cycle, and their angles add up to 360 degrees. *)
Check (@LowerBound.Around.edge_cycle : forall (index : Type) (is_tile : index -> Prop) (tile : index -> tetrahedron), space_tiling is_tile tile ->
  forall u v c0, has_edge is_tile tile u v c0 -> u <> v -> exists tiles (w : nat -> point), let n := length tiles in
  NoDup tiles /\ (forall c, In c tiles <-> has_edge is_tile tile u v c) /\
  (forall k c x, nth_error tiles k = Some c -> (In x (verts (tile c)) <-> In x (u :: v :: w k :: w (S k) :: nil))) /\
  (forall k c, nth_error tiles k = Some c -> In (dihedral u v (w k) (w (S k))) (dihedrals (tile c))) /\ w n = w 0%nat /\
  fold_right Rplus 0 (map (fun k => dihedral u v (w k) (w (S k))) (seq 0 n)) = 2 * PI).
(* The tiles at a point form a vertex_star: its tetrahedra are the tiles with the vertex v. *)
Check (@LowerBound.Around.star_in_tiling : forall (index : Type) (is_tile : index -> Prop) (tile : index -> tetrahedron), space_tiling is_tile tile ->
  forall v, exists (dart : Type) (darts : list dart) turn along tip valence, LowerBound.Vertex.vertex_star dart v darts turn along tip valence /\
  (forall d, In d darts -> exists c, is_tile c /\ forall x, In x (verts (tile c)) <-> In x (verts (tetrahedron_of v tip along d))) /\
  (forall c, is_tile c -> In v (verts (tile c)) -> exists d, In d darts /\ forall x, In x (verts (tile c)) <-> In x (verts (tetrahedron_of v tip along d)))).
(* Section 3, Lemma 1 *)
Check (@LowerBound.Theorem1.lemma_1_space : forall (index : Type) (is_tile : index -> Prop) (tile : index -> tetrahedron), space_tiling is_tile tile ->
  ~ forall u v c, has_edge is_tile tile u v c -> u <> v ->
    exists L, NoDup L /\ length L = 5%nat /\ forall c', In c' L <-> has_edge is_tile tile u v c').
(* Theorem 2 *)
Check (@LowerBound.Theorem1.theorem_2_space : forall (index : Type) (is_tile : index -> Prop) (tile : index -> tetrahedron), space_tiling is_tile tile ->
  let valence u v m := exists L, NoDup L /\ length L = m /\ forall c, In c L <-> has_edge is_tile tile u v c in forall v,
  (forall w c, has_edge is_tile tile v w c -> v <> w -> valence v w 5%nat \/ valence v w 6%nat) ->
  (forall c w w', is_tile c -> In v (verts (tile c)) -> In w (verts (tile c)) -> In w' (verts (tile c)) -> v <> w -> v <> w' -> w <> w' ->
    ~ (valence v w 6%nat /\ valence v w' 6%nat)) ->
  (exists w c, has_edge is_tile tile v w c /\ v <> w /\ valence v w 6%nat) ->
  exists c w p q, is_tile c /\ (forall x, In x (verts (tile c)) <-> In x (v :: w :: p :: q :: nil)) /\ acos (sqrt 3 / 6) <= dihedral v w p q).
(* Theorem 1 *)
Check (@LowerBound.Theorem1.theorem_1_space : forall (index : Type) (is_tile : index -> Prop) (tile : index -> tetrahedron), space_tiling is_tile tile ->
  exists c x, is_tile c /\ In x (dihedrals (tile c)) /\ acos (sqrt 3 / 6) < x).
(* The same for periodic tilings, in the words of Statement.v: Omega is all of space. *)
Check (LowerBound.Theorem1.lemma_1 : forall l1 l2 l3 (Omega : point -> Prop) N P, (forall X, Omega X) -> face_to_face_tiling l1 l2 l3 3 Omega N P ->
  ~ forall u v c, has_vertices l1 l2 l3 3 N P (u :: v :: nil) c -> u <> v -> valence l1 l2 l3 3 N P u v 5).
Check (LowerBound.Theorem1.theorem_1 : forall l1 l2 l3 (Omega : point -> Prop) N P, (forall X, Omega X) -> face_to_face_tiling l1 l2 l3 3 Omega N P ->
  exists c x, is_tile 3 N c /\ In x (dihedrals (tile l1 l2 l3 P c)) /\ acos (sqrt 3 / 6) < x).
(* Theorem 8 *)
Check (LowerBound.Larger.theorem_8_space : forall (index : Type) (is_tile : index -> Prop) (tile : index -> tetrahedron), space_tiling is_tile tile ->
  exists c x, is_tile c /\ In x (dihedrals (tile c)) /\ 73.31 * PI / 180 < x).
Check (LowerBound.Larger.theorem_8 : forall l1 l2 l3 (Omega : point -> Prop) N P, (forall X, Omega X) -> face_to_face_tiling l1 l2 l3 3 Omega N P ->
  exists c x, is_tile 3 N c /\ In x (dihedrals (tile l1 l2 l3 P c)) /\ 73.31 * PI / 180 < x).
(* Theorem 7: all valences are 5 or 6, and no triangle has two edges of valence 6 *)
Check (LowerBound.Tcp.theorem_7_space : forall (index : Type) (is_tile : index -> Prop) (tile : index -> tetrahedron), space_tiling is_tile tile ->
  let valence u v m := exists L, NoDup L /\ length L = m /\ forall c, In c L <-> has_edge is_tile tile u v c in
  (forall c u v, has_edge is_tile tile u v c -> u <> v -> valence u v 5%nat \/ valence u v 6%nat) /\
  (forall c u v w, is_tile c -> In u (verts (tile c)) -> In v (verts (tile c)) -> In w (verts (tile c)) -> u <> v -> u <> w -> v <> w ->
    ~ (valence u v 6%nat /\ valence u w 6%nat)) ->
  exists c x, is_tile c /\ In x (dihedrals (tile c)) /\ 73.44 * PI / 180 < x).
Check (LowerBound.Tcp.theorem_7 : forall l1 l2 l3 (Omega : point -> Prop) N P, (forall X, Omega X) -> face_to_face_tiling l1 l2 l3 3 Omega N P ->
  tcp l1 l2 l3 3 N P -> exists c x, is_tile 3 N c /\ In x (dihedrals (tile l1 l2 l3 P c)) /\ 73.44 * PI / 180 < x).
(* Proposition 5 *)
Check (LowerBound.Valences.proposition_5_space : forall (index : Type) (is_tile : index -> Prop) (tile : index -> tetrahedron), space_tiling is_tile tile ->
  (forall c x, is_tile c -> In x (dihedrals (tile c)) -> x < 74.7324 * PI / 180) ->
  let valence u v m := exists L, NoDup L /\ length L = m /\ forall c, In c L <-> has_edge is_tile tile u v c in
  forall u v c, has_edge is_tile tile u v c -> u <> v -> valence u v 5%nat \/ valence u v 6%nat).
(* The hypotheses are not empty: the tiling of the certificate a15. *)
Check (LowerBound.Sanity.a_tiling : exists l1 l2 l3 N P, face_to_face_tiling l1 l2 l3 3 (fun _ => True) N P /\ tcp l1 l2 l3 3 N P /\
  space_tiling (is_tile 3 N) (tile l1 l2 l3 P)).
