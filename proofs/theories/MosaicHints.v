(** * Systems of patches: the hints of the checker

    No theorem is about this file: MosaicChecker.v checks every mate, every apex, every home and
    every rotation, and MosaicValences.v every name.  Facets are named by their corners, as in Pairing.v. *)
From Coq Require Import Reals NArith ZArith List Bool.
From Acutile Require Import Tetrahedra Degree Domain Checker Pairing MosaicStatement MosaicPoints MosaicPatches MosaicChecker MosaicValences.
Import ListNotations.
Local Open Scope nat_scope.

(** The corners of the tetrahedra of a patch, and of its pyramids. *)
Record names := Names { n_pieces : list (list Checker.corner); n_pyramids : list (Checker.corner * list Checker.corner) }.
Fixpoint find_index {X} (f : X -> bool) (l : list X) (i : nat) : option nat :=
  match l with [] => None | x :: l => if f x then Some i else find_index f l (S i) end.
Fixpoint first_of {X Y} (f : X -> option Y) (l : list X) : option Y :=
  match l with [] => None | x :: l => match f x with Some y => Some y | None => first_of f l end end.
Definition table {X} (n : nat) (f : nat -> X) : list X := map f (seq 0 n).
Definition get {X} (t : list X) (i : nat) (d : X) : X := nth i t d.
Definition occupant_corners (p : names) (o : occupant) : list Checker.corner := match o with
  | Facet k f => without f (nth k (n_pieces p) [])
  | Lateral q e => let y := nth q (n_pyramids p) (no_corner, []) in let n := length (snd y) in
      [nth e (snd y) no_corner; fst y; nth (next n e) (snd y) no_corner] end.
Definition name_of (l : list Checker.corner) : (N * list Checker.corner) * Z3 := match sort_corners l with
  | [] => ((0%N, []), z30) | (v, shift) :: rest => ((v, map (back shift) rest), shift) end.
Definition same_name (x y : N * list Checker.corner) : bool := N.eqb (fst x) (fst y) && same_corners (snd x) (snd y).

Section Ring.
Variables (A : Type) (aadd asub amul : A -> A -> A) (aofZ : Z -> A) (alt ale : A -> A -> bool).
Variables (content : list A -> Z) (quot : Z -> A -> A).
Notation spot := (spot A).
Notation kpatch := (kpatch A).
Notation zero := (zero A aofZ).
Notation weight := (weight A).
Notation numerators := (numerators A).
Notation no_spot := (no_spot A aofZ).
Notation spot_eq := (spot_eq A amul ale).
Notation spot_lift := (spot_lift A aadd amul aofZ).
Notation aeq := (aeq A ale).
Variables (g : kgram A) (r : nat) (system : list kpatch) (ns : list names).
Notation k_patch := (k_patch A system).
Notation carry := (k_carry A aadd asub amul aofZ ale content quot g r).
Notation can_meet := (can_meet A aofZ r).

(** The period that takes q to p, if there is one. *)
Definition integer_of (x w : A) : option Z := find (fun z => aeq x (amul (aofZ z) w)) (map (fun k => (if Nat.even k then Z.of_nat (k / 2) else - Z.of_nat (S k / 2))%Z) (seq 0 41)).
Definition period_between (p q : spot) : option Z3 :=
  let w := amul (weight p) (weight q) in
  let d f := asub (amul (weight q) (f (numerators p))) (amul (weight p) (f (numerators q))) in
  if aeq (d (vZ A)) zero then
    match integer_of (d (vX A)) w with
    | None => None
    | Some x => if r =? 1 then if aeq (d (vY A)) zero then Some (x, 0, 0)%Z else None
        else match integer_of (d (vY A)) w with Some y => Some (x, y, 0)%Z | None => None end
    end
  else None.
Definition side_of_spots (p : kpatch) (l : list spot) : nat :=
  match find_index (fun s => forallb (fun x => aeq (k_left A aadd amul (side_form A asub amul aofZ r p s) x) zero) l) (seq 0 (k_sides A p)) 0 with Some s => s | None => 0 end.

(** What is behind each occupant; the triangles in the walls. *)
Definition n := length system.
Definition patch_tables (a : nat) : list entry * list (list entry) * list (list occupant) * list nat :=
  let p := k_patch a in let nm := nth a ns (Names [] []) in
  let os := map (fun o => (o, name_of (occupant_corners nm o))) (occupants A aofZ p) in
  let mate o := let x := name_of (occupant_corners nm o) in
    match find (fun y => negb (occupant_eqb o (fst y)) && same_name (fst x) (fst (snd y))) os with
    | Some y => Some (Inner (fst y) (zadd3 (snd x) (zopp3 (snd (snd y))))) | None => None end in
  let side o := let '(x, y, z) := k_triangle A aofZ p o in side_of_spots p [x; y; z] in
  let open := flat_map (fun k => flat_map (fun f => match mate (Facet k f) with None => [(side (Facet k f), Facet k f)] | Some _ => [] end) [0; 1; 2; 3]) (seq 0 (length (k_pieces A p))) in
  let walls := table (k_sides A p) (fun s => map snd (filter (fun x => fst x =? s) open)) in
  let entry_of o := match mate o with Some e => e | None =>
    let s := side o in Wall s (match find_index (occupant_eqb o) (get walls s []) 0 with Some w => w | None => 0 end) end in
  (flat_map (fun k => map (fun f => entry_of (Facet k f)) [0; 1; 2; 3]) (seq 0 (length (k_pieces A p))),
   table (length (k_pyramids A p)) (fun q => table (k_rim_count A aofZ p q) (fun e => entry_of (Lateral q e))),
   walls, table (length (k_pyramids A p)) (fun q => side_of_spots p (k_rim A aofZ p q))).

(** A pyramid on the other side with its period, and the place in its rim where this rim begins; the rims run against each other. *)
Definition pyramid_beyond (sides_of : list (list nat)) (a q b s' : nat) : nat * Z3 * nat :=
  let p := k_patch a in let p' := k_patch b in let s := get (get sides_of a []) q 0 in
  if can_meet p s p' s' then
    let own := k_rim A aofZ p q in let count := length own in
    match first_of (fun q' => if get (get sides_of b []) q' 0 =? s' then
      let other := map (carry p s p' s') (k_rim A aofZ p' q') in
      if length other =? count then
        first_of (fun j => match period_between (nth 0 own no_spot) (nth j other no_spot) with
          | Some m => if forallb (fun e => spot_eq (nth e own no_spot) (spot_lift m (nth ((j + count - e) mod count) other no_spot))) (seq 0 count) then Some (q', m, j) else None
          | None => None end) (seq 0 count)
      else None else None) (seq 0 (length (k_pyramids A p'))) with Some x => x | None => (0, z30, 0) end
  else (0, z30, 0).
Definition triangle_beyond (walls : list (list (list occupant))) (a s b s' w : nat) : nat * Z3 :=
  let p := k_patch a in let p' := k_patch b in
  let f := k_triangle A aofZ p (get (get (get walls a []) s []) w (Facet 0 0)) in
  match first_of (fun w' =>
    let '(x, y, z) := map_spots A (carry p s p' s') (k_triangle A aofZ p' (get (get (get walls b []) s' []) w' (Facet 0 0))) in
    first_of (fun t => let '(u, _, _) := t in let '(v, _, _) := f in match period_between v u with
      | Some m => if spots_eq A amul ale f (map_spots A (spot_lift m) t) then Some (w', m) else None | None => None end) [(y, x, z); (x, z, y); (z, y, x)])
    (seq 0 (length (get (get walls b []) s' []))) with Some x => x | None => (0, z30) end.
Fixpoint distinct (l kept : list spot) : list spot := match l with
  | [] => rev kept | x :: l => distinct l (if existsb (spot_eq x) kept then kept else x :: kept) end.
Definition home_of (a : nat) : nat * spot := match k_piece A aofZ (k_patch a) 0 with
  | (x, y, z, t) => let sum f := aadd (aadd (f (numerators x)) (f (numerators y))) (aadd (f (numerators z)) (f (numerators t))) in
    (0, Spot A (amul (aofZ 4) (weight x)) (V3 A (sum (vX A)) (sum (vY A)) (sum (vZ A)))) end.

(** Rotations: those from tile to tile, composed until none is new; no more once there are sixty. *)
Notation matrix := (matrix A).
Notation k_turning := (k_turning A).
Definition generators : list k_turning :=
  fold_left (fun l t => if existsb (fun t' => matrix_eq A amul ale (fst t) (fst t')) l then l else t :: l)
  (flat_map (fun a => let p := k_patch a in flat_map (fun s => flat_map (fun b => let p' := k_patch b in flat_map (fun s' =>
    if can_meet p s p' s' then [(k_linear A aadd asub amul aofZ ale content quot g p s p' s', minus_fraction A asub amul (offset_of A aofZ p s) (offset_of A aofZ p' s'))] else [])
    (seq 0 (k_sides A p'))) (seq 0 n)) (seq 0 (k_sides A p))) (seq 0 n)) [].
Definition reduce_fraction (x : fraction A) : fraction A := let k := content [fst x; snd x] in
  if Z.leb k 1 then x else (quot k (fst x), quot k (snd x)).
Fixpoint compose_all (fuel : nat) (gs : list k_turning) (new known : list k_turning) : list k_turning := match fuel with
  | O => known
  | S fuel => match new with
    | [] => known
    | t :: new => if 60 <? length known then known else
      let more := fold_left (fun l gn => let m := matrix_compose A aadd amul aofZ ale content quot (fst t) (fst gn) in
        if existsb (fun t' => matrix_eq A amul ale m (fst t')) (l ++ known) then l
        else (m, reduce_fraction (plus_fraction A aadd amul (snd t) (snd gn))) :: l) gs [] in
      compose_all fuel gs (new ++ more) (known ++ more)
    end
  end.
Definition identity : k_turning := ((one A aofZ, (one A aofZ, zero, zero, one A aofZ)), (zero, one A aofZ)).
Definition find_turnings : list k_turning := if r =? 1 then compose_all 61 generators [identity] [identity] else [].

Definition found : hints * (nat -> nat -> list spot) * (nat -> nat * spot) :=
  let tables := table n patch_tables in
  let empty := ([], [], [], []) in
  let walls := map (fun t => let '(_, _, w, _) := t in w) tables in
  let sides_of := map (fun t => let '(_, _, _, s) := t in s) tables in
  let beyond := table n (fun a => table (length (k_pyramids A (k_patch a))) (fun q => table n (fun b => table (k_sides A (k_patch b)) (fun s' => pyramid_beyond sides_of a q b s')))) in
  let triangles := table n (fun a => table (k_sides A (k_patch a)) (fun s => table n (fun b => table (k_sides A (k_patch b)) (fun s' =>
    if can_meet (k_patch a) s (k_patch b) s' then table (length (get (get walls a []) s [])) (fun w => triangle_beyond walls a s b s' w) else [])))) in
  let beyond_at a q b s' := get (get (get (get beyond a []) q []) b []) s' (0, z30, 0) in
  let apexes := table n (fun a => table (length (k_pyramids A (k_patch a))) (fun q => let p := k_patch a in let s := get (get sides_of a []) q 0 in
    distinct (flat_map (fun b => let p' := k_patch b in flat_map (fun s' => if can_meet p s p' s' then
      let '(q', m, _) := beyond_at a q b s' in [spot_lift m (carry p s p' s' (k_apex A aofZ p' q'))] else []) (seq 0 (k_sides A p'))) (seq 0 n)) [])) in
  let homes := table n home_of in
  (Hints
    (fun a o => let '(fs, ls, _, _) := get tables a empty in match o with Facet k f => get fs (4 * k + f) (Wall 0 0) | Lateral q e => get (get ls q []) e (Wall 0 0) end)
    (fun a s w => get (get (get walls a []) s []) w (Facet 0 0))
    (fun a s => length (get (get walls a []) s []))
    (fun a q => get (get sides_of a []) q 0)
    (fun a q b s' => let '(q', m, _) := beyond_at a q b s' in (q', m))
    (fun a q b s' e => let '(_, _, j) := beyond_at a q b s' in let c := k_rim_count A aofZ (k_patch a) q in ((j + 2 * c - e - 1) mod c))
    (fun a s b s' w => get (get (get (get (get triangles a []) s []) b []) s' []) w (0, z30)),
   (fun a q => get (get apexes a []) q []), (fun a => get homes a (0, no_spot))).

(** For TCP: the names across walls, and directions that no side has. *)
Definition neighbour_table (labels : list (label A)) : list (list (list (list (list Checker.corner)))) :=
  let vertices a := l_vertices A (nth a labels (Label A [] [] [])) in
  let in_side p s x := aeq (k_left A aadd amul (side_form A asub amul aofZ r p s) x) zero in
  table n (fun a => let p := k_patch a in table (k_sides A p) (fun s => table n (fun b => let p' := k_patch b in table (k_sides A p') (fun s' =>
    if can_meet p s p' s' then
      let numbered := combine (seq 0 (length (vertices b))) (vertices b) in
      let theirs := map (fun y => (N.of_nat (fst y), carry p s p' s' (snd y))) (filter (fun y => in_side p' s' (snd y)) numbered) in
      map (fun x => if in_side p s x then match first_of (fun y => match period_between x (snd y) with Some m => Some (fst y, m) | None => None end) theirs with
        Some c => c | None => no_name end else no_name) (vertices a)
    else [])))).
Definition neighbours (labels : list (label A)) : nat -> nat -> nat -> nat -> N -> Checker.corner :=
  let t := neighbour_table labels in fun a s b s' v => nth (N.to_nat v) (get (get (get (get t a []) s []) b []) s' []) no_name.
Definition find_samples (turnings : list k_turning) : list (A * A) :=
  map (fun t => let '(_, (a, b, c, d)) := fst t in let sum x y := aadd (amul (aofZ 1009) x) (amul (aofZ 313) y) in (sum a c, sum b d)) turnings.
End Ring.
