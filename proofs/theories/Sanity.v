(** * Sanity: the definitions of Statement.v say what they should

    Nothing depends on this file.  It relates the definitions to plain topology and
    to the usual notions, and gives examples of what fulfils them and of what does not.  That there are
    tilings is what the theorems of exported certificates say (docs/trust.md). *)
Require Import Reals Lra ZArith List.
From Acutile Require Import Statement PlaneStatement Tetrahedra Topology Degree Angles Euclid.
Open Scope R_scope.

(** [open_hull] is the topological interior of the closed tetrahedron. *)
Theorem open_hull_is_interior t x : vol t <> 0 -> (open_hull t x <-> interior (hull t) x).
Proof. apply open_hull_interior. Qed.

Section Tiling.
Variables (l1 l2 l3 : point) (r : nat) (Omega : point -> Prop) (N : nat) (P : nat -> tetrahedron).
Hypothesis H : face_to_face_tiling l1 l2 l3 r Omega N P.

(** Distinct tiles have disjoint topological interiors. *)
Theorem interiors_disjoint X c c' : is_tile r N c -> is_tile r N c' -> c <> c' ->
  interior (hull (tile l1 l2 l3 P c)) X -> interior (hull (tile l1 l2 l3 P c')) X -> False.
Proof.
  intros Hc Hc' Ne I I'. apply Ne.
  apply (open_hull_is_interior _ _ (tiling_nondegenerate _ _ _ _ _ _ _ H c Hc)) in I.
  apply (tiling_disjoint _ _ _ _ _ _ _ H X c c'); auto.
  destruct I' as [e [He K]]. apply K. apply near_refl; auto.
Qed.
(** The intersection of two tiles is exactly the hull of their common vertices. *)
Theorem intersection X c c' : is_tile r N c -> is_tile r N c' ->
  (hull (tile l1 l2 l3 P c) X /\ hull (tile l1 l2 l3 P c') X) <-> common_hull (tile l1 l2 l3 P c) (tile l1 l2 l3 P c') X.
Proof.
  intros Hc Hc'. split.
  - intros [A B]. apply (tiling_face_to_face _ _ _ _ _ _ _ H); auto.
  - set (t := tile l1 l2 l3 P c). set (t' := tile l1 l2 l3 P c').
    clearbody t t'. clear c c' Hc Hc'.
    intros [a [b [c [d [A [B [C [orient [S [E [Ha [Hb [Hc Hd]]]]]]]]]]]]].
    split. { exists a, b, c, d. repeat split; auto. }
    (* regroup the weights on the vertices of t' *)
    assert (V : forall v, In v (verts t') -> exists w0 w1 w2 w3, 0 <= w0 /\ 0 <= w1 /\ 0 <= w2 /\ 0 <= w3 /\ w0 + w1 + w2 + w3 = 1 /\ v = combination t' w0 w1 w2 w3).
    { intros v Hv. simpl in Hv. destruct Hv as [<-|[<-|[<-|[<-|[]]]]];
      [exists 1, 0, 0, 0 | exists 0, 1, 0, 0 | exists 0, 0, 1, 0 | exists 0, 0, 0, 1];
      repeat split; try lra; unfold combination; apply point_eq; unf; ring. }
    assert (V' : forall q v, 0 <= q -> (0 < q -> In v (verts t')) -> exists w0 w1 w2 w3, 0 <= w0 /\ 0 <= w1 /\ 0 <= w2 /\ 0 <= w3 /\ w0 + w1 + w2 + w3 = q /\ scale q v = combination t' w0 w1 w2 w3).
    { intros q v Hr Hv. destruct (Req_dec q 0) as [->|Nr].
      - exists 0, 0, 0, 0. repeat split; try lra. unfold combination. apply point_eq; unf; ring.
      - destruct (V v) as [w0 [w1 [w2 [w3 [X0 [X1 [X2 [X3 [XS XE]]]]]]]]]; [apply Hv; lra|].
        exists (q * w0), (q * w1), (q * w2), (q * w3).
        repeat split; try (apply Rmult_le_pos; auto).
        + replace (q * w0 + q * w1 + q * w2 + q * w3) with (q * (w0 + w1 + w2 + w3)) by ring. rewrite XS. ring.
        + rewrite XE. unfold combination. apply point_eq; unf; ring. }
    destruct (V' a _ A Ha) as [a0 [a1 [a2 [a3 [? [? [? [? [Sa Ea]]]]]]]]].
    destruct (V' b _ B Hb) as [b0 [b1 [b2 [b3 [? [? [? [? [Sb Eb]]]]]]]]].
    destruct (V' c _ C Hc) as [c0 [c1 [c2 [c3 [? [? [? [? [Sc Ec]]]]]]]]].
    destruct (V' d _ orient Hd) as [d0 [d1 [d2 [d3 [? [? [? [? [Sd Ed]]]]]]]]].
    exists (a0+b0+c0+d0), (a1+b1+c1+d1), (a2+b2+c2+d2), (a3+b3+c3+d3).
    repeat split; try lra. rewrite E. unfold combination at 1. rewrite Ea, Eb, Ec, Ed.
    unfold combination. apply point_eq; unf; ring.
Qed.
End Tiling.

(** With a lattice of rank 3 the domain is the whole space. *)
Theorem domain_space l1 l2 l3 W X : det l1 l2 l3 <> 0 -> domain l1 l2 l3 3 W X.
Proof. intros D. exists (Einv l1 l2 l3 X). split; [symmetry; apply (E_Einv l1 l2 l3 D)|]. exact I. Qed.
(** With a lattice of rank 2 and W on two levels it is the slab between them. *)
Theorem domain_slab l1 l2 l3 lo hi X : det l1 l2 l3 <> 0 -> lo < hi ->
  domain l1 l2 l3 2 (Point 0 0 lo :: Point 0 0 hi :: nil) X <-> lo <= pz (Einv l1 l2 l3 X) <= hi.
Proof.
  intros D LH. split.
  - intros [x [-> [w [Hw E]]]]. rewrite (Einv_E l1 l2 l3 D), E. clear E x.
    induction Hw as [v [<-|[<-|[]]]|x y s _ IHx _ IHy S]; cbn; try lra. unf. nra.
  - intros B. exists (Einv l1 l2 l3 X). split; [symmetry; apply (E_Einv l1 l2 l3 D)|].
    set (z := pz (Einv l1 l2 l3 X)) in *.
    exists (add (scale (1 - (z - lo) / (hi - lo)) (Point 0 0 lo)) (scale ((z - lo) / (hi - lo)) (Point 0 0 hi))). split.
    + apply hull_segment; try (apply hull_vertex; simpl; auto).
      split; [apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]|].
      apply Rmult_le_reg_r with (hi - lo); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
    + unf. field. lra.
Qed.

(** With a lattice of rank 0 it is the hull itself, in the coordinates of the basis. *)
Theorem domain_solid l1 l2 l3 W X : domain l1 l2 l3 0 W X <-> exists x, convex_hull W x /\ X = at_coordinates l1 l2 l3 x.
Proof. split; [intros [x [E [w [H ->]]]] | intros [x [H E]]; exists x; split]; eauto. Qed.

(** Acute means a positive inner product; the angle is the usual one. *)
Theorem acute_iff u w : 0 < dot u u -> 0 < dot w w -> (angle u w < PI / 2 <-> 0 < dot u w).
Proof.
  intros Hu Hw. pose proof (angle_cos u w Hu Hw) as C.
  assert (NU : 0 < norm u) by (apply sqrt_lt_R0; auto).
  assert (NW : 0 < norm w) by (apply sqrt_lt_R0; auto).
  assert (NN : 0 < norm u * norm w) by (apply Rmult_lt_0_compat; auto).
  assert (B : 0 <= angle u w <= PI) by apply acos_bound. pose proof PI_RGT_0. split; intros A.
  - assert (0 < cos (angle u w)) by (apply cos_gt_0; lra). rewrite <- C. apply Rmult_lt_0_compat; auto.
  - apply Rnot_le_lt. intros K. assert (cos (angle u w) <= 0) by (apply cos_le_0; lra). nra.
Qed.

(** The corner of a cube has right dihedral angles: not acute. *)
Example right_angle_not_acute : ~ dihedral (Point 0 0 0) (Point 1 0 0) (Point 0 1 0) (Point 0 0 1) < PI / 2.
Proof.
  unfold dihedral, angle.
  replace (dot _ _) with 0 by (unfold perp, dot; unf; field).
  unfold Rdiv. rewrite Rmult_0_l, acos_0. lra.
Qed.

(** The regular tetrahedron is acute. *)
Example regular_acute : all_dihedral (fun x => x < PI / 2)
  (Tetrahedron (Point 1 1 1) (Point 1 (-1) (-1)) (Point (-1) 1 (-1)) (Point (-1) (-1) 1)).
Proof.
  unfold all_dihedral, dihedral; cbn [va vb vc vd].
  repeat split; apply acute_iff; unfold perp, dot, sub, scale; cbn [px py pz]; field_simplify; lra.
Qed.

(** ** The plane *)

(** With a lattice of rank 2 the domain is the whole plane. *)
Theorem domain_plane l1 l2 W X : det2 l1 l2 <> 0 -> domain2 l1 l2 2 W X.
Proof.
  intros D. exists (Point2 (det2 X l2 / det2 l1 l2) (det2 l1 X / det2 l1 l2)). split; [|exact I].
  unfold at_coordinates2, add2, scale2, det2 in *. destruct X as [x y]. cbn [x2 y2] in *. f_equal; field; exact D.
Qed.
(** The triangle 3, 4, 5 has a right angle: it is not acute. *)
Example right_angle_not_acute2 : ~ all_angles (fun x => x < PI / 2) (Triangle2 (Point2 0 0) (Point2 3 0) (Point2 0 4)).
Proof.
  intros [H _]. unfold angle2 in H; cbn [ta tb tc] in H.
  replace (dot2 _ _) with 0 in H at 1 by (unfold dot2, sub2; cbn [x2 y2]; ring).
  unfold Rdiv at 1 in H. rewrite Rmult_0_l, acos_0 in H. lra.
Qed.
