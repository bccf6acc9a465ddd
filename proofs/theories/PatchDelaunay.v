(** * Systems of patches: Delaunay

    The local condition behind each facet, for all cells that can be there.  An occupant of a
    patch that is a lateral triangle belongs to a join, which depends on the side of the next tile: all are tried.
    Numbers that belong to one patch are in units of 1/13824 = 1/24 1/576 here, so that cells in the
    wall coordinates of different sides have integers. *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Statement Tetrahedra Topology Domain Euclid Delaunay Transfer PatchStatement PatchChecker PatchGeometry PatchSoundness PatchHeights.
Import ListNotations.
Open Scope R_scope.

(** ** The checks *)
Definition enlarge (x : spot) : spot := Spot (zmul (zint 576) (height x)) (zmul (zint 576) (ahead x)) (zmul (zint 576) (aside x)).
(** From wall coordinates of side s, in units of 1/576, to coordinates of the patch in units of 1/13824. *)
Definition unwall (p : patch) (s : nat) (w : spot) : spot :=
  let u := vector p s in let A := enlarge (start (edge_at p s)) in
  Spot (zadd (height A) (zmul (zint 24) (height w)))
       (zadd (ahead A) (zsub (zmul (ahead w) (ahead u)) (zmul (aside w) (aside u))))
       (zadd (aside A) (zadd (zmul (ahead w) (aside u)) (zmul (aside w) (ahead u)))).
Definition map_corners (f : spot -> spot) (t : corners) : corners := let '(a, b, c, d) := t in (f a, f b, f c, f d).
Definition spot_vx (t : corners) (i : nat) : spot := let '(a, b, c, d) := t in match i with 0 => a | 1 => b | 2 => c | _ => d end%nat.
Definition spot_power_sum (t : corners) (x : spot) : zz := let '(a, b, c, d) := t in
  let term i v := zmul (on_side (spot_facet t i) x) (spot_dot (spot_sub v x) (spot_sub v x)) in
  zadd (zadd (term 0%nat a) (term 1%nat b)) (zadd (term 2%nat c) (term 3%nat d)).
Definition outside_ball (t : corners) (x : spot) : bool := let '(a, b, c, d) := t in
  zpos (spot_orient a b c d) && zpos (zsub (zint 0) (spot_power_sum t x)).

Section Check.
Variables (system : list patch) (h : hints).
Notation patch_at a := (patch_at system a).
(** The sides that a join can meet. *)
Definition all_sides : list (nat * nat) := flat_map (fun b => map (pair b) (seq 0 (side_count (patch_at b)))) (seq 0 (length system)).
Definition beyond_apex (p : patch) (s : nat) (ch : nat * nat) : spot := let q := patch_at (fst ch) in
  unwall p s (turn (wall q (snd ch) (apex (edge_at q (snd ch))))).
(** The cell of an occupant, with its vertex opposite to the triangle. *)
Definition cell_of (p : patch) (o : occupant) (ch : nat * nat) : corners := match o with
  | Facet k f => map_corners enlarge (corners_at p k)
  | Lateral s e => (beyond_apex p s ch, enlarge (rim_at p s e), enlarge (rim_at p s (next (rim_count p s) e)), enlarge (apex (edge_at p s))) end.
Definition opposite_of (p : patch) (o : occupant) (ch : nat * nat) : spot :=
  spot_vx (cell_of p o ch) (match o with Facet k f => f | Lateral s e => 0%nat end).
Definition choices (o : occupant) : list (nat * nat) := match o with Facet _ _ => [(0, 0)%nat] | Lateral _ _ => all_sides end.
Definition check_local (a : nat) (o : occupant) : bool := let p := patch_at a in match behind h a o with
  | Inner o' n => forallb (fun ch => forallb (fun ch' => outside_ball (cell_of p o ch) (lift (13824 * n) (opposite_of p o' ch'))) (choices o')) (choices o)
  | Wall s w => match o with
    | Facet k f => forallb (fun ch => let q := patch_at (fst ch) in let '(w', n) := wall_mate h a s (fst ch) (snd ch) w in
        match owner h (fst ch) (snd ch) w' with
        | Facet k' f' => outside_ball (map_corners (wall p s) (corners_at p k)) (lift (576 * n) (turn (wall q (snd ch) (spot_vx (corners_at q k') f'))))
        | Lateral _ _ => false end) all_sides
    | Lateral _ _ => false end end.
Definition check_axis (a s b s' : nat) : bool := let p := patch_at a in let q := patch_at b in let n := rim_count p s in
  forallb (fun e => outside_ball (join p s q s' e) (spot_vx (join p s q s' (next n e)) 2) && outside_ball (join p s q s' e) (spot_vx (join p s q s' (prev n e)) 1)) (seq 0 n).
Definition check_delaunay : bool := forallb (fun a => let p := patch_at a in
  forallb (check_local a) (occupants p) &&
  forallb (fun s => forallb (fun ch => check_axis a s (fst ch) (snd ch)) all_sides) (seq 0 (side_count p))) (seq 0 (length system)).
Lemma all_sides_In b s : (b < length system)%nat -> (s < side_count (patch_at b))%nat -> In (b, s) all_sides.
Proof. intros B S. apply in_flat_map. exists b. split; [apply in_seq; lia|]. apply in_map, in_seq. lia. Qed.
End Check.

(** ** Powers *)
Definition cartesian := Gram 1 1 1 0 0 0.
Lemma gdot_dot u v : gdot cartesian u v = dot u v.
Proof. unfold gdot, cartesian, dot; cbn. ring. Qed.
Lemma put_power c H o d t x : 0 < c -> fst d * fst d + snd d * snd d = 1 -> outside_ball t x = true ->
  0 < power cartesian (put_tet c H o d t) (put c H o d x).
Proof.
  intros C U. destruct t as [[[p q] r] s] eqn:T. unfold outside_ball. rewrite andb_true_iff. intros [V P]. apply zpos_ok in V, P.
  assert (V' : 0 < vol (put_tet c H o d t)).
  { rewrite T. change (0 < orient (put c H o d p) (put c H o d q) (put c H o d r) (put c H o d s)). rewrite put_orient by auto.
    rewrite surd_orient in V. apply Rmult_lt_0_compat; auto. apply c3, C. }
  rewrite <- T in *. apply Rmult_lt_reg_l with (vol (put_tet c H o d t)); auto. rewrite Rmult_0_r, power_power_sum by lra.
  unfold power_sum, sq. rewrite !gdot_dot, !put_coord by auto. rewrite T at 1 2 3 4 5 6 7 8.
  rewrite T in P. unfold spot_power_sum in P. rewrite surd_sub, surd_int, !surd_add, !surd_mul, !surd_dot, !val_sub in P.
  rewrite T. cbn [put_tet va vb vc vd]. rewrite !put_dot by auto.
  match type of P with 0 < 0 - ?g => match goal with |- 0 < - ?k => replace (- k) with (c * c * c * (c * c) * (0 - g)) by ring end end.
  apply Rmult_lt_0_compat; auto. apply Rmult_lt_0_compat; [apply c3, C|apply Rmult_lt_0_compat; auto].
Qed.
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
Variables (system : list patch) (h : hints).
Hypothesis checked : check_system system h = true.
Hypothesis delaunay_checked : check_delaunay system h = true.
Variables (tiles : nat -> tile) (rise : nat -> R).
Hypothesis tiling : mosaic system tiles.
Hypothesis agree : walls_agree system tiles rise.
Notation across_side := (across_side system tiles tiling).
Notation chosen := (across_chosen system tiles tiling).
Notation piece := (piece system tiles rise across_side).
Notation valid := (valid system tiles across_side).
Notation across := (across system h tiles rise across_side).
Notation resolve := (resolve system h tiles rise across_side).
Notation step := (step system tiles rise across_side).
Notation kind i := (shape (tiles i)).
Notation patch_of i := (patch_of system tiles i).
Notation patch_at a := (patch_at system a).
Notation corner_of i s := (corner_of system tiles i s).
Notation direction i s := (direction system tiles i s).
Notation wall_height i s := (wall_height system tiles rise i s).
Notation spec := (across_spec system h checked tiles rise tiling across_side chosen).
Notation turned := (frame_turn system tiles rise across_side chosen agree).
Notation kinds := (kind_lt system tiles tiling).
Definition in_patch i z (x : spot) : point := put (/ 13824) (rise i + z) (corner (tiles i)) (along (tiles i)) x.

Lemma delaunay_checks a : (a < length system)%nat ->
  (forall o, is_occupant (patch_at a) o = true -> check_local system h a o = true) /\
  forall s b s', (s < side_count (patch_at a))%nat -> (b < length system)%nat -> (s' < side_count (patch_at b))%nat -> check_axis system a s b s' = true.
Proof.
  intros Ha. pose proof delaunay_checked as C. unfold check_delaunay in C. rewrite forallb_forall in C.
  specialize (C a ltac:(apply in_seq; lia)). cbv zeta in C. rewrite andb_true_iff, !forallb_forall in C. destruct C as [C1 C2]. split.
  - intros o Ho. apply C1, occupants_In, Ho.
  - intros s b s' Hs Hb Hs'. specialize (C2 s ltac:(apply in_seq; lia)). rewrite forallb_forall in C2.
    apply (C2 (b, s')), all_sides_In; auto.
Qed.
Lemma in_patch_place i z x : in_patch i z (enlarge x) = place_at tiles rise i z x.
Proof. unfold in_patch, place_at, enlarge, put; cbn [height ahead aside]. surds. apply point_eq; cbn [px py pz]; field. Qed.
Lemma in_patch_frame i s z w : in_patch i z (unwall (patch_of i) s w) = frame system tiles rise i s z w.
Proof.
  unfold in_patch, frame. rewrite direction_value. cbv zeta. unfold PatchStatement.wall_height, PatchStatement.corner_of.
  change (PatchStatement.edge_of system tiles i s) with (edge_at (patch_of i) s).
  unfold unwall, enlarge, put; cbn [fst snd py pz height ahead aside]. surds. apply point_eq; cbn [px py pz]; field.
Qed.

(** The cell of a facet, by its occupant. *)
Lemma resolve_cell i o n : ok system tiles i o -> exists ch, In ch (choices system o) /\
  (forall y, power cartesian (piece (fst (resolve i o n))) y =
     power cartesian (put_tet (/ 13824) (rise i + IZR n) (corner (tiles i)) (along (tiles i)) (cell_of system (patch_of i) o ch)) y) /\
  vx (piece (fst (resolve i o n))) (snd (resolve i o n)) = in_patch i (IZR n) (opposite_of system (patch_of i) o ch).
Proof.
  destruct o as [k f|s e].
  - intros _. exists (0, 0)%nat. split; [cbn; auto|]. cbn [PatchSoundness.resolve fst snd PatchSoundness.piece cell_of].
    assert (E : put_tet (/ 24) (rise i + IZR n) (corner (tiles i)) (along (tiles i)) (corners_at (patch_of i) k) =
      put_tet (/ 13824) (rise i + IZR n) (corner (tiles i)) (along (tiles i)) (map_corners enlarge (corners_at (patch_of i) k))).
    { destruct (corners_at (patch_of i) k) as [[[a b] c] d]. cbn [map_corners put_tet].
      pose proof (in_patch_place i (IZR n)) as P. unfold in_patch, place_at in P. rewrite !P. reflexivity. }
    split; [intros y; rewrite E; reflexivity|]. rewrite E. unfold opposite_of, cell_of, in_patch.
    destruct (map_corners enlarge (corners_at (patch_of i) k)) as [[[a b] c] d]. destruct f as [|[|[|f]]]; reflexivity.
  - intros K. apply lateral_ok in K as [Hs He]. cbn [PatchSoundness.resolve]. destruct (across_side i s) as [j s'] eqn:E.
    destruct (spec i s j s' Hs E) as [Hs' [NE [E' _]]].
    destruct (rims system h checked tiles rise tiling across_side chosen i s j s' e Hs E He) as [R1 [R2 [R3 [R4 _]]]].
    exists (kind j, s'). split; [apply all_sides_In; [apply kinds|exact Hs']|].
    pose proof (fun x => frame_wall system h checked tiles rise tiling i s (IZR n) x Hs) as FW.
    pose proof (fun x => in_patch_frame i s (IZR n) x) as PF.
    assert (T : put_tet (/ 13824) (rise i + IZR n) (corner (tiles i)) (along (tiles i)) (cell_of system (patch_of i) (Lateral s e) (kind j, s')) =
      put_tet (/ 576) (wall_height i s + IZR n) (corner_of i s) (direction i s) (join (patch_of i) s (patch_of j) s' e)).
    { unfold cell_of, beyond_apex, join, put_tet; cbn [fst snd]. pose proof (in_patch_place i (IZR n)) as P.
      unfold in_patch, frame in *. rewrite !FW. rewrite PF, !P. reflexivity. }
    rewrite T. unfold opposite_of, cell_of, beyond_apex; cbn [fst snd spot_vx]. rewrite PF.
    destruct (Nat.ltb_spec i j); cbn [fst snd PatchSoundness.piece].
    + rewrite E. split; [reflexivity|]. reflexivity.
    + rewrite E'. pose proof (fun x => turned i s j s' (IZR n) x Hs E) as F. unfold frame in F |- *. rewrite <- plus_IZR in F.
      unfold join, put_tet. rewrite !F, !turn_turn, <- R3, <- R4. split; [intros y; apply power_reversed|reflexivity].
Qed.

Theorem local_condition c f : valid c -> In f I4 -> 0 < power cartesian (piece c) (Delaunay.behind cell piece across c f).
Proof.
  intros V F. unfold Delaunay.behind. assert (D : axial (c, f) \/ ~ axial (c, f)).
  { destruct c as [[i [k|s e]] n], f as [|[|[|f]]]; cbn; auto. }
  destruct D as [A|A].
  - destruct c as [[i [k|s e]] n]; [cbn in A; tauto|]. cbn [PatchSoundness.valid] in V. destruct V as [Hs [He L]].
    destruct (across_side i s) as [j s'] eqn:E. destruct (spec i s j s' Hs E) as [Hs' _].
    destruct (delaunay_checks (kind i) (kinds i)) as [_ K]. specialize (K s (kind j) s' Hs (kinds j) Hs').
    unfold check_axis in K. cbv zeta in K. rewrite forallb_forall in K. specialize (K e ltac:(apply in_seq; split; [lia|exact He])).
    apply andb_true_iff in K as [K1 K2].
    pose proof (direction_unit system h checked tiles tiling i s Hs) as DU.
    destruct f as [|[|[|f]]]; cbn in A; try tauto; cbn [PatchSoundness.across fst snd PatchSoundness.piece]; rewrite E.
    + apply (put_power (/ 576) (wall_height i s + IZR n) (corner_of i s) (direction i s)) in K1; auto; lra.
    + apply (put_power (/ 576) (wall_height i s + IZR n) (corner_of i s) (direction i s)) in K2; auto; lra.
  - destruct (view_spec system h checked tiles rise tiling across_side chosen agree c f V F A) as [i [o [n [K R]]]].
    rewrite <- R, (across_resolve system h checked tiles rise tiling across_side chosen agree i o n K).
    replace (piece c) with (piece (fst (resolve i o n))) by (rewrite R; reflexivity).
    destruct (delaunay_checks (kind i) (kinds i)) as [C _]. specialize (C o K). unfold check_local in C. cbv zeta in C.
    destruct (beyond_spec system h checked tiles rise tiling across_side chosen agree i o n K) as [i' [o' [n' [K' [B _]]]]].
    pose proof (along_unit system tiles tiling i) as U.
    unfold PatchSoundness.beyond in *. destruct (behind h (kind i) o) as [o2 m|s w] eqn:BH.
    + destruct (checks system h checked (kind i) (kinds i)) as [CO _]. specialize (CO o (occupants_In _ _ K)). unfold check_occupant in CO. cbv zeta in CO.
      rewrite BH, !andb_true_iff in CO. destruct CO as [[K2 _] _].
      destruct (resolve_cell i o n K) as [ch [Ich [P _]]]. destruct (resolve_cell i o2 (n + m)%Z K2) as [ch' [Ich' [_ X]]].
      rewrite P, X. rewrite forallb_forall in C. specialize (C ch Ich). rewrite forallb_forall in C. specialize (C ch' Ich').
      apply (put_power (/ 13824) (rise i + IZR n) (corner (tiles i)) (along (tiles i))) in C; auto; [|lra].
      rewrite put_lift in C. unfold in_patch. rewrite plus_IZR.
      replace (rise i + (IZR n + IZR m)) with (rise i + IZR n + / 13824 * IZR (13824 * m)) by (rewrite mult_IZR; field). exact C.
    + destruct o as [k f0|]; [|discriminate].
      destruct (checks system h checked (kind i) (kinds i)) as [CO _]. specialize (CO _ (occupants_In _ _ K)). unfold check_occupant in CO. cbv zeta in CO.
      rewrite BH, !andb_true_iff, !Nat.ltb_lt in CO. destruct CO as [[Hs Hw] _].
      destruct (across_side i s) as [j s'] eqn:E. destruct (spec i s j s' Hs E) as [Hs' _].
      rewrite forallb_forall in C. specialize (C (kind j, s') (all_sides_In system _ _ (kinds j) Hs')). cbn [fst snd] in C.
      destruct (wall_mate h (kind i) s (kind j) s' w) as [w' m]. destruct (owner h (kind j) s' w') as [k' f'|]; [|discriminate].
      cbn [PatchSoundness.resolve fst snd PatchSoundness.piece].
      pose proof (direction_unit system h checked tiles tiling i s Hs) as DU.
      apply (put_power (/ 576) (wall_height i s + IZR n) (corner_of i s) (direction i s)) in C; auto; [|lra].
      rewrite put_lift in C. replace (wall_height i s + IZR n + / 576 * IZR (576 * m)) with (wall_height i s + (IZR n + IZR m)) in C by (rewrite mult_IZR; field).
      pose proof (fun x => frame_wall system h checked tiles rise tiling i s (IZR n) x Hs) as FW. unfold frame, place_at in FW.
      pose proof (fun x => frame_wall system h checked tiles rise tiling j s' (IZR n + IZR m + IZR (step i s)) x Hs') as FW'. unfold place_at in FW'.
      pose proof (fun x => turned i s j s' (IZR n + IZR m) x Hs E) as FT. unfold frame in FT at 2.
      change (patch_at (kind i)) with (patch_of i) in *. change (patch_at (kind j)) with (patch_of j) in *.
      rewrite <- FT, FW' in C.
      replace (IZR (n + step i s + m)) with (IZR n + IZR m + IZR (step i s)) by (rewrite !plus_IZR; ring).
      destruct (corners_at (patch_of i) k) as [[[a b] c0] d]. cbn [map_corners put_tet] in *. rewrite !FW in C.
      destruct (corners_at (patch_of j) k') as [[[a' b'] c'] d']. destruct f' as [|[|[|f']]]; exact C.
Qed.

Theorem patches_delaunay : delaunay_cells (is_cell system tiles rise).
Proof.
  pose proof (is_cell_iff system h checked tiles rise tiling across_side chosen agree) as IFF.
  pose proof (piece_vol system h checked tiles rise tiling across_side chosen) as PV.
  pose proof (PatchSoundness.range system h checked tiles rise tiling across_side chosen agree) as RG.
  pose proof (mates_everywhere system h checked tiles rise tiling across_side chosen agree) as MT.
  pose proof (covered system h checked tiles rise tiling across_side chosen agree) as CV.
  intros t Ht. apply IFF in Ht as [c [V ->]]. pose proof (PV c V) as PC.
  exists (circumcentre (piece c)), (distance_squared (va (piece c)) (circumcentre (piece c))).
  pose proof (circumscribed_centre (piece c) ltac:(lra)) as CC. split; [exact CC|].
  intros v [t' [Ht' Hv]]. apply IFF in Ht' as [c' [V' ->]].
  pose proof (power_is_distance (piece c) _ _ v PC CC) as PD.
  assert (LC : forall d i, valid d -> In i I4 -> True -> 0 <= power cartesian (piece d) (Delaunay.behind cell piece across d i)).
  { intros d i Vd Hi _. left. apply local_condition; auto. }
  split.
  - pose proof (cells_weakly_delaunay cell cell_eq_dec piece valid (fun _ => True) (fun _ => True) across PV RG MT
      (fun _ _ _ _ => or_introl I) (fun _ _ _ _ _ _ => I) (fun _ _ _ _ => I) CV cartesian LC c c' v V V' Hv). lra.
  - intros EQ. apply (cells_delaunay cell cell_eq_dec piece valid (fun _ => True) (fun _ => True) across PV RG MT
      (fun _ _ _ _ => or_introl I) (fun _ _ _ _ _ _ => I) (fun _ _ _ _ => I) CV cartesian LC c c' v V V' Hv); [|lra].
    intros i Hi _. split; auto. apply local_condition; auto.
Qed.
End System.
