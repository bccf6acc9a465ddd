(** * What is proved of a region: definitions only

    A region is the union of N tetrahedra and of their translates by a lattice of rank r,
    with r from 0 to 3; see Statement.v, which this file continues.  Some facets of the
    tetrahedra are listed: (k, i) is the facet of P k opposite to its corner i, that is
    va, vb, vc, vd for i = 0, 1, 2, 3.  The claim does not say which region it is. *)
From Coq Require Import Reals ZArith List.
From Acutile Require Import Statement.
Open Scope R_scope.

(** The closed facet of t opposite to corner i, and its vertices. *)
Definition facet_vertices (t : tetrahedron) (i : nat) : list point :=
  match i with
  | 0 => vb t :: vc t :: vd t :: nil
  | 1 => va t :: vc t :: vd t :: nil
  | 2 => va t :: vb t :: vd t :: nil
  | _ => va t :: vb t :: vc t :: nil
  end%nat.
Definition in_facet (t : tetrahedron) (i : nat) (X : point) := exists a b c d,
  0 <= a /\ 0 <= b /\ 0 <= c /\ 0 <= d /\ a + b + c + d = 1 /\ X = combination t a b c d /\
  match i with 0 => a | 1 => b | 2 => c | _ => d end%nat = 0.
(** The convex hull of the vertices that facet i of t has in common with facet i' of t'. *)
Definition common_facet_hull (t : tetrahedron) (i : nat) (t' : tetrahedron) (i' : nat) (X : point) := exists a b c d,
  0 <= a /\ 0 <= b /\ 0 <= c /\ 0 <= d /\ a + b + c + d = 1 /\ X = combination t a b c d /\
  match i with 0 => a | 1 => b | 2 => c | _ => d end%nat = 0 /\
  (0 < a -> In (va t) (facet_vertices t' i')) /\ (0 < b -> In (vb t) (facet_vertices t' i')) /\
  (0 < c -> In (vc t) (facet_vertices t' i')) /\ (0 < d -> In (vd t) (facet_vertices t' i')).

(** The topological boundary of a set: points close to the set and to its complement. *)
Definition topological_boundary (S : point -> Prop) (X : point) :=
  (forall e, 0 < e -> exists Y, near e X Y /\ S Y) /\ (forall e, 0 < e -> exists Y, near e X Y /\ ~ S Y).

Section Regions.
Variables (l1 l2 l3 : point) (r N : nat) (P : nat -> tetrahedron) (listed : list (nat * nat)).
Notation tile := (tile l1 l2 l3 P).
Notation is_tile := (is_tile r N).

(** The region, and its boundary facets: (c, i) is the facet i of the tile c. *)
Definition in_region (X : point) := exists c, is_tile c /\ hull (tile c) X.
Definition is_boundary_facet (f : (nat * (Z * Z * Z)) * nat) := is_tile (fst f) /\ In (fst (fst f), snd f) listed.
Definition in_boundary_facet (f : (nat * (Z * Z * Z)) * nat) := in_facet (tile (fst f)) (snd f).

(** "face-to-face tiling" with the domain "region" *)
Record face_to_face_region : Prop := {
  region_basis : det l1 l2 l3 <> 0;
  region_nondegenerate : forall c, is_tile c -> vol (tile c) <> 0;
  region_locally_finite : forall M, exists F, forall c X, is_tile c -> near M origin X -> hull (tile c) X -> In c F;
  (* an inner point of one tile lies in no other tile *)
  region_interiors : forall X c c', is_tile c -> is_tile c' -> open_hull (tile c) X -> hull (tile c') X -> c = c';
  (* two tiles meet in the hull of their common vertices *)
  region_faces : forall X c c', is_tile c -> is_tile c' -> hull (tile c) X -> hull (tile c') X -> common_hull (tile c) (tile c') X;
  (* there is a boundary facet; each is a facet of a tile *)
  region_has_boundary : exists f, is_boundary_facet f;
  region_facets : forall k i, In (k, i) listed -> (k < N)%nat /\ (i < 4)%nat;
  (* the topological boundary is the union of the boundary facets *)
  region_is_bounded_by : forall X, topological_boundary in_region X <-> exists f, is_boundary_facet f /\ in_boundary_facet f X;
  (* two boundary facets meet in the hull of their common vertices *)
  region_boundary_faces : forall X f g, is_boundary_facet f -> is_boundary_facet g -> in_boundary_facet f X -> in_boundary_facet g X ->
     common_facet_hull (tile (fst f)) (snd f) (tile (fst g)) (snd g) X }.

(** "locally weakly Delaunay": if two tiles have a facet in common, that is three vertices,
    then the circumscribed ball of the first has no vertex of the second in its interior.
    "Locally Delaunay": and none on its boundary, but those that both have. *)
Definition have_a_common_facet (c c' : nat * (Z * Z * Z)) := exists u v w, u <> v /\ u <> w /\ v <> w /\
  has_vertices l1 l2 l3 r N P (u :: v :: w :: nil) c /\ has_vertices l1 l2 l3 r N P (u :: v :: w :: nil) c'.
Definition locally_weakly_delaunay := forall c c', have_a_common_facet c c' -> exists C s, circumscribed (tile c) C s /\
  forall v, In v (verts (tile c')) -> s <= distance_squared v C.
Definition locally_delaunay := forall c c', have_a_common_facet c c' -> exists C s, circumscribed (tile c) C s /\
  forall v, In v (verts (tile c')) -> s <= distance_squared v C /\ (distance_squared v C = s -> In v (verts (tile c))).
End Regions.

(** The statements about a region: those of Statement.v, and these two. *)
Inductive region_statement := Stated (s : statement) | LocallyDelaunay | LocallyWeaklyDelaunay.
Definition holds_in_region (l1 l2 l3 : point) (r N : nat) (P : nat -> tetrahedron) (s : region_statement) : Prop :=
  match s with
  | Stated s => holds l1 l2 l3 r N P s
  | LocallyDelaunay => locally_delaunay l1 l2 l3 r N P
  | LocallyWeaklyDelaunay => locally_weakly_delaunay l1 l2 l3 r N P
  end.
