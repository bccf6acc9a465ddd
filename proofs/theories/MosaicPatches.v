(** * Systems of patches: the conditions

    Here patches have real coordinates, and the conditions are propositions; MosaicChecker.v decides them.
    Everything around a wall is said in the coordinates of one of its two tiles: [carry] takes
    those of the other tile to them, up to periods.  A facet of a cell is an *occupant* of a patch, moved by
    a period: a facet of the piece, or a lateral triangle of a pyramid; or it is one of the two
    facets of a tetrahedron of a join that contain its axis.
    MosaicTiling.v proves that the cells over a mosaic tile space. *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Statement Sums Tetrahedra Degree Domain MosaicStatement MosaicPoints.
Import ListNotations.
Open Scope R_scope.

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
End System.
