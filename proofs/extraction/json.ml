(* The part of JSON that certificates use: objects, arrays, strings of printable ASCII
   without escapes, integers. It reads a text and writes the canonical text. *)

type t = Object of (string * t) list | Array of t list | String of string | Integer of string

exception Unreadable of string

let fail at reason = raise (Unreadable (Printf.sprintf "byte %d: %s" at reason))

let parse (s : string) : t =
  let n = String.length s and i = ref 0 in
  let peek () = if !i < n then s.[!i] else '\000' in
  let rec space () = match peek () with ' ' | '\n' | '\t' | '\r' -> incr i; space () | _ -> () in
  let expect c = space (); if !i < n && peek () = c then incr i else fail !i (Printf.sprintf "expected %c" c) in
  let text () =
    expect '"';
    let start = !i in
    while !i < n && peek () <> '"' do
      if peek () = '\\' || peek () < ' ' || peek () > '~' then fail !i "an escape or a character that is not printable ASCII";
      incr i
    done;
    let t = String.sub s start (!i - start) in
    expect '"'; t in
  let integer () =
    let start = !i in
    if peek () = '-' then incr i;
    while peek () >= '0' && peek () <= '9' do incr i done;
    let t = String.sub s start (!i - start) in
    if t = "" || t = "-" then fail start "expected a value"; t in
  let rec list close item acc =
    space ();
    if acc = [] && peek () = close then (incr i; [])
    else begin
      let x = item () in
      space ();
      match peek () with
      | ',' -> incr i; list close item (x :: acc)
      | c when c = close && !i < n -> incr i; List.rev (x :: acc)
      | _ -> fail !i "expected a comma or the end"
    end in
  (* The bound on nesting bounds the stack. *)
  let rec value depth =
    if depth > 80 then fail !i "nested too deeply";
    space ();
    match peek () with
    | '{' -> incr i; Object (list '}' (fun () -> space (); let k = text () in expect ':'; (k, value (depth + 1))) [])
    | '[' -> incr i; Array (list ']' (fun () -> value (depth + 1)) [])
    | '"' -> String (text ())
    | _ -> Integer (integer ()) in
  let v = value 0 in
  space ();
  if !i < n then fail !i "trailing data";
  v

(* The canonical bytes: each item of the outer three levels stands on its own line. *)
let canonical (v : t) : string =
  let b = Buffer.create 65536 in
  let line depth = if depth <= 3 then Buffer.add_char b '\n' in
  let members depth items write =
    List.iteri (fun k x -> if k > 0 then Buffer.add_char b ','; line depth; write x) items;
    if items <> [] then line depth in
  let rec write depth = function
    | String s -> Buffer.add_char b '"'; Buffer.add_string b s; Buffer.add_char b '"'
    | Integer s -> Buffer.add_string b s
    | Array l -> Buffer.add_char b '['; members (depth + 1) l (write (depth + 1)); Buffer.add_char b ']'
    | Object l -> Buffer.add_char b '{';
      members (depth + 1) l (fun (k, x) -> Buffer.add_string b ("\"" ^ k ^ "\":"); write (depth + 1) x);
      Buffer.add_char b '}' in
  write 0 v;
  Buffer.add_char b '\n';
  Buffer.contents b
