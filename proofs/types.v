(* The types of the main theorems, written out: check.sh compiles this file.  It fails if a
   theorem says something else.  The words are those of Statement.v, PlaneStatement.v and
   Denote.v, whose SHA-256 are pinned in statements.sha256. *)
From Coq Require Import Reals ZArith List.
From Acutile Require Import Statement PlaneStatement Checker PlaneChecker Soundness PlaneSoundness Numbers Denote Bytes.
Import ListNotations.

(* The bytes of a certificate: Bytes.v. *)
Check (Acutile.Bytes.accepted : forall (s : list Coq.Init.Byte.byte) (k : Acutile.Denote.claim), accepts s = Some k ->
  exists c : Acutile.Denote.certificate, s = Acutile.Denote.print c /\ Acutile.Denote.claim_of c = k /\
    Acutile.Denote.shows c /\ Acutile.Denote.meaning k).
Check (Acutile.Bytes.bytes_theorem : forall (s : list Coq.Init.Byte.byte) (k : Acutile.Denote.claim), accepts s = Some k ->
  exists c : Acutile.Denote.certificate, s = Acutile.Denote.print c /\ Acutile.Denote.claim_of c = k /\ Acutile.Denote.meaning k).

(* The data of the checker: Numbers.v. *)
Check (Acutile.Numbers.z_theorem : forall c ss, zcheck c ss = true ->
  (exists l1 l2 l3, has_gram (dgram Z IZR c) l1 l2 l3) /\
  forall l1 l2 l3, has_gram (dgram Z IZR c) l1 l2 l3 ->
  face_to_face_tiling l1 l2 l3 (c_rank Z c) (ddomain Z IZR c l1 l2 l3) (length (c_tets Z c)) (dtet Z idZ IZR c l1 l2 l3) /\
  forall s, In s (map (dstatement Z IZR) ss) -> holds l1 l2 l3 (c_rank Z c) (length (c_tets Z c)) (dtet Z idZ IZR c l1 l2 l3) s).
Check (Acutile.Numbers.z_theorem2 : forall c ss, zcheck2 c ss = true ->
  (exists l1 l2, has_gram2 (dgram2 Z IZR c) l1 l2) /\
  forall l1 l2, has_gram2 (dgram2 Z IZR c) l1 l2 ->
  edge_to_edge_tiling l1 l2 (e_rank Z c) (ddomain2 Z IZR c l1 l2) (length (e_tris Z c)) (dtriangle Z idZ IZR c l1 l2) /\
  forall s, In s (map (dstatement Z IZR) ss) -> holds2 l1 l2 (e_rank Z c) (length (e_tris Z c)) (dtriangle Z idZ IZR c l1 l2) s).
Check (Acutile.Numbers.nf_theorem : forall fl e0 es claimed c ss, isolated fl e0 es claimed = true -> nfcheck fl e0 es c ss = true ->
  exists al, ev al (fl ++ [1%Z]) = 0%R /\ in_claimed claimed al /\
    (forall x, ev x (fl ++ [1%Z]) = 0%R -> in_claimed claimed x -> x = al) /\
  (exists l1 l2 l3, has_gram (dgram (list Z) (ev al) c) l1 l2 l3) /\
  forall l1 l2 l3, has_gram (dgram (list Z) (ev al) c) l1 l2 l3 ->
  face_to_face_tiling l1 l2 l3 (c_rank _ c) (ddomain (list Z) (ev al) c l1 l2 l3) (length (c_tets _ c)) (dtet (list Z) lofZ (ev al) c l1 l2 l3) /\
  forall s, In s (map (dstatement (list Z) (ev al)) ss) -> holds l1 l2 l3 (c_rank _ c) (length (c_tets _ c)) (dtet (list Z) lofZ (ev al) c l1 l2 l3) s).
Check (Acutile.Numbers.nf_theorem2 : forall fl e0 es claimed c ss, isolated fl e0 es claimed = true -> nfcheck2 fl e0 es c ss = true ->
  exists al, ev al (fl ++ [1%Z]) = 0%R /\ in_claimed claimed al /\
    (forall x, ev x (fl ++ [1%Z]) = 0%R -> in_claimed claimed x -> x = al) /\
  (exists l1 l2, has_gram2 (dgram2 (list Z) (ev al) c) l1 l2) /\
  forall l1 l2, has_gram2 (dgram2 (list Z) (ev al) c) l1 l2 ->
  edge_to_edge_tiling l1 l2 (e_rank _ c) (ddomain2 (list Z) (ev al) c l1 l2) (length (e_tris _ c)) (dtriangle (list Z) lofZ (ev al) c l1 l2) /\
  forall s, In s (map (dstatement (list Z) (ev al)) ss) -> holds2 l1 l2 (e_rank _ c) (length (e_tris _ c)) (dtriangle (list Z) lofZ (ev al) c l1 l2) s).
