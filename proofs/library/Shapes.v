(* The shapes of goals that [acutile] proves, and goals that it must not prove.
   check.sh compiles this file against the installed library.
   The bytes are those of four certificates of tests/certificates/valid and one of the catalogue. *)
From Acutile Require Import Certificate.
Import ListNotations.
Local Open Scope R_scope.

(* space-bcc.json *)
Definition bcc := hex "
  857361637574696c652d6365727469666963617465026674696c696e6785036151838303202082032081036573706163658773666163652d746f
  2d666163652074696c696e67696e6f6e6f627475736584766c61726765737420646968656472616c20616e676c65676d6178696d756d00820001
  8477736d616c6c65737420646968656472616c20616e676c65676d696e696d756d0182010483781973717561726564207261646975732d656467
  6520726174696f676d6178696d756d82050c6844656c61756e61796f7765616b6c792044656c61756e6179840181830000008086840084000100
  00840001010084000101018400840001000084000101018400010001840084000001008400010101840001010084008400000100840000010184
  0001010184008400000001840001000184000101018400840000000184000101018400000101".
Theorem bcc_for_all : forall l1 l2 l3, has_gram (Gram 3 3 3 (-1) (-1) (-1)) l1 l2 l3 ->
  exists n P, face_to_face_tiling l1 l2 l3 3 (domain l1 l2 l3 3 []) n P /\ nonobtuse l1 l2 l3 3 n P /\ delaunay l1 l2 l3 3 n P /\
    smallest_dihedral_angle l1 l2 l3 3 n P Minimum (acos (1 * sqrt (1 / 4))) /\
    squared_radius_edge_ratio l1 l2 l3 3 n P Maximum (1 / 4 + 1 / 6).
Proof. acutile bcc. Qed.
Theorem bcc_exists : exists l1 l2 l3, has_gram (Gram 3 (2 + 1) 3 (-1) (-1) (-1)) l1 l2 l3 /\
  exists n P, squared_radius_edge_ratio l1 l2 l3 3 n P Maximum (5 / 12) /\ face_to_face_tiling l1 l2 l3 3 (domain l1 l2 l3 3 []) n P.
Proof. acutile bcc. Qed.
(* another Gram matrix, a statement that the claim has not, another bound, another domain *)
Theorem bcc_wrong : True.
Proof.
  assert (forall l1 l2 l3, has_gram (Gram 3 3 4 (-1) (-1) (-1)) l1 l2 l3 -> exists n P, nonobtuse l1 l2 l3 3 n P).
  { Fail acutile bcc. admit. }
  assert (forall l1 l2 l3, has_gram (Gram 3 3 3 (-1) (-1) (-1)) l1 l2 l3 -> exists n P, acute l1 l2 l3 3 n P).
  { Fail acutile bcc. admit. }
  assert (forall l1 l2 l3, has_gram (Gram 3 3 3 (-1) (-1) (-1)) l1 l2 l3 ->
    exists n P, squared_radius_edge_ratio l1 l2 l3 3 n P Maximum (5 / 13)).
  { Fail acutile bcc. admit. }
  assert (forall l1 l2 l3, has_gram (Gram 3 3 3 (-1) (-1) (-1)) l1 l2 l3 ->
    exists n P, face_to_face_tiling l1 l2 l3 3 (domain l1 l2 l3 2 []) n P).
  { Fail acutile bcc. admit. }
  assert (False). { Fail acutile bcc. admit. }
Abort.

(* solid-of-half-size.json *)
Definition half := hex "
  857361637574696c652d6365727469666963617465026674696c696e67850261518282010081018265736f6c6964830683820000820300820002
  838200018201028202008173666163652d746f2d666163652074696c696e67840683820000820300820002808183000102".
Theorem half_square : forall l1 l2, has_gram2 (Gram2 1 1 0) l1 l2 ->
  exists n P, edge_to_edge_tiling l1 l2 0 (domain2 l1 l2 0 [Point2 0 0; Point2 (1 / 2) 0; Point2 0 (1 / 3)]) n P.
Proof. acutile half. Qed.

(* strip-of-height-sqrt-3.json *)
Definition strip := hex "
  857361637574696c652d6365727469666963617465026674696c696e6785028283220001830102018282820100820000818201008264736c6162
  830182818200008182000182810081018373666163652d746f2d666163652074696c696e67696e6f6e6f62747573656f7765616b6c792044656c
  61756e617984018282820000820000828200008200018082830082000101830001820120".
Theorem strip_over_a_field : exists a, the_root (Root [-3; 0; 1]%Z 1 2 1) a /\ forall l1 l2, has_gram2 (Gram2 1 1 0) l1 l2 ->
  exists n P, edge_to_edge_tiling l1 l2 1 (domain2 l1 l2 1 [origin2; Point2 0 a]) n P /\ weakly_delaunay2 l1 l2 1 n P.
Proof. acutile strip. Qed.

(* region-tetrahedron.json *)
Definition region := hex "
  857361637574696c652d6365727469666963617465026674696c696e6785036151838302010182020181028266726567696f6e00857366616365
  2d746f2d666163652074696c696e6765616375746584766c61726765737420646968656472616c20616e676c65676d6178696d756d0182010984
  77736d616c6c65737420646968656472616c20616e676c65676d696e696d756d0182010983781973717561726564207261646975732d65646765
  20726174696f676d6178696d756d8203088401848300000083010000830001008300000184830102038300030283000103830002018184000102
  03".
Theorem one_tetrahedron : forall l1 l2 l3, has_gram (Gram 2 2 2 1 1 1) l1 l2 l3 ->
  exists n P f, face_to_face_region l1 l2 l3 0 n P f /\ acute l1 l2 l3 0 n P.
Proof. acutile region. Qed.
Definition claimed : claim := OfTiling (TilingClaim 3 Rationals
  [[Plain [2%Z]; Plain [1%Z]; Plain [1%Z]]; [Plain [2%Z]; Plain [1%Z]]; [Plain [2%Z]]] (Region 0)
  [FaceToFaceTiling; IsAcute; LargestAngle Maximum 1 (Plain [1%Z]) 9; SmallestAngle Minimum 1 (Plain [1%Z]) 9; SquaredRatio Maximum (Plain [3%Z]) 8]).
Theorem one_meaning : meaning claimed.
Proof. acutile region. Qed.
Theorem one_certificate : exists c, region = print c /\ claim_of c = claimed /\ shows c /\ meaning claimed.
Proof. acutile region. Qed.
(* certificates/goldberg-1-all.json, a family. Below: an end that is open, and another Gram matrix. *)
Definition goldberg := hex "
  857361637574696c652d6365727469666963617465026666616d696c79860361518183617382646f70656e82000182646f70656e820101
  838381820200828202008222018282020082220182818202008282020082220181818202006573706163658173666163652d746f2d6661
  63652074696c696e6785018183808080808086840084000100008400010100840001010184008400000100840000010184000101018400
  84000000018400010001840001010184008400010000840001010184000100018400840000000184000101018400000101840084000001
0084000101018400010100".
Theorem goldberg_all : forall s, 0 < s < 1 -> forall l1 l2 l3, has_gram (Gram 2 2 2 (2 - 3 * s) (2 - 3 * s) (2 - 3 * s)) l1 l2 l3 ->
  exists n P, face_to_face_tiling l1 l2 l3 3 (domain l1 l2 l3 3 nil) n P.
Proof. intros s Hs. acutile goldberg at (s :: nil). Qed.
Theorem goldberg_half : exists l1 l2 l3, has_gram (Gram 2 2 2 (1 / 2) (1 / 2) (1 / 2)) l1 l2 l3 /\
  exists n P, face_to_face_tiling l1 l2 l3 3 (domain l1 l2 l3 3 nil) n P.
Proof. acutile goldberg at (1 / 2 :: nil). Qed.
Theorem goldberg_wrong : True.
Proof.
  assert (forall s, 0 <= s < 1 -> forall l1 l2 l3, has_gram (Gram 2 2 2 (2 - 3 * s) (2 - 3 * s) (2 - 3 * s)) l1 l2 l3 ->
    exists n P, face_to_face_tiling l1 l2 l3 3 (domain l1 l2 l3 3 nil) n P).
  { intros s Hs. Fail acutile goldberg at (s :: nil). admit. }
  assert (forall s, 0 < s < 1 -> forall l1 l2 l3, has_gram (Gram 2 2 2 (2 - 3 * s) (2 - 3 * s) (2 - 2 * s)) l1 l2 l3 ->
    exists n P, face_to_face_tiling l1 l2 l3 3 (domain l1 l2 l3 3 nil) n P).
  { intros s Hs. Fail acutile goldberg at (s :: nil). Fail acutile goldberg. admit. }
Abort.

Definition all := (goldberg_all, goldberg_half, bcc_for_all, bcc_exists, half_square, strip_over_a_field, one_tetrahedron, one_meaning, one_certificate).
Set Printing All.
Print Assumptions all.
