(* The types of the main theorems, written out: check.sh compiles this file.  It fails if a
   theorem says something else.  Only Coq's library and the pinned files of statements.sha256
   are imported.  All other files come without their short names and their notations, so
   none of them can change how this text is read.  The main theorem is written out even
   before they are loaded. *)
From Coq Require Import Reals ZArith List.
From Acutile Require Statement PlaneStatement RegionStatement PlaneRegionStatement MosaicStatement Denote.
Import ListNotations.

(* The bytes of a certificate: Bytes.v. *)
Definition accepted_says (accepts : list Coq.Init.Byte.byte -> option Acutile.Denote.claim) : Prop :=
  forall (s : list Coq.Init.Byte.byte) (k : Acutile.Denote.claim), accepts s = Some k ->
  exists c : Acutile.Denote.certificate, s = Acutile.Denote.print c /\ Acutile.Denote.claim_of c = k /\
    Acutile.Denote.shows c /\ Acutile.Denote.meaning k.
Definition bytes_theorem_says (accepts : list Coq.Init.Byte.byte -> option Acutile.Denote.claim) : Prop :=
  forall (s : list Coq.Init.Byte.byte) (k : Acutile.Denote.claim), accepts s = Some k ->
  exists c : Acutile.Denote.certificate, s = Acutile.Denote.print c /\ Acutile.Denote.claim_of c = k /\ Acutile.Denote.meaning k.

From Acutile Require Checker PlaneChecker Soundness PlaneSoundness Numbers.
From Acutile Require RegionChecker RegionTheorem PlaneRegionChecker RegionNumbers Format Bytes.
Check (Acutile.Bytes.accepted : accepted_says Acutile.Bytes.accepts).
Check (Acutile.Bytes.bytes_theorem : bytes_theorem_says Acutile.Bytes.accepts).
(* The extracted function is [judge]; the theorems are about its acceptance. *)
Check (eq_refl : Acutile.Bytes.accepts =
  fun s => match Acutile.Bytes.judge s with Acutile.Format.Accepted k => Some k | Acutile.Format.Refused _ => None end).

(* The data of the checker: Numbers.v. *)
Check (Acutile.Numbers.z_theorem : forall c ss, Acutile.Numbers.zcheck c ss = true ->
  (exists l1 l2 l3, Acutile.Statement.has_gram (Acutile.Soundness.dgram Z IZR c) l1 l2 l3) /\
  forall l1 l2 l3, Acutile.Statement.has_gram (Acutile.Soundness.dgram Z IZR c) l1 l2 l3 ->
  Acutile.Statement.face_to_face_tiling l1 l2 l3 (Acutile.Checker.c_rank Z c) (Acutile.Soundness.ddomain Z IZR c l1 l2 l3) (length (Acutile.Checker.c_tets Z c)) (Acutile.Soundness.dtet Z Acutile.Numbers.idZ IZR c l1 l2 l3) /\
  forall s, In s (map (Acutile.Soundness.dstatement Z IZR) ss) -> Acutile.Statement.holds l1 l2 l3 (Acutile.Checker.c_rank Z c) (length (Acutile.Checker.c_tets Z c)) (Acutile.Soundness.dtet Z Acutile.Numbers.idZ IZR c l1 l2 l3) s).
Check (Acutile.Numbers.z_theorem2 : forall c ss, Acutile.Numbers.zcheck2 c ss = true ->
  (exists l1 l2, Acutile.PlaneStatement.has_gram2 (Acutile.PlaneSoundness.dgram2 Z IZR c) l1 l2) /\
  forall l1 l2, Acutile.PlaneStatement.has_gram2 (Acutile.PlaneSoundness.dgram2 Z IZR c) l1 l2 ->
  Acutile.PlaneStatement.edge_to_edge_tiling l1 l2 (Acutile.PlaneChecker.e_rank Z c) (Acutile.PlaneSoundness.ddomain2 Z IZR c l1 l2) (length (Acutile.PlaneChecker.e_tris Z c)) (Acutile.PlaneSoundness.dtriangle Z Acutile.Numbers.idZ IZR c l1 l2) /\
  forall s, In s (map (Acutile.Soundness.dstatement Z IZR) ss) -> Acutile.PlaneStatement.holds2 l1 l2 (Acutile.PlaneChecker.e_rank Z c) (length (Acutile.PlaneChecker.e_tris Z c)) (Acutile.PlaneSoundness.dtriangle Z Acutile.Numbers.idZ IZR c l1 l2) s).
Check (Acutile.Numbers.nf_theorem : forall fl e0 es claimed c ss, Acutile.Numbers.isolated fl e0 es claimed = true -> Acutile.Numbers.nfcheck fl e0 es c ss = true ->
  exists al, Acutile.Numbers.ev al (fl ++ [1%Z]) = 0%R /\ Acutile.Numbers.in_claimed claimed al /\
    (forall x, Acutile.Numbers.ev x (fl ++ [1%Z]) = 0%R -> Acutile.Numbers.in_claimed claimed x -> x = al) /\
  (exists l1 l2 l3, Acutile.Statement.has_gram (Acutile.Soundness.dgram (list Z) (Acutile.Numbers.ev al) c) l1 l2 l3) /\
  forall l1 l2 l3, Acutile.Statement.has_gram (Acutile.Soundness.dgram (list Z) (Acutile.Numbers.ev al) c) l1 l2 l3 ->
  Acutile.Statement.face_to_face_tiling l1 l2 l3 (Acutile.Checker.c_rank _ c) (Acutile.Soundness.ddomain (list Z) (Acutile.Numbers.ev al) c l1 l2 l3) (length (Acutile.Checker.c_tets _ c)) (Acutile.Soundness.dtet (list Z) Acutile.Numbers.lofZ (Acutile.Numbers.ev al) c l1 l2 l3) /\
  forall s, In s (map (Acutile.Soundness.dstatement (list Z) (Acutile.Numbers.ev al)) ss) -> Acutile.Statement.holds l1 l2 l3 (Acutile.Checker.c_rank _ c) (length (Acutile.Checker.c_tets _ c)) (Acutile.Soundness.dtet (list Z) Acutile.Numbers.lofZ (Acutile.Numbers.ev al) c l1 l2 l3) s).
Check (Acutile.Numbers.nf_theorem2 : forall fl e0 es claimed c ss, Acutile.Numbers.isolated fl e0 es claimed = true -> Acutile.Numbers.nfcheck2 fl e0 es c ss = true ->
  exists al, Acutile.Numbers.ev al (fl ++ [1%Z]) = 0%R /\ Acutile.Numbers.in_claimed claimed al /\
    (forall x, Acutile.Numbers.ev x (fl ++ [1%Z]) = 0%R -> Acutile.Numbers.in_claimed claimed x -> x = al) /\
  (exists l1 l2, Acutile.PlaneStatement.has_gram2 (Acutile.PlaneSoundness.dgram2 (list Z) (Acutile.Numbers.ev al) c) l1 l2) /\
  forall l1 l2, Acutile.PlaneStatement.has_gram2 (Acutile.PlaneSoundness.dgram2 (list Z) (Acutile.Numbers.ev al) c) l1 l2 ->
  Acutile.PlaneStatement.edge_to_edge_tiling l1 l2 (Acutile.PlaneChecker.e_rank _ c) (Acutile.PlaneSoundness.ddomain2 (list Z) (Acutile.Numbers.ev al) c l1 l2) (length (Acutile.PlaneChecker.e_tris _ c)) (Acutile.PlaneSoundness.dtriangle (list Z) Acutile.Numbers.lofZ (Acutile.Numbers.ev al) c l1 l2) /\
  forall s, In s (map (Acutile.Soundness.dstatement (list Z) (Acutile.Numbers.ev al)) ss) -> Acutile.PlaneStatement.holds2 l1 l2 (Acutile.PlaneChecker.e_rank _ c) (length (Acutile.PlaneChecker.e_tris _ c)) (Acutile.PlaneSoundness.dtriangle (list Z) Acutile.Numbers.lofZ (Acutile.Numbers.ev al) c l1 l2) s).

(* The same for regions: RegionNumbers.v. *)
Check (Acutile.RegionNumbers.z_region_theorem : forall c ss, Acutile.RegionNumbers.zcheck_region c ss = true ->
  (exists l1 l2 l3, Acutile.Statement.has_gram (Acutile.Soundness.dgram Z IZR c) l1 l2 l3) /\
  forall l1 l2 l3, Acutile.Statement.has_gram (Acutile.Soundness.dgram Z IZR c) l1 l2 l3 ->
  Acutile.RegionStatement.face_to_face_region l1 l2 l3 (Acutile.Checker.c_rank Z c) (length (Acutile.Checker.c_tets Z c)) (Acutile.Soundness.dtet Z Acutile.Numbers.idZ IZR c l1 l2 l3) (Acutile.RegionChecker.listed_facets Z c) /\
  forall s, In s (map (Acutile.RegionTheorem.rdstatement Z IZR) ss) -> Acutile.RegionStatement.holds_in_region l1 l2 l3 (Acutile.Checker.c_rank Z c) (length (Acutile.Checker.c_tets Z c)) (Acutile.Soundness.dtet Z Acutile.Numbers.idZ IZR c l1 l2 l3) s).
Check (Acutile.RegionNumbers.z_region_theorem2 : forall c ss, Acutile.RegionNumbers.zcheck_region2 c ss = true ->
  (exists l1 l2, Acutile.PlaneStatement.has_gram2 (Acutile.PlaneSoundness.dgram2 Z IZR c) l1 l2) /\
  forall l1 l2, Acutile.PlaneStatement.has_gram2 (Acutile.PlaneSoundness.dgram2 Z IZR c) l1 l2 ->
  Acutile.PlaneRegionStatement.edge_to_edge_region l1 l2 (Acutile.PlaneChecker.e_rank Z c) (length (Acutile.PlaneChecker.e_tris Z c)) (Acutile.PlaneSoundness.dtriangle Z Acutile.Numbers.idZ IZR c l1 l2) (Acutile.PlaneRegionChecker.listed_sides Z c) /\
  forall s, In s (map (Acutile.RegionTheorem.rdstatement Z IZR) ss) -> Acutile.PlaneRegionStatement.holds_in_region2 l1 l2 (Acutile.PlaneChecker.e_rank Z c) (length (Acutile.PlaneChecker.e_tris Z c)) (Acutile.PlaneSoundness.dtriangle Z Acutile.Numbers.idZ IZR c l1 l2) s).
Check (Acutile.RegionNumbers.nf_region_theorem : forall fl e0 es claimed c ss, Acutile.Numbers.isolated fl e0 es claimed = true -> Acutile.RegionNumbers.nfcheck_region fl e0 es c ss = true ->
  exists al, Acutile.Numbers.ev al (fl ++ [1%Z]) = 0%R /\ Acutile.Numbers.in_claimed claimed al /\
    (forall x, Acutile.Numbers.ev x (fl ++ [1%Z]) = 0%R -> Acutile.Numbers.in_claimed claimed x -> x = al) /\
  (exists l1 l2 l3, Acutile.Statement.has_gram (Acutile.Soundness.dgram (list Z) (Acutile.Numbers.ev al) c) l1 l2 l3) /\
  forall l1 l2 l3, Acutile.Statement.has_gram (Acutile.Soundness.dgram (list Z) (Acutile.Numbers.ev al) c) l1 l2 l3 ->
  Acutile.RegionStatement.face_to_face_region l1 l2 l3 (Acutile.Checker.c_rank _ c) (length (Acutile.Checker.c_tets _ c)) (Acutile.Soundness.dtet (list Z) Acutile.Numbers.lofZ (Acutile.Numbers.ev al) c l1 l2 l3) (Acutile.RegionChecker.listed_facets _ c) /\
  forall s, In s (map (Acutile.RegionTheorem.rdstatement (list Z) (Acutile.Numbers.ev al)) ss) -> Acutile.RegionStatement.holds_in_region l1 l2 l3 (Acutile.Checker.c_rank _ c) (length (Acutile.Checker.c_tets _ c)) (Acutile.Soundness.dtet (list Z) Acutile.Numbers.lofZ (Acutile.Numbers.ev al) c l1 l2 l3) s).
Check (Acutile.RegionNumbers.nf_region_theorem2 : forall fl e0 es claimed c ss, Acutile.Numbers.isolated fl e0 es claimed = true -> Acutile.RegionNumbers.nfcheck_region2 fl e0 es c ss = true ->
  exists al, Acutile.Numbers.ev al (fl ++ [1%Z]) = 0%R /\ Acutile.Numbers.in_claimed claimed al /\
    (forall x, Acutile.Numbers.ev x (fl ++ [1%Z]) = 0%R -> Acutile.Numbers.in_claimed claimed x -> x = al) /\
  (exists l1 l2, Acutile.PlaneStatement.has_gram2 (Acutile.PlaneSoundness.dgram2 (list Z) (Acutile.Numbers.ev al) c) l1 l2) /\
  forall l1 l2, Acutile.PlaneStatement.has_gram2 (Acutile.PlaneSoundness.dgram2 (list Z) (Acutile.Numbers.ev al) c) l1 l2 ->
  Acutile.PlaneRegionStatement.edge_to_edge_region l1 l2 (Acutile.PlaneChecker.e_rank _ c) (length (Acutile.PlaneChecker.e_tris _ c)) (Acutile.PlaneSoundness.dtriangle (list Z) Acutile.Numbers.lofZ (Acutile.Numbers.ev al) c l1 l2) (Acutile.PlaneRegionChecker.listed_sides _ c) /\
  forall s, In s (map (Acutile.RegionTheorem.rdstatement (list Z) (Acutile.Numbers.ev al)) ss) -> Acutile.PlaneRegionStatement.holds_in_region2 l1 l2 (Acutile.PlaneChecker.e_rank _ c) (length (Acutile.PlaneChecker.e_tris _ c)) (Acutile.PlaneSoundness.dtriangle (list Z) Acutile.Numbers.lofZ (Acutile.Numbers.ev al) c l1 l2) s).

(* There are mosaics, so claims about patches are about something: MosaicSanity.v. *)
From Acutile Require MosaicSanity.
Check (Acutile.MosaicSanity.squares_are_a_mosaic : Acutile.MosaicStatement.mosaic (Acutile.Statement.Point 1 0 0) (Acutile.Statement.Point 0 1 0)
  (Acutile.Statement.Point 0 0 1) (Acutile.Statement.Gram 1 1 1 0 0 0) 1 [Acutile.MosaicSanity.square] Acutile.MosaicSanity.squares).
Check (Acutile.MosaicSanity.segments_are_a_mosaic : Acutile.MosaicStatement.mosaic (Acutile.Statement.Point 1 0 0) (Acutile.Statement.Point 0 1 0)
  (Acutile.Statement.Point 0 0 1) (Acutile.Statement.Gram 1 1 1 0 0 0) 2 [Acutile.MosaicSanity.segment] Acutile.MosaicSanity.segments).
