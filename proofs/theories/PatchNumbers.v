(** * All tilings of space over edge-to-edge tilings of the plane by squares and triangles

    The finite checks by computation, and the theorem. *)
From Coq Require Import ZArith List.
From Acutile Require Import PatchStatement SquareTriangle PatchChecker SquareTriangleHints PatchHeights.
Import ListNotations.
Open Scope Z_scope.

Definition get {A} (l : list (list (list A))) (a s e : nat) (d : A) : A := nth e (nth s (nth a l []) []) d.
(** A spot inside of the first tetrahedron of each piece, and of no other cell. *)
Definition homes : list spot := [Spot (-6, 0) (18, 0) (0, 5); Spot (-6, 0) (14, 0) (22, 0)].
Definition square_triangle_hints : hints := Hints
  (fun a o => match o with Facet k f => get behind_facets a k f (Wall 0 0) | Lateral s e => get behind_laterals a s e (Wall 0 0) end)
  (fun a s w => get wall_owners a s w (Facet 0 0))
  (fun a s => length (nth s (nth a wall_owners []) []))
  (fun a s b s' e => get (nth s (nth a rim_mates []) []) b s' e 0%nat)
  (fun a s b s' w => get (nth s (nth a wall_mates []) []) b s' w (0%nat, 0))
  (fun a => (0%nat, nth a homes origin_spot)).
(** Sides of the triangle have the directions 0, 120 and 240 degrees, those of the square 0, 90, 180, 270. *)
Definition square_triangle_headings (a s : nat) : nat := (nth a [4; 3] 0 * s)%nat.

Lemma square_triangle_checked : check_system square_triangle square_triangle_hints = true.
Proof. vm_compute. reflexivity. Qed.
Lemma square_triangle_headed : check_headings square_triangle square_triangle_headings = true.
Proof. vm_compute. reflexivity. Qed.

(** Over every edge-to-edge tiling of the plane by squares and equilateral triangles the patches
    can be raised so that walls agree, and then the cells tile space face to face and are acute. *)
Theorem square_triangle_theorem : forall tiles, mosaic square_triangle tiles ->
  (exists rise, walls_agree square_triangle tiles rise) /\
  forall rise, walls_agree square_triangle tiles rise ->
    tiles_space (is_cell square_triangle tiles rise) /\ acute_cells (is_cell square_triangle tiles rise).
Proof.
  exact (patches_over_mosaic square_triangle square_triangle_hints square_triangle_headings square_triangle_checked square_triangle_headed).
Qed.
