(** * Corners, keys of edges, and how often a key occurs

    The combinatorial half of the theorem on valences: lemmas about the definitions of
    Checker.v that speak of integers and lists alone. *)
Require Import NArith Nnat ZArith List Lia Bool FMapPositive.
From Acutile Require Import Tetrahedra Degree Checker.
Import ListNotations.

(** Equality of lattice vectors, entry by entry. *)
Ltac z3 := repeat match goal with |- (_, _) = (_, _) => apply f_equal2 end; try reflexivity; lia.
Lemma z3eqb_t a b : z3eqb a b = true <-> a = b.
Proof. destruct a as [[? ?] ?], b as [[? ?] ?]. simpl. rewrite !andb_true_iff, !Z.eqb_eq. intuition congruence. Qed.
Lemma ceqb_t a b : ceqb a b = true <-> a = b.
Proof. destruct a, b. unfold ceqb; simpl. rewrite andb_true_iff, N.eqb_eq, z3eqb_t. intuition congruence. Qed.
Lemma meqb_t a b : meqb a b = true <-> a = Some b.
Proof.
  destruct a as [[[? ?] ?]|], b as [[? ?] ?]; unfold meqb; cbn [fst snd]; [|split; discriminate].
  rewrite !andb_true_iff, !N.eqb_eq, z3eqb_t. intuition congruence.
Qed.

Lemma cshift_shift d n q : cshift (zadd3 n d) q = cshift n (cshift d q).
Proof. destruct q as [v [[? ?] ?]], n as [[? ?] ?], d as [[? ?] ?]. unfold cshift, zadd3; cbn. z3. Qed.
Definition keqb (a b : key) := N.eqb (fst a) (fst b) && end_eqb (snd a) (snd b).
Lemma end_eqb_t a b : end_eqb a b = true <-> a = b.
Proof. destruct a, b. unfold end_eqb; cbn [fst snd]. rewrite andb_true_iff, N.eqb_eq, z3eqb_t. intuition congruence. Qed.
Lemma keqb_t a b : keqb a b = true <-> a = b.
Proof. destruct a, b. unfold keqb; cbn [fst snd]. rewrite andb_true_iff, N.eqb_eq, end_eqb_t. intuition congruence. Qed.
Lemma lookup_indexed v ks : lookup v (indexed ks) = map snd (filter (fun k => N.eqb v (fst k)) ks).
Proof.
  induction ks as [|k ks IH]; cbn [indexed fold_right filter map].
  - unfold lookup. rewrite PositiveMap.gempty. reflexivity.
  - fold (indexed ks). unfold lookup at 1. destruct (N.eqb_spec v (fst k)) as [->|Ne].
    + rewrite PositiveMap.gss. cbn [map]. rewrite IH. reflexivity.
    + rewrite PositiveMap.gso; [exact IH|]. intros X. apply Ne.
      apply (f_equal Npos) in X. rewrite !N.succ_pos_spec in X. apply N.succ_inj; auto.
Qed.
Lemma count_key_filter ks k : count_key (indexed ks) k = length (filter (keqb k) ks).
Proof.
  unfold count_key. rewrite lookup_indexed. induction ks as [|a ks IH]; cbn [filter map]; auto. unfold keqb at 1.
  destruct (N.eqb (fst k) (fst a)); cbn [map filter andb]; auto.
  destruct (end_eqb (snd k) (snd a)); cbn [length]; auto.
Qed.
Lemma filter_map {X Y} (f : X -> Y) (g : Y -> bool) l : filter g (map f l) = map f (filter (fun x => g (f x)) l).
Proof. induction l; cbn; auto. destruct (g (f a)); cbn; rewrite IHl; auto. Qed.
Lemma edge_key_shift n a b : edge_key (cshift n a) (cshift n b) = edge_key a b.
Proof.
  destruct a as [v [[? ?] ?]], b as [w [[? ?] ?]], n as [[? ?] ?]. unfold edge_key, cshift, zadd3, zopp3; cbn. z3.
Qed.
Lemma shift_to a b a' b' : edge_key a b = edge_key a' b' -> let m := zadd3 (snd a) (zopp3 (snd a')) in cshift m a' = a /\ cshift m b' = b.
Proof.
  destruct a as [v [[? ?] ?]], b as [w [[? ?] ?]], a' as [v' [[? ?] ?]], b' as [w' [[? ?] ?]].
  unfold edge_key, cshift, zadd3, zopp3; cbn. intros H. injection H as -> -> X Y Z. split; z3.
Qed.
Lemma pairs4_In i j : In (i, j) pairs4 <-> In i I4 /\ In j I4 /\ i <> j.
Proof.
  unfold pairs4, I4. cbn [In]. split.
  - intros H. repeat (destruct H as [H|H]; [injection H as <- <-; repeat split; auto; lia|]). destruct H.
  - intros [[<-|[<-|[<-|[<-|[]]]]] [[<-|[<-|[<-|[<-|[]]]]] Ne]]; try lia; tauto.
Qed.
