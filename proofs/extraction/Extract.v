(** * The checker as an OCaml program

    Pure extraction: numbers stay the inductive types of Coq (binary [Z], [N],
    [positive], unary [nat]), nothing is mapped to machine or library arithmetic.
    Only bool, list, option, pairs and unit become those of OCaml. *)
From Coq Require Import ZArith NArith List Extraction ExtrOcamlBasic.
From Acutile Require Import Statement Checker Numbers.

Definition check_rationals (c : cert Z) (ss : list statement) : bool := zcheck c ss.
Definition parts_rationals := zparts.
Definition check_field (fl : list Z) (e0 : encl) (es : list encl) (interval : encl) (c : cert (list Z)) (ss : list statement) : bool :=
  if isolated fl e0 es interval then nfcheck fl e0 es c ss else false.
(** The sign of the monic polynomial with lower coefficients fl at a/S: for the reader, which bisects. *)
Definition polynomial_sign (fl : list Z) (S a : Z) : comparison := Z.compare (fst (hev S (fl ++ 1%Z :: nil) a)) 0.

Extraction "checker.ml" check_rationals parts_rationals check_field polynomial_sign
  Z.add Z.sub Z.mul Z.div Z.gcd Z.eqb Z.ltb Z.opp Z.to_N.
