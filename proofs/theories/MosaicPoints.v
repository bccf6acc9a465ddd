(** * Systems of patches: choice, places in a list, and periods

    What the files about patches share: numbers are chosen from countable sets, a rim is cyclic,
    and a period moves points, triangles and tetrahedra. *)
Require Import Reals Lra ZArith List Lia Bool ConstructiveEpsilon.
From Coq Require Arith.Cantor.
From Acutile Require Import Statement Sums Crossing Tetrahedra Bounds Domain Degree MosaicStatement.
Import ListNotations.
Open Scope R_scope.

(** ** Choice from countable sets *)
Lemma dec (P : Prop) : {P} + {~ P}.
Proof.
  destruct (ClassicalDedekindReals.sig_not_dec P) as [N|N]; [left|right; exact N].
  destruct (Classical_Prop.classic P); tauto.
Qed.
Section Choice.
Context {A : Type} (f : A -> nat) (g : nat -> A) (gf : forall x, g (f x) = x).
Lemma choose (P : A -> Prop) : {x | (exists y, P y) -> P x}.
Proof.
  destruct (dec (exists y, P y)) as [E|E].
  - destruct (constructive_indefinite_ground_description A f g gf P (fun x => dec (P x)) E) as [x Px]. exists x. auto.
  - exists (g 0%nat). tauto.
Qed.
End Choice.
Definition code_z (z : Z) : nat := Cantor.to_nat (Z.to_nat z, Z.to_nat (- z)).
Definition decode_z (n : nat) : Z := let '(a, b) := Cantor.of_nat n in (Z.of_nat a - Z.of_nat b)%Z.
Lemma decode_code z : decode_z (code_z z) = z.
Proof. unfold decode_z, code_z. rewrite Cantor.cancel_of_to. lia. Qed.
Definition code3 (n : Z3) : nat := let '(x, y, z) := n in Cantor.to_nat (code_z x, Cantor.to_nat (code_z y, code_z z)).
Definition decode3 (k : nat) : Z3 := let '(a, b) := Cantor.of_nat k in let '(b, c) := Cantor.of_nat b in (decode_z a, decode_z b, decode_z c).
Lemma decode3_code n : decode3 (code3 n) = n.
Proof. destruct n as [[x y] z]. unfold decode3, code3. rewrite !Cantor.cancel_of_to, !decode_code. reflexivity. Qed.
Definition choose3 := choose code3 decode3 decode3_code.
Definition choose_pair := choose Cantor.to_nat Cantor.of_nat Cantor.cancel_of_to.

(** ** Small facts *)
Lemma next_lt n s : (s < n)%nat -> (next n s < n)%nat.
Proof. unfold next. destruct (Nat.eqb_spec (S s) n); lia. Qed.
Definition prev (n s : nat) : nat := match s with O => Nat.pred n | S s' => s' end.
Lemma prev_lt n s : (s < n)%nat -> (prev n s < n)%nat.
Proof. unfold prev. destruct s; lia. Qed.
Lemma prev_next n s : (s < n)%nat -> prev n (next n s) = s.
Proof. unfold prev, next. destruct (Nat.eqb_spec (S s) n); intros; cbn; lia. Qed.
Lemma next_prev n s : (s < n)%nat -> next n (prev n s) = s.
Proof. unfold prev, next. destruct s; intros; [destruct (Nat.eqb_spec (S (Nat.pred n)) n)|destruct (Nat.eqb_spec (S s) n)]; lia. Qed.
(** A triangle with its vertices in another order, of the same orientation. *)
Definition turns (f g : triangle) := f = g \/ f = Triangle (t2 g) (t3 g) (t1 g) \/ f = Triangle (t3 g) (t1 g) (t2 g).
Lemma turns_opposite f f' g g' : turns f f' -> turns g g' -> opposite f' g' -> opposite f g.
Proof. intros [->|[->| ->]] [->|[->| ->]]; unfold opposite; cbn [t1 t2 t3]; intuition. Qed.

Definition pt (n : Z3) : point := let '(x, y, z) := n in Point (IZR x) (IZR y) (IZR z).
Definition lift (n : Z3) (x : point) : point := add x (pt n).
Lemma pt_add a b : pt (zadd3 a b) = add (pt a) (pt b).
Proof. destruct a as [[? ?] ?], b as [[? ?] ?]. unfold pt, zadd3, add; cbn. rewrite !plus_IZR. reflexivity. Qed.
Lemma pt_opp a : pt (zopp3 a) = scale (-1) (pt a).
Proof. destruct a as [[? ?] ?]. unfold pt, zopp3, scale; cbn. rewrite !opp_IZR. apply point_eq; cbn; ring. Qed.
Lemma pt_inj a b : pt a = pt b -> a = b.
Proof. destruct a as [[? ?] ?], b as [[? ?] ?]. unfold pt. intros E. injection E as A B C. apply eq_IZR in A, B, C. congruence. Qed.
Lemma lift_lift a b x : lift a (lift b x) = lift (zadd3 a b) x.
Proof. unfold lift. rewrite pt_add. apply point_eq; unf; ring. Qed.
Lemma lift_zero x : lift z30 x = x.
Proof. unfold lift, pt, z30. apply point_eq; unf; ring. Qed.
Lemma z3_eq (x y z x' y' z' : Z) : x = x' -> y = y' -> z = z' -> (x, y, z) = (x', y', z').
Proof. congruence. Qed.
Lemma zadd3_opp a : zadd3 a (zopp3 a) = z30.
Proof. destruct a as [[? ?] ?]. unfold zadd3, zopp3, z30. apply z3_eq; lia. Qed.
Lemma zadd3_comm a b : zadd3 a b = zadd3 b a.
Proof. destruct a as [[? ?] ?], b as [[? ?] ?]. unfold zadd3. apply z3_eq; lia. Qed.
Lemma zadd3_assoc a b c : zadd3 a (zadd3 b c) = zadd3 (zadd3 a b) c.
Proof. destruct a as [[? ?] ?], b as [[? ?] ?], c as [[? ?] ?]. unfold zadd3. apply z3_eq; lia. Qed.
Lemma zadd3_zero a : zadd3 a z30 = a.
Proof. destruct a as [[? ?] ?]. unfold zadd3, z30. apply z3_eq; lia. Qed.
Lemma zopp3_opp a : zopp3 (zopp3 a) = a.
Proof. destruct a as [[? ?] ?]. unfold zopp3. apply z3_eq; lia. Qed.
Ltac z3 := repeat match goal with n : Z3 |- _ => destruct n as [[? ?] ?] end; unfold zadd3, zopp3, z30; apply z3_eq; lia.
Lemma latb_opp r a : latb r a = true -> latb r (zopp3 a) = true.
Proof. rewrite !latb_iff. destruct a as [[? ?] ?], r as [|[|[|r]]]; simpl; intuition lia. Qed.

Definition map_tet (f : point -> point) (t : tetrahedron) := Tetrahedron (f (va t)) (f (vb t)) (f (vc t)) (f (vd t)).
Definition map_tri (f : point -> point) (t : triangle) := Triangle (f (t1 t)) (f (t2 t)) (f (t3 t)).
Lemma facet_map f t i : facet (map_tet f t) i = map_tri f (facet t i).
Proof. destruct i as [|[|[|i]]]; reflexivity. Qed.
Lemma vx_map f t i : vx (map_tet f t) i = f (vx t i).
Proof. destruct i as [|[|[|i]]]; reflexivity. Qed.
Lemma opposite_map f s t : opposite s t -> opposite (map_tri f s) (map_tri f t).
Proof. unfold opposite, map_tri; cbn [t1 t2 t3]. intuition congruence. Qed.

(** A vector that is orthogonal to two independent ones and in their plane is zero. *)
Lemma flat_zero a b w : dot a w = 0 -> dot b w = 0 -> det a b w = 0 -> dot a a * dot b b - dot a b * dot a b <> 0 -> w = origin.
Proof.
  intros A B D N.
  assert (E : det a b w * det a b w = (dot a a * dot b b - dot a b * dot a b) * dot w w
    - dot a w * (dot a w * dot b b - dot b w * dot a b) + dot b w * (dot a w * dot a b - dot b w * dot a a)).
  { unfold det, dot. ring. }
  rewrite A, B, D in E. assert (W : dot w w = 0) by nra. unfold dot in W.
  pose proof (Rle_0_sqr (px w)); pose proof (Rle_0_sqr (py w)); pose proof (Rle_0_sqr (pz w)); unfold Rsqr in *.
  apply point_eq; unfold origin; cbn; match goal with |- ?x = 0 => assert (K : x * x = 0) by lra; apply Rmult_integral in K; tauto end.
Qed.

(** A finite set of points is not moved into itself. *)
Lemma no_shift L d : L <> [] -> (forall h, In h L -> exists h', In h' L /\ h = lift d h') -> d = z30.
Proof.
  intros NE H. destruct L as [|x L]; [congruence|]. destruct (smallest_exists (dot x (pt d)) (map (fun h => dot h (pt d)) L)) as [q [I U]].
  change (In q (map (fun h => dot h (pt d)) (x :: L))) in I. apply in_map_iff in I as [h [<- I]]. destruct (H h I) as [h' [I' E]].
  assert (Q : dot h (pt d) <= dot h' (pt d)) by (apply U; exact (in_map (fun h => dot h (pt d)) (x :: L) h' I')).
  rewrite E in Q. apply pt_inj. set (w := pt d) in *. unfold lift in Q. fold w in Q. clearbody w. unfold dot, add in Q; cbn in Q.
  pose proof (Rle_0_sqr (px w)); pose proof (Rle_0_sqr (py w)); pose proof (Rle_0_sqr (pz w)); unfold Rsqr in *.
  apply point_eq; cbn; match goal with |- ?x = 0 => assert (K : x * x = 0) by lra; apply Rmult_integral in K; tauto end.
Qed.
