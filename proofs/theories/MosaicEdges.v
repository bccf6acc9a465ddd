(** * Edges: ordered pairs of names, and the facets of a tetrahedron with a given edge

    How often a key of Checker.v occurs is how many things have a given pair of names, up to
    periods ([select_length]).  Nothing here is about mosaics; MosaicAround.v uses it. *)
Require Import Reals Lra Psatz NArith ZArith List Lia Bool Permutation.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Domain Euclid Checker Keys MosaicStatement MosaicPoints MosaicPatches MosaicValences.
From Acutile Require Import Cells.
Import ListNotations.
Open Scope R_scope.

(** ** Ordered pairs of names *)
Lemma ceqb_dec (x y : name) : {x = y} + {x <> y}.
Proof. destruct (ceqb x y) eqn:E; [left; apply ceqb_t, E|right]. intros H. apply ceqb_t in H. congruence. Qed.
Lemma ordered_In l x y : In (x, y) (ordered l) <-> In x l /\ In y l /\ x <> y.
Proof.
  unfold ordered. rewrite in_flat_map. split.
  - intros [z [Hz H]]. apply in_map_iff in H as [w [E H]]. injection E as <- <-. apply filter_In in H as [H N]. apply negb_true_iff in N.
    repeat split; auto. intros E. apply ceqb_t in E. congruence.
  - intros [Hx [Hy N]]. exists x. split; auto. apply in_map, filter_In. split; auto. apply negb_true_iff. destruct (ceqb x y) eqn:E; auto. apply ceqb_t in E. contradiction.
Qed.
Lemma NoDup_flat_map {X Y} (f : X -> list Y) l : NoDup l -> (forall x, In x l -> NoDup (f x)) -> (forall x y z, In x l -> In y l -> In z (f x) -> In z (f y) -> x = y) -> NoDup (flat_map f l).
Proof.
  induction l as [|x l IH]; intros N F D; cbn [flat_map]; [constructor|]. inversion N as [|? ? N1 N2]; subst. apply NoDup_app_disj.
  - apply F. cbn; auto.
  - apply IH; auto; [intros y Hy; apply F; cbn; auto|]. intros y z w Hy Hz. apply D; cbn; auto.
  - intros z H K. apply in_flat_map in K as [y [Hy K]]. assert (x = y) by (apply (D x y z); cbn; auto). subst y. contradiction.
Qed.
Lemma NoDup_map_pair {X Y} (x : X) (l : list Y) : NoDup l -> NoDup (map (pair x) l).
Proof. intros N. apply FinFun.Injective_map_NoDup; auto. intros a b E. congruence. Qed.
Lemma ordered_NoDup l : NoDup l -> NoDup (ordered l).
Proof.
  intros N. apply NoDup_flat_map; auto.
  - intros x _. apply NoDup_map_pair, NoDup_filter, N.
  - intros x y z _ _ H K. apply in_map_iff in H as [? [<- _]]. apply in_map_iff in K as [? [E _]]. congruence.
Qed.
(** Things with pairs of names, and the periods that take a pair of theirs to a given one. *)
Section Select.
Context {T : Type} (things : list T) (pairs_of : T -> list (name * name)).
Hypothesis things_NoDup : NoDup things.
Hypothesis pairs_NoDup : forall t, In t things -> NoDup (pairs_of t).
Definition all_keys : list key := flat_map (fun t => map key_of (pairs_of t)) things.
Definition select (c1 c2 : name) : list (T * Z3) :=
  map (fun x => (fst x, zadd3 (snd c1) (zopp3 (snd (fst (snd x)))))) (filter (fun x => keqb (edge_key c1 c2) (key_of (snd x))) (flat_map (fun t => map (pair t) (pairs_of t)) things)).
Lemma select_length c1 c2 : length (select c1 c2) = count_key (indexed all_keys) (edge_key c1 c2).
Proof.
  unfold select. rewrite map_length, count_key_filter. unfold all_keys. generalize (edge_key c1 c2). intros k. clear things_NoDup pairs_NoDup.
  induction things as [|t l IH]; cbn [flat_map]; [reflexivity|]. rewrite !filter_app, !app_length. rewrite !filter_map, !map_length. f_equal. exact IH.
Qed.
Lemma cshift_inj n a b : cshift n a = cshift n b -> a = b.
Proof.
  destruct a as [v [[? ?] ?]], b as [w [[? ?] ?]], n as [[? ?] ?]. unfold cshift, zadd3; cbn. intros E. injection E as -> X Y Z. f_equal. apply z3_eq; lia.
Qed.
Lemma select_In c1 c2 t n : In (t, n) (select c1 c2) <-> In t things /\ exists p, In p (pairs_of t) /\ cshift n (fst p) = c1 /\ cshift n (snd p) = c2.
Proof.
  unfold select. rewrite in_map_iff. split.
  - intros [[t' p] [E H]]. cbn [fst snd] in E. injection E as -> <-. apply filter_In in H as [H K]. apply in_flat_map in H as [t' [Ht H]]. apply in_map_iff in H as [p' [E Hp]]. injection E as -> ->.
    split; auto. exists p. split; auto. cbn [snd] in K. apply keqb_t in K. unfold key_of in K. exact (shift_to _ _ _ _ K).
  - intros [Ht [p [Hp [E1 E2]]]]. exists (t, p). cbn [fst snd]. split.
    + f_equal. subst c1. destruct p as [[v [[? ?] ?]] y], n as [[? ?] ?]. unfold cshift, zadd3, zopp3; cbn. apply z3_eq; lia.
    + apply filter_In. split; [apply in_flat_map; exists t; split; auto; apply in_map, Hp|]. apply keqb_t. unfold key_of. cbn [snd]. subst c1 c2. apply edge_key_shift.
Qed.
Lemma select_NoDup c1 c2 : NoDup (select c1 c2).
Proof.
  unfold select. apply NoDup_map_inj_on.
  - apply NoDup_filter, NoDup_flat_map; auto.
    + intros t Ht. apply NoDup_map_pair, pairs_NoDup, Ht.
    + intros x y z _ _ H K. apply in_map_iff in H as [? [<- _]]. apply in_map_iff in K as [? [E _]]. congruence.
  - intros [t [x y]] [t' [x' y']] H H' E. cbn [fst snd] in E. injection E as -> E. apply filter_In in H as [_ H], H' as [_ H']. apply keqb_t in H, H'. unfold key_of in H, H'. cbn [fst snd] in H, H'.
    apply shift_to in H as [A B], H' as [A' B']. f_equal. assert (X : zadd3 (snd c1) (zopp3 (snd x)) = zadd3 (snd c1) (zopp3 (snd x'))) by (apply E).
    rewrite <- X in A', B'. f_equal; eapply cshift_inj; [rewrite A', A|rewrite B', B]; reflexivity.
Qed.
End Select.

(** ** Facets of a tetrahedron with two of its vertices *)
Definition corners3 (t : triangle) : list point := [t1 t; t2 t; t3 t].
Lemma turns_corners s t : turns s t -> forall x, In x (corners3 s) <-> In x (corners3 t).
Proof. intros [->|[->| ->]] x; unfold corners3; cbn [t1 t2 t3 In]; tauto. Qed.
Lemma opposite_corners s t : opposite s t -> forall x, In x (corners3 s) <-> In x (corners3 t).
Proof. intros H x. unfold opposite in H. unfold corners3; cbn [In]. destruct H as [[-> [-> ->]]|[[-> [-> ->]]|[-> [-> ->]]]]; tauto. Qed.
Lemma facet_verts t f x : In x (corners3 (facet t f)) -> In x (verts t).
Proof. destruct f as [|[|[|f]]]; unfold corners3, facet, verts; cbn [t1 t2 t3 In]; tauto. Qed.
Lemma verts_vx t x : In x (verts t) <-> exists j, In j I4 /\ vx t j = x.
Proof.
  split.
  - intros H. cbn [verts In] in H. destruct H as [<-|[<-|[<-|[<-|[]]]]]; [exists 0%nat|exists 1%nat|exists 2%nat|exists 3%nat]; (split; [cbn; tauto|reflexivity]).
  - intros [j [H <-]]. cbn in H. destruct H as [<-|[<-|[<-|[<-|[]]]]]; cbn; auto.
Qed.
Lemma vx_facet t j f : In j I4 -> In f I4 -> j <> f -> In (vx t j) (corners3 (facet t f)).
Proof.
  intros J F. cbn in J, F. destruct J as [<-|[<-|[<-|[<-|[]]]]], F as [<-|[<-|[<-|[<-|[]]]]]; intros N; try congruence; cbn; auto.
Qed.
Lemma coord_vx t j f : In j I4 -> In f I4 -> coord t f (vx t j) = if Nat.eqb j f then vol t else 0.
Proof.
  intros J F. cbn in J, F. destruct J as [<-|[<-|[<-|[<-|[]]]]], F as [<-|[<-|[<-|[<-|[]]]]]; cbn [Nat.eqb]; unfold coord, side, vol; cbn [facet vx t1 t2 t3]; unf; ring.
Qed.
Lemma vx_inj t j j' : vol t <> 0 -> In j I4 -> In j' I4 -> vx t j = vx t j' -> j = j'.
Proof.
  intros V J J' E. destruct (Nat.eq_dec j j') as [|N]; auto. exfalso. pose proof (coord_vx t j j J J) as A. pose proof (coord_vx t j' j J' J) as B.
  rewrite Nat.eqb_refl in A. rewrite <- E in B. destruct (Nat.eqb_spec j' j); [congruence|]. lra.
Qed.
Lemma vertex_in_facet t u f : vol t <> 0 -> In u (verts t) -> In f I4 -> (In u (corners3 (facet t f)) <-> coord t f u = 0).
Proof.
  intros V U F. apply verts_vx in U as [j [J <-]]. rewrite coord_vx by auto. split.
  - intros H. destruct (Nat.eqb_spec j f) as [->|]; auto. exfalso.
    assert (X : exists k, In k I4 /\ k <> f /\ vx t k = vx t f).
    { cbn in F. unfold corners3 in H. cbn [In] in H. destruct F as [<-|[<-|[<-|[<-|[]]]]]; cbn [facet t1 t2 t3] in H;
      destruct H as [H|[H|[H|[]]]]; first [exists 0%nat; split; [cbn; tauto|split; [congruence|exact H]]|exists 1%nat; split; [cbn; tauto|split; [congruence|exact H]]
      |exists 2%nat; split; [cbn; tauto|split; [congruence|exact H]]|exists 3%nat; split; [cbn; tauto|split; [congruence|exact H]]]. }
    destruct X as [k [K [N E]]]. apply N. apply (vx_inj t); auto.
  - intros H. destruct (Nat.eqb_spec j f) as [->|N]; [contradiction|]. apply vx_facet; auto.
Qed.
Definition middle (u v : point) : point := scale (/ 2) (add u v).
Lemma middle_affine f u v : affine f -> f (middle u v) = (f u + f v) / 2.
Proof. intros [a [b [c [d E]]]]. rewrite !E. unfold middle. unf. field. Qed.
Lemma middle_coord t f u v : coord t f (middle u v) = (coord t f u + coord t f v) / 2.
Proof. apply middle_affine. apply aff_o. Qed.
Lemma vertex_closed t u : 0 < vol t -> In u (verts t) -> closed t u.
Proof. intros V U f F. apply verts_vx in U as [j [J <-]]. rewrite coord_vx by auto. destruct (Nat.eqb j f); lra. Qed.
Lemma middle_closed t u v : 0 < vol t -> In u (verts t) -> In v (verts t) -> closed t (middle u v).
Proof. intros V U W f F. rewrite middle_coord. pose proof (vertex_closed t u V U f F). pose proof (vertex_closed t v V W f F). lra. Qed.
Lemma middle_facet t u v f : 0 < vol t -> In u (verts t) -> In v (verts t) -> In f I4 -> coord t f (middle u v) = 0 ->
  In u (corners3 (facet t f)) /\ In v (corners3 (facet t f)).
Proof.
  intros V U W F E. rewrite middle_coord in E. pose proof (vertex_closed t u V U f F). pose proof (vertex_closed t v V W f F).
  split; apply vertex_in_facet; auto; lra.
Qed.
(** The middle of an edge carries its ends. *)
Lemma middle_carries t u v : 0 < vol t -> In u (verts t) -> In v (verts t) -> carT t (middle u v) u /\ carT t (middle u v) v.
Proof.
  intros V U W. pose proof (middle_closed t u v V U W) as C.
  assert (E : forall x, In x (verts t) -> (x = u \/ x = v) -> carT t (middle u v) x).
  { intros x Hx X. apply carb_t; auto. unfold carb. apply andb_true_iff. split; [apply closedb_t, C|]. apply verts_vx in Hx as [j [J Ej]]. apply existsb_exists. exists j. split; auto.
    apply andb_true_iff. split; [apply ptb_t; auto|]. unfold posb. destruct (Rlt_dec 0 (coord t j (middle u v))) as [|N]; auto. exfalso. apply N. rewrite middle_coord.
    pose proof (vertex_closed t u V U j J). pose proof (vertex_closed t v V W j J). pose proof (coord_vx t j j J J) as A. rewrite Nat.eqb_refl in A. rewrite Ej in A.
    destruct X as [X|X]; rewrite X in A; lra. }
  split; apply E; auto.
Qed.
(** Two of the four facets have a given edge. *)
Definition facets_with (t : tetrahedron) (u v : point) : list nat := filter (fun f => if dec (In u (corners3 (facet t f)) /\ In v (corners3 (facet t f))) then true else false) I4.
Lemma facets_with_In t u v f : In f (facets_with t u v) <-> In f I4 /\ In u (corners3 (facet t f)) /\ In v (corners3 (facet t f)).
Proof. unfold facets_with. rewrite filter_In. destruct (dec _); intuition discriminate. Qed.
Lemma facets_with_length t u v : 0 < vol t -> In u (verts t) -> In v (verts t) -> u <> v -> length (facets_with t u v) = 2%nat.
Proof.
  intros V U W N. apply verts_vx in U as [j [J Ej]]. apply verts_vx in W as [k [K Ek]].
  assert (E : facets_with t u v = filter (fun f => negb (Nat.eqb j f) && negb (Nat.eqb k f)) I4).
  { unfold facets_with. apply filter_ext_in. intros f F. rewrite <- Ej, <- Ek.
    assert (X : forall i, In i I4 -> (In (vx t i) (corners3 (facet t f)) <-> i <> f)).
    { intros i I. rewrite vertex_in_facet by (auto; try lra; apply verts_vx; eauto). rewrite coord_vx by auto. destruct (Nat.eqb_spec i f); split; intros; auto; try lra; contradiction. }
    pose proof (X j J). pose proof (X k K). destruct (dec _) as [D|D]; destruct (Nat.eqb_spec j f), (Nat.eqb_spec k f); cbn [negb andb]; auto; exfalso; tauto. }
  rewrite E. assert (JK : j <> k) by congruence. clear E Ej Ek N. cbn in J, K. destruct J as [<-|[<-|[<-|[<-|[]]]]], K as [<-|[<-|[<-|[<-|[]]]]]; try congruence; reflexivity.
Qed.
