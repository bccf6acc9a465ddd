(** * Systems of patches: the finite checks

    Boolean functions over any ring of exact numbers, as in Checker.v, and no proof.  The points of a
    patch have a positive weight: the coordinates are those of the point, times the weight.
    MosaicSoundness.v proves that "true" implies the conditions of MosaicPatches.v. *)
From Coq Require Import Reals NArith ZArith List Bool.
From Acutile Require Import Statement Tetrahedra Degree Domain Bounds Checker MosaicStatement MosaicPoints MosaicPatches.
Import ListNotations.
Local Open Scope nat_scope.

Definition occupant_eqb (o o' : occupant) : bool := match o, o' with
  | Facet k f, Facet k' f' | Lateral k f, Lateral k' f' => (k =? k') && (f =? f') | _, _ => false end.
Definition entry_eqb (x y : entry) : bool := match x, y with
  | Inner o n, Inner o' n' => occupant_eqb o o' && z3eqb n n'
  | Wall s w, Wall s' w' => (s =? s') && (w =? w') | _, _ => false end.
Definition mate_eqb (x y : nat * Z3) : bool := (fst x =? fst y) && z3eqb (snd x) (snd y).
Definition upto (n : nat) (f : nat -> bool) : bool := forallb f (seq 0 n).
Definition some_upto (n : nat) (f : nat -> bool) : bool := existsb f (seq 0 n).

Section Ring.
Variables (A : Type) (aadd asub amul : A -> A -> A) (aofZ : Z -> A) (alt ale : A -> A -> bool).
(** Hints: a common divisor of numbers, and quotients by it. *)
Variables (content : list A -> Z) (quot : Z -> A -> A).
Notation v3 := (v3 A).
Notation V3 := (V3 A).
Notation vX := (vX A).
Notation vY := (vY A).
Notation vZ := (vZ A).
Notation zero := (zero A aofZ).
Notation ktet := (ktet A).
Notation kL := (kL A aadd asub amul).
Notation kverts := (kverts A).
Notation k22 := (k22 A).
Notation k33 := (k33 A).
Notation k23 := (k23 A).

(** ** Points with weights *)
Record spot := Spot { weight : A; numerators : v3 }.
Definition aeq (x y : A) : bool := ale x y && ale y x.
Definition one := aofZ 1.
Definition vtimes (w : A) (v : v3) : v3 := V3 (amul w (vX v)) (amul w (vY v)) (amul w (vZ v)).
Definition veq (u v : v3) : bool := aeq (vX u) (vX v) && aeq (vY u) (vY v) && aeq (vZ u) (vZ v).
Definition spot_eq (p q : spot) : bool :=
  if aeq (weight p) (weight q) then veq (numerators p) (numerators q)
  else veq (vtimes (weight q) (numerators p)) (vtimes (weight p) (numerators q)).
Definition shifted (z : Z) (w x : A) : A := if Z.eqb z 0 then x else aadd x (amul (aofZ z) w).
Definition spot_lift (n : Z3) (p : spot) : spot := let '(a, b, c) := n in let w := weight p in let v := numerators p in
  Spot w (V3 (shifted a w (vX v)) (shifted b w (vY v)) (shifted c w (vZ v))).
(** The same numerators over one weight. *)
Fixpoint even (l : list spot) : A * list v3 := match l with
  | [] => (one, [])
  | p :: l => match l with [] => (weight p, [numerators p]) | _ =>
      let '(w, vs) := even l in
      if aeq (weight p) w then (w, numerators p :: vs)
      else (amul (weight p) w, vtimes w (numerators p) :: map (vtimes (weight p)) vs) end
  end.
Definition reduce (p : spot) : spot :=
  let v := numerators p in let g := content [weight p; vX v; vY v; vZ v] in
  if Z.leb g 1 then p else
  let p' := Spot (quot g (weight p)) (V3 (quot g (vX v)) (quot g (vY v)) (quot g (vZ v))) in
  if aeq (amul (aofZ g) (weight p')) (weight p) && veq (vtimes (aofZ g) (numerators p')) v then p' else p.

(** ** Patches *)
Definition corners := (spot * spot * spot * spot)%type.
Definition spots := (spot * spot * spot)%type.
Record kpatch := KPatch { k_edges : list (Z * spot); k_pyramids : list (spot * list spot); k_pieces : list corners }.
Definition no_spot := Spot one (vzero A aofZ).
Definition k_sides (p : kpatch) : nat := length (k_edges p).
Definition k_class (p : kpatch) (s : nat) : Z := fst (nth s (k_edges p) (0%Z, no_spot)).
Definition k_start (p : kpatch) (s : nat) : spot := snd (nth s (k_edges p) (0%Z, no_spot)).
Definition k_pyramid (p : kpatch) (q : nat) : spot * list spot := nth q (k_pyramids p) (no_spot, []).
Definition k_apex (p : kpatch) (q : nat) : spot := fst (k_pyramid p q).
Definition k_rim (p : kpatch) (q : nat) : list spot := snd (k_pyramid p q).
Definition k_rim_count (p : kpatch) (q : nat) : nat := length (k_rim p q).
Definition k_rim_at (p : kpatch) (q e : nat) : spot := nth e (k_rim p q) no_spot.
Definition k_piece (p : kpatch) (k : nat) : corners := nth k (k_pieces p) (no_spot, no_spot, no_spot, no_spot).
Definition corner_list (t : corners) : list spot := let '(a, b, c, d) := t in [a; b; c; d].
Definition k_corner (t : corners) (i : nat) : spot := let '(a, b, c, d) := t in match i with 0 => a | 1 => b | 2 => c | _ => d end.
Definition k_facet (t : corners) (i : nat) : spots :=
  let '(a, b, c, d) := t in match i with 0 => (b, d, c) | 1 => (a, c, d) | 2 => (a, d, b) | _ => (a, b, c) end.
Definition map_spots (f : spot -> spot) (t : spots) : spots := let '(a, b, c) := t in (f a, f b, f c).
Definition spots_eq (f g : spots) : bool :=
  let '(a, b, c) := f in let '(a', b', c') := g in spot_eq a a' && spot_eq b b' && spot_eq c c'.
(** The same triangle, seen from the other side. *)
Definition spots_opposite (f g : spots) : bool := let '(a, b, c) := g in
  spots_eq f (b, a, c) || spots_eq f (a, c, b) || spots_eq f (c, b, a).
Definition k_triangle (p : kpatch) (o : occupant) : spots := match o with
  | Facet k f => k_facet (k_piece p k) f
  | Lateral q e => (k_rim_at p q e, k_apex p q, k_rim_at p q (next (k_rim_count p q) e)) end.
Definition k_occupant (p : kpatch) (o : occupant) : bool := match o with
  | Facet k f => (k <? length (k_pieces p)) && (f <? 4)
  | Lateral q e => (q <? length (k_pyramids p)) && (e <? k_rim_count p q) end.
Definition occupants (p : kpatch) : list occupant :=
  flat_map (fun k => map (Facet k) [0; 1; 2; 3]) (seq 0 (length (k_pieces p))) ++
  flat_map (fun q => map (Lateral q) (seq 0 (k_rim_count p q))) (seq 0 (length (k_pyramids p))).

(** ** Sides *)
Variables (g : kgram A) (r : nat).
(** Positive on the inner side of a wall: the coefficients of y, z and the weight. *)
Definition side_form (p : kpatch) (s : nat) : A * A * A :=
  let P := k_start p s in let Q := k_start p (next (k_sides p) s) in
  let minor a b c d := asub (amul a d) (amul b c) in
  let '(w, y, z) := (weight P, vY (numerators P), vZ (numerators P)) in
  match r, s with
  | 1, _ => let '(w', y', z') := (weight Q, vY (numerators Q), vZ (numerators Q)) in (minor z w z' w', minor w y w' y', minor y z y' z')
  | _, 0 => (zero, w, asub zero z)
  | _, _ => (zero, asub zero w, z)
  end.
Definition k_left (f : A * A * A) (x : spot) : A := let '(b, c, d) := f in
  aadd (aadd (amul b (vY (numerators x))) (amul c (vZ (numerators x)))) (amul d (weight x)).
Definition k_in_prism (fs : list (A * A * A)) (x : spot) : bool := forallb (fun f => ale zero (k_left f x)) fs.
Definition side_forms (p : kpatch) : list (A * A * A) := map (side_form p) (seq 0 (k_sides p)).

(** From the coordinates of patch q, in its side s', to those of patch p, in its side s: [carry] of MosaicPatches.v. *)
Definition base_diff (P Q : spot) : A * A := (* Q - P, times both weights *)
  (asub (amul (weight P) (vY (numerators Q))) (amul (weight Q) (vY (numerators P))),
   asub (amul (weight P) (vZ (numerators Q))) (amul (weight Q) (vZ (numerators P)))).
Definition base_dot (u v : A * A) : A :=
  aadd (aadd (amul (k22 g) (amul (fst u) (fst v))) (amul (k33 g) (amul (snd u) (snd v))))
    (amul (k23 g) (aadd (amul (fst u) (snd v)) (amul (snd u) (fst v)))).
Definition base_turn (u : A * A) : A * A :=
  (aadd (amul (k23 g) (fst u)) (amul (k33 g) (snd u)), asub zero (aadd (amul (k22 g) (fst u)) (amul (k23 g) (snd u)))).
Definition k_carry (p : kpatch) (s : nat) (q : kpatch) (s' : nat) (x : spot) : spot :=
  let P := k_start p s in let Q := k_start q s' in let w := weight x in let wP := weight P in let wQ := weight Q in
  match r with
  | 1 =>
    let P' := k_start p (next (k_sides p) s) in let Q' := k_start q (next (k_sides q) s') in
    let u := base_diff P P' in let v := base_diff Q Q' in let mu := amul wP (weight P') in let nu := amul wQ (weight Q') in
    let n := base_dot u u in let b := base_diff Q x in let t := base_turn u in
    let X := base_dot b v in let Y := asub (amul (fst v) (snd b)) (amul (snd v) (fst b)) in
    let nun := amul nu n in let wq := amul w wQ in
    let own := amul wP (amul wq nun) in let mm := amul mu mu in
    let at_ c u t := aadd (amul own c) (amul mm (asub (amul Y t) (amul X u))) in
    reduce (Spot (amul mu (amul wq nun))
      (V3 (aadd (asub (amul (vX (numerators x)) (amul mu (amul wQ nun))) (amul (vX (numerators Q)) (amul mu (amul w nun))))
             (amul (vX (numerators P)) (amul (weight P') (amul wq nun))))
          (at_ (vY (numerators P')) (fst u) (fst t)) (at_ (vZ (numerators P')) (snd u) (snd t))))
  | _ =>
    let c x y z := aadd (asub (amul x (amul wP wQ)) (amul y (amul w wP))) (amul z (amul w wQ)) in
    let '(a, b, d) := (numerators x, numerators Q, numerators P) in
    reduce (Spot (amul w (amul wP wQ)) (V3 (c (vX a) (vX b) (vX d)) (c (vY a) (vY b) (vY d)) (c (vZ a) (vZ b) (vZ d))))
  end.
(** Sides of one class, that can meet; for r = 1 they have one length. *)
Definition can_meet (p : kpatch) (s : nat) (q : kpatch) (s' : nat) : bool :=
  Z.eqb (k_class p s) (k_class q s') && (if r =? 2 then negb (s =? s') else true).
Definition same_length (p : kpatch) (s : nat) (q : kpatch) (s' : nat) : bool :=
  if r =? 1 then
    let P := k_start p s in let P' := k_start p (next (k_sides p) s) in let Q := k_start q s' in let Q' := k_start q (next (k_sides q) s') in
    let u := base_diff P P' in let v := base_diff Q Q' in let mu := amul (weight P) (weight P') in let nu := amul (weight Q) (weight Q') in
    let n := base_dot u u in alt zero n && aeq (amul n (amul nu nu)) (amul (base_dot v v) (amul mu mu))
  else true.

(** ** The conditions *)
Variables (system : list kpatch) (h : hints).
(** Hints: the apexes of joins on the other side of each pyramid; a spot in one tetrahedron of each piece. *)
Variables (apexes : nat -> nat -> list spot) (home : nat -> nat * spot).
Definition k_patch (a : nat) : kpatch := nth a system (KPatch [] [] []).
Definition positive_spots (a : nat) : bool := let p := k_patch a in let ok x := alt zero (weight x) in
  forallb (fun e => ok (snd e)) (k_edges p) && forallb (fun y => ok (fst y) && forallb ok (snd y)) (k_pyramids p) &&
  forallb (fun t => forallb ok (corner_list t)) (k_pieces p) &&
  upto (length (k_pyramids p)) (fun q => forallb ok (apexes a q)).
Definition check_occupant (a : nat) (o : occupant) : bool := let p := k_patch a in
  match behind h a o with
  | Inner o' n => k_occupant p o' && latb r n && entry_eqb (behind h a o') (Inner o (zopp3 n)) &&
      spots_opposite (k_triangle p o) (map_spots (spot_lift n) (k_triangle p o'))
  | Wall s w => (s <? k_sides p) && (w <? owners h a s) && occupant_eqb (owner h a s w) o &&
      match o with Facet _ _ => true | Lateral _ _ => false end
  end.
Definition tet_of (t : corners) : ktet := match snd (even (corner_list t)) with
  | [a; b; c; d] => KT A a b c d | _ => KT A (vzero A aofZ) (vzero A aofZ) (vzero A aofZ) (vzero A aofZ) end.
Definition tet_and (t : corners) (x : spot) : ktet * v3 := match snd (even (x :: corner_list t)) with
  | [x; a; b; c; d] => (KT A a b c d, x) | _ => (KT A (vzero A aofZ) (vzero A aofZ) (vzero A aofZ) (vzero A aofZ), vzero A aofZ) end.
Definition positive_tet (t : corners) : bool := chk_vol A aadd asub amul aofZ alt (tet_of t).
Definition check_piece (fs : list (A * A * A)) (t : corners) : bool := positive_tet t && forallb (k_in_prism fs) (corner_list t).
(** Two points that no period takes to each other. *)
Definition strict (x y : A) : bool := alt x y || alt y x.
Definition fraction_between (x y : A) : bool := (* x / y is between two successive integers *)
  existsb (fun k => alt (amul (aofZ k) y) x && alt x (amul (aofZ (k + 1)) y)) [-8; -7; -6; -5; -4; -3; -2; -1; 0; 1; 2; 3; 4; 5; 6; 7]%Z.
Definition apart (p q : spot) : bool :=
  let d f := asub (amul (weight q) (f (numerators p))) (amul (weight p) (f (numerators q))) in let w := amul (weight p) (weight q) in
  strict zero (d vZ) || fraction_between (d vX) w || (if r =? 1 then strict zero (d vY) else fraction_between (d vY) w).
(** No period takes the second rim to the first one: it would take some corner y of the second one to the first corner x of the first one. *)
Definition unequal (p q : spot) : bool :=
  let d f := strict (amul (weight q) (f (numerators p))) (amul (weight p) (f (numerators q))) in d vX || d vY || d vZ.
Definition shifts : list Z3 :=
  flat_map (fun x => map (fun y => (x, y, 0)%Z) (if r =? 1 then [0%Z] else [-2; -1; 0; 1; 2]%Z)) [-2; -1; 0; 1; 2]%Z.
Definition rims_differ (l l' : list spot) : bool := match l with
  | [] => false
  | x :: _ => forallb (fun y => apart x y || existsb (fun n => spot_eq x (spot_lift n y) &&
      existsb (fun x => forallb (fun y => unequal x (spot_lift n y)) l') l) shifts) l'
  end.
Definition check_pyramid (a q : nat) : bool := let p := k_patch a in let s := side_of h a q in let fs := side_forms p in
  (s <? k_sides p) && (0 <? k_rim_count p q) && k_in_prism fs (k_apex p q) && alt zero (k_left (side_form p s) (k_apex p q)) &&
  forallb (fun x => k_in_prism fs x && aeq (k_left (side_form p s) x) zero) (k_rim p q) &&
  upto (k_sides p) (fun s2 => (s2 =? s) || existsb (fun x => alt zero (k_left (side_form p s2) x)) (k_rim p q)) &&
  upto (length (k_pyramids p)) (fun q2 => (q2 =? q) || negb (side_of h a q2 =? s) ||
    rims_differ (k_rim p q) (k_rim p q2)).
Definition lateral (p : kpatch) (q e : nat) (y : spot) : corners := (y, k_rim_at p q e, k_rim_at p q (next (k_rim_count p q) e), k_apex p q).
Definition check_joins (a q : nat) : bool := let p := k_patch a in
  forallb (fun y => upto (k_rim_count p q) (fun e => positive_tet (lateral p q e y)) &&
    (* the segment between the apexes meets the wall in the side *)
    let f := side_form p (side_of h a q) in let l := k_apex p q in
    upto (k_sides p) (fun t => ale zero (asub (amul (k_left f l) (k_left (side_form p t) y)) (amul (k_left f y) (k_left (side_form p t) l))))) (apexes a q).
Definition check_pair (a s b s' : nat) : bool := let p := k_patch a in let p' := k_patch b in
  if can_meet p s p' s' then
  same_length p s p' s' &&
  upto (length (k_pyramids p)) (fun q => if side_of h a q =? s then
    let '(q', m) := pyramid_mate h a q b s' in
    (q' <? length (k_pyramids p')) && (side_of h b q' =? s') && latb r m && mate_eqb (pyramid_mate h b q' a s) (q, zopp3 m) &&
    existsb (spot_eq (spot_lift m (k_carry p s p' s' (k_apex p' q')))) (apexes a q) &&
    let across := map (fun x => spot_lift m (k_carry p s p' s' x)) (k_rim p' q') in
    upto (k_rim_count p q) (fun e => let e' := rim_mate h a q b s' e in
      (e' <? k_rim_count p' q') && (rim_mate h b q' a s e' =? e) &&
      spot_eq (k_rim_at p q e) (nth (next (k_rim_count p' q') e') across no_spot) &&
      spot_eq (k_rim_at p q (next (k_rim_count p q) e)) (nth e' across no_spot)) else true) &&
  upto (owners h a s) (fun w => let '(w', m) := wall_mate h a s b s' w in
    (w' <? owners h b s') && latb r m && mate_eqb (wall_mate h b s' a s w') (w, zopp3 m) &&
    spots_opposite (k_triangle p (owner h a s w)) (map_spots (fun x => spot_lift m (k_carry p s p' s' x)) (k_triangle p' (owner h b s' w'))))
  else true.
Definition check_wall (a s w : nat) : bool := k_occupant (k_patch a) (owner h a s w) && entry_eqb (behind h a (owner h a s w)) (Wall s w).
(** The home of a patch: it is outside of all other cells.  In the fibre all corners are within three periods. *)
Definition within_3 (x y : spot) : bool :=
  let w := amul (weight x) (weight y) in
  let ok f := let d := asub (amul (weight y) (f (numerators x))) (amul (weight x) (f (numerators y))) in
    alt (amul (aofZ (-3)) w) d && alt d (amul (aofZ 3) w) in
  ok vX && (if r =? 1 then true else ok vY).
Definition is_outside (t : corners) (x : spot) : bool := let '(t, x) := tet_and t x in existsb (fun i => alt (kL t i x) zero) I4.
Definition missed (t : corners) (x : spot) : bool :=
  forallb (within_3 x) (corner_list t) && forallb (fun n => is_outside t (spot_lift n x)) shifts.
Definition check_home (a : nat) : bool := let p := k_patch a in let '(k, x) := home a in
  (k <? length (k_pieces p)) && alt zero (weight x) &&
  (let '(t, y) := tet_and (k_piece p k) x in forallb (fun i => alt zero (kL t i y)) I4) &&
  forallb (fun f => alt zero (k_left f x)) (side_forms p) &&
  forallb (within_3 x) (corner_list (k_piece p k)) && forallb (fun n => z3eqb n z30 || is_outside (k_piece p k) (spot_lift n x)) shifts &&
  upto (length (k_pieces p)) (fun k' => (k' =? k) || missed (k_piece p k') x) &&
  upto (length (k_pyramids p)) (fun q => forallb (fun y => upto (k_rim_count p q) (fun e => missed (lateral p q e y) x)) (apexes a q)).

Definition zero_blocks : bool := aeq (k13 A g) zero && (if r =? 1 then aeq (k12 A g) zero else aeq (k23 g) zero).
(** The polygon is strictly convex; a segment has two ends. *)
Definition check_sides (a : nat) : bool := let p := k_patch a in let n := k_sides p in
  if r =? 1 then (3 <=? n) && upto n (fun s => upto n (fun t => (t =? s) || (t =? prev n s) || alt zero (k_left (side_form p t) (k_start p s)))) else n =? 2.
Definition check_patch (a : nat) : bool := let p := k_patch a in
  positive_spots a && check_sides a &&
  forallb (check_occupant a) (occupants p) && forallb (check_piece (side_forms p)) (k_pieces p) &&
  upto (length (k_pyramids p)) (fun q => check_pyramid a q && check_joins a q) && check_home a &&
  upto (k_sides p) (fun s => upto (owners h a s) (check_wall a s) &&
    upto (length system) (fun b => upto (k_sides (k_patch b)) (check_pair a s b))).
Definition check_system : bool :=
  ((r =? 1) || (r =? 2)) && chk_gram A aadd asub amul aofZ alt g && zero_blocks && upto (length system) check_patch.

(** ** Delaunay *)
Definition choices (a : nat) (o : occupant) : list spot := match o with Facet _ _ => [no_spot] | Lateral q _ => apexes a q end.
Definition k_cell (p : kpatch) (o : occupant) (y : spot) : corners := match o with Facet k f => k_piece p k | Lateral q e => lateral p q e y end.
Definition k_opposite (p : kpatch) (o : occupant) (y : spot) : spot := match o with Facet k f => k_corner (k_piece p k) f | Lateral q e => y end.
(** Outside of the ball of a tetrahedron, strictly or not: [less] is [alt] or [ale]. *)
Definition outside_ball (less : A -> A -> bool) (t : corners) (x : spot) : bool :=
  let '(t, x) := tet_and t x in less (kpower A aadd asub amul g t x) zero.
Definition check_local (less : A -> A -> bool) (a : nat) (o : occupant) : bool := let p := k_patch a in
  match behind h a o with
  | Inner o' n => forallb (fun y => forallb (fun y' => outside_ball less (k_cell p o y) (spot_lift n (k_opposite p o' y'))) (choices a o')) (choices a o)
  | Wall s w => match o with
    | Facet k f => upto (length system) (fun b => let p' := k_patch b in upto (k_sides p') (fun s' => if can_meet p s p' s' then
        let '(w', m) := wall_mate h a s b s' w in
        match owner h b s' w' with
        | Facet k' f' => outside_ball less (k_piece p k) (spot_lift m (k_carry p s p' s' (k_corner (k_piece p' k') f')))
        | Lateral _ _ => true end else true))
    | Lateral _ _ => true end
  end.
Definition check_axes (less : A -> A -> bool) (a q : nat) : bool := let p := k_patch a in let n := k_rim_count p q in
  forallb (fun y => upto n (fun e => outside_ball less (lateral p q e y) (k_rim_at p q (next n (next n e))) &&
    outside_ball less (lateral p q e y) (k_rim_at p q (prev n e)))) (apexes a q).
Definition check_delaunay (less : A -> A -> bool) : bool := upto (length system) (fun a => let p := k_patch a in
  forallb (check_local less a) (occupants p) && upto (length (k_pyramids p)) (check_axes less a)).

(** ** Statements about single cells, by the checks of Checker.v *)
Definition alone (t : ktet) : cert A :=
  let corner k := (k, z30) in
  Cert A 1 (kverts t) [CT (corner 0%N) (corner 1%N) (corner 2%N) (corner 3%N) None None None None] g 0 [] [] [].
Definition check_alone (s : cstatement A) (t : corners) : bool := let c := alone (tet_of t) in
  forallb (chk_vol A aadd asub amul aofZ alt) (positions A aadd aofZ c) && check_statement A aadd asub amul aofZ alt ale c s.
Definition joins (a : nat) : list corners := let p := k_patch a in
  flat_map (fun q => flat_map (fun y => map (fun e => lateral p q e y) (seq 0 (k_rim_count p q))) (apexes a q)) (seq 0 (length (k_pyramids p))).
Definition every_cell (f : corners -> bool) : bool := upto (length system) (fun a => forallb f (k_pieces (k_patch a)) && forallb f (joins a)).
Definition some_piece (f : corners -> bool) : bool := some_upto (length system) (fun a => existsb f (k_pieces (k_patch a))).
Definition check_bound (mk : relation -> cstatement A) (rel : relation) : bool := match rel with
  | Maximum => every_cell (check_alone (mk AtMost)) && some_piece (check_alone (mk Maximum))
  | Minimum => every_cell (check_alone (mk AtLeast)) && some_piece (check_alone (mk Minimum))
  | _ => every_cell (check_alone (mk rel)) end.
Definition check_sentence (s : cstatement A) : bool := match s with
  | CAcute _ | CNonobtuse _ => every_cell (check_alone s)
  | CLargestDihedralAngle _ rel sg p q => check_bound (fun rel => CLargestDihedralAngle A rel sg p q) rel
  | CSmallestDihedralAngle _ rel sg p q => check_bound (fun rel => CSmallestDihedralAngle A rel sg p q) rel
  | CSquaredRadiusEdgeRatio _ rel p q => check_bound (fun rel => CSquaredRadiusEdgeRatio A rel p q) rel
  | CDelaunay _ => check_delaunay alt
  | CWeaklyDelaunay _ => check_delaunay ale
  | _ => false
  end.

(** ** Heights for r = 1: a set of rotations *)
Definition matrix := (A * (A * A * A * A))%type. (* a weight, the images of the two basis vectors of the base *)
Definition fraction := (A * A)%type.
Definition matrix_eq (m n : matrix) : bool :=
  let '(w, (a, b, c, d)) := m in let '(v, (a', b', c', d')) := n in
  aeq (amul v a) (amul w a') && aeq (amul v b) (amul w b') && aeq (amul v c) (amul w c') && aeq (amul v d) (amul w d').
Definition matrix_differs (m n : matrix) : bool :=
  let '(w, (a, b, c, d)) := m in let '(v, (a', b', c', d')) := n in
  strict (amul v a) (amul w a') || strict (amul v b) (amul w b') || strict (amul v c) (amul w c') || strict (amul v d) (amul w d').
Definition matrix_reduce (m : matrix) : matrix := let '(w, (a, b, c, d)) := m in
  let k := content [w; a; b; c; d] in if Z.leb k 1 then m else
  let m' := (quot k w, (quot k a, quot k b, quot k c, quot k d)) in
  let '(w', (a', b', c', d')) := m' in let ok x y := aeq (amul (aofZ k) x) y in
  if ok w' w && ok a' a && ok b' b && ok c' c && ok d' d then m' else m.
Definition matrix_compose (m n : matrix) : matrix :=
  let '(w, (a, b, c, d)) := m in let '(v, (x, y, z, t)) := n in
  matrix_reduce (amul w v, (aadd (amul x a) (amul y c), aadd (amul x b) (amul y d), aadd (amul z a) (amul t c), aadd (amul z b) (amul t d))).
Definition k_linear (p : kpatch) (s : nat) (q : kpatch) (s' : nat) : matrix :=
  let P := k_start p s in let P' := k_start p (next (k_sides p) s) in let Q := k_start q s' in let Q' := k_start q (next (k_sides q) s') in
  let u := base_diff P P' in let v := base_diff Q Q' in let mu := amul (weight P) (weight P') in let nu := amul (weight Q) (weight Q') in
  let t := base_turn u in
  let im X Y := (amul mu (asub (amul Y (fst t)) (amul X (fst u))), amul mu (asub (amul Y (snd t)) (amul X (snd u)))) in
  let e2 := im (aadd (amul (k22 g) (fst v)) (amul (k23 g) (snd v))) (asub zero (snd v)) in
  let e3 := im (aadd (amul (k23 g) (fst v)) (amul (k33 g) (snd v))) (fst v) in
  matrix_reduce (amul nu (base_dot u u), (fst e2, snd e2, fst e3, snd e3)).
(** The difference of two fractions, and that it is an integer. *)
Definition offset_of (p : kpatch) (s : nat) : fraction := (vX (numerators (k_start p s)), weight (k_start p s)).
Definition plus_fraction (x y : fraction) : fraction := (aadd (amul (fst x) (snd y)) (amul (fst y) (snd x)), amul (snd x) (snd y)).
Definition minus_fraction (x y : fraction) : fraction := (asub (amul (fst x) (snd y)) (amul (fst y) (snd x)), amul (snd x) (snd y)).
Definition some_integers : list Z := map (fun k => Z.of_nat k - 20)%Z (seq 0 41).
Definition is_whole (x : fraction) : bool := existsb (fun z => aeq (fst x) (amul (aofZ z) (snd x))) some_integers.
Definition k_turning := (matrix * fraction)%type.
Variable turnings : list k_turning.
Definition check_rotations : bool :=
  forallb (fun t => alt zero (fst (fst t)) && alt zero (snd (snd t))) turnings &&
  match turnings with t :: _ => matrix_eq (fst t) (one, (one, zero, zero, one)) && aeq (fst (snd t)) zero | [] => false end &&
  upto (length system) (fun a => let p := k_patch a in upto (k_sides p) (fun s => upto (length system) (fun b => let p' := k_patch b in upto (k_sides p') (fun s' =>
    if can_meet p s p' s' then let m := k_linear p s p' s' in let d := minus_fraction (offset_of p s) (offset_of p' s') in
      forallb (fun t => existsb (fun t' => matrix_eq (fst t') (matrix_compose (fst t) m) && is_whole (minus_fraction (snd t') (plus_fraction (snd t) d))) turnings) turnings
    else true)))) &&
  forallb (fun t => forallb (fun t' => matrix_differs (fst t) (fst t') || is_whole (minus_fraction (snd t) (snd t'))) turnings) turnings.
Definition check_heights : bool := if r =? 1 then check_rotations else true.
End Ring.
