(** * docs/lower-bound.md, section 14: how a box is decided

    Real numbers are enclosed by integers, in units of 2^-28.  [search] cuts the cube of excesses into boxes, and
    decides each one with the linear bound of Boxes.v. *)
From Coq Require Import Reals Lra Psatz Lia List ZArith Bool.
From LowerBound Require Import Calculus Normals Corners Triangles Sides Boxes Decimals.
Import ListNotations.

(** ** Integers as bounds of real numbers *)
Definition U : Z := 268435456.
Definition down (a : Z) : Z := Z.shiftr a 28.
Definition mulL (a b : Z) : Z := down (a * b)%Z.
Definition mulH (a b : Z) : Z := (down (a * b) + 1)%Z.
Definition divL (a b : Z) : Z := (a * U / b)%Z.
Definition divH (a b : Z) : Z := (a * U / b + 1)%Z.

Open Scope R_scope.
Definition u : R := IZR U.
Lemma u_pos : 0 < u.
Proof. unfold u. apply IZR_lt. reflexivity. Qed.
Lemma down_is a : down a = (a / U)%Z.
Proof. unfold down. rewrite Z.shiftr_div_pow2 by lia. reflexivity. Qed.
Lemma floor_le a b : (0 < b)%Z -> IZR (a / b) * IZR b <= IZR a.
Proof. intros B. rewrite <- mult_IZR. apply IZR_le. pose proof (Z.mul_div_le a b B). lia. Qed.
Lemma floor_gt a b : (0 < b)%Z -> IZR a < IZR (a / b + 1) * IZR b.
Proof. intros B. rewrite <- mult_IZR. apply IZR_lt. pose proof (Z.mul_succ_div_gt a b B). lia. Qed.
Lemma mulL_ok a b x y : (0 <= a)%Z -> (0 <= b)%Z -> IZR a <= u * x -> IZR b <= u * y -> IZR (mulL a b) <= u * (x * y).
Proof.
  intros A B X Y. pose proof u_pos. apply IZR_le in A, B. pose proof (floor_le (a * b) U eq_refl) as F. fold u in F. rewrite mult_IZR in F.
  assert (IZR a * IZR b <= u * x * (u * y)) by (apply Rmult_le_compat; auto). apply Rmult_le_reg_r with u; [lra|]. unfold mulL. rewrite down_is. lra.
Qed.
Lemma mulH_ok a b x y : 0 <= x -> 0 <= y -> u * x <= IZR a -> u * y <= IZR b -> u * (x * y) <= IZR (mulH a b).
Proof.
  intros A B X Y. pose proof u_pos. pose proof (floor_gt (a * b) U eq_refl) as F. fold u in F. rewrite mult_IZR in F.
  assert (u * x * (u * y) <= IZR a * IZR b) by (apply Rmult_le_compat; auto; apply Rmult_le_pos; lra). apply Rmult_le_reg_r with u; [lra|]. unfold mulH. rewrite down_is. lra.
Qed.
Lemma divL_ok a b x y : (0 <= a)%Z -> IZR a <= u * x -> 0 < y -> u * y <= IZR b -> IZR (divL a b) <= u * (x / y).
Proof.
  intros A X Y B. pose proof u_pos. assert (B0 : 0 < IZR b) by (apply Rlt_le_trans with (u * y); [apply Rmult_lt_0_compat; lra|exact B]).
  pose proof (floor_le (a * U) b ltac:(apply lt_IZR; exact B0)) as F. rewrite mult_IZR in F. fold u in F. fold (divL a b) in F. apply IZR_le in A.
  assert (X0 : 0 <= x) by (apply Rmult_le_reg_l with u; lra).
  destruct (Rle_dec (IZR (divL a b)) 0) as [Z|Z].
  - apply Rle_trans with (1 := Z). apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra].
  - apply Rmult_le_reg_r with (u * y); [apply Rmult_lt_0_compat; lra|]. replace (u * (x / y) * (u * y)) with (u * x * u) by (field; lra).
    assert (IZR (divL a b) * (u * y) <= IZR (divL a b) * IZR b) by (apply Rmult_le_compat_l; lra).
    assert (IZR a * u <= u * x * u) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma divH_ok a b x y : 0 <= x -> u * x <= IZR a -> (0 < b)%Z -> IZR b <= u * y -> u * (x / y) <= IZR (divH a b).
Proof.
  intros X A B Y. pose proof u_pos. pose proof (floor_gt (a * U) b B) as F. rewrite mult_IZR in F. fold u in F. fold (divH a b) in F. apply IZR_lt in B.
  assert (Y0 : 0 < y) by (apply Rmult_lt_reg_l with u; lra).
  apply Rmult_le_reg_r with (IZR b); [exact B|].
  assert (E : u * (x / y) * IZR b <= u * x * u).
  { assert (Q : 0 <= x / y) by (apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]).
    replace (u * x * u) with (u * (x / y) * (u * y)) by (field; lra). apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|exact Y]. }
  assert (u * x * u <= IZR a * u) by (apply Rmult_le_compat_r; lra). lra.
Qed.

(** ** The angle 60 degrees + g, by its cosine *)
Definition arc (y : Z) : Z :=
  let t := Z.shiftr ((U / 2 - y) * 1210792) 20 in
  let better g := (let q := down (g * g) in t - Z.shiftr (q * 302698) 20 + Z.shiftr (down (q * g) * 174763) 20)%Z in
  (better (better (better (better t))) - 4000)%Z.
Definition arc_ok (g y : Z) : bool :=
  if (0 <=? g)%Z
  then ((g <=? 75161927) && (400000000 * y * U * U <=? 200000000 * U * U * U - 100000000 * g * g * U - 346412000 * g * U * U + 57504392 * g * g * g))%Z
  else ((-80530636 <=? g) && (40000000000 * y * U * U <=? 20000000000 * U * U * U - 10000000000 * g * g * U - 34641000000 * g * U * U + 5774654700 * g * g * g))%Z.
Lemma cos_low_pos g : 0 <= g <= 0.28 -> 1 / 2 - g * g / 4 - 0.86603 * (g - 0.166 * (g * g * g)) <= cos (PI / 3 + g).
Proof.
  intros G. rewrite cos_plus, cos_PI3, sin_PI3. pose proof (cos_square g). pose proof (sin_cubic g ltac:(lra)) as [_ S]. pose proof root3 as [_ R].
  assert (G2 : 0 <= g * g <= 0.28 * 0.28) by (split; [apply Rmult_le_pos; lra|apply Rmult_le_compat; lra]). assert (G3 : 0 <= g * g * g) by (apply Rmult_le_pos; lra).
  assert (G5 : g * g * g * (g * g) <= g * g * g * (0.28 * 0.28)) by (apply Rmult_le_compat_l; lra).
  assert (S1 : sin g <= g - 0.166 * (g * g * g)) by lra. pose proof (sin_ge_0 g ltac:(lra) ltac:(pose proof PI2_3_2; lra)) as S0.
  assert (sqrt 3 / 2 * sin g <= 0.86603 * (g - 0.166 * (g * g * g))) by (apply Rmult_le_compat; lra). lra.
Qed.
Lemma cos_low_neg g : -0.3 <= g <= 0 -> 1 / 2 - g * g / 4 - 0.866025 * (g - 0.1667 * (g * g * g)) <= cos (PI / 3 + g).
Proof.
  intros G. replace (PI / 3 + g) with (PI / 3 - (- g)) by ring. set (h := - g). rewrite cos_minus, cos_PI3, sin_PI3. pose proof (cos_square h). pose proof (sin_cubic h ltac:(unfold h; lra)) as [S _]. pose proof root3 as [_ R].
  assert (H0 : 0 <= h <= 0.3) by (unfold h; lra). assert (H2 : 0 <= h * h <= 0.09) by (split; [apply Rmult_le_pos; lra|replace 0.09 with (0.3 * 0.3) by lra; apply Rmult_le_compat; lra]).
  assert (H3 : 0 <= h * h * h <= 0.09 * 0.3) by (split; [apply Rmult_le_pos; lra|apply Rmult_le_compat; lra]).
  assert (H4 : h * h * h <= 0.09 * h) by (apply Rmult_le_compat_r; lra).
  assert (0.866025 * (h - 0.1667 * (h * h * h)) <= sqrt 3 / 2 * sin h) by (apply Rmult_le_compat; lra).
  unfold h in *. lra.
Qed.
Lemma arc_low g y x : arc_ok g y = true -> u * cos x <= IZR y -> 0 <= x <= PI -> IZR g <= u * (x - PI / 3).
Proof.
  intros H Y X. pose proof u_pos as UP. set (G := IZR g / u). assert (EG : IZR g = u * G) by (unfold G; field; lra).
  set (W := IZR y / u). assert (EW : IZR y = u * W) by (unfold W; field; lra). pose proof PI2_3_2. assert (U3 : 0 < u * u * u) by (repeat apply Rmult_lt_0_compat; lra).
  assert (CW : cos x <= W) by (apply Rmult_le_reg_l with u; lra). enough (G <= x - PI / 3) by (rewrite EG; apply Rmult_le_compat_l; lra).
  unfold arc_ok in H. destruct (0 <=? g)%Z eqn:S; apply andb_true_iff in H; destruct H as [H1 H2].
  - apply Z.leb_le, IZR_le in S, H1, H2. rewrite ?minus_IZR, ?plus_IZR, ?minus_IZR, ?mult_IZR in H2. fold u in H2. rewrite EG, EW in H2. rewrite EG in S, H1.
    assert (G0 : 0 <= G) by (apply Rmult_le_reg_l with u; lra).
    assert (G1 : G <= 0.28) by (apply Rmult_le_reg_l with u; [lra|]; apply Rle_trans with (1 := H1); unfold u, U; lra).
    pose proof (cos_low_pos G ltac:(lra)) as L.
    assert (Q : W <= 1 / 2 - G * G / 4 - 0.86603 * (G - 0.166 * (G * G * G))) by (apply Rmult_le_reg_l with (400000000 * (u * u * u)); lra).
    enough (PI / 3 + G <= x) by lra. apply angle_le; lra.
  - apply Z.leb_gt in S. apply IZR_lt in S. apply Z.leb_le, IZR_le in H1, H2. rewrite ?minus_IZR, ?plus_IZR, ?minus_IZR, ?mult_IZR in H2. fold u in H2. rewrite EG, EW in H2. rewrite EG in S, H1.
    assert (G0 : G <= 0) by (apply Rmult_le_reg_l with u; lra).
    assert (G1 : -0.3 <= G) by (apply Rmult_le_reg_l with u; [lra|]; apply Rle_trans with (2 := H1); unfold u, U; lra).
    pose proof (cos_low_neg G ltac:(lra)) as L.
    assert (Q : W <= 1 / 2 - G * G / 4 - 0.866025 * (G - 0.1667 * (G * G * G))) by (apply Rmult_le_reg_l with (40000000000 * (u * u * u)); lra).
    enough (PI / 3 + G <= x) by lra. apply angle_le; lra.
Qed.

(** ** Cosine and sine of the angles of a grid *)
Record entry := Entry { cl : Z; ch : Z; sl : Z; sh : Z }.
Definition holds (e : entry) (x : R) := IZR (cl e) <= u * cos x /\ u * cos x <= IZR (ch e) /\ IZR (sl e) <= u * sin x /\ u * sin x <= IZR (sh e).
Definition positive_entry (e : entry) : bool := ((0 <? cl e) && (0 <? sl e))%Z.
Definition next (s e : entry) : entry :=
  Entry (mulL (cl e) (cl s) - mulH (sh e) (sh s)) (mulH (ch e) (ch s) - mulL (sl e) (sl s))
        (mulL (sl e) (cl s) + mulL (cl e) (sl s)) (mulH (sh e) (ch s) + mulH (ch e) (sh s)).
Lemma positive_sound e x : positive_entry e = true -> holds e x -> (0 <= cl e)%Z /\ (0 <= sl e)%Z /\ 0 < cos x /\ 0 < sin x.
Proof.
  unfold positive_entry. rewrite andb_true_iff, !Z.ltb_lt. intros [A B] [C [_ [S _]]]. pose proof u_pos. pose proof (IZR_lt _ _ A). pose proof (IZR_lt _ _ B).
  repeat split; try lia; apply Rmult_lt_reg_l with u; lra.
Qed.
Lemma next_holds s e h x : positive_entry s = true -> positive_entry e = true -> holds s h -> holds e x -> holds (next s e) (x + h).
Proof.
  intros PS PE HS HE. pose proof (positive_sound s h PS HS) as [S1 [S2 [S3 S4]]]. pose proof (positive_sound e x PE HE) as [E1 [E2 [E3 E4]]].
  destruct HS as [A1 [A2 [A3 A4]]]. destruct HE as [B1 [B2 [B3 B4]]]. unfold holds, next; cbn [cl ch sl sh]. rewrite cos_plus, sin_plus.
  pose proof (mulL_ok _ _ _ _ E1 S1 B1 A1). pose proof (mulH_ok _ _ _ _ (Rlt_le _ _ E4) (Rlt_le _ _ S4) B4 A4).
  pose proof (mulH_ok _ _ _ _ (Rlt_le _ _ E3) (Rlt_le _ _ S3) B2 A2). pose proof (mulL_ok _ _ _ _ E2 S2 B3 A3).
  pose proof (mulL_ok _ _ _ _ E2 S1 B3 A1). pose proof (mulL_ok _ _ _ _ E1 S2 B1 A3).
  pose proof (mulH_ok _ _ _ _ (Rlt_le _ _ E4) (Rlt_le _ _ S3) B4 A2). pose proof (mulH_ok _ _ _ _ (Rlt_le _ _ E3) (Rlt_le _ _ S4) B2 A4).
  rewrite !minus_IZR, !plus_IZR. lra.
Qed.
Fixpoint points (n : nat) (s e : entry) : list entry := match n with O => [] | S n => e :: points n s (next s e) end.
Lemma points_hold s h : positive_entry s = true -> holds s h -> forall n e x, holds e x -> forallb positive_entry (points n s e) = true ->
  forall i d, (i < n)%nat -> holds (nth i (points n s e) d) (x + INR i * h).
Proof.
  intros PS HS. induction n as [|n IH]; intros e x H F i d I; [lia|]. cbn [points forallb] in F. apply andb_true_iff in F. destruct F as [F1 F2].
  destruct i as [|i]; cbn [points nth]; [replace (x + INR 0 * h) with x by (cbn; lra); exact H|].
  replace (x + INR (S i) * h) with (x + h + INR i * h) by (rewrite S_INR; lra). apply IH; [apply next_holds; assumption|exact F2|lia].
Qed.

(** ** One box *)
Record claim := Claim { w1 : Z; w2 : Z; w3 : Z; r1 : Z; r2 : Z; r3 : Z; kk : Z; nus : list Z }.

Section Search.
Variables (at_ : nat -> entry) (S2l S2h C2l C2h kH mH : Z).
(** side_cos of the side opposite a: from above with the lower angles, from below with the upper ones *)
Definition scH (a b d : entry) : Z := divH (ch a + mulH (ch b) (ch d)) (mulL (sl b) (sl d)).
Definition scL (a b d : entry) : Z := divL (cl a + mulL (cl b) (cl d)) (mulH (sh b) (sh d)).
(** the own slope of x, in the box with the lower entry a and the upper entries b, d; cos x is at least y *)
Definition own_slope (a b d : entry) (y : Z) : Z := divL (mulL S2l (sl a)) (mulH (mulH (sh b) (sh d)) (Z.sqrt (U * U - y * y) + 1)).
(** an upper bound of i steps of the grid, as an angle *)
Definition steps (i : nat) : Z := (kH * Z.of_nat i / 64 + 1)%Z.
Definition leaf (c : claim) (l1 l2 l3 h1 h2 h3 : nat) : bool :=
  let a1 := at_ l1 in let a2 := at_ l2 in let a3 := at_ l3 in let b1 := at_ h1 in let b2 := at_ h2 in let b3 := at_ h3 in
  let y1 := (mulH S2h (scH a1 a2 a3) - C2l)%Z in let y2 := (mulH S2h (scH a2 a3 a1) - C2l)%Z in let y3 := (mulH S2h (scH a3 a1 a2) - C2l)%Z in
  let g1 := arc y1 in let g2 := arc y2 in let g3 := arc y3 in
  let q1 := scL b1 b2 b3 in let q2 := scL b2 b3 b1 in let q3 := scL b3 b1 b2 in
  let z1 := (mulL S2l q1 - C2h)%Z in let z2 := (mulL S2l q2 - C2h)%Z in let z3 := (mulL S2l q3 - C2h)%Z in
  let p1 := own_slope a1 b2 b3 z1 in let p2 := own_slope a2 b3 b1 z2 in let p3 := own_slope a3 b1 b2 z3 in
  let s1 := (10 * (w1 c * p1 + w2 c * mulL p2 q3 + w3 c * mulL p3 q2) - 20 * r1 c)%Z in
  let s2 := (10 * (w1 c * mulL p1 q3 + w2 c * p2 + w3 c * mulL p3 q1) - 20 * r2 c)%Z in
  let s3 := (10 * (w1 c * mulL p1 q2 + w2 c * mulL p2 q1 + w3 c * p3) - 20 * r3 c)%Z in
  let v := (10 * (w1 c * g1 + w2 c * g2 + w3 c * g3) - 20 * (mulH (r1 c) (steps l1) + mulH (r2 c) (steps l2) + mulH (r3 c) (steps l3)) + 20 * kk c)%Z in
  let m := (mH - (cl a1 + cl a2 + cl a3))%Z in
  (forallb (fun t => 0 <=? t) [w1 c; w2 c; w3 c; q1; q2; q3; z1; z2; z3; p1; p2; p3]
   && forallb (fun e => 0 <? mulL (sl (fst e)) (sl (snd e))) [(a2, a3); (a3, a1); (a1, a2)]
   && arc_ok g1 y1 && arc_ok g2 y2 && arc_ok g3 y3
   && existsb (fun n => (0 <=? n) && (60000 * U <=? (v - 2 * n * m) * U + Z.min 0 (s1 - 2 * n * sh b1) * steps (h1 - l1)
        + Z.min 0 (s2 - 2 * n * sh b2) * steps (h2 - l2) + Z.min 0 (s3 - 2 * n * sh b3) * steps (h3 - l3))) (nus c))%Z.

Variable theta : R.
Hypothesis range : 2 * PI / 5 < theta < 5 * PI / 12.
Definition grid_angle (i : nat) := a0 theta + INR i * (kappa theta / 64).
Hypothesis at_holds : forall i, (i <= 64)%nat -> holds (at_ i) (grid_angle i) /\ positive_entry (at_ i) = true.
Hypothesis s_holds : (0 <= S2l)%Z /\ IZR S2l <= u * sin theta ^ 2 <= IZR S2h.
Hypothesis c_holds : IZR C2l <= u * cos theta ^ 2 <= IZR C2h.
Hypothesis k_holds : u * kappa theta <= IZR kH.
Hypothesis m_holds : u * ((3 - 9 * cos theta ^ 2) / 2) <= IZR mH.

Lemma kappa_pos : 0 < kappa theta.
Proof. unfold kappa. lra. Qed.
Lemma grid_mid i : (i <= 64)%nat -> mid theta (grid_angle i).
Proof.
  intros I. apply le_INR in I. replace (INR 64) with 64 in I by (cbn; lra). pose proof kappa_pos as K. pose proof (pos_INR i).
  unfold mid, grid_angle. assert (0 <= INR i * (kappa theta / 64)) by (apply Rmult_le_pos; lra).
  assert (INR i * (kappa theta / 64) <= 64 * (kappa theta / 64)) by (apply Rmult_le_compat_r; lra). unfold kappa, a0 in *. lra.
Qed.
Lemma steps_hold i : 0 <= u * (INR i * (kappa theta / 64)) <= IZR (steps i).
Proof.
  pose proof kappa_pos as K. pose proof u_pos. pose proof (pos_INR i). split; [repeat apply Rmult_le_pos; lra|].
  pose proof (floor_gt (kH * Z.of_nat i) 64 eq_refl) as F. fold (steps i) in F. rewrite mult_IZR, <- INR_IZR_INZ in F.
  assert (u * kappa theta * INR i <= IZR kH * INR i) by (apply Rmult_le_compat_r; lra). lra.
Qed.

(** A point of the box, for one side: the entries a, b, d at the lower angles, and a', b', d' at the upper ones *)
Lemma scH_ok a b d A B D : mid theta A -> mid theta B -> mid theta D -> holds a A -> holds b B -> holds d D -> positive_entry b = true -> positive_entry d = true ->
  (0 < mulL (sl b) (sl d))%Z -> u * side_cos A B D <= IZR (scH a b d).
Proof.
  intros MA MB MD HA HB HD Pb Pd Q. pose proof (positive_sound _ _ Pb HB) as [B1 [B2 [B3 B4]]]. pose proof (positive_sound _ _ Pd HD) as [D1 [D2 [D3 D4]]].
  pose proof (mid_trig theta range A MA) as [_ [[A1 _] _]]. pose proof (Sides.numbers theta range) as [N _].
  unfold scH, side_cos. apply divH_ok; [assert (0 < cos B * cos D) by (apply Rmult_lt_0_compat; lra); lra| |exact Q|apply mulL_ok; auto; apply HB || apply HD].
  rewrite plus_IZR. pose proof (mulH_ok (ch b) (ch d) (cos B) (cos D) ltac:(lra) ltac:(lra) (proj1 (proj2 HB)) (proj1 (proj2 HD))). destruct HA as [_ [HA _]]. lra.
Qed.
Lemma scL_ok a b d A B D : holds a A -> holds b B -> holds d D -> positive_entry a = true -> positive_entry b = true -> positive_entry d = true ->
  IZR (scL a b d) <= u * side_cos A B D.
Proof.
  intros HA HB HD Pa Pb Pd. pose proof (positive_sound _ _ Pa HA) as [A1 [A2 [A3 A4]]]. pose proof (positive_sound _ _ Pb HB) as [B1 [B2 [B3 B4]]]. pose proof (positive_sound _ _ Pd HD) as [D1 [D2 [D3 D4]]].
  unfold scL, side_cos. pose proof (mulL_ok (cl b) (cl d) (cos B) (cos D) B1 D1 (proj1 HB) (proj1 HD)) as M.
  assert (Z0 : (0 <= mulL (cl b) (cl d))%Z) by (unfold mulL; rewrite down_is; apply Z.div_pos; [apply Z.mul_nonneg_nonneg; lia|reflexivity]).
  apply divL_ok; [lia| |apply Rmult_lt_0_compat; lra|].
  - rewrite plus_IZR. destruct HA as [HA _]. lra.
  - apply mulH_ok; try lra; [apply HB|apply HD].
Qed.
Lemma one_side a b d a' b' d' lA lB lD hA hB hD A B D y g z q qB qD p :
  mid theta lA -> mid theta lB -> mid theta lD -> mid theta hA -> mid theta hB -> mid theta hD ->
  holds a lA -> holds b lB -> holds d lD -> holds a' hA -> holds b' hB -> holds d' hD ->
  positive_entry a = true -> positive_entry b = true -> positive_entry d = true -> positive_entry a' = true -> positive_entry b' = true -> positive_entry d' = true ->
  (0 < mulL (sl b) (sl d))%Z -> y = (mulH S2h (scH a b d) - C2l)%Z -> arc_ok g y = true ->
  q = scL a' b' d' -> qD = scL d' a' b' -> qB = scL b' d' a' -> (0 <= q)%Z -> (0 <= qB)%Z -> (0 <= qD)%Z ->
  z = (mulL S2l q - C2h)%Z -> (0 <= z)%Z -> p = own_slope a b' d' z -> (0 <= p)%Z ->
  inb lA hA A -> inb lB hB B -> inb lD hD D ->
  IZR g + IZR p * (A - lA) + IZR (mulL p qD) * (B - lB) + IZR (mulL p qB) * (D - lD) <= u * (xs theta A B D - PI / 3).
Proof.
  intros mlA mlB mlD mhA mhB mhD Ha Hb Hd Ha' Hb' Hd' Pa Pb Pd Pa' Pb' Pd' Q Ey Ag Eq EqD EqB q0 qB0 qD0 Ez z0 Ep p0 IA IB ID.
  pose proof u_pos as UP. destruct s_holds as [s0 [s1 s2]]. destruct c_holds as [c1 c2]. pose proof (Sides.numbers theta range) as [_ [N2 _]].
  assert (SS : 0 < sin theta ^ 2) by nra.
  destruct (cos_xs theta range lA lB lD mlA mlB mlD) as [R1 E1]. destruct (cos_xs theta range hA hB hD mhA mhB mhD) as [R2 E2]. pose proof (between theta range) as BT.
  (* x at the lower corner *)
  pose proof (scH_ok a b d lA lB lD mlA mlB mlD Ha Hb Hd Pb Pd Q) as C1.
  assert (SC : 0 <= side_cos lA lB lD).
  { pose proof (side_cos_range theta range theta (mid_theta theta range) lA lB lD mlA mlB mlD) as [X _]. pose proof (k_numbers theta range theta (mid_theta theta range)) as [_ [X' _]]. lra. }
  pose proof (mulH_ok S2h (scH a b d) (sin theta ^ 2) (side_cos lA lB lD) ltac:(lra) SC s2 C1) as C2.
  assert (L : IZR g <= u * (xs theta lA lB lD - PI / 3)).
  { apply (arc_low g y); [exact Ag| |lra]. rewrite Ey, minus_IZR, E1. lra. }
  (* the slopes *)
  pose proof (scL_ok a' b' d' hA hB hD Ha' Hb' Hd' Pa' Pb' Pd') as C3. rewrite <- Eq in C3.
  pose proof (scL_ok d' a' b' hD hA hB Hd' Ha' Hb' Pd' Pa' Pb') as C4. rewrite <- EqD in C4.
  pose proof (scL_ok b' d' a' hB hD hA Hb' Hd' Ha' Pb' Pd' Pa') as C5. rewrite <- EqB in C5.
  pose proof (mulL_ok S2l q (sin theta ^ 2) (side_cos hA hB hD) s0 q0 s1 C3) as C6.
  set (X1 := xs theta hA hB hD) in *. assert (CX : IZR z <= u * cos X1) by (rewrite Ez, minus_IZR, E2; lra).
  assert (SX : u * sin X1 <= IZR (Z.sqrt (U * U - z * z) + 1)).
  { set (n := (U * U - z * z)%Z). pose proof (squares X1) as SQ. apply IZR_le in z0. pose proof (sin_ge_0 X1 ltac:(lra) ltac:(lra)) as S0.
    assert (ZZ : IZR z * IZR z <= u * cos X1 * (u * cos X1)) by (apply Rmult_le_compat; lra).
    assert (NN : u * sin X1 * (u * sin X1) <= IZR n).
    { unfold n. rewrite minus_IZR, !mult_IZR. fold u. replace (u * sin X1 * (u * sin X1)) with (u * u * (sin X1 * sin X1)) by ring.
      replace (sin X1 * sin X1) with (1 - cos X1 * cos X1) by lra. lra. }
    assert (n0 : (0 <= n)%Z) by (apply le_IZR; apply Rle_trans with (2 := NN); pose proof (Rle_0_sqr (u * sin X1)); unfold Rsqr in *; lra).
    pose proof (Z.sqrt_spec n n0) as [_ SN]. cbv zeta in SN. apply IZR_lt in SN. rewrite mult_IZR, <- Z.add_1_r in SN. pose proof (Z.sqrt_nonneg n) as SP. apply IZR_le in SP.
    rewrite plus_IZR in SN |- *. apply Rnot_lt_le. intros K. assert ((IZR (Z.sqrt n) + 1) * (IZR (Z.sqrt n) + 1) <= u * sin X1 * (u * sin X1)) by (apply Rmult_le_compat; lra). lra. }
  pose proof (positive_sound _ _ Pa Ha) as [_ [A2 [_ A4]]]. pose proof (positive_sound _ _ Pb' Hb') as [_ [_ [_ B4]]]. pose proof (positive_sound _ _ Pd' Hd') as [_ [_ [_ D4]]].
  pose proof (sin_ge_0 X1 ltac:(lra) ltac:(lra)) as SX0.
  pose proof (mulH_ok (sh b') (sh d') (sin hB) (sin hD) ltac:(lra) ltac:(lra) (proj2 (proj2 (proj2 Hb'))) (proj2 (proj2 (proj2 Hd')))) as M1.
  pose proof (mulH_ok _ _ (sin hB * sin hD) (sin X1) ltac:(apply Rmult_le_pos; lra) SX0 M1 SX) as M2.
  pose proof (mulL_ok S2l (sl a) (sin theta ^ 2) (sin lA) s0 A2 s1 (proj1 (proj2 (proj2 Ha)))) as M3.
  assert (P1 : IZR p * (sin hB * sin hD * sin X1) <= u * (sin theta ^ 2 * sin lA)).
  { destruct (Req_dec (sin X1) 0) as [Z|Z]; [rewrite Z, Rmult_0_r, Rmult_0_r; repeat apply Rmult_le_pos; try lra|].
    assert (W : 0 < sin hB * sin hD * sin X1) by (repeat apply Rmult_lt_0_compat; lra).
    assert (N0 : (0 <= mulL S2l (sl a))%Z) by (unfold mulL; rewrite down_is; apply Z.div_pos; [apply Z.mul_nonneg_nonneg; assumption|reflexivity]).
    pose proof (divL_ok _ _ _ _ N0 M3 W M2) as DV. fold (own_slope a b' d' z) in DV. rewrite <- Ep in DV.
    apply Rmult_le_compat_r with (r := sin hB * sin hD * sin X1) in DV; [|lra].
    replace (u * (sin theta ^ 2 * sin lA / (sin hB * sin hD * sin X1)) * (sin hB * sin hD * sin X1)) with (u * (sin theta ^ 2 * sin lA)) in DV by (field; lra). exact DV. }
  pose proof (IZR_le _ _ p0) as p0'.
  pose proof (box_side theta range lA lB lD hA hB hD A B D (IZR p / u) mlA mlB mlD mhA mhB mhD IA IB ID) as BS.
  assert (PU : u * (IZR p / u) = IZR p) by (field; lra).
  specialize (BS ltac:(apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra])).
  assert (BP : IZR p / u * (sin hB * sin hD * sin (xs theta hA hB hD)) <= sin theta ^ 2 * sin lA).
  { apply Rmult_le_reg_l with u; [lra|]. fold X1. replace (u * (IZR p / u * (sin hB * sin hD * sin X1))) with (IZR p * (sin hB * sin hD * sin X1)) by (field; lra). exact P1. }
  specialize (BS BP). pose proof (mulL_ok p qD (IZR p / u) (side_cos hD hA hB) p0 qD0 ltac:(lra) C4) as M4. pose proof (mulL_ok p qB (IZR p / u) (side_cos hB hD hA) p0 qB0 ltac:(lra) C5) as M5.
  unfold inb in *. apply (Rmult_le_compat_l u) in BS; [|lra].
  assert (T2 : IZR (mulL p qD) * (B - lB) <= u * (IZR p / u * side_cos hD hA hB) * (B - lB)) by (apply Rmult_le_compat_r; lra).
  assert (T3 : IZR (mulL p qB) * (D - lD) <= u * (IZR p / u * side_cos hB hD hA) * (D - lD)) by (apply Rmult_le_compat_r; lra).
  assert (T1 : IZR p * (A - lA) = u * (IZR p / u * (A - lA))) by (field; lra). lra.
Qed.

Definition claim_holds (c : claim) (A B D : R) := forall k x1 x2 x3, 0 <= x1 -> 0 <= x2 -> 0 <= x3 ->
  u * x1 <= IZR (r1 c) -> u * x2 <= IZR (r2 c) -> u * x3 <= IZR (r3 c) -> IZR (kk c) <= u * k ->
  1 / 100000 <= IZR (w1 c) / 2 * (xs theta A B D - PI / 3) + IZR (w2 c) / 2 * (xs theta B D A - PI / 3) + IZR (w3 c) / 2 * (xs theta D A B - PI / 3)
    - x1 * (A - a0 theta) - x2 * (B - a0 theta) - x3 * (D - a0 theta) + k.
Definition in_box (l1 l2 l3 h1 h2 h3 : nat) A B D :=
  inb (grid_angle l1) (grid_angle h1) A /\ inb (grid_angle l2) (grid_angle h2) B /\ inb (grid_angle l3) (grid_angle h3) D.
Lemma least_product d t e : 0 <= t <= IZR e -> IZR (Z.min 0 d * e) <= IZR d * t.
Proof.
  intros [T1 T2]. rewrite mult_IZR. destruct (Z.min_spec 0 d) as [[L ->]|[L ->]].
  - apply IZR_lt in L. rewrite Rmult_0_l. apply Rmult_le_pos; lra.
  - apply IZR_le in L. assert (0 <= - IZR d * (IZR e - t)) by (apply Rmult_le_pos; lra). lra.
Qed.
(** The excess at the lower angle, and its growth in the box *)
Lemma excess_part x r i A : 0 <= x -> u * x <= IZR r -> grid_angle i <= A -> u * (x * (A - a0 theta)) <= IZR (mulH r (steps i)) + IZR r * (A - grid_angle i).
Proof.
  intros X Rr L. pose proof (steps_hold i) as [S1 S2]. pose proof u_pos. assert (E0 : 0 <= INR i * (kappa theta / 64)) by (apply Rmult_le_reg_l with u; lra).
  pose proof (mulH_ok r (steps i) x (INR i * (kappa theta / 64)) X E0 Rr S2) as M. assert (u * x * (A - grid_angle i) <= IZR r * (A - grid_angle i)) by (apply Rmult_le_compat_r; lra).
  unfold grid_angle in *. lra.
Qed.
Lemma cos_part i j A : (i <= 64)%nat -> (j <= 64)%nat -> inb (grid_angle i) (grid_angle j) A -> IZR (cl (at_ i)) - IZR (sh (at_ j)) * (A - grid_angle i) <= u * cos A.
Proof.
  intros I J IA. pose proof (grid_mid i I) as MI. pose proof (grid_mid j J) as MJ. pose proof (mid_in theta _ _ _ MI MJ IA) as MA. unfold inb, mid in *. pose proof (between theta range). pose proof u_pos.
  pose proof (cos_falls (grid_angle i) A (grid_angle j) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as F.
  destruct (at_holds i I) as [[HI _] _]. destruct (at_holds j J) as [[_ [_ [_ HJ]]] _].
  assert (u * sin (grid_angle j) * (A - grid_angle i) <= IZR (sh (at_ j)) * (A - grid_angle i)) by (apply Rmult_le_compat_r; lra).
  apply (Rmult_le_compat_l u) in F; lra.
Qed.
Lemma width_part i j A : (i <= j)%nat -> inb (grid_angle i) (grid_angle j) A -> 0 <= u * (A - grid_angle i) <= IZR (steps (j - i)).
Proof.
  intros IJ IA. pose proof (steps_hold (j - i)) as [_ S]. pose proof u_pos. unfold inb, grid_angle in *. rewrite minus_INR in S by exact IJ. split; [apply Rmult_le_pos; lra|].
  apply Rle_trans with (2 := S). apply Rmult_le_compat_l; lra.
Qed.
Lemma leaf_sound c l1 l2 l3 h1 h2 h3 A B D : (l1 <= h1 <= 64)%nat -> (l2 <= h2 <= 64)%nat -> (l3 <= h3 <= 64)%nat ->
  leaf c l1 l2 l3 h1 h2 h3 = true -> in_box l1 l2 l3 h1 h2 h3 A B D -> cos A + cos B + cos D <= (3 - 9 * cos theta ^ 2) / 2 -> claim_holds c A B D.
Proof.
  intros O1 O2 O3 L [IA [IB ID]] F k x1 x2 x3 X1 X2 X3 Y1 Y2 Y3 Kk. pose proof u_pos as UP.
  pose proof (at_holds l1 ltac:(lia)) as [HA PA]. pose proof (at_holds l2 ltac:(lia)) as [HB PB]. pose proof (at_holds l3 ltac:(lia)) as [HD PD].
  pose proof (at_holds h1 ltac:(lia)) as [HA' PA']. pose proof (at_holds h2 ltac:(lia)) as [HB' PB']. pose proof (at_holds h3 ltac:(lia)) as [HD' PD'].
  pose proof (grid_mid l1 ltac:(lia)) as MA. pose proof (grid_mid l2 ltac:(lia)) as MB. pose proof (grid_mid l3 ltac:(lia)) as MD.
  pose proof (grid_mid h1 ltac:(lia)) as MA'. pose proof (grid_mid h2 ltac:(lia)) as MB'. pose proof (grid_mid h3 ltac:(lia)) as MD'.
  unfold leaf in L. cbv zeta in L. cbn [forallb fst snd] in L. rewrite !andb_true_iff, !Z.leb_le, !Z.ltb_lt in L.
  destruct L as [[[[[[W1 [W2 [W3 [Q1 [Q2 [Q3 [Z1 [Z2 [Z3 [P1 [P2 [P3 _]]]]]]]]]]]] [T1 [T2 [T3 _]]]] G1] G2] G3] V].
  apply existsb_exists in V. destruct V as [n [_ V]]. apply andb_true_iff in V. destruct V as [N0 V]. apply Z.leb_le in N0, V.
  pose proof (one_side _ _ _ _ _ _ _ _ _ _ _ _ A B D _ _ _ _ _ _ _ MA MB MD MA' MB' MD' HA HB HD HA' HB' HD' PA PB PD PA' PB' PD' T1 eq_refl G1 eq_refl eq_refl eq_refl Q1 Q2 Q3 eq_refl Z1 eq_refl P1 IA IB ID) as S1.
  pose proof (one_side _ _ _ _ _ _ _ _ _ _ _ _ B D A _ _ _ _ _ _ _ MB MD MA MB' MD' MA' HB HD HA HB' HD' HA' PB PD PA PB' PD' PA' T2 eq_refl G2 eq_refl eq_refl eq_refl Q2 Q3 Q1 eq_refl Z2 eq_refl P2 IB ID IA) as S2.
  pose proof (one_side _ _ _ _ _ _ _ _ _ _ _ _ D A B _ _ _ _ _ _ _ MD MA MB MD' MA' MB' HD HA HB HD' HA' HB' PD PA PB PD' PA' PB' T3 eq_refl G3 eq_refl eq_refl eq_refl Q3 Q1 Q2 eq_refl Z3 eq_refl P3 ID IA IB) as S3.
  pose proof (cos_part l1 h1 A ltac:(lia) ltac:(lia) IA) as C1. pose proof (cos_part l2 h2 B ltac:(lia) ltac:(lia) IB) as C2. pose proof (cos_part l3 h3 D ltac:(lia) ltac:(lia) ID) as C3.
  pose proof (width_part l1 h1 A ltac:(lia) IA) as D1. pose proof (width_part l2 h2 B ltac:(lia) IB) as D2. pose proof (width_part l3 h3 D ltac:(lia) ID) as D3.
  pose proof (excess_part x1 (r1 c) l1 A X1 Y1 (proj1 IA)) as E1. pose proof (excess_part x2 (r2 c) l2 B X2 Y2 (proj1 IB)) as E2. pose proof (excess_part x3 (r3 c) l3 D X3 Y3 (proj1 ID)) as E3.
  apply IZR_le in W1, W2, W3, N0, V.
  set (g1 := arc _) in S1. set (g2 := arc _) in S2. set (g3 := arc _) in S3.
  match type of V with IZR (60000 * U) <= IZR (?v * U + Z.min 0 ?d1 * _ + Z.min 0 ?d2 * _ + Z.min 0 ?d3 * _) =>
    pose proof (least_product d1 _ _ D1) as F1; pose proof (least_product d2 _ _ D2) as F2; pose proof (least_product d3 _ _ D3) as F3;
    set (vv := v) in V; set (dd1 := d1) in V, F1; set (dd2 := d2) in V, F2; set (dd3 := d3) in V, F3 end.
  rewrite !plus_IZR, (mult_IZR vv), (mult_IZR 60000) in V. fold u in V.
  assert (V' : 60000 <= IZR vv + IZR dd1 * (A - grid_angle l1) + IZR dd2 * (B - grid_angle l2) + IZR dd3 * (D - grid_angle l3)) by (apply Rmult_le_reg_r with u; [lra|]; lra).
  clear V F1 F2 F3. unfold vv, dd1, dd2, dd3 in V'. rewrite ?minus_IZR, ?plus_IZR, ?mult_IZR, ?plus_IZR, ?minus_IZR, ?mult_IZR, ?plus_IZR, ?mult_IZR in V'.
  rewrite ?mult_IZR in V'. fold g1 g2 g3 in V'.
  apply (Rmult_le_compat_l (IZR (w1 c)) _ _ W1) in S1. apply (Rmult_le_compat_l (IZR (w2 c)) _ _ W2) in S2. apply (Rmult_le_compat_l (IZR (w3 c)) _ _ W3) in S3.
  assert (FU : u * (cos A + cos B + cos D) <= u * ((3 - 9 * cos theta ^ 2) / 2)) by (apply Rmult_le_compat_l; lra).
  assert (FF : 0 <= IZR n * (IZR mH - (u * cos A + u * cos B + u * cos D))) by (apply Rmult_le_pos; [exact N0|]; lra).
  apply (Rmult_le_compat_l (IZR n) _ _ N0) in C1. apply (Rmult_le_compat_l (IZR n) _ _ N0) in C2. apply (Rmult_le_compat_l (IZR n) _ _ N0) in C3.
  apply Rmult_le_reg_l with (20 * u); [lra|]. assert (UU : 20 * u * (1 / 100000) <= 60000) by (unfold u, U; lra).
  apply Rle_trans with (1 := UU). apply Rle_trans with (1 := V'). lra.
Qed.

(** ** The search *)
Fixpoint search (c : claim) (sorted : bool) (fuel l1 l2 l3 h1 h2 h3 : nat) : bool :=
  if sorted && ((h2 <? l1)%nat || (h3 <? l2)%nat) then true
  else if (mH <? cl (at_ h1) + cl (at_ h2) + cl (at_ h3))%Z then true
  else if leaf c l1 l2 l3 h1 h2 h3 then true
  else match fuel with
  | O => false
  | S fuel =>
    if ((h2 - l2 <=? h1 - l1) && (h3 - l3 <=? h1 - l1))%nat
    then let m := Nat.div2 (l1 + h1) in search c sorted fuel l1 l2 l3 m h2 h3 && search c sorted fuel m l2 l3 h1 h2 h3
    else if (h3 - l3 <=? h2 - l2)%nat
    then let m := Nat.div2 (l2 + h2) in search c sorted fuel l1 l2 l3 h1 m h3 && search c sorted fuel l1 m l3 h1 h2 h3
    else let m := Nat.div2 (l3 + h3) in search c sorted fuel l1 l2 l3 h1 h2 m && search c sorted fuel l1 l2 m h1 h2 h3
  end.
Lemma grid_lt i j : (i < j)%nat -> grid_angle i < grid_angle j.
Proof. intros I. apply lt_INR in I. pose proof kappa_pos. unfold grid_angle. apply Rplus_lt_compat_l, Rmult_lt_compat_r; lra. Qed.
Lemma middle_between l h : (l <= h)%nat -> (l <= Nat.div2 (l + h) <= h)%nat.
Proof. intros L. pose proof (Nat.div2_odd (l + h)). destruct (Nat.odd (l + h)); cbn in *; lia. Qed.
Theorem search_sound c sorted fuel : forall l1 l2 l3 h1 h2 h3 A B D, (l1 <= h1 <= 64)%nat -> (l2 <= h2 <= 64)%nat -> (l3 <= h3 <= 64)%nat ->
  search c sorted fuel l1 l2 l3 h1 h2 h3 = true -> in_box l1 l2 l3 h1 h2 h3 A B D -> (sorted = true -> A <= B <= D) ->
  cos A + cos B + cos D <= (3 - 9 * cos theta ^ 2) / 2 -> claim_holds c A B D.
Proof.
  induction fuel as [|fuel IH]; intros l1 l2 l3 h1 h2 h3 A B D O1 O2 O3 S [IA [IB ID]] So F; cbn [search] in S.
  all: destruct (sorted && ((h2 <? l1)%nat || (h3 <? l2)%nat)) eqn:E1;
    [exfalso; apply andb_true_iff in E1; destruct E1 as [E1 E2]; specialize (So E1); apply orb_true_iff in E2; unfold inb in *;
     destruct E2 as [E2|E2]; apply Nat.ltb_lt, grid_lt in E2; lra|].
  all: destruct (mH <? cl (at_ h1) + cl (at_ h2) + cl (at_ h3))%Z eqn:E2;
    [exfalso; apply Z.ltb_lt, IZR_lt in E2; rewrite !plus_IZR in E2; pose proof u_pos;
     pose proof (proj1 (proj1 (at_holds h1 ltac:(lia)))); pose proof (proj1 (proj1 (at_holds h2 ltac:(lia)))); pose proof (proj1 (proj1 (at_holds h3 ltac:(lia))));
     pose proof (grid_mid h1 ltac:(lia)) as M1; pose proof (grid_mid h2 ltac:(lia)) as M2; pose proof (grid_mid h3 ltac:(lia)) as M3;
     pose proof (grid_mid l1 ltac:(lia)) as M4; pose proof (grid_mid l2 ltac:(lia)) as M5; pose proof (grid_mid l3 ltac:(lia)) as M6;
     pose proof (between theta range); unfold inb, mid in *;
     pose proof (cos_le A (grid_angle h1) ltac:(lra) ltac:(lra) ltac:(lra)); pose proof (cos_le B (grid_angle h2) ltac:(lra) ltac:(lra) ltac:(lra)); pose proof (cos_le D (grid_angle h3) ltac:(lra) ltac:(lra) ltac:(lra));
     assert (u * (cos (grid_angle h1) + cos (grid_angle h2) + cos (grid_angle h3)) <= u * ((3 - 9 * cos theta ^ 2) / 2)) by (apply Rmult_le_compat_l; lra); lra|].
  all: destruct (leaf c l1 l2 l3 h1 h2 h3) eqn:E3;
    [exact (leaf_sound c l1 l2 l3 h1 h2 h3 A B D O1 O2 O3 E3 (conj IA (conj IB ID)) F)|].
  - discriminate.
  - pose proof (middle_between l1 h1 ltac:(lia)). pose proof (middle_between l2 h2 ltac:(lia)). pose proof (middle_between l3 h3 ltac:(lia)).
    destruct ((h2 - l2 <=? h1 - l1) && (h3 - l3 <=? h1 - l1))%nat; [|destruct (h3 - l3 <=? h2 - l2)%nat]; cbv zeta in S; apply andb_true_iff in S; destruct S as [Sl Sr].
    + destruct (Rle_dec A (grid_angle (Nat.div2 (l1 + h1)))) as [Q|Q]; [apply (IH _ _ _ _ _ _ A B D) in Sl|apply (IH _ _ _ _ _ _ A B D) in Sr]; auto; try lia; repeat split; unfold inb in *; try lra; tauto.
    + destruct (Rle_dec B (grid_angle (Nat.div2 (l2 + h2)))) as [Q|Q]; [apply (IH _ _ _ _ _ _ A B D) in Sl|apply (IH _ _ _ _ _ _ A B D) in Sr]; auto; try lia; repeat split; unfold inb in *; try lra; tauto.
    + destruct (Rle_dec D (grid_angle (Nat.div2 (l3 + h3)))) as [Q|Q]; [apply (IH _ _ _ _ _ _ A B D) in Sl|apply (IH _ _ _ _ _ _ A B D) in Sr]; auto; try lia; repeat split; unfold inb in *; try lra; tauto.
Qed.
End Search.
