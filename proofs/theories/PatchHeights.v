(** * Heights of the patches over a mosaic

    The sides of the tiles have directions that are multiples of 30 degrees, in the patch, and
    the offset of a side is half a period for each of them.  So a patch that is turned by k times
    30 degrees is raised by k half periods.  Two tiles that meet are turned against each other by a
    multiple of 30 degrees.  For each tile the number k is counted from the first tile, in the order
    of their numbers, that is turned against it by such a multiple: no path from tile to tile is needed. *)
Require Import Reals Lra Psatz ZArith List Lia Bool ConstructiveEpsilon.
From Acutile Require Import Statement Sums Crossing Tetrahedra PatchStatement PatchChecker PatchGeometry PatchSoundness.
Import ListNotations.
Open Scope R_scope.

(** ** Rotations by 30 degrees *)
Definition rot1 (v : R * R) : R * R := (sqrt 3 / 2 * fst v - / 2 * snd v, / 2 * fst v + sqrt 3 / 2 * snd v).
Definition rot (n : nat) (v : R * R) : R * R := Nat.iter n rot1 v.
Lemma rot_S n v : rot (S n) v = rot1 (rot n v).
Proof. reflexivity. Qed.
Lemma rot_add a b v : rot (a + b) v = rot a (rot b v).
Proof. induction a as [|a IH]; [reflexivity|]. rewrite Nat.add_succ_l, !rot_S, IH. reflexivity. Qed.
Lemma rot_2 v : rot 2 v = (/ 2 * fst v - sqrt 3 / 2 * snd v, sqrt 3 / 2 * fst v + / 2 * snd v).
Proof.
  unfold rot, rot1; cbn [Nat.iter nat_rect fst snd]. pose proof root3 as Q. set (r := sqrt 3) in *. f_equal.
  - transitivity ((r * r - 1) / 4 * fst v - r / 2 * snd v); [field|rewrite Q; field].
  - transitivity (r / 2 * fst v + (r * r - 1) / 4 * snd v); [field|rewrite Q; field].
Qed.
Lemma rot_3 v : rot 3 v = (- snd v, fst v).
Proof.
  rewrite rot_S, rot_2. unfold rot1; cbn [fst snd]. pose proof root3 as Q. set (r := sqrt 3) in *. f_equal.
  - transitivity (- ((r * r + 1) / 4) * snd v); [field|rewrite Q; field].
  - transitivity ((r * r + 1) / 4 * fst v); [field|rewrite Q; field].
Qed.
Lemma rot_6 v : rot 6 v = (- fst v, - snd v).
Proof. change 6%nat with (3 + 3)%nat. rewrite rot_add, !rot_3. reflexivity. Qed.
Lemma rot_12 v : rot 12 v = v.
Proof. change 12%nat with (6 + 6)%nat. rewrite rot_add, !rot_6. destruct v; cbn [fst snd]. f_equal; ring. Qed.
Lemma rot_mod n v : exists k, (k < 12)%nat /\ rot n v = rot k v.
Proof.
  exists (n mod 12)%nat. split; [apply Nat.mod_upper_bound; lia|]. rewrite (Nat.div_mod n 12) at 1 by lia.
  rewrite Nat.add_comm, rot_add. f_equal. induction (n / 12)%nat as [|q IH]; [reflexivity|].
  rewrite Nat.mul_succ_r, rot_add, rot_12. exact IH.
Qed.
Definition length_of (v : R * R) := fst v * fst v + snd v * snd v.
Lemma rot_length n v : length_of (rot n v) = length_of v.
Proof.
  induction n as [|n IH]; [reflexivity|]. rewrite rot_S, <- IH. unfold length_of, rot1; cbn [fst snd]. pose proof root3 as Q.
  set (r := sqrt 3) in *. set (w := rot n v). transitivity ((r * r + 1) / 4 * (fst w * fst w + snd w * snd w)); [field|rewrite Q; field].
Qed.
Lemma rot_quarters q v : rot (3 * (2 * q + 1)) v = (- snd v, fst v) \/ rot (3 * (2 * q + 1)) v = (snd v, - fst v).
Proof.
  induction q as [|q IH]; [left; apply rot_3|]. replace (3 * (2 * S q + 1))%nat with (6 + 3 * (2 * q + 1))%nat by lia.
  rewrite rot_add, rot_6. destruct IH as [-> | ->]; cbn [fst snd]; [right|left]; f_equal; ring.
Qed.
Lemma rot_odd q v : rot (2 * q + 1) v = v -> length_of v = 0.
Proof.
  intros E. assert (E3 : rot (3 * (2 * q + 1)) v = v).
  { revert E. generalize (2 * q + 1)%nat. intros n E. replace (3 * n)%nat with (n + (n + n))%nat by lia. rewrite !rot_add, !E. reflexivity. }
  destruct (rot_quarters q v) as [T|T]; rewrite E3 in T; apply (f_equal fst) in T as T1; apply (f_equal snd) in T; cbn [fst snd] in *; unfold length_of; rewrite T; nra.
Qed.
Lemma rot_parity a b v : length_of v = 1 -> rot a v = rot b v -> exists q, (a + b = 2 * q)%nat.
Proof.
  intros U. assert (W : forall a b, (a <= b)%nat -> rot a v = rot b v -> exists q, (a + b = 2 * q)%nat).
  { clear a b. intros a b L E. destruct (Nat.Even_or_Odd (b - a)) as [[q Q]|[q Q]]; [exists (a + q)%nat; lia|].
    exfalso. replace b with ((2 * q + 1) + a)%nat in E by lia. rewrite rot_add in E. symmetry in E. apply rot_odd in E.
    rewrite rot_length in E. lra. }
  intros E. destruct (Nat.le_ge_cases a b) as [L|L]; [apply W; auto|]. destruct (W b a L (eq_sym E)) as [q Q]. exists q. lia.
Qed.

(** ** The directions of sides *)
Definition circle : list (zz * zz) := [((24, 0), (0, 0)); ((0, 12), (12, 0)); ((12, 0), (0, 12)); ((0, 0), (24, 0));
  ((-12, 0), (0, 12)); ((0, -12), (12, 0)); ((-24, 0), (0, 0)); ((0, -12), (-12, 0)); ((-12, 0), (0, -12)); ((0, 0), (-24, 0));
  ((12, 0), (0, -12)); ((0, 12), (-12, 0))]%Z.
Definition on_circle (t : nat) : zz * zz := nth t circle (zint 0, zint 0).
Definition spin (c : zz * zz) (v : R * R) : R * R :=
  (/ 24 * (surd (fst c) * fst v - surd (snd c) * snd v), / 24 * (surd (fst c) * snd v + surd (snd c) * fst v)).
Lemma circle_rot t v : (t < 12)%nat -> rot t v = spin (on_circle t) v.
Proof.
  assert (STEP : forall t, (t < 11)%nat -> let c := on_circle t in let c' := on_circle (S t) in
    zadd (fst c') (fst c') = zsub (zmul (0, 1)%Z (fst c)) (snd c) /\ zadd (snd c') (snd c') = zadd (fst c) (zmul (0, 1)%Z (snd c))).
  { clear t. intros t. do 11 (destruct t as [|t]; [intros; split; reflexivity|]). lia. }
  induction t as [|t IH]; intros T.
  - destruct v. unfold spin, on_circle, surd; cbn [nth circle fst snd]. unfold rot; cbn. f_equal; field.
  - rewrite rot_S, IH by lia. destruct (STEP t ltac:(lia)) as [A B]. apply (f_equal surd) in A, B. rewrite surd_add, surd_sub, surd_mul in A.
    rewrite !surd_add, surd_mul in B. replace (surd (0, 1)%Z) with (sqrt 3) in * by (unfold surd; cbn [fst snd]; ring).
    unfold rot1, spin; cbn [fst snd]. set (r := sqrt 3) in *. set (a := surd (fst (on_circle t))) in *. set (b := surd (snd (on_circle t))) in *.
    replace (surd (fst (on_circle (S t)))) with (/ 2 * (r * a - b)) by lra. replace (surd (snd (on_circle (S t)))) with (/ 2 * (a + r * b)) by lra.
    f_equal; field.
Qed.

(** Side s of patch a has the direction of 30 degrees times [heading a s], and so many half periods as offset. *)
Section Heights.
Variables (system : list patch) (h : hints) (heading : nat -> nat -> nat).
Definition check_headings : bool := forallb (fun a => let p := patch_at system a in forallb (fun s =>
  let t := heading a s in let H := height (start (edge_at p s)) in
  (t <? 12)%nat && zeq (ahead (vector p s)) (fst (on_circle t)) && zeq (aside (vector p s)) (snd (on_circle t)) &&
  (snd H =? 0)%Z && ((fst H - 12 * Z.of_nat t) mod 24 =? 0)%Z) (seq 0 (side_count p))) (seq 0 (length system)).
Hypothesis checked : check_system system h = true.
Hypothesis headed : check_headings = true.
Variable tiles : nat -> tile.
Hypothesis tiling : mosaic system tiles.
Notation kind i := (shape (tiles i)).
Notation patch_of i := (patch_of system tiles i).
Notation sides i := (sides system tiles i).
Notation corner_of i s := (corner_of system tiles i s).
Notation meets i s j s' := (meets system tiles i s j s').
Notation direction i s := (direction system tiles i s).

(** ** The side that a side meets *)
Definition same (X Y : R * R) : bool := (if Req_EM_T (fst X) (fst Y) then true else false) && (if Req_EM_T (snd X) (snd Y) then true else false).
Lemma same_t X Y : same X Y = true <-> X = Y.
Proof.
  destruct X as [a b], Y as [c d]. unfold same; cbn [fst snd]. destruct (Req_EM_T a c), (Req_EM_T b d); cbn; split; intros E; try discriminate; congruence.
Qed.
Definition meetsb i s j s' : bool := (s <? sides i)%nat && (s' <? sides j)%nat && negb (i =? j)%nat &&
  same (corner_of i s) (corner_of j (next (sides j) s')) && same (corner_of i (next (sides i) s)) (corner_of j s').
Lemma meetsb_t i s j s' : meetsb i s j s' = true <-> meets i s j s'.
Proof. unfold meetsb, PatchStatement.meets. rewrite !andb_true_iff, negb_true_iff, !Nat.ltb_lt, Nat.eqb_neq, !same_t. tauto. Qed.
Lemma neighbour i s : {js : nat * nat | (s < sides i)%nat -> meets i s (fst js) (snd js)}.
Proof.
  destruct (lt_dec s (sides i)) as [Hs|Hs]; [|exists (0, 0)%nat; intros; lia].
  assert (X : exists j, existsb (meetsb i s j) (seq 0 (sides j)) = true).
  { destruct (mosaic_edge_to_edge _ _ tiling i s Hs) as [j [s' M]]. exists j. apply existsb_exists. exists s'.
    split; [apply in_seq; destruct M as [_ [M _]]; lia|apply meetsb_t, M]. }
  destruct (constructive_indefinite_ground_description_nat (fun j => existsb (meetsb i s j) (seq 0 (sides j)) = true) (fun j => bool_dec _ _) X) as [j Hj].
  destruct (find (meetsb i s j) (seq 0 (sides j))) as [s'|] eqn:F.
  - exists (j, s'). intros _. apply find_some in F as [_ F]. apply meetsb_t, F.
  - exfalso. apply existsb_exists in Hj as [s' [I M]]. pose proof (find_none _ _ F s' I). congruence.
Qed.
Definition across_side i s : nat * nat := proj1_sig (neighbour i s).
Lemma across_chosen i s : (s < sides i)%nat -> meets i s (fst (across_side i s)) (snd (across_side i s)).
Proof. intros Hs. unfold across_side. destruct (neighbour i s) as [js M]. apply M, Hs. Qed.

(** ** Tiles that meet are turned by a multiple of 30 degrees *)
Lemma headings a s : (a < length system)%nat -> (s < side_count (patch_at system a))%nat -> let t := heading a s in let p := patch_at system a in
  (t < 12)%nat /\ ahead (vector p s) = fst (on_circle t) /\ aside (vector p s) = snd (on_circle t) /\
  exists q, height (start (edge_at p s)) = zint (12 * Z.of_nat t + 24 * q).
Proof.
  intros Ha Hs. pose proof headed as K. unfold check_headings in K. rewrite forallb_forall in K. specialize (K a ltac:(apply in_seq; lia)).
  cbv zeta in *. rewrite forallb_forall in K. specialize (K s ltac:(apply in_seq; lia)). rewrite !andb_true_iff in K.
  destruct K as [[[[K1 K2] K3] K4] K5]. apply Nat.ltb_lt in K1. apply zeq_ok in K2, K3. apply Z.eqb_eq in K4, K5.
  repeat split; auto. destruct (height (start (edge_at (patch_at system a) s))) as [H H']. cbn [fst snd] in *. subst H'.
  exists ((H - 12 * Z.of_nat (heading a s)) / 24)%Z. unfold zint. f_equal. pose proof (Z.div_mod (H - 12 * Z.of_nat (heading a s)) 24). lia.
Qed.
Lemma direction_rot i s : (s < sides i)%nat -> direction i s = rot (heading (kind i) s) (along (tiles i)).
Proof.
  intros Hs. destruct (headings (kind i) s) as [T [A [B _]]]; [apply (mosaic_shapes _ _ tiling)|exact Hs|]. cbv zeta in *.
  rewrite circle_rot by auto. rewrite direction_value. cbv zeta. unfold spin.
  change (patch_at system (kind i)) with (patch_of i) in *. rewrite A, B. reflexivity.
Qed.
Lemma meets_rot i s j s' : meets i s j s' -> along (tiles j) = rot (18 + heading (kind i) s - heading (kind j) s') (along (tiles i)).
Proof.
  intros M. pose proof M as [Hs [Hs' _]]. destruct (meets_turned system tiles _ _ _ _ M) as [_ D].
  rewrite !direction_rot, <- rot_6, <- rot_add in D by auto.
  destruct (headings (kind j) s') as [T _]; [apply (mosaic_shapes _ _ tiling)|exact Hs'|]. cbv zeta in T.
  apply (f_equal (rot (12 - heading (kind j) s'))) in D. rewrite <- !rot_add in D.
  replace (12 - heading (kind j) s' + heading (kind j) s')%nat with 12%nat in D by lia. rewrite rot_12 in D. rewrite D. f_equal. lia.
Qed.

(** ** The first tile that is turned against a given one by such a multiple *)
Definition turned (i j k : nat) : bool := same (along (tiles i)) (rot k (along (tiles j))).
Definition related (i j : nat) : bool := existsb (turned i j) (seq 0 12).
Lemma related_rot i i' m j : along (tiles i') = rot m (along (tiles i)) -> related i j = true -> related i' j = true.
Proof.
  intros E K. apply existsb_exists in K as [k [_ K]]. apply same_t in K. destruct (rot_mod (m + k) (along (tiles j))) as [n [L R]].
  apply existsb_exists. exists n. split; [apply in_seq; lia|]. apply same_t. rewrite E, K, <- rot_add. exact R.
Qed.
Lemma find_first f n : forall a r, find f (seq a n) = Some r -> f r = true /\ forall j, (a <= j < r)%nat -> f j = false.
Proof.
  induction n as [|n IH]; intros a r; cbn [seq find]; [discriminate|]. destruct (f a) eqn:F.
  - intros E. injection E as <-. split; auto. lia.
  - intros E. destruct (IH _ _ E) as [A B]. split; auto. intros j J. destruct (Nat.eq_dec j a) as [->|]; auto. apply B. lia.
Qed.
Definition first (i : nat) : nat := match find (related i) (seq 0 (S i)) with Some j => j | None => i end.
Lemma first_spec i : related i (first i) = true /\ forall j, (j < first i)%nat -> related i j = false.
Proof.
  assert (R : related i i = true).
  { apply existsb_exists. exists 0%nat. split; [apply in_seq; lia|]. apply same_t. reflexivity. }
  unfold first. destruct (find (related i) (seq 0 (S i))) as [r|] eqn:F.
  - apply find_first in F as [A B]. split; auto. intros. apply B. lia.
  - exfalso. pose proof (find_none _ _ F i ltac:(apply in_seq; lia)). congruence.
Qed.
Definition times (i : nat) : nat := match find (turned i (first i)) (seq 0 12) with Some k => k | None => 0%nat end.
Lemma times_spec i : along (tiles i) = rot (times i) (along (tiles (first i))).
Proof.
  destruct (first_spec i) as [R _]. unfold times. destruct (find _ _) as [k|] eqn:F.
  - apply find_some in F as [_ F]. apply same_t, F.
  - apply existsb_exists in R as [k [I K]]. pose proof (find_none _ _ F k I). congruence.
Qed.
Lemma first_meets i s j s' : meets i s j s' -> first j = first i.
Proof.
  intros M. pose proof (meets_rot _ _ _ _ M) as E. pose proof (meets_rot _ _ _ _ (meets_sym system tiles _ _ _ _ M)) as E'.
  destruct (first_spec i) as [A B], (first_spec j) as [A' B'].
  destruct (Nat.lt_trichotomy (first i) (first j)) as [L|[L|L]]; auto; exfalso.
  - apply B' in L. apply (related_rot _ _ _ _ E) in A. congruence.
  - apply B in L. apply (related_rot _ _ _ _ E') in A'. congruence.
Qed.

Definition rise_of (i : nat) : R := / 2 * IZR (Z.of_nat (times i) mod 2).
Theorem heights_exist : walls_agree system tiles rise_of.
Proof.
  intros i s j s' M. pose proof (meets_rot _ _ _ _ M) as E. pose proof (first_meets _ _ _ _ M) as F. pose proof M as [Hs [Hs' _]].
  rewrite (times_spec j), F, (times_spec i), <- rot_add in E.
  apply rot_parity in E as [e E]; [|apply (mosaic_unit _ _ tiling)].
  destruct (headings (kind i) s) as [T [_ [_ [q Q]]]]; [apply (mosaic_shapes _ _ tiling)|exact Hs|].
  destruct (headings (kind j) s') as [T' [_ [_ [q' Q']]]]; [apply (mosaic_shapes _ _ tiling)|exact Hs'|]. cbv zeta in *.
  unfold wall_height. change (PatchStatement.edge_of system tiles i s) with (edge_at (patch_at system (kind i)) s).
  change (PatchStatement.edge_of system tiles j s') with (edge_at (patch_at system (kind j)) s'). rewrite Q, Q', !surd_int. unfold rise_of.
  set (k := times i) in *. set (k' := times j) in *. set (t := heading (kind i) s) in *. set (t' := heading (kind j) s') in *.
  assert (X : exists z, (Z.of_nat k mod 2 - Z.of_nat k' mod 2 + Z.of_nat t - Z.of_nat t' = 2 * z)%Z).
  { exists (Z.of_nat e - 9 - Z.of_nat k' mod 2 - Z.of_nat k / 2 - Z.of_nat k' / 2)%Z. clearbody k k' t t'. clear - E T T'.
    pose proof (Z.div_mod (Z.of_nat k) 2). pose proof (Z.div_mod (Z.of_nat k') 2). lia. }
  destruct X as [z X]. exists (z + q - q')%Z. apply (f_equal IZR) in X. rewrite !minus_IZR, plus_IZR, !minus_IZR, mult_IZR in X.
  rewrite minus_IZR, !plus_IZR, !mult_IZR. lra.
Qed.

(** ** The theorem *)
Theorem patches_over_mosaic : (exists rise, walls_agree system tiles rise) /\
  forall rise, walls_agree system tiles rise -> tiles_space (is_cell system tiles rise) /\ acute_cells (is_cell system tiles rise).
Proof.
  split; [exists rise_of; exact heights_exist|].
  intros rise A. exact (patches_tile system h checked tiles rise tiling across_side across_chosen A).
Qed.
End Heights.
