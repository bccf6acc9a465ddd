(** * Systems of patches: from numbers to space

    What the Boolean tests of PatchChecker.v say about spots that are put into space. *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Angles Euclid PatchStatement PatchChecker.
Import ListNotations.
Open Scope R_scope.

(** ** Numbers *)
Lemma root3 : sqrt 3 * sqrt 3 = 3.
Proof. apply sqrt_sqrt. lra. Qed.
Lemma root3_pos : 0 < sqrt 3.
Proof. apply sqrt_lt_R0. lra. Qed.
Lemma surd_add x y : surd (zadd x y) = surd x + surd y.
Proof. unfold surd, zadd; cbn [fst snd]. rewrite !plus_IZR. ring. Qed.
Lemma surd_sub x y : surd (zsub x y) = surd x - surd y.
Proof. unfold surd, zsub; cbn [fst snd]. rewrite !minus_IZR. ring. Qed.
Lemma surd_mul x y : surd (zmul x y) = surd x * surd y.
Proof.
  unfold surd, zmul; cbn [fst snd]. rewrite !plus_IZR, !mult_IZR.
  replace (IZR (fst x) * IZR (fst y) + 3 * (IZR (snd x) * IZR (snd y))) with (IZR (fst x) * IZR (fst y) + (sqrt 3 * sqrt 3) * (IZR (snd x) * IZR (snd y))) by (rewrite root3; ring).
  ring.
Qed.
Lemma surd_int n : surd (zint n) = IZR n.
Proof. unfold surd, zint; cbn [fst snd]. ring. Qed.
Lemma zpos_ok x : zpos x = true -> 0 < surd x.
Proof.
  destruct x as [a b]. unfold zpos, surd; cbn [fst snd]. pose proof root3_pos as P. pose proof root3 as Q. set (r := sqrt 3) in *. clearbody r.
  rewrite !orb_true_iff, !andb_true_iff, !Z.ltb_lt, !Z.leb_le.
  intros [[[[A B]|[A B]]|[A B]]|[A B]]; apply IZR_lt in B || apply IZR_le in B; apply IZR_lt in A || apply IZR_le in A; rewrite ?mult_IZR in *; set (u := IZR a) in *; set (v := IZR b) in *; clearbody u v.
  - nra.
  - nra.
  - assert ((v * r) * (v * r) < u * u) by (replace (v * r * (v * r)) with (r * r * (v * v)) by ring; rewrite Q; lra). nra.
  - assert (u * u < (v * r) * (v * r)) by (replace (v * r * (v * r)) with (r * r * (v * v)) by ring; rewrite Q; lra).
    assert (0 < v * r) by (apply Rmult_lt_0_compat; auto). nra.
Qed.
Lemma zeq_ok x y : zeq x y = true -> x = y.
Proof. destruct x, y. unfold zeq; cbn [fst snd]. rewrite andb_true_iff, !Z.eqb_eq. intros [-> ->]; reflexivity. Qed.
Lemma znonneg_ok x : znonneg x = true -> 0 <= surd x.
Proof. unfold znonneg. rewrite orb_true_iff. intros [H|H]; [apply zeq_ok in H; subst; rewrite surd_int; lra|apply zpos_ok in H; lra]. Qed.
Lemma spot_eq_ok x y : spot_eq x y = true -> x = y.
Proof. destruct x, y. unfold spot_eq; cbn. rewrite !andb_true_iff. intros [[A B] C]. apply zeq_ok in A, B, C. subst; auto. Qed.
Lemma spots_eq_ok f g : spots_eq f g = true -> f = g.
Proof. destruct f as [[? ?] ?], g as [[? ?] ?]. cbn. rewrite !andb_true_iff. intros [[A B] C]. apply spot_eq_ok in A, B, C. subst; auto. Qed.
Ltac surds := repeat first [rewrite surd_add | rewrite surd_sub | rewrite surd_mul | rewrite surd_int].

(** ** Spots *)
Definition val (x : spot) : point := Point (surd (height x)) (surd (ahead x)) (surd (aside x)).
Lemma val_sub x y : val (spot_sub x y) = sub (val x) (val y).
Proof. unfold val, spot_sub, sub; cbn. rewrite !surd_sub. reflexivity. Qed.
Lemma surd_dot u v : surd (spot_dot u v) = dot (val u) (val v).
Proof. unfold spot_dot, dot, val; cbn. surds. ring. Qed.
Lemma surd_det u v w : surd (spot_det u v w) = det (val u) (val v) (val w).
Proof. unfold spot_det, det, val; cbn. surds. ring. Qed.
Lemma surd_orient a b c d : surd (spot_orient a b c d) = orient (val a) (val b) (val c) (val d).
Proof. unfold spot_orient, orient. rewrite surd_det, !val_sub. reflexivity. Qed.
Definition val_tet (t : corners) : tetrahedron := let '(a, b, c, d) := t in Tetrahedron (val a) (val b) (val c) (val d).

Section Put.
Variables (c H : R) (o d : R * R).
Hypothesis c_pos : 0 < c.
Hypothesis unit : fst d * fst d + snd d * snd d = 1.
Notation put x := (put c H o d x).
Definition put_tet (t : corners) : tetrahedron := let '(a, b, e, f) := t in Tetrahedron (put a) (put b) (put e) (put f).
Definition put_tri (f : spots) : triangle := let '(a, b, e) := f in Triangle (put a) (put b) (put e).

Lemma put_orient x y z w : orient (put x) (put y) (put z) (put w) = c * c * c * orient (val x) (val y) (val z) (val w).
Proof.
  transitivity (c * c * c * (fst d * fst d + snd d * snd d) * orient (val x) (val y) (val z) (val w)).
  - unfold PatchStatement.put, val. unf. ring.
  - rewrite unit. ring.
Qed.
Lemma put_dot x y z w : dot (sub (put x) (put y)) (sub (put z) (put w)) = c * c * dot (sub (val x) (val y)) (sub (val z) (val w)).
Proof.
  transitivity (c * c * ((surd (height x) - surd (height y)) * (surd (height z) - surd (height w)) +
    (fst d * fst d + snd d * snd d) * ((surd (ahead x) - surd (ahead y)) * (surd (ahead z) - surd (ahead w)) + (surd (aside x) - surd (aside y)) * (surd (aside z) - surd (aside w))))).
  - unfold PatchStatement.put, dot. unf. ring.
  - rewrite unit. unfold val, dot. unf. ring.
Qed.
Lemma c3 : 0 < c * c * c.
Proof. repeat apply Rmult_lt_0_compat; auto. Qed.
Lemma put_facet t i : facet (put_tet t) i = put_tri (spot_facet t i).
Proof. destruct t as [[[? ?] ?] ?], i as [|[|[|i]]]; reflexivity. Qed.
Lemma put_side f x : side (put_tri f) (put x) = c * c * c * surd (on_side f x).
Proof. destruct f as [[p q] r]. unfold side, put_tri, on_side; cbn [t1 t2 t3]. rewrite put_orient, surd_orient. reflexivity. Qed.
Lemma put_coord t i x : coord (put_tet t) i (put x) = c * c * c * surd (on_side (spot_facet t i) x).
Proof. unfold coord. rewrite put_facet, put_side. reflexivity. Qed.

Lemma put_inside t x : spot_inside t x = true -> inside (put_tet t) (put x).
Proof.
  unfold spot_inside. rewrite forallb_forall. intros K i Hi. rewrite put_coord. apply Rmult_lt_0_compat; [apply c3|].
  apply zpos_ok, K, Hi.
Qed.
Lemma put_outside t x : spot_outside t x = true -> ~ closed (put_tet t) (put x).
Proof.
  unfold spot_outside. rewrite existsb_exists. intros [i [Hi K]] C. specialize (C i Hi). rewrite put_coord in C.
  apply zpos_ok in K. rewrite surd_sub, surd_int in K. pose proof c3. nra.
Qed.

Lemma put_vol t : good_corners t = true -> 0 < vol (put_tet t).
Proof.
  destruct t as [[[x y] z] w]. unfold good_corners. rewrite !andb_true_iff. intros [[[[[[K _] _] _] _] _] _].
  apply zpos_ok in K. rewrite surd_orient in K.
  change (0 < orient (put x) (put y) (put z) (put w)). rewrite put_orient. apply Rmult_lt_0_compat; auto. apply c3.
Qed.
Lemma put_acute_at x y z w : orient (put x) (put y) (put z) (put w) <> 0 -> spot_acute_at x y z w = true ->
  dihedral (put x) (put y) (put z) (put w) < PI / 2.
Proof.
  intros O K. apply acute_rule; auto. apply zpos_ok in K. unfold spot_acute_at in K.
  rewrite surd_sub, !surd_mul, !surd_dot, !val_sub in K. unfold acpoly. rewrite !put_dot.
  match goal with |- 0 < ?g => replace g with (c * c * (c * c) * (dot (sub (val z) (val x)) (sub (val w) (val x)) * dot (sub (val y) (val x)) (sub (val y) (val x)) - dot (sub (val z) (val x)) (sub (val y) (val x)) * dot (sub (val w) (val x)) (sub (val y) (val x)))) by ring end.
  apply Rmult_lt_0_compat; auto. repeat apply Rmult_lt_0_compat; auto.
Qed.
Lemma put_acute t x : good_corners t = true -> In x (dihedrals (put_tet t)) -> x < PI / 2.
Proof.
  intros G. pose proof (put_vol t G) as V. destruct t as [[[p q] r] s]. unfold good_corners in G. rewrite !andb_true_iff in G.
  destruct G as [[[[[[_ A] B] C] D] E] F]. change (0 < orient (put p) (put q) (put r) (put s)) in V.
  assert (P : forall a b e f, orient (put a) (put b) (put e) (put f) = orient (put p) (put q) (put r) (put s) \/ orient (put a) (put b) (put e) (put f) = - orient (put p) (put q) (put r) (put s) ->
    spot_acute_at a b e f = true -> dihedral (put a) (put b) (put e) (put f) < PI / 2).
  { intros a b e f O K. apply put_acute_at; auto. lra. }
  unfold dihedrals; cbn [put_tet va vb vc vd In].
  intros [<-|[<-|[<-|[<-|[<-|[<-|[]]]]]]]; apply P; auto; clear; unf; [right|left|left|right|left]; ring.
Qed.

Lemma put_opposite f g : spots_opposite f g = true -> opposite (put_tri f) (put_tri g).
Proof.
  destruct g as [[p q] r]. unfold spots_opposite. rewrite !orb_true_iff.
  intros [[K|K]|K]; apply spots_eq_ok in K; subst f; unfold opposite, put_tri; cbn [t1 t2 t3]; auto.
Qed.
End Put.

Lemma put_raise c H o d x z : add (put c H o d x) (Point z 0 0) = put c (H + z) o d x.
Proof. apply point_eq; unfold put, add; cbn; ring. Qed.
Lemma put_lift c H o d x n : put c H o d (lift n x) = put c (H + c * IZR n) o d x.
Proof. apply point_eq; unfold put, lift; cbn; rewrite ?surd_add, ?surd_int; ring. Qed.
Lemma put_tri_lift c H o d f n : put_tri c H o d (lift_all n f) = put_tri c (H + c * IZR n) o d f.
Proof. destruct f as [[? ?] ?]. unfold put_tri, lift_all. rewrite !put_lift. reflexivity. Qed.
Lemma put_turn c H o d x : c = / 576 ->
  put c H (fst o + fst d, snd o + snd d) (- fst d, - snd d) x = put c H o d (turn x).
Proof. intros ->. apply point_eq; unfold put, turn; cbn; rewrite ?surd_sub, ?surd_int; field. Qed.

(** Points of a tetrahedron as combinations. *)
Lemma closed_between t y (f : point -> R) : 0 < vol t -> closed t y -> affine f ->
  (forall v, In v (verts t) -> 0 <= f v) -> 0 <= f y.
Proof.
  intros V C [k1 [k2 [k3 [k0 F]]]] P. apply hull_closed in C; auto. destruct C as [a [b [c [d [A [B [C [D [S ->]]]]]]]]].
  pose proof (P (va t) ltac:(simpl; auto)) as Pa. pose proof (P (vb t) ltac:(simpl; auto)) as Pb.
  pose proof (P (vc t) ltac:(simpl; auto)) as Pc. pose proof (P (vd t) ltac:(simpl; auto)) as Pd.
  replace (f (combination t a b c d)) with (a * f (va t) + b * f (vb t) + c * f (vc t) + d * f (vd t)).
  { repeat apply Rplus_le_le_0_compat; apply Rmult_le_pos; auto. }
  rewrite !F. unfold combination. unf. replace d with (1 - a - b - c) by lra. ring.
Qed.
Lemma closed_heights t y b B : 0 < vol t -> closed t y -> (forall v, In v (verts t) -> b <= px v <= B) -> b <= px y <= B.
Proof.
  intros V C P. split.
  - cut (0 <= px y - b); [lra|]. apply (closed_between t y (fun y => px y - b)); auto.
    + exists 1, 0, 0, (- b). intros; ring.
    + intros v Hv. specialize (P v Hv). lra.
  - cut (0 <= B - px y); [lra|]. apply (closed_between t y (fun y => B - px y)); auto.
    + exists (-1), 0, 0, B. intros; ring.
    + intros v Hv. specialize (P v Hv). lra.
Qed.
Lemma put_verts c H o d t v : In v (verts (put_tet c H o d t)) -> exists x, v = put c H o d x /\ In x (let '(p, q, r, s) := t in [p; q; r; s]).
Proof. destruct t as [[[p q] r] s]. cbn. intros [<-|[<-|[<-|[<-|[]]]]]; eexists; (split; [reflexivity|]); auto. Qed.

(** A spot that misses a tetrahedron, and all its copies some periods higher. *)
Lemma small n : (-3 <= n <= 3)%Z -> In n [-3; -2; -1; 0; 1; 2; 3]%Z.
Proof. intros. cbn. lia. Qed.
Lemma far_away u c H o d t x n : (0 < u)%Z -> c = / IZR u -> fst d * fst d + snd d * snd d = 1 -> good_corners t = true ->
  (let '(p, q, r, s) := t in forallb (bounded_height (3 * u) x) [p; q; r; s]) = true -> (n < -3 \/ 3 < n)%Z ->
  ~ closed (put_tet c (H + IZR n) o d t) (put c H o d x).
Proof.
  intros U -> D G B N C. assert (U' : 0 < IZR u) by (apply IZR_lt in U; exact U).
  assert (I : 0 < / IZR u) by (apply Rinv_0_lt_compat; auto).
  pose proof (put_vol (/ IZR u) (H + IZR n) o d I D t G) as V.
  assert (P : forall v, In v (verts (put_tet (/ IZR u) (H + IZR n) o d t)) ->
    H + IZR n + / IZR u * surd (height x) - 3 <= px v <= H + IZR n + / IZR u * surd (height x) + 3).
  { intros v Hv. apply put_verts in Hv as [y [-> Hy]].
    assert (K : bounded_height (3 * u) x y = true).
    { destruct t as [[[p q] r] s]. rewrite forallb_forall in B. apply B, Hy. }
    unfold bounded_height in K. apply andb_true_iff in K as [K1 K2]. apply zpos_ok in K1, K2.
    rewrite !surd_sub, !surd_int, mult_IZR in K1, K2. cbn [put px].
    assert (E : / IZR u * IZR u = 1) by (field; lra).
    assert (X : / IZR u * (surd (height x) - surd (height y)) <= / IZR u * (3 * IZR u)) by (apply Rmult_le_compat_l; lra).
    assert (Y : / IZR u * (surd (height y) - surd (height x)) <= / IZR u * (3 * IZR u)) by (apply Rmult_le_compat_l; lra).
    replace (/ IZR u * (3 * IZR u)) with (3 * (/ IZR u * IZR u)) in X, Y by ring. rewrite E in X, Y. lra. }
  apply (closed_heights _ _ _ _ V C) in P. cbn [put px] in P.
  destruct N as [N|N]; [assert (IZR n <= -4) by (apply IZR_le; lia)|assert (4 <= IZR n) by (apply IZR_le; lia)]; lra.
Qed.
Lemma near_by u c H o d t x n : (0 < u)%Z -> c = / IZR u -> fst d * fst d + snd d * snd d = 1 ->
  spot_outside t (lift (u * - n) x) = true -> ~ closed (put_tet c (H + IZR n) o d t) (put c H o d x).
Proof.
  intros U -> D K C. assert (U' : 0 < IZR u) by (apply IZR_lt in U; exact U).
  assert (I : 0 < / IZR u) by (apply Rinv_0_lt_compat; auto).
  apply (put_outside (/ IZR u) (H + IZR n) o d I D t (lift (u * - n) x) K).
  rewrite put_lift, mult_IZR, opp_IZR. replace (H + IZR n + / IZR u * (IZR u * - IZR n)) with H by (field; lra). exact C.
Qed.
Lemma missed_ok u c H o d t x n : (0 < u)%Z -> c = / IZR u -> fst d * fst d + snd d * snd d = 1 -> good_corners t = true ->
  missed u x t = true -> ~ closed (put_tet c (H + IZR n) o d t) (put c H o d x).
Proof.
  intros U E D G M. unfold missed in M. destruct t as [[[p q] r] s] eqn:T. apply andb_true_iff in M as [M1 M2].
  destruct (Z_lt_le_dec n (-3)); [apply far_away with (u := u); auto|]. destruct (Z_lt_le_dec 3 n); [apply far_away with (u := u); auto|].
  apply near_by with (u := u); auto. rewrite forallb_forall in M2. apply M2, small. lia.
Qed.
