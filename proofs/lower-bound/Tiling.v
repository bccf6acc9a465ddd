(** * docs/lower-bound.md, section 1: tilings of space, and their tetrahedra with ordered vertices

    [space_tiling] is the definition of a locally finite face-to-face tiling of space by tetrahedra, for any set of
    indices: nothing is said about periods or the number of shapes. *)
From Coq Require Import Reals Lra List Classical.
From Acutile Require Import Statement Tetrahedra Topology Euclid.
Import ListNotations.
Open Scope R_scope.

Record space_tiling {index : Type} (is_tile : index -> Prop) (tile : index -> tetrahedron) : Prop := {
  (* no tile is flat *)
  space_solid : forall c, is_tile c -> vol (tile c) <> 0;
  (* only finitely many tiles meet any bounded set *)
  space_locally_finite : forall M, exists F, forall c X, is_tile c -> near M origin X -> hull (tile c) X -> In c F;
  (* the tiles cover space *)
  space_cover : forall X, exists c, is_tile c /\ hull (tile c) X;
  (* an inner point of one tile lies in no other tile *)
  space_disjoint : forall X c c', is_tile c -> is_tile c' -> open_hull (tile c) X -> hull (tile c') X -> c = c';
  (* two tiles meet in the hull of their common vertices: in a common face or not at all *)
  space_face_to_face : forall X c c', is_tile c -> is_tile c' -> hull (tile c) X -> hull (tile c') X -> common_hull (tile c) (tile c') X }.

(** The tile c has the edge uv, and the valence of an edge. *)
Definition has_edge {index : Type} (is_tile : index -> Prop) (tile : index -> tetrahedron) u v c := is_tile c /\ In u (verts (tile c)) /\ In v (verts (tile c)).
Definition edge_valence {index : Type} (is_tile : index -> Prop) (tile : index -> tetrahedron) u v m :=
  exists L, NoDup L /\ length L = m /\ forall c, In c L <-> has_edge is_tile tile u v c.

(** ** The vertices of a tetrahedron in another order *)

Inductive shuffle : tetrahedron -> tetrahedron -> Prop :=
  | shuffle_refl t : shuffle t t
  | shuffle_ab a b c d t : shuffle (Tetrahedron b a c d) t -> shuffle (Tetrahedron a b c d) t
  | shuffle_bc a b c d t : shuffle (Tetrahedron a c b d) t -> shuffle (Tetrahedron a b c d) t
  | shuffle_cd a b c d t : shuffle (Tetrahedron a b d c) t -> shuffle (Tetrahedron a b c d) t.

Lemma shuffle_verts s t : shuffle s t -> forall v, In v (verts s) <-> In v (verts t).
Proof. induction 1; intros v; [reflexivity| | |]; rewrite <- IHshuffle; unfold verts; simpl; tauto. Qed.
Ltac reorder := unfold combination; cbn [va vb vc vd]; apply point_eq; unf; ring.
Lemma shuffle_hull s t X : shuffle s t -> (hull s X <-> hull t X).
Proof.
  induction 1; [reflexivity| | |]; rewrite <- IHshuffle; split; intros [wa [wb [wc [wd [A [B [C [D [S E]]]]]]]]].
  1,2: exists wb, wa, wc, wd. 3,4: exists wa, wc, wb, wd. 5,6: exists wa, wb, wd, wc.
  all: repeat split; try lra; rewrite E; reorder.
Qed.
Lemma shuffle_open s t X : shuffle s t -> (open_hull s X <-> open_hull t X).
Proof.
  induction 1; [reflexivity| | |]; rewrite <- IHshuffle; split; intros [wa [wb [wc [wd [A [B [C [D [S E]]]]]]]]].
  1,2: exists wb, wa, wc, wd. 3,4: exists wa, wc, wb, wd. 5,6: exists wa, wb, wd, wc.
  all: repeat split; try lra; rewrite E; reorder.
Qed.
Lemma shuffle_vol s t : shuffle s t -> vol s = vol t \/ vol s = - vol t.
Proof.
  induction 1 as [|a b c d t _ IH|a b c d t _ IH|a b c d t _ IH]; [left; reflexivity| | |];
  match type of IH with vol ?x = _ \/ _ => match goal with |- vol ?y = _ \/ _ => assert (vol y = - vol x) by (unfold vol; cbn [va vb vc vd]; unf; ring) end end;
  destruct IH; [right|left|right|left|right|left]; lra.
Qed.
Lemma shuffle_common s s' t X : shuffle s s' -> common_hull s' t X -> common_hull s t X.
Proof.
  induction 1; intros H'; [exact H'| | |]; destruct (IHshuffle H') as [wa [wb [wc [wd [A [B [C [D [S [E [VA [VB [VC VD]]]]]]]]]]]]]; cbn [va vb vc vd] in *.
  - exists wb, wa, wc, wd. repeat split; try lra; auto. rewrite E. reorder.
  - exists wa, wc, wb, wd. repeat split; try lra; auto. rewrite E. reorder.
  - exists wa, wb, wd, wc. repeat split; try lra; auto. rewrite E. reorder.
Qed.
Lemma shuffle_first t a : In a (verts t) -> exists b c d, shuffle (Tetrahedron a b c d) t.
Proof.
  destruct t as [w x y z]. intros [<-|[<-|[<-|[<-|[]]]]]; cbn [va vb vc vd].
  - exists x, y, z. apply shuffle_refl.
  - exists w, y, z. apply shuffle_ab, shuffle_refl.
  - exists w, x, z. apply shuffle_ab, shuffle_bc, shuffle_refl.
  - exists w, x, y. apply shuffle_ab, shuffle_bc, shuffle_cd, shuffle_refl.
Qed.
Lemma shuffle_two t a b : In a (verts t) -> In b (verts t) -> a <> b -> exists c d, shuffle (Tetrahedron a b c d) t.
Proof.
  intros A B AB. destruct (shuffle_first t a A) as [x [y [z S]]].
  apply (shuffle_verts _ _ S) in B. destruct B as [B|[B|[B|[B|[]]]]]; cbn [va vb vc vd] in B; subst; [congruence| | |].
  - exists y, z. exact S.
  - exists x, z. apply shuffle_bc. exact S.
  - exists x, y. apply shuffle_bc, shuffle_cd. exact S.
Qed.
Lemma shuffle_three t a b c : In a (verts t) -> In b (verts t) -> In c (verts t) -> a <> b -> a <> c -> b <> c ->
  exists d, shuffle (Tetrahedron a b c d) t.
Proof.
  intros A B C AB AC BC. destruct (shuffle_two t a b A B AB) as [y [z S]].
  apply (shuffle_verts _ _ S) in C. destruct C as [C|[C|[C|[C|[]]]]]; cbn [va vb vc vd] in C; subst; [congruence|congruence| |].
  - exists z. exact S.
  - exists y. apply shuffle_cd. exact S.
Qed.

(** ** Points near a tile that is not at them *)

Lemma not_hull_open t x : vol t <> 0 -> ~ hull t x -> exists e, 0 < e /\ forall y, near e x y -> ~ hull t y.
Proof.
  intros V H. destruct (Rlt_dec 0 (vol t)) as [P|P].
  - rewrite hull_closed in H by exact P. destruct (not_closed_opn t x H) as [e [E K]]. exists e. split; [exact E|].
    intros y N. rewrite hull_closed by exact P. apply K, N.
  - destruct t as [a b c d]. set (t' := Tetrahedron b a c d). assert (Sh : shuffle (Tetrahedron a b c d) t') by apply shuffle_ab, shuffle_refl.
    assert (P' : 0 < vol t') by (replace (vol t') with (- vol (Tetrahedron a b c d)) by (unfold vol, t'; cbn [va vb vc vd]; unf; ring); lra).
    rewrite (shuffle_hull _ _ _ Sh), hull_closed in H by exact P'. destruct (not_closed_opn t' x H) as [e [E K]]. exists e. split; [exact E|].
    intros y N. rewrite (shuffle_hull _ _ _ Sh), hull_closed by exact P'. apply K, N.
Qed.

(** ** The tetrahedra of a tiling with ordered vertices *)
Section Cells.
Context {index : Type} {is_tile : index -> Prop} {tile : index -> tetrahedron}.
Hypothesis tiling : space_tiling is_tile tile.

Definition cell_of i a b c d := is_tile i /\ shuffle (Tetrahedron a b c d) (tile i).
Definition cell a b c d := exists i, cell_of i a b c d.
Lemma cell_ab a b c d : cell a b c d -> cell b a c d.
Proof. intros [i [T S]]. exists i. split; [exact T|]. apply shuffle_ab. exact S. Qed.
Lemma cell_bc a b c d : cell a b c d -> cell a c b d.
Proof. intros [i [T S]]. exists i. split; [exact T|]. apply shuffle_bc. exact S. Qed.
Lemma cell_cd a b c d : cell a b c d -> cell a b d c.
Proof. intros [i [T S]]. exists i. split; [exact T|]. apply shuffle_cd. exact S. Qed.
Lemma cell_solid a b c d : cell a b c d -> orient a b c d <> 0.
Proof.
  intros [i [T S]]. pose proof (space_solid _ _ tiling i T) as V. destruct (shuffle_vol _ _ S) as [E|E]; change (vol (Tetrahedron a b c d)) with (orient a b c d) in E; lra.
Qed.
Lemma cell_apart a b c d : cell a b c d -> a <> b /\ a <> c /\ a <> d /\ b <> c /\ b <> d /\ c <> d.
Proof. intros H. apply cell_solid in H. repeat split; intros E; apply H; rewrite E; unf; ring. Qed.

(** Only finitely many tiles are at a point. *)
Lemma near_far x : exists M, forall y, near 1 x y -> near M origin y.
Proof.
  exists (Rabs (px x) + Rabs (py x) + Rabs (pz x) + 1). intros y [A [B C]].
  pose proof (Rabs_pos (px x)); pose proof (Rabs_pos (py x)); pose proof (Rabs_pos (pz x)). unfold near, origin; cbn [px py pz].
  pose proof (Rabs_triang (px y - px x) (px x)) as TA. pose proof (Rabs_triang (py y - py x) (py x)) as TB. pose proof (Rabs_triang (pz y - pz x) (pz x)) as TC.
  replace (px y - px x + px x) with (px y - 0) in TA by ring. replace (py y - py x + py x) with (py y - 0) in TB by ring. replace (pz y - pz x + pz x) with (pz y - 0) in TC by ring. lra.
Qed.
Lemma tiles_at x : exists F e, 0 < e /\ forall i y, is_tile i -> near e x y -> hull (tile i) y -> In i F /\ hull (tile i) x.
Proof.
  destruct (near_far x) as [M HM]. destruct (space_locally_finite _ _ tiling M) as [F HF].
  assert (L : forall G, exists e, 0 < e /\ forall i y, In i G -> is_tile i -> near e x y -> hull (tile i) y -> hull (tile i) x).
  { induction G as [|i G [e [E IH]]]; [exists 1; split; [lra|intros i y []]|].
    destruct (classic (is_tile i -> hull (tile i) x)) as [H|H].
    - exists e. split; [exact E|]. intros j y [<-|J] T N Y; [auto|apply (IH j y); auto].
    - apply imply_to_and in H. destruct H as [T H]. destruct (not_hull_open (tile i) x (space_solid _ _ tiling i T) H) as [e' [E' K]].
      exists (Rmin e e'). split; [apply Rmin_glb_lt; auto|]. intros j y [<-|J] Tj N Y.
      + exfalso. apply (K y); [|exact Y]. apply near_mono with (2 := N). apply Rmin_r.
      + apply (IH j y); auto. apply near_mono with (2 := N). apply Rmin_l. }
  destruct (L F) as [e [E K]]. exists F, (Rmin e 1). split; [apply Rmin_glb_lt; lra|]. intros i y T N Y.
  assert (I : In i F). { apply (HF i y); auto. apply HM. apply near_mono with (2 := N). apply Rmin_r. }
  split; [exact I|]. apply (K i y); auto. apply near_mono with (2 := N). apply Rmin_l.
Qed.
Lemma hull_va a b c d t : shuffle (Tetrahedron a b c d) t -> hull t a.
Proof.
  intros S. apply (shuffle_hull _ _ _ S). exists 1, 0, 0, 0. repeat split; try lra. unfold combination; cbn [va vb vc vd]. apply point_eq; unf; ring.
Qed.
Lemma cells_at v : exists L, forall p q r, cell v p q r -> In (p, q, r) L.
Proof.
  destruct (tiles_at v) as [F [e [E H]]].
  exists (flat_map (fun i => list_prod (list_prod (verts (tile i)) (verts (tile i))) (verts (tile i))) F).
  intros p q r [i [T S]]. apply in_flat_map. exists i. split.
  - apply (H i v T); [apply near_refl; exact E|]. exact (hull_va _ _ _ _ _ S).
  - assert (V : forall x, In x [v; p; q; r] -> In x (verts (tile i))) by (intros x X; apply (shuffle_verts _ _ S); exact X).
    apply in_prod; [apply in_prod|]; apply V; simpl; auto.
Qed.

(** *** A facet has a tile on each side *)
Definition third := / 3.
Definition face_middle a b c := scale third (add (add a b) c).
Lemma weights_of a b c d wa wb wc wd : orient a b c d <> 0 -> wa + wb + wc + wd = 1 ->
  face_middle a b c = combination (Tetrahedron a b c d) wa wb wc wd -> wa = third /\ wb = third /\ wc = third.
Proof.
  intros V S E. set (t := Tetrahedron a b c d) in *. destruct (L_comb4 t wa wb wc wd S) as [A [B [C _]]].
  destruct (L_comb4 t third third third 0 ltac:(unfold third; lra)) as [A' [B' [C' _]]].
  replace (combination t third third third 0) with (face_middle a b c) in A', B', C' by (unfold t, combination, face_middle; cbn [va vb vc vd]; apply point_eq; unf; ring).
  rewrite <- E in A, B, C. change (vol t) with (orient a b c d) in *.
  repeat split; apply Rmult_eq_reg_r with (orient a b c d); try lra; exact V.
Qed.
Lemma across a b c d : cell a b c d -> exists e, cell a b c e /\ orient a b c d * orient a b c e < 0.
Proof.
  intros H. pose proof (cell_solid _ _ _ _ H) as V. pose proof (cell_apart _ _ _ _ H) as [AB [AC [_ [BC _]]]]. destruct H as [i [T S]].
  set (m := face_middle a b c). destruct (tiles_at m) as [F [e [E K]]].
  destruct (lerp_near e m (sub (scale 2 m) d) E) as [s [Hs N]]. set (y := lerp m (sub (scale 2 m) d) s) in *.
  destruct (space_cover _ _ tiling y) as [j [Tj Y]]. destruct (K j y Tj N Y) as [_ J].
  assert (Hm : hull (tile i) m).
  { apply (shuffle_hull _ _ _ S). exists third, third, third, 0. unfold third. repeat split; try lra. unfold m, combination, face_middle, third; cbn [va vb vc vd]. apply point_eq; unf; ring. }
  pose proof (shuffle_common _ _ _ _ S (space_face_to_face _ _ tiling m i j T Tj Hm J)) as [wa [wb [wc [wd [A [B [C [D [Sw [Em [VA [VB [VC _]]]]]]]]]]]]].
  cbn [va vb vc vd] in VA, VB, VC. destruct (weights_of a b c d wa wb wc wd V Sw Em) as [EA [EB EC]].
  assert (P : 0 < third) by (unfold third; lra).
  destruct (shuffle_three (tile j) a b c) as [x X]; auto; [apply VA|apply VB|apply VC|]; try lra.
  exists x. assert (Cx : cell a b c x) by (exists j; split; auto). split; [exact Cx|].
  pose proof (cell_solid _ _ _ _ Cx) as Vx.
  apply (shuffle_hull _ _ _ X) in Y. destruct Y as [ya [yb [yc [yd [YA [YB [YC [YD [Sy Ey]]]]]]]]].
  assert (Q : orient a b c y = yd * orient a b c x).
  { rewrite Ey. replace ya with (1 - yb - yc - yd) by lra. unfold combination; cbn [va vb vc vd]. unf. ring. }
  assert (Q' : orient a b c y = - s * orient a b c d) by (unfold y, m, face_middle, third; unf; field).
  assert (0 < orient a b c d * orient a b c d) by nra. assert (0 < s * (orient a b c d * orient a b c d)) by nra.
  assert (yd * (orient a b c d * orient a b c x) < 0) by (replace (yd * (orient a b c d * orient a b c x)) with (orient a b c d * (yd * orient a b c x)) by ring; rewrite <- Q, Q'; lra).
  nra.
Qed.

(** *** Two tiles at an edge whose wedges overlap are equal *)
Lemma inner_weight k x : 0 < k -> 0 < x -> x <= k -> 0 < x / (8 * k) <= / 8.
Proof.
  intros K X L. split; [apply Rdiv_lt_0_compat; lra|]. apply Rmult_le_reg_r with (8 * k); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.
Lemma wedge_inner a b c d x y z k t : 0 < k -> 0 < x <= k -> 0 < y <= k -> Rabs z <= k -> shuffle (Tetrahedron a b c d) t ->
  open_hull t (add (add a (scale (/ 2) (sub b a))) (scale (/ (8 * k)) (add (add (scale x (sub c a)) (scale y (sub d a))) (scale z (sub b a))))).
Proof.
  intros K [X X'] [Y Y'] Z S. apply (shuffle_open _ _ _ S).
  pose proof (inner_weight k x K X X'). pose proof (inner_weight k y K Y Y').
  assert (Hz : - / 8 <= z / (8 * k) <= / 8).
  { pose proof (Rle_abs z). pose proof (Rle_abs (- z)) as Zn. rewrite Rabs_Ropp in Zn.
    split; (apply Rmult_le_reg_r with (8 * k); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra). }
  exists (1 - (/ 2 + z / (8 * k)) - x / (8 * k) - y / (8 * k)), (/ 2 + z / (8 * k)), (x / (8 * k)), (y / (8 * k)).
  repeat split; try lra. unfold combination; cbn [va vb vc vd]. apply point_eq; unf; field; lra.
Qed.
Lemma same_tile a b c d c' d' x y z x' y' z' i j : is_tile i -> is_tile j -> shuffle (Tetrahedron a b c d) (tile i) -> shuffle (Tetrahedron a b c' d') (tile j) ->
  0 < x -> 0 < y -> 0 < x' -> 0 < y' ->
  add (add (scale x (sub c a)) (scale y (sub d a))) (scale z (sub b a)) = add (add (scale x' (sub c' a)) (scale y' (sub d' a))) (scale z' (sub b a)) -> i = j.
Proof.
  intros T T' S S' X Y X' Y' E.
  set (k := x + y + Rabs z + x' + y' + Rabs z'). pose proof (Rabs_pos z). pose proof (Rabs_pos z').
  pose proof (wedge_inner a b c d x y z k (tile i) ltac:(unfold k; lra) ltac:(unfold k; lra) ltac:(unfold k; lra) ltac:(unfold k; lra) S) as P.
  pose proof (wedge_inner a b c' d' x' y' z' k (tile j) ltac:(unfold k; lra) ltac:(unfold k; lra) ltac:(unfold k; lra) ltac:(unfold k; lra) S') as P'.
  rewrite <- E in P'.
  apply (space_disjoint _ _ tiling _ i j T T' P). destruct P' as [wa [wb [wc [wd [A [B [C [D Q]]]]]]]]. exists wa, wb, wc, wd. repeat split; try apply Q; lra.
Qed.
Lemma overlap a b c d c' d' x y z x' y' z' : cell a b c d -> cell a b c' d' -> 0 < x -> 0 < y -> 0 < x' -> 0 < y' ->
  add (add (scale x (sub c a)) (scale y (sub d a))) (scale z (sub b a)) = add (add (scale x' (sub c' a)) (scale y' (sub d' a))) (scale z' (sub b a)) ->
  (c = c' /\ d = d') \/ (c = d' /\ d = c').
Proof.
  intros H H' X Y X' Y' E. pose proof (cell_apart _ _ _ _ H') as [AB [AC [AD [BC [BD CD]]]]].
  destruct H as [i [T S]]. destruct H' as [j [T' S']].
  assert (IJ : i = j) by exact (same_tile a b c d c' d' x y z x' y' z' i j T T' S S' X Y X' Y' E). clear E.
  subst j. assert (V : forall v, In v [a; b; c'; d'] -> In v [a; b; c; d]).
  { intros v Hv. apply (shuffle_verts _ _ S). apply (shuffle_verts _ _ S'). exact Hv. }
  pose proof (V c' ltac:(simpl; auto)) as Q1. pose proof (V d' ltac:(simpl; auto)) as Q2. simpl in Q1, Q2.
  destruct Q1 as [Q1|[Q1|[Q1|[Q1|[]]]]]; try congruence; destruct Q2 as [Q2|[Q2|[Q2|[Q2|[]]]]]; try congruence; [left|right]; split; congruence.
Qed.
(** Tiles with the same vertices are equal. *)
Lemma tiles_same a b c d i j : is_tile i -> is_tile j -> shuffle (Tetrahedron a b c d) (tile i) -> shuffle (Tetrahedron a b c d) (tile j) -> i = j.
Proof. intros T T' S S'. apply (same_tile a b c d c d 1 1 0 1 1 0); auto; lra. Qed.
End Cells.
