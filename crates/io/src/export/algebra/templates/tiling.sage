# @NAME@: an exact tiling, written by acutile @VERSION@ for Sage.
# load("FILE.sage") defines it and checks it. Nothing is rounded.
#
# Points have coordinates in a basis whose inner products are `gram`.
# A corner [v, s1, ...] is vertex v, counted from 0, moved by the integers s1, ... along the basis.
# Each simplex stands for its translates by the first @RANK@ basis vectors. Domain: @DOMAIN@.
@FIELD@
gram = matrix(K, @GRAM@)
vertices = [vector(K, v) for v in @VERTICES@]
simplices = @SIMPLICES@
# The sum of the absolute determinants of all simplices, @D@! times the volume in cells.
total = K(@TOTAL@)
# The congruence class of each simplex, and for each class the squared edges and the numbers of acute, right
# and obtuse dihedral angles.
kinds = @KINDS@
classes = @CLASSES@

def point(corner):
    return vertices[corner[0]] + vector(K, corner[1:])

def edge_matrix(simplex):
    points = [point(corner) for corner in simplex]
    return matrix(K, [p - points[0] for p in points[1:]])

def squared_edges(simplex):
    points = [point(corner) for corner in simplex]
    return [(q - p) * gram * (q - p) for i, p in enumerate(points) for q in points[i + 1:]]

def angle_signs(simplex):
    """The numbers of acute, right and obtuse dihedral angles, by the products of the facets' normals."""
    edges = edge_matrix(simplex)
    inner = (edges * gram * edges.transpose()).adjugate()
    border = -sum(inner)
    normals = matrix(K, [[-sum(border)] + list(border)] + [[b] + list(row) for b, row in zip(border, inner)])
    products = [normals[i, j] for i in range(normals.nrows()) for j in range(i)]
    return [sum(1 for x in products if x < 0), sum(1 for x in products if x == 0), sum(1 for x in products if x > 0)]

assert all(gram[:k, :k].det() > 0 for k in range(1, gram.nrows() + 1)), "the metric is not positive"
assert simplices, "no simplices"
determinants = [edge_matrix(simplex).det() for simplex in simplices]
assert all(determinants), "a simplex is flat"
assert sum(abs(x) for x in determinants) == total, "the volume is another one"
assert len(kinds) == len(simplices), "a simplex has no class"
for simplex, kind in zip(simplices, kinds):
    assert sorted(squared_edges(simplex)) == sorted(K(x) for x in classes[kind][0]), "squared edges are others"
    assert angle_signs(simplex) == classes[kind][1], "angles have other signs"
print(f"checked: simplices {len(simplices)}, classes {len(classes)}")
