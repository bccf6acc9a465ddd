(** * Systems of patches: what the theorem on all their tilings of space says

    Read Statement.v first.  This file contains definitions and not a single proof.

    A *mosaic* is a tiling of the plane by copies of finitely many polygons, edge to edge: for
    example by squares and equilateral triangles.  It need not be periodic.  Space is the plane
    times a line; the first coordinate of a point is its height, the other two are those of the
    plane.  Over each tile of a mosaic stands a prism, infinitely high.  A *patch* says with
    which tetrahedra it is filled, with the period 1 in the direction of the height.

    - The *piece* is a list of tetrahedra in the prism.
    - What is left are pyramids.  Each has its base in a side of the prism: a polygon, the
      *rim*.  The pyramids on both sides of a wall, over one rim, are a *join*.  It is cut
      into the tetrahedra around the segment between the two apexes, one for each side of the rim.

    All tiles have sides of length 1.  The numbers of a patch are a + b sqrt 3 with integers
    a and b, in units of 1/24. *)
From Coq Require Import Reals ZArith List.
From Acutile Require Import Statement.
Open Scope R_scope.

Definition surd (x : Z * Z) : R := IZR (fst x) + IZR (snd x) * sqrt 3.

(** ** Patches *)

(** A point of a patch: its height, and its coordinates in the plane of the tile. *)
Record spot := Spot { height : Z * Z; ahead : Z * Z; aside : Z * Z }.

(** A side of a tile, with the pyramid in the wall over it.  The sides of a tile are listed
    counterclockwise, and each ends where the next one starts.  The height of [start] is the
    offset of the wall: heights in a wall are counted from there. *)
Record edge := Edge { start : spot; apex : spot; rim : list spot }.
Record patch := Patch { edges : list edge; pieces : list (spot * spot * spot * spot) }.

(** The number after s, cyclically, of the numbers 0, …, n - 1. *)
Definition next (n s : nat) : nat := if Nat.eqb (S s) n then 0%nat else S s.

(** ** Mosaics *)

(** A copy of the polygon with the number [shape]: the origin of the patch is moved to [corner]
    and its first axis to the direction [along], a unit vector; no reflection. *)
Record tile := Tile { shape : nat; corner : R * R; along : R * R }.

(** The spot x, in units of c, for an origin at the height H over o and the direction d. *)
Definition put (c H : R) (o d : R * R) (x : spot) : point :=
  Point (H + c * surd (height x))
        (fst o + c * (surd (ahead x) * fst d - surd (aside x) * snd d))
        (snd o + c * (surd (ahead x) * snd d + surd (aside x) * fst d)).

Section Mosaic.
(** A system of patches, and the tiles 0, 1, 2, … *)
Variables (system : list patch) (tiles : nat -> tile).

Definition patch_of (i : nat) : patch := nth (shape (tiles i)) system (Patch nil nil).
Definition sides (i : nat) : nat := length (edges (patch_of i)).
Definition edge_of (i s : nat) : edge := let o := (0, 0)%Z in nth s (edges (patch_of i)) (Edge (Spot o o o) (Spot o o o) nil).

(** The corner of tile i in which its side s starts, in the plane. *)
Definition corner_of (i s : nat) : R * R :=
  let x := put (/ 24) 0 (corner (tiles i)) (along (tiles i)) (start (edge_of i s)) in (py x, pz x).

(** Positive to the left of side s of tile i, negative to the right of it, zero on its line.  A
    convex polygon with its corners in counterclockwise order is what is to the left of all sides. *)
Definition left_of (i s : nat) (X : R * R) : R :=
  let A := corner_of i s in let B := corner_of i (next (sides i) s) in
  (fst B - fst A) * (snd X - snd A) - (snd B - snd A) * (fst X - fst A).
Definition in_tile (i : nat) (X : R * R) := forall s, (s < sides i)%nat -> 0 <= left_of i s X.
Definition inside_tile (i : nat) (X : R * R) := forall s, (s < sides i)%nat -> 0 < left_of i s X.

(** Side s of tile i and side s' of tile j, another tile, are the same segment. *)
Definition meets (i s j s' : nat) : Prop := (s < sides i)%nat /\ (s' < sides j)%nat /\ i <> j /\
  corner_of i s = corner_of j (next (sides j) s') /\ corner_of i (next (sides i) s) = corner_of j s'.

Record mosaic : Prop := {
  mosaic_shapes : forall i, (shape (tiles i) < length system)%nat;
  mosaic_unit : forall i, fst (along (tiles i)) * fst (along (tiles i)) + snd (along (tiles i)) * snd (along (tiles i)) = 1;
  (* only finitely many tiles meet any bounded set *)
  mosaic_locally_finite : forall M, exists F, forall i X, Rabs (fst X) < M -> Rabs (snd X) < M -> in_tile i X -> In i F;
  (* the tiles cover the plane, and an inner point of one tile is in no other one *)
  mosaic_cover : forall X, exists i, in_tile i X;
  mosaic_apart : forall i j X, inside_tile i X -> in_tile j X -> i = j;
  (* edge to edge: each side of a tile is a side of another one *)
  mosaic_edge_to_edge : forall i s, (s < sides i)%nat -> exists j s', meets i s j s' }.

(** ** The cells *)

(** The patch over tile i is raised by [rise i].  Walls agree if heights counted from the offsets
    of their two sides differ by a multiple of the period. *)
Variable rise : nat -> R.
Definition wall_height (i s : nat) : R := rise i + / 24 * surd (height (start (edge_of i s))).
Definition walls_agree := forall i s j s', meets i s j s' -> exists z : Z, wall_height i s - wall_height j s' = IZR z.

(** A spot of the patch over tile i, in space, and n periods higher. *)
Definition place (i : nat) (x : spot) : point := put (/ 24) (rise i) (corner (tiles i)) (along (tiles i)) x.
Definition periods (n : Z) (t : tetrahedron) : tetrahedron := translate (Point (IZR n) 0 0) t.

(** A tetrahedron of the piece over a tile; or one of a join, for a side s of tile i that is side
    s' of a tile j: with the apex of j, a side of the rim, and the apex of i.  (Of the tiles i
    and j the one with the smaller number counts, so that no tetrahedron is listed twice.) *)
Inductive is_cell : tetrahedron -> Prop :=
  | piece_cell i a b c d n : In (a, b, c, d) (pieces (patch_of i)) ->
      is_cell (periods n (Tetrahedron (place i a) (place i b) (place i c) (place i d)))
  | join_cell i s j s' e n : meets i s j s' -> (i < j)%nat ->
      let h k := place i (nth k (rim (edge_of i s)) (start (edge_of i s))) in
      (e < length (rim (edge_of i s)))%nat ->
      is_cell (periods n (Tetrahedron
        (add (place j (apex (edge_of j s'))) (Point (wall_height i s - wall_height j s') 0 0))
        (h e) (h (next (length (rim (edge_of i s))) e)) (place i (apex (edge_of i s))))).
End Mosaic.

(** ** Tilings of space, as sets of tetrahedra *)
Record tiles_space (cells : tetrahedron -> Prop) : Prop := {
  space_nondegenerate : forall t, cells t -> vol t <> 0;
  (* only finitely many cells meet any bounded set *)
  space_locally_finite : forall M, exists F, forall t X, cells t -> near M origin X -> hull t X -> In t F;
  space_cover : forall X, exists t, cells t /\ hull t X;
  (* an inner point of one cell lies in no other cell *)
  space_disjoint : forall X t t', cells t -> cells t' -> open_hull t X -> hull t' X -> t = t';
  (* two cells meet in the hull of their common vertices: in a common face or not at all *)
  space_face_to_face : forall X t t', cells t -> cells t' -> hull t X -> hull t' X -> common_hull t t' X }.
Definition acute_cells (cells : tetrahedron -> Prop) := forall t x, cells t -> In x (dihedrals t) -> x < PI / 2.
(** The quantity of a cell is its largest dihedral angle, in radians. *)
Definition largest_angle_of_cells (cells : tetrahedron -> Prop) := bounded cells (fun t => largest (dihedrals t)).
(** The circumscribed ball of every cell has no vertex in its interior and none but the cell's own on its boundary. *)
Definition delaunay_cells (cells : tetrahedron -> Prop) := forall t, cells t -> exists C s, circumscribed t C s /\
  forall v, (exists t', cells t' /\ In v (verts t')) ->
    s <= distance_squared v C /\ (distance_squared v C = s -> In v (verts t)).
