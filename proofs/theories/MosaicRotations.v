(** * Systems of patches: the finite checks imply that heights exist

    The rotations of the checker are those of MosaicHeights.v. *)
Require Import Reals Lra Psatz NArith ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Domain Bounds Euclid Transfer Checker Soundness
  MosaicStatement MosaicPoints MosaicPatches MosaicHeights MosaicChecker MosaicSpots MosaicSoundness.
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
Notation rpatch := (MosaicSpots.rpatch A phi).
Notation phi_zero := (MosaicSpots.phi_zero A aofZ phi phi_Z).
Notation aeq_ok := (MosaicSpots.aeq_ok A ale phi ale_ok).
Notation positive_patch := (MosaicSpots.positive_patch A aofZ phi).
Notation edge_ok := (MosaicSpots.edge_ok A aofZ phi phi_Z).
Notation finish_ok := (MosaicSpots.finish_ok A aofZ phi phi_Z r).
Notation len := (MosaicSpots.len A aadd asub amul aofZ phi g).
Notation length_ok := (MosaicSpots.length_ok A aadd asub amul aofZ phi phi_add phi_sub phi_mul phi_Z g r).
Notation fits_ok := (MosaicSpots.fits_ok A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok g r).
Notation patch_ok := (MosaicSoundness.patch_ok A phi system).
Notation positive_ok := (MosaicSoundness.positive_ok A aadd asub amul aofZ alt ale content quot phi phi_Z alt_ok g r system h apexes home CHECKED).
Notation pair_checked := (MosaicSoundness.pair_checked A aadd asub amul aofZ alt ale content quot phi g r system h apexes home CHECKED).
Notation fits_meet := (MosaicSoundness.fits_meet A aofZ phi phi_Z g r system).
Notation sides_length := (MosaicSoundness.sides_length A phi system).
Notation system_good := (MosaicSoundness.system_good A aadd asub amul aofZ alt ale content quot phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok g r rank system h apexes home CHECKED).
Notation vY := (Checker.vY A).
Notation vZ := (Checker.vZ A).
Notation phiG := (phiG A phi).
Notation weight := (MosaicChecker.weight A).
Notation numerators := (MosaicChecker.numerators A).
Notation k_start := (MosaicChecker.k_start A aofZ).
Notation k_sides := (MosaicChecker.k_sides A).
Notation base_diff := (MosaicChecker.base_diff A asub amul).
Notation G := (phiG g).
Notation k_patch := (MosaicChecker.k_patch A system).
Notation rsystem := (map rpatch system).
Variables (l1 l2 l3 : point).
Hypothesis basis : has_gram G l1 l2 l3.
Hypothesis right_handed : 0 < det l1 l2 l3.

Variable turnings : list (k_turning A).
Definition rmatrix (m : matrix A) : (R * R) * (R * R) := let '(w, (a, b, c, d)) := m in ((phi a / phi w, phi b / phi w), (phi c / phi w, phi d / phi w)).
Definition rfraction (x : fraction A) : R := phi (fst x) / phi (snd x).
Definition rturning (t : k_turning A) : turning := (rmatrix (fst t), rfraction (snd t)).
Lemma div_eq a b c d : 0 < b -> 0 < d -> d * a = b * c -> a / b = c / d.
Proof. intros B D E. apply Rmult_eq_reg_l with (b * d); [|apply Rgt_not_eq, Rmult_lt_0_compat; auto]. transitivity (d * a); [field; lra|]. rewrite E. field. lra. Qed.
Lemma matrix_eq_ok m n : 0 < phi (fst m) -> 0 < phi (fst n) -> matrix_eq A amul ale m n = true -> rmatrix m = rmatrix n.
Proof.
  destruct m as [w [[[a b] c] d]], n as [v [[[a' b'] c'] d']]. cbn [fst]. intros W V. unfold matrix_eq. rewrite !andb_true_iff. intros [[[H1 H2] H3] H4].
  apply aeq_ok in H1, H2, H3, H4. rewrite !phi_mul in H1, H2, H3, H4. unfold rmatrix. rewrite (div_eq _ _ _ _ W V H1), (div_eq _ _ _ _ W V H2), (div_eq _ _ _ _ W V H3), (div_eq _ _ _ _ W V H4). reflexivity.
Qed.
Lemma matrix_differs_ok m n : 0 < phi (fst m) -> 0 < phi (fst n) -> matrix_differs A amul alt m n = true -> rmatrix m <> rmatrix n.
Proof.
  destruct m as [w [[[a b] c] d]], n as [v [[[a' b'] c'] d']]. cbn [fst]. intros W V. unfold matrix_differs, rmatrix. intros H E. injection E as E1 E2 E3 E4.
  assert (X : forall x y, phi x / phi w = phi y / phi v -> strict A alt (amul v x) (amul w y) = true -> False).
  { intros x y E S. unfold strict in S. apply (f_equal (Rmult (phi w * phi v))) in E. assert (E' : phi v * phi x = phi w * phi y).
    { transitivity (phi w * phi v * (phi x / phi w)); [field; lra|]. rewrite E. field. lra. }
    apply orb_true_iff in S as [S|S]; apply alt_ok in S; rewrite !phi_mul in S; lra. }
  rewrite !orb_true_iff in H. destruct H as [[[H|H]|H]|H]; eapply X; eauto.
Qed.
Lemma matrix_reduce_ok m : 0 < phi (fst m) -> 0 < phi (fst (matrix_reduce A amul aofZ ale content quot m)) /\ rmatrix (matrix_reduce A amul aofZ ale content quot m) = rmatrix m.
Proof.
  destruct m as [w [[[a b] c] d]]. cbn [fst]. intros W. unfold matrix_reduce. set (k := content _). cbv zeta. destruct (Z.leb_spec k 1) as [L|L]; [auto|].
  match goal with |- context [if ?x then _ else _] => destruct x eqn:E end; [|auto]. rewrite !andb_true_iff in E. destruct E as [[[[E0 E1] E2] E3] E4].
  apply aeq_ok in E0, E1, E2, E3, E4. rewrite !phi_mul, phi_Z in *. assert (K : 0 < IZR k) by (apply IZR_lt; lia). cbn [fst].
  assert (W' : 0 < phi (quot k w)) by (apply Rmult_lt_reg_l with (IZR k); auto; lra). split; [exact W'|]. unfold rmatrix. rewrite <- E0, <- E1, <- E2, <- E3, <- E4.
  f_equal; f_equal; field; lra.
Qed.
Lemma compose_ok m n : 0 < phi (fst m) -> 0 < phi (fst n) -> let x := matrix_compose A aadd amul aofZ ale content quot m n in 0 < phi (fst x) /\ rmatrix x = compose (rmatrix m) (rmatrix n).
Proof.
  destruct m as [w [[[a b] c] d]], n as [v [[[x y] z] t]]. cbn [fst]. intros W V. unfold matrix_compose. cbv zeta.
  match goal with |- context [matrix_reduce _ _ _ _ _ _ ?m] => destruct (matrix_reduce_ok m) as [P E] end; [cbn [fst]; rewrite phi_mul; apply Rmult_lt_0_compat; auto|].
  split; [exact P|]. rewrite E. unfold rmatrix, compose; cbn [fst snd]. repeat rewrite ?phi_add, ?phi_mul. f_equal; f_equal; field; lra.
Qed.
Lemma linear_ok p s q s' : positive_patch p -> positive_patch q -> r = 1%nat -> 0 < fst (len p s) ->
  let x := k_linear A aadd asub amul aofZ ale content quot g p s q s' in 0 < phi (fst x) /\ rmatrix x = linear G r (rpatch p) s (rpatch q) s'.
Proof.
  intros PP PQ R L. pose proof (proj1 PP s) as P1. pose proof (proj1 PP (next (k_sides p) s)) as P2. pose proof (proj1 PQ s') as Q1. pose proof (proj1 PQ (next (k_sides q) s')) as Q2.
  unfold k_linear. cbv zeta. match goal with |- context [matrix_reduce _ _ _ _ _ _ ?m] => destruct (matrix_reduce_ok m) as [P E] end.
  { cbn [fst]. rewrite !phi_mul. repeat apply Rmult_lt_0_compat; auto. }
  split; [exact P|]. rewrite E. clear P E. unfold linear, carry. cbv zeta. rewrite !(length_ok p s PP R). unfold along. rewrite !finish_ok, !edge_ok by auto. rewrite !R. cbn [start].
  unfold len in *; cbn [fst snd] in *. set (U := base_diff (k_start p s) (k_start p (next (k_sides p) s))) in *. set (V := base_diff (k_start q s') (k_start q (next (k_sides q) s'))) in *.
  unfold pos in P1, P2, Q1, Q2. set (n := base_dot A aadd amul g U U) in *.
  assert (UE : phi (fst U) = phi (weight (k_start p s)) * phi (vY (numerators (k_start p (next (k_sides p) s)))) - phi (weight (k_start p (next (k_sides p) s))) * phi (vY (numerators (k_start p s)))) by (unfold U, MosaicChecker.base_diff; cbn [fst]; rewrite phi_sub, !phi_mul; reflexivity).
  assert (UE' : phi (snd U) = phi (weight (k_start p s)) * phi (vZ (numerators (k_start p (next (k_sides p) s)))) - phi (weight (k_start p (next (k_sides p) s))) * phi (vZ (numerators (k_start p s)))) by (unfold U, MosaicChecker.base_diff; cbn [snd]; rewrite phi_sub, !phi_mul; reflexivity).
  assert (VE : phi (fst V) = phi (weight (k_start q s')) * phi (vY (numerators (k_start q (next (k_sides q) s')))) - phi (weight (k_start q (next (k_sides q) s'))) * phi (vY (numerators (k_start q s')))) by (unfold V, MosaicChecker.base_diff; cbn [fst]; rewrite phi_sub, !phi_mul; reflexivity).
  assert (VE' : phi (snd V) = phi (weight (k_start q s')) * phi (vZ (numerators (k_start q (next (k_sides q) s')))) - phi (weight (k_start q (next (k_sides q) s'))) * phi (vZ (numerators (k_start q s')))) by (unfold V, MosaicChecker.base_diff; cbn [snd]; rewrite phi_sub, !phi_mul; reflexivity).
  clearbody n. clear PP PQ. unfold rmatrix, MosaicChecker.base_turn, origin; cbn [fst snd].
  unfold rp, scale, sub, Soundness.phiG; cbn [px py pz g22 g33 g23]. unfold Soundness.phi3; cbn [px py pz].
  repeat rewrite ?phi_add, ?phi_mul, ?phi_sub, ?phi_zero. rewrite UE, UE', VE, VE'. f_equal; f_equal; field; lra.
Qed.
Lemma is_whole_ok x : 0 < phi (snd x) -> is_whole A amul aofZ ale x = true -> whole (rfraction x).
Proof.
  intros P H. unfold is_whole in H. apply existsb_exists in H as [z [_ H]]. apply aeq_ok in H. rewrite phi_mul, phi_Z in H. exists z. unfold rfraction. rewrite H. field. lra.
Qed.
Lemma minus_ok x y : 0 < phi (snd x) -> 0 < phi (snd y) -> 0 < phi (snd (minus_fraction A asub amul x y)) /\ rfraction (minus_fraction A asub amul x y) = rfraction x - rfraction y.
Proof. intros X Y. unfold minus_fraction, rfraction; cbn [fst snd]. rewrite phi_sub, !phi_mul. split; [apply Rmult_lt_0_compat; auto|field; lra]. Qed.
Lemma plus_ok x y : 0 < phi (snd x) -> 0 < phi (snd y) -> 0 < phi (snd (plus_fraction A aadd amul x y)) /\ rfraction (plus_fraction A aadd amul x y) = rfraction x + rfraction y.
Proof. intros X Y. unfold plus_fraction, rfraction; cbn [fst snd]. rewrite phi_add, !phi_mul. split; [apply Rmult_lt_0_compat; auto|field; lra]. Qed.
Theorem rotations_ok : r = 1%nat -> check_rotations A aadd asub amul aofZ alt ale content quot g r system turnings = true -> rotations G r rsystem (map rturning turnings).
Proof.
  intros R C. unfold check_rotations in C. rewrite !andb_true_iff in C. destruct C as [[[C1 C2] C3] C4]. rewrite forallb_forall in C1, C4.
  assert (POS : forall t, In t turnings -> 0 < phi (fst (fst t)) /\ 0 < phi (snd (snd t))).
  { intros t Ht. specialize (C1 t Ht). apply andb_true_iff in C1 as [A1 A2]. apply alt_ok in A1, A2. rewrite phi_zero in A1, A2. auto. }
  destruct turnings as [|t0 ts] eqn:ET; [discriminate|]. rewrite <- ET in *. set (T := turnings) in *.
  assert (I0 : rturning t0 = no_turning).
  { apply andb_true_iff in C2 as [A1 A2]. destruct (POS t0 ltac:(rewrite ET; cbn; auto)) as [P1 P2]. apply matrix_eq_ok in A1; auto; [|cbn [fst]; unfold one; rewrite phi_Z; lra]. apply aeq_ok in A2. rewrite phi_zero in A2.
    unfold rturning, no_turning. rewrite A1. unfold rfraction. rewrite A2. unfold rmatrix, one. rewrite phi_zero, phi_Z. f_equal; [f_equal; f_equal; field|unfold Rdiv; ring]. }
  assert (AT : forall k, (k < length (map rturning T))%nat -> exists t, In t T /\ nth k (map rturning T) no_turning = rturning t).
  { intros k Hk. rewrite map_length in Hk. exists (nth k T t0). split; [apply nth_In, Hk|]. rewrite <- I0. apply map_nth. }
  assert (IDX : forall t, In t T -> exists k, (k < length (map rturning T))%nat /\ nth k (map rturning T) no_turning = rturning t).
  { intros t Ht. apply (In_nth _ _ t0) in Ht as [k [Hk <-]]. exists k. rewrite map_length. split; [exact Hk|]. rewrite <- I0. apply map_nth. }
  split.
  - split; [rewrite map_length, ET; cbn; lia|]. rewrite ET. cbn [map nth]. exact I0.
  - intros a s b s' k Ha Hb Hs Hs' FT Hk. destruct (AT k Hk) as [t [Ht ->]]. rewrite sides_length in Hs, Hs'.
    pose proof (fits_meet _ _ _ _ FT) as CM. pose proof (pair_checked a s b s' Ha Hb Hs Hs') as CP. unfold check_pair in CP. cbv zeta in CP. rewrite CM in CP. rewrite !andb_true_iff in CP. destruct CP as [[SL _] _].
    destruct (positive_ok a Ha) as [PP _]. destruct (positive_ok b Hb) as [PQ _]. destruct (fits_ok _ _ _ _ PP PQ CM SL) as [_ LP]. specialize (LP R).
    rewrite map_length in Ha, Hb. pose proof (upto_ok _ _ C3 a Ha) as K. cbv zeta in K. pose proof (upto_ok _ _ K s Hs) as K2. cbv beta in K2. pose proof (upto_ok _ _ K2 b Hb) as K3. cbv zeta in K3. pose proof (upto_ok _ _ K3 s' Hs') as K4. cbv beta zeta in K4. rewrite CM in K4.
    rewrite forallb_forall in K4. specialize (K4 t Ht). apply existsb_exists in K4 as [t' [Ht' K4]]. apply andb_true_iff in K4 as [K4 K5]. destruct (POS t Ht) as [Pt Pt2]. destruct (POS t' Ht') as [Pt' Pt2'].
    destruct (linear_ok (k_patch a) s (k_patch b) s' PP PQ R LP) as [LP1 LP2]. cbv zeta in LP1, LP2. destruct (compose_ok (fst t) _ Pt LP1) as [CP1 CP2]. cbv zeta in CP1, CP2.
    destruct (IDX t' Ht') as [k' [Hk' Ek']]. exists k'. split; [exact Hk'|]. rewrite Ek'. unfold rturning at 1 2; cbn [fst]. rewrite !patch_ok. split.
    + rewrite <- LP2, <- CP2. apply matrix_eq_ok; auto.
    + assert (O1 : 0 < phi (snd (offset_of A aofZ (k_patch a) s))) by apply PP. assert (O2 : 0 < phi (snd (offset_of A aofZ (k_patch b) s'))) by apply PQ.
      destruct (minus_ok _ _ O1 O2) as [M1 M2]. destruct (plus_ok _ _ Pt2 M1) as [N1 N2]. destruct (minus_ok _ _ Pt2' N1) as [Q1 Q2]. apply is_whole_ok in K5; auto.
      rewrite Q2, N2, M2 in K5. unfold rturning; cbn [snd]. apply (whole_eq _ _ K5). unfold offset. rewrite !edge_ok. cbn [start fst].
      assert (OF : forall p s, positive_patch p -> rfraction (offset_of A aofZ p s) = px (rp (k_start p s))).
      { intros p0 s0 P0. unfold rfraction, offset_of, rp, scale, Soundness.phi3; cbn [fst snd px]. pose proof (proj1 P0 s0) as X. unfold pos in X. field. lra. }
      rewrite !OF by auto. ring.
  - intros k k' Hk Hk' E. destruct (AT k Hk) as [t [Ht Et]]. destruct (AT k' Hk') as [t' [Ht' Et']]. rewrite Et, Et' in *. unfold rturning in E |- *; cbn [fst snd] in *.
    destruct (POS t Ht) as [P1 P2]. destruct (POS t' Ht') as [P1' P2']. specialize (C4 t Ht). rewrite forallb_forall in C4. specialize (C4 t' Ht'). apply orb_true_iff in C4 as [C4|C4].
    + apply matrix_differs_ok in C4; auto. contradiction.
    + destruct (minus_ok _ _ P2 P2') as [M1 M2]. apply is_whole_ok in C4; auto. rewrite M2 in C4. exact C4.
Qed.
Theorem heights_ok : check_heights A aadd asub amul aofZ alt ale content quot g r system turnings = true -> heights_exist l1 l2 l3 G r rsystem.
Proof.
  intros C tiles T. unfold check_heights in C. destruct rank as [R|R].
  - rewrite R in C. cbn [Nat.eqb] in C. rewrite <- R in C. apply (heights_by_rotations G r rsystem h system_good l1 l2 l3 basis right_handed tiles T R (map rturning turnings)). apply rotations_ok; auto.
  - apply (heights_by_chain G r rsystem h system_good l1 l2 l3 basis right_handed tiles T R).
Qed.
End Ring.
