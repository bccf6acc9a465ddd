(** * docs/lower-bound.md, sections 1 and 7: the tiles at a vertex of a tiling

    They form a [vertex_star] of Vertex.v.  A dart at the vertex v is a tile with v and an order of its other three
    vertices, so that the orientation is positive. *)
From Coq Require Import Reals Lra Lia List Bool Arith Classical.
From Acutile Require Import Statement Tetrahedra.
From LowerBound Require Import Corners Link Vertex Tiling Edge.
Import ListNotations.
Open Scope R_scope.

(** ** Finite lists *)

Lemma sublist {A} (P : A -> Prop) l : exists m, NoDup m /\ forall x, In x m <-> In x l /\ P x.
Proof.
  induction l as [|a l [m [N H]]]; [exists []; split; [constructor|simpl; tauto]|].
  destruct (classic (P a /\ ~ In a m)) as [[Pa Na]|Q].
  - exists (a :: m). split; [constructor; assumption|]. intros x. simpl. rewrite H. split; [intros [<-|?]; tauto|tauto].
  - exists m. split; [exact N|]. intros x. simpl. split; [intros X; apply H in X; tauto|]. intros [[<-|X] Px]; [|apply H; tauto].
    apply NNPP. intros Z. tauto.
Qed.

(** The first number from k on with f, among m. *)
Fixpoint first_from (f : nat -> bool) k m := match m with O => k | S m => if f k then k else first_from f (S k) m end.
Lemma first_from_spec f m : forall k n, (k <= n)%nat -> (n < k + m)%nat -> f n = true ->
  let r := first_from f k m in (k <= r)%nat /\ f r = true /\ forall i, (k <= i < r)%nat -> f i = false.
Proof.
  induction m as [|m IH]; intros k n A B E; [lia|]. cbn [first_from]. destruct (f k) eqn:K.
  - split; [lia|]. split; [exact K|]. intros i I. lia.
  - assert (n <> k) by congruence. destruct (IH (S k) n ltac:(lia) ltac:(lia) E) as [P [Q R]]. split; [lia|]. split; [exact Q|].
    intros i I. destruct (Nat.eq_dec i k) as [->|]; [exact K|]. apply R. lia.
Qed.
Lemma first_from_ext f g m : (forall i, f i = g i) -> forall k, first_from f k m = first_from g k m.
Proof. intros E. induction m as [|m IH]; intros k; cbn [first_from]; [reflexivity|]. rewrite E, IH. reflexivity. Qed.

(** A map that is one-to-one on a finite list comes back. *)
Section Orbit.
Context {A : Type}.
Variables (l : list A) (turn : A -> A).
Hypothesis inside : forall x, In x l -> In (turn x) l.
Hypothesis one : forall x y, In x l -> In y l -> turn x = turn y -> x = y.
Lemma iterate_inside x n : In x l -> In (Nat.iter n turn x) l.
Proof. intros X. induction n; cbn; auto. Qed.
Lemma iterate_one x y n : In x l -> In y l -> Nat.iter n turn x = Nat.iter n turn y -> x = y.
Proof.
  intros X Y. induction n as [|n IH]; cbn; [auto|]. intros E. apply IH. apply one; auto using iterate_inside.
Qed.
Lemma iterate_add x i j : Nat.iter (i + j) turn x = Nat.iter i turn (Nat.iter j turn x).
Proof. induction i as [|i IH]; [reflexivity|]. change (turn (Nat.iter (i + j) turn x) = turn (Nat.iter i turn (Nat.iter j turn x))). rewrite IH. reflexivity. Qed.
Fixpoint trace x m := match m with O => [] | S m => Nat.iter m turn x :: trace x m end.
Lemma trace_in x m y : In y (trace x m) -> exists i, (i < m)%nat /\ y = Nat.iter i turn x.
Proof. induction m as [|m IH]; intros []; [exists m; split; [lia|congruence]|]. destruct (IH H) as [i [I E]]. exists i. split; [lia|exact E]. Qed.
Lemma trace_length x m : length (trace x m) = m.
Proof. induction m; cbn; auto. Qed.
Lemma comes_back x : In x l -> exists n, (1 <= n <= length l)%nat /\ Nat.iter n turn x = x.
Proof.
  intros X. apply NNPP. intros N.
  assert (D : forall m, (m <= S (length l))%nat -> NoDup (trace x m)).
  { induction m as [|m IH]; intros M; [constructor|]. cbn [trace]. constructor; [|apply IH; lia]. intros I. apply trace_in in I. destruct I as [i [I E]].
    apply N. exists (m - i)%nat. split; [lia|]. replace m with (i + (m - i))%nat in E by lia. rewrite iterate_add in E.
    symmetry in E. symmetry. apply (iterate_one _ _ i); auto using iterate_inside. }
  pose proof (NoDup_incl_length (D _ (le_n _)) (l' := l)) as Q. rewrite trace_length in Q.
  assert (incl (trace x (S (length l))) l) by (intros y Y; apply trace_in in Y; destruct Y as [i [_ ->]]; apply iterate_inside, X).
  specialize (Q H). lia.
Qed.
End Orbit.

(** ** The darts at a vertex *)

Definition dart := (point * point * point)%type.
Definition tip (d : dart) : point := fst (fst d).
Definition along (d : dart) : dart := let '(p, q, r) := d in (q, r, p).
Definition next_after (d e : dart) := ptb (fst (fst e)) (fst (fst d)) && ptb (snd (fst e)) (snd d).
Definition turn_in (l : list dart) (d : dart) : dart := match find (next_after d) l with Some e => e | None => d end.
Definition same_dart (d e : dart) := ptb (fst (fst d)) (fst (fst e)) && ptb (snd (fst d)) (snd (fst e)) && ptb (snd d) (snd e).
Lemma same_dart_eq d e : same_dart d e = true <-> d = e.
Proof.
  destruct d as [[p q] r], e as [[p' q'] r']. unfold same_dart. cbn [fst snd]. rewrite !andb_true_iff, !ptb_t.
  split; [intros [[-> ->] ->]; reflexivity|]. intros E. injection E as -> -> ->. auto.
Qed.
(** The number of tiles in the cycle of d. *)
Definition valence_in (l : list dart) (d : dart) : nat := first_from (fun n => same_dart (Nat.iter n (turn_in l) d) d) 1 (length l).

(** A tile has the same dihedral angles in another order of its vertices. *)
Lemma shuffle_dihedrals s t : shuffle s t -> vol s <> 0 -> forall x, In x (dihedrals s) -> In x (dihedrals t).
Proof.
  induction 1 as [|a b c d t S IH|a b c d t S IH|a b c d t S IH]; intros V x X; [exact X| | |]; change (vol (Tetrahedron a b c d)) with (orient a b c d) in V; apply IH.
  - change (orient b a c d <> 0). replace (orient b a c d) with (- orient a b c d) by (unf; ring). lra.
  - unfold dihedrals in *; cbn [va vb vc vd] in *. rewrite (dihedral_back a b c d), (dihedral_sym c d b a) by exact V. simpl in *. tauto.
  - change (orient a c b d <> 0). replace (orient a c b d) with (- orient a b c d) by (unf; ring). lra.
  - assert (V' : orient b c a d <> 0) by (replace (orient b c a d) with (orient a b c d) by (unf; ring); exact V).
    unfold dihedrals in *; cbn [va vb vc vd] in *. rewrite (dihedral_back b c a d V'), (dihedral_sym a d c b). simpl in *. tauto.
  - change (orient a b d c <> 0). replace (orient a b d c) with (- orient a b c d) by (unf; ring). lra.
  - assert (V' : orient c d a b <> 0) by (replace (orient c d a b) with (orient a b c d) by (unf; ring); exact V).
    unfold dihedrals in *; cbn [va vb vc vd] in *. rewrite (dihedral_back c d a b V'), (dihedral_sym a b d c). simpl in *. tauto.
Qed.

Section Vertex.
Context {index : Type} {is_tile : index -> Prop} {tile : index -> tetrahedron}.
Hypothesis tiling : space_tiling is_tile tile.
Notation pos := (@pos index is_tile tile).
Variable v : point.
Lemma darts_exist : exists darts : list dart, NoDup darts /\ forall p q r, In (p, q, r) darts <-> pos v p q r.
Proof.
  destruct (cells_at tiling v) as [L H]. destruct (sublist (fun d : dart => let '(p, q, r) := d in pos v p q r) L) as [m [N M]].
  exists m. split; [exact N|]. intros p q r. rewrite M. split; [tauto|]. intros P. split; [apply H, P|exact P].
Qed.

Variable darts : list dart.
Hypothesis distinct : NoDup darts.
Hypothesis darts_are : forall p q r, In (p, q, r) darts <-> pos v p q r.
Notation turn := (turn_in darts).
Notation valence := (valence_in darts).

Lemma turn_is p q r s : pos v p q r -> pos v p r s -> turn (p, q, r) = (p, r, s).
Proof.
  intros _ P. unfold turn_in. destruct (find (next_after (p, q, r)) darts) as [[[p' r'] s']|] eqn:E.
  - apply find_some in E. destruct E as [I E]. unfold next_after in E. cbn [fst snd] in E. rewrite andb_true_iff, !ptb_t in E. destruct E as [-> ->].
    apply darts_are in I. rewrite (same_side tiling _ _ _ _ _ I P). reflexivity.
  - apply darts_are in P. apply (find_none _ _ E) in P. unfold next_after in P. cbn [fst snd] in P.
    rewrite (proj2 (ptb_t p p)), (proj2 (ptb_t r r)) in P by reflexivity. discriminate.
Qed.
Lemma turn_exists p q r : pos v p q r -> exists s, pos v p r s /\ turn (p, q, r) = (p, r, s).
Proof. intros P. destruct (pos_next tiling _ _ _ _ P) as [s S]. exists s. split; [exact S|]. apply turn_is; assumption. Qed.
Lemma turn_inside d : In d darts -> In (turn d) darts.
Proof. destruct d as [[p q] r]. intros D. apply darts_are in D. destruct (turn_exists p q r D) as [s [S ->]]. apply darts_are, S. Qed.
Lemma turn_one d e : In d darts -> In e darts -> turn d = turn e -> d = e.
Proof.
  destruct d as [[p q] r], e as [[p' q'] r']. intros D E. apply darts_are in D, E. destruct (turn_exists p q r D) as [s [S ->]]. destruct (turn_exists p' q' r' E) as [s' [S' ->]].
  intros X. injection X as <- <- <-. rewrite (same_side_previous tiling _ _ _ _ _ D E). reflexivity.
Qed.
Lemma valence_spec d : In d darts -> (1 <= valence d)%nat /\ Nat.iter (valence d) turn d = d /\
  forall k, (1 <= k < valence d)%nat -> Nat.iter k turn d <> d.
Proof.
  intros D. destruct (comes_back darts turn turn_inside turn_one d D) as [n [N E]].
  destruct (first_from_spec (fun n => same_dart (Nat.iter n turn d) d) (length darts) 1 n) as [A [B C]]; [lia|lia|apply same_dart_eq, E|].
  unfold valence_in. split; [exact A|]. split; [apply same_dart_eq, B|]. intros k K Z. specialize (C k K). cbv beta in C.
  rewrite (proj2 (same_dart_eq _ _) Z) in C. discriminate.
Qed.
Lemma valence_turn d : In d darts -> valence (turn d) = valence d.
Proof.
  intros D. unfold valence_in. apply first_from_ext. intros i. apply eq_true_iff_eq. rewrite !same_dart_eq.
  replace (Nat.iter i turn (turn d)) with (turn (Nat.iter i turn d)) by (change (Nat.iter i turn (turn d)) with (Nat.iter i turn (Nat.iter 1 turn d)); rewrite <- iterate_add, Nat.add_1_r; reflexivity).
  split; [|congruence]. apply turn_one; [|exact D]. apply iterate_inside; [exact turn_inside|exact D].
Qed.

(** *** The cycle of a dart *)
Definition point_of (d : dart) k := snd (fst (Nat.iter k turn d)).
Lemma cycle_fan p q r k : pos v p q r -> Nat.iter k turn (p, q, r) = (p, point_of (p, q, r) k, point_of (p, q, r) (S k)) /\
  pos v p (point_of (p, q, r) k) (point_of (p, q, r) (S k)).
Proof.
  intros P. unfold point_of. set (d := (p, q, r)).
  assert (I : forall k, exists x y, Nat.iter k turn d = (p, x, y) /\ pos v p x y).
  { intros i. induction i as [|i [x [y [E X]]]]; [exists q, r; auto|]. destruct (turn_exists p x y X) as [s [S T]]. exists y, s. split; [|exact S].
    change (turn (Nat.iter i turn d) = (p, y, s)). rewrite E. exact T. }
  destruct (I k) as [x [y [E X]]]. destruct (turn_exists p x y X) as [s [S T]].
  assert (E' : Nat.iter (Datatypes.S k) turn d = (p, y, s)) by (change (turn (Nat.iter k turn d) = (p, y, s)); rewrite E; exact T).
  rewrite E, E'. cbn [fst snd]. auto.
Qed.
Lemma sum_Phi (angle : dart -> R) (c : nat -> point) p d n : (forall k, angle (Nat.iter k turn d) = dihedral v p (c k) (c (S k))) ->
  fold_right Rplus 0 (map angle (around turn n d)) = Phi v p c n.
Proof.
  intros H. unfold around. assert (G : forall x l, fold_right Rplus x l = fold_right Rplus 0 l + x) by (intros x l; induction l as [|y l IH]; cbn; lra).
  induction n as [|n IH]; [reflexivity|]. rewrite seq_S, !map_app, fold_right_app, G, IH. cbn [map fold_right Phi]. rewrite Nat.add_0_l, H. lra.
Qed.
Lemma cycle_properties p q r : pos v p q r -> let d := (p, q, r) in let c := point_of d in let n := valence d in
  (forall k, pos v p (c k) (c (S k))) /\ (0 < n)%nat /\ c n = c 0%nat /\ c (S n) = c 1%nat /\ forall k, (0 < k < n)%nat -> ~ (c k = c 0%nat /\ c (S k) = c 1%nat).
Proof.
  intros P d c n. assert (D : In d darts) by (apply darts_are, P). destruct (valence_spec d D) as [A [B C]]. fold n in A, B, C.
  pose proof (fun k => proj1 (cycle_fan p q r k P)) as E. fold d in E. fold c in E.
  assert (E0 : d = (p, c 0%nat, c 1%nat)) by exact (E 0%nat).
  split; [intros k; apply (cycle_fan p q r k P)|]. split; [lia|].
  pose proof (E n) as En. rewrite B, E0 in En. injection En as En1 En2. split; [congruence|]. split; [congruence|].
  intros k K [K1 K2]. apply (C k ltac:(lia)). rewrite (E k), K1, K2. symmetry. exact E0.
Qed.
Lemma cycle_distinct d i j : In d darts -> (i < valence d)%nat -> (j < valence d)%nat -> Nat.iter i turn d = Nat.iter j turn d -> i = j.
Proof.
  intros D. assert (G : forall i j, (i < j < valence d)%nat -> Nat.iter i turn d <> Nat.iter j turn d).
  { clear i j. intros i j IJ E. destruct (valence_spec d D) as [_ [_ C]]. apply (C (j - i)%nat); [lia|].
    replace j with (i + (j - i))%nat in E by lia. rewrite iterate_add in E. symmetry.
    apply (iterate_one darts turn turn_inside turn_one _ _ i); auto using iterate_inside, turn_inside. }
  intros I J E. destruct (lt_eq_lt_dec i j) as [[L|L]|L]; [|exact L|]; exfalso; [apply (G i j)|apply (G j i)]; auto.
Qed.
(** All tiles at the edge are in this cycle, each once. *)
Theorem cycle_tiles p q r : pos v p q r -> let d := (p, q, r) in let c := point_of d in exists tiles, NoDup tiles /\ length tiles = valence d /\
  (forall i, In i tiles <-> has_edge is_tile tile v p i) /\ (forall k i, nth_error tiles k = Some i -> shuffle (Tetrahedron v p (c k) (c (S k))) (tile i)).
Proof.
  intros P d c. assert (D : In d darts) by (apply darts_are, P). destruct (cycle_properties p q r P) as [A [B [C [C' E]]]]. fold d c in A, B, C, C', E. set (n := valence d) in *.
  assert (T : exists tiles, length tiles = n /\ forall k i, nth_error tiles k = Some i -> is_tile i /\ shuffle (Tetrahedron v p (c k) (c (S k))) (tile i)).
  { clear B C C' E. induction n as [|n [tiles [L T]]]; [exists []; split; [reflexivity|]; intros [|k] i X; discriminate|].
    destruct (A n) as [[i [I S]] _]. exists (tiles ++ [i]). split; [rewrite app_length; cbn; lia|]. intros k j X.
    destruct (lt_dec k (length tiles)) as [K|K].
    - rewrite nth_error_app1 in X by exact K. apply T, X.
    - rewrite nth_error_app2 in X by lia. destruct (k - length tiles)%nat as [|m] eqn:M; [|destruct m; discriminate]. injection X as <-.
      replace k with n by lia. auto. }
  destruct T as [tiles [L T]]. exists tiles.
  assert (O : forall i x y x' y', shuffle (Tetrahedron v p x y) (tile i) -> shuffle (Tetrahedron v p x' y') (tile i) -> pos v p x y -> pos v p x' y' -> x = x' /\ y = y').
  { intros i x y x' y' S S' [Q O] [Q' O']. pose proof (cell_apart tiling _ _ _ _ Q') as N.
    assert (V : forall w, In w [v; p; x'; y'] -> In w [v; p; x; y]) by (intros w W; apply (shuffle_verts _ _ S), (shuffle_verts _ _ S'), W).
    pose proof (V x' ltac:(simpl; auto)) as Q1. pose proof (V y' ltac:(simpl; auto)) as Q2. simpl in Q1, Q2.
    destruct Q1 as [Q1|[Q1|[Q1|[Q1|[]]]]]; try tauto; destruct Q2 as [Q2|[Q2|[Q2|[Q2|[]]]]]; try tauto; try (subst; tauto).
    exfalso. subst. replace (orient v p y' x') with (- orient v p x' y') in O by (unf; ring). lra. }
  split; [|split; [exact L|split]].
  - apply NoDup_nth_error. intros i j I X. rewrite L in I. destruct (nth_error tiles i) as [t|] eqn:Ti; [|apply nth_error_None in Ti; lia].
    symmetry in X. pose proof (nth_error_Some tiles j) as J. rewrite X, L in J. specialize (proj1 J ltac:(discriminate)) as J'.
    destruct (T i t Ti) as [_ S]. destruct (T j t X) as [_ S']. destruct (O t _ _ _ _ S S' (A i) (A j)) as [E1 E2].
    apply (cycle_distinct d i j D I J'). unfold d. rewrite (proj1 (cycle_fan p q r i P)), (proj1 (cycle_fan p q r j P)). fold d c. congruence.
  - intros i. split.
    + intros I. apply In_nth_error in I. destruct I as [k K]. destruct (T k i K) as [Ti S]. split; [exact Ti|].
      split; apply (shuffle_verts _ _ S); simpl; auto.
    + intros [Ti [V Pi]]. pose proof (cell_apart tiling _ _ _ _ (proj1 P)) as N. destruct (shuffle_two (tile i) v p V Pi (proj1 N)) as [x [y S]].
      assert (Q : exists x y, shuffle (Tetrahedron v p x y) (tile i) /\ pos v p x y).
      { assert (Cx : @cell index is_tile tile v p x y) by (exists i; split; assumption). pose proof (cell_solid tiling _ _ _ _ Cx) as Ox.
        destruct (Rlt_dec 0 (orient v p x y)) as [Z|Z].
        - exists x, y. split; [exact S|]. split; assumption.
        - exists y, x. split; [apply shuffle_cd, S|]. split; [apply cell_cd, Cx|]. replace (orient v p y x) with (- orient v p x y) by (unf; ring). lra. }
      clear x y S. destruct Q as [x [y [S Q]]]. destruct (fan_all tiling v p c n A B C E x y Q) as [k [K [-> ->]]].
      destruct (nth_error tiles k) as [j|] eqn:J; [|apply nth_error_None in J; lia]. destruct (T k j J) as [Tj Sj].
      replace i with j; [apply nth_error_In in J; exact J|].
      destruct (tiles_same tiling _ _ _ _ _ _ Tj Ti Sj S). reflexivity.
  - intros k i K. apply T, K.
Qed.

Theorem vertex_star_of_tiling : vertex_star dart v darts turn along tip valence.
Proof.
  split.
  - exact distinct.
  - exact turn_inside.
  - intros [[p q] r] D. apply darts_are in D. apply darts_are, pos_turn, D.
  - intros [[p q] r] D. reflexivity.
  - intros [[p q] r] D. apply darts_are in D. cbn [along]. pose proof (pos_turn _ _ _ _ D) as D1. destruct (turn_exists q r p D1) as [s [S ->]]. cbn [along].
    apply turn_is; [apply pos_turn, S|exact D].
  - intros [[p q] r] D. apply darts_are in D. destruct (turn_exists p q r D) as [s [_ ->]]. reflexivity.
  - intros [[p q] r] D. apply darts_are in D. exact (cell_solid tiling _ _ _ _ (proj1 D)).
  - exact valence_turn.
  - intros d D. apply valence_spec, D.
  - intros [[p q] r] D. apply darts_are in D. destruct (cycle_properties p q r D) as [A [B [C [C' E]]]].
    rewrite <- (fan_sum tiling v p (point_of (p, q, r)) (valence (p, q, r)) A B C E). apply sum_Phi. intros k.
    rewrite (proj1 (cycle_fan p q r k D)). reflexivity.
Qed.
End Vertex.

(** The tiles at a point v form a [vertex_star]: the tetrahedra of the darts are the tiles with the vertex v. *)
Theorem star_in_tiling {index : Type} {is_tile : index -> Prop} {tile : index -> tetrahedron} : space_tiling is_tile tile ->
  forall v, exists (dart : Type) (darts : list dart) turn along tip valence, vertex_star dart v darts turn along tip valence /\
  (forall d, In d darts -> exists c, is_tile c /\ forall x, In x (verts (tile c)) <-> In x (verts (corner_tetrahedron v tip along d))) /\
  (forall c, is_tile c -> In v (verts (tile c)) -> exists d, In d darts /\ forall x, In x (verts (tile c)) <-> In x (verts (corner_tetrahedron v tip along d))).
Proof.
  intros tiling v. destruct (darts_exist tiling v) as [darts [D H]].
  exists dart, darts, (turn_in darts), along, tip, (valence_in darts). split; [exact (vertex_star_of_tiling tiling v darts D H)|]. split.
  - intros [[p q] r] I. apply H in I. destruct I as [[c [T S]] _]. exists c. split; [exact T|]. intros x. symmetry. exact (shuffle_verts _ _ S x).
  - intros c T V. destruct (shuffle_first (tile c) v V) as [p [q [r S]]]. assert (C : @cell index is_tile tile v p q r) by (exists c; split; assumption).
    pose proof (cell_solid tiling _ _ _ _ C) as O. destruct (Rlt_dec 0 (orient v p q r)) as [Z|Z].
    + exists (p, q, r). split; [apply H; split; assumption|]. intros x. symmetry. exact (shuffle_verts _ _ S x).
    + exists (p, r, q). split; [apply H; split; [apply cell_cd, C|]; replace (orient v p r q) with (- orient v p q r) by (unf; ring); lra|].
      intros x. symmetry. exact (shuffle_verts _ _ (shuffle_cd _ _ _ _ _ S) x).
Qed.

(** The tiles at an edge uv of a tiling: w 0, w 1, … are the other vertices of these tiles, in cyclic order. *)
Theorem edge_cycle {index : Type} {is_tile : index -> Prop} {tile : index -> tetrahedron} : space_tiling is_tile tile ->
  forall u v c0, has_edge is_tile tile u v c0 -> u <> v -> exists tiles (w : nat -> point), let n := length tiles in
  NoDup tiles /\ (forall c, In c tiles <-> has_edge is_tile tile u v c) /\
  (forall k c x, nth_error tiles k = Some c -> (In x (verts (tile c)) <-> In x [u; v; w k; w (S k)])) /\
  (forall k c, nth_error tiles k = Some c -> In (dihedral u v (w k) (w (S k))) (dihedrals (tile c))) /\ w n = w 0%nat /\
  fold_right Rplus 0 (map (fun k => dihedral u v (w k) (w (S k))) (seq 0 n)) = 2 * PI.
Proof.
  intros tiling u v c0 [T [U V]] N. destruct (shuffle_two (tile c0) u v U V N) as [x [y S]].
  assert (Q : exists x y, @pos index is_tile tile u v x y).
  { assert (Cx : @cell index is_tile tile u v x y) by (exists c0; split; assumption). pose proof (cell_solid tiling _ _ _ _ Cx) as Ox.
    destruct (Rlt_dec 0 (orient u v x y)) as [Z|Z].
    - exists x, y. split; assumption.
    - exists y, x. split; [apply cell_cd, Cx|]. replace (orient u v y x) with (- orient u v x y) by (unf; ring). lra. }
  clear x y S. destruct Q as [x [y P]]. destruct (darts_exist tiling u) as [darts [D H]].
  destruct (cycle_tiles tiling u darts H v x y P) as [tiles [A [B [C E]]]]. destruct (cycle_properties tiling u darts H v x y P) as [F [G [I [J K]]]].
  exists tiles, (point_of darts (v, x, y)). cbv zeta. rewrite B. split; [exact A|]. split; [exact C|]. split; [|split; [|split; [exact I|]]].
  - intros k c z Z. symmetry. apply (shuffle_verts _ _ (E k c Z)).
  - intros k c Z. apply (shuffle_dihedrals _ _ (E k c Z)); [|left; reflexivity]. exact (cell_solid tiling _ _ _ _ (proj1 (F k))).
  - rewrite <- (fan_sum tiling u v _ _ F G I K). set (c := point_of darts (v, x, y)).
    generalize (valence_in darts (v, x, y)) as n. clear. intros n. assert (R : forall z l, fold_right Rplus z l = fold_right Rplus 0 l + z) by (intros z l; induction l as [|s l IH]; cbn; lra).
    induction n as [|n IH]; [reflexivity|]. rewrite seq_S, map_app, fold_right_app, R, IH. cbn [map fold_right Phi]. rewrite Nat.add_0_l. lra.
Qed.
