(** * Systems of patches: the sides of a mosaic

    Two tiles that meet in a side have one frame there, up to periods: [carry] takes the coordinates of one to
    those of the other.  A side belongs to two tiles only ([meets_once]): the interiors of two tiles
    on one side of it overlap. *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Statement Sums Tetrahedra Degree Domain Euclid Transfer MosaicStatement MosaicPoints MosaicPatches.
Import ListNotations.
Open Scope R_scope.

Section System.
Variables (G : gram) (r : nat) (system : list patch) (h : hints).
Hypothesis OK : good G r system h.
Variables (l1 l2 l3 : point).
Hypothesis basis : has_gram G l1 l2 l3.
Hypothesis right_handed : 0 < det l1 l2 l3.
Variable tiles : nat -> tile.
Hypothesis tiling : mosaic l1 l2 l3 G r system tiles.
Notation rank_eq := (rank_eq G r system h OK).
Notation carry := (carry G r).
Notation left_of := (left_of r).
Notation in_prism := (in_prism r).
Notation kind i := (shape (tiles i)).
Notation patch_of i := (patch_of system tiles i).
Notation meets i s j s' := (meets l1 l2 l3 r system tiles i s j s').
Notation place i x := (place tiles i x).
Notation period n := (period l1 l2 l3 n).

Lemma kind_lt i : (kind i < length system)%nat.
Proof. apply tiling. Qed.
Lemma motion i : exists m2 m3, axes (tiles i) = (l1, m2, m3) /\ has_gram G l1 m2 m3 /\ det l1 m2 m3 = det l1 l2 l3 /\ (r = 2%nat -> m2 = l2 /\ m3 = l3).
Proof.
  pose proof (mosaic_motions _ _ _ _ _ _ _ tiling i) as M. destruct (axes (tiles i)) as [[m1 m2] m3]. destruct M as [HG [D [-> R2]]].
  exists m2, m3. split; [reflexivity|]. split; [exact HG|]. split; [exact D|]. intros H.
  pose proof (R2 H) as E. subst m2. split; [reflexivity|]. assert (Z : sub m3 l3 = origin).
  { destruct HG as [A1 [A2 [A3 [A4 [A5 A6]]]]]. destruct basis as [B1 [B2 [B3 [B4 [B5 B6]]]]].
    assert (S : forall u v w, dot u (sub v w) = dot u v - dot u w) by (intros; unfold dot; unf; ring).
    assert (T : forall u v w x, det u v (sub w x) = det u v w - det u v x) by (intros; unf; ring).
    apply (flat_zero l1 l2); rewrite ?S, ?T; try lra. intros K.
    assert (E : det l1 l2 l3 * det l1 l2 l3 = (dot l1 l1 * dot l2 l2 - dot l1 l2 * dot l1 l2) * dot l3 l3
      - dot l1 l3 * (dot l1 l3 * dot l2 l2 - dot l2 l3 * dot l1 l2) + dot l2 l3 * (dot l1 l3 * dot l1 l2 - dot l2 l3 * dot l1 l1)) by (unfold det, dot; ring).
    destruct (good_blocks _ _ _ _ OK) as [Z13 [_ Z23]]. rewrite K, B5, B6, Z13, (Z23 H) in E. nra. }
  apply point_eq; [apply (f_equal px) in Z|apply (f_equal py) in Z|apply (f_equal pz) in Z]; unf; unfold origin in Z; cbn in Z; lra.
Qed.
Lemma place_affine i t a b c d : a + b + c + d = 1 -> combination (map_tet (fun x => place i x) t) a b c d = place i (combination t a b c d).
Proof.
  intros S. unfold MosaicStatement.place. destruct (axes (tiles i)) as [[m1 m2] m3]. unfold combination, map_tet, at_coordinates; cbn [va vb vc vd].
  replace d with (1 - a - b - c) by lra. apply point_eq; unf; ring.
Qed.
Lemma place_orient i a b c d : orient (place i a) (place i b) (place i c) (place i d) = det l1 l2 l3 * orient a b c d.
Proof.
  destruct (motion i) as [m2 [m3 [E [_ [D _]]]]]. unfold MosaicStatement.place. rewrite E, <- D. unfold at_coordinates. unf. ring.
Qed.
Lemma place_period i n x : in_lattice r n -> place i (lift n x) = add (place i x) (period n).
Proof.
  intros L. destruct (motion i) as [m2 [m3 [E [_ [_ R2]]]]]. unfold MosaicStatement.place, MosaicStatement.period, lattice_vector. rewrite E.
  destruct n as [[a b] c]. unfold lift, pt, at_coordinates. destruct rank_eq as [R|R]; rewrite R in L; cbn in L.
  - destruct L as [-> ->]. apply point_eq; unf; ring.
  - subst c. destruct (R2 R) as [-> ->]. apply point_eq; unf; ring.
Qed.
Lemma place_fibre i f x : in_fibre r f -> place i (add x f) = add (place i x) (at_coordinates l1 l2 l3 f).
Proof.
  intros L. destruct (motion i) as [m2 [m3 [E [_ [_ R2]]]]]. unfold MosaicStatement.place. rewrite E. unfold at_coordinates.
  destruct rank_eq as [R|R]; rewrite R in L; cbn in L.
  - destruct L as [Y Z]. apply point_eq; unf; rewrite Y, Z; ring.
  - destruct (R2 R) as [-> ->]. apply point_eq; unf; rewrite L; ring.
Qed.
Lemma period_inj n m : period n = period m -> n = m.
Proof.
  intros E. apply pt_inj. unfold MosaicStatement.period, lattice_vector in E. destruct n as [[a b] c], m as [[a' b'] c']. unfold pt.
  apply (E_inj l1 l2 l3) in E; auto. lra.
Qed.
Lemma period_add n m : period (zadd3 n m) = add (period n) (period m).
Proof. destruct n as [[a b] c], m as [[a' b'] c']. unfold MosaicStatement.period, lattice_vector, zadd3, at_coordinates. rewrite !plus_IZR. apply point_eq; unf; ring. Qed.
Lemma place_inj i x y : place i x = place i y -> x = y.
Proof.
  destruct (motion i) as [m2 [m3 [E [_ [D _]]]]]. unfold MosaicStatement.place. rewrite E. intros K.
  apply (E_inj l1 m2 m3); [lra|]. apply point_eq; [apply (f_equal px) in K|apply (f_equal py) in K|apply (f_equal pz) in K]; unfold Euclid.E; unf; lra.
Qed.

(** ** Sides that meet *)
Lemma meets_sym i s j s' : meets i s j s' -> meets j s' i s.
Proof.
  assert (B : forall X Y, same_base l1 l2 l3 r X Y -> same_base l1 l2 l3 r Y X).
  { intros X Y [f [F ->]]. exists (scale (-1) f). split.
    - unfold in_fibre, scale in *. destruct rank_eq as [-> | ->]; cbn in *; [destruct F as [-> ->]; lra|rewrite F; ring].
    - unfold at_coordinates. apply point_eq; unf; ring. }
  intros [A1 [A2 [A3 [A4 [A5 A6]]]]]. repeat split; auto. intros R Q. apply (A4 R). auto.
Qed.
Lemma meets_fits i s j s' : meets i s j s' -> fits G r (patch_of i) s (patch_of j) s'.
Proof.
  intros M. pose proof M as [A1 [A2 [_ [A4 _]]]]. apply (good_lengths _ _ _ _ OK); auto using kind_lt. apply (mosaic_classes _ _ _ _ _ _ _ tiling _ _ _ _ M).
Qed.
Lemma side_small i s : (s < sides (patch_of i))%nat -> (s < 2 \/ r = 1)%nat.
Proof. intros H. destruct rank_eq as [|R]; auto. left. pose proof (good_sides _ _ _ _ OK (kind i) (kind_lt i) R) as E. unfold MosaicStatement.patch_of in H. lia. Qed.

(** *** A side of the mosaic is that of two tiles *)
(** Two points of a patch over the same point of the base, for r = 1. *)
Definition same_place (x y : point) : Prop := py x = py y /\ pz x = pz y.
Lemma left_place p s x y : r = 1%nat -> same_place x y -> left_of p s x = left_of p s y.
Proof. intros R [A B]. unfold MosaicStatement.left_of. rewrite R, A, B. reflexivity. Qed.
Lemma finish_next p s : r = 1%nat -> same_place (finish r p s) (start (edge_at p (next (sides p) s))).
Proof. intros R. unfold finish. rewrite R. split; reflexivity. Qed.
Lemma left_start p s : r = 1%nat -> left_of p s (start (edge_at p s)) = 0.
Proof. intros R. unfold MosaicStatement.left_of. rewrite R. ring. Qed.
Lemma left_finish p s : r = 1%nat -> left_of p s (finish r p s) = 0.
Proof. intros R. unfold MosaicStatement.left_of. rewrite R. ring. Qed.
Lemma left_prev p s : r = 1%nat -> (s < sides p)%nat -> left_of p (prev (sides p) s) (start (edge_at p s)) = 0.
Proof.
  intros R Hs. rewrite (left_place p _ _ (finish r p (prev (sides p) s)) R); [apply left_finish, R|].
  destruct (finish_next p (prev (sides p) s) R) as [A B]. rewrite next_prev in A, B by auto. split; auto.
Qed.
(** The ends of a side are in the prism. *)
Lemma start_in i s : r = 1%nat -> (s < sides (patch_of i))%nat -> in_prism (patch_of i) (start (edge_at (patch_of i) s)).
Proof.
  intros R Hs t Ht. destruct (Nat.eq_dec t s) as [->|N]; [rewrite left_start by exact R; lra|].
  destruct (Nat.eq_dec t (prev (sides (patch_of i)) s)) as [->|N']; [rewrite left_prev by auto; lra|].
  apply Rlt_le. apply (proj2 (good_convex _ _ _ _ OK R (kind i) s t (kind_lt i) Hs Ht) N N').
Qed.
Lemma finish_in i s : r = 1%nat -> (s < sides (patch_of i))%nat -> in_prism (patch_of i) (finish r (patch_of i) s).
Proof. intros R Hs t Ht. rewrite (left_place _ _ _ _ R (finish_next _ _ R)). apply start_in; auto using next_lt. Qed.

(** Two directions V and V' on one side of the plane of l and u: a small multiple of V is one of V', up to l and u. *)
Lemma common_direction l u V V' : 0 < det l u V * det l u V' -> exists c c' k m, 0 < c <= 1 / 4 /\ 0 < c' <= 1 / 4 /\ - (1 / 4) <= k <= 1 / 4 /\
  scale c V = add (scale c' V') (add (scale k u) (scale m l)).
Proof.
  intros P. set (L := det l u V) in *. set (L' := det l u V') in *.
  assert (L0 : L <> 0) by (intros E; rewrite E in P; lra). assert (L0' : L' <> 0) by (intros E; rewrite E in P; lra).
  assert (P' : 0 < L' * L') by (destruct (Rdichotomy _ _ L0'); nra).
  set (W := sub (scale (L' * L') V) (scale (L * L') V')).
  assert (W0 : det l u W = 0) by (unfold W; transitivity (L' * L' * L - L * L' * L'); [unfold L, L'; unf; ring|ring]).
  set (K := det l W V / L). set (M := det W u V / L).
  assert (WE : W = add (scale K u) (scale M l)).
  { assert (C : scale L W = add (scale (det W u V) l) (add (scale (det l W V) u) (scale (det l u W) V))) by (unfold L; apply point_eq; unf; ring).
    rewrite W0 in C. unfold K, M. clearbody L W. clear - C L0.
    apply point_eq; [apply (f_equal px) in C|apply (f_equal py) in C|apply (f_equal pz) in C]; unf; apply Rmult_eq_reg_l with L; auto; rewrite C; field; exact L0. }
  set (D := 4 * (1 + L' * L' + L * L' + Rabs K)). assert (K0 : 0 <= Rabs K) by apply Rabs_pos. assert (D0 : 0 < D) by (unfold D; lra).
  assert (B : forall x, - (L' * L' + L * L' + Rabs K) <= x <= L' * L' + L * L' + Rabs K -> - (1 / 4) <= x / D <= 1 / 4).
  { intros x X. split; apply Rmult_le_reg_r with D; auto; replace (x / D * D) with x by (field; lra); unfold D; lra. }
  assert (KA : - Rabs K <= K <= Rabs K) by (split; [pose proof (Rle_abs (- K)); rewrite Rabs_Ropp in *; lra|apply Rle_abs]).
  exists (L' * L' / D), (L * L' / D), (K / D), (M / D). split; [split; [apply Rdiv_lt_0_compat; auto|apply B; lra]|].
  split; [split; [apply Rdiv_lt_0_compat; auto|apply B; lra]|]. split; [apply B; lra|].
  clearbody K M D L L'. clear - WE D0. unfold W in WE.
  apply point_eq; [apply (f_equal px) in WE|apply (f_equal py) in WE|apply (f_equal pz) in WE]; unf; apply Rmult_eq_reg_l with D; try lra; field_simplify; try lra.
Qed.
Lemma within_place i x : inside_prism r (patch_of i) x -> within r system tiles i (place i x).
Proof. intros P. exists x. auto. Qed.
Lemma over_fibre i x f : in_fibre r f -> in_prism (patch_of i) x -> over r system tiles i (add (place i x) (at_coordinates l1 l2 l3 f)).
Proof. intros F P. exists (add x f). rewrite place_fibre by exact F. split; [reflexivity|]. intros s Hs. rewrite (left_fibre r rank_eq) by exact F. apply P, Hs. Qed.
Lemma place_axis i a b x : det l1 (sub (place i a) (place i b)) (sub (place i x) (place i b)) = det l1 l2 l3 * ((py a - py b) * (pz x - pz b) - (pz a - pz b) * (py x - py b)).
Proof. destruct (motion i) as [m2 [m3 [E [_ [D _]]]]]. unfold MosaicStatement.place. rewrite E, <- D. unfold at_coordinates. unf. ring. Qed.
Lemma place_layer i b x : r = 2%nat -> det l1 l2 (sub (place i x) (place i b)) = det l1 l2 l3 * (pz x - pz b).
Proof. intros R. destruct (motion i) as [m2 [m3 [E [_ [_ R2]]]]]. destruct (R2 R) as [-> ->]. unfold MosaicStatement.place. rewrite E. unfold at_coordinates. unf. ring. Qed.
(** Only one other tile has a side. *)
Lemma one_neighbour i s j s' j' s'' : meets i s j s' -> meets i s j' s'' -> j' = j.
Proof.
  intros [_ [Hs' [_ [A3 [[f [F A]] [g [Fg B]]]]]]] [Hs [Hs'' [_ [A3' [[f' [F' A']] [g' [Fg' B']]]]]]].
  destruct (good_homes _ _ _ _ OK (kind j) (kind_lt j)) as [_ [x [_ [_ [X _]]]]]. destruct (good_homes _ _ _ _ OK (kind j') (kind_lt j')) as [_ [x' [_ [_ [X' _]]]]].
  change (nth (kind j) system (Patch [] [] [])) with (patch_of j) in *. change (nth (kind j') system (Patch [] [] [])) with (patch_of j') in *.
  rewrite A in A'. rewrite B in B'. clear A B.
  cut (exists y y' h, in_fibre r h /\ inside_prism r (patch_of j) y /\ in_prism (patch_of j') y' /\ place j y = add (place j' y') (at_coordinates l1 l2 l3 h)).
  { intros [y [y' [k [K [Y [Y' E]]]]]]. symmetry. apply (mosaic_apart _ _ _ _ _ _ _ tiling j j' (place j y)); [apply within_place, Y|]. rewrite E. apply over_fibre; auto. }
  destruct rank_eq as [R|R].
  - set (P := finish r (patch_of j) s') in *. set (Q := start (edge_at (patch_of j) s')) in *. set (P' := finish r (patch_of j') s'') in *. set (Q' := start (edge_at (patch_of j') s'')) in *.
    assert (LX : 0 < (py P - py Q) * (pz x - pz Q) - (pz P - pz Q) * (py x - py Q)) by (pose proof (X s' Hs') as L; unfold MosaicStatement.left_of in L; rewrite R in L; unfold P, Q; rewrite R; exact L).
    assert (LX' : 0 < (py P' - py Q') * (pz x' - pz Q') - (pz P' - pz Q') * (py x' - py Q')) by (pose proof (X' s'' Hs'') as L; unfold MosaicStatement.left_of in L; rewrite R in L; unfold P', Q'; rewrite R; exact L).
    apply (Rmult_lt_0_compat _ _ right_handed) in LX, LX'. rewrite <- (place_axis j) in LX. rewrite <- (place_axis j') in LX'.
    assert (DE : forall V, det l1 (sub (place j P) (place j Q)) V = det l1 (sub (place j' P') (place j' Q')) V).
    { rewrite R in F, F', Fg, Fg'. destruct F as [F2 F3], F' as [F2' F3'], Fg as [G2 G3], Fg' as [G2' G3']. intros V. unfold at_coordinates in A', B'. rewrite ?F2, ?F3, ?F2', ?F3' in A'. rewrite ?G2, ?G3, ?G2', ?G3' in B'.
      assert (U : sub (place j P) (place j Q) = add (sub (place j' P') (place j' Q')) (scale (px f' - px f - (px g' - px g)) l1)).
      { apply point_eq; [apply (f_equal px) in A'; apply (f_equal px) in B'|apply (f_equal py) in A'; apply (f_equal py) in B'|apply (f_equal pz) in A'; apply (f_equal pz) in B']; unf; lra. }
      rewrite U. unf. ring. }
    assert (PR : 0 < det l1 (sub (place j P) (place j Q)) (sub (place j x) (place j Q)) * det l1 (sub (place j P) (place j Q)) (sub (place j' x') (place j' Q'))) by (rewrite (DE (sub (place j' x') (place j' Q'))); apply Rmult_lt_0_compat; auto).
    apply common_direction in PR as [c [c' [k [m [C [C' [K E]]]]]]].
    set (t := Tetrahedron P Q x x). set (t' := Tetrahedron P' Q' x' x').
    exists (combination t (1 / 2) (1 / 2 - c) c 0), (combination t' (1 / 2 + k) (1 / 2 - k - c') c' 0).
    assert (Z : exists e, place j (combination t (1 / 2) (1 / 2 - c) c 0) = add (place j' (combination t' (1 / 2 + k) (1 / 2 - k - c') c' 0)) (scale e l1)).
    { rewrite <- !place_affine by field. unfold combination, map_tet, t, t'; cbn [va vb vc vd].
      rewrite R in F, F', Fg, Fg'. destruct F as [F2 F3], F' as [F2' F3'], Fg as [G2 G3], Fg' as [G2' G3']. unfold at_coordinates in A', B'. rewrite ?F2, ?F3, ?F2', ?F3' in A'. rewrite ?G2, ?G3, ?G2', ?G3' in B'.
      exists (m + (1 / 2 + k) * (px f' - px f) + (1 / 2 - k) * (px g' - px g)).
      apply point_eq; [apply (f_equal px) in A'; apply (f_equal px) in B'; apply (f_equal px) in E|apply (f_equal py) in A'; apply (f_equal py) in B'; apply (f_equal py) in E|apply (f_equal pz) in A'; apply (f_equal pz) in B'; apply (f_equal pz) in E];
        unf; clear - A' B' E; nra. }
    destruct Z as [e Z]. exists (Point e 0 0). split; [rewrite R; split; reflexivity|]. split; [|split].
    + intros t0 Ht. rewrite (left_affine r rank_eq) by field. unfold t; cbn [va vb vc vd]. pose proof (finish_in j s' R Hs' t0 Ht : 0 <= left_of (patch_of j) t0 P). pose proof (start_in j s' R Hs' t0 Ht : 0 <= left_of (patch_of j) t0 Q). pose proof (X t0 Ht). nra.
    + intros t0 Ht. rewrite (left_affine r rank_eq) by field. unfold t'; cbn [va vb vc vd]. pose proof (finish_in j' s'' R Hs'' t0 Ht : 0 <= left_of (patch_of j') t0 P'). pose proof (start_in j' s'' R Hs'' t0 Ht : 0 <= left_of (patch_of j') t0 Q'). pose proof (X' t0 Ht). nra.
    + rewrite Z. f_equal. unfold at_coordinates. apply point_eq; unf; ring.
  - pose proof (good_sides _ _ _ _ OK (kind j) (kind_lt j) R) as N. pose proof (good_sides _ _ _ _ OK (kind j') (kind_lt j') R) as N'. pose proof (good_sides _ _ _ _ OK (kind i) (kind_lt i) R) as Ni.
    change (nth (kind j) system (Patch [] [] [])) with (patch_of j) in *. change (nth (kind j') system (Patch [] [] [])) with (patch_of j') in *. change (nth (kind i) system (Patch [] [] [])) with (patch_of i) in *.
    specialize (A3 R). specialize (A3' R). assert (s'' = s') by lia. subst s''. clear B' Fg Fg'.
    pose proof (X 0%nat ltac:(lia)) as X0. pose proof (X 1%nat ltac:(lia)) as X1. pose proof (X' 0%nat ltac:(lia)) as X0'. pose proof (X' 1%nat ltac:(lia)) as X1'.
    unfold finish in A'. rewrite R in F, F', A'. cbn [in_fibre] in F, F'. set (Q := start (edge_at (patch_of j) s')) in *. set (Q' := start (edge_at (patch_of j') s')) in *.
    assert (END : forall p y t, inside_prism r p y -> sides p = 2%nat -> (t < 2)%nat -> 0 <= left_of p t (start (edge_at p s'))).
    { intros p y t Y S Ht. pose proof (Y 0%nat ltac:(lia)) as Y0. pose proof (Y 1%nat ltac:(lia)) as Y1. unfold MosaicStatement.left_of in *. rewrite R in *.
      destruct s' as [|[|s']]; [| |lia]; destruct t as [|[|t]]; try lia; lra. }
    assert (PR : 0 < det l1 l2 (sub (place j x) (place j Q)) * det l1 l2 (sub (place j' x') (place j' Q'))).
    { rewrite !place_layer by exact R. assert (0 < (pz x - pz Q) * (pz x' - pz Q')).
      { unfold Q, Q', MosaicStatement.left_of in *. rewrite R in *. destruct s' as [|[|s']]; [| |lia]; nra. }
      assert (0 < det l1 l2 l3 * det l1 l2 l3) by (apply Rmult_lt_0_compat; auto). nra. }
    apply common_direction in PR as [c [c' [k [m [C [C' [K E]]]]]]].
    set (t := Tetrahedron Q Q x x). set (t' := Tetrahedron Q' Q' x' x').
    exists (combination t (1 - c) 0 c 0), (combination t' (1 - c') 0 c' 0), (Point (m + px f' - px f) (k + py f' - py f) 0).
    split; [rewrite R; reflexivity|]. split; [|split].
    + intros t0 Ht. rewrite (left_affine r rank_eq) by field. unfold t; cbn [va vb vc vd]. pose proof (END (patch_of j) x t0 X N ltac:(lia) : 0 <= left_of (patch_of j) t0 Q). pose proof (X t0 Ht). nra.
    + intros t0 Ht. rewrite (left_affine r rank_eq) by field. unfold t'; cbn [va vb vc vd]. pose proof (END (patch_of j') x' t0 X' N' ltac:(lia) : 0 <= left_of (patch_of j') t0 Q'). pose proof (X' t0 Ht). nra.
    + rewrite <- !place_affine by field. unfold combination, map_tet, t, t', at_coordinates in *; cbn [va vb vc vd]. rewrite F, F' in A'.
      apply point_eq; [apply (f_equal px) in A'; apply (f_equal px) in E|apply (f_equal py) in A'; apply (f_equal py) in E|apply (f_equal pz) in A'; apply (f_equal pz) in E]; unf; clear - A' E; lra.
Qed.
(** And with one of its sides. *)
Lemma meets_once i s j s' j' s'' : meets i s j s' -> meets i s j' s'' -> j' = j /\ s'' = s'.
Proof.
  intros M M'. pose proof (one_neighbour _ _ _ _ _ _ M M') as ->. split; [reflexivity|].
  destruct M as [Hs [Hs' [_ [A3 [[f [F A]] [g [Fg B]]]]]]], M' as [_ [Hs'' [_ [A3' [[f' [F' A']] [g' [Fg' B']]]]]]].
  destruct rank_eq as [R|R].
  - destruct (Nat.eq_dec s' s'') as [|NE]; [auto|exfalso].
    rewrite A, <- !place_fibre in A' by auto. rewrite B, <- !place_fibre in B' by auto.
    assert (PL : forall x y h h', in_fibre r h -> in_fibre r h' -> place j (add x h) = place j (add y h') -> same_place x y).
    { intros x y u u' U U' E. apply place_inj in E. rewrite R in U, U'. destruct U as [U2 U3], U' as [U2' U3']. split; [apply (f_equal py) in E|apply (f_equal pz) in E]; unf; lra. }
    apply (PL _ _ _ _ Fg Fg') in B'. clear A' PL.
    destruct (Nat.eq_dec s' (prev (sides (patch_of j)) s'')) as [EP|NP].
    + destruct (good_homes _ _ _ _ OK (kind j) (kind_lt j)) as [_ [x [_ [_ [X _]]]]]. specialize (X s' Hs'). change (nth (kind j) system (Patch [] [] [])) with (patch_of j) in X.
      destruct (finish_next (patch_of j) s' R) as [E1 E2]. rewrite EP, next_prev in E1, E2 by exact Hs''. rewrite <- EP in E1, E2. destruct B' as [E3 E4].
      unfold MosaicStatement.left_of in X. rewrite R in X, E1, E2. rewrite E1, E2, <- E3, <- E4 in X. lra.
    + pose proof (proj2 (good_convex _ _ _ _ OK R (kind j) s'' s' (kind_lt j) Hs'' Hs') NE NP) as L. change (nth (kind j) system (Patch [] [] [])) with (patch_of j) in L.
      rewrite <- (left_place _ _ _ _ R B'), left_start in L by exact R. lra.
  - pose proof (good_sides _ _ _ _ OK (kind j) (kind_lt j) R) as N. pose proof (good_sides _ _ _ _ OK (kind i) (kind_lt i) R) as Ni. unfold MosaicStatement.patch_of in *. specialize (A3 R). specialize (A3' R). lia.
Qed.

(** The frames of two tiles that meet. *)
Lemma frame_meets i s j s' P Q T x : meets i s j s' -> in_fibre r P -> in_fibre r Q ->
  place i (add (start (edge_at (patch_of i) s)) P) = add (place j (add (finish r (patch_of j) s') Q)) T ->
  add (place j (add x Q)) T = place i (add (carry (patch_of i) s (patch_of j) s' x) P).
Proof.
  intros M Fi Fj K. pose proof M as [_ [_ [_ [_ [B1 B2]]]]]. pose proof (meets_fits _ _ _ _ M) as [_ [_ N]].
  destruct (motion i) as [a2 [a3 [Ei [HGi [Di R2i]]]]]. destruct (motion j) as [b2 [b3 [Ej [HGj [Dj R2j]]]]].
  destruct (good_blocks _ _ _ _ OK) as [Z13 [Z12 _]].
  unfold MosaicPatches.carry. unfold MosaicStatement.place in *. rewrite Ei, Ej in *.
  set (A := start (edge_at (patch_of i) s)) in *. set (B := start (edge_at (patch_of j) s')) in *.
  set (C := corner (tiles i)) in *. set (D := corner (tiles j)) in *.
  destruct rank_eq as [R|R]; rewrite R in *.
  - specialize (Z12 eq_refl). destruct (N eq_refl) as [NN N0]. clear N R2i R2j.
    unfold length2 in *. set (u := along 1 (patch_of i) s) in *. set (v := along 1 (patch_of j) s') in *.
    assert (Fu : finish 1 (patch_of i) s = add A u) by (unfold u, along, A; apply point_eq; unf; ring).
    assert (Fv : finish 1 (patch_of j) s' = add B v) by (unfold v, along, B; apply point_eq; unf; ring).
    assert (U0 : px u = 0) by (unfold u, along, finish; unf; ring). assert (V0 : px v = 0) by (unfold v, along, finish; unf; ring).
    rewrite Fu in B2. rewrite Fv in B1, K. clearbody u v A B C D.
    cbn [in_fibre] in *. destruct Fi as [Pi1 Pi2], Fj as [Pj1 Pj2].
    destruct B1 as [f [[F1 F2] B1]]. destruct B2 as [g [[G1 G2] B2]].
    destruct HGi as [I1 [I2 [I3 [I4 [I5 I6]]]]]. destruct HGj as [J1 [J2 [J3 [J4 [J5 J6]]]]].
    set (N := g22 G * (py u * py u) + g33 G * (pz u * pz u) + g23 G * (py u * pz u + pz u * py u)) in *.
    set (U := add (scale (py u) a2) (scale (pz u) a3)). set (U' := add (scale (py v) b2) (scale (pz v) b3)).
    set (V := add (scale (- (g23 G * py u + g33 G * pz u)) a2) (scale (g22 G * py u + g23 G * pz u) a3)).
    set (V' := add (scale (- (g23 G * py v + g33 G * pz v)) b2) (scale (g22 G * py v + g23 G * pz v) b3)).
    assert (LL : 0 < dot l1 l1).
    { destruct (Req_dec (dot l1 l1) 0) as [Z|Z].
      - exfalso. unfold dot in Z. pose proof (Rle_0_sqr (px l1)); pose proof (Rle_0_sqr (py l1)); pose proof (Rle_0_sqr (pz l1)); unfold Rsqr in *.
        assert (X : px l1 = 0) by nra. assert (Y : py l1 = 0) by nra. assert (W : pz l1 = 0) by nra.
        revert right_handed. unfold det. rewrite X, Y, W. lra.
      - unfold dot in *. pose proof (Rle_0_sqr (px l1)); pose proof (Rle_0_sqr (py l1)); pose proof (Rle_0_sqr (pz l1)); unfold Rsqr in *. lra. }
    assert (DL : forall c x y z w, dot l1 (add (scale x y) (scale z w)) = x * dot l1 y + z * dot l1 w + c * 0) by (intros; unfold dot; unf; ring).
    assert (UU : add U U' = scale (px g - px f) l1).
    { unfold U, U', at_coordinates in *. apply point_eq; [apply (f_equal px) in B1; apply (f_equal px) in B2|apply (f_equal py) in B1; apply (f_equal py) in B2|apply (f_equal pz) in B1; apply (f_equal pz) in B2];
      unf; rewrite ?F1, ?F2, ?G1, ?G2, ?U0, ?V0 in *; lra. }
    assert (CU : px g - px f = 0).
    { assert (X : dot l1 (add U U') = 0). { unfold U, U'. assert (S : forall x y z, dot x (add y z) = dot x y + dot x z) by (intros; unfold dot; unf; ring). rewrite S, !(DL 0), I4, I5, J4, J5, Z12, Z13. ring. }
      rewrite UU in X. assert (Y : dot l1 (scale (px g - px f) l1) = (px g - px f) * dot l1 l1) by (unfold dot; unf; ring). rewrite Y in X. nra. }
    rewrite CU in UU. clear B1 B2 CU F1 F2 G1 G2 f g.
    assert (UE : U' = scale (-1) U).
    { clear - UU. clearbody U U'. apply point_eq; [apply (f_equal px) in UU|apply (f_equal py) in UU|apply (f_equal pz) in UU]; unf; lra. }
    assert (DS : forall x y z, dot x (add y z) = dot x y + dot x z) by (intros; unfold dot; unf; ring).
    assert (DUV : dot U V = 0).
    { transitivity (- (g23 G * py u + g33 G * pz u) * (py u * dot a2 a2 + pz u * dot a2 a3) + (g22 G * py u + g23 G * pz u) * (py u * dot a2 a3 + pz u * dot a3 a3)).
      - unfold U, V, dot. unf. ring. - rewrite I2, I3, I6. ring. }
    assert (DUV' : dot U' V' = 0).
    { transitivity (- (g23 G * py v + g33 G * pz v) * (py v * dot b2 b2 + pz v * dot b2 b3) + (g22 G * py v + g23 G * pz v) * (py v * dot b2 b3 + pz v * dot b3 b3)).
      - unfold U', V', dot. unf. ring. - rewrite J2, J3, J6. ring. }
    assert (DU : dot U U = N).
    { transitivity (py u * py u * dot a2 a2 + pz u * pz u * dot a3 a3 + dot a2 a3 * (py u * pz u + pz u * py u)).
      - unfold U, dot. unf. ring. - rewrite I2, I3, I6. unfold N. ring. }
    assert (W : add V V' = origin).
    { apply (flat_zero l1 U).
      - rewrite DS. unfold V, V'. rewrite !(DL 0), I4, I5, J4, J5, Z12, Z13. ring.
      - rewrite DS, DUV. assert (X : dot U V' = - dot U' V') by (rewrite UE; unfold dot; unf; ring). rewrite X, DUV'. ring.
      - assert (X : det l1 U (add V V') = det l1 U V + det l1 U V') by (unf; ring). rewrite X.
        assert (Y : det l1 U V' = - det l1 U' V') by (rewrite UE; unf; ring). rewrite Y.
        assert (X1 : det l1 U V = N * det l1 a2 a3) by (unfold U, V, N; unf; ring).
        assert (X2 : det l1 U' V' = (g22 G * (py v * py v) + g33 G * (pz v * pz v) + g23 G * (py v * pz v + pz v * py v)) * det l1 b2 b3) by (unfold U', V'; unf; ring).
        rewrite X1, X2, <- NN, Di, Dj. ring.
      - assert (X : dot l1 U = 0) by (unfold U; rewrite (DL 0), I4, I5, Z12, Z13; ring). rewrite X, DU.
        assert (0 < dot l1 l1 * N \/ dot l1 l1 * N < 0); [|lra]. destruct (Rdichotomy _ _ N0); [right|left]; nra. }
    assert (VE : V' = scale (-1) V).
    { clear - W. clearbody V V'. apply point_eq; [apply (f_equal px) in W|apply (f_equal py) in W|apply (f_equal pz) in W]; unf; unfold origin in W; cbn in W; lra. }
    set (b := sub x B). set (X := g22 G * (py b * py v) + g33 G * (pz b * pz v) + g23 G * (py b * pz v + pz b * py v)). set (Y := py v * pz b - pz v * py b).
    assert (BE : add (scale (py b) b2) (scale (pz b) b3) = scale (/ N) (add (scale X U') (scale Y V'))).
    { assert (E2 : N * py b = X * py v + Y * (- (g23 G * py v + g33 G * pz v))) by (rewrite NN; unfold X, Y; ring).
      assert (E3 : N * pz b = X * pz v + Y * (g22 G * py v + g23 G * pz v)) by (rewrite NN; unfold X, Y; ring).
      assert (E2' : py b = / N * (X * py v + Y * (- (g23 G * py v + g33 G * pz v)))) by (rewrite <- E2; field; exact N0).
      assert (E3' : pz b = / N * (X * pz v + Y * (g22 G * py v + g23 G * pz v))) by (rewrite <- E3; field; exact N0).
      clearbody X Y. clear E2 E3. rewrite E2', E3' at 1. unfold U', V'. apply point_eq; unf; ring. }
    assert (XB : x = add B b) by (unfold b; apply point_eq; unf; ring).
    clearbody X Y b N. subst x.
    assert (K' : sub (add C (at_coordinates l1 a2 a3 (add A P))) (add (add D (at_coordinates l1 b2 b3 (add (add B v) Q))) T) = origin).
    { rewrite K. apply point_eq; unf; unfold origin; cbn; ring. }
    assert (UE' : add (add (scale (py v) b2) (scale (pz v) b3)) U = origin) by (fold U'; rewrite UE; apply point_eq; unf; unfold origin; cbn; ring).
    assert (VE' : add V' V = origin) by (rewrite VE; apply point_eq; unf; unfold origin; cbn; ring).
    rewrite UE, VE in BE. unfold U, V, at_coordinates in *.
    apply point_eq; [apply (f_equal px) in K'; apply (f_equal px) in UE'; apply (f_equal px) in BE|apply (f_equal py) in K'; apply (f_equal py) in UE'; apply (f_equal py) in BE|apply (f_equal pz) in K'; apply (f_equal pz) in UE'; apply (f_equal pz) in BE];
    clear - K' UE' BE N0 Pi1 Pi2 Pj1 Pj2 U0 V0; unf; unfold origin in *; cbn in *; rewrite ?Pi1, ?Pi2, ?Pj1, ?Pj2, ?V0 in *;
    match goal with |- ?l = ?rr => match type of BE with ?bl = ?br => match type of UE' with ?ul = _ => match type of K' with ?kl = _ =>
      assert (FIN : l - rr = (bl - br) - ul - kl) by (field; exact N0); rewrite BE, UE', K' in FIN; lra end end end end.
  - destruct (R2i eq_refl) as [-> ->], (R2j eq_refl) as [-> ->]. unfold finish in K. fold B in K.
    apply point_eq; [apply (f_equal px) in K|apply (f_equal py) in K|apply (f_equal pz) in K]; unfold at_coordinates in *; unf; lra.
Qed.

Variable rise : nat -> point.
Hypothesis high : heights l1 l2 l3 r system tiles rise.
Notation spot i x := (spot tiles rise i x).
Definition at_ i n x := spot i (lift n x).
Lemma at_period i n x : latb r n = true -> at_ i n x = add (spot i x) (period n).
Proof.
  intros L. unfold at_, MosaicStatement.spot. rewrite <- place_period by (apply latb_iff, L). f_equal. unfold lift. apply point_eq; unf; ring.
Qed.
Lemma at_lift i n m x : at_ i n (lift m x) = at_ i (zadd3 n m) x.
Proof. unfold at_. rewrite lift_lift. reflexivity. Qed.
Lemma spot_affine i n t a b c d : a + b + c + d = 1 -> combination (map_tet (at_ i n) t) a b c d = at_ i n (combination t a b c d).
Proof.
  intros S. unfold at_, MosaicStatement.spot. change (map_tet _ t) with (map_tet (fun x => place i x) (map_tet (fun x => add (lift n x) (rise i)) t)).
  rewrite place_affine by auto. f_equal. unfold combination, map_tet, lift; cbn [va vb vc vd]. replace d with (1 - a - b - c) by lra. apply point_eq; unf; ring.
Qed.
Lemma at_orient i n a b c d : orient (at_ i n a) (at_ i n b) (at_ i n c) (at_ i n d) = det l1 l2 l3 * orient a b c d.
Proof.
  unfold at_, MosaicStatement.spot. rewrite place_orient. f_equal. unfold lift. unf. ring.
Qed.
Lemma at_coord i n t k x : coord (map_tet (at_ i n) t) k (at_ i n x) = det l1 l2 l3 * coord t k x.
Proof. unfold coord, side. rewrite facet_map. cbn [map_tri t1 t2 t3]. apply at_orient. Qed.
Lemma at_vol i n t : vol (map_tet (at_ i n) t) = det l1 l2 l3 * vol t.
Proof. exact (at_orient i n (va t) (vb t) (vc t) (vd t)). Qed.
Lemma at_closed i n t x : closed (map_tet (at_ i n) t) (at_ i n x) <-> closed t x.
Proof.
  split; intros C k Hk; specialize (C k Hk).
  - rewrite at_coord in C. nra.
  - rewrite at_coord. apply Rmult_le_pos; lra.
Qed.
Lemma at_inj i n x y : at_ i n x = at_ i n y -> x = y.
Proof.
  unfold at_, MosaicStatement.spot. intros E. apply place_inj in E. unfold lift in E.
  apply point_eq; [apply (f_equal px) in E|apply (f_equal py) in E|apply (f_equal pz) in E]; unf; lra.
Qed.


(** For each side of a tile the one that it meets, and the difference of their heights in periods. *)
Definition across_side i s : nat * nat := proj1_sig (choose_pair (fun js => meets i s (fst js) (snd js))).
Lemma across_meets i s j s' : (s < sides (patch_of i))%nat -> across_side i s = (j, s') -> meets i s j s'.
Proof.
  intros Hs E. unfold across_side in E. destruct (choose_pair _) as [js M]; cbn [proj1_sig] in E. subst js. apply M.
  destruct (mosaic_edge_to_edge _ _ _ _ _ _ _ tiling i s Hs) as [j' [s'' K]]. exists (j', s''). exact K.
Qed.
Lemma meets_across i s j s' : meets i s j s' -> across_side i s = (j, s').
Proof.
  intros M. pose proof M as [Hs _]. destruct (across_side i s) as [j2 s2] eqn:E. apply across_meets in E; [|exact Hs].
  destruct (meets_once _ _ _ _ _ _ M E) as [-> ->]. reflexivity.
Qed.
Lemma across_spec i s j s' : (s < sides (patch_of i))%nat -> across_side i s = (j, s') ->
  (s' < sides (patch_of j))%nat /\ j <> i /\ across_side j s' = (i, s) /\ fits G r (patch_of i) s (patch_of j) s'.
Proof.
  intros Hs E. apply across_meets in E; auto. pose proof E as [_ [Hs' [N _]]]. repeat split; auto; try apply (meets_fits _ _ _ _ E); auto.
  apply meets_across, meets_sym, E.
Qed.
Definition step i s : Z3 := let '(j, s') := across_side i s in
  proj1_sig (choose3 (fun n => in_lattice r n /\ spot i (start (edge_at (patch_of i) s)) = add (spot j (finish r (patch_of j) s')) (period n))).
Lemma step_spec i s j s' : (s < sides (patch_of i))%nat -> across_side i s = (j, s') -> latb r (step i s) = true /\
  forall n x, latb r n = true -> at_ j (zadd3 n (step i s)) x = at_ i n (carry (patch_of i) s (patch_of j) s' x).
Proof.
  intros Hs E. pose proof (across_meets _ _ _ _ Hs E) as M. unfold step. rewrite E.
  destruct (choose3 _) as [n K]; cbn [proj1_sig]. destruct (K (heights_agree _ _ _ _ _ _ _ high _ _ _ _ M)) as [L S]. clear K.
  apply latb_iff in L as L'. split; [exact L'|]. intros m x Hm. rewrite !at_period by auto using latb_add.
  unfold MosaicStatement.spot in *. rewrite <- (frame_meets i s j s' (rise i) (rise j) (period n) x M (heights_in_fibre _ _ _ _ _ _ _ high i) (heights_in_fibre _ _ _ _ _ _ _ high j) S), period_add.
  apply point_eq; unf; ring.
Qed.
Lemma step_opp i s j s' : (s < sides (patch_of i))%nat -> across_side i s = (j, s') -> step j s' = zopp3 (step i s).
Proof.
  intros Hs E. destruct (across_spec i s j s' Hs E) as [Hs' [_ [E' _]]].
  destruct (step_spec i s j s' Hs E) as [L F]. destruct (step_spec j s' i s Hs' E') as [L' F'].
  destruct (across_spec i s j s' Hs E) as [_ [_ [_ FT]]]. set (c := carry (patch_of i) s (patch_of j) s' origin).
  assert (K : at_ j (zadd3 (zadd3 z30 (step j s')) (step i s)) origin = at_ j z30 origin).
  { rewrite F by auto using latb_add, latb_zero. rewrite F' by apply latb_zero. f_equal. apply carry_carry; [exact rank_eq|exact FT]. }
  rewrite !at_period in K by auto using latb_add, latb_zero.
  assert (Z : period (zadd3 (zadd3 z30 (step j s')) (step i s)) = period z30).
  { apply point_eq; [apply (f_equal px) in K|apply (f_equal py) in K|apply (f_equal pz) in K]; unf; lra. }
  apply period_inj in Z. clear - Z. destruct (step i s) as [[? ?] ?], (step j s') as [[? ?] ?]. unfold zadd3, z30, zopp3 in *. injection Z as A B C. apply z3_eq; lia.
Qed.
End System.
