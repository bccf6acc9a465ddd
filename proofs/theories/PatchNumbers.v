(** * All tilings of space over edge-to-edge tilings of the plane by squares and triangles

    The finite checks by computation, and the theorem. *)
From Coq Require Import Reals Lra ZArith List.
From Acutile Require Import Statement PatchStatement SquareTriangle PatchChecker SquareTriangleHints PatchHeights PatchAngles PatchDelaunay.
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

(** A tetrahedron over a square has the largest angle; over triangles alone none has. *)
Definition peaks (a : nat) : option nat := match a with 1%nat => Some 15%nat | _ => None end.
Lemma square_triangle_angles : check_angles square_triangle 25 peaks = true.
Proof. vm_compute. reflexivity. Qed.
Lemma square_triangle_delaunay : check_delaunay square_triangle square_triangle_hints = true.
Proof. vm_compute. reflexivity. Qed.
Lemma root_of_25 : sqrt (/ 25) = (1 / 5)%R.
Proof. replace (/ 25)%R with ((1 / 5) * (1 / 5))%R by lra. apply sqrt_square. lra. Qed.

(** Over every edge-to-edge tiling of the plane by squares and equilateral triangles the patches
    can be raised so that walls agree.  Then the cells tile space face to face, they are
    acute, and no dihedral angle is above arccos (1/5); it occurs if there is a square.
    The tiling is Delaunay. *)
Theorem square_triangle_theorem : forall tiles, mosaic square_triangle tiles ->
  (exists rise, walls_agree square_triangle tiles rise) /\
  forall rise, walls_agree square_triangle tiles rise -> let cells := is_cell square_triangle tiles rise in
    tiles_space cells /\ acute_cells cells /\ largest_angle_of_cells cells AtMost (acos (1 / 5)) /\
    (forall i, shape (tiles i) = 1%nat -> largest_angle_of_cells cells Maximum (acos (1 / 5))) /\ delaunay_cells cells.
Proof.
  intros tiles tiling.
  destruct (patches_over_mosaic square_triangle square_triangle_hints square_triangle_headings square_triangle_checked square_triangle_headed tiles tiling) as [E T].
  split; [exact E|]. intros rise A cells. destruct (T rise A) as [S C]. split; [exact S|]. split; [exact C|]. rewrite <- root_of_25. split; [|split].
  - exact (angle_at_most square_triangle square_triangle_hints 25 peaks square_triangle_checked eq_refl square_triangle_angles tiles rise tiling A).
  - intros i I. apply (largest_angle square_triangle square_triangle_hints 25 peaks square_triangle_checked eq_refl square_triangle_angles tiles rise tiling A i 15).
    rewrite I. reflexivity.
  - exact (patches_delaunay square_triangle square_triangle_hints square_triangle_checked square_triangle_delaunay tiles rise tiling A).
Qed.
