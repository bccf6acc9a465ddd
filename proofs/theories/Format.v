(** * The rules of the format, and the data of the checker

    The first part has the rules of docs/format.md that no theorem needs, such as lowest
    terms and the order of corners: they can refuse a certificate, and accept none.  The
    second part turns a certificate into the data of Checker.v and PlaneChecker.v, and asks
    for all that the theorem of Bytes.v needs. *)
From Coq Require Import Reals NArith ZArith List Bool String FMapPositive.
From Acutile Require Import Statement Tetrahedra Degree Domain Checker PlaneChecker Polytope Numbers Fast Grid RegionChecker PlaneRegionChecker Denote Pairing.
Import ListNotations.
Local Open Scope nat_scope.
Notation length := List.length.

(** The corners of the checker have three entries in a shift. *)
Definition shift3 (s : list Z) : Z3 :=
  match s with [] => z30 | [x] => (x, 0, 0)%Z | [x; y] => (x, y, 0)%Z | x :: y :: z :: _ => (x, y, z) end.
Definition corner3 (q : Denote.corner) : Checker.corner := (fst q, shift3 (snd q)).
Definition row_corners (r : row) : list Checker.corner := map corner3 (fst r).
Definition faces_of (k : tiling_claim) : list (list N) := match polytope_of (region_of k) with Some P => p_faces P | None => [] end.

(** ** 1. Rules of the format *)
Inductive refusal := Malformed (why : string) | Rejected (why : string) | Declined (why : string).
Inductive verdict := Accepted (k : claim) | Refused (r : refusal).
Notation "'need' c 'else' v ; e" := (if c then e else Some v) (at level 200, c at level 100, v at level 100, e at level 200).

(** The integers in a number. *)
Definition integers (x : number) : list Z := match x with Plain x => x | Polynomial l => flat_map fst l end.
Definition degree (f : field) : nat := match f with Rationals => 1 | Root p _ _ _ => length p - 1 end.
Definition bits (z : Z) : N := N.size (Z.abs_N z).
Definition fold_numbers {X} (f : X -> Z -> X) (table : list (list number)) (m : X) : X :=
  fold_left (fun m v => fold_left (fun m x => fold_left f (integers x) m) v m) table m.
Definition common_divisor (m : Z) (table : list (list number)) : Z := fold_numbers Z.gcd table m.
Definition proper_denominator (m : Z) (table : list (list number)) : bool := Z.ltb 0 m && Z.eqb (common_divisor m table) 1.
(** With m parameters: without any a number has n coefficients; else it is a list of terms that are
    not zero, with exponents from 0 to 15, in ascending order of these. *)
Fixpoint ascends (e f : list N) : bool :=
  match e, f with x :: e, y :: f => N.ltb x y || (N.eqb x y && ascends e f) | _, _ => false end.
Fixpoint all_ascend (l : list (list N)) : bool := match l with e :: (f :: _) as r => ascends e f && all_ascend r | _ => true end.
Definition proper_term (m n : nat) (t : list Z * list N) : bool :=
  Nat.eqb (length (fst t)) n && existsb (fun z => negb (Z.eqb 0 z)) (fst t) &&
  Nat.eqb (length (snd t)) m && forallb (fun e => N.leb e 15) (snd t).
Definition proper_number (m n : nat) (x : number) : bool :=
  match m, x with
  | 0, Plain x => Nat.eqb (length x) n
  | S _, Polynomial l => forallb (proper_term m n) l && all_ascend (map snd l)
  | _, _ => false
  end.
Definition rows_of (m n d : nat) (table : list (list number)) : bool :=
  forallb (fun v => Nat.eqb (length v) d && forallb (proper_number m n) v) table.
Fixpoint triangular (m n d : nat) (rows : list (list number)) : bool :=
  match d, rows with
  | 0, [] => true
  | S d', row :: rows => rows_of m n d [row] && triangular m n d' rows
  | _, _ => false
  end.

Local Open Scope string_scope.
Definition field_refusal (f : field) : option refusal :=
  match f with
  | Rationals => None
  | Root p lo hi d =>
    need (Nat.leb 2 (degree f) && Z.eqb (last p 0%Z) 1) else Malformed "the polynomial is not monic of degree at least two";
    need Nat.leb (degree f) 8 else Declined "the degree";
    need (Z.ltb 0 d && Z.ltb lo hi) else Malformed "the interval of the root";
    need Z.eqb (Z.gcd d (Z.gcd lo hi)) 1 else Malformed "a common factor of the interval of the root";
    need (N.leb (bits lo) 400 && N.leb (bits hi) 400 && N.leb (bits d) 400) else Declined "a root with long ends";
    match polynomial_sign p d lo, polynomial_sign p d hi with
    | Lt, Gt | Gt, Lt => None
    | _, _ => Some (Rejected "the polynomial does not change its sign")
    end
  end.
Definition region_refusal (m : nat) (k : tiling_claim) : option refusal :=
  match region_of k with
  | Space => None
  | Region r => need Nat.leb r (dimension k) else Malformed "the rank of the region"; None
  | Slab P | Prism P | Solid P =>
    need (match region_of k with Prism _ => Nat.eqb (dimension k) 3 | _ => true end) else Malformed "a prism in the plane";
    need rows_of m (degree (over k)) (dimension k - rank k) (p_vertices P) else Malformed "the vertices of the polytope";
    need proper_denominator (p_denominator P) (p_vertices P) else Malformed "the denominator of the polytope";
    need forallb (forallb (fun i => N.ltb i (N.of_nat (length (p_vertices P))))) (p_faces P) else Malformed "a vertex of a face out of range";
    None
  end.
(** Sentences stand in the order of the grammar; their places increase. *)
Definition relation_place (rel : relation) : nat :=
  match rel with LessThan => 0 | AtMost => 1 | Maximum => 2 | MoreThan => 3 | AtLeast => 4 | Minimum => 5 end.
Definition sentence_place (s : sentence) : nat :=
  match s with
  | FaceToFaceTiling => 0 | IsAcute => 1 | IsNonobtuse => 2
  | LargestAngle rel _ _ _ => 10 + relation_place rel
  | SmallestAngle rel _ _ _ => 20 + relation_place rel
  | SquaredRatio rel _ _ => 30 + relation_place rel
  | UncrossedPlane _ _ _ => 36
  | IsDelaunay => 40 | IsWeaklyDelaunay => 41 | IsLocallyDelaunay => 42 | IsLocallyWeaklyDelaunay => 43 | IsNotDelaunay => 44 | IsTCP => 45
  end.
Fixpoint lexicographic (x y : list Z) : bool :=
  match x, y with a :: x, b :: y => Z.ltb a b || (Z.eqb a b && lexicographic x y) | _, _ => false end.
(** Planes stand in the order of their coefficients, then of p, then of q. *)
Definition precedes (s t : sentence) : bool :=
  match s, t with
  | UncrossedPlane c p q, UncrossedPlane d u v => lexicographic (c ++ [p; q]) (d ++ [u; v])
  | _, _ => Nat.ltb (sentence_place s) (sentence_place t)
  end.
Fixpoint increasing (l : list sentence) : bool :=
  match l with a :: (b :: _) as r => precedes a b && increasing r | _ => true end.
Definition is_plane (s : sentence) : bool := match s with UncrossedPlane _ _ _ => true | _ => false end.
Definition is_tcp (s : sentence) : bool := match s with IsTCP => true | _ => false end.
Definition is_global (s : sentence) : bool := match s with IsDelaunay | IsWeaklyDelaunay => true | _ => false end.
Definition is_local (s : sentence) : bool := match s with IsLocallyDelaunay | IsLocallyWeaklyDelaunay => true | _ => false end.
Definition positive_first (c : list Z) : bool := match filter (fun x => negb (Z.eqb 0 x)) c with x :: _ => Z.ltb 0 x | [] => false end.
Definition proper_bound (d n : nat) (s : sentence) : bool :=
  let fraction p q := proper_number 0 n p && proper_denominator q [[p]] in
  match s with
  | LargestAngle _ sg p q | SmallestAngle _ sg p q =>
    Z.leb (-1) sg && Z.leb sg 1 && fraction p q && Bool.eqb (Z.eqb sg 0) (forallb (Z.eqb 0) (integers p))
  | SquaredRatio _ p q => fraction p q
  | UncrossedPlane c p q =>
    Nat.eqb (length c) d && Z.eqb (fold_left Z.gcd c 0%Z) 1 && positive_first c && forallb (fun x => Z.ltb (Z.abs x) 536870912) c &&
    Z.ltb 0 q && Z.eqb (Z.gcd p q) 1
  | _ => true
  end.
Definition is_region (k : tiling_claim) : bool := match region_of k with Region _ => true | _ => false end.
Definition claim_refusal (m : nat) (k : tiling_claim) : option refusal :=
  let n := degree (over k) in
  need (Nat.eqb (dimension k) 2 || Nat.eqb (dimension k) 3) else Malformed "the dimension";
  match field_refusal (over k) with Some v => Some v | None =>
  need (triangular m n (dimension k) (gram_rows k) && Z.eqb (common_divisor 0 (gram_rows k)) 1) else Malformed "the Gram matrix";
  match region_refusal m k with Some v => Some v | None =>
  need (match sentences k with FaceToFaceTiling :: _ => true | _ => false end && increasing (sentences k))
    else Malformed "the order of the statements";
  need forallb (proper_bound (dimension k) n) (sentences k) else Malformed "a bound";
  need (Nat.eqb m 0 || negb (existsb is_plane (sentences k))) else Malformed "an uncrossed plane of a family";
  need (is_region k || negb (existsb is_local (sentences k))) else Malformed "a local statement about a domain that is not a region";
  need (negb (is_region k) || negb (existsb is_global (sentences k))) else Malformed "Delaunay of a region";
  need (negb (existsb is_tcp (sentences k)) || (Nat.eqb (dimension k) 3 && Nat.eqb (rank k) 3 && negb (is_region k))) else Malformed "TCP is stated of space only";
  None
  end end.

(** A row: the corners in order, the first with the shift zero; sixes exactly if TCP is stated. *)
Definition proper_shift (r : nat) (s : list Z) : bool :=
  match s with
  | [] => true
  | _ => Nat.eqb (length s) r && existsb (fun x => negb (Z.eqb x 0)) s && forallb (fun x => Z.ltb (Z.abs x) 536870912) s
  end.
Definition in_order (q : list Checker.corner) : bool :=
  match q with
  | [a; b; c] => before a b && before a c && negb (ceqb b c)
  | [a; b; c; d] => before a b && before b c && before b d && negb (ceqb c d)
  | _ => false
  end.
Definition row_refusal (k : tiling_claim) (count : N) (tcp : bool) (r : row) : option refusal :=
  need Nat.eqb (length (fst r)) (dimension k + 1) else Malformed "the length of a row";
  need forallb (fun q => N.ltb (fst q) count) (fst r) else Malformed "a vertex out of range";
  need forallb (fun q => proper_shift (rank k) (snd q)) (fst r) else Malformed "a shift";
  need match fst r with (_, []) :: _ => true | _ => false end else Malformed "the first corner has a shift";
  need in_order (row_corners r) else Malformed "the order of the corners";
  match snd r, tcp with
  | None, false => None
  | Some b, true => if Z.leb 0 b && Z.ltb b 64 then None else Some (Malformed "the bits of a row")
  | _, _ => Some (Malformed "the length of a row")
  end.
(** A boundary facet: its corners in order, the first one listed with the shift zero. *)
Definition facet_refusal (k : tiling_claim) (count : N) (f : list corner) : option refusal :=
  need Nat.eqb (length f) (dimension k) else Malformed "the length of a boundary facet";
  need forallb (fun q => N.ltb (fst q) count) f else Malformed "a vertex out of range";
  need forallb (fun q => proper_shift (rank k) (snd q)) f else Malformed "a shift";
  need match f with (_, []) :: _ => true | _ => false end else Malformed "the first corner has a shift";
  need match map corner3 f with
    | [a; b; c] => before a b && before a c && negb (ceqb b c)
    | [a; b] => negb (ceqb a b)
    | _ => false
    end else Malformed "the order of the corners";
  None.
Fixpoint first_refusal {X} (f : X -> option refusal) (l : list X) : option refusal :=
  match l with [] => None | x :: l => match f x with None => first_refusal f l | v => v end end.

(** About how many determinants the checks compute, at most, for t simplices and a polytope of dimension
    k with w vertices.  For a tile a hundred: signs, angles, spheres.  For each of its corners half of
    the pieces, and the planes of the faces (in_piece, chk_inside).  For two pieces of positive volume
    the planes of all of them, four each (chk_apart).  Faces: each with all vertices, sides with sides. *)
Definition determinants (k t w : nat) (faces : list (list N)) : N :=
  let cap x := N.min x 100000 in
  let sides := fold_left (fun n f => N.add n (N.of_nat (length f))) faces 0%N in
  let n := N.of_nat (length faces) in
  let pieces := match k with
    | 0 => 6%N
    | 1 => (6 * n)%N
    | 2 => (3 * n)%N
    | _ => fold_left (fun m f => if existsb (N.eqb 0) f then m else (m + N.of_nat (length f - 2))%N) faces 0%N
    end in
  let t := cap (N.of_nat t) in let w := cap (N.of_nat w) in let p := cap pieces in let n := cap n in let sides := cap sides in
  (100 * t + 20 * t * (p + n) + 2 * p * p * p + n * w + sides * sides)%N.
Definition too_much_work (k : tiling_claim) (w : tiling_witness) : bool :=
  let vertices := match polytope_of (region_of k) with Some P => p_vertices P | None => [] end in
  let most := fold_numbers (fun m x => N.max m (bits x)) in
  let words := (1 + most vertices (most (w_vertices w) (most (gram_rows k) 0)) / 64)%N in
  let n := N.of_nat (degree (over k)) in
  N.ltb (100000000 / (n * n * words * words)) (determinants (dimension k - rank k) (length (w_rows w)) (length vertices) (faces_of k)).

(** Every vertex is used. *)
Definition used_vertices (rows : list row) : PositiveMap.t unit :=
  fold_left (fun m r => fold_left (fun m q => PositiveMap.add (N.succ_pos (fst q)) tt m) (fst r) m) rows (PositiveMap.empty unit).
Fixpoint all_used (m : PositiveMap.t unit) (v : N) (l : list (list number)) : bool :=
  match l with [] => true | _ :: l => match entry m v with Some _ => all_used m (N.succ v) l | None => false end end.
(** The bits of a row say which edges of its sorted corners have valence 6. *)
Definition six_bits (m : tally) (r : row) : Z :=
  match sort_corners (row_corners r) with
  | [a; b; c; d] =>
    let bit (p : Z) x y := if is_six (count_of m (edge_key x y)) then p else 0%Z in
    (bit 1 a b + bit 2 a c + bit 4 a d + bit 8 b c + bit 16 b d + bit 32 c d)%Z
  | _ => (-1)%Z
  end.
Definition sixes_agree (ts : list ctet) (rows : list row) : bool :=
  let m := tallied ts in
  forallb (fun r => match snd r with Some b => Z.eqb (six_bits m r) b | None => false end) rows.
Definition witness_refusal (m : nat) (k : tiling_claim) (w : tiling_witness) : option refusal :=
  let tcp := existsb is_tcp (sentences k) in
  need rows_of m (degree (over k)) (dimension k) (w_vertices w) else Malformed "the length of a vertex";
  need proper_denominator (w_denominator w) (w_vertices w) else Malformed "the denominator";
  need Bool.eqb (is_region k) match w_boundary w with [] => false | _ => true end else Malformed "boundary facets are listed for a region, and for no other domain";
  need match w_rows w with [] => false | _ => true end else Malformed "no simplices";
  match first_refusal (row_refusal k (N.of_nat (length (w_vertices w))) tcp) (w_rows w) with Some v => Some v | None =>
  match first_refusal (facet_refusal k (N.of_nat (length (w_vertices w)))) (w_boundary w) with Some v => Some v | None =>
  need all_used (used_vertices (w_rows w)) 0 (w_vertices w) else Malformed "an unused vertex";
  need negb (too_much_work k w) else Declined "the work";
  None
  end end.

(** *** Families: names, ends, terms, the tree *)
Definition between (lo hi : N) (c : Ascii.ascii) : bool := let n := Ascii.N_of_ascii c in N.leb lo n && N.leb n hi.
Definition name_letter (c : Ascii.ascii) : bool := between 97 122 c || between 48 57 c || between 95 95 c.
Definition proper_name (s : string) : bool :=
  match s with
  | String c r => between 97 122 c && forallb name_letter (list_ascii_of_string r) && Nat.leb (String.length s) 16
  | EmptyString => false
  end.
Fixpoint distinct_names (l : list string) : bool :=
  match l with [] => true | s :: l => negb (existsb (String.eqb s) l) && distinct_names l end.
Definition proper_limit (n : nat) (e : limit) : bool :=
  Nat.eqb (length (numerator e)) n && proper_denominator (divisor e) [[Plain (numerator e)]].
Definition values_of (k : tiling_claim) (w : tiling_witness) : list (list number) :=
  gram_rows k ++ match polytope_of (region_of k) with Some P => p_vertices P | None => [] end ++ w_vertices w.
(** The greatest exponent of the parameter with number i. *)
Definition greatest (i : nat) (table : list (list number)) : N :=
  fold_left (fun m x => match x with Polynomial l => fold_left (fun m t => N.max m (nth i (snd t) 0%N)) l m | Plain _ => m end) (List.concat table) 0%N.
Fixpoint leaf_count (t : tree) : N := match t with Leaf => 1 | Halve _ l u => leaf_count l + leaf_count u end%N.
Fixpoint depth (t : tree) : nat := match t with Leaf => 0 | Halve _ l u => S (Nat.max (depth l) (depth u)) end.
Fixpoint proper_axes (m : N) (t : tree) : bool :=
  match t with Leaf => true | Halve a l u => N.ltb a m && proper_axes m l && proper_axes m u end.
Definition family_refusal (ps : list parameter) (k : tiling_claim) (t : tree) (w : tiling_witness) : option refusal :=
  let m := length ps in let n := degree (over k) in let names := map p_name ps in
  need (Nat.leb 1 m && Nat.leb m 64) else Malformed "the number of parameters";
  need (forallb proper_name names && distinct_names names) else Malformed "the name of a parameter";
  need (Nat.eqb n 1 || negb (existsb (String.eqb "a") names)) else Malformed "a parameter with the name of the generator";
  need forallb (fun p => proper_limit n (p_low p) && proper_limit n (p_high p)) ps else Malformed "an end of an interval";
  match claim_refusal m k with Some v => Some v | None =>
  need negb (is_region k) else Malformed "a family of regions";
  match witness_refusal m k w with Some v => Some v | None =>
  need proper_axes (N.of_nat m) t else Malformed "the axis of a tree";
  need (N.leb (leaf_count t) 4096 && Nat.leb (depth t) 64) else Declined "the tree";
  let degrees := map (fun i => greatest i (values_of k w)) (seq 0 m) in
  need forallb (N.ltb 0) degrees else Malformed "an unused parameter";
  let size := fold_left (fun s d => N.min 1000000 (s * (3 * d + 1)))%N degrees 1%N in
  (* terms of a determinant, squared, for each row and leaf *)
  let n := N.of_nat n in
  need N.leb (leaf_count t * size * size * n * n * (1 + N.of_nat (length (w_rows w)))) 10000000 else Declined "the work";
  None
  end end.

(** *** Systems of patches *)
Definition polygon_refusal (n r : nat) (T : polygon) : option refusal :=
  let sides := length (t_vertices T) in
  need rows_of 0 n (3 - r) (t_vertices T) else Malformed "the vertices of a tile";
  need proper_denominator (t_denominator T) (t_vertices T) else Malformed "the denominator of a tile";
  need (if Nat.eqb r 2 then Nat.eqb sides 2 else Nat.leb 3 sides) else Malformed "the number of sides of a tile";
  need Nat.eqb (length (t_classes T)) sides else Malformed "the number of classes";
  None.
(** The claim as one of a region of the rank: for the rules on shifts. *)
Definition as_ranked (k : patches_claim) : tiling_claim := TilingClaim 3 (base_field k) (base_gram k) (Region (fibre_rank k)) (patch_sentences k).
Definition corner_refusal (r : nat) (count : N) (q : Denote.corner) : option refusal :=
  need N.ltb (fst q) count else Malformed "a vertex out of range";
  need proper_shift r (snd q) else Malformed "a shift";
  None.
Definition pyramid_refusal (r : nat) (count : N) (y : Denote.corner * list Denote.corner) : option refusal :=
  match first_refusal (corner_refusal r count) (fst y :: snd y) with Some v => Some v | None =>
  let qs := map corner3 (fst y :: snd y) in
  need Nat.leb 3 (length (snd y)) else Malformed "a polygon of less than three corners";
  need match snd y with (_, []) :: _ => true | _ => false end else Malformed "the first corner of a polygon has a shift";
  need forallb (fun q => Nat.eqb (length (filter (ceqb q) qs)) 1) qs else Malformed "a corner of a pyramid that occurs twice";
  None end.
Definition patch_refusal (k : patches_claim) (Tw : polygon * patch_witness) : option refusal :=
  let n := degree (base_field k) in let r := fibre_rank k in let '(T, w) := Tw in let count := N.of_nat (length (q_vertices w)) in
  need (rows_of 0 n r (q_offsets w) && Nat.eqb (length (q_offsets w)) (length (t_vertices T))) else Malformed "the offsets";
  need rows_of 0 n 3 (q_vertices w) else Malformed "the length of a vertex";
  need proper_denominator (q_denominator w) (q_offsets w ++ q_vertices w) else Malformed "the denominator";
  match first_refusal (pyramid_refusal r count) (q_pyramids w) with Some v => Some v | None =>
  need match q_simplices w with [] => false | _ => true end else Malformed "no simplices";
  let rows := map (fun t => (t, None)) (q_simplices w) in
  match first_refusal (row_refusal (as_ranked k) count false) rows with Some v => Some v | None =>
  need all_used (used_vertices (map (fun y => (fst y :: snd y, None)) (q_pyramids w) ++ rows)) 0 (q_vertices w) else Malformed "an unused vertex";
  None end end.
Definition patches_refusal (k : patches_claim) (ws : list patch_witness) : option refusal :=
  match claim_refusal 0 (as_tiling k) with Some v => Some v | None =>
  need (negb (existsb is_plane (patch_sentences k))) else Declined "an uncrossed plane of a system of patches";
  need (match polygons k with [] => false | _ => true end && Nat.eqb (length ws) (length (polygons k))) else Malformed "the number of patches";
  match first_refusal (polygon_refusal (degree (base_field k)) (fibre_rank k)) (polygons k) with Some v => Some v | None =>
  match first_refusal (patch_refusal k) (combine (polygons k) ws) with Some v => Some v | None =>
  let sides := fold_left (fun m T => m + length (t_vertices T)) (polygons k) 0 in
  let cells := fold_left (fun m w => m + length (q_simplices w) + length (flat_map snd (q_pyramids w))) ws 0 in
  need (Nat.leb sides 40 && Nat.leb cells 600) else Declined "the work";
  None end end end.

(** ** 2. The data of the checker, over a ring *)
Local Close Scope string_scope.
Local Open Scope Z_scope.
Definition scale_number (f : Z) (x : number) : number :=
  match x with Plain x => Plain (map (Z.mul f) x) | Polynomial l => Polynomial (map (fun t => (map (Z.mul f) (fst t), snd t)) l) end.
(** The polytope over the witness's denominator, with z zeros in front. *)
Definition factor (w : tiling_witness) (P : polytope) : Z := w_denominator w / p_denominator P.
Definition scaled (k : tiling_claim) (w : tiling_witness) (z : nat) : list (list number) :=
  match polytope_of (region_of k) with
  | Some P => map (fun v => repeat (Plain [0]) z ++ map (scale_number (factor w P)) v) (p_vertices P)
  | None => []
  end.
Definition denominators_agree (k : tiling_claim) (w : tiling_witness) : bool :=
  match polytope_of (region_of k) with Some P => Z.eqb (w_denominator w) (factor w P * p_denominator P) | None => true end.
Definition states_tiling (k : tiling_claim) : bool := existsb (fun s => match s with FaceToFaceTiling => true | _ => false end) (sentences k).

(** The corners of a row are those of the simplex, in the plane in some order. *)
Definition same_row (count : N) (r : row) (t : ctet) : bool :=
  match fst r with
  | [a; b; c; d] =>
    forallb (fun q => N.ltb (fst q) count) (fst r) &&
    ceqb (corner3 a) (q0 t) && ceqb (corner3 b) (q1 t) && ceqb (corner3 c) (q2 t) && ceqb (corner3 d) (q3 t)
  | _ => false
  end.
Definition ceqb2 (q : Denote.corner) (p : corner2) : bool :=
  N.eqb (fst q) (fst p) && Z.eqb (nth 0 (snd q) 0) (fst (snd p)) && Z.eqb (nth 1 (snd q) 0) (snd (snd p)).
Definition same_triangle (count : N) (r : row) (t : ctri) : bool :=
  match fst r with
  | [a; b; c] =>
    forallb (fun q => N.ltb (fst q) count) (fst r) && ceqb2 a (p0 t) &&
    ((ceqb2 b (p1 t) && ceqb2 c (p2 t)) || (ceqb2 b (p2 t) && ceqb2 c (p1 t)))
  | _ => false
  end.

(** The boundary facets of a region: facet i of tetrahedron j, moved by d, has the corners listed, in
    the order of the other side, and no mate; and there are no other facets without a mate. *)
Definition facet_is (r : nat) (tm : PositiveMap.t ctet) (f : list Denote.corner) (p : N * N * Z3) : bool :=
  let '(j, i, d) := p in
  match entry tm j, map corner3 f with
  | Some t, [a; b; c] =>
    N.ltb i 4 && latb r d && unmated t (N.to_nat i) && codd d (a, b, c) (cfc t (N.to_nat i))
  | _, _ => false
  end.
Definition marked (l : list (N * N * Z3)) : PositiveMap.t unit :=
  fold_left (fun m p => let '(j, i, _) := p in PositiveMap.add (place j i) tt m) l (PositiveMap.empty unit).
Definition all_marked (m : PositiveMap.t unit) (fs : list (N * ctet * nat)) : bool :=
  forallb (fun f => let '(k, _, i) := f in match PositiveMap.find (place k (N.of_nat i)) m with Some _ => true | None => false end) fs.
Definition facets_agree (k : tiling_claim) (w : tiling_witness) (ts : list ctet) (places : list (N * N * Z3)) : bool :=
  if is_region k then Nat.leb (rank k) 3 && both (facet_is (rank k) (tabulate ts)) (w_boundary w) places && all_marked (marked places) (RegionChecker.open_facets ts)
  else match w_boundary w with [] => true | _ => false end.

(** The same in the plane: from the first end to the second the region is on the left. *)
Definition moved2 (d : Z3) (p : corner2) : corner2 := (fst p, (fst (snd p) + fst (fst d), snd (snd p) + snd (fst d))).
Definition ends (t : ctri) (i : nat) : corner2 * corner2 :=
  let '(a, b) := match i with O => (p1 t, p2 t) | S O => (p2 t, p0 t) | _ => (p0 t, p1 t) end in if even t then (a, b) else (b, a).
Definition side_is (r : nat) (tm : PositiveMap.t ctri) (f : list Denote.corner) (p : N * N * Z3) : bool :=
  let '(j, i, d) := p in
  match entry tm j, f with
  | Some t, [a; b] =>
    N.ltb i 3 && latb r d && free t (N.to_nat i) &&
    let '(x, y) := ends t (N.to_nat i) in ceqb2 a (moved2 d x) && ceqb2 b (moved2 d y)
  | _, _ => false
  end.
Definition all_marked2 (m : PositiveMap.t unit) (fs : list (N * ctri * nat)) : bool :=
  forallb (fun f => let '(k, _, i) := f in match PositiveMap.find (place k (N.of_nat i)) m with Some _ => true | None => false end) fs.
Definition sides_agree (k : tiling_claim) (w : tiling_witness) (ts : list ctri) (places : list (N * N * Z3)) : bool :=
  if is_region k then Nat.leb (rank k) 2 && forallb (forallb (fun q => N.ltb (fst q) (N.of_nat (length (w_vertices w))))) (w_boundary w) &&
    both (side_is (rank k) (tabulate ts)) (w_boundary w) places && all_marked2 (marked places) (open_sides ts)
  else match w_boundary w with [] => true | _ => false end.

Section Ring.
Variables (A : Type) (aadd asub amul : A -> A -> A) (aofZ : Z -> A) (alt ale : A -> A -> bool).
Variable part : Z -> A -> Z.
(** A number that is fit is an element of the ring. *)
Variables (fit : number -> bool) (inn : number -> A).
Notation zero := (Checker.zero A aofZ).
Definition vec3 (v : list number) : v3 A := match v with [x; y; z] => V3 A (inn x) (inn y) (inn z) | _ => V3 A zero zero zero end.
Definition vec2 (v : list number) : A * A := match v with [x; y] => (inn x, inn y) | _ => (zero, zero) end.
Definition triple (v : list number) : bool := match v with [x; y; z] => fit x && fit y && fit z | _ => false end.
Definition pair (v : list number) : bool := match v with [x; y] => fit x && fit y | _ => false end.
Definition gram3 (k : tiling_claim) : kgram A :=
  match gram_rows k with
  | [[g11; g12; g13]; [g22; g23]; [g33]] => KG A (inn g11) (inn g22) (inn g33) (inn g12) (inn g13) (inn g23)
  | _ => KG A zero zero zero zero zero zero
  end.
Definition gram2 (k : tiling_claim) : A * A * A :=
  match gram_rows k with [[g11; g12]; [g22]] => (inn g11, inn g22, inn g12) | _ => (zero, zero, zero) end.
Definition gram_shape (k : tiling_claim) : bool :=
  match dimension k, gram_rows k with
  | 3%nat, [[_; _; _]; [_; _]; [_]] | 2%nat, [[_; _]; [_]] => forallb (forallb fit) (gram_rows k)
  | _, _ => false
  end.
Definition statement_of (s : sentence) : list (cstatement A) :=
  match s with
  | FaceToFaceTiling => []
  | IsAcute => [CAcute A]
  | IsNonobtuse => [CNonobtuse A]
  | LargestAngle rel sg p q => [CLargestDihedralAngle A rel sg (inn p) q]
  | SmallestAngle rel sg p q => [CSmallestDihedralAngle A rel sg (inn p) q]
  | SquaredRatio rel p q => [CSquaredRadiusEdgeRatio A rel (inn p) q]
  | UncrossedPlane [c1; c2; c3] p q => [CUncrossed A (c1, c2, c3) p q part]
  | UncrossedPlane [c1; c2] p q => [CUncrossed A (c1, c2, 0) p q part]
  | UncrossedPlane _ _ _ => []
  | IsDelaunay => [CDelaunay A]
  | IsWeaklyDelaunay => [CWeaklyDelaunay A]
  | IsLocallyDelaunay | IsLocallyWeaklyDelaunay => []
  | IsNotDelaunay => [CNotDelaunay A]
  | IsTCP => [CTCP A]
  end.
Definition region_statement_of (s : sentence) : list (rstatement A) :=
  match s with
  | IsLocallyDelaunay => [CLocallyDelaunay A]
  | IsLocallyWeaklyDelaunay => [CLocallyWeaklyDelaunay A]
  | _ => map (Each A) (statement_of s)
  end.
Definition fit_sentence (d : nat) (regional : bool) (s : sentence) : bool :=
  match s with
  | LargestAngle _ _ p _ | SmallestAngle _ _ p _ | SquaredRatio _ p _ => fit p
  | UncrossedPlane c _ _ => Nat.eqb (length c) d
  | IsLocallyDelaunay | IsLocallyWeaklyDelaunay => regional
  | _ => true
  end.
Definition statements_of (k : tiling_claim) := flat_map statement_of (sentences k).
Definition region_statements_of (k : tiling_claim) := flat_map region_statement_of (sentences k).

Definition shape3 (k : tiling_claim) (w : tiling_witness) (ts : list ctet) (places : list (N * N * Z3)) : bool :=
  gram_shape k && forallb triple (w_vertices w) && forallb triple (scaled k w (rank k)) && Z.ltb 0 (w_denominator w) && denominators_agree k w &&
  facets_agree k w ts places && states_tiling k && forallb (fit_sentence 3 (is_region k)) (sentences k) &&
  both (same_row (N.of_nat (length (w_vertices w)))) (w_rows w) ts.
Definition data3 (k : tiling_claim) (w : tiling_witness) (ts : list ctet) : cert A :=
  faces_cert A aadd asub amul aofZ ale (w_denominator w) (map vec3 (w_vertices w)) ts (gram3 k) (rank k)
    (map vec3 (scaled k w (rank k))) (faces_of k).
Definition proved3 (k : tiling_claim) (w : tiling_witness) (ts : list ctet) (places : list (N * N * Z3)) : bool :=
  if shape3 k w ts places then
    if is_region k then check_region_with A aadd asub amul aofZ alt ale part (data3 k w ts) (region_statements_of k)
    else fast_check A aadd asub amul aofZ alt ale (data3 k w ts) (statements_of k)
  else false.

Definition shape2 (k : tiling_claim) (w : tiling_witness) (ts : list ctri) (places : list (N * N * Z3)) : bool :=
  gram_shape k && forallb pair (w_vertices w) && forallb pair (scaled k w (rank k)) && Z.ltb 0 (w_denominator w) && denominators_agree k w &&
  sides_agree k w ts places && states_tiling k && forallb (fit_sentence 2 (is_region k)) (sentences k) &&
  both (same_triangle (N.of_nat (length (w_vertices w)))) (w_rows w) ts.
Definition data2 (k : tiling_claim) (w : tiling_witness) (ts : list ctri) : cert2 A :=
  Cert2 A (w_denominator w) (map vec2 (w_vertices w)) ts (gram2 k) (rank k) (map vec2 (scaled k w (rank k))) (faces_of k).
Definition proved2 (k : tiling_claim) (w : tiling_witness) (ts : list ctri) (places : list (N * N * Z3)) : bool :=
  if shape2 k w ts places then
    if is_region k then check_region2_with A aadd asub amul aofZ alt ale part (data2 k w ts) (region_statements_of k)
    else check2 A aadd asub amul aofZ alt ale (data2 k w ts) (statements_of k)
  else false.

(** About how many cells the grid of a region has: a bound on the work. *)
Definition grid_cells (k : tiling_claim) (w : tiling_witness) : Z :=
  let place v := match dimension k with 3%nat => vec3 v | _ => let p := vec2 v in V3 A (fst p) (snd p) zero end in
  let at_ := fast_pos A aadd aofZ (w_denominator w) (tabulate (fast_map place (w_vertices w))) in
  let es := fast_map (fun r => extents A part (map at_ (row_corners r))) (w_rows w) in
  all_cells (units_of (rank k) (w_denominator w) es) es.

(** The polytope is as the format demands. *)
Definition proper_polytope (k : tiling_claim) (w : tiling_witness) : bool :=
  match polytope_of (region_of k) with
  | Some _ =>
    let z := (3 - (dimension k - rank k))%nat in
    as_the_format_says A aadd asub amul aofZ alt ale (w_denominator w) z (map vec3 (scaled k w z)) (faces_of k)
  | None => true
  end.
Definition proved (k : tiling_claim) (w : tiling_witness) : bool :=
  let rows := fast_map row_corners (w_rows w) in let boundary := fast_map (map corner3) (w_boundary w) in
  match dimension k with
  | 3%nat => let (ts, places) := tetrahedra boundary rows in proved3 k w ts places
  | 2%nat => let (ts, places) := triangles boundary rows in proved2 k w ts places
  | _ => false
  end.
End Ring.
