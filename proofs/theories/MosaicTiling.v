(** * Systems of patches: finitely many conditions imply the tiling

    Here patches have real coordinates, and the conditions are propositions; MosaicChecker.v decides them.
    Everything around a wall is said in the coordinates of one of its two tiles: [carry] takes
    those of the other tile to them, up to periods.  A facet of a cell is an *occupant* of a patch, moved by
    a period: a facet of the piece, or a lateral triangle of a pyramid; or it is one of the two
    facets of a tetrahedron of a join that contain its axis. *)
Require Import Reals Lra Psatz ZArith List Lia Bool ConstructiveEpsilon.
From Coq Require Arith.Cantor.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Bounds Degree Domain Euclid Transfer MosaicStatement.
From Acutile Require Import Cells.
Import ListNotations.
Open Scope R_scope.

(** ** Choice from countable sets *)
Lemma dec (P : Prop) : {P} + {~ P}.
Proof.
  destruct (ClassicalDedekindReals.sig_not_dec P) as [N|N]; [left|right; exact N].
  destruct (Classical_Prop.classic P); tauto.
Qed.
Section Choice.
Context {A : Type} (f : A -> nat) (g : nat -> A) (gf : forall x, g (f x) = x).
Lemma choose (P : A -> Prop) : {x | (exists y, P y) -> P x}.
Proof.
  destruct (dec (exists y, P y)) as [E|E].
  - destruct (constructive_indefinite_ground_description A f g gf P (fun x => dec (P x)) E) as [x Px]. exists x. auto.
  - exists (g 0%nat). tauto.
Qed.
End Choice.
Definition code_z (z : Z) : nat := Cantor.to_nat (Z.to_nat z, Z.to_nat (- z)).
Definition decode_z (n : nat) : Z := let '(a, b) := Cantor.of_nat n in (Z.of_nat a - Z.of_nat b)%Z.
Lemma decode_code z : decode_z (code_z z) = z.
Proof. unfold decode_z, code_z. rewrite Cantor.cancel_of_to. lia. Qed.
Definition code3 (n : Z3) : nat := let '(x, y, z) := n in Cantor.to_nat (code_z x, Cantor.to_nat (code_z y, code_z z)).
Definition decode3 (k : nat) : Z3 := let '(a, b) := Cantor.of_nat k in let '(b, c) := Cantor.of_nat b in (decode_z a, decode_z b, decode_z c).
Lemma decode3_code n : decode3 (code3 n) = n.
Proof. destruct n as [[x y] z]. unfold decode3, code3. rewrite !Cantor.cancel_of_to, !decode_code. reflexivity. Qed.
Definition choose3 := choose code3 decode3 decode3_code.
Definition choose_pair := choose Cantor.to_nat Cantor.of_nat Cantor.cancel_of_to.

(** ** Small facts *)
Lemma next_lt n s : (s < n)%nat -> (next n s < n)%nat.
Proof. unfold next. destruct (Nat.eqb_spec (S s) n); lia. Qed.
Definition prev (n s : nat) : nat := match s with O => Nat.pred n | S s' => s' end.
Lemma prev_lt n s : (s < n)%nat -> (prev n s < n)%nat.
Proof. unfold prev. destruct s; lia. Qed.
Lemma prev_next n s : (s < n)%nat -> prev n (next n s) = s.
Proof. unfold prev, next. destruct (Nat.eqb_spec (S s) n); intros; cbn; lia. Qed.
Lemma next_prev n s : (s < n)%nat -> next n (prev n s) = s.
Proof. unfold prev, next. destruct s; intros; [destruct (Nat.eqb_spec (S (Nat.pred n)) n)|destruct (Nat.eqb_spec (S s) n)]; lia. Qed.
(** A triangle with its vertices in another order, of the same orientation. *)
Definition turns (f g : triangle) := f = g \/ f = Triangle (t2 g) (t3 g) (t1 g) \/ f = Triangle (t3 g) (t1 g) (t2 g).
Lemma turns_opposite f f' g g' : turns f f' -> turns g g' -> opposite f' g' -> opposite f g.
Proof. intros [->|[->| ->]] [->|[->| ->]]; unfold opposite; cbn [t1 t2 t3]; intuition. Qed.

Definition pt (n : Z3) : point := let '(x, y, z) := n in Point (IZR x) (IZR y) (IZR z).
Definition lift (n : Z3) (x : point) : point := add x (pt n).
Lemma pt_add a b : pt (zadd3 a b) = add (pt a) (pt b).
Proof. destruct a as [[? ?] ?], b as [[? ?] ?]. unfold pt, zadd3, add; cbn. rewrite !plus_IZR. reflexivity. Qed.
Lemma pt_opp a : pt (zopp3 a) = scale (-1) (pt a).
Proof. destruct a as [[? ?] ?]. unfold pt, zopp3, scale; cbn. rewrite !opp_IZR. apply point_eq; cbn; ring. Qed.
Lemma pt_inj a b : pt a = pt b -> a = b.
Proof. destruct a as [[? ?] ?], b as [[? ?] ?]. unfold pt. intros E. injection E as A B C. apply eq_IZR in A, B, C. congruence. Qed.
Lemma lift_lift a b x : lift a (lift b x) = lift (zadd3 a b) x.
Proof. unfold lift. rewrite pt_add. apply point_eq; unf; ring. Qed.
Lemma lift_zero x : lift z30 x = x.
Proof. unfold lift, pt, z30. apply point_eq; unf; ring. Qed.
Lemma z3_eq (x y z x' y' z' : Z) : x = x' -> y = y' -> z = z' -> (x, y, z) = (x', y', z').
Proof. congruence. Qed.
Lemma zadd3_opp a : zadd3 a (zopp3 a) = z30.
Proof. destruct a as [[? ?] ?]. unfold zadd3, zopp3, z30. apply z3_eq; lia. Qed.
Lemma zadd3_comm a b : zadd3 a b = zadd3 b a.
Proof. destruct a as [[? ?] ?], b as [[? ?] ?]. unfold zadd3. apply z3_eq; lia. Qed.
Lemma zadd3_assoc a b c : zadd3 a (zadd3 b c) = zadd3 (zadd3 a b) c.
Proof. destruct a as [[? ?] ?], b as [[? ?] ?], c as [[? ?] ?]. unfold zadd3. apply z3_eq; lia. Qed.
Lemma zadd3_zero a : zadd3 a z30 = a.
Proof. destruct a as [[? ?] ?]. unfold zadd3, z30. apply z3_eq; lia. Qed.
Lemma zopp3_opp a : zopp3 (zopp3 a) = a.
Proof. destruct a as [[? ?] ?]. unfold zopp3. apply z3_eq; lia. Qed.
Ltac z3 := repeat match goal with n : Z3 |- _ => destruct n as [[? ?] ?] end; unfold zadd3, zopp3, z30; apply z3_eq; lia.
Lemma latb_opp r a : latb r a = true -> latb r (zopp3 a) = true.
Proof. rewrite !latb_iff. destruct a as [[? ?] ?], r as [|[|[|r]]]; simpl; intuition lia. Qed.

Definition map_tet (f : point -> point) (t : tetrahedron) := Tetrahedron (f (va t)) (f (vb t)) (f (vc t)) (f (vd t)).
Definition map_tri (f : point -> point) (t : triangle) := Triangle (f (t1 t)) (f (t2 t)) (f (t3 t)).
Lemma facet_map f t i : facet (map_tet f t) i = map_tri f (facet t i).
Proof. destruct i as [|[|[|i]]]; reflexivity. Qed.
Lemma vx_map f t i : vx (map_tet f t) i = f (vx t i).
Proof. destruct i as [|[|[|i]]]; reflexivity. Qed.
Lemma opposite_map f s t : opposite s t -> opposite (map_tri f s) (map_tri f t).
Proof. unfold opposite, map_tri; cbn [t1 t2 t3]. intuition congruence. Qed.

(** A vector that is orthogonal to two independent ones and in their plane is zero. *)
Lemma flat_zero a b w : dot a w = 0 -> dot b w = 0 -> det a b w = 0 -> dot a a * dot b b - dot a b * dot a b <> 0 -> w = origin.
Proof.
  intros A B D N.
  assert (E : det a b w * det a b w = (dot a a * dot b b - dot a b * dot a b) * dot w w
    - dot a w * (dot a w * dot b b - dot b w * dot a b) + dot b w * (dot a w * dot a b - dot b w * dot a a)).
  { unfold det, dot. ring. }
  rewrite A, B, D in E. assert (W : dot w w = 0) by nra. unfold dot in W.
  pose proof (Rle_0_sqr (px w)); pose proof (Rle_0_sqr (py w)); pose proof (Rle_0_sqr (pz w)); unfold Rsqr in *.
  apply point_eq; unfold origin; cbn; match goal with |- ?x = 0 => assert (K : x * x = 0) by lra; apply Rmult_integral in K; tauto end.
Qed.

(** A finite set of points is not moved into itself. *)
Lemma no_shift L d : L <> [] -> (forall h, In h L -> exists h', In h' L /\ h = lift d h') -> d = z30.
Proof.
  intros NE H. destruct L as [|x L]; [congruence|]. destruct (smallest_exists (dot x (pt d)) (map (fun h => dot h (pt d)) L)) as [q [I U]].
  change (In q (map (fun h => dot h (pt d)) (x :: L))) in I. apply in_map_iff in I as [h [<- I]]. destruct (H h I) as [h' [I' E]].
  assert (Q : dot h (pt d) <= dot h' (pt d)) by (apply U; exact (in_map (fun h => dot h (pt d)) (x :: L) h' I')).
  rewrite E in Q. apply pt_inj. set (w := pt d) in *. unfold lift in Q. fold w in Q. clearbody w. unfold dot, add in Q; cbn in Q.
  pose proof (Rle_0_sqr (px w)); pose proof (Rle_0_sqr (py w)); pose proof (Rle_0_sqr (pz w)); unfold Rsqr in *.
  apply point_eq; cbn; match goal with |- ?x = 0 => assert (K : x * x = 0) by lra; apply Rmult_integral in K; tauto end.
Qed.

(** ** Patches and their occupants *)
Definition no_pyramid := Pyramid origin [].
Definition no_tet := Tetrahedron origin origin origin origin.
Definition pyramid_at (p : patch) (q : nat) := nth q (pyramids p) no_pyramid.
Definition rim_count (p : patch) (q : nat) := length (rim (pyramid_at p q)).
Definition rim_at (p : patch) (q e : nat) := nth e (rim (pyramid_at p q)) origin.
Definition apex_at (p : patch) (q : nat) := apex (pyramid_at p q).
Definition piece_at (p : patch) (k : nat) := nth k (pieces p) no_tet.
(** A facet f of the tetrahedron k of the piece, or the lateral triangle of pyramid q over the side e of its rim. *)
Inductive occupant := Facet (k f : nat) | Lateral (q e : nat).
(** It is that of another occupant, moved by a period, or the triangle w in the wall s. *)
Inductive entry := Inner (o : occupant) (n : Z3) | Wall (s w : nat).
Definition triangle_of (p : patch) (o : occupant) : triangle := match o with
  | Facet k f => facet (piece_at p k) f
  | Lateral q e => Triangle (rim_at p q e) (apex_at p q) (rim_at p q (next (rim_count p q) e)) end.
Definition is_occupant (p : patch) (o : occupant) : Prop := match o with
  | Facet k f => (k < length (pieces p))%nat /\ (f < 4)%nat
  | Lateral q e => (q < length (pyramids p))%nat /\ (e < rim_count p q)%nat end.
Record hints := Hints {
  (* what is behind an occupant of a patch; the owner of the triangle w in the wall s; how many there are; the side of a pyramid *)
  behind : nat -> occupant -> entry;
  owner : nat -> nat -> nat -> occupant;
  owners : nat -> nat -> nat;
  side_of : nat -> nat -> nat;
  (* for pyramid q, or side s, of patch a and side s' of patch b: the pyramid on the other side and its period, sides of
     the rims, triangles in the wall and their periods *)
  pyramid_mate : nat -> nat -> nat -> nat -> nat * Z3;
  rim_mate : nat -> nat -> nat -> nat -> nat -> nat;
  wall_mate : nat -> nat -> nat -> nat -> nat -> nat * Z3 }.

(** ** From the coordinates of one tile to those of the next one *)
Section Carry.
Variables (G : gram) (r : nat).
Definition along (p : patch) (s : nat) : point := sub (finish r p s) (start (edge_at p s)).
Definition length2 (p : patch) (s : nat) : R := let u := along p s in
  g22 G * (py u * py u) + g33 G * (pz u * pz u) + g23 G * (py u * pz u + pz u * py u).
Definition carry (p : patch) (s : nat) (q : patch) (s' : nat) (x : point) : point :=
  let A := start (edge_at p s) in let B := start (edge_at q s') in let b := sub x B in
  match r with
  | 1%nat => let u := along p s in let v := along q s' in let N := length2 p s in
    let X := g22 G * (py b * py v) + g33 G * (pz b * pz v) + g23 G * (py b * pz v + pz b * py v) in
    let Y := py v * pz b - pz v * py b in
    Point (px b + px A) (py A + ((N - X) / N * py u + Y / N * (g23 G * py u + g33 G * pz u)))
      (pz A + ((N - X) / N * pz u - Y / N * (g22 G * py u + g23 G * pz u)))
  | _ => add b A
  end.
Definition fits (p : patch) (s : nat) (q : patch) (s' : nat) : Prop :=
  class (edge_at p s) = class (edge_at q s') /\ (r = 2%nat -> s <> s') /\ (r = 1%nat -> length2 p s = length2 q s' /\ length2 p s <> 0).
Hypothesis rank : r = 1%nat \/ r = 2%nat.

Lemma left_affine p s t a b c d : a + b + c + d = 1 -> left_of r p s (combination t a b c d) =
  a * left_of r p s (va t) + b * left_of r p s (vb t) + c * left_of r p s (vc t) + d * left_of r p s (vd t).
Proof.
  intros S. unfold left_of, combination. replace d with (1 - a - b - c) by lra.
  destruct rank as [-> | ->]; [unf; ring|]. destruct s; unf; ring.
Qed.
Lemma left_fibre p s f x : in_fibre r f -> left_of r p s (add x f) = left_of r p s x.
Proof.
  unfold left_of, in_fibre. destruct rank as [-> | ->].
  - intros [Y Z]. unf. rewrite Y, Z. ring.
  - intros Z. destruct s; unf; rewrite Z; ring.
Qed.
Lemma lattice_fibre n : in_lattice r n -> in_fibre r (pt n).
Proof. destruct n as [[x y] z]. unfold in_fibre, pt. destruct rank as [-> | ->]; cbn; [intros [-> ->]; auto|intros ->; auto]. Qed.
Lemma left_lift p s n x : latb r n = true -> left_of r p s (lift n x) = left_of r p s x.
Proof. intros L. apply left_fibre, lattice_fibre, latb_iff, L. Qed.
Lemma left_carry p s q s' x : (s < 2 \/ r = 1)%nat -> (s' < 2 \/ r = 1)%nat -> fits p s q s' -> left_of r q s' x = - left_of r p s (carry p s q s' x).
Proof.
  intros S S' [_ [D L]]. revert S S' D L. unfold left_of, carry, length2, along, finish. destruct rank as [-> | ->]; intros S S' D L.
  - destruct (L eq_refl) as [_ N]. clear L D. cbv zeta in *. cbn [px py pz sub] in *. set (A := start (edge_at p s)) in *. set (A' := start (edge_at p (next (sides p) s))) in *. set (B := start (edge_at q s')). set (B' := start (edge_at q (next (sides q) s'))).
    field. exact N.
  - specialize (D eq_refl). destruct s as [|[|s]]; [| |lia]; destruct s' as [|[|s']]; try lia; unf; ring.
Qed.
Lemma carry_carry p s q s' x : fits p s q s' -> carry q s' p s (carry p s q s' x) = x.
Proof.
  intros [_ [_ L]]. unfold carry. destruct rank as [E|E]; rewrite E in *; [|apply point_eq; unf; ring].
  destruct (L eq_refl) as [NN N0]. clear L. unfold length2 in *. set (u := along p s) in *. set (v := along q s') in *.
  set (A := start (edge_at p s)). set (B := start (edge_at q s')). set (b := sub x B). clearbody u v.
  set (N := g22 G * (py u * py u) + g33 G * (pz u * pz u) + g23 G * (py u * pz u + pz u * py u)) in *.
  set (M := g22 G * (py v * py v) + g33 G * (pz v * pz v) + g23 G * (py v * pz v + pz v * py v)) in *.
  set (X := g22 G * (py b * py v) + g33 G * (pz b * pz v) + g23 G * (py b * pz v + pz b * py v)). set (Y := py v * pz b - pz v * py b).
  cbv zeta. cbn [px py pz sub]. set (P := (N - X) / N * py u + Y / N * (g23 G * py u + g33 G * pz u)). set (Q := (N - X) / N * pz u - Y / N * (g22 G * py u + g23 G * pz u)).
  replace (py A + P - py A) with P by ring. replace (pz A + Q - pz A) with Q by ring.
  assert (EX : g22 G * (P * py u) + g33 G * (Q * pz u) + g23 G * (P * pz u + Q * py u) = N - X).
  { transitivity ((N - X) / N * N); [unfold P, Q, N; ring|field; exact N0]. }
  assert (EY : py u * Q - pz u * P = - Y).
  { transitivity (- (Y / N) * N); [unfold P, Q, N; ring|field; exact N0]. }
  rewrite EX, EY. assert (XB : x = add B b) by (unfold b; apply point_eq; unf; ring).
  assert (E2 : M * py b = X * py v + Y * (- (g23 G * py v + g33 G * pz v))) by (unfold X, Y, M; ring).
  assert (E3 : M * pz b = X * pz v + Y * (g22 G * py v + g23 G * pz v)) by (unfold X, Y, M; ring).
  rewrite <- NN in *. clearbody P Q X Y N M b. subst x. apply point_eq; cbn [px py pz add].
  - ring.
  - f_equal. apply Rmult_eq_reg_l with N; auto. rewrite E2. field. exact N0.
  - f_equal. apply Rmult_eq_reg_l with N; auto. rewrite E3. field. exact N0.
Qed.
Lemma fits_sym p s q s' : fits p s q s' -> fits q s' p s.
Proof. intros [A [B C]]. repeat split; auto; [intros R K; apply (B R); auto|apply C in H as [-> ?]; auto|apply C in H as [<- ?]; auto]. Qed.
End Carry.

(** ** The conditions on a system of patches *)
Section System.
Variables (G : gram) (r : nat) (system : list patch) (h : hints).
Notation patch_at a := (nth a system (Patch [] [] [])).
Notation carry := (carry G r).
Notation left_of := (left_of r).
Notation in_prism := (in_prism r).
Definition join (a q b s' e : nat) : tetrahedron := let p := patch_at a in let '(q', m) := pyramid_mate h a q b s' in
  Tetrahedron (lift m (carry p (side_of h a q) (patch_at b) s' (apex_at (patch_at b) q'))) (rim_at p q e)
    (rim_at p q (next (rim_count p q) e)) (apex_at p q).
Definition good_occupant (a : nat) (o : occupant) : Prop := let p := patch_at a in
  match behind h a o with
  | Inner o' n => is_occupant p o' /\ latb r n = true /\ behind h a o' = Inner o (zopp3 n) /\
      opposite (triangle_of p o) (map_tri (lift n) (triangle_of p o'))
  | Wall s w => (s < sides p)%nat /\ (w < owners h a s)%nat /\ owner h a s w = o
  end.
Definition good_pyramid (a q : nat) : Prop := let p := patch_at a in let s := side_of h a q in
  (s < sides p)%nat /\ (0 < rim_count p q)%nat /\ in_prism p (apex_at p q) /\ 0 < left_of p s (apex_at p q) /\
  (forall e, (e < rim_count p q)%nat -> in_prism p (rim_at p q e) /\ left_of p s (rim_at p q e) = 0) /\
  (forall s2, (s2 < sides p)%nat -> s2 <> s -> exists e, (e < rim_count p q)%nat /\ left_of p s2 (rim_at p q e) <> 0) /\
  (* no other pyramid in this side has this rim, moved by a period *)
  (forall q2, (q2 < length (pyramids p))%nat -> q2 <> q -> side_of h a q2 = s ->
     forall n, latb r n = true -> exists e, (e < rim_count p q)%nat /\ forall e2, (e2 < rim_count p q2)%nat -> rim_at p q e <> lift n (rim_at p q2 e2)).
(** Two sides that can meet: their rims and triangles are mates, and the axes of joins cross them. *)
Definition good_pair (a s b s' : nat) : Prop := let p := patch_at a in let p' := patch_at b in
  (forall q, (q < length (pyramids p))%nat -> side_of h a q = s -> let '(q', m) := pyramid_mate h a q b s' in
     (q' < length (pyramids p'))%nat /\ side_of h b q' = s' /\ latb r m = true /\ pyramid_mate h b q' a s = (q, zopp3 m) /\
     (forall e, (e < rim_count p q)%nat -> let e' := rim_mate h a q b s' e in
        (e' < rim_count p' q')%nat /\ rim_mate h b q' a s e' = e /\
        rim_at p q e = lift m (carry p s p' s' (rim_at p' q' (next (rim_count p' q') e'))) /\
        rim_at p q (next (rim_count p q) e) = lift m (carry p s p' s' (rim_at p' q' e')) /\ 0 < vol (join a q b s' e)) /\
     let l := apex_at p q in let l' := lift m (carry p s p' s' (apex_at p' q')) in
     forall t, (t < sides p)%nat -> 0 <= left_of p s l * left_of p t l' - left_of p s l' * left_of p t l) /\
  (forall w, (w < owners h a s)%nat -> let '(w', m) := wall_mate h a s b s' w in
     (w' < owners h b s')%nat /\ latb r m = true /\ wall_mate h b s' a s w' = (w, zopp3 m) /\
     opposite (triangle_of p (owner h a s w)) (map_tri (fun x => lift m (carry p s p' s' x)) (triangle_of p' (owner h b s' w')))).
(** A point that is in one tetrahedron of the piece, and in no other cell. *)
Definition has_home (a : nat) : Prop := let p := patch_at a in exists k x, (k < length (pieces p))%nat /\
  inside (piece_at p k) x /\ inside_prism r p x /\
  (forall k' n, (k' < length (pieces p))%nat -> latb r n = true -> (k', n) <> (k, z30) -> ~ closed (piece_at p k') (lift n x)) /\
  (forall q b s' e n, (q < length (pyramids p))%nat -> (b < length system)%nat -> (s' < sides (patch_at b))%nat ->
     fits G r p (side_of h a q) (patch_at b) s' -> (e < rim_count p q)%nat -> latb r n = true -> ~ closed (join a q b s' e) (lift n x)).
Record good : Prop := {
  good_rank : r = 1%nat \/ r = 2%nat;
  good_blocks : g13 G = 0 /\ (r = 1%nat -> g12 G = 0) /\ (r = 2%nat -> g23 G = 0);
  good_sides : forall a, (a < length system)%nat -> r = 2%nat -> sides (patch_at a) = 2%nat;
  good_convex : r = 1%nat -> forall a s t, (a < length system)%nat -> (s < sides (patch_at a))%nat -> (t < sides (patch_at a))%nat ->
    (3 <= sides (patch_at a))%nat /\ (t <> s -> t <> prev (sides (patch_at a)) s -> 0 < left_of (patch_at a) t (start (edge_at (patch_at a) s)));
  good_lengths : forall a s b s', (a < length system)%nat -> (b < length system)%nat -> (s < sides (patch_at a))%nat -> (s' < sides (patch_at b))%nat ->
    class (edge_at (patch_at a) s) = class (edge_at (patch_at b) s') -> (r = 2%nat -> s <> s') -> fits G r (patch_at a) s (patch_at b) s';
  good_pieces : forall a k, (a < length system)%nat -> (k < length (pieces (patch_at a)))%nat ->
    0 < vol (piece_at (patch_at a) k) /\ forall v, In v (verts (piece_at (patch_at a) k)) -> in_prism (patch_at a) v;
  good_occupants : forall a o, (a < length system)%nat -> is_occupant (patch_at a) o -> good_occupant a o;
  good_pyramids : forall a q, (a < length system)%nat -> (q < length (pyramids (patch_at a)))%nat -> good_pyramid a q;
  good_walls : forall a s w, (a < length system)%nat -> (s < sides (patch_at a))%nat -> (w < owners h a s)%nat ->
    is_occupant (patch_at a) (owner h a s w) /\ behind h a (owner h a s w) = Wall s w;
  good_wall_facets : forall a o s w, (a < length system)%nat -> is_occupant (patch_at a) o -> behind h a o = Wall s w -> exists k f, o = Facet k f;
  good_pairs : forall a s b s', (a < length system)%nat -> (b < length system)%nat -> (s < sides (patch_at a))%nat -> (s' < sides (patch_at b))%nat ->
    fits G r (patch_at a) s (patch_at b) s' -> good_pair a s b s';
  good_homes : forall a, (a < length system)%nat -> has_home a }.
Hypothesis OK : good.

Lemma rank_eq : r = 1%nat \/ r = 2%nat.
Proof. apply OK. Qed.

(** ** A mosaic over it *)
Variables (l1 l2 l3 : point).
Hypothesis basis : has_gram G l1 l2 l3.
Hypothesis right_handed : 0 < det l1 l2 l3.
Variable tiles : nat -> tile.
Hypothesis tiling : mosaic l1 l2 l3 G r system tiles.
Notation kind i := (shape (tiles i)).
Notation patch_of i := (patch_of system tiles i).
Notation meets i s j s' := (meets l1 l2 l3 r system tiles i s j s').
Notation place i x := (place tiles i x).
Notation period n := (period l1 l2 l3 n).

Lemma kind_lt i : (kind i < length system)%nat.
Proof. apply tiling. Qed.
Lemma motion i : exists m2 m3, axes (tiles i) = (l1, m2, m3) /\ has_gram G l1 m2 m3 /\ det l1 m2 m3 = det l1 l2 l3 /\ (r = 2%nat -> m2 = l2 /\ m3 = l3).
Proof.
  pose proof (mosaic_motions _ _ _ _ _ _ _ tiling i) as M. destruct (axes (tiles i)) as [[m1 m2] m3]. destruct M as [HG [D [-> R2]]].
  exists m2, m3. split; [reflexivity|]. split; [exact HG|]. split; [exact D|]. intros H.
  pose proof (R2 H) as E. subst m2. split; [reflexivity|]. assert (Z : sub m3 l3 = origin).
  { destruct HG as [A1 [A2 [A3 [A4 [A5 A6]]]]]. destruct basis as [B1 [B2 [B3 [B4 [B5 B6]]]]].
    assert (S : forall u v w, dot u (sub v w) = dot u v - dot u w) by (intros; unfold dot; unf; ring).
    assert (T : forall u v w x, det u v (sub w x) = det u v w - det u v x) by (intros; unf; ring).
    apply (flat_zero l1 l2); rewrite ?S, ?T; try lra. intros K.
    assert (E : det l1 l2 l3 * det l1 l2 l3 = (dot l1 l1 * dot l2 l2 - dot l1 l2 * dot l1 l2) * dot l3 l3
      - dot l1 l3 * (dot l1 l3 * dot l2 l2 - dot l2 l3 * dot l1 l2) + dot l2 l3 * (dot l1 l3 * dot l1 l2 - dot l2 l3 * dot l1 l1)) by (unfold det, dot; ring).
    destruct (good_blocks OK) as [Z13 [_ Z23]]. rewrite K, B5, B6, Z13, (Z23 H) in E. nra. }
  apply point_eq; [apply (f_equal px) in Z|apply (f_equal py) in Z|apply (f_equal pz) in Z]; unf; unfold origin in Z; cbn in Z; lra.
Qed.
Lemma place_affine i t a b c d : a + b + c + d = 1 -> combination (map_tet (fun x => place i x) t) a b c d = place i (combination t a b c d).
Proof.
  intros S. unfold MosaicStatement.place. destruct (axes (tiles i)) as [[m1 m2] m3]. unfold combination, map_tet, at_coordinates; cbn [va vb vc vd].
  replace d with (1 - a - b - c) by lra. apply point_eq; unf; ring.
Qed.
Lemma place_orient i a b c d : orient (place i a) (place i b) (place i c) (place i d) = det l1 l2 l3 * orient a b c d.
Proof.
  destruct (motion i) as [m2 [m3 [E [_ [D _]]]]]. unfold MosaicStatement.place. rewrite E, <- D. unfold at_coordinates. unf. ring.
Qed.
Lemma place_period i n x : in_lattice r n -> place i (lift n x) = add (place i x) (period n).
Proof.
  intros L. destruct (motion i) as [m2 [m3 [E [_ [_ R2]]]]]. unfold MosaicStatement.place, MosaicStatement.period, lattice_vector. rewrite E.
  destruct n as [[a b] c]. unfold lift, pt, at_coordinates. destruct rank_eq as [R|R]; rewrite R in L; cbn in L.
  - destruct L as [-> ->]. apply point_eq; unf; ring.
  - subst c. destruct (R2 R) as [-> ->]. apply point_eq; unf; ring.
Qed.
Lemma place_fibre i f x : in_fibre r f -> place i (add x f) = add (place i x) (at_coordinates l1 l2 l3 f).
Proof.
  intros L. destruct (motion i) as [m2 [m3 [E [_ [_ R2]]]]]. unfold MosaicStatement.place. rewrite E. unfold at_coordinates.
  destruct rank_eq as [R|R]; rewrite R in L; cbn in L.
  - destruct L as [Y Z]. apply point_eq; unf; rewrite Y, Z; ring.
  - destruct (R2 R) as [-> ->]. apply point_eq; unf; rewrite L; ring.
Qed.
Lemma period_inj n m : period n = period m -> n = m.
Proof.
  intros E. apply pt_inj. unfold MosaicStatement.period, lattice_vector in E. destruct n as [[a b] c], m as [[a' b'] c']. unfold pt.
  apply (E_inj l1 l2 l3) in E; auto. lra.
Qed.
Lemma period_add n m : period (zadd3 n m) = add (period n) (period m).
Proof. destruct n as [[a b] c], m as [[a' b'] c']. unfold MosaicStatement.period, lattice_vector, zadd3, at_coordinates. rewrite !plus_IZR. apply point_eq; unf; ring. Qed.
Lemma place_inj i x y : place i x = place i y -> x = y.
Proof.
  destruct (motion i) as [m2 [m3 [E [_ [D _]]]]]. unfold MosaicStatement.place. rewrite E. intros K.
  apply (E_inj l1 m2 m3); [lra|]. apply point_eq; [apply (f_equal px) in K|apply (f_equal py) in K|apply (f_equal pz) in K]; unfold Euclid.E; unf; lra.
Qed.

(** ** Sides that meet *)
Lemma meets_sym i s j s' : meets i s j s' -> meets j s' i s.
Proof.
  assert (B : forall X Y, same_base l1 l2 l3 r X Y -> same_base l1 l2 l3 r Y X).
  { intros X Y [f [F ->]]. exists (scale (-1) f). split.
    - unfold in_fibre, scale in *. destruct rank_eq as [-> | ->]; cbn in *; [destruct F as [-> ->]; lra|rewrite F; ring].
    - unfold at_coordinates. apply point_eq; unf; ring. }
  intros [A1 [A2 [A3 [A4 [A5 A6]]]]]. repeat split; auto. intros R Q. apply (A4 R). auto.
Qed.
Lemma meets_fits i s j s' : meets i s j s' -> fits G r (patch_of i) s (patch_of j) s'.
Proof.
  intros M. pose proof M as [A1 [A2 [_ [A4 _]]]]. apply (good_lengths OK); auto using kind_lt. apply (mosaic_classes _ _ _ _ _ _ _ tiling _ _ _ _ M).
Qed.
Lemma side_small i s : (s < sides (patch_of i))%nat -> (s < 2 \/ r = 1)%nat.
Proof. intros H. destruct rank_eq as [|R]; auto. left. pose proof (good_sides OK (kind i) (kind_lt i) R) as E. unfold MosaicStatement.patch_of in H. lia. Qed.

(** *** A side of the mosaic is that of two tiles *)
(** Two points of a patch over the same point of the base, for r = 1. *)
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
(** The ends of a side are in the prism. *)
Lemma start_in i s : r = 1%nat -> (s < sides (patch_of i))%nat -> in_prism (patch_of i) (start (edge_at (patch_of i) s)).
Proof.
  intros R Hs t Ht. destruct (Nat.eq_dec t s) as [->|N]; [rewrite left_start by exact R; lra|].
  destruct (Nat.eq_dec t (prev (sides (patch_of i)) s)) as [->|N']; [rewrite left_prev by auto; lra|].
  apply Rlt_le. apply (proj2 (good_convex OK R (kind i) s t (kind_lt i) Hs Ht) N N').
Qed.
Lemma finish_in i s : r = 1%nat -> (s < sides (patch_of i))%nat -> in_prism (patch_of i) (finish r (patch_of i) s).
Proof. intros R Hs t Ht. rewrite (left_place _ _ _ _ R (finish_next _ _ R)). apply start_in; auto using next_lt. Qed.

(** Two directions V and V' on one side of the plane of l and u: a small multiple of V is one of V', up to l and u. *)
Lemma common_direction l u V V' : 0 < det l u V * det l u V' -> exists c c' k m, 0 < c <= 1 / 4 /\ 0 < c' <= 1 / 4 /\ - (1 / 4) <= k <= 1 / 4 /\
  scale c V = add (scale c' V') (add (scale k u) (scale m l)).
Proof.
  intros P. set (L := det l u V) in *. set (L' := det l u V') in *.
  assert (L0 : L <> 0) by (intros E; rewrite E in P; lra). assert (L0' : L' <> 0) by (intros E; rewrite E in P; lra).
  assert (P' : 0 < L' * L') by (destruct (Rdichotomy _ _ L0'); nra).
  set (W := sub (scale (L' * L') V) (scale (L * L') V')).
  assert (W0 : det l u W = 0) by (unfold W; transitivity (L' * L' * L - L * L' * L'); [unfold L, L'; unf; ring|ring]).
  set (K := det l W V / L). set (M := det W u V / L).
  assert (WE : W = add (scale K u) (scale M l)).
  { assert (C : scale L W = add (scale (det W u V) l) (add (scale (det l W V) u) (scale (det l u W) V))) by (unfold L; apply point_eq; unf; ring).
    rewrite W0 in C. unfold K, M. clearbody L W. clear - C L0.
    apply point_eq; [apply (f_equal px) in C|apply (f_equal py) in C|apply (f_equal pz) in C]; unf; apply Rmult_eq_reg_l with L; auto; rewrite C; field; exact L0. }
  set (D := 4 * (1 + L' * L' + L * L' + Rabs K)). assert (K0 : 0 <= Rabs K) by apply Rabs_pos. assert (D0 : 0 < D) by (unfold D; lra).
  assert (B : forall x, - (L' * L' + L * L' + Rabs K) <= x <= L' * L' + L * L' + Rabs K -> - (1 / 4) <= x / D <= 1 / 4).
  { intros x X. split; apply Rmult_le_reg_r with D; auto; replace (x / D * D) with x by (field; lra); unfold D; lra. }
  assert (KA : - Rabs K <= K <= Rabs K) by (split; [pose proof (Rle_abs (- K)); rewrite Rabs_Ropp in *; lra|apply Rle_abs]).
  exists (L' * L' / D), (L * L' / D), (K / D), (M / D). split; [split; [apply Rdiv_lt_0_compat; auto|apply B; lra]|].
  split; [split; [apply Rdiv_lt_0_compat; auto|apply B; lra]|]. split; [apply B; lra|].
  clearbody K M D L L'. clear - WE D0. unfold W in WE.
  apply point_eq; [apply (f_equal px) in WE|apply (f_equal py) in WE|apply (f_equal pz) in WE]; unf; apply Rmult_eq_reg_l with D; try lra; field_simplify; try lra.
Qed.
Lemma within_place i x : inside_prism r (patch_of i) x -> within r system tiles i (place i x).
Proof. intros P. exists x. auto. Qed.
Lemma over_fibre i x f : in_fibre r f -> in_prism (patch_of i) x -> over r system tiles i (add (place i x) (at_coordinates l1 l2 l3 f)).
Proof. intros F P. exists (add x f). rewrite place_fibre by exact F. split; [reflexivity|]. intros s Hs. rewrite (left_fibre r rank_eq) by exact F. apply P, Hs. Qed.
Lemma place_axis i a b x : det l1 (sub (place i a) (place i b)) (sub (place i x) (place i b)) = det l1 l2 l3 * ((py a - py b) * (pz x - pz b) - (pz a - pz b) * (py x - py b)).
Proof. destruct (motion i) as [m2 [m3 [E [_ [D _]]]]]. unfold MosaicStatement.place. rewrite E, <- D. unfold at_coordinates. unf. ring. Qed.
Lemma place_layer i b x : r = 2%nat -> det l1 l2 (sub (place i x) (place i b)) = det l1 l2 l3 * (pz x - pz b).
Proof. intros R. destruct (motion i) as [m2 [m3 [E [_ [_ R2]]]]]. destruct (R2 R) as [-> ->]. unfold MosaicStatement.place. rewrite E. unfold at_coordinates. unf. ring. Qed.
(** Only one other tile has a side. *)
Lemma one_neighbour i s j s' j' s'' : meets i s j s' -> meets i s j' s'' -> j' = j.
Proof.
  intros [_ [Hs' [_ [A3 [[f [F A]] [g [Fg B]]]]]]] [Hs [Hs'' [_ [A3' [[f' [F' A']] [g' [Fg' B']]]]]]].
  destruct (good_homes OK (kind j) (kind_lt j)) as [_ [x [_ [_ [X _]]]]]. destruct (good_homes OK (kind j') (kind_lt j')) as [_ [x' [_ [_ [X' _]]]]].
  change (nth (kind j) system (Patch [] [] [])) with (patch_of j) in *. change (nth (kind j') system (Patch [] [] [])) with (patch_of j') in *.
  rewrite A in A'. rewrite B in B'. clear A B.
  cut (exists y y' h, in_fibre r h /\ inside_prism r (patch_of j) y /\ in_prism (patch_of j') y' /\ place j y = add (place j' y') (at_coordinates l1 l2 l3 h)).
  { intros [y [y' [k [K [Y [Y' E]]]]]]. symmetry. apply (mosaic_apart _ _ _ _ _ _ _ tiling j j' (place j y)); [apply within_place, Y|]. rewrite E. apply over_fibre; auto. }
  destruct rank_eq as [R|R].
  - set (P := finish r (patch_of j) s') in *. set (Q := start (edge_at (patch_of j) s')) in *. set (P' := finish r (patch_of j') s'') in *. set (Q' := start (edge_at (patch_of j') s'')) in *.
    assert (LX : 0 < (py P - py Q) * (pz x - pz Q) - (pz P - pz Q) * (py x - py Q)) by (pose proof (X s' Hs') as L; unfold MosaicStatement.left_of in L; rewrite R in L; unfold P, Q; rewrite R; exact L).
    assert (LX' : 0 < (py P' - py Q') * (pz x' - pz Q') - (pz P' - pz Q') * (py x' - py Q')) by (pose proof (X' s'' Hs'') as L; unfold MosaicStatement.left_of in L; rewrite R in L; unfold P', Q'; rewrite R; exact L).
    apply (Rmult_lt_0_compat _ _ right_handed) in LX, LX'. rewrite <- (place_axis j) in LX. rewrite <- (place_axis j') in LX'.
    assert (DE : forall V, det l1 (sub (place j P) (place j Q)) V = det l1 (sub (place j' P') (place j' Q')) V).
    { rewrite R in F, F', Fg, Fg'. destruct F as [F2 F3], F' as [F2' F3'], Fg as [G2 G3], Fg' as [G2' G3']. intros V. unfold at_coordinates in A', B'. rewrite ?F2, ?F3, ?F2', ?F3' in A'. rewrite ?G2, ?G3, ?G2', ?G3' in B'.
      assert (U : sub (place j P) (place j Q) = add (sub (place j' P') (place j' Q')) (scale (px f' - px f - (px g' - px g)) l1)).
      { apply point_eq; [apply (f_equal px) in A'; apply (f_equal px) in B'|apply (f_equal py) in A'; apply (f_equal py) in B'|apply (f_equal pz) in A'; apply (f_equal pz) in B']; unf; lra. }
      rewrite U. unf. ring. }
    assert (PR : 0 < det l1 (sub (place j P) (place j Q)) (sub (place j x) (place j Q)) * det l1 (sub (place j P) (place j Q)) (sub (place j' x') (place j' Q'))) by (rewrite (DE (sub (place j' x') (place j' Q'))); apply Rmult_lt_0_compat; auto).
    apply common_direction in PR as [c [c' [k [m [C [C' [K E]]]]]]].
    set (t := Tetrahedron P Q x x). set (t' := Tetrahedron P' Q' x' x').
    exists (combination t (1 / 2) (1 / 2 - c) c 0), (combination t' (1 / 2 + k) (1 / 2 - k - c') c' 0).
    assert (Z : exists e, place j (combination t (1 / 2) (1 / 2 - c) c 0) = add (place j' (combination t' (1 / 2 + k) (1 / 2 - k - c') c' 0)) (scale e l1)).
    { rewrite <- !place_affine by field. unfold combination, map_tet, t, t'; cbn [va vb vc vd].
      rewrite R in F, F', Fg, Fg'. destruct F as [F2 F3], F' as [F2' F3'], Fg as [G2 G3], Fg' as [G2' G3']. unfold at_coordinates in A', B'. rewrite ?F2, ?F3, ?F2', ?F3' in A'. rewrite ?G2, ?G3, ?G2', ?G3' in B'.
      exists (m + (1 / 2 + k) * (px f' - px f) + (1 / 2 - k) * (px g' - px g)).
      apply point_eq; [apply (f_equal px) in A'; apply (f_equal px) in B'; apply (f_equal px) in E|apply (f_equal py) in A'; apply (f_equal py) in B'; apply (f_equal py) in E|apply (f_equal pz) in A'; apply (f_equal pz) in B'; apply (f_equal pz) in E];
        unf; clear - A' B' E; nra. }
    destruct Z as [e Z]. exists (Point e 0 0). split; [rewrite R; split; reflexivity|]. split; [|split].
    + intros t0 Ht. rewrite (left_affine r rank_eq) by field. unfold t; cbn [va vb vc vd]. pose proof (finish_in j s' R Hs' t0 Ht : 0 <= left_of (patch_of j) t0 P). pose proof (start_in j s' R Hs' t0 Ht : 0 <= left_of (patch_of j) t0 Q). pose proof (X t0 Ht). nra.
    + intros t0 Ht. rewrite (left_affine r rank_eq) by field. unfold t'; cbn [va vb vc vd]. pose proof (finish_in j' s'' R Hs'' t0 Ht : 0 <= left_of (patch_of j') t0 P'). pose proof (start_in j' s'' R Hs'' t0 Ht : 0 <= left_of (patch_of j') t0 Q'). pose proof (X' t0 Ht). nra.
    + rewrite Z. f_equal. unfold at_coordinates. apply point_eq; unf; ring.
  - pose proof (good_sides OK (kind j) (kind_lt j) R) as N. pose proof (good_sides OK (kind j') (kind_lt j') R) as N'. pose proof (good_sides OK (kind i) (kind_lt i) R) as Ni.
    change (nth (kind j) system (Patch [] [] [])) with (patch_of j) in *. change (nth (kind j') system (Patch [] [] [])) with (patch_of j') in *. change (nth (kind i) system (Patch [] [] [])) with (patch_of i) in *.
    specialize (A3 R). specialize (A3' R). assert (s'' = s') by lia. subst s''. clear B' Fg Fg'.
    pose proof (X 0%nat ltac:(lia)) as X0. pose proof (X 1%nat ltac:(lia)) as X1. pose proof (X' 0%nat ltac:(lia)) as X0'. pose proof (X' 1%nat ltac:(lia)) as X1'.
    unfold finish in A'. rewrite R in F, F', A'. cbn [in_fibre] in F, F'. set (Q := start (edge_at (patch_of j) s')) in *. set (Q' := start (edge_at (patch_of j') s')) in *.
    assert (END : forall p y t, inside_prism r p y -> sides p = 2%nat -> (t < 2)%nat -> 0 <= left_of p t (start (edge_at p s'))).
    { intros p y t Y S Ht. pose proof (Y 0%nat ltac:(lia)) as Y0. pose proof (Y 1%nat ltac:(lia)) as Y1. unfold MosaicStatement.left_of in *. rewrite R in *.
      destruct s' as [|[|s']]; [| |lia]; destruct t as [|[|t]]; try lia; lra. }
    assert (PR : 0 < det l1 l2 (sub (place j x) (place j Q)) * det l1 l2 (sub (place j' x') (place j' Q'))).
    { rewrite !place_layer by exact R. assert (0 < (pz x - pz Q) * (pz x' - pz Q')).
      { unfold Q, Q', MosaicStatement.left_of in *. rewrite R in *. destruct s' as [|[|s']]; [| |lia]; nra. }
      assert (0 < det l1 l2 l3 * det l1 l2 l3) by (apply Rmult_lt_0_compat; auto). nra. }
    apply common_direction in PR as [c [c' [k [m [C [C' [K E]]]]]]].
    set (t := Tetrahedron Q Q x x). set (t' := Tetrahedron Q' Q' x' x').
    exists (combination t (1 - c) 0 c 0), (combination t' (1 - c') 0 c' 0), (Point (m + px f' - px f) (k + py f' - py f) 0).
    split; [rewrite R; reflexivity|]. split; [|split].
    + intros t0 Ht. rewrite (left_affine r rank_eq) by field. unfold t; cbn [va vb vc vd]. pose proof (END (patch_of j) x t0 X N ltac:(lia) : 0 <= left_of (patch_of j) t0 Q). pose proof (X t0 Ht). nra.
    + intros t0 Ht. rewrite (left_affine r rank_eq) by field. unfold t'; cbn [va vb vc vd]. pose proof (END (patch_of j') x' t0 X' N' ltac:(lia) : 0 <= left_of (patch_of j') t0 Q'). pose proof (X' t0 Ht). nra.
    + rewrite <- !place_affine by field. unfold combination, map_tet, t, t', at_coordinates in *; cbn [va vb vc vd]. rewrite F, F' in A'.
      apply point_eq; [apply (f_equal px) in A'; apply (f_equal px) in E|apply (f_equal py) in A'; apply (f_equal py) in E|apply (f_equal pz) in A'; apply (f_equal pz) in E]; unf; clear - A' E; lra.
Qed.
(** And with one of its sides. *)
Lemma meets_once i s j s' j' s'' : meets i s j s' -> meets i s j' s'' -> j' = j /\ s'' = s'.
Proof.
  intros M M'. pose proof (one_neighbour _ _ _ _ _ _ M M') as ->. split; [reflexivity|].
  destruct M as [Hs [Hs' [_ [A3 [[f [F A]] [g [Fg B]]]]]]], M' as [_ [Hs'' [_ [A3' [[f' [F' A']] [g' [Fg' B']]]]]]].
  destruct rank_eq as [R|R].
  - destruct (Nat.eq_dec s' s'') as [|NE]; [auto|exfalso].
    rewrite A, <- !place_fibre in A' by auto. rewrite B, <- !place_fibre in B' by auto.
    assert (PL : forall x y h h', in_fibre r h -> in_fibre r h' -> place j (add x h) = place j (add y h') -> same_place x y).
    { intros x y u u' U U' E. apply place_inj in E. rewrite R in U, U'. destruct U as [U2 U3], U' as [U2' U3']. split; [apply (f_equal py) in E|apply (f_equal pz) in E]; unf; lra. }
    apply (PL _ _ _ _ Fg Fg') in B'. clear A' PL.
    destruct (Nat.eq_dec s' (prev (sides (patch_of j)) s'')) as [EP|NP].
    + destruct (good_homes OK (kind j) (kind_lt j)) as [_ [x [_ [_ [X _]]]]]. specialize (X s' Hs'). change (nth (kind j) system (Patch [] [] [])) with (patch_of j) in X.
      destruct (finish_next (patch_of j) s' R) as [E1 E2]. rewrite EP, next_prev in E1, E2 by exact Hs''. rewrite <- EP in E1, E2. destruct B' as [E3 E4].
      unfold MosaicStatement.left_of in X. rewrite R in X, E1, E2. rewrite E1, E2, <- E3, <- E4 in X. lra.
    + pose proof (proj2 (good_convex OK R (kind j) s'' s' (kind_lt j) Hs'' Hs') NE NP) as L. change (nth (kind j) system (Patch [] [] [])) with (patch_of j) in L.
      rewrite <- (left_place _ _ _ _ R B'), left_start in L by exact R. lra.
  - pose proof (good_sides OK (kind j) (kind_lt j) R) as N. pose proof (good_sides OK (kind i) (kind_lt i) R) as Ni. unfold MosaicStatement.patch_of in *. specialize (A3 R). specialize (A3' R). lia.
Qed.

(** The frames of two tiles that meet. *)
Lemma frame_meets i s j s' P Q T x : meets i s j s' -> in_fibre r P -> in_fibre r Q ->
  place i (add (start (edge_at (patch_of i) s)) P) = add (place j (add (finish r (patch_of j) s') Q)) T ->
  add (place j (add x Q)) T = place i (add (carry (patch_of i) s (patch_of j) s' x) P).
Proof.
  intros M Fi Fj K. pose proof M as [_ [_ [_ [_ [B1 B2]]]]]. pose proof (meets_fits _ _ _ _ M) as [_ [_ N]].
  destruct (motion i) as [a2 [a3 [Ei [HGi [Di R2i]]]]]. destruct (motion j) as [b2 [b3 [Ej [HGj [Dj R2j]]]]].
  destruct (good_blocks OK) as [Z13 [Z12 _]].
  unfold MosaicTiling.carry. unfold MosaicStatement.place in *. rewrite Ei, Ej in *.
  set (A := start (edge_at (patch_of i) s)) in *. set (B := start (edge_at (patch_of j) s')) in *.
  set (C := corner (tiles i)) in *. set (D := corner (tiles j)) in *.
  destruct rank_eq as [R|R]; rewrite R in *.
  - specialize (Z12 eq_refl). destruct (N eq_refl) as [NN N0]. clear N R2i R2j.
    unfold length2 in *. set (u := along 1 (patch_of i) s) in *. set (v := along 1 (patch_of j) s') in *.
    assert (Fu : finish 1 (patch_of i) s = add A u) by (unfold u, along, A; apply point_eq; unf; ring).
    assert (Fv : finish 1 (patch_of j) s' = add B v) by (unfold v, along, B; apply point_eq; unf; ring).
    assert (U0 : px u = 0) by (unfold u, along, finish; unf; ring). assert (V0 : px v = 0) by (unfold v, along, finish; unf; ring).
    rewrite Fu in B2. rewrite Fv in B1, K. clearbody u v A B C D.
    cbn [in_fibre] in *. destruct Fi as [Pi1 Pi2], Fj as [Pj1 Pj2].
    destruct B1 as [f [[F1 F2] B1]]. destruct B2 as [g [[G1 G2] B2]].
    destruct HGi as [I1 [I2 [I3 [I4 [I5 I6]]]]]. destruct HGj as [J1 [J2 [J3 [J4 [J5 J6]]]]].
    set (N := g22 G * (py u * py u) + g33 G * (pz u * pz u) + g23 G * (py u * pz u + pz u * py u)) in *.
    set (U := add (scale (py u) a2) (scale (pz u) a3)). set (U' := add (scale (py v) b2) (scale (pz v) b3)).
    set (V := add (scale (- (g23 G * py u + g33 G * pz u)) a2) (scale (g22 G * py u + g23 G * pz u) a3)).
    set (V' := add (scale (- (g23 G * py v + g33 G * pz v)) b2) (scale (g22 G * py v + g23 G * pz v) b3)).
    assert (LL : 0 < dot l1 l1).
    { destruct (Req_dec (dot l1 l1) 0) as [Z|Z].
      - exfalso. unfold dot in Z. pose proof (Rle_0_sqr (px l1)); pose proof (Rle_0_sqr (py l1)); pose proof (Rle_0_sqr (pz l1)); unfold Rsqr in *.
        assert (X : px l1 = 0) by nra. assert (Y : py l1 = 0) by nra. assert (W : pz l1 = 0) by nra.
        revert right_handed. unfold det. rewrite X, Y, W. lra.
      - unfold dot in *. pose proof (Rle_0_sqr (px l1)); pose proof (Rle_0_sqr (py l1)); pose proof (Rle_0_sqr (pz l1)); unfold Rsqr in *. lra. }
    assert (DL : forall c x y z w, dot l1 (add (scale x y) (scale z w)) = x * dot l1 y + z * dot l1 w + c * 0) by (intros; unfold dot; unf; ring).
    assert (UU : add U U' = scale (px g - px f) l1).
    { unfold U, U', at_coordinates in *. apply point_eq; [apply (f_equal px) in B1; apply (f_equal px) in B2|apply (f_equal py) in B1; apply (f_equal py) in B2|apply (f_equal pz) in B1; apply (f_equal pz) in B2];
      unf; rewrite ?F1, ?F2, ?G1, ?G2, ?U0, ?V0 in *; lra. }
    assert (CU : px g - px f = 0).
    { assert (X : dot l1 (add U U') = 0). { unfold U, U'. assert (S : forall x y z, dot x (add y z) = dot x y + dot x z) by (intros; unfold dot; unf; ring). rewrite S, !(DL 0), I4, I5, J4, J5, Z12, Z13. ring. }
      rewrite UU in X. assert (Y : dot l1 (scale (px g - px f) l1) = (px g - px f) * dot l1 l1) by (unfold dot; unf; ring). rewrite Y in X. nra. }
    rewrite CU in UU. clear B1 B2 CU F1 F2 G1 G2 f g.
    assert (UE : U' = scale (-1) U).
    { clear - UU. clearbody U U'. apply point_eq; [apply (f_equal px) in UU|apply (f_equal py) in UU|apply (f_equal pz) in UU]; unf; lra. }
    assert (DS : forall x y z, dot x (add y z) = dot x y + dot x z) by (intros; unfold dot; unf; ring).
    assert (DUV : dot U V = 0).
    { transitivity (- (g23 G * py u + g33 G * pz u) * (py u * dot a2 a2 + pz u * dot a2 a3) + (g22 G * py u + g23 G * pz u) * (py u * dot a2 a3 + pz u * dot a3 a3)).
      - unfold U, V, dot. unf. ring. - rewrite I2, I3, I6. ring. }
    assert (DUV' : dot U' V' = 0).
    { transitivity (- (g23 G * py v + g33 G * pz v) * (py v * dot b2 b2 + pz v * dot b2 b3) + (g22 G * py v + g23 G * pz v) * (py v * dot b2 b3 + pz v * dot b3 b3)).
      - unfold U', V', dot. unf. ring. - rewrite J2, J3, J6. ring. }
    assert (DU : dot U U = N).
    { transitivity (py u * py u * dot a2 a2 + pz u * pz u * dot a3 a3 + dot a2 a3 * (py u * pz u + pz u * py u)).
      - unfold U, dot. unf. ring. - rewrite I2, I3, I6. unfold N. ring. }
    assert (W : add V V' = origin).
    { apply (flat_zero l1 U).
      - rewrite DS. unfold V, V'. rewrite !(DL 0), I4, I5, J4, J5, Z12, Z13. ring.
      - rewrite DS, DUV. assert (X : dot U V' = - dot U' V') by (rewrite UE; unfold dot; unf; ring). rewrite X, DUV'. ring.
      - assert (X : det l1 U (add V V') = det l1 U V + det l1 U V') by (unf; ring). rewrite X.
        assert (Y : det l1 U V' = - det l1 U' V') by (rewrite UE; unf; ring). rewrite Y.
        assert (X1 : det l1 U V = N * det l1 a2 a3) by (unfold U, V, N; unf; ring).
        assert (X2 : det l1 U' V' = (g22 G * (py v * py v) + g33 G * (pz v * pz v) + g23 G * (py v * pz v + pz v * py v)) * det l1 b2 b3) by (unfold U', V'; unf; ring).
        rewrite X1, X2, <- NN, Di, Dj. ring.
      - assert (X : dot l1 U = 0) by (unfold U; rewrite (DL 0), I4, I5, Z12, Z13; ring). rewrite X, DU.
        assert (0 < dot l1 l1 * N \/ dot l1 l1 * N < 0); [|lra]. destruct (Rdichotomy _ _ N0); [right|left]; nra. }
    assert (VE : V' = scale (-1) V).
    { clear - W. clearbody V V'. apply point_eq; [apply (f_equal px) in W|apply (f_equal py) in W|apply (f_equal pz) in W]; unf; unfold origin in W; cbn in W; lra. }
    set (b := sub x B). set (X := g22 G * (py b * py v) + g33 G * (pz b * pz v) + g23 G * (py b * pz v + pz b * py v)). set (Y := py v * pz b - pz v * py b).
    assert (BE : add (scale (py b) b2) (scale (pz b) b3) = scale (/ N) (add (scale X U') (scale Y V'))).
    { assert (E2 : N * py b = X * py v + Y * (- (g23 G * py v + g33 G * pz v))) by (rewrite NN; unfold X, Y; ring).
      assert (E3 : N * pz b = X * pz v + Y * (g22 G * py v + g23 G * pz v)) by (rewrite NN; unfold X, Y; ring).
      assert (E2' : py b = / N * (X * py v + Y * (- (g23 G * py v + g33 G * pz v)))) by (rewrite <- E2; field; exact N0).
      assert (E3' : pz b = / N * (X * pz v + Y * (g22 G * py v + g23 G * pz v))) by (rewrite <- E3; field; exact N0).
      clearbody X Y. clear E2 E3. rewrite E2', E3' at 1. unfold U', V'. apply point_eq; unf; ring. }
    assert (XB : x = add B b) by (unfold b; apply point_eq; unf; ring).
    clearbody X Y b N. subst x.
    assert (K' : sub (add C (at_coordinates l1 a2 a3 (add A P))) (add (add D (at_coordinates l1 b2 b3 (add (add B v) Q))) T) = origin).
    { rewrite K. apply point_eq; unf; unfold origin; cbn; ring. }
    assert (UE' : add (add (scale (py v) b2) (scale (pz v) b3)) U = origin) by (fold U'; rewrite UE; apply point_eq; unf; unfold origin; cbn; ring).
    assert (VE' : add V' V = origin) by (rewrite VE; apply point_eq; unf; unfold origin; cbn; ring).
    rewrite UE, VE in BE. unfold U, V, at_coordinates in *.
    apply point_eq; [apply (f_equal px) in K'; apply (f_equal px) in UE'; apply (f_equal px) in BE|apply (f_equal py) in K'; apply (f_equal py) in UE'; apply (f_equal py) in BE|apply (f_equal pz) in K'; apply (f_equal pz) in UE'; apply (f_equal pz) in BE];
    clear - K' UE' BE N0 Pi1 Pi2 Pj1 Pj2 U0 V0; unf; unfold origin in *; cbn in *; rewrite ?Pi1, ?Pi2, ?Pj1, ?Pj2, ?V0 in *;
    match goal with |- ?l = ?rr => match type of BE with ?bl = ?br => match type of UE' with ?ul = _ => match type of K' with ?kl = _ =>
      assert (FIN : l - rr = (bl - br) - ul - kl) by (field; exact N0); rewrite BE, UE', K' in FIN; lra end end end end.
  - destruct (R2i eq_refl) as [-> ->], (R2j eq_refl) as [-> ->]. unfold finish in K. fold B in K.
    apply point_eq; [apply (f_equal px) in K|apply (f_equal py) in K|apply (f_equal pz) in K]; unfold at_coordinates in *; unf; lra.
Qed.

Variable rise : nat -> point.
Hypothesis high : heights l1 l2 l3 r system tiles rise.
Notation spot i x := (spot tiles rise i x).
Definition at_ i n x := spot i (lift n x).
Lemma at_period i n x : latb r n = true -> at_ i n x = add (spot i x) (period n).
Proof.
  intros L. unfold at_, MosaicStatement.spot. rewrite <- place_period by (apply latb_iff, L). f_equal. unfold lift. apply point_eq; unf; ring.
Qed.
Lemma at_lift i n m x : at_ i n (lift m x) = at_ i (zadd3 n m) x.
Proof. unfold at_. rewrite lift_lift. reflexivity. Qed.
Lemma spot_affine i n t a b c d : a + b + c + d = 1 -> combination (map_tet (at_ i n) t) a b c d = at_ i n (combination t a b c d).
Proof.
  intros S. unfold at_, MosaicStatement.spot. change (map_tet _ t) with (map_tet (fun x => place i x) (map_tet (fun x => add (lift n x) (rise i)) t)).
  rewrite place_affine by auto. f_equal. unfold combination, map_tet, lift; cbn [va vb vc vd]. replace d with (1 - a - b - c) by lra. apply point_eq; unf; ring.
Qed.
Lemma at_orient i n a b c d : orient (at_ i n a) (at_ i n b) (at_ i n c) (at_ i n d) = det l1 l2 l3 * orient a b c d.
Proof.
  unfold at_, MosaicStatement.spot. rewrite place_orient. f_equal. unfold lift. unf. ring.
Qed.
Lemma at_coord i n t k x : coord (map_tet (at_ i n) t) k (at_ i n x) = det l1 l2 l3 * coord t k x.
Proof. unfold coord, side. rewrite facet_map. cbn [map_tri t1 t2 t3]. apply at_orient. Qed.
Lemma at_vol i n t : vol (map_tet (at_ i n) t) = det l1 l2 l3 * vol t.
Proof. exact (at_orient i n (va t) (vb t) (vc t) (vd t)). Qed.
Lemma at_closed i n t x : closed (map_tet (at_ i n) t) (at_ i n x) <-> closed t x.
Proof.
  split; intros C k Hk; specialize (C k Hk).
  - rewrite at_coord in C. nra.
  - rewrite at_coord. apply Rmult_le_pos; lra.
Qed.
Lemma at_inj i n x y : at_ i n x = at_ i n y -> x = y.
Proof.
  unfold at_, MosaicStatement.spot. intros E. apply place_inj in E. unfold lift in E.
  apply point_eq; [apply (f_equal px) in E|apply (f_equal py) in E|apply (f_equal pz) in E]; unf; lra.
Qed.


(** For each side of a tile the one that it meets, and the difference of their heights in periods. *)
Definition across_side i s : nat * nat := proj1_sig (choose_pair (fun js => meets i s (fst js) (snd js))).
Lemma across_meets i s j s' : (s < sides (patch_of i))%nat -> across_side i s = (j, s') -> meets i s j s'.
Proof.
  intros Hs E. unfold across_side in E. destruct (choose_pair _) as [js M]; cbn [proj1_sig] in E. subst js. apply M.
  destruct (mosaic_edge_to_edge _ _ _ _ _ _ _ tiling i s Hs) as [j' [s'' K]]. exists (j', s''). exact K.
Qed.
Lemma meets_across i s j s' : meets i s j s' -> across_side i s = (j, s').
Proof.
  intros M. pose proof M as [Hs _]. destruct (across_side i s) as [j2 s2] eqn:E. apply across_meets in E; [|exact Hs].
  destruct (meets_once _ _ _ _ _ _ M E) as [-> ->]. reflexivity.
Qed.
Lemma across_spec i s j s' : (s < sides (patch_of i))%nat -> across_side i s = (j, s') ->
  (s' < sides (patch_of j))%nat /\ j <> i /\ across_side j s' = (i, s) /\ fits G r (patch_of i) s (patch_of j) s'.
Proof.
  intros Hs E. apply across_meets in E; auto. pose proof E as [_ [Hs' [N _]]]. repeat split; auto; try apply (meets_fits _ _ _ _ E); auto.
  apply meets_across, meets_sym, E.
Qed.
Definition step i s : Z3 := let '(j, s') := across_side i s in
  proj1_sig (choose3 (fun n => in_lattice r n /\ spot i (start (edge_at (patch_of i) s)) = add (spot j (finish r (patch_of j) s')) (period n))).
Lemma step_spec i s j s' : (s < sides (patch_of i))%nat -> across_side i s = (j, s') -> latb r (step i s) = true /\
  forall n x, latb r n = true -> at_ j (zadd3 n (step i s)) x = at_ i n (carry (patch_of i) s (patch_of j) s' x).
Proof.
  intros Hs E. pose proof (across_meets _ _ _ _ Hs E) as M. unfold step. rewrite E.
  destruct (choose3 _) as [n K]; cbn [proj1_sig]. destruct (K (heights_agree _ _ _ _ _ _ _ high _ _ _ _ M)) as [L S]. clear K.
  apply latb_iff in L as L'. split; [exact L'|]. intros m x Hm. rewrite !at_period by auto using latb_add.
  unfold MosaicStatement.spot in *. rewrite <- (frame_meets i s j s' (rise i) (rise j) (period n) x M (heights_in_fibre _ _ _ _ _ _ _ high i) (heights_in_fibre _ _ _ _ _ _ _ high j) S), period_add.
  apply point_eq; unf; ring.
Qed.
Lemma step_opp i s j s' : (s < sides (patch_of i))%nat -> across_side i s = (j, s') -> step j s' = zopp3 (step i s).
Proof.
  intros Hs E. destruct (across_spec i s j s' Hs E) as [Hs' [_ [E' _]]].
  destruct (step_spec i s j s' Hs E) as [L F]. destruct (step_spec j s' i s Hs' E') as [L' F'].
  destruct (across_spec i s j s' Hs E) as [_ [_ [_ FT]]]. set (c := carry (patch_of i) s (patch_of j) s' origin).
  assert (K : at_ j (zadd3 (zadd3 z30 (step j s')) (step i s)) origin = at_ j z30 origin).
  { rewrite F by auto using latb_add, latb_zero. rewrite F' by apply latb_zero. f_equal. apply carry_carry; [exact rank_eq|exact FT]. }
  rewrite !at_period in K by auto using latb_add, latb_zero.
  assert (Z : period (zadd3 (zadd3 z30 (step j s')) (step i s)) = period z30).
  { apply point_eq; [apply (f_equal px) in K|apply (f_equal py) in K|apply (f_equal pz) in K]; unf; lra. }
  apply period_inj in Z. clear - Z. destruct (step i s) as [[? ?] ?], (step j s') as [[? ?] ?]. unfold zadd3, z30, zopp3 in *. injection Z as A B C. apply z3_eq; lia.
Qed.

(** ** Cells *)
Inductive part := Piece (k : nat) | Join (q e : nat).
Definition cell := (nat * part * Z3)%type.
Definition cell_eq_dec (a b : cell) : {a = b} + {a <> b}.
Proof. repeat decide equality. Defined.
Notation wall i q := (side_of h (kind i) q).
Definition valid (c : cell) : Prop := let '(i, p, n) := c in latb r n = true /\ match p with
  | Piece k => (k < length (pieces (patch_of i)))%nat
  | Join q e => (q < length (pyramids (patch_of i)))%nat /\ (e < rim_count (patch_of i) q)%nat /\ (i < fst (across_side i (wall i q)))%nat end.
Definition join_at i q e : tetrahedron := let '(j, s') := across_side i (wall i q) in join (kind i) q (kind j) s' e.
Definition piece (c : cell) : tetrahedron := let '(i, p, n) := c in map_tet (at_ i n) (match p with
  | Piece k => piece_at (patch_of i) k
  | Join q e => join_at i q e end).

Definition ok i o := is_occupant (patch_of i) o.
Definition tri i o n : triangle := map_tri (at_ i n) (triangle_of (patch_of i) o).
Definition resolve i (o : occupant) (n : Z3) : cell * nat := match o with
  | Facet k f => ((i, Piece k, n), f)
  | Lateral q e => let s := wall i q in let '(j, s') := across_side i s in
      if (i <? j)%nat then ((i, Join q e, n), 0%nat)
      else let '(q', m) := pyramid_mate h (kind i) q (kind j) s' in
        ((j, Join q' (rim_mate h (kind i) q (kind j) s' e), zadd3 (zadd3 n m) (step i s)), 3%nat) end.
Definition beyond i (o : occupant) (n : Z3) : cell * nat := match behind h (kind i) o with
  | Inner o' m => resolve i o' (zadd3 n m)
  | Wall s w => let '(j, s') := across_side i s in let '(w', m) := wall_mate h (kind i) s (kind j) s' w in
      resolve j (owner h (kind j) s' w') (zadd3 (zadd3 n m) (step i s)) end.
Definition view (cf : cell * nat) : nat * occupant * Z3 := match cf with
  | ((i, Piece k, n), f) => (i, Facet k f, n)
  | ((i, Join q e, n), O) => (i, Lateral q e, n)
  | ((i, Join q e, n), _) => let s := wall i q in let '(j, s') := across_side i s in
      let '(q', m) := pyramid_mate h (kind i) q (kind j) s' in
      (j, Lateral q' (rim_mate h (kind i) q (kind j) s' e), zadd3 (zadd3 n m) (step i s)) end.
Definition across (cf : cell * nat) : cell * nat := match cf with
  | ((i, Join q e, n), 1%nat) => ((i, Join q (next (rim_count (patch_of i) q) e), n), 2%nat)
  | ((i, Join q e, n), 2%nat) => ((i, Join q (prev (rim_count (patch_of i) q) e), n), 1%nat)
  | _ => let '(i, o, n) := view cf in beyond i o n end.

(** A pyramid, and the one on the other side of its wall. *)
Lemma pyramid_facts i q : (q < length (pyramids (patch_of i)))%nat -> good_pyramid (kind i) q.
Proof. intros Hq. apply (good_pyramids OK); auto using kind_lt. Qed.
Lemma mate_facts i q j s' : (q < length (pyramids (patch_of i)))%nat -> across_side i (wall i q) = (j, s') ->
  let '(q', m) := pyramid_mate h (kind i) q (kind j) s' in let s := wall i q in let p := patch_of i in let p' := patch_of j in
  (q' < length (pyramids p'))%nat /\ wall j q' = s' /\ latb r m = true /\ pyramid_mate h (kind j) q' (kind i) s = (q, zopp3 m) /\
  (forall e, (e < rim_count p q)%nat -> let e' := rim_mate h (kind i) q (kind j) s' e in
     (e' < rim_count p' q')%nat /\ rim_mate h (kind j) q' (kind i) s e' = e /\
     rim_at p q e = lift m (carry p s p' s' (rim_at p' q' (next (rim_count p' q') e'))) /\
     rim_at p q (next (rim_count p q) e) = lift m (carry p s p' s' (rim_at p' q' e')) /\ 0 < vol (join (kind i) q (kind j) s' e)) /\
  let l := apex_at p q in let l' := lift m (carry p s p' s' (apex_at p' q')) in
  forall t, (t < sides p)%nat -> 0 <= left_of p s l * left_of p t l' - left_of p s l' * left_of p t l.
Proof.
  intros Hq E. destruct (pyramid_facts i q Hq) as [Hs _]. destruct (across_spec i (wall i q) j s' Hs E) as [Hs' [_ [_ FT]]].
  destruct (good_pairs OK (kind i) (wall i q) (kind j) s') as [K _]; auto using kind_lt. exact (K q Hq eq_refl).
Qed.
Lemma piece_good c : valid c -> exists i n t, latb r n = true /\ piece c = map_tet (at_ i n) t /\ 0 < vol t.
Proof.
  destruct c as [[i [k|q e]] n]; cbn [valid piece]; intros [L V]; (eexists i, n, _; split; [exact L|]; split; [reflexivity|]).
  - apply (good_pieces OK); auto using kind_lt.
  - destruct V as [Hq [He _]]. unfold join_at. destruct (across_side i (wall i q)) as [j s'] eqn:E.
    pose proof (mate_facts i q j s' Hq E) as K. destruct (pyramid_mate h (kind i) q (kind j) s'). apply K, He.
Qed.
Lemma piece_vol c : valid c -> 0 < vol (piece c).
Proof. intros V. destruct (piece_good c V) as [i [n [t [_ [-> P]]]]]. rewrite at_vol. apply Rmult_lt_0_compat; auto. Qed.

(** ** Occupants and facets *)
Lemma resolve_valid i o n : ok i o -> latb r n = true -> valid (fst (resolve i o n)) /\ In (snd (resolve i o n)) I4.
Proof.
  destruct o as [k f|q e]; cbn [resolve]; intros [Hq He] L.
  - cbn [fst snd valid]. repeat split; auto. cbn. lia.
  - destruct (pyramid_facts i q Hq) as [Hs _]. destruct (across_side i (wall i q)) as [j s'] eqn:E.
    destruct (across_spec i _ j s' Hs E) as [Hs' [NE [E' _]]]. pose proof (mate_facts i q j s' Hq E) as M.
    destruct (pyramid_mate h (kind i) q (kind j) s') as [q' m] eqn:PM. destruct M as [Hq' [W [Lm [_ [R _]]]]]. destruct (R e He) as [He' _].
    destruct (step_spec i _ j s' Hs E) as [Ls _].
    destruct (Nat.ltb_spec i j); cbn [fst snd valid].
    + rewrite E. cbn. tauto.
    + rewrite W, E'. cbn [fst]. split; [|cbn; tauto]. split; [auto using latb_add|]. repeat split; auto. lia.
Qed.
Lemma across_resolve i o n : ok i o -> latb r n = true -> across (resolve i o n) = beyond i o n.
Proof.
  destruct o as [k f|q e]; cbn [resolve]; [reflexivity|]. intros [Hq He] L.
  destruct (pyramid_facts i q Hq) as [Hs _]. destruct (across_side i (wall i q)) as [j s'] eqn:E.
  destruct (across_spec i _ j s' Hs E) as [Hs' [NE [E' _]]]. pose proof (mate_facts i q j s' Hq E) as M.
  destruct (pyramid_mate h (kind i) q (kind j) s') as [q' m] eqn:PM. destruct M as [Hq' [W [Lm [PM' [R _]]]]]. destruct (R e He) as [He' [RM _]].
  destruct (Nat.ltb_spec i j); cbn [across view].
  - reflexivity.
  - rewrite W, E', PM', RM, (step_opp i _ j s' Hs E). f_equal. clear. destruct (step i (wall i q)) as [[? ?] ?], m as [[? ?] ?], n as [[? ?] ?]. unfold zadd3, zopp3. apply z3_eq; lia.
Qed.
Lemma map_tri_ext f g t : (forall x, f x = g x) -> map_tri f t = map_tri g t.
Proof. intros E. unfold map_tri. rewrite !E. reflexivity. Qed.
Lemma frame_lift i s j s' n m x : (s < sides (patch_of i))%nat -> across_side i s = (j, s') -> latb r n = true -> latb r m = true ->
  at_ j (zadd3 (zadd3 n m) (step i s)) x = at_ i n (lift m (carry (patch_of i) s (patch_of j) s' x)).
Proof. intros Hs E Ln Lm. rewrite at_lift. apply (step_spec i s j s' Hs E). apply latb_add; auto. Qed.
Lemma frame_back i s j s' n m x : (s < sides (patch_of i))%nat -> across_side i s = (j, s') -> latb r n = true -> latb r m = true ->
  at_ j (zadd3 (zadd3 n m) (step i s)) (lift (zopp3 m) (carry (patch_of j) s' (patch_of i) s x)) = at_ i n x.
Proof.
  intros Hs E Ln Lm. destruct (across_spec i s j s' Hs E) as [Hs' [NE [E' _]]]. destruct (step_spec i s j s' Hs E) as [Ls _].
  rewrite at_lift. replace (zadd3 (zadd3 (zadd3 n m) (step i s)) (zopp3 m)) with (zadd3 n (step i s)) by (clear; destruct (step i s) as [[? ?] ?], m as [[? ?] ?], n as [[? ?] ?]; unfold zadd3, zopp3; apply z3_eq; lia).
  rewrite <- (proj2 (step_spec j s' i s Hs' E')) by auto using latb_add. rewrite (step_opp i s j s' Hs E).
  replace (zadd3 (zadd3 n (step i s)) (zopp3 (step i s))) with n by (clear; destruct (step i s) as [[? ?] ?], n as [[? ?] ?]; unfold zadd3, zopp3; apply z3_eq; lia). reflexivity.
Qed.
Lemma resolve_facet i o n : ok i o -> latb r n = true -> turns (facet (piece (fst (resolve i o n))) (snd (resolve i o n))) (tri i o n).
Proof.
  destruct o as [k f|q e]; cbn [resolve].
  - intros _ _. left. cbn [fst snd piece]. rewrite facet_map. reflexivity.
  - intros [Hq He] L. destruct (pyramid_facts i q Hq) as [Hs _]. destruct (across_side i (wall i q)) as [j s'] eqn:E.
    destruct (across_spec i _ j s' Hs E) as [Hs' [NE [E' _]]]. pose proof (mate_facts i q j s' Hq E) as M.
    destruct (pyramid_mate h (kind i) q (kind j) s') as [q' m] eqn:PM. destruct M as [Hq' [W [Lm [PM' [R _]]]]]. destruct (R e He) as [He' [RM [R3 [R4 _]]]].
    unfold tri. cbn [triangle_of map_tri]. destruct (Nat.ltb_spec i j); cbn [fst snd piece]; unfold join_at.
    + rewrite E. unfold join. rewrite PM. left. reflexivity.
    + rewrite W, E'. unfold join. rewrite PM', W. right; left. cbn [map_tet facet va vb vc vd t1 t2 t3].
      change (nth (kind j) system (Patch [] [] [])) with (patch_of j) in *. change (nth (kind i) system (Patch [] [] [])) with (patch_of i) in *.
      destruct (step_spec i _ j s' Hs E) as [Ls _].
      assert (Ea : at_ j (zadd3 (zadd3 n m) (step i (wall i q))) (lift (zopp3 m) (carry (patch_of j) s' (patch_of i) (wall i q) (apex_at (patch_of i) q))) = at_ i n (apex_at (patch_of i) q)).
      { apply frame_back; auto. }
      rewrite Ea, !(frame_lift i _ j s' n m) by auto. rewrite <- R4, <- R3. reflexivity.
Qed.

(** Behind an occupant there is another one, with the opposite triangle. *)
Lemma beyond_spec i o n : ok i o -> latb r n = true -> exists i' o' n', ok i' o' /\ latb r n' = true /\ beyond i o n = resolve i' o' n' /\
  beyond i' o' n' = resolve i o n /\ opposite (tri i o n) (tri i' o' n').
Proof.
  intros K L. pose proof (good_occupants OK (kind i) o (kind_lt i) K) as C.
  unfold beyond at 1. unfold good_occupant in C. cbv zeta in C. destruct (behind h (kind i) o) as [o' m|s w] eqn:B.
  - destruct C as [C1 [Lm [C2 C3]]].
    exists i, o', (zadd3 n m). split; [exact C1|]. split; [auto using latb_add|]. split; auto. split.
    + unfold beyond. rewrite C2. f_equal. clear. destruct n as [[? ?] ?], m as [[? ?] ?]. unfold zadd3, zopp3. apply z3_eq; lia.
    + apply (opposite_map (at_ i n)) in C3. unfold tri. change (nth (kind i) system (Patch [] [] [])) with (patch_of i) in C3.
      replace (map_tri (at_ i (zadd3 n m)) (triangle_of (patch_of i) o')) with (map_tri (at_ i n) (map_tri (lift m) (triangle_of (patch_of i) o'))); [exact C3|].
      unfold map_tri; cbn [t1 t2 t3]. rewrite !at_lift. reflexivity.
  - destruct C as [Hs [Hw C]]. subst o.
    destruct (across_side i s) as [j s'] eqn:E. destruct (across_spec i s j s' Hs E) as [Hs' [NE [E' FT]]].
    destruct (good_pairs OK (kind i) s (kind j) s' (kind_lt i) (kind_lt j) Hs Hs' FT) as [_ P]. specialize (P w Hw).
    destruct (wall_mate h (kind i) s (kind j) s' w) as [w' m] eqn:WM. destruct P as [P1 [Lm [P2 P3]]].
    destruct (good_walls OK (kind j) s' w' (kind_lt j) Hs' P1) as [W1 W3]. destruct (step_spec i s j s' Hs E) as [Ls _].
    exists j, (owner h (kind j) s' w'), (zadd3 (zadd3 n m) (step i s)). split; [exact W1|]. split; [auto using latb_add|]. split; auto. split.
    + unfold beyond. rewrite W3, E', P2, (step_opp i s j s' Hs E). f_equal. clear. destruct (step i s) as [[? ?] ?], m as [[? ?] ?], n as [[? ?] ?]. unfold zadd3, zopp3. apply z3_eq; lia.
    + apply (opposite_map (at_ i n)) in P3. unfold tri. change (nth (kind i) system (Patch [] [] [])) with (patch_of i) in P3. change (nth (kind j) system (Patch [] [] [])) with (patch_of j) in P3.
      replace (map_tri (at_ j (zadd3 (zadd3 n m) (step i s))) (triangle_of (patch_of j) (owner h (kind j) s' w'))) with
        (map_tri (at_ i n) (map_tri (fun x => lift m (carry (patch_of i) s (patch_of j) s' x)) (triangle_of (patch_of j) (owner h (kind j) s' w')))); [exact P3|].
      unfold map_tri; cbn [t1 t2 t3]. rewrite !(frame_lift i s j s' n m) by auto. reflexivity.
Qed.

(** The facets that contain no axis of a join are those of occupants. *)
Definition axial (cf : cell * nat) : Prop := match cf with ((_, Join _ _, _), 1%nat) | ((_, Join _ _, _), 2%nat) => True | _ => False end.
Lemma view_spec c f : valid c -> In f I4 -> ~ axial (c, f) -> exists i o n, ok i o /\ latb r n = true /\ resolve i o n = (c, f).
Proof.
  intros V F A. destruct c as [[i [k|q e]] n]; cbn [valid] in V; destruct V as [L V].
  - exists i, (Facet k f), n. split; [|split; [exact L|reflexivity]]. split; auto. cbn in F. lia.
  - destruct V as [Hq [He I]]. destruct (pyramid_facts i q Hq) as [Hs _]. destruct (across_side i (wall i q)) as [j s'] eqn:E. cbn [fst] in I.
    destruct (across_spec i _ j s' Hs E) as [Hs' [NE [E' _]]]. pose proof (mate_facts i q j s' Hq E) as M.
    destruct (pyramid_mate h (kind i) q (kind j) s') as [q' m] eqn:PM. destruct M as [Hq' [W [Lm [PM' [R _]]]]]. destruct (R e He) as [He' [RM _]].
    destruct (step_spec i _ j s' Hs E) as [Ls _].
    cbn in F. destruct F as [<-|[<-|[<-|[<-|[]]]]]; cbn in A; try tauto.
    + exists i, (Lateral q e), n. split; [split; auto|]. split; [exact L|]. cbn [resolve]. rewrite E. apply Nat.ltb_lt in I. rewrite I. reflexivity.
    + exists j, (Lateral q' (rim_mate h (kind i) q (kind j) s' e)), (zadd3 (zadd3 n m) (step i (wall i q))). split; [split; auto|]. split; [auto using latb_add|].
      cbn [resolve]. rewrite W, E'. destruct (Nat.ltb_spec j i); [lia|]. rewrite PM', RM, (step_opp i _ j s' Hs E). do 2 f_equal.
      clear. destruct (step i (wall i q)) as [[? ?] ?], m as [[? ?] ?], n as [[? ?] ?]. unfold zadd3, zopp3. apply z3_eq; lia.
Qed.

Theorem mates c f : valid c -> In f I4 ->
  valid (fst (across (c, f))) /\ In (snd (across (c, f))) I4 /\ across (across (c, f)) = (c, f) /\
  opposite (facet (piece c) f) (facet (piece (fst (across (c, f)))) (snd (across (c, f)))).
Proof.
  intros V F. assert (D : axial (c, f) \/ ~ axial (c, f)).
  { destruct c as [[i [k|s e]] n], f as [|[|[|f]]]; cbn; auto. }
  destruct D as [A|A].
  - destruct c as [[i [k|q e]] n]; [cbn in A; tauto|]. cbn [valid] in V. destruct V as [L [Hq [He I]]].
    destruct f as [|[|[|f]]]; cbn in A; try tauto; cbn [across fst snd valid piece]; unfold join_at; destruct (across_side i (wall i q)) as [j s'] eqn:E; cbn [fst] in *;
    unfold join; destruct (pyramid_mate h (kind i) q (kind j) s') as [q' m].
    + rewrite prev_next by auto. repeat split; auto using next_lt; [cbn; tauto|]. right; left. cbn. auto.
    + rewrite next_prev by auto. repeat split; auto using prev_lt; [cbn; tauto|]. right; left. cbn.
      change (nth (kind i) system (Patch [] [] [])) with (patch_of i). rewrite next_prev by auto. auto.
  - destruct (view_spec c f V F A) as [i [o [n [K [L R]]]]]. destruct (beyond_spec i o n K L) as [i' [o' [n' [K' [L' [B [B' O]]]]]]].
    rewrite <- R. rewrite (across_resolve i o n K L), B. destruct (resolve_valid i' o' n' K' L') as [V' F'].
    split; auto. split; auto. split.
    + rewrite (across_resolve i' o' n' K' L'). exact B'.
    + pose proof (resolve_facet i o n K L) as T. pose proof (resolve_facet i' o' n' K' L') as T'. rewrite R in T. cbn [fst snd] in T.
      apply turns_opposite with (f' := tri i o n) (g' := tri i' o' n'); auto.
Qed.

(** ** Each cell is over its tiles *)
Lemma closed_at i n t y : 0 < vol t -> closed (map_tet (at_ i n) t) y -> exists a b c d, 0 <= a /\ 0 <= b /\ 0 <= c /\ 0 <= d /\ a + b + c + d = 1 /\
  y = at_ i n (combination t a b c d).
Proof.
  intros V C. apply hull_closed in C; [|rewrite at_vol; apply Rmult_lt_0_compat; auto].
  destruct C as [a [b [c [d [A [B [C [D [S ->]]]]]]]]]. exists a, b, c, d. repeat split; auto. apply spot_affine, S.
Qed.
Lemma over_at i n x : latb r n = true -> in_prism (patch_of i) x -> over r system tiles i (at_ i n x).
Proof.
  intros L P. exists (add (lift n x) (rise i)). split; [reflexivity|]. intros s Hs.
  rewrite (left_fibre r rank_eq) by apply high. rewrite (left_lift r rank_eq) by auto. apply P, Hs.
Qed.
Lemma in_prism_combination p t a b c d : 0 <= a -> 0 <= b -> 0 <= c -> 0 <= d -> a + b + c + d = 1 ->
  (forall v, In v (verts t) -> in_prism p v) -> in_prism p (combination t a b c d).
Proof.
  intros A B C D S P s Hs. rewrite (left_affine r rank_eq) by auto.
  repeat apply Rplus_le_le_0_compat; apply Rmult_le_pos; auto; apply P; auto; cbn; auto.
Qed.
Lemma piece_over i k n y : valid (i, Piece k, n) -> closed (piece (i, Piece k, n)) y -> over r system tiles i y.
Proof.
  intros [L V] C. destruct (good_pieces OK (kind i) k (kind_lt i) V) as [PV P]. cbn [piece] in C.
  apply closed_at in C as [a [b [c [d [A [B [C [D [S ->]]]]]]]]]; auto. apply over_at; auto. apply in_prism_combination; auto.
Qed.
Lemma half_arithmetic a b c d Sm Sl Gm Gh Gk Gl : 0 <= a -> 0 <= b -> 0 <= c -> 0 <= d -> 0 < Sl ->
  0 <= a * Sm + d * Sl -> 0 <= Sl * Gm - Sm * Gl -> 0 <= Gh -> 0 <= Gk -> 0 <= Gl -> 0 <= a * Gm + b * Gh + c * Gk + d * Gl.
Proof.
  intros A B C D SL SY X GH GK GL.
  assert (0 <= b * Gh) by (apply Rmult_le_pos; auto). assert (0 <= c * Gk) by (apply Rmult_le_pos; auto).
  cut (0 <= a * Gm + d * Gl); [lra|]. apply Rmult_le_reg_l with Sl; auto. rewrite Rmult_0_r.
  replace (Sl * (a * Gm + d * Gl)) with (a * (Sl * Gm - Sm * Gl) + (a * Sm + d * Sl) * Gl) by ring.
  apply Rplus_le_le_0_compat; apply Rmult_le_pos; auto.
Qed.
(** The part of a join on the inner side of its wall is in the prism there. *)
Lemma half_join i q j s' q' m e1 e2 a b c d : (q < length (pyramids (patch_of i)))%nat -> across_side i (wall i q) = (j, s') ->
  pyramid_mate h (kind i) q (kind j) s' = (q', m) -> (e1 < rim_count (patch_of i) q)%nat -> (e2 < rim_count (patch_of i) q)%nat ->
  0 <= a -> 0 <= b -> 0 <= c -> 0 <= d -> a + b + c + d = 1 ->
  let p := patch_of i in let s := wall i q in
  let t := Tetrahedron (lift m (carry p s (patch_of j) s' (apex_at (patch_of j) q'))) (rim_at p q e1) (rim_at p q e2) (apex_at p q) in
  0 <= left_of p s (combination t a b c d) -> in_prism p (combination t a b c d).
Proof.
  intros Hq E PM He1 He2 A B C D S p s t HL u Hu. destruct (pyramid_facts i q Hq) as [Hs [_ [Pa [La [Pr _]]]]].
  pose proof (mate_facts i q j s' Hq E) as M. rewrite PM in M. destruct M as [_ [_ [_ [_ [_ AX]]]]]. specialize (AX u Hu). cbv zeta in AX.
  destruct (Pr e1 He1) as [I1 Z1]. destruct (Pr e2 He2) as [I2 Z2].
  rewrite (left_affine r rank_eq) in HL |- * by auto. unfold t in *. clear t. cbn [va vb vc vd] in *. fold p s in AX, Z1, Z2, La.
  change (nth (kind i) system (Patch [] [] [])) with p in *. rewrite Z1, Z2 in HL.
  apply half_arithmetic with (Sm := left_of p s (lift m (carry p s (patch_of j) s' (apex_at (patch_of j) q')))) (Sl := left_of p s (apex_at p q)); auto.
  lra.
Qed.
Lemma join_over i q e n y : valid (i, Join q e, n) -> closed (piece (i, Join q e, n)) y -> over r system tiles i y \/ over r system tiles (fst (across_side i (wall i q))) y.
Proof.
  intros [L [Hq [He I]]] C. destruct (pyramid_facts i q Hq) as [Hs _]. cbn [piece] in C. unfold join_at in C.
  destruct (across_side i (wall i q)) as [j s'] eqn:E. cbn [fst] in *.
  destruct (across_spec i _ j s' Hs E) as [Hs' [NE [E' FT]]]. pose proof (mate_facts i q j s' Hq E) as M.
  destruct (pyramid_mate h (kind i) q (kind j) s') as [q' m] eqn:PM. destruct M as [Hq' [W [Lm [PM' [R _]]]]]. destruct (R e He) as [He' [RM [R3 [R4 JV]]]].
  apply closed_at in C as [a [b [c [d [A [B [C [D [S ->]]]]]]]]]; auto. unfold join in *. rewrite PM in *.
  change (nth (kind j) system (Patch [] [] [])) with (patch_of j) in *. change (nth (kind i) system (Patch [] [] [])) with (patch_of i) in *.
  set (p := patch_of i) in *. set (p' := patch_of j) in *. set (s := wall i q) in *.
  set (t := Tetrahedron (lift m (carry p s p' s' (apex_at p' q'))) (rim_at p q e) (rim_at p q (next (rim_count p q) e)) (apex_at p q)) in *.
  destruct (Rle_dec 0 (left_of p s (combination t a b c d))) as [X|X].
  - left. apply over_at; auto. apply (half_join i q j s' q' m e (next (rim_count p q) e)); auto using next_lt.
  - right. set (e' := rim_mate h (kind i) q (kind j) s' e) in *.
    set (t' := Tetrahedron (lift (zopp3 m) (carry p' s' p s (apex_at p q))) (rim_at p' q' e') (rim_at p' q' (next (rim_count p' q') e')) (apex_at p' q')).
    destruct (step_spec i s j s' Hs E) as [Ls _]. set (n' := zadd3 (zadd3 n m) (step i s)).
    assert (F1 : forall x, at_ j n' x = at_ i n (lift m (carry p s p' s' x))) by (intros x; apply frame_lift; auto).
    assert (V4 : at_ j n' (lift (zopp3 m) (carry p' s' p s (apex_at p q))) = at_ i n (apex_at p q)).
    { apply frame_back; auto. }
    assert (TE : at_ i n (combination t a b c d) = at_ j n' (combination t' d c b a)).
    { rewrite <- (spot_affine i n t) by auto. rewrite <- (spot_affine j n' t') by lra. unfold map_tet, t, t', combination; cbn [va vb vc vd].
      rewrite V4, R3, R4, !F1. apply point_eq; unf; ring. }
    assert (LE : left_of p' s' (combination t' d c b a) = - left_of p s (combination t a b c d)).
    { rewrite !(left_affine r rank_eq) by lra. unfold t, t'; cbn [va vb vc vd]. rewrite R3, R4, !(left_lift r rank_eq) by auto using latb_opp.
      pose proof (side_small i s Hs) as S1. pose proof (side_small j s' Hs') as S2.
      rewrite !(left_carry G r rank_eq p s p' s') by auto.
      rewrite (carry_carry G r rank_eq p' s' p s) by (apply fits_sym, FT). ring. }
    rewrite TE. apply over_at; [unfold n'; auto using latb_add|]. rewrite <- W in E'.
    pose proof (half_join j q' i s q (zopp3 m) e' (next (rim_count p' q') e') d c b a Hq') as HJ. rewrite W in HJ. cbv zeta in HJ. rewrite W in E'. apply HJ; auto using next_lt; [lra|].
    fold p p' s t'. rewrite LE. lra.
Qed.

(** ** Finitely many cells meet a bounded set *)
Lemma translate_piece i p n : latb r n = true -> piece (i, p, n) = translate (period n) (piece (i, p, z30)).
Proof. intros L. cbn [piece]. unfold translate, map_tet; cbn [va vb vc vd]. rewrite !(at_period i n), !(at_period i z30) by auto using latb_zero.
  assert (Z : period z30 = origin) by (unfold MosaicStatement.period, lattice_vector, z30, at_coordinates, origin; apply point_eq; unf; ring).
  rewrite Z. f_equal; apply point_eq; unf; unfold origin; cbn; ring. Qed.
Definition spread (t : tetrahedron) (f : point -> R) : R := Rabs (f (va t)) + Rabs (f (vb t)) + Rabs (f (vc t)) + Rabs (f (vd t)).
Lemma spread_ok t f y : affine f -> hull t y -> Rabs (f y) <= spread t f.
Proof.
  intros [k1 [k2 [k3 [k0 F]]]] [a [b [c [d [A [B [C [D [S ->]]]]]]]]].
  assert (E : f (combination t a b c d) = a * f (va t) + b * f (vb t) + (c * f (vc t) + d * f (vd t))).
  { rewrite !F. unfold combination. unf. replace d with (1 - a - b - c) by lra. ring. }
  rewrite E. unfold spread.
  assert (P : forall w x, 0 <= w <= 1 -> Rabs (w * x) <= Rabs x).
  { intros w x W. rewrite Rabs_mult, (Rabs_right w) by lra. pose proof (Rabs_pos x). nra. }
  pose proof (P a (f (va t)) ltac:(lra)); pose proof (P b (f (vb t)) ltac:(lra)); pose proof (P c (f (vc t)) ltac:(lra)); pose proof (P d (f (vd t)) ltac:(lra)).
  pose proof (Rabs_triang (a * f (va t) + b * f (vb t)) (c * f (vc t) + d * f (vd t))).
  pose proof (Rabs_triang (a * f (va t)) (b * f (vb t))). pose proof (Rabs_triang (c * f (vc t)) (d * f (vd t))). lra.
Qed.
Definition box (K : nat) : list Z3 := list_prod (list_prod (zr K) (zr K)) (zr K).
Lemma periods_bound M i p : exists B, forall n y, valid (i, p, n) -> near M origin y -> closed (piece (i, p, n)) y -> In n (box B).
Proof.
  assert (D0 : det l1 l2 l3 <> 0) by lra.
  set (f1 := fun X => det X l2 l3 / det l1 l2 l3). set (f2 := fun X => det l1 X l3 / det l1 l2 l3). set (f3 := fun X => det l1 l2 X / det l1 l2 l3).
  assert (A1 : affine f1). { exists ((py l2 * pz l3 - pz l2 * py l3) / det l1 l2 l3), ((pz l2 * px l3 - px l2 * pz l3) / det l1 l2 l3), ((px l2 * py l3 - py l2 * px l3) / det l1 l2 l3), 0. intros X. unfold f1. field_simplify_eq; auto. unf. ring. }
  assert (A2 : affine f2). { exists ((py l3 * pz l1 - pz l3 * py l1) / det l1 l2 l3), ((pz l3 * px l1 - px l3 * pz l1) / det l1 l2 l3), ((px l3 * py l1 - py l3 * px l1) / det l1 l2 l3), 0. intros X. unfold f2. field_simplify_eq; auto. unf. ring. }
  assert (A3 : affine f3). { exists ((py l1 * pz l2 - pz l1 * py l2) / det l1 l2 l3), ((pz l1 * px l2 - px l1 * pz l2) / det l1 l2 l3), ((px l1 * py l2 - py l1 * px l2) / det l1 l2 l3), 0. intros X. unfold f3. field_simplify_eq; auto. unf. ring. }
  destruct (aff_bound f1 M A1) as [C1 H1], (aff_bound f2 M A2) as [C2 H2], (aff_bound f3 M A3) as [C3 H3].
  set (t := piece (i, p, z30)).
  set (B := Rmax (C1 + spread t f1) (Rmax (C2 + spread t f2) (C3 + spread t f3))).
  exists (Z.to_nat (up B)). intros n y V Ny C.
  assert (L : latb r n = true) by (destruct p; apply V).
  assert (Hy : hull t (sub y (period n))).
  { apply hull_closed in C; [|apply piece_vol, V]. rewrite translate_piece in C by auto. fold t in C.
    destruct C as [a [b [c [d [A [B0 [C0 [D [S E]]]]]]]]]. exists a, b, c, d. repeat split; auto. rewrite E. unfold combination, translate; cbn [va vb vc vd].
    replace d with (1 - a - b - c) by lra. apply point_eq; unf; ring. }
  destruct n as [[n1 n2] n3].
  assert (E1 : f1 y = IZR n1 + f1 (sub y (period (n1, n2, n3)))).
  { unfold f1, MosaicStatement.period, lattice_vector, at_coordinates. field_simplify_eq; auto. unf. ring. }
  assert (E2 : f2 y = IZR n2 + f2 (sub y (period (n1, n2, n3)))).
  { unfold f2, MosaicStatement.period, lattice_vector, at_coordinates. field_simplify_eq; auto. unf. ring. }
  assert (E3 : f3 y = IZR n3 + f3 (sub y (period (n1, n2, n3)))).
  { unfold f3, MosaicStatement.period, lattice_vector, at_coordinates. field_simplify_eq; auto. unf. ring. }
  pose proof (spread_ok t f1 _ A1 Hy) as S1. pose proof (spread_ok t f2 _ A2 Hy) as S2. pose proof (spread_ok t f3 _ A3 Hy) as S3.
  specialize (H1 y Ny). specialize (H2 y Ny). specialize (H3 y Ny). destruct (archimed B) as [U _].
  assert (M1 : C1 + spread t f1 <= B) by apply Rmax_l.
  assert (M2 : C2 + spread t f2 <= B) by (eapply Rle_trans; [|apply Rmax_r]; apply Rmax_l).
  assert (M3 : C3 + spread t f3 <= B) by (eapply Rle_trans; [|apply Rmax_r]; apply Rmax_r).
  assert (K : forall m x z C s, x = IZR m + z -> Rabs x < C -> Rabs z <= s -> C + s <= B -> In m (zr (Z.to_nat (up B)))).
  { intros m x z C0 s0 Ex X Z0 LE. apply zr_In. apply Rabs_def2 in X. assert (Z1 : - s0 <= z <= s0) by (split; [pose proof (Rle_abs (- z)); rewrite Rabs_Ropp in *; lra|pose proof (Rle_abs z); lra]).
    assert (T1 : IZR m < IZR (up B)) by lra. assert (T2 : IZR (- m) < IZR (up B)) by (rewrite opp_IZR; lra).
    apply lt_IZR in T1, T2. lia. }
  apply in_prod; [apply in_prod|]; eapply K; eauto.
Qed.
Definition parts i : list part := map Piece (seq 0 (length (pieces (patch_of i)))) ++
  flat_map (fun q => map (Join q) (seq 0 (rim_count (patch_of i) q))) (seq 0 (length (pyramids (patch_of i)))).
Lemma parts_In i p n : valid (i, p, n) -> In p (parts i).
Proof.
  unfold parts. rewrite in_app_iff, in_flat_map. destruct p as [k|q e]; cbn [valid]; intros [_ H].
  - left. apply in_map, in_seq. lia.
  - right. exists q. split; [apply in_seq; lia|]. apply in_map, in_seq. lia.
Qed.
(** One bound for all parts of finitely many tiles. *)
Lemma common_bound M (L : list (nat * part)) : exists B, forall i p n y, In (i, p) L -> valid (i, p, n) -> near M origin y -> closed (piece (i, p, n)) y -> In n (box B).
Proof.
  induction L as [|[i p] L [B IH]]; [exists 0%nat; intros ? ? ? ? []|].
  destruct (periods_bound M i p) as [B' H]. exists (Nat.max B B').
  assert (MONO : forall n B1 B2, (B1 <= B2)%nat -> In n (box B1) -> In n (box B2)).
  { intros [[x y] z] B1 B2 LE I. unfold box in *. rewrite !in_prod_iff, !zr_In in *. lia. }
  intros i0 p0 n y [E|I] V N C.
  - injection E as <- <-. apply (MONO n B'); [lia|]. eapply H; eauto.
  - apply (MONO n B); [lia|]. eapply IH; eauto.
Qed.
Theorem range M : exists L, finite_part cell valid L /\ reaches cell piece valid L M.
Proof.
  destruct (mosaic_locally_finite _ _ _ _ _ _ _ tiling M) as [F HF].
  set (T := F ++ flat_map (fun j => map (fun s => fst (across_side j s)) (seq 0 (sides (patch_of j)))) F).
  set (L := flat_map (fun i => map (pair i) (parts i)) T). destruct (common_bound M L) as [B HB].
  exists (nodup cell_eq_dec (filter (fun c => if dec (valid c) then true else false) (list_prod L (box B)))).
  split; [split; [apply NoDup_nodup|]|].
  - intros c Hc. apply nodup_In, filter_In in Hc as [_ Hc]. destruct (dec (valid c)); congruence.
  - intros [[i p] n] y V N C. apply nodup_In, filter_In. split; [|destruct (dec (valid (i, p, n))); tauto].
    assert (IL : In (i, p) L).
    { apply in_flat_map. exists i. split; [|apply in_map; eapply parts_In, V].
      unfold T. apply in_app_iff. destruct p as [k|q e].
      + left. apply (HF i y N). eapply piece_over; eauto.
      + destruct (join_over _ _ _ _ _ V C) as [Y|Y]; [left; apply (HF i y N Y)|right]. apply (HF _ y N) in Y. destruct V as [_ [Hq _]].
        destruct (pyramid_facts i q Hq) as [Hs _].
        destruct (across_side i (wall i q)) as [j s'] eqn:E. cbn [fst] in Y. destruct (across_spec i _ j s' Hs E) as [Hs' [_ [E' _]]].
        apply in_flat_map. exists j. split; auto. apply in_map_iff. exists s'. rewrite E'. split; auto. apply in_seq. lia. }
    apply in_prod; auto. eapply HB; eauto.
Qed.

(** ** A point in one cell *)
Theorem once_somewhere : exists x c, valid c /\ inside (piece c) x /\ forall c', valid c' -> c' <> c -> ~ closed (piece c') x.
Proof.
  destruct (good_homes OK (kind 0) (kind_lt 0)) as [k [x [Hk [I [P [NP NJ]]]]]]. change (nth (kind 0) system (Patch [] [] [])) with (patch_of 0%nat) in *.
  exists (at_ 0 z30 x), (0%nat, Piece k, z30). split; [split; [apply latb_zero|exact Hk]|]. split.
  { intros m Hm. cbn [piece]. rewrite at_coord. apply Rmult_lt_0_compat; auto. }
  assert (IN : forall i, over r system tiles i (at_ 0 z30 x) -> i = 0%nat).
  { intros i Hi. symmetry. apply (mosaic_apart _ _ _ _ _ _ _ tiling 0%nat i (at_ 0 z30 x)); auto.
    exists (add (lift z30 x) (rise 0%nat)). split; [reflexivity|]. intros s Hs. rewrite (left_fibre r rank_eq) by apply high. rewrite lift_zero. apply P, Hs. }
  assert (BACK : forall n t, latb r n = true -> closed (map_tet (at_ 0 n) t) (at_ 0 z30 x) -> closed t (lift (zopp3 n) x)).
  { intros n t L C. apply (at_closed 0 n). rewrite at_lift. rewrite zadd3_opp. exact C. }
  intros [[i p] n] V NE C. destruct p as [k'|q e].
  - pose proof C as C'. apply piece_over in C'; auto. apply IN in C'. subst i. destruct V as [L V]. cbn [piece] in C. apply BACK in C; auto.
    revert C. apply NP; auto using latb_opp. intros K. apply NE. injection K as K1 K2. subst k'. f_equal.
    rewrite <- (zopp3_opp n), K2. reflexivity.
  - pose proof C as C'. apply join_over in C'; auto. destruct V as [L [Hq [He I']]]. destruct (pyramid_facts i q Hq) as [Hs _].
    assert (i = 0%nat). { destruct C' as [C'|C']; apply IN in C'; auto. rewrite C' in I'. lia. }
    subst i. cbn [piece] in C. apply BACK in C; auto. unfold join_at in C. destruct (across_side 0%nat (wall 0%nat q)) as [j s'] eqn:E.
    destruct (across_spec 0%nat _ j s' Hs E) as [Hs' [_ [_ FT]]]. revert C. apply NJ; auto using kind_lt, latb_opp.
Qed.

(** ** The cells of MosaicStatement.v *)
Notation is_cell := (is_cell l1 l2 l3 r system tiles rise).
Lemma at_zero i x : at_ i z30 x = spot i x.
Proof. unfold at_. rewrite lift_zero. reflexivity. Qed.
Lemma pyramid_index p P : In P (pyramids p) -> exists q, (q < length (pyramids p))%nat /\ pyramid_at p q = P.
Proof. intros I. apply (In_nth _ _ no_pyramid) in I. exact I. Qed.
Lemma rim_In p q x : In x (rim (pyramid_at p q)) <-> exists e, (e < rim_count p q)%nat /\ rim_at p q e = x.
Proof.
  split; [intros I; apply (In_nth _ _ origin) in I; exact I|]. intros [e [He <-]]. apply nth_In, He.
Qed.
(** A pyramid in a wall of a tile has this side. *)
Lemma wall_unique i q s : (q < length (pyramids (patch_of i)))%nat -> (s < sides (patch_of i))%nat ->
  (forall x, In x (rim (pyramid_at (patch_of i) q)) -> left_of (patch_of i) s x = 0) -> s = wall i q.
Proof.
  intros Hq Hs Z. destruct (pyramid_facts i q Hq) as [_ [_ [_ [_ [_ [U _]]]]]].
  destruct (Nat.eq_dec s (wall i q)) as [|N]; auto. exfalso. destruct (U s Hs N) as [e [He K]]. apply K, Z, rim_In. eauto.
Qed.
(** The rims of a pyramid and of its mate have the same corners. *)
Lemma rims_meet i q j s' q' m : (q < length (pyramids (patch_of i)))%nat -> across_side i (wall i q) = (j, s') ->
  pyramid_mate h (kind i) q (kind j) s' = (q', m) ->
  forall X, In X (map (fun x => spot i x) (rim (pyramid_at (patch_of i) q))) <->
    In X (map (fun x => add (spot j x) (period (zadd3 m (step i (wall i q))))) (rim (pyramid_at (patch_of j) q'))).
Proof.
  intros Hq E PM X. destruct (pyramid_facts i q Hq) as [Hs _]. destruct (across_spec i _ j s' Hs E) as [Hs' [NE [E' FT]]].
  pose proof (mate_facts i q j s' Hq E) as M. rewrite PM in M. destruct M as [Hq' [W [Lm [PM' [R _]]]]].
  destruct (step_spec i _ j s' Hs E) as [Ls _].
  assert (F : forall x, add (spot j x) (period (zadd3 m (step i (wall i q)))) = spot i (lift m (carry (patch_of i) (wall i q) (patch_of j) s' x))).
  { intros x. rewrite <- at_period by auto using latb_add. rewrite <- (at_zero i), <- frame_lift by auto using latb_zero.
    f_equal. f_equal. rewrite zadd3_comm. symmetry. apply zadd3_zero. }
  rewrite !in_map_iff. split.
  - intros [x [<- Hx]]. apply rim_In in Hx as [e [He <-]]. destruct (R e He) as [He' [_ [R3 _]]].
    eexists. split; [rewrite F, <- R3; reflexivity|]. apply rim_In. eexists. split; [|reflexivity]. apply next_lt, He'.
  - intros [x [<- Hx]]. apply rim_In in Hx as [e' [He' <-]].
    rewrite <- W in E'. pose proof (mate_facts j q' i (wall i q) Hq' E') as M'. rewrite W in M'. rewrite PM' in M'. destruct M' as [_ [_ [_ [_ [R' _]]]]].
    destruct (R' e' He') as [He [RM _]]. destruct (R _ He) as [_ [RM2 [_ [R4 _]]]]. rewrite RM in R4.
    eexists. split; [rewrite F, <- R4; reflexivity|]. apply rim_In. eexists. split; [|reflexivity]. apply next_lt, He.
Qed.
Lemma is_cell_iff t : is_cell t <-> exists c, valid c /\ t = piece c.
Proof.
  split.
  - intros [i t0 n Hin L|i s j s' P Q m e n M I IP ZP IQ Lm EQ He L k].
    + apply (In_nth _ _ no_tet) in Hin as [k [Hk Hn]]. apply latb_iff in L.
      exists (i, Piece k, n). split; [split; auto|]. rewrite translate_piece by auto. f_equal. cbn [piece]. unfold piece_at. rewrite Hn.
      unfold map_tet. rewrite !at_zero. reflexivity.
    + apply latb_iff in L, Lm. pose proof M as [Hs [Hs' _]]. pose proof (meets_across _ _ _ _ M) as E.
      apply pyramid_index in IP as [q [Hq EP]]. apply pyramid_index in IQ as [q2 [Hq2 EQ2]]. subst P Q.
      assert (W : s = wall i q) by (apply wall_unique; auto). subst s.
      pose proof (mate_facts i q j s' Hq E) as MF. destruct (pyramid_mate h (kind i) q (kind j) s') as [q' m'] eqn:PM.
      destruct MF as [Hq' [W' [Lm' [PM' [R _]]]]]. destruct (step_spec i _ j s' Hs E) as [Ls _].
      pose proof (rims_meet i q j s' q' m' Hq E PM) as RM. set (d := zadd3 m' (step i (wall i q))) in *. assert (Ld : latb r d = true) by (unfold d; auto using latb_add).
      (* the rim of the other pyramid is that of the mate *)
      assert (SUB : forall x, In x (rim (pyramid_at (patch_of j) q2)) -> exists x', In x' (rim (pyramid_at (patch_of j) q')) /\ x = lift (zadd3 d (zopp3 m)) x').
      { intros x Hx. assert (X : In (add (spot j x) (period m)) (map (fun x => add (spot j x) (period m)) (rim (pyramid_at (patch_of j) q2)))) by (apply (in_map (fun x => add (spot j x) (period m))), Hx).
        apply EQ, RM in X. apply in_map_iff in X as [x' [X Hx']]. exists x'. split; auto. rewrite <- !at_period in X by auto.
        apply (at_inj j m). rewrite at_lift. rewrite <- X. f_equal. clear. clearbody d. destruct d as [[? ?] ?], m as [[? ?] ?]. unfold zadd3, zopp3. apply z3_eq; lia. }
      assert (Lo : latb r (zadd3 d (zopp3 m)) = true) by (auto using latb_add, latb_opp).
      destruct (pyramid_facts j q' Hq') as [_ [_ [_ [_ [Z' _]]]]].
      assert (W2 : s' = wall j q2).
      { apply wall_unique; auto. intros x Hx. apply SUB in Hx as [x' [Hx' ->]]. rewrite (left_lift r rank_eq) by auto. apply rim_In in Hx' as [e' [He' <-]].
        rewrite W' in Z'. apply Z', He'. }
      assert (q2 = q').
      { destruct (Nat.eq_dec q' q2) as [|N]; auto. exfalso. destruct (pyramid_facts j q2 Hq2) as [_ [_ [_ [_ [_ [_ D]]]]]].
        destruct (D q' Hq' N ltac:(rewrite W'; exact W2) _ Lo) as [e2 [He2 K]]. destruct (SUB (rim_at (patch_of j) q2 e2)) as [x' [Hx' X]]; [apply rim_In; eauto|].
        apply rim_In in Hx' as [e' [He' <-]]. apply (K e' He' X). }
      subst q2. assert (Z0 : zadd3 d (zopp3 m) = z30).
      { apply (no_shift (rim (pyramid_at (patch_of j) q'))); auto. destruct (pyramid_facts j q' Hq') as [_ [C _]]. unfold rim_count in C.
        change (nth (kind j) system (Patch [] [] [])) with (patch_of j) in C.
        destruct (rim (pyramid_at (patch_of j) q')); [cbn in C; lia|congruence]. }
      assert (Em : m = d). { clear - Z0. clearbody d. destruct d as [[? ?] ?], m as [[? ?] ?]. unfold zadd3, zopp3, z30 in Z0. injection Z0 as A B C. apply z3_eq; lia. }
      exists (i, Join q e, n). split; [cbn [valid]; rewrite E; auto|]. rewrite translate_piece by auto. f_equal. cbn [piece]. unfold join_at. rewrite E. unfold join. rewrite PM.
      unfold map_tet; cbn [va vb vc vd]. rewrite !at_zero. unfold k, rim_at, rim_count, apex_at, pyramid_at. f_equal.
      subst m. rewrite <- at_period by auto. rewrite <- (at_zero i).
      change (nth (kind i) system (Patch [] [] [])) with (patch_of i). change (nth (kind j) system (Patch [] [] [])) with (patch_of j).
      rewrite <- (frame_lift i (wall i q) j s' z30 m') by auto using latb_zero. f_equal. unfold d. rewrite (zadd3_comm z30), zadd3_zero. reflexivity.
  - intros [[[i [k|q e]] n] [V ->]]; destruct V as [L V]; rewrite translate_piece by auto.
    + cbn [piece]. pose proof (nth_In _ no_tet V) as I. apply latb_iff in L. unfold map_tet. rewrite !at_zero.
      apply (piece_cell l1 l2 l3 r system tiles rise i (piece_at (patch_of i) k) n I L).
    + destruct V as [Hq [He I]]. destruct (pyramid_facts i q Hq) as [Hs [_ [_ [_ [Z _]]]]]. destruct (across_side i (wall i q)) as [j s'] eqn:E. cbn [fst] in I.
      pose proof (mate_facts i q j s' Hq E) as MF. destruct (pyramid_mate h (kind i) q (kind j) s') as [q' m'] eqn:PM.
      destruct MF as [Hq' [W' [Lm' [PM' [R _]]]]]. destruct (step_spec i _ j s' Hs E) as [Ls _].
      pose proof (rims_meet i q j s' q' m' Hq E PM) as RM. apply latb_iff in L. set (d := zadd3 m' (step i (wall i q))) in *. assert (Ld : latb r d = true) by (unfold d; auto using latb_add).
      pose proof (join_cell l1 l2 l3 r system tiles rise i (wall i q) j s' (pyramid_at (patch_of i) q) (pyramid_at (patch_of j) q') d e n (across_meets _ _ _ _ Hs E) I
        (nth_In _ no_pyramid Hq) ltac:(intros x Hx; apply rim_In in Hx as [e' [He' <-]]; apply Z, He') (nth_In _ no_pyramid Hq') (proj1 (latb_iff r d) Ld) RM He L) as K.
      cbv zeta in K. match type of K with is_cell (translate _ ?a) => match goal with |- is_cell (translate _ ?b) => replace b with a; [exact K|] end end.
      cbn [piece]. unfold join_at. rewrite E. unfold join. rewrite PM. unfold map_tet; cbn [va vb vc vd]. rewrite !at_zero. f_equal.
      rewrite <- at_period by auto. rewrite <- (at_zero i).
      change (nth (kind i) system (Patch [] [] [])) with (patch_of i). change (nth (kind j) system (Patch [] [] [])) with (patch_of j).
      rewrite <- (frame_lift i (wall i q) j s' z30 m') by auto using latb_zero. unfold d. rewrite (zadd3_comm z30), zadd3_zero. reflexivity.
Qed.

(** Every facet has a mate, and the domain is all of space. *)
Notation everywhere := (fun _ : point => True).
Notation every_facet := (fun _ : cell * nat => True).
Lemma mates_everywhere c f : valid c -> In f I4 -> True ->
  valid (fst (across (c, f))) /\ In (snd (across (c, f))) I4 /\ across (across (c, f)) = (c, f) /\
  opposite (facet (piece c) f) (facet (piece (fst (across (c, f)))) (snd (across (c, f)))) /\ True.
Proof. intros V F _. pose proof (mates c f V F). tauto. Qed.
Lemma no_boundary c f : valid c -> In f I4 -> True \/ forall y : point, True -> 0 < coord (piece c) f y.
Proof. auto. Qed.
Lemma open_everywhere : open everywhere.
Proof. apply opn_const. Qed.
Lemma convex_everywhere (p q : point) (s : R) : True -> True -> 0 <= s <= 1 -> True.
Proof. auto. Qed.
Lemma inside_everywhere c x : valid c -> inside (piece c) x -> True.
Proof. auto. Qed.
Lemma covered : covered_once cell piece valid everywhere.
Proof.
  exact (once_everywhere cell cell_eq_dec piece valid everywhere every_facet across piece_vol range mates_everywhere no_boundary
    open_everywhere convex_everywhere inside_everywhere once_somewhere).
Qed.

Theorem mosaic_tiles : tiles_space is_cell.
Proof.
  pose proof piece_vol as PV. constructor.
  - intros t Ht. apply is_cell_iff in Ht as [c [V ->]]. specialize (PV c V). lra.
  - intros M. destruct (range M) as [L [FL RG]]. exists (map piece L). intros t X Ht N H. apply is_cell_iff in Ht as [c [V ->]].
    apply in_map. apply RG with (y := X); auto. apply hull_closed; auto.
  - intros X. destruct (cover cell piece valid everywhere range open_everywhere covered X) as [c [V C]].
    { intros e He. exists X. split; auto. apply near_refl, He. }
    exists (piece c). split; [apply is_cell_iff; eauto|apply hull_closed; auto].
  - intros X t t' Ht Ht' H H'. apply is_cell_iff in Ht as [c [V ->]]. apply is_cell_iff in Ht' as [c' [V' ->]].
    f_equal. apply open_hull_inter in H; auto. apply hull_closed in H'; auto.
    apply (disjoint_closed cell cell_eq_dec piece valid everywhere piece_vol inside_everywhere covered X); auto.
  - intros X t t' Ht Ht' H H'. apply is_cell_iff in Ht as [c [V ->]]. apply is_cell_iff in Ht' as [c' [V' ->]].
    pose proof (proj1 (hull_closed _ _ (PV c V)) H) as C. pose proof (proj1 (hull_closed _ _ (PV c' V')) H') as C'.
    pose proof (fun v => face_to_face cell cell_eq_dec piece valid everywhere every_facet across piece_vol range mates_everywhere no_boundary
      convex_everywhere inside_everywhere covered X v c c' V V' C C') as FF.
    destruct H as [a [b [c0 [d [A [B [C0 [Dd [S Hx]]]]]]]]]. exists a, b, c0, d.
    repeat split; auto; intros P; apply carT_vert with (x := X); apply FF; exists a, b, c0, d; repeat split; auto.
Qed.
End System.
