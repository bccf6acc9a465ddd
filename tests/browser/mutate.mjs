// Certificates, changed: a seeded generator of files that are nearly right, for the comparison of the verifiers.
//
// A change takes the parsed certificate and makes it another one: mostly in canonical form, so that every later check of docs/format.md
// is met by files that pass the ones before it. `write` gives the canonical text and `toCbor` the bytes, from docs/format.md alone.

/** Small, fast, and the same everywhere (mulberry32). */
export class Chance {
  constructor(seed) {
    this.state = seed >>> 0;
  }

  /** An integer from 0 to n - 1. */
  below(n) {
    this.state = (this.state + 0x6d2b79f5) >>> 0;
    let t = this.state;
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) % n;
  }

  of(list) {
    return list[this.below(list.length)];
  }

  index(list) {
    return this.below(list.length);
  }
}

// ---- The two encodings ----

/** The canonical text: the outer three levels on lines of their own. */
export function write(value, depth = 0) {
  if (value === null || typeof value !== "object") return JSON.stringify(value);
  const items = Array.isArray(value)
    ? value.map((item) => write(item, depth + 1))
    : Object.entries(value).map(([name, item]) => `${JSON.stringify(name)}:${write(item, depth + 1)}`);
  const [open, close] = Array.isArray(value) ? "[]" : "{}";
  const line = depth < 3 && items.length > 0 ? "\n" : "";
  return open + items.map((item) => line + item).join(",") + line + close + (depth === 0 ? "\n" : "");
}

/** The same certificate in CBOR; undefined where a value has no place there. */
export function toCbor(value) {
  const head = (major, argument) => {
    const width = [24n, 1n << 8n, 1n << 16n, 1n << 32n, 1n << 64n].findIndex((end) => argument < end);
    const digits = width === 0 ? "" : argument.toString(16).padStart(2 ** width, "0");
    return [32 * major + (width === 0 ? Number(argument) : 23 + width), ...Buffer.from(digits, "hex")];
  };
  const integer = (x) => {
    const [sign, size] = x < 0n ? [1, -x - 1n] : [0, x];
    if (size < 1n << 64n) return head(sign, size);
    const digits = size.toString(16);
    const bytes = Buffer.from(digits.length % 2 ? "0" + digits : digits, "hex");
    return [0xc2 + sign, ...head(2, BigInt(bytes.length)), ...bytes];
  };
  if (Number.isSafeInteger(value)) return integer(BigInt(value));
  if (typeof value === "string") return /^-?[1-9][0-9]*$/.test(value) ? integer(BigInt(value)) : [...head(3, BigInt(Buffer.byteLength(value))), ...Buffer.from(value)];
  if (value === null || typeof value !== "object") return undefined;
  const items = Object.values(value).map(toCbor);
  return items.includes(undefined) ? undefined : [...head(4, BigInt(items.length)), ...items.flat()];
}

// ---- Numbers: arrays of coefficients as BigInt; in families values are lists of terms [number, exponent…] ----

const gcd = (a, b) => (b === 0n ? (a < 0n ? -a : a) : gcd(b, a % b));
const wide = (x) => (Array.isArray(x) ? x.map(BigInt) : [BigInt(x)]);
const short = (c) => (c > -(2n ** 53n) && c < 2n ** 53n ? Number(c) : `${c}`);
const narrow = (x, like) => (Array.isArray(like) ? x.map(short) : short(x[0]));
const mapped = (number, change) => narrow(wide(number).map(change), number);
/** A number over Q(a) is an array of integers, a value of a family one of arrays. The empty value is zero. */
const isValue = (x) => Array.isArray(x) && (x.length === 0 || Array.isArray(x[0]));
const isZero = (number) => wide(number).every((c) => c === 0n);
const eachNumber = (x, change) => (isValue(x) ? x.map(([c, ...powers]) => [change(c), ...powers]).filter(([c]) => !isZero(c)) : change(x));
const times = (x, factor) => eachNumber(x, (number) => mapped(number, (c) => c * factor));
const divided = (x, divisor) => eachNumber(x, (number) => mapped(number, (c) => c / divisor));
const plusNumber = (number, other) => mapped(number, (c, k) => c + (other[k] ?? 0n));

/** Adds a number, to a value at its constant term; `like` is a number of the field, `count` that of parameters. */
function plus(x, other, like, count) {
  if (!isValue(x)) return plusNumber(x, other);
  return withTerm(x, [narrow(wide(like).map((_, k) => other[k] ?? 0n), like), ...Array(count).fill(0)]);
}

/** Adds a term to a value, in order. */
function withTerm(value, [c, ...powers]) {
  const at = value.findIndex(([, ...other]) => byEntries(other, powers) === 0);
  const terms = at < 0 ? [...value, [c, ...powers]] : value.with(at, [plusNumber(value[at][0], wide(c)), ...powers]);
  return terms.filter(([c]) => !isZero(c)).sort(([, ...p], [, ...q]) => byEntries(p, q));
}

/** All coefficients of nested arrays of numbers or values. The exponents of terms are none. */
function integersOf(table, isFamily) {
  if (!isFamily) return table.flat(3).map(BigInt);
  return table.flat(1).flatMap((value) => value.flatMap(([c]) => wide(c)));
}

const likeOf = ({ field }) => (field === "Q" ? 0 : Array(field.polynomial.length - 1).fill(0));
const countOf = ({ parameters }) => parameters?.length ?? 0;

/** All coordinates and their denominator, times an integer. */
function refine(table, factor) {
  table.denominator = times(table.denominator, factor);
  table.vertices = table.vertices.map((point) => point.map((x) => times(x, factor)));
}

/** Lowest terms. */
function reduce(table, claim) {
  const common = [BigInt(table.denominator), ...integersOf(table.vertices, Boolean(claim.parameters))].reduce(gcd);
  if (common < 2n) return;
  table.denominator = mapped(table.denominator, (c) => c / common);
  table.vertices = table.vertices.map((point) => point.map((x) => divided(x, common)));
}

function reduceGram({ claim }) {
  const common = integersOf(claim.gram, Boolean(claim.parameters)).reduce(gcd);
  if (common > 1n) claim.gram = claim.gram.map((row) => row.map((x) => divided(x, common)));
}

// ---- Corners, rows, facets ----

const rankOf = ({ dimension, domain }) => (domain === "space" ? dimension : { region: domain[1], slab: dimension - 1, prism: 1, solid: 0 }[domain[0]]);
const full = (corner, rank) => (Array.isArray(corner) ? corner : [corner, ...Array(rank).fill(0)]);
const tight = ([v, ...shift]) => (shift.some((s) => s !== 0) ? [v, ...shift] : v);
const byEntries = (x, y) => x.map((entry, k) => entry - y[k]).find((d) => d !== 0) ?? 0;
const moved = ([v, ...shift], by, sign) => [v, ...shift.map((s, k) => s + sign * by[k])];
const inversions = (corners) => corners.flatMap((x, i) => corners.slice(i + 1).filter((y) => byEntries(x, y) > 0)).length;

/** A positive list of corners in canonical order; `sixes` follow their edges. */
function canonicalRow(corners) {
  const sorted = [...corners].sort(byEntries).map((corner, _, [first]) => moved(corner, first.slice(1), -1));
  if (inversions(corners) % 2 === 1) sorted.push(...sorted.splice(-2).reverse());
  return sorted.map(tight);
}

/** A facet in canonical order, with the same sense. */
function canonicalFacet(corners) {
  if (corners.length > 2) return canonicalRow(corners);
  return corners.map((corner) => tight(moved(corner, corners[0].slice(1), -1)));
}

const EDGES = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];

/** Rewrites all corners, and the order of rows and facets with them. */
function rename(certificate, change) {
  const { claim, witness } = certificate;
  const rank = rankOf(claim);
  const renamed = (corners) => corners.map((corner) => change(full(corner, rank)));
  witness.boundary = witness.boundary.map((facet) => canonicalFacet(renamed(facet)));
  witness.simplices = witness.simplices.map((row) => {
    const before = row.slice(0, claim.dimension + 1).map((corner) => full(corner, rank));
    const after = renamed(before);
    const rest = row.slice(claim.dimension + 1);
    if (rest.length === 0) return canonicalRow(after);
    const [from, to] = [before, after].map((corners) => [...corners].sort(byEntries));
    const bit = ([i, j]) => EDGES.findIndex((edge) => edge.includes(i) && edge.includes(j));
    const place = (i) => to.findIndex((corner) => corner === after[before.indexOf(from[i])]);
    const sixes = EDGES.reduce((sum, [i, j], p) => sum + (((rest[0] >> p) & 1) << bit([place(i), place(j)])), 0);
    return [...canonicalRow(after), sixes];
  });
}

/** The boundary that the rows have: facets that do not occur twice. */
function findBoundary({ claim, witness }) {
  const rank = rankOf(claim);
  const open = new Map();
  for (const row of witness.simplices) {
    const corners = row.slice(0, claim.dimension + 1).map((corner) => full(corner, rank));
    corners.forEach((_, i) => {
      const facet = corners.filter((_, k) => k !== i);
      if (i % 2 === 1) facet.push(...facet.splice(-2).reverse());
      const sorted = [...facet].sort(byEntries);
      const name = sorted.map((corner) => moved(corner, sorted[0].slice(1), -1)).join();
      if (!open.delete(name)) open.set(name, canonicalFacet(facet));
    });
  }
  witness.boundary = [...open.values()];
}

function dropUnused(certificate) {
  const { witness } = certificate;
  const used = [...new Set(witness.simplices.flatMap((row) => row.map((corner) => [corner].flat()[0])))].sort((v, w) => v - w);
  witness.vertices = used.map((v) => witness.vertices[v]);
  rename(certificate, ([v, ...shift]) => [used.indexOf(v), ...shift]);
}

// ---- Changes that keep a tiling a tiling ----

function relabel(chance, certificate) {
  const { vertices } = certificate.witness;
  const [v, w] = [chance.index(vertices), chance.index(vertices)];
  [vertices[v], vertices[w]] = [vertices[w], vertices[v]];
  rename(certificate, ([u, ...shift]) => [u === v ? w : u === w ? v : u, ...shift]);
}

/** Another translate of a vertex. */
function moveVertex(chance, certificate) {
  const { claim, witness } = certificate;
  const rank = rankOf(claim);
  const v = chance.index(witness.vertices);
  const by = Array.from({ length: rank }, () => chance.below(5) - 2);
  witness.vertices[v] = witness.vertices[v].map((x, k) => plus(x, [BigInt(by[k] ?? 0) * BigInt(witness.denominator)], likeOf(claim), countOf(claim)));
  rename(certificate, ([u, ...shift]) => (u === v ? moved([u, ...shift], by, -1) : [u, ...shift]));
}

const exchangeRows = (chance, { witness }) => {
  const { simplices } = witness;
  const [s, t] = [chance.index(simplices), chance.index(simplices)];
  [simplices[s], simplices[t]] = [simplices[t], simplices[s]];
};

// ---- Changes that make something false ----

/** Moves one vertex by little: mostly a tiling still, with other angles. */
function nudge(chance, { witness, claim }) {
  const factor = BigInt(chance.of([1, 2, 7, 100, 1e6, "1000000000000000000000"]));
  refine(witness, factor);
  const point = chance.of(witness.vertices);
  const k = chance.index(point);
  point[k] = plus(point[k], [BigInt(chance.of([-2, -1, 1, 3])), ...(chance.below(3) === 0 ? [1n] : [])], likeOf(claim), countOf(claim));
  if (chance.below(2) === 0 && claim.domain[0] === "solid") refine(claim.domain[1], factor);
  reduce(witness, claim);
}

/** Another metric. */
function stretch(chance, certificate) {
  const { claim } = certificate;
  const factor = BigInt(chance.of([1, 2, 10, 1000]));
  claim.gram = claim.gram.map((row) => row.map((x) => times(x, factor)));
  const row = chance.of(claim.gram);
  const k = chance.below(3) === 0 ? chance.index(row) : 0;
  row[k] = plus(row[k], [BigInt(chance.of([-3, -1, 1, 2]))], likeOf(claim), countOf(claim));
  reduceGram(certificate);
}

const BOUNDS = ["largest dihedral angle", "smallest dihedral angle", "squared radius-edge ratio"];
const RELATIONS = ["less than", "at most", "maximum", "more than", "at least", "minimum"];
const ORDER = ["face-to-face tiling", "acute", "nonobtuse", ...BOUNDS, "uncrossed plane", "Delaunay", "weakly Delaunay", "locally Delaunay", "locally weakly Delaunay", "not Delaunay", "TCP"];

function fractionNear(chance, fraction, claim) {
  const [p, q] = fraction ?? [claim.field === "Q" ? 1 : [1, ...Array(claim.field.polynomial.length - 2).fill(0)], chance.of([1, 2, 3, 4, 9, 25])];
  const factor = BigInt(chance.of([1, 1, 2, 1000, "100000000000000000000"]));
  const change = factor === 1n && chance.below(2) === 0 ? 0n : BigInt(chance.of([-1, 1, 2]));
  const [top, bottom] = [wide(p).map((c, k) => c * factor + (k === 0 ? change : 0n)), BigInt(q) * factor];
  const common = [...top, bottom].reduce(gcd);
  return [narrow(top.map((c) => c / common), p), short(bottom / common)];
}

function changeBound(chance, { claim }) {
  const bounds = claim.statements.filter((statement) => BOUNDS.includes(statement[0]));
  const old = bounds.length > 0 && chance.below(4) > 0 ? chance.of(bounds) : undefined;
  const name = old?.[0] ?? chance.of(BOUNDS);
  const relation = old && chance.below(2) === 0 ? old[1] : chance.of(RELATIONS);
  const fraction = fractionNear(chance, old?.at(-1), claim);
  const sign = old && old.length === 4 && chance.below(4) > 0 ? old[2] : chance.of([-1, 0, 1, 1]);
  const statement = name === BOUNDS[2] ? [name, relation, fraction] : [name, relation, wide(fraction[0]).every((c) => c === 0n) ? 0 : sign, fraction];
  if (old) claim.statements.splice(claim.statements.indexOf(old), 1);
  claim.statements.push(statement);
  sortStatements(claim);
}

function changePlane(chance, { claim }) {
  const old = claim.statements.filter(([name]) => name === "uncrossed plane");
  if (old.length > 0 && chance.below(2) === 0) claim.statements.splice(claim.statements.indexOf(chance.of(old)), 1);
  const normal = Array.from({ length: claim.dimension }, () => chance.of([-1, 0, 0, 1, 2]));
  claim.statements.push(["uncrossed plane", normal, chance.of([[0, 1], [0, 1], [1, 2], [1, 1], [-1, 3]])]);
  sortStatements(claim);
}

const rankOfStatement = (statement) => ORDER.indexOf([statement].flat()[0]) * 6 + (Array.isArray(statement) ? RELATIONS.indexOf(statement[1]) : 0);
const sortStatements = ({ statements }) => statements.sort((x, y) => rankOfStatement(x) - rankOfStatement(y));

function changeStatements(chance, { claim, witness }) {
  const isRegion = claim.domain[0] === "region";
  const name = chance.of(chance.below(5) === 0 ? ORDER : ["acute", "nonobtuse", ...(isRegion ? ORDER.slice(9, 11) : ORDER.slice(7, 9))]);
  const at = claim.statements.indexOf(name);
  if (at >= 0) claim.statements.splice(at, 1);
  else claim.statements.push(name);
  if (chance.below(8) > 0) sortStatements(claim);
  if (name !== "TCP") return;
  witness.simplices = witness.simplices.map((row) => (at >= 0 ? row.slice(0, claim.dimension + 1) : [...row, chance.below(64)]));
}

function changeField(chance, { claim }) {
  const { field } = claim;
  if (field === "Q") return void (claim.field = { polynomial: [-3, 0, 1], root: { low: 1, high: 2, denominator: 1 } });
  const { polynomial, root } = field;
  const k = chance.index(polynomial);
  chance.of([
    () => (polynomial[k] = short(BigInt(polynomial[k]) + BigInt(chance.of([-1, 1, 5])))),
    () => (root.low = chance.of([-5, 0, 1, 3])),
    () => (root.high = chance.of([-1, 2, 4, 100])),
    () => (root.denominator = chance.of([0, -1, 1, 2, 3])),
    () => ([root.low, root.high] = [root.high, root.low]),
    () => (field.polynomial = [0n, ...polynomial.map(BigInt)].map((c, i) => short(c - BigInt(chance.of([5, -7])) * BigInt(polynomial[i] ?? 0)))),
    () => polynomial.push(1),
    () => (claim.field = "Q"),
  ])();
}

function changeRow(chance, { claim, witness }) {
  const row = chance.of(witness.simplices);
  const i = chance.below(claim.dimension + 1);
  const corner = row[i];
  chance.of([
    () => ([row[row.length - 1], row[row.length - 2]] = [row[row.length - 2], row[row.length - 1]]),
    () => ([row[claim.dimension - 1], row[claim.dimension]] = [row[claim.dimension], row[claim.dimension - 1]]),
    () => Array.isArray(corner) && (corner[chance.index(corner)] += chance.of([-1, 1])),
    () => !Array.isArray(corner) && (row[i] += chance.of([-1, 1])),
    () => (row[i] = [[corner].flat()[0], ...Array.from({ length: rankOf(claim) }, () => chance.below(3) - 1)]),
    () => row.length > claim.dimension + 1 && (row[row.length - 1] ^= 1 << chance.below(7)),
    () => witness.simplices.splice(witness.simplices.indexOf(row), 1),
    () => witness.simplices.push(structuredClone(row)),
  ])();
}

function changeBoundary(chance, { witness }) {
  const { boundary } = witness;
  if (boundary.length === 0) return void boundary.push(structuredClone(witness.simplices[0].slice(0, 2)));
  const facet = chance.of(boundary);
  chance.of([
    () => boundary.splice(boundary.indexOf(facet), 1),
    () => boundary.push(structuredClone(facet)),
    () => facet.reverse(),
    () => facet.push(...facet.splice(-2).reverse()),
    () => boundary.reverse(),
    () => boundary.push(structuredClone(chance.of(witness.simplices).slice(0, facet.length))),
  ])();
}

/** Takes rows out of a region, and finds its boundary again: a region still. */
function removeRow(chance, certificate) {
  const { simplices } = certificate.witness;
  if (simplices.length > 1) simplices.splice(chance.index(simplices), 1);
  findBoundary(certificate);
  dropUnused(certificate);
}

/** A second piece, the same one moved and scaled: beside, inside of or across the first. */
function secondPiece(chance, certificate) {
  const { claim, witness } = certificate;
  refine(witness, 840n);
  const [p, q] = chance.of([[1n, 1n], [1n, 1n], [1n, 2n], [1n, 10n], [1n, 40n], [3n, 1n]]);
  const by = witness.vertices[0].map(() => (BigInt(witness.denominator) / 840n) * BigInt(chance.of([0, 0, 840, -840, 420, 1680, 120, 168, 240, 84000])));
  const n = witness.vertices.length;
  witness.vertices.push(...witness.vertices.map((point) => point.map((x, k) => plus(divided(times(x, p), q), [by[k]]))));
  const renamed = (corner) => (Array.isArray(corner) ? [corner[0] + n, ...corner.slice(1)] : corner + n);
  for (const table of [witness.simplices, witness.boundary]) table.push(...table.map((corners) => corners.map(renamed)));
  reduce(witness, claim);
}

/** Two vertices become one. */
function identify(chance, certificate) {
  const { vertices } = certificate.witness;
  const [v, w] = [chance.index(vertices), chance.index(vertices)];
  rename(certificate, ([u, ...shift]) => [u === w ? v : u, ...shift]);
  if (certificate.claim.domain[0] === "region") findBoundary(certificate);
  dropUnused(certificate);
}

/** Closer together: a region of rank r with a shorter lattice, so that translates come near. */
function changeRank(chance, certificate) {
  const { claim, witness } = certificate;
  const rank = chance.below(claim.dimension + 1);
  const old = rankOf(claim);
  rename(certificate, ([v, ...shift]) => [v, ...shift.slice(0, rank), ...Array(Math.max(0, rank - old)).fill(0)]);
  claim.domain = ["region", rank];
  claim.statements = claim.statements.filter((statement) => !["Delaunay", "weakly Delaunay", "TCP"].includes(statement));
  witness.simplices = witness.simplices.map((row) => row.slice(0, claim.dimension + 1));
  if (chance.below(2) === 0) refine(witness, BigInt(chance.of([2, 3, 5])));
  if (chance.below(2) === 0) witness.denominator = short(BigInt(witness.denominator) * BigInt(chance.of([2, 3, 7])));
  reduce(witness, claim);
  findBoundary(certificate);
}

function changeDomain(chance, { claim }) {
  const moved = (x) => plus(x, [1n], likeOf(claim), countOf(claim));
  const [kind, polytope] = claim.domain;
  if (kind === "region" || claim.domain === "space") return void (claim.domain = chance.of(["space", ["region", 0], ["region", claim.dimension], ["region", 9], ["region", -1], "slab"]));
  const { faces, vertices } = polytope;
  const [face, point] = [chance.of(faces), chance.of(vertices)];
  chance.of([
    () => (claim.domain[0] = chance.of(["slab", "prism", "solid", "region", "torus"])),
    () => faces.splice(faces.indexOf(face), 1),
    () => faces.push([...face]),
    () => face.push(chance.below(8)),
    () => face.reverse(),
    () => face.push(face.shift()),
    () => ([face[0], face[face.length - 1]] = [face.at(-1), face[0]]),
    () => (face[0] = chance.below(9)),
    () => vertices.push([...point]),
    () => (point[0] = moved(point[0])),
    () => refine(polytope, 2n),
    () => (refine(polytope, 3n), (point[0] = moved(point[0])), reduce(polytope, claim)),
    () => (polytope.denominator = chance.of([0, -1, 2, 3])),
  ])();
}

const ODD = [0, 1, -1, 2, 2 ** 53 - 1, -(2 ** 53) + 1, `${2n ** 53n}`, `${2n ** 64n - 1n}`, `${2n ** 64n}`, `${-(2n ** 64n)}`, `${-(2n ** 64n) - 1n}`, `${2n ** 200n}`,
  `${2n ** 5000n}`, "7", "-0", "01", "x", "", "Q", "space", 1.5, null, true, [], [[]], [0], {}, { a: 1 }, 2 ** 53, "\u00e9", "\\"];

/** Puts an odd value somewhere, or takes a value out. */
function changeAnything(chance, certificate) {
  let [holder, key] = [certificate, chance.of(Object.keys(certificate))];
  while (typeof holder[key] === "object" && holder[key] !== null && Object.keys(holder[key]).length > 0 && chance.below(9) > 0) {
    holder = holder[key];
    key = chance.of(Object.keys(holder));
  }
  if (chance.below(6) > 0) holder[key] = structuredClone(chance.of(ODD));
  else if (Array.isArray(holder)) holder.splice(Number(key), chance.below(2), structuredClone(holder[key]));
  else delete holder[key];
}

// ---- Families ----

/** Other ends of a parameter, or another name. */
function changeParameter(chance, { claim }) {
  const parameter = chance.of(claim.parameters);
  const side = chance.of(["low", "high"]);
  const end = parameter[side];
  chance.of([
    () => (end[0] = end[0] === "open" ? "closed" : "open"),
    () => (end[0] = end[0] === "open" ? "closed" : "open"),
    () => (end[1] = fractionNear(chance, end[1], claim)),
    () => (end[1] = fractionNear(chance, end[1], claim)),
    () => ([parameter.low, parameter.high] = [parameter.high, parameter.low]),
    () => (parameter[side] = structuredClone(parameter[side === "low" ? "high" : "low"])),
    () => (parameter.name = chance.of(["a", "x1", "X", "", "a".repeat(17), claim.parameters[0].name])),
    () => claim.parameters.push({ ...structuredClone(parameter), name: "new" }),
  ])();
}

/** Another tree of halvings. */
function changeTree(chance, { claim, witness }) {
  const axis = chance.below(claim.parameters.length);
  const holders = [[witness, "tree"]];
  const visit = (node) => node.slice(1).forEach((half, i) => (holders.push([node, i + 1]), visit(half)));
  visit(witness.tree);
  const [holder, key] = chance.of(holders);
  holder[key] = chance.of([() => [axis, holder[key], structuredClone(holder[key])], () => [axis, [], []], () => [], () => [axis, [axis, [], []], holder[key]], () => [chance.below(4), [], []]])();
}

/** Another term of a value. */
function changeTerm(chance, certificate) {
  const { claim, witness } = certificate;
  const row = chance.of([...claim.gram, ...claim.gram, ...witness.vertices, ...(Array.isArray(claim.domain) ? claim.domain[1].vertices : [])]);
  const k = chance.index(row);
  const value = row[k];
  const powers = Array.from({ length: claim.parameters.length }, () => chance.of([0, 0, 1, 1, 2, 3]));
  const unit = narrow(wide(likeOf(claim)).map((_, i) => (i === 0 ? BigInt(chance.of([-1, 1, 2])) : 0n)), likeOf(claim));
  chance.of([
    () => (row[k] = withTerm(value, [unit, ...powers])),
    () => (row[k] = withTerm(value, [unit, ...powers])),
    () => value.splice(chance.index(value), 1),
    () => (chance.of(value)[1] += chance.of([-1, 1, 14])),
    () => value.reverse(),
    () => value.push(structuredClone(chance.of(value))),
    () => (chance.of(value)[0] = likeOf(claim)),
  ])();
  if (chance.below(8) > 0) {
    reduceGram(certificate);
    reduce(witness, claim);
  }
}

/** A tiling as a family, whose Gram matrix has a factor 1 + t, or 1 + t² - t: all angles are the same. */
export function asFamily(chance, { claim, witness, ...rest }) {
  if (claim.parameters || claim.domain[0] === "region") return;
  const value = (x) => (isZero(x) ? [] : [[x, 0]]);
  const powers = chance.of([[[1, 1]], [[-1, 1], [1, 2]]]);
  const stretched = (x) => (isZero(x) ? [] : [[x, 0], ...powers.map(([sign, e]) => [times(x, BigInt(sign)), e])]);
  const like = likeOf({ ...claim });
  const end = (n) => chance.of([["closed", [plusNumber(like, [BigInt(n)]), 1]], ["open", [plusNumber(like, [BigInt(n)]), 1]]]);
  const tree = chance.of([[], [0, [], []], [0, [0, [], []], []], [0, [], [0, [], [0, [], []]]]]);
  const values = (rows) => rows.map((row) => row.map(value));
  const domain = Array.isArray(claim.domain) ? [claim.domain[0], { ...claim.domain[1], vertices: values(claim.domain[1].vertices) }] : claim.domain;
  return {
    ...{ ...rest, kind: "family" },
    claim: {
      ...{ dimension: claim.dimension, field: claim.field, parameters: [{ name: "t", low: end(0), high: end(1) }] },
      ...{ gram: claim.gram.map((row) => row.map(stretched)), domain, statements: claim.statements },
    },
    witness: { denominator: witness.denominator, vertices: values(witness.vertices), boundary: [], tree, simplices: witness.simplices },
  };
}

// ---- Systems of patches ----

function changePatch(chance, { claim, witness }) {
  const patch = chance.of(witness);
  const tile = chance.of(claim.tiles);
  const [pyramid, row] = [chance.of(patch.pyramids), chance.of(patch.simplices)];
  const moved = (number) => plusNumber(number, [BigInt(chance.of([-1, 1, 2]))]);
  const point = chance.of([...patch.vertices, ...tile.vertices]);
  const offset = chance.of(patch.offsets);
  const k = chance.index(point);
  chance.of([
    () => (tile.classes[chance.index(tile.classes)] += chance.of([-1, 1])),
    () => (offset[0] = moved(offset[0])),
    () => (offset[0] = plusNumber(offset[0], [BigInt(patch.denominator)])),
    () => (point[k] = moved(point[k])),
    () => patch.simplices.splice(patch.simplices.indexOf(row), 1),
    () => patch.pyramids.splice(patch.pyramids.indexOf(pyramid), 1),
    () => pyramid[1].reverse(),
    () => pyramid[1].push(pyramid[1].shift()),
    () => pyramid[1].pop(),
    () => (pyramid[0] = chance.of(pyramid[1])),
    () => tile.vertices.push(tile.vertices.shift()),
    () => claim.tiles.push(structuredClone(tile)) && witness.push(structuredClone(patch)),
    () => claim.tiles.reverse() && witness.reverse(),
    () => (claim.gram = claim.gram.map((entries) => entries.map((x) => times(x, BigInt(chance.of([1, 2])))))),
    () => (claim.rank = 3 - claim.rank),
    () => claim.statements.push("TCP"),
  ])();
}

const KEEP = [relabel, moveVertex, exchangeRows];
const PATCHES = [changePatch, changePatch, changePatch, changePatch, changeBound, changePlane, changeAnything];
const FAMILY = [changeParameter, changeTree, changeTerm, changeTerm, changeTerm];
const BREAK = [nudge, nudge, stretch, changeBound, changeBound, changePlane, changeStatements, changeField, changeRow, changeRow, changeAnything, identify];
const REGION = [removeRow, secondPiece, secondPiece, identify, changeBoundary, changeRank];

/** Text that no writer gives. */
const TEXT = [
  (chance, text) => cut(chance, text, 1, ""),
  (chance, text) => cut(chance, text, 0, chance.of([..." \n,[]{}\"0-1:\t\\e"])),
  (chance, text) => cut(chance, text, 1, chance.of([..." \n,[]{}\"0123456789-:\\eEa"])),
  (chance, text) => text.slice(0, chance.below(text.length)),
  (chance, text) => text + chance.of(["\n", " ", "x", "{}"]),
  (chance, text) => chance.of(["\ufeff", " ", "["]) + text,
  (chance, text) => text.replace(/"[a-z]+":/, "$&1,$&"),
  (chance, text) => text.replace('"version":2', chance.of(['"version":1', '"version":2.0', '"version":3', '"version":2e0', '"version":"2"'])),
  (chance, text) => text.replace('"tiling"', chance.of(['"family"', '"Tiling"', "1"])),
];

function cut(chance, text, length, replacement) {
  const at = chance.below(text.length);
  return text.slice(0, at) + replacement + text.slice(at + length);
}

/** One certificate, changed once or a few times, as text. */
export function mutate(chance, text) {
  if (chance.below(16) === 0) return chance.of(TEXT)(chance, text);
  let certificate = JSON.parse(text);
  for (let i = 0; i === 0 || (i < 4 && chance.below(3) === 0); i++) attempt(() => chance.of(tableFor(chance, certificate))(chance, certificate));
  if (chance.below(4) === 0) attempt(() => (certificate = asFamily(chance, certificate) ?? certificate));
  return write(certificate);
}

function tableFor(chance, { claim }) {
  const kind = chance.below(12);
  if (claim.tiles) return PATCHES;
  if (kind === 0) return KEEP;
  if (kind < 6 && claim.parameters) return FAMILY;
  if (kind < 6 && claim.domain[0] === "region") return REGION;
  if (kind < 6 && Array.isArray(claim.domain)) return [changeDomain];
  if (kind === 6) return [changeRank, changeDomain, changeBoundary];
  return BREAK;
}

/** A change that a change before it has made impossible is left out. */
function attempt(change) {
  try {
    change();
  } catch (error) {
    if (!(error instanceof TypeError || error instanceof SyntaxError || error instanceof RangeError)) throw error;
  }
}
