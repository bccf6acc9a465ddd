(** * Systems of patches: Delaunay

    The local condition behind each facet, for all cells that can be there.  A lateral triangle of a
    pyramid belongs to a join, whose other apex depends on the side of the next tile: all are tried. *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Statement Tetrahedra Topology Degree Domain Euclid Delaunay Transfer MosaicStatement MosaicPoints MosaicPatches MosaicSides MosaicTiling.
From Acutile Require Import Cells.
Import ListNotations.
Open Scope R_scope.

Definition cartesian := Gram 1 1 1 0 0 0.
Lemma gdot_dot u v : gdot cartesian u v = dot u v.
Proof. unfold gdot, cartesian, dot; cbn. ring. Qed.
Lemma power_reversed a b c d y : power cartesian (Tetrahedron d c b a) y = power cartesian (Tetrahedron a b c d) y.
Proof.
  unfold power, Delaunay.lift. cbn [va vb vc vd].
  replace (vol (Tetrahedron d c b a)) with (vol (Tetrahedron a b c d)) by (unfold vol; cbn [va vb vc vd]; unf; ring).
  replace (coord (Tetrahedron d c b a) 0 y) with (coord (Tetrahedron a b c d) 3 y) by (unfold coord, side, facet; cbn [va vb vc vd t1 t2 t3]; unf; ring).
  replace (coord (Tetrahedron d c b a) 1 y) with (coord (Tetrahedron a b c d) 2 y) by (unfold coord, side, facet; cbn [va vb vc vd t1 t2 t3]; unf; ring).
  replace (coord (Tetrahedron d c b a) 2 y) with (coord (Tetrahedron a b c d) 1 y) by (unfold coord, side, facet; cbn [va vb vc vd t1 t2 t3]; unf; ring).
  replace (coord (Tetrahedron d c b a) 3 y) with (coord (Tetrahedron a b c d) 0 y) by (unfold coord, side, facet; cbn [va vb vc vd t1 t2 t3]; unf; ring).
  f_equal. unfold Rdiv. f_equal. ring.
Qed.
(** The power is the squared distance to the centre minus the squared radius. *)
Lemma power_is_distance t C s x : 0 < vol t -> circumscribed t C s -> power cartesian t x = distance_squared x C - s.
Proof.
  intros V K. set (f := fun x => distance_squared x C - s - power cartesian t x).
  assert (A : affine f).
  { apply aff_ext with (f := fun x => (-1) * Delaunay.lift cartesian t x + (-2 * px C * px x + -2 * py C * py x + -2 * pz C * pz x + (dot C C - s))).
    - intros y. unfold f, power, sq, distance_squared. rewrite gdot_dot. unfold dot. unf. ring.
    - apply aff_add; [apply aff_scl, aff_lift|]. exists (-2 * px C), (-2 * py C), (-2 * pz C), (dot C C - s). intros. ring. }
  assert (Z : forall v, In v (verts t) -> f v = 0).
  { intros v Hv. unfold f. rewrite (K v Hv), (power_vertex cartesian t v) by (auto; lra). ring. }
  pose proof (interpolate t f x A) as E. rewrite (Z (va t)), (Z (vb t)), (Z (vc t)), (Z (vd t)) in E by (unfold verts; simpl; auto).
  assert (F : f x = 0). { apply Rmult_eq_reg_l with (vol t); [|lra]. rewrite E. ring. }
  unfold f in F. lra.
Qed.

Section System.
Variables (G : gram) (r : nat) (system : list patch) (h : hints).
Hypothesis OK : good G r system h.
Notation patch_at a := (nth a system (Patch [] [] [])).
Notation carry := (carry G r).
(** The apexes on the other side of a lateral triangle; its cell, and the vertex opposite to it. *)
Definition is_choice (a : nat) (o : occupant) (y : point) : Prop := match o with
  | Facet _ _ => True
  | Lateral q e => exists b s', (b < length system)%nat /\ (s' < sides (patch_at b))%nat /\ fits G r (patch_at a) (side_of h a q) (patch_at b) s' /\
      let '(q', m) := pyramid_mate h a q b s' in y = lift m (carry (patch_at a) (side_of h a q) (patch_at b) s' (apex_at (patch_at b) q')) end.
Definition lateral_cell (p : patch) (q e : nat) (y : point) := Tetrahedron y (rim_at p q e) (rim_at p q (next (rim_count p q) e)) (apex_at p q).
Definition cell_of (p : patch) (o : occupant) (y : point) : tetrahedron := match o with
  | Facet k f => piece_at p k | Lateral q e => lateral_cell p q e y end.
Definition opposite_of (p : patch) (o : occupant) (y : point) : point := match o with
  | Facet k f => vx (piece_at p k) f | Lateral q e => y end.
Variable strict : bool.
Definition outside (t : tetrahedron) (x : point) : Prop := if strict then 0 < power G t x else 0 <= power G t x.
Definition good_local (a : nat) (o : occupant) : Prop := let p := patch_at a in match behind h a o with
  | Inner o' n => forall y y', is_choice a o y -> is_choice a o' y' -> outside (cell_of p o y) (lift n (opposite_of p o' y'))
  | Wall s w => match o with
    | Facet k f => forall b s', (b < length system)%nat -> (s' < sides (patch_at b))%nat -> fits G r p s (patch_at b) s' ->
        let '(w', m) := wall_mate h a s b s' w in
        match owner h b s' w' with
        | Facet k' f' => outside (piece_at p k) (lift m (carry p s (patch_at b) s' (vx (piece_at (patch_at b) k') f')))
        | Lateral _ _ => True end
    | Lateral _ _ => True end end.
Definition good_axis (a q e : nat) : Prop := let p := patch_at a in let n := rim_count p q in
  forall y, is_choice a (Lateral q e) y -> outside (lateral_cell p q e y) (rim_at p q (next n (next n e))) /\ outside (lateral_cell p q e y) (rim_at p q (prev n e)).
Hypothesis LOCAL : forall a o, (a < length system)%nat -> is_occupant (patch_at a) o -> good_local a o.
Hypothesis AXES : forall a q e, (a < length system)%nat -> (q < length (pyramids (patch_at a)))%nat -> (e < rim_count (patch_at a) q)%nat -> good_axis a q e.

Variables (l1 l2 l3 : point).
Hypothesis basis : has_gram G l1 l2 l3.
Hypothesis right_handed : 0 < det l1 l2 l3.
Variable tiles : nat -> tile.
Hypothesis tiling : mosaic l1 l2 l3 G r system tiles.
Variable rise : nat -> point.
Hypothesis high : heights l1 l2 l3 r system tiles rise.
Notation kind i := (shape (tiles i)).
Notation patch_of i := (MosaicStatement.patch_of system tiles i).
Notation across_side := (across_side r system l1 l2 l3 tiles).
Notation wall i q := (side_of h (kind i) q).
Notation at_ := (at_ tiles rise).
Notation piece := (piece G r system h l1 l2 l3 tiles rise).
Notation valid := (valid r system h l1 l2 l3 tiles).
Notation resolve := (resolve r system h l1 l2 l3 tiles rise).
Notation across := (across r system h l1 l2 l3 tiles rise).
Notation ok := (ok system tiles).
Notation kinds := (kind_lt G r system l1 l2 l3 tiles tiling).
Notation across_spec := (across_spec G r system h OK l1 l2 l3 basis right_handed tiles tiling).
Notation pyramid_facts := (pyramid_facts G r system h OK l1 l2 l3 tiles tiling).
Notation mate_facts := (mate_facts G r system h OK l1 l2 l3 basis right_handed tiles tiling).
Notation frame_lift := (frame_lift G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation frame_back := (frame_back G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).

Lemma at_dot i n a b c d : dot (sub (at_ i n a) (at_ i n b)) (sub (at_ i n c) (at_ i n d)) = gdot G (sub a b) (sub c d).
Proof.
  destruct (motion G r system h OK l1 l2 l3 basis right_handed tiles tiling i) as [m2 [m3 [E [HG _]]]].
  rewrite <- (gram_dot G l1 m2 m3 _ _ HG). unfold MosaicSides.at_, MosaicStatement.spot, MosaicStatement.place. rewrite E.
  unfold MosaicPoints.lift, Euclid.E, at_coordinates. f_equal; apply point_eq; unf; ring.
Qed.
Lemma at_power i n t x : 0 < vol t -> power cartesian (map_tet (at_ i n) t) (at_ i n x) = power G t x.
Proof.
  intros V. pose proof (at_vol G r system h OK l1 l2 l3 basis right_handed tiles tiling rise i n t) as VE.
  assert (V' : 0 < vol (map_tet (at_ i n) t)) by (rewrite VE; apply Rmult_lt_0_compat; auto).
  apply Rmult_eq_reg_l with (vol (map_tet (at_ i n) t)); [|lra]. rewrite power_power_sum by lra. rewrite VE, Rmult_assoc, power_power_sum by lra.
  unfold power_sum, sq. rewrite !gdot_dot, !(at_coord G r system h OK l1 l2 l3 basis right_handed tiles tiling rise). cbn [map_tet va vb vc vd]. rewrite !at_dot. ring.
Qed.

(** The cell of a facet, by its occupant. *)
Lemma choice_across i q e j s' : (q < length (pyramids (patch_of i)))%nat -> across_side i (wall i q) = (j, s') ->
  let '(q', m) := pyramid_mate h (kind i) q (kind j) s' in is_choice (kind i) (Lateral q e) (lift m (carry (patch_of i) (wall i q) (patch_of j) s' (apex_at (patch_of j) q'))).
Proof.
  intros Hq E. destruct (pyramid_facts i q Hq) as [Hs _]. destruct (across_spec i _ j s' Hs E) as [Hs' [_ [_ FT]]].
  destruct (pyramid_mate h (kind i) q (kind j) s') as [q' m] eqn:PM. exists (kind j), s'. split; [apply kinds|]. split; [exact Hs'|]. split; [exact FT|].
  rewrite PM. reflexivity.
Qed.
Lemma resolve_cell i o n : ok i o -> latb r n = true -> exists y, is_choice (kind i) o y /\ 0 < vol (cell_of (patch_of i) o y) /\
  (forall z, power cartesian (piece (fst (resolve i o n))) z = power cartesian (map_tet (at_ i n) (cell_of (patch_of i) o y)) z) /\
  vx (piece (fst (resolve i o n))) (snd (resolve i o n)) = at_ i n (opposite_of (patch_of i) o y).
Proof.
  destruct o as [k f|q e]; intros [Hq He] L; cbn [MosaicTiling.resolve].
  - exists origin. split; [exact I|]. split; [apply (good_pieces _ _ _ _ OK); [apply kinds|exact Hq]|].
    cbn [fst snd MosaicTiling.piece cell_of opposite_of]. split; [reflexivity|]. apply vx_map.
  - destruct (pyramid_facts i q Hq) as [Hs _]. destruct (across_side i (wall i q)) as [j s'] eqn:E.
    destruct (across_spec i _ j s' Hs E) as [Hs' [NE [E' FT]]]. pose proof (mate_facts i q j s' Hq E) as M. pose proof (choice_across i q e j s' Hq E) as CH.
    destruct (pyramid_mate h (kind i) q (kind j) s') as [q' m] eqn:PM. destruct M as [Hq' [W [Lm [PM' [R _]]]]]. destruct (R e He) as [He' [RM [R3 [R4 JV]]]].
    eexists. split; [exact CH|]. unfold join in JV. rewrite PM in JV. split; [exact JV|].
    destruct (Nat.ltb_spec i j); cbn [fst snd MosaicTiling.piece]; unfold join_at.
    + rewrite E. unfold join. rewrite PM. split; reflexivity.
    + rewrite W, E'. unfold join. rewrite PM', W. change (patch_at (kind i)) with (patch_of i). change (patch_at (kind j)) with (patch_of j).
      cbn [cell_of opposite_of]. unfold lateral_cell, map_tet; cbn [va vb vc vd vx].
      rewrite (frame_back i _ j s') by auto. rewrite !(frame_lift i _ j s' n m) by auto. rewrite <- R3, <- R4. split; [|reflexivity].
      intros z. apply power_reversed.
Qed.

Theorem local_condition c f : valid c -> In f I4 -> if strict then 0 < power cartesian (piece c) (Delaunay.behind cell piece across c f) else 0 <= power cartesian (piece c) (Delaunay.behind cell piece across c f).
Proof.
  intros V F. unfold Delaunay.behind. assert (D : axial (c, f) \/ ~ axial (c, f)).
  { destruct c as [[i [k|s e]] n], f as [|[|[|f]]]; cbn; auto. }
  destruct D as [A|A].
  - destruct c as [[i [k|q e]] n]; [cbn in A; tauto|]. cbn [MosaicTiling.valid] in V. destruct V as [L [Hq [He I]]].
    pose proof (AXES (kind i) q e (kinds i) Hq He) as AX. unfold good_axis in AX. cbv zeta in AX.
    destruct (across_side i (wall i q)) as [j s'] eqn:E. pose proof (mate_facts i q j s' Hq E) as M. pose proof (choice_across i q e j s' Hq E) as CH.
    destruct (pyramid_mate h (kind i) q (kind j) s') as [q' m] eqn:PM. destruct M as [_ [_ [_ [_ [R _]]]]]. destruct (R e He) as [_ [_ [_ [_ JV]]]].
    unfold join in JV. rewrite PM in JV. destruct (AX _ CH) as [AX1 AX2]. unfold outside, lateral_cell in AX1, AX2.
    destruct f as [|[|[|f]]]; cbn in A; try tauto; cbn [MosaicTiling.across fst snd MosaicTiling.piece]; unfold join_at; rewrite E; unfold join; rewrite PM;
    rewrite vx_map; cbn [vx va vb vc vd]; change (patch_at (kind i)) with (patch_of i) in *; (rewrite at_power by exact JV); assumption.
  - destruct (view_spec G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high c f V F A) as [i [o [n [K [L R]]]]].
    rewrite <- R, (across_resolve G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high i o n K L).
    replace (piece c) with (piece (fst (resolve i o n))) by (rewrite R; reflexivity).
    pose proof (LOCAL (kind i) o (kinds i) K) as C. unfold good_local in C. cbv zeta in C.
    pose proof (good_occupants _ _ _ _ OK (kind i) o (kinds i) K) as CO. unfold good_occupant in CO. cbv zeta in CO.
    unfold MosaicTiling.beyond. destruct (MosaicPatches.behind h (kind i) o) as [o2 m|s w] eqn:BH.
    + destruct CO as [K2 [Lm _]].
      destruct (resolve_cell i o n K L) as [y [CH [VO [P _]]]]. destruct (resolve_cell i o2 (zadd3 n m) K2 ltac:(auto using latb_add)) as [y' [CH' [_ [_ X]]]].
      rewrite P, X. rewrite <- (at_lift tiles rise i n m). rewrite at_power by exact VO. exact (C y y' CH CH').
    + destruct (good_wall_facets _ _ _ _ OK (kind i) o s w (kinds i) K BH) as [k [f0 ->]]. destruct CO as [Hs [Hw _]].
      destruct (across_side i s) as [j s'] eqn:E. destruct (across_spec i s j s' Hs E) as [Hs' [_ [_ FT]]].
      specialize (C (kind j) s' (kinds j) Hs' FT).
      destruct (good_pairs _ _ _ _ OK (kind i) s (kind j) s' (kinds i) (kinds j) Hs Hs' FT) as [_ P]. specialize (P w Hw).
      destruct (wall_mate h (kind i) s (kind j) s' w) as [w' m] eqn:WM. destruct P as [Hw' [Lm _]].
      destruct (good_walls _ _ _ _ OK (kind j) s' w' (kinds j) Hs' Hw') as [W1 W3].
      destruct (good_wall_facets _ _ _ _ OK (kind j) _ s' w' (kinds j) W1 W3) as [k' [f' EW]]. rewrite EW in *.
      cbn [MosaicTiling.resolve fst snd MosaicTiling.piece]. rewrite vx_map, (frame_lift i s j s' n m) by auto.
      destruct K as [Hk _]. rewrite at_power by (apply (good_pieces _ _ _ _ OK); [apply kinds|exact Hk]). exact C.
Qed.
Lemma local_weak c f : valid c -> In f I4 -> 0 <= power cartesian (piece c) (Delaunay.behind cell piece across c f).
Proof. intros V F. pose proof (local_condition c f V F) as L. destruct strict; lra. Qed.

Notation IFF := (is_cell_iff G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation PV := (piece_vol G r system h OK l1 l2 l3 basis right_handed tiles tiling rise).
Notation RG := (MosaicTiling.range G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation MT := (mates_everywhere G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation CV := (covered G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Theorem mosaic_weakly_delaunay : weakly_delaunay_cells (is_cell l1 l2 l3 r system tiles rise).
Proof.
  intros t Ht. apply IFF in Ht as [c [V ->]]. pose proof (PV c V) as PC.
  exists (circumcentre (piece c)), (distance_squared (va (piece c)) (circumcentre (piece c))).
  pose proof (circumscribed_centre (piece c) ltac:(lra)) as CC. split; [exact CC|].
  intros v [t' [Ht' Hv]]. apply IFF in Ht' as [c' [V' ->]].
  pose proof (power_is_distance (piece c) _ _ v PC CC) as PD.
  pose proof (cells_weakly_delaunay cell cell_eq_dec piece valid (fun _ => True) (fun _ => True) across PV RG MT
    (fun _ _ _ _ => or_introl I) (fun _ _ _ _ _ _ => I) (fun _ _ _ _ => I) CV cartesian (fun d i Vd Hi _ => local_weak d i Vd Hi) c c' v V V' Hv). lra.
Qed.
Theorem mosaic_delaunay : strict = true -> delaunay_cells (is_cell l1 l2 l3 r system tiles rise).
Proof.
  intros ST t Ht. apply IFF in Ht as [c [V ->]]. pose proof (PV c V) as PC.
  exists (circumcentre (piece c)), (distance_squared (va (piece c)) (circumcentre (piece c))).
  pose proof (circumscribed_centre (piece c) ltac:(lra)) as CC. split; [exact CC|].
  intros v [t' [Ht' Hv]]. apply IFF in Ht' as [c' [V' ->]].
  pose proof (power_is_distance (piece c) _ _ v PC CC) as PD.
  split.
  - pose proof (cells_weakly_delaunay cell cell_eq_dec piece valid (fun _ => True) (fun _ => True) across PV RG MT
      (fun _ _ _ _ => or_introl I) (fun _ _ _ _ _ _ => I) (fun _ _ _ _ => I) CV cartesian (fun d i Vd Hi _ => local_weak d i Vd Hi) c c' v V V' Hv). lra.
  - intros EQ. apply (cells_delaunay cell cell_eq_dec piece valid (fun _ => True) (fun _ => True) across PV RG MT
      (fun _ _ _ _ => or_introl I) (fun _ _ _ _ _ _ => I) (fun _ _ _ _ => I) CV cartesian (fun d i Vd Hi _ => local_weak d i Vd Hi) c c' v V V' Hv); [|lra].
    intros i Hi _. split; auto. pose proof (local_condition c i V Hi) as L. rewrite ST in L. exact L.
Qed.
End System.
