(** * The checker as an OCaml program

    Pure extraction: numbers stay the inductive types of Coq (binary [Z], [N],
    [positive], unary [nat]), nothing is mapped to machine or library arithmetic.
    Bytes and the letters of texts become characters, and bool, list, option, pairs and
    unit those of OCaml, by the libraries that come with Coq. *)
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlString.
From Acutile Require Import Bytes ClaimText.

(** The theorem [accepted] of Bytes.v is about [judge]. *)
Extraction "checker.ml" judge claim_text.
