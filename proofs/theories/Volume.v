(** * The volume sum as the covering condition

    If all facets are paired and the volumes of T 0, ..., T (N-1) sum to that of the
    cell h^3, then every generic point lies in exactly one tile.  No measure theory:
    for one tetrahedron T and a generic point p the number of its translates that
    contain p is (1/6) det (integer parts of the vertices) plus a sum over its four
    facets of a term w that changes its sign with the orientation and does not change
    under lattice translations.  Summed over all T the facet terms cancel in pairs,
    twice over: once to pass from counting to integer parts, once to pass from
    integer parts to volumes. *)
Require Import Reals Lra Psatz ZArith List Lia Bool Permutation.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree.
Import ListNotations.
Open Scope R_scope.

(** ** Finite sums: shifts and counting *)
Definition b2r (b : bool) : R := if b then 1 else 0.
Lemma b2r_b2z b : IZR (Z.b2z b) = b2r b.
Proof. destruct b; reflexivity. Qed.

Lemma rsum_mulr {A} (f : A -> R) c l : rsum (fun x => f x * c) l = rsum f l * c.
Proof. induction l; simpl; lra. Qed.
Lemma rsum_opp {A} (f : A -> R) l : rsum (fun x => - f x) l = - rsum f l.
Proof. induction l; simpl; lra. Qed.

Definition nzb (x : R) : bool := if Req_EM_T x 0 then false else true.
(** A sum over a box that contains the support of f does not see a shift of f. *)
Lemma rsum_shift {A} (f : A -> R) (s t : A -> A) l :
  NoDup l -> (forall x, s (t x) = x) -> (forall x, t (s x) = x) ->
  (forall x, f x <> 0 -> In x l /\ In (t x) l) -> rsum (fun x => f (s x)) l = rsum f l.
Proof.
  intros ND ST TS H. rewrite <- (rsum_map s f).
  rewrite (rsum_filter f (fun x => nzb (f x)) (map s l)), (rsum_filter f (fun x => nzb (f x)) l);
  try (intros x _; unfold nzb; destruct (Req_EM_T (f x) 0); [auto|discriminate]).
  apply rsum_perm, NoDup_Permutation.
  - apply NoDup_filter, NoDup_map_inj_on; auto. intros x y _ _ E. rewrite <- (TS x), <- (TS y), E. auto.
  - apply NoDup_filter; auto.
  - intros x. rewrite !filter_In, in_map_iff. unfold nzb. destruct (Req_EM_T (f x) 0) as [Z|Z]; [intuition discriminate|].
    destruct (H x Z) as [H1 H2]. intuition eauto.
Qed.

Lemma count_zero a m : (a <= 1 - Z.of_nat m)%Z -> rsum (fun j => b2r (0 <? a + Z.of_nat j)%Z) (seq 0 m) = 0.
Proof.
  intros H. apply rsum_zero. intros j Hj. apply in_seq in Hj. destruct (Z.ltb_spec 0 (a + Z.of_nat j)); [lia|reflexivity].
Qed.
Lemma count_seq m : forall a, (1 - Z.of_nat m <= a <= 1)%Z ->
  rsum (fun j => b2r (0 <? a + Z.of_nat j)%Z) (seq 0 m) = IZR (Z.of_nat m - 1 + a).
Proof.
  induction m as [|m IH]; intros a Ha.
  - simpl. replace a with 1%Z by lia. reflexivity.
  - rewrite seq_S, rsum_app. cbn [rsum Nat.add].
    destruct (Z.eq_dec a (- Z.of_nat m)) as [->|Ne].
    + rewrite count_zero by lia. replace (- Z.of_nat m + Z.of_nat m)%Z with 0%Z by lia. change (b2r (0 <? 0)%Z) with 0.
      replace (Z.of_nat (S m) - 1 + - Z.of_nat m)%Z with 0%Z by lia. lra.
    + rewrite IH by lia. destruct (Z.ltb_spec 0 (a + Z.of_nat m)); [|lia]. cbn [b2r].
      replace (Z.of_nat (S m) - 1 + a)%Z with (Z.of_nat m - 1 + a + 1)%Z by lia. rewrite (plus_IZR (Z.of_nat m - 1 + a) 1). lra.
Qed.
Lemma count_above K a : (Z.abs a <= Z.of_nat K)%Z -> rsum (fun n => b2r (0 <? a + n)%Z) (zr K) = IZR (a + Z.of_nat K).
Proof.
  intros H. unfold zr. rewrite rsum_map.
  rewrite (rsum_ext _ (fun j => b2r (0 <? (a - Z.of_nat K) + Z.of_nat j)%Z)) by (intros; do 2 f_equal; lia).
  rewrite count_seq by lia. f_equal. lia.
Qed.

(** ** One generic point, one tetrahedron *)
Definition above (s x : R) : R := b2r (posb (x - s)).

Section Point.
Variables (h : R) (p : point).
Hypothesis h_pos : 0 < h.

(** Twice the area of p a b, projected along the first axis. *)
Definition D2 (a b : point) : R := (py a - py p) * (pz b - pz p) - (pz a - pz p) * (py b - py p).
(** The projected triangle contains p (signed); the ray from p along the first axis
    meets the triangle; the ray along the second axis meets a projected edge. *)
Definition sigma f : R :=
  b2r (posb (D2 (t1 f) (t2 f)) && posb (D2 (t2 f) (t3 f)) && posb (D2 (t3 f) (t1 f)))
  - b2r (posb (- D2 (t1 f) (t2 f)) && posb (- D2 (t2 f) (t3 f)) && posb (- D2 (t3 f) (t1 f))).
Definition cross f : R :=
  b2r (posb (- side f p) && (posb (D2 (t1 f) (t2 f)) && posb (D2 (t2 f) (t3 f)) && posb (D2 (t3 f) (t1 f))))
  - b2r (posb (side f p) && (posb (- D2 (t1 f) (t2 f)) && posb (- D2 (t2 f) (t3 f)) && posb (- D2 (t3 f) (t1 f)))).
Definition rho a b : R :=
  b2r (posb (pz b - pz p) && negb (posb (pz a - pz p)) && posb (D2 a b))
  - b2r (posb (pz a - pz p) && negb (posb (pz b - pz p)) && posb (- D2 a b)).
Definition tau a b : R := above (pz p) (pz b) - above (pz p) (pz a).

(** General position of p. *)
Definition off_axis v := px v <> px p /\ py v <> py p /\ pz v <> pz p.
Definition good_edge a b := D2 a b <> 0 \/ (py a = py b /\ pz a = pz b).
Definition good f := off_axis (t1 f) /\ off_axis (t2 f) /\ off_axis (t3 f) /\ side f p <> 0 /\
  good_edge (t1 f) (t2 f) /\ good_edge (t2 f) (t3 f) /\ good_edge (t3 f) (t1 f).

Definition area f : R := D2 (t1 f) (t2 f) + D2 (t2 f) (t3 f) + D2 (t3 f) (t1 f).
Definition far (R0 : R) := Point (px p + R0) (py p) (pz p).
Lemma side_far f R0 : side f (far R0) = side f p + R0 * area f.
Proof. unfold area, D2, far, side. unf. ring. Qed.
Lemma orient_far a b R0 : orient p (far R0) a b = R0 * D2 a b.
Proof. unfold D2, far. unf. ring. Qed.

Lemma far_sign s a : exists R0, 0 < R0 /\ forall r, R0 <= r -> (0 < a -> 0 < s + r * a) /\ (a < 0 -> s + r * a < 0).
Proof.
  destruct (Req_EM_T a 0) as [->|N].
  - exists 1. split; [lra|]. intros; split; lra.
  - exists (Rabs s / Rabs a + 1). pose proof (Rabs_pos s). pose proof (Rabs_pos_lt a N).
    assert (Q : 0 <= Rabs s / Rabs a). { apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat; auto. }
    split; [lra|]. intros r Hr.
    assert (Rabs s < r * Rabs a).
    { assert (X : Rabs s / Rabs a * Rabs a = Rabs s) by (field; lra). nra. }
    pose proof (Rle_abs s). pose proof (Rle_abs (- s)). rewrite Rabs_Ropp in *.
    split; intros A; [rewrite (Rabs_right a) in * by lra | rewrite (Rabs_left a) in * by lra]; lra.
Qed.

(** The ray: p is inside of t as often as the ray leaves minus as it enters. *)
Lemma ray t : 0 < vol t -> (forall i, In i I4 -> good (facet t i)) ->
  b2r (insideb t p) = - rsum (fun i => cross (facet t i)) I4.
Proof.
  intros V G.
  set (A := fun i => area (facet t i)).
  destruct (far_sign (coord t 0 p) (A 0%nat)) as [R0 [P0 F0]]. destruct (far_sign (coord t 1 p) (A 1%nat)) as [R1 [P1 F1]].
  destruct (far_sign (coord t 2 p) (A 2%nat)) as [R2 [P2 F2]]. destruct (far_sign (coord t 3 p) (A 3%nat)) as [R3 [P3 F3]].
  set (r := R0 + R1 + R2 + R3). set (q := far r).
  assert (Pr : 0 < r) by (unfold r; lra).
  assert (Q : forall i, In i I4 -> coord t i q = coord t i p + r * A i) by (intros; apply side_far).
  assert (F : forall i, In i I4 -> (0 < A i -> 0 < coord t i q) /\ (A i < 0 -> coord t i q < 0)).
  { intros i Hi. rewrite Q by auto. simpl in Hi. destruct Hi as [<-|[<-|[<-|[<-|[]]]]];
    [apply F0 | apply F1 | apply F2 | apply F3]; unfold r; lra. }
  assert (NP : forall i, In i I4 -> coord t i p <> 0) by (intros i Hi; destruct (G i Hi) as [_ [_ [_ [S _]]]]; exact S).
  assert (NQ : forall i, In i I4 -> coord t i q <> 0).
  { intros i Hi. destruct (F i Hi) as [F1' F2']. destruct (Rtotal_order (A i) 0) as [L|[L|L]].
    - specialize (F2' L). lra.
    - rewrite Q, L by auto. specialize (NP i Hi). lra.
    - specialize (F1' L). lra. }
  assert (OUT : insideb t q = false).
  { destruct (insideb t q) eqn:E; auto. exfalso. apply interb_t in E.
    assert (NN : forall i, In i I4 -> 0 <= A i).
    { intros i Hi. apply Rnot_lt_le. intros L. destruct (F i Hi) as [_ F2']. specialize (E i Hi). specialize (F2' L). lra. }
    pose proof (NN 0%nat ltac:(simpl; auto)) as N0. pose proof (NN 1%nat ltac:(simpl; auto)) as N1.
    pose proof (NN 2%nat ltac:(simpl; auto)) as N2. pose proof (NN 3%nat ltac:(simpl; auto)) as N3.
    pose proof (L_sum t p) as S1. pose proof (L_sum t q) as S2. rewrite !Q in S2 by (simpl; auto).
    assert (SA : r * (A 0%nat + A 1%nat + A 2%nat + A 3%nat) = 0) by lra.
    apply Rmult_integral in SA. destruct SA as [SA|SA]; [lra|].
    pose proof (f_equal px (L_bary t q)) as B. pose proof (f_equal px (L_bary t p)) as B'.
    unfold scale, add in B, B'; cbn [px] in B, B'. rewrite !Q in B by (simpl; auto).
    replace (A 0%nat) with 0 in B by lra. replace (A 1%nat) with 0 in B by lra. replace (A 2%nat) with 0 in B by lra. replace (A 3%nat) with 0 in B by lra.
    unfold q, far in B; cbn [px] in B. assert (vol t * r = 0) by lra. apply Rmult_integral in H. destruct H; lra. }
  assert (WG : weakly_generic_for t p q).
  { split; auto. intros i Hi. destruct (G i Hi) as [_ [_ [_ [_ [E1 [E2 E3]]]]]].
    assert (FLAT : A i = 0 -> 0 < coord t i p * coord t i q).
    { intros Z. rewrite Q, Z by auto. pose proof (NP i Hi). nra. }
    unfold A, area in FLAT. unfold generic_edge, q. rewrite !orient_far.
    assert (NZ : forall x, x <> 0 -> r * x <> 0) by (intros; apply Rmult_integral_contrapositive_currified; lra).
    destruct E1 as [E1|[Ey Ez]]; [|right; apply FLAT; unfold D2; rewrite Ey, Ez; ring].
    destruct E2 as [E2|[Ey Ez]]; [|right; apply FLAT; unfold D2; rewrite Ey, Ez; ring].
    destruct E3 as [E3|[Ey Ez]]; [|right; apply FLAT; unfold D2; rewrite Ey, Ez; ring].
    left. auto. }
  pose proof (tet_crossing_weak t p q V WG) as H. rewrite OUT in H. cbn [Z.b2z] in H.
  apply (f_equal IZR) in H. rewrite minus_IZR, rsum_IZR, b2r_b2z in H.
  rewrite (rsum_ext _ (fun i => IZR (crossing (facet t i) p q))); [lra|].
  intros i Hi. unfold crossing, cross. rewrite minus_IZR, !b2r_b2z.
  destruct (F i Hi) as [F1' F2']. unfold A, area, coord in F1', F2'.
  apply f_equal2; apply f_equal; apply beq_iff; unfold crp, crm; unfold q in *; rewrite !orient_far; bsimp.
  - split.
    + intros [X [[Y1 Y2] Y3]]. repeat split; auto; try (apply Rmult_lt_0_compat; auto). apply F1'. lra.
    + intros [[[[X _] Y1] Y2] Y3]. repeat split; auto; nra.
  - split.
    + intros [X [[Y1 Y2] Y3]]. repeat split; auto; nra.
    + intros [[[[X _] Y1] Y2] Y3]. repeat split; auto; nra.
Qed.

(** The same one dimension lower. *)
Lemma sigma_rho f : good f -> sigma f = rho (t1 f) (t2 f) + rho (t2 f) (t3 f) + rho (t3 f) (t1 f).
Proof.
  intros [[_ [_ Z1]] [[_ [_ Z2]] [[_ [_ Z3]] [_ [E1 [E2 E3]]]]]]. unfold good_edge in *.
  assert (I : (pz (t1 f) - pz p) * D2 (t2 f) (t3 f) + (pz (t2 f) - pz p) * D2 (t3 f) (t1 f) + (pz (t3 f) - pz p) * D2 (t1 f) (t2 f) = 0) by (unfold D2; ring).
  assert (S1 : D2 (t1 f) (t2 f) = 0 -> pz (t1 f) = pz (t2 f) /\ D2 (t2 f) (t3 f) = - D2 (t3 f) (t1 f)).
  { intros Z. destruct E1 as [E|[Ey Ez]]; [contradiction|]. split; auto. unfold D2. rewrite Ey, Ez. ring. }
  assert (S2 : D2 (t2 f) (t3 f) = 0 -> pz (t2 f) = pz (t3 f) /\ D2 (t3 f) (t1 f) = - D2 (t1 f) (t2 f)).
  { intros Z. destruct E2 as [E|[Ey Ez]]; [contradiction|]. split; auto. unfold D2. rewrite Ey, Ez. ring. }
  assert (S3 : D2 (t3 f) (t1 f) = 0 -> pz (t3 f) = pz (t1 f) /\ D2 (t1 f) (t2 f) = - D2 (t2 f) (t3 f)).
  { intros Z. destruct E3 as [E|[Ey Ez]]; [contradiction|]. split; auto. unfold D2. rewrite Ey, Ez. ring. }
  unfold sigma, rho. clear E1 E2 E3.
  set (a := pz (t1 f)) in *. set (b := pz (t2 f)) in *. set (c := pz (t3 f)) in *. set (s := pz p) in *.
  set (d1 := D2 (t1 f) (t2 f)) in *. set (d2 := D2 (t2 f) (t3 f)) in *. set (d3 := D2 (t3 f) (t1 f)) in *.
  clearbody a b c s d1 d2 d3. unfold posb.
  destruct (Rlt_dec 0 (a - s)); destruct (Rlt_dec 0 (s - a)); try (exfalso; lra);
  destruct (Rlt_dec 0 (b - s)); destruct (Rlt_dec 0 (s - b)); try (exfalso; lra);
  destruct (Rlt_dec 0 (c - s)); destruct (Rlt_dec 0 (s - c)); try (exfalso; lra);
  destruct (Rlt_dec 0 d1); destruct (Rlt_dec 0 (- d1)); try (exfalso; lra);
  destruct (Rlt_dec 0 d2); destruct (Rlt_dec 0 (- d2)); try (exfalso; lra);
  destruct (Rlt_dec 0 d3); destruct (Rlt_dec 0 (- d3)); try (exfalso; lra);
  cbn [andb negb b2r]; try lra; exfalso; try nra.
  all: try (assert (d1 = 0) as ZZ by lra; destruct (S1 ZZ); lra).
  all: try (assert (d2 = 0) as ZZ by lra; destruct (S2 ZZ); lra).
  all: try (assert (d3 = 0) as ZZ by lra; destruct (S3 ZZ); lra).
Qed.

(** ** What is left over has bounded support *)
Definition c2 a b : R := rho a b - tau a b * ((above (py p) (py a) + above (py p) (py b)) / 2).
Definition c1 f : R := cross f - sigma f * ((above (px p) (px (t1 f)) + above (px p) (px (t2 f)) + above (px p) (px (t3 f))) / 3).

Definition same (s x y : R) := (s < x /\ s < y) \/ (x <= s /\ y <= s).
Definition same3 (s x y z : R) := (s < x /\ s < y /\ s < z) \/ (x <= s /\ y <= s /\ z <= s).

Lemma above_1 s x : s < x -> above s x = 1.
Proof. intros H. unfold above, posb. destruct (Rlt_dec 0 (x - s)); [reflexivity|lra]. Qed.
Lemma above_0 s x : x <= s -> above s x = 0.
Proof. intros H. unfold above, posb. destruct (Rlt_dec 0 (x - s)); [lra|reflexivity]. Qed.

Lemma c2_z a b : same (pz p) (pz a) (pz b) -> c2 a b = 0.
Proof.
  intros H. unfold c2, tau, rho, posb. destruct H as [[H1 H2]|[H1 H2]]; [rewrite !above_1 by auto | rewrite (above_0 (pz p) (pz a)), (above_0 (pz p) (pz b)) by auto];
  destruct (Rlt_dec 0 (pz b - pz p)); destruct (Rlt_dec 0 (pz a - pz p)); try (exfalso; lra); cbn [andb negb b2r]; lra.
Qed.
Lemma c2_y a b : same (py p) (py a) (py b) -> c2 a b = 0.
Proof.
  intros H. unfold c2, tau, rho, above at 1 2, posb.
  assert (E : D2 a b = (py a - py p) * (pz b - pz p) - (pz a - pz p) * (py b - py p)) by reflexivity.
  set (d := D2 a b) in *. clearbody d.
  destruct H as [[H1 H2]|[H1 H2]]; [rewrite !above_1 by auto | rewrite !above_0 by auto];
  destruct (Rlt_dec 0 (pz b - pz p)); destruct (Rlt_dec 0 (pz a - pz p));
  destruct (Rlt_dec 0 d); destruct (Rlt_dec 0 (- d)); cbn [andb negb b2r]; try lra; exfalso; nra.
Qed.

(** Three numbers of one sign and three positive weights cannot cancel. *)
Lemma no_balance u1 u2 u3 d1 d2 d3 : (0 < u1 /\ 0 < u2 /\ 0 < u3) \/ (u1 <= 0 /\ u2 <= 0 /\ u3 <= 0) ->
  u1 * d2 + u2 * d3 + u3 * d1 = 0 -> (u1 = 0 -> u2 = 0 -> d1 = 0) -> 0 < d1 -> 0 < d2 -> 0 < d3 -> False.
Proof.
  intros [[H1 [H2 H3]]|[H1 [H2 H3]]] E Z P1 P2 P3.
  - assert (0 < u1 * d2) by (apply Rmult_lt_0_compat; auto). assert (0 < u2 * d3) by (apply Rmult_lt_0_compat; auto).
    assert (0 < u3 * d1) by (apply Rmult_lt_0_compat; auto). lra.
  - assert (0 <= (- u1) * d2) by (apply Rmult_le_pos; lra). assert (0 <= (- u2) * d3) by (apply Rmult_le_pos; lra).
    assert (0 <= (- u3) * d1) by (apply Rmult_le_pos; lra).
    assert (U1 : u1 * d2 = 0) by lra. assert (U2 : u2 * d3 = 0) by lra.
    apply Rmult_integral in U1, U2. destruct U1 as [U1|U1]; [|lra]. destruct U2 as [U2|U2]; [|lra]. specialize (Z U1 U2). lra.
Qed.
Lemma all_pos a b c : posb a && posb b && posb c = true <-> 0 < a /\ 0 < b /\ 0 < c.
Proof. rewrite !andb_true_iff, !posb_t. tauto. Qed.
Lemma same3_signs s x y z : same3 s x y z -> (0 < x - s /\ 0 < y - s /\ 0 < z - s) \/ (x - s <= 0 /\ y - s <= 0 /\ z - s <= 0).
Proof. intros [H|H]; [left|right]; lra. Qed.

Lemma outside_shadow f : same3 (py p) (py (t1 f)) (py (t2 f)) (py (t3 f)) \/ same3 (pz p) (pz (t1 f)) (pz (t2 f)) (pz (t3 f)) ->
  posb (D2 (t1 f) (t2 f)) && posb (D2 (t2 f) (t3 f)) && posb (D2 (t3 f) (t1 f)) = false /\
  posb (- D2 (t1 f) (t2 f)) && posb (- D2 (t2 f) (t3 f)) && posb (- D2 (t3 f) (t1 f)) = false.
Proof.
  intros H. split; apply bfalse; rewrite all_pos; intros [P1 [P2 P3]]; destruct H as [H|H]; apply same3_signs in H; revert P1 P2 P3.
  - apply (no_balance _ _ _ _ _ _ H); unfold D2; [ring|]. intros -> ->. ring.
  - apply (no_balance _ _ _ _ _ _ H); unfold D2; [ring|]. intros -> ->. ring.
  - apply (no_balance _ _ _ _ _ _ H); unfold D2; [ring|]. intros -> ->. ring.
  - apply (no_balance _ _ _ _ _ _ H); unfold D2; [ring|]. intros -> ->. ring.
Qed.
Lemma c1_yz f : same3 (py p) (py (t1 f)) (py (t2 f)) (py (t3 f)) \/ same3 (pz p) (pz (t1 f)) (pz (t2 f)) (pz (t3 f)) -> c1 f = 0.
Proof.
  intros H. destruct (outside_shadow f H) as [H1 H2]. unfold c1, cross, sigma. rewrite H1, H2, !andb_false_r. cbn [b2r]. lra.
Qed.
Lemma side_D2 f : side f p = - ((px (t1 f) - px p) * D2 (t2 f) (t3 f) + (px (t2 f) - px p) * D2 (t3 f) (t1 f) + (px (t3 f) - px p) * D2 (t1 f) (t2 f)).
Proof. unfold side, D2. unf. ring. Qed.
Lemma c1_x f : same3 (px p) (px (t1 f)) (px (t2 f)) (px (t3 f)) -> c1 f = 0.
Proof.
  intros H. unfold c1, cross, sigma. pose proof (side_D2 f) as S.
  set (d1 := D2 (t1 f) (t2 f)) in *. set (d2 := D2 (t2 f) (t3 f)) in *. set (d3 := D2 (t3 f) (t1 f)) in *.
  set (P := posb d1 && posb d2 && posb d3). set (M := posb (- d1) && posb (- d2) && posb (- d3)).
  assert (HP : P = true -> 0 < d1 /\ 0 < d2 /\ 0 < d3) by (apply all_pos).
  assert (HM : M = true -> 0 < - d1 /\ 0 < - d2 /\ 0 < - d3) by (apply all_pos).
  clearbody P M d1 d2 d3.
  set (x := px (t1 f) - px p) in *. set (y := px (t2 f) - px p) in *. set (z := px (t3 f) - px p) in *.
  assert (SG : (P = true -> posb (- side f p) = posb x) /\ (M = true -> posb (side f p) = posb x)).
  { apply same3_signs in H. fold x y z in H. unfold posb.
    split; intros E; [destruct (HP E) as [A [B C]] | destruct (HM E) as [A [B C]]];
    destruct H as [[X [Y Z]]|[X [Y Z]]].
    - assert (0 < x * d2) by (apply Rmult_lt_0_compat; auto). assert (0 < y * d3) by (apply Rmult_lt_0_compat; auto). assert (0 < z * d1) by (apply Rmult_lt_0_compat; auto).
      destruct (Rlt_dec 0 (- side f p)), (Rlt_dec 0 x); auto; lra.
    - assert (0 <= (- x) * d2) by (apply Rmult_le_pos; lra). assert (0 <= (- y) * d3) by (apply Rmult_le_pos; lra). assert (0 <= (- z) * d1) by (apply Rmult_le_pos; lra).
      destruct (Rlt_dec 0 (- side f p)), (Rlt_dec 0 x); auto; lra.
    - assert (0 < x * - d2) by (apply Rmult_lt_0_compat; auto). assert (0 < y * - d3) by (apply Rmult_lt_0_compat; auto). assert (0 < z * - d1) by (apply Rmult_lt_0_compat; auto).
      destruct (Rlt_dec 0 (side f p)), (Rlt_dec 0 x); auto; lra.
    - assert (0 <= (- x) * - d2) by (apply Rmult_le_pos; lra). assert (0 <= (- y) * - d3) by (apply Rmult_le_pos; lra). assert (0 <= (- z) * - d1) by (apply Rmult_le_pos; lra).
      destruct (Rlt_dec 0 (side f p)), (Rlt_dec 0 x); auto; lra. }
  destruct SG as [SP SM].
  assert (AB : above (px p) (px (t1 f)) = b2r (posb x) /\ above (px p) (px (t2 f)) = b2r (posb x) /\ above (px p) (px (t3 f)) = b2r (posb x)).
  { unfold above. fold x y z. apply same3_signs in H. fold x y z in H. unfold posb.
    destruct H as [H|H]; destruct (Rlt_dec 0 x), (Rlt_dec 0 y), (Rlt_dec 0 z); try (exfalso; lra); auto. }
  destruct AB as [-> [-> ->]].
  assert (EP : posb (- side f p) && P = posb x && P) by (destruct P; [rewrite SP by auto; auto | rewrite !andb_false_r; auto]).
  assert (EM : posb (side f p) && M = posb x && M) by (destruct M; [rewrite SM by auto; auto | rewrite !andb_false_r; auto]).
  rewrite EP, EM. destruct (posb x), P, M; cbn [andb b2r]; lra.
Qed.

(** ** Orientation *)
Lemma D2_anti a b : D2 b a = - D2 a b.
Proof. unfold D2. ring. Qed.
Lemma c2_anti a b : c2 b a = - c2 a b.
Proof.
  unfold c2. assert (R1 : rho b a = - rho a b).
  { unfold rho. rewrite (D2_anti a b), Ropp_involutive. lra. }
  rewrite R1. unfold tau. lra.
Qed.
Lemma c1_opposite f g : opposite f g -> c1 f = - c1 g.
Proof.
  intros H. pose proof (oddm_o f g p H) as S. unfold c1, cross, sigma. rewrite S, Ropp_involutive. clear S.
  destruct f as [f1 f2 f3], g as [g1 g2 g3]. unfold opposite in H; cbn [t1 t2 t3] in *.
  destruct H as [[-> [-> ->]]|[[-> [-> ->]]|[-> [-> ->]]]];
  rewrite (D2_anti g1 g2), (D2_anti g2 g3), (D2_anti g3 g1), ?Ropp_involutive;
  set (a := D2 g1 g2); set (b := D2 g2 g3); set (c := D2 g3 g1);
  destruct (posb a), (posb b), (posb c), (posb (- a)), (posb (- b)), (posb (- c)), (posb (- side _ p)), (posb (side _ p)); cbn [andb b2r]; lra.
Qed.

(** ** Integer parts: s < x + h n exactly when 0 < NN s x + n *)
Definition NN (s x : R) : Z := (1 - up ((s - x) / h))%Z.
Lemma above_NN s x n : above s (x + h * IZR n) = b2r (0 <? NN s x + n)%Z.
Proof.
  unfold NN. set (r := (s - x) / h). assert (E : s = x + h * r) by (unfold r; field; lra).
  destruct (archimed r) as [A1 A2]. destruct (Z.ltb_spec 0 (1 - up r + n)) as [L|L].
  - apply above_1. assert (LE : (up r <= n)%Z) by lia. apply IZR_le in LE. rewrite E. nra.
  - apply above_0. assert (LE : (n + 1 <= up r)%Z) by lia. apply IZR_le in LE. rewrite plus_IZR in LE. rewrite E. nra.
Qed.
Lemma NN_shift s x d : NN s (x + h * IZR d) = (NN s x + d)%Z.
Proof.
  unfold NN. set (r := (s - x) / h). replace ((s - (x + h * IZR d)) / h) with (r - IZR d) by (unfold r; field; lra).
  destruct (archimed r) as [A1 A2].
  rewrite <- (tech_up (r - IZR d) (up r - d)); [lia | |]; rewrite minus_IZR; lra.
Qed.
Lemma NN_bound s x M : Rabs (s - x) <= M -> IZR (Z.abs (NN s x)) <= M / h + 2.
Proof.
  intros H. unfold NN. set (r := (s - x) / h). destruct (archimed r) as [A1 A2].
  assert (Er : r * h = s - x) by (unfold r; field; lra).
  assert (Em : M / h * h = M) by (field; lra). set (m := M / h) in *.
  pose proof (Rle_abs (s - x)). pose proof (Rle_abs (- (s - x))). rewrite Rabs_Ropp in *.
  assert (- m <= r <= m) by (split; nra).
  rewrite abs_IZR, minus_IZR. apply Rabs_le. lra.
Qed.

Definition sh (n : Z3) (v : point) := add v (vec h n).
Definition N1 v := NN (px p) (px v).
Definition N2 v := NN (py p) (py v).
Definition N3 v := NN (pz p) (pz v).
Definition small B v := (Z.abs (N1 v) <= B /\ Z.abs (N2 v) <= B /\ Z.abs (N3 v) <= B)%Z.
Definition n1 (n : Z3) := fst (fst n).
Definition n2 (n : Z3) := snd (fst n).
Definition n3 (n : Z3) := snd n.
Lemma px_sh n v : px (sh n v) = px v + h * IZR (n1 n).
Proof. destruct n as [[? ?] ?]. reflexivity. Qed.
Lemma py_sh n v : py (sh n v) = py v + h * IZR (n2 n).
Proof. destruct n as [[? ?] ?]. reflexivity. Qed.
Lemma pz_sh n v : pz (sh n v) = pz v + h * IZR (n3 n).
Proof. destruct n as [[? ?] ?]. reflexivity. Qed.

Lemma far_same s x n B : (Z.abs (NN s x) <= B)%Z -> (B < n)%Z -> s < x + h * IZR n.
Proof.
  intros H L. pose proof (above_NN s x n) as A. destruct (Z.ltb_spec 0 (NN s x + n)); [|lia].
  destruct (Rlt_dec s (x + h * IZR n)); auto. rewrite above_0 in A by lra. cbn in A. lra.
Qed.
Lemma far_same' s x n B : (Z.abs (NN s x) <= B)%Z -> (n < - B)%Z -> x + h * IZR n <= s.
Proof.
  intros H L. pose proof (above_NN s x n) as A. destruct (Z.ltb_spec 0 (NN s x + n)); [lia|].
  destruct (Rlt_dec s (x + h * IZR n)); [|lra]. rewrite above_1 in A by lra. cbn in A. lra.
Qed.
Lemma same_far s x y n B : (Z.abs (NN s x) <= B)%Z -> (Z.abs (NN s y) <= B)%Z -> (B < Z.abs n)%Z ->
  same s (x + h * IZR n) (y + h * IZR n).
Proof.
  intros X Y L. destruct (Z_lt_dec B n).
  - left. split; apply far_same with (B := B); auto.
  - right. split; apply far_same' with (B := B); auto; lia.
Qed.
Lemma same3_far s x y z n B : (Z.abs (NN s x) <= B)%Z -> (Z.abs (NN s y) <= B)%Z -> (Z.abs (NN s z) <= B)%Z -> (B < Z.abs n)%Z ->
  same3 s (x + h * IZR n) (y + h * IZR n) (z + h * IZR n).
Proof.
  intros X Y Z0 L. destruct (Z_lt_dec B n).
  - left. repeat split; apply far_same with (B := B); auto.
  - right. repeat split; apply far_same' with (B := B); auto; lia.
Qed.

Lemma c2_support a b n B : small B a -> small B b -> c2 (sh n a) (sh n b) <> 0 -> (Z.abs (n2 n) <= B /\ Z.abs (n3 n) <= B)%Z.
Proof.
  intros [_ [A2 A3]] [_ [B2 B3]] H. split; apply Z.nlt_ge; intros L; apply H.
  - apply c2_y. rewrite !py_sh. apply same_far with (B := B); auto.
  - apply c2_z. rewrite !pz_sh. apply same_far with (B := B); auto.
Qed.
Definition tt n f := Triangle (sh n (t1 f)) (sh n (t2 f)) (sh n (t3 f)).
Definition small3 B f := small B (t1 f) /\ small B (t2 f) /\ small B (t3 f).
Lemma c1_support f n B : small3 B f -> c1 (tt n f) <> 0 -> (Z.abs (n1 n) <= B /\ Z.abs (n2 n) <= B /\ Z.abs (n3 n) <= B)%Z.
Proof.
  intros [[A1 [A2 A3]] [[B1 [B2 B3]] [C1 [C2 C3]]]] H. repeat split; apply Z.nlt_ge; intros L; apply H.
  - apply c1_x. unfold tt; cbn [t1 t2 t3]. rewrite !px_sh. apply same3_far with (B := B); auto.
  - apply c1_yz. left. unfold tt; cbn [t1 t2 t3]. rewrite !py_sh. apply same3_far with (B := B); auto.
  - apply c1_yz. right. unfold tt; cbn [t1 t2 t3]. rewrite !pz_sh. apply same3_far with (B := B); auto.
Qed.

(** ** Counting the translates of one tetrahedron *)
Definition box (K : nat) : list Z3 := list_prod (list_prod (zr K) (zr K)) (zr K).
Lemma box_In K n : In n (box K) <-> (Z.abs (n1 n) <= Z.of_nat K /\ Z.abs (n2 n) <= Z.of_nat K /\ Z.abs (n3 n) <= Z.of_nat K)%Z.
Proof. destruct n as [[x y] z]. unfold box, n1, n2, n3; cbn [fst snd]. rewrite !in_prod_iff, !zr_In. tauto. Qed.
Lemma box_NoDup K : NoDup (box K).
Proof. unfold box. repeat apply NoDup_list_prod; apply zr_NoDup. Qed.
Lemma rsum2_ext (f g : Z -> Z -> R) l l' : (forall y z, In y l -> In z l' -> f y z = g y z) ->
  rsum (fun y => rsum (fun z => f y z) l') l = rsum (fun y => rsum (fun z => g y z) l') l.
Proof. intros H. apply rsum_ext. intros y Hy. apply rsum_ext. auto. Qed.
Lemma rsum2_mul (f g : Z -> R) l l' : rsum (fun y => rsum (fun z => f y * g z) l') l = rsum f l * rsum g l'.
Proof. rewrite <- rsum_mulr. apply rsum_ext. intros y _. apply rsum_mull. Qed.
Lemma rsum2_add (f g : Z -> Z -> R) l l' : rsum (fun y => rsum (fun z => f y z + g y z) l') l =
  rsum (fun y => rsum (fun z => f y z) l') l + rsum (fun y => rsum (fun z => g y z) l') l.
Proof. rewrite <- rsum_add. apply rsum_ext. intros y _. apply rsum_add. Qed.

Definition C2 K a b : R := rsum (fun y => rsum (fun z => c2 (sh (0%Z, y, z) a) (sh (0%Z, y, z) b)) (zr K)) (zr K).
Definition C1 K f : R := rsum (fun n => c1 (tt n f)) (box K).
Definition k2r (K : nat) : R := IZR (Z.of_nat K).

Lemma edge_sum K a b : small (Z.of_nat K) a -> small (Z.of_nat K) b ->
  rsum (fun y => rsum (fun z => rho (sh (0%Z, y, z) a) (sh (0%Z, y, z) b)) (zr K)) (zr K)
  = (IZR (N2 a) + IZR (N2 b) + 2 * k2r K) / 2 * (IZR (N3 b) - IZR (N3 a)) + C2 K a b.
Proof.
  intros [_ [A2 A3]] [_ [B2 B3]].
  set (al := fun y => (b2r (0 <? N2 a + y)%Z + b2r (0 <? N2 b + y)%Z) / 2).
  set (ta := fun z => b2r (0 <? N3 b + z)%Z - b2r (0 <? N3 a + z)%Z).
  rewrite (rsum2_ext _ (fun y z => al y * ta z + c2 (sh (0%Z, y, z) a) (sh (0%Z, y, z) b))).
  2:{ intros y z _ _. unfold c2, tau. rewrite !py_sh, !pz_sh. cbn [n2 n3 fst snd]. rewrite !above_NN.
      fold (N2 a) (N2 b) (N3 a) (N3 b). unfold al, ta. lra. }
  rewrite rsum2_add, rsum2_mul. fold (C2 K a b). f_equal. f_equal.
  - unfold al. rewrite (rsum_ext _ (fun y => (b2r (0 <? N2 a + y)%Z + b2r (0 <? N2 b + y)%Z) * / 2)) by reflexivity.
    rewrite rsum_mulr, rsum_add, !count_above, !plus_IZR by auto. fold (k2r K). lra.
  - unfold ta. rewrite rsum_sub, !count_above, !plus_IZR by auto. lra.
Qed.

Definition Om K a b : R := (IZR (N2 a) + IZR (N2 b)) / 2 * (IZR (N3 b) - IZR (N3 a)) + C2 K a b.
Lemma shadow_sum K f : small3 (Z.of_nat K) f -> (forall n, In n (box K) -> good (tt n f)) ->
  rsum (fun y => rsum (fun z => sigma (tt (0%Z, y, z) f)) (zr K)) (zr K)
  = Om K (t1 f) (t2 f) + Om K (t2 f) (t3 f) + Om K (t3 f) (t1 f).
Proof.
  intros [S1 [S2 S3]] G.
  rewrite (rsum2_ext _ (fun y z => rho (sh (0%Z, y, z) (t1 f)) (sh (0%Z, y, z) (t2 f)) +
    (rho (sh (0%Z, y, z) (t2 f)) (sh (0%Z, y, z) (t3 f)) + rho (sh (0%Z, y, z) (t3 f)) (sh (0%Z, y, z) (t1 f))))).
  2:{ intros y z Hy Hz. rewrite sigma_rho. { cbn [tt t1 t2 t3]. lra. }
      apply G, box_In. cbn [n1 n2 n3 fst snd]. apply zr_In in Hy, Hz. lia. }
  rewrite rsum2_add, rsum2_add, !edge_sum by auto. unfold Om. field.
Qed.

Lemma cross_sum K f : small3 (Z.of_nat K) f -> (forall n, In n (box K) -> good (tt n f)) ->
  rsum (fun n => cross (tt n f)) (box K)
  = (IZR (N1 (t1 f)) + IZR (N1 (t2 f)) + IZR (N1 (t3 f)) + 3 * k2r K) / 3 * (Om K (t1 f) (t2 f) + Om K (t2 f) (t3 f) + Om K (t3 f) (t1 f)) + C1 K f.
Proof.
  intros S G. rewrite <- (shadow_sum K f S G).
  set (be := fun x => (b2r (0 <? N1 (t1 f) + x)%Z + b2r (0 <? N1 (t2 f) + x)%Z + b2r (0 <? N1 (t3 f) + x)%Z) * / 3).
  rewrite (rsum_ext _ (fun n => be (n1 n) * sigma (tt (0%Z, n2 n, n3 n) f) + c1 (tt n f))).
  2:{ intros n _. unfold c1. cbn [tt t1 t2 t3]. rewrite !px_sh, !above_NN. fold (N1 (t1 f)) (N1 (t2 f)) (N1 (t3 f)). unfold be.
      destruct n as [[x y] z]. cbn [n1 n2 n3 fst snd].
      change (sigma (tt (x, y, z) f)) with (sigma (tt (0%Z, y, z) f)). field. }
  rewrite rsum_add. fold (C1 K f). f_equal.
  unfold box. rewrite rsum_prod, rsum_prod. cbn [n1 n2 n3 fst snd].
  rewrite (rsum_ext _ (fun x => be x * rsum (fun y => rsum (fun z => sigma (tt (0%Z, y, z) f)) (zr K)) (zr K))).
  2:{ intros x _. rewrite <- rsum_mull. apply rsum_ext. intros y _. rewrite <- rsum_mull. reflexivity. }
  rewrite rsum_mulr. f_equal. unfold be. destruct S as [[A _] [[B _] [C _]]].
  rewrite rsum_mulr, !rsum_add, !count_above, !plus_IZR by auto. fold (k2r K). lra.
Qed.

Lemma C2_anti K a b : C2 K b a = - C2 K a b.
Proof.
  unfold C2. rewrite <- rsum_opp. apply rsum_ext. intros y _. rewrite <- rsum_opp. apply rsum_ext. intros z _. apply c2_anti.
Qed.

(** The facet term. *)
Definition w K f : R := - C1 K f
  - (C2 K (t1 f) (t2 f) * (IZR (N1 (t3 f)) - (IZR (N1 (t1 f)) + IZR (N1 (t2 f))) / 2)
   + C2 K (t2 f) (t3 f) * (IZR (N1 (t1 f)) - (IZR (N1 (t2 f)) + IZR (N1 (t3 f))) / 2)
   + C2 K (t3 f) (t1 f) * (IZR (N1 (t2 f)) - (IZR (N1 (t3 f)) + IZR (N1 (t1 f))) / 2)) / 3.

(** The tetrahedron of the integer parts, and a tetrahedron from three functions. *)
Definition mapT (X Y Z : point -> R) (t : tetrahedron) :=
  let m v := Point (X v) (Y v) (Z v) in Tetrahedron (m (va t)) (m (vb t)) (m (vc t)) (m (vd t)).
Definition M1 v := IZR (N1 v).
Definition M2 v := IZR (N2 v).
Definition M3 v := IZR (N3 v).

Theorem translates_count K t : 0 < vol t -> (forall v, In v (verts t) -> small (Z.of_nat K) v) ->
  (forall n i, In n (box K) -> In i I4 -> good (tt n (facet t i))) ->
  rsum (fun n => b2r (insideb (translate (vec h n) t) p)) (box K)
  = vol (mapT M1 M2 M3 t) / 6 + rsum (fun i => w K (facet t i)) I4.
Proof.
  intros V S G.
  rewrite (rsum_ext _ (fun n => - (cross (tt n (facet t 0)) + (cross (tt n (facet t 1)) + (cross (tt n (facet t 2)) + (cross (tt n (facet t 3)) + 0)))))).
  2:{ intros n Hn. rewrite ray.
      - reflexivity.
      - rewrite vol_ttr; auto.
      - intros i Hi. rewrite facet_translate. apply (G n i); auto. }
  rewrite rsum_opp, !rsum_add, (rsum_zero (fun _ => 0)) by auto.
  pose proof (S (va t) ltac:(simpl; auto)) as Sa. pose proof (S (vb t) ltac:(simpl; auto)) as Sb.
  pose proof (S (vc t) ltac:(simpl; auto)) as Sc. pose proof (S (vd t) ltac:(simpl; auto)) as Sd.
  rewrite !cross_sum; try (intros n Hn; apply G; auto; simpl; tauto); try (unfold small3; cbn [facet t1 t2 t3]; auto).
  unfold w. cbn [rsum I4 facet t1 t2 t3]. unfold Om.
  rewrite (C2_anti K (va t) (vb t)), (C2_anti K (va t) (vc t)), (C2_anti K (va t) (vd t)), (C2_anti K (vb t) (vc t)), (C2_anti K (vb t) (vd t)), (C2_anti K (vc t) (vd t)).
  unfold mapT, vol, M1, M2, M3; cbn [va vb vc vd]. unf. field.
Qed.

(** *** Oddness and invariance of the facet term *)
Lemma w_opposite K f g : opposite f g -> w K f = - w K g.
Proof.
  intros H. unfold w.
  assert (E : C1 K f = - C1 K g).
  { unfold C1. rewrite <- rsum_opp. apply rsum_ext. intros n _. apply c1_opposite. apply (oddm_tritr (vec h n)); auto. }
  rewrite E. destruct H as [[-> [-> ->]]|[[-> [-> ->]]|[-> [-> ->]]]];
  rewrite (C2_anti K (t1 g) (t2 g)), (C2_anti K (t2 g) (t3 g)), (C2_anti K (t3 g) (t1 g)); field.
Qed.

Lemma N1_sh d v : N1 (sh d v) = (N1 v + n1 d)%Z.
Proof. unfold N1. rewrite px_sh. apply NN_shift. Qed.
Lemma N2_sh d v : N2 (sh d v) = (N2 v + n2 d)%Z.
Proof. unfold N2. rewrite py_sh. apply NN_shift. Qed.
Lemma N3_sh d v : N3 (sh d v) = (N3 v + n3 d)%Z.
Proof. unfold N3. rewrite pz_sh. apply NN_shift. Qed.
Lemma c2_ext a b a' b' : py a = py a' -> pz a = pz a' -> py b = py b' -> pz b = pz b' -> c2 a b = c2 a' b'.
Proof. intros H1 H2 H3 H4. unfold c2, rho, tau, D2. rewrite H1, H2, H3, H4. reflexivity. Qed.

Section Shift.
Variables (K : nat) (B : Z) (d : Z3).
Hypothesis HK : (3 * B <= Z.of_nat K)%Z.

Lemma shift_small v : small B v -> small B (sh d v) -> (Z.abs (n1 d) <= 2 * B /\ Z.abs (n2 d) <= 2 * B /\ Z.abs (n3 d) <= 2 * B)%Z.
Proof. unfold small. rewrite N1_sh, N2_sh, N3_sh. lia. Qed.

Lemma C2_shift a b : small B a -> small B b -> small B (sh d a) -> C2 K (sh d a) (sh d b) = C2 K a b.
Proof.
  intros Sa Sb Sd. pose proof (shift_small a Sa Sd) as [_ [D2' D3']].
  unfold C2.
  set (F := fun yz : Z * Z => c2 (sh (0%Z, fst yz, snd yz) a) (sh (0%Z, fst yz, snd yz) b)).
  transitivity (rsum (fun yz => F ((fst yz + n2 d)%Z, (snd yz + n3 d)%Z)) (list_prod (zr K) (zr K))).
  - rewrite rsum_prod. apply rsum2_ext. intros y z _ _. unfold F; cbn [fst snd]. apply c2_ext;
    rewrite ?py_sh, ?pz_sh; cbn [n2 n3 fst snd]; rewrite plus_IZR; ring.
  - rewrite (rsum_shift F (fun yz => ((fst yz + n2 d)%Z, (snd yz + n3 d)%Z)) (fun yz => ((fst yz - n2 d)%Z, (snd yz - n3 d)%Z))).
    + rewrite rsum_prod. reflexivity.
    + apply NoDup_list_prod; apply zr_NoDup.
    + intros [y z]; cbn [fst snd]. f_equal; lia.
    + intros [y z]; cbn [fst snd]. f_equal; lia.
    + intros [y z] H. unfold F in H; cbn [fst snd] in H. apply c2_support with (B := B) in H; auto. cbn [n2 n3 fst snd] in H.
      cbn [fst snd]. rewrite !in_prod_iff, !zr_In. lia.
Qed.
Lemma C1_shift f : small3 B f -> small B (sh d (t1 f)) -> C1 K (tt d f) = C1 K f.
Proof.
  intros S Sd. pose proof (shift_small (t1 f) (proj1 S) Sd) as [D1' [D2' D3']].
  unfold C1. transitivity (rsum (fun n => (fun m => c1 (tt m f)) (zadd3 n d)) (box K)).
  - apply rsum_ext. intros n _. f_equal. unfold tt; cbn [t1 t2 t3]. unfold sh. rewrite !vec_add, (padd_comm (vec h n)), !padd_assoc. reflexivity.
  - apply (rsum_shift (fun m => c1 (tt m f)) (fun n => zadd3 n d) (fun n => zadd3 n (zopp3 d))).
    + apply box_NoDup.
    + intros [[? ?] ?]. destruct d as [[? ?] ?]. cbn. repeat f_equal; lia.
    + intros [[? ?] ?]. destruct d as [[? ?] ?]. cbn. repeat f_equal; lia.
    + intros n H. apply c1_support with (B := B) in H; auto. rewrite !box_In.
      assert (P : n1 (zadd3 n (zopp3 d)) = (n1 n - n1 d)%Z /\ n2 (zadd3 n (zopp3 d)) = (n2 n - n2 d)%Z /\ n3 (zadd3 n (zopp3 d)) = (n3 n - n3 d)%Z).
      { clear. destruct n as [[? ?] ?]. destruct d as [[? ?] ?]. unfold n1, n2, n3, zadd3, zopp3; cbn [fst snd]. lia. }
      destruct P as [-> [-> ->]]. lia.
Qed.
Lemma w_shift f : small3 B f -> small3 B (tt d f) -> w K (tt d f) = w K f.
Proof.
  intros S Sd. pose proof S as [S1 [S2 S3]]. destruct Sd as [D1' [D2' D3']]. cbn [tt t1 t2 t3] in *.
  unfold w. rewrite C1_shift by auto. cbn [tt t1 t2 t3]. rewrite !C2_shift by auto. rewrite !N1_sh, !plus_IZR. field.
Qed.
End Shift.
End Point.

(** ** All tetrahedra of the cell *)
Section Cell.
Variables (N : nat) (T : nat -> tetrahedron) (h : R) (lat : Z3 -> bool) (Dom : point -> Prop).
Variable mate : nat -> nat -> option (nat * nat * Z3).
Hypothesis h_pos : 0 < h.
Hypothesis lat_all : forall n, lat n = true.
Hypothesis Hvol : forall k, (k < N)%nat -> 0 < vol (T k).
Hypothesis Hmate : forall k i, (k < N)%nat -> In i I4 ->
  match mate k i with
  | Some (k', i', d) =>
    (k' < N)%nat /\ In i' I4 /\ mate k' i' = Some (k, i, zopp3 d) /\
    opposite (facet (T k) i) (facet (translate (vec h d) (T k')) i')
  | None => False
  end.

(** What is odd and periodic on the facets sums to zero. *)
Lemma pairs_cancel (g : triangle -> R) :
  (forall k i k' i' d, (k < N)%nat -> In i I4 -> mate k i = Some (k', i', d) -> (k' < N)%nat -> In i' I4 ->
     opposite (facet (T k) i) (tt h d (facet (T k') i')) -> g (facet (T k) i) = - g (facet (T k') i')) ->
  rsum (fun k => rsum (fun i => g (facet (T k) i)) I4) (seq 0 N) = 0.
Proof.
  intros H.
  set (s := fun ki : nat * nat => match mate (fst ki) (snd ki) with Some (k', i', _) => (k', i') | None => ki end).
  assert (X : forall e, e = 1 \/ e = -1 -> rsum (fun ki => e * g (facet (T (fst ki)) (snd ki))) (list_prod (seq 0 N) I4) <= 0).
  { intros e He. apply rsum_invol with (s := s) (b := fun _ => true).
    - apply NoDup_list_prod; [apply seq_NoDup|]. unfold I4. repeat constructor; simpl; intuition congruence.
    - discriminate.
    - intros [k i] Hin _. apply in_prod_iff in Hin as [Hk Hi]. apply in_seq in Hk. unfold s; cbn [fst snd].
      pose proof (Hmate k i ltac:(lia) Hi) as M. destruct (mate k i) as [[[k' i'] d]|] eqn:E; [|tauto].
      destruct M as [M1 [M2 [M3 M4]]]. cbn [fst snd]. rewrite M3. repeat split; auto.
      + apply in_prod; auto. apply in_seq; lia.
      + rewrite facet_translate in M4. rewrite (H k i k' i' d ltac:(lia) Hi E M1 M2 M4). destruct He as [->| ->]; lra. }
  pose proof (X 1 (or_introl eq_refl)) as X1. pose proof (X (-1) (or_intror eq_refl)) as X2.
  rewrite rsum_mull, rsum_prod in X1, X2. cbn [fst snd] in X1, X2. lra.
Qed.

(** A determinant with a periodic row sums to zero. *)
Definition shoelace (Y Z : point -> R) f :=
  (Y (t1 f) * Z (t2 f) - Y (t2 f) * Z (t1 f)) + (Y (t2 f) * Z (t3 f) - Y (t3 f) * Z (t2 f)) + (Y (t3 f) * Z (t1 f) - Y (t1 f) * Z (t3 f)).
Lemma periodic_cancel (u Y Z : point -> R) : (forall d v, u (sh h d v) = u v) ->
  (forall d v v', Y (sh h d v) - Y v = Y (sh h d v') - Y v') -> (forall d v v', Z (sh h d v) - Z v = Z (sh h d v') - Z v') ->
  rsum (fun k => vol (mapT u Y Z (T k))) (seq 0 N) = 0.
Proof.
  intros Hu HY HZ. set (g := fun f => - ((u (t1 f) + u (t2 f) + u (t3 f)) * shoelace Y Z f)).
  rewrite (rsum_ext _ (fun k => rsum (fun i => g (facet (T k) i)) I4)).
  2:{ intros k _. unfold g, shoelace. cbn [rsum I4 facet t1 t2 t3]. unfold mapT, vol; cbn [va vb vc vd]. unf. ring. }
  apply pairs_cancel. intros k i k' i' d _ _ _ _ _ O.
  assert (O1 : forall f f', opposite f f' -> g f = - g f').
  { intros f f' [[A [B C]]|[[A [B C]]|[A [B C]]]]; unfold g, shoelace; rewrite A, B, C; ring. }
  rewrite (O1 _ _ O). f_equal. unfold g, shoelace. cbn [tt t1 t2 t3]. rewrite !Hu.
  set (f := facet (T k') i').
  assert (Y2 : Y (sh h d (t2 f)) = Y (t2 f) + (Y (sh h d (t1 f)) - Y (t1 f))) by (rewrite (HY d (t1 f) (t2 f)); ring).
  assert (Y3 : Y (sh h d (t3 f)) = Y (t3 f) + (Y (sh h d (t1 f)) - Y (t1 f))) by (rewrite (HY d (t1 f) (t3 f)); ring).
  assert (Z2 : Z (sh h d (t2 f)) = Z (t2 f) + (Z (sh h d (t1 f)) - Z (t1 f))) by (rewrite (HZ d (t1 f) (t2 f)); ring).
  assert (Z3' : Z (sh h d (t3 f)) = Z (t3 f) + (Z (sh h d (t1 f)) - Z (t1 f))) by (rewrite (HZ d (t1 f) (t3 f)); ring).
  rewrite Y2, Y3, Z2, Z3'. ring.
Qed.

(** Integer parts and volumes. *)
Lemma integer_volumes p : rsum (fun k => vol (mapT (M1 h p) (M2 h p) (M3 h p) (T k))) (seq 0 N) = rsum (fun k => vol (T k)) (seq 0 N) / (h * h * h).
Proof.
  set (X := fun v => (px v - px p) / h). set (Y := fun v => (py v - py p) / h). set (Z := fun v => (pz v - pz p) / h).
  set (u1 := fun v => M1 h p v - X v). set (u2 := fun v => M2 h p v - Y v). set (u3 := fun v => M3 h p v - Z v).
  rewrite (rsum_ext _ (fun k => vol (T k) * / (h * h * h) + (vol (mapT u1 (M2 h p) (M3 h p) (T k)) + (- vol (mapT u2 X (M3 h p) (T k)) + vol (mapT u3 X Y (T k)))))).
  2:{ intros k _. unfold u1, u2, u3, X, Y, Z, mapT, vol; cbn [va vb vc vd]. unf. field. lra. }
  assert (PX : forall d v v', X (sh h d v) - X v = X (sh h d v') - X v') by (intros; unfold X; rewrite !px_sh; field; lra).
  assert (PY : forall d v v', Y (sh h d v) - Y v = Y (sh h d v') - Y v') by (intros; unfold Y; rewrite !py_sh; field; lra).
  assert (P2 : forall d v v', M2 h p (sh h d v) - M2 h p v = M2 h p (sh h d v') - M2 h p v') by (intros; unfold M2; rewrite !N2_sh, !plus_IZR by auto; ring).
  assert (P3 : forall d v v', M3 h p (sh h d v) - M3 h p v = M3 h p (sh h d v') - M3 h p v') by (intros; unfold M3; rewrite !N3_sh, !plus_IZR by auto; ring).
  rewrite !rsum_add, rsum_opp, rsum_mulr, !periodic_cancel; auto.
  - unfold Rdiv. ring.
  - intros d v. unfold u3, M3, Z. rewrite N3_sh, pz_sh, plus_IZR by auto. field. lra.
  - intros d v. unfold u2, M2, Y. rewrite N2_sh, py_sh, plus_IZR by auto. field. lra.
  - intros d v. unfold u1, M1, X. rewrite N1_sh, px_sh, plus_IZR by auto. field. lra.
Qed.

Notation piece := (piece T h).
Notation cells := (cells N lat).

Lemma cells_all K : cells K = list_prod (seq 0 N) (box K).
Proof.
  unfold Degree.cells, box. set (l := list_prod (seq 0 N) _). clearbody l.
  induction l as [|c l IH]; simpl; auto. rewrite lat_all. f_equal. auto.
Qed.

(** The number of tiles that contain a generic point is the volume sum over 6 h^3. *)
Theorem count_is_volume K B p : (3 * B <= Z.of_nat K)%Z -> (B <= Z.of_nat K)%Z ->
  (forall k v, (k < N)%nat -> In v (verts (T k)) -> small h p B v) ->
  (forall c i, In c (cells K) -> In i I4 -> good p (facet (piece c) i)) ->
  IZR (count N T h lat one K p) = rsum (fun k => vol (T k)) (seq 0 N) / (6 * (h * h * h)).
Proof.
  intros K1 K2 S G. rewrite cnt_one, rsum_IZR, cells_all.
  etransitivity; [apply (rsum_prod (fun c : nat * Z3 => IZR (Z.b2z (insideb (piece c) p))))|]. cbv beta.
  assert (SK : forall v, small h p B v -> small h p (Z.of_nat K) v) by (unfold small; intros; lia).
  rewrite (rsum_ext _ (fun k => vol (mapT (M1 h p) (M2 h p) (M3 h p) (T k)) * / 6 + rsum (fun i => w h p K (facet (T k) i)) I4)).
  - rewrite rsum_add, rsum_mulr, integer_volumes.
    rewrite (pairs_cancel (w h p K)).
    + field. lra.
    + intros k i k' i' d Hk Hi E Hk' Hi' O. rewrite (w_opposite h p K _ _ O). f_equal.
      assert (SM : forall k i, (k < N)%nat -> In i I4 -> small3 h p B (facet (T k) i)).
      { clear - S. intros k i Hk Hi. unfold small3. simpl in Hi. destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; cbn [facet t1 t2 t3];
        (split; [|split]); apply (S k _ Hk); simpl; auto. }
      apply w_shift with (B := B); auto.
      clear - O SM Hk Hi. specialize (SM k i Hk Hi). unfold small3, opposite in *.
      destruct O as [[A [B' C]]|[[A [B' C]]|[A [B' C]]]]; rewrite A, B', C in SM; tauto.
  - intros k Hk. apply in_seq in Hk.
    rewrite (rsum_ext _ (fun n => b2r (insideb (translate (vec h n) (T k)) p))) by (intros; apply b2r_b2z).
    rewrite translates_count; auto.
    + apply Hvol; lia.
    + intros v Hv. apply SK, (S k); auto; lia.
    + intros n i Hn Hi. pose proof (G (k, n) i) as G'. unfold Degree.piece in G'; cbn [fst snd] in G'. rewrite facet_translate in G'. apply G'; auto.
      rewrite cells_all. apply in_prod; auto. apply in_seq; lia.
Qed.

(** Generic points exist. *)
Definition edge_form (a b : point) : point -> R :=
  if Req_EM_T (py a) (py b) then (if Req_EM_T (pz a) (pz b) then (fun _ => 1) else (fun x => D2 x a b)) else (fun x => D2 x a b).
Definition vertex_forms (v : point) : list (point -> R) := [(fun x => px v - px x); (fun x => py v - py x); (fun x => pz v - pz x)].
Definition forms (f : triangle) : list (point -> R) :=
  vertex_forms (t1 f) ++ vertex_forms (t2 f) ++ vertex_forms (t3 f) ++
  [side f; edge_form (t1 f) (t2 f); edge_form (t2 f) (t3 f); edge_form (t3 f) (t1 f)].
Lemma aff_D2' a b : affine (fun x => D2 x a b).
Proof. exists 0, (pz a - pz b), (py b - py a), (py a * pz b - pz a * py b). intros x. unfold D2. ring. Qed.
Lemma edge_form_ok a b : affine (edge_form a b) /\ exists z, edge_form a b z <> 0.
Proof.
  assert (C : affine (fun _ => 1)) by (exists 0, 0, 0, 1; intros; ring).
  unfold edge_form. destruct (Req_EM_T (py a) (py b)) as [Ey|Ey]; [destruct (Req_EM_T (pz a) (pz b)) as [Ez|Ez]|].
  - split; auto. exists origin. lra.
  - split; [apply aff_D2'|]. exists (Point 0 (py a + 1) (pz a)). unfold D2; cbn [px py pz]. lra.
  - split; [apply aff_D2'|]. exists (Point 0 (py a) (pz a + 1)). unfold D2; cbn [px py pz]. lra.
Qed.
Lemma forms_good f x : (forall g, In g (forms f) -> g x <> 0) -> good x f.
Proof.
  intros H. unfold good, off_axis.
  assert (I : forall g, In g (forms f) -> g x <> 0) by exact H.
  unfold forms, vertex_forms in I. cbn [app] in I.
  pose proof (I (fun x => px (t1 f) - px x) ltac:(simpl; tauto)). pose proof (I (fun x => py (t1 f) - py x) ltac:(simpl; tauto)). pose proof (I (fun x => pz (t1 f) - pz x) ltac:(simpl; tauto)).
  pose proof (I (fun x => px (t2 f) - px x) ltac:(simpl; tauto)). pose proof (I (fun x => py (t2 f) - py x) ltac:(simpl; tauto)). pose proof (I (fun x => pz (t2 f) - pz x) ltac:(simpl; tauto)).
  pose proof (I (fun x => px (t3 f) - px x) ltac:(simpl; tauto)). pose proof (I (fun x => py (t3 f) - py x) ltac:(simpl; tauto)). pose proof (I (fun x => pz (t3 f) - pz x) ltac:(simpl; tauto)).
  pose proof (I (side f) ltac:(simpl; tauto)) as S.
  pose proof (I (edge_form (t1 f) (t2 f)) ltac:(simpl; tauto)) as E1. pose proof (I (edge_form (t2 f) (t3 f)) ltac:(simpl; tauto)) as E2. pose proof (I (edge_form (t3 f) (t1 f)) ltac:(simpl; tauto)) as E3.
  cbv beta in *. clear I H.
  assert (GE : forall a b, edge_form a b x <> 0 -> good_edge x a b).
  { intros a b. unfold edge_form, good_edge. destruct (Req_EM_T (py a) (py b)); [destruct (Req_EM_T (pz a) (pz b))|]; auto. }
  repeat split; auto; lra.
Qed.

Theorem volume_covers_once : rsum (fun k => vol (T k)) (seq 0 N) = 6 * (h * h * h) -> covered_once N T h lat Dom.
Proof.
  intros HS M x V Hx Vx OV VD.
  destruct (bnd_exists N T) as [M0 [HM0 BV]].
  destruct (range N T h lat h_pos Hvol M) as [K0 RG].
  set (m := (M + M0) / h + 2). set (B := up m). assert (HB : m <= IZR B) by (destruct (archimed m); unfold B; lra).
  assert (MP : 0 < M). { destruct Hx as [Hx _]. pose proof (Rabs_pos (px x - px org)). lra. }
  assert (m0 : 0 < m). { unfold m. assert (0 < (M + M0) / h) by (apply Rdiv_lt_0_compat; lra). lra. }
  assert (B0 : (0 < B)%Z) by (apply lt_IZR; lra).
  set (K := (K0 + Z.to_nat (3 * B))%nat).
  destruct (generic (flat_map (fun c => flat_map (fun i => forms (facet (piece c) i)) I4) (cells K)) (fun y => near M org y /\ V y)) as [q [[Nq Vq] Gq]].
  - intros g Hg. apply in_flat_map in Hg as [c [Hc Hg]]. apply in_flat_map in Hg as [i [Hi Hg]].
    unfold forms in Hg. rewrite !in_app_iff in Hg.
    assert (VF : forall v, In g (vertex_forms v) -> affine g /\ exists z, g z <> 0).
    { intros v Iv. simpl in Iv. destruct Iv as [<-|[<-|[<-|[]]]].
      - split; [exists (-1), 0, 0, (px v); intros; ring|]. exists (Point (px v + 1) 0 0). cbn. lra.
      - split; [exists 0, (-1), 0, (py v); intros; ring|]. exists (Point 0 (py v + 1) 0). cbn. lra.
      - split; [exists 0, 0, (-1), (pz v); intros; ring|]. exists (Point 0 0 (pz v + 1)). cbn. lra. }
    destruct Hg as [Hg|[Hg|[Hg|Hg]]]; eauto.
    destruct Hg as [<-|[<-|[<-|[<-|[]]]]]; try apply edge_form_ok.
    split; [apply aff_o|]. eapply tri_nz; [exact Hvol|]. apply tris_In. eauto.
  - apply opn_and; auto. apply near_opn.
  - eauto.
  - exists K, q. split; auto. split; [|split; auto].
    + apply eq_IZR. rewrite (count_is_volume K B q).
      * rewrite HS. field. lra.
      * unfold K. lia.
      * unfold K. lia.
      * intros k v Hk Hv. destruct (BV k Hk) as [Ba [Bb [Bc Bd]]].
        assert (Bv : bnd M0 v) by (simpl in Hv; destruct Hv as [<-|[<-|[<-|[<-|[]]]]]; auto).
        destruct Bv as [X1 [X2 X3]]. destruct Nq as [Q1 [Q2 Q3]]. cbn [org px py pz] in Q1, Q2, Q3. rewrite Rminus_0_r in Q1, Q2, Q3.
        assert (DB : forall s y, Rabs s < M -> Rabs y <= M0 -> (Z.abs (NN h s y) <= B)%Z).
        { intros s y Hs Hy. apply le_IZR. apply Rle_trans with m; auto. unfold m. apply NN_bound; auto.
          unfold Rminus. apply Rle_trans with (Rabs s + Rabs (- y)); [apply Rabs_triang|]. rewrite Rabs_Ropp. lra. }
        split; [|split]; apply DB; auto.
      * intros c i Hc Hi. apply forms_good. intros g Hg. apply Gq. apply in_flat_map. exists c. split; auto. apply in_flat_map. exists i. auto.
    + intros c y Hc Ny Cy. specialize (RG c y Hc Ny Cy). destruct c as [k [[a b] d]]. rewrite cells_In in *. unfold K. split; [apply RG|]. destruct RG as [_ RG]. lia.
Qed.
End Cell.
