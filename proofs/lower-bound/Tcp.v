(** * docs/lower-bound.md, section 14: Theorem 7, by boxes

    theta is the angle with the cosine 0.285019, which is above 73.44 degrees. *)
From Coq Require Import Reals Lra Psatz Lia List ZArith Bool.
From Acutile Require Import Statement Tetrahedra.
From LowerBound Require Import Calculus Normals Corners Triangles Sides Boxes Decimals Search Link Tiling Theorem1 Larger.
Import ListNotations.
Open Scope R_scope.

Definition theta7 := acos 0.285019.
Notation T := theta7.
Notation a := (a0 T).
Lemma cosT : cos T = 0.285019.
Proof. apply cos_acos. lra. Qed.
Lemma T_acute : 0 < T < PI / 2.
Proof.
  pose proof (acos_bound 0.285019) as B. fold T in B. pose proof cosT as E.
  split; apply Rnot_le_lt; intros Z; [replace T with 0 in E by lra; rewrite cos_0 in E; lra|]. pose proof (cos_le_0 T Z ltac:(lra)). lra.
Qed.
Lemma ca_is : cos a = 8 * 0.285019 ^ 4 - 8 * 0.285019 ^ 2 + 1.
Proof. rewrite cos_a0, cosT. reflexivity. Qed.
Lemma T_range : 2 * PI / 5 < T < 5 * PI / 12.
Proof. apply range_from; [exact T_acute|rewrite cosT; lra|rewrite ca_is, cosT; lra]. Qed.
Lemma sT_is : 0.958521867 < sin T < 0.958521868 /\ sin T * sin T = 1 - 0.285019 * 0.285019.
Proof.
  pose proof (squares T) as S. rewrite cosT in S. pose proof T_acute. pose proof (sin_pos T ltac:(lra)).
  split; [split; apply Rnot_le_lt; intros Z; nra|lra].
Qed.
Lemma kappa_range : 0.12566507 < kappa T < 0.1256654.
Proof.
  pose proof T_range. pose proof (between T T_range) as [B _]. pose proof PI2_3_2. pose proof PI_between as P. pose proof sT_is as [S _].
  assert (E : sin (kappa T) = sin T * (16 * 0.285019 ^ 4 - 12 * 0.285019 ^ 2 + 1)).
  { replace (kappa T) with (T - a) by (unfold kappa, a0; ring). rewrite sin_minus, sin_a0, cos_a0, cosT. ring. }
  assert (K : 0 < kappa T < 1) by (unfold kappa; lra). split; apply Rnot_le_lt; intros L.
  - pose proof (sin_le (kappa T) 0.12566507 ltac:(lra) ltac:(lra) ltac:(lra)) as Q. pose proof (sin_cubic 0.12566507 ltac:(lra)). lra.
  - pose proof (sin_le 0.1256654 (kappa T) ltac:(lra) ltac:(lra) ltac:(lra)) as Q. pose proof (sin_cubic 0.1256654 ltac:(lra)). lra.
Qed.
(** ** The grid *)
Definition first_entry := Entry 108154641 108154642 245683062 245683064.
Definition step_entry := Entry 268434938 268434939 527077 527079.
Definition table := points 65 step_entry first_entry.
Definition at7 (i : nat) := nth i table first_entry.
Lemma first_holds : holds first_entry a.
Proof. pose proof sT_is as [S _]. unfold holds, first_entry, u, U; cbn [cl ch sl sh]. rewrite ca_is, sin_a0, cosT. lra. Qed.
Lemma step_holds : holds step_entry (kappa T / 64).
Proof.
  pose proof kappa_range as K. set (h := kappa T / 64). assert (H : 0.12566507 / 64 < h < 0.1256654 / 64) by (unfold h; lra).
  pose proof (cos_square h) as C1. pose proof (cos_quartic h ltac:(lra)) as C2. pose proof (sin_cubic h ltac:(lra)) as [S1 _].
  assert (S2 : sin h <= h).
  { pose proof (sin_cubic h ltac:(lra)) as [_ Q]. assert (H2 : 0 <= h * h <= 1) by (split; [apply Rmult_le_pos; lra|replace 1 with (1 * 1) by lra; apply Rmult_le_compat; lra]).
    assert (0 <= h * h * h * (20 - h * h)) by (repeat apply Rmult_le_pos; lra). lra. }
  assert (H2 : 0.12566507 / 64 * (0.12566507 / 64) <= h * h <= 0.1256654 / 64 * (0.1256654 / 64)) by (split; apply Rmult_le_compat; lra).
  assert (H4 : 0 <= h * h * (h * h) <= 0.1256654 / 64 * (0.1256654 / 64) * (0.1256654 / 64 * (0.1256654 / 64))) by (split; [repeat apply Rmult_le_pos; lra|apply Rmult_le_compat; lra]).
  assert (H3 : h * h * h <= 0.1256654 / 64 * (0.1256654 / 64) * (0.1256654 / 64)) by (apply Rmult_le_compat; lra).
  unfold holds, step_entry, u, U; cbn [cl ch sl sh]. lra.
Qed.
Lemma table_positive : forallb positive_entry table = true.
Proof. vm_compute. reflexivity. Qed.
Lemma at7_holds i : (i <= 64)%nat -> holds (at7 i) (grid_angle T i) /\ positive_entry (at7 i) = true.
Proof.
  intros I. split.
  - exact (points_hold step_entry (kappa T / 64) eq_refl step_holds 65 first_entry a first_holds table_positive i first_entry ltac:(lia)).
  - apply (proj1 (forallb_forall positive_entry table) table_positive). apply nth_In. change (i < 65)%nat. lia.
Qed.
Definition S2l := 246628878%Z.
Definition S2h := 246628879%Z.
Definition C2l := 21806577%Z.
Definition C2h := 21806578%Z.
Definition kH := 33733049%Z.
Definition mH := 304523587%Z.
Lemma s_holds : (0 <= S2l)%Z /\ IZR S2l <= u * sin T ^ 2 <= IZR S2h.
Proof. pose proof sT_is as [_ S]. replace (sin T ^ 2) with (1 - 0.285019 * 0.285019) by lra. unfold S2l, S2h, u, U. split; [lia|lra]. Qed.
Lemma c_holds : IZR C2l <= u * cos T ^ 2 <= IZR C2h.
Proof. rewrite cosT. unfold C2l, C2h, u, U. lra. Qed.
Lemma k_holds : u * kappa T <= IZR kH.
Proof. pose proof kappa_range. unfold kH, u, U. lra. Qed.
Lemma m_holds : u * ((3 - 9 * cos T ^ 2) / 2) <= IZR mH.
Proof. rewrite cosT. unfold mH, u, U. lra. Qed.

(** ** The four claims; the rates K, C + lambda, lambda, and lambda kappa *)
Definition lambda := 337 / 400.
Definition above_60_claim := Claim 2 0 0 0 0 0 0 [5%Z].
Definition uuu_claim := Claim 4 4 4 491287888 491287888 491287888 0 [24; 21; 27; 18; 30]%Z.
Definition utt_claim := Claim 0 3 3 491287888 616432497 616432497 28420019 [0; 3]%Z.
Definition tt_claim := Claim 2 0 0 0 226156872 226156872 28420019 [0%Z].
Notation found c sorted := (search at7 S2l S2h C2l C2h kH mH c sorted 20 0 0 0 64 64 64).
Lemma above_60_found : found above_60_claim false = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma uuu_found : found uuu_claim true = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma utt_found : found utt_claim false = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma tt_found : found tt_claim false = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
(* no tactic computes the search again *)
Opaque search.
Lemma found_holds c sorted A B D : found c sorted = true -> mid T A -> mid T B -> mid T D -> (sorted = true -> A <= B <= D) -> feasible T A B D -> claim_holds T c A B D.
Proof.
  intros Fo HA HB HD So F.
  assert (G : grid_angle T 0 = a /\ grid_angle T 64 = T) by (unfold grid_angle, kappa, a0; split; [change (INR 0) with 0|replace (INR 64) with 64 by (rewrite INR_IZR_INZ; reflexivity)]; lra).
  destruct G as [G0 G1].
  refine (search_sound at7 S2l S2h C2l C2h kH mH T T_range at7_holds s_holds c_holds k_holds m_holds c sorted 20 0 0 0 64 64 64 A B D _ _ _ Fo _ So F); [lia|lia|lia|].
  unfold in_box, inb. rewrite G0, G1. unfold mid in *. lra.
Qed.
Lemma K_range : 1.8301 < K T < 1.83019.
Proof.
  pose proof sT_is as [S _]. unfold K. rewrite sin_2a, cosT.
  split; (apply Rmult_lt_reg_r with (2 * sin T * 0.285019); [lra|]; rewrite Rinv_l by lra; lra).
Qed.
Lemma C_below : 0 < C T (PI / 3) < 1.45389.
Proof.
  pose proof sT_is as [S S2]. pose proof root3 as [R3 R3']. split; [exact (C_pos T T_range)|].
  unfold C, tan. rewrite sin_PI3, sin_a0, cosT.
  replace ((1 - 0.285019) / 2 * (sin T / 0.285019) * sin T / (4 * 0.285019 * (1 - 2 * 0.285019 ^ 2) * sin T * (sqrt 3 / 2)))
    with ((1 - 0.285019) * sin T / (0.285019 * (4 * 0.285019 * (1 - 2 * 0.285019 ^ 2) * sqrt 3))) by (field; lra).
  apply Rmult_lt_reg_r with (0.285019 * (4 * 0.285019 * (1 - 2 * 0.285019 ^ 2) * sqrt 3)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.
Lemma uuu_sorted A B D : mid T A -> mid T B -> mid T D -> A <= B <= D -> feasible T A B D ->
  1 / 100000 <= 2 * (xs T A B D - PI / 3) + 2 * (xs T B D A - PI / 3) + 2 * (xs T D A B - PI / 3) - K T * (A - a) - K T * (B - a) - K T * (D - a).
Proof.
  intros HA HB HD So F.
  pose proof K_range as KR. assert (K0 : u * K T <= 491287888) by (unfold u, U; lra).
  pose proof (found_holds uuu_claim true A B D uuu_found HA HB HD (fun _ => So) F 0 (K T) (K T) (K T) ltac:(lra) ltac:(lra) ltac:(lra) K0 K0 K0 ltac:(cbn; lra)) as H.
  cbn [w1 w2 w3 uuu_claim] in H. lra.
Qed.
Lemma pays7 : pays T lambda (1 / 100000) 0 (feasible T).
Proof.
  pose proof K_range as KR. pose proof C_below as CB. pose proof kappa_range as KA.
  assert (K0 : u * K T <= 491287888) by (unfold u, U; lra). assert (C0 : u * (C T (PI / 3) + lambda) <= 616432497) by (unfold lambda, u, U; lra).
  assert (L0 : u * lambda <= 226156872) by (unfold lambda, u, U; lra). assert (L1 : 28420019 <= u * (lambda * kappa T)) by (unfold lambda, u, U; lra).
  split; intros A B D HA HB HD F.
  - assert (P : forall x y z, feasible T x y z -> feasible T x z y /\ feasible T y x z) by (unfold feasible; intros; lra).
    pose proof (P _ _ _ F) as [F1 F2]. pose proof (P _ _ _ F1) as [_ F3]. pose proof (P _ _ _ F2) as [F4 _]. pose proof (P _ _ _ F3) as [F5 _].
    pose proof (xs_sym T A B D) as E1. pose proof (xs_sym T B D A) as E2. pose proof (xs_sym T D A B) as E3.
    destruct (Rle_dec A B) as [AB|AB], (Rle_dec B D) as [BD|BD], (Rle_dec A D) as [AD|AD].
    1,2: pose proof (uuu_sorted A B D HA HB HD ltac:(lra) F); lra.
    + pose proof (uuu_sorted A D B HA HD HB ltac:(lra) F1). lra.
    + pose proof (uuu_sorted D A B HD HA HB ltac:(lra) F3). lra.
    + pose proof (uuu_sorted B A D HB HA HD ltac:(lra) F2). lra.
    + pose proof (uuu_sorted B D A HB HD HA ltac:(lra) F4). lra.
    + pose proof (uuu_sorted D B A HD HB HA ltac:(lra) F5). lra.
    + pose proof (uuu_sorted D B A HD HB HA ltac:(lra) F5). lra.
  - pose proof (found_holds utt_claim false A B D utt_found HA HB HD ltac:(discriminate) F (lambda * kappa T) (K T) (C T (PI / 3) + lambda) (C T (PI / 3) + lambda)
      ltac:(lra) ltac:(unfold lambda; lra) ltac:(unfold lambda; lra) K0 C0 C0 L1) as H. cbn [w1 w2 w3 utt_claim] in H. lra.
  - pose proof (found_holds tt_claim false A B D tt_found HA HB HD ltac:(discriminate) F (lambda * kappa T) 0 lambda lambda
      ltac:(lra) ltac:(unfold lambda; lra) ltac:(unfold lambda; lra) ltac:(cbn; lra) L0 L0 L1) as H. cbn [w1 w2 w3 tt_claim] in H. lra.
Qed.
Lemma above_60_7 A B D : mid T A -> mid T B -> mid T D -> feasible T A B D -> PI / 3 <= xs T A B D.
Proof.
  intros HA HB HD F.
  pose proof (found_holds above_60_claim false A B D above_60_found HA HB HD ltac:(discriminate) F 0 0 0 0 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(cbn; lra) ltac:(cbn; lra) ltac:(cbn; lra) ltac:(cbn; lra)) as H.
  cbn [w1 w2 w3 above_60_claim] in H. lra.
Qed.

(** ** 73.44 degrees *)
Lemma degrees : 73.44 * PI / 180 < T.
Proof.
  pose proof PI_between as P. pose proof T_range. set (d := 1.56 * PI / 180). assert (D : 0.0272271 <= d <= 0.027229) by (unfold d; lra).
  apply Rnot_le_lt. intros L. pose proof (cos_le T (PI / 4 + PI / 6 - d) ltac:(lra) ltac:(unfold d; lra) ltac:(lra)) as Q.
  rewrite cosT, cos_minus, cos_plus, sin_plus, cos_PI4, sin_PI4, cos_PI6, sin_PI6 in Q. pose proof roots as [R2 R3].
  replace (1 / sqrt 2) with (sqrt 2 / 2) in Q by (apply Rmult_eq_reg_r with (sqrt 2); [pose proof (sqrt_sqrt 2 ltac:(lra)); field_simplify; lra|lra]).
  pose proof (cos_square d) as CD. pose proof (sin_cubic d ltac:(lra)) as [SD _].
  assert (DD : d * d <= 0.027229 * 0.027229) by (apply Rmult_le_compat; lra). assert (0.0272271 * (1 - 0.027229 * 0.027229 / 6) <= d * (1 - d * d / 6)) by (apply Rmult_le_compat; lra).
  assert (1.4142135 * 0.7320508 <= sqrt 2 * (sqrt 3 - 1)) by (apply Rmult_le_compat; lra). assert (1.4142135 * 2.7320508 <= sqrt 2 * (sqrt 3 + 1)) by (apply Rmult_le_compat; lra).
  assert (1.4142135 * 0.7320508 * (1 - 0.027229 * 0.027229 / 2) <= sqrt 2 * (sqrt 3 - 1) * cos d) by (apply Rmult_le_compat; lra).
  assert (1.4142135 * 2.7320508 * (0.0272271 * (1 - 0.027229 * 0.027229 / 6)) <= sqrt 2 * (sqrt 3 + 1) * sin d) by (apply Rmult_le_compat; lra). lra.
Qed.

(** Theorem 7: for any TCP tiling of space, and in the words of Statement.v. *)
Theorem theorem_7_space index (is_tile : index -> Prop) tile : space_tiling is_tile tile -> @space_tcp index is_tile tile ->
  exists c x, is_tile c /\ In x (dihedrals (tile c)) /\ 73.44 * PI / 180 < x.
Proof.
  intros H TCP'. destruct (above_bound_tcp T lambda (1 / 100000) T_range ltac:(unfold lambda; lra) ltac:(lra) pays7 above_60_7 H TCP') as [c [x [A [B D]]]].
  exists c, x. pose proof degrees. split; [exact A|]. split; [exact B|lra].
Qed.
Theorem theorem_7 l1 l2 l3 (Omega : point -> Prop) N P : (forall X, Omega X) -> face_to_face_tiling l1 l2 l3 3 Omega N P -> tcp l1 l2 l3 3 N P ->
  exists c x, is_tile 3 N c /\ In x (dihedrals (tile l1 l2 l3 P c)) /\ 73.44 * PI / 180 < x.
Proof.
  intros O H [T1 T2]. apply (theorem_7_space _ _ _ (periodic_space l1 l2 l3 Omega N P O H)).
  assert (E : forall u v c, has_vertices l1 l2 l3 3 N P (u :: v :: nil) c <-> has_edge (is_tile 3 N) (tile l1 l2 l3 P) u v c).
  { intros u v c. unfold has_vertices, has_edge. simpl. split; intros [Tc V]; (split; [exact Tc|]); [auto|]. intros w [<-|[<-|[]]]; tauto. }
  assert (EV : forall u v m, valence l1 l2 l3 3 N P u v m <-> edge_valence (is_tile 3 N) (tile l1 l2 l3 P) u v m).
  { intros u v m. split; intros [L [A [B I]]]; exists L; (split; [exact A|]); (split; [exact B|]); intros c; rewrite I; [|symmetry]; apply E. }
  split.
  - intros c u v Ed Ne. rewrite <- !EV. apply (T1 c u v); [apply E, Ed|exact Ne].
  - intros c u v w Tc Iu Iv Iw N1 N2 N3. rewrite <- !EV. apply (T2 c u v w); auto. split; [exact Tc|]. simpl. intros x [<-|[<-|[<-|[]]]]; assumption.
Qed.
