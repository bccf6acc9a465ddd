(** * Products of long integers

    [Z.mul] adds the second factor once for each bit of the first one that is set: for two
    long factors that is half of the bits.  [zmul] takes three bits at a time, and the
    multiples 3, 5 and 7 of the shorter factor: a quarter of the bits of the longer one.
    [zmul_is] says that the two are the same function. *)
From Coq Require Import ZArith Lia Reals FunctionalExtensionality.
Local Open Scope positive_scope.

Fixpoint windows (y y3 y5 y7 x : positive) : positive :=
  match x with
  | 1 => y
  | p~0 => (windows y y3 y5 y7 p)~0
  | 3 => y3
  | 5 => y5
  | 7 => y7
  | p~0~0~1 => y + (windows y y3 y5 y7 p)~0~0~0
  | p~0~1~1 => y3 + (windows y y3 y5 y7 p)~0~0~0
  | p~1~0~1 => y5 + (windows y y3 y5 y7 p)~0~0~0
  | p~1~1~1 => y7 + (windows y y3 y5 y7 p)~0~0~0
  end.
Lemma windows_eq y : forall x, windows y (3 * y) (5 * y) (7 * y) x = x * y.
Proof.
  fix IH 1. intros x. destruct x as [x|x|]; [destruct x as [x|x|]; [destruct x as [x|x|]|destruct x as [x|x|]|]| |];
    cbn [windows]; rewrite ?(IH x); clear IH; lia.
Qed.

(** For a factor of at most six bits the multiples would cost more than they save. *)
Fixpoint is_short (bits : nat) (x : positive) : bool :=
  match x with
  | 1 => true
  | p~0 => match bits with O => false | S bits => is_short bits p end
  | p~1 => match bits with O => false | S bits => is_short bits p end
  end.
Definition multiplied (y x : positive) : positive :=
  if is_short 6 y then y * x else
  let y2 := y~0 in let y3 := y + y2 in let y5 := y + y2~0 in windows y y3 y5 (y5 + y2) x.
Lemma multiplied_eq y x : multiplied y x = x * y.
Proof.
  unfold multiplied. destruct (is_short 6 y); [apply Pos.mul_comm|]. cbv zeta. rewrite <- windows_eq. f_equal; lia.
Qed.
Fixpoint is_shorter (x y : positive) : bool :=
  match x, y with
  | 1, _ => true
  | _, 1 => false
  | p~0, q~0 => is_shorter p q
  | p~0, q~1 => is_shorter p q
  | p~1, q~0 => is_shorter p q
  | p~1, q~1 => is_shorter p q
  end.
Definition pmul (x y : positive) : positive := if is_shorter x y then multiplied x y else multiplied y x.
Lemma pmul_eq x y : pmul x y = x * y.
Proof. unfold pmul. destruct (is_shorter x y); rewrite multiplied_eq; [apply Pos.mul_comm|reflexivity]. Qed.

Local Open Scope Z_scope.
Definition zmul (x y : Z) : Z :=
  match x, y with
  | 0, _ => 0
  | _, 0 => 0
  | Zpos x, Zpos y => Zpos (pmul x y)
  | Zpos x, Zneg y => Zneg (pmul x y)
  | Zneg x, Zpos y => Zneg (pmul x y)
  | Zneg x, Zneg y => Zpos (pmul x y)
  end.
Lemma zmul_eq x y : zmul x y = x * y.
Proof. destruct x, y; cbn [zmul Z.mul]; rewrite ?pmul_eq; reflexivity. Qed.
Lemma zmul_is : zmul = Z.mul.
Proof. apply functional_extensionality. intros x. apply functional_extensionality. exact (zmul_eq x). Qed.
Lemma zmul_IZR x y : IZR (zmul x y) = (IZR x * IZR y)%R.
Proof. rewrite zmul_eq. apply mult_IZR. Qed.
