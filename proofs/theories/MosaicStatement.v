(** * Systems of patches: the tilings of space over all mosaics

    Read Statement.v first.  This file contains definitions and not a single proof.

    Space is the product of a *base* and a *fibre*.  The fibre is spanned by the first r vectors of a
    basis l1, l2, l3, and the base by the others; the two are orthogonal.  For r = 1 the base is a
    plane, for r = 2 a line.  A *mosaic* is a tiling of the base by copies of finitely many convex
    polygons (r = 1), or of a line by copies of segments (r = 2).  It need not be periodic.  Over each
    tile stands a prism, infinite in the directions of the fibre.  A *patch* says with which
    tetrahedra it is filled, with the periods l1, …, lr.

    - The *piece* is a list of tetrahedra in the prism.
    - What is left are *pyramids*.  Each has its base, the *rim*, in a side of the prism.  The two
      pyramids over one rim, from both sides of a wall, are a *join*.  It is cut into the tetrahedra
      around the segment between the two apexes, one for each side of the rim. *)
From Coq Require Import Reals ZArith List.
From Acutile Require Import Statement.
Open Scope R_scope.

(** ** Patches

    Points are given by coordinates in the basis of the patch.  The first r are those in the fibre. *)
Record pyramid := Pyramid { apex : point; rim : list point }.
(** A side of the prism.  For r = 1 the sides are listed counterclockwise: a side begins over [start]
    and ends where the next one begins.  For r = 2 there are two, the lower end and the upper end of
    the slab.  Only sides of one class can meet.  The coordinates of [start] in the fibre are the
    offset of the side: fibre coordinates in the wall are counted from there. *)
Record edge := Edge { class : Z; start : point }.
Record patch := Patch { edges : list edge; pyramids : list pyramid; pieces : list tetrahedron }.

(** The number after s, cyclically, of the numbers 0, …, n - 1. *)
Definition next (n s : nat) : nat := if Nat.eqb (S s) n then 0%nat else S s.

(** Points of the fibre: the other coordinates are zero. *)
Definition in_fibre (r : nat) (x : point) : Prop := match r with 1%nat => py x = 0 /\ pz x = 0 | _ => pz x = 0 end.

Section Shape.
Variables (r : nat) (p : patch).
Definition sides : nat := length (edges p).
Definition edge_at (s : nat) : edge := nth s (edges p) (Edge 0 origin).
(** The end of a side, with the side's own offset. *)
Definition finish (s : nat) : point := let A := start (edge_at s) in let B := start (edge_at (next sides s)) in
  match r with 1%nat => Point (px A) (py B) (pz B) | _ => A end.
(** Positive on the inner side of the plane of side s, zero in this plane. *)
Definition left_of (s : nat) (x : point) : R :=
  let A := start (edge_at s) in let B := finish s in
  match r, s with
  | 1%nat, _ => (py B - py A) * (pz x - pz A) - (pz B - pz A) * (py x - py A)
  | _, 0%nat => pz x - pz A
  | _, _ => pz A - pz x
  end.
Definition in_prism (x : point) : Prop := forall s, (s < sides)%nat -> 0 <= left_of s x.
Definition inside_prism (x : point) : Prop := forall s, (s < sides)%nat -> 0 < left_of s x.
End Shape.

(** ** Mosaics *)

(** A copy of the polygon with the number [shape]: coordinates x of the patch are those of the point
    [corner] + x1 m1 + x2 m2 + x3 m3 of space, where m1, m2, m3 are [axes]. *)
Record tile := Tile { shape : nat; corner : point; axes : point * point * point }.

Section Mosaic.
(** A basis with its Gram matrix, the rank, a system of patches, and the tiles 0, 1, 2, … *)
Variables (l1 l2 l3 : point) (G : gram) (r : nat) (system : list patch) (tiles : nat -> tile).

Definition patch_of (i : nat) : patch := nth (shape (tiles i)) system (Patch nil nil nil).
Definition place (i : nat) (x : point) : point :=
  let '(m1, m2, m3) := axes (tiles i) in add (corner (tiles i)) (at_coordinates m1 m2 m3 x).
(** Two points of space over the same point of the base. *)
Definition same_base (X Y : point) : Prop := exists f, in_fibre r f /\ X = add Y (at_coordinates l1 l2 l3 f).

(** The prism over a tile, and its interior. *)
Definition over (i : nat) (X : point) := exists x, X = place i x /\ in_prism r (patch_of i) x.
Definition within (i : nat) (X : point) := exists x, X = place i x /\ inside_prism r (patch_of i) x.

(** Side s of tile i and side s' of tile j, another tile, are the same side of the mosaic, seen from
    its two sides; for r = 2 one of them is a lower end and the other one an upper end. *)
Definition meets (i s j s' : nat) : Prop :=
  let p := patch_of i in let q := patch_of j in
  (s < sides p)%nat /\ (s' < sides q)%nat /\ i <> j /\ (r = 2%nat -> s <> s') /\
  same_base (place i (start (edge_at p s))) (place j (finish r q s')) /\
  same_base (place i (finish r p s)) (place j (start (edge_at q s'))).

Record mosaic : Prop := {
  mosaic_shapes : forall i, (shape (tiles i) < length system)%nat;
  (* copies are moved, and turned in the base; they are not reflected *)
  mosaic_motions : forall i, let '(m1, m2, m3) := axes (tiles i) in
    has_gram G m1 m2 m3 /\ det m1 m2 m3 = det l1 l2 l3 /\ m1 = l1 /\ (r = 2%nat -> m2 = l2);
  (* only finitely many prisms meet any bounded set *)
  mosaic_locally_finite : forall M, exists F, forall i X, near M origin X -> over i X -> In i F;
  (* the prisms cover space, and an inner point of one is in no other one *)
  mosaic_cover : forall X, exists i, over i X;
  mosaic_apart : forall i j X, within i X -> over j X -> i = j;
  (* edge to edge: each side of a tile is a side of another tile, and of its class *)
  mosaic_edge_to_edge : forall i s, (s < sides (patch_of i))%nat -> exists j s', meets i s j s';
  mosaic_classes : forall i s j s', meets i s j s' -> class (edge_at (patch_of i) s) = class (edge_at (patch_of j) s') }.

(** ** The cells *)

(** The patch over tile i is moved by [rise i] in the fibre. *)
Variable rise : nat -> point.
Definition spot (i : nat) (x : point) : point := place i (add x (rise i)).
Definition period (n : Z * Z * Z) : point := lattice_vector l1 l2 l3 n.
(** Where two tiles meet, their walls agree up to periods: the offset of one side is that of the other. *)
Record heights : Prop := {
  heights_in_fibre : forall i, in_fibre r (rise i);
  heights_agree : forall i s j s', meets i s j s' -> exists n, in_lattice r n /\
    spot i (start (edge_at (patch_of i) s)) = add (spot j (finish r (patch_of j) s')) (period n) }.

(** A tetrahedron of the piece over a tile; or one of a join.  A pyramid P over side s of tile i and a
    pyramid Q over side s' of tile j are over the same rim if the rim of Q, moved by a period m, has
    the same corners in space as that of P.  (Of the tiles i and j the one with the smaller number
    counts, so that no tetrahedron is listed twice.) *)
Inductive is_cell : tetrahedron -> Prop :=
  | piece_cell i t n : In t (pieces (patch_of i)) -> in_lattice r n ->
      is_cell (translate (period n) (Tetrahedron (spot i (va t)) (spot i (vb t)) (spot i (vc t)) (spot i (vd t))))
  | join_cell i s j s' P Q m e n : meets i s j s' -> (i < j)%nat ->
      In P (pyramids (patch_of i)) -> (forall h, In h (rim P) -> left_of r (patch_of i) s h = 0) ->
      In Q (pyramids (patch_of j)) -> in_lattice r m ->
      (forall X, In X (map (spot i) (rim P)) <-> In X (map (fun h => add (spot j h) (period m)) (rim Q))) ->
      (e < length (rim P))%nat -> in_lattice r n ->
      let corner k := spot i (nth k (rim P) origin) in
      is_cell (translate (period n) (Tetrahedron (add (spot j (apex Q)) (period m))
        (corner e) (corner (next (length (rim P)) e)) (spot i (apex P)))).
End Mosaic.

(** ** Tilings of space, as sets of tetrahedra *)
Section Cells.
Variable cells : tetrahedron -> Prop.
Record tiles_space : Prop := {
  space_nondegenerate : forall t, cells t -> vol t <> 0;
  (* only finitely many cells meet any bounded set *)
  space_locally_finite : forall M, exists F, forall t X, cells t -> near M origin X -> hull t X -> In t F;
  space_cover : forall X, exists t, cells t /\ hull t X;
  (* an inner point of one cell lies in no other cell *)
  space_disjoint : forall X t t', cells t -> cells t' -> open_hull t X -> hull t' X -> t = t';
  (* two cells meet in the hull of their common vertices: in a common face or not at all *)
  space_face_to_face : forall X t t', cells t -> cells t' -> hull t X -> hull t' X -> common_hull t t' X }.
Definition acute_cells := forall t x, cells t -> In x (dihedrals t) -> x < PI / 2.
Definition nonobtuse_cells := forall t x, cells t -> In x (dihedrals t) -> x <= PI / 2.
(** The quantities of a cell, as in Statement.v. *)
Definition largest_angle (t : tetrahedron) := largest (dihedrals t).
Definition smallest_angle (t : tetrahedron) := smallest (dihedrals t).
(** The circumscribed ball of every cell has no vertex in its interior; and none but the cell's own on its boundary. *)
Definition vertex_of_cells (v : point) := exists t, cells t /\ In v (verts t).
Definition weakly_delaunay_cells := forall t, cells t -> exists C s, circumscribed t C s /\
  forall v, vertex_of_cells v -> s <= distance_squared v C.
Definition delaunay_cells := forall t, cells t -> exists C s, circumscribed t C s /\
  forall v, vertex_of_cells v -> s <= distance_squared v C /\ (distance_squared v C = s -> In v (verts t)).
(** The valence of an edge uv is the number of cells that have it; it is 5 or 6, and no triangle has
    two edges of valence 6. *)
Definition cell_with (vs : list point) (t : tetrahedron) := cells t /\ forall v, In v vs -> In v (verts t).
Definition valence_in_cells (u v : point) (m : nat) :=
  exists L, NoDup L /\ length L = m /\ forall t, In t L <-> cell_with (u :: v :: nil) t.
Definition tcp_cells :=
  (forall t u v, cell_with (u :: v :: nil) t -> u <> v -> valence_in_cells u v 5 \/ valence_in_cells u v 6) /\
  (forall t u v w, cell_with (u :: v :: w :: nil) t -> u <> v -> u <> w -> v <> w ->
    ~ (valence_in_cells u v 6 /\ valence_in_cells u w 6)).
End Cells.

(** ** Over all mosaics *)
Section All.
Variables (l1 l2 l3 : point) (G : gram) (r : nat) (system : list patch).
(** Over every mosaic the patches can be raised such that the walls agree. *)
Definition heights_exist : Prop := forall tiles, mosaic l1 l2 l3 G r system tiles -> exists rise, heights l1 l2 l3 r system tiles rise.
(** The cells over every mosaic have the property P, for all heights. *)
Definition over_all (P : (tetrahedron -> Prop) -> Prop) : Prop :=
  forall tiles rise, mosaic l1 l2 l3 G r system tiles -> heights l1 l2 l3 r system tiles rise -> P (is_cell l1 l2 l3 r system tiles rise).
(** There is a tile such that they have it over every mosaic with a copy of this tile. *)
Definition over_some (P : (tetrahedron -> Prop) -> Prop) : Prop := exists a, (a < length system)%nat /\
  forall tiles rise, mosaic l1 l2 l3 G r system tiles -> heights l1 l2 l3 r system tiles rise ->
    (exists i, shape (tiles i) = a) -> P (is_cell l1 l2 l3 r system tiles rise).
(** A bound for a quantity of the cells.  A maximum, or a minimum, is attained over every mosaic in
    which some tile occurs. *)
Definition bounded_over_all (of : tetrahedron -> R -> Prop) (rel : relation) (B : R) : Prop :=
  match rel with
  | Maximum => over_all (fun cells => bounded cells of AtMost B) /\ over_some (fun cells => reached cells of B)
  | Minimum => over_all (fun cells => bounded cells of AtLeast B) /\ over_some (fun cells => reached cells of B)
  | _ => over_all (fun cells => bounded cells of rel B)
  end.
End All.
