(** * Soundness in the plane

    The tetrahedra over the triangles tile the domain times [0, 1], by Soundness.v. What
    they do in the bottom plane is the theorem about the triangles. *)
Require Import Reals Lra Psatz NArith Nnat ZArith List Lia Bool.
From Acutile Require Import Statement PlaneStatement Tetrahedra Topology Degree Domain Bounds Angles Euclid Transfer Checker Soundness PlaneChecker.
Import ListNotations.
Open Scope R_scope.

Ltac unf2 := unfold translate2, combination2, area in *; unfold det2, sub2, add2, scale2 in *; cbn [x2 y2 ta tb tc] in *.
Lemma point2_eq a b : x2 a = x2 b -> y2 a = y2 b -> a = b.
Proof. destruct a, b; simpl; intros; subst; auto. Qed.

(** ** The plane as the bottom plane of space *)
Definition up (h : R) (X : point2) : point := Point (x2 X) (y2 X) h.
Definition down (X : point) : point2 := Point2 (px X) (py X).
Lemma up_inj h k X Y : up h X = up k Y -> X = Y.
Proof. unfold up. intros H. injection H as H1 H2 _. apply point2_eq; auto. Qed.

Lemma dot_up u w : dot (up 0 u) (up 0 w) = dot2 u w.
Proof. unfold dot, dot2, up; cbn [px py pz]. ring. Qed.
Lemma sub_up h u w : sub (up h u) (up h w) = up 0 (sub2 u w).
Proof. unfold up. apply point_eq; unf; unf2; ring. Qed.
(** The angle of a triangle is the dihedral angle along the vertical edge over its corner. *)
Lemma dihedral_up a b c : dihedral (up 0 a) (up 1 a) (up 0 b) (up 0 c) = angle2 (sub2 b a) (sub2 c a).
Proof.
  unfold dihedral. rewrite !sub_up.
  assert (P : forall u, perp (sub (up 1 a) (up 0 a)) (up 0 u) = up 0 u).
  { intros u. unfold perp, up. apply point_eq; unfold dot; unf; field; lra. }
  rewrite !P. unfold angle, angle2, norm, norm2. rewrite !dot_up. reflexivity.
Qed.
Lemma distance_up h u w : distance_squared (up h u) (up h w) = distance_squared2 u w.
Proof. unfold distance_squared, distance_squared2. rewrite sub_up, dot_up. reflexivity. Qed.
Lemma distance_down h u C : distance_squared (up h u) C = distance_squared2 u (down C) + (h - pz C) * (h - pz C).
Proof. unfold distance_squared, distance_squared2, dot, dot2, up, down. unf. unf2. ring. Qed.
Lemma distance_sym2 u v : distance_squared2 u v = distance_squared2 v u.
Proof. unfold distance_squared2, dot2. unf2. ring. Qed.

(** ** Triangles *)
Lemma weights_exist T X : area T <> 0 -> exists a b c, a + b + c = 1 /\ X = combination2 T a b c.
Proof.
  intros V. exists (1 - det2 (sub2 X (ta T)) (sub2 (tc T) (ta T)) / area T - det2 (sub2 (tb T) (ta T)) (sub2 X (ta T)) / area T),
    (det2 (sub2 X (ta T)) (sub2 (tc T) (ta T)) / area T), (det2 (sub2 (tb T) (ta T)) (sub2 X (ta T)) / area T).
  split; [ring|]. apply point2_eq; unf2; field; auto.
Qed.
Lemma weights_unique T a b c a' b' c' : area T <> 0 -> a + b + c = 1 -> a' + b' + c' = 1 ->
  combination2 T a b c = combination2 T a' b' c' -> a = a' /\ b = b' /\ c = c'.
Proof.
  intros V S S' E. pose proof (f_equal x2 E) as X. pose proof (f_equal y2 E) as Y. clear E. unf2.
  assert (B : (b - b') * area T = 0 /\ (c - c') * area T = 0).
  { unf2. replace a with (1 - b - c) in * by lra. replace a' with (1 - b' - c') in * by lra. split.
    - replace ((b - b') * _) with
        (((1 - b - c) * x2 (ta T) + b * x2 (tb T) + c * x2 (tc T) - ((1 - b' - c') * x2 (ta T) + b' * x2 (tb T) + c' * x2 (tc T))) * (y2 (tc T) - y2 (ta T))
        - ((1 - b - c) * y2 (ta T) + b * y2 (tb T) + c * y2 (tc T) - ((1 - b' - c') * y2 (ta T) + b' * y2 (tb T) + c' * y2 (tc T))) * (x2 (tc T) - x2 (ta T))) by ring.
      rewrite X, Y. ring.
    - replace ((c - c') * _) with
        (((1 - b - c) * y2 (ta T) + b * y2 (tb T) + c * y2 (tc T) - ((1 - b' - c') * y2 (ta T) + b' * y2 (tb T) + c' * y2 (tc T))) * (x2 (tb T) - x2 (ta T))
        - ((1 - b - c) * x2 (ta T) + b * x2 (tb T) + c * x2 (tc T) - ((1 - b' - c') * x2 (ta T) + b' * x2 (tb T) + c' * x2 (tc T))) * (y2 (tb T) - y2 (ta T))) by ring.
      rewrite X, Y. ring. }
  destruct B as [B C]. apply Rmult_integral in B, C. destruct B as [B|B]; [|contradiction]. destruct C as [C|C]; [|contradiction]. lra.
Qed.
Lemma corner_weights T v : In v (corners T) -> exists a b c, 0 <= a /\ 0 <= b /\ 0 <= c /\ a + b + c = 1 /\ v = combination2 T a b c /\
  ((a = 1 /\ v = ta T) \/ (b = 1 /\ v = tb T) \/ (c = 1 /\ v = tc T)).
Proof.
  intros [<-|[<-|[<-|[]]]]; [exists 1, 0, 0|exists 0, 1, 0|exists 0, 0, 1]; repeat split; try lra; auto; apply point2_eq; unf2; ring.
Qed.
Lemma distinct_corners T : area T <> 0 -> ta T <> tb T /\ ta T <> tc T /\ tb T <> tc T.
Proof.
  intros V. repeat split; intros E; apply V; unfold area; rewrite E; unf2; ring.
Qed.
Lemma area_translate u T : area (translate2 u T) = area T.
Proof. unf2. ring. Qed.
Lemma corners_translate u T v : In v (corners (translate2 u T)) <-> exists w, In w (corners T) /\ v = add2 w u.
Proof.
  unfold corners, translate2; cbn. split.
  - intros [<-|[<-|[<-|[]]]]; eauto 8.
  - intros [w [[<-|[<-|[<-|[]]]] ->]]; auto.
Qed.
Lemma angles_translate u T : angles2 (translate2 u T) = angles2 T.
Proof.
  assert (K : forall x y, sub2 (add2 x u) (add2 y u) = sub2 x y) by (intros; apply point2_eq; unf2; ring).
  unfold angles2, translate2; cbn [ta tb tc]. rewrite !K. reflexivity.
Qed.

(** The centre and the radius of the circumscribed circle. *)
Definition circumcentre2 (T : triangle2) : point2 :=
  let u := sub2 (tb T) (ta T) in let v := sub2 (tc T) (ta T) in
  add2 (ta T) (scale2 (/ (2 * area T)) (sub2 (scale2 (dot2 u u) (Point2 (y2 v) (- x2 v))) (scale2 (dot2 v v) (Point2 (y2 u) (- x2 u))))).
Lemma circumscribed_centre2 T : area T <> 0 -> circumscribed2 T (circumcentre2 T) (distance_squared2 (ta T) (circumcentre2 T)).
Proof.
  intros V. unfold circumcentre2. set (u := sub2 (tb T) (ta T)). set (v := sub2 (tc T) (ta T)).
  assert (EV : area T = det2 u v) by reflexivity. rewrite EV in *. set (w := scale2 (/ (2 * det2 u v)) _).
  assert (K : 2 * dot2 u w = dot2 u u /\ 2 * dot2 v w = dot2 v v).
  { unfold w. clearbody u v. clear w EV. unfold dot2. unf2. split; field; auto. }
  destruct K as [K1 K2].
  assert (Q : forall x e, x = add2 (ta T) e -> 2 * dot2 e w = dot2 e e -> distance_squared2 x (add2 (ta T) w) = distance_squared2 (ta T) (add2 (ta T) w)).
  { intros x e -> Ke. unfold distance_squared2. unfold dot2 in *. unf2. lra. }
  intros x [<-|[<-|[<-|[]]]]; [reflexivity|apply (Q _ u)|apply (Q _ v)]; auto; apply point2_eq; unfold u, v; unf2; ring.
Qed.
Lemma circumradius2 T : area T <> 0 ->
  let u := sub2 (tb T) (ta T) in let v := sub2 (tc T) (ta T) in let w := sub2 (tc T) (tb T) in
  let g := dot2 u u * dot2 v v - dot2 u v * dot2 u v in
  0 < g /\ 4 * g * distance_squared2 (ta T) (circumcentre2 T) = dot2 u u * (dot2 v v * dot2 w w).
Proof.
  intros V u v w g. assert (G : g = area T * area T) by (unfold g, u, v, dot2; unf2; ring). split.
  - rewrite G. destruct (Rlt_dec 0 (area T)); nra.
  - rewrite G. unfold circumcentre2. fold u v. assert (EV : area T = det2 u v) by reflexivity. rewrite EV in *.
    replace w with (sub2 v u) by (unfold w, u, v; apply point2_eq; unf2; ring). clearbody u v.
    unfold distance_squared2, dot2. unf2. field. auto.
Qed.
Lemma centre_unique T C C' : area T <> 0 ->
  distance_squared2 (tb T) C = distance_squared2 (ta T) C -> distance_squared2 (tc T) C = distance_squared2 (ta T) C ->
  distance_squared2 (tb T) C' = distance_squared2 (ta T) C' -> distance_squared2 (tc T) C' = distance_squared2 (ta T) C' -> C = C'.
Proof.
  intros V A B A' B'. unfold distance_squared2, dot2 in *.
  set (X := x2 C - x2 C'). set (Y := y2 C - y2 C').
  assert (E1 : (x2 (tb T) - x2 (ta T)) * X + (y2 (tb T) - y2 (ta T)) * Y = 0) by (unfold X, Y; unf2; lra).
  assert (E2 : (x2 (tc T) - x2 (ta T)) * X + (y2 (tc T) - y2 (ta T)) * Y = 0) by (unfold X, Y; unf2; lra).
  clear A B A' B'.
  assert (X0 : area T * X = 0).
  { unf2. replace (_ * X) with (((x2 (tb T) - x2 (ta T)) * X + (y2 (tb T) - y2 (ta T)) * Y) * (y2 (tc T) - y2 (ta T)) - ((x2 (tc T) - x2 (ta T)) * X + (y2 (tc T) - y2 (ta T)) * Y) * (y2 (tb T) - y2 (ta T))) by ring.
    rewrite E1, E2. ring. }
  assert (Y0 : area T * Y = 0).
  { unf2. replace (_ * Y) with (((x2 (tc T) - x2 (ta T)) * X + (y2 (tc T) - y2 (ta T)) * Y) * (x2 (tb T) - x2 (ta T)) - ((x2 (tb T) - x2 (ta T)) * X + (y2 (tb T) - y2 (ta T)) * Y) * (x2 (tc T) - x2 (ta T))) by ring.
    rewrite E1, E2. ring. }
  apply Rmult_integral in X0, Y0. destruct X0 as [|X0]; [contradiction|]. destruct Y0 as [|Y0]; [contradiction|].
  apply point2_eq; unfold X, Y in *; lra.
Qed.

(** ** The three tetrahedra over a triangle *)
Definition turn (e : bool) (t : tetrahedron) := if e then t else trev t.
Definition overA (e : bool) T := turn e (Tetrahedron (up 0 (ta T)) (up 0 (tb T)) (up 0 (tc T)) (up 1 (tc T))).
Definition overB (e : bool) T := turn e (Tetrahedron (up 0 (ta T)) (up 1 (tb T)) (up 0 (tb T)) (up 1 (tc T))).
Definition overC (e : bool) T := turn e (Tetrahedron (up 0 (ta T)) (up 1 (ta T)) (up 1 (tb T)) (up 1 (tc T))).
Lemma hull_turn e t X : hull (turn e t) X <-> hull t X.
Proof. destruct e; cbn [turn]; [tauto|]. rewrite <- hull_trev. tauto. Qed.
Lemma open_hull_turn e t X : open_hull (turn e t) X <-> open_hull t X.
Proof. destruct e; cbn [turn]; [tauto|]. rewrite <- open_hull_trev. tauto. Qed.
Lemma verts_turn e t v : In v (verts (turn e t)) <-> In v (verts t).
Proof. destruct e; cbn; tauto. Qed.
Lemma common_turn e t t' X : common_hull (turn e t) t' X -> common_hull t t' X.
Proof.
  destruct e; cbn [turn]; auto. intros [a [b [c [d [A [B [C [D [S [E [Ha [Hb [Hc Hd]]]]]]]]]]]]].
  exists b, a, c, d. repeat split; auto; try lra. rewrite E. unfold combination, trev; cbn [va vb vc vd]. apply point_eq; unf; ring.
Qed.
Lemma vol_turn e t : vol (turn e t) <> 0 <-> vol t <> 0.
Proof. destruct e; cbn [turn]; [tauto|]. rewrite vol_trev. lra. Qed.
Lemma turn_translate e u t : translate u (turn e t) = turn e (translate u t).
Proof. destruct e; reflexivity. Qed.
Lemma over_translate u T e : translate (up 0 u) (overA e T) = overA e (translate2 u T) /\
  translate (up 0 u) (overB e T) = overB e (translate2 u T) /\ translate (up 0 u) (overC e T) = overC e (translate2 u T).
Proof.
  unfold overA, overB, overC. rewrite !turn_translate. unfold translate, translate2, up, add, add2; cbn [va vb vc vd ta tb tc x2 y2 px py pz].
  rewrite !Rplus_0_r. auto.
Qed.
Lemma vol_overA e T : vol (overA e T) <> 0 <-> area T <> 0.
Proof.
  unfold overA. rewrite vol_turn. unfold vol, up; cbn [va vb vc vd].
  match goal with |- ?x <> 0 <-> _ => replace x with (area T) by (unf; unf2; ring) end. tauto.
Qed.
Lemma bottom e T X : hull2 T X -> hull (overA e T) (up 0 X).
Proof.
  intros [a [b [c [A [B [C [S ->]]]]]]]. unfold overA. apply hull_turn. exists a, b, c, 0.
  repeat split; try lra. unfold combination, combination2, up; cbn [va vb vc vd]. apply point_eq; unf; unf2; ring.
Qed.
Lemma below T t Y : In t [overA true T; overA false T; overB true T; overB false T; overC true T; overC false T] -> hull t Y -> hull2 T (down Y).
Proof.
  intros Ht H.
  assert (K : exists t', In t' [overA true T; overB true T; overC true T] /\ hull t' Y).
  { unfold overA, overB, overC in *. cbn [turn] in *. simpl in Ht.
    destruct Ht as [<-|[<-|[<-|[<-|[<-|[<-|[]]]]]]]; rewrite <- ?hull_trev in H; eexists; (split; [|exact H]); simpl; auto. }
  clear t Ht H. destruct K as [t [Ht [a [b [c [d [A [B [C [D [S ->]]]]]]]]]]]. simpl in Ht.
  destruct Ht as [<-|[<-|[<-|[]]]]; [exists a, b, (c + d) | exists a, (b + c), d | exists (a + b), c, d];
  repeat split; try lra; unfold combination, up, down; cbn [overA overB overC turn va vb vc vd]; apply point2_eq; unf; unf2; ring.
Qed.
(** The weights of a point of the bottom plane. *)
Lemma bottom_weights T a b c d X : a + b + c + d = 1 -> up 0 X = combination (overA true T) a b c d -> d = 0 /\ X = combination2 T a b c.
Proof.
  intros S E. pose proof (f_equal px E) as X1. pose proof (f_equal py E) as Y1. pose proof (f_equal pz E) as Z1.
  unfold combination in *; cbn [overA turn va vb vc vd] in *. unf. unfold up in *; cbn [px py pz] in *. clear E.
  assert (d = 0) by lra. subst d. split; auto. apply point2_eq; unf2; lra.
Qed.
Lemma bottom_vertex e T v : In (up 0 v) (verts (overA e T)) <-> In v (corners T).
Proof.
  unfold overA. rewrite verts_turn. cbn. split.
  - intros [H|[H|[H|[H|[]]]]]; apply up_inj in H; auto.
  - intros [<-|[<-|[<-|[]]]]; auto.
Qed.

Section Ring.
Variables (A : Type) (aadd asub amul : A -> A -> A) (aofZ : Z -> A) (alt ale : A -> A -> bool).
Variable phi : A -> R.
Hypothesis phi_add : forall x y, phi (aadd x y) = (phi x + phi y)%R.
Hypothesis phi_sub : forall x y, phi (asub x y) = (phi x - phi y)%R.
Hypothesis phi_mul : forall x y, phi (amul x y) = (phi x * phi y)%R.
Hypothesis phi_Z : forall z, phi (aofZ z) = IZR z.
Hypothesis alt_ok : forall x y, alt x y = true -> (phi x < phi y)%R.
Hypothesis ale_ok : forall x y, ale x y = true -> (phi x <= phi y)%R.

(** ** What a certificate denotes *)
Section Denote.
Variables (c : cert2 A) (l1 l2 : point2).
Definition dpoint2 (v : A * A) := let d := IZR (e_den A c) in Point2 (phi (fst v) / d) (phi (snd v) / d).
(** Corner (v, n) is the point with the coordinates of vertex v, plus n, in the basis. *)
Definition dcorner2 (q : corner2) : point2 :=
  let v := nth (N.to_nat (fst q)) (e_verts A c) (aofZ 0, aofZ 0) in let n := snd q in let d := IZR (e_den A c) in
  at_coordinates2 l1 l2 (Point2 (phi (fst v) / d + IZR (fst n)) (phi (snd v) / d + IZR (snd n))).
Definition dtriangle (k : nat) : triangle2 :=
  match nth_error (e_tris A c) k with
  | Some t => Triangle2 (dcorner2 (p0 t)) (dcorner2 (p1 t)) (dcorner2 (p2 t))
  | None => Triangle2 origin2 origin2 origin2
  end.
Definition ddomain2 := domain2 l1 l2 (e_rank A c) (map dpoint2 (e_polytope A c)).
Definition dgram2 :=
  let '(g11, g22, g12) := e_gram A c in Gram2 (phi g11) (phi g22) (phi g12).
End Denote.

Section Sound.
Variable c : cert2 A.
Notation lift := (lift A aadd asub amul aofZ ale).
Let c3 := lift c.
Let N := length (e_tris A c).
Let r := e_rank A c.
(** What regions, too, have of the checks. *)
Definition based2 := (r <= 2)%nat /\ (forall t, In t (e_tris A c) -> in_range A c t = true) /\ based A aadd asub amul aofZ alt c3.
Hypothesis small : (r <= 2)%nat.
Hypothesis range : forall t, In t (e_tris A c) -> in_range A c t = true.
Hypothesis base3 : based A aadd asub amul aofZ alt c3.
Lemma lift_den : c_den A c3 = e_den A c.
Proof. unfold c3, PlaneChecker.lift. destruct (e_gram A c) as [[? ?] ?]. reflexivity. Qed.
Lemma lift_rank : c_rank A c3 = r.
Proof. unfold c3, PlaneChecker.lift. destruct (e_gram A c) as [[? ?] ?]. reflexivity. Qed.
Lemma lift_verts : c_verts A c3 = both_levels A aofZ (e_den A c) (e_verts A c).
Proof. unfold c3, PlaneChecker.lift. destruct (e_gram A c) as [[? ?] ?]. reflexivity. Qed.
Lemma lift_tets : c_tets A c3 = prisms (V2 A c) (e_tris A c) 0 (e_tris A c).
Proof. unfold c3, PlaneChecker.lift. destruct (e_gram A c) as [[? ?] ?]. reflexivity. Qed.
Lemma lift_polytope : c_polytope A c3 = polytope2 A aofZ c.
Proof. unfold c3, PlaneChecker.lift. destruct (e_gram A c) as [[? ?] ?]. reflexivity. Qed.
Lemma den_pos2 : 0 < IZR (e_den A c).
Proof. rewrite <- lift_den. apply (h_pos A aadd asub amul aofZ alt c3 base3). Qed.

Lemma prisms_nth V all : forall ts k0 k t, nth_error ts k = Some t ->
  nth_error (prisms V all k0 ts) (3 * k) = Some (tetA V all (k0 + N.of_nat k) t) /\
  nth_error (prisms V all k0 ts) (3 * k + 1) = Some (tetB V all (k0 + N.of_nat k) t) /\
  nth_error (prisms V all k0 ts) (3 * k + 2) = Some (tetC V all (k0 + N.of_nat k) t).
Proof.
  induction ts as [|t0 ts IH]; intros k0 k t H; [destruct k; discriminate|].
  destruct k as [|k].
  - injection H as ->. cbn. rewrite N.add_0_r. auto.
  - cbn [nth_error] in H. destruct (IH (k0 + 1)%N k t H) as [H1 [H2 H3]].
    replace (3 * S k)%nat with (S (S (S (3 * k)))) by lia.
    replace (S (S (S (3 * k))) + 1)%nat with (S (S (S (3 * k + 1)))) by lia.
    replace (S (S (S (3 * k))) + 2)%nat with (S (S (S (3 * k + 2)))) by lia.
    cbn [prisms nth_error]. replace (k0 + N.of_nat (S k))%N with (k0 + 1 + N.of_nat k)%N by lia. auto.
Qed.
Lemma prisms_length V all ts k : length (prisms V all k ts) = (3 * length ts)%nat.
Proof. revert k. induction ts as [|t ts IH]; intros k; cbn [prisms length]; [reflexivity|]. rewrite IH. lia. Qed.

Section Basis.
Variables l1 l2 : point2.
Hypothesis HG : has_gram2 (dgram2 c) l1 l2.
Let L1 := up 0 l1.
Let L2 := up 0 l2.
Let L3 := Point 0 0 1.

Lemma lift_gram : has_gram (dgram A phi c3) L1 L2 L3.
Proof.
  destruct HG as [H1 [H2 H3]]. unfold dgram2 in *. unfold dgram, c3, PlaneChecker.lift. 
  destruct (e_gram A c) as [[g11' g22'] g12']. cbn [h11 h22 h12] in *. cbn [c_gram k11 k22 k33 k12 k13 k23] in *.
  unfold has_gram; cbn [g11 g22 g33 g12 g13 g23]. unfold L1, L2. rewrite !dot_up. unfold Checker.zero. rewrite !phi_Z.
  repeat split; auto; unfold dot, L3, up; cbn [px py pz]; field; lra.
Qed.

Notation T3 := (dtet A aofZ phi c3 L1 L2 L3).
Notation T2 := (dtriangle c l1 l2).
Notation tile3 := (tile L1 L2 L3 T3).
Notation tile2 := (tile2 l1 l2 T2).
Notation is_tile2 := (is_tile2 r N).

Lemma dcorner_low q : (fst q < V2 A c)%N -> dcorner A aofZ phi c3 L1 L2 L3 (low q) = up 0 (dcorner2 c l1 l2 q).
Proof.
  intros B. unfold dcorner, dcorner2, low; cbn [fst snd]. rewrite lift_verts, lift_den. unfold both_levels.
  unfold V2 in B. rewrite app_nth1 by (rewrite map_length; lia).
  rewrite (nth_indep _ _ (level0 A aofZ (aofZ 0, aofZ 0))) by (rewrite map_length; lia). rewrite map_nth.
  destruct (nth _ _ _) as [x y]. destruct (snd q) as [m n]. cbn. unfold Checker.zero. rewrite phi_Z. pose proof den_pos2.
  unfold at_coordinates, at_coordinates2, L1, L2, L3, up. apply point_eq; unf; unf2; field; lra.
Qed.
Lemma dcorner_top q : (fst q < V2 A c)%N -> dcorner A aofZ phi c3 L1 L2 L3 (top (V2 A c) q) = up 1 (dcorner2 c l1 l2 q).
Proof.
  intros B. unfold dcorner, dcorner2, top; cbn [fst snd]. rewrite lift_verts, lift_den. unfold both_levels.
  unfold V2 in *. rewrite app_nth2 by (rewrite map_length; lia). rewrite map_length.
  replace (N.to_nat (fst q + N.of_nat (length (e_verts A c))) - length (e_verts A c))%nat with (N.to_nat (fst q)) by lia.
  rewrite (nth_indep _ _ (level1 A aofZ (e_den A c) (aofZ 0, aofZ 0))) by (rewrite map_length; lia). rewrite map_nth.
  destruct (nth _ _ _) as [x y]. destruct (snd q) as [m n]. cbn. rewrite phi_Z. pose proof den_pos2.
  unfold at_coordinates, at_coordinates2, L1, L2, L3, up. apply point_eq; unf; unf2; field; lra.
Qed.
Lemma get2 k : (k < N)%nat -> exists t, nth_error (e_tris A c) k = Some t /\ In t (e_tris A c) /\
  (fst (p0 t) < V2 A c)%N /\ (fst (p1 t) < V2 A c)%N /\ (fst (p2 t) < V2 A c)%N.
Proof.
  intros Hk. destruct (nth_error (e_tris A c) k) as [t|] eqn:E; [|apply nth_error_None in E; unfold N in Hk; lia].
  exists t. pose proof (nth_error_In _ _ E) as I. pose proof (range t I) as R. unfold in_range in R.
  rewrite !andb_true_iff, !N.ltb_lt in R. tauto.
Qed.
(** Whether the triangle is even. *)
Definition even_at (k : nat) : bool := match nth_error (e_tris A c) k with Some t => even t | None => true end.
Lemma shape k : (k < N)%nat -> let e := even_at k in T3 (3 * k)%nat = overA e (T2 k) /\ T3 (3 * k + 1)%nat = overB e (T2 k) /\ T3 (3 * k + 2)%nat = overC e (T2 k).
Proof.
  intros Hk. destruct (get2 k Hk) as [t [E [_ [B0 [B1 B2]]]]]. unfold even_at. rewrite E. cbv zeta.
  destruct (prisms_nth (V2 A c) (e_tris A c) (e_tris A c) 0 k t E) as [E1 [E2 E3]].
  unfold dtet, dtriangle. rewrite lift_tets, E1, E2, E3, E. unfold tetA, tetB, tetC, turned, overA, overB, overC, turn.
  destruct (even t); unfold trev; cbn [q0 q1 q2 q3 va vb vc vd ta tb tc]; rewrite !dcorner_low, !dcorner_top by auto; auto.
Qed.

Definition lat2 (n : Z3) : Z * Z := (fst (fst n), snd (fst n)).
Lemma lattice_up n : lattice_vector L1 L2 L3 (up3 n) = up 0 (lattice_vector2 l1 l2 n).
Proof. destruct n as [x y]. unfold lattice_vector, lattice_vector2, up3, at_coordinates, at_coordinates2, L1, L2, L3, up; cbn [fst snd]. apply point_eq; unf; unf2; ring. Qed.
Lemma lattice3 n : in_lattice r n -> n = up3 (lat2 n) /\ in_lattice2 r (lat2 n).
Proof.
  pose proof small as R. destruct n as [[x y] z]. unfold up3, lat2; cbn [fst snd].
  destruct r as [|[|[|]]]; cbn; [intuition congruence|intuition congruence|intuition congruence|lia].
Qed.
Lemma lattice2 n : in_lattice2 r n -> in_lattice r (up3 n).
Proof. destruct n as [x y]. pose proof small as R. unfold up3. destruct r as [|[|[|]]]; cbn; [tauto|tauto|tauto|lia]. Qed.
Lemma length3 : length (c_tets A c3) = (3 * N)%nat.
Proof. rewrite lift_tets, prisms_length. reflexivity. Qed.
Notation is_tile3 := (is_tile (c_rank A c3) (length (c_tets A c3))).

(** The tetrahedra over the tile (k, n). *)
Lemma over_tile_even k n : is_tile2 (k, n) -> let e := even_at k in
  (tile3 ((3 * k)%nat, up3 n) = overA e (tile2 (k, n)) /\ is_tile3 ((3 * k)%nat, up3 n)) /\
  (tile3 ((3 * k + 1)%nat, up3 n) = overB e (tile2 (k, n)) /\ is_tile3 ((3 * k + 1)%nat, up3 n)) /\
  (tile3 ((3 * k + 2)%nat, up3 n) = overC e (tile2 (k, n)) /\ is_tile3 ((3 * k + 2)%nat, up3 n)).
Proof.
  intros [Hk Hn]. cbn [fst snd] in *. destruct (shape k Hk) as [S1 [S2 S3]]. cbv zeta. set (e := even_at k) in *.
  destruct (over_translate (lattice_vector2 l1 l2 n) (T2 k) e) as [O1 [O2 O3]].
  unfold tile, PlaneStatement.tile2; cbn [fst snd]. rewrite lattice_up, S1, S2, S3, O1, O2, O3.
  unfold is_tile; cbn [fst snd]. rewrite length3, lift_rank. pose proof (lattice2 n Hn). repeat split; auto; lia.
Qed.
Lemma over_tile k n : is_tile2 (k, n) -> exists e,
  (tile3 ((3 * k)%nat, up3 n) = overA e (tile2 (k, n)) /\ is_tile3 ((3 * k)%nat, up3 n)) /\
  (tile3 ((3 * k + 1)%nat, up3 n) = overB e (tile2 (k, n)) /\ is_tile3 ((3 * k + 1)%nat, up3 n)) /\
  (tile3 ((3 * k + 2)%nat, up3 n) = overC e (tile2 (k, n)) /\ is_tile3 ((3 * k + 2)%nat, up3 n)).
Proof. intros H. exists (even_at k). apply over_tile_even, H. Qed.
(** Every tetrahedron is over a tile. *)
Lemma tile_below m n3 : is_tile3 (m, n3) -> exists k n, is_tile2 (k, n) /\ (k = m / 3)%nat /\ n = lat2 n3 /\
  forall Y, hull (tile3 (m, n3)) Y -> hull2 (tile2 (k, n)) (down Y).
Proof.
  intros [Hm Hn]. cbn [fst snd] in *. rewrite length3 in Hm. rewrite lift_rank in Hn. destruct (lattice3 n3 Hn) as [E Hn2].
  exists (m / 3)%nat, (lat2 n3).
  assert (Hk : (m / 3 < N)%nat) by (apply Nat.div_lt_upper_bound; lia).
  assert (T : is_tile2 ((m / 3)%nat, lat2 n3)) by (split; auto). split; auto. split; auto. split; auto.
  destruct (over_tile _ _ T) as [e [[A1 _] [[B1 _] [C1 _]]]]. rewrite <- E in A1, B1, C1.
  assert (M : m = (3 * (m / 3))%nat \/ m = (3 * (m / 3) + 1)%nat \/ m = (3 * (m / 3) + 2)%nat).
  { pose proof (Nat.div_mod m 3 ltac:(lia)). pose proof (Nat.mod_upper_bound m 3 ltac:(lia)). lia. }
  intros Y HY. destruct M as [M|[M|M]]; rewrite M, ?A1, ?B1, ?C1 in HY at 1; (apply below with (2 := HY); destruct e; simpl; tauto).
Qed.

(** *** The domain *)
Lemma polytope_low w : (r <= 1)%nat -> In w (map (dpoint2 c) (e_polytope A c)) -> In (up 0 w) (map (dpoint A phi c3) (c_polytope A c3)).
Proof.
  intros R H. rewrite lift_polytope. unfold polytope2. fold r. apply in_map_iff in H as [[x y] [<- H]].
  assert (X : up 0 (dpoint2 c (x, y)) = dpoint A phi c3 (level0 A aofZ (x, y))).
  { unfold dpoint2, dpoint, level0, up; cbn [fst snd vX vY vZ x2 y2]. rewrite lift_den. unfold Checker.zero. rewrite phi_Z. pose proof den_pos2.
    apply point_eq; cbn; auto. field. lra. }
  rewrite X. destruct r as [|[|]]; [| |lia]; apply in_map; unfold both_levels; apply in_app_iff; left; apply in_map; auto.
Qed.
Lemma polytope_down v : (r <= 1)%nat -> In v (map (dpoint A phi c3) (c_polytope A c3)) -> In (down v) (map (dpoint2 c) (e_polytope A c)).
Proof.
  intros R H. rewrite lift_polytope in H. unfold polytope2 in H. fold r in H. apply in_map_iff in H as [u [<- H]].
  assert (K : In u (both_levels A aofZ (e_den A c) (e_polytope A c))) by (destruct r as [|[|]]; [exact H|exact H|lia]).
  unfold both_levels in K. apply in_app_iff in K as [K|K]; apply in_map_iff in K as [p [<- Hp]]; apply in_map_iff; exists p; split; auto;
  unfold dpoint2, dpoint, level0, level1, down; cbn [vX vY px py]; rewrite lift_den; reflexivity.
Qed.
Lemma hull_up w : (r <= 1)%nat -> convex_hull2 (map (dpoint2 c) (e_polytope A c)) w -> convex_hull (map (dpoint A phi c3) (c_polytope A c3)) (up 0 w).
Proof.
  intros R H. induction H as [v Hv|x y s _ IHx _ IHy S].
  - apply hull_vertex, polytope_low; auto.
  - replace (up 0 (add2 (scale2 (1 - s) x) (scale2 s y))) with (add (scale (1 - s) (up 0 x)) (scale s (up 0 y))).
    + apply hull_segment; auto.
    + unfold up. apply point_eq; unf; unf2; ring.
Qed.
Lemma hull_down w : (r <= 1)%nat -> convex_hull (map (dpoint A phi c3) (c_polytope A c3)) w -> convex_hull2 (map (dpoint2 c) (e_polytope A c)) (down w).
Proof.
  intros R H. induction H as [v Hv|x y s _ IHx _ IHy S].
  - apply hull_vertex2, polytope_down; auto.
  - replace (down (add (scale (1 - s) x) (scale s y))) with (add2 (scale2 (1 - s) (down x)) (scale2 s (down y))).
    + apply hull_segment2; auto.
    + unfold down. apply point2_eq; unf; unf2; ring.
Qed.
Lemma domain_up X : ddomain2 c l1 l2 X -> ddomain A phi c3 L1 L2 L3 (up 0 X).
Proof.
  intros [x [-> H]]. exists (up 0 x). split.
  { unfold at_coordinates, at_coordinates2, L1, L2, L3, up. apply point_eq; unf; unf2; ring. }
  rewrite lift_rank. fold r in H. pose proof (hull_up) as HU. destruct r as [|[|[|]]] eqn:Er.
  - destruct H as [w [Hw ->]]. exists (up 0 w). split; auto.
  - destruct H as [w [Hw E]]. exists (up 0 w). split; auto.
  - exists (up 0 origin2). split; auto. apply hull_vertex. rewrite lift_polytope. unfold polytope2. fold r. rewrite Er.
    left. unfold dpoint, level0, up, origin2; cbn [fst snd vX vY vZ x2 y2]. rewrite lift_den. unfold Checker.zero. rewrite phi_Z. pose proof den_pos2.
    apply point_eq; cbn; field; lra.
  - exact I.
Qed.
Lemma domain_down X : ddomain A phi c3 L1 L2 L3 X -> ddomain2 c l1 l2 (down X).
Proof.
  intros [x [-> H]]. exists (down x). split.
  { unfold at_coordinates, at_coordinates2, L1, L2, L3, up, down. apply point2_eq; unf; unf2; ring. }
  rewrite lift_rank in H. fold r. pose proof hull_down as HD. destruct r as [|[|]].
  - destruct H as [w [Hw ->]]. exists (down w). auto.
  - destruct H as [w [Hw [E _]]]. exists (down w). split; auto.
  - exact I.
Qed.

(** *** Tiles *)
Lemma vol_tile3 cc : is_tile3 cc -> vol (tile3 cc) <> 0.
Proof.
  intros H. rewrite (dtet_cP A aadd asub amul aofZ alt phi phi_add phi_Z c3 base3), (tile_cP A aadd asub amul aofZ alt phi c3 base3), vol_Et.
  apply Rmult_integral_contrapositive_currified.
  - destruct cc as [k n]. pose proof (pvol A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c3 base3 k n (proj1 H)). lra.
  - apply (cdetb A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c3 base3 L1 L2 L3 lift_gram).
Qed.
Lemma area_tile cc : is_tile2 cc -> area (tile2 cc) <> 0.
Proof.
  destruct cc as [k n]. intros H. destruct (over_tile k n H) as [e [[A1 A2] _]]. apply (vol_overA e). rewrite <- A1. apply vol_tile3, A2.
Qed.
Lemma basis_plane : det2 l1 l2 <> 0.
Proof.
  pose proof (cdet A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c3 base3 L1 L2 L3 lift_gram) as D.
  intros Z. apply D. unfold L1, L2, L3, up. unfold det2 in Z. unfold det; cbn [px py pz]. lra.
Qed.
(** The tetrahedra are face to face, and so on: of tilings and of regions. *)
Section FaceToFace.
Hypothesis finite3 : forall M, exists F, forall c X, is_tile3 c -> near M origin X -> hull (tile3 c) X -> In c F.
Hypothesis disjoint3 : forall X c c', is_tile3 c -> is_tile3 c' -> open_hull (tile3 c) X -> hull (tile3 c') X -> c = c'.
Hypothesis faces3 : forall X c c', is_tile3 c -> is_tile3 c' -> hull (tile3 c) X -> hull (tile3 c') X -> common_hull (tile3 c) (tile3 c') X.
(** Two tiles with a common point: where it has positive weight, a common corner. *)
Lemma weights_common cc cc' X a b c0 : is_tile2 cc -> is_tile2 cc' -> hull2 (tile2 cc') X ->
  0 <= a -> 0 <= b -> 0 <= c0 -> a + b + c0 = 1 -> X = combination2 (tile2 cc) a b c0 ->
  (0 < a -> In (ta (tile2 cc)) (corners (tile2 cc'))) /\ (0 < b -> In (tb (tile2 cc)) (corners (tile2 cc'))) /\
  (0 < c0 -> In (tc (tile2 cc)) (corners (tile2 cc'))).
Proof.
  destruct cc as [k n], cc' as [k' n']. intros H H' HX Ha Hb Hc S E. pose proof (area_tile _ H) as AR.
  destruct (over_tile k n H) as [e [[A1 A2] _]]. destruct (over_tile k' n' H') as [e' [[A1' A2'] _]].
  assert (X1 : hull (tile3 ((3 * k)%nat, up3 n)) (up 0 X)) by (rewrite A1; apply bottom; exists a, b, c0; auto).
  assert (X2 : hull (tile3 ((3 * k')%nat, up3 n')) (up 0 X)) by (rewrite A1'; apply bottom; auto).
  pose proof (faces3 _ _ _ A2 A2' X1 X2) as CH. rewrite A1, A1' in CH.
  apply common_turn in CH. destruct CH as [a' [b' [c' [d' [Pa [Pb [Pc [Pd [S' [E' [Qa [Qb [Qc _]]]]]]]]]]]]].
  apply (bottom_weights (tile2 (k, n))) in E' as [D0 E']; auto. rewrite D0 in S'.
  rewrite E in E'. apply weights_unique in E' as [-> [-> ->]]; auto; [|lra].
  cbn [va vb vc] in Qa, Qb, Qc. repeat split; intros P; apply (bottom_vertex e'); auto.
Qed.

Lemma finite_plane M : exists F, forall c X, is_tile2 c -> near2 M origin2 X -> hull2 (tile2 c) X -> In c F.
Proof.
  destruct (finite3 M) as [F HF].
    exists (map (fun c => ((fst c / 3)%nat, lat2 (snd c))) F). intros [k n] X H [N1 N2] HX.
    destruct (over_tile k n H) as [e [[A1 A2] _]]. apply in_map_iff. exists ((3 * k)%nat, up3 n). split.
    + cbn [fst snd]. rewrite Nat.mul_comm, Nat.div_mul by lia. destruct n; reflexivity.
    + apply (HF _ (up 0 X)); auto; [|rewrite A1; apply bottom; auto].
      unfold near, up, origin; cbn [px py pz]. cbn [x2 y2 origin2] in N1, N2. split; auto. split; auto.
      rewrite Rminus_0_r, Rabs_R0. pose proof (Rabs_pos (x2 X - 0)). lra.
Qed.
Lemma disjoint_plane X cc cc' : is_tile2 cc -> is_tile2 cc' -> open_hull2 (tile2 cc) X -> hull2 (tile2 cc') X -> cc = cc'.
Proof.
  intros H H' HO HX. pose proof (area_tile _ H) as AR.
    destruct HO as [a [b [c0 [Ha [Hb [Hc [S E]]]]]]].
    destruct (weights_common cc cc' X a b c0) as [Ia [Ib Ic]]; auto; try lra.
    specialize (Ia Ha). specialize (Ib Hb). specialize (Ic Hc). clear a b c0 Ha Hb Hc S E.
    destruct (distinct_corners _ AR) as [N1 [N2 N3]].
    destruct cc as [k n], cc' as [k' n']. destruct (over_tile k n H) as [e [[A1 A2] _]]. destruct (over_tile k' n' H') as [e' [[A1' A2'] _]].
    set (T := tile2 (k, n)) in *. set (T' := tile2 (k', n')) in *.
    set (Z := combination (overA true T) (3/10) (3/10) (3/10) (1/10)).
    assert (Z1 : open_hull (tile3 ((3 * k)%nat, up3 n)) Z).
    { rewrite A1. unfold overA. apply open_hull_turn. exists (3/10), (3/10), (3/10), (1/10). repeat split; lra. }
    assert (Z2 : hull (tile3 ((3 * k')%nat, up3 n')) Z).
    { rewrite A1'. unfold overA. apply hull_turn.
      assert (G : exists a b c0 d, 0 <= a /\ 0 <= b /\ 0 <= c0 /\ 0 <= d /\ a + b + c0 + d = 1 /\ Z = combination (overA true T') a b c0 d); [|exact G].
      clear - Ia Ib Ic N1 N2 N3. unfold Z, corners in *. clear Z. destruct T as [a b c0], T' as [a' b' c']. cbn [ta tb tc overA turn] in *. simpl in Ia, Ib, Ic.
      destruct Ia as [->|[->|[->|[]]]]; destruct Ib as [->|[->|[->|[]]]]; destruct Ic as [->|[->|[->|[]]]]; try congruence;
      first [ exists (3/10), (3/10), (3/10), (1/10); repeat split; try lra; unfold combination, up; cbn [va vb vc vd]; apply point_eq; unf; field
            | exists (3/10), (4/10), (2/10), (1/10); repeat split; try lra; unfold combination, up; cbn [va vb vc vd]; apply point_eq; unf; field
            | exists (4/10), (3/10), (2/10), (1/10); repeat split; try lra; unfold combination, up; cbn [va vb vc vd]; apply point_eq; unf; field ]. }
    pose proof (disjoint3 _ _ _ A2 A2' Z1 Z2) as Q. injection Q as Q1 Q2 Q3.
    destruct n as [x y], n' as [x' y']. cbn [fst snd] in *. f_equal; [lia|]. congruence.
Qed.
Lemma edges_plane X cc cc' : is_tile2 cc -> is_tile2 cc' -> hull2 (tile2 cc) X -> hull2 (tile2 cc') X -> common_hull2 (tile2 cc) (tile2 cc') X.
Proof.
  intros H H' [a [b [c0 [Ha [Hb [Hc [S E]]]]]]] HX.
    destruct (weights_common cc cc' X a b c0) as [Ia [Ib Ic]]; auto. exists a, b, c0. repeat split; auto.
Qed.
End FaceToFace.

(** *** Angles *)
Let ee (v : v3 A) : point := E (scale (/ IZR (c_den A c3)) L1) (scale (/ IZR (c_den A c3)) L2) (scale (/ IZR (c_den A c3)) L3) (phi3 A phi v).
Notation place := (place A aadd aofZ c).
Lemma place_corner q : ee (place q) = dcorner A aofZ phi c3 L1 L2 L3 q.
Proof.
  unfold PlaneChecker.place. rewrite <- lift_verts, <- lift_den.
  apply (rp_dcorner A aadd asub amul aofZ alt phi phi_add phi_Z c3 base3).
Qed.
Lemma place_low q : (fst q < V2 A c)%N -> ee (place (low q)) = up 0 (dcorner2 c l1 l2 q).
Proof. intros. rewrite place_corner. apply dcorner_low; auto. Qed.
Lemma place_top q : (fst q < V2 A c)%N -> ee (place (top (V2 A c) q)) = up 1 (dcorner2 c l1 l2 q).
Proof. intros. rewrite place_corner. apply dcorner_top; auto. Qed.
Lemma triangle_get k : (k < N)%nat -> exists t, In t (e_tris A c) /\ nth_error (e_tris A c) k = Some t /\
  (fst (p0 t) < V2 A c)%N /\ (fst (p1 t) < V2 A c)%N /\ (fst (p2 t) < V2 A c)%N /\
  T2 k = Triangle2 (dcorner2 c l1 l2 (p0 t)) (dcorner2 c l1 l2 (p1 t)) (dcorner2 c l1 l2 (p2 t)).
Proof.
  intros Hk. destruct (get2 k Hk) as [t [E [I [B0 [B1 B2]]]]]. exists t. repeat split; auto. unfold dtriangle. rewrite E. reflexivity.
Qed.
(** The triangle of a tile, and the tile itself. *)
Definition item2 (cc : nat * (Z * Z)) : ctri :=
  match nth_error (e_tris A c) (fst cc) with Some t => t | None => CTri (0%N, (0, 0)%Z) (0%N, (0, 0)%Z) (0%N, (0, 0)%Z) None None None true end.
Lemma item2_in cc : is_tile2 cc -> In (item2 cc) (e_tris A c).
Proof. intros [Hk _]. destruct (triangle_get (fst cc) Hk) as [t [I [E _]]]. unfold item2. rewrite E. exact I. Qed.
Lemma in_item2 t : In t (e_tris A c) -> exists cc, is_tile2 cc /\ item2 cc = t.
Proof.
  intros H. apply In_nth_error in H as [k E]. exists (k, (0, 0)%Z). split; [|unfold item2; cbn [fst]; rewrite E; reflexivity].
  split; cbn [fst snd]; [apply nth_error_Some; congruence|]. destruct r as [|[|]]; cbn; auto.
Qed.
Definition real2 (t : ctri) := Triangle2 (dcorner2 c l1 l2 (p0 t)) (dcorner2 c l1 l2 (p1 t)) (dcorner2 c l1 l2 (p2 t)).
Lemma tile_item2 cc : is_tile2 cc -> let t := item2 cc in tile2 cc = translate2 (lattice_vector2 l1 l2 (snd cc)) (real2 t) /\ area (real2 t) <> 0 /\
  (fst (p0 t) < V2 A c)%N /\ (fst (p1 t) < V2 A c)%N /\ (fst (p2 t) < V2 A c)%N.
Proof.
  intros H. destruct (triangle_get (fst cc) (proj1 H)) as [t [_ [E [B0 [B1 [B2 ET]]]]]]. unfold item2. rewrite E. cbv zeta.
  pose proof (area_tile _ H) as AR. unfold PlaneStatement.tile2 in *. rewrite area_translate in AR. unfold real2. rewrite ET in *. auto.
Qed.
(** The number of a vertical edge. *)
Definition edge_angle2 := on_edge A (fun a b c0 d => dihedral (ee a) (ee b) (ee c0) (ee d)).
Lemma angles_three cc : is_tile2 cc -> angles2 (tile2 cc) = map edge_angle2 (three A aadd aofZ c (item2 cc)).
Proof.
  intros H. destruct (tile_item2 cc H) as [-> [_ [B0 [B1 B2]]]]. rewrite angles_translate.
  unfold three, edge_angle2, on_edge. cbn [map]. rewrite !place_low, !place_top, !dihedral_up by auto. reflexivity.
Qed.
Lemma three_orient cc i : is_tile2 cc -> In i (three A aadd aofZ c (item2 cc)) -> on_edge A (fun a b c0 d => orient (ee a) (ee b) (ee c0) (ee d)) i <> 0.
Proof.
  intros H Hi. destruct (tile_item2 cc H) as [_ [AR [B0 [B1 B2]]]]. unfold three in Hi. unfold real2 in AR.
  set (t := item2 cc) in *.
  set (a := dcorner2 c l1 l2 (p0 t)) in *. set (b := dcorner2 c l1 l2 (p1 t)) in *. set (d := dcorner2 c l1 l2 (p2 t)) in *.
  assert (O : forall u v w, det2 (sub2 v u) (sub2 w u) <> 0 -> orient (up 0 u) (up 1 u) (up 0 v) (up 0 w) <> 0).
  { intros u v w D Z. apply D. rewrite <- Z. unfold up. unf. unf2. ring. }
  simpl in Hi. destruct Hi as [<-|[<-|[<-|[]]]]; cbn [on_edge]; rewrite !place_low, place_top by auto; apply O; fold a b d; intros Z; apply AR; unf2; lra.
Qed.
Lemma each_angle2 (f : v3 A -> v3 A -> v3 A -> v3 A -> bool) (Q : R -> Prop) :
  (forall a b c0 d, orient (ee a) (ee b) (ee c0) (ee d) <> 0 -> f a b c0 d = true -> Q (dihedral (ee a) (ee b) (ee c0) (ee d))) ->
  forallb (fun t => forallb (on_edge A f) (three A aadd aofZ c t)) (e_tris A c) = true ->
  forall cc x, is_tile2 cc -> In x (angles2 (tile2 cc)) -> Q x.
Proof.
  intros HQ HF cc x Hc Hx. rewrite (angles_three cc Hc) in Hx. apply in_map_iff in Hx as [i [<- Hi]].
  rewrite forallb_forall in HF. specialize (HF _ (item2_in cc Hc)). rewrite forallb_forall in HF. specialize (HF i Hi).
  pose proof (three_orient cc i Hc Hi) as V. destruct i as [[[a b] c0] d]. apply HQ; auto.
Qed.
Notation chk_angle := (chk_angle A aadd asub amul aofZ alt ale (c_gram A c3)).
Lemma item_angle2 cc sg p q o i : is_tile2 cc -> chk_bound A aofZ alt ale sg p q = true -> In i (three A aadd aofZ c (item2 cc)) ->
  on_edge A (chk_angle sg p q o) i = true -> compares o (edge_angle2 i) (dangle A phi sg p q).
Proof.
  intros Hc B Hi H. pose proof (three_orient cc i Hc Hi) as V. destruct i as [[[a b] c0] d].
  apply (angle_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok c3 base3 L1 L2 L3 lift_gram o sg p q); auto.
Qed.
Lemma largest_sound2 rel sg p q : chk_bound A aofZ alt ale sg p q = true ->
  related rel (fun t => test_largest (fun o => on_edge A (chk_angle sg p q o)) (three A aadd aofZ c t)) (e_tris A c) = true ->
  largest_angle2 l1 l2 r N T2 rel (dangle A phi sg p q).
Proof.
  intros B. apply related_ok with (item := item2); [exact item2_in|exact in_item2|]. intros cc Hc. rewrite (angles_three cc Hc).
  unfold three. cbv zeta. cbn [map]. match goal with |- exists q, largest (?x :: ?l) _ /\ _ => destruct (largest_exists x l) as [y Hy] end.
  exists y. split; [exact Hy|]. intros o. apply (test_largest_ok _ _ edge_angle2); [|exact Hy]. intros o' i Hi. apply (item_angle2 cc); auto.
Qed.
Lemma smallest_sound2 rel sg p q : chk_bound A aofZ alt ale sg p q = true ->
  related rel (fun t => test_smallest (fun o => on_edge A (chk_angle sg p q o)) (three A aadd aofZ c t)) (e_tris A c) = true ->
  smallest_angle2 l1 l2 r N T2 rel (dangle A phi sg p q).
Proof.
  intros B. apply related_ok with (item := item2); [exact item2_in|exact in_item2|]. intros cc Hc. rewrite (angles_three cc Hc).
  unfold three. cbv zeta. cbn [map]. match goal with |- exists q, smallest (?x :: ?l) _ /\ _ => destruct (smallest_exists x l) as [y Hy] end.
  exists y. split; [exact Hy|]. intros o. apply (test_smallest_ok _ _ edge_angle2); [|exact Hy]. intros o' i Hi. apply (item_angle2 cc); auto.
Qed.

(** *** Radii *)
Let s := / IZR (c_den A c3) * / IZR (c_den A c3).
Notation kgdot := (kgdot A aadd amul (c_gram A c3)).
Notation vsub := (vsub A asub).
Lemma s_pos2 : 0 < s.
Proof. apply (s_pos A aadd asub amul aofZ alt c3 base3). Qed.
Lemma dot_ee a b d f : dot (sub (ee b) (ee a)) (sub (ee f) (ee d)) = s * phi (kgdot (vsub b a) (vsub f d)).
Proof.
  unfold ee. rewrite <- !E_sub, <- !(phi3_sub A asub phi phi_sub).
  rewrite (phi_gdot A aadd amul phi phi_add phi_mul).
  apply (dot_e A phi c3 L1 L2 L3 lift_gram).
Qed.
Lemma distance_pos2 u v : u <> v -> 0 < distance_squared2 u v.
Proof. intros Ne. rewrite <- (distance_up 0). apply distance_pos. intros E. apply Ne, (up_inj 0 0), E. Qed.
Lemma distance_translate2 u v w : distance_squared2 (add2 u w) (add2 v w) = distance_squared2 u v.
Proof. unfold distance_squared2, dot2. unf2. ring. Qed.
Lemma radius_sound2 rel p q : 0 < IZR q -> related rel (chk_radius2 A aadd asub amul aofZ alt ale c p q) (e_tris A c) = true ->
  squared_radius_edge_ratio2 l1 l2 r N T2 rel (phi p / IZR q).
Proof.
  intros Q. apply related_ok with (item := item2); [exact item2_in|exact in_item2|]. intros cc Hc.
  destruct (tile_item2 cc Hc) as [-> [AR [B0 [B1 B2]]]]. set (w := lattice_vector2 _ _ _). set (t := item2 cc) in *.
  set (R2 := distance_squared2 (ta (real2 t)) (circumcentre2 (real2 t))).
  assert (ES : squared_edges2 (translate2 w (real2 t)) = squared_edges2 (real2 t)).
  { unfold squared_edges2, translate2; cbn [ta tb tc]. rewrite !distance_translate2. reflexivity. }
  destruct (smallest_exists (distance_squared2 (ta (real2 t)) (tb (real2 t))) (tl (squared_edges2 (real2 t)))) as [l Hl].
  change (smallest (squared_edges2 (real2 t)) l) in Hl.
  exists (R2 / l). split.
  { exists (add2 (circumcentre2 (real2 t)) w), R2, l. split; [|split; [rewrite ES; exact Hl|reflexivity]].
    intros v Hv. apply corners_translate in Hv as [u [Hu ->]]. rewrite distance_translate2. apply circumscribed_centre2; auto. }
  destruct (distinct_corners _ AR) as [N1 [N2 N3]].
  destruct (circumradius2 (real2 t) AR) as [G0 R0]. cbv zeta in G0, R0. fold R2 in R0.
  assert (R2P : 0 <= R2).
  { unfold R2, distance_squared2. set (u := sub2 _ _). unfold dot2. pose proof (Rle_0_sqr (x2 u)); pose proof (Rle_0_sqr (y2 u)). unfold Rsqr in *. lra. }
  clearbody R2. unfold real2 in *; cbn [ta tb tc] in *.
  pose proof (place_low (p0 t) B0) as X0. pose proof (place_low (p1 t) B1) as X1. pose proof (place_low (p2 t) B2) as X2.
  intros o. unfold chk_radius2. cbv zeta. change (c_gram A (lift c)) with (c_gram A c3).
  set (a := dcorner2 c l1 l2 (p0 t)) in *. set (b := dcorner2 c l1 l2 (p1 t)) in *. set (d := dcorner2 c l1 l2 (p2 t)) in *.
  set (ka := place (low (p0 t))) in *. set (kb := place (low (p1 t))) in *. set (kd := place (low (p2 t))) in *.
  assert (K : forall x y z v X Y Z V, ee x = up 0 X -> ee y = up 0 Y -> ee z = up 0 Z -> ee v = up 0 V ->
    dot2 (sub2 Y X) (sub2 V Z) = s * phi (kgdot (vsub y x) (vsub v z))).
  { intros x y z v X Y Z V Ex Ey Ez Ev. rewrite <- dot_ee, Ex, Ey, Ez, Ev, !sub_up, dot_up. reflexivity. }
  rewrite !(K ka kb ka kb a b a b), !(K ka kd ka kd a d a d), !(K ka kb ka kd a b a d), !(K kb kd kb kd b d b d) in * by auto.
  pose proof s_pos2 as S. set (uu := phi (kgdot (vsub kb ka) (vsub kb ka))) in *. set (vv := phi (kgdot (vsub kd ka) (vsub kd ka))) in *.
  set (uv := phi (kgdot (vsub kb ka) (vsub kd ka))) in *. set (ww := phi (kgdot (vsub kd kb) (vsub kd kb))) in *.
  assert (F : forall o x y X Y, ee x = up 0 X -> ee y = up 0 Y -> X <> Y ->
    chk_ratio A aadd asub amul aofZ alt ale (c_gram A c3) p q (kradius2 A aadd asub amul (c_gram A c3) ka kb kd) o x y = true ->
    compares o (R2 / distance_squared2 X Y) (phi p / IZR q)).
  { clear o. intros o x y X Y Ex Ey Ne C. apply (ratio_rule o R2 _ _ _ _ _ G0 R0 Q (distance_pos2 X Y Ne)).
    rewrite distance_sym2. unfold distance_squared2. rewrite (K x y x y X Y X Y) by auto.
    unfold chk_ratio, kradius2 in C. cbn [fst snd] in C. apply (compare_ok A alt ale phi alt_ok ale_ok) in C. rewrite !phi_mul, phi_sub, !phi_mul, !phi_Z in C.
    fold uu vv uv ww in C. set (l' := phi (kgdot (vsub y x) (vsub y x))) in *.
    assert (S3' : 0 < s * s * s) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; apply s_pos2).
    apply (compares_scale _ _ _ _ S3') in C. clearbody s uu vv uv ww l'.
    replace (IZR q * (s * uu * (s * vv * (s * ww)))) with (s * s * s * (IZR q * (uu * (vv * ww)))) by ring.
    replace (4 * phi p * (s * uu * (s * vv) - s * uv * (s * uv)) * (s * l')) with (s * s * s * (4 * phi p * (uu * vv - uv * uv) * l')) by ring.
    exact C. }
  (* the three sides, each with its square *)
  set (square := fun i : v3 A * v3 A => s * phi (kgdot (vsub (snd i) (fst i)) (vsub (snd i) (fst i)))).
  assert (SQ : forall x y X Y, ee x = up 0 X -> ee y = up 0 Y -> distance_squared2 X Y = square (x, y)).
  { intros x y X Y Ex Ey. rewrite distance_sym2. unfold distance_squared2. apply (K x y x y X Y X Y); auto. }
  unfold squared_edges2 in Hl; cbn [ta tb tc] in Hl.
  apply (test_largest_ok _ _ (fun i => R2 / square i)).
  - intros o' i [<-|[<-|[<-|[]]]] H; cbn [fst snd] in H.
    + rewrite <- (SQ ka kb a b) by auto. apply (F o' ka kb); auto.
    + rewrite <- (SQ ka kd a d) by auto. apply (F o' ka kd); auto.
    + rewrite <- (SQ kb kd b d) by auto. apply (F o' kb kd); auto.
  - rewrite (SQ ka kb a b), (SQ ka kd a d), (SQ kb kd b d) in Hl by auto. rewrite <- (map_map square (fun x => R2 / x)). apply largest_quotient; auto.
    intros x [<-|[<-|[<-|[]]]].
    + rewrite <- (SQ ka kb a b) by auto. apply distance_pos2; auto.
    + rewrite <- (SQ ka kd a d) by auto. apply distance_pos2; auto.
    + rewrite <- (SQ kb kd b d) by auto. apply distance_pos2; auto.
Qed.

(** *** The tiling *)
(** *** Delaunay *)
(** The balls of the tetrahedra over T meet the bottom plane in the circle of T. *)
Lemma circle_A e T C q : circumscribed (overA e T) C q ->
  circumscribed2 T (down C) (q - pz C * pz C) /\ forall v, distance_squared (up 0 v) C = distance_squared2 v (down C) + pz C * pz C.
Proof.
  intros H. assert (D : forall v, distance_squared (up 0 v) C = distance_squared2 v (down C) + pz C * pz C).
  { intros v. rewrite distance_down. ring. }
  split; auto. intros v Hv. assert (K : In (up 0 v) (verts (overA e T))) by (apply bottom_vertex; auto).
  apply H in K. rewrite D in K. lra.
Qed.
Lemma bottom_vx e T j : In j I4 -> (j < 3)%nat -> exists v, In v (corners T) /\ vx (overA e T) (N.to_nat (slot e (N.of_nat j))) = up 0 v.
Proof.
  intros _ H. destruct j as [|[|[|j]]]; [| | |lia]; destruct e; eexists; (split; [|reflexivity]); simpl; auto.
Qed.
Theorem not_delaunay_sound2 : chk_not_delaunay2 A aadd asub amul aofZ alt ale c = true -> not_delaunay2 l1 l2 r N T2.
Proof.
  intros H. unfold chk_not_delaunay2 in H. cbv zeta in H. rewrite existsl_eq, existsb_exists in H. destruct H as [t [It H]].
  rewrite existsl_eq, existsb_exists in H. destruct H as [m [_ H]]. apply In_nth_error in It as [k Et].
  destruct (prisms_nth (V2 A c) (e_tris A c) (e_tris A c) 0 k t Et) as [N0 _]. rewrite N.add_0_l in N0. rewrite <- lift_tets in N0.
  assert (KE : kpos A aadd aofZ (c_den A c3) (c_verts A c3) (tetA (V2 A c) (e_tris A c) 0 t) =
    kpos A aadd aofZ (c_den A c3) (c_verts A c3) (tetA (V2 A c) (e_tris A c) (N.of_nat k) t)) by (unfold tetA; destruct (even t); reflexivity).
  fold c3 in H. rewrite KE in H.
  destruct (inside_at_sound A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c3 base3 L1 L2 L3 lift_gram _ _ _ N0 H) as [k' [i' [d [E [Hi [V' [V D]]]]]]].
  cbv zeta in D. rewrite <- (dtet_cP A aadd asub amul aofZ alt phi phi_add phi_Z c3 base3) in D.
  unfold bottom_mate in E. destruct m as [[[t' j] u]|]; [|discriminate]. destruct (N.ltb_spec j 3) as [Hj|]; [|discriminate].
  cbn [lifted_mate] in E. injection E as E1 E2 E3.
  assert (Ek : k' = (3 * t')%N) by (rewrite <- E1, N.add_0_r; reflexivity). clear E1. subst d k'. rewrite N2Nat.inj_mul in V', D. change (N.to_nat 3) with 3%nat in V', D.
  pose proof (lattice3 _ (eq_ind _ (fun x => in_lattice x (up3 u)) (proj2 V') _ lift_rank)) as [_ Hu]. cbn [snd lat2 up3 fst] in Hu.
  assert (Hk' : (N.to_nat t' < N)%nat) by (pose proof (proj1 V') as X; cbn [fst] in X; rewrite length3 in X; lia).
  assert (T' : is_tile2 (N.to_nat t', u)) by (split; [exact Hk'|destruct u; exact Hu]).
  assert (Hk : (k < N)%nat) by (apply nth_error_Some; congruence).
  assert (T : is_tile2 (k, (0, 0)%Z)) by (split; [exact Hk|destruct r as [|[|?]]; cbn; auto]).
  destruct (over_tile_even _ _ T) as [[A1 A2] _]. destruct (over_tile_even _ _ T') as [[B1 _] _].
  change (up3 (0, 0)%Z) with z30 in A1, A2. rewrite B1, A1 in D.
  assert (Ei : N.to_nat i' = N.to_nat (slot (even_at (N.to_nat t')) (N.of_nat (N.to_nat j)))).
  { rewrite N2Nat.id, <- E2. cbn [snd]. unfold even_at. destruct (nth_error (e_tris A c) (N.to_nat t')); reflexivity. }
  rewrite Ei in D. destruct (bottom_vx (even_at (N.to_nat t')) (tile2 (N.to_nat t', u)) (N.to_nat j)) as [v [Iv Ev]]; [apply I4_lt; lia|lia|].
  rewrite Ev in D.
  pose proof (circumscribed_centre (tile3 ((3 * k)%nat, z30)) (vol_tile3 _ A2)) as CC. rewrite A1 in CC.
  destruct (circle_A _ _ _ _ CC) as [C2 D2]. rewrite D2 in D.
  eexists. eexists. eexists. exists v. split; [exact T|]. split; [exact C2|]. split; [eexists; split; [exact T'|exact Iv]|]. lra.
Qed.

(** *** Lines that no triangle crosses: planes that no tetrahedron crosses *)
Theorem uncrossed_sound2 part c1 c2 p q : 0 < IZR q ->
  forallb (chk_uncrossed A aadd asub amul aofZ ale part (c_den A c3) (c_rank A c3) (c1, c2, 0%Z) p q) (positions A aadd aofZ c3) = true ->
  uncrossed2 l1 l2 r N T2 (c1, c2) (IZR p / IZR q).
Proof.
  intros Q H [k n] Ht.
  pose proof (uncrossed_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok c3 base3 L1 L2 L3 lift_gram part _ p q Q H) as U.
  rewrite <- (dtet_cP A aadd asub amul aofZ alt phi phi_add phi_Z c3 base3) in U.
  destruct (over_tile k n Ht) as [e [[A1 A2] _]]. specialize (U _ A2). rewrite A1 in U.
  assert (K : forall x, hull2 (tile2 (k, n)) (at_coordinates2 l1 l2 x) -> hull (overA e (tile2 (k, n))) (at_coordinates L1 L2 L3 (up 0 x)) /\
    linear_form (c1, c2, 0%Z) (up 0 x) = IZR c1 * x2 x + IZR c2 * y2 x).
  { intros x Hx. split.
    - replace (at_coordinates L1 L2 L3 (up 0 x)) with (up 0 (at_coordinates2 l1 l2 x)); [apply bottom, Hx|].
      unfold at_coordinates, at_coordinates2, L1, L2, L3, up. apply point_eq; unf; unf2; ring.
    - unfold linear_form, up; cbn [px py pz]. ring. }
  cbn [fst snd]. destruct U as [U|U]; [left|right]; intros x Hx; destruct (K x Hx) as [K1 <-]; apply U, K1.
Qed.

Section Tiling.
Hypothesis chk3 : check_tiling A aadd asub amul aofZ alt ale c3 = true.
Let S3 := tiling_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok c3 base3 chk3 L1 L2 L3 lift_gram.
Theorem plane_sound : edge_to_edge_tiling l1 l2 r (ddomain2 c l1 l2) N T2.
Proof.
  constructor.
  - apply basis_plane.
  - apply area_tile.
  - apply finite_plane, (tiling_locally_finite _ _ _ _ _ _ _ S3).
  - intros [k n] X H HX. destruct (over_tile k n H) as [e [[A1 A2] _]].
    assert (D : ddomain A phi c3 L1 L2 L3 (up 0 X)).
    { apply (tiling_inside _ _ _ _ _ _ _ S3 _ _ A2). rewrite A1. apply bottom; auto. }
    apply domain_down in D. destruct X; exact D.
  - intros X HX. destruct (tiling_cover _ _ _ _ _ _ _ S3 _ (domain_up X HX)) as [[m n3] [Hm HY]].
    destruct (tile_below m n3 Hm) as [k [n [Ht [_ [_ D]]]]]. exists (k, n). split; auto. specialize (D _ HY). destruct X; exact D.
  - apply disjoint_plane; [apply (tiling_disjoint _ _ _ _ _ _ _ S3)|apply (tiling_face_to_face _ _ _ _ _ _ _ S3)].
  - apply edges_plane, (tiling_face_to_face _ _ _ _ _ _ _ S3).
Qed.

Notation tile3' := (tile L1 L2 L3 T3).
Lemma vertex_up v : is_vertex2 l1 l2 r N T2 v -> is_vertex L1 L2 L3 (c_rank A c3) (length (c_tets A c3)) T3 (up 0 v).
Proof.
  intros [[k n] [H Hv]]. destruct (over_tile k n H) as [e [[A1 A2] _]]. exists ((3 * k)%nat, up3 n). split; auto.
  rewrite A1. apply bottom_vertex; auto.
Qed.
Lemma circle_B e T C q : area T <> 0 -> circumscribed (overB e T) C q -> down C = circumcentre2 T /\ q = distance_squared2 (ta T) (circumcentre2 T) + pz C * pz C.
Proof.
  intros V H.
  assert (Ka : distance_squared (up 0 (ta T)) C = q) by (apply H; unfold overB; apply verts_turn; simpl; auto).
  assert (Kb0 : distance_squared (up 0 (tb T)) C = q) by (apply H; unfold overB; apply verts_turn; simpl; auto).
  assert (Kb1 : distance_squared (up 1 (tb T)) C = q) by (apply H; unfold overB; apply verts_turn; simpl; auto).
  assert (Kc : distance_squared (up 1 (tc T)) C = q) by (apply H; unfold overB; apply verts_turn; simpl; auto).
  rewrite distance_down in Ka, Kb0, Kb1, Kc. assert (Hz : pz C = / 2) by lra. rewrite Hz in *.
  pose proof (circumscribed_centre2 T V) as CC.
  assert (DC : down C = circumcentre2 T).
  { apply (centre_unique T); auto; try lra; [apply (CC (tb T))|apply (CC (tc T))]; simpl; auto. }
  split; auto. rewrite <- DC. lra.
Qed.
Let weak3 := statement_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok c3 base3 chk3 L1 L2 L3 lift_gram (CWeaklyDelaunay A).
Lemma weakly_sound2 : chk_delaunay A aadd asub amul aofZ ale c3 = true -> forall k n, is_tile2 (k, n) ->
  let T := tile2 (k, n) in circumscribed2 T (circumcentre2 T) (distance_squared2 (ta T) (circumcentre2 T)) /\
  forall v, is_vertex2 l1 l2 r N T2 v -> distance_squared2 (ta T) (circumcentre2 T) <= distance_squared2 v (circumcentre2 T).
Proof.
  intros H k n Ht T. pose proof (area_tile _ Ht) as AR. fold T in AR. split; [apply circumscribed_centre2; auto|].
  pose proof (weak3 H) as W. cbn [holds] in W. rewrite <- (dtet_cP A aadd asub amul aofZ alt phi phi_add phi_Z c3 base3) in W.
  destruct (over_tile k n Ht) as [e [[A1 A2] _]]. destruct (W _ A2) as [C [q [HC HW]]]. rewrite A1 in HC.
  destruct (circle_A e T C q HC) as [H2 D].
  assert (DC : down C = circumcentre2 T).
  { pose proof (circumscribed_centre2 T AR) as CC. pose proof (H2 (ta T) ltac:(simpl; auto)) as Qa.
    apply (centre_unique T); auto; try (rewrite Qa; apply H2; simpl; auto); [apply (CC (tb T))|apply (CC (tc T))]; simpl; auto. }
  intros v Hv. specialize (HW _ (vertex_up v Hv)). rewrite D, DC in HW.
  pose proof (H2 (ta T) ltac:(simpl; auto)) as Qa. rewrite DC in Qa. lra.
Qed.
Lemma edges_nth c' kts V all : forall ts k0 k t, chk_edges A aadd asub amul aofZ alt c' kts (prisms V all k0 ts) = true -> nth_error ts k = Some t ->
  let strict u i := chk_power A aadd asub amul aofZ alt (c_gram A c') (c_den A c') kts u (kpos A aadd aofZ (c_den A c') (c_verts A c') u) i = true in
  strict (tetA V all (k0 + N.of_nat k) t) 0%nat /\ strict (tetA V all (k0 + N.of_nat k) t) 1%nat /\ strict (tetB V all (k0 + N.of_nat k) t) 3%nat.
Proof.
  induction ts as [|t0 ts IH]; intros k0 k t H Ek; [destruct k; discriminate|].
  cbn [prisms chk_edges] in H. rewrite !andb_true_iff in H. destruct H as [[[H0 H1] H3] H].
  destruct k as [|k].
  - injection Ek as ->. rewrite N.add_0_r. auto.
  - cbn [nth_error] in Ek. replace (k0 + N.of_nat (S k))%N with (k0 + 1 + N.of_nat k)%N by lia. apply (IH _ k t H Ek).
Qed.
Lemma circumscribed_tile m n3 : is_tile3 (m, n3) ->
  circumscribed (tile3 (m, n3)) (circumcentre (tile3 (m, n3))) (distance_squared (va (tile3 (m, n3))) (circumcentre (tile3 (m, n3)))).
Proof. intros H. apply circumscribed_centre, vol_tile3, H. Qed.

Ltac weigh := unfold combination; cbn [overA overB turn trev va vb vc vd]; unfold up; apply point_eq; unf; unf2; ring.
Lemma strict_sound2 : check_statement2 A aadd asub amul aofZ alt ale c (CDelaunay A) = true -> delaunay2 l1 l2 r N T2.
Proof.
  intros H [k n] Ht. cbn [check_statement2] in H. cbv zeta in H. apply andb_true_iff in H as [H HWL].
  destruct (weakly_sound2 H k n Ht) as [CC W]. cbv zeta in CC, W. set (T := tile2 (k, n)) in *.
  exists (circumcentre2 T), (distance_squared2 (ta T) (circumcentre2 T)). split; auto. intros v Hv. split; auto. intros EQ.
  pose proof (area_tile _ Ht) as AR. fold T in AR.
  destruct (weights_exist T v AR) as [a [b [d [S E]]]].
  change (c_tets A (lift c)) with (c_tets A c3) in HWL. rewrite lift_tets in HWL.
  destruct (get2 k (proj1 Ht)) as [t [Et _]].
  destruct (edges_nth _ _ _ _ _ _ k t HWL Et) as [W0 [W1 W3]]. cbv zeta in W0, W1, W3. rewrite N.add_0_l in W0, W1, W3.
  destruct (prisms_nth (V2 A c) (e_tris A c) (e_tris A c) 0 k t Et) as [N0 [N1 _]]. rewrite N.add_0_l in N0, N1. rewrite <- lift_tets in N0, N1.
  pose proof (strict_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok c3 base3 chk3 L1 L2 L3 lift_gram) as SS.
  rewrite <- (dtet_cP A aadd asub amul aofZ alt phi phi_add phi_Z c3 base3) in SS. cbv zeta in SS.
  destruct (over_tile k n Ht) as [e [[A1 A2] [[B1 B2] _]]]. fold T in A1, B1.
  pose proof (vertex_up v Hv) as VU.
  pose proof (circumscribed_tile _ _ A2) as CA. pose proof (circumscribed_tile _ _ B2) as CB.
  assert (HA : forall i, In i I4 -> forall w0 w1 w2 w3, w0 + w1 + w2 + w3 = 1 -> nth i [w0; w1; w2; w3] 0 < 0 ->
     up 0 v = combination (tile3 ((3 * k)%nat, up3 n)) w0 w1 w2 w3 ->
     chk_power A aadd asub amul aofZ alt (c_gram A c3) (c_den A c3) (positions A aadd aofZ c3) (tetA (V2 A c) (e_tris A c) (N.of_nat k) t)
       (kpos A aadd aofZ (c_den A c3) (c_verts A c3) (tetA (V2 A c) (e_tris A c) (N.of_nat k) t)) i = true -> False).
  { intros i Hi w0 w1 w2 w3 SW Wi Ev CP.
    pose proof (SS _ (up3 n) i w0 w1 w2 w3 _ H A2 N0 Hi CP SW Wi) as K. rewrite <- Ev in K. specialize (K VU).
    rewrite A1 in CA. destruct (circle_A e T _ _ CA) as [H2 D]. rewrite <- A1 in *. rewrite D in K.
    set (C := circumcentre (tile3 ((3 * k)%nat, up3 n))) in *. set (q := distance_squared (va _) C) in *.
    assert (DC : down C = circumcentre2 T).
    { pose proof (H2 (ta T) ltac:(simpl; auto)) as Qa.
      apply (centre_unique T); auto; try (rewrite Qa; apply H2; simpl; auto); [apply (CC (tb T))|apply (CC (tc T))]; simpl; auto. }
    pose proof (H2 (ta T) ltac:(simpl; auto)) as Qa. rewrite DC in *. lra. }
  destruct (Rlt_dec a 0) as [Na|Pa]; [exfalso|destruct (Rlt_dec b 0) as [Nb|Pb]; [exfalso|destruct (Rlt_dec d 0) as [Nd|Pd]; [exfalso|]]].
  - destruct e.
    + apply (HA 0%nat ltac:(simpl; auto) a b d 0); auto; [lra|]. rewrite A1, E. weigh.
    + apply (HA 1%nat ltac:(simpl; auto) b a d 0); auto; [lra|]. rewrite A1, E. weigh.
  - destruct e.
    + apply (HA 1%nat ltac:(simpl; auto) a b d 0); auto; [lra|]. rewrite A1, E. weigh.
    + apply (HA 0%nat ltac:(simpl; auto) b a d 0); auto; [lra|]. rewrite A1, E. weigh.
  - assert (KB : forall w0 w1 w2 w3, w0 + w1 + w2 + w3 = 1 -> w3 < 0 -> up 0 v = combination (tile3 ((3 * k + 1)%nat, up3 n)) w0 w1 w2 w3 -> False).
    { intros w0 w1 w2 w3 SW Wi Ev.
      pose proof (SS _ (up3 n) 3%nat w0 w1 w2 w3 _ H B2 N1 ltac:(simpl; auto) W3 SW Wi) as K. rewrite <- Ev in K. specialize (K VU).
      rewrite B1 in CB. destruct (circle_B e T _ _ AR CB) as [DC Q]. rewrite <- B1 in *. rewrite distance_down, DC in K.
      set (C := circumcentre (tile3 ((3 * k + 1)%nat, up3 n))) in *. lra. }
    destruct e.
    + apply (KB a (- d) (b + d) d); auto; [lra|]. rewrite B1, E. weigh.
    + apply (KB (- d) a (b + d) d); auto; [lra|]. rewrite B1, E. weigh.
  - destruct Hv as [cc' [Ht' Hv]]. pose proof (corner_weights _ _ Hv) as [a' [b' [d' [P1 [P2 [P3 [S' [E' OR]]]]]]]].
    destruct (weights_common (tiling_face_to_face _ _ _ _ _ _ _ S3) cc' (k, n) v a' b' d' Ht' Ht) as [Ia [Ib Ic]]; auto.
    { exists a, b, d. repeat split; auto; lra. }
    fold T in Ia, Ib, Ic. destruct OR as [[-> ->]|[[-> ->]|[-> ->]]]; [apply Ia|apply Ib|apply Ic]; lra.
Qed.

Lemma delaunay_sound2 st : check_statement2 A aadd asub amul aofZ alt ale c st = true ->
  match st with CDelaunay _ | CWeaklyDelaunay _ => holds2 l1 l2 r N T2 (dstatement A phi st) | _ => True end.
Proof.
  intros H. destruct st; auto; cbn [dstatement holds2].
  - apply strict_sound2; auto.
  - intros [k n] Ht. destruct (weakly_sound2 H k n Ht) as [CC W]. eexists. eexists. split; [exact CC|exact W].
Qed.
End Tiling.

(** Statements about single triangles. *)
Lemma each_sound2 st : check_statement2 A aadd asub amul aofZ alt ale c st = true ->
  match st with CDelaunay _ | CWeaklyDelaunay _ => True | _ => holds2 l1 l2 r N T2 (dstatement A phi st) end.
Proof.
  intros H. destruct st as [| |rel sg p q|rel sg p q|rel p q|n p q part| | | |]; auto; cbn [check_statement2 dstatement holds2] in *; cbv zeta in H; change (c_gram A (lift c)) with (c_gram A c3) in H.
  - exact (each_angle2 _ (fun x => x < PI / 2) (acute_sound A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c3 base3 L1 L2 L3 lift_gram) H).
  - exact (each_angle2 _ (fun x => x <= PI / 2) (nonobtuse_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z ale_ok c3 base3 L1 L2 L3 lift_gram) H).
  - apply andb_true_iff in H as [B H]. apply largest_sound2; auto.
  - apply andb_true_iff in H as [B H]. apply smallest_sound2; auto.
  - apply andb_true_iff in H as [B H]. apply andb_true_iff in B as [B _]. apply Z.ltb_lt, IZR_lt in B. apply radius_sound2; auto.
  - destruct n as [[c1 c2] ?]. cbv beta iota in H |- *. apply andb_true_iff in H as [B H]. apply Z.ltb_lt, IZR_lt in B. apply (uncrossed_sound2 part); auto.
  - apply not_delaunay_sound2, H.
  - discriminate.
Qed.
End Basis.
End Sound.

(** ** The theorem *)
Lemma checked_based2 c : check_tiling2 A aadd asub amul aofZ alt ale c = true -> based2 c /\ check_tiling A aadd asub amul aofZ alt ale (PlaneChecker.lift A aadd asub amul aofZ ale c) = true.
Proof.
  intros H. unfold check_tiling2 in H. rewrite !andb_true_iff in H. destruct H as [[H1 H2] H3].
  rewrite forallb_forall in H2. split; auto. split; [apply Nat.leb_le; auto|]. split; auto. apply tiling_based with (ale := ale); auto.
Qed.
Lemma gram2_exists c : based2 c -> exists l1 l2, has_gram2 (dgram2 c) l1 l2.
Proof.
  intros [_ [_ B]]. pose proof (cgram A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok _ B) as [G1 [G2 _]].
  unfold lift in G1, G2. unfold dgram2. destruct (e_gram A c) as [[x y] z]. cbn [c_gram k11 k22 k33 k12 k13 k23] in *.
  unfold phiG in G1, G2; cbn [g11 g22 g33 g12 g13 g23 k11 k22 k12 k33 k13 k23] in G1, G2.
  set (a := sqrt (phi x)). assert (Pa : 0 < a) by (apply sqrt_lt_R0; auto).
  assert (Ea : a * a = phi x) by (apply sqrt_sqrt, Rlt_le; auto).
  set (b := phi z / a). set (m := phi y - b * b).
  assert (Eb : a * b = phi z) by (unfold b; field; lra).
  assert (M : (a * a) * m = phi x * phi y - phi z * phi z).
  { unfold m. replace (a * a * (phi y - b * b)) with (a * a * phi y - (a * b) * (a * b)) by ring. rewrite Eb, Ea. ring. }
  assert (Pm : 0 < m).
  { rewrite <- M in G2. assert (0 < a * a) by (apply Rmult_lt_0_compat; auto). nra. }
  exists (Point2 a 0), (Point2 b (sqrt m)). unfold has_gram2, dot2; cbn [x2 y2 h11 h22 h12].
  pose proof (sqrt_sqrt m ltac:(lra)) as Sm. unfold m in Sm at 3. repeat split; lra.
Qed.
Theorem check2_sound c ss : check2 A aadd asub amul aofZ alt ale c ss = true ->
  (exists l1 l2, has_gram2 (dgram2 c) l1 l2) /\
  forall l1 l2, has_gram2 (dgram2 c) l1 l2 ->
  edge_to_edge_tiling l1 l2 (e_rank A c) (ddomain2 c l1 l2) (length (e_tris A c)) (dtriangle c l1 l2) /\
  forall s, In s (map (dstatement A phi) ss) -> holds2 l1 l2 (e_rank A c) (length (e_tris A c)) (dtriangle c l1 l2) s.
Proof.
  intros H. unfold check2 in H. apply andb_true_iff in H as [H1 H2]. rewrite forallb_forall in H2.
  destruct (checked_based2 c H1) as [B H3]. split; [apply gram2_exists, B|]. destruct B as [B1 [B2 B3]].
  intros l1 l2 HG. split; [apply plane_sound; auto|]. intros s Hs. apply in_map_iff in Hs as [st [<- Hs]]. specialize (H2 st Hs).
  pose proof (each_sound2 c B1 B2 B3 l1 l2 HG st H2) as E. pose proof (delaunay_sound2 c B1 B2 B3 l1 l2 HG H3 st H2) as D. destruct st; auto.
Qed.
End Ring.
