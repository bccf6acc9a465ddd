(** * A rational upper bound of the cosine of p/q degrees

    With L < pi a rational number and y = (p/q) L / 360 half the angle, a little
    less:  cos (p/q degrees) <= 2 cos(y)^2 - 1 <= 2 u^2 - 1, where u >= cos y is the
    Taylor polynomial of degree 24, evaluated by Horner's scheme in integers. *)
Require Import Reals Lra Psatz ZArith List Lia.
Open Scope R_scope.

(** pi > 3.1415926535897932 (Machin-like series of the standard library). *)
Definition pi_num : Z := 31415926535897932.
Definition pi_den : Z := 10000000000000000.
Lemma pi_lower : IZR pi_num / IZR pi_den < PI.
Proof.
  pose proof (PI_2_3_7_ineq 8) as [H _]. unfold pi_num, pi_den.
  unfold tg_alt, PI_2_3_7_tg, Ratan_seq in H. cbn [sum_f_R0 Nat.mul Nat.add pow] in H. rewrite !INR_IZR_INZ in H. cbn [Z.of_nat Pos.of_succ_nat Pos.succ] in H.
  lra.
Qed.

(** Horner's scheme: 1 - z/((2k+1)(2k+2)) (1 - z/((2k+3)(2k+4)) (...)), n times. *)
Fixpoint horner (y : R) (k n : nat) : R :=
  match n with
  | O => 1
  | S n => 1 - y * y / (INR (2 * k + 1) * INR (2 * k + 2)) * horner y (S k) n
  end.
Lemma cos_term_succ y k : cos_term y (S k) = - cos_term y k * (y * y / (INR (2 * k + 1) * INR (2 * k + 2))).
Proof.
  unfold cos_term. replace (2 * S k)%nat with (S (S (2 * k))) by lia.
  change (y ^ S (S (2 * k))) with (y * (y * y ^ (2 * k))). change ((-1) ^ S k) with (-1 * (-1) ^ k).
  rewrite !fact_simpl, !mult_INR. replace (S (2 * k))%nat with (2 * k + 1)%nat by lia. replace (S (2 * k + 1)) with (2 * k + 2)%nat by lia.
  assert (INR (fact (2 * k)) <> 0) by apply INR_fact_neq_0.
  assert (INR (2 * k + 1) <> 0) by (apply not_0_INR; lia). assert (INR (2 * k + 2) <> 0) by (apply not_0_INR; lia).
  field. auto.
Qed.
Lemma horner_sum y n : forall k, cos_term y k * horner y k n = sum_f_R0 (fun i => cos_term y (k + i)) n.
Proof.
  induction n as [|n IH]; intros k.
  - cbn. rewrite Nat.add_0_r. ring.
  - rewrite decomp_sum by lia. cbn [pred]. rewrite Nat.add_0_r.
    rewrite (sum_eq _ (fun i => cos_term y (S k + i))) by (intros; f_equal; lia).
    rewrite <- IH, cos_term_succ. cbn [horner]. ring.
Qed.
Lemma horner_cos y n : horner y 0 n = cos_approx y n.
Proof.
  unfold cos_approx. pose proof (horner_sum y n 0) as H.
  assert (E : cos_term y 0 = 1) by (unfold cos_term; cbn; field). rewrite E, Rmult_1_l in H. exact H.
Qed.

(** The same in integers, for y = s/t, over the denominator 2^80: rounded up or down in
    each step, so that the numbers stay small. *)
Definition unit80 : Z := 1208925819614629174706176.
Fixpoint zhorner (up : bool) (s t : Z) (k : Z) (n : nat) : Z :=
  match n with
  | O => unit80
  | S n => let m := (s * s * zhorner (negb up) s t (k + 1) n / ((2 * k + 1) * (2 * k + 2) * (t * t)))%Z in
           if up then (unit80 - m)%Z else (unit80 - m - 1)%Z
  end.
Lemma unit80_pos : 0 < IZR unit80.
Proof. apply IZR_lt. reflexivity. Qed.
Lemma zhorner_ok s t n : (0 < t)%Z -> forall up k, let h := IZR (zhorner up s t (Z.of_nat k) n) / IZR unit80 in
  if up then horner (IZR s / IZR t) k n <= h else h <= horner (IZR s / IZR t) k n.
Proof.
  intros Ht. pose proof unit80_pos as U. pose proof (IZR_lt _ _ Ht) as Ht'.
  induction n as [|n IH]; intros up k.
  - cbn [zhorner horner]. assert (IZR unit80 / IZR unit80 = 1) by (field; lra). destruct up; lra.
  - cbn [zhorner horner]. specialize (IH (negb up) (S k)). cbv zeta in *. replace (Z.of_nat (S k)) with (Z.of_nat k + 1)%Z in IH by lia.
    set (z := zhorner (negb up) s t (Z.of_nat k + 1) n) in *. set (H := horner (IZR s / IZR t) (S k) n) in *. clearbody z H.
    assert (K1 : INR (2 * k + 1) = IZR (2 * Z.of_nat k + 1)) by (rewrite INR_IZR_INZ; f_equal; lia).
    assert (K2 : INR (2 * k + 2) = IZR (2 * Z.of_nat k + 2)) by (rewrite INR_IZR_INZ; f_equal; lia).
    rewrite K1, K2.
    set (d := ((2 * Z.of_nat k + 1) * (2 * Z.of_nat k + 2) * (t * t))%Z).
    assert (Hd : (0 < d)%Z) by (unfold d; repeat apply Z.mul_pos_pos; lia).
    pose proof (Z.mul_div_le (s * s * z) d Hd) as D1. pose proof (Z.mul_succ_div_gt (s * s * z) d Hd) as D2.
    set (m := (s * s * z / d)%Z) in *. unfold Z.succ in D2. clearbody m.
    assert (P1 : 0 < IZR (2 * Z.of_nat k + 1)) by (apply IZR_lt; lia). assert (P2 : 0 < IZR (2 * Z.of_nat k + 2)) by (apply IZR_lt; lia).
    apply IZR_lt in Hd, D2. apply IZR_le in D1. rewrite !mult_IZR in D1, D2. rewrite plus_IZR in D2.
    set (c := IZR s / IZR t * (IZR s / IZR t) / (IZR (2 * Z.of_nat k + 1) * IZR (2 * Z.of_nat k + 2))).
    assert (Ec : c * IZR d = IZR s * IZR s) by (unfold c, d; rewrite !mult_IZR; field; repeat split; lra).
    assert (C0 : 0 <= c).
    { unfold c. apply Rmult_le_pos; [apply Rle_0_sqr|]. apply Rlt_le, Rinv_0_lt_compat, Rmult_lt_0_compat; auto. }
    set (u := IZR unit80) in *. set (h := IZR z / u) in *. assert (Eh : IZR z = h * u) by (unfold h; field; lra).
    rewrite Eh, <- Ec in D1, D2.
    assert (M1 : IZR m <= c * h * u) by (apply Rmult_le_reg_l with (IZR d); lra).
    assert (M2 : c * h * u < IZR m + 1) by (apply Rmult_lt_reg_l with (IZR d); lra).
    destruct up; cbn [negb] in IH; rewrite ?minus_IZR; fold u; apply Rmult_le_reg_r with u; auto.
    + replace ((u - IZR m) / u * u) with (u - IZR m) by (field; lra). assert (c * h * u <= c * H * u) by (apply Rmult_le_compat_r; [lra|apply Rmult_le_compat_l; lra]). lra.
    + replace ((u - IZR m - 1) / u * u) with (u - IZR m - 1) by (field; lra). assert (c * H * u <= c * h * u) by (apply Rmult_le_compat_r; [lra|apply Rmult_le_compat_l; lra]). lra.
Qed.

(** a/b rounded up to a multiple of 2^-60, so that the numbers to compare with stay small. *)
Definition unit60 : Z := 1152921504606846976.
Definition round_up (a b : Z) : Z * Z := (a * unit60 / b + 1, unit60)%Z.
Lemma round_up_ok a b : 0 < IZR b -> 0 < IZR (snd (round_up a b)) /\ IZR a / IZR b <= IZR (fst (round_up a b)) / IZR (snd (round_up a b)).
Proof.
  intros Hb. apply lt_IZR in Hb. unfold round_up; cbn [fst snd].
  assert (U : (0 < unit60)%Z) by (unfold unit60; lia).
  pose proof (Z.mul_succ_div_gt (a * unit60) b Hb) as D. set (m := (a * unit60 / b)%Z) in *. unfold Z.succ in D.
  apply IZR_lt in Hb, U, D. rewrite !mult_IZR in D. split; auto.
  apply Rmult_le_reg_r with (IZR b * IZR unit60); [apply Rmult_lt_0_compat; auto|].
  replace (IZR a / IZR b * (IZR b * IZR unit60)) with (IZR a * IZR unit60) by (field; lra).
  replace (IZR (m + 1) / IZR unit60 * (IZR b * IZR unit60)) with (IZR b * IZR (m + 1)) by (field; lra). lra.
Qed.

(** cos (p/q degrees) <= fst / snd, for 0 < p/q <= 180. *)
Definition cos_upper (p q : Z) : Z * Z :=
  let a := zhorner true (p * pi_num) (360 * q * pi_den) 0 12 in round_up (2 * a * a - unit80 * unit80) (unit80 * unit80).
Definition degrees_ok (p q : Z) : bool := (Z.ltb 0 p && Z.ltb 0 q && Z.leb p (180 * q))%bool.

Theorem cos_upper_ok p q : degrees_ok p q = true ->
  let theta := IZR p / IZR q * (PI / 180) in
  0 <= theta <= PI /\ 0 < IZR (snd (cos_upper p q)) /\ cos theta <= IZR (fst (cos_upper p q)) / IZR (snd (cos_upper p q)).
Proof.
  intros D theta. unfold degrees_ok in D. rewrite !Bool.andb_true_iff, !Z.ltb_lt, Z.leb_le in D. destruct D as [[Hp Hq] Hpq].
  pose proof PI_RGT_0 as PI0. pose proof pi_lower as PL.
  unfold cos_upper.
  assert (Hd : (0 < 360 * q * pi_den)%Z) by (unfold pi_den; lia).
  pose proof (zhorner_ok (p * pi_num) (360 * q * pi_den) 12 Hd true 0) as Hy.
  cbn [Z.of_nat] in Hy. cbv zeta in Hy. set (a := zhorner true (p * pi_num) (360 * q * pi_den) 0 12) in *. clearbody a.
  pose proof unit80_pos as Hb. set (b := unit80) in *.
  set (y := IZR (p * pi_num) / IZR (360 * q * pi_den)) in *.
  apply IZR_lt in Hp, Hq. apply IZR_le in Hpq. rewrite mult_IZR in Hpq.
  set (r := IZR p / IZR q) in *.
  assert (Er : r * IZR q = IZR p) by (unfold r; field; lra).
  assert (R0 : 0 < r) by (apply Rdiv_lt_0_compat; auto).
  assert (R1 : r <= 180) by (apply Rmult_le_reg_r with (IZR q); [auto|]; lra).
  assert (T0 : 0 <= theta <= PI).
  { unfold theta. split; [apply Rmult_le_pos; lra|]. nra. }
  assert (Ey : y = r * (IZR pi_num / IZR pi_den) / 360).
  { unfold y, r. rewrite !mult_IZR. unfold pi_num, pi_den. field. lra. }
  assert (L0 : 0 < IZR pi_num / IZR pi_den) by (unfold pi_num, pi_den; lra).
  assert (Y0 : 0 <= y) by (rewrite Ey; apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
  assert (Yt : y <= theta / 2).
  { rewrite Ey. unfold theta. assert (r * (IZR pi_num / IZR pi_den) <= r * PI) by (apply Rmult_le_compat_l; lra). lra. }
  assert (BB : 0 < IZR (b * b)) by (rewrite mult_IZR; apply Rmult_lt_0_compat; auto).
  destruct (round_up_ok (2 * a * a - b * b) (b * b) BB) as [RU0 RU1].
  split; auto. split; auto. apply Rle_trans with (2 := RU1).
  destruct (cos_bound y 5) as [_ UB]; [lra|lra|]. change (2 * (5 + 1))%nat with 12%nat in UB.
  rewrite <- horner_cos in UB.
  assert (DC : cos (theta / 2) <= cos y) by (apply cos_decr_1; lra).
  assert (C0 : 0 <= cos (theta / 2)) by (apply cos_ge_0; lra).
  assert (E2 : cos theta = 2 * cos (theta / 2) * cos (theta / 2) - 1).
  { replace theta with (2 * (theta / 2)) at 1 by field. apply cos_2a_cos. }
  rewrite E2, minus_IZR, !mult_IZR.
  replace ((2 * IZR a * IZR a - IZR b * IZR b) / (IZR b * IZR b)) with (2 * (IZR a / IZR b) * (IZR a / IZR b) - 1) by (field; lra).
  assert (cos (theta / 2) * cos (theta / 2) <= IZR a / IZR b * (IZR a / IZR b)) by (apply Rmult_le_compat; lra). lra.
Qed.

(** ** A rational lower bound

    With U > pi and y = (p/q) U / 360, a little more than half the angle, and not beyond
    pi/2: cos y >= u, the Taylor polynomial of degree 26; if u > 0, the cosine is at
    least 2 u^2 - 1. *)
Definition pi_above : Z := 31415926535897933.
Lemma pi_upper : PI < IZR pi_above / IZR pi_den.
Proof.
  pose proof (PI_2_3_7_ineq 8) as [_ H]. unfold pi_above, pi_den.
  unfold tg_alt, PI_2_3_7_tg, Ratan_seq in H. cbn [sum_f_R0 Nat.mul Nat.add pow] in H. rewrite !INR_IZR_INZ in H. cbn [Z.of_nat Pos.of_succ_nat Pos.succ] in H.
  lra.
Qed.
Definition round_down (a b : Z) : Z * Z := (a * unit60 / b, unit60)%Z.
Lemma round_down_ok a b : 0 < IZR b -> 0 < IZR (snd (round_down a b)) /\ IZR (fst (round_down a b)) / IZR (snd (round_down a b)) <= IZR a / IZR b.
Proof.
  intros Hb. apply lt_IZR in Hb. unfold round_down; cbn [fst snd].
  assert (U : (0 < unit60)%Z) by (unfold unit60; lia).
  pose proof (Z.mul_div_le (a * unit60) b Hb) as D. set (m := (a * unit60 / b)%Z) in *.
  apply IZR_lt in Hb, U. apply IZR_le in D. rewrite !mult_IZR in D. split; auto.
  apply Rmult_le_reg_r with (IZR b * IZR unit60); [apply Rmult_lt_0_compat; auto|].
  replace (IZR a / IZR b * (IZR b * IZR unit60)) with (IZR a * IZR unit60) by (field; lra).
  replace (IZR m / IZR unit60 * (IZR b * IZR unit60)) with (IZR b * IZR m) by (field; lra). lra.
Qed.

(** cos (p/q degrees) >= fst / snd, for 0 <= p/q < 180. *)
Definition cos_lower (p q : Z) : Z * Z :=
  if (p * pi_above * 2 <=? 360 * q * pi_num)%Z then
    let a := zhorner false (p * pi_above) (360 * q * pi_den) 0 13 in
    if (0 <? a)%Z then round_down (2 * a * a - unit80 * unit80) (unit80 * unit80) else (-1, 1)%Z
  else (-1, 1)%Z.
Definition above_ok (p q : Z) : bool := (Z.leb 0 p && Z.ltb 0 q && Z.ltb p (180 * q))%bool.

Theorem cos_lower_ok p q : above_ok p q = true ->
  let theta := IZR p / IZR q * (PI / 180) in
  0 <= theta <= PI /\ 0 < IZR (snd (cos_lower p q)) /\ IZR (fst (cos_lower p q)) / IZR (snd (cos_lower p q)) <= cos theta.
Proof.
  intros D theta. unfold above_ok in D. rewrite !Bool.andb_true_iff, !Z.ltb_lt, Z.leb_le in D. destruct D as [[Hp Hq] Hpq].
  pose proof PI_RGT_0 as PI0. pose proof pi_lower as PL. pose proof pi_upper as PU.
  assert (Hd : (0 < 360 * q * pi_den)%Z) by (unfold pi_den; lia).
  pose proof (COS_bound theta) as CB.
  assert (HpR : 0 <= IZR p) by (apply IZR_le; auto). assert (HqR : 0 < IZR q) by (apply IZR_lt; auto).
  apply IZR_lt in Hpq. rewrite mult_IZR in Hpq.
  set (r := IZR p / IZR q) in *.
  assert (Er : r * IZR q = IZR p) by (unfold r; field; lra).
  assert (R0 : 0 <= r) by (apply Rmult_le_pos; [auto|left; apply Rinv_0_lt_compat; auto]).
  assert (R1 : r <= 180) by (apply Rmult_le_reg_r with (IZR q); [auto|]; lra).
  assert (T0 : 0 <= theta <= PI).
  { unfold theta. split; [apply Rmult_le_pos; lra|]. nra. }
  split; auto. unfold cos_lower.
  destruct (Z.leb_spec (p * pi_above * 2) (360 * q * pi_num)) as [LE|]; [|cbn [fst snd]; lra].
  pose proof (zhorner_ok (p * pi_above) (360 * q * pi_den) 13 Hd false 0) as Hy.
  cbn [Z.of_nat] in Hy. cbv zeta in Hy. set (a := zhorner false (p * pi_above) (360 * q * pi_den) 0 13) in *. clearbody a.
  pose proof unit80_pos as Hb. set (b := unit80) in *.
  destruct (Z.ltb_spec 0 a) as [Ha|]; [|cbn [fst snd]; lra]. apply IZR_lt in Ha.
  set (y := IZR (p * pi_above) / IZR (360 * q * pi_den)) in *.
  assert (Ey : y = r * (IZR pi_above / IZR pi_den) / 360).
  { unfold y, r. rewrite !mult_IZR. unfold pi_above, pi_den. field. lra. }
  assert (L0 : 0 < IZR pi_num / IZR pi_den) by (unfold pi_num, pi_den; lra).
  assert (Y0 : theta / 2 <= y).
  { rewrite Ey. unfold theta. assert (r * PI <= r * (IZR pi_above / IZR pi_den)) by (apply Rmult_le_compat_l; lra). lra. }
  assert (Y1 : y <= PI / 2).
  { apply Rle_trans with (IZR pi_num / IZR pi_den / 2); [|lra].
    apply IZR_le in LE. rewrite !mult_IZR in LE. unfold y. rewrite !mult_IZR.
    assert (P : 0 < IZR pi_den) by (unfold pi_den; lra).
    apply Rmult_le_reg_r with (360 * IZR q * IZR pi_den * 2); [repeat apply Rmult_lt_0_compat; lra|].
    replace (IZR p * IZR pi_above / (360 * IZR q * IZR pi_den) * (360 * IZR q * IZR pi_den * 2)) with (IZR p * IZR pi_above * 2) by (field; lra).
    replace (IZR pi_num / IZR pi_den / 2 * (360 * IZR q * IZR pi_den * 2)) with (360 * IZR q * IZR pi_num) by (field; lra). lra. }
  assert (BB : 0 < IZR (b * b)) by (rewrite mult_IZR; apply Rmult_lt_0_compat; auto).
  destruct (round_down_ok (2 * a * a - b * b) (b * b) BB) as [RU0 RU1].
  split; auto. apply Rle_trans with (1 := RU1).
  destruct (cos_bound y 6) as [LB _]; [lra|lra|]. change (2 * 6 + 1)%nat with 13%nat in LB.
  rewrite <- horner_cos in LB.
  assert (DC : cos y <= cos (theta / 2)) by (apply cos_decr_1; lra).
  assert (C0 : 0 < IZR a / IZR b) by (apply Rdiv_lt_0_compat; auto).
  assert (E2 : cos theta = 2 * cos (theta / 2) * cos (theta / 2) - 1).
  { replace theta with (2 * (theta / 2)) at 1 by field. apply cos_2a_cos. }
  rewrite E2, minus_IZR, !mult_IZR.
  replace ((2 * IZR a * IZR a - IZR b * IZR b) / (IZR b * IZR b)) with (2 * (IZR a / IZR b) * (IZR a / IZR b) - 1) by (field; lra).
  assert (IZR a / IZR b * (IZR a / IZR b) <= cos (theta / 2) * cos (theta / 2)) by (apply Rmult_le_compat; lra). lra.
Qed.
