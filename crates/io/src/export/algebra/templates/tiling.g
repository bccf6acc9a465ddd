# @NAME@: an exact tiling, written by acutile @VERSION@ for GAP.
# Read("FILE.g"); defines it and checks it. Nothing is rounded.
#
# Points have coordinates in a basis whose inner products are `gram`.
# A corner [v, s1, ...] is vertex v, counted from 0, moved by the integers s1, ... along the basis.
# Each simplex stands for its translates by the first @RANK@ basis vectors. Domain: @DOMAIN@.
@FIELD@
gram := @GRAM@ * One(K);;
vertices := @VERTICES@ * One(K);;
simplices := @SIMPLICES@;;
# The sum of the absolute determinants of all simplices, @D@! times the volume in cells.
total := (@TOTAL@) * One(K);;
# The congruence class of each simplex, and for each class the squared edges and the numbers of acute, right
# and obtuse dihedral angles.
kinds := @KINDS@;;
classes := @CLASSES@;;

# The values of a polynomial on an interval of rational numbers, enclosed by Horner's rule.
enclosure := function(coefficients, low, high)
  local c, value, ends;
  value := [0, 0];
  for c in Reversed(coefficients) do
    ends := [value[1] * low, value[1] * high, value[2] * low, value[2] * high];
    value := [Minimum(ends) + c, Maximum(ends) + c];
  od;
  return value;
end;;

# The sign of a number, decided exactly: the interval of the generator is halved until it suffices.
sign := function(x)
  local c, low, high, middle, value;
  c := Coefficients(basis, x * One(K));
  if ForAll(c, IsZero) then return 0; fi;
  low := bounds[1]; high := bounds[2];
  repeat
    value := enclosure(c, low, high);
    middle := (low + high) / 2;
    if enclosure(polynomial, middle, middle)[1] * enclosure(polynomial, low, low)[1] <= 0 then
      high := middle;
    else
      low := middle;
    fi;
  until value[1] > 0 or value[2] < 0;
  return SignInt(NumeratorRat(value[1] + value[2]));
end;;

point := corner -> vertices[corner[1] + 1] + corner{[2 .. Length(corner)]} * One(K);;

edgeMatrix := function(simplex)
  local points;
  points := List(simplex, point);
  return List(points{[2 .. Length(points)]}, p -> p - points[1]);
end;;

squaredEdges := function(simplex)
  local points;
  points := List(simplex, point);
  return List(Combinations([1 .. Length(points)], 2),
    pair -> (points[pair[2]] - points[pair[1]]) * gram * (points[pair[2]] - points[pair[1]]));
end;;

# The numbers of acute, right and obtuse dihedral angles, by the products of the facets' normals.
angleSigns := function(simplex)
  local edges, inner, normals, border, signs;
  edges := edgeMatrix(simplex);
  inner := edges * gram * TransposedMat(edges);
  inner := Inverse(inner) * DeterminantMat(inner);
  border := -Sum(inner);
  normals := Concatenation([Concatenation([-Sum(border)], border)],
    List([1 .. Length(inner)], i -> Concatenation([border[i]], inner[i])));
  signs := List(Combinations([1 .. Length(normals)], 2), pair -> sign(normals[pair[1]][pair[2]]));
  return List([-1, 0, 1], s -> Number(signs, t -> t = s));
end;;

require := function(holds, words)
  if not holds then Error(words); fi;
end;;

require(ForAll([1 .. Length(gram)], k -> sign(DeterminantMat(List([1 .. k], i -> gram[i]{[1 .. k]}))) > 0), "the metric is not positive");
require(Length(simplices) > 0, "no simplices");
determinants := List(simplices, simplex -> DeterminantMat(edgeMatrix(simplex)));;
require(ForAll(determinants, x -> not IsZero(x)), "a simplex is flat");
require(Sum(determinants, x -> sign(x) * x) = total, "the volume is another one");
require(Length(kinds) = Length(simplices), "a simplex has no class");
for place in [1 .. Length(simplices)] do
  class := classes[kinds[place] + 1];
  require(SortedList(squaredEdges(simplices[place])) = SortedList(class[1] * One(K)), "squared edges are others");
  require(angleSigns(simplices[place]) = class[2], "angles have other signs");
od;
Print("checked: simplices ", Length(simplices), ", classes ", Length(classes), "\n");
