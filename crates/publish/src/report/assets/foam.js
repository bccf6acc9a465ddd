// The foam: the Voronoi cell of each vertex, coloured by its number of faces.

COLOURINGS.foam = (tiling) => {
  const { foam } = tiling.data, kinds = [...new Set(foam.map((faces) => faces.length))].sort((a, b) => a - b);
  return {
    palette: kinds.map((_, k) => rgb(TYPE_COLOURS[k % 8])).slice(0, 64),
    of: (vertex) => Array(4).fill(kinds.indexOf(foam[vertex].length) % 64),
    legend: kinds.map((count, k) => [TYPE_COLOURS[k % 8], `${count} faces: ${foam.filter((faces) => faces.length === count).length} in a cell`]),
  };
};

// The cells of one lattice cell with Cartesian corners, and the middle of each.
function foamCells(tiling) {
  return tiling.foamCells ??= tiling.data.foam.map((faces) => {
    const polygons = faces.map((corners) => corners.map(tiling.cartesian));
    return { polygons, middle: mean(polygons.map(mean)) };
  });
}

// The triangles of n cells in each direction. A cut leaves out the cells whose middles lie beyond it.
async function foamTriangles(tiling, n, plane, colours) {
  const list = new Triangles(), offsets = translates(tiling, n).map(tiling.cartesian), cells = foamCells(tiling);
  await inPortions(cells.length * offsets.length, (owner) => {
    const offset = offsets[Math.floor(owner / cells.length)], vertex = owner % cells.length, middle = add(cells[vertex].middle, offset);
    if (plane && dot(plane.n, middle) > plane.c) return;
    for (const polygon of cells[vertex].polygons) putFace(list, polygon.map((p) => add(p, offset)), middle, colours(vertex), owner);
  });
  return list.done();
}

// A face as triangles around its middle. Only the first weight vanishes at an edge of the face, so that no other line is drawn.
function putFace(list, polygon, middle, ink, owner) {
  const centre = mean(polygon);
  let normal = unit(cross(add(polygon[1], polygon[0], -1), add(polygon[2], polygon[0], -1)));
  const isInward = dot(normal, add(centre, middle, -1)) < 0;
  if (isInward) normal = normal.map((x) => -x);
  polygon.forEach((p, k) => {
    const q = polygon[(k + 1) % polygon.length], [a, b] = isInward ? [q, p] : [p, q];
    list.put([{ p: centre, b: [1, 1, 1, 1] }, { p: a, b: [0, 1, 1, 1] }, { p: b, b: [0, 1, 1, 1] }], normal, middle, ink, 4, owner, 0);
  });
}

// What is shown of a chosen cell.
function foamDetails(tiling, vertex) {
  const faces = tiling.data.foam[vertex], sizes = new Map();
  for (const { length } of faces) sizes.set(length, (sizes.get(length) ?? 0) + 1);
  const kinds = [...sizes].sort(([a], [b]) => a - b).map(([corners, count]) => [`${corners} corners`, String(count)]);
  return [
    element("h3", {}, `Foam cell of vertex ${vertex}`),
    element("p", {}, `${faces.length} faces. The cell has the points that are nearer to this vertex than to any other.`),
    table("Faces", ["face", "number"], kinds),
  ];
}
