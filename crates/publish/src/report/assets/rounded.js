// What is shown of a chosen simplex of a family or of a system of patches: values in doubles, and what the certificate says of its corners.

function roundedDetails(tiling, cell, shift) {
  const { data, D } = tiling, [a, b, c, d = add(a, [0, 0, 1])] = cell.points;
  const size = Math.abs(dot(add(b, a, -1), cross(add(c, a, -1), add(d, a, -1)))) / (D === 2 ? 2 : 6);
  const moved = shift.map((s, k) => s + cell.moved[k]);
  const where = moved.some((x) => x) ? ` The chosen one is its translate by (${moved.slice(0, tiling.r).join(", ")}).` : "";
  const about = data.kind === "family" ? "" : `${pieceWords(data, cell.index)} `;
  return [
    element("h3", {}, `${D === 2 ? "Triangle" : "Tetrahedron"} ${cell.index}`),
    element("p", {}, `${about}${D === 2 ? "Area" : "Volume"} about ${size.toPrecision(6)}.${where} Lengths and angles are rounded.`),
    element("div", { class: "pair" }, data.kind === "family" ? polynomialCorners(tiling, cell) : placedCorners(cell), roundedEdges(cell.points, D)),
  ];
}

const cornerName = ([v, ...s]) => (s.some((x) => x) ? `${v} + (${s.join(", ")})` : `${v}`);

// Corners with the polynomials of the certificate.
function polynomialCorners({ data, certificate }, cell) {
  const { vertices, denominator } = certificate.witness, names = data.parameters.map(({ name }) => name);
  const rows = cell.corners.map((corner, i) => {
    const [v, ...s] = corner, coordinates = element("span", {}, "(");
    vertices[v].forEach((terms, k) => {
      const unmoved = polynomialText(terms, denominator, names), text = s[k] ? `${unmoved === "0" ? "" : `${unmoved} + `}${s[k]}`.replace("+ -", "- ") : unmoved;
      coordinates.append(k ? ", " : "", math(text));
    });
    coordinates.append(")");
    return [LETTERS[i], cornerName(corner), data.typeNames[data.types[v]], coordinates];
  });
  return table("Corners", ["corner", "vertex", "type", "coordinates in the basis"], rows);
}

const placedCorners = (cell) => table("Corners", ["corner", "vertex", "position, rounded"],
  cell.corners.map((corner, i) => [LETTERS[i], cornerName(corner), `(${cell.points[i].map((x) => x.toFixed(4)).join(", ")})`]));

function roundedEdges(points, D) {
  const at = anglesAt(points, D), length = ([i, j]) => Math.hypot(...add(points[i], points[j], -1));
  const rows = pairsOf(D).map((pair) => [pair.map((i) => LETTERS[i]).join(""), length(pair).toFixed(6), `about ${at(pair).toFixed(6)}°`]);
  return table(D === 3 ? "Edges and the dihedral angles at them" : "Sides and the angles opposite to them", [D === 3 ? "edge" : "side", "length, rounded", "degrees, rounded"], rows);
}
