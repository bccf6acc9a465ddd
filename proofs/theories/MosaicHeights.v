(** * Heights of the patches over a mosaic

    Each tile is compared with the first one, in the order of their numbers, to which it is related.
    So no path from tile to tile is needed.

    - r = 1: tiles are related if one is turned against the other by one of finitely many rotations.
      The rotation alone gives the difference of their heights.  (The finite check is that each
      rotation from a tile to the next one leads from this set into it.)
    - r = 2: tiles are related if one is some tiles above the other. *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Domain Euclid MosaicStatement MosaicPoints MosaicPatches MosaicSides.
Import ListNotations.
Open Scope R_scope.

Definition whole (x : R) : Prop := exists z : Z, x = IZR z.
Lemma whole_0 : whole 0.
Proof. exists 0%Z. reflexivity. Qed.
Lemma whole_add x y : whole x -> whole y -> whole (x + y).
Proof. intros [a ->] [b ->]. exists (a + b)%Z. rewrite plus_IZR. reflexivity. Qed.
Lemma whole_opp x : whole x -> whole (- x).
Proof. intros [a ->]. exists (- a)%Z. rewrite opp_IZR. reflexivity. Qed.
Lemma whole_eq x y : whole x -> x = y -> whole y.
Proof. intros H <-. exact H. Qed.

(** ** The first related tile *)
Section First.
Variable related : nat -> nat -> Prop.
Hypothesis refl : forall i, related i i.
Definition relatedb i j : bool := if dec (related i j) then true else false.
Lemma relatedb_t i j : relatedb i j = true <-> related i j.
Proof. unfold relatedb. destruct (dec (related i j)); split; intros; auto; discriminate. Qed.
Lemma find_first f n : forall a x, find f (seq a n) = Some x -> f x = true /\ forall j, (a <= j < x)%nat -> f j = false.
Proof.
  induction n as [|n IH]; intros a r; cbn [seq find]; [discriminate|]. destruct (f a) eqn:F.
  - intros E. injection E as <-. split; auto. lia.
  - intros E. destruct (IH _ _ E) as [A B]. split; auto. intros j J. destruct (Nat.eq_dec j a) as [->|]; auto. apply B. lia.
Qed.
Definition first (i : nat) : nat := match find (relatedb i) (seq 0 (S i)) with Some j => j | None => i end.
Lemma first_spec i : related i (first i) /\ forall j, related i j -> (first i <= j)%nat.
Proof.
  unfold first. destruct (find (relatedb i) (seq 0 (S i))) as [x|] eqn:F.
  - apply find_first in F as [A B]. apply relatedb_t in A. split; auto. intros j J. destruct (Nat.le_gt_cases x j) as [|L]; auto.
    apply relatedb_t in J. rewrite B in J by lia. discriminate.
  - exfalso. pose proof (find_none _ _ F i ltac:(apply in_seq; lia)) as N. pose proof (proj2 (relatedb_t i i) (refl i)). congruence.
Qed.
Lemma first_eq i j : (forall k, related i k <-> related j k) -> first i = first j.
Proof.
  intros E. destruct (first_spec i) as [A B], (first_spec j) as [A' B'].
  apply Nat.le_antisymm; [apply B, E, A'|apply B', E, A].
Qed.
End First.

Section Heights.
Variables (G : gram) (r : nat) (system : list patch) (h : hints).
Hypothesis OK : good G r system h.
Variables (l1 l2 l3 : point).
Hypothesis basis : has_gram G l1 l2 l3.
Hypothesis right_handed : 0 < det l1 l2 l3.
Variable tiles : nat -> tile.
Hypothesis tiling : mosaic l1 l2 l3 G r system tiles.
Notation kind i := (shape (tiles i)).
Notation patch_at a := (nth a system (Patch [] [] [])).
Notation patch_of i := (patch_of system tiles i).
Notation meets i s j s' := (meets l1 l2 l3 r system tiles i s j s').
Notation place i x := (place tiles i x).
Notation carry := (carry G r).
Notation kinds := (kind_lt G r system l1 l2 l3 tiles tiling).
Notation across_side := (across_side r system l1 l2 l3 tiles).
Definition offset (p : patch) (s : nat) : R * R := (px (start (edge_at p s)), py (start (edge_at p s))).

(** Heights psi over the base are enough. *)
Section Reduction.
(** [S i j w]: the tile i is related to j, in the way w; [value i j w] is the difference of their heights. *)
Variables (S : nat -> nat -> nat * nat -> Prop) (value : nat -> nat -> nat * nat -> R * R).
Definition congruent (x y : R * R) : Prop := whole (fst x - fst y) /\ (r = 2%nat -> whole (snd x - snd y)).
Hypothesis S_refl : forall i, exists w, S i i w.
Hypothesis S_step : forall i s j s' k w, meets i s j s' -> S i k w -> exists w', S j k w' /\
  congruent (value j k w') (fst (value i k w) + fst (offset (patch_of i) s) - fst (offset (patch_of j) s'), snd (value i k w) + snd (offset (patch_of i) s) - snd (offset (patch_of j) s')).
Hypothesis S_unique : forall i k w w', S i k w -> S i k w' -> congruent (value i k w) (value i k w').
Definition related i k : Prop := exists w, S i k w.
Definition psi (i : nat) : R * R := let k := first related i in value i k (proj1_sig (choose_pair (S i k))).
Lemma psi_step i s j s' : meets i s j s' -> congruent (psi j) (fst (psi i) + fst (offset (patch_of i) s) - fst (offset (patch_of j) s'), snd (psi i) + snd (offset (patch_of i) s) - snd (offset (patch_of j) s')).
Proof.
  intros M. pose proof (meets_sym G r system h OK l1 l2 l3 tiles tiling _ _ _ _ M) as M'.
  assert (F : first related i = first related j).
  { apply first_eq; [exact S_refl|]. intros k. split; intros [w W]; [destruct (S_step _ _ _ _ _ _ M W) as [w' [W' _]]|destruct (S_step _ _ _ _ _ _ M' W) as [w' [W' _]]]; exists w'; exact W'. }
  unfold psi. rewrite <- F. destruct (first_spec related S_refl i) as [R _]. destruct (first_spec related S_refl j) as [R' _]. rewrite <- F in R'.
  set (k := first related i) in *. destruct (choose_pair (S i k)) as [w W], (choose_pair (S j k)) as [w' W']; cbn [proj1_sig].
  specialize (W R). specialize (W' R'). destruct (S_step _ _ _ _ _ _ M W) as [w2 [W2 C]]. pose proof (S_unique _ _ _ _ W' W2) as U.
  destruct C as [C1 C2], U as [U1 U2]. split; [|intros R2; specialize (C2 R2); specialize (U2 R2)].
  - apply (whole_eq _ _ (whole_add _ _ U1 C1)). cbn [fst snd]. ring.
  - apply (whole_eq _ _ (whole_add _ _ U2 C2)). cbn [fst snd]. ring.
Qed.
(** Coordinates in the fibre. *)
Definition fibre_of (X : point) : point := match r with 1%nat => Point (dot l1 X / dot l1 l1) 0 0 | _ => let x := Einv l1 l2 l3 X in Point (px x) (py x) 0 end.
Lemma g11_pos : 0 < dot l1 l1.
Proof.
  destruct (Req_dec (dot l1 l1) 0) as [Z|Z].
  - exfalso. unfold dot in Z. pose proof (Rle_0_sqr (px l1)); pose proof (Rle_0_sqr (py l1)); pose proof (Rle_0_sqr (pz l1)); unfold Rsqr in *.
    assert (X : px l1 = 0) by nra. assert (Y : py l1 = 0) by nra. assert (W : pz l1 = 0) by nra.
    revert right_handed. unfold det. rewrite X, Y, W. lra.
  - unfold dot in *. pose proof (Rle_0_sqr (px l1)); pose proof (Rle_0_sqr (py l1)); pose proof (Rle_0_sqr (pz l1)); unfold Rsqr in *. lra.
Qed.
Lemma fibre_place i x : fibre_of (place i x) = add (fibre_of (corner (tiles i))) (match r with 1%nat => Point (px x) 0 0 | _ => Point (px x) (py x) 0 end).
Proof.
  destruct (motion G r system h OK l1 l2 l3 basis right_handed tiles tiling i) as [m2 [m3 [E [HG [_ R2]]]]]. unfold MosaicStatement.place. rewrite E.
  pose proof g11_pos as LL. destruct (good_blocks _ _ _ _ OK) as [Z13 [Z12 _]]. unfold fibre_of. destruct (good_rank _ _ _ _ OK) as [R|R]; rewrite R in *.
  - destruct HG as [_ [_ [_ [A4 [A5 _]]]]]. rewrite (Z12 eq_refl) in A4. rewrite Z13 in A5. apply point_eq; unf; [|ring|ring].
    transitivity ((dot l1 (corner (tiles i)) + px x * dot l1 l1 + py x * dot l1 m2 + pz x * dot l1 m3) / dot l1 l1).
    + f_equal. unfold dot, at_coordinates. unf. ring.
    + rewrite A4, A5. field. lra.
  - destruct (R2 eq_refl) as [-> ->]. assert (D0 : det l1 l2 l3 <> 0) by lra. unfold Einv, at_coordinates. apply point_eq; cbn [px py pz add]; unf; try ring; field; auto.
Qed.
Lemma fibre_at f : in_fibre r f -> fibre_of (at_coordinates l1 l2 l3 f) = f.
Proof.
  pose proof g11_pos as LL. unfold fibre_of, in_fibre. destruct (good_rank _ _ _ _ OK) as [R|R]; rewrite R in *.
  - intros [Y Z]. apply point_eq; cbn [px py pz]; auto. unfold at_coordinates. rewrite Y, Z. unfold dot in *. unf. field. lra.
  - intros Z. pose proof (Einv_E l1 l2 l3 ltac:(lra) f) as K. unfold Euclid.E in K. rewrite K. apply point_eq; cbn [px py pz]; auto.
Qed.
Lemma fibre_add X Y : fibre_of (add X Y) = add (fibre_of X) (fibre_of Y).
Proof.
  pose proof g11_pos as LL. unfold fibre_of. destruct (good_rank _ _ _ _ OK) as [R|R]; rewrite R in *.
  - apply point_eq; cbn [px py pz add]; [|ring|ring]. unfold dot in *. unf. field. lra.
  - unfold Einv. apply point_eq; cbn [px py pz add]; [| |ring]; unf; field; lra.
Qed.
Definition rise_of (i : nat) : point := let c := fibre_of (corner (tiles i)) in Point (fst (psi i) - px c) (if Nat.eqb r 2 then snd (psi i) - py c else 0) 0.
Theorem reduced : exists rise, heights l1 l2 l3 r system tiles rise.
Proof.
  exists rise_of. assert (FB : forall i, in_fibre r (rise_of i)).
  { intros i. unfold in_fibre, rise_of. destruct (good_rank _ _ _ _ OK) as [R|R]; rewrite R; cbn; auto. }
  split; [exact FB|]. intros i s j s' M. pose proof (psi_step _ _ _ _ M) as [C1 C2]. pose proof M as [_ [_ [_ [_ [[f [F E]] _]]]]].
  assert (FE : fibre_of (place i (start (edge_at (patch_of i) s))) = add (fibre_of (place j (finish r (patch_of j) s'))) f).
  { rewrite E, fibre_add, (fibre_at f F). reflexivity. }
  rewrite !fibre_place in FE. set (A := start (edge_at (patch_of i) s)) in *. set (B := start (edge_at (patch_of j) s')) in *.
  assert (PB : px (finish r (patch_of j) s') = px B /\ (r = 2%nat -> py (finish r (patch_of j) s') = py B)).
  { unfold finish. destruct (good_rank _ _ _ _ OK) as [R|R]; rewrite R; split; auto; discriminate. }
  destruct PB as [PB1 PB2]. set (fin := finish r (patch_of j) s') in *.
  assert (N : exists n, in_lattice r n /\ add f (rise_of i) = add (rise_of j) (pt n)).
  { destruct C1 as [z1 C1]. unfold offset in *. cbn [fst snd] in *. fold A B in C1, C2. unfold rise_of, in_fibre in *. destruct (good_rank _ _ _ _ OK) as [R|R]; rewrite R in *; cbn [Nat.eqb] in *.
    - exists (- z1, 0, 0)%Z. split; [split; reflexivity|]. destruct F as [F1 F2]. apply (f_equal px) in FE. unf.
      apply point_eq; cbn [px py pz add pt]; rewrite ?opp_IZR; lra.
    - destruct (C2 eq_refl) as [z2 C2']. specialize (PB2 eq_refl). exists (- z1, - z2, 0)%Z. split; [reflexivity|].
      apply (f_equal px) in FE as FE1. apply (f_equal py) in FE as FE2. clear FE. unf. apply point_eq; cbn [px py pz add pt]; rewrite ?opp_IZR; lra. }
  destruct N as [n [L N]]. exists n. split; [exact L|]. unfold MosaicStatement.spot.
  rewrite !(place_fibre G r system h OK l1 l2 l3 basis right_handed tiles tiling) by apply FB. rewrite E. fold fin.
  assert (P : MosaicStatement.period l1 l2 l3 n = at_coordinates l1 l2 l3 (pt n)) by (destruct n as [[? ?] ?]; reflexivity). rewrite P.
  assert (AA : forall x y, at_coordinates l1 l2 l3 (add x y) = add (at_coordinates l1 l2 l3 x) (at_coordinates l1 l2 l3 y)) by (intros; unfold at_coordinates; apply point_eq; unf; ring).
  transitivity (add (place j fin) (at_coordinates l1 l2 l3 (add f (rise_of i)))); [rewrite AA; apply point_eq; unf; ring|].
  rewrite N, AA. apply point_eq; unf; ring.
Qed.
End Reduction.

(** ** r = 1: finitely many rotations *)
Section Rotations.
Hypothesis rank_1 : r = 1%nat.
(** A linear map of the base, by the images of its two basis vectors, and a height. *)
Definition turning := ((R * R) * (R * R) * R)%type.
Definition linear (p : patch) (s : nat) (q : patch) (s' : nat) : (R * R) * (R * R) :=
  let im e := let d := sub (carry p s q s' e) (carry p s q s' origin) in (py d, pz d) in (im (Point 0 1 0), im (Point 0 0 1)).
Definition compose (m n : (R * R) * (R * R)) : (R * R) * (R * R) :=
  let im v := (fst v * fst (fst m) + snd v * fst (snd m), fst v * snd (fst m) + snd v * snd (snd m)) in (im (fst n), im (snd n)).
Variable turnings : list turning.
Definition no_turning : turning := ((1, 0), (0, 1), 0).
Notation turning_at k := (nth k turnings no_turning).
Record rotations : Prop := {
  rotations_identity : (0 < length turnings)%nat /\ turning_at 0 = no_turning;
  rotations_step : forall a s b s' k, (a < length system)%nat -> (b < length system)%nat -> (s < sides (patch_at a))%nat -> (s' < sides (patch_at b))%nat ->
    fits G r (patch_at a) s (patch_at b) s' -> (k < length turnings)%nat -> exists k', (k' < length turnings)%nat /\
      fst (turning_at k') = compose (fst (turning_at k)) (linear (patch_at a) s (patch_at b) s') /\
      whole (snd (turning_at k') - (snd (turning_at k) + fst (offset (patch_at a) s) - fst (offset (patch_at b) s')));
  rotations_unique : forall k k', (k < length turnings)%nat -> (k' < length turnings)%nat -> fst (turning_at k) = fst (turning_at k') ->
    whole (snd (turning_at k) - snd (turning_at k')) }.
Hypothesis ROT : rotations.
Definition second (i : nat) : point := snd (fst (axes (tiles i))).
Definition third (i : nat) : point := snd (axes (tiles i)).
Definition image (i : nat) (v : R * R) : point := add (scale (fst v) (second i)) (scale (snd v) (third i)).
Definition turned (i j : nat) (w : nat * nat) : Prop := (fst w < length turnings)%nat /\
  second i = image j (fst (fst (turning_at (fst w)))) /\ third i = image j (snd (fst (turning_at (fst w)))).
Lemma meets_linear i s j s' : meets i s j s' -> let m := linear (patch_of i) s (patch_of j) s' in second j = image i (fst m) /\ third j = image i (snd m).
Proof.
  intros M. cbv zeta. pose proof M as [_ [_ [_ [_ [[f [F E]] _]]]]].
  assert (FO : in_fibre r origin) by (unfold in_fibre; rewrite rank_1; cbn; auto).
  assert (K : place i (add (start (edge_at (patch_of i) s)) origin) = add (place j (add (finish r (patch_of j) s') origin)) (at_coordinates l1 l2 l3 f)).
  { assert (O : forall x, add x origin = x) by (intros; apply point_eq; unf; unfold origin; cbn; ring). rewrite !O. exact E. }
  pose proof (fun x => frame_meets G r system h OK l1 l2 l3 basis right_handed tiles tiling i s j s' origin origin _ x M FO FO K) as FM.
  set (T := at_coordinates l1 l2 l3 f) in *. clearbody T.
  destruct (motion G r system h OK l1 l2 l3 basis right_handed tiles tiling i) as [a2 [a3 [Ei _]]]. destruct (motion G r system h OK l1 l2 l3 basis right_handed tiles tiling j) as [b2 [b3 [Ej _]]].
  unfold image, second, third, MosaicStatement.place in *. rewrite Ei, Ej in *. cbn [fst snd] in *.
  assert (D : forall e, at_coordinates l1 b2 b3 e = at_coordinates l1 a2 a3 (sub (carry (patch_of i) s (patch_of j) s' e) (carry (patch_of i) s (patch_of j) s' origin))).
  { intros e. pose proof (FM e) as X. pose proof (FM origin) as Y. set (c := carry (patch_of i) s (patch_of j) s' e) in *. set (c0 := carry (patch_of i) s (patch_of j) s' origin) in *. clearbody c c0.
    clear - X Y. unfold at_coordinates, origin in *. apply point_eq; [apply (f_equal px) in X; apply (f_equal px) in Y|apply (f_equal py) in X; apply (f_equal py) in Y|apply (f_equal pz) in X; apply (f_equal pz) in Y]; unf; lra. }
  assert (P0 : forall e, px e = 0 -> px (sub (carry (patch_of i) s (patch_of j) s' e) (carry (patch_of i) s (patch_of j) s' origin)) = 0).
  { intros e P. unfold MosaicPatches.carry. rewrite rank_1. unfold sub, origin; cbn. lra. }
  split; [pose proof (D (Point 0 1 0)) as X; pose proof (P0 (Point 0 1 0) eq_refl) as Y|pose proof (D (Point 0 0 1)) as X; pose proof (P0 (Point 0 0 1) eq_refl) as Y];
  unfold linear; cbn [fst snd]; match type of X with _ = at_coordinates _ _ _ ?d => set (dd := d) in *; clearbody dd end;
  unfold at_coordinates in X; clear - X Y; apply point_eq; [apply (f_equal px) in X|apply (f_equal py) in X|apply (f_equal pz) in X|apply (f_equal px) in X|apply (f_equal py) in X|apply (f_equal pz) in X]; unf; rewrite Y in X; lra.
Qed.
Lemma image_inj i v w : image i v = image i w -> v = w.
Proof.
  destruct (motion G r system h OK l1 l2 l3 basis right_handed tiles tiling i) as [m2 [m3 [E [_ [D _]]]]]. unfold image, second, third. rewrite E. cbn [fst snd]. intros K.
  assert (X : Point 0 (fst v) (snd v) = Point 0 (fst w) (snd w)).
  { apply (E_inj l1 m2 m3); [lra|]. unfold Euclid.E, at_coordinates. apply point_eq; [apply (f_equal px) in K|apply (f_equal py) in K|apply (f_equal pz) in K]; unf; lra. }
  injection X as A B. destruct v, w; cbn in *; congruence.
Qed.
Theorem heights_by_rotations : exists rise, heights l1 l2 l3 r system tiles rise.
Proof.
  destruct ROT as [[I0 I1] ST UN].
  apply (reduced turned (fun i j w => (snd (turning_at (fst w)), 0))).
  - intros i. exists (0, 0)%nat. unfold turned. cbn [fst]. rewrite I1. split; [exact I0|]. unfold no_turning, image; cbn [fst snd]. split; apply point_eq; unf; ring.
  - intros i s j s' k w M [W1 [W2 W3]]. pose proof M as [Hs [Hs' _]]. pose proof (meets_fits G r system h OK l1 l2 l3 tiles tiling _ _ _ _ M) as FT.
    destruct (ST (kind i) s (kind j) s' (fst w) (kinds i) (kinds j) Hs Hs' FT W1) as [k' [K1 [K2 K3]]].
    exists (k', 0)%nat. cbn [fst snd]. split.
    + unfold turned; cbn [fst]. split; [exact K1|]. rewrite K2. destruct (meets_linear _ _ _ _ M) as [L2 L3]. cbv zeta in *.
      change (nth (kind i) system (Patch [] [] [])) with (patch_of i). change (nth (kind j) system (Patch [] [] [])) with (patch_of j).
      set (m := linear (patch_of i) s (patch_of j) s') in *. rewrite L2, L3. unfold image at 1 3. rewrite W2, W3. unfold compose, image; cbn [fst snd].
      split; apply point_eq; unf; ring.
    + split; [exact K3|]. rewrite rank_1. discriminate.
  - intros i k w w' [W1 [W2 W3]] [W1' [W2' W3']]. cbn [fst snd]. split; [|rewrite rank_1; discriminate].
    apply UN; auto. rewrite W2 in W2'. rewrite W3 in W3'. apply image_inj in W2', W3'.
    destruct (fst (turning_at (fst w))), (fst (turning_at (fst w'))); cbn in *; congruence.
Qed.
End Rotations.

(** ** r = 2: one tile above the other *)
Section Chain.
Hypothesis rank_2 : r = 2%nat.
Definition up (i : nat) : nat := fst (across_side i 1).
Lemma two_sides i : sides (patch_of i) = 2%nat.
Proof. apply (good_sides _ _ _ _ OK); [apply kinds|exact rank_2]. Qed.
Lemma up_meets i : meets i 1 (up i) 0.
Proof.
  unfold up. assert (H1 : (1 < sides (patch_of i))%nat) by (rewrite two_sides; lia). destruct (across_side i 1) as [j s'] eqn:E. cbn [fst].
  pose proof (across_meets G r system l1 l2 l3 tiles tiling i 1 j s' H1 E) as M. pose proof M as [_ [Hs' [_ [D _]]]]. specialize (D rank_2). rewrite two_sides in Hs'.
  replace s' with 0%nat in M by lia. exact M.
Qed.
Lemma meets_up i s j s' : meets i s j s' -> (s = 1%nat /\ s' = 0%nat /\ j = up i) \/ (s = 0%nat /\ s' = 1%nat /\ i = up j).
Proof.
  intros M. pose proof M as [Hs [Hs' [_ [D _]]]]. specialize (D rank_2). rewrite two_sides in Hs, Hs'.
  assert (C : (s = 1 /\ s' = 0 \/ s = 0 /\ s' = 1)%nat) by lia. destruct C as [[-> ->]|[-> ->]]; [left|right]; repeat split; auto.
  - destruct (meets_once G r system h OK l1 l2 l3 basis right_handed tiles tiling _ _ _ _ _ _ M (up_meets i)) as [E _]. auto.
  - pose proof (meets_sym G r system h OK l1 l2 l3 tiles tiling _ _ _ _ M) as M'. destruct (meets_once G r system h OK l1 l2 l3 basis right_handed tiles tiling _ _ _ _ _ _ M' (up_meets j)) as [E _]. auto.
Qed.
Lemma up_inj i j : up i = up j -> i = j.
Proof.
  intros E. pose proof (meets_sym G r system h OK l1 l2 l3 tiles tiling _ _ _ _ (up_meets i)) as M. pose proof (meets_sym G r system h OK l1 l2 l3 tiles tiling _ _ _ _ (up_meets j)) as M'.
  rewrite E in M. destruct (meets_once G r system h OK l1 l2 l3 basis right_handed tiles tiling _ _ _ _ _ _ M M') as [K _]. auto.
Qed.
(** The height of the lower end. *)
Definition low (i : nat) : R := pz (Einv l1 l2 l3 (corner (tiles i))) + pz (start (edge_at (patch_of i) 0)).
Lemma low_up i : low i < low (up i).
Proof.
  assert (D0 : det l1 l2 l3 <> 0) by lra. pose proof (up_meets i) as [_ [_ [_ [_ [[f [F E]] _]]]]].
  destruct (motion G r system h OK l1 l2 l3 basis right_handed tiles tiling i) as [a2 [a3 [Ei [_ [_ R2]]]]]. destruct (motion G r system h OK l1 l2 l3 basis right_handed tiles tiling (up i)) as [b2 [b3 [Ej [_ [_ R2']]]]].
  destruct (R2 rank_2) as [-> ->], (R2' rank_2) as [-> ->]. unfold MosaicStatement.place in E. rewrite Ei, Ej in E. unfold finish, in_fibre in *. rewrite rank_2 in F, E.
  destruct (good_homes _ _ _ _ OK (kind i) (kinds i)) as [k [x [_ [_ [P _]]]]]. change (patch_at (kind i)) with (patch_of i) in P.
  pose proof (P 0%nat ltac:(rewrite two_sides; lia)) as P0. pose proof (P 1%nat ltac:(rewrite two_sides; lia)) as P1. unfold left_of in P0, P1. rewrite rank_2 in P0, P1.
  apply (f_equal (fun X => pz (Einv l1 l2 l3 X))) in E.
  assert (EI : forall X x, pz (Einv l1 l2 l3 (add X (at_coordinates l1 l2 l3 x))) = pz (Einv l1 l2 l3 X) + pz x).
  { intros. unfold Einv, at_coordinates; cbn [pz]. unf. field. exact D0. }
  cbv beta in E. rewrite !EI, F in E. unfold low. lra.
Qed.
Definition climb (n i : nat) : nat := Nat.iter n up i.
Lemma climb_low n i : low i <= low (climb n i) /\ ((0 < n)%nat -> low i < low (climb n i)).
Proof.
  induction n as [|n [IH _]]; [split; [apply Rle_refl|lia]|].
  change (climb (S n) i) with (up (climb n i)). pose proof (low_up (climb n i)) as L.
  split; [left|intros _]; apply Rle_lt_trans with (low (climb n i)); assumption.
Qed.
Lemma climb_add m n i : climb (m + n) i = climb m (climb n i).
Proof. unfold climb. induction m as [|m IH]; cbn [Nat.add Nat.iter nat_rect]; [reflexivity|]. f_equal. exact IH. Qed.
Lemma climb_inj n i j : climb n i = climb n j -> i = j.
Proof. unfold climb. induction n as [|n IH]; cbn [Nat.iter nat_rect]; auto. intros E. apply IH, up_inj, E. Qed.
Lemma climb_fix n i : climb n i = i -> n = 0%nat.
Proof. intros E. destruct n; auto. destruct (climb_low (S n) i) as [_ K]. specialize (K ltac:(lia)). rewrite E in K. lra. Qed.
Lemma climb_up n i : climb n (up i) = up (climb n i).
Proof. unfold climb. induction n as [|n IH]; cbn [Nat.iter nat_rect]; auto. Qed.
(** The gain from a tile to the next one, and that over n tiles. *)
Definition gain (i : nat) : R * R := (fst (offset (patch_of i) 1) - fst (offset (patch_of (up i)) 0), snd (offset (patch_of i) 1) - snd (offset (patch_of (up i)) 0)).
Fixpoint gains (n i : nat) : R * R := match n with O => (0, 0) | S n => (fst (gain i) + fst (gains n (up i)), snd (gain i) + snd (gains n (up i))) end.
Lemma gains_last n : forall i, gains (S n) i = (fst (gains n i) + fst (gain (climb n i)), snd (gains n i) + snd (gain (climb n i))).
Proof.
  induction n as [|n IH]; intros i; [cbn; f_equal; ring|]. cbn [gains] in *. rewrite (IH (up i)). cbn [fst snd].
  rewrite climb_up. change (up (climb n i)) with (climb (S n) i). f_equal; ring.
Qed.
Definition above (i j : nat) (w : nat * nat) : Prop := match snd w with O => i = climb (fst w) j | _ => j = climb (fst w) i /\ (0 < fst w)%nat end.
Definition difference (i j : nat) (w : nat * nat) : R * R := match snd w with O => gains (fst w) j | _ => (- fst (gains (fst w) i), - snd (gains (fst w) i)) end.
Lemma congruent_eq x y : x = y -> congruent x y.
Proof. intros ->. split; intros; (apply (whole_eq 0); [apply whole_0|ring]). Qed.
Theorem heights_by_chain : exists rise, heights l1 l2 l3 r system tiles rise.
Proof.
  apply (reduced above difference).
  - intros i. exists (0, 0)%nat. reflexivity.
  - intros i s j s' k [n b] M A. unfold above in A; cbn [fst snd] in A. destruct (meets_up _ _ _ _ M) as [[-> [-> ->]]|[-> [-> ->]]].
    + destruct b as [|b].
      * subst i. exists (S n, 0)%nat. split; [reflexivity|]. unfold difference; cbn [fst snd]. apply congruent_eq. rewrite gains_last. unfold gain; cbn [fst snd]. f_equal; ring.
      * destruct A as [A N]. destruct n as [|n]; [lia|]. unfold climb in A. rewrite <- (Nat.add_1_r n) in A. change (Nat.iter (n + 1) up i) with (climb (n + 1) i) in A. rewrite climb_add in A. change (climb 1 i) with (up i) in A.
        destruct n as [|n].
        -- exists (0, 0)%nat. split; [unfold above; cbn; auto|]. unfold difference; cbn [fst snd gains]. apply congruent_eq. unfold gain; cbn [fst snd]. f_equal; ring.
        -- exists (S n, 1)%nat. split; [unfold above; cbn [fst snd]; split; [exact A|lia]|]. unfold difference; cbn [fst snd]. apply congruent_eq.
           change (gains (S (S n)) i) with (fst (gain i) + fst (gains (S n) (up i)), snd (gain i) + snd (gains (S n) (up i))). unfold gain; cbn [fst snd]. f_equal; ring.
    + destruct b as [|b].
      * destruct n as [|n].
        -- cbn in A. subst k. exists (1, 1)%nat. split; [unfold above; cbn; auto|]. unfold difference; cbn [fst snd gains]. apply congruent_eq. unfold gain; cbn [fst snd]. f_equal; ring.
        -- change (climb (S n) k) with (up (climb n k)) in A. apply up_inj in A. subst j. exists (n, 0)%nat. split; [reflexivity|]. unfold difference; cbn [fst snd]. apply congruent_eq.
           rewrite gains_last. unfold gain; cbn [fst snd]. rewrite (surjective_pairing (gains n k)) at 1. f_equal; ring.
      * destruct A as [A N]. exists (S n, 1)%nat. split.
        -- unfold above; cbn [fst snd]. split; [|lia]. rewrite <- (Nat.add_1_r n), climb_add. exact A.
        -- unfold difference; cbn [fst snd]. apply congruent_eq. cbn [gains]. unfold gain; cbn [fst snd]. f_equal; ring.
  - intros i k [n b] [n' b'] A A'. unfold above in *; cbn [fst snd] in *. apply congruent_eq. unfold difference; cbn [fst snd].
    assert (U : forall m m' x y, y = climb m x -> y = climb m' x -> m = m').
    { assert (W : forall m m' x, (m <= m')%nat -> climb m x = climb m' x -> m = m').
      { intros m m' x L E. replace m' with (m + (m' - m))%nat in E by lia. rewrite climb_add in E. apply climb_inj in E. symmetry in E. apply climb_fix in E. lia. }
      intros m m' x y E1 E2. rewrite E1 in E2. destruct (Nat.le_ge_cases m m') as [L|L]; [apply (W _ _ _ L E2)|symmetry; apply (W _ _ _ L (eq_sym E2))]. }
    assert (X : forall m m' x y, y = climb m x -> x = climb m' y -> m = 0%nat /\ m' = 0%nat).
    { intros m m' x y E1 E2. rewrite E1, <- climb_add in E2. symmetry in E2. apply climb_fix in E2. lia. }
    destruct b as [|b], b' as [|b'].
    + rewrite (U _ _ _ _ A A'). reflexivity.
    + destruct A' as [A' N]. destruct (X _ _ _ _ A A') as [_ ->]. lia.
    + destruct A as [A N]. destruct (X _ _ _ _ A A') as [-> _]. lia.
    + destruct A as [A _], A' as [A' _]. rewrite (U _ _ _ _ A A'). reflexivity.
Qed.
End Chain.
End Heights.
