(** * Hints for the checker: the mates of the facets, enclosures of the root

    No theorem is about this file: the checker checks every mate and every enclosure.  A
    facet is named by its sorted corners, moved so that the first one has the shift zero:
    translates have one name.  The second facet with a name closes the first, a third one
    is open again (docs/format.md, "Mates").  The boundary facets of a region are open
    before the first row: a simplex that closes one has it as a boundary facet. *)
From Coq Require Import NArith ZArith List Bool FMapPositive.
From Acutile Require Import Tetrahedra Degree Domain Checker PlaneChecker Numbers Fast.
Import ListNotations.

(** ** The order of corners *)
Definition z3cmp (a b : Z3) : comparison :=
  let '(x, y, z) := a in let '(x', y', z') := b in
  match Z.compare x x' with Eq => match Z.compare y y' with Eq => Z.compare z z' | c => c end | c => c end.
Definition corner_cmp (a b : corner) : comparison :=
  match N.compare (fst a) (fst b) with Eq => z3cmp (snd a) (snd b) | c => c end.
Definition before (a b : corner) : bool := match corner_cmp a b with Lt => true | _ => false end.
Fixpoint insert (a : corner) (l : list corner) : list corner :=
  match l with [] => [a] | b :: m => if before b a then b :: insert a m else a :: l end.
Definition sort_corners (l : list corner) : list corner := fold_right insert [] l.

(** ** Facets by name: those of the first vertex hang on it *)
Definition back (s : Z3) (q : corner) : corner := (fst q, zadd3 (snd q) (zopp3 s)).
Definition same_corners (a b : list corner) : bool := both ceqb a b.
Definition open_facets := PositiveMap.t (list (list corner * (N * N * Z3))).
Fixpoint take (name : list corner) (l : list (list corner * (N * N * Z3))) : option ((N * N * Z3) * list (list corner * (N * N * Z3))) :=
  match l with
  | [] => None
  | (n, f) :: l => if same_corners name n then Some (f, l) else
      match take name l with Some (g, l) => Some (g, (n, f) :: l) | None => None end
  end.
Definition place (k i : N) : positive := N.succ_pos (4 * k + i).
Definition mates_map := PositiveMap.t (N * N * Z3).
(** Facet i of simplex k, with its corners. *)
Definition pair_facet (k i : N) (facet : list corner) (s : open_facets * mates_map) : open_facets * mates_map :=
  match sort_corners facet with
  | [] => s
  | (v, shift) :: rest =>
    let (opened, mates) := s in
    let name := map (back shift) rest in
    let l := match PositiveMap.find (N.succ_pos v) opened with Some l => l | None => [] end in
    match take name l with
    | None => (PositiveMap.add (N.succ_pos v) ((name, (k, i, shift)) :: l) opened, mates)
    | Some ((k', i', shift'), l) =>
      let d := zadd3 shift (zopp3 shift') in
      (PositiveMap.add (N.succ_pos v) l opened,
       PositiveMap.add (place k i) (k', i', d) (PositiveMap.add (place k' i') (k, i, zopp3 d) mates))
    end
  end.
Definition without (i : nat) (l : list corner) : list corner := firstn i l ++ skipn (S i) l.
Definition pair_row (s : N * (open_facets * mates_map)) (r : list corner) : N * (open_facets * mates_map) :=
  let (k, s) := s in
  (N.succ k, fold_left (fun s i => pair_facet k (N.of_nat i) (without i r) s) (seq 0 (length r)) s).
(** Boundary facets are the facets 0 of simplices n, n + 1, …, where n is the number of rows. *)
Definition pair_boundary (s : N * (open_facets * mates_map)) (f : list corner) : N * (open_facets * mates_map) :=
  let (k, s) := s in (N.succ k, pair_facet k 0 f s).
Definition mates (n : N) (boundary rows : list (list corner)) : mates_map :=
  let s := snd (fold_left pair_boundary boundary (n, (PositiveMap.empty _, PositiveMap.empty _))) in
  snd (snd (fold_left pair_row rows (0%N, s))).
Definition number_of {X} (l : list X) : N := fold_left (fun n _ => N.succ n) l 0%N.
(** The simplex, and not a boundary facet, across facet i of simplex k. *)
Definition mate_in (n : N) (m : mates_map) (k i : N) : option (N * N * Z3) :=
  match PositiveMap.find (place k i) m with Some (k', i', d) => if N.ltb k' n then Some (k', i', d) else None | None => None end.
Fixpoint numbered {X Y} (f : N -> X -> Y) (k : N) (l : list X) (reversed : list Y) : list Y :=
  match l with [] => rev_append reversed [] | x :: l => numbered f (N.succ k) l (f k x :: reversed) end.

(** ** The data of the checker *)
Definition no_corner : corner := (0%N, z30).
Definition tetrahedron (n : N) (m : mates_map) (k : N) (r : list corner) : ctet :=
  let q i := nth i r no_corner in let mate i := mate_in n m k i in
  CT (q 0%nat) (q 1%nat) (q 2%nat) (q 3%nat) (mate 0%N) (mate 1%N) (mate 2%N) (mate 3%N).
(** The facet of a simplex for each boundary facet, and the vector that moves it there. *)
Definition boundary_places (n : N) (m : mates_map) (boundary : list (list corner)) : list (N * N * Z3) :=
  numbered (fun k _ => match mate_in n m k 0 with Some p => p | None => (n, 0%N, z30) end) n boundary [].
Definition tetrahedra (boundary rows : list (list corner)) : list ctet * list (N * N * Z3) :=
  let n := number_of rows in let m := mates n boundary rows in
  (numbered (tetrahedron n m) 0%N rows [], boundary_places n m boundary).
(** In the plane the corners ascend; the triangle is even if they did so in its row. *)
Definition flat (n : Z3) : Z * Z := fst n.
Definition corner_in_plane (q : corner) : corner2 := (fst q, flat (snd q)).
Definition triangle (n : N) (m : mates_map) (k : N) (r : list corner) : ctri :=
  let s := sort_corners r in
  let q i := corner_in_plane (nth i s no_corner) in
  let mate i := match mate_in n m k i with Some (k', i', d) => Some (k', i', flat d) | None => None end in
  CTri (q 0%nat) (q 1%nat) (q 2%nat) (mate 0%N) (mate 1%N) (mate 2%N) (same_corners r s).
Definition triangles (boundary rows : list (list corner)) : list ctri * list (N * N * Z3) :=
  let n := number_of rows in let m := mates n boundary (fast_map sort_corners rows) in
  (numbered (triangle n m) 0%N rows [], boundary_places n m boundary).

(** ** The root, bisected: enclosures after 32, 64, 128 and 256 halvings *)
Definition polynomial_sign (p : list Z) (S a : Z) : comparison := Z.compare (fst (hev S p a)) 0.
Local Open Scope Z_scope.
Fixpoint halve (p : list Z) (right : comparison) (n : nat) (k : Z) (lo hi S : Z) (kept : list encl) : list encl :=
  match n with
  | O => kept
  | Datatypes.S n =>
    let middle := lo + hi in let S := 2 * S in
    let (lo, hi) := match polynomial_sign p S middle, right with
      | Eq, _ => (middle, middle)
      | Lt, Lt | Gt, Gt => (2 * lo, middle)
      | _, _ => (middle, 2 * hi)
      end in
    let kept := if (k =? 32) || (k =? 64) || (k =? 128) || (k =? 256) then Encl lo hi S :: kept else kept in
    halve p right n (k + 1) lo hi S kept
  end.
(** The finest one, and the others with the coarsest first. *)
Definition enclosures (p : list Z) (lo hi S : Z) : encl * list encl :=
  match halve p (polynomial_sign p S hi) 256 1 lo hi S [] with
  | finest :: rest => (finest, rev rest)
  | [] => (Encl lo hi S, [])
  end.
