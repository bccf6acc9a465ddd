(** * docs/lower-bound.md, section 13: a larger bound

    [above_bound] is for any theta that fulfils the demands of the link argument; then come the numbers for the angle
    with the cosine 0.28718, which is above 73.31 degrees. *)
From Coq Require Import Reals Lra Psatz Lia List Classical.
From Acutile Require Import Statement Tetrahedra.
From LowerBound Require Import Calculus Normals Corners Triangles Sides Decimals Link Steps Vertex Tiling Edge Around Theorem1.
Import ListNotations.
Open Scope R_scope.

(** (c) for the angles at three edges from a vertex *)
Definition feasible (theta A B C : R) := cos A + cos B + cos C <= (3 - 9 * cos theta ^ 2) / 2.

Section Bound.
Variables theta lambda eps : R.
Hypothesis range : 2 * PI / 5 < theta < 5 * PI / 12.
Hypothesis lambda_pos : 0 <= lambda.
Hypothesis eps_pos : 0 < eps.
Hypothesis all_pay : pays theta lambda eps 0 (feasible theta).
Hypothesis above_60 : forall A B C, mid theta A -> mid theta B -> mid theta C -> feasible theta A B C -> PI / 3 <= xs theta A B C.

(** No tetrahedra at a vertex have all dihedral angles at most theta, if they are as Theorem 2 needs them. *)
Lemma no_star (v : point) darts turn (six : dart -> bool) : star dart v darts turn along tip six ->
  (forall d x, In d darts -> In x (dihedrals (corner_tetrahedron v tip along d)) -> x <= theta) -> False.
Proof.
  intros S M. pose proof (star_link _ _ _ _ _ _ _ S) as L.
  set (ang := corner_angle v tip along) in *. set (len := fun d => angle (sub (tip d) v) (sub (tip (along d)) v)) in *.
  assert (A : forall d, In d darts -> ang d <= theta) by (intros d J; apply (M d); [exact J|left; reflexivity]).
  assert (F : forall c, In c darts -> six c = false -> six (along c) = false -> six (along (along c)) = false -> feasible theta (ang c) (ang (along c)) (ang (along (along c)))).
  { intros [[q r] s] J _ _ _. pose proof (star_solid _ _ _ _ _ _ _ S _ J) as So.
    pose proof (corollary_c v q r s theta So ltac:(lra) (fun x X => M _ x J X)) as Q. unfold feasible, ang, corner_angle. cbn [tip along fst].
    rewrite (dihedral_sym v r s q). exact Q. }
  pose proof (ang_middle _ _ _ _ _ _ _ L theta A) as AM. pose proof (link_along _ _ _ _ _ _ _ L) as Al.
  assert (X60 : forall c, In c darts -> six c = false -> six (along c) = false -> six (along (along c)) = false -> PI / 3 <= apex theta (len (along c))).
  { intros c J S0 S1 S2. pose proof (AM c J S0) as A0. pose proof (AM _ (Al _ J) S1) as A1. pose proof (AM _ (Al _ (Al _ J)) S2) as A2.
    pose proof (rule_a _ _ _ _ _ _ (link_spherical _ _ _ _ _ _ _ L c J)) as Ru.
    replace (apex theta (len (along c))) with (xs theta (ang c) (ang (along c)) (ang (along (along c)))); [apply above_60; auto|].
    unfold xs, apex. rewrite <- (side_cos_rule _ _ _ _ (proj2 (proj2 (mid_trig theta range _ A1))) (proj2 (proj2 (mid_trig theta range _ A2))) Ru). reflexivity. }
  destruct (nothing_left _ _ _ _ _ _ _ L theta range A X60 lambda eps 0 lambda_pos ltac:(lra) ltac:(lra) (feasible theta) F all_pay) as [d [_ [_ [_ [_ Z]]]]].
  lra.
Qed.

Section Tiling.
Context {index : Type} {is_tile : index -> Prop} {tile : index -> tetrahedron}.
Hypothesis tiling : space_tiling is_tile tile.
Lemma all_at_vertex v darts : (forall p q r, In (p, q, r) darts <-> @pos index is_tile tile v p q r) -> ~ (exists c x, is_tile c /\ In x (dihedrals (tile c)) /\ theta < x) ->
  forall d x, In d darts -> In x (dihedrals (corner_tetrahedron v tip along d)) -> x <= theta.
Proof.
  intros H N [[q r] s] x J X. apply H in J. destruct (cell_dihedrals tiling v q r s x (proj1 J) X) as [i [T Y]].
  apply Rnot_lt_le. intros Z. apply N. exists i, x. auto.
Qed.
Theorem above_bound p z : good_bound theta p z -> exists c x, is_tile c /\ In x (dihedrals (tile c)) /\ theta < x.
Proof.
  intros good. apply NNPP. intros N. destruct (other_valence tiling) as [v [darts [d0 [D [H [I0 V]]]]]].
  pose proof (vertex_star_of_tiling tiling v darts D H) as S. pose proof (all_at_vertex v darts H N) as M.
  exact (no_star v darts _ _ (vertex_is_star _ _ _ _ _ _ _ S theta p z good M (ex_intro _ d0 (conj I0 V))) M).
Qed.

(** TCP: all valences are 5 or 6, and no triangle has two edges of valence 6.  Then Steps A and B are not needed. *)
Definition space_tcp := (forall c u v, has_edge is_tile tile u v c -> u <> v -> edge_valence is_tile tile u v 5 \/ edge_valence is_tile tile u v 6) /\
  (forall c u v w, is_tile c -> In u (verts (tile c)) -> In v (verts (tile c)) -> In w (verts (tile c)) -> u <> v -> u <> w -> v <> w ->
     ~ (edge_valence is_tile tile u v 6 /\ edge_valence is_tile tile u w 6)).
Theorem above_bound_tcp : space_tcp -> exists c x, is_tile c /\ In x (dihedrals (tile c)) /\ theta < x.
Proof.
  intros [T1 T2]. apply NNPP. intros N. destruct (other_valence tiling) as [v [darts [d0 [D [H [I0 V]]]]]]. pose proof (all_at_vertex v darts H N) as M.
  refine (no_star v darts _ _ (tcp_star tiling v darts D H _ _ (ex_intro _ d0 (conj I0 V))) M).
  - intros w c E Ne. exact (T1 c v w E Ne).
  - intros c w w' Tc. exact (T2 c v w w' Tc).
Qed.
End Tiling.
End Bound.

(** ** The angle with the cosine 0.28718 *)

Definition c8 := 0.28718.
Definition theta8 := acos c8.
Notation T := theta8.
Lemma cT : cos T = c8.
Proof. apply cos_acos. unfold c8. lra. Qed.
Lemma T_acute : 0 < T < PI / 2.
Proof.
  pose proof (acos_bound c8) as B. fold T in B. pose proof cT as E. unfold c8 in E.
  split; apply Rnot_le_lt; intros Z; [replace T with 0 in E by lra; rewrite cos_0 in E; lra|]. pose proof (cos_le_0 T Z ltac:(lra)). lra.
Qed.
Lemma cosT : cos T = 0.28718.
Proof. exact cT. Qed.
Notation a := (a0 T).
Lemma ca_is : 0.39463 < cos a < 0.39464.
Proof. rewrite cos_a0, cosT. lra. Qed.
Lemma T_range : 2 * PI / 5 < T < 5 * PI / 12.
Proof. apply range_from; [exact T_acute|rewrite cosT; lra|pose proof ca_is; rewrite cosT; lra]. Qed.
Lemma sT_is : 0.95787 < sin T < 0.95788 /\ sin T * sin T = 1 - 0.28718 * 0.28718.
Proof.
  pose proof (squares T) as S. rewrite cosT in S. pose proof T_acute. pose proof (sin_pos T ltac:(lra)).
  split; [split; apply Rnot_le_lt; intros Z; nra|lra].
Qed.
(** D1, D2, K and C of sections 8 and 9 *)
Definition D1 := sin a / sin T.
Lemma D1_is : D1 = 4 * 0.28718 * (1 - 2 * 0.28718 ^ 2).
Proof. pose proof sT_is. unfold D1. rewrite sin_a0, cosT. field. lra. Qed.
Lemma D1_range : 0.9592 < D1 < 0.9593.
Proof. rewrite D1_is. lra. Qed.
Lemma k_range : 0.4028 < 0.28718 / (1 - 0.28718) < 0.4029.
Proof. lra. Qed.
Lemma K_range : 1.8176 < K T < 1.8177.
Proof.
  pose proof sT_is as [S _]. unfold K. rewrite sin_2a, cosT.
  split; (apply Rmult_lt_reg_r with (2 * sin T * 0.28718); [lra|]; rewrite Rinv_l by lra; lra).
Qed.
Lemma C_below : 0 < C T (PI / 3) < 1.4312.
Proof.
  pose proof sT_is as [S S2]. pose proof D1_range as D. pose proof root3 as [R3 R3']. split; [exact (C_pos T T_range)|].
  unfold C, tan. rewrite sin_PI3, cosT. replace (sin a) with (D1 * sin T) by (unfold D1; field; lra).
  replace ((1 - 0.28718) / 2 * (sin T / 0.28718) * sin T / (D1 * sin T * (sqrt 3 / 2))) with ((1 - 0.28718) * sin T / (0.28718 * (D1 * sqrt 3))) by (field; lra).
  assert (0.9592 * 1.73205 <= D1 * sqrt 3) by (apply Rmult_le_compat; lra).
  apply Rmult_lt_reg_r with (0.28718 * (D1 * sqrt 3)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.

(** *** x of the smallest side; kappa; the least excess *)
Notation X := (xs T).
Lemma ratio_a : 0.411 < cos a / D1 < 0.4115.
Proof.
  pose proof ca_is. pose proof D1_range. split; (apply Rmult_lt_reg_r with D1; [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra).
Qed.
Lemma x0_above : PI / 3 - 0.01825 <= X a a a.
Proof.
  pose proof (mid_a T T_range) as H0. pose proof (mid_theta T T_range) as HT. destruct (xs_range T T_range T HT a a a H0 H0 H0) as [B E]. pose proof (between T T_range). pose proof PI_RGT_0.
  pose proof PI2_3_2 as P3. apply angle_le; [lra|lra|]. rewrite E, cosT. pose proof ca_is as CA. pose proof sT_is as [_ S2]. pose proof (squares a) as SA. pose proof (Sides.numbers T T_range) as [_ [_ [_ [N4 _]]]].
  assert (Q : side_cos a a a <= 0.65192).
  { unfold side_cos. apply Rmult_le_reg_r with (sin a * sin a); [nra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by nra.
    replace (sin a * sin a) with ((1 - cos a) * (1 + cos a)) by lra. assert (0 <= (1 + cos a) * (0.65192 * (1 - cos a) - cos a)) by (apply Rmult_le_pos; lra). lra. }
  replace (sin T ^ 2) with (1 - 0.28718 * 0.28718) by lra.
  rewrite cos_minus, cos_PI3, sin_PI3. pose proof (cos_square 0.01825). pose proof (sin_cubic 0.01825 ltac:(lra)). pose proof root3 as [_ R3].
  assert (1.73205 * 0.018246 <= sqrt 3 * sin 0.01825) by (apply Rmult_le_compat; lra). lra.
Qed.
Lemma kappa_above : 0.1141 <= kappa T.
Proof.
  pose proof (between T T_range) as [B _]. replace (kappa T) with (T - a) by (unfold kappa, a0; ring). pose proof (sin_below (T - a) ltac:(lra)) as S.
  rewrite sin_minus, sin_a0, cos_a0, cosT in S. pose proof sT_is. lra.
Qed.
Lemma excess_above A B C' : mid T A -> mid T B -> mid T C' -> feasible T A B C' -> 0.0574 <= (A - a) + (B - a) + (C' - a).
Proof.
  intros HA HB HC F. unfold feasible in F. rewrite cosT in F. pose proof (between T T_range) as BT. unfold mid in *.
  pose proof (cos_falls a A T ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)). pose proof (cos_falls a B T ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)). pose proof (cos_falls a C' T ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
  set (S := (A - a) + (B - a) + (C' - a)). assert (0.05502 <= sin T * S) by (pose proof (cos_a0 T) as E; rewrite cosT in E; unfold S; lra).
  pose proof sT_is as [[_ S1] _]. assert (0 <= S) by (unfold S; lra). assert (sin T * S <= 0.95788 * S) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma X_above A B C' : mid T A -> mid T B -> mid T C' -> PI / 3 - 0.01825 + 0.9592 * (A - a) + 0.3863 * ((B - a) + (C' - a)) <= X A B C'.
Proof.
  intros HA HB HC. pose proof (xs_above T T_range T (mid_theta T T_range) A B C' HA HB HC) as L. pose proof x0_above. pose proof D1_range as DR. rewrite cosT in L. fold D1 in L.
  pose proof k_range as KR. unfold mid in *. assert (0.9592 * (A - a) <= D1 * (A - a)) by (apply Rmult_le_compat_r; lra).
  assert (0.3863 * ((B - a) + (C' - a)) <= D1 * (0.28718 / (1 - 0.28718)) * ((B - a) + (C' - a))).
  { apply Rmult_le_compat_r; [lra|]. apply Rle_trans with (0.9592 * 0.4028); [lra|apply Rmult_le_compat; lra]. }
  lra.
Qed.
Lemma above_60_8 A B C' : mid T A -> mid T B -> mid T C' -> feasible T A B C' -> PI / 3 <= X A B C'.
Proof.
  intros HA HB HC F. pose proof (X_above A B C' HA HB HC). pose proof (excess_above A B C' HA HB HC F). unfold mid in *. lra.
Qed.
(** A triangle with a small sum of excesses has long sides. *)
Lemma X_above_small A B C' : mid T A -> mid T B -> mid T C' -> (A - a) + (B - a) + (C' - a) <= 0.0672 ->
  PI / 3 - 0.01825 + 0.9592 * (A - a) + 0.4728 * ((B - a) + (C' - a)) <= X A B C'.
Proof.
  intros HA HB HC S. pose proof kappa_above as KA. pose proof (between T T_range) as BT. unfold kappa in KA. set (b := a + 0.0672). unfold mid in HA, HB, HC.
  assert (Hb : mid T b) by (unfold mid, b, a0 in *; lra). assert (HbT : b <= T) by apply Hb.
  pose proof (xs_above T T_range b Hb A B C' ltac:(unfold upto, b; lra) ltac:(unfold upto, b; lra) ltac:(unfold upto, b; lra)) as L. fold D1 in L. pose proof x0_above. pose proof D1_range as DR.
  pose proof (cos_falls a b T ltac:(lra) ltac:(unfold b; lra) HbT ltac:(lra)) as CF. pose proof sT_is as [[S0 S1] _]. pose proof ca_is as CA.
  assert (S2 : sin T * (b - a) <= 0.95788 * 0.0672) by (apply Rmult_le_compat; try unfold b; lra).
  pose proof (mid_trig T T_range b Hb) as [_ [[_ M] _]].
  assert (KB : 0.493 <= cos b / (1 - cos b)) by (apply Rmult_le_reg_r with (1 - cos b); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra).
  assert (0.9592 * (A - a) <= D1 * (A - a)) by (apply Rmult_le_compat_r; lra).
  assert (0.4728 * ((B - a) + (C' - a)) <= D1 * (cos b / (1 - cos b)) * ((B - a) + (C' - a))).
  { apply Rmult_le_compat_r; [lra|]. apply Rle_trans with (0.9592 * 0.493); [lra|apply Rmult_le_compat; lra]. }
  lra.
Qed.
Lemma f_fast : (K T + 0) * (1 - cos T) * sin (X a T a) <= 3 * sin T ^ 2 * (cos a / sin a).
Proof.
  pose proof (mid_theta T T_range) as HT. pose proof (mid_a T T_range) as H0. destruct (xs_range T T_range T HT a T a H0 HT H0) as [B _]. pose proof (f_end T T_range) as E. set (F := X a T a) in *.
  pose proof sT_is as [S1 S2]. pose proof D1_range as DR. pose proof ratio_a as RA. pose proof (between T T_range) as BT. pose proof K_range as KR.
  assert (Q : cos a / sin a = cos a / D1 / sin T) by (unfold D1; field; pose proof (Sides.numbers T T_range); lra).
  rewrite Q, cosT in E |- *. replace (sin T * (cos a / D1 / sin T)) with (cos a / D1) in E by (field; lra).
  replace (3 * sin T ^ 2 * (cos a / D1 / sin T)) with (3 * sin T * (cos a / D1)) by (field; lra).
  pose proof (squares F) as SF. pose proof (sin_ge_0 F ltac:(lra) ltac:(lra)) as SF0.
  assert (C1 : 0.446 <= cos F) by lra. assert (C2 : 0.446 * 0.446 <= cos F * cos F) by (apply Rmult_le_compat; lra).
  assert (SF1 : sin F < 0.8951) by (apply Rnot_le_lt; intros Z; assert (0.8951 * 0.8951 <= sin F * sin F) by (apply Rmult_le_compat; lra); lra).
  assert (P1 : (K T + 0) * (1 - 0.28718) * sin F <= 1.8177 * 0.71282 * 0.8951) by (repeat apply Rmult_le_compat; try lra; apply Rmult_le_pos; lra).
  assert (P2 : 3 * 0.95787 * 0.411 <= 3 * sin T * (cos a / D1)) by (apply Rmult_le_compat; lra). lra.
Qed.

Lemma pays8 : pays T 0.53 0.0005 0 (feasible T).
Proof.
  pose proof K_range as KR. pose proof C_below as CB. pose proof kappa_above as KA. pose proof D1_range as DR. pose proof k_range as kR.
  split; intros A B C' HA HB HC F; pose proof (excess_above A B C' HA HB HC F) as SE.
  - set (S := (A - a) + (B - a) + (C' - a)) in *. assert (KS : K T * S <= 1.8177 * S) by (apply Rmult_le_compat_r; lra).
    destruct (Rle_dec S 0.0672) as [L|L].
    + pose proof (X_above_small A B C' HA HB HC ltac:(unfold S in L; lra)). pose proof (X_above_small B C' A HB HC HA ltac:(unfold S in L; lra)). pose proof (X_above_small C' A B HC HA HB ltac:(unfold S in L; lra)).
      unfold S in *. lra.
    + pose proof (X_above A B C' HA HB HC). pose proof (X_above B C' A HB HC HA). pose proof (X_above C' A B HC HA HB). unfold S in *. lra.
  - pose proof (utt_from_f T T_range A B C' 0 HA HB HC ltac:(lra) f_fast) as L. pose proof x0_above. rewrite cosT in L. fold D1 in L. unfold mid in *.
    set (s := (B - a) + (C' - a)) in *. assert (s0 : 0 <= s) by (unfold s; lra).
    assert (Q : 3 / 2 * (0.9592 + 0.3863) * s <= 3 / 2 * (D1 + D1 * (0.28718 / (1 - 0.28718))) * s).
    { apply Rmult_le_compat_r; [lra|]. assert (0.9592 * 0.4028 <= D1 * (0.28718 / (1 - 0.28718))) by (apply Rmult_le_compat; lra). lra. }
    assert (Q' : C T (PI / 3) * s <= 1.4312 * s) by (apply Rmult_le_compat_r; lra). lra.
  - pose proof (X_above A B C' HA HB HC). unfold mid in *. unfold kappa, a0 in *. lra.
Qed.
Lemma good8 : good_bound T 1.093 0.8885.
Proof.
  assert (Q : 0.5372 < least_cos T < 0.53721) by (unfold least_cos; rewrite cosT; lra).
  split; [exact T_acute|lra|lra|lra|]. cbv zeta. rewrite cosT. set (q := least_cos T) in *.
  assert (Q2 : 0.5372 * 0.5372 <= q * q <= 0.53721 * 0.53721) by (split; apply Rmult_le_compat; lra).
  assert (Q3 : 0.5372 * (3 - 4 * (0.53721 * 0.53721)) <= q * (3 - 4 * (q * q))) by (apply Rmult_le_compat; lra).
  assert ((1 - 2 * (0.53721 * 0.53721)) * (0.5372 * (3 - 4 * (0.53721 * 0.53721))) <= (1 - 2 * q ^ 2) * (3 * q - 4 * q ^ 3)) by (apply Rmult_le_compat; lra). lra.
Qed.

(** ** 73.31 degrees *)
Lemma degrees : 73.31 * PI / 180 < T.
Proof.
  pose proof PI_between as P. pose proof T_range. set (d := 1.69 * PI / 180). assert (D : 0.029495 <= d <= 0.0296) by (unfold d; lra).
  apply Rnot_le_lt. intros L. pose proof (cos_le T (PI / 4 + PI / 6 - d) ltac:(lra) ltac:(unfold d; lra) ltac:(lra)) as Q.
  rewrite cosT, cos_minus, cos_plus, sin_plus, cos_PI4, sin_PI4, cos_PI6, sin_PI6 in Q.
  pose proof root3 as [_ R3]. pose proof (sqrt_sqrt 2 ltac:(lra)) as R2. pose proof (sqrt_lt_R0 2 ltac:(lra)). assert (R : 1.41421 < sqrt 2) by nra.
  replace (1 / sqrt 2) with (sqrt 2 / 2) in Q by (apply Rmult_eq_reg_r with (sqrt 2); [field_simplify; lra|lra]).
  pose proof (cos_square d) as CD. pose proof (sin_cubic d ltac:(lra)) as [SD _].
  assert (DD : d * d <= 0.0296 * 0.0296) by (apply Rmult_le_compat; lra). assert (0.029495 * (1 - 0.0296 * 0.0296 / 6) <= d * (1 - d * d / 6)) by (apply Rmult_le_compat; lra).
  assert (1.41421 * 0.73205 <= sqrt 2 * (sqrt 3 - 1)) by (apply Rmult_le_compat; lra). assert (1.41421 * 2.73205 <= sqrt 2 * (sqrt 3 + 1)) by (apply Rmult_le_compat; lra).
  assert (1.41421 * 0.73205 * 0.99956 <= sqrt 2 * (sqrt 3 - 1) * cos d) by (apply Rmult_le_compat; lra).
  assert (1.41421 * 2.73205 * (0.029495 * (1 - 0.0296 * 0.0296 / 6)) <= sqrt 2 * (sqrt 3 + 1) * sin d) by (apply Rmult_le_compat; lra). lra.
Qed.

(** Theorem 8: for any tiling of space, and in the words of Statement.v. *)
Theorem theorem_8_space index (is_tile : index -> Prop) tile : space_tiling is_tile tile ->
  exists c x, is_tile c /\ In x (dihedrals (tile c)) /\ 73.31 * PI / 180 < x.
Proof.
  intros H. destruct (above_bound T 0.53 0.0005 T_range ltac:(lra) ltac:(lra) pays8 above_60_8 H 1.093 0.8885 good8) as [c [x [A [B D]]]].
  exists c, x. pose proof degrees. split; [exact A|]. split; [exact B|lra].
Qed.
Theorem theorem_8 l1 l2 l3 (Omega : point -> Prop) N P : (forall X, Omega X) -> face_to_face_tiling l1 l2 l3 3 Omega N P ->
  exists c x, is_tile 3 N c /\ In x (dihedrals (tile l1 l2 l3 P c)) /\ 73.31 * PI / 180 < x.
Proof. intros O H. exact (theorem_8_space _ _ _ (periodic_space l1 l2 l3 Omega N P O H)). Qed.
