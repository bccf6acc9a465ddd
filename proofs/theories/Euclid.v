(* From lattice coordinates to Euclidean space; dihedral angles. *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree.
Import ListNotations.
Open Scope R_scope.

Lemma hull_closed t x : 0 < vol t -> (hull t x <-> closed t x).
Proof.
  intros V. split.
  - intros [a [b [c [d [A [B [C [Dd [S E]]]]]]]]].
    destruct (L_comb4 t a b c d S) as [K0 [K1 [K2 K3]]]. rewrite <- E in *.
    intros i Hi. simpl in Hi. destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; nra.
  - intros C. destruct (bary t x V) as [E S].
    assert (P : forall j, In j I4 -> 0 <= coord t j x / vol t).
    { intros j Hj. specialize (C j Hj). apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat; auto. }
    exists (coord t 0 x / vol t), (coord t 1 x / vol t), (coord t 2 x / vol t), (coord t 3 x / vol t).
    repeat split; try (apply P; simpl; tauto); auto.
Qed.
Lemma open_hull_inter t x : 0 < vol t -> (open_hull t x <-> inside t x).
Proof.
  intros V. split.
  - intros [a [b [c [d [A [B [C [Dd [S E]]]]]]]]].
    destruct (L_comb4 t a b c d S) as [K0 [K1 [K2 K3]]]. rewrite <- E in *.
    intros i Hi. simpl in Hi. destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; nra.
  - intros C. destruct (bary t x V) as [E S].
    assert (P : forall j, In j I4 -> 0 < coord t j x / vol t).
    { intros j Hj. specialize (C j Hj). apply Rdiv_lt_0_compat; auto. }
    exists (coord t 0 x / vol t), (coord t 1 x / vol t), (coord t 2 x / vol t), (coord t 3 x / vol t).
    repeat split; try (apply P; simpl; tauto); auto.
Qed.

(* the reversed tetrahedron, to treat both orientations *)
Definition trev t := Tetrahedron (vb t) (va t) (vc t) (vd t).
Lemma vol_trev t : vol (trev t) = - vol t.
Proof. unfold vol, trev; cbn [va vb vc vd]. unf. ring. Qed.
Lemma hull_trev t x : hull t x <-> hull (trev t) x.
Proof.
  split; intros [a [b [c [d [A [B [C [Dd [S H]]]]]]]]]; exists b, a, c, d; repeat split; auto; try lra;
  rewrite H; unfold combination, trev; cbn [va vb vc vd]; apply point_eq; unf; ring.
Qed.
Lemma open_hull_trev t x : open_hull t x <-> open_hull (trev t) x.
Proof.
  split; intros [a [b [c [d [A [B [C [Dd [S H]]]]]]]]]; exists b, a, c, d; repeat split; auto; try lra;
  rewrite H; unfold combination, trev; cbn [va vb vc vd]; apply point_eq; unf; ring.
Qed.
Lemma L_vx t i : In i I4 -> coord t i (vx t i) = vol t.
Proof.
  intros Hi. simpl in Hi. destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; unfold coord, side, vol; cbn [facet vx t1 t2 t3]; unf; ring.
Qed.
Lemma open_hull_interior_pos t x : 0 < vol t -> (open_hull t x <-> interior (hull t) x).
Proof.
  intros V. rewrite open_hull_inter by auto. split.
  - intros H. destruct (inter_opn t x H) as [e [He K]]. exists e. split; auto.
    intros y Hy. apply hull_closed; auto. apply inter_closed, K. exact Hy.
  - intros [e [He K]] i Hi.
    assert (C : closed t x). { apply hull_closed; auto. apply K. apply (near_refl e x He). }
    destruct (Req_dec (coord t i x) 0) as [Z|Z]; [|specialize (C i Hi); lra]. exfalso.
    (* move away from vertex i *)
    destruct (lerp_near e x (sub (scale 2 x) (vx t i)) He) as [s [Hs Ns]].
    specialize (K _ Ns). apply hull_closed in K; auto. specialize (K i Hi).
    assert (X : coord t i (lerp x (sub (scale 2 x) (vx t i)) s) = coord t i x + s * (coord t i x - coord t i (vx t i))).
    { clear. unfold coord, side. destruct (facet t i) as [a b c]; cbn [t1 t2 t3]. destruct (vx t i), a, b, c, x. unf. ring. }
    rewrite X, Z, L_vx in K by auto. nra.
Qed.
Theorem open_hull_interior t x : vol t <> 0 -> (open_hull t x <-> interior (hull t) x).
Proof.
  intros V. destruct (Rlt_dec 0 (vol t)); [apply open_hull_interior_pos; auto|].
  rewrite open_hull_trev, open_hull_interior_pos by (rewrite vol_trev; lra).
  unfold interior. split; intros [e [He K]]; exists e; split; auto; intros y Hy; apply hull_trev, K, Hy.
Qed.

Section Emb.
Variables b1 b2 b3 : point.
Let dl := det b1 b2 b3.
Hypothesis dl0 : dl <> 0.

Definition E (x : point) : point := at_coordinates b1 b2 b3 x.
Definition Einv (X : point) : point := Point (det X b2 b3 / dl) (det b1 X b3 / dl) (det b1 b2 X / dl).

Lemma E_Einv X : E (Einv X) = X.
Proof. unfold E, at_coordinates, Einv, dl in *. apply point_eq; unf; field; auto. Qed.
Lemma Einv_E x : Einv (E x) = x.
Proof. unfold E, at_coordinates, Einv, dl in *. apply point_eq; unf; field; auto. Qed.
Lemma E_inj x y : E x = E y -> x = y.
Proof. intros H. rewrite <- (Einv_E x), <- (Einv_E y), H. auto. Qed.

Definition Et t := Tetrahedron (E (va t)) (E (vb t)) (E (vc t)) (E (vd t)).
Lemma E_comb4 t a b c d : combination (Et t) a b c d = E (combination t a b c d).
Proof. unfold combination, Et, E, at_coordinates; cbn [va vb vc vd]. apply point_eq; unf; ring. Qed.
Lemma E_add x y : E (add x y) = add (E x) (E y).
Proof. unfold E, at_coordinates. apply point_eq; unf; ring. Qed.
Lemma E_sub x y : E (sub x y) = sub (E x) (E y).
Proof. unfold E, at_coordinates. apply point_eq; unf; ring. Qed.
Lemma Et_ttr u t : Et (translate u t) = translate (E u) (Et t).
Proof. unfold Et, translate; cbn. rewrite !E_add. auto. Qed.
Lemma vol_Et t : vol (Et t) = vol t * dl.
Proof. unfold vol, Et, E, at_coordinates, dl; cbn [va vb vc vd]. unf. ring. Qed.

Lemma hull_Et t x : hull (Et t) (E x) <-> hull t x.
Proof.
  unfold hull. split; intros [a [b [c [d [A [B [C [Dd [S H]]]]]]]]]; exists a, b, c, d; repeat split; auto.
  - rewrite E_comb4 in H. apply E_inj in H. auto.
  - rewrite E_comb4, H. auto.
Qed.
Lemma open_hull_Et t x : open_hull (Et t) (E x) <-> open_hull t x.
Proof.
  unfold open_hull. split; intros [a [b [c [d [A [B [C [Dd [S H]]]]]]]]]; exists a, b, c, d; repeat split; auto.
  - rewrite E_comb4 in H. apply E_inj in H. auto.
  - rewrite E_comb4, H. auto.
Qed.
Lemma common_Et t t' x : common_hull t t' x -> common_hull (Et t) (Et t') (E x).
Proof.
  intros [a [b [c [d [A [B [C [Dd [S [H [Ha [Hb [Hc Hd]]]]]]]]]]]]]. exists a, b, c, d.
  repeat split; auto.
  - rewrite E_comb4, H; auto.
  - intros K. apply (in_map E) in Ha; auto.
  - intros K. apply (in_map E) in Hb; auto.
  - intros K. apply (in_map E) in Hc; auto.
  - intros K. apply (in_map E) in Hd; auto.
Qed.
End Emb.

(* Gram matrices *)
Definition gdot G u v :=
  g11 G * (px u * px v) + g22 G * (py u * py v) + g33 G * (pz u * pz v)
  + g12 G * (px u * py v + py u * px v) + g13 G * (px u * pz v + pz u * px v) + g23 G * (py u * pz v + pz u * py v).
Definition gdet G :=
  g11 G * (g22 G * g33 G - g23 G * g23 G) - g12 G * (g12 G * g33 G - g23 G * g13 G) + g13 G * (g12 G * g23 G - g22 G * g13 G).
Definition gpos G := 0 < g11 G /\ 0 < g11 G * g22 G - g12 G * g12 G /\ 0 < gdet G.

Lemma gram_dot G l1 l2 l3 u v : has_gram G l1 l2 l3 -> dot (E l1 l2 l3 u) (E l1 l2 l3 v) = gdot G u v.
Proof.
  intros [H1 [H2 [H3 [H4 [H5 H6]]]]]. unfold gdot. rewrite <- H1, <- H2, <- H3, <- H4, <- H5, <- H6.
  unfold dot, E, at_coordinates. unf. ring.
Qed.
Lemma gram_det G l1 l2 l3 : has_gram G l1 l2 l3 -> det l1 l2 l3 * det l1 l2 l3 = gdet G.
Proof.
  intros [H1 [H2 [H3 [H4 [H5 H6]]]]]. unfold gdet. rewrite <- H1, <- H2, <- H3, <- H4, <- H5, <- H6.
  unfold dot. unf. ring.
Qed.
Lemma gram_exists G : gpos G -> exists l1 l2 l3, has_gram G l1 l2 l3.
Proof.
  intros [A [B C]].
  set (a := sqrt (g11 G)). assert (Ea : a * a = g11 G) by (apply sqrt_sqrt; lra).
  assert (Pa : 0 < a) by (apply sqrt_lt_R0; auto).
  set (b := g12 G / a). set (c := g13 G / a).
  set (m2 := g22 G - b * b).
  assert (Eb : a * b = g12 G) by (unfold b; field; lra).
  assert (Ec : a * c = g13 G) by (unfold c; field; lra).
  assert (M2 : g11 G * m2 = g11 G * g22 G - g12 G * g12 G).
  { unfold m2. rewrite <- Eb, <- Ea. ring. }
  assert (Pm2 : 0 < m2) by nra.
  set (d := sqrt m2). assert (Ed : d * d = m2) by (apply sqrt_sqrt; lra).
  assert (Pd : 0 < d) by (apply sqrt_lt_R0; auto).
  set (e := (g23 G - b * c) / d).
  assert (Ee : d * e = g23 G - b * c) by (unfold e; field; lra).
  set (m3 := g33 G - c * c - e * e).
  assert (M3 : g11 G * m2 * m3 = gdet G).
  { unfold m3.
    assert (X : m2 * (e * e) = (g23 G - b * c) * (g23 G - b * c)).
    { rewrite <- Ed, <- Ee. ring. }
    replace (g11 G * m2 * (g33 G - c * c - e * e)) with (g11 G * m2 * (g33 G - c * c) - g11 G * (m2 * (e * e))) by ring.
    rewrite X. unfold m2, gdet. rewrite <- Ea, <- Eb, <- Ec. ring. }
  assert (P12 : 0 < g11 G * m2) by nra.
  assert (Pm3 : 0 < m3) by nra.
  set (f := sqrt m3). assert (Ef : f * f = m3) by (apply sqrt_sqrt; lra).
  exists (Point a 0 0), (Point b d 0), (Point c e f).
  unfold has_gram, dot; cbn [px py pz]. unfold m2, m3 in *. repeat split; lra.
Qed.


Lemma carT_vert t x v : carT t x v -> In v (verts t).
Proof. intros [a [b [c [d [_ [_ [_ [_ [_ [_ H]]]]]]]]]]. simpl. intuition. Qed.
