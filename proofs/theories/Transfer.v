(** * From lattice coordinates to Euclidean space

    Everything that a tiling is, but its angles and circumspheres, is affine: it
    can be proved in lattice coordinates, where the lattice is h Z^3, and moved
    to Euclidean space by x |-> (x1 l1 + x2 l2 + x3 l3) / h. *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Domain Euclid Bounds.
Import ListNotations.
Open Scope R_scope.

Section Transfer.
Variables (r : nat) (Hs : list half_space).
Variables (N : nat) (T : nat -> tetrahedron) (h : R) (l1 l2 l3 : point).
Hypothesis h_pos : 0 < h.
Hypothesis dl0 : det l1 l2 l3 <> 0.
Hypothesis Hvol : forall k, (k < N)%nat -> 0 < vol (T k).
Let b1 := scale (/ h) l1.
Let b2 := scale (/ h) l2.
Let b3 := scale (/ h) l3.
Definition Pk (k : nat) := Et b1 b2 b3 (T k).

Lemma det_scl : det b1 b2 b3 = / h * / h * / h * det l1 l2 l3.
Proof. unfold b1, b2, b3. unf. ring. Qed.
Lemma det_scl0 : det b1 b2 b3 <> 0.
Proof.
  rewrite det_scl. pose proof (Rinv_0_lt_compat h h_pos).
  apply Rmult_integral_contrapositive_currified; auto.
  assert (0 < / h * / h * / h); [|lra]. repeat apply Rmult_lt_0_compat; auto.
Qed.
Lemma E_vec n : E b1 b2 b3 (vec h n) = lattice_vector l1 l2 l3 n.
Proof.
  destruct n as [[x y] z]. unfold E, at_coordinates, vec, lattice_vector, at_coordinates, b1, b2, b3. apply point_eq; unf; field; lra.
Qed.
Lemma tile_eq k n : translate (lattice_vector l1 l2 l3 n) (Pk k) = Et b1 b2 b3 (piece T h (k, n)).
Proof. unfold piece; cbn [fst snd]. rewrite Et_ttr, E_vec. auto. Qed.


Lemma E_scaled x : E b1 b2 b3 x = at_coordinates l1 l2 l3 (scale (/ h) x).
Proof. unfold E, at_coordinates, b1, b2, b3. apply point_eq; unf; ring. Qed.
Lemma at_coordinates_E x : at_coordinates l1 l2 l3 x = E b1 b2 b3 (scale h x).
Proof. rewrite E_scaled. f_equal. apply point_eq; unf; field; lra. Qed.

(** The half-spaces in basis coordinates: x with level H (h x) >= 0. *)
Definition descale (H : half_space) := HalfSpace (normal H) (offset H / h).
Lemma level_descale H x : h * level (descale H) x = level H (scale h x).
Proof. unfold level, descale, dot, scale; cbn [normal offset px py pz]. field. lra. Qed.

Notation valid := (valid N (latb r)).
Lemma valid_is_tile c : is_tile r N c <-> valid c.
Proof. unfold is_tile, Degree.valid. rewrite latb_iff. tauto. Qed.
Lemma tile_piece c : tile l1 l2 l3 Pk c = Et b1 b2 b3 (piece T h c).
Proof. destruct c as [k n]. apply tile_eq. Qed.
Lemma cv c : valid c -> 0 < vol (piece T h c).
Proof. intros [H _]. unfold piece. rewrite vol_ttr. auto. Qed.

Hypothesis Hin : forall c x, valid c -> closed (piece T h c) x -> forall H, In H Hs -> 0 <= level H x.
Hypothesis Hcov : forall x, (forall H, In H Hs -> 0 <= level H x) -> exists c, valid c /\ closed (piece T h c) x.
Hypothesis Hdis : forall x c c', valid c -> valid c' ->
  inside (piece T h c) x -> closed (piece T h c') x -> c = c'.
Hypothesis Hftf : forall x v c c', valid c -> valid c' ->
  closed (piece T h c) x -> closed (piece T h c') x -> carT (piece T h c) x v -> carT (piece T h c') x v.
Hypothesis Hrange : forall M, exists K : list cell, forall c y, valid c -> near M org y -> closed (piece T h c) y -> In c K.

Lemma aff_bound f M : affine f -> exists C, forall X, near M org X -> Rabs (f X) < C.
Proof.
  intros [a [b [c [d H]]]]. exists (Rabs a * M + Rabs b * M + Rabs c * M + Rabs d + 1).
  intros X [A [B C]]. cbn [org px py pz] in *. rewrite Rminus_0_r in *. rewrite H.
  assert (Q : forall u v, Rabs v < M -> Rabs (u * v) <= Rabs u * M).
  { intros u v Hv. rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos | lra]. }
  pose proof (Q a _ A). pose proof (Q b _ B). pose proof (Q c _ C).
  pose proof (Rabs_triang (a * px X + b * py X + c * pz X) d).
  pose proof (Rabs_triang (a * px X + b * py X) (c * pz X)).
  pose proof (Rabs_triang (a * px X) (b * py X)). lra.
Qed.
Lemma Einv_bound M : exists M', forall X, near M org X -> near M' org (Einv b1 b2 b3 X).
Proof.
  pose proof det_scl0 as D0. set (dl := det b1 b2 b3) in *.
  assert (A1 : affine (fun X => px (Einv b1 b2 b3 X))).
  { exists ((py b2 * pz b3 - pz b2 * py b3) / dl), ((pz b2 * px b3 - px b2 * pz b3) / dl), ((px b2 * py b3 - py b2 * px b3) / dl), 0.
    intros X. unfold Einv; cbn [px]. fold dl. unfold det. field. auto. }
  assert (A2 : affine (fun X => py (Einv b1 b2 b3 X))).
  { exists ((py b3 * pz b1 - pz b3 * py b1) / dl), ((pz b3 * px b1 - px b3 * pz b1) / dl), ((px b3 * py b1 - py b3 * px b1) / dl), 0.
    intros X. unfold Einv; cbn [py]. fold dl. unfold det. field. auto. }
  assert (A3 : affine (fun X => pz (Einv b1 b2 b3 X))).
  { exists ((py b1 * pz b2 - pz b1 * py b2) / dl), ((pz b1 * px b2 - px b1 * pz b2) / dl), ((px b1 * py b2 - py b1 * px b2) / dl), 0.
    intros X. unfold Einv; cbn [pz]. fold dl. unfold det. field. auto. }
  destruct (aff_bound _ M A1) as [C1 H1], (aff_bound _ M A2) as [C2 H2], (aff_bound _ M A3) as [C3 H3].
  exists (Rmax C1 (Rmax C2 C3)). intros X HX. specialize (H1 X HX). specialize (H2 X HX). specialize (H3 X HX).
  pose proof (Rmax_l C1 (Rmax C2 C3)). pose proof (Rmax_r C1 (Rmax C2 C3)). pose proof (Rmax_l C2 C3). pose proof (Rmax_r C2 C3).
  unfold near, org; cbn [px py pz].
  rewrite !Rminus_0_r. repeat split; lra.
Qed.


Theorem transfer : face_to_face_tiling l1 l2 l3 r (half_spaces l1 l2 l3 (map descale Hs)) N Pk.
Proof.
  pose proof det_scl0 as D0.
  constructor; auto.
  - intros c Hc. apply valid_is_tile in Hc. rewrite tile_piece, vol_Et. pose proof (cv c Hc).
    apply Rmult_integral_contrapositive_currified; lra.
  - intros M. destruct (Einv_bound M) as [M' HM]. destruct (Hrange M') as [F HF]. exists F.
    intros c X Hc HX H. apply valid_is_tile in Hc. rewrite tile_piece in H. rewrite <- (E_Einv b1 b2 b3 D0 X), hull_Et in H by auto.
    apply HF with (y := Einv b1 b2 b3 X); auto. apply hull_closed; auto. apply cv; auto.
  - intros c X Hc H. apply valid_is_tile in Hc. rewrite tile_piece in H.
    rewrite <- (E_Einv b1 b2 b3 D0 X) in H |- *. rewrite hull_Et in H by auto. apply hull_closed in H; [|apply cv; auto].
    rewrite E_scaled. eexists. split; [reflexivity|]. intros H' HI. apply in_map_iff in HI as [H0 [<- HI]].
    pose proof (Hin c _ Hc H H0 HI) as L. apply Rmult_le_reg_l with h; auto. rewrite Rmult_0_r, level_descale.
    replace (scale h (scale (/ h) (Einv b1 b2 b3 X))) with (Einv b1 b2 b3 X); auto.
    apply point_eq; unfold scale; cbn [px py pz]; field; lra.
  - intros X [x [-> HX]]. rewrite at_coordinates_E.
    destruct (Hcov (scale h x)) as [c [Hc C]].
    { intros H HI. rewrite <- level_descale. apply Rmult_le_pos; [lra|]. apply HX, in_map; auto. }
    exists c. split; [apply valid_is_tile; auto|]. rewrite tile_piece. apply hull_Et; auto. apply hull_closed; auto. apply cv; auto.
  - intros X c c' Hc Hc' H H'. apply valid_is_tile in Hc, Hc'. rewrite tile_piece in H, H'.
    rewrite <- (E_Einv b1 b2 b3 D0 X) in H, H'. rewrite open_hull_Et in H by auto. rewrite hull_Et in H' by auto.
    apply open_hull_inter in H; [|apply cv; auto]. apply hull_closed in H'; [|apply cv; auto].
    eapply Hdis; [| |exact H|exact H']; auto.
  - intros X c c' Hc Hc' H H'. apply valid_is_tile in Hc, Hc'. rewrite tile_piece in *. rewrite tile_piece in *.
    rewrite <- (E_Einv b1 b2 b3 D0 X) in *. rewrite hull_Et in H, H' by auto.
    apply common_Et.
    pose proof (cv c Hc) as V. pose proof (cv c' Hc') as V'.
    pose proof (proj1 (hull_closed _ _ V) H) as C. pose proof (proj1 (hull_closed _ _ V') H') as C'.
    destruct H as [a [b [c0 [d [A [B [C0 [Dd [S Hx]]]]]]]]].
    exists a, b, c0, d. repeat split; auto; intros P;
    apply carT_vert with (x := Einv b1 b2 b3 X); (eapply Hftf; [| |exact C|exact C'|]; auto);
    exists a, b, c0, d; repeat split; auto.
Qed.

(** ** The circumscribed ball of a tile, and powers as distances *)
Variable G : gram.
Hypothesis HG : has_gram G b1 b2 b3.

Definition cross (u v : point) := Point (py u * pz v - pz u * py v) (pz u * px v - px u * pz v) (px u * py v - py u * px v).
Definition circumcentre (t : tetrahedron) : point :=
  let e1 := sub (vb t) (va t) in let e2 := sub (vc t) (va t) in let e3 := sub (vd t) (va t) in
  add (va t) (scale (/ (2 * vol t)) (add (scale (dot e1 e1) (cross e2 e3)) (add (scale (dot e2 e2) (cross e3 e1)) (scale (dot e3 e3) (cross e1 e2))))).
Lemma circumscribed_centre t : vol t <> 0 -> circumscribed t (circumcentre t) (distance_squared (va t) (circumcentre t)).
Proof.
  intros V. unfold circumcentre. set (e1 := sub (vb t) (va t)). set (e2 := sub (vc t) (va t)). set (e3 := sub (vd t) (va t)).
  assert (EV : vol t = det e1 e2 e3) by reflexivity. rewrite EV in *.
  set (w := scale (/ (2 * det e1 e2 e3)) _).
  assert (K : 2 * dot e1 w = dot e1 e1 /\ 2 * dot e2 w = dot e2 e2 /\ 2 * dot e3 w = dot e3 e3).
  { unfold w. clearbody e1 e2 e3. clear w EV. repeat split; unfold cross, dot at 1; cbn [px py pz]; unfold scale, add; cbn [px py pz];
    unfold det in *; field_simplify_eq; auto; unfold dot; ring. }
  destruct K as [K1 [K2 K3]].
  assert (Q : forall v e, v = add (va t) e -> 2 * dot e w = dot e e -> distance_squared v (add (va t) w) = distance_squared (va t) (add (va t) w)).
  { intros v e -> Ke. unfold distance_squared. unfold dot in *. unf. lra. }
  intros v Hv. simpl in Hv. destruct Hv as [<-|[<-|[<-|[<-|[]]]]]; [reflexivity|apply (Q _ e1)|apply (Q _ e2)|apply (Q _ e3)]; auto;
  apply point_eq; unfold e1, e2, e3; unf; ring.
Qed.

(** ** The circumradius, from the Gram matrix m of the three edges at one vertex

    With C the cofactors of m: R^2 = sum_ij m_ii C_ij m_jj / (4 det m). *)
Definition radius_form m11 m22 m33 m12 m13 m23 : R :=
  m11 * (m11 * (m22 * m33 - m23 * m23)) + m22 * (m22 * (m11 * m33 - m13 * m13)) + m33 * (m33 * (m11 * m22 - m12 * m12))
  + 2 * (m11 * (m22 * (m13 * m23 - m12 * m33)) + m11 * (m33 * (m12 * m23 - m13 * m22)) + m22 * (m33 * (m12 * m13 - m11 * m23))).
Definition gram_form m11 m22 m33 m12 m13 m23 : R :=
  m11 * (m22 * m33 - m23 * m23) + m12 * (m13 * m23 - m12 * m33) + m13 * (m12 * m23 - m13 * m22).
Lemma circumradius t : vol t <> 0 ->
  let e1 := sub (vb t) (va t) in let e2 := sub (vc t) (va t) in let e3 := sub (vd t) (va t) in
  let on f : R := f (dot e1 e1) (dot e2 e2) (dot e3 e3) (dot e1 e2) (dot e1 e3) (dot e2 e3) in
  0 < on gram_form /\ 4 * on gram_form * distance_squared (va t) (circumcentre t) = on radius_form.
Proof.
  intros V e1 e2 e3 on. unfold circumcentre. fold e1 e2 e3. assert (EV : vol t = det e1 e2 e3) by reflexivity. rewrite EV in *.
  assert (D : on gram_form = det e1 e2 e3 * det e1 e2 e3).
  { unfold on, gram_form, dot, det. ring. }
  split.
  - rewrite D. destruct (Rlt_dec 0 (det e1 e2 e3)); nra.
  - set (w := add (scale (dot e1 e1) (cross e2 e3)) (add (scale (dot e2 e2) (cross e3 e1)) (scale (dot e3 e3) (cross e1 e2)))).
    assert (X : on radius_form = dot w w).
    { assert (BC : forall a b c d, dot (cross a b) (cross c d) = dot a c * dot b d - dot a d * dot b c) by (intros; unfold dot, cross; cbn [px py pz]; ring).
      assert (BL : forall p q r a b c, dot (add (scale p a) (add (scale q b) (scale r c))) (add (scale p a) (add (scale q b) (scale r c))) =
        p * p * dot a a + q * q * dot b b + r * r * dot c c + 2 * (p * q * dot a b + p * r * dot a c + q * r * dot b c)) by (intros; unfold dot; unf; ring).
      assert (SY : forall a b, dot a b = dot b a) by (intros; unfold dot; ring).
      unfold w. rewrite BL, !BC. rewrite (SY e3 e1), (SY e2 e1), (SY e3 e2). unfold on, radius_form. ring. }
    rewrite D, X. clearbody w. set (dd := det e1 e2 e3) in *. clearbody dd.
    unfold distance_squared, dot. unf. field. auto.
Qed.
(** R^2 / l and p / q compare as q X and 4 p g l. *)
Lemma ratio_rule o R2 g X p q l : 0 < g -> 4 * g * R2 = X -> 0 < q -> 0 < l ->
  compares o (q * X) (4 * p * g * l) -> compares o (R2 / l) (p / q).
Proof.
  intros G0 <- Q L H.
  assert (K : 0 < 4 * g * (q * l)) by (repeat apply Rmult_lt_0_compat; lra).
  assert (E1 : R2 / l * (4 * g * (q * l)) = q * (4 * g * R2)) by (field; lra).
  assert (E2 : p / q * (4 * g * (q * l)) = 4 * p * g * l) by (field; lra).
  rewrite <- E1, <- E2 in H. destruct o; cbn [compares] in *.
  - apply (Rmult_lt_reg_r _ _ _ K H).
  - apply (Rmult_le_reg_r _ _ _ K H).
  - apply (Rmult_le_reg_r _ _ _ K H).
  - apply (Rmult_lt_reg_r _ _ _ K H).
Qed.
Lemma radius_rule t o p q l : vol t <> 0 -> 0 < q -> 0 < l ->
  let e1 := sub (vb t) (va t) in let e2 := sub (vc t) (va t) in let e3 := sub (vd t) (va t) in
  let on f : R := f (dot e1 e1) (dot e2 e2) (dot e3 e3) (dot e1 e2) (dot e1 e3) (dot e2 e3) in
  compares o (q * on radius_form) (4 * p * on gram_form * l) ->
  compares o (distance_squared (va t) (circumcentre t) / l) (p / q).
Proof.
  intros V Q L e1 e2 e3 on H. destruct (circumradius t V) as [G0 E0]. cbv zeta in G0, E0. fold e1 e2 e3 in G0, E0.
  apply (ratio_rule o _ _ _ p q l G0 E0); auto.
Qed.
End Transfer.
