(** * A grid of cells: which boxes meet, without looking at all pairs

    A box has an interval of integers on each axis, and a lattice vector n moves it by
    s n on the first r axes.  [candidates] finds the moved boxes that meet a box, by the
    cells that they have in common.  Only that none is missing matters, [candidates_all]. *)
Require Import NArith ZArith List Bool Lia FMapPositive.
From Acutile Require Import Statement Degree Domain Checker Keys.
Import ListNotations.
Local Open Scope Z_scope.

Definition interval := (Z * Z)%type.
Definition box := (interval * interval * interval)%type.

(** ** Lists of values by a key that need not be one to one *)
Section Buckets.
Context {V : Type}.
Definition buckets := PositiveMap.t (list V).
Definition bucket (m : buckets) (p : positive) : list V := match PositiveMap.find p m with Some l => l | None => [] end.
Definition put (m : buckets) (p : positive) (v : V) : buckets := PositiveMap.add p (v :: bucket m p) m.
Lemma bucket_put m p v q : bucket (put m p v) q = if Pos.eqb q p then v :: bucket m p else bucket m q.
Proof.
  unfold bucket at 1, put. destruct (Pos.eqb_spec q p) as [->|Ne]; [rewrite PositiveMap.gss|rewrite PositiveMap.gso]; auto.
Qed.
Lemma put_In m p v q u : In u (bucket (put m p v) q) <-> q = p /\ u = v \/ In u (bucket m q).
Proof. rewrite bucket_put. destruct (Pos.eqb_spec q p) as [->|Ne]; simpl; intuition auto. Qed.
End Buckets.

Section Grid.
Variables (r : nat) (s : Z).
(** How far the unit vector of an axis moves a box. *)
Definition step (j : nat) : Z := if Nat.ltb j r then s else 1.
Definition meet1 (j : nat) (m : Z) (a b : interval) : bool := (fst a <=? snd b + step j * m) && (fst b + step j * m <=? snd a).
(** The box a, and b moved by n. *)
Definition meet (n : Z3) (a b : box) : bool :=
  let '(a0, a1, a2) := a in let '(b0, b1, b2) := b in let '(x, y, z) := n in meet1 0 x a0 b0 && meet1 1 y a1 b1 && meet1 2 z a2 b2.

Definition proper (b : box) : bool := let '(b0, b1, b2) := b in (fst b0 <=? snd b0) && (fst b1 <=? snd b1) && (fst b2 <=? snd b2).

Definition zrange (a b : Z) : list Z := map (fun i => a + Z.of_nat i) (seq 0 (Z.to_nat (b - a + 1))).
Definition cells (b : box) : list Z3 := let '(b0, b1, b2) := b in
  list_prod (list_prod (zrange (fst b0) (snd b0)) (zrange (fst b1) (snd b1))) (zrange (fst b2) (snd b2)).
(** A cell is another one, moved by a lattice vector. *)
Definition reduce1 (j : nat) (c : Z) : Z * Z := if Nat.ltb j r then (c mod s, c / s) else (c, 0).
Definition reduced (c : Z3) : Z3 := let '(x, y, z) := c in (fst (reduce1 0 x), fst (reduce1 1 y), fst (reduce1 2 z)).
Definition layer (c : Z3) : Z3 := let '(x, y, z) := c in (snd (reduce1 0 x), snd (reduce1 1 y), snd (reduce1 2 z)).
(** Not one to one: cells far apart may share a bucket. *)
Definition key_of (c : Z3) : positive := let '(x, y, z) := c in
  let low x := Z.land x 1048575 in Z.to_pos (1 + low x + 1048576 * (low y + 1048576 * low z)).
(** The first cell that two boxes have in common. *)
Definition first1 (j : nat) (m : Z) (a b : interval) : Z := Z.max (fst a) (fst b + step j * m).
Definition first_cell (n : Z3) (a b : box) : Z3 :=
  let '(a0, a1, a2) := a in let '(b0, b1, b2) := b in let '(x, y, z) := n in (first1 0 x a0 b0, first1 1 y a1 b1, first1 2 z a2 b2).

Section Values.
Context {X : Type}.
Definition grid := @buckets (box * X * Z3).
Definition enter (m : grid) (e : box * X) : grid :=
  fold_left (fun m c => put m (key_of (reduced c)) (e, layer c)) (cells (fst e)) m.
Definition grid_of (l : list (box * X)) : grid := fold_left enter l (PositiveMap.empty _).
Definition found (a : box) (c : Z3) (e : box * X * Z3) (l : list (X * Z3)) : list (X * Z3) :=
  let n := zadd3 (layer c) (zopp3 (snd e)) in
  if z3eqb c (first_cell n a (fst (fst e))) then (snd (fst e), n) :: l else l.
Definition candidates (m : grid) (a : box) : list (X * Z3) :=
  fold_left (fun l c => fold_left (fun l e => found a c e l) (bucket m (key_of (reduced c))) l) (cells a) [].
End Values.


(** ** Nothing is missing *)
Lemma zrange_In a b x : In x (zrange a b) <-> a <= x <= b.
Proof.
  unfold zrange. rewrite in_map_iff. split.
  - intros [i [<- Hi]]. apply in_seq in Hi. lia.
  - intros H. exists (Z.to_nat (x - a)). split; [lia|]. apply in_seq. lia.
Qed.
Lemma cells_In b c : In c (cells b) <-> let '(b0, b1, b2) := b in let '(x, y, z) := c in
  fst b0 <= x <= snd b0 /\ fst b1 <= y <= snd b1 /\ fst b2 <= z <= snd b2.
Proof. destruct b as [[b0 b1] b2], c as [[x y] z]. unfold cells. rewrite !in_prod_iff, !zrange_In. tauto. Qed.

Section Complete.
Context {X : Type}.
Lemma enter_In (e : box * X) (m : grid) p v :
  (In v (bucket m p) -> In v (bucket (enter m e) p)) /\
  (forall c, In c (cells (fst e)) -> p = key_of (reduced c) -> v = (e, layer c) -> In v (bucket (enter m e) p)).
Proof.
  unfold enter. generalize (cells (fst e)) as l. intros l. revert m. induction l as [|c l IH]; intros m; cbn [fold_left]; [split; [auto|intros c []]|].
  destruct (IH (put m (key_of (reduced c)) (e, layer c))) as [I1 I2]. split.
  - intros H. apply I1, put_In. auto.
  - intros c' [<-|H] E1 E2; [|eauto]. apply I1, put_In. auto.
Qed.
Lemma grid_of_In (l : list (box * X)) e c : In e l -> In c (cells (fst e)) -> In (e, layer c) (bucket (grid_of l) (key_of (reduced c))).
Proof.
  intros He Hc. unfold grid_of. generalize (PositiveMap.empty (list (box * X * Z3))) as m. revert He.
  induction l as [|e' l IH]; intros He m; [destruct He|destruct He as [<-|He]; cbn [fold_left]; auto].
  assert (K : forall (l : list (box * X)) (m : grid) p v, In v (bucket m p) -> In v (bucket (fold_left enter l m) p)).
  { clear. induction l as [|e l IH]; intros m p v H; cbn [fold_left]; auto. apply IH, enter_In, H. }
  apply K. apply (enter_In e' m _ (e', layer c)) with (c := c); auto.
Qed.
Lemma candidates_In (m : grid) a c (e : box * X * Z3) n : In c (cells a) -> In e (bucket m (key_of (reduced c))) ->
  n = zadd3 (layer c) (zopp3 (snd e)) -> c = first_cell n a (fst (fst e)) -> In (snd (fst e), n) (candidates m a).
Proof.
  intros Hc He -> Ef. unfold candidates.
  assert (F : forall c e l (y : X * Z3), In y l -> In y (found a c e l)).
  { intros c' e' l y H. unfold found. destruct (z3eqb _ _); simpl; auto. }
  assert (F2 : forall c es l (y : X * Z3), In y l -> In y (fold_left (fun l e => found a c e l) es l)).
  { intros c' es. induction es as [|e' es IH]; intros l y H; cbn [fold_left]; auto. }
  assert (F3 : forall cs l (y : X * Z3), In y l -> In y (fold_left (fun l c => fold_left (fun l e => found a c e l) (bucket m (key_of (reduced c))) l) cs l)).
  { intros cs. induction cs as [|c' cs IH]; intros l y H; cbn [fold_left]; auto. }
  assert (G : forall es l, In e es -> In (snd (fst e), zadd3 (layer c) (zopp3 (snd e))) (fold_left (fun l e => found a c e l) es l)).
  { intros es. induction es as [|e' es IH]; intros l H; [destruct H|destruct H as [->|H]; cbn [fold_left]; auto]. apply F2. unfold found.
    rewrite (proj2 (z3eqb_t _ _) Ef). simpl; auto. }
  generalize (@nil (X * Z3)) as l. revert Hc. generalize (cells a) as cs. intros cs.
  induction cs as [|c' cs IH]; intros Hc l; [destruct Hc|destruct Hc as [->|Hc]; cbn [fold_left]; auto].
Qed.
Hypothesis s_pos : 0 < s.
Lemma reduce1_moved j c n : (Nat.ltb j r = false -> n = 0) ->
  fst (reduce1 j (c - step j * n)) = fst (reduce1 j c) /\ snd (reduce1 j (c - step j * n)) = snd (reduce1 j c) - n.
Proof.
  intros H. unfold reduce1, step. destruct (Nat.ltb j r); cbn [fst snd].
  - replace (c - s * n) with (c + (- n) * s) by ring. rewrite Z_mod_plus_full, Z_div_plus_full by lia. lia.
  - rewrite (H eq_refl), Z.mul_0_r. split; ring.
Qed.
Theorem candidates_all (l : list (box * X)) a b x n : In (b, x) l -> proper a = true -> proper b = true -> latb r n = true -> meet n a b = true -> In (x, n) (candidates (grid_of l) a).
Proof.
  intros Hl Pa Pb Hn M. destruct a as [[a0 a1] a2] eqn:Ea, b as [[b0 b1] b2] eqn:Eb, n as [[i j] k] eqn:En.
  unfold meet, meet1, proper in *. rewrite !andb_true_iff, !Z.leb_le in *. apply latb_iff in Hn.
  assert (L : (Nat.ltb 0 r = false -> i = 0) /\ (Nat.ltb 1 r = false -> j = 0) /\ (Nat.ltb 2 r = false -> k = 0)).
  { destruct r as [|[|[|r']]]; cbn in *; repeat split; intros; try discriminate; try tauto. }
  destruct L as [L0 [L1 L2]].
  set (c := first_cell n a b).
  assert (C : c = (first1 0 i a0 b0, first1 1 j a1 b1, first1 2 k a2 b2)) by (unfold c; rewrite Ea, Eb, En; reflexivity).
  set (c' := (first1 0 i a0 b0 - step 0 * i, first1 1 j a1 b1 - step 1 * j, first1 2 k a2 b2 - step 2 * k)).
  assert (I : In c (cells a)).
  { rewrite Ea, cells_In, C. unfold first1. clear - M Pa Pb. lia. }
  assert (I' : In c' (cells b)).
  { rewrite Eb, cells_In. unfold c', first1. clear - M Pa Pb. lia. }
  destruct (reduce1_moved 0 (first1 0 i a0 b0) i L0) as [R0 S0]. destruct (reduce1_moved 1 (first1 1 j a1 b1) j L1) as [R1 S1].
  destruct (reduce1_moved 2 (first1 2 k a2 b2) k L2) as [R2 S2].
  assert (RE : reduced c' = reduced c) by (rewrite C; unfold reduced, c'; rewrite R0, R1, R2; reflexivity).
  rewrite <- Ea, <- En.
  apply (candidates_In (grid_of l) a c ((b, x), layer c') n); auto.
  - rewrite <- RE. apply grid_of_In; [rewrite Eb; exact Hl|]. exact I'.
  - rewrite En, C. unfold layer, c'; cbn [snd]. rewrite S0, S1, S2. unfold zadd3, zopp3. z3.
Qed.
End Complete.
End Grid.
