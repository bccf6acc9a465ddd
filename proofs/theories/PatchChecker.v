(** * Systems of patches: the finite checks

    Boolean functions on integers, no proof.  [check_system] is what PatchSoundness.v proves
    sound.  Mates of facets are given (they are hints: the checks do not believe them). *)
From Coq Require Import Reals ZArith List Bool.
From Acutile Require Import Statement PatchStatement.
Import ListNotations.

(** ** Numbers a + b sqrt 3 *)
Definition zz := (Z * Z)%type.
Definition zint (n : Z) : zz := (n, 0%Z).
Definition zadd (x y : zz) : zz := (fst x + fst y, snd x + snd y)%Z.
Definition zsub (x y : zz) : zz := (fst x - fst y, snd x - snd y)%Z.
Definition zmul (x y : zz) : zz := (fst x * fst y + 3 * (snd x * snd y), fst x * snd y + snd x * fst y)%Z.
Definition zpos (x : zz) : bool := let '(a, b) := x in
  ((0 <? a) && (0 <=? b) || (0 <=? a) && (0 <? b) || (0 <? a) && (3 * (b * b) <? a * a) || (0 <? b) && (a * a <? 3 * (b * b)))%Z.
Definition zeq (x y : zz) : bool := (fst x =? fst y)%Z && (snd x =? snd y)%Z.
Definition znonneg (x : zz) : bool := zeq x (zint 0) || zpos x.

(** ** Spots *)
Definition spot_eq (x y : spot) : bool := zeq (height x) (height y) && zeq (ahead x) (ahead y) && zeq (aside x) (aside y).
Definition spot_sub (x y : spot) : spot := Spot (zsub (height x) (height y)) (zsub (ahead x) (ahead y)) (zsub (aside x) (aside y)).
Definition lift (n : Z) (x : spot) : spot := Spot (zadd (height x) (zint n)) (ahead x) (aside x).
Definition spot_dot (u v : spot) : zz :=
  zadd (zadd (zmul (height u) (height v)) (zmul (ahead u) (ahead v))) (zmul (aside u) (aside v)).
Definition spot_det (u v w : spot) : zz :=
  zadd (zsub (zmul (height u) (zsub (zmul (ahead v) (aside w)) (zmul (aside v) (ahead w))))
             (zmul (ahead u) (zsub (zmul (height v) (aside w)) (zmul (aside v) (height w)))))
       (zmul (aside u) (zsub (zmul (height v) (ahead w)) (zmul (ahead v) (height w)))).
Definition spot_orient (a b c d : spot) : zz := spot_det (spot_sub b a) (spot_sub c a) (spot_sub d a).

(** ** Tetrahedra of spots, and their facets as in Tetrahedra.v *)
Definition corners := (spot * spot * spot * spot)%type.
Definition spots := (spot * spot * spot)%type.
Definition lift_all (n : Z) (f : spots) : spots := let '(a, b, c) := f in (lift n a, lift n b, lift n c).
Definition spot_facet (t : corners) (i : nat) : spots :=
  let '(a, b, c, d) := t in match i with 0 => (b, d, c) | 1 => (a, c, d) | 2 => (a, d, b) | _ => (a, b, c) end%nat.
Definition on_side (f : spots) (x : spot) : zz := let '(a, b, c) := f in spot_orient a b c x.
Definition spot_inside (t : corners) (x : spot) : bool := forallb (fun i => zpos (on_side (spot_facet t i) x)) [0; 1; 2; 3]%nat.
Definition spot_outside (t : corners) (x : spot) : bool := existsb (fun i => zpos (zsub (zint 0) (on_side (spot_facet t i) x))) [0; 1; 2; 3]%nat.
Definition spots_eq (f g : spots) : bool :=
  let '(a, b, c) := f in let '(a', b', c') := g in spot_eq a a' && spot_eq b b' && spot_eq c c'.
(** The same triangle, seen from the other side. *)
Definition spots_opposite (f g : spots) : bool := let '(a, b, c) := g in
  spots_eq f (b, a, c) || spots_eq f (a, c, b) || spots_eq f (c, b, a).

(** The dihedral angle at ab, between c and d, is acute: Angles.v. *)
Definition spot_acute_at (a b c d : spot) : bool :=
  let e := spot_sub b a in let u := spot_sub c a in let w := spot_sub d a in
  zpos (zsub (zmul (spot_dot u w) (spot_dot e e)) (zmul (spot_dot u e) (spot_dot w e))).
Definition good_corners (t : corners) : bool := let '(a, b, c, d) := t in
  zpos (spot_orient a b c d) && spot_acute_at a b c d && spot_acute_at a c b d && spot_acute_at a d b c &&
  spot_acute_at b c a d && spot_acute_at b d a c && spot_acute_at c d a b.

(** ** Walls *)
Definition origin_spot := Spot (zint 0) (zint 0) (zint 0).
Definition no_edge := Edge origin_spot origin_spot [].
Definition edge_at (p : patch) (s : nat) : edge := nth s (edges p) no_edge.
Definition side_count (p : patch) : nat := length (edges p).
Definition vector (p : patch) (s : nat) : spot := spot_sub (start (edge_at p (next (side_count p) s))) (start (edge_at p s)).
(** Wall coordinates of a spot, seen from side s, in units of 1/576: height over the offset, along
    the side, to the left of it.  [turn] takes them to those from the other tile. *)
Definition wall (p : patch) (s : nat) (x : spot) : spot :=
  let u := vector p s in let b := spot_sub x (start (edge_at p s)) in
  Spot (zmul (zint 24) (height b)) (zadd (zmul (ahead b) (ahead u)) (zmul (aside b) (aside u)))
       (zsub (zmul (ahead u) (aside b)) (zmul (aside u) (ahead b))).
Definition turn (x : spot) : spot := Spot (height x) (zsub (zint 576) (ahead x)) (zsub (zint 0) (aside x)).
Definition wall_all p s (f : spots) : spots := let '(a, b, c) := f in (wall p s a, wall p s b, wall p s c).
Definition turn_all (f : spots) : spots := let '(a, b, c) := f in (turn a, turn b, turn c).
(** Positive to the left of side r, in wall coordinates of side s. *)
Definition left_of_side (p : patch) (s r : nat) (x : spot) : zz :=
  let A := wall p s (start (edge_at p r)) in let B := wall p s (start (edge_at p (next (side_count p) r))) in
  zsub (zmul (zsub (ahead B) (ahead A)) (zsub (aside x) (aside A))) (zmul (zsub (aside B) (aside A)) (zsub (ahead x) (ahead A))).
(** The same in the coordinates of the patch. *)
Definition left_of_edge (p : patch) (r : nat) (x : spot) : zz :=
  let A := start (edge_at p r) in let u := vector p r in
  zsub (zmul (ahead u) (zsub (aside x) (aside A))) (zmul (aside u) (zsub (ahead x) (ahead A))).

Definition rim_at (p : patch) (s e : nat) : spot := nth e (rim (edge_at p s)) (start (edge_at p s)).
Definition rim_count (p : patch) (s : nat) : nat := length (rim (edge_at p s)).
(** The cell of the join of two sides, in wall coordinates of the first one. *)
Definition join (p : patch) (s : nat) (q : patch) (s' e : nat) : corners :=
  (turn (wall q s' (apex (edge_at q s'))), wall p s (rim_at p s e), wall p s (rim_at p s (next (rim_count p s) e)), wall p s (apex (edge_at p s))).

(** ** Facets and their mates *)

(** A facet f of the tetrahedron k of the piece, or that of a pyramid in side s with the side e of the rim. *)
Inductive occupant := Facet (k f : nat) | Lateral (s e : nat).
(** It is that of another occupant, n periods higher, or the triangle w in the wall s. *)
Inductive entry := Inner (o : occupant) (n : Z) | Wall (s w : nat).

Definition corners_at (p : patch) (k : nat) : corners := nth k (pieces p) (origin_spot, origin_spot, origin_spot, origin_spot).
Definition triangle_of (p : patch) (o : occupant) : spots := match o with
  | Facet k f => spot_facet (corners_at p k) f
  | Lateral s e => (rim_at p s e, apex (edge_at p s), rim_at p s (next (rim_count p s) e)) end.
Definition is_occupant (p : patch) (o : occupant) : bool := match o with
  | Facet k f => (k <? length (pieces p)) && (f <? 4)
  | Lateral s e => (s <? side_count p) && (e <? rim_count p s) end%nat.
Definition occupants (p : patch) : list occupant :=
  flat_map (fun k => map (Facet k) [0; 1; 2; 3]%nat) (seq 0 (length (pieces p))) ++
  flat_map (fun s => map (Lateral s) (seq 0 (rim_count p s))) (seq 0 (side_count p)).
Definition occupant_eq (o o' : occupant) : bool := match o, o' with
  | Facet k f, Facet k' f' | Lateral k f, Lateral k' f' => (k =? k') && (f =? f') | _, _ => false end%nat.
Definition entry_eq (x y : entry) : bool := match x, y with
  | Inner o n, Inner o' n' => occupant_eq o o' && (n =? n')%Z
  | Wall s w, Wall s' w' => (s =? s')%nat && (w =? w')%nat | _, _ => false end.

Record hints := Hints {
  (* what is behind an occupant of a patch; the owner of the triangle w in the wall s; how many there are *)
  behind : nat -> occupant -> entry;
  owner : nat -> nat -> nat -> occupant;
  owners : nat -> nat -> nat;
  (* for side s of patch a and side s' of patch b: sides of the rims, triangles in the wall *)
  rim_mate : nat -> nat -> nat -> nat -> nat -> nat;
  wall_mate : nat -> nat -> nat -> nat -> nat -> nat * Z;
  (* a spot inside of a tetrahedron of the piece and of no other cell *)
  home : nat -> nat * spot }.

Section Check.
Variables (system : list patch) (h : hints).
Definition patch_at (a : nat) : patch := nth a system (Patch [] []).
Definition check_occupant (a : nat) (o : occupant) : bool := let p := patch_at a in
  match behind h a o with
  | Inner o' n => is_occupant p o' && entry_eq (behind h a o') (Inner o (- n)) &&
      spots_opposite (triangle_of p o) (lift_all (24 * n) (triangle_of p o'))
  | Wall s w => (s <? side_count p)%nat && (w <? owners h a s)%nat && occupant_eq (owner h a s w) o
  end.
(** The tetrahedra of the piece are acute, and in the prism; sides have the length 1; rims and
    apexes are in the prism, the apex not in its wall. *)
Definition in_prism (p : patch) (x : spot) : bool := forallb (fun r => znonneg (left_of_edge p r x)) (seq 0 (side_count p)).
Definition check_piece (p : patch) (t : corners) : bool := let '(a, b, c, d) := t in
  good_corners t && in_prism p a && in_prism p b && in_prism p c && in_prism p d.
Definition beside : spot := Spot (zint 0) (zint 288) (zint 144).
Definition check_edge (p : patch) (s : nat) : bool := let u := vector p s in
  zeq (zadd (zmul (ahead u) (ahead u)) (zmul (aside u) (aside u))) (zint 576) &&
  in_prism p (apex (edge_at p s)) && forallb (in_prism p) (rim (edge_at p s)) &&
  zpos (aside (wall p s (apex (edge_at p s)))) && forallb (fun x => zeq (aside (wall p s x)) (zint 0)) (rim (edge_at p s)) &&
  (* a spot over the middle of the side is inside, and no other side has the same line *)
  forallb (fun r => zpos (left_of_side p s r beside)) (seq 0 (side_count p)) &&
  forallb (fun s' => (s' =? s)%nat || existsb (fun r => let x := start (edge_at p r) in
    zpos (zsub (left_of_edge p s x) (left_of_edge p s' x)) || zpos (zsub (left_of_edge p s' x) (left_of_edge p s x)))
    (seq 0 (side_count p))) (seq 0 (side_count p)).
(** Two sides that can meet. *)
Definition check_pair (a s b s' : nat) : bool := let p := patch_at a in let q := patch_at b in
  forallb (fun e => let e' := rim_mate h a s b s' e in
    (e' <? rim_count q s')%nat && (rim_mate h b s' a s e' =? e)%nat &&
    spot_eq (wall p s (rim_at p s e)) (turn (wall q s' (rim_at q s' (next (rim_count q s') e')))) &&
    spot_eq (wall p s (rim_at p s (next (rim_count p s) e))) (turn (wall q s' (rim_at q s' e'))) &&
    good_corners (join p s q s' e)) (seq 0 (rim_count p s)) &&
  forallb (fun w => let '(w', n) := wall_mate h a s b s' w in
    (w' <? owners h b s')%nat && (let '(w2, n2) := wall_mate h b s' a s w' in (w2 =? w)%nat && (n2 =? - n)%Z) &&
    spots_opposite (wall_all p s (triangle_of p (owner h a s w)))
      (lift_all (576 * n) (turn_all (wall_all q s' (triangle_of q (owner h b s' w')))))) (seq 0 (owners h a s)) &&
  (* the segment between the apexes meets the wall in the side *)
  (let m := turn (wall q s' (apex (edge_at q s'))) in let l := wall p s (apex (edge_at p s)) in
   forallb (fun r => znonneg (zsub (zmul (aside l) (left_of_side p s r m)) (zmul (aside m) (left_of_side p s r l)))) (seq 0 (side_count p))).
Definition check_wall (a s w : nat) : bool := let p := patch_at a in
  is_occupant p (owner h a s w) && match owner h a s w with Facet _ _ => true | Lateral _ _ => false end &&
  entry_eq (behind h a (owner h a s w)) (Wall s w).
(** At the home spot: heights of all corners differ from it by at most [reach] units of c each. *)
Definition bounded_height (bound : Z) (x y : spot) : bool :=
  zpos (zsub (zint bound) (zsub (height x) (height y))) && zpos (zsub (zint bound) (zsub (height y) (height x))).
Definition missed (c : Z) (x : spot) (t : corners) : bool := let '(p, q, r, s) := t in
  forallb (bounded_height (3 * c) x) [p; q; r; s] && forallb (fun n => spot_outside t (lift (c * n) x)) [-3; -2; -1; 0; 1; 2; 3]%Z.
Definition check_home (a : nat) : bool := let p := patch_at a in let '(k, x) := home h a in
  (k <? length (pieces p))%nat && spot_inside (corners_at p k) x &&
  forallb (fun r => zpos (left_of_edge p r x)) (seq 0 (side_count p)) &&
  (let '(t1, t2, t3, t4) := corners_at p k in forallb (bounded_height 72 x) [t1; t2; t3; t4]) &&
  forallb (fun n => spot_outside (corners_at p k) (lift (24 * n) x)) [-3; -2; -1; 1; 2; 3]%Z &&
  forallb (fun k' => (k' =? k)%nat || missed 24 x (corners_at p k')) (seq 0 (length (pieces p))) &&
  forallb (fun s => forallb (fun b => forallb (fun s' => forallb (fun e =>
    missed 576 (wall p s x) (join p s (patch_at b) s' e)) (seq 0 (rim_count p s)))
    (seq 0 (side_count (patch_at b)))) (seq 0 (length system))) (seq 0 (side_count p)).

Definition check_system : bool :=
  forallb (fun a => let p := patch_at a in
    forallb (check_occupant a) (occupants p) && forallb (check_piece p) (pieces p) &&
    forallb (check_edge p) (seq 0 (side_count p)) && check_home a &&
    forallb (fun s => forallb (check_wall a s) (seq 0 (owners h a s)) &&
      forallb (fun b => forallb (check_pair a s b) (seq 0 (side_count (patch_at b)))) (seq 0 (length system))) (seq 0 (side_count p)))
    (seq 0 (length system)).
End Check.
