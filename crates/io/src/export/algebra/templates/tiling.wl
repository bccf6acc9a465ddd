(* @NAME@: an exact tiling, written by acutile @VERSION@ for Mathematica.
   Get["FILE.wl"] defines it and checks it. Nothing is rounded.

   Points have coordinates in a basis whose inner products are gram.
   A corner {v, s1, ...} is vertex v, counted from 0, moved by the integers s1, ... along the basis.
   Each simplex stands for its translates by the first @RANK@ basis vectors. Domain: @DOMAIN@. *)
(* Mathics ends an evaluation after 4096 steps, which is too early here. *)
$IterationLimit = 1000000;
@FIELD@
gram = @GRAM@;
vertices = @VERTICES@;
simplices = @SIMPLICES@;
(* The sum of the absolute determinants of all simplices, @D@! times the volume in cells. *)
total = @TOTAL@;
(* The congruence class of each simplex, and for each class the squared edges and the numbers of acute, right
   and obtuse dihedral angles. *)
kinds = @KINDS@;
classes = @CLASSES@;

point[corner_] := vertices[[First[corner] + 1]] + Rest[corner];
edgeMatrix[simplex_] := Map[# - point[First[simplex]] &, Map[point, Rest[simplex]]];
squaredEdges[simplex_] := Flatten[Table[
   Module[{edge = point[simplex[[j]]] - point[simplex[[i]]]}, canonical[edge . gram . edge]],
   {i, 1, Length[simplex]}, {j, i + 1, Length[simplex]}]];
without[matrix_, i_, j_] := Map[Delete[#, j] &, Delete[matrix, i]];
cofactors[matrix_] := Table[(-1)^(i + j) Det[without[matrix, i, j]], {i, 1, Length[matrix]}, {j, 1, Length[matrix]}];
(* The numbers of acute, right and obtuse dihedral angles, by the products of the facets' normals. *)
angleSigns[simplex_] := Module[{edges = edgeMatrix[simplex], inner, border, products, signs},
   inner = Map[canonical, cofactors[Map[canonical, edges . gram . Transpose[edges], {2}]], {2}];
   border = Map[canonical, -Total[inner]];
   products = Join[border, Flatten[Table[inner[[i, j]], {i, 1, Length[inner]}, {j, i + 1, Length[inner]}]]];
   signs = Map[Sign, products];
   {Count[signs, -1], Count[signs, 0], Count[signs, 1]}];
determinants = Map[canonical[Det[edgeMatrix[#]]] &, simplices];
checks = {
   Table[Sign[canonical[Det[Map[Take[#, k] &, Take[gram, k]]]]] === 1, {k, 1, Length[gram]}],
   Length[simplices] > 0,
   Map[# =!= 0 &, determinants],
   canonical[Total[Map[Sign[#] # &, determinants]]] === canonical[total],
   Length[kinds] === Length[simplices],
   Table[Sort[squaredEdges[simplices[[k]]]] === Sort[Map[canonical, classes[[kinds[[k]] + 1, 1]]]] &&
     angleSigns[simplices[[k]]] === classes[[kinds[[k]] + 1, 2]], {k, 1, Length[simplices]}]};
checked = Union[Flatten[checks]] === {True};
If[checked,
  Print["checked: simplices ", Length[simplices], ", classes ", Length[classes]],
  If[MemberQ[Flatten[{checks}], False],
    Print["not as acutile wrote it; see the list checks"],
    Print["not decided by this program; see the list checks"]]];
