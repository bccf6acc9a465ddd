(** * Systems of patches: the finite checks imply the statements

    Delaunay statements follow from MosaicDelaunay.v.  Statements about single cells are those of Checker.v, for each cell as a
    certificate of its own. *)
Require Import Reals Lra Psatz NArith ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Domain Bounds Angles Euclid Transfer Delaunay Checker Soundness
  MosaicStatement MosaicPoints MosaicPatches MosaicSides MosaicTiling MosaicDelaunay MosaicChecker MosaicSpots MosaicSoundness.
Import ListNotations.
Local Open Scope R_scope.

Section Ring.
Variables (A : Type) (aadd asub amul : A -> A -> A) (aofZ : Z -> A) (alt ale : A -> A -> bool).
Variables (content : list A -> Z) (quot : Z -> A -> A).
Variable phi : A -> R.
Hypothesis phi_add : forall x y, phi (aadd x y) = (phi x + phi y)%R.
Hypothesis phi_sub : forall x y, phi (asub x y) = (phi x - phi y)%R.
Hypothesis phi_mul : forall x y, phi (amul x y) = (phi x * phi y)%R.
Hypothesis phi_Z : forall z, phi (aofZ z) = IZR z.
Hypothesis alt_ok : forall x y, alt x y = true -> (phi x < phi y)%R.
Hypothesis ale_ok : forall x y, ale x y = true -> (phi x <= phi y)%R.
Variables (g : kgram A) (r : nat).
Hypothesis rank : r = 1%nat \/ r = 2%nat.
Variables (system : list (MosaicChecker.kpatch A)) (h : hints) (apexes : nat -> nat -> list (MosaicChecker.spot A)) (home : nat -> nat * MosaicChecker.spot A).
Hypothesis CHECKED : check_system A aadd asub amul aofZ alt ale content quot g r system h apexes home = true.
Notation rp := (MosaicSpots.rp A phi).
Notation pos := (MosaicSpots.pos A phi).
Notation rtet := (MosaicSpots.rtet A phi).
Notation rpatch := (MosaicSpots.rpatch A phi).
Notation phi_zero := (MosaicSpots.phi_zero A aofZ phi phi_Z).
Notation lift_pos := (MosaicSpots.lift_pos A aadd amul aofZ phi).
Notation lift_ok := (MosaicSpots.lift_ok A aadd amul aofZ phi phi_add phi_mul phi_Z).
Notation tet_pos := (MosaicSpots.tet_pos A phi).
Notation tet_of_ok := (MosaicSpots.tet_of_ok A amul aofZ ale phi phi_mul ale_ok).
Notation tet_and_ok := (MosaicSpots.tet_and_ok A amul aofZ ale phi phi_mul ale_ok).
Notation positive_tet_ok := (MosaicSpots.positive_tet_ok A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok).
Notation sides_ok := (MosaicSpots.sides_ok A phi).
Notation rim_count_ok := (MosaicSpots.rim_count_ok A aofZ phi phi_Z).
Notation rim_ok := (MosaicSpots.rim_ok A aofZ phi phi_Z).
Notation piece_ok := (MosaicSpots.piece_ok A aofZ phi phi_Z).
Notation occupant_ok := (MosaicSpots.occupant_ok A aofZ phi phi_Z).
Notation occupants_In := (MosaicSpots.occupants_In A aofZ phi phi_Z r rank).
Notation patch_ok := (MosaicSoundness.patch_ok A phi system).
Notation positive_ok := (MosaicSoundness.positive_ok A aadd asub amul aofZ alt ale content quot phi phi_Z alt_ok g r system h apexes home CHECKED).
Notation join_pos := (MosaicSoundness.join_pos A aadd asub amul aofZ alt ale content quot phi phi_Z alt_ok g r system h apexes home CHECKED).
Notation lateral_ok := (MosaicSoundness.lateral_ok A aofZ phi phi_Z).
Notation fits_meet := (MosaicSoundness.fits_meet A aofZ phi phi_Z g r system).
Notation pair_fits := (MosaicSoundness.pair_fits A aadd asub amul aofZ alt ale content quot phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok g r rank system h apexes home CHECKED).
Notation choice_ok := (MosaicSoundness.choice_ok A aadd asub amul aofZ alt ale content quot phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok g r rank system h apexes home CHECKED).
Notation pyramids_length := (MosaicSoundness.pyramids_length A phi system).
Notation pieces_length := (MosaicSoundness.pieces_length A phi system).
Notation sides_length := (MosaicSoundness.sides_length A phi system).
Notation pyramid_checked := (MosaicSoundness.pyramid_checked A aadd asub amul aofZ alt ale content quot phi g r system h apexes home CHECKED).
Notation system_good := (MosaicSoundness.system_good A aadd asub amul aofZ alt ale content quot phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok g r rank system h apexes home CHECKED).
Notation phi3 := (phi3 A phi).
Notation phiT := (phiT A phi).
Notation phiG := (phiG A phi).
Notation no_spot := (MosaicChecker.no_spot A aofZ).
Notation corners := (MosaicChecker.corners A).
Notation k_sides := (MosaicChecker.k_sides A).
Notation k_piece := (MosaicChecker.k_piece A aofZ).
Notation k_occupant := (MosaicChecker.k_occupant A aofZ).
Notation tet_of := (MosaicChecker.tet_of A amul aofZ ale).
Notation tet_and := (MosaicChecker.tet_and A amul aofZ ale).
Notation G := (phiG g).
Notation k_patch := (MosaicChecker.k_patch A system).
Notation rsystem := (map rpatch system).
Notation patch_at a := (nth a rsystem (Patch [] [] [])).
Notation lateral := (MosaicChecker.lateral A aofZ).

(** ** Delaunay *)
Notation choices := (MosaicChecker.choices A aofZ apexes).
Notation k_cell := (MosaicChecker.k_cell A aofZ).
Notation k_opposite := (MosaicChecker.k_opposite A aofZ).
Notation outside_ball := (MosaicChecker.outside_ball A aadd asub amul aofZ ale g).
Lemma scale_gdot k u v : gdot G (scale k u) (scale k v) = k * k * gdot G u v.
Proof. unfold gdot. unf. ring. Qed.
Lemma scale_power k t x : power_sum G (map_tet (scale k) t) (scale k x) = k * k * k * (k * k) * power_sum G t x.
Proof.
  unfold power_sum, sq. cbn [map_tet va vb vc vd]. rewrite !scale_coord.
  assert (S : forall a b, sub (scale k a) (scale k b) = scale k (sub a b)) by (intros; apply point_eq; unf; ring).
  rewrite !S, !scale_gdot. ring.
Qed.
Lemma outside_ok (less : A -> A -> bool) (strict : bool) t x : (forall a b, less a b = true -> if strict then phi a < phi b else phi a <= phi b) ->
  tet_pos t -> pos x -> 0 < vol (rtet t) -> outside_ball less t x = true -> outside G strict (rtet t) (rp x).
Proof.
  intros LE P X V. destruct (tet_and_ok t x P X) as [k [K [E1 E2]]]. unfold MosaicChecker.outside_ball. destruct (tet_and t x) as [t' y]; cbn [fst snd] in *. intros H. apply LE in H.
  rewrite phi_zero, (phi_power A aadd asub amul phi phi_add phi_sub phi_mul), E1, E2, scale_power in H.
  pose proof (power_power_sum G (rtet t) (rp x) ltac:(lra)) as PP. assert (C : 0 < k * k * k * (k * k)) by (repeat apply Rmult_lt_0_compat; auto).
  unfold outside. destruct strict.
  - assert (power_sum G (rtet t) (rp x) < 0) by nra. apply Rmult_lt_reg_l with (vol (rtet t)); auto. rewrite PP. lra.
  - assert (power_sum G (rtet t) (rp x) <= 0) by nra. apply Rmult_le_reg_l with (vol (rtet t)); auto. rewrite PP. lra.
Qed.
Section Local.
Variables (less : A -> A -> bool) (strict : bool).
Hypothesis LESS : forall a b, less a b = true -> if strict then phi a < phi b else phi a <= phi b.
Hypothesis DEL : check_delaunay A aadd asub amul aofZ ale content quot g r system h apexes less = true.
Lemma cell_facts a o y : (a < length rsystem)%nat -> k_occupant (k_patch a) o = true -> In y (choices a o) ->
  tet_pos (k_cell (k_patch a) o y) /\ pos (k_opposite (k_patch a) o y) /\ 0 < vol (rtet (k_cell (k_patch a) o y)) /\
  rtet (k_cell (k_patch a) o y) = cell_of (rpatch (k_patch a)) o (rp y) /\ rp (k_opposite (k_patch a) o y) = opposite_of (rpatch (k_patch a)) o (rp y).
Proof.
  intros Ha Ho Hy. destruct (positive_ok a Ha) as [PP PY]. destruct o as [k f|q e]; cbn [MosaicChecker.k_occupant] in Ho; rewrite andb_true_iff, !Nat.ltb_lt in Ho; destruct Ho as [H1 H2];
  cbn [MosaicChecker.k_cell MosaicChecker.k_opposite cell_of opposite_of MosaicChecker.choices] in *.
  - destruct PP as [_ [_ [_ PT]]]. specialize (PT k). rewrite piece_ok. split; [exact PT|].
    pose proof (good_pieces _ _ _ _ system_good a k Ha ltac:(rewrite pieces_length; exact H1)) as [V _]. rewrite patch_ok, piece_ok in V.
    unfold tet_pos in PT. rewrite Forall_forall in PT. destruct (k_piece (k_patch a) k) as [[[x1 x2] x3] x4].
    split; [destruct f as [|[|[|f]]]; cbn [k_corner]; apply PT; cbn; auto|]. split; [exact V|]. split; [reflexivity|]. destruct f as [|[|[|f]]]; reflexivity.
  - split; [apply join_pos; auto|]. split; [eapply PY; eauto|]. split; [|split; [apply lateral_ok|reflexivity]].
    destruct (pyramid_checked a q Ha H1) as [_ C]. unfold check_joins in C. cbv zeta in C. rewrite forallb_forall in C. specialize (C y Hy). apply andb_true_iff in C as [C _].
    apply positive_tet_ok; [apply join_pos; auto|]. apply (upto_ok _ _ C e H2).
Qed.
Lemma side_lt a q : (a < length rsystem)%nat -> (q < length (k_pyramids A (k_patch a)))%nat -> (side_of h a q < k_sides (k_patch a))%nat.
Proof. intros Ha Hq. pose proof (good_pyramids _ _ _ _ system_good a q Ha ltac:(rewrite pyramids_length; exact Hq)) as [K _]. rewrite sides_length in K. exact K. Qed.
Lemma choice_in a o y : (a < length rsystem)%nat -> k_occupant (k_patch a) o = true -> is_choice G r rsystem h a o y -> exists y', In y' (choices a o) /\
  cell_of (rpatch (k_patch a)) o y = cell_of (rpatch (k_patch a)) o (rp y') /\ opposite_of (rpatch (k_patch a)) o y = opposite_of (rpatch (k_patch a)) o (rp y').
Proof.
  intros Ha Ho. destruct o as [k f|q e]; cbn [is_choice MosaicChecker.choices cell_of opposite_of].
  - intros _. exists no_spot. split; [cbn; auto|]. split; reflexivity.
  - intros [b [s' [Hb [Hs' [FT K]]]]]. cbn [MosaicChecker.k_occupant] in Ho. rewrite andb_true_iff, !Nat.ltb_lt in Ho. destruct Ho as [Hq He]. rewrite sides_length in Hs'.
    pose proof (choice_ok a q b s' Ha Hb Hq (side_lt a q Ha Hq) Hs' FT) as CH. destruct (pyramid_mate h a q b s') as [q' m]. destruct CH as [y' [Hy' E]]. exists y'. split; auto.
    rewrite K, E. auto.
Qed.
Lemma local_ok a o : (a < length rsystem)%nat -> is_occupant (patch_at a) o -> good_local G r rsystem h strict a o.
Proof.
  intros Ha Ho. rewrite patch_ok in Ho. pose proof Ho as Ho'. apply occupant_ok in Ho'. pose proof (upto_ok _ _ DEL a ltac:(rewrite map_length in Ha; exact Ha)) as C. cbv zeta in C. apply andb_true_iff in C as [C _].
  rewrite forallb_forall in C. specialize (C o (occupants_In _ _ Ho)). unfold check_local in C. cbv zeta in C. unfold good_local. cbv zeta. rewrite patch_ok.
  pose proof (good_occupants _ _ _ _ system_good a o Ha ltac:(rewrite patch_ok; exact Ho)) as GO. unfold good_occupant in GO. cbv zeta in GO. rewrite patch_ok in GO.
  destruct (behind h a o) as [o' n|s w].
  - destruct GO as [GO [L _]]. apply occupant_ok in GO. intros y y' CH CH'. destruct (choice_in a o y Ha Ho' CH) as [z [Hz [E1 _]]]. destruct (choice_in a o' y' Ha GO CH') as [z' [Hz' [_ E2]]].
    rewrite E1, E2. destruct (cell_facts a o z Ha Ho' Hz) as [F1 [_ [F2 [F3 _]]]]. destruct (cell_facts a o' z' Ha GO Hz') as [_ [F4 [_ [_ F5]]]].
    rewrite <- F3, <- F5, <- lift_ok by auto. rewrite forallb_forall in C. specialize (C z Hz). rewrite forallb_forall in C. apply (outside_ok less); auto using lift_pos.
  - destruct o as [k f|]; [|exact I]. destruct GO as [Hs [Hw _]]. rewrite sides_ok in Hs. intros b s' Hb Hs' FT. rewrite sides_length in Hs'.
    pose proof (fits_meet a s b s' ltac:(rewrite patch_ok; exact FT)) as CM. destruct (pair_fits a s b s' Ha Hb Hs Hs' CM) as [_ CO]. rewrite patch_ok in CO.
    pose proof (good_pairs _ _ _ _ system_good a s b s' Ha Hb ltac:(rewrite sides_length; exact Hs) ltac:(rewrite sides_length; exact Hs') ltac:(rewrite patch_ok; exact FT)) as [_ GP].
    specialize (GP w Hw). pose proof (upto_ok _ _ C b ltac:(rewrite map_length in Hb; exact Hb)) as C2. cbv zeta in C2. pose proof (upto_ok _ _ C2 s' Hs') as C3. cbv beta in C3. rewrite CM in C3.
    destruct (wall_mate h a s b s' w) as [w' m]. destruct GP as [Hw' _]. destruct (good_walls _ _ _ _ system_good b s' w' Hb ltac:(rewrite sides_length; exact Hs') Hw') as [GW _]. rewrite patch_ok in GW.
    destruct (owner h b s' w') as [k' f'|]; [|exact I]. apply occupant_ok in GW.
    destruct (cell_facts b (Facet k' f') no_spot Hb GW ltac:(cbn; auto)) as [_ [F4 [_ [_ F5]]]]. destruct (cell_facts a (Facet k f) no_spot Ha Ho' ltac:(cbn; auto)) as [F1 [_ [F2 [F3 _]]]].
    cbn [MosaicChecker.k_cell MosaicChecker.k_opposite cell_of opposite_of] in *. destruct (CO _ F4) as [P E]. rewrite patch_ok in E |- *. rewrite F5 in E.
    rewrite <- F3, <- E, <- lift_ok by auto. apply (outside_ok less); auto using lift_pos.
Qed.
Lemma axis_ok a q e : (a < length rsystem)%nat -> (q < length (pyramids (patch_at a)))%nat -> (e < rim_count (patch_at a) q)%nat -> good_axis G r rsystem h strict a q e.
Proof.
  intros Ha Hq He. rewrite pyramids_length in Hq. rewrite patch_ok, rim_count_ok in He. pose proof (upto_ok _ _ DEL a ltac:(rewrite map_length in Ha; exact Ha)) as C. cbv zeta in C. apply andb_true_iff in C as [_ C].
  pose proof (upto_ok _ _ C q Hq) as K. unfold check_axes in K. cbv zeta in K. rewrite forallb_forall in K. unfold good_axis. cbv zeta. intros y CH.
  assert (Ho : k_occupant (k_patch a) (Lateral q e) = true) by (cbn [MosaicChecker.k_occupant]; rewrite andb_true_iff, !Nat.ltb_lt; auto).
  destruct (choice_in a (Lateral q e) y Ha Ho CH) as [z [Hz [_ E]]]. cbn [opposite_of MosaicChecker.choices] in E, Hz. subst y.
  destruct (cell_facts a (Lateral q e) z Ha Ho Hz) as [F1 [_ [F2 [F3 _]]]]. cbn [MosaicChecker.k_cell cell_of] in F1, F2, F3.
  pose proof (upto_ok _ _ (K z Hz) e He) as K2. cbv beta in K2. apply andb_true_iff in K2 as [K3 K4]. rewrite patch_ok, rim_count_ok, !rim_ok, <- F3. destruct (positive_ok a Ha) as [[_ [_ [PR _]]] _].
  split; apply (outside_ok less); auto.
Qed.
End Local.

(** ** Single cells *)
Definition moved (k : R) (u x : point) : point := add (scale k x) u.
Lemma moved_sub k u x y : sub (moved k u x) (moved k u y) = scale k (sub x y).
Proof. unfold moved. apply point_eq; unf; ring. Qed.
Lemma scale_dot k u v : dot (scale k u) (scale k v) = k * k * dot u v.
Proof. unfold dot. unf. ring. Qed.
Lemma scale_quotient c a b : c <> 0 -> c * a / (c * b) = a / b.
Proof.
  intros K. unfold Rdiv. rewrite Rinv_mult. replace (c * a * (/ c * / b)) with (c * / c * (a * / b)) by ring. rewrite Rinv_r by auto. ring.
Qed.
Lemma moved_dihedral k u a b c d : 0 < k -> dihedral (moved k u a) (moved k u b) (moved k u c) (moved k u d) = dihedral a b c d.
Proof.
  intros K. assert (K2 : k * k <> 0) by (apply Rmult_integral_contrapositive_currified; lra).
  assert (P : forall e v, perp (scale k e) (scale k v) = scale k (perp e v)).
  { intros e v. unfold perp. rewrite !scale_dot, scale_quotient by auto. apply point_eq; unf; ring. }
  assert (N : forall v, norm (scale k v) = k * norm v).
  { intros v. unfold norm. rewrite scale_dot, sqrt_mult_alt by nra. rewrite sqrt_square by lra. reflexivity. }
  assert (AN : forall v w, angle (scale k v) (scale k w) = angle v w).
  { intros v w. unfold angle. f_equal. rewrite scale_dot, !N. replace (k * norm v * (k * norm w)) with (k * k * (norm v * norm w)) by ring. apply scale_quotient, K2. }
  unfold dihedral. rewrite !moved_sub, !P. apply AN.
Qed.
Lemma moved_dihedrals k u t : 0 < k -> dihedrals (map_tet (moved k u) t) = dihedrals t.
Proof. intros K. unfold dihedrals, map_tet; cbn [va vb vc vd]. rewrite !moved_dihedral by auto. reflexivity. Qed.
Lemma moved_ratio k u t q : 0 < k -> squared_ratio (map_tet (moved k u) t) q -> squared_ratio t q.
Proof.
  intros K [C [s [l [HC [[I U] ->]]]]]. assert (K2 : 0 < k * k) by (apply Rmult_lt_0_compat; auto). set (C' := scale (/ k) (sub C u)).
  assert (CE : C = moved k u C') by (unfold C', moved; apply point_eq; unf; field; lra).
  clearbody C'. subst C.
  assert (D : forall x y, distance_squared (moved k u x) (moved k u y) = k * k * distance_squared x y) by (intros; unfold distance_squared; rewrite moved_sub, scale_dot; reflexivity).
  assert (SE : squared_edges (map_tet (moved k u) t) = map (Rmult (k * k)) (squared_edges t)).
  { unfold squared_edges, map_tet; cbn [va vb vc vd map]. rewrite !D. reflexivity. }
  rewrite SE in I, U. apply in_map_iff in I as [l' [<- I]]. exists C', (s / (k * k)), l'. split; [|split].
  - intros v Hv. specialize (HC (moved k u v)). rewrite D in HC. apply Rmult_eq_reg_l with (k * k); [|lra]. rewrite HC; [field; lra|].
    unfold verts, map_tet in *; cbn [va vb vc vd In] in *. intuition (subst; auto).
  - split; [exact I|]. intros x Hx. apply Rmult_le_reg_l with (k * k); auto. apply U, in_map, Hx.
  - unfold Rdiv. rewrite Rinv_mult. ring.
Qed.

Section Alone.
Variables (l1 m2 m3 : point).
Hypothesis HG : has_gram G l1 m2 m3.
Variables (kt : corners) (i0 : point).
Hypothesis P : tet_pos kt.
(** The cell in space, from an origin. *)
Definition in_space : tetrahedron := map_tet (fun x => add i0 (at_coordinates l1 m2 m3 x)) (rtet kt).
Notation alone := (MosaicChecker.alone A g).
Notation c := (alone (tet_of kt)).
Hypothesis VOL : forallb (chk_vol A aadd asub amul aofZ alt) (positions A aadd aofZ c) = true.
Hypothesis GRAM : chk_gram A aadd asub amul aofZ alt g = true.
Lemma alone_based : based A aadd asub amul aofZ alt c.
Proof.
  split; [reflexivity|]. split; [|exact GRAM]. intros t Ht. rewrite forallb_forall in VOL. apply VOL. unfold positions. apply in_map, Ht.
Qed.
Lemma alone_tile n : is_tile 0 1 n -> exists k u, 0 < k /\ Statement.tile l1 m2 m3 (cP A aadd aofZ phi c l1 m2 m3) n = map_tet (moved k u) in_space.
Proof.
  destruct n as [j [[x y] z]]. intros [J [-> [-> ->]]]. cbn [fst] in J. replace j with 0%nat by lia.
  destruct (tet_of_ok kt P) as [k [K E]]. exists k, (scale (- k) i0). split; [exact K|].
  unfold Statement.tile, cP, Pk, cT. cbn [fst snd nth_error MosaicChecker.alone c_tets c_den c_verts].
  assert (PP : phiT (kpos A aadd aofZ 1 (kverts A (tet_of kt)) (CT (0%N, z30) (1%N, z30) (2%N, z30) (3%N, z30) None None None None)) = phiT (tet_of kt)).
  { unfold Soundness.phiT, kpos, Checker.pos; cbn [ka kb kc kd q0 q1 q2 q3 fst snd N.to_nat Pos.to_nat Pos.iter_op Nat.add nth kverts].
    assert (Z : forall v, phi3 (vadd A aadd v (vofZ A aofZ 1 z30)) = phi3 v).
    { intros v. rewrite (phi3_add A aadd phi phi_add), (phi3_ofZ A aofZ phi phi_Z). unfold vec, z30. apply point_eq; unf; ring. }
    rewrite !Z. reflexivity. }
  rewrite PP, E. unfold in_space, Et, translate, map_tet, moved, Euclid.E, lattice_vector, at_coordinates; cbn [va vb vc vd]. f_equal; apply point_eq; unf; field.
Qed.
Definition quantity (Q : tetrahedron -> R -> Prop) : Prop := forall k u t q, 0 < k -> Q (map_tet (moved k u) t) q -> Q t q.
Definition satisfies (Q : tetrahedron -> R -> Prop) (rel : relation) (B : R) (t : tetrahedron) : Prop := match rel with
  | LessThan => exists q, Q t q /\ q < B | AtMost => exists q, Q t q /\ q <= B | MoreThan => exists q, Q t q /\ B < q | AtLeast => exists q, Q t q /\ B <= q
  | Maximum | Minimum => Q t B end.
Lemma alone_bounded Q rel B : quantity Q -> bounded (is_tile 0 1) (fun n => Q (Statement.tile l1 m2 m3 (cP A aadd aofZ phi c l1 m2 m3) n)) rel B -> satisfies Q rel B in_space.
Proof.
  intros QI H. assert (T0 : is_tile 0 1 (0%nat, z30)) by (split; [cbn; lia|cbn; auto]).
  assert (EV : forall ok, every (is_tile 0 1) (fun n => Q (Statement.tile l1 m2 m3 (cP A aadd aofZ phi c l1 m2 m3) n)) ok -> exists q, Q in_space q /\ ok q).
  { intros ok E. destruct (E _ T0) as [q [Hq O]]. destruct (alone_tile _ T0) as [k [u [K T]]]. rewrite T in Hq. exists q. split; auto. apply (QI k u); auto. }
  assert (RE : reached (is_tile 0 1) (fun n => Q (Statement.tile l1 m2 m3 (cP A aadd aofZ phi c l1 m2 m3) n)) B -> Q in_space B).
  { intros [n [Tn Hq]]. destruct (alone_tile _ Tn) as [k [u [K T]]]. rewrite T in Hq. apply (QI k u); auto. }
  destruct rel; cbn [bounded satisfies] in *; try (apply EV; exact H); apply RE, H.
Qed.
Lemma alone_largest rel sg p q : check_statement A aadd asub amul aofZ alt ale c (CLargestDihedralAngle A rel sg p q) = true -> satisfies largest_angle rel (dangle A phi sg p q) in_space.
Proof.
  intros H. unfold check_statement in H. cbv zeta in H. apply andb_true_iff in H as [H1 H2]. apply alone_bounded.
  - intros k u t x K. unfold largest_angle. rewrite moved_dihedrals by auto. auto.
  - exact (largest_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok c alone_based l1 m2 m3 HG rel sg p q H1 H2).
Qed.
Lemma alone_smallest rel sg p q : check_statement A aadd asub amul aofZ alt ale c (CSmallestDihedralAngle A rel sg p q) = true -> satisfies smallest_angle rel (dangle A phi sg p q) in_space.
Proof.
  intros H. unfold check_statement in H. cbv zeta in H. apply andb_true_iff in H as [H1 H2]. apply alone_bounded.
  - intros k u t x K. unfold smallest_angle. rewrite moved_dihedrals by auto. auto.
  - exact (smallest_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok c alone_based l1 m2 m3 HG rel sg p q H1 H2).
Qed.
Lemma alone_ratio rel p q : check_statement A aadd asub amul aofZ alt ale c (CSquaredRadiusEdgeRatio A rel p q) = true -> satisfies squared_ratio rel (phi p / IZR q) in_space.
Proof.
  intros H. unfold check_statement in H. cbv zeta in H. rewrite !andb_true_iff in H. destruct H as [[H1 _] H2]. apply Z.ltb_lt, IZR_lt in H1. apply alone_bounded.
  - intros k u t x K. apply moved_ratio, K.
  - exact (radius_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok c alone_based l1 m2 m3 HG rel p q H1 H2).
Qed.
Lemma alone_acute : check_statement A aadd asub amul aofZ alt ale c (CAcute A) = true -> forall x, In x (dihedrals in_space) -> x < PI / 2.
Proof.
  intros H x Hx. assert (T0 : is_tile 0 1 (0%nat, z30)) by (split; [cbn; lia|cbn; auto]). destruct (alone_tile _ T0) as [k [u [K T]]].
  assert (BASE := alone_based).
  apply (each_angle A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c BASE l1 m2 m3 HG _ (fun x => x < PI / 2)
    (acute_sound A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c BASE l1 m2 m3 HG) H (0%nat, z30) x T0).
  rewrite T, moved_dihedrals by auto. exact Hx.
Qed.
Lemma alone_nonobtuse : check_statement A aadd asub amul aofZ alt ale c (CNonobtuse A) = true -> forall x, In x (dihedrals in_space) -> x <= PI / 2.
Proof.
  intros H x Hx. assert (T0 : is_tile 0 1 (0%nat, z30)) by (split; [cbn; lia|cbn; auto]). destruct (alone_tile _ T0) as [k [u [K T]]].
  assert (BASE := alone_based).
  apply (each_angle A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c BASE l1 m2 m3 HG _ (fun x => x <= PI / 2)
    (nonobtuse_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z ale_ok c BASE l1 m2 m3 HG) H (0%nat, z30) x T0).
  rewrite T, moved_dihedrals by auto. exact Hx.
Qed.
End Alone.

(** ** Over all mosaics *)
Section Mosaic.
Variables (l1 l2 l3 : point).
Hypothesis basis : has_gram G l1 l2 l3.
Hypothesis right_handed : 0 < det l1 l2 l3.
Notation over_all := (over_all l1 l2 l3 G r rsystem).
Notation over_some := (over_some l1 l2 l3 G r rsystem).
Notation joins := (MosaicChecker.joins A aofZ system apexes).
Notation check_alone := (MosaicChecker.check_alone A aadd asub amul aofZ alt ale g).
Lemma gram_checked : chk_gram A aadd asub amul aofZ alt g = true.
Proof. pose proof CHECKED as C. unfold check_system in C. rewrite !andb_true_iff in C. tauto. Qed.
Lemma pieces_In a t : In t (pieces (patch_at a)) -> exists kt, In kt (k_pieces A (k_patch a)) /\ t = rtet kt.
Proof. rewrite patch_ok. unfold rpatch; cbn [pieces]. rewrite in_map_iff. intros [kt [E I]]. eauto. Qed.
Lemma piece_pos a kt : (a < length rsystem)%nat -> In kt (k_pieces A (k_patch a)) -> tet_pos kt.
Proof.
  intros Ha I. apply (In_nth _ _ (no_spot, no_spot, no_spot, no_spot)) in I as [k [Hk <-]]. destruct (positive_ok a Ha) as [[_ [_ [_ PT]]] _]. apply PT.
Qed.
Section Over.
Variables (tiles : nat -> tile) (rise : nat -> point).
Hypothesis tiling : mosaic l1 l2 l3 G r rsystem tiles.
Hypothesis high : heights l1 l2 l3 r rsystem tiles rise.
Notation kind i := (shape (tiles i)).
Notation is_cell := (is_cell l1 l2 l3 r rsystem tiles rise).
Lemma space_of i n kt : exists m2 m3 i0, has_gram G l1 m2 m3 /\ map_tet (at_ tiles rise i n) (rtet kt) = in_space l1 m2 m3 kt i0.
Proof.
  destruct (motion G r rsystem h system_good l1 l2 l3 basis right_handed tiles tiling i) as [m2 [m3 [E [HG _]]]].
  exists m2, m3, (at_ tiles rise i n origin). split; [exact HG|]. unfold in_space, map_tet, at_, MosaicStatement.spot, MosaicStatement.place. rewrite E.
  unfold MosaicPoints.lift, at_coordinates, origin. destruct kt as [[[x y] z] w]; cbn [rtet va vb vc vd]. f_equal; apply point_eq; unf; ring.
Qed.
Lemma cell_corners t : is_cell t -> exists a kt m2 m3 i0, (a < length rsystem)%nat /\ (In kt (k_pieces A (k_patch a)) \/ In kt (joins a)) /\ tet_pos kt /\
  has_gram G l1 m2 m3 /\ t = in_space l1 m2 m3 kt i0.
Proof.
  intros Ht. apply (is_cell_iff G r rsystem h system_good l1 l2 l3 basis right_handed tiles tiling rise high) in Ht as [c [V ->]].
  destruct c as [[i p] n]. pose proof (kind_lt G r rsystem l1 l2 l3 tiles tiling i) as KI. cbn [MosaicTiling.piece]. destruct V as [L V]. destruct p as [k|q e].
  - change (MosaicStatement.patch_of rsystem tiles i) with (patch_at (kind i)) in *. rewrite pieces_length in V. rewrite patch_ok, piece_ok.
    destruct (space_of i n (k_piece (k_patch (kind i)) k)) as [m2 [m3 [i0 [HG E]]]]. exists (kind i), (k_piece (k_patch (kind i)) k), m2, m3, i0.
    assert (I : In (k_piece (k_patch (kind i)) k) (k_pieces A (k_patch (kind i)))) by (apply nth_In, V). split; [exact KI|]. split; [left; exact I|]. split; [apply (piece_pos (kind i)); auto|]. auto.
  - destruct V as [Hq [He I]]. destruct (pyramid_facts G r rsystem h system_good l1 l2 l3 tiles tiling i q Hq) as [Hs _]. unfold join_at.
    destruct (MosaicSides.across_side r rsystem l1 l2 l3 tiles i (side_of h (kind i) q)) as [j s'] eqn:E.
    destruct (across_spec G r rsystem h system_good l1 l2 l3 basis right_handed tiles tiling i _ j s' Hs E) as [Hs' [_ [_ FT]]].
    change (MosaicStatement.patch_of rsystem tiles i) with (patch_at (kind i)) in *. change (MosaicStatement.patch_of rsystem tiles j) with (patch_at (kind j)) in *.
    pose proof (kind_lt G r rsystem l1 l2 l3 tiles tiling j) as KJ.
    rewrite pyramids_length in Hq. rewrite sides_length in Hs, Hs'. rewrite patch_ok, rim_count_ok in He.
    pose proof (choice_ok (kind i) q (kind j) s' KI KJ Hq Hs Hs' FT) as CH. unfold join. destruct (pyramid_mate h (kind i) q (kind j) s') as [q' m]. destruct CH as [y [Hy ->]].
    rewrite patch_ok. change (Tetrahedron (rp y) (rim_at (rpatch (k_patch (kind i))) q e) (rim_at (rpatch (k_patch (kind i))) q (next (rim_count (rpatch (k_patch (kind i))) q) e)) (apex_at (rpatch (k_patch (kind i))) q)) with (lateral_cell (rpatch (k_patch (kind i))) q e (rp y)).
    rewrite <- lateral_ok. destruct (space_of i n (lateral (k_patch (kind i)) q e y)) as [m2 [m3 [i0 [HG E2]]]].
    exists (kind i), (lateral (k_patch (kind i)) q e y), m2, m3, i0. split; [exact KI|]. split; [right|split; [apply join_pos; auto|auto]].
    unfold MosaicChecker.joins. cbv zeta. apply in_flat_map. exists q. split; [apply in_seq; lia|]. apply in_flat_map. exists y. split; [exact Hy|].
    apply (in_map (fun e => lateral (k_patch (kind i)) q e y)), in_seq. lia.
Qed.
Lemma every_ok (f : corners -> bool) (Q : tetrahedron -> Prop) : every_cell A aofZ system apexes f = true ->
  (forall m2 m3 kt i0, has_gram G l1 m2 m3 -> tet_pos kt -> f kt = true -> Q (in_space l1 m2 m3 kt i0)) -> forall t, is_cell t -> Q t.
Proof.
  intros E H t Ht. destruct (cell_corners t Ht) as [a [kt [m2 [m3 [i0 [Ha [I [P [HG ->]]]]]]]]]. apply H; auto.
  pose proof (upto_ok _ _ E a ltac:(rewrite map_length in Ha; exact Ha)) as K. cbv beta in K. apply andb_true_iff in K as [K1 K2]. rewrite forallb_forall in K1, K2. destruct I; auto.
Qed.
Lemma some_ok (f : corners -> bool) (Q : tetrahedron -> Prop) a : existsb f (k_pieces A (k_patch a)) = true ->
  (forall m2 m3 kt i0, has_gram G l1 m2 m3 -> tet_pos kt -> f kt = true -> Q (in_space l1 m2 m3 kt i0)) -> (exists i, kind i = a) -> exists t, is_cell t /\ Q t.
Proof.
  intros E H [i Hi]. apply existsb_exists in E as [kt [I F]]. pose proof (kind_lt G r rsystem l1 l2 l3 tiles tiling i) as KI.
  destruct (space_of i z30 kt) as [m2 [m3 [i0 [HG ES]]]]. exists (in_space l1 m2 m3 kt i0). split; [|apply H; auto; apply (piece_pos a); auto; rewrite <- Hi; exact KI].
  apply (is_cell_iff G r rsystem h system_good l1 l2 l3 basis right_handed tiles tiling rise high).
  apply (In_nth _ _ (no_spot, no_spot, no_spot, no_spot)) in I as [k [Hk Ek]]. exists (i, Piece k, z30). split.
  - split; [apply latb_zero|]. change (MosaicStatement.patch_of rsystem tiles i) with (patch_at (kind i)). rewrite pieces_length, Hi. exact Hk.
  - cbn [MosaicTiling.piece]. change (MosaicStatement.patch_of rsystem tiles i) with (patch_at (kind i)). 
    assert (PE : piece_at (patch_at (kind i)) k = rtet kt) by (rewrite patch_ok, piece_ok, Hi, <- Ek; reflexivity). rewrite PE. symmetry. exact ES.
Qed.
End Over.

Theorem tiles_all : over_all tiles_space.
Proof. intros tiles rise T H. apply (mosaic_tiles G r rsystem h system_good); auto. Qed.
Theorem acute_all : every_cell A aofZ system apexes (check_alone (CAcute A)) = true -> over_all acute_cells.
Proof.
  intros E tiles rise T H t x Ht. revert x. apply (every_ok tiles rise T H _ (fun t => forall x, In x (dihedrals t) -> x < PI / 2) E); auto.
  intros m2 m3 kt i0 HG P F. unfold MosaicChecker.check_alone in F. cbv zeta in F. apply andb_true_iff in F as [F1 F2]. apply alone_acute; auto. apply gram_checked.
Qed.
Theorem nonobtuse_all : every_cell A aofZ system apexes (check_alone (CNonobtuse A)) = true -> over_all nonobtuse_cells.
Proof.
  intros E tiles rise T H t x Ht. revert x. apply (every_ok tiles rise T H _ (fun t => forall x, In x (dihedrals t) -> x <= PI / 2) E); auto.
  intros m2 m3 kt i0 HG P F. unfold MosaicChecker.check_alone in F. cbv zeta in F. apply andb_true_iff in F as [F1 F2]. apply alone_nonobtuse; auto. apply gram_checked.
Qed.
Lemma bound_all (mk : relation -> cstatement A) (Q : tetrahedron -> R -> Prop) (B : R) rel :
  (forall rel m2 m3 kt i0, has_gram G l1 m2 m3 -> tet_pos kt -> check_alone (mk rel) kt = true -> satisfies Q rel B (in_space l1 m2 m3 kt i0)) ->
  check_bound A aadd asub amul aofZ alt ale g system apexes mk rel = true -> bounded_over_all l1 l2 l3 G r rsystem Q rel B.
Proof.
  intros S E.
  assert (ALL : forall rel, match rel with Maximum | Minimum => False | _ => True end -> every_cell A aofZ system apexes (check_alone (mk rel)) = true -> over_all (fun cells => bounded cells Q rel B)).
  { intros rel0 NM E0 tiles rise T H. pose proof (every_ok tiles rise T H _ (satisfies Q rel0 B) E0 (S rel0)) as K. destruct rel0; try contradiction; cbn [bounded]; intros t Ht; exact (K t Ht). }
  assert (SOME : forall rel, match rel with Maximum | Minimum => True | _ => False end -> some_piece A system (check_alone (mk rel)) = true -> over_some (fun cells => reached cells Q B)).
  { intros rel0 NM E0. apply some_upto_ok in E0 as [a [Ha E0]]. exists a. split; [rewrite map_length; exact Ha|]. intros tiles rise T H X.
    destruct (some_ok tiles rise T H _ (satisfies Q rel0 B) a E0 (S rel0) X) as [t [Ht K]]. exists t. split; auto. destruct rel0; try contradiction; exact K. }
  destruct rel; cbn [bounded_over_all check_bound] in *; try (apply ALL; [exact I|exact E]); apply andb_true_iff in E as [E1 E2]; (split; [apply ALL; [exact I|exact E1]|]);
  [apply (SOME Maximum)|apply (SOME Minimum)]; auto.
Qed.
Ltac alone_with L := intros rel0 m2 m3 kt i0 HG P F; unfold MosaicChecker.check_alone in F; cbv zeta in F; apply andb_true_iff in F as [F1 F2]; apply L; auto; apply gram_checked.
Theorem largest_all rel sg p q : check_bound A aadd asub amul aofZ alt ale g system apexes (fun rel => CLargestDihedralAngle A rel sg p q) rel = true ->
  bounded_over_all l1 l2 l3 G r rsystem largest_angle rel (dangle A phi sg p q).
Proof. apply bound_all. alone_with alone_largest. Qed.
Theorem smallest_all rel sg p q : check_bound A aadd asub amul aofZ alt ale g system apexes (fun rel => CSmallestDihedralAngle A rel sg p q) rel = true ->
  bounded_over_all l1 l2 l3 G r rsystem smallest_angle rel (dangle A phi sg p q).
Proof. apply bound_all. alone_with alone_smallest. Qed.
Theorem ratio_all rel p q : check_bound A aadd asub amul aofZ alt ale g system apexes (fun rel => CSquaredRadiusEdgeRatio A rel p q) rel = true ->
  bounded_over_all l1 l2 l3 G r rsystem squared_ratio rel (phi p / IZR q).
Proof. apply bound_all. alone_with alone_ratio. Qed.
Theorem delaunay_all : check_delaunay A aadd asub amul aofZ ale content quot g r system h apexes alt = true -> over_all delaunay_cells.
Proof.
  intros D tiles rise T H. apply (mosaic_delaunay G r rsystem h system_good true (local_ok alt true alt_ok D) (axis_ok alt true alt_ok D) l1 l2 l3 basis right_handed tiles T rise H eq_refl).
Qed.
Theorem weakly_delaunay_all : check_delaunay A aadd asub amul aofZ ale content quot g r system h apexes ale = true -> over_all weakly_delaunay_cells.
Proof.
  intros D tiles rise T H. apply (mosaic_weakly_delaunay G r rsystem h system_good false (local_ok ale false ale_ok D) (axis_ok ale false ale_ok D) l1 l2 l3 basis right_handed tiles T rise H).
Qed.
End Mosaic.
End Ring.
