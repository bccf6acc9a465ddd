(** * docs/lower-bound.md, section 6: Steps A, B and C together, at one vertex

    The tetrahedra at a vertex as in Link.v, but with any valences: if not all of them are 5, then some dihedral angle of
    these tetrahedra is above theta*.  Steps A and B are for any bound theta as in Steps.v. *)
From Coq Require Import Reals Lra List Bool Arith Lia.
From Acutile Require Import Statement Tetrahedra Angles.
From LowerBound Require Import Calculus Normals Corners Triangles Excess Steps Link.
Import ListNotations.
Open Scope R_scope.

(** An edge has two directions, and a tetrahedron has the same angles in another order of its vertices. *)
Lemma dihedral_back a b c d : orient a b c d <> 0 -> dihedral b a c d = dihedral a b c d.
Proof.
  intros O. assert (O' : orient b a c d <> 0) by (intros Z; apply O; replace (orient a b c d) with (- orient b a c d) by (unf; ring); lra).
  destruct (dihedral_normals a b c d O) as [A1 [A2 E1]]. destruct (dihedral_normals b a c d O') as [B1 [B2 E2]].
  pose proof (acos_bound (dot (perp (sub b a) (sub c a)) (perp (sub b a) (sub d a)) / (norm (perp (sub b a) (sub c a)) * norm (perp (sub b a) (sub d a))))) as R1.
  pose proof (acos_bound (dot (perp (sub a b) (sub c b)) (perp (sub a b) (sub d b)) / (norm (perp (sub a b) (sub c b)) * norm (perp (sub a b) (sub d b))))) as R2.
  change (0 <= dihedral a b c d <= PI) in R1. change (0 <= dihedral b a c d <= PI) in R2.
  assert (N : forall x, cross (sub a b) (sub x b) = scale (-1) (cross (sub b a) (sub x a))) by (intros x; apply point_eq; unfold cross; unf; ring).
  rewrite !N, !norm_opp, dot_scale in E2.
  assert (E : cos (dihedral b a c d) = cos (dihedral a b c d)).
  { apply Rmult_eq_reg_r with (norm (cross (sub b a) (sub c a)) * norm (cross (sub b a) (sub d a))); [lra|].
    apply Rmult_integral_contrapositive_currified; lra. }
  apply cos_inj; lra.
Qed.
Lemma same_angles a b c d x : orient a b c d <> 0 -> In x (dihedrals (Tetrahedron a b d c)) -> In x (dihedrals (Tetrahedron a b c d)).
Proof.
  intros O. rewrite !the_six. unfold ab, ac, ad, bc, bd, cd.
  rewrite (dihedral_sym a b d c), (dihedral_back c d a b) by (intros Z; apply O; replace (orient a b c d) with (orient c d a b) by (unf; ring); exact Z).
  simpl. tauto.
Qed.

(** The sum of the angles at the edge of d, from the corner of d on. *)
Definition around {dart} (turn : dart -> dart) (n : nat) (d : dart) := map (fun i => Nat.iter i turn d) (seq 0 n).
Record vertex_star (dart : Type) (v : point) (darts : list dart) (turn along : dart -> dart) (tip : dart -> point) (valence : dart -> nat) : Prop := {
  vertex_distinct : NoDup darts;
  vertex_turn : forall d, In d darts -> In (turn d) darts;
  vertex_along : forall d, In d darts -> In (along d) darts;
  vertex_triangle : forall d, In d darts -> along (along (along d)) = d;
  vertex_back : forall d, In d darts -> turn (along (turn (along d))) = d;
  vertex_tip : forall d, In d darts -> tip (turn d) = tip d;
  vertex_solid : forall d, In d darts -> vol (corner_tetrahedron v tip along d) <> 0;
  vertex_valence : forall d, In d darts -> valence (turn d) = valence d;
  vertex_cycle : forall d, In d darts -> Nat.iter (valence d) turn d = d;
  vertex_sum : forall d, In d darts -> fold_right Rplus 0 (map (corner_angle v tip along) (around turn (valence d) d)) = 2 * PI }.

(** Valences 5 and 6, and no two of valence 6 together, make a [star] of Link.v. *)
Lemma star_from_valences dart v darts turn along tip valence : vertex_star dart v darts turn along tip valence ->
  (forall d, In d darts -> valence d = 5%nat \/ valence d = 6%nat) -> (forall d, In d darts -> valence d = 6%nat -> valence (turn (along d)) <> 6%nat) ->
  (exists d, In d darts /\ valence d <> 5%nat) -> star dart v darts turn along tip (fun d => valence d =? 6)%nat.
Proof.
  intros S F N [d0 [D0 V0]].
  destruct S as [Di Tu Al Tri Bk Tip Sol Val Cyc Sum]. split; auto.
  - intros d D H. apply Nat.eqb_neq in H. destruct (F d D) as [V|V]; [|contradiction]. pose proof (Cyc d D) as Q. rewrite V in Q. exact Q.
  - intros d D H. apply Nat.eqb_eq in H. pose proof (Cyc d D) as Q. rewrite H in Q. exact Q.
  - intros d D H. apply Nat.eqb_eq in H. apply Nat.eqb_neq. apply N; auto.
  - exists d0. split; [exact D0|]. apply Nat.eqb_eq. destruct (F d0 D0); [contradiction|assumption].
  - intros d D H a. apply Nat.eqb_neq in H. destruct (F d D) as [V|V]; [|contradiction]. pose proof (Sum d D) as Q. rewrite V in Q.
    unfold around in Q. cbv [seq map fold_right Nat.iter nat_rect] in Q. unfold a. lra.
  - intros d D H a. apply Nat.eqb_eq in H. pose proof (Sum d D) as Q. rewrite H in Q.
    unfold around in Q. cbv [seq map fold_right Nat.iter nat_rect] in Q. unfold a. lra.
Qed.

Section Vertex.
Variables (dart : Type) (v : point) (darts : list dart) (turn along : dart -> dart) (tip : dart -> point) (valence : dart -> nat).
Hypothesis S : vertex_star dart v darts turn along tip valence.
Variables theta p z : R.
Hypothesis good : good_bound theta p z.
Hypothesis at_most : forall d x, In d darts -> In x (dihedrals (corner_tetrahedron v tip along d)) -> x <= theta.
Notation angle_at := (corner_angle v tip along).

Lemma angle_possible d : In d darts -> possible_at theta (angle_at d).
Proof.
  intros D. exists v, (tip d), (tip (along d)), (tip (along (along d))). split; [exact (vertex_solid _ _ _ _ _ _ _ S d D)|]. split.
  - intros x X. exact (at_most d x D X).
  - left. reflexivity.
Qed.
Lemma iter_in d n : In d darts -> In (Nat.iter n turn d) darts.
Proof. intros D. induction n as [|n IH]; [exact D|]. cbn. apply (vertex_turn _ _ _ _ _ _ _ S). exact IH. Qed.
Lemma five_or_six d : In d darts -> valence d = 5%nat \/ valence d = 6%nat.
Proof.
  intros D. pose proof (valence_at theta p z good (map angle_at (around turn (valence d) d))) as Q.
  unfold around in Q. rewrite !map_length, seq_length in Q. apply Q; [|exact (vertex_sum _ _ _ _ _ _ _ S d D)].
  intros x X. apply in_map_iff in X. destruct X as [e [<- X]]. apply in_map_iff in X. destruct X as [i [<- _]]. apply angle_possible, iter_in, D.
Qed.

Lemma not_two_sixes d : In d darts -> valence d = 6%nat -> valence (turn (along d)) <> 6%nat.
Proof.
  intros D V6 W6. destruct S as [_ Tu Al Tri Bk Tip Sol Val Cyc Sum]. set (b := turn (along d)) in *. set (e := along b).
  assert (Db : In b darts) by (unfold b; auto). assert (De : In e darts) by (unfold e; auto).
  assert (Te : turn e = d) by (apply Bk; auto).
  assert (Tb : tip b = tip (along d)) by (apply Tip; auto). assert (Td : tip e = tip d) by (rewrite <- Te; symmetry; apply Tip; auto).
  assert (Ae : along (along e) = b) by (apply Tri; auto).
  (* the last corner at d is that of e, and the last one at b is that of along d *)
  assert (Le : Nat.iter 5 turn d = e).
  { pose proof (Cyc e De) as Q. rewrite <- (Val e De), Te, V6 in Q. change (turn (turn (turn (turn (turn (turn e))))) = e) in Q. rewrite Te in Q. exact Q. }
  assert (Lb : Nat.iter 5 turn b = along d).
  { pose proof (Cyc (along d) (Al d D)) as Q. rewrite <- (Val (along d) (Al d D)) in Q. fold b in Q. rewrite W6 in Q. exact Q. }
  pose proof (Sum d D) as Sd. pose proof (Sum b Db) as Sb. rewrite V6 in Sd. rewrite W6 in Sb.
  unfold around in Sd, Sb. cbv [seq map fold_right Nat.iter nat_rect] in Sd, Sb, Le, Lb. rewrite Le in Sd. rewrite Lb in Sb.
  set (w := tip d) in *. set (w' := tip (along d)) in *. set (t := tip (along (along d))) in *. set (r := tip (along e)).
  assert (A1 : angle_at d = dihedral v w w' t) by reflexivity.
  assert (A2 : angle_at e = dihedral v w w' r) by (unfold corner_angle; rewrite Ae, Tb, Td, dihedral_sym; reflexivity).
  assert (A3 : angle_at b = dihedral v w' w r) by (unfold corner_angle; fold e; rewrite Tb, Td; reflexivity).
  assert (A4 : angle_at (along d) = dihedral v w' w t) by (unfold corner_angle; rewrite Tri by auto; rewrite dihedral_sym; reflexivity).
  assert (Or : orient v w r w' <> 0).
  { pose proof (Sol e De) as Z. unfold corner_tetrahedron in Z. rewrite Ae, Tb, Td in Z. exact Z. }
  assert (Or' : orient v w w' r <> 0) by (intros Z; apply Or; replace (orient v w r w') with (- orient v w w' r) by (unf; ring); lra).
  pose proof (fun i => angle_possible _ (iter_in d i D)) as Pd. pose proof (fun i => angle_possible _ (iter_in b i Db)) as Pb.
  apply (two_sixes_at theta p z good v w w' t r (map (fun i => angle_at (Nat.iter i turn d)) [1;2;3;4]%nat) (map (fun i => angle_at (Nat.iter i turn b)) [1;2;3;4]%nat)).
  - exact (Sol d D).
  - intros x X. exact (at_most d x D X).
  - exact Or'.
  - intros x X. apply (at_most e x De). unfold corner_tetrahedron. rewrite Ae, Tb, Td. apply same_angles; [exact Or|exact X].
  - reflexivity.
  - intros x X. apply in_map_iff in X. destruct X as [i [<- _]]. apply Pd.
  - rewrite <- A1, <- A2, <- Sd. cbv [sum map fold_right Nat.iter nat_rect]. lra.
  - reflexivity.
  - intros x X. apply in_map_iff in X. destruct X as [i [<- _]]. apply Pb.
  - rewrite <- A3, <- A4, <- Sb. cbv [sum map fold_right Nat.iter nat_rect]. lra.
Qed.

Lemma vertex_is_star : (exists d, In d darts /\ valence d <> 5%nat) -> star dart v darts turn along tip (fun d => valence d =? 6)%nat.
Proof. exact (star_from_valences _ _ _ _ _ _ _ S five_or_six not_two_sixes). Qed.
End Vertex.

Theorem theorem_1_at_a_vertex dart v darts turn along tip valence :
  vertex_star dart v darts turn along tip valence -> (exists d, In d darts /\ valence d <> 5%nat) ->
  exists d, In d darts /\ exists x, In x (dihedrals (corner_tetrahedron v tip along d)) /\ theta_star < x.
Proof.
  intros S H.
  destruct (Exists_dec (fun d => Exists (fun x => theta_star < x) (dihedrals (corner_tetrahedron v tip along d))) darts
    (fun d => Exists_dec _ _ (fun x => Rlt_dec _ _))) as [Q|Q].
  - apply Exists_exists in Q. destruct Q as [d [D X]]. apply Exists_exists in X. exists d. auto.
  - apply (above_theta_star dart v darts turn along tip (fun d => valence d =? 6)%nat). apply (vertex_is_star _ _ _ _ _ _ _ S theta_star 1.09 0.89 star_good); auto.
    intros d x D X. apply Rnot_lt_le. intros Z. apply Q, Exists_exists. exists d. split; [exact D|]. apply Exists_exists. exists x. auto.
Qed.
