(** * Systems of patches: the cells around an edge

    Each corner of a patch has a name, a vertex and a period.  So how many cells have an edge is a count
    of pairs of names.  What passes through every facet with the edge holds for all cells with
    the edge ([around]), because [constant_around] of Cells.v says so at its middle.

    - *Axes.*  The tetrahedra of a join lie around their axis, and no others do ([valence_axis]).
    - *Edges in no side of a tile.*  The middle is an inner point of the tile.  So each cell
      with the edge is of its piece, or of a join with an apex at the edge ([valence_inside]).
    - *Edges in sides.*  Let T be a set of tiles such that behind each of their sides with the edge there
      is another tile of T.  Then each facet with the edge is that of an occupant of a
      tile in T ([walk]), and half of their number is the valence ([valence_of_tiles]).
      For an edge in one side T has two tiles ([valence_side]).

    Edges over a corner of the mosaic are in MosaicCorners.v. *)
Require Import Reals Lra Psatz NArith ZArith List Lia Bool Permutation.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Domain Euclid Checker Keys MosaicStatement MosaicPoints MosaicPatches MosaicSides MosaicTiling MosaicHeights MosaicValences MosaicEdges.
From Acutile Require Import Cells.
Import ListNotations.
Open Scope R_scope.

Section System.
Variables (G : gram) (r : nat) (system : list patch) (h : hints).
Hypothesis OK : good G r system h.
Notation patch_at a := (nth a system (Patch [] [] [])).
Notation carry := (carry G r).

(** ** Names of the corners of a patch *)
Variables (vertex : nat -> N -> point) (vertices : nat -> N).
Variables (piece_name : nat -> nat -> nat -> name) (apex_name : nat -> nat -> name) (rim_name : nat -> nat -> nat -> name).
Definition proper (a : nat) (c : name) : Prop := (fst c < vertices a)%N /\ latb r (snd c) = true.
Definition named_point (a : nat) (c : name) : point := lift (snd c) (vertex a (fst c)).
Definition lateral_names (a q e : nat) : list name := [rim_name a q e; apex_name a q; rim_name a q (next (rim_count (patch_at a) q) e)].
Definition occupant_names (a : nat) (o : occupant) : list name := match o with
  | Facet k f => map (piece_name a k) (filter (fun j => negb (Nat.eqb f j)) I4)
  | Lateral q e => lateral_names a q e end.
Record named : Prop := {
  named_pieces : forall a k, (a < length system)%nat -> (k < length (pieces (patch_at a)))%nat -> NoDup (map (piece_name a k) I4) /\
    forall j, In j I4 -> proper a (piece_name a k j) /\ vx (piece_at (patch_at a) k) j = named_point a (piece_name a k j);
  named_apexes : forall a q, (a < length system)%nat -> (q < length (pyramids (patch_at a)))%nat -> proper a (apex_name a q) /\ apex_at (patch_at a) q = named_point a (apex_name a q);
  named_rims : forall a q e, (a < length system)%nat -> (q < length (pyramids (patch_at a)))%nat -> (e < rim_count (patch_at a) q)%nat ->
    proper a (rim_name a q e) /\ rim_at (patch_at a) q e = named_point a (rim_name a q e) /\ NoDup (lateral_names a q e);
  (* no period takes one vertex to another *)
  named_apart : forall a v v' n, (a < length system)%nat -> (v < vertices a)%N -> (v' < vertices a)%N -> latb r n = true -> vertex a v = lift n (vertex a v') -> v = v';
  named_inside : forall a v, (a < length system)%nat -> (v < vertices a)%N -> in_prism r (patch_at a) (vertex a v) }.
Hypothesis NAMED : named.
(** No apex is in a side. *)
Hypothesis APEX : forall a q s, (a < length system)%nat -> (q < length (pyramids (patch_at a)))%nat -> (s < sides (patch_at a))%nat -> 0 < left_of r (patch_at a) s (apex_at (patch_at a) q).

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
Notation step := (step r system l1 l2 l3 tiles rise).
Notation wall i q := (side_of h (kind i) q).
Notation at_ := (at_ tiles rise).
Notation piece := (piece G r system h l1 l2 l3 tiles rise).
Notation valid := (valid r system h l1 l2 l3 tiles).
Notation resolve := (resolve r system h l1 l2 l3 tiles rise).
Notation beyond := (beyond r system h l1 l2 l3 tiles rise).
Notation view := (view r system h l1 l2 l3 tiles rise).
Notation across := (across r system h l1 l2 l3 tiles rise).
Notation ok := (ok system tiles).
Notation tri := (tri system tiles rise).
Notation left_of := (left_of r).
Notation kinds := (kind_lt G r system l1 l2 l3 tiles tiling).
Notation across_spec := (across_spec G r system h OK l1 l2 l3 basis right_handed tiles tiling).
Notation step_spec := (step_spec G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation step_opp := (step_opp G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation pyramid_facts := (pyramid_facts G r system h OK l1 l2 l3 tiles tiling).
Notation mate_facts := (mate_facts G r system h OK l1 l2 l3 basis right_handed tiles tiling).
Notation frame_lift := (frame_lift G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation across_resolve := (across_resolve G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation beyond_spec := (beyond_spec G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation resolve_valid := (resolve_valid G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation resolve_facet := (resolve_facet G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation view_spec := (view_spec G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation rank := (rank_eq G r system h OK).
Notation IFF := (is_cell_iff G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation PV := (piece_vol G r system h OK l1 l2 l3 basis right_handed tiles tiling rise).
Notation RG := (MosaicTiling.range G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation MT := (mates_everywhere G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation CV := (covered G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation at_inj := (at_inj G r system h OK l1 l2 l3 basis right_handed tiles tiling rise).
Notation is_cell := (MosaicStatement.is_cell l1 l2 l3 r system tiles rise).

(** *** The point of a name in a tile *)
Definition spot_of (i : nat) (c : name) : point := at_ i z30 (named_point (kind i) c).
Lemma z30_add n : zadd3 z30 n = n.
Proof. destruct n as [[? ?] ?]. unfold zadd3, z30. apply z3_eq; lia. Qed.
Lemma at_shift i n x : at_ i n x = at_ i z30 (lift n x).
Proof. rewrite at_lift, z30_add. reflexivity. Qed.
Lemma spot_shift i n c : at_ i n (named_point (kind i) c) = spot_of i (cshift n c).
Proof. unfold spot_of, named_point, cshift; cbn [fst snd]. rewrite !at_lift, z30_add, zadd3_comm. reflexivity. Qed.
Lemma named_point_inj a c c' : (a < length system)%nat -> proper a c -> proper a c' -> named_point a c = named_point a c' -> c = c'.
Proof.
  intros Ha [V L] [V' L'] E. destruct c as [v n], c' as [v' n']. unfold named_point in E. cbn [fst snd] in *.
  assert (E' : vertex a v = lift (zadd3 n' (zopp3 n)) (vertex a v')).
  { apply (f_equal (lift (zopp3 n))) in E. rewrite !lift_lift, (zadd3_comm (zopp3 n) n), zadd3_opp, lift_zero in E. rewrite E. f_equal. apply zadd3_comm. }
  assert (v = v') by (apply (named_apart NAMED a v v' _ Ha V V') in E'; auto using latb_add, latb_opp). subst v'. f_equal.
  unfold lift in E. apply pt_inj. apply point_eq; [apply (f_equal px) in E|apply (f_equal py) in E|apply (f_equal pz) in E]; unf; lra.
Qed.
Lemma spot_inj i c c' : proper (kind i) c -> proper (kind i) c' -> spot_of i c = spot_of i c' -> c = c'.
Proof. intros P P' E. apply at_inj in E. apply (named_point_inj (kind i)); auto using kinds. Qed.
Lemma proper_shift a n c : latb r n = true -> proper a c -> proper a (cshift n c).
Proof. intros L [V L']. split; cbn [fst snd cshift]; auto. apply latb_add; auto. Qed.

Lemma names_In i o n X : ok i o -> (In X (corners3 (tri i o n)) <-> exists c, In c (occupant_names (kind i) o) /\ X = spot_of i (cshift n c)).
Proof.
  destruct o as [k f|q e]; intros [Hk Hf].
  - destruct (named_pieces NAMED (kind i) k (kinds i) Hk) as [_ N]. unfold MosaicTiling.tri. cbn [triangle_of occupant_names].
    assert (F : In f I4) by (cbn; lia). change (patch_at (kind i)) with (patch_of i) in N.
    assert (E : forall Y, In Y (corners3 (map_tri (at_ i n) (facet (piece_at (patch_of i) k) f))) <-> exists j, In j I4 /\ f <> j /\ Y = at_ i n (vx (piece_at (patch_of i) k) j)).
    { intros Y. split.
      - cbn in F. destruct F as [<-|[<-|[<-|[<-|[]]]]]; cbn [facet map_tri corners3 t1 t2 t3 In];
        intros [<-|[<-|[<-|[]]]]; first [exists 0%nat; split; [cbn; tauto|split; [discriminate|reflexivity]]|exists 1%nat; split; [cbn; tauto|split; [discriminate|reflexivity]]
          |exists 2%nat; split; [cbn; tauto|split; [discriminate|reflexivity]]|exists 3%nat; split; [cbn; tauto|split; [discriminate|reflexivity]]].
      - intros [j [J [NE ->]]]. pose proof (vx_facet (piece_at (patch_of i) k) j f J F ltac:(auto)) as K. unfold corners3, map_tri in *; cbn [t1 t2 t3 In] in *. destruct K as [<-|[<-|[<-|[]]]]; auto. }
    rewrite E. split.
    + intros [j [J [NE ->]]]. exists (piece_name (kind i) k j). split; [apply in_map, filter_In; split; auto; apply negb_true_iff, Nat.eqb_neq, NE|].
      destruct (N j J) as [_ ->]. apply spot_shift.
    + intros [c [Hc ->]]. apply in_map_iff in Hc as [j [<- Hj]]. apply filter_In in Hj as [J NE]. apply negb_true_iff, Nat.eqb_neq in NE. exists j. split; auto. split; auto.
      destruct (N j J) as [_ ->]. symmetry. apply spot_shift.
  - destruct (named_apexes NAMED (kind i) q (kinds i) Hk) as [_ A]. destruct (named_rims NAMED (kind i) q e (kinds i) Hk Hf) as [_ [R1 _]].
    destruct (named_rims NAMED (kind i) q (next (rim_count (patch_of i) q) e) (kinds i) Hk (next_lt _ _ Hf)) as [_ [R2 _]].
    unfold MosaicTiling.tri. cbn [triangle_of occupant_names lateral_names map_tri corners3 t1 t2 t3 In]. change (patch_at (kind i)) with (patch_of i) in *.
    rewrite R1, R2, A, !spot_shift. split.
    + intros [<-|[<-|[<-|[]]]]; eexists; (split; [|reflexivity]); auto.
    + intros [c [[<-|[<-|[<-|[]]]] ->]]; auto.
Qed.
Lemma names_proper i o c : ok i o -> In c (occupant_names (kind i) o) -> proper (kind i) c.
Proof.
  destruct o as [k f|q e]; intros [Hk Hf] Hc.
  - cbn [occupant_names] in Hc. apply in_map_iff in Hc as [j [<- Hj]]. apply filter_In in Hj as [J _]. apply (named_pieces NAMED (kind i) k (kinds i) Hk), J.
  - cbn [occupant_names lateral_names In] in Hc. destruct Hc as [<-|[<-|[<-|[]]]].
    + apply (named_rims NAMED (kind i) q e (kinds i) Hk Hf).
    + apply (named_apexes NAMED (kind i) q (kinds i) Hk).
    + apply (named_rims NAMED (kind i) q _ (kinds i) Hk (next_lt _ _ Hf)).
Qed.
Lemma names_NoDup i o : ok i o -> NoDup (occupant_names (kind i) o).
Proof.
  destruct o as [k f|q e]; intros [Hk Hf]; cbn [occupant_names].
  - destruct (named_pieces NAMED (kind i) k (kinds i) Hk) as [N _]. revert N. generalize (piece_name (kind i) k). intros g N.
    apply NoDup_map_inj_on; [apply NoDup_filter; unfold I4; repeat constructor; cbn; intuition congruence|].
    intros x y Hx Hy E. apply filter_In in Hx as [Hx _], Hy as [Hy _]. cbn in N. inversion N as [|? ? N0 N']; subst. inversion N' as [|? ? N1 N'']; subst. inversion N'' as [|? ? N2 _]; subst.
    cbn in Hx, Hy, N0, N1, N2. destruct Hx as [<-|[<-|[<-|[<-|[]]]]], Hy as [<-|[<-|[<-|[<-|[]]]]]; auto; exfalso; intuition congruence.
  - apply (named_rims NAMED (kind i) q e (kinds i) Hk Hf).
Qed.

(** *** Resolving is injective; the two occupants of a tetrahedron of a join *)
Lemma view_resolve i o n : ok i o -> latb r n = true -> view (resolve i o n) = (i, o, n).
Proof.
  destruct o as [k f|q e]; cbn [MosaicTiling.resolve]; [reflexivity|]. intros [Hq He] L.
  destruct (pyramid_facts i q Hq) as [Hs _]. destruct (across_side i (wall i q)) as [j s'] eqn:E.
  destruct (across_spec i _ j s' Hs E) as [Hs' [NE [E' _]]]. pose proof (mate_facts i q j s' Hq E) as M.
  destruct (pyramid_mate h (kind i) q (kind j) s') as [q' m] eqn:PM. destruct M as [Hq' [W [Lm [PM' [R _]]]]]. destruct (R e He) as [He' [RM _]].
  destruct (Nat.ltb_spec i j); cbn [MosaicTiling.view].
  - reflexivity.
  - rewrite W, E', PM', RM, (step_opp i _ j s' Hs E). f_equal. clear. destruct (step i (wall i q)) as [[? ?] ?], m as [[? ?] ?], n as [[? ?] ?]. unfold zadd3, zopp3. apply z3_eq; lia.
Qed.
Lemma mate_resolve i q e n : ok i (Lateral q e) -> latb r n = true -> exists j q' e' n', j = fst (across_side i (wall i q)) /\ ok j (Lateral q' e') /\ latb r n' = true /\
  wall j q' = snd (across_side i (wall i q)) /\
  fst (resolve j (Lateral q' e') n') = fst (resolve i (Lateral q e) n) /\
  ((snd (resolve i (Lateral q e) n) = 0 /\ snd (resolve j (Lateral q' e') n') = 3) \/ (snd (resolve i (Lateral q e) n) = 3 /\ snd (resolve j (Lateral q' e') n') = 0))%nat /\
  at_ i n (rim_at (patch_of i) q e) = at_ j n' (rim_at (patch_of j) q' (next (rim_count (patch_of j) q') e')) /\
  at_ i n (rim_at (patch_of i) q (next (rim_count (patch_of i) q) e)) = at_ j n' (rim_at (patch_of j) q' e') /\
  q' = fst (pyramid_mate h (kind i) q (kind j) (snd (across_side i (wall i q)))) /\ e' = rim_mate h (kind i) q (kind j) (snd (across_side i (wall i q))) e /\
  n' = zadd3 (zadd3 n (snd (pyramid_mate h (kind i) q (kind j) (snd (across_side i (wall i q)))))) (step i (wall i q)).
Proof.
  intros [Hq He] L. cbn [MosaicTiling.resolve].
  destruct (pyramid_facts i q Hq) as [Hs _]. destruct (across_side i (wall i q)) as [j s'] eqn:E.
  destruct (across_spec i _ j s' Hs E) as [Hs' [NE [E' _]]]. pose proof (mate_facts i q j s' Hq E) as M.
  destruct (pyramid_mate h (kind i) q (kind j) s') as [q' m] eqn:PM. destruct M as [Hq' [W [Lm [PM' [R _]]]]]. destruct (R e He) as [He' [RM [R3 [R4 _]]]].
  destruct (step_spec i _ j s' Hs E) as [Ls _].
  exists j, q', (rim_mate h (kind i) q (kind j) s' e), (zadd3 (zadd3 n m) (step i (wall i q))). cbn [fst snd].
  split; [reflexivity|]. split; [split; auto|]. split; [auto using latb_add|]. split; [exact W|].
  rewrite W, E', PM', RM. cbn [fst snd]. split; [|split; [|split; [|split; [|split; [|split]]]]].
  - destruct (Nat.ltb_spec i j), (Nat.ltb_spec j i); try lia; cbn [fst]; auto. rewrite (step_opp i _ j s' Hs E). do 2 f_equal.
    clear. destruct (step i (wall i q)) as [[? ?] ?], m as [[? ?] ?], n as [[? ?] ?]. unfold zadd3, zopp3. apply z3_eq; lia.
  - destruct (Nat.ltb_spec i j), (Nat.ltb_spec j i); try lia; cbn [snd]; auto.
  - rewrite (frame_lift i _ j s' n m) by auto. rewrite <- R3. reflexivity.
  - rewrite (frame_lift i _ j s' n m) by auto. rewrite <- R4. reflexivity.
  - rewrite PM. reflexivity.
  - reflexivity.
  - rewrite PM. reflexivity.
Qed.
Lemma resolve_corners i o n X : ok i o -> latb r n = true -> (In X (corners3 (facet (piece (fst (resolve i o n))) (snd (resolve i o n)))) <-> In X (corners3 (tri i o n))).
Proof. intros K L. apply turns_corners, resolve_facet; auto. Qed.

(** *** Points in a side *)
Definition on (i s : nat) (X : point) : Prop := exists x, X = at_ i z30 x /\ left_of (patch_of i) s x = 0.
Lemma on_at i s n x : latb r n = true -> (on i s (at_ i n x) <-> left_of (patch_of i) s x = 0).
Proof.
  intros L. rewrite at_shift. split.
  - intros [y [E Y]]. apply at_inj in E. subst y. rewrite (left_lift r rank) in Y by auto. exact Y.
  - intros Z. exists (lift n x). split; auto. rewrite (left_lift r rank) by auto. exact Z.
Qed.
Lemma wall_flat i o n s w X : ok i o -> latb r n = true -> MosaicPatches.behind h (kind i) o = Wall s w -> In X (corners3 (tri i o n)) -> on i s X.
Proof.
  intros K L B HX. pose proof (good_occupants _ _ _ _ OK (kind i) o (kinds i) K) as C. unfold good_occupant in C. cbv zeta in C. rewrite B in C. destruct C as [Hs [Hw C]].
  destruct (good_wall_facets _ _ _ _ OK (kind i) o s w (kinds i) K B) as [k [f ->]].
  assert (Q : forall j k f y, is_occupant (patch_of j) (Facet k f) -> In y (corners3 (triangle_of (patch_of j) (Facet k f))) -> in_prism r (patch_of j) y).
  { intros j k0 f0 y [Hk0 _] Hy. apply facet_verts in Hy. apply (good_pieces _ _ _ _ OK (kind j) k0 (kinds j) Hk0), Hy. }
  destruct (across_side i s) as [j s'] eqn:E. destruct (across_spec i s j s' Hs E) as [Hs' [NE [E' FT]]].
  destruct (good_pairs _ _ _ _ OK (kind i) s (kind j) s' (kinds i) (kinds j) Hs Hs' FT) as [_ P]. specialize (P w Hw).
  destruct (wall_mate h (kind i) s (kind j) s' w) as [w' m]. destruct P as [P1 [Lm [_ P3]]]. rewrite C in P3.
  destruct (good_walls _ _ _ _ OK (kind j) s' w' (kinds j) Hs' P1) as [W1 W3].
  destruct (good_wall_facets _ _ _ _ OK (kind j) _ s' w' (kinds j) W1 W3) as [k' [f' EW]]. rewrite EW in *.
  assert (HX' : exists x, X = at_ i n x /\ In x (corners3 (triangle_of (patch_of i) (Facet k f)))).
  { unfold MosaicTiling.tri, map_tri, corners3 in HX; cbn [t1 t2 t3 In] in HX. destruct HX as [<-|[<-|[<-|[]]]]; eexists; (split; [reflexivity|]); cbn; auto. }
  destruct HX' as [x [-> Hx]]. apply on_at; auto. pose proof (Q i k f x K Hx s Hs) as P0.
  apply (opposite_corners _ _ P3) in Hx. unfold map_tri, corners3 in Hx; cbn [t1 t2 t3 In] in Hx.
  assert (HY : exists y, In y (corners3 (triangle_of (patch_of j) (Facet k' f'))) /\ x = lift m (carry (patch_of i) s (patch_of j) s' y)).
  { destruct Hx as [<-|[<-|[<-|[]]]]; eexists; (split; [|reflexivity]); cbn; auto. }
  destruct HY as [y [Hy ->]]. pose proof (Q j k' f' y W1 Hy s' Hs') as P4. rewrite (left_lift r rank) in * by auto.
  pose proof (side_small G r system h OK l1 l2 l3 tiles tiling i s Hs). pose proof (side_small G r system h OK l1 l2 l3 tiles tiling j s' Hs').
  rewrite (left_carry G r rank (patch_of i) s (patch_of j) s') in P4 by auto. lra.
Qed.
Lemma beyond_where i o n : ok i o -> latb r n = true -> exists i' o' n', ok i' o' /\ latb r n' = true /\ beyond i o n = resolve i' o' n' /\
  (i' = i \/ exists s, (s < sides (patch_of i))%nat /\ i' = fst (across_side i s) /\ forall X, In X (corners3 (tri i o n)) -> on i s X) /\
  forall X, In X (corners3 (tri i o n)) <-> In X (corners3 (tri i' o' n')).
Proof.
  intros K L. destruct (beyond_spec i o n K L) as [i' [o' [n' [K' [L' [B [_ O]]]]]]]. exists i', o', n'. split; auto. split; auto. split; auto.
  split; [|apply opposite_corners, O].
  pose proof (good_occupants _ _ _ _ OK (kind i) o (kinds i) K) as C. unfold good_occupant in C. cbv zeta in C.
  unfold MosaicTiling.beyond in B. destruct (MosaicPatches.behind h (kind i) o) as [o2 m|s w] eqn:BH.
  - left. destruct C as [C1 [Lm _]]. apply (f_equal view) in B. rewrite !view_resolve in B by (auto using latb_add; exact C1). injection B as <- _ _. reflexivity.
  - right. destruct C as [Hs [Hw C]]. exists s. split; auto. split; [|intros X; apply (wall_flat i o n s w X); auto].
    destruct (across_side i s) as [j s'] eqn:E. destruct (across_spec i s j s' Hs E) as [Hs' [NE [E' FT]]]. cbn [fst].
    destruct (good_pairs _ _ _ _ OK (kind i) s (kind j) s' (kinds i) (kinds j) Hs Hs' FT) as [_ P]. specialize (P w Hw).
    destruct (wall_mate h (kind i) s (kind j) s' w) as [w' m]. destruct P as [P1 [Lm _]].
    destruct (good_walls _ _ _ _ OK (kind j) s' w' (kinds j) Hs' P1) as [W1 _]. destruct (step_spec i s j s' Hs E) as [Ls _].
    apply (f_equal view) in B. rewrite !view_resolve in B by (auto using latb_add; exact W1). injection B as <- _ _. reflexivity.
Qed.

(** *** What passes through the facets around an edge *)
Definition has (c : cell) (f : nat) (u v : point) : Prop := In u (corners3 (facet (piece c) f)) /\ In v (corners3 (facet (piece c) f)).
Definition holds_edge (c : cell) (u v : point) : Prop := In u (verts (piece c)) /\ In v (verts (piece c)).
Lemma has_holds c f u v : has c f u v -> holds_edge c u v.
Proof. intros [A B]. split; eapply facet_verts; eauto. Qed.
Lemma middle_holds c d u v : valid c -> valid d -> holds_edge c u v -> closed (piece d) (middle u v) -> holds_edge d u v.
Proof.
  intros Vc Vd [U W] C. pose proof (middle_carries (piece c) u v (PV c Vc) U W) as [CU CW]. pose proof (middle_closed (piece c) u v (PV c Vc) U W) as CM.
  pose proof (fun x => Cells.face_to_face cell cell_eq_dec piece valid (fun _ => True) (fun _ => True) across PV RG MT (fun _ _ _ _ => or_introl I)
    (fun _ _ _ _ _ _ => I) (fun _ _ _ _ => I) CV (middle u v) x c d Vc Vd CM C) as FF.
  split; eapply carT_vert; apply FF; eassumption.
Qed.
Theorem around u v c0 (w : cell -> Prop) : valid c0 -> holds_edge c0 u v ->
  (forall d f, valid d -> In f I4 -> has d f u v -> w d -> w (fst (across (d, f)))) -> w c0 -> forall c, valid c -> holds_edge c u v -> w c.
Proof.
  intros V0 H0 ST W0 c V H. set (b c := if dec (w c) then 1%Z else 0%Z).
  assert (E : b c0 = b c).
  { apply (Cells.constant_around cell cell_eq_dec piece valid (fun _ => True) (fun _ => True) across PV RG MT (fun _ _ _ _ => or_introl I)
      (fun _ _ _ _ _ _ => I) (fun _ _ _ _ => I) CV (middle u v) b); auto; [|destruct H0; apply middle_closed; auto; apply PV, V0|destruct H; apply middle_closed; auto; apply PV, V].
    intros d f Vd F _ C Z. pose proof (middle_holds c0 d u v V0 Vd H0 C) as HD. destruct (MT d f Vd F I) as [V' [F' [B [O _]]]].
    assert (HA : has d f u v). { destruct HD as [U W]. apply middle_facet; auto. apply PV, Vd. }
    assert (HA' : has (fst (across (d, f))) (snd (across (d, f))) u v). { destruct HA. split; apply (opposite_corners _ _ O); auto. }
    unfold b. destruct (dec (w (fst (across (d, f))))) as [A1|A1], (dec (w d)) as [A2|A2]; auto; exfalso.
    - apply A2. pose proof (ST _ _ V' F' HA' A1) as K. rewrite <- surjective_pairing, B in K. exact K.
    - apply A1, ST; auto. }
  unfold b in E. destruct (dec (w c0)); [|contradiction]. destruct (dec (w c)); auto. discriminate.
Qed.

(** *** Counting cells *)
Lemma piece_inj c c' : valid c -> valid c' -> piece c = piece c' -> c = c'.
Proof.
  intros V V' E. pose proof (cen_inter (piece c) (PV c V)) as I0.
  apply (Cells.disjoint cell cell_eq_dec piece valid (fun _ => True) (fun _ _ _ _ => I) CV (centroid (piece c))); auto. rewrite <- E. exact I0.
Qed.
Lemma valence_from u v SL : NoDup SL -> (forall c, In c SL <-> valid c /\ holds_edge c u v) -> valence_in_cells is_cell u v (length SL).
Proof.
  intros N M. exists (map piece SL). split; [|split; [apply map_length|]].
  - apply NoDup_map_inj_on; auto. intros x y Hx Hy. apply M in Hx as [Hx _], Hy as [Hy _]. apply piece_inj; auto.
  - intros t. rewrite in_map_iff. unfold cell_with. rewrite IFF. split.
    + intros [c [<- Hc]]. apply M in Hc as [V [U W]]. split; [eauto|]. intros x [<-|[<-|[]]]; auto.
    + intros [[c [V ->]] H]. exists c. split; auto. apply M. split; auto. split; apply H; cbn; auto.
Qed.
Lemma cells_with u v : exists SL, NoDup SL /\ forall c, In c SL <-> valid c /\ holds_edge c u v.
Proof.
  destruct (near_origin_exists u) as [M [_ NM]]. destruct (RG M) as [L [[N VL] R]].
  exists (filter (fun c => if dec (holds_edge c u v) then true else false) L). split; [apply NoDup_filter, N|].
  intros c. rewrite filter_In. split.
  - intros [Hc D]. destruct (dec _); [auto|discriminate].
  - intros [V H]. destruct (dec _); [|contradiction]. split; auto. apply (R c u V NM). apply vertex_closed; [apply PV, V|apply H].
Qed.
Lemma valence_same u v m m' : valence_in_cells is_cell u v m -> valence_in_cells is_cell u v m' -> m = m'.
Proof.
  intros [L [N1 [<- H]]] [L' [N1' [<- H']]]. apply Nat.le_antisymm; apply NoDup_incl_length; auto; intros x Hx; [apply H', H, Hx|apply H, H', Hx].
Qed.

(** *** Edges in sides *)
Section Tiles.
Variables (T : nat -> Prop) (u v : point).
Hypothesis uv : u <> v.
Hypothesis T_sides : forall i s, T i -> (s < sides (patch_of i))%nat -> on i s u -> on i s v -> T (fst (across_side i s)).
Hypothesis T_flat : forall i, T i -> exists s, (s < sides (patch_of i))%nat /\ on i s u /\ on i s v.
Definition known (c : cell) (f : nat) : Prop := exists i o n, T i /\ ok i o /\ latb r n = true /\ resolve i o n = (c, f).
Lemma not_apex i q n X : T i -> (q < length (pyramids (patch_of i)))%nat -> latb r n = true -> X = u \/ X = v -> at_ i n (apex_at (patch_of i) q) <> X.
Proof.
  intros HT Hq L XX E. destruct (T_flat i HT) as [s [Hs [U W]]]. assert (O : on i s (at_ i n (apex_at (patch_of i) q))) by (rewrite E; destruct XX; subst; auto).
  apply on_at in O; auto. pose proof (APEX (kind i) q s (kinds i) Hq Hs) as A. change (patch_at (kind i)) with (patch_of i) in A. lra.
Qed.
Lemma all_known i o n : T i -> ok i o -> latb r n = true -> In u (corners3 (tri i o n)) -> In v (corners3 (tri i o n)) ->
  forall g, In g I4 -> has (fst (resolve i o n)) g u v -> known (fst (resolve i o n)) g.
Proof.
  intros HT K L U W g Hg HG. destruct o as [k f|q e].
  - destruct K as [Hk Hf]. exists i, (Facet k g), n. split; auto. split; [split; auto; cbn in Hg; lia|]. split; auto.
  - pose proof K as [Hq He]. pose proof (not_apex i q n u HT Hq L (or_introl eq_refl)) as NU. pose proof (not_apex i q n v HT Hq L (or_intror eq_refl)) as NV.
    destruct (mate_resolve i q e n K L) as [j [q' [e' [n' [EJ [K' [L' [_ [EC [SD [R1 [R2 _]]]]]]]]]]]].
    set (c := fst (resolve i (Lateral q e) n)) in *.
    destruct (resolve_valid i _ n K L) as [V F]. fold c in V.
    assert (RIM : forall X, In X (corners3 (tri i (Lateral q e) n)) -> at_ i n (apex_at (patch_of i) q) <> X -> X = at_ i n (rim_at (patch_of i) q e) \/ X = at_ i n (rim_at (patch_of i) q (next (rim_count (patch_of i) q) e))).
    { unfold MosaicTiling.tri. cbn [triangle_of map_tri corners3 t1 t2 t3 In]. intros X [<-|[<-|[<-|[]]]] NX; auto. congruence. }
    pose proof (RIM u U NU) as RU. pose proof (RIM v W NV) as RW.
    destruct (pyramid_facts i q Hq) as [Hs [_ [_ [_ [Z _]]]]].
    assert (ON : forall e, (e < rim_count (patch_of i) q)%nat -> on i (wall i q) (at_ i n (rim_at (patch_of i) q e))).
    { intros x Hx. apply on_at; auto. apply Z, Hx. }
    assert (TJ : T j).
    { rewrite EJ. apply T_sides; auto; [destruct RU as [-> | ->]|destruct RW as [-> | ->]]; apply ON; auto using next_lt. }
    assert (U' : forall X, X = at_ i n (rim_at (patch_of i) q e) \/ X = at_ i n (rim_at (patch_of i) q (next (rim_count (patch_of i) q) e)) -> In X (corners3 (tri j (Lateral q' e') n'))).
    { intros X [-> | ->]; [rewrite R1|rewrite R2]; unfold MosaicTiling.tri; cbn [triangle_of map_tri corners3 t1 t2 t3 In]; auto. }
    apply U' in RU, RW. rewrite <- resolve_corners in RU, RW by auto. rewrite EC in RU, RW. rewrite <- resolve_corners in U, W by auto. fold c in U, W.
    (* the facets with the edge are those of the two occupants *)
    destruct (Nat.eq_dec g (snd (resolve i (Lateral q e) n))) as [->|N1].
    { exists i, (Lateral q e), n. split; [exact HT|split; [exact K|split; [exact L|apply surjective_pairing]]]. }
    destruct (Nat.eq_dec g (snd (resolve j (Lateral q' e') n'))) as [->|N2].
    { exists j, (Lateral q' e'), n'. split; [exact TJ|split; [exact K'|split; [exact L'|rewrite <- EC; apply surjective_pairing]]]. }
    exfalso. destruct (resolve_valid j _ n' K' L') as [_ F']. destruct (has_holds c g u v HG) as [HU HW].
    pose proof (facets_with_length (piece c) u v (PV c V) HU HW uv) as LEN.
    assert (INC : incl [g; snd (resolve i (Lateral q e) n); snd (resolve j (Lateral q' e') n')] (facets_with (piece c) u v)).
    { intros x [<-|[<-|[<-|[]]]]; apply facets_with_In; split; auto. }
    apply NoDup_incl_length in INC; [rewrite LEN in INC; cbn in INC; lia|].
    apply NoDup_cons; [intros [E|[E|[]]]; congruence|]. apply NoDup_cons; [intros [E|[]]; destruct SD as [[A1 A2]|[A1 A2]]; congruence|]. apply NoDup_cons; [intros []|apply NoDup_nil].
Qed.
Theorem walk i0 o0 n0 : T i0 -> ok i0 o0 -> latb r n0 = true -> In u (corners3 (tri i0 o0 n0)) -> In v (corners3 (tri i0 o0 n0)) ->
  forall c f, valid c -> In f I4 -> has c f u v -> known c f.
Proof.
  intros T0 K0 L0 U0 W0 c f V F HF. pose proof (has_holds c f u v HF) as HH. revert f F HF. apply (around u v (fst (resolve i0 o0 n0)) (fun c => forall f, In f I4 -> has c f u v -> known c f)); auto.
  - apply resolve_valid; auto.
  - apply (has_holds _ (snd (resolve i0 o0 n0))). split; apply resolve_corners; auto.
  - intros d g Vd Hg HG KN. destruct (KN g Hg HG) as [i [o [n [HT [K [L E]]]]]]. rewrite <- E, across_resolve by auto.
    destruct (beyond_where i o n K L) as [i' [o' [n' [K' [L' [B [WH SAME]]]]]]]. rewrite B.
    assert (UU : In u (corners3 (tri i o n)) /\ In v (corners3 (tri i o n))).
    { destruct HG as [A1 A2]. split; apply resolve_corners; auto; rewrite E; auto. }
    apply all_known; auto; [|apply SAME, UU|apply SAME, UU].
    destruct WH as [->|[s [Hs [-> ON]]]]; auto. apply T_sides; auto; apply ON, UU.
  - apply all_known; auto.
Qed.
(** Half the number of the occupants with the edge. *)
Variables (LT : list nat) (occs : nat -> list (occupant * Z3)).
Hypothesis LT_NoDup : NoDup LT.
Hypothesis LT_In : forall i, In i LT <-> T i.
Hypothesis occs_NoDup : forall i, T i -> NoDup (occs i).
Hypothesis occs_In : forall i o n, T i -> (In (o, n) (occs i) <-> ok i o /\ latb r n = true /\ In u (corners3 (tri i o n)) /\ In v (corners3 (tri i o n))).
Lemma length_flat_map {X Y} (f : X -> list Y) l : length (flat_map f l) = list_sum (map (fun x => length (f x)) l).
Proof. induction l as [|x l IH]; cbn; auto. rewrite app_length, IH. reflexivity. Qed.
Theorem valence_of_tiles i0 o0 n0 : T i0 -> In (o0, n0) (occs i0) ->
  exists m, (2 * m = list_sum (map (fun i => length (occs i)) LT))%nat /\ valence_in_cells is_cell u v m.
Proof.
  intros T0 I0. apply occs_In in I0 as [K0 [L0 [U0 W0]]]; auto. destruct (cells_with u v) as [SL [NS IS]]. exists (length SL). split; [|apply valence_from; auto].
  set (FAC := flat_map (fun c => map (pair c) (facets_with (piece c) u v)) SL).
  set (OCC := flat_map (fun i => map (fun x => (i, fst x, snd x)) (occs i)) LT).
  assert (IF : forall c f, In (c, f) FAC <-> valid c /\ In f I4 /\ has c f u v).
  { intros c f. unfold FAC. rewrite in_flat_map. split.
    - intros [d [Hd H]]. apply in_map_iff in H as [g [E H]]. injection E as -> ->. apply facets_with_In in H as [F H]. apply IS in Hd as [V _]. auto.
    - intros [V [F H]]. exists c. split; [apply IS; split; auto; apply (has_holds c f), H|]. apply in_map, facets_with_In. auto. }
  assert (IO : forall i o n, In (i, o, n) OCC <-> T i /\ In (o, n) (occs i)).
  { intros i o n. unfold OCC. rewrite in_flat_map. split.
    - intros [j [Hj H]]. apply in_map_iff in H as [[o' n'] [E H]]. cbn [fst snd] in E. injection E as -> -> ->. apply LT_In in Hj. auto.
    - intros [Hi H]. exists i. split; [apply LT_In, Hi|]. apply in_map_iff. exists (o, n). auto. }
  assert (NF : NoDup FAC).
  { apply NoDup_flat_map; auto.
    - intros c _. apply NoDup_map_pair, NoDup_filter. unfold I4. repeat constructor; cbn; intuition congruence.
    - intros x y z _ _ H K. apply in_map_iff in H as [? [<- _]]. apply in_map_iff in K as [? [E _]]. congruence. }
  assert (NO : NoDup OCC).
  { apply NoDup_flat_map; auto.
    - intros i Hi. apply LT_In in Hi. apply FinFun.Injective_map_NoDup; auto. intros [a b] [a' b'] E. cbn [fst snd] in E. congruence.
    - intros x y z _ _ H K. apply in_map_iff in H as [? [<- _]]. apply in_map_iff in K as [? [E _]]. congruence. }
  assert (LF : length FAC = (2 * length SL)%nat).
  { unfold FAC. assert (X : forall c, In c SL -> length (facets_with (piece c) u v) = 2%nat).
    { intros c Hc. apply IS in Hc as [V [A B]]. apply facets_with_length; auto. apply PV, V. }
    clear - X. induction SL as [|c l IH]; [reflexivity|]. cbn [flat_map length]. rewrite app_length, map_length, X by (cbn; auto). rewrite IH by (intros; apply X; cbn; auto). lia. }
  assert (LO : length OCC = list_sum (map (fun i => length (occs i)) LT)).
  { unfold OCC. rewrite length_flat_map. f_equal. apply map_ext. intros i. apply map_length. }
  rewrite <- LF, <- LO, <- (map_length (fun x => let '(i, o, n) := x in resolve i o n) OCC). apply Permutation_length, NoDup_Permutation; auto.
  - apply NoDup_map_inj_on; auto. intros [[i o] n] [[i' o'] n'] H H' E. apply IO in H as [A B], H' as [A' B'].
    apply occs_In in B as [B1 [B2 _]], B' as [B1' [B2' _]]; auto. apply (f_equal view) in E. rewrite !view_resolve in E by auto. exact E.
  - intros [c f]. rewrite IF, in_map_iff. split.
    + intros [V [F H]]. destruct (walk i0 o0 n0 T0 K0 L0 U0 W0 c f V F H) as [i [o [n [HT [K [L E]]]]]]. exists (i, o, n). split; auto. apply IO. split; auto.
      apply occs_In; auto. split; auto. split; auto. destruct H as [A B]. split; apply resolve_corners; auto; rewrite E; auto.
    + intros [[[i o] n] [E H]]. apply IO in H as [HT H]. apply occs_In in H as [K [L [A B]]]; auto.
      destruct (resolve_valid i o n K L) as [V F]. rewrite E in V, F. split; auto. split; auto. split; [apply resolve_corners in A|apply resolve_corners in B]; auto; rewrite E in *; auto.
Qed.
End Tiles.

(** *** Counting by names *)
Definition occupants_of (p : patch) : list occupant := flat_map (fun k => map (Facet k) I4) (seq 0 (length (pieces p))) ++
  flat_map (fun q => map (Lateral q) (seq 0 (rim_count p q))) (seq 0 (length (pyramids p))).
Definition rim_places (p : patch) : list (nat * nat) := flat_map (fun q => map (pair q) (seq 0 (rim_count p q))) (seq 0 (length (pyramids p))).
Definition apex_pairs (a : nat) (x : nat * nat) : list (name * name) := let y := apex_name a (fst x) in
  filter (fun p => ceqb y (fst p) || ceqb y (snd p)) (ordered (lateral_names a (fst x) (snd x))).
Definition around_tile (a : nat) (c1 c2 : name) := select (occupants_of (patch_at a)) (fun o => ordered (occupant_names a o)) c1 c2.
Definition in_pieces (a : nat) (c1 c2 : name) := select (seq 0 (length (pieces (patch_at a)))) (fun k => ordered (map (piece_name a k) I4)) c1 c2.
Definition at_apexes (a : nat) (c1 c2 : name) := select (rim_places (patch_at a)) (apex_pairs a) c1 c2.
Lemma occupants_of_In p o : In o (occupants_of p) <-> is_occupant p o.
Proof.
  unfold occupants_of. rewrite in_app_iff, !in_flat_map. destruct o as [k f|q e]; cbn [is_occupant]; split.
  - intros [[x [Hx H]]|[x [_ H]]]; apply in_map_iff in H as [y [E H]]; [|discriminate]. injection E as -> ->. apply in_seq in Hx. cbn in H. lia.
  - intros [A B]. left. exists k. split; [apply in_seq; lia|]. apply in_map. cbn. lia.
  - intros [[x [_ H]]|[x [Hx H]]]; apply in_map_iff in H as [y [E H]]; [discriminate|]. injection E as -> ->. apply in_seq in Hx, H. lia.
  - intros [A B]. right. exists q. split; [apply in_seq; lia|]. apply in_map, in_seq. lia.
Qed.
Lemma occupants_of_NoDup p : NoDup (occupants_of p).
Proof.
  unfold occupants_of. apply NoDup_app_disj.
  - apply NoDup_flat_map; [apply seq_NoDup| |].
    + intros k _. apply FinFun.Injective_map_NoDup; [intros x y E; congruence|unfold I4; repeat constructor; cbn; intuition congruence].
    + intros x y z _ _ H K. apply in_map_iff in H as [? [<- _]]. apply in_map_iff in K as [? [E _]]. congruence.
  - apply NoDup_flat_map; [apply seq_NoDup| |].
    + intros k _. apply FinFun.Injective_map_NoDup; [intros x y E; congruence|apply seq_NoDup].
    + intros x y z _ _ H K. apply in_map_iff in H as [? [<- _]]. apply in_map_iff in K as [? [E _]]. congruence.
  - intros o H K. apply in_flat_map in H as [k [_ H]]. apply in_flat_map in K as [q [_ K]]. apply in_map_iff in H as [? [<- _]]. apply in_map_iff in K as [? [E _]]. discriminate.
Qed.
Lemma rim_places_In p q e : In (q, e) (rim_places p) <-> is_occupant p (Lateral q e).
Proof.
  unfold rim_places. rewrite in_flat_map. cbn [is_occupant]. split.
  - intros [x [Hx H]]. apply in_map_iff in H as [y [E H]]. injection E as -> ->. apply in_seq in Hx, H. lia.
  - intros [A B]. exists q. split; [apply in_seq; lia|]. apply in_map, in_seq. lia.
Qed.
Lemma rim_places_NoDup p : NoDup (rim_places p).
Proof.
  apply NoDup_flat_map; [apply seq_NoDup| |].
  - intros k _. apply NoDup_map_pair, seq_NoDup.
  - intros x y z _ _ H K. apply in_map_iff in H as [? [<- _]]. apply in_map_iff in K as [? [E _]]. congruence.
Qed.
Lemma latb_shift a n c : proper a c -> proper a (cshift n c) -> latb r n = true.
Proof.
  intros [_ L] [_ L']. cbn [cshift snd] in L'. replace n with (zadd3 (zadd3 (snd c) n) (zopp3 (snd c))); [auto using latb_add, latb_opp|].
  destruct (snd c) as [[? ?] ?], n as [[? ?] ?]. unfold zadd3, zopp3. apply z3_eq; lia.
Qed.
Lemma around_tile_In i c1 c2 o n : proper (kind i) c1 -> proper (kind i) c2 -> c1 <> c2 ->
  (In (o, n) (around_tile (kind i) c1 c2) <-> ok i o /\ latb r n = true /\ In (spot_of i c1) (corners3 (tri i o n)) /\ In (spot_of i c2) (corners3 (tri i o n))).
Proof.
  intros P1 P2 N. unfold around_tile. rewrite select_In, occupants_of_In. change (patch_at (kind i)) with (patch_of i). split.
  - intros [K [[x y] [Hp [E1 E2]]]]. cbn [fst snd] in *. apply ordered_In in Hp as [Hx [Hy _]]. split; [exact K|]. pose proof (names_proper i o x K Hx) as Px.
    assert (L : latb r n = true) by (apply (latb_shift (kind i) n x); auto; rewrite E1; auto). split; [exact L|]. split; apply names_In; eauto; [exists x|exists y]; rewrite ?E1, ?E2; auto.
  - intros [K [L [A B]]]. split; [exact K|]. apply names_In in A as [x [Hx Ex]], B as [y [Hy Ey]]; auto.
    pose proof (names_proper i o x K Hx) as Px. pose proof (names_proper i o y K Hy) as Py.
    apply spot_inj in Ex, Ey; auto using proper_shift. exists (x, y). cbn [fst snd]. split; auto. apply ordered_In. split; auto. split; auto. intros ->. congruence.
Qed.
Lemma around_tile_NoDup i c1 c2 : NoDup (around_tile (kind i) c1 c2).
Proof.
  apply select_NoDup; [apply occupants_of_NoDup|]. intros o Ho. apply occupants_of_In in Ho. apply ordered_NoDup, names_NoDup. exact Ho.
Qed.
Lemma around_tile_shift a m c1 c2 : length (around_tile a (cshift m c1) (cshift m c2)) = length (around_tile a c1 c2).
Proof. unfold around_tile. rewrite !select_length, edge_key_shift. reflexivity. Qed.

(** *** The sides of a convex tile *)
Notation CONVEX := (good_convex _ _ _ _ OK).
Notation left_place := (left_place r).
Notation finish_next := (finish_next r).
Notation left_start := (left_start r).
Notation left_prev := (left_prev r).
Lemma next_neq n s : (3 <= n)%nat -> (s < n)%nat -> next n s <> s /\ prev n s <> s /\ next n s <> prev n s.
Proof. intros N H. unfold next, prev. destruct s as [|s]; [destruct (Nat.eqb_spec 1 n)|destruct (Nat.eqb_spec (S (S s)) n)]; lia. Qed.
Lemma corner_point a s t y : r = 1%nat -> (a < length system)%nat -> (s < sides (patch_at a))%nat -> (t < sides (patch_at a))%nat -> t <> s ->
  in_prism r (patch_at a) y -> left_of (patch_at a) s y = 0 -> left_of (patch_at a) t y = 0 ->
  (t = prev (sides (patch_at a)) s /\ same_place y (start (edge_at (patch_at a) s))) \/ (t = next (sides (patch_at a)) s /\ same_place y (finish r (patch_at a) s)).
Proof.
  intros R Ha Hs Ht NE IP Zs Zt. set (p := patch_at a) in *. set (n := sides p) in *.
  destruct (CONVEX R a s s Ha Hs Hs) as [N3 _]. fold p n in N3. destruct (next_neq n s N3 Hs) as [Q1 [Q2 Q3]].
  pose proof (next_lt n s Hs) as Hn. pose proof (prev_lt n s Hs) as Hp.
  assert (AT : forall x, same_place x (start (edge_at p (next n s))) -> forall k, left_of p k x = left_of p k (start (edge_at p (next n s)))) by (intros x X k; apply left_place; auto).
  pose proof (fun k Hk => proj2 (CONVEX R a s k Ha Hs Hk)) as CA. pose proof (fun k Hk => proj2 (CONVEX R a (next n s) k Ha Hn Hk)) as CB. fold p n in CA, CB.
  set (A := start (edge_at p s)) in *. set (B := start (edge_at p (next n s))) in *.
  rewrite prev_next in CB by auto.
  (* the point divides the side *)
  assert (U : (py B - py A) * (py B - py A) + (pz B - pz A) * (pz B - pz A) <> 0).
  { intros E. apply Rplus_sqr_eq_0 in E as [EY EZ].
    pose proof (CA (next n s) Hn Q1 Q3) as P. rewrite (left_place p (next n s) A B R) in P by (split; lra). unfold B in P. rewrite left_start in P by auto. lra. }
  set (uu := (py B - py A) * (py B - py A) + (pz B - pz A) * (pz B - pz A)) in *.
  set (la := ((py y - py A) * (py B - py A) + (pz y - pz A) * (pz B - pz A)) / uu).
  assert (ZE : (py B - py A) * (pz y - pz A) - (pz B - pz A) * (py y - py A) = 0).
  { revert Zs. unfold MosaicStatement.left_of, finish. rewrite R. fold A. fold n. fold B. cbn [py pz]. auto. }
  assert (EY : py y = py A + la * (py B - py A)).
  { apply Rmult_eq_reg_l with uu; auto. unfold la. transitivity (uu * py A + ((py y - py A) * (py B - py A) + (pz y - pz A) * (pz B - pz A)) * (py B - py A)); [|field; auto].
    assert (X : (pz B - pz A) * ((py B - py A) * (pz y - pz A) - (pz B - pz A) * (py y - py A)) = 0) by (rewrite ZE; ring). unfold uu. lra. }
  assert (EZ : pz y = pz A + la * (pz B - pz A)).
  { apply Rmult_eq_reg_l with uu; auto. unfold la. transitivity (uu * pz A + ((py y - py A) * (py B - py A) + (pz y - pz A) * (pz B - pz A)) * (pz B - pz A)); [|field; auto].
    assert (X : (py B - py A) * ((py B - py A) * (pz y - pz A) - (pz B - pz A) * (py y - py A)) = 0) by (rewrite ZE; ring). unfold uu. lra. }
  assert (F : forall k, left_of p k y = (1 - la) * left_of p k A + la * left_of p k B).
  { intros k. unfold MosaicStatement.left_of. rewrite R, EY, EZ. ring. }
  clearbody la. clear ZE U uu.
  pose proof (CB (prev n s) Hp ltac:(auto) Q2) as P1. pose proof (left_prev p s R Hs) as P2. fold n A in P2. pose proof (IP (prev n s) Hp) as P3. rewrite F, P2 in P3.
  pose proof (CA (next n s) Hn Q1 Q3) as P4. assert (P5 : left_of p (next n s) B = 0) by (apply left_start, R). pose proof (IP (next n s) Hn) as P6. rewrite F, P5 in P6.
  assert (L0 : 0 <= la) by nra. assert (L1 : la <= 1) by nra.
  destruct (Nat.eq_dec t (prev n s)) as [->|N1]; [left|right].
  - split; auto. rewrite F, P2 in Zt. assert (la = 0) by nra. subst la. split; lra.
  - destruct (Nat.eq_dec t (next n s)) as [->|N2].
    + split; auto. rewrite F, P5 in Zt. assert (la = 1) by nra. destruct (finish_next p s R) as [E1 E2]. fold n B in E1, E2. subst la. split; [rewrite E1|rewrite E2]; lra.
    + exfalso. pose proof (CA t Ht NE N1). pose proof (CB t Ht N2 NE). rewrite F in Zt. destruct (Req_dec la 0) as [->|]; nra.
Qed.
Lemma two_sides_2 a s t y : r = 2%nat -> (a < length system)%nat -> (s < sides (patch_at a))%nat -> (t < sides (patch_at a))%nat -> t <> s ->
  left_of (patch_at a) s y = 0 -> left_of (patch_at a) t y = 0 -> False.
Proof.
  intros R Ha Hs Ht NE Z1 Z2. pose proof (good_sides _ _ _ _ OK a Ha R) as TWO. destruct (good_homes _ _ _ _ OK a Ha) as [k [x [_ [_ [P _]]]]].
  pose proof (P 0%nat ltac:(lia)) as P0. pose proof (P 1%nat ltac:(lia)) as P1. unfold MosaicStatement.left_of in *. rewrite R in *.
  assert (C : (s = 0 /\ t = 1 \/ s = 1 /\ t = 0)%nat) by lia. destruct C as [[-> ->]|[-> ->]]; lra.
Qed.
Lemma carry_start p s q s' x : r = 1%nat -> fits G r p s q s' -> same_place x (start (edge_at q s')) -> same_place (carry p s q s' x) (finish r p s).
Proof.
  intros R [_ [_ L]] [A B]. destruct (L R) as [_ N]. unfold MosaicPatches.carry, same_place. rewrite R. cbn [px py pz sub]. rewrite A, B. clear A B.
  unfold along. rewrite R in *. set (u := sub (finish 1 p s) (start (edge_at p s))) in *. split; [transitivity (py (start (edge_at p s)) + py u)|transitivity (pz (start (edge_at p s)) + pz u)];
  try (unfold u; cbn [py pz sub]; ring); field; exact N.
Qed.
Lemma carry_finish p s q s' x : r = 1%nat -> fits G r p s q s' -> same_place x (finish r q s') -> same_place (carry p s q s' x) (start (edge_at p s)).
Proof.
  intros R [_ [_ L]] [A B]. destruct (L R) as [E N]. unfold MosaicPatches.carry, same_place. rewrite R in *. cbn [px py pz sub]. rewrite A, B. clear A B L.
  change (py (finish 1 q s') - py (start (edge_at q s'))) with (py (along 1 q s')). change (pz (finish 1 q s') - pz (start (edge_at q s'))) with (pz (along 1 q s')).
  change (g22 G * (py (along 1 q s') * py (along 1 q s')) + g33 G * (pz (along 1 q s') * pz (along 1 q s')) + g23 G * (py (along 1 q s') * pz (along 1 q s') + pz (along 1 q s') * py (along 1 q s'))) with (length2 G 1 q s').
  rewrite <- E. split; field; exact N.
Qed.

(** ** The valences that an edge of a patch can have *)
Variable neighbour : nat -> nat -> nat -> nat -> N -> name.
Hypothesis NEIGHBOUR : forall a s b s' v, (a < length system)%nat -> (b < length system)%nat -> (s < sides (patch_at a))%nat -> (s' < sides (patch_at b))%nat ->
  fits G r (patch_at a) s (patch_at b) s' -> (v < vertices a)%N -> left_of (patch_at a) s (vertex a v) = 0 ->
  proper b (neighbour a s b s' v) /\ vertex a v = carry (patch_at a) s (patch_at b) s' (named_point b (neighbour a s b s' v)).
Definition across_name (a s b s' : nat) (c : name) : name := cshift (snd c) (neighbour a s b s' (fst c)).
Definition on_side (a s : nat) (c : name) : Prop := left_of (patch_at a) s (vertex a (fst c)) = 0.
Inductive possible (a : nat) (c1 c2 : name) : nat -> Prop :=
  | possible_inside : (forall s, (s < sides (patch_at a))%nat -> ~ (on_side a s c1 /\ on_side a s c2)) -> possible a c1 c2 (length (in_pieces a c1 c2) + length (at_apexes a c1 c2))
  | possible_side s b s' m : (s < sides (patch_at a))%nat -> on_side a s c1 -> on_side a s c2 ->
      (forall t, (t < sides (patch_at a))%nat -> on_side a t c1 -> on_side a t c2 -> t = s) ->
      (b < length system)%nat -> (s' < sides (patch_at b))%nat -> fits G r (patch_at a) s (patch_at b) s' ->
      (2 * m = length (around_tile a c1 c2) + length (around_tile b (across_name a s b s' c1) (across_name a s b s' c2)))%nat -> possible a c1 c2 m
  | possible_corner s t : (s < sides (patch_at a))%nat -> (t < sides (patch_at a))%nat -> t <> s -> on_side a s c1 -> on_side a s c2 -> on_side a t c1 -> on_side a t c2 -> possible a c1 c2 6.
Lemma on_spot i s c : proper (kind i) c -> (on i s (spot_of i c) <-> on_side (kind i) s c).
Proof. intros [_ L]. unfold spot_of, named_point. rewrite at_lift, z30_add. apply (on_at i s (snd c)), L. Qed.
Lemma spot_inside i c : proper (kind i) c -> exists x, spot_of i c = at_ i z30 x /\ in_prism r (patch_of i) x /\ forall s, left_of (patch_of i) s x = left_of (patch_of i) s (vertex (kind i) (fst c)).
Proof.
  intros [V L]. exists (named_point (kind i) c). split; [reflexivity|]. unfold named_point. split.
  - intros s Hs. rewrite (left_lift r rank) by auto. apply (named_inside NAMED (kind i) (fst c) (kinds i) V s Hs).
  - intros s. apply (left_lift r rank), L.
Qed.
(** The name in the next tile. *)
Lemma across_spot i s j s' c : (s < sides (patch_of i))%nat -> across_side i s = (j, s') -> proper (kind i) c -> on_side (kind i) s c ->
  proper (kind j) (cshift (step i s) (across_name (kind i) s (kind j) s' c)) /\ spot_of i c = spot_of j (cshift (step i s) (across_name (kind i) s (kind j) s' c)).
Proof.
  intros Hs E [V L] O. destruct (across_spec i s j s' Hs E) as [Hs' [_ [_ FT]]]. destruct (step_spec i s j s' Hs E) as [Ls F].
  destruct (NEIGHBOUR (kind i) s (kind j) s' (fst c) (kinds i) (kinds j) Hs Hs' FT V O) as [P X]. split; [apply proper_shift; auto; apply proper_shift; auto|].
  unfold across_name. rewrite <- cshift_shift, <- spot_shift. rewrite (zadd3_comm (step i s)), F by auto.
  change (patch_at (kind i)) with (patch_of i) in X. change (patch_at (kind j)) with (patch_of j) in X. rewrite <- X. unfold spot_of, named_point. rewrite at_lift, z30_add. reflexivity.
Qed.

Theorem valence_side i s o n c1 c2 : proper (kind i) c1 -> proper (kind i) c2 -> c1 <> c2 -> ok i o -> latb r n = true ->
  In (spot_of i c1) (corners3 (tri i o n)) -> In (spot_of i c2) (corners3 (tri i o n)) ->
  (s < sides (patch_of i))%nat -> on_side (kind i) s c1 -> on_side (kind i) s c2 ->
  (forall t, (t < sides (patch_of i))%nat -> on_side (kind i) t c1 -> on_side (kind i) t c2 -> t = s) ->
  exists m, possible (kind i) c1 c2 m /\ valence_in_cells is_cell (spot_of i c1) (spot_of i c2) m.
Proof.
  intros P1 P2 N K L I1 I2 Hs O1 O2 U. destruct (across_side i s) as [j s'] eqn:E. destruct (across_spec i s j s' Hs E) as [Hs' [NE [E' FT]]].
  destruct (across_spot i s j s' c1 Hs E P1 O1) as [Q1 S1]. destruct (across_spot i s j s' c2 Hs E P2 O2) as [Q2 S2].
  set (d1 := cshift (step i s) (across_name (kind i) s (kind j) s' c1)) in *. set (d2 := cshift (step i s) (across_name (kind i) s (kind j) s' c2)) in *.
  set (u := spot_of i c1) in *. set (v := spot_of i c2) in *.
  assert (UV : u <> v) by (intros X; apply N, (spot_inj i); auto).
  assert (ND : d1 <> d2) by (intros X; apply UV; rewrite S1, S2, X; reflexivity).
  destruct (spot_inside i c1 P1) as [x1 [X1 [IX1 LX1]]]. destruct (spot_inside i c2 P2) as [x2 [X2 [IX2 LX2]]].
  destruct (spot_inside j d1 Q1) as [y1 [Y1 [IY1 LY1]]]. destruct (spot_inside j d2 Q2) as [y2 [Y2 [IY2 LY2]]].
  rewrite <- S1 in Y1. rewrite <- S2 in Y2. fold u in X1. fold v in X2.
  (* both names of a corner *)
  destruct (step_spec i s j s' Hs E) as [Ls F].
  assert (FR : forall x y, at_ i z30 x = at_ j z30 y -> x = carry (patch_of i) s (patch_of j) s' (lift (zopp3 (step i s)) y)).
  { intros x y XY. apply (at_inj i z30). rewrite <- F by apply latb_zero. rewrite z30_add, at_lift, zadd3_opp. exact XY. }
  assert (FY : forall x y, at_ i z30 x = at_ j z30 y -> left_of (patch_of i) s x = - left_of (patch_of j) s' y).
  { intros x y XY. rewrite (FR x y XY). pose proof (side_small G r system h OK l1 l2 l3 tiles tiling i s Hs). pose proof (side_small G r system h OK l1 l2 l3 tiles tiling j s' Hs').
    pose proof (left_carry G r rank (patch_of i) s (patch_of j) s' (lift (zopp3 (step i s)) y) ltac:(auto) ltac:(auto) FT) as LC. rewrite (left_lift r rank) in LC by (apply latb_opp, Ls). lra. }
  assert (Z1 : left_of (patch_of j) s' y1 = 0). { pose proof (FY x1 y1 ltac:(congruence)) as K1. rewrite LX1 in K1. unfold on_side in O1. change (patch_at (kind i)) with (patch_of i) in O1. lra. }
  assert (Z2 : left_of (patch_of j) s' y2 = 0). { pose proof (FY x2 y2 ltac:(congruence)) as K1. rewrite LX2 in K1. unfold on_side in O2. change (patch_at (kind i)) with (patch_of i) in O2. lra. }
  assert (ONLY : forall t, (t < sides (patch_of j))%nat -> on j t u -> on j t v -> t = s').
  { intros t Ht [z1 [V1 W1]] [z2 [V2 W2]]. rewrite Y1 in V1. rewrite Y2 in V2. apply at_inj in V1, V2. subst z1 z2.
    destruct (Nat.eq_dec t s') as [|NT]; auto. exfalso. destruct rank as [R|R]; [|apply (two_sides_2 (kind j) s' t y1 R (kinds j) Hs' Ht NT Z1 W1)].
    pose proof (corner_point (kind j) s' t y1 R (kinds j) Hs' Ht NT IY1 Z1 W1) as C1. pose proof (corner_point (kind j) s' t y2 R (kinds j) Hs' Ht NT IY2 Z2 W2) as C2.
    change (patch_at (kind j)) with (patch_of j) in *.
    destruct (CONVEX R (kind i) s s (kinds i) Hs Hs) as [N3 _]. destruct (next_neq _ s N3 Hs) as [M1 [M2 _]]. change (patch_at (kind i)) with (patch_of i) in *.
    destruct (CONVEX R (kind j) s' s' (kinds j) Hs' Hs') as [N3' _]. destruct (next_neq _ s' N3' Hs') as [_ [_ M3]]. change (patch_at (kind j)) with (patch_of j) in M3.
    pose proof (FR x1 y1 ltac:(congruence)) as EX1. pose proof (FR x2 y2 ltac:(congruence)) as EX2.
    assert (LS : forall y, same_place (lift (zopp3 (step i s)) y) y).
    { intros y. apply latb_opp, latb_iff in Ls. revert Ls. generalize (zopp3 (step i s)). intros [[n1 n2] n3] Ls. rewrite R in Ls. cbn in Ls. destruct Ls as [-> ->]. unfold lift, pt. split; unf; ring. }
    assert (TR : forall a b c, same_place a b -> same_place b c -> same_place a c) by (intros a b c [A B] [A' B']; split; congruence).
    assert (GO : forall k c x y, (k < sides (patch_of i))%nat -> x = carry (patch_of i) s (patch_of j) s' (lift (zopp3 (step i s)) y) ->
       (forall s0, left_of (patch_of i) s0 x = left_of (patch_of i) s0 (vertex (kind i) (fst c))) ->
       (k = next (sides (patch_of i)) s /\ same_place y (start (edge_at (patch_of j) s'))) \/ (k = prev (sides (patch_of i)) s /\ same_place y (finish r (patch_of j) s')) -> on_side (kind i) k c).
    { intros k c x y Hk EX LX D. unfold on_side. change (patch_at (kind i)) with (patch_of i). rewrite <- LX. destruct D as [[-> D]|[-> D]].
      - assert (SP : same_place x (start (edge_at (patch_of i) (next (sides (patch_of i)) s)))).
        { rewrite EX. eapply TR; [apply carry_start; auto; eapply TR; [apply LS|exact D]|apply finish_next, R]. }
        rewrite (left_place _ _ _ _ R SP). apply left_start, R.
      - assert (SP : same_place x (start (edge_at (patch_of i) s))).
        { rewrite EX. apply carry_finish; auto. eapply TR; [apply LS|exact D]. }
        rewrite (left_place _ _ _ _ R SP). apply left_prev; auto. }
    destruct C1 as [[T1 D1]|[T1 D1]], C2 as [[T2 D2]|[T2 D2]]; try congruence.
    - apply M1, U; [apply next_lt, Hs|apply (GO _ c1 x1 y1 (next_lt _ _ Hs) EX1 LX1); left; split; [reflexivity|exact D1]|apply (GO _ c2 x2 y2 (next_lt _ _ Hs) EX2 LX2); left; split; [reflexivity|exact D2]].
    - apply M2, U; [apply prev_lt, Hs|apply (GO _ c1 x1 y1 (prev_lt _ _ Hs) EX1 LX1); right; split; [reflexivity|exact D1]|apply (GO _ c2 x2 y2 (prev_lt _ _ Hs) EX2 LX2); right; split; [reflexivity|exact D2]]. }
  set (occs k := if Nat.eqb k i then around_tile (kind i) c1 c2 else around_tile (kind j) d1 d2).
  destruct (valence_of_tiles (fun k => k = i \/ k = j) u v UV) with (LT := [i; j]) (occs := occs) (i0 := i) (o0 := o) (n0 := n) as [m [SUM VAL]].
  - intros k t [->| ->] Ht A B.
    + apply on_spot in A, B; auto. rewrite (U t Ht A B), E. auto.
    + rewrite (ONLY t Ht A B), E'. auto.
  - intros k [->| ->]; [exists s|exists s']; (split; [auto|]).
    + split; apply on_spot; auto.
    + split; [exists y1|exists y2]; auto.
  - repeat constructor; cbn; intuition congruence.
  - intros k. cbn. intuition congruence.
  - intros k _. unfold occs. destruct (Nat.eqb k i); apply around_tile_NoDup.
  - intros k o' n' [->| ->]; unfold occs.
    + rewrite Nat.eqb_refl. apply around_tile_In; auto.
    + destruct (Nat.eqb_spec j i); [congruence|]. rewrite around_tile_In by auto. rewrite S1, S2. reflexivity.
  - auto.
  - unfold occs. rewrite Nat.eqb_refl. apply around_tile_In; auto.
  - exists m. split; [|exact VAL]. apply (possible_side (kind i) c1 c2 s (kind j) s'); auto using kinds.
    rewrite SUM. unfold occs. cbn [map list_sum fold_right]. rewrite Nat.eqb_refl. destruct (Nat.eqb_spec j i); [congruence|]. unfold d1, d2. rewrite around_tile_shift. cbn [list_sum fold_right]. lia.
Qed.

(** *** Edges inside of a tile *)
Lemma at_middle i n x y : at_ i n (middle x y) = middle (at_ i n x) (at_ i n y).
Proof. unfold MosaicSides.at_, MosaicStatement.spot, MosaicStatement.place, MosaicPoints.lift, middle, at_coordinates. destruct (axes (tiles i)) as [[m1 m2] m3]. apply point_eq; unf; field. Qed.
Lemma left_middle p s x y : left_of p s (middle x y) = (left_of p s x + left_of p s y) / 2.
Proof. unfold MosaicStatement.left_of, middle. destruct rank as [-> | ->]; [unf; field|]. destruct s; unf; field. Qed.
Lemma within_at i n x : latb r n = true -> inside_prism r (patch_of i) x -> within r system tiles i (at_ i n x).
Proof.
  intros L P. exists (add (MosaicPoints.lift n x) (rise i)). split; [reflexivity|]. intros s Hs.
  rewrite (left_fibre r rank) by apply high. rewrite (left_lift r rank) by auto. apply P, Hs.
Qed.
Lemma at_over i n x : latb r n = true -> in_prism r (patch_of i) x -> over r system tiles i (at_ i n x).
Proof. intros L P. apply (over_at G r system h OK l1 l2 l3 tiles rise high); auto. Qed.
Lemma tri_inside i o n X : ok i o -> latb r n = true -> In X (corners3 (tri i o n)) -> exists y, X = at_ i z30 y /\ in_prism r (patch_of i) y.
Proof.
  intros K L H. apply names_In in H as [c [Hc ->]]; auto. destruct (spot_inside i (cshift n c)) as [x [E [I _]]]; [apply proper_shift; auto; eapply names_proper; eauto|]. eauto.
Qed.
Lemma middle_over i x y : in_prism r (patch_of i) x -> in_prism r (patch_of i) y -> over r system tiles i (middle (at_ i z30 x) (at_ i z30 y)).
Proof.
  intros X Y. rewrite <- at_middle. apply at_over; [apply latb_zero|]. intros s Hs. rewrite left_middle. specialize (X s Hs). specialize (Y s Hs). lra.
Qed.
Lemma edge_cases c u v : valid c -> holds_edge c u v -> u <> v -> (exists f, In f I4 /\ ~ axial (c, f) /\ has c f u v) \/
  (exists i q e n, c = (i, Join q e, n) /\ ((u = va (piece c) /\ v = vd (piece c)) \/ (u = vd (piece c) /\ v = va (piece c)))).
Proof.
  intros V [U W] N. destruct c as [[i [k|q e]] n].
  - left. pose proof (facets_with_length (piece (i, Piece k, n)) u v (PV _ V) U W N) as LEN. destruct (facets_with _ u v) as [|f l] eqn:E; [discriminate|].
    assert (F : In f (facets_with (piece (i, Piece k, n)) u v)) by (rewrite E; cbn; auto). apply facets_with_In in F as [F H]. exists f. split; [exact F|]. split; [intros []|exact H].
  - set (c := (i, Join q e, n)) in *. apply verts_vx in U as [j [J Ej]]. apply verts_vx in W as [j' [J' Ej']].
    assert (JJ : j <> j') by congruence.
    destruct (Nat.eq_dec j 0) as [Z|Z], (Nat.eq_dec j' 0) as [Z'|Z'], (Nat.eq_dec j 3) as [Y|Y], (Nat.eq_dec j' 3) as [Y'|Y']; try lia;
    try (left; exists 3%nat; split; [cbn; tauto|]; split; [cbn; tauto|]; rewrite <- Ej, <- Ej'; split; apply vx_facet; auto; cbn; tauto);
    try (left; exists 0%nat; split; [cbn; tauto|]; split; [cbn; tauto|]; rewrite <- Ej, <- Ej'; split; apply vx_facet; auto; cbn; tauto);
    right; exists i, q, e, n; (split; [reflexivity|]); subst j j'; cbn [vx] in Ej, Ej'; rewrite <- Ej, <- Ej'; auto.
Qed.
(** The ends of an axis. *)
Lemma axis_ends i q e n : valid (i, Join q e, n) -> exists j s' q' m, across_side i (wall i q) = (j, s') /\ pyramid_mate h (kind i) q (kind j) s' = (q', m) /\ (q' < length (pyramids (patch_of j)))%nat /\ j <> i /\
  latb r (zadd3 (zadd3 n m) (step i (wall i q))) = true /\
  va (piece (i, Join q e, n)) = at_ j (zadd3 (zadd3 n m) (step i (wall i q))) (apex_at (patch_of j) q') /\ vd (piece (i, Join q e, n)) = at_ i n (apex_at (patch_of i) q).
Proof.
  intros [L [Hq [He _]]]. destruct (pyramid_facts i q Hq) as [Hs _]. destruct (across_side i (wall i q)) as [j s'] eqn:E.
  destruct (across_spec i _ j s' Hs E) as [Hs' [NE [E' _]]]. pose proof (mate_facts i q j s' Hq E) as M.
  destruct (pyramid_mate h (kind i) q (kind j) s') as [q' m] eqn:PM. destruct M as [Hq' [W [Lm _]]]. destruct (step_spec i _ j s' Hs E) as [Ls _].
  exists j, s', q', m. split; auto. split; auto. split; auto. split; auto. split; [auto using latb_add|]. cbn [MosaicTiling.piece]. unfold join_at. rewrite E. unfold join. rewrite PM.
  cbn [map_tet va vd]. split; [|reflexivity]. rewrite (frame_lift i _ j s' n m) by auto. reflexivity.
Qed.
Lemma apex_within i q n : (q < length (pyramids (patch_of i)))%nat -> latb r n = true -> within r system tiles i (at_ i n (apex_at (patch_of i) q)).
Proof. intros Hq L. apply within_at; auto. intros s Hs. apply (APEX (kind i) q s (kinds i) Hq Hs). Qed.
(** No edge over one tile is an axis. *)
Lemma no_axis i x y c : in_prism r (patch_of i) x -> in_prism r (patch_of i) y -> valid c -> forall i' q e n, c = (i', Join q e, n) ->
  ~ ((at_ i z30 x = va (piece c) /\ at_ i z30 y = vd (piece c)) \/ (at_ i z30 x = vd (piece c) /\ at_ i z30 y = va (piece c))).
Proof.
  intros X Y V i' q e n -> D. destruct (axis_ends i' q e n V) as [j [s' [q' [m [_ [_ [Hq' [NE [L' [EA ED]]]]]]]]]]. destruct V as [L [Hq _]].
  pose proof (apex_within j q' _ Hq' L') as WJ. pose proof (apex_within i' q n Hq L) as WI. rewrite <- EA in WJ. rewrite <- ED in WI.
  pose proof (at_over i z30 x (latb_zero r) X) as OX. pose proof (at_over i z30 y (latb_zero r) Y) as OY.
  assert (A : forall k Z, within r system tiles k Z -> over r system tiles i Z -> k = i) by (intros k Z A B; exact (mosaic_apart _ _ _ _ _ _ _ tiling k i Z A B)).
  apply NE. destruct D as [[D1 D2]|[D1 D2]]; rewrite D1 in OX; rewrite D2 in OY; rewrite (A j _ WJ), (A i' _ WI); auto.
Qed.
Lemma in_pieces_In i c1 c2 k n : proper (kind i) c1 -> proper (kind i) c2 -> c1 <> c2 ->
  (In (k, n) (in_pieces (kind i) c1 c2) <-> valid (i, Piece k, n) /\ holds_edge (i, Piece k, n) (spot_of i c1) (spot_of i c2)).
Proof.
  intros P1 P2 N. unfold in_pieces. rewrite select_In, in_seq. cbn [MosaicTiling.valid]. change (patch_at (kind i)) with (patch_of i). split.
  - intros [Hk [[x y] [Hp [E1 E2]]]]. cbn [fst snd] in *. apply ordered_In in Hp as [Hx [Hy _]]. assert (Hk' : (k < length (pieces (patch_of i)))%nat) by lia.
    destruct (named_pieces NAMED (kind i) k (kinds i) Hk') as [_ NP]. change (patch_at (kind i)) with (patch_of i) in NP. apply in_map_iff in Hx as [j [<- J]], Hy as [j' [<- J']].
    destruct (NP j J) as [A B], (NP j' J') as [A' B']. assert (L : latb r n = true) by (apply (latb_shift (kind i) n (piece_name (kind i) k j)); auto; rewrite E1; auto).
    split; auto. split; apply verts_vx; [exists j|exists j']; (split; [auto|]); cbn [MosaicTiling.piece]; rewrite vx_map; [rewrite B, <- E1|rewrite B', <- E2]; apply spot_shift.
  - intros [[L Hk] [A B]]. split; [lia|]. destruct (named_pieces NAMED (kind i) k (kinds i) Hk) as [_ NP]. change (patch_at (kind i)) with (patch_of i) in NP.
    apply verts_vx in A as [j [J A]], B as [j' [J' B]]. cbn [MosaicTiling.piece] in A, B. rewrite vx_map in A, B. destruct (NP j J) as [Q1 Q2], (NP j' J') as [Q1' Q2'].
    rewrite Q2, spot_shift in A. rewrite Q2', spot_shift in B. apply spot_inj in A, B; auto using proper_shift.
    exists (piece_name (kind i) k j, piece_name (kind i) k j'). cbn [fst snd]. split; auto. apply ordered_In. split; [apply in_map, J|]. split; [apply in_map, J'|]. intros E. rewrite E in A. congruence.
Qed.
Lemma at_apexes_In i c1 c2 q e n : proper (kind i) c1 -> proper (kind i) c2 -> c1 <> c2 ->
  (In (q, e, n) (at_apexes (kind i) c1 c2) <-> ok i (Lateral q e) /\ latb r n = true /\ In (spot_of i c1) (corners3 (tri i (Lateral q e) n)) /\ In (spot_of i c2) (corners3 (tri i (Lateral q e) n)) /\
    (spot_of i c1 = at_ i n (apex_at (patch_of i) q) \/ spot_of i c2 = at_ i n (apex_at (patch_of i) q))).
Proof.
  intros P1 P2 N. unfold at_apexes. rewrite select_In, rim_places_In. change (patch_at (kind i)) with (patch_of i). unfold apex_pairs; cbn [fst snd]. split.
  - intros [K [[x y] [Hp [E1 E2]]]]. cbn [fst snd] in *. apply filter_In in Hp as [Hp AP]. cbn [fst snd] in AP. apply ordered_In in Hp as [Hx [Hy _]]. split; [exact K|]. pose proof (names_proper i (Lateral q e) x K Hx) as Px.
    assert (L : latb r n = true) by (apply (latb_shift (kind i) n x); auto; rewrite E1; auto). split; [exact L|].
    split; [apply names_In; auto; exists x; rewrite E1; auto|]. split; [apply names_In; auto; exists y; rewrite E2; auto|].
    destruct (named_apexes NAMED (kind i) q (kinds i) (proj1 K)) as [_ A]. change (patch_at (kind i)) with (patch_of i) in A. rewrite A, spot_shift.
    apply orb_true_iff in AP as [AP|AP]; apply ceqb_t in AP; rewrite AP; [left; rewrite E1|right; rewrite E2]; reflexivity.
  - intros [K [L [A [B D]]]]. split; [exact K|]. apply names_In in A as [x [Hx Ex]], B as [y [Hy Ey]]; auto.
    pose proof (names_proper i _ x K Hx) as Px. pose proof (names_proper i _ y K Hy) as Py.
    destruct (named_apexes NAMED (kind i) q (kinds i) (proj1 K)) as [PA A]. change (patch_at (kind i)) with (patch_of i) in A. rewrite A, spot_shift in D.
    apply spot_inj in Ex, Ey; auto using proper_shift. exists (x, y). cbn [fst snd]. split; auto. apply filter_In. split.
    + apply ordered_In. split; auto. split; auto. intros ->. congruence.
    + cbn [fst snd]. apply orb_true_iff. destruct D as [D|D]; apply spot_inj in D; auto using proper_shift; [left|right]; apply ceqb_t; [rewrite Ex in D|rewrite Ey in D]; symmetry; eapply cshift_inj; exact D.
Qed.
Lemma resolve_lateral i q e n : ok i (Lateral q e) -> exists i' q' e' n', fst (resolve i (Lateral q e) n) = (i', Join q' e', n') /\ ((i' = i /\ snd (resolve i (Lateral q e) n) = 0%nat) \/ (i' <> i /\ snd (resolve i (Lateral q e) n) = 3%nat)).
Proof.
  intros [Hq _]. cbn [MosaicTiling.resolve]. destruct (pyramid_facts i q Hq) as [Hs _]. destruct (across_side i (wall i q)) as [j s'] eqn:E. destruct (across_spec i _ j s' Hs E) as [_ [NE _]].
  destruct (pyramid_mate h (kind i) q (kind j) s') as [q' m]. destruct (Nat.ltb_spec i j); cbn [fst snd]; eauto 10.
Qed.
Theorem valence_inside i c1 c2 : proper (kind i) c1 -> proper (kind i) c2 -> c1 <> c2 ->
  (forall s, (s < sides (patch_of i))%nat -> ~ (on_side (kind i) s c1 /\ on_side (kind i) s c2)) ->
  exists m, possible (kind i) c1 c2 m /\ valence_in_cells is_cell (spot_of i c1) (spot_of i c2) m.
Proof.
  intros P1 P2 N NS. set (u := spot_of i c1) in *. set (v := spot_of i c2) in *.
  assert (UV : u <> v) by (intros X; apply N, (spot_inj i); auto).
  destruct (spot_inside i c1 P1) as [x1 [X1 [IX1 LX1]]]. destruct (spot_inside i c2 P2) as [x2 [X2 [IX2 LX2]]]. fold u in X1. fold v in X2.
  assert (WM : within r system tiles i (middle u v)).
  { rewrite X1, X2, <- at_middle. apply within_at; [apply latb_zero|]. intros s Hs. rewrite left_middle. pose proof (IX1 s Hs) as A. pose proof (IX2 s Hs) as B.
    destruct (Rle_lt_or_eq_dec _ _ A) as [A'|A'], (Rle_lt_or_eq_dec _ _ B) as [B'|B']; try lra. exfalso. apply (NS s Hs). unfold on_side. change (patch_at (kind i)) with (patch_of i). rewrite <- LX1, <- LX2. auto. }
  assert (ONE : forall k, over r system tiles k (middle u v) -> k = i) by (intros k K; symmetry; exact (mosaic_apart _ _ _ _ _ _ _ tiling i k _ WM K)).
  set (f := fun x : nat * nat * Z3 => fst (resolve i (Lateral (fst (fst x)) (snd (fst x))) (snd x))).
  set (SL := map (fun x => (i, Piece (fst x), snd x)) (in_pieces (kind i) c1 c2) ++ map f (at_apexes (kind i) c1 c2)).
  exists (length SL). split.
  { unfold SL. rewrite app_length, !map_length. apply possible_inside, NS. }
  apply valence_from.
  - unfold SL. apply NoDup_app_disj.
    + apply FinFun.Injective_map_NoDup; [intros [a b] [a' b'] E; cbn [fst snd] in E; congruence|].
      apply select_NoDup; [apply seq_NoDup|]. intros k Hk. apply in_seq in Hk. apply ordered_NoDup, (named_pieces NAMED (kind i) k (kinds i)). lia.
    + apply NoDup_map_inj_on.
      * apply select_NoDup; [apply rim_places_NoDup|]. intros [q e] H. apply rim_places_In in H. apply NoDup_filter, ordered_NoDup, (named_rims NAMED (kind i) q e (kinds i)); apply H.
      * intros [[q e] n1] [[q' e'] n1'] H H' E. apply at_apexes_In in H as [K [L _]], H' as [K' [L' _]]; auto. unfold f in E. cbn [fst snd] in E.
        assert (RE : resolve i (Lateral q e) n1 = resolve i (Lateral q' e') n1').
        { rewrite (surjective_pairing (resolve i (Lateral q e) n1)), (surjective_pairing (resolve i (Lateral q' e') n1')), E. f_equal.
          destruct (resolve_lateral i q e n1 K) as [a1 [a2 [a3 [a4 [E1 D1]]]]]. destruct (resolve_lateral i q' e' n1' K') as [b1 [b2 [b3 [b4 [E2 D2]]]]].
          rewrite E1, E2 in E. injection E as -> _ _ _. destruct D1 as [[? ?]|[? ?]], D2 as [[? ?]|[? ?]]; congruence. }
        apply (f_equal view) in RE. rewrite !view_resolve in RE by auto. congruence.
    + intros c H H'. apply in_map_iff in H as [x [<- _]]. apply in_map_iff in H' as [[[q e] n1] [E H']]. apply at_apexes_In in H' as [K _]; auto. unfold f in E. cbn [fst snd] in E.
      destruct (resolve_lateral i q e n1 K) as [a1 [a2 [a3 [a4 [E1 _]]]]]. congruence.
  - intros c. unfold SL. rewrite in_app_iff, !in_map_iff. split.
    + intros [[[k n1] [<- H]]|[[[q e] n1] [<- H]]].
      * apply in_pieces_In in H; auto.
      * apply at_apexes_In in H as [K [L [A [B _]]]]; auto. unfold f; cbn [fst snd]. split; [apply resolve_valid; auto|]. apply (has_holds _ (snd (resolve i (Lateral q e) n1))). split; apply resolve_corners; auto.
    + intros [V H]. destruct (edge_cases c u v V H UV) as [[g [Hg [AX HG]]]|[i' [q [e [n1 [EC D]]]]]].
      * destruct (view_spec c g V Hg AX) as [i1 [o1 [n1 [K [L E]]]]].
        assert (UU : In u (corners3 (tri i1 o1 n1)) /\ In v (corners3 (tri i1 o1 n1))).
        { destruct HG. split; apply resolve_corners; auto; rewrite E; auto. }
        destruct UU as [A B]. assert (I1 : i1 = i).
        { apply ONE. destruct (tri_inside i1 o1 n1 u K L A) as [y1 [Y1 Z1]]. destruct (tri_inside i1 o1 n1 v K L B) as [y2 [Y2 Z2]]. rewrite Y1, Y2. apply middle_over; auto. }
        subst i1. destruct o1 as [k g'|q e].
        -- left. exists (k, n1). cbn [MosaicTiling.resolve] in E. injection E as <- <-. cbn [fst snd]. split; auto. apply in_pieces_In; auto.
        -- right. exists (q, e, n1). unfold f; cbn [fst snd]. split; [rewrite E; reflexivity|]. apply at_apexes_In; auto. split; auto. split; auto. split; auto. split; auto.
           destruct (dec (u = at_ i n1 (apex_at (patch_of i) q) \/ v = at_ i n1 (apex_at (patch_of i) q))) as [D|D]; auto. exfalso.
           destruct K as [Hq He]. destruct (pyramid_facts i q Hq) as [Hs [_ [_ [_ [Z _]]]]].
           assert (ON : forall X, In X (corners3 (tri i (Lateral q e) n1)) -> X <> at_ i n1 (apex_at (patch_of i) q) -> on i (wall i q) X).
           { intros X HX NX. unfold MosaicTiling.tri in HX. cbn [triangle_of map_tri corners3 t1 t2 t3 In] in HX. destruct HX as [<-|[<-|[<-|[]]]]; try congruence; apply on_at; auto; apply Z; auto. apply next_lt, He. }
           apply (NS (wall i q) Hs). split; apply on_spot; auto.
      * exfalso. rewrite X1, X2 in D. exact (no_axis i x1 x2 c IX1 IX2 V i' q e n1 EC D).
Qed.
Theorem valence_axis i q e n : valid (i, Join q e, n) -> valence_in_cells is_cell (va (piece (i, Join q e, n))) (vd (piece (i, Join q e, n))) (rim_count (patch_of i) q).
Proof.
  intros V. set (u := va (piece (i, Join q e, n))). set (v := vd (piece (i, Join q e, n))).
  assert (SAME : forall x, va (piece (i, Join q x, n)) = u /\ vd (piece (i, Join q x, n)) = v).
  { intros x. unfold u, v. cbn [MosaicTiling.piece]. unfold join_at. destruct (across_side i (wall i q)) as [j s']. unfold join. destruct (pyramid_mate h (kind i) q (kind j) s'). split; reflexivity. }
  pose proof V as [L [Hq [He LT]]].
  assert (VX : forall x, (x < rim_count (patch_of i) q)%nat -> valid (i, Join q x, n)) by (intros x Hx; cbn [MosaicTiling.valid]; auto).
  assert (HE : forall x, holds_edge (i, Join q x, n) u v).
  { intros x. destruct (SAME x) as [<- <-]. split; cbn [verts In]; auto. }
  replace (rim_count (patch_of i) q) with (length (map (fun x => (i, Join q x, n)) (seq 0 (rim_count (patch_of i) q)))) by (rewrite map_length, seq_length; reflexivity).
  apply valence_from.
  - apply FinFun.Injective_map_NoDup; [intros x y E; congruence|apply seq_NoDup].
  - intros c. rewrite in_map_iff. split.
    + intros [x [<- Hx]]. apply in_seq in Hx. split; [apply VX; lia|apply HE].
    + intros [Vc H]. assert (W : exists x, (x < rim_count (patch_of i) q)%nat /\ c = (i, Join q x, n)).
      { apply (around u v (i, Join q e, n) (fun c => exists x, (x < rim_count (patch_of i) q)%nat /\ c = (i, Join q x, n))); auto; [|eauto].
        intros d f Vd F [A B] [x [Hx ->]]. destruct (HE x) as [U W]. destruct (SAME x) as [SA SD].
        pose proof (PV _ Vd) as P. apply vertex_in_facet in A, B; auto; try lra.
        assert (U0 : u = vx (piece (i, Join q x, n)) 0) by (cbn [vx]; auto). assert (W3 : v = vx (piece (i, Join q x, n)) 3) by (cbn [vx]; auto).
        rewrite U0, coord_vx in A by (auto; cbn; tauto). rewrite W3, coord_vx in B by (auto; cbn; tauto).
        cbn in F. destruct F as [<-|[<-|[<-|[<-|[]]]]]; cbn [Nat.eqb] in A, B; try lra; cbn [MosaicTiling.across fst]; eexists; (split; [|reflexivity]); auto using next_lt, prev_lt. }
      destruct W as [x [Hx ->]]. exists x. split; auto. apply in_seq. lia.
Qed.
End System.
