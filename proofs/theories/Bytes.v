(** * The theorem about bytes

    [accepts] takes the bytes of a certificate.  If it returns a claim, then the bytes are
    those of a certificate with this claim, and the claim is true. *)
From Coq Require Import Reals Lra Lia NArith ZArith List Bool String Permutation FunctionalExtensionality FMapPositive.
From Coq Require Import Init.Byte.
From Coq Require Strings.Byte.
From Acutile Require Import Statement PlaneStatement Tetrahedra Degree Domain Multiply Checker PlaneChecker Soundness PlaneSoundness Keys Numbers
  Fast RegionStatement PlaneRegionStatement RegionChecker RegionSoundness RegionTheorem PlaneRegionChecker PlaneRegionTheorem RegionNumbers Family Denote Read Pairing Format MosaicBytes.
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
Definition fast_witness (f : field) (w : tiling_witness) (tree : list item) : bytes :=
  head 4 (N.of_nat (4 + List.length tree)) ++ encode (Int (w_denominator w)) ++
  long_array (fun v => Array (map (number_item f) v)) (w_vertices w)
  (long_array (fun b => Array (map corner_item b)) (w_boundary w)
  (fold_right onto (long_array row_item (w_rows w) []) tree)).
Lemma fold_onto l t : fold_right onto t l = flat_map encode l ++ t.
Proof. induction l as [|i l IH]; [reflexivity|]. cbn [fold_right flat_map]. rewrite IH, onto_eq, app_assoc. reflexivity. Qed.
Lemma fast_witness_eq f w l : fast_witness f w l = encode (witness_items f w l).
Proof.
  unfold fast_witness, witness_items, points_item. rewrite !long_array_eq, fold_onto, app_nil_r.
  assert (E : forall x, encode (Array x) = head 4 (N.of_nat (List.length x)) ++ flat_map encode x) by reflexivity.
  rewrite (E (Int _ :: _)). cbn [List.length flat_map]. rewrite flat_map_app, app_length. cbn [List.length flat_map].
  rewrite app_nil_r, ?app_assoc. replace (S (S (S (List.length l + 1)))) with (4 + List.length l) by lia. reflexivity.
Qed.
Definition fast_print (c : certificate) : bytes :=
  head 4 5 ++ encode (Text "acutile-certificate") ++ encode (Int 2) ++
  match c with
  | Tiling k w => encode (Text "tiling") ++ onto (claim_item k) (fast_witness (over k) w [])
  | Family ps k t w => encode (Text "family") ++
      onto (claim_items k [Array (map (parameter_item (over k)) ps)]) (fast_witness (over k) w [tree_item t])
  | Patches k ws => encode (Text "patches") ++ onto (patches_claim_item k) (long_array (patch_item (base_field k)) ws [])
  end.
Lemma fast_print_eq c : fast_print c = print c.
Proof.
  assert (E : forall a b c d e, encode (Array [a; b; c; d; e]) = head 4 5 ++ encode a ++ encode b ++ encode c ++ encode d ++ encode e).
  { intros. cbn [encode List.length flat_map]. rewrite app_nil_r. reflexivity. }
  unfold fast_print, print, certificate_item.
  destruct c as [k w|ps k t w|k ws]; rewrite E, onto_eq; [rewrite fast_witness_eq; reflexivity|rewrite fast_witness_eq; reflexivity|rewrite long_array_eq, app_nil_r; reflexivity].
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
Definition one (x : list Z) : bool := Nat.eqb (List.length x) 1.
Definition z_fit (x : number) : bool := match x with Plain x => one x | Polynomial _ => false end.
Definition z_in (x : number) : Z := match x with Plain x => List.hd 0%Z x | Polynomial _ => 0%Z end.
Definition z_proved := proved Z Z.add Z.sub zmul idZ Z.ltb Z.leb zpart z_fit z_in.
Definition z_polytope := proper_polytope Z Z.add Z.sub zmul idZ Z.ltb Z.leb z_in.
Definition nf_fit (x : number) : bool := match x with Plain _ => true | Polynomial _ => false end.
Definition nf_in (x : number) : list Z := match x with Plain x => x | Polynomial _ => [] end.
Definition nf_proved fl e0 es := proved (list Z) ladd lsub (lmul fl) lofZ (lltb e0 es) (lleb e0 es) (nfpart e0) nf_fit nf_in.
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
       proved (list Z) ladd lsub (lmul fl) lofZ less at_most (nfpart e0) nf_fit nf_in k w
    then Declined "a sign that 256 halvings of the root leave open" else Rejected "the checks"
  end.

(** *** Families: polynomials over a base ring B, with signs on the leaves *)
Section OnBox.
Variables (B : Type) (badd bsub bmul : B -> B -> B) (bofZ : Z -> B) (bnonneg bpos : B -> bool) (bfit : list Z -> bool) (bin : list Z -> B).
Fixpoint power_term (m : nat) (es : list N) (c : B) : poly B m :=
  match m, es with
  | O, _ => c
  | S m, e :: es => repeat (pofZ B bofZ m 0) (N.to_nat e) ++ [power_term m es c]
  | S m, [] => [power_term m [] c]
  end.
Definition poly_in (m : nat) (x : number) : poly B m :=
  match x with
  | Plain x => constant B m (bin x)
  | Polynomial l => fold_right (fun t s => padd B badd m (power_term m (snd t) (bin (fst t))) s) (pofZ B bofZ m 0) l
  end.
Definition poly_fit (x : number) : bool :=
  match x with Plain x => bfit x | Polynomial l => forallb (fun t => bfit (fst t)) l end.
(** Both ends over one denominator. *)
Definition interval_of (p : parameter) : interval B :=
  let lo := p_low p in let hi := p_high p in
  Interval B (is_closed lo) (bmul (bofZ (divisor hi)) (bin (numerator lo))) (is_closed hi) (bmul (bofZ (divisor lo)) (bin (numerator hi)))
    (divisor lo * divisor hi)%Z.
Definition fit_limit (e : limit) : bool := Z.ltb 0 (divisor e) && bfit (numerator e).
Fixpoint cuts (t : Denote.tree) : Family.tree :=
  match t with Leaf => Family.Leaf | Halve a l u => Family.Halve (N.to_nat a) (cuts l) (cuts u) end.
Variables (ps : list parameter) (k : tiling_claim) (t : Denote.tree) (w : tiling_witness).
Notation m := (List.length ps).
Definition box_of : box B := map interval_of ps.
Definition fit_box : bool :=
  forallb (fun p => fit_limit (p_low p) && fit_limit (p_high p)) ps && proper B bsub bpos box_of && negb (is_region k).
Definition every_leaf (f : (poly B m -> poly B m -> bool) -> (poly B m -> poly B m -> bool) -> bool) : bool :=
  on_leaves B badd box_of (cuts t) (fun l => f (plt B badd bsub bmul bofZ bnonneg bpos m l) (ple B badd bsub bmul bofZ bnonneg m l)).
Definition family_proved : bool :=
  if fit_box then every_leaf (fun less at_most =>
    proved (poly B m) (padd B badd m) (psub B bsub bofZ m) (pmul B badd bmul bofZ m) (pofZ B bofZ m) less at_most (fun _ _ => 0%Z) poly_fit (poly_in m) k w)
  else false.
Definition family_polytope : bool :=
  every_leaf (fun less at_most =>
    proper_polytope (poly B m) (padd B badd m) (psub B bsub bofZ m) (pmul B badd bmul bofZ m) (pofZ B bofZ m) less at_most (poly_in m) k w).
End OnBox.
Definition nf_nonneg e0 es (x : list Z) : bool := if forallb (Z.eqb 0) x then true else lpos (es ++ [e0]) x.
Definition all_fit (x : list Z) : bool := true.
Definition itself (x : list Z) : list Z := x.
Definition family_proves (h : hint) ps k t w : bool :=
  match over k with
  | Rationals => family_proved Z Z.add Z.sub zmul idZ (Z.leb 0) (Z.ltb 0) one (List.hd 0%Z) ps k t w
  | Root p lo hi d =>
    let (e0, es) := h in let fl := removelast p in
    if nf_root p e0 es lo hi d then
      family_proved (list Z) ladd lsub (lmul fl) lofZ (nf_nonneg e0 es) (lpos (es ++ [e0])) all_fit itself ps k t w
    else false
  end.
(** The polytope is as the format demands on each leaf, and the ends of the intervals are in order. *)
Definition family_polytope_ok (h : hint) ps k t w : bool :=
  match over k with
  | Rationals => family_polytope Z Z.add Z.sub zmul idZ (Z.leb 0) (Z.ltb 0) (List.hd 0%Z) ps k t w
  | Root p lo hi d =>
    let (e0, es) := h in let fl := removelast p in
    family_polytope (list Z) ladd lsub (lmul fl) lofZ (nf_nonneg e0 es) (lpos (es ++ [e0])) itself ps k t w
  end.
Definition box_in_order (h : hint) ps k : bool :=
  match over k with
  | Rationals => fit_box Z Z.sub zmul idZ (Z.ltb 0) one (List.hd 0%Z) ps k
  | Root p lo hi d =>
    let (e0, es) := h in let fl := removelast p in fit_box (list Z) lsub (lmul fl) lofZ (lpos (es ++ [e0])) all_fit itself ps k
  end.
(** Systems of patches.  Numbers are divided by a common divisor where the checker asks for it. *)
Definition z_content (l : list Z) : Z := fold_left Z.gcd l 0%Z.
Definition z_quot (g x : Z) : Z := Z.div x g.
Definition nf_content (l : list (list Z)) : Z := fold_left (fun m x => fold_left Z.gcd x m) l 0%Z.
Definition nf_quot (g : Z) (x : list Z) : list Z := map (fun c => Z.div c g) x.
Definition patches_prove (h : hint) (k : patches_claim) (ws : list patch_witness) : bool :=
  match base_field k with
  | Rationals => patches_proved Z Z.add Z.sub zmul idZ Z.ltb Z.leb z_content z_quot z_fit z_in k ws
  | Root p lo hi d =>
    let (e0, es) := h in
    if nf_root p e0 es lo hi d then
      let fl := removelast p in
      patches_proved (list Z) ladd lsub (lmul fl) lofZ (lltb e0 es) (lleb e0 es) nf_content nf_quot nf_fit nf_in k ws
    else false
  end.
Definition bits_agree (k : tiling_claim) (w : tiling_witness) : bool :=
  if existsb is_tcp (sentences k) then sixes_agree (fst (Pairing.tetrahedra [] (fast_map row_corners (w_rows w)))) (w_rows w) else true.
(** The cells of a region that the program is willing to look at. *)
Definition too_many_cells (h : hint) (k : tiling_claim) (w : tiling_witness) : bool :=
  if is_region k then
    Z.ltb (2000000 + 64 * Z.of_N (count_all (w_rows w)))
      match over k with
      | Rationals => grid_cells Z Z.add idZ zpart z_in k w
      | Root _ _ _ _ => grid_cells (list Z) ladd lofZ (nfpart (fst h)) nf_in k w
      end
  else false.
Definition judged (c : certificate) : verdict :=
  match c with
  | Family ps k t w =>
    match family_refusal ps k t w with Some r => Refused r | None =>
      if denominators_agree k w then
        let h := hint_for (over k) in
        if negb (box_in_order h ps k) then Refused (Malformed "the ends of an interval are not in order") else
        if (if family_polytope_ok h ps k t w then family_proves h ps k t w else false) then
          if bits_agree k w then Accepted (claim_of c) else Refused (Rejected "the bits of valence 6")
        else Refused (Declined "the checks on some leaf")
      else Refused (Rejected "the denominator of the domain")
    end
  | Tiling k w =>
    match claim_refusal 0 k with Some r => Refused r | None =>
    match witness_refusal 0 k w with Some r => Refused r | None =>
      if denominators_agree k w then
        let h := hint_for (over k) in
        if too_many_cells h k w then Refused (Declined "the work") else
        if (if polytope_ok h k w then proves h k w else false) then
          if bits_agree k w then Accepted (claim_of c) else Refused (Rejected "the bits of valence 6")
        else Refused (why_not h k w)
      else Refused (Rejected "the denominator of the domain")
    end end
  | Patches k ws =>
    match patches_refusal k ws with Some r => Refused r | None =>
      if patches_prove (hint_for (base_field k)) k ws then Accepted (claim_of c) else Refused (Declined "the checks of a system of patches")
    end
  end.
Local Open Scope string_scope.
Definition judge (s : bytes) : verdict :=
  match items s with
  | Complete (Array (Text format :: Int version :: rest)) =>
    if negb (String.eqb format "acutile-certificate") then Refused (Malformed "not an acutile certificate")
    else if negb (Z.eqb version 2) then Refused (Declined "the version")
    else match rest with
    | [Text kind; k; w] =>
      if negb (String.eqb kind "tiling" || String.eqb kind "family" || String.eqb kind "patches") then
        Refused (Declined ("the kind: this checker has theorems about tilings, families and patches only")) else
      match (if String.eqb kind "tiling" then read_tiling k w else if String.eqb kind "family" then read_family k w else read_patches k w) with
      | None => Refused (Malformed "not of the shape of a certificate")
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
Variables (A : Type) (aadd asub amul : A -> A -> A) (aofZ : Z -> A) (alt ale : A -> A -> bool) (fit : number -> bool) (inn : number -> A) (part : Z -> A -> Z).
Variables (phi : A -> R) (a : valuation).
Hypothesis phi_Z : forall z, phi (aofZ z) = IZR z.
Hypothesis inn_ok : forall x, fit x = true -> phi (inn x) = value a x.
Variables (k : tiling_claim) (w : tiling_witness).

Lemma root_scaled f x : at_root (fst a) (map (Z.mul f) x) = IZR f * at_root (fst a) x.
Proof. induction x as [|c x IH]; cbn [map at_root]; [ring|]. rewrite mult_IZR, IH. ring. Qed.
Lemma value_scaled f x : value a (scale_number f x) = IZR f * value a x.
Proof.
  destruct x as [x|l]; [apply root_scaled|]. cbn [scale_number value]. induction l as [|c l IH]; cbn [map fold_right fst snd]; [ring|].
  rewrite IH, root_scaled. ring.
Qed.
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
Section SpaceData.
Variables (ts : list ctet) (places : list (N * N * Z3)).
Hypothesis SHAPE : shape3 fit k w ts places = true.
Lemma shape3_all : gram_shape fit k = true /\ (forall v, In v (w_vertices w) -> triple fit v = true) /\
  (forall v, In v (scaled k w (rank k)) -> triple fit v = true) /\ (0 < w_denominator w)%Z /\ denominators_agree k w = true /\
  facets_agree k w ts places = true /\ In FaceToFaceTiling (sentences k) /\ (forall s, In s (sentences k) -> fit_sentence fit 3 (is_region k) s = true) /\
  both (same_row (N.of_nat (List.length (w_vertices w)))) (w_rows w) ts = true.
Proof.
  pose proof SHAPE as H. unfold shape3 in H. rewrite !andb_true_iff, !forallb_forall, Z.ltb_lt in H.
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
(** The coordinates of a corner of the checker. *)
Definition place3 (q : Checker.corner) : list R :=
  let '(x, y, z) := snd q in moved (map (fun x => value a x / IZR (w_denominator w)) (nth (N.to_nat (fst q)) (w_vertices w) [])) [x; y; z].
Lemma vertex3 i : N.ltb i (N.of_nat (List.length (w_vertices w))) = true -> exists x y z, nth (N.to_nat i) (w_vertices w) [] = [x; y; z].
Proof.
  rewrite N.ltb_lt. intros L. destruct shape3_all as [_ [V _]].
  assert (I : In (nth (N.to_nat i) (w_vertices w) []) (w_vertices w)) by (apply nth_In; lia).
  destruct (triple_cases _ (V _ I)) as [x [y [z [E _]]]]. eauto.
Qed.
Lemma place3_ok q : N.ltb (fst q) (N.of_nat (List.length (w_vertices w))) = true -> coordinates a w q = place3 (corner3 q).
Proof.
  intros L. destruct (vertex3 _ L) as [x [y [z E]]]. unfold coordinates, place3. cbn [corner3 fst snd]. rewrite E.
  destruct (snd q) as [|s1 [|s2 [|s3 s]]]; cbn [shift3 z30 moved map]; rewrite ?Rplus_0_r; reflexivity.
Qed.
Lemma place3_rank q d1 d2 d3 : N.ltb (fst q) (N.of_nat (List.length (w_vertices w))) = true -> latb (rank k) (- d1, - d2, - d3)%Z = true ->
  moved (place3 (corner3 q)) (firstn (rank k) [d1; d2; d3]) = moved (place3 (corner3 q)) [d1; d2; d3].
Proof.
  intros L H. destruct (vertex3 _ L) as [x [y [z E]]]. unfold place3. cbn [corner3 fst snd]. rewrite E. destruct (shift3 (snd q)) as [[s1 s2] s3].
  apply latb_iff in H. assert (K : forall d, (- d = 0)%Z -> d = 0%Z) by lia.
  destruct (rank k) as [|[|[|r]]]; cbn [in_lattice] in H; decompose [and] H; repeat match goal with X : (- _ = 0)%Z |- _ => apply K in X; subst end;
    cbn [firstn moved map]; rewrite ?firstn_nil, ?Rplus_0_r; try (destruct r); reflexivity.
Qed.
Lemma place3_back q x y z : N.ltb (fst q) (N.of_nat (List.length (w_vertices w))) = true ->
  moved (place3 (cshift (x, y, z) q)) [- x; - y; - z]%Z = place3 q.
Proof.
  intros L. destruct (vertex3 _ L) as [u [v [t E]]]. unfold place3, cshift. cbn [fst snd]. rewrite E. destruct (snd q) as [[s1 s2] s3].
  cbn [zadd3 moved map]. rewrite !plus_IZR, !opp_IZR.
  assert (K : forall p s x, p + (s + x) + - x = p + s) by (intros; ring). rewrite !K. reflexivity.
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
Lemma row_link j t : nth_error ts j = Some t -> (forall q, In q [q0 t; q1 t; q2 t; q3 t] -> N.ltb (fst q) (N.of_nat (List.length (w_vertices w))) = true) /\
  rows_as_simplices j = map place3 [q0 t; q1 t; q2 t; q3 t].
Proof.
  intros E. destruct shape3_all as [_ [_ [_ [_ [_ [_ [_ [_ B]]]]]]]]. pose proof (both_nth _ _ _ B j) as H. unfold rows_as_simplices.
  rewrite E in H. destruct (nth_error (w_rows w) j) as [r|]; [|contradiction].
  unfold same_row in H. destruct (fst r) as [|a0 [|a1 [|a2 [|a3 [|? ?]]]]]; try discriminate.
  cbn [forallb] in H. rewrite !andb_true_iff, !ceqb_t in H. destruct H as [[[[[R0 [R1 [R2 [R3 _]]]] E0] E1] E2] E3]. split.
  - intros q [<-|[<-|[<-|[<-|[]]]]]; [rewrite <- E0|rewrite <- E1|rewrite <- E2|rewrite <- E3]; assumption.
  - cbn [map]. rewrite <- E0, <- E1, <- E2, <- E3, !place3_ok by assumption. reflexivity.
Qed.

(** *** The boundary facets of a region *)
Definition listed_places : list (nat * nat) := map (fun p => let '(j, i, _) := p in (N.to_nat j, N.to_nat i)) places.
Hypothesis REGION : is_region k = true.
Lemma facets_all : (rank k <= 3)%nat /\ both (facet_is (rank k) (tabulate ts)) (w_boundary w) places = true /\
  all_marked (marked places) (RegionChecker.open_facets ts) = true.
Proof.
  destruct shape3_all as [_ [_ [_ [_ [_ [F _]]]]]]. unfold facets_agree in F. rewrite REGION, !andb_true_iff, Nat.leb_le in F. tauto.
Qed.
Lemma facet_is_spec f j i d : facet_is (rank k) (tabulate ts) f (j, i, d) = true -> exists t, nth_error ts (N.to_nat j) = Some t /\
  In (N.to_nat i) I4 /\ latb (rank k) d = true /\ mt t (N.to_nat i) = None /\
  Permutation (map corner3 f) (map (cshift d) (facet_corners t (N.to_nat i))).
Proof.
  unfold facet_is. rewrite entry_tabulate. destruct (nth_error ts (N.to_nat j)) as [t|] eqn:E; [|discriminate].
  destruct (map corner3 f) as [|x [|y [|z [|? ?]]]] eqn:M; try discriminate. rewrite !andb_true_iff, N.ltb_lt. intros [[[H1 H2] H3] H4].
  exists t. split; auto. split; [apply I4_lt; lia|]. split; auto. split.
  - unfold unmated in H3. destruct (mt t (N.to_nat i)); [discriminate|reflexivity].
  - unfold facet_corners. destruct (cfc t (N.to_nat i)) as [[a' b'] c'].
    unfold codd in H4. rewrite !orb_true_iff, !andb_true_iff, !ceqb_t in H4. cbn [map].
    destruct H4 as [[[[-> ->] ->]|[[-> ->] ->]]|[[-> ->] ->]].
    + apply perm_swap.
    + apply perm_skip, perm_swap.
    + apply Permutation_trans with (1 := perm_swap _ _ _). apply Permutation_trans with (1 := perm_skip _ (perm_swap _ _ _)). apply perm_swap.
Qed.
Lemma marked_In (l : list (N * N * Z3)) : forall (m : PositiveMap.t unit) q, PositiveMap.find q (fold_left (fun m p => let '(j, i, _) := p in PositiveMap.add (place j i) tt m) l m) <> None ->
  (exists j i d, In (j, i, d) l /\ q = place j i) \/ PositiveMap.find q m <> None.
Proof.
  induction l as [|[[j i] d] l IH]; intros m q H; cbn [fold_left] in H; auto.
  apply IH in H as [[j' [i' [d' [H E]]]]|H].
  - left. exists j', i', d'. split; [right; exact H|exact E].
  - destruct (Pos.eq_dec q (place j i)) as [->|Ne].
    + left. exists j, i, d. split; [left|]; reflexivity.
    + right. rewrite PositiveMap.gso in H; auto.
Qed.
Lemma listed_same (p : nat * nat) : In p listed_places <-> In p (listed_facets A c).
Proof.
  destruct facets_all as [_ [B M]]. destruct p as [j0 i0]. unfold listed_places, listed_facets. change (c_tets A c) with ts. rewrite !in_map_iff. split.
  - intros [[[j i] d] [E H]]. injection E as <- <-. apply In_nth_error in H as [m Hm]. pose proof (both_nth _ _ _ B m) as F. rewrite Hm in F.
    destruct (nth_error (w_boundary w) m) as [f|]; [|contradiction]. destruct (facet_is_spec f j i d F) as [t [Et [It [_ [U _]]]]].
    exists (j, t, N.to_nat i). split; auto. apply open_facets_In. auto.
  - intros [[[j t] i] [E H]]. injection E as <- <-. pose proof H as H'. apply open_facets_In in H' as [_ [Hi _]]. apply I4_lt in Hi.
    unfold all_marked in M. rewrite forallb_forall in M. specialize (M _ H). cbv beta iota in M.
    destruct (marked_In places (PositiveMap.empty unit) (place j (N.of_nat i))) as [[j' [i' [d' [H1 E]]]]|X].
    + fold (marked places). destruct (PositiveMap.find _ (marked places)); discriminate.
    + exists (j', i', d'). split; auto.
      apply In_nth_error in H1 as [m Hm]. pose proof (both_nth _ _ _ B m) as F. rewrite Hm in F.
      destruct (nth_error (w_boundary w) m) as [f|]; [|contradiction]. destruct (facet_is_spec f j' i' d' F) as [_ [_ [It _]]]. apply I4_lt in It.
      unfold place in E. assert (K : (4 * j + N.of_nat i = 4 * j' + i')%N). { apply (f_equal Npos) in E. rewrite !N.succ_pos_spec in E. lia. }
      assert (j' = j) as -> by lia. f_equal. lia.
    + rewrite PositiveMap.gempty in X. congruence.
Qed.
Lemma facets_link : are_facets a w (rank k) rows_as_simplices listed_places.
Proof.
  destruct facets_all as [RK [B _]]. split.
  - unfold listed_places. rewrite map_length. symmetry. apply (both_length _ _ _ B).
  - intros m f E. pose proof (both_nth _ _ _ B m) as F. rewrite E in F. destruct (nth_error places m) as [[[j i] [[x y] z]]|] eqn:Em; [|contradiction].
    destruct (facet_is_spec f j i _ F) as [t [Et [It [L [_ P]]]]]. destruct (row_link _ t Et) as [V RL].
    exists (N.to_nat j), (N.to_nat i), (firstn (rank k) [- x; - y; - z]%Z). split; [|split].
    + unfold listed_places. rewrite (map_nth_error _ _ _ Em). reflexivity.
    + rewrite firstn_length. cbn [List.length]. lia.
    + assert (VF : forall q, In q (facet_corners t (N.to_nat i)) -> N.ltb (fst q) (N.of_nat (List.length (w_vertices w))) = true).
      { intros q Hq. apply V, (facet_tet t (N.to_nat i)), Hq. }
      assert (VQ : forall q, In q f -> N.ltb (fst q) (N.of_nat (List.length (w_vertices w))) = true).
      { intros q Hq. apply (in_map corner3), (Permutation_in _ P) in Hq. apply in_map_iff in Hq as [q' [Eq Hq']]. specialize (VF q' Hq').
        destruct q as [v s']. apply (f_equal fst) in Eq. cbn [fst corner3 cshift] in Eq |- *. rewrite <- Eq. exact VF. }
      assert (K : map (fun q => moved (coordinates a w q) (firstn (rank k) [- x; - y; - z]%Z)) f = map (fun q => moved (place3 q) [- x; - y; - z]%Z) (map corner3 f)).
      { rewrite map_map. apply map_ext_in. intros q Hq. rewrite place3_ok by auto. apply place3_rank; [apply VQ, Hq|rewrite !Z.opp_involutive; exact L]. }
      rewrite K. apply Permutation_trans with (map (fun q => moved (place3 q) [- x; - y; - z]%Z) (map (cshift (x, y, z)) (facet_corners t (N.to_nat i))));
        [|apply Permutation_map, Permutation_sym, P].
      rewrite map_map. rewrite (map_ext_in _ place3).
      2:{ intros q Hq. apply place3_back, VF, Hq. }
      rewrite RL. apply I4_lt in It. destruct (N.to_nat i) as [|[|[|[|i']]]]; try lia; cbn [map but facet_corners cfc].
      * apply perm_skip, perm_swap.
      * apply Permutation_refl.
      * apply perm_skip, perm_swap.
      * apply Permutation_refl.
Qed.
End SpaceData.

Lemma listed_either l1 l2 l3 r n P l l' : (forall p, In p l <-> In p l') -> face_to_face_region l1 l2 l3 r n P l' -> face_to_face_region l1 l2 l3 r n P l.
Proof.
  intros E H. assert (B : forall f, is_boundary_facet r n l f <-> is_boundary_facet r n l' f) by (intros f; unfold is_boundary_facet; rewrite E; tauto).
  destruct H as [H1 H2 H3 H4 H5 H6 H7 H8 H9]. constructor; auto.
  - destruct H6 as [f H6]. exists f. apply B, H6.
  - intros j i I. apply H7, E, I.
  - intros X. rewrite H8. split; intros [f [F G]]; exists f; (split; [apply B|]; auto).
  - intros X f g F G. apply H9; apply B; auto.
Qed.
Section SpaceLink.
Variables (ts : list ctet) (places : list (N * N * Z3)).
Hypothesis SHAPE : shape3 fit k w ts places = true.
Notation c := (data3 A aadd asub amul aofZ ale inn k w ts).
Theorem space_link : dimension k = 3%nat -> is_region k = false ->
  (exists l1 l2 l3, has_gram (dgram A phi c) l1 l2 l3) ->
  (forall l1 l2 l3, has_gram (dgram A phi c) l1 l2 l3 ->
    face_to_face_tiling l1 l2 l3 (c_rank A c) (ddomain A phi c l1 l2 l3) (List.length (c_tets A c)) (dtet A aofZ phi c l1 l2 l3) /\
    forall s, In s (map (dstatement A phi) (statements_of A part inn k)) -> holds l1 l2 l3 (c_rank A c) (List.length (c_tets A c)) (dtet A aofZ phi c l1 l2 l3) s) ->
  exists n T listed, are_rows a w n T /\ are_facets a w (rank k) T listed /\ holds_of k a n T listed.
Proof.
  intros D NR H1 H2. destruct (shape3_all ts places SHAPE) as [_ [_ [_ [_ [_ [FA [ST [FS B]]]]]]]].
  exists (List.length (w_rows w)), rows_as_simplices, []. split; [|split].
  { split; auto. intros j r E. unfold rows_as_simplices. rewrite E. apply Permutation_refl. }
  { unfold facets_agree in FA. rewrite NR in FA. destruct (w_boundary w) eqn:E; [|discriminate]. split; rewrite E; [reflexivity|]. intros [|m] f X; discriminate. }
  unfold holds_of. split; auto. rewrite D, <- (gram_link ts places SHAPE D). split; auto.
  intros l1 l2 l3 HG s Hs. destruct (H2 l1 l2 l3 HG) as [T HS]. rewrite (tetrahedra_link ts places SHAPE) in T, HS. rewrite (domain_link ts places SHAPE) in T.
  change (c_rank A c) with (rank k) in T, HS. change (c_tets A c) with ts in T, HS. rewrite <- (both_length _ _ _ B) in T, HS.
  specialize (FS s Hs). rewrite NR in FS.
  assert (HS' : forall st, In st (statement_of A part inn s) -> holds l1 l2 l3 (rank k) (List.length (w_rows w)) (fun j => as_tetrahedron l1 l2 l3 (rows_as_simplices j)) (dstatement A phi st)).
  { intros st Hst. apply HS, in_map. unfold statements_of. apply in_flat_map. eauto. }
  unfold is_region in NR.
  destruct s as [| | |rel sg p q|rel sg p q|rel p q|l p q| | | | | |]; cbn [fit_sentence] in FS; try discriminate; cbn [space_sentence];
    [destruct (region_of k); try discriminate; exact T|..];
    try (destruct l as [|c1 [|c2 [|c3 [|? ?]]]]; try discriminate);
    specialize (HS' _ (or_introl eq_refl)); cbn [dstatement holds] in HS'; unfold dangle in HS'; rewrite ?inn_ok in HS' by assumption; exact HS'.
Qed.
Theorem region_link : dimension k = 3%nat -> is_region k = true ->
  region_meaning (dgram A phi c) (c_rank A c) (List.length (c_tets A c)) (dtet A aofZ phi c) (listed_facets A c) (map (rdstatement A phi) (region_statements_of A part inn k)) ->
  exists n T listed, are_rows a w n T /\ are_facets a w (rank k) T listed /\ holds_of k a n T listed.
Proof.
  intros D RG [H1 H2]. destruct (shape3_all ts places SHAPE) as [_ [_ [_ [_ [_ [_ [ST [FS B]]]]]]]].
  exists (List.length (w_rows w)), rows_as_simplices, (listed_places places). split; [|split].
  { split; auto. intros j r E. unfold rows_as_simplices. rewrite E. apply Permutation_refl. }
  { apply (facets_link ts places SHAPE RG). }
  unfold holds_of. split; auto. rewrite D, <- (gram_link ts places SHAPE D). split; auto.
  intros l1 l2 l3 HG s Hs. destruct (H2 l1 l2 l3 HG) as [T HS]. rewrite (tetrahedra_link ts places SHAPE) in T, HS.
  change (c_rank A c) with (rank k) in T, HS. change (c_tets A c) with ts in T, HS. rewrite <- (both_length _ _ _ B) in T, HS.
  apply (listed_either _ _ _ _ _ _ (listed_places places)) in T; [|apply (listed_same ts places SHAPE RG)].
  specialize (FS s Hs).
  assert (HS' : forall st, In st (region_statement_of A part inn s) -> holds_in_region l1 l2 l3 (rank k) (List.length (w_rows w)) (fun j => as_tetrahedron l1 l2 l3 (rows_as_simplices j)) (rdstatement A phi st)).
  { intros st Hst. apply HS, in_map. unfold region_statements_of. apply in_flat_map. eauto. }
  unfold is_region in RG.
  destruct s as [| | |rel sg p q|rel sg p q|rel p q|l p q| | | | | |]; cbn [fit_sentence] in FS; cbn [space_sentence];
    [destruct (region_of k); try discriminate; exact T|..];
    try (destruct l as [|c1 [|c2 [|c3 [|? ?]]]]; try discriminate);
    specialize (HS' _ (or_introl eq_refl)); cbn [rdstatement holds_in_region dstatement holds] in HS'; unfold dangle in HS'; rewrite ?inn_ok in HS' by assumption; exact HS'.
Qed.
End SpaceLink.

(** *** The plane *)
Section PlaneData.
Variables (ts : list ctri) (places : list (N * N * Z3)).
Hypothesis SHAPE : shape2 fit k w ts places = true.
Lemma shape2_all : gram_shape fit k = true /\ (forall v, In v (w_vertices w) -> pair fit v = true) /\
  (forall v, In v (scaled k w (rank k)) -> pair fit v = true) /\ (0 < w_denominator w)%Z /\ denominators_agree k w = true /\
  sides_agree k w ts places = true /\ In FaceToFaceTiling (sentences k) /\ (forall s, In s (sentences k) -> fit_sentence fit 2 (is_region k) s = true) /\
  both (same_triangle (N.of_nat (List.length (w_vertices w)))) (w_rows w) ts = true.
Proof.
  pose proof SHAPE as H. unfold shape2 in H. rewrite !andb_true_iff, !forallb_forall, Z.ltb_lt in H.
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

(** *** The boundary sides of a region *)
Definition listed_places2 : list (nat * nat) := map (fun p => let '(j, i, _) := p in (N.to_nat j, N.to_nat i)) places.
Hypothesis REGION : is_region k = true.
Lemma sides_all : (rank k <= 2)%nat /\ (forall f q, In f (w_boundary w) -> In q f -> N.ltb (fst q) (N.of_nat (List.length (w_vertices w))) = true) /\
  both (side_is (rank k) (tabulate ts)) (w_boundary w) places = true /\ all_marked2 (marked places) (open_sides ts) = true.
Proof.
  destruct shape2_all as [_ [_ [_ [_ [_ [F _]]]]]]. unfold sides_agree in F. rewrite REGION, !andb_true_iff, Nat.leb_le, forallb_forall in F.
  destruct F as [[[F1 F2] F3] F4]. split; auto. split; auto. intros f q Hf. specialize (F2 f Hf). rewrite forallb_forall in F2. apply F2.
Qed.
Lemma side_is_spec f j i d : side_is (rank k) (tabulate ts) f (j, i, d) = true -> exists t x y q q', nth_error ts (N.to_nat j) = Some t /\
  In (N.to_nat i) I3 /\ latb (rank k) d = true /\ nt t (N.to_nat i) = None /\ ends t (N.to_nat i) = (x, y) /\ f = [q; q'] /\
  ceqb2 q (moved2 d x) = true /\ ceqb2 q' (moved2 d y) = true.
Proof.
  unfold side_is. rewrite entry_tabulate. destruct (nth_error ts (N.to_nat j)) as [t|] eqn:E; [|discriminate].
  destruct f as [|q [|q' [|? ?]]]; try discriminate. destruct (ends t (N.to_nat i)) as [x y] eqn:Ee. rewrite !andb_true_iff, N.ltb_lt. intros [[[H1 H2] H3] [H4 H5]].
  exists t, x, y, q, q'. split; auto. split.
  - assert (K : (N.to_nat i < 3)%nat) by lia. destruct (N.to_nat i) as [|[|[|?]]]; simpl; auto; lia.
  - split; auto. split; [|repeat split; auto]. unfold free in H3. destruct (nt t (N.to_nat i)); [discriminate|reflexivity].
Qed.
Lemma listed_same2 (p : nat * nat) : In p listed_places2 <-> In p (listed_sides A c).
Proof.
  destruct sides_all as [_ [_ [B M]]]. destruct p as [j0 i0]. unfold listed_places2, listed_sides. change (e_tris A c) with ts. rewrite !in_map_iff. split.
  - intros [[[j i] d] [E H]]. injection E as <- <-. apply In_nth_error in H as [m Hm]. pose proof (both_nth _ _ _ B m) as F. rewrite Hm in F.
    destruct (nth_error (w_boundary w) m) as [f|]; [|contradiction]. destruct (side_is_spec f j i d F) as [t [_ [_ [_ [_ [Et [It [_ [U _]]]]]]]]].
    exists (j, t, N.to_nat i). split; auto. apply open_sides_In. auto.
  - intros [[[j t] i] [E H]]. injection E as <- <-. pose proof H as H'. apply open_sides_In in H' as [_ [Hi _]].
    assert (Li : (i < 3)%nat) by (simpl in Hi; lia).
    unfold all_marked2 in M. rewrite forallb_forall in M. specialize (M _ H). cbv beta iota in M.
    destruct (marked_In places (PositiveMap.empty unit) (place j (N.of_nat i))) as [[j' [i' [d' [H1 E]]]]|X].
    + fold (marked places). destruct (PositiveMap.find _ (marked places)); discriminate.
    + exists (j', i', d'). split; auto.
      apply In_nth_error in H1 as [m Hm]. pose proof (both_nth _ _ _ B m) as F. rewrite Hm in F.
      destruct (nth_error (w_boundary w) m) as [f|]; [|contradiction]. destruct (side_is_spec f j' i' d' F) as [_ [_ [_ [_ [_ [_ [It _]]]]]]].
      assert (Li' : (N.to_nat i' < 3)%nat) by (simpl in It; lia).
      unfold place in E. assert (K : (4 * j + N.of_nat i = 4 * j' + i')%N). { apply (f_equal Npos) in E. rewrite !N.succ_pos_spec in E. lia. }
      assert (j' = j) as -> by lia. f_equal. lia.
    + rewrite PositiveMap.gempty in X. congruence.
Qed.
Lemma side_back q p x y z : N.ltb (fst q) (N.of_nat (List.length (w_vertices w))) = true -> latb (rank k) (x, y, z) = true -> (rank k <= 2)%nat ->
  ceqb2 q (moved2 (x, y, z) p) = true -> moved (coordinates a w q) (firstn (rank k) [- x; - y]%Z) = corner_place p.
Proof.
  intros L Hd RK E. destruct (ceqb2_place _ _ L E) as [F <-]. unfold corner_place, coordinates, moved2. cbn [fst snd].
  rewrite F in L. destruct (vertex2 _ L) as [u [v [Ev _]]]. cbn [moved2 fst] in Ev. rewrite Ev. apply latb_iff in Hd.
  assert (K : forall p s x, p + (s + x) + - x = p + s) by (intros; ring). assert (K0 : forall p s, p + (s + 0) = p + s) by (intros; ring).
  destruct (rank k) as [|[|[|r]]]; try lia; cbn [in_lattice] in Hd; decompose [and] Hd; subst;
    cbn [firstn map moved fst snd]; rewrite ?plus_IZR, ?opp_IZR, ?K, ?K0; reflexivity.
Qed.
Lemma sides_link : are_facets a w (rank k) triangles_as_simplices listed_places2.
Proof.
  destruct sides_all as [RK [VF [B _]]]. split.
  - unfold listed_places2. rewrite map_length. symmetry. apply (both_length _ _ _ B).
  - intros m f E. pose proof (both_nth _ _ _ B m) as F. rewrite E in F. destruct (nth_error places m) as [[[j i] [[x y] z]]|] eqn:Em; [|contradiction].
    destruct (side_is_spec f j i _ F) as [t [e1 [e2 [q [q' [Et [It [L [_ [Ee [-> [Q Q']]]]]]]]]]]].
    exists (N.to_nat j), (N.to_nat i), (firstn (rank k) [- x; - y]%Z). split; [|split].
    + unfold listed_places2. rewrite (map_nth_error _ _ _ Em). reflexivity.
    + rewrite firstn_length. cbn [List.length]. lia.
    + pose proof (nth_error_In _ _ E) as If. cbn [map]. rewrite (side_back q e1 x y z), (side_back q' e2 x y z); auto;
        try (apply (VF _ _ If); simpl; auto).
      unfold triangles_as_simplices. rewrite Et. unfold ends in Ee. simpl in It.
      revert Ee. destruct It as [<-|[<-|[<-|[]]]]; cbn [but]; intros Ee; destruct (even t); injection Ee as <- <-; first [apply Permutation_refl|apply perm_swap].
Qed.
End PlaneData.

Lemma listed_either2 l1 l2 r n P l l' : (forall p, In p l <-> In p l') -> edge_to_edge_region l1 l2 r n P l' -> edge_to_edge_region l1 l2 r n P l.
Proof.
  intros E H. assert (B : forall f, is_boundary_side r n l f <-> is_boundary_side r n l' f) by (intros f; unfold is_boundary_side; rewrite E; tauto).
  destruct H as [H1 H2 H3 H4 H5 H6 H7 H8 H9]. constructor; auto.
  - destruct H6 as [f H6]. exists f. apply B, H6.
  - intros j i I. apply H7, E, I.
  - intros X. rewrite H8. split; intros [f [F G]]; exists f; (split; [apply B|]; auto).
  - intros X f g F G. apply H9; apply B; auto.
Qed.
Section PlaneLink.
Variables (ts : list ctri) (places : list (N * N * Z3)).
Hypothesis SHAPE : shape2 fit k w ts places = true.
Notation c := (data2 A aofZ inn k w ts).
Theorem plane_link : dimension k = 2%nat -> is_region k = false ->
  (exists l1 l2, has_gram2 (dgram2 A phi c) l1 l2) ->
  (forall l1 l2, has_gram2 (dgram2 A phi c) l1 l2 ->
    edge_to_edge_tiling l1 l2 (e_rank A c) (ddomain2 A phi c l1 l2) (List.length (e_tris A c)) (dtriangle A aofZ phi c l1 l2) /\
    forall s, In s (map (dstatement A phi) (statements_of A part inn k)) -> holds2 l1 l2 (e_rank A c) (List.length (e_tris A c)) (dtriangle A aofZ phi c l1 l2) s) ->
  exists n T listed, are_rows a w n T /\ are_facets a w (rank k) T listed /\ holds_of k a n T listed.
Proof.
  intros D NR H1 H2. destruct (shape2_all ts places SHAPE) as [_ [_ [_ [_ [_ [FA [ST [FS B]]]]]]]]. exists (List.length (w_rows w)), (triangles_as_simplices ts), []. split; [|split].
  { split; auto. intros j r E. destruct (rows2 ts places SHAPE j r E) as [t [_ [P _]]]. exact P. }
  { unfold sides_agree in FA. rewrite NR in FA. destruct (w_boundary w) eqn:E; [|discriminate]. split; rewrite E; [reflexivity|]. intros [|m] f X; discriminate. }
  unfold holds_of. split; auto. rewrite D, <- (gram2_link ts places SHAPE D). split; auto.
  intros l1 l2 HG s Hs. destruct (H2 l1 l2 HG) as [T HS]. rewrite (triangles_link ts places SHAPE) in T, HS. rewrite (domain2_link ts places SHAPE) in T.
  change (e_rank A c) with (rank k) in T, HS. change (e_tris A c) with ts in T, HS. rewrite <- (both_length _ _ _ B) in T, HS.
  specialize (FS s Hs). rewrite NR in FS.
  assert (HS' : forall st, In st (statement_of A part inn s) -> holds2 l1 l2 (rank k) (List.length (w_rows w)) (fun j => as_triangle l1 l2 (triangles_as_simplices ts j)) (dstatement A phi st)).
  { intros st Hst. apply HS, in_map. unfold statements_of. apply in_flat_map. eauto. }
  unfold is_region in NR.
  destruct s as [| | |rel sg p q|rel sg p q|rel p q|l p q| | | | | |]; cbn [fit_sentence] in FS; try discriminate; cbn [plane_sentence];
    [destruct (region_of k); try discriminate; exact T|..];
    try (destruct l as [|c1 [|c2 [|c3 [|? ?]]]]; try discriminate);
    specialize (HS' _ (or_introl eq_refl)); cbn [dstatement holds2] in HS'; unfold dangle in HS'; rewrite ?inn_ok in HS' by assumption; exact HS'.
Qed.
Theorem plane_region_link : dimension k = 2%nat -> is_region k = true ->
  region_meaning2 (dgram2 A phi c) (e_rank A c) (List.length (e_tris A c)) (dtriangle A aofZ phi c) (listed_sides A c) (map (rdstatement A phi) (region_statements_of A part inn k)) ->
  exists n T listed, are_rows a w n T /\ are_facets a w (rank k) T listed /\ holds_of k a n T listed.
Proof.
  intros D RG [H1 H2]. destruct (shape2_all ts places SHAPE) as [_ [_ [_ [_ [_ [_ [ST [FS B]]]]]]]].
  exists (List.length (w_rows w)), (triangles_as_simplices ts), (listed_places2 places). split; [|split].
  { split; auto. intros j r E. destruct (rows2 ts places SHAPE j r E) as [t [_ [P _]]]. exact P. }
  { apply (sides_link ts places SHAPE RG). }
  unfold holds_of. split; auto. rewrite D, <- (gram2_link ts places SHAPE D). split; auto.
  intros l1 l2 HG s Hs. destruct (H2 l1 l2 HG) as [T HS]. rewrite (triangles_link ts places SHAPE) in T, HS.
  change (e_rank A c) with (rank k) in T, HS. change (e_tris A c) with ts in T, HS. rewrite <- (both_length _ _ _ B) in T, HS.
  apply (listed_either2 _ _ _ _ _ (listed_places2 places)) in T; [|apply (listed_same2 ts places SHAPE RG)].
  specialize (FS s Hs).
  assert (HS' : forall st, In st (region_statement_of A part inn s) -> holds_in_region2 l1 l2 (rank k) (List.length (w_rows w)) (fun j => as_triangle l1 l2 (triangles_as_simplices ts j)) (rdstatement A phi st)).
  { intros st Hst. apply HS, in_map. unfold region_statements_of. apply in_flat_map. eauto. }
  unfold is_region in RG.
  destruct s as [| | |rel sg p q|rel sg p q|rel p q|l p q| | | | | |]; cbn [fit_sentence] in FS; cbn [plane_sentence];
    [destruct (region_of k); try discriminate; exact T|..];
    try (destruct l as [|c1 [|c2 [|c3 [|? ?]]]]; try discriminate);
    specialize (HS' _ (or_introl eq_refl)); cbn [rdstatement holds_in_region2 dstatement holds2] in HS'; unfold dangle in HS'; rewrite ?inn_ok in HS' by assumption; exact HS'.
Qed.
End PlaneLink.
End Link.

(** ** The theorem *)
Lemma same_list_eq x : forall y, same_list x y = true -> x = y.
Proof.
  induction x as [|b x IH]; intros [|c y]; cbn [same_list]; try discriminate; auto.
  rewrite andb_true_iff, Z.eqb_eq. intros [-> H]. f_equal. auto.
Qed.
Lemma z_in_ok x : z_fit x = true -> IZR (z_in x) = value (0, []) x.
Proof. destruct x as [x|l]; [|discriminate]. destruct x as [|b [|? ?]]; try discriminate. intros _. cbn. ring. Qed.
Lemma nf_in_ok a x : nf_fit x = true -> ev a (nf_in x) = value (a, []) x.
Proof. destruct x as [x|l]; [reflexivity|discriminate]. Qed.
Theorem proves_sound h k w : proves h k w = true ->
  exists a, the_root (over k) a /\ exists n T listed, are_rows (a, []) w n T /\ are_facets (a, []) w (rank k) T listed /\ holds_of k (a, []) n T listed.
Proof.
  unfold proves. destruct (over k) as [|p lo hi d]; intros H.
  - unfold z_proved, proved in H. rewrite zmul_is in H. exists 0. split; [exact I|]. destruct (dimension k) as [|[|[|[|?]]]] eqn:D; try discriminate.
    + destruct (Pairing.triangles _ _) as [ts places]. unfold proved2 in H. destruct (shape2 z_fit k w ts places) eqn:S; [|discriminate].
      destruct (is_region k) eqn:RG.
      * apply z_region_theorem2 in H. apply (plane_region_link Z idZ z_fit z_in zpart IZR (0, []) z_in_ok k w ts places S D RG H).
      * apply z_theorem2 in H as [H1 H2]. apply (plane_link Z idZ z_fit z_in zpart IZR (0, []) z_in_ok k w ts places S D RG H1 H2).
    + destruct (Pairing.tetrahedra _ _) as [ts places]. unfold proved3 in H. destruct (shape3 z_fit k w ts places) eqn:S; [|discriminate].
      destruct (is_region k) eqn:RG.
      * apply z_region_theorem in H. apply (region_link Z Z.add Z.sub Z.mul idZ Z.leb z_fit z_in zpart IZR (0, []) z_in_ok k w ts places S D RG H).
      * apply fast_ok in H. apply z_theorem in H as [H1 H2].
        apply (space_link Z Z.add Z.sub Z.mul idZ Z.leb z_fit z_in zpart IZR (0, []) z_in_ok k w ts places S D RG H1 H2).
  - destruct h as [e0 es]. destruct (nf_root p e0 es lo hi d) eqn:R; [|discriminate].
    unfold nf_root in R. apply andb_true_iff in R as [M R]. apply same_list_eq in M. set (fl := removelast p) in *. clearbody fl.
    assert (ROOT : forall a, ev a (fl ++ [1%Z]) = 0 -> in_claimed (Encl lo hi d) a ->
      (forall x, ev x (fl ++ [1%Z]) = 0 -> in_claimed (Encl lo hi d) x -> x = a) -> the_root (Root p lo hi d) a).
    { intros a A1 A2 A3. rewrite <- M in A1, A3. cbn [the_root]. repeat split; auto; apply A2. }
    unfold nf_proved, proved in H. destruct (dimension k) as [|[|[|[|?]]]] eqn:D; try discriminate.
    + destruct (Pairing.triangles _ _) as [ts places]. unfold proved2 in H. destruct (shape2 nf_fit k w ts places) eqn:S; [|discriminate].
      destruct (is_region k) eqn:RG.
      * destruct (nf_region_theorem2 fl e0 es (Encl lo hi d) _ _ R H) as [a [A1 [A2 [A3 H1]]]]. exists a. split; [apply ROOT; auto|].
        apply (plane_region_link (list Z) lofZ nf_fit nf_in (nfpart e0) (ev a) (a, []) (nf_in_ok a) k w ts places S D RG H1).
      * destruct (nf_theorem2 fl e0 es (Encl lo hi d) _ _ R H) as [a [A1 [A2 [A3 [H1 H2]]]]]. exists a. split; [apply ROOT; auto|].
        apply (plane_link (list Z) lofZ nf_fit nf_in (nfpart e0) (ev a) (a, []) (nf_in_ok a) k w ts places S D RG H1 H2).
    + destruct (Pairing.tetrahedra _ _) as [ts places]. unfold proved3 in H. destruct (shape3 nf_fit k w ts places) eqn:S; [|discriminate].
      destruct (is_region k) eqn:RG.
      * destruct (nf_region_theorem fl e0 es (Encl lo hi d) _ _ R H) as [a [A1 [A2 [A3 H1]]]]. exists a. split; [apply ROOT; auto|].
        apply (region_link (list Z) ladd lsub (lmul fl) lofZ (lleb e0 es) nf_fit nf_in (nfpart e0) (ev a) (a, []) (nf_in_ok a) k w ts places S D RG H1).
      * apply fast_ok in H.
        destruct (nf_theorem fl e0 es (Encl lo hi d) _ _ R H) as [a [A1 [A2 [A3 [H1 H2]]]]]. exists a. split; [apply ROOT; auto|].
        apply (space_link (list Z) ladd lsub (lmul fl) lofZ (lleb e0 es) nf_fit nf_in (nfpart e0) (ev a) (a, []) (nf_in_ok a) k w ts places S D RG H1 H2).
Qed.

(** *** Families *)
Section OnBoxSound.
Variables (B : Type) (badd bsub bmul : B -> B -> B) (bofZ : Z -> B) (bnonneg bpos : B -> bool) (bfit : list Z -> bool) (bin : list Z -> B).
Variables (beta : B -> R) (a : R).
Hypothesis beta_add : forall x y, beta (badd x y) = beta x + beta y.
Hypothesis beta_sub : forall x y, beta (bsub x y) = beta x - beta y.
Hypothesis beta_mul : forall x y, beta (bmul x y) = beta x * beta y.
Hypothesis beta_Z : forall z, beta (bofZ z) = IZR z.
Hypothesis bnonneg_ok : forall b, bnonneg b = true -> 0 <= beta b.
Hypothesis bpos_ok : forall b, bpos b = true -> 0 < beta b.
Hypothesis bin_ok : forall x, bfit x = true -> beta (bin x) = at_root a x.
Notation ev_at := (pev B beta).
Lemma power_term_ok m : forall ts es c, List.length ts = m -> ev_at m ts (power_term B bofZ m es c) = beta c * power_product ts es.
Proof.
  induction m as [|m IH]; intros [|x ts] es c L; try discriminate; [cbn; ring|]. injection L as L.
  destruct es as [|e es]; cbn [power_term pev List.hd tl power_product].
  - cbn [at_value]. rewrite IH by auto. destruct ts; cbn; ring.
  - assert (E : forall n p, at_value (poly B m) (ev_at m ts) x (repeat (pofZ B bofZ m 0) n ++ [p]) = x ^ n * ev_at m ts p).
    { intros n p. induction n as [|n IHn]; cbn [repeat app at_value pow]; [ring|]. rewrite IHn, pev_Z by auto. ring. }
    rewrite E, IH by auto. ring.
Qed.
Lemma poly_in_ok m ts x : List.length ts = m -> poly_fit bfit x = true -> ev_at m ts (poly_in B badd bofZ bin m x) = value (a, ts) x.
Proof.
  intros L. destruct x as [x|l]; cbn [poly_fit poly_in value fst snd].
  - intros F. rewrite pev_constant. apply bin_ok, F.
  - induction l as [|c l IH]; cbn [forallb fold_right]; [intros _; apply pev_Z; auto|]. rewrite andb_true_iff. intros [F G].
    rewrite pev_add, power_term_ok, IH, bin_ok by auto. reflexivity.
Qed.
Lemma box_link ps ts : forallb (fun p => fit_limit bfit (p_low p) && fit_limit bfit (p_high p)) ps = true ->
  Denote.in_box a ps ts -> Family.in_box B beta (box_of B bmul bofZ bin ps) ts.
Proof.
  intros F I. unfold Denote.in_box in I. unfold Family.in_box, box_of. induction I as [|p t ps ts [L H] _ IH]; cbn [map forallb] in *; constructor.
  - apply andb_true_iff in F as [F _]. unfold fit_limit in F. rewrite !andb_true_iff, !Z.ltb_lt in F. destruct F as [[D1 F1] [D2 F2]].
    unfold in_interval, interval_of. cbn [low high low_closed high_closed den]. rewrite !beta_mul, !beta_Z, !bin_ok by auto.
    unfold limit_value in L, H. rewrite mult_IZR. apply IZR_lt in D1, D2.
    set (x := at_root a (numerator (p_low p))) in *. set (y := at_root a (numerator (p_high p))) in *.
    set (d := IZR (divisor (p_low p))) in *. set (e := IZR (divisor (p_high p))) in *.
    assert (X : x = x / d * d) by (field; lra). assert (Y : y = y / e * e) by (field; lra). split.
    + rewrite X. destruct (is_closed (p_low p)).
      * replace (e * (x / d * d)) with (d * e * (x / d)) by ring. apply Rmult_le_compat_l; [|exact L]. apply Rlt_le, Rmult_lt_0_compat; auto.
      * replace (e * (x / d * d)) with (d * e * (x / d)) by ring. apply Rmult_lt_compat_l; [|exact L]. apply Rmult_lt_0_compat; auto.
    + rewrite Y. destruct (is_closed (p_high p)).
      * replace (d * (y / e * e)) with (d * e * (y / e)) by ring. apply Rmult_le_compat_l; [|exact H]. apply Rlt_le, Rmult_lt_0_compat; auto.
      * replace (d * (y / e * e)) with (d * e * (y / e)) by ring. apply Rmult_lt_compat_l; [|exact H]. apply Rmult_lt_0_compat; auto.
  - apply IH. apply andb_true_iff in F as [_ F]. exact F.
Qed.
Theorem family_proved_sound ps k t w : family_proved B badd bsub bmul bofZ bnonneg bpos bfit bin ps k t w = true ->
  forall ts, Denote.in_box a ps ts -> exists n T listed, are_rows (a, ts) w n T /\ are_facets (a, ts) w (rank k) T listed /\ holds_of k (a, ts) n T listed.
Proof.
  unfold family_proved. destruct (fit_box _ _ _ _ _ _ _ _ _) eqn:FB; [|discriminate]. intros H ts I.
  unfold fit_box in FB. rewrite !andb_true_iff in FB. destruct FB as [[F1 F2] F3]. apply negb_true_iff in F3.
  assert (L : List.length ts = List.length ps) by (clear - I; induction I; cbn; congruence).
  pose proof (box_link ps ts F1 I) as IB. unfold every_leaf in H.
  destruct (at_point B badd bsub bpos beta beta_add beta_sub bpos_ok _ _ F2 _ ts H IB) as [l [G [O Il]]]. clear H.
  set (m := List.length ps) in *. pose proof (fun x => poly_in_ok m ts x L) as IN.
  unfold proved in G. destruct (dimension k) as [|[|[|[|?]]]] eqn:D; try discriminate.
  - destruct (Pairing.triangles _ _) as [tris places]. unfold proved2 in G. destruct (shape2 (poly_fit bfit) k w tris places) eqn:S; [|discriminate].
    rewrite F3 in G.
    destruct (leaf_sound2 B badd bsub bmul bofZ bnonneg bpos beta beta_add beta_sub beta_mul beta_Z bnonneg_ok bpos_ok m l ts O Il _ _ G) as [H1 H2].
    apply (plane_link (poly B m) (pofZ B bofZ m) (poly_fit bfit) (poly_in B badd bofZ bin m) (fun _ _ => 0%Z) (ev_at m ts) (a, ts) IN k w tris places S D F3 H1 H2).
  - destruct (Pairing.tetrahedra _ _) as [tets places]. unfold proved3 in G. destruct (shape3 (poly_fit bfit) k w tets places) eqn:S; [|discriminate].
    rewrite F3 in G.
    destruct (leaf_sound B badd bsub bmul bofZ bnonneg bpos beta beta_add beta_sub beta_mul beta_Z bnonneg_ok bpos_ok m l ts O Il _ _ G) as [H1 H2].
    apply (space_link (poly B m) (padd B badd m) (psub B bsub bofZ m) (pmul B badd bmul bofZ m) (pofZ B bofZ m) (ple B badd bsub bmul bofZ bnonneg m l)
      (poly_fit bfit) (poly_in B badd bofZ bin m) (fun _ _ => 0%Z) (ev_at m ts) (a, ts) IN k w tets places S D F3 H1 H2).
Qed.
End OnBoxSound.
Lemma one_ok x : one x = true -> IZR (List.hd 0%Z x) = at_root 0 x.
Proof. destruct x as [|b [|? ?]]; try discriminate. intros _. cbn. ring. Qed.
Theorem family_proves_sound h ps k t w : family_proves h ps k t w = true ->
  exists a, the_root (over k) a /\ forall ts, Denote.in_box a ps ts ->
    exists n T listed, are_rows (a, ts) w n T /\ are_facets (a, ts) w (rank k) T listed /\ holds_of k (a, ts) n T listed.
Proof.
  unfold family_proves. destruct (over k) as [|p lo hi d]; intros H.
  - exists 0. split; [exact I|].
    apply (family_proved_sound Z Z.add Z.sub zmul idZ (Z.leb 0) (Z.ltb 0) one (List.hd 0%Z) IZR 0 plus_IZR minus_IZR zmul_IZR (fun _ => eq_refl)) with (t := t); auto.
    + intros b Hb. apply IZR_le, Z.leb_le, Hb. + intros b Hb. apply IZR_lt, Z.ltb_lt, Hb. + apply one_ok.
  - destruct h as [e0 es]. destruct (nf_root p e0 es lo hi d) eqn:Rt; [|discriminate].
    unfold nf_root in Rt. apply andb_true_iff in Rt as [M Rt]. apply same_list_eq in M. set (fl := removelast p) in *. clearbody fl.
    destruct (isolated_root fl e0 es (Encl lo hi d) Rt) as [a [A1 [A2 [A3 A4]]]]. exists a. split.
    { rewrite <- M in A1, A3. cbn [the_root]. repeat split; auto; apply A2. }
    apply (family_proved_sound (list Z) ladd lsub (lmul fl) lofZ (nf_nonneg e0 es) (lpos (es ++ [e0])) all_fit itself (ev a) a
      (ev_add a) (ev_sub a) (ev_mul fl a A1) (ev_ofZ a)) with (t := t); auto.
    + intros b. unfold nf_nonneg. destruct (forallb (Z.eqb 0) b) eqn:E; [intros _; rewrite (ev_zeros a b E); lra|]. intros Hb. apply Rlt_le, (lpos_ok a _ b A4 Hb).
    + intros b Hb. apply (lpos_ok a _ b A4 Hb).
Qed.

(** *** Systems of patches *)
Theorem patches_sound h k ws : patches_prove h k ws = true -> exists a, the_root (base_field k) a /\ holds_over_mosaics (a, []) k ws.
Proof.
  unfold patches_prove. destruct (base_field k) as [|p lo hi d]; intros H.
  - exists 0. split; [exact I|].
    apply (patches_link Z Z.add Z.sub zmul idZ Z.ltb Z.leb z_content z_quot z_fit z_in IZR (0, []) plus_IZR minus_IZR zmul_IZR (fun _ => eq_refl) zltb_ok zleb_ok z_in_ok k ws H).
  - destruct h as [e0 es]. destruct (nf_root p e0 es lo hi d) eqn:Rt; [|discriminate].
    unfold nf_root in Rt. apply andb_true_iff in Rt as [M Rt]. apply same_list_eq in M. set (fl := removelast p) in *. clearbody fl.
    destruct (isolated_root fl e0 es (Encl lo hi d) Rt) as [a [A1 [A2 [A3 A4]]]]. exists a. split.
    { rewrite <- M in A1, A3. cbn [the_root]. repeat split; auto; apply A2. }
    apply (patches_link (list Z) ladd lsub (lmul fl) lofZ (lltb e0 es) (lleb e0 es) nf_content nf_quot nf_fit nf_in (ev a) (a, [])
      (ev_add a) (ev_sub a) (ev_mul fl a A1) (ev_ofZ a) (lltb_ok e0 es a A4) (lleb_ok e0 es a A4) (nf_in_ok a) k ws H).
Qed.

(** What the certificate shows implies its claim. *)
Theorem shows_meaning c : shows c -> meaning (claim_of c).
Proof.
  destruct c as [k w|ps k t w|k ws]; cbn [shows claim_of meaning]; intros [a [R H]].
  3:{ exists a. split; auto. exists ws. exact H. }
  2:{ exists a. split; auto. intros ts I. destruct (H ts I) as [n [T [l [_ [_ X]]]]]. exists n, T, l. exact X. }
  destruct H as [n [T [l [_ [_ H]]]]]. exists a. split; auto. exists n, T, l. exact H.
Qed.
Theorem accepted s k : accepts s = Some k -> exists c, s = print c /\ claim_of c = k /\ shows c /\ meaning k.
Proof.
  unfold accepts, judge. destruct (items s) as [|[z|t|l]| |]; try discriminate.
  destruct l as [|[z|format|l'] l]; try discriminate. destruct l as [|[version|t|l'] l]; try discriminate.
  destruct (negb _); [discriminate|]. destruct (negb _); [discriminate|].
  destruct l as [|[z|kind|l'] l]; try discriminate. destruct l as [|k0 l]; try discriminate. destruct l as [|w0 l]; try discriminate.
  destruct l; [|discriminate]. destruct (negb _); [discriminate|].
  destruct (if String.eqb kind "tiling" then read_tiling k0 w0 else if String.eqb kind "family" then read_family k0 w0 else read_patches k0 w0) as [c|]; [|discriminate]. destruct (same_bytes s (fast_print c)) eqn:E; [|discriminate].
  apply same_bytes_eq in E. rewrite fast_print_eq in E. intros H. exists c. split; [exact E|].
  unfold judged in H. destruct c as [kk w|ps kk t w|kk ws].
  3:{ destruct (patches_refusal kk ws); [discriminate|].
    destruct (patches_prove (hint_for (base_field kk)) kk ws) eqn:P; [|discriminate]. injection H as <-. split; [reflexivity|].
    apply patches_sound in P. split; [exact P|]. apply (shows_meaning (Patches kk ws) P). }
  2:{ destruct (family_refusal ps kk t w); [discriminate|]. destruct (denominators_agree kk w); [|discriminate]. cbv zeta in H.
    set (h := hint_for (over kk)) in H. clearbody h. destruct (box_in_order h ps kk); [|discriminate]. cbn [negb] in H.
    destruct (family_polytope_ok h ps kk t w); [|discriminate]. destruct (family_proves h ps kk t w) eqn:P; [|discriminate].
    destruct (bits_agree kk w); [|discriminate]. injection H as <-. split; [reflexivity|].
    apply family_proves_sound in P. split; [exact P|]. apply (shows_meaning (Family ps kk t w) P). }
  destruct (claim_refusal 0 kk); [discriminate|]. destruct (witness_refusal 0 kk w); [discriminate|].
  destruct (denominators_agree kk w); [|discriminate]. cbv zeta in H. set (h := hint_for (over kk)) in H. clearbody h.
  destruct (too_many_cells h kk w); [discriminate|].
  destruct (polytope_ok h kk w); [|discriminate]. destruct (proves h kk w) eqn:P; [|discriminate].
  destruct (bits_agree kk w); [|discriminate]. injection H as <-. split; [reflexivity|].
  apply proves_sound in P. split; [exact P|]. apply (shows_meaning (Tiling kk w) P).
Qed.
(** The same without the certificate's own simplices. *)
Theorem bytes_theorem s k : accepts s = Some k -> exists c, s = print c /\ claim_of c = k /\ meaning k.
Proof. intros H. destruct (accepted s k H) as [c [H1 [H2 [_ H3]]]]. exists c. auto. Qed.
