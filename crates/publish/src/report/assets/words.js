// The sentences of a page, made anew from the claim that a certificate makes, to compare them with what the page says.

const NAMES = {
  2: { how: "edge to edge", one: "triangle", many: "triangles", facet: ["edge", "edges"], angle: "angle", corners: "vertices", space: "the plane", solid: ["strip", "", "polygon"], plane: "the line" },
  3: { how: "face to face", one: "tetrahedron", many: "tetrahedra", facet: ["triangle", "triangles"], angle: "dihedral angle", corners: "vertices and edges", space: "three-space", solid: ["slab", "prism", "polyhedron"], plane: "the plane" },
};

const count = (n, one, many) => `${n} ${n === 1 ? one : many}`;
const list = (items) => `[${items.join(", ")}]`;

// The first sentence of a tiling.
function firstSentence({ claim, witness }, printed = (x, q = 1) => quotient(integersOf(x), BigInt(q))) {
  const D = claim.dimension, names = NAMES[D], rank = rankOf(claim), isRegion = claim.domain[0] === "region";
  const boundary = isRegion ? `, whose union it is, and its boundary by ${count(witness.boundary.length, ...names.facet)}, which meet in common ${names.corners} only` : "";
  const gram = [...Array(D).keys()].map((i) => list([...Array(D).keys()].map((j) => printed(claim.gram[Math.min(i, j)][Math.abs(i - j)]))));
  const { polynomial, root } = claim.field, end = (x) => fraction(BigInt(x), BigInt(root.denominator));
  const field = claim.field === "Q" ? "" : `, where a is the root of ${quotient(integersOf(polynomial), 1n)} between ${end(root.low)} and ${end(root.high)}`;
  return `${domainWords(claim, names, rank, printed)} is tiled ${names.how} by ${count(witness.simplices.length, names.one, names.many)}${boundary}${latticeWords(rank, D)} the Gram matrix ${list(gram)}${field}`;
}

function rankOf({ domain, dimension }) {
  if (domain === "space") return dimension;
  if (domain[0] === "region") return domain[1];
  return { slab: dimension - 1, prism: 1, solid: 0 }[domain[0]];
}

function domainWords({ domain, dimension }, names, rank, printed) {
  if (domain === "space") return names.space;
  if (domain[0] === "region") return `a ${rank === 0 ? "bounded" : "periodic"} region of ${names.space}`;
  const [kind, { denominator, vertices }] = domain, name = names.solid[["slab", "prism", "solid"].indexOf(kind)];
  const coordinates = Array.from({ length: dimension - rank }, (_, k) => `x_${rank + k + 1}`);
  return `the ${name} of the points whose coordinates ${list(coordinates)} lie in the convex hull of ${vertices.map((v) => list(v.map((x) => printed(x, denominator)))).join(", ")}`;
}

function latticeWords(rank, dimension) {
  if (rank === 0) return ", in the basis with";
  if (rank === dimension) return " and their translates under the lattice whose basis has";
  const vectors = rank === 1 ? "by the integer multiples of the first vector" : "under the lattice of the first two vectors";
  return ` and their translates ${vectors} of the basis with`;
}

const PLAIN = {
  acute: ({ angle }) => `all ${angle}s are acute`,
  nonobtuse: ({ angle }) => `no ${angle} is obtuse`,
  Delaunay: () => "it is the Delaunay triangulation of its vertices",
  "weakly Delaunay": () => "it is a Delaunay triangulation of its vertices",
  "locally Delaunay": ({ facet }) => `it is Delaunay at every ${facet[0]} that two share`,
  "locally weakly Delaunay": ({ facet }) => `it is weakly Delaunay at every ${facet[0]} that two share`,
  TCP: () => "it is tetrahedrally close packed: every edge is in 5 or 6 tetrahedra, and no triangle has two edges that are in 6",
};

const RELATIONS = { maximum: "at most", minimum: "at least" };

// Whether a sentence of the page says what a statement of the claim says. Values are compared in doubles, in all digits that the page prints.
function saysStatement(sentence, statement, claim, generator) {
  // A system of patches is about space.
  const names = NAMES[claim.dimension ?? 3];
  if (typeof statement === "string") return sentence === PLAIN[statement]?.(names);
  const [kind, relation, ...rest] = statement;
  if (kind === "uncrossed plane") return sentence === `no ${names.one} crosses ${names.plane} ${planeWords(relation, rest[0])} or a translate of it by the lattice`;
  const head = `${boundHead(kind, relation, names)} ${RELATIONS[relation] ?? relation} `, tail = relation in RELATIONS ? `, attained${claim.tiles ? " wherever a certain tile occurs" : ""}` : "";
  if (!sentence.startsWith(head) || !sentence.endsWith(tail)) return false;
  const isRatio = kind === "squared radius-edge ratio", [sign, bound] = isRatio ? [1, rest[0]] : rest;
  const square = integersOf(bound[0]).reduce((sum, c, k) => sum + Number(c) * generator ** k, 0) / Number(bound[1]);
  const value = isRatio ? Math.sqrt(square) : Math.acos(sign * Math.sqrt(square)) * 180 / Math.PI;
  return saysValue(sentence.slice(head.length, sentence.length - tail.length), value, isRatio ? "" : " degrees");
}

function boundHead(kind, relation, { angle, one }) {
  const isUpper = ["less than", "at most", "maximum"].includes(relation);
  if (kind === "squared radius-edge ratio") return `every circumradius over the shortest edge of its ${one} is`;
  if ((kind === "largest dihedral angle") === isUpper) return `all ${angle}s are`;
  return `the ${kind === "largest dihedral angle" ? "largest" : "smallest"} ${angle} of every ${one} is`;
}

// `arccos(1/5) = 78.4630... degrees`, `60 degrees`, `√(5/12) = 0.6454...`, `1/2`.
function saysValue(text, value, unit) {
  if (!text.endsWith(unit)) return false;
  const parts = text.slice(0, text.length - unit.length).split(" = "), digits = parts.at(-1);
  const isClosed = parts.length === 1 || close(closedForm(parts[0]), value);
  const cut = /^(?:about )?(\d+\.\d{4})(\.\.\.)?$/.exec(digits);
  const isCut = cut && (digits.startsWith("about") ? Math.abs(Number(cut[1]) - value) < 1.1e-4 : Number(cut[1]) <= value + 1e-9 && value < Number(cut[1]) + 1.00001e-4);
  return isClosed && (parts.length === 1 ? isCut || close(closedForm(digits), value) : isCut);
}

const close = (x, y) => Math.abs(x - y) <= 1e-12 * Math.max(1, Math.abs(y)) * 100;

// The value of `arccos(-√(1/7))` in degrees, of `√5`, `√(5/12)`, `3/4`, `60`; no number for another text.
function closedForm(text) {
  const angle = /^arccos\((.*)\)$/.exec(text);
  if (angle) return Math.acos(closedForm(angle[1])) * 180 / Math.PI;
  const [, minus, root, inner] = /^(-?)(√?)\(?([\d./]+)\)?$/.exec(text) ?? [];
  if (!inner) return NaN;
  const [p, q = "1"] = inner.split("/"), size = Number(p) / Number(q);
  return (minus ? -1 : 1) * (root ? Math.sqrt(size) : size);
}

// `x2+x3=1/2`
function planeWords(normal, [p, q]) {
  let text = "";
  normal.forEach((c, k) => {
    if (c) text += `${c < 0 ? "-" : text ? "+" : ""}${Math.abs(c) === 1 ? "" : Math.abs(c)}x${k + 1}`;
  });
  return `${text}=${p}${Number(q) === 1 ? "" : `/${q}`}`;
}
