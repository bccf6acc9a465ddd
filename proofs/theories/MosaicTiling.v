(** * Systems of patches: the conditions imply the tiling

    The cells over a mosaic are those of its pieces and joins, moved by periods.  Every facet has a mate
    ([mates]), finitely many cells meet a bounded set ([range]), and some point is in one cell only
    ([once_somewhere]).  So Cells.v says that they tile space ([mosaic_tiles]). *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Statement Sums Crossing Tetrahedra Topology Degree Domain Euclid Transfer MosaicStatement MosaicPoints MosaicPatches MosaicSides.
From Acutile Require Import Cells.
Import ListNotations.
Open Scope R_scope.

Section System.
Variables (G : gram) (r : nat) (system : list patch) (h : hints).
Hypothesis OK : good G r system h.
Variables (l1 l2 l3 : point).
Hypothesis basis : has_gram G l1 l2 l3.
Hypothesis right_handed : 0 < det l1 l2 l3.
Variable tiles : nat -> tile.
Hypothesis tiling : mosaic l1 l2 l3 G r system tiles.
Variable rise : nat -> point.
Hypothesis high : heights l1 l2 l3 r system tiles rise.
Notation kind i := (shape (tiles i)).
Notation patch_of i := (patch_of system tiles i).
Notation period n := (period l1 l2 l3 n).
Notation spot i x := (spot tiles rise i x).
Notation carry := (carry G r).
Notation left_of := (left_of r).
Notation in_prism := (in_prism r).
Notation join := (join G r system h).
Notation good_occupant := (good_occupant r system h).
Notation good_pyramid := (good_pyramid r system h).
Notation rank_eq := (rank_eq G r system h OK).
Notation kind_lt := (kind_lt G r system l1 l2 l3 tiles tiling).
Notation side_small := (side_small G r system h OK l1 l2 l3 tiles tiling).
Notation at_ := (at_ tiles rise).
Notation at_period := (at_period G r system h OK l1 l2 l3 basis right_handed tiles tiling rise).
Notation at_lift := (at_lift tiles rise).
Notation spot_affine := (spot_affine tiles rise).
Notation at_coord := (at_coord G r system h OK l1 l2 l3 basis right_handed tiles tiling rise).
Notation at_vol := (at_vol G r system h OK l1 l2 l3 basis right_handed tiles tiling rise).
Notation at_closed := (at_closed G r system h OK l1 l2 l3 basis right_handed tiles tiling rise).
Notation at_inj := (at_inj G r system h OK l1 l2 l3 basis right_handed tiles tiling rise).
Notation across_side := (across_side r system l1 l2 l3 tiles).
Notation across_meets := (across_meets G r system l1 l2 l3 tiles tiling).
Notation meets_across := (meets_across G r system h OK l1 l2 l3 basis right_handed tiles tiling).
Notation across_spec := (across_spec G r system h OK l1 l2 l3 basis right_handed tiles tiling).
Notation step := (step r system l1 l2 l3 tiles rise).
Notation step_spec := (step_spec G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).
Notation step_opp := (step_opp G r system h OK l1 l2 l3 basis right_handed tiles tiling rise high).

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
Proof. intros Hq. apply (good_pyramids _ _ _ _ OK); auto using kind_lt. Qed.
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
  destruct (good_pairs _ _ _ _ OK (kind i) (wall i q) (kind j) s') as [K _]; auto using kind_lt. exact (K q Hq eq_refl).
Qed.
Lemma piece_good c : valid c -> exists i n t, latb r n = true /\ piece c = map_tet (at_ i n) t /\ 0 < vol t.
Proof.
  destruct c as [[i [k|q e]] n]; cbn [valid piece]; intros [L V]; (eexists i, n, _; split; [exact L|]; split; [reflexivity|]).
  - apply (good_pieces _ _ _ _ OK); auto using kind_lt.
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
  intros K L. pose proof (good_occupants _ _ _ _ OK (kind i) o (kind_lt i) K) as C.
  unfold beyond at 1. unfold good_occupant in C. cbv zeta in C. destruct (behind h (kind i) o) as [o' m|s w] eqn:B.
  - destruct C as [C1 [Lm [C2 C3]]].
    exists i, o', (zadd3 n m). split; [exact C1|]. split; [auto using latb_add|]. split; auto. split.
    + unfold beyond. rewrite C2. f_equal. clear. destruct n as [[? ?] ?], m as [[? ?] ?]. unfold zadd3, zopp3. apply z3_eq; lia.
    + apply (opposite_map (at_ i n)) in C3. unfold tri. change (nth (kind i) system (Patch [] [] [])) with (patch_of i) in C3.
      replace (map_tri (at_ i (zadd3 n m)) (triangle_of (patch_of i) o')) with (map_tri (at_ i n) (map_tri (lift m) (triangle_of (patch_of i) o'))); [exact C3|].
      unfold map_tri; cbn [t1 t2 t3]. rewrite !at_lift. reflexivity.
  - destruct C as [Hs [Hw C]]. subst o.
    destruct (across_side i s) as [j s'] eqn:E. destruct (across_spec i s j s' Hs E) as [Hs' [NE [E' FT]]].
    destruct (good_pairs _ _ _ _ OK (kind i) s (kind j) s' (kind_lt i) (kind_lt j) Hs Hs' FT) as [_ P]. specialize (P w Hw).
    destruct (wall_mate h (kind i) s (kind j) s' w) as [w' m] eqn:WM. destruct P as [P1 [Lm [P2 P3]]].
    destruct (good_walls _ _ _ _ OK (kind j) s' w' (kind_lt j) Hs' P1) as [W1 W3]. destruct (step_spec i s j s' Hs E) as [Ls _].
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
  intros [L V] C. destruct (good_pieces _ _ _ _ OK (kind i) k (kind_lt i) V) as [PV P]. cbn [piece] in C.
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
  destruct (good_homes _ _ _ _ OK (kind 0) (kind_lt 0)) as [k [x [Hk [I [P [NP NJ]]]]]]. change (nth (kind 0) system (Patch [] [] [])) with (patch_of 0%nat) in *.
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
