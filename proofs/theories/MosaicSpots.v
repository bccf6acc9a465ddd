(** * Systems of patches: the points and patches of the checker have real coordinates

    Over any ring with a homomorphism phi to the real numbers for which the two comparisons are
    sound, as in Soundness.v. *)
Require Import Reals Lra Psatz NArith ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Domain Bounds Euclid Transfer Checker Soundness
  MosaicStatement MosaicPoints MosaicPatches MosaicChecker.
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
Notation tet_of := (MosaicChecker.tet_of A amul aofZ ale).
Notation tet_and := (MosaicChecker.tet_and A amul aofZ ale).

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
End Ring.
