(** * The claim file of a claim (docs/format.md): canonical JSON, for people

    No theorem is about this file.  Whoever reads the claim that the extracted program
    prints, trusts it; an exported theorem has the claim itself. *)
From Coq Require Import NArith ZArith List Bool String DecimalString.
From Acutile Require Import Statement Denote.
Import ListNotations.
Local Open Scope string_scope.

Inductive json := JItem (i : item) | JArray (l : list json) | JObject (l : list (string * json)).

Definition quote : string := String (Ascii.ascii_of_N 34) "".
Definition quoted (s : string) : string := quote ++ s ++ quote.
Definition line_feed : string := String (Ascii.ascii_of_N 10) "".
Definition digits (z : Z) : string := NilZero.string_of_int (Z.to_int z).
Definition integer_text (z : Z) : string := if Z.ltb (Z.abs z) (2 ^ 53) then digits z else quoted (digits z).
(** The items of the outer three levels stand on their own lines. *)
Definition line (depth : nat) : string := if Nat.leb depth 3 then line_feed else "".
Definition enclosed (opening closing : string) (depth : nat) (l : list string) : string :=
  match l with [] => opening ++ closing | _ => opening ++ line depth ++ concat ("," ++ line depth) l ++ line depth ++ closing end.
Fixpoint item_text (depth : nat) (i : item) : string :=
  match i with
  | Int z => integer_text z
  | Text s => quoted s
  | Array l => enclosed "[" "]" depth (map (item_text (S depth)) l)
  end.
Fixpoint json_text (depth : nat) (j : json) : string :=
  match j with
  | JItem i => item_text depth i
  | JArray l => enclosed "[" "]" depth (map (json_text (S depth)) l)
  | JObject l => enclosed "{" "}" depth (map (fun m => quoted (fst m) ++ ":" ++ json_text (S depth) (snd m)) l)
  end.

Definition field_json (f : field) : json :=
  match f with
  | Rationals => JItem (Text "Q")
  | Root p lo hi d =>
    JObject [("polynomial", JItem (Array (map Int p)));
      ("root", JObject [("low", JItem (Int lo)); ("high", JItem (Int hi)); ("denominator", JItem (Int d))])]
  end.
Definition polytope_json (f : field) (P : polytope) : json :=
  JObject [("denominator", JItem (Int (p_denominator P))); ("vertices", JItem (points_item f (p_vertices P)));
    ("faces", JItem (Array (map (fun l => Array (map index_item l)) (p_faces P))))].
Definition region_json (f : field) (d : region) : json :=
  match d with
  | Slab P => JArray [JItem (Text "slab"); polytope_json f P]
  | Prism P => JArray [JItem (Text "prism"); polytope_json f P]
  | Solid P => JArray [JItem (Text "solid"); polytope_json f P]
  | Space | Region _ => JItem (region_item f d)
  end.
Definition claim_json (k : tiling_claim) (parameters : list (string * json)) : json :=
  let f := over k in
  JObject (("dimension", JItem (Int (Z.of_nat (dimension k)))) :: ("field", field_json f) :: (parameters ++ [("gram", JItem (points_item f (gram_rows k)));
    ("domain", region_json f (region_of k)); ("statements", JItem (Array (map (sentence_item f) (sentences k))))])%list).
Definition parameter_json (f : field) (p : parameter) : json :=
  JObject [("name", JItem (Text (p_name p))); ("low", JItem (limit_item f (p_low p))); ("high", JItem (limit_item f (p_high p)))].
Definition polygon_json (f : field) (T : polygon) : json :=
  JObject [("denominator", JItem (Int (t_denominator T))); ("vertices", JItem (points_item f (t_vertices T)));
    ("classes", JItem (Array (map Int (t_classes T))))].
Definition patches_json (k : patches_claim) : json :=
  let f := base_field k in
  JObject [("field", field_json f); ("gram", JItem (points_item f (base_gram k))); ("rank", JItem (Int (Z.of_nat (fibre_rank k))));
    ("tiles", JArray (map (polygon_json f) (polygons k))); ("statements", JItem (Array (map (sentence_item f) (patch_sentences k))))].
Definition kind_text (kind : string) (k : json) : string :=
  json_text 1 (JObject [("format", JItem (Text "acutile-claim")); ("version", JItem (Int 2)); ("kind", JItem (Text kind)); ("claim", k)]) ++ line_feed.
Definition claim_text (k : claim) : string :=
  match k with
  | OfTiling k => kind_text "tiling" (claim_json k [])
  | OfFamily ps k => kind_text "family" (claim_json k [("parameters", JArray (map (parameter_json (over k)) ps))])
  | OfPatches k => kind_text "patches" (patches_json k)
  end.
