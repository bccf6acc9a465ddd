(* Integers of a certificate as Coq's integers; common factors; the root, bisected. *)

open Checker
open Json

exception Malformed of string
exception Rejected of string
exception Declined of string

let malformed reason = raise (Malformed reason)
let form condition reason = if not condition then malformed reason
let need condition reason = if not condition then raise (Rejected reason)

let rec z_of_int n = if n = 0 then Z0 else if n < 0 then Z.opp (z_of_int (-n))
  else let rec p n = if n = 1 then XH else if n land 1 = 0 then XO (p (n / 2)) else XI (p (n / 2)) in Zpos (p n)
let n_of_int n = Z.to_N (z_of_int n)
let rec nat_of_int n = if n = 0 then O else S (nat_of_int (n - 1))
let one = z_of_int 1
let ten = z_of_int 10
let is_digit c = c >= '0' && c <= '9'
let is_positive = function Zpos _ -> true | _ -> false

(* "0", or an optional minus sign and digits of which the first is not zero. *)
let integer_text t =
  let n = String.length t in
  let k = if n > 0 && t.[0] = '-' then 1 else 0 in
  let digits = ref (n > k && t.[k] <> '0') in
  String.iteri (fun i c -> if i >= k && not (is_digit c) then digits := false) t;
  t = "0" || !digits
let z_of_text t =
  if String.length t > 1001 then raise (Declined "more than 1000 digits");
  let v = ref Z0 in
  String.iter (fun c -> if is_digit c then v := Z.add (Z.mul !v ten) (z_of_int (Char.code c - 48))) t;
  if t.[0] = '-' then Z.opp !v else !v

(* An integer of absolute value less than 2^53 is a number, any other a string. *)
let bits_of = let rec bits = function XH -> 1 | XO p | XI p -> 1 + bits p in function Z0 -> 0 | Zpos p | Zneg p -> bits p
let integer v =
  let value text = form (integer_text text) ("not an integer: " ^ text); z_of_text text in
  match v with
  | Integer text -> let z = value text in form (bits_of z <= 53) "a number of 2^53 or more that is not a string"; z
  | String text -> let z = value text in form (bits_of z > 53) "a string with a number of less than 2^53"; z
  | _ -> malformed "expected an integer"

(* Integers of the machine: vertices, shifts, indices. *)
let small v =
  match v with
  | Integer text when integer_text text && String.length text <= 11 -> int_of_string text
  | _ -> malformed "expected a small integer"

(* The greatest common divisor of m and all integers of a table of numbers. *)
let common_divisor m table = List.fold_left (List.fold_left (List.fold_left Z.gcd)) m table
let times m table = List.map (List.map (List.map (Z.mul m))) table

(* The root, bisected: enclosures after 32, 64, 128 and 256 halvings. *)
let enclosures fl (lo, hi, s) =
  let sign a s = polynomial_sign fl s a in
  (match sign lo s, sign hi s with
   | Lt, Gt | Gt, Lt -> ()
   | _ -> raise (Rejected "the polynomial does not change its sign"));
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
  | [] -> raise (Rejected "no enclosure")
