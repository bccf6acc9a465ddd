(* acutile-coq-check CERTIFICATE: the extracted checker on a certificate file.

   Trusted, besides the extraction and the OCaml compiler: json.ml and this file, which
   turn decimal text into Coq's numbers and clear denominators. The verdict is computed
   by extracted code alone.
   Exit codes: 0 proved, 1 rejected, 2 unreadable or usage, 3 declined. *)

open Checker
open Json

exception Rejected of string
exception Declined of string

let reject what = raise (Rejected what)
let need condition what = if not condition then reject what

(* Numbers *)

let rec z_of_int n = if n = 0 then Z0 else if n < 0 then Z.opp (z_of_int (-n))
  else let rec p n = if n = 1 then XH else if n land 1 = 0 then XO (p (n / 2)) else XI (p (n / 2)) in Zpos (p n)
let one = z_of_int 1
let ten = z_of_int 10
let is_digit c = c >= '0' && c <= '9'

(* "0", or an optional minus sign and digits of which the first is not zero. *)
let integer_text t =
  let n = String.length t in
  let k = if n > 0 && t.[0] = '-' then 1 else 0 in
  t = "0" || (n > k && t.[k] <> '0' && (let ok = ref true in String.iteri (fun i c -> if i >= k && not (is_digit c) then ok := false) t; !ok))
let z_of_text t =
  need (integer_text t) ("not an integer: " ^ t);
  let v = ref Z0 in
  String.iter (fun c -> if is_digit c then v := Z.add (Z.mul !v ten) (z_of_int (Char.code c - 48))) t;
  if t.[0] = '-' then Z.opp !v else !v

(* p or p/q in lowest terms, q > 1. *)
let rational t =
  if String.length t > 1001 then raise (Declined "more than 1000 digits");
  match String.index_opt t '/' with
  | None -> (z_of_text t, one)
  | Some i ->
    let p = z_of_text (String.sub t 0 i) and q = z_of_text (String.sub t (i + 1) (String.length t - i - 1)) in
    need (Z.ltb one q) "a denominator that is not above 1";
    need (Z.eqb (Z.gcd p q) one) "not in lowest terms";
    (p, q)

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

(* m T for the least m > 0 that makes it integral, and m. *)
let cleared table =
  let lcm m (_, q) = Z.div (Z.mul m q) (Z.gcd m q) in
  let m = List.fold_left (List.fold_left (List.fold_left lcm)) one table in
  (List.map (List.map (List.map (fun (p, q) -> Z.mul p (Z.div m q)))) table, m)

(* Structure *)

let array = function Array l -> l | _ -> reject "expected an array"
let bound = 1 lsl 31
let int_of = function
  | Integer t when integer_text t && String.length t <= 11 ->
    let n = int_of_string t in
    need (abs n < bound) "an integer beyond 2^31"; n
  | _ -> reject "expected a small integer"
let index limit n = need (0 <= n && n < limit) "an index out of range"; Z.to_N (z_of_int n)
let shift x y z = ((z_of_int x, z_of_int y), z_of_int z)

let corner used v =
  match List.map int_of (array v) with
  | [i; x; y; z] -> let k = index (Array.length used) i in used.(i) <- true; (k, shift x y z)
  | _ -> reject "the length of a corner"
let mate simplices v =
  match List.map int_of (array v) with
  | [t; j; x; y; z] -> Some ((index simplices t, index 4 j), shift x y z)
  | _ -> reject "the length of a mate"
let simplex used simplices corners mates =
  match List.map (corner used) (array corners), List.map (mate simplices) (array mates) with
  | [q0; q1; q2; q3], [m0; m1; m2; m3] -> { q0; q1; q2; q3; m0; m1; m2; m3 }
  | _ -> reject "the length of a simplex or of a row of mates"

(* Claimed, but nothing that the theory treats: the verdict can only be "declined". *)
let left_out = ref []

let statement = function
  | String "face-to-face tiling" -> (0, None)
  | String "acute" -> (1, Some Acute)
  | String "nonobtuse" -> (2, Some Nonobtuse)
  | Object ["all dihedral angles below", String t] -> let (p, q) = rational t in (3, Some (DihedralBelow (p, q)))
  | Object [("all dihedral angles above" | "all radius-edge ratios below" as name), String t] ->
    ignore (rational t); left_out := name :: !left_out; ((if name = "all dihedral angles above" then 4 else 5), None)
  | String "Delaunay" -> (6, Some Delaunay)
  | String "weakly Delaunay" -> (7, Some WeaklyDelaunay)
  | String "TCP" -> left_out := "TCP" :: !left_out; (8, None)
  | _ -> reject "an unknown statement"
let statements v =
  let l = List.map statement (array v) in
  let rec increasing = function a :: (b :: _ as r) -> fst a < fst b && increasing r | _ -> true in
  need (l <> [] && fst (List.hd l) = 0 && increasing l) "the order of the statements";
  List.filter_map snd l

(* The root, bisected: enclosures after 32, 64, 128 and 256 halvings. *)
let enclosures fl (lo, hi, s) =
  let sign a s = polynomial_sign fl s a in
  (match sign lo s, sign hi s with
   | Lt, Gt | Gt, Lt -> ()
   | _ -> reject "the polynomial does not change its sign");
  let right = sign hi s and two = z_of_int 2 in
  let rec go k lo hi s acc =
    let middle = Z.add lo hi and s' = Z.mul s two in
    let lo, hi = match sign middle s' with
      | Eq -> middle, middle
      | c when c = right -> Z.mul lo two, middle
      | _ -> middle, Z.mul hi two in
    let acc = if List.mem k [32; 64; 128; 256] then { e_lo = lo; e_hi = hi; e_S = s' } :: acc else acc in
    if k = 256 then acc else go (k + 1) lo hi s' acc in
  match go 1 lo hi s [] with
  | finest :: rest -> (finest, List.rev rest)
  | [] -> reject "no enclosure"

let field = function
  | String "Q" -> None
  | Object ["Q(a)", Object ["polynomial", p; "root", Array [String lo; String hi]]] ->
    let text = function String t -> z_of_text t | _ -> reject "the polynomial" in
    let cs = List.map text (array p) in
    let n = List.length cs - 1 in
    need (n >= 2 && Z.eqb (List.nth cs n) one) "the polynomial is not monic of degree at least two";
    if n > 32 then raise (Declined "the degree");
    let fl = List.filteri (fun k _ -> k < n) cs in
    let (p1, q1) = rational lo and (p2, q2) = rational hi in
    let lo = Z.mul p1 q2 and hi = Z.mul p2 q1 and s = Z.mul q1 q2 in
    need (Z.ltb lo hi) "the interval of the root";
    Some (fl, (lo, hi, s))
  | _ -> reject "the field"

let certificate v =
  match v with
  | Object ["format", String "acutile-certificate"; "version", Integer version; "claim", claim; "witness", witness] ->
    if version <> "1" then raise (Declined "the version");
    (match claim, witness with
     | Object ["dimension", d; "field", f; "gram", gram; "domain", domain; "statements", ss],
       Object ["vertices", vertices; "simplices", simplices; "mates", mates] ->
       let d = int_of d in
       if d = 2 then raise (Declined "dimension 2 is not part of the Coq development");
       need (d = 3) "the dimension";
       if domain <> String "space" then raise (Declined "a domain other than space");
       let field = field f in
       let degree = match field with None -> 1 | Some (fl, _) -> List.length fl in
       let table v = List.map (fun row -> List.map (number degree) (array row)) (array v) in
       need (List.length (array gram) = 3 && List.for_all (fun r -> List.length (array r) = 3) (array gram)) "the shape of the Gram matrix";
       let entry i j = List.nth (array (List.nth (array gram) i)) j in
       need (entry 0 1 = entry 1 0 && entry 0 2 = entry 2 0 && entry 1 2 = entry 2 1) "the Gram matrix is not symmetric";
       let (g, gden) = cleared (table gram) and (vs, den) = cleared (table vertices) in
       need (List.for_all (fun r -> List.length r = 3) vs) "the length of a vertex";
       let used = Array.make (List.length vs) false in
       let ss_json = array simplices and ms_json = array mates in
       let n = List.length ss_json in
       need (n > 0 && List.length ms_json = n) "the number of simplices or of rows of mates";
       let ts = List.map2 (simplex used n) ss_json ms_json in
       need (Array.for_all (fun u -> u) used) "an unused vertex";
       let ss = statements ss in
       let make scalar =
         let v3 = function [x; y; z] -> { vX = scalar x; vY = scalar y; vZ = scalar z } | _ -> reject "a vertex" in
         let e i j = scalar (List.nth (List.nth g i) j) in
         { c_den = den; c_verts = List.map v3 vs; c_tets = ts; c_gden = gden;
           c_gram = { k11 = e 0 0; k22 = e 1 1; k33 = e 2 2; k12 = e 0 1; k13 = e 0 2; k23 = e 1 2 };
           c_rank = S (S (S O)); c_domain = []; c_cover = ByVolume } in
       (match field with
        | None ->
          let c = make List.hd in
          if not (check_rationals c ss) then
            reject ("the checks: " ^ String.concat " " (List.map string_of_bool (parts_rationals c ss)))
        | Some (fl, ((lo, hi, s) as interval)) ->
          let (e0, es) = enclosures fl interval in
          need (check_field fl e0 es { e_lo = lo; e_hi = hi; e_S = s } (make (fun x -> x)) ss) "the checks")
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

let () =
  let say code what = print_endline what; exit code in
  match Sys.argv with
  | [| _; path |] ->
    (match check path with
     | () when !left_out <> [] -> say 3 ("declined: all is proved but: " ^ String.concat ", " (List.rev !left_out))
     | () -> say 0 "proved"
     | exception Rejected what -> say 1 ("rejected: " ^ what)
     | exception Declined what -> say 3 ("declined: " ^ what)
     | exception Unreadable what -> say 1 ("rejected: " ^ what)
     | exception Sys_error what -> say 2 what
     | exception Stack_overflow -> say 3 "declined: out of stack")
  | _ -> say 2 "usage: acutile-coq-check CERTIFICATE"
