(** * Lattices of every rank, domains as intersections of half-spaces

    The open domain { x : level H x > 0 for all H } is open and convex, and the
    closed one is its closure.  The lattice of rank r leaves it alone when the
    normals vanish on the first r coordinates. *)
Require Import Reals Lra ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree.
Import ListNotations.
Open Scope R_scope.

(** [in_lattice] as a boolean. *)
Definition latb (r : nat) (n : Z3) : bool :=
  let '(x, y, z) := n in
  match r with
  | 0 => Z.eqb x 0 && Z.eqb y 0 && Z.eqb z 0 | 1 => Z.eqb y 0 && Z.eqb z 0 | 2 => Z.eqb z 0 | _ => true
  end%nat.
Lemma latb_iff r n : latb r n = true <-> in_lattice r n.
Proof.
  destruct n as [[x y] z]. destruct r as [|[|[|r]]]; simpl; rewrite ?andb_true_iff, ?Z.eqb_eq; intuition.
Qed.
Lemma latb_zero r : latb r z30 = true.
Proof. destruct r as [|[|[|r]]]; reflexivity. Qed.
Lemma latb_add r a b : latb r a = true -> latb r b = true -> latb r (zadd3 a b) = true.
Proof.
  rewrite !latb_iff. destruct a as [[? ?] ?], b as [[? ?] ?].
  destruct r as [|[|[|r]]]; simpl; intuition (subst; auto).
Qed.

(** Half-spaces in basis coordinates: { x : n . x + d >= 0 }; a finite intersection of
    them.  The last theorems of Soundness.v show that it is the domain of Statement.v. *)
Record half_space := HalfSpace { normal : point; offset : R }.
Definition level (H : half_space) (x : point) := dot (normal H) x + offset H.
Definition half_spaces (l1 l2 l3 : point) (Hs : list half_space) (X : point) :=
  exists x, X = at_coordinates l1 l2 l3 x /\ forall H, In H Hs -> 0 <= level H x.

(** The open domain. *)
Definition open_domain (Hs : list half_space) (x : point) := forall H, In H Hs -> 0 < level H x.

Lemma aff_level H : affine (level H).
Proof. exists (px (normal H)), (py (normal H)), (pz (normal H)), (offset H). intros x. unfold level, dot. ring. Qed.
Lemma level_lerp H p q s : level H (lerp p q s) = level H p + s * (level H q - level H p).
Proof. apply aff_lerp, aff_level. Qed.
Lemma open_domain_open Hs : open (open_domain Hs).
Proof. unfold open_domain. apply opn_all. intros H _. apply aff_pos_opn, aff_level. Qed.
Lemma open_domain_convex Hs p q s : open_domain Hs p -> open_domain Hs q -> 0 <= s <= 1 -> open_domain Hs (lerp p q s).
Proof. intros Hp Hq S H HI. rewrite level_lerp. specialize (Hp H HI). specialize (Hq H HI). nra. Qed.
Lemma domain_closure Hs x z : (forall H, In H Hs -> 0 <= level H x) -> open_domain Hs z ->
  forall e, 0 < e -> exists y, near e x y /\ open_domain Hs y.
Proof.
  intros Hx Hz e He. destruct (lerp_near e x z He) as [s [S Ns]]. exists (lerp x z s). split; auto.
  intros H HI. rewrite level_lerp. specialize (Hx H HI). specialize (Hz H HI). nra.
Qed.

(** An affine function is the interpolation of its values at the vertices. *)
Lemma interpolate t f x : affine f ->
  vol t * f x = coord t 0 x * f (va t) + coord t 1 x * f (vb t) + coord t 2 x * f (vc t) + coord t 3 x * f (vd t).
Proof.
  intros [a [b [c [d H]]]]. rewrite !H. pose proof (L_sum t x) as S. pose proof (L_bary t x) as B.
  pose proof (f_equal px B) as Bx. pose proof (f_equal py B) as By. pose proof (f_equal pz B) as Bz.
  unfold scale, add in Bx, By, Bz; cbn [px py pz] in *.
  replace (vol t * (a * px x + b * py x + c * pz x + d))
    with (a * (vol t * px x) + b * (vol t * py x) + c * (vol t * pz x) + vol t * d) by ring.
  rewrite Bx, By, Bz, <- S. ring.
Qed.

(** Tetrahedra whose vertices lie in the domain. *)
Lemma level_closed H t x : 0 < vol t -> (forall v, In v (verts t) -> 0 <= level H v) -> closed t x -> 0 <= level H x.
Proof.
  intros V HV C. pose proof (interpolate t (level H) x (aff_level H)) as E.
  pose proof (HV (va t) ltac:(simpl; auto)). pose proof (HV (vb t) ltac:(simpl; auto)).
  pose proof (HV (vc t) ltac:(simpl; auto)). pose proof (HV (vd t) ltac:(simpl; auto)).
  pose proof (C 0%nat ltac:(simpl; auto)). pose proof (C 1%nat ltac:(simpl; auto)).
  pose proof (C 2%nat ltac:(simpl; auto)). pose proof (C 3%nat ltac:(simpl; auto)).
  assert (0 <= vol t * level H x).
  { rewrite E. repeat apply Rplus_le_le_0_compat; apply Rmult_le_pos; auto. }
  nra.
Qed.
Lemma level_inside H t x : 0 < vol t -> (forall v, In v (verts t) -> 0 <= level H v) ->
  (exists v, In v (verts t) /\ 0 < level H v) -> inside t x -> 0 < level H x.
Proof.
  intros V HV [v [Iv Pv]] C. pose proof (interpolate t (level H) x (aff_level H)) as E.
  pose proof (HV (va t) ltac:(simpl; auto)) as V0. pose proof (HV (vb t) ltac:(simpl; auto)) as V1.
  pose proof (HV (vc t) ltac:(simpl; auto)) as V2. pose proof (HV (vd t) ltac:(simpl; auto)) as V3.
  pose proof (C 0%nat ltac:(simpl; auto)) as C0. pose proof (C 1%nat ltac:(simpl; auto)) as C1.
  pose proof (C 2%nat ltac:(simpl; auto)) as C2. pose proof (C 3%nat ltac:(simpl; auto)) as C3.
  assert (K0 : 0 <= coord t 0 x * level H (va t)) by (apply Rmult_le_pos; lra).
  assert (K1 : 0 <= coord t 1 x * level H (vb t)) by (apply Rmult_le_pos; lra).
  assert (K2 : 0 <= coord t 2 x * level H (vc t)) by (apply Rmult_le_pos; lra).
  assert (K3 : 0 <= coord t 3 x * level H (vd t)) by (apply Rmult_le_pos; lra).
  assert (0 < vol t * level H x); [|nra]. rewrite E.
  destruct Iv as [<-|[<-|[<-|[<-|[]]]]].
  - assert (0 < coord t 0 x * level H (va t)) by (apply Rmult_lt_0_compat; auto). lra.
  - assert (0 < coord t 1 x * level H (vb t)) by (apply Rmult_lt_0_compat; auto). lra.
  - assert (0 < coord t 2 x * level H (vc t)) by (apply Rmult_lt_0_compat; auto). lra.
  - assert (0 < coord t 3 x * level H (vd t)) by (apply Rmult_lt_0_compat; auto). lra.
Qed.
(** Tetrahedra on both sides of a plane have no common inner point. *)
Lemma apart_affine f p q x : affine f -> (exists z, f z <> 0) -> 0 < vol p -> 0 < vol q ->
  (forall v, In v (verts p) -> 0 <= f v) -> (forall v, In v (verts q) -> f v <= 0) ->
  inside p x -> inside q x -> False.
Proof.
  intros AF [z Hz] Vp Vq P Q Ip Iq.
  pose proof (interpolate p f x AF) as Ep. pose proof (interpolate q f x AF) as Eq. pose proof (interpolate p f z AF) as Ez.
  pose proof (Ip 0%nat ltac:(simpl; auto)) as I0. pose proof (Ip 1%nat ltac:(simpl; auto)) as I1.
  pose proof (Ip 2%nat ltac:(simpl; auto)) as I2. pose proof (Ip 3%nat ltac:(simpl; auto)) as I3.
  pose proof (Iq 0%nat ltac:(simpl; auto)) as J0. pose proof (Iq 1%nat ltac:(simpl; auto)) as J1.
  pose proof (Iq 2%nat ltac:(simpl; auto)) as J2. pose proof (Iq 3%nat ltac:(simpl; auto)) as J3.
  pose proof (P (va p) ltac:(simpl; auto)) as P0. pose proof (P (vb p) ltac:(simpl; auto)) as P1.
  pose proof (P (vc p) ltac:(simpl; auto)) as P2. pose proof (P (vd p) ltac:(simpl; auto)) as P3.
  pose proof (Q (va q) ltac:(simpl; auto)) as Q0. pose proof (Q (vb q) ltac:(simpl; auto)) as Q1.
  pose proof (Q (vc q) ltac:(simpl; auto)) as Q2. pose proof (Q (vd q) ltac:(simpl; auto)) as Q3.
  assert (M : forall a b, 0 < a -> 0 <= b -> 0 <= a * b) by (intros; apply Rmult_le_pos; lra).
  assert (L : f x <= 0).
  { pose proof (M _ (- f (va q)) J0 ltac:(lra)). pose proof (M _ (- f (vb q)) J1 ltac:(lra)).
    pose proof (M _ (- f (vc q)) J2 ltac:(lra)). pose proof (M _ (- f (vd q)) J3 ltac:(lra)).
    apply Rnot_lt_le. intros K. assert (0 < vol q * f x) by (apply Rmult_lt_0_compat; auto). lra. }
  pose proof (M _ _ I0 P0) as M0. pose proof (M _ _ I1 P1) as M1. pose proof (M _ _ I2 P2) as M2. pose proof (M _ _ I3 P3) as M3.
  pose proof (M (vol p) (- f x) Vp ltac:(lra)) as MX.
  assert (Z : forall a b, 0 < a -> a * b = 0 -> b = 0) by (intros a b Ha E; apply Rmult_integral in E; destruct E; lra).
  rewrite (Z _ (f (va p)) I0 ltac:(lra)), (Z _ (f (vb p)) I1 ltac:(lra)), (Z _ (f (vc p)) I2 ltac:(lra)), (Z _ (f (vd p)) I3 ltac:(lra)) in Ez.
  apply Hz, (Z (vol p)); auto. rewrite Ez. ring.
Qed.
(** A facet in the boundary plane: the vertex opposite to it and the whole open
    domain lie on the same side. *)
Lemma level_boundary H t i y : In i I4 -> 0 < vol t -> 0 <= level H (vx t i) ->
  (forall j, In j I4 -> j <> i -> level H (vx t j) = 0) -> 0 < level H y -> 0 < coord t i y.
Proof.
  intros Hi V Pi Z Py. pose proof (interpolate t (level H) y (aff_level H)) as E.
  assert (Q : vol t * level H y = coord t i y * level H (vx t i)).
  { rewrite E. simpl in Hi. destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; cbn [vx] in *.
    - pose proof (Z 1%nat ltac:(simpl; auto) ltac:(lia)) as Z1. pose proof (Z 2%nat ltac:(simpl; auto) ltac:(lia)) as Z2. pose proof (Z 3%nat ltac:(simpl; auto) ltac:(lia)) as Z3.
      cbn [vx] in *. rewrite Z1, Z2, Z3. ring.
    - pose proof (Z 0%nat ltac:(simpl; auto) ltac:(lia)) as Z1. pose proof (Z 2%nat ltac:(simpl; auto) ltac:(lia)) as Z2. pose proof (Z 3%nat ltac:(simpl; auto) ltac:(lia)) as Z3.
      cbn [vx] in *. rewrite Z1, Z2, Z3. ring.
    - pose proof (Z 0%nat ltac:(simpl; auto) ltac:(lia)) as Z1. pose proof (Z 1%nat ltac:(simpl; auto) ltac:(lia)) as Z2. pose proof (Z 3%nat ltac:(simpl; auto) ltac:(lia)) as Z3.
      cbn [vx] in *. rewrite Z1, Z2, Z3. ring.
    - pose proof (Z 0%nat ltac:(simpl; auto) ltac:(lia)) as Z1. pose proof (Z 1%nat ltac:(simpl; auto) ltac:(lia)) as Z2. pose proof (Z 2%nat ltac:(simpl; auto) ltac:(lia)) as Z3.
      cbn [vx] in *. rewrite Z1, Z2, Z3. ring. }
  assert (0 < vol t * level H y) by (apply Rmult_lt_0_compat; auto). nra.
Qed.

(** Invariance under the lattice of rank r. *)
Definition invariant (r : nat) (H : half_space) :=
  ((1 <= r)%nat -> px (normal H) = 0) /\ ((2 <= r)%nat -> py (normal H) = 0) /\ ((3 <= r)%nat -> pz (normal H) = 0).
Lemma level_shift r H h n x : invariant r H -> in_lattice r n -> level H (add x (vec h n)) = level H x.
Proof.
  destruct n as [[n1 n2] n3]. intros [I1 [I2 I3]] L. unfold level, dot, vec, add; cbn [px py pz].
  destruct r as [|[|[|r]]]; cbn in L.
  - destruct L as [-> [-> ->]]. ring.
  - destruct L as [-> ->]. rewrite I1 by lia. ring.
  - rewrite L, I1, I2 by lia. ring.
  - rewrite I1, I2, I3 by lia. ring.
Qed.

(** ** The domain of the claim: a convex hull, times the span of the lattice *)

(** x and w have the same last 3 - r coordinates. *)
Definition agree (r : nat) (x w : point) : Prop :=
  match r with 0 => x = w | 1 => py x = py w /\ pz x = pz w | 2 => pz x = pz w | _ => True end%nat.
Definition over_hull (r : nat) (W : list point) (x : point) := (3 <= r)%nat \/ exists w, convex_hull W w /\ agree r x w.
Lemma over_hull_domain r W x : over_hull r W x <->
  match r with
  | 0 => exists w, convex_hull W w /\ x = w
  | 1 => exists w, convex_hull W w /\ py x = py w /\ pz x = pz w
  | 2 => exists w, convex_hull W w /\ pz x = pz w
  | _ => True
  end%nat.
Proof. unfold over_hull. destruct r as [|[|[|r]]]; cbn [agree]; intuition lia. Qed.

Lemma agree_segment r x y w v s : agree r x w -> agree r y v ->
  agree r (add (scale (1 - s) x) (scale s y)) (add (scale (1 - s) w) (scale s v)).
Proof.
  destruct r as [|[|[|r]]]; cbn; auto; unf.
  - intros -> ->. reflexivity.
  - intros [-> ->] [-> ->]. auto.
  - intros -> ->. auto.
Qed.
Lemma over_hull_convex r W x y s : over_hull r W x -> over_hull r W y -> 0 <= s <= 1 ->
  over_hull r W (add (scale (1 - s) x) (scale s y)).
Proof.
  intros [L|[w [Hw Aw]]] [L'|[v [Hv Av]]] S; try (left; assumption).
  right. exists (add (scale (1 - s) w) (scale s v)). split; [apply hull_segment; auto|]. apply agree_segment; auto.
Qed.
Lemma agree_trans r x y w : agree r x y -> agree r y w -> agree r x w.
Proof. destruct r as [|[|[|r]]]; cbn; intuition congruence. Qed.
Lemma over_hull_agree r W x y : agree r x y -> over_hull r W y -> over_hull r W x.
Proof. intros A [L|[w [Hw Aw]]]; [left; auto|]. right. exists w. split; auto. eapply agree_trans; eauto. Qed.
Lemma agree_shift r h n x : in_lattice r n -> agree r (add x (vec h n)) x.
Proof.
  destruct n as [[a b] c]. destruct r as [|[|[|r]]]; cbn; auto; unf.
  - intros [-> [-> ->]]. apply point_eq; cbn; ring.
  - intros [-> ->]. split; ring.
  - intros ->. ring.
Qed.
Lemma agree_shift' r h n x : in_lattice r n -> agree r x (add x (vec h n)).
Proof.
  intros L. pose proof (agree_shift r h n x L) as A. destruct r as [|[|[|r]]]; cbn [agree] in *; intuition congruence.
Qed.

(** A convex set holds the combinations of four of its points. *)
Lemma convex_combination (Q : point -> Prop) t a b c d :
  (forall x y s, Q x -> Q y -> 0 <= s <= 1 -> Q (add (scale (1 - s) x) (scale s y))) ->
  (forall v, In v (verts t) -> Q v) ->
  0 <= a -> 0 <= b -> 0 <= c -> 0 <= d -> a + b + c + d = 1 -> Q (combination t a b c d).
Proof.
  intros CV V A B C D S.
  (* p is m times a point of Q *)
  set (P := fun (m : R) (p : point) => 0 <= m /\ (m = 0 /\ p = Point 0 0 0 \/ 0 < m /\ exists q, Q q /\ p = scale m q)).
  assert (P1 : forall m v, 0 <= m -> Q v -> P m (scale m v)).
  { intros m v Hm Hv. split; auto. destruct (Req_dec m 0) as [->|N].
    - left. split; auto. apply point_eq; unf; ring.
    - right. split; [lra|]. eauto. }
  assert (P2 : forall m n p q, P m p -> P n q -> P (m + n) (add p q)).
  { intros m n p q [Hm [[M0 Ep]|[M1 [x [Qx Ep]]]]] [Hn [[N0 Eq]|[N1 [y [Qy Eq]]]]]; split; try lra; subst.
    - left. split; [lra|]. apply point_eq; unf; ring.
    - right. split; [lra|]. exists y. split; auto. apply point_eq; unf; ring.
    - right. split; [lra|]. exists x. split; auto. apply point_eq; unf; ring.
    - right. split; [lra|]. eexists. split; [apply (CV x y (n / (m + n))); auto|].
      + split; [apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]|].
        apply Rmult_le_reg_r with (m + n); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
      + apply point_eq; unf; field; lra. }
  assert (F : P (a + b + (c + d)) (combination t a b c d)).
  { unfold combination. apply P2; apply P2; apply P1; auto; apply V; simpl; auto. }
  destruct F as [_ [[Z _]|[_ [q [Qq E]]]]]; [lra|].
  rewrite E. replace (a + b + (c + d)) with 1 by lra. replace (scale 1 q) with q; auto.
  apply point_eq; unf; ring.
Qed.

(** A half-space that is invariant and holds all points of W holds the domain. *)
Lemma level_agree r H x w : invariant r H -> agree r x w -> level H x = level H w.
Proof.
  intros [I1 [I2 I3]] A. unfold level, dot. destruct r as [|[|[|r]]]; cbn in A.
  - subst. reflexivity.
  - destruct A as [-> ->]. rewrite I1 by lia. ring.
  - rewrite A, I1, I2 by lia. ring.
  - rewrite I1, I2, I3 by lia. ring.
Qed.
Lemma level_over_hull r H W x : (r <= 2)%nat -> invariant r H -> (forall w, In w W -> 0 <= level H w) -> over_hull r W x -> 0 <= level H x.
Proof.
  intros R I HW [L|[w [Hw A]]]; [lia|]. rewrite (level_agree r H x w I A). clear A x.
  induction Hw as [v Hv|x y s _ IHx _ IHy S]; auto.
  replace (level H (add (scale (1 - s) x) (scale s y))) with ((1 - s) * level H x + s * level H y).
  - assert (0 <= (1 - s) * level H x) by (apply Rmult_le_pos; lra). assert (0 <= s * level H y) by (apply Rmult_le_pos; lra). lra.
  - unfold level, dot. unf. ring.
Qed.
Lemma convex_hull_scale W k x : convex_hull W x -> convex_hull (map (scale k) W) (scale k x).
Proof.
  intros H. induction H as [v Hv|x y s _ IHx _ IHy S].
  - apply hull_vertex, in_map, Hv.
  - replace (scale k (add (scale (1 - s) x) (scale s y))) with (add (scale (1 - s) (scale k x)) (scale s (scale k y))) by (apply point_eq; unf; ring).
    apply hull_segment; auto.
Qed.
Lemma over_hull_scale r W k x : over_hull r W x -> over_hull r (map (scale k) W) (scale k x).
Proof.
  intros [L|[w [Hw A]]]; [left; auto|]. right. exists (scale k w). split; [apply convex_hull_scale; auto|].
  destruct r as [|[|[|r]]]; cbn [agree] in *; auto; unf; intuition congruence.
Qed.
