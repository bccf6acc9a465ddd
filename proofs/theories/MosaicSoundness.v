(** * Systems of patches: the finite checks imply the conditions of MosaicPatches.v *)
Require Import Reals Lra Psatz NArith ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Domain Bounds Euclid Transfer Checker Soundness
  MosaicStatement MosaicPoints MosaicPatches MosaicDelaunay MosaicChecker MosaicSpots.
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
Notation rtri := (MosaicSpots.rtri A phi).
Notation rpatch := (MosaicSpots.rpatch A phi).
Notation phi_zero := (MosaicSpots.phi_zero A aofZ phi phi_Z).
Notation aeq_ok := (MosaicSpots.aeq_ok A ale phi ale_ok).
Notation spot_eq_ok := (MosaicSpots.spot_eq_ok A amul ale phi phi_mul ale_ok).
Notation lift_pos := (MosaicSpots.lift_pos A aadd amul aofZ phi).
Notation lift_ok := (MosaicSpots.lift_ok A aadd amul aofZ phi phi_add phi_mul phi_Z).
Notation no_spot_pos := (MosaicSpots.no_spot_pos A aofZ phi phi_Z).
Notation tet_pos := (MosaicSpots.tet_pos A phi).
Notation positive_tet_ok := (MosaicSpots.positive_tet_ok A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok).
Notation inside_ok := (MosaicSpots.inside_ok A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok).
Notation is_outside_ok := (MosaicSpots.is_outside_ok A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok).
Notation positive_patch := (MosaicSpots.positive_patch A aofZ phi).
Notation edge_ok := (MosaicSpots.edge_ok A aofZ phi phi_Z).
Notation sides_ok := (MosaicSpots.sides_ok A phi).
Notation apex_ok := (MosaicSpots.apex_ok A aofZ phi phi_Z).
Notation rim_count_ok := (MosaicSpots.rim_count_ok A aofZ phi phi_Z).
Notation rim_ok := (MosaicSpots.rim_ok A aofZ phi phi_Z).
Notation piece_ok := (MosaicSpots.piece_ok A aofZ phi phi_Z).
Notation triangle_ok := (MosaicSpots.triangle_ok A aofZ phi phi_Z).
Notation occupant_ok := (MosaicSpots.occupant_ok A aofZ phi phi_Z).
Notation occupants_In := (MosaicSpots.occupants_In A aofZ phi phi_Z r rank).
Notation opposite_ok := (MosaicSpots.opposite_ok A amul ale phi phi_mul ale_ok).
Notation triangle_pos := (MosaicSpots.triangle_pos A aofZ phi).
Notation left_ok := (MosaicSpots.left_ok A aadd asub amul aofZ phi phi_add phi_sub phi_mul phi_Z r rank).
Notation in_prism_ok := (MosaicSpots.in_prism_ok A aadd asub amul aofZ ale phi phi_add phi_sub phi_mul phi_Z ale_ok r rank).
Notation left_sign := (MosaicSpots.left_sign A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok r rank).
Notation fits_ok := (MosaicSpots.fits_ok A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok g r).
Notation carry_ok := (MosaicSpots.carry_ok A aadd asub amul aofZ ale content quot phi phi_add phi_sub phi_mul phi_Z ale_ok g r rank).
Notation zero := (Checker.zero A aofZ).
Notation phiG := (phiG A phi).
Notation spot := (MosaicChecker.spot A).
Notation weight := (MosaicChecker.weight A).
Notation numerators := (MosaicChecker.numerators A).
Notation aeq := (MosaicChecker.aeq A ale).
Notation spot_lift := (MosaicChecker.spot_lift A aadd amul aofZ).
Notation no_spot := (MosaicChecker.no_spot A aofZ).
Notation corner_list := (MosaicChecker.corner_list A).
Notation k_sides := (MosaicChecker.k_sides A).
Notation k_apex := (MosaicChecker.k_apex A aofZ).
Notation k_rim := (MosaicChecker.k_rim A aofZ).
Notation k_rim_at := (MosaicChecker.k_rim_at A aofZ).
Notation k_rim_count := (MosaicChecker.k_rim_count A aofZ).
Notation k_piece := (MosaicChecker.k_piece A aofZ).
Notation k_triangle := (MosaicChecker.k_triangle A aofZ).
Notation k_left := (MosaicChecker.k_left A aadd amul).
Notation G := (phiG g).
Notation side_form := (MosaicChecker.side_form A asub amul aofZ r).
Notation k_carry := (MosaicChecker.k_carry A aadd asub amul aofZ ale content quot g r).
Notation k_patch := (MosaicChecker.k_patch A system).
Notation rsystem := (map rpatch system).
Notation patch_at a := (nth a rsystem (Patch [] [] [])).
Notation can_meet := (MosaicChecker.can_meet A aofZ r).
Notation lateral := (MosaicChecker.lateral A aofZ).

Lemma patch_ok a : patch_at a = rpatch (k_patch a).
Proof. exact (map_nth rpatch system (KPatch A [] [] []) a). Qed.
Lemma checked_patch a : (a < length rsystem)%nat -> check_patch A aadd asub amul aofZ alt ale content quot g r system h apexes home a = true.
Proof.
  rewrite map_length. intros Ha. pose proof CHECKED as C. unfold check_system in C. apply andb_true_iff in C as [_ C]. apply (upto_ok _ _ C a Ha).
Qed.
Lemma positive_ok a : (a < length rsystem)%nat -> positive_patch (k_patch a) /\ forall q, (q < length (k_pyramids A (k_patch a)))%nat -> forall y, In y (apexes a q) -> pos y.
Proof.
  intros Ha. pose proof (checked_patch a Ha) as C. unfold check_patch in C. cbv zeta in C. rewrite !andb_true_iff in C. destruct C as [[[[[[C _] _] _] _] _] _].
  unfold positive_spots in C. cbv zeta in C. rewrite !andb_true_iff, !forallb_forall in C. destruct C as [[[C1 C2] C3] C4].
  assert (OK : forall x, alt zero (weight x) = true -> pos x) by (intros x H; apply alt_ok in H; rewrite phi_zero in H; exact H).
  assert (D : forall {X} (P : X -> Prop) (l : list X) d k, (forall x, In x l -> P x) -> P d -> P (nth k l d)).
  { intros X P l d k H Pd. destruct (Nat.lt_ge_cases k (length l)) as [L|L]; [apply H, nth_In, L|rewrite nth_overflow; auto]. }
  split; [split; [|split; [|split]]|].
  - intros s. unfold MosaicChecker.k_start. apply (D _ (fun e => pos (snd e))); [|apply no_spot_pos]. intros x Hx. apply OK, C1, Hx.
  - intros q. unfold MosaicChecker.k_apex, k_pyramid. apply (D _ (fun y => pos (fst y))); [|apply no_spot_pos]. intros x Hx. specialize (C2 x Hx). apply andb_true_iff in C2 as [C2 _]. apply OK, C2.
  - intros q e. unfold MosaicChecker.k_rim_at. apply (D _ pos); [|apply no_spot_pos]. unfold MosaicChecker.k_rim, k_pyramid. intros x Hx.
    assert (K : Forall pos (snd (nth q (k_pyramids A (k_patch a)) (no_spot, [])))).
    { apply (D _ (fun y => Forall pos (snd y))); [|constructor]. intros y Hy. specialize (C2 y Hy). apply andb_true_iff in C2 as [_ C2]. rewrite forallb_forall in C2.
      apply Forall_forall. intros z Hz. apply OK, C2, Hz. }
    rewrite Forall_forall in K. apply K, Hx.
  - intros k. unfold MosaicChecker.k_piece. apply (D _ tet_pos).
    + intros t Ht. specialize (C3 t Ht). rewrite forallb_forall in C3. apply Forall_forall. intros z Hz. apply OK, C3, Hz.
    + unfold tet_pos. cbn [MosaicChecker.corner_list]. repeat constructor; apply no_spot_pos.
  - intros q Hq y Hy. pose proof (upto_ok _ _ C4 q Hq) as K. rewrite forallb_forall in K. apply OK, K, Hy.
Qed.

Lemma join_pos a q e y : (a < length rsystem)%nat -> (q < length (k_pyramids A (k_patch a)))%nat -> In y (apexes a q) -> tet_pos (lateral (k_patch a) q e y).
Proof.
  intros Ha Hq Hy. destruct (positive_ok a Ha) as [[_ [PA [PR _]]] PY]. unfold tet_pos, MosaicChecker.lateral; cbn [MosaicChecker.corner_list].
  repeat constructor; eauto.
Qed.
Lemma lateral_ok p q e y : rtet (lateral p q e y) = lateral_cell (rpatch p) q e (rp y).
Proof. unfold MosaicChecker.lateral, lateral_cell; cbn [rtet]. rewrite !rim_ok, apex_ok, rim_count_ok. reflexivity. Qed.

Lemma pair_checked a s b s' : (a < length rsystem)%nat -> (b < length rsystem)%nat -> (s < k_sides (k_patch a))%nat -> (s' < k_sides (k_patch b))%nat ->
  check_pair A aadd asub amul aofZ alt ale content quot g r system h apexes a s b s' = true.
Proof.
  intros Ha Hb Hs Hs'. pose proof (checked_patch a Ha) as C. unfold check_patch in C. cbv zeta in C. apply andb_true_iff in C as [_ C].
  pose proof (upto_ok _ _ C s Hs) as K. apply andb_true_iff in K as [_ K]. rewrite map_length in Hb. pose proof (upto_ok _ _ K b Hb) as K2. exact (upto_ok _ _ K2 s' Hs').
Qed.
Lemma meet_iff a s b s' : class (edge_at (patch_at a) s) = class (edge_at (patch_at b) s') -> (r = 2%nat -> s <> s') -> can_meet (k_patch a) s (k_patch b) s' = true.
Proof.
  rewrite !patch_ok, !edge_ok. cbn [class]. intros C D. unfold MosaicChecker.can_meet. rewrite C, Z.eqb_refl. cbn [andb].
  destruct (Nat.eqb_spec r 2) as [R|]; auto. apply negb_true_iff, Nat.eqb_neq, D, R.
Qed.
Lemma fits_meet a s b s' : fits G r (patch_at a) s (patch_at b) s' -> can_meet (k_patch a) s (k_patch b) s' = true.
Proof. intros [C [D _]]. apply meet_iff; auto. Qed.
(** What the check of two sides says, and the apexes on the other side. *)
Lemma pair_fits a s b s' : (a < length rsystem)%nat -> (b < length rsystem)%nat -> (s < k_sides (k_patch a))%nat -> (s' < k_sides (k_patch b))%nat ->
  can_meet (k_patch a) s (k_patch b) s' = true -> fits G r (patch_at a) s (patch_at b) s' /\
  forall x, pos x -> pos (k_carry (k_patch a) s (k_patch b) s' x) /\ rp (k_carry (k_patch a) s (k_patch b) s' x) = carry G r (patch_at a) s (patch_at b) s' (rp x).
Proof.
  intros Ha Hb Hs Hs' CM. pose proof (pair_checked a s b s' Ha Hb Hs Hs') as C. unfold check_pair in C. cbv zeta in C. rewrite CM in C.
  rewrite !andb_true_iff in C. destruct C as [[C _] _]. destruct (positive_ok a Ha) as [PA _]. destruct (positive_ok b Hb) as [PB _].
  destruct (fits_ok (k_patch a) s (k_patch b) s' PA PB CM C) as [F L]. rewrite !patch_ok. split; [exact F|]. intros x X. apply carry_ok; auto.
Qed.
Lemma choice_ok a q b s' : (a < length rsystem)%nat -> (b < length rsystem)%nat -> (q < length (k_pyramids A (k_patch a)))%nat -> (side_of h a q < k_sides (k_patch a))%nat ->
  (s' < k_sides (k_patch b))%nat -> fits G r (patch_at a) (side_of h a q) (patch_at b) s' ->
  let '(q', m) := pyramid_mate h a q b s' in exists y, In y (apexes a q) /\ lift m (carry G r (patch_at a) (side_of h a q) (patch_at b) s' (apex_at (patch_at b) q')) = rp y.
Proof.
  intros Ha Hb Hq Hs Hs' FT. pose proof (pair_checked a (side_of h a q) b s' Ha Hb Hs Hs') as C. unfold check_pair in C. cbv zeta in C.
  pose proof (fits_meet _ _ _ _ FT) as CM. rewrite CM in C. rewrite !andb_true_iff in C. destruct C as [[_ C] _]. pose proof (upto_ok _ _ C q Hq) as K. cbv beta in K. rewrite Nat.eqb_refl in K.
  destruct (pair_fits a (side_of h a q) b s' Ha Hb Hs Hs' CM) as [_ CO].
  destruct (pyramid_mate h a q b s') as [q' m]. rewrite !andb_true_iff in K. destruct K as [[_ K] _]. apply existsb_exists in K as [y [Hy K]].
  destruct (positive_ok a Ha) as [_ PY]. destruct (positive_ok b Hb) as [[_ [PB _]] _]. destruct (CO (k_apex (k_patch b) q') (PB q')) as [CP CE].
  exists y. split; auto. rewrite !patch_ok, apex_ok. rewrite !patch_ok in CE. rewrite <- CE, <- lift_ok by auto. exact (spot_eq_ok _ _ (lift_pos _ _ CP) (PY q Hq y Hy) K).
Qed.
Lemma pyramids_length a : length (pyramids (patch_at a)) = length (k_pyramids A (k_patch a)).
Proof. rewrite patch_ok. unfold rpatch; cbn [pyramids]. apply map_length. Qed.
Lemma pieces_length a : length (pieces (patch_at a)) = length (k_pieces A (k_patch a)).
Proof. rewrite patch_ok. unfold rpatch; cbn [pieces]. apply map_length. Qed.
Lemma sides_length a : sides (patch_at a) = k_sides (k_patch a).
Proof. rewrite patch_ok. apply sides_ok. Qed.
Lemma rtri_lift n f : (let '(a, b, c) := f in pos a /\ pos b /\ pos c) -> rtri (map_spots A (spot_lift n) f) = map_tri (lift n) (rtri f).
Proof. destruct f as [[a b] c]. intros [P1 [P2 P3]]. unfold rtri, map_tri, map_spots; cbn [t1 t2 t3]. rewrite !lift_ok by auto. reflexivity. Qed.

Lemma pyramid_checked a q : (a < length rsystem)%nat -> (q < length (k_pyramids A (k_patch a)))%nat ->
  check_pyramid A aadd asub amul aofZ alt ale r system h a q = true /\ check_joins A aadd asub amul aofZ alt ale r system h apexes a q = true.
Proof.
  intros Ha Hq. pose proof (checked_patch a Ha) as C. unfold check_patch in C. cbv zeta in C. rewrite !andb_true_iff in C. destruct C as [[[_ C] _] _].
  pose proof (upto_ok _ _ C q Hq) as K. apply andb_true_iff in K. exact K.
Qed.
Lemma within_ok x y : pos x -> pos y -> within_3 A asub amul aofZ alt r x y = true ->
  (-3 < px (rp x) - px (rp y) < 3) /\ (r = 2%nat -> -3 < py (rp x) - py (rp y) < 3).
Proof.
  intros X Y W. unfold within_3 in W. cbv zeta in W. apply andb_true_iff in W as [W1 W2]. unfold pos in X, Y.
  assert (K : forall u v, alt (amul (aofZ (-3)) (amul (weight x) (weight y))) (asub (amul (weight y) u) (amul (weight x) v)) &&
     alt (asub (amul (weight y) u) (amul (weight x) v)) (amul (aofZ 3) (amul (weight x) (weight y))) = true ->
     -3 < / phi (weight x) * phi u - / phi (weight y) * phi v < 3).
  { intros u v H. apply andb_true_iff in H as [H1 H2]. apply alt_ok in H1, H2. rewrite !phi_sub, !phi_mul, phi_Z in H1, H2.
    set (a := phi (weight x)) in *. set (b := phi (weight y)) in *. assert (AB : 0 < a * b) by (apply Rmult_lt_0_compat; auto).
    assert (E : / a * phi u - / b * phi v = (b * phi u - a * phi v) / (a * b)) by (field; lra). rewrite E. split.
    - apply Rmult_lt_reg_r with (a * b); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
    - apply Rmult_lt_reg_r with (a * b); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  split.
  - exact (K _ _ W1).
  - intros R. rewrite R in W2. cbn [Nat.eqb] in W2. exact (K _ _ W2).
Qed.
Lemma hull_coordinate (f : point -> R) t b B y : (forall a1 a2 a3 a4, a1 + a2 + a3 + a4 = 1 -> f (combination t a1 a2 a3 a4) = a1 * f (va t) + a2 * f (vb t) + a3 * f (vc t) + a4 * f (vd t)) ->
  (forall v, In v (verts t) -> b < f v < B) -> hull t y -> b < f y < B.
Proof.
  intros F P [a1 [a2 [a3 [a4 [A1 [A2 [A3 [A4 [S ->]]]]]]]]]. rewrite F by auto.
  pose proof (P (va t) ltac:(cbn; auto)); pose proof (P (vb t) ltac:(cbn; auto)); pose proof (P (vc t) ltac:(cbn; auto)); pose proof (P (vd t) ltac:(cbn; auto)).
  assert (M : exists i, 0 < i /\ (i <= a1 \/ i <= a2 \/ i <= a3 \/ i <= a4)).
  { exists (/ 4). split; [lra|]. lra. }
  split.
  - assert (0 <= a1 * (f (va t) - b) /\ 0 <= a2 * (f (vb t) - b) /\ 0 <= a3 * (f (vc t) - b) /\ 0 <= a4 * (f (vd t) - b)) by (repeat split; apply Rmult_le_pos; lra).
    destruct M as [i [I [M|[M|[M|M]]]]]; nra.
  - assert (0 <= a1 * (B - f (va t)) /\ 0 <= a2 * (B - f (vb t)) /\ 0 <= a3 * (B - f (vc t)) /\ 0 <= a4 * (B - f (vd t))) by (repeat split; apply Rmult_le_pos; lra).
    destruct M as [i [I [M|[M|[M|M]]]]]; nra.
Qed.
(** A spot that is outside of the moved tetrahedra near by is outside of all. *)
Lemma missed_ok t x (skip : Z3 -> bool) n : tet_pos t -> 0 < vol (rtet t) -> pos x -> latb r n = true -> skip n = false ->
  forallb (within_3 A asub amul aofZ alt r x) (corner_list t) = true ->
  forallb (fun n => skip n || is_outside A aadd asub amul aofZ alt ale t (spot_lift n x)) (shifts r) = true -> ~ closed (rtet t) (lift n (rp x)).
Proof.
  intros P V X L SK W O C. assert (I : In n (shifts r)).
  { pose proof (proj2 (hull_closed _ _ V) C) as H. rewrite forallb_forall in W.
    assert (VS : forall v, In v (verts (rtet t)) -> exists y, v = rp y /\ pos y /\ In y (corner_list t)).
    { intros v Hv. unfold tet_pos in P. rewrite Forall_forall in P. destruct t as [[[a b] c] d]. cbn [rtet verts va vb vc vd In] in Hv.
      destruct Hv as [<-|[<-|[<-|[<-|[]]]]]; eexists; (split; [reflexivity|]); split; try (apply P); cbn; auto. }
    assert (H1 : px (rp x) - 3 < px (lift n (rp x)) < px (rp x) + 3).
    { apply (hull_coordinate px (rtet t)); auto.
      - intros a1 a2 a3 a4 S. unfold combination. unf. ring.
      - intros v Hv. destruct (VS v Hv) as [y [-> [Y I]]]. destruct (within_ok x y X Y (W y I)) as [K _]. lra. }
    assert (H2 : r = 2%nat -> py (rp x) - 3 < py (lift n (rp x)) < py (rp x) + 3).
    { intros R. apply (hull_coordinate py (rtet t)); auto.
      - intros a1 a2 a3 a4 S. unfold combination. unf. ring.
      - intros v Hv. destruct (VS v Hv) as [y [-> [Y I]]]. destruct (within_ok x y X Y (W y I)) as [_ K]. specialize (K R). lra. }
    apply latb_iff in L. destruct n as [[n1 n2] n3]. unfold lift, pt in H1, H2. cbn [px py add] in H1, H2.
    assert (N1 : (-3 < n1 < 3)%Z) by (split; apply lt_IZR; lra). unfold shifts. apply in_flat_map. exists n1. split; [cbn; lia|]. apply in_map_iff.
    destruct rank as [R|R]; rewrite R in *; cbn in L; cbn [Nat.eqb].
    - exists 0%Z. destruct L as [-> ->]. split; [reflexivity|cbn; auto].
    - specialize (H2 eq_refl). exists n2. subst n3. split; [reflexivity|]. assert (N2 : (-3 < n2 < 3)%Z) by (split; apply lt_IZR; lra). cbn; lia. }
  rewrite forallb_forall in O. specialize (O n I). rewrite SK in O. cbn [orb] in O. apply is_outside_ok in O; auto using lift_pos.
  rewrite lift_ok in O by auto. exact (O C).
Qed.
Lemma missed_all t x n : tet_pos t -> 0 < vol (rtet t) -> pos x -> latb r n = true -> missed A aadd asub amul aofZ alt ale r t x = true -> ~ closed (rtet t) (lift n (rp x)).
Proof.
  intros P V X L M. unfold missed in M. apply andb_true_iff in M as [M1 M2]. apply (missed_ok t x (fun _ => false) n); auto.
Qed.

Lemma left_zero p s x : positive_patch p -> pos x -> aeq (k_left (side_form p s) x) zero = true -> left_of r (rpatch p) s (rp x) = 0.
Proof.
  intros PP X H. apply aeq_ok in H. rewrite phi_zero in H. destruct (left_ok p s PP) as [k [K E]]. rewrite E in H by auto. unfold pos in X.
  apply Rmult_integral in H as [H|H]; auto. pose proof (Rmult_lt_0_compat _ _ K X). lra.
Qed.
Lemma apart_ok x y n : pos x -> pos y -> latb r n = true -> apart A asub amul aofZ alt r x y = true -> rp x <> lift n (rp y).
Proof.
  intros X Y L H E. apply latb_iff in L. unfold pos in X, Y.
  assert (W : 0 < phi (weight x) * phi (weight y)) by (apply Rmult_lt_0_compat; auto).
  (* the difference of a coordinate, times both weights *)
  assert (D : forall f, phi (asub (amul (weight y) (f (numerators x))) (amul (weight x) (f (numerators y)))) = phi (weight x) * phi (weight y) * (/ phi (weight x) * phi (f (numerators x)) - / phi (weight y) * phi (f (numerators y)))).
  { intros f. rewrite phi_sub, !phi_mul. field. lra. }
  assert (FB : forall u z, phi u = phi (weight x) * phi (weight y) * IZR z -> fraction_between A amul aofZ alt u (amul (weight x) (weight y)) = true -> False).
  { intros u z Eu F. unfold fraction_between in F. apply existsb_exists in F as [k [_ F]]. apply andb_true_iff in F as [F1 F2]. apply alt_ok in F1, F2. rewrite !phi_mul, phi_Z, Eu in F1, F2.
    assert (k < z)%Z by (apply lt_IZR; nra). assert (z < k + 1)%Z by (apply lt_IZR; nra). lia. }
  assert (ST : forall u, phi u = 0 -> strict A alt zero u = true -> False).
  { intros u Eu S. unfold strict in S. apply orb_true_iff in S as [S|S]; apply alt_ok in S; rewrite phi_zero in S; lra. }
  destruct n as [[n1 n2] n3]. unfold lift, rp, scale, pt, add, Soundness.phi3 in E. injection E as E1 E2 E3.
  unfold apart in H. cbv zeta in H. rewrite !orb_true_iff in H.
  assert (Z3 : n3 = 0%Z) by (destruct rank as [R|R]; rewrite R in L; cbn in L; tauto). subst n3.
  destruct H as [[H|H]|H].
  - revert H. apply ST. rewrite D, E3. ring.
  - revert H. apply (FB _ n1). rewrite D, E1. ring.
  - destruct rank as [R|R]; rewrite R in H, L; cbn [Nat.eqb] in H; cbn in L.
    + destruct L as [-> _]. revert H. apply ST. rewrite D, E2. ring.
    + revert H. apply (FB _ n2). rewrite D, E2. ring.
Qed.

Lemma unequal_ok x y : pos x -> pos y -> unequal A amul alt x y = true -> rp x <> rp y.
Proof.
  intros X Y H E. unfold pos in X, Y.
  assert (K : forall u v, / phi (weight x) * phi u = / phi (weight y) * phi v -> strict A alt (amul (weight y) u) (amul (weight x) v) = true -> False).
  { intros u v Q S. assert (Q' : phi (weight y) * phi u = phi (weight x) * phi v).
    { transitivity (phi (weight x) * phi (weight y) * (/ phi (weight x) * phi u)); [field; lra|]. rewrite Q. field. lra. }
    unfold strict in S. apply orb_true_iff in S as [S|S]; apply alt_ok in S; rewrite !phi_mul in S; lra. }
  unfold rp, scale, Soundness.phi3 in E. injection E as E1 E2 E3. unfold unequal in H. cbv zeta in H. rewrite !orb_true_iff in H.
  destruct H as [[H|H]|H]; eapply K; eauto.
Qed.
Lemma rims_differ_ok p q q2 n : (forall e, pos (k_rim_at p q e)) -> (forall e, pos (k_rim_at p q2 e)) -> latb r n = true ->
  rims_differ A aadd asub amul aofZ alt ale r (k_rim p q) (k_rim p q2) = true -> exists e, (e < k_rim_count p q)%nat /\
  forall e2, (e2 < rim_count (rpatch p) q2)%nat -> rp (k_rim_at p q e) <> lift n (rp (k_rim_at p q2 e2)).
Proof.
  intros P P2 L H. unfold rims_differ in H. destruct (k_rim p q) as [|x l] eqn:E; [discriminate|]. rewrite <- E in H. rewrite rim_count_ok.
  assert (X0 : k_rim_at p q 0 = x) by (unfold MosaicChecker.k_rim_at; rewrite E; reflexivity). assert (N0 : (0 < k_rim_count p q)%nat) by (unfold MosaicChecker.k_rim_count; rewrite E; cbn; lia).
  rewrite forallb_forall in H.
  destruct (dec (exists e2, (e2 < k_rim_count p q2)%nat /\ rp (k_rim_at p q 0) = lift n (rp (k_rim_at p q2 e2)))) as [[e2 [He2 Q]]|NO].
  - specialize (H (k_rim_at p q2 e2) (nth_In _ no_spot He2)). rewrite <- X0 in H. apply orb_true_iff in H as [H|H].
    + exfalso. exact (apart_ok _ _ n (P 0%nat) (P2 e2) L H Q).
    + apply existsb_exists in H as [m [_ H]]. apply andb_true_iff in H as [H1 H2]. apply spot_eq_ok in H1; auto using lift_pos. rewrite lift_ok in H1 by auto.
      assert (m = n). { apply pt_inj. rewrite Q in H1. unfold lift in H1. apply point_eq; [apply (f_equal px) in H1|apply (f_equal py) in H1|apply (f_equal pz) in H1]; unf; lra. }
      subst m. apply existsb_exists in H2 as [z [Hz H2]]. apply (In_nth _ _ no_spot) in Hz as [e [He Ez]]. exists e. split; [exact He|]. intros e3 He3.
      rewrite forallb_forall in H2. rewrite <- lift_ok by auto. apply unequal_ok; auto using lift_pos. unfold MosaicChecker.k_rim_at at 1. rewrite Ez. apply H2, nth_In, He3.
  - exists 0%nat. split; [exact N0|]. intros e2 He2 Q. apply NO. eauto.
Qed.

Theorem system_good : good G r rsystem h.
Proof.
  assert (SPOTS := positive_ok).
  assert (PIECES : forall a k, (a < length rsystem)%nat -> (k < length (k_pieces A (k_patch a)))%nat -> tet_pos (k_piece (k_patch a) k) /\ 0 < vol (rtet (k_piece (k_patch a) k)) /\
    forallb (k_in_prism A aadd amul aofZ ale (side_forms A asub amul aofZ r (k_patch a))) (corner_list (k_piece (k_patch a) k)) = true).
  { intros a k Ha Hk. destruct (SPOTS a Ha) as [[_ [_ [_ PT]]] _]. pose proof (checked_patch a Ha) as C. unfold check_patch in C. cbv zeta in C. rewrite !andb_true_iff in C. destruct C as [[[[_ C] _] _] _].
    rewrite forallb_forall in C. specialize (C _ (nth_In _ (no_spot, no_spot, no_spot, no_spot) Hk)). unfold check_piece in C. apply andb_true_iff in C as [C1 C2].
    split; [apply PT|]. split; [apply positive_tet_ok; [apply PT|exact C1]|exact C2]. }
  assert (SIDE : forall a q, (a < length rsystem)%nat -> (q < length (k_pyramids A (k_patch a)))%nat -> (side_of h a q < k_sides (k_patch a))%nat).
  { intros a q Ha Hq. destruct (pyramid_checked a q Ha Hq) as [C _]. unfold check_pyramid in C. cbv zeta in C. rewrite !andb_true_iff in C. apply Nat.ltb_lt. tauto. }
  assert (VOL : forall a q e y, (a < length rsystem)%nat -> (q < length (k_pyramids A (k_patch a)))%nat -> (e < k_rim_count (k_patch a) q)%nat -> In y (apexes a q) ->
    0 < vol (rtet (lateral (k_patch a) q e y))).
  { intros a q e y Ha Hq He Hy. destruct (pyramid_checked a q Ha Hq) as [_ C]. unfold check_joins in C. cbv zeta in C. rewrite forallb_forall in C. specialize (C y Hy). apply andb_true_iff in C as [C _].
    apply positive_tet_ok; [apply join_pos; auto|]. apply (upto_ok _ _ C e He). }
  assert (SIDES : forall a, (a < length rsystem)%nat -> check_sides A aadd asub amul aofZ alt r system a = true).
  { intros a Ha. pose proof (checked_patch a Ha) as C. unfold check_patch in C. cbv zeta in C. rewrite !andb_true_iff in C. tauto. }
  constructor.
  - exact rank.
  - pose proof CHECKED as C. unfold check_system in C. rewrite !andb_true_iff in C. destruct C as [[_ C] _]. unfold zero_blocks in C. apply andb_true_iff in C as [C1 C2]. apply aeq_ok in C1. rewrite phi_zero in C1.
    split; [exact C1|]. split; intros R; rewrite R in C2; cbn [Nat.eqb] in C2; apply aeq_ok in C2; rewrite phi_zero in C2; exact C2.
  - intros a Ha R. pose proof (SIDES a Ha) as C. unfold check_sides in C. rewrite R in C at 1. cbn [Nat.eqb] in C. apply Nat.eqb_eq in C. rewrite sides_length. exact C.
  - intros R a s t Ha Hs Ht. pose proof (SIDES a Ha) as C. unfold check_sides in C. rewrite R in C at 1. cbn [Nat.eqb] in C. cbv zeta in C. rewrite sides_length in *. apply andb_true_iff in C as [C2 C3].
    apply Nat.leb_le in C2. split; auto. intros N1 N2. pose proof (upto_ok _ _ C3 s Hs) as K. pose proof (upto_ok _ _ K t Ht) as K2. cbv beta in K2.
    rewrite !orb_true_iff, !Nat.eqb_eq in K2. destruct K2 as [[K2|K2]|K2]; [contradiction|contradiction|]. destruct (SPOTS a Ha) as [PP _].
    rewrite patch_ok, edge_ok. cbn [start]. apply left_sign; auto. apply PP.
  - intros a s b s' Ha Hb Hs Hs' CL D. rewrite sides_length in Hs, Hs'. apply (pair_fits a s b s' Ha Hb Hs Hs'). apply meet_iff; auto.
  - intros a k Ha Hk. rewrite pieces_length in Hk. destruct (PIECES a k Ha Hk) as [P [V I]]. rewrite patch_ok, piece_ok. split; [exact V|].
    intros v Hv. rewrite forallb_forall in I. unfold tet_pos in P. rewrite Forall_forall in P. destruct (SPOTS a Ha) as [PP _].
    destruct (k_piece (k_patch a) k) as [[[x y] z] w]. cbn [rtet verts va vb vc vd In] in Hv.
    destruct Hv as [<-|[<-|[<-|[<-|[]]]]]; apply in_prism_ok; auto; try (apply P); try (apply I); cbn; auto.
  - intros a o Ha Ho. rewrite patch_ok in Ho. pose proof (checked_patch a Ha) as C. unfold check_patch in C. cbv zeta in C. rewrite !andb_true_iff in C. destruct C as [[[[[_ C] _] _] _] _].
    rewrite forallb_forall in C. specialize (C o (occupants_In _ _ Ho)). unfold check_occupant in C. cbv zeta in C. unfold good_occupant. cbv zeta. destruct (SPOTS a Ha) as [PP _].
    destruct (behind h a o) as [o' n|s w].
    + rewrite !andb_true_iff in C. destruct C as [[[C1 C2] C3] C4]. rewrite patch_ok. split; [apply occupant_ok, C1|]. split; [exact C2|]. split; [apply entry_eqb_eq, C3|].
      rewrite <- !triangle_ok, <- rtri_lift by (apply triangle_pos, PP). apply opposite_ok; [apply triangle_pos, PP| |exact C4].
      pose proof (triangle_pos (k_patch a) o' PP) as T. destruct (k_triangle (k_patch a) o') as [[x y] z]. cbn [map_spots]. destruct T as [T1 [T2 T3]]. auto using lift_pos.
    + rewrite !andb_true_iff in C. destruct C as [[[C1 C2] C3] _]. apply Nat.ltb_lt in C1, C2. apply occupant_eqb_eq in C3. rewrite sides_length. auto.
  - intros a q Ha Hq. rewrite pyramids_length in Hq. destruct (pyramid_checked a q Ha Hq) as [C _]. unfold check_pyramid in C. cbv zeta in C. rewrite !andb_true_iff in C.
    destruct C as [[[[[[C1 C2] C3] C4] C5] C6] C7]. apply Nat.ltb_lt in C1, C2. destruct (SPOTS a Ha) as [PP _]. pose proof PP as [_ [PA [PR _]]].
    unfold good_pyramid. cbv zeta. rewrite sides_length. rewrite patch_ok, rim_count_ok, apex_ok. split; [exact C1|]. split; [exact C2|].
    split; [apply in_prism_ok; auto|]. split; [apply left_sign; auto|]. rewrite forallb_forall in C5. split; [|split].
    + intros e He. rewrite rim_ok. specialize (C5 _ (nth_In _ no_spot He)). apply andb_true_iff in C5 as [C5 C5']. split; [apply in_prism_ok; auto; apply PR|apply left_zero; auto; apply PR].
    + intros s2 Hs2 N. pose proof (upto_ok _ _ C6 s2 Hs2) as K. cbv beta in K. apply orb_true_iff in K as [K|K]; [apply Nat.eqb_eq in K; contradiction|].
      apply existsb_exists in K as [x [Hx K]]. apply (In_nth _ _ no_spot) in Hx as [e [He Ex]]. exists e. split; [exact He|]. rewrite rim_ok. unfold MosaicChecker.k_rim_at. rewrite Ex.
      pose proof (PR q e) as PX. unfold MosaicChecker.k_rim_at in PX. rewrite Ex in PX. apply left_sign in K; auto. lra.
    + intros q2 Hq2 N S n L. rewrite <- patch_ok, pyramids_length in Hq2. pose proof (upto_ok _ _ C7 q2 Hq2) as K. cbv beta in K. rewrite !orb_true_iff in K. destruct K as [[K|K]|K].
      * apply Nat.eqb_eq in K. contradiction.
      * rewrite S, Nat.eqb_refl in K. discriminate.
      * setoid_rewrite rim_ok. apply rims_differ_ok; auto; apply PR.
  - intros a s w Ha Hs Hw. rewrite sides_length in Hs. pose proof (checked_patch a Ha) as C. unfold check_patch in C. cbv zeta in C. apply andb_true_iff in C as [_ C].
    pose proof (upto_ok _ _ C s Hs) as K. apply andb_true_iff in K as [K _]. pose proof (upto_ok _ _ K w Hw) as K2. unfold check_wall in K2. apply andb_true_iff in K2 as [K2 K3].
    rewrite patch_ok. split; [apply occupant_ok, K2|apply entry_eqb_eq, K3].
  - intros a o s w Ha Ho B. rewrite patch_ok in Ho. pose proof (checked_patch a Ha) as C. unfold check_patch in C. cbv zeta in C. rewrite !andb_true_iff in C. destruct C as [[[[[_ C] _] _] _] _].
    rewrite forallb_forall in C. specialize (C o (occupants_In _ _ Ho)). unfold check_occupant in C. cbv zeta in C. rewrite B in C. apply andb_true_iff in C as [_ C].
    destruct o as [k f|q e]; [eauto|discriminate].
  - intros a s b s' Ha Hb Hs Hs' FT. rewrite sides_length in Hs, Hs'. pose proof (fits_meet _ _ _ _ FT) as CM. pose proof (pair_checked a s b s' Ha Hb Hs Hs') as C.
    destruct (pair_fits a s b s' Ha Hb Hs Hs' CM) as [_ CO]. unfold check_pair in C. cbv zeta in C. rewrite CM in C. rewrite !andb_true_iff in C. destruct C as [[_ C1] C2].
    destruct (SPOTS a Ha) as [PPa PYa]. destruct (SPOTS b Hb) as [PPb _]. pose proof PPa as [_ [PAa [PRa _]]]. pose proof PPb as [_ [PAb [PRb _]]].
    assert (CL : forall m x, pos x -> pos (spot_lift m (k_carry (k_patch a) s (k_patch b) s' x)) /\ rp (spot_lift m (k_carry (k_patch a) s (k_patch b) s' x)) = lift m (carry G r (patch_at a) s (patch_at b) s' (rp x))).
    { intros m x X. destruct (CO x X) as [P E]. split; [apply lift_pos, P|]. rewrite lift_ok, E by auto. reflexivity. }
    unfold good_pair. cbv zeta. split.
    + intros q Hq Sq. rewrite pyramids_length in Hq. pose proof (upto_ok _ _ C1 q Hq) as K. cbv beta in K. rewrite Sq, Nat.eqb_refl in K.
      pose proof (choice_ok a q b s' Ha Hb Hq) as CH. rewrite Sq in CH. specialize (CH Hs Hs' FT).
      destruct (pyramid_mate h a q b s') as [q' m] eqn:PM. rewrite !andb_true_iff in K. destruct K as [[[[[K1 K2] K3] K4] _] K5].
      apply Nat.ltb_lt in K1. apply Nat.eqb_eq in K2. apply mate_eqb_eq in K4. destruct CH as [y [Hy Ey]].
      rewrite pyramids_length. split; [exact K1|]. split; [exact K2|]. split; [exact K3|]. split; [exact K4|]. split.
      * intros e He. rewrite (patch_ok a), rim_count_ok in He. pose proof (upto_ok _ _ K5 e He) as K. cbv beta in K. rewrite !andb_true_iff in K. destruct K as [[[E1 E2] E3] E4].
        apply Nat.ltb_lt in E1. apply Nat.eqb_eq in E2. set (e' := rim_mate h a q b s' e) in *.
        assert (NM : forall j, (j < k_rim_count (k_patch b) q')%nat -> nth j (map (fun x => spot_lift m (k_carry (k_patch a) s (k_patch b) s' x)) (k_rim (k_patch b) q')) no_spot =
          spot_lift m (k_carry (k_patch a) s (k_patch b) s' (k_rim_at (k_patch b) q' j))).
        { intros j Hj. rewrite (nth_indep _ no_spot (spot_lift m (k_carry (k_patch a) s (k_patch b) s' no_spot))) by (rewrite map_length; exact Hj).
          exact (map_nth (fun x => spot_lift m (k_carry (k_patch a) s (k_patch b) s' x)) (k_rim (k_patch b) q') no_spot j). }
        rewrite NM in E3 by (apply next_lt, E1). rewrite NM in E4 by exact E1.
        apply spot_eq_ok in E3; [|apply PRa|apply CL, PRb]. apply spot_eq_ok in E4; [|apply PRa|apply CL, PRb].
        rewrite (proj2 (CL m _ (PRb _ _))) in E3. rewrite (proj2 (CL m _ (PRb _ _))) in E4.
        rewrite (patch_ok b), rim_count_ok, !rim_ok, <- (patch_ok b). split; [exact E1|]. split; [exact E2|].
        split; [rewrite (patch_ok a) at 1; rewrite rim_ok; exact E3|]. split; [rewrite (patch_ok a) at 1 2; rewrite rim_ok, rim_count_ok; exact E4|].
        unfold join. rewrite PM, Sq, Ey. rewrite (patch_ok a), !rim_ok, rim_count_ok, apex_ok.
        pose proof (VOL a q e y Ha Hq He Hy) as V. exact V.
      * rewrite Ey. intros t Ht. rewrite sides_length in Ht. destruct (pyramid_checked a q Ha Hq) as [_ C]. unfold check_joins in C. cbv zeta in C. rewrite forallb_forall in C.
        specialize (C y Hy). apply andb_true_iff in C as [_ C]. pose proof (upto_ok _ _ C t Ht) as K. cbv beta in K. apply ale_ok in K. rewrite phi_zero, phi_sub, !phi_mul in K. rewrite Sq in K.
        destruct (left_ok (k_patch a) s PPa) as [k1 [K1' L1]]. destruct (left_ok (k_patch a) t PPa) as [k2 [K2' L2]].
        pose proof (PYa q Hq y Hy) as PY. rewrite !L1, !L2 in K by auto. rewrite (patch_ok a), apex_ok.
        pose proof (PAa q) as PQ. unfold pos in PY, PQ.
        set (X := left_of r (rpatch (k_patch a)) s (rp (k_apex (k_patch a) q)) * left_of r (rpatch (k_patch a)) t (rp y) - left_of r (rpatch (k_patch a)) s (rp y) * left_of r (rpatch (k_patch a)) t (rp (k_apex (k_patch a) q))) in *.
        set (c := k1 * k2 * (phi (weight (k_apex (k_patch a) q)) * phi (weight y))).
        assert (CP : 0 < c) by (unfold c; repeat apply Rmult_lt_0_compat; auto).
        assert (E : c * X = k1 * phi (weight (k_apex (k_patch a) q)) * left_of r (rpatch (k_patch a)) s (rp (k_apex (k_patch a) q)) * (k2 * phi (weight y) * left_of r (rpatch (k_patch a)) t (rp y)) -
          k1 * phi (weight y) * left_of r (rpatch (k_patch a)) s (rp y) * (k2 * phi (weight (k_apex (k_patch a) q)) * left_of r (rpatch (k_patch a)) t (rp (k_apex (k_patch a) q)))) by (unfold c, X; ring).
        rewrite <- E in K. apply Rmult_le_reg_l with c; auto. lra.
    + intros w Hw. pose proof (upto_ok _ _ C2 w Hw) as K. cbv beta in K. destruct (wall_mate h a s b s' w) as [w' m]. rewrite !andb_true_iff in K. destruct K as [[[K1 K2] K3] K4].
      apply Nat.ltb_lt in K1. apply mate_eqb_eq in K3. split; [exact K1|]. split; [exact K2|]. split; [exact K3|].
      pose proof (triangle_pos (k_patch a) (owner h a s w) PPa) as T. pose proof (triangle_pos (k_patch b) (owner h b s' w') PPb) as T'.
      assert (TR : forall a o, triangle_of (patch_at a) o = rtri (k_triangle (k_patch a) o)) by (intros; rewrite patch_ok; symmetry; apply triangle_ok).
      rewrite !TR.
      assert (E : map_tri (fun x => lift m (carry G r (patch_at a) s (patch_at b) s' x)) (rtri (k_triangle (k_patch b) (owner h b s' w'))) =
        rtri (map_spots A (fun x => spot_lift m (k_carry (k_patch a) s (k_patch b) s' x)) (k_triangle (k_patch b) (owner h b s' w')))).
      { destruct (k_triangle (k_patch b) (owner h b s' w')) as [[x y] z]. destruct T' as [T1 [T2 T3]]. unfold map_tri, map_spots, rtri; cbn [t1 t2 t3].
        rewrite (proj2 (CL m x T1)), (proj2 (CL m y T2)), (proj2 (CL m z T3)). reflexivity. }
      rewrite E. apply opposite_ok; auto. destruct (k_triangle (k_patch b) (owner h b s' w')) as [[x y] z]. cbn [map_spots]. destruct T' as [T1 [T2 T3]]. repeat split; apply CL; auto.
  - intros a Ha. pose proof (checked_patch a Ha) as C. unfold check_patch in C. cbv zeta in C. rewrite !andb_true_iff in C. destruct C as [[_ C] _].
    unfold check_home in C. cbv zeta in C. destruct (home a) as [k x]. rewrite !andb_true_iff in C. destruct C as [[[[[[[C1 C2] C3] C4] C5] C6] C7] C8].
    apply Nat.ltb_lt in C1. assert (X : pos x) by (apply alt_ok in C2; rewrite phi_zero in C2; exact C2). destruct (SPOTS a Ha) as [PP PY]. destruct (PIECES a k Ha C1) as [TP [TV _]].
    unfold has_home. cbv zeta. exists k, (rp x). rewrite pieces_length. split; [exact C1|]. split; [rewrite patch_ok, piece_ok; apply inside_ok; auto|]. split; [|split].
    + intros s Hs. rewrite sides_length in Hs. rewrite patch_ok. rewrite forallb_forall in C4. apply left_sign; auto. apply C4, in_map, in_seq. lia.
    + intros k' n Hk' L N. rewrite patch_ok, piece_ok. destruct (PIECES a k' Ha Hk') as [TP' [TV' _]]. destruct (Nat.eq_dec k' k) as [->|NK].
      * apply (missed_ok (k_piece (k_patch a) k) x (fun n => z3eqb n z30) n); auto. destruct (z3eqb n z30) eqn:E; auto. exfalso. apply z3eqb_eq in E. apply N. congruence.
      * apply missed_all; auto. pose proof (upto_ok _ _ C7 k' Hk') as K. cbv beta in K. apply orb_true_iff in K as [K|K]; auto. apply Nat.eqb_eq in K. contradiction.
    + intros q b s' e n Hq Hb Hs' FT He L. rewrite pyramids_length in Hq. rewrite sides_length in Hs'.
      pose proof (choice_ok a q b s' Ha Hb Hq (SIDE a q Ha Hq) Hs' FT) as CH. unfold join. destruct (pyramid_mate h a q b s') as [q' m]. destruct CH as [y [Hy ->]].
      rewrite patch_ok in He |- *. rewrite rim_count_ok in He. change (Tetrahedron (rp y) (rim_at (rpatch (k_patch a)) q e) (rim_at (rpatch (k_patch a)) q (next (rim_count (rpatch (k_patch a)) q) e)) (apex_at (rpatch (k_patch a)) q)) with (lateral_cell (rpatch (k_patch a)) q e (rp y)).
      rewrite <- lateral_ok. apply missed_all; auto; [apply join_pos; auto|].
      pose proof (upto_ok _ _ C8 q Hq) as K. cbv beta in K. rewrite forallb_forall in K. exact (upto_ok _ _ (K y Hy) e He).
Qed.
End Ring.
