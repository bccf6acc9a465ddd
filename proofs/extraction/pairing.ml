(* Hints for the extracted checker, and what it does not ask for.

   Nothing here is trusted: the checker checks every mate, and [valences] only refuses.
   A corner is (vertex, shift). A face is named by its sorted corners, moved so that the
   first one has the shift zero: translates have one name. *)

let minus (x, y, z) (x', y', z') = (x - x', y - y', z - z')

let name corners =
  match List.sort compare corners with
  | [] -> ([], (0, 0, 0))
  | (_, s) :: _ as sorted -> (List.map (fun (v, t) -> (v, minus t s)) sorted, s)

let without i l = List.filteri (fun k _ -> k <> i) l

(* The mate of each facet: (row, facet, shift) if another facet has its name. The second
   facet with a name closes the first; a third one would be open again. *)
let mates rows =
  let found = Array.map (fun corners -> Array.make (List.length corners) None) rows in
  let opened = Hashtbl.create (4 * Array.length rows) in
  Array.iteri (fun k corners ->
    List.iteri (fun i _ ->
      let key, s = name (without i corners) in
      match Hashtbl.find_opt opened key with
      | None -> Hashtbl.add opened key (k, i, s)
      | Some (k', i', s') ->
        Hashtbl.remove opened key;
        found.(k).(i) <- Some (k', i', minus s s');
        found.(k').(i') <- Some (k, i, minus s' s)) corners) rows;
  Array.map Array.to_list found

(* Whether the bits of every row say which of its edges have valence 6. *)
let edges = [(0, 1); (0, 2); (0, 3); (1, 2); (1, 3); (2, 3)]
let valences rows sixes =
  let count = Hashtbl.create (2 * Array.length rows) in
  let names corners =
    let sorted = List.sort compare corners in
    List.map (fun (i, j) -> fst (name [List.nth sorted i; List.nth sorted j])) edges in
  let found key = match Hashtbl.find_opt count key with Some n -> n | None -> 0 in
  let all = Array.map names rows in
  Array.iter (List.iter (fun key -> Hashtbl.replace count key (found key + 1))) all;
  let agree keys bits = List.for_all (fun b -> b) (List.mapi (fun p key -> (bits lsr p) land 1 = 1 = (found key = 6)) keys) in
  Array.for_all (fun b -> b) (Array.map2 agree all sixes)
