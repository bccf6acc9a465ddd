(** * Quantities and bounds: how the relations are decided

    A quantity of a tile is the largest or the smallest number of a list.  Four tests
    compare a number with the bound.  They decide the six relations. *)
Require Import Reals Lra List Bool.
From Acutile Require Import Statement.
Import ListNotations.
Open Scope R_scope.

(** The test: less than the bound, at most, at least, more than. *)
Inductive test := TLt | TLe | TGe | TGt.
Definition compares (o : test) (q B : R) : Prop :=
  match o with TLt => q < B | TLe => q <= B | TGe => B <= q | TGt => B < q end.

(** Is there a member with f?  The search ends at the first one, under call by value too. *)
Fixpoint existsl {X} (f : X -> bool) (l : list X) : bool :=
  match l with [] => false | x :: l => if f x then true else existsl f l end.
Lemma existsl_eq {X} (f : X -> bool) l : existsl f l = existsb f l.
Proof. induction l; simpl; auto. rewrite IHl. destruct (f a); auto. Qed.

(** [f o x] tests the number of the item x; the list has one item for each number. *)
Definition test_largest {X} (f : test -> X -> bool) (l : list X) (o : test) : bool :=
  match o with TLt | TLe => forallb (f o) l | TGe | TGt => existsl (f o) l end.
Definition test_smallest {X} (f : test -> X -> bool) (l : list X) (o : test) : bool :=
  match o with TLt | TLe => existsl (f o) l | TGe | TGt => forallb (f o) l end.
(** [f c o] tests the quantity of the tile c. *)
Definition related {X} (rel : relation) (f : X -> test -> bool) (tiles : list X) : bool :=
  let all o := forallb (fun c => f c o) tiles in
  let some o := existsl (fun c => f c o) tiles in
  match rel with
  | LessThan => all TLt
  | AtMost => all TLe
  | Maximum => all TLe && some TGe
  | MoreThan => all TGt
  | AtLeast => all TGe
  | Minimum => all TGe && some TLe
  end.

Lemma largest_exists x l : exists q, largest (x :: l) q.
Proof.
  revert x. induction l as [|y l IH]; intros x.
  - exists x. split; [simpl; auto|]. intros z [<-|[]]. lra.
  - destruct (IH y) as [q [I U]]. destruct (Rle_dec x q) as [L|L].
    + exists q. split; [right; exact I|]. intros z [<-|Hz]; auto.
    + exists x. split; [left; reflexivity|]. intros z [<-|Hz]; [lra|]. specialize (U z Hz). lra.
Qed.
Lemma smallest_exists x l : exists q, smallest (x :: l) q.
Proof.
  revert x. induction l as [|y l IH]; intros x.
  - exists x. split; [simpl; auto|]. intros z [<-|[]]. lra.
  - destruct (IH y) as [q [I U]]. destruct (Rle_dec q x) as [L|L].
    + exists q. split; [right; exact I|]. intros z [<-|Hz]; auto.
    + exists x. split; [left; reflexivity|]. intros z [<-|Hz]; [lra|]. specialize (U z Hz). lra.
Qed.

Section Quantity.
Variables (X : Type) (f : test -> X -> bool) (number : X -> R) (l : list X) (B q : R).
Hypothesis f_ok : forall o x, In x l -> f o x = true -> compares o (number x) B.
Lemma test_largest_ok o : largest (map number l) q -> test_largest f l o = true -> compares o q B.
Proof.
  intros [I U] H. apply in_map_iff in I as [x0 [E I]]. unfold test_largest in H.
  destruct o; [rewrite forallb_forall in H | rewrite forallb_forall in H | rewrite existsl_eq in H; apply existsb_exists in H as [x [Ix H]] ..].
  - rewrite <- E. apply (f_ok TLt); auto.
  - rewrite <- E. apply (f_ok TLe); auto.
  - apply f_ok in H; auto. pose proof (U _ (in_map number _ _ Ix)). cbn in *. lra.
  - apply f_ok in H; auto. pose proof (U _ (in_map number _ _ Ix)). cbn in *. lra.
Qed.
Lemma test_smallest_ok o : smallest (map number l) q -> test_smallest f l o = true -> compares o q B.
Proof.
  intros [I U] H. apply in_map_iff in I as [x0 [E I]]. unfold test_smallest in H.
  destruct o; [rewrite existsl_eq in H; apply existsb_exists in H as [x [Ix H]] | rewrite existsl_eq in H; apply existsb_exists in H as [x [Ix H]] | rewrite forallb_forall in H ..].
  - apply f_ok in H; auto. pose proof (U _ (in_map number _ _ Ix)). cbn in *. lra.
  - apply f_ok in H; auto. pose proof (U _ (in_map number _ _ Ix)). cbn in *. lra.
  - rewrite <- E. apply (f_ok TGe); auto.
  - rewrite <- E. apply (f_ok TGt); auto.
Qed.
End Quantity.

(** s over the smallest number is the largest of the quotients. *)
Lemma largest_quotient s l m : 0 <= s -> (forall x, In x l -> 0 < x) -> smallest l m -> largest (map (fun x => s / x) l) (s / m).
Proof.
  intros S P [I U]. split; [apply (in_map (fun x => s / x)); exact I|]. intros y Hy. apply in_map_iff in Hy as [x [<- Hx]].
  apply Rmult_le_compat_l; auto. apply Rinv_le_contravar; auto.
Qed.

(** The items of the list are the tiles up to the lattice. *)
Section Related.
Variables (T X : Type) (tiles : T -> Prop) (item : T -> X) (l : list X) (of : T -> R -> Prop) (f : X -> test -> bool) (B : R).
Hypothesis item_in : forall c, tiles c -> In (item c) l.
Hypothesis in_item : forall x, In x l -> exists c, tiles c /\ item c = x.
Hypothesis f_ok : forall c, tiles c -> exists q, of c q /\ forall o, f (item c) o = true -> compares o q B.
Lemma all_ok o : forallb (fun c => f c o) l = true -> every tiles of (fun q => compares o q B).
Proof.
  rewrite forallb_forall. intros H c Hc. destruct (f_ok c Hc) as [q [Q K]]. exists q. split; auto.
Qed.
Lemma reached_ok o o' : (forall q, compares o q B -> compares o' q B -> q = B) ->
  forallb (fun c => f c o) l = true -> existsl (fun c => f c o') l = true -> reached tiles of B.
Proof.
  rewrite existsl_eq, forallb_forall, existsb_exists. intros E H [x [Ix H']]. destruct (in_item x Ix) as [c [Hc <-]].
  destruct (f_ok c Hc) as [q [Q K]]. exists c. split; auto. rewrite <- (E q); auto.
Qed.
Theorem related_ok rel : related rel f l = true -> bounded tiles of rel B.
Proof.
  intros H. destruct rel; cbn [related bounded] in *.
  - apply (all_ok TLt H).
  - apply (all_ok TLe H).
  - apply andb_true_iff in H as [H H']. split; [apply (all_ok TLe H)|]. apply (reached_ok TLe TGe); auto. cbn. intros. lra.
  - apply (all_ok TGt H).
  - apply (all_ok TGe H).
  - apply andb_true_iff in H as [H H']. split; [apply (all_ok TGe H)|]. apply (reached_ok TGe TLe); auto. cbn. intros. lra.
Qed.
End Related.
