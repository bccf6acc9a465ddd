(** * Reading a certificate

    No theorem is about this file.  The bytes are read by a machine that takes them one by
    one, so that neither a long nor a deep certificate needs a deep recursion.  The
    certificate that comes out is printed and compared with the bytes (Bytes.v): a mistake
    here can refuse a certificate, and accept none. *)
From Coq Require Import NArith ZArith List String.
From Coq Require Import Init.Byte.
From Coq Require Strings.Byte.
From Acutile Require Import Statement Denote.
Import ListNotations.
Local Open Scope N_scope.

(** ** Bytes to items *)

(** The next byte begins an item, belongs to an argument, a text or a long integer. [tag] is the
    sign that a tag has announced, [more] counts the bytes that are missing. *)
Inductive mode :=
  | Start (tag : option bool)
  | Argument (tag : option bool) (major : N) (more : nat) (n : N)
  | Letters (more : N) (reversed : bytes)
  | Digits (negative : bool) (more : N) (n : N).
(** The open arrays: the number of items that are missing, and those read, in reverse. *)
Definition stack := list (N * list item).
Inductive state := Reading (m : mode) (st : stack) | Complete (i : item) | Broken | TooLong.

Fixpoint push (i : item) (st : stack) : state :=
  match st with
  | [] => Complete i
  | (n, l) :: st => if n =? 1 then push (Array (rev_append l [i])) st else Reading (Start None) ((n - 1, i :: l) :: st)
  end.
Definition longest_text := 64.
Definition longest_integer := 416.   (* bytes: 1000 decimal digits *)
Definition finish (tag : option bool) (major n : N) (st : stack) : state :=
  match tag, major with
  | None, 0 => push (Int (Z.of_N n)) st
  | None, 1 => push (Int (-1 - Z.of_N n)) st
  | None, 3 => if n =? 0 then push (Text EmptyString) st else if longest_text <? n then Broken else Reading (Letters n []) st
  | None, 4 => if n =? 0 then push (Array []) st else Reading (Start None) ((n, []) :: st)
  | None, 6 => match n with 2 => Reading (Start (Some false)) st | 3 => Reading (Start (Some true)) st | _ => Broken end
  | Some negative, 2 => if n =? 0 then Broken else if longest_integer <? n then TooLong else Reading (Digits negative n 0) st
  | _, _ => Broken
  end.
Definition step (s : state) (b : byte) : state :=
  match s with
  | Reading (Start tag) st =>
    let n := Byte.to_N b in let major := N.shiftr n 5 in let low := N.land n 31 in
    if low <? 24 then finish tag major low st else
    match low with
    | 24 => Reading (Argument tag major 1 0) st
    | 25 => Reading (Argument tag major 2 0) st
    | 26 => Reading (Argument tag major 4 0) st
    | 27 => Reading (Argument tag major 8 0) st
    | _ => Broken
    end
  | Reading (Argument tag major more n) st =>
    let n := 256 * n + Byte.to_N b in
    match more with S (S more) => Reading (Argument tag major (S more) n) st | _ => finish tag major n st end
  | Reading (Letters more l) st =>
    if more =? 1 then push (Text (string_of_list_byte (rev_append l [b]))) st else Reading (Letters (more - 1) (b :: l)) st
  | Reading (Digits negative more n) st =>
    let n := 256 * n + Byte.to_N b in
    if more =? 1 then push (Int (if negative then -1 - Z.of_N n else Z.of_N n)%Z) st else Reading (Digits negative (more - 1) n) st
  | Complete _ => Broken
  | Broken => Broken
  | TooLong => TooLong
  end.
Definition items (s : bytes) : state := fold_left step s (Reading (Start None) []).

(** ** Items to certificates *)
Fixpoint all_of {X Y} (f : X -> option Y) (l : list X) (reversed : list Y) : option (list Y) :=
  match l with
  | [] => Some (rev_append reversed [])
  | x :: l => match f x with Some y => all_of f l (y :: reversed) | None => None end
  end.
Definition array {Y} (f : item -> option Y) (i : item) : option (list Y) :=
  match i with Array l => all_of f l [] | _ => None end.
Definition whole (i : item) : option Z := match i with Int z => Some z | _ => None end.
Definition index (i : item) : option N := match i with Int z => if Z.leb 0 z then Some (Z.to_N z) else None | _ => None end.
Definition bind {X Y} (o : option X) (f : X -> option Y) : option Y := match o with Some x => f x | None => None end.
Notation "'let*' x := e 'in' f" := (bind e (fun x => f)) (at level 200, x name, e at level 100, f at level 200).

Definition read_coefficients (f : field) (i : item) : option (list Z) :=
  match f, i with
  | Rationals, Int z => Some [z]
  | Root _ _ _ _, Array l => all_of whole l []
  | _, _ => None
  end.
Definition read_number (f : field) (i : item) : option number := let* x := read_coefficients f i in Some (Plain x).
Definition read_term (f : field) (i : item) : option (list Z * list N) :=
  match i with Array (c :: e) => let* c := read_coefficients f c in let* e := all_of index e [] in Some (c, e) | _ => None end.
(** With parameters: a list of terms. *)
Definition read_value (polynomials : bool) (f : field) (i : item) : option number :=
  if polynomials then let* l := array (read_term f) i in Some (Polynomial l) else read_number f i.
Definition read_points (b : bool) (f : field) : item -> option (list (list number)) := array (array (read_value b f)).
Local Open Scope string_scope.
Definition read_field (i : item) : option field :=
  match i with
  | Text "Q" => Some Rationals
  | Array [p; Array [Int lo; Int hi; Int d]] => let* p := array whole p in Some (Root p lo hi d)
  | _ => None
  end.
Definition read_polytope (b : bool) (f : field) (i : item) : option polytope :=
  match i with
  | Array [Int d; vertices; faces] =>
    let* vertices := read_points b f vertices in let* faces := array (array index) faces in Some (Polytope d vertices faces)
  | _ => None
  end.
Definition read_region (b : bool) (f : field) (i : item) : option region :=
  match i with
  | Text "space" => Some Space
  | Array [Text "slab"; P] => let* P := read_polytope b f P in Some (Slab P)
  | Array [Text "prism"; P] => let* P := read_polytope b f P in Some (Prism P)
  | Array [Text "solid"; P] => let* P := read_polytope b f P in Some (Solid P)
  | Array [Text "region"; Int r] => if Z.leb 0 r && Z.leb r 3 then Some (Region (Z.to_nat r)) else None
  | _ => None
  end%bool.
Definition read_relation (i : item) : option relation :=
  match i with
  | Text "less than" => Some LessThan
  | Text "at most" => Some AtMost
  | Text "maximum" => Some Maximum
  | Text "more than" => Some MoreThan
  | Text "at least" => Some AtLeast
  | Text "minimum" => Some Minimum
  | _ => None
  end.
Definition read_sentence (f : field) (i : item) : option sentence :=
  match i with
  | Text "face-to-face tiling" => Some FaceToFaceTiling
  | Text "acute" => Some IsAcute
  | Text "nonobtuse" => Some IsNonobtuse
  | Array [Text "largest dihedral angle"; rel; Int sg; Array [p; Int q]] =>
    let* rel := read_relation rel in let* p := read_number f p in Some (LargestAngle rel sg p q)
  | Array [Text "smallest dihedral angle"; rel; Int sg; Array [p; Int q]] =>
    let* rel := read_relation rel in let* p := read_number f p in Some (SmallestAngle rel sg p q)
  | Array [Text "squared radius-edge ratio"; rel; Array [p; Int q]] =>
    let* rel := read_relation rel in let* p := read_number f p in Some (SquaredRatio rel p q)
  | Array [Text "uncrossed plane"; c; Array [Int p; Int q]] => let* c := array whole c in Some (UncrossedPlane c p q)
  | Text "Delaunay" => Some IsDelaunay
  | Text "weakly Delaunay" => Some IsWeaklyDelaunay
  | Text "locally Delaunay" => Some IsLocallyDelaunay
  | Text "locally weakly Delaunay" => Some IsLocallyWeaklyDelaunay
  | Text "not Delaunay" => Some IsNotDelaunay
  | Text "TCP" => Some IsTCP
  | _ => None
  end.
Definition read_members (b : bool) (d : Z) (f : field) (gram region ss : item) : option tiling_claim :=
  let* gram := read_points b f gram in let* region := read_region b f region in
  let* ss := array (read_sentence f) ss in
  if Z.eqb d 2 then Some (TilingClaim 2 f gram region ss)
  else if Z.eqb d 3 then Some (TilingClaim 3 f gram region ss) else None.
Definition read_claim (i : item) : option tiling_claim :=
  match i with
  | Array [Int d; f; gram; region; ss] => let* f := read_field f in read_members false d f gram region ss
  | _ => None
  end.
Definition read_limit (f : field) (i : item) : option limit :=
  match i with
  | Array [Text kind; Array [x; Int d]] =>
    let* x := read_coefficients f x in
    if String.eqb kind "closed" then Some (Limit true x d) else if String.eqb kind "open" then Some (Limit false x d) else None
  | _ => None
  end.
Definition read_parameter (f : field) (i : item) : option parameter :=
  match i with
  | Array [Text name; lo; hi] => let* lo := read_limit f lo in let* hi := read_limit f hi in Some (Range name lo hi)
  | _ => None
  end.
Definition read_family_claim (i : item) : option (list parameter * tiling_claim) :=
  match i with
  | Array [Int d; f; ps; gram; region; ss] =>
    let* f := read_field f in let* ps := array (read_parameter f) ps in
    let* k := read_members true d f gram region ss in Some (ps, k)
  | _ => None
  end.
Fixpoint read_tree (i : item) : option tree :=
  match i with
  | Array [] => Some Leaf
  | Array [a; l; u] => let* a := index a in let* l := read_tree l in let* u := read_tree u in Some (Halve a l u)
  | _ => None
  end.
Definition read_corner (i : item) : option corner :=
  match i with
  | Int _ => let* v := index i in Some (v, [])
  | Array (v :: s) => let* v := index v in let* s := all_of whole s [] in Some (v, s)
  | _ => None
  end.
Definition read_row (d : nat) (i : item) : option row :=
  match i with
  | Array l =>
    let* corners := all_of read_corner (firstn (d + 1) l) [] in
    match skipn (d + 1) l with
    | [] => Some (corners, None)
    | [Int sixes] => Some (corners, Some sixes)
    | _ => None
    end
  | _ => None
  end.
Definition read_parts (b : bool) (k : tiling_claim) (d : Z) (vertices boundary rows : item) : option tiling_witness :=
  let* vertices := read_points b (over k) vertices in
  let* boundary := array (array read_corner) boundary in
  let* rows := array (read_row (dimension k)) rows in
  Some (TilingWitness d vertices boundary rows).
Definition read_tiling (k w : item) : option certificate :=
  let* k := read_claim k in
  match w with
  | Array [Int d; vertices; boundary; rows] => let* w := read_parts false k d vertices boundary rows in Some (Tiling k w)
  | _ => None
  end.
Definition read_family (k w : item) : option certificate :=
  let* k := read_family_claim k in
  match w with
  | Array [Int d; vertices; boundary; t; rows] =>
    let* t := read_tree t in let* w := read_parts true (snd k) d vertices boundary rows in Some (Family (fst k) (snd k) t w)
  | _ => None
  end.
Definition read_polygon (f : field) (i : item) : option polygon :=
  match i with
  | Array [Int d; vertices; classes] =>
    let* vertices := read_points false f vertices in let* classes := array whole classes in Some (Polygon d vertices classes)
  | _ => None
  end.
Definition read_patches_claim (i : item) : option patches_claim :=
  match i with
  | Array [f; gram; Int r; tiles; ss] =>
    let* f := read_field f in let* gram := read_points false f gram in let* tiles := array (read_polygon f) tiles in
    let* ss := array (read_sentence f) ss in
    if Z.eqb r 1 then Some (PatchesClaim f gram 1 tiles ss) else if Z.eqb r 2 then Some (PatchesClaim f gram 2 tiles ss) else None
  | _ => None
  end.
Definition read_pyramid (i : item) : option (corner * list corner) :=
  match i with Array [apex; rim] => let* apex := read_corner apex in let* rim := array read_corner rim in Some (apex, rim) | _ => None end.
Definition read_patch (f : field) (i : item) : option patch_witness :=
  match i with
  | Array [Int d; offsets; vertices; pyramids; rows] =>
    let* offsets := read_points false f offsets in let* vertices := read_points false f vertices in
    let* pyramids := array read_pyramid pyramids in let* rows := array (array read_corner) rows in
    Some (PatchWitness d offsets vertices pyramids rows)
  | _ => None
  end.
Definition read_patches (k w : item) : option certificate :=
  let* k := read_patches_claim k in let* ws := array (read_patch (base_field k)) w in Some (Patches k ws).
