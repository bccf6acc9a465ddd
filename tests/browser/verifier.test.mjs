// The JavaScript verifier against the folders of certificates, hand calculations, and the other verifiers. Run: node --test tests/browser
//
// ACUTILE_VERIFY names the Rust program, MUTATIONS how many changed certificates are compared, SEED the first of their seeds, ONLY a part of the
// names of the certificates that are changed; SHOW_CODES prints how often each pair of answers occurs.

import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { sha256, verify } from "../../verifiers/javascript/verifier.js";
import { ask, certificatesIn, OTHERS, outputOf, ROOT } from "./files.mjs";
import { Chance, mutate, toCbor, write } from "./mutate.mjs";

const SOURCE = join(ROOT, "verifiers/javascript/verifier.js");
const VERDICTS = new Map([["malformed", "malformed"], ["false", "rejected"], ["declined", "declined"]]);
const MUTATIONS = Number(process.env.MUTATIONS ?? 3000);
const SEED = Number(process.env.SEED ?? 1);
const textOf = (bytes) => new TextDecoder("utf-8", { ignoreBOM: true }).decode(bytes);
const digestOf = (bytes) => createHash("sha256").update(bytes).digest("hex");
const valid = (name) => JSON.parse(textOf(certificatesIn("tests/certificates/valid").find(({ stem }) => stem === name).bytes));

/** Another verifier counts other work; nothing states how much. */
const isComparable = ({ limits }) => limits.work === undefined;

for (const [folder, verdict] of VERDICTS) {
  test(`every file of ${folder} gets the code in its name`, () => {
    const files = certificatesIn(`tests/certificates/${folder}`).filter(isComparable);
    assert.ok(files.length >= 10);
    for (const { stem, bytes, limits } of files) {
      const answer = verify(bytes, limits);
      assert.deepEqual([stem, answer.verdict, answer.code], [stem, verdict, stem.split("--")[0]]);
      assert.deepEqual([answer.claim, answer.sha256], [[], null]);
    }
  });
}

for (const folder of ["tests/certificates/valid", "certificates"]) {
  test(`every file of ${folder} is verified`, () => {
    const files = certificatesIn(folder);
    assert.ok(files.length >= 30);
    for (const { name, bytes } of files) {
      const answer = verify(bytes);
      assert.equal(answer.verdict, "verified", `${name}: [${answer.code}] ${answer.message}`);
      const certificate = JSON.parse(textOf(bytes));
      assert.equal(answer.sha256, digestOf(Uint8Array.from(toCbor(certificate))), name);
      const { claim, witness } = certificate;
      const count = (name) => [witness].flat().reduce((sum, part) => sum + part[name].length, 0);
      assert.deepEqual(
        [answer.claim.length, answer.vertices, answer.simplices],
        [claim.statements.length, count("vertices"), count("simplices")],
      );
    }
  });
}

test("a text and its bytes are the same certificate", () => {
  for (const { bytes } of certificatesIn("tests/certificates/valid")) assert.deepEqual(verify(textOf(bytes)), verify(bytes));
});

// ---- Encodings ----

test("SHA-256 of every length around the blocks", () => {
  for (let length = 0; length < 200; length++) {
    const bytes = Uint8Array.from({ length }, (_, i) => (i * 37 + length) & 255);
    assert.equal(sha256(bytes), digestOf(bytes));
  }
  // FIPS 180-4, the example "abc".
  assert.equal(sha256(new TextEncoder().encode("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
});

// RFC 8949, appendix A; the integers of 64 bits and more are texts in JSON.
const CBOR = new Map([
  [0, "00"],
  [23, "17"],
  [24, "1818"],
  [255, "18ff"],
  [256, "190100"],
  [1000, "1903e8"],
  [1000000, "1a000f4240"],
  [1000000000000, "1b000000e8d4a51000"],
  ["18446744073709551615", "1bffffffffffffffff"],
  ["18446744073709551616", "c249010000000000000000"],
  ["-18446744073709551616", "3bffffffffffffffff"],
  ["-18446744073709551617", "c349010000000000000000"],
  [-1, "20"],
  [-100, "3863"],
  [-1000, "3903e7"],
  ["a", "6161"],
  ["IETF", "6449455446"],
  [[], "80"],
  [[1, [2, 3], [4, 5]], "8301820203820405"],
  [Array.from({ length: 25 }, (_, i) => i + 1), "98190102030405060708090a0b0c0d0e0f101112131415161718181819"],
  [{ format: "a", version: [-1] }, "826161" + "8120"], // An object is the array of its values.
]);

test("CBOR as in the examples of RFC 8949", async () => {
  const { writeCbor } = await inside("writeCbor");
  for (const [value, expected] of CBOR) {
    const bytes = [];
    writeCbor(value, (byte) => bytes.push(byte));
    assert.equal(Buffer.from(bytes).toString("hex"), expected);
    assert.equal(Buffer.from(toCbor(value)).toString("hex"), expected);
  }
});

test("hostile texts are malformed, and nothing is left behind", () => {
  const million = 1 << 20;
  const head = '{"format":"acutile-certificate","version":2,"kind":"tiling","claim":';
  const texts = new Map([
    ["[".repeat(million), "json"],
    ['{"a":'.repeat(million), "json"],
    [`${head}${"[".repeat(million)}${"]".repeat(million)},"witness":{}}`, "canonical"],
    [`{\n${head.slice(1).replaceAll(",", ",\n")}[\n[\n${"[".repeat(million)}${"]".repeat(million)}\n]\n],\n"witness":{}\n}\n`, "json"],
    ['{"__proto__":{"format":"acutile-certificate","version":2}}', "json"],
    [`${head}{"__proto__":{"dimension":2}},"witness":{}}`, "canonical"],
    [`{"format":"acutile-certificate","version":1e${"9".repeat(million)}}`, "json"],
    ['"\ud800"', "json"],
    ["\ufeff{}", "json"],
    ["", "json"],
    ["null", "json"],
    ['{"format":"acutile-certificate","version":2,}', "json"],
  ]);
  for (const [text, code] of texts) {
    const answer = verify(text);
    assert.deepEqual([answer.verdict, answer.code], ["malformed", code], text.slice(0, 90));
  }
  assert.deepEqual([Object.keys(Object.prototype), {}.format, {}.dimension], [[], undefined, undefined]);
});

test("a certificate in CBOR is declined, and another version too", () => {
  const bytes = certificatesIn("certificates")[0].bytes;
  assert.equal(verify(Uint8Array.from(toCbor(JSON.parse(textOf(bytes))))).code, "encoding");
  assert.equal(verify('{"format":"acutile-certificate","version":1}').code, "version");
  assert.equal(verify(textOf(bytes).replace('"version":2', '"version":3')).code, "version");
});

// ---- Limits ----

test("integers that would be expensive are declined before they are made", () => {
  const certificate = valid("plane-square");
  certificate.witness.vertices[0][0] = "7".repeat(30_000_000);
  const start = performance.now();
  assert.equal(verify(write(certificate)).code, "too-many-digits");
  assert.ok(performance.now() - start < 20_000);
});

test("limits are inclusive", () => {
  const certificate = valid("plane-square-triangle");
  const { witness, claim } = certificate;
  const text = write(certificate);
  const integers = text.match(/-?[0-9]+/g).map((digits) => BigInt(digits));
  const bits = Math.max(...integers.map((x) => (x < 0n ? -x : x).toString(2).length));
  const limits = { bytes: text.length, simplices: witness.simplices.length, degree: claim.field.polynomial.length - 1, bits };
  for (const [name, value] of Object.entries(limits)) {
    assert.equal(verify(text, { [name]: value }).verdict, "verified", name);
    assert.equal(verify(text, { [name]: value - 1 }).verdict, "declined", name);
  }
  assert.equal(verify(write(valid("region-cube-6")), { work: 10 }).code, "work");
});

test("limits are integers with known names", () => {
  for (const limits of [{ bytes: -1 }, { bytes: 1.5 }, { work: Infinity }, { depth: 3 }, { bits: "9" }]) assert.throws(() => verify("", limits), TypeError);
  assert.throws(() => verify(null), TypeError);
});

test("a page can embed the module", () => {
  const source = readFileSync(SOURCE, "utf8");
  assert.doesNotMatch(source, /<\/script|<!--|^import\b|\b(import|require|fetch|eval|Function)\(|Math\.random|\bDate\b/im);
});

test("sigma takes less than two seconds", () => {
  const { bytes } = certificatesIn("certificates").find(({ name }) => name === "sigma.json");
  const start = performance.now();
  assert.equal(verify(bytes).verdict, "verified");
  assert.ok(performance.now() - start < 2000);
});

// ---- Bounds by hand ----

/** A relation's verdict for a quantity that is less than the bound, equal to it, or more. */
const BY_HAND = new Map([
  ["less than", ["verified", "rejected", "rejected"]],
  ["at most", ["verified", "verified", "rejected"]],
  ["maximum", ["rejected", "verified", "rejected"]],
  ["more than", ["rejected", "rejected", "verified"]],
  ["at least", ["rejected", "verified", "verified"]],
  ["minimum", ["rejected", "verified", "rejected"]],
]);

// All angles of the equilateral triangle are arccos 1/2, and R² = l² / 3. A bound of 1/5 or 1/3 on the squared cosine is above or below the angle.
const TRIANGLE = [
  ["largest dihedral angle", [[1, [1, 5]], [1, [1, 4]], [1, [1, 3]]]],
  ["smallest dihedral angle", [[0, [0, 1]], [1, [1, 4]], [1, [1, 1]]]],
  ["largest dihedral angle", [[-1, [1, 4]], [1, [1, 4]], [1, [251, 1000]]]],
  ["squared radius-edge ratio", [[[1, 2]], [[1, 3]], [[1, 4]]]],
];

test("every relation holds as calculated by hand for the equilateral triangle", () => {
  const certificate = valid("plane-equilateral");
  for (const [name, bounds] of TRIANGLE) {
    for (const [relation, verdicts] of BY_HAND) {
      bounds.forEach((bound, i) => {
        certificate.claim.statements = ["face-to-face tiling", [name, relation, ...bound]];
        const { verdict } = verify(write(certificate));
        assert.equal(verdict, verdicts[i], `${name} ${relation} ${bound}`);
      });
    }
  }
});

// The right triangle with the sides 1, 1, √2: R² = 1/2, the angles are 45° and 90°. Each triangle has the smallest angle and the largest.
test("largest and smallest angle of a right triangle", () => {
  const certificate = valid("plane-square");
  const said = (...statement) => {
    certificate.claim.statements = ["face-to-face tiling", statement];
    return verify(write(certificate)).code;
  };
  assert.equal(said("largest dihedral angle", "maximum", 0, [0, 1]), null);
  assert.equal(said("largest dihedral angle", "minimum", 0, [0, 1]), null);
  assert.equal(said("smallest dihedral angle", "maximum", 1, [1, 2]), null);
  assert.equal(said("smallest dihedral angle", "minimum", 1, [1, 2]), null);
  assert.equal(said("smallest dihedral angle", "more than", 1, [1, 2]), "angle-bound");
  assert.equal(said("squared radius-edge ratio", "maximum", [1, 2]), null);
  assert.equal(said("squared radius-edge ratio", "less than", [1, 2]), "ratio-bound");
  assert.equal(said("squared radius-edge ratio", "minimum", [1, 3]), "not-attained");
});

// ---- Functions of the module against schoolbook ones ----

/** The module's own functions, which it does not export. */
async function inside(...names) {
  const source = readFileSync(SOURCE, "utf8");
  return import(`data:text/javascript,${encodeURIComponent(`${source}\nexport { ${names} };`)}`);
}

test("products in Z[a] are those of polynomials, less multiples of the field's", async () => {
  const { Ring } = await inside("Ring");
  const chance = new Chance(3);
  const some = (length) => Array.from({ length }, () => BigInt(chance.below(41) - 20) ** BigInt(1 + chance.below(9)));
  for (let round = 0; round < 500; round++) {
    const n = 2 + chance.below(7);
    const modulus = [...some(n), 1n];
    const [x, y] = [some(n), some(n)];
    const rest = new Array(2 * n).fill(0n);
    x.forEach((c, i) => y.forEach((d, j) => (rest[i + j] += c * d)));
    for (let top = rest.length - 1; top >= n; top--) {
      const factor = rest[top];
      modulus.forEach((c, i) => (rest[top - n + i] -= factor * c));
    }
    assert.deepEqual(new Ring(modulus).times(x, y), rest.slice(0, n));
  }
});

// Convergents of √2 are alternately less and more; with integer bounds: √2 is between 1 and 2, 1000 √2 between 1414 and 1415.
test("signs and bounds of a + b √2", async () => {
  const { Ring, rungsFrom } = await inside("Ring", "rungsFrom");
  const ring = new Ring([-2n, 0n, 1n], rungsFrom([-2n, 0n, 1n], 1n, 2n, 1n));
  const cases = [[0n, 0n, 0], [3n, -2n, 1], [7n, -5n, -1], [577n, -408n, 1], [1393n, -985n, -1], [-1n, 0n, -1], [0n, 1n, 1]];
  for (const [p, q, expected] of cases) assert.equal(ring.sign([p, q]), expected);
  assert.deepEqual([ring.bounds([0n, 1n], 1000n), ring.bounds([0n, -1n], 1n), ring.bounds([5n, 0n], 3n)], [[1414n, 1415n], [-2n, -1n], [15n, 15n]]);
});

// ---- Signs of polynomials on boxes ----

/** Coefficients from the constant term up. */
const timesPolynomial = (p, q) => Array.from({ length: p.length + q.length - 1 }, (_, k) => p.reduce((sum, c, i) => sum + c * (q[k - i] ?? 0n), 0n));

/** A product of factors, most of whose roots are known, in twelfths of the box from 0 to 1; and its values in 24ths, times positive numbers. */
function polynomialWithRoots(chance) {
  const roots = Array.from({ length: 1 + chance.below(3) }, () => ({ at: chance.of([0, 0, 12, 12, 6, 3, 4, -5, 13]), order: 1 + chance.below(3) }));
  let p = [chance.of([1n, 1n, -1n, 7n])];
  for (const { at, order } of roots) for (let i = 0; i < order; i++) p = timesPolynomial(p, [-BigInt(at), 12n]);
  if (chance.below(3) === 0) p = timesPolynomial(p, [chance.of([37n, 1n]), -12n, chance.of([1n, 10n]) * 2n]);
  const value = (twelfths) => p.reduce((sum, c, k) => sum + c * BigInt(twelfths) ** BigInt(k) * 24n ** BigInt(p.length - 1 - k), 0n);
  return { p, value };
}

test("signs of polynomials with known roots", async () => {
  const { Box, Polynomial, PolynomialRing, Ring, Work } = await inside("Box", "Polynomial", "PolynomialRing", "Ring", "Work");
  const ring = new PolynomialRing(new Ring(), ["t"]);
  const chance = new Chance(11);
  const seen = [0, 0, 0];
  for (let round = 0; round < 3000; round++) {
    const closed = [chance.below(2) === 0, chance.below(2) === 0];
    const tiling = { ring, work: new Work(Infinity) };
    const box = new Box(tiling, [{ low: [0n], high: [1n], unit: 1n, closed }]);
    const { p, value } = polynomialWithRoots(chance);
    const polynomial = new Polynomial(ring, new Map(p.map((c, k) => [BigInt(k), [c]]).filter(([, [c]]) => c !== 0n)));
    // There is such a point between any two of the known roots.
    const inside = Array.from({ length: 23 }, (_, i) => value(i + 1));
    const ends = [0, 24].filter((_, end) => closed[end]).map(value);
    const all = [...inside, ...ends];
    const [isPositive, isNotNegative] = [box.positive(polynomial, () => ""), box.atLeastZero(polynomial, () => "")];
    if (isPositive) assert.ok(all.every((x) => x > 0n), JSON.stringify([String(p), closed]));
    if (isNotNegative) assert.ok(all.every((x) => x >= 0n), JSON.stringify([String(p), closed]));
    assert.ok(!isPositive || isNotNegative);
    assert.equal(box.zero(polynomial, () => ""), false);
    seen[isPositive ? 0 : isNotNegative ? 1 : 2]++;
  }
  assert.ok(Math.min(...seen) > 100, String(seen));
});

// (x - y)² + c on the unit square, and x² y: by hand. On the diagonal the middle coefficient is c - 1/2 and the corners are c, c + 1.
const SQUARE = [
  ["x + y", [[1n, 0, 1], [1n, 1, 0]], [[false, true], [true, true]], true, true],
  ["x + y with the corner", [[1n, 0, 1], [1n, 1, 0]], [[true, true], [true, true]], false, true],
  ["x y without its sides", [[1n, 1, 1]], [[false, true], [false, true]], true, true],
  ["x y with a side", [[1n, 1, 1]], [[true, true], [false, true]], false, true],
  ["x y with an open corner", [[1n, 1, 1]], [[false, false], [false, false]], true, true],
  ["2 (x - y)² + 1", [[1n, 0, 0], [2n, 0, 2], [-4n, 1, 1], [2n, 2, 0]], [[true, true], [true, true]], true, true],
  ["4 (x - y)² + 1", [[1n, 0, 0], [4n, 0, 2], [-8n, 1, 1], [4n, 2, 0]], [[true, true], [true, true]], false, false],
  ["(1 - x) (1 - y) open at 1", [[1n, 0, 0], [-1n, 0, 1], [-1n, 1, 0], [1n, 1, 1]], [[true, false], [true, false]], true, true],
  ["(1 - x) (1 - y) half open", [[1n, 0, 0], [-1n, 0, 1], [-1n, 1, 0], [1n, 1, 1]], [[true, false], [true, true]], false, true],
  ["-x", [[-1n, 1, 0]], [[false, true], [true, true]], false, false],
];

test("signs of polynomials on the unit square by hand", async () => {
  const { Box, Polynomial, PolynomialRing, Ring, Work, keyOf } = await inside("Box", "Polynomial", "PolynomialRing", "Ring", "Work", "keyOf");
  const ring = new PolynomialRing(new Ring(), ["x", "y"]);
  for (const [name, terms, closed, isPositive, isNotNegative] of SQUARE) {
    const box = new Box({ ring, work: new Work(Infinity) }, closed.map((ends) => ({ low: [0n], high: [1n], unit: 1n, closed: ends })));
    const polynomial = new Polynomial(ring, new Map(terms.map(([c, ...powers]) => [keyOf(powers), [c]])));
    assert.deepEqual([name, box.positive(polynomial, () => ""), box.atLeastZero(polynomial, () => "")], [name, isPositive, isNotNegative]);
  }
});

/** A family of rectangles with this square of a side: it is verified exactly if the polynomial is shown to be positive. */
function rectangles(terms, parameters, tree) {
  const constant = (c) => (c === 0 ? [] : [[c, ...parameters.map(() => 0)]]);
  return write({
    ...{ format: "acutile-certificate", version: 2, kind: "family" },
    claim: { dimension: 2, field: "Q", parameters, gram: [[terms, constant(0)], [constant(1)]], domain: "space", statements: ["face-to-face tiling"] },
    witness: { denominator: 1, vertices: [[[], []]], boundary: [], tree, simplices: [[0, [0, 1, 0], [0, 0, 1]], [0, [0, 1, -1], [0, 1, 0]]] },
  });
}

test("the verifiers decide the same signs of random polynomials", () => {
  const chance = new Chance(SEED);
  const files = Array.from({ length: Math.min(MUTATIONS, 400) }, (_, i) => {
    const count = 1 + chance.below(2);
    const parameters = Array.from({ length: count }, (_, k) => {
      const low = chance.below(5) - 3;
      const end = (x) => [chance.of(["closed", "open"]), [x, 1]];
      return { name: `x${k}`, low: end(low), high: end(low + 1 + chance.below(3)) };
    });
    const terms = new Map(parameters.map((_, k) => [parameters.map((_, l) => Number(k === l)).join(), chance.of([-2, -1, 1, 2, 3])]));
    for (let j = chance.below(5); j >= 0; j--) terms.set(parameters.map(() => chance.below(4)).join(), chance.of([-3, -1, 1, 1, 2, 4]));
    terms.set(parameters.map(() => 0).join(), chance.of([1, 1, 2, 3, 5, 9, 20]));
    const rows = [...terms].map(([powers, c]) => [c, ...powers.split(",").map(Number)]);
    rows.sort(([, ...p], [, ...q]) => p[0] - q[0] || (p[1] ?? 0) - (q[1] ?? 0));
    const tree = chance.of([[], [], [0, [], []], [count - 1, [0, [], []], [0, [], [0, [], []]]]]);
    return { name: `polynomial ${i}`, text: rectangles(rows, parameters, tree) };
  });
  const counts = new Map();
  for (const { text } of files) {
    const { verdict } = verify(text);
    counts.set(verdict, (counts.get(verdict) ?? 0) + 1);
  }
  assert.ok(["verified", "rejected", "declined"].every((verdict) => counts.get(verdict) > files.length / 50), JSON.stringify([...counts]));
  for (const other of OTHERS) compareTexts(other, files, true);
});

/** A module's tiling of nothing, over Q, with the unit metric. */
async function unitSpace(dimension, ...names) {
  const module = await inside("Ring", "Work", ...names);
  const ring = new module.Ring();
  const unit = Array.from({ length: dimension }, (_, i) => Array.from({ length: dimension }, (_, j) => [i === j ? 1n : 0n]));
  return { ...module, tiling: { ring, dimension, gram: unit, dualGram: unit, determinantOfGram: [1n], denominator: 1n, work: new module.Work(Infinity) } };
}

const element = (x) => [BigInt(x)];
const rank0 = (points) => ({ vertices: points.map((point) => point.map(element)) });

// The corner of a cube: centre (1/2, 1/2, 1/2), R² = 3/4, det E = 1. Powers: (1,1,1) 0, (2,0,0) 2, (1,1,0) 0, (1,0,-1) 2, (0,0,0) 0.
test("normals, radius and power of the corner of a cube", async () => {
  const { Simplex, tiling } = await unitSpace(3, "Simplex");
  const points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]].map((point) => point.map(element));
  const simplex = new Simplex(tiling, points, 0);
  assert.deepEqual(simplex.determinant, [1n]);
  assert.deepEqual(simplex.normals, [[-1, -1, -1], [1, 0, 0], [0, 1, 0], [0, 0, 1]].map((row) => row.map(element)));
  assert.deepEqual(simplex.radius(), [[12n], 16n]); // 16 det M R² = 12
  const powers = [[1, 1, 1], [2, 0, 0], [1, 1, 0], [1, 0, -1], [0, 0, 0]].map((w) => simplex.power(w.map(element))[0]);
  assert.deepEqual(powers, [0n, 2n, 0n, 2n, 0n]);
});

// Segments of the plane, by inspection.
test("segments meet", async () => {
  const { segmentsMeet, tiling } = await unitSpace(2, "segmentsMeet");
  const cases = [
    [[0, 0], [2, 2], [0, 2], [2, 0], true], // cross
    [[0, 0], [2, 0], [1, 0], [1, 2], true], // an end on the other
    [[0, 0], [2, 0], [1, 1], [1, 2], false], // on one side
    [[0, 0], [2, 0], [3, 0], [4, 0], false], // on one line
    [[0, 0], [2, 0], [1, 0], [4, 0], true],
    [[0, 0], [4, 0], [1, 0], [2, 0], true],
    [[0, 0], [2, 0], [2, 0], [3, 0], true],
    [[0, 0], [2, 2], [3, 1], [2, 0], false],
  ];
  for (const [p, q, u, v, expected] of cases) {
    const [f, g] = [[p, q], [u, v]].map((points) => points.map((point) => point.map(element)));
    assert.deepEqual([segmentsMeet(tiling, f, g), segmentsMeet(tiling, g, f), segmentsMeet(tiling, f.toReversed(), g)], [expected, expected, expected]);
  }
});

// ---- Boundary facets, against separating functionals ----

const minus = (x, y) => x.map((entry, k) => entry - y[k]);
const dot = (x, y) => x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
const cross = (x, y) => [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
const edgesOf = (p) => (p.length === 2 ? [minus(p[1], p[0])] : p.map((x, i) => minus(p[(i + 1) % 3], x)));

/** A plane is strictly between a triangle p and a triangle or segment q: the facets of p - q have no other normals than these. */
function isSeparated(p, q) {
  const [e, f] = [edgesOf(p), edgesOf(q)];
  const normals = [e, f].filter((edges) => edges.length === 3).map((edges) => cross(edges[0], edges[1]));
  const inPlane = normals.flatMap((n) => [...e, ...f].map((edge) => cross(n, edge)));
  return [...normals, ...inPlane, ...e.flatMap((x) => f.map((y) => cross(x, y)))].some((w) => {
    const [atP, atQ] = [p, q].map((points) => points.map((x) => dot(w, x)));
    return Math.max(...atP) < Math.min(...atQ) || Math.max(...atQ) < Math.min(...atP);
  });
}

/** Random triangles that are not flat, as six points. */
function* pairsOfTriangles(chance, change) {
  for (;;) {
    const width = chance.of([[3, 3, 3], [4, 4, 1], [2, 2, 2], [5, 5, 2]]);
    const points = Array.from({ length: 6 }, () => width.map((w) => chance.below(w)));
    change(points);
    const triangles = [points.slice(0, 3), points.slice(3)];
    if (triangles.every((corners) => cross(...edgesOf(corners)).some((entry) => entry !== 0))) yield triangles;
  }
}

test("edges cut triangles where no plane is between them", async () => {
  const { cuts, meetInShared, surfaceOf, tiling } = await unitSpace(3, "cuts", "meetInShared", "surfaceOf");
  const seen = [0, 0, 0, 0];
  for (const [p, q] of pairsOfTriangles(new Chance(7), () => {})) {
    Object.assign(tiling, rank0([...p, ...q]));
    const [f, g] = [[0, 1, 2], [3, 4, 5]].map((corners) => surfaceOf(tiling, 0, corners.map((v) => [v])));
    const answers = [meetInShared(tiling, f, g), cuts(tiling, f.points.slice(0, 2), g)];
    assert.deepEqual(answers, [isSeparated(p, q), !isSeparated(q, p.slice(0, 2))], JSON.stringify([p, q]));
    seen[2 * Number(answers[0]) + Number(answers[1])]++;
    if (seen.reduce((x, y) => x + y) === 6000) break;
  }
  assert.ok(seen[0] > 300 && seen[1] > 300 && seen[2] > 300 && seen[3] === 0, String(seen));
});

/** With a common corner they meet there alone exactly if, drawn nearer to it, the opposite edges are apart from the triangles. */
test("triangles with one or two common corners", async () => {
  const { meetInShared, surfaceOf, tiling } = await unitSpace(3, "meetInShared", "surfaceOf");
  const seen = [0, 0];
  const shareOne = (points) => (points[3] = points[0]);
  for (const [p, q] of pairsOfTriangles(new Chance(8), shareOne)) {
    Object.assign(tiling, rank0([...p, ...q]));
    const [f, g] = [[0, 1, 2], [0, 4, 5]].map((corners) => surfaceOf(tiling, 0, corners.map((v) => [v])));
    const expected = isSeparated(q, p.slice(1)) && isSeparated(p, q.slice(1));
    assert.equal(meetInShared(tiling, f, g), expected, JSON.stringify([p, q]));
    if (++seen[Number(expected)] > 500 && Math.min(...seen) > 500) break;
  }
  // Two common corners: the third ones are apart unless they are on one side in one plane.
  const two = [[[1, 1, 0], false], [[1, 2, 0], false], [[1, -1, 0], true], [[1, 1, 1], true], [[1, -1, 1], true], [[5, 3, 0], false]];
  for (const [q, expected] of two) {
    Object.assign(tiling, rank0([[0, 0, 0], [2, 0, 0], [0, 2, 0], q]));
    const [f, g] = [[0, 1, 2], [0, 1, 3]].map((corners) => surfaceOf(tiling, 0, corners.map((v) => [v])));
    assert.equal(meetInShared(tiling, f, g), expected, String(q));
  }
});

test("overlapping boxes are found, with all translates", async () => {
  const { eachOverlap, boxOf, tiling } = await unitSpace(3, "eachOverlap", "boxOf");
  const chance = new Chance(9);
  for (let round = 0; round < 60; round++) {
    const rank = chance.below(4);
    const denominator = 1 + chance.below(7);
    Object.assign(tiling, { rank, denominator: BigInt(denominator) });
    const some = (n) => Array.from({ length: n }, () => {
      const low = [0, 1, 2].map(() => chance.below(30) - 15);
      return [low, low.map((x) => x + chance.below(9))];
    });
    const [first, second] = [some(5), some(5)];
    const found = new Set();
    const boxes = ([low, high]) => boxOf(tiling, [low, high].map((point) => point.map(element)));
    eachOverlap(tiling, first.map(boxes), second.map(boxes), (a, b, shift) => {
      assert.ok(!found.has(`${a} ${b} ${shift}`), "once");
      found.add(`${a} ${b} ${shift}`);
    });
    const range = Array.from({ length: 99 }, (_, i) => i - 49);
    const expected = new Set();
    first.forEach(([low, high], a) => second.forEach(([least, most], b) => {
      const along = [0, 1, 2].map((k) => (k < rank ? range : [0]).filter((s) => low[k] <= most[k] + s * denominator && least[k] + s * denominator <= high[k]));
      for (const x of along[0]) for (const y of along[1]) for (const z of along[2]) expected.add(`${a} ${b} ${[x, y, z].slice(0, rank)}`);
    }));
    assert.deepEqual([...found].sort(), [...expected].sort());
  }
});

// ---- Pieces of a region, by inspection ----

/** A region of the plane from triangles without common vertices, their corners counterclockwise and in units of 1 / denominator. */
function pieces(rank, denominator, triangles) {
  const short = (x) => (x > -(2n ** 53n) && x < 2n ** 53n ? Number(x) : `${x}`);
  const rows = triangles.map((_, i) => [3 * i, 3 * i + 1, 3 * i + 2]);
  return write({
    ...{ format: "acutile-certificate", version: 2, kind: "tiling" },
    claim: { dimension: 2, field: "Q", gram: [[1, 0], [1]], domain: ["region", rank], statements: ["face-to-face tiling"] },
    witness: {
      denominator,
      vertices: triangles.flat().map((point) => point.map((x) => short(BigInt(x)))),
      boundary: rows.flatMap(([a, b, c]) => [[a, b], [b, c], [c, a]]),
      simplices: rows,
    },
  });
}

/** A right triangle from its corner, with legs of the same length. */
const triangleAt = (x, y, leg) => [[BigInt(x), BigInt(y)], [BigInt(x) + BigInt(leg), BigInt(y)], [BigInt(x), BigInt(y) + BigInt(leg)]];

const PIECES = [
  ["a triangle wider than the cell meets its own translate", 1, 2, [[[0, 0], [3, 0], [0, 2]]], "boundary-meets"],
  ["a triangle of half a cell does not", 1, 2, [triangleAt(0, 0, 1)], null],
  ["a triangle as wide as the cell meets its translate in a corner that has two names", 1, 1, [triangleAt(0, 0, 1)], "boundary-meets"],
  ["without a lattice nothing meets", 0, 1, [triangleAt(0, 0, 2)], null],
  ...[0n, 5n, -3n, 2n ** 60n + 1n, -(2n ** 200n) - 1n].flatMap((cells) => [
    [`across, ${cells} cells on`, 1, 4, [triangleAt(0, 0, 2), triangleAt(4n * cells + 1n, 0, 2)], "boundary-meets"],
    [`inside, ${cells} cells on`, 1, 401, [triangleAt(0, 0, 200), triangleAt(401n * cells + 10n, 10, 50)], "covering"],
    [`beside, ${cells} cells on`, 1, 401, [triangleAt(0, 0, 180), triangleAt(401n * cells + 190n, 0, 180)], null],
    [`across in the second direction, ${cells} cells on`, 2, 8, [triangleAt(0, 0, 4), triangleAt(1, 8n * cells + 1n, 4)], "boundary-meets"],
  ]),
];

for (const [name, rank, denominator, triangles, code] of PIECES) {
  test(name, () => {
    const text = pieces(rank, denominator, triangles);
    assert.equal(verify(text).code, code);
    for (const other of OTHERS) compareTexts(other, [{ name, text }], false);
  });
}

// ---- Against the other verifiers ----

const BATCH = 100;

test("the command line prints a line for each file and ends with the right code", () => {
  const program = join(ROOT, "verifiers/javascript/verify-cli.mjs");
  const files = ["valid/plane-square", "false/not-acute--cube-6"].map((file) => join(ROOT, `tests/certificates/${file}.json`));
  const lines = outputOf(process.execPath, [program, ...files, "no\nfile: verified: "]).trimEnd().split("\n");
  assert.equal(lines.length, 3);
  assert.match(lines[0], /: verified: .*sha256 [0-9a-f]{64}\)$/);
  assert.match(lines[1], /: rejected \[not-acute\] /);
  assert.match(lines[2], /^"no\\u000afile: verified: ": unreadable: /);
});

// tests/bundle/certificates.py compares verify.py with the codes in the names of these files.
test("acutile-verify says the same of every file", () => {
  const folders = [...VERDICTS.keys(), "valid"].map((folder) => `tests/certificates/${folder}`);
  const files = [...folders, "certificates"].flatMap(certificatesIn).filter(({ limits }) => Object.keys(limits).length === 0);
  const rust = OTHERS.find(({ name }) => name === "acutile-verify");
  compareTexts(rust, files.map(({ bytes, path }) => ({ text: textOf(bytes), bytes, name: path })), true);
});

test(`the verifiers say the same of ${MUTATIONS} changed certificates`, { timeout: 3_600_000 }, () => {
  const bases = ["certificates", "tests/certificates/valid"]
    .flatMap(certificatesIn)
    .filter(({ bytes, name }) => bytes.length < 9_000 && name.includes(process.env.ONLY ?? ""))
    .map(({ bytes, name }) => ({ name, text: textOf(bytes) }));
  const seen = new Map();
  for (let first = 0; first < MUTATIONS; first += BATCH) {
    const files = Array.from({ length: Math.min(BATCH, MUTATIONS - first) }, (_, k) => {
      const chance = new Chance(SEED + first + k);
      const base = chance.of(bases);
      return { name: `${base.name}, seed ${SEED + first + k}`, text: mutate(chance, base.text) };
    });
    // The Python verifier is slow: one encoding in each batch.
    const skipped = ["verify.py", "verify.py on CBOR"][(first / BATCH) % 2];
    for (const other of OTHERS.filter(({ name }) => name !== skipped)) compareTexts(other, files, false, seen);
  }
  if (process.env.SHOW_CODES) console.log([...seen].sort().map(([pair, count]) => `${count} ${pair}`).join("\n"));
  const codes = new Set([...seen.keys()].map((pair) => pair.split(" ")[1]));
  if (MUTATIONS >= 2000 && !process.env.ONLY) assert.ok(codes.size >= 30, `only ${codes.size} codes are met: ${[...codes]}`);
});

/** Nobody accepts what another one refuses; declined agrees with everything. Files with one fault have one code, and all of them one digest. */
function compareTexts(other, files, hasOneFault, seen = new Map()) {
  const folder = mkdtempSync(join(tmpdir(), "acutile-verifiers-"));
  try {
    const chosen = files.map((file) => ({ ...file, data: dataFor(other, file) })).filter(({ data }) => data !== undefined);
    const paths = chosen.map(({ data }, i) => {
      const path = join(folder, `${i}.${other.reads}`);
      writeFileSync(path, data);
      return path;
    });
    const answers = paths.length > 0 ? ask(other, paths) : [];
    chosen.forEach((file, i) => compareAnswers(other, file, verify(file.bytes ?? file.text), answers[i], hasOneFault, seen));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** The file in the encoding that a program reads; undefined where what is wrong with the JSON has no place in CBOR. */
function dataFor({ reads }, { text, bytes }) {
  if (reads === "json") return bytes ?? text;
  try {
    const tree = JSON.parse(text);
    const { claim, witness } = tree;
    const parts = claim.tiles ? [...claim.tiles, ...witness] : [witness, claim.domain[1], ...(claim.parameters ?? [])];
    const records = [tree, claim, claim.field, claim.field.root, ...parts];
    const isPlain = write(tree) === text && namesAreRight(tree) && !records.some(Array.isArray);
    const data = isPlain ? toCbor(tree) : undefined;
    return data && Uint8Array.from(data);
  } catch {
    return undefined;
  }
}

const RECORDS = [
  ["format", "version", "kind", "claim", "witness"],
  ["dimension", "field", "gram", "domain", "statements"],
  ["dimension", "field", "parameters", "gram", "domain", "statements"],
  ["name", "low", "high"],
  ["field", "gram", "rank", "tiles", "statements"],
  ["denominator", "vertices", "classes"],
  ["denominator", "offsets", "vertices", "pyramids", "simplices"],
  ["denominator", "vertices", "boundary", "simplices"],
  ["denominator", "vertices", "boundary", "tree", "simplices"],
  ["polynomial", "root"],
  ["low", "high", "denominator"],
  ["denominator", "vertices", "faces"],
].map((names) => names.join());

/**
 * CBOR has no names, so the objects have those of the grammar, and no array stands for one. A small integer as a text would be another
 * certificate. The kernel reads no text that is longer than those of the grammar.
 */
function namesAreRight(tree) {
  if (typeof tree === "string" && /[^-0-9]/.test(tree) && tree.length > 40) return false;
  if (typeof tree === "string") return !/^-?[0-9]{1,16}$/.test(tree) || (tree.length > 15 && BigInt(tree) ** 2n >= 2n ** 106n);
  if (tree === null || typeof tree !== "object") return true;
  return (Array.isArray(tree) || RECORDS.includes(Object.keys(tree).join())) && Object.values(tree).every(namesAreRight);
}

const WORDS = { verified: "accepted", rejected: "refused", malformed: "refused", declined: "declined" };
const codeOf = ({ code }) => (code === "cbor" ? "json" : code);

function compareAnswers(other, { name }, mine, theirs, hasOneFault, seen) {
  const pair = `${mine.verdict} ${codeOf(mine)} | ${theirs.verdict} ${codeOf(theirs)}`;
  seen.set(pair, (seen.get(pair) ?? 0) + 1);
  const both = `${name}: ${mine.verdict} [${mine.code}] ${mine.message}; ${other.name}: ${theirs.line}`;
  const words = [mine, theirs].map(({ verdict }) => WORDS[verdict]);
  const agree = words[0] === words[1] || words.includes("declined");
  assert.ok(words[1] && agree, both);
  // Over a reducible polynomial another expression for the same value may be decided.
  const isDecided = [mine, theirs].some(({ code }) => code === "sign-undecided");
  if (hasOneFault && !isDecided) assert.deepEqual([theirs.verdict, codeOf(theirs)], [mine.verdict, codeOf(mine)], both);
  if (words[0] === "accepted" && words[1] === "accepted") assert.equal(theirs.sha256, mine.sha256, both);
}
