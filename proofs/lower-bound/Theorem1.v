(** * docs/lower-bound.md, Theorem 1: every locally finite face-to-face tiling of space by tetrahedra has a dihedral angle
    above theta* *)
From Coq Require Import Reals Lra Lia List Permutation Classical.
From Acutile Require Import Statement Tetrahedra.
From LowerBound Require Import Normals Corners Link Vertex Tiling Edge Around Cell600.
Import ListNotations.
Open Scope R_scope.

Section Theorem_1.
Context {index : Type} {is_tile : index -> Prop} {tile : index -> tetrahedron}.
Hypothesis tiling : space_tiling is_tile tile.
Notation pos := (@pos index is_tile tile).

Lemma cell_dihedrals a b c d x : @cell index is_tile tile a b c d -> In x (dihedrals (Tetrahedron a b c d)) -> exists i, is_tile i /\ In x (dihedrals (tile i)).
Proof.
  intros C X. pose proof (cell_solid tiling _ _ _ _ C) as V. destruct C as [i [T S]]. exists i. split; [exact T|]. exact (shuffle_dihedrals _ _ S V x X).
Qed.
(** If all cycles have five tiles, they close as in Cell600.v. *)
Lemma closes_after_five v darts p c0 c1 c2 c3 c4 : (forall p q r, In (p, q, r) darts <-> pos v p q r) -> valence_in darts (p, c0, c1) = 5%nat ->
  pos v p c0 c1 -> pos v p c1 c2 -> pos v p c2 c3 -> pos v p c3 c4 -> pos v p c4 c0.
Proof.
  intros H V P0 P1 P2 P3. destruct (cycle_properties tiling v darts H p c0 c1 P0) as [A [_ [C _]]]. rewrite V in C.
  set (c := point_of darts (p, c0, c1)) in *. assert (E0 : c 0%nat = c0) by reflexivity.
  assert (E1 : c 1%nat = c1). { apply (same_side tiling v p c0); [|exact P0]. rewrite <- E0 at 1. apply A. }
  assert (E2 : c 2%nat = c2). { apply (same_side tiling v p c1); [|exact P1]. rewrite <- E1 at 1. apply A. }
  assert (E3 : c 3%nat = c3). { apply (same_side tiling v p c2); [|exact P2]. rewrite <- E2 at 1. apply A. }
  assert (E4 : c 4%nat = c4). { apply (same_side tiling v p c3); [|exact P3]. rewrite <- E3 at 1. apply A. }
  pose proof (A 4%nat) as Q. rewrite C, E0, E4 in Q. exact Q.
Qed.

(** Lemma 1: not all valences are 5. *)
Theorem lemma_1_space : ~ forall u v c, has_edge is_tile tile u v c -> u <> v -> edge_valence is_tile tile u v 5.
Proof.
  intros F. apply (not_all_close tiling). intros v p c0 c1 c2 c3 c4 P0 P1 P2 P3.
  destruct (darts_exist tiling v) as [darts [D H]]. apply (closes_after_five v darts p c0 c1 c2 c3 c4 H); auto.
  destruct (cycle_tiles tiling v darts H p c0 c1 P0) as [tiles [N [L [I _]]]]. rewrite <- L.
  pose proof (cell_apart tiling _ _ _ _ (proj1 P0)) as [Ne _]. destruct P0 as [[i [T S]] _].
  assert (E : has_edge is_tile tile v p i) by (split; [exact T|]; split; apply (shuffle_verts _ _ S); simpl; auto).
  destruct (F v p i E Ne) as [M [NM [LM IM]]]. rewrite <- LM. apply Permutation_length, NoDup_Permutation; auto. intros x. rewrite I, IM. reflexivity.
Qed.

(** So there is a vertex with a valence that is not 5. *)
Lemma other_valence : exists v darts d, NoDup darts /\ (forall p q r, In (p, q, r) darts <-> pos v p q r) /\ In d darts /\ valence_in darts d <> 5%nat.
Proof.
  apply NNPP. intros N. apply (not_all_close tiling). intros v p c0 c1 c2 c3 c4 P0 P1 P2 P3.
  destruct (darts_exist tiling v) as [darts [D H]]. apply (closes_after_five v darts p c0 c1 c2 c3 c4 H); auto.
  destruct (Nat.eq_dec (valence_in darts (p, c0, c1)) 5) as [E|E]; [exact E|]. exfalso. apply N.
  exists v, darts, (p, c0, c1). split; [exact D|]. split; [exact H|]. split; [apply H, P0|exact E].
Qed.

(** ** A vertex with valences 5 and 6 only, no two of them 6 in a triangle *)
Lemma one_valence u v m n : edge_valence is_tile tile u v m -> edge_valence is_tile tile u v n -> m = n.
Proof.
  intros [L [A [B I]]] [L' [A' [B' I']]]. rewrite <- B, <- B'. apply Permutation_length, NoDup_Permutation; auto. intros x. rewrite I, I'. reflexivity.
Qed.
Section At_vertex.
Variables (v : point) (darts : list dart).
Hypothesis distinct : NoDup darts.
Hypothesis darts_are : forall p q r, In (p, q, r) darts <-> pos v p q r.
Hypothesis five_or_six : forall w c, has_edge is_tile tile v w c -> v <> w -> edge_valence is_tile tile v w 5 \/ edge_valence is_tile tile v w 6.
Hypothesis apart : forall c w w', is_tile c -> In v (verts (tile c)) -> In w (verts (tile c)) -> In w' (verts (tile c)) -> v <> w -> v <> w' -> w <> w' ->
  ~ (edge_valence is_tile tile v w 6 /\ edge_valence is_tile tile v w' 6).
Lemma dart_valence p q r : In (p, q, r) darts -> edge_valence is_tile tile v p (valence_in darts (p, q, r)).
Proof. intros J. apply darts_are in J. destruct (cycle_tiles tiling v darts darts_are p q r J) as [tiles [A [B [C _]]]]. exists tiles. auto. Qed.
Lemma dart_tile p q r : In (p, q, r) darts ->
  exists c, is_tile c /\ In v (verts (tile c)) /\ In p (verts (tile c)) /\ In q (verts (tile c)) /\ v <> p /\ v <> q /\ p <> q.
Proof.
  intros J. apply darts_are in J. destruct J as [C _]. pose proof (cell_apart tiling _ _ _ _ C) as A. destruct C as [c [T Sh]]. exists c. split; [exact T|].
  repeat split; try apply A; apply (shuffle_verts _ _ Sh); simpl; auto.
Qed.
Lemma tcp_star : (exists d, In d darts /\ valence_in darts d <> 5%nat) -> star dart v darts (turn_in darts) along tip (fun d => Nat.eqb (valence_in darts d) 6).
Proof.
  intros V. pose proof (vertex_star_of_tiling tiling v darts distinct darts_are) as S. apply (star_from_valences _ _ _ _ _ _ _ S); [| |exact V].
  - intros [[p q] r] J. destruct (dart_tile p q r J) as [c [T [V1 [V2 [_ [Ne _]]]]]].
    destruct (five_or_six p c (conj T (conj V1 V2)) Ne) as [W|W]; [left|right]; apply (one_valence v p _ _ (dart_valence p q r J) W).
  - intros [[p q] r] J E E'. destruct (dart_tile p q r J) as [c [T [V1 [V2 [V3 [N1 [N2 N3]]]]]]].
    apply (apart c p q T V1 V2 V3 N1 N2 N3). split; [rewrite <- E; apply dart_valence, J|].
    pose proof (vertex_along _ _ _ _ _ _ _ S _ J) as J'. cbn [along] in J'. rewrite (vertex_valence _ _ _ _ _ _ _ S (along (p, q, r)) J') in E'. cbn [along] in E'.
    rewrite <- E'. apply dart_valence, J'.
Qed.
End At_vertex.
(** Theorem 2: then an angle at an edge vw is at least theta*, if one of these valences is 6. *)
Theorem theorem_2_space v :
  (forall w c, has_edge is_tile tile v w c -> v <> w -> edge_valence is_tile tile v w 5 \/ edge_valence is_tile tile v w 6) ->
  (forall c w w', is_tile c -> In v (verts (tile c)) -> In w (verts (tile c)) -> In w' (verts (tile c)) -> v <> w -> v <> w' -> w <> w' ->
    ~ (edge_valence is_tile tile v w 6 /\ edge_valence is_tile tile v w' 6)) ->
  (exists w c, has_edge is_tile tile v w c /\ v <> w /\ edge_valence is_tile tile v w 6) ->
  exists c w p q, is_tile c /\ (forall x, In x (verts (tile c)) <-> In x [v; w; p; q]) /\ theta_star <= dihedral v w p q.
Proof.
  intros F A [w [c [[T [V W]] [Ne S6]]]]. destruct (darts_exist tiling v) as [darts [D H]].
  destruct (shuffle_two (tile c) v w V W Ne) as [x [y S]]. assert (C : @cell index is_tile tile v w x y) by (exists c; split; assumption).
  assert (J : exists x y, In (w, x, y) darts).
  { pose proof (cell_solid tiling _ _ _ _ C) as O. destruct (Rlt_dec 0 (orient v w x y)) as [Z|Z].
    - exists x, y. apply H. split; assumption.
    - exists y, x. apply H. split; [apply cell_cd, C|]. replace (orient v w y x) with (- orient v w x y) by (unf; ring). lra. }
  clear x y S C. destruct J as [x [y J]].
  assert (E : valence_in darts (w, x, y) = 6%nat) by (apply (one_valence v w _ _ (dart_valence v darts H w x y J) S6)).
  assert (V5 : exists d, In d darts /\ valence_in darts d <> 5%nat) by (exists (w, x, y); split; [exact J|rewrite E; discriminate]).
  destruct (theorem_2 _ _ _ _ _ _ _ (tcp_star v darts D H F A V5)) as [[[p q] r] [K L]].
  apply H in K. destruct K as [[i [Ti Sh]] _]. exists i, p, q, r. split; [exact Ti|]. split; [|exact L]. intros z. symmetry. exact (shuffle_verts _ _ Sh z).
Qed.

Theorem theorem_1_space : exists c x, is_tile c /\ In x (dihedrals (tile c)) /\ theta_star < x.
Proof.
  destruct other_valence as [v [darts [d [D [H [I E]]]]]].
  destruct (theorem_1_at_a_vertex _ _ _ _ _ _ _ (vertex_star_of_tiling tiling v darts D H)) as [[[q r] s] [J [x [X L]]]]; [exists d; auto|].
  apply H in J. destruct (cell_dihedrals v q r s x (proj1 J) X) as [i [T Y]]. exists i, x. auto.
Qed.
End Theorem_1.

(** In the words of Statement.v, for periodic tilings. *)
Lemma periodic_space l1 l2 l3 (Omega : point -> Prop) N P : (forall X, Omega X) -> face_to_face_tiling l1 l2 l3 3 Omega N P -> space_tiling (is_tile 3 N) (tile l1 l2 l3 P).
Proof.
  intros O []. split; auto.
Qed.
Theorem lemma_1 l1 l2 l3 (Omega : point -> Prop) N P : (forall X, Omega X) -> face_to_face_tiling l1 l2 l3 3 Omega N P ->
  ~ forall u v c, has_vertices l1 l2 l3 3 N P (u :: v :: nil) c -> u <> v -> valence l1 l2 l3 3 N P u v 5.
Proof.
  intros O H F. assert (E : forall u v c, has_vertices l1 l2 l3 3 N P (u :: v :: nil) c <-> has_edge (is_tile 3 N) (tile l1 l2 l3 P) u v c).
  { intros u v c. unfold has_vertices, has_edge. simpl. split; intros [T V]; (split; [exact T|]); [auto|]. intros w [<-|[<-|[]]]; tauto. }
  apply (lemma_1_space (periodic_space l1 l2 l3 Omega N P O H)). intros u v c C Ne. apply E in C. destruct (F u v c C Ne) as [L [A [B I]]].
  exists L. split; [exact A|]. split; [exact B|]. intros x. rewrite I. apply E.
Qed.
Theorem theorem_1 l1 l2 l3 (Omega : point -> Prop) N P : (forall X, Omega X) -> face_to_face_tiling l1 l2 l3 3 Omega N P ->
  exists c x, is_tile 3 N c /\ In x (dihedrals (tile l1 l2 l3 P c)) /\ theta_star < x.
Proof. intros O H. exact (theorem_1_space (periodic_space l1 l2 l3 Omega N P O H)). Qed.
