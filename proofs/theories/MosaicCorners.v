(** * Systems of patches: edges over a corner of the mosaic, and TCP

    T has all tiles around the corner, in the words of MosaicAround.v.  No angle is needed.
    Finitely many directions from the corner are sampled.  Near the corner each
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
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Domain Euclid Checker Keys MosaicStatement MosaicPoints MosaicPatches MosaicSides MosaicTiling MosaicHeights MosaicValences MosaicEdges MosaicAround.
From Acutile Require Import Cells.
Import ListNotations.
Open Scope R_scope.

Section System.
Variables (G : gram) (r : nat) (system : list patch) (h : hints).
Hypothesis OK : good G r system h.
Notation patch_at a := (nth a system (Patch [] [] [])).
Notation carry := (carry G r).

Variables (vertex : nat -> N -> point) (vertices : nat -> N).
Variables (piece_name : nat -> nat -> nat -> name) (apex_name : nat -> nat -> name) (rim_name : nat -> nat -> nat -> name).
Notation proper := (MosaicAround.proper r vertices).
Notation named_point := (MosaicAround.named_point vertex).
Notation occupant_names := (MosaicAround.occupant_names system piece_name apex_name rim_name).
Notation named := (MosaicAround.named r system vertex vertices piece_name apex_name rim_name).
Notation named_apexes := (MosaicAround.named_apexes r system vertex vertices piece_name apex_name rim_name).
Notation named_rims := (MosaicAround.named_rims r system vertex vertices piece_name apex_name rim_name).
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
Notation view := (view r system h l1 l2 l3 tiles rise).
Notation ok := (ok system tiles).
Notation tri := (tri system tiles rise).
Notation left_of := (left_of r).
Notation kinds := (kind_lt G r system l1 l2 l3 tiles tiling).
Notation across_spec := (across_spec G r system h OK l1 l2 l3 basis right_handed tiles tiling).
Notation step_spec := (step_spec G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation pyramid_facts := (pyramid_facts G r system h OK l1 l2 l3 tiles tiling).
Notation mate_facts := (mate_facts G r system h OK l1 l2 l3 basis right_handed tiles tiling).
Notation resolve_valid := (resolve_valid G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation view_spec := (view_spec G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation rank := (rank_eq G r system h OK).
Notation IFF := (is_cell_iff G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation PV := (piece_vol G r system h OK l1 l2 l3 basis right_handed tiles tiling rise).
Notation RG := (MosaicTiling.range G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation CV := (covered G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation is_cell := (MosaicStatement.is_cell l1 l2 l3 r system tiles rise).

Notation spot_of := (MosaicAround.spot_of vertex tiles rise).
Notation spot_shift := (MosaicAround.spot_shift vertex tiles rise).
Notation spot_inj := (MosaicAround.spot_inj G r system h OK vertex vertices piece_name apex_name rim_name NAMED l1 l2 l3 basis right_handed tiles tiling rise).
Notation proper_shift := (MosaicAround.proper_shift r vertices).
Notation names_In := (MosaicAround.names_In G r system vertex vertices piece_name apex_name rim_name NAMED l1 l2 l3 tiles tiling rise).
Notation names_proper := (MosaicAround.names_proper G r system vertex vertices piece_name apex_name rim_name NAMED l1 l2 l3 tiles tiling).
Notation view_resolve := (MosaicAround.view_resolve G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation mate_resolve := (MosaicAround.mate_resolve G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation resolve_corners := (MosaicAround.resolve_corners G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation on := (MosaicAround.on r system tiles rise).
Notation on_at := (MosaicAround.on_at G r system h OK l1 l2 l3 basis right_handed tiles tiling rise).
Notation holds_edge := (MosaicAround.holds_edge G r system h l1 l2 l3 tiles rise).
Notation has_holds := (MosaicAround.has_holds G r system h l1 l2 l3 tiles rise).
Notation middle_holds := (MosaicAround.middle_holds G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation around := (MosaicAround.around G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation valence_same := (MosaicAround.valence_same r system l1 l2 l3 tiles rise).
Notation walk := (MosaicAround.walk G r system h OK APEX l1 l2 l3 basis right_handed tiles tiling rise high).
Notation valence_of_tiles := (MosaicAround.valence_of_tiles G r system h OK APEX l1 l2 l3 basis right_handed tiles tiling rise high).
Notation around_tile := (MosaicAround.around_tile system piece_name apex_name rim_name).
Notation in_pieces := (MosaicAround.in_pieces system piece_name).
Notation at_apexes := (MosaicAround.at_apexes system apex_name rim_name).
Notation around_tile_In := (MosaicAround.around_tile_In G r system h OK vertex vertices piece_name apex_name rim_name NAMED l1 l2 l3 basis right_handed tiles tiling rise).
Notation around_tile_NoDup := (MosaicAround.around_tile_NoDup G r system vertex vertices piece_name apex_name rim_name NAMED l1 l2 l3 tiles tiling).
Notation around_tile_shift := (MosaicAround.around_tile_shift system piece_name apex_name rim_name).
Notation left_place := (MosaicSides.left_place r).
Notation finish_next := (MosaicSides.finish_next r).
Notation left_start := (MosaicSides.left_start r).
Notation left_prev := (MosaicSides.left_prev r).
Notation on_side := (MosaicAround.on_side r system vertex).
Notation on_spot := (MosaicAround.on_spot G r system h OK vertex vertices l1 l2 l3 basis right_handed tiles tiling rise).
Notation spot_inside := (MosaicAround.spot_inside G r system h OK vertex vertices piece_name apex_name rim_name NAMED l1 l2 l3 tiles tiling rise).
Notation at_middle := (MosaicAround.at_middle tiles rise).
Notation within_at := (MosaicAround.within_at G r system h OK l1 l2 l3 tiles rise high).
Notation axis_ends := (MosaicAround.axis_ends G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation resolve_lateral := (MosaicAround.resolve_lateral G r system h OK l1 l2 l3 basis right_handed tiles tiling rise).
Notation CONVEX := (good_convex _ _ _ _ OK).
Variable neighbour : nat -> nat -> nat -> nat -> N -> name.
Hypothesis NEIGHBOUR : forall a s b s' v, (a < length system)%nat -> (b < length system)%nat -> (s < sides (patch_at a))%nat -> (s' < sides (patch_at b))%nat ->
  fits G r (patch_at a) s (patch_at b) s' -> (v < vertices a)%N -> left_of (patch_at a) s (vertex a v) = 0 ->
  proper b (neighbour a s b s' v) /\ vertex a v = carry (patch_at a) s (patch_at b) s' (named_point b (neighbour a s b s' v)).
Notation corner_point := (MosaicAround.corner_point G r system h OK).
Notation two_sides_2 := (MosaicAround.two_sides_2 G r system h OK APEX l1 l2 l3 tiles tiling rise high).
Notation carry_start := (MosaicAround.carry_start G r system h OK APEX l1 l2 l3 tiles tiling rise high).
Notation carry_finish := (MosaicAround.carry_finish G r system h OK APEX l1 l2 l3 tiles tiling rise high).
Notation across_name := (MosaicAround.across_name neighbour).
Notation possible := (MosaicAround.possible G r system vertex piece_name apex_name rim_name neighbour).
Notation valence_side := (MosaicAround.valence_side G r system h OK vertex vertices piece_name apex_name rim_name NAMED APEX l1 l2 l3 basis right_handed tiles tiling rise high neighbour NEIGHBOUR).
Notation left_middle := (MosaicAround.left_middle G r system h OK vertex vertices APEX l1 l2 l3 tiles tiling rise high neighbour NEIGHBOUR).
Notation middle_over := (MosaicAround.middle_over G r system h OK vertex vertices APEX l1 l2 l3 tiles tiling rise high neighbour NEIGHBOUR).
Notation edge_cases := (MosaicAround.edge_cases G r system h OK l1 l2 l3 basis right_handed tiles tiling rise).
Notation valence_inside := (MosaicAround.valence_inside G r system h OK vertex vertices piece_name apex_name rim_name NAMED APEX l1 l2 l3 basis right_handed tiles tiling rise high neighbour NEIGHBOUR).
Notation valence_axis := (MosaicAround.valence_axis G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation possible_inside := (MosaicAround.possible_inside G r system vertex piece_name apex_name rim_name neighbour).
Notation possible_side := (MosaicAround.possible_side G r system vertex piece_name apex_name rim_name neighbour).
Notation possible_corner := (MosaicAround.possible_corner G r system vertex piece_name apex_name rim_name neighbour).

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
  unfold MosaicSides.at_, MosaicStatement.spot, MosaicStatement.place, MosaicPoints.lift, MosaicHeights.image, second, third, at_coordinates. destruct (axes (tiles i)) as [[m1 m2] m3]. cbn [fst snd]. apply point_eq; unf; ring.
Qed.
Lemma left_direction p s y e : r = 1%nat -> left_of p s (add y (Point 0 (fst e) (snd e))) = left_of p s y + inward p s e.
Proof. intros R1. unfold MosaicStatement.left_of, inward, along. rewrite R1. cbn [py pz sub add]. ring. Qed.
Lemma over_inside i z : over r system tiles i (at_ i z30 z) -> in_prism r (patch_of i) z.
Proof.
  intros [x [E P]] s Hs. specialize (P s Hs). unfold MosaicSides.at_, MosaicStatement.spot in E.
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
Lemma lift_place n y : latb r n = true -> same_place (MosaicPoints.lift n y) y.
Proof. intros L. apply latb_iff in L. rewrite R1 in L. destruct n as [[n1 n2] n3]. cbn in L. destruct L as [-> ->]. unfold MosaicPoints.lift, pt. split; unf; ring. Qed.
(** The corner in the next tile. *)
Lemma start_across i s t j t' X : (s < sides (patch_of i))%nat -> (t < sides (patch_of i))%nat -> across_side i t = (j, t') -> over_start i s X -> t = s \/ t = prev (sides (patch_of i)) s ->
  over_start j (if Nat.eqb t s then next (sides (patch_of j)) t' else t') X.
Proof.
  intros Hs Ht E [x [-> P]] D. destruct (across_spec i t j t' Ht E) as [Ht' [_ [E' FT]]]. destruct (step_spec j t' i t Ht' E') as [L F].
  exists (MosaicPoints.lift (zopp3 (step j t')) (carry (patch_of j) t' (patch_of i) t x)). split.
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
  unfold MosaicAround.on_side in *. change (patch_at (kind i)) with (patch_of i) in *. rewrite <- LX1 in A1, B1. rewrite <- LX2 in A2, B2.
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
Proof. unfold MosaicAround.across_name. cbn [cshift fst snd]. rewrite zadd3_comm. apply cshift_shift. Qed.
Lemma possible_shift a n c1 c2 m : possible a (cshift n c1) (cshift n c2) m -> possible a c1 c2 m.
Proof.
  assert (ON : forall s c, on_side a s (cshift n c) = on_side a s c) by reflexivity.
  assert (P : length (in_pieces a (cshift n c1) (cshift n c2)) = length (in_pieces a c1 c2)) by (unfold MosaicAround.in_pieces; rewrite !select_length, edge_key_shift; reflexivity).
  assert (Q : length (at_apexes a (cshift n c1) (cshift n c2)) = length (at_apexes a c1 c2)) by (unfold MosaicAround.at_apexes; rewrite !select_length, edge_key_shift; reflexivity).
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
