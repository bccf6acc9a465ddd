(** * The checks of a region: Boolean functions, no proof

    A region is a certificate of Checker.v without a domain.  A facet without a mate is a
    boundary facet.  [chk_separated] is condition X of docs/soundness.md and
    [chk_uncovered] condition W: here for every boundary facet, not for one of each class.
    A tile contains the middle of a boundary facet of a valid region only if it is its own.

    Only translates that are close need a look: those whose boxes of cells meet (Grid.v).
    Vertices and mates are looked up in binary tries, so the cost is about that of the pairs
    that are close.  The functionals of X are those of the kernel. *)
Require Import NArith ZArith List Bool FMapPositive.
From Acutile Require Import Statement Tetrahedra Degree Domain Bounds Checker Fast Grid.
Import ListNotations.
Local Open Scope nat_scope.

(** A boundary facet (k, i): its tetrahedron, its corners. *)
Definition facet_corners (t : ctet) (i : nat) : list corner := let '(a, b, c) := cfc t i in [a; b; c].
Definition tet_corners (t : ctet) : list corner := [q0 t; q1 t; q2 t; q3 t].
Definition unmated (t : ctet) (i : nat) : bool := match mt t i with None => true | Some _ => false end.
Definition among_corners (q : corner) (l : list corner) : bool := existsb (ceqb q) l.
Definition moved_tet (n : Z3) (t : ctet) : ctet :=
  CT (cshift n (q0 t)) (cshift n (q1 t)) (cshift n (q2 t)) (cshift n (q3 t)) None None None None.
(** [f] adds what it makes of the k-th member; by tail recursion. *)
Fixpoint collect {X Y} (f : N -> X -> list Y -> list Y) (k : N) (l : list X) (found : list Y) : list Y :=
  match l with [] => found | x :: l => collect f (N.succ k) l (f k x found) end.
Definition numbered_tets (ts : list ctet) : list (N * ctet) := collect (fun k t l => (k, t) :: l) 0%N ts [].
Definition open_facets (ts : list ctet) : list (N * ctet * nat) :=
  collect (fun k t l => fold_right (fun i l => if unmated t i then (k, t, i) :: l else l) l I4) 0%N ts [].

(** ** The mates, as in Checker.v; a facet may have none *)
Definition region_mate (r : nat) (tm : PositiveMap.t ctet) (k : N) (t : ctet) (i : nat) : bool :=
  match mt t i with
  | None => true
  | Some (k', i', d) =>
    N.ltb i' 4 && latb r d &&
    match entry tm k' with
    | None => false
    | Some t' => meqb (mt t' (N.to_nat i')) (k, N.of_nat i, zopp3 d) && codd d (cfc t i) (cfc t' (N.to_nat i'))
    end
  end.
Fixpoint region_mates (r : nat) (tm : PositiveMap.t ctet) (k : N) (ts : list ctet) : bool :=
  match ts with [] => true | t :: ts => if forallb (region_mate r tm k t) I4 then region_mates r tm (N.succ k) ts else false end.

Section Ring.
Variables (A : Type) (aadd asub amul : A -> A -> A) (aofZ : Z -> A) (alt ale : A -> A -> bool).
(** A hint: about the integral part of x / d. *)
Variable (part : Z -> A -> Z).
Notation v3 := (v3 A).
Notation cert := (cert A).
Notation zero := (zero A aofZ).
Notation vsub := (vsub A asub).
Notation vadd := (vadd A aadd).

(** ** Cells: [u_cells] for a lattice vector, of the width [u_width] on the other axes *)
Record units := Units { u_rank : nat; u_den : Z; u_cells : Z; u_width : Z }.
Definition width (u : units) (j : nat) : Z := if Nat.ltb j (u_rank u) then u_den u else u_width u.
Definition coordinate (j : nat) (v : v3) : A := match j with 0 => vX A v | 1 => vY A v | _ => vZ A v end.
Definition scaled_by (m : Z) (x : A) : A := if Z.eqb m 1 then x else amul (aofZ m) x.
Definition level_in (u : units) (j : nat) (v : v3) : A := scaled_by (step (u_rank u) (u_cells u) j) (coordinate j v).
Definition floor_of (d : Z) (x : A) : Z := let p := part d x in if alt x (aofZ (d * (p + 1))) then p else (p + 1)%Z.
Definition interval_of (u : units) (j : nat) (vs : list v3) : interval :=
  match map (fun v => floor_of (width u j) (level_in u j v)) vs with
  | [] => (0, 0)%Z
  | x :: l => (fold_left Z.min l x, fold_left Z.max l x)
  end.
Definition box_of (u : units) (vs : list v3) : box := (interval_of u 0 vs, interval_of u 1 vs, interval_of u 2 vs).
Definition chk_interval (u : units) (j : nat) (i : interval) (v : v3) : bool :=
  let x := level_in u j v in ale (aofZ (width u j * fst i)) x && alt x (aofZ (width u j * (snd i + 1))).
Definition chk_box (u : units) (b : box) (vs : list v3) : bool :=
  let '(b0, b1, b2) := b in
  proper b && forallb (fun v => chk_interval u 0 b0 v && chk_interval u 1 b1 v && chk_interval u 2 b2 v) vs.

(** A hint: cells about as wide as a simplex, or wider if some simplex has too many of them. *)
Definition extents (vs : list v3) : Z3 :=
  let extent j := match map (fun v => part 1 (coordinate j v)) vs with
    | [] => 1%Z | x :: l => (1 + fold_left Z.max l x - fold_left Z.min l x)%Z end in
  (extent 0, extent 1, extent 2).
Definition units_for (r : nat) (den w : Z) : units := Units r den (Z.max 1 (den / w)) w.
Definition cells_about (u : units) (e : Z3) : Z :=
  let n j x := (2 + x * step (u_rank u) (u_cells u) j / width u j)%Z in let '(x, y, z) := e in (n 0%nat x * n 1%nat y * n 2%nat z)%Z.
Definition all_cells (u : units) (es : list Z3) : Z := fold_left (fun n e => n + cells_about u e)%Z es 0%Z.
Fixpoint wide_enough (fuel : nat) (r : nat) (den w most : Z) (es : list Z3) : units :=
  let u := units_for r den w in
  match fuel with
  | O => u
  | S fuel => if Z.leb (all_cells u es) most then u else wide_enough fuel r den (2 * w) most es
  end.
Definition units_of (r : nat) (den : Z) (es : list Z3) : units :=
  let n := fold_left (fun n (_ : Z3) => Z.succ n) es 0%Z in
  let sum := fold_left (fun m e => let '(x, y, z) := e in m + x + y + z)%Z es 0%Z in
  wide_enough 64 r den (Z.max 1 (sum / (3 * n))) (64 * n + 4096) es.

Section Places.
(** Where the corners are. *)
Variable at_ : corner -> v3.
Definition kat (t : ctet) : ktet A := KT A (at_ (q0 t)) (at_ (q1 t)) (at_ (q2 t)) (at_ (q3 t)).

(** ** X: a functional that is less on f than on g, but for common corners *)
Definition kdot (d v : v3) : A := aadd (aadd (amul (vX A d) (vX A v)) (amul (vY A d) (vY A v))) (amul (vZ A d) (vZ A v)).
Definition kcross (u v : v3) : v3 :=
  let minor a b c d := asub (amul a b) (amul c d) in
  V3 A (minor (vY A u) (vZ A v) (vZ A u) (vY A v)) (minor (vZ A u) (vX A v) (vX A u) (vZ A v)) (minor (vX A u) (vY A v) (vY A u) (vX A v)).
Definition chk_direction (f g : list corner) (d : v3) : bool :=
  forallb (fun p => forallb (fun q =>
    (if among_corners p g && among_corners q f then ale else alt) (kdot d (at_ p)) (kdot d (at_ q))) g) f.
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
Definition chk_separated (f g : list corner) : bool :=
  let common := filter (fun q => among_corners q g) f in
  let own := filter (fun q => negb (among_corners q g)) f in let others := filter (fun q => negb (among_corners q f)) g in
  match own, others with
  | _ :: _, _ :: _ =>
    let points := map at_ in
    existsl (fun d => if chk_direction f g d then true else chk_direction f g (vsub (vzero A aofZ) d))
      (directions (length common) (points (common ++ own)) (points (common ++ others)))
  | _, _ => false
  end.

(** ** W: the middle of f is outside of the tetrahedron, strictly *)
Definition chk_uncovered (f : list corner) (t : ctet) : bool :=
  let kt := kat t in
  existsl (fun j => alt (fold_right (fun q s => aadd (kL A aadd asub amul kt j (at_ q)) s) zero f) zero) I4.

(** ** The boundary facets *)
Definition chk_facet (f : N * ctet * nat) (others : list ((N * ctet * nat) * Z3)) (tets : list ((N * ctet) * Z3)) : bool :=
  let '(k, t, i) := f in let corners := facet_corners t i in
  forallb (fun g => let '(k', t', i', n) := g in
    if N.eqb k k' && Nat.eqb i i' && z3eqb n z30 then true else chk_separated corners (map (cshift n) (facet_corners t' i'))) others &&
  forallb (fun g => let '(k', t', n) := g in
    if N.eqb k k' && z3eqb n z30 then true else chk_uncovered corners (moved_tet n t')) tets.
Definition boxed {X} (u : units) (corners : X -> list corner) (l : list X) : list (box * X) :=
  fast_map (fun x => (box_of u (map at_ (corners x)), x)) l.
Definition chk_boxed {X} (u : units) (corners : X -> list corner) (l : list (box * X)) : bool :=
  forallb (fun e => chk_box u (fst e) (map at_ (corners (snd e)))) l.
Definition facet_of (f : N * ctet * nat) := facet_corners (snd (fst f)) (snd f).
Definition tet_of (t : N * ctet) := tet_corners (snd t).
Definition chk_boundary (u : units) (ts : list ctet) (facets : list (N * ctet * nat)) : bool :=
  let r := u_rank u in let s := u_cells u in
  let tets := boxed u tet_of (numbered_tets ts) in let facets := boxed u facet_of facets in
  chk_boxed u tet_of tets && chk_boxed u facet_of facets &&
  (let tg := grid_of r s tets in let fg := grid_of r s facets in
   forallb (fun f => chk_facet (snd f) (candidates r s fg (fst f)) (candidates r s tg (fst f))) facets).
End Places.

(** ** The region *)
Definition listed_facets (c : cert) : list (nat * nat) := map (fun f => let '(k, _, i) := f in (N.to_nat k, i)) (open_facets (c_tets A c)).
Definition check_region (c : cert) : bool :=
  let den := c_den A c in let r := c_rank A c in let ts := c_tets A c in
  let vm := tabulate (c_verts A c) in let at_ := fast_pos A aadd aofZ den vm in
  Z.ltb 0 den && Nat.leb r 3 && forallb (fun t => chk_vol A aadd asub amul aofZ alt (kat at_ t)) ts &&
  chk_gram A aadd asub amul aofZ alt (c_gram A c) &&
  (let tm := tabulate ts in region_mates r tm 0%N ts) &&
  (let facets := open_facets ts in
   let u := units_of r den (fast_map (fun t => extents (map at_ (tet_corners t))) ts) in
   match facets with [] => false | _ => true end && Z.ltb 0 (u_cells u) && Z.ltb 0 (u_width u) && chk_boundary at_ u ts facets).

(** The statements: about single tetrahedra, and the local conditions; others are declined. *)
Inductive rstatement := Each (s : cstatement A) | CLocallyDelaunay | CLocallyWeaklyDelaunay.
Definition check_region_statement (c : cert) (kts : list (ktet A)) (km : PositiveMap.t (ktet A)) (s : rstatement) : bool :=
  match s with
  | Each (CDelaunay _) | Each (CWeaklyDelaunay _) | Each (CTCP _) => false
  | Each s => fast_statement A aadd asub amul aofZ alt ale c kts km s
  | CLocallyDelaunay => fast_delaunay A aadd asub amul aofZ alt c kts km
  | CLocallyWeaklyDelaunay => fast_delaunay A aadd asub amul aofZ ale c kts km
  end.
Definition check_region_with (c : cert) (ss : list rstatement) : bool :=
  if check_region c then
    let kts := fast_positions A aadd aofZ c in let km := tabulate kts in forallb (check_region_statement c kts km) ss
  else false.
End Ring.
