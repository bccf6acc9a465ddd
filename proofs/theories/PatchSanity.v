(** * There are mosaics: the grid of unit squares

    So the theorem of PatchNumbers.v is about something.  And the checks refuse what is wrong.  Nothing depends on this file. *)
Require Import Reals Lra Psatz ZArith List Lia Bool Cantor.
From Acutile Require Import Statement Sums PatchStatement SquareTriangle PatchChecker PatchNumbers.
Import ListNotations.
Open Scope R_scope.

(** The integers, numbered 0, -1, 1, -2, 2, … *)
Definition integer (n : nat) : Z := if Nat.even n then Z.of_nat (Nat.div2 n) else (- Z.of_nat (S (Nat.div2 n)))%Z.
Definition number (z : Z) : nat := if (z <? 0)%Z then Nat.pred (2 * Z.to_nat (- z)) else (2 * Z.to_nat z)%nat.
Lemma integer_number z : integer (number z) = z.
Proof.
  unfold integer, number. destruct (Z.ltb_spec z 0).
  - replace (Nat.pred (2 * Z.to_nat (- z))) with (S (2 * Nat.pred (Z.to_nat (- z)))) by lia.
    rewrite Nat.even_succ, Nat.odd_mul, Nat.div2_succ_double. cbn [Nat.odd Nat.even negb andb]. lia.
  - rewrite Nat.even_mul, Nat.div2_double. cbn [Nat.even orb]. lia.
Qed.
Lemma integer_injective m n : integer m = integer n -> m = n.
Proof.
  unfold integer. pose proof (Nat.div2_odd m) as M. pose proof (Nat.div2_odd n) as N. rewrite <- !Nat.negb_odd.
  destruct (Nat.odd m), (Nat.odd n); cbn [negb Nat.b2n] in *; lia.
Qed.

(** Tile n is the unit square with the lower left corner [at_grid n]. *)
Definition at_grid (n : nat) : Z * Z := let '(a, b) := of_nat n in (integer a, integer b).
Definition code (z : Z * Z) : nat := to_nat (number (fst z), number (snd z)).
Lemma grid_code z : at_grid (code z) = z.
Proof. unfold at_grid, code. rewrite cancel_of_to, !integer_number. destruct z; reflexivity. Qed.
Lemma grid_injective m n : at_grid m = at_grid n -> m = n.
Proof.
  unfold at_grid. rewrite <- (cancel_to_of m) at 2. rewrite <- (cancel_to_of n) at 2. destruct (of_nat m) as [a b], (of_nat n) as [c d].
  intros E. injection E as A B. apply integer_injective in A, B. congruence.
Qed.
Definition squares (n : nat) : tile := Tile 1 (IZR (fst (at_grid n)), IZR (snd (at_grid n))) (1, 0).

Lemma square_corner n s : corner_of square_triangle squares n s =
  let x := IZR (fst (at_grid n)) in let y := IZR (snd (at_grid n)) in
  match s with 1%nat => (x + 1, y) | 2%nat => (x + 1, y + 1) | 3%nat => (x, y + 1) | _ => (x, y) end.
Proof.
  cbv zeta. unfold corner_of, edge_of, patch_of, squares. cbn [shape corner along square_triangle nth].
  do 4 (destruct s as [|s]; [cbn; unfold surd; cbn [fst snd]; f_equal; field|]).
  destruct s; cbn; unfold surd; cbn [fst snd]; f_equal; field.
Qed.
Lemma square_left n s X : (s < 4)%nat -> left_of square_triangle squares n s X =
  let x := IZR (fst (at_grid n)) in let y := IZR (snd (at_grid n)) in
  match s with 0%nat => snd X - y | 1%nat => x + 1 - fst X | 2%nat => y + 1 - snd X | _ => fst X - x end.
Proof.
  intros S. unfold left_of. rewrite !square_corner. cbv zeta. change (sides square_triangle squares n) with 4%nat.
  do 4 (destruct s as [|s]; [cbn [next Nat.eqb fst snd]; ring|]). lia.
Qed.
Lemma square_in n X : in_tile square_triangle squares n X <->
  IZR (fst (at_grid n)) <= fst X <= IZR (fst (at_grid n)) + 1 /\ IZR (snd (at_grid n)) <= snd X <= IZR (snd (at_grid n)) + 1.
Proof.
  split.
  - intros H. pose proof (H 0%nat ltac:(cbn; lia)) as A. pose proof (H 1%nat ltac:(cbn; lia)) as B. pose proof (H 2%nat ltac:(cbn; lia)) as C. pose proof (H 3%nat ltac:(cbn; lia)) as D.
    rewrite square_left in A, B, C, D by lia. cbv zeta in *. lra.
  - intros H s S. change (s < 4)%nat in S. rewrite square_left by auto. cbv zeta. destruct s as [|[|[|s]]]; lra.
Qed.

Theorem squares_are_a_mosaic : mosaic square_triangle squares.
Proof.
  constructor.
  - intros i. cbn. lia.
  - intros i. cbn [squares along fst snd]. ring.
  - intros M. set (K := Z.to_nat (up (M + 1))). exists (map code (list_prod (zr K) (zr K))).
    intros i X A B H. apply square_in in H. apply Rabs_def2 in A, B. destruct (archimed (M + 1)) as [U _].
    rewrite <- (grid_injective (code (at_grid i)) i (grid_code _)). apply in_map. destruct (at_grid i) as [x y]. cbn [fst snd] in H.
    assert (G : forall z t, - M < t < M -> IZR z <= t <= IZR z + 1 -> (Z.abs z <= Z.of_nat K)%Z).
    { intros z t T Z. assert (IZR z < IZR (up (M + 1))) by lra. assert (IZR (- z) < IZR (up (M + 1))) by (rewrite opp_IZR; lra).
      apply lt_IZR in H0, H1. unfold K. lia. }
    destruct H. apply in_prod; apply zr_In; [apply (G x (fst X))|apply (G y (snd X))]; lra.
  - intros X. exists (code (up (fst X) - 1, up (snd X) - 1)%Z). apply square_in. rewrite grid_code. cbn [fst snd]. rewrite !minus_IZR.
    destruct (archimed (fst X)), (archimed (snd X)). lra.
  - intros i j X I J. assert (I' : in_tile square_triangle squares i X) by (intros s S; specialize (I s S); lra).
    pose proof (I 0%nat ltac:(cbn; lia)) as A. pose proof (I 1%nat ltac:(cbn; lia)) as B. pose proof (I 2%nat ltac:(cbn; lia)) as C. pose proof (I 3%nat ltac:(cbn; lia)) as D.
    rewrite square_left in A, B, C, D by lia. cbv zeta in *. apply square_in in J. apply grid_injective.
    destruct (at_grid i) as [x y], (at_grid j) as [u v]. cbn [fst snd] in *.
    assert (G : forall a b, IZR a < IZR b + 1 -> IZR b < IZR a + 1 -> a = b).
    { intros a b P Q. rewrite <- plus_IZR in P, Q. apply lt_IZR in P, Q. lia. }
    f_equal; apply G; lra.
  - intros i s S. change (s < 4)%nat in S. destruct (at_grid i) as [x y] eqn:E.
    assert (N : forall z, z <> (x, y) -> i <> code z) by (intros z Z Q; apply Z; rewrite <- E, Q, grid_code; reflexivity).
    assert (P : forall z, at_grid (code z) = z) by apply grid_code.
    destruct s as [|[|[|[|s]]]]; [exists (code (x, y - 1)%Z), 2%nat|exists (code (x + 1, y)%Z), 3%nat|exists (code (x, y + 1)%Z), 0%nat|exists (code (x - 1, y)%Z), 1%nat|lia];
    (split; [cbn; lia|]; split; [cbn; lia|]; split; [apply N; intros Q; injection Q; lia|]);
    change (sides square_triangle squares i) with 4%nat; change (sides square_triangle squares (code _)) with 4%nat;
    rewrite !square_corner, E, P; cbn [next Nat.eqb fst snd]; rewrite ?minus_IZR, ?plus_IZR; split; f_equal; ring.
Qed.

(** The checks refuse what is wrong: a piece without one of its tetrahedra, an apex at
    another place, a square whose offsets are all zero. *)
Definition without_one (p : patch) : patch := Patch (edges p) (tl (pieces p)).
Definition moved (p : patch) : patch := Patch (map (fun e => Edge (start e) (lift 1 (apex e)) (rim e)) (edges p)) (pieces p).
Definition level (p : patch) : patch := Patch (map (fun e => Edge (Spot (0, 0)%Z (ahead (start e)) (aside (start e))) (apex e) (rim e)) (edges p)) (pieces p).
Example refused_without_one : check_system [triangle_patch; without_one square_patch] square_triangle_hints = false.
Proof. vm_compute. reflexivity. Qed.
Example refused_moved : check_system [moved triangle_patch; square_patch] square_triangle_hints = false.
Proof. vm_compute. reflexivity. Qed.
Example refused_level : check_system [triangle_patch; level square_patch] square_triangle_hints = false.
Proof. vm_compute. reflexivity. Qed.
