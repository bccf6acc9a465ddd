(** * docs/lower-bound.md, sections 7, 10 and 11: the link of a vertex, the summation, Theorem 2 *)
From Coq Require Import Reals Lra Lia List Bool Permutation.
From Acutile Require Import Statement Tetrahedra Angles.
From LowerBound Require Import Calculus Normals Corners Triangles Sides Excess.
Import ListNotations.
Open Scope R_scope.

(** ** Finite sums *)

Definition total {A} (l : list A) (f : A -> R) := fold_right Rplus 0 (map f l).
Section Sums.
Context {A : Type}.
Implicit Types (l : list A) (f g : A -> R).
Lemma total_ext l f g : (forall x, In x l -> f x = g x) -> total l f = total l g.
Proof. unfold total. induction l as [|a l IH]; cbn; intros H; auto. rewrite H, IH; auto. Qed.
Lemma total_le l f g : (forall x, In x l -> f x <= g x) -> total l f <= total l g.
Proof. unfold total. induction l as [|a l IH]; cbn; intros H; [lra|]. apply Rplus_le_compat; auto. Qed.
Lemma total_plus l f g : total l (fun x => f x + g x) = total l f + total l g.
Proof. unfold total. induction l as [|a l IH]; cbn; [lra|]. rewrite IH. lra. Qed.
Lemma total_zero l : total l (fun _ => 0) = 0.
Proof. unfold total. induction l as [|a l IH]; cbn; [lra|]. rewrite IH. lra. Qed.
Lemma total_all_zero l f : (forall x, In x l -> 0 <= f x) -> total l f <= 0 -> forall x, In x l -> f x = 0.
Proof.
  induction l as [|a l IH]; intros P L x X; [destruct X|]. unfold total in L; cbn in L.
  pose proof (P a (or_introl eq_refl)) as Pa. assert (Q : forall x, In x l -> 0 <= f x) by (intros; apply P; right; auto).
  pose proof (total_le l (fun _ => 0) f Q) as S. rewrite total_zero in S. unfold total in S.
  destruct X as [<-|X]; [lra|]. apply IH; auto. unfold total. lra.
Qed.
Lemma total_permutation l m f : Permutation l m -> total l f = total m f.
Proof. unfold total. induction 1; cbn; lra. Qed.
Lemma total_map l f (p : A -> A) : NoDup l -> (forall x, In x l -> In (p x) l) ->
  (forall x y, In x l -> In y l -> p x = p y -> x = y) -> total l (fun x => f (p x)) = total l f.
Proof.
  intros N I J. replace (total l (fun x => f (p x))) with (total (map p l) f) by (unfold total; rewrite map_map; reflexivity).
  apply total_permutation, NoDup_Permutation_bis.
  - clear I. induction N as [|a l Na N IH]; cbn; constructor.
    + intros H. apply in_map_iff in H. destruct H as [b [E B]]. apply Na. rewrite <- (J b a); auto; [right; auto|left; auto].
    + apply IH. intros x y X Y. apply J; right; auto.
  - rewrite map_length. lia.
  - intros x X. apply in_map_iff in X. destruct X as [y [<- Y]]. auto.
Qed.
End Sums.

(** ** The link (section 7)

    A dart is an edge of the link with a direction.  The next dart around the vertex where it starts is
    [turn d], counterclockwise.  The triangle on the left of a dart lies between d and [turn d]; its next dart,
    with the triangle on the left, is [along d].  So [turn (along d)] is the dart d with the other direction, and a
    dart also stands for the corner of its triangle where it starts.  [ang d] is the angle there, [len d] the
    length of the edge, and [six d] says that the vertex where d starts has degree 6; otherwise it has degree 5. *)
Section Link.
Variables (dart : Type) (darts : list dart) (turn along : dart -> dart) (six : dart -> bool) (ang len : dart -> R).
Notation back d := (turn (along d)).

Record link : Prop := {
  link_distinct : NoDup darts;
  link_turn : forall d, In d darts -> In (turn d) darts;
  link_along : forall d, In d darts -> In (along d) darts;
  (* triangles have three sides, and an edge has two directions *)
  link_triangle : forall d, In d darts -> along (along (along d)) = d;
  link_back : forall d, In d darts -> back (back d) = d;
  (* degrees *)
  link_six : forall d, In d darts -> six (turn d) = six d;
  link_five_darts : forall d, In d darts -> six d = false -> turn (turn (turn (turn (turn d)))) = d;
  link_six_darts : forall d, In d darts -> six d = true -> turn (turn (turn (turn (turn (turn d))))) = d;
  (* no two sixes are adjacent, and there is a six *)
  link_apart : forall d, In d darts -> six d = true -> six (back d) = false;
  link_some : exists d, In d darts /\ six d = true;
  (* the triangles are spherical, and angles at a vertex add up to 360 degrees *)
  link_spherical : forall d, In d darts ->
    spherical_triangle (ang d) (ang (along d)) (ang (along (along d))) (len (along d)) (len (along (along d))) (len d);
  link_len : forall d, In d darts -> len (back d) = len d;
  link_five_sum : forall d, In d darts -> six d = false ->
    ang d + ang (turn d) + ang (turn (turn d)) + ang (turn (turn (turn d))) + ang (turn (turn (turn (turn d)))) = 2 * PI;
  link_six_sum : forall d, In d darts -> six d = true ->
    ang d + ang (turn d) + ang (turn (turn d)) + ang (turn (turn (turn d))) + ang (turn (turn (turn (turn d))))
    + ang (turn (turn (turn (turn (turn d))))) = 2 * PI }.

Hypothesis L : link.
Let Din d := In d darts.

Ltac inside := unfold Din in *; repeat first [assumption | apply (link_turn L) | apply (link_along L)].

(** *** Names of darts *)
Lemma six_back d : Din d -> six (back d) = six (along d).
Proof. intros H. apply (link_six L). inside. Qed.
(** The third corner of a triangle starts with the dart back from the second side. *)
Lemma third d : Din d -> along (along d) = back (turn d).
Proof.
  intros H. rewrite <- (link_back L (along (along d))) at 1 by inside. rewrite (link_triangle L) by inside. reflexivity.
Qed.
Lemma apart d : Din d -> six d = true -> six (along d) = false /\ six (along (along d)) = false.
Proof.
  intros H S. rewrite <- six_back by inside. split; [apply (link_apart L); inside|].
  rewrite third by inside. apply (link_apart L); [inside|]. rewrite (link_six L) by inside. exact S.
Qed.
Lemma apart_neighbours d : Din d -> six (along d) = true -> six (along (along d)) = false.
Proof. intros H S. apply (apart (along d)); inside. Qed.
(** The corner across the side that is opposite to a corner. *)
Definition across d := along (along (back (along d))).
Lemma across_in d : Din d -> Din (across d).
Proof. intros H. unfold across. inside. Qed.
Lemma across_along d : Din d -> along (across d) = back (along d).
Proof. intros H. unfold across. apply (link_triangle L). inside. Qed.
Lemma across_across d : Din d -> across (across d) = d.
Proof.
  intros H. unfold across at 1. rewrite across_along by auto. rewrite (link_back L) by inside. apply (link_triangle L). inside.
Qed.
(** At a five the dart before d is the fourth after it. *)
Definition before d := turn (turn (turn (turn d))).
Lemma turn_before d : Din d -> six d = false -> turn (before d) = d.
Proof. intros H S. apply (link_five_darts L); auto. Qed.
Lemma before_turn d : Din d -> six d = false -> before (turn d) = d.
Proof. intros H S. apply (link_five_darts L); auto. Qed.
Lemma before_in d : Din d -> Din (before d).
Proof. intros H. unfold before. inside. Qed.
Lemma six_before d : Din d -> six (before d) = six d.
Proof. intros H. unfold before. rewrite !(link_six L) by inside. reflexivity. Qed.

(** The corner across the side of a triangle at d, seen from the two ends of the side. *)
Lemma across_from_before d : Din d -> six (along d) = false -> six (along (before (along d))) = six (across d).
Proof.
  intros H S. set (p := before (along d)). assert (P : Din p) by (apply before_in; inside).
  assert (E : turn p = along d) by (apply turn_before; inside). unfold across. rewrite <- E, <- third by auto.
  rewrite (link_triangle L) by inside. reflexivity.
Qed.
Lemma across_from_after d : Din d -> six (along (turn (turn (along (along d))))) = six (across d).
Proof.
  intros H. unfold across. rewrite (third (back (along d))) by inside. rewrite six_back by inside. reflexivity.
Qed.

(** *** Reindexing *)
Lemma sum_turn f : total darts (fun d => f (turn d)) = total darts f.
Proof.
  apply total_map; [apply L|apply L|]. intros x y X Y E.
  assert (S : six x = six y) by (rewrite <- (link_six L x), <- (link_six L y), E; auto).
  destruct (six x) eqn:S1; symmetry in S.
  - rewrite <- (link_six_darts L x), <- (link_six_darts L y), E; auto.
  - rewrite <- (link_five_darts L x), <- (link_five_darts L y), E; auto.
Qed.
Lemma sum_along f : total darts (fun d => f (along d)) = total darts f.
Proof.
  apply total_map; [apply L|apply L|]. intros x y X Y E. rewrite <- (link_triangle L x), <- (link_triangle L y), E; auto.
Qed.
Lemma sum_across f : total darts (fun d => f (across d)) = total darts f.
Proof.
  apply total_map; [apply L|exact across_in|]. intros x y X Y E. rewrite <- (across_across x), <- (across_across y), E; auto.
Qed.

(** ** Section 8: all angles are at most theta, and x of the sides of 555 triangles is at least 60 degrees *)
Variable theta : R.
Hypothesis range : 2 * PI / 5 < theta < 5 * PI / 12.
Hypothesis at_most : forall d, Din d -> ang d <= theta.
Hypothesis x_60 : forall c, Din c -> six c = false -> six (along c) = false -> six (along (along c)) = false -> PI / 3 <= apex theta (len (along c)).

Lemma ang_small d : Din d -> small theta (ang d).
Proof. intros H. split; [apply (link_spherical L d H)|auto]. Qed.
(** The defects at a five, and the excess of an angle there. *)
Definition defect d := theta - ang d.
Definition E d := ang d - a0 theta.
Lemma defect_pos d : Din d -> 0 <= defect d.
Proof. intros H. pose proof (at_most d H). unfold defect. lra. Qed.
Lemma E_is d : Din d -> six d = false -> E d = defect (turn d) + defect (turn (turn d)) + defect (turn (turn (turn d))) + defect (before d).
Proof. intros H S. pose proof (link_five_sum L d H S). unfold E, a0, defect, before. lra. Qed.
Lemma E_above d : Din d -> six d = false -> 0 <= E d /\ defect (turn d) + defect (before d) <= E d.
Proof.
  intros H S. rewrite E_is by auto.
  pose proof (defect_pos (turn d) ltac:(inside)). pose proof (defect_pos (turn (turn d)) ltac:(inside)).
  pose proof (defect_pos (turn (turn (turn d))) ltac:(inside)). pose proof (defect_pos (before d) (before_in d H)). lra.
Qed.
Lemma ang_middle d : Din d -> six d = false -> mid theta (ang d).
Proof. intros H S. pose proof (E_above d H S) as [Q _]. unfold E in Q. split; [lra|auto]. Qed.
Lemma side_positive d : Din d -> 0 < cos (len d).
Proof.
  intros H. pose proof (ang_small d H) as S1. pose proof (ang_small (along d) ltac:(inside)) as S2. pose proof (ang_small (along (along d)) ltac:(inside)) as S3.
  pose proof (side_acute theta range _ _ _ _ S3 S1 S2 (rule_c _ _ _ _ _ _ (link_spherical L d H))) as Q. pose proof (least_cosine theta range). lra.
Qed.

(** ** Section 10

    A *spoke* s goes from a five to a six.  Its two sides are corners at the five: s itself, and [before s].  [PA] and [PB]
    are the parts of the two apex angles there, less 30 degrees. *)
Definition spoke s := six (along s).
Definition PA s := part (ang s) (len s) - PI / 6.
Definition PB s := part (ang (before s)) (len s) - PI / 6.
(** The next edge of the hexagon is HH, on the side of PA, and of PB. *)
Definition hA s := six (along (turn (turn s))).
Definition hB s := six (along (turn (turn (turn s)))).
Definition cA s := if hA s then 0 else if hB s then 2 * PA s - K theta * defect s else PA s.
Definition cB s := if hB s then 0 else if hA s then 2 * PB s - K theta * defect (before s) else PB s.

Lemma spoke_five s : Din s -> spoke s = true -> six s = false.
Proof. intros H S. destruct (six s) eqn:Q; auto. destruct (apart s H Q). unfold spoke in S. congruence. Qed.
Lemma not_both s : Din s -> ~ (hA s = true /\ hB s = true).
Proof.
  intros H [A B]. unfold hA, hB in *. pose proof (apart_neighbours (turn (turn s)) ltac:(inside) A) as Q.
  rewrite third in Q by inside. rewrite six_back in Q by inside. congruence.
Qed.
Lemma spoke_bounds d r : Din d -> six d = false -> 0 < cos r -> part theta r <= part (ang d) r <= part theta r + K theta * defect d.
Proof.
  intros H S Cr. apply (lemma_4_bounds theta range); auto. pose proof (ang_middle d H S) as M. pose proof (between theta range). unfold mid in M. lra.
Qed.
Lemma spokes s : Din s -> spoke s = true -> cA s + cB s <= PA s + PB s.
Proof.
  intros H S. pose proof (spoke_five s H S) as F. pose proof (side_positive s H) as Cr.
  pose proof (spoke_bounds s (len s) H F Cr) as B1. pose proof (spoke_bounds (before s) (len s) (before_in s H) ltac:(rewrite six_before; auto) Cr) as B2.
  pose proof (not_both s H) as N. unfold cA, cB, PA, PB. destruct (hA s), (hB s); [tauto|lra|lra|lra].
Qed.

(** The apex angle is the sum of its parts. *)
Lemma apex_parts d : Din d -> six d = true -> ang d - PI / 3 = PB (back d) + PA (along (along d)).
Proof.
  intros H S. destruct (apart d H S) as [S1 S2]. unfold PA, PB. rewrite before_turn by (auto; inside). rewrite (link_len L) by auto.
  pose proof (between theta range). pose proof (at_most d H). pose proof (at_most (along d) ltac:(inside)). pose proof (at_most (along (along d)) ltac:(inside)).
  pose proof (lemma_4_sum (ang d) (ang (along d)) (ang (along (along d))) _ _ _ (link_spherical L d H) ltac:(lra) ltac:(lra) ltac:(lra)). lra.
Qed.

(** At the sixes the angles add up to 360 degrees. *)
Lemma sixes : total darts (fun d => if six d then ang d - PI / 3 else 0) = 0.
Proof.
  set (g := fun d => if six d then ang d - PI / 3 else 0).
  assert (Q : total darts (fun d => g d + (g (turn d) + (g (turn (turn d)) + (g (turn (turn (turn d))) + (g (turn (turn (turn (turn d)))) + g (turn (turn (turn (turn (turn d)))))))))) = 0).
  { rewrite <- (total_zero darts). apply total_ext. intros d H. unfold g. rewrite !(link_six L) by inside.
    destruct (six d) eqn:S; [|lra]. pose proof (link_six_sum L d H S). lra. }
  rewrite !total_plus in Q.
  rewrite (sum_turn (fun d => g (turn (turn (turn (turn d)))))), (sum_turn (fun d => g (turn (turn (turn d))))), (sum_turn (fun d => g (turn (turn d)))), (sum_turn (fun d => g (turn d))), (sum_turn g) in Q.
  lra.
Qed.
(** From the sixes to the spokes and back. *)
Lemma regroup f g : total darts (fun d => if six d then f (back d) + g (along (along d)) else 0) = total darts (fun s => if spoke s then g s + f s else 0).
Proof.
  transitivity (total darts (fun d => (if six d then f (back d) else 0) + (if six d then g (along (along d)) else 0))).
  { apply total_ext. intros d _. destruct (six d); lra. }
  transitivity (total darts (fun s => (if spoke s then g s else 0) + (if spoke s then f s else 0))).
  2: { apply total_ext. intros d _. destruct (spoke d); lra. }
  rewrite !total_plus, Rplus_comm. f_equal.
  - rewrite <- (sum_along (fun s => if spoke s then g s else 0)), <- (sum_along (fun s => if spoke (along s) then g (along s) else 0)).
    apply total_ext. intros d H. unfold spoke. rewrite (link_triangle L) by auto. reflexivity.
  - rewrite <- (sum_turn (fun s => if spoke s then f s else 0)), <- (sum_along (fun s => if spoke (turn s) then f (turn s) else 0)).
    apply total_ext. intros d H. unfold spoke. rewrite <- (six_back (back d)) by inside. rewrite (link_back L) by auto. reflexivity.
Qed.
Definition Phi d := cB (back d) + cA (along (along d)).
Lemma sixes_above : total darts (fun d => if six d then Phi d else 0) <= 0.
Proof.
  apply Rle_trans with (total darts (fun d => if six d then ang d - PI / 3 else 0)); [|rewrite sixes; lra]. unfold Phi. rewrite (regroup cB cA).
  replace (total darts (fun d => if six d then ang d - PI / 3 else 0)) with (total darts (fun d => if six d then PB (back d) + PA (along (along d)) else 0)).
  - rewrite (regroup PB PA). apply total_le. intros s H. destruct (spoke s) eqn:S; [apply spokes; auto|lra].
  - apply total_ext. intros d H. destruct (six d) eqn:S; [rewrite apex_parts; auto|reflexivity].
Qed.

(** *** The terms at the edges of hexagons, as terms of the triangles across *)
Definition faces c := six (across c).
Definition xl c := apex theta (len (along c)).
Definition Psi c :=
  let ux := faces (along c) in let uy := faces (along (along c)) in
  let dx := defect (turn (along (along c))) in let dy := defect (before (along c)) in
  if ux then if uy then 2 * (xl c - PI / 3) - K theta * (dx + dy) else 3 / 2 * (xl c - PI / 3) - K theta * dx - C theta (PI / 3) * dy
  else if uy then 3 / 2 * (xl c - PI / 3) - K theta * dy - C theta (PI / 3) * dx else xl c - PI / 3.

Lemma xl_is c : Din c -> six c = false -> six (along c) = false -> six (along (along c)) = false ->
  xl c = xs theta (ang c) (ang (along c)) (ang (along (along c))).
Proof.
  intros H S0 S1 S2. unfold xl, apex, xs. rewrite <- (side_cos_rule _ _ _ _ (proj2 (proj2 (mid_trig theta range _ (ang_middle (along c) ltac:(inside) S1))))
    (proj2 (proj2 (mid_trig theta range _ (ang_middle (along (along c)) ltac:(inside) S2)))) (rule_a _ _ _ _ _ _ (link_spherical L c H))). reflexivity.
Qed.

(** A triangle in the other orientation. *)
Lemma mirror A B C a b c : spherical_triangle A B C a b c -> spherical_triangle A C B a c b.
Proof.
  intros [H1 H2 H3 H4 H5 H6 Ra Rb Rc]. unfold side_rule in *. split; auto; unfold side_rule; [rewrite <- (Rmult_comm (sin B))|rewrite <- (Rmult_comm (sin A))|rewrite <- (Rmult_comm (sin C))]; lra.
Qed.
(** A term of an HH edge is 0. *)
Lemma Phi_HH d : Din d -> six d = true -> six (across d) = true -> Phi d = 0.
Proof.
  intros H S A. destruct (apart d H S) as [S1 S2]. unfold Phi, cB, cA, hA, hB.
  rewrite across_from_after by auto. change (turn (turn (turn (back d)))) with (before (along d)). rewrite across_from_before by auto. rewrite A. lra.
Qed.
Lemma Phi_HT d : Din d -> six d = true -> six (across d) = false -> Psi (across d) <= Phi d.
Proof.
  intros H S A. destruct (apart d H S) as [S1 S2]. set (c := across d). assert (HC : Din c) by (apply across_in; auto).
  assert (E1 : along c = back (along d)) by (apply across_along; auto).
  assert (E1' : along c = turn (along (along d))) by exact E1.
  assert (E2 : turn (along (along c)) = along d).
  { change (back (along c) = along d). rewrite E1. apply (link_back L). inside. }
  assert (S3 : six (along c) = false) by (rewrite E1', (link_six L) by inside; auto).
  assert (S4 : six (along (along c)) = false) by (rewrite <- (link_six L), E2 by inside; auto).
  (* the five at y, then the five at x *)
  assert (E3 : before (along c) = along (along d)) by (rewrite E1'; apply before_turn; inside).
  assert (X : hA (back d) = faces (along c)).
  { unfold hA, faces. rewrite <- across_from_before by (auto; inside). do 2 f_equal.
    change (turn (turn (back d))) with (turn (turn (turn (along d)))). rewrite <- E2. reflexivity. }
  assert (Y : hB (along (along d)) = faces (along (along c))).
  { unfold hB, faces. rewrite <- across_from_after by inside. rewrite (link_triangle L) by inside. rewrite E1'. reflexivity. }
  assert (X' : hB (back d) = false).
  { unfold hB. change (turn (turn (turn (back d)))) with (before (along d)). rewrite across_from_before; auto. }
  assert (Y' : hA (along (along d)) = false) by (unfold hA; rewrite across_from_after; auto).
  assert (XL : xl c = apex theta (len (along d))) by (unfold xl; rewrite E1, (link_len L) by inside; reflexivity).
  pose proof (apex_parts d H S) as P. pose proof (link_spherical L d H) as Sp.
  pose proof (at_most d H) as M. pose proof (ang_middle (along d) ltac:(inside) S1) as Mx. pose proof (ang_middle (along (along d)) ltac:(inside) S2) as My.
  pose proof (lemma_3 theta range _ _ _ _ _ _ Sp M (proj2 Mx) (proj2 My)) as L3. rewrite <- XL in L3.
  assert (X60 : PI / 3 <= apex theta (len (along d))).
  { rewrite <- XL. apply x_60; auto. }
  pose proof PI_RGT_0 as P0.
  pose proof (lemma_5 theta range _ _ _ _ _ _ (PI / 3) Sp M Mx My ltac:(lra) X60) as Lx.
  pose proof (lemma_5 theta range _ _ _ _ _ _ (PI / 3) (mirror _ _ _ _ _ _ Sp) M My Mx ltac:(lra) X60) as Ly.
  rewrite <- XL in Lx, Ly.
  assert (B1 : before (back d) = along d) by (apply before_turn; inside).
  unfold Psi, Phi, cB, cA. rewrite X, Y, X', Y', B1, E2, E3. unfold PA, PB in *. rewrite B1, (link_len L) in * by auto.
  unfold defect. destruct (faces (along c)), (faces (along (along c))); lra.
Qed.

(** The sum over all corners of 555 triangles that face a six. *)
Definition term c := if faces c && negb (six c) then Psi c else 0.
Lemma terms : total darts term <= 0.
Proof.
  eapply Rle_trans; [|exact sixes_above]. rewrite <- (sum_across term). apply total_le. intros d H. unfold term, faces.
  rewrite across_across by auto. destruct (six d) eqn:S; cbn; [|lra].
  destruct (six (across d)) eqn:A; cbn; [rewrite Phi_HH; auto; lra|apply Phi_HT; auto].
Qed.
Lemma faces_fives c : Din c -> faces c = true -> six (along c) = false /\ six (along (along c)) = false.
Proof.
  intros H F. pose proof (apart (across c) (across_in c H) F) as [A B]. rewrite across_along in A, B by auto. split.
  - rewrite <- (link_back L (along c)) by inside. rewrite six_back by inside. exact B.
  - rewrite (link_six L) in A by inside. exact A.
Qed.

(** A term of a t: at each of its HT edges it may take lambda (E - kappa / 2) away, for E is at least kappa in both
    triangles there together (section 14). *)
Variables lambda eps0 eps1 : R.
Hypothesis lambda_pos : 0 <= lambda.
Hypothesis eps0_pos : 0 <= eps0.
Hypothesis eps1_pos : 0 <= eps1.
Let share e := lambda * (E e - kappa theta / 2).
Definition pay c := (if faces (along c) then 0 else share (along (along c))) + (if faces (along (along c)) then 0 else share (along c)).
Definition share_after e := if faces (along e) && negb (six (along e)) && negb (faces (along (along e))) then share e else 0.
Definition share_before e := if faces (along (along e)) && negb (six (along (along e))) && negb (faces (along e)) then share e else 0.
Lemma pay_shares : total darts (fun c => if faces c && negb (six c) then pay c else 0) = total darts (fun e => share_after e + share_before e).
Proof.
  transitivity (total darts (fun c => share_after (along (along c)) + share_before (along c))).
  - apply total_ext. intros c H. unfold share_after, share_before, pay. rewrite !(link_triangle L) by auto.
    destruct (faces c), (six c), (faces (along c)), (faces (along (along c))); cbn [andb negb]; lra.
  - rewrite !total_plus, (sum_along (fun e => share_after (along e))), (sum_along share_after), (sum_along share_before). reflexivity.
Qed.
Lemma spokes_apart e : Din e -> six (along e) = true -> six (along (turn e)) = true -> False.
Proof.
  intros H A B. pose proof (apart_neighbours e H A) as Q. rewrite third in Q by auto. rewrite six_back in Q by inside. congruence.
Qed.
(** The shares of a corner at a five, by the spokes among the five darts there. *)
Lemma shares_five e : Din e -> six e = false -> share_after e + share_before e =
  (if six (along (turn (turn e))) && negb (six (along e)) && negb (six (along (before e))) then share e else 0)
  + (if six (along (before e)) && negb (six (along (turn e))) && negb (six (along (turn (turn e)))) then share e else 0).
Proof.
  intros H S. unfold share_after, share_before.
  assert (A : faces (along e) = six (along (turn (turn e)))) by (unfold faces; rewrite <- across_from_after by inside; rewrite (link_triangle L) by auto; reflexivity).
  assert (B : faces (along (along e)) = six (along (before e))) by (unfold faces; rewrite <- across_from_before by (rewrite ?(link_triangle L); auto; inside); rewrite (link_triangle L) by auto; reflexivity).
  rewrite A, B. replace (six (along (along e))) with (six (along (turn e))) by (rewrite third, six_back by (auto; inside); reflexivity). reflexivity.
Qed.
Lemma shares_six e : Din e -> six e = true -> share_after e + share_before e = 0.
Proof.
  intros H S. unfold share_after, share_before.
  destruct (faces (along e)) eqn:A.
  { destruct (faces_fives (along e) ltac:(inside) A) as [_ Q]. rewrite (link_triangle L) in Q by auto. congruence. }
  destruct (faces (along (along e))) eqn:B; [|cbn [andb]; lra].
  destruct (faces_fives (along (along e)) ltac:(inside) B) as [Q _]. rewrite (link_triangle L) in Q by auto. congruence.
Qed.
Lemma shares_around d : Din d -> six d = false -> let f e := share_after e + share_before e in
  0 <= f d + (f (turn d) + (f (turn (turn d)) + (f (turn (turn (turn d))) + f (turn (turn (turn (turn d))))))).
Proof.
  intros H S f. set (d1 := turn d). set (d2 := turn d1). set (d3 := turn d2). set (d4 := turn d3).
  assert (I1 : Din d1) by (unfold d1; inside). assert (I2 : Din d2) by (unfold d2; inside). assert (I3 : Din d3) by (unfold d3; inside). assert (I4 : Din d4) by (unfold d4; inside).
  assert (R : turn d4 = d) by (apply (link_five_darts L); auto).
  assert (S1 : six d1 = false) by (unfold d1; rewrite (link_six L); auto). assert (S2 : six d2 = false) by (unfold d2; rewrite (link_six L); auto).
  assert (S3 : six d3 = false) by (unfold d3; rewrite (link_six L); auto). assert (S4 : six d4 = false) by (unfold d4; rewrite (link_six L); auto).
  unfold f. rewrite (shares_five d), (shares_five d1), (shares_five d2), (shares_five d3), (shares_five d4) by auto.
  unfold before. fold d1 d2 d3 d4. rewrite R. fold d1 d2 d3 d4. rewrite ?R. fold d1 d2 d3 d4. rewrite ?R.
  pose proof (spokes_apart d H) as A0. pose proof (spokes_apart d1 I1) as A1. pose proof (spokes_apart d2 I2) as A2. pose proof (spokes_apart d3 I3) as A3. pose proof (spokes_apart d4 I4) as A4.
  fold d1 d2 d3 d4 in A0, A1, A2, A3, A4. rewrite R in A4.
  pose proof (link_five_sum L d H S) as Q. fold d1 d2 d3 d4 in Q.
  assert (W : forall e, Din e -> 0 <= lambda * defect e) by (intros e He; apply Rmult_le_pos; [exact lambda_pos|apply defect_pos, He]).
  assert (V : forall e, share e = lambda * kappa theta / 2 - lambda * defect e) by (intros e; unfold share, E, defect, kappa, a0; field).
  assert (T : lambda * kappa theta = lambda * defect d + lambda * defect d1 + lambda * defect d2 + lambda * defect d3 + lambda * defect d4).
  { rewrite <- !Rmult_plus_distr_l. f_equal. unfold kappa, defect. lra. }
  rewrite !V, T. pose proof (W d H). pose proof (W d1 I1). pose proof (W d2 I2). pose proof (W d3 I3). pose proof (W d4 I4).
  destruct (six (along d)), (six (along d1)), (six (along d2)), (six (along d3)), (six (along d4)); cbn [andb negb];
    first [exfalso; first [apply A0; reflexivity|apply A1; reflexivity|apply A2; reflexivity|apply A3; reflexivity|apply A4; reflexivity]|lra].
Qed.
Lemma shares_pos : 0 <= total darts (fun e => share_after e + share_before e).
Proof.
  set (f := fun e => share_after e + share_before e).
  assert (Q : 0 <= total darts (fun d => f d + (f (turn d) + (f (turn (turn d)) + (f (turn (turn (turn d))) + f (turn (turn (turn (turn d))))))))).
  { rewrite <- (total_zero darts). apply total_le. intros d H. destruct (six d) eqn:S; [|apply shares_around; auto].
    unfold f. rewrite !shares_six by (rewrite ?(link_six L) by inside; auto; inside). lra. }
  rewrite !total_plus in Q.
  rewrite (sum_turn (fun d => f (turn (turn (turn d))))), (sum_turn (fun d => f (turn (turn d)))), (sum_turn (fun d => f (turn d))), (sum_turn f) in Q. lra.
Qed.
Definition net c := if faces c && negb (six c) then Psi c - pay c else 0.
Lemma nets : total darts net <= 0.
Proof.
  pose proof terms as T. pose proof shares_pos as P. rewrite <- pay_shares in P.
  assert (Q : total darts term = total darts (fun c => net c + (if faces c && negb (six c) then pay c else 0))).
  { apply total_ext. intros c _. unfold term, net. destruct (faces c && negb (six c)); lra. }
  rewrite total_plus in Q. lra.
Qed.

(** *** One 555 triangle

    What is used of the angles of 555 triangles: [feasible] holds for them, and it implies three inequalities. *)
Variable feasible : R -> R -> R -> Prop.
Hypothesis all_feasible : forall c, Din c -> six c = false -> six (along c) = false -> six (along (along c)) = false ->
  feasible (ang c) (ang (along c)) (ang (along (along c))).
Let Ex A := A - a0 theta.
Let xs := xs theta.
Record pays : Prop := {
  pays_uuu : forall A B C', mid theta A -> mid theta B -> mid theta C' -> feasible A B C' ->
    2 * PI + eps0 + eps1 * (Ex A + Ex B + Ex C') <= 2 * (xs A B C' + xs B C' A + xs C' A B) - K theta * (Ex A + Ex B + Ex C');
  pays_utt : forall A B C', mid theta A -> mid theta B -> mid theta C' -> feasible A B C' ->
    PI + lambda * (Ex B + Ex C' - kappa theta) + eps0 + eps1 * (Ex A + Ex B + Ex C')
    <= 3 / 2 * (xs B C' A + xs C' A B) - K theta * Ex A - C theta (PI / 3) * (Ex B + Ex C');
  pays_tt : forall A B C', mid theta A -> mid theta B -> mid theta C' -> feasible A B C' ->
    PI / 3 + lambda * (Ex B + Ex C' - kappa theta) + eps0 + eps1 * (Ex A + Ex B + Ex C') <= xs A B C' }.
Hypothesis P : pays.
Lemma K_pos : 0 < K theta.
Proof. apply Rinv_0_lt_compat, sin_pos. pose proof (between theta range). lra. Qed.
Lemma C_pos : 0 < C theta (PI / 3).
Proof.
  unfold C, tan. pose proof (Sides.numbers theta range) as [N1 [N2 [_ [N3 _]]]]. rewrite sin_PI3. pose proof (sqrt_lt_R0 3 ltac:(lra)).
  repeat first [apply Rdiv_lt_0_compat | apply Rmult_lt_0_compat]; lra.
Qed.

Section Triangle.
Variable c : dart.
Hypothesis inside_c : Din c.
Let c1 := along c.
Let c2 := along (along c).
Hypothesis five0 : six c = false.
Hypothesis five1 : six c1 = false.
Hypothesis five2 : six c2 = false.
Let S3 := net c + net c1 + net c2.
Lemma triangle_pays : (faces c || faces c1 || faces c2 = true) -> eps0 + eps1 * (E c + E c1 + E c2) <= S3.
Proof.
  assert (I1 : Din c1) by (unfold c1; inside). assert (I2 : Din c2) by (unfold c2; inside).
  assert (R1 : along c1 = c2) by reflexivity. assert (R2 : along c2 = c) by (apply (link_triangle L); auto). assert (R0 : along c = c1) by reflexivity.
  pose proof (ang_middle c inside_c five0) as M0. pose proof (ang_middle c1 I1 five1) as M1. pose proof (ang_middle c2 I2 five2) as M2.
  pose proof (E_above c inside_c five0) as [P0 Q0]. pose proof (E_above c1 I1 five1) as [P1 Q1]. pose proof (E_above c2 I2 five2) as [P2 Q2].
  assert (D : forall d, Din d -> 0 <= defect d) by exact defect_pos.
  pose proof (D (turn c) ltac:(inside)). pose proof (D (turn c1) ltac:(inside)). pose proof (D (turn c2) ltac:(inside)).
  pose proof (D _ (before_in c inside_c)). pose proof (D _ (before_in c1 I1)). pose proof (D _ (before_in c2 I2)).
  assert (X0 : xl c = xs (ang c) (ang c1) (ang c2)) by (rewrite xl_is by auto; rewrite R0, R1; reflexivity).
  assert (X1 : xl c1 = xs (ang c1) (ang c2) (ang c)) by (rewrite xl_is by (rewrite ?R1, ?R2; auto); rewrite R1, R2; reflexivity).
  assert (X2 : xl c2 = xs (ang c2) (ang c) (ang c1)) by (rewrite xl_is by (rewrite ?R2, ?R0; auto); rewrite R2, R0; reflexivity).
  pose proof (all_feasible c inside_c five0 five1 five2) as F0. fold c1 c2 in F0.
  pose proof (all_feasible c1 I1 five1 ltac:(rewrite R1; exact five2) ltac:(rewrite R1, R2; exact five0)) as F1. rewrite R1, R2 in F1.
  pose proof (all_feasible c2 I2 five2 ltac:(rewrite R2; exact five0) ltac:(rewrite R2, R0; exact five1)) as F2. rewrite R2, R0 in F2.
  pose proof (pays_uuu P _ _ _ M0 M1 M2 F0) as U. change (Ex (ang c)) with (E c) in U. change (Ex (ang c1)) with (E c1) in U. change (Ex (ang c2)) with (E c2) in U.
  pose proof (pays_utt P _ _ _ M0 M1 M2 F0) as U0. change (Ex (ang c)) with (E c) in U0. change (Ex (ang c1)) with (E c1) in U0. change (Ex (ang c2)) with (E c2) in U0.
  pose proof (pays_utt P _ _ _ M1 M2 M0 F1) as U1. change (Ex (ang c)) with (E c) in U1. change (Ex (ang c1)) with (E c1) in U1. change (Ex (ang c2)) with (E c2) in U1.
  pose proof (pays_utt P _ _ _ M2 M0 M1 F2) as U2. change (Ex (ang c)) with (E c) in U2. change (Ex (ang c1)) with (E c1) in U2. change (Ex (ang c2)) with (E c2) in U2.
  pose proof (pays_tt P _ _ _ M0 M1 M2 F0) as V0. change (Ex (ang c)) with (E c) in V0. change (Ex (ang c1)) with (E c1) in V0. change (Ex (ang c2)) with (E c2) in V0.
  pose proof (pays_tt P _ _ _ M1 M2 M0 F1) as V1. change (Ex (ang c)) with (E c) in V1. change (Ex (ang c1)) with (E c1) in V1. change (Ex (ang c2)) with (E c2) in V1.
  pose proof (pays_tt P _ _ _ M2 M0 M1 F2) as V2. change (Ex (ang c)) with (E c) in V2. change (Ex (ang c1)) with (E c1) in V2. change (Ex (ang c2)) with (E c2) in V2.
  pose proof K_pos as KP. pose proof C_pos as CP.
  assert (KK : forall x y, x <= y -> K theta * x <= K theta * y) by (intros; apply Rmult_le_compat_l; lra).
  assert (CC : forall x y, x <= y -> C theta (PI / 3) * x <= C theta (PI / 3) * y) by (intros; apply Rmult_le_compat_l; lra).
  pose proof (KK _ _ Q0). pose proof (KK _ _ Q1). pose proof (KK _ _ Q2).
  pose proof (CC (defect (turn c)) (E c) ltac:(lra)). pose proof (CC (defect (turn c1)) (E c1) ltac:(lra)). pose proof (CC (defect (turn c2)) (E c2) ltac:(lra)).
  pose proof (CC (defect (before c)) (E c) ltac:(lra)). pose proof (CC (defect (before c1)) (E c1) ltac:(lra)). pose proof (CC (defect (before c2)) (E c2) ltac:(lra)).
  unfold S3, net. rewrite five0, five1, five2. unfold Psi, pay, share. rewrite R0, R1, R2, R0, X0, X1, X2.
  destruct (faces c), (faces c1), (faces c2); cbn [andb negb orb]; intros F; try discriminate; lra.
Qed.
Lemma triangle_nonneg : 0 <= S3.
Proof.
  destruct (faces c || faces c1 || faces c2) eqn:F.
  - pose proof (triangle_pays F). pose proof (E_above c inside_c five0). pose proof (E_above c1 ltac:(unfold c1; inside) five1). pose proof (E_above c2 ltac:(unfold c2; inside) five2).
    assert (0 <= eps1 * (E c + E c1 + E c2)) by (apply Rmult_le_pos; lra). lra.
  - apply orb_false_iff in F. destruct F as [F F2]. apply orb_false_iff in F. destruct F as [F0 F1]. unfold S3, net. rewrite F0, F1, F2. cbn. lra.
Qed.
End Triangle.

(** ** Section 11: equality in every term *)

Lemma no_triangle c : Din c -> six c = true -> net c + net (along c) + net (along (along c)) = 0.
Proof.
  intros H S. assert (F : forall d, Din d -> (six (along d) = true \/ six (along (along d)) = true) -> faces d = false).
  { intros d D Z. destruct (faces d) eqn:Q; auto. destruct (faces_fives d D Q). destruct Z; congruence. }
  unfold net. rewrite S, (F (along c)), (F (along (along c))); [|inside|left|inside|right]; try (rewrite (link_triangle L) by inside; exact S).
  rewrite andb_false_r. cbn. lra.
Qed.
Lemma triangles_nonneg c : Din c -> 0 <= net c + net (along c) + net (along (along c)).
Proof.
  intros H. destruct (six c) eqn:S0; [rewrite no_triangle; auto; lra|].
  destruct (six (along c)) eqn:S1.
  { pose proof (no_triangle (along c) ltac:(inside) S1) as Q. rewrite (link_triangle L) in Q by auto. lra. }
  destruct (six (along (along c))) eqn:S2.
  { pose proof (no_triangle (along (along c)) ltac:(inside) S2) as Q. rewrite (link_triangle L c) in Q by auto. lra. }
  apply triangle_nonneg; auto.
Qed.
Lemma equality c : Din c -> net c + net (along c) + net (along (along c)) = 0.
Proof.
  intros H. apply (total_all_zero darts (fun c => net c + net (along c) + net (along (along c))) triangles_nonneg); [|exact H].
  rewrite !total_plus, (sum_along (fun c => net (along c))), (sum_along net). pose proof nets. lra.
Qed.
(** There is an HT edge. *)
Lemma some_HT : exists d, Din d /\ six d = true /\ six (across d) = false.
Proof.
  destruct (link_some L) as [d [H S]]. destruct (apart d H S) as [S1 S2].
  destruct (six (across d)) eqn:A; [|exists d; auto].
  exists (along (back d)). assert (I : Din (along (back d))) by inside. split; [exact I|]. split.
  - rewrite <- six_back by inside. rewrite (link_back L) by auto. exact S.
  - rewrite <- across_from_after by exact I. rewrite (link_triangle L) by inside.
    destruct (six (along (turn (turn (back d))))) eqn:B; auto. exfalso. apply (not_both (back d)); [inside|]. split; [exact B|].
    unfold hB. change (turn (turn (turn (back d)))) with (before (along d)). rewrite across_from_before; auto.
Qed.
(** There is a 555 triangle at an HT edge, and nothing is left over. *)
Theorem nothing_left : exists d, Din d /\ six d = false /\ six (along d) = false /\ six (along (along d)) = false /\
  eps0 + eps1 * (E d + E (along d) + E (along (along d))) <= 0.
Proof.
  destruct some_HT as [d [H [S A]]]. exists (across d). pose proof (across_in d H) as I. split; [exact I|]. split; [exact A|].
  assert (F : faces (across d) = true) by (unfold faces; rewrite across_across; auto).
  destruct (faces_fives _ I F) as [S1 S2]. set (c := across d) in *. split; [exact S1|]. split; [exact S2|].
  pose proof (equality c I) as Q. pose proof (triangle_pays c I A S1 S2 ltac:(rewrite F; reflexivity)) as PA'. lra.
Qed.
End Link.

(** ** theta*: a triangle whose three angles are a0, at vertices of degree 5 *)
Lemma star_pays : pays T 0 0 0.001 (fun _ _ _ => True).
Proof.
  pose proof D_numbers as [N1 N2]. assert (Q : forall x, middle x -> 0 <= excess x) by (intros x [A _]; unfold excess; lra).
  split; intros A B C' HA HB HC _; pose proof (Q A HA); pose proof (Q B HB); pose proof (Q C' HC); fold (excess A) (excess B) (excess C').
  - pose proof (uuu_above A B C' HA HB HC) as U. unfold KT in U. lra.
  - pose proof (utt_above A B C' HA HB HC) as U. unfold KT, CT in U. lra.
  - pose proof (X_above A B C' HA HB HC) as U. fold (excess A) (excess B) (excess C') in U.
    assert (0 <= (D1 - 0.001) * excess A) by (apply Rmult_le_pos; lra). assert (0 <= (D2 - 0.001) * (excess B + excess C')) by (apply Rmult_le_pos; lra). lra.
Qed.
Theorem three_a0 dart darts turn along six ang len : link dart darts turn along six ang len -> (forall d, In d darts -> ang d <= T) ->
  exists d, In d darts /\ six d = false /\ ang d = a0 T /\ ang (along d) = a0 T /\ ang (along (along d)) = a0 T.
Proof.
  intros L M. pose proof (link_along _ _ _ _ _ _ _ L) as Al. pose proof (ang_middle _ _ _ _ _ _ _ L T M) as AM.
  assert (X60 : forall c, In c darts -> six c = false -> six (along c) = false -> six (along (along c)) = false -> PI / 3 <= apex T (len (along c))).
  { intros c I S0 S1 S2. apply (lemma_3_at_least (ang c) (ang (along c)) (ang (along (along c))) _ (len (along (along c))) (len c)); auto. apply (link_spherical _ _ _ _ _ _ _ L c I). }
  destruct (nothing_left _ _ _ _ _ _ _ L T T_range M X60 0 0 0.001 ltac:(lra) ltac:(lra) ltac:(lra) (fun _ _ _ => True) (fun _ _ _ _ _ => Logic.I) star_pays) as [d [I [S0 [S1 [S2 Z]]]]].
  exists d. split; [exact I|]. split; [exact S0|].
  pose proof (AM d I S0) as [A0 _]. pose proof (AM (along d) (Al d I) S1) as [A1 _]. pose proof (AM (along (along d)) (Al _ (Al d I)) S2) as [A2 _].
  unfold E in Z. lra.
Qed.

(** Theorem 2, for a link with angles. *)
Theorem theorem_2_link dart darts turn along six ang len :
  link dart darts turn along six ang len -> exists d, In d darts /\ theta_star <= ang d.
Proof.
  intros L. destruct (Exists_dec (fun d => theta_star <= ang d) darts (fun d => Rle_dec _ _)) as [H|H].
  - apply Exists_exists in H. exact H.
  - exfalso. assert (B : forall d, In d darts -> ang d < theta_star).
    { intros d D. apply Rnot_le_lt. intros Q. apply H, Exists_exists. exists d. auto. }
    destruct (three_a0 _ _ _ _ _ _ _ L (fun d D => Rlt_le _ _ (B d D))) as [c [I [S [E _]]]].
    pose proof (link_five_sum _ _ _ _ _ _ _ L c I S) as Q. unfold a0 in E.
    assert (I1 : In (turn c) darts) by (apply L; auto). assert (I2 : In (turn (turn c)) darts) by (apply L; auto).
    assert (I3 : In (turn (turn (turn c))) darts) by (apply L; auto). assert (I4 : In (turn (turn (turn (turn c)))) darts) by (apply L; auto).
    pose proof (B _ I1). pose proof (B _ I2). pose proof (B _ I3). pose proof (B _ I4). lra.
Qed.

(** ** The tetrahedra at a vertex

    The darts are those of the link of the point v.  [tip d] is the other end of the edge from v on which d starts, and
    the tetrahedron of d has the vertices v, [tip d], [tip (along d)] and [tip (along (along d))].  So each tetrahedron
    has three darts, and [corner_angle d] is its dihedral angle at the edge from v to [tip d].  The tetrahedra at this
    edge are those of d, [turn d], [turn (turn d)], and so on: five of them, or six if [six d]. *)
Definition corner_tetrahedron {dart} (v : point) (tip : dart -> point) (along : dart -> dart) (d : dart) :=
  Tetrahedron v (tip d) (tip (along d)) (tip (along (along d))).
Definition corner_angle {dart} (v : point) (tip : dart -> point) (along : dart -> dart) (d : dart) :=
  dihedral v (tip d) (tip (along d)) (tip (along (along d))).
Record star (dart : Type) (v : point) (darts : list dart) (turn along : dart -> dart) (tip : dart -> point) (six : dart -> bool) : Prop := {
  star_distinct : NoDup darts;
  star_turn : forall d, In d darts -> In (turn d) darts;
  star_along : forall d, In d darts -> In (along d) darts;
  star_triangle : forall d, In d darts -> along (along (along d)) = d;
  star_back : forall d, In d darts -> turn (along (turn (along d))) = d;
  star_tip : forall d, In d darts -> tip (turn d) = tip d;
  star_solid : forall d, In d darts -> vol (corner_tetrahedron v tip along d) <> 0;
  star_six : forall d, In d darts -> six (turn d) = six d;
  star_five_darts : forall d, In d darts -> six d = false -> turn (turn (turn (turn (turn d)))) = d;
  star_six_darts : forall d, In d darts -> six d = true -> turn (turn (turn (turn (turn (turn d))))) = d;
  star_apart : forall d, In d darts -> six d = true -> six (turn (along d)) = false;
  star_some : exists d, In d darts /\ six d = true;
  star_five_sum : forall d, In d darts -> six d = false -> let a := corner_angle v tip along in
    a d + a (turn d) + a (turn (turn d)) + a (turn (turn (turn d))) + a (turn (turn (turn (turn d)))) = 2 * PI;
  star_six_sum : forall d, In d darts -> six d = true -> let a := corner_angle v tip along in
    a d + a (turn d) + a (turn (turn d)) + a (turn (turn (turn d))) + a (turn (turn (turn (turn d))))
    + a (turn (turn (turn (turn (turn d))))) = 2 * PI }.

Section Star.
Variables (dart : Type) (v : point) (darts : list dart) (turn along : dart -> dart) (tip : dart -> point) (six : dart -> bool).
Hypothesis S : star dart v darts turn along tip six.
Lemma star_link : link dart darts turn along six (corner_angle v tip along) (fun d => angle (sub (tip d) v) (sub (tip (along d)) v)).
Proof.
  destruct S. split; auto.
  - intros d D. unfold corner_angle. rewrite !star_triangle0 by auto. apply corner. exact (star_solid0 d D).
  - intros d D. rewrite angle_sym. do 2 f_equal.
    + rewrite <- (star_tip0 (along (turn (along d)))) by auto. rewrite star_back0 by auto. reflexivity.
    + rewrite star_tip0 by auto. reflexivity.
Qed.

Theorem theorem_2 : exists d, In d darts /\ theta_star <= corner_angle v tip along d.
Proof. exact (theorem_2_link _ _ _ _ _ _ _ star_link). Qed.

(** Step C of section 6: with the other three angles of the tetrahedra, some angle is above theta*. *)
Theorem above_theta_star : exists d, In d darts /\ exists x, In x (dihedrals (corner_tetrahedron v tip along d)) /\ theta_star < x.
Proof.
  destruct (Exists_dec (fun d => Exists (fun x => theta_star < x) (dihedrals (corner_tetrahedron v tip along d))) darts
    (fun d => Exists_dec _ _ (fun x => Rlt_dec _ _))) as [H|H].
  - apply Exists_exists in H. destruct H as [d [D X]]. apply Exists_exists in X. exists d. auto.
  - exfalso. assert (B : forall d, In d darts -> all_at_most v (tip d) (tip (along d)) (tip (along (along d))) theta_star).
    { intros d D x X. apply Rnot_lt_le. intros Q. apply H, Exists_exists. exists d. split; [exact D|]. apply Exists_exists. exists x. auto. }
    destruct (three_a0 _ _ _ _ _ _ _ star_link) as [d [D [_ [E0 [E1 E2]]]]].
    { intros d D. apply (B d D). left. reflexivity. }
    pose proof (star_triangle _ _ _ _ _ _ _ S) as R. pose proof (star_along _ _ _ _ _ _ _ S) as I.
    unfold corner_angle in *. rewrite !R in E1 by auto. rewrite !R in E2 by auto.
    apply (step_c v (tip d) (tip (along d)) (tip (along (along d)))); [exact (star_solid _ _ _ _ _ _ _ S d D)|auto|].
    rewrite E0, (dihedral_sym v (tip (along d))), E1, E2. auto using ca0.
Qed.
End Star.
