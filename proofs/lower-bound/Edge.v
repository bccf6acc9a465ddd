(** * docs/lower-bound.md, section 1: the tiles at an edge of a tiling form one cycle, and their angles add up to 360 degrees

    [pos a b c d] says that abcd is a tile with this order of the vertices, and has positive orientation. *)
From Coq Require Import Reals Lra Lia Psatz List Arith.
From Acutile Require Import Statement Tetrahedra Angles.
From LowerBound Require Import Calculus Normals Corners Tiling.
Import ListNotations.
Open Scope R_scope.

Section Edge.
Context {index : Type} {is_tile : index -> Prop} {tile : index -> tetrahedron}.
Hypothesis tiling : space_tiling is_tile tile.
Notation cell := (@cell index is_tile tile).

Definition pos a b c d := cell a b c d /\ 0 < orient a b c d.
Lemma pos_swap a b c d : pos a b c d -> pos b a d c.
Proof. intros [C O]. split; [apply cell_ab, cell_cd; exact C|]. replace (orient b a d c) with (orient a b c d) by (unf; ring). exact O. Qed.
Lemma pos_turn a b c d : pos a b c d -> pos a c d b.
Proof. intros [C O]. split; [apply cell_cd, cell_bc; exact C|]. replace (orient a c d b) with (orient a b c d) by (unf; ring). exact O. Qed.

(** ** The next tile at an edge vp *)
Lemma same_side v p r s s' : pos v p r s -> pos v p r s' -> s = s'.
Proof.
  intros [C O] [C' O']. set (P := sub p v) in *. set (Q := sub r v). set (W := sub s v). set (W' := sub s' v).
  set (b := det P W' W). pose proof (Rabs_pos b). pose proof (Rle_abs b) as B1. pose proof (Rle_abs (- b)) as B2. rewrite Rabs_Ropp in B2.
  destruct (overlap tiling v p r s' r s (Rabs b + 1) (orient v p r s) 0 (Rabs b + 1 + b) (orient v p r s') (det W' Q W)) as [[_ E]|[E _]]; auto; try lra.
  - unfold b, P, Q, W, W'. apply point_eq; unf; ring.
  - exfalso. rewrite <- E in O. apply (Rlt_irrefl 0). replace 0 with (orient v p r r) at 2 by (unf; ring). exact O.
Qed.
Lemma pos_next v p q r : pos v p q r -> exists s, pos v p r s.
Proof.
  intros [C O]. destruct (across tiling v p r q (cell_cd _ _ _ _ C)) as [s [Cs N]]. exists s. split; [exact Cs|].
  replace (orient v p r q) with (- orient v p q r) in N by (unf; ring). nra.
Qed.
Lemma same_side_previous v p r s s' : pos v p s r -> pos v p s' r -> s = s'.
Proof. intros C C'. apply (same_side p v r); apply pos_swap; assumption. Qed.

(** ** Polar coordinates around the edge

    The vectors e1 and e2 are perpendicular to the edge; [polar q rho psi z] says where the point q is. *)
Section Frame.
Variables (v p : point) (e1 : point).
Let A := sub p v.
Let a := norm A.
Hypothesis A_not_zero : 0 < dot A A.
Hypothesis e1_unit : dot e1 e1 = 1.
Hypothesis e1_perp : dot e1 A = 0.
Let e2 := scale (/ a) (cross A e1).
Definition dir psi := add (scale (cos psi) e1) (scale (sin psi) e2).
Definition polar q rho psi z := 0 < rho /\ sub q v = add (scale rho (dir psi)) (scale z A).

Lemma a_pos : 0 < a. Proof. apply sqrt_lt_R0. exact A_not_zero. Qed.
Lemma a_sqr : a * a = dot A A. Proof. apply norm_sqr. Qed.
Lemma e2_unit : dot e2 e2 = 1.
Proof.
  pose proof a_pos. pose proof a_sqr as S. unfold e2. rewrite dot_scale.
  replace (dot (cross A e1) (cross A e1)) with (dot A A * dot e1 e1 - dot e1 A * dot e1 A) by (unfold cross, dot; cbn [px py pz]; ring).
  rewrite e1_unit, e1_perp, <- S. field. lra.
Qed.
Lemma e12 : dot e1 e2 = 0.
Proof. unfold e2. replace (dot e1 (scale (/ a) (cross A e1))) with (/ a * 0) by (unfold cross, dot, scale; cbn [px py pz]; ring). ring. Qed.
Lemma e2_perp : dot e2 A = 0.
Proof. unfold e2. replace (dot (scale (/ a) (cross A e1)) A) with (/ a * 0) by (unfold cross, dot, scale; cbn [px py pz]; ring). ring. Qed.
Lemma frame w : w = add (add (scale (dot w e1) e1) (scale (dot w e2) e2)) (scale (dot w A / dot A A) A).
Proof.
  pose proof a_pos. pose proof a_sqr as S.
  assert (F : scale (dot A A) w = add (add (scale (dot w e1 * dot A A) e1) (scale (dot w (cross A e1)) (cross A e1))) (scale (dot w A) A)).
  { transitivity (scale (dot A A * dot e1 e1 - dot e1 A * dot e1 A) w); [rewrite e1_unit, e1_perp; apply point_eq; unf; ring|].
    transitivity (add (add (scale (dot w e1 * dot A A - dot w A * dot e1 A) e1) (scale (dot w (cross A e1)) (cross A e1))) (scale (dot w A * dot e1 e1 - dot w e1 * dot e1 A) A)).
    - apply point_eq; unfold cross, dot, add, scale; cbn [px py pz]; ring.
    - rewrite e1_unit, e1_perp. apply point_eq; unf; ring. }
  assert (G : w = scale (/ dot A A) (scale (dot A A) w)) by (apply point_eq; unfold scale; cbn [px py pz]; field; lra).
  rewrite G, F at 1. unfold e2. replace (dot w (scale (/ a) (cross A e1))) with (/ a * dot w (cross A e1)) by (unfold dot, scale; cbn [px py pz]; ring).
  rewrite <- S. apply point_eq; unfold add, scale; cbn [px py pz]; field; lra.
Qed.
Lemma dot_frame x y z X Y Z : dot (add (add (scale x e1) (scale y e2)) (scale z A)) (add (add (scale X e1) (scale Y e2)) (scale Z A)) = x * X + y * Y + z * Z * dot A A.
Proof.
  transitivity (x * X * dot e1 e1 + y * Y * dot e2 e2 + z * Z * dot A A + (x * Y + y * X) * dot e1 e2 + (x * Z + z * X) * dot e1 A + (y * Z + z * Y) * dot e2 A).
  - unfold dot, add, scale; cbn [px py pz]. ring.
  - rewrite e1_unit, e2_unit, e12, e1_perp, e2_perp. ring.
Qed.
Lemma det_frame x y z X Y Z : det A (add (add (scale x e1) (scale y e2)) (scale z A)) (add (add (scale X e1) (scale Y e2)) (scale Z A)) = a * (x * Y - y * X).
Proof.
  transitivity ((x * Y - y * X) * det A e1 e2); [unfold det, add, scale; cbn [px py pz]; ring|].
  assert (D : det A e1 e2 = a * dot e2 e2).
  { unfold e2. pose proof a_pos. unfold det, dot, cross, scale; cbn [px py pz]. field. lra. }
  rewrite D, e2_unit. ring.
Qed.
Lemma polar_frame q rho psi z : polar q rho psi z -> sub q v = add (add (scale (rho * cos psi) e1) (scale (rho * sin psi) e2)) (scale z A).
Proof. intros [_ E]. rewrite E. unfold dir. apply point_eq; unf; ring. Qed.
Lemma frame_unique x y z X Y Z : add (add (scale x e1) (scale y e2)) (scale z A) = add (add (scale X e1) (scale Y e2)) (scale Z A) -> x = X /\ y = Y.
Proof.
  intros E. split.
  - pose proof (dot_frame x y z 1 0 0) as P. rewrite E, dot_frame in P. lra.
  - pose proof (dot_frame x y z 0 1 0) as P. rewrite E, dot_frame in P. lra.
Qed.

(** From a vertex to the next one the direction turns by the dihedral angle. *)
Lemma polar_next q r rho psi z : 0 < orient v p q r -> polar q rho psi z -> exists rho' z', polar r rho' (psi + dihedral v p q r) z'.
Proof.
  intros O H. pose proof (polar_frame _ _ _ _ H) as Q. destruct H as [Rho _]. pose proof (frame (sub r v)) as R.
  set (X := dot (sub r v) e1) in *. set (Y := dot (sub r v) e2) in *. set (z' := dot (sub r v) A / dot A A) in *.
  pose proof a_pos as AP. pose proof a_sqr as AS.
  assert (D : orient v p q r = a * (rho * cos psi * Y - rho * sin psi * X)) by (unfold orient; fold A; rewrite Q, R at 1; apply det_frame).
  set (S := cos psi * Y - sin psi * X). set (C := cos psi * X + sin psi * Y).
  assert (SP : 0 < S).
  { rewrite D in O. replace (a * (rho * cos psi * Y - rho * sin psi * X)) with (a * rho * S) in O by (unfold S; ring).
    assert (0 < a * rho) by (apply Rmult_lt_0_compat; lra). apply Rnot_le_lt. intros Z. assert (0 <= a * rho * - S) by (apply Rmult_le_pos; lra). lra. }
  assert (N : S * S + C * C = X * X + Y * Y).
  { transitivity ((sin psi * sin psi + cos psi * cos psi) * (X * X + Y * Y)); [unfold S, C; ring|rewrite squares; ring]. }
  set (m := sqrt (X * X + Y * Y)). assert (MP : 0 < m) by (apply sqrt_lt_R0; nra). assert (MS : m * m = X * X + Y * Y) by (apply sqrt_sqrt; nra).
  destruct (dihedral_cos v p q r ltac:(lra)) as [s [S1 [S2 S3]]]. fold A in S2, S3.
  assert (DA : forall x y z, dot (add (add (scale x e1) (scale y e2)) (scale z A)) A = z * dot A A).
  { intros x y u. pose proof (dot_frame x y u 0 0 1) as P. replace (add (add (scale 0 e1) (scale 0 e2)) (scale 1 A)) with A in P by (apply point_eq; unf; ring).
    rewrite P. ring. }
  unfold acpoly in S2, S3. rewrite Q, R in S2, S3. rewrite !DA in S2. rewrite !DA in S3. do 2 rewrite dot_frame in S2. rewrite dot_frame in S3. rewrite <- !AS in S2, S3.
  assert (Es : s = a * a * (rho * m)).
  { apply Rsqr_inj; [lra|repeat apply Rmult_le_pos; lra|]. unfold Rsqr. rewrite S2.
    transitivity (a * a * (a * a) * (rho * rho * ((sin psi * sin psi + cos psi * cos psi) * (X * X + Y * Y)))); [ring|rewrite squares, <- MS; ring]. }
  set (al := dihedral v p q r) in *.
  assert (CA : m * cos al = C).
  { assert (K : 0 < a * a * rho) by (repeat apply Rmult_lt_0_compat; lra). apply Rmult_eq_reg_l with (a * a * rho); [|lra].
    transitivity (cos al * s); [rewrite Es; ring|]. rewrite S3. unfold C. ring. }
  pose proof (dihedral_range v p q r ltac:(lra)) as AR. fold al in AR. pose proof (sin_gt_0 al ltac:(lra) ltac:(lra)) as SA.
  assert (SS : m * sin al = S).
  { apply Rsqr_inj; [apply Rmult_le_pos; lra|lra|]. unfold Rsqr. replace (S * S) with (m * m - C * C) by lra. rewrite <- CA. pose proof (squares al) as T.
    replace (m * sin al * (m * sin al)) with (m * m * (sin al * sin al)) by ring. replace (sin al * sin al) with (1 - cos al * cos al) by lra. ring. }
  exists m, z'. split; [exact MP|]. rewrite R at 1. unfold dir. rewrite cos_plus, sin_plus.
  assert (EX : m * (cos psi * cos al - sin psi * sin al) = X).
  { transitivity (cos psi * (m * cos al) - sin psi * (m * sin al)); [ring|]. rewrite CA, SS. unfold C, S.
    transitivity ((sin psi * sin psi + cos psi * cos psi) * X); [ring|rewrite squares; ring]. }
  assert (EY : m * (sin psi * cos al + cos psi * sin al) = Y).
  { transitivity (sin psi * (m * cos al) + cos psi * (m * sin al)); [ring|]. rewrite CA, SS. unfold C, S.
    transitivity ((sin psi * sin psi + cos psi * cos psi) * Y); [ring|rewrite squares; ring]. }
  rewrite <- EX at 1. rewrite <- EY at 1. apply point_eq; unf; ring.
Qed.
Lemma dir_between psi al om : sin al <> 0 ->
  dir om = add (scale (sin (psi + al - om) / sin al) (dir psi)) (scale (sin (om - psi) / sin al) (dir (psi + al))).
Proof.
  intros S. unfold dir. replace (psi + al - om) with (al - (om - psi)) by ring. set (d := om - psi). replace om with (psi + d) by (unfold d; ring).
  rewrite sin_minus, !cos_plus, !sin_plus. apply point_eq; unf; field; exact S.
Qed.
Lemma wedge q r rho psi z om : pos v p q r -> polar q rho psi z -> psi < om < psi + dihedral v p q r ->
  exists x y u, 0 < x /\ 0 < y /\ dir om = add (add (scale x (sub q v)) (scale y (sub r v))) (scale u (sub p v)).
Proof.
  intros [C O] H [L U]. set (al := dihedral v p q r) in *. pose proof (dihedral_range v p q r ltac:(lra)) as AR. fold al in AR.
  destruct (polar_next q r rho psi z O H) as [rho' [z' [R' H']]]. destruct H as [R H].
  pose proof (sin_gt_0 al ltac:(lra) ltac:(lra)) as SA. pose proof (sin_gt_0 (psi + al - om) ltac:(lra) ltac:(lra)) as S1. pose proof (sin_gt_0 (om - psi) ltac:(lra) ltac:(lra)) as S2.
  set (x := sin (psi + al - om) / sin al / rho). set (y := sin (om - psi) / sin al / rho').
  exists x, y, (- x * z - y * z'). split; [repeat apply Rdiv_lt_0_compat; auto|]. split; [repeat apply Rdiv_lt_0_compat; auto|].
  rewrite (dir_between psi al om) by lra. rewrite H, H'. fold al. fold A. unfold x, y. apply point_eq; unf; field; lra.
Qed.
Lemma same_wedge q r q' r' rho psi z rho' psi' z' : pos v p q r -> pos v p q' r' -> polar q rho psi z -> polar q' rho' psi' z' ->
  psi' <= psi < psi' + dihedral v p q' r' -> q = q' /\ r = r'.
Proof.
  intros C C' H H' [L U]. pose proof (dihedral_range v p q r ltac:(destruct C; lra)) as AR.
  set (om := psi + Rmin (dihedral v p q r) (psi' + dihedral v p q' r' - psi) / 2).
  assert (B : psi < om /\ om < psi + dihedral v p q r /\ om < psi' + dihedral v p q' r').
  { unfold om. pose proof (Rmin_l (dihedral v p q r) (psi' + dihedral v p q' r' - psi)). pose proof (Rmin_r (dihedral v p q r) (psi' + dihedral v p q' r' - psi)).
    assert (0 < Rmin (dihedral v p q r) (psi' + dihedral v p q' r' - psi)) by (apply Rmin_glb_lt; lra). lra. }
  destruct (wedge q r rho psi z om C H ltac:(lra)) as [x [y [u [X [Y E]]]]].
  destruct (wedge q' r' rho' psi' z' om C' H' ltac:(lra)) as [x' [y' [u' [X' [Y' E']]]]].
  destruct (overlap tiling v p q r q' r' x y u x' y' u' (proj1 C) (proj1 C') X Y X' Y' ltac:(congruence)) as [W|[W1 W2]]; [exact W|].
  exfalso. subst. destruct C as [_ O], C' as [_ O']. replace (orient v p r' q') with (- orient v p q' r') in O by (unf; ring). lra.
Qed.
Lemma polar_again q rho psi z : polar q rho psi z -> polar q rho (psi + 2 * PI) z.
Proof.
  intros [R H]. split; [exact R|]. rewrite H. unfold dir.
  rewrite <- (cos_period psi 1), <- (sin_period psi 1). cbn [INR]. rewrite Rmult_1_r. reflexivity.
Qed.
Lemma polar_exists q r : pos v p q r -> exists rho psi z, 0 <= psi < 2 * PI /\ polar q rho psi z.
Proof.
  intros [_ O]. pose proof (frame (sub q v)) as Q. set (X := dot (sub q v) e1) in *. set (Y := dot (sub q v) e2) in *. set (z := dot (sub q v) A / dot A A) in *.
  assert (N : 0 < X * X + Y * Y).
  { destruct (Req_dec X 0) as [X0|X0]; [destruct (Req_dec Y 0) as [Y0|Y0]|]; [|nra|nra]. exfalso.
    unfold orient in O. fold A in O. rewrite Q, X0, Y0, (frame (sub r v)), det_frame in O. lra. }
  set (m := sqrt (X * X + Y * Y)). assert (MP : 0 < m) by (apply sqrt_lt_R0; exact N). assert (MS : m * m = X * X + Y * Y) by (apply sqrt_sqrt; lra).
  assert (B : -1 <= X / m <= 1).
  { split; (apply Rmult_le_reg_r with m; [exact MP|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; nra). }
  set (al := acos (X / m)). assert (CA : m * cos al = X) by (unfold al; rewrite cos_acos by exact B; field; lra).
  pose proof (acos_bound (X / m)) as AB. fold al in AB. pose proof (sin_ge_0 al ltac:(lra) ltac:(lra)) as SA.
  assert (SS : m * sin al * (m * sin al) = Y * Y).
  { transitivity (m * m * (sin al * sin al)); [ring|]. replace (sin al * sin al) with (1 - cos al * cos al) by (pose proof (squares al); lra).
    transitivity (m * m - m * cos al * (m * cos al)); [ring|]. rewrite CA, MS. ring. }
  assert (K : forall psi, m * cos psi = X -> m * sin psi = Y -> polar q m psi z).
  { intros psi C S. split; [exact MP|]. rewrite Q at 1. rewrite <- C, <- S at 1. unfold dir. apply point_eq; unf; ring. }
  destruct (Rle_dec 0 Y) as [Y0|Y0].
  - exists m, al, z. pose proof PI_RGT_0. split; [lra|]. apply K; [exact CA|]. apply Rsqr_inj; [apply Rmult_le_pos; lra|lra|exact SS].
  - exists m, (- al + 2 * PI), z. assert (S0 : al <> 0) by (intros Z; rewrite Z, sin_0 in SS; nra). split; [lra|].
    apply polar_again, K; [rewrite cos_neg; exact CA|]. rewrite sin_neg.
    assert (E : m * sin al = - Y); [|lra]. apply Rsqr_inj; [apply Rmult_le_pos; lra|lra|]. unfold Rsqr. rewrite SS. ring.
Qed.
End Frame.

(** ** The cycle *)

Lemma step_over (f : nat -> R) x n : f 0%nat <= x < f n -> exists k, (k < n)%nat /\ f k <= x < f (S k).
Proof.
  induction n as [|n IH]; intros [A B]; [lra|]. destruct (Rle_dec (f n) x) as [L|L].
  - exists n. split; [lia|lra].
  - destruct IH as [k [K Q]]; [lra|]. exists k. split; [lia|exact Q].
Qed.

Section Fan.
Variables (v p : point) (c : nat -> point) (n : nat).
Hypothesis fan : forall k, pos v p (c k) (c (S k)).
Hypothesis n_pos : (0 < n)%nat.
Hypothesis closes : c n = c 0%nat.
Hypothesis first : forall k, (0 < k < n)%nat -> ~ (c k = c 0%nat /\ c (S k) = c 1%nat).
Fixpoint Phi k := match k with O => 0 | S k => Phi k + dihedral v p (c k) (c (S k)) end.

Let A := sub p v.
Let u := perp A (sub (c 0%nat) v).
Lemma A_positive : 0 < dot A A.
Proof. destruct (fan 0) as [_ O]. apply dot_self_pos. intros Z. unfold orient in O. fold A in O. rewrite Z in O. unf. lra. Qed.
Lemma u_perp : dot u A = 0.
Proof.
  pose proof A_positive. unfold u, perp. set (t := dot (sub (c 0%nat) v) A / dot A A).
  replace (dot (sub (sub (c 0%nat) v) (scale t A)) A) with (dot (sub (c 0%nat) v) A - t * dot A A) by (unfold dot; unf; ring). unfold t. field. lra.
Qed.
Lemma u_positive : 0 < dot u u.
Proof.
  apply dot_self_pos. intros Z. destruct (fan 0) as [_ O]. unfold orient in O. fold A in O.
  assert (E : sub (c 0%nat) v = scale (dot (sub (c 0%nat) v) A / dot A A) A).
  { set (t := dot (sub (c 0%nat) v) A / dot A A) in *. unfold u, perp in Z. fold t in Z. pose proof (f_equal px Z). pose proof (f_equal py Z). pose proof (f_equal pz Z). apply point_eq; unf; lra. }
  rewrite E in O. unf. lra.
Qed.
Let e1 := scale (/ norm u) u.
Lemma norm_u : 0 < norm u. Proof. apply sqrt_lt_R0, u_positive. Qed.
Lemma e1u : dot e1 e1 = 1.
Proof. pose proof norm_u. unfold e1. rewrite dot_scale, <- norm_sqr. field. lra. Qed.
Lemma e1p : dot e1 A = 0.
Proof. unfold e1. replace (dot (scale (/ norm u) u) A) with (/ norm u * dot u A) by (unfold dot, scale; cbn [px py pz]; ring). rewrite u_perp. ring. Qed.
Notation polar := (polar v p e1).

Lemma polar_zero : exists rho z, polar (c 0%nat) rho 0 z.
Proof.
  pose proof norm_u. exists (norm u), (dot (sub (c 0%nat) v) A / dot A A). split; [exact norm_u|]. unfold dir. rewrite cos_0, sin_0. fold A.
  set (t := dot (sub (c 0%nat) v) A / dot A A). assert (E : scale (norm u) e1 = sub (sub (c 0%nat) v) (scale t A)).
  { change (sub (sub (c 0%nat) v) (scale t A)) with u. unfold e1. apply point_eq; unf; field; lra. }
  transitivity (add (scale (norm u) e1) (scale t A)); [rewrite E|]; apply point_eq; unf; ring.
Qed.
Lemma polar_fan k : exists rho z, polar (c k) rho (Phi k) z.
Proof.
  induction k as [|k [rho [z IH]]]; [exact polar_zero|]. apply (polar_next v p e1 A_positive e1u e1p (c k) (c (S k)) rho (Phi k) z); [|exact IH]. apply fan.
Qed.
Lemma angle_k k : 0 < dihedral v p (c k) (c (S k)) < PI.
Proof. apply dihedral_range. destruct (fan k). lra. Qed.
Lemma Phi_pos k : 0 <= Phi k.
Proof. induction k; cbn [Phi]; [lra|]. pose proof (angle_k k). lra. Qed.

Theorem fan_sum : Phi n = 2 * PI.
Proof.
  destruct (polar_fan n) as [rho [z H]]. destruct polar_zero as [rho0 [z0 H0]]. rewrite closes in H. pose proof PI_RGT_0 as P0.
  pose proof (polar_frame _ _ _ _ _ _ _ H) as E. rewrite (polar_frame _ _ _ _ _ _ _ H0) in E.
  apply frame_unique in E; [|exact A_positive|exact e1u|exact e1p]. rewrite cos_0, sin_0 in E. destruct E as [EC ES]. destruct H as [Rho H], H0 as [Rho0 H0].
  assert (S0 : sin (Phi n) = 0) by nra. assert (C0 : 0 < cos (Phi n)) by nra.
  assert (N : Phi n <> 0). { destruct n as [|m]; [lia|]. cbn [Phi]. pose proof (Phi_pos m). pose proof (angle_k m). lra. }
  pose proof (Phi_pos n) as PP. destruct (Rtotal_order (Phi n) (2 * PI)) as [L|[L|L]]; [exfalso|exact L|exfalso].
  - destruct (Rtotal_order (Phi n) PI) as [Q|[Q|Q]].
    + pose proof (sin_gt_0 (Phi n) ltac:(lra) Q). lra.
    + rewrite Q, cos_PI in C0. lra.
    + pose proof (sin_lt_0 (Phi n) Q L). lra.
  - destruct (step_over Phi (2 * PI) n) as [k [K [B1 B2]]]; [cbn [Phi]; lra|].
    assert (K0 : (0 < k)%nat). { destruct k; [|lia]. cbn [Phi] in B2. pose proof (angle_k 0). lra. }
    destruct polar_zero as [r1 [z1 P1]]. apply polar_again in P1. destruct (polar_fan k) as [r2 [z2 P2]].
    destruct (same_wedge v p e1 A_positive e1u e1p (c 0%nat) (c 1%nat) (c k) (c (S k)) r1 (0 + 2 * PI) z1 r2 (Phi k) z2) as [W1 W2]; auto.
    + cbn [Phi] in B2. lra.
    + apply (first k); [lia|]. split; congruence.
Qed.
Theorem fan_all q r : pos v p q r -> exists k, (k < n)%nat /\ q = c k /\ r = c (S k).
Proof.
  intros H. destruct (polar_exists v p e1 A_positive e1u e1p q r H) as [rho [psi [z [B P]]]].
  destruct (step_over Phi psi n) as [k [K Q]]; [rewrite fan_sum; cbn [Phi]; lra|].
  exists k. split; [exact K|]. destruct (polar_fan k) as [r2 [z2 P2]].
  apply (same_wedge v p e1 A_positive e1u e1p q r (c k) (c (S k)) rho psi z r2 (Phi k) z2); auto.
Qed.
End Fan.
End Edge.
