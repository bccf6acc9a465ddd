(** * What is proved of a region of the plane: definitions only

    The counterpart of RegionStatement.v in dimension two, and written the same way.  A facet
    of a triangle is one of its sides: (k, i) is the side of P k opposite to its corner i,
    that is ta, tb, tc for i = 0, 1, 2. *)
From Coq Require Import Reals ZArith List.
From Acutile Require Import Statement PlaneStatement RegionStatement.
Open Scope R_scope.

(** The closed side of t opposite to corner i, and its ends. *)
Definition side_ends (t : triangle2) (i : nat) : list point2 :=
  match i with 0 => tb t :: tc t :: nil | 1 => ta t :: tc t :: nil | _ => ta t :: tb t :: nil end%nat.
Definition in_side (t : triangle2) (i : nat) (X : point2) := exists a b c,
  0 <= a /\ 0 <= b /\ 0 <= c /\ a + b + c = 1 /\ X = combination2 t a b c /\
  match i with 0 => a | 1 => b | _ => c end%nat = 0.
(** The convex hull of the ends that side i of t has in common with side i' of t'. *)
Definition common_side_hull (t : triangle2) (i : nat) (t' : triangle2) (i' : nat) (X : point2) := exists a b c,
  0 <= a /\ 0 <= b /\ 0 <= c /\ a + b + c = 1 /\ X = combination2 t a b c /\
  match i with 0 => a | 1 => b | _ => c end%nat = 0 /\
  (0 < a -> In (ta t) (side_ends t' i')) /\ (0 < b -> In (tb t) (side_ends t' i')) /\ (0 < c -> In (tc t) (side_ends t' i')).
Definition topological_boundary2 (S : point2 -> Prop) (X : point2) :=
  (forall e, 0 < e -> exists Y, near2 e X Y /\ S Y) /\ (forall e, 0 < e -> exists Y, near2 e X Y /\ ~ S Y).

Section Regions.
Variables (l1 l2 : point2) (r N : nat) (P : nat -> triangle2) (listed : list (nat * nat)).
Notation tile2 := (tile2 l1 l2 P).
Notation is_tile2 := (is_tile2 r N).

Definition in_region2 (X : point2) := exists c, is_tile2 c /\ hull2 (tile2 c) X.
Definition is_boundary_side (f : (nat * (Z * Z)) * nat) := is_tile2 (fst f) /\ In (fst (fst f), snd f) listed.
Definition in_boundary_side (f : (nat * (Z * Z)) * nat) := in_side (tile2 (fst f)) (snd f).

(** "face-to-face tiling" with the domain "region": see RegionStatement.v for the meaning of each member. *)
Record edge_to_edge_region : Prop := {
  region_basis2 : det2 l1 l2 <> 0;
  region_nondegenerate2 : forall c, is_tile2 c -> area (tile2 c) <> 0;
  region_locally_finite2 : forall M, exists F, forall c X, is_tile2 c -> near2 M origin2 X -> hull2 (tile2 c) X -> In c F;
  region_interiors2 : forall X c c', is_tile2 c -> is_tile2 c' -> open_hull2 (tile2 c) X -> hull2 (tile2 c') X -> c = c';
  region_edges2 : forall X c c', is_tile2 c -> is_tile2 c' -> hull2 (tile2 c) X -> hull2 (tile2 c') X -> common_hull2 (tile2 c) (tile2 c') X;
  region_has_boundary2 : exists f, is_boundary_side f;
  region_sides2 : forall k i, In (k, i) listed -> (k < N)%nat /\ (i < 3)%nat;
  region_is_bounded_by2 : forall X, topological_boundary2 in_region2 X <-> exists f, is_boundary_side f /\ in_boundary_side f X;
  region_boundary_sides2 : forall X f g, is_boundary_side f -> is_boundary_side g -> in_boundary_side f X -> in_boundary_side g X ->
     common_side_hull (tile2 (fst f)) (snd f) (tile2 (fst g)) (snd g) X }.

(** "locally weakly Delaunay", "locally Delaunay": two tiles have a side in common. *)
Definition have_a_common_side (c c' : nat * (Z * Z)) := is_tile2 c /\ is_tile2 c' /\ exists u v, u <> v /\
  In u (corners (tile2 c)) /\ In v (corners (tile2 c)) /\ In u (corners (tile2 c')) /\ In v (corners (tile2 c')).
Definition locally_weakly_delaunay2 := forall c c', have_a_common_side c c' -> exists C s, circumscribed2 (tile2 c) C s /\
  forall v, In v (corners (tile2 c')) -> s <= distance_squared2 v C.
Definition locally_delaunay2 := forall c c', have_a_common_side c c' -> exists C s, circumscribed2 (tile2 c) C s /\
  forall v, In v (corners (tile2 c')) -> s <= distance_squared2 v C /\ (distance_squared2 v C = s -> In v (corners (tile2 c))).
End Regions.

Definition holds_in_region2 (l1 l2 : point2) (r N : nat) (P : nat -> triangle2) (s : region_statement) : Prop :=
  match s with
  | Stated s => holds2 l1 l2 r N P s
  | LocallyDelaunay => locally_delaunay2 l1 l2 r N P
  | LocallyWeaklyDelaunay => locally_weakly_delaunay2 l1 l2 r N P
  end.
