(* The dimension-free crossing identity.  A segment p -> q and finitely many affine
   functions f_i; a_i = f_i(p), b_i = f_i(q).  If no two functions vanish at the same
   point of the line, or are parallel along it, unless neither changes its sign, then
     [all b_i > 0] - [all a_i > 0] =  sum_i  (signed crossing of facet i).  *)
Require Import Reals Lra Psatz ZArith List Lia Bool.
From Acutile Require Import Sums.
Import ListNotations.
Open Scope R_scope.

Definition posb (x : R) : bool := if Rlt_dec 0 x then true else false.
Lemma posb_t x : posb x = true <-> 0 < x.
Proof. unfold posb. destruct (Rlt_dec 0 x); intuition (try easy; lra). Qed.
Lemma posb_f x : posb x = false <-> x <= 0.
Proof. unfold posb. destruct (Rlt_dec 0 x); intuition (try easy; lra). Qed.
Lemma posb_ext x y : (0 < x <-> 0 < y) -> posb x = posb y.
Proof. intros H. unfold posb. destruct (Rlt_dec 0 x), (Rlt_dec 0 y); auto; tauto. Qed.

Notation pr := (R * R)%type.
Definition m (x y : pr) : R := snd x * fst y - fst x * snd y.
(* m x y = b_x a_y - a_x b_y : sign of f_y at the zero of f_x, times sign of slope *)

Definition Ia (F : list pr) := forallb (fun x => posb (fst x)) F.
Definition Ib (F : list pr) := forallb (fun x => posb (snd x)) F.
Definition ent (F : list pr) (x : pr) : bool :=
  posb (- fst x) && posb (snd x) && forallb (fun y => negb (posb (- m x y))) F.
Definition lea (F : list pr) (x : pr) : bool :=
  posb (fst x) && posb (- snd x) && forallb (fun y => negb (posb (m x y))) F.
Definition term F x : Z := (Z.b2z (ent F x) - Z.b2z (lea F x))%Z.

(** f changes its sign; two functions may be parallel if neither does. *)
Definition changes (x : pr) := fst x * snd x < 0.
Definition apart (x y : pr) := changes x \/ changes y -> m x y <> 0.
Definition okF (F : list pr) :=
  (forall x, In x F -> fst x <> 0 /\ snd x <> 0) /\ ForallOrdPairs apart F.

Definition swp (x : pr) : pr := (snd x, fst x).

Ltac bsimp := repeat rewrite ?andb_true_iff, ?andb_false_iff, ?negb_true_iff, ?negb_false_iff, ?posb_t, ?posb_f in *.

Lemma ent_true F x : ent F x = true <-> fst x < 0 /\ 0 < snd x /\ forall y, In y F -> 0 <= m x y.
Proof. unfold ent. bsimp. rewrite forallb_forall. split.
  - intros [[H1 H2] H3]. repeat split; try lra. intros y Hy. specialize (H3 y Hy). bsimp. lra.
  - intros [H1 [H2 H3]]. repeat split; try lra. intros y Hy. specialize (H3 y Hy). bsimp. lra.
Qed.
Lemma lea_true F x : lea F x = true <-> 0 < fst x /\ snd x < 0 /\ forall y, In y F -> m x y <= 0.
Proof. unfold lea. bsimp. rewrite forallb_forall. split.
  - intros [[H1 H2] H3]. repeat split; try lra. intros y Hy. specialize (H3 y Hy). bsimp. lra.
  - intros [H1 [H2 H3]]. repeat split; try lra. intros y Hy. specialize (H3 y Hy). bsimp. lra.
Qed.

Lemma beq_iff a b : (a = true <-> b = true) -> a = b.
Proof. destruct a, b; intuition. Qed.
Lemma bfalse a : (a = true -> False) -> a = false.
Proof. destruct a; intuition. Qed.

Lemma Ia_true F : Ia F = true <-> forall y, In y F -> 0 < fst y.
Proof. unfold Ia. rewrite forallb_forall. split; intros H y Hy; specialize (H y Hy); bsimp; auto. Qed.
Lemma Ib_true F : Ib F = true <-> forall y, In y F -> 0 < snd y.
Proof. unfold Ib. rewrite forallb_forall. split; intros H y Hy; specialize (H y Hy); bsimp; auto. Qed.

(* reversal of time *)
Lemma Ia_swp F : Ia (map swp F) = Ib F.
Proof. induction F; simpl; congruence. Qed.
Lemma Ib_swp F : Ib (map swp F) = Ia F.
Proof. induction F; simpl; congruence. Qed.
Lemma m_swp x y : m (swp x) (swp y) = - m x y.
Proof. unfold m, swp; simpl; ring. Qed.
Lemma ent_swp F x : ent (map swp F) (swp x) = lea F x.
Proof.
  apply beq_iff. rewrite ent_true, lea_true. unfold swp at 1 2; simpl. split; intros [H1 [H2 H3]]; repeat split; auto.
  - intros y Hy. specialize (H3 (swp y) (in_map swp F y Hy)). rewrite m_swp in H3. lra.
  - intros y Hy. apply in_map_iff in Hy as [z [<- Hz]]. rewrite m_swp. specialize (H3 z Hz). lra.
Qed.
Lemma lea_swp F x : lea (map swp F) (swp x) = ent F x.
Proof.
  apply beq_iff. rewrite ent_true, lea_true. unfold swp at 1 2; simpl. split; intros [H1 [H2 H3]]; repeat split; auto.
  - intros y Hy. specialize (H3 (swp y) (in_map swp F y Hy)). rewrite m_swp in H3. lra.
  - intros y Hy. apply in_map_iff in Hy as [z [<- Hz]]. rewrite m_swp. specialize (H3 z Hz). lra.
Qed.

Lemma FOP_map {A B} (h : A -> B) (P : A -> A -> Prop) (Q : B -> B -> Prop) l :
  (forall x y, In x l -> In y l -> P x y -> Q (h x) (h y)) ->
  ForallOrdPairs P l -> ForallOrdPairs Q (map h l).
Proof.
  intros H FP. induction FP as [|a l Ha Hl IH]; simpl; constructor.
  - rewrite Forall_forall in *. intros y Hy. apply in_map_iff in Hy as [z [<- Hz]].
    apply H; simpl; auto.
  - apply IH. intros; apply H; simpl; auto.
Qed.

Lemma okF_swp F : okF F -> okF (map swp F).
Proof.
  intros [H1 H2]. split.
  - intros x Hx. apply in_map_iff in Hx as [z [<- Hz]]. specialize (H1 z Hz). simpl. tauto.
  - revert H2. apply FOP_map. intros x y _ _ H C. rewrite m_swp.
    assert (m x y <> 0); [|lra]. apply H. unfold changes, swp in *; simpl in C. lra.
Qed.

(* the crossing identity, entering case, as a step of the induction *)
Definition tl_ (g x : pr) : pr := (m g x, snd x).   (* restart the segment at the zero of g *)

Lemma m_tl g x y : m (tl_ g x) (tl_ g y) = snd g * m x y.
Proof. unfold m, tl_; simpl. unfold m. ring. Qed.
Lemma m_anti x y : m x y = - m y x.
Proof. unfold m; ring. Qed.
Lemma m_self x : m x x = 0.
Proof. unfold m; ring. Qed.

Definition claim (F : list pr) := (Z.b2z (Ib F) - Z.b2z (Ia F) = zsum (term F) F)%Z.

Lemma step_entering g F :
  fst g < 0 -> 0 < snd g -> okF (g :: F) -> claim (map (tl_ g) F) -> claim (g :: F).
Proof.
  intros Hg1 Hg2 [H1 H2] IH. unfold claim in *. inversion H2 as [|? ? Hm' H2']; subst; clear H2.
  rewrite Forall_forall in Hm'.
  assert (Hm : forall x, In x F -> m g x <> 0) by (intros x Hx; apply (Hm' x Hx); left; unfold changes; nra).
  assert (E1 : Ib (map (tl_ g) F) = Ib F).
  { clear. induction F; simpl; congruence. }
  assert (E2 : Ib (g :: F) = Ib F).
  { simpl. rewrite (proj2 (posb_t _) Hg2). auto. }
  assert (E3 : Ia (g :: F) = false).
  { simpl. apply andb_false_iff; left. apply posb_f. lra. }
  assert (E4 : term (g :: F) g = Z.b2z (Ia (map (tl_ g) F))).
  { unfold term. replace (lea (g :: F) g) with false.
    2:{ symmetry. apply bfalse. rewrite lea_true. lra. }
    rewrite Z.sub_0_r. f_equal. apply beq_iff. rewrite ent_true, Ia_true. split.
    - intros [_ [_ H]] y Hy. apply in_map_iff in Hy as [z [<- Hz]]. simpl.
      specialize (H z (or_intror Hz)). specialize (Hm z Hz). lra.
    - intros H. repeat split; auto. intros y [<-|Hy]. { rewrite m_self; lra. }
      specialize (H _ (in_map (tl_ g) F y Hy)). simpl in H. lra. }
  assert (E5 : zsum (term (g :: F)) F = zsum (term (map (tl_ g) F)) (map (tl_ g) F)).
  { rewrite zsum_map. apply zsum_ext. intros x Hx. unfold term.
    specialize (H1 x (or_intror Hx)). pose proof (Hm x Hx) as Hmx. apply (f_equal2 Z.sub); apply (f_equal Z.b2z).
    - apply beq_iff. rewrite !ent_true. unfold tl_ at 1 2; simpl. split.
      + intros [A [B C]]. repeat split; auto.
        * specialize (C g (or_introl eq_refl)). rewrite m_anti in C. lra.
        * intros y Hy. apply in_map_iff in Hy as [z [<- Hz]]. rewrite m_tl.
          specialize (C z (or_intror Hz)). nra.
      + intros [A [B C]]. assert (fst x < 0). { unfold m in A. nra. } repeat split; auto.
        intros y [<-|Hy]. { rewrite m_anti; lra. }
        specialize (C _ (in_map (tl_ g) F y Hy)). rewrite m_tl in C. nra.
    - apply beq_iff. rewrite !lea_true. unfold tl_ at 1 2; simpl. split.
      + intros [A [B C]]. repeat split; auto.
        * specialize (C g (or_introl eq_refl)). rewrite m_anti in C. lra.
        * intros y Hy. apply in_map_iff in Hy as [z [<- Hz]]. rewrite m_tl.
          specialize (C z (or_intror Hz)). nra.
      + intros [A [B C]]. assert (0 < fst x). { unfold m in A. nra. } repeat split; auto.
        intros y [<-|Hy]. { rewrite m_anti; lra. }
        specialize (C _ (in_map (tl_ g) F y Hy)). rewrite m_tl in C. nra. }
  cbn [zsum]. rewrite E2, E3, E4, E5. rewrite E1 in IH. simpl (Z.b2z false). lia.
Qed.

Lemma claim_swp F : claim (map swp F) -> claim F.
Proof.
  unfold claim. rewrite Ia_swp, Ib_swp, zsum_map. intros H.
  rewrite (zsum_ext _ (fun x => - term F x)%Z) in H.
  - rewrite zsum_opp in H. lia.
  - intros x _. unfold term. rewrite ent_swp, lea_swp. lia.
Qed.

Theorem crossing_identity : forall n F, length F = n -> okF F -> claim F.
Proof.
  induction n as [|n IH]; intros F HL OK.
  - destruct F; [|discriminate]. reflexivity.
  - destruct F as [|g F]; [discriminate|]. injection HL as HL.
    assert (ENT : forall g F, length F = n -> okF (g :: F) -> fst g < 0 -> 0 < snd g -> claim (g :: F)).
    { clear - IH. intros g F HL OK A B. apply step_entering; auto. apply IH.
      - rewrite map_length; auto.
      - destruct OK as [H1 H2]. inversion H2 as [|? ? Hm' H2']; subst; clear H2. rewrite Forall_forall in Hm'.
        assert (Hm : forall x, In x F -> m g x <> 0) by (intros x Hx; apply (Hm' x Hx); left; unfold changes; nra).
        split.
        + intros x Hx. apply in_map_iff in Hx as [z [<- Hz]]. simpl. split; auto.
          apply H1; right; auto.
        + assert (K : forall x, In x F -> changes (tl_ g x) -> changes x).
          { intros x Hx. destruct (H1 x (or_intror Hx)) as [N1 N2]. unfold changes, tl_, m; simpl. intros C.
            destruct (Rlt_dec 0 (fst x)), (Rlt_dec 0 (snd x)); nra. }
          revert H2'. apply FOP_map. intros x y Hx Hy H C. rewrite m_tl.
          assert (m x y <> 0); [|nra]. apply H. destruct C as [C|C]; [left|right]; apply K; auto. }
    destruct (proj1 OK g (or_introl eq_refl)) as [Ha Hb].
    destruct (Rlt_dec (fst g) 0) as [Ga|Ga]; destruct (Rlt_dec (snd g) 0) as [Gb|Gb].
    + (* (-,-) *) unfold claim. cbn [zsum].
      assert (E0 : Ib (g :: F) = false). { simpl. apply andb_false_iff; left. apply posb_f; lra. }
      assert (E1 : Ia (g :: F) = false). { simpl. apply andb_false_iff; left. apply posb_f; lra. }
      rewrite E0, E1. rewrite zsum_zero.
      * unfold term. replace (ent (g :: F) g) with false; [replace (lea (g :: F) g) with false; [reflexivity|]|].
        -- symmetry; apply bfalse. rewrite lea_true. lra.
        -- symmetry; apply bfalse. rewrite ent_true. lra.
      * intros x Hx. unfold term. replace (ent (g :: F) x) with false; [replace (lea (g :: F) x) with false; [reflexivity|]|].
        -- symmetry; apply bfalse. rewrite lea_true. intros [A [B C]]. specialize (C g (or_introl eq_refl)). unfold m in C. nra.
        -- symmetry; apply bfalse. rewrite ent_true. intros [A [B C]]. specialize (C g (or_introl eq_refl)). unfold m in C. nra.
    + apply ENT; auto; lra.
    + (* leaving *) apply claim_swp. simpl. apply ENT; simpl; try lra.
      * rewrite map_length; auto.
      * apply (okF_swp (g :: F)); auto.
    + (* (+,+) *) unfold claim. cbn [zsum].
      assert (E0 : Ib (g :: F) = Ib F). { simpl. rewrite (proj2 (posb_t (snd g))); auto; lra. }
      assert (E1 : Ia (g :: F) = Ia F). { simpl. rewrite (proj2 (posb_t (fst g))); auto; lra. }
      rewrite E0, E1.
      assert (E2 : term (g :: F) g = 0%Z).
      { unfold term. replace (ent (g :: F) g) with false; [replace (lea (g :: F) g) with false; [reflexivity|]|].
        -- symmetry; apply bfalse. rewrite lea_true. lra.
        -- symmetry; apply bfalse. rewrite ent_true. lra. }
      rewrite E2.
      assert (IHF : claim F).
      { apply IH; auto. destruct OK as [H1 H2]. inversion H2; subst. split; auto. intros; apply H1; right; auto. }
      unfold claim in IHF. rewrite IHF. rewrite Z.add_0_l. apply zsum_ext. intros x Hx. unfold term. apply (f_equal2 Z.sub); apply (f_equal Z.b2z).
      * apply beq_iff. rewrite !ent_true. split; intros [A [B C]]; repeat split; auto.
        -- intros y [<-|Hy]; auto. unfold m. nra.
        -- intros y Hy. apply C; right; auto.
      * apply beq_iff. rewrite !lea_true. split; intros [A [B C]]; repeat split; auto.
        -- intros y [<-|Hy]; auto. unfold m. nra.
        -- intros y Hy. apply C; right; auto.
Qed.
