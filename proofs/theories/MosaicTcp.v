(** * Systems of patches: "true" implies TCP

    The checks of MosaicValences.v imply what MosaicAround.v and MosaicCorners.v demand. *)
Require Import Reals Lra Psatz NArith ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Domain Bounds Euclid Transfer Checker Keys Soundness
  MosaicStatement MosaicPoints MosaicPatches MosaicSides MosaicTiling MosaicHeights MosaicChecker MosaicValences MosaicSpots MosaicSoundness MosaicRotations MosaicEdges MosaicAround MosaicCorners.
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
Variables (system : list (kpatch A)) (h : hints) (apexes : nat -> nat -> list (spot A)) (home : nat -> nat * spot A).
Hypothesis CHECKED : check_system A aadd asub amul aofZ alt ale content quot g r system h apexes home = true.
Variables (labels : list (label A)) (neighbour : nat -> nat -> nat -> nat -> N -> name) (samples : list (A * A)) (turnings : list (k_turning A)).
Hypothesis TCP : check_tcp A aadd asub amul aofZ alt ale content quot g r system h labels neighbour samples turnings = true.
Hypothesis HEIGHTS : check_heights A aadd asub amul aofZ alt ale content quot g r system turnings = true.

Notation spot_eq_ok := (MosaicSpots.spot_eq_ok A amul ale phi phi_mul ale_ok).
Notation lift_ok := (MosaicSpots.lift_ok A aadd amul aofZ phi phi_add phi_mul phi_Z).
Notation lift_pos := (MosaicSpots.lift_pos A aadd amul aofZ phi).
Notation left_sign := (MosaicSpots.left_sign A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok r rank).
Notation left_zero := (MosaicSoundness.left_zero A aadd asub amul aofZ ale phi phi_add phi_sub phi_mul phi_Z ale_ok r rank).
Notation positive_ok := (MosaicSoundness.positive_ok A aadd asub amul aofZ alt ale content quot phi phi_Z alt_ok g r system h apexes home CHECKED).
Notation patch_ok := (MosaicSoundness.patch_ok A phi system).
Notation piece_ok := (MosaicSpots.piece_ok A aofZ phi phi_Z).
Notation apex_ok := (MosaicSpots.apex_ok A aofZ phi phi_Z).
Notation rim_ok := (MosaicSpots.rim_ok A aofZ phi phi_Z).
Notation rim_count_ok := (MosaicSpots.rim_count_ok A aofZ phi phi_Z).
Notation edge_ok := (MosaicSpots.edge_ok A aofZ phi phi_Z).
Notation apart_ok := (MosaicSoundness.apart_ok A asub amul aofZ alt phi phi_sub phi_mul phi_Z alt_ok r rank).
Notation fits_meet := (MosaicSoundness.fits_meet A aofZ phi phi_Z g r system).
Notation pair_fits := (MosaicSoundness.pair_fits A aadd asub amul aofZ alt ale content quot phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok g r rank system h apexes home CHECKED).
Notation system_good := (MosaicSoundness.system_good A aadd asub amul aofZ alt ale content quot phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok g r rank system h apexes home CHECKED).
Notation rotations_ok := (MosaicRotations.rotations_ok A aadd asub amul aofZ alt ale content quot phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok g r rank system h apexes home CHECKED turnings).
Notation no_spot_pos := (MosaicSpots.no_spot_pos A aofZ phi phi_Z).
Notation finish_ok := (MosaicSpots.finish_ok A aofZ phi phi_Z r).
Notation pyramids_length := (MosaicSoundness.pyramids_length A phi system).
Notation pieces_length := (MosaicSoundness.pieces_length A phi system).
Notation sides_length := (MosaicSoundness.sides_length A phi system).
Notation G := (Soundness.phiG A phi g).
Notation rp := (MosaicSpots.rp A phi).
Notation pos := (MosaicSpots.pos A phi).
Notation rpatch := (MosaicSpots.rpatch A phi).
Notation rsystem := (map rpatch system).
Notation patch_at a := (nth a rsystem (Patch [] [] [])).
Notation k_patch := (MosaicChecker.k_patch A system).
Notation zero := (Checker.zero A aofZ).
Notation no_spot := (MosaicChecker.no_spot A aofZ).
Notation k_sides := (MosaicChecker.k_sides A).
Notation k_rim_count := (MosaicChecker.k_rim_count A aofZ).
Notation label_of := (MosaicValences.label_of A labels).
Notation k_vertex := (MosaicValences.k_vertex A aofZ labels).
Notation k_vertices := (MosaicValences.k_vertices A labels).
Notation k_piece_name := (MosaicValences.k_piece_name A labels).
Notation k_apex_name := (MosaicValences.k_apex_name A labels).
Notation k_rim_name := (MosaicValences.k_rim_name A labels).
Notation named_spot := (MosaicValences.named_spot A aadd amul aofZ labels).
Notation is_named := (MosaicValences.is_named A aadd amul aofZ ale r labels).
Notation on := (MosaicValences.on A aadd asub amul aofZ ale r system labels).
Notation k_lateral_names := (MosaicValences.k_lateral_names A aofZ system labels).
Notation k_occupant_names := (MosaicValences.k_occupant_names A aofZ system labels).
Notation tables := (MosaicValences.indexes A aofZ system labels).
Notation doubled := (MosaicValences.doubled A aadd asub amul aofZ ale r system labels neighbour tables).
Notation facets_at := (MosaicValences.facets_at tables).
Notation can_be_six := (MosaicValences.can_be_six A aadd asub amul aofZ ale r system labels neighbour tables).
Notation is_in := (MosaicValences.is_in A asub amul aofZ alt system).
Notation is_out := (MosaicValences.is_out A asub amul aofZ alt system).
Definition vertex (a : nat) (v : N) : point := rp (k_vertex a v).
Notation named := (MosaicAround.named r rsystem vertex k_vertices k_piece_name k_apex_name k_rim_name).
Notation possible := (MosaicAround.possible G r rsystem vertex k_piece_name k_apex_name k_rim_name neighbour).
Notation around_tile := (MosaicAround.around_tile rsystem k_piece_name k_apex_name k_rim_name).
Notation on_side := (MosaicAround.on_side r rsystem vertex).
Notation named_point := (MosaicAround.named_point vertex).
Notation proper := (MosaicAround.proper r k_vertices).
Notation occupant_names := (MosaicAround.occupant_names rsystem k_piece_name k_apex_name k_rim_name).
Notation edge_of := (MosaicCorners.edge_of rsystem k_piece_name k_apex_name k_rim_name).

Lemma length_system : length rsystem = length system.
Proof. apply map_length. Qed.
Lemma edges_checked a : (a < length rsystem)%nat ->
  check_names A aadd asub amul aofZ alt ale r system labels a = true /\ check_apexes A aadd asub amul aofZ alt r system a = true /\
  (forall s b s', (s < k_sides (k_patch a))%nat -> (b < length rsystem)%nat -> (s' < k_sides (k_patch b))%nat -> check_neighbours A aadd asub amul aofZ ale content quot g r system labels neighbour a s b s' = true) /\
  (forall o, In o (occupants A aofZ (k_patch a)) -> check_triangle A aadd asub amul aofZ ale r system labels neighbour tables a o = true) /\
  (forall q, (q < length (k_pyramids A (k_patch a)))%nat -> check_axis A aadd asub amul aofZ ale r system h labels neighbour tables a q = true).
Proof.
  rewrite length_system. intros Ha. pose proof TCP as C. unfold check_tcp in C. cbv zeta in C. apply andb_true_iff in C as [C _]. unfold check_edges in C. pose proof (upto_ok _ _ C a Ha) as K. cbv zeta in K. rewrite !andb_true_iff in K.
  destruct K as [[[[K1 K2] K3] K4] K5]. split; auto. split; auto. split; [|split].
  - intros s b s' Hs Hb Hs'. pose proof (upto_ok _ _ K3 s Hs) as X. pose proof (upto_ok _ _ X b Hb) as Y. apply (upto_ok _ _ Y s' Hs').
  - intros o Ho. rewrite forallb_forall in K4. apply K4, Ho.
  - intros q Hq. apply (upto_ok _ _ K5 q Hq).
Qed.
Lemma distinct_ok l : distinct_names l = true -> NoDup l.
Proof.
  induction l as [|x l IH]; [constructor|]. cbn [distinct_names]. rewrite andb_true_iff, forallb_forall. intros [H K]. constructor; auto.
  intros I. specialize (H x I). apply negb_true_iff in H. assert (ceqb x x = true) by (apply ceqb_t; reflexivity). congruence.
Qed.
Lemma names_checked a : (a < length rsystem)%nat -> (forall v, pos (k_vertex a v)) /\
  (forall i j n, (i < length (l_vertices A (label_of a)))%nat -> (j < length (l_vertices A (label_of a)))%nat -> latb r n = true ->
     rp (nth i (l_vertices A (label_of a)) no_spot) = lift n (rp (nth j (l_vertices A (label_of a)) no_spot)) -> i = j) /\
  (forall v s, (v < k_vertices a)%N -> (s < k_sides (k_patch a))%nat -> on a s (v, z30) = true \/ 0 < left_of r (patch_at a) s (vertex a v)).
Proof.
  intros Ha. destruct (edges_checked a Ha) as [C _]. unfold check_names in C. cbv zeta in C. rewrite !andb_true_iff in C. destruct C as [[[[C1 C2] C3] _] _].
  rewrite forallb_forall in C1, C3. assert (P : forall x, In x (l_vertices A (label_of a)) -> pos x) by (intros x Hx; specialize (C1 x Hx); apply alt_ok in C1; unfold MosaicSpots.pos; rewrite <- (phi_Z 0); exact C1).
  assert (PV : forall v, pos (k_vertex a v)).
  { intros v. unfold MosaicValences.k_vertex. destruct (Nat.lt_ge_cases (N.to_nat v) (length (l_vertices A (label_of a)))) as [L|L]; [apply P, nth_In, L|rewrite nth_overflow by exact L; apply no_spot_pos]. }
  split; [exact PV|]. split.
  - (* both orders *)
    assert (ONE : forall l, (forall x, In x l -> pos x) -> all_apart A asub amul aofZ alt r l = true -> forall i j n, (i < j)%nat -> (j < length l)%nat -> latb r n = true -> rp (nth i l no_spot) <> lift n (rp (nth j l no_spot))).
    { induction l as [|x l IH]; intros PL AP i j n IJ JL L; [cbn in JL; lia|]. cbn [all_apart] in AP. apply andb_true_iff in AP as [AP1 AP2]. rewrite forallb_forall in AP1.
      destruct j as [|j]; [lia|]. cbn [length] in JL. destruct i as [|i]; cbn [nth].
      - assert (I : In (nth j l no_spot) l) by (apply nth_In; lia). apply apart_ok; auto; apply PL; cbn; auto.
      - apply IH; auto; [intros y Hy; apply PL; cbn; auto|lia|lia]. }
    intros i j n Hi Hj L E. destruct (Nat.lt_total i j) as [Q|[Q|Q]]; auto; exfalso.
    + exact (ONE _ P C2 i j n Q Hj L E).
    + apply (ONE _ P C2 j i (zopp3 n) Q Hi (latb_opp r n L)). rewrite E, lift_lift, (zadd3_comm (zopp3 n) n), zadd3_opp, lift_zero. reflexivity.
  - intros v s Hv Hs. assert (I : In (k_vertex a v) (l_vertices A (label_of a))).
    { unfold MosaicValences.k_vertex. apply nth_In. unfold MosaicValences.k_vertices in Hv. lia. }
    specialize (C3 _ I). pose proof (upto_ok _ _ C3 s Hs) as K. cbv beta zeta in K. apply orb_true_iff in K as [K|K]; [left; exact K|right].
    rewrite patch_ok. apply left_sign; auto. apply (positive_ok a Ha).
Qed.
Lemma on_ok a s c : (a < length rsystem)%nat -> on a s c = true -> on_side a s c.
Proof.
  intros Ha H. unfold MosaicAround.on_side, vertex. rewrite patch_ok. apply left_zero; auto; [apply (positive_ok a Ha)|apply (names_checked a Ha)].
Qed.
Lemma on_back a s c : (a < length rsystem)%nat -> (fst c < k_vertices a)%N -> (s < k_sides (k_patch a))%nat -> on_side a s c -> on a s c = true.
Proof.
  intros Ha Hc Hs O. destruct (names_checked a Ha) as [_ [_ D]]. destruct (D (fst c) s Hc Hs) as [X|X]; [exact X|]. unfold MosaicAround.on_side in O. lra.
Qed.
Lemma named_spot_ok a c : (a < length rsystem)%nat -> pos (named_spot a c) /\ rp (named_spot a c) = named_point a c.
Proof.
  intros Ha. destruct (names_checked a Ha) as [P _]. unfold MosaicValences.named_spot. split; [apply lift_pos, P|]. rewrite lift_ok by apply P. reflexivity.
Qed.
Lemma is_named_ok a c x : (a < length rsystem)%nat -> pos x -> is_named a c x = true -> proper a c /\ rp x = named_point a c.
Proof.
  intros Ha P H. unfold MosaicValences.is_named in H. rewrite !andb_true_iff in H. destruct H as [[H1 H2] H3]. apply N.ltb_lt in H1. destruct (named_spot_ok a c Ha) as [Q E].
  apply spot_eq_ok in H3; auto. rewrite E in H3. split; [split; auto|exact H3].
Qed.
Lemma rim_count_at a q : rim_count (patch_at a) q = k_rim_count (k_patch a) q.
Proof. rewrite patch_ok. apply rim_count_ok. Qed.
Lemma lateral_names_ok a q e : MosaicAround.lateral_names rsystem k_apex_name k_rim_name a q e = k_lateral_names a q e.
Proof. unfold MosaicAround.lateral_names, MosaicValences.k_lateral_names. rewrite rim_count_at. reflexivity. Qed.
Lemma occupant_names_ok a o : occupant_names a o = k_occupant_names a o.
Proof. destruct o; cbn [MosaicAround.occupant_names MosaicValences.k_occupant_names]; [reflexivity|apply lateral_names_ok]. Qed.
Lemma corner_rtet t j : In j I4 -> vx (rtet A phi t) j = rp (k_corner A t j).
Proof. destruct t as [[[x y] z] w]. intros J. cbn in J. destruct J as [<-|[<-|[<-|[<-|[]]]]]; reflexivity. Qed.
Lemma corner_in t j : In j I4 -> In (k_corner A t j) (corner_list A t).
Proof. destruct t as [[[x y] z] w]. intros J. cbn in J. destruct J as [<-|[<-|[<-|[<-|[]]]]]; cbn; auto. Qed.
Theorem named_ok : named.
Proof.
  constructor.
  - intros a k Ha Hk. rewrite pieces_length in Hk. destruct (edges_checked a Ha) as [C _]. unfold check_names in C. cbv zeta in C. rewrite !andb_true_iff in C. destruct C as [[_ C] _].
    pose proof (upto_ok _ _ C k Hk) as K. cbv beta in K. apply andb_true_iff in K as [K1 K2]. rewrite forallb_forall in K2. split; [apply distinct_ok, K1|]. intros j J. specialize (K2 j J).
    destruct (positive_ok a Ha) as [[_ [_ [_ PT]]] _]. specialize (PT k). unfold tet_pos in PT. rewrite Forall_forall in PT.
    apply is_named_ok in K2; [|exact Ha|apply PT, corner_in, J]. destruct K2 as [K2 K3]. split; auto. rewrite patch_ok, piece_ok, corner_rtet; auto.
  - intros a q Ha Hq. rewrite pyramids_length in Hq. destruct (edges_checked a Ha) as [C _]. unfold check_names in C. cbv zeta in C. rewrite !andb_true_iff in C. destruct C as [_ C].
    pose proof (upto_ok _ _ C q Hq) as K. cbv beta in K. apply andb_true_iff in K as [K _]. apply is_named_ok in K; auto; [|apply (positive_ok a Ha)]. rewrite patch_ok, apex_ok. exact K.
  - intros a q e Ha Hq He. rewrite pyramids_length in Hq. rewrite rim_count_at in He. destruct (edges_checked a Ha) as [C _]. unfold check_names in C. cbv zeta in C. rewrite !andb_true_iff in C. destruct C as [_ C].
    pose proof (upto_ok _ _ C q Hq) as K. cbv beta in K. apply andb_true_iff in K as [_ K]. pose proof (upto_ok _ _ K e He) as K2. cbv beta in K2. apply andb_true_iff in K2 as [K2 K3].
    apply is_named_ok in K2; auto; [|apply (positive_ok a Ha)]. rewrite lateral_names_ok. rewrite patch_ok, rim_ok. destruct K2. split; auto. split; auto. apply distinct_ok, K3.
  - intros a v v' n Ha Hv Hv' L E. destruct (names_checked a Ha) as [_ [AP _]]. unfold MosaicValences.k_vertices in Hv, Hv'. apply N2Nat.inj. apply (AP _ _ n); auto; lia.
  - intros a v Ha Hv s Hs. rewrite sides_length in Hs. destruct (names_checked a Ha) as [_ [_ D]]. destruct (D v s Hv Hs) as [X|X]; [|lra]. apply on_ok in X; auto. unfold MosaicAround.on_side in X. cbn [fst] in X. lra.
Qed.
Lemma apexes_inside a q s : (a < length rsystem)%nat -> (q < length (pyramids (patch_at a)))%nat -> (s < sides (patch_at a))%nat -> 0 < left_of r (patch_at a) s (apex_at (patch_at a) q).
Proof.
  intros Ha Hq Hs. destruct (edges_checked a Ha) as [_ [C _]]. unfold check_apexes in C. cbv zeta in C. destruct (positive_ok a Ha) as [PP _].
  rewrite pyramids_length in Hq. rewrite sides_length in Hs. pose proof (upto_ok _ _ C q Hq) as K. pose proof (upto_ok _ _ K s Hs) as K2. rewrite patch_ok, apex_ok. apply left_sign; auto. apply PP.
Qed.
Lemma neighbour_ok a s b s' v : (a < length rsystem)%nat -> (b < length rsystem)%nat -> (s < sides (patch_at a))%nat -> (s' < sides (patch_at b))%nat ->
  fits G r (patch_at a) s (patch_at b) s' -> (v < k_vertices a)%N -> left_of r (patch_at a) s (vertex a v) = 0 ->
  proper b (neighbour a s b s' v) /\ vertex a v = carry G r (patch_at a) s (patch_at b) s' (named_point b (neighbour a s b s' v)).
Proof.
  intros Ha Hb Hs Hs' FT Hv Z. rewrite sides_length in Hs, Hs'. destruct (edges_checked a Ha) as [_ [_ [C _]]]. specialize (C s b s' Hs Hb Hs'). unfold check_neighbours in C. cbv zeta in C.
  pose proof (fits_meet _ _ _ _ FT) as CM. rewrite CM in C. assert (Hi : (N.to_nat v < length (l_vertices A (label_of a)))%nat) by (unfold MosaicValences.k_vertices in Hv; lia).
  pose proof (upto_ok _ _ C _ Hi) as K. cbv beta zeta in K. rewrite N2Nat.id in K. rewrite (on_back a s (v, z30) Ha Hv Hs Z) in K. rewrite !andb_true_iff in K. destruct K as [[K1 K2] K3]. apply N.ltb_lt in K1.
  split; [split; auto|]. destruct (pair_fits a s b s' Ha Hb Hs Hs' CM) as [_ CO]. destruct (named_spot_ok b (neighbour a s b s' v) Hb) as [P E]. destruct (CO _ P) as [CP CE].
  apply spot_eq_ok in K3; auto; [|apply (names_checked a Ha)]. unfold vertex. rewrite K3, CE, E. reflexivity.
Qed.

(** ** Counts *)
Lemma occupants_ok a : occupants_of (patch_at a) = occupants A aofZ (k_patch a).
Proof.
  unfold occupants_of, MosaicChecker.occupants. rewrite pieces_length, pyramids_length. f_equal. apply flat_map_ext. intros q. rewrite rim_count_at. reflexivity.
Qed.
Lemma tables_ok a : (a < length rsystem)%nat -> tables_at tables a = (indexed (facet_keys A aofZ system labels a), indexed (piece_keys A system labels a), indexed (apex_keys A aofZ system labels a)).
Proof.
  rewrite length_system. intros Ha. unfold tables_at, indexes. set (f := fun a => (indexed (facet_keys A aofZ system labels a), indexed (piece_keys A system labels a), indexed (apex_keys A aofZ system labels a))).
  rewrite (nth_indep _ _ (f 0%nat)) by (rewrite map_length, seq_length; exact Ha). rewrite (map_nth f (seq 0 (length system)) 0%nat). rewrite seq_nth by exact Ha. reflexivity.
Qed.
Lemma facets_ok a c1 c2 : (a < length rsystem)%nat -> facets_at a c1 c2 = length (around_tile a c1 c2).
Proof.
  intros Ha. unfold MosaicValences.facets_at. rewrite tables_ok by auto. cbn [fst]. unfold MosaicAround.around_tile. rewrite select_length. f_equal. f_equal. unfold facet_keys, all_keys. rewrite occupants_ok.
  apply flat_map_ext. intros o. rewrite occupant_names_ok. reflexivity.
Qed.
Lemma pieces_ok a c1 c2 : (a < length rsystem)%nat -> pieces_at tables a c1 c2 = length (in_pieces rsystem k_piece_name a c1 c2).
Proof.
  intros Ha. unfold pieces_at. rewrite tables_ok by auto. cbn [fst snd]. unfold in_pieces. rewrite select_length, pieces_length. reflexivity.
Qed.
Lemma apexes_ok a c1 c2 : (a < length rsystem)%nat -> apexes_at tables a c1 c2 = length (at_apexes rsystem k_apex_name k_rim_name a c1 c2).
Proof.
  intros Ha. unfold apexes_at. rewrite tables_ok by auto. cbn [snd]. unfold at_apexes. rewrite select_length. f_equal. f_equal. unfold apex_keys, all_keys.
  assert (E : k_rim_places A aofZ (k_patch a) = rim_places (patch_at a)).
  { unfold k_rim_places, rim_places. rewrite pyramids_length. apply flat_map_ext. intros q. rewrite rim_count_at. reflexivity. }
  rewrite E. apply flat_map_ext. intros [q e]. unfold apex_pairs, apex_pairs_of. rewrite lateral_names_ok. reflexivity.
Qed.
Lemma sides_with_In a c1 c2 s : (a < length rsystem)%nat -> (fst c1 < k_vertices a)%N -> (fst c2 < k_vertices a)%N ->
  (In s (sides_with A aadd asub amul aofZ ale r system labels a c1 c2) <-> (s < sides (patch_at a))%nat /\ on_side a s c1 /\ on_side a s c2).
Proof.
  intros Ha H1 H2. unfold sides_with. rewrite filter_In, in_seq, andb_true_iff, sides_length. split.
  - intros [Hs [O1 O2]]. split; [lia|]. split; apply on_ok; auto.
  - intros [Hs [O1 O2]]. split; [lia|]. split; apply on_back; auto.
Qed.
Theorem doubled_ok a c1 c2 m : (a < length rsystem)%nat -> (fst c1 < k_vertices a)%N -> (fst c2 < k_vertices a)%N -> possible a c1 c2 m -> In (2 * m)%nat (doubled a c1 c2).
Proof.
  intros Ha H1 H2 P. unfold MosaicValences.doubled. pose proof (fun s => sides_with_In a c1 c2 s Ha H1 H2) as SW.
  assert (ND : NoDup (sides_with A aadd asub amul aofZ ale r system labels a c1 c2)) by (apply NoDup_filter, seq_NoDup).
  set (l := sides_with A aadd asub amul aofZ ale r system labels a c1 c2) in *. clearbody l. destruct P as [NS|s b s' m Hs O1 O2 U Hb Hs' FT E|s t Hs Ht NE A1 A2 B1 B2].
  - destruct l as [|s l]; [|exfalso; destruct (proj1 (SW s) (or_introl eq_refl)) as [Hs [O1 O2]]; apply (NS s Hs); auto]. left. rewrite pieces_ok, apexes_ok by auto. reflexivity.
  - assert (I : In s l) by (apply SW; auto). destruct l as [|x [|y l]].
    + destruct I.
    + destruct I as [->|[]]. apply in_flat_map. exists b. rewrite length_system in Hb. split; [apply in_seq; lia|]. apply in_flat_map. rewrite sides_length in Hs'. exists s'. split; [apply in_seq; lia|].
      rewrite (fits_meet _ _ _ _ FT). left. rewrite !facets_ok by (auto; rewrite length_system; auto). symmetry. exact E.
    + exfalso. destruct (proj1 (SW x) (or_introl eq_refl)) as [Hx [X1 X2]]. destruct (proj1 (SW y) (or_intror (or_introl eq_refl))) as [Hy [Y1 Y2]].
      pose proof (U x Hx X1 X2). pose proof (U y Hy Y1 Y2). subst x y. inversion ND as [|? ? N _]. apply N. cbn. auto.
  - assert (I : In s l) by (apply SW; auto). assert (J : In t l) by (apply SW; auto). destruct l as [|x [|y l]]; [destruct I| |left; reflexivity].
    destruct I as [->|[]], J as [->|[]]. contradiction.
Qed.
Lemma name_proper a o c : (a < length rsystem)%nat -> is_occupant (patch_at a) o -> In c (occupant_names a o) -> proper a c.
Proof.
  intros Ha. destruct o as [k f|q e]; intros [Hk Hf] Hc.
  - cbn [MosaicAround.occupant_names] in Hc. apply in_map_iff in Hc as [j [<- Hj]]. apply filter_In in Hj as [J _]. apply (named_pieces _ _ _ _ _ _ _ named_ok a k Ha Hk), J.
  - cbn [MosaicAround.occupant_names MosaicAround.lateral_names In] in Hc. destruct Hc as [<-|[<-|[<-|[]]]].
    + apply (named_rims _ _ _ _ _ _ _ named_ok a q e Ha Hk Hf).
    + apply (named_apexes _ _ _ _ _ _ _ named_ok a q Ha Hk).
    + apply (named_rims _ _ _ _ _ _ _ named_ok a q _ Ha Hk (next_lt _ _ Hf)).
Qed.
Lemma occupant_listed a o : is_occupant (patch_at a) o -> In o (occupants A aofZ (k_patch a)).
Proof. intros H. rewrite <- occupants_ok. apply occupants_of_In, H. Qed.
Theorem valences_ok a c1 c2 m : (a < length rsystem)%nat -> edge_of a c1 c2 -> possible a c1 c2 m -> m = 5%nat \/ m = 6%nat.
Proof.
  intros Ha [o [K [I1 [I2 N]]]] P. pose proof (name_proper a o c1 Ha K I1) as [V1 _]. pose proof (name_proper a o c2 Ha K I2) as [V2 _]. apply doubled_ok in P; auto.
  destruct (edges_checked a Ha) as [_ [_ [_ [C _]]]]. specialize (C o (occupant_listed a o K)). unfold check_triangle in C. cbv zeta in C. apply andb_true_iff in C as [C _]. rewrite forallb_forall in C.
  rewrite occupant_names_ok in I1, I2. specialize (C ((c1, c2), doubled a c1 c2)). cbn [snd] in C. rewrite forallb_forall in C.
  assert (D : ((2 * m =? 10) || (2 * m =? 12))%nat = true).
  { apply C; auto. apply in_map_iff. exists (c1, c2). split; [reflexivity|]. apply ordered_In. auto. }
  rewrite orb_true_iff, !Nat.eqb_eq in D. lia.
Qed.
Theorem triangles_ok a o c1 c2 c3 : (a < length rsystem)%nat -> is_occupant (patch_at a) o -> In c1 (occupant_names a o) -> In c2 (occupant_names a o) -> In c3 (occupant_names a o) ->
  c1 <> c2 -> c1 <> c3 -> c2 <> c3 -> ~ (possible a c1 c2 6 /\ possible a c1 c3 6).
Proof.
  intros Ha K I1 I2 I3 N1 N2 N3 [P Q]. pose proof (name_proper a o c1 Ha K I1) as [V1 _]. pose proof (name_proper a o c2 Ha K I2) as [V2 _]. pose proof (name_proper a o c3 Ha K I3) as [V3 _].
  apply doubled_ok in P, Q; auto. destruct (edges_checked a Ha) as [_ [_ [_ [C _]]]]. specialize (C o (occupant_listed a o K)). unfold check_triangle in C. cbv zeta in C. apply andb_true_iff in C as [_ C].
  rewrite occupant_names_ok in I1, I2, I3. rewrite forallb_forall in C.
  assert (S : forall c, In c (k_occupant_names a o) -> c1 <> c -> In 12%nat (doubled a c1 c) -> In ((c1, c), doubled a c1 c) (filter (fun v => existsb (Nat.eqb 12) (snd v)) (map (fun p => (p, doubled a (fst p) (snd p))) (ordered (k_occupant_names a o))))).
  { intros c Ic Nc D. apply filter_In. cbn [snd]. split; [|apply existsb_exists; exists 12%nat; split; [exact D|reflexivity]]. apply in_map_iff. exists (c1, c). split; [reflexivity|]. apply ordered_In. auto. }
  specialize (C _ (S c2 I2 N1 P)). rewrite forallb_forall in C. specialize (C _ (S c3 I3 N2 Q)). cbn [fst snd] in C. apply orb_true_iff in C as [C|C].
  - apply negb_true_iff in C. assert (ceqb c1 c1 = true) by (apply ceqb_t; reflexivity). congruence.
  - apply ceqb_t in C. contradiction.
Qed.
Lemma six_ok a c1 c2 : (a < length rsystem)%nat -> proper a c1 -> proper a c2 -> possible a c1 c2 6 -> can_be_six a c1 c2 = true.
Proof. intros Ha [V1 _] [V2 _] P. apply doubled_ok in P; auto. unfold MosaicValences.can_be_six. apply existsb_exists. exists 12%nat. split; [exact P|reflexivity]. Qed.
Theorem axes_ok a q : (a < length rsystem)%nat -> (q < length (pyramids (patch_at a)))%nat -> rim_count (patch_at a) q = 5%nat \/ rim_count (patch_at a) q = 6%nat.
Proof.
  intros Ha Hq. rewrite pyramids_length in Hq. destruct (edges_checked a Ha) as [_ [_ [_ [_ C]]]]. specialize (C q Hq). unfold check_axis in C. cbv zeta in C. apply andb_true_iff in C as [C _].
  rewrite orb_true_iff, !Nat.eqb_eq in C. rewrite rim_count_at. exact C.
Qed.
Theorem axial_ok a q b s' : (a < length rsystem)%nat -> (b < length rsystem)%nat -> (q < length (pyramids (patch_at a)))%nat -> (s' < sides (patch_at b))%nat ->
  fits G r (patch_at a) (side_of h a q) (patch_at b) s' -> forall e, (e < rim_count (patch_at a) q)%nat ->
  let q' := fst (pyramid_mate h a q b s') in let e' := next (rim_count (patch_at b) q') (rim_mate h a q b s' e) in
  ~ (possible a (k_apex_name a q) (k_rim_name a q e) 6 /\ possible b (k_apex_name b q') (k_rim_name b q' e') 6) /\
  (rim_count (patch_at a) q = 6%nat -> ~ possible a (k_apex_name a q) (k_rim_name a q e) 6 /\ ~ possible b (k_apex_name b q') (k_rim_name b q' e') 6).
Proof.
  intros Ha Hb Hq Hs' FT e He. cbv zeta. pose proof Hq as Hq0. rewrite pyramids_length in Hq. destruct (edges_checked a Ha) as [_ [_ [_ [_ C]]]]. specialize (C q Hq). unfold check_axis in C. cbv zeta in C. apply andb_true_iff in C as [_ C].
  pose proof Hb as Hb'. rewrite length_system in Hb'. pose proof (upto_ok _ _ C b Hb') as K. pose proof Hs' as Hs2. rewrite sides_length in Hs2. pose proof (upto_ok _ _ K s' Hs2) as K2. cbv beta in K2.
  rewrite (fits_meet _ _ _ _ FT) in K2. pose proof He as He0. rewrite rim_count_at in He. pose proof (upto_ok _ _ K2 e He) as K3. cbv beta zeta in K3.
  assert (Hs : (side_of h a q < sides (patch_at a))%nat) by (apply (good_pyramids _ _ _ _ system_good a q Ha Hq0)).
  destruct (good_pairs _ _ _ _ system_good a (side_of h a q) b s' Ha Hb Hs Hs' FT) as [GP _]. specialize (GP q Hq0 eq_refl). destruct (pyramid_mate h a q b s') as [q' mm]. cbn [fst] in *.
  destruct GP as [Hq' [_ [_ [_ [RI _]]]]]. destruct (RI e He0) as [He' _]. rewrite <- rim_count_at in K3.
  destruct (named_apexes _ _ _ _ _ _ _ named_ok a q Ha Hq0) as [PA _]. destruct (named_rims _ _ _ _ _ _ _ named_ok a q e Ha Hq0 He0) as [PR _].
  destruct (named_apexes _ _ _ _ _ _ _ named_ok b q' Hb Hq') as [PA' _]. destruct (named_rims _ _ _ _ _ _ _ named_ok b q' _ Hb Hq' (next_lt _ _ He')) as [PR' _].
  apply andb_true_iff in K3 as [K3 K4]. split.
  - intros [P Q]. apply six_ok in P, Q; auto. rewrite P, Q in K3. discriminate.
  - intros S. rewrite <- rim_count_at, S in K4. cbn [Nat.eqb orb] in K4. apply negb_true_iff, orb_false_iff in K4 as [K4 K5].
    split; intros P; apply six_ok in P; auto; congruence.
Qed.

(** ** Corners *)
Lemma phi_zero : phi zero = 0.
Proof. apply phi_Z. Qed.
Notation rturnings := (map (rturning A phi) turnings).
Definition rsamples : list (R * R) := map (fun d => (phi (fst d), phi (snd d))) samples.
Notation in_corner := (MosaicCorners.in_corner r rsystem rturnings rsamples).
Notation out_of_corner := (MosaicCorners.out_of_corner r rsystem rturnings rsamples).
Lemma corners_checked : r = 1%nat -> samples <> [] /\ (forall t, In t turnings -> positive_turning A asub amul aofZ alt t = true) /\
  forall a s, (a < length rsystem)%nat -> (s < k_sides (k_patch a))%nat -> check_corner A aadd asub amul aofZ alt ale r system labels samples turnings tables a s = true.
Proof.
  intros R1. pose proof TCP as C. unfold check_tcp in C. cbv zeta in C. apply andb_true_iff in C as [_ C]. unfold check_corners in C. rewrite R1 in C at 1. cbn [Nat.eqb] in C. rewrite !andb_true_iff in C. destruct C as [[C1 C2] C3].
  split; [intros E; rewrite E in C1; discriminate|]. rewrite forallb_forall in C2. split; [exact C2|]. intros a s Ha Hs. rewrite length_system in Ha. pose proof (upto_ok _ _ C3 a Ha) as K. apply (upto_ok _ _ K s Hs).
Qed.
Lemma rot_ok : r = 1%nat -> check_rotations A aadd asub amul aofZ alt ale content quot g r system turnings = true.
Proof. intros R1. pose proof HEIGHTS as C. unfold check_heights in C. rewrite R1 in C at 1. exact C. Qed.
Lemma turning_positive t : r = 1%nat -> In t turnings -> 0 < phi (fst (fst t)).
Proof.
  intros R1 Ht. pose proof (rot_ok R1) as C. unfold check_rotations in C. rewrite !andb_true_iff in C. destruct C as [[[C1 _] _] _]. rewrite forallb_forall in C1. specialize (C1 t Ht).
  apply andb_true_iff in C1 as [C1 _]. apply alt_ok in C1. rewrite phi_zero in C1. exact C1.
Qed.
Lemma turning_at k : (k < length rturnings)%nat -> exists t, In t turnings /\ nth k rturnings no_turning = rturning A phi t.
Proof.
  rewrite map_length. intros Hk. destruct turnings as [|t0 ts] eqn:E; [cbn in Hk; lia|]. rewrite <- E in *. exists (nth k turnings t0). split; [apply nth_In, Hk|].
  rewrite (nth_indep _ _ (rturning A phi t0)) by (rewrite map_length; exact Hk). apply map_nth.
Qed.
Lemma inward_ok p s (t : k_turning A) d : r = 1%nat -> positive_patch A aofZ phi p -> 0 < phi (fst (fst t)) -> exists k, 0 < k /\
  phi (k_inward A asub amul aofZ p s (k_local A asub amul t d)) = k * inward r (rpatch p) s (local_direction (fst (rturning A phi t)) (phi (fst d), phi (snd d))).
Proof.
  intros R1 [PS _] W. pose proof (PS s) as P. pose proof (PS (next (k_sides p) s)) as Q. unfold MosaicSpots.pos in P, Q. destruct t as [[w [[[a b] c] e]] f]. cbn [fst] in W.
  exists (phi (weight A (k_start A aofZ p s)) * phi (weight A (k_start A aofZ p (next (k_sides p) s))) * phi w). split; [repeat apply Rmult_lt_0_compat; auto|].
  unfold k_inward, k_local, base_diff, inward, along, local_direction, rturning, rmatrix. rewrite finish_ok, edge_ok by auto. cbn [fst snd start py pz sub].
  repeat rewrite ?phi_sub, ?phi_mul. unfold MosaicSpots.rp, scale, Soundness.phi3; cbn [py pz]. field. repeat split; lra.
Qed.
Lemma sample_at x : (x < length rsamples)%nat -> exists d, In d samples /\ nth x rsamples (0, 0) = (phi (fst d), phi (snd d)).
Proof.
  unfold rsamples. rewrite map_length. intros Hx. destruct samples as [|d0 ds] eqn:E; [cbn in Hx; lia|]. rewrite <- E in *. exists (nth x samples d0). split; [apply nth_In, Hx|].
  rewrite (nth_indep _ _ ((fun d => (phi (fst d), phi (snd d))) d0)) by (rewrite map_length; exact Hx). apply (map_nth (fun d => (phi (fst d), phi (snd d)))).
Qed.
Lemma is_in_ok a s k x t d : r = 1%nat -> (a < length rsystem)%nat -> In t turnings -> nth k rturnings no_turning = rturning A phi t -> nth x rsamples (0, 0) = (phi (fst d), phi (snd d)) ->
  (is_in a s t d = true -> in_corner a s k x) /\ (is_out a s t d = true -> out_of_corner a s k x).
Proof.
  intros R1 Ha Ht Ek Ex. destruct (positive_ok a Ha) as [PP _]. pose proof (turning_positive t R1 Ht) as W. unfold MosaicCorners.in_corner, MosaicCorners.out_of_corner. cbv zeta. rewrite Ek, Ex, !sides_length, !patch_ok.
  unfold MosaicValences.is_in, MosaicValences.is_out. cbv zeta. destruct (inward_ok (k_patch a) s t d R1 PP W) as [k1 [K1 E1]]. destruct (inward_ok (k_patch a) (prev (k_sides (k_patch a)) s) t d R1 PP W) as [k2 [K2 E2]].
  rewrite andb_true_iff, orb_true_iff. split.
  - intros [A1 A2]. apply alt_ok in A1, A2. rewrite phi_zero, E1 in A1. rewrite phi_zero, E2 in A2. split; nra.
  - intros [A1|A1]; apply alt_ok in A1; rewrite phi_zero in A1; [rewrite E1 in A1; left|rewrite E2 in A1; right]; nra.
Qed.
Theorem sampled_ok : r = 1%nat -> rsamples <> [] /\ forall a s k, (a < length rsystem)%nat -> (s < sides (patch_at a))%nat -> (k < length rturnings)%nat ->
  0 < turning_det (fst (nth k rturnings no_turning)) /\ (exists x, (x < length rsamples)%nat /\ in_corner a s k x) /\
  forall x, (x < length rsamples)%nat -> in_corner a s k x \/ out_of_corner a s k x.
Proof.
  intros R1. destruct (corners_checked R1) as [NE [PT CC]]. split; [intros E; apply NE; unfold rsamples in E; apply map_eq_nil in E; exact E|]. intros a s k Ha Hs Hk. rewrite sides_length in Hs.
  destruct (turning_at k Hk) as [t [Ht Ek]]. specialize (CC a s Ha Hs). unfold check_corner in CC. cbv zeta in CC. apply andb_true_iff in CC as [CC _]. rewrite forallb_forall in CC. specialize (CC t Ht). apply andb_true_iff in CC as [C1 C2]. rewrite forallb_forall in C2.
  split; [|split].
  - rewrite Ek. pose proof (PT t Ht) as P. pose proof (turning_positive t R1 Ht) as W. unfold positive_turning in P. destruct t as [[w [[[x y] z] e]] f]. cbn [fst] in P, W. apply alt_ok in P. rewrite phi_zero, phi_sub, !phi_mul in P.
    unfold turning_det, rturning, rmatrix; cbn [fst snd]. replace (phi x / phi w * (phi e / phi w) - phi y / phi w * (phi z / phi w)) with ((phi x * phi e - phi y * phi z) / (phi w * phi w)) by (field; lra).
    apply Rdiv_lt_0_compat; auto. apply Rmult_lt_0_compat; auto.
  - apply existsb_exists in C1 as [d [Hd C1]]. apply (In_nth _ _ d) in Hd as [x [Hx Ed]]. exists x. unfold rsamples. rewrite map_length. split; auto.
    apply (proj1 (is_in_ok a s k x t d R1 Ha Ht Ek ltac:(unfold rsamples; rewrite (nth_indep _ _ ((fun d => (phi (fst d), phi (snd d))) d)) by (rewrite map_length; exact Hx); rewrite (map_nth (fun d => (phi (fst d), phi (snd d)))), Ed; reflexivity))), C1.
  - intros x Hx. destruct (sample_at x Hx) as [d [Hd Ed]]. specialize (C2 d Hd). destruct (is_in_ok a s k x t d R1 Ha Ht Ek Ed) as [I O]. apply orb_true_iff in C2 as [C2|C2]; auto.
Qed.
Lemma filter_nth {X} (f : X -> bool) l d : length (filter (fun x => f (nth x l d)) (seq 0 (length l))) = length (filter f l).
Proof.
  induction l as [|y l IH]; [reflexivity|]. cbn [length seq filter nth]. rewrite <- seq_shift, filter_map. cbn [nth]. destruct (f y); cbn [length]; rewrite map_length, IH; reflexivity.
Qed.
Theorem shares_ok : r = 1%nat -> forall a s k c1 c2, (a < length rsystem)%nat -> (s < sides (patch_at a))%nat -> (k < length rturnings)%nat -> around_tile a c1 c2 <> [] ->
  on_side a s c1 -> on_side a s c2 -> on_side a (prev (sides (patch_at a)) s) c1 -> on_side a (prev (sides (patch_at a)) s) c2 ->
  (length (around_tile a c1 c2) * length rsamples = 12 * length (filter (in_cornerb r rsystem rturnings rsamples a s k) (seq 0 (length rsamples))))%nat.
Proof.
  intros R1 a s k c1 c2 Ha Hs Hk NE O1 O2 O3 O4. rewrite sides_length in Hs, O3, O4. destruct (corners_checked R1) as [_ [_ CC]]. destruct (turning_at k Hk) as [t [Ht Ek]].
  specialize (CC a s Ha Hs). unfold check_corner in CC. cbv zeta in CC. apply andb_true_iff in CC as [C1 C2]. rewrite forallb_forall in C1, C2. specialize (C1 t Ht). apply andb_true_iff in C1 as [_ C1]. rewrite forallb_forall in C1.
  destruct (around_tile a c1 c2) as [|[o n] l] eqn:E; [congruence|]. assert (I : In (o, n) (around_tile a c1 c2)) by (rewrite E; cbn; auto). rewrite <- E. clear E NE l.
  apply select_In in I as [K [[x y] [Hp [E1 E2]]]]. cbn [fst snd] in E1, E2. pose proof (occupants_of_In (patch_at a) o) as OI. apply OI in K. pose proof K as K0. apply occupant_listed in K.
  apply ordered_In in Hp as [Hx [Hy N]]. pose proof (name_proper a o x Ha K0 Hx) as [Vx _]. pose proof (name_proper a o y Ha K0 Hy) as [Vy _].
  specialize (C2 o K). rewrite forallb_forall in C2. rewrite occupant_names_ok in Hx, Hy. specialize (C2 (x, y) ltac:(apply ordered_In; auto)). cbv beta iota in C2.
  assert (Fx : fst c1 = fst x) by (rewrite <- E1; reflexivity). assert (Fy : fst c2 = fst y) by (rewrite <- E2; reflexivity).
  assert (OB : forall s c z, (s < k_sides (k_patch a))%nat -> fst c = fst z -> (fst z < k_vertices a)%N -> on_side a s c -> on a s z = true).
  { intros s0 c z H0 F V O. apply on_back; auto. unfold MosaicAround.on_side in *. rewrite <- F. exact O. }
  rewrite (OB s c1 x), (OB s c2 y), (OB _ c1 x), (OB _ c2 y) in C2 by (auto using prev_lt). cbn [andb] in C2. rewrite forallb_forall in C2.
  specialize (C2 _ (in_map (fun t => (12 * length (filter (is_in a s t) samples))%nat) _ t Ht)). apply Nat.eqb_eq in C2. rewrite facets_ok in C2 by auto.
  rewrite <- E1, <- E2. rewrite around_tile_shift. unfold rsamples at 1. rewrite map_length, C2. f_equal.
  rewrite <- (filter_nth (is_in a s t) samples (zero, zero)). unfold rsamples at 2. rewrite map_length. f_equal. apply filter_ext_in. intros z Hz. apply in_seq in Hz.
  assert (Ez : nth z rsamples (0, 0) = (phi (fst (nth z samples (zero, zero))), phi (snd (nth z samples (zero, zero))))).
  { unfold rsamples. rewrite (nth_indep _ _ ((fun d => (phi (fst d), phi (snd d))) (zero, zero))) by (rewrite map_length; lia). apply (map_nth (fun d => (phi (fst d), phi (snd d)))). }
  destruct (is_in_ok a s k z t _ R1 Ha Ht Ek Ez) as [IN OUT]. unfold in_cornerb. destruct (dec _) as [D|D].
  - destruct (is_in a s t (nth z samples (zero, zero))) eqn:Q; auto. specialize (C1 (nth z samples (zero, zero)) ltac:(apply nth_In; lia)). rewrite Q in C1. cbn [orb] in C1. apply OUT in C1.
    unfold MosaicCorners.in_corner, MosaicCorners.out_of_corner in *. cbv zeta in *. lra.
  - destruct (is_in a s t (nth z samples (zero, zero))); auto. exfalso. auto.
Qed.

Variables (l1 l2 l3 : point).
Hypothesis basis : has_gram G l1 l2 l3.
Hypothesis right_handed : 0 < det l1 l2 l3.
Theorem tcp_all : over_all l1 l2 l3 G r rsystem tcp_cells.
Proof.
  intros tiles rise T H.
  apply (mosaic_tcp G r rsystem h system_good vertex k_vertices k_piece_name k_apex_name k_rim_name named_ok
    apexes_inside l1 l2 l3 basis right_handed tiles T rise H neighbour neighbour_ok rturnings rsamples
    (fun R1 => rotations_ok R1 (rot_ok R1)) sampled_ok shares_ok valences_ok axes_ok triangles_ok axial_ok).
Qed.
End Ring.
