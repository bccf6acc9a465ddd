(** * Exact numbers: the integers, and Z[alpha] for a real algebraic integer

    alpha is the root of a monic integer polynomial in an interval with rational
    ends.  An element of Z[alpha] is the list of its coefficients.  Equality is
    equality of coefficients; a strict sign is proved by interval arithmetic at an
    enclosure of the root.  Both are sound whether or not the polynomial is
    irreducible. *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Statement PlaneStatement Multiply Checker PlaneChecker Soundness PlaneSoundness.
Import ListNotations.
Local Open Scope Z_scope.

(** ** The integers *)
Definition idZ (z : Z) := z.
Definition zcheck : cert Z -> list (cstatement Z) -> bool := check Z Z.add Z.sub Z.mul idZ Z.ltb Z.leb.
(** A certificate, its hints computed from the faces of the polytope. *)
Definition zcert := faces_cert Z Z.add Z.sub Z.mul idZ Z.leb.
Lemma zltb_ok x y : Z.ltb x y = true -> (IZR x < IZR y)%R.
Proof. intros H. apply IZR_lt, Z.ltb_lt, H. Qed.
Lemma zleb_ok x y : Z.leb x y = true -> (IZR x <= IZR y)%R.
Proof. intros H. apply IZR_le, Z.leb_le, H. Qed.
Theorem z_sound c ss : zcheck c ss = true -> forall l1 l2 l3, has_gram (dgram Z IZR c) l1 l2 l3 ->
  face_to_face_tiling l1 l2 l3 (c_rank Z c) (ddomain Z IZR c l1 l2 l3) (length (c_tets Z c)) (dtet Z idZ IZR c l1 l2 l3) /\
  forall s, In s (map (dstatement Z IZR) ss) -> holds l1 l2 l3 (c_rank Z c) (length (c_tets Z c)) (dtet Z idZ IZR c l1 l2 l3) s.
Proof. apply (check_sound Z Z.add Z.sub Z.mul idZ Z.ltb Z.leb IZR plus_IZR minus_IZR mult_IZR (fun _ => eq_refl) zltb_ok zleb_ok). Qed.
Theorem z_basis c ss : zcheck c ss = true -> exists l1 l2 l3, has_gram (dgram Z IZR c) l1 l2 l3.
Proof. apply (basis_exists Z Z.add Z.sub Z.mul idZ Z.ltb Z.leb IZR plus_IZR minus_IZR mult_IZR (fun _ => eq_refl) zltb_ok). Qed.

(** The same in the plane. *)
Definition zcheck2 : cert2 Z -> list (cstatement Z) -> bool := check2 Z Z.add Z.sub Z.mul idZ Z.ltb Z.leb.
Theorem z_theorem2 c ss : zcheck2 c ss = true ->
  (exists l1 l2, has_gram2 (dgram2 Z IZR c) l1 l2) /\
  forall l1 l2, has_gram2 (dgram2 Z IZR c) l1 l2 ->
  edge_to_edge_tiling l1 l2 (e_rank Z c) (ddomain2 Z IZR c l1 l2) (length (e_tris Z c)) (dtriangle Z idZ IZR c l1 l2) /\
  forall s, In s (map (dstatement Z IZR) ss) -> holds2 l1 l2 (e_rank Z c) (length (e_tris Z c)) (dtriangle Z idZ IZR c l1 l2) s.
Proof. apply (check2_sound Z Z.add Z.sub Z.mul idZ Z.ltb Z.leb IZR plus_IZR minus_IZR mult_IZR (fun _ => eq_refl) zltb_ok zleb_ok). Qed.

(** ** Number fields *)
Fixpoint ladd (p q : list Z) : list Z :=
  match p, q with [], _ => q | _, [] => p | a :: p, b :: q => (a + b) :: ladd p q end.
Definition lscl (a : Z) (p : list Z) := map (zmul a) p.
Fixpoint lsub (p q : list Z) : list Z :=
  match p, q with [], _ => lscl (-1) q | _, [] => p | a :: p, b :: q => (a - b) :: lsub p q end.
Definition lofZ (z : Z) : list Z := [z].

Definition imul (l1 h1 l2 h2 : Z) : Z * Z :=
  let a := zmul l1 l2 in let b := zmul l1 h2 in let c := zmul h1 l2 in let d := zmul h1 h2 in
  (Z.min (Z.min a b) (Z.min c d), Z.max (Z.max a b) (Z.max c d)).

Section NF.
Variable fl : list Z.
(* alpha^d + f_{d-1} alpha^{d-1} + ... + f_0 = 0 *)
Definition lmulx (q : list Z) : list Z :=
  if Nat.eqb (length q) (length fl) then lsub (0 :: removelast q) (lscl (last q 0) fl) else 0 :: q.
Fixpoint lmul (p q : list Z) : list Z :=
  match p with
  | [] => []
  | [a] => lscl a q
  | a :: p => ladd (lscl a q) (lmulx (lmul p q))
  end.
(* enclosures lo/S <= alpha <= hi/S: coarse ones first (cheap), the last one is the finest.  S is mostly a power of two:
   it is the first factor, because Z.mul adds once for each bit of that one that is set. *)
Record encl := Encl { e_lo : Z; e_hi : Z; e_S : Z }.
Section Enc.
Variables lo hi S : Z.
Fixpoint lint (p : list Z) : Z * Z * Z :=
  match p with
  | [] => (0, 0, 1)
  | a :: p => let '(l, h, P) := lint p in
     let '(l', h') := imul lo hi l h in let P' := P * S in let m := P' * a in (m + l', m + h', P')
  end.
End Enc.
Fixpoint lpos (es : list encl) (p : list Z) : bool :=
  match es with
  | [] => false
  | e :: es => let '(l, h, _) := lint (e_lo e) (e_hi e) (e_S e) p in
     if Z.ltb 0 l then true else if Z.leb h 0 then false else lpos es p
  end.
Variables (e0 : encl) (es : list encl).   (* e0: the finest one *)
Definition lltb (p q : list Z) : bool := lpos (es ++ [e0]) (lsub q p).

(** x <= y: equal as coefficient vectors, or strictly by an enclosure. *)
Definition lleb (p q : list Z) : bool :=
  let d := lsub q p in if forallb (Z.eqb 0) d then true else lpos (es ++ [e0]) d.

Definition nfcheck (c : cert (list Z)) (ss : list (cstatement (list Z))) : bool := check (list Z) ladd lsub lmul lofZ lltb lleb c ss.
Definition nfcert := faces_cert (list Z) ladd lsub lmul lofZ lleb.

Definition nfcheck2 (c : cert2 (list Z)) (ss : list (cstatement (list Z))) : bool := check2 (list Z) ladd lsub lmul lofZ lltb lleb c ss.

(* root isolation: sign change of the polynomial, computed exactly *)
Fixpoint hev (S : Z) (p : list Z) (a : Z) : Z * Z :=   (* (S^k p(a/S), S^k) with k = length p *)
  match p with [] => (0, 1) | c :: p => let '(v, P) := hev S p a in let P' := P * S in (P' * c + zmul a v, P') end.
Definition isol : bool :=
  let lo := e_lo e0 in let hi := e_hi e0 in let S := e_S e0 in
  (0 <? S) && (lo <=? hi) && (fst (hev S (fl ++ [1]) lo) * fst (hev S (fl ++ [1]) hi) <=? 0) &&
  forallb (fun e => (0 <? e_S e) && (e_lo e * S <=? lo * e_S e) && (hi * e_S e <=? e_hi e * S)) es.

Local Open Scope R_scope.
Section Alpha.
Variable al : R.
Fixpoint ev (p : list Z) : R := match p with [] => 0 | a :: p => IZR a + al * ev p end.
Hypothesis root : ev (fl ++ [1%Z]) = 0.
Definition encl_ok (e : encl) := (0 < e_S e)%Z /\ IZR (e_lo e) <= al * IZR (e_S e) /\ al * IZR (e_S e) <= IZR (e_hi e).
Hypothesis al_encl : forall e, In e (es ++ [e0]) -> encl_ok e.

Lemma ev_add p q : ev (ladd p q) = ev p + ev q.
Proof. revert q. induction p; destruct q; simpl; try lra. rewrite IHp, plus_IZR. ring. Qed.
Lemma ev_scl a p : ev (lscl a p) = IZR a * ev p.
Proof. unfold lscl. induction p as [|b p IH]; cbn [map ev]. - ring. - rewrite IH, zmul_IZR. ring. Qed.
Lemma ev_sub p q : ev (lsub p q) = ev p - ev q.
Proof.
  revert q. induction p as [|a p IH]; destruct q as [|b q].
  - simpl. lra.
  - cbn [lsub]. rewrite ev_scl. simpl (ev []). lra.
  - simpl. lra.
  - cbn [lsub ev]. rewrite IH, minus_IZR. ring.
Qed.
Lemma ev_app p c : ev (p ++ [c]) = ev p + IZR c * al ^ (length p).
Proof. induction p; simpl. - ring. - rewrite IHp. ring. Qed.
Lemma ev_mulx q : ev (lmulx q) = al * ev q.
Proof.
  unfold lmulx. destruct (Nat.eqb_spec (length q) (length fl)) as [E|E]; [|simpl; ring].
  rewrite ev_sub, ev_scl. cbn [ev]. pose proof root as R. rewrite ev_app in R.
  destruct q as [|x q'].
  - simpl in E. simpl. rewrite <- E in R. simpl in R.
    symmetry in E. apply length_zero_iff_nil in E. rewrite E. simpl. lra.
  - assert (NE : x :: q' <> []) by discriminate.
    pose proof (app_removelast_last 0%Z NE) as AR. set (q := x :: q') in *.
    set (r := removelast q) in *. set (l := last q 0%Z) in *. 
    assert (Hl : length fl = Datatypes.S (length r)).
    { rewrite <- E, AR, app_length. simpl. lia. }
    rewrite AR, ev_app. rewrite Hl in R. simpl in R.
    replace (ev fl) with (- (al * al ^ length r)) by lra. ring.
Qed.
Lemma ev_mul p q : ev (lmul p q) = ev p * ev q.
Proof.
  induction p as [|a p IH]; [simpl; ring|]. destruct p as [|b p].
  - simpl. rewrite ev_scl. simpl. ring.
  - change (lmul (a :: b :: p) q) with (ladd (lscl a q) (lmulx (lmul (b :: p) q))).
    rewrite ev_add, ev_scl, ev_mulx, IH. cbn [ev]. ring.
Qed.
Lemma ev_ofZ z : ev (lofZ z) = IZR z.
Proof. simpl. ring. Qed.

Lemma imul_ok l1 h1 l2 h2 u v :
  IZR l1 <= u <= IZR h1 -> IZR l2 <= v <= IZR h2 ->
  IZR (fst (imul l1 h1 l2 h2)) <= u * v <= IZR (snd (imul l1 h1 l2 h2)).
Proof.
  intros [U1 U2] [V1 V2]. unfold imul. rewrite !zmul_eq. cbn [fst snd].
  set (mn := Z.min _ _). set (mx := Z.max _ _).
  assert (K : (mn <= l1 * l2 /\ mn <= l1 * h2 /\ mn <= h1 * l2 /\ mn <= h1 * h2 /\
               l1 * l2 <= mx /\ l1 * h2 <= mx /\ h1 * l2 <= mx /\ h1 * h2 <= mx)%Z) by (unfold mn, mx; lia).
  clearbody mn mx. destruct K as [K1 [K2 [K3 [K4 [K5 [K6 [K7 K8]]]]]]].
  apply IZR_le in K1, K2, K3, K4, K5, K6, K7, K8. rewrite !mult_IZR in *.
  assert (A1 : forall s, 0 <= v -> s = u * v -> IZR l1 * v <= s <= IZR h1 * v) by (intros; subst; split; apply Rmult_le_compat_r; lra).
  assert (A2 : forall s, v <= 0 -> s = u * v -> IZR h1 * v <= s <= IZR l1 * v).
  { intros s Hv ->. assert (0 <= (u - IZR l1) * - v) by (apply Rmult_le_pos; lra).
    assert (0 <= (IZR h1 - u) * - v) by (apply Rmult_le_pos; lra). lra. }
  assert (B : forall c, IZR mn <= c * IZR l2 -> IZR mn <= c * IZR h2 -> c * IZR l2 <= IZR mx -> c * IZR h2 <= IZR mx -> IZR mn <= c * v <= IZR mx).
  { intros c X1 X2 X3 X4. destruct (Rle_dec 0 c).
    - assert (0 <= c * (v - IZR l2)) by (apply Rmult_le_pos; lra). assert (0 <= c * (IZR h2 - v)) by (apply Rmult_le_pos; lra). lra.
    - assert (0 <= - c * (v - IZR l2)) by (apply Rmult_le_pos; lra). assert (0 <= - c * (IZR h2 - v)) by (apply Rmult_le_pos; lra). lra. }
  pose proof (B (IZR l1) K1 K2 K5 K6). pose proof (B (IZR h1) K3 K4 K7 K8).
  destruct (Rle_dec 0 v); [specialize (A1 (u * v)) | specialize (A2 (u * v))]; lra.
Qed.

Lemma lint_ok e p : encl_ok e -> let '(l, h, P) := lint (e_lo e) (e_hi e) (e_S e) p in 0 < IZR P /\ IZR l <= IZR P * ev p <= IZR h.
Proof.
  intros [S_pos [al_lo al_hi]]. set (lo := e_lo e) in *. set (hi := e_hi e) in *. set (S := e_S e) in *.
  induction p as [|a p IH]; cbn [lint ev]; [lra|].
  destruct (lint lo hi S p) as [[l h] P]. destruct IH as [HP IH].
  pose proof (imul_ok lo hi l h (al * IZR S) (IZR P * ev p) (conj al_lo al_hi) IH) as M.
  destruct (imul lo hi l h) as [l' h']. cbn [fst snd] in M.
  apply IZR_lt in S_pos. rewrite !plus_IZR, !mult_IZR. split; [apply Rmult_lt_0_compat; auto|].
  assert (Q : IZR P * IZR S * (IZR a + al * ev p) = IZR a * (IZR P * IZR S) + (al * IZR S) * (IZR P * ev p)) by ring.
  rewrite Q. lra.
Qed.
Lemma lpos_ok l p : (forall e, In e l -> encl_ok e) -> lpos l p = true -> 0 < ev p.
Proof.
  induction l as [|e l IH]; intros H K; [discriminate|]. cbn [lpos] in K.
  pose proof (lint_ok e p (H e (or_introl eq_refl))) as X.
  destruct (lint (e_lo e) (e_hi e) (e_S e) p) as [[lw hg] P]. destruct X as [HP [X _]].
  destruct (Z.ltb_spec 0 lw) as [Y|Y].
  - apply IZR_lt in Y. nra.
  - destruct (Z.leb hg 0); [discriminate|]. apply IH; auto. intros; apply H; right; auto.
Qed.
Lemma lltb_ok p q : lltb p q = true -> ev p < ev q.
Proof. unfold lltb. intros H. apply lpos_ok in H; auto. rewrite ev_sub in H. lra. Qed.
Lemma ev_zeros p : forallb (Z.eqb 0) p = true -> ev p = 0.
Proof.
  induction p as [|a p IH]; cbn [forallb ev]; auto. rewrite andb_true_iff, Z.eqb_eq. intros [<- H]. rewrite IH by auto. ring.
Qed.
Lemma lleb_ok p q : lleb p q = true -> ev p <= ev q.
Proof.
  unfold lleb. cbv zeta. destruct (forallb (Z.eqb 0) (lsub q p)) eqn:E; intros H.
  - apply ev_zeros in E. rewrite ev_sub in E. lra.
  - apply lpos_ok in H; auto. rewrite ev_sub in H. lra.
Qed.

Theorem nf_sound c ss : nfcheck c ss = true -> forall l1 l2 l3, has_gram (dgram (list Z) ev c) l1 l2 l3 ->
  face_to_face_tiling l1 l2 l3 (c_rank _ c) (ddomain (list Z) ev c l1 l2 l3) (length (c_tets _ c)) (dtet (list Z) lofZ ev c l1 l2 l3) /\
  forall s, In s (map (dstatement (list Z) ev) ss) -> holds l1 l2 l3 (c_rank _ c) (length (c_tets _ c)) (dtet (list Z) lofZ ev c l1 l2 l3) s.
Proof. apply (check_sound (list Z) ladd lsub lmul lofZ lltb lleb ev ev_add ev_sub ev_mul ev_ofZ lltb_ok lleb_ok). Qed.
Theorem nf_basis c ss : nfcheck c ss = true -> exists l1 l2 l3, has_gram (dgram (list Z) ev c) l1 l2 l3.
Proof. apply (basis_exists (list Z) ladd lsub lmul lofZ lltb lleb ev ev_add ev_sub ev_mul ev_ofZ lltb_ok). Qed.

Theorem nf_sound2 c ss : nfcheck2 c ss = true ->
  (exists l1 l2, has_gram2 (dgram2 (list Z) ev c) l1 l2) /\
  forall l1 l2, has_gram2 (dgram2 (list Z) ev c) l1 l2 ->
  edge_to_edge_tiling l1 l2 (e_rank _ c) (ddomain2 (list Z) ev c l1 l2) (length (e_tris _ c)) (dtriangle (list Z) lofZ ev c l1 l2) /\
  forall s, In s (map (dstatement (list Z) ev) ss) -> holds2 l1 l2 (e_rank _ c) (length (e_tris _ c)) (dtriangle (list Z) lofZ ev c l1 l2) s.
Proof. apply (check2_sound (list Z) ladd lsub lmul lofZ lltb lleb ev ev_add ev_sub ev_mul ev_ofZ lltb_ok lleb_ok). Qed.
End Alpha.

Lemma ev_cont p : continuity (fun x => ev x p).
Proof.
  induction p as [|a p IH]; cbn [ev].
  - apply continuity_const. intros x y; reflexivity.
  - apply (continuity_plus (fun _ => IZR a) (fun x => x * ev x p)).
    + apply continuity_const. intros x y; reflexivity.
    + apply (continuity_mult (fun x => x) (fun x => ev x p)); auto. apply derivable_continuous, derivable_id.
Qed.
Lemma hev_ok S p a : (0 < S)%Z -> 0 < IZR (snd (hev S p a)) /\ IZR (fst (hev S p a)) = IZR (snd (hev S p a)) * ev (IZR a / IZR S) p.
Proof.
  intros HS. apply IZR_lt in HS. induction p as [|c p [IH1 IH2]]; simpl; [lra|].
  destruct (hev S p a) as [v P]. cbn [fst snd] in *. rewrite plus_IZR, zmul_IZR, !mult_IZR. split; [apply Rmult_lt_0_compat; auto|].
  rewrite IH2. field. lra.
Qed.
Theorem isol_root : isol = true -> exists al, ev al (fl ++ [1%Z]) = 0 /\ forall e, In e (es ++ [e0]) -> encl_ok al e.
Proof.
  unfold isol. cbv zeta. set (lo := e_lo e0). set (hi := e_hi e0). set (S := e_S e0).
  rewrite !andb_true_iff, Z.ltb_lt, !Z.leb_le, forallb_forall. intros [[[HS HL] HV] HE].
  set (F := fun x => ev x (fl ++ [1%Z])).
  destruct (hev_ok S (fl ++ [1%Z]) lo HS) as [P1 E1]. destruct (hev_ok S (fl ++ [1%Z]) hi HS) as [P2 E2].
  apply IZR_le in HV. rewrite mult_IZR, E1, E2 in HV.
  pose proof (IZR_lt _ _ HS) as HS'. pose proof (IZR_le _ _ HL) as HL'.
  destruct (IVT_cor F (IZR lo / IZR S) (IZR hi / IZR S)) as [z [[Z1 Z2] Z3]].
  - apply ev_cont.
  - apply Rmult_le_compat_r; auto. left. apply Rinv_0_lt_compat; auto.
  - unfold F. set (u := ev (IZR lo / IZR S) _) in *. set (v := ev (IZR hi / IZR S) _) in *.
    set (p := IZR (snd _)) in *. set (q := IZR (snd (hev _ _ hi))) in *.
    apply Rmult_le_reg_l with (p * q); [apply Rmult_lt_0_compat; auto|]. rewrite Rmult_0_r.
    replace (p * q * (u * v)) with (p * u * (q * v)) by ring. exact HV.
  - exists z. split; auto.
    assert (K1 : IZR lo / IZR S * IZR S = IZR lo) by (field; lra).
    assert (K2 : IZR hi / IZR S * IZR S = IZR hi) by (field; lra).
    assert (Y1 : IZR lo <= z * IZR S) by (rewrite <- K1; apply Rmult_le_compat_r; lra).
    assert (Y2 : z * IZR S <= IZR hi) by (rewrite <- K2; apply Rmult_le_compat_r; lra).
    intros e He. apply in_app_or in He as [He|[<-|[]]]; [|repeat split; auto].
    specialize (HE e He). rewrite !andb_true_iff, Z.ltb_lt, !Z.leb_le in HE. destruct HE as [[X1 X2] X3].
    apply IZR_le in X2, X3. rewrite !mult_IZR in *. pose proof (IZR_lt _ _ X1) as X1'.
    assert (Z0 : forall a b, a * IZR S <= b * IZR S -> a <= b).
    { intros a b. apply Rmult_le_reg_r; auto. }
    repeat split; auto; apply Z0.
    + apply Rle_trans with (IZR lo * IZR (e_S e)); auto.
      replace (z * IZR (e_S e) * IZR S) with (z * IZR S * IZR (e_S e)) by ring. apply Rmult_le_compat_r; lra.
    + apply Rle_trans with (IZR hi * IZR (e_S e)); auto.
      replace (z * IZR (e_S e) * IZR S) with (z * IZR S * IZR (e_S e)) by ring. apply Rmult_le_compat_r; lra.
Qed.


(** ** The root is the only one in the interval of the claim

    The derivative has no zero there, by interval arithmetic: mean value theorem. *)
Variable claimed : encl.
Fixpoint derivative (p : list Z) : list Z :=
  match p with [] => [] | _ :: p => ladd p (0%Z :: derivative p) end.
Definition isolated : bool :=
  isol && (0 <? e_S claimed)%Z && (e_lo claimed * e_S e0 <=? e_lo e0 * e_S claimed)%Z && (e_hi e0 * e_S claimed <=? e_hi claimed * e_S e0)%Z &&
  (let '(l, h, _) := lint (e_lo claimed) (e_hi claimed) (e_S claimed) (derivative (fl ++ [1%Z])) in (0 <? l)%Z || (h <? 0)%Z).

Lemma ev_derivative p x : derivable_pt_lim (fun x => ev x p) x (ev x (derivative p)).
Proof.
  induction p as [|a p IH]; cbn [ev derivative].
  - apply derivable_pt_lim_const.
  - replace (ev x (ladd p (0%Z :: derivative p))) with (0 + (1 * ev x p + x * ev x (derivative p))).
    + apply (derivable_pt_lim_plus (fun _ => IZR a) (fun x => x * ev x p)); [apply derivable_pt_lim_const|].
      apply (derivable_pt_lim_mult (fun x => x) (fun x => ev x p)); auto. apply derivable_pt_lim_id.
    + rewrite ev_add. cbn [ev]. ring.
Qed.
Definition in_claimed (x : R) := IZR (e_lo claimed) / IZR (e_S claimed) <= x <= IZR (e_hi claimed) / IZR (e_S claimed).
Theorem isolated_root : isolated = true -> exists al, ev al (fl ++ [1%Z]) = 0 /\ in_claimed al /\
  (forall x, ev x (fl ++ [1%Z]) = 0 -> in_claimed x -> x = al) /\ forall e, In e (es ++ [e0]) -> encl_ok al e.
Proof.
  unfold isolated. rewrite !andb_true_iff, Z.ltb_lt, !Z.leb_le. intros [[[[HI HS] HL] HH] HD].
  destruct (isol_root HI) as [al [A1 A2]]. exists al.
  destruct (A2 e0) as [HS0 [X1 X2]]. { apply in_or_app; right; left; auto. }
  apply IZR_lt in HS0, HS. apply IZR_le in HL, HH. rewrite !mult_IZR in HL, HH.
  assert (IN : forall x, IZR (e_lo claimed) <= x * IZR (e_S claimed) <= IZR (e_hi claimed) <-> in_claimed x).
  { intros x. unfold in_claimed. set (S := IZR (e_S claimed)) in *. set (l := IZR (e_lo claimed)). set (u := IZR (e_hi claimed)).
    assert (Y : x = x * S / S) by (field; lra). assert (Il : l / S * S = l) by (field; lra). assert (Iu : u / S * S = u) by (field; lra). split; intros [B1 B2].
    - split; rewrite Y; apply Rmult_le_compat_r; auto; left; apply Rinv_0_lt_compat; auto.
    - split; [rewrite <- Il | rewrite <- Iu]; apply Rmult_le_compat_r; lra. }
  assert (INA : in_claimed al).
  { apply IN. assert (Z0 : forall a b, a * IZR (e_S e0) <= b * IZR (e_S e0) -> a <= b) by (intros a b; apply Rmult_le_reg_r; auto).
    split; apply Z0.
    - apply Rle_trans with (IZR (e_lo e0) * IZR (e_S claimed)); auto.
      replace (al * IZR (e_S claimed) * IZR (e_S e0)) with (al * IZR (e_S e0) * IZR (e_S claimed)) by ring. apply Rmult_le_compat_r; lra.
    - apply Rle_trans with (IZR (e_hi e0) * IZR (e_S claimed)); auto.
      replace (al * IZR (e_S claimed) * IZR (e_S e0)) with (al * IZR (e_S e0) * IZR (e_S claimed)) by ring. apply Rmult_le_compat_r; lra. }
  split; auto. split; auto. split; auto.
  assert (DZ : forall x, in_claimed x -> ev x (derivative (fl ++ [1%Z])) <> 0).
  { intros x Hx. apply IN in Hx. apply lt_IZR in HS.
    pose proof (lint_ok x claimed (derivative (fl ++ [1%Z])) (conj HS Hx)) as LO.
    destruct (lint (e_lo claimed) (e_hi claimed) (e_S claimed) (derivative (fl ++ [1%Z]))) as [[l h] P]. destruct LO as [HP [L1 L2]].
    apply orb_true_iff in HD. rewrite !Z.ltb_lt in HD. intros E. rewrite E, Rmult_0_r in *.
    destruct HD as [HD|HD]; apply IZR_lt in HD; lra. }
  assert (MV : forall a b, in_claimed a -> in_claimed b -> a < b -> ev a (fl ++ [1%Z]) = 0 -> ev b (fl ++ [1%Z]) = 0 -> False).
  { intros a b [Ha1 Ha2] [Hb1 Hb2] Hab Ea Eb.
    destruct (MVT_cor2 (fun x => ev x (fl ++ [1%Z])) (fun x => ev x (derivative (fl ++ [1%Z]))) a b Hab) as [c [C1 C2]].
    { intros; apply ev_derivative. }
    rewrite Ea, Eb in C1. apply (DZ c); [unfold in_claimed; lra|].
    assert (0 = ev c (derivative (fl ++ [1%Z])) * (b - a)) as Q by lra. symmetry in Q. apply Rmult_integral in Q. destruct Q; [auto|lra]. }
  intros x Hx Ix. destruct (Rtotal_order x al) as [L|[L|L]]; auto; exfalso; [apply (MV x al) | apply (MV al x)]; auto.
Qed.

(** The theorem over Z[alpha]. *)
Theorem nf_theorem c ss : isolated = true -> nfcheck c ss = true ->
  exists al, ev al (fl ++ [1%Z]) = 0 /\ in_claimed al /\ (forall x, ev x (fl ++ [1%Z]) = 0 -> in_claimed x -> x = al) /\
  (exists l1 l2 l3, has_gram (dgram (list Z) (ev al) c) l1 l2 l3) /\
  forall l1 l2 l3, has_gram (dgram (list Z) (ev al) c) l1 l2 l3 ->
  face_to_face_tiling l1 l2 l3 (c_rank _ c) (ddomain (list Z) (ev al) c l1 l2 l3) (length (c_tets _ c)) (dtet (list Z) lofZ (ev al) c l1 l2 l3) /\
  forall s, In s (map (dstatement (list Z) (ev al)) ss) -> holds l1 l2 l3 (c_rank _ c) (length (c_tets _ c)) (dtet (list Z) lofZ (ev al) c l1 l2 l3) s.
Proof.
  intros HI HC. destruct (isolated_root HI) as [al [A1 [A2 [A3 A4]]]]. exists al. split; auto. split; auto. split; auto.
  split; [apply (nf_basis al A1 A4 c ss HC) | apply (nf_sound al A1 A4 c ss HC)].
Qed.
Theorem nf_theorem2 c ss : isolated = true -> nfcheck2 c ss = true ->
  exists al, ev al (fl ++ [1%Z]) = 0 /\ in_claimed al /\ (forall x, ev x (fl ++ [1%Z]) = 0 -> in_claimed x -> x = al) /\
  (exists l1 l2, has_gram2 (dgram2 (list Z) (ev al) c) l1 l2) /\
  forall l1 l2, has_gram2 (dgram2 (list Z) (ev al) c) l1 l2 ->
  edge_to_edge_tiling l1 l2 (e_rank _ c) (ddomain2 (list Z) (ev al) c l1 l2) (length (e_tris _ c)) (dtriangle (list Z) lofZ (ev al) c l1 l2) /\
  forall s, In s (map (dstatement (list Z) (ev al)) ss) -> holds2 l1 l2 (e_rank _ c) (length (e_tris _ c)) (dtriangle (list Z) lofZ (ev al) c l1 l2) s.
Proof.
  intros HI HC. destruct (isolated_root HI) as [al [A1 [A2 [A3 A4]]]]. exists al. split; auto. split; auto. split; auto.
  apply (nf_sound2 al A1 A4 c ss HC).
Qed.
End NF.

Theorem z_theorem c ss : zcheck c ss = true ->
  (exists l1 l2 l3, has_gram (dgram Z IZR c) l1 l2 l3) /\
  forall l1 l2 l3, has_gram (dgram Z IZR c) l1 l2 l3 ->
  face_to_face_tiling l1 l2 l3 (c_rank Z c) (ddomain Z IZR c l1 l2 l3) (length (c_tets Z c)) (dtet Z idZ IZR c l1 l2 l3) /\
  forall s, In s (map (dstatement Z IZR) ss) -> holds l1 l2 l3 (c_rank Z c) (length (c_tets Z c)) (dtet Z idZ IZR c l1 l2 l3) s.
Proof. intros H. split; [apply (z_basis c ss H) | apply (z_sound c ss H)]. Qed.
