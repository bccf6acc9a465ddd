(** * There are mosaics: the grid of unit squares, and the integers on a line

    So claims about systems of patches are about something.  Nothing depends on this file. *)
Require Import Reals Lra Psatz ZArith List Lia Bool Cantor.
From Acutile Require Import Statement Sums Tetrahedra MosaicStatement.
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
Lemma near_integers a b : IZR a < IZR b + 1 -> IZR b < IZR a + 1 -> a = b.
Proof. intros P Q. rewrite <- plus_IZR in P, Q. apply lt_IZR in P, Q. lia. Qed.
Lemma bounded_integer M z t : - M < t < M -> IZR z <= t <= IZR z + 1 -> In z (zr (Z.to_nat (up (M + 1)))).
Proof.
  intros T Z. destruct (archimed (M + 1)) as [U _]. assert (A : IZR z < IZR (up (M + 1))) by lra. assert (B : IZR (- z) < IZR (up (M + 1))) by (rewrite opp_IZR; lra).
  apply lt_IZR in A, B. apply zr_In. lia.
Qed.

(** The standard basis. *)
Definition e1 := Point 1 0 0.
Definition e2 := Point 0 1 0.
Definition e3 := Point 0 0 1.
Definition standard := Gram 1 1 1 0 0 0.
Lemma standard_coordinates x : at_coordinates e1 e2 e3 x = x.
Proof. unfold at_coordinates, e1, e2, e3. apply point_eq; unf; ring. Qed.
Lemma standard_gram : has_gram standard e1 e2 e3.
Proof. unfold has_gram, standard, dot, e1, e2, e3; cbn. repeat split; ring. Qed.
Definition standard_tile (c : point) := Tile 0 c (e1, e2, e3).

(** ** Squares *)
Definition square := Patch [Edge 0 (Point 0 0 0); Edge 0 (Point 0 1 0); Edge 0 (Point 0 1 1); Edge 0 (Point 0 0 1)] [] [].
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
Definition squares (n : nat) : tile := standard_tile (Point 0 (IZR (fst (at_grid n))) (IZR (snd (at_grid n)))).
Lemma square_left s x : (s < 4)%nat -> left_of 1 square s x = match s with 0%nat => pz x | 1%nat => 1 - py x | 2%nat => 1 - pz x | _ => py x end.
Proof. intros S. do 4 (destruct s as [|s]; [unfold left_of, finish, square; cbn; ring|]). lia. Qed.
Lemma square_place n x : place squares n x = Point (px x) (IZR (fst (at_grid n)) + py x) (IZR (snd (at_grid n)) + pz x).
Proof. unfold place, squares, standard_tile; cbn [axes corner]. rewrite standard_coordinates. apply point_eq; unf; ring. Qed.
Lemma square_over n X : over 1 [square] squares n X <->
  IZR (fst (at_grid n)) <= py X <= IZR (fst (at_grid n)) + 1 /\ IZR (snd (at_grid n)) <= pz X <= IZR (snd (at_grid n)) + 1.
Proof.
  split.
  - intros [x [-> H]]. rewrite square_place. cbn [py pz].
    pose proof (H 0%nat ltac:(cbn; lia)) as A. pose proof (H 1%nat ltac:(cbn; lia)) as B. pose proof (H 2%nat ltac:(cbn; lia)) as C. pose proof (H 3%nat ltac:(cbn; lia)) as D.
    change (patch_of [square] squares n) with square in *. rewrite square_left in A, B, C, D by lia. lra.
  - intros H. exists (Point (px X) (py X - IZR (fst (at_grid n))) (pz X - IZR (snd (at_grid n)))). split; [rewrite square_place; apply point_eq; cbn; ring|].
    intros s S. change (patch_of [square] squares n) with square in *. change (s < 4)%nat in S. rewrite square_left by auto. destruct s as [|[|[|s]]]; cbn [py pz]; lra.
Qed.
Lemma square_meets n s m s' : meets e1 e2 e3 1 [square] squares n s m s' <->
  (s < 4)%nat /\ (s' < 4)%nat /\ n <> m /\
  let v (k : nat) := match k with 0%nat => (0, 0) | 1%nat => (1, 0) | 2%nat => (1, 1) | _ => (0, 1) end%Z in
  let at_ i (k : nat) := (fst (at_grid i) + fst (v k), snd (at_grid i) + snd (v k))%Z in
  at_ n s = at_ m (next 4 s') /\ at_ n (next 4 s) = at_ m s'.
Proof.
  unfold meets. change (patch_of [square] squares n) with square. change (patch_of [square] squares m) with square.
  change (sides square) with 4%nat.
  assert (B : forall X Y, same_base e1 e2 e3 1 X Y <-> py X = py Y /\ pz X = pz Y).
  { intros X Y. split.
    - intros [f [[F1 F2] ->]]. rewrite standard_coordinates. unf. rewrite F1, F2. split; ring.
    - intros [P Q]. exists (Point (px X - px Y) 0 0). split; [split; reflexivity|]. rewrite standard_coordinates. apply point_eq; unf; rewrite ?P, ?Q; ring. }
  rewrite !B, !square_place. cbn [py pz]. destruct (at_grid n) as [x y], (at_grid m) as [u v]. cbn [fst snd].
  split; intros [S [S' [N H]]]; (split; [exact S|split; [exact S'|split; [exact N|]]]).
  - destruct H as [_ H]. cbv zeta. do 4 (destruct s as [|s]; [do 4 (destruct s' as [|s']; [cbn in H |- *; destruct H as [[H1 H2] [H3 H4]];
      rewrite ?Rplus_0_r, <- ?plus_IZR in H1, H2, H3, H4; try (apply eq_IZR in H1); try (apply eq_IZR in H2); try (apply eq_IZR in H3); try (apply eq_IZR in H4); split; f_equal; lia|]); lia|]). lia.
  - split; [discriminate|]. cbv zeta in H. do 4 (destruct s as [|s]; [do 4 (destruct s' as [|s']; [cbn in H |- *; destruct H as [H1 H2]; injection H1 as H1 H1'; injection H2 as H2 H2';
      repeat split; rewrite ?Rplus_0_r, <- ?plus_IZR; f_equal; lia|]); lia|]). lia.
Qed.

Theorem squares_are_a_mosaic : mosaic e1 e2 e3 standard 1 [square] squares.
Proof.
  constructor.
  - intros i. cbn. lia.
  - intros i. cbn. split; [apply standard_gram|]. repeat split; discriminate.
  - intros M. set (K := Z.to_nat (up (M + 1))). exists (map code (list_prod (zr K) (zr K))).
    intros i X [_ [A B]] H. apply square_over in H. cbn [origin py pz] in A, B. rewrite Rminus_0_r in A, B. apply Rabs_def2 in A, B.
    rewrite <- (grid_injective (code (at_grid i)) i (grid_code _)). apply in_map. destruct (at_grid i) as [x y]. cbn [fst snd] in H. destruct H.
    apply in_prod; [apply (bounded_integer M x (py X))|apply (bounded_integer M y (pz X))]; lra.
  - intros X. exists (code (up (py X) - 1, up (pz X) - 1)%Z). apply square_over. rewrite grid_code. cbn [fst snd]. rewrite !minus_IZR.
    destruct (archimed (py X)), (archimed (pz X)). lra.
  - intros i j X [x [-> I]] J. apply square_over in J. rewrite square_place in J. cbn [py pz] in J.
    pose proof (I 0%nat ltac:(cbn; lia)) as A. pose proof (I 1%nat ltac:(cbn; lia)) as B. pose proof (I 2%nat ltac:(cbn; lia)) as C. pose proof (I 3%nat ltac:(cbn; lia)) as D.
    change (patch_of [square] squares i) with square in *. rewrite square_left in A, B, C, D by lia. apply grid_injective.
    destruct (at_grid i) as [u v], (at_grid j) as [u' v']. cbn [fst snd] in *. f_equal; apply near_integers; lra.
  - intros i s S. change (s < 4)%nat in S. destruct (at_grid i) as [x y] eqn:E.
    assert (N : forall z, z <> (x, y) -> i <> code z) by (intros z Z Q; apply Z; rewrite <- E, Q, grid_code; reflexivity).
    destruct s as [|[|[|[|s]]]]; [exists (code (x, y - 1)%Z), 2%nat|exists (code (x + 1, y)%Z), 3%nat|exists (code (x, y + 1)%Z), 0%nat|exists (code (x - 1, y)%Z), 1%nat|lia];
    apply square_meets; (split; [lia|]; split; [lia|]; split; [apply N; intros Q; injection Q; lia|]); cbv beta zeta; rewrite E, grid_code; cbn; split; f_equal; lia.
  - intros i s j s' [S [S' _]]. change (s < 4)%nat in S. change (s' < 4)%nat in S'. change (patch_of [square] squares i) with square. change (patch_of [square] squares j) with square.
    do 4 (destruct s as [|s]; [do 4 (destruct s' as [|s']; [reflexivity|]); lia|]). lia.
Qed.

(** ** A line *)
Definition segment := Patch [Edge 0 (Point 0 0 0); Edge 0 (Point 0 0 1)] [] [].
Definition segments (n : nat) : tile := standard_tile (Point 0 0 (IZR (integer n))).
Lemma segment_place n x : place segments n x = Point (px x) (py x) (IZR (integer n) + pz x).
Proof. unfold place, segments, standard_tile; cbn [axes corner]. rewrite standard_coordinates. apply point_eq; unf; ring. Qed.
Lemma segment_over n X : over 2 [segment] segments n X <-> IZR (integer n) <= pz X <= IZR (integer n) + 1.
Proof.
  split.
  - intros [x [-> H]]. rewrite segment_place. cbn [pz]. pose proof (H 0%nat ltac:(cbn; lia)) as A. pose proof (H 1%nat ltac:(cbn; lia)) as B. cbn in A, B. lra.
  - intros H. exists (Point (px X) (py X) (pz X - IZR (integer n))). split; [rewrite segment_place; apply point_eq; cbn; ring|].
    intros s S. change (s < 2)%nat in S. destruct s as [|[|s]]; [cbn; lra|cbn; lra|lia].
Qed.
Lemma segment_meets n s m s' : meets e1 e2 e3 2 [segment] segments n s m s' <->
  (s = 0%nat /\ s' = 1%nat /\ integer n = (integer m + 1)%Z) \/ (s = 1%nat /\ s' = 0%nat /\ (integer n + 1)%Z = integer m).
Proof.
  unfold meets. change (patch_of [segment] segments n) with segment. change (patch_of [segment] segments m) with segment. change (sides segment) with 2%nat.
  assert (B : forall X Y, same_base e1 e2 e3 2 X Y <-> pz X = pz Y).
  { intros X Y. split.
    - intros [f [F ->]]. cbn in F. rewrite standard_coordinates. unf. rewrite F. ring.
    - intros P. exists (Point (px X - px Y) (py X - py Y) 0). split; [reflexivity|]. rewrite standard_coordinates. apply point_eq; unf; rewrite ?P; ring. }
  rewrite !B, !segment_place. cbn [pz]. split.
  - intros [S [S' [_ [D [H _]]]]]. specialize (D eq_refl).
    destruct s as [|[|s]]; [| |lia]; destruct s' as [|[|s']]; try lia; cbn in H; rewrite ?Rplus_0_r, <- ?plus_IZR in H; apply eq_IZR in H; [left|right]; auto.
  - intros [[-> [-> E]]|[-> [-> E]]]; cbn; rewrite ?Rplus_0_r, <- ?plus_IZR; (split; [lia|]; split; [lia|]; split; [intros ->; lia|]; split; [discriminate|]); split; f_equal; lia.
Qed.
Theorem segments_are_a_mosaic : mosaic e1 e2 e3 standard 2 [segment] segments.
Proof.
  constructor.
  - intros i. cbn. lia.
  - intros i. cbn. split; [apply standard_gram|]. repeat split.
  - intros M. exists (map number (zr (Z.to_nat (up (M + 1))))). intros i X [_ [_ B]] H. apply segment_over in H. cbn [origin pz] in B. rewrite Rminus_0_r in B. apply Rabs_def2 in B.
    rewrite <- (integer_injective (number (integer i)) i (integer_number _)). apply in_map, (bounded_integer M _ (pz X)); lra.
  - intros X. exists (number (up (pz X) - 1)%Z). apply segment_over. rewrite integer_number, minus_IZR. destruct (archimed (pz X)). lra.
  - intros i j X [x [-> I]] J. apply segment_over in J. rewrite segment_place in J. cbn [pz] in J.
    pose proof (I 0%nat ltac:(cbn; lia)) as A. pose proof (I 1%nat ltac:(cbn; lia)) as B. cbn in A, B. apply integer_injective, near_integers; lra.
  - intros i s S. change (s < 2)%nat in S. destruct s as [|[|s]]; [exists (number (integer i - 1)), 1%nat|exists (number (integer i + 1)), 0%nat|lia]; apply segment_meets; rewrite integer_number; [left|right]; repeat split; lia.
  - intros i s j s' M. apply segment_meets in M as [[-> [-> _]]|[-> [-> _]]]; reflexivity.
Qed.
