(** * The volume sum as the covering condition

    Over a domain with a lattice of any rank: if all facets are paired or in the boundary,
    and the volumes of the tetrahedra T 0, ..., T (N-1) sum to no more than those of
    tetrahedra Q 0, ..., Q (m-1) that lie in the domain and have no inner points in
    common, modulo the lattice, then every generic point lies in exactly one tile.

    For the number of tiles is the same number c at all generic points (Degree.v), so that
    sum 1_T - c sum 1_Q, over all translates, is nowhere negative.  Integrated over
    one period of the lattice, sum vol T - c sum vol Q >= 0, that is c <= 1. *)
Require Import Reals Lra Psatz ZArith List Lia Bool Permutation.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Domain Integral Slices.
Import ListNotations.
Open Scope R_scope.

(** ** Characteristic functions and volumes

    If sum a_i 1_{T_i}, summed over all translates by multiples of h1, h2, h3 in the three
    directions, is nowhere negative in a box of one period, then sum a_i vol T_i >= 0.
    (With K = 0 and the period that of all tetrahedra a direction has no translates.) *)
Section Fold.
Variables (A : Type) (l : list A) (a : A -> R) (T : A -> tetrahedron) (M : R).
Variables (w1 w2 w3 h1 h2 h3 : R) (K1 K2 K3 : nat).
Hypothesis vol_pos : forall i, In i l -> 0 < vol (T i).
Hypothesis bounded : forall i v, In i l -> In v (verts (T i)) -> bnd M v.
Definition reaches w h K := 0 < h /\ w - h * IZR (Z.of_nat K) <= - M /\ M <= w + h + h * IZR (Z.of_nat K).
Hypothesis reach1 : reaches w1 h1 K1.
Hypothesis reach2 : reaches w2 h2 K2.
Hypothesis reach3 : reaches w3 h3 K3.

Definition character x y z := rsum (fun i => a i * b2r (insideb (T i) (Point x y z))) l.
Definition all_good x y z := forall i, In i l -> forall j, In j I4 -> good (Point x y z) (facet (T i) j).

Lemma volume_nonneg :
  ae3 (fun x y z => w1 < x < w1 + h1 -> w2 < y < w2 + h2 -> w3 < z < w3 + h3 ->
    0 <= rsum (fun n1 => rsum (fun n2 => rsum (fun n3 => character (x - h1 * IZR n1) (y - h2 * IZR n2) (z - h3 * IZR n3)) (zr K3)) (zr K2)) (zr K1)) ->
  0 <= rsum (fun i => a i * vol (T i)) l.
Proof.
  intros H. assert (G : ae3 all_good). { apply ae3_forall. intros i Hi. apply good_ae, vol_pos, Hi. }
  cut (0 <= rsum (fun i => a i * (vol (T i) / 6)) l).
  { intros P. rewrite (rsum_ext _ (fun i => a i * vol (T i) * / 6)) in P by (intros; unfold Rdiv; ring). rewrite rsum_mulr in P. lra. }
  destruct reach1 as [H1 [L1 R1]], reach2 as [H2 [L2 R2]], reach3 as [H3 [L3 R3]].
  (* along z *)
  apply (fold_nonneg M (fun z => rsum (fun i => a i * slice (T i) z) l) _ w3 h3 K3); auto.
  { apply (integral_sum M (fun i z => a i * slice (T i) z) (fun i => a i * (vol (T i) / 6))).
    intros i Hi. apply integral_scal, volume_integral; eauto. revert G. apply ae3_imp. intros x y z Gd. apply Gd; auto. }
  assert (GZ : ae (fun z => forall n, In n (zr K3) -> ae (fun y => ae (fun x => all_good x y (z - h3 * IZR n))))).
  { apply (ae_forall (fun n z => ae (fun y => ae (fun x => all_good x y (z - h3 * IZR n))))). intros n _. apply (ae_shift (fun z => ae (fun y => ae (fun x => all_good x y z)))), G. }
  apply ae_imp with (2 := ae_and _ _ H GZ). clear H G GZ. intros z [H G] Iz.
  (* along y *)
  apply (fold_nonneg M (fun y => rsum (fun n3 => rsum (fun i => a i * chord (T i) y (z - h3 * IZR n3)) l) (zr K3)) _ w2 h2 K2); auto.
  { apply (integral_sum M (fun n3 y => rsum (fun i => a i * chord (T i) y (z - h3 * IZR n3)) l) (fun n3 => rsum (fun i => a i * slice (T i) (z - h3 * IZR n3)) l)).
    intros n Hn. apply (integral_sum M (fun i y => a i * chord (T i) y (z - h3 * IZR n)) (fun i => a i * slice (T i) (z - h3 * IZR n))).
    intros i Hi. apply integral_scal, slice_integral; eauto. specialize (G n Hn). revert G. apply ae_imp. intros y. apply ae_imp. intros x Gd. apply Gd; auto. }
  assert (GY : ae (fun y => forall n3, In n3 (zr K3) -> forall n2, In n2 (zr K2) -> ae (fun x => all_good x (y - h2 * IZR n2) (z - h3 * IZR n3)))).
  { apply (ae_forall (fun n3 y => forall n2, In n2 (zr K2) -> ae (fun x => all_good x (y - h2 * IZR n2) (z - h3 * IZR n3)))). intros n3 I3'.
    apply (ae_forall (fun n2 y => ae (fun x => all_good x (y - h2 * IZR n2) (z - h3 * IZR n3)))). intros n2 _.
    apply (ae_shift (fun y => ae (fun x => all_good x y (z - h3 * IZR n3)))), (G n3 I3'). }
  apply ae_imp with (2 := ae_and _ _ H GY). clear H G GY. intros y [H G] Iy.
  (* along x *)
  apply (fold_nonneg M (fun x => rsum (fun n2 => rsum (fun n3 => character x (y - h2 * IZR n2) (z - h3 * IZR n3)) (zr K3)) (zr K2)) _ w1 h1 K1); auto.
  { apply (integral_sum M (fun n2 x => rsum (fun n3 => character x (y - h2 * IZR n2) (z - h3 * IZR n3)) (zr K3))
      (fun n2 => rsum (fun n3 => rsum (fun i => a i * chord (T i) (y - h2 * IZR n2) (z - h3 * IZR n3)) l) (zr K3))). intros n2 I2.
    apply (integral_sum M (fun n3 x => character x (y - h2 * IZR n2) (z - h3 * IZR n3))
      (fun n3 => rsum (fun i => a i * chord (T i) (y - h2 * IZR n2) (z - h3 * IZR n3)) l)). intros n3 I3'. unfold character.
    apply (integral_sum M (fun i x => a i * b2r (insideb (T i) (Point x (y - h2 * IZR n2) (z - h3 * IZR n3))))
      (fun i => a i * chord (T i) (y - h2 * IZR n2) (z - h3 * IZR n3))). intros i Hi.
    apply integral_scal, chord_integral; eauto. specialize (G n3 I3' n2 I2). revert G. apply ae_imp. intros x Gd. apply Gd; auto. }
  revert H. apply ae_imp. intros x P Ix. apply P; auto.
Qed.
End Fold.

(** ** Lattices of rank r in a box *)
Lemma rsum_swap {A B} (f : A -> B -> R) l l' : rsum (fun a => rsum (f a) l') l = rsum (fun b => rsum (fun a => f a b) l) l'.
Proof.
  induction l as [|a l IH]; cbn [rsum].
  - symmetry. apply rsum_zero. auto.
  - rewrite IH, <- rsum_add. auto.
Qed.
(** The directions of the lattice go to K, the others to 0. *)
Definition to_K (r i K : nat) := if (i <=? r)%nat then K else 0%nat.
Definition box (r K : nat) : list Z3 := list_prod (list_prod (zr (to_K r 1 K)) (zr (to_K r 2 K))) (zr (to_K r 3 K)).
Lemma cells_box N r K : Permutation (cells N (latb r) K) (list_prod (seq 0 N) (box r K)).
Proof.
  apply NoDup_Permutation.
  - apply cells_NoDup.
  - repeat apply NoDup_list_prod; auto using zr_NoDup, seq_NoDup.
  - intros [k [[x y] z]]. rewrite cells_In. unfold valid, box, cell. rewrite !in_prod_iff, !zr_In, in_seq, latb_iff. cbn [fst snd].
    unfold to_K. destruct r as [|[|[|r]]]; cbn [in_lattice Nat.leb]; lia.
Qed.
Lemma coord_translate u t i x : coord (translate u t) i x = coord t i (sub x u).
Proof. unfold coord, side. rewrite facet_translate. unfold translate_triangle; cbn [t1 t2 t3]. unf. ring. Qed.
Lemma inside_translate u t x : insideb (translate u t) x = insideb t (sub x u).
Proof. unfold insideb, I4. cbn [forallb]. rewrite !coord_translate. auto. Qed.
Lemma count_box N T h r K x : IZR (count N T h (latb r) one K x) =
  rsum (fun n => rsum (fun k => b2r (insideb (T k) (sub x (vec h n)))) (seq 0 N)) (box r K).
Proof.
  rewrite cnt_one, rsum_IZR, (rsum_perm _ _ _ (cells_box N r K)). unfold cell. rewrite rsum_prod, rsum_swap.
  apply rsum_ext. intros n _. apply rsum_ext. intros k _. unfold piece; cbn [fst snd]. rewrite inside_translate, b2r_b2z. auto.
Qed.

(** ** The theorem *)
Section Cover.
Variables (N : nat) (T : nat -> tetrahedron) (h : R) (r : nat) (Dom : point -> Prop).
Variable mate : nat -> nat -> option (nat * nat * Z3).
Notation lat := (latb r).
Hypothesis h_pos : 0 < h.
Hypothesis Dom_open : open Dom.
Hypothesis Dom_convex : forall p q s, Dom p -> Dom q -> 0 <= s <= 1 -> Dom (lerp p q s).
Hypothesis Dom_inside : forall c x, valid N lat c -> inside (piece T h c) x -> Dom x.
Hypothesis Hvol : forall k, (k < N)%nat -> 0 < vol (T k).
Hypothesis Hmate : forall k i, (k < N)%nat -> In i I4 ->
  match mate k i with
  | Some (k', i', d) =>
    (k' < N)%nat /\ In i' I4 /\ lat d = true /\ mate k' i' = Some (k, i, zopp3 d) /\
    opposite (facet (T k) i) (facet (translate (vec h d) (T k')) i')
  | None => forall n y, lat n = true -> Dom y -> 0 < coord (piece T h (k, n)) i y
  end.
(** Tetrahedra Q in the domain, without common inner points, modulo the lattice. *)
Variables (m : nat) (Q : nat -> tetrahedron).
Hypothesis Qvol : forall k, (k < m)%nat -> 0 < vol (Q k).
Hypothesis Qinside : forall c x, valid m lat c -> inside (piece Q h c) x -> Dom x.
Hypothesis Qapart : forall x c c', valid m lat c -> valid m lat c' -> inside (piece Q h c) x -> inside (piece Q h c') x -> c = c'.
Hypothesis N_pos : (0 < N)%nat.
Hypothesis Hsum : rsum (fun k => vol (T k)) (seq 0 N) <= rsum (fun k => vol (Q k)) (seq 0 m).

Lemma volume_positive : 0 < rsum (fun k => vol (T k)) (seq 0 N).
Proof.
  assert (P : forall n, (n <= N)%nat -> 0 <= rsum (fun k => vol (T k)) (seq 0 n)).
  { induction n as [|n IH]; intros Hn; [cbn; lra|]. rewrite seq_S, rsum_app. cbn [rsum Nat.add].
    assert (0 < vol (T n)) by (apply Hvol; lia). specialize (IH ltac:(lia)). lra. }
  destruct N as [|n] eqn:E; [lia|]. rewrite seq_S, rsum_app. cbn [rsum Nat.add].
  assert (0 < vol (T n)) by (apply Hvol; lia). specialize (P n ltac:(lia)). lra.
Qed.
(** The Q cover a point at most once. *)
Lemma count_Q K x c : In c (cells m lat K) -> inside (piece Q h c) x -> count m Q h lat one K x = 1%Z.
Proof.
  intros Hc I. rewrite cnt_one, (zsum_single _ _ c); [|apply cells_NoDup|auto|].
  - rewrite (proj2 (interb_t _ _) I). reflexivity.
  - intros c' Hc' Ne. destruct (insideb (piece Q h c') x) eqn:E; auto. exfalso. apply Ne. apply interb_t in E.
    apply (Qapart x); auto; eapply cells_valid; eauto.
Qed.

(** Facet planes are avoided by almost all points, and by points of every open set. *)
Lemma plane_proper K ci : In ci (list_prod (cells N lat K) I4) ->
  affine (coord (piece T h (fst ci)) (snd ci)) /\ exists z, coord (piece T h (fst ci)) (snd ci) z <> 0.
Proof.
  destruct ci as [c i]. intros H. apply in_prod_iff in H as [Hc Hi]. cbn [fst snd]. split; [apply aff_o|].
  assert (V : 0 < vol (piece T h c)) by (apply cellt_vol with (N := N); auto; eapply cells_N; eauto).
  exists (centroid (piece T h c)). pose proof (cen_inter _ V i Hi). lra.
Qed.
Lemma off_planes_ae K : ae3 (fun x y z => off_planes N T h lat K (Point x y z)).
Proof.
  apply (ae3_forall (fun ci x y z => coord (piece T h (fst ci)) (snd ci) (Point x y z) <> 0)). intros ci Hci.
  destruct (plane_proper K ci Hci) as [P1 P2]. apply (ae3_affine (coord (piece T h (fst ci)) (snd ci))); auto.
Qed.
Lemma off_planes_exist K (U : point -> Prop) : open U -> (exists x, U x) -> exists x, U x /\ off_planes N T h lat K x.
Proof.
  intros OU NU.
  destruct (generic (map (fun ci : Degree.cell * nat => coord (piece T h (fst ci)) (snd ci)) (list_prod (cells N lat K) I4)) U) as [x [Ux G]]; auto.
  - intros f Hf. apply in_map_iff in Hf as [ci [<- Hci]]. apply (plane_proper K ci Hci).
  - exists x. split; auto. intros ci Hci. apply (G (coord (piece T h (fst ci)) (snd ci))). apply in_map_iff. eauto.
Qed.

(** If all generic points of a large box are in c tiles, then c is at most 1. *)
Lemma at_most_one K B c : 0 < B -> B <= h * IZR (Z.of_nat K) ->
  (forall k v, (k < N)%nat -> In v (verts (T k)) -> bnd B v) -> (forall k v, (k < m)%nat -> In v (verts (Q k)) -> bnd B v) ->
  (forall p, near (h + B + 1) org p -> Dom p -> off_planes N T h lat K p -> count N T h lat one K p = c) ->
  (0 <= c)%Z -> (c <= 1)%Z.
Proof.
  intros B0 BK BT BQ HC C0.
  set (l := map inl (seq 0 N) ++ map inr (seq 0 m) : list (nat + nat)).
  set (a := fun i : nat + nat => if i then 1 else - IZR c).
  set (TQ := fun i : nat + nat => match i with inl k => T k | inr k => Q k end).
  set (per := fun i => (i <=? r)%nat).
  set (w := fun i => if per i then 0 else - B). set (g := fun i => if per i then h else 2 * B).
  assert (RE : forall i, reaches B (w i) (g i) (to_K r i K)).
  { intros i. unfold reaches, w, g, to_K, per. destruct (i <=? r)%nat; repeat split; try lra; cbn [Z.of_nat]; lra. }
  assert (IN : forall i, In i l -> match i with inl k => (k < N)%nat | inr k => (k < m)%nat end).
  { intros i Hi. unfold l in Hi. apply in_app_iff in Hi as [Hi|Hi]; apply in_map_iff in Hi as [k [<- Hk]]; apply in_seq in Hk; lia. }
  assert (P : 0 <= rsum (fun i => a i * vol (TQ i)) l).
  { apply (volume_nonneg (nat + nat) l a TQ B (w 1%nat) (w 2%nat) (w 3%nat) (g 1%nat) (g 2%nat) (g 3%nat) (to_K r 1 K) (to_K r 2 K) (to_K r 3 K)); auto.
    - intros i Hi. specialize (IN i Hi). destruct i; unfold TQ; auto.
    - intros i v Hi Hv. specialize (IN i Hi). destruct i; unfold TQ in Hv; eauto.
    - apply ae3_imp with (2 := off_planes_ae K). intros x y z OFF Ix Iy Iz. set (p := Point x y z) in *.
      assert (NP : near (h + B + 1) org p).
      { assert (W : forall i u, w i < u < w i + g i -> Rabs (u - 0) < h + B + 1).
        { intros i u. unfold w, g. destruct (per i); intros Hu; apply Rabs_def1; lra. }
        exact (conj (W 1%nat x Ix) (conj (W 2%nat y Iy) (W 3%nat z Iz))). }
      assert (E : rsum (fun n1 => rsum (fun n2 => rsum (fun n3 => character (nat + nat) l a TQ (x - g 1%nat * IZR n1) (y - g 2%nat * IZR n2) (z - g 3%nat * IZR n3))
          (zr (to_K r 3 K))) (zr (to_K r 2 K))) (zr (to_K r 1 K))
        = IZR (count N T h lat one K p) - IZR c * IZR (count m Q h lat one K p)).
      { rewrite !count_box, <- rsum_mull, <- rsum_sub. unfold box. rewrite !rsum_prod.
        apply rsum_ext. intros n1 I1. apply rsum_ext. intros n2 I2. apply rsum_ext. intros n3 I3'.
        assert (S : forall i n, In n (zr (to_K r i K)) -> g i * IZR n = h * IZR n).
        { intros i n. rewrite zr_In. unfold g, to_K, per. destruct (i <=? r)%nat; intros Hn; auto.
          replace n with 0%Z by lia. ring. }
        rewrite !S by auto. unfold character, l. rewrite rsum_app, !rsum_map. unfold a, TQ. rewrite !rsum_mull.
        replace (Point (x - h * IZR n1) (y - h * IZR n2) (z - h * IZR n3)) with (sub p (vec h (n1, n2, n3))) by reflexivity. ring. }
      rewrite E. clear E.
      destruct (Z.eq_dec (count m Q h lat one K p) 0) as [Z0|NZ].
      + rewrite Z0. rewrite Rmult_0_r, Rminus_0_r, cnt_one. apply IZR_le, zsum_b2z_nonneg.
      + assert (X : exists d, In d (cells m lat K) /\ inside (piece Q h d) p).
        { rewrite cnt_one in NZ. pose proof (zsum_b2z_nonneg (fun d => insideb (piece Q h d) p) (cells m lat K)) as NN.
          destruct (zsum_b2z_pos (fun d => insideb (piece Q h d) p) (cells m lat K)) as [d [Hd Id]]; [lia|].
          exists d. split; auto. apply interb_t; auto. }
        destruct X as [d [Hd Id]]. rewrite (count_Q K p d Hd Id), HC; auto; [lra|].
        apply (Qinside d); auto. eapply cells_valid; eauto. }
  unfold l in P. rewrite rsum_app, !rsum_map in P. unfold a, TQ in P. rewrite !rsum_mull in P.
  pose proof volume_positive as VP. set (v := rsum (fun k => vol (T k)) (seq 0 N)) in *. set (u := rsum (fun k => vol (Q k)) (seq 0 m)) in *.
  apply Znot_gt_le. intros C1. assert (C2 : (2 <= c)%Z) by lia. apply IZR_le in C2. nra.
Qed.

Theorem volume_covers_once : covered_once N T h lat Dom.
Proof.
  intros M x V Hx Vx OV VD.
  destruct (bnd_exists N T) as [MT [MT0 BT]]. destruct (bnd_exists m Q) as [MQ [MQ0 BQ]].
  set (p0 := centroid (T 0%nat)). destruct (near_org_exists p0) as [M1 [M10 N0]].
  assert (MP : 0 < M). { destruct Hx as [Hx _]. pose proof (Rabs_pos (px x - px org)). lra. }
  set (B := MT + MQ). set (R0 := M + M1 + (h + B + 1)). assert (B0 : 0 < B) by (unfold B; lra).
  destruct (range N T h lat h_pos Hvol R0) as [K1 RG].
  set (K := (K1 + Z.to_nat (up (B / h)))%nat).
  assert (RGK : forall c y, valid N lat c -> near R0 org y -> closed (piece T h c) y -> In c (cells N lat K)).
  { intros c y Hc Ny Cy. specialize (RG c y Hc Ny Cy). destruct c as [k [[u v] d]]. rewrite cells_In in *. unfold K. split; [apply RG|].
    destruct RG as [_ RG]. lia. }
  assert (BK : B <= h * IZR (Z.of_nat K)).
  { destruct (archimed (B / h)) as [A _]. assert (B / h * h = B) by (field; lra).
    assert (L : IZR (up (B / h)) <= IZR (Z.of_nat K)) by (apply IZR_le; unfold K; lia). nra. }
  assert (NM : forall y, near M org y -> near R0 org y) by (intros y; apply near_mono; unfold R0; lra).
  assert (E0 : piece T h (0%nat, z30) = T 0%nat) by (unfold piece; cbn [fst snd]; apply ttr0).
  assert (V0 : valid N lat (0%nat, z30)) by (split; [auto | apply latb_zero]).
  (* a generic point of V, one of the tile (0, 0) *)
  destruct (off_planes_exist K (fun y => near M org y /\ V y)) as [q [[Nq Vq] Oq]]; [apply opn_and; auto; apply near_opn | eauto|].
  destruct (off_planes_exist K (fun y => near M1 org y /\ inside (T 0%nat) y)) as [q0 [[Nq0 Iq0] Oq0]].
  { apply opn_and; [apply near_opn | apply inter_opn]. }
  { exists p0. split; auto. apply cen_inter, Hvol, N_pos. }
  assert (Nq0' : near R0 org q0) by (revert Nq0; apply near_mono; unfold R0; lra).
  rewrite <- E0 in Iq0.
  assert (C : forall p, near R0 org p -> Dom p -> off_planes N T h lat K p -> count N T h lat one K p = count N T h lat one K q0).
  { intros p Np Dp Op. apply (count_constant N T h lat Dom mate (latb_add r) Dom_open Dom_convex Hvol Hmate K R0); auto.
    apply (Dom_inside _ _ V0 Iq0). }
  assert (C1 : (1 <= count N T h lat one K q0)%Z).
  { rewrite cnt_one. apply zsum_b2z_ge1 with (x := (0%nat, z30)); [|apply interb_t; auto].
    apply RGK with (y := q0); auto. apply inter_closed; auto. }
  assert (C2 : (count N T h lat one K q0 <= 1)%Z).
  { apply (at_most_one K B); auto; [| | |lia].
    - intros k v Hk Hv. destruct (BT k Hk) as [Ba [Bb [Bc Bd]]].
      assert (X : bnd MT v) by (simpl in Hv; destruct Hv as [<-|[<-|[<-|[<-|[]]]]]; auto). unfold bnd, B in *. lra.
    - intros k v Hk Hv. destruct (BQ k Hk) as [Ba [Bb [Bc Bd]]].
      assert (X : bnd MQ v) by (simpl in Hv; destruct Hv as [<-|[<-|[<-|[<-|[]]]]]; auto). unfold bnd, B in *. lra.
    - intros p Np. apply C. revert Np. apply near_mono. unfold R0. lra. }
  exists K, q. split; auto. split; [|split; auto].
  - rewrite C; auto. lia.
  - intros c y Hc Ny. apply RGK; auto.
Qed.
End Cover.
