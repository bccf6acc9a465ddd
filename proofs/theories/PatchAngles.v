(** * Systems of patches: the largest dihedral angle

    With A, B and C of Angles.v, and C not negative, an angle is at most arccos sqrt (1/m) if
    A B <= m C^2, and equal to it if A B = m C^2. *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Statement Tetrahedra Bounds Angles PatchStatement PatchChecker PatchGeometry PatchSoundness PatchHeights.
Import ListNotations.
Open Scope R_scope.

(** An edge ab, and the other two corners. *)
Definition six (t : corners) : list corners := let '(a, b, c, d) := t in
  [(a, b, c, d); (a, c, b, d); (a, d, b, c); (b, c, a, d); (b, d, a, c); (c, d, a, b)].
Definition spot_form (e u w : spot) : zz := zsub (zmul (spot_dot u w) (spot_dot e e)) (zmul (spot_dot u e) (spot_dot w e)).
Definition defect (m : Z) (t : corners) : zz := let '(a, b, c, d) := t in
  let e := spot_sub b a in let u := spot_sub c a in let w := spot_sub d a in
  zsub (zmul (zint m) (zmul (spot_form e u w) (spot_form e u w))) (zmul (spot_form e u u) (spot_form e w w)).
Definition cosine (t : corners) : zz := let '(a, b, c, d) := t in spot_form (spot_sub b a) (spot_sub c a) (spot_sub d a).
Definition at_most (m : Z) (t : corners) : bool := forallb (fun e => znonneg (cosine e) && znonneg (defect m e)) (six t).
Definition attains (m : Z) (t : corners) : bool := existsb (fun e => znonneg (cosine e) && zeq (defect m e) (zint 0)) (six t).

Section Put.
Variables (c H : R) (o d : R * R) (m : Z).
Hypothesis c_pos : 0 < c.
Hypothesis unit : fst d * fst d + snd d * snd d = 1.
Hypothesis m_pos : (0 < m)%Z.
Notation put x := (put c H o d x).
Definition angle_of (e : corners) : R := let '(p, q, r, s) := e in dihedral (put p) (put q) (put r) (put s).
Lemma angles_six t : dihedrals (put_tet c H o d t) = map angle_of (six t).
Proof. destruct t as [[[? ?] ?] ?]. reflexivity. Qed.
Lemma six_orient t p q r s : In (p, q, r, s) (six t) -> good_corners t = true -> orient (put p) (put q) (put r) (put s) <> 0.
Proof.
  intros I G. pose proof (put_vol c H o d c_pos unit t G) as V. destruct t as [[[x y] z] w].
  change (0 < orient (put x) (put y) (put z) (put w)) in V.
  assert (K : orient (put p) (put q) (put r) (put s) = orient (put x) (put y) (put z) (put w) \/ orient (put p) (put q) (put r) (put s) = - orient (put x) (put y) (put z) (put w)); [|lra].
  cbn [six In] in I. destruct I as [I|[I|[I|[I|[I|[I|[]]]]]]]; injection I as <- <- <- <-; unf; [left|right|left|left|right|left]; ring.
Qed.
Lemma put_form p q r s : acpoly dot (sub (put q) (put p)) (sub (put r) (put p)) (sub (put s) (put p)) =
  c * c * (c * c) * surd (spot_form (spot_sub q p) (spot_sub r p) (spot_sub s p)).
Proof.
  unfold acpoly, spot_form. rewrite !put_dot by auto. surds. rewrite !surd_dot, !val_sub. ring.
Qed.
Lemma inverse_ok : sign_ok 1 (/ IZR m).
Proof.
  assert (1 <= IZR m) by (apply IZR_le; lia). split; [apply Rinv_0_lt_compat; lra|]. rewrite <- Rinv_1. apply Rinv_le_contravar; lra.
Qed.
Lemma put_compares p q r s o' : In o' [TLe; TGe] -> orient (put p) (put q) (put r) (put s) <> 0 -> 0 <= surd (cosine (p, q, r, s)) ->
  (match o' with TLe => 0 <= surd (defect m (p, q, r, s)) | _ => surd (defect m (p, q, r, s)) <= 0 end) ->
  compares o' (dihedral (put p) (put q) (put r) (put s)) (acos (sqrt (/ IZR m))).
Proof.
  intros I O C D. replace (acos (sqrt (/ IZR m))) with (acos (1 * sqrt (/ IZR m))) by (f_equal; ring).
  apply (bound_rule _ _ _ _ O o' 1 _ inverse_ok). rewrite !put_form.
  assert (M : 0 < IZR m) by (apply IZR_lt; auto). assert (E : / IZR m * IZR m = 1) by (field; lra).
  cbn [cosine] in C. unfold defect in D. rewrite surd_sub, !surd_mul, surd_int in D.
  set (x := surd (spot_form _ _ (spot_sub s p))) in *. set (y := surd (spot_form _ (spot_sub r p) (spot_sub r p))) in *. set (z := surd (spot_form _ (spot_sub s p) (spot_sub s p))) in *.
  set (k := c * c * (c * c)). assert (K : 0 < k) by (unfold k; repeat apply Rmult_lt_0_compat; auto).
  assert (F : / IZR m * (k * y * (k * z)) - k * x * (k * x) = - (k * k * / IZR m * (IZR m * (x * x) - y * z))) by (field; lra).
  assert (P : 0 <= k * k * / IZR m) by (apply Rlt_le; repeat apply Rmult_lt_0_compat; auto; apply Rinv_0_lt_compat; auto).
  cbn in I. destruct I as [<-|[<-|[]]]; cbn [compares_root below_root Z.opp].
  - split; [apply Rmult_le_pos; lra|]. assert (0 <= k * k * / IZR m * (IZR m * (x * x) - y * z)) by (apply Rmult_le_pos; auto). lra.
  - right. assert (0 <= k * k * / IZR m * - (IZR m * (x * x) - y * z)) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma put_at_most t q : good_corners t = true -> at_most m t = true -> largest (dihedrals (put_tet c H o d t)) q -> q <= acos (sqrt (/ IZR m)).
Proof.
  intros G A [I _]. rewrite angles_six in I. apply in_map_iff in I as [[[[p x] r] s] [<- I]]. unfold at_most in A. rewrite forallb_forall in A.
  specialize (A _ I). apply andb_true_iff in A as [A B]. apply znonneg_ok in A, B.
  apply (put_compares p x r s TLe); auto; [cbn; auto|]. eapply six_orient; eauto.
Qed.
Lemma put_attains t q : good_corners t = true -> attains m t = true -> largest (dihedrals (put_tet c H o d t)) q -> acos (sqrt (/ IZR m)) <= q.
Proof.
  intros G A [_ U]. unfold attains in A. apply existsb_exists in A as [[[[p x] r] s] [I A]]. apply andb_true_iff in A as [A B].
  apply znonneg_ok in A. apply zeq_ok in B. apply Rle_trans with (angle_of (p, x, r, s)).
  - apply (put_compares p x r s TGe); auto; [cbn; auto|eapply six_orient; eauto|]. rewrite B, surd_int. lra.
  - apply U. rewrite angles_six. apply in_map, I.
Qed.
End Put.

Section System.
Variables (system : list patch) (h : hints) (m : Z).
(** A tetrahedron of the piece that reaches the bound, for some of the shapes. *)
Variable peak : nat -> option nat.
Definition check_angles : bool := forallb (fun a => let p := patch_at system a in
  forallb (at_most m) (pieces p) &&
  match peak a with Some k => (k <? length (pieces p))%nat && attains m (corners_at p k) | None => true end &&
  forallb (fun s => forallb (fun b => let q := patch_at system b in forallb (fun s' => forallb (fun e =>
    at_most m (join p s q s' e)) (seq 0 (rim_count p s))) (seq 0 (side_count q))) (seq 0 (length system))) (seq 0 (side_count p)))
  (seq 0 (length system)).
Hypothesis checked : check_system system h = true.
Hypothesis m_pos : (0 < m)%Z.
Hypothesis bounded_angles : check_angles = true.
Variables (tiles : nat -> tile) (rise : nat -> R).
Hypothesis tiling : mosaic system tiles.
Hypothesis agree : walls_agree system tiles rise.
Notation across_side := (across_side system tiles tiling).
Notation chosen := (across_chosen system tiles tiling).
Notation piece := (piece system tiles rise across_side).
Notation valid := (valid system tiles across_side).
Notation kind i := (shape (tiles i)).
Notation patch_of i := (patch_of system tiles i).

Lemma angle_checks a : (a < length system)%nat -> let p := patch_at system a in
  (forall t, In t (pieces p) -> at_most m t = true) /\ (forall k, peak a = Some k -> (k < length (pieces p))%nat /\ attains m (corners_at p k) = true) /\
  forall s b s' e, (s < side_count p)%nat -> (b < length system)%nat -> (s' < side_count (patch_at system b))%nat -> (e < rim_count p s)%nat ->
    at_most m (join p s (patch_at system b) s' e) = true.
Proof.
  intros Ha p. pose proof bounded_angles as C. unfold check_angles in C. rewrite forallb_forall in C. specialize (C a ltac:(apply in_seq; lia)).
  cbv zeta in C. rewrite !andb_true_iff, !forallb_forall in C. destruct C as [[C1 C2] C4].
  split; auto. split.
  { intros k E. rewrite E in C2. apply andb_true_iff in C2 as [C2 C3]. apply Nat.ltb_lt in C2. split; auto. }
  intros s b s' e Hs Hb Hs' He.
  specialize (C4 s ltac:(apply in_seq; split; [lia|exact Hs])). rewrite forallb_forall in C4.
  specialize (C4 b ltac:(apply in_seq; split; [lia|exact Hb])). cbv zeta in C4. rewrite forallb_forall in C4.
  specialize (C4 s' ltac:(apply in_seq; split; [lia|exact Hs'])). rewrite forallb_forall in C4. apply C4, in_seq. split; [lia|exact He].
Qed.
Lemma some_largest t : exists q, largest (dihedrals t) q.
Proof. apply largest_exists. Qed.
Lemma cell_at_most c q : valid c -> largest (dihedrals (piece c)) q -> q <= acos (sqrt (/ IZR m)).
Proof.
  intros V L. pose proof V as V'. destruct c as [[i [k|s e]] n]; cbn [PatchSoundness.valid PatchSoundness.piece] in *.
  - destruct (angle_checks (kind i) (kind_lt system tiles tiling i)) as [A _].
    apply (put_at_most (/ 24) (rise i + IZR n) (corner (tiles i)) (along (tiles i)) m ltac:(lra) (along_unit system tiles tiling i) m_pos (corners_at (patch_of i) k)); auto.
    + apply (piece_corners system h checked tiles tiling); auto.
    + apply A, nth_In, V.
  - destruct V as [Hs [He _]]. destruct (across_side i s) as [j s'] eqn:E.
    destruct (across_spec system h checked tiles rise tiling across_side chosen i s j s' Hs E) as [Hs' _].
    destruct (angle_checks (kind i) (kind_lt system tiles tiling i)) as [_ [_ A]].
    apply (put_at_most (/ 576) (wall_height system tiles rise i s + IZR n) (corner_of system tiles i s) (direction system tiles i s) m ltac:(lra)
      (direction_unit system h checked tiles tiling i s Hs) m_pos (join (patch_of i) s (patch_of j) s' e)); auto.
    + apply (rims system h checked tiles rise tiling across_side chosen i s j s' e Hs E He).
    + apply A; auto. apply (kind_lt system tiles tiling).
Qed.
Theorem angle_at_most : largest_angle_of_cells (is_cell system tiles rise) AtMost (acos (sqrt (/ IZR m))).
Proof.
  pose proof (is_cell_iff system h checked tiles rise tiling across_side chosen agree) as IFF.
  intros t Ht. destruct (some_largest t) as [q Q]. exists q. split; auto. apply IFF in Ht as [c [V ->]]. eapply cell_at_most; eauto.
Qed.
(** The bound is attained if the mosaic has a tile of a shape with such a tetrahedron. *)
Theorem largest_angle i k : peak (kind i) = Some k -> largest_angle_of_cells (is_cell system tiles rise) Maximum (acos (sqrt (/ IZR m))).
Proof.
  intros E. split; [exact angle_at_most|]. destruct (angle_checks (kind i) (kind_lt system tiles tiling i)) as [_ [K _]]. destruct (K k E) as [P A].
  set (c := (i, Piece k, 0%Z) : cell). assert (V : valid c) by exact P.
  exists (piece c). split; [apply (is_cell_iff system h checked tiles rise tiling across_side chosen agree); eauto|].
  destruct (some_largest (piece c)) as [q Q].
  replace (acos (sqrt (/ IZR m))) with q; auto. apply Rle_antisym; [eapply cell_at_most; eauto|].
  apply (put_attains (/ 24) (rise i + IZR 0) (corner (tiles i)) (along (tiles i)) m ltac:(lra) (along_unit system tiles tiling i) m_pos (corners_at (patch_of i) k)); auto.
  apply (piece_corners system h checked tiles tiling); auto.
Qed.
End System.
