(** * Theorems for another development

    This file is the entrance of the installed library.  [Import Certificate] makes the
    definitions of the statement files visible, but those of MosaicStatement.v, and the following.

    - [hex "8573…"] is the list of bytes with these digits.
    - [acutile s] proves a goal about the certificate with the bytes s.  It runs the checker
      on s, and uses the theorem [accepted].  It fails if the checker does not accept s, and
      if the goal does not follow from the sentences of the claim.
    - [acutile s at (x :: y :: nil)] does it for a family and the values x, y of its parameters.  It
      shows by linear arithmetic that they are in the box: intervals are hypotheses.

    The goal is about real space or the real plane, in the words of the statement files.  It
    has one of these shapes, with the Gram matrix and the sentences of the claim, or some of
    them:

      [forall l1 l2 l3, has_gram G l1 l2 l3 -> exists n P, face_to_face_tiling l1 l2 l3 … /\ acute … /\ …]
      [exists l1 l2 l3, has_gram G l1 l2 l3 /\ exists n P, …]
      [exists c, s = print c /\ claim_of c = k /\ shows c /\ meaning k]
      [meaning k]

    For a system of patches the goal has one of the last two.
    In the plane, [l1 l2], [has_gram2] and [edge_to_edge_tiling] take the place of the first
    two.  For a region they say [exists n P listed, face_to_face_region … listed].  Numbers and bounds
    are equal to those of the claim by the laws of a field.  Over a number field the first two
    begin with [exists a, the_root f a /\ …], and a is in the numbers.

    Nothing here needs trust: a theorem that [acutile] proves says what is written in it. *)
From Coq Require Import Lra.
From Coq Require Export Reals NArith ZArith List.
From Coq Require Export Init.Byte.
From Coq Require Strings.Byte.
From Acutile Require Export Statement PlaneStatement RegionStatement PlaneRegionStatement Denote.
From Acutile Require Bytes.
Import ListNotations.
Local Open Scope R_scope.

(** ** Bytes by hexadecimal digits

    A text in quotes, and the numbers of its characters.  Its type is one of its own, so that [Coq.Strings.String]
    with its other [length] is not imported. *)
Inductive digits := Digits (l : list byte).
Definition characters (d : digits) : list byte := let '(Digits l) := d in l.
Declare Scope hex_scope.
String Notation digits Digits characters : hex_scope.
Definition digit (c : byte) : N := let n := Strings.Byte.to_N c in (if n <? 58 then n - 48 else n - 87)%N.
(** Two digits are a byte.  Blanks and line breaks are left out; what else is no digit makes some byte. *)
Fixpoint pairs (l : list N) : bytes := match l with x :: y :: l => byte_of (16 * x + y)%N :: pairs l | _ => [] end.
Definition hex (d : digits) : bytes := pairs (map digit (filter (fun c => 48 <=? Strings.Byte.to_N c)%N (characters d))).
Arguments hex d%hex_scope.

(** ** What a claim gives *)
Lemma meaning_of s k : Acutile.Bytes.accepts s = Some k -> meaning k.
Proof. intros H. destruct (Acutile.Bytes.accepted s k H) as [c [_ [_ [_ M]]]]. exact M. Qed.
Lemma each {X} (P : X -> Prop) l : (forall x, In x l -> P x) -> fold_right (fun x => and (P x)) True l.
Proof. induction l as [|x l IH]; cbn; intros H; [exact I|]. split; [apply H; auto|]. apply IH. intros y Hy. apply H. auto. Qed.

(** ** The tactic *)

(** Two terms that differ by numbers, equal by the laws of a field. *)
Ltac same_numbers := first [reflexivity | (cbn; first [reflexivity | field]) | (progress f_equal; same_numbers)].
Ltac same_terms := 
  unfold angle_bound, gram_of, gram2_of, polytope_points, origin, origin2;
  cbn [gram_rows rank dimension region_of polytope_of p_vertices p_denominator map repeat app Nat.sub as_point as_point2 value at_root power_product fold_right fst snd];
  repeat match goal with |- context [N.to_nat ?e] => let e' := eval vm_compute in (N.to_nat e) in change (N.to_nat e) with e' end;
  same_numbers.
(** A sentence of the claim is the goal, up to numbers. *)
Ltac same_sentence :=
  match goal with
  | H : ?P |- ?P => exact H
  | H : ?f _ _ _ _ ?x _ _ |- ?f _ _ _ _ ?y _ _ => replace y with x by same_terms; exact H
  | H : ?f _ _ _ ?x _ _ |- ?f _ _ _ ?y _ _ => replace y with x by same_terms; exact H
  | H : ?f _ _ _ _ _ _ ?rel ?x |- ?f _ _ _ _ _ _ ?rel ?y => replace y with x by same_terms; exact H
  | H : ?f _ _ _ _ _ ?rel ?x |- ?f _ _ _ _ _ ?rel ?y => replace y with x by same_terms; exact H
  | H : _ |- _ => exact H
  end.
Ltac all_sentences H :=
  apply each in H;
  cbn [fold_right space_sentence plane_sentence sentences region_of] in H;
  repeat match type of H with _ /\ _ => let S := fresh "S" in destruct H as [S H] end.
Ltac for_bases n T listed H :=
  lazymatch goal with
  | |- exists n P, _ => idtac
  | _ => fail "acutile: after the basis the goal does not say: exists n P, …"
  end;
  exists n; eexists; try (lazymatch goal with |- exists f, _ => exists listed end); all_sentences H;
  repeat match goal with |- _ /\ _ => split end;
  first [same_sentence | fail 1 "acutile: the claim does not say this, or not in these numbers"].
Ltac root_of a R :=
  cbn [over] in R;
  lazymatch goal with
  | |- exists a, the_root _ a /\ _ => exists a; split; [exact R|]
  | _ => idtac
  end.
(** The values are in the box, by linear arithmetic from the hypotheses. *)
Ltac in_the_box :=
  unfold in_box; repeat apply Forall2_cons; try apply Forall2_nil;
  unfold in_range, limit_value; cbn [is_closed p_low p_high numerator divisor at_root]; lra.
Ltac about_claim n T listed E H :=
  lazymatch goal with
  | |- forall l1 l2 l3, has_gram ?G l1 l2 l3 -> _ =>
    let G' := lazymatch type of E with exists l1 l2 l3, has_gram ?G' l1 l2 l3 => G' end in
    let l1 := fresh "l1" in let l2 := fresh "l2" in let l3 := fresh "l3" in let HG := fresh "HG" in
    intros l1 l2 l3 HG; replace G with G' in HG by same_terms; specialize (H l1 l2 l3 HG); for_bases n T listed H
  | |- exists l1 l2 l3, has_gram ?G l1 l2 l3 /\ _ =>
    let G' := lazymatch type of E with exists l1 l2 l3, has_gram ?G' l1 l2 l3 => G' end in
    let l1 := fresh "l1" in let l2 := fresh "l2" in let l3 := fresh "l3" in let HG := fresh "HG" in
    destruct E as [l1 [l2 [l3 HG]]]; exists l1, l2, l3; split;
    [replace G with G' by same_terms; exact HG | specialize (H l1 l2 l3 HG); for_bases n T listed H]
  | |- forall l1 l2, has_gram2 ?G l1 l2 -> _ =>
    let G' := lazymatch type of E with exists l1 l2, has_gram2 ?G' l1 l2 => G' end in
    let l1 := fresh "l1" in let l2 := fresh "l2" in let HG := fresh "HG" in
    intros l1 l2 HG; replace G with G' in HG by same_terms; specialize (H l1 l2 HG); for_bases n T listed H
  | |- exists l1 l2, has_gram2 ?G l1 l2 /\ _ =>
    let G' := lazymatch type of E with exists l1 l2, has_gram2 ?G' l1 l2 => G' end in
    let l1 := fresh "l1" in let l2 := fresh "l2" in let HG := fresh "HG" in
    destruct E as [l1 [l2 HG]]; exists l1, l2; split;
    [replace G with G' by same_terms; exact HG | specialize (H l1 l2 HG); for_bases n T listed H]
  | _ => fail "acutile: the goal has none of the shapes of Certificate.v"
  end.
Ltac about_tiling M :=
  let a := fresh "a" in let R := fresh "R" in let n := fresh "n" in let T := fresh "T" in let listed := fresh "listed" in
  let E := fresh "E" in let H := fresh "H" in
  lazymatch type of M with
  | meaning (OfTiling _) => cbn [meaning] in M; destruct M as [a [R [n [T [listed [_ [E H]]]]]]]; root_of a R; about_claim n T listed E H
  | meaning (OfPatches _) => fail "acutile: for a system of patches the goal must be: meaning k"
  | _ => fail "acutile: a family needs values of its parameters: acutile s at (t1 :: … :: nil)"
  end.
Ltac about_member M ts :=
  let a := fresh "a" in let R := fresh "R" in let n := fresh "n" in let T := fresh "T" in let listed := fresh "listed" in
  let E := fresh "E" in let H := fresh "H" in let B := fresh "B" in
  lazymatch type of M with
  | meaning (OfFamily ?ps _) =>
    cbn [meaning] in M; destruct M as [a [R M]]; root_of a R;
    assert (B : in_box a ps ts) by (first [in_the_box | fail 1 "acutile: the values are not seen to be in the box"]);
    destruct (M ts B) as [n [T [listed [_ [E H]]]]]; clear M; about_claim n T listed E H
  | _ => fail "acutile: this certificate is no family"
  end.
Ltac with_claim s about :=
  let accepted := eval vm_compute in (Acutile.Bytes.accepts s) in
  lazymatch accepted with
  | Some ?k =>
    let A := fresh "A" in
    assert (A : Acutile.Bytes.accepts s = Some k) by (vm_cast_no_check (eq_refl (Some k)));
    lazymatch goal with
    | |- exists c, _ = print c /\ _ => exact (Acutile.Bytes.accepted s k A)
    | |- meaning _ => exact (meaning_of s k A)
    | _ => let M := fresh "M" in pose proof (meaning_of s k A) as M; clear A; about M
    end
  | None => fail "acutile: the checker does not accept these bytes"
  end.
Tactic Notation "acutile" constr(s) := with_claim s about_tiling.
Tactic Notation "acutile" constr(s) "at" constr(ts) := with_claim s ltac:(fun M => about_member M ts).
