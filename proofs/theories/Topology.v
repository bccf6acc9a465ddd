(* Open sets in R^3 (sup norm) and generic points. *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing Tetrahedra.
Import ListNotations.
Open Scope R_scope.

Definition open (U : point -> Prop) := forall x, U x -> exists e, 0 < e /\ forall y, near e x y -> U y.

Lemma near_refl e x : 0 < e -> near e x x.
Proof. intros. unfold near. rewrite !Rminus_diag_eq by auto. rewrite Rabs_R0. auto. Qed.
Lemma near_mono e e' x y : e <= e' -> near e x y -> near e' x y.
Proof. unfold near. intuition lra. Qed.

Lemma near_opn e x : open (near e x).
Proof.
  intros y [A [B C]].
  exists (Rmin (e - Rabs (px y - px x)) (Rmin (e - Rabs (py y - py x)) (e - Rabs (pz y - pz x)))).
  split. { repeat apply Rmin_glb_lt; lra. }
  intros z [A' [B' C']].
  pose proof (Rmin_l (e - Rabs (px y - px x)) (Rmin (e - Rabs (py y - py x)) (e - Rabs (pz y - pz x)))).
  pose proof (Rmin_r (e - Rabs (px y - px x)) (Rmin (e - Rabs (py y - py x)) (e - Rabs (pz y - pz x)))).
  pose proof (Rmin_l (e - Rabs (py y - py x)) (e - Rabs (pz y - pz x))).
  pose proof (Rmin_r (e - Rabs (py y - py x)) (e - Rabs (pz y - pz x))).
  repeat split.
  - replace (px z - px x) with ((px z - px y) + (px y - px x)) by ring.
    pose proof (Rabs_triang (px z - px y) (px y - px x)). lra.
  - replace (py z - py x) with ((py z - py y) + (py y - py x)) by ring.
    pose proof (Rabs_triang (py z - py y) (py y - py x)). lra.
  - replace (pz z - pz x) with ((pz z - pz y) + (pz y - pz x)) by ring.
    pose proof (Rabs_triang (pz z - pz y) (pz y - pz x)). lra.
Qed.

Lemma near_convex e x p q s : near e x p -> near e x q -> 0 <= s <= 1 -> near e x (lerp p q s).
Proof.
  intros [A [B C]] [A' [B' C']] S.
  assert (K : forall a b c, Rabs (a - c) < e -> Rabs (b - c) < e -> Rabs (a + s * (b - a) - c) < e).
  { clear - S. intros a b c H H'. apply Rabs_def2 in H. apply Rabs_def2 in H'.
    apply Rabs_def1.
    - assert (0 <= s * (e - (b - c))) by (apply Rmult_le_pos; lra).
      assert (0 <= (1 - s) * (e - (a - c))) by (apply Rmult_le_pos; lra).
      destruct (Rlt_dec 0 s); [|assert (s = 0) by lra; subst; lra].
      assert (0 < s * (e - (b - c))) by (apply Rmult_lt_0_compat; lra). lra.
    - assert (0 <= s * (e + (b - c))) by (apply Rmult_le_pos; lra).
      assert (0 <= (1 - s) * (e + (a - c))) by (apply Rmult_le_pos; lra).
      destruct (Rlt_dec 0 s); [|assert (s = 0) by lra; subst; lra].
      assert (0 < s * (e + (b - c))) by (apply Rmult_lt_0_compat; lra). lra. }
  repeat split; unf; apply K; auto.
Qed.

Lemma opn_and U V : open U -> open V -> open (fun x => U x /\ V x).
Proof.
  intros HU HV x [Hx Hy]. destruct (HU x Hx) as [e [He H]], (HV x Hy) as [e' [He' H']].
  exists (Rmin e e'). split; [apply Rmin_glb_lt; auto|]. intros y N. split.
  - apply H. eapply near_mono; [|exact N]. apply Rmin_l.
  - apply H'. eapply near_mono; [|exact N]. apply Rmin_r.
Qed.
Lemma opn_or U V : open U -> open V -> open (fun x => U x \/ V x).
Proof.
  intros HU HV x [Hx|Hx]; [destruct (HU x Hx) as [e [He H]] | destruct (HV x Hx) as [e [He H]]];
  exists e; split; auto.
Qed.
Lemma opn_const (P : Prop) : open (fun _ => P).
Proof. intros x H. exists 1. split; [lra|auto]. Qed.
Lemma opn_ext U V : (forall x, U x <-> V x) -> open U -> open V.
Proof. intros E H x Hx. apply E in Hx. destruct (H x Hx) as [e [He K]]. exists e. split; auto. intros; apply E; auto. Qed.
Lemma opn_all {A} (P : A -> point -> Prop) l : (forall a, In a l -> open (P a)) -> open (fun x => forall a, In a l -> P a x).
Proof.
  induction l as [|a l IH]; intros H.
  - intros x _. exists 1. split; [lra|]. simpl; tauto.
  - apply opn_ext with (U := fun x => P a x /\ forall b, In b l -> P b x).
    + intros x. simpl. split; [intros [H1 H2] b [<-|Hb]; auto | intros K; split; auto].
    + apply opn_and. { apply H; simpl; auto. } apply IH. intros; apply H; simpl; auto.
Qed.
Lemma opn_ex {A} (P : A -> point -> Prop) l : (forall a, In a l -> open (P a)) -> open (fun x => exists a, In a l /\ P a x).
Proof.
  intros H x [a [Ha Hx]]. destruct (H a Ha x Hx) as [e [He K]]. exists e. split; auto.
  intros y N. exists a. auto.
Qed.

(* affine functions *)
Definition affine (f : point -> R) := exists a b c d, forall x, f x = a * px x + b * py x + c * pz x + d.
Lemma aff_lerp f p q s : affine f -> f (lerp p q s) = f p + s * (f q - f p).
Proof. intros [a [b [c [d H]]]]. rewrite !H. unf. ring. Qed.
Lemma aff_o f : affine (side f).
Proof.
  set (u := sub (t2 f) (t1 f)). set (v := sub (t3 f) (t1 f)).
  exists (py u * pz v - pz u * py v), (pz u * px v - px u * pz v), (px u * py v - py u * px v),
   (- (det u v (t1 f))). intros x. unfold side. unfold u, v. unf. ring.
Qed.
Lemma aff_D2 p a b : affine (fun x => orient p x a b).
Proof.
  destruct (aff_o (Triangle p a b)) as [k1 [k2 [k3 [k4 H]]]]. exists k1, k2, k3, k4. intros x. rewrite <- H.
  unfold side; cbn [t1 t2 t3]. unf. ring.
Qed.
Lemma aff_opp f : affine f -> affine (fun x => - f x).
Proof. intros [a [b [c [d H]]]]. exists (-a), (-b), (-c), (-d). intros x. rewrite H. ring. Qed.

Lemma aff_pos_opn f : affine f -> open (fun x => 0 < f x).
Proof.
  intros [a [b [c [d H]]]] x Hx. set (M := Rabs a + Rabs b + Rabs c + 1).
  pose proof (Rabs_pos a); pose proof (Rabs_pos b); pose proof (Rabs_pos c).
  assert (0 < M) by (unfold M; lra).
  exists (f x / M). split. { apply Rdiv_lt_0_compat; auto. }
  set (e := f x / M). assert (E : e * M = f x) by (unfold e; field; lra).
  intros y [A [B C]].
  assert (F : f y = f x + (a * (px y - px x) + b * (py y - py x) + c * (pz y - pz x))) by (rewrite !H; ring).
  assert (K : forall k d, Rabs d < e -> - (Rabs k * e) <= k * d).
  { intros k dd Hd. assert (Rabs (k * dd) <= Rabs k * e).
    { rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos|lra]. }
    pose proof (Rle_abs (- (k * dd))). rewrite Rabs_Ropp in *. lra. }
  pose proof (K a _ A). pose proof (K b _ B). pose proof (K c _ C).
  assert (0 < e). { pose proof (Rabs_pos (px y - px x)). lra. }
  unfold M in E. rewrite F. nra.
Qed.
Lemma aff_neg_opn f : affine f -> open (fun x => f x < 0).
Proof. intros H. apply opn_ext with (U := fun x => 0 < - f x); [intros; lra|]. apply (aff_pos_opn (fun x => - f x)), aff_opp, H. Qed.
Lemma aff_nz_opn f : affine f -> open (fun x => f x <> 0).
Proof.
  intros H. apply opn_ext with (U := fun x => 0 < f x \/ f x < 0); [intros; lra|].
  apply opn_or; [apply aff_pos_opn | apply aff_neg_opn]; auto.
Qed.

(* points close to x on the segment to z *)
Lemma lerp_near e x z : 0 < e -> exists s, 0 < s < 1 /\ near e x (lerp x z s).
Proof.
  intros He. set (M := Rabs (px z - px x) + Rabs (py z - py x) + Rabs (pz z - pz x) + e + 1).
  pose proof (Rabs_pos (px z - px x)); pose proof (Rabs_pos (py z - py x)); pose proof (Rabs_pos (pz z - pz x)).
  exists (e / M). assert (M > 0) by (unfold M; lra).
  assert (P : 0 < e / M) by (apply Rdiv_lt_0_compat; auto).
  assert (E : e / M * M = e) by (field; lra).
  assert (Q : e / M < 1).
  { apply Rmult_lt_reg_r with M; auto. rewrite E. unfold M. lra. }
  split; [lra|]. set (s := e / M) in *.
  unfold near, lerp, add, scale, sub; cbn [px py pz].
  repeat split; match goal with |- Rabs (?u + s * ?w - ?u) < e => replace (u + s * w - u) with (s * w) by ring end;
  rewrite Rabs_mult, (Rabs_right s) by lra; unfold M in E; nra.
Qed.

Lemma generic : forall (l : list (point -> R)) (U : point -> Prop),
  (forall f, In f l -> affine f /\ exists z, f z <> 0) -> open U -> (exists x, U x) ->
  exists x, U x /\ forall f, In f l -> f x <> 0.
Proof.
  induction l as [|f l IH]; intros U H HU [x Hx].
  - exists x. simpl; tauto.
  - destruct (H f (or_introl eq_refl)) as [Af [z Hz]].
    destruct (IH (fun x => U x /\ f x <> 0)) as [y [[Hy1 Hy2] Hy3]].
    + intros; apply H; simpl; auto.
    + apply opn_and; auto. apply aff_nz_opn; auto.
    + destruct (Req_EM_T (f x) 0) as [E|E]; [|exists x; auto].
      destruct (HU x Hx) as [e [He K]]. destruct (lerp_near e x z He) as [s [Hs N]].
      exists (lerp x z s). split; auto. rewrite aff_lerp by auto. rewrite E. nra.
    + exists y. split; auto. intros g [<-|Hg]; auto.
Qed.

Lemma inter_opn t : open (inside t).
Proof. unfold inside. apply opn_all. intros i _. apply aff_pos_opn, aff_o. Qed.
Lemma not_closed_iff t x : ~ closed t x <-> exists i, In i I4 /\ coord t i x < 0.
Proof.
  split.
  - intros H. destruct (existsb (fun i => posb (- coord t i x)) I4) eqn:E.
    + apply existsb_exists in E as [i [Hi E]]. apply posb_t in E. exists i; split; auto; lra.
    + exfalso. apply H. intros i Hi. apply Rnot_lt_le. intros N.
      assert (existsb (fun i => posb (- coord t i x)) I4 = true); [|congruence].
      apply existsb_exists. exists i; split; auto. apply posb_t. lra.
  - intros [i [Hi H]] C. specialize (C i Hi). lra.
Qed.
Lemma not_closed_opn t : open (fun x => ~ closed t x).
Proof.
  apply opn_ext with (U := fun x => exists i, In i I4 /\ coord t i x < 0).
  - intros; symmetry; apply not_closed_iff.
  - apply opn_ex. intros i _. apply aff_neg_opn, aff_o.
Qed.

(* every closed tetrahedron point is a limit of interior points *)
Definition centroid t := combination t (/4) (/4) (/4) (/4).
Lemma cen_inter t : 0 < vol t -> inside t (centroid t).
Proof.
  intros V i Hi. destruct (L_comb4 t (/4) (/4) (/4) (/4) ltac:(lra)) as [A [B [C E]]]. unfold centroid.
  simpl in Hi. destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; nra.
Qed.
Lemma closed_limit t x e : 0 < vol t -> closed t x -> 0 < e -> exists y, near e x y /\ inside t y.
Proof.
  intros V C He. destruct (lerp_near e x (centroid t) He) as [s [Hs N]]. exists (lerp x (centroid t) s).
  split; auto. intros i Hi. unfold coord. rewrite o_lerp. pose proof (C i Hi) as A. pose proof (cen_inter t V i Hi) as B.
  unfold coord in *. nra.
Qed.
