(** * The checks of a region of the plane: Boolean functions, no proof

    As in PlaneChecker.v: the region times the interval [0, 1] is a region of space, and
    RegionChecker.v checks it. *)
Require Import NArith ZArith List Bool.
From Acutile Require Import Statement Tetrahedra Degree Domain Checker RegionChecker PlaneChecker.
Import ListNotations.
Local Open Scope nat_scope.

Definition I3 := [0; 1; 2].
(** The mate across the side opposite to corner i. *)
Definition nt (t : ctri) (i : nat) : mref2 := match i with 0 => n0 t | 1 => n1 t | _ => n2 t end.
Definition free (t : ctri) (i : nat) : bool := match nt t i with None => true | Some _ => false end.
Definition open_sides (ts : list ctri) : list (N * ctri * nat) :=
  collect (fun k t l => fold_right (fun i l => if free t i then (k, t, i) :: l else l) l I3) 0%N ts [].

Section Ring.
Variables (A : Type) (aadd asub amul : A -> A -> A) (aofZ : Z -> A) (alt ale : A -> A -> bool) (part : Z -> A -> Z).
Notation lift := (lift A aadd asub amul aofZ ale).
Definition listed_sides (c : cert2 A) : list (nat * nat) := map (fun f => let '(k, _, i) := f in (N.to_nat k, i)) (open_sides (e_tris A c)).
Definition check_region2 (c : cert2 A) : bool :=
  Nat.leb (e_rank A c) 2 && forallb (in_range A c) (e_tris A c) && match open_sides (e_tris A c) with [] => false | _ => true end &&
  check_region A aadd asub amul aofZ alt ale part (lift c).
Definition check_region_statement2 (c : cert2 A) (s : rstatement A) : bool :=
  match s with
  | Each _ (CDelaunay _) | Each _ (CWeaklyDelaunay _) | Each _ (CTCP _) => false
  | Each _ s => check_statement2 A aadd asub amul aofZ alt ale c s
  | CLocallyDelaunay _ => let c3 := lift c in
    chk_edges A aadd asub amul aofZ alt c3 (positions A aadd aofZ c3) (c_tets A c3)
  | CLocallyWeaklyDelaunay _ => chk_delaunay A aadd asub amul aofZ ale (lift c)
  end.
Definition check_region2_with (c : cert2 A) (ss : list (rstatement A)) : bool :=
  if check_region2 c then forallb (check_region_statement2 c) ss else false.
End Ring.
