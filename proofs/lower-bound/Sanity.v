(** * docs/lower-bound.md, section 11: equality is possible in Theorem 2 for links

    24 triangles with the angles 60, theta*, theta* and four with three angles a0 satisfy all demands of [link]: so they
    do not contradict each other, and no larger bound than theta* follows from them.  The vertices are 4 sixes and 12
    fives; the fives and the four triangles form a truncated tetrahedron, and each six is in one of its hexagons.
    At the end there is a TCP tiling of space: the hypotheses of the theorems are not empty. *)
From Coq Require Import Reals Lra List Bool Arith Lia ZArith.
From Acutile Require Import Statement Certificate Sanity.
From LowerBound Require Import Calculus Normals Corners Triangles Excess Link Tiling Theorem1.
Import ListNotations.
Open Scope R_scope.

Definition alongs := [
   1; 2; 0; 4; 5; 3; 7; 8; 6; 10; 11; 9; 13; 14; 12; 16; 17; 15; 19; 20; 18; 22; 23; 21; 25; 26; 24; 28; 29; 27;
   31; 32; 30; 34; 35; 33; 37; 38; 36; 40; 41; 39; 43; 44; 42; 46; 47; 45; 49; 50; 48; 52; 53; 51; 55; 56; 54;
   58; 59; 57; 61; 62; 60; 64; 65; 63; 67; 68; 66; 70; 71; 69; 73; 74; 72; 76; 77; 75; 79; 80; 78; 82; 83; 81]%nat.
Definition turns := [
   64; 82; 46; 70; 58; 28; 34; 76; 22; 52; 40; 16; 15; 29; 55; 18; 14; 10; 21; 17; 37; 24; 20; 7; 27; 23; 73;
   12; 26; 4; 33; 47; 79; 36; 32; 8; 39; 35; 19; 42; 38; 9; 45; 41; 49; 30; 44; 1; 51; 65; 43; 54; 50; 11; 57;
   53; 13; 60; 56; 3; 63; 59; 67; 48; 62; 2; 69; 83; 61; 72; 68; 5; 75; 71; 25; 78; 74; 6; 81; 77; 31; 66; 80;
   0]%nat.
(** Darts 0 to 11 are those of the four triangles; then each hexagon triangle has three, the first one at the six. *)
Definition darts := seq 0 84.
Definition along d := nth d alongs 0%nat.
Definition turn d := nth d turns 0%nat.
Definition six d := (12 <=? d)%nat && (d mod 3 =? 0)%nat.
Definition ang d := if (d <? 12)%nat then a0 T else if six d then PI / 3 else T.
(** The edges of the hexagons, and the spokes. *)
Definition edge := acos (7 / 11).
Definition spoke := acos (sqrt 3 / sqrt 11).
Definition len d := if (d <? 12)%nat || (d mod 3 =? 1)%nat then edge else spoke.

Lemma edge_range : cos edge = 7 / 11 /\ 0 < edge < PI.
Proof.
  assert (E : cos edge = 7 / 11) by (apply cos_acos; lra). split; [exact E|]. pose proof (acos_bound (7 / 11)) as B. fold edge in B.
  split; apply Rnot_le_lt; intros Z; [replace edge with 0 in E by lra; rewrite cos_0 in E|replace edge with PI in E by lra; rewrite cos_PI in E]; lra.
Qed.
Lemma spoke_range : cos spoke = sqrt 3 / sqrt 11 /\ 0 < spoke < PI.
Proof.
  pose proof root3. pose proof root11.
  assert (Q : 0 < sqrt 3 / sqrt 11 < 1).
  { split; [apply Rdiv_lt_0_compat; lra|]. apply Rmult_lt_reg_r with (sqrt 11); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (E : cos spoke = sqrt 3 / sqrt 11) by (apply cos_acos; lra). split; [exact E|]. pose proof (acos_bound (sqrt 3 / sqrt 11)) as B. fold spoke in B.
  split; apply Rnot_le_lt; intros Z; [replace spoke with 0 in E by lra; rewrite cos_0 in E|replace spoke with PI in E by lra; rewrite cos_PI in E]; lra.
Qed.
Lemma all_a0 : spherical_triangle (a0 T) (a0 T) (a0 T) edge edge edge.
Proof.
  destruct edge_range as [E B]. pose proof (between T T_range). pose proof root11 as [R _].
  assert (S : side_rule (a0 T) (a0 T) (a0 T) edge).
  { unfold side_rule. rewrite E, ca0, sa0. replace (5 * sqrt 11 / 18 * (5 * sqrt 11 / 18)) with (25 * (sqrt 11 * sqrt 11) / 324) by field. rewrite R. lra. }
  pose proof PI_RGT_0. split; try assumption; lra.
Qed.
Lemma hexagon_triangle : spherical_triangle (PI / 3) T T edge spoke spoke.
Proof.
  destruct edge_range as [E B]. destruct spoke_range as [E' B']. pose proof T_acute. pose proof root11 as [R R']. pose proof root3 as [R3 R3']. pose proof PI_RGT_0.
  assert (S : side_rule T T (PI / 3) spoke).
  { unfold side_rule. rewrite E', sT, cT, cos_PI3, sin_PI3.
    replace (sqrt 3 * sqrt 11 / 6 * (sqrt 3 / 2) * (sqrt 3 / sqrt 11)) with (sqrt 3 * (sqrt 3 * sqrt 3) / 12) by (field; lra). rewrite R3. lra. }
  split; try assumption; try lra.
  - unfold side_rule. rewrite E, sT2, cT, cos_PI3. lra.
  - unfold side_rule in *. rewrite (Rmult_comm (cos (PI / 3))), (Rmult_comm (sin (PI / 3))). exact S.
Qed.

Lemma turned_triangle A B C a b c : spherical_triangle A B C a b c -> spherical_triangle B C A b c a.
Proof. intros []. split; assumption. Qed.

(** The demands on numbers, by computation. *)
Lemma computed (p : nat -> bool) : forallb p darts = true -> forall d, In d darts -> p d = true.
Proof. intros H. apply forallb_forall. exact H. Qed.
(** The kinds of corners: a0, 60 degrees, theta*. *)
Definition kind d := if (d <? 12)%nat then 0%nat else if six d then 1%nat else 2%nat.
Definition value k := match k with 0%nat => a0 T | 1%nat => PI / 3 | _ => T end.
Lemma ang_value d : ang d = value (kind d).
Proof. unfold ang, kind. destruct (d <? 12)%nat; [|destruct (six d)]; reflexivity. Qed.
Definition long d := (d <? 12)%nat || (d mod 3 =? 1)%nat.
Definition same (l m : list nat) := if list_eq_dec Nat.eq_dec l m then true else false.
Lemma same_eq l m : same l m = true -> l = m.
Proof. unfold same. destruct (list_eq_dec Nat.eq_dec l m); congruence. Qed.
Definition kinds_five d := map kind [d; turn d; turn (turn d); turn (turn (turn d)); turn (turn (turn (turn d)))].
Definition shape d := map kind [d; along d; along (along d)] ++ map (fun e => if long e then 1%nat else 0%nat) [along d; along (along d); d].

Theorem equality_is_possible : link nat darts turn along six ang len /\ forall d, In d darts -> ang d <= theta_star.
Proof.
  pose proof (between T T_range) as [B _]. pose proof T_acute. pose proof T_range. pose proof PI_RGT_0.
  assert (M : forall d, (d <? 84)%nat = true -> In d darts) by (intros d Z; apply Nat.ltb_lt in Z; apply in_seq; lia).
  split; [split|].
  - apply seq_NoDup.
  - intros d D. apply M. apply (computed (fun d => turn d <? 84)%nat); [vm_compute; reflexivity|exact D].
  - intros d D. apply M. apply (computed (fun d => along d <? 84)%nat); [vm_compute; reflexivity|exact D].
  - intros d D. apply Nat.eqb_eq. apply (computed (fun d => along (along (along d)) =? d)%nat); [vm_compute; reflexivity|exact D].
  - intros d D. apply Nat.eqb_eq. apply (computed (fun d => turn (along (turn (along d))) =? d)%nat); [vm_compute; reflexivity|exact D].
  - intros d D. apply eqb_prop. apply (computed (fun d => Bool.eqb (six (turn d)) (six d))); [vm_compute; reflexivity|exact D].
  - intros d D Z. apply Nat.eqb_eq. pose proof (computed (fun d => six d || (turn (turn (turn (turn (turn d)))) =? d)%nat) ltac:(vm_compute; reflexivity) d D) as Q.
    cbv beta in Q. rewrite Z in Q. exact Q.
  - intros d D Z. apply Nat.eqb_eq. pose proof (computed (fun d => negb (six d) || (turn (turn (turn (turn (turn (turn d))))) =? d)%nat) ltac:(vm_compute; reflexivity) d D) as Q.
    cbv beta in Q. rewrite Z in Q. exact Q.
  - intros d D Z. apply negb_true_iff. pose proof (computed (fun d => negb (six d) || negb (six (turn (along d)))) ltac:(vm_compute; reflexivity) d D) as Q.
    cbv beta in Q. rewrite Z in Q. exact Q.
  - exists 12%nat. split; [apply M|]; reflexivity.
  - intros d D. pose proof (computed (fun d => existsb (same (shape d)) [[0;0;0;1;1;1]; [1;2;2;1;0;0]; [2;2;1;0;0;1]; [2;1;2;0;1;0]])%nat ltac:(vm_compute; reflexivity) d D) as Q.
    cbv beta in Q. apply existsb_exists in Q. destruct Q as [l [Il Q]]. apply same_eq in Q.
    rewrite !ang_value. unfold len. fold (long d) (long (along d)) (long (along (along d))).
    unfold shape in Q. cbn [map app] in Q.
    assert (X : forall e, (if long e then edge else spoke) = match (if long e then 1%nat else 0%nat) with 1%nat => edge | _ => spoke end) by (intros e; destruct (long e); reflexivity).
    rewrite !X. destruct Il as [<-|[<-|[<-|[<-|[]]]]]; injection Q as -> -> -> -> -> ->; cbn [value].
    + exact all_a0.
    + exact hexagon_triangle.
    + exact (turned_triangle _ _ _ _ _ _ hexagon_triangle).
    + exact (turned_triangle _ _ _ _ _ _ (turned_triangle _ _ _ _ _ _ hexagon_triangle)).
  - intros d D. pose proof (computed (fun d => Bool.eqb (long (turn (along d))) (long d)) ltac:(vm_compute; reflexivity) d D) as Q.
    apply eqb_prop in Q. unfold len. fold (long d) (long (turn (along d))). rewrite Q. reflexivity.
  - intros d D Z. pose proof (computed (fun d => six d || existsb (same (kinds_five d)) [[0;2;2;2;2]; [2;0;2;2;2]; [2;2;0;2;2]; [2;2;2;0;2]; [2;2;2;2;0]])%nat ltac:(vm_compute; reflexivity) d D) as Q.
    cbv beta in Q. rewrite Z in Q. cbn [orb] in Q. apply existsb_exists in Q. destruct Q as [l [Il Q]]. apply same_eq in Q. unfold kinds_five in Q. cbn [map] in Q.
    rewrite !ang_value. destruct Il as [<-|[<-|[<-|[<-|[<-|[]]]]]]; injection Q as -> -> -> -> ->; cbn [value]; unfold a0; lra.
  - intros d D Z. pose proof (computed (fun d => negb (six d) || same (map kind [d; turn d; turn (turn d); turn (turn (turn d)); turn (turn (turn (turn d))); turn (turn (turn (turn (turn d))))]) [1;1;1;1;1;1])%nat ltac:(vm_compute; reflexivity) d D) as Q.
    cbv beta in Q. rewrite Z in Q. cbn [orb negb] in Q. apply same_eq in Q. cbn [map] in Q. rewrite !ang_value. injection Q as -> -> -> -> -> ->. cbn [value]. lra.
  - intros d D. rewrite ang_value. unfold value. destruct (kind d) as [|[|k]]; lra.
Qed.

(** ** A TCP tiling of space, from the bytes of the certificate a15 *)
Definition a15 := hex "
  857361637574696c652d6365727469666963617465026674696c696e6785036151838301000082010081016573706163658a73666163652d746f
  2d666163652074696c696e6765616375746584766c61726765737420646968656472616c20616e676c65676d6178696d756d018201181984766c
  61726765737420646968656472616c20616e676c65676d696e696d756d01820418318477736d616c6c65737420646968656472616c20616e676c
  65676d6178696d756d018201078477736d616c6c65737420646968656472616c20616e676c65676d696e696d756d018209181983781973717561
  726564207261646975732d6564676520726174696f676d6178696d756d82010283781973717561726564207261646975732d6564676520726174
  696f676d696e696d756d82050c6844656c61756e6179635443508404888300000083000002830200038303020383010203830201018300020183
  02030180982e85008401000020840320202084022000200185008401000020840220002084032000200185008401000020840200002084040020
  20018500840100002084040000208402000020018500840100002084040020208403202020182185008401000020840320002084040000201821
  85000106840520000001850001840520000084072020001821850001050601850001840700200005182185000184072020008406002000018500
  01840600200084070020000185008402200020840520000084032000200085008402200020840720200084052000001820850084022000208403
  20202084072020000085008402000020058407002000182085008402000020840400002005008500840200002084070020008404002020008500
  84032000208405200000060085008404000020060500850084032020208406002000840720200000850084032020208404002020840600200008
  85008404002020840700200084060020000085008403200020068404000020088501840220000084032000008405200000008501840220000084
  05200000840720200018208501840220000084072020008403202000008501028407002000051820850102050400850102840400200084070020
  00008501840320000006840520000000850104050600850184032020008407202000840600200000850184032020008406002000840400200008
  85018404002000840600200084070020000085018403200000040608850203050408850203048405000001088502840300200084040020008407
  00200008850284030020008407002001840400200008850484050000018407000001840600000110850405060710850384050000018406010001
  8407000001108503050784060100001085030484050000018407000001182185030407051821".
Theorem a_tiling : exists l1 l2 l3 N P, face_to_face_tiling l1 l2 l3 3 (fun _ => True) N P /\ tcp l1 l2 l3 3 N P /\ space_tiling (is_tile 3 N) (tile l1 l2 l3 P).
Proof.
  assert (B : exists l1 l2 l3, has_gram (Gram 1 1 1 0 0 0) l1 l2 l3 /\ exists n P, face_to_face_tiling l1 l2 l3 3 (domain l1 l2 l3 3 []) n P /\ tcp l1 l2 l3 3 n P) by acutile a15.
  destruct B as [l1 [l2 [l3 [_ [n [P [H TCP']]]]]]]. assert (D : forall X, domain l1 l2 l3 3 [] X) by (intros X; apply domain_space, (tiling_basis _ _ _ _ _ _ _ H)).
  exists l1, l2, l3, n, P. split; [destruct H; split; auto|]. split; [exact TCP'|]. exact (periodic_space l1 l2 l3 _ n P D H).
Qed.
