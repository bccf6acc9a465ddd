(** * The checker for the plane

    A tiling of a plane domain, times the interval [0, 1], is a tiling by prisms; each
    prism over a triangle with the corners a < b < c, in the order of their names, is cut
    into the tetrahedra a0 b0 c0 c1, a0 b0 b1 c1, a0 a1 b1 c1.  Neighbours are cut alike.
    [lift] writes down this tiling of a domain of space, and Checker.v checks it. *)
Require Import Reals NArith ZArith List Bool.
From Acutile Require Import Statement Tetrahedra Degree Domain Bounds Checker.
Import ListNotations.
Local Open Scope nat_scope.

(** The corners in ascending order of their names; a positive triangle is [even]. *)
Definition corner2 := (N * (Z * Z))%type.
Definition mref2 := option (N * N * (Z * Z)).
Record ctri := CTri { p0 : corner2; p1 : corner2; p2 : corner2; n0 : mref2; n1 : mref2; n2 : mref2; even : bool }.

Definition up3 (n : Z * Z) : Z3 := (fst n, snd n, 0%Z).
Definition low (q : corner2) : corner := (fst q, up3 (snd q)).
(** The vertices come twice: V below, V above. *)
Definition top (V : N) (q : corner2) : corner := ((fst q + V)%N, up3 (snd q)).

(** Tetrahedra over a triangle that is not even have their first two corners exchanged. *)
Definition turned (e : bool) (t : ctet) : ctet :=
  if e then t else CT (q1 t) (q0 t) (q2 t) (q3 t) (m1 t) (m0 t) (m2 t) (m3 t).
Definition slot (e : bool) (i : N) : N := if e then i else match i with 0%N => 1%N | 1%N => 0%N | _ => i end.
(** The lower and the upper triangle over the mate of an edge. *)
Definition lifted_mate (ts : list ctri) (f : N -> bool -> N * N) (m : mref2) : mref :=
  match m with
  | None => None
  | Some (t, j, u) =>
    let e := match nth_error ts (N.to_nat t) with Some t' => even t' | None => true end in
    Some ((3 * t + fst (f j e))%N, snd (f j e), up3 u)
  end.
Definition lower (j : N) (e : bool) : N * N := match j with 0%N => (0%N, slot e 0) | 1%N => (0%N, slot e 1) | 2%N => (1%N, 3%N) | _ => (0%N, 4%N) end.
Definition upper (j : N) (e : bool) : N * N := match j with 0%N => (1%N, slot e 0) | 1%N => (2%N, 2%N) | 2%N => (2%N, 3%N) | _ => (0%N, 4%N) end.
Definition tetA V ts (k : N) t := turned (even t) (CT (low (p0 t)) (low (p1 t)) (low (p2 t)) (top V (p2 t))
  (lifted_mate ts lower (n0 t)) (lifted_mate ts lower (n1 t)) (Some ((3 * k + 1)%N, slot (even t) 1, z30)) None).
Definition tetB V ts (k : N) t := turned (even t) (CT (low (p0 t)) (top V (p1 t)) (low (p1 t)) (top V (p2 t))
  (lifted_mate ts upper (n0 t)) (Some ((3 * k)%N, 2%N, z30)) (Some ((3 * k + 2)%N, slot (even t) 1, z30)) (lifted_mate ts lower (n2 t))).
Definition tetC V ts (k : N) t := turned (even t) (CT (low (p0 t)) (top V (p0 t)) (top V (p1 t)) (top V (p2 t))
  None (Some ((3 * k + 1)%N, 2%N, z30)) (lifted_mate ts upper (n1 t)) (lifted_mate ts upper (n2 t))).
Fixpoint prisms V all (k : N) (ts : list ctri) : list ctet :=
  match ts with [] => [] | t :: ts => tetA V all k t :: tetB V all k t :: tetC V all k t :: prisms V all (k + 1) ts end.

Section Ring.
Variables (A : Type) (aadd asub amul : A -> A -> A) (aofZ : Z -> A) (alt ale : A -> A -> bool).
Notation zero := (zero A aofZ).

(** Integral data, as in Checker.v. *)
Record cert2 := Cert2 {
  e_den : Z; e_verts : list (A * A); e_tris : list ctri; e_gram : A * A * A;
  e_rank : nat; e_polytope : list (A * A); e_faces : list (list N) }.

Definition level0 (p : A * A) : v3 A := V3 A (fst p) (snd p) zero.
Definition level1 (den : Z) (p : A * A) : v3 A := V3 A (fst p) (snd p) (aofZ den).
Definition both_levels (den : Z) (ps : list (A * A)) := map level0 ps ++ map (level1 den) ps.
Definition V2 (c : cert2) : N := N.of_nat (length (e_verts c)).

(** The polytope P x [0, 1], its faces, and its pieces. *)
Definition polytope2 (c : cert2) : list (v3 A) := match e_rank c with 0 | 1 => both_levels (e_den c) (e_polytope c) | _ => [level0 (zero, zero); level1 (e_den c) (zero, zero)] end.
Definition faces2 (c : cert2) : list (list N) :=
  let n := N.of_nat (length (e_polytope c)) in
  match e_rank c with
  | 0 => [0%N; 1%N; 2%N] :: [n; (n + 1)%N; (n + 2)%N] :: map (fun f => match f with [i; j] => [i; j; (n + j)%N; (n + i)%N] | _ => f end) (e_faces c)
  | 1 => [0%N; 1%N] :: [n; (n + 1)%N] :: map (fun f => match f with [i] => [i; (n + i)%N] | _ => f end) (e_faces c)
  | _ => [[0%N]; [1%N]]
  end.
Definition pieces2 (c : cert2) : list (corner * corner * corner * corner) :=
  let n := N.of_nat (length (e_polytope c)) in
  match e_rank c with
  | 0 => flat_map (fun f => match f with
      | [i; j] => flat_map both_orders (prism (fun a => ((n + fst a)%N, snd a)) (at0 0%N) (at0 i) (at0 j))
      | _ => [] end) (e_faces c)
  | r => flat_map (pieces_over r) (faces2 c)
  end.

Definition lift (c : cert2) : cert A :=
  let '(g11, g22, g12) := e_gram c in
  let W := polytope2 c in
  Cert A (e_den c) (both_levels (e_den c) (e_verts c)) (prisms (V2 c) (e_tris c) 0 (e_tris c))
    (KG A g11 g22 (aofZ 1) g12 zero zero)
    (e_rank c) W (map (half_space_over A aadd asub amul aofZ ale (e_den c) (e_rank c) W) (faces2 c)) (pieces2 c).

(** ** Statements *)
Definition place (c : cert2) (q : corner) : v3 A := pos A aadd aofZ (e_den c) (both_levels (e_den c) (e_verts c)) q.
(** The vertical edges over the three corners, each with the other two corners. *)
Definition three (c : cert2) (t : ctri) : list (v3 A * v3 A * v3 A * v3 A) :=
  let at_ p q r := (place c (low p), place c (top (V2 c) p), place c (low q), place c (low r)) in
  [at_ (p0 t) (p1 t) (p2 t); at_ (p1 t) (p0 t) (p2 t); at_ (p2 t) (p0 t) (p1 t)].
(** The circumradius of a triangle: R^2 = product of the squared sides / (4 det M). *)
Definition kradius2 g (a b c : v3 A) : A * A :=
  let u := vsub A asub b a in let v := vsub A asub c a in let w := vsub A asub c b in
  let kgdot := kgdot A aadd amul g in
  (amul (kgdot u u) (amul (kgdot v v) (kgdot w w)), asub (amul (kgdot u u) (kgdot v v)) (amul (kgdot u v) (kgdot u v))).
Definition chk_radius2 (c : cert2) (p : A) (q : Z) (t : ctri) (o : test) : bool :=
  let g := c_gram A (lift c) in
  let a := place c (low (p0 t)) in let b := place c (low (p1 t)) in let d := place c (low (p2 t)) in
  let r := kradius2 g a b d in
  test_largest (fun o e => chk_ratio A aadd asub amul aofZ alt ale g p q r o (fst e) (snd e)) [(a, b); (a, d); (b, d)] o.
(** Strictly Delaunay: at each edge, by one of the two triangles over it. *)
Fixpoint chk_edges (c : cert A) (kts : list (ktet A)) (ts : list ctet) : bool :=
  let strict t i := chk_power A aadd asub amul aofZ alt (c_gram A c) (c_den A c) kts t (kpos A aadd aofZ (c_den A c) (c_verts A c) t) i in
  match ts with
  | a :: b :: _ :: ts => strict a 0 && strict a 1 && strict b 3 && chk_edges c kts ts
  | _ => true
  end.
(** Not Delaunay: a corner of a mate is inside of the ball of the first tetrahedron over a triangle, which
    meets the bottom plane in the circumscribed circle. *)
Definition bottom_mate (ts : list ctri) (m : mref2) : mref :=
  match m with Some (_, j, _) => if N.ltb j 3 then lifted_mate ts (fun j e => (0%N, slot e j)) m else None | None => None end.
Definition chk_not_delaunay2 (c : cert2) : bool :=
  let c3 := lift c in let kts := positions A aadd aofZ c3 in
  existsl (fun t => let kt := kpos A aadd aofZ (c_den A c3) (c_verts A c3) (tetA (V2 c) (e_tris c) 0 t) in
    existsl (fun m => chk_inside_at A aadd asub amul aofZ alt c3 kts kt (bottom_mate (e_tris c) m)) [n0 t; n1 t; n2 t]) (e_tris c).
Definition check_statement2 (c : cert2) (s : cstatement A) : bool :=
  let g := c_gram A (lift c) in
  let all f := forallb (fun t => forallb (on_edge A f) (three c t)) (e_tris c) in
  let angles sg p q o := on_edge A (chk_angle A aadd asub amul aofZ alt ale g sg p q o) in
  match s with
  | CAcute _ => all (chk_acute A aadd asub amul aofZ alt g)
  | CNonobtuse _ => all (chk_nonobtuse A aadd asub amul aofZ ale g)
  | CLargestDihedralAngle _ rel sg p q =>
    chk_bound A aofZ alt ale sg p q && related rel (fun t => test_largest (angles sg p q) (three c t)) (e_tris c)
  | CSmallestDihedralAngle _ rel sg p q =>
    chk_bound A aofZ alt ale sg p q && related rel (fun t => test_smallest (angles sg p q) (three c t)) (e_tris c)
  | CSquaredRadiusEdgeRatio _ rel p q => Z.ltb 0 q && alt zero p && related rel (chk_radius2 c p q) (e_tris c)
  | CUncrossed _ (c1, c2, _) p q part => let c3 := lift c in
    Z.ltb 0 q && forallb (chk_uncrossed A aadd asub amul aofZ ale part (c_den A c3) (c_rank A c3) (c1, c2, 0%Z) p q) (positions A aadd aofZ c3)
  | CDelaunay _ => let c3 := lift c in
    chk_delaunay A aadd asub amul aofZ ale c3 && chk_edges c3 (positions A aadd aofZ c3) (c_tets A c3)
  | CWeaklyDelaunay _ => chk_delaunay A aadd asub amul aofZ ale (lift c)
  | CNotDelaunay _ => chk_not_delaunay2 c
  | CTCP _ => false
  end.
Definition in_range (c : cert2) (t : ctri) := N.ltb (fst (p0 t)) (V2 c) && N.ltb (fst (p1 t)) (V2 c) && N.ltb (fst (p2 t)) (V2 c).
Definition check_tiling2 (c : cert2) : bool :=
  Nat.leb (e_rank c) 2 && forallb (in_range c) (e_tris c) && check_tiling A aadd asub amul aofZ alt ale (lift c).
Definition check2 (c : cert2) (ss : list (cstatement A)) : bool := check_tiling2 c && forallb (check_statement2 c) ss.
End Ring.
