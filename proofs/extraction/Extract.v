(** * The checker as an OCaml program

    Pure extraction: numbers stay the inductive types of Coq (binary [Z], [N],
    [positive], unary [nat]), nothing is mapped to machine or library arithmetic.
    Only bool, list, option, pairs and unit become those of OCaml. *)
From Coq Require Import ZArith NArith List Extraction ExtrOcamlBasic.
From Acutile Require Import Statement Checker PlaneChecker Polytope Numbers.

(** The four theorems end in these: z_theorem, nf_theorem, z_theorem2, nf_theorem2. *)
Definition check_rationals (c : cert Z) (ss : list (cstatement Z)) : bool := zcheck c ss.
Definition check_field (fl : list Z) (e0 : encl) (es : list encl) (interval : encl) (c : cert (list Z)) (ss : list (cstatement (list Z))) : bool :=
  if isolated fl e0 es interval then nfcheck fl e0 es c ss else false.
Definition check_rationals2 (c : cert2 Z) (ss : list (cstatement Z)) : bool := zcheck2 c ss.
Definition check_field2 (fl : list Z) (e0 : encl) (es : list encl) (interval : encl) (c : cert2 (list Z)) (ss : list (cstatement (list Z))) : bool :=
  if isolated fl e0 es interval then nfcheck2 fl e0 es c ss else false.

(** Certificates with their hints, and what the format demands of a polytope. *)
Definition cert_rationals := zcert.
Definition cert_field := nfcert.
Definition format_rationals := as_the_format_says Z Z.add Z.sub Z.mul idZ Z.ltb Z.leb.
Definition format_field (fl : list Z) (e0 : encl) (es : list encl) := as_the_format_says (list Z) ladd lsub (lmul fl) lofZ (lltb e0 es) (lleb e0 es).
(** The sign of the monic polynomial with lower coefficients fl at a/S: for the reader, which bisects. *)
Definition polynomial_sign (fl : list Z) (S a : Z) : comparison := Z.compare (fst (hev S (fl ++ 1%Z :: nil) a)) 0.

Extraction "checker.ml" check_rationals check_field check_rationals2 check_field2 cert_rationals cert_field
  format_rationals format_field polynomial_sign
  Z.add Z.sub Z.mul Z.div Z.gcd Z.eqb Z.ltb Z.leb Z.opp Z.to_N.
