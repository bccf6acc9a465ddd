(* acutile-coq-check [--print-claim] CERTIFICATE...: the function [judge] of Bytes.v on the
   bytes of each file, which is a certificate in CBOR.

   One line for each file; with --print-claim the claim file of each proved certificate. Exit
   code 0 if all are proved, else the first that occurs of 1 (one is rejected), 2 (one is
   malformed or unreadable, or usage), 3 (one is declined). *)

let contents path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  let rec bytes k l = if k < 0 then l else bytes (k - 1) (text.[k] :: l) in
  bytes (String.length text - 1) []
let text letters = String.of_seq (List.to_seq letters)

let verdict print_claim path =
  match Checker.judge (contents path) with
  | Checker.Accepted claim -> (0, if print_claim then text (Checker.claim_text claim) else path ^ ": proved\n")
  | Checker.Refused (Checker.Rejected why) -> (1, path ^ ": rejected: " ^ text why ^ "\n")
  | Checker.Refused (Checker.Malformed why) -> (2, path ^ ": malformed: " ^ text why ^ "\n")
  | Checker.Refused (Checker.Declined why) -> (3, path ^ ": declined: " ^ text why ^ "\n")
  | exception Sys_error why -> (2, path ^ ": unreadable: " ^ why ^ "\n")
  | exception End_of_file -> (2, path ^ ": unreadable: shorter than it says\n")
  | exception Stack_overflow -> (3, path ^ ": declined: out of stack\n")

let () =
  let print_claim, paths = match List.tl (Array.to_list Sys.argv) with
    | "--print-claim" :: paths -> true, paths
    | paths -> false, paths in
  if paths = [] || List.mem "--help" paths then (print_endline "usage: acutile-coq-check [--print-claim] CERTIFICATE... (in CBOR)"; exit 2);
  let codes = List.map (fun path -> let (code, line) = verdict print_claim path in print_string line; flush stdout; code) paths in
  exit (match List.find_opt (fun c -> List.mem c codes) [1; 2; 3] with Some c -> c | None -> 0)
