(** * The volume of a tetrahedron, slice by slice

    The characteristic function of a tetrahedron, integrated over x, is the length of its
    part on a line; that, integrated over y, the area of a slice; and that, over z, a
    sixth of the determinant (Integral.v).  A point is inside as often as the ray from
    it along the first axis leaves minus as it enters; the facets that the ray meets are those whose
    projection holds the point, which the same argument, one dimension lower, expresses by
    edges.  So at each stage there is a sum of steps, over facets, edges, vertices. *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Integral.
Import ListNotations.
Open Scope R_scope.

Lemma b2r_b2z b : IZR (Z.b2z b) = b2r b.
Proof. destruct b; reflexivity. Qed.
Lemma rsum_mulr {A} (f : A -> R) c l : rsum (fun x => f x * c) l = rsum f l * c.
Proof. induction l; simpl; lra. Qed.
Lemma rsum_opp {A} (f : A -> R) l : rsum (fun x => - f x) l = - rsum f l.
Proof. induction l; simpl; lra. Qed.

(** ** One generic point, one tetrahedron *)

Section Point.
Variable p : point.

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

Lemma side_D2 f : side f p = - ((px (t1 f) - px p) * D2 (t2 f) (t3 f) + (px (t2 f) - px p) * D2 (t3 f) (t1 f) + (px (t3 f) - px p) * D2 (t1 f) (t2 f)).
Proof. unfold side, D2. unf. ring. Qed.
Lemma all_pos a b c : posb a && posb b && posb c = true <-> 0 < a /\ 0 < b /\ 0 < c.
Proof. rewrite !andb_true_iff, !posb_t. tauto. Qed.
Lemma rho_anti a b : rho b a = - rho a b.
Proof. unfold rho. replace (D2 b a) with (- D2 a b) by (unfold D2; ring). rewrite Ropp_involutive. lra. Qed.
(** The boundary of the boundary is zero. *)
Lemma sigma_closed t : (forall i, In i I4 -> good (facet t i)) -> rsum (fun i => sigma (facet t i)) I4 = 0.
Proof.
  intros G. rewrite (rsum_ext _ (fun i => rho (t1 (facet t i)) (t2 (facet t i)) + rho (t2 (facet t i)) (t3 (facet t i)) + rho (t3 (facet t i)) (t1 (facet t i)))) by (intros; apply sigma_rho; auto).
  cbn [rsum I4 facet t1 t2 t3].
  rewrite (rho_anti (va t) (vb t)), (rho_anti (va t) (vc t)), (rho_anti (va t) (vd t)), (rho_anti (vb t) (vc t)), (rho_anti (vb t) (vd t)), (rho_anti (vc t) (vd t)). lra.
Qed.

(** ** The plane of a facet: x = a0 + a1 y + a2 z *)
Definition shadow f := (py (t2 f) - py (t1 f)) * (pz (t3 f) - pz (t1 f)) - (pz (t2 f) - pz (t1 f)) * (py (t3 f) - py (t1 f)).
Definition a0 f := ((py (t2 f) * pz (t3 f) - pz (t2 f) * py (t3 f)) * px (t1 f) + (py (t3 f) * pz (t1 f) - pz (t3 f) * py (t1 f)) * px (t2 f)
  + (py (t1 f) * pz (t2 f) - pz (t1 f) * py (t2 f)) * px (t3 f)) / shadow f.
Definition a1 f := ((pz (t2 f) - pz (t3 f)) * px (t1 f) + (pz (t3 f) - pz (t1 f)) * px (t2 f) + (pz (t1 f) - pz (t2 f)) * px (t3 f)) / shadow f.
Definition a2 f := ((py (t3 f) - py (t2 f)) * px (t1 f) + (py (t1 f) - py (t3 f)) * px (t2 f) + (py (t2 f) - py (t1 f)) * px (t3 f)) / shadow f.
Definition height f y z := a0 f + a1 f * y + a2 f * z.

Lemma cross_height f : cross f = sigma f * b2r (posb (height f (py p) (pz p) - px p)).
Proof.
  assert (S : shadow f = D2 (t1 f) (t2 f) + D2 (t2 f) (t3 f) + D2 (t3 f) (t1 f)) by (unfold shadow, D2; ring).
  assert (H : shadow f <> 0 -> side f p = shadow f * (px p - height f (py p) (pz p))).
  { intros N. unfold height, a0, a1, a2. rewrite side_D2. field_simplify_eq; [|exact N]. unfold shadow, D2. ring. }
  unfold cross, sigma. set (w := height f (py p) (pz p)) in *. clearbody w.
  set (P := posb (D2 (t1 f) (t2 f)) && posb (D2 (t2 f) (t3 f)) && posb (D2 (t3 f) (t1 f))).
  set (M := posb (- D2 (t1 f) (t2 f)) && posb (- D2 (t2 f) (t3 f)) && posb (- D2 (t3 f) (t1 f))).
  assert (HP : P = true -> posb (- side f p) = posb (w - px p)).
  { intros E. apply all_pos in E. rewrite H by lra. apply posb_ext. split; intros K; nra. }
  assert (HM : M = true -> posb (side f p) = posb (w - px p)).
  { intros E. apply all_pos in E. rewrite H by lra. apply posb_ext. split; intros K; nra. }
  destruct P, M; rewrite ?HP, ?HM by auto; rewrite ?andb_true_r, ?andb_false_r; destruct (posb (w - px p)); cbn [b2r andb]; lra.
Qed.

(** The line of an edge, projected along the first axis: y = b0 + b1 z. *)
Definition b0 a b := (py a * pz b - py b * pz a) / (pz b - pz a).
Definition b1 a b := (py b - py a) / (pz b - pz a).
Definition line a b z := b0 a b + b1 a b * z.
Definition sign z a b : R := b2r (posb (pz b - z)) - b2r (posb (pz a - z)).
Lemma rho_line a b : rho a b = sign (pz p) a b * b2r (posb (line a b (pz p) - py p)).
Proof.
  assert (H : pz b - pz a <> 0 -> D2 a b = (pz b - pz a) * (line a b (pz p) - py p)).
  { intros N. unfold D2, line, b0, b1. field. exact N. }
  unfold rho, sign. set (w := line a b (pz p)) in *. clearbody w. unfold posb at 1 2 4 5 7 8.
  destruct (Rlt_dec 0 (pz b - pz p)), (Rlt_dec 0 (pz a - pz p)); cbn [negb andb b2r]; try lra.
  - replace (posb (D2 a b)) with (posb (w - py p)); [lra|]. rewrite H by lra. apply posb_ext. split; intros K; nra.
  - replace (posb (- D2 a b)) with (posb (w - py p)); [lra|]. rewrite H by lra. apply posb_ext. split; intros K; nra.
Qed.
End Point.

(** ** General position: the affine forms that must not vanish *)
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

(** ** Almost all points (x, y, z) *)
Definition ae3 (P : R -> R -> R -> Prop) := ae (fun z => ae (fun y => ae (fun x => P x y z))).
Lemma ae3_imp (P Q : R -> R -> R -> Prop) : (forall x y z, P x y z -> Q x y z) -> ae3 P -> ae3 Q.
Proof. intros H. apply ae_imp. intros z. apply ae_imp. intros y. apply ae_imp. auto. Qed.
Lemma ae3_and P Q : ae3 P -> ae3 Q -> ae3 (fun x y z => P x y z /\ Q x y z).
Proof.
  intros H H'. apply ae_imp with (2 := ae_and _ _ H H'). intros z [Hz Hz'].
  apply ae_imp with (2 := ae_and _ _ Hz Hz'). intros y [Hy Hy']. apply ae_and; auto.
Qed.
Lemma ae3_all (P : R -> R -> R -> Prop) : (forall x y z, P x y z) -> ae3 P.
Proof. intros H. apply ae_all. intros z. apply ae_all. intros y. apply ae_all. auto. Qed.
Lemma ae3_forall {A} (P : A -> R -> R -> R -> Prop) l : (forall a, In a l -> ae3 (P a)) -> ae3 (fun x y z => forall a, In a l -> P a x y z).
Proof.
  induction l as [|a l IH]; intros H; [apply ae3_all; simpl; tauto|].
  apply ae3_imp with (P := fun x y z => P a x y z /\ forall b, In b l -> P b x y z).
  - intros x y z [H1 H2] b [<-|Hb]; auto.
  - apply ae3_and; [apply H; simpl; auto | apply IH; intros; apply H; simpl; auto].
Qed.
(** Almost no point is on a given plane. *)
Lemma ae3_affine g : affine g -> (exists p, g p <> 0) -> ae3 (fun x y z => g (Point x y z) <> 0).
Proof.
  intros [a [b [c [d H]]]] [p Hp]. rewrite H in Hp.
  assert (E : forall x y z, g (Point x y z) = a * x + b * y + c * z + d) by (intros; rewrite H; auto).
  destruct (Req_dec a 0) as [A|A].
  - destruct (Req_dec b 0) as [B|B].
    + destruct (Req_dec c 0) as [C|C].
      * apply ae3_all. intros x y z. rewrite E, A, B, C. rewrite A, B, C in Hp. lra.
      * apply ae_imp with (2 := ae_neq (- d / c)). intros z Hz. apply ae_all. intros y. apply ae_all. intros x K. apply Hz.
        rewrite E, A, B in K. apply Rmult_eq_reg_l with c; auto. field_simplify_eq; auto. lra.
    + apply ae_all. intros z. apply ae_imp with (2 := ae_neq (- (c * z + d) / b)). intros y Hy. apply ae_all. intros x K. apply Hy.
      rewrite E, A in K. apply Rmult_eq_reg_l with b; auto. field_simplify_eq; auto. lra.
  - apply ae_all. intros z. apply ae_all. intros y. apply ae_imp with (2 := ae_neq (- (b * y + c * z + d) / a)). intros x Hx K. apply Hx.
    rewrite E in K. apply Rmult_eq_reg_l with a; auto. field_simplify_eq; auto. lra.
Qed.
Lemma good_ae t : 0 < vol t -> ae3 (fun x y z => forall i, In i I4 -> good (Point x y z) (facet t i)).
Proof.
  intros V. apply ae3_forall. intros i Hi.
  apply ae3_imp with (P := fun x y z => forall g, In g (forms (facet t i)) -> g (Point x y z) <> 0); [intros; apply forms_good; auto|].
  apply (ae3_forall (fun g x y z => g (Point x y z) <> 0)). intros g Hg.
  assert (VF : forall v, In g (vertex_forms v) -> affine g /\ exists z, g z <> 0).
  { intros v Iv. simpl in Iv. destruct Iv as [<-|[<-|[<-|[]]]].
    - split; [exists (-1), 0, 0, (px v); intros; ring|]. exists (Point (px v + 1) 0 0). cbn. lra.
    - split; [exists 0, (-1), 0, (py v); intros; ring|]. exists (Point 0 (py v + 1) 0). cbn. lra.
    - split; [exists 0, 0, (-1), (pz v); intros; ring|]. exists (Point 0 0 (pz v + 1)). cbn. lra. }
  assert (AF : affine g /\ exists z, g z <> 0); [|apply ae3_affine; tauto].
  unfold forms in Hg. rewrite !in_app_iff in Hg. destruct Hg as [Hg|[Hg|[Hg|Hg]]]; eauto.
  destruct Hg as [<-|[<-|[<-|[<-|[]]]]]; try apply edge_form_ok.
  split; [apply aff_o|]. exists (centroid t). pose proof (cen_inter t V i Hi). unfold coord in *. lra.
Qed.

(** ** The volume of a tetrahedron by slices *)
Section Slices.
Variables (M : R) (t : tetrahedron).
Hypothesis V : 0 < vol t.
Hypothesis B : forall v, In v (verts t) -> bnd M v.

Definition I3 := [0; 1; 2]%nat.
Definition ends f (e : nat) : point * point := match e with 0 => (t1 f, t2 f) | 1 => (t2 f, t3 f) | _ => (t3 f, t1 f) end%nat.
Definition tail (ie : nat * nat) := fst (ends (facet t (fst ie)) (snd ie)).
Definition tip (ie : nat * nat) := snd (ends (facet t (fst ie)) (snd ie)).
Definition edges4 := list_prod I4 I3.

(** The length of the part of t on the line over (y, z); the area of its part in the plane at height z. *)
Definition chord (y z : R) := rsum (fun i => - sigma (Point 0 y z) (facet t i) * height (facet t i) y z) I4.
Definition upto f y z := cubic (a0 f + a2 f * z) (a1 f) 0 y.
Definition slice (z : R) := rsum (fun ie => - sign z (tail ie) (tip ie) * upto (facet t (fst ie)) (line (tail ie) (tip ie) z) z) edges4.

Lemma outside x y z : M < Rabs x \/ M < Rabs y \/ M < Rabs z -> insideb t (Point x y z) = false.
Proof.
  intros H. apply bfalse. intros I. apply interb_t in I.
  pose proof (L_sum t (Point x y z)) as S. pose proof (L_bary t (Point x y z)) as E.
  pose proof (I 0%nat ltac:(simpl; auto)) as I0. pose proof (I 1%nat ltac:(simpl; auto)) as I1.
  pose proof (I 2%nat ltac:(simpl; auto)) as I2. pose proof (I 3%nat ltac:(simpl; auto)) as I3'.
  set (a := coord t 0 _) in *. set (b := coord t 1 _) in *. set (c := coord t 2 _) in *. set (d := coord t 3 _) in *. clearbody a b c d.
  destruct (B (va t) ltac:(simpl; auto)) as [A1 [A2 A3]]. destruct (B (vb t) ltac:(simpl; auto)) as [B1 [B2 B3]].
  destruct (B (vc t) ltac:(simpl; auto)) as [C1 [C2 C3]]. destruct (B (vd t) ltac:(simpl; auto)) as [D1 [D2' D3]].
  assert (K : forall u p q r s, vol t * u = a * p + b * q + (c * r + d * s) -> Rabs p <= M -> Rabs q <= M -> Rabs r <= M -> Rabs s <= M -> Rabs u <= M).
  { clear - S V I0 I1 I2 I3'. intros u p q r s E P Q R' S'.
    assert (X : forall p, Rabs p <= M -> - M <= p <= M).
    { intros w Hw. pose proof (Rle_abs w). pose proof (Rle_abs (- w)). rewrite Rabs_Ropp in *. lra. }
    apply X in P, Q, R', S'. apply Rabs_le. split; apply Rmult_le_reg_l with (vol t); auto; rewrite E, <- S; nra. }
  pose proof (f_equal px E) as Ex. pose proof (f_equal py E) as Ey. pose proof (f_equal pz E) as Ez.
  unfold scale, add in Ex, Ey, Ez; cbn [px py pz] in Ex, Ey, Ez.
  destruct H as [H|[H|H]]; [apply K in Ex|apply K in Ey|apply K in Ez]; auto; lra.
Qed.

Lemma chord_integral y z : ae (fun x => forall i, In i I4 -> good (Point x y z) (facet t i)) ->
  integral M (fun x => b2r (insideb t (Point x y z))) (chord y z).
Proof.
  intros G. unfold chord.
  apply (integral_steps I4 (fun i => height (facet t i) y z) (fun i _ => - sigma (Point 0 y z) (facet t i)) (fun i x => - sigma (Point 0 y z) (facet t i) * x)).
  - intros i x _. apply linear_primitive.
  - intros x. destruct (ae_exists _ G) as [x' G']. rewrite rsum_mulr, rsum_opp.
    change (- rsum (fun i => sigma (Point x' y z) (facet t i)) I4 * x = 0). rewrite sigma_closed by auto. ring.
  - revert G. apply ae_imp. intros x G. rewrite ray by auto. rewrite <- rsum_opp. apply rsum_ext. intros i _.
    rewrite cross_height. cbn [px py pz]. change (sigma (Point x y z) (facet t i)) with (sigma (Point 0 y z) (facet t i)). ring.
  - apply ae_all. intros x Hx. rewrite outside; auto.
Qed.
Lemma chord_steps x y z : (forall i, In i I4 -> good (Point x y z) (facet t i)) ->
  chord y z = rsum (fun ie => b2r (posb (line (tail ie) (tip ie) z - y)) * (- sign z (tail ie) (tip ie) * height (facet t (fst ie)) y z)) edges4.
Proof.
  intros G. unfold edges4. rewrite rsum_prod. unfold chord. apply rsum_ext. intros i Hi.
  change (sigma (Point 0 y z) (facet t i)) with (sigma (Point x y z) (facet t i)). rewrite sigma_rho by auto. rewrite !rho_line.
  cbn [rsum I3]. unfold tail, tip; cbn [fst snd ends px py pz]. ring.
Qed.
Lemma slice_integral z : ae (fun y => ae (fun x => forall i, In i I4 -> good (Point x y z) (facet t i))) ->
  integral M (fun y => chord y z) (slice z).
Proof.
  intros G. unfold slice.
  apply (integral_steps edges4 (fun ie => line (tail ie) (tip ie) z) (fun ie y => - sign z (tail ie) (tip ie) * height (facet t (fst ie)) y z)
    (fun ie y => - sign z (tail ie) (tip ie) * upto (facet t (fst ie)) y z)).
  - intros ie y _. apply (derivable_pt_lim_scal (fun y => upto (facet t (fst ie)) y z)). unfold upto, height.
    replace (a0 (facet t (fst ie)) + a1 (facet t (fst ie)) * y + a2 (facet t (fst ie)) * z)
      with (a0 (facet t (fst ie)) + a2 (facet t (fst ie)) * z + a1 (facet t (fst ie)) * y + 0 * (y * y)) by ring.
    apply cubic_primitive.
  - intros y. unfold edges4. rewrite rsum_prod. apply rsum_zero. intros i _. cbn [rsum I3]. unfold tail, tip, sign; cbn [fst snd ends]. ring.
  - revert G. apply ae_imp. intros y G. destruct (ae_exists _ G) as [x G']. apply (chord_steps x); auto.
  - revert G. apply ae_imp. intros y G H. assert (M0 : 0 < M + 1).
    { destruct (B (va t) ltac:(simpl; auto)) as [A1 _]. pose proof (Rabs_pos (px (va t))). lra. }
    destruct (chord_integral y z G) as [F [P [Z V']]].
    apply (integral_zero (M + 1) (fun x => b2r (insideb t (Point x y z)))); auto.
    + exists F. split; auto. split; intros; [apply Z | apply V']; lra.
    + apply ae_all. intros x. rewrite outside; auto.
Qed.

(** The area as a quadratic polynomial between the heights of the vertices. *)
Definition k0 ie := let f := facet t (fst ie) in let m := b0 (tail ie) (tip ie) in a0 f * m + a1 f * (m * m) / 2.
Definition k1 ie := let f := facet t (fst ie) in let m := b0 (tail ie) (tip ie) in let n := b1 (tail ie) (tip ie) in a0 f * n + a2 f * m + a1 f * (m * n).
Definition k2 ie := let f := facet t (fst ie) in let n := b1 (tail ie) (tip ie) in a2 f * n + a1 f * (n * n) / 2.
Definition deep ie z := cubic (k0 ie) (k1 ie) (k2 ie) z.
Lemma upto_line ie z : upto (facet t (fst ie)) (line (tail ie) (tip ie) z) z = k0 ie + k1 ie * z + k2 ie * (z * z).
Proof. unfold upto, cubic, line, k0, k1, k2. cbv zeta. field. Qed.

(** Simpson's rule. *)
Lemma edge_value ie : let a := tail ie in let b := tip ie in let f := facet t (fst ie) in
  deep ie (pz b) - deep ie (pz a) = (pz b - pz a) / 6 * (upto f (py a) (pz a) + 4 * upto f ((py a + py b) / 2) ((pz a + pz b) / 2) + upto f (py b) (pz b)).
Proof.
  cbv zeta. destruct (Req_dec (pz (tail ie)) (pz (tip ie))) as [E|N]; [rewrite E; lra|].
  set (a := tail ie) in *. set (b := tip ie) in *. set (f := facet t (fst ie)).
  assert (N' : pz b - pz a <> 0) by (intros K; apply N; lra).
  assert (L1 : py a = line a b (pz a)) by (unfold line, b0, b1; field; exact N').
  assert (L2 : py b = line a b (pz b)) by (unfold line, b0, b1; field; exact N').
  assert (L3 : (py a + py b) / 2 = line a b ((pz a + pz b) / 2)) by (unfold line, b0, b1; field; exact N').
  rewrite L3. rewrite L1 at 1. rewrite L2 at 1. unfold f, a, b. rewrite !upto_line. unfold deep, cubic. field.
Qed.
Lemma face_value i : rsum (fun e => deep (i, e) (pz (tip (i, e))) - deep (i, e) (pz (tail (i, e)))) I3
  = shadow (facet t i) * (px (t1 (facet t i)) + px (t2 (facet t i)) + px (t3 (facet t i))) / 6.
Proof.
  cbn [rsum I3]. rewrite !edge_value. unfold tail, tip; cbn [fst snd ends]. set (f := facet t i).
  unfold upto, cubic. destruct (Req_dec (shadow f) 0) as [E|N].
  - assert (D : forall n, n / shadow f = 0) by (intros; unfold Rdiv; rewrite E, Rinv_0; ring).
    unfold a0, a1, a2. rewrite !D, E. field.
  - unfold a0, a1, a2. field_simplify_eq; [|exact N]. unfold shadow. ring.
Qed.
Lemma volume_integral : ae (fun z => ae (fun y => ae (fun x => forall i, In i I4 -> good (Point x y z) (facet t i)))) ->
  integral M slice (vol t / 6).
Proof.
  intros G. set (u := fun ieb : nat * nat * bool => if snd ieb then pz (tip (fst ieb)) else pz (tail (fst ieb))).
  set (s := fun ieb : nat * nat * bool => if snd ieb then -1 else 1).
  replace (vol t / 6) with (rsum (fun ieb : nat * nat * bool => s ieb * deep (fst ieb) (u ieb)) (list_prod edges4 [true; false])).
  2:{ rewrite rsum_prod. cbn [rsum fst snd s u].
      rewrite (rsum_ext _ (fun ie => -1 * (deep ie (pz (tip ie)) - deep ie (pz (tail ie))))) by (intros; unfold s, u; cbn [fst snd]; ring).
      rewrite rsum_mull. unfold edges4. rewrite rsum_prod.
      rewrite (rsum_ext _ (fun i => shadow (facet t i) * (px (t1 (facet t i)) + px (t2 (facet t i)) + px (t3 (facet t i))) / 6)) by (intros; apply face_value).
      unfold shadow, vol. cbn [rsum I4 facet t1 t2 t3]. unf. field. }
  apply (integral_steps (list_prod edges4 [true; false]) u (fun ieb z => s ieb * (k0 (fst ieb) + k1 (fst ieb) * z + k2 (fst ieb) * (z * z))) (fun ieb z => s ieb * deep (fst ieb) z)).
  - intros ieb z _. apply (derivable_pt_lim_scal (deep (fst ieb))). apply cubic_primitive.
  - intros z. rewrite rsum_prod. apply rsum_zero. intros ie _. unfold s; cbn [rsum fst snd]. ring.
  - apply ae_all. intros z. rewrite rsum_prod. unfold slice. apply rsum_ext. intros ie _.
    rewrite upto_line. unfold s, u, sign; cbn [rsum fst snd]. ring.
  - revert G. apply ae_imp. intros z G H. assert (M0 : 0 < M + 1).
    { destruct (B (va t) ltac:(simpl; auto)) as [A1 _]. pose proof (Rabs_pos (px (va t))). lra. }
    destruct (slice_integral z G) as [F [P [Z V']]].
    apply (integral_zero (M + 1) (fun y => chord y z)); auto.
    + exists F. split; auto. split; intros; [apply Z | apply V']; lra.
    + revert G. apply ae_imp. intros y G. destruct (chord_integral y z G) as [F' [P' [Z' V'']]].
      apply (integral_zero (M + 1) (fun x => b2r (insideb t (Point x y z)))); auto.
      * exists F'. split; auto. split; intros; [apply Z' | apply V'']; lra.
      * apply ae_all. intros x. rewrite outside; auto.
Qed.
End Slices.
