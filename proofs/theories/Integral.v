(** * Integrals of piecewise polynomial functions of one variable

    What Slices.v and Volume.v need of the integral, and no more: a function f has the integral v
    if it is, but for finitely many points, the derivative of a continuous function that
    is 0 far on the left and v far on the right.  No measure, no Riemann sums. *)
Require Import Reals Ranalysis5 Lra Psatz ZArith List Lia.
From Acutile Require Import Sums Crossing.
Import ListNotations.
Open Scope R_scope.

(** ** All but finitely many numbers *)
Definition ae (P : R -> Prop) := exists S : list R, forall t, ~ In t S -> P t.

Lemma ae_all (P : R -> Prop) : (forall t, P t) -> ae P.
Proof. intros H. exists []. auto. Qed.
Lemma ae_and (P Q : R -> Prop) : ae P -> ae Q -> ae (fun t => P t /\ Q t).
Proof.
  intros [S HS] [S' HS']. exists (S ++ S'). intros t Ht. rewrite in_app_iff in Ht. split; [apply HS | apply HS']; tauto.
Qed.
Lemma ae_imp (P Q : R -> Prop) : (forall t, P t -> Q t) -> ae P -> ae Q.
Proof. intros H [S HS]. exists S. auto. Qed.
Lemma ae_forall {A} (P : A -> R -> Prop) l : (forall a, In a l -> ae (P a)) -> ae (fun t => forall a, In a l -> P a t).
Proof.
  induction l as [|a l IH]; intros H; [apply ae_all; simpl; tauto|].
  apply ae_imp with (P := fun t => P a t /\ forall b, In b l -> P b t).
  - intros t [H1 H2] b [<-|Hb]; auto.
  - apply ae_and; [apply H; simpl; auto | apply IH; intros; apply H; simpl; auto].
Qed.
Lemma ae_neq a : ae (fun t => t <> a).
Proof. exists [a]. simpl. intuition. Qed.
Lemma ae_shift (P : R -> Prop) a : ae P -> ae (fun t => P (t - a)).
Proof.
  intros [S HS]. exists (map (fun s => s + a) S). intros t Ht. apply HS. intros I. apply Ht.
  apply in_map_iff. exists (t - a). split; [lra|auto].
Qed.
Lemma above_all (S : list R) : exists m, forall s, In s S -> s < m.
Proof.
  induction S as [|a S [m H]]; [exists 0; simpl; tauto|]. exists (Rmax m a + 1). pose proof (Rmax_l m a). pose proof (Rmax_r m a).
  intros s [<-|Hs]; [lra|]. specialize (H s Hs). lra.
Qed.
Lemma ae_exists (P : R -> Prop) : ae P -> exists t, P t.
Proof. intros [S HS]. destruct (above_all S) as [m Hm]. exists m. apply HS. intros I. specialize (Hm m I). lra. Qed.

(** ** Primitives *)
Definition primitive (F f : R -> R) := continuity F /\ ae (fun t => derivable_pt_lim F t (f t)).

Lemma primitive_ext F f g : ae (fun t => f t = g t) -> primitive F f -> primitive F g.
Proof. intros E [C D]. split; auto. apply ae_imp with (2 := ae_and _ _ D E). intros t [H <-]. exact H. Qed.
Lemma primitive_zero : primitive (fun _ => 0) (fun _ => 0).
Proof. split; [apply continuity_const; intros ? ?; auto|]. apply ae_all. intros t. apply derivable_pt_lim_const. Qed.
Lemma primitive_add F f G g : primitive F f -> primitive G g -> primitive (fun t => F t + G t) (fun t => f t + g t).
Proof.
  intros [C D] [C' D']. split; [apply (continuity_plus F G); auto|].
  apply ae_imp with (2 := ae_and _ _ D D'). intros t [H H']. apply (derivable_pt_lim_plus F G); auto.
Qed.
Lemma primitive_scal a F f : primitive F f -> primitive (fun t => a * F t) (fun t => a * f t).
Proof.
  intros [C D]. split; [apply (continuity_scal F a); auto|]. revert D. apply ae_imp. intros t. apply (derivable_pt_lim_scal F).
Qed.
Lemma primitive_sum {A} (F f : A -> R -> R) l : (forall a, In a l -> primitive (F a) (f a)) ->
  primitive (fun t => rsum (fun a => F a t) l) (fun t => rsum (fun a => f a t) l).
Proof.
  induction l as [|a l IH]; intros H; cbn [rsum]; [apply primitive_zero|].
  apply primitive_add; [apply H; simpl; auto | apply IH; intros; apply H; simpl; auto].
Qed.
Lemma primitive_shift F f a : primitive F f -> primitive (fun t => F (t - a)) (fun t => f (t - a)).
Proof.
  intros [C D]. split.
  - apply (continuity_comp (fun t => t - a) F); auto. apply (continuity_minus id (fun _ => a)); [apply derivable_continuous, derivable_id | apply continuity_const; intros ? ?; auto].
  - apply ae_shift with (a := a) in D. revert D. apply ae_imp. intros t D.
    replace (f (t - a)) with (f (t - a) * (1 - 0)) by ring.
    apply (derivable_pt_lim_comp (fun t => t - a) F); auto.
    apply (derivable_pt_lim_minus id (fun _ => a)); [apply derivable_pt_lim_id | apply derivable_pt_lim_const].
Qed.

(** The mean value theorem, finitely many points left out. *)
Lemma increasing_but F f S : continuity F -> forall a b, a <= b ->
  (forall t, a < t < b -> ~ In t S -> derivable_pt_lim F t (f t) /\ 0 <= f t) -> F a <= F b.
Proof.
  intros C. induction S as [|s S IH]; intros a b L H.
  - destruct (Req_dec a b) as [->|Ne]; [lra|]. assert (L' : a < b) by lra.
    assert (pr : forall c, a < c < b -> derivable_pt F c) by (intros c Hc; exists (f c); apply H; auto).
    destruct (MVT F id a b pr (fun c _ => derivable_pt_id c) L' (fun c _ => C c)
      (fun c _ => derivable_continuous_pt id c (derivable_pt_id c))) as [c [P E]].
    rewrite derive_pt_id in E. destruct (H c P) as [D P0]; [simpl; tauto|].
    rewrite (derive_pt_eq_0 F c (f c) (pr c P) D) in E. unfold id in E. nra.
  - destruct (Rlt_dec a s) as [A|A]; [destruct (Rlt_dec s b) as [B|B]|].
    + apply Rle_trans with (F s); apply IH; try lra; intros t Ht Hn; apply H; try lra; intros [E|E]; try (subst; lra); auto.
    + apply IH; auto. intros t Ht Hn. apply H; auto. intros [E|E]; [subst; lra|auto].
    + apply IH; auto. intros t Ht Hn. apply H; auto. intros [E|E]; [subst; lra|auto].
Qed.
Lemma increasing F f a b : primitive F f -> a <= b -> ae (fun t => a < t < b -> 0 <= f t) -> F a <= F b.
Proof.
  intros [C D] L P. destruct (ae_and _ _ D P) as [S HS]. apply (increasing_but F f S); auto.
  intros t Ht Hn. destruct (HS t Hn) as [H1 H2]. auto.
Qed.
Lemma constant F f a b : primitive F f -> a <= b -> ae (fun t => a < t < b -> f t = 0) -> F a = F b.
Proof.
  intros H L Z. apply Rle_antisym.
  - apply (increasing F f); auto. revert Z. apply ae_imp. intros t E I. rewrite E by auto. lra.
  - apply (primitive_scal (-1)) in H. cut (-1 * F a <= -1 * F b); [lra|].
    apply (increasing (fun t => -1 * F t) (fun t => -1 * f t)); auto.
    revert Z. apply ae_imp. intros t E I. rewrite E by auto. lra.
Qed.

(** ** Integrals *)
Definition integral (M : R) (f : R -> R) (v : R) :=
  exists F, primitive F f /\ (forall t, t <= - M -> F t = 0) /\ (forall t, M <= t -> F t = v).

Lemma integral_scal M a f v : integral M f v -> integral M (fun t => a * f t) (a * v).
Proof.
  intros [F [P [Z V]]]. exists (fun t => a * F t). split; [apply primitive_scal; auto|].
  split; intros t Ht; [rewrite Z by auto; ring | rewrite V by auto; auto].
Qed.
Lemma integral_sum {A} M (f : A -> R -> R) v l : (forall a, In a l -> integral M (f a) (v a)) ->
  integral M (fun t => rsum (fun a => f a t) l) (rsum v l).
Proof.
  induction l as [|a l IH]; intros H; cbn [rsum].
  - exists (fun _ => 0). split; [apply primitive_zero|]. auto.
  - destruct (H a) as [F [P [Z V]]]; [simpl; auto|]. destruct IH as [G [P' [Z' V']]]; [intros; apply H; simpl; auto|].
    exists (fun t => F t + G t). split; [apply primitive_add; auto|].
    split; intros t Ht; [rewrite Z, Z' by auto; ring | rewrite V, V' by auto; auto].
Qed.
Lemma integral_zero M f v : 0 < M -> integral M f v -> ae (fun t => f t = 0) -> v = 0.
Proof.
  intros HM [F [P [Z V]]] E. rewrite <- (V M), <- (Z (- M)) by lra. symmetry. apply (constant F f); auto; [lra|].
  revert E. apply ae_imp. auto.
Qed.

(** The sum of the translates of f by the multiples of h, if it is nowhere negative on a
    period, makes the integral nonnegative: what the primitive gains over one period is, telescoped, all of v. *)
Lemma telescope (u : Z -> R) K : rsum (fun n => u (n - 1)%Z - u n) (zr K) = u (- Z.of_nat K - 1)%Z - u (Z.of_nat K).
Proof.
  unfold zr. rewrite rsum_map.
  assert (X : forall m, rsum (fun j => u (Z.of_nat j - Z.of_nat K - 1)%Z - u (Z.of_nat j - Z.of_nat K)%Z) (seq 0 m)
     = u (- Z.of_nat K - 1)%Z - u (Z.of_nat m - 1 - Z.of_nat K)%Z).
  { induction m as [|m IH]; [cbn [seq rsum]; replace (Z.of_nat 0 - 1 - Z.of_nat K)%Z with (- Z.of_nat K - 1)%Z by lia; lra|].
    rewrite seq_S, rsum_app, IH. cbn [rsum Nat.add].
    replace (Z.of_nat (S m) - 1 - Z.of_nat K)%Z with (Z.of_nat m - Z.of_nat K)%Z by lia.
    replace (Z.of_nat m - Z.of_nat K - 1)%Z with (Z.of_nat m - 1 - Z.of_nat K)%Z by lia. lra. }
  rewrite X. f_equal. f_equal. lia.
Qed.
Lemma fold_nonneg M f v w h K : integral M f v -> 0 < h ->
  w - h * IZR (Z.of_nat K) <= - M -> M <= w + h + h * IZR (Z.of_nat K) ->
  ae (fun t => w < t < w + h -> 0 <= rsum (fun n => f (t - h * IZR n)) (zr K)) -> 0 <= v.
Proof.
  intros [F [P [Z V]]] Hh L R H.
  pose proof (increasing (fun t => rsum (fun n => F (t - h * IZR n)) (zr K)) (fun t => rsum (fun n => f (t - h * IZR n)) (zr K)) w (w + h)) as I.
  assert (E : rsum (fun n => F (w + h - h * IZR n)) (zr K) - rsum (fun n => F (w - h * IZR n)) (zr K) = v).
  { rewrite <- rsum_sub. rewrite (rsum_ext _ (fun n => F (w - h * IZR (n - 1)) - F (w - h * IZR n))).
    2:{ intros n _. f_equal. f_equal. rewrite minus_IZR. ring. }
    rewrite (telescope (fun n => F (w - h * IZR n)) K). rewrite V, Z; [ring|lra|]. rewrite minus_IZR, opp_IZR. lra. }
  apply Rge_le, Rle_ge. rewrite <- E. apply Rge_le, Rge_minus, Rle_ge, I; auto; [|lra].
  apply primitive_sum. intros n _. apply primitive_shift, P.
Qed.

(** ** Sums of steps: g_i(t) for t < u_i, with the primitives G_i *)
Definition b2r (b : bool) : R := if b then 1 else 0.

Lemma Rmin_continuity u : continuity (fun t => Rmin t u).
Proof.
  intros x. intros e He. exists e. split; auto. intros y [_ Hy]. simpl in *. unfold R_dist in *.
  apply Rle_lt_trans with (2 := Hy). unfold Rmin. destruct (Rle_dec y u), (Rle_dec x u); unfold Rabs; repeat (destruct (Rcase_abs _)); lra.
Qed.
Lemma primitive_step G g u : (forall t, derivable_pt_lim G t (g t)) ->
  primitive (fun t => G (Rmin t u)) (fun t => b2r (posb (u - t)) * g t).
Proof.
  intros D. split.
  - apply (continuity_comp (fun t => Rmin t u) G); [apply Rmin_continuity|]. intros t. apply derivable_continuous_pt. exists (g t). apply D.
  - apply ae_imp with (2 := ae_neq u). intros t Ne. unfold posb. destruct (Rlt_dec 0 (u - t)) as [L|L]; cbn [b2r].
    + rewrite Rmult_1_l. apply (derivable_pt_lim_locally_ext G _ t (t - 1) u); [lra| |apply D].
      intros z Hz. rewrite Rmin_left by lra. auto.
    + rewrite Rmult_0_l. apply (derivable_pt_lim_locally_ext (fun _ => G u) _ t u (t + 1)); [lra| |apply derivable_pt_lim_const].
      intros z Hz. rewrite Rmin_right by lra. auto.
Qed.

Lemma integral_steps {A} (l : list A) (u : A -> R) (g G : A -> R -> R) M f :
  (forall i t, In i l -> derivable_pt_lim (G i) t (g i t)) ->
  (forall t, rsum (fun i => G i t) l = 0) ->
  ae (fun t => f t = rsum (fun i => b2r (posb (u i - t)) * g i t) l) ->
  ae (fun t => M < Rabs t -> f t = 0) ->
  integral M f (rsum (fun i => G i (u i)) l).
Proof.
  intros D Z E S. set (F := fun t => rsum (fun i => G i (Rmin t (u i))) l).
  assert (P : primitive F f).
  { apply primitive_ext with (f := fun t => rsum (fun i => b2r (posb (u i - t)) * g i t) l).
    - revert E. apply ae_imp. auto.
    - apply primitive_sum. intros i Hi. apply primitive_step. auto. }
  assert (FAR : forall a b, a <= b -> b <= - M \/ M <= a -> F a = F b).
  { intros a b L H. apply (constant F f); auto. revert S. apply ae_imp. intros t K I. apply K. unfold Rabs. destruct (Rcase_abs t); lra. }
  destruct (above_all (map u l)) as [m1 H1]. destruct (above_all (map (fun i => - u i) l)) as [m2 H2].
  exists F. split; auto. split; intros t Ht.
  - rewrite <- (FAR (Rmin t (- m2)) t); [|apply Rmin_l|left; auto]. pose proof (Rmin_r t (- m2)).
    set (s := Rmin t (- m2)) in *. rewrite <- (Z s). apply rsum_ext. intros i Hi. f_equal. apply Rmin_left.
    specialize (H2 (- u i) (in_map (fun i => - u i) l i Hi)). lra.
  - rewrite (FAR t (Rmax t m1)); [|apply Rmax_l|right; auto]. pose proof (Rmax_r t m1).
    set (s := Rmax t m1) in *. apply rsum_ext. intros i Hi. f_equal. apply Rmin_right.
    specialize (H1 (u i) (in_map u l i Hi)). lra.
Qed.

(** The primitives that occur. *)
Lemma linear_primitive a t : derivable_pt_lim (fun t => a * t) t a.
Proof. pose proof (derivable_pt_lim_scal id a t 1 (derivable_pt_lim_id t)) as H. rewrite Rmult_1_r in H. exact H. Qed.
Definition cubic (c0 c1 c2 t : R) := c0 * t + c1 * (t * t) / 2 + c2 * (t * t * t) / 3.
Lemma cubic_primitive c0 c1 c2 t : derivable_pt_lim (cubic c0 c1 c2) t (c0 + c1 * t + c2 * (t * t)).
Proof.
  assert (D1 := derivable_pt_lim_id t). assert (D2 := derivable_pt_lim_mult id id t 1 1 D1 D1).
  assert (D3 := derivable_pt_lim_mult _ id t _ 1 D2 D1).
  assert (D := derivable_pt_lim_plus _ _ t _ _ (derivable_pt_lim_plus _ _ t _ _ (derivable_pt_lim_scal _ c0 t _ D1) (derivable_pt_lim_scal _ (c1 / 2) t _ D2)) (derivable_pt_lim_scal _ (c2 / 3) t _ D3)).
  apply (derivable_pt_lim_locally_ext _ (cubic c0 c1 c2) t (t - 1) (t + 1)) in D; [|lra|].
  - match type of D with derivable_pt_lim _ _ ?l => replace (c0 + c1 * t + c2 * (t * t)) with l; auto end.
    unfold mult_fct, id. field.
  - intros z _. unfold cubic, plus_fct, mult_real_fct, mult_fct, id. field.
Qed.
