(* Finite sums in Z over lists, and the sign-reversing involution lemma. *)
Require Import Reals Lra ZArith List Lia Permutation Bool.
Import ListNotations.
Open Scope Z_scope.

Fixpoint zsum {A} (f : A -> Z) (l : list A) : Z :=
  match l with [] => 0 | x :: l => f x + zsum f l end.

Lemma zsum_ext {A} (f g : A -> Z) l :
  (forall x, In x l -> f x = g x) -> zsum f l = zsum g l.
Proof. induction l as [|x l IH]; intros H; simpl; auto.
  rewrite (H x) by (left; auto). rewrite IH; auto. intros; apply H; right; auto. Qed.

Lemma zsum_app {A} (f : A -> Z) l l' : zsum f (l ++ l') = zsum f l + zsum f l'.
Proof. induction l; simpl; lia. Qed.

Lemma zsum_opp {A} (f : A -> Z) l : zsum (fun x => - f x) l = - zsum f l.
Proof. induction l; simpl; lia. Qed.

Lemma zsum_sub {A} (f g : A -> Z) l : zsum (fun x => f x - g x) l = zsum f l - zsum g l.
Proof. induction l; simpl; lia. Qed.

Lemma zsum_mull {A} c (f : A -> Z) l : zsum (fun x => c * f x) l = c * zsum f l.
Proof. induction l; simpl; lia. Qed.

Lemma zsum_map {A B} (h : A -> B) (f : B -> Z) l : zsum f (map h l) = zsum (fun x => f (h x)) l.
Proof. induction l; simpl; lia. Qed.

Lemma zsum_perm {A} (f : A -> Z) l l' : Permutation l l' -> zsum f l = zsum f l'.
Proof. induction 1; simpl; lia. Qed.

Lemma zsum_prod {A B} (f : A * B -> Z) (l : list A) (l' : list B) :
  zsum f (list_prod l l') = zsum (fun a => zsum (fun b => f (a, b)) l') l.
Proof. induction l; simpl; auto. rewrite zsum_app, zsum_map, IHl. auto. Qed.

Lemma zsum_filter_nz {A} (f : A -> Z) l :
  zsum f l = zsum f (filter (fun x => negb (f x =? 0)) l).
Proof. induction l; simpl; auto. destruct (Z.eqb_spec (f a) 0); simpl; lia. Qed.

Lemma zsum_zero {A} (f : A -> Z) l : (forall x, In x l -> f x = 0) -> zsum f l = 0.
Proof. intros H. rewrite (zsum_ext f (fun _ => 0)) by auto. clear H. induction l; simpl; lia. Qed.

Lemma NoDup_map_inj_on {A B} (s : A -> B) (l : list A) :
  NoDup l -> (forall x y, In x l -> In y l -> s x = s y -> x = y) -> NoDup (map s l).
Proof.
  induction 1 as [|x l Hx Hl IH]; intros Hinj; simpl; constructor.
  - rewrite in_map_iff. intros [y [E Hy]]. apply Hx.
    rewrite <- (Hinj y x); auto; [right | left]; auto.
  - apply IH. intros; apply Hinj; auto; right; auto.
Qed.

Lemma zsum_invol {A} (l : list A) (g : A -> Z) (s : A -> A) :
  NoDup l ->
  (forall x, In x l -> g x <> 0 -> In (s x) l /\ g (s x) = - g x /\ s (s x) = x) ->
  zsum g l = 0.
Proof.
  intros ND H. rewrite zsum_filter_nz.
  set (l' := filter _ l).
  assert (ND' : NoDup l') by (apply NoDup_filter; auto).
  assert (H' : forall x, In x l' -> In (s x) l' /\ g (s x) = - g x /\ s (s x) = x).
  { intros x Hx. unfold l' in *. apply filter_In in Hx as [Hx E].
    apply negb_true_iff, Z.eqb_neq in E.
    destruct (H x Hx E) as [H1 [H2 H3]]. repeat split; auto.
    apply filter_In. split; auto. apply negb_true_iff, Z.eqb_neq. lia. }
  clearbody l'.
  assert (P : Permutation (map s l') l').
  { apply NoDup_Permutation_bis.
    - apply NoDup_map_inj_on; auto. intros x y Hx Hy E.
      destruct (H' x Hx) as [_ [_ Ex]]. destruct (H' y Hy) as [_ [_ Ey]]. congruence.
    - rewrite map_length. auto.
    - intros y Hy. apply in_map_iff in Hy as [x [<- Hx]]. apply H'; auto. }
  apply (zsum_perm g) in P. rewrite zsum_map in P.
  rewrite (zsum_ext (fun x => g (s x)) (fun x => - g x)) in P by (intros; apply H'; auto).
  rewrite zsum_opp in P. lia.
Qed.

(* counting *)
Lemma zsum_b2z_nonneg {A} (f : A -> bool) l : 0 <= zsum (fun x => Z.b2z (f x)) l.
Proof. induction l; simpl; [lia|]. destruct (f a); cbn [Z.b2z]; lia. Qed.

Lemma zsum_b2z_pos {A} (f : A -> bool) l :
  0 < zsum (fun x => Z.b2z (f x)) l -> exists x, In x l /\ f x = true.
Proof.
  induction l; simpl; try lia. destruct (f a) eqn:E; cbn [Z.b2z]; intros.
  - exists a; auto.
  - destruct IHl as [x [? ?]]; [simpl in *; lia | exists x; auto].
Qed.

Lemma zsum_b2z_ge1 {A} (f : A -> bool) l x :
  In x l -> f x = true -> 1 <= zsum (fun x => Z.b2z (f x)) l.
Proof.
  induction l; simpl; [tauto|]. intros [->|H] E.
  - rewrite E; cbn [Z.b2z]. pose proof (zsum_b2z_nonneg f l). lia.
  - specialize (IHl H E). destruct (f a); cbn [Z.b2z]; lia.
Qed.

Lemma zsum_b2z_ge2 {A} (f : A -> bool) l x y :
  In x l -> In y l -> x <> y -> f x = true -> f y = true ->
  2 <= zsum (fun x => Z.b2z (f x)) l.
Proof.
  induction l; simpl; [tauto|]. intros Hx Hy N Ex Ey.
  destruct Hx as [->|Hx]; destruct Hy as [->|Hy]; try congruence.
  - rewrite Ex; cbn [Z.b2z]. pose proof (zsum_b2z_ge1 f l y Hy Ey). lia.
  - rewrite Ey; cbn [Z.b2z]. pose proof (zsum_b2z_ge1 f l x Hx Ex). lia.
  - specialize (IHl Hx Hy N Ex Ey). destruct (f a); cbn [Z.b2z]; lia.
Qed.

Lemma zsum_single {A} (f : A -> Z) l x :
  NoDup l -> In x l -> (forall y, In y l -> y <> x -> f y = 0) -> zsum f l = f x.
Proof.
  induction 1 as [|a l Ha Hl IH]; simpl; [tauto|]. intros [->|Hx] H.
  - rewrite zsum_zero; [lia|]. intros y Hy. apply H; auto. intros ->; auto.
  - rewrite IH by auto. rewrite (H a); [lia|auto|]. intros ->; auto.
Qed.

(* integer boxes *)
Definition zr (K : nat) : list Z := map (fun j => Z.of_nat j - Z.of_nat K) (seq 0 (2 * K + 1)).
Lemma zr_In K z : In z (zr K) <-> Z.abs z <= Z.of_nat K.
Proof.
  unfold zr. rewrite in_map_iff. split.
  - intros [j [<- Hj]]. apply in_seq in Hj. lia.
  - intros H. exists (Z.to_nat (z + Z.of_nat K)). rewrite in_seq. lia.
Qed.
Lemma zr_NoDup K : NoDup (zr K).
Proof. apply NoDup_map_inj_on; [apply seq_NoDup|]. intros; lia. Qed.


Lemma NoDup_app_disj {A} (l l' : list A) :
  NoDup l -> NoDup l' -> (forall x, In x l -> ~ In x l') -> NoDup (l ++ l').
Proof.
  induction 1 as [|a l Ha Hl IH]; simpl; auto. intros H' orient. constructor.
  - rewrite in_app_iff. intros [|]; auto. apply (orient a); auto.
  - apply IH; auto.
Qed.
Lemma NoDup_list_prod {A B} (l : list A) (l' : list B) :
  NoDup l -> NoDup l' -> NoDup (list_prod l l').
Proof.
  intros H H'. induction H as [|a l Ha Hl IH]; simpl; [constructor|].
  apply NoDup_app_disj; auto.
  - apply NoDup_map_inj_on; auto. intros; congruence.
  - intros [x y] H1 H2. apply in_map_iff in H1 as [? [E ?]]. injection E as -> ->.
    apply in_prod_iff in H2. tauto.
Qed.

(** ** The same over the real numbers *)
Open Scope R_scope.
Fixpoint rsum {A} (f : A -> R) (l : list A) : R :=
  match l with [] => 0 | x :: l => f x + rsum f l end.
Lemma rsum_ext {A} (f g : A -> R) l : (forall x, In x l -> f x = g x) -> rsum f l = rsum g l.
Proof. induction l as [|x l IH]; intros H; simpl; auto.
  rewrite (H x) by (left; auto). rewrite IH; auto. intros; apply H; right; auto. Qed.
Lemma rsum_app {A} (f : A -> R) l l' : rsum f (l ++ l') = rsum f l + rsum f l'.
Proof. induction l; simpl; lra. Qed.
Lemma rsum_sub {A} (f g : A -> R) l : rsum (fun x => f x - g x) l = rsum f l - rsum g l.
Proof. induction l; simpl; lra. Qed.
Lemma rsum_add {A} (f g : A -> R) l : rsum (fun x => f x + g x) l = rsum f l + rsum g l.
Proof. induction l; simpl; lra. Qed.
Lemma rsum_mull {A} c (f : A -> R) l : rsum (fun x => c * f x) l = c * rsum f l.
Proof. induction l; simpl; lra. Qed.
Lemma rsum_map {A B} (h : A -> B) (f : B -> R) l : rsum f (map h l) = rsum (fun x => f (h x)) l.
Proof. induction l; simpl; lra. Qed.
Lemma rsum_perm {A} (f : A -> R) l l' : Permutation l l' -> rsum f l = rsum f l'.
Proof. induction 1; simpl; lra. Qed.
Lemma rsum_prod {A B} (f : A * B -> R) (l : list A) (l' : list B) :
  rsum f (list_prod l l') = rsum (fun a => rsum (fun b => f (a, b)) l') l.
Proof. induction l; simpl; auto. rewrite rsum_app, rsum_map, IHl. auto. Qed.
Lemma rsum_IZR {A} (f : A -> Z) l : IZR (zsum f l) = rsum (fun x => IZR (f x)) l.
Proof. induction l; simpl; auto. rewrite plus_IZR. lra. Qed.
Lemma rsum_nonpos {A} (f : A -> R) l : (forall x, In x l -> f x <= 0) -> rsum f l <= 0.
Proof. induction l; simpl; intros H; [lra|]. pose proof (H a (or_introl eq_refl)). assert (rsum f l <= 0) by auto. lra. Qed.
Lemma rsum_filter {A} (f : A -> R) (b : A -> bool) l :
  (forall x, In x l -> b x = false -> f x = 0) -> rsum f l = rsum f (filter b l).
Proof. induction l; simpl; intros H; auto. destruct (b a) eqn:E; simpl; rewrite IHl by auto; auto. rewrite (H a); auto. lra. Qed.
Lemma rsum_zero {A} (f : A -> R) l : (forall x, In x l -> f x = 0) -> rsum f l = 0.
Proof. intros H. rewrite (rsum_ext f (fun _ => 0)) by auto. clear H. induction l; simpl; lra. Qed.
Lemma rsum_single {A} (f : A -> R) l x : NoDup l -> In x l -> (forall y, In y l -> y <> x -> f y = 0) -> rsum f l = f x.
Proof.
  induction 1 as [|y l Hy Hl IH]; simpl; [tauto|]. intros [->|Hx] H.
  - rewrite rsum_zero; [lra|]. intros z Hz. apply H; auto. intros ->. contradiction.
  - rewrite (H y); auto; [|intros ->; contradiction]. rewrite IH; auto. lra.
Qed.

(** If s pairs the terms that matter and each pair sums to at most zero, so does the whole. *)
Lemma rsum_invol {A} (l : list A) (g : A -> R) (s : A -> A) (b : A -> bool) :
  NoDup l -> (forall x, In x l -> b x = false -> g x = 0) ->
  (forall x, In x l -> b x = true -> In (s x) l /\ b (s x) = true /\ s (s x) = x /\ g x + g (s x) <= 0) ->
  rsum g l <= 0.
Proof.
  intros ND H0 H. rewrite (rsum_filter g b) by auto. set (l' := filter b l).
  assert (ND' : NoDup l') by (apply NoDup_filter; auto).
  assert (H' : forall x, In x l' -> In (s x) l' /\ s (s x) = x /\ g x + g (s x) <= 0).
  { intros x Hx. unfold l' in *. apply filter_In in Hx as [Hx E]. destruct (H x Hx E) as [H1 [H2 [H3 H4]]].
    repeat split; auto. apply filter_In; auto. }
  clearbody l'.
  assert (P : Permutation (map s l') l').
  { apply NoDup_Permutation_bis.
    - apply NoDup_map_inj_on; auto. intros x y Hx Hy E.
      destruct (H' x Hx) as [_ [Ex _]]. destruct (H' y Hy) as [_ [Ey _]]. congruence.
    - rewrite map_length. auto.
    - intros y Hy. apply in_map_iff in Hy as [x [<- Hx]]. apply H'; auto. }
  apply (rsum_perm g) in P. rewrite rsum_map in P.
  assert (rsum (fun x => g x + g (s x)) l' <= 0) by (apply rsum_nonpos; intros; apply H'; auto).
  rewrite rsum_add in H1. lra.
Qed.
