(** * The checker

    A boolean function of a certificate over any ring A of exact numbers, given by
    its operations and two one-sided comparisons.  Numbers.v supplies the integers
    and Z[alpha].  No proof is in this file; Soundness.v proves that "true" implies
    the theorem, and extraction/ turns it into a program.

    Indices are binary ([N]): unary ones make large certificates slow to read. *)
Require Import Reals NArith ZArith List Bool.
From Acutile Require Import Statement Tetrahedra Degree Domain Cosine.
Import ListNotations.
Local Open Scope nat_scope.

(** A corner [(v, n)] is vertex v moved by the lattice vector n.  A mate
    [Some (t, j, d)] is the facet opposite to corner j of simplex t, moved by d;
    [None] says that the facet lies on the boundary of the domain. *)
Definition corner := (N * Z3)%type.
Definition mref := option (N * N * Z3).
Record ctet := CT { q0 : corner; q1 : corner; q2 : corner; q3 : corner;
                    m0 : mref; m1 : mref; m2 : mref; m3 : mref }.
Definition mt (t : ctet) (i : nat) : mref := match i with 0 => m0 t | 1 => m1 t | 2 => m2 t | _ => m3 t end.
(** The facet opposite to corner i, oriented towards it. *)
Definition cfc (t : ctet) (i : nat) : corner * corner * corner :=
  match i with
  | 0 => (q1 t, q3 t, q2 t)
  | 1 => (q0 t, q2 t, q3 t)
  | 2 => (q0 t, q3 t, q1 t)
  | _ => (q0 t, q1 t, q2 t)
  end.
Definition z3eqb (a b : Z3) := let '(x,y,z) := a in let '(x',y',z') := b in Z.eqb x x' && Z.eqb y y' && Z.eqb z z'.
Definition ceqb (a b : corner) := N.eqb (fst a) (fst b) && z3eqb (snd a) (snd b).
Definition meqb (a : mref) (b : N * N * Z3) :=
  match a with None => false | Some a => N.eqb (fst (fst a)) (fst (fst b)) && N.eqb (snd (fst a)) (snd (fst b)) && z3eqb (snd a) (snd b) end.
Definition cshift (d : Z3) (a : corner) : corner := (fst a, zadd3 (snd a) d).
(** The facets f, and g moved by d, have the same corners and opposite orientations. *)
Definition codd (d : Z3) (f g : corner * corner * corner) :=
  let '(a,b,c) := f in let '(a',b',c') := g in
  let a' := cshift d a' in let b' := cshift d b' in let c' := cshift d c' in
  (ceqb a b' && ceqb b a' && ceqb c c') || (ceqb a a' && ceqb b c' && ceqb c b') || (ceqb a c' && ceqb b b' && ceqb c a').

Section Ring.
Variables (A : Type) (aadd asub amul : A -> A -> A) (aofZ : Z -> A).
(** [alt x y] proves x < y, [ale x y] proves x <= y; "false" proves nothing. *)
Variables (alt ale : A -> A -> bool).

(** ** Vectors, determinants *)
Record v3 := V3 { vX : A; vY : A; vZ : A }.
Definition vadd a b := V3 (aadd (vX a) (vX b)) (aadd (vY a) (vY b)) (aadd (vZ a) (vZ b)).
Definition vsub a b := V3 (asub (vX a) (vX b)) (asub (vY a) (vY b)) (asub (vZ a) (vZ b)).
Definition kdet3 u v w :=
  aadd (asub (amul (vX u) (asub (amul (vY v) (vZ w)) (amul (vZ v) (vY w))))
             (amul (vY u) (asub (amul (vX v) (vZ w)) (amul (vZ v) (vX w)))))
       (amul (vZ u) (asub (amul (vX v) (vY w)) (amul (vY v) (vX w)))).
Definition kD a b c d := kdet3 (vsub b a) (vsub c a) (vsub d a).
Definition zero := aofZ 0.
Definition vzero := V3 zero zero zero.
Definition vofZ den (n : Z3) := let '(x,y,z) := n in V3 (aofZ (den * x)) (aofZ (den * y)) (aofZ (den * z)).

(** ** The certificate: integral data, denominators cleared

    Vertices and half-spaces are [c_den] times the real ones, the Gram matrix is
    [c_gden] times the real one. *)
Record kgram := KG { k11 : A; k22 : A; k33 : A; k12 : A; k13 : A; k23 : A }.
Record khalf := KH { hn : v3; hd : A }.
(** Why generic points are covered once: the volume sum, or a point of the open
    simplex wk in no other closed translate, with a box of translates for each simplex. *)
Inductive covering := ByVolume | ByWitness (wk : N) (wp : v3) (boxes : list (Z3 * Z3)).
Record cert := Cert {
  c_den : Z; c_verts : list v3; c_tets : list ctet;
  c_gden : Z; c_gram : kgram;
  c_rank : nat; c_domain : list khalf;
  c_cover : covering }.

Definition pos (den : Z) (vs : list v3) (c : corner) : v3 := vadd (nth (N.to_nat (fst c)) vs vzero) (vofZ den (snd c)).
Record ktet := KT { ka : v3; kb : v3; kc : v3; kd : v3 }.
Definition kpos den vs t := KT (pos den vs (q0 t)) (pos den vs (q1 t)) (pos den vs (q2 t)) (pos den vs (q3 t)).
Definition kverts t := [ka t; kb t; kc t; kd t].
Definition kvx (t : ktet) (i : nat) := match i with 0 => ka t | 1 => kb t | 2 => kc t | _ => kd t end.
Definition kfc (t : ktet) (i : nat) : v3 * v3 * v3 :=
  match i with
  | 0 => (kb t, kd t, kc t)
  | 1 => (ka t, kc t, kd t)
  | 2 => (ka t, kd t, kb t)
  | _ => (ka t, kb t, kc t)
  end.
(** vol times the i-th barycentric coordinate of x. *)
Definition kL t i x := let '(a,b,c) := kfc t i in kD a b c x.

(** ** 1. Positive orientation *)
Definition chk_vol (t : ktet) := alt zero (kD (ka t) (kb t) (kc t) (kd t)).

(** ** 2. The domain: invariant, with all vertices inside; boundary facets on its planes *)
Definition klev (H : khalf) (x : v3) :=
  aadd (aadd (amul (vX (hn H)) (vX x)) (aadd (amul (vY (hn H)) (vY x)) (amul (vZ (hn H)) (vZ x)))) (hd H).
Definition is_zero x := ale x zero && ale zero x.
Definition chk_invariant (r : nat) (H : khalf) :=
  (if 1 <=? r then is_zero (vX (hn H)) else true) && (if 2 <=? r then is_zero (vY (hn H)) else true) &&
  (if 3 <=? r then is_zero (vZ (hn H)) else true).
Definition chk_inside (kts : list ktet) (H : khalf) :=
  forallb (fun t => forallb (fun v => ale zero (klev H v)) (kverts t) && existsb (fun v => alt zero (klev H v)) (kverts t)) kts.
Definition on_boundary (Hs : list khalf) (t : ktet) (i : nat) :=
  existsb (fun H => forallb (fun j => if Nat.eqb j i then true else ale (klev H (kvx t j)) zero) I4) Hs.

(** ** 3. The pairing of facets, purely combinatorial *)
Definition chk_mate (r : nat) (Hs : list khalf) (ts : list ctet) (k : nat) (t : ctet) (kt : ktet) (i : nat) : bool :=
  match mt t i with
  | None => on_boundary Hs kt i
  | Some (k', i', d) =>
    N.ltb i' 4 && latb r d &&
    match nth_error ts (N.to_nat k') with
    | None => false
    | Some t' => meqb (mt t' (N.to_nat i')) (N.of_nat k, N.of_nat i, zopp3 d) && codd d (cfc t i) (cfc t' (N.to_nat i'))
    end
  end.
Fixpoint chk_mates (r : nat) (Hs : list khalf) (all : list ctet) (pos : ctet -> ktet) (k : nat) (ts : list ctet) : bool :=
  match ts with
  | [] => true
  | t :: ts => forallb (chk_mate r Hs all k t (pos t)) I4 && chk_mates r Hs all pos (S k) ts
  end.

(** ** 4. The covering condition

    By volume, for space only: all facets are paired and the volumes of the tetrahedra
    sum to that of the cell, det sums to 6 den^3. *)
Definition is_paired (t : ctet) := forallb (fun i => match mt t i with Some _ => true | None => false end) I4.
Definition kvolume (kts : list ktet) : A := fold_right (fun t s => aadd (kD (ka t) (kb t) (kc t) (kd t)) s) zero kts.
Definition chk_volume (den : Z) (r : nat) (ts : list ctet) (kts : list ktet) : bool :=
  Nat.eqb r 3 && forallb is_paired ts && is_zero (asub (kvolume kts) (aofZ (6 * (den * den * den)))).
(** By a witness: a point of the open tetrahedron wk in no other closed translate.
    The certificate gives for each tetrahedron a box lo..hi of lattice vectors; outside
    of it a coordinate plane separates the point from the translate, inside a facet plane. *)
Fixpoint existsl {X} (f : X -> bool) (l : list X) : bool :=   (* lazy under call by value *)
  match l with [] => false | x :: l => if f x then true else existsl f l end.
Definition zint (lo hi : Z) : list Z := map (fun j => (lo + Z.of_nat j)%Z) (seq 0 (Z.to_nat (hi - lo + 1))).
Definition chk_box1 (den : Z) (pr : v3 -> A) (t : ktet) (w : v3) (lo hi : Z) : bool :=
  let u := asub (pr w) (aofZ (den * (lo - 1))) in let v := asub (pr w) (aofZ (den * (hi + 1))) in
  (alt (pr (ka t)) u && alt (pr (kb t)) u && alt (pr (kc t)) u && alt (pr (kd t)) u) &&
  (alt v (pr (ka t)) && alt v (pr (kb t)) && alt v (pr (kc t)) && alt v (pr (kd t))).
Definition outb (den : Z) (t : ktet) (w : v3) (n : Z3) :=
  let y := vsub w (vofZ den n) in existsl (fun i => alt (kL t i y) zero) I4.
(** Only the first r coordinates move: the box is cut to the lattice. *)
Definition chk_wit1 (den : Z) (r : nat) (wk : nat) (w : v3) (k : nat) (t : ktet) (bx : Z3 * Z3) : bool :=
  let '((lx,ly,lz),(hx,hy,hz)) := bx in
  (if 1 <=? r then chk_box1 den vX t w lx hx else true) && (if 2 <=? r then chk_box1 den vY t w ly hy else true) &&
  (if 3 <=? r then chk_box1 den vZ t w lz hz else true) &&
  forallb (fun n => if Nat.eqb k wk && z3eqb n z30 then true else outb den t w n)
    (list_prod (list_prod (if 1 <=? r then zint lx hx else [0%Z]) (if 2 <=? r then zint ly hy else [0%Z])) (if 3 <=? r then zint lz hz else [0%Z])).
Fixpoint chk_wits (den : Z) (r : nat) (wk : nat) (w : v3) (k : nat) (ts : list ktet) (bs : list (Z3 * Z3)) : bool :=
  match ts, bs with
  | [], _ => true
  | t :: ts, b :: bs => chk_wit1 den r wk w k t b && chk_wits den r wk w (S k) ts bs
  | _, _ => false
  end.
Definition chk_in (t : ktet) (w : v3) := forallb (fun i => alt zero (kL t i w)) I4.

(** ** 5. The Gram matrix is positive definite *)
Definition kgdet g :=
  aadd (asub (amul (k11 g) (asub (amul (k22 g) (k33 g)) (amul (k23 g) (k23 g))))
             (amul (k12 g) (asub (amul (k12 g) (k33 g)) (amul (k23 g) (k13 g)))))
       (amul (k13 g) (asub (amul (k12 g) (k23 g)) (amul (k22 g) (k13 g)))).
Definition chk_gram g := alt zero (k11 g) && alt zero (asub (amul (k11 g) (k22 g)) (amul (k12 g) (k12 g))) && alt zero (kgdet g).

Definition positions (c : cert) := map (kpos (c_den c) (c_verts c)) (c_tets c).
Definition chk_cover (c : cert) : bool :=
  let den := c_den c in let r := c_rank c in let kts := positions c in
  match c_cover c with
  | ByVolume => chk_volume den r (c_tets c) kts
  | ByWitness wk wp boxes =>
    match nth_error kts (N.to_nat wk) with None => false | Some t => chk_in t wp end &&
    chk_wits den r (N.to_nat wk) wp 0 kts boxes
  end.
Definition check_tiling (c : cert) : bool :=
  let den := c_den c in let r := c_rank c in let kts := positions c in
  Z.ltb 0 den && Z.ltb 0 (c_gden c) && Nat.leb r 3 &&
  forallb chk_vol kts &&
  forallb (fun H => chk_invariant r H && chk_inside kts H) (c_domain c) &&
  chk_mates r (c_domain c) (c_tets c) (kpos den (c_verts c)) 0 (c_tets c) &&
  chk_cover c &&
  chk_gram (c_gram c).

(** ** 6. Statements: dihedral angles *)
Definition kgdot g u v :=
  aadd (aadd (aadd (amul (k11 g) (amul (vX u) (vX v))) (amul (k22 g) (amul (vY u) (vY v)))) (amul (k33 g) (amul (vZ u) (vZ v))))
  (aadd (aadd (amul (k12 g) (aadd (amul (vX u) (vY v)) (amul (vY u) (vX v)))) (amul (k13 g) (aadd (amul (vX u) (vZ v)) (amul (vZ u) (vX v)))))
   (amul (k23 g) (aadd (amul (vY u) (vZ v)) (amul (vZ u) (vY v))))).
(** [kac g a b c d] = |e|^2 (u.w) - (e.u)(e.w) for the edges e = ab, u = ac, w = ad: C of Angles.v. *)
Definition kac g a b c d :=
  let e := vsub b a in let u := vsub c a in let w := vsub d a in
  asub (amul (kgdot g u w) (kgdot g e e)) (amul (kgdot g u e) (kgdot g w e)).
Definition all_six (f : v3 -> v3 -> v3 -> v3 -> bool) (t : ktet) :=
  f (ka t) (kb t) (kc t) (kd t) && f (ka t) (kc t) (kb t) (kd t) &&
  f (ka t) (kd t) (kb t) (kc t) && f (kb t) (kc t) (ka t) (kd t) &&
  f (kb t) (kd t) (ka t) (kc t) && f (kc t) (kd t) (ka t) (kb t).
Definition chk_acute g a b c d := alt zero (kac g a b c d).
Definition chk_nonobtuse g a b c d := ale zero (kac g a b c d).
(** cos (angle) > p/q, with q > 0: rule [below_rule] of Angles.v. *)
Definition chk_cosine g (p q : Z) a b c d :=
  let x := kac g a b c d in
  let left := amul (aofZ (p * p)) (amul (kac g a b c c) (kac g a b d d)) in
  let right := amul (aofZ (q * q)) (amul x x) in
  if Z.leb 0 p then alt zero x && alt left right else if ale zero x then true else alt right left.
(** ** 7. Statements: Delaunay, by the power of the vertex behind each facet *)
Definition ksq g u := kgdot g u u.
(** - vol times the power of x: power_sum of Delaunay.v. *)
Definition kpower g t x :=
  aadd (aadd (aadd (amul (kL t 0 x) (ksq g (vsub (ka t) x))) (amul (kL t 1 x) (ksq g (vsub (kb t) x))))
    (amul (kL t 2 x) (ksq g (vsub (kc t) x)))) (amul (kL t 3 x) (ksq g (vsub (kd t) x))).
Definition chk_power (less : A -> A -> bool) g den (kts : list ktet) (t : ctet) (kt : ktet) (i : nat) : bool :=
  match mt t i with
  | None => true
  | Some (k', i', d) =>
    match nth_error kts (N.to_nat k') with
    | None => false
    | Some kt' => less (kpower g kt (vadd (kvx kt' (N.to_nat i')) (vofZ den d))) zero
    end
  end.
Definition chk_delaunay (less : A -> A -> bool) (c : cert) :=
  let kts := positions c in
  forallb (fun t => forallb (chk_power less (c_gram c) (c_den c) kts t (kpos (c_den c) (c_verts c) t)) I4) (c_tets c).

Definition check_statement (c : cert) (s : statement) : bool :=
  match s with
  | Acute => forallb (all_six (chk_acute (c_gram c))) (positions c)
  | Nonobtuse => forallb (all_six (chk_nonobtuse (c_gram c))) (positions c)
  | DihedralBelow p q =>
    degrees_ok p q && let bound := cos_upper p q in forallb (all_six (chk_cosine (c_gram c) (fst bound) (snd bound))) (positions c)
  | Delaunay => chk_delaunay alt c
  | WeaklyDelaunay => chk_delaunay ale c
  end.
Definition check (c : cert) (ss : list statement) : bool := check_tiling c && forallb (check_statement c) ss.

(** Which part fails, for people; no theorem speaks of it. *)
Definition parts (c : cert) (ss : list statement) : list bool :=
  let den := c_den c in let r := c_rank c in let kts := positions c in
  [ Z.ltb 0 den && Z.ltb 0 (c_gden c) && Nat.leb r 3; forallb chk_vol kts;
    forallb (fun H => chk_invariant r H && chk_inside kts H) (c_domain c);
    chk_mates r (c_domain c) (c_tets c) (kpos den (c_verts c)) 0 (c_tets c);
    chk_cover c; chk_gram (c_gram c) ] ++ map (check_statement c) ss.
End Ring.
