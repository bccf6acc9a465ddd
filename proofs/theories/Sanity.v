(** * Sanity: the definitions of Statement.v say what they should

    Nothing depends on this file.  It relates the definitions to plain topology and
    to the usual notions, and gives examples of what fulfils them and of what does not.  That there are
    tilings is what the theorems of exported certificates say (docs/trust.md). *)
Require Import Reals Lra ZArith List.
From Acutile Require Import Statement PlaneStatement Tetrahedra Topology Degree Bounds Angles Euclid Transfer.
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
Example regular_acute x :
  In x (dihedrals (Tetrahedron (Point 1 1 1) (Point 1 (-1) (-1)) (Point (-1) 1 (-1)) (Point (-1) (-1) 1))) -> x < PI / 2.
Proof.
  unfold dihedrals, dihedral; cbn [va vb vc vd].
  intros [<-|[<-|[<-|[<-|[<-|[<-|[]]]]]]]; apply acute_iff; unfold perp, dot, sub, scale; cbn [px py pz]; field_simplify; lra.
Qed.

(** ** Quantities and bounds *)

(** A tile has one largest number, one smallest, one squared radius-edge ratio. *)
Theorem largest_unique l p q : largest l p -> largest l q -> p = q.
Proof. intros [P P'] [Q Q']. specialize (P' q Q). specialize (Q' p P). lra. Qed.
Theorem smallest_unique l p q : smallest l p -> smallest l q -> p = q.
Proof. intros [P P'] [Q Q']. specialize (P' q Q). specialize (Q' p P). lra. Qed.
Theorem squared_ratio_unique t p q : vol t <> 0 -> squared_ratio t p -> squared_ratio t q -> p = q.
Proof.
  intros V [C [s [l [HC [Hl ->]]]]] [C' [s' [l' [HC' [Hl' ->]]]]]. rewrite (smallest_unique _ _ _ Hl Hl').
  (* C and C' have the same inner products with the three edges *)
  assert (K : forall v, In v (verts t) -> dot (sub v (va t)) (sub C C') = 0).
  { intros v Hv. pose proof (HC v Hv) as A. pose proof (HC (va t) ltac:(simpl; auto)) as B.
    pose proof (HC' v Hv) as A'. pose proof (HC' (va t) ltac:(simpl; auto)) as B'.
    unfold distance_squared, dot in *. unf. lra. }
  assert (E : C = C').
  { pose proof (K (vb t) ltac:(simpl; auto)) as K1. pose proof (K (vc t) ltac:(simpl; auto)) as K2. pose proof (K (vd t) ltac:(simpl; auto)) as K3.
    unfold vol in V. set (u := sub (vb t) (va t)) in *. set (v := sub (vc t) (va t)) in *. set (w := sub (vd t) (va t)) in *. set (n := sub C C') in *.
    assert (N : scale (det u v w) n = origin).
    { replace (scale (det u v w) n) with (add (scale (dot u n) (cross v w)) (add (scale (dot v n) (cross w u)) (scale (dot w n) (cross u v))))
        by (unfold cross, dot; apply point_eq; unf; ring).
      rewrite K1, K2, K3. unfold origin. apply point_eq; unf; ring. }
    clearbody u v w. pose proof (f_equal px N) as X. pose proof (f_equal py N) as Y. pose proof (f_equal pz N) as Z. clear N K K1 K2 K3.
    unfold scale, origin, n, sub in X, Y, Z; cbn [px py pz] in X, Y, Z. apply Rmult_integral in X, Y, Z.
    apply point_eq; lra. }
  subst C'. rewrite <- (HC (va t) ltac:(simpl; auto)), <- (HC' (va t) ltac:(simpl; auto)). reflexivity.
Qed.
(** "The largest at most B" bounds every number; "at least B" is reached by some number. *)
Theorem largest_at_most {T} (tiles : T -> Prop) (l : T -> list R) B : (forall c, l c <> nil) ->
  (bounded tiles (fun c => largest (l c)) AtMost B <-> forall c x, tiles c -> In x (l c) -> x <= B).
Proof.
  intros NE. split.
  - intros H c x Hc Hx. destruct (H c Hc) as [q [[_ U] L]]. specialize (U x Hx). lra.
  - intros H c Hc. destruct (l c) as [|x m] eqn:E; [destruct (NE c E)|]. destruct (largest_exists x m) as [q Hq]. exists q. split; auto.
    apply (H c); auto. rewrite E. apply Hq.
Qed.
Theorem largest_at_least {T} (tiles : T -> Prop) (l : T -> list R) B : (forall c, l c <> nil) ->
  (bounded tiles (fun c => largest (l c)) AtLeast B <-> forall c, tiles c -> exists x, In x (l c) /\ B <= x).
Proof.
  intros NE. split.
  - intros H c Hc. destruct (H c Hc) as [q [[I _] L]]. eauto.
  - intros H c Hc. destruct (H c Hc) as [x [Hx L]]. destruct (l c) as [|y m] eqn:E; [destruct Hx|].
    destruct (largest_exists y m) as [q Hq]. exists q. split; auto. pose proof (proj2 Hq x Hx). lra.
Qed.
(** "The maximum is B" says that B is the largest quantity of all tiles. *)
Theorem maximum_iff {T} (tiles : T -> Prop) (of : T -> R -> Prop) B : (forall c p q, of c p -> of c q -> p = q) ->
  (bounded tiles of Maximum B <-> (forall c, tiles c -> exists q, of c q) /\ (forall c q, tiles c -> of c q -> q <= B) /\ exists c, tiles c /\ of c B).
Proof.
  intros U. split.
  - intros [H R]. split; [|split; auto].
    + intros c Hc. destruct (H c Hc) as [q [Q _]]. eauto.
    + intros c q Hc Q. destruct (H c Hc) as [p [P L]]. rewrite (U c q p); auto.
  - intros [E [H R]]. split; auto. intros c Hc. destruct (E c Hc) as [q Q]. exists q. split; auto. apply (H c); auto.
Qed.
(** An angle is at most arccos y if its cosine is at least y. *)
Theorem at_most_arccos x y : 0 <= x <= PI -> -1 <= y <= 1 -> (x <= acos y <-> y <= cos x).
Proof.
  intros X Y. pose proof (cos_acos y Y) as E. pose proof (acos_bound y) as B. split; intros H.
  - rewrite <- E. apply cos_decr_1; lra.
  - rewrite <- E in H. apply cos_decr_0; lra.
Qed.
(** The largest dihedral angle of the regular tetrahedron is arccos(1/3): the sign is 1, the square is 1/9. *)
Example regular_largest :
  largest (dihedrals (Tetrahedron (Point 1 1 1) (Point 1 (-1) (-1)) (Point (-1) 1 (-1)) (Point (-1) (-1) 1))) (acos (1 * sqrt (1 / 9))).
Proof.
  assert (S : forall x, 0 <= x -> sqrt (x * x) = x) by apply sqrt_square.
  assert (A : forall u w m, dot u u = m -> dot w w = m -> 0 < m -> dot u w = m / 3 -> angle u w = acos (1 * sqrt (1 / 9))).
  { intros u w m U W M D. unfold angle, norm. rewrite U, W, D, sqrt_sqrt by lra. f_equal.
    replace (1 / 9) with (1 / 3 * (1 / 3)) by field. rewrite S by lra. field. lra. }
  unfold dihedrals, dihedral; cbn [va vb vc vd].
  assert (K : forall l x, l <> nil -> (forall y, In y l -> y = x) -> largest l x).
  { intros [|y l] x NE H; [congruence|]. split; [left; apply H; left; reflexivity|]. intros z Hz. rewrite (H z Hz). lra. }
  apply K; [discriminate|]. intros y [<-|[<-|[<-|[<-|[<-|[<-|[]]]]]]]; apply (A _ _ 6); unfold perp, dot, sub, scale; cbn [px py pz]; try field; lra.
Qed.

(** ** The plane *)

(** With a lattice of rank 2 the domain is the whole plane. *)
Theorem domain_plane l1 l2 W X : det2 l1 l2 <> 0 -> domain2 l1 l2 2 W X.
Proof.
  intros D. exists (Point2 (det2 X l2 / det2 l1 l2) (det2 l1 X / det2 l1 l2)). split; [|exact I].
  unfold at_coordinates2, add2, scale2, det2 in *. destruct X as [x y]. cbn [x2 y2] in *. f_equal; field; exact D.
Qed.
(** The triangle 3, 4, 5 has a right angle: it is not acute. *)
Example right_angle_not_acute2 : ~ forall x, In x (angles2 (Triangle2 (Point2 0 0) (Point2 3 0) (Point2 0 4))) -> x < PI / 2.
Proof.
  intros H. specialize (H _ (or_introl eq_refl)). unfold angle2 in H; cbn [ta tb tc] in H.
  replace (dot2 _ _) with 0 in H at 1 by (unfold dot2, sub2; cbn [x2 y2]; ring).
  unfold Rdiv at 1 in H. rewrite Rmult_0_l, acos_0 in H. lra.
Qed.
