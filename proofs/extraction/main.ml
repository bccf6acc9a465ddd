(* acutile-coq-check CERTIFICATE...: the extracted checker on certificates in JSON.

   Trusted, besides the extraction and the OCaml compiler: json.ml, numbers.ml and this
   file, which turn text into the data that the theorems speak of. The verdict is
   computed by extracted code alone.
   One line for each file. Exit code 0 if all are proved, else the first that occurs of
   1 (one is rejected), 2 (one is malformed or unreadable, or usage), 3 (one is declined). *)

open Checker
open Json
open Numbers

(* Numbers: an integer over Q, n coefficients over a field of degree n *)

let array = function Array l -> l | _ -> malformed "expected an array"
let number degree v =
  if degree = 1 then [integer v]
  else begin
    let cs = List.map integer (array v) in
    form (List.length cs = degree) "the number of coefficients";
    cs
  end
let row degree length v =
  let l = List.map (number degree) (array v) in
  form (List.length l = length) "the length of a row";
  l
let rows degree length v = List.map (row degree length) (array v)
let denominator v table =
  let m = integer v in
  form (is_positive m) "a denominator that is not positive";
  form (Z.eqb (common_divisor m table) one) "a common factor of a denominator";
  m

(* The field: the lower coefficients of the polynomial, and the interval of the root *)

let field = function
  | String "Q" -> None
  | Object ["polynomial", p; "root", Object ["low", lo; "high", hi; "denominator", s]] ->
    let cs = List.map integer (array p) in
    let n = List.length cs - 1 in
    form (n >= 2 && Z.eqb (List.nth cs n) one) "the polynomial is not monic of degree at least two";
    if n > 8 then raise (Declined "the degree");
    let lo = integer lo and hi = integer hi and s = integer s in
    form (is_positive s && Z.ltb lo hi) "the interval of the root";
    form (Z.eqb (Z.gcd s (Z.gcd lo hi)) one) "a common factor of the interval of the root";
    if List.exists (fun x -> bits_of x > 400) [lo; hi; s] then raise (Declined "a root with long ends");
    Some (List.filteri (fun k _ -> k < n) cs, (lo, hi, s))
  | _ -> malformed "the field"

(* Statements, each with its place in the order; numbers are lists of coefficients *)

let relation = function
  | String "less than" -> (0, LessThan)
  | String "at most" -> (1, AtMost)
  | String "maximum" -> (2, Maximum)
  | String "more than" -> (3, MoreThan)
  | String "at least" -> (4, AtLeast)
  | String "minimum" -> (5, Minimum)
  | _ -> malformed "an unknown relation"
let fraction degree = function
  | Array [p; q] ->
    let p = number degree p in
    (p, denominator q [[p]])
  | _ -> malformed "a fraction"
let sign v =
  match small v with
  | (-1 | 0 | 1) as n -> z_of_int n
  | _ -> malformed "a sign"
let is_zero p = List.for_all (fun c -> c = Z0) p
let statement degree = function
  | String "face-to-face tiling" -> (0, None)
  | String "acute" -> (10, Some CAcute)
  | String "nonobtuse" -> (20, Some CNonobtuse)
  | Array [String ("largest dihedral angle" | "smallest dihedral angle" as quantity); rel; sg; f] ->
    let (place, rel) = relation rel and sg = sign sg and (p, q) = fraction degree f in
    form (sg = Z0 = is_zero p) "a bound of zero with a sign, or the reverse";
    if quantity = "largest dihedral angle" then (30 + place, Some (CLargestDihedralAngle (rel, sg, p, q)))
    else (40 + place, Some (CSmallestDihedralAngle (rel, sg, p, q)))
  | Array [String "squared radius-edge ratio"; rel; f] ->
    let (place, rel) = relation rel and (p, q) = fraction degree f in
    (50 + place, Some (CSquaredRadiusEdgeRatio (rel, p, q)))
  | String "Delaunay" -> (60, Some CDelaunay)
  | String "weakly Delaunay" -> (70, Some CWeaklyDelaunay)
  | String ("locally Delaunay" | "locally weakly Delaunay") -> malformed "a local statement about a domain that is not a region"
  | String "TCP" -> (80, Some CTCP)
  | _ -> malformed "an unknown statement"
let statements degree v =
  let l = List.map (statement degree) (array v) in
  let rec increasing = function a :: (b :: _ as r) -> fst a < fst b && increasing r | _ -> true in
  form (l <> [] && fst (List.hd l) = 0 && increasing l) "the order of the statements";
  List.filter_map snd l

(* The domain: the rank of the lattice, and the polytope *)

let domain d degree v =
  let polytope k = function
    | Object ["denominator", m; "vertices", vertices; "faces", faces] ->
      let ws = rows degree k vertices in
      let index i = let i = small i in form (0 <= i && i < List.length ws) "a vertex of a face out of range"; i in
      (d - k, Some (denominator m ws, ws, List.map (fun f -> List.map index (array f)) (array faces)))
    | _ -> malformed "the polytope" in
  match v with
  | String "space" -> (d, None)
  | Array [String "slab"; p] -> polytope 1 p
  | Array [String "prism"; p] -> form (d = 3) "a prism in the plane"; polytope 2 p
  | Array [String "solid"; p] -> polytope d p
  | Array [String "region"; _] -> raise (Declined "a region: its soundness is proved on paper only")
  | _ -> malformed "the domain"

(* Rows: corners, in the canonical order, and the bits of TCP *)

let shift r l =
  let entry v = let n = small v in form (abs n < 1 lsl 29) "a shift out of range"; n in
  let l = List.map entry l in
  form (List.length l = r && List.exists (fun n -> n <> 0) l) "a shift";
  let at k = if k < r then List.nth l k else 0 in
  (at 0, at 1, at 2)
let corner r used v =
  let vertex v = let i = small v in form (0 <= i && i < Array.length used) "a vertex out of range"; used.(i) <- true; i in
  match v with
  | Array (v :: l) -> (vertex v, shift r l)
  | v -> (vertex v, (0, 0, 0))
let in_order = function
  | [a; b; c] -> a < b && a < c && b <> c
  | [a; b; c; d] -> a < b && b < c && b < d && c <> d
  | _ -> false
let simplex d r used tcp v =
  let n = d + 1 in
  let items = array v in
  form (List.length items = n + Bool.to_int tcp) "the length of a row";
  let corners = List.map (corner r used) (List.filteri (fun k _ -> k < n) items) in
  form (snd (List.hd corners) = (0, 0, 0) && in_order corners) "the order of the corners";
  let sixes = if tcp then small (List.nth items n) else 0 in
  form (0 <= sixes && sixes < 64) "the bits of a row";
  (corners, sixes)

(* The data of the checker *)

let z3 (x, y, z) = ((z_of_int x, z_of_int y), z_of_int z)
let z2 (x, y, _) = (z_of_int x, z_of_int y)
let mate shift = Option.map (fun (k, i, s) -> ((n_of_int k, n_of_int i), shift s))
let tetrahedra corners =
  let place (v, s) = (n_of_int v, z3 s) in
  let one cs ms = match List.map place cs, List.map (mate z3) ms with
    | [q0; q1; q2; q3], [m0; m1; m2; m3] -> { q0; q1; q2; q3; m0; m1; m2; m3 }
    | _ -> malformed "a simplex" in
  Array.to_list (Array.map2 one corners (Pairing.mates corners))
(* The corners of a triangle ascend; it is even if they did so in its row. *)
let triangles corners =
  let sorted = Array.map (List.sort compare) corners in
  let place (v, s) = (n_of_int v, z2 s) in
  let one cs ms even = match List.map place cs, List.map (mate z2) ms with
    | [p0; p1; p2], [n0; n1; n2] -> { p0; p1; p2; n0; n1; n2; even }
    | _ -> malformed "a simplex" in
  let pairs = Array.map2 (fun ms even -> (ms, even)) (Pairing.mates sorted) (Array.map2 (=) sorted corners) in
  Array.to_list (Array.map2 (fun cs (ms, even) -> one cs ms even) sorted pairs)

(* Vectors of the ring: over Q the coefficient itself, over a field all of them. *)
let v3 scalar = function [x; y; z] -> { vX = scalar x; vY = scalar y; vZ = scalar z } | _ -> malformed "a vertex"
let in_front n row = List.init n (fun _ -> [Z0]) @ row
let over scalar = function
  | CAcute -> CAcute
  | CNonobtuse -> CNonobtuse
  | CLargestDihedralAngle (rel, sg, p, q) -> CLargestDihedralAngle (rel, sg, scalar p, q)
  | CSmallestDihedralAngle (rel, sg, p, q) -> CSmallestDihedralAngle (rel, sg, scalar p, q)
  | CSquaredRadiusEdgeRatio (rel, p, q) -> CSquaredRadiusEdgeRatio (rel, scalar p, q)
  | CDelaunay -> CDelaunay
  | CWeaklyDelaunay -> CWeaklyDelaunay
  | CTCP -> CTCP

(* The checker over one ring, in which [scalar] puts numbers *)

type 'a judge = {
  format : z -> nat -> 'a v3 list -> n list list -> bool;
  cert : z -> 'a v3 list -> ctet list -> 'a kgram -> nat -> 'a v3 list -> n list list -> 'a cert;
  space : 'a cert -> 'a cstatement list -> bool;
  plane : 'a cert2 -> 'a cstatement list -> bool;
  scalar : z list -> 'a }

type data = {
  d : int; r : int; den : z; gram : z list list; vertices : z list list list;
  polytope : z list list list; faces : int list list;
  corners : (int * (int * int * int)) list array; claimed : z list cstatement list }

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

let judged (type a) (j : a judge) (c : data) =
  let k = c.d - c.r in
  let numbers = c.gram :: c.vertices @ c.polytope in
  let words = 1 + List.fold_left (fun m c -> max m (bits_of c)) 0 (List.concat (List.concat numbers)) / 64 in
  let degree = List.fold_left (fun m c -> max m (List.length c)) 1 (List.concat numbers) in
  if determinants k (Array.length c.corners) (List.length c.polytope) c.faces > 100_000_000 / (degree * degree * words * words) then raise (Declined "the work");
  let v3 = v3 j.scalar and faces = List.map (List.map n_of_int) c.faces and claimed = List.map (over j.scalar) c.claimed in
  let padded = List.map (fun w -> v3 (in_front (3 - k) w)) c.polytope in
  need (k = 0 || j.format c.den (nat_of_int (3 - k)) padded faces) "the polytope";
  let rank = nat_of_int c.r in
  match c.d, List.map j.scalar c.gram with
  | 3, [k11; k12; k13; k22; k23; k33] ->
    let kgram = { k11; k22; k33; k12; k13; k23 } in
    need (j.space (j.cert c.den (List.map v3 c.vertices) (tetrahedra c.corners) kgram rank padded faces) claimed) "the checks"
  | 2, [g11; g12; g22] ->
    let pair = function [x; y] -> (j.scalar x, j.scalar y) | _ -> malformed "a vertex" in
    need (j.plane { e_den = c.den; e_verts = List.map pair c.vertices; e_tris = triangles c.corners;
      e_gram = ((g11, g22), g12); e_rank = rank; e_polytope = List.map (fun w -> pair (in_front (2 - k) w)) c.polytope;
      e_faces = faces } claimed) "the checks"
  | _ -> malformed "the Gram matrix"

(* Over a field a check may fail because a sign is open: a value that is zero although its coefficients
   are not, over a reducible polynomial, or one too close to zero. Such a certificate is declined. The
   same functions run again, with comparisons that note it; their answers have no effect. *)
let why_rejected fl e0 es c reason =
  let is_open = ref false in
  let note x y = if not (lleb e0 es x y || lltb e0 es y x) then is_open := true in
  let less x y = note x y; lltb e0 es x y and at_most x y = note x y; lleb e0 es x y in
  (try judged { format = as_the_format_says ladd lsub (lmul fl) lofZ less at_most;
            cert = faces_cert ladd lsub (lmul fl) lofZ at_most;
            space = Checker.check ladd lsub (lmul fl) lofZ less at_most;
            plane = check2 ladd lsub (lmul fl) lofZ less at_most; scalar = (fun x -> x) } c
   with Rejected _ -> ());
  raise (if !is_open then Declined "a sign that 256 halvings of the root leave open" else Rejected reason)

let judge field c =
  match field with
  | None -> judged { format = format_rationals; cert = cert_rationals; space = check_rationals; plane = check_rationals2; scalar = List.hd } c
  | Some (fl, ((lo, hi, s) as interval)) ->
    let (e0, es) = enclosures fl interval in
    let i = { e_lo = lo; e_hi = hi; e_S = s } in
    let proving = { format = format_field fl e0 es; cert = cert_field fl e0 es; space = check_field fl e0 es i; plane = check_field2 fl e0 es i; scalar = (fun x -> x) } in
    try judged proving c with Rejected reason -> why_rejected fl e0 es c reason

(* A tiling: its claim and its witness *)

let tiling claim witness =
  match claim, witness with
  | Object ["dimension", d; "field", f; "gram", gram; "domain", dom; "statements", ss],
    Object ["denominator", den; "vertices", vertices; "boundary", boundary; "simplices", simplices] ->
    let d = small d in
    form (d = 2 || d = 3) "the dimension";
    let field = field f in
    let degree = match field with None -> 1 | Some (fl, _) -> List.length fl in
    let gram = List.mapi (fun i -> row degree (d - i)) (array gram) in
    form (List.length gram = d && Z.eqb (common_divisor Z0 gram) one) "the Gram matrix";
    let (r, polytope) = domain d degree dom in
    let claimed = statements degree ss in
    let tcp = List.mem CTCP claimed in
    form (not tcp || (d = 3 && r = 3)) "TCP is stated of space only";
    let vertices = rows degree d vertices in
    let den = denominator den vertices in
    let (polytope, faces) = match polytope with
      | None -> ([], [])
      | Some (m, ws, faces) ->
        let factor = Z.div den m in
        need (Z.eqb (Z.mul m factor) den) "the denominator of the domain";
        (times factor ws, faces) in
    form (boundary = Array []) "boundary facets of a domain that is not a region";
    let used = Array.make (List.length vertices) false in
    let rows = Array.of_list (List.map (simplex d r used tcp) (array simplices)) in
    form (rows <> [||]) "no simplices";
    let corners = Array.map fst rows in
    judge field { d; r; den; gram = List.concat gram; vertices; polytope; faces; corners; claimed };
    need (not tcp || Pairing.valences corners (Array.map snd rows)) "the bits of valence 6";
    form (Array.for_all (fun u -> u) used) "an unused vertex"
  | _ -> malformed "the members of the claim or of the witness"

let certificate = function
  | Object (("format", String "acutile-certificate") :: ("version", Integer version) :: _) when version <> "2" -> raise (Declined "the version")
  | Object ["format", String "acutile-certificate"; "version", Integer _; "kind", String kind; "claim", claim; "witness", witness] ->
    if kind <> "tiling" then raise (Declined "the kind");
    tiling claim witness
  | _ -> malformed "not an acutile certificate"

let check path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  let v = parse text in
  form (canonical v = text) "not the canonical bytes";
  certificate v

let verdict path =
  match check path with
  | () -> (0, "proved")
  | exception Rejected reason -> (1, "rejected: " ^ reason)
  | exception (Malformed reason | Unreadable reason) -> (2, "malformed: " ^ reason)
  | exception Declined reason -> (3, "declined: " ^ reason)
  | exception Sys_error reason -> (2, "unreadable: " ^ reason)
  | exception Stack_overflow -> (3, "declined: out of stack")

let () =
  match List.tl (Array.to_list Sys.argv) with
  | [] -> print_endline "usage: acutile-coq-check CERTIFICATE..."; exit 2
  | paths ->
    let codes = List.map (fun path -> let (code, text) = verdict path in Printf.printf "%s: %s\n%!" path text; code) paths in
    exit (match List.find_opt (fun c -> List.mem c codes) [1; 2; 3] with Some c -> c | None -> 0)
