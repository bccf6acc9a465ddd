(** * The theorem about bytes

    [accepts] takes the bytes of a certificate.  If it returns a claim, then the bytes are
    those of a certificate with this claim, and the claim is true. *)
From Coq Require Import Reals Lra Lia NArith ZArith List Bool String Permutation FunctionalExtensionality.
From Coq Require Import Init.Byte.
From Coq Require Strings.Byte.
From Acutile Require Import Statement PlaneStatement Tetrahedra Degree Domain Checker PlaneChecker Soundness PlaneSoundness Keys Numbers
  Fast Denote Read Pairing Format.
Import ListNotations.
Local Open Scope nat_scope.

(** ** Printing by tail recursion *)
Definition count_all {X} (l : list X) : N := fold_left (fun n _ => N.succ n) l 0%N.
Lemma count_all_eq {X} (l : list X) : count_all l = N.of_nat (List.length l).
Proof.
  unfold count_all. assert (H : forall n, fold_left (fun n (_ : X) => N.succ n) l n = (N.of_nat (List.length l) + n)%N).
  { induction l as [|x l IH]; intros n; cbn [fold_left List.length]; [lia|]. rewrite IH. lia. }
  rewrite H. lia.
Qed.
Fixpoint onto (i : item) (t : bytes) : bytes :=
  match i with
  | Array l => head 4 (count_all l) ++ fold_right onto t l
  | Int z => encode (Int z) ++ t
  | Text s => encode (Text s) ++ t
  end.
Fixpoint onto_eq (i : item) : forall t, onto i t = encode i ++ t.
Proof.
  destruct i as [z|s|l]; intros t; [reflexivity|reflexivity|].
  cbn [onto encode]. rewrite count_all_eq, <- app_assoc. f_equal.
  induction l as [|i l IH]; [reflexivity|]. cbn [fold_right flat_map]. rewrite IH, onto_eq, app_assoc. reflexivity.
Qed.
Definition long_array {X} (f : X -> item) (l : list X) (t : bytes) : bytes :=
  head 4 (count_all l) ++ fold_left (fun t x => onto (f x) t) (rev_append l []) t.
Lemma long_array_eq {X} (f : X -> item) l t : long_array f l t = encode (Array (map f l)) ++ t.
Proof.
  unfold long_array. cbn [encode]. rewrite count_all_eq, map_length, <- app_assoc. f_equal.
  rewrite rev_append_rev, app_nil_r, fold_left_rev_right || rewrite rev_append_rev, app_nil_r, <- fold_left_rev_right, rev_involutive.
  induction l as [|x l IH]; [reflexivity|]. cbn [fold_right map flat_map]. rewrite IH, onto_eq, app_assoc. reflexivity.
Qed.
Definition fast_print (c : certificate) : bytes :=
  match c with
  | Tiling k w =>
    head 4 5 ++ encode (Text "acutile-certificate") ++ encode (Int 2) ++ encode (Text "tiling") ++
    onto (claim_item k) (head 4 4 ++ encode (Int (w_denominator w)) ++
    long_array (fun v => Array (map (number_item (over k)) v)) (w_vertices w)
    (long_array (fun b => Array (map corner_item b)) (w_boundary w)
    (long_array row_item (w_rows w) [])))
  end.
Lemma fast_print_eq c : fast_print c = print c.
Proof.
  destruct c as [k w]. unfold fast_print, print, certificate_item, witness_item, points_item.
  rewrite !long_array_eq, onto_eq.
  change (encode (Array [Text "acutile-certificate"; Int 2; Text "tiling"; claim_item k;
    Array [Int (w_denominator w); Array (map (fun v => Array (map (number_item (over k)) v)) (w_vertices w));
      Array (map (fun b => Array (map corner_item b)) (w_boundary w)); Array (map row_item (w_rows w))]]))
  with (head 4 5 ++ encode (Text "acutile-certificate") ++ encode (Int 2) ++ encode (Text "tiling") ++ encode (claim_item k) ++
    (head 4 4 ++ encode (Int (w_denominator w)) ++ encode (Array (map (fun v => Array (map (number_item (over k)) v)) (w_vertices w))) ++
    encode (Array (map (fun b => Array (map corner_item b)) (w_boundary w))) ++ encode (Array (map row_item (w_rows w))) ++ []) ++ []).
  rewrite !app_nil_r. reflexivity.
Qed.
Fixpoint same_bytes (s t : bytes) : bool :=
  match s, t with
  | x :: s, y :: t => if N.eqb (Byte.to_N x) (Byte.to_N y) then same_bytes s t else false
  | [], [] => true
  | _, _ => false
  end.
Lemma same_bytes_eq s : forall t, same_bytes s t = true -> s = t.
Proof.
  induction s as [|x s IH]; intros [|y t]; cbn [same_bytes]; try discriminate; auto.
  destruct (N.eqb_spec (Byte.to_N x) (Byte.to_N y)) as [E|]; [|discriminate]. intros H. apply IH in H. subst t. f_equal.
  apply (f_equal Strings.Byte.of_N) in E. rewrite !Strings.Byte.of_to_N in E. congruence.
Qed.

(** ** The checker on bytes *)
Definition z_fit (x : number) : bool := Nat.eqb (List.length x) 1.
Definition z_in (x : number) : Z := List.hd 0%Z x.
Definition z_proved := proved Z Z.add Z.sub Z.mul idZ Z.ltb Z.leb z_fit z_in.
Definition z_polytope := proper_polytope Z Z.add Z.sub Z.mul idZ Z.ltb Z.leb z_in.
Definition nf_fit (x : number) : bool := true.
Definition nf_in (x : number) : list Z := x.
Definition nf_proved fl e0 es := proved (list Z) ladd lsub (lmul fl) lofZ (lltb e0 es) (lleb e0 es) nf_fit nf_in.
Definition nf_polytope fl e0 es := proper_polytope (list Z) ladd lsub (lmul fl) lofZ (lltb e0 es) (lleb e0 es) nf_in.
Fixpoint same_list (x y : list Z) : bool :=
  match x, y with [], [] => true | a :: x, b :: y => Z.eqb a b && same_list x y | _, _ => false end.
(** The polynomial is monic, and its root is isolated. *)
Definition nf_root (p : list Z) (e0 : encl) (es : list encl) (lo hi d : Z) : bool :=
  same_list p (removelast p ++ [1%Z]) && isolated (removelast p) e0 es (Encl lo hi d).
(** The enclosures of the root: a hint, computed once. *)
Definition hint := (encl * list encl)%type.
Definition hint_for (f : field) : hint :=
  match f with Rationals => (Encl 0 0 1, []) | Root p lo hi d => enclosures p lo hi d end.
Definition proves (h : hint) (k : tiling_claim) (w : tiling_witness) : bool :=
  match over k with
  | Rationals => z_proved k w
  | Root p lo hi d =>
    let (e0, es) := h in
    if nf_root p e0 es lo hi d then nf_proved (removelast p) e0 es k w else false
  end.
(** The polytope is as the format demands; no theorem needs it. *)
Definition polytope_ok (h : hint) (k : tiling_claim) (w : tiling_witness) : bool :=
  match over k with
  | Rationals => z_polytope k w
  | Root p lo hi d => let (e0, es) := h in nf_polytope (removelast p) e0 es k w
  end.
(** Over a field a check may fail because a sign is open: a value that is zero although its coefficients
    are not, over a reducible polynomial, or one too close to zero.  If the checks succeed once open signs
    count as favourable, the certificate is declined, and not rejected. *)
Definition is_open e0 es x y : bool := negb (lleb e0 es x y) && negb (lltb e0 es y x).
Definition maybe_less e0 es x y : bool := lltb e0 es x y || is_open e0 es x y.
Definition maybe_at_most e0 es x y : bool := lleb e0 es x y || is_open e0 es x y.
Definition why_not (h : hint) (k : tiling_claim) (w : tiling_witness) : refusal :=
  match over k with
  | Rationals => Rejected "the checks"
  | Root p lo hi d =>
    let (e0, es) := h in let fl := removelast p in
    let less := maybe_less e0 es in let at_most := maybe_at_most e0 es in
    if proper_polytope (list Z) ladd lsub (lmul fl) lofZ less at_most nf_in k w &&
       proved (list Z) ladd lsub (lmul fl) lofZ less at_most nf_fit nf_in k w
    then Declined "a sign that 256 halvings of the root leave open" else Rejected "the checks"
  end.
Definition bits_agree (k : tiling_claim) (w : tiling_witness) : bool :=
  if existsb is_tcp (sentences k) then sixes_agree (Pairing.tetrahedra (fast_map row_corners (w_rows w))) (w_rows w) else true.
Definition judged (c : certificate) : verdict :=
  match c with
  | Tiling k w =>
    match claim_refusal k with Some r => Refused r | None =>
    match witness_refusal k w with Some r => Refused r | None =>
      if denominators_agree k w then
        let h := hint_for (over k) in
        if (if polytope_ok h k w then proves h k w else false) then
          if bits_agree k w then Accepted (claim_of c) else Refused (Rejected "the bits of valence 6")
        else Refused (why_not h k w)
      else Refused (Rejected "the denominator of the domain")
    end end
  end.
Local Open Scope string_scope.
(** The statement about planes that no simplex crosses, which has no theorem here. *)
Definition names_a_plane (i : item) : bool :=
  match i with Array (Text name :: _) => String.eqb name "uncrossed plane" | _ => false end.
Definition unreadable (k : item) : refusal :=
  match k with
  | Array [_; _; _; _; Array statements] =>
    if existsb names_a_plane statements then Declined "the statement: this checker has no theorem about uncrossed planes"
    else Malformed "not of the shape of a certificate"
  | _ => Malformed "not of the shape of a certificate"
  end.
Definition judge (s : bytes) : verdict :=
  match items s with
  | Complete (Array (Text format :: Int version :: rest)) =>
    if negb (String.eqb format "acutile-certificate") then Refused (Malformed "not an acutile certificate")
    else if negb (Z.eqb version 2) then Refused (Declined "the version")
    else match rest with
    | [Text kind; k; w] =>
      if negb (String.eqb kind "tiling") then Refused (Declined ("the kind: this checker has theorems about tilings only")) else
      match read_tiling k w with
      | None => Refused (unreadable k)
      | Some c => if same_bytes s (fast_print c) then judged c else Refused (Malformed "not the canonical bytes")
      end
    | _ => Refused (Malformed "not an acutile certificate")
    end
  | TooLong => Refused (Declined "an integer of more than 1000 digits")
  | _ => Refused (Malformed "not an acutile certificate in CBOR")
  end.
Definition accepts (s : bytes) : option claim := match judge s with Accepted k => Some k | Refused _ => None end.
Local Close Scope string_scope.

(** ** What the data of the checker denote *)
Local Open Scope R_scope.
Section Link.
Variables (A : Type) (aadd asub amul : A -> A -> A) (aofZ : Z -> A) (alt ale : A -> A -> bool) (fit : number -> bool) (inn : number -> A).
Variables (phi : A -> R) (a : R).
Hypothesis phi_Z : forall z, phi (aofZ z) = IZR z.
Hypothesis inn_ok : forall x, fit x = true -> phi (inn x) = value a x.
Variables (k : tiling_claim) (w : tiling_witness).

Lemma value_scaled f x : value a (map (Z.mul f) x) = IZR f * value a x.
Proof. induction x as [|c x IH]; cbn [map value]; [ring|]. rewrite mult_IZR, IH. ring. Qed.
Lemma map_repeat {X Y} (f : X -> Y) x n : map f (repeat x n) = repeat (f x) n.
Proof. induction n; cbn; congruence. Qed.
Lemma scaled_points : denominators_agree k w = true -> (0 < w_denominator w)%Z ->
  polytope_points k a = map (map (fun x => value a x / IZR (w_denominator w))) (scaled k w (rank k)).
Proof.
  unfold denominators_agree, polytope_points, scaled. destruct (polytope_of (region_of k)) as [P|]; [|reflexivity].
  rewrite Z.eqb_eq. intros E HD. rewrite map_map. apply map_ext. intros v. rewrite map_app, map_repeat, map_map. f_equal.
  - f_equal. cbn. field. apply IZR_lt in HD. lra.
  - apply map_ext. intros x. rewrite value_scaled, E, mult_IZR.
    assert (NZ : IZR (factor w P * p_denominator P) <> 0) by (apply IZR_lt in HD; rewrite <- E; lra).
    rewrite mult_IZR in NZ. apply Rmult_neq_0_reg in NZ. field. tauto.
Qed.
Lemma both_nth {X Y} (f : X -> Y -> bool) xs : forall ys, both f xs ys = true -> forall j,
  match nth_error xs j, nth_error ys j with Some x, Some y => f x y = true | None, None => True | _, _ => False end.
Proof.
  induction xs as [|x xs IH]; intros [|y ys]; cbn [both]; try discriminate.
  - intros _ [|j]; exact I.
  - destruct (f x y) eqn:E; [|discriminate]. intros H [|j]; cbn; [exact E|apply IH, H].
Qed.
Lemma both_length {X Y} (f : X -> Y -> bool) xs : forall ys, both f xs ys = true -> List.length xs = List.length ys.
Proof.
  induction xs as [|x xs IH]; intros [|y ys]; cbn [both]; try discriminate; auto.
  destruct (f x y); [|discriminate]. intros H. cbn. f_equal. apply IH, H.
Qed.
Lemma states_In : states_tiling k = true -> In FaceToFaceTiling (sentences k).
Proof. unfold states_tiling. rewrite existsb_exists. intros [s [I H]]. destruct s; try discriminate. exact I. Qed.

(** *** Space *)
Section Space.
Variable ts : list ctet.
Hypothesis SHAPE : shape3 fit k w ts = true.
Lemma shape3_all : gram_shape fit k = true /\ (forall v, In v (w_vertices w) -> triple fit v = true) /\
  (forall v, In v (scaled k w (rank k)) -> triple fit v = true) /\ (0 < w_denominator w)%Z /\ denominators_agree k w = true /\
  is_region k = false /\ In FaceToFaceTiling (sentences k) /\ (forall s, In s (sentences k) -> fit_sentence fit s = true) /\
  both (same_row (N.of_nat (List.length (w_vertices w)))) (w_rows w) ts = true.
Proof.
  pose proof SHAPE as H. unfold shape3 in H. rewrite !andb_true_iff, !forallb_forall, negb_true_iff, Z.ltb_lt in H.
  decompose [and] H. repeat split; auto. apply states_In; auto.
Qed.
Notation c := (data3 A aadd asub amul aofZ ale inn k w ts).
Definition rows_as_simplices (j : nat) : simplex :=
  match nth_error (w_rows w) j with Some r => map (coordinates a w) (fst r) | None => [] end.
Lemma triple_cases v : triple fit v = true -> exists x y z, v = [x; y; z] /\ fit x = true /\ fit y = true /\ fit z = true.
Proof. destruct v as [|x [|y [|z [|? ?]]]]; try discriminate. cbn. rewrite !andb_true_iff. intros [[? ?] ?]. eauto 8. Qed.
Lemma corner_link l1 l2 l3 q : N.ltb (fst q) (N.of_nat (List.length (w_vertices w))) = true ->
  dcorner A aofZ phi c l1 l2 l3 (corner3 q) = at_coordinates l1 l2 l3 (as_point (coordinates a w q)).
Proof.
  rewrite N.ltb_lt. intros L. destruct shape3_all as [_ [V _]].
  assert (I : In (nth (N.to_nat (fst q)) (w_vertices w) []) (w_vertices w)) by (apply nth_In; lia).
  unfold dcorner, coordinates. cbn [corner3 fst snd data3 faces_cert c_verts c_den].
  change (Checker.vzero A aofZ) with (vec3 A aofZ inn []). rewrite map_nth.
  destruct (triple_cases _ (V _ I)) as [x [y [z [E [X [Y Z]]]]]]. rewrite E. cbn [vec3 vX vY vZ map].
  rewrite !inn_ok by assumption. destruct (snd q) as [|s1 [|s2 [|s3 s]]]; cbn [shift3 z30 moved as_point]; rewrite ?Rplus_0_r; reflexivity.
Qed.
Lemma tetrahedra_link l1 l2 l3 : dtet A aofZ phi c l1 l2 l3 = fun j => as_tetrahedron l1 l2 l3 (rows_as_simplices j).
Proof.
  apply functional_extensionality. intros j. destruct shape3_all as [_ [_ [_ [_ [_ [_ [_ [_ B]]]]]]]].
  pose proof (both_nth _ _ _ B j) as H. unfold dtet, rows_as_simplices. change (c_tets A c) with ts.
  destruct (nth_error (w_rows w) j) as [r|], (nth_error ts j) as [t|]; try contradiction; [|reflexivity].
  unfold same_row in H. destruct (fst r) as [|q0' [|q1' [|q2' [|q3' [|? ?]]]]]; try discriminate.
  cbn [forallb] in H. rewrite !andb_true_iff, !ceqb_t in H. destruct H as [[[[[R0 [R1 [R2 [R3 _]]]] E0] E1] E2] E3].
  rewrite <- E0, <- E1, <- E2, <- E3, !corner_link by assumption. reflexivity.
Qed.
Lemma gram_link : dimension k = 3%nat -> dgram A phi c = gram_of k a.
Proof.
  intros D. destruct shape3_all as [G _]. unfold gram_shape in G. rewrite D in G. unfold dgram, gram_of. cbn [data3 faces_cert c_gram]. unfold gram3.
  destruct (gram_rows k) as [|[|g11 [|g12 [|g13 [|? ?]]]] [|[|g22 [|g23 [|? ?]]] [|[|g33 [|? ?]] [|? ?]]]]; try discriminate.
  cbn [forallb] in G. rewrite !andb_true_iff in G. decompose [and] G. cbn [k11 k22 k33 k12 k13 k23]. rewrite !inn_ok by assumption. reflexivity.
Qed.
Lemma domain_link l1 l2 l3 : ddomain A phi c l1 l2 l3 = domain l1 l2 l3 (rank k) (map as_point (polytope_points k a)).
Proof.
  unfold ddomain. cbn [data3 faces_cert c_rank c_polytope]. f_equal.
  destruct shape3_all as [_ [_ [S [HD [DA _]]]]]. rewrite scaled_points by assumption. rewrite !map_map. apply map_ext_in. intros v Hv.
  destruct (triple_cases _ (S v Hv)) as [x [y [z [-> [X [Y Z]]]]]]. unfold dpoint. cbn [data3 faces_cert c_den vec3 vX vY vZ map as_point].
  rewrite !inn_ok by assumption. reflexivity.
Qed.
Theorem space_link : dimension k = 3%nat ->
  (exists l1 l2 l3, has_gram (dgram A phi c) l1 l2 l3) ->
  (forall l1 l2 l3, has_gram (dgram A phi c) l1 l2 l3 ->
    face_to_face_tiling l1 l2 l3 (c_rank A c) (ddomain A phi c l1 l2 l3) (List.length (c_tets A c)) (dtet A aofZ phi c l1 l2 l3) /\
    forall s, In s (map (dstatement A phi) (statements_of A inn k)) -> holds l1 l2 l3 (c_rank A c) (List.length (c_tets A c)) (dtet A aofZ phi c l1 l2 l3) s) ->
  exists n T, are_rows a w n T /\ holds_of k a n T.
Proof.
  intros D H1 H2. exists (List.length (w_rows w)), rows_as_simplices. split.
  { split; auto. intros j r E. unfold rows_as_simplices. rewrite E. apply Permutation_refl. }
  unfold holds_of. destruct shape3_all as [_ [_ [_ [_ [_ [_ [ST [FS B]]]]]]]]. split; auto. rewrite D, <- (gram_link D). split; auto.
  intros l1 l2 l3 HG s Hs. destruct (H2 l1 l2 l3 HG) as [T HS]. rewrite tetrahedra_link in T, HS. rewrite domain_link in T.
  change (c_rank A c) with (rank k) in T, HS. change (c_tets A c) with ts in T, HS. rewrite <- (both_length _ _ _ B) in T, HS.
  specialize (FS s Hs).
  assert (HS' : forall st, In st (statement_of A inn s) -> holds l1 l2 l3 (rank k) (List.length (w_rows w)) (fun j => as_tetrahedron l1 l2 l3 (rows_as_simplices j)) (dstatement A phi st)).
  { intros st Hst. apply HS, in_map. unfold statements_of. apply in_flat_map. eauto. }
  destruct s as [| | |rel sg p q|rel sg p q|rel p q| | | | |]; cbn [fit_sentence] in FS; try discriminate; cbn [space_sentence]; try exact T;
    specialize (HS' _ (or_introl eq_refl)); cbn [dstatement holds] in HS'; unfold dangle in HS'; rewrite ?inn_ok in HS' by assumption; exact HS'.
Qed.
End Space.

(** *** The plane *)
Section Plane.
Variable ts : list ctri.
Hypothesis SHAPE : shape2 fit k w ts = true.
Lemma shape2_all : gram_shape fit k = true /\ (forall v, In v (w_vertices w) -> pair fit v = true) /\
  (forall v, In v (scaled k w (rank k)) -> pair fit v = true) /\ (0 < w_denominator w)%Z /\ denominators_agree k w = true /\
  is_region k = false /\ In FaceToFaceTiling (sentences k) /\ (forall s, In s (sentences k) -> fit_sentence fit s = true) /\
  both (same_triangle (N.of_nat (List.length (w_vertices w)))) (w_rows w) ts = true.
Proof.
  pose proof SHAPE as H. unfold shape2 in H. rewrite !andb_true_iff, !forallb_forall, negb_true_iff, Z.ltb_lt in H.
  decompose [and] H. repeat split; auto. apply states_In; auto.
Qed.
Notation c := (data2 A aofZ inn k w ts).
Definition corner_place (p : corner2) : list R := coordinates a w (fst p, [fst (snd p); snd (snd p)]).
Definition triangles_as_simplices (j : nat) : simplex :=
  match nth_error ts j with Some t => [corner_place (p0 t); corner_place (p1 t); corner_place (p2 t)] | None => [] end.
Lemma pair_cases v : pair fit v = true -> exists x y, v = [x; y] /\ fit x = true /\ fit y = true.
Proof. destruct v as [|x [|y [|? ?]]]; try discriminate. cbn. rewrite !andb_true_iff. intros [? ?]. eauto 8. Qed.
Lemma vertex2 i : N.ltb i (N.of_nat (List.length (w_vertices w))) = true ->
  exists x y, nth (N.to_nat i) (w_vertices w) [] = [x; y] /\ fit x = true /\ fit y = true.
Proof.
  rewrite N.ltb_lt. intros L. destruct shape2_all as [_ [V _]]. apply pair_cases, V, nth_In. lia.
Qed.
Lemma corner2_link l1 l2 p : N.ltb (fst p) (N.of_nat (List.length (w_vertices w))) = true ->
  dcorner2 A aofZ phi c l1 l2 p = at_coordinates2 l1 l2 (as_point2 (corner_place p)).
Proof.
  intros L. destruct (vertex2 _ L) as [x [y [E [X Y]]]].
  unfold dcorner2, corner_place, coordinates. cbn [data2 e_verts e_den fst snd].
  change (aofZ 0, aofZ 0) with (vec2 A aofZ inn []). rewrite map_nth, E. cbn [vec2 map fst snd moved as_point2].
  rewrite !inn_ok by assumption. reflexivity.
Qed.
Lemma ceqb2_place q p : N.ltb (fst q) (N.of_nat (List.length (w_vertices w))) = true -> ceqb2 q p = true ->
  fst q = fst p /\ corner_place p = coordinates a w q.
Proof.
  intros L. unfold ceqb2. rewrite !andb_true_iff, N.eqb_eq, !Z.eqb_eq. intros [[E F] G]. split; auto.
  unfold corner_place, coordinates. cbn [fst snd]. rewrite <- E, <- F, <- G.
  destruct (vertex2 _ L) as [x [y [-> _]]]. destruct (snd q) as [|s1 [|s2 s]]; cbn; rewrite ?Rplus_0_r; reflexivity.
Qed.
Lemma rows2 j r : nth_error (w_rows w) j = Some r -> exists t, nth_error ts j = Some t /\
  Permutation (triangles_as_simplices j) (map (coordinates a w) (fst r)) /\
  (forall p, In p [p0 t; p1 t; p2 t] -> N.ltb (fst p) (N.of_nat (List.length (w_vertices w))) = true).
Proof.
  intros E. destruct shape2_all as [_ [_ [_ [_ [_ [_ [_ [_ B]]]]]]]]. pose proof (both_nth _ _ _ B j) as H. rewrite E in H.
  unfold triangles_as_simplices. destruct (nth_error ts j) as [t|]; [|contradiction]. exists t. split; auto.
  unfold same_triangle in H. destruct (fst r) as [|b0 [|b1 [|b2 [|? ?]]]]; try discriminate.
  cbn [forallb] in H. rewrite !andb_true_iff, orb_true_iff, !andb_true_iff in H. destruct H as [[[R0 [R1 [R2 _]]] E0] H].
  destruct (ceqb2_place _ _ R0 E0) as [F0 G0]. cbn [map]. rewrite G0.
  destruct H as [[E1 E2]|[E1 E2]]; destruct (ceqb2_place _ _ R1 E1) as [F1 G1], (ceqb2_place _ _ R2 E2) as [F2 G2]; rewrite G1, G2; split.
  - apply Permutation_refl.
  - intros p [<-|[<-|[<-|[]]]]; [rewrite <- F0|rewrite <- F1|rewrite <- F2]; assumption.
  - apply perm_skip, perm_swap.
  - intros p [<-|[<-|[<-|[]]]]; [rewrite <- F0|rewrite <- F2|rewrite <- F1]; assumption.
Qed.
Lemma triangles_link l1 l2 : dtriangle A aofZ phi c l1 l2 = fun j => as_triangle l1 l2 (triangles_as_simplices j).
Proof.
  apply functional_extensionality. intros j. unfold dtriangle. change (e_tris A c) with ts.
  destruct (nth_error (w_rows w) j) as [r|] eqn:E.
  - destruct (rows2 j r E) as [t [ET [_ L]]]. unfold triangles_as_simplices. rewrite ET.
    rewrite !corner2_link by (apply L; simpl; auto). reflexivity.
  - destruct shape2_all as [_ [_ [_ [_ [_ [_ [_ [_ B]]]]]]]]. pose proof (both_nth _ _ _ B j) as H. rewrite E in H.
    unfold triangles_as_simplices. destruct (nth_error ts j); [contradiction|reflexivity].
Qed.
Lemma gram2_link : dimension k = 2%nat -> dgram2 A phi c = gram2_of k a.
Proof.
  intros D. destruct shape2_all as [G _]. unfold gram_shape in G. rewrite D in G. unfold dgram2, gram2_of. cbn [data2 e_gram]. unfold gram2.
  destruct (gram_rows k) as [|[|g11 [|g12 [|? ?]]] [|[|g22 [|? ?]] [|? ?]]]; try discriminate.
  cbn [forallb] in G. rewrite !andb_true_iff in G. decompose [and] G. rewrite !inn_ok by assumption. reflexivity.
Qed.
Lemma domain2_link l1 l2 : ddomain2 A phi c l1 l2 = domain2 l1 l2 (rank k) (map as_point2 (polytope_points k a)).
Proof.
  unfold ddomain2. cbn [data2 e_rank e_polytope]. f_equal.
  destruct shape2_all as [_ [_ [S [HD [DA _]]]]]. rewrite scaled_points by assumption. rewrite !map_map. apply map_ext_in. intros v Hv.
  destruct (pair_cases _ (S v Hv)) as [x [y [-> [X Y]]]]. unfold dpoint2. cbn [data2 e_den vec2 fst snd map as_point2].
  rewrite !inn_ok by assumption. reflexivity.
Qed.
Theorem plane_link : dimension k = 2%nat ->
  (exists l1 l2, has_gram2 (dgram2 A phi c) l1 l2) ->
  (forall l1 l2, has_gram2 (dgram2 A phi c) l1 l2 ->
    edge_to_edge_tiling l1 l2 (e_rank A c) (ddomain2 A phi c l1 l2) (List.length (e_tris A c)) (dtriangle A aofZ phi c l1 l2) /\
    forall s, In s (map (dstatement A phi) (statements_of A inn k)) -> holds2 l1 l2 (e_rank A c) (List.length (e_tris A c)) (dtriangle A aofZ phi c l1 l2) s) ->
  exists n T, are_rows a w n T /\ holds_of k a n T.
Proof.
  intros D H1 H2. exists (List.length (w_rows w)), triangles_as_simplices. split.
  { split; auto. intros j r E. destruct (rows2 j r E) as [t [_ [P _]]]. exact P. }
  unfold holds_of. destruct shape2_all as [_ [_ [_ [_ [_ [_ [ST [FS B]]]]]]]]. split; auto. rewrite D, <- (gram2_link D). split; auto.
  intros l1 l2 HG s Hs. destruct (H2 l1 l2 HG) as [T HS]. rewrite triangles_link in T, HS. rewrite domain2_link in T.
  change (e_rank A c) with (rank k) in T, HS. change (e_tris A c) with ts in T, HS. rewrite <- (both_length _ _ _ B) in T, HS.
  specialize (FS s Hs).
  assert (HS' : forall st, In st (statement_of A inn s) -> holds2 l1 l2 (rank k) (List.length (w_rows w)) (fun j => as_triangle l1 l2 (triangles_as_simplices j)) (dstatement A phi st)).
  { intros st Hst. apply HS, in_map. unfold statements_of. apply in_flat_map. eauto. }
  destruct s as [| | |rel sg p q|rel sg p q|rel p q| | | | |]; cbn [fit_sentence] in FS; try discriminate; cbn [plane_sentence]; try exact T;
    specialize (HS' _ (or_introl eq_refl)); cbn [dstatement holds2] in HS'; unfold dangle in HS'; rewrite ?inn_ok in HS' by assumption; exact HS'.
Qed.
End Plane.
End Link.

(** ** The theorem *)
Lemma same_list_eq x : forall y, same_list x y = true -> x = y.
Proof.
  induction x as [|b x IH]; intros [|c y]; cbn [same_list]; try discriminate; auto.
  rewrite andb_true_iff, Z.eqb_eq. intros [-> H]. f_equal. auto.
Qed.
Lemma z_in_ok x : z_fit x = true -> IZR (z_in x) = value 0 x.
Proof. unfold z_fit, z_in. rewrite Nat.eqb_eq. destruct x as [|b [|? ?]]; try discriminate. intros _. cbn. ring. Qed.
Theorem proves_sound h k w : proves h k w = true ->
  is_region k = false /\ exists a, the_root (over k) a /\ exists n T, are_rows a w n T /\ holds_of k a n T.
Proof.
  unfold proves. destruct (over k) as [|p lo hi d]; intros H.
  - unfold z_proved, proved in H. destruct (dimension k) as [|[|[|[|?]]]] eqn:D; try discriminate.
    + unfold proved2 in H. set (ts := Pairing.triangles _) in H. clearbody ts. destruct (shape2 z_fit k w ts) eqn:S; [|discriminate].
      split; [apply (shape2_all z_fit k w ts S)|]. exists 0. split; [exact I|]. apply z_theorem2 in H as [H1 H2].
      apply (plane_link Z idZ z_fit z_in IZR 0 z_in_ok k w ts S D H1 H2).
    + unfold proved3 in H. set (ts := Pairing.tetrahedra _) in H. clearbody ts. destruct (shape3 z_fit k w ts) eqn:S; [|discriminate].
      split; [apply (shape3_all z_fit k w ts S)|]. exists 0. split; [exact I|]. apply fast_ok in H. apply z_theorem in H as [H1 H2].
      apply (space_link Z Z.add Z.sub Z.mul idZ Z.leb z_fit z_in IZR 0 z_in_ok k w ts S D H1 H2).
  - destruct h as [e0 es]. destruct (nf_root p e0 es lo hi d) eqn:R; [|discriminate].
    unfold nf_root in R. apply andb_true_iff in R as [M R]. apply same_list_eq in M. set (fl := removelast p) in *. clearbody fl.
    assert (ROOT : forall a, ev a (fl ++ [1%Z]) = 0 -> in_claimed (Encl lo hi d) a ->
      (forall x, ev x (fl ++ [1%Z]) = 0 -> in_claimed (Encl lo hi d) x -> x = a) -> the_root (Root p lo hi d) a).
    { intros a A1 A2 A3. rewrite <- M in A1, A3. cbn [the_root]. repeat split; auto; apply A2. }
    unfold nf_proved, proved in H. destruct (dimension k) as [|[|[|[|?]]]] eqn:D; try discriminate.
    + unfold proved2 in H. set (ts := Pairing.triangles _) in H. clearbody ts. destruct (shape2 nf_fit k w ts) eqn:S; [|discriminate].
      split; [apply (shape2_all nf_fit k w ts S)|].
      destruct (nf_theorem2 fl e0 es (Encl lo hi d) _ _ R H) as [a [A1 [A2 [A3 [H1 H2]]]]]. exists a. split; [apply ROOT; auto|].
      apply (plane_link (list Z) lofZ nf_fit nf_in (ev a) a (fun x _ => eq_refl) k w ts S D H1 H2).
    + unfold proved3 in H. set (ts := Pairing.tetrahedra _) in H. clearbody ts. destruct (shape3 nf_fit k w ts) eqn:S; [|discriminate].
      split; [apply (shape3_all nf_fit k w ts S)|]. apply fast_ok in H.
      destruct (nf_theorem fl e0 es (Encl lo hi d) _ _ R H) as [a [A1 [A2 [A3 [H1 H2]]]]]. exists a. split; [apply ROOT; auto|].
      apply (space_link (list Z) ladd lsub (lmul fl) lofZ (lleb e0 es) nf_fit nf_in (ev a) a (fun x _ => eq_refl) k w ts S D H1 H2).
Qed.

(** What the certificate shows implies its claim. *)
Theorem shows_meaning c : shows c -> meaning (claim_of c).
Proof.
  destruct c as [k w]. cbn [shows claim_of meaning]. destruct (region_of k); auto; intros [a [R [n [T [_ H]]]]]; exists a; split; auto; exists n, T; exact H.
Qed.
Theorem accepted s k : accepts s = Some k -> exists c, s = print c /\ claim_of c = k /\ shows c /\ meaning k.
Proof.
  unfold accepts, judge. destruct (items s) as [|[z|t|l]| |]; try discriminate.
  destruct l as [|[z|format|l'] l]; try discriminate. destruct l as [|[version|t|l'] l]; try discriminate.
  destruct (negb _); [discriminate|]. destruct (negb _); [discriminate|].
  destruct l as [|[z|kind|l'] l]; try discriminate. destruct l as [|k0 l]; try discriminate. destruct l as [|w0 l]; try discriminate.
  destruct l; [|discriminate]. destruct (negb _); [discriminate|].
  destruct (read_tiling k0 w0) as [c|]; [|discriminate]. destruct (same_bytes s (fast_print c)) eqn:E; [|discriminate].
  apply same_bytes_eq in E. rewrite fast_print_eq in E. intros H. exists c. split; [exact E|].
  unfold judged in H. destruct c as [kk w]. destruct (claim_refusal kk); [discriminate|]. destruct (witness_refusal kk w); [discriminate|].
  destruct (denominators_agree kk w); [|discriminate]. cbv zeta in H. set (h := hint_for (over kk)) in H. clearbody h.
  destruct (polytope_ok h kk w); [|discriminate]. destruct (proves h kk w) eqn:P; [|discriminate].
  destruct (bits_agree kk w); [|discriminate]. injection H as <-. split; [reflexivity|].
  apply proves_sound in P as [NR P].
  assert (S : shows (Tiling kk w)). { cbn [shows]. unfold is_region in NR. destruct (region_of kk); try exact P. discriminate. }
  split; [exact S|]. apply (shows_meaning _ S).
Qed.
(** The same without the certificate's own simplices. *)
Theorem bytes_theorem s k : accepts s = Some k -> exists c, s = print c /\ claim_of c = k /\ meaning k.
Proof. intros H. destruct (accepted s k H) as [c [H1 [H2 [_ H3]]]]. exists c. auto. Qed.
