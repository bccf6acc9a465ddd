(** * The degree argument for any locally finite family of tetrahedra

    The tetrahedra have any index set [cell]; nothing needs to be periodic.  They are in an open
    convex domain [Dom], and a facet has a mate or lies on the boundary of the domain.
    Degree.v is about the translates of finitely many tetrahedra; in MosaicTiling.v the cells
    stand over a tiling of the plane, and every facet has a mate.

    - [range]: finitely many cells meet a bounded set.
    - [mates]: the mate of a facet is the same triangle, seen from the other side, and the mate
      of the mate is the facet.
    - [boundary]: the domain is inside of a facet without a mate.
    - [covered_once]: every nonempty bounded open part of the domain holds a point that lies
      inside of exactly one cell.  It suffices that there is such a point somewhere
      ([once_everywhere]), because the number of cells at a point is constant ([count_constant]).

    They imply that the cells cover the domain, that no inner point of a cell is in another
    one, and that two cells meet in a common face or not at all. *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology.
Import ListNotations.
Open Scope R_scope.

Section Cells.
Variables (cell : Type) (eq_dec : forall a b : cell, {a = b} + {a <> b}).
Variables (piece : cell -> tetrahedron) (valid : cell -> Prop) (Dom : point -> Prop).
(** The facets with a mate, and the mates. *)
Variables (paired : cell * nat -> Prop) (across : cell * nat -> cell * nat).
Definition finite_part (L : list cell) := NoDup L /\ forall c, In c L -> valid c.
Definition reaches (L : list cell) M := forall c y, valid c -> near M origin y -> closed (piece c) y -> In c L.
Hypothesis positive : forall c, valid c -> 0 < vol (piece c).
Hypothesis range : forall M, exists L, finite_part L /\ reaches L M.
Hypothesis mates : forall c i, valid c -> In i I4 -> paired (c, i) ->
  valid (fst (across (c, i))) /\ In (snd (across (c, i))) I4 /\ across (across (c, i)) = (c, i) /\
  opposite (facet (piece c) i) (facet (piece (fst (across (c, i)))) (snd (across (c, i)))) /\ paired (across (c, i)).
Hypothesis boundary : forall c i, valid c -> In i I4 -> paired (c, i) \/ forall y, Dom y -> 0 < coord (piece c) i y.
Hypothesis Dom_open : open Dom.
Hypothesis Dom_convex : forall p q s, Dom p -> Dom q -> 0 <= s <= 1 -> Dom (lerp p q s).
Hypothesis Dom_inside : forall c x, valid c -> inside (piece c) x -> Dom x.

(** A facet that a segment inside of the domain crosses is not on the boundary. *)
Lemma crossed_paired c i p q : valid c -> In i I4 -> Dom p -> Dom q -> crossing (facet (piece c) i) p q <> 0%Z -> paired (c, i).
Proof.
  intros Hc Hi Dp Dq CR. destruct (boundary c i Hc Hi) as [P|H]; auto. exfalso.
  pose proof (H p Dp) as Hp. pose proof (H q Dq) as Hq. unfold coord in Hp, Hq. unfold crossing in CR.
  destruct (crp (facet (piece c) i) p q) eqn:E1; [apply crp_t in E1; lra|].
  destruct (crm (facet (piece c) i) p q) eqn:E2; [apply crm_t in E2; lra|]. simpl in CR. lia.
Qed.

(** ** Weights that mates have in common *)
Definition count (w : cell -> Z) L x := zsum (fun c => (w c * Z.b2z (insideb (piece c) x))%Z) L.

Lemma weighted L p q w : finite_part L ->
  (forall c, In c L -> generic_for (piece c) p q) ->
  (forall c i, In c L -> In i I4 -> crossing (facet (piece c) i) p q <> 0%Z ->
     paired (c, i) /\ In (fst (across (c, i))) L /\ w (fst (across (c, i))) = w c) ->
  count w L p = count w L q.
Proof.
  intros [ND VL] G H. unfold count.
  cut (zsum (fun c => w c * Z.b2z (insideb (piece c) q) - w c * Z.b2z (insideb (piece c) p))%Z L = 0%Z).
  { rewrite zsum_sub. lia. }
  rewrite (zsum_ext _ (fun c => zsum (fun i => (w c * crossing (facet (piece c) i) p q)%Z) I4)).
  2:{ intros c Hc. rewrite zsum_mull, <- tet_crossing; [ring| |]; auto. }
  rewrite <- (zsum_prod (fun ci => (w (fst ci) * crossing (facet (piece (fst ci)) (snd ci)) p q)%Z)).
  apply zsum_invol with (s := across).
  - apply NoDup_list_prod; [exact ND|]. unfold I4. repeat constructor; simpl; intuition congruence.
  - intros [c i] Hin NZ. apply in_prod_iff in Hin as [Hc Hi]. cbn [fst snd] in NZ.
    assert (CR : crossing (facet (piece c) i) p q <> 0%Z) by (intros E; rewrite E in NZ; lia).
    destruct (H _ _ Hc Hi CR) as [H0 [H1 H2]].
    destruct (mates c i (VL c Hc) Hi H0) as [S1 [S2 [S3 [S4 _]]]].
    set (ci' := across (c, i)) in *. repeat split; auto.
    + match goal with |- In ?z _ => rewrite (surjective_pairing z) end. apply in_prod; auto.
    + rewrite H2. cbn [fst snd]. rewrite (oddm_cr _ _ p q S4). lia.
Qed.

(** The same with real weights and an inequality: if w does not increase from a
    cell to the next one along the segment, its total does not increase. *)
Definition total (w : cell -> R) L x := rsum (fun c => w c * IZR (Z.b2z (insideb (piece c) x))) L.
Lemma weighted_le L p q w : finite_part L ->
  (forall c, In c L -> generic_for (piece c) p q) ->
  (forall c i, In c L -> In i I4 -> crossing (facet (piece c) i) p q <> 0%Z ->
     paired (c, i) /\ In (fst (across (c, i))) L /\
     IZR (crossing (facet (piece c) i) p q) * (w c - w (fst (across (c, i)))) <= 0) ->
  total w L q <= total w L p.
Proof.
  intros [ND VL] G H. unfold total.
  cut (rsum (fun c => w c * IZR (Z.b2z (insideb (piece c) q)) - w c * IZR (Z.b2z (insideb (piece c) p))) L <= 0).
  { rewrite rsum_sub. lra. }
  rewrite (rsum_ext _ (fun c => rsum (fun i => w c * IZR (crossing (facet (piece c) i) p q)) I4)).
  2:{ intros c Hc. rewrite rsum_mull, <- rsum_IZR, <- tet_crossing, minus_IZR; [ring| |]; auto. }
  rewrite <- (rsum_prod (fun ci => w (fst ci) * IZR (crossing (facet (piece (fst ci)) (snd ci)) p q))).
  apply rsum_invol with (s := across) (b := fun ci => negb (Z.eqb (crossing (facet (piece (fst ci)) (snd ci)) p q) 0)).
  - apply NoDup_list_prod; [exact ND|]. unfold I4. repeat constructor; simpl; intuition congruence.
  - intros [c i] _ Hb. cbn [fst snd] in *. apply negb_false_iff, Z.eqb_eq in Hb. rewrite Hb. lra.
  - intros [c i] Hin Hb. apply in_prod_iff in Hin as [Hc Hi]. cbn [fst snd] in *.
    apply negb_true_iff, Z.eqb_neq in Hb.
    destruct (H _ _ Hc Hi Hb) as [H0 [H1 H2]].
    destruct (mates c i (VL c Hc) Hi H0) as [S1 [S2 [S3 [S4 _]]]].
    set (ci' := across (c, i)) in *. pose proof (oddm_cr _ _ p q S4) as E. repeat split; auto.
    + match goal with |- In ?z _ => rewrite (surjective_pairing z) end. apply in_prod; auto.
    + apply negb_true_iff, Z.eqb_neq. lia.
    + replace (crossing (facet (piece (fst ci')) (snd ci')) p q) with (- crossing (facet (piece c) i) p q)%Z by lia.
      rewrite opp_IZR. lra.
Qed.

(** ** Generic segments *)
Definition tris L : list triangle := flat_map (fun c => map (facet (piece c)) I4) L.
Lemma tris_In L f : In f (tris L) <-> exists c i, In c L /\ In i I4 /\ f = facet (piece c) i.
Proof.
  unfold tris. rewrite in_flat_map. split.
  - intros [c [Hc Hf]]. apply in_map_iff in Hf as [i [<- Hi]]. eauto.
  - intros [c [i [Hc [Hi ->]]]]. exists c. split; auto. apply in_map; auto.
Qed.
Lemma tri_nz L f : finite_part L -> In f (tris L) -> exists z, side f z <> 0.
Proof.
  intros [_ VL] H. apply tris_In in H as [c [i [Hc [Hi ->]]]]. exists (centroid (piece c)).
  pose proof (cen_inter (piece c) (positive c (VL c Hc)) i Hi). unfold coord in *. lra.
Qed.
Lemma rotations p f : orient p (t3 f) (t1 f) (t2 f) = - side f p /\ orient p (t1 f) (t2 f) (t3 f) = - side f p /\ orient p (t2 f) (t3 f) (t1 f) = - side f p.
Proof. unfold side. unf. repeat split; ring. Qed.

Lemma gen_pair L U V : finite_part L -> open U -> open V -> (exists x, U x) -> (exists x, V x) ->
  exists p q, U p /\ V q /\ forall c, In c L -> generic_for (piece c) p q.
Proof.
  intros FL OU OV NU NV.
  destruct (generic (map side (tris L)) U) as [p [Up Gp]]; auto.
  { intros f Hf. apply in_map_iff in Hf as [g [<- Hg]]. split; [apply aff_o|]. eapply tri_nz; eauto. }
  destruct (generic (flat_map (fun f => [side f; (fun x => orient p x (t1 f) (t2 f)); (fun x => orient p x (t2 f) (t3 f)); (fun x => orient p x (t3 f) (t1 f))]) (tris L)) V)
    as [q [Vq Gq]]; auto.
  { intros g Hg. apply in_flat_map in Hg as [f [Hf Hg]].
    assert (P : side f p <> 0). { apply Gp, in_map; auto. }
    destruct (rotations p f) as [D1 [D2 D3]].
    destruct Hg as [<-|[<-|[<-|[<-|[]]]]].
    - split; [apply aff_o|]. eapply tri_nz; eauto.
    - split; [apply aff_D2|]. exists (t3 f). rewrite D1. lra.
    - split; [apply aff_D2|]. exists (t1 f). rewrite D2. lra.
    - split; [apply aff_D2|]. exists (t2 f). rewrite D3. lra. }
  exists p, q. split; auto. split; auto. intros c Hc.
  assert (IT : forall i, In i I4 -> In (facet (piece c) i) (tris L)) by (intros i Hi; apply tris_In; eauto).
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

(** Two open sets in a convex set W are connected by a generic segment in W. *)
Lemma connect L M (W U V : point -> Prop) : finite_part L -> reaches L M ->
  (forall y, W y -> near M origin y /\ Dom y) ->
  (forall p q s, W p -> W q -> 0 <= s <= 1 -> W (lerp p q s)) ->
  open U -> open V -> (exists x, U x) -> (exists x, V x) ->
  (forall x, U x -> W x) -> (forall x, V x -> W x) ->
  exists p q, U p /\ V q /\ (forall c, In c L -> generic_for (piece c) p q) /\
  forall c i, In c L -> In i I4 -> crossing (facet (piece c) i) p q <> 0%Z ->
    paired (c, i) /\ In (fst (across (c, i))) L /\ exists y, W y /\ closed (piece c) y /\ coord (piece c) i y = 0.
Proof.
  intros FL RG WM WC OU OV NU NV UW VW.
  destruct (gen_pair L U V FL OU OV NU NV) as [p [q [Up [Vq G]]]].
  exists p, q. split; auto. split; auto. split; auto.
  intros c i Hc Hi CR. pose proof (proj2 FL c Hc) as Hk. pose proof (positive c Hk) as V0.
  assert (PA : paired (c, i)) by (apply crossed_paired with (p := p) (q := q); auto; apply WM; auto).
  destruct (mates c i Hk Hi PA) as [S1 [S2 [S3 [S4 _]]]].
  destruct (cr_meets _ i p q Hi V0 CR) as [s [Hs [C1 C2]]].
  split; auto. split.
  - set (ci' := across (c, i)) in *.
    assert (CR' : crossing (facet (piece (fst ci')) (snd ci')) p q <> 0%Z).
    { rewrite (oddm_cr _ _ p q S4) in CR. lia. }
    destruct (cr_meets _ _ p q S2 (positive _ S1) CR') as [s' [Hs' [C1' C2']]].
    apply RG with (y := lerp p q s'); auto. apply WM, WC; auto. lra.
  - exists (lerp p q s). split; auto. apply WC; auto. lra.
Qed.

(** ** The number of cells at a point *)
Definition one (c : cell) : Z := 1%Z.
Lemma cnt_one L x : count one L x = zsum (fun c => Z.b2z (insideb (piece c) x)) L.
Proof. unfold count, one. apply zsum_ext. intros. lia. Qed.
Lemma near_origin_exists x : exists M, 0 < M /\ near M origin x.
Proof.
  exists (Rabs (px x) + Rabs (py x) + Rabs (pz x) + 1).
  pose proof (Rabs_pos (px x)); pose proof (Rabs_pos (py x)); pose proof (Rabs_pos (pz x)).
  unfold near; cbn [origin px py pz]; rewrite !Rminus_0_r. repeat split; lra.
Qed.

Definition off_planes L p := forall ci, In ci (list_prod L I4) -> coord (piece (fst ci)) (snd ci) p <> 0.
Lemma near_Dom_convex e x p q s : near e x p /\ Dom p -> near e x q /\ Dom q -> 0 <= s <= 1 -> near e x (lerp p q s) /\ Dom (lerp p q s).
Proof. intros [? ?] [? ?] ?. split; [apply near_convex|apply Dom_convex]; auto. Qed.
Definition like L M p y := (near M origin y /\ Dom y) /\
  forall ci, In ci (list_prod L I4) -> 0 < coord (piece (fst ci)) (snd ci) p * coord (piece (fst ci)) (snd ci) y.
Lemma like_open L M p : open (like L M p).
Proof.
  apply opn_and; [apply opn_and; auto; apply near_opn|]. apply opn_all. intros ci _.
  destruct (aff_o (facet (piece (fst ci)) (snd ci))) as [a [b [c [d H]]]]. set (k := coord (piece (fst ci)) (snd ci) p).
  apply (aff_pos_opn (fun y => k * coord (piece (fst ci)) (snd ci) y)).
  exists (k * a), (k * b), (k * c), (k * d). intros y. unfold coord. rewrite H. ring.
Qed.
Lemma like_count L M p y : like L M p y -> count one L y = count one L p.
Proof.
  intros [_ H]. rewrite !cnt_one. apply zsum_ext. intros c Hc. f_equal. apply beq_iff. rewrite !interb_t.
  split; intros I i Hi; specialize (H (c, i) (proj2 (in_prod_iff _ _ _ _) (conj Hc Hi))); specialize (I i Hi); cbn [fst snd] in H; nra.
Qed.
Lemma count_constant L M p q : finite_part L -> reaches L M ->
  near M origin p -> Dom p -> off_planes L p -> near M origin q -> Dom q -> off_planes L q -> count one L p = count one L q.
Proof.
  intros FL RG Np Dp Op Nq Dq Oq.
  assert (SELF : forall x, near M origin x -> Dom x -> off_planes L x -> like L M x x).
  { intros x Nx Dx Ox. split; auto. intros ci Hci. specialize (Ox ci Hci). nra. }
  destruct (connect L M (fun y => near M origin y /\ Dom y) (like L M p) (like L M q)) as [p' [q' [Lp [Lq [G CR]]]]];
    eauto using like_open; try (intros; apply near_Dom_convex; auto).
  { intros y [Hy _]. exact Hy. }
  { intros y [Hy _]. exact Hy. }
  rewrite <- (like_count L M p p' Lp), <- (like_count L M q q' Lq).
  apply weighted; auto. intros c i Hc Hi X. destruct (CR c i Hc Hi X) as [X1 [X2 _]]. auto.
Qed.
Lemma off_planes_exists L U : finite_part L -> open U -> (exists x, U x) -> exists x, U x /\ off_planes L x.
Proof.
  intros FL OU NU. destruct (generic (map side (tris L)) U) as [p [Up Gp]]; auto.
  { intros f Hf. apply in_map_iff in Hf as [g [<- Hg]]. split; [apply aff_o|]. eapply tri_nz; eauto. }
  exists p. split; auto. intros [c i] H. apply in_prod_iff in H as [Hc Hi]. cbn [fst snd].
  apply (Gp (side (facet (piece c) i))), in_map, tris_In. eauto.
Qed.

(** ** The covering condition *)
Definition covered_once := forall M x (V : point -> Prop), near M origin x -> V x -> open V -> (forall y, V y -> Dom y) ->
  exists L q, V q /\ count one L q = 1%Z /\ finite_part L /\ reaches L M /\ near M origin q.

Lemma once_everywhere : (exists x c, valid c /\ inside (piece c) x /\ forall c', valid c' -> c' <> c -> ~ closed (piece c') x) -> covered_once.
Proof.
  intros [x0 [c0 [H0 [I0 NO]]]] M x V Nx Vx OV VD.
  destruct (near_origin_exists x0) as [M0 [_ N0]]. set (M' := Rmax M M0).
  assert (m : M <= M') by apply Rmax_l. assert (m0 : M0 <= M') by apply Rmax_r.
  destruct (range M') as [L [FL RG]].
  destruct (off_planes_exists L (fun y => V y /\ near M origin y)) as [q [[Vq Nq] Oq]]; auto.
  { apply opn_and; auto. apply near_opn. }
  { exists x. auto. }
  destruct (off_planes_exists L (fun y => (inside (piece c0) y /\ near M0 origin y) /\ forall c, In c L -> c = c0 \/ ~ closed (piece c) y))
    as [p [[[Ip Np] Cp] Op]]; auto.
  { apply opn_and; [apply opn_and; [apply inter_opn|apply near_opn]|]. apply opn_all. intros c _. apply opn_or; [apply opn_const|apply not_closed_opn]. }
  { exists x0. repeat split; auto; try apply N0. intros c Hc. destruct (eq_dec c c0); auto. right. apply NO; auto. apply FL, Hc. }
  exists L, q. split; [exact Vq|]. split; [|split; [exact FL|split; [|exact Nq]]].
  2:{ intros c y Vc Ny C. apply RG with (y := y); auto. apply near_mono with M; auto. }
  rewrite (count_constant L M' q p); auto; try (eapply near_mono; [|eauto]; auto); [|apply (Dom_inside c0); auto].
  rewrite cnt_one. rewrite (zsum_single _ _ c0); [|apply FL| |].
  - rewrite (proj2 (interb_t _ _) Ip). reflexivity.
  - apply RG with (y := p); auto; [apply near_mono with M0; auto|apply inter_closed; auto].
  - intros c Hc Ne. destruct (insideb (piece c) p) eqn:E; [|reflexivity]. exfalso.
    apply interb_t, inter_closed in E. destruct (Cp c Hc); tauto.
Qed.

(** ** What follows *)
Section Once.
Hypothesis once : covered_once.

Theorem cover x : (forall e, 0 < e -> exists y, near e x y /\ Dom y) -> exists c, valid c /\ closed (piece c) x.
Proof.
  intros LIM. destruct (near_origin_exists x) as [M [HM Hx]]. destruct (range M) as [L [FL RG]].
  destruct (existsb (fun c => closedb (piece c) x) L) eqn:E.
  - apply existsb_exists in E as [c [Hc E]]. apply closedb_t in E. exists c. split; auto. apply FL, Hc.
  - exfalso.
    assert (NC : forall c, In c L -> ~ closed (piece c) x).
    { intros c Hc C. assert (existsb (fun c => closedb (piece c) x) L = true); [|congruence].
      apply existsb_exists. exists c. split; auto. apply closedb_t; auto. }
    assert (OV : open (fun y => near M origin y /\ forall c, In c L -> ~ closed (piece c) y)).
    { apply opn_and; [apply near_opn|]. apply opn_all. intros c _. apply not_closed_opn. }
    destruct (OV x (conj Hx NC)) as [e [He KV]]. destruct (LIM e He) as [z [Nz Dz]]. destruct (KV z Nz) as [Mz Vz].
    destruct (once M z (fun y => (near M origin y /\ forall c, In c L -> ~ closed (piece c) y) /\ Dom y)) as [L' [q [[[_ Vq] _] [C1 [FL' [RG' Hq]]]]]]; auto.
    { apply opn_and; auto. }
    { tauto. }
    rewrite cnt_one in C1.
    destruct (zsum_b2z_pos (fun c => insideb (piece c) q) L') as [c [Hc Hi]]; [lia|].
    apply interb_t, inter_closed in Hi. apply (Vq c); auto. apply RG with (y := q); auto. apply FL', Hc.
Qed.

Theorem disjoint x c c' : valid c -> valid c' -> inside (piece c) x -> inside (piece c') x -> c = c'.
Proof.
  intros Hc Hc' I I'. destruct (eq_dec c c') as [|Ne]; auto. exfalso.
  destruct (near_origin_exists x) as [M [HM Hx]].
  destruct (once M x (fun y => inside (piece c) y /\ inside (piece c') y)) as [L [q [[Q1 Q2] [C1 [FL [RG Hq]]]]]]; auto.
  { apply opn_and; apply inter_opn. }
  { intros y [Iy _]. apply (Dom_inside _ _ Hc Iy). }
  rewrite cnt_one in C1.
  pose proof (zsum_b2z_ge2 (fun c => insideb (piece c) q) L c c') as G.
  assert (2 <= 1)%Z; [|lia]. rewrite <- C1 at 1. apply G; auto; try (apply interb_t; auto);
  apply RG with (y := q); auto using inter_closed.
Qed.

(** An inner point of one cell lies in no other closed cell. *)
Theorem disjoint_closed x c c' : valid c -> valid c' -> inside (piece c) x -> closed (piece c') x -> c = c'.
Proof.
  intros Hc Hc' I I'. destruct (inter_opn _ _ I) as [e [He K]].
  destruct (closed_limit _ x e (positive c' Hc') I' He) as [y [Ny Iy]].
  apply disjoint with (x := y); auto.
Qed.

Lemma cnt_interior w L q c : finite_part L -> In c L -> inside (piece c) q -> count w L q = w c.
Proof.
  intros FL Hc I. unfold count. rewrite (zsum_single _ _ c); [|apply FL|auto|].
  - rewrite (proj2 (interb_t _ _) I). simpl. lia.
  - intros c' Hc' Ne. destruct (insideb (piece c') q) eqn:Eb; simpl; [|lia].
    exfalso. apply Ne. apply interb_t in Eb. apply disjoint with (x := q); auto; apply FL; auto.
Qed.

Lemma total_interior w L q c : finite_part L -> In c L -> inside (piece c) q -> total w L q = w c.
Proof.
  intros FL Hc I. unfold total. rewrite (rsum_single _ _ c); [|apply FL|auto|].
  - rewrite (proj2 (interb_t _ _) I). simpl. lra.
  - intros c' Hc' Ne. destruct (insideb (piece c') q) eqn:Eb; simpl; [|lra].
    exfalso. apply Ne. apply interb_t in Eb. apply disjoint with (x := q); auto; apply FL; auto.
Qed.

(** What passes through every facet around x is the same for all cells that contain x. *)
Theorem constant_around (x : point) (w : cell -> Z) :
  (forall d i, valid d -> In i I4 -> paired (d, i) -> closed (piece d) x -> coord (piece d) i x = 0 -> w (fst (across (d, i))) = w d) ->
  forall c c', valid c -> valid c' -> closed (piece c) x -> closed (piece c') x -> w c = w c'.
Proof.
  intros HW c c' Hc Hc' C C'.
  destruct (near_origin_exists x) as [M1 [HM1 Hx]].
  destruct (range M1) as [L [FL RG]].
  set (G := fun y => near M1 origin y /\ forall ci, In ci (list_prod L I4) ->
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
  assert (Ic : In c L) by (apply RG with (y := x); auto).
  assert (Ic' : In c' L) by (apply RG with (y := x); auto).
  destruct (connect L M1 (fun y => near e x y /\ Dom y) (fun y => near e x y /\ inside (piece c) y) (fun y => near e x y /\ inside (piece c') y))
    as [p [q [[Up1 Up2] [[Vq1 Vq2] [GE CR]]]]]; auto.
  - intros y [Hy Dy]. split; auto. apply KG in Hy. apply Hy.
  - intros; apply near_Dom_convex; auto.
  - apply opn_and; [apply near_opn | apply inter_opn].
  - apply opn_and; [apply near_opn | apply inter_opn].
  - apply closed_limit; auto.
  - apply closed_limit; auto.
  - intros y [Hy Iy]. split; auto. apply (Dom_inside _ _ Hc Iy).
  - intros y [Hy Iy]. split; auto. apply (Dom_inside _ _ Hc' Iy).
  - assert (E : count w L p = count w L q).
    { apply weighted; auto. intros d i Hd Hi X. destruct (CR d i Hd Hi X) as [PA [X2 [y [[Wy _] [Cy Ly]]]]].
      split; auto. split; auto. apply KG in Wy. destruct Wy as [_ Wy].
      specialize (Wy (d, i)). cbn [fst snd] in Wy. rewrite in_prod_iff in Wy.
      destruct (Wy (conj Hd Hi)) as [[Cx Lx]|[|]]; [|tauto|tauto].
      apply HW; auto. apply FL, Hd. }
    rewrite (cnt_interior w L p c), (cnt_interior w L q c') in E by auto. exact E.
Qed.

Theorem face_to_face x v c c' : valid c -> valid c' ->
  closed (piece c) x -> closed (piece c') x -> carT (piece c) x v -> carT (piece c') x v.
Proof.
  intros Hc Hc' C C' CAR.
  pose proof (constant_around x (fun c => Z.b2z (carb (piece c) x v))) as E.
  specialize (fun H => E H c c' Hc Hc' C C'). cbv beta in E.
  rewrite <- (carb_t _ x v (positive c Hc)) in CAR. rewrite CAR in E.
  apply carb_t; [apply positive, Hc'|].
  destruct (carb (piece c') x v); auto. exfalso. cut (1 = 0)%Z; [discriminate|]. apply E. clear E CAR C C' Hc Hc' c c'.
  intros d i Hk Hi PA Cx Lx.
  destruct (mates d i Hk Hi PA) as [S1 [S2 [S3 [S4 _]]]].
  set (ci' := across (d, i)) in *.
  assert (Lx' : coord (piece (fst ci')) (snd ci') x = 0).
  { unfold coord in *. rewrite (oddm_o _ _ x S4) in Lx. lra. }
  assert (V1 : 0 < vol (piece d)) by (apply positive, Hk).
  assert (V2 : 0 < vol (piece (fst ci'))) by (apply positive, S1).
  assert (S4' : opposite (facet (piece (fst ci')) (snd ci')) (facet (piece d) i)).
  { clear - S4. unfold opposite in *. intuition congruence. }
  f_equal. apply beq_iff. rewrite !carb_t by auto. split; intros CC.
  + apply carF_carT with (i := i); auto. apply carF_odd with (f := facet (piece (fst ci')) (snd ci')); auto.
    apply carT_carF; auto.
  + apply carF_carT with (i := snd ci'); auto. apply carF_odd with (f := facet (piece d) i); auto.
    apply carT_carF; auto.
Qed.

(** ** Convexity: the global consequence of a local inequality

    For each cell c an affine function f c.  If across every paired facet f c is
    at least f c' on the side of c', then f c >= f c' on all of c', whatever the
    two cells.  (Delaunay's lemma; f c is the power of the circumsphere of c, up
    to a function that is the same for all cells.) *)
Section Convexity.
Variable f : cell -> point -> R.
Hypothesis f_affine : forall c c', affine (fun y => f c y - f c' y).
Hypothesis f_local : forall c i y, valid c -> In i I4 -> paired (c, i) ->
  (coord (piece c) i y <= 0 -> f (fst (across (c, i))) y <= f c y) /\
  (0 <= coord (piece c) i y -> f c y <= f (fst (across (c, i))) y).

Theorem local_to_global : forall c c' x, valid c -> valid c' -> closed (piece c') x -> f c' x <= f c x.
Proof.
  intros c c' x Hc Hc' C'. apply Rnot_lt_le. intros LT.
  pose proof (positive c Hc) as V. pose proof (positive c' Hc') as V'.
  set (p0 := centroid (piece c)). pose proof (cen_inter _ V) as I0. fold p0 in I0.
  destruct (near_origin_exists x) as [M1 [HM1 Hx]]. destruct (near_origin_exists p0) as [M2 [HM2 Hp]].
  set (M := Rmax M1 M2). assert (m1 : M1 <= M) by apply Rmax_l. assert (m2 : M2 <= M) by apply Rmax_r.
  destruct (range M) as [L [FL RG]].
  assert (OV : open (fun y => near M1 origin y /\ 0 < f c' y - f c y)).
  { apply opn_and; [apply near_opn|]. apply aff_pos_opn; auto. }
  destruct (OV x) as [e [He KV]]; [split; auto; lra|].
  destruct (closed_limit _ x e V' C' He) as [z [Nz Iz]].
  destruct (connect L M (fun y => near M origin y /\ Dom y) (fun y => near M origin y /\ inside (piece c) y)
     (fun y => (near M1 origin y /\ 0 < f c' y - f c y) /\ inside (piece c') y))
    as [p [q [[Up1 Up2] [[[Vq1 Vq2] Vq3] [GE CR]]]]]; auto.
  - intros; apply near_Dom_convex; auto.
  - apply opn_and; [apply near_opn | apply inter_opn].
  - apply opn_and; [exact OV | apply inter_opn].
  - exists p0. split; auto. apply near_mono with M2; auto.
  - exists z. split; auto.
  - intros y [Hy Iy]. split; auto. apply (Dom_inside _ _ Hc Iy).
  - intros y [[Hy _] Iy]. split; [apply near_mono with M1; auto|]. apply (Dom_inside _ _ Hc' Iy).
  - assert (E : total (fun d => f d q) L q <= total (fun d => f d q) L p).
    { apply weighted_le; auto. intros d i Hd Hi X. destruct (CR d i Hd Hi X) as [PA [X2 _]]. split; auto. split; auto.
      pose proof (proj2 FL d Hd) as Hdv. destruct (f_local d i q Hdv Hi PA) as [F1 F2]. unfold coord in F1, F2.
      set (d' := fst (across (d, i))) in *.
      unfold crossing in *. destruct (crp (facet (piece d) i) p q) eqn:E1; destruct (crm (facet (piece d) i) p q) eqn:E2.
      - cbn in X. lia.
      - apply crp_t in E1. assert (f d q <= f d' q) by (apply F2; lra). change (IZR (Z.b2z true - Z.b2z false)) with 1. lra.
      - apply crm_t in E2. assert (f d' q <= f d q) by (apply F1; lra). change (IZR (Z.b2z false - Z.b2z true)) with (-1). lra.
      - cbn in X. lia. }
    assert (Ic : In c L). { apply RG with (y := p); auto. apply inter_closed; auto. }
    assert (Ic' : In c' L). { apply RG with (y := q); auto using inter_closed. apply near_mono with M1; auto. }
    rewrite (total_interior _ L p c), (total_interior _ L q c') in E by auto. lra.
Qed.
End Convexity.
End Once.
End Cells.
