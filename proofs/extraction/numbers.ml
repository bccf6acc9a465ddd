(* Decimal text to Coq's integers; denominators cleared; the root bisected. Unverified. *)

open Checker

exception Rejected of string
exception Declined of string

let reject what = raise (Rejected what)
let need condition what = if not condition then reject what

let rec z_of_int n = if n = 0 then Z0 else if n < 0 then Z.opp (z_of_int (-n))
  else let rec p n = if n = 1 then XH else if n land 1 = 0 then XO (p (n / 2)) else XI (p (n / 2)) in Zpos (p n)
let n_of_int n = Z.to_N (z_of_int n)
let rec nat_of_int n = if n = 0 then O else S (nat_of_int (n - 1))
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
  if String.length t > 1001 then raise (Declined "more than 1000 digits");
  let v = ref Z0 in
  String.iter (fun c -> if is_digit c then v := Z.add (Z.mul !v ten) (z_of_int (Char.code c - 48))) t;
  if t.[0] = '-' then Z.opp !v else !v

(* p or p/q in lowest terms, q > 1. *)
let rational t =
  match String.index_opt t '/' with
  | None -> (z_of_text t, one)
  | Some i ->
    let p = z_of_text (String.sub t 0 i) and q = z_of_text (String.sub t (i + 1) (String.length t - i - 1)) in
    need (Z.ltb one q) "a denominator that is not above 1";
    need (Z.eqb (Z.gcd p q) one) "not in lowest terms";
    (p, q)

(* The least common denominator of rows of numbers; m T for a multiple m of it. *)
let rec bits = function XH -> 1 | XO p | XI p -> 1 + bits p
let bits_of = function Z0 -> 0 | Zpos p | Zneg p -> bits p
let denominator tables =
  let lcm m (_, q) =
    match Z.div (Z.mul m q) (Z.gcd m q) with
    | Zpos p when bits p > 3400 -> raise (Declined "a common denominator of more than 1000 digits")
    | m -> m in
  List.fold_left (List.fold_left (List.fold_left (List.fold_left lcm))) one tables
let scaled m table = List.map (List.map (List.map (fun (p, q) -> Z.mul p (Z.div m q)))) table

(* The sum of two elements by their coefficients. *)
let rec plus a b = match a, b with
  | [], c | c, [] -> c
  | x :: a, y :: b -> Z.add x y :: plus a b

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
