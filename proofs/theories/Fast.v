(** * The same checks at linear cost

    Checker.v looks up vertices and mates in lists, which costs time proportional to the
    list for each of them.  Here both are in binary tries, valences are counted once, and
    long lists are traversed by tail recursion.  [fast_ok] says that "true" here implies
    "true" there; no theorem needs more. *)
Require Import Reals NArith Nnat ZArith List Bool Lia FMapPositive.
From Acutile Require Import Statement Tetrahedra Degree Domain Bounds Checker Keys.
Import ListNotations.
Local Open Scope nat_scope.

(** ** Tables and tail-recursive traversal *)
Section Table.
Context {X : Type}.
Fixpoint fill (p : positive) (l : list X) (m : PositiveMap.t X) : PositiveMap.t X :=
  match l with [] => m | x :: l => fill (Pos.succ p) l (PositiveMap.add p x m) end.
Definition tabulate (l : list X) : PositiveMap.t X := fill 1%positive l (PositiveMap.empty X).
Definition entry (m : PositiveMap.t X) (k : N) : option X := PositiveMap.find (N.succ_pos k) m.
Lemma find_fill l : forall p m q, PositiveMap.find q (fill p l m) =
  if Pos.ltb q p then PositiveMap.find q m else
  match nth_error l (Pos.to_nat q - Pos.to_nat p) with Some x => Some x | None => PositiveMap.find q m end.
Proof.
  induction l as [|x l IH]; intros p m q; cbn [fill].
  - destruct (Pos.ltb q p); [reflexivity|]. destruct (Pos.to_nat q - Pos.to_nat p); reflexivity.
  - rewrite IH. destruct (Pos.ltb_spec q (Pos.succ p)) as [L|L], (Pos.ltb_spec q p) as [L'|L'].
    + rewrite PositiveMap.gso; [reflexivity|lia].
    + assert (q = p) as -> by lia. rewrite PositiveMap.gss, Nat.sub_diag. reflexivity.
    + lia.
    + rewrite PositiveMap.gso by lia. replace (Pos.to_nat q - Pos.to_nat p) with (S (Pos.to_nat q - Pos.to_nat (Pos.succ p))) by lia. reflexivity.
Qed.
Lemma entry_tabulate l k : entry (tabulate l) k = nth_error l (N.to_nat k).
Proof.
  unfold entry, tabulate. rewrite find_fill. destruct (Pos.ltb_spec (N.succ_pos k) 1) as [L|_]; [lia|].
  replace (Pos.to_nat (N.succ_pos k) - Pos.to_nat 1) with (N.to_nat k) by (destruct k; simpl; lia).
  rewrite PositiveMap.gempty. destruct (nth_error l (N.to_nat k)); reflexivity.
Qed.
End Table.

Definition fast_map {X Y} (f : X -> Y) (l : list X) : list Y := rev_append (fold_left (fun acc x => f x :: acc) l []) [].
Lemma fast_map_eq {X Y} (f : X -> Y) l : fast_map f l = map f l.
Proof.
  unfold fast_map. rewrite rev_append_rev, app_nil_r.
  assert (H : forall acc, fold_left (fun acc x => f x :: acc) l acc = rev (map f l) ++ acc).
  { induction l as [|x l IH]; intros acc; cbn [fold_left map rev]; auto. rewrite IH, <- app_assoc. reflexivity. }
  rewrite H, app_nil_r. apply rev_involutive.
Qed.
Definition fast_sum {X Y} (f : X -> Y -> Y) (z : Y) (l : list X) : Y := fold_left (fun s x => f x s) (rev_append l []) z.
Lemma fast_sum_eq {X Y} (f : X -> Y -> Y) z l : fast_sum f z l = fold_right f z l.
Proof. unfold fast_sum. rewrite rev_append_rev, app_nil_r, <- (rev_involutive l), fold_left_rev_right, rev_involutive. reflexivity. Qed.
Fixpoint both {X Y} (f : X -> Y -> bool) (xs : list X) (ys : list Y) : bool :=
  match xs, ys with x :: xs, y :: ys => if f x y then both f xs ys else false | [], [] => true | _, _ => false end.
Lemma both_map {X Y} (f : X -> Y -> bool) (g : X -> Y) xs : both f xs (map g xs) = forallb (fun x => f x (g x)) xs.
Proof. induction xs as [|x xs IH]; cbn; auto. rewrite IH. destruct (f x (g x)); auto. Qed.
Fixpoint either {X Y} (f : X -> Y -> bool) (xs : list X) (ys : list Y) : bool :=
  match xs, ys with x :: xs, y :: ys => if f x y then true else either f xs ys | _, _ => false end.
Lemma either_map {X Y} (f : X -> Y -> bool) (g : X -> Y) xs : either f xs (map g xs) = existsl (fun x => f x (g x)) xs.
Proof. induction xs as [|x xs IH]; cbn; auto. rewrite IH. reflexivity. Qed.

(** ** Valences, counted once *)
Definition tally := PositiveMap.t (list ((N * Z3) * N)).
Fixpoint bump (e : N * Z3) (l : list ((N * Z3) * N)) : list ((N * Z3) * N) :=
  match l with [] => [(e, 1%N)] | (e', n) :: l => if end_eqb e e' then (e', N.succ n) :: l else (e', n) :: bump e l end.
Fixpoint count_in (e : N * Z3) (l : list ((N * Z3) * N)) : N :=
  match l with [] => 0%N | (e', n) :: l => if end_eqb e e' then n else count_in e l end.
Definition ends (v : N) (m : tally) := match PositiveMap.find (N.succ_pos v) m with Some l => l | None => [] end.
Definition count_of (m : tally) (k : key) : N := count_in (snd k) (ends (fst k) m).
Definition add_key (m : tally) (k : key) : tally := PositiveMap.add (N.succ_pos (fst k)) (bump (snd k) (ends (fst k) m)) m.
Definition tallied (ts : list ctet) : tally := fold_left (fun m t => fold_left add_key (keys t) m) ts (PositiveMap.empty _).

Lemma count_bump e e' l : count_in e (bump e' l) = if end_eqb e e' then N.succ (count_in e l) else count_in e l.
Proof.
  induction l as [|[f n] l IH]; cbn [bump count_in].
  - destruct (end_eqb e e'); reflexivity.
  - destruct (end_eqb e' f) eqn:E; cbn [count_in].
    + apply end_eqb_t in E. subst f. destruct (end_eqb e e'); reflexivity.
    + destruct (end_eqb e f) eqn:F; [|exact IH]. apply end_eqb_t in F. subst f.
      destruct (end_eqb e e') eqn:G; [|reflexivity]. apply end_eqb_t in G. subst e'.
      rewrite (proj2 (end_eqb_t e e) eq_refl) in E. discriminate.
Qed.
Lemma count_add_key m k k' : count_of (add_key m k') k = if keqb k k' then N.succ (count_of m k) else count_of m k.
Proof.
  unfold count_of, add_key, keqb. unfold ends at 1. destruct (N.eqb_spec (fst k) (fst k')) as [E|E]; cbn [andb].
  - rewrite E, PositiveMap.gss. apply count_bump.
  - rewrite PositiveMap.gso; [reflexivity|]. intros X. apply E.
    apply (f_equal Npos) in X. rewrite !N.succ_pos_spec in X. apply N.succ_inj; auto.
Qed.
Lemma count_keys ks : forall m k, count_of (fold_left add_key ks m) k = (N.of_nat (length (filter (keqb k) ks)) + count_of m k)%N.
Proof.
  induction ks as [|a ks IH]; intros m k; cbn [fold_left filter]; auto.
  rewrite IH, count_add_key. destruct (keqb k a); cbn [length]; lia.
Qed.
Lemma tallied_flat ts : forall m, fold_left (fun m t => fold_left add_key (keys t) m) ts m = fold_left add_key (flat_map keys ts) m.
Proof. induction ts as [|t ts IH]; intros m; cbn [fold_left flat_map]; auto. rewrite fold_left_app. apply IH. Qed.
Lemma count_tallied ts k : count_of (tallied ts) k = N.of_nat (count_key (indexed (flat_map keys ts)) k).
Proof.
  unfold tallied. rewrite tallied_flat, count_keys, count_key_filter. unfold count_of, ends. rewrite PositiveMap.gempty. cbn. lia.
Qed.

(** The three edges at corner i: each is in 5 or 6 tetrahedra, and no two are in 6. *)
Definition five_or_six (n : N) : bool := match n with 5%N | 6%N => true | _ => false end.
Definition is_six (n : N) : bool := match n with 6%N => true | _ => false end.
Definition tcp_corner (m : tally) (t : ctet) (i j k l : nat) : bool :=
  let a := count_of m (edge_key (qx t i) (qx t j)) in
  let b := count_of m (edge_key (qx t i) (qx t k)) in
  let c := count_of m (edge_key (qx t i) (qx t l)) in
  five_or_six a && five_or_six b && five_or_six c &&
  negb (is_six a && is_six b) && negb (is_six a && is_six c) && negb (is_six b && is_six c).
Definition tcp_tetrahedron (m : tally) (t : ctet) : bool :=
  tcp_corner m t 0 1 2 3 && tcp_corner m t 1 0 2 3 && tcp_corner m t 2 0 1 3 && tcp_corner m t 3 0 1 2.
Definition fast_tcp (ts : list ctet) : bool := let m := tallied ts in forallb (tcp_tetrahedron m) ts.

Lemma five_or_six_of n : five_or_six (N.of_nat n) = Nat.eqb n 5 || Nat.eqb n 6.
Proof. do 8 (destruct n as [|n]; [reflexivity|]). cbn [Nat.eqb orb]. replace (N.of_nat (S (S (S (S (S (S (S (S n)))))))))%N with (8 + N.of_nat n)%N by lia. destruct (N.of_nat n) as [|p]; [reflexivity|]. destruct p as [[[p|p|]|[p|p|]|]|[[p|p|]|[p|p|]|]|]; cbn; try reflexivity; destruct p; reflexivity. Qed.
Lemma is_six_of n : is_six (N.of_nat n) = Nat.eqb n 6.
Proof. do 8 (destruct n as [|n]; [reflexivity|]). cbn [Nat.eqb orb]. replace (N.of_nat (S (S (S (S (S (S (S (S n)))))))))%N with (8 + N.of_nat n)%N by lia. destruct (N.of_nat n) as [|p]; [reflexivity|]. destruct p as [[[p|p|]|[p|p|]|]|[[p|p|]|[p|p|]|]|]; cbn; try reflexivity; destruct p; reflexivity. Qed.
Lemma fast_tcp_ok ts : fast_tcp ts = true -> chk_tcp ts = true.
Proof.
  unfold fast_tcp, chk_tcp. cbv zeta. rewrite !forallb_forall. intros H t It. specialize (H t It).
  unfold tcp_tetrahedron, tcp_corner in H. cbv zeta in H. rewrite !count_tallied, !five_or_six_of, !is_six_of in H.
  set (m := indexed (flat_map keys ts)) in *. clearbody m. cbn [forallb pairs4 triples4 fst snd].
  rewrite !andb_true_iff in H. repeat match goal with X : _ /\ _ |- _ => destruct X end.
  repeat match goal with X : ?b = true |- _ => rewrite X; clear X end. reflexivity.
Qed.

Section Ring.
Variables (A : Type) (aadd asub amul : A -> A -> A) (aofZ : Z -> A) (alt ale : A -> A -> bool).
Notation v3 := (v3 A).
Notation ktet := (ktet A).
Notation vadd := (vadd A aadd).
Notation vofZ := (vofZ A aofZ).
Notation vzero := (vzero A aofZ).
Notation zero := (zero A aofZ).
Notation kpos := (kpos A aadd aofZ).
Notation chk_vol := (chk_vol A aadd asub amul aofZ alt).
Notation on_boundary := (on_boundary A aadd amul aofZ ale).
Notation kvolume := (kvolume A aadd asub amul aofZ).
Notation kD := (kD A aadd asub amul).
Notation ka := (ka A).
Notation kb := (kb A).
Notation kc := (kc A).
Notation kd := (kd A).

(** ** Positions *)
Definition fast_pos (den : Z) (vm : PositiveMap.t v3) (q : corner) : v3 :=
  vadd (match entry vm (fst q) with Some v => v | None => vzero end)
       (match snd q with (Z0, Z0, Z0) => V3 A zero zero zero | n => vofZ den n end).
Definition fast_kpos den vm t := KT A (fast_pos den vm (q0 t)) (fast_pos den vm (q1 t)) (fast_pos den vm (q2 t)) (fast_pos den vm (q3 t)).
Lemma fast_pos_eq den vs q : fast_pos den (tabulate vs) q = pos A aadd aofZ den vs q.
Proof.
  unfold fast_pos, pos. rewrite entry_tabulate, <- nth_default_eq. unfold nth_default. f_equal.
  destruct (snd q) as [[[|x|x] [|y|y]] [|z|z]]; auto. cbn. rewrite Z.mul_0_r. reflexivity.
Qed.
Lemma fast_kpos_eq den vs t : fast_kpos den (tabulate vs) t = kpos den vs t.
Proof. unfold fast_kpos, Checker.kpos. rewrite !fast_pos_eq. reflexivity. Qed.

(** ** The pairing *)
Definition fast_mate (r : nat) (Hs : list (khalf A)) (tm : PositiveMap.t ctet) (k : N) (t : ctet) (kt : ktet) (i : nat) : bool :=
  match mt t i with
  | None => on_boundary Hs kt i
  | Some (k', i', d) =>
    N.ltb i' 4 && latb r d &&
    match entry tm k' with
    | None => false
    | Some t' => meqb (mt t' (N.to_nat i')) (k, N.of_nat i, zopp3 d) && codd d (cfc t i) (cfc t' (N.to_nat i'))
    end
  end.
Fixpoint fast_mates r Hs tm (k : N) (ts : list ctet) (kts : list ktet) : bool :=
  match ts, kts with
  | t :: ts, kt :: kts => if forallb (fast_mate r Hs tm k t kt) I4 then fast_mates r Hs tm (N.succ k) ts kts else false
  | [], [] => true
  | _, _ => false
  end.
Lemma fast_mates_eq r Hs all p ts : forall k,
  fast_mates r Hs (tabulate all) k ts (map p ts) = chk_mates A aadd amul aofZ ale r Hs all p (N.to_nat k) ts.
Proof.
  induction ts as [|t ts IH]; intros k; cbn [fast_mates map chk_mates]; auto.
  rewrite IH, N2Nat.inj_succ.
  assert (E : forall i, fast_mate r Hs (tabulate all) k t (p t) i = chk_mate A aadd amul aofZ ale r Hs all (N.to_nat k) t (p t) i).
  { intros i. unfold fast_mate, chk_mate. destruct (mt t i) as [[[k' i'] d]|]; auto. rewrite entry_tabulate, N2Nat.id. reflexivity. }
  cbn [forallb I4]. rewrite !E. destruct (_ && _); reflexivity.
Qed.

(** ** The covering condition, Delaunay *)
Definition fast_volume (kts : list ktet) : A := fast_sum (fun t s => aadd (kD (ka t) (kb t) (kc t) (kd t)) s) zero kts.
Definition fast_cover (c : cert A) (kts : list ktet) : bool :=
  let l := unit_cell A aadd asub amul aofZ alt c in
  match c_tets A c with [] => false | _ => true end &&
  forallb (chk_inside A aadd amul aofZ alt ale l) (c_domain A c) && forallb (chk_unit A aofZ ale (c_den A c) (c_rank A c)) l &&
  chk_apart A aadd asub amul aofZ ale l l && is_zero A aofZ ale (asub (fast_volume kts) (kvolume l)).
Definition fast_power (less : A -> A -> bool) g den (km : PositiveMap.t ktet) (t : ctet) (kt : ktet) (i : nat) : bool :=
  match mt t i with
  | None => true
  | Some (k', i', d) =>
    match entry km k' with
    | None => false
    | Some kt' => less (kpower A aadd asub amul g kt (vadd (kvx A kt' (N.to_nat i')) (vofZ den d))) zero
    end
  end.
Definition fast_delaunay (less : A -> A -> bool) (c : cert A) (kts : list ktet) (km : PositiveMap.t ktet) : bool :=
  both (fun t kt => forallb (fast_power less (c_gram A c) (c_den A c) km t kt) I4) (c_tets A c) kts.
Lemma fast_delaunay_eq less c : fast_delaunay less c (positions A aadd aofZ c) (tabulate (positions A aadd aofZ c)) = chk_delaunay A aadd asub amul aofZ less c.
Proof.
  unfold fast_delaunay, chk_delaunay. unfold positions at 2. rewrite both_map. cbv zeta.
  assert (F : forall X (f g : X -> bool) l, (forall x, f x = g x) -> forallb f l = forallb g l).
  { intros X f g l E. induction l; cbn; auto. rewrite E, IHl. reflexivity. }
  apply F. intros t. apply F. intros i. unfold fast_power, chk_power.
  destruct (mt t i) as [[[k' i'] d]|]; auto. rewrite entry_tabulate. reflexivity.
Qed.
Definition fast_inside_at (c : cert A) (km : PositiveMap.t ktet) (kt : ktet) (m : mref) : bool :=
  match m with
  | None => false
  | Some (k', i', d) =>
    match entry km k' with
    | None => false
    | Some kt' => N.ltb i' 4 && latb (c_rank A c) d &&
      alt zero (kpower A aadd asub amul (c_gram A c) kt (vadd (kvx A kt' (N.to_nat i')) (vofZ (c_den A c) d)))
    end
  end.
Definition fast_not_delaunay (c : cert A) (kts : list ktet) (km : PositiveMap.t ktet) : bool :=
  either (fun t kt => existsl (fun i => fast_inside_at c km kt (mt t i)) I4) (c_tets A c) kts.
Lemma fast_not_delaunay_eq c : fast_not_delaunay c (positions A aadd aofZ c) (tabulate (positions A aadd aofZ c)) = chk_not_delaunay A aadd asub amul aofZ alt c.
Proof.
  unfold fast_not_delaunay, chk_not_delaunay. unfold positions at 2. rewrite either_map. cbv zeta.
  assert (F : forall X (f g : X -> bool) l, (forall x, f x = g x) -> existsl f l = existsl g l).
  { intros X f g l E. induction l; cbn; auto. rewrite E, IHl. reflexivity. }
  apply F. intros t. apply F. intros i. unfold fast_inside_at, chk_inside_at.
  destruct (mt t i) as [[[k' i'] d]|]; auto. rewrite entry_tabulate. reflexivity.
Qed.

(** ** All checks *)
Definition fast_statement (c : cert A) (kts : list ktet) (km : PositiveMap.t ktet) (s : cstatement A) : bool :=
  let g := c_gram A c in
  let all f := forallb (fun t => forallb (on_edge A f) (six A t)) kts in
  let angles sg p q o := on_edge A (chk_angle A aadd asub amul aofZ alt ale g sg p q o) in
  match s with
  | CAcute _ => all (chk_acute A aadd asub amul aofZ alt g)
  | CNonobtuse _ => all (chk_nonobtuse A aadd asub amul aofZ ale g)
  | CLargestDihedralAngle _ rel sg p q =>
    chk_bound A aofZ alt ale sg p q && related rel (fun t => test_largest (angles sg p q) (six A t)) kts
  | CSmallestDihedralAngle _ rel sg p q =>
    chk_bound A aofZ alt ale sg p q && related rel (fun t => test_smallest (angles sg p q) (six A t)) kts
  | CSquaredRadiusEdgeRatio _ rel p q =>
    Z.ltb 0 q && alt zero p && related rel (chk_radius A aadd asub amul aofZ alt ale g p q) kts
  | CUncrossed _ n p q part => Z.ltb 0 q && forallb (chk_uncrossed A aadd asub amul aofZ ale part (c_den A c) (c_rank A c) n p q) kts
  | CDelaunay _ => fast_delaunay alt c kts km
  | CWeaklyDelaunay _ => fast_delaunay ale c kts km
  | CNotDelaunay _ => fast_not_delaunay c kts km
  | CTCP _ => Nat.eqb (c_rank A c) 3 && fast_tcp (c_tets A c)
  end.
Definition fast_positions (c : cert A) : list ktet := let vm := tabulate (c_verts A c) in fast_map (fast_kpos (c_den A c) vm) (c_tets A c).
Definition fast_tiling (c : cert A) (kts : list ktet) : bool :=
  let r := c_rank A c in
  Z.ltb 0 (c_den A c) && Nat.leb r 3 &&
  forallb chk_vol kts &&
  forallb (fun H => chk_invariant A aofZ ale r H && chk_inside A aadd amul aofZ alt ale kts H) (c_domain A c) &&
  chk_polytope A aadd asub amul aofZ alt ale c kts &&
  (let tm := tabulate (c_tets A c) in fast_mates r (c_domain A c) tm 0%N (c_tets A c) kts) &&
  fast_cover c kts &&
  chk_gram A aadd asub amul aofZ alt (c_gram A c).
Definition fast_check (c : cert A) (ss : list (cstatement A)) : bool :=
  let kts := fast_positions c in
  if fast_tiling c kts then let km := tabulate kts in forallb (fast_statement c kts km) ss else false.

Lemma fast_positions_eq c : fast_positions c = positions A aadd aofZ c.
Proof.
  unfold fast_positions, positions. rewrite fast_map_eq. apply map_ext. intros. apply fast_kpos_eq.
Qed.
Lemma fast_tiling_eq c : fast_tiling c (positions A aadd aofZ c) = check_tiling A aadd asub amul aofZ alt ale c.
Proof.
  unfold fast_tiling, check_tiling. cbv zeta.
  assert (M : fast_mates (c_rank A c) (c_domain A c) (tabulate (c_tets A c)) 0%N (c_tets A c) (positions A aadd aofZ c) =
    chk_mates A aadd amul aofZ ale (c_rank A c) (c_domain A c) (c_tets A c) (kpos (c_den A c) (c_verts A c)) 0 (c_tets A c)).
  { unfold positions. apply (fast_mates_eq _ _ _ _ _ 0%N). }
  rewrite M. unfold fast_cover, chk_cover, fast_volume. rewrite fast_sum_eq. reflexivity.
Qed.
Lemma fast_statement_ok c s : fast_statement c (positions A aadd aofZ c) (tabulate (positions A aadd aofZ c)) s = true ->
  check_statement A aadd asub amul aofZ alt ale c s = true.
Proof.
  destruct s; cbn [fast_statement check_statement]; cbv zeta; auto.
  - rewrite fast_delaunay_eq. auto.
  - rewrite fast_delaunay_eq. auto.
  - rewrite fast_not_delaunay_eq. auto.
  - rewrite !andb_true_iff. intros [H1 H2]. split; [exact H1|apply fast_tcp_ok, H2].
Qed.
Theorem fast_ok c ss : fast_check c ss = true -> check A aadd asub amul aofZ alt ale c ss = true.
Proof.
  unfold fast_check, check. cbv zeta. rewrite fast_positions_eq, fast_tiling_eq.
  destruct (check_tiling A aadd asub amul aofZ alt ale c); [|discriminate]. cbn [andb].
  rewrite !forallb_forall. intros H s Hs. apply fast_statement_ok, H, Hs.
Qed.
End Ring.
