(** * Systems of patches: the finite checks for TCP

    Boolean functions over any ring of exact numbers, as in MosaicChecker.v, and no proof.  The corners of a
    patch have names, as those of a tiling have in Checker.v; so valences are counts of keys.
    MosaicTcp.v proves that "true" implies TCP, by MosaicAround.v. *)
From Coq Require Import Reals NArith ZArith List Bool FMapPositive.
From Acutile Require Import Statement Tetrahedra Degree Domain Bounds Checker MosaicStatement MosaicPoints MosaicPatches MosaicChecker.
Import ListNotations.
Local Open Scope nat_scope.

Notation name := Checker.corner.
Definition no_name : name := (0%N, z30).
Definition ordered (l : list name) : list (name * name) := flat_map (fun x => map (pair x) (filter (fun y => negb (ceqb x y)) l)) l.
Definition key_of (p : name * name) : key := edge_key (fst p) (snd p).
Fixpoint distinct_names (l : list name) : bool := match l with [] => true | x :: l => forallb (fun y => negb (ceqb x y)) l && distinct_names l end.
Definition apex_pairs_of (y : name) (l : list name) : list (name * name) := filter (fun p => ceqb y (fst p) || ceqb y (snd p)) (ordered l).

Section Ring.
Variables (A : Type) (aadd asub amul : A -> A -> A) (aofZ : Z -> A) (alt ale : A -> A -> bool).
Variables (content : list A -> Z) (quot : Z -> A -> A).
Notation zero := (zero A aofZ).
Notation spot := (spot A).
Notation weight := (weight A).
Notation kpatch := (kpatch A).
Notation no_spot := (no_spot A aofZ).
Notation spot_eq := (spot_eq A amul ale).
Notation spot_lift := (spot_lift A aadd amul aofZ).
Notation aeq := (aeq A ale).
Notation k_left := (k_left A aadd amul).
Notation k_sides := (k_sides A).
Notation k_start := (k_start A aofZ).
Notation k_apex := (k_apex A aofZ).
Notation k_rim_at := (k_rim_at A aofZ).
Notation k_rim_count := (k_rim_count A aofZ).
Notation k_piece := (k_piece A aofZ).
(** The vertices of a patch; the names of the corners of its tetrahedra and pyramids. *)
Record label := Label { l_vertices : list spot; l_pieces : list (list name); l_pyramids : list (name * list name) }.
Variables (g : kgram A) (r : nat) (system : list kpatch) (h : hints) (labels : list label).
(** Hints: the name on the other side of a wall; directions in the base. *)
Variables (neighbour : nat -> nat -> nat -> nat -> N -> name) (samples : list (A * A)).
Variable turnings : list (k_turning A).
Notation k_patch := (k_patch A system).
Notation side_form := (side_form A asub amul aofZ r).
Notation can_meet := (can_meet A aofZ r).
Notation carry := (k_carry A aadd asub amul aofZ ale content quot g r).
Definition label_of (a : nat) : label := nth a labels (Label [] [] []).
Definition k_vertex (a : nat) (v : N) : spot := nth (N.to_nat v) (l_vertices (label_of a)) no_spot.
Definition k_vertices (a : nat) : N := N.of_nat (length (l_vertices (label_of a))).
Definition k_piece_name (a k j : nat) : name := nth j (nth k (l_pieces (label_of a)) []) no_name.
Definition k_apex_name (a q : nat) : name := fst (nth q (l_pyramids (label_of a)) (no_name, [])).
Definition k_rim_name (a q e : nat) : name := nth e (snd (nth q (l_pyramids (label_of a)) (no_name, []))) no_name.
Definition named_spot (a : nat) (c : name) : spot := spot_lift (snd c) (k_vertex a (fst c)).
Definition is_named (a : nat) (c : name) (x : spot) : bool := N.ltb (fst c) (k_vertices a) && latb r (snd c) && spot_eq x (named_spot a c).
Definition k_lateral_names (a q e : nat) : list name := [k_rim_name a q e; k_apex_name a q; k_rim_name a q (next (k_rim_count (k_patch a) q) e)].
Definition k_occupant_names (a : nat) (o : occupant) : list name := match o with
  | Facet k f => map (k_piece_name a k) (filter (fun j => negb (Nat.eqb f j)) I4)
  | Lateral q e => k_lateral_names a q e end.

(** ** Names, sides, corners *)
Fixpoint all_apart (l : list spot) : bool := match l with [] => true | x :: l => forallb (apart A asub amul aofZ alt r x) l && all_apart l end.
Definition check_names (a : nat) : bool := let p := k_patch a in let vs := l_vertices (label_of a) in
  forallb (fun x => alt zero (weight x)) vs && all_apart vs &&
  forallb (fun x => upto (k_sides p) (fun s => let y := k_left (side_form p s) x in aeq y zero || alt zero y)) vs &&
  upto (length (k_pieces A p)) (fun k => distinct_names (map (k_piece_name a k) I4) && forallb (fun j => is_named a (k_piece_name a k j) (k_corner A (k_piece p k) j)) I4) &&
  upto (length (k_pyramids A p)) (fun q => is_named a (k_apex_name a q) (k_apex p q) &&
    upto (k_rim_count p q) (fun e => is_named a (k_rim_name a q e) (k_rim_at p q e) && distinct_names (k_lateral_names a q e))).
(** No apex is in a side. *)
Definition check_apexes (a : nat) : bool := let p := k_patch a in
  upto (length (k_pyramids A p)) (fun q => upto (k_sides p) (fun s => alt zero (k_left (side_form p s) (k_apex p q)))).
Definition on (a s : nat) (c : name) : bool := aeq (k_left (side_form (k_patch a) s) (k_vertex a (fst c))) zero.
Definition check_neighbours (a s b s' : nat) : bool := let p := k_patch a in let p' := k_patch b in
  if can_meet p s p' s' then upto (length (l_vertices (label_of a))) (fun i => let v := N.of_nat i in
    if on a s (v, z30) then let c := neighbour a s b s' v in
      N.ltb (fst c) (k_vertices b) && latb r (snd c) && spot_eq (k_vertex a v) (carry p s p' s' (named_spot b c)) else true) else true.

(** ** Valences, doubled: for the facets of the piece and the triangles of pyramids; for tetrahedra of the piece; for joins at apexes *)
Definition facet_keys (a : nat) : list key := flat_map (fun o => map key_of (ordered (k_occupant_names a o))) (occupants A aofZ (k_patch a)).
Definition piece_keys (a : nat) : list key := flat_map (fun k => map key_of (ordered (map (k_piece_name a k) I4))) (seq 0 (length (k_pieces A (k_patch a)))).
Definition k_rim_places (p : kpatch) : list (nat * nat) := flat_map (fun q => map (pair q) (seq 0 (k_rim_count p q))) (seq 0 (length (k_pyramids A p))).
Definition apex_keys (a : nat) : list key := flat_map (fun x => map key_of (apex_pairs_of (k_apex_name a (fst x)) (k_lateral_names a (fst x) (snd x)))) (k_rim_places (k_patch a)).
Definition indexes : list (index * index * index) := map (fun a => (indexed (facet_keys a), indexed (piece_keys a), indexed (apex_keys a))) (seq 0 (length system)).
Section Count.
Variable tables : list (index * index * index).
Definition tables_at (a : nat) : index * index * index := nth a tables (PositiveMap.empty _, PositiveMap.empty _, PositiveMap.empty _).
Definition facets_at (a : nat) (c1 c2 : name) : nat := count_key (fst (fst (tables_at a))) (edge_key c1 c2).
Definition pieces_at (a : nat) (c1 c2 : name) : nat := count_key (snd (fst (tables_at a))) (edge_key c1 c2).
Definition apexes_at (a : nat) (c1 c2 : name) : nat := count_key (snd (tables_at a)) (edge_key c1 c2).
Definition k_across (a s b s' : nat) (c : name) : name := cshift (snd c) (neighbour a s b s' (fst c)).
Definition sides_with (a : nat) (c1 c2 : name) : list nat := filter (fun s => on a s c1 && on a s c2) (seq 0 (k_sides (k_patch a))).
Definition doubled (a : nat) (c1 c2 : name) : list nat := match sides_with a c1 c2 with
  | [] => [2 * (pieces_at a c1 c2 + apexes_at a c1 c2)]
  | [s] => flat_map (fun b => flat_map (fun s' => if can_meet (k_patch a) s (k_patch b) s' then [facets_at a c1 c2 + facets_at b (k_across a s b s' c1) (k_across a s b s' c2)] else [])
      (seq 0 (k_sides (k_patch b)))) (seq 0 (length system))
  | _ => [12] end.
Definition can_be_six (a : nat) (c1 c2 : name) : bool := existsb (Nat.eqb 12) (doubled a c1 c2).
Definition check_triangle (a : nat) (o : occupant) : bool :=
  let ps := ordered (k_occupant_names a o) in
  let vs := map (fun p => (p, doubled a (fst p) (snd p))) ps in
  forallb (fun v => forallb (fun d => (d =? 10) || (d =? 12)) (snd v)) vs &&
  let sixes := filter (fun v => existsb (Nat.eqb 12) (snd v)) vs in
  forallb (fun v => forallb (fun w => negb (ceqb (fst (fst v)) (fst (fst w))) || ceqb (snd (fst v)) (snd (fst w))) sixes) sixes.
Definition check_axis (a q : nat) : bool := let p := k_patch a in let n := k_rim_count p q in
  ((n =? 5) || (n =? 6)) && upto (length system) (fun b => upto (k_sides (k_patch b)) (fun s' => if can_meet p (side_of h a q) (k_patch b) s' then
    let q' := fst (pyramid_mate h a q b s') in let n' := k_rim_count (k_patch b) q' in
    upto n (fun e => let e' := next n' (rim_mate h a q b s' e) in
      let mine := can_be_six a (k_apex_name a q) (k_rim_name a q e) in let theirs := can_be_six b (k_apex_name b q') (k_rim_name b q' e') in
      negb (mine && theirs) && ((n =? 5) || negb (mine || theirs))) else true)).

(** ** Corners of the mosaic: the samples in the corner of a tile that is turned *)
Definition k_local (t : k_turning A) (d : A * A) : A * A := let '(_, (a, b, c, e)) := fst t in
  (asub (amul (fst d) e) (amul (snd d) c), asub (amul (snd d) a) (amul (fst d) b)).
Definition k_inward (p : kpatch) (s : nat) (e : A * A) : A := let u := base_diff A asub amul (k_start p s) (k_start p (next (k_sides p) s)) in
  asub (amul (fst u) (snd e)) (amul (snd u) (fst e)).
Definition is_in (a s : nat) (t : k_turning A) (d : A * A) : bool := let p := k_patch a in let e := k_local t d in
  alt zero (k_inward p s e) && alt zero (k_inward p (prev (k_sides p) s) e).
Definition is_out (a s : nat) (t : k_turning A) (d : A * A) : bool := let p := k_patch a in let e := k_local t d in
  alt (k_inward p s e) zero || alt (k_inward p (prev (k_sides p) s) e) zero.
Definition positive_turning (t : k_turning A) : bool := let '(_, (a, b, c, d)) := fst t in alt zero (asub (amul a d) (amul b c)).
Definition check_corner (a s : nat) : bool := let p := k_patch a in
  forallb (fun t => existsb (is_in a s t) samples && forallb (fun d => is_in a s t d || is_out a s t d) samples) turnings &&
  let shares := map (fun t => 12 * length (filter (is_in a s t) samples)) turnings in
  forallb (fun o => forallb (fun q => let '(c1, c2) := q in if on a s c1 && on a s c2 && (on a (prev (k_sides p) s) c1 && on a (prev (k_sides p) s) c2) then
    let share := facets_at a c1 c2 * length samples in forallb (Nat.eqb share) shares else true) (ordered (k_occupant_names a o))) (occupants A aofZ p).
Definition check_corners : bool := if r =? 1 then
  match samples with [] => false | _ => true end && forallb positive_turning turnings &&
  upto (length system) (fun a => upto (k_sides (k_patch a)) (check_corner a)) else true.
Definition check_edges : bool := upto (length system) (fun a => let p := k_patch a in
  check_names a && check_apexes a && upto (k_sides p) (fun s => upto (length system) (fun b => upto (k_sides (k_patch b)) (check_neighbours a s b))) &&
  forallb (check_triangle a) (occupants A aofZ p) && upto (length (k_pyramids A p)) (check_axis a)).
End Count.
Definition check_tcp : bool := let tables := indexes in check_edges tables && check_corners tables.
End Ring.
