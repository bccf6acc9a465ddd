(** * The theorem on regions, over the integers and over Z[a]; examples by computation *)
Require Import Reals NArith ZArith List Bool.
From Acutile Require Import Statement Tetrahedra Degree Domain Checker Soundness PlaneStatement PlaneChecker PlaneSoundness RegionStatement PlaneRegionStatement RegionChecker RegionTheorem PlaneRegionChecker PlaneRegionTheorem Numbers.
Import ListNotations.

(** ** The integers *)
Definition zpart (den x : Z) : Z := Z.div x den.
Definition zcheck_region (c : cert Z) (ss : list (rstatement Z)) : bool :=
  check_region_with Z Z.add Z.sub Z.mul idZ Z.ltb Z.leb zpart c ss.
Theorem z_region_theorem c ss : zcheck_region c ss = true ->
  region_meaning (dgram Z IZR c) (c_rank Z c) (length (c_tets Z c)) (dtet Z idZ IZR c) (listed_facets Z c) (map (rdstatement Z IZR) ss).
Proof.
  apply (check_region_sound Z Z.add Z.sub Z.mul idZ Z.ltb Z.leb zpart IZR plus_IZR minus_IZR mult_IZR (fun _ => eq_refl) zltb_ok zleb_ok c ss).
Qed.

Definition zcheck_region2 (c : cert2 Z) (ss : list (rstatement Z)) : bool :=
  check_region2_with Z Z.add Z.sub Z.mul idZ Z.ltb Z.leb zpart c ss.
Theorem z_region_theorem2 c ss : zcheck_region2 c ss = true ->
  region_meaning2 (dgram2 Z IZR c) (e_rank Z c) (length (e_tris Z c)) (dtriangle Z idZ IZR c) (listed_sides Z c) (map (rdstatement Z IZR) ss).
Proof.
  apply (check_region2_sound Z Z.add Z.sub Z.mul idZ Z.ltb Z.leb zpart IZR plus_IZR minus_IZR mult_IZR (fun _ => eq_refl) zltb_ok zleb_ok c ss).
Qed.

(** ** Z[a], for the root a of a monic polynomial in an interval, as in Numbers.v *)
Section NF.
Variables (fl : list Z) (e0 : encl) (es : list encl) (claimed : encl).
(** The integral part by the finest enclosure of a. *)
Definition nfpart (den : Z) (x : list Z) : Z := let '(l, _, P) := lint (e_lo e0) (e_hi e0) (e_S e0) x in Z.div l (P * den).
Definition nfcheck_region (c : cert (list Z)) (ss : list (rstatement (list Z))) : bool :=
  check_region_with (list Z) ladd lsub (lmul fl) lofZ (lltb e0 es) (lleb e0 es) nfpart c ss.
Theorem nf_region_theorem c ss : isolated fl e0 es claimed = true -> nfcheck_region c ss = true ->
  exists al, ev al (fl ++ [1%Z]) = 0%R /\ in_claimed claimed al /\
  (forall x, ev x (fl ++ [1%Z]) = 0%R -> in_claimed claimed x -> x = al) /\
  region_meaning (dgram (list Z) (ev al) c) (c_rank _ c) (length (c_tets _ c)) (dtet (list Z) lofZ (ev al) c) (listed_facets _ c) (map (rdstatement (list Z) (ev al)) ss).
Proof.
  intros HI H. destruct (isolated_root fl e0 es claimed HI) as [al [A1 [A2 [A3 A4]]]]. exists al. split; auto. split; auto. split; auto.
  apply (check_region_sound (list Z) ladd lsub (lmul fl) lofZ (lltb e0 es) (lleb e0 es) nfpart (ev al) (ev_add al) (ev_sub al) (ev_mul fl al A1) (ev_ofZ al)
    (lltb_ok e0 es al A4) (lleb_ok e0 es al A4) c ss H).
Qed.
Definition nfcheck_region2 (c : cert2 (list Z)) (ss : list (rstatement (list Z))) : bool :=
  check_region2_with (list Z) ladd lsub (lmul fl) lofZ (lltb e0 es) (lleb e0 es) nfpart c ss.
Theorem nf_region_theorem2 c ss : isolated fl e0 es claimed = true -> nfcheck_region2 c ss = true ->
  exists al, ev al (fl ++ [1%Z]) = 0%R /\ in_claimed claimed al /\
  (forall x, ev x (fl ++ [1%Z]) = 0%R -> in_claimed claimed x -> x = al) /\
  region_meaning2 (dgram2 (list Z) (ev al) c) (e_rank _ c) (length (e_tris _ c)) (dtriangle (list Z) lofZ (ev al) c) (listed_sides _ c) (map (rdstatement (list Z) (ev al)) ss).
Proof.
  intros HI H. destruct (isolated_root fl e0 es claimed HI) as [al [A1 [A2 [A3 A4]]]]. exists al. split; auto. split; auto. split; auto.
  apply (check_region2_sound (list Z) ladd lsub (lmul fl) lofZ (lltb e0 es) (lleb e0 es) nfpart (ev al) (ev_add al) (ev_sub al) (ev_mul fl al A1) (ev_ofZ al)
    (lltb_ok e0 es al A4) (lleb_ok e0 es al A4) c ss H).
Qed.
End NF.

(** ** Examples: regions of rank 0 and 1 *)
Section Examples.
Let G := (KG Z 1 1 1 0 0 0)%Z.
Let V (l : list Z3) := map (fun p => let '(x, y, z) := p in V3 Z x y z) l.
Let cube := V [(0,0,0); (1,0,0); (0,1,0); (1,1,0); (0,0,1); (1,0,1); (0,1,1); (1,1,1)]%Z.
Fixpoint numbered {X} (k : nat) (l : list X) : list (nat * X) := match l with [] => [] | x :: l => (k, x) :: numbered (S k) l end.
(** Mates by search among the translates by at most one along the first axis. *)
Definition with_mates (ds : list Z3) (ts : list (list corner)) : list ctet :=
  let plain q := CT (nth 0 q (0%N, z30)) (nth 1 q (0%N, z30)) (nth 2 q (0%N, z30)) (nth 3 q (0%N, z30)) None None None None in
  let ps := map plain ts in
  let all := list_prod (numbered 0 ps) (list_prod I4 ds) in
  let mate t i := option_map (fun x => let '((k, _), (j, d)) := x in (N.of_nat k, N.of_nat j, d))
    (find (fun x => let '((_, t'), (j, d)) := x in codd d (cfc t i) (cfc t' j)) all) in
  map (fun t => CT (q0 t) (q1 t) (q2 t) (q3 t) (mate t 0%nat) (mate t 1%nat) (mate t 2%nat) (mate t 3%nat)) ps.
Definition at_zero (l : list N) : list corner := map at0 l.
Definition example (den : Z) (vs : list (v3 Z)) (r : nat) (ds : list Z3) (ts : list (list corner)) : cert Z :=
  Cert Z den vs (with_mates ds ts) G r [] [] [].
Definition kuhn := [[0;1;3;7]; [0;2;6;7]; [0;4;5;7]; [0;1;7;5]; [0;2;7;3]; [0;4;7;6]]%N.
Definition zregion c := check_region Z Z.add Z.sub Z.mul idZ Z.ltb Z.leb zpart c.

(** A cube of six tetrahedra. *)
Example cube_of_six : zcheck_region (example 1 cube 0 [z30] (map at_zero kuhn)) [Each Z (CNonobtuse Z)] = true.
Proof. vm_compute. reflexivity. Qed.
Example boundary_of_six : length (listed_facets Z (example 1 cube 0 [z30] (map at_zero kuhn))) = 12%nat.
Proof. vm_compute. reflexivity. Qed.
Example six_not_acute : zcheck_region (example 1 cube 0 [z30] (map at_zero kuhn)) [Each Z (CAcute Z)] = false.
Proof. vm_compute. reflexivity. Qed.
(** Without one of the six it is a region, too. *)
Example five_of_six : zregion (example 1 cube 0 [z30] (map at_zero (tl kuhn))) = true.
Proof. vm_compute. reflexivity. Qed.
(** Two that share a facet; two that overlap, with the same facet. *)
Let two := V [(0,0,0); (1,0,0); (0,1,0); (0,0,1); (0,0,-1); (0,0,2)]%Z.
Example shared_facet : zregion (example 1 two 0 [z30] (map at_zero [[0;1;2;3]; [0;1;4;2]]%N)) = true.
Proof. vm_compute. reflexivity. Qed.
Example overlap : zregion (example 1 two 0 [z30] (map at_zero [[0;1;2;3]; [0;1;2;5]]%N)) = false.
Proof. vm_compute. reflexivity. Qed.
(** The same tetrahedron twice; nested tetrahedra; none. *)
Example twice_the_same : zregion (example 1 two 0 [z30] (map at_zero [[0;1;2;3]; [0;1;2;3]]%N)) = false.
Proof. vm_compute. reflexivity. Qed.
Example nested : zregion (example 1 (V [(0,0,0); (9,0,0); (0,9,0); (0,0,9); (1,1,1); (2,1,1); (1,2,1); (1,1,2)]%Z) 0 [z30] (map at_zero [[0;1;2;3]; [4;5;6;7]]%N)) = false.
Proof. vm_compute. reflexivity. Qed.
Example no_tetrahedron : zregion (example 1 two 0 [z30] []) = false.
Proof. vm_compute. reflexivity. Qed.
(** Rank 1: a tetrahedron of width 1/2 along the first axis, and one of width 3/2, which meets its translate. *)
Example row_apart : zregion (example 2 (V [(0,0,0); (1,0,0); (0,1,0); (0,0,1)]%Z) 1 [z30; (1,0,0)%Z; (-1,0,0)%Z] (map at_zero [[0;1;2;3]]%N)) = true.
Proof. vm_compute. reflexivity. Qed.
Example row_overlaps : zregion (example 2 (V [(0,0,0); (3,0,0); (0,1,0); (0,0,1)]%Z) 1 [z30; (1,0,0)%Z; (-1,0,0)%Z] (map at_zero [[0;1;2;3]]%N)) = false.
Proof. vm_compute. reflexivity. Qed.
End Examples.
