(** * The theorem on regions, over the integers and over Z[a]; examples by computation *)
Require Import Reals NArith ZArith List Bool.
From Acutile Require Import Statement Tetrahedra Degree Domain Checker Soundness RegionStatement RegionChecker RegionTheorem Numbers.
Import ListNotations.

(** A claim about a region, in the words of Statement.v and RegionStatement.v. *)
Definition region_meaning (G : gram) (r N : nat) (P : point -> point -> point -> nat -> tetrahedron) (listed : list (nat * nat)) (ss : list statement) : Prop :=
  (exists l1 l2 l3, has_gram G l1 l2 l3) /\
  forall l1 l2 l3, has_gram G l1 l2 l3 -> face_to_face_region l1 l2 l3 r N (P l1 l2 l3) listed /\
    forall s, In s ss -> holds l1 l2 l3 r N (P l1 l2 l3) s.

(** ** The integers *)
Definition zpart (den x : Z) : Z := Z.div x den.
Definition zcheck_region (c : cert Z) (ss : list (cstatement Z)) : bool :=
  check_region Z Z.add Z.sub Z.mul idZ Z.ltb Z.leb zpart c &&
  forallb (check_region_statement Z Z.add Z.sub Z.mul idZ Z.ltb Z.leb c) ss.
Theorem z_region_theorem c ss : zcheck_region c ss = true ->
  region_meaning (dgram Z IZR c) (c_rank Z c) (length (c_tets Z c)) (dtet Z idZ IZR c) (listed_facets Z c) (map (dstatement Z IZR) ss).
Proof.
  unfold zcheck_region. rewrite andb_true_iff, forallb_forall. intros [H1 H2]. split.
  - apply (region_basis_exists Z Z.add Z.sub Z.mul idZ Z.ltb Z.leb zpart IZR plus_IZR minus_IZR mult_IZR (fun _ => eq_refl) zltb_ok c H1).
  - intros l1 l2 l3 HG. split.
    + apply (region_sound Z Z.add Z.sub Z.mul idZ Z.ltb Z.leb zpart IZR plus_IZR minus_IZR mult_IZR (fun _ => eq_refl) zltb_ok zleb_ok c H1 l1 l2 l3 HG).
    + intros s Hs. apply in_map_iff in Hs as [st [<- Hs]].
      apply (region_statement_sound Z Z.add Z.sub Z.mul idZ Z.ltb Z.leb zpart IZR plus_IZR minus_IZR mult_IZR (fun _ => eq_refl) zltb_ok zleb_ok c H1 l1 l2 l3 HG). auto.
Qed.

(** ** Z[a], for the root a of a monic polynomial in an interval, as in Numbers.v *)
Section NF.
Variables (fl : list Z) (e0 : encl) (es : list encl) (claimed : encl).
(** The integral part by the finest enclosure of a. *)
Definition nfpart (den : Z) (x : list Z) : Z := let '(l, _, P) := lint (e_lo e0) (e_hi e0) (e_S e0) x in Z.div l (P * den).
Definition nfcheck_region (c : cert (list Z)) (ss : list (cstatement (list Z))) : bool :=
  check_region (list Z) ladd lsub (lmul fl) lofZ (lltb e0 es) (lleb e0 es) nfpart c &&
  forallb (check_region_statement (list Z) ladd lsub (lmul fl) lofZ (lltb e0 es) (lleb e0 es) c) ss.
Theorem nf_region_theorem c ss : isolated fl e0 es claimed = true -> nfcheck_region c ss = true ->
  exists al, ev al (fl ++ [1%Z]) = 0%R /\ in_claimed claimed al /\
  (forall x, ev x (fl ++ [1%Z]) = 0%R -> in_claimed claimed x -> x = al) /\
  region_meaning (dgram (list Z) (ev al) c) (c_rank _ c) (length (c_tets _ c)) (dtet (list Z) lofZ (ev al) c) (listed_facets _ c) (map (dstatement (list Z) (ev al)) ss).
Proof.
  intros HI H. destruct (isolated_root fl e0 es claimed HI) as [al [A1 [A2 [A3 A4]]]]. exists al. split; auto. split; auto. split; auto.
  unfold nfcheck_region in H. rewrite andb_true_iff, forallb_forall in H. destruct H as [H1 H2].
  pose proof (ev_add al) as EA. pose proof (ev_sub al) as ES. pose proof (ev_mul fl al A1) as EM. pose proof (ev_ofZ al) as EZ.
  pose proof (lltb_ok e0 es al A4) as LT. pose proof (lleb_ok e0 es al A4) as LE. split.
  - apply (region_basis_exists (list Z) ladd lsub (lmul fl) lofZ (lltb e0 es) (lleb e0 es) nfpart (ev al) EA ES EM EZ LT c H1).
  - intros l1 l2 l3 HG. split.
    + apply (region_sound (list Z) ladd lsub (lmul fl) lofZ (lltb e0 es) (lleb e0 es) nfpart (ev al) EA ES EM EZ LT LE c H1 l1 l2 l3 HG).
    + intros s Hs. apply in_map_iff in Hs as [st [<- Hs]].
      apply (region_statement_sound (list Z) ladd lsub (lmul fl) lofZ (lltb e0 es) (lleb e0 es) nfpart (ev al) EA ES EM EZ LT LE c H1 l1 l2 l3 HG). auto.
Qed.
End NF.

(** ** Examples: regions of rank 0 and 1 *)
Section Examples.
Let G := (KG Z 1 1 1 0 0 0)%Z.
Let V (l : list Z3) := map (fun p => let '(x, y, z) := p in V3 Z x y z) l.
Let cube := V [(0,0,0); (1,0,0); (0,1,0); (1,1,0); (0,0,1); (1,0,1); (0,1,1); (1,1,1)]%Z.
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
Example cube_of_six : zcheck_region (example 1 cube 0 [z30] (map at_zero kuhn)) [CNonobtuse Z] = true.
Proof. vm_compute. reflexivity. Qed.
Example boundary_of_six : length (listed_facets Z (example 1 cube 0 [z30] (map at_zero kuhn))) = 12%nat.
Proof. vm_compute. reflexivity. Qed.
Example six_not_acute : zcheck_region (example 1 cube 0 [z30] (map at_zero kuhn)) [CAcute Z] = false.
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
