(** * Dihedral angles and their cosines

    With e the edge ab, u and w the edges ac and ad, let
      A = |e|^2 |u|^2 - (e.u)^2,  B = |e|^2 |w|^2 - (e.w)^2,  C = |e|^2 (u.w) - (e.u)(e.w).
    The cosine of the dihedral angle at ab is C / sqrt (A B).  So the angle is
    acute when C > 0, and compares with arccos (sg sqrt f) as C, |C| and squares
    compare: polynomial signs, no division and no root. *)
Require Import Reals Lra Psatz ZArith.
From Acutile Require Import Statement Tetrahedra Bounds.
Open Scope R_scope.

(** C above, for any inner product dt; A and B are its values at (u,u) and (w,w). *)
Definition acpoly (dt : point -> point -> R) e u w := dt u w * dt e e - dt u e * dt w e.

Lemma dot_self_pos u : u <> Point 0 0 0 -> 0 < dot u u.
Proof.
  intros H. destruct (Req_dec (dot u u) 0) as [Z|Z].
  - exfalso. apply H. unfold dot in Z.
    pose proof (Rle_0_sqr (px u)); pose proof (Rle_0_sqr (py u)); pose proof (Rle_0_sqr (pz u)). unfold Rsqr in *.
    apply point_eq; cbn; match goal with |- ?x = 0 => assert (K : x * x = 0) by lra; apply Rmult_integral in K; tauto end.
  - unfold dot in *.
    pose proof (Rle_0_sqr (px u)); pose proof (Rle_0_sqr (py u)); pose proof (Rle_0_sqr (pz u)). unfold Rsqr in *. lra.
Qed.

(** Cauchy-Schwarz, by Lagrange's identity. *)
Lemma cauchy u w : (dot u w) * (dot u w) <= dot u u * dot w w.
Proof.
  unfold dot.
  assert (0 <= (px u * py w - py u * px w) * (px u * py w - py u * px w)) by apply Rle_0_sqr.
  assert (0 <= (px u * pz w - pz u * px w) * (px u * pz w - pz u * px w)) by apply Rle_0_sqr.
  assert (0 <= (py u * pz w - pz u * py w) * (py u * pz w - pz u * py w)) by apply Rle_0_sqr.
  lra.
Qed.

(** The angle has the cosine that one expects. *)
Lemma angle_cos u w : 0 < dot u u -> 0 < dot w w -> cos (angle u w) * (norm u * norm w) = dot u w.
Proof.
  intros U W.
  assert (NU : 0 < norm u) by (apply sqrt_lt_R0; auto).
  assert (NW : 0 < norm w) by (apply sqrt_lt_R0; auto).
  assert (EU : norm u * norm u = dot u u) by (apply sqrt_sqrt; lra).
  assert (EW : norm w * norm w = dot w w) by (apply sqrt_sqrt; lra).
  pose proof (cauchy u w) as C.
  assert (P : 0 < norm u * norm w) by (apply Rmult_lt_0_compat; auto).
  assert (Q : (norm u * norm w) * (norm u * norm w) = dot u u * dot w w).
  { replace ((norm u * norm w) * (norm u * norm w)) with ((norm u * norm u) * (norm w * norm w)) by ring. rewrite EU, EW. auto. }
  unfold angle. set (x := dot u w / (norm u * norm w)).
  assert (X : x * (norm u * norm w) = dot u w) by (unfold x; field; lra).
  rewrite cos_acos; auto.
  assert (x * x <= 1).
  { apply Rmult_le_reg_r with ((norm u * norm w) * (norm u * norm w)); [apply Rmult_lt_0_compat; auto|].
    replace (x * x * (norm u * norm w * (norm u * norm w))) with ((x * (norm u * norm w)) * (x * (norm u * norm w))) by ring.
    rewrite X, Q. lra. }
  nra.
Qed.

Lemma dot_perp e u w : dot e e <> 0 -> dot (perp e u) (perp e w) = acpoly dot e u w / dot e e.
Proof.
  intros H. unfold acpoly.
  assert (X : forall s r, dot (sub u (scale s e)) (sub w (scale r e)) = dot u w - r * dot u e - s * dot w e + s * r * dot e e).
  { intros. unfold dot. unf. ring. }
  unfold perp. rewrite X. field. auto.
Qed.

(** e x u is not zero where e, u, w are independent: A > 0 and |e| > 0. *)
Lemma acpoly_pos e u w : det e u w <> 0 -> 0 < dot e e /\ 0 < acpoly dot e u u.
Proof.
  intros H. split.
  - apply dot_self_pos. intros ->. apply H. unf. ring.
  - set (n := Point (py e * pz u - pz e * py u) (pz e * px u - px e * pz u) (px e * py u - py e * px u)).
    replace (acpoly dot e u u) with (dot n n) by (unfold n, acpoly, dot; cbn [px py pz]; ring).
    apply dot_self_pos. intros Z. apply H.
    replace (det e u w) with (dot n w) by (unfold n, dot; unf; ring). rewrite Z. unfold dot; cbn [px py pz]. ring.
Qed.

(** ** Comparing with the bound arccos (sg sqrt f)

    The sign sg is -1, 0 or 1, and f is between 0 and 1. *)
Definition sign_ok (sg : Z) (f : R) : Prop :=
  match sg with Z0 => True | Zpos xH | Zneg xH => 0 < f <= 1 | _ => False end.
Lemma sqrt_bound f : 0 < f <= 1 -> 0 < sqrt f <= 1.
Proof.
  intros [F0 F1]. split; [apply sqrt_lt_R0; auto|]. rewrite <- sqrt_1. apply sqrt_le_1; lra.
Qed.
Lemma root_bound sg f : sign_ok sg f -> -1 <= IZR sg * sqrt f <= 1.
Proof. destruct sg as [|[p|p|]|[p|p|]]; cbn [sign_ok]; try tauto; intros H; [lra| |]; pose proof (sqrt_bound f H); lra. Qed.

(** sg sqrt f s < x for s^2 = m, where [less] is "<"; at most for "<=". *)
Definition below_root (less : R -> R -> Prop) (sg : Z) (f x m : R) : Prop :=
  match sg with
  | Z0 => less 0 x
  | Zpos _ => 0 <= x /\ less (f * m) (x * x)
  | Zneg _ => 0 <= x \/ less (x * x) (f * m)
  end.
Lemma below_root_lt sg f s x : sign_ok sg f -> 0 < s -> below_root Rlt sg f x (s * s) -> IZR sg * sqrt f * s < x.
Proof.
  intros HF S H. destruct sg as [|[p|p|]|[p|p|]]; cbn [sign_ok below_root] in *; try tauto; [lra| |];
  pose proof (sqrt_bound f HF) as [R0 _]; pose proof (sqrt_sqrt f ltac:(lra)) as RR; set (r := sqrt f) in *; assert (K : 0 < r * s) by (apply Rmult_lt_0_compat; auto);
  replace (f * (s * s)) with ((r * s) * (r * s)) in H by (rewrite <- RR; ring).
  - destruct H as [X H]. apply Rnot_le_lt. intros L. assert (x * x <= r * s * (r * s)) by (apply Rmult_le_compat; lra). lra.
  - destruct H as [H|H]; [lra|]. apply Rnot_le_lt. intros L. assert (r * s * (r * s) <= (- x) * (- x)) by (apply Rmult_le_compat; lra). lra.
Qed.
Lemma below_root_le sg f s x : sign_ok sg f -> 0 < s -> below_root Rle sg f x (s * s) -> IZR sg * sqrt f * s <= x.
Proof.
  intros HF S H. destruct sg as [|[p|p|]|[p|p|]]; cbn [sign_ok below_root] in *; try tauto; [lra| |];
  pose proof (sqrt_bound f HF) as [R0 _]; pose proof (sqrt_sqrt f ltac:(lra)) as RR; set (r := sqrt f) in *; assert (K : 0 < r * s) by (apply Rmult_lt_0_compat; auto);
  replace (f * (s * s)) with ((r * s) * (r * s)) in H by (rewrite <- RR; ring).
  - destruct H as [X H]. apply Rnot_lt_le. intros L. assert (x * x < r * s * (r * s)) by (apply Rmult_le_0_lt_compat; lra). lra.
  - destruct H as [H|H]; [lra|]. apply Rnot_lt_le. intros L. assert (r * s * (r * s) < (- x) * (- x)) by (apply Rmult_le_0_lt_compat; lra). lra.
Qed.
(** An angle is less than arccos y if its cosine is more than y. *)
Definition compares_root (o : test) (sg : Z) (f x m : R) : Prop :=
  match o with
  | TLt => below_root Rlt sg f x m
  | TLe => below_root Rle sg f x m
  | TGe => below_root Rle (- sg) f (- x) m
  | TGt => below_root Rlt (- sg) f (- x) m
  end.
Lemma compares_root_ok o sg f s x : sign_ok sg f -> 0 < s -> compares_root o sg f x (s * s) -> compares o (IZR sg * sqrt f * s) x.
Proof.
  intros HF S H. assert (HF' : sign_ok (- sg) f) by (destruct sg as [|[p|p|]|[p|p|]]; exact HF).
  destruct o; cbn [compares_root compares] in *.
  - apply below_root_lt; auto.
  - apply below_root_le; auto.
  - apply below_root_le in H; auto. rewrite opp_IZR in H. lra.
  - apply below_root_lt in H; auto. rewrite opp_IZR in H. lra.
Qed.

Section Angle.
Variables a b c d : point.
Let e := sub b a.
Let u := sub c a.
Let w := sub d a.
Hypothesis independent : orient a b c d <> 0.
Let A := acpoly dot e u u.
Let B := acpoly dot e w w.
Let C := acpoly dot e u w.

Lemma A_pos : 0 < A.
Proof. apply (acpoly_pos e u w). exact independent. Qed.
Lemma B_pos : 0 < B.
Proof. apply (acpoly_pos e w u). intros Z. apply independent. change (det e u w = 0). rewrite <- (Ropp_involutive (det e u w)). replace (- det e u w) with (det e w u) by (unf; ring). rewrite Z. ring. Qed.

(** cos (dihedral angle) sqrt (A B) = C *)
Lemma dihedral_cos : exists s, 0 < s /\ s * s = A * B /\ cos (dihedral a b c d) * s = C.
Proof.
  pose proof A_pos as PA. pose proof B_pos as PB.
  destruct (acpoly_pos e u w independent) as [EE _].
  unfold dihedral. fold e u w. set (U := perp e u). set (W := perp e w).
  assert (HUW : dot U W = C / dot e e) by (apply dot_perp; lra).
  assert (HUU : dot U U = A / dot e e) by (apply dot_perp; lra).
  assert (HWW : dot W W = B / dot e e) by (apply dot_perp; lra).
  assert (PU : 0 < dot U U) by (rewrite HUU; apply Rdiv_lt_0_compat; auto).
  assert (PW : 0 < dot W W) by (rewrite HWW; apply Rdiv_lt_0_compat; auto).
  pose proof (angle_cos U W PU PW) as AC.
  assert (NU : 0 < norm U) by (apply sqrt_lt_R0; auto).
  assert (NW : 0 < norm W) by (apply sqrt_lt_R0; auto).
  assert (EU : norm U * norm U = dot U U) by (apply sqrt_sqrt; lra).
  assert (EW : norm W * norm W = dot W W) by (apply sqrt_sqrt; lra).
  exists (dot e e * (norm U * norm W)). split; [repeat apply Rmult_lt_0_compat; auto|]. split.
  - replace (dot e e * (norm U * norm W) * (dot e e * (norm U * norm W))) with ((dot e e * (norm U * norm U)) * (dot e e * (norm W * norm W))) by ring.
    rewrite EU, EW, HUU, HWW. field. lra.
  - replace (cos (angle U W) * (dot e e * (norm U * norm W))) with (dot e e * (cos (angle U W) * (norm U * norm W))) by ring.
    rewrite AC, HUW. field. lra.
Qed.
Lemma dihedral_bound : 0 <= dihedral a b c d <= PI.
Proof. apply acos_bound. Qed.

(** ** The rules of the checker *)

Lemma acute_rule : 0 < C -> dihedral a b c d < PI / 2.
Proof.
  intros HC. destruct dihedral_cos as [s [S1 [_ S2]]]. destruct dihedral_bound as [B1 B2]. pose proof PI_RGT_0.
  apply Rnot_le_lt. intros K. assert (cos (dihedral a b c d) <= 0) by (apply cos_le_0; lra). nra.
Qed.
Lemma nonobtuse_rule : 0 <= C -> dihedral a b c d <= PI / 2.
Proof.
  intros HC. destruct dihedral_cos as [s [S1 [_ S2]]]. destruct dihedral_bound as [B1 B2]. pose proof PI_RGT_0.
  apply Rnot_lt_le. intros K. assert (cos (dihedral a b c d) < 0) by (apply cos_lt_0; lra). nra.
Qed.

(** The dihedral angle compares with a bound as [compares_root] says. *)
Lemma bound_rule o sg f : sign_ok sg f -> compares_root o sg f C (A * B) ->
  compares o (dihedral a b c d) (acos (IZR sg * sqrt f)).
Proof.
  intros HF H. destruct dihedral_cos as [s [S1 [S2 S3]]]. pose proof dihedral_bound as B1.
  pose proof (acos_bound (IZR sg * sqrt f)) as B2. pose proof (cos_acos _ (root_bound sg f HF)) as CB.
  rewrite <- S2 in H. apply (compares_root_ok o sg f s) in H; auto. rewrite <- S3, <- CB in H.
  set (x := dihedral a b c d) in *. set (y := acos _) in *. destruct o; cbn [compares] in *.
  - apply cos_decreasing_0; try lra. apply Rmult_lt_reg_r with s; lra.
  - apply cos_decr_0; try lra. apply Rmult_le_reg_r with s; lra.
  - apply cos_decr_0; try lra. apply Rmult_le_reg_r with s; lra.
  - apply cos_decreasing_0; try lra. apply Rmult_lt_reg_r with s; lra.
Qed.
End Angle.

(** Angles do not change under translation. *)
Lemma dihedral_translate a b c d u : dihedral (add a u) (add b u) (add c u) (add d u) = dihedral a b c d.
Proof.
  assert (K : forall x y, sub (add x u) (add y u) = sub x y) by (intros; apply point_eq; unf; ring).
  unfold dihedral. rewrite !K. reflexivity.
Qed.
Lemma dihedrals_translate u t : dihedrals (translate u t) = dihedrals t.
Proof. unfold dihedrals, translate; cbn [va vb vc vd]. rewrite !dihedral_translate. reflexivity. Qed.
