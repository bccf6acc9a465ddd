(** * Derivatives in a form that composes; the arc cotangent; small facts on sines and cosines *)
From Coq Require Import Reals Lra Psatz.
Open Scope R_scope.

Definition slope (f : R -> R) (x l : R) := derivable_pt_lim f x l.
Lemma slope_eq f x l l' : slope f x l -> l = l' -> slope f x l'.
Proof. intros H <-. exact H. Qed.
Lemma slope_const k x : slope (fun _ => k) x 0.
Proof. exact (derivable_pt_lim_const k x). Qed.
Lemma slope_id x : slope (fun y => y) x 1.
Proof. exact (derivable_pt_lim_id x). Qed.
Lemma slope_plus f g x l m : slope f x l -> slope g x m -> slope (fun y => f y + g y) x (l + m).
Proof. exact (derivable_pt_lim_plus f g x l m). Qed.
Lemma slope_minus f g x l m : slope f x l -> slope g x m -> slope (fun y => f y - g y) x (l - m).
Proof. exact (derivable_pt_lim_minus f g x l m). Qed.
Lemma slope_mult f g x l m : slope f x l -> slope g x m -> slope (fun y => f y * g y) x (l * g x + f x * m).
Proof. exact (derivable_pt_lim_mult f g x l m). Qed.
Lemma slope_div f g x l m : slope f x l -> slope g x m -> g x <> 0 -> slope (fun y => f y / g y) x ((l * g x - m * f x) / (g x * g x)).
Proof. exact (derivable_pt_lim_div f g x l m). Qed.
Lemma slope_sin f x l : slope f x l -> slope (fun y => sin (f y)) x (cos (f x) * l).
Proof. intros H. exact (derivable_pt_lim_comp f sin x l _ H (derivable_pt_lim_sin (f x))). Qed.
Lemma slope_cos f x l : slope f x l -> slope (fun y => cos (f y)) x (- sin (f x) * l).
Proof. intros H. exact (derivable_pt_lim_comp f cos x l _ H (derivable_pt_lim_cos (f x))). Qed.
Lemma slope_atan f x l : slope f x l -> slope (fun y => atan (f y)) x (/ (1 + f x ^ 2) * l).
Proof. intros H. exact (derivable_pt_lim_comp f atan x l _ H (derivable_pt_lim_atan (f x))). Qed.

(** The mean value theorem, with a bound of the slope. *)
Lemma grows f f' m a b : a <= b -> (forall c, a <= c <= b -> slope f c (f' c)) -> (forall c, a <= c <= b -> m <= f' c) -> m * (b - a) <= f b - f a.
Proof.
  intros [L|<-] D M; [|lra]. destruct (MVT_cor2 f f' a b L D) as [c [E C]]. rewrite E.
  apply Rmult_le_compat_r; [lra|]. apply M. lra.
Qed.
Lemma grows_at_most f f' m a b : a <= b -> (forall c, a <= c <= b -> slope f c (f' c)) -> (forall c, a <= c <= b -> f' c <= m) -> f b - f a <= m * (b - a).
Proof.
  intros [L|<-] D M; [|lra]. destruct (MVT_cor2 f f' a b L D) as [c [E C]]. rewrite E.
  apply Rmult_le_compat_r; [lra|]. apply M. lra.
Qed.

(** The angle in (0, 180) with the cotangent x. *)
Definition acot (x : R) := PI / 2 - atan x.
Lemma acot_range x : 0 < acot x < PI.
Proof. unfold acot. pose proof (atan_bound x). lra. Qed.
Lemma acot_acute x : 0 < x -> acot x < PI / 2.
Proof. intros H. unfold acot. pose proof (atan_increasing 0 x H). rewrite atan_0 in *. lra. Qed.
Lemma one_plus x : 0 < 1 + x ^ 2.
Proof. pose proof (pow2_ge_0 x). lra. Qed.
Lemma square x : 0 <= x * x.
Proof. exact (Rle_0_sqr x). Qed.
Lemma acot_decreasing x y : x <= y -> acot y <= acot x.
Proof. intros [H|<-]; [|lra]. unfold acot. pose proof (atan_increasing x y H). lra. Qed.
Lemma acot_cot q : 0 < q < PI -> acot (cos q / sin q) = q.
Proof.
  intros H. unfold acot. replace (cos q / sin q) with (tan (PI / 2 - q)) by (unfold tan; rewrite sin_shift, cos_shift; reflexivity).
  rewrite atan_tan by lra. ring.
Qed.
Lemma cot_acot x : cos (acot x) = x * sin (acot x).
Proof.
  unfold acot. rewrite cos_shift, sin_shift. pose proof (tan_atan x) as E. unfold tan in E.
  pose proof (atan_bound x) as B. assert (0 < cos (atan x)) by (apply cos_gt_0; lra).
  rewrite <- E at 2. field. lra.
Qed.
Lemma sin_acot x : 0 < sin (acot x) /\ sin (acot x) * sin (acot x) * (1 + x ^ 2) = 1.
Proof.
  pose proof (acot_range x) as B. split; [apply sin_gt_0; lra|].
  pose proof (sin2_cos2 (acot x)) as S. unfold Rsqr in S. rewrite cot_acot in S. lra.
Qed.
Lemma slope_acot f x l : slope f x l -> slope (fun y => acot (f y)) x (- (/ (1 + f x ^ 2) * l)).
Proof. intros H. eapply slope_eq; [apply slope_minus; [apply slope_const|apply slope_atan, H]|]. ring. Qed.

(** Sines and cosines of acute angles. *)
Lemma squares x : sin x * sin x + cos x * cos x = 1.
Proof. exact (sin2_cos2 x). Qed.
Lemma sin_pos x : 0 < x < PI -> 0 < sin x.
Proof. intros. apply sin_gt_0; lra. Qed.
Lemma cos_pos x : 0 < x < PI / 2 -> 0 < cos x.
Proof. intros. apply cos_gt_0; lra. Qed.
Lemma cos_le x y : 0 <= x -> x <= y -> y <= PI -> cos y <= cos x.
Proof. intros. apply cos_decr_1; lra. Qed.
Lemma sin_le x y : 0 <= x -> x <= y -> y <= PI / 2 -> sin x <= sin y.
Proof. intros. apply sin_incr_1; lra. Qed.
Lemma angle_le x y : 0 <= x <= PI -> 0 <= y <= PI -> cos y <= cos x -> x <= y.
Proof. intros. apply cos_decr_0; lra. Qed.
Lemma acute_from x : 0 < x < PI -> 0 < cos x -> x < PI / 2.
Proof. intros X C. apply Rnot_le_lt. intros L. pose proof (cos_le_0 x L ltac:(lra)). lra. Qed.
