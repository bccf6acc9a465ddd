// The data of a chosen simplex.

// Bounds as one decimal where they agree in all digits, else the digits that they share and dots.
function decimal([low, high]) {
  if (low === high) return low.includes(".") ? low.replace(/\.?0+$/, "") : low;
  let k = 0;
  while (k < low.length && low[k] === high[k]) k++;
  return k > low.indexOf(".") + 2 && k > 3 ? `${low.slice(0, k)}…` : `${low} to ${high}`;
}

const LETTERS = "ABCD";
const pairsOf = (D) => [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]].filter((pair) => Math.max(...pair) <= D);

// What is shown of simplex `cell`; `shift` says which translate was chosen.
function details(tiling, cell, shift) {
  const { data, D } = tiling;
  const moved = shift.map((s, k) => s + cell.moved[k]);
  const where = moved.some((x) => x) ? ` The chosen one is its translate by (${moved.slice(0, tiling.r).join(", ")}).` : "";
  const { basis } = data, cellVolume = D === 2 ? basis[0][0] * basis[1][1] : basis[0][0] * basis[1][1] * basis[2][2];
  const volume = cell.edges ? data.numbers[cell.volume][0] : volumeOf(tiling, cell);
  const approximate = cellVolume * (cell.edges ? data.numbers[cell.volume][1] : numberOf(volume, data.generator));
  return [
    element("h3", {}, `${D === 2 ? "Triangle" : "Tetrahedron"} ${cell.index}`),
    element("p", {}, cell.edges ? `Congruence class ${cell.class}. ` : "", `${D === 2 ? "Area" : "Volume"}: `, element("b", {}, math(volume)),
      ` of the basis' ${D === 2 ? "parallelogram" : "parallelepiped"}, about ${approximate.toPrecision(8)}.${where}`),
    element("div", { class: "pair" }, cornerTable(tiling, cell), edgeTable(tiling, cell)),
  ];
}

function cornerTable({ data, certificate }, cell) {
  const hasTypes = Boolean(data.typeNames?.length), { vertices, denominator } = certificate.witness;
  const rows = cell.corners.map(([v, ...s], i) => {
    const coordinates = vertices[v].map((x, k) => exact(x, denominator, s[k] ?? 0)).join(", ");
    const name = s.some((x) => x) ? `${v} + (${s.join(", ")})` : `${v}`;
    return [LETTERS[i], name, ...(hasTypes ? [data.typeNames[data.types[v]]] : []), `(${coordinates})`];
  });
  return table("Corners", ["corner", "vertex", ...(hasTypes ? ["type"] : []), "coordinates in the basis"], rows);
}

const facetsAt = (pair, D) => (D === 2 ? pair : [0, 1, 2, 3].filter((i) => !pair.includes(i)));

// The angle at an edge, or opposite to a side, in degrees, rounded.
function anglesAt(points, D) {
  const angles = roundedAngles(points, D);
  return (pair) => angles.find(([i, j]) => facetsAt(pair, D).every((k) => k === i || k === j))[2];
}

// The edges with the angles at them; in the plane the sides with the angles opposite to them. The angle at an edge, or at a corner, lies
// between the facets opposite to the two other corners, or opposite to the two ends of the side.
function edgeTable(tiling, cell) {
  const { D } = tiling, pairs = pairsOf(D);
  const caption = D === 3 ? "Edges and the dihedral angles at them" : "Sides and the angles opposite to them";
  const side = D === 3 ? "edge" : "side", name = (pair) => pair.map((i) => LETTERS[i]).join("");
  if (!cell.edges) {
    const degrees = anglesAt(cell.points, D);
    return table(caption, [side, "squared length", "degrees, rounded"],
      pairs.map((pair) => [name(pair), squaredLength(tiling, cell, ...pair), `about ${degrees(pair).toFixed(6)}°`]));
  }
  const angleOf = (pair) => tiling.data.angles[cell.angles[pairs.findIndex((other) => facetsAt(pair, D).every((k) => other.includes(k)))]];
  const angleCells = (a) => [math(a.cosine), decimal(a.decimals), a.name && !a.name.startsWith("arccos") ? `${a.name}°` : `${decimal(a.degrees)}°`];
  return table(caption, [side, "squared length", "cosine", "decimal", "degrees"],
    pairs.map((pair, k) => [name(pair), math(tiling.data.numbers[cell.edges[k]][0]), ...angleCells(angleOf(pair))]));
}

// A number like `1/2 + 3/4 a` as a double, for the double `generator` in the place of a.
function numberOf(text, generator = 0) {
  return text.replaceAll(" - ", " + -").split(" + ").reduce((sum, term) => {
    const [, sign, p, q, a, power = "1"] = /^(-?)(\d+)?(?:\/(\d+))?\s*(a)?(?:\^(\d+))?$/.exec(term);
    return sum + (sign ? -1 : 1) * Number(p ?? 1) / Number(q ?? 1) * (a ? generator ** Number(power) : 1);
  }, 0);
}
