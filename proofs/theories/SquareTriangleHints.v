(** * Patches over triangles and squares: the mates of facets

    patches.py writes this file.  These are hints: PatchChecker.v does not believe them. *)
From Coq Require Import ZArith List.
From Acutile Require Import PatchStatement PatchChecker.
Import ListNotations.
Open Scope Z_scope.

Definition behind_facets : list (list (list entry)) :=
  [[[Inner (Facet 2 3) (-1); Inner (Facet 1 2) (0); Wall 1 0; Wall 0 0];
    [Inner (Facet 4 2) (-1); Inner (Lateral 1 5) (0); Inner (Facet 0 1) (0); Inner (Lateral 0 0) (0)];
    [Inner (Facet 3 3) (0); Inner (Lateral 1 1) (0); Inner (Lateral 0 4) (0); Inner (Facet 0 0) (1)];
    [Inner (Facet 10 2) (0); Inner (Facet 7 1) (0); Inner (Facet 4 3) (0); Inner (Facet 2 0) (0)];
    [Inner (Facet 9 3) (0); Inner (Facet 6 1) (0); Inner (Facet 1 0) (1); Inner (Facet 3 2) (0)];
    [Wall 2 0; Inner (Facet 7 3) (0); Wall 0 1; Inner (Facet 6 2) (0)];
    [Inner (Lateral 2 0) (1); Inner (Facet 4 1) (0); Inner (Facet 5 3) (0); Inner (Lateral 0 1) (1)];
    [Inner (Lateral 2 4) (0); Inner (Facet 3 1) (0); Inner (Lateral 0 3) (0); Inner (Facet 5 1) (0)];
    [Wall 2 1; Wall 1 1; Inner (Facet 10 3) (0); Inner (Facet 9 2) (0)];
    [Inner (Lateral 2 1) (1); Inner (Lateral 1 4) (1); Inner (Facet 8 3) (0); Inner (Facet 4 0) (0)];
    [Inner (Lateral 2 3) (0); Inner (Lateral 1 2) (0); Inner (Facet 3 0) (0); Inner (Facet 8 2) (0)]];
   [[Inner (Facet 4 3) (-1); Inner (Facet 2 2) (0); Wall 2 0; Inner (Lateral 1 0) (-1)];
    [Inner (Facet 5 1) (0); Inner (Facet 3 1) (0); Wall 1 0; Inner (Lateral 2 0) (0)];
    [Inner (Facet 7 2) (-1); Inner (Lateral 2 5) (0); Inner (Facet 0 1) (0); Inner (Facet 3 2) (0)];
    [Inner (Facet 18 3) (-1); Inner (Facet 1 1) (0); Inner (Facet 2 3) (0); Inner (Lateral 1 5) (-1)];
    [Inner (Facet 6 3) (0); Inner (Lateral 2 1) (0); Inner (Facet 5 3) (0); Inner (Facet 0 0) (1)];
    [Inner (Facet 17 2) (0); Inner (Facet 1 0) (0); Inner (Lateral 1 1) (0); Inner (Facet 4 2) (0)];
    [Inner (Facet 21 1) (0); Inner (Facet 15 3) (0); Inner (Facet 7 3) (0); Inner (Facet 4 0) (0)];
    [Inner (Facet 20 1) (0); Inner (Facet 16 2) (0); Inner (Facet 2 0) (1); Inner (Facet 6 2) (0)];
    [Wall 0 0; Inner (Facet 11 3) (0); Inner (Lateral 1 3) (0); Inner (Facet 9 2) (0)];
    [Inner (Lateral 0 0) (1); Inner (Facet 14 3) (0); Inner (Facet 8 3) (0); Inner (Facet 10 2) (0)];
    [Inner (Facet 22 1) (1); Inner (Facet 18 2) (0); Inner (Facet 9 3) (0); Inner (Lateral 1 4) (0)];
    [Inner (Lateral 0 4) (0); Inner (Facet 13 2) (0); Inner (Facet 12 3) (0); Inner (Facet 8 1) (0)];
    [Inner (Facet 22 0) (0); Inner (Facet 17 3) (0); Inner (Lateral 1 2) (0); Inner (Facet 11 2) (0)];
    [Inner (Facet 25 3) (0); Inner (Facet 15 2) (0); Inner (Facet 11 1) (0); Inner (Facet 14 2) (0)];
    [Inner (Facet 24 2) (0); Inner (Facet 16 3) (0); Inner (Facet 13 3) (0); Inner (Facet 9 1) (0)];
    [Inner (Facet 31 2) (0); Inner (Facet 17 1) (0); Inner (Facet 13 1) (0); Inner (Facet 6 1) (0)];
    [Inner (Facet 32 3) (0); Inner (Facet 18 1) (0); Inner (Facet 7 1) (0); Inner (Facet 14 1) (0)];
    [Inner (Facet 18 0) (-1); Inner (Facet 15 1) (0); Inner (Facet 5 0) (0); Inner (Facet 12 1) (0)];
    [Inner (Facet 17 0) (1); Inner (Facet 16 1) (0); Inner (Facet 10 1) (0); Inner (Facet 3 0) (1)];
    [Inner (Lateral 3 5) (0); Inner (Facet 21 2) (0); Inner (Facet 20 3) (0); Wall 2 1];
    [Inner (Facet 27 3) (1); Inner (Facet 7 0) (0); Inner (Lateral 2 4) (1); Inner (Facet 19 2) (0)];
    [Inner (Facet 28 2) (0); Inner (Facet 6 0) (0); Inner (Facet 19 1) (0); Inner (Lateral 2 2) (0)];
    [Inner (Facet 12 0) (0); Inner (Facet 10 0) (-1); Inner (Lateral 0 5) (0); Wall 1 1];
    [Inner (Lateral 3 2) (0); Wall 0 1; Inner (Facet 24 3) (0); Inner (Facet 25 2) (0)];
    [Inner (Facet 29 3) (0); Inner (Lateral 0 1) (1); Inner (Facet 14 0) (0); Inner (Facet 23 2) (0)];
    [Inner (Facet 30 2) (0); Inner (Lateral 0 3) (0); Inner (Facet 23 3) (0); Inner (Facet 13 0) (0)];
    [Inner (Facet 28 1) (0); Inner (Facet 27 1) (0); Inner (Lateral 2 3) (0); Wall 3 0];
    [Inner (Facet 32 1) (-1); Inner (Facet 26 1) (0); Inner (Lateral 3 0) (-1); Inner (Facet 20 0) (-1)];
    [Inner (Facet 31 1) (0); Inner (Facet 26 0) (0); Inner (Facet 21 0) (0); Inner (Lateral 3 4) (0)];
    [Inner (Facet 33 1) (1); Inner (Facet 32 2) (0); Inner (Lateral 3 1) (0); Inner (Facet 24 0) (0)];
    [Inner (Facet 33 0) (0); Inner (Facet 31 3) (0); Inner (Facet 25 0) (0); Inner (Lateral 3 3) (0)];
    [Inner (Facet 32 0) (-1); Inner (Facet 28 0) (0); Inner (Facet 15 0) (0); Inner (Facet 30 1) (0)];
    [Inner (Facet 31 0) (1); Inner (Facet 27 0) (1); Inner (Facet 29 1) (0); Inner (Facet 16 0) (0)];
    [Inner (Facet 30 0) (0); Inner (Facet 29 0) (-1); Wall 3 1; Inner (Lateral 0 2) (0)]]].
Definition behind_laterals : list (list (list entry)) :=
  [[[Inner (Facet 1 3) (0); Inner (Facet 6 3) (-1); Inner (Lateral 2 5) (0); Inner (Facet 7 2) (0); Inner (Facet 2 2) (0); Inner (Lateral 1 0) (0)];
    [Inner (Lateral 0 5) (0); Inner (Facet 2 1) (0); Inner (Facet 10 1) (0); Inner (Lateral 2 2) (0); Inner (Facet 9 1) (-1); Inner (Facet 1 1) (0)];
    [Inner (Facet 6 0) (-1); Inner (Facet 9 0) (-1); Inner (Lateral 1 3) (0); Inner (Facet 10 0) (0); Inner (Facet 7 0) (0); Inner (Lateral 0 2) (0)]];
   [[Inner (Facet 9 0) (-1); Inner (Facet 24 1) (-1); Inner (Facet 33 3) (0); Inner (Facet 25 1) (0); Inner (Facet 11 0) (0); Inner (Facet 22 2) (0)];
    [Inner (Facet 0 3) (1); Inner (Facet 5 2) (0); Inner (Facet 12 2) (0); Inner (Facet 8 2) (0); Inner (Facet 10 3) (0); Inner (Facet 3 3) (1)];
    [Inner (Facet 1 3) (0); Inner (Facet 4 1) (0); Inner (Facet 21 3) (0); Inner (Facet 26 2) (0); Inner (Facet 20 2) (-1); Inner (Facet 2 1) (0)];
    [Inner (Facet 27 2) (1); Inner (Facet 29 2) (0); Inner (Facet 23 0) (0); Inner (Facet 30 3) (0); Inner (Facet 28 3) (0); Inner (Facet 19 0) (0)]]].
Definition wall_owners : list (list (list occupant)) :=
  [[[Facet 0 3; Facet 5 2];
    [Facet 0 2; Facet 8 1];
    [Facet 5 0; Facet 8 0]];
   [[Facet 8 0; Facet 23 1];
    [Facet 1 2; Facet 22 3];
    [Facet 0 2; Facet 19 3];
    [Facet 26 3; Facet 33 2]]].
Definition rim_mates : list (list (list (list (list nat)))) :=
  [[[[[1; 0; 5; 4; 3; 2]; [5; 4; 3; 2; 1; 0]; [1; 0; 5; 4; 3; 2]]; [[1; 0; 5; 4; 3; 2]; [2; 1; 0; 5; 4; 3]; [5; 4; 3; 2; 1; 0]; [4; 3; 2; 1; 0; 5]]];
    [[[5; 4; 3; 2; 1; 0]; [3; 2; 1; 0; 5; 4]; [5; 4; 3; 2; 1; 0]]; [[5; 4; 3; 2; 1; 0]; [0; 5; 4; 3; 2; 1]; [3; 2; 1; 0; 5; 4]; [2; 1; 0; 5; 4; 3]]];
    [[[1; 0; 5; 4; 3; 2]; [5; 4; 3; 2; 1; 0]; [1; 0; 5; 4; 3; 2]]; [[1; 0; 5; 4; 3; 2]; [2; 1; 0; 5; 4; 3]; [5; 4; 3; 2; 1; 0]; [4; 3; 2; 1; 0; 5]]]];
   [[[[1; 0; 5; 4; 3; 2]; [5; 4; 3; 2; 1; 0]; [1; 0; 5; 4; 3; 2]]; [[1; 0; 5; 4; 3; 2]; [2; 1; 0; 5; 4; 3]; [5; 4; 3; 2; 1; 0]; [4; 3; 2; 1; 0; 5]]];
    [[[2; 1; 0; 5; 4; 3]; [0; 5; 4; 3; 2; 1]; [2; 1; 0; 5; 4; 3]]; [[2; 1; 0; 5; 4; 3]; [3; 2; 1; 0; 5; 4]; [0; 5; 4; 3; 2; 1]; [5; 4; 3; 2; 1; 0]]];
    [[[5; 4; 3; 2; 1; 0]; [3; 2; 1; 0; 5; 4]; [5; 4; 3; 2; 1; 0]]; [[5; 4; 3; 2; 1; 0]; [0; 5; 4; 3; 2; 1]; [3; 2; 1; 0; 5; 4]; [2; 1; 0; 5; 4; 3]]];
    [[[4; 3; 2; 1; 0; 5]; [2; 1; 0; 5; 4; 3]; [4; 3; 2; 1; 0; 5]]; [[4; 3; 2; 1; 0; 5]; [5; 4; 3; 2; 1; 0]; [2; 1; 0; 5; 4; 3]; [1; 0; 5; 4; 3; 2]]]]]%nat.
Definition wall_mates : list (list (list (list (list (nat * Z))))) :=
  [[[[[(1%nat, -1); (0%nat, 1)]; [(0%nat, 0); (1%nat, 0)]; [(1%nat, -1); (0%nat, 0)]]; [[(1%nat, -1); (0%nat, 0)]; [(1%nat, 0); (0%nat, 1)]; [(0%nat, 0); (1%nat, 0)]; [(0%nat, 0); (1%nat, 1)]]];
    [[[(0%nat, 0); (1%nat, 0)]; [(1%nat, -1); (0%nat, 1)]; [(0%nat, -1); (1%nat, 0)]]; [[(0%nat, -1); (1%nat, 0)]; [(0%nat, 0); (1%nat, 1)]; [(1%nat, -1); (0%nat, 1)]; [(1%nat, 0); (0%nat, 1)]]];
    [[[(1%nat, 0); (0%nat, 1)]; [(0%nat, 1); (1%nat, 0)]; [(1%nat, 0); (0%nat, 0)]]; [[(1%nat, 0); (0%nat, 0)]; [(1%nat, 1); (0%nat, 1)]; [(0%nat, 1); (1%nat, 0)]; [(0%nat, 1); (1%nat, 1)]]]];
   [[[[(1%nat, 0); (0%nat, 1)]; [(0%nat, 1); (1%nat, 0)]; [(1%nat, 0); (0%nat, 0)]]; [[(1%nat, 0); (0%nat, 0)]; [(1%nat, 1); (0%nat, 1)]; [(0%nat, 1); (1%nat, 0)]; [(0%nat, 1); (1%nat, 1)]]];
    [[[(1%nat, -1); (0%nat, 0)]; [(0%nat, 0); (1%nat, -1)]; [(1%nat, -1); (0%nat, -1)]]; [[(1%nat, -1); (0%nat, -1)]; [(1%nat, 0); (0%nat, 0)]; [(0%nat, 0); (1%nat, -1)]; [(0%nat, 0); (1%nat, 0)]]];
    [[[(0%nat, 0); (1%nat, 0)]; [(1%nat, -1); (0%nat, 1)]; [(0%nat, -1); (1%nat, 0)]]; [[(0%nat, -1); (1%nat, 0)]; [(0%nat, 0); (1%nat, 1)]; [(1%nat, -1); (0%nat, 1)]; [(1%nat, 0); (0%nat, 1)]]];
    [[[(0%nat, 0); (1%nat, -1)]; [(1%nat, -1); (0%nat, 0)]; [(0%nat, -1); (1%nat, -1)]]; [[(0%nat, -1); (1%nat, -1)]; [(0%nat, 0); (1%nat, 0)]; [(1%nat, -1); (0%nat, 0)]; [(1%nat, 0); (0%nat, 0)]]]]].
