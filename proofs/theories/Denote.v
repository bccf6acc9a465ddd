(** * What a certificate is, and what its claim says

    This file is read after Statement.v and PlaneStatement.v, for regions also
    RegionStatement.v and PlaneRegionStatement.v, and for systems of patches MosaicStatement.v.
    It contains definitions and no proof.
    It says what a certificate of format 2 is (docs/format.md), which bytes it is, and what
    its claim means, in the words of those files.  Bytes.v has the theorem:

      [accepts s = Some k -> exists c, s = print c /\ claim_of c = k /\ shows c /\ meaning k]

    The reader of the bytes s plays no part in it: whatever it makes of them is printed
    again and compared with s.  A few more notations: [N] are the numbers 0, 1, 2, … in
    binary; [l ++ m] is the list l followed by m, [map f l] the list of the values of f, [nth i l d]
    is the i-th member of l, or d if there is none.

    The theorem does not say that c and k are well formed.  The checker demands it
    (Format.v), but the definitions below give every term a meaning.  A missing vertex, and
    one with a wrong number of coordinates, is the origin.  x / 0 is some number, the square
    root of a negative number is 0, and arccos x is 0 for x > 1 and π for x < -1.  A polytope
    without vertices is an empty domain, which no simplices tile.  Rank 7 is like rank 3.
    Over the rational numbers a number of two coefficients depends on an arbitrary a.
    Two certificates may have the same bytes: the sixes of a row look like another corner.
    Where a family's box is empty, its claim says nothing; the checker demands low < high.
    The claim of a system of patches does not say that there is a mosaic. *)
From Coq Require Import Reals NArith ZArith List Permutation String.
From Coq Require Import Init.Byte.
From Coq Require Strings.Byte.
From Acutile Require Import Statement PlaneStatement RegionStatement PlaneRegionStatement MosaicStatement.
Import ListNotations.

(** ** Bytes: deterministic CBOR (RFC 8949, section 4.2.1)

    The certificate is its CBOR, and the kernel reads nothing else. *)
Definition bytes := list byte.
Inductive item := Int (z : Z) | Text (s : string) | Array (l : list item).

Section Encoding.
Local Open Scope N_scope.
Definition byte_of (n : N) : byte := match Strings.Byte.of_N n with Some b => b | None => x00 end.
(** The k bytes of n, the most significant one first. *)
Fixpoint big_endian (k : nat) (n : N) : bytes :=
  match k with O => [] | S k => big_endian k (n / 256) ++ [byte_of (n mod 256)] end.
(** A major type and its argument, in the shortest form. *)
Definition head (major n : N) : bytes :=
  let first x := byte_of (32 * major + x) in
  if n <? 24 then [first n]
  else if n <? 2 ^ 8 then first 24 :: big_endian 1 n
  else if n <? 2 ^ 16 then first 25 :: big_endian 2 n
  else if n <? 2 ^ 32 then first 26 :: big_endian 4 n
  else first 27 :: big_endian 8 n.
(** An integer that has no argument of 64 bits is a tagged byte string. *)
Definition integer (major tag n : N) : bytes :=
  if n <? 2 ^ 64 then head major n
  else let k := (N.size n + 7) / 8 in head 6 tag ++ head 2 k ++ big_endian (N.to_nat k) n.
Fixpoint encode (i : item) : bytes :=
  match i with
  | Int z => if Z.leb 0 z then integer 0 2 (Z.to_N z) else integer 1 3 (Z.to_N (-1 - z))
  | Text s => let l := list_byte_of_string s in head 3 (N.of_nat (List.length l)) ++ l
  | Array l => head 4 (N.of_nat (List.length l)) ++ flat_map encode l
  end.
End Encoding.

(** ** The abstract syntax *)

(** A number: its coefficients of 1, a, a^2, …; over the rational numbers just one.  In a family it
    is a polynomial: terms of a coefficient and the exponents of the parameters, in their order. *)
Inductive number := Plain (x : list Z) | Polynomial (l : list (list Z * list N)).
Inductive field := Rationals | Root (polynomial : list Z) (low high denominator : Z).
Record polytope := Polytope { p_denominator : Z; p_vertices : list (list number); p_faces : list (list N) }.
Inductive region := Space | Slab (P : polytope) | Prism (P : polytope) | Solid (P : polytope) | Region (rank : nat).
Inductive sentence :=
  | FaceToFaceTiling | IsAcute | IsNonobtuse
  | LargestAngle (rel : relation) (sign : Z) (p : number) (q : Z)
  | SmallestAngle (rel : relation) (sign : Z) (p : number) (q : Z)
  | SquaredRatio (rel : relation) (p : number) (q : Z)
  | UncrossedPlane (c : list Z) (p q : Z)
  | IsDelaunay | IsWeaklyDelaunay | IsLocallyDelaunay | IsLocallyWeaklyDelaunay | IsNotDelaunay | IsTCP.
Record tiling_claim := TilingClaim {
  dimension : nat; over : field; gram_rows : list (list number); region_of : region; sentences : list sentence }.
(** A corner: a vertex, and the shift, empty if it is zero. A row: its corners; its sixes if TCP is stated. *)
Definition corner := (N * list Z)%type.
Definition row := (list corner * option Z)%type.
Record tiling_witness := TilingWitness {
  w_denominator : Z; w_vertices : list (list number); w_boundary : list (list corner); w_rows : list row }.
(** A parameter of a family, and the ends of its interval: closed or open, numerator, denominator. *)
Record limit := Limit { is_closed : bool; numerator : list Z; divisor : Z }.
Record parameter := Range { p_name : string; p_low : limit; p_high : limit }.
(** How a family's box was cut, for the proof: not, or halved along the parameter with this number. *)
Inductive tree := Leaf | Halve (axis : N) (lower upper : tree).
(** A system of patches: polygons of the base (segments for rank 2) with the classes of their sides, and
    for each polygon a patch: offsets of its sides, points, pyramids (apex and rim), tetrahedra. *)
Record polygon := Polygon { t_denominator : Z; t_vertices : list (list number); t_classes : list Z }.
Record patches_claim := PatchesClaim {
  base_field : field; base_gram : list (list number); fibre_rank : nat; polygons : list polygon; patch_sentences : list sentence }.
Record patch_witness := PatchWitness {
  q_denominator : Z; q_offsets : list (list number); q_vertices : list (list number);
  q_pyramids : list (corner * list corner); q_simplices : list (list corner) }.
Inductive claim := OfTiling (k : tiling_claim) | OfFamily (ps : list parameter) (k : tiling_claim) | OfPatches (k : patches_claim).
Inductive certificate :=
  | Tiling (k : tiling_claim) (w : tiling_witness)
  | Family (ps : list parameter) (k : tiling_claim) (t : tree) (w : tiling_witness)
  | Patches (k : patches_claim) (ws : list patch_witness).
Definition claim_of (c : certificate) : claim :=
  match c with Tiling k _ => OfTiling k | Family ps k _ _ => OfFamily ps k | Patches k _ => OfPatches k end.

(** ** Printing: the arrays of docs/format.md *)
Local Open Scope string_scope.
Definition index_item (n : N) : item := Int (Z.of_N n).
Definition coefficients_item (f : field) (x : list Z) : item :=
  match f, x with Rationals, [z] => Int z | _, _ => Array (map Int x) end.
Definition number_item (f : field) (x : number) : item :=
  match x with
  | Plain x => coefficients_item f x
  | Polynomial l => Array (map (fun t => Array (coefficients_item f (fst t) :: map index_item (snd t))) l)
  end.
Definition field_item (f : field) : item :=
  match f with
  | Rationals => Text "Q"
  | Root p lo hi d => Array [Array (map Int p); Array [Int lo; Int hi; Int d]]
  end.
Definition points_item (f : field) (l : list (list number)) : item := Array (map (fun v => Array (map (number_item f) v)) l).
Definition polytope_item (f : field) (P : polytope) : item :=
  Array [Int (p_denominator P); points_item f (p_vertices P); Array (map (fun l => Array (map index_item l)) (p_faces P))].
Definition region_item (f : field) (d : region) : item :=
  match d with
  | Space => Text "space"
  | Slab P => Array [Text "slab"; polytope_item f P]
  | Prism P => Array [Text "prism"; polytope_item f P]
  | Solid P => Array [Text "solid"; polytope_item f P]
  | Region r => Array [Text "region"; Int (Z.of_nat r)]
  end.
Definition relation_word (r : relation) : string :=
  match r with
  | LessThan => "less than" | AtMost => "at most" | Maximum => "maximum"
  | MoreThan => "more than" | AtLeast => "at least" | Minimum => "minimum"
  end.
Definition sentence_item (f : field) (s : sentence) : item :=
  let fraction p q := Array [number_item f p; Int q] in
  match s with
  | FaceToFaceTiling => Text "face-to-face tiling"
  | IsAcute => Text "acute"
  | IsNonobtuse => Text "nonobtuse"
  | LargestAngle rel sg p q => Array [Text "largest dihedral angle"; Text (relation_word rel); Int sg; fraction p q]
  | SmallestAngle rel sg p q => Array [Text "smallest dihedral angle"; Text (relation_word rel); Int sg; fraction p q]
  | SquaredRatio rel p q => Array [Text "squared radius-edge ratio"; Text (relation_word rel); fraction p q]
  | UncrossedPlane c p q => Array [Text "uncrossed plane"; Array (map Int c); Array [Int p; Int q]]
  | IsDelaunay => Text "Delaunay"
  | IsWeaklyDelaunay => Text "weakly Delaunay"
  | IsLocallyDelaunay => Text "locally Delaunay"
  | IsLocallyWeaklyDelaunay => Text "locally weakly Delaunay"
  | IsNotDelaunay => Text "not Delaunay"
  | IsTCP => Text "TCP"
  end.
Definition claim_items (k : tiling_claim) (parameters : list item) : item :=
  let f := over k in
  Array (Int (Z.of_nat (dimension k)) :: field_item f :: parameters ++ [points_item f (gram_rows k); region_item f (region_of k);
         Array (map (sentence_item f) (sentences k))]).
Definition claim_item (k : tiling_claim) : item := claim_items k [].
Definition limit_item (f : field) (e : limit) : item :=
  Array [Text (if is_closed e then "closed" else "open"); Array [coefficients_item f (numerator e); Int (divisor e)]].
Definition parameter_item (f : field) (p : parameter) : item :=
  Array [Text (p_name p); limit_item f (p_low p); limit_item f (p_high p)].
Fixpoint tree_item (t : tree) : item :=
  match t with Leaf => Array [] | Halve a l u => Array [index_item a; tree_item l; tree_item u] end.
Definition corner_item (c : corner) : item :=
  match snd c with [] => index_item (fst c) | s => Array (index_item (fst c) :: map Int s) end.
Definition row_item (r : row) : item :=
  Array (map corner_item (fst r) ++ match snd r with None => [] | Some sixes => [Int sixes] end).
Definition witness_items (f : field) (w : tiling_witness) (tree : list item) : item :=
  Array (Int (w_denominator w) :: points_item f (w_vertices w) ::
         Array (map (fun b => Array (map corner_item b)) (w_boundary w)) :: tree ++ [Array (map row_item (w_rows w))]).
Definition witness_item (f : field) (w : tiling_witness) : item := witness_items f w [].
Definition polygon_item (f : field) (T : polygon) : item :=
  Array [Int (t_denominator T); points_item f (t_vertices T); Array (map Int (t_classes T))].
Definition patches_claim_item (k : patches_claim) : item :=
  let f := base_field k in
  Array [field_item f; points_item f (base_gram k); Int (Z.of_nat (fibre_rank k)); Array (map (polygon_item f) (polygons k));
         Array (map (sentence_item f) (patch_sentences k))].
Definition patch_item (f : field) (w : patch_witness) : item :=
  Array [Int (q_denominator w); points_item f (q_offsets w); points_item f (q_vertices w);
         Array (map (fun y => Array [corner_item (fst y); Array (map corner_item (snd y))]) (q_pyramids w));
         Array (map (fun t => Array (map corner_item t)) (q_simplices w))].
Definition certificate_item (c : certificate) : item :=
  match c with
  | Tiling k w => Array [Text "acutile-certificate"; Int 2; Text "tiling"; claim_item k; witness_item (over k) w]
  | Family ps k t w => Array [Text "acutile-certificate"; Int 2; Text "family";
      claim_items k [Array (map (parameter_item (over k)) ps)]; witness_items (over k) w [tree_item t]]
  | Patches k ws => Array [Text "acutile-certificate"; Int 2; Text "patches";
      patches_claim_item k; Array (map (patch_item (base_field k)) ws)]
  end.
Definition print (c : certificate) : bytes := encode (certificate_item c).
Local Close Scope string_scope.

(** ** Meaning: numbers *)
Local Open Scope R_scope.
Section Value.
Variable a : R.
Fixpoint at_root (x : list Z) : R := match x with [] => 0 | c :: x => IZR c + a * at_root x end.
End Value.
(** Where numbers are evaluated: at a, and at the values of the parameters of a family.  A tiling
    has no parameters. *)
Definition valuation := (R * list R)%type.
Fixpoint power_product (t : list R) (exponents : list N) : R :=
  match t, exponents with x :: t, e :: es => x ^ N.to_nat e * power_product t es | _, _ => 1 end.
Definition value (a : valuation) (x : number) : R :=
  match x with
  | Plain x => at_root (fst a) x
  | Polynomial l => fold_right (fun c s => at_root (fst a) (fst c) * power_product (snd a) (snd c) + s) 0 l
  end.
(** a is the number that the field is about: the only root of the polynomial in the interval.
    Over the rational numbers it plays no part. *)
Definition the_root (f : field) (a : R) : Prop :=
  match f with
  | Rationals => True
  | Root p lo hi d =>
    let between x := IZR lo / IZR d <= x <= IZR hi / IZR d in
    at_root a p = 0 /\ between a /\ forall x, at_root x p = 0 -> between x -> x = a
  end.
(** The box of a family: t has one value for each parameter, and each is in its interval. *)
Definition limit_value (a : R) (e : limit) : R := at_root a (numerator e) / IZR (divisor e).
Definition in_range (a : R) (p : parameter) (t : R) : Prop :=
  (if is_closed (p_low p) then limit_value a (p_low p) <= t else limit_value a (p_low p) < t) /\
  (if is_closed (p_high p) then t <= limit_value a (p_high p) else t < limit_value a (p_high p)).
Definition in_box (a : R) (ps : list parameter) (t : list R) : Prop := Forall2 (in_range a) ps t.

(** ** Meaning: the claim about a list of simplices

    A simplex is the list of its corners, a corner the list of its D coordinates in the
    basis l1, …, lD. *)
Definition simplex := list (list R).
Definition as_point (x : list R) : point := match x with [x; y; z] => Point x y z | _ => origin end.
Definition as_point2 (x : list R) : point2 := match x with [x; y] => Point2 x y | _ => origin2 end.
Definition as_tetrahedron (l1 l2 l3 : point) (t : simplex) : tetrahedron :=
  match map (fun x => at_coordinates l1 l2 l3 (as_point x)) t with
  | [p; q; r; s] => Tetrahedron p q r s
  | _ => Tetrahedron origin origin origin origin
  end.
Definition as_triangle (l1 l2 : point2) (t : simplex) : triangle2 :=
  match map (fun x => at_coordinates2 l1 l2 (as_point2 x)) t with
  | [p; q; r] => Triangle2 p q r
  | _ => Triangle2 origin2 origin2 origin2
  end.

Definition polytope_of (d : region) : option polytope :=
  match d with Slab P | Prism P | Solid P => Some P | Space | Region _ => None end.
Definition rank (k : tiling_claim) : nat :=
  match region_of k with Space => dimension k | Slab _ => dimension k - 1 | Prism _ => 1 | Solid _ => 0 | Region r => r end.

Section Claim.
Variables (k : tiling_claim) (a : valuation).
(** The upper triangle, by rows. *)
Definition gram_of : gram :=
  match gram_rows k with
  | [[g11; g12; g13]; [g22; g23]; [g33]] =>
    Gram (value a g11) (value a g22) (value a g33) (value a g12) (value a g13) (value a g23)
  | _ => Gram 0 0 0 0 0 0
  end.
Definition gram2_of : gram2 :=
  match gram_rows k with
  | [[g11; g12]; [g22]] => Gram2 (value a g11) (value a g22) (value a g12)
  | _ => Gram2 0 0 0
  end.
(** The vertices of the polytope, with zeros in front, in the directions of the lattice. *)
Definition polytope_points : list (list R) :=
  match polytope_of (region_of k) with
  | Some P => map (fun v => repeat 0 (rank k) ++ map (fun x => value a x / IZR (p_denominator P)) v) (p_vertices P)
  | None => []
  end.
(** The angle with the sign and the square p/q of its cosine. *)
Definition angle_bound (sign : Z) (p : number) (q : Z) : R := acos (IZR sign * sqrt (value a p / IZR q)).

(** The sentence holds for the simplices T 0, …, T (n - 1) and their lattice translates. A region is
    their union, and [listed] are its boundary facets: (j, i) is the facet of T j opposite to its
    corner i, with i = 0, 1, … For other domains [listed] plays no part. *)
Variables (n : nat) (T : nat -> simplex) (listed : list (nat * nat)).
Definition space_sentence (l1 l2 l3 : point) (s : sentence) : Prop :=
  let r := rank k in let P := fun j => as_tetrahedron l1 l2 l3 (T j) in
  match s with
  | FaceToFaceTiling =>
    match region_of k with
    | Region _ => face_to_face_region l1 l2 l3 r n P listed
    | _ => face_to_face_tiling l1 l2 l3 r (domain l1 l2 l3 r (map as_point polytope_points)) n P
    end
  | IsAcute => acute l1 l2 l3 r n P
  | IsNonobtuse => nonobtuse l1 l2 l3 r n P
  | LargestAngle rel sg p q => largest_dihedral_angle l1 l2 l3 r n P rel (angle_bound sg p q)
  | SmallestAngle rel sg p q => smallest_dihedral_angle l1 l2 l3 r n P rel (angle_bound sg p q)
  | SquaredRatio rel p q => squared_radius_edge_ratio l1 l2 l3 r n P rel (value a p / IZR q)
  | UncrossedPlane c p q => match c with [c1; c2; c3] => uncrossed l1 l2 l3 r n P (c1, c2, c3) (IZR p / IZR q) | _ => False end
  | IsDelaunay => delaunay l1 l2 l3 r n P
  | IsWeaklyDelaunay => weakly_delaunay l1 l2 l3 r n P
  | IsLocallyDelaunay => locally_delaunay l1 l2 l3 r n P
  | IsLocallyWeaklyDelaunay => locally_weakly_delaunay l1 l2 l3 r n P
  | IsNotDelaunay => not_delaunay l1 l2 l3 r n P
  | IsTCP => tcp l1 l2 l3 r n P
  end.
Definition plane_sentence (l1 l2 : point2) (s : sentence) : Prop :=
  let r := rank k in let P := fun j => as_triangle l1 l2 (T j) in
  match s with
  | FaceToFaceTiling =>
    match region_of k with
    | Region _ => edge_to_edge_region l1 l2 r n P listed
    | _ => edge_to_edge_tiling l1 l2 r (domain2 l1 l2 r (map as_point2 polytope_points)) n P
    end
  | IsAcute => acute2 l1 l2 r n P
  | IsNonobtuse => nonobtuse2 l1 l2 r n P
  | LargestAngle rel sg p q => largest_angle2 l1 l2 r n P rel (angle_bound sg p q)
  | SmallestAngle rel sg p q => smallest_angle2 l1 l2 r n P rel (angle_bound sg p q)
  | SquaredRatio rel p q => squared_radius_edge_ratio2 l1 l2 r n P rel (value a p / IZR q)
  | UncrossedPlane c p q => match c with [c1; c2] => uncrossed2 l1 l2 r n P (c1, c2) (IZR p / IZR q) | _ => False end
  | IsDelaunay => delaunay2 l1 l2 r n P
  | IsWeaklyDelaunay => weakly_delaunay2 l1 l2 r n P
  | IsLocallyDelaunay => locally_delaunay2 l1 l2 r n P
  | IsLocallyWeaklyDelaunay => locally_weakly_delaunay2 l1 l2 r n P
  | IsNotDelaunay => not_delaunay2 l1 l2 r n P
  | IsTCP => False
  end.
(** There are bases with the Gram matrix, and for all of them every sentence holds. Any two of them
    differ by a congruence. *)
Definition holds_of : Prop :=
  In FaceToFaceTiling (sentences k) /\
  match dimension k with
  | 3%nat => (exists l1 l2 l3, has_gram gram_of l1 l2 l3) /\
         forall l1 l2 l3, has_gram gram_of l1 l2 l3 -> forall s, In s (sentences k) -> space_sentence l1 l2 l3 s
  | 2%nat => (exists l1 l2, has_gram2 gram2_of l1 l2) /\
         forall l1 l2, has_gram2 gram2_of l1 l2 -> forall s, In s (sentences k) -> plane_sentence l1 l2 s
  | _ => False
  end.
End Claim.

(** ** Meaning: systems of patches *)

(** Coordinates, moved by a shift. *)
Fixpoint moved (x : list R) (shift : list Z) : list R :=
  match x, shift with
  | x :: xs, s :: shift => (x + IZR s) :: moved xs shift
  | _, _ => x
  end.
Definition as_tiling (k : patches_claim) : tiling_claim := TilingClaim 3 (base_field k) (base_gram k) Space (patch_sentences k).
Section Patches.
Variable a : valuation.
(** The coordinates x, over the denominator d. *)
Definition over_denominator (d : Z) (x : list number) : list R := map (fun c => value a c / IZR d) x.
Definition patch_point (w : patch_witness) (c : corner) : point :=
  as_point (moved (over_denominator (q_denominator w) (nth (N.to_nat (fst c)) (q_vertices w) [])) (snd c)).
Definition patch_tetrahedron (w : patch_witness) (t : list corner) : tetrahedron :=
  match map (patch_point w) t with [p; q; r; s] => Tetrahedron p q r s | _ => Tetrahedron origin origin origin origin end.
(** A side begins over a vertex of the polygon; its offset comes first. *)
Definition patch_edges (T : polygon) (w : patch_witness) : list edge :=
  map (fun e => let '(o, v, c) := e in
      Edge c (as_point (over_denominator (q_denominator w) o ++ over_denominator (t_denominator T) v)))
    (combine (combine (q_offsets w) (t_vertices T)) (t_classes T)).
Definition real_patch (Tw : polygon * patch_witness) : patch := let '(T, w) := Tw in
  Patch (patch_edges T w) (map (fun y => Pyramid (patch_point w (fst y)) (map (patch_point w) (snd y))) (q_pyramids w))
    (map (patch_tetrahedron w) (q_simplices w)).
Variables (k : patches_claim) (ws : list patch_witness).
Definition system_of : list patch := map real_patch (combine (polygons k) ws).
Definition patches_sentence (l1 l2 l3 : point) (s : sentence) : Prop :=
  let G := gram_of (as_tiling k) a in let r := fibre_rank k in
  let all := over_all l1 l2 l3 G r system_of in let bounded := bounded_over_all l1 l2 l3 G r system_of in
  match s with
  | FaceToFaceTiling => all tiles_space
  | IsAcute => all acute_cells
  | IsNonobtuse => all nonobtuse_cells
  | LargestAngle rel sg p q => bounded largest_angle rel (angle_bound a sg p q)
  | SmallestAngle rel sg p q => bounded smallest_angle rel (angle_bound a sg p q)
  | SquaredRatio rel p q => bounded squared_ratio rel (value a p / IZR q)
  | IsDelaunay => all delaunay_cells
  | IsWeaklyDelaunay => all weakly_delaunay_cells
  | IsTCP => all tcp_cells
  (* the checker accepts no other sentence *)
  | UncrossedPlane _ _ _ | IsLocallyDelaunay | IsLocallyWeaklyDelaunay | IsNotDelaunay => False
  end.
(** There is a patch for each polygon.  There are positive bases with the Gram matrix; and for all of
    them the patches can be raised over every mosaic, and the sentences hold.  (For the other bases
    read everything in a mirror.) *)
Definition holds_over_mosaics : Prop :=
  let G := gram_of (as_tiling k) a in let r := fibre_rank k in
  List.length ws = List.length (polygons k) /\ In FaceToFaceTiling (patch_sentences k) /\
  (exists l1 l2 l3, has_gram G l1 l2 l3 /\ 0 < det l1 l2 l3) /\
  forall l1 l2 l3, has_gram G l1 l2 l3 -> 0 < det l1 l2 l3 ->
    heights_exist l1 l2 l3 G r system_of /\ forall s, In s (patch_sentences k) -> patches_sentence l1 l2 l3 s.
End Patches.

(** ** Meaning: the claim alone, and the certificate

    The claim says that there are such simplices, and boundary facets of a region; that of a
    family says it for every point of the box. The certificate shows which ones.  The claim about a region says very little by itself,
    because any region of this rank is one: read [shows] for the region of the certificate. *)
Definition meaning (k : claim) : Prop :=
  match k with
  | OfTiling k => exists a, the_root (over k) a /\ exists n T listed, holds_of k (a, []) n T listed
  | OfFamily ps k => exists a, the_root (over k) a /\
      forall t, in_box a ps t -> exists n T listed, holds_of k (a, t) n T listed
  | OfPatches k => exists a, the_root (base_field k) a /\ exists ws, holds_over_mosaics (a, []) k ws
  end.

(** The coordinates of a corner: those of its vertex, moved by the shift. *)
Definition coordinates (a : valuation) (w : tiling_witness) (c : corner) : list R :=
  moved (map (fun x => value a x / IZR (w_denominator w)) (nth (N.to_nat (fst c)) (w_vertices w) [])) (snd c).
(** T j has the corners of row j, in some order. *)
Definition are_rows (a : valuation) (w : tiling_witness) (n : nat) (T : nat -> simplex) : Prop :=
  n = List.length (w_rows w) /\
  forall j r, nth_error (w_rows w) j = Some r -> Permutation (T j) (map (coordinates a w) (fst r)).
(** The corners of a simplex but its i-th one. *)
Fixpoint but (i : nat) (t : simplex) : simplex :=
  match t, i with [], _ => [] | _ :: t, O => t | x :: t, S i => x :: but i t end.
(** The m-th listed facet (j, i) has the corners of the m-th facet of the certificate's boundary, in
    some order and all moved by one lattice vector, which has the coordinates s. *)
Definition are_facets (a : valuation) (w : tiling_witness) (rank : nat) (T : nat -> simplex) (listed : list (nat * nat)) : Prop :=
  List.length listed = List.length (w_boundary w) /\
  forall m f, nth_error (w_boundary w) m = Some f -> exists j i s, nth_error listed m = Some (j, i) /\
    List.length s = rank /\ Permutation (but i (T j)) (map (fun c => moved (coordinates a w c) s) f).
(** What the certificate shows: its own simplices and facets have the claimed properties. *)
Definition shows (c : certificate) : Prop :=
  match c with
  | Tiling k w => exists a, the_root (over k) a /\ exists n T listed,
      are_rows (a, []) w n T /\ are_facets (a, []) w (rank k) T listed /\ holds_of k (a, []) n T listed
  | Family ps k _ w => exists a, the_root (over k) a /\ forall t, in_box a ps t -> exists n T listed,
      are_rows (a, t) w n T /\ are_facets (a, t) w (rank k) T listed /\ holds_of k (a, t) n T listed
  | Patches k ws => exists a, the_root (base_field k) a /\ holds_over_mosaics (a, []) k ws
  end.
