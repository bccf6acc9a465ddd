(* acutile-coq-check CERTIFICATE...: the extracted checker on certificate files.

   Trusted, besides the extraction and the OCaml compiler: json.ml, numbers.ml and this
   file, which turn text into the data that the theorems speak of. The verdict is
   computed by extracted code alone.
   One line for each file. Exit code 0 if all are proved, else the first that occurs of
   1 (one is rejected), 2 (one is unreadable, or usage), 3 (one is declined). *)

open Checker
open Json
open Numbers

(* The claim: numbers, field, statements *)

let array = function Array l -> l | _ -> reject "expected an array"
let number degree v =
  let text = function String t -> rational t | _ -> reject "a number is not a string" in
  match v with
  | String t -> [rational t]
  | Array l ->
    let cs = List.map text l in
    let n = List.length cs in
    need (2 <= n && n <= degree) "the number of coefficients";
    need (not (Z.eqb (fst (List.nth cs (n - 1))) Z0)) "a last coefficient of zero";
    cs
  | _ -> reject "a number"
let rows degree length v =
  let row v = let l = List.map (number degree) (array v) in need (List.length l = length) "the length of a row"; l in
  List.map row (array v)

let statement = function
  | String "face-to-face tiling" -> (0, None)
  | String "acute" -> (1, Some Acute)
  | String "nonobtuse" -> (2, Some Nonobtuse)
  | Object ["all dihedral angles below", String t] -> let (p, q) = rational t in (3, Some (DihedralBelow (p, q)))
  | Object ["all dihedral angles above", String t] -> let (p, q) = rational t in (4, Some (DihedralAbove (p, q)))
  | Object ["all radius-edge ratios below", String t] -> let (p, q) = rational t in (5, Some (RadiusEdgeBelow (p, q)))
  | String "Delaunay" -> (6, Some Delaunay)
  | String "weakly Delaunay" -> (7, Some WeaklyDelaunay)
  | String "TCP" -> (8, Some TCP)
  | _ -> reject "an unknown statement"
let statements v =
  let l = List.map statement (array v) in
  let rec increasing = function a :: (b :: _ as r) -> fst a < fst b && increasing r | _ -> true in
  need (l <> [] && fst (List.hd l) = 0 && increasing l) "the order of the statements";
  List.filter_map snd l

let field = function
  | String "Q" -> None
  | Object ["Q(a)", Object ["polynomial", p; "root", Array [String lo; String hi]]] ->
    let text = function String t -> z_of_text t | _ -> reject "the polynomial" in
    let cs = List.map text (array p) in
    let n = List.length cs - 1 in
    need (n >= 2 && Z.eqb (List.nth cs n) one) "the polynomial is not monic of degree at least two";
    if n > 32 then raise (Declined "the degree");
    let fl = List.filteri (fun k _ -> k < n) cs in
    if String.length lo + String.length hi > 200 then raise (Declined "a root with long ends");
    let (p1, q1) = rational lo and (p2, q2) = rational hi in
    let lo = Z.mul p1 q2 and hi = Z.mul p2 q1 and s = Z.mul q1 q2 in
    need (Z.ltb lo hi) "the interval of the root";
    Some (fl, (lo, hi, s))
  | _ -> reject "the field"

(* The witness: corners and mates *)

let bound = 1 lsl 31
let int_of = function
  | Integer t when integer_text t && String.length t <= 11 ->
    let n = int_of_string t in
    need (abs n < bound) "an integer beyond 2^31"; n
  | _ -> reject "expected a small integer"
let index limit n = need (0 <= n && n < limit) "an index out of range"; n
(* The entries of a lattice vector of rank r, zeros filled in. *)
let shift r l =
  need (List.length l = r) "the length of a corner or a mate";
  let at k = if k < r then List.nth l k else 0 in
  (at 0, at 1, at 2)
let corner r used v =
  match List.map int_of (array v) with
  | i :: l -> let i = index (Array.length used) i in used.(i) <- true; (i, shift r l)
  | [] -> reject "an empty corner"
type mate = Behind of int * int * (int * int * int) | Face of int
let mate d r simplices faces v =
  match List.map int_of (array v) with
  | [f] when r < d -> Face (index faces f)
  | t :: j :: l -> Behind (index simplices t, index (d + 1) j, shift r l)
  | _ -> reject "the length of a mate"
let same_length l n what = need (List.length l = n) what; l

let z3 (x, y, z) = ((z_of_int x, z_of_int y), z_of_int z)
let z2 (x, y, _) = (z_of_int x, z_of_int y)

let tetrahedra corners mates =
  let place (v, s) = (n_of_int v, z3 s) in
  let behind = function Behind (t, j, s) -> Some ((n_of_int t, n_of_int j), z3 s) | Face _ -> None in
  let one cs ms = match List.map place cs, List.map behind ms with
    | [q0; q1; q2; q3], [m0; m1; m2; m3] -> { q0; q1; q2; q3; m0; m1; m2; m3 }
    | _ -> reject "a simplex" in
  List.map2 one corners mates

(* In the plane the corners stand in ascending order, and the mates follow them. *)
let order corners = List.sort (fun i j -> compare (List.nth corners i) (List.nth corners j)) [0; 1; 2]
let position corners i = let rec find k = function j :: l -> if i = j then k else find (k + 1) l | [] -> 0 in find 0 (order corners)
let triangles corners mates =
  let all = Array.of_list corners in
  let place (v, s) = (n_of_int v, z2 s) in
  let behind = function Behind (t, j, s) -> Some ((n_of_int t, n_of_int (position all.(t) j)), z2 s) | Face _ -> None in
  let one cs ms = match List.map (fun i -> (place (List.nth cs i), behind (List.nth ms i))) (order cs) with
    | [(p0, n0); (p1, n1); (p2, n2)] -> { p0; p1; p2; n0; n1; n2; even = List.mem (order cs) [[0; 1; 2]; [1; 2; 0]; [2; 0; 1]] }
    | _ -> reject "a simplex" in
  List.map2 one corners mates

(* Vectors of the ring: over Q the coefficient itself, over Q(a) all of them. *)
let v3 scalar = function [x; y; z] -> { vX = scalar x; vY = scalar y; vZ = scalar z } | _ -> reject "a vertex"
let in_front n row = List.init n (fun _ -> [Z0]) @ row

let domain d v =
  match v with
  | String "space" -> (d, None)
  | String "region" -> raise (Declined "a region: its soundness is proved on paper only")
  | Object [name, Object ["vertices", vertices; "faces", faces]] ->
    let k = match name with "slab" -> 1 | "prism" -> need (d = 3) "a prism in the plane"; 2 | "solid" -> d | _ -> reject "the domain" in
    (d - k, Some (vertices, List.map (fun f -> List.map int_of (array f)) (array faces)))
  | _ -> reject "the domain"

(* All of a certificate, over the ring in which [scalar] puts numbers *)

type 'a judge = {
  format : z -> nat -> 'a v3 list -> n list list -> (n * 'a v3 list) list -> bool;
  cert : z -> 'a v3 list -> ctet list -> z -> 'a kgram -> nat -> 'a v3 list -> n list list -> 'a cert;
  space : 'a cert -> statement list -> bool;
  plane : 'a cert2 -> statement list -> bool;
  scalar : z list -> 'a }

(* How many determinants the checks compute, about and at most, for t simplices, k = d - r, a polytope
   with w vertices. For a tile a hundred: signs, angles, spheres. For each of its corners half of the
   pieces, and the planes of the faces (in_piece, chk_inside). For two pieces of positive volume the
   planes of all of them, four each (chk_apart). Faces: each with all vertices, sides with sides. *)
let determinants k t w faces =
  let sum f = List.fold_left (fun n face -> n + f face) 0 faces in
  let n = List.length faces and sides = sum List.length in
  let pieces = match k with
    | 0 -> 6
    | 1 -> 6 * n
    | 2 -> 3 * n
    | _ -> sum (fun face -> if List.mem 0 face then 0 else max 0 (List.length face - 2)) in
  let cap x = min x 100_000 in
  let t = cap t and w = cap w and n = cap n and sides = cap sides and p = cap pieces in
  100 * t + 20 * t * (p + n) + 2 * p * p * p + n * w + sides * sides

let judged (type a) (j : a judge) d r gram vertices polytope faces corners mates ss =
  let k = d - r in
  let den = denominator [vertices; polytope] and gden = denominator [gram] in
  let v3 = v3 j.scalar in
  let vs = scaled den vertices and ws = scaled den polytope and g = scaled gden gram in
  let numbers = List.concat (List.concat [vs; ws; g]) in
  let words = 1 + List.fold_left (fun m c -> max m (bits_of c)) 0 (List.concat numbers) / 64 in
  let degree = List.fold_left (fun m c -> max m (List.length c)) 1 numbers in
  if determinants k (List.length corners) (List.length ws) faces > 100_000_000 / (degree * degree * words * words) then raise (Declined "the work");
  let e a b = j.scalar (List.nth (List.nth g a) b) in
  let faces = List.map (List.map n_of_int) faces in
  (* what the format demands of the domain *)
  let corner_of c = v3 (in_front (3 - d) (List.nth vs (fst c))) in
  let named = List.concat (List.map2 (fun cs ms ->
      List.concat (List.mapi (fun i m -> match m with
        | Face f -> [(n_of_int f, List.map corner_of (List.filteri (fun k _ -> k <> i) cs))]
        | Behind _ -> []) ms)) corners mates) in
  let padded = List.map (fun w -> v3 (in_front (3 - k) w)) ws in
  need (k = 0 || j.format den (nat_of_int (3 - k)) padded faces named) "the polytope, or a facet in its boundary";
  (* the theorem *)
  let rank = nat_of_int r in
  if d = 3 then
    let kgram = { k11 = e 0 0; k22 = e 1 1; k33 = e 2 2; k12 = e 0 1; k13 = e 0 2; k23 = e 1 2 } in
    need (j.space (j.cert den (List.map v3 vs) (tetrahedra corners mates) gden kgram rank padded faces) ss) "the checks"
  else
    let pair = function [x; y] -> (j.scalar x, j.scalar y) | _ -> reject "a vertex" in
    need (j.plane { e_den = den; e_verts = List.map pair vs; e_tris = triangles corners mates; e_gden = gden;
      e_gram = ((e 0 0, e 1 1), e 0 1); e_rank = rank; e_polytope = List.map (fun w -> pair (in_front (2 - k) w)) ws;
      e_faces = faces } ss) "the checks"

(* Over a field a check may fail because a sign is open: a value that is zero although its coefficients
   are not, over a reducible polynomial, or one too close to zero. Such a certificate is declined. The
   same functions run again, with comparisons that note it; what they answer is of no account. *)
let why_rejected fl e0 es by what =
  let is_open = ref false in
  let note x y = if not (lleb e0 es x y || lltb e0 es y x) then is_open := true in
  let less x y = note x y; lltb e0 es x y and at_most x y = note x y; lleb e0 es x y in
  (try by { format = as_the_format_says ladd lsub (lmul fl) lofZ less at_most;
            cert = faces_cert ladd lsub (lmul fl) lofZ at_most;
            space = Checker.check ladd lsub (lmul fl) lofZ less at_most;
            plane = check2 ladd lsub (lmul fl) lofZ less at_most; scalar = (fun x -> x) }
   with Rejected _ -> ());
  if !is_open then raise (Declined "a sign that 256 halvings of the root leave open") else reject what

let certificate v =
  match v with
  | Object ["format", String "acutile-certificate"; "version", Integer version; "claim", claim; "witness", witness] ->
    if version <> "1" then raise (Declined "the version");
    (match claim, witness with
     | Object ["dimension", d; "field", f; "gram", gram; "domain", dom; "statements", ss],
       Object ["vertices", vertices; "simplices", simplices; "mates", mates] ->
       let d = int_of d in
       need (d = 2 || d = 3) "the dimension";
       let ss = statements ss in
       let (r, polytope) = domain d dom in
       need (not (List.mem TCP ss) || (d = 3 && r = 3)) "TCP is stated of space only";
       let entry i j = List.nth (array (List.nth (array gram) i)) j in
       let symmetric g = List.iteri (fun i row -> List.iteri (fun j x -> if j < i then need (x = entry j i) "the Gram matrix is not symmetric") (array row)) (array g) in
       let field = field f in
       let degree = match field with None -> 1 | Some (fl, _) -> List.length fl in
       let g = rows degree d gram in
       need (List.length g = d) "the shape of the Gram matrix"; symmetric gram;
       let ws, faces = match polytope with None -> [], [] | Some (ws, faces) -> rows degree (d - r) ws, faces in
       List.iter (List.iter (fun i -> ignore (index (List.length ws) i))) faces;
       let vs = rows degree d vertices in
       let used = Array.make (List.length vs) false in
       let ss_json = array simplices and ms_json = array mates in
       let n = List.length ss_json in
       need (n > 0 && List.length ms_json = n) "the number of simplices or of rows of mates";
       let corners = List.map (fun s -> same_length (List.map (corner r used) (array s)) (d + 1) "the length of a simplex") ss_json in
       let mates = List.map (fun s -> same_length (List.map (mate d r n (List.length faces)) (array s)) (d + 1) "the length of a row of mates") ms_json in
       need (Array.for_all (fun u -> u) used) "an unused vertex";
       (match field with
        | None ->
          judged { format = format_rationals; cert = cert_rationals; space = check_rationals; plane = check_rationals2; scalar = List.hd }
            d r g vs ws faces corners mates ss
        | Some (fl, ((lo, hi, s) as interval)) ->
          let (e0, es) = enclosures fl interval in
          let i = { e_lo = lo; e_hi = hi; e_S = s } in
          let by j = judged j d r g vs ws faces corners mates ss in
          let proving = { format = format_field fl e0 es; cert = cert_field fl e0 es; space = check_field fl e0 es i; plane = check_field2 fl e0 es i; scalar = (fun x -> x) } in
          try by proving with Rejected what -> why_rejected fl e0 es by what)
     | _ -> reject "the members of the claim or of the witness")
  | Object (("format", String "acutile-certificate") :: ("version", Integer v) :: _) when v <> "1" -> raise (Declined "the version")
  | _ -> reject "not an acutile certificate"

let check path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  let v = parse text in
  need (canonical v = text) "not the canonical bytes";
  certificate v

let verdict path =
  match check path with
  | () -> (0, "proved")
  | exception Rejected what -> (1, "rejected: " ^ what)
  | exception Declined what -> (3, "declined: " ^ what)
  | exception Unreadable what -> (1, "rejected: " ^ what)
  | exception Sys_error what -> (2, what)
  | exception Stack_overflow -> (3, "declined: out of stack")

let () =
  match List.tl (Array.to_list Sys.argv) with
  | [] -> print_endline "usage: acutile-coq-check CERTIFICATE..."; exit 2
  | paths ->
    let codes = List.map (fun path -> let (code, what) = verdict path in Printf.printf "%s: %s\n%!" path what; code) paths in
    exit (match List.find_opt (fun c -> List.mem c codes) [1; 2; 3] with Some c -> c | None -> 0)
