(** * Systems of patches: the checks imply the theorem

    The cells over a mosaic satisfy the hypotheses of Cells.v.  A facet of a cell is an
    *occupant* of a patch, raised by some periods: a facet of a piece, or a lateral triangle of
    a pyramid; or it is one of the two facets of a tetrahedron of a join that contain its axis.
    [resolve] gives the facet of a cell for an occupant, [beyond] the facet on its other side. *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Angles Euclid PatchStatement PatchChecker Cells PatchGeometry.
Import ListNotations.
Open Scope R_scope.

Lemma next_lt n s : (s < n)%nat -> (next n s < n)%nat.
Proof. unfold next. destruct (Nat.eqb_spec (S s) n); lia. Qed.
Definition prev (n s : nat) : nat := match s with O => Nat.pred n | S s' => s' end.
Lemma prev_lt n s : (s < n)%nat -> (prev n s < n)%nat.
Proof. unfold prev. destruct s; lia. Qed.
Lemma prev_next n s : (s < n)%nat -> prev n (next n s) = s.
Proof. unfold prev, next. destruct (Nat.eqb_spec (S s) n); intros; cbn; lia. Qed.
Lemma next_prev n s : (s < n)%nat -> next n (prev n s) = s.
Proof. unfold prev, next. destruct s; intros; [destruct (Nat.eqb_spec (S (Nat.pred n)) n)|destruct (Nat.eqb_spec (S s) n)]; lia. Qed.

(** A triangle with its vertices in another order, of the same orientation. *)
Definition turns (f g : triangle) := f = g \/ f = Triangle (t2 g) (t3 g) (t1 g) \/ f = Triangle (t3 g) (t1 g) (t2 g).
Lemma turns_opposite f f' g g' : turns f f' -> turns g g' -> opposite f' g' -> opposite f g.
Proof. intros [->|[->| ->]] [->|[->| ->]]; unfold opposite; cbn [t1 t2 t3]; intuition. Qed.

Lemma turn_turn x : turn (turn x) = x.
Proof.
  destruct x as [[? ?] [a b] [c e]]. unfold turn, zsub, zint; cbn [height ahead aside fst snd].
  f_equal; f_equal; lia.
Qed.

(** ** What has been checked *)
Section System.
Variables (system : list patch) (h : hints).
Hypothesis checked : check_system system h = true.
Notation patch_at a := (patch_at system a).

Lemma checks a : (a < length system)%nat ->
  (forall o, In o (occupants (patch_at a)) -> check_occupant system h a o = true) /\
  (forall t, In t (pieces (patch_at a)) -> check_piece (patch_at a) t = true) /\
  (forall s, (s < side_count (patch_at a))%nat -> check_edge (patch_at a) s = true) /\
  check_home system h a = true /\
  (forall s w, (s < side_count (patch_at a))%nat -> (w < owners h a s)%nat -> check_wall system h a s w = true) /\
  (forall s b s', (s < side_count (patch_at a))%nat -> (b < length system)%nat -> (s' < side_count (patch_at b))%nat -> check_pair system h a s b s' = true).
Proof.
  intros Ha. pose proof checked as C. unfold check_system in C. rewrite forallb_forall in C.
  specialize (C a ltac:(apply in_seq; lia)). cbv zeta in C. rewrite !andb_true_iff, !forallb_forall in C.
  destruct C as [[[[C1 C2] C3] C4] C5]. repeat split; auto.
  - intros s Hs. apply C3, in_seq. lia.
  - intros s w Hs Hw. specialize (C5 s ltac:(apply in_seq; lia)). apply andb_true_iff in C5 as [C5 _].
    rewrite forallb_forall in C5. apply C5, in_seq. lia.
  - intros s b s' Hs Hb Hs'. specialize (C5 s ltac:(apply in_seq; lia)). apply andb_true_iff in C5 as [_ C5].
    rewrite forallb_forall in C5. specialize (C5 b ltac:(apply in_seq; lia)). rewrite forallb_forall in C5. apply C5, in_seq. lia.
Qed.
Lemma occupants_In p o : is_occupant p o = true -> In o (occupants p).
Proof.
  unfold occupants. rewrite in_app_iff, !in_flat_map. destruct o as [k f|s e]; cbn [is_occupant]; rewrite andb_true_iff, !Nat.ltb_lt; intros [A B].
  - left. exists k. split; [apply in_seq; lia|]. apply in_map. cbn. lia.
  - right. exists s. split; [apply in_seq; lia|]. apply in_map, in_seq. lia.
Qed.
Lemma occupant_eq_ok o o' : occupant_eq o o' = true -> o = o'.
Proof. destruct o, o'; cbn; try discriminate; rewrite andb_true_iff, !Nat.eqb_eq; intros [-> ->]; reflexivity. Qed.
Lemma entry_eq_ok x y : entry_eq x y = true -> x = y.
Proof.
  destruct x, y; cbn; try discriminate; rewrite andb_true_iff.
  - rewrite Z.eqb_eq. intros [A ->]. apply occupant_eq_ok in A. congruence.
  - rewrite !Nat.eqb_eq. intros [-> ->]; reflexivity.
Qed.

(** ** A mosaic over it *)
Variables (tiles : nat -> tile) (rise : nat -> R).
Hypothesis tiling : mosaic system tiles.
Notation kind i := (shape (tiles i)).
Notation patch_of i := (patch_of system tiles i).
Notation sides i := (sides system tiles i).
Notation corner_of i s := (corner_of system tiles i s).
Notation wall_height i s := (wall_height system tiles rise i s).

Lemma kind_lt i : (kind i < length system)%nat.
Proof. apply (mosaic_shapes _ _ tiling). Qed.
Lemma along_unit i : fst (along (tiles i)) * fst (along (tiles i)) + snd (along (tiles i)) * snd (along (tiles i)) = 1.
Proof. apply (mosaic_unit _ _ tiling). Qed.

(** The direction of a side; the patch in the frame of a side. *)
Definition direction i s : R * R :=
  (fst (corner_of i (next (sides i) s)) - fst (corner_of i s), snd (corner_of i (next (sides i) s)) - snd (corner_of i s)).
Definition place_at i z (x : spot) := put (/ 24) (rise i + z) (corner (tiles i)) (along (tiles i)) x.
Definition frame i s z (x : spot) := put (/ 576) (wall_height i s + z) (corner_of i s) (direction i s) x.

Lemma direction_value i s : let u := vector (patch_of i) s in let d := along (tiles i) in
  direction i s = (/ 24 * (surd (ahead u) * fst d - surd (aside u) * snd d), / 24 * (surd (ahead u) * snd d + surd (aside u) * fst d)).
Proof.
  cbv zeta. unfold direction, PatchStatement.corner_of, put; cbn [py pz fst snd].
  change (PatchStatement.edge_of system tiles i s) with (edge_at (patch_of i) s).
  change (PatchStatement.edge_of system tiles i (next (sides i) s)) with (edge_at (patch_of i) (next (side_count (patch_of i)) s)).
  unfold vector, spot_sub; cbn [height ahead aside]. rewrite !surd_sub. f_equal; ring.
Qed.
Lemma vector_unit i s : (s < sides i)%nat -> let u := vector (patch_of i) s in
  surd (ahead u) * surd (ahead u) + surd (aside u) * surd (aside u) = 576.
Proof.
  intros Hs u. destruct (checks (kind i) (kind_lt i)) as [_ [_ [K _]]]. specialize (K s Hs).
  unfold check_edge in K. cbv zeta in K. rewrite !andb_true_iff in K. destruct K as [[[[[[K _] _] _] _] _] _].
  apply zeq_ok in K. apply (f_equal surd) in K. rewrite surd_add, !surd_mul, surd_int in K. exact K.
Qed.
Lemma direction_unit i s : (s < sides i)%nat -> fst (direction i s) * fst (direction i s) + snd (direction i s) * snd (direction i s) = 1.
Proof.
  intros Hs. rewrite direction_value. cbv zeta. cbn [fst snd]. pose proof (vector_unit i s Hs) as U. cbv zeta in U. pose proof (along_unit i) as D.
  set (u := surd (ahead _)) in *. set (v := surd (aside _)) in *. set (d := fst (along _)) in *. set (e := snd (along _)) in *. clearbody u v d e.
  transitivity (/ 576 * ((u * u + v * v) * (d * d + e * e))); [field|]. rewrite U, D. field.
Qed.
Lemma frame_wall i s z x : (s < sides i)%nat -> frame i s z (wall (patch_of i) s x) = place_at i z x.
Proof.
  intros Hs. pose proof (vector_unit i s Hs) as U. cbv zeta in U. unfold frame, place_at. rewrite direction_value. cbv zeta.
  unfold PatchStatement.wall_height, PatchStatement.corner_of.
  change (PatchStatement.edge_of system tiles i s) with (edge_at (patch_of i) s).
  unfold wall. set (u := vector (patch_of i) s) in *. set (w := start (edge_at (patch_of i) s)).
  unfold put; cbn [fst snd py pz height ahead aside spot_sub]. surds.
  set (d := fst (along (tiles i))). set (e := snd (along (tiles i))).
  set (u1 := surd (ahead u)) in *. set (u2 := surd (aside u)) in *.
  apply point_eq; cbn [px py pz].
  - field.
  - transitivity (fst (corner (tiles i)) + / 24 * (surd (ahead w) * d - surd (aside w) * e) +
      / 576 * / 24 * ((u1 * u1 + u2 * u2) * ((surd (ahead x) - surd (ahead w)) * d - (surd (aside x) - surd (aside w)) * e))); [field|rewrite U; field].
  - transitivity (snd (corner (tiles i)) + / 24 * (surd (ahead w) * e + surd (aside w) * d) +
      / 576 * / 24 * ((u1 * u1 + u2 * u2) * ((surd (ahead x) - surd (ahead w)) * e + (surd (aside x) - surd (aside w)) * d))); [field|rewrite U; field].
Qed.

(** ** Left of a side *)
Notation left_of i s X := (left_of system tiles i s X).
Definition base (X : point) : R * R := (py X, pz X).
Notation in_tile i X := (in_tile system tiles i X).
Notation inside_tile i X := (inside_tile system tiles i X).

Lemma corner_base i r z : corner_of i r = base (place_at i z (start (edge_at (patch_of i) r))).
Proof. reflexivity. Qed.
Lemma left_value i r X : left_of i r X = fst (direction i r) * (snd X - snd (corner_of i r)) - snd (direction i r) * (fst X - fst (corner_of i r)).
Proof. reflexivity. Qed.
Lemma left_affine i r : affine (fun X => left_of i r (base X)).
Proof.
  exists 0, (- snd (direction i r)), (fst (direction i r)), (- (fst (direction i r) * snd (corner_of i r) - snd (direction i r) * fst (corner_of i r))).
  intros X. rewrite left_value. unfold base; cbn [fst snd]. ring.
Qed.
Lemma left_place i r z x : left_of i r (base (place_at i z x)) = / 576 * surd (left_of_edge (patch_of i) r x).
Proof.
  rewrite left_value, direction_value, (corner_base i r z). cbv zeta. pose proof (along_unit i) as D.
  unfold left_of_edge, base, place_at, put; cbn [fst snd py pz]. surds.
  set (d := fst (along (tiles i))) in *. set (e := snd (along (tiles i))) in *.
  set (u1 := surd (ahead (vector _ _))). set (u2 := surd (aside (vector _ _))).
  match goal with |- ?l = / 576 * ?r => transitivity (/ 576 * ((d * d + e * e) * r)); [field|rewrite D; ring] end.
Qed.
Lemma left_frame i s r z x : (s < sides i)%nat -> left_of i r (base (frame i s z x)) = / 576 * / 576 * surd (left_of_side (patch_of i) s r x).
Proof.
  intros Hs. unfold PatchStatement.left_of. pose proof (direction_unit i s Hs) as D.
  change (PatchStatement.corner_of system tiles i (next (PatchStatement.sides system tiles i) r)) with (corner_of i (next (side_count (patch_of i)) r)).
  rewrite (corner_base i r z), (corner_base i (next (side_count (patch_of i)) r) z), <- !(frame_wall i s z _ Hs).
  unfold left_of_side, base, frame, put; cbn [fst snd py pz]. surds.
  set (d := fst (direction i s)) in *. set (e := snd (direction i s)) in *.
  match goal with |- ?l = / 576 * / 576 * ?r => transitivity (/ 576 * / 576 * ((d * d + e * e) * r)); [field|rewrite D; ring] end.
Qed.
Lemma left_own i s z x : (s < sides i)%nat -> left_of i s (base (frame i s z x)) = / 576 * surd (aside x).
Proof.
  intros Hs. rewrite left_value. pose proof (direction_unit i s Hs) as D.
  unfold base, frame, put; cbn [fst snd py pz].
  set (d := fst (direction i s)) in *. set (e := snd (direction i s)) in *.
  transitivity (/ 576 * ((d * d + e * e) * surd (aside x))); [field|rewrite D; ring].
Qed.
Lemma in_prism_ok i z x : in_prism (patch_of i) x = true -> in_tile i (base (place_at i z x)).
Proof.
  unfold in_prism. rewrite forallb_forall. intros K r Hr. rewrite left_place. apply Rmult_le_pos; [lra|].
  apply znonneg_ok, K, in_seq. split; [lia|exact Hr].
Qed.
Lemma edge_checked i s : (s < sides i)%nat -> let p := patch_of i in
  in_prism p (apex (edge_at p s)) = true /\ (forall e, (e < rim_count p s)%nat -> in_prism p (rim_at p s e) = true /\ aside (wall p s (rim_at p s e)) = zint 0) /\
  0 < surd (aside (wall p s (apex (edge_at p s)))).
Proof.
  intros Hs p. destruct (checks (kind i) (kind_lt i)) as [_ [_ [K _]]]. specialize (K s Hs).
  unfold check_edge in K. cbv zeta in K. rewrite !andb_true_iff, !forallb_forall in K. destruct K as [[[[[[_ K1] K2] K3] K4] _] _].
  split; [exact K1|]. split; [|apply zpos_ok, K3].
  intros e He. split; [apply K2|apply zeq_ok, K4]; apply nth_In, He.
Qed.

(** ** Sides that meet *)
Notation meets i s j s' := (meets system tiles i s j s').
Lemma meets_sym i s j s' : meets i s j s' -> meets j s' i s.
Proof. intros [A [B [C [D E]]]]. repeat split; auto. Qed.
Lemma meets_turned i s j s' : meets i s j s' ->
  corner_of j s' = (fst (corner_of i s) + fst (direction i s), snd (corner_of i s) + snd (direction i s)) /\
  direction j s' = (- fst (direction i s), - snd (direction i s)).
Proof.
  intros [_ [_ [_ [A B]]]]. unfold direction. rewrite <- A, <- B.
  destruct (corner_of i s), (corner_of i (next (sides i) s)); cbn [fst snd]. split; f_equal; ring.
Qed.
Lemma meets_unique i s j s' j2 s2 : meets i s j s' -> meets i s j2 s2 -> j2 = j /\ s2 = s'.
Proof.
  intros M M2. destruct (meets_turned _ _ _ _ M) as [C D]. destruct (meets_turned _ _ _ _ M2) as [C2 D2].
  destruct M as [Hs [Hs' _]]. destruct M2 as [_ [Hs2 _]]. rewrite <- C in C2. rewrite <- D in D2. clear C D.
  assert (IN : forall k r, (r < sides k)%nat -> inside_tile k (base (frame k r 0 beside))).
  { intros k r Hr q Hq. rewrite left_frame by auto. apply Rmult_lt_0_compat; [lra|].
    destruct (checks (kind k) (kind_lt k)) as [_ [_ [K _]]]. specialize (K r Hr).
    unfold check_edge in K. cbv zeta in K. rewrite !andb_true_iff in K. destruct K as [[_ K] _]. rewrite forallb_forall in K.
    apply zpos_ok, K, in_seq. split; [lia|exact Hq]. }
  assert (E : base (frame j s' 0 beside) = base (frame j2 s2 0 beside)).
  { unfold frame, base, put; cbn [py pz]. rewrite C2, D2. reflexivity. }
  assert (j2 = j).
  { symmetry. apply (mosaic_apart _ _ tiling j j2 (base (frame j s' 0 beside))); auto.
    intros r Hr. rewrite E. left. apply IN; auto. }
  subst j2. split; auto. destruct (Nat.eq_dec s2 s') as [|NE]; auto. exfalso.
  destruct (checks (kind j) (kind_lt j)) as [_ [_ [K _]]]. specialize (K s' Hs').
  unfold check_edge in K. cbv zeta in K. rewrite !andb_true_iff in K. destruct K as [_ K]. rewrite forallb_forall in K.
  specialize (K s2 ltac:(apply in_seq; split; [lia|exact Hs2])). apply orb_true_iff in K as [K|K]; [apply Nat.eqb_eq in K; congruence|].
  apply existsb_exists in K as [r [_ K]]. set (x := start (edge_at (patch_at (kind j)) r)) in *.
  assert (L : left_of j s' (base (place_at j 0 x)) = left_of j s2 (base (place_at j 0 x))) by (rewrite !left_value, C2, D2; reflexivity).
  rewrite !left_place in L. apply orb_true_iff in K. change (patch_at (kind j)) with (patch_of j) in K.
  destruct K as [K|K]; apply zpos_ok in K; rewrite surd_sub in K; lra.
Qed.

(** For each side of a tile the one that it meets. *)
Variable across_side : nat -> nat -> nat * nat.
Hypothesis chosen : forall i s, (s < sides i)%nat -> meets i s (fst (across_side i s)) (snd (across_side i s)).
Hypothesis agree : walls_agree system tiles rise.

Lemma across_meets i s j s' : (s < sides i)%nat -> across_side i s = (j, s') -> meets i s j s'.
Proof. intros Hs E. pose proof (chosen i s Hs) as C. rewrite E in C. exact C. Qed.
Lemma across_spec i s j s' : (s < sides i)%nat -> across_side i s = (j, s') ->
  (s' < sides j)%nat /\ j <> i /\ across_side j s' = (i, s) /\
  corner_of i s = corner_of j (next (sides j) s') /\ corner_of i (next (sides i) s) = corner_of j s'.
Proof.
  intros Hs E. pose proof (across_meets i s j s' Hs E) as M. pose proof M as [_ [Hs' [N [A B]]]].
  repeat split; auto. destruct (meets_unique j s' i s _ _ (meets_sym _ _ _ _ M) (chosen j s' Hs')) as [E1 E2].
  rewrite <- E1, <- E2. apply surjective_pairing.
Qed.
Lemma meets_across i s j s' : meets i s j s' -> across_side i s = (j, s').
Proof.
  intros M. pose proof M as [Hs _]. destruct (meets_unique i s j s' _ _ M (chosen i s Hs)) as [E1 E2].
  rewrite <- E1, <- E2. apply surjective_pairing.
Qed.

(** The difference of the heights of a wall, seen from its two sides, in periods. *)
Definition step i s : Z := let '(j, s') := across_side i s in (up (wall_height i s - wall_height j s') - 1)%Z.
Lemma step_spec i s j s' : (s < sides i)%nat -> across_side i s = (j, s') -> IZR (step i s) = wall_height i s - wall_height j s'.
Proof.
  intros Hs E. destruct (agree _ _ _ _ (across_meets i s j s' Hs E)) as [z A]. unfold step. rewrite E, A.
  rewrite <- (up_tech (IZR z) z); [f_equal; lia|lra|rewrite plus_IZR; lra].
Qed.
Lemma step_opp i s j s' : (s < sides i)%nat -> across_side i s = (j, s') -> step j s' = (- step i s)%Z.
Proof.
  intros Hs E. destruct (across_spec i s j s' Hs E) as [Hs' [_ [E' _]]]. apply eq_IZR.
  rewrite opp_IZR, (step_spec i s j s' Hs E), (step_spec j s' i s Hs' E'). ring.
Qed.
Lemma frame_turn i s j s' z x : (s < sides i)%nat -> across_side i s = (j, s') ->
  frame j s' (z + IZR (step i s)) x = frame i s z (turn x).
Proof.
  intros Hs E. destruct (meets_turned _ _ _ _ (across_meets i s j s' Hs E)) as [C D].
  unfold frame. rewrite <- put_turn by reflexivity. rewrite (step_spec i s j s' Hs E), C, D.
  replace (wall_height j s' + (z + (wall_height i s - wall_height j s'))) with (wall_height i s + z) by ring. reflexivity.
Qed.

(** ** Cells *)
Inductive part := Piece (k : nat) | Join (s e : nat).
Definition cell := (nat * part * Z)%type.
Definition cell_eq_dec (a b : cell) : {a = b} + {a <> b}.
Proof. repeat decide equality. Defined.
Definition valid (c : cell) : Prop := let '(i, p, n) := c in match p with
  | Piece k => (k < length (pieces (patch_of i)))%nat
  | Join s e => (s < sides i)%nat /\ (e < rim_count (patch_of i) s)%nat /\ (i < fst (across_side i s))%nat end.
Definition piece (c : cell) : tetrahedron := let '(i, p, n) := c in match p with
  | Piece k => put_tet (/ 24) (rise i + IZR n) (corner (tiles i)) (along (tiles i)) (corners_at (patch_of i) k)
  | Join s e => let '(j, s') := across_side i s in
      put_tet (/ 576) (wall_height i s + IZR n) (corner_of i s) (direction i s) (join (patch_of i) s (patch_of j) s' e) end.

Definition ok i o := is_occupant (patch_of i) o = true.
Definition tri i o n : triangle := put_tri (/ 24) (rise i + IZR n) (corner (tiles i)) (along (tiles i)) (triangle_of (patch_of i) o).
Definition resolve i (o : occupant) (n : Z) : cell * nat := match o with
  | Facet k f => ((i, Piece k, n), f)
  | Lateral s e => let '(j, s') := across_side i s in
      if (i <? j)%nat then ((i, Join s e, n), 0%nat)
      else ((j, Join s' (rim_mate h (kind i) s (kind j) s' e), (n + step i s)%Z), 3%nat) end.
Definition beyond i (o : occupant) (n : Z) : cell * nat := match behind h (kind i) o with
  | Inner o' m => resolve i o' (n + m)
  | Wall s w => let '(j, s') := across_side i s in let '(w', m) := wall_mate h (kind i) s (kind j) s' w in
      resolve j (owner h (kind j) s' w') (n + step i s + m) end.
Definition view (cf : cell * nat) : nat * occupant * Z := match cf with
  | ((i, Piece k, n), f) => (i, Facet k f, n)
  | ((i, Join s e, n), O) => (i, Lateral s e, n)
  | ((i, Join s e, n), _) => let '(j, s') := across_side i s in
      (j, Lateral s' (rim_mate h (kind i) s (kind j) s' e), (n + step i s)%Z) end.
Definition across (cf : cell * nat) : cell * nat := match cf with
  | ((i, Join s e, n), 1%nat) => ((i, Join s (next (rim_count (patch_of i) s) e), n), 2%nat)
  | ((i, Join s e, n), 2%nat) => ((i, Join s (prev (rim_count (patch_of i) s) e), n), 1%nat)
  | _ => let '(i, o, n) := view cf in beyond i o n end.

Lemma piece_corners i k : (k < length (pieces (patch_of i)))%nat -> good_corners (corners_at (patch_of i) k) = true.
Proof.
  intros Hk. destruct (checks (kind i) (kind_lt i)) as [_ [K _]]. specialize (K _ (nth_In _ (origin_spot, origin_spot, origin_spot, origin_spot) Hk)).
  unfold corners_at. unfold check_piece in K. change (PatchChecker.patch_at system (kind i)) with (patch_of i) in K.
  destruct (nth k (pieces (patch_of i)) _) as [[[? ?] ?] ?]. rewrite !andb_true_iff in K. tauto.
Qed.
(** Two sides that meet, and their rims. *)
Lemma rims i s j s' e : (s < sides i)%nat -> across_side i s = (j, s') -> (e < rim_count (patch_of i) s)%nat ->
  let e' := rim_mate h (kind i) s (kind j) s' e in let p := patch_of i in let q := patch_of j in
  (e' < rim_count q s')%nat /\ rim_mate h (kind j) s' (kind i) s e' = e /\
  wall p s (rim_at p s e) = turn (wall q s' (rim_at q s' (next (rim_count q s') e'))) /\
  wall p s (rim_at p s (next (rim_count p s) e)) = turn (wall q s' (rim_at q s' e')) /\ good_corners (join p s q s' e) = true.
Proof.
  intros Hs E He e' p q. destruct (across_spec i s j s' Hs E) as [Hs' _].
  destruct (checks (kind i) (kind_lt i)) as [_ [_ [_ [_ [_ K]]]]]. specialize (K s (kind j) s' Hs (kind_lt j) Hs').
  unfold check_pair in K. cbv zeta in K. rewrite !andb_true_iff, !forallb_forall in K. destruct K as [[K _] _].
  specialize (K e ltac:(apply in_seq; split; [lia|exact He])). rewrite !andb_true_iff in K. destruct K as [[[[A B] C] D] G].
  apply Nat.ltb_lt in A. apply Nat.eqb_eq in B. apply spot_eq_ok in C, D. auto.
Qed.
Lemma piece_good c : valid c -> exists c0 H o d t, 0 < c0 /\ fst d * fst d + snd d * snd d = 1 /\ piece c = put_tet c0 H o d t /\ good_corners t = true.
Proof.
  destruct c as [[i [k|s e]] n]; cbn [valid piece].
  - intros Hk. exists (/ 24), (rise i + IZR n), (corner (tiles i)), (along (tiles i)), (corners_at (patch_of i) k).
    split; [lra|]. split; [apply along_unit|]. split; auto.
    apply piece_corners, Hk.
  - intros [Hs [He _]]. destruct (across_side i s) as [j s'] eqn:E.
    exists (/ 576), (wall_height i s + IZR n), (corner_of i s), (direction i s), (join (patch_of i) s (patch_of j) s' e).
    split; [lra|]. split; [apply direction_unit; auto|]. split; auto. apply (rims i s j s' e Hs E He).
Qed.
Lemma piece_vol c : valid c -> 0 < vol (piece c).
Proof. intros V. destruct (piece_good c V) as [c0 [H [o [d [t [C [D [-> G]]]]]]]]. apply put_vol; auto. Qed.
Lemma piece_acute c x : valid c -> In x (dihedrals (piece c)) -> x < PI / 2.
Proof. intros V. destruct (piece_good c V) as [c0 [H [o [d [t [C [D [-> G]]]]]]]]. apply put_acute; auto. Qed.

(** ** Occupants and facets *)
Lemma lateral_ok i s e : ok i (Lateral s e) <-> (s < sides i)%nat /\ (e < rim_count (patch_of i) s)%nat.
Proof. unfold ok. cbn [is_occupant]. rewrite andb_true_iff, !Nat.ltb_lt. reflexivity. Qed.
Lemma facet_ok i k f : ok i (Facet k f) <-> (k < length (pieces (patch_of i)))%nat /\ (f < 4)%nat.
Proof. unfold ok. cbn [is_occupant]. rewrite andb_true_iff, !Nat.ltb_lt. reflexivity. Qed.

Lemma resolve_valid i o n : ok i o -> valid (fst (resolve i o n)) /\ In (snd (resolve i o n)) I4.
Proof.
  destruct o as [k f|s e]; cbn [resolve].
  - rewrite facet_ok. intros [A B]. cbn [fst snd valid]. split; auto. cbn. lia.
  - rewrite lateral_ok. intros [Hs He]. destruct (across_side i s) as [j s'] eqn:E.
    destruct (across_spec i s j s' Hs E) as [Hs' [NE [E' _]]]. destruct (rims i s j s' e Hs E He) as [R1 _].
    destruct (Nat.ltb_spec i j); cbn [fst snd valid].
    + rewrite E. cbn. tauto.
    + rewrite E'. cbn [fst]. split; [|cbn; tauto]. repeat split; auto. lia.
Qed.
Lemma across_resolve i o n : ok i o -> across (resolve i o n) = beyond i o n.
Proof.
  destruct o as [k f|s e]; cbn [resolve]; [reflexivity|].
  rewrite lateral_ok. intros [Hs He]. destruct (across_side i s) as [j s'] eqn:E.
  destruct (across_spec i s j s' Hs E) as [Hs' [NE [E' _]]]. destruct (rims i s j s' e Hs E He) as [R1 [R2 _]].
  destruct (Nat.ltb_spec i j); cbn [across view].
  - reflexivity.
  - rewrite E', R2, (step_opp i s j s' Hs E). replace (n + step i s + - step i s)%Z with n by lia. reflexivity.
Qed.
Lemma put_tri_frame i s z f : (s < sides i)%nat ->
  put_tri (/ 24) (rise i + z) (corner (tiles i)) (along (tiles i)) f = put_tri (/ 576) (wall_height i s + z) (corner_of i s) (direction i s) (wall_all (patch_of i) s f).
Proof.
  intros Hs. destruct f as [[x y] w]. unfold put_tri, wall_all. pose proof (fun x => frame_wall i s z x Hs) as F. unfold frame, place_at in F.
  rewrite !F. reflexivity.
Qed.
Lemma resolve_facet i o n : ok i o -> turns (facet (piece (fst (resolve i o n))) (snd (resolve i o n))) (tri i o n).
Proof.
  destruct o as [k f|s e]; cbn [resolve].
  - intros _. left. cbn [fst snd piece]. rewrite put_facet. reflexivity.
  - rewrite lateral_ok. intros [Hs He]. destruct (across_side i s) as [j s'] eqn:E.
    destruct (across_spec i s j s' Hs E) as [Hs' [NE [E' _]]]. destruct (rims i s j s' e Hs E He) as [R1 [R2 [R3 [R4 _]]]].
    unfold tri. rewrite (put_tri_frame i s) by auto. cbn [triangle_of wall_all put_tri].
    destruct (Nat.ltb_spec i j); cbn [fst snd piece].
    + rewrite E. left. reflexivity.
    + rewrite E'. right; left. unfold join. cbn [put_tet facet va vb vc vd t1 t2 t3].
      pose proof (fun x => frame_turn i s j s' (IZR n) x Hs E) as F. unfold frame in F. rewrite <- plus_IZR in F. rewrite !F.
      rewrite turn_turn, <- R4, <- R3. reflexivity.
Qed.

(** Behind an occupant there is another one, with the opposite triangle. *)
Lemma beyond_spec i o n : ok i o -> exists i' o' n', ok i' o' /\ beyond i o n = resolve i' o' n' /\
  beyond i' o' n' = resolve i o n /\ opposite (tri i o n) (tri i' o' n').
Proof.
  intros K. destruct (checks (kind i) (kind_lt i)) as [C _]. specialize (C o (occupants_In _ _ K)).
  unfold beyond at 1. unfold check_occupant in C. cbv zeta in C. destruct (behind h (kind i) o) as [o' m|s w] eqn:B.
  - rewrite !andb_true_iff in C. destruct C as [[C1 C2] C3]. apply entry_eq_ok in C2.
    exists i, o', (n + m)%Z. split; [exact C1|]. split; auto. split.
    + unfold beyond. rewrite C2. f_equal. lia.
    + apply (put_opposite (/ 24) (rise i + IZR n) (corner (tiles i)) (along (tiles i))) in C3. rewrite put_tri_lift in C3.
      unfold tri. rewrite plus_IZR. replace (rise i + (IZR n + IZR m)) with (rise i + IZR n + / 24 * IZR (24 * m)) by (rewrite mult_IZR; field). exact C3.
  - rewrite !andb_true_iff, !Nat.ltb_lt in C. destruct C as [[Hs Hw] C]. apply occupant_eq_ok in C. subst o.
    destruct (across_side i s) as [j s'] eqn:E. destruct (across_spec i s j s' Hs E) as [Hs' [NE [E' _]]].
    destruct (checks (kind i) (kind_lt i)) as [_ [_ [_ [_ [_ P]]]]]. specialize (P s (kind j) s' Hs (kind_lt j) Hs').
    unfold check_pair in P. cbv zeta in P. rewrite !andb_true_iff, !forallb_forall in P. destruct P as [[_ P] _].
    specialize (P w ltac:(apply in_seq; lia)). destruct (wall_mate h (kind i) s (kind j) s' w) as [w' m] eqn:WM.
    rewrite !andb_true_iff in P. destruct P as [[P1 P2] P3]. apply Nat.ltb_lt in P1.
    destruct (wall_mate h (kind j) s' (kind i) s w') as [w2 n2] eqn:WM'. apply andb_true_iff in P2 as [P2 P2'].
    apply Nat.eqb_eq in P2. apply Z.eqb_eq in P2'. subst w2 n2.
    destruct (checks (kind j) (kind_lt j)) as [_ [_ [_ [_ [W _]]]]]. specialize (W s' w' Hs' P1). unfold check_wall in W. cbv zeta in W.
    rewrite !andb_true_iff in W. destruct W as [[W1 _] W3]. apply entry_eq_ok in W3.
    exists j, (owner h (kind j) s' w'), (n + step i s + m)%Z. split; [exact W1|]. split; auto. split.
    + unfold beyond. rewrite W3, E', WM', (step_opp i s j s' Hs E). f_equal. lia.
    + unfold tri. rewrite (put_tri_frame i s _ _ Hs), (put_tri_frame j s' _ _ Hs').
      apply (put_opposite (/ 576) (wall_height i s + IZR n) (corner_of i s) (direction i s)) in P3. rewrite put_tri_lift in P3.
      replace (wall_height i s + IZR n + / 576 * IZR (576 * m)) with (wall_height i s + (IZR n + IZR m)) in P3 by (rewrite mult_IZR; field).
      pose proof (fun x => frame_turn i s j s' (IZR n + IZR m) x Hs E) as F. unfold frame in F.
      rewrite !plus_IZR. replace (IZR n + IZR (step i s) + IZR m) with (IZR n + IZR m + IZR (step i s)) by ring.
      change (patch_at (kind j)) with (patch_of j) in P3. change (patch_at (kind i)) with (patch_of i) in P3.
      destruct (triangle_of (patch_of j) (owner h (kind j) s' w')) as [[x y] z]. cbn [wall_all turn_all put_tri] in *. rewrite !F. exact P3.
Qed.

(** The facets that contain no axis of a join are those of occupants. *)
Definition axial (cf : cell * nat) : Prop := match cf with ((_, Join _ _, _), 1%nat) | ((_, Join _ _, _), 2%nat) => True | _ => False end.
Lemma view_spec c f : valid c -> In f I4 -> ~ axial (c, f) -> exists i o n, ok i o /\ resolve i o n = (c, f).
Proof.
  intros V F A. destruct c as [[i [k|s e]] n]; cbn [valid] in V.
  - exists i, (Facet k f), n. rewrite facet_ok. split; [|reflexivity]. split; auto. cbn in F. lia.
  - destruct V as [Hs [He L]]. destruct (across_side i s) as [j s'] eqn:E. cbn [fst] in L.
    destruct (across_spec i s j s' Hs E) as [Hs' [NE [E' _]]]. destruct (rims i s j s' e Hs E He) as [R1 [R2 _]].
    cbn in F. destruct F as [<-|[<-|[<-|[<-|[]]]]]; cbn in A; try tauto.
    + exists i, (Lateral s e), n. rewrite lateral_ok. split; auto. cbn [resolve]. rewrite E. apply Nat.ltb_lt in L. rewrite L. reflexivity.
    + exists j, (Lateral s' (rim_mate h (kind i) s (kind j) s' e)), (n + step i s)%Z. rewrite lateral_ok. split; auto.
      cbn [resolve]. rewrite E'. destruct (Nat.ltb_spec j i); [lia|]. rewrite R2, (step_opp i s j s' Hs E).
      replace (n + step i s + - step i s)%Z with n by lia. reflexivity.
Qed.

Theorem mates c f : valid c -> In f I4 ->
  valid (fst (across (c, f))) /\ In (snd (across (c, f))) I4 /\ across (across (c, f)) = (c, f) /\
  opposite (facet (piece c) f) (facet (piece (fst (across (c, f)))) (snd (across (c, f)))).
Proof.
  intros V F. assert (D : axial (c, f) \/ ~ axial (c, f)).
  { destruct c as [[i [k|s e]] n], f as [|[|[|f]]]; cbn; auto. }
  destruct D as [A|A].
  - destruct c as [[i [k|s e]] n]; [cbn in A; tauto|]. cbn [valid] in V. destruct V as [Hs [He L]].
    destruct f as [|[|[|f]]]; cbn in A; try tauto; cbn [across fst snd valid piece]; destruct (across_side i s) as [j s'] eqn:E; cbn [fst] in *.
    + rewrite prev_next by auto. repeat split; auto using next_lt; [cbn; tauto|]. right; left. cbn. auto.
    + rewrite next_prev by auto. repeat split; auto using prev_lt; [cbn; tauto|]. unfold join. rewrite next_prev by auto. right; left. cbn. auto.
  - destruct (view_spec c f V F A) as [i [o [n [K R]]]]. destruct (beyond_spec i o n K) as [i' [o' [n' [K' [B [B' O]]]]]].
    rewrite <- R. rewrite (across_resolve i o n K), B. destruct (resolve_valid i' o' n' K') as [V' F'].
    split; auto. split; auto. split.
    + rewrite (across_resolve i' o' n' K'). exact B'.
    + pose proof (resolve_facet i o n K) as T. pose proof (resolve_facet i' o' n' K') as T'. rewrite R in T. cbn [fst snd] in T.
      apply turns_opposite with (f' := tri i o n) (g' := tri i' o' n'); auto.
Qed.

(** ** Each cell is over its tiles *)
Lemma piece_over i k n y : valid (i, Piece k, n) -> closed (piece (i, Piece k, n)) y -> in_tile i (base y).
Proof.
  intros V C r Hr. apply (closed_between _ y (fun y => left_of i r (base y)) (piece_vol _ V) C (left_affine i r)).
  cbn [valid piece] in *. intros v Hv. apply put_verts in Hv as [x [-> Hx]].
  apply (in_prism_ok i (IZR n)); [|exact Hr].
  destruct (checks (kind i) (kind_lt i)) as [_ [K _]]. specialize (K _ (nth_In _ (origin_spot, origin_spot, origin_spot, origin_spot) V)).
  unfold corners_at in Hx. unfold check_piece in K. change (PatchChecker.patch_at system (kind i)) with (patch_of i) in *. destruct (nth k (pieces (patch_of i)) _) as [[[? ?] ?] ?].
  rewrite !andb_true_iff in K. cbn in Hx. intuition (subst; auto).
Qed.

Lemma half_arithmetic a b c d Sm Sl Gm Gh Gk Gl : 0 <= a -> 0 <= b -> 0 <= c -> 0 <= d -> 0 < Sl ->
  0 <= a * Sm + d * Sl -> 0 <= Sl * Gm - Sm * Gl -> 0 <= Gh -> 0 <= Gk -> 0 <= Gl -> 0 <= a * Gm + b * Gh + c * Gk + d * Gl.
Proof.
  intros A B C D SL SY X GH GK GL.
  assert (0 <= b * Gh) by (apply Rmult_le_pos; auto). assert (0 <= c * Gk) by (apply Rmult_le_pos; auto).
  cut (0 <= a * Gm + d * Gl); [lra|]. apply Rmult_le_reg_l with Sl; auto. rewrite Rmult_0_r.
  replace (Sl * (a * Gm + d * Gl)) with (a * (Sl * Gm - Sm * Gl) + (a * Sm + d * Sl) * Gl) by ring.
  apply Rplus_le_le_0_compat; apply Rmult_le_pos; auto.
Qed.
Lemma affine4 (f : point -> R) t a b c d : affine f -> a + b + c + d = 1 ->
  f (combination t a b c d) = a * f (va t) + b * f (vb t) + c * f (vc t) + d * f (vd t).
Proof.
  intros [k1 [k2 [k3 [k0 F]]]] S. rewrite !F. unfold combination. unf. replace d with (1 - a - b - c) by lra. ring.
Qed.
(** The part of a join to the left of its wall is over the tile there. *)
Lemma half_join i s j s' z e1 e2 a b c d : (s < sides i)%nat -> across_side i s = (j, s') ->
  (e1 < rim_count (patch_of i) s)%nat -> (e2 < rim_count (patch_of i) s)%nat -> 0 <= a -> 0 <= b -> 0 <= c -> 0 <= d -> a + b + c + d = 1 ->
  let p := patch_of i in let q := patch_of j in
  let t := Tetrahedron (frame i s z (turn (wall q s' (apex (edge_at q s'))))) (frame i s z (wall p s (rim_at p s e1)))
    (frame i s z (wall p s (rim_at p s e2))) (frame i s z (wall p s (apex (edge_at p s)))) in
  0 <= left_of i s (base (combination t a b c d)) -> in_tile i (base (combination t a b c d)).
Proof.
  intros Hs E He1 He2 A B C D S p q t HL r Hr. destruct (across_spec i s j s' Hs E) as [Hs' _].
  destruct (edge_checked i s Hs) as [K1 [K2 K3]]. destruct (K2 e1 He1) as [I1 Z1]. destruct (K2 e2 He2) as [I2 Z2].
  destruct (checks (kind i) (kind_lt i)) as [_ [_ [_ [_ [_ P]]]]]. specialize (P s (kind j) s' Hs (kind_lt j) Hs').
  unfold check_pair in P. cbv zeta in P. rewrite !andb_true_iff in P. destruct P as [_ P]. rewrite forallb_forall in P.
  specialize (P r ltac:(apply in_seq; split; [lia|exact Hr])). apply znonneg_ok in P. rewrite surd_sub, !surd_mul in P.
  change (PatchChecker.patch_at system (kind i)) with p in P. change (PatchChecker.patch_at system (kind j)) with q in P.
  rewrite (affine4 (fun X => left_of i s (base X)) t a b c d (left_affine i s) S) in HL.
  rewrite (affine4 (fun X => left_of i r (base X)) t a b c d (left_affine i r) S).
  unfold t in *. clear t. cbn [va vb vc vd] in *. rewrite !(left_own i s) in HL by auto. fold p in Z1, Z2, K3. rewrite Z1, Z2, surd_int in HL.
  apply half_arithmetic with (Sm := / 576 * surd (aside (turn (wall q s' (apex (edge_at q s')))))) (Sl := / 576 * surd (aside (wall p s (apex (edge_at p s))))); auto.
  - apply Rmult_lt_0_compat; [lra|exact K3].
  - lra.
  - rewrite !(left_frame i s r) by auto. fold p.
    match goal with |- 0 <= ?g => match type of P with 0 <= ?x => replace g with (/ 576 * / 576 * / 576 * x) by ring end end.
    apply Rmult_le_pos; [lra|exact P].
  - unfold p. rewrite frame_wall by auto. apply in_prism_ok; auto.
  - unfold p. rewrite frame_wall by auto. apply in_prism_ok; auto.
  - unfold p. rewrite frame_wall by auto. apply in_prism_ok; auto.
Qed.
Lemma left_across i s j s' X : (s < sides i)%nat -> across_side i s = (j, s') -> left_of j s' X = - left_of i s X.
Proof.
  intros Hs E. destruct (across_spec i s j s' Hs E) as [Hs' [_ [E' [A B]]]]. unfold PatchStatement.left_of. rewrite A, B. ring.
Qed.
Lemma join_over i s e n y : valid (i, Join s e, n) -> closed (piece (i, Join s e, n)) y -> in_tile i (base y) \/ in_tile (fst (across_side i s)) (base y).
Proof.
  intros V C. pose proof (piece_vol _ V) as PV. apply hull_closed in C; auto. clear PV. cbn [valid piece] in *. destruct V as [Hs [He L]].
  destruct (across_side i s) as [j s'] eqn:E. cbn [fst] in *. destruct (across_spec i s j s' Hs E) as [Hs' [NE [E' _]]].
  destruct (rims i s j s' e Hs E He) as [R1 [R2 [R3 [R4 _]]]].
  destruct C as [a [b [c [d [A [B [C [D [S ->]]]]]]]]].
  destruct (Rle_dec 0 (left_of i s (base (combination (put_tet (/ 576) (wall_height i s + IZR n) (corner_of i s) (direction i s) (join (patch_of i) s (patch_of j) s' e)) a b c d)))) as [G|G].
  - left. apply (half_join i s j s' (IZR n) e (next (rim_count (patch_of i) s) e)); auto using next_lt.
  - right. rewrite <- (Ropp_involutive (left_of i s _)), <- (left_across i s j s' _ Hs E) in G.
    assert (T : combination (put_tet (/ 576) (wall_height i s + IZR n) (corner_of i s) (direction i s) (join (patch_of i) s (patch_of j) s' e)) a b c d =
      combination (Tetrahedron (frame j s' (IZR n + IZR (step i s)) (turn (wall (patch_of i) s (apex (edge_at (patch_of i) s)))))
        (frame j s' (IZR n + IZR (step i s)) (wall (patch_of j) s' (rim_at (patch_of j) s' (rim_mate h (kind i) s (kind j) s' e))))
        (frame j s' (IZR n + IZR (step i s)) (wall (patch_of j) s' (rim_at (patch_of j) s' (next (rim_count (patch_of j) s') (rim_mate h (kind i) s (kind j) s' e)))))
        (frame j s' (IZR n + IZR (step i s)) (wall (patch_of j) s' (apex (edge_at (patch_of j) s'))))) d c b a).
    { rewrite !(frame_turn i s j s' (IZR n) _ Hs E), turn_turn, <- R3, <- R4. unfold combination, join, put_tet, frame; cbn [va vb vc vd].
      apply point_eq; unf; ring. }
    rewrite T in *. apply (half_join j s' i s); auto using next_lt; [lra|]. lra.
Qed.

(** ** Finitely many cells meet a bounded set *)
Definition validb (c : cell) : bool := let '(i, p, n) := c in match p with
  | Piece k => (k <? length (pieces (patch_of i)))
  | Join s e => (s <? sides i) && (e <? rim_count (patch_of i) s) && (i <? fst (across_side i s)) end%nat.
Lemma validb_t c : validb c = true <-> valid c.
Proof. destruct c as [[i [k|s e]] n]; cbn [valid validb]; rewrite ?andb_true_iff, ?Nat.ltb_lt; tauto. Qed.
Lemma piece_periods i p n : piece (i, p, n) = periods n (piece (i, p, 0%Z)).
Proof.
  unfold periods. destruct p as [k|s e]; cbn [piece]; [|destruct (across_side i s) as [j s']; set (t := join _ _ _ _ _); clearbody t].
  - set (t := corners_at _ _). clearbody t. destruct t as [[[? ?] ?] ?]. unfold translate, put_tet; cbn [va vb vc vd]. rewrite !put_raise, !Rplus_0_r. reflexivity.
  - destruct t as [[[? ?] ?] ?]. unfold translate, put_tet; cbn [va vb vc vd]. rewrite !put_raise, !Rplus_0_r. reflexivity.
Qed.
Definition spread (t : tetrahedron) : R := Rabs (px (va t)) + Rabs (px (vb t)) + Rabs (px (vc t)) + Rabs (px (vd t)).
Lemma spread_ok t v : In v (verts t) -> - spread t <= px v <= spread t.
Proof.
  unfold spread. pose proof (Rabs_pos (px (va t))); pose proof (Rabs_pos (px (vb t))); pose proof (Rabs_pos (px (vc t))); pose proof (Rabs_pos (px (vd t))).
  assert (K : forall x, - Rabs x <= x <= Rabs x).
  { intros x. pose proof (Rle_abs x). pose proof (Rle_abs (- x)). rewrite Rabs_Ropp in *. lra. }
  cbn. intros [<-|[<-|[<-|[<-|[]]]]]; match goal with |- _ <= px ?v <= _ => pose proof (K (px v)) end; lra.
Qed.
Lemma periods_bound M i p n y : valid (i, p, n) -> near M origin y -> closed (piece (i, p, n)) y ->
  In n (zr (Z.to_nat (up (M + spread (piece (i, p, 0%Z)))))).
Proof.
  intros V [Y _] C. pose proof (piece_vol _ V) as PV. set (B := spread (piece (i, p, 0%Z))).
  assert (K : IZR n - B <= px y <= IZR n + B).
  { apply (closed_heights _ _ _ _ PV C). rewrite piece_periods. intros v Hv. unfold periods, translate in Hv. cbn [verts va vb vc vd In] in Hv.
    assert (X : exists w, In w (verts (piece (i, p, 0%Z))) /\ px v = px w + IZR n).
    { destruct Hv as [<-|[<-|[<-|[<-|[]]]]]; eexists; (split; [|reflexivity]); cbn; auto. }
    destruct X as [w [Hw ->]]. pose proof (spread_ok _ w Hw). fold B in H. lra. }
  cbn [origin px] in Y. rewrite Rminus_0_r in Y. apply Rabs_def2 in Y.
  destruct (archimed (M + B)) as [U _]. apply zr_In.
  assert (IZR n < IZR (up (M + B))) by lra. assert (IZR (- n) < IZR (up (M + B))) by (rewrite opp_IZR; lra).
  apply lt_IZR in H, H0. lia.
Qed.
Definition parts i : list part := map Piece (seq 0 (length (pieces (patch_of i)))) ++
  flat_map (fun s => map (Join s) (seq 0 (rim_count (patch_of i) s))) (seq 0 (sides i)).
Lemma parts_In i p n : valid (i, p, n) -> In p (parts i).
Proof.
  unfold parts. rewrite in_app_iff, in_flat_map. destruct p as [k|s e]; cbn [valid].
  - intros H. left. apply in_map, in_seq. lia.
  - intros [Hs [He _]]. right. exists s. split; [apply in_seq; lia|]. apply in_map, in_seq. lia.
Qed.
Theorem range M : exists L, finite_part cell valid L /\ reaches cell piece valid L M.
Proof.
  destruct (mosaic_locally_finite _ _ tiling M) as [F HF].
  set (T := F ++ flat_map (fun j => map (fun s => fst (across_side j s)) (seq 0 (sides j))) F).
  exists (nodup cell_eq_dec (filter validb (flat_map (fun i => flat_map (fun p => map (fun n => (i, p, n)) (zr (Z.to_nat (up (M + spread (piece (i, p, 0%Z))))))) (parts i)) T))).
  split; [split; [apply NoDup_nodup|]|].
  - intros c Hc. apply nodup_In, filter_In in Hc as [_ Hc]. apply validb_t, Hc.
  - intros [[i p] n] y V N C. apply nodup_In, filter_In. split; [|apply validb_t, V].
    apply in_flat_map. exists i. split.
    2:{ apply in_flat_map. exists p. split; [eapply parts_In, V|]. apply in_map. apply periods_bound with (y := y); auto. }
    assert (X : forall k, in_tile k (base y) -> In k F).
    { intros k Hk. destruct N as [_ [N1 N2]]. cbn [origin py pz] in N1, N2. rewrite Rminus_0_r in N1, N2. apply HF with (X := base y); auto. }
    unfold T. apply in_app_iff. destruct p as [k|s e].
    + left. apply X. eapply piece_over; eauto.
    + destruct (join_over _ _ _ _ _ V C) as [Y|Y]; [left; apply X, Y|right]. apply X in Y. cbn [valid] in V. destruct V as [Hs _].
      destruct (across_side i s) as [j s'] eqn:E. cbn [fst] in Y. destruct (across_spec i s j s' Hs E) as [Hs' [_ [E' _]]].
      apply in_flat_map. exists j. split; auto. apply in_map_iff. exists s'. rewrite E'. split; auto. apply in_seq. split; [lia|exact Hs'].
Qed.

(** ** A point in one cell *)
Theorem once_somewhere : exists x c, valid c /\ inside (piece c) x /\ forall c', valid c' -> c' <> c -> ~ closed (piece c') x.
Proof.
  destruct (checks (kind 0) (kind_lt 0)) as [_ [_ [_ [K _]]]]. unfold check_home in K. cbv zeta in K.
  change (PatchChecker.patch_at system (kind 0)) with (patch_of 0%nat) in K. destruct (home h (kind 0)) as [k x].
  rewrite !andb_true_iff, !forallb_forall in K. destruct K as [[[[[[K1 K2] K3] K4] K5] K6] K7]. apply Nat.ltb_lt in K1.
  exists (put (/ 24) (rise 0%nat) (corner (tiles 0%nat)) (along (tiles 0%nat)) x), (0%nat, Piece k, 0%Z).
  assert (E0 : put (/ 24) (rise 0%nat) (corner (tiles 0%nat)) (along (tiles 0%nat)) x = place_at 0 0 x) by (unfold place_at; rewrite Rplus_0_r; reflexivity).
  split; [exact K1|]. split.
  { cbn [piece]. rewrite Rplus_0_r. apply put_inside; auto; [lra|apply along_unit]. }
  assert (IN : forall i, in_tile i (base (place_at 0 0 x)) -> i = 0%nat).
  { intros i Hi. symmetry. apply (mosaic_apart _ _ tiling 0%nat i (base (place_at 0 0 x))); auto.
    intros r Hr. rewrite left_place. apply Rmult_lt_0_compat; [lra|]. apply zpos_ok, K3, in_seq. split; [lia|exact Hr]. }
  intros [[i p] n] V NE C. destruct p as [k'|s e].
  - pose proof C as C'. rewrite E0 in C'. apply (piece_over i k' n) in C'; auto. apply IN in C'. subst i. cbn [valid] in V.
    pose proof (piece_corners 0%nat k' V) as G.
    cbn [piece] in C. revert C. destruct (Nat.eq_dec k' k) as [->|Nk].
    + assert (n <> 0%Z) by congruence.
      destruct (Z_lt_le_dec n (-3)); [apply far_away with (u := 24%Z); auto; try lia; try apply along_unit|].
      destruct (Z_lt_le_dec 3 n); [apply far_away with (u := 24%Z); auto; try lia; try apply along_unit|].
      apply near_by with (u := 24%Z); auto; try lia; try apply along_unit. apply K5. cbn. lia.
    + apply missed_ok with (u := 24%Z); auto; try lia; try apply along_unit.
      specialize (K6 k' ltac:(apply in_seq; lia)). apply orb_true_iff in K6 as [K6|K6]; auto. apply Nat.eqb_eq in K6. congruence.
  - pose proof C as C'. rewrite E0 in C'. apply (join_over i s e n) in C'; auto. pose proof V as V'. cbn [valid] in V'. destruct V' as [Hs [He L]].
    assert (i = 0%nat). { destruct C' as [C'|C']; apply IN in C'; auto. rewrite C' in L. lia. }
    subst i. cbn [piece] in C. destruct (across_side 0%nat s) as [j s'] eqn:E. destruct (across_spec 0%nat s j s' Hs E) as [Hs' _].
    revert C. rewrite E0, <- (frame_wall 0%nat s 0 x Hs). unfold frame. rewrite Rplus_0_r.
    apply missed_ok with (u := 576%Z); auto; try lia; [apply direction_unit; auto|apply (rims 0%nat s j s' e Hs E He)|].
    specialize (K7 s ltac:(apply in_seq; split; [lia|exact Hs])). rewrite forallb_forall in K7.
    specialize (K7 (kind j) ltac:(apply in_seq; split; [lia|apply kind_lt])). rewrite forallb_forall in K7.
    specialize (K7 s' ltac:(apply in_seq; split; [lia|exact Hs'])). rewrite forallb_forall in K7.
    apply K7, in_seq. split; [lia|exact He].
Qed.

(** ** The cells of PatchStatement.v *)
Notation is_cell := (is_cell system tiles rise).
Lemma join_tet i s j s' e n : (s < sides i)%nat -> across_side i s = (j, s') ->
  piece (i, Join s e, n) = periods n (Tetrahedron
        (add (place tiles rise j (apex (edge_at (patch_of j) s'))) (Point (wall_height i s - wall_height j s') 0 0))
        (place tiles rise i (rim_at (patch_of i) s e)) (place tiles rise i (rim_at (patch_of i) s (next (rim_count (patch_of i) s) e)))
        (place tiles rise i (apex (edge_at (patch_of i) s)))).
Proof.
  intros Hs E. destruct (across_spec i s j s' Hs E) as [Hs' _]. rewrite piece_periods. f_equal. cbn [piece]. rewrite E. unfold join, put_tet.
  pose proof (fun x => frame_wall i s 0 x Hs) as F. pose proof (fun x => frame_wall j s' (0 + IZR (step i s)) x Hs') as F'.
  pose proof (fun x => frame_turn i s j s' 0 x Hs E) as T. unfold frame, place_at in F, F', T. rewrite Rplus_0_l in F', T.
  rewrite <- !T, !F, !F'. unfold place. rewrite put_raise, (step_spec i s j s' Hs E), !Rplus_0_r. reflexivity.
Qed.
Lemma is_cell_iff t : is_cell t <-> exists c, valid c /\ t = piece c.
Proof.
  split.
  - intros [i a b c d n Hin|i s j s' e n M L k He].
    + apply (In_nth _ _ (origin_spot, origin_spot, origin_spot, origin_spot)) in Hin as [m [Hm Hn]].
      exists (i, Piece m, n). split; [exact Hm|]. rewrite piece_periods. f_equal. cbn [piece]. unfold corners_at. rewrite Hn, Rplus_0_r. reflexivity.
    + pose proof M as [Hs _]. pose proof (meets_across _ _ _ _ M) as E. exists (i, Join s e, n). split; [cbn [valid]; rewrite E; auto|]. rewrite (join_tet i s j s' e n Hs E). reflexivity.
  - intros [[[i [k|s e]] n] [V ->]]; cbn [valid] in V.
    + rewrite piece_periods. cbn [piece]. rewrite Rplus_0_r. pose proof (nth_In _ (origin_spot, origin_spot, origin_spot, origin_spot) V) as I.
      unfold corners_at. destruct (nth k (pieces (patch_of i)) _) as [[[a b] c] d]. apply (piece_cell system tiles rise i a b c d n I).
    + destruct V as [Hs [He L]]. destruct (across_side i s) as [j s'] eqn:E. cbn [fst] in L. rewrite (join_tet i s j s' e n Hs E).
      apply (join_cell system tiles rise i s j s' e n (across_meets _ _ _ _ Hs E) L He).
Qed.

(** Every facet has a mate, and the domain is all of space. *)
Notation everywhere := (fun _ : point => True).
Notation every_facet := (fun _ : cell * nat => True).
Lemma mates_everywhere c f : valid c -> In f I4 -> True ->
  valid (fst (across (c, f))) /\ In (snd (across (c, f))) I4 /\ across (across (c, f)) = (c, f) /\
  opposite (facet (piece c) f) (facet (piece (fst (across (c, f)))) (snd (across (c, f)))) /\ True.
Proof. intros V F _. pose proof (mates c f V F). tauto. Qed.
Lemma no_boundary c f : valid c -> In f I4 -> True \/ forall y : point, True -> 0 < coord (piece c) f y.
Proof. auto. Qed.
Lemma open_everywhere : open everywhere.
Proof. apply opn_const. Qed.
Lemma convex_everywhere (p q : point) (s : R) : True -> True -> 0 <= s <= 1 -> True.
Proof. auto. Qed.
Lemma inside_everywhere c x : valid c -> inside (piece c) x -> True.
Proof. auto. Qed.
Lemma covered : covered_once cell piece valid everywhere.
Proof.
  exact (once_everywhere cell cell_eq_dec piece valid everywhere every_facet across piece_vol range mates_everywhere no_boundary
    open_everywhere convex_everywhere inside_everywhere once_somewhere).
Qed.

Theorem patches_tile : tiles_space is_cell /\ acute_cells is_cell.
Proof.
  pose proof piece_vol as PV. split.
  - constructor.
    + intros t Ht. apply is_cell_iff in Ht as [c [V ->]]. specialize (PV c V). lra.
    + intros M. destruct (range M) as [L [FL RG]]. exists (map piece L). intros t X Ht N H. apply is_cell_iff in Ht as [c [V ->]].
      apply in_map. apply RG with (y := X); auto. apply hull_closed; auto.
    + intros X. destruct (cover cell piece valid everywhere range open_everywhere covered X) as [c [V C]].
      { intros e He. exists X. split; auto. apply near_refl, He. }
      exists (piece c). split; [apply is_cell_iff; eauto|apply hull_closed; auto].
    + intros X t t' Ht Ht' H H'. apply is_cell_iff in Ht as [c [V ->]]. apply is_cell_iff in Ht' as [c' [V' ->]].
      f_equal. apply open_hull_inter in H; auto. apply hull_closed in H'; auto.
      apply (disjoint_closed cell cell_eq_dec piece valid everywhere piece_vol inside_everywhere covered X); auto.
    + intros X t t' Ht Ht' H H'. apply is_cell_iff in Ht as [c [V ->]]. apply is_cell_iff in Ht' as [c' [V' ->]].
      pose proof (proj1 (hull_closed _ _ (PV c V)) H) as C. pose proof (proj1 (hull_closed _ _ (PV c' V')) H') as C'.
      pose proof (fun v => face_to_face cell cell_eq_dec piece valid everywhere every_facet across piece_vol range mates_everywhere no_boundary
        convex_everywhere inside_everywhere covered X v c c' V V' C C') as FF.
      destruct H as [a [b [c0 [d [A [B [C0 [Dd [S Hx]]]]]]]]]. exists a, b, c0, d.
      repeat split; auto; intros P; apply carT_vert with (x := X); apply FF; exists a, b, c0, d; repeat split; auto.
  - intros t x Ht. apply is_cell_iff in Ht as [c [V ->]]. apply piece_acute; auto.
Qed.
End System.
