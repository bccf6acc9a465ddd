(** * Systems of patches: TCP from finitely many conditions

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
    - *Edges over a corner of the mosaic.*  T has all tiles around the corner.  No angle is
      needed.  Finitely many directions from the corner are sampled.  Near the corner each
      sample is in exactly one tile, for the prisms cover space and do not overlap.
      A tile is turned against the first one by one of the rotations of MosaicHeights.v, so which samples
      are in its corner is a finite question.  If 12 times their number is the number of all
      samples times that of the tile's occupants with the edge, there are 12 occupants, and the valence
      is 6 ([valence_there]).  No T-junction has to be excluded: the cells with the edge cover
      what is near, and [walk] knows their tiles.

    A valence is [possible] for an edge of a patch if some next tile gives it.  If all possible ones
    are 5 or 6, and no triangle has two edges for which 6 is possible, the cells are TCP
    ([mosaic_tcp]). *)
Require Import Reals Lra Psatz NArith ZArith List Lia Bool Permutation.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Domain Euclid Checker Keys MosaicStatement MosaicTiling MosaicHeights MosaicValences MosaicEdges.
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
Notation across_spec := (across_spec G r system h OK l1 l2 l3 tiles tiling).
Notation step_spec := (step_spec G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation step_opp := (step_opp G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation pyramid_facts := (pyramid_facts G r system h OK l1 l2 l3 tiles tiling).
Notation mate_facts := (mate_facts G r system h OK l1 l2 l3 tiles tiling).
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
Lemma wall_flat i o n s w X : ok i o -> latb r n = true -> MosaicTiling.behind h (kind i) o = Wall s w -> In X (corners3 (tri i o n)) -> on i s X.
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
  unfold MosaicTiling.beyond in B. destruct (MosaicTiling.behind h (kind i) o) as [o2 m|s w] eqn:BH.
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
Hypothesis CONVEX : r = 1%nat -> forall a s t, (a < length system)%nat -> (s < sides (patch_at a))%nat -> (t < sides (patch_at a))%nat ->
  (3 <= sides (patch_at a))%nat /\ (t <> s -> t <> prev (sides (patch_at a)) s -> 0 < left_of (patch_at a) t (start (edge_at (patch_at a) s))).
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
  intros R [_ [_ L]] [A B]. destruct (L R) as [_ N]. unfold MosaicTiling.carry, same_place. rewrite R. cbn [px py pz sub]. rewrite A, B. clear A B.
  unfold along. rewrite R in *. set (u := sub (finish 1 p s) (start (edge_at p s))) in *. split; [transitivity (py (start (edge_at p s)) + py u)|transitivity (pz (start (edge_at p s)) + pz u)];
  try (unfold u; cbn [py pz sub]; ring); field; exact N.
Qed.
Lemma carry_finish p s q s' x : r = 1%nat -> fits G r p s q s' -> same_place x (finish r q s') -> same_place (carry p s q s' x) (start (edge_at p s)).
Proof.
  intros R [_ [_ L]] [A B]. destruct (L R) as [E N]. unfold MosaicTiling.carry, same_place. rewrite R in *. cbn [px py pz sub]. rewrite A, B. clear A B L.
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
Proof. unfold MosaicTiling.at_, MosaicStatement.spot, MosaicStatement.place, MosaicTiling.lift, middle, at_coordinates. destruct (axes (tiles i)) as [[m1 m2] m3]. apply point_eq; unf; field. Qed.
Lemma left_middle p s x y : left_of p s (middle x y) = (left_of p s x + left_of p s y) / 2.
Proof. unfold MosaicStatement.left_of, middle. destruct rank as [-> | ->]; [unf; field|]. destruct s; unf; field. Qed.
Lemma within_at i n x : latb r n = true -> inside_prism r (patch_of i) x -> within r system tiles i (at_ i n x).
Proof.
  intros L P. exists (add (MosaicTiling.lift n x) (rise i)). split; [reflexivity|]. intros s Hs.
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

(** *** Edges over a corner of the mosaic

    The directions from there are sampled.  Each sample is inside of one of the tiles around the
    corner.  A tile's share of the samples is its share of the cells. *)
Variables (turnings : list turning) (samples : list (R * R)).
Notation turning_at k := (nth k turnings no_turning).
Notation sample x := (nth x samples (0, 0)).
Definition local_direction (m : (R * R) * (R * R)) (d : R * R) : R * R := (fst d * snd (snd m) - snd d * fst (snd m), snd d * fst (fst m) - fst d * snd (fst m)).
Definition turning_det (m : (R * R) * (R * R)) : R := fst (fst m) * snd (snd m) - snd (fst m) * fst (snd m).
(** How far a direction leads to the inner side of a side. *)
Definition inward (p : patch) (s : nat) (e : R * R) : R := py (along r p s) * snd e - pz (along r p s) * fst e.
Definition in_corner (a s k x : nat) : Prop := let p := patch_at a in let e := local_direction (fst (turning_at k)) (sample x) in
  0 < inward p s e /\ 0 < inward p (prev (sides p) s) e.
Definition out_of_corner (a s k x : nat) : Prop := let p := patch_at a in let e := local_direction (fst (turning_at k)) (sample x) in
  inward p s e < 0 \/ inward p (prev (sides p) s) e < 0.
Definition in_cornerb (a s k x : nat) : bool := if dec (in_corner a s k x) then true else false.
Hypothesis ROT : r = 1%nat -> MosaicHeights.rotations G r system turnings.
Hypothesis SAMPLED : r = 1%nat -> samples <> [] /\ forall a s k, (a < length system)%nat -> (s < sides (patch_at a))%nat -> (k < length turnings)%nat ->
  0 < turning_det (fst (turning_at k)) /\ (exists x, (x < length samples)%nat /\ in_corner a s k x) /\
  forall x, (x < length samples)%nat -> in_corner a s k x \/ out_of_corner a s k x.
Hypothesis SHARES : r = 1%nat -> forall a s k c1 c2, (a < length system)%nat -> (s < sides (patch_at a))%nat -> (k < length turnings)%nat -> around_tile a c1 c2 <> [] ->
  on_side a s c1 -> on_side a s c2 -> on_side a (prev (sides (patch_at a)) s) c1 -> on_side a (prev (sides (patch_at a)) s) c2 ->
  (length (around_tile a c1 c2) * length samples = 12 * length (filter (in_cornerb a s k) (seq 0 (length samples))))%nat.

Notation turned := (turned tiles turnings).
Notation image := (image tiles).
Lemma turned_step i s j s' k w : r = 1%nat -> MosaicStatement.meets l1 l2 l3 r system tiles i s j s' -> turned i k w -> exists w', turned j k w'.
Proof.
  intros R1 M [W1 [W2 W3]]. destruct (ROT R1) as [_ ST _]. pose proof M as [Hs [Hs' _]]. pose proof (meets_fits G r system h OK l1 l2 l3 tiles tiling _ _ _ _ M) as FT.
  destruct (ST (kind i) s (kind j) s' (fst w) (kinds i) (kinds j) Hs Hs' FT W1) as [k' [K1 [K2 K3]]].
  exists (k', 0)%nat. unfold MosaicHeights.turned; cbn [fst]. split; [exact K1|]. rewrite K2. destruct (meets_linear G r system h OK l1 l2 l3 basis right_handed tiles tiling R1 _ _ _ _ M) as [L2 L3]. cbv zeta in *.
  change (nth (kind i) system (Patch [] [] [])) with (patch_of i). change (nth (kind j) system (Patch [] [] [])) with (patch_of j).
  set (m := linear G r (patch_of i) s (patch_of j) s') in *. rewrite L2, L3. unfold MosaicHeights.image at 1 3. rewrite W2, W3. unfold compose, MosaicHeights.image; cbn [fst snd].
  split; apply point_eq; unf; ring.
Qed.
Lemma at_direction i n y e : at_ i n (add y (Point 0 (fst e) (snd e))) = add (at_ i n y) (image i e).
Proof.
  unfold MosaicTiling.at_, MosaicStatement.spot, MosaicStatement.place, MosaicTiling.lift, MosaicHeights.image, second, third, at_coordinates. destruct (axes (tiles i)) as [[m1 m2] m3]. cbn [fst snd]. apply point_eq; unf; ring.
Qed.
Lemma left_direction p s y e : r = 1%nat -> left_of p s (add y (Point 0 (fst e) (snd e))) = left_of p s y + inward p s e.
Proof. intros R1. unfold MosaicStatement.left_of, inward, along. rewrite R1. cbn [py pz sub add]. ring. Qed.
Lemma over_inside i z : over r system tiles i (at_ i z30 z) -> in_prism r (patch_of i) z.
Proof.
  intros [x [E P]] s Hs. specialize (P s Hs). unfold MosaicTiling.at_, MosaicStatement.spot in E.
  apply (place_inj G r system h OK l1 l2 l3 basis right_handed tiles tiling) in E. rewrite <- E, (left_fibre r rank) in P by apply high. rewrite lift_zero in P. exact P.
Qed.
Lemma uniform {J} (l : list J) (P : J -> R -> Prop) : (forall x, In x l -> exists d, 0 < d /\ forall e, 0 < e < d -> P x e) -> exists d, 0 < d /\ forall e, 0 < e < d -> forall x, In x l -> P x e.
Proof.
  induction l as [|x l IH]; intros H; [exists 1; split; [lra|intros ? ? ? []]|].
  destruct (H x ltac:(cbn; auto)) as [d [D HD]]. destruct IH as [d' [D' HD']]; [intros y Hy; apply H; cbn; auto|].
  exists (Rmin d d'). split; [apply Rmin_glb_lt; auto|]. pose proof (Rmin_l d d'). pose proof (Rmin_r d d'). intros e E y [<-|Hy]; [apply HD; lra|apply HD'; auto; lra].
Qed.
Lemma start_left i s t : r = 1%nat -> (s < sides (patch_of i))%nat -> (t < sides (patch_of i))%nat ->
  left_of (patch_of i) t (start (edge_at (patch_of i) s)) = 0 /\ (t = s \/ t = prev (sides (patch_of i)) s) \/ 0 < left_of (patch_of i) t (start (edge_at (patch_of i) s)).
Proof.
  intros R1 Hs Ht. destruct (Nat.eq_dec t s) as [->|N]; [left; split; auto; apply left_start, R1|].
  destruct (Nat.eq_dec t (prev (sides (patch_of i)) s)) as [->|N']; [left; split; auto; apply left_prev; auto|]. right. apply (CONVEX R1 (kind i) s t (kinds i) Hs Ht); auto.
Qed.
(** A cell with points near the middle of an edge contains the middle. *)
Lemma near_cells x : exists e, 0 < e /\ forall y, near e x y -> forall c, valid c -> closed (piece c) y -> closed (piece c) x.
Proof.
  destruct (near_origin_exists x) as [M [_ NM]]. destruct (RG M) as [L [_ R]].
  assert (O : open (fun y => near M origin y /\ forall c, In c L -> closed (piece c) x \/ ~ closed (piece c) y)).
  { apply opn_and; [apply near_opn|]. apply opn_all. intros c _. apply opn_or; [apply opn_const|apply not_closed_opn]. }
  destruct (O x) as [e [E H]].
  { split; auto. intros c _. destruct (dec (closed (piece c) x)); auto. }
  exists e. split; auto. intros y Hy c V C. destruct (H y Hy) as [A B]. destruct (B c (R c y V A C)); tauto.
Qed.
Lemma near_small x w e : 0 < e -> exists d, 0 < d /\ forall t, 0 < t < d -> near e x (add x (scale t w)).
Proof.
  intros E. set (B := Rabs (px w) + Rabs (py w) + Rabs (pz w) + 1). pose proof (Rabs_pos (px w)). pose proof (Rabs_pos (py w)). pose proof (Rabs_pos (pz w)).
  assert (PB : 0 < B) by (unfold B; lra). exists (e / B). split; [apply Rdiv_lt_0_compat; auto|]. intros t [T1 T2].
  assert (TB : t * B < e). { apply (Rmult_lt_compat_r B) in T2; auto. unfold Rdiv in T2. rewrite Rmult_assoc, Rinv_l in T2 by lra. lra. }
  assert (K : forall a, Rabs a <= B -> Rabs (t * a) < e).
  { intros a A. rewrite Rabs_mult, (Rabs_right t) by lra. assert (t * Rabs a <= t * B) by (apply Rmult_le_compat_l; lra). lra. }
  unfold near, add, scale; cbn [px py pz]. repeat split; match goal with |- Rabs (?p + t * ?q - ?p) < _ => replace (p + t * q - p) with (t * q) by ring end; apply K; unfold B; lra.
Qed.
Lemma count_once {J} (LT : list J) n (b : J -> nat -> bool) : NoDup LT -> (forall x, (x < n)%nat -> exists i, In i LT /\ b i x = true /\ forall i', In i' LT -> b i' x = true -> i' = i) ->
  list_sum (map (fun i => length (filter (b i) (seq 0 n))) LT) = n.
Proof.
  intros N. induction n as [|n IH]; intros H.
  - clear. induction LT; cbn; auto.
  - assert (S1 : list_sum (map (fun i => length (filter (b i) (seq 0 (S n)))) LT) = (list_sum (map (fun i => length (filter (b i) (seq 0 n))) LT) + list_sum (map (fun i => if b i n then 1 else 0) LT))%nat).
    { rewrite seq_S. cbn [Nat.add]. generalize (seq 0 n) as xs. clear. intros xs. induction LT as [|i l IH]; [reflexivity|]. cbn [map list_sum fold_right] in *. rewrite filter_app, app_length. cbn [filter].
      unfold list_sum in IH. rewrite IH. destruct (b i n); cbn [length]; lia. }
    rewrite S1, IH by (intros x Hx; apply H; lia). destruct (H n ltac:(lia)) as [i [Hi [B U]]]. clear - N Hi B U.
    assert (Z : forall l, (forall i', In i' l -> b i' n = false) -> list_sum (map (fun i => if b i n then 1 else 0)%nat l) = 0%nat).
    { induction l as [|j l IH]; intros Z; [reflexivity|]. cbn [map list_sum fold_right]. rewrite (Z j) by (cbn; auto). apply IH. intros; apply Z; cbn; auto. }
    induction LT as [|j l IH]; [destruct Hi|]. inversion N as [|? ? N1 N2]; subst. cbn [map list_sum fold_right]. destruct (b j n) eqn:E.
    + assert (j = i) by (apply U; cbn; auto). subst j. fold (list_sum (map (fun i => if b i n then 1 else 0)%nat l)). rewrite Z; [lia|].
      intros i' Hi'. destruct (b i' n) eqn:E'; auto. assert (i' = i) by (apply U; cbn; auto). subst. contradiction.
    + destruct Hi as [->|Hi]; [congruence|]. apply IH; auto. intros i' Hi'. apply U. cbn; auto.
Qed.
Lemma list_choice {B} (d : B) (l : list nat) (P : nat -> B -> Prop) : (forall i, In i l -> exists b, P i b) -> exists f, forall i, In i l -> P i (f i).
Proof.
  induction l as [|i l IH]; intros H; [exists (fun _ => d); intros ? []|]. destruct IH as [f F]; [intros; apply H; cbn; auto|]. destruct (H i ltac:(cbn; auto)) as [b Hb].
  exists (fun j => if Nat.eqb j i then b else f j). intros j [<-|Hj]; [rewrite Nat.eqb_refl; auto|]. destruct (Nat.eqb_spec j i) as [->|]; auto.
Qed.
Lemma resolve_over i q e n y : ok i (Lateral q e) -> latb r n = true -> closed (piece (fst (resolve i (Lateral q e) n))) y -> over r system tiles i y \/ over r system tiles (fst (across_side i (wall i q))) y.
Proof.
  intros K L C. destruct (resolve_valid i _ n K L) as [V _]. cbn [MosaicTiling.resolve] in *. destruct K as [Hq He]. destruct (pyramid_facts i q Hq) as [Hs _]. destruct (across_side i (wall i q)) as [j s'] eqn:E.
  destruct (across_spec i _ j s' Hs E) as [_ [_ [E' _]]]. pose proof (mate_facts i q j s' Hq E) as M. destruct (pyramid_mate h (kind i) q (kind j) s') as [q' m]. destruct M as [Hq' [W _]].
  destruct (Nat.ltb_spec i j); cbn [fst] in *; apply (join_over G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high) in C; auto.
  - rewrite E in C. exact C.
  - rewrite W, E' in C. cbn [fst] in C. tauto.
Qed.
Lemma sum_share (f g : nat -> nat) l n : (forall i, In i l -> f i * n = 12 * g i)%nat -> (list_sum (map f l) * n = 12 * list_sum (map g l))%nat.
Proof.
  induction l as [|i l IH]; intros H; [reflexivity|]. pose proof (H i ltac:(cbn; auto)) as X. pose proof (IH ltac:(intros; apply H; cbn; auto)) as Y.
  unfold list_sum in *. cbn [map fold_right]. rewrite Nat.mul_add_distr_r, Nat.mul_add_distr_l, X, Y. reflexivity.
Qed.
Section Corner.
Hypothesis R1 : r = 1%nat.
Variables (i0 : nat) (u v : point).
Hypothesis uv : u <> v.
Definition over_start (i s : nat) (X : point) : Prop := exists x, X = at_ i z30 x /\ same_place x (start (edge_at (patch_of i) s)).
Definition placed (i s k : nat) : Prop := (s < sides (patch_of i))%nat /\ over_start i s u /\ over_start i s v /\ turned i i0 (k, 0%nat).
Definition tile_there (i : nat) : Prop := exists s k, placed i s k.
Lemma start_on i s X : (s < sides (patch_of i))%nat -> over_start i s X -> on i s X /\ on i (prev (sides (patch_of i)) s) X.
Proof.
  intros Hs [x [E P]]. split; exists x; (split; [exact E|]); rewrite (left_place _ _ _ _ R1 P); [apply left_start, R1|apply left_prev; auto].
Qed.
Lemma start_sides i s t X : (s < sides (patch_of i))%nat -> (t < sides (patch_of i))%nat -> over_start i s X -> on i t X -> t = s \/ t = prev (sides (patch_of i)) s.
Proof.
  intros Hs Ht [x [-> P]] O. apply on_at in O; [|apply latb_zero]. rewrite (left_place _ _ _ _ R1 P) in O. destruct (start_left i s t R1 Hs Ht) as [[_ D]|D]; auto. lra.
Qed.
Lemma start_over i s X : (s < sides (patch_of i))%nat -> over_start i s X -> exists x, X = at_ i z30 x /\ same_place x (start (edge_at (patch_of i) s)) /\ in_prism r (patch_of i) x.
Proof.
  intros Hs [x [-> P]]. exists x. split; auto. split; auto. intros t Ht. rewrite (left_place _ _ _ _ R1 P). destruct (start_left i s t R1 Hs Ht) as [[D _]|D]; lra.
Qed.
Lemma lift_place n y : latb r n = true -> same_place (MosaicTiling.lift n y) y.
Proof. intros L. apply latb_iff in L. rewrite R1 in L. destruct n as [[n1 n2] n3]. cbn in L. destruct L as [-> ->]. unfold MosaicTiling.lift, pt. split; unf; ring. Qed.
(** The corner in the next tile. *)
Lemma start_across i s t j t' X : (s < sides (patch_of i))%nat -> (t < sides (patch_of i))%nat -> across_side i t = (j, t') -> over_start i s X -> t = s \/ t = prev (sides (patch_of i)) s ->
  over_start j (if Nat.eqb t s then next (sides (patch_of j)) t' else t') X.
Proof.
  intros Hs Ht E [x [-> P]] D. destruct (across_spec i t j t' Ht E) as [Ht' [_ [E' FT]]]. destruct (step_spec j t' i t Ht' E') as [L F].
  exists (MosaicTiling.lift (zopp3 (step j t')) (carry (patch_of j) t' (patch_of i) t x)). split.
  - rewrite at_lift, z30_add, <- F by (apply latb_opp, L). f_equal. rewrite zadd3_comm, zadd3_opp. reflexivity.
  - assert (TR : forall a b c, same_place a b -> same_place b c -> same_place a c) by (intros a b c [A B] [A' B']; split; congruence).
    eapply TR; [apply lift_place, latb_opp, L|]. destruct (Nat.eqb_spec t s) as [->|N].
    + eapply TR; [|apply finish_next, R1]. apply carry_start; auto. apply fits_sym, FT.
    + destruct D as [D|D]; [contradiction|]. apply carry_finish; auto; [apply fits_sym, FT|]. eapply TR; [exact P|]. subst t.
      destruct (finish_next (patch_of i) (prev (sides (patch_of i)) s) R1) as [A B]. rewrite next_prev in A, B by auto. split; auto.
Qed.
Lemma there_sides i t : tile_there i -> (t < sides (patch_of i))%nat -> on i t u -> on i t v -> tile_there (fst (across_side i t)).
Proof.
  intros [s [k [Hs [A [B W]]]]] Ht OU OV. destruct (across_side i t) as [j t'] eqn:E. cbn [fst]. pose proof (start_sides i s t u Hs Ht A OU) as D.
  destruct (turned_step i t j t' i0 _ R1 (across_meets G r system l1 l2 l3 tiles tiling i t j t' Ht E) W) as [w' [W1 [W2 W3]]].
  destruct (across_spec i t j t' Ht E) as [Ht' _].
  exists (if Nat.eqb t s then next (sides (patch_of j)) t' else t'), (fst w'). split; [destruct (Nat.eqb t s); auto using next_lt|].
  split; [apply (start_across i s t j t' u); auto|]. split; [apply (start_across i s t j t' v); auto|]. split; [exact W1|]. split; [exact W2|exact W3].
Qed.
Lemma there_flat i : tile_there i -> exists s, (s < sides (patch_of i))%nat /\ on i s u /\ on i s v.
Proof. intros [s [k [Hs [A [B _]]]]]. exists s. split; auto. split; apply start_on; auto. Qed.
Notation known := (known tile_there).
Variables (o0 : occupant) (n0 : Z3).
Hypothesis here : tile_there i0.
Hypothesis ok0 : ok i0 o0.
Hypothesis lat0 : latb r n0 = true.
Hypothesis u0 : In u (corners3 (tri i0 o0 n0)).
Hypothesis v0 : In v (corners3 (tri i0 o0 n0)).
Lemma cell_tiles c y : valid c -> holds_edge c u v -> closed (piece c) y ->
  exists i o n, tile_there i /\ ok i o /\ latb r n = true /\ In u (corners3 (tri i o n)) /\ In v (corners3 (tri i o n)) /\ over r system tiles i y.
Proof.
  intros V H C. pose proof (facets_with_length (piece c) u v (PV _ V) (proj1 H) (proj2 H) uv) as LEN.
  destruct (facets_with (piece c) u v) as [|f [|f2 [|? ?]]] eqn:E; try discriminate.
  assert (ND : NoDup (facets_with (piece c) u v)) by (apply NoDup_filter; unfold I4; repeat constructor; cbn; intuition congruence). rewrite E in ND.
  assert (F : In f (facets_with (piece c) u v)) by (rewrite E; cbn; auto). assert (F2 : In f2 (facets_with (piece c) u v)) by (rewrite E; cbn; auto).
  apply facets_with_In in F as [F HF], F2 as [F2 HF2]. assert (NE : f <> f2) by (intros X; subst f2; inversion ND as [|? ? A _]; apply A; cbn; auto).
  destruct (walk tile_there u v uv there_sides there_flat i0 o0 n0 here ok0 lat0 u0 v0 c f V F HF) as [i [o [n [HT [K [L R]]]]]].
  destruct (walk tile_there u v uv there_sides there_flat i0 o0 n0 here ok0 lat0 u0 v0 c f2 V F2 HF2) as [i2 [o2 [n2 [HT2 [K2 [L2 R2]]]]]].
  assert (UU : In u (corners3 (tri i o n)) /\ In v (corners3 (tri i o n))) by (destruct HF; split; apply resolve_corners; auto; rewrite R; auto).
  assert (UU2 : In u (corners3 (tri i2 o2 n2)) /\ In v (corners3 (tri i2 o2 n2))) by (destruct HF2; split; apply resolve_corners; auto; rewrite R2; auto).
  destruct o as [k g|q e].
  - exists i, (Facet k g), n. split; auto. split; auto. split; auto. split; [apply UU|]. split; [apply UU|]. cbn [MosaicTiling.resolve] in R. injection R as <- <-.
    apply (piece_over G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high i k n); auto.
  - assert (C' : closed (piece (fst (resolve i (Lateral q e) n))) y) by (rewrite R; exact C).
    apply resolve_over in C' as [C'|C']; auto.
    + exists i, (Lateral q e), n. split; auto. split; auto. split; auto. split; [apply UU|]. split; [apply UU|]. exact C'.
    + destruct (mate_resolve i q e n K L) as [j [q' [e' [n' [EJ [K' [L' [_ [EC [SD _]]]]]]]]]].
      assert (I2 : i2 = j).
      { destruct o2 as [k g|q2 e2].
        - exfalso. destruct (resolve_lateral i q e n K) as [a1 [a2 [a3 [a4 [E1 _]]]]]. rewrite R in E1. cbn [fst] in E1. cbn [MosaicTiling.resolve] in R2. congruence.
        - destruct (resolve_lateral i2 q2 e2 n2 K2) as [a1 [a2 [a3 [a4 [_ D2]]]]]. rewrite R2 in D2. cbn [snd] in D2. rewrite R in EC, SD. cbn [fst snd] in EC, SD.
          assert (X : resolve i2 (Lateral q2 e2) n2 = resolve j (Lateral q' e') n').
          { rewrite R2, (surjective_pairing (resolve j (Lateral q' e') n')), EC. f_equal. destruct D2 as [[_ D2]|[_ D2]], SD as [[S1 S2]|[S1 S2]]; congruence. }
          apply (f_equal view) in X. rewrite !view_resolve in X by auto. congruence. }
      exists i2, o2, n2. split; auto. split; auto. split; auto. split; [apply UU2|]. split; [apply UU2|]. rewrite I2, EJ. exact C'.
Qed.
Definition place_of (i : nat) : nat * nat := proj1_sig (choose_pair (fun sk => placed i (fst sk) (snd sk))).
Lemma place_of_spec i : tile_there i -> placed i (fst (place_of i)) (snd (place_of i)).
Proof.
  intros [s [k H]]. unfold place_of. destruct (choose_pair _) as [sk P]; cbn [proj1_sig]. apply P. exists (s, k). exact H.
Qed.
Definition sees (i x : nat) : bool := in_cornerb (kind i) (fst (place_of i)) (snd (place_of i)) x.
Definition probe (x : nat) (e : R) : point := add (middle u v) (scale e (image i0 (sample x))).
(** A probe in the coordinates of a tile. *)
Lemma probe_at i : tile_there i -> exists y d, 0 < d /\ in_prism r (patch_of i) y /\ same_place y (start (edge_at (patch_of i) (fst (place_of i)))) /\
  forall x e, probe x e = at_ i z30 (add y (Point 0 (fst (let l := local_direction (fst (turning_at (snd (place_of i)))) (sample x) in (e * d * fst l, e * d * snd l)))
    (snd (let l := local_direction (fst (turning_at (snd (place_of i)))) (sample x) in (e * d * fst l, e * d * snd l))))).
Proof.
  intros HT. destruct (place_of_spec i HT) as [Hs [A [B [W1 [W2 W3]]]]]. set (s := fst (place_of i)) in *. set (k := snd (place_of i)) in *. cbn [fst snd] in W1, W2, W3.
  destruct (SAMPLED R1) as [_ SA]. destruct (SA (kind i) s k (kinds i) Hs W1) as [DET _].
  destruct (start_over i s u Hs A) as [x1 [X1 [S1 I1]]]. destruct (start_over i s v Hs B) as [x2 [X2 [S2 I2]]].
  exists (middle x1 x2), (/ turning_det (fst (turning_at k))). split; [apply Rinv_0_lt_compat, DET|]. split; [intros t Ht; rewrite left_middle; specialize (I1 t Ht); specialize (I2 t Ht); lra|].
  split; [destruct S1 as [S1 S1'], S2 as [S2 S2']; unfold middle; split; unf; rewrite ?S1, ?S2, ?S1', ?S2'; field|].
  intros x e. cbv zeta. rewrite at_direction, at_middle, <- X1, <- X2. unfold probe. f_equal. unfold MosaicHeights.image at 2. rewrite W2, W3. unfold MosaicHeights.image, local_direction. cbn [fst snd].
  set (m := fst (turning_at k)) in *. unfold turning_det in *. apply point_eq; unf; field; lra.
Qed.
Lemma inward_scale p s e d : inward p s (e * fst d, e * snd d) = e * inward p s d.
Proof. unfold inward; cbn [fst snd]. ring. Qed.
Lemma sees_within i x : tile_there i -> sees i x = true -> exists d, 0 < d /\ forall e, 0 < e < d -> within r system tiles i (probe x e).
Proof.
  intros HT SE. destruct (place_of_spec i HT) as [Hs _]. destruct (probe_at i HT) as [y [d [D [IY [SP PE]]]]]. set (s := fst (place_of i)) in *. set (k := snd (place_of i)) in *.
  unfold sees, in_cornerb in SE. fold s k in SE. destruct (dec (in_corner (kind i) s k x)) as [IN|]; [|discriminate]. destruct IN as [IN1 IN2].
  set (l := local_direction (fst (turning_at k)) (sample x)) in *.
  destruct (uniform (seq 0 (sides (patch_of i))) (fun t e => 0 < left_of (patch_of i) t y + e * d * inward (patch_of i) t l)) as [d' [D' U]].
  { intros t Ht. apply in_seq in Ht. rewrite (left_place _ _ _ _ R1 SP). destruct (start_left i s t R1 Hs ltac:(lia)) as [[Z Q]|Q].
    - exists 1. split; [lra|]. intros e E. rewrite Z. assert (IN : 0 < inward (patch_of i) t l) by (destruct Q; subst t; auto).
      rewrite Rplus_0_l. repeat apply Rmult_lt_0_compat; auto; lra.
    - set (a := left_of (patch_of i) t (start (edge_at (patch_of i) s))) in *. set (b := d * inward (patch_of i) t l). pose proof (Rabs_pos b).
      exists (a / (Rabs b + 1)). split; [apply Rdiv_lt_0_compat; lra|]. intros e [E1 E2]. apply (Rmult_lt_compat_r (Rabs b + 1)) in E2; [|lra]. unfold Rdiv in E2. rewrite Rmult_assoc, Rinv_l in E2 by lra.
      replace (e * d * inward (patch_of i) t l) with (e * b) by (unfold b; ring). assert (e * b >= - (e * Rabs b)) by (pose proof (Rle_abs (- b)); rewrite Rabs_Ropp in *; nra). nra. }
  exists d'. split; auto. intros e E. rewrite PE. apply within_at; [apply latb_zero|]. intros t Ht. rewrite left_direction by auto. cbv zeta. fold l.
  rewrite (inward_scale (patch_of i) t (e * d) l). apply U; auto. apply in_seq. lia.
Qed.
Lemma unseen_out i x e : tile_there i -> (x < length samples)%nat -> sees i x = false -> 0 < e -> ~ over r system tiles i (probe x e).
Proof.
  intros HT Hx SE E O. destruct (place_of_spec i HT) as [Hs [_ [_ [W1 _]]]]. destruct (probe_at i HT) as [y [d [D [IY [SP PE]]]]]. set (s := fst (place_of i)) in *. set (k := snd (place_of i)) in *. cbn [fst] in W1.
  destruct (SAMPLED R1) as [_ SA]. destruct (SA (kind i) s k (kinds i) Hs W1) as [_ [_ DEC]]. unfold sees, in_cornerb in SE. fold s k in SE. destruct (dec (in_corner (kind i) s k x)) as [|NI]; [discriminate|].
  destruct (DEC x Hx) as [Q|Q]; [contradiction|]. rewrite PE in O. apply over_inside in O. unfold out_of_corner in Q. cbv zeta in Q. change (patch_at (kind i)) with (patch_of i) in Q.
  assert (ED : 0 < e * d) by (apply Rmult_lt_0_compat; auto).
  assert (BAD : forall t, (t < sides (patch_of i))%nat -> left_of (patch_of i) t (start (edge_at (patch_of i) s)) = 0 -> inward (patch_of i) t (local_direction (fst (turning_at k)) (sample x)) < 0 -> False).
  { intros t Ht Z NEG. specialize (O t Ht). rewrite left_direction in O by auto. cbv zeta in O. rewrite (inward_scale (patch_of i) t (e * d) (local_direction (fst (turning_at k)) (sample x))) in O. rewrite (left_place _ _ _ _ R1 SP), Z in O. nra. }
  destruct Q as [Q|Q]; [apply (BAD s)|apply (BAD (prev (sides (patch_of i)) s))]; auto using prev_lt; [apply left_start, R1|apply left_prev; auto].
Qed.
Theorem valence_there : valence_in_cells is_cell u v 6.
Proof.
  set (M := length samples). destruct (SAMPLED R1) as [M0 SA].
  assert (MP : (0 < M)%nat) by (unfold M; destruct samples; [congruence|cbn; lia]).
  destruct (resolve_valid i0 o0 n0 ok0 lat0) as [VC FC]. set (cc := fst (resolve i0 o0 n0)) in *.
  assert (HC : holds_edge cc u v) by (apply (has_holds cc (snd (resolve i0 o0 n0))); split; apply resolve_corners; auto).
  (* the tiles there *)
  destruct (near_origin_exists (middle u v)) as [Q [_ NQ]]. destruct (mosaic_locally_finite _ _ _ _ _ _ _ tiling Q) as [F HF].
  set (LT := nodup Nat.eq_dec (filter (fun i => if dec (tile_there i) then true else false) F)).
  assert (LTN : NoDup LT) by apply NoDup_nodup.
  assert (LTI : forall i, In i LT <-> tile_there i).
  { intros i. unfold LT. rewrite nodup_In, filter_In. split; [intros [_ D]; destruct (dec _); [auto|discriminate]|]. intros T. split; [|destruct (dec _); tauto].
    apply (HF i (middle u v) NQ). destruct T as [s [k [Hs [A [B _]]]]]. destruct (start_over i s u Hs A) as [x1 [-> [_ I1]]]. destruct (start_over i s v Hs B) as [x2 [-> [_ I2]]]. apply middle_over; auto. }
  (* one distance for all probes *)
  destruct (near_cells (middle u v)) as [e0 [E0 NC]].
  destruct (uniform (seq 0 M) (fun x e => near e0 (middle u v) (probe x e))) as [d1 [D1 U1]].
  { intros x _. apply near_small, E0. }
  destruct (uniform (list_prod LT (seq 0 M)) (fun ix e => sees (fst ix) (snd ix) = true -> within r system tiles (fst ix) (probe (snd ix) e))) as [d2 [D2 U2]].
  { intros [i x] H. apply in_prod_iff in H as [H _]. apply LTI in H. cbn [fst snd]. destruct (sees i x) eqn:SE; [|exists 1; split; [lra|discriminate]].
    destruct (sees_within i x H SE) as [d [D W]]. exists d. split; auto. }
  set (e := Rmin d1 d2 / 2). pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2). assert (0 < Rmin d1 d2) by (apply Rmin_glb_lt; auto).
  assert (E1 : 0 < e < d1) by (unfold e; lra). assert (E2 : 0 < e < d2) by (unfold e; lra). specialize (U1 e E1). specialize (U2 e E2).
  assert (IN : forall i x, tile_there i -> (x < M)%nat -> sees i x = true -> within r system tiles i (probe x e)).
  { intros i x T Hx SE. apply (U2 (i, x)); [apply in_prod; [apply LTI, T|apply in_seq; lia]|exact SE]. }
  assert (CELL : forall x, (x < M)%nat -> exists i o n, tile_there i /\ ok i o /\ latb r n = true /\ In u (corners3 (tri i o n)) /\ In v (corners3 (tri i o n)) /\ over r system tiles i (probe x e)).
  { intros x Hx. destruct (Cells.cover cell piece valid (fun _ => True) RG (opn_const True) CV (probe x e)) as [c [V C]].
    { intros e' He'. exists (probe x e). split; auto. apply near_refl, He'. }
    apply (cell_tiles c (probe x e)); auto. apply (middle_holds cc c u v VC V HC). apply (NC (probe x e)); auto. apply U1, in_seq. lia. }
  assert (ONE : forall x, (x < M)%nat -> exists i, In i LT /\ sees i x = true /\ forall i', In i' LT -> sees i' x = true -> i' = i).
  { intros x Hx. destruct (CELL x Hx) as [i [o [n [T [_ [_ [_ [_ O]]]]]]]]. exists i. split; [apply LTI, T|]. split.
    - destruct (sees i x) eqn:SE; auto. exfalso. apply (unseen_out i x e T Hx SE); [lra|exact O].
    - intros i' T' SE. apply LTI in T'. exact (mosaic_apart _ _ _ _ _ _ _ tiling i' i _ (IN i' x T' Hx SE) O). }
  (* names in all tiles *)
  assert (NAMES : forall i, In i LT -> exists cs : name * name, proper (kind i) (fst cs) /\ proper (kind i) (snd cs) /\ fst cs <> snd cs /\ u = spot_of i (fst cs) /\ v = spot_of i (snd cs) /\ around_tile (kind i) (fst cs) (snd cs) <> []).
  { intros i T. apply LTI in T. destruct (place_of_spec i T) as [Hs [_ [_ [W1 _]]]]. cbn [fst] in W1. destruct (SA (kind i) _ _ (kinds i) Hs W1) as [_ [[x [Hx IC]] _]].
    assert (SE : sees i x = true) by (unfold sees, in_cornerb; destruct (dec _); [auto|contradiction]).
    destruct (CELL x Hx) as [i' [o [n [T' [K [L [A [B O]]]]]]]]. pose proof (mosaic_apart _ _ _ _ _ _ _ tiling i i' _ (IN i x T Hx SE) O) as X. subst i'.
    pose proof A as A'. pose proof B as B'. apply names_In in A as [a [Ha Ea]], B as [b [Hb Eb]]; auto. pose proof (proper_shift _ n _ L (names_proper i o a K Ha)) as Pa. pose proof (proper_shift _ n _ L (names_proper i o b K Hb)) as Pb.
    exists (cshift n a, cshift n b). cbn [fst snd]. split; auto. split; auto. assert (NE : cshift n a <> cshift n b) by (intros X; apply uv; rewrite Ea, Eb, X; reflexivity). split; auto. split; auto. split; auto.
    intros X. assert (Y : In (o, n) (around_tile (kind i) (cshift n a) (cshift n b))) by (apply around_tile_In; auto; rewrite <- Ea, <- Eb; auto). rewrite X in Y. destruct Y. }
  apply (@list_choice (name * name) ((0%N, z30), (0%N, z30))) in NAMES as [cs CS].
  set (occs i := around_tile (kind i) (fst (cs i)) (snd (cs i))).
  assert (OI : forall i o n, tile_there i -> (In (o, n) (occs i) <-> ok i o /\ latb r n = true /\ In u (corners3 (tri i o n)) /\ In v (corners3 (tri i o n)))).
  { intros i o n T. destruct (CS i (proj2 (LTI i) T)) as [Pa [Pb [N [Ea [Eb _]]]]]. unfold occs. rewrite around_tile_In by auto. rewrite <- Ea, <- Eb. reflexivity. }
  destruct (valence_of_tiles tile_there u v uv there_sides there_flat LT occs LTN LTI (fun i _ => around_tile_NoDup i _ _) OI i0 o0 n0 here) as [m [SUM VAL]].
  { apply OI; auto. }
  assert (TOTAL : (list_sum (map (fun i => length (occs i)) LT) * M = 12 * M)%nat).
  { pose proof (count_once LT M sees LTN ONE) as CO. rewrite <- CO at 2. clear SUM CO.
    assert (EACH : forall i, In i LT -> (length (occs i) * M = 12 * length (filter (sees i) (seq 0 M)))%nat).
    { intros i Hi. destruct (CS i Hi) as [Pa [Pb [N [Ea [Eb NN]]]]]. apply LTI in Hi. destruct (place_of_spec i Hi) as [Hs [A [B [W1 _]]]]. cbn [fst] in W1.
      destruct (start_on i _ u Hs A) as [A1 A2]. destruct (start_on i _ v Hs B) as [B1 B2]. rewrite Ea in A1, A2. rewrite Eb in B1, B2. apply on_spot in A1, A2, B1, B2; auto.
      exact (SHARES R1 (kind i) _ _ _ _ (kinds i) Hs W1 NN A1 B1 A2 B2). }
    exact (sum_share (fun i => length (occs i)) (fun i => length (filter (sees i) (seq 0 M))) LT M EACH). }
  assert (m = 6)%nat by nia. subst m. exact VAL.
Qed.
End Corner.

Theorem valence_corner i o n c1 c2 s t : proper (kind i) c1 -> proper (kind i) c2 -> c1 <> c2 -> ok i o -> latb r n = true ->
  In (spot_of i c1) (corners3 (tri i o n)) -> In (spot_of i c2) (corners3 (tri i o n)) ->
  (s < sides (patch_of i))%nat -> (t < sides (patch_of i))%nat -> t <> s -> on_side (kind i) s c1 -> on_side (kind i) s c2 -> on_side (kind i) t c1 -> on_side (kind i) t c2 ->
  valence_in_cells is_cell (spot_of i c1) (spot_of i c2) 6.
Proof.
  intros P1 P2 N K L I1 I2 Hs Ht NE A1 A2 B1 B2. assert (UV : spot_of i c1 <> spot_of i c2) by (intros X; apply N, (spot_inj i); auto).
  destruct (spot_inside i c1 P1) as [x1 [X1 [IX1 LX1]]]. destruct (spot_inside i c2 P2) as [x2 [X2 [IX2 LX2]]].
  unfold on_side in *. change (patch_at (kind i)) with (patch_of i) in *. rewrite <- LX1 in A1, B1. rewrite <- LX2 in A2, B2.
  destruct rank as [R1|R2]; [|exfalso; apply (two_sides_2 (kind i) s t x1 R2 (kinds i) Hs Ht NE A1 B1)].
  pose proof (corner_point (kind i) s t x1 R1 (kinds i) Hs Ht NE IX1 A1 B1) as C1. pose proof (corner_point (kind i) s t x2 R1 (kinds i) Hs Ht NE IX2 A2 B2) as C2.
  change (patch_at (kind i)) with (patch_of i) in *. destruct (CONVEX R1 (kind i) s s (kinds i) Hs Hs) as [N3 _]. destruct (next_neq _ s N3 Hs) as [_ [_ M3]]. change (patch_at (kind i)) with (patch_of i) in M3.
  assert (SP : exists s', (s' < sides (patch_of i))%nat /\ same_place x1 (start (edge_at (patch_of i) s')) /\ same_place x2 (start (edge_at (patch_of i) s'))).
  { destruct C1 as [[T1 D1]|[T1 D1]], C2 as [[T2 D2]|[T2 D2]]; try congruence.
    - exists s. auto.
    - exists (next (sides (patch_of i)) s). split; [apply next_lt, Hs|]. destruct (finish_next (patch_of i) s R1) as [E1 E2], D1 as [D1 D1'], D2 as [D2 D2']. split; split; congruence. }
  destruct SP as [s' [Hs' [S1 S2]]]. destruct (ROT R1) as [[I0 I0'] _ _].
  apply (valence_there R1 i _ _ UV o n); auto. exists s', 0%nat. split; [exact Hs'|]. split; [exists x1; auto|]. split; [exists x2; auto|].
  unfold MosaicHeights.turned. cbn [fst]. rewrite I0'. split; [exact I0|]. unfold no_turning, MosaicHeights.image; cbn [fst snd]. split; apply point_eq; unf; ring.
Qed.

(** ** All edges, and the triangles *)
Theorem valence_of_edge i o n c1 c2 : proper (kind i) c1 -> proper (kind i) c2 -> c1 <> c2 -> ok i o -> latb r n = true ->
  In (spot_of i c1) (corners3 (tri i o n)) -> In (spot_of i c2) (corners3 (tri i o n)) -> exists m, possible (kind i) c1 c2 m /\ valence_in_cells is_cell (spot_of i c1) (spot_of i c2) m.
Proof.
  intros P1 P2 N K L I1 I2.
  destruct (dec (exists s, (s < sides (patch_of i))%nat /\ on_side (kind i) s c1 /\ on_side (kind i) s c2)) as [[s [Hs [A1 A2]]]|NO].
  - destruct (dec (exists t, (t < sides (patch_of i))%nat /\ t <> s /\ on_side (kind i) t c1 /\ on_side (kind i) t c2)) as [[t [Ht [NE [B1 B2]]]]|NO].
    + exists 6%nat. split; [apply (possible_corner (kind i) c1 c2 s t); auto|]. apply (valence_corner i o n c1 c2 s t); auto.
    + apply (valence_side i s o n c1 c2); auto. intros t Ht B1 B2. destruct (Nat.eq_dec t s); auto. exfalso. apply NO. eauto.
  - apply valence_inside; auto. intros s Hs [A1 A2]. apply NO. eauto.
Qed.
(** What is demanded of the possible valences.  [edge_of] are the edges of a patch. *)
Definition edge_of (a : nat) (c1 c2 : name) : Prop := exists o, is_occupant (patch_at a) o /\ In c1 (occupant_names a o) /\ In c2 (occupant_names a o) /\ c1 <> c2.
Hypothesis VALENCES : forall a c1 c2 m, (a < length system)%nat -> edge_of a c1 c2 -> possible a c1 c2 m -> m = 5%nat \/ m = 6%nat.
Hypothesis AXES : forall a q, (a < length system)%nat -> (q < length (pyramids (patch_at a)))%nat -> rim_count (patch_at a) q = 5%nat \/ rim_count (patch_at a) q = 6%nat.
Hypothesis TRIANGLES : forall a o c1 c2 c3, (a < length system)%nat -> is_occupant (patch_at a) o -> In c1 (occupant_names a o) -> In c2 (occupant_names a o) -> In c3 (occupant_names a o) ->
  c1 <> c2 -> c1 <> c3 -> c2 <> c3 -> ~ (possible a c1 c2 6 /\ possible a c1 c3 6).
(** The triangle of a corner of the rim of a join and the two apexes. *)
Hypothesis AXIAL : forall a q b s', (a < length system)%nat -> (b < length system)%nat -> (q < length (pyramids (patch_at a)))%nat -> (s' < sides (patch_at b))%nat ->
  fits G r (patch_at a) (side_of h a q) (patch_at b) s' -> forall e, (e < rim_count (patch_at a) q)%nat ->
  let q' := fst (pyramid_mate h a q b s') in let e' := next (rim_count (patch_at b) q') (rim_mate h a q b s' e) in
  ~ (possible a (apex_name a q) (rim_name a q e) 6 /\ possible b (apex_name b q') (rim_name b q' e') 6) /\
  (rim_count (patch_at a) q = 6%nat -> ~ possible a (apex_name a q) (rim_name a q e) 6 /\ ~ possible b (apex_name b q') (rim_name b q' e') 6).
Lemma across_name_shift a s b s' n c : across_name a s b s' (cshift n c) = cshift n (across_name a s b s' c).
Proof. unfold across_name. cbn [cshift fst snd]. rewrite zadd3_comm. apply cshift_shift. Qed.
Lemma possible_shift a n c1 c2 m : possible a (cshift n c1) (cshift n c2) m -> possible a c1 c2 m.
Proof.
  assert (ON : forall s c, on_side a s (cshift n c) = on_side a s c) by reflexivity.
  assert (P : length (in_pieces a (cshift n c1) (cshift n c2)) = length (in_pieces a c1 c2)) by (unfold in_pieces; rewrite !select_length, edge_key_shift; reflexivity).
  assert (Q : length (at_apexes a (cshift n c1) (cshift n c2)) = length (at_apexes a c1 c2)) by (unfold at_apexes; rewrite !select_length, edge_key_shift; reflexivity).
  intros [NS|s b s' k Hs A1 A2 U Hb Hs' FT E|s t Hs Ht NE A1 A2 B1 B2].
  - rewrite P, Q. apply possible_inside, NS.
  - apply (possible_side a c1 c2 s b s'); auto. rewrite !across_name_shift, !around_tile_shift in E. exact E.
  - apply (possible_corner a c1 c2 s t); auto.
Qed.
Lemma possible_edge i o n a b m : ok i o -> latb r n = true -> In a (occupant_names (kind i) o) -> In b (occupant_names (kind i) o) -> a <> b ->
  valence_in_cells is_cell (spot_of i (cshift n a)) (spot_of i (cshift n b)) m -> possible (kind i) a b m.
Proof.
  intros K L Ha Hb N V. pose proof (names_proper i o a K Ha) as Pa. pose proof (names_proper i o b K Hb) as Pb.
  destruct (valence_of_edge i o n (cshift n a) (cshift n b)) as [m' [P V']]; auto using proper_shift.
  - intros E. apply cshift_inj in E. contradiction.
  - apply names_In; eauto.
  - apply names_In; eauto.
  - rewrite (valence_same _ _ _ _ V V'). apply (possible_shift _ n), P.
Qed.
Lemma valence_56 c u v : valid c -> holds_edge c u v -> u <> v -> valence_in_cells is_cell u v 5 \/ valence_in_cells is_cell u v 6.
Proof.
  intros V H N. destruct (edge_cases c u v V H N) as [[f [F [AX HF]]]|[i [q [e [n [-> D]]]]]].
  - destruct (view_spec c f V F AX) as [i [o [n [K [L R]]]]].
    assert (A : In u (corners3 (tri i o n))) by (destruct HF; apply resolve_corners; auto; rewrite R; auto). assert (B : In v (corners3 (tri i o n))) by (destruct HF; apply resolve_corners; auto; rewrite R; auto).
    pose proof A as A'. pose proof B as B'. apply names_In in A as [a [Ha ->]], B as [b [Hb ->]]; auto.
    pose proof (names_proper i o a K Ha) as Pa. pose proof (names_proper i o b K Hb) as Pb.
    assert (NE : a <> b) by (intros ->; contradiction).
    destruct (valence_of_edge i o n (cshift n a) (cshift n b)) as [m [P VAL]]; auto using proper_shift.
    { intros E. apply cshift_inj in E. contradiction. }
    apply possible_shift in P. destruct (VALENCES (kind i) a b m (kinds i)) as [->| ->]; auto. exists o. auto.
  - pose proof (valence_axis i q e n V) as X. destruct V as [_ [Hq _]]. assert (S : valence_in_cells is_cell u v (rim_count (patch_of i) q)).
    { destruct D as [[-> ->]|[-> ->]]; auto. destruct X as [L [X1 [X2 X3]]]. exists L. split; auto. split; auto. intros t. rewrite X3. unfold cell_with. cbn [In]. split; intros [Q1 Q2]; (split; [exact Q1|intros x Hx; apply Q2; tauto]). }
    destruct (AXES (kind i) q (kinds i) Hq) as [E|E]; change (patch_at (kind i)) with (patch_of i) in E; rewrite E in S; auto.
Qed.
Lemma valence_sym u v m : valence_in_cells is_cell u v m -> valence_in_cells is_cell v u m.
Proof. intros [L [X1 [X2 X3]]]. exists L. split; auto. split; auto. intros t. rewrite X3. unfold cell_with. cbn [In]. split; intros [Q1 Q2]; (split; [exact Q1|intros x Hx; apply Q2; tauto]). Qed.
Notation six u v := (valence_in_cells is_cell u v 6).
Lemma axial_triangle i q e n x : valid (i, Join q e, n) -> (x < rim_count (patch_of i) q)%nat ->
  let X := vd (piece (i, Join q e, n)) in let Z := va (piece (i, Join q e, n)) in let Y := at_ i n (rim_at (patch_of i) q x) in
  ~ (six X Y /\ six Z Y) /\ (six X Z -> ~ six X Y /\ ~ six Z Y).
Proof.
  intros V Hx. cbv zeta. destruct (axis_ends i q e n V) as [j [s' [q' [m [E [PM [Hq' [NE [L' [EA ED]]]]]]]]]]. pose proof (valence_axis i q e n V) as VA. destruct V as [L [Hq [He _]]]. rewrite EA, ED in *.
  destruct (pyramid_facts i q Hq) as [Hs _]. destruct (across_spec i _ j s' Hs E) as [Hs' [_ [_ FT]]].
  assert (K : ok i (Lateral q x)) by (split; auto).
  destruct (mate_resolve i q x n K L) as [j2 [q2 [e2 [n2 [EJ [K2 [L2 [_ [_ [_ [R1 [_ [EQ [EE EN]]]]]]]]]]]]]]. rewrite E in EJ, EQ, EE, EN. cbn [fst snd] in *. subst j2. rewrite PM in EQ, EN. cbn [fst snd] in EQ, EN. subst q2 n2.
  pose proof (AXIAL (kind i) q (kind j) s' (kinds i) (kinds j) Hq Hs' FT x Hx) as AX. cbv zeta in AX. rewrite PM in AX. cbn [fst] in AX. rewrite <- EE in AX.
  change (patch_at (kind i)) with (patch_of i) in *. change (patch_at (kind j)) with (patch_of j) in *.
  destruct (named_apexes NAMED (kind i) q (kinds i) Hq) as [_ A1]. destruct (named_apexes NAMED (kind j) q' (kinds j) Hq') as [_ A2].
  destruct (named_rims NAMED (kind i) q x (kinds i) Hq Hx) as [_ [B1 D1]]. destruct K2 as [_ He2]. destruct (named_rims NAMED (kind j) q' _ (kinds j) Hq' (next_lt _ _ He2)) as [_ [B2 _]]. destruct (named_rims NAMED (kind j) q' e2 (kinds j) Hq' He2) as [_ [_ D2]].
  change (patch_at (kind i)) with (patch_of i) in *. change (patch_at (kind j)) with (patch_of j) in *.
  assert (SX : six (at_ i n (apex_at (patch_of i) q)) (at_ i n (rim_at (patch_of i) q x)) -> possible (kind i) (apex_name (kind i) q) (rim_name (kind i) q x) 6).
  { intros S. rewrite A1, B1, !spot_shift in S. apply (possible_edge i (Lateral q x) n) in S; auto; [cbn; auto|cbn; auto|]. intros X. inversion D1 as [|? ? N1 _]; subst. apply N1. cbn. auto. }
  assert (SZ : six (at_ j (zadd3 (zadd3 n m) (step i (wall i q))) (apex_at (patch_of j) q')) (at_ i n (rim_at (patch_of i) q x)) -> possible (kind j) (apex_name (kind j) q') (rim_name (kind j) q' (next (rim_count (patch_of j) q') e2)) 6).
  { intros S. rewrite R1, A2, B2, !spot_shift in S. apply (possible_edge j (Lateral q' e2) _) in S; auto; [split; auto|cbn; auto|cbn; auto|]. intros X. inversion D2 as [|? ? _ N2]; subst. inversion N2 as [|? ? N3 _]; subst. apply N3. cbn. auto. }
  split.
  - intros [S1 S2]. apply (proj1 AX). auto.
  - intros S. apply valence_sym in S. pose proof (valence_same _ _ _ _ VA S) as C. destruct (proj2 AX C). split; auto.
Qed.
Lemma fourth j1 j2 j3 : In j1 I4 -> In j2 I4 -> In j3 I4 -> exists f, In f I4 /\ j1 <> f /\ j2 <> f /\ j3 <> f.
Proof.
  intros A B C. cbn in A, B, C. destruct A as [<-|[<-|[<-|[<-|[]]]]], B as [<-|[<-|[<-|[<-|[]]]]], C as [<-|[<-|[<-|[<-|[]]]]];
  first [exists 0%nat; split; [cbn; tauto|lia]|exists 1%nat; split; [cbn; tauto|lia]|exists 2%nat; split; [cbn; tauto|lia]|exists 3%nat; split; [cbn; tauto|lia]].
Qed.
Theorem mosaic_tcp : tcp_cells is_cell.
Proof.
  split.
  - intros t u v [Ht HV] N. apply IFF in Ht as [c [V ->]]. apply (valence_56 c); auto. split; apply HV; cbn; auto.
  - intros t u v w [Ht HV] N1 N2 N3 [S1 S2]. apply IFF in Ht as [c [V ->]].
    pose proof (HV u ltac:(cbn; auto)) as U. pose proof (HV v ltac:(cbn; auto)) as W. pose proof (HV w ltac:(cbn; auto)) as Y.
    apply verts_vx in U as [j1 [J1 E1]], W as [j2 [J2 E2]], Y as [j3 [J3 E3]]. destruct (fourth j1 j2 j3 J1 J2 J3) as [f [F [F1 [F2 F3]]]].
    pose proof (vx_facet (piece c) j1 f J1 F F1) as G1. pose proof (vx_facet (piece c) j2 f J2 F F2) as G2. pose proof (vx_facet (piece c) j3 f J3 F F3) as G3. rewrite E1 in G1. rewrite E2 in G2. rewrite E3 in G3.
    destruct (dec (axial (c, f))) as [AX|AX].
    + destruct c as [[i [k|q e]] n]; [destruct AX|]. pose proof V as [L [Hq [He _]]].
      assert (X : exists x, (x < rim_count (patch_of i) q)%nat /\ forall Y, In Y (corners3 (facet (piece (i, Join q e, n)) f)) -> Y = vd (piece (i, Join q e, n)) \/ Y = va (piece (i, Join q e, n)) \/ Y = at_ i n (rim_at (patch_of i) q x)).
      { destruct (axis_ends i q e n V) as [j [s' [q' [m [E [PM _]]]]]]. destruct f as [|[|[|f]]]; cbn in AX; try contradiction; [exists (next (rim_count (patch_of i) q) e)|exists e]; (split; [auto using next_lt|]);
        cbn [MosaicTiling.piece facet corners3 t1 t2 t3 In]; unfold join_at; rewrite E; unfold join; rewrite PM; cbn [map_tet va vb vc vd In corners3 t1 t2 t3]; intros Y [<-|[<-|[<-|[]]]]; auto. }
      destruct X as [x [Hx X]]. destruct (axial_triangle i q e n x V Hx) as [T1 T2]. apply X in G1, G2, G3.
      pose proof (valence_sym _ _ _ S1) as S1'. pose proof (valence_sym _ _ _ S2) as S2'.
      set (P := vd (piece (i, Join q e, n))) in *. set (Q := va (piece (i, Join q e, n))) in *. set (O := at_ i n (rim_at (patch_of i) q x)) in *. clearbody P Q O.
      destruct G1 as [->|[->| ->]], G2 as [->|[->| ->]], G3 as [->|[->| ->]]; try congruence; tauto.
    + destruct (view_spec c f V F AX) as [i [o [n [K [L R]]]]].
      assert (TRI : forall X, In X (corners3 (facet (piece c) f)) -> exists a, In a (occupant_names (kind i) o) /\ X = spot_of i (cshift n a)).
      { intros X HX. apply names_In; auto. apply resolve_corners; auto. rewrite R. exact HX. }
      destruct (TRI u G1) as [a [Ha ->]], (TRI v G2) as [b [Hb ->]], (TRI w G3) as [d [Hd ->]].
      assert (AB : a <> b) by (intros ->; contradiction). assert (AD : a <> d) by (intros ->; contradiction). assert (BD : b <> d) by (intros ->; contradiction).
      apply (TRIANGLES (kind i) o a b d (kinds i) K Ha Hb Hd AB AD BD). split; apply (possible_edge i o n); auto.
Qed.
End System.
