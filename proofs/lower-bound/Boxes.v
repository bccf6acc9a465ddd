(** * docs/lower-bound.md, section 14: the four claims on a box of angles

    A point of a box has angles A, B, C' between the lower and the upper ones.  [box_side] bounds x of the side opposite A
    from below by a linear function there. *)
From Coq Require Import Reals Lra Psatz.
From LowerBound Require Import Calculus Corners Triangles Sides.
Open Scope R_scope.

Section Box.
Variable theta : R.
Hypothesis range : 2 * PI / 5 < theta < 5 * PI / 12.
Let s := sin theta.
Let c := cos theta.
Notation mid := (mid theta).
Notation xs := (xs theta).
Let mt : Sides.mid theta theta := mid_theta theta range.
Lemma up x : mid x -> upto theta theta x.
Proof. intros H. exact H. Qed.

Lemma slope_pos : 0 <= sin (a0 theta) / s * (c / (1 - c)).
Proof.
  pose proof (Sides.numbers theta range) as [N1 [N2 [_ [N3 _]]]]. apply Rmult_le_pos; left; apply Rdiv_lt_0_compat; unfold c, s; lra.
Qed.
Lemma xs_mono A B C' A' B' C'' : mid A -> mid B -> mid C' -> mid A' -> mid B' -> mid C'' -> A <= A' -> B <= B' -> C' <= C'' -> xs A B C' <= xs A' B' C''.
Proof.
  intros HA HB HC HA' HB' HC' LA LB LC. pose proof (D_pos theta range) as DP. pose proof slope_pos as SP. unfold s, c in SP.
  pose proof (own theta range theta mt A A' B C' HA HA' HB HC LA) as O1. pose proof (other theta range theta mt A' B B' C' HA' HB HB' HC LB) as O2.
  pose proof (other theta range theta mt A' C' C'' B' HA' HC HC' HB' LC) as O3. rewrite (xs_sym theta A' C' B'), (xs_sym theta A' C'' B') in O3.
  pose proof (Rmult_le_pos (sin (a0 theta) / sin theta) (A' - A) ltac:(lra) ltac:(lra)).
  pose proof (Rmult_le_pos _ (B' - B) SP ltac:(lra)). pose proof (Rmult_le_pos _ (C'' - C') SP ltac:(lra)). lra.
Qed.
Lemma cos_xs A B C' : mid A -> mid B -> mid C' -> 0 <= xs A B C' <= theta /\ cos (xs A B C') = s ^ 2 * side_cos A B C' - c ^ 2.
Proof. exact (xs_range theta range theta mt A B C'). Qed.
Lemma side_mono A B C' A' B' C'' : mid A -> mid B -> mid C' -> mid A' -> mid B' -> mid C'' -> A <= A' -> B <= B' -> C' <= C'' -> side_cos A' B' C'' <= side_cos A B C'.
Proof.
  intros HA HB HC HA' HB' HC' LA LB LC. pose proof (xs_mono A B C' A' B' C'' HA HB HC HA' HB' HC' LA LB LC) as L.
  destruct (cos_xs A B C' HA HB HC) as [R1 E1]. destruct (cos_xs A' B' C'' HA' HB' HC') as [R2 E2]. pose proof (between theta range).
  pose proof (cos_le _ _ ltac:(apply R1) L ltac:(lra)) as Q. rewrite E1, E2 in Q. pose proof (Sides.numbers theta range) as [_ [N2 _]]. fold s in N2.
  apply Rmult_le_reg_l with (s ^ 2); [nra|lra].
Qed.

Variables lA lB lC hA hB hC : R.
Hypothesis mlA : mid lA. Hypothesis mlB : mid lB. Hypothesis mlC : mid lC.
Hypothesis mhA : mid hA. Hypothesis mhB : mid hB. Hypothesis mhC : mid hC.
Let X1 := xs hA hB hC.
Definition inb l h x := l <= x <= h.
Lemma mid_in l h x : mid l -> mid h -> inb l h x -> mid x.
Proof. unfold Sides.mid, inb. lra. Qed.
(** The sine of the largest side turns differences of cosines into differences of sides. *)
Lemma box_grows A B C' A' B' C'' : inb lA hA A -> inb lB hB B -> inb lC hC C' -> inb lA hA A' -> inb lB hB B' -> inb lC hC C'' -> A <= A' -> B <= B' -> C' <= C'' ->
  s ^ 2 * (side_cos A B C' - side_cos A' B' C'') <= sin X1 * (xs A' B' C'' - xs A B C').
Proof.
  intros IA IB IC IA' IB' IC' LA LB LC. pose proof (mid_in _ _ _ mlA mhA IA) as M1. pose proof (mid_in _ _ _ mlB mhB IB) as M2. pose proof (mid_in _ _ _ mlC mhC IC) as M3.
  pose proof (mid_in _ _ _ mlA mhA IA') as M4. pose proof (mid_in _ _ _ mlB mhB IB') as M5. pose proof (mid_in _ _ _ mlC mhC IC') as M6.
  destruct (cos_xs A B C' M1 M2 M3) as [R1 E1]. destruct (cos_xs A' B' C'' M4 M5 M6) as [R2 E2]. destruct (cos_xs hA hB hC mhA mhB mhC) as [R3 _]. fold X1 in R3.
  pose proof (xs_mono A B C' A' B' C'' M1 M2 M3 M4 M5 M6 LA LB LC) as L. unfold inb in *.
  pose proof (xs_mono A' B' C'' hA hB hC M4 M5 M6 mhA mhB mhC ltac:(lra) ltac:(lra) ltac:(lra)) as L'. fold X1 in L'. pose proof (between theta range).
  pose proof (cos_falls (xs A B C') (xs A' B' C'') X1 ltac:(lra) L L' ltac:(lra)) as F. rewrite E1, E2 in F. lra.
Qed.
Lemma box_own A A' B C' : inb lA hA A -> inb lA hA A' -> inb lB hB B -> inb lC hC C' -> A <= A' ->
  s ^ 2 * sin lA / (sin hB * sin hC) * (A' - A) <= sin X1 * (xs A' B C' - xs A B C').
Proof.
  intros IA IA' IB IC L. eapply Rle_trans; [|apply box_grows; auto; lra].
  pose proof (mid_trig theta range B (mid_in _ _ _ mlB mhB IB)) as [_ [_ B3]]. pose proof (mid_trig theta range C' (mid_in _ _ _ mlC mhC IC)) as [_ [_ C3]].
  pose proof (mid_trig theta range lA mlA) as [_ [_ A3]]. pose proof (Sides.numbers theta range) as [_ [N2 _]]. fold s in N2.
  pose proof (between theta range) as BT. unfold inb, Sides.mid in *.
  pose proof (sin_le B hB ltac:(lra) ltac:(lra) ltac:(lra)) as SB. pose proof (sin_le C' hC ltac:(lra) ltac:(lra) ltac:(lra)) as SC.
  pose proof (cos_falls_at_least A A' lA ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as F. set (P := sin B * sin C'). set (Q := sin hB * sin hC).
  assert (PQ : 0 < P <= Q) by (split; [apply Rmult_lt_0_compat; lra|apply Rmult_le_compat; lra]).
  replace (s ^ 2 * sin lA / Q * (A' - A)) with (s ^ 2 * (sin lA * (A' - A) / Q)) by (field; lra). apply Rmult_le_compat_l; [nra|].
  unfold side_cos. fold P. replace ((cos A + cos B * cos C') / P - (cos A' + cos B * cos C') / P) with ((cos A - cos A') / P) by (field; lra).
  assert (F0 : 0 <= sin lA * (A' - A)) by (apply Rmult_le_pos; lra).
  apply Rle_trans with (sin lA * (A' - A) / P).
  - apply Rmult_le_compat_l; [lra|]. apply Rinv_le_contravar; lra.
  - apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|lra].
Qed.
Lemma box_other A B B' C' : inb lA hA A -> inb lB hB B -> inb lB hB B' -> inb lC hC C' -> B <= B' ->
  s ^ 2 * sin lA / (sin hB * sin hC) * side_cos hC hA hB * (B' - B) <= sin X1 * (xs A B' C' - xs A B C').
Proof.
  intros IA IB IB' IC L. eapply Rle_trans; [|apply box_grows; auto; lra].
  pose proof (mid_in _ _ _ mlA mhA IA) as MA. pose proof (mid_in _ _ _ mlC mhC IC) as MC.
  pose proof (mid_trig theta range A MA) as [_ [_ A3]]. pose proof (mid_trig theta range C' MC) as [_ [_ C3]].
  pose proof (mid_trig theta range lA mlA) as [_ [_ A4]]. pose proof (mid_trig theta range hB mhB) as [_ [_ B4]]. pose proof (mid_trig theta range hC mhC) as [_ [_ C4]].
  pose proof (Sides.numbers theta range) as [_ [N2 _]]. fold s in N2. pose proof (between theta range) as BT.
  set (k := side_cos hC hA hB). assert (K0 : 0 <= k).
  { pose proof (side_cos_range theta range theta mt hC hA hB mhC mhA mhB) as [Q _]. pose proof (k_numbers theta range theta mt) as [_ [Q' _]]. unfold k. lra. }
  set (m := sin lA / (sin hB * sin hC) * k). replace (s ^ 2 * sin lA / (sin hB * sin hC) * k * (B' - B)) with (s ^ 2 * (m * (B' - B))) by (unfold m; field; lra).
  apply Rmult_le_compat_l; [nra|]. enough (side_cos A B' C' - side_cos A B C' <= - m * (B' - B)) by lra.
  set (f' := fun y => - ((cos C' + cos A * cos y) / (sin y * sin y * sin C'))).
  apply (grows_at_most (fun y => side_cos A y C') f'); [exact L| |].
  - intros y Y. assert (MY : mid y) by (apply (mid_in lB hB); auto; unfold inb in *; lra). pose proof (mid_trig theta range y MY) as [_ [_ Y3]]. eapply slope_eq.
    + unfold side_cos. apply slope_div.
      * apply slope_plus; [apply slope_const|]. apply slope_mult; [apply slope_cos, slope_id|apply slope_const].
      * apply slope_mult; [apply slope_sin, slope_id|apply slope_const].
      * apply Rmult_integral_contrapositive_currified; lra.
    + unfold f'. pose proof (squares y) as S.
      apply Rmult_eq_reg_r with (sin y * sin y * sin C'); [|repeat apply Rmult_integral_contrapositive_currified; lra].
      replace (- ((cos C' + cos A * cos y) / (sin y * sin y * sin C')) * (sin y * sin y * sin C')) with (- (cos C' * (sin y * sin y + cos y * cos y) + cos A * cos y)) by (rewrite S; field; lra).
      field. lra.
  - intros y Y. assert (IY : inb lB hB y) by (unfold inb in *; lra). pose proof (mid_in _ _ _ mlB mhB IY) as MY. pose proof (mid_trig theta range y MY) as [_ [_ Y3]].
    unfold f'. apply Ropp_le_contravar.
    replace ((cos C' + cos A * cos y) / (sin y * sin y * sin C')) with (sin A / (sin y * sin C') * side_cos C' A y) by (unfold side_cos; field; lra).
    pose proof (side_mono C' A y hC hA hB MC MA MY mhC mhA mhB ltac:(apply IC) ltac:(apply IA) ltac:(apply IY)) as SM. fold k in SM.
    unfold inb, Sides.mid in *.
    pose proof (sin_le y hB ltac:(lra) ltac:(lra) ltac:(lra)) as SB. pose proof (sin_le C' hC ltac:(lra) ltac:(lra) ltac:(lra)) as SC. pose proof (sin_le lA A ltac:(lra) ltac:(lra) ltac:(lra)) as SA.
    unfold m. apply Rmult_le_compat; try lra.
    + left. apply Rdiv_lt_0_compat; [lra|apply Rmult_lt_0_compat; lra].
    + apply Rmult_le_compat; try lra.
      * left. apply Rinv_0_lt_compat, Rmult_lt_0_compat; lra.
      * apply Rinv_le_contravar; [apply Rmult_lt_0_compat; lra|apply Rmult_le_compat; lra].
Qed.
End Box.

Lemma side_sym x y z : side_cos x y z = side_cos x z y.
Proof. unfold side_cos. rewrite (Rmult_comm (sin y)), (Rmult_comm (cos y)). reflexivity. Qed.
(** x of the side opposite A, from the lower corner of the box *)
Lemma box_side theta (range : 2 * PI / 5 < theta < 5 * PI / 12) lA lB lC hA hB hC A B C' P :
  mid theta lA -> mid theta lB -> mid theta lC -> mid theta hA -> mid theta hB -> mid theta hC ->
  inb lA hA A -> inb lB hB B -> inb lC hC C' -> 0 <= P -> P * (sin hB * sin hC * sin (xs theta hA hB hC)) <= sin theta ^ 2 * sin lA ->
  xs theta lA lB lC + P * (A - lA) + P * side_cos hC hA hB * (B - lB) + P * side_cos hB hC hA * (C' - lC) <= xs theta A B C'.
Proof.
  intros mlA mlB mlC mhA mhB mhC IA IB IC P0 PL.
  assert (JA : inb lA hA lA) by (unfold inb in *; lra). assert (JB : inb lB hB lB) by (unfold inb in *; lra). assert (JC : inb lC hC lC) by (unfold inb in *; lra).
  pose proof (box_own theta range lA lB lC hA hB hC mlA mlB mlC mhA mhB mhC lA A lB lC JA IA JB JC ltac:(apply IA)) as O1.
  pose proof (box_other theta range lA lB lC hA hB hC mlA mlB mlC mhA mhB mhC A lB B lC IA JB IB JC ltac:(apply IB)) as O2.
  pose proof (box_other theta range lA lC lB hA hC hB mlA mlC mlB mhA mhC mhB A lC C' B IA JC IC IB ltac:(apply IC)) as O3.
  rewrite (xs_sym theta hA hC hB), (xs_sym theta A C' B), (xs_sym theta A lC B), (side_sym hB hA hC), (Rmult_comm (sin hC)) in O3.
  pose proof (Sides.numbers theta range) as [N1 [N2 [N3 [N4 [N5 N6]]]]].
  set (s := sin theta) in *. set (c := cos theta) in *. set (k3 := side_cos hC hA hB) in *. set (k2 := side_cos hB hC hA) in *.
  pose proof (mid_theta theta range) as mt.
  assert (K3 : 0 <= k3) by (pose proof (side_cos_range theta range theta mt hC hA hB mhC mhA mhB) as [Q _]; pose proof (k_numbers theta range theta mt) as [_ [Q' _]]; unfold k3; lra).
  assert (K2 : 0 <= k2) by (pose proof (side_cos_range theta range theta mt hB hC hA mhB mhC mhA) as [Q _]; pose proof (k_numbers theta range theta mt) as [_ [Q' _]]; unfold k2; lra).
  destruct (cos_xs theta range hA hB hC mhA mhB mhC) as [R1 E1]. set (X1 := xs theta hA hB hC) in *. fold s c in E1.
  assert (SX : 0 < sin X1).
  { pose proof (between theta range). apply sin_pos. split; [|lra]. apply Rnot_le_lt. intros Z. assert (Z0 : X1 = 0) by lra. rewrite Z0, cos_0 in E1.
    pose proof (side_cos_range theta range theta mt hA hB hC mhA mhB mhC) as [_ Q].
    assert (cos (a0 theta) / (1 - cos (a0 theta)) <= 1) by (apply Rmult_le_reg_r with (1 - cos (a0 theta)); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra).
    assert (s ^ 2 * side_cos hA hB hC <= s ^ 2 * 1) by (apply Rmult_le_compat_l; nra). assert (0 < c * c) by (apply Rmult_lt_0_compat; lra). lra. }
  pose proof (mid_trig theta range hB mhB) as [_ [_ B3]]. pose proof (mid_trig theta range hC mhC) as [_ [_ C3]].
  set (M := s ^ 2 * sin lA / (sin hB * sin hC)) in *.
  assert (PM : P * sin X1 <= M).
  { unfold M. apply Rmult_le_reg_r with (sin hB * sin hC); [apply Rmult_lt_0_compat; lra|].
    replace (s ^ 2 * sin lA / (sin hB * sin hC) * (sin hB * sin hC)) with (s ^ 2 * sin lA) by (field; lra). lra. }
  unfold inb in *. set (W := (A - lA) + k3 * (B - lB) + k2 * (C' - lC)).
  assert (W0 : 0 <= W).
  { pose proof (Rmult_le_pos k3 (B - lB) K3 ltac:(lra)). pose proof (Rmult_le_pos k2 (C' - lC) K2 ltac:(lra)). unfold W. lra. }
  assert (F : P * sin X1 * W <= M * W) by (apply Rmult_le_compat_r; lra).
  assert (G : M * W <= sin X1 * (xs theta A B C' - xs theta lA lB lC)) by (unfold W; lra).
  enough (P * W <= xs theta A B C' - xs theta lA lB lC) by (unfold W in *; lra). apply Rmult_le_reg_l with (sin X1); [exact SX|]. lra.
Qed.
