(** * Families: polynomials in parameters, and their signs on a box

    The numbers of a family are polynomials in parameters t1, …, tm over the integers or
    Z[a].  They are another ring for the checker.  A sign is proved on a whole box at
    once, so all checks hold at each of its points; there the theorem for single tilings
    applies ([family_theorem]).

    Let lo <= t <= hi.  With x = hi - t and y = t - lo, both at least zero, t (x + y) =
    lo x + hi y.  So (x + y)^n p(t) is a homogeneous polynomial in x and y of degree n.  Its
    coefficients are those of Bernstein, times binomial coefficients.  If all are at least zero,
    so is p; if the first one is positive, p is positive for t < hi, and so on.  The
    coefficients are polynomials in the other parameters, so the test is recursive. *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Statement PlaneStatement Checker PlaneChecker Soundness PlaneSoundness Fast Numbers.
Import ListNotations.
Local Open Scope R_scope.

(** ** One more variable *)
Section Step.
Variables (A : Type) (add sub mul : A -> A -> A) (zero : A).
Fixpoint plus (p q : list A) : list A :=
  match p, q with [], _ => q | _, [] => p | a :: p, b :: q => add a b :: plus p q end.
Fixpoint minus (p q : list A) : list A :=
  match p, q with [], _ => map (sub zero) q | _, [] => p | a :: p, b :: q => sub a b :: minus p q end.
Fixpoint times (p q : list A) : list A :=
  match p with [] => [] | a :: p => plus (map (mul a) q) (zero :: times p q) end.

(** An interval with the ends low/den and high/den, each closed or open. *)
Variables (B : Type) (scale : B -> A -> A) (bofZ : Z -> B).
Record interval := Interval { low_closed : bool; low : B; high_closed : bool; high : B; den : Z }.
(** Homogeneous polynomials in x and y of degree n: n + 1 coefficients, of x^n first. *)
Definition times_x (l : list A) : list A := l ++ [zero].
Definition times_y (l : list A) : list A := zero :: l.
(** (den (x + y))^n for a list of length n. *)
Fixpoint sum_power (d : Z) (p : list A) : list Z :=
  match p with [] => [1%Z] | _ :: p => let e := sum_power d p in map (Z.mul d) (Numbers.ladd (e ++ [0%Z]) (0%Z :: e)) end.
(** The coefficients of (den (x + y))^n p(t) for p of degree n. *)
Fixpoint bernstein (i : interval) (p : list A) : list A :=
  match p with
  | [] => []
  | c :: p =>
    let q := bernstein i p in
    plus (map (fun e => scale (bofZ e) c) (sum_power (den i) p))
      (plus (map (scale (low i)) (times_x q)) (map (scale (high i)) (times_y q)))
  end.
Variables (nonnegative positive : A -> bool).
Definition nonnegative_on (i : interval) (p : list A) : bool := forallb nonnegative (bernstein i p).
Definition positive_on (i : interval) (p : list A) : bool :=
  let q := bernstein i p in
  forallb nonnegative q && negb (Nat.eqb (length q) 0) &&
  (if low_closed i then positive (List.hd zero q) else true) && (if high_closed i then positive (last q zero) else true) &&
  (if low_closed i || high_closed i then true else positive (fold_right add zero q)).

(** *** Soundness, at one value of the other parameters *)
Variables (phi : A -> R) (beta : B -> R) (t : R).
Hypothesis phi_add : forall a b, phi (add a b) = phi a + phi b.
Hypothesis phi_sub : forall a b, phi (sub a b) = phi a - phi b.
Hypothesis phi_mul : forall a b, phi (mul a b) = phi a * phi b.
Hypothesis phi_zero : phi zero = 0.
Hypothesis phi_scale : forall b a, phi (scale b a) = beta b * phi a.
Hypothesis beta_Z : forall z, beta (bofZ z) = IZR z.
Fixpoint at_value (p : list A) : R := match p with [] => 0 | a :: p => phi a + t * at_value p end.
Lemma at_plus p : forall q, at_value (plus p q) = at_value p + at_value q.
Proof. induction p as [|a p IH]; intros [|b q]; cbn [plus at_value]; try ring. rewrite IH, phi_add. ring. Qed.
Lemma at_minus p : forall q, at_value (minus p q) = at_value p - at_value q.
Proof.
  induction p as [|a p IH]; intros [|b q]; cbn [minus at_value map]; try ring; [|rewrite IH, phi_sub; ring].
  rewrite phi_sub, phi_zero. assert (E : at_value (map (sub zero) q) = - at_value q).
  { clear b. induction q as [|b q IHq]; cbn [map at_value]; [ring|]. rewrite IHq, phi_sub, phi_zero. ring. }
  rewrite E. ring.
Qed.
Lemma at_map (f : A -> A) (r : R) : (forall x, phi (f x) = r * phi x) -> forall q, at_value (map f q) = r * at_value q.
Proof. intros F q. induction q as [|b q IH]; cbn [map at_value]; [ring|]. rewrite IH, F. ring. Qed.
Lemma at_times p q : at_value (times p q) = at_value p * at_value q.
Proof.
  induction p as [|a p IH]; cbn [times at_value]; [ring|].
  rewrite at_plus, (at_map _ (phi a)) by (intros; apply phi_mul). cbn [at_value]. rewrite IH, phi_zero. ring.
Qed.

Variable i : interval.
Hypothesis den_pos : (0 < den i)%Z.
Hypothesis ordered : beta (low i) < beta (high i).
Definition in_interval : Prop :=
  (if low_closed i then beta (low i) <= IZR (den i) * t else beta (low i) < IZR (den i) * t) /\
  (if high_closed i then IZR (den i) * t <= beta (high i) else IZR (den i) * t < beta (high i)).
Hypothesis inside : in_interval.
Let x := beta (high i) - IZR (den i) * t.
Let y := IZR (den i) * t - beta (low i).
Let w := IZR (den i) * (x + y).
Fixpoint form (l : list A) : R := match l with [] => 0 | c :: l => phi c * x ^ length l + y * form l end.
Fixpoint zform (l : list Z) : R := match l with [] => 0 | c :: l => IZR c * x ^ length l + y * zform l end.
Lemma x_nonneg : 0 <= x. Proof. unfold x. destruct inside as [_ H]. destruct (high_closed i); lra. Qed.
Lemma y_nonneg : 0 <= y. Proof. unfold y. destruct inside as [H _]. destruct (low_closed i); lra. Qed.
Lemma w_pos : 0 < w.
Proof. unfold w, x, y. apply IZR_lt in den_pos. apply Rmult_lt_0_compat; lra. Qed.
Lemma plus_length p : forall q, length p = length q -> length (plus p q) = length p.
Proof. induction p as [|a p IH]; intros [|b q]; cbn; try discriminate; auto. Qed.
Lemma form_plus p : forall q, length p = length q -> form (plus p q) = form p + form q.
Proof.
  induction p as [|a p IH]; intros [|b q]; cbn [plus form length]; try discriminate; [intros; ring|].
  intros E. injection E as E. rewrite IH by auto. rewrite (plus_length p q E), phi_add, E. ring.
Qed.
Lemma form_map (f : A -> A) (r : R) : (forall a, phi (f a) = r * phi a) -> forall q, form (map f q) = r * form q.
Proof. intros F q. induction q as [|b q IH]; cbn [map form]; [ring|]. rewrite IH, F, map_length. ring. Qed.
Lemma form_x l : form (times_x l) = x * form l.
Proof.
  unfold times_x. induction l as [|a l IH]; cbn [app form length]; [rewrite phi_zero; ring|].
  rewrite IH, app_length. cbn [length]. rewrite Nat.add_1_r. cbn [pow]. ring.
Qed.
Lemma form_y l : form (times_y l) = y * form l.
Proof. unfold times_y. cbn [form]. rewrite phi_zero. ring. Qed.
Lemma ladd_length p : forall q, length p = length q -> length (Numbers.ladd p q) = length p.
Proof. induction p as [|a p IH]; intros [|b q]; cbn; try discriminate; auto. Qed.
Lemma zform_add p : forall q, length p = length q -> zform (Numbers.ladd p q) = zform p + zform q.
Proof.
  induction p as [|a p IH]; intros [|b q]; cbn [Numbers.ladd zform length]; try discriminate; [intros; ring|].
  intros E. injection E as E. rewrite IH by auto. rewrite (ladd_length p q E), plus_IZR, E. ring.
Qed.
Lemma zform_scale d q : zform (map (Z.mul d) q) = IZR d * zform q.
Proof. induction q as [|b q IH]; cbn [map zform]; [ring|]. rewrite IH, mult_IZR, map_length. ring. Qed.
Lemma zform_x l : zform (l ++ [0%Z]) = x * zform l.
Proof.
  induction l as [|a l IH]; cbn [app zform length]; [ring|].
  rewrite IH, app_length. cbn [length]. rewrite Nat.add_1_r. cbn [pow]. ring.
Qed.
Lemma sum_power_length p : length (sum_power (den i) p) = S (length p).
Proof.
  induction p as [|a p IH]; cbn [sum_power length]; auto.
  rewrite map_length, ladd_length; rewrite app_length; cbn [length]; lia.
Qed.
Lemma sum_power_ok p : zform (sum_power (den i) p) = w ^ length p.
Proof.
  induction p as [|a p IH]; cbn [sum_power]; [cbn; ring|].
  rewrite zform_scale, zform_add, zform_x by (rewrite app_length; cbn [length]; lia). cbn [zform length pow].
  rewrite IH. unfold w. ring.
Qed.
Lemma form_scaled c e : form (map (fun e => scale (bofZ e) c) e) = phi c * zform e.
Proof. induction e as [|z e IH]; cbn [map form zform]; [ring|]. rewrite IH, phi_scale, beta_Z, map_length. ring. Qed.
Lemma bernstein_length p : length (bernstein i p) = length p.
Proof.
  induction p as [|c p IH]; cbn [bernstein length]; auto.
  assert (X : length (map (scale (low i)) (times_x (bernstein i p))) = S (length p)).
  { rewrite map_length. unfold times_x. rewrite app_length. cbn [length]. lia. }
  assert (Y : length (map (scale (high i)) (times_y (bernstein i p))) = S (length p)).
  { rewrite map_length. unfold times_y. cbn [length]. lia. }
  rewrite plus_length; rewrite map_length, sum_power_length; [reflexivity|]. rewrite plus_length; congruence.
Qed.
Lemma bernstein_ok p : w * form (bernstein i p) = w ^ length p * at_value p.
Proof.
  induction p as [|c p IH]; cbn [bernstein]; [cbn; ring|].
  assert (X : length (map (scale (low i)) (times_x (bernstein i p))) = S (length p)).
  { rewrite map_length. unfold times_x. rewrite app_length, bernstein_length. cbn [length]. lia. }
  assert (Y : length (map (scale (high i)) (times_y (bernstein i p))) = S (length p)).
  { rewrite map_length. unfold times_y. cbn [length]. rewrite bernstein_length. lia. }
  rewrite form_plus.
  2:{ rewrite map_length, sum_power_length, plus_length; congruence. }
  rewrite form_plus by congruence.
  rewrite (form_map _ (beta (low i))), (form_map _ (beta (high i))), form_x, form_y, form_scaled, sum_power_ok by (intros; apply phi_scale).
  cbn [length at_value pow].
  assert (E : beta (low i) * x + beta (high i) * y = t * w) by (unfold w, x, y; ring).
  replace (w * (phi c * w ^ length p + (beta (low i) * (x * form (bernstein i p)) + beta (high i) * (y * form (bernstein i p)))))
    with (w * phi c * w ^ length p + (beta (low i) * x + beta (high i) * y) * (w * form (bernstein i p))) by ring.
  rewrite E, IH. ring.
Qed.
(** From the form to the polynomial. *)
Lemma value_nonneg p : 0 <= form (bernstein i p) -> 0 <= at_value p.
Proof.
  intros H. pose proof w_pos as W. apply Rmult_le_reg_l with (w ^ length p); [apply pow_lt, W|].
  rewrite Rmult_0_r, <- bernstein_ok. apply Rmult_le_pos; lra.
Qed.
Lemma value_pos p : 0 < form (bernstein i p) -> 0 < at_value p.
Proof.
  intros H. pose proof w_pos as W. apply Rmult_lt_reg_l with (w ^ length p); [apply pow_lt, W|].
  rewrite Rmult_0_r, <- bernstein_ok. apply Rmult_lt_0_compat; lra.
Qed.

Hypothesis nonnegative_ok : forall a, nonnegative a = true -> 0 <= phi a.
Hypothesis positive_ok : forall a, positive a = true -> 0 < phi a.
Lemma form_nonneg l : forallb nonnegative l = true -> 0 <= form l.
Proof.
  induction l as [|c l IH]; cbn [forallb form]; [lra|]. rewrite andb_true_iff. intros [H1 H2]. apply nonnegative_ok in H1. apply IH in H2.
  pose proof (pow_le x (length l) x_nonneg). pose proof y_nonneg. assert (0 <= phi c * x ^ length l) by (apply Rmult_le_pos; auto).
  assert (0 <= y * form l) by (apply Rmult_le_pos; auto). lra.
Qed.
Lemma form_first l : l <> [] -> forallb nonnegative l = true -> 0 < x -> 0 < phi (List.hd zero l) -> 0 < form l.
Proof.
  destruct l as [|c l]; [congruence|]. cbn [forallb form List.hd]. rewrite andb_true_iff. intros _ [_ H2] X P. apply form_nonneg in H2.
  pose proof (pow_lt x (length l) X). pose proof y_nonneg. assert (0 < phi c * x ^ length l) by (apply Rmult_lt_0_compat; auto).
  assert (0 <= y * form l) by (apply Rmult_le_pos; auto). lra.
Qed.
Lemma form_last l : l <> [] -> forallb nonnegative l = true -> 0 < y -> 0 < phi (last l zero) -> 0 < form l.
Proof.
  induction l as [|c l IH]; [congruence|]. intros _ H Y P. destruct l as [|d l].
  - cbn in *. lra.
  - cbn [forallb] in H. rewrite andb_true_iff in H. destruct H as [H1 H2]. specialize (IH ltac:(discriminate) H2 Y P). apply nonnegative_ok in H1.
    change (form (c :: d :: l)) with (phi c * x ^ length (d :: l) + y * form (d :: l)).
    pose proof (pow_le x (length (d :: l)) x_nonneg). assert (0 <= phi c * x ^ length (d :: l)) by (apply Rmult_le_pos; auto).
    assert (0 < y * form (d :: l)) by (apply Rmult_lt_0_compat; auto). lra.
Qed.
Lemma form_sum l : forallb nonnegative l = true -> 0 < x -> 0 < y -> 0 < phi (fold_right add zero l) -> 0 < form l.
Proof.
  induction l as [|c l IH]; cbn [forallb form fold_right]; [rewrite phi_zero; lra|]. rewrite andb_true_iff, phi_add. intros [H1 H2] X Y P.
  apply nonnegative_ok in H1. pose proof (form_nonneg l H2). pose proof (pow_lt x (length l) X).
  destruct (Rlt_dec 0 (phi c)) as [C|C].
  - assert (0 < phi c * x ^ length l) by (apply Rmult_lt_0_compat; auto). assert (0 <= y * form l) by (apply Rmult_le_pos; lra). lra.
  - assert (0 < form l) by (apply IH; auto; lra). assert (0 < y * form l) by (apply Rmult_lt_0_compat; auto).
    replace (phi c) with 0 by lra. lra.
Qed.
Lemma nonnegative_on_ok p : nonnegative_on i p = true -> 0 <= at_value p.
Proof. intros H. apply value_nonneg, form_nonneg, H. Qed.
Lemma positive_on_ok p : positive_on i p = true -> 0 < at_value p.
Proof.
  unfold positive_on. cbv zeta. rewrite !andb_true_iff, negb_true_iff, Nat.eqb_neq. intros [[[[H1 H2] HL] HH] HO]. apply value_pos.
  set (q := bernstein i p) in *. assert (NE : q <> []) by (intros E; rewrite E in H2; auto).
  pose proof x_nonneg as X. pose proof y_nonneg as Y. pose proof inside as [IL IH].
  assert (XY : 0 < x + y) by (unfold x, y; lra).
  destruct (low_closed i) eqn:EL, (high_closed i) eqn:EH; cbn [orb] in HO.
  - apply positive_ok in HL, HH. destruct (Rlt_dec 0 x); [apply form_first|apply form_last]; auto. lra.
  - apply positive_ok in HL. apply form_first; auto. unfold x. lra.
  - apply positive_ok in HH. apply form_last; auto. unfold y. lra.
  - apply positive_ok in HO. apply form_sum; auto; unfold x, y; lra.
Qed.
End Step.
Arguments low {B}. Arguments high {B}. Arguments low_closed {B}. Arguments high_closed {B}. Arguments den {B}.

(** ** All parameters, over a ring B *)
Section Poly.
Variables (B : Type) (badd bsub bmul : B -> B -> B) (bofZ : Z -> B) (bnonneg bpos : B -> bool).
(** The first parameter is the outer variable. *)
Fixpoint poly (m : nat) : Type := match m with O => B | S m => list (poly m) end.
Fixpoint constant (m : nat) (b : B) : poly m := match m with O => b | S m => [constant m b] end.
Definition pofZ (m : nat) (z : Z) : poly m := constant m (bofZ z).
Fixpoint padd (m : nat) : poly m -> poly m -> poly m := match m with O => badd | S m => plus (poly m) (padd m) end.
Fixpoint psub (m : nat) : poly m -> poly m -> poly m := match m with O => bsub | S m => minus (poly m) (psub m) (pofZ m 0) end.
Fixpoint pmul (m : nat) : poly m -> poly m -> poly m := match m with O => bmul | S m => times (poly m) (padd m) (pmul m) (pofZ m 0) end.
Fixpoint pscale (m : nat) (b : B) : poly m -> poly m := match m with O => bmul b | S m => map (pscale m b) end.
Definition box := list (interval B).
(** A box with fewer intervals than parameters decides nothing. *)
Fixpoint pnonneg (m : nat) (bs : box) : poly m -> bool :=
  match m, bs with
  | O, _ => bnonneg
  | S m, i :: bs => nonnegative_on (poly m) (padd m) (pofZ m 0) B (pscale m) bofZ (pnonneg m bs) i
  | S _, [] => fun _ => false
  end.
Fixpoint ppos (m : nat) (bs : box) : poly m -> bool :=
  match m, bs with
  | O, _ => bpos
  | S m, i :: bs => positive_on (poly m) (padd m) (pofZ m 0) B (pscale m) bofZ (pnonneg m bs) (ppos m bs) i
  | S _, [] => fun _ => false
  end.
Definition plt (m : nat) (bs : box) (p q : poly m) : bool := ppos m bs (psub m q p).
Definition ple (m : nat) (bs : box) (p q : poly m) : bool := pnonneg m bs (psub m q p).

(** The certificate's tree: a leaf, or the box is halved along an axis. An end made by halving is closed. *)
Inductive tree := Leaf | Halve (axis : nat) (lower upper : tree).
Definition middle (i : interval B) : B := badd (low i) (high i).
Definition twice (b : B) : B := badd b b.
Definition lower_half (i : interval B) : interval B := Interval B (low_closed i) (twice (low i)) true (middle i) (2 * den i)%Z.
Definition upper_half (i : interval B) : interval B := Interval B true (middle i) (high_closed i) (twice (high i)) (2 * den i)%Z.
Fixpoint change {X} (f : X -> X) (n : nat) (l : list X) : list X :=
  match l, n with [], _ => [] | x :: l, O => f x :: l | x :: l, S n => x :: change f n l end.
Fixpoint leaves (bs : box) (t : tree) : list box :=
  match t with Leaf => [bs] | Halve a l u => leaves (change lower_half a bs) l ++ leaves (change upper_half a bs) u end.
(** Every interval has a positive denominator and ends in order. *)
Definition proper (bs : box) : bool := forallb (fun i => Z.ltb 0 (den i) && bpos (bsub (high i) (low i))) bs.

Section Soundness.
Variable beta : B -> R.
Hypothesis beta_add : forall a b, beta (badd a b) = beta a + beta b.
Hypothesis beta_sub : forall a b, beta (bsub a b) = beta a - beta b.
Hypothesis beta_mul : forall a b, beta (bmul a b) = beta a * beta b.
Hypothesis beta_Z : forall z, beta (bofZ z) = IZR z.
Hypothesis bnonneg_ok : forall b, bnonneg b = true -> 0 <= beta b.
Hypothesis bpos_ok : forall b, bpos b = true -> 0 < beta b.
Fixpoint pev (m : nat) (ts : list R) : poly m -> R :=
  match m with O => beta | S m => at_value (poly m) (pev m (tl ts)) (List.hd 0 ts) end.
Definition ordered_interval (i : interval B) : Prop := (0 < den i)%Z /\ beta (low i) < beta (high i).
Definition in_box (bs : box) (ts : list R) : Prop := Forall2 (fun i t => in_interval B beta t i) bs ts.

Lemma pev_constant m b : forall ts, pev m ts (constant m b) = beta b.
Proof. induction m as [|m IH]; intros ts; cbn [pev constant at_value]; auto. rewrite IH. ring. Qed.
Lemma pev_Z m z ts : pev m ts (pofZ m z) = IZR z.
Proof. unfold pofZ. rewrite pev_constant. apply beta_Z. Qed.
Lemma pev_add m : forall ts p q, pev m ts (padd m p q) = pev m ts p + pev m ts q.
Proof. induction m as [|m IH]; intros ts p q; [apply beta_add|]. apply at_plus. intros; apply IH. Qed.
Lemma pev_sub m : forall ts p q, pev m ts (psub m p q) = pev m ts p - pev m ts q.
Proof. induction m as [|m IH]; intros ts p q; [apply beta_sub|]. apply at_minus; [intros; apply IH|apply pev_Z]. Qed.
Lemma pev_mul m : forall ts p q, pev m ts (pmul m p q) = pev m ts p * pev m ts q.
Proof. induction m as [|m IH]; intros ts p q; [apply beta_mul|]. apply at_times; [intros; apply pev_add|intros; apply IH|apply pev_Z]. Qed.
Lemma pev_scale m b : forall ts p, pev m ts (pscale m b p) = beta b * pev m ts p.
Proof. induction m as [|m IH]; intros ts p; [apply beta_mul|]. apply (at_map (poly m) (pev m (tl ts))). intros; apply IH. Qed.

Lemma psigns m : forall bs ts, Forall ordered_interval bs -> in_box bs ts ->
  (forall p, pnonneg m bs p = true -> 0 <= pev m ts p) /\ (forall p, ppos m bs p = true -> 0 < pev m ts p).
Proof.
  induction m as [|m IH]; intros bs ts O I; [split; [apply bnonneg_ok|apply bpos_ok]|].
  destruct bs as [|i bs]; [split; intros p H; discriminate|]. inversion I as [|? t ? ts' It Its]; subst. inversion O as [|? ? [Oi1 Oi2] Obs]; subst.
  destruct (IH bs ts' Obs Its) as [N P]. cbn [pnonneg ppos pev List.hd tl]. split; intros p H.
  - apply (nonnegative_on_ok (poly m) (padd m) (pofZ m 0) B (pscale m) bofZ (pnonneg m bs) (pev m ts') beta t) with (i := i); auto.
    + intros; apply pev_add. + apply pev_Z. + intros; apply pev_scale.
  - apply (positive_on_ok (poly m) (padd m) (pofZ m 0) B (pscale m) bofZ (pnonneg m bs) (ppos m bs) (pev m ts') beta t) with (i := i); auto.
    + intros; apply pev_add. + apply pev_Z. + intros; apply pev_scale.
Qed.
Lemma plt_ok m bs ts : Forall ordered_interval bs -> in_box bs ts -> forall p q, plt m bs p q = true -> pev m ts p < pev m ts q.
Proof. intros O I p q H. apply (proj2 (psigns m bs ts O I)) in H. rewrite pev_sub in H. lra. Qed.
Lemma ple_ok m bs ts : Forall ordered_interval bs -> in_box bs ts -> forall p q, ple m bs p q = true -> pev m ts p <= pev m ts q.
Proof. intros O I p q H. apply (proj1 (psigns m bs ts O I)) in H. rewrite pev_sub in H. lra. Qed.

(** *** The leaves cover the box *)
Lemma proper_ok bs : proper bs = true -> Forall ordered_interval bs.
Proof.
  unfold proper. rewrite forallb_forall, Forall_forall. intros H i Hi. specialize (H i Hi). rewrite andb_true_iff, Z.ltb_lt in H.
  destruct H as [D P]. apply bpos_ok in P. rewrite beta_sub in P. split; [auto|lra].
Qed.
Lemma halves i t : ordered_interval i -> in_interval B beta t i ->
  ordered_interval (lower_half i) /\ ordered_interval (upper_half i) /\ (in_interval B beta t (lower_half i) \/ in_interval B beta t (upper_half i)).
Proof.
  intros [D O] [L H]. unfold ordered_interval, in_interval, lower_half, upper_half, middle, twice. cbn [low high low_closed high_closed den].
  rewrite !beta_add, !mult_IZR. split; [split; [lia|lra]|]. split; [split; [lia|lra]|].
  destruct (Rle_dec (2 * IZR (den i) * t) (beta (low i) + beta (high i))); [left|right]; split; try lra.
  - destruct (low_closed i); lra.
  - destruct (high_closed i); lra.
Qed.
Lemma change_box f n : forall bs ts, (forall i t, ordered_interval i -> in_interval B beta t i -> ordered_interval (f i)) ->
  Forall ordered_interval bs -> in_box bs ts -> Forall ordered_interval (change f n bs).
Proof.
  induction n as [|n IH]; intros [|i bs] ts F O I; cbn [change]; auto; inversion I; subst; inversion O; subst; constructor; eauto.
Qed.
Lemma halved a : forall bs ts, Forall ordered_interval bs -> in_box bs ts ->
  in_box (change lower_half a bs) ts \/ in_box (change upper_half a bs) ts.
Proof.
  induction a as [|a IH]; intros [|i bs] ts O I; cbn [change]; auto; inversion I as [|? t ? ts' It Its]; subst; inversion O as [|? ? Oi Obs]; subst.
  - destruct (halves i t Oi It) as [_ [_ [H|H]]]; [left|right]; constructor; auto.
  - destruct (IH bs ts' Obs Its) as [H|H]; [left|right]; constructor; auto.
Qed.
Lemma leaves_cover t : forall bs ts, Forall ordered_interval bs -> in_box bs ts ->
  exists l, In l (leaves bs t) /\ Forall ordered_interval l /\ in_box l ts.
Proof.
  induction t as [|a l IHl u IHu]; intros bs ts O I; cbn [leaves].
  - exists bs. split; [left; reflexivity|auto].
  - destruct (halved a bs ts O I) as [H|H].
    + destruct (IHl (change lower_half a bs) ts) as [x [X1 X2]]; [|exact H|].
      { apply change_box with (2 := O) (3 := I). intros i t Oi It. apply (halves i t Oi It). }
      exists x. split; [apply in_or_app; left; exact X1|exact X2].
    + destruct (IHu (change upper_half a bs) ts) as [x [X1 X2]]; [|exact H|].
      { apply change_box with (2 := O) (3 := I). intros i t Oi It. apply (halves i t Oi It). }
      exists x. split; [apply in_or_app; right; exact X1|exact X2].
Qed.

(** *** From the leaves to the points *)
Section Points.
Variables (bs : box) (t : tree).
Hypothesis OK : proper bs = true.
Definition on_leaves (f : box -> bool) : bool := forallb f (leaves bs t).
Lemma at_point f ts : on_leaves f = true -> in_box bs ts -> exists l, f l = true /\ Forall ordered_interval l /\ in_box l ts.
Proof.
  unfold on_leaves. rewrite forallb_forall. intros H I. destruct (leaves_cover t bs ts (proper_ok bs OK) I) as [l [L1 L2]]. exists l. split; [apply H, L1|exact L2].
Qed.
End Points.

(** On one leaf. *)
Section OneLeaf.
Variables (m : nat) (l : box) (ts : list R).
Hypothesis O : Forall ordered_interval l.
Hypothesis I : in_box l ts.
Theorem leaf_sound (c : cert (poly m)) ss : fast_check (poly m) (padd m) (psub m) (pmul m) (pofZ m) (plt m l) (ple m l) c ss = true ->
  (exists l1 l2 l3, has_gram (dgram (poly m) (pev m ts) c) l1 l2 l3) /\
  forall l1 l2 l3, has_gram (dgram (poly m) (pev m ts) c) l1 l2 l3 ->
  face_to_face_tiling l1 l2 l3 (c_rank _ c) (ddomain (poly m) (pev m ts) c l1 l2 l3) (length (c_tets _ c)) (dtet (poly m) (pofZ m) (pev m ts) c l1 l2 l3) /\
  forall s, In s (map (dstatement (poly m) (pev m ts)) ss) -> holds l1 l2 l3 (c_rank _ c) (length (c_tets _ c)) (dtet (poly m) (pofZ m) (pev m ts) c l1 l2 l3) s.
Proof.
  intros F. apply fast_ok in F. split.
  - apply (basis_exists (poly m) (padd m) (psub m) (pmul m) (pofZ m) (plt m l) (ple m l) (pev m ts) (pev_add m ts) (pev_sub m ts) (pev_mul m ts) (fun z => pev_Z m z ts) (plt_ok m l ts O I) c ss F).
  - apply (check_sound (poly m) (padd m) (psub m) (pmul m) (pofZ m) (plt m l) (ple m l) (pev m ts) (pev_add m ts) (pev_sub m ts) (pev_mul m ts) (fun z => pev_Z m z ts) (plt_ok m l ts O I) (ple_ok m l ts O I) c ss F).
Qed.
Theorem leaf_sound2 (c : cert2 (poly m)) ss : check2 (poly m) (padd m) (psub m) (pmul m) (pofZ m) (plt m l) (ple m l) c ss = true ->
  (exists l1 l2, has_gram2 (dgram2 (poly m) (pev m ts) c) l1 l2) /\
  forall l1 l2, has_gram2 (dgram2 (poly m) (pev m ts) c) l1 l2 ->
  edge_to_edge_tiling l1 l2 (e_rank _ c) (ddomain2 (poly m) (pev m ts) c l1 l2) (length (e_tris _ c)) (dtriangle (poly m) (pofZ m) (pev m ts) c l1 l2) /\
  forall s, In s (map (dstatement (poly m) (pev m ts)) ss) -> holds2 l1 l2 (e_rank _ c) (length (e_tris _ c)) (dtriangle (poly m) (pofZ m) (pev m ts) c l1 l2) s.
Proof.
  apply (check2_sound (poly m) (padd m) (psub m) (pmul m) (pofZ m) (plt m l) (ple m l) (pev m ts) (pev_add m ts) (pev_sub m ts) (pev_mul m ts) (fun z => pev_Z m z ts) (plt_ok m l ts O I) (ple_ok m l ts O I) c ss).
Qed.
End OneLeaf.

(** The theorems on families: at each point of the box.  Data may depend on the leaf, because hints do. *)
Theorem family_theorem m bs t (c : box -> cert (poly m)) ss : proper bs = true ->
  on_leaves bs t (fun l => fast_check (poly m) (padd m) (psub m) (pmul m) (pofZ m) (plt m l) (ple m l) (c l) ss) = true ->
  forall ts, in_box bs ts -> exists l,
  (exists l1 l2 l3, has_gram (dgram (poly m) (pev m ts) (c l)) l1 l2 l3) /\
  forall l1 l2 l3, has_gram (dgram (poly m) (pev m ts) (c l)) l1 l2 l3 ->
  face_to_face_tiling l1 l2 l3 (c_rank _ (c l)) (ddomain (poly m) (pev m ts) (c l) l1 l2 l3) (length (c_tets _ (c l))) (dtet (poly m) (pofZ m) (pev m ts) (c l) l1 l2 l3) /\
  forall s, In s (map (dstatement (poly m) (pev m ts)) ss) -> holds l1 l2 l3 (c_rank _ (c l)) (length (c_tets _ (c l))) (dtet (poly m) (pofZ m) (pev m ts) (c l) l1 l2 l3) s.
Proof. intros P H ts I. destruct (at_point bs t P _ ts H I) as [l [F [O Il]]]. exists l. apply (leaf_sound m l ts O Il (c l) ss F). Qed.
Theorem family_theorem2 m bs t (c : cert2 (poly m)) ss : proper bs = true ->
  on_leaves bs t (fun l => check2 (poly m) (padd m) (psub m) (pmul m) (pofZ m) (plt m l) (ple m l) c ss) = true ->
  forall ts, in_box bs ts ->
  (exists l1 l2, has_gram2 (dgram2 (poly m) (pev m ts) c) l1 l2) /\
  forall l1 l2, has_gram2 (dgram2 (poly m) (pev m ts) c) l1 l2 ->
  edge_to_edge_tiling l1 l2 (e_rank _ c) (ddomain2 (poly m) (pev m ts) c l1 l2) (length (e_tris _ c)) (dtriangle (poly m) (pofZ m) (pev m ts) c l1 l2) /\
  forall s, In s (map (dstatement (poly m) (pev m ts)) ss) -> holds2 l1 l2 (e_rank _ c) (length (e_tris _ c)) (dtriangle (poly m) (pofZ m) (pev m ts) c l1 l2) s.
Proof. intros P H ts I. destruct (at_point bs t P _ ts H I) as [l [F [O Il]]]. apply (leaf_sound2 m l ts O Il c ss F). Qed.
End Soundness.
End Poly.
