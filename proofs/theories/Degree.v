(** * The degree argument of Cells.v for translates of finitely many tetrahedra

    In lattice coordinates: the lattice is h Z^3 or a sublattice of it. *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology.
From Acutile Require Cells.
Import ListNotations.
Open Scope R_scope.

Notation Z3 := (Z * Z * Z)%type.
Definition zadd3 (a b : Z3) : Z3 := let '(x,y,z) := a in let '(x',y',z') := b in (x+x', y+y', z+z')%Z.
Definition zopp3 (a : Z3) : Z3 := let '(x,y,z) := a in (-x,-y,-z)%Z.
Definition z30 : Z3 := (0,0,0)%Z.
Definition vec (h : R) (n : Z3) : point := let '(x,y,z) := n in Point (h * IZR x) (h * IZR y) (h * IZR z).

Lemma vec_add h a b : vec h (zadd3 a b) = add (vec h a) (vec h b).
Proof. destruct a as [[? ?] ?], b as [[? ?] ?]. apply point_eq; simpl; rewrite plus_IZR; ring. Qed.
Lemma padd_assoc a b c : add a (add b c) = add (add a b) c.
Proof. apply point_eq; unf; ring. Qed.

Definition translate_triangle (u : point) f := Triangle (add (t1 f) u) (add (t2 f) u) (add (t3 f) u).
Lemma facet_translate u t i : facet (translate u t) i = translate_triangle u (facet t i).
Proof. destruct i as [|[|[|i]]]; reflexivity. Qed.
Lemma oddm_tritr u f g : opposite f g -> opposite (translate_triangle u f) (translate_triangle u g).
Proof. unfold opposite, translate_triangle; cbn [t1 t2 t3]. intuition congruence. Qed.
Lemma ttr_ttr u v t : translate u (translate v t) = translate (add v u) t.
Proof. unfold translate; cbn. rewrite <- !padd_assoc. reflexivity. Qed.
Lemma padd_comm a b : add a b = add b a.
Proof. apply point_eq; unf; ring. Qed.

Definition cell := (nat * Z3)%type.
Definition cell_eq_dec (a b : cell) : {a = b} + {a <> b}.
Proof. repeat decide equality. Defined.

Definition org := Point 0 0 0.


(** ** The setting

    A sublattice of h Z^3 ([lat]), an open convex domain [Dom], tetrahedra T 0,
    ..., T (N-1), and for each facet its mate or the fact that it lies on the
    boundary of the domain. *)
Section Tiling.
Variables (N : nat) (T : nat -> tetrahedron) (h : R) (lat : Z3 -> bool) (Dom : point -> Prop).
Variable mate : nat -> nat -> option (nat * nat * Z3).
Definition piece (c : cell) := translate (vec h (snd c)) (T (fst c)).
Definition valid (c : cell) := (fst c < N)%nat /\ lat (snd c) = true.

Hypothesis h_pos : 0 < h.
Hypothesis lat_add : forall a b, lat a = true -> lat b = true -> lat (zadd3 a b) = true.
Hypothesis Dom_open : open Dom.
Hypothesis Dom_convex : forall p q s, Dom p -> Dom q -> 0 <= s <= 1 -> Dom (lerp p q s).
Hypothesis Dom_inside : forall c x, valid c -> inside (piece c) x -> Dom x.
Hypothesis Hvol : forall k, (k < N)%nat -> 0 < vol (T k).
Hypothesis Hmate : forall k i, (k < N)%nat -> In i I4 ->
  match mate k i with
  | Some (k', i', d) =>
    (k' < N)%nat /\ In i' I4 /\ lat d = true /\ mate k' i' = Some (k, i, zopp3 d) /\
    opposite (facet (T k) i) (facet (translate (vec h d) (T k')) i')
  | None => forall n y, lat n = true -> Dom y -> 0 < coord (piece (k, n)) i y
  end.

Lemma cellt_vol c : (fst c < N)%nat -> 0 < vol (piece c).
Proof. intros. unfold piece. rewrite vol_ttr. apply Hvol; auto. Qed.

(** The facet on the other side; a boundary facet has none and is left alone. *)
Definition across (ci : cell * nat) : cell * nat :=
  let '((k, n), i) := ci in match mate k i with Some (k', i', d) => ((k', zadd3 n d), i') | None => ci end.
Definition paired (ci : cell * nat) := mate (fst (fst ci)) (snd ci) <> None.

Lemma sg_spec (c : cell) i : valid c -> In i I4 -> paired (c, i) ->
  valid (fst (across (c, i))) /\ In (snd (across (c, i))) I4 /\ across (across (c, i)) = (c, i) /\
  opposite (facet (piece c) i) (facet (piece (fst (across (c, i)))) (snd (across (c, i)))) /\ paired (across (c, i)).
Proof.
  destruct c as [k n]; unfold valid, paired; cbn [fst snd]. intros [Hk Hn] Hi P. unfold across. pose proof (Hmate k i Hk Hi) as H.
  destruct (mate k i) as [[[k' i'] d]|]; [|congruence]. cbn [fst snd]. destruct H as [H1 [H2 [H3' [H3 H4]]]].
  rewrite H3. repeat split; auto; [| |congruence].
  - destruct n as [[? ?] ?], d as [[? ?] ?]; cbn. repeat f_equal; lia.
  - unfold piece; cbn [fst snd]. rewrite vec_add, (padd_comm (vec h n)), <- ttr_ttr.
    rewrite (facet_translate (vec h n)), (facet_translate (vec h n)). apply oddm_tritr; auto.
Qed.

(* finite ranges of cells *)
Definition cells (K : nat) : list cell :=
  filter (fun c => lat (snd c)) (list_prod (seq 0 N) (list_prod (list_prod (zr K) (zr K)) (zr K))).
Lemma cells_In K k x y z : In (k, (x, y, z)) (cells K) <->
  valid (k, (x, y, z)) /\ (Z.abs x <= Z.of_nat K)%Z /\ (Z.abs y <= Z.of_nat K)%Z /\ (Z.abs z <= Z.of_nat K)%Z.
Proof. unfold cells, valid. rewrite filter_In, !in_prod_iff, !zr_In, in_seq. cbn [fst snd]. intuition lia. Qed.
Lemma cells_NoDup K : NoDup (cells K).
Proof. unfold cells. apply NoDup_filter. repeat apply NoDup_list_prod; auto using zr_NoDup, seq_NoDup. Qed.
Lemma cells_valid K c : In c (cells K) -> valid c.
Proof. destruct c as [k [[x y] z]]. rewrite cells_In. tauto. Qed.
Lemma cells_N K c : In c (cells K) -> (fst c < N)%nat.
Proof. intros H. apply cells_valid in H. apply H. Qed.

Definition bnd M (x : point) := Rabs (px x) <= M /\ Rabs (py x) <= M /\ Rabs (pz x) <= M.
Lemma bnd_exists : exists M0, 0 < M0 /\ forall k, (k < N)%nat -> bnd M0 (va (T k)) /\ bnd M0 (vb (T k)) /\ bnd M0 (vc (T k)) /\ bnd M0 (vd (T k)).
Proof.
  assert (P : forall x, exists M, 0 < M /\ bnd M x).
  { intros x. exists (Rabs (px x) + Rabs (py x) + Rabs (pz x) + 1). unfold bnd.
    pose proof (Rabs_pos (px x)); pose proof (Rabs_pos (py x)); pose proof (Rabs_pos (pz x)). repeat split; lra. }
  assert (Mn : forall M M' x, M <= M' -> bnd M x -> bnd M' x) by (unfold bnd; intuition lra).
  clear - P Mn. induction N as [|n [M [HM IH]]].
  - exists 1. split; [lra|]. intros; lia.
  - destruct (P (va (T n))) as [A [HA PA]], (P (vb (T n))) as [B [HB PB]], (P (vc (T n))) as [C [HC PC]], (P (vd (T n))) as [E [HE PE]].
    exists (M + A + B + C + E). split; [lra|]. intros k Hk.
    destruct (Nat.eq_dec k n) as [->|Ne].
    + split; [apply (Mn A); [lra|auto]|]. split; [apply (Mn B); [lra|auto]|]. split; [apply (Mn C); [lra|auto]|apply (Mn E); [lra|auto]].
    + destruct (IH k) as [I1 [I2 [I3 I4']]]; [lia|].
      split; [|split; [|split]]; apply (Mn M); auto; lra.
Qed.

Lemma range M : exists K, forall c y, valid c -> near M org y -> closed (piece c) y -> In c (cells K).
Proof.
  destruct bnd_exists as [M0 [HM0 B]].
  exists (Z.to_nat (up ((M + M0) / h))). intros [k [[n1 n2] n3]] y Hv [Y1 [Y2 Y3]] C.
  pose proof (proj1 Hv) as Hk. cbn [fst] in Hk. cbn [px py pz org] in *.
  destruct (B k Hk) as [[A1 [A2 A3]] [[B1 [B2 B3]] [[C1 [C2 C3]] [D1 [D2 D3]]]]].
  pose proof (cellt_vol (k, (n1, n2, n3)) Hk) as V.
  destruct (bary _ y V) as [E S].
  assert (P : forall j, In j I4 -> 0 <= coord (piece (k, (n1,n2,n3))) j y / vol (piece (k, (n1,n2,n3)))).
  { intros j Hj. specialize (C j Hj). apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat; auto. }
  pose proof (P 0%nat ltac:(simpl; tauto)) as Pa. pose proof (P 1%nat ltac:(simpl; tauto)) as Pb.
  pose proof (P 2%nat ltac:(simpl; tauto)) as Pc. pose proof (P 3%nat ltac:(simpl; tauto)) as Pd. clear P C.
  set (t := piece (k, (n1,n2,n3))) in *.
  set (a := coord t 0 y / vol t) in *. set (b := coord t 1 y / vol t) in *. set (c := coord t 2 y / vol t) in *. set (d := coord t 3 y / vol t) in *.
  clearbody a b c d.
  assert (Q : forall u n va' vb' vc' vd', Rabs (u - 0) < M -> Rabs va' <= M0 -> Rabs vb' <= M0 -> Rabs vc' <= M0 -> Rabs vd' <= M0 ->
     u = a * (va' + h * IZR n) + b * (vb' + h * IZR n) + (c * (vc' + h * IZR n) + d * (vd' + h * IZR n)) ->
     (Z.abs n <= Z.of_nat (Z.to_nat (up ((M + M0) / h))))%Z).
  { clear - Pa Pb Pc Pd S h_pos HM0. intros u n va' vb' vc' vd' Hu Ha Hb Hc Hd E.
    assert (E' : u - h * IZR n = a * va' + b * vb' + c * vc' + d * vd').
    { rewrite E. replace d with (1 - a - b - c) by lra. ring. }
    apply Rabs_def2 in Hu.
    assert (In1 : forall x, Rabs x <= M0 -> - M0 <= x <= M0).
    { intros x Hx. pose proof (Rle_abs x). pose proof (Rle_abs (- x)). rewrite Rabs_Ropp in *. lra. }
    apply In1 in Ha; apply In1 in Hb; apply In1 in Hc; apply In1 in Hd.
    assert (Ql : - M0 <= u - h * IZR n) by (rewrite E'; nra).
    assert (Qr : u - h * IZR n <= M0) by (rewrite E'; nra).
    set (X := (M + M0) / h). assert (EX : X * h = M + M0) by (unfold X; field; lra).
    destruct (archimed X) as [AX _].
    assert (IZR n < IZR (up X)). { apply Rmult_lt_reg_r with h; auto. nra. }
    assert (- IZR n < IZR (up X)). { apply Rmult_lt_reg_r with h; auto. nra. }
    rewrite <- opp_IZR in *. apply lt_IZR in H, H0. lia. }
  apply cells_In. split; auto. unfold t, piece, combination, translate, vec in E; cbn [fst snd va vb vc vd] in E.
  pose proof (f_equal px E) as Ex. pose proof (f_equal py E) as Ey. pose proof (f_equal pz E) as Ez. unf.
  split; [|split].
  - apply (Q (px y) n1 (px (va (T k))) (px (vb (T k))) (px (vc (T k))) (px (vd (T k)))); auto.
  - apply (Q (py y) n2 (py (va (T k))) (py (vb (T k))) (py (vc (T k))) (py (vd (T k)))); auto.
  - apply (Q (pz y) n3 (pz (va (T k))) (pz (vb (T k))) (pz (vc (T k))) (pz (vd (T k)))); auto.
Qed.

(** ** These cells fulfil the hypotheses of Cells.v *)
Lemma cells_finite K : Cells.finite_part cell valid (cells K).
Proof. split; [apply cells_NoDup|apply cells_valid]. Qed.
Lemma cells_positive c : valid c -> 0 < vol (piece c).
Proof. intros [H _]. apply cellt_vol, H. Qed.
Lemma cells_range M : exists L, Cells.finite_part cell valid L /\ Cells.reaches cell piece valid L M.
Proof. destruct (range M) as [K RG]. exists (cells K). split; [apply cells_finite|exact RG]. Qed.
Lemma cells_boundary c i : valid c -> In i I4 -> paired (c, i) \/ forall y, Dom y -> 0 < coord (piece c) i y.
Proof.
  destruct c as [k n]. intros [Hk Hn] Hi. unfold paired; cbn [fst snd] in *. pose proof (Hmate k i Hk Hi) as H.
  destruct (mate k i) as [[[k' i'] d]|]; [left; congruence|right; intros y; apply (H n y Hn)].
Qed.

Definition count (w : cell -> Z) K x := zsum (fun c => (w c * Z.b2z (insideb (piece c) x))%Z) (cells K).
Lemma weighted K p q w :
  (forall c, In c (cells K) -> generic_for (piece c) p q) ->
  (forall c i, In c (cells K) -> In i I4 -> crossing (facet (piece c) i) p q <> 0%Z ->
     paired (c, i) /\ In (fst (across (c, i))) (cells K) /\ w (fst (across (c, i))) = w c) ->
  count w K p = count w K q.
Proof. exact (Cells.weighted cell piece valid paired across cells_positive sg_spec (cells K) p q w (cells_finite K)). Qed.

Lemma gen_pair K U V : open U -> open V -> (exists x, U x) -> (exists x, V x) ->
  exists p q, U p /\ V q /\ forall c, In c (cells K) -> generic_for (piece c) p q.
Proof. exact (Cells.gen_pair cell piece valid cells_positive (cells K) U V (cells_finite K)). Qed.

Definition one (c : cell) : Z := 1%Z.
Lemma cnt_one K x : count one K x = zsum (fun c => Z.b2z (insideb (piece c) x)) (cells K).
Proof. exact (Cells.cnt_one cell piece (cells K) x). Qed.
Lemma near_org_exists x : exists M, 0 < M /\ near M org x.
Proof. exact (Cells.near_origin_exists x). Qed.

Lemma ttr0 t : translate (vec h z30) t = t.
Proof.
  destruct t as [[a1 a2 a3] [b1 b2 b3] [c1 c2 c3] [d1 d2 d3]]. unfold translate, vec, z30, add; cbn [va vb vc vd px py pz].
  rewrite !Rmult_0_r, !Rplus_0_r. reflexivity.
Qed.

(** ** The covering condition: generic points are covered once

    Every nonempty bounded open part of the domain holds a point that lies inside of
    exactly one tile.  The volume sum implies it (Volume.v). *)
Definition covered_once := forall M x (V : point -> Prop), near M org x -> V x -> open V -> (forall y, V y -> Dom y) ->
  exists K q, V q /\ count one K q = 1%Z /\
   (forall c y, valid c -> near M org y -> closed (piece c) y -> In c (cells K)) /\ near M org q.
Lemma cells_once : covered_once -> Cells.covered_once cell piece valid Dom.
Proof.
  intros O M x V Nx Vx OV VD. destruct (O M x V Nx Vx OV VD) as [K [q [Vq [C [RG Nq]]]]].
  exists (cells K), q. split; [exact Vq|]. split; [exact C|]. split; [apply cells_finite|]. split; [exact RG|exact Nq].
Qed.

(** The number of tiles is the same at all points of the domain that are in no facet plane. *)
Definition off_planes K p := forall ci, In ci (list_prod (cells K) I4) -> coord (piece (fst ci)) (snd ci) p <> 0.
Definition like K M p y := (near M org y /\ Dom y) /\
  forall ci, In ci (list_prod (cells K) I4) -> 0 < coord (piece (fst ci)) (snd ci) p * coord (piece (fst ci)) (snd ci) y.
Lemma like_open K M p : open (like K M p).
Proof. exact (Cells.like_open cell piece Dom Dom_open (cells K) M p). Qed.
Lemma like_count K M p y : like K M p y -> count one K y = count one K p.
Proof. exact (Cells.like_count cell piece Dom (cells K) M p y). Qed.
Lemma count_constant K M p q :
  (forall c y, valid c -> near M org y -> closed (piece c) y -> In c (cells K)) ->
  near M org p -> Dom p -> off_planes K p -> near M org q -> Dom q -> off_planes K q -> count one K p = count one K q.
Proof.
  exact (Cells.count_constant cell piece valid Dom paired across cells_positive sg_spec cells_boundary Dom_open Dom_convex
    (cells K) M p q (cells_finite K)).
Qed.

(** ** What follows *)
Section Once.
Hypothesis once : covered_once.

Theorem cover : forall x, (forall e, 0 < e -> exists y, near e x y /\ Dom y) -> exists c, valid c /\ closed (piece c) x.
Proof. exact (Cells.cover cell piece valid Dom cells_range Dom_open (cells_once once)). Qed.

Theorem disjoint : forall x c c', valid c -> valid c' -> inside (piece c) x -> inside (piece c') x -> c = c'.
Proof. exact (Cells.disjoint cell cell_eq_dec piece valid Dom Dom_inside (cells_once once)). Qed.

Theorem disjoint_closed : forall x c c', valid c -> valid c' -> inside (piece c) x -> closed (piece c') x -> c = c'.
Proof. exact (Cells.disjoint_closed cell cell_eq_dec piece valid Dom cells_positive Dom_inside (cells_once once)). Qed.

Lemma cnt_interior w K q c : In c (cells K) -> inside (piece c) q -> count w K q = w c.
Proof. exact (Cells.cnt_interior cell cell_eq_dec piece valid Dom Dom_inside (cells_once once) w (cells K) q c (cells_finite K)). Qed.

(** What passes through every facet around x is the same for all tiles that contain x. *)
Theorem constant_around (x : point) (w : cell -> Z) :
  (forall d i, valid d -> In i I4 -> paired (d, i) -> closed (piece d) x -> coord (piece d) i x = 0 -> w (fst (across (d, i))) = w d) ->
  forall c c', valid c -> valid c' -> closed (piece c) x -> closed (piece c') x -> w c = w c'.
Proof.
  exact (Cells.constant_around cell cell_eq_dec piece valid Dom paired across cells_positive cells_range sg_spec cells_boundary
    Dom_convex Dom_inside (cells_once once) x w).
Qed.

Theorem face_to_face : forall x v c c', valid c -> valid c' ->
  closed (piece c) x -> closed (piece c') x -> carT (piece c) x v -> carT (piece c') x v.
Proof.
  exact (Cells.face_to_face cell cell_eq_dec piece valid Dom paired across cells_positive cells_range sg_spec cells_boundary
    Dom_convex Dom_inside (cells_once once)).
Qed.

(** Delaunay's lemma, see Cells.v. *)
Section Convexity.
Variable f : cell -> point -> R.
Hypothesis f_affine : forall c c', affine (fun y => f c y - f c' y).
Hypothesis f_local : forall c i y, valid c -> In i I4 -> paired (c, i) ->
  (coord (piece c) i y <= 0 -> f (fst (across (c, i))) y <= f c y) /\
  (0 <= coord (piece c) i y -> f c y <= f (fst (across (c, i))) y).

Theorem local_to_global : forall c c' x, valid c -> valid c' -> closed (piece c') x -> f c' x <= f c x.
Proof.
  exact (Cells.local_to_global cell cell_eq_dec piece valid Dom paired across cells_positive cells_range sg_spec cells_boundary
    Dom_convex Dom_inside (cells_once once) f f_affine f_local).
Qed.
End Convexity.
End Once.
End Tiling.
