(** * The theorem on regions of the plane

    1. Triangles: the sides of a triangle, and the facets over them of the three tetrahedra.
    2. The boundary facets of the region times [0, 1].
    3. The theorem, by RegionTheorem.v. *)
Require Import Reals Lra NArith Nnat ZArith List Lia Bool.
From Acutile Require Import Statement Tetrahedra Topology Degree Domain Bounds Euclid Transfer Checker Soundness PlaneStatement PlaneChecker PlaneSoundness
  RegionStatement PlaneRegionStatement RegionChecker RegionSoundness RegionTheorem PlaneRegionChecker.
Import ListNotations.
Open Scope R_scope.
Ltac unf2 := unfold combination2, add2, scale2, sub2 in *; cbn [x2 y2] in *.

(** ** 1. Over a triangle *)
Lemma down_up z X : down (up z X) = X.
Proof. destruct X; reflexivity. Qed.
(** The three tetrahedra over an even triangle; those over another one are turned. *)
Definition over (j : nat) (T : triangle2) : tetrahedron := match j with 0 => overA true T | 1 => overB true T | _ => overC true T end%nat.
Definition turned_facet (e : bool) (i : nat) : nat := if e then i else match i with 0 => 1 | 1 => 0 | _ => i end%nat.
Lemma turned_twice e i : turned_facet e (turned_facet e i) = i.
Proof. destruct e; auto. destruct i as [|[|i]]; reflexivity. Qed.
Lemma turned_I4 e i : In i I4 -> In (turned_facet e i) I4.
Proof. intros H. destruct e; auto. simpl in H. destruct H as [<-|[<-|[<-|[<-|[]]]]]; simpl; auto. Qed.
Lemma facet_turn e t i X : in_facet (turn e t) (turned_facet e i) X <-> in_facet t i X.
Proof.
  destruct e; cbn [turn turned_facet]; [tauto|].
  assert (C : forall t a b c d, combination (trev t) b a c d = combination t a b c d).
  { intros [p q r s] a b c d. unfold combination, trev; cbn [va vb vc vd]. apply point_eq; unf; ring. }
  split; intros [a [b [c [d [A [B [C' [D [S [E Z]]]]]]]]]]; exists b, a, c, d.
  - rewrite <- (C t b a c d). repeat split; auto; [lra|]. destruct i as [|[|[|i]]]; exact Z.
  - rewrite C. repeat split; auto; [lra|]. destruct i as [|[|[|i]]]; exact Z.
Qed.
Lemma facet_vertices_turn e t i v : In v (facet_vertices (turn e t) (turned_facet e i)) <-> In v (facet_vertices t i).
Proof. destruct e; cbn [turn turned_facet]; [tauto|]. destruct i as [|[|[|i]]]; cbn [facet_vertices trev va vb vc vd In]; tauto. Qed.
Lemma common_facet_turn e t i e' t' i' X : common_facet_hull (turn e t) (turned_facet e i) (turn e' t') (turned_facet e' i') X -> common_facet_hull t i t' i' X.
Proof.
  intros [a [b [c [d [A [B [C [D [S [E [Z [Qa [Qb [Qc Qd]]]]]]]]]]]]]]. rewrite facet_vertices_turn in Qa, Qb, Qc, Qd.
  destruct e; cbn [turn turned_facet trev va vb vc vd] in *.
  - exists a, b, c, d. repeat split; auto.
  - exists b, a, c, d. rewrite E. repeat split; auto; [lra|unfold combination, trev; cbn [va vb vc vd]; apply point_eq; unf; ring|].
    destruct i as [|[|[|i]]]; exact Z.
Qed.
(** The facets over side i, the first of them with the side as its lower edge. *)
Definition over_side (i : nat) : list (nat * nat) := match i with 0 => [(0, 0); (1, 0)] | 1 => [(0, 1); (2, 2)] | _ => [(1, 3); (2, 3)] end%nat.
Definition lowest (i : nat) : nat * nat := match i with 0 => (0, 0) | 1 => (0, 1) | _ => (1, 3) end%nat.
Ltac over_facets H := destruct H as [H|[H|[]]]; injection H as <- <-.
Ltac points := unfold combination, combination2; cbn [over overA overB overC turn va vb vc vd]; unfold up; apply point_eq; unf; unf2; lra || ring.
Lemma side_below i j f T Y : In (j, f) (over_side i) -> in_facet (over j T) f Y -> in_side T i (down Y).
Proof.
  intros H [a [b [c [d [A [B [C [D [S [-> Z]]]]]]]]]]. destruct T as [p q t].
  destruct i as [|[|i]]; over_facets H; cbv beta iota in Z; rewrite Z in *;
  [ exists 0, b, (c + d) | exists 0, (b + c), d | exists a, 0, (c + d) | exists (a + b), 0, d | exists a, (b + c), 0 | exists (a + b), c, 0 ];
  repeat split; try lra; unfold down, combination, combination2; cbn [over overA overB overC turn va vb vc vd ta tb tc]; unfold up; apply point2_eq; unf; unf2; ring.
Qed.
Lemma side_lowest i T X : (i < 3)%nat -> in_side T i X -> let (j, f) := lowest i in in_facet (over j T) f (up 0 X).
Proof.
  intros Hi [a [b [c [A [B [C [S [-> Z]]]]]]]]. destruct T as [p q t].
  destruct i as [|[|[|i]]]; try lia; cbn [lowest]; cbv beta iota in Z; rewrite Z in *;
  [ exists 0, b, c, 0 | exists a, 0, c, 0 | exists a, 0, b, 0 ]; repeat split; try lra; cbn [ta tb tc]; points.
Qed.
Lemma side_above i T X : (i < 3)%nat -> in_side T i X -> exists j f, In (j, f) (over_side i) /\ in_facet (over j T) f (up (1/2) X).
Proof.
  intros Hi [a [b [c [A [B [C [S [-> Z]]]]]]]]. destruct T as [p q t].
  destruct i as [|[|[|i]]]; try lia; cbv beta iota in Z; rewrite Z in *.
  - destruct (Rle_dec (1/2) c).
    + exists 0%nat, 0%nat. split; [simpl; auto|]. exists 0, b, (c - 1/2), (1/2). repeat split; try lra; cbn [ta tb tc]; points.
    + exists 1%nat, 0%nat. split; [simpl; auto|]. exists 0, (1/2 - c), (b - (1/2 - c)), c. repeat split; try lra; cbn [ta tb tc]; points.
  - destruct (Rle_dec (1/2) c).
    + exists 0%nat, 1%nat. split; [simpl; auto|]. exists a, 0, (c - 1/2), (1/2). repeat split; try lra; cbn [ta tb tc]; points.
    + exists 2%nat, 2%nat. split; [simpl; auto|]. exists (a - (1/2 - c)), (1/2 - c), 0, c. repeat split; try lra; cbn [ta tb tc]; points.
  - destruct (Rle_dec (1/2) b).
    + exists 1%nat, 3%nat. split; [simpl; auto|]. exists a, (1/2), (b - 1/2), 0. repeat split; try lra; cbn [ta tb tc]; points.
    + exists 2%nat, 3%nat. split; [simpl; auto|]. exists (a - (1/2 - b)), (1/2 - b), b, 0. repeat split; try lra; cbn [ta tb tc]; points.
Qed.
Lemma above T X z : hull2 T X -> 0 <= z <= 1 -> exists j, (j < 3)%nat /\ hull (over j T) (up z X).
Proof.
  intros [a [b [c [A [B [C [S ->]]]]]]] Hz. destruct T as [p q t].
  destruct (Rle_dec z c); [|destruct (Rle_dec z (b + c))].
  - exists 0%nat. split; [lia|]. exists a, b, (c - z), z. repeat split; try lra; cbn [ta tb tc]; points.
  - exists 1%nat. split; [lia|]. exists a, (z - c), (b - (z - c)), c. repeat split; try lra; cbn [ta tb tc]; points.
  - exists 2%nat. split; [lia|]. exists (a - (z - b - c)), (z - b - c), b, c. repeat split; try lra; cbn [ta tb tc]; points.
Qed.
(** The vertices of these facets and tetrahedra are over ends and corners. *)
Lemma facet_ends i j f T v : In (j, f) (over_side i) -> In v (facet_vertices (over j T) f) -> In (down v) (side_ends T i) /\ (pz v = 0 \/ pz v = 1).
Proof.
  intros H Hv. destruct T as [[p p'] [q q'] [t t']].
  destruct i as [|[|i]]; over_facets H; cbn [over overA overB overC turn facet_vertices va vb vc vd ta tb tc In] in Hv;
  destruct Hv as [<-|[<-|[<-|[]]]]; cbn [side_ends ta tb tc In pz up down px py x2 y2]; auto 6.
Qed.
Lemma over_corners j T v : (j < 3)%nat -> In v (verts (over j T)) -> In (down v) (corners T) /\ (pz v = 0 \/ pz v = 1).
Proof.
  intros Hj Hv. destruct T as [[p p'] [q q'] [t t']]. destruct j as [|[|[|j]]]; try lia;
  cbn [over overA overB overC turn verts va vb vc vd ta tb tc In] in Hv; destruct Hv as [<-|[<-|[<-|[<-|[]]]]]; cbn [corners ta tb tc In pz up down px py x2 y2]; auto 6.
Qed.
Lemma corner_over j T v : (j < 3)%nat -> In v (corners T) -> exists z, (z = 0 \/ z = 1) /\ In (up z v) (verts (over j T)).
Proof.
  intros Hj Hv. destruct T as [p q t]. cbn [corners ta tb tc In] in Hv.
  destruct j as [|[|[|j]]]; try lia; destruct Hv as [<-|[<-|[<-|[]]]];
  ((exists 0; split; [auto|]; cbn [over overA overB overC turn verts va vb vc vd ta tb tc In]; solve [auto 6]) ||
   (exists 1; split; [auto|]; cbn [over overA overB overC turn verts va vb vc vd ta tb tc In]; solve [auto 6])).
Qed.
(** Each has a vertical edge: so the centre of its ball is halfway up, over that of the circle. *)
Lemma ball_over j T C s : (j < 3)%nat -> area T <> 0 -> circumscribed (over j T) C s ->
  circumscribed2 T (down C) (s - 1/4) /\ forall z v, z = 0 \/ z = 1 -> distance_squared (up z v) C = distance_squared2 v (down C) + 1/4.
Proof.
  intros Hj AR H. assert (K : pz C = 1/2).
  { assert (V : exists v, In (up 0 v) (verts (over j T)) /\ In (up 1 v) (verts (over j T))).
    { destruct j as [|[|[|j]]]; try lia; [exists (tc T)|exists (tb T)|exists (ta T)]; cbn [over overA overB overC turn verts va vb vc vd In]; auto 6. }
    destruct V as [v [V0 V1]]. apply H in V0, V1. rewrite distance_down in V0, V1. lra. }
  assert (D : forall z v, z = 0 \/ z = 1 -> distance_squared (up z v) C = distance_squared2 v (down C) + 1/4).
  { intros z v Z. rewrite distance_down, K. destruct Z as [-> | ->]; lra. }
  split; auto. intros v Hv. destruct (corner_over j T v Hj Hv) as [z [Z I]]. apply H in I. rewrite D in I by auto. lra.
Qed.

(** ** 2. The boundary facets of the region times [0, 1] *)
Lemma open_sides_In ts k t i : In (k, t, i) (open_sides ts) <-> nth_error ts (N.to_nat k) = Some t /\ In i I3 /\ nt t i = None.
Proof.
  unfold open_sides. rewrite (collect_In _ (fun k t y => exists i, y = (k, t, i) /\ In i I3 /\ nt t i = None)).
  - split.
    + intros [[j [x [E [i' [X Y]]]]]|[]]. injection X as -> -> ->. rewrite ?N.add_0_l, Nnat.Nat2N.id. auto.
    + intros [E X]. left. exists (N.to_nat k), t. split; auto. exists i. rewrite N.add_0_l, N2Nat.id. auto.
  - intros k' t' l y. unfold I3. generalize [0; 1; 2]%nat as is. induction is as [|i' is IH]; cbn [fold_right].
    + split; auto. intros [[? [_ [[] _]]]|]; auto.
    + unfold free. destruct (nt t' i') as [m|] eqn:E; [|cbn [In]]; rewrite IH; split.
      * intros [[i0 [H1 [H2 H3]]]|H]; auto. left. exists i0. simpl. auto.
      * intros [[i0 [H1 [[<-|H2] H3]]]|H]; auto; [congruence|]. left. exists i0. auto.
      * intros [<-|[[i0 [H1 [H2 H3]]]|H]]; auto; left; [exists i'|exists i0]; simpl; auto.
      * intros [[i0 [H1 [[<-|H2] H3]]]|H]; auto. right; left. exists i0. auto.
Qed.
Lemma zero_lattice2 r : in_lattice2 r (0, 0)%Z.
Proof. destruct r as [|[|]]; cbn; auto. Qed.
Definition tet_over (j : nat) V ts (k : N) (t : ctri) : ctet := match j with 0 => tetA V ts k t | 1 => tetB V ts k t | _ => tetC V ts k t end%nat.
Lemma lifted_none ts f m : lifted_mate ts f m = None <-> m = None.
Proof. destruct m as [[[t j] u]|]; cbn; split; congruence. Qed.
Lemma turned_mate e t f : mt (turned e t) (turned_facet e f) = mt t f.
Proof. destruct e; auto. destruct f as [|[|f]]; reflexivity. Qed.
(** Which facets have no mate: the lowest, the highest, and those over sides without one. *)
Lemma free_facets j V ts k t f : (j < 3)%nat -> In f I4 -> mt (tet_over j V ts k t) (turned_facet (even t) f) = None ->
  (j, f) = (0, 3)%nat \/ (j, f) = (2, 0)%nat \/ exists i, In i I3 /\ In (j, f) (over_side i) /\ nt t i = None.
Proof.
  intros Hj Hf H. destruct j as [|[|[|j]]]; try lia; cbn [tet_over] in H; [unfold tetA in H|unfold tetB in H|unfold tetC in H];
  rewrite turned_mate in H; simpl in Hf; destruct Hf as [<-|[<-|[<-|[<-|[]]]]]; cbn [mt m0 m1 m2 m3] in H; try discriminate; auto;
  apply lifted_none in H; right; right;
  first [exists 0%nat; split; [simpl; auto|]; split; [solve [simpl; auto]|exact H] | exists 1%nat; split; [simpl; auto|]; split; [solve [simpl; auto]|exact H]
        | exists 2%nat; split; [simpl; auto|]; split; [solve [simpl; auto]|exact H]].
Qed.
Lemma sides_free i j f V ts k t : In (j, f) (over_side i) -> nt t i = None -> mt (tet_over j V ts k t) (turned_facet (even t) f) = None.
Proof.
  intros H Z. destruct i as [|[|i]]; over_facets H; cbn [tet_over nt] in *; unfold tetA, tetB, tetC; rewrite turned_mate; cbn [mt m0 m1 m2 m3]; apply lifted_none, Z.
Qed.

Section Ring.
Variables (A : Type) (aadd asub amul : A -> A -> A) (aofZ : Z -> A) (alt ale : A -> A -> bool).
Variable part : Z -> A -> Z.
Variable phi : A -> R.
Hypothesis phi_add : forall x y, phi (aadd x y) = (phi x + phi y)%R.
Hypothesis phi_sub : forall x y, phi (asub x y) = (phi x - phi y)%R.
Hypothesis phi_mul : forall x y, phi (amul x y) = (phi x * phi y)%R.
Hypothesis phi_Z : forall z, phi (aofZ z) = IZR z.
Hypothesis alt_ok : forall x y, alt x y = true -> (phi x < phi y)%R.
Hypothesis ale_ok : forall x y, ale x y = true -> (phi x <= phi y)%R.
Notation check_region2 := (check_region2 A aadd asub amul aofZ alt ale part).

Section Sound.
Variable c : cert2 A.
Let c3 := PlaneChecker.lift A aadd asub amul aofZ ale c.
Let N := length (e_tris A c).
Let r := e_rank A c.
Hypothesis CHK : check_region2 c = true.
Lemma parts2 : ((r <= 2)%nat /\ (forall t, In t (e_tris A c) -> in_range A c t = true)) /\ open_sides (e_tris A c) <> [] /\
  check_region A aadd asub amul aofZ alt ale part c3 = true.
Proof.
  pose proof CHK as H. unfold PlaneRegionChecker.check_region2 in H. rewrite !andb_true_iff, forallb_forall, Nat.leb_le in H.
  destruct H as [[[H1 H2] H3] H4]. split; auto. split; auto. intros E. rewrite E in H3. discriminate.
Qed.
Lemma some_side : exists k t i, In (k, t, i) (open_sides (e_tris A c)).
Proof.
  destruct parts2 as [_ [NE _]]. destruct (open_sides (e_tris A c)) as [|[[k t] i] l] eqn:E; [congruence|]. exists k, t, i. left; auto.
Qed.
Let small := proj1 (proj1 parts2).
Let range := proj2 (proj1 parts2).
Let chk3 := proj2 (proj2 parts2).
Let base3 := RegionTheorem.base A aadd asub amul aofZ alt ale part c3 chk3.

Section Basis.
Variables l1 l2 : point2.
Hypothesis HG : has_gram2 (dgram2 A phi c) l1 l2.
Let L1 := up 0 l1.
Let L2 := up 0 l2.
Let L3 := Point 0 0 1.
Let HG3 : has_gram (dgram A phi c3) L1 L2 L3 := lift_gram A aadd asub amul aofZ ale phi phi_Z c l1 l2 HG.
Notation T3 := (dtet A aofZ phi c3 L1 L2 L3).
Notation T2 := (dtriangle A aofZ phi c l1 l2).
Notation tile3 := (tile L1 L2 L3 T3).
Notation tile2 := (tile2 l1 l2 T2).
Notation is_tile2 := (is_tile2 r N).
Notation is_tile3 := (is_tile (c_rank A c3) (length (c_tets A c3))).
Let R3 : face_to_face_region L1 L2 L3 (c_rank A c3) (length (c_tets A c3)) T3 (listed_facets A c3) :=
  region_sound A aadd asub amul aofZ alt ale part phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok c3 chk3 L1 L2 L3 HG3.
Notation boundary3 := (is_boundary_facet (c_rank A c3) (length (c_tets A c3)) (listed_facets A c3)).
Notation boundary2 := (is_boundary_side r N (listed_sides A c)).

Lemma triangle_at k : (k < N)%nat -> exists t, nth_error (e_tris A c) k = Some t /\ even_at A c k = even t.
Proof.
  intros Hk. destruct (nth_error (e_tris A c) k) as [t|] eqn:E; [|apply nth_error_None in E; unfold N in Hk; lia]. exists t. split; auto. unfold even_at. rewrite E. reflexivity.
Qed.
(** The tetrahedra over a tile. *)
Lemma tet_at j k t : (j < 3)%nat -> nth_error (e_tris A c) k = Some t -> nth_error (c_tets A c3) (3 * k + j) = Some (tet_over j (V2 A c) (e_tris A c) (N.of_nat k) t).
Proof.
  intros Hj E. destruct (prisms_nth A c small (V2 A c) (e_tris A c) (e_tris A c) 0 k t E) as [E1 [E2 E3]].
  unfold c3. rewrite (lift_tets A aadd asub amul aofZ ale c). rewrite N.add_0_l in *.
  destruct j as [|[|[|j]]]; try lia; rewrite ?Nat.add_0_r; assumption.
Qed.
Lemma tile_at j k n : (j < 3)%nat -> is_tile2 (k, n) -> is_tile3 ((3 * k + j)%nat, up3 n) /\ tile3 ((3 * k + j)%nat, up3 n) = turn (even_at A c k) (over j (tile2 (k, n))).
Proof.
  intros Hj H. pose proof (over_tile_even A aadd asub amul aofZ alt ale phi phi_Z c small range base3 l1 l2 k n H) as O. cbv zeta in O.
  destruct O as [[A1 A2] [[B1 B2] [C1 C2]]].
  destruct j as [|[|[|j]]]; try lia; rewrite ?Nat.add_0_r; split; auto.
Qed.
Lemma under m n3 : is_tile3 (m, n3) -> exists k n j, is_tile2 (k, n) /\ (j < 3)%nat /\ m = (3 * k + j)%nat /\ n3 = up3 n.
Proof.
  intros [Hm Hn]. cbn [fst snd] in *. unfold c3 in Hm, Hn. rewrite (length3 A aadd asub amul aofZ ale c small) in Hm. rewrite (lift_rank A aadd asub amul aofZ ale c) in Hn.
  destruct (lattice3 A c small n3 Hn) as [E Hn2].
  exists (m / 3)%nat, (lat2 n3), (m mod 3)%nat. pose proof (Nat.div_mod m 3 ltac:(lia)). pose proof (Nat.mod_upper_bound m 3 ltac:(lia)).
  split; [split; auto; apply Nat.div_lt_upper_bound; lia|]. split; [lia|]. split; [lia|exact E].
Qed.
Lemma listed_iff3 m g : In (m, g) (listed_facets A c3) <-> exists t, nth_error (c_tets A c3) m = Some t /\ In g I4 /\ mt t g = None.
Proof.
  unfold listed_facets. rewrite in_map_iff. split.
  - intros [[[k t] i] [E H]]. injection E as <- <-. apply open_facets_In in H. eauto.
  - intros [t H]. exists (N.of_nat m, t, g). rewrite Nnat.Nat2N.id. split; auto. apply open_facets_In. rewrite Nnat.Nat2N.id. exact H.
Qed.
Lemma listed_iff2 k i : In (k, i) (listed_sides A c) <-> exists t, nth_error (e_tris A c) k = Some t /\ In i I3 /\ nt t i = None.
Proof.
  unfold listed_sides. rewrite in_map_iff. split.
  - intros [[[k' t] i'] [E H]]. injection E as <- <-. apply open_sides_In in H. eauto.
  - intros [t H]. exists (N.of_nat k, t, i). rewrite Nnat.Nat2N.id. split; auto. apply open_sides_In. rewrite Nnat.Nat2N.id. exact H.
Qed.
(** From a boundary side to the boundary facets over it, and back from points that are halfway up. *)
Lemma facet_over k n i j f : boundary2 ((k, n), i) -> In (j, f) (over_side i) ->
  boundary3 ((((3 * k + j)%nat, up3 n)), turned_facet (even_at A c k) f) /\ (j < 3)%nat /\
  tile3 ((3 * k + j)%nat, up3 n) = turn (even_at A c k) (over j (tile2 (k, n))).
Proof.
  intros [H L] O. cbn [fst snd] in *. assert (JF : (j < 3)%nat /\ In f I4) by (destruct i as [|[|i]]; over_facets O; split; simpl; auto).
  destruct JF as [Hj Hf]. destruct (tile_at j k n Hj H) as [V E]. split; [|auto]. split; auto. cbn [fst snd].
  apply listed_iff2 in L as [t [Et [_ Z]]]. apply listed_iff3. exists (tet_over j (V2 A c) (e_tris A c) (N.of_nat k) t).
  split; [apply tet_at; auto|]. split; [apply turned_I4, Hf|]. unfold even_at. rewrite Et. apply (sides_free i); auto.
Qed.
Lemma side_under f X : boundary3 f -> in_boundary_facet L1 L2 L3 T3 f (up (1/2) X) -> exists g, boundary2 g /\ in_boundary_side l1 l2 T2 g X.
Proof.
  destruct f as [[m n3] g]. intros [V L] I. cbn [fst snd] in *. destruct (under m n3 V) as [k [n [j [H [Hj [-> ->]]]]]].
  destruct (triangle_at k (proj1 H)) as [t [Et Ee]]. apply listed_iff3 in L as [t3 [E3 [Hg M]]]. rewrite (tet_at j k t Hj Et) in E3. injection E3 as <-.
  destruct (tile_at j k n Hj H) as [_ E]. unfold in_boundary_facet in I; cbn [fst snd] in I. rewrite E, Ee in I.
  rewrite <- (turned_twice (even t) g) in I, M. set (f := turned_facet (even t) g) in *. apply (proj1 (facet_turn _ _ _ _)) in I.
  assert (Hf : In f I4) by (apply turned_I4, Hg).
  destruct (free_facets j _ _ _ _ f Hj Hf M) as [Q|[Q|[i [Hi [O Z]]]]].
  - exfalso. injection Q as -> ->. destruct I as [a [b [c0 [d [_ [_ [_ [_ [_ [Ex Z]]]]]]]]]]. cbv beta iota in Z.
    apply (f_equal pz) in Ex. unfold combination in Ex. cbn [over overA turn va vb vc vd] in Ex. unfold up in Ex. unf. lra.
  - exfalso. injection Q as -> ->. destruct I as [a [b [c0 [d [_ [_ [_ [_ [S [Ex Z]]]]]]]]]]. cbv beta iota in Z.
    apply (f_equal pz) in Ex. unfold combination in Ex. cbn [over overC turn va vb vc vd] in Ex. unfold up in Ex. unf. lra.
  - exists ((k, n), i). split.
    + split; auto. cbn [fst snd]. apply listed_iff2. eauto.
    + unfold in_boundary_side; cbn [fst snd]. apply (side_below i j f _ _ O) in I. rewrite down_up in I. exact I.
Qed.
(** The region of space and that of the plane. *)
Lemma region_up X z : 0 <= z <= 1 -> (in_region L1 L2 L3 (c_rank A c3) (length (c_tets A c3)) T3 (up z X) <-> in_region2 l1 l2 r N T2 X).
Proof.
  intros Hz. split.
  - intros [[m n3] [V I]]. destruct (tile_below A aadd asub amul aofZ alt ale phi phi_Z c small range base3 l1 l2 m n3 V) as [k [n [H [_ [_ D]]]]].
    exists (k, n). split; auto. specialize (D _ I). rewrite down_up in D. exact D.
  - intros [[k n] [H I]]. destruct (above _ X z I Hz) as [j [Hj HJ]]. destruct (tile_at j k n Hj H) as [V E].
    exists ((3 * k + j)%nat, up3 n). split; auto. rewrite E. apply hull_turn, HJ.
Qed.
Lemma close_up (S3 : point -> Prop) (S2 : point2 -> Prop) X : (forall z Y, 0 <= z <= 1 -> (S3 (up z Y) <-> S2 Y)) ->
  ((forall e, 0 < e -> exists Y, near e (up (1/2) X) Y /\ S3 Y) <-> (forall e, 0 < e -> exists Y, near2 e X Y /\ S2 Y)).
Proof.
  intros H. split; intros C e He.
  - destruct (C (Rmin e (1/2))) as [Y [[N1 [N2 N3]] SY]]; [apply Rmin_glb_lt; lra|]. pose proof (Rmin_l e (1/2)). pose proof (Rmin_r e (1/2)).
    exists (down Y). unfold up in N1, N2, N3; cbn [px py pz] in N1, N2, N3. split; [split; cbn [down x2 y2]; lra|].
    replace Y with (up (pz Y) (down Y)) in SY by (destruct Y; reflexivity). apply H in SY; auto.
    assert (Rabs (pz Y - 1/2) < 1/2) as NZ by lra. apply Rabs_def2 in NZ. lra.
  - destruct (C e He) as [Y [[N1 N2] SY]]. exists (up (1/2) Y). split; [|apply H; auto; lra].
    unfold up. repeat split; cbn [px py pz]; auto. replace (1/2 - 1/2) with 0 by lra. rewrite Rabs_R0. exact He.
Qed.

(** ** 3. The theorem *)
Theorem region_sound2 : edge_to_edge_region l1 l2 r N T2 (listed_sides A c).
Proof.
  constructor.
  - apply (basis_plane A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok c base3 l1 l2 HG).
  - apply (area_tile A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok c small range base3 l1 l2 HG).
  - apply (finite_plane A aadd asub amul aofZ alt ale phi phi_Z c small range base3 l1 l2 (region_locally_finite _ _ _ _ _ _ _ R3)).
  - apply (disjoint_plane A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok c small range base3 l1 l2 HG (region_interiors _ _ _ _ _ _ _ R3) (region_faces _ _ _ _ _ _ _ R3)).
  - apply (edges_plane A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok c small range base3 l1 l2 HG (region_faces _ _ _ _ _ _ _ R3)).
  - destruct some_side as [k [t [i H]]]. apply open_sides_In in H.
    exists ((N.to_nat k, (0, 0)%Z), i). split; cbn [fst snd].
    + split; cbn [fst snd]; [apply nth_error_Some; destruct H as [H _]; rewrite H; discriminate|apply zero_lattice2].
    + apply listed_iff2. eauto.
  - intros k i H. apply listed_iff2 in H as [t [E [Hi _]]]. split; [apply nth_error_Some; congruence|]. simpl in Hi. lia.
  - intros X. unfold topological_boundary2. pose proof (region_is_bounded_by _ _ _ _ _ _ _ R3 (up (1/2) X)) as B. unfold topological_boundary in B.
    rewrite (close_up _ (in_region2 l1 l2 r N T2) X) in B by (intros z Y Hz; apply region_up; auto).
    rewrite (close_up _ (fun Y => ~ in_region2 l1 l2 r N T2 Y) X) in B by (intros z Y Hz; rewrite region_up by auto; tauto).
    rewrite B. split.
    + intros [f [Bf Of]]. apply (side_under f X); auto.
    + intros [[[k n] i] [Bg Og]]. unfold in_boundary_side in Og; cbn [fst snd] in Og.
      assert (Hi : (i < 3)%nat). { destruct Bg as [_ L]. apply listed_iff2 in L as [_ [_ [Hi _]]]. cbn [snd] in Hi. simpl in Hi. lia. }
      destruct (side_above i _ X Hi Og) as [j [f [O F]]]. destruct (facet_over k n i j f Bg O) as [B3 [_ E]].
      eexists. split; [exact B3|]. unfold in_boundary_facet; cbn [fst snd]. rewrite E. apply facet_turn, F.
  - intros X [[k n] i] [[k' n'] i'] Bf Bg Of Og. unfold in_boundary_side in Of, Og; cbn [fst snd] in *.
    assert (LT : forall k n i, boundary2 ((k, n), i) -> (i < 3)%nat).
    { intros k0 n0 i0 [_ L]. apply listed_iff2 in L as [_ [_ [Hi _]]]. cbn [snd] in Hi. simpl in Hi. lia. }
    pose proof (side_lowest i _ X (LT _ _ _ Bf) Of) as F. pose proof (side_lowest i' _ X (LT _ _ _ Bg) Og) as G.
    destruct (lowest i) as [j f] eqn:El, (lowest i') as [j' f'] eqn:El'.
    assert (O : In (j, f) (over_side i)) by (rewrite <- El; destruct i as [|[|?]]; simpl; auto).
    assert (O' : In (j', f') (over_side i')) by (rewrite <- El'; destruct i' as [|[|?]]; simpl; auto).
    destruct (facet_over k n i j f Bf O) as [B3 [_ E]]. destruct (facet_over k' n' i' j' f' Bg O') as [B3' [_ E']].
    pose proof (region_boundary_faces _ _ _ _ _ _ _ R3 (up 0 X) _ _ B3 B3') as CH. unfold in_boundary_facet in CH; cbn [fst snd] in CH. rewrite E, E' in CH.
    specialize (CH (proj2 (facet_turn _ _ _ _) F) (proj2 (facet_turn _ _ _ _) G)). apply common_facet_turn in CH.
    set (T := tile2 (k, n)) in *. set (T' := tile2 (k', n')) in *.
    assert (EN : forall v, In (up 0 v) (facet_vertices (over j' T') f') -> In v (side_ends T' i')).
    { intros v Hv. apply (facet_ends i') in Hv as [Hv _]; auto. rewrite down_up in Hv. exact Hv. }
    destruct CH as [a [b [c0 [d [Pa [Pb [Pc [Pd [S [Ex [Z [Qa [Qb [Qc Qd]]]]]]]]]]]]]].
    pose proof (LT _ _ _ Bf) as Hi. clearbody T T'. clear - El Hi EN Pa Pb Pc Pd S Ex Z Qa Qb Qc Qd.
    destruct i as [|[|[|i]]]; try lia; cbn [lowest] in El; injection El as <- <-; cbv beta iota in Z; subst;
      cbn [over overA overB turn va vb vc vd] in *; pose proof (f_equal pz Ex) as Ez; pose proof (f_equal px Ex) as E1; pose proof (f_equal py Ex) as E2;
      unfold combination, up in Ez, E1, E2; cbn [over overA overB turn va vb vc vd] in Ez, E1, E2; unf.
    + assert (d = 0) by lra. subst d. exists 0, b, c0. repeat split; auto; try lra; [destruct T as [p q t]; apply point2_eq; unf2; cbn [ta tb tc] in *; lra|..]; intros; try lra; apply EN; auto.
    + assert (d = 0) by lra. subst d. exists a, 0, c0. repeat split; auto; try lra; [destruct T as [p q t]; apply point2_eq; unf2; cbn [ta tb tc] in *; lra|..]; intros; try lra; apply EN; auto.
    + assert (b = 0) by lra. subst b. exists a, c0, 0. repeat split; auto; try lra; [destruct T as [p q t]; apply point2_eq; unf2; cbn [ta tb tc] in *; lra|..]; intros; try lra; apply EN; auto.
Qed.

(** *** Tiles with a common side *)
Notation chk_power := (chk_power A aadd asub amul aofZ).
Definition side_checked (less : A -> A -> bool) := forall k t i, nth_error (e_tris A c) k = Some t -> (i < 3)%nat ->
  let (j, f) := lowest i in let t3 := tet_over j (V2 A c) (e_tris A c) (N.of_nat k) t in
  chk_power less (c_gram A c3) (c_den A c3) (positions A aadd aofZ c3) t3 (kpos A aadd aofZ (c_den A c3) (c_verts A c3) t3) (turned_facet (even t) f) = true.
Lemma weakly_checked : chk_delaunay A aadd asub amul aofZ ale c3 = true -> side_checked ale.
Proof.
  intros H k t i E Hi. destruct (lowest i) as [j f] eqn:El. cbv zeta.
  assert (JF : (j < 3)%nat /\ In f I4) by (destruct i as [|[|i]]; injection El as <- <-; split; simpl; auto). destruct JF as [Hj Hf].
  unfold Checker.chk_delaunay in H. rewrite forallb_forall in H. specialize (H _ (nth_error_In _ _ (tet_at j k t Hj E))).
  rewrite forallb_forall in H. apply H, turned_I4, Hf.
Qed.
Lemma strictly_checked : chk_edges A aadd asub amul aofZ alt c3 (positions A aadd aofZ c3) (c_tets A c3) = true -> side_checked alt.
Proof.
  intros H k t i E Hi. unfold c3 in H at 3. rewrite (lift_tets A aadd asub amul aofZ ale c) in H.
  destruct (edges_nth A aadd asub amul aofZ alt c small c3 _ _ _ _ _ k t H E) as [W0 [W1 W3]]. rewrite N.add_0_l in W0, W1, W3.
  destruct i as [|[|[|i]]]; try lia; cbn [lowest tet_over]; cbv zeta; destruct (even t); cbn [turned_facet]; assumption.
Qed.
Lemma side_of T u v : u <> v -> In u (corners T) -> In v (corners T) -> exists i, (i < 3)%nat /\ forall x, In x (side_ends T i) -> x = u \/ x = v.
Proof.
  intros Ne U W. destruct T as [p q t]. cbn [corners ta tb tc In] in U, W.
  destruct U as [<-|[<-|[<-|[]]]], W as [<-|[<-|[<-|[]]]]; try congruence;
  first [exists 0%nat; split; [lia|]; cbn [side_ends ta tb tc In]; solve [intuition] | exists 1%nat; split; [lia|]; cbn [side_ends ta tb tc In]; solve [intuition]
        | exists 2%nat; split; [lia|]; cbn [side_ends ta tb tc In]; solve [intuition]].
Qed.
(** The middle of the facet over the side is in a tetrahedron over the neighbour, which has its vertices. *)
Lemma facet_shared k n k' n' i : is_tile2 (k, n) -> is_tile2 (k', n') -> (i < 3)%nat ->
  (forall x, In x (side_ends (tile2 (k, n)) i) -> In x (corners (tile2 (k', n')))) ->
  let (j, f) := lowest i in exists j', (j' < 3)%nat /\ forall v, In v (facet_vertices (over j (tile2 (k, n))) f) -> In v (verts (over j' (tile2 (k', n')))).
Proof.
  intros H H' Hi EN. destruct (lowest i) as [j f] eqn:El. pose proof (vol_tile3 A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok c base3 l1 l2 HG) as VT.
  assert (Hj : (j < 3)%nat) by (destruct i as [|[|i]]; injection El as <- <-; auto).
  destruct (tile_at j k n Hj H) as [V E]. specialize (VT _ V). fold c3 L1 L2 L3 in VT. rewrite E in VT. apply vol_turn in VT.
  set (T := tile2 (k, n)) in *. set (T' := tile2 (k', n')) in *.
  set (w := fun m => if Nat.eqb m f then 0 else 1/3).
  set (M := combination (over j T) (w 0%nat) (w 1%nat) (w 2%nat) (w 3%nat)).
  assert (W : (w 0%nat + w 1%nat + w 2%nat + w 3%nat = 1) /\ forall m, 0 <= w m).
  { split; [unfold w; destruct i as [|[|i]]; injection El as <- <-; cbn [Nat.eqb]; lra|]. intros m. unfold w. destruct (Nat.eqb m f); lra. }
  destruct W as [W W0].
  assert (HM : hull (over j T) M) by (exists (w 0%nat), (w 1%nat), (w 2%nat), (w 3%nat); auto 8).
  assert (HM' : hull2 T' (down M) /\ 0 <= pz M <= 1).
  { assert (CV : forall x y s, 0 <= s <= 1 -> In x (corners T') -> In y (corners T') -> hull2 T' (add2 (scale2 (1 - s) x) (scale2 s y))).
    { clear. intros x y s Hs X Y. destruct T' as [p q t]. cbn [corners ta tb tc In] in X, Y.
      destruct X as [<-|[<-|[<-|[]]]], Y as [<-|[<-|[<-|[]]]];
      [ exists 1, 0, 0 | exists (1 - s), s, 0 | exists (1 - s), 0, s | exists s, (1 - s), 0 | exists 0, 1, 0 | exists 0, (1 - s), s
      | exists s, 0, (1 - s) | exists 0, s, (1 - s) | exists 0, 0, 1 ]; repeat split; try lra; apply point2_eq; unfold combination2; cbn [ta tb tc]; unf2; ring. }
    unfold M, w. destruct i as [|[|[|i]]]; try lia; injection El as <- <-; cbn [Nat.eqb]; unfold combination; cbn [over overA overB turn va vb vc vd]; split;
      try (unfold up; unf; lra).
    - replace (down _) with (add2 (scale2 (1 - 2/3) (tb T)) (scale2 (2/3) (tc T))); [apply CV; [lra| |]; apply EN; cbn [side_ends In]; auto|].
      unfold down, up. apply point2_eq; unf; unf2; field.
    - replace (down _) with (add2 (scale2 (1 - 2/3) (ta T)) (scale2 (2/3) (tc T))); [apply CV; [lra| |]; apply EN; cbn [side_ends In]; auto|].
      unfold down, up. apply point2_eq; unf; unf2; field.
    - replace (down _) with (add2 (scale2 (1 - 2/3) (ta T)) (scale2 (2/3) (tb T))); [apply CV; [lra| |]; apply EN; cbn [side_ends In]; auto|].
      unfold down, up. apply point2_eq; unf; unf2; field. }
  destruct HM' as [HM' Hz]. destruct (above T' (down M) (pz M) HM' Hz) as [j' [Hj' HJ]].
  replace (up (pz M) (down M)) with M in HJ by (destruct M; reflexivity).
  exists j'. split; auto. destruct (tile_at j' k' n' Hj' H') as [V' E'].
  pose proof (region_faces _ _ _ _ _ _ _ R3 M _ _ V V') as FF. rewrite E, E' in FF. specialize (FF (proj2 (hull_turn _ _ _) HM) (proj2 (hull_turn _ _ _) HJ)).
  apply common_turn in FF. destruct FF as [a [b [c0 [d [_ [_ [_ [_ [S [EM [Qa [Qb [Qc Qd]]]]]]]]]]]]].
  destruct (L_comb4 (over j T) a b c0 d S) as [Ka [Kb [Kc Kd]]]. destruct (L_comb4 (over j T) _ _ _ _ W) as [Ja [Jb [Jc Jd]]].
  fold M in Ja, Jb, Jc, Jd. rewrite <- EM in Ka, Kb, Kc, Kd. rewrite Ja in Ka. rewrite Jb in Kb. rewrite Jc in Kc. rewrite Jd in Kd.
  apply Rmult_eq_reg_r in Ka, Kb, Kc, Kd; auto. clear Ja Jb Jc Jd EM. rewrite verts_turn in Qa, Qb, Qc, Qd. rewrite <- Ka in Qa. rewrite <- Kb in Qb. rewrite <- Kc in Qc. rewrite <- Kd in Qd.
  assert (P : forall m, m <> f -> 0 < w m) by (intros m Hm; unfold w; apply Nat.eqb_neq in Hm; rewrite Hm; lra).
  intros v Hv. destruct i as [|[|[|i]]]; try lia; injection El as <- <-; cbn [facet_vertices In] in Hv; destruct Hv as [<-|[<-|[<-|[]]]];
  first [apply Qa, P; discriminate | apply Qb, P; discriminate | apply Qc, P; discriminate | apply Qd, P; discriminate].
Qed.
Lemma local_side (less : A -> A -> bool) (Q : R -> Prop) cc cc' :
  (forall a, less a (zero A aofZ) = true -> forall b d, 0 < b -> phi a = - (b * d) -> Q d) -> (forall s d, 0 < s -> Q d -> Q (s * d)) ->
  side_checked less -> have_a_common_side l1 l2 r N T2 cc cc' ->
  exists C s, circumscribed2 (tile2 cc) C s /\ forall v, In v (corners (tile2 cc')) -> In v (corners (tile2 cc)) \/ Q (distance_squared2 v C - s).
Proof.
  intros LQ QS SC [H [H' [u [v [Nuv [Hu [Hv [Hu' Hv']]]]]]]].
  pose proof (area_tile A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok c small range base3 l1 l2 HG) as AR.
  destruct cc as [k n], cc' as [k' n'].
  assert (D : {(k, n) = (k', n')} + {(k, n) <> (k', n')}) by (repeat decide equality). destruct D as [E|Ne].
  { rewrite <- E in *. eexists. eexists. split; [apply circumscribed_centre2, AR, H|]. auto. }
  destruct (side_of _ u v Nuv Hu Hv) as [i [Hi EN]].
  assert (EN' : forall x, In x (side_ends (tile2 (k, n)) i) -> In x (corners (tile2 (k', n')))) by (intros x Hx; destruct (EN x Hx) as [-> | ->]; auto).
  pose proof (facet_shared k n k' n' i H H' Hi EN') as FS. destruct (triangle_at k (proj1 H)) as [t [Et Ee]]. pose proof (SC k t i Et Hi) as CK.
  destruct (lowest i) as [j f] eqn:El. destruct FS as [j' [Hj' FS]]. cbv zeta in CK.
  assert (JF : (j < 3)%nat /\ In f I4) by (destruct i as [|[|i]]; injection El as <- <-; split; simpl; auto). destruct JF as [Hj Hf].
  destruct (tile_at j k n Hj H) as [V E]. destruct (tile_at j' k' n' Hj' H') as [V' E']. rewrite <- Ee in CK.
  pose proof (facet_behind A aadd asub amul aofZ alt ale part phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok c3 chk3 L1 L2 L3 HG3 less Q
    (3 * k + j)%nat (up3 n) (tet_over j (V2 A c) (e_tris A c) (N.of_nat k) t) (turned_facet (even_at A c k) f) ((3 * k' + j')%nat, up3 n') LQ QS V V') as FB.
  assert (EP : T3 = Pk (cT A aadd aofZ phi c3) (IZR (c_den A c3)) L1 L2 L3) by exact (dtet_cP A aadd asub amul aofZ alt phi phi_add phi_Z c3 base3 L1 L2 L3).
  rewrite <- EP in FB.
  assert (Ne3 : ((3 * k + j)%nat, up3 n) <> ((3 * k' + j')%nat, up3 n')).
  { intros X. injection X as X1 X2 X3. apply Ne. destruct n as [x1 y1], n' as [x1' y1']. cbn [fst snd] in *. subst. f_equal. lia. }
  destruct (FB Ne3 (tet_at j k t Hj Et) (turned_I4 _ _ Hf) CK) as [C [s [CI HC]]].
  { rewrite E, E'. intros x Hx. apply facet_vertices_turn in Hx. apply verts_turn, FS, Hx. }
  rewrite E in CI. assert (CI' : circumscribed (over j (tile2 (k, n))) C s) by (intros x Hx; apply CI, verts_turn, Hx).
  destruct (ball_over j _ C s Hj (AR _ H) CI') as [B1 B2]. exists (down C), (s - 1/4). split; auto.
  intros x Hx. destruct (corner_over j' _ x Hj' Hx) as [z [Z Iz]]. destruct (HC (up z x)) as [I|J].
  - rewrite E'. apply verts_turn, Iz.
  - left. rewrite E in I. apply verts_turn, over_corners in I as [I _]; auto. rewrite down_up in I. exact I.
  - right. rewrite B2 in J by auto. replace (distance_squared2 x (down C) - (s - 1/4)) with (distance_squared2 x (down C) + 1/4 - s) by ring. exact J.
Qed.
Theorem locally_weakly_sound2 : chk_delaunay A aadd asub amul aofZ ale c3 = true -> locally_weakly_delaunay2 l1 l2 r N T2.
Proof.
  intros H cc cc' CS. destruct (local_side ale (fun d => 0 <= d) cc cc') as [C [s [CI HC]]]; auto.
  - intros a L b d Hb E. apply ale_ok in L. unfold Checker.zero in L. rewrite phi_Z, E in L. apply Rmult_le_reg_l with b; auto. lra.
  - intros s d Hs Hd. apply Rmult_le_pos; lra.
  - apply weakly_checked, H.
  - exists C, s. split; auto. intros v Hv. destruct (HC v Hv) as [I|J]; [right; symmetry; apply CI, I|lra].
Qed.
Theorem locally_sound2 : chk_edges A aadd asub amul aofZ alt c3 (positions A aadd aofZ c3) (c_tets A c3) = true -> locally_delaunay2 l1 l2 r N T2.
Proof.
  intros H cc cc' CS. destruct (local_side alt (fun d => 0 < d) cc cc') as [C [s [CI HC]]]; auto.
  - intros a L b d Hb E. apply alt_ok in L. unfold Checker.zero in L. rewrite phi_Z, E in L. apply Rmult_lt_reg_l with b; auto. lra.
  - intros s d Hs Hd. apply Rmult_lt_0_compat; auto.
  - apply strictly_checked, H.
  - exists C, s. split; auto. intros v Hv. destruct (HC v Hv) as [I|J]; split; auto; try lra. right; symmetry; apply CI, I.
Qed.
End Basis.
End Sound.

(** A claim about a region of the plane. *)
Definition region_meaning2 (G : gram2) (r N : nat) (P : point2 -> point2 -> nat -> triangle2) (listed : list (nat * nat)) (ss : list region_statement) : Prop :=
  (exists l1 l2, has_gram2 G l1 l2) /\
  forall l1 l2, has_gram2 G l1 l2 -> edge_to_edge_region l1 l2 r N (P l1 l2) listed /\
    forall s, In s ss -> holds_in_region2 l1 l2 r N (P l1 l2) s.
Theorem check_region2_sound c ss : check_region2_with A aadd asub amul aofZ alt ale part c ss = true ->
  region_meaning2 (dgram2 A phi c) (e_rank A c) (length (e_tris A c)) (dtriangle A aofZ phi c) (listed_sides A c) (map (rdstatement A phi) ss).
Proof.
  unfold check_region2_with. destruct (check_region2 c) eqn:CHK; [|discriminate]. rewrite forallb_forall. intros H.
  destruct (parts2 c CHK) as [[S R] [_ C3]]. pose proof (RegionTheorem.base A aadd asub amul aofZ alt ale part _ C3) as B3. split.
  - apply (gram2_exists A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok c). split; auto.
  - intros l1 l2 HG. split; [apply region_sound2; auto|].
    intros s Hs. apply in_map_iff in Hs as [st [<- Hs]]. specialize (H st Hs).
    destruct st as [st| |]; cbn [check_region_statement2 rdstatement holds_in_region2] in *.
    + destruct st; try discriminate;
      exact (each_sound2 A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok c S R B3 l1 l2 HG _ H).
    + apply locally_sound2; auto.
    + apply locally_weakly_sound2; auto.
Qed.
End Ring.
