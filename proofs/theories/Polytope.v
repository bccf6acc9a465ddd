(** * What the format demands of a polytope, beyond the theorem

    No theorem speaks of this file: the domain is the convex hull of the points listed,
    whatever is said about its faces, and the checker uses them as hints.  A certificate
    is nevertheless refused where they are not the facets of the hull, each once; the
    extracted program does so too.  P1 to P3 are those of docs/soundness.md. *)
Require Import NArith ZArith List Bool.
From Acutile Require Import Tetrahedra Domain Checker.
Import ListNotations.
Local Open Scope nat_scope.

Definition among (i : N) (f : list N) : bool := existsb (N.eqb i) f.
Fixpoint distinct (f : list N) : bool := match f with [] => true | i :: f => negb (among i f) && distinct f end.
Definition subset (f g : list N) : bool := forallb (fun i => among i g) f.
Fixpoint no_two {X} (same : X -> X -> bool) (l : list X) : bool :=
  match l with [] => true | x :: l => negb (existsb (same x) l) && no_two same l end.
Definition indices (n : nat) : list N := map N.of_nat (seq 0 n).
(** The sides of a face in cyclic order, each with its smaller end first. *)
Definition sides (f : list N) : list (N * N) :=
  match f with [] => [] | i :: g => map (fun e => (N.min (fst e) (snd e), N.max (fst e) (snd e))) (combine f (g ++ [i])) end.
Definition twice {X} (same : X -> X -> bool) (l : list X) : bool :=
  forallb (fun x => Nat.eqb (length (filter (same x) l)) 2) l.
Definition same_side (a b : N * N) := N.eqb (fst a) (fst b) && N.eqb (snd a) (snd b).

Section Ring.
Variables (A : Type) (aadd asub amul : A -> A -> A) (aofZ : Z -> A) (alt ale : A -> A -> bool).
Variables (den : Z) (r : nat) (W : list (v3 A)).
Notation zero := (zero A aofZ).
Notation corner_at i := (nth (N.to_nat i) W (vzero A aofZ)).

Definition shape (faces : list (list N)) : bool :=
  let size f := match r with 2 => Nat.eqb (length f) 1 | 1 => Nat.eqb (length f) 2 | _ => 3 <=? length f end in
  (4 - r <=? length faces) &&
  forallb (fun f => size f && distinct f && forallb (fun i => N.ltb i (N.of_nat (length W))) f) faces &&
  no_two (fun f g => subset f g && subset g f) faces && subset (indices (length W)) (concat faces).
(** P1: zero at the vertices of the face, positive at all others, of which there is one. *)
Definition facet_of_hull (f : list N) : bool :=
  let H := half_space_over A aadd asub amul aofZ ale den r W f in
  forallb (fun i => let l := klev A aadd amul H (corner_at i) in if among i f then is_zero A aofZ ale l else alt zero l) (indices (length W)) &&
  negb (subset (indices (length W)) f).
(** P2: of consecutive corners and any other one the turn has one strict sign.  Three corners are a
    triangle by P1: otherwise H would be zero everywhere. *)
Definition convex_face (f : list N) : bool :=
  match r, f with
  | 0, [_; _; _] => true
  | 0, _ =>
    let n := hn A (half_space_over A aadd asub amul aofZ ale den r W f) in
    let turn p q t := kdet3 A aadd asub amul (vsub A asub (corner_at q) (corner_at p)) (vsub A asub (corner_at t) (corner_at p)) n in
    let all (ok : A -> bool) := forallb (fun e => forallb (fun t => if among t [fst e; snd e] then true else ok (turn (fst e) (snd e) t)) f)
      (match f with [] => [] | i :: g => combine f (g ++ [i]) end) in
    if all (fun x => alt zero x) then true else all (fun x => alt x zero)
  | _, _ => true
  end.
(** P3: every ridge is in two faces. *)
Definition closed_up (faces : list (list N)) : bool :=
  match r with
  | 0 => twice same_side (flat_map sides faces)
  | 1 => twice N.eqb (concat faces)
  | _ => Nat.eqb (length faces) 2
  end.
Definition as_the_format_says (faces : list (list N)) : bool :=
  shape faces && forallb facet_of_hull faces && forallb convex_face faces && closed_up faces.
End Ring.
