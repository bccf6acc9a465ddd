(** * The checker

    A boolean function of a certificate over any ring A of exact numbers, given by
    its operations and two one-sided comparisons.  Numbers.v supplies the integers
    and Z[alpha].  No proof is in this file; Soundness.v proves that "true" implies
    the theorem, and extraction/ turns it into a program.

    Indices are binary ([N]): unary ones make large certificates slow to read. *)
Require Import Reals NArith ZArith List Bool FMapPositive.
From Acutile Require Import Statement Tetrahedra Degree Domain Bounds.
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

(** ** Valences, purely combinatorial

    The key of an ordered pair of corners is the same for all lattice translates of it. The
    valence of an edge is the number of ordered pairs of corners of all tetrahedra with
    its key. *)
Definition key := (N * (N * Z3))%type.
Definition qx (t : ctet) (i : nat) : corner := match i with 0 => q0 t | 1 => q1 t | 2 => q2 t | _ => q3 t end.
Definition edge_key (a b : corner) : key := (fst a, (fst b, zadd3 (snd b) (zopp3 (snd a)))).
Definition pairs4 : list (nat * nat) := [(0,1);(0,2);(0,3);(1,0);(1,2);(1,3);(2,0);(2,1);(2,3);(3,0);(3,1);(3,2)].
Definition triples4 : list (nat * nat * nat) := [(0,1,2);(0,1,3);(0,2,3);(1,0,2);(1,0,3);(1,2,3);(2,0,1);(2,0,3);(2,1,3);(3,0,1);(3,0,2);(3,1,2)].
Definition keys (t : ctet) : list key := map (fun p => edge_key (qx t (fst p)) (qx t (snd p))) pairs4.
(** The keys by their first vertex. *)
Definition index := PositiveMap.t (list (N * Z3)).
Definition lookup (v : N) (m : index) : list (N * Z3) := match PositiveMap.find (N.succ_pos v) m with Some l => l | None => [] end.
Definition indexed (ks : list key) : index :=
  fold_right (fun k m => PositiveMap.add (N.succ_pos (fst k)) (snd k :: lookup (fst k) m) m) (PositiveMap.empty _) ks.
Definition end_eqb (a b : N * Z3) := N.eqb (fst a) (fst b) && z3eqb (snd a) (snd b).
Definition count_key (m : index) (k : key) : nat := length (filter (end_eqb (snd k)) (lookup (fst k) m)).
Definition chk_tcp (ts : list ctet) : bool :=
  let m := indexed (flat_map keys ts) in
  forallb (fun t =>
    let val i j := count_key m (edge_key (qx t i) (qx t j)) in
    forallb (fun p => let n := val (fst p) (snd p) in Nat.eqb n 5 || Nat.eqb n 6) pairs4 &&
    forallb (fun p => let '(i, j, k) := p in negb (Nat.eqb (val i j) 6 && Nat.eqb (val i k) 6)) triples4) ts.

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

(** ** The certificate: integral data

    Vertices, of the tiling and of the polytope, and half-spaces are [c_den] times the
    real ones. *)
Record kgram := KG { k11 : A; k22 : A; k33 : A; k12 : A; k13 : A; k23 : A }.
Record khalf := KH { hn : v3; hd : A }.
(** The claim's domain is spanned by the lattice and [c_polytope], whose points have
    zeros in the first r coordinates. [c_domain] are half-spaces that have it as their
    intersection; [c_pieces] cut a cell of it, the part with the first r coordinates
    between 0 and 1, into tetrahedra, by points of [c_polytope] moved by lattice vectors:
    hints, computed by [faces_cert] below, and checked. *)
Record cert := Cert {
  c_den : Z; c_verts : list v3; c_tets : list ctet; c_gram : kgram;
  c_rank : nat; c_polytope : list v3; c_domain : list khalf; c_pieces : list (corner * corner * corner * corner) }.

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

(** The half-spaces contain the polytope, and each vertex lies over it: in one of the pieces,
    once its first r coordinates are set to zero. *)
Definition zeroed (r : nat) (v : v3) :=
  V3 (if 1 <=? r then zero else vX v) (if 2 <=? r then zero else vY v) (if 3 <=? r then zero else vZ v).
Definition piece_corners (q : corner * corner * corner * corner) := let '(a, b, c, d) := q in [a; b; c; d].
Definition piece_pos (den : Z) (W : list v3) (q : corner * corner * corner * corner) :=
  let '(a, b, c, d) := q in KT (pos den W a) (pos den W b) (pos den W c) (pos den W d).
Definition in_piece (den : Z) (r : nat) (W : list v3) (v : v3) (q : corner * corner * corner * corner) : bool :=
  forallb (fun a => N.ltb (fst a) (N.of_nat (length W)) && latb r (snd a)) (piece_corners q) &&
  let t := piece_pos den W q in let z := zeroed r v in chk_vol t && forallb (fun i => ale zero (kL t i z)) I4.
Definition chk_polytope (c : cert) (kts : list ktet) : bool :=
  let r := c_rank c in let W := c_polytope c in
  if 3 <=? r then match c_domain c with [] => true | _ => false end else
  forallb (fun H => forallb (fun w => ale zero (klev H w)) W) (c_domain c) &&
  forallb (fun t => forallb (fun v => existsl (in_piece (c_den c) r W v) (c_pieces c)) (kverts t)) kts.

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

(** ** 4. The covering condition: volumes

    The cell of the domain, cut into pieces: those of [c_pieces] with positive volume. They lie in
    the domain and in the cell; no two have common inner points; and the volumes of the
    tetrahedra of the tiling sum to theirs. *)
Definition unit_cell (c : cert) : list ktet := filter chk_vol (map (piece_pos (c_den c) (c_polytope c)) (c_pieces c)).
Definition chk_unit (den : Z) (r : nat) (t : ktet) : bool :=
  let unit x := ale zero x && ale x (aofZ den) in
  forallb (fun v => (if 1 <=? r then unit (vX v) else true) && (if 2 <=? r then unit (vY v) else true) &&
    (if 3 <=? r then unit (vZ v) else true)) (kverts t).
(** The plane of facet i of t is between p and q; some plane of a facet, their own are tried first. *)
Definition between (t : ktet) (i : nat) (p q : ktet) : bool :=
  if forallb (fun v => ale zero (kL t i v)) (kverts p) then forallb (fun v => ale (kL t i v) zero) (kverts q) else false.
Definition separated (all : list ktet) (p q : ktet) : bool :=
  existsl (fun t => existsl (fun i => if between t i p q then true else between t i q p) I4) (p :: q :: all).
Fixpoint chk_apart (all l : list ktet) : bool :=
  match l with [] => true | p :: l => forallb (separated all p) l && chk_apart all l end.
Definition kvolume (kts : list ktet) : A := fold_right (fun t s => aadd (kD (ka t) (kb t) (kc t) (kd t)) s) zero kts.

(** ** 5. The Gram matrix is positive definite *)
Definition kgdet g :=
  aadd (asub (amul (k11 g) (asub (amul (k22 g) (k33 g)) (amul (k23 g) (k23 g))))
             (amul (k12 g) (asub (amul (k12 g) (k33 g)) (amul (k23 g) (k13 g)))))
       (amul (k13 g) (asub (amul (k12 g) (k23 g)) (amul (k22 g) (k13 g)))).
Definition chk_gram g := alt zero (k11 g) && alt zero (asub (amul (k11 g) (k22 g)) (amul (k12 g) (k12 g))) && alt zero (kgdet g).

Definition positions (c : cert) := map (kpos (c_den c) (c_verts c)) (c_tets c).
Definition chk_cover (c : cert) : bool :=
  let l := unit_cell c in
  match c_tets c with [] => false | _ => true end &&
  forallb (chk_inside l) (c_domain c) && forallb (chk_unit (c_den c) (c_rank c)) l && chk_apart l l &&
  is_zero (asub (kvolume (positions c)) (kvolume l)).
Definition check_tiling (c : cert) : bool :=
  let den := c_den c in let r := c_rank c in let kts := positions c in
  Z.ltb 0 den && Nat.leb r 3 &&
  forallb chk_vol kts &&
  forallb (fun H => chk_invariant r H && chk_inside kts H) (c_domain c) &&
  chk_polytope c kts &&
  chk_mates r (c_domain c) (c_tets c) (kpos den (c_verts c)) 0 (c_tets c) &&
  chk_cover c &&
  chk_gram (c_gram c).

(** ** 6. Statements: dihedral angles *)
(** Three products of long factors, because the entries of the Gram matrix are short and many are zero. *)
Definition kgdot g u v :=
  let row x y z := aadd (aadd (amul x (vX u)) (amul y (vY u))) (amul z (vZ u)) in
  aadd (aadd (amul (row (k11 g) (k12 g) (k13 g)) (vX v)) (amul (row (k12 g) (k22 g) (k23 g)) (vY v)))
       (amul (row (k13 g) (k23 g) (k33 g)) (vZ v)).
(** [kac g a b c d] = |e|^2 (u.w) - (e.u)(e.w) for the edges e = ab, u = ac, w = ad: C of Angles.v. *)
Definition kac g a b c d :=
  let e := vsub b a in let u := vsub c a in let w := vsub d a in
  asub (amul (kgdot g u w) (kgdot g e e)) (amul (kgdot g u e) (kgdot g w e)).
(** The six edges, each with the other two corners after it. *)
Definition six (t : ktet) : list (v3 * v3 * v3 * v3) :=
  [(ka t, kb t, kc t, kd t); (ka t, kc t, kb t, kd t); (ka t, kd t, kb t, kc t);
   (kb t, kc t, ka t, kd t); (kb t, kd t, ka t, kc t); (kc t, kd t, ka t, kb t)].
Definition on_edge {X} (f : v3 -> v3 -> v3 -> v3 -> X) (i : v3 * v3 * v3 * v3) : X := let '(a, b, c, d) := i in f a b c d.
Definition chk_acute g a b c d := alt zero (kac g a b c d).
Definition chk_nonobtuse g a b c d := ale zero (kac g a b c d).
(** The bound of an angle is arccos (sg sqrt (p/q)), where sg is the sign -1, 0 or 1. *)
Definition chk_bound (sg : Z) (p : A) (q : Z) : bool :=
  Z.ltb 0 q && match sg with Z0 => is_zero p | Zpos xH | Zneg xH => alt zero p && ale p (aofZ q) | _ => false end.
(** sg sqrt (p/q) < x / sqrt m for "less than": [below_root] of Angles.v. *)
Definition chk_root (less : A -> A -> bool) (sg : Z) (p : A) (q : Z) (x m : A) : bool :=
  match sg with
  | Z0 => less zero x
  | Zpos _ => if ale zero x then less (amul p m) (amul (aofZ q) (amul x x)) else false
  | Zneg _ => if ale zero x then true else less (amul (aofZ q) (amul x x)) (amul p m)
  end.
(** The dihedral angle along ab passes the test: rule [bound_rule] of Angles.v.  With x and m from [kac], as
    [angle_sound] of Soundness.v says; here six inner products stand for its twelve. *)
Definition chk_rule (sg : Z) (p : A) (q : Z) (o : test) (x m : A) : bool :=
  match o with
  | TLt => chk_root alt sg p q x m
  | TLe => chk_root ale sg p q x m
  | TGe => chk_root ale (- sg) p q (asub zero x) m
  | TGt => chk_root alt (- sg) p q (asub zero x) m
  end.
Definition chk_angle g (sg : Z) (p : A) (q : Z) (o : test) a b c d : bool :=
  let e := vsub b a in let u := vsub c a in let w := vsub d a in
  let ee := kgdot g e e in let ue := kgdot g u e in let we := kgdot g w e in
  chk_rule sg p q o (asub (amul (kgdot g u w) ee) (amul ue we))
    (amul (asub (amul (kgdot g u u) ee) (amul ue ue)) (asub (amul (kgdot g w w) ee) (amul we we))).
(** The circumradius: R^2 = X / (4 det M) for the Gram matrix M of the edges from the first
    vertex, its cofactors C, its diagonal m and X = m^T C m. *)
Definition kradius g (t : ktet) : A * A :=
  let e1 := vsub (kb t) (ka t) in let e2 := vsub (kc t) (ka t) in let e3 := vsub (kd t) (ka t) in
  let m11 := kgdot g e1 e1 in let m22 := kgdot g e2 e2 in let m33 := kgdot g e3 e3 in
  let m12 := kgdot g e1 e2 in let m13 := kgdot g e1 e3 in let m23 := kgdot g e2 e3 in
  let minor a b c d := asub (amul a b) (amul c d) in
  let c11 := minor m22 m33 m23 m23 in let c22 := minor m11 m33 m13 m13 in let c33 := minor m11 m22 m12 m12 in
  let c12 := minor m13 m23 m12 m33 in let c13 := minor m12 m23 m13 m22 in let c23 := minor m12 m13 m11 m23 in
  (aadd (aadd (aadd (amul m11 (amul m11 c11)) (amul m22 (amul m22 c22))) (amul m33 (amul m33 c33)))
     (amul (aofZ 2) (aadd (aadd (amul m11 (amul m22 c12)) (amul m11 (amul m33 c13))) (amul m22 (amul m33 c23)))),
   aadd (aadd (amul m11 c11) (amul m12 c12)) (amul m13 c13)).
Definition chk_compare (o : test) (x y : A) : bool :=
  match o with TLt => alt x y | TLe => ale x y | TGe => ale y x | TGt => alt y x end.
(** R^2 / |b - a|^2 against p/q, for X and det M as above: rule [ratio_rule] of Transfer.v. *)
Definition chk_ratio g (p : A) (q : Z) (r : A * A) (o : test) (a b : v3) : bool :=
  let e := vsub b a in chk_compare o (amul (aofZ q) (fst r)) (amul (amul (amul (aofZ 4) p) (snd r)) (kgdot g e e)).
(** The squared radius-edge ratio is the largest of R^2 / |b - a|^2. *)
Definition chk_radius g (p : A) (q : Z) (t : ktet) (o : test) : bool :=
  let r := kradius g t in test_largest (fun o => on_edge (fun a b _ _ => chk_ratio g p q r o a b)) (six t) o.

(** ** 7. Statements: Delaunay, by the power of the mate's opposite vertex at each facet *)
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
(** Not Delaunay: the power of a mate's opposite vertex is negative. *)
Definition chk_inside_at (c : cert) (kts : list ktet) (kt : ktet) (m : mref) : bool :=
  match m with
  | None => false
  | Some (k', i', d) =>
    match nth_error kts (N.to_nat k') with
    | None => false
    | Some kt' => N.ltb i' 4 && latb (c_rank c) d && alt zero (kpower (c_gram c) kt (vadd (kvx kt' (N.to_nat i')) (vofZ (c_den c) d)))
    end
  end.
Definition chk_not_delaunay (c : cert) : bool :=
  let kts := positions c in
  existsl (fun t => let kt := kpos (c_den c) (c_verts c) t in existsl (fun i => chk_inside_at c kts kt (mt t i)) I4) (c_tets c).

(** ** 8. Statements: planes that no tetrahedron crosses

    The plane c x = p/q and its translates by the lattice are the planes where q (c x) - p is a
    multiple of q g, for the greatest common divisor g of the first r entries of c.  The corners of a
    tetrahedron are between two successive ones; if g is zero, in one closed side of one plane. *)
Definition kheight (n : Z3) (p q den : Z) (v : v3) : A :=
  let '(c1, c2, c3) := n in
  asub (aadd (aadd (amul (aofZ (q * c1)) (vX v)) (amul (aofZ (q * c2)) (vY v))) (amul (aofZ (q * c3)) (vZ v))) (aofZ (p * den)).
Definition plane_step (r : nat) (n : Z3) : Z :=
  let '(c1, c2, c3) := n in
  match r with 0 => 0%Z | 1 => Z.gcd c1 0 | 2 => Z.gcd c1 c2 | _ => Z.gcd c1 (Z.gcd c2 c3) end.
(** [part d x] is about the integral part of x / d: a hint. *)
Definition chk_uncrossed (part : Z -> A -> Z) (den : Z) (r : nat) (n : Z3) (p q : Z) (t : ktet) : bool :=
  let g := plane_step r n in let hs := map (kheight n p q den) (kverts t) in
  if Z.eqb g 0 then if forallb (fun x => ale zero x) hs then true else forallb (fun x => ale x zero) hs
  else
    let u := (q * den * g)%Z in let m := part (4 * u)%Z (fold_right aadd zero hs) in
    existsl (fun m => forallb (fun x => ale (aofZ (u * m)) x && ale x (aofZ (u * (m + 1)))) hs) [m; (m - 1)%Z; (m + 1)%Z].

(** The statements of a claim. The bound of an angle is given by the sign and the square p/q
    of its cosine, that of a ratio by p/q. *)
Inductive cstatement :=
  | CAcute | CNonobtuse
  | CLargestDihedralAngle (rel : relation) (sg : Z) (p : A) (q : Z)
  | CSmallestDihedralAngle (rel : relation) (sg : Z) (p : A) (q : Z)
  | CSquaredRadiusEdgeRatio (rel : relation) (p : A) (q : Z)
  | CUncrossed (n : Z3) (p q : Z) (part : Z -> A -> Z)
  | CDelaunay | CWeaklyDelaunay | CNotDelaunay | CTCP.
Definition check_statement (c : cert) (s : cstatement) : bool :=
  let g := c_gram c in
  let all f := forallb (fun t => forallb (on_edge f) (six t)) (positions c) in
  let angles sg p q o := on_edge (chk_angle g sg p q o) in
  match s with
  | CAcute => all (chk_acute g)
  | CNonobtuse => all (chk_nonobtuse g)
  | CLargestDihedralAngle rel sg p q =>
    chk_bound sg p q && related rel (fun t => test_largest (angles sg p q) (six t)) (positions c)
  | CSmallestDihedralAngle rel sg p q =>
    chk_bound sg p q && related rel (fun t => test_smallest (angles sg p q) (six t)) (positions c)
  | CSquaredRadiusEdgeRatio rel p q =>
    Z.ltb 0 q && alt zero p && related rel (chk_radius g p q) (positions c)
  | CUncrossed n p q part => Z.ltb 0 q && forallb (chk_uncrossed part (c_den c) (c_rank c) n p q) (positions c)
  | CDelaunay => chk_delaunay alt c
  | CWeaklyDelaunay => chk_delaunay ale c
  | CNotDelaunay => chk_not_delaunay c
  | CTCP => Nat.eqb (c_rank c) 3 && chk_tcp (c_tets c)
  end.
Definition check (c : cert) (ss : list cstatement) : bool := check_tiling c && forallb (check_statement c) ss.

(** ** The hints, from the faces of the polytope

    For k = 3 - r: k = 1, a face is a vertex; k = 2, the two ends of a side; k = 3, the
    corners in cyclic order. Directions of the lattice fill up the dimension. *)
Definition at0 (i : N) : corner := (i, z30).
Definition atx (i : N) : corner := (i, (1, 0, 0)%Z).
Definition aty (i : N) : corner := (i, (0, 1, 0)%Z).
Definition spanning (r : nat) (f : list N) : corner * corner * corner :=
  match r, f with
  | 2, i :: _ => (at0 i, atx i, aty i)
  | 1, i :: j :: _ => (at0 i, at0 j, atx i)
  | _, i :: j :: k :: _ => (at0 i, at0 j, at0 k)
  | _, _ => (at0 0%N, at0 0%N, at0 0%N)
  end.
Definition half_space_over (den : Z) (r : nat) (W : list v3) (f : list N) : khalf :=
  let '(a, b, c) := spanning r f in
  let a := pos den W a in let u := vsub (pos den W b) a in let v := vsub (pos den W c) a in
  let minor p q s t := asub (amul p q) (amul s t) in
  let n := V3 (minor (vY u) (vZ v) (vZ u) (vY v)) (minor (vZ u) (vX v) (vX u) (vZ v)) (minor (vX u) (vY v) (vY u) (vX v)) in
  let d := aadd (aadd (amul (vX n) (vX a)) (amul (vY n) (vY a))) (amul (vZ n) (vZ a)) in
  let H := KH n (asub zero d) in
  if forallb (fun w => ale zero (klev H w)) W then H else KH (vsub vzero n) d.
(** The pieces of a cell: pyramids over the faces with their top at vertex 0, times the
    cell of the lattice; all in both orders of the corners, one of which is positive, or
    none if vertex 0 is in the face. *)
Definition both_orders (q : corner * corner * corner * corner) := let '(a, b, c, d) := q in [(a, b, c, d); (b, a, c, d)].
(** A triangle times an interval; a parallelogram, that of the lattice, times an interval. *)
Definition prism (up : corner -> corner) (a b c : corner) := [(a, b, c, up c); (a, b, up b, up c); (a, up a, up b, up c)].
Definition box_over (up : corner -> corner) := let o := (0, 0, 0)%Z in let x := (1, 0, 0)%Z in let y := (0, 1, 0)%Z in let xy := (1, 1, 0)%Z in
  prism up (0%N, o) (0%N, x) (0%N, y) ++ prism up (0%N, xy) (0%N, x) (0%N, y).
Fixpoint fan (f : list N) : list (N * N) := match f with i :: ((j :: _) as f) => (i, j) :: fan f | _ => [] end.
Definition pieces_over (r : nat) (f : list N) : list (corner * corner * corner * corner) :=
  flat_map both_orders match r, f with
  | 2, i :: _ => box_over (fun a => (i, snd a))
  | 1, i :: j :: _ => prism (fun a => (fst a, (1, 0, 0)%Z)) (at0 0%N) (at0 i) (at0 j)
  | _, i :: f => map (fun jk => (at0 0%N, at0 i, at0 (fst jk), at0 (snd jk))) (fan f)
  | _, [] => []
  end.
Definition cell_pieces (r : nat) (faces : list (list N)) :=
  if 3 <=? r then flat_map both_orders (box_over (cshift (0, 0, 1)%Z)) else flat_map (pieces_over r) faces.
Definition faces_cert den verts tets gram (r : nat) (W : list v3) (faces : list (list N)) : cert :=
  Cert den verts tets gram r W (map (half_space_over den r W) faces) (cell_pieces r faces).
End Ring.
