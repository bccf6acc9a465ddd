(* The periodic tiling theorem, in lattice coordinates (lattice = h Z^3). *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology.
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

(** A facet that a segment inside of the domain crosses is not on the boundary. *)
Lemma crossed_paired c i p q : valid c -> In i I4 -> Dom p -> Dom q ->
  crossing (facet (piece c) i) p q <> 0%Z -> paired (c, i).
Proof.
  destruct c as [k n]. intros [Hk Hn] Hi Dp Dq CR E. unfold paired in *; cbn [fst snd] in *.
  pose proof (Hmate k i Hk Hi) as H. rewrite E in H.
  pose proof (H n p Hn Dp) as Hp. pose proof (H n q Hn Dq) as Hq. unfold coord in Hp, Hq. unfold crossing in CR.
  destruct (crp (facet (piece (k, n)) i) p q) eqn:E1; [apply crp_t in E1; lra|].
  destruct (crm (facet (piece (k, n)) i) p q) eqn:E2; [apply crm_t in E2; lra|]. simpl in CR. lia.
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

(* The weighted degree argument. *)
Definition count (w : cell -> Z) K x := zsum (fun c => (w c * Z.b2z (insideb (piece c) x))%Z) (cells K).

Lemma weighted K p q w :
  (forall c, In c (cells K) -> generic_for (piece c) p q) ->
  (forall c i, In c (cells K) -> In i I4 -> crossing (facet (piece c) i) p q <> 0%Z ->
     paired (c, i) /\ In (fst (across (c, i))) (cells K) /\ w (fst (across (c, i))) = w c) ->
  count w K p = count w K q.
Proof.
  intros G H. unfold count.
  cut (zsum (fun c => w c * Z.b2z (insideb (piece c) q) - w c * Z.b2z (insideb (piece c) p))%Z (cells K) = 0%Z).
  { rewrite zsum_sub. lia. }
  rewrite (zsum_ext _ (fun c => zsum (fun i => (w c * crossing (facet (piece c) i) p q)%Z) I4)).
  2:{ intros c Hc. rewrite zsum_mull, <- tet_crossing; [ring| |]; auto. apply cellt_vol. eapply cells_N; eauto. }
  rewrite <- (zsum_prod (fun ci => (w (fst ci) * crossing (facet (piece (fst ci)) (snd ci)) p q)%Z)).
  apply zsum_invol with (s := across).
  - apply NoDup_list_prod; [apply cells_NoDup|]. unfold I4. repeat constructor; simpl; intuition congruence.
  - intros [c i] Hin NZ. apply in_prod_iff in Hin as [Hc Hi]. cbn [fst snd] in NZ.
    assert (CR : crossing (facet (piece c) i) p q <> 0%Z) by (intros E; rewrite E in NZ; lia).
    destruct (H _ _ Hc Hi CR) as [H0 [H1 H2]].
    pose proof (cells_valid _ _ Hc) as Hk.
    destruct (sg_spec c i Hk Hi H0) as [S1 [S2 [S3 [S4 _]]]].
    set (ci' := across (c, i)) in *. repeat split; auto.
    + match goal with |- In ?z _ => rewrite (surjective_pairing z) end. apply in_prod; auto.
    + rewrite H2. cbn [fst snd]. rewrite (oddm_cr _ _ p q S4). lia.
Qed.

(** The same with real weights and an inequality: if w does not increase from a
    cell to the next one along the segment, its total does not increase. *)
Definition total (w : cell -> R) K x := rsum (fun c => w c * IZR (Z.b2z (insideb (piece c) x))) (cells K).

Lemma weighted_le K p q w :
  (forall c, In c (cells K) -> generic_for (piece c) p q) ->
  (forall c i, In c (cells K) -> In i I4 -> crossing (facet (piece c) i) p q <> 0%Z ->
     paired (c, i) /\ In (fst (across (c, i))) (cells K) /\
     IZR (crossing (facet (piece c) i) p q) * (w c - w (fst (across (c, i)))) <= 0) ->
  total w K q <= total w K p.
Proof.
  intros G H. unfold total.
  cut (rsum (fun c => w c * IZR (Z.b2z (insideb (piece c) q)) - w c * IZR (Z.b2z (insideb (piece c) p))) (cells K) <= 0).
  { rewrite rsum_sub. lra. }
  rewrite (rsum_ext _ (fun c => rsum (fun i => w c * IZR (crossing (facet (piece c) i) p q)) I4)).
  2:{ intros c Hc. rewrite rsum_mull, <- rsum_IZR, <- tet_crossing, minus_IZR; [ring| |]; auto. apply cellt_vol. eapply cells_N; eauto. }
  rewrite <- (rsum_prod (fun ci => w (fst ci) * IZR (crossing (facet (piece (fst ci)) (snd ci)) p q))).
  apply rsum_invol with (s := across) (b := fun ci => negb (Z.eqb (crossing (facet (piece (fst ci)) (snd ci)) p q) 0)).
  - apply NoDup_list_prod; [apply cells_NoDup|]. unfold I4. repeat constructor; simpl; intuition congruence.
  - intros [c i] _ Hb. cbn [fst snd] in *. apply negb_false_iff, Z.eqb_eq in Hb. rewrite Hb. lra.
  - intros [c i] Hin Hb. apply in_prod_iff in Hin as [Hc Hi]. cbn [fst snd] in *.
    apply negb_true_iff, Z.eqb_neq in Hb.
    destruct (H _ _ Hc Hi Hb) as [H0 [H1 H2]].
    pose proof (cells_valid _ _ Hc) as Hk.
    destruct (sg_spec c i Hk Hi H0) as [S1 [S2 [S3 [S4 _]]]].
    set (ci' := across (c, i)) in *. pose proof (oddm_cr _ _ p q S4) as E. repeat split; auto.
    + match goal with |- In ?z _ => rewrite (surjective_pairing z) end. apply in_prod; auto.
    + apply negb_true_iff, Z.eqb_neq. lia.
    + replace (crossing (facet (piece (fst ci')) (snd ci')) p q) with (- crossing (facet (piece c) i) p q)%Z by lia.
      rewrite opp_IZR. lra.
Qed.

(* generic points exist in every pair of open sets *)
Lemma D_rot_o p f : orient p (t3 f) (t1 f) (t2 f) = - side f p /\ orient p (t1 f) (t2 f) (t3 f) = - side f p /\ orient p (t2 f) (t3 f) (t1 f) = - side f p.
Proof. unfold side. unf. repeat split; ring. Qed.

Definition tris K : list triangle := flat_map (fun c => map (facet (piece c)) I4) (cells K).
Lemma tris_In K f : In f (tris K) <-> exists c i, In c (cells K) /\ In i I4 /\ f = facet (piece c) i.
Proof.
  unfold tris. rewrite in_flat_map. split.
  - intros [c [Hc Hf]]. apply in_map_iff in Hf as [i [<- Hi]]. eauto.
  - intros [c [i [Hc [Hi ->]]]]. exists c. split; auto. apply in_map; auto.
Qed.
Lemma tri_nz K f : In f (tris K) -> exists z, side f z <> 0.
Proof.
  intros H. apply tris_In in H as [c [i [Hc [Hi ->]]]]. exists (centroid (piece c)).
  pose proof (cen_inter (piece c) (cellt_vol c (cells_N _ _ Hc)) i Hi). unfold coord in *. lra.
Qed.

Lemma gen_pair K U V : open U -> open V -> (exists x, U x) -> (exists x, V x) ->
  exists p q, U p /\ V q /\ forall c, In c (cells K) -> generic_for (piece c) p q.
Proof.
  intros OU OV NU NV.
  destruct (generic (map side (tris K)) U) as [p [Up Gp]]; auto.
  { intros f Hf. apply in_map_iff in Hf as [g [<- Hg]]. split; [apply aff_o|]. eapply tri_nz; eauto. }
  destruct (generic (flat_map (fun f => [side f; (fun x => orient p x (t1 f) (t2 f)); (fun x => orient p x (t2 f) (t3 f)); (fun x => orient p x (t3 f) (t1 f))]) (tris K)) V)
    as [q [Vq Gq]]; auto.
  { intros g Hg. apply in_flat_map in Hg as [f [Hf Hg]].
    assert (P : side f p <> 0). { apply Gp, in_map; auto. }
    destruct (D_rot_o p f) as [D1 [D2 D3]].
    destruct Hg as [<-|[<-|[<-|[<-|[]]]]].
    - split; [apply aff_o|]. eapply tri_nz; eauto.
    - split; [apply aff_D2|]. exists (t3 f). rewrite D1. lra.
    - split; [apply aff_D2|]. exists (t1 f). rewrite D2. lra.
    - split; [apply aff_D2|]. exists (t2 f). rewrite D3. lra. }
  exists p, q. split; auto. split; auto. intros c Hc.
  assert (IT : forall i, In i I4 -> In (facet (piece c) i) (tris K)) by (intros i Hi; apply tris_In; eauto).
  split.
  - intros i Hi. apply (Gp (side (facet (piece c) i))), in_map; auto.
  - intros i Hi. apply Gq, in_flat_map. exists (facet (piece c) i). split; auto. simpl; auto.
  - intros i Hi.
    assert (Q : forall g, In g [side (facet (piece c) i); (fun x => orient p x (t1 (facet (piece c) i)) (t2 (facet (piece c) i))); (fun x => orient p x (t2 (facet (piece c) i)) (t3 (facet (piece c) i))); (fun x => orient p x (t3 (facet (piece c) i)) (t1 (facet (piece c) i)))] -> g q <> 0).
    { intros g Hg. apply Gq, in_flat_map. exists (facet (piece c) i). split; auto. }
    repeat split.
    + apply (Q (fun x => orient p x (t1 (facet (piece c) i)) (t2 (facet (piece c) i)))). simpl; auto.
    + apply (Q (fun x => orient p x (t2 (facet (piece c) i)) (t3 (facet (piece c) i)))). simpl; auto.
    + apply (Q (fun x => orient p x (t3 (facet (piece c) i)) (t1 (facet (piece c) i)))). simpl; auto.
Qed.

Lemma connect K M (W U V : point -> Prop) :
  (forall c y, valid c -> near M org y -> closed (piece c) y -> In c (cells K)) ->
  (forall y, W y -> near M org y /\ Dom y) ->
  (forall p q s, W p -> W q -> 0 <= s <= 1 -> W (lerp p q s)) ->
  open U -> open V -> (exists x, U x) -> (exists x, V x) ->
  (forall x, U x -> W x) -> (forall x, V x -> W x) ->
  exists p q, U p /\ V q /\ (forall c, In c (cells K) -> generic_for (piece c) p q) /\
  forall c i, In c (cells K) -> In i I4 -> crossing (facet (piece c) i) p q <> 0%Z ->
    paired (c, i) /\ In (fst (across (c, i))) (cells K) /\
    exists y, W y /\ closed (piece c) y /\ coord (piece c) i y = 0.
Proof.
  intros RG WM WC OU OV NU NV UW VW.
  destruct (gen_pair K U V OU OV NU NV) as [p [q [Up [Vq G]]]].
  exists p, q. split; auto. split; auto. split; auto.
  intros c i Hc Hi CR. pose proof (cells_valid _ _ Hc) as Hk. pose proof (cellt_vol _ (proj1 Hk)) as V0.
  assert (PA : paired (c, i)).
  { apply crossed_paired with (p := p) (q := q); auto; apply WM; auto. }
  destruct (sg_spec c i Hk Hi PA) as [S1 [S2 [S3 [S4 _]]]].
  destruct (cr_meets _ i p q Hi V0 CR) as [s [Hs [C1 C2]]].
  split; auto. split.
  - set (ci' := across (c, i)) in *.
    assert (CR' : crossing (facet (piece (fst ci')) (snd ci')) p q <> 0%Z).
    { rewrite (oddm_cr _ _ p q S4) in CR. lia. }
    destruct (cr_meets _ _ p q S2 (cellt_vol _ (proj1 S1)) CR') as [s' [Hs' [C1' C2']]].
    apply RG with (y := lerp p q s'); auto. apply WM, WC; auto. lra.
  - exists (lerp p q s). split; auto. apply WC; auto. lra.
Qed.

Definition one (c : cell) : Z := 1%Z.
Lemma cnt_one K x : count one K x = zsum (fun c => Z.b2z (insideb (piece c) x)) (cells K).
Proof. unfold count, one. apply zsum_ext. intros. lia. Qed.

Lemma near_org_exists x : exists M, 0 < M /\ near M org x.
Proof.
  exists (Rabs (px x) + Rabs (py x) + Rabs (pz x) + 1).
  pose proof (Rabs_pos (px x)); pose proof (Rabs_pos (py x)); pose proof (Rabs_pos (pz x)).
  unfold near; cbn [org px py pz]; rewrite !Rminus_0_r. repeat split; lra.
Qed.

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

Lemma near_Dom_convex e x p q s : near e x p /\ Dom p -> near e x q /\ Dom q -> 0 <= s <= 1 -> near e x (lerp p q s) /\ Dom (lerp p q s).
Proof. intros [? ?] [? ?] ?. split; [apply near_convex|apply Dom_convex]; auto. Qed.

(** The number of tiles is the same at all points of the domain that are in no facet plane. *)
Definition off_planes K p := forall ci, In ci (list_prod (cells K) I4) -> coord (piece (fst ci)) (snd ci) p <> 0.
Definition like K M p y := (near M org y /\ Dom y) /\
  forall ci, In ci (list_prod (cells K) I4) -> 0 < coord (piece (fst ci)) (snd ci) p * coord (piece (fst ci)) (snd ci) y.
Lemma like_open K M p : open (like K M p).
Proof.
  apply opn_and; [apply opn_and; auto; apply near_opn|]. apply opn_all. intros ci _.
  destruct (aff_o (facet (piece (fst ci)) (snd ci))) as [a [b [c [d H]]]]. set (k := coord (piece (fst ci)) (snd ci) p).
  apply (aff_pos_opn (fun y => k * coord (piece (fst ci)) (snd ci) y)).
  exists (k * a), (k * b), (k * c), (k * d). intros y. unfold coord. rewrite H. ring.
Qed.
Lemma like_count K M p y : like K M p y -> count one K y = count one K p.
Proof.
  intros [_ H]. rewrite !cnt_one. apply zsum_ext. intros c Hc. f_equal. apply beq_iff. rewrite !interb_t.
  split; intros I i Hi; specialize (H (c, i) (proj2 (in_prod_iff _ _ _ _) (conj Hc Hi))); specialize (I i Hi); cbn [fst snd] in H; nra.
Qed.
Lemma count_constant K M p q :
  (forall c y, valid c -> near M org y -> closed (piece c) y -> In c (cells K)) ->
  near M org p -> Dom p -> off_planes K p -> near M org q -> Dom q -> off_planes K q -> count one K p = count one K q.
Proof.
  intros RG Np Dp Op Nq Dq Oq.
  assert (SELF : forall x, near M org x -> Dom x -> off_planes K x -> like K M x x).
  { intros x Nx Dx Ox. split; auto. intros ci Hci. specialize (Ox ci Hci). nra. }
  destruct (connect K M (fun y => near M org y /\ Dom y) (like K M p) (like K M q)) as [p' [q' [Lp [Lq [G CR]]]]];
    eauto using like_open; try (intros; apply near_Dom_convex; auto).
  { intros y [Hy _]. exact Hy. }
  { intros y [Hy _]. exact Hy. }
  rewrite <- (like_count K M p p' Lp), <- (like_count K M q q' Lq).
  apply weighted; auto. intros c i Hc Hi X. destruct (CR c i Hc Hi X) as [X1 [X2 _]]. auto.
Qed.

(** ** What follows *)
Section Once.
Hypothesis once : covered_once.

Theorem cover : forall x, (forall e, 0 < e -> exists y, near e x y /\ Dom y) -> exists c, valid c /\ closed (piece c) x.
Proof.
  intros x LIM. destruct (near_org_exists x) as [M [HM Hx]]. destruct (range M) as [K RG].
  destruct (existsb (fun c => closedb (piece c) x) (cells K)) eqn:E.
  - apply existsb_exists in E as [c [Hc E]]. apply closedb_t in E. exists c. split; auto. eapply cells_valid; eauto.
  - exfalso.
    assert (NC : forall c, In c (cells K) -> ~ closed (piece c) x).
    { intros c Hc C. assert (existsb (fun c => closedb (piece c) x) (cells K) = true); [|congruence].
      apply existsb_exists. exists c. split; auto. apply closedb_t; auto. }
    assert (OV : open (fun y => near M org y /\ forall c, In c (cells K) -> ~ closed (piece c) y)).
    { apply opn_and; [apply near_opn|]. apply opn_all. intros c _. apply not_closed_opn. }
    destruct (OV x (conj Hx NC)) as [e [He KV]]. destruct (LIM e He) as [z [Nz Dz]]. destruct (KV z Nz) as [Mz Vz].
    destruct (once M z (fun y => (near M org y /\ forall c, In c (cells K) -> ~ closed (piece c) y) /\ Dom y)) as [K' [q [[[_ Vq] Dq] [C1 [RG' Hq]]]]]; auto.
    { apply opn_and; auto. }
    { tauto. }
    rewrite cnt_one in C1.
    destruct (zsum_b2z_pos (fun c => insideb (piece c) q) (cells K')) as [c [Hc Hi]]; [lia|].
    apply interb_t, inter_closed in Hi. apply (Vq c); auto. apply RG with (y := q); auto. eapply cells_valid; eauto.
Qed.

Theorem disjoint : forall x c c', valid c -> valid c' ->
  inside (piece c) x -> inside (piece c') x -> c = c'.
Proof.
  intros x c c' Hc Hc' I I'. destruct (cell_eq_dec c c') as [|Ne]; auto. exfalso.
  destruct (near_org_exists x) as [M [HM Hx]].
  destruct (once M x (fun y => inside (piece c) y /\ inside (piece c') y)) as [K [q [[Q1 Q2] [C1 [RG Hq]]]]]; auto.
  { apply opn_and; apply inter_opn. }
  { intros y [Iy _]. apply (Dom_inside _ _ Hc Iy). }
  rewrite cnt_one in C1.
  pose proof (zsum_b2z_ge2 (fun c => insideb (piece c) q) (cells K) c c') as G.
  assert (2 <= 1)%Z; [|lia]. rewrite <- C1 at 1. apply G; auto; try (apply interb_t; auto);
  apply RG with (y := q); auto using inter_closed.
Qed.

(* an interior point of one cell lies in no other closed cell *)
Theorem disjoint_closed : forall x c c', valid c -> valid c' ->
  inside (piece c) x -> closed (piece c') x -> c = c'.
Proof.
  intros x c c' Hc Hc' I I'. destruct (inter_opn _ _ I) as [e [He K]].
  destruct (closed_limit _ x e (cellt_vol c' (proj1 Hc')) I' He) as [y [Ny Iy]].
  apply disjoint with (x := y); auto.
Qed.

Lemma cnt_interior w K q c : In c (cells K) -> inside (piece c) q -> count w K q = w c.
Proof.
  intros Hc I. unfold count. rewrite (zsum_single _ _ c); [|apply cells_NoDup|auto|].
  - rewrite (proj2 (interb_t _ _) I). simpl. lia.
  - intros c' Hc' Ne. destruct (insideb (piece c') q) eqn:Eb; simpl; [|lia].
    exfalso. apply Ne. apply interb_t in Eb. apply disjoint with (x := q); auto; eapply cells_valid; eauto.
Qed.
Lemma total_interior w K q c : In c (cells K) -> inside (piece c) q -> total w K q = w c.
Proof.
  intros Hc I. unfold total. rewrite (rsum_single _ _ c); [|apply cells_NoDup|auto|].
  - rewrite (proj2 (interb_t _ _) I). simpl. lra.
  - intros c' Hc' Ne. destruct (insideb (piece c') q) eqn:Eb; simpl; [|lra].
    exfalso. apply Ne. apply interb_t in Eb. apply disjoint with (x := q); auto; eapply cells_valid; eauto.
Qed.

(** What passes through every facet around x is the same for all tiles that contain x. *)
Theorem constant_around (x : point) (w : cell -> Z) :
  (forall d i, valid d -> In i I4 -> paired (d, i) -> closed (piece d) x -> coord (piece d) i x = 0 -> w (fst (across (d, i))) = w d) ->
  forall c c', valid c -> valid c' -> closed (piece c) x -> closed (piece c') x -> w c = w c'.
Proof.
  intros HW c c' Hc Hc' C C'.
  destruct (near_org_exists x) as [M1 [HM1 Hx]].
  destruct (range M1) as [K RG].
  set (G := fun y => near M1 org y /\ forall ci, In ci (list_prod (cells K) I4) ->
     (closed (piece (fst ci)) x /\ coord (piece (fst ci)) (snd ci) x = 0) \/
     (~ closed (piece (fst ci)) y \/ coord (piece (fst ci)) (snd ci) y <> 0)).
  assert (OG : open G).
  { unfold G. apply opn_and; [apply near_opn|]. apply opn_all. intros [d i] _. cbn [fst snd].
    apply opn_or; [apply opn_const|]. apply opn_or; [apply not_closed_opn|]. apply aff_nz_opn, aff_o. }
  assert (Gx : G x).
  { unfold G. split; auto. intros [d i] _; cbn [fst snd].
    destruct (closedb (piece d) x) eqn:Cb.
    - apply closedb_t in Cb. destruct (Req_EM_T (coord (piece d) i x) 0); auto.
    - right; left. rewrite <- closedb_t. congruence. }
  destruct (OG x Gx) as [e [He KG]].
  assert (Ic : In c (cells K)) by (apply RG with (y := x); auto).
  assert (Ic' : In c' (cells K)) by (apply RG with (y := x); auto).
  destruct (connect K M1 (fun y => near e x y /\ Dom y) (fun y => near e x y /\ inside (piece c) y) (fun y => near e x y /\ inside (piece c') y))
    as [p [q [[Up1 Up2] [[Vq1 Vq2] [GE CR]]]]]; auto.
  - intros y [Hy Dy]. split; auto. apply KG in Hy. apply Hy.
  - intros; apply near_Dom_convex; auto.
  - apply opn_and; [apply near_opn | apply inter_opn].
  - apply opn_and; [apply near_opn | apply inter_opn].
  - apply closed_limit; auto. apply cellt_vol, Hc.
  - apply closed_limit; auto. apply cellt_vol, Hc'.
  - intros y [Hy Iy]. split; auto. apply (Dom_inside _ _ Hc Iy).
  - intros y [Hy Iy]. split; auto. apply (Dom_inside _ _ Hc' Iy).
  - assert (E : count w K p = count w K q).
    { apply weighted; auto. intros d i Hkn Hi X. destruct (CR d i Hkn Hi X) as [PA [X2 [y [[Wy _] [Cy Ly]]]]].
      split; auto. split; auto. clear X2.
      apply KG in Wy. destruct Wy as [_ Wy].
      specialize (Wy (d, i)). cbn [fst snd] in Wy. rewrite in_prod_iff in Wy.
      destruct (Wy (conj Hkn Hi)) as [[Cx Lx]|[|]]; [|tauto|tauto].
      apply HW; auto. exact (cells_valid _ _ Hkn). }
    rewrite (cnt_interior w K p c), (cnt_interior w K q c') in E by auto. exact E.
Qed.

Theorem face_to_face : forall x v c c', valid c -> valid c' ->
  closed (piece c) x -> closed (piece c') x -> carT (piece c) x v -> carT (piece c') x v.
Proof.
  intros x v c c' Hc Hc' C C' CAR.
  pose proof (constant_around x (fun c => Z.b2z (carb (piece c) x v))) as E.
  specialize (fun H => E H c c' Hc Hc' C C'). cbv beta in E.
  rewrite <- (carb_t _ x v (cellt_vol c (proj1 Hc))) in CAR. rewrite CAR in E.
  apply carb_t; [apply cellt_vol, Hc'|].
  destruct (carb (piece c') x v); auto. exfalso. cut (1 = 0)%Z; [discriminate|]. apply E. clear E CAR C C' Hc Hc' c c'.
  intros d i Hk Hi PA Cx Lx.
  destruct (sg_spec d i Hk Hi PA) as [S1 [S2 [S3 [S4 _]]]].
  set (ci' := across (d, i)) in *.
  assert (Lx' : coord (piece (fst ci')) (snd ci') x = 0).
  { unfold coord in *. rewrite (oddm_o _ _ x S4) in Lx. lra. }
  assert (V1 : 0 < vol (piece d)) by (apply cellt_vol, Hk).
  assert (V2 : 0 < vol (piece (fst ci'))) by (apply cellt_vol, S1).
  assert (S4' : opposite (facet (piece (fst ci')) (snd ci')) (facet (piece d) i)).
  { clear - S4. unfold opposite in *. intuition congruence. }
  f_equal. apply beq_iff. rewrite !carb_t by auto. split; intros CC.
  + apply carF_carT with (i := i); auto. apply carF_odd with (f := facet (piece (fst ci')) (snd ci')); auto.
    apply carT_carF; auto.
  + apply carF_carT with (i := snd ci'); auto. apply carF_odd with (f := facet (piece d) i); auto.
    apply carT_carF; auto.
Qed.

(** ** Convexity: the global consequence of a local inequality

    For each tile c an affine function f c.  If across every paired facet f c is
    at least f c' on the side of c', then f c >= f c' on all of c', whatever the
    two tiles.  (Delaunay's lemma; f c is the power of the circumsphere of c, up
    to a function that is the same for all tiles.) *)
Section Convexity.
Variable f : cell -> point -> R.
Hypothesis f_affine : forall c c', affine (fun y => f c y - f c' y).
Hypothesis f_local : forall c i y, valid c -> In i I4 -> paired (c, i) ->
  (coord (piece c) i y <= 0 -> f (fst (across (c, i))) y <= f c y) /\
  (0 <= coord (piece c) i y -> f c y <= f (fst (across (c, i))) y).

Theorem local_to_global : forall c c' x, valid c -> valid c' -> closed (piece c') x -> f c' x <= f c x.
Proof.
  intros c c' x Hc Hc' C'. apply Rnot_lt_le. intros LT.
  pose proof (cellt_vol c (proj1 Hc)) as V. pose proof (cellt_vol c' (proj1 Hc')) as V'.
  set (p0 := centroid (piece c)). pose proof (cen_inter _ V) as I0. fold p0 in I0.
  destruct (near_org_exists x) as [M1 [HM1 Hx]]. destruct (near_org_exists p0) as [M2 [HM2 Hp]].
  set (M := Rmax M1 M2). assert (m1 : M1 <= M) by apply Rmax_l. assert (m2 : M2 <= M) by apply Rmax_r.
  destruct (range M) as [K RG].
  assert (OV : open (fun y => near M1 org y /\ 0 < f c' y - f c y)).
  { apply opn_and; [apply near_opn|]. apply aff_pos_opn; auto. }
  destruct (OV x) as [e [He KV]]; [split; auto; lra|].
  destruct (closed_limit _ x e V' C' He) as [z [Nz Iz]].
  destruct (connect K M (fun y => near M org y /\ Dom y) (fun y => near M org y /\ inside (piece c) y)
     (fun y => (near M1 org y /\ 0 < f c' y - f c y) /\ inside (piece c') y))
    as [p [q [[Up1 Up2] [[[Vq1 Vq2] Vq3] [GE CR]]]]]; auto.
  - intros; apply near_Dom_convex; auto.
  - apply opn_and; [apply near_opn | apply inter_opn].
  - apply opn_and; [exact OV | apply inter_opn].
  - exists p0. split; auto. apply near_mono with M2; auto.
  - exists z. split; auto.
  - intros y [Hy Iy]. split; auto. apply (Dom_inside _ _ Hc Iy).
  - intros y [[Hy _] Iy]. split; [apply near_mono with M1; auto|]. apply (Dom_inside _ _ Hc' Iy).
  - assert (E : total (fun d => f d q) K q <= total (fun d => f d q) K p).
    { apply weighted_le; auto. intros d i Hd Hi X. destruct (CR d i Hd Hi X) as [PA [X2 _]]. split; auto. split; auto.
      pose proof (cells_valid _ _ Hd) as Hdv. destruct (f_local d i q Hdv Hi PA) as [F1 F2]. unfold coord in F1, F2.
      set (d' := fst (across (d, i))) in *.
      unfold crossing in *. destruct (crp (facet (piece d) i) p q) eqn:E1; destruct (crm (facet (piece d) i) p q) eqn:E2.
      - cbn in X. lia.
      - apply crp_t in E1. assert (f d q <= f d' q) by (apply F2; lra). change (IZR (Z.b2z true - Z.b2z false)) with 1. lra.
      - apply crm_t in E2. assert (f d' q <= f d q) by (apply F1; lra). change (IZR (Z.b2z false - Z.b2z true)) with (-1). lra.
      - cbn in X. lia. }
    assert (Ic : In c (cells K)). { apply RG with (y := p); auto. apply inter_closed; auto. }
    assert (Ic' : In c' (cells K)). { apply RG with (y := q); auto using inter_closed. apply near_mono with M1; auto. }
    rewrite (total_interior _ K p c), (total_interior _ K q c') in E by auto. lra.
Qed.
End Convexity.
End Once.
End Tiling.
