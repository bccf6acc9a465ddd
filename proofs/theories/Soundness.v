(** * Soundness: the checker's "true" implies the theorem

    Over any ring A with a homomorphism phi to the real numbers for which the two
    comparisons are sound.  Each lemma [c...] is what one check of Checker.v means;
    the theorem [check_sound] puts them into the degree argument and moves the
    result to Euclidean space. *)
Require Import Reals Lra Psatz NArith Nnat ZArith List Lia Bool FunctionalExtensionality FMapPositive.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Domain Bounds Angles Euclid Transfer Volume Delaunay Checker Keys.
Import ListNotations.
Local Open Scope nat_scope.

Lemma I4_lt i : In i I4 <-> (i < 4)%nat.
Proof. simpl. lia. Qed.

Section Ring.
Variables (A : Type) (aadd asub amul : A -> A -> A) (aofZ : Z -> A) (alt ale : A -> A -> bool).
Variable phi : A -> R.
Hypothesis phi_add : forall x y, phi (aadd x y) = (phi x + phi y)%R.
Hypothesis phi_sub : forall x y, phi (asub x y) = (phi x - phi y)%R.
Hypothesis phi_mul : forall x y, phi (amul x y) = (phi x * phi y)%R.
Hypothesis phi_Z : forall z, phi (aofZ z) = IZR z.
Hypothesis alt_ok : forall x y, alt x y = true -> (phi x < phi y)%R.
Hypothesis ale_ok : forall x y, ale x y = true -> (phi x <= phi y)%R.

(* the operations of Checker.v, over this ring *)
Notation v3 := (v3 A).
Notation V3 := (V3 A).
Notation vX := (vX A).
Notation vY := (vY A).
Notation vZ := (vZ A).
Notation vadd := (vadd A aadd).
Notation vsub := (vsub A asub).
Notation kdet3 := (kdet3 A aadd asub amul).
Notation kD := (kD A aadd asub amul).
Notation zero := (zero A aofZ).
Notation vzero := (vzero A aofZ).
Notation vofZ := (vofZ A aofZ).
Notation cert := (cert A).
Notation kgram := (kgram A).
Notation khalf := (khalf A).
Notation ktet := (ktet A).
Notation ka := (ka A).
Notation kb := (kb A).
Notation kc := (kc A).
Notation kd := (kd A).
Notation c_den := (c_den A).
Notation c_verts := (c_verts A).
Notation c_tets := (c_tets A).
Notation c_gram := (c_gram A).
Notation c_rank := (c_rank A).
Notation c_domain := (c_domain A).
Notation c_polytope := (c_polytope A).
Notation c_pieces := (c_pieces A).
Notation chk_polytope := (chk_polytope A aadd asub amul aofZ alt ale).
Notation in_piece := (in_piece A aadd asub amul aofZ alt ale).
Notation piece_pos := (piece_pos A aadd aofZ).
Notation zeroed := (zeroed A aofZ).
Notation unit_cell := (unit_cell A aadd asub amul aofZ alt).
Notation chk_unit := (chk_unit A aofZ ale).
Notation between := (between A aadd asub amul aofZ ale).
Notation separated := (separated A aadd asub amul aofZ ale).
Notation chk_apart := (chk_apart A aadd asub amul aofZ ale).
Notation chk_cover := (chk_cover A aadd asub amul aofZ alt ale).
Notation kvolume := (kvolume A aadd asub amul aofZ).
Notation pos := (pos A aadd aofZ).
Notation kpos := (kpos A aadd aofZ).
Notation kL := (kL A aadd asub amul).
Notation klev := (klev A aadd amul).
Notation kvx := (kvx A).
Notation kverts := (kverts A).
Notation kgdot := (kgdot A aadd amul).
Notation kgdet := (kgdet A aadd asub amul).
Notation kac := (kac A aadd asub amul).
Notation kpower := (kpower A aadd asub amul).
Notation k11 := (k11 A).
Notation k22 := (k22 A).
Notation k33 := (k33 A).
Notation k12 := (k12 A).
Notation k13 := (k13 A).
Notation k23 := (k23 A).
Notation hn := (hn A).
Notation hd := (hd A).
Notation chk_vol := (chk_vol A aadd asub amul aofZ alt).
Notation chk_mates := (chk_mates A aadd amul aofZ ale).
Notation chk_mate := (chk_mate A aadd amul aofZ ale).
Notation chk_gram := (chk_gram A aadd asub amul aofZ alt).
Notation chk_invariant := (chk_invariant A aofZ ale).
Notation chk_inside := (chk_inside A aadd amul aofZ alt ale).
Notation on_boundary := (on_boundary A aadd amul aofZ ale).
Notation is_zero := (is_zero A aofZ ale).
Notation positions := (positions A aadd aofZ).
Notation check_tiling := (check_tiling A aadd asub amul aofZ alt ale).
Notation check_statement := (check_statement A aadd asub amul aofZ alt ale).
Notation check := (check A aadd asub amul aofZ alt ale).
Notation six := (six A).
Notation on_edge := (on_edge A).
Notation cstatement := (cstatement A).
Notation chk_bound := (chk_bound A aofZ alt ale).
Notation chk_root := (chk_root A amul aofZ ale).
Notation chk_angle := (chk_angle A aadd asub amul aofZ alt ale).
Notation chk_radius := (chk_radius A aadd asub amul aofZ alt ale).
Notation chk_ratio := (chk_ratio A aadd asub amul aofZ alt ale).
Notation chk_compare := (chk_compare A alt ale).
Notation kradius := (kradius A aadd asub amul aofZ).
Notation chk_power := (chk_power A aadd asub amul aofZ).

(** ** What the ring operations mean *)
Definition phi3 (v : v3) := Point (phi (vX v)) (phi (vY v)) (phi (vZ v)).
Lemma phi3_add a b : phi3 (vadd a b) = add (phi3 a) (phi3 b).
Proof. unfold phi3, Checker.vadd, add; cbn. rewrite !phi_add. auto. Qed.
Lemma phi3_sub a b : phi3 (vsub a b) = sub (phi3 a) (phi3 b).
Proof. unfold phi3, Checker.vsub, sub; cbn. rewrite !phi_sub. auto. Qed.
Lemma phi_det3 a b c : phi (kdet3 a b c) = det (phi3 a) (phi3 b) (phi3 c).
Proof. unfold Checker.kdet3, det, phi3; cbn [px py pz]. repeat rewrite ?phi_add, ?phi_sub, ?phi_mul. auto. Qed.
Lemma phi_D a b c d : phi (kD a b c d) = orient (phi3 a) (phi3 b) (phi3 c) (phi3 d).
Proof. unfold Checker.kD, orient. rewrite phi_det3, !phi3_sub. auto. Qed.
Lemma phi3_ofZ den n : phi3 (vofZ den n) = vec (IZR den) n.
Proof. destruct n as [[x y] z]. unfold Checker.vofZ, phi3, vec; cbn. rewrite !phi_Z, !mult_IZR. auto. Qed.
Lemma phi_zero : phi zero = 0%R.
Proof. unfold Checker.zero. apply phi_Z. Qed.
Definition phiT (t : ktet) := Tetrahedron (phi3 (ka t)) (phi3 (kb t)) (phi3 (kc t)) (phi3 (kd t)).
Lemma phi_L t i x : phi (kL t i x) = coord (phiT t) i (phi3 x).
Proof. unfold Checker.kL, coord, side. destruct i as [|[|[|i]]]; cbn [kfc facet t1 t2 t3 phiT va vb vc vd]; apply phi_D. Qed.
Lemma phi_vx t i : phi3 (kvx t i) = vx (phiT t) i.
Proof. destruct i as [|[|[|i]]]; reflexivity. Qed.
Definition phiH (H : khalf) := HalfSpace (phi3 (hn H)) (phi (hd H)).
Lemma phi_lev H x : phi (klev H x) = level (phiH H) (phi3 x).
Proof. unfold Checker.klev, level, phiH, dot, phi3; cbn [px py pz normal offset]. repeat rewrite ?phi_add, ?phi_mul. ring. Qed.
Definition phiG (g : kgram) := Gram (phi (k11 g)) (phi (k22 g)) (phi (k33 g)) (phi (k12 g)) (phi (k13 g)) (phi (k23 g)).
Lemma phi_gdot g u v : phi (kgdot g u v) = gdot (phiG g) (phi3 u) (phi3 v).
Proof. unfold Checker.kgdot, gdot, phiG, phi3; cbn [g11 g22 g33 g12 g13 g23 px py pz]. repeat rewrite ?phi_add, ?phi_sub, ?phi_mul. ring. Qed.
Lemma phi_gdet g : phi (kgdet g) = gdet (phiG g).
Proof. unfold Checker.kgdet, gdet, phiG; cbn [g11 g22 g33 g12 g13 g23]. repeat rewrite ?phi_add, ?phi_sub, ?phi_mul. ring. Qed.
Lemma phi_power g t x : phi (kpower g t x) = power_sum (phiG g) (phiT t) (phi3 x).
Proof.
  unfold Checker.kpower, power_sum, ksq, sq. repeat rewrite ?phi_add, ?phi_mul. rewrite !phi_L, !phi_gdot, !phi3_sub. reflexivity.
Qed.

(** Planes, and the lattice. *)
Definition zdot (n d : Z3) : Z := let '(n1, n2, n3) := n in let '(d1, d2, d3) := d in (n1 * d1 + n2 * d2 + n3 * d3)%Z.
Lemma phi_height n p q d v : phi (kheight A aadd asub amul aofZ n p q d v) = (IZR q * linear_form n (phi3 v) - IZR p * IZR d)%R.
Proof.
  destruct n as [[n1 n2] n3]. unfold kheight, linear_form, phi3; cbn [px py pz].
  rewrite phi_sub, !phi_add, !phi_mul, !phi_Z, !mult_IZR. ring.
Qed.
Lemma linear_add n x y : linear_form n (add x y) = (linear_form n x + linear_form n y)%R.
Proof. destruct n as [[n1 n2] n3]. unfold linear_form, add; cbn [px py pz]. ring. Qed.
Lemma linear_vec n d z : linear_form n (vec d z) = (d * IZR (zdot n z))%R.
Proof. destruct n as [[n1 n2] n3], z as [[z1 z2] z3]. unfold linear_form, vec, zdot; cbn [px py pz]. rewrite !plus_IZR, !mult_IZR. ring. Qed.
Lemma step_divides r n d : latb r d = true -> exists w, zdot n d = (plane_step r n * w)%Z.
Proof.
  rewrite latb_iff. destruct n as [[n1 n2] n3], d as [[d1 d2] d3]. unfold plane_step, zdot. destruct r as [|[|[|r]]]; cbn [in_lattice].
  - intros [-> [-> ->]]. exists 0%Z. ring.
  - intros [-> ->]. destruct (Z.gcd_divide_l n1 0) as [a Ha]. set (g := Z.gcd n1 0) in *. clearbody g. exists (a * d1)%Z. rewrite Ha. ring.
  - intros ->. destruct (Z.gcd_divide_l n1 n2) as [a Ha], (Z.gcd_divide_r n1 n2) as [b Hb]. set (g := Z.gcd n1 n2) in *. clearbody g.
    exists (a * d1 + b * d2)%Z. rewrite Ha, Hb. ring.
  - intros _. destruct (Z.gcd_divide_l n1 (Z.gcd n2 n3)) as [a Ha], (Z.gcd_divide_r n1 (Z.gcd n2 n3)) as [b Hb].
    destruct (Z.gcd_divide_l n2 n3) as [a' Ha'], (Z.gcd_divide_r n2 n3) as [b' Hb'].
    set (g := Z.gcd n1 (Z.gcd n2 n3)) in *. clearbody g. set (g' := Z.gcd n2 n3) in *. clearbody g'. rewrite Hb in Ha', Hb'.
    exists (a * d1 + a' * b * d2 + b' * b * d3)%Z. rewrite Ha, Ha', Hb'. ring.
Qed.
Lemma step_nonnegative r n : (0 <= plane_step r n)%Z.
Proof. destruct n as [[n1 n2] n3], r as [|[|[|r]]]; cbn [plane_step]; try apply Z.gcd_nonneg. lia. Qed.

(** ** What a certificate denotes

    Corner (v, n) is the point with basis coordinates c_verts[v]/c_den + n. *)
Section Denote.
Local Open Scope R_scope.
Variables (c : cert) (l1 l2 l3 : point).
Definition dcorner (q : corner) : point :=
  let v := nth (N.to_nat (fst q)) (c_verts c) vzero in let '(x, y, z) := snd q in let d := IZR (c_den c) in
  at_coordinates l1 l2 l3 (Point (phi (vX v) / d + IZR x) (phi (vY v) / d + IZR y) (phi (vZ v) / d + IZR z)).
Definition dtet (k : nat) : tetrahedron :=
  match nth_error (c_tets c) k with
  | Some t => Tetrahedron (dcorner (q0 t)) (dcorner (q1 t)) (dcorner (q2 t)) (dcorner (q3 t))
  | None => Tetrahedron origin origin origin origin
  end.
Definition dpoint (v : v3) := let d := IZR (c_den c) in Point (phi (vX v) / d) (phi (vY v) / d) (phi (vZ v) / d).
Definition ddomain := domain l1 l2 l3 (c_rank c) (map dpoint (c_polytope c)).
Definition dgram :=
  let g := c_gram c in Gram (phi (k11 g)) (phi (k22 g)) (phi (k33 g)) (phi (k12 g)) (phi (k13 g)) (phi (k23 g)).
(** The statements, with their bounds as real numbers. *)
Definition dangle (sg : Z) (p : A) (q : Z) : R := acos (IZR sg * sqrt (phi p / IZR q)).
Definition dstatement (s : cstatement) : statement :=
  match s with
  | CAcute _ => Acute
  | CNonobtuse _ => Nonobtuse
  | CLargestDihedralAngle _ rel sg p q => LargestDihedralAngle rel (dangle sg p q)
  | CSmallestDihedralAngle _ rel sg p q => SmallestDihedralAngle rel (dangle sg p q)
  | CSquaredRadiusEdgeRatio _ rel p q => SquaredRadiusEdgeRatio rel (phi p / IZR q)
  | CUncrossed _ n p q _ => Uncrossed n (IZR p / IZR q)
  | CDelaunay _ => Delaunay
  | CWeaklyDelaunay _ => WeaklyDelaunay
  | CNotDelaunay _ => NotDelaunay
  | CTCP _ => TCP
  end.
End Denote.

Open Scope R_scope.
Section Sound.
Variable c : cert.
Let den := c_den c.
Let h := IZR den.
Let vs := c_verts c.
Let N := length (c_tets c).
Let r := c_rank c.
Let Hs := map phiH (c_domain c).
Definition cT (k : nat) : tetrahedron :=
  match nth_error (c_tets c) k with Some t => phiT (kpos den vs t) | None => phiT (KT A vzero vzero vzero vzero) end.
Definition cM (k i : nat) : option (nat * nat * Z3) :=
  match nth_error (c_tets c) k with
  | Some t => match mt t i with Some (k', i', d) => Some (N.to_nat k', N.to_nat i', d) | None => None end
  | None => None end.
Notation piece := (piece cT h).
Notation valid := (valid N (latb r)).

(** What regions, too, have of the checks. *)
Definition based := (0 < den)%Z /\ (forall t, In t (c_tets c) -> chk_vol (kpos den vs t) = true) /\ chk_gram (c_gram c) = true.
Hypothesis BASE : based.
Hypothesis CHK : check_tiling c = true.

Lemma chk_all :
  (0 < den)%Z /\ (r <= 3)%nat /\ (forall t, In t (c_tets c) -> chk_vol (kpos den vs t) = true) /\
  (forall H, In H (c_domain c) -> chk_invariant r H = true /\ chk_inside (positions c) H = true) /\
  chk_mates r (c_domain c) (c_tets c) (kpos den vs) 0 (c_tets c) = true /\
  chk_cover c = true /\
  chk_gram (c_gram c) = true /\
  chk_polytope c (positions c) = true.
Proof.
  pose proof CHK as H. unfold Checker.check_tiling in H. cbv zeta in H. fold den vs r in H. rewrite !andb_true_iff in H.
  destruct H as [[[[[[[H1 H1''] H2] H3] HP] H6] H7] H9].
  unfold Checker.positions in H2. fold den vs in H2.
  repeat split; auto.
  - apply Z.ltb_lt; auto.
  - apply Nat.leb_le; auto.
  - intros t Ht. rewrite forallb_forall in H2. apply H2, in_map; auto.
  - rewrite forallb_forall in H3. specialize (H3 H H0). apply andb_true_iff in H3. apply H3.
  - rewrite forallb_forall in H3. specialize (H3 H H0). apply andb_true_iff in H3. apply H3.
Qed.

Lemma h_pos : 0 < h.
Proof. destruct BASE as [H _]. unfold h. apply IZR_lt; auto. Qed.

Lemma get k : (k < N)%nat -> exists t, nth_error (c_tets c) k = Some t /\ In t (c_tets c).
Proof.
  intros Hk. destruct (nth_error (c_tets c) k) as [t|] eqn:E.
  - exists t. split; auto. eapply nth_error_In; eauto.
  - apply nth_error_None in E. unfold N in Hk. lia.
Qed.
Lemma cT_eq k t : nth_error (c_tets c) k = Some t -> cT k = phiT (kpos den vs t).
Proof. intros E. unfold cT. rewrite E. auto. Qed.

Lemma cvol k : (k < N)%nat -> 0 < vol (cT k).
Proof.
  intros Hk. destruct (get k Hk) as [t [E I]]. rewrite (cT_eq k t E).
  destruct BASE as [_ [H _]]. specialize (H t I). unfold Checker.chk_vol in H. apply alt_ok in H.
  rewrite phi_zero, phi_D in H. exact H.
Qed.
Lemma pvol k n : (k < N)%nat -> 0 < vol (piece (k, n)).
Proof. intros Hk. unfold Degree.piece; cbn [fst snd]. rewrite vol_ttr. apply cvol; auto. Qed.

(** *** The domain *)
Lemma is_zero_ok x : is_zero x = true -> phi x = 0.
Proof. unfold Checker.is_zero. rewrite andb_true_iff. intros [H1 H2]. apply ale_ok in H1, H2. rewrite phi_zero in *. lra. Qed.
Lemma cinvariant H : In H Hs -> invariant r H.
Proof.
  unfold Hs. rewrite in_map_iff. intros [K [<- HK]]. destruct chk_all as [_ [_ [_ [D _]]]]. destruct (D K HK) as [D1 _].
  unfold Checker.chk_invariant in D1. rewrite !andb_true_iff in D1. destruct D1 as [[D1 D2] D3].
  unfold invariant, phiH, phi3; cbn [normal px py pz].
  split; [|split]; intros L; apply is_zero_ok.
  - destruct (Nat.leb_spec 1 r); [exact D1|lia].
  - destruct (Nat.leb_spec 2 r); [exact D2|lia].
  - destruct (Nat.leb_spec 3 r); [exact D3|lia].
Qed.
Lemma phiT_verts t v : In v (verts (phiT t)) <-> exists w, In w (kverts t) /\ v = phi3 w.
Proof.
  unfold verts, phiT, Checker.kverts; cbn. split.
  - intros [<-|[<-|[<-|[<-|[]]]]]; eauto 8.
  - intros [w [[<-|[<-|[<-|[<-|[]]]]] ->]]; auto.
Qed.
Lemma in_piece_verts t n v : In v (verts (translate (vec h n) (phiT t))) <-> exists w, In w (kverts t) /\ v = add (phi3 w) (vec h n).
Proof.
  unfold verts, translate, phiT, Checker.kverts; cbn. split.
  - intros [<-|[<-|[<-|[<-|[]]]]]; eauto 8.
  - intros [w [[<-|[<-|[<-|[<-|[]]]]] ->]]; auto.
Qed.
(** What [chk_inside] says of the translates of one tetrahedron. *)
Lemma inside_level kts t n K : In K (c_domain c) -> chk_inside kts K = true -> In t kts -> latb r n = true ->
  (forall v, In v (verts (translate (vec h n) (phiT t))) -> 0 <= level (phiH K) v) /\
  (exists v, In v (verts (translate (vec h n) (phiT t))) /\ 0 < level (phiH K) v).
Proof.
  intros HK D2 It Hn. assert (INV : invariant r (phiH K)) by (apply cinvariant; unfold Hs; apply in_map; auto).
  assert (SH : forall x, level (phiH K) (add x (vec h n)) = level (phiH K) x) by (intros; apply level_shift with (r := r); auto; apply latb_iff; auto).
  unfold Checker.chk_inside in D2. rewrite forallb_forall in D2.
  specialize (D2 t It). rewrite andb_true_iff, forallb_forall, existsb_exists in D2. destruct D2 as [D2 [w [Hw D3]]].
  split.
  - intros v Hv. apply in_piece_verts in Hv as [u [Hu ->]]. rewrite SH.
    specialize (D2 u Hu). apply ale_ok in D2. rewrite phi_zero, phi_lev in D2. auto.
  - apply alt_ok in D3. rewrite phi_zero, phi_lev in D3.
    exists (add (phi3 w) (vec h n)). rewrite SH. split; auto. apply in_piece_verts. eauto.
Qed.
Lemma clevel k n H : (k < N)%nat -> latb r n = true -> In H Hs ->
  (forall v, In v (verts (piece (k, n))) -> 0 <= level H v) /\ (exists v, In v (verts (piece (k, n))) /\ 0 < level H v).
Proof.
  intros Hk Hn HI. destruct (get k Hk) as [t [E I]]. unfold Degree.piece; cbn [fst snd]. rewrite (cT_eq k t E).
  unfold Hs in HI. apply in_map_iff in HI as [K [<- HK]]. destruct chk_all as [_ [_ [_ [D _]]]]. destruct (D K HK) as [_ D2].
  apply (inside_level (positions c)); auto. unfold Checker.positions. fold den vs. apply in_map; auto.
Qed.
Lemma cdom_inside cc x : valid cc -> inside (piece cc) x -> open_domain Hs x.
Proof.
  destruct cc as [k n]. intros [Hk Hn] I H HI. cbn [fst snd] in *. destruct (clevel k n H Hk Hn HI) as [L1 L2].
  apply (level_inside H (piece (k, n)) x); auto. apply pvol; auto.
Qed.
Lemma cdom_closed cc x : valid cc -> closed (piece cc) x -> forall H, In H Hs -> 0 <= level H x.
Proof.
  destruct cc as [k n]. intros [Hk Hn] I H HI. cbn [fst snd] in *. destruct (clevel k n H Hk Hn HI) as [L1 L2].
  apply (level_closed H (piece (k, n)) x); auto. apply pvol; auto.
Qed.

(** *** The pairing *)
Definition rp (q : corner) : point := phi3 (pos den vs q).
Lemma rp_shift d q : rp (cshift d q) = add (rp q) (vec h d).
Proof.
  unfold rp, Checker.pos, cshift; cbn [fst snd]. rewrite !phi3_add, !phi3_ofZ. fold h. rewrite vec_add, padd_assoc. auto.
Qed.
Definition rtri (f : corner * corner * corner) := let '(a,b,c) := f in Triangle (rp a) (rp b) (rp c).
Lemma rtri_fc t i : rtri (cfc t i) = facet (phiT (kpos den vs t)) i.
Proof. destruct i as [|[|[|i]]]; reflexivity. Qed.
Lemma codd_oddm d f g : codd d f g = true -> opposite (rtri f) (translate_triangle (vec h d) (rtri g)).
Proof.
  destruct f as [[a b] c0], g as [[a' b'] c']. unfold codd, opposite, translate_triangle, rtri; cbn [t1 t2 t3].
  rewrite !orb_true_iff, !andb_true_iff, !ceqb_t. rewrite <- !rp_shift.
  intros [[[[-> ->] ->]|[[-> ->] ->]]|[[-> ->] ->]]; auto.
Qed.
Lemma chk_mates_spec ps : forall ts k, chk_mates r (c_domain c) (c_tets c) ps k ts = true ->
  forall j t i, nth_error ts j = Some t -> In i I4 -> chk_mate r (c_domain c) (c_tets c) (k + j) t (ps t) i = true.
Proof.
  induction ts as [|t0 ts IH]; intros k H j t i E Hi.
  - destruct j; discriminate.
  - cbn [Checker.chk_mates] in H. apply andb_true_iff in H as [H1 H2]. destruct j as [|j].
    + injection E as <-. rewrite Nat.add_0_r. rewrite forallb_forall in H1. apply (H1 i Hi).
    + replace (k + S j)%nat with (S k + j)%nat by lia. apply (IH (S k)); auto.
Qed.
Lemma translate_verts u t v : In v (verts (translate u t)) <-> exists w, In w (verts t) /\ v = add w u.
Proof.
  unfold verts, translate; cbn. split.
  - intros [<-|[<-|[<-|[<-|[]]]]]; eauto 8.
  - intros [w [[<-|[<-|[<-|[<-|[]]]]] ->]]; auto.
Qed.
Lemma vx_translate' u t i : vx (translate u t) i = add (vx t i) u.
Proof. destruct i as [|[|[|i]]]; reflexivity. Qed.
Lemma vx_In t i : In i I4 -> In (vx t i) (verts t).
Proof. intros Hi. simpl in Hi. destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; simpl; auto. Qed.

(** A boundary facet lies in a boundary plane. *)
Lemma cboundary k n i : (k < N)%nat -> latb r n = true -> In i I4 -> cM k i = None ->
  exists H, In H Hs /\ forall j, In j I4 -> j <> i -> level H (vx (piece (k, n)) j) = 0.
Proof.
  intros Hk Hn Hi E. destruct (get k Hk) as [t [Et It]].
  destruct chk_all as [_ [_ [_ [_ [M _]]]]].
  pose proof (chk_mates_spec _ _ 0 M k t i Et Hi) as C. cbn [Nat.add] in C. unfold Checker.chk_mate in C.
  unfold cM in E. rewrite Et in E. destruct (mt t i) as [[[k' i'] d]|]; [discriminate|].
  unfold Checker.on_boundary in C. apply existsb_exists in C as [K [HK C]]. rewrite forallb_forall in C.
  exists (phiH K). assert (HI : In (phiH K) Hs) by (unfold Hs; apply in_map; auto). split; auto.
  intros j Hj Ne. destruct (clevel k n _ Hk Hn HI) as [L1 _].
  pose proof (L1 _ (vx_In (piece (k, n)) j Hj)) as P0.
  unfold Degree.piece in *; cbn [fst snd] in *. rewrite vx_translate' in *.
  rewrite (level_shift r) in * by (auto using cinvariant; apply latb_iff; auto).
  specialize (C j Hj). destruct (Nat.eqb_spec j i); [lia|]. apply ale_ok in C.
  rewrite phi_zero, phi_lev, phi_vx in C. rewrite (cT_eq k t Et) in *. lra.
Qed.

Lemma cmate k i : (k < N)%nat -> In i I4 ->
  match cM k i with
  | Some (k', i', d) =>
    (k' < N)%nat /\ In i' I4 /\ latb r d = true /\ cM k' i' = Some (k, i, zopp3 d) /\
    opposite (facet (cT k) i) (facet (translate (vec h d) (cT k')) i')
  | None => forall n y, latb r n = true -> open_domain Hs y -> 0 < coord (piece (k, n)) i y
  end.
Proof.
  intros Hk Hi. destruct (cM k i) as [[[k1 i1] d1]|] eqn:EM.
  - destruct (get k Hk) as [t [E I]].
    destruct chk_all as [_ [_ [_ [_ [M _]]]]].
    pose proof (chk_mates_spec _ _ 0 M k t i E Hi) as C. cbn [Nat.add] in C. unfold Checker.chk_mate in C.
    unfold cM in EM. rewrite E in EM. destruct (mt t i) as [[[k' i'] d]|] eqn:Em; [|discriminate]. injection EM as <- <- <-.
    rewrite !andb_true_iff in C. destruct C as [[C1 C0] C2]. apply N.ltb_lt in C1.
    destruct (nth_error (c_tets c) (N.to_nat k')) as [t'|] eqn:E'; [|discriminate].
    apply andb_true_iff in C2 as [C2 C3]. apply meqb_t in C2. apply codd_oddm in C3.
    split; [|split; [|split; [|split]]]; auto.
    + apply nth_error_Some. rewrite E'. discriminate.
    + apply I4_lt. lia.
    + unfold cM. rewrite E', C2. rewrite !Nnat.Nat2N.id. auto.
    + rewrite (cT_eq k t E), (cT_eq _ t' E'). rewrite facet_translate, <- !rtri_fc. exact C3.
  - intros n y Hn Hy. destruct (cboundary k n i Hk Hn Hi EM) as [H [HI Z]].
    destruct (clevel k n H Hk Hn HI) as [L1 _].
    apply (level_boundary H (piece (k, n)) i y); auto.
    + apply pvol; auto.
    + apply L1, vx_In; auto.
Qed.

(** *** The covering condition: the pieces of a cell of the domain *)
Let NQ := length (unit_cell c).
Definition cQ (k : nat) : tetrahedron := phiT (nth k (unit_cell c) (KT A vzero vzero vzero vzero)).
Notation cell_piece := (Degree.piece cQ h).

Lemma chk_pieces : (0 < N)%nat /\ (forall K, In K (c_domain c) -> chk_inside (unit_cell c) K = true) /\
  (forall t, In t (unit_cell c) -> chk_unit den r t = true) /\ chk_apart (unit_cell c) (unit_cell c) = true /\
  phi (kvolume (positions c)) = phi (kvolume (unit_cell c)).
Proof.
  destruct chk_all as [_ [_ [_ [_ [_ [H _]]]]]]. unfold Checker.chk_cover in H. cbv zeta in H. fold den r in H.
  rewrite !andb_true_iff in H. destruct H as [[[[H1 H2] H3] H4] H5]. rewrite forallb_forall in H2, H3.
  apply is_zero_ok in H5. rewrite phi_sub in H5. repeat split; auto; [|lra].
  unfold N. destruct (c_tets c); [discriminate|]. cbn. lia.
Qed.
Lemma cell_In k : (k < NQ)%nat -> In (nth k (unit_cell c) (KT A vzero vzero vzero vzero)) (unit_cell c).
Proof. intros Hk. apply nth_In. exact Hk. Qed.
Lemma cells_vol t : In t (unit_cell c) -> 0 < vol (phiT t).
Proof.
  intros H. unfold Checker.unit_cell in H. apply filter_In in H as [_ H]. unfold Checker.chk_vol in H. apply alt_ok in H.
  rewrite phi_zero, phi_D in H. exact H.
Qed.
Lemma cQ_vol k : (k < NQ)%nat -> 0 < vol (cQ k).
Proof. intros Hk. apply cells_vol, cell_In, Hk. Qed.
Lemma cQ_inside cc x : Degree.valid NQ (latb r) cc -> inside (cell_piece cc) x -> open_domain Hs x.
Proof.
  destruct cc as [k n]. intros [Hk Hn] I H HI. cbn [fst snd] in *.
  unfold Hs in HI. apply in_map_iff in HI as [K [<- HK]]. destruct chk_pieces as [_ [D _]].
  destruct (inside_level (unit_cell c) _ n K HK (D K HK) (cell_In k Hk) Hn) as [L1 L2].
  apply (level_inside _ (cell_piece (k, n)) x); auto. unfold Degree.piece; cbn [fst snd]. rewrite vol_ttr. apply cQ_vol, Hk.
Qed.

(** No two pieces have common inner points. *)
Lemma between_apart t i p q x : In t (unit_cell c) -> In i I4 -> In p (unit_cell c) -> In q (unit_cell c) ->
  between t i p q = true -> inside (phiT p) x -> inside (phiT q) x -> False.
Proof.
  intros It Hi Ip Iq H. unfold Checker.between in H.
  destruct (forallb (fun v => ale zero (kL t i v)) (kverts p)) eqn:E; [|discriminate]. rewrite forallb_forall in E, H.
  apply (apart_affine (coord (phiT t) i)); auto using cells_vol.
  - apply aff_o.
  - exists (centroid (phiT t)). pose proof (cen_inter _ (cells_vol t It) i Hi). lra.
  - intros v Hv. apply phiT_verts in Hv as [w [Hw ->]]. specialize (E w Hw). apply ale_ok in E. rewrite phi_zero, phi_L in E. exact E.
  - intros v Hv. apply phiT_verts in Hv as [w [Hw ->]]. specialize (H w Hw). apply ale_ok in H. rewrite phi_zero, phi_L in H. exact H.
Qed.
Lemma separated_apart p q x : In p (unit_cell c) -> In q (unit_cell c) -> separated (unit_cell c) p q = true ->
  inside (phiT p) x -> inside (phiT q) x -> False.
Proof.
  intros Ip Iq H Xp Xq. unfold Checker.separated in H. rewrite existsl_eq in H. apply existsb_exists in H as [t [It H]].
  rewrite existsl_eq in H. apply existsb_exists in H as [i [Hi H]].
  assert (It' : In t (unit_cell c)) by (destruct It as [<-|[<-|It]]; auto).
  destruct (between t i p q) eqn:E; [apply (between_apart t i p q x) | apply (between_apart t i q p x)]; auto.
Qed.
Lemma chk_apart_spec all d : forall l j k, chk_apart all l = true -> (j < k < length l)%nat -> separated all (nth j l d) (nth k l d) = true.
Proof.
  induction l as [|p l IH]; intros j k H L; [cbn in L; lia|]. cbn [Checker.chk_apart] in H. apply andb_true_iff in H as [H1 H2].
  rewrite forallb_forall in H1. cbn [length] in L. destruct k as [|k]; [lia|]. destruct j as [|j]; cbn [nth].
  - apply H1, nth_In. lia.
  - apply IH; auto. lia.
Qed.
Lemma same_shift_apart j k n x : (j < k < NQ)%nat -> inside (cell_piece (j, n)) x -> inside (cell_piece (k, n)) x -> False.
Proof.
  intros L I I'. destruct chk_pieces as [_ [_ [_ [AP _]]]].
  apply (separated_apart _ _ (sub x (vec h n)) (cell_In j ltac:(lia)) (cell_In k ltac:(lia))).
  - apply chk_apart_spec; auto.
  - intros i Hi. specialize (I i Hi). unfold Degree.piece in I; cbn [fst snd] in I. rewrite coord_translate in I. exact I.
  - intros i Hi. specialize (I' i Hi). unfold Degree.piece in I'; cbn [fst snd] in I'. rewrite coord_translate in I'. exact I'.
Qed.
(** Cells that differ in one coordinate of the shift are on different sides of a plane. *)
Lemma layers_apart (pr : point -> R) (sh : Z3 -> Z) j k n n' x :
  affine pr -> (forall u v, pr (add u v) = pr u + pr v) -> (forall d, pr (vec h d) = h * IZR (sh d)) ->
  (exists z, pr z <> 0) -> (forall t v, In t (unit_cell c) -> In v (kverts t) -> 0 <= pr (phi3 v) <= h) ->
  (j < NQ)%nat -> (k < NQ)%nat -> (sh n < sh n')%Z -> inside (cell_piece (j, n)) x -> inside (cell_piece (k, n')) x -> False.
Proof.
  intros AP PA PV [z0 Hz0] U Hj Hk L I I'. pose proof h_pos as hp.
  assert (AP' := AP). destruct AP as [a [b [d [e0 PR]]]].
  apply (apart_affine (fun y => pr y - h * IZR (sh n')) (cell_piece (k, n')) (cell_piece (j, n)) x); auto.
  - exists a, b, d, (e0 - h * IZR (sh n')). intros y. rewrite PR. ring.
  - destruct (Req_dec (pr z0) (h * IZR (sh n'))) as [E|E]; [|exists z0; lra].
    exists (add z0 z0). rewrite PA, E. rewrite E in Hz0. lra.
  - unfold Degree.piece; cbn [fst snd]. rewrite vol_ttr. apply cQ_vol; auto.
  - unfold Degree.piece; cbn [fst snd]. rewrite vol_ttr. apply cQ_vol; auto.
  - intros v Hv. apply in_piece_verts in Hv as [w [Hw ->]]. rewrite PA, PV. cbn [fst snd]. destruct (U _ w (cell_In k Hk) Hw). lra.
  - intros v Hv. apply in_piece_verts in Hv as [w [Hw ->]]. rewrite PA, PV. cbn [fst snd]. destruct (U _ w (cell_In j Hj) Hw).
    assert (L' : (sh n + 1 <= sh n')%Z) by lia. apply IZR_le in L'. rewrite plus_IZR in L'. nra.
Qed.
Lemma unit_coordinates t v : In t (unit_cell c) -> In v (kverts t) ->
  ((1 <= r)%nat -> 0 <= px (phi3 v) <= h) /\ ((2 <= r)%nat -> 0 <= py (phi3 v) <= h) /\ ((3 <= r)%nat -> 0 <= pz (phi3 v) <= h).
Proof.
  intros It Hv. destruct chk_pieces as [_ [_ [U _]]]. specialize (U t It). unfold Checker.chk_unit in U. cbv zeta in U.
  rewrite forallb_forall in U. specialize (U v Hv). rewrite !andb_true_iff in U. destruct U as [[U1 U2] U3].
  assert (X : forall x, ale zero x && ale x (aofZ den) = true -> 0 <= phi x <= h).
  { intros x H. apply andb_true_iff in H as [H1 H2]. apply ale_ok in H1, H2. rewrite phi_zero in H1. rewrite phi_Z in H2. auto. }
  unfold phi3; cbn [px py pz]. split; [|split]; intros R; apply X.
  - destruct (Nat.leb_spec 1 r); [auto|lia].
  - destruct (Nat.leb_spec 2 r); [auto|lia].
  - destruct (Nat.leb_spec 3 r); [auto|lia].
Qed.
Lemma cQ_apart x cc cc' : Degree.valid NQ (latb r) cc -> Degree.valid NQ (latb r) cc' -> inside (cell_piece cc) x -> inside (cell_piece cc') x -> cc = cc'.
Proof.
  destruct cc as [j n], cc' as [k n']. intros [Hj Hn] [Hk Hn'] I I'. cbn [fst snd] in *. apply latb_iff in Hn, Hn'.
  assert (D : n = n').
  { destruct n as [[n1 n2] n3], n' as [[n1' n2'] n3'].
    assert (X : ~ (1 <= r)%nat -> n1 = n1') by (intros R; destruct r as [|[|[|]]]; cbn in Hn, Hn'; lia).
    assert (Y : ~ (2 <= r)%nat -> n2 = n2') by (intros R; destruct r as [|[|[|]]]; cbn in Hn, Hn'; lia).
    assert (Z : ~ (3 <= r)%nat -> n3 = n3') by (intros R; destruct r as [|[|[|]]]; cbn in Hn, Hn'; lia).
    assert (LX : forall j k n n', (1 <= r)%nat -> (j < NQ)%nat -> (k < NQ)%nat -> inside (cell_piece (j, n)) x -> inside (cell_piece (k, n')) x -> (fst (fst n) < fst (fst n'))%Z -> False).
    { intros j' k' d d' R Hj' Hk' I1 I2 L. apply (layers_apart px (fun d => fst (fst d)) j' k' d d' x); auto.
      - exists 1, 0, 0, 0. intros; ring.
      - intros [[? ?] ?]; reflexivity.
      - exists (Point 1 0 0). cbn. lra.
      - intros t v It Iv. apply (unit_coordinates t v It Iv), R. }
    assert (LY : forall j k n n', (2 <= r)%nat -> (j < NQ)%nat -> (k < NQ)%nat -> inside (cell_piece (j, n)) x -> inside (cell_piece (k, n')) x -> (snd (fst n) < snd (fst n'))%Z -> False).
    { intros j' k' d d' R Hj' Hk' I1 I2 L. apply (layers_apart py (fun d => snd (fst d)) j' k' d d' x); auto.
      - exists 0, 1, 0, 0. intros; ring.
      - intros [[? ?] ?]; reflexivity.
      - exists (Point 0 1 0). cbn. lra.
      - intros t v It Iv. apply (unit_coordinates t v It Iv), R. }
    assert (LZ : forall j k n n', (3 <= r)%nat -> (j < NQ)%nat -> (k < NQ)%nat -> inside (cell_piece (j, n)) x -> inside (cell_piece (k, n')) x -> (snd n < snd n')%Z -> False).
    { intros j' k' d d' R Hj' Hk' I1 I2 L. apply (layers_apart pz (fun d => snd d) j' k' d d' x); auto.
      - exists 0, 0, 1, 0. intros; ring.
      - intros [[? ?] ?]; reflexivity.
      - exists (Point 0 0 1). cbn. lra.
      - intros t v It Iv. apply (unit_coordinates t v It Iv), R. }
    f_equal; [f_equal|].
    - destruct (le_dec 1 r) as [R|R]; [|auto]. destruct (Z.lt_total n1 n1') as [L|[L|L]]; auto; exfalso;
        [apply (LX _ _ _ _ R Hj Hk I I' L) | apply (LX _ _ _ _ R Hk Hj I' I L)].
    - destruct (le_dec 2 r) as [R|R]; [|auto]. destruct (Z.lt_total n2 n2') as [L|[L|L]]; auto; exfalso;
        [apply (LY _ _ _ _ R Hj Hk I I' L) | apply (LY _ _ _ _ R Hk Hj I' I L)].
    - destruct (le_dec 3 r) as [R|R]; [|auto]. destruct (Z.lt_total n3 n3') as [L|[L|L]]; auto; exfalso;
        [apply (LZ _ _ _ _ R Hj Hk I I' L) | apply (LZ _ _ _ _ R Hk Hj I' I L)]. }
  subst n'. f_equal. destruct (lt_eq_lt_dec j k) as [[L|L]|L]; auto; exfalso.
  - apply (same_shift_apart j k n x); auto.
  - apply (same_shift_apart k j n x); auto.
Qed.

(** The volume sum. *)
Lemma kvolume_sum : forall ts s f, (forall j t, nth_error ts j = Some t -> f (s + j)%nat = vol (phiT t)) ->
  phi (kvolume ts) = rsum f (seq s (length ts)).
Proof.
  induction ts as [|t ts IH]; intros s f H.
  - apply phi_zero.
  - cbn [Checker.kvolume fold_right length seq rsum]. rewrite phi_add, phi_D.
    change (fold_right _ zero ts) with (kvolume ts). rewrite (IH (S s) f).
    + f_equal. specialize (H 0%nat t eq_refl). rewrite Nat.add_0_r in H. rewrite H. reflexivity.
    + intros j t' E. replace (S s + j)%nat with (s + S j)%nat by lia. apply H. exact E.
Qed.
Lemma volumes_equal : rsum (fun k => vol (cT k)) (seq 0 N) = rsum (fun k => vol (cQ k)) (seq 0 NQ).
Proof.
  destruct chk_pieces as [_ [_ [_ [_ H]]]].
  rewrite (kvolume_sum (positions c) 0 (fun k => vol (cT k))), (kvolume_sum (unit_cell c) 0 (fun k => vol (cQ k))) in H.
  - unfold Checker.positions in H. rewrite map_length in H. exact H.
  - intros j t E. cbn [Nat.add]. unfold cQ. rewrite (nth_error_nth _ _ _ E). reflexivity.
  - intros j t E. cbn [Nat.add]. unfold Checker.positions in E. rewrite nth_error_map in E. unfold cT. fold den vs in E.
    destruct (nth_error (c_tets c) j); [|discriminate]. injection E as <-. reflexivity.
Qed.
Lemma cover_once : (0 < N)%nat /\ covered_once N cT h (latb r) (open_domain Hs).
Proof.
  split; [apply chk_pieces|]. pose proof volumes_equal as E.
  apply (volume_covers_once N cT h r (open_domain Hs) cM h_pos (open_domain_open Hs) (open_domain_convex Hs)
    cdom_inside cvol cmate NQ cQ cQ_vol cQ_inside cQ_apart); [apply chk_pieces | lra].
Qed.
Lemma cN : (0 < N)%nat.
Proof. apply cover_once. Qed.
Lemma conce : covered_once N cT h (latb r) (open_domain Hs).
Proof. apply cover_once. Qed.

Lemma cgram : gpos (phiG (c_gram c)).
Proof.
  destruct BASE as [_ [_ H]]. unfold Checker.chk_gram in H. rewrite !andb_true_iff in H.
  destruct H as [[H1 H2] H3]. apply alt_ok in H1, H2, H3. rewrite phi_zero in *.
  rewrite phi_gdet in H3. rewrite phi_sub, !phi_mul in H2. unfold gpos, phiG at 1 2 3 4 5; cbn. auto.
Qed.

(** *** In Euclidean space *)
Section Basis.
Variables l1 l2 l3 : point.
Hypothesis HG : has_gram (dgram c) l1 l2 l3.
Let b1 := scale (/ h) l1.
Let b2 := scale (/ h) l2.
Let b3 := scale (/ h) l3.
Let e := E b1 b2 b3.
Let G := phiG (c_gram c).
Let s := / h * / h.
Definition cP (k : nat) : tetrahedron := Pk cT h l1 l2 l3 k.

Lemma s_pos : 0 < s.
Proof. unfold s. pose proof (Rinv_0_lt_compat h h_pos). repeat apply Rmult_lt_0_compat; auto. Qed.
(** The inner product of images: s times that of the Gram matrix. *)
Lemma dot_e u v : dot (e u) (e v) = s * gdot G u v.
Proof.
  assert (K : dot (e u) (e v) = / h * / h * gdot (dgram c) u v).
  { rewrite <- (gram_dot (dgram c) l1 l2 l3 u v HG). unfold e, dot, E, at_coordinates, b1, b2, b3. unf. ring. }
  rewrite K. unfold s, gdot, dgram, G, phiG; cbn [g11 g22 g33 g12 g13 g23]. unfold Rdiv. ring.
Qed.
Lemma cdet : det l1 l2 l3 <> 0.
Proof.
  pose proof (gram_det _ _ _ _ HG) as H. destruct cgram as [_ [_ D]]. intros Z. rewrite Z in H.
  assert (0 < gdet (dgram c)) by exact D. lra.
Qed.
Lemma cdetb : det b1 b2 b3 <> 0.
Proof. apply det_scl0; [apply h_pos|apply cdet]. Qed.

Lemma rp_dcorner q : e (rp q) = dcorner c l1 l2 l3 q.
Proof.
  pose proof h_pos as hp. unfold rp, Checker.pos, dcorner. rewrite phi3_add, phi3_ofZ. fold den vs h.
  destruct (snd q) as [[x y] z]. cbv zeta.
  assert (K : forall u n, (u + h * IZR n) * / h = u / h + IZR n) by (intros; field; lra).
  unfold e, E, b1, b2, b3, at_coordinates, vec, add, scale, phi3; cbn [px py pz]. apply point_eq; cbn [px py pz]; rewrite <- !K; ring.
Qed.
Lemma dtet_cP : dtet c l1 l2 l3 = cP.
Proof.
  apply functional_extensionality. intros k. unfold cP, Pk, cT, dtet. destruct (nth_error (c_tets c) k) as [t|].
  - unfold Euclid.Et, phiT, Checker.kpos; cbn [Checker.ka Checker.kb Checker.kc Checker.kd va vb vc vd].
    change (E (scale (/ h) l1) (scale (/ h) l2) (scale (/ h) l3)) with e.
    change (phi3 (pos den vs (q0 t))) with (rp (q0 t)). change (phi3 (pos den vs (q1 t))) with (rp (q1 t)).
    change (phi3 (pos den vs (q2 t))) with (rp (q2 t)). change (phi3 (pos den vs (q3 t))) with (rp (q3 t)).
    rewrite !rp_dcorner. reflexivity.
  - unfold Euclid.Et, phiT; cbn [Checker.ka Checker.kb Checker.kc Checker.kd va vb vc vd].
    assert (K : E (scale (/ h) l1) (scale (/ h) l2) (scale (/ h) l3) (phi3 vzero) = origin).
    { unfold phi3, Checker.vzero; cbn [Checker.vX Checker.vY Checker.vZ]. rewrite phi_zero.
      unfold E, at_coordinates, origin, add, scale; cbn [px py pz]. apply point_eq; cbn [px py pz]; ring. }
    rewrite K. reflexivity.
Qed.
Lemma nonempty_domain : exists z, open_domain Hs z.
Proof.
  exists (centroid (piece (0%nat, z30))). apply (cdom_inside (0%nat, z30)).
  - split; [apply cN | apply latb_zero].
  - apply cen_inter, pvol, cN.
Qed.

Lemma half_space_tiling : face_to_face_tiling l1 l2 l3 r (half_spaces l1 l2 l3 (map (descale h) Hs)) N (dtet c l1 l2 l3).
Proof.
  rewrite dtet_cP.
  apply transfer.
  - apply h_pos.
  - apply cdet.
  - apply cvol.
  - intros cc x Hc C H HI. apply (cdom_closed cc x); auto.
  - intros x Hx. apply (cover N cT h (latb r) (open_domain Hs) h_pos (open_domain_open Hs) cvol conce). destruct nonempty_domain as [z Hz]. apply domain_closure with (z := z); auto.
  - apply (disjoint_closed N cT h (latb r) (open_domain Hs) cdom_inside cvol conce).
  - apply (face_to_face N cT h (latb r) (open_domain Hs) cM h_pos (latb_add r) (open_domain_convex Hs)
      cdom_inside cvol cmate conce).
  - intros M. destruct (range N cT h (latb r) h_pos cvol M) as [K HK]. exists (cells N (latb r) K). exact HK.
Qed.

(** The half-spaces hold the convex hull of the polytope, and the hull all tiles; as the
    tiles cover what the half-spaces hold, it is the domain of the claim. *)
Let Wh := map phi3 (c_polytope c).
Lemma cpolytope_point : map (dpoint c) (c_polytope c) = map (scale (/ h)) Wh.
Proof.
  unfold Wh. rewrite map_map. apply map_ext. intros v. unfold dpoint, phi3. fold den h. pose proof h_pos.
  apply point_eq; unf; field; lra.
Qed.
Lemma domain_half_spaces X : ddomain c l1 l2 l3 X -> half_spaces l1 l2 l3 (map (descale h) Hs) X.
Proof.
  intros [x [-> Hx]]. exists x. split; auto. apply over_hull_domain in Hx. fold r in Hx. rewrite cpolytope_point in Hx.
  intros H HI. apply in_map_iff in HI as [H0 [<- HI]]. pose proof h_pos as hp.
  apply Rmult_le_reg_l with h; auto. rewrite Rmult_0_r, level_descale by apply h_pos.
  destruct chk_all as [_ [R3 [_ [_ [_ [_ [_ K]]]]]]]. unfold Checker.chk_polytope in K. fold r in K.
  destruct (Nat.leb_spec 3 r) as [R|R].
  - exfalso. unfold Hs in HI. destruct (c_domain c); [exact HI|discriminate].
  - apply andb_true_iff in K as [K _]. rewrite forallb_forall in K.
    apply level_over_hull with (r := r) (W := Wh); [lia|apply cinvariant; auto| |].
    + intros w Hw. unfold Wh in Hw. apply in_map_iff in Hw as [v [<- Hv]].
      unfold Hs in HI. apply in_map_iff in HI as [H1 [<- HI]]. specialize (K H1 HI). rewrite forallb_forall in K.
      specialize (K v Hv). apply ale_ok in K. rewrite phi_zero, phi_lev in K. exact K.
    + apply (over_hull_scale r _ h) in Hx. rewrite map_map in Hx.
      replace (map (fun x => scale h (scale (/ h) x)) Wh) with Wh in Hx; auto.
      rewrite <- (map_id Wh) at 1. apply map_ext. intros v. apply point_eq; unf; field; lra.
Qed.

Lemma agree_zeroed v : (r <= 3)%nat -> agree r (phi3 v) (phi3 (zeroed r v)).
Proof.
  intros R. unfold Checker.zeroed, phi3; cbn [Checker.vX Checker.vY Checker.vZ].
  destruct r as [|[|[|[|]]]]; cbn; auto; lia.
Qed.
Lemma agree_sym k x y : agree k x y -> agree k y x.
Proof. destruct k as [|[|[|k]]]; cbn; intuition congruence. Qed.
Lemma cvertex cc v : valid cc -> In v (verts (piece cc)) -> over_hull r Wh v.
Proof.
  destruct cc as [k n]. intros [Hk Hn] Hv. cbn [fst snd] in *. apply latb_iff in Hn.
  destruct chk_all as [_ [R3 [_ [_ [_ [_ [_ K]]]]]]]. unfold Checker.chk_polytope in K. fold r den in K.
  destruct (Nat.leb_spec 3 r) as [R|R]; [left; auto|].
  apply andb_true_iff in K as [_ K]. rewrite forallb_forall in K.
  destruct (get k Hk) as [t [E I]]. specialize (K (kpos den vs t)).
  unfold Checker.positions in K. fold den vs in K. specialize (K (in_map _ _ _ I)). rewrite forallb_forall in K.
  assert (W : exists w, In w (verts (cT k)) /\ v = add w (vec h n)).
  { unfold Degree.piece, translate, verts in Hv; cbn [fst snd va vb vc vd] in Hv. unfold verts. simpl in Hv |- *.
    destruct Hv as [<-|[<-|[<-|[<-|[]]]]]; eauto 8. }
  destruct W as [w [Hw ->]]. apply over_hull_agree with (y := w); [apply agree_shift; auto|].
  rewrite (cT_eq k t E) in Hw. apply phiT_verts in Hw as [w' [Hw' ->]].
  specialize (K w' Hw'). rewrite existsl_eq in K. apply existsb_exists in K as [q [_ K]]. unfold Checker.in_piece in K. cbv zeta in K.
  apply andb_true_iff in K as [K1 K2]. apply andb_true_iff in K2 as [K2 K3]. rewrite forallb_forall in K1, K3.
  apply over_hull_agree with (y := phi3 (zeroed r w')); [apply agree_zeroed; lia|].
  set (kt := piece_pos den (c_polytope c) q) in *.
  assert (V : 0 < vol (phiT kt)). { unfold Checker.chk_vol in K2. apply alt_ok in K2. rewrite phi_zero, phi_D in K2. exact K2. }
  assert (C : closed (phiT kt) (phi3 (zeroed r w'))).
  { intros i Hi. specialize (K3 i Hi). apply ale_ok in K3. rewrite phi_zero, phi_L in K3. exact K3. }
  apply hull_closed in C; auto. destruct C as [a [b [c0 [d [A1 [B1 [C1 [D1 [S1 ->]]]]]]]]].
  apply convex_combination; auto.
  - intros x y s0 Hx Hy S0. apply over_hull_convex; auto.
  - intros u Hu.
    assert (Y : forall a, In a (piece_corners q) -> over_hull r Wh (phi3 (pos den (c_polytope c) a))).
    { intros a' Ha. specialize (K1 a' Ha). apply andb_true_iff in K1 as [L1 L2]. apply N.ltb_lt in L1. apply latb_iff in L2.
      unfold Checker.pos. rewrite phi3_add, phi3_ofZ. apply over_hull_agree with (y := phi3 (nth (N.to_nat (fst a')) (c_polytope c) vzero)).
      - apply agree_shift; auto.
      - right. eexists. split; [|destruct r as [|[|[|]]]; cbn; auto].
        apply hull_vertex. unfold Wh. apply in_map, nth_In. lia. }
    unfold kt, Checker.piece_pos in Hu. destruct q as [[[qa qb] qc] qd]. cbn [piece_corners] in Y.
    simpl in Hu. destruct Hu as [<-|[<-|[<-|[<-|[]]]]]; apply Y; simpl; auto.
Qed.

Theorem tiling_sound : face_to_face_tiling l1 l2 l3 r (ddomain c l1 l2 l3) N (dtet c l1 l2 l3).
Proof.
  pose proof half_space_tiling as T. destruct T as [T1 T2 T3 T4 T5 T6 T7]. constructor; auto.
  2:{ intros X HX. apply T5, domain_half_spaces, HX. }
  clear T1 T2 T3 T4 T5 T6 T7. rewrite dtet_cP. intros cc X Hc H. apply valid_is_tile in Hc. unfold cP in H.
  rewrite (tile_piece cT h l1 l2 l3 h_pos) in H. fold b1 b2 b3 in H.
  rewrite <- (E_Einv b1 b2 b3 cdetb X) in H |- *. rewrite (hull_Et b1 b2 b3 cdetb) in H.
  set (x := Einv b1 b2 b3 X) in *. unfold b1, b2, b3. rewrite E_scaled.
  exists (scale (/ h) x). split; auto. apply over_hull_domain. fold r. rewrite cpolytope_point. apply over_hull_scale.
  destruct H as [a [b [c0 [d [A1 [B1 [C1 [D1 [S1 ->]]]]]]]]].
  apply convex_combination; auto.
  - intros; apply over_hull_convex; auto.
  - intros v Hv. apply (cvertex cc); auto.
Qed.

(** *** Dihedral angles *)
Lemma e_sub x y : e (sub x y) = sub (e x) (e y).
Proof. apply E_sub. Qed.
Lemma kac_C a b c0 d : acpoly dot (sub (e (phi3 b)) (e (phi3 a))) (sub (e (phi3 c0)) (e (phi3 a))) (sub (e (phi3 d)) (e (phi3 a)))
  = s * s * phi (kac (c_gram c) a b c0 d).
Proof.
  rewrite <- !e_sub. unfold acpoly. rewrite !dot_e. unfold Checker.kac. rewrite phi_sub, !phi_mul, !phi_gdot, !phi3_sub. fold G. ring.
Qed.
Lemma ss_pos : 0 < s * s.
Proof. pose proof s_pos. apply Rmult_lt_0_compat; auto. Qed.

Lemma acute_sound a b c0 d : orient (e (phi3 a)) (e (phi3 b)) (e (phi3 c0)) (e (phi3 d)) <> 0 ->
  chk_acute A aadd asub amul aofZ alt (c_gram c) a b c0 d = true ->
  dihedral (e (phi3 a)) (e (phi3 b)) (e (phi3 c0)) (e (phi3 d)) < PI / 2.
Proof.
  intros V H. apply alt_ok in H. rewrite phi_zero in H. apply acute_rule; auto. rewrite kac_C.
  apply Rmult_lt_0_compat; auto using ss_pos.
Qed.
Lemma nonobtuse_sound a b c0 d : orient (e (phi3 a)) (e (phi3 b)) (e (phi3 c0)) (e (phi3 d)) <> 0 ->
  chk_nonobtuse A aadd asub amul aofZ ale (c_gram c) a b c0 d = true ->
  dihedral (e (phi3 a)) (e (phi3 b)) (e (phi3 c0)) (e (phi3 d)) <= PI / 2.
Proof.
  intros V H. apply ale_ok in H. rewrite phi_zero in H. apply nonobtuse_rule; auto. rewrite kac_C.
  pose proof ss_pos. apply Rmult_le_pos; lra.
Qed.
(** [chk_root], of numbers that are k and k^2 times the true ones. *)
Lemma root_sound (less : A -> A -> bool) (Less : R -> R -> Prop) sg p q x m k :
  (forall x y, less x y = true -> Less (phi x) (phi y)) -> (forall k x y, 0 < k -> Less x y -> Less (k * x) (k * y)) ->
  0 < IZR q -> 0 < k -> chk_root less sg p q x m = true -> below_root Less sg (phi p / IZR q) (k * phi x) (k * k * phi m).
Proof.
  intros LO LM Hq Hk H. unfold Checker.chk_root in H. unfold below_root.
  assert (K : 0 < k * k / IZR q) by (apply Rdiv_lt_0_compat; auto; apply Rmult_lt_0_compat; auto).
  assert (E1 : phi p / IZR q * (k * k * phi m) = k * k / IZR q * (phi p * phi m)) by (field; lra).
  assert (E2 : k * phi x * (k * phi x) = k * k / IZR q * (IZR q * (phi x * phi x))) by (field; lra).
  assert (P : ale zero x = true -> 0 <= k * phi x).
  { intros X. apply ale_ok in X. rewrite phi_zero in X. apply Rmult_le_pos; lra. }
  destruct sg as [|g|g].
  - apply LO, (LM k) in H; auto. rewrite phi_zero, Rmult_0_r in H. exact H.
  - destruct (ale zero x) eqn:X; [|discriminate]. split; auto. apply LO in H. rewrite !phi_mul, phi_Z in H. rewrite E1, E2. auto.
  - destruct (ale zero x) eqn:X; [left; auto|]. right. apply LO in H. rewrite !phi_mul, phi_Z in H. rewrite E1, E2. auto.
Qed.
Lemma bound_sound sg p q : chk_bound sg p q = true -> 0 < IZR q /\ sign_ok sg (phi p / IZR q).
Proof.
  intros H. unfold Checker.chk_bound in H. apply andb_true_iff in H as [Q H]. apply Z.ltb_lt, IZR_lt in Q. split; auto.
  assert (F : alt zero p && ale p (aofZ q) = true -> 0 < phi p / IZR q <= 1).
  { intros X. apply andb_true_iff in X as [X1 X2]. apply alt_ok in X1. apply ale_ok in X2. rewrite phi_zero in X1. rewrite phi_Z in X2.
    split; [apply Rdiv_lt_0_compat; auto|]. apply Rmult_le_reg_r with (IZR q); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  destruct sg as [|[g|g|]|[g|g|]]; cbn [sign_ok]; try discriminate; auto.
Qed.
Lemma angle_sound o sg p q a b c0 d : orient (e (phi3 a)) (e (phi3 b)) (e (phi3 c0)) (e (phi3 d)) <> 0 ->
  chk_bound sg p q = true -> chk_angle (c_gram c) sg p q o a b c0 d = true ->
  compares o (dihedral (e (phi3 a)) (e (phi3 b)) (e (phi3 c0)) (e (phi3 d))) (dangle sg p q).
Proof.
  intros V B H. destruct (bound_sound _ _ _ B) as [Q F]. apply bound_rule; auto. rewrite !kac_C.
  pose proof ss_pos as SS. set (k := s * s) in *. clearbody k.
  change (Checker.chk_rule A asub amul aofZ alt ale sg p q o (kac (c_gram c) a b c0 d) (amul (kac (c_gram c) a b c0 c0) (kac (c_gram c) a b d d)) = true) in H.
  unfold Checker.chk_rule in H. set (x := kac (c_gram c) a b c0 d) in *.
  set (y := kac (c_gram c) a b c0 c0) in *. set (z := kac (c_gram c) a b d d) in *.
  replace (k * phi y * (k * phi z)) with (k * k * phi (amul y z)) by (rewrite phi_mul; ring).
  assert (NX : - (k * phi x) = k * phi (asub zero x)) by (rewrite phi_sub, phi_zero; ring).
  destruct o; cbn [compares_root]; rewrite ?NX.
  - apply (root_sound alt Rlt); auto. intros; apply Rmult_lt_compat_l; auto.
  - apply (root_sound ale Rle); auto. intros; apply Rmult_le_compat_l; lra.
  - apply (root_sound ale Rle); auto. intros; apply Rmult_le_compat_l; lra.
  - apply (root_sound alt Rlt); auto. intros; apply Rmult_lt_compat_l; auto.
Qed.

(** *** The tiles and their tetrahedra *)
Definition item (cc : cell) : ktet := match nth_error (positions c) (fst cc) with Some t => t | None => KT A vzero vzero vzero vzero end.
Lemma item_in cc : is_tile r N cc -> In (item cc) (positions c).
Proof.
  intros [Hk _]. destruct (get (fst cc) Hk) as [t [Et It]]. unfold item, Checker.positions. rewrite nth_error_map, Et. apply in_map, It.
Qed.
Lemma in_item t : In t (positions c) -> exists cc, is_tile r N cc /\ item cc = t.
Proof.
  intros H. apply In_nth_error in H as [k E]. exists (k, z30). split.
  - split; [|apply latb_iff, latb_zero]. cbn [fst]. assert (L : (k < length (positions c))%nat) by (apply nth_error_Some; congruence).
    unfold Checker.positions in L. rewrite map_length in L. exact L.
  - unfold item; cbn [fst]. rewrite E. reflexivity.
Qed.
Definition real_tile (cc : cell) := Euclid.Et b1 b2 b3 (phiT (item cc)).
Lemma tile_item cc : is_tile r N cc -> tile l1 l2 l3 cP cc = translate (lattice_vector l1 l2 l3 (snd cc)) (real_tile cc) /\ vol (real_tile cc) <> 0.
Proof.
  intros [Hk _]. destruct (get (fst cc) Hk) as [t [Et It]]. unfold real_tile, item, Checker.positions. rewrite nth_error_map, Et. cbn [option_map]. split.
  - unfold tile, cP, Pk. rewrite (cT_eq (fst cc) t Et). reflexivity.
  - rewrite vol_Et. apply Rmult_integral_contrapositive_currified; [|apply cdetb].
    pose proof (cvol (fst cc) Hk) as V. rewrite (cT_eq (fst cc) t Et) in V. unfold den, vs in V. lra.
Qed.
(** The numbers of the six edges. *)
Definition edge_angle := on_edge (fun a b c0 d => dihedral (e (phi3 a)) (e (phi3 b)) (e (phi3 c0)) (e (phi3 d))).
Definition edge_square := on_edge (fun a b _ _ => distance_squared (e (phi3 a)) (e (phi3 b))).
Lemma dihedrals_six cc : is_tile r N cc -> dihedrals (tile l1 l2 l3 cP cc) = map edge_angle (six (item cc)).
Proof. intros H. rewrite (proj1 (tile_item cc H)), dihedrals_translate. reflexivity. Qed.
Lemma six_orient t i : vol (Euclid.Et b1 b2 b3 (phiT t)) <> 0 -> In i (six t) ->
  on_edge (fun a b c0 d => orient (e (phi3 a)) (e (phi3 b)) (e (phi3 c0)) (e (phi3 d))) i <> 0.
Proof.
  intros V Hi. unfold vol, Euclid.Et, phiT in V; cbn [va vb vc vd] in V. change (E b1 b2 b3) with e in V.
  assert (PV : forall X Y, X <> 0 -> (Y = X \/ Y = - X) -> Y <> 0) by (intros X Y HX [->| ->]; lra).
  unfold Checker.six in Hi. simpl in Hi.
  destruct Hi as [<-|[<-|[<-|[<-|[<-|[<-|[]]]]]]]; cbn [Checker.on_edge]; (eapply PV; [exact V|]; unfold orient; clear; unf; (left; ring) || (right; ring)).
Qed.
Lemma each_angle (f : v3 -> v3 -> v3 -> v3 -> bool) (Q : R -> Prop) :
  (forall a b c0 d, orient (e (phi3 a)) (e (phi3 b)) (e (phi3 c0)) (e (phi3 d)) <> 0 -> f a b c0 d = true ->
     Q (dihedral (e (phi3 a)) (e (phi3 b)) (e (phi3 c0)) (e (phi3 d)))) ->
  forallb (fun t => forallb (on_edge f) (six t)) (positions c) = true ->
  forall cc x, is_tile r N cc -> In x (dihedrals (tile l1 l2 l3 cP cc)) -> Q x.
Proof.
  intros HQ HF cc x Hc Hx. rewrite (dihedrals_six cc Hc) in Hx. apply in_map_iff in Hx as [i [<- Hi]].
  rewrite forallb_forall in HF. specialize (HF _ (item_in cc Hc)). rewrite forallb_forall in HF. specialize (HF i Hi).
  pose proof (six_orient _ i (proj2 (tile_item cc Hc)) Hi) as V. destruct i as [[[a b] c0] d]. apply HQ; auto.
Qed.
Lemma item_angle cc sg p q o i : is_tile r N cc -> chk_bound sg p q = true -> In i (six (item cc)) ->
  on_edge (chk_angle (c_gram c) sg p q o) i = true -> compares o (edge_angle i) (dangle sg p q).
Proof.
  intros Hc B Hi H. pose proof (six_orient _ i (proj2 (tile_item cc Hc)) Hi) as V. destruct i as [[[a b] c0] d].
  apply (angle_sound o sg p q); auto.
Qed.
Lemma largest_sound rel sg p q : chk_bound sg p q = true ->
  related rel (fun t => test_largest (fun o => on_edge (chk_angle (c_gram c) sg p q o)) (six t)) (positions c) = true ->
  largest_dihedral_angle l1 l2 l3 r N cP rel (dangle sg p q).
Proof.
  intros B. apply related_ok with (item := item); [exact item_in|exact in_item|]. intros cc Hc. rewrite (dihedrals_six cc Hc).
  destruct (largest_exists (edge_angle (ka (item cc), kb (item cc), kc (item cc), kd (item cc))) (tl (map edge_angle (six (item cc))))) as [x Hx].
  exists x. split; [exact Hx|]. intros o. apply (test_largest_ok _ _ edge_angle); [|exact Hx]. intros o' i Hi. apply (item_angle cc); auto.
Qed.
Lemma smallest_sound rel sg p q : chk_bound sg p q = true ->
  related rel (fun t => test_smallest (fun o => on_edge (chk_angle (c_gram c) sg p q o)) (six t)) (positions c) = true ->
  smallest_dihedral_angle l1 l2 l3 r N cP rel (dangle sg p q).
Proof.
  intros B. apply related_ok with (item := item); [exact item_in|exact in_item|]. intros cc Hc. rewrite (dihedrals_six cc Hc).
  destruct (smallest_exists (edge_angle (ka (item cc), kb (item cc), kc (item cc), kd (item cc))) (tl (map edge_angle (six (item cc))))) as [x Hx].
  exists x. split; [exact Hx|]. intros o. apply (test_smallest_ok _ _ edge_angle); [|exact Hx]. intros o' i Hi. apply (item_angle cc); auto.
Qed.

(** *** The radius *)
Lemma distance_e a b : distance_squared (e (phi3 a)) (e (phi3 b)) = s * phi (kgdot (c_gram c) (vsub b a) (vsub b a)).
Proof.
  unfold distance_squared. rewrite <- e_sub, dot_e, phi_gdot, phi3_sub. fold G. f_equal.
  unfold gdot. unf. ring.
Qed.
Lemma distance_sym u v : distance_squared u v = distance_squared v u.
Proof. unfold distance_squared, dot. unf. ring. Qed.
Lemma distance_translate u v w : distance_squared (add u w) (add v w) = distance_squared u v.
Proof. unfold distance_squared, dot. unf. ring. Qed.
Lemma distance_pos u v : u <> v -> 0 < distance_squared u v.
Proof.
  intros Ne. apply dot_self_pos. intros Z. apply Ne. pose proof (f_equal px Z) as X. pose proof (f_equal py Z) as Y. pose proof (f_equal pz Z) as W.
  unf. apply point_eq; lra.
Qed.
Definition on_edges (f : R -> R -> R -> R -> R -> R -> R) (t : ktet) : R :=
  let e1 := sub (phi3 (kb t)) (phi3 (ka t)) in let e2 := sub (phi3 (kc t)) (phi3 (ka t)) in let e3 := sub (phi3 (kd t)) (phi3 (ka t)) in
  f (gdot G e1 e1) (gdot G e2 e2) (gdot G e3 e3) (gdot G e1 e2) (gdot G e1 e3) (gdot G e2 e3).
Lemma kradius_x t : phi (fst (kradius (c_gram c) t)) = on_edges radius_form t.
Proof.
  unfold Checker.kradius; cbn [fst]. repeat rewrite ?phi_add, ?phi_sub, ?phi_mul, ?phi_Z. rewrite !phi_gdot, !phi3_sub. reflexivity.
Qed.
Lemma kradius_d t : phi (snd (kradius (c_gram c) t)) = on_edges gram_form t.
Proof.
  unfold Checker.kradius; cbn [snd]. repeat rewrite ?phi_add, ?phi_sub, ?phi_mul. rewrite !phi_gdot, !phi3_sub. reflexivity.
Qed.
Lemma compare_ok o x y : chk_compare o x y = true -> compares o (phi x) (phi y).
Proof. destruct o; [apply alt_ok|apply ale_ok|apply ale_ok|apply alt_ok]. Qed.
Lemma compares_scale o k x y : 0 < k -> compares o x y -> compares o (k * x) (k * y).
Proof. intros K H. destruct o; cbn [compares] in *; try (apply Rmult_lt_compat_l; lra); apply Rmult_le_compat_l; lra. Qed.
Lemma ratio_sound t o p q a b : let T := Euclid.Et b1 b2 b3 (phiT t) in vol T <> 0 -> 0 < IZR q ->
  0 < distance_squared (e (phi3 a)) (e (phi3 b)) -> chk_ratio (c_gram c) p q (kradius (c_gram c) t) o a b = true ->
  compares o (distance_squared (va T) (circumcentre T) / distance_squared (e (phi3 a)) (e (phi3 b))) (phi p / IZR q).
Proof.
  intros T V Q D H. pose proof s_pos as S. apply radius_rule; auto.
  unfold Checker.chk_ratio in H. cbv zeta in H. apply compare_ok in H. rewrite !phi_mul, !phi_Z, kradius_x, kradius_d in H.
  rewrite distance_e. unfold T, Euclid.Et, phiT; cbn [va vb vc vd].
  change (E b1 b2 b3) with e. rewrite <- !e_sub, !dot_e.
  assert (S4 : 0 < s * s * (s * s)) by (apply Rmult_lt_0_compat; apply ss_pos).
  unfold on_edges in H. cbv zeta in H.
  set (e1 := sub (phi3 (kb t)) (phi3 (ka t))) in *. set (e2 := sub (phi3 (kc t)) (phi3 (ka t))) in *. set (e3 := sub (phi3 (kd t)) (phi3 (ka t))) in *.
  set (m11 := gdot G e1 e1) in *. set (m22 := gdot G e2 e2) in *. set (m33 := gdot G e3 e3) in *.
  set (m12 := gdot G e1 e2) in *. set (m13 := gdot G e1 e3) in *. set (m23 := gdot G e2 e3) in *. set (l := phi (kgdot _ _ _)) in *.
  replace (radius_form (s * m11) (s * m22) (s * m33) (s * m12) (s * m13) (s * m23)) with (s * s * (s * s) * radius_form m11 m22 m33 m12 m13 m23) by (unfold radius_form; ring).
  replace (gram_form (s * m11) (s * m22) (s * m33) (s * m12) (s * m13) (s * m23)) with (s * s * s * gram_form m11 m22 m33 m12 m13 m23) by (unfold gram_form; ring).
  apply (compares_scale _ _ _ _ S4) in H. clearbody m11 m22 m33 m12 m13 m23 l s.
  set (rf := radius_form _ _ _ _ _ _) in *. set (gf := gram_form _ _ _ _ _ _) in *. clearbody rf gf.
  replace (IZR q * (s * s * (s * s) * rf)) with (s * s * (s * s) * (IZR q * rf)) by ring.
  replace (4 * phi p * (s * s * s * gf) * (s * l)) with (s * s * (s * s) * (4 * phi p * gf * l)) by ring. exact H.
Qed.
Lemma six_square t i : vol (Euclid.Et b1 b2 b3 (phiT t)) <> 0 -> In i (six t) -> 0 < edge_square i.
Proof.
  intros V Hi. pose proof (six_orient t i V Hi) as O. destruct i as [[[a b] c0] d]. apply distance_pos. intros E. apply O.
  cbn [Checker.on_edge]. rewrite E. unfold orient. unf. ring.
Qed.
Lemma circumscribed_translate t C q w : circumscribed t C q -> circumscribed (translate w t) (add C w) q.
Proof. intros H v Hv. apply translate_verts in Hv as [u [Hu ->]]. rewrite distance_translate. apply H, Hu. Qed.
Lemma radius_sound rel p q : 0 < IZR q -> related rel (chk_radius (c_gram c) p q) (positions c) = true ->
  squared_radius_edge_ratio l1 l2 l3 r N cP rel (phi p / IZR q).
Proof.
  intros Q. apply related_ok with (item := item); [exact item_in|exact in_item|]. intros cc Hc.
  destruct (tile_item cc Hc) as [-> V]. set (w := lattice_vector _ _ _ _). set (t := item cc) in *.
  set (T := real_tile cc) in *. set (R2 := distance_squared (va T) (circumcentre T)).
  assert (ES : squared_edges (translate w T) = map edge_square (six t)).
  { unfold squared_edges, translate; cbn [va vb vc vd]. rewrite !distance_translate. reflexivity. }
  destruct (smallest_exists (edge_square (ka t, kb t, kc t, kd t)) (tl (map edge_square (six t)))) as [l Hl].
  change (smallest (map edge_square (six t)) l) in Hl.
  exists (R2 / l). split.
  - exists (add (circumcentre T) w), R2, l. split; [|split; [rewrite ES; exact Hl|reflexivity]].
    apply circumscribed_translate, circumscribed_centre, V.
  - intros o. unfold Checker.chk_radius. cbv zeta. apply (test_largest_ok _ _ (fun i => R2 / edge_square i)).
    + intros o' i Hi H. pose proof (six_square t i V Hi) as D. destruct i as [[[a b] c0] d]. apply ratio_sound; auto.
    + rewrite <- (map_map edge_square (fun x => R2 / x)). apply largest_quotient; auto.
      * unfold R2, distance_squared. set (u := sub _ _). unfold dot.
        pose proof (Rle_0_sqr (px u)); pose proof (Rle_0_sqr (py u)); pose proof (Rle_0_sqr (pz u)). unfold Rsqr in *. lra.
      * intros x Hx. apply in_map_iff in Hx as [i [<- Hi]]. apply (six_square t); auto.
Qed.

(** *** Delaunay *)
Lemma cpower k i : (k < N)%nat -> In i I4 -> forall less, chk_delaunay A aadd asub amul aofZ less c = true ->
  match cM k i with
  | Some (k', i', d) => exists x, less x zero = true /\ phi x = - (vol (cT k) * power G (cT k) (vx (translate (vec h d) (cT k')) i'))
  | None => True end.
Proof.
  intros Hk Hi less H. destruct (get k Hk) as [t [Et It]].
  unfold Checker.chk_delaunay in H. rewrite forallb_forall in H. specialize (H t It). rewrite forallb_forall in H. specialize (H i Hi).
  unfold Checker.chk_power in H. unfold cM. rewrite Et. destruct (mt t i) as [[[k' i'] d]|]; auto.
  unfold Checker.positions in H. fold den vs in H. rewrite nth_error_map in H.
  destruct (nth_error (c_tets c) (N.to_nat k')) as [t'|] eqn:E'; [|discriminate]. cbn [option_map] in H.
  eexists. split; [exact H|].
  rewrite phi_power, phi3_add, phi3_ofZ, phi_vx, vx_translate'. fold h G.
  rewrite power_power_sum by (pose proof (cvol k Hk); lra).
  rewrite (cT_eq k t Et), (cT_eq _ t' E'). ring.
Qed.

(** The power is the squared distance to the centre minus the squared radius. *)
Lemma power_distance t x : 0 < vol t ->
  let C := circumcentre (Euclid.Et b1 b2 b3 t) in
  distance_squared (e x) C - distance_squared (e (va t)) C = s * power G t x.
Proof.
  intros V C. set (sr := distance_squared (e (va t)) C).
  assert (V' : vol (Euclid.Et b1 b2 b3 t) <> 0).
  { rewrite vol_Et. apply Rmult_integral_contrapositive_currified; [lra|apply cdetb]. }
  pose proof (circumscribed_centre _ V') as CC. fold C in CC. cbn [Euclid.Et va] in CC. fold e in CC. fold sr in CC.
  set (f := fun x => distance_squared (e x) C - sr - s * power G t x).
  assert (Af : affine f).
  { apply aff_ext with (f := fun x => (-2) * dot (e x) C + (-s) * lift G t x + (dot C C - sr)).
    - intros y. unfold f, power. rewrite Rmult_plus_distr_l. unfold sq. rewrite <- dot_e.
      unfold distance_squared. unfold dot. unf. ring.
    - apply aff_add; [apply aff_add; apply aff_scl; [|apply aff_lift]|].
      + exists (dot b1 C), (dot b2 C), (dot b3 C), 0. intros y. unfold e, E, at_coordinates, dot. unf. ring.
      + exists 0, 0, 0, (dot C C - sr). intros; ring. }
  assert (Z : forall v, In v (verts t) -> f v = 0).
  { intros v Hv. unfold f. rewrite (power_vertex G t v) by (auto; lra).
    rewrite (CC (e v)); [ring|]. apply (in_map e) in Hv. exact Hv. }
  pose proof (interpolate t f x Af) as I. rewrite (Z (va t)), (Z (vb t)), (Z (vc t)), (Z (vd t)) in I by (simpl; auto).
  assert (FX : f x = 0). { apply Rmult_eq_reg_l with (vol t); [|lra]. rewrite I. ring. }
  unfold f in FX. lra.
Qed.

Lemma tile_cP cc : tile l1 l2 l3 cP cc = Euclid.Et b1 b2 b3 (piece cc).
Proof. apply tile_piece, h_pos. Qed.
Lemma vertex_coordinates v : is_vertex l1 l2 l3 r N cP v -> exists cc x, valid cc /\ In x (verts (piece cc)) /\ v = e x.
Proof.
  intros [cc [Hc Hv]]. apply valid_is_tile in Hc. rewrite tile_cP in Hv. 
  unfold verts, Euclid.Et in Hv; cbn [va vb vc vd] in Hv.
  exists cc. simpl in Hv. destruct Hv as [<-|[<-|[<-|[<-|[]]]]]; eexists; (split; [exact Hc|]; split; [|reflexivity]); simpl; auto.
Qed.

Lemma weak_local less : (forall x y, less x y = true -> phi x <= phi y) -> chk_delaunay A aadd asub amul aofZ less c = true ->
  forall k i, (k < N)%nat -> In i I4 ->
  match cM k i with Some (k', i', d) => 0 <= power G (cT k) (vx (translate (vec h d) (cT k')) i') | None => True end.
Proof.
  intros LE H k i Hk Hi. pose proof (cpower k i Hk Hi less H) as X. destruct (cM k i) as [[[k' i'] d]|]; auto.
  destruct X as [x [X1 X2]]. apply LE in X1. rewrite phi_zero, X2 in X1. pose proof (cvol k Hk).
  apply Rmult_le_reg_l with (vol (cT k)); auto. lra.
Qed.

Lemma weakly_sound less : (forall x y, less x y = true -> phi x <= phi y) -> chk_delaunay A aadd asub amul aofZ less c = true ->
  forall cc v, valid cc -> is_vertex l1 l2 l3 r N cP v ->
  let C := circumcentre (tile l1 l2 l3 cP cc) in distance_squared (va (tile l1 l2 l3 cP cc)) C <= distance_squared v C.
Proof.
  intros LE H cc v Hc Hv. apply vertex_coordinates in Hv as [c' [x [Hc' [Hx ->]]]]. rewrite tile_cP. cbv zeta.
  assert (V : 0 < vol (piece cc)) by (destruct cc; apply pvol, Hc).
  pose proof (power_distance (piece cc) x V) as PD. cbv zeta in PD.
  pose proof (weakly_delaunay_global N cT h (latb r) (open_domain Hs) cM h_pos (latb_add r) (open_domain_convex Hs)
     cdom_inside cvol cmate conce G (weak_local less LE H) cc c' x Hc Hc' Hx) as W.
  pose proof s_pos. cbn [Euclid.Et va]. fold e. assert (0 <= s * power G (piece cc) x) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma boundary_vertices k i n cc v : (k < N)%nat -> latb r n = true -> In i I4 -> cM k i = None ->
  valid cc -> In v (verts (piece cc)) -> 0 <= coord (piece (k, n)) i v.
Proof.
  intros Hk Hn Hi EM Hc Hv. destruct (cboundary k n i Hk Hn Hi EM) as [H [HI Z]].
  destruct (clevel k n H Hk Hn HI) as [L1 [v' [Iv' Pv']]]. destruct cc as [k' n']. destruct Hc as [Hk' Hn']. cbn [fst snd] in *.
  destruct (clevel k' n' H Hk' Hn' HI) as [L1' _]. pose proof (L1' v Hv) as Lv.
  apply Rnot_lt_le. intros NE. pose proof (pvol k n Hk) as V.
  assert (AP : 0 < level H (vx (piece (k, n)) i)).
  { destruct (Rlt_dec 0 (level H (vx (piece (k, n)) i))) as [|Nl]; auto. exfalso.
    assert (X : exists j, In j I4 /\ v' = vx (piece (k, n)) j).
    { simpl in Iv'. destruct Iv' as [<-|[<-|[<-|[<-|[]]]]]; [exists 0%nat|exists 1%nat|exists 2%nat|exists 3%nat]; (split; [simpl; tauto|reflexivity]). }
    destruct X as [j [Hj ->]]. destruct (Nat.eq_dec j i) as [->|Ne]; [lra|]. rewrite Z in Pv' by auto. lra. }
  pose proof (interpolate (piece (k, n)) (level H) v (aff_level H)) as IN.
  assert (Q : vol (piece (k, n)) * level H v = coord (piece (k, n)) i v * level H (vx (piece (k, n)) i)).
  { rewrite IN. pose proof (Z 0%nat ltac:(simpl; auto)) as Z0. pose proof (Z 1%nat ltac:(simpl; auto)) as Z1.
    pose proof (Z 2%nat ltac:(simpl; auto)) as Z2. pose proof (Z 3%nat ltac:(simpl; auto)) as Z3. cbn [vx] in *.
    simpl in Hi. destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; cbn [vx]; rewrite ?Z0, ?Z1, ?Z2, ?Z3 by lia; ring. }
  assert (0 <= vol (piece (k, n)) * level H v) by (apply Rmult_le_pos; lra).
  assert (0 < - coord (piece (k, n)) i v * level H (vx (piece (k, n)) i)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

(** For the plane: where the facet i has a positive power behind it, no vertex of the
    tiling that lies beyond it is on the circumsphere. *)
Theorem strict_sound k n i w0 w1 w2 w3 t : chk_delaunay A aadd asub amul aofZ ale c = true ->
  is_tile r N (k, n) -> nth_error (c_tets c) k = Some t -> In i I4 ->
  chk_power alt (c_gram c) den (positions c) t (kpos den vs t) i = true ->
  w0 + w1 + w2 + w3 = 1 -> nth i [w0; w1; w2; w3] 0 < 0 ->
  let P := tile l1 l2 l3 cP (k, n) in let v := combination P w0 w1 w2 w3 in
  is_vertex l1 l2 l3 r N cP v -> distance_squared (va P) (circumcentre P) < distance_squared v (circumcentre P).
Proof.
  intros H Ht Et Hi CP SW Wi P v Hv. apply valid_is_tile in Ht. pose proof (pvol k n (proj1 Ht)) as V.
  pose proof (proj1 Ht) as Hk. cbn [fst] in Hk.
  apply vertex_coordinates in Hv as [c' [x [Hc' [Hx Ev]]]].
  assert (PE : P = Euclid.Et b1 b2 b3 (piece (k, n))) by apply tile_cP.
  pose proof (power_distance (piece (k, n)) x V) as PD. cbv zeta in PD. rewrite <- PE in PD. rewrite Ev.
  replace (va P) with (e (va (piece (k, n)))) by (rewrite PE; reflexivity).
  pose proof s_pos as S. cut (0 < power G (piece (k, n)) x).
  { intros K. assert (0 < s * power G (piece (k, n)) x) by (apply Rmult_lt_0_compat; auto). lra. }
  assert (X : x = combination (piece (k, n)) w0 w1 w2 w3).
  { apply (E_inj b1 b2 b3 cdetb). change (E b1 b2 b3 x) with (e x). rewrite <- Ev. unfold v. rewrite PE. apply E_comb4. }
  apply (strict_at N cT h (latb r) (open_domain Hs) cM h_pos (latb_add r) (open_domain_convex Hs)
      cdom_inside cvol cmate conce G (weak_local ale ale_ok H) boundary_vertices (k, n) c' x i); auto.
  - destruct (L_comb4 (piece (k, n)) w0 w1 w2 w3 SW) as [K0 [K1 [K2 K3]]]. rewrite <- X in *.
    simpl in Hi. destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; cbn [nth] in Wi; rewrite ?K0, ?K1, ?K2, ?K3; nra.
  - cbn [fst]. unfold Checker.chk_power in CP. unfold cM. rewrite Et. destruct (mt t i) as [[[k' i'] d]|]; auto.
    unfold Checker.positions in CP. fold den vs in CP. rewrite nth_error_map in CP.
    destruct (nth_error (c_tets c) (N.to_nat k')) as [t'|] eqn:E'; [|discriminate]. cbn [option_map] in CP.
    apply alt_ok in CP. rewrite phi_zero, phi_power, phi3_add, phi3_ofZ, phi_vx in CP. fold h G in CP.
    rewrite (cT_eq k t Et), (cT_eq _ t' E'), vx_translate'.
    pose proof (cvol k Hk) as V'. rewrite (cT_eq k t Et) in V'.
    pose proof (power_power_sum G (phiT (kpos den vs t)) (add (vx (phiT (kpos den vs t')) (N.to_nat i')) (vec h d))) as PP.
    apply Rmult_lt_reg_l with (vol (phiT (kpos den vs t))); auto. rewrite PP by lra. lra.
Qed.

(** Not Delaunay: a vertex with a negative power is inside. *)
Lemma inside_at_sound k t m : nth_error (c_tets c) k = Some t ->
  chk_inside_at A aadd asub amul aofZ alt c (positions c) (kpos den vs t) m = true ->
  exists k' i' d, m = Some (k', i', d) /\ In (N.to_nat i') I4 /\ is_tile r N (N.to_nat k', d) /\ is_tile r N (k, z30) /\
  let P := tile l1 l2 l3 cP (k, z30) in
  distance_squared (vx (tile l1 l2 l3 cP (N.to_nat k', d)) (N.to_nat i')) (circumcentre P) < distance_squared (va P) (circumcentre P).
Proof.
  intros Et H. unfold Checker.chk_inside_at in H. destruct m as [[[k' i'] d]|]; [|discriminate]. exists k', i', d. split; auto.
  unfold Checker.positions in H. fold den vs in H. rewrite nth_error_map in H.
  destruct (nth_error (c_tets c) (N.to_nat k')) as [t'|] eqn:E'; [|discriminate]. cbn [option_map] in H.
  rewrite !andb_true_iff, N.ltb_lt in H. destruct H as [[Hi Hd] H]. fold r in Hd.
  assert (Hk : (k < N)%nat) by (apply nth_error_Some; congruence).
  assert (Hk' : (N.to_nat k' < N)%nat) by (apply nth_error_Some; congruence).
  assert (V : valid (k, z30)) by (split; [exact Hk|apply latb_zero]).
  assert (V' : valid (N.to_nat k', d)) by (split; auto).
  split; [apply I4_lt; lia|]. split; [apply valid_is_tile, V'|]. split; [apply valid_is_tile, V|]. cbv zeta.
  rewrite !tile_cP. pose proof (pvol k z30 Hk) as P. pose proof (power_distance (piece (k, z30)) (vx (piece (N.to_nat k', d)) (N.to_nat i')) P) as PD. cbv zeta in PD.
  assert (EV : vx (Euclid.Et b1 b2 b3 (piece (N.to_nat k', d))) (N.to_nat i') = e (vx (piece (N.to_nat k', d)) (N.to_nat i'))).
  { destruct (N.to_nat i') as [|[|[|?]]]; reflexivity. }
  rewrite EV. change (va (Euclid.Et b1 b2 b3 (piece (k, z30)))) with (e (va (piece (k, z30)))).
  apply alt_ok in H. rewrite phi_zero, phi_power, phi3_add, phi3_ofZ, phi_vx in H. fold h G in H.
  assert (PT : piece (k, z30) = phiT (kpos den vs t)).
  { unfold Degree.piece; cbn [fst snd]. rewrite (cT_eq k t Et). apply ttr0. }
  assert (PV : vx (piece (N.to_nat k', d)) (N.to_nat i') = add (vx (phiT (kpos den vs t')) (N.to_nat i')) (vec h d)).
  { unfold Degree.piece; cbn [fst snd]. rewrite (cT_eq _ t' E'). apply vx_translate'. }
  rewrite <- PV, <- PT in H.
  pose proof (power_power_sum G (piece (k, z30)) (vx (piece (N.to_nat k', d)) (N.to_nat i')) ltac:(lra)) as PP.
  pose proof s_pos. cut (s * power G (piece (k, z30)) (vx (piece (N.to_nat k', d)) (N.to_nat i')) < 0); [lra|].
  assert (power G (piece (k, z30)) (vx (piece (N.to_nat k', d)) (N.to_nat i')) < 0).
  { apply Rmult_lt_reg_l with (vol (piece (k, z30))); auto. lra. }
  apply Rmult_lt_reg_l with (/ s); [apply Rinv_0_lt_compat; auto|]. rewrite <- Rmult_assoc, Rinv_l by lra. lra.
Qed.
Theorem not_delaunay_sound : chk_not_delaunay A aadd asub amul aofZ alt c = true -> not_delaunay l1 l2 l3 r N cP.
Proof.
  intros H. unfold Checker.chk_not_delaunay in H. rewrite existsl_eq, existsb_exists in H. destruct H as [t [It H]].
  rewrite existsl_eq, existsb_exists in H. destruct H as [i [_ H]]. apply In_nth_error in It as [k Et].
  destruct (inside_at_sound k t _ Et H) as [k' [i' [d [_ [Hi [V' [V D]]]]]]]. cbv zeta in D.
  eexists. eexists. eexists. eexists. split; [exact V|]. split; [apply circumscribed_centre|split; [|exact D]].
  - rewrite tile_cP, vol_Et. apply valid_is_tile in V. pose proof (pvol k z30 (proj1 V)).
    apply Rmult_integral_contrapositive_currified; [lra|apply cdetb].
  - eexists. split; [exact V'|apply vx_In, Hi].
Qed.

(** *** Planes that no tile crosses *)
Theorem uncrossed_sound part n p q : 0 < IZR q -> forallb (chk_uncrossed A aadd asub amul aofZ ale part den r n p q) (positions c) = true ->
  uncrossed l1 l2 l3 r N cP n (IZR p / IZR q).
Proof.
  intros Q H [k d] Hc. apply valid_is_tile in Hc. pose proof h_pos as hp. pose proof (proj1 Hc) as Hk. pose proof (proj2 Hc) as Hd. cbn [fst snd] in Hk, Hd.
  destruct (get k Hk) as [t [Et It]]. rewrite forallb_forall in H.
  assert (Ip : In (kpos den vs t) (positions c)) by (unfold Checker.positions; fold den vs; apply in_map; exact It).
  specialize (H _ Ip). set (W := fun x => IZR q * linear_form n x - IZR p * h).
  assert (S : (forall v, In v (verts (piece (k, d))) -> W v <= 0) \/ (forall v, In v (verts (piece (k, d))) -> 0 <= W v)).
  { destruct (step_divides r n d Hd) as [w Ew]. pose proof (step_nonnegative r n) as Gn. unfold chk_uncrossed in H. cbv zeta in H.
    set (g := plane_step r n) in *. clearbody g.
    assert (V : forall v, In v (verts (piece (k, d))) -> exists x, In x (map (kheight A aadd asub amul aofZ n p q den) (kverts (kpos den vs t))) /\
      W v = phi x + IZR (q * den * (g * w))).
    { intros v Hv. unfold Degree.piece in Hv; cbn [fst snd] in Hv. rewrite (cT_eq k t Et) in Hv. apply in_piece_verts in Hv as [u [Hu ->]].
      eexists. split; [apply in_map, Hu|]. unfold W. rewrite phi_height, linear_add, linear_vec, Ew, !mult_IZR. fold h. ring. }
    set (ks := map (kheight A aadd asub amul aofZ n p q den) (kverts (kpos den vs t))) in *. clearbody ks. destruct (Z.eqb_spec g 0) as [E|NE].
    - rewrite E in V. assert (Z0 : IZR (q * den * (0 * w)) = 0) by (rewrite Z.mul_0_l, Z.mul_0_r; reflexivity). rewrite Z0 in V.
      destruct (forallb (fun x => ale zero x) ks) eqn:P; [right|left]; intros v Hv; destruct (V v Hv) as [x [Hx ->]].
      + rewrite forallb_forall in P. specialize (P x Hx). apply ale_ok in P. rewrite phi_zero in P. lra.
      + rewrite forallb_forall in H. specialize (H x Hx). apply ale_ok in H. rewrite phi_zero in H. lra.
    - rewrite existsl_eq, existsb_exists in H. destruct H as [m [_ H]]. rewrite forallb_forall in H.
      assert (U : (0 <= q * den * g)%Z).
      { apply lt_IZR in Q. destruct BASE as [DP _]. fold den in DP. apply Z.mul_nonneg_nonneg; [apply Z.mul_nonneg_nonneg|]; lia. }
      destruct (Z_le_gt_dec 0 (m + w)) as [L|L]; [right|left]; intros v Hv; destruct (V v Hv) as [x [Hx ->]]; specialize (H x Hx);
        cbv beta in H; apply andb_true_iff in H as [H1 H2]; apply ale_ok in H1, H2; rewrite phi_Z in H1, H2.
      + assert (K : 0 <= IZR (q * den * g * m) + IZR (q * den * (g * w))).
        { rewrite <- plus_IZR. apply IZR_le. replace (q * den * g * m + q * den * (g * w))%Z with (q * den * g * (m + w))%Z by ring.
          apply Z.mul_nonneg_nonneg; lia. }
        lra.
      + assert (K : IZR (q * den * g * (m + 1)) + IZR (q * den * (g * w)) <= 0).
        { rewrite <- plus_IZR. apply IZR_le. replace (q * den * g * (m + 1) + q * den * (g * w))%Z with (q * den * g * (m + w + 1))%Z by ring.
          apply Z.mul_nonneg_nonpos; lia. }
        lra. }
  assert (X : forall x, hull (tile l1 l2 l3 cP (k, d)) (at_coordinates l1 l2 l3 x) -> exists a1 a2 a3 a4, 0 <= a1 /\ 0 <= a2 /\ 0 <= a3 /\ 0 <= a4 /\
    h * (IZR q * linear_form n x - IZR p) = a1 * W (va (piece (k, d))) + a2 * W (vb (piece (k, d))) + a3 * W (vc (piece (k, d))) + a4 * W (vd (piece (k, d)))).
  { intros x [a1 [a2 [a3 [a4 [P1 [P2 [P3 [P4 [SW E]]]]]]]]]. exists a1, a2, a3, a4. repeat (split; [assumption|]).
    rewrite tile_cP, E_comb4 in E.
    assert (EX : at_coordinates l1 l2 l3 x = Euclid.E b1 b2 b3 (scale h x)).
    { unfold Euclid.E, b1, b2, b3, at_coordinates. apply point_eq; unf; field; lra. }
    rewrite EX in E. apply (E_inj b1 b2 b3 cdetb) in E.
    assert (HX : h * (IZR q * linear_form n x - IZR p) = W (scale h x)).
    { unfold W, linear_form. destruct n as [[n1 n2] n3]. unf. ring. }
    rewrite HX, E. unfold W, linear_form. destruct n as [[n1 n2] n3]. unfold combination. unf.
    replace a4 with (1 - a1 - a2 - a3) by lra. ring. }
  assert (Y : forall x, h * (IZR q * linear_form n x - IZR p) = h * IZR q * (linear_form n x - IZR p / IZR q)) by (intros x; field; lra).
  assert (HQ : 0 < h * IZR q) by (apply Rmult_lt_0_compat; auto).
  assert (PV : forall v, In v [va (piece (k, d)); vb (piece (k, d)); vc (piece (k, d)); vd (piece (k, d))] -> In v (verts (piece (k, d)))) by (intros v Hv; exact Hv).
  destruct S as [S|S]; [left|right]; intros x Hx; destruct (X x Hx) as [a1 [a2 [a3 [a4 [P1 [P2 [P3 [P4 E]]]]]]]]; rewrite Y in E;
    pose proof (S _ (PV _ (or_introl eq_refl))) as W1; pose proof (S _ (PV _ (or_intror (or_introl eq_refl)))) as W2;
    pose proof (S _ (PV _ (or_intror (or_intror (or_introl eq_refl))))) as W3; pose proof (S _ (PV _ (or_intror (or_intror (or_intror (or_introl eq_refl)))))) as W4.
  - assert (K : h * IZR q * (linear_form n x - IZR p / IZR q) <= 0).
    { rewrite E. pose proof (Rmult_le_compat_l _ _ _ P1 W1). pose proof (Rmult_le_compat_l _ _ _ P2 W2).
      pose proof (Rmult_le_compat_l _ _ _ P3 W3). pose proof (Rmult_le_compat_l _ _ _ P4 W4). lra. }
    apply Rnot_lt_le. intros L. assert (0 < h * IZR q * (linear_form n x - IZR p / IZR q)) by (apply Rmult_lt_0_compat; lra). lra.
  - assert (K : 0 <= h * IZR q * (linear_form n x - IZR p / IZR q)).
    { rewrite E. pose proof (Rmult_le_pos _ _ P1 W1). pose proof (Rmult_le_pos _ _ P2 W2). pose proof (Rmult_le_pos _ _ P3 W3). pose proof (Rmult_le_pos _ _ P4 W4). lra. }
    apply Rnot_lt_le. intros L. assert (0 < h * IZR q * (IZR p / IZR q - linear_form n x)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

(** *** Valences *)
(** The name of a vertex of a tile: the corner, moved with the tile. *)
Definition names (cc : cell) : list corner :=
  match nth_error (c_tets c) (fst cc) with Some t => map (fun i => cshift (snd cc) (qx t i)) I4 | None => [] end.
Lemma qx_pos t i : rp (qx t i) = vx (phiT (kpos den vs t)) i.
Proof. destruct i as [|[|[|i]]]; reflexivity. Qed.
Lemma piece_name k n t i : nth_error (c_tets c) k = Some t -> rp (cshift n (qx t i)) = vx (piece (k, n)) i.
Proof.
  intros E. rewrite rp_shift, qx_pos. unfold Degree.piece; cbn [fst snd]. rewrite vx_translate', (cT_eq k t E). reflexivity.
Qed.
Lemma names_verts cc q : In q (names cc) -> In (rp q) (verts (piece cc)).
Proof.
  destruct cc as [k n]. unfold names; cbn [fst snd]. destruct (nth_error (c_tets c) k) as [t|] eqn:E; [|intros []].
  intros H. apply in_map_iff in H as [i [<- Hi]]. rewrite (piece_name k n t i E). apply vx_In; auto.
Qed.
Lemma verts_names cc v : valid cc -> In v (verts (piece cc)) -> exists q, In q (names cc) /\ v = rp q.
Proof.
  destruct cc as [k n]. intros [Hk _] Hv. cbn [fst] in Hk. destruct (get k Hk) as [t [E _]].
  assert (X : exists i, In i I4 /\ v = vx (piece (k, n)) i).
  { simpl in Hv. destruct Hv as [<-|[<-|[<-|[<-|[]]]]]; [exists 0%nat|exists 1%nat|exists 2%nat|exists 3%nat]; (split; [simpl; tauto|reflexivity]). }
  destruct X as [i [Hi ->]]. exists (cshift n (qx t i)). split; [|symmetry; apply piece_name; auto].
  unfold names; cbn [fst snd]. rewrite E. apply in_map_iff. eauto.
Qed.
Lemma name_closed cc q : valid cc -> In q (names cc) -> closed (piece cc) (rp q).
Proof.
  intros Hc Hq. apply names_verts in Hq. destruct cc as [k n]. apply closed_vertex; auto. apply pvol, Hc.
Qed.
(** A facet has the same names on both sides. *)
Lemma names_across cc i q : valid cc -> In i I4 -> paired cM (cc, i) -> In q (names cc) -> coord (piece cc) i (rp q) = 0 ->
  In q (names (fst (across cM (cc, i)))).
Proof.
  destruct cc as [k n]. intros [Hk Hn] Hi PA Hq Z. cbn [fst snd] in Hk, Hn.
  unfold Degree.paired in PA; cbn [fst snd] in PA. unfold Degree.across.
  destruct (get k Hk) as [t [E I]]. destruct (cM k i) as [[[k1 i1] d1]|] eqn:EM; [|congruence]. clear PA.
  destruct chk_all as [_ [_ [_ [_ [M _]]]]].
  pose proof (chk_mates_spec _ _ 0 M k t i E Hi) as C. cbn [Nat.add] in C. unfold Checker.chk_mate in C.
  unfold cM in EM. rewrite E in EM. destruct (mt t i) as [[[k' i'] d]|]; [|discriminate]. injection EM as <- <- <-.
  rewrite !andb_true_iff in C. destruct C as [_ C2].
  destruct (nth_error (c_tets c) (N.to_nat k')) as [t'|] eqn:E'; [|discriminate].
  apply andb_true_iff in C2 as [_ C3]. cbn [fst snd].
  unfold names in *; cbn [fst snd] in *. rewrite E in Hq. rewrite E'.
  apply in_map_iff in Hq as [j [<- Hj]].
  assert (Ne : j <> i).
  { intros ->. rewrite (piece_name k n t i E), L_vx in Z by auto. pose proof (pvol k n Hk). lra. }
  assert (F : exists j', In j' I4 /\ qx t j = cshift d (qx t' j')).
  { clear - C3 Hi Hj Ne. 
    assert (Q : qx t j = fst (fst (cfc t i)) \/ qx t j = snd (fst (cfc t i)) \/ qx t j = snd (cfc t i)).
    { simpl in Hi, Hj. destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; destruct Hj as [<-|[<-|[<-|[<-|[]]]]]; cbn; try lia; auto. }
    assert (Q' : forall x, x = fst (fst (cfc t' (N.to_nat i'))) \/ x = snd (fst (cfc t' (N.to_nat i'))) \/ x = snd (cfc t' (N.to_nat i')) -> exists j', In j' I4 /\ x = qx t' j').
    { intros x. destruct (N.to_nat i') as [|[|[|]]]; cbn [cfc fst snd]; intros [->|[->| ->]];
      first [exists 0%nat; split; [simpl; tauto|reflexivity] | exists 1%nat; split; [simpl; tauto|reflexivity] | exists 2%nat; split; [simpl; tauto|reflexivity] | exists 3%nat; split; [simpl; tauto|reflexivity]]. }
    destruct (cfc t i) as [[a b] c0], (cfc t' (N.to_nat i')) as [[a' b'] c']. cbn [fst snd] in *. unfold codd in C3.
    rewrite !orb_true_iff, !andb_true_iff, !ceqb_t in C3.
    assert (W : exists x, (x = a' \/ x = b' \/ x = c') /\ qx t j = cshift d x).
    { destruct C3 as [[[[A1 A2] A3]|[[A1 A2] A3]]|[[A1 A2] A3]]; rewrite A1, A2, A3 in Q; destruct Q as [Q|[Q|Q]]; rewrite Q; eauto. }
    destruct W as [x [W1 W2]]. destruct (Q' x W1) as [j' [J1 J2]]. exists j'. subst x. auto. }
  destruct F as [j' [J1 J2]]. apply in_map_iff. exists j'. split; auto. rewrite J2. apply cshift_shift.
Qed.
(** A point has one name: the corollary on names. *)
Theorem one_name cc cc' q : valid cc -> valid cc' -> In q (names cc) -> In (rp q) (verts (piece cc')) -> In q (names cc').
Proof.
  intros Hc Hc' Hq Hv.
  assert (C' : closed (piece cc') (rp q)) by (destruct cc' as [k' n']; apply closed_vertex; auto; apply pvol, Hc').
  set (has := fun cc => existsb (ceqb q) (names cc)).
  assert (HAS : forall cc, has cc = true <-> In q (names cc)).
  { intros c1. unfold has. rewrite existsb_exists. split.
    - intros [x [Hx Ex]]. apply ceqb_t in Ex. congruence.
    - intros H. exists q. split; auto. apply ceqb_t; auto. }
  apply HAS. pose proof (proj2 (HAS cc) Hq) as T.
  assert (K : (Z.b2z (has cc) = Z.b2z (has cc'))%Z).
  { apply (constant_around N cT h (latb r) (open_domain Hs) cM h_pos (latb_add r) (open_domain_convex Hs)
      cdom_inside cvol cmate conce (rp q) (fun c1 => Z.b2z (has c1))); auto; [|apply name_closed; auto].
    intros d i Hd Hi PA Cx Lx. f_equal.
    destruct (sg_spec N cT h (latb r) (open_domain Hs) cM (latb_add r) cmate d i Hd Hi PA) as [S1 [S2 [S3 [S4 S5]]]].
    set (ci := across cM (d, i)) in *. destruct (has d) eqn:H1.
    - apply HAS. apply HAS in H1. apply names_across; auto.
    - destruct (has (fst ci)) eqn:H2; auto. exfalso. apply HAS in H2.
      assert (X : In q (names d)); [|apply HAS in X; congruence].
      assert (Lx' : coord (piece (fst ci)) (snd ci) (rp q) = 0).
      { unfold coord in *. rewrite (oddm_o _ _ _ S4) in Lx. lra. }
      rewrite (surjective_pairing ci) in S3. rewrite <- (f_equal fst S3 : _ = d).
      apply names_across; auto. }
  rewrite T in K. destruct (has cc'); auto; discriminate.
Qed.

(** The tiles with two given vertices, by the keys. *)
Definition all_pairs : list (nat * (nat * nat)) := list_prod (seq 0 N) pairs4.
Definition corner_of (k i : nat) : corner := match nth_error (c_tets c) k with Some t => qx t i | None => (0%N, z30) end.
Definition key_of (p : nat * (nat * nat)) : key := edge_key (corner_of (fst p) (fst (snd p))) (corner_of (fst p) (snd (snd p))).
Lemma keys_all_pairs : flat_map keys (c_tets c) = map key_of all_pairs.
Proof.
  assert (X : forall ts s, (forall j t, nth_error ts j = Some t -> nth_error (c_tets c) (s + j) = Some t) ->
    flat_map keys ts = map key_of (list_prod (seq s (length ts)) pairs4)).
  { induction ts as [|t ts IH]; intros s0 H; [reflexivity|].
    cbn [flat_map length seq list_prod]. rewrite map_app. f_equal.
    - specialize (H 0%nat t eq_refl). rewrite Nat.add_0_r in H. unfold keys. rewrite map_map. apply map_ext. intros p.
      unfold key_of, corner_of; cbn [fst snd]. rewrite H. reflexivity.
    - apply IH. intros j t' E. replace (S s0 + j)%nat with (s0 + S j)%nat by lia. apply H. exact E. }
  apply (X (c_tets c) 0%nat). auto.
Qed.
Definition tiles_with (a b : corner) : list cell :=
  map (fun p => (fst p, zadd3 (snd a) (zopp3 (snd (corner_of (fst p) (fst (snd p)))))))
    (filter (fun p => keqb (edge_key a b) (key_of p)) all_pairs).
Lemma tiles_with_length a b : length (tiles_with a b) = count_key (indexed (flat_map keys (c_tets c))) (edge_key a b).
Proof. rewrite count_key_filter, keys_all_pairs, filter_map. unfold tiles_with. rewrite !map_length. reflexivity. Qed.
Lemma vertex_index k n i j : (k < N)%nat -> In i I4 -> In j I4 -> vx (piece (k, n)) i = vx (piece (k, n)) j -> i = j.
Proof.
  intros Hk Hi Hj E. destruct (Nat.eq_dec i j); auto. exfalso. pose proof (pvol k n Hk) as V.
  pose proof (L_vx (piece (k, n)) i Hi) as X. rewrite E, L_vx' in X by auto. lra.
Qed.
Lemma corner_get k : (k < N)%nat -> exists t, nth_error (c_tets c) k = Some t /\ forall i, corner_of k i = qx t i.
Proof. intros Hk. destruct (get k Hk) as [t [E _]]. exists t. split; auto. intros. unfold corner_of. rewrite E. auto. Qed.
Lemma names_In k n q : In q (names (k, n)) -> exists i, In i I4 /\ q = cshift n (corner_of k i).
Proof.
  unfold names, corner_of; cbn [fst snd]. destruct (nth_error (c_tets c) k) as [t|]; [|intros []].
  intros H. apply in_map_iff in H as [i [<- Hi]]. eauto.
Qed.
Lemma In_names k n i : (k < N)%nat -> In i I4 -> In (cshift n (corner_of k i)) (names (k, n)).
Proof.
  intros Hk Hi. unfold names, corner_of; cbn [fst snd]. destruct (get k Hk) as [t [-> _]]. apply in_map_iff. eauto.
Qed.
Lemma tiles_with_In a b cc : r = 3%nat -> rp a <> rp b -> In cc (tiles_with a b) <-> valid cc /\ In a (names cc) /\ In b (names cc).
Proof.
  intros R3 Ne. unfold tiles_with. rewrite in_map_iff. split.
  - intros [[k [i j]] [<- H]]. apply filter_In in H as [H1 H2]. unfold all_pairs in H1. apply in_prod_iff in H1 as [Hk Hij]. apply in_seq in Hk.
    apply pairs4_In in Hij as [Hi [Hj _]]. apply keqb_t in H2. cbn [fst snd] in *. unfold key_of in H2; cbn [fst snd] in H2.
    destruct (shift_to _ _ _ _ H2) as [S1 S2]. cbv zeta in S1, S2. set (m := zadd3 _ _) in *.
    split; [split; [cbn; lia|rewrite R3; destruct m as [[? ?] ?]; reflexivity]|].
    rewrite <- S1 at 1. rewrite <- S2. split; apply In_names; auto; lia.
  - destruct cc as [k n]. intros [[Hk Hn] [Ha Hb]]. cbn [fst snd] in Hk.
    apply names_In in Ha as [i [Hi ->]]. apply names_In in Hb as [j [Hj ->]].
    exists (k, (i, j)). cbn [fst snd]. split.
    + f_equal. destruct (corner_of k i) as [v [[? ?] ?]], n as [[? ?] ?]. cbn. z3.
    + apply filter_In. split.
      * unfold all_pairs. apply in_prod; [apply in_seq; lia|]. apply pairs4_In. repeat split; auto. intros ->. auto.
      * apply keqb_t. unfold key_of; cbn [fst snd]. apply edge_key_shift.
Qed.
Lemma tiles_with_NoDup a b : rp a <> rp b -> NoDup (tiles_with a b).
Proof.
  intros Ne. unfold tiles_with. apply NoDup_map_inj_on.
  - apply NoDup_filter. unfold all_pairs. apply NoDup_list_prod; [apply seq_NoDup|].
    unfold pairs4. repeat constructor; simpl; intuition congruence.
  - intros [k [i j]] [k' [i' j']] H H' E. apply filter_In in H as [H1 H2]. apply filter_In in H' as [H1' H2'].
    unfold all_pairs in H1, H1'. apply in_prod_iff in H1 as [Hk Hij]. apply in_prod_iff in H1' as [_ Hij'].
    apply pairs4_In in Hij as [Hi [Hj _]]. apply pairs4_In in Hij' as [Hi' [Hj' _]]. apply in_seq in Hk.
    cbn [fst snd] in E. injection E as Ek Em. subst k'. cbn [fst snd] in *.
    apply keqb_t in H2, H2'. unfold key_of in H2, H2'; cbn [fst snd] in H2, H2'.
    destruct (shift_to _ _ _ _ H2) as [S1 S2]. destruct (shift_to _ _ _ _ H2') as [S1' S2']. cbv zeta in *. rewrite <- Em in S1', S2'.
    set (m := zadd3 _ _) in *. clearbody m. destruct (corner_get k) as [t [Et Ct]]; [lia|]. rewrite !Ct in *.
    assert (I1 : i = i'). { apply (vertex_index k m); auto; [lia|]. rewrite <- !(piece_name k m t) by auto. congruence. }
    assert (I2 : j = j'). { apply (vertex_index k m); auto; [lia|]. rewrite <- !(piece_name k m t) by auto. congruence. }
    subst. reflexivity.
Qed.

Notation has_vertices := (has_vertices l1 l2 l3 r N cP).
Notation valence := (valence l1 l2 l3 r N cP).
Lemma e_inj x y : e x = e y -> x = y.
Proof. apply E_inj, cdetb. Qed.
Lemma tile_vertex_name cc v : valid cc -> In v (verts (tile l1 l2 l3 cP cc)) -> exists q, In q (names cc) /\ v = e (rp q).
Proof.
  intros Hc Hv. assert (VV : is_vertex l1 l2 l3 r N cP v) by (exists cc; split; auto; apply valid_is_tile; auto).
  rewrite tile_cP in Hv. change (verts (Euclid.Et b1 b2 b3 (piece cc))) with (map e (verts (piece cc))) in Hv.
  apply in_map_iff in Hv as [x [<- Hx]]. destruct (verts_names cc x Hc Hx) as [q [Hq ->]]. eauto.
Qed.
Lemma name_tile_vertex cc q : valid cc -> In q (names cc) -> In (e (rp q)) (verts (tile l1 l2 l3 cP cc)).
Proof.
  intros Hc Hq. rewrite tile_cP. change (verts (Euclid.Et b1 b2 b3 (piece cc))) with (map e (verts (piece cc))).
  apply in_map, names_verts, Hq.
Qed.
Lemma vertex_has_name cc cc' q : valid cc -> valid cc' -> In q (names cc) -> In (e (rp q)) (verts (tile l1 l2 l3 cP cc')) -> In q (names cc').
Proof.
  intros Hc Hc' Hq Hv. apply (one_name cc); auto. destruct (tile_vertex_name cc' _ Hc' Hv) as [q' [Hq' E]].
  apply e_inj in E. rewrite E. apply names_verts; auto.
Qed.
Lemma valence_count cc a b : r = 3%nat -> valid cc -> In a (names cc) -> In b (names cc) -> rp a <> rp b ->
  valence (e (rp a)) (e (rp b)) (length (tiles_with a b)).
Proof.
  intros R3 Hc Ha Hb Ne. exists (tiles_with a b). split; [apply tiles_with_NoDup; auto|]. split; auto.
  intros c'. rewrite (tiles_with_In a b c' R3 Ne). unfold Statement.has_vertices. rewrite valid_is_tile. split.
  - intros [Hc' [Ha' Hb']]. split; auto. intros v [<-|[<-|[]]]; apply name_tile_vertex; auto.
  - intros [Hc' H]. split; auto. split; apply (vertex_has_name cc); auto; apply H; simpl; auto.
Qed.
Lemma valence_unique u v m m' : valence u v m -> valence u v m' -> m = m'.
Proof.
  intros [L [N1 [<- H]]] [L' [N1' [<- H']]]. apply Nat.le_antisymm; apply NoDup_incl_length; auto; intros x Hx;
  [apply H', H, Hx | apply H, H', Hx].
Qed.
Theorem tcp_sound : Nat.eqb r 3 && chk_tcp (c_tets c) = true -> tcp l1 l2 l3 r N cP.
Proof.
  intros H. apply andb_true_iff in H as [R3 H]. apply Nat.eqb_eq in R3. unfold chk_tcp in H. cbv zeta in H.
  set (m := indexed (flat_map keys (c_tets c))) in *. rewrite forallb_forall in H.
  (* a vertex of a tile by its index *)
  assert (V : forall cc v, valid cc -> In v (verts (tile l1 l2 l3 cP cc)) -> exists t i, nth_error (c_tets c) (fst cc) = Some t /\ In i I4 /\ v = e (rp (cshift (snd cc) (qx t i)))).
  { intros cc v Hc Hv. destruct (tile_vertex_name cc v Hc Hv) as [q [Hq ->]]. unfold names in Hq.
    destruct (nth_error (c_tets c) (fst cc)) as [t|]; [|destruct Hq]. apply in_map_iff in Hq as [i [<- Hi]]. eauto. }
  assert (CNT : forall cc t i j, valid cc -> nth_error (c_tets c) (fst cc) = Some t -> In i I4 -> In j I4 ->
    e (rp (cshift (snd cc) (qx t i))) <> e (rp (cshift (snd cc) (qx t j))) ->
    valence (e (rp (cshift (snd cc) (qx t i)))) (e (rp (cshift (snd cc) (qx t j)))) (count_key m (edge_key (qx t i) (qx t j)))).
  { intros cc t i j Hc E Hi Hj Ne. rewrite <- (edge_key_shift (snd cc)). unfold m. rewrite <- tiles_with_length.
    apply (valence_count cc); auto; try congruence; unfold names; rewrite E; apply in_map_iff; eauto. }
  split.
  - intros cc u v [Hc HV] Ne. apply valid_is_tile in Hc.
    destruct (V cc u Hc) as [t [i [E [Hi ->]]]]; [apply HV; simpl; auto|].
    destruct (V cc v Hc) as [t' [j [E' [Hj ->]]]]; [apply HV; simpl; auto|]. rewrite E in E'. injection E' as <-.
    pose proof (CNT cc t i j Hc E Hi Hj Ne) as K.
    specialize (H t (nth_error_In _ _ E)). apply andb_true_iff in H as [H _]. rewrite forallb_forall in H.
    specialize (H (i, j)). cbn [fst snd] in H. rewrite pairs4_In, orb_true_iff, !Nat.eqb_eq in H.
    destruct H as [H|H]; [repeat split; auto; congruence| |]; rewrite H in K; auto.
  - intros cc u v w [Hc HV] N1 N2 N3 [K1 K2]. apply valid_is_tile in Hc.
    destruct (V cc u Hc) as [t [i [E [Hi ->]]]]; [apply HV; simpl; auto|].
    destruct (V cc v Hc) as [t' [j [E' [Hj ->]]]]; [apply HV; simpl; auto|]. rewrite E in E'. injection E' as <-.
    destruct (V cc w Hc) as [t' [k [E' [Hk ->]]]]; [apply HV; simpl; auto|]. rewrite E in E'. injection E' as <-.
    assert (Nij : i <> j) by congruence. assert (Nik : i <> k) by congruence. assert (Njk : j <> k) by congruence.
    pose proof (valence_unique _ _ _ _ K1 (CNT cc t i j Hc E Hi Hj N1)) as C1.
    pose proof (valence_unique _ _ _ _ K2 (CNT cc t i k Hc E Hi Hk N2)) as C2.
    specialize (H t (nth_error_In _ _ E)). apply andb_true_iff in H as [_ H]. rewrite forallb_forall in H.
    assert (T : In (i, j, k) triples4 \/ In (i, k, j) triples4).
    { clear - Hi Hj Hk Nij Nik Njk. unfold triples4. simpl in Hi, Hj, Hk.
      destruct Hi as [<-|[<-|[<-|[<-|[]]]]]; destruct Hj as [<-|[<-|[<-|[<-|[]]]]]; try lia; destruct Hk as [<-|[<-|[<-|[<-|[]]]]]; try lia; simpl; tauto. }
    destruct T as [T|T]; specialize (H _ T); cbv beta iota in H; rewrite <- C1, <- C2 in H; discriminate.
Qed.

(** *** All statements *)
Theorem statement_sound st : check_statement c st = true -> holds l1 l2 l3 r N cP (dstatement st).
Proof.
  intros H. destruct st as [| |rel sg p q|rel sg p q|rel p q|n p q part| | | |]; cbn [Checker.check_statement dstatement holds] in *; cbv zeta in H.
  - exact (each_angle _ (fun x => x < PI / 2) acute_sound H).
  - exact (each_angle _ (fun x => x <= PI / 2) nonobtuse_sound H).
  - apply andb_true_iff in H as [B H]. apply largest_sound; auto.
  - apply andb_true_iff in H as [B H]. apply smallest_sound; auto.
  - apply andb_true_iff in H as [B H]. apply andb_true_iff in B as [B _]. apply Z.ltb_lt, IZR_lt in B. apply radius_sound; auto.
  - apply andb_true_iff in H as [B H]. apply Z.ltb_lt, IZR_lt in B. apply (uncrossed_sound part); auto.
  - assert (LE : forall x y, alt x y = true -> phi x <= phi y) by (intros x y X; apply alt_ok in X; lra).
    intros cc Hc. apply valid_is_tile in Hc.
    assert (V : 0 < vol (piece cc)) by (destruct cc; apply pvol, Hc).
    assert (V' : vol (tile l1 l2 l3 cP cc) <> 0).
    { rewrite tile_cP, vol_Et. apply Rmult_integral_contrapositive_currified; [lra|apply cdetb]. }
    exists (circumcentre (tile l1 l2 l3 cP cc)), (distance_squared (va (tile l1 l2 l3 cP cc)) (circumcentre (tile l1 l2 l3 cP cc))).
    split; [apply circumscribed_centre; auto|]. intros v Hv. split; [apply (weakly_sound alt LE H cc v Hc Hv)|].
    intros EQ. apply vertex_coordinates in Hv as [c' [x [Hc' [Hx ->]]]]. rewrite tile_cP in *.
    pose proof (power_distance (piece cc) x V) as PD. cbv zeta in PD. cbn [Euclid.Et va] in EQ. fold e in EQ.
    assert (PZ : power G (piece cc) x = 0).
    { pose proof s_pos. apply Rmult_eq_reg_l with s; [|lra]. rewrite Rmult_0_r, <- PD. unfold e in EQ |- *. lra. }
    apply (in_map e (verts (piece cc)) x).
    apply (delaunay_global N cT h (latb r) (open_domain Hs) cM h_pos (latb_add r) (open_domain_convex Hs)
      cdom_inside cvol cmate conce G (weak_local alt LE H) boundary_vertices) with (c' := c'); auto.
    + intros k i Hk Hi. pose proof (cpower k i Hk Hi alt H) as X. destruct (cM k i) as [[[k' i'] d]|]; auto.
      destruct X as [y [X1 X2]]. apply alt_ok in X1. rewrite phi_zero, X2 in X1. pose proof (cvol k Hk).
      apply Rmult_lt_reg_l with (vol (cT k)); auto. lra.
  - intros cc Hc. apply valid_is_tile in Hc.
    assert (V : 0 < vol (piece cc)) by (destruct cc; apply pvol, Hc).
    assert (V' : vol (tile l1 l2 l3 cP cc) <> 0).
    { rewrite tile_cP, vol_Et. apply Rmult_integral_contrapositive_currified; [lra|apply cdetb]. }
    exists (circumcentre (tile l1 l2 l3 cP cc)), (distance_squared (va (tile l1 l2 l3 cP cc)) (circumcentre (tile l1 l2 l3 cP cc))).
    split; [apply circumscribed_centre; auto|]. intros v Hv. apply (weakly_sound ale ale_ok H cc v Hc Hv).
  - apply not_delaunay_sound, H.
  - apply tcp_sound, H.
Qed.
End Basis.
End Sound.

(** ** The theorem *)
Lemma tiling_based c : check_tiling c = true -> based c.
Proof. intros H. destruct (chk_all c H) as [H1 [_ [H2 [_ [_ [_ [H3 _]]]]]]]. repeat split; auto. Qed.
Theorem check_sound c ss : check c ss = true -> forall l1 l2 l3, has_gram (dgram c) l1 l2 l3 ->
  face_to_face_tiling l1 l2 l3 (c_rank c) (ddomain c l1 l2 l3) (length (c_tets c)) (dtet c l1 l2 l3) /\
  forall s, In s (map dstatement ss) -> holds l1 l2 l3 (c_rank c) (length (c_tets c)) (dtet c l1 l2 l3) s.
Proof.
  intros H l1 l2 l3 HG. unfold Checker.check in H. apply andb_true_iff in H as [H1 H2]. rewrite forallb_forall in H2.
  pose proof (tiling_based c H1) as B.
  split; [apply tiling_sound; auto|]. intros s Hs. apply in_map_iff in Hs as [st [<- Hs]]. rewrite (dtet_cP c B). apply statement_sound; auto.
Qed.
(** A basis with that Gram matrix exists. *)
Theorem basis_exists c ss : check c ss = true -> exists l1 l2 l3, has_gram (dgram c) l1 l2 l3.
Proof.
  intros H. unfold Checker.check in H. apply andb_true_iff in H as [H1 H2]. apply gram_exists.
  apply (cgram c (tiling_based c H1)).
Qed.
End Ring.
