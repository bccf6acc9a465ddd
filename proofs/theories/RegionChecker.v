(** * The checks of a region: Boolean functions, no proof

    A region is a certificate of Checker.v without a domain.  A facet without a mate is a
    boundary facet.  [chk_separated] is condition X of docs/soundness.md and
    [chk_uncovered] condition W: here for every boundary facet, not for one of each class.
    A tile contains the middle of a boundary facet of a valid region only if it is its own.

    Only finitely many translates of a tile are close to another one: those for which the
    integral boxes around the two meet.  The functionals of X are those of the kernel. *)
Require Import NArith ZArith List Bool.
From Acutile Require Import Statement Tetrahedra Degree Domain Bounds Checker.
Import ListNotations.
Local Open Scope nat_scope.

(** ** Boxes with integral coordinates; the shifts that move one to another *)
Definition box := (Z3 * Z3)%type.
Definition zrange (a b : Z) : list Z := map (fun i => (a + Z.of_nat i)%Z) (seq 0 (Z.to_nat (b - a + 1))).
Definition range1 (moves : bool) (lo hi lo' hi' : Z) : list Z :=
  if moves then zrange (lo - hi') (hi - lo') else if (lo <=? hi')%Z && (lo' <=? hi)%Z then [0%Z] else [].
Definition shifts (r : nat) (b b' : box) : list Z3 :=
  let '((x, y, z), (u, v, w)) := b in let '((x', y', z'), (u', v', w')) := b' in
  list_prod (list_prod (range1 (1 <=? r) x u x' u') (range1 (2 <=? r) y v y' v')) (range1 (3 <=? r) z w z' w').

(** A boundary facet (k, i): its tetrahedron, its corners. *)
Definition facet_corners (t : ctet) (i : nat) : list corner := let '(a, b, c) := cfc t i in [a; b; c].
Definition unmated (t : ctet) (i : nat) : bool := match mt t i with None => true | Some _ => false end.
Fixpoint numbered {X} (k : nat) (l : list X) : list (nat * X) := match l with [] => [] | x :: l => (k, x) :: numbered (S k) l end.
Definition among_corners (q : corner) (l : list corner) : bool := existsb (ceqb q) l.
Definition moved_tet (n : Z3) (t : ctet) : ctet :=
  CT (cshift n (q0 t)) (cshift n (q1 t)) (cshift n (q2 t)) (cshift n (q3 t)) None None None None.

Section Ring.
Variables (A : Type) (aadd asub amul : A -> A -> A) (aofZ : Z -> A) (alt ale : A -> A -> bool).
(** A hint: about the integral part of x / den. *)
Variable (part : Z -> A -> Z).
Notation v3 := (v3 A).
Notation cert := (cert A).
Notation zero := (zero A aofZ).
Notation vsub := (vsub A asub).
Notation vadd := (vadd A aadd).
Notation pos := (pos A aadd aofZ).
Notation kpos := (kpos A aadd aofZ).

Definition box_of (den : Z) (t : ktet A) : box :=
  let bound f := let l := map (fun v => part den (f v)) (kverts A t) in
    (fold_right Z.min (part den (f (ka A t))) l, (1 + fold_right Z.max (part den (f (ka A t))) l)%Z) in
  let '(x, u) := bound (vX A) in let '(y, v) := bound (vY A) in let '(z, w) := bound (vZ A) in ((x, y, z), (u, v, w)).
Definition chk_box (den : Z) (t : ktet A) (b : box) : bool :=
  let '((x, y, z), (u, v, w)) := b in
  let within lo hi a := ale (aofZ (den * lo)) a && ale a (aofZ (den * hi)) in
  forallb (fun p => within x u (vX A p) && within y v (vY A p) && within z w (vZ A p)) (kverts A t).

(** ** X: a functional that is less on f than on g, but for common corners *)
Definition kdot (d v : v3) : A := aadd (aadd (amul (vX A d) (vX A v)) (amul (vY A d) (vY A v))) (amul (vZ A d) (vZ A v)).
Definition kcross (u v : v3) : v3 :=
  let minor a b c d := asub (amul a b) (amul c d) in
  V3 A (minor (vY A u) (vZ A v) (vZ A u) (vY A v)) (minor (vZ A u) (vX A v) (vX A u) (vZ A v)) (minor (vX A u) (vY A v) (vY A u) (vX A v)).
Definition chk_direction (den : Z) (vs : list v3) (f g : list corner) (d : v3) : bool :=
  forallb (fun p => forallb (fun q =>
    (if among_corners p g && among_corners q f then ale else alt) (kdot d (pos den vs p)) (kdot d (pos den vs q))) g) f.
Definition axes : list v3 := let o := aofZ 1 in [V3 A o zero zero; V3 A zero o zero; V3 A zero zero o].
Fixpoint products (others edges : list v3) : list v3 :=
  match edges with [] => [] | e :: edges => map (kcross e) (edges ++ others) ++ products others edges end.
(** Candidates; the common corners come first in f and in g. *)
Definition directions (common : nat) (f g : list v3) : list v3 :=
  match f, g with
  | [f0; f1; f2], [g0; g1; g2] =>
    match common with
    | 0 => products axes [vsub f1 f0; vsub f2 f0; vsub g1 g0; vsub g2 g0; vsub f2 f1; vsub g2 g1]
    | 1 => let a := vsub f1 f0 in let b := vsub f2 f0 in let c := vsub g0 g1 in let d := vsub g0 g2 in
      products axes [vsub b a; vsub d c; vsub c a; vsub d a; vsub c b; vsub d b]
    | _ => let e := vsub f1 f0 in map (kcross e) (vadd (vsub f2 f0) (vsub g2 g0) :: axes)
    end
  | _, _ => []
  end.
Definition chk_separated (den : Z) (vs : list v3) (f g : list corner) : bool :=
  let common := filter (fun q => among_corners q g) f in
  let own := filter (fun q => negb (among_corners q g)) f in let others := filter (fun q => negb (among_corners q f)) g in
  match own, others with
  | _ :: _, _ :: _ =>
    let points := map (pos den vs) in
    existsl (fun d => if chk_direction den vs f g d then true else chk_direction den vs f g (vsub (vzero A aofZ) d))
      (directions (length common) (points (common ++ own)) (points (common ++ others)))
  | _, _ => false
  end.

(** ** W: the middle of f is outside of the tetrahedron, strictly *)
Definition chk_uncovered (den : Z) (vs : list v3) (f : list corner) (t : ctet) : bool :=
  let kt := kpos den vs t in
  existsb (fun j => alt (fold_right (fun q s => aadd (kL A aadd asub amul kt j (pos den vs q)) s) zero f) zero) I4.

(** ** The mates, as Checker.v has them; a facet may have none *)
Fixpoint chk_region_mates (r : nat) (all : list ctet) (pos : ctet -> ktet A) (k : nat) (ts : list ctet) : bool :=
  match ts with
  | [] => true
  | t :: ts => forallb (fun i => if unmated t i then true else chk_mate A aadd amul aofZ ale r [] all k t (pos t) i) I4 &&
      chk_region_mates r all pos (S k) ts
  end.

(** ** The region *)
Definition region_facets_of (c : cert) : list (nat * (ctet * nat)) :=
  flat_map (fun kt => map (fun i => (fst kt, (snd kt, i))) (filter (unmated (snd kt)) I4)) (numbered 0 (c_tets A c)).
Definition listed_facets (c : cert) : list (nat * nat) := map (fun f => (fst f, snd (snd f))) (region_facets_of c).
Definition check_region (c : cert) : bool :=
  let den := c_den A c in let r := c_rank A c in let vs := c_verts A c in let ts := c_tets A c in
  let tets := numbered 0 ts in let facets := region_facets_of c in
  let box t := box_of den (kpos den vs t) in
  Z.ltb 0 den && Nat.leb r 3 && forallb (chk_vol A aadd asub amul aofZ alt) (positions A aadd aofZ c) &&
  chk_gram A aadd asub amul aofZ alt (c_gram A c) &&
  chk_region_mates r ts (kpos den vs) 0 ts &&
  forallb (fun t => let kt := kpos den vs t in chk_box den kt (box_of den kt)) ts &&
  match facets with [] => false | _ => true end &&
  forallb (fun f => let '(k, (t, i)) := f in let b := box t in
    forallb (fun g => let '(k', (t', i')) := g in
      forallb (fun n => if Nat.eqb k k' && Nat.eqb i i' && z3eqb n z30 then true else
        chk_separated den vs (facet_corners t i) (map (cshift n) (facet_corners t' i'))) (shifts r b (box t'))) facets &&
    forallb (fun g => let '(k', t') := g in
      forallb (fun n => if Nat.eqb k k' && z3eqb n z30 then true else
        chk_uncovered den vs (facet_corners t i) (moved_tet n t')) (shifts r b (box t'))) tets) facets.
(** The statements about single tetrahedra; others are declined. *)
Definition check_region_statement (c : cert) (s : cstatement A) : bool :=
  match s with CDelaunay _ | CWeaklyDelaunay _ | CTCP _ => false | _ => check_statement A aadd asub amul aofZ alt ale c s end.
End Ring.
