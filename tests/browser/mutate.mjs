// Certificates, changed: a seeded generator of files that are nearly right, for the comparison of the two verifiers.
//
// Each mutation takes the parsed certificate and changes one thing, so that every later check of docs/format.md is met by files that
// pass the ones before it. `write` gives the canonical bytes, from docs/format.md alone; the mutations of text work on those.

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

/** The canonical text: the outer three levels on lines of their own. */
export function write(value, depth = 0) {
  const line = depth < 3 ? "\n" : "";
  const group = (open, close, items) => open + items.map((item, i) => (i > 0 ? "," : "") + line + item).join("") + line + close;
  const end = depth === 0 ? "\n" : "";
  if (Array.isArray(value)) return group("[", "]", value.map((item) => write(item, depth + 1)));
  if (value === null || typeof value !== "object") return JSON.stringify(value);
  const members = Object.entries(value).map(([name, item]) => `${JSON.stringify(name)}:${write(item, depth + 1)}`);
  return group("{", "}", members) + end;
}

// ---- Numbers as texts ----

const gcd = (a, b) => (b === 0n ? (a < 0n ? -a : a) : gcd(b, a % b));
const parse = (text) => text.split("/").concat("1").slice(0, 2).map(BigInt);

function ratio(p, q) {
  const d = gcd(p, q) * (q < 0n ? -1n : 1n);
  return q / d === 1n ? `${p / d}` : `${p / d}/${q / d}`;
}

function plus(x, y) {
  const [[p, q], [r, s]] = [parse(x), parse(y)];
  return ratio(p * s + r * q, q * s);
}

const list = (number) => [number].flat();

/** A number of the format from coefficients. */
function fromList(coefficients) {
  const kept = [...coefficients];
  while (kept.length > 1 && kept.at(-1) === "0") kept.pop();
  return kept.length === 1 ? kept[0] : kept;
}

const sum = (x, y) => fromList(Array.from({ length: Math.max(list(x).length, list(y).length) }, (_, k) => plus(list(x)[k] ?? "0", list(y)[k] ?? "0")));

const SMALL = ["1", "-1", "1/2", "-1/2", "1/3", "1/7", "-1/10", "1/100", "-1/1000", "1/100000", "-1/99999999999999999999", "2", "-3", "10"];
const ODD = [
  ...["", "-", "0/1", "1/1", "2/4", "-0", "+1", "01", "1e3", "1.0", "0x1", "1/0", "1/-2", "--1", "1/2/3", " 1", "1 ", "\u0661", "NaN", "1_0"],
  ...["1".repeat(999), "1".repeat(1000), "1".repeat(1001), "1/" + "3".repeat(999), "9".repeat(5000), "\n", "\u0000", "\u00e9", "1\\", '"', "\u{1f600}", "\u200b"],
];
const NUMBERS = ["0", "1", "-1", "1/2", "3", "-2/3", "1/97", "123456789/1000", ["0", "1"], ["1", "-1/2"], ["1", "1", "1"], ["1", "0"], [], ["1"]];

// ---- Mutations of the data ----

const rows = (certificate) => [certificate.claim.gram, certificate.witness.vertices, polytope(certificate)?.vertices ?? certificate.witness.vertices];
const polytope = ({ claim }) => (typeof claim.domain === "object" && claim.domain ? Object.values(claim.domain)[0] : undefined);

function entry(chance, table) {
  const line = chance.of(table);
  return [line, chance.index(line)];
}

function setGram(certificate, i, j, value) {
  certificate.claim.gram[i][j] = value;
  certificate.claim.gram[j][i] = value;
}

const shiftRow = (chance, rowOfShift, from) => {
  if (rowOfShift.length > from) rowOfShift[from + chance.below(rowOfShift.length - from)] += chance.of([1, -1, 2, 2 ** 31, -(2 ** 31), 2 ** 31 - 1, 1e15]);
};

function changeBound(chance, certificate) {
  const { statements } = certificate.claim;
  const bounds = statements.filter((statement) => typeof statement === "object");
  if (bounds.length === 0) return void statements.push({ "all dihedral angles below": chance.of(["60", "90", "120", "179", "180", "181", "0", "1/3"]) });
  const statement = chance.of(bounds);
  const [name] = Object.keys(statement);
  const near = ["1/100", "-1/100", "1/1000000", "-1/100000", "1", "-1", "-10", "30"];
  const some = ["60", "90", "45", "180", "0", "120", "-1", "181", "1/2", "7/10", "1", ...ODD];
  statement[name] = chance.below(3) > 0 ? plus(statement[name], chance.of(near)) : chance.of(some);
}

/** Makes more or other statements, mostly in order. */
function changeStatements(chance, certificate) {
  const all = ["face-to-face tiling", "acute", "nonobtuse", { "all dihedral angles below": "179" }, { "all dihedral angles above": "1" }];
  const rest = [{ "all radius-edge ratios below": chance.of(["1", "3/5", "1000", "2/3"]) }, "Delaunay", "weakly Delaunay", "TCP"];
  const given = new Map(certificate.claim.statements.map((statement) => [nameOf(statement), statement]));
  const chosen = [...all, ...rest].map((statement) => given.get(nameOf(statement)) ?? statement);
  certificate.claim.statements = chosen.filter((statement, i) => i === 0 || chance.below(2) === 0);
  const { statements } = certificate.claim;
  if (chance.below(6) === 0) statements.reverse();
  if (chance.below(6) === 0) statements.push(chance.of(statements));
}

const nameOf = (statement) => (typeof statement === "string" ? statement : Object.keys(statement)[0]);

function changeField(chance, certificate) {
  const { field } = certificate.claim;
  if (typeof field === "string") return void (certificate.claim.field = { "Q(a)": { polynomial: chance.of([["-3", "0", "1"], ["-2", "0", "1"], ["1", "-3", "0", "1"], ["0", "1"], ["-4", "0", "1"]]), root: ["1", "2"] } });
  const { polynomial, root } = field["Q(a)"];
  [
    () => (polynomial[chance.index(polynomial)] = chance.of(["0", "1", "-1", "5", "-3", "1/2", ...ODD])),
    () => (root[chance.below(2)] = chance.of(["0", "1", "-2", "7/4", "3/2", "5", "100", "-100", ...ODD])),
    () => root.reverse(),
    () => (root[chance.below(2)] = plus(root[0], chance.of(SMALL))),
    () => (field["Q(a)"].polynomial = timesLinear(polynomial, chance.of([5n, -7n, 0n, 1n, 2n]))),
    () => polynomial.push("1"),
    () => (field["Q(a)"].polynomial = [chance.of(["-3", "-2"]), ...Array(chance.below(40)).fill("0"), "1"]),
    () => (certificate.claim.field = "Q"),
    () => root.push("3"),
  ][chance.below(9)]();
}

/** p (x - c): a field given by a reducible polynomial. */
function timesLinear(p, c) {
  if (!p.every((text) => /^-?[0-9]+$/.test(text))) return p;
  return [...p, "0"].map((text, k) => `${(k > 0 ? BigInt(p[k - 1]) : 0n) - c * BigInt(k < p.length ? text : "0")}`);
}

function changeDomain(chance, certificate) {
  const { claim } = certificate;
  const solid = polytope(certificate);
  const kinds = ["space", "slab", "prism", "solid", "torus", "Q"];
  const face = solid && chance.of(solid.faces);
  const changes = [
    () => (claim.domain = chance.of(["space", "slab", "solid", "torus", "region", { region: null }, { space: null }, null])),
    () => solid && (claim.domain = { [chance.of(kinds)]: solid }),
    () => solid && solid.faces.splice(chance.index(solid.faces), 1),
    () => solid && solid.faces.push([...chance.of(solid.faces)]),
    () => solid && solid.vertices.push([...chance.of(solid.vertices)]),
    () => face && (face[chance.index(face)] = chance.below(9)),
    () => face && face.reverse(),
    () => face && face.push(chance.below(8)),
    () => face && face.length > 1 && ([face[0], face[1]] = [face[1], face[0]]),
    () => solid && solid.faces.reverse(),
    () => solid && (solid.vertices = solid.vertices.map((w) => w.map((x) => sum(x, "1/3")))),
  ];
  chance.of(changes)();
}

/** Takes one simplex out of a mesh, and puts its neighbours' facets into the boundary: a mesh still. */
function removeSimplex(chance, { witness }) {
  const s = chance.index(witness.simplices);
  witness.simplices.splice(s, 1);
  witness.mates.splice(s, 1);
  const renamed = (mate) => (mate.length < 2 || mate[0] < s ? mate : mate[0] === s ? [] : [mate[0] - 1, ...mate.slice(1)]);
  witness.mates = witness.mates.map((row) => row.map(renamed));
  dropUnused(witness);
}

function dropUnused({ vertices, simplices }) {
  const used = [...new Set(simplices.flat().map(([v]) => v))].sort((v, w) => v - w);
  vertices.splice(0, vertices.length, ...used.map((v) => vertices[v]));
  for (const corner of simplices.flat()) corner[0] = used.indexOf(corner[0]);
}

/** A second mesh, the same one moved: beside, inside of or across the first. */
function secondPiece(chance, { witness }) {
  const { vertices, simplices, mates } = structuredClone(witness);
  const [n, m] = [vertices.length, simplices.length];
  const isInside = chance.below(3) === 0;
  const by = vertices[0].map(() => (isInside ? chance.of(["1/7", "1/5", "2/7"]) : chance.of(["0", "0", "1", "-1", "1/2", "2", "1/7", "100"])));
  const size = chance.of(isInside ? ["1/2", "1/10", "1/40"] : ["1", "1", "1/2", "1/10", "3"]);
  const scaled = (x) => fromList(list(x).map((text) => ratio(parse(text)[0] * parse(size)[0], parse(text)[1] * parse(size)[1])));
  witness.vertices.push(...vertices.map((x) => x.map((entry, k) => sum(scaled(entry), by[k]))));
  witness.simplices.push(...simplices.map((corners) => corners.map(([v, ...shift]) => [v + n, ...shift])));
  witness.mates.push(...mates.map((row) => row.map((mate) => (mate.length > 1 ? [mate[0] + m, ...mate.slice(1)] : mate))));
}

/** Two vertices of a mesh become one. */
function identify(chance, { witness }) {
  const [v, w] = [chance.index(witness.vertices), chance.index(witness.vertices)];
  for (const corner of witness.simplices.flat()) if (corner[0] === w) corner[0] = v;
  dropUnused(witness);
}

/** A polytope written otherwise, or with a vertex moved. */
function rewritePolytope(chance, certificate) {
  const { vertices, faces } = polytope(certificate);
  const [f, g] = [chance.index(faces), chance.index(faces)];
  const other = (x) => (x === f ? g : x === g ? f : x);
  const [w, x] = [chance.index(vertices), chance.index(vertices)];
  const renamed = (v) => (v === w ? x : v === x ? w : v);
  const [line, k] = entry(chance, vertices);
  chance.of([
    () => {
      [faces[f], faces[g]] = [faces[g], faces[f]];
      for (const mate of certificate.witness.mates.flat()) if (mate.length === 1) mate[0] = other(mate[0]);
    },
    () => {
      [vertices[w], vertices[x]] = [vertices[x], vertices[w]];
      faces.forEach((face) => face.forEach((v, i) => (face[i] = renamed(v))));
    },
    () => faces[f].push(faces[f].shift()),
    () => faces[f].reverse(),
    () => (line[k] = sum(line[k], chance.of(SMALL))),
    () => ([faces[f][0], faces[f][1]] = [faces[f][1], faces[f][0]]),
    () => certificate.witness.mates.flat().forEach((mate) => mate.length === 1 && chance.below(4) === 0 && (mate[0] = f)),
  ])();
}

const SOLID = [rewritePolytope, rewritePolytope, rewritePolytope, changeDomain, nudge, changeStatements];
const MESH = [removeSimplex, secondPiece, secondPiece, identify, nudge, nudge, relabelSimplices];

/** Every simplex's facets keep their mates: a tiling stays one. */
function relabelSimplices(chance, { witness }) {
  const { simplices, mates } = witness;
  const [s, t] = [chance.index(simplices), chance.index(simplices)];
  const other = (x) => (x === s ? t : x === t ? s : x);
  [simplices[s], simplices[t]] = [simplices[t], simplices[s]];
  [mates[s], mates[t]] = [mates[t], mates[s]];
  for (const mate of mates.flat()) if (mate.length > 1) mate[0] = other(mate[0]);
}

/** Moves a vertex and nothing else: mostly a tiling still, with other angles. */
function nudge(chance, certificate) {
  const [line, i] = entry(chance, certificate.witness.vertices);
  line[i] = sum(line[i], chance.of(SMALL.slice(2, 11)));
}

/** Scales one metric, or stretches along one vector of the basis: a tiling still. */
function stretch(chance, certificate) {
  const i = chance.index(certificate.claim.gram);
  const factor = chance.of([["11", "10"], ["4", "3"], ["1", "7"], ["1000001", "1000000"], ["2", "1"]]);
  const times = (x) => fromList(list(x).map((text) => ratio(parse(text)[0] * BigInt(factor[0]), parse(text)[1] * BigInt(factor[1]))));
  const { gram } = certificate.claim;
  if (chance.below(3) === 0) certificate.claim.gram = gram.map((line) => line.map(times));
  else setGram(certificate, i, i, times(gram[i][i]));
}

function swapCorners(chance, { witness }) {
  const s = chance.index(witness.simplices);
  const [i, j] = [0, 1].map(() => chance.index(witness.simplices[s]));
  const swap = (line) => ([line[i], line[j]] = [line[j], line[i]]);
  swap(witness.simplices[s]);
  if (chance.below(2)) swap(witness.mates[s]);
}

const DATA = [
  nudge,
  nudge,
  nudge,
  stretch,
  stretch,
  changeBound,
  changeBound,
  changeStatements,
  changeStatements,
  changeField,
  changeDomain,
  relabelSimplices,
  swapCorners,
  (chance, certificate) => {
    const [line, i] = entry(chance, chance.of(rows(certificate)));
    line[i] = sum(line[i], chance.of(SMALL));
  },
  (chance, certificate) => {
    const [line, i] = entry(chance, chance.of(rows(certificate)));
    line[i] = chance.of([...ODD, ...NUMBERS]);
  },
  (chance, certificate) => setGram(certificate, ...[0, 1].map(() => chance.index(certificate.claim.gram)), chance.of(NUMBERS)),
  (chance, certificate) => {
    const { gram } = certificate.claim;
    const [i, j] = [chance.index(gram), chance.index(gram)];
    setGram(certificate, i, j, sum(gram[i][j], chance.of(SMALL)));
  },
  (chance, certificate) => {
    const [line, i] = entry(chance, chance.of(rows(certificate)));
    line[i] = fromList(list(line[i]).map((text) => (text.startsWith("-") ? text.slice(1) : text === "0" ? text : `-${text}`)));
  },
  (chance, { witness }) => (chance.of(chance.of(witness.simplices))[0] = chance.of([0, 1, 2, 3, witness.vertices.length, -1, 2 ** 53, 7])),
  (chance, { witness }) => shiftRow(chance, chance.of(chance.of(witness.simplices)), 1),
  (chance, { witness }) => shiftRow(chance, chance.of(chance.of(witness.mates)), 2),
  (chance, { witness }) => (chance.of(chance.of(witness.mates))[chance.below(2)] = chance.of([0, 1, 2, 3, 4, -1, witness.simplices.length])),
  (chance, { witness }) => {
    const row = chance.of(witness.mates);
    [row[0], row[1]] = [row[1], row[0]];
  },
  (chance, { witness }) => {
    const [s, t] = [chance.of(witness.mates), chance.of(witness.mates)];
    const [i, j] = [chance.index(s), chance.index(t)];
    [s[i], t[j]] = [t[j], s[i]];
  },
  (chance, { witness }) => {
    const row = chance.of(witness.mates);
    row[chance.index(row)] = chance.of([[], [0], [1], [0, 0], [0, 1, 0, 0, 0], [0, 1, 0, 0]]);
  },
  (chance, { witness }) => {
    const table = chance.of([witness.vertices, witness.simplices, witness.mates]);
    chance.of([() => table.splice(chance.index(table), 1), () => table.push(structuredClone(chance.of(table))), () => table.reverse()])();
  },
  (chance, { witness }) => {
    const line = chance.of(chance.of([witness.vertices, witness.simplices, witness.mates]));
    chance.of([() => line.pop(), () => line.push(structuredClone(line[0]))])();
  },
  (chance, { witness }) => {
    // A second copy of everything, matched with itself.
    const n = witness.simplices.length;
    witness.simplices.push(...structuredClone(witness.simplices));
    witness.mates.push(...structuredClone(witness.mates).map((row) => row.map((mate) => (mate.length > 1 ? [mate[0] + n, ...mate.slice(1)] : mate))));
  },
  (chance, certificate) => (certificate.claim.dimension = chance.of([2, 3, 0, 4, -1, 1.5, "3", 2 ** 53])),
  (chance, certificate) => (certificate.version = chance.of([0, 2, -1, 1.5, "1", null, 2 ** 53])),
  (chance, certificate) => (certificate.format = chance.of(["acutile", "", 1, null, "acutile-certificate\u0000", "\u{1f600}".repeat(300)])),
  (chance, certificate) => {
    const target = chance.of([certificate, certificate.claim, certificate.witness]);
    const name = chance.of(Object.keys(target));
    chance.of([
      () => delete target[name],
      () => (target[chance.of(["__proto__x", "constructor", "toString", "name", ""])] = 1),
      () => (target[name] = chance.of([null, true, [], {}, "", 0, [[]], [{}]])),
      () => {
        const value = target[name];
        delete target[name];
        target[name] = value;
      },
    ])();
  },
];

// ---- Mutations of the text ----

const LITERALS = ["1e3", "-0", "1.0", "null", "true", "0", "00", "-", "1E400", "9223372036854775808", "-9223372036854775808", "18446744073709551616", "[]", "{}", '""', "NaN", "[".repeat(200)];
const KEYS = ['"__proto__"', '"constructor"', '"form\\u0061t"', '"\\ud800"', '"\\udc00\\ud800"', '"\\ud83d\\ude00"', '"a\\x"', '"\\u00e9"', '"\u00e9"'];

const TEXT = [
  (chance, text) => cut(chance, text, 1, ""),
  (chance, text) => cut(chance, text, 0, chance.of([" ", "\n", ",", "[", "]", "{", "}", '"', "0", "-", "1", ":", "\t", "\ufeff", "\\", "/", "e"])),
  (chance, text) => cut(chance, text, 1, chance.of([..." \n,[]{}\"0123456789-/:\\eEa"])),
  (chance, text) => cut(chance, text, chance.below(60), ""),
  (chance, text) => text.slice(0, chance.below(text.length)),
  (chance, text) => text + chance.of(["\n", " ", "x", "null", "\u0000", "{}"]),
  (chance, text) => chance.of(["\ufeff", " ", "\n", "[", "//"]) + text,
  (chance, text) => replaceOne(chance, text, /-?[0-9]+(?=[,\]])/g, chance.of(LITERALS)),
  (chance, text) => replaceOne(chance, text, /"[a-z]+"(?=:)/g, chance.of(KEYS)),
  (chance, text) => replaceOne(chance, text, /"[a-z]+":/g, `${chance.of(KEYS)}:${chance.of(LITERALS)},$&`),
  (chance, text) => replaceOne(chance, text, /"[a-z]+":/g, "$&$&"),
  (chance, text) => replaceOne(chance, text, /"-?[0-9/]+"/g, chance.of(['["1"]', '"\\u0031"', "1", "null", '"1e3"', '"\\ud800"', '{"p":"1"}', "[]", '["1",["1"]]'])),
  (chance, text) => replaceOne(chance, text, /\n/g, chance.of(["", "\r\n", "\n\n", " "])),
  (chance, text) => text.replace('"space"', chance.of(['{"space":null}', '{"space":[]}', '"Space"', '{"space":null,"space":null}', '{"slab":null}'])),
  (chance, text) => text.replace('"Q"', chance.of(['{"Q":null}', '{"Q":[]}', '"Q(a)"', '{"Q(a)":[["-2","0","1"],["1","2"]]}'])),
  (chance, text) => text.replace(/"format":"[^"]*"/, chance.of(['"format":"other"', '"format":1', '"form":1', '"format":"other","x":[[[{"y":[1e999,"\\ud800"]}]]]'])),
  (chance, text) => text.replace(/"version":1/, chance.of(['"version":2', '"version":1.0', '"version":-0', '"version":1e0', '"version":2,"x":{"a":[}', '"version":18446744073709551615', '"version":18446744073709551616'])),
  (chance, text) => `[${text.replace(/"[a-z]+":/g, (key) => (["\"format\":", "\"version\":", "\"claim\":", "\"witness\":"].includes(key) ? "" : key)).trim().slice(1, -1)}]`,
  () => '["other",1]',
  (chance) => `["acutile-certificate",${chance.of(["1", "2", "1,{}", "1,{},{}"])}]`,
];

function cut(chance, text, length, replacement) {
  const at = chance.below(text.length);
  return text.slice(0, at) + replacement + text.slice(at + length);
}

function replaceOne(chance, text, pattern, replacement) {
  const matches = [...text.matchAll(pattern)];
  if (matches.length === 0) return text;
  const { index, 0: found } = chance.of(matches);
  return text.slice(0, index) + replacement.replaceAll("$&", () => found) + text.slice(index + found.length);
}

/** Raw bytes: a bit, a byte that is no UTF-8, or a piece exchanged. */
function changeBytes(chance, bytes) {
  const at = chance.below(bytes.length);
  if (chance.below(2)) bytes[at] ^= 1 << chance.below(8);
  else bytes[at] = chance.of([0xff, 0xc0, 0x80, 0xed, 0x00, 0x7f, 0xf5]);
  return bytes;
}

/** One certificate, changed once or a few times, as bytes. */
export function mutate(chance, bytes) {
  const text = new TextDecoder().decode(bytes);
  const kind = chance.below(16);
  if (kind === 0) return changeBytes(chance, Uint8Array.from(bytes));
  if (kind < 3) return encoded(chance.of(TEXT)(chance, text));
  const certificate = JSON.parse(text);
  for (let i = 0; i === 0 || (i < 4 && chance.below(3) === 0); i++) attempt(() => chance.of(tableFor(chance, certificate))(chance, certificate));
  const changed = write(certificate);
  return encoded(chance.below(20) === 0 ? chance.of(TEXT)(chance, changed) : changed);
}


/** What can be done to the kind of domain that it has, or what can be done to all. */
function tableFor(chance, certificate) {
  if (chance.below(3) === 0) return DATA;
  if (certificate.claim.domain === "region") return MESH;
  return polytope(certificate) ? SOLID : DATA;
}

const encoded = (text) => new TextEncoder().encode(text);

/** A change that a change before it has made impossible is left out. */
function attempt(change) {
  try {
    change();
  } catch (error) {
    if (!(error instanceof TypeError || error instanceof SyntaxError || error instanceof RangeError)) throw error;
  }
}
