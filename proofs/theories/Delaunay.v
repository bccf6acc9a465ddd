(** * Delaunay's lemma: local implies global

    With the inner product of a Gram matrix G.  The power
    of a point x with respect to the circumsphere of t is
      power t x = |x|^2 - sum_j lambda_j(x) |v_j|^2 = - sum_j lambda_j(x) |v_j - x|^2,
    lambda_j the barycentric coordinates: so no centre and no radius is needed.
    If the vertex behind each facet has power >= 0, every vertex has; if it is > 0
    behind every facet, only a tile's own vertices have power 0. *)
Require Import Reals Lra ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Domain Euclid.
From Acutile Require Cells.
Import ListNotations.
Open Scope R_scope.

Section Power.
Variable G : gram.
Definition sq (u : point) := gdot G u u.

Definition lift (t : tetrahedron) (x : point) :=
  - (coord t 0 x * sq (va t) + coord t 1 x * sq (vb t) + coord t 2 x * sq (vc t) + coord t 3 x * sq (vd t)) / vol t.
Definition power t x := sq x + lift t x.
(** vol t times the power, negated, as the checker computes it. *)
Definition power_sum t x :=
  coord t 0 x * sq (sub (va t) x) + coord t 1 x * sq (sub (vb t) x) + coord t 2 x * sq (sub (vc t) x) + coord t 3 x * sq (sub (vd t) x).

Lemma sq_sub v x : sq (sub v x) = sq v + (sq x - 2 * gdot G v x).
Proof. unfold sq, gdot. unf. ring. Qed.
Lemma aff_gdot x : affine (fun v => gdot G v x).
Proof.
  exists (g11 G * px x + g12 G * py x + g13 G * pz x), (g12 G * px x + g22 G * py x + g23 G * pz x), (g13 G * px x + g23 G * py x + g33 G * pz x), 0.
  intros v. unfold gdot. ring.
Qed.
Lemma power_power_sum t x : vol t <> 0 -> vol t * power t x = - power_sum t x.
Proof.
  intros V. unfold power_sum. rewrite !sq_sub.
  assert (A : affine (fun v => sq x - 2 * gdot G v x)).
  { destruct (aff_gdot x) as [a [b [c [d H]]]]. exists (-2 * a), (-2 * b), (-2 * c), (sq x - 2 * d).
    intros v. rewrite H. ring. }
  pose proof (interpolate t (fun v => sq x - 2 * gdot G v x) x A) as E. cbv beta in E. fold (sq x) in E.
  assert (P : vol t * power t x = vol t * sq x - (coord t 0 x * sq (va t) + coord t 1 x * sq (vb t) + coord t 2 x * sq (vc t) + coord t 3 x * sq (vd t))).
  { unfold power, lift. field. auto. }
  rewrite P. lra.
Qed.
Lemma aff_L t i : affine (coord t i).
Proof. apply aff_o. Qed.
Lemma aff_add f g : affine f -> affine g -> affine (fun x => f x + g x).
Proof. intros [a [b [c [d H]]]] [a' [b' [c' [d' H']]]]. exists (a+a'), (b+b'), (c+c'), (d+d'). intros. rewrite H, H'. ring. Qed.
Lemma aff_scl k f : affine f -> affine (fun x => k * f x).
Proof. intros [a [b [c [d H]]]]. exists (k*a), (k*b), (k*c), (k*d). intros. rewrite H. ring. Qed.
Lemma aff_ext f g : (forall x, f x = g x) -> affine f -> affine g.
Proof. intros E [a [b [c [d H]]]]. exists a, b, c, d. intros. rewrite <- E. auto. Qed.
Lemma aff_lift t : affine (lift t).
Proof.
  apply aff_ext with (f := fun x => (- / vol t) * (coord t 0 x * sq (va t) + coord t 1 x * sq (vb t) + coord t 2 x * sq (vc t) + coord t 3 x * sq (vd t))).
  { intros. unfold lift, Rdiv. ring. }
  assert (K : forall i k, affine (fun x => coord t i x * k)).
  { intros i k. apply aff_ext with (f := fun x => k * coord t i x); [intros; ring|]. apply aff_scl, aff_L. }
  apply aff_scl. apply aff_add; [apply aff_add; [apply aff_add|]|]; apply K.
Qed.
Lemma L_vx' t i j : In i I4 -> In j I4 -> i <> j -> coord t i (vx t j) = 0.
Proof.
  intros Hi Hj Ne. simpl in Hi, Hj.
  destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; destruct Hj as [<-|[<-|[<-|[<-|[]]]]]; try lia;
  unfold coord, side, vol; cbn [facet vx t1 t2 t3]; unf; ring.
Qed.
Lemma power_vertex t v : vol t <> 0 -> In v (verts t) -> power t v = 0.
Proof.
  intros V Hv.
  assert (X : exists j, In j I4 /\ v = vx t j).
  { simpl in Hv. destruct Hv as [<-|[<-|[<-|[<-|[]]]]]; [exists 0%nat|exists 1%nat|exists 2%nat|exists 3%nat]; (split; [simpl; tauto|reflexivity]). }
  destruct X as [j [Hj ->]].
  assert (K : forall i, In i I4 -> coord t i (vx t j) = if Nat.eqb i j then vol t else 0).
  { intros i Hi. destruct (Nat.eqb_spec i j) as [->|Ne]; [apply L_vx; auto | apply L_vx'; auto]. }
  unfold power, lift. rewrite !K by (simpl; auto).
  simpl in Hj. destruct Hj as [<-|[<-|[<-|[<-|[]]]]]; cbn; field; auto.
Qed.
(** Translation invariance. *)
Lemma power_translate t u x : vol t <> 0 -> power (translate u t) (add x u) = power t x.
Proof.
  intros V. apply Rmult_eq_reg_l with (vol t); auto. rewrite power_power_sum by auto.
  rewrite <- (vol_ttr u t), power_power_sum by (rewrite vol_ttr; auto). f_equal.
  assert (K : forall i, coord (translate u t) i (add x u) = coord t i x).
  { intros i. unfold coord, side. rewrite facet_translate. unfold translate_triangle; cbn [t1 t2 t3]. unf. ring. }
  assert (S : forall v, sub (add v u) (add x u) = sub v x) by (intros; apply point_eq; unf; ring).
  unfold power_sum. rewrite !K. unfold translate; cbn [va vb vc vd]. rewrite !S. reflexivity.
Qed.

(** Two tetrahedra with a common facet: the difference of the powers is a multiple
    of the coordinate of that facet. *)
Lemma power_difference t i t' i' y : In i I4 -> In i' I4 -> 0 < vol t -> 0 < vol t' ->
  opposite (facet t i) (facet t' i') ->
  vol t' * (power t y - power t' y) = - coord t i y * power t (vx t' i').
Proof.
  intros Hi Hi' V V' OP.
  assert (A : affine (fun y => power t y - power t' y)).
  { apply aff_ext with (f := fun y => lift t y + (-1) * lift t' y); [intros; unfold power; ring|].
    apply aff_add; [|apply aff_scl]; apply aff_lift. }
  rewrite (interpolate t' _ y A).
  assert (SH : forall j, In j I4 -> j <> i' -> power t (vx t' j) - power t' (vx t' j) = 0).
  { intros j Hj Ne. rewrite (power_vertex t'), (power_vertex t); [ring|lra| |lra|].
    - clear - OP Hi Hi' Hj Ne. simpl in Hi, Hi', Hj. unfold opposite in OP.
      destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; destruct Hi' as [<-|[<-|[<-|[<-|[]]]]]; destruct Hj as [<-|[<-|[<-|[<-|[]]]]];
      try lia; cbn [facet t1 t2 t3 vx verts] in *; simpl; intuition congruence.
    - clear - Hj. simpl in Hj. destruct Hj as [<-|[<-|[<-|[<-|[]]]]]; simpl; auto. }
  assert (AP : power t (vx t' i') - power t' (vx t' i') = power t (vx t' i')).
  { rewrite (power_vertex t'); [ring|lra|]. clear - Hi'. simpl in Hi'. destruct Hi' as [<-|[<-|[<-|[<-|[]]]]]; simpl; auto. }
  assert (OC : coord t i y = - coord t' i' y) by (unfold coord; apply oddm_o; auto).
  rewrite OC, Ropp_involutive.
  simpl in Hi'. destruct Hi' as [<-|[<-|[<-|[<-|[]]]]];
  pose proof (SH 0%nat ltac:(simpl; auto)) as S0; pose proof (SH 1%nat ltac:(simpl; auto)) as S1;
  pose proof (SH 2%nat ltac:(simpl; auto)) as S2; pose proof (SH 3%nat ltac:(simpl; auto)) as S3; cbn [vx] in *;
  rewrite AP; rewrite ?S0, ?S1, ?S2, ?S3 by lia; ring.
Qed.
End Power.

Lemma verts_vx t v : In v (verts t) -> exists j, In j I4 /\ v = vx t j.
Proof. simpl. intros [<-|[<-|[<-|[<-|[]]]]]; [exists 0%nat|exists 1%nat|exists 2%nat|exists 3%nat]; (split; [simpl; tauto|reflexivity]). Qed.
Lemma closed_vertex t v : 0 < vol t -> In v (verts t) -> closed t v /\ carT t v v.
Proof.
  intros V Hv. split.
  - apply hull_closed; auto. simpl in Hv.
    destruct Hv as [<-|[<-|[<-|[<-|[]]]]]; [exists 1,0,0,0|exists 0,1,0,0|exists 0,0,1,0|exists 0,0,0,1];
    repeat split; try lra; unfold combination; apply point_eq; unf; ring.
  - simpl in Hv. destruct Hv as [<-|[<-|[<-|[<-|[]]]]]; [exists 1,0,0,0|exists 0,1,0,0|exists 0,0,1,0|exists 0,0,0,1];
    repeat split; try lra; try (unfold combination; apply point_eq; unf; ring); auto.
    + left; split; auto; lra.
    + right; left; split; auto; lra.
    + right; right; left; split; auto; lra.
    + right; right; right; split; auto; lra.
Qed.

(** ** The cells of Cells.v *)
Section AnyCells.
Variables (cell : Type) (eq_dec : forall a b : cell, {a = b} + {a <> b}).
Variables (piece : cell -> tetrahedron) (valid : cell -> Prop) (Dom : point -> Prop).
Variables (paired : cell * nat -> Prop) (across : cell * nat -> cell * nat).
Hypothesis positive : forall c, valid c -> 0 < vol (piece c).
Hypothesis range : forall M, exists L, Cells.finite_part cell valid L /\ Cells.reaches cell piece valid L M.
Hypothesis mates : forall c i, valid c -> In i I4 -> paired (c, i) ->
  valid (fst (across (c, i))) /\ In (snd (across (c, i))) I4 /\ across (across (c, i)) = (c, i) /\
  opposite (facet (piece c) i) (facet (piece (fst (across (c, i)))) (snd (across (c, i)))) /\ paired (across (c, i)).
Hypothesis boundary : forall c i, valid c -> In i I4 -> paired (c, i) \/ forall y, Dom y -> 0 < coord (piece c) i y.
Hypothesis Dom_convex : forall p q s, Dom p -> Dom q -> 0 <= s <= 1 -> Dom (lerp p q s).
Hypothesis Dom_inside : forall c x, valid c -> inside (piece c) x -> Dom x.
Hypothesis once : Cells.covered_once cell piece valid Dom.
Variable G : gram.
(** The vertex of the mate that is behind the facet (c, i). *)
Definition behind (c : cell) (i : nat) : point := vx (piece (fst (across (c, i)))) (snd (across (c, i))).
Hypothesis local : forall c i, valid c -> In i I4 -> paired (c, i) -> 0 <= power G (piece c) (behind c i).

Lemma across_power c i y : valid c -> In i I4 -> paired (c, i) ->
  exists a, 0 <= a /\ power G (piece c) y - power G (piece (fst (across (c, i)))) y = - coord (piece c) i y * a.
Proof.
  intros Hc Hi PA. destruct (mates c i Hc Hi PA) as [S1 [S2 [S3 [S4 _]]]].
  pose proof (local c i Hc Hi PA) as LC. unfold behind in LC. set (ci := across (c, i)) in *.
  pose proof (positive _ Hc) as V. pose proof (positive _ S1) as V'.
  exists (power G (piece c) (vx (piece (fst ci)) (snd ci)) / vol (piece (fst ci))). split.
  - apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat; auto.
  - apply Rmult_eq_reg_l with (vol (piece (fst ci))); [|lra].
    rewrite (power_difference G (piece c) i _ (snd ci) y) by auto. field. lra.
Qed.

Theorem cells_weakly_delaunay c c' v : valid c -> valid c' -> In v (verts (piece c')) -> 0 <= power G (piece c) v.
Proof.
  intros Hc Hc' Hv. pose proof (positive _ Hc') as V'.
  rewrite <- (power_vertex G (piece c') v) by (auto; lra). unfold power.
  apply Rplus_le_compat_l.
  apply (Cells.local_to_global cell eq_dec piece valid Dom paired across positive range mates boundary Dom_convex Dom_inside
           once (fun c => lift G (piece c))); auto.
  - intros d d'. apply aff_ext with (f := fun y => lift G (piece d) y + (-1) * lift G (piece d') y); [intros; ring|].
    apply aff_add; [|apply aff_scl]; apply aff_lift.
  - intros d i y Hd Hi PA. destruct (across_power d i y Hd Hi PA) as [a [A E]]. unfold power in E.
    split; intros K; nra.
  - apply closed_vertex; auto.
Qed.

(** Strictly: a vertex behind a facet whose apex has a positive power. *)
Theorem cells_strict c c' v i : valid c -> valid c' -> In v (verts (piece c')) -> In i I4 -> coord (piece c) i v < 0 ->
  paired (c, i) -> 0 < power G (piece c) (behind c i) -> 0 < power G (piece c) v.
Proof.
  intros Hc Hc' Hv Hi Li PA ST. pose proof (positive _ Hc) as V.
  destruct (mates c i Hc Hi PA) as [S1 [S2 [S3 [S4 _]]]]. unfold behind in ST.
  set (ci := across (c, i)) in *. pose proof (positive _ S1) as V1.
  pose proof (power_difference G (piece c) i _ (snd ci) v Hi S2 V V1 S4) as PD.
  pose proof (cells_weakly_delaunay (fst ci) c' v S1 Hc' Hv) as W.
  assert (0 < - coord (piece c) i v * power G (piece c) (vx (piece (fst ci)) (snd ci))) by (apply Rmult_lt_0_compat; lra).
  assert (0 <= vol (piece (fst ci)) * power G (piece (fst ci)) v) by (apply Rmult_le_pos; lra). nra.
Qed.

(** So a vertex that is not a vertex of c has positive power. *)
Theorem cells_delaunay c c' v : valid c -> valid c' -> In v (verts (piece c')) ->
  (forall i, In i I4 -> coord (piece c) i v < 0 -> paired (c, i) /\ 0 < power G (piece c) (behind c i)) ->
  power G (piece c) v = 0 -> In v (verts (piece c)).
Proof.
  intros Hc Hc' Hv ST PZ. pose proof (positive _ Hc) as V. pose proof (positive _ Hc') as V'.
  destruct (closed_vertex _ v V' Hv) as [C' CAR'].
  destruct (closedb (piece c) v) eqn:CB.
  - apply closedb_t in CB. apply carT_vert with (x := v).
    apply (Cells.face_to_face cell eq_dec piece valid Dom paired across positive range mates boundary Dom_convex Dom_inside
           once v v c' c); auto.
  - exfalso. assert (NC : ~ closed (piece c) v) by (rewrite <- closedb_t; congruence).
    apply not_closed_iff in NC as [i [Hi Li]]. destruct (ST i Hi Li) as [PA S].
    pose proof (cells_strict c c' v i Hc Hc' Hv Hi Li PA S). lra.
Qed.
End AnyCells.

Section Delaunay.
Variables (N : nat) (T : nat -> tetrahedron) (h : R) (lat : Z3 -> bool) (Dom : point -> Prop).
Variable mate : nat -> nat -> option (nat * nat * Z3).
Hypothesis h_pos : 0 < h.
Hypothesis lat_add : forall a b, lat a = true -> lat b = true -> lat (zadd3 a b) = true.
Hypothesis Dom_convex : forall p q s, Dom p -> Dom q -> 0 <= s <= 1 -> Dom (lerp p q s).
Notation piece := (piece T h).
Notation valid := (valid N lat).
Hypothesis Dom_inside : forall c x, valid c -> inside (piece c) x -> Dom x.
Hypothesis Hvol : forall k, (k < N)%nat -> 0 < vol (T k).
Hypothesis Hmate : forall k i, (k < N)%nat -> In i I4 ->
  match mate k i with
  | Some (k', i', d) =>
    (k' < N)%nat /\ In i' I4 /\ lat d = true /\ mate k' i' = Some (k, i, zopp3 d) /\
    opposite (facet (T k) i) (facet (translate (vec h d) (T k')) i')
  | None => forall n y, lat n = true -> Dom y -> 0 < coord (piece (k, n)) i y
  end.
Hypothesis once : covered_once N T h lat Dom.

Variable G : gram.
Notation across := (across mate).
Notation paired := (paired mate).

(** The local condition, for one tetrahedron of each orbit. *)
Hypothesis local : forall k i, (k < N)%nat -> In i I4 ->
  match mate k i with Some (k', i', d) => 0 <= power G (T k) (vx (translate (vec h d) (T k')) i') | None => True end.

Lemma vol_piece c : valid c -> 0 < vol (piece c).
Proof. intros [Hc _]. apply cellt_vol with (N := N); auto. Qed.

Lemma vx_translate u t i : vx (translate u t) i = add (vx t i) u.
Proof. destruct i as [|[|[|i]]]; reflexivity. Qed.
Lemma apex_power c i : valid c -> In i I4 -> paired (c, i) ->
  match mate (fst c) i with Some (k', i', d) => power G (piece c) (vx (piece (fst (across (c, i)))) (snd (across (c, i)))) = power G (T (fst c)) (vx (translate (vec h d) (T k')) i') | None => False end.
Proof.
  destruct c as [k n]. intros [Hc _] Hi PA. cbn [fst] in *. unfold Degree.paired in PA. cbn [fst snd] in PA. unfold Degree.across.
  destruct (mate k i) as [[[k' i'] d]|]; [|congruence]. cbn [fst snd]. unfold Degree.piece; cbn [fst snd].
  rewrite !vx_translate, vec_add, (padd_comm (vec h n)), padd_assoc. apply power_translate. pose proof (Hvol k Hc). lra.
Qed.

Notation cells_behind := (behind cell piece across).
Lemma behind_power c i : valid c -> In i I4 -> paired (c, i) -> 0 <= power G (piece c) (cells_behind c i).
Proof.
  intros Hc Hi PA. pose proof (apex_power c i Hc Hi PA) as AP. pose proof (local (fst c) i (proj1 Hc) Hi) as LC.
  unfold behind. destruct (mate (fst c) i) as [[[k' i'] d]|]; [|tauto]. rewrite AP. exact LC.
Qed.
Notation mates := (sg_spec N T h lat Dom mate lat_add Hmate).
Notation positive := (cells_positive N T h lat Hvol).
Notation in_range := (cells_range N T h lat h_pos Hvol).
Notation boundary := (cells_boundary N T h lat Dom mate Hmate).
Notation once_there := (cells_once N T h lat Dom once).

Theorem weakly_delaunay_global c c' v : valid c -> valid c' -> In v (verts (piece c')) -> 0 <= power G (piece c) v.
Proof.
  exact (cells_weakly_delaunay cell cell_eq_dec piece valid Dom paired across positive in_range mates boundary Dom_convex Dom_inside
    once_there G behind_power c c' v).
Qed.

(** Strictly: a vertex behind a facet whose apex has a positive power. *)
Hypothesis boundary_vertices : forall k i n c v, (k < N)%nat -> lat n = true -> In i I4 -> mate k i = None ->
  valid c -> In v (verts (piece c)) -> 0 <= coord (piece (k, n)) i v.
Theorem strict_at c c' v i : valid c -> valid c' -> In v (verts (piece c')) -> In i I4 -> coord (piece c) i v < 0 ->
  match mate (fst c) i with Some (k', i', d) => 0 < power G (T (fst c)) (vx (translate (vec h d) (T k')) i') | None => True end ->
  0 < power G (piece c) v.
Proof.
  intros Hc Hc' Hv Hi Li ST.
  assert (PA : paired (c, i)).
  { unfold Degree.paired; cbn [fst snd]. intros E. destruct c as [k n]. cbn [fst] in E.
    pose proof (boundary_vertices k i n c' v (proj1 Hc) (proj2 Hc) Hi E Hc' Hv). lra. }
  apply (cells_strict cell cell_eq_dec piece valid Dom paired across positive in_range mates boundary Dom_convex Dom_inside
    once_there G behind_power c c' v i); auto.
  pose proof (apex_power c i Hc Hi PA) as AP. unfold behind.
  destruct (mate (fst c) i) as [[[k' i'] d]|]; [|tauto]. rewrite AP. exact ST.
Qed.

(** So a vertex that is not a vertex of c has positive power. *)
Hypothesis strict : forall k i, (k < N)%nat -> In i I4 ->
  match mate k i with Some (k', i', d) => 0 < power G (T k) (vx (translate (vec h d) (T k')) i') | None => True end.

Theorem delaunay_global c c' v : valid c -> valid c' -> In v (verts (piece c')) ->
  power G (piece c) v = 0 -> In v (verts (piece c)).
Proof.
  intros Hc Hc' Hv. apply (cells_delaunay cell cell_eq_dec piece valid Dom paired across positive in_range mates boundary Dom_convex
    Dom_inside once_there G behind_power c c' v Hc Hc' Hv).
  intros i Hi Li.
  assert (PA : paired (c, i)).
  { unfold Degree.paired; cbn [fst snd]. intros E. destruct c as [k n]. cbn [fst] in E.
    pose proof (boundary_vertices k i n c' v (proj1 Hc) (proj2 Hc) Hi E Hc' Hv). lra. }
  split; [exact PA|]. pose proof (apex_power c i Hc Hi PA) as AP. pose proof (strict (fst c) i (proj1 Hc) Hi) as ST. unfold behind.
  destruct (mate (fst c) i) as [[[k' i'] d]|]; [|tauto]. rewrite AP. exact ST.
Qed.
End Delaunay.
