(** * Regions: the theorem of docs/soundness.md, section 8, in lattice coordinates

    A region is the union of its tiles.  Nothing says how large it is, so there is no volume
    sum.  A facet without a mate is a *boundary facet*.  The hypotheses are

    - [apart]: two boundary facets are separated by an affine function that is zero at their
      common corners only;
    - [uncovered]: no tile but its own contains the middle of a boundary facet;
    - [bounded_somewhere]: there is a boundary facet.

    The plan of the proof.  N(x) is the number of tiles with x in their interior, [count one].

    1. [steady]: N, and any sum of weights that mates have in common, is equal at the ends of
       a generic segment that crosses no boundary facet.
    2. [first_exit]: otherwise there is a first boundary facet; N is constant before.
    3. [beside_boundary]: near any inner point of a boundary facet, N is 1 on its inner side and
       0 on its outer side.  By 1, along a segment beside the facet from its middle:
       the separating functions are negative at both ends, so it meets no other boundary facet.
    4. [at_most_one]: N <= 1.  From any point go to the outer side of a boundary facet, where
       N = 0.  If N > 1 at the start, a boundary facet is crossed, and before the first one
       N would still be more than 1, against 3.
    5. [region_once]: so the part of Degree.v that follows from N = 1 in the tiles applies:
       interiors are disjoint.
    6. [follow], [region_face_to_face]: two tiles at x have the same carrier of x, or each has
       that of a boundary facet at x; and these agree, by [apart].
    7. [region_boundary]: the topological boundary is the union of the boundary facets.
    8. [neighbours]: tiles with the corners of a facet in common are mates there.

    A lattice of any rank serves: [lat] is any sublattice. *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Facets Euclid.
Import ListNotations.
Open Scope R_scope.

Section Region.
Variables (N : nat) (T : nat -> tetrahedron) (h : R) (lat : Z3 -> bool).
Variable mate : nat -> nat -> option (nat * nat * Z3).
Notation piece := (Degree.piece T h).
Notation valid := (Degree.valid N lat).
Notation cells := (Degree.cells N lat).
Notation across := (Degree.across mate).
Notation paired := (Degree.paired mate).
Notation count := (Degree.count N T h lat).
Notation off_planes := (Degree.off_planes N T h lat).

Hypothesis h_pos : 0 < h.
Hypothesis lat_add : forall a b, lat a = true -> lat b = true -> lat (zadd3 a b) = true.
Hypothesis Hvol : forall k, (k < N)%nat -> 0 < vol (T k).
Hypothesis Hmate : forall k i, (k < N)%nat -> In i I4 ->
  match mate k i with
  | Some (k', i', d) =>
    (k' < N)%nat /\ In i' I4 /\ lat d = true /\ mate k' i' = Some (k, i, zopp3 d) /\
    opposite (facet (T k) i) (facet (translate (vec h d) (T k')) i')
  | None => True
  end.

(** The boundary facet (c, i), as a triangle: the facet of the tile c opposite to its corner i. *)
Definition boundary (f : cell * nat) := valid (fst f) /\ In (snd f) I4 /\ ~ paired f.
Definition face (f : cell * nat) := facet (piece (fst f)) (snd f).
Hypothesis apart : forall f g, boundary f -> boundary g -> f <> g -> exists w, separates w (face f) (face g).
Hypothesis uncovered : forall f c, boundary f -> valid c -> c <> fst f -> ~ closed (piece c) (middle (face f)).
Hypothesis bounded_somewhere : exists f, boundary f.

Let Mate_nowhere : forall k i, (k < N)%nat -> In i I4 ->
  match mate k i with
  | Some (k', i', d) =>
    (k' < N)%nat /\ In i' I4 /\ lat d = true /\ mate k' i' = Some (k, i, zopp3 d) /\
    opposite (facet (T k) i) (facet (translate (vec h d) (T k')) i')
  | None => forall n y, lat n = true -> False -> 0 < coord (piece (k, n)) i y
  end.
Proof. intros k i Hk Hi. pose proof (Hmate k i Hk Hi) as H. destruct (mate k i) as [[[k' i'] d]|]; auto. tauto. Qed.

Lemma piece_vol c : valid c -> 0 < vol (piece c).
Proof. intros [H _]. apply cellt_vol with (N := N); auto. Qed.
Lemma across_spec c i : valid c -> In i I4 -> paired (c, i) ->
  valid (fst (across (c, i))) /\ In (snd (across (c, i))) I4 /\ across (across (c, i)) = (c, i) /\
  opposite (facet (piece c) i) (facet (piece (fst (across (c, i)))) (snd (across (c, i)))) /\ paired (across (c, i)).
Proof. apply (sg_spec N T h lat (fun _ => False) mate lat_add Mate_nowhere). Qed.
Lemma paired_dec f : paired f \/ ~ paired f.
Proof. unfold Degree.paired. destruct (mate _ _); [left|right]; congruence. Qed.
Lemma facet_dec (f g : cell * nat) : {f = g} + {f <> g}.
Proof. repeat decide equality. Qed.
Lemma face_on f x : boundary f -> (on (face f) x <-> closed (piece (fst f)) x /\ coord (piece (fst f)) (snd f) x = 0).
Proof. intros [V [I _]]. apply facet_on; auto. apply piece_vol, V. Qed.

(** ** 1. Weights that mates have in common *)
Definition reaches K M := forall c y, valid c -> near M org y -> closed (piece c) y -> In c (cells K).
Definition generic_in K p q := forall c, In c (cells K) -> generic_for (piece c) p q.
Definition crosses K p q (f : cell * nat) := In (fst f) (cells K) /\ In (snd f) I4 /\ crossing (face f) p q <> 0%Z.

Lemma steady K M w p q : reaches K M -> near M org p -> near M org q -> generic_in K p q ->
  (forall f, crosses K p q f -> paired f /\ w (fst (across f)) = w (fst f)) -> count w K p = count w K q.
Proof.
  intros RG Np Nq G H.
  apply (weighted N T h lat (fun _ => False) mate lat_add Hvol Mate_nowhere); auto.
  intros c i Hc Hi CR. destruct (H (c, i)) as [P E]; [repeat split; auto|]. split; auto. split; auto.
  pose proof (cells_valid _ _ _ _ Hc) as V. destruct (across_spec c i V Hi P) as [S1 [S2 [S3 [S4 _]]]].
  assert (CR' : crossing (facet (piece (fst (across (c, i)))) (snd (across (c, i)))) p q <> 0%Z).
  { rewrite (oddm_cr _ _ p q S4) in CR. lia. }
  destruct (cr_meets _ _ p q S2 (piece_vol _ S1) CR') as [s [Hs [C1 C2]]].
  apply RG with (y := lerp p q s); auto. apply near_convex; auto. lra.
Qed.
Lemma crosses_boundary K p q f : crosses K p q f -> ~ paired f -> boundary f.
Proof. intros [A [B C]] D. repeat split; auto; apply (cells_valid _ _ _ _ A). Qed.
Lemma crosses_inner K p q f : crosses K p q f -> exists s, 0 < s < 1 /\ inner (face f) (lerp p q s).
Proof. intros [A [B C]]. apply crossed_inner; auto. apply piece_vol, (cells_valid _ _ _ _ A). Qed.
Lemma generic_in_swap K p q : generic_in K p q -> generic_in K q p.
Proof. intros H c Hc. apply generic_swap; auto. Qed.
Lemma generic_off K p q : generic_in K p q -> off_planes K q.
Proof. intros G [c i] H. apply in_prod_iff in H as [Hc Hi]. apply (g_q _ _ _ (G c Hc)); auto. Qed.

(** ** 2. The first boundary facet on a generic segment *)
Definition parameter p q (f : cell * nat) := - side (face f) p / (side (face f) q - side (face f) p).
Lemma crosses_sides K p q f : crosses K p q f -> side (face f) p * side (face f) q < 0.
Proof.
  intros [_ [_ H]]. unfold crossing in H. destruct (crp (face f) p q) eqn:P1; [apply crp_t in P1; nra|].
  destruct (crm (face f) p q) eqn:P2; [apply crm_t in P2; nra|]. simpl in H. congruence.
Qed.
Lemma parameter_spec K p q f : crosses K p q f -> let s := parameter p q f in
  0 < s < 1 /\ inner (face f) (lerp p q s) /\ forall u, side (face f) (lerp p q u) * s = side (face f) p * (s - u).
Proof.
  intros H. destruct (crosses_inner K p q f H) as [s [Hs I]]. pose proof (crosses_sides K p q f H) as O.
  assert (D : side (face f) q - side (face f) p <> 0) by nra.
  assert (Z : side (face f) (lerp p q s) = 0).
  { destruct H as [Hc [Hi _]]. apply facet_inner in I; auto. { apply I. } apply piece_vol, (cells_valid _ _ _ _ Hc). }
  rewrite o_lerp in Z. assert (E : parameter p q f = s).
  { unfold parameter. apply Rmult_eq_reg_r with (side (face f) q - side (face f) p); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by auto. lra. }
  cbv zeta. rewrite E. split; auto. split; auto. intros u. rewrite o_lerp.
  replace (side (face f) p) with (- (s * (side (face f) q - side (face f) p))) at 1 3 by lra. ring.
Qed.

Lemma first_exit K p q : generic_in K p q -> (exists f, crosses K p q f /\ ~ paired f) ->
  exists f s, crosses K p q f /\ ~ paired f /\ 0 < s < 1 /\ inner (face f) (lerp p q s) /\
  forall e, 0 < e -> exists u, 0 < u < s /\ near e (lerp p q s) (lerp p q u) /\ generic_in K p (lerp p q u) /\
    forall g, crosses K p (lerp p q u) g -> crosses K p q g /\ paired g.
Proof.
  intros G [f0 [C0 U0]].
  assert (CD : forall f, crosses K p q f /\ ~ paired f \/ ~ (crosses K p q f /\ ~ paired f)).
  { intros f. destruct (paired_dec f) as [P|P]; [right; tauto|]. unfold crosses.
    destruct (in_dec cell_eq_dec (fst f) (cells K)); [|right; tauto]. destruct (in_dec Nat.eq_dec (snd f) I4); [|right; tauto].
    destruct (Z.eq_dec (crossing (face f) p q) 0); [right; tauto|left; tauto]. }
  (* the list of the boundary facets that are crossed *)
  assert (L : exists l, forall f, In f l <-> crosses K p q f /\ ~ paired f).
  { assert (L : forall l, exists l', forall f, In f l' <-> In f l /\ crosses K p q f /\ ~ paired f).
    { induction l as [|f l [l' IH]]; [exists []; simpl; tauto|]. destruct (CD f) as [Y|Y].
      - exists (f :: l'). intros g. simpl. rewrite IH. split; [intros [<-|?]; tauto|tauto].
      - exists l'. intros g. simpl. rewrite IH. split; [tauto|]. intros [[<-|?] ?]; tauto. }
    destruct (L (list_prod (cells K) I4)) as [l' Hl]. exists l'. intros [c i]. rewrite Hl, in_prod_iff. unfold crosses; cbn [fst snd]. tauto. }
  destruct L as [l Hl].
  destruct (least (parameter p q) l) as [f [Hf Lf]].
  { intros E. assert (X : In f0 l) by (apply Hl; auto). rewrite E in X. destruct X. }
  apply Hl in Hf as [Cf Uf]. destruct (parameter_spec K p q f Cf) as [Hs [I _]]. set (s := parameter p q f) in *.
  exists f, s. repeat split; try apply Cf; auto; try lra. intros e He.
  destruct (lerp_close p q s e He) as [d [Hd CL]].
  (* parameters where the segment meets planes *)
  destruct (just_before (map (parameter p q) (list_prod (cells K) I4)) (Rmax 0 (s - d)) s) as [u [Hu Bu]]; [apply Rmax_lub_lt; lra|].
  pose proof (Rmax_l 0 (s - d)). pose proof (Rmax_r 0 (s - d)).
  exists u. split; [lra|]. split; [apply CL, Rabs_def1; lra|]. split.
  - intros c Hc. apply generic_part; auto; [lra|]. intros i Hi Z.
    destruct (just_before [] 0 1) as [_ _]; [lra|].
    pose proof (g_p _ _ _ (G c Hc) i Hi) as Gp. pose proof (g_q _ _ _ (G c Hc) i Hi) as Gq. unfold coord in *. rewrite o_lerp in Z.
    assert (D : side (facet (piece c) i) q - side (facet (piece c) i) p <> 0) by (intros E; rewrite E in Z; lra).
    assert (E : parameter p q (c, i) = u).
    { unfold parameter, face; cbn [fst snd]. apply Rmult_eq_reg_r with (side (facet (piece c) i) q - side (facet (piece c) i) p); auto.
      unfold Rdiv. rewrite Rmult_assoc, Rinv_l by auto. lra. }
    specialize (Bu u). rewrite <- E in Bu at 1. assert (u < u); [|lra]. apply Bu; [|lra]. apply in_map, in_prod; auto.
  - intros g [Hc [Hi CR]].
    assert (Cg : crosses K p q g). { repeat split; auto. apply crossing_part with (s := u); auto. lra. }
    split; auto. destruct (paired_dec g) as [P|P]; auto. exfalso.
    assert (Lg : s <= parameter p q g) by (apply Lf, Hl; auto).
    destruct (parameter_spec K p q g Cg) as [Hs' [_ Sg]]. specialize (Sg u).
    assert (O : side (face g) p * side (face g) (lerp p q u) < 0) by (apply (crosses_sides K); repeat split; auto).
    set (sg := parameter p q g) in *. set (a := side (face g) p) in *. set (b := side (face g) (lerp p q u)) in *.
    assert (X : 0 <= a * (b * sg)). { rewrite Sg. replace (a * (a * (sg - u))) with ((a * a) * (sg - u)) by ring. apply Rmult_le_pos; nra. }
    assert (a * (b * sg) < 0); [|lra]. replace (a * (b * sg)) with (- (- (a * b) * sg)) by ring.
    assert (0 < - (a * b) * sg) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

(** ** 3. N beside a boundary facet *)
(** The cells K reach all tiles near M', and the middle of each boundary facet near M is near M'. *)
Record reach K M M' : Prop := {
  reach_le : M <= M';
  reach_cells : reaches K M';
  reach_middle : forall f x, boundary f -> near M org x -> on (face f) x -> near M' org (middle (face f)) }.
Lemma list_bounded (l : list point) : exists M, forall x, In x l -> near M org x.
Proof.
  induction l as [|y l [M IH]]; [exists 0; simpl; tauto|]. destruct (near_org_exists y) as [M' [_ Hy]].
  exists (Rmax M M'). intros x [<-|Hx].
  - apply near_mono with M'; auto. apply Rmax_r.
  - apply near_mono with M; auto. apply Rmax_l.
Qed.
Lemma reach_exists M : exists K M', reach K M M'.
Proof.
  destruct (range N T h lat h_pos Hvol M) as [K RG]. destruct (list_bounded (map (fun f => middle (face f)) (list_prod (cells K) I4))) as [M1 H1].
  destruct (range N T h lat h_pos Hvol (Rmax M M1)) as [K' RG']. exists K', (Rmax M M1). split; auto.
  - apply Rmax_l.
  - intros f x Hf Nx Ox. apply near_mono with M1; [apply Rmax_r|]. apply H1.
    apply (in_map (fun f => middle (face f))). destruct f as [c i]. apply in_prod; [|apply Hf].
    destruct Hf as [V [I U]]. apply RG with (y := x); auto. apply (face_on (c, i)) in Ox; [|repeat split; auto; apply V]. apply Ox.
Qed.

(** Segments between two balls around inner points of f meet no other boundary facet. *)
Lemma beside_others f z m : boundary f -> inner (face f) z -> inner (face f) m -> forall l, exists e, 0 < e /\
  forall y y' s g, near e z y -> near e m y' -> 0 <= s <= 1 -> In g l -> boundary g -> g <> f -> ~ on (face g) (lerp y y' s).
Proof.
  intros Hf Iz Im. induction l as [|g l [e [He IH]]]; [exists 1; split; [lra|simpl; tauto]|].
  assert (D : boundary g \/ ~ boundary g).
  { unfold boundary. destruct (paired_dec g); [tauto|]. unfold Degree.valid.
    destruct (lt_dec (fst (fst g)) N); [|tauto]. destruct (bool_dec (lat (snd (fst g))) true); [|tauto].
    destruct (in_dec Nat.eq_dec (snd g) I4); tauto. }
  destruct D as [Hg|Hg]; [|exists e; split; auto; intros y y' s g' A B C [<-|X]; [tauto|apply IH; auto]].
  destruct (facet_dec g f) as [->|Ne]; [exists e; split; auto; intros y y' s g' A B C [<-|X]; [tauto|apply IH; auto]|].
  destruct (apart f g Hf Hg) as [w S]; [congruence|].
  assert (O : open (fun x => w x < 0)) by (apply aff_neg_opn, S).
  destruct (O z (separates_inner _ _ _ _ S Iz)) as [e1 [He1 K1]]. destruct (O m (separates_inner _ _ _ _ S Im)) as [e2 [He2 K2]].
  exists (Rmin e (Rmin e1 e2)). split; [repeat apply Rmin_glb_lt; auto|].
  pose proof (Rmin_l e (Rmin e1 e2)). pose proof (Rmin_r e (Rmin e1 e2)). pose proof (Rmin_l e1 e2). pose proof (Rmin_r e1 e2).
  intros y y' s g' Ny Ny' Hs [<-|Hg'] B Nf.
  - intros Og. pose proof (separates_on _ _ _ _ S Og) as P. rewrite aff_lerp in P by apply S.
    assert (w y < 0) by (apply K1, near_mono with (2 := Ny); lra). assert (w y' < 0) by (apply K2, near_mono with (2 := Ny'); lra). nra.
  - apply IH; auto; [apply near_mono with (2 := Ny) | apply near_mono with (2 := Ny')]; lra.
Qed.

Definition likewise K M p y := Degree.like N T h lat (fun _ => True) K M p y.
Lemma likewise_open K M p : open (likewise K M p).
Proof. apply like_open. intros x _. exists 1. split; [lra|auto]. Qed.
Lemma likewise_self K M p : near M org p -> off_planes K p -> likewise K M p p.
Proof. intros Np Op. split; auto. intros ci Hci. specialize (Op ci Hci). nra. Qed.
Lemma likewise_side K M p y c i : likewise K M p y -> In c (cells K) -> In i I4 -> 0 < coord (piece c) i p * coord (piece c) i y.
Proof. intros [_ H] Hc Hi. apply (H (c, i)), in_prod; auto. Qed.

(** A point near x on a given side of a plane through x. *)
Lemma near_side t i x e k : 0 < vol t -> In i I4 -> coord t i x = 0 -> 0 < e -> k <> 0 -> exists y, near e x y /\ 0 < k * coord t i y.
Proof.
  intros V Hi Z He Hk. pose proof (cen_inter t V i Hi) as P.
  destruct (lerp_near e x (lerp x (centroid t) k) He) as [s [Hs Ny]]. exists (lerp x (lerp x (centroid t) k) s). split; auto.
  unfold coord in *. rewrite !o_lerp, Z. set (a := side (facet t i) (centroid t)) in *.
  replace (k * (0 + s * (0 + k * (a - 0) - 0))) with ((k * k) * (s * a)) by ring. apply Rmult_lt_0_compat; [|apply Rmult_lt_0_compat; lra].
  destruct (Rlt_dec 0 k); nra.
Qed.

Lemma beside_boundary K M M' f z : reach K M M' -> boundary f -> near M org z -> inner (face f) z ->
  exists e, 0 < e /\ forall y, near e z y -> off_planes K y -> count one K y = Z.b2z (posb (coord (piece (fst f)) (snd f) y)).
Proof.
  intros R Hf Nz Iz. set (m := middle (face f)). pose proof (middle_inner (face f)) as Im. fold m in Im.
  assert (Nm : near M' org m) by (apply (reach_middle _ _ _ R f z); auto; apply inner_on; auto).
  assert (Nz' : near M' org z) by (apply near_mono with M; auto; apply R).
  destruct f as [c i]. pose proof Hf as [Vc [Hi Uf]]. cbn [fst snd] in *. pose proof (piece_vol c Vc) as V0.
  apply facet_inner in Im as Im'; auto. destruct Im' as [Zm Pm]. cbn [fst snd] in Zm, Pm.
  assert (Cm : closed (piece c) m).
  { intros j Hj. destruct (Nat.eq_dec j i) as [->|Ne]; [rewrite Zm; lra|]. left. apply Pm; auto. }
  assert (Ic : In c (cells K)) by (apply (reach_cells _ _ _ R) with (y := m); auto).
  destruct (beside_others (c, i) z m Hf Iz Im (list_prod (cells K) I4)) as [e0 [He0 B0]].
  destruct (near_opn M' org z Nz') as [e1 [He1 B1]].
  (* around the middle *)
  assert (OM : open (fun y => (near M' org y /\ forall d, In d (cells K) -> d = c \/ ~ closed (piece d) y) /\ forall j, In j I4 -> j = i \/ 0 < coord (piece c) j y)).
  { apply opn_and; [apply opn_and; [apply near_opn|]|].
    - apply opn_all. intros d _. apply opn_or; [apply opn_const|apply not_closed_opn].
    - apply opn_all. intros j _. apply opn_or; [apply opn_const|]. apply aff_pos_opn, aff_o. }
  destruct (OM m) as [e2 [He2 B2]].
  { split; [split; auto|].
    - intros d Hd. destruct (cell_eq_dec d c) as [|Ne]; auto. right. apply (uncovered (c, i)); auto. apply (cells_valid _ _ _ _ Hd).
    - intros j Hj. destruct (Nat.eq_dec j i); auto. }
  clear OM. exists (Rmin e0 e1). split; [apply Rmin_glb_lt; auto|]. intros y Ny Oy.
  assert (Ny0 : near e0 z y) by (apply near_mono with (2 := Ny); apply Rmin_l).
  assert (Ny1 : near M' org y) by (apply B1, near_mono with (2 := Ny); apply Rmin_r).
  set (k := coord (piece c) i y). assert (Hk : k <> 0) by (apply (Oy (c, i)), in_prod; auto).
  assert (He : 0 < Rmin e0 e2) by (apply Rmin_glb_lt; auto).
  destruct (near_side (piece c) i m (Rmin e0 e2) k V0 Hi Zm He Hk) as [q0 [Nq0 Kq0]].
  destruct (gen_pair N T h lat Hvol K (fun x => likewise K M' y x /\ near e0 z x) (fun x => near (Rmin e0 e2) m x /\ 0 < k * coord (piece c) i x))
    as [p [q [[Lp Np] [[Nq Kq] G]]]].
  { apply opn_and; [apply likewise_open|apply near_opn]. }
  { apply opn_and; [apply near_opn|]. destruct (aff_o (facet (piece c) i)) as [a [b [c' [d' H]]]].
    apply aff_pos_opn. exists (k * a), (k * b), (k * c'), (k * d'). intros x. unfold coord. rewrite H. ring. }
  { exists y. split; auto. apply likewise_self; auto. }
  { exists q0. auto. }
  assert (Nqm : near e0 m q) by (apply near_mono with (2 := Nq); apply Rmin_l).
  destruct (B2 q) as [[Nq' Dq] Pq]; [apply near_mono with (2 := Nq); apply Rmin_r|].
  rewrite <- (like_count N T h lat (fun _ => True) K M' y p Lp).
  rewrite (steady K M' one p q); auto; [ |apply R|apply Lp|].
  2:{ intros g Cg. destruct (paired_dec g) as [|U]; [auto|exfalso].
      pose proof (crosses_boundary _ _ _ _ Cg U) as Bg. destruct (facet_dec g (c, i)) as [->|Ne].
      - pose proof (crosses_sides _ _ _ _ Cg) as O. pose proof (likewise_side _ _ _ _ c i Lp Ic Hi) as S. fold k in S. unfold face, coord in *; cbn [fst snd] in *.
        set (a := side (facet (piece c) i) p) in *. set (b := side (facet (piece c) i) q) in *.
        assert (0 < (k * a) * (k * b)) by (apply Rmult_lt_0_compat; auto). replace (k * a * (k * b)) with ((k * k) * (a * b)) in H by ring.
        assert (0 < k * k) by (destruct (Rlt_dec 0 k); nra). nra.
      - destruct (crosses_inner _ _ _ _ Cg) as [s [Hs Is]]. apply (B0 p q s g); auto; [lra| |apply inner_on; auto].
        destruct g as [d j]. destruct Cg as [Hd [Hj _]]. apply in_prod; auto. }
  rewrite cnt_one. rewrite (zsum_single _ _ c); [|apply cells_NoDup|auto|].
  - f_equal. transitivity (posb (coord (piece c) i q)).
    + apply beq_iff. rewrite interb_t, posb_t. split; [intros I; apply I; auto|]. intros P j Hj. destruct (Pq j Hj) as [->|]; auto.
    + apply posb_ext. fold k. split; nra.
  - intros d Hd Ne. destruct (Dq d Hd) as [|NC]; [tauto|]. destruct (insideb (piece d) q) eqn:E; auto. apply interb_t, inter_closed in E. tauto.
Qed.

(** ** 4. N is at most 1 *)
Lemma at_most_one f0 K M M' y : boundary f0 -> near M org (middle (face f0)) -> reach K M M' -> near M org y -> off_planes K y -> (count one K y <= 1)%Z.
Proof.
  intros Hf0 Nm R Ny Oy. destruct (Z_le_gt_dec (count one K y) 1) as [|GT]; auto. exfalso.
  set (m := middle (face f0)) in *. pose proof (middle_inner (face f0)) as Im. fold m in Im.
  destruct (beside_boundary K M M' f0 m R Hf0 Nm Im) as [e [He BB]].
  destruct f0 as [c0 i0]. pose proof Hf0 as [Vc [Hi U0]]. cbn [fst snd] in *. pose proof (piece_vol c0 Vc) as V0.
  apply facet_inner in Im as [Zm _]; auto. cbn [fst snd] in Zm.
  destruct (near_opn M org m Nm) as [e1 [He1 B1]].
  assert (He' : 0 < Rmin e e1) by (apply Rmin_glb_lt; auto).
  destruct (near_side (piece c0) i0 m (Rmin e e1) (-1) V0 Hi Zm He') as [q0 [Nq0 Kq0]]; [lra|].
  destruct (gen_pair N T h lat Hvol K (likewise K M y) (fun x => near (Rmin e e1) m x /\ coord (piece c0) i0 x < 0)) as [p [q [Lp [[Nq Kq] G]]]].
  { apply likewise_open. }
  { apply opn_and; [apply near_opn|]. apply aff_neg_opn, aff_o. }
  { exists y. apply likewise_self; auto. }
  { exists q0. split; auto. lra. }
  assert (Np : near M org p) by apply Lp.
  assert (Nq1 : near M org q) by (apply B1, near_mono with (2 := Nq); apply Rmin_r).
  assert (RGM : reaches K M) by (intros c x A B C; apply (reach_cells _ _ _ R) with (y := x); auto; apply near_mono with M; auto; apply R).
  assert (Cq : count one K q = 0%Z).
  { rewrite BB; [|apply near_mono with (2 := Nq); apply Rmin_l|apply (generic_off K p); auto]. replace (posb _) with false; auto. symmetry. apply posb_f. lra. }
  assert (Cp : count one K p = count one K y) by apply (like_count N T h lat (fun _ => True) K M y p Lp).
  destruct (first_exit K p q G) as [f [s [Cf [Uf [Hs [Is Be]]]]]].
  { destruct (existsb (fun f => negb (Z.eqb (crossing (face f) p q) 0) && match mate (fst (fst f)) (snd f) with None => true | _ => false end) (list_prod (cells K) I4)) eqn:E.
    - apply existsb_exists in E as [f [Hf E]]. apply andb_true_iff in E as [E1 E2]. apply negb_true_iff, Z.eqb_neq in E1. exists f. destruct f as [c i].
      apply in_prod_iff in Hf. split; [repeat split; tauto|]. unfold Degree.paired. destruct (mate _ _); [discriminate|]. congruence.
    - exfalso. assert (X : count one K p = count one K q); [|lia]. apply (steady K M); auto. intros g Cg. split; auto.
      destruct (paired_dec g) as [|U]; auto. exfalso. assert (F : existsb (fun f => negb (Z.eqb (crossing (face f) p q) 0) && match mate (fst (fst f)) (snd f) with None => true | _ => false end) (list_prod (cells K) I4) = true); [|congruence].
      apply existsb_exists. exists g. destruct Cg as [A [B C]]. destruct g as [c i]. split; [apply in_prod; auto|]. apply andb_true_iff. split; [apply negb_true_iff, Z.eqb_neq; auto|].
      unfold Degree.paired in U. destruct (mate _ _); auto. exfalso; apply U; congruence. }
  pose proof (crosses_boundary _ _ _ _ Cf Uf) as Bf.
  assert (Ns : near M org (lerp p q s)) by (apply near_convex; auto; lra).
  destruct (beside_boundary K M M' f (lerp p q s) R Bf Ns Is) as [e3 [He3 BB3]].
  destruct (Be e3 He3) as [u [Hu [Nu [Gu Cu]]]]. pose proof (BB3 _ Nu (generic_off K p _ Gu)) as X.
  assert (Y : count one K p = count one K (lerp p q u)).
  { apply (steady K M); auto; [apply near_convex; auto; lra|]. intros g Cg. split; auto. apply (Cu g Cg). }
  destruct (posb _) in X; cbn in X; lia.
Qed.

(** ** 5. Every generic point of the region is covered once *)
Definition covered (x : point) := exists c, valid c /\ inside (piece c) x.
Lemma covered_open : open covered.
Proof. intros x [c [V I]]. destruct (inter_opn _ x I) as [e [He K]]. exists e. split; auto. intros y Hy. exists c. auto. Qed.
Lemma off_planes_exists K (U : point -> Prop) : open U -> (exists x, U x) -> exists x, U x /\ off_planes K x.
Proof.
  intros O NE. destruct (gen_pair N T h lat Hvol K U U O O NE NE) as [p [q [_ [Uq G]]]]. exists q. split; auto. apply (generic_off K p); auto.
Qed.
Theorem region_once : covered_once N T h lat covered.
Proof.
  intros M x V Nx Vx OV VC. destruct bounded_somewhere as [f0 Hf0]. destruct (near_org_exists (middle (face f0))) as [M0 [_ Nm]].
  set (M1 := Rmax M M0). assert (L1 : M <= M1) by apply Rmax_l. assert (L0 : M0 <= M1) by apply Rmax_r.
  destruct (reach_exists M1) as [K [M' R]].
  destruct (off_planes_exists K (fun y => near M org y /\ V y)) as [q [[Nq Vq] Oq]]; [apply opn_and; auto; apply near_opn|exists x; auto|].
  assert (Nq1 : near M1 org q) by (apply near_mono with M; auto).
  exists K, q. split; auto. split; [|split; auto].
  - pose proof (at_most_one f0 K M1 M' q Hf0 (near_mono _ _ _ _ L0 Nm) R Nq1 Oq) as LE.
    destruct (VC q Vq) as [c [Hc I]].
    assert (Ic : In c (cells K)). { apply (reach_cells _ _ _ R) with (y := q); auto using inter_closed. apply near_mono with M1; auto; apply R. }
    assert (GE : (1 <= count one K q)%Z); [|lia]. rewrite cnt_one. clear LE.
    apply (zsum_b2z_ge1 (fun c => insideb (piece c) q) (cells K) c); auto. apply interb_t; auto.
  - intros c y Hc Ny C. apply (reach_cells _ _ _ R) with (y := y); auto. apply near_mono with M; auto. pose proof (reach_le _ _ _ R). lra.
Qed.
Lemma covered_inside c x : valid c -> inside (piece c) x -> covered x.
Proof. intros V I. exists c. auto. Qed.
Theorem region_disjoint x c c' : valid c -> valid c' -> inside (piece c) x -> closed (piece c') x -> c = c'.
Proof. apply (disjoint_closed N T h lat covered covered_inside Hvol region_once). Qed.
Lemma count_inside w K q c : In c (cells K) -> inside (piece c) q -> count w K q = w c.
Proof. apply (cnt_interior N T h lat covered covered_inside region_once). Qed.

(** ** 6. Face to face *)
Lemma carT_corner f x v : boundary f -> on (face f) x -> (carT (piece (fst f)) x v <-> carF (face f) x v).
Proof.
  intros Hf O. pose proof Hf as [V [I _]]. apply (face_on f x Hf) in O as [C Z]. pose proof (piece_vol _ V). split.
  - apply carT_carF; auto.
  - apply carF_carT; auto.
Qed.
(** Near x only facets that contain x. *)
Lemma facets_around K M x : near M org x -> exists e, 0 < e /\ forall y, near e x y -> near M org y /\
  forall f, In (fst f) (cells K) -> In (snd f) I4 -> on (face f) y -> on (face f) x.
Proof.
  intros Nx. set (G := fun y => near M org y /\ forall f, In f (list_prod (cells K) I4) -> on (face f) x \/ (~ closed (piece (fst f)) y \/ coord (piece (fst f)) (snd f) y <> 0)).
  assert (FO : forall f y, In f (list_prod (cells K) I4) -> (on (face f) y <-> closed (piece (fst f)) y /\ coord (piece (fst f)) (snd f) y = 0)).
  { intros [c i] y H. apply in_prod_iff in H as [Hc Hi]. apply facet_on; auto. apply piece_vol, (cells_valid _ _ _ _ Hc). }
  assert (OG : open G).
  { apply opn_and; [apply near_opn|]. apply opn_all. intros f _. apply opn_or; [apply opn_const|]. apply opn_or; [apply not_closed_opn|]. apply aff_nz_opn, aff_o. }
  destruct (OG x) as [e [He KG]].
  { split; auto. intros f Hf. rewrite FO by auto. destruct (closedb (piece (fst f)) x) eqn:C.
    - apply closedb_t in C. destruct (Req_EM_T (coord (piece (fst f)) (snd f) x) 0); auto.
    - right; left. rewrite <- closedb_t. congruence. }
  exists e. split; auto. intros y Hy. destruct (KG y Hy) as [Ny L]. split; auto. intros f A B O.
  assert (Hf : In f (list_prod (cells K) I4)) by (destruct f; apply in_prod; auto).
  destruct (L f Hf) as [|[Q|Q]]; auto; apply FO in O; tauto.
Qed.

Definition common_around x (w : cell -> Z) := forall f, valid (fst f) -> In (snd f) I4 -> paired f -> on (face f) x -> w (fst (across f)) = w (fst f).
(** From a tile at x along a segment near x: to the first boundary facet, if there is one. *)
Lemma follow_exit K M M' e x w c p q : reach K M M' -> common_around x w ->
  (forall y, near e x y -> near M org y /\ forall f, In (fst f) (cells K) -> In (snd f) I4 -> on (face f) y -> on (face f) x) ->
  near e x p -> near e x q -> In c (cells K) -> inside (piece c) p -> generic_in K p q -> (exists f, crosses K p q f /\ ~ paired f) ->
  exists f, boundary f /\ on (face f) x /\ w c = w (fst f).
Proof.
  intros R W A Np Nq Ic Ip G EX. destruct (first_exit K p q G EX) as [f [s [Cf [Uf [Hs [Is Be]]]]]].
  pose proof (crosses_boundary _ _ _ _ Cf Uf) as Bf. pose proof Bf as [Vf [If _]].
  assert (Nz : near e x (lerp p q s)) by (apply near_convex; auto; lra).
  destruct (A _ Nz) as [NM Az]. exists f. split; auto. split; [apply Az; try apply Cf; apply inner_on; auto|].
  destruct (beside_boundary K M M' f _ R Bf NM Is) as [e1 [He1 B1]].
  apply facet_inner in Is as [Z P]; auto; [|apply piece_vol; auto].
  assert (O : open (fun y => forall j, In j I4 -> j = snd f \/ 0 < coord (piece (fst f)) j y)).
  { apply opn_all. intros j _. apply opn_or; [apply opn_const|]. apply aff_pos_opn, aff_o. }
  destruct (O (lerp p q s)) as [e2 [He2 B2]]. { intros j Hj. destruct (Nat.eq_dec j (snd f)); auto. }
  destruct (Be (Rmin e1 e2)) as [u [Hu [Nu [Gu Cu]]]]; [apply Rmin_glb_lt; auto|].
  assert (RG : reaches K M) by (intros c' y X Y; apply (reach_cells _ _ _ R); auto; apply near_mono with M; auto; apply R).
  assert (Nup : near e x (lerp p q u)) by (apply near_convex; auto; lra).
  assert (S : forall w', common_around x w' -> count w' K p = count w' K (lerp p q u)).
  { intros w' W'. apply (steady K M); auto; try (apply A; auto). intros g Cg. destruct (Cu g Cg) as [_ Pg]. split; auto.
    destruct (crosses_inner _ _ _ _ Cg) as [s' [Hs' Ig]]. apply W'; auto; try apply Cg; [apply (cells_valid _ _ _ _ (proj1 Cg))|].
    destruct (A (lerp p (lerp p q u) s')) as [_ Q]; [apply near_convex; auto; lra|]. apply Q; try apply Cg. apply inner_on; auto. }
  assert (E : count one K p = count one K (lerp p q u)) by (apply S; intros g _ _ _ _; reflexivity).
  rewrite (count_inside one K p c Ic Ip) in E. rewrite B1 in E; [|apply near_mono with (2 := Nu); apply Rmin_l|apply (generic_off K p); auto].
  destruct (posb (coord (piece (fst f)) (snd f) (lerp p q u))) eqn:PB; [|discriminate]. apply posb_t in PB.
  assert (I : inside (piece (fst f)) (lerp p q u)).
  { assert (B : forall j, In j I4 -> j = snd f \/ 0 < coord (piece (fst f)) j (lerp p q u)).
    { apply B2, near_mono with (2 := Nu). apply Rmin_r. }
    intros j Hj. destruct (B j Hj) as [->|]; auto. }
  specialize (S w W). rewrite (count_inside w K p c Ic Ip) in S. rewrite S. apply count_inside; auto. apply Cf.
Qed.
(** Two tiles at x have the same weight, or each has that of the tile of a boundary facet at x. *)
Theorem follow x w c c' : common_around x w -> valid c -> valid c' -> closed (piece c) x -> closed (piece c') x -> w c = w c' \/
  exists f g, boundary f /\ boundary g /\ on (face f) x /\ on (face g) x /\ w c = w (fst f) /\ w c' = w (fst g).
Proof.
  intros W Hc Hc' C C'. destruct (near_org_exists x) as [M [_ Nx]]. destruct (reach_exists M) as [K [M' R]].
  destruct (facets_around K M x Nx) as [e [He A]].
  assert (RG : reaches K M) by (intros d y X Y; apply (reach_cells _ _ _ R); auto; apply near_mono with M; auto; apply R).
  assert (Ic : In c (cells K)) by (apply RG with (y := x); auto). assert (Ic' : In c' (cells K)) by (apply RG with (y := x); auto).
  destruct (gen_pair N T h lat Hvol K (fun y => near e x y /\ inside (piece c) y) (fun y => near e x y /\ inside (piece c') y))
    as [p [q [[Np Ip] [[Nq Iq] G]]]].
  { apply opn_and; [apply near_opn|apply inter_opn]. }
  { apply opn_and; [apply near_opn|apply inter_opn]. }
  { apply closed_limit; auto. apply piece_vol; auto. }
  { apply closed_limit; auto. apply piece_vol; auto. }
  destruct (Classical_Prop.classic (exists f, crosses K p q f /\ ~ paired f)) as [EX|NX].
  - right. destruct (follow_exit K M M' e x w c p q R W A Np Nq Ic Ip G EX) as [f [F1 [F2 F3]]].
    destruct (follow_exit K M M' e x w c' q p R W A Nq Np Ic' Iq (generic_in_swap _ _ _ G)) as [g [G1 [G2 G3]]].
    { destruct EX as [f0 [[X1 [X2 X3]] U]]. exists f0. split; auto. repeat split; auto. rewrite crossing_swap. lia. }
    exists f, g. tauto.
  - left. assert (E : count w K p = count w K q).
    { apply (steady K M); auto; try (apply A; auto). intros g Cg. destruct (paired_dec g) as [P|P]; [|exfalso; apply NX; eauto]. split; auto.
      destruct (crosses_inner _ _ _ _ Cg) as [s [Hs Ig]]. apply W; auto; try apply Cg; [apply (cells_valid _ _ _ _ (proj1 Cg))|].
      destruct (A (lerp p q s)) as [_ Q]; [apply near_convex; auto; lra|]. apply Q; try apply Cg. apply inner_on; auto. }
    rewrite (count_inside w K p c), (count_inside w K q c') in E by auto. exact E.
Qed.

(** Boundary facets meet in the hull of their common corners. *)
Lemma boundary_carrier f g x v : boundary f -> boundary g -> on (face f) x -> on (face g) x -> carF (face f) x v -> carF (face g) x v.
Proof.
  intros Hf Hg Of Og C. destruct (facet_dec f g) as [->|Ne]; auto. destruct (apart f g Hf Hg Ne) as [w S].
  apply carF_sub with (face f); auto. intros u Hu. apply (separates_carrier w (face f) (face g) x); auto.
Qed.
Theorem region_face_to_face x v c c' : valid c -> valid c' -> closed (piece c) x -> closed (piece c') x -> carT (piece c) x v -> carT (piece c') x v.
Proof.
  intros Hc Hc' C C' CAR.
  assert (K : forall d, valid d -> (Z.b2z (carb (piece d) x v) = 1%Z <-> carT (piece d) x v)).
  { intros d Hd. rewrite <- (carb_t _ x v (piece_vol d Hd)). destruct (carb (piece d) x v); simpl; split; congruence. }
  assert (W : common_around x (fun d => Z.b2z (carb (piece d) x v))).
  { intros [d i] Hd Hi PA O. cbn [fst snd] in *. apply facet_on in O as [Cx Lx]; auto; [|apply piece_vol; auto]. cbn [fst snd] in *.
    destruct (across_spec d i Hd Hi PA) as [S1 [S2 [S3 [S4 _]]]]. set (ci' := across (d, i)) in *.
    assert (Lx' : coord (piece (fst ci')) (snd ci') x = 0). { unfold coord in *. rewrite (oddm_o _ _ x S4) in Lx. lra. }
    pose proof (piece_vol d Hd) as V1. pose proof (piece_vol _ S1) as V2.
    assert (S4' : opposite (facet (piece (fst ci')) (snd ci')) (facet (piece d) i)). { clear - S4. unfold opposite in *. intuition congruence. }
    f_equal. apply beq_iff. rewrite !carb_t by auto. split; intros CC.
    + apply carF_carT with (i := i); auto. apply carF_odd with (f := facet (piece (fst ci')) (snd ci')); auto. apply carT_carF; auto.
    + apply carF_carT with (i := snd ci'); auto. apply carF_odd with (f := facet (piece d) i); auto. apply carT_carF; auto. }
  apply (K c Hc) in CAR. apply (K c' Hc').
  destruct (follow x _ c c' W Hc Hc' C C') as [E|[f [g [Bf [Bg [Of [Og [E E']]]]]]]]; cbv beta in *; [congruence|].
  rewrite E in CAR. rewrite E'. apply (K (fst f) (proj1 Bf)) in CAR. apply (K (fst g) (proj1 Bg)).
  apply carT_corner; auto. apply (boundary_carrier f g); auto. apply carT_corner; auto.
Qed.

(** ** 7. The topological boundary *)
Definition region x := exists c, valid c /\ closed (piece c) x.
Theorem region_boundary x : (exists f, boundary f /\ on (face f) x) <->
  ((forall e, 0 < e -> exists y, near e x y /\ region y) /\ (forall e, 0 < e -> exists y, near e x y /\ ~ region y)).
Proof.
  destruct (near_org_exists x) as [M [_ Nx]]. destruct (reach_exists M) as [K [M' R]].
  assert (RG : reaches K M) by (intros d y X Y; apply (reach_cells _ _ _ R); auto; apply near_mono with M; auto; apply R). split.
  - intros [f [Bf Of]]. pose proof Bf as [Vf [If _]]. split.
    + intros e He. exists x. split; [apply near_refl; auto|]. exists (fst f). split; auto. apply (face_on f x Bf); auto.
    + intros e He. destruct (near_opn M org x Nx) as [e0 [He0 B0]].
      (* an inner point of f near x, then a point outside near it *)
      assert (E1 : 0 < Rmin e e0) by (apply Rmin_glb_lt; auto).
      destruct (lerp_near (Rmin e e0) x (middle (face f)) E1) as [s [Hs Nz]]. set (z := lerp x (middle (face f)) s) in *.
      assert (Iz : inner (face f) z).
      { apply facet_inner; auto; [apply piece_vol; auto|]. pose proof (middle_inner (face f)) as Im. apply facet_inner in Im as [Zm Pm]; auto; [|apply piece_vol; auto].
        apply (face_on f x Bf) in Of as [Cx Zx]. unfold z, coord in *. rewrite o_lerp. split; [rewrite Zx, Zm; ring|].
        intros j Hj Ne. rewrite o_lerp. pose proof (Cx j Hj) as Q1. pose proof (Pm j Hj Ne) as Q2. unfold coord in Q1, Q2.
        assert (0 <= (1 - s) * side (facet (piece (fst f)) j) x) by (apply Rmult_le_pos; lra).
        assert (0 < s * side (facet (piece (fst f)) j) (middle (face f))) by (apply Rmult_lt_0_compat; lra). lra. }
      assert (Nz' : near M org z) by (apply B0, near_mono with (2 := Nz); apply Rmin_r).
      destruct (beside_boundary K M M' f z R Bf Nz' Iz) as [e1 [He1 B1]].
      destruct (near_opn (Rmin e e0) x z Nz) as [e2 [He2 B2]].
      assert (E3 : 0 < Rmin e1 e2) by (apply Rmin_glb_lt; auto).
      apply facet_inner in Iz as [Zz _]; auto; [|apply piece_vol; auto].
      destruct (near_side (piece (fst f)) (snd f) z (Rmin e1 e2) (-1) (piece_vol _ Vf) If Zz E3) as [y0 [Ny0 Ky0]]; [lra|].
      destruct (off_planes_exists K (fun y => near (Rmin e1 e2) z y /\ coord (piece (fst f)) (snd f) y < 0)) as [y [[Ny Ky] Oy]].
      { apply opn_and; [apply near_opn|]. apply aff_neg_opn, aff_o. }
      { exists y0. split; auto. lra. }
      assert (Nxy : near (Rmin e e0) x y) by (apply B2, near_mono with (2 := Ny); apply Rmin_r).
      exists y. split; [apply near_mono with (2 := Nxy); apply Rmin_l|]. intros [c [Hc Cc]].
      assert (Ic : In c (cells K)). { apply RG with (y := y); auto. apply B0, near_mono with (2 := Nxy); apply Rmin_r. }
      assert (I : inside (piece c) y).
      { intros i Hi. destruct (Rle_lt_or_eq_dec _ _ (Cc i Hi)) as [|E]; auto. exfalso. apply (Oy (c, i)); [apply in_prod; auto|auto]. }
      pose proof (B1 y) as X. rewrite (count_inside one K y c Ic I) in X.
      replace (posb _) with false in X by (symmetry; apply posb_f; lra). unfold one in X. cbn in X.
      assert (1 = 0)%Z; [|lia]. apply X; auto. apply near_mono with (2 := Ny); apply Rmin_l.
  - intros [CL CO]. destruct (Classical_Prop.classic (exists f, boundary f /\ on (face f) x)) as [|NB]; auto. exfalso.
    (* x is in a tile *)
    assert (CLOSED : forall y, near M org y -> (forall e, 0 < e -> exists z, near e y z /\ region z) -> exists c, In c (cells K) /\ closed (piece c) y).
    { intros y Ny CLy. destruct (existsb (fun c => closedb (piece c) y) (cells K)) eqn:E.
      - apply existsb_exists in E as [c [Hc E]]. apply closedb_t in E. eauto.
      - exfalso. assert (OV : open (fun z => near M org z /\ forall c, In c (cells K) -> ~ closed (piece c) z)).
        { apply opn_and; [apply near_opn|]. apply opn_all. intros c _. apply not_closed_opn. }
        destruct (OV y) as [e [He KV]].
        { split; auto. intros c Hc C. assert (existsb (fun c => closedb (piece c) y) (cells K) = true); [|congruence].
          apply existsb_exists. exists c. split; auto. apply closedb_t; auto. }
        destruct (CLy e He) as [z [Nz [c [Hc Cz]]]]. destruct (KV z Nz) as [Mz Vz]. apply (Vz c); auto. apply RG with (y := z); auto. }
    destruct (CLOSED x Nx CL) as [c [Hc Cx]]. pose proof (cells_valid _ _ _ _ Hc) as Vc.
    destruct (facets_around K M x Nx) as [e [He A]].
    destruct (CO e He) as [y [Ny Ry]]. apply Ry.
    destruct (CLOSED y) as [d [Hd Dy]]; [apply A; auto| |exists d; split; auto; apply (cells_valid _ _ _ _ Hd)].
    intros e' He'. destruct (closed_limit (piece c) x e (piece_vol c Vc) Cx He) as [z0 [Nz0 Iz0]].
    destruct (gen_pair N T h lat Hvol K (fun z => near e x z /\ inside (piece c) z) (fun z => near e x z /\ near e' y z)) as [p [q [[Np Ip] [[Nq Nq'] G]]]].
    { apply opn_and; [apply near_opn|apply inter_opn]. }
    { apply opn_and; apply near_opn. }
    { exists z0. auto. }
    { exists y. split; auto. apply near_refl; auto. }
    exists q. split; auto. assert (E : count one K p = count one K q).
    { apply (steady K M); auto; try (apply A; auto). intros g Cg. split; auto. destruct (paired_dec g) as [|P]; auto. exfalso. apply NB.
      exists g. split; [apply (crosses_boundary K p q); auto|]. destruct (crosses_inner _ _ _ _ Cg) as [s [Hs Ig]].
      destruct (A (lerp p q s)) as [_ Q]; [apply near_convex; auto; lra|]. apply Q; try apply Cg. apply inner_on; auto. }
    rewrite (count_inside one K p c Hc Ip), cnt_one in E.
    destruct (zsum_b2z_pos (fun c => insideb (piece c) q) (cells K)) as [d [Hd Id]]; [unfold one in E; lia|].
    apply interb_t, inter_closed in Id. exists d. split; auto. apply (cells_valid _ _ _ _ Hd).
Qed.

(** ** 8. Tiles with a common facet *)
(** Triangles with the same corners: opposite, or with the same sides. *)
Lemma same_corners F F' : t1 F <> t2 F -> t1 F <> t3 F -> t2 F <> t3 F -> (forall v, In v (corners F) -> In v (corners F')) ->
  middle F = middle F' /\ (opposite F F' \/ forall x, side F x = side F' x).
Proof.
  intros N12 N13 N23 H. pose proof (H (t1 F)) as H1. pose proof (H (t2 F)) as H2. pose proof (H (t3 F)) as H3.
  destruct F as [a b c], F' as [a' b' c']. unfold corners in *. cbn [t1 t2 t3] in *. unfold opposite. cbn [t1 t2 t3].
  destruct H1 as [E1|[E1|[E1|[]]]], H2 as [E2|[E2|[E2|[]]]], H3 as [E3|[E3|[E3|[]]]]; simpl; auto; subst; try congruence;
  (split; [unfold middle, combination3; cbn [t1 t2 t3]; apply point_eq; unf; ring|]); tauto || (right; intros x; unfold side; cbn [t1 t2 t3]; unf; ring).
Qed.
Lemma facet_distinct t i : 0 < vol t -> In i I4 -> let F := facet t i in t1 F <> t2 F /\ t1 F <> t3 F /\ t2 F <> t3 F.
Proof.
  intros V Hi F. pose proof (L_vx t i Hi) as L. fold F in L. unfold coord in L. fold F in L.
  repeat split; intros E; unfold side in L; rewrite E in L; unf; lra.
Qed.
(** Two tetrahedra on the same side of a common facet have common inner points. *)
Lemma overlap t i t' i' : 0 < vol t -> 0 < vol t' -> In i I4 -> In i' I4 -> middle (facet t i) = middle (facet t' i') ->
  (forall x, coord t i x = coord t' i' x) -> exists x, inside t x /\ inside t' x.
Proof.
  intros V V' Hi Hi' M S. pose proof (middle_inner (facet t i)) as I. pose proof (middle_inner (facet t' i')) as I'. rewrite <- M in I'.
  apply facet_inner in I as [Z P]; auto. apply facet_inner in I' as [_ P']; auto.
  assert (O : open (fun y => (forall j, In j I4 -> j = i \/ 0 < coord t j y) /\ forall j, In j I4 -> j = i' \/ 0 < coord t' j y)).
  { apply opn_and; apply opn_all; intros j _; (apply opn_or; [apply opn_const|apply aff_pos_opn, aff_o]). }
  destruct (O (middle (facet t i))) as [e [He K]].
  { split; intros j Hj; [destruct (Nat.eq_dec j i)|destruct (Nat.eq_dec j i')]; auto. }
  destruct (near_side t i (middle (facet t i)) e 1 V Hi Z He) as [y [Ny Ky]]; [lra|]. destruct (K y Ny) as [A B].
  exists y. split; intros j Hj; [destruct (A j Hj) as [->|]|destruct (B j Hj) as [->|]]; auto; [|rewrite <- S]; lra.
Qed.
Theorem neighbours c c' i i' : valid c -> valid c' -> In i I4 -> In i' I4 -> c <> c' ->
  (forall v, In v (corners (face (c, i))) -> In v (corners (face (c', i')))) -> paired (c, i) /\ fst (across (c, i)) = c'.
Proof.
  intros V V' Hi Hi' Ne H. pose proof (piece_vol c V) as P. pose proof (piece_vol c' V') as P'.
  destruct (facet_distinct (piece c) i P Hi) as [N12 [N13 N23]]. destruct (same_corners (facet (piece c) i) (facet (piece c') i') N12 N13 N23 H) as [M S].
  destruct (paired_dec (c, i)) as [PA|U].
  - split; auto. destruct (across_spec c i V Hi PA) as [S1 [S2 [_ [S4 _]]]]. set (m := across (c, i)) in *. destruct S as [S|S].
    + destruct (overlap (piece c') i' (piece (fst m)) (snd m)) as [x [I I']]; auto; [apply piece_vol; auto| | |].
      * rewrite <- M. pose proof S4 as Q.
        destruct (same_corners _ (facet (piece (fst m)) (snd m)) N12 N13 N23) as [MM _]; [|exact MM].
        intros v. unfold corners. unfold opposite in Q. simpl. intuition congruence.
      * intros x. unfold coord. pose proof (oddm_o _ _ x S) as X. pose proof (oddm_o _ _ x S4) as Y. lra.
      * symmetry. apply (region_disjoint x); auto. apply inter_closed; auto.
    + exfalso. apply Ne. destruct (overlap (piece c) i (piece c') i') as [x [I I']]; auto. apply (region_disjoint x); auto. apply inter_closed; auto.
  - exfalso. assert (B : boundary (c, i)) by (repeat split; auto; apply V). apply (uncovered (c, i) c' B V'); [cbn; congruence|].
    change (closed (piece c') (middle (facet (piece c) i))). rewrite M. pose proof (inner_on _ _ (middle_inner (facet (piece c') i'))) as O. apply facet_on in O; auto. apply O.
Qed.
End Region.
