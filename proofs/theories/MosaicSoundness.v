(** * Systems of patches: the finite checks imply the theorem

    Over any ring with a homomorphism phi to the real numbers for which the two comparisons are
    sound, as in Soundness.v. *)
Require Import Reals Lra Psatz NArith ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Domain Bounds Angles Euclid Transfer Delaunay Checker Soundness
  MosaicStatement MosaicTiling MosaicDelaunay MosaicHeights MosaicChecker.
Import ListNotations.
Local Open Scope R_scope.

Lemma upto_ok n f : upto n f = true -> forall i, (i < n)%nat -> f i = true.
Proof. unfold upto. rewrite forallb_forall. intros H i Hi. apply H, in_seq. lia. Qed.
Lemma some_upto_ok n f : some_upto n f = true -> exists i, (i < n)%nat /\ f i = true.
Proof. unfold some_upto. rewrite existsb_exists. intros [i [I H]]. apply in_seq in I. exists i. split; [lia|exact H]. Qed.
Lemma z3eqb_eq a b : z3eqb a b = true -> a = b.
Proof. destruct a as [[? ?] ?], b as [[? ?] ?]. unfold z3eqb. rewrite !andb_true_iff, !Z.eqb_eq. intros [[-> ->] ->]. reflexivity. Qed.
Lemma occupant_eqb_eq o o' : occupant_eqb o o' = true -> o = o'.
Proof. destruct o, o'; cbn; try discriminate; rewrite andb_true_iff, !Nat.eqb_eq; intros [-> ->]; reflexivity. Qed.
Lemma entry_eqb_eq x y : entry_eqb x y = true -> x = y.
Proof.
  destruct x, y; cbn; try discriminate; rewrite andb_true_iff.
  - intros [A B]. apply occupant_eqb_eq in A. apply z3eqb_eq in B. congruence.
  - rewrite !Nat.eqb_eq. intros [-> ->]; reflexivity.
Qed.
Lemma mate_eqb_eq x y : mate_eqb x y = true -> x = y.
Proof. destruct x, y. unfold mate_eqb; cbn [fst snd]. rewrite andb_true_iff, Nat.eqb_eq. intros [-> B]. apply z3eqb_eq in B. congruence. Qed.

Lemma cons_inj {X} (a b : X) l m : a :: l = b :: m -> a = b /\ l = m.
Proof. intros E. injection E as -> ->. auto. Qed.

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
Notation v3 := (Checker.v3 A).
Notation V3 := (Checker.V3 A).
Notation vX := (Checker.vX A).
Notation vY := (Checker.vY A).
Notation vZ := (Checker.vZ A).
Notation zero := (Checker.zero A aofZ).
Notation phi3 := (phi3 A phi).
Notation phiT := (phiT A phi).
Notation phiG := (phiG A phi).
Notation spot := (MosaicChecker.spot A).
Notation Spot := (MosaicChecker.Spot A).
Notation weight := (MosaicChecker.weight A).
Notation numerators := (MosaicChecker.numerators A).
Notation aeq := (MosaicChecker.aeq A ale).
Notation veq := (MosaicChecker.veq A ale).
Notation vtimes := (MosaicChecker.vtimes A amul).
Notation spot_eq := (MosaicChecker.spot_eq A amul ale).
Notation spot_lift := (MosaicChecker.spot_lift A aadd amul aofZ).
Notation even := (MosaicChecker.even A amul aofZ ale).
Notation reduce := (MosaicChecker.reduce A amul aofZ ale content quot).
Notation no_spot := (MosaicChecker.no_spot A aofZ).
Notation kpatch := (MosaicChecker.kpatch A).
Notation corner_list := (MosaicChecker.corner_list A).
Notation corners := (MosaicChecker.corners A).
Notation spots := (MosaicChecker.spots A).
Notation k_start := (MosaicChecker.k_start A aofZ).
Notation k_class := (MosaicChecker.k_class A aofZ).
Notation k_sides := (MosaicChecker.k_sides A).
Notation k_apex := (MosaicChecker.k_apex A aofZ).
Notation k_rim := (MosaicChecker.k_rim A aofZ).
Notation k_rim_at := (MosaicChecker.k_rim_at A aofZ).
Notation k_rim_count := (MosaicChecker.k_rim_count A aofZ).
Notation k_piece := (MosaicChecker.k_piece A aofZ).
Notation k_triangle := (MosaicChecker.k_triangle A aofZ).
Notation k_occupant := (MosaicChecker.k_occupant A aofZ).
Notation occupants := (MosaicChecker.occupants A aofZ).
Notation k_left := (MosaicChecker.k_left A aadd amul).
Notation kL := (Checker.kL A aadd asub amul).
Notation base_diff := (MosaicChecker.base_diff A asub amul).

Definition rp (p : spot) : point := scale (/ phi (weight p)) (phi3 (numerators p)).
Definition pos (p : spot) : Prop := 0 < phi (weight p).
Definition rtet (t : corners) : tetrahedron := let '(a, b, c, d) := t in Tetrahedron (rp a) (rp b) (rp c) (rp d).
Definition rtri (f : spots) : triangle := let '(a, b, c) := f in Triangle (rp a) (rp b) (rp c).
Definition rpatch (p : kpatch) : patch :=
  Patch (map (fun e => Edge (fst e) (rp (snd e))) (k_edges A p)) (map (fun y => Pyramid (rp (fst y)) (map rp (snd y))) (k_pyramids A p)) (map rtet (k_pieces A p)).

Lemma phi_zero : phi zero = 0.
Proof. apply phi_Z. Qed.
Lemma aeq_ok x y : aeq x y = true -> phi x = phi y.
Proof. unfold MosaicChecker.aeq. rewrite andb_true_iff. intros [H K]. apply ale_ok in H, K. lra. Qed.
Lemma veq_ok u v : veq u v = true -> phi3 u = phi3 v.
Proof. unfold MosaicChecker.veq. rewrite !andb_true_iff. intros [[X Y] Z]. apply aeq_ok in X, Y, Z. unfold Soundness.phi3. congruence. Qed.
Lemma vtimes_ok w v : phi3 (vtimes w v) = scale (phi w) (phi3 v).
Proof. unfold Soundness.phi3, MosaicChecker.vtimes, scale; cbn. rewrite !phi_mul. reflexivity. Qed.
Lemma numerators_ok p : pos p -> phi3 (numerators p) = scale (phi (weight p)) (rp p).
Proof. intros P. unfold rp. set (v := phi3 _). unfold pos in P. apply point_eq; unf; field; lra. Qed.
Lemma rp_unique p x : pos p -> phi3 (numerators p) = scale (phi (weight p)) x -> rp p = x.
Proof. intros P E. unfold rp. rewrite E. unfold pos in P. apply point_eq; unf; field; lra. Qed.
Lemma spot_eq_ok p q : pos p -> pos q -> spot_eq p q = true -> rp p = rp q.
Proof.
  intros P Q. unfold MosaicChecker.spot_eq. destruct (aeq (weight p) (weight q)) eqn:E.
  - intros H. apply veq_ok in H. apply aeq_ok in E. unfold rp. rewrite H, E. reflexivity.
  - intros H. apply veq_ok in H. rewrite !vtimes_ok in H. apply rp_unique; auto. unfold rp. unfold pos in *. set (a := phi3 _) in *. set (b := phi3 _) in *.
    apply point_eq; [apply (f_equal px) in H|apply (f_equal py) in H|apply (f_equal pz) in H]; unf; apply Rmult_eq_reg_l with (phi (weight q)); try lra; rewrite H; field; lra.
Qed.
Lemma shifted_ok z w x : phi (shifted A aadd amul aofZ z w x) = phi x + IZR z * phi w.
Proof. unfold shifted. destruct (Z.eqb_spec z 0) as [->|]; [ring|]. rewrite phi_add, phi_mul, phi_Z. reflexivity. Qed.
Lemma lift_pos n p : pos p -> pos (spot_lift n p).
Proof. destruct n as [[? ?] ?]. auto. Qed.
Lemma lift_ok n p : pos p -> rp (spot_lift n p) = lift n (rp p).
Proof.
  intros P. destruct n as [[a b] c]. apply rp_unique; [exact P|]. cbn [MosaicChecker.spot_lift MosaicChecker.numerators MosaicChecker.weight].
  unfold Soundness.phi3; cbn [Checker.vX Checker.vY Checker.vZ]. rewrite !shifted_ok. unfold lift, rp, pt, Soundness.phi3. unfold pos in P. apply point_eq; unf; field; lra.
Qed.
Lemma even_ok l : Forall pos l -> l <> [] -> 0 < phi (fst (even l)) /\ map phi3 (snd (even l)) = map (fun p => scale (phi (fst (even l))) (rp p)) l.
Proof.
  induction l as [|p l IH]; [congruence|]. intros F _. inversion F as [|? ? P F']; subst. destruct l as [|q l].
  - cbn. split; [exact P|]. rewrite numerators_ok by auto. reflexivity.
  - destruct (IH F' ltac:(congruence)) as [W E]. cbn [MosaicChecker.even] in *. set (ev := MosaicChecker.even A amul aofZ ale (q :: l)) in *.
    change (match l with [] => (weight q, [numerators q]) | _ :: _ => _ end) with ev in *.
    assert (EV : even (p :: q :: l) = let '(w, vs) := ev in if aeq (weight p) w then (w, numerators p :: vs) else (amul (weight p) w, vtimes w (numerators p) :: map (vtimes (weight p)) vs)) by reflexivity.
    clearbody ev. destruct ev as [w vs]; cbn [fst snd] in *. destruct (aeq (weight p) w) eqn:Q; cbn [fst snd].
    + split; auto. cbn [map]. rewrite E. f_equal. apply aeq_ok in Q. rewrite numerators_ok, Q by auto. reflexivity.
    + rewrite phi_mul. split; [apply Rmult_lt_0_compat; auto|]. cbn [map]. f_equal.
      * rewrite vtimes_ok, numerators_ok by auto. apply point_eq; unf; ring.
      * rewrite map_map. transitivity (map (scale (phi (weight p))) (map phi3 vs)).
        -- rewrite map_map. apply map_ext. intros v. apply vtimes_ok.
        -- rewrite E. cbn [map]. rewrite map_map. f_equal; [apply point_eq; unf; ring|]. apply map_ext. intros v. apply point_eq; unf; ring.
Qed.
Lemma reduce_ok p : pos p -> pos (reduce p) /\ rp (reduce p) = rp p.
Proof.
  intros P. unfold MosaicChecker.reduce. cbv zeta. set (g := content _). destruct (Z.leb_spec g 1) as [L|L]; [auto|].
  set (p' := Spot _ _). match goal with |- context [if ?c then _ else _] => destruct c eqn:E end; [|auto].
  apply andb_true_iff in E as [E1 E2]. apply aeq_ok in E1. apply veq_ok in E2. rewrite phi_mul, phi_Z in E1. rewrite vtimes_ok, phi_Z in E2.
  assert (G : 0 < IZR g) by (apply IZR_lt; lia). assert (P' : pos p') by (unfold pos in *; apply Rmult_lt_reg_l with (IZR g); auto; lra).
  split; auto. apply rp_unique; auto. unfold rp. rewrite <- E2, <- E1. unfold pos in P'. apply point_eq; unf; field; lra.
Qed.
Lemma no_spot_pos : pos no_spot.
Proof. unfold pos, MosaicChecker.no_spot, one; cbn. rewrite phi_Z. lra. Qed.
Lemma no_spot_ok : rp no_spot = origin.
Proof. apply rp_unique; [apply no_spot_pos|]. unfold Soundness.phi3, MosaicChecker.no_spot, vzero, Checker.zero, origin, one; cbn. rewrite !phi_Z. apply point_eq; unf; ring. Qed.

(** ** Tetrahedra *)
Notation tet_of := (MosaicChecker.tet_of A amul aofZ ale).
Notation tet_and := (MosaicChecker.tet_and A amul aofZ ale).
Definition tet_pos (t : corners) : Prop := Forall pos (corner_list t).
Lemma tet_of_ok t : tet_pos t -> exists k, 0 < k /\ phiT (tet_of t) = map_tet (scale k) (rtet t).
Proof.
  intros P. destruct (even_ok _ P) as [W E]; [destruct t as [[[? ?] ?] ?]; discriminate|]. exists (phi (fst (even (corner_list t)))). split; auto.
  unfold MosaicChecker.tet_of. destruct t as [[[a b] c] d]. set (w := phi (fst _)) in *. clearbody w. cbn [MosaicChecker.corner_list map] in *.
  destruct (snd (even [a; b; c; d])) as [|v0 [|v1 [|v2 [|v3 [|? ?]]]]]; try discriminate. cbn [map] in E.
  apply cons_inj in E as [E0 E]. apply cons_inj in E as [E1 E]. apply cons_inj in E as [E2 E]. apply cons_inj in E as [E3 _].
  unfold Soundness.phiT, map_tet; cbn [ka kb kc kd rtet va vb vc vd]. rewrite E0, E1, E2, E3. reflexivity.
Qed.
Lemma tet_and_ok t x : tet_pos t -> pos x -> exists k, 0 < k /\ phiT (fst (tet_and t x)) = map_tet (scale k) (rtet t) /\ phi3 (snd (tet_and t x)) = scale k (rp x).
Proof.
  intros P X. destruct (even_ok (x :: corner_list t)) as [W E]; [constructor; auto|discriminate|]. exists (phi (fst (even (x :: corner_list t)))). split; auto.
  unfold MosaicChecker.tet_and. destruct t as [[[a b] c] d]. set (w := phi (fst _)) in *. clearbody w. cbn [MosaicChecker.corner_list map] in *.
  destruct (snd (even [x; a; b; c; d])) as [|v [|v0 [|v1 [|v2 [|v3 [|? ?]]]]]]; try discriminate. cbn [map] in E.
  apply cons_inj in E as [E' E]. apply cons_inj in E as [E0 E]. apply cons_inj in E as [E1 E]. apply cons_inj in E as [E2 E]. apply cons_inj in E as [E3 _].
  unfold Soundness.phiT, map_tet; cbn [fst snd ka kb kc kd rtet va vb vc vd]. rewrite E0, E1, E2, E3, E'. split; reflexivity.
Qed.
Lemma scale_orient k a b c d : orient (scale k a) (scale k b) (scale k c) (scale k d) = k * k * k * orient a b c d.
Proof. unf. ring. Qed.
Lemma scale_coord k t i x : coord (map_tet (scale k) t) i (scale k x) = k * k * k * coord t i x.
Proof. unfold coord, side. rewrite facet_map. apply scale_orient. Qed.
Lemma cube_pos k : 0 < k -> 0 < k * k * k.
Proof. intros. repeat apply Rmult_lt_0_compat; auto. Qed.
Lemma positive_tet_ok t : tet_pos t -> positive_tet A aadd asub amul aofZ alt ale t = true -> 0 < vol (rtet t).
Proof.
  intros P H. destruct (tet_of_ok t P) as [k [K E]]. unfold positive_tet, chk_vol in H. apply alt_ok in H. rewrite phi_zero in H.
  pose proof (phi_D A aadd asub amul phi phi_add phi_sub phi_mul (ka A (tet_of t)) (kb A (tet_of t)) (kc A (tet_of t)) (kd A (tet_of t))) as D.
  change (orient _ _ _ _) with (vol (phiT (tet_of t))) in D. rewrite D, E in H.
  pose proof (scale_orient k (va (rtet t)) (vb (rtet t)) (vc (rtet t)) (vd (rtet t))) as S.
  change (vol (map_tet (scale k) (rtet t)) = k * k * k * vol (rtet t)) in S. rewrite S in H. pose proof (cube_pos k K). nra.
Qed.
Lemma coord_ok t x : tet_pos t -> pos x -> exists k, 0 < k /\ forall i, phi (kL (fst (tet_and t x)) i (snd (tet_and t x))) = k * coord (rtet t) i (rp x).
Proof.
  intros P X. destruct (tet_and_ok t x P X) as [k [K [E1 E2]]]. exists (k * k * k). split; [apply cube_pos, K|]. intros j.
  rewrite (phi_L A aadd asub amul phi phi_add phi_sub phi_mul), E1, E2. apply scale_coord.
Qed.
Lemma inside_ok t x : tet_pos t -> pos x -> (let '(t, y) := tet_and t x in forallb (fun i => alt zero (kL t i y)) I4) = true -> inside (rtet t) (rp x).
Proof.
  intros P X. destruct (coord_ok t x P X) as [k [K C]]. destruct (tet_and t x) as [t' y]; cbn [fst snd] in C. rewrite forallb_forall. intros H i Hi.
  specialize (H i Hi). apply alt_ok in H. rewrite phi_zero, C in H. nra.
Qed.
Lemma is_outside_ok t x : tet_pos t -> pos x -> is_outside A aadd asub amul aofZ alt ale t x = true -> ~ closed (rtet t) (rp x).
Proof.
  intros P X. destruct (coord_ok t x P X) as [k [K C]]. unfold is_outside. destruct (tet_and t x) as [t' y]; cbn [fst snd] in C. rewrite existsb_exists. intros [i [Hi H]] Q.
  apply alt_ok in H. rewrite phi_zero, C in H. specialize (Q i Hi). nra.
Qed.

(** ** A patch and its real coordinates *)
Variables (g : kgram A) (r : nat).
Hypothesis rank : r = 1%nat \/ r = 2%nat.
Notation G := (phiG g).
Notation side_form := (MosaicChecker.side_form A asub amul aofZ r).
Notation k_carry := (MosaicChecker.k_carry A aadd asub amul aofZ ale content quot g r).
Definition positive_patch (p : kpatch) : Prop :=
  (forall s, pos (k_start p s)) /\ (forall q, pos (k_apex p q)) /\ (forall q e, pos (k_rim_at p q e)) /\ (forall k, tet_pos (k_piece p k)).
Lemma edge_ok p s : edge_at (rpatch p) s = Edge (k_class p s) (rp (k_start p s)).
Proof.
  unfold edge_at, rpatch; cbn [edges]. rewrite <- no_spot_ok. exact (map_nth (fun e => Edge (fst e) (rp (snd e))) (k_edges A p) (0%Z, no_spot) s).
Qed.
Lemma sides_ok p : sides (rpatch p) = k_sides p.
Proof. unfold sides, rpatch; cbn [edges]. apply map_length. Qed.
Lemma pyramid_ok p q : pyramid_at (rpatch p) q = Pyramid (rp (k_apex p q)) (map rp (k_rim p q)).
Proof.
  unfold pyramid_at, rpatch; cbn [pyramids]. replace no_pyramid with (Pyramid (rp (fst (no_spot, @nil spot))) (map rp (snd (no_spot, @nil spot)))) by (cbn [fst snd map]; rewrite no_spot_ok; reflexivity).
  exact (map_nth (fun y => Pyramid (rp (fst y)) (map rp (snd y))) (k_pyramids A p) (no_spot, []) q).
Qed.
Lemma apex_ok p q : apex_at (rpatch p) q = rp (k_apex p q).
Proof. unfold apex_at. rewrite pyramid_ok. reflexivity. Qed.
Lemma rim_count_ok p q : rim_count (rpatch p) q = k_rim_count p q.
Proof. unfold rim_count. rewrite pyramid_ok. cbn [rim]. apply map_length. Qed.
Lemma rim_ok p q e : rim_at (rpatch p) q e = rp (k_rim_at p q e).
Proof. unfold rim_at. rewrite pyramid_ok. cbn [rim]. rewrite <- no_spot_ok. apply map_nth. Qed.
Lemma piece_ok p k : piece_at (rpatch p) k = rtet (k_piece p k).
Proof.
  unfold piece_at, rpatch; cbn [pieces]. replace no_tet with (rtet (no_spot, no_spot, no_spot, no_spot)) by (unfold rtet; rewrite no_spot_ok; reflexivity). apply map_nth.
Qed.
Lemma facet_ok t f : rtri (k_facet A t f) = facet (rtet t) f.
Proof. destruct t as [[[? ?] ?] ?], f as [|[|[|f]]]; reflexivity. Qed.
Lemma triangle_ok p o : rtri (k_triangle p o) = triangle_of (rpatch p) o.
Proof. destruct o as [k f|q e]; cbn [MosaicChecker.k_triangle triangle_of]; [rewrite piece_ok; apply facet_ok|]. rewrite !rim_ok, apex_ok, rim_count_ok. reflexivity. Qed.
Lemma occupant_ok p o : k_occupant p o = true <-> is_occupant (rpatch p) o.
Proof.
  destruct o as [k f|q e]; cbn [MosaicChecker.k_occupant is_occupant]; rewrite andb_true_iff, !Nat.ltb_lt; unfold rpatch at 1; cbn [pieces pyramids]; rewrite map_length; [reflexivity|].
  rewrite rim_count_ok. reflexivity.
Qed.
Lemma occupants_In p o : is_occupant (rpatch p) o -> In o (occupants p).
Proof.
  intros H. apply occupant_ok in H. unfold MosaicChecker.occupants. rewrite in_app_iff, !in_flat_map. destruct o as [k f|s e]; cbn [MosaicChecker.k_occupant] in H; rewrite andb_true_iff, !Nat.ltb_lt in H; destruct H as [H1 H2].
  - left. exists k. split; [apply in_seq; lia|]. apply in_map. cbn. lia.
  - right. exists s. split; [apply in_seq; lia|]. apply in_map, in_seq. lia.
Qed.
Lemma opposite_ok f f' : (let '(a, b, c) := f in pos a /\ pos b /\ pos c) -> (let '(a, b, c) := f' in pos a /\ pos b /\ pos c) ->
  spots_opposite A amul ale f f' = true -> opposite (rtri f) (rtri f').
Proof.
  destruct f as [[a b] c], f' as [[a' b'] c']. intros [P1 [P2 P3]] [Q1 [Q2 Q3]]. unfold spots_opposite, spots_eq. rewrite !orb_true_iff, !andb_true_iff.
  unfold opposite, rtri; cbn [t1 t2 t3].
  intros [[[[X Y] Z]|[[X Y] Z]]|[[X Y] Z]]; apply spot_eq_ok in X, Y, Z; auto; rewrite X, Y, Z; auto.
Qed.
Lemma triangle_pos p o : positive_patch p -> let '(a, b, c) := k_triangle p o in pos a /\ pos b /\ pos c.
Proof.
  intros [_ [PA [PR PP]]]. destruct o as [k f|q e]; cbn [MosaicChecker.k_triangle]; auto.
  specialize (PP k). unfold tet_pos in PP. destruct (k_piece p k) as [[[a b] c] d]. cbn [MosaicChecker.corner_list] in PP.
  rewrite Forall_forall in PP. destruct f as [|[|[|f]]]; cbn [k_facet]; repeat split; apply PP; cbn; auto.
Qed.

Lemma finish_ok p s : r = 1%nat -> finish r (rpatch p) s = Point (px (rp (k_start p s))) (py (rp (k_start p (next (k_sides p) s)))) (pz (rp (k_start p (next (k_sides p) s)))).
Proof. intros E. unfold finish. rewrite E, !edge_ok, sides_ok. reflexivity. Qed.
Lemma left_ok p s : positive_patch p -> exists k, 0 < k /\ forall x, pos x -> phi (k_left (side_form p s) x) = k * phi (weight x) * left_of r (rpatch p) s (rp x).
Proof.
  intros [PS _]. pose proof (PS s) as P. pose proof (PS (next (k_sides p) s)) as Q. unfold pos in P, Q.
  destruct rank as [R|R].
  - exists (phi (weight (k_start p s)) * phi (weight (k_start p (next (k_sides p) s)))). split; [apply Rmult_lt_0_compat; auto|]. intros x X. unfold pos in X.
    unfold MosaicChecker.side_form, left_of. rewrite finish_ok by auto. rewrite R, edge_ok. cbn [start px py pz]. unfold MosaicChecker.k_left.
    rewrite !phi_add, !phi_mul, !phi_sub, !phi_mul. unfold rp, scale, Soundness.phi3; cbn [px py pz]. field. lra.
  - exists (phi (weight (k_start p s))). split; auto. intros x X. unfold pos in X. unfold MosaicChecker.side_form, left_of. rewrite R, edge_ok. cbn [start].
    destruct s; unfold MosaicChecker.k_left; rewrite !phi_add, !phi_mul, ?phi_sub, phi_zero; unfold rp, scale, Soundness.phi3; cbn [px py pz]; field; lra.
Qed.
Lemma in_prism_ok p x : positive_patch p -> pos x -> k_in_prism A aadd amul aofZ ale (side_forms A asub amul aofZ r p) x = true -> in_prism r (rpatch p) (rp x).
Proof.
  intros PP X. unfold k_in_prism, side_forms. rewrite forallb_forall. intros H s Hs. rewrite sides_ok in Hs.
  specialize (H (side_form p s) ltac:(apply in_map, in_seq; lia)). apply ale_ok in H. rewrite phi_zero in H.
  destruct (left_ok p s PP) as [k [K E]]. rewrite E in H by auto. unfold pos in X. pose proof (Rmult_lt_0_compat _ _ K X). nra.
Qed.
Lemma left_sign p s x : positive_patch p -> pos x -> alt zero (k_left (side_form p s) x) = true -> 0 < left_of r (rpatch p) s (rp x).
Proof.
  intros PP X H. apply alt_ok in H. rewrite phi_zero in H. destruct (left_ok p s PP) as [k [K E]]. rewrite E in H by auto. unfold pos in X. pose proof (Rmult_lt_0_compat _ _ K X). nra.
Qed.

(** ** Carrying *)
Definition len (p : kpatch) (s : nat) : R * R := (phi (base_dot A aadd amul g (base_diff (k_start p s) (k_start p (next (k_sides p) s))) (base_diff (k_start p s) (k_start p (next (k_sides p) s)))),
  phi (weight (k_start p s)) * phi (weight (k_start p (next (k_sides p) s)))).
Lemma length_ok p s : positive_patch p -> r = 1%nat -> length2 G r (rpatch p) s = fst (len p s) / (snd (len p s) * snd (len p s)).
Proof.
  intros [PS _] R. pose proof (PS s) as P. pose proof (PS (next (k_sides p) s)) as Q. unfold pos in P, Q.
  unfold length2, along, len. rewrite finish_ok, edge_ok by auto. unfold MosaicChecker.base_dot, MosaicChecker.base_diff; cbn [fst snd start px py pz sub].
  repeat rewrite ?phi_add, ?phi_mul, ?phi_sub. unfold rp, scale, Soundness.phi3, Soundness.phiG; cbn [px py pz g22 g33 g23]. field. lra.
Qed.
Lemma fits_ok p s q s' : positive_patch p -> positive_patch q -> can_meet A aofZ r p s q s' = true -> same_length A aadd asub amul aofZ alt ale g r p s q s' = true ->
  fits G r (rpatch p) s (rpatch q) s' /\ (r = 1%nat -> 0 < fst (len p s)).
Proof.
  intros PP PQ C L. unfold can_meet in C. apply andb_true_iff in C as [C1 C2]. apply Z.eqb_eq in C1. unfold fits. rewrite !edge_ok. cbn [class].
  assert (NR : forall x, 0 < x -> x <> 0) by (intros; lra).
  assert (L' : r = 1%nat -> 0 < fst (len p s) /\ fst (len p s) * (snd (len q s') * snd (len q s')) = fst (len q s') * (snd (len p s) * snd (len p s))).
  { intros R. unfold same_length in L. rewrite R in L. cbn [Nat.eqb] in L. apply andb_true_iff in L as [L1 L2]. apply alt_ok in L1. apply aeq_ok in L2.
    rewrite phi_zero in L1. rewrite !phi_mul in L2. split; auto. }
  split; [|intros R; apply L', R]. split; [exact C1|]. split.
  - intros R E. rewrite R in C2. cbn [Nat.eqb] in C2. subst s'. rewrite Nat.eqb_refl in C2. discriminate.
  - intros R. destruct (L' R) as [L1 L2]. rewrite !length_ok by auto.
    assert (P1 : 0 < snd (len p s)) by (unfold len; cbn [snd]; apply Rmult_lt_0_compat; apply PP).
    assert (P2 : 0 < snd (len q s')) by (unfold len; cbn [snd]; apply Rmult_lt_0_compat; apply PQ).
    assert (P3 : 0 < snd (len p s) * snd (len p s)) by (apply Rmult_lt_0_compat; auto). assert (P4 : 0 < snd (len q s') * snd (len q s')) by (apply Rmult_lt_0_compat; auto).
    split.
    + apply Rmult_eq_reg_r with ((snd (len p s) * snd (len p s)) * (snd (len q s') * snd (len q s'))); [|apply NR, Rmult_lt_0_compat; auto].
      transitivity (fst (len p s) * (snd (len q s') * snd (len q s'))); [field; lra|]. rewrite L2. field. lra.
    + apply NR. apply Rdiv_lt_0_compat; auto.
Qed.
Lemma carry_ok p s q s' x : positive_patch p -> positive_patch q -> pos x -> (r = 1%nat -> 0 < fst (len p s)) ->
  pos (k_carry p s q s' x) /\ rp (k_carry p s q s' x) = carry G r (rpatch p) s (rpatch q) s' (rp x).
Proof.
  intros PP PQ X L. pose proof (proj1 PP s) as P1. pose proof (proj1 PP (next (k_sides p) s)) as P2. pose proof (proj1 PQ s') as Q1. pose proof (proj1 PQ (next (k_sides q) s')) as Q2.
  unfold MosaicChecker.k_carry, carry. destruct rank as [R|R].
  - rewrite R at 1 2 3. specialize (L R). rewrite (length_ok p s PP R). unfold along. rewrite !finish_ok, !edge_ok by auto. cbn [start].
    unfold len in *; cbn [fst snd] in *. set (U := base_diff (k_start p s) (k_start p (next (k_sides p) s))) in *. set (V := base_diff (k_start q s') (k_start q (next (k_sides q) s'))) in *.
    unfold pos in X, P1, P2, Q1, Q2. set (n := base_dot A aadd amul g U U) in *.
    match goal with |- pos (MosaicChecker.reduce _ _ _ _ _ _ ?y) /\ _ => destruct (reduce_ok y) as [RP RE] end.
    { unfold pos; cbn [MosaicChecker.weight]. rewrite !phi_mul. repeat apply Rmult_lt_0_compat; auto. }
    split; [exact RP|]. rewrite RE. clear RP RE. apply rp_unique.
    { unfold pos; cbn [MosaicChecker.weight]. rewrite !phi_mul. repeat apply Rmult_lt_0_compat; auto. }
    unfold Soundness.phi3 at 1; cbn [MosaicChecker.weight MosaicChecker.numerators Checker.vX Checker.vY Checker.vZ].
    assert (UE : phi (fst U) = phi (weight (k_start p s)) * phi (vY (numerators (k_start p (next (k_sides p) s)))) - phi (weight (k_start p (next (k_sides p) s))) * phi (vY (numerators (k_start p s)))) by (unfold U, MosaicChecker.base_diff; cbn [fst]; rewrite phi_sub, !phi_mul; reflexivity).
    assert (UE' : phi (snd U) = phi (weight (k_start p s)) * phi (vZ (numerators (k_start p (next (k_sides p) s)))) - phi (weight (k_start p (next (k_sides p) s))) * phi (vZ (numerators (k_start p s)))) by (unfold U, MosaicChecker.base_diff; cbn [snd]; rewrite phi_sub, !phi_mul; reflexivity).
    assert (VE : phi (fst V) = phi (weight (k_start q s')) * phi (vY (numerators (k_start q (next (k_sides q) s')))) - phi (weight (k_start q (next (k_sides q) s'))) * phi (vY (numerators (k_start q s')))) by (unfold V, MosaicChecker.base_diff; cbn [fst]; rewrite phi_sub, !phi_mul; reflexivity).
    assert (VE' : phi (snd V) = phi (weight (k_start q s')) * phi (vZ (numerators (k_start q (next (k_sides q) s')))) - phi (weight (k_start q (next (k_sides q) s'))) * phi (vZ (numerators (k_start q s')))) by (unfold V, MosaicChecker.base_diff; cbn [snd]; rewrite phi_sub, !phi_mul; reflexivity).
    clearbody n. clear PP PQ.
    unfold MosaicChecker.base_dot, MosaicChecker.base_turn, MosaicChecker.base_diff; cbn [fst snd].
    unfold rp, scale, sub, Soundness.phiG; cbn [px py pz g22 g33 g23]. unfold Soundness.phi3; cbn [px py pz].
    repeat rewrite ?phi_add, ?phi_mul, ?phi_sub, ?phi_zero. rewrite UE, UE', VE, VE'.
    apply point_eq; cbn [px py pz]; field; lra.
  - rewrite R at 1 2. match goal with |- pos (MosaicChecker.reduce _ _ _ _ _ _ ?y) /\ _ => destruct (reduce_ok y) as [RP RE] end.
    { unfold pos in *; cbn [MosaicChecker.weight]. rewrite !phi_mul. repeat apply Rmult_lt_0_compat; auto. }
    split; [exact RP|]. rewrite RE. clear RP RE. apply rp_unique.
    { unfold pos in *; cbn [MosaicChecker.weight]. rewrite !phi_mul. repeat apply Rmult_lt_0_compat; auto. }
    rewrite R, !edge_ok. cbn [start]. unfold Soundness.phi3 at 1; cbn [MosaicChecker.weight MosaicChecker.numerators Checker.vX Checker.vY Checker.vZ].
    unfold pos in *. unfold rp, scale, sub, add, Soundness.phi3; cbn [px py pz]. repeat rewrite ?phi_add, ?phi_mul, ?phi_sub. apply point_eq; cbn [px py pz]; field; lra.
Qed.

(** ** The checks *)
Section System.
Variables (system : list kpatch) (h : hints) (apexes : nat -> nat -> list spot) (home : nat -> nat * spot).
Notation k_patch := (MosaicChecker.k_patch A system).
Notation rsystem := (map rpatch system).
Notation patch_at a := (nth a rsystem (Patch [] [] [])).
Notation can_meet := (MosaicChecker.can_meet A aofZ r).
Notation lateral := (MosaicChecker.lateral A aofZ).
Hypothesis CHECKED : check_system A aadd asub amul aofZ alt ale content quot g r system h apexes home = true.

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

(** ** Delaunay *)
Notation choices := (MosaicChecker.choices A aofZ apexes).
Notation k_cell := (MosaicChecker.k_cell A aofZ).
Notation k_opposite := (MosaicChecker.k_opposite A aofZ).
Notation outside_ball := (MosaicChecker.outside_ball A aadd asub amul aofZ ale g).
Lemma scale_gdot k u v : gdot G (scale k u) (scale k v) = k * k * gdot G u v.
Proof. unfold gdot. unf. ring. Qed.
Lemma scale_power k t x : power_sum G (map_tet (scale k) t) (scale k x) = k * k * k * (k * k) * power_sum G t x.
Proof.
  unfold power_sum, sq. cbn [map_tet va vb vc vd]. rewrite !scale_coord.
  assert (S : forall a b, sub (scale k a) (scale k b) = scale k (sub a b)) by (intros; apply point_eq; unf; ring).
  rewrite !S, !scale_gdot. ring.
Qed.
Lemma outside_ok (less : A -> A -> bool) (strict : bool) t x : (forall a b, less a b = true -> if strict then phi a < phi b else phi a <= phi b) ->
  tet_pos t -> pos x -> 0 < vol (rtet t) -> outside_ball less t x = true -> outside G strict (rtet t) (rp x).
Proof.
  intros LE P X V. destruct (tet_and_ok t x P X) as [k [K [E1 E2]]]. unfold MosaicChecker.outside_ball. destruct (tet_and t x) as [t' y]; cbn [fst snd] in *. intros H. apply LE in H.
  rewrite phi_zero, (phi_power A aadd asub amul phi phi_add phi_sub phi_mul), E1, E2, scale_power in H.
  pose proof (power_power_sum G (rtet t) (rp x) ltac:(lra)) as PP. assert (C : 0 < k * k * k * (k * k)) by (repeat apply Rmult_lt_0_compat; auto).
  unfold outside. destruct strict.
  - assert (power_sum G (rtet t) (rp x) < 0) by nra. apply Rmult_lt_reg_l with (vol (rtet t)); auto. rewrite PP. lra.
  - assert (power_sum G (rtet t) (rp x) <= 0) by nra. apply Rmult_le_reg_l with (vol (rtet t)); auto. rewrite PP. lra.
Qed.
Section Local.
Variables (less : A -> A -> bool) (strict : bool).
Hypothesis LESS : forall a b, less a b = true -> if strict then phi a < phi b else phi a <= phi b.
Hypothesis DEL : check_delaunay A aadd asub amul aofZ ale content quot g r system h apexes less = true.
Lemma cell_facts a o y : (a < length rsystem)%nat -> k_occupant (k_patch a) o = true -> In y (choices a o) ->
  tet_pos (k_cell (k_patch a) o y) /\ pos (k_opposite (k_patch a) o y) /\ 0 < vol (rtet (k_cell (k_patch a) o y)) /\
  rtet (k_cell (k_patch a) o y) = cell_of (rpatch (k_patch a)) o (rp y) /\ rp (k_opposite (k_patch a) o y) = opposite_of (rpatch (k_patch a)) o (rp y).
Proof.
  intros Ha Ho Hy. destruct (positive_ok a Ha) as [PP PY]. destruct o as [k f|q e]; cbn [MosaicChecker.k_occupant] in Ho; rewrite andb_true_iff, !Nat.ltb_lt in Ho; destruct Ho as [H1 H2];
  cbn [MosaicChecker.k_cell MosaicChecker.k_opposite cell_of opposite_of MosaicChecker.choices] in *.
  - destruct PP as [_ [_ [_ PT]]]. specialize (PT k). rewrite piece_ok. split; [exact PT|].
    pose proof (good_pieces _ _ _ _ system_good a k Ha ltac:(rewrite pieces_length; exact H1)) as [V _]. rewrite patch_ok, piece_ok in V.
    unfold tet_pos in PT. rewrite Forall_forall in PT. destruct (k_piece (k_patch a) k) as [[[x1 x2] x3] x4].
    split; [destruct f as [|[|[|f]]]; cbn [k_corner]; apply PT; cbn; auto|]. split; [exact V|]. split; [reflexivity|]. destruct f as [|[|[|f]]]; reflexivity.
  - split; [apply join_pos; auto|]. split; [eapply PY; eauto|]. split; [|split; [apply lateral_ok|reflexivity]].
    destruct (pyramid_checked a q Ha H1) as [_ C]. unfold check_joins in C. cbv zeta in C. rewrite forallb_forall in C. specialize (C y Hy). apply andb_true_iff in C as [C _].
    apply positive_tet_ok; [apply join_pos; auto|]. apply (upto_ok _ _ C e H2).
Qed.
Lemma side_lt a q : (a < length rsystem)%nat -> (q < length (k_pyramids A (k_patch a)))%nat -> (side_of h a q < k_sides (k_patch a))%nat.
Proof. intros Ha Hq. pose proof (good_pyramids _ _ _ _ system_good a q Ha ltac:(rewrite pyramids_length; exact Hq)) as [K _]. rewrite sides_length in K. exact K. Qed.
Lemma choice_in a o y : (a < length rsystem)%nat -> k_occupant (k_patch a) o = true -> is_choice G r rsystem h a o y -> exists y', In y' (choices a o) /\
  cell_of (rpatch (k_patch a)) o y = cell_of (rpatch (k_patch a)) o (rp y') /\ opposite_of (rpatch (k_patch a)) o y = opposite_of (rpatch (k_patch a)) o (rp y').
Proof.
  intros Ha Ho. destruct o as [k f|q e]; cbn [is_choice MosaicChecker.choices cell_of opposite_of].
  - intros _. exists no_spot. split; [cbn; auto|]. split; reflexivity.
  - intros [b [s' [Hb [Hs' [FT K]]]]]. cbn [MosaicChecker.k_occupant] in Ho. rewrite andb_true_iff, !Nat.ltb_lt in Ho. destruct Ho as [Hq He]. rewrite sides_length in Hs'.
    pose proof (choice_ok a q b s' Ha Hb Hq (side_lt a q Ha Hq) Hs' FT) as CH. destruct (pyramid_mate h a q b s') as [q' m]. destruct CH as [y' [Hy' E]]. exists y'. split; auto.
    rewrite K, E. auto.
Qed.
Lemma local_ok a o : (a < length rsystem)%nat -> is_occupant (patch_at a) o -> good_local G r rsystem h strict a o.
Proof.
  intros Ha Ho. rewrite patch_ok in Ho. pose proof Ho as Ho'. apply occupant_ok in Ho'. pose proof (upto_ok _ _ DEL a ltac:(rewrite map_length in Ha; exact Ha)) as C. cbv zeta in C. apply andb_true_iff in C as [C _].
  rewrite forallb_forall in C. specialize (C o (occupants_In _ _ Ho)). unfold check_local in C. cbv zeta in C. unfold good_local. cbv zeta. rewrite patch_ok.
  pose proof (good_occupants _ _ _ _ system_good a o Ha ltac:(rewrite patch_ok; exact Ho)) as GO. unfold good_occupant in GO. cbv zeta in GO. rewrite patch_ok in GO.
  destruct (behind h a o) as [o' n|s w].
  - destruct GO as [GO [L _]]. apply occupant_ok in GO. intros y y' CH CH'. destruct (choice_in a o y Ha Ho' CH) as [z [Hz [E1 _]]]. destruct (choice_in a o' y' Ha GO CH') as [z' [Hz' [_ E2]]].
    rewrite E1, E2. destruct (cell_facts a o z Ha Ho' Hz) as [F1 [_ [F2 [F3 _]]]]. destruct (cell_facts a o' z' Ha GO Hz') as [_ [F4 [_ [_ F5]]]].
    rewrite <- F3, <- F5, <- lift_ok by auto. rewrite forallb_forall in C. specialize (C z Hz). rewrite forallb_forall in C. apply (outside_ok less); auto using lift_pos.
  - destruct o as [k f|]; [|exact I]. destruct GO as [Hs [Hw _]]. rewrite sides_ok in Hs. intros b s' Hb Hs' FT. rewrite sides_length in Hs'.
    pose proof (fits_meet a s b s' ltac:(rewrite patch_ok; exact FT)) as CM. destruct (pair_fits a s b s' Ha Hb Hs Hs' CM) as [_ CO]. rewrite patch_ok in CO.
    pose proof (good_pairs _ _ _ _ system_good a s b s' Ha Hb ltac:(rewrite sides_length; exact Hs) ltac:(rewrite sides_length; exact Hs') ltac:(rewrite patch_ok; exact FT)) as [_ GP].
    specialize (GP w Hw). pose proof (upto_ok _ _ C b ltac:(rewrite map_length in Hb; exact Hb)) as C2. cbv zeta in C2. pose proof (upto_ok _ _ C2 s' Hs') as C3. cbv beta in C3. rewrite CM in C3.
    destruct (wall_mate h a s b s' w) as [w' m]. destruct GP as [Hw' _]. destruct (good_walls _ _ _ _ system_good b s' w' Hb ltac:(rewrite sides_length; exact Hs') Hw') as [GW _]. rewrite patch_ok in GW.
    destruct (owner h b s' w') as [k' f'|]; [|exact I]. apply occupant_ok in GW.
    destruct (cell_facts b (Facet k' f') no_spot Hb GW ltac:(cbn; auto)) as [_ [F4 [_ [_ F5]]]]. destruct (cell_facts a (Facet k f) no_spot Ha Ho' ltac:(cbn; auto)) as [F1 [_ [F2 [F3 _]]]].
    cbn [MosaicChecker.k_cell MosaicChecker.k_opposite cell_of opposite_of] in *. destruct (CO _ F4) as [P E]. rewrite patch_ok in E |- *. rewrite F5 in E.
    rewrite <- F3, <- E, <- lift_ok by auto. apply (outside_ok less); auto using lift_pos.
Qed.
Lemma axis_ok a q e : (a < length rsystem)%nat -> (q < length (pyramids (patch_at a)))%nat -> (e < rim_count (patch_at a) q)%nat -> good_axis G r rsystem h strict a q e.
Proof.
  intros Ha Hq He. rewrite pyramids_length in Hq. rewrite patch_ok, rim_count_ok in He. pose proof (upto_ok _ _ DEL a ltac:(rewrite map_length in Ha; exact Ha)) as C. cbv zeta in C. apply andb_true_iff in C as [_ C].
  pose proof (upto_ok _ _ C q Hq) as K. unfold check_axes in K. cbv zeta in K. rewrite forallb_forall in K. unfold good_axis. cbv zeta. intros y CH.
  assert (Ho : k_occupant (k_patch a) (Lateral q e) = true) by (cbn [MosaicChecker.k_occupant]; rewrite andb_true_iff, !Nat.ltb_lt; auto).
  destruct (choice_in a (Lateral q e) y Ha Ho CH) as [z [Hz [_ E]]]. cbn [opposite_of MosaicChecker.choices] in E, Hz. subst y.
  destruct (cell_facts a (Lateral q e) z Ha Ho Hz) as [F1 [_ [F2 [F3 _]]]]. cbn [MosaicChecker.k_cell cell_of] in F1, F2, F3.
  pose proof (upto_ok _ _ (K z Hz) e He) as K2. cbv beta in K2. apply andb_true_iff in K2 as [K3 K4]. rewrite patch_ok, rim_count_ok, !rim_ok, <- F3. destruct (positive_ok a Ha) as [[_ [_ [PR _]]] _].
  split; apply (outside_ok less); auto.
Qed.
End Local.

(** ** Single cells *)
Definition moved (k : R) (u x : point) : point := add (scale k x) u.
Lemma moved_sub k u x y : sub (moved k u x) (moved k u y) = scale k (sub x y).
Proof. unfold moved. apply point_eq; unf; ring. Qed.
Lemma scale_dot k u v : dot (scale k u) (scale k v) = k * k * dot u v.
Proof. unfold dot. unf. ring. Qed.
Lemma scale_quotient c a b : c <> 0 -> c * a / (c * b) = a / b.
Proof.
  intros K. unfold Rdiv. rewrite Rinv_mult. replace (c * a * (/ c * / b)) with (c * / c * (a * / b)) by ring. rewrite Rinv_r by auto. ring.
Qed.
Lemma moved_dihedral k u a b c d : 0 < k -> dihedral (moved k u a) (moved k u b) (moved k u c) (moved k u d) = dihedral a b c d.
Proof.
  intros K. assert (K2 : k * k <> 0) by (apply Rmult_integral_contrapositive_currified; lra).
  assert (P : forall e v, perp (scale k e) (scale k v) = scale k (perp e v)).
  { intros e v. unfold perp. rewrite !scale_dot, scale_quotient by auto. apply point_eq; unf; ring. }
  assert (N : forall v, norm (scale k v) = k * norm v).
  { intros v. unfold norm. rewrite scale_dot, sqrt_mult_alt by nra. rewrite sqrt_square by lra. reflexivity. }
  assert (AN : forall v w, angle (scale k v) (scale k w) = angle v w).
  { intros v w. unfold angle. f_equal. rewrite scale_dot, !N. replace (k * norm v * (k * norm w)) with (k * k * (norm v * norm w)) by ring. apply scale_quotient, K2. }
  unfold dihedral. rewrite !moved_sub, !P. apply AN.
Qed.
Lemma moved_dihedrals k u t : 0 < k -> dihedrals (map_tet (moved k u) t) = dihedrals t.
Proof. intros K. unfold dihedrals, map_tet; cbn [va vb vc vd]. rewrite !moved_dihedral by auto. reflexivity. Qed.
Lemma moved_ratio k u t q : 0 < k -> squared_ratio (map_tet (moved k u) t) q -> squared_ratio t q.
Proof.
  intros K [C [s [l [HC [[I U] ->]]]]]. assert (K2 : 0 < k * k) by (apply Rmult_lt_0_compat; auto). set (C' := scale (/ k) (sub C u)).
  assert (CE : C = moved k u C') by (unfold C', moved; apply point_eq; unf; field; lra).
  clearbody C'. subst C.
  assert (D : forall x y, distance_squared (moved k u x) (moved k u y) = k * k * distance_squared x y) by (intros; unfold distance_squared; rewrite moved_sub, scale_dot; reflexivity).
  assert (SE : squared_edges (map_tet (moved k u) t) = map (Rmult (k * k)) (squared_edges t)).
  { unfold squared_edges, map_tet; cbn [va vb vc vd map]. rewrite !D. reflexivity. }
  rewrite SE in I, U. apply in_map_iff in I as [l' [<- I]]. exists C', (s / (k * k)), l'. split; [|split].
  - intros v Hv. specialize (HC (moved k u v)). rewrite D in HC. apply Rmult_eq_reg_l with (k * k); [|lra]. rewrite HC; [field; lra|].
    unfold verts, map_tet in *; cbn [va vb vc vd In] in *. intuition (subst; auto).
  - split; [exact I|]. intros x Hx. apply Rmult_le_reg_l with (k * k); auto. apply U, in_map, Hx.
  - unfold Rdiv. rewrite Rinv_mult. ring.
Qed.

Section Alone.
Variables (l1 m2 m3 : point).
Hypothesis HG : has_gram G l1 m2 m3.
Variables (kt : corners) (i0 : point).
Hypothesis P : tet_pos kt.
(** The cell in space, from an origin. *)
Definition in_space : tetrahedron := map_tet (fun x => add i0 (at_coordinates l1 m2 m3 x)) (rtet kt).
Notation alone := (MosaicChecker.alone A g).
Notation c := (alone (tet_of kt)).
Hypothesis VOL : forallb (chk_vol A aadd asub amul aofZ alt) (positions A aadd aofZ c) = true.
Hypothesis GRAM : chk_gram A aadd asub amul aofZ alt g = true.
Lemma alone_based : based A aadd asub amul aofZ alt c.
Proof.
  split; [reflexivity|]. split; [|exact GRAM]. intros t Ht. rewrite forallb_forall in VOL. apply VOL. unfold positions. apply in_map, Ht.
Qed.
Lemma alone_tile n : is_tile 0 1 n -> exists k u, 0 < k /\ Statement.tile l1 m2 m3 (cP A aadd aofZ phi c l1 m2 m3) n = map_tet (moved k u) in_space.
Proof.
  destruct n as [j [[x y] z]]. intros [J [-> [-> ->]]]. cbn [fst] in J. replace j with 0%nat by lia.
  destruct (tet_of_ok kt P) as [k [K E]]. exists k, (scale (- k) i0). split; [exact K|].
  unfold Statement.tile, cP, Pk, cT. cbn [fst snd nth_error MosaicChecker.alone c_tets c_den c_verts].
  assert (PP : phiT (kpos A aadd aofZ 1 (kverts A (tet_of kt)) (CT (0%N, z30) (1%N, z30) (2%N, z30) (3%N, z30) None None None None)) = phiT (tet_of kt)).
  { unfold Soundness.phiT, kpos, Checker.pos; cbn [ka kb kc kd q0 q1 q2 q3 fst snd N.to_nat Pos.to_nat Pos.iter_op Nat.add nth kverts].
    assert (Z : forall v, phi3 (vadd A aadd v (vofZ A aofZ 1 z30)) = phi3 v).
    { intros v. rewrite (phi3_add A aadd phi phi_add), (phi3_ofZ A aofZ phi phi_Z). unfold vec, z30. apply point_eq; unf; ring. }
    rewrite !Z. reflexivity. }
  rewrite PP, E. unfold in_space, Et, translate, map_tet, moved, Euclid.E, lattice_vector, at_coordinates; cbn [va vb vc vd]. f_equal; apply point_eq; unf; field.
Qed.
Definition quantity (Q : tetrahedron -> R -> Prop) : Prop := forall k u t q, 0 < k -> Q (map_tet (moved k u) t) q -> Q t q.
Definition satisfies (Q : tetrahedron -> R -> Prop) (rel : relation) (B : R) (t : tetrahedron) : Prop := match rel with
  | LessThan => exists q, Q t q /\ q < B | AtMost => exists q, Q t q /\ q <= B | MoreThan => exists q, Q t q /\ B < q | AtLeast => exists q, Q t q /\ B <= q
  | Maximum | Minimum => Q t B end.
Lemma alone_bounded Q rel B : quantity Q -> bounded (is_tile 0 1) (fun n => Q (Statement.tile l1 m2 m3 (cP A aadd aofZ phi c l1 m2 m3) n)) rel B -> satisfies Q rel B in_space.
Proof.
  intros QI H. assert (T0 : is_tile 0 1 (0%nat, z30)) by (split; [cbn; lia|cbn; auto]).
  assert (EV : forall ok, every (is_tile 0 1) (fun n => Q (Statement.tile l1 m2 m3 (cP A aadd aofZ phi c l1 m2 m3) n)) ok -> exists q, Q in_space q /\ ok q).
  { intros ok E. destruct (E _ T0) as [q [Hq O]]. destruct (alone_tile _ T0) as [k [u [K T]]]. rewrite T in Hq. exists q. split; auto. apply (QI k u); auto. }
  assert (RE : reached (is_tile 0 1) (fun n => Q (Statement.tile l1 m2 m3 (cP A aadd aofZ phi c l1 m2 m3) n)) B -> Q in_space B).
  { intros [n [Tn Hq]]. destruct (alone_tile _ Tn) as [k [u [K T]]]. rewrite T in Hq. apply (QI k u); auto. }
  destruct rel; cbn [bounded satisfies] in *; try (apply EV; exact H); apply RE, H.
Qed.
Lemma alone_largest rel sg p q : check_statement A aadd asub amul aofZ alt ale c (CLargestDihedralAngle A rel sg p q) = true -> satisfies largest_angle rel (dangle A phi sg p q) in_space.
Proof.
  intros H. unfold check_statement in H. cbv zeta in H. apply andb_true_iff in H as [H1 H2]. apply alone_bounded.
  - intros k u t x K. unfold largest_angle. rewrite moved_dihedrals by auto. auto.
  - exact (largest_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok c alone_based l1 m2 m3 HG rel sg p q H1 H2).
Qed.
Lemma alone_smallest rel sg p q : check_statement A aadd asub amul aofZ alt ale c (CSmallestDihedralAngle A rel sg p q) = true -> satisfies smallest_angle rel (dangle A phi sg p q) in_space.
Proof.
  intros H. unfold check_statement in H. cbv zeta in H. apply andb_true_iff in H as [H1 H2]. apply alone_bounded.
  - intros k u t x K. unfold smallest_angle. rewrite moved_dihedrals by auto. auto.
  - exact (smallest_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok c alone_based l1 m2 m3 HG rel sg p q H1 H2).
Qed.
Lemma alone_ratio rel p q : check_statement A aadd asub amul aofZ alt ale c (CSquaredRadiusEdgeRatio A rel p q) = true -> satisfies squared_ratio rel (phi p / IZR q) in_space.
Proof.
  intros H. unfold check_statement in H. cbv zeta in H. rewrite !andb_true_iff in H. destruct H as [[H1 _] H2]. apply Z.ltb_lt, IZR_lt in H1. apply alone_bounded.
  - intros k u t x K. apply moved_ratio, K.
  - exact (radius_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z alt_ok ale_ok c alone_based l1 m2 m3 HG rel p q H1 H2).
Qed.
Lemma alone_acute : check_statement A aadd asub amul aofZ alt ale c (CAcute A) = true -> forall x, In x (dihedrals in_space) -> x < PI / 2.
Proof.
  intros H x Hx. assert (T0 : is_tile 0 1 (0%nat, z30)) by (split; [cbn; lia|cbn; auto]). destruct (alone_tile _ T0) as [k [u [K T]]].
  assert (BASE := alone_based).
  apply (each_angle A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c BASE l1 m2 m3 HG _ (fun x => x < PI / 2)
    (acute_sound A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c BASE l1 m2 m3 HG) H (0%nat, z30) x T0).
  rewrite T, moved_dihedrals by auto. exact Hx.
Qed.
Lemma alone_nonobtuse : check_statement A aadd asub amul aofZ alt ale c (CNonobtuse A) = true -> forall x, In x (dihedrals in_space) -> x <= PI / 2.
Proof.
  intros H x Hx. assert (T0 : is_tile 0 1 (0%nat, z30)) by (split; [cbn; lia|cbn; auto]). destruct (alone_tile _ T0) as [k [u [K T]]].
  assert (BASE := alone_based).
  apply (each_angle A aadd asub amul aofZ alt phi phi_add phi_sub phi_mul phi_Z alt_ok c BASE l1 m2 m3 HG _ (fun x => x <= PI / 2)
    (nonobtuse_sound A aadd asub amul aofZ alt ale phi phi_add phi_sub phi_mul phi_Z ale_ok c BASE l1 m2 m3 HG) H (0%nat, z30) x T0).
  rewrite T, moved_dihedrals by auto. exact Hx.
Qed.
End Alone.

(** ** Over all mosaics *)
Section Mosaic.
Variables (l1 l2 l3 : point).
Hypothesis basis : has_gram G l1 l2 l3.
Hypothesis right_handed : 0 < det l1 l2 l3.
Notation over_all := (over_all l1 l2 l3 G r rsystem).
Notation over_some := (over_some l1 l2 l3 G r rsystem).
Notation joins := (MosaicChecker.joins A aofZ system apexes).
Notation check_alone := (MosaicChecker.check_alone A aadd asub amul aofZ alt ale g).
Lemma gram_checked : chk_gram A aadd asub amul aofZ alt g = true.
Proof. pose proof CHECKED as C. unfold check_system in C. rewrite !andb_true_iff in C. tauto. Qed.
Lemma pieces_In a t : In t (pieces (patch_at a)) -> exists kt, In kt (k_pieces A (k_patch a)) /\ t = rtet kt.
Proof. rewrite patch_ok. unfold rpatch; cbn [pieces]. rewrite in_map_iff. intros [kt [E I]]. eauto. Qed.
Lemma piece_pos a kt : (a < length rsystem)%nat -> In kt (k_pieces A (k_patch a)) -> tet_pos kt.
Proof.
  intros Ha I. apply (In_nth _ _ (no_spot, no_spot, no_spot, no_spot)) in I as [k [Hk <-]]. destruct (positive_ok a Ha) as [[_ [_ [_ PT]]] _]. apply PT.
Qed.
Section Over.
Variables (tiles : nat -> tile) (rise : nat -> point).
Hypothesis tiling : mosaic l1 l2 l3 G r rsystem tiles.
Hypothesis high : heights l1 l2 l3 r rsystem tiles rise.
Notation kind i := (shape (tiles i)).
Notation is_cell := (is_cell l1 l2 l3 r rsystem tiles rise).
Lemma space_of i n kt : exists m2 m3 i0, has_gram G l1 m2 m3 /\ map_tet (at_ tiles rise i n) (rtet kt) = in_space l1 m2 m3 kt i0.
Proof.
  destruct (motion G r rsystem h system_good l1 l2 l3 basis right_handed tiles tiling i) as [m2 [m3 [E [HG _]]]].
  exists m2, m3, (at_ tiles rise i n origin). split; [exact HG|]. unfold in_space, map_tet, at_, MosaicStatement.spot, MosaicStatement.place. rewrite E.
  unfold MosaicTiling.lift, at_coordinates, origin. destruct kt as [[[x y] z] w]; cbn [rtet va vb vc vd]. f_equal; apply point_eq; unf; ring.
Qed.
Lemma cell_corners t : is_cell t -> exists a kt m2 m3 i0, (a < length rsystem)%nat /\ (In kt (k_pieces A (k_patch a)) \/ In kt (joins a)) /\ tet_pos kt /\
  has_gram G l1 m2 m3 /\ t = in_space l1 m2 m3 kt i0.
Proof.
  intros Ht. apply (is_cell_iff G r rsystem h system_good l1 l2 l3 basis right_handed tiles tiling rise high) in Ht as [c [V ->]].
  destruct c as [[i p] n]. pose proof (kind_lt G r rsystem l1 l2 l3 tiles tiling i) as KI. cbn [MosaicTiling.piece]. destruct V as [L V]. destruct p as [k|q e].
  - change (MosaicStatement.patch_of rsystem tiles i) with (patch_at (kind i)) in *. rewrite pieces_length in V. rewrite patch_ok, piece_ok.
    destruct (space_of i n (k_piece (k_patch (kind i)) k)) as [m2 [m3 [i0 [HG E]]]]. exists (kind i), (k_piece (k_patch (kind i)) k), m2, m3, i0.
    assert (I : In (k_piece (k_patch (kind i)) k) (k_pieces A (k_patch (kind i)))) by (apply nth_In, V). split; [exact KI|]. split; [left; exact I|]. split; [apply (piece_pos (kind i)); auto|]. auto.
  - destruct V as [Hq [He I]]. destruct (pyramid_facts G r rsystem h system_good l1 l2 l3 tiles tiling i q Hq) as [Hs _]. unfold join_at.
    destruct (MosaicTiling.across_side r rsystem l1 l2 l3 tiles i (side_of h (kind i) q)) as [j s'] eqn:E.
    destruct (across_spec G r rsystem h system_good l1 l2 l3 basis right_handed tiles tiling i _ j s' Hs E) as [Hs' [_ [_ FT]]].
    change (MosaicStatement.patch_of rsystem tiles i) with (patch_at (kind i)) in *. change (MosaicStatement.patch_of rsystem tiles j) with (patch_at (kind j)) in *.
    pose proof (kind_lt G r rsystem l1 l2 l3 tiles tiling j) as KJ.
    rewrite pyramids_length in Hq. rewrite sides_length in Hs, Hs'. rewrite patch_ok, rim_count_ok in He.
    pose proof (choice_ok (kind i) q (kind j) s' KI KJ Hq Hs Hs' FT) as CH. unfold join. destruct (pyramid_mate h (kind i) q (kind j) s') as [q' m]. destruct CH as [y [Hy ->]].
    rewrite patch_ok. change (Tetrahedron (rp y) (rim_at (rpatch (k_patch (kind i))) q e) (rim_at (rpatch (k_patch (kind i))) q (next (rim_count (rpatch (k_patch (kind i))) q) e)) (apex_at (rpatch (k_patch (kind i))) q)) with (lateral_cell (rpatch (k_patch (kind i))) q e (rp y)).
    rewrite <- lateral_ok. destruct (space_of i n (lateral (k_patch (kind i)) q e y)) as [m2 [m3 [i0 [HG E2]]]].
    exists (kind i), (lateral (k_patch (kind i)) q e y), m2, m3, i0. split; [exact KI|]. split; [right|split; [apply join_pos; auto|auto]].
    unfold MosaicChecker.joins. cbv zeta. apply in_flat_map. exists q. split; [apply in_seq; lia|]. apply in_flat_map. exists y. split; [exact Hy|].
    apply (in_map (fun e => lateral (k_patch (kind i)) q e y)), in_seq. lia.
Qed.
Lemma every_ok (f : corners -> bool) (Q : tetrahedron -> Prop) : every_cell A aofZ system apexes f = true ->
  (forall m2 m3 kt i0, has_gram G l1 m2 m3 -> tet_pos kt -> f kt = true -> Q (in_space l1 m2 m3 kt i0)) -> forall t, is_cell t -> Q t.
Proof.
  intros E H t Ht. destruct (cell_corners t Ht) as [a [kt [m2 [m3 [i0 [Ha [I [P [HG ->]]]]]]]]]. apply H; auto.
  pose proof (upto_ok _ _ E a ltac:(rewrite map_length in Ha; exact Ha)) as K. cbv beta in K. apply andb_true_iff in K as [K1 K2]. rewrite forallb_forall in K1, K2. destruct I; auto.
Qed.
Lemma some_ok (f : corners -> bool) (Q : tetrahedron -> Prop) a : existsb f (k_pieces A (k_patch a)) = true ->
  (forall m2 m3 kt i0, has_gram G l1 m2 m3 -> tet_pos kt -> f kt = true -> Q (in_space l1 m2 m3 kt i0)) -> (exists i, kind i = a) -> exists t, is_cell t /\ Q t.
Proof.
  intros E H [i Hi]. apply existsb_exists in E as [kt [I F]]. pose proof (kind_lt G r rsystem l1 l2 l3 tiles tiling i) as KI.
  destruct (space_of i z30 kt) as [m2 [m3 [i0 [HG ES]]]]. exists (in_space l1 m2 m3 kt i0). split; [|apply H; auto; apply (piece_pos a); auto; rewrite <- Hi; exact KI].
  apply (is_cell_iff G r rsystem h system_good l1 l2 l3 basis right_handed tiles tiling rise high).
  apply (In_nth _ _ (no_spot, no_spot, no_spot, no_spot)) in I as [k [Hk Ek]]. exists (i, Piece k, z30). split.
  - split; [apply latb_zero|]. change (MosaicStatement.patch_of rsystem tiles i) with (patch_at (kind i)). rewrite pieces_length, Hi. exact Hk.
  - cbn [MosaicTiling.piece]. change (MosaicStatement.patch_of rsystem tiles i) with (patch_at (kind i)). 
    assert (PE : piece_at (patch_at (kind i)) k = rtet kt) by (rewrite patch_ok, piece_ok, Hi, <- Ek; reflexivity). rewrite PE. symmetry. exact ES.
Qed.
End Over.

Theorem tiles_all : over_all tiles_space.
Proof. intros tiles rise T H. apply (mosaic_tiles G r rsystem h system_good); auto. Qed.
Theorem acute_all : every_cell A aofZ system apexes (check_alone (CAcute A)) = true -> over_all acute_cells.
Proof.
  intros E tiles rise T H t x Ht. revert x. apply (every_ok tiles rise T H _ (fun t => forall x, In x (dihedrals t) -> x < PI / 2) E); auto.
  intros m2 m3 kt i0 HG P F. unfold MosaicChecker.check_alone in F. cbv zeta in F. apply andb_true_iff in F as [F1 F2]. apply alone_acute; auto. apply gram_checked.
Qed.
Theorem nonobtuse_all : every_cell A aofZ system apexes (check_alone (CNonobtuse A)) = true -> over_all nonobtuse_cells.
Proof.
  intros E tiles rise T H t x Ht. revert x. apply (every_ok tiles rise T H _ (fun t => forall x, In x (dihedrals t) -> x <= PI / 2) E); auto.
  intros m2 m3 kt i0 HG P F. unfold MosaicChecker.check_alone in F. cbv zeta in F. apply andb_true_iff in F as [F1 F2]. apply alone_nonobtuse; auto. apply gram_checked.
Qed.
Lemma bound_all (mk : relation -> cstatement A) (Q : tetrahedron -> R -> Prop) (B : R) rel :
  (forall rel m2 m3 kt i0, has_gram G l1 m2 m3 -> tet_pos kt -> check_alone (mk rel) kt = true -> satisfies Q rel B (in_space l1 m2 m3 kt i0)) ->
  check_bound A aadd asub amul aofZ alt ale g system apexes mk rel = true -> bounded_over_all l1 l2 l3 G r rsystem Q rel B.
Proof.
  intros S E.
  assert (ALL : forall rel, match rel with Maximum | Minimum => False | _ => True end -> every_cell A aofZ system apexes (check_alone (mk rel)) = true -> over_all (fun cells => bounded cells Q rel B)).
  { intros rel0 NM E0 tiles rise T H. pose proof (every_ok tiles rise T H _ (satisfies Q rel0 B) E0 (S rel0)) as K. destruct rel0; try contradiction; cbn [bounded]; intros t Ht; exact (K t Ht). }
  assert (SOME : forall rel, match rel with Maximum | Minimum => True | _ => False end -> some_piece A system (check_alone (mk rel)) = true -> over_some (fun cells => reached cells Q B)).
  { intros rel0 NM E0. apply some_upto_ok in E0 as [a [Ha E0]]. exists a. split; [rewrite map_length; exact Ha|]. intros tiles rise T H X.
    destruct (some_ok tiles rise T H _ (satisfies Q rel0 B) a E0 (S rel0) X) as [t [Ht K]]. exists t. split; auto. destruct rel0; try contradiction; exact K. }
  destruct rel; cbn [bounded_over_all check_bound] in *; try (apply ALL; [exact I|exact E]); apply andb_true_iff in E as [E1 E2]; (split; [apply ALL; [exact I|exact E1]|]);
  [apply (SOME Maximum)|apply (SOME Minimum)]; auto.
Qed.
Ltac alone_with L := intros rel0 m2 m3 kt i0 HG P F; unfold MosaicChecker.check_alone in F; cbv zeta in F; apply andb_true_iff in F as [F1 F2]; apply L; auto; apply gram_checked.
Theorem largest_all rel sg p q : check_bound A aadd asub amul aofZ alt ale g system apexes (fun rel => CLargestDihedralAngle A rel sg p q) rel = true ->
  bounded_over_all l1 l2 l3 G r rsystem largest_angle rel (dangle A phi sg p q).
Proof. apply bound_all. alone_with alone_largest. Qed.
Theorem smallest_all rel sg p q : check_bound A aadd asub amul aofZ alt ale g system apexes (fun rel => CSmallestDihedralAngle A rel sg p q) rel = true ->
  bounded_over_all l1 l2 l3 G r rsystem smallest_angle rel (dangle A phi sg p q).
Proof. apply bound_all. alone_with alone_smallest. Qed.
Theorem ratio_all rel p q : check_bound A aadd asub amul aofZ alt ale g system apexes (fun rel => CSquaredRadiusEdgeRatio A rel p q) rel = true ->
  bounded_over_all l1 l2 l3 G r rsystem squared_ratio rel (phi p / IZR q).
Proof. apply bound_all. alone_with alone_ratio. Qed.
Theorem delaunay_all : check_delaunay A aadd asub amul aofZ ale content quot g r system h apexes alt = true -> over_all delaunay_cells.
Proof.
  intros D tiles rise T H. apply (mosaic_delaunay G r rsystem h system_good true (local_ok alt true alt_ok D) (axis_ok alt true alt_ok D) l1 l2 l3 basis right_handed tiles T rise H eq_refl).
Qed.
Theorem weakly_delaunay_all : check_delaunay A aadd asub amul aofZ ale content quot g r system h apexes ale = true -> over_all weakly_delaunay_cells.
Proof.
  intros D tiles rise T H. apply (mosaic_weakly_delaunay G r rsystem h system_good false (local_ok ale false ale_ok D) (axis_ok ale false ale_ok D) l1 l2 l3 basis right_handed tiles T rise H).
Qed.

(** ** Heights *)
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
End Mosaic.
End System. End Ring.
