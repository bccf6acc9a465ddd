(** * The plane: every definition that gives the theorem its meaning there

    The counterpart of Statement.v in dimension two, and written the same way:
    definitions, and not a single proof. *)

From Coq Require Import Reals ZArith List.
From Acutile Require Import Statement.
Open Scope R_scope.

(** ** The Euclidean plane *)

Record point2 := Point2 { x2 : R; y2 : R }.
Definition origin2 := Point2 0 0.
Definition add2 (u v : point2) := Point2 (x2 u + x2 v) (y2 u + y2 v).
Definition sub2 (u v : point2) := Point2 (x2 u - x2 v) (y2 u - y2 v).
Definition scale2 (s : R) (u : point2) := Point2 (s * x2 u) (s * y2 u).
Definition dot2 (u v : point2) := x2 u * x2 v + y2 u * y2 v.
Definition norm2 (u : point2) := sqrt (dot2 u u).
Definition distance_squared2 (x y : point2) := dot2 (sub2 x y) (sub2 x y).
Definition det2 (u v : point2) := x2 u * y2 v - y2 u * x2 v.

(** ** Triangles *)

Record triangle2 := Triangle2 { ta : point2; tb : point2; tc : point2 }.
Definition corners (t : triangle2) := ta t :: tb t :: tc t :: nil.
(** Twice the signed area, whatever the name. *)
Definition area (t : triangle2) := det2 (sub2 (tb t) (ta t)) (sub2 (tc t) (ta t)).
Definition combination2 (t : triangle2) (a b c : R) := add2 (add2 (scale2 a (ta t)) (scale2 b (tb t))) (scale2 c (tc t)).
(** The closed triangle, the open triangle, the hull of the corners that t has in common with t'. *)
Definition hull2 (t : triangle2) (X : point2) := exists a b c,
  0 <= a /\ 0 <= b /\ 0 <= c /\ a + b + c = 1 /\ X = combination2 t a b c.
Definition open_hull2 (t : triangle2) (X : point2) := exists a b c,
  0 < a /\ 0 < b /\ 0 < c /\ a + b + c = 1 /\ X = combination2 t a b c.
Definition common_hull2 (t t' : triangle2) (X : point2) := exists a b c,
  0 <= a /\ 0 <= b /\ 0 <= c /\ a + b + c = 1 /\ X = combination2 t a b c /\
  (0 < a -> In (ta t) (corners t')) /\ (0 < b -> In (tb t) (corners t')) /\ (0 < c -> In (tc t) (corners t')).
Definition translate2 (u : point2) (t : triangle2) := Triangle2 (add2 (ta t) u) (add2 (tb t) u) (add2 (tc t) u).
Definition near2 (e : R) (x y : point2) := Rabs (x2 y - x2 x) < e /\ Rabs (y2 y - y2 x) < e.

(** The angle between two vectors; the three angles of t, the squares of its three sides. *)
Definition angle2 (u w : point2) := acos (dot2 u w / (norm2 u * norm2 w)).
Definition angles2 (t : triangle2) : list R :=
  angle2 (sub2 (tb t) (ta t)) (sub2 (tc t) (ta t)) ::
  angle2 (sub2 (ta t) (tb t)) (sub2 (tc t) (tb t)) ::
  angle2 (sub2 (ta t) (tc t)) (sub2 (tb t) (tc t)) :: nil.
Definition squared_edges2 (t : triangle2) : list R :=
  distance_squared2 (ta t) (tb t) :: distance_squared2 (ta t) (tc t) :: distance_squared2 (tb t) (tc t) :: nil.

(** ** Bases, lattices, domains *)

Definition at_coordinates2 (l1 l2 x : point2) : point2 := add2 (scale2 (x2 x) l1) (scale2 (y2 x) l2).
(** [Gram2 g11 g22 g12], the inner products of a basis. *)
Record gram2 := Gram2 { h11 : R; h22 : R; h12 : R }.
Definition has_gram2 (G : gram2) (l1 l2 : point2) := dot2 l1 l1 = h11 G /\ dot2 l2 l2 = h22 G /\ dot2 l1 l2 = h12 G.
(** The lattice of rank r: 2 for the plane, 1 for a strip, 0 for a polygon. *)
Definition in_lattice2 (r : nat) (n : Z * Z) : Prop :=
  match r with 0%nat => fst n = 0%Z /\ snd n = 0%Z | 1%nat => snd n = 0%Z | _ => True end.
Definition lattice_vector2 (l1 l2 : point2) (n : Z * Z) : point2 := at_coordinates2 l1 l2 (Point2 (IZR (fst n)) (IZR (snd n))).
Inductive convex_hull2 (W : list point2) : point2 -> Prop :=
  | hull_vertex2 v : In v W -> convex_hull2 W v
  | hull_segment2 x y s : convex_hull2 W x -> convex_hull2 W y -> 0 <= s <= 1 -> convex_hull2 W (add2 (scale2 (1 - s) x) (scale2 s y)).
(** The points whose last 2 - r basis coordinates are those of a point of the hull of W;
    with r = 2 all of the plane. *)
Definition domain2 (l1 l2 : point2) (r : nat) (W : list point2) (X : point2) : Prop :=
  exists x, X = at_coordinates2 l1 l2 x /\
  match r with
  | 0 => exists w, convex_hull2 W w /\ x = w
  | 1 => exists w, convex_hull2 W w /\ y2 x = y2 w
  | _ => True
  end%nat.

(** ** Periodic tilings *)

Section Tilings.
Variables (l1 l2 : point2) (r : nat) (Omega : point2 -> Prop) (N : nat) (P : nat -> triangle2).
Definition is_tile2 (c : nat * (Z * Z)) := (fst c < N)%nat /\ in_lattice2 r (snd c).
Definition tile2 (c : nat * (Z * Z)) := translate2 (lattice_vector2 l1 l2 (snd c)) (P (fst c)).

(** "face-to-face tiling": see Statement.v for the meaning of each member. *)
Record edge_to_edge_tiling : Prop := {
  basis2 : det2 l1 l2 <> 0;
  nondegenerate2 : forall c, is_tile2 c -> area (tile2 c) <> 0;
  locally_finite2 : forall M, exists F, forall c X, is_tile2 c -> near2 M origin2 X -> hull2 (tile2 c) X -> In c F;
  inside2 : forall c X, is_tile2 c -> hull2 (tile2 c) X -> Omega X;
  cover2 : forall X, Omega X -> exists c, is_tile2 c /\ hull2 (tile2 c) X;
  disjoint2 : forall X c c', is_tile2 c -> is_tile2 c' -> open_hull2 (tile2 c) X -> hull2 (tile2 c') X -> c = c';
  edge_to_edge2 : forall X c c', is_tile2 c -> is_tile2 c' ->
     hull2 (tile2 c) X -> hull2 (tile2 c') X -> common_hull2 (tile2 c) (tile2 c') X }.

Definition acute2 := forall c x, is_tile2 c -> In x (angles2 (tile2 c)) -> x < PI / 2.
Definition nonobtuse2 := forall c x, is_tile2 c -> In x (angles2 (tile2 c)) -> x <= PI / 2.
Definition largest_angle2 := bounded is_tile2 (fun c => largest (angles2 (tile2 c))).
Definition smallest_angle2 := bounded is_tile2 (fun c => smallest (angles2 (tile2 c))).

Definition circumscribed2 (t : triangle2) (C : point2) (s : R) := forall v, In v (corners t) -> distance_squared2 v C = s.
Definition squared_ratio2 (t : triangle2) (q : R) := exists C s l, circumscribed2 t C s /\ smallest (squared_edges2 t) l /\ q = s / l.
Definition squared_radius_edge_ratio2 := bounded is_tile2 (fun c => squared_ratio2 (tile2 c)).
(** "uncrossed plane": a line. *)
Definition uncrossed2 (c : Z * Z) (b : R) := forall t, is_tile2 t ->
  (forall x, hull2 (tile2 t) (at_coordinates2 l1 l2 x) -> IZR (fst c) * x2 x + IZR (snd c) * y2 x <= b) \/
  (forall x, hull2 (tile2 t) (at_coordinates2 l1 l2 x) -> b <= IZR (fst c) * x2 x + IZR (snd c) * y2 x).
Definition is_vertex2 (v : point2) := exists c, is_tile2 c /\ In v (corners (tile2 c)).
Definition weakly_delaunay2 := forall c, is_tile2 c -> exists C s, circumscribed2 (tile2 c) C s /\
  forall v, is_vertex2 v -> s <= distance_squared2 v C.
Definition delaunay2 := forall c, is_tile2 c -> exists C s, circumscribed2 (tile2 c) C s /\
  forall v, is_vertex2 v -> s <= distance_squared2 v C /\ (distance_squared2 v C = s -> In v (corners (tile2 c))).
Definition not_delaunay2 := exists c C s v, is_tile2 c /\ circumscribed2 (tile2 c) C s /\ is_vertex2 v /\ distance_squared2 v C < s.
End Tilings.

(** The statements of Statement.v; the dihedral angles of a triangle are its angles, and
    "TCP" is no statement about the plane; a line has two coefficients. *)
Definition holds2 (l1 l2 : point2) (r N : nat) (P : nat -> triangle2) (s : statement) : Prop :=
  match s with
  | Acute => acute2 l1 l2 r N P
  | Nonobtuse => nonobtuse2 l1 l2 r N P
  | LargestDihedralAngle rel B => largest_angle2 l1 l2 r N P rel B
  | SmallestDihedralAngle rel B => smallest_angle2 l1 l2 r N P rel B
  | SquaredRadiusEdgeRatio rel B => squared_radius_edge_ratio2 l1 l2 r N P rel B
  | Uncrossed (c1, c2, _) b => uncrossed2 l1 l2 r N P (c1, c2) b
  | Delaunay => delaunay2 l1 l2 r N P
  | WeaklyDelaunay => weakly_delaunay2 l1 l2 r N P
  | NotDelaunay => not_delaunay2 l1 l2 r N P
  | TCP => False
  end.
