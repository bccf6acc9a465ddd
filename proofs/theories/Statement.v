(** * What is proved: every definition that gives the theorem its meaning

    This file alone says what the words of a claim mean: tiling, face to face,
    dihedral angle, acute, Delaunay.  It contains definitions and not a single
    proof.  Nothing in it mentions certificates, checkers or computations; the
    theorems that end in these definitions are in [Numbers.v] and [Bytes.v].

    How to read it.  [R] is the set of the real numbers and [Z] that of the
    integers, [nat] the numbers 0, 1, 2, …, all from Coq's standard library; [IZR]
    takes an integer to the real number.  [%nat] and [%Z] say of what kind the
    numbers beside them are.  [Record p := C { a : R; b : R }] is a pair of real
    numbers, made by [C 1 2]; its components are [a x] and [b x].  [(x, y)] is a pair
    too, with the components [fst] and [snd].  [Definition f x := e] is f(x) = e, and
    a function is applied without parentheses: [f x y] is f(x, y).  [fun x => e] is the
    function that takes x to e.  [Prop] is the type of propositions, so a
    [point -> Prop] is a set of points: [S x] says that x is in S.  [/\] is "and",
    [\/] "or", [~] "not", [->] "implies", [<->] "if and only if", [<>] "is not equal
    to"; [forall] and [exists] are the quantifiers.  [a :: b :: nil] is the list of a
    and b, [In v l] says that v is a member of l, [length l] is the number of members,
    [NoDup l] says that they are distinct.  [match n with 0 => e | _ => f end] is e if
    n is 0, and f else; [let '(x, y) := n in e] takes a pair apart.  [Inductive] is the
    least set, or the least predicate, closed under the rules listed.

    [Section] opens a paragraph and [Variables] says for all of it "let these be
    given".  When it closes they become arguments of what was defined there and uses
    them: after the section [acute] takes [l1 l2 l3 r N P], and [acute l1 l2 l3 r N P] is
    the proposition.

    The theorems begin with [exists l1 l2 l3, has_gram G l1 l2 l3], and go on "for all
    l1, l2, l3 with this Gram matrix".  A certificate gives the Gram matrix and no
    basis: any two bases with it differ by a congruence, so the claim is about all of
    them; and that there is one keeps "for all" from being empty. *)

From Coq Require Import Reals ZArith List.
Open Scope R_scope.

(** ** Euclidean three-space *)

(** A point of R^3, or a vector, by its three Cartesian coordinates. *)
Record point := Point { px : R; py : R; pz : R }.

Definition origin := Point 0 0 0.
Definition add (u v : point) := Point (px u + px v) (py u + py v) (pz u + pz v).
Definition sub (u v : point) := Point (px u - px v) (py u - py v) (pz u - pz v).
Definition scale (s : R) (u : point) := Point (s * px u) (s * py u) (s * pz u).

(** The inner product, the length, the square of the distance. *)
Definition dot (u v : point) := px u * px v + py u * py v + pz u * pz v.
Definition norm (u : point) := sqrt (dot u u).
Definition distance_squared (x y : point) := dot (sub x y) (sub x y).

(** The determinant of three vectors. *)
Definition det (u v w : point) :=
  px u * (py v * pz w - pz v * py w)
  - py u * (px v * pz w - pz v * px w)
  + pz u * (px v * py w - py v * px w).

(** ** Tetrahedra *)

(** Four vertices, in order. *)
Record tetrahedron := Tetrahedron { va : point; vb : point; vc : point; vd : point }.
Definition verts (t : tetrahedron) := va t :: vb t :: vc t :: vd t :: nil.

(** Six times the signed volume, whatever the name; its sign is the orientation. *)
Definition vol (t : tetrahedron) := det (sub (vb t) (va t)) (sub (vc t) (va t)) (sub (vd t) (va t)).

(** The combination a va + b vb + c vc + d vd of the vertices. *)
Definition combination (t : tetrahedron) (a b c d : R) :=
  add (add (scale a (va t)) (scale b (vb t))) (add (scale c (vc t)) (scale d (vd t))).

(** The closed tetrahedron: the convex hull of the four vertices. *)
Definition hull (t : tetrahedron) (X : point) := exists a b c d,
  0 <= a /\ 0 <= b /\ 0 <= c /\ 0 <= d /\ a + b + c + d = 1 /\ X = combination t a b c d.

(** The open tetrahedron: all weights are positive.  It is the topological
    interior of [hull t] (theorem [open_hull_is_interior] in Sanity.v). *)
Definition open_hull (t : tetrahedron) (X : point) := exists a b c d,
  0 < a /\ 0 < b /\ 0 < c /\ 0 < d /\ a + b + c + d = 1 /\ X = combination t a b c d.

(** The convex hull of the vertices that t has in common with t': the only
    vertices with positive weight are vertices of t'. *)
Definition common_hull (t t' : tetrahedron) (X : point) := exists a b c d,
  0 <= a /\ 0 <= b /\ 0 <= c /\ 0 <= d /\ a + b + c + d = 1 /\ X = combination t a b c d /\
  (0 < a -> In (va t) (verts t')) /\ (0 < b -> In (vb t) (verts t')) /\
  (0 < c -> In (vc t) (verts t')) /\ (0 < d -> In (vd t) (verts t')).

Definition translate (u : point) (t : tetrahedron) :=
  Tetrahedron (add (va t) u) (add (vb t) u) (add (vc t) u) (add (vd t) u).

(** ** Topology: boxes as neighbourhoods, interior *)

Definition near (e : R) (x y : point) :=
  Rabs (px y - px x) < e /\ Rabs (py y - py x) < e /\ Rabs (pz y - pz x) < e.
Definition interior (S : point -> Prop) (x : point) := exists e, 0 < e /\ forall y, near e x y -> S y.

(** ** Angles *)

(** The component of u perpendicular to e; the angle between two vectors. *)
Definition perp (e u : point) := sub u (scale (dot u e / dot e e) e).
Definition angle (u w : point) := acos (dot u w / (norm u * norm w)).

(** The dihedral angle along the edge ab, between the half planes that contain
    c and d, in radians. *)
Definition dihedral (a b c d : point) := angle (perp (sub b a) (sub c a)) (perp (sub b a) (sub d a)).

(** The six dihedral angles of t, and the squares of its six edges. *)
Definition dihedrals (t : tetrahedron) : list R :=
  dihedral (va t) (vb t) (vc t) (vd t) :: dihedral (va t) (vc t) (vb t) (vd t) ::
  dihedral (va t) (vd t) (vb t) (vc t) :: dihedral (vb t) (vc t) (va t) (vd t) ::
  dihedral (vb t) (vd t) (va t) (vc t) :: dihedral (vc t) (vd t) (va t) (vb t) :: nil.
Definition squared_edges (t : tetrahedron) : list R :=
  distance_squared (va t) (vb t) :: distance_squared (va t) (vc t) ::
  distance_squared (va t) (vd t) :: distance_squared (vb t) (vc t) ::
  distance_squared (vb t) (vd t) :: distance_squared (vc t) (vd t) :: nil.

(** ** Quantities and bounds *)

(** q is the largest number in the list, the smallest. *)
Definition largest (l : list R) (q : R) := In q l /\ forall x, In x l -> x <= q.
Definition smallest (l : list R) (q : R) := In q l /\ forall x, In x l -> q <= x.

(** The relations between a quantity of the tiles and a bound B.  [of c q] says that the
    tile c has the quantity q.  "Less than": every tile has a quantity less than B.
    "Maximum": every tile has a quantity of at most B, and some tile has the quantity B.
    The other relations are alike. *)
Inductive relation := LessThan | AtMost | Maximum | MoreThan | AtLeast | Minimum.
Definition every {T} (tiles : T -> Prop) (of : T -> R -> Prop) (ok : R -> Prop) := forall c, tiles c -> exists q, of c q /\ ok q.
Definition reached {T} (tiles : T -> Prop) (of : T -> R -> Prop) (B : R) := exists c, tiles c /\ of c B.
Definition bounded {T} (tiles : T -> Prop) (of : T -> R -> Prop) (rel : relation) (B : R) : Prop :=
  match rel with
  | LessThan => every tiles of (fun q => q < B)
  | AtMost => every tiles of (fun q => q <= B)
  | Maximum => every tiles of (fun q => q <= B) /\ reached tiles of B
  | MoreThan => every tiles of (fun q => B < q)
  | AtLeast => every tiles of (fun q => B <= q)
  | Minimum => every tiles of (fun q => B <= q) /\ reached tiles of B
  end.

(** ** Bases, lattices, domains *)

(** The point with coordinates x in the basis l1, l2, l3. *)
Definition at_coordinates (l1 l2 l3 x : point) : point :=
  add (add (scale (px x) l1) (scale (py x) l2)) (scale (pz x) l3).

(** The Gram matrix of a basis: its inner products.  [Gram g11 g22 g33 g12 g13 g23]. *)
Record gram := Gram { g11 : R; g22 : R; g33 : R; g12 : R; g13 : R; g23 : R }.
Definition has_gram (G : gram) (l1 l2 l3 : point) :=
  dot l1 l1 = g11 G /\ dot l2 l2 = g22 G /\ dot l3 l3 = g33 G /\
  dot l1 l2 = g12 G /\ dot l1 l3 = g13 G /\ dot l2 l3 = g23 G.

(** The lattice of rank r is spanned by the first r basis vectors: r = 3 for
    space, 2 for a slab, 1 for a prism, 0 for a solid. *)
Definition in_lattice (r : nat) (n : Z * Z * Z) : Prop :=
  let '(x, y, z) := n in
  match r with 0%nat => x = 0%Z /\ y = 0%Z /\ z = 0%Z | 1%nat => y = 0%Z /\ z = 0%Z | 2%nat => z = 0%Z | _ => True end.
Definition lattice_vector (l1 l2 l3 : point) (n : Z * Z * Z) : point :=
  let '(x, y, z) := n in at_coordinates l1 l2 l3 (Point (IZR x) (IZR y) (IZR z)).

(** ** Domains *)

(** The convex hull of finitely many points: the smallest convex set that contains them. *)
Inductive convex_hull (W : list point) : point -> Prop :=
  | hull_vertex v : In v W -> convex_hull W v
  | hull_segment x y s : convex_hull W x -> convex_hull W y -> 0 <= s <= 1 -> convex_hull W (add (scale (1 - s) x) (scale s y)).

(** The domain: the points whose last 3 - r basis coordinates are those of a point of
    the convex hull of W.  With r = 3 this is all of space, whatever W; with r = 2 a
    slab, with r = 1 a prism, with r = 0 a polyhedron.  The first r coordinates of the
    points of W play no part; the certificates leave them out, and the theorems have
    zeros there, in front. *)
Definition domain (l1 l2 l3 : point) (r : nat) (W : list point) (X : point) : Prop :=
  exists x, X = at_coordinates l1 l2 l3 x /\
  match r with
  | 0 => exists w, convex_hull W w /\ x = w
  | 1 => exists w, convex_hull W w /\ py x = py w /\ pz x = pz w
  | 2 => exists w, convex_hull W w /\ pz x = pz w
  | _ => True
  end%nat.

(** ** Periodic tilings *)

Section Tilings.
(** A basis, the rank of the lattice, the domain, and N tetrahedra P 0, …, P (N-1),
    one for each lattice orbit of tiles.  P k is irrelevant for k >= N. *)
Variables (l1 l2 l3 : point) (r : nat) (Omega : point -> Prop) (N : nat) (P : nat -> tetrahedron).

(** The tile (k, n): the k-th tetrahedron, moved by the lattice vector n. *)
Definition is_tile (c : nat * (Z * Z * Z)) := (fst c < N)%nat /\ in_lattice r (snd c).
Definition tile (c : nat * (Z * Z * Z)) := translate (lattice_vector l1 l2 l3 (snd c)) (P (fst c)).

(** "face-to-face tiling" *)
Record face_to_face_tiling : Prop := {
  (* l1, l2, l3 are a basis, and no tile is flat *)
  tiling_basis : det l1 l2 l3 <> 0;
  tiling_nondegenerate : forall c, is_tile c -> vol (tile c) <> 0;
  (* only finitely many tiles meet any bounded set *)
  tiling_locally_finite : forall M, exists F, forall c X, is_tile c ->
     near M origin X -> hull (tile c) X -> In c F;
  (* the tiles cover the domain and nothing else *)
  tiling_inside : forall c X, is_tile c -> hull (tile c) X -> Omega X;
  tiling_cover : forall X, Omega X -> exists c, is_tile c /\ hull (tile c) X;
  (* an inner point of one tile lies in no other tile *)
  tiling_disjoint : forall X c c', is_tile c -> is_tile c' ->
     open_hull (tile c) X -> hull (tile c') X -> c = c';
  (* two tiles meet in the hull of their common vertices: in a common face or not at all *)
  tiling_face_to_face : forall X c c', is_tile c -> is_tile c' ->
     hull (tile c) X -> hull (tile c') X -> common_hull (tile c) (tile c') X }.

(** "acute", "nonobtuse" *)
Definition acute := forall c x, is_tile c -> In x (dihedrals (tile c)) -> x < PI / 2.
Definition nonobtuse := forall c x, is_tile c -> In x (dihedrals (tile c)) -> x <= PI / 2.

(** "largest dihedral angle", "smallest dihedral angle": the quantity of a tile is the
    largest, the smallest of its six dihedral angles, and B is an angle, in radians. *)
Definition largest_dihedral_angle := bounded is_tile (fun c => largest (dihedrals (tile c))).
Definition smallest_dihedral_angle := bounded is_tile (fun c => smallest (dihedrals (tile c))).

(** "squared radius-edge ratio": the quantity of a tile is s / l for the squared radius s
    of the circumscribed ball (with the centre C) and the square l of the shortest edge. *)
Definition circumscribed (t : tetrahedron) (C : point) (s : R) := forall v, In v (verts t) -> distance_squared v C = s.
Definition squared_ratio (t : tetrahedron) (q : R) := exists C s l, circumscribed t C s /\ smallest (squared_edges t) l /\ q = s / l.
Definition squared_radius_edge_ratio := bounded is_tile (fun c => squared_ratio (tile c)).

(** "uncrossed plane": the points with the basis coordinates x and c1 x1 + c2 x2 + c3 x3 = b, for
    c = (c1, c2, c3), are a plane.  Each tile lies in one of its two closed sides. *)
Definition linear_form (c : Z * Z * Z) (x : point) : R := let '(c1, c2, c3) := c in IZR c1 * px x + IZR c2 * py x + IZR c3 * pz x.
Definition uncrossed (c : Z * Z * Z) (b : R) := forall t, is_tile t ->
  (forall x, hull (tile t) (at_coordinates l1 l2 l3 x) -> linear_form c x <= b) \/
  (forall x, hull (tile t) (at_coordinates l1 l2 l3 x) -> b <= linear_form c x).

(** "Delaunay": the circumscribed ball of every tile has no vertex in its
    interior and none but the tile's own on its boundary; "weakly Delaunay": none in
    its interior. *)
Definition is_vertex (v : point) := exists c, is_tile c /\ In v (verts (tile c)).
Definition weakly_delaunay := forall c, is_tile c -> exists C s, circumscribed (tile c) C s /\
  forall v, is_vertex v -> s <= distance_squared v C.
Definition delaunay := forall c, is_tile c -> exists C s, circumscribed (tile c) C s /\
  forall v, is_vertex v -> s <= distance_squared v C /\ (distance_squared v C = s -> In v (verts (tile c))).

(** "not Delaunay": the circumscribed ball of some tile has a vertex in its interior. *)
Definition not_delaunay := exists c C s v, is_tile c /\ circumscribed (tile c) C s /\ is_vertex v /\ distance_squared v C < s.

(** "TCP", tetrahedrally close packed.  The valence of an edge uv is the number of
    tiles that have it; it is 5 or 6, and no triangle has two edges of valence 6. *)
Definition has_vertices (vs : list point) (c : nat * (Z * Z * Z)) := is_tile c /\ forall v, In v vs -> In v (verts (tile c)).
Definition valence (u v : point) (m : nat) :=
  exists L, NoDup L /\ length L = m /\ forall c, In c L <-> has_vertices (u :: v :: nil) c.
Definition tcp :=
  (forall c u v, has_vertices (u :: v :: nil) c -> u <> v -> valence u v 5 \/ valence u v 6) /\
  (forall c u v w, has_vertices (u :: v :: w :: nil) c -> u <> v -> u <> w -> v <> w -> ~ (valence u v 6 /\ valence u w 6)).
End Tilings.

(** One statement of a claim, as a certificate lists them; with the relation and the
    bound.  A certificate gives the bound of an angle as acos (sign * sqrt fraction). *)
Inductive statement :=
  | Acute | Nonobtuse
  | LargestDihedralAngle (rel : relation) (B : R) | SmallestDihedralAngle (rel : relation) (B : R)
  | SquaredRadiusEdgeRatio (rel : relation) (B : R)
  | Uncrossed (c : Z * Z * Z) (b : R)
  | Delaunay | WeaklyDelaunay | NotDelaunay | TCP.
Definition holds (l1 l2 l3 : point) (r N : nat) (P : nat -> tetrahedron) (s : statement) : Prop :=
  match s with
  | Acute => acute l1 l2 l3 r N P
  | Nonobtuse => nonobtuse l1 l2 l3 r N P
  | LargestDihedralAngle rel B => largest_dihedral_angle l1 l2 l3 r N P rel B
  | SmallestDihedralAngle rel B => smallest_dihedral_angle l1 l2 l3 r N P rel B
  | SquaredRadiusEdgeRatio rel B => squared_radius_edge_ratio l1 l2 l3 r N P rel B
  | Uncrossed c b => uncrossed l1 l2 l3 r N P c b
  | Delaunay => delaunay l1 l2 l3 r N P
  | WeaklyDelaunay => weakly_delaunay l1 l2 l3 r N P
  | NotDelaunay => not_delaunay l1 l2 l3 r N P
  | TCP => tcp l1 l2 l3 r N P
  end.
