// The JavaScript verifier against the folders of certificates, and against the Rust verifier. Run: node --test tests/browser
//
// ACUTILE_VERIFY names the Rust program, MUTATIONS how many changed certificates are compared, SEED the first of their seeds, ONLY a part of the
// names of the certificates that are changed; SHOW_CODES counts the answers.

import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { sha256, verify } from "../../crates/publish/src/report/verifier.js";
import { askRust, certificatesIn, outputOf, ROOT, rustVerifier } from "./files.mjs";
import { Chance, mutate, write } from "./mutate.mjs";

const VERDICTS = new Map([["malformed", "malformed"], ["false", "rejected"], ["declined", "declined"]]);
const MUTATIONS = Number(process.env.MUTATIONS ?? 3000);
const SEED = Number(process.env.SEED ?? 1);
const rust = rustVerifier();
const needsRust = { skip: rust ? false : "acutile-verify is not built, and ACUTILE_VERIFY does not name it" };

for (const [folder, verdict] of VERDICTS) {
  test(`every file of ${folder} gets the code in its name`, () => {
    const files = certificatesIn(`tests/certificates/${folder}`);
    assert.ok(files.length >= 25);
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
      assert.equal(answer.sha256, createHash("sha256").update(bytes).digest("hex"));
      const { claim, witness } = JSON.parse(new TextDecoder().decode(bytes));
      assert.deepEqual(
        [answer.claim.length, answer.vertices, answer.simplices],
        [claim.statements.length, witness.vertices.length, witness.simplices.length],
      );
    }
  });
}

test("a text and its bytes are the same certificate", () => {
  for (const { bytes } of certificatesIn("tests/certificates/valid")) {
    assert.deepEqual(verify(new TextDecoder("utf-8", { ignoreBOM: true }).decode(bytes)), verify(bytes));
  }
});

test("SHA-256 of every length around the blocks", () => {
  for (let length = 0; length < 200; length++) {
    const bytes = Uint8Array.from({ length }, (_, i) => (i * 37 + length) & 255);
    assert.equal(sha256(bytes), createHash("sha256").update(bytes).digest("hex"));
  }
  // FIPS 180-4, the example "abc".
  assert.equal(sha256(new TextEncoder().encode("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
});

test("hostile texts are malformed, and nothing is left behind", () => {
  const million = 1 << 20;
  const texts = [
    "[".repeat(million),
    '{"a":'.repeat(million),
    `{"format":"acutile-certificate","version":1,"claim":${"[".repeat(million)}${"]".repeat(million)},"witness":{}}`,
    '{"__proto__":{"format":"acutile-certificate","version":1}}',
    `{"format":"acutile-certificate","version":1,"claim":{"__proto__":{"dimension":2}},"witness":{}}`,
    `{"format":"acutile-certificate","version":${"9".repeat(million)}}`,
    `{"format":"acutile-certificate","version":1e${"9".repeat(million)}}`,
    '"\ud800"',
    "\ufeff{}",
    "",
    "nul",
    '{"format":"acutile-certificate","version":1,}',
  ];
  for (const text of texts) {
    const answer = verify(text);
    assert.deepEqual([answer.verdict, answer.code], ["malformed", "json"], text.slice(0, 60));
  }
  assert.deepEqual([Object.keys(Object.prototype), {}.format, {}.dimension], [[], undefined, undefined]);
});

test("the first vertex may be the unused one", () => {
  const { bytes } = certificatesIn("tests/certificates/valid").find(({ name }) => name === "solid-cube-6.json");
  const [one, other] = [0, 1].map(() => JSON.parse(new TextDecoder().decode(bytes)));
  one.witness.vertices.unshift(["5", "5", "5"]);
  for (const corner of one.witness.simplices.flat()) corner[0]++;
  assert.equal(verify(write(one)).code, "unused-vertex");
  const { solid } = other.claim.domain;
  solid.vertices.unshift(["5", "5", "5"]);
  solid.faces = solid.faces.map((face) => face.map((w) => w + 1));
  assert.equal(verify(write(other)).code, "unused-domain-vertex");
});

test("numbers that would be expensive are declined before they are made", () => {
  const file = certificatesIn("tests/certificates/valid").find(({ name }) => name === "plane-square.json");
  const certificate = JSON.parse(new TextDecoder().decode(file.bytes));
  certificate.witness.vertices[0][0] = "7".repeat(30_000_000);
  const start = performance.now();
  assert.equal(verify(write(certificate)).code, "too-many-digits");
  assert.ok(performance.now() - start < 20_000);
});

test("limits are inclusive", () => {
  const { bytes } = certificatesIn("tests/certificates/valid").find(({ name }) => name === "plane-square-triangle.json");
  const { witness, claim } = JSON.parse(new TextDecoder().decode(bytes));
  const degree = claim.field["Q(a)"].polynomial.length - 1;
  for (const [name, value] of Object.entries({ bytes: bytes.length, simplices: witness.simplices.length, degree })) {
    assert.equal(verify(bytes, { [name]: value }).verdict, "verified", name);
    assert.equal(verify(bytes, { [name]: value - 1 }).verdict, "declined", name);
  }
});

test("limits are integers with known names", () => {
  for (const limits of [{ bytes: -1 }, { bytes: 1.5 }, { work: Infinity }, { depth: 3 }, { digits: "9" }]) assert.throws(() => verify("", limits), TypeError);
  assert.throws(() => verify(null), TypeError);
});

test("a page can embed the module", () => {
  const source = readFileSync(join(ROOT, "crates/publish/src/report/verifier.js"), "utf8");
  assert.doesNotMatch(source, /<\/script|<!--|^import\b|\b(import|require|fetch|eval|Function)\(|Math\.random|\bDate\b/im);
});

test("sigma takes less than two seconds", () => {
  const { bytes } = certificatesIn("certificates").find(({ name }) => name === "sigma.json");
  const start = performance.now();
  assert.equal(verify(bytes).verdict, "verified");
  assert.ok(performance.now() - start < 2000);
});

// ---- Functions of the module against schoolbook ones ----

/** The module's own functions, which it does not export. */
async function inside(...names) {
  const source = readFileSync(join(ROOT, "crates/publish/src/report/verifier.js"), "utf8");
  return import(`data:text/javascript,${encodeURIComponent(`${source}\nexport { ${names} };`)}`);
}

test("products in Z[a] are those of polynomials, less multiples of the field's", async () => {
  const { Ring } = await inside("Ring");
  const chance = new Chance(3);
  const some = (length) => Array.from({ length }, () => BigInt(chance.below(41) - 20) ** BigInt(1 + chance.below(9)));
  for (let round = 0; round < 500; round++) {
    const n = 2 + chance.below(7);
    const modulus = [...some(n), 1n];
    const [x, y] = [some(1 + chance.below(n)), some(1 + chance.below(n))];
    const rest = new Array(2 * n).fill(0n);
    x.forEach((c, i) => y.forEach((d, j) => (rest[i + j] += c * d)));
    for (let top = rest.length - 1; top >= n; top--) {
      const factor = rest[top];
      modulus.forEach((c, i) => (rest[top - n + i] -= factor * c));
    }
    const product = new Ring(modulus, [], null).times(x, y);
    assert.notEqual(product.at(-1), 0n);
    assert.deepEqual(Array.from(rest, (_, i) => product[i] ?? 0n), rest);
  }
});

// ---- Triangles in the boundary of a region, against separating functionals ----

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

test("edges cut triangles where no plane is between them", async () => {
  const { cuts, meetInShared, normalOf, Ring } = await inside("cuts", "meetInShared", "normalOf", "Ring");
  const chance = new Chance(7);
  const seen = [0, 0, 0, 0];
  while (seen.reduce((x, y) => x + y) < 8_000) {
    const width = chance.of([[3, 3, 3], [4, 4, 1], [2, 2, 2], [5, 5, 2]]);
    const points = Array.from({ length: 6 }, () => width.map((w) => chance.below(w)));
    const [p, q] = [points.slice(0, 3), points.slice(3)];
    if ([p, q].some((corners) => cross(...edgesOf(corners)).every((entry) => entry === 0))) continue;
    const element = (x) => (x === 0 ? [] : [BigInt(x)]);
    const tiling = { ring: new Ring(null, [], null), vertices: points.map((x) => x.map(element)) };
    const [f, g] = [[0, 1, 2], [3, 4, 5]].map((corners) => ({ corners, normal: normalOf(tiling, corners) }));
    const answers = [meetInShared(tiling, f, g, []), cuts(tiling, [0, 1], g)];
    const expected = [isSeparated(p, q), !isSeparated(q, p.slice(0, 2))];
    assert.deepEqual(answers, expected, JSON.stringify(points));
    seen[2 * Number(answers[0]) + Number(answers[1])]++;
  }
  assert.ok(seen[0] > 300 && seen[1] > 300 && seen[2] > 300 && seen[3] === 0, String(seen));
});

// ---- Against the Rust verifier ----

/** As the programs read files: one byte more than the limit is enough. */
const verifyFile = (bytes, limits) => verify(bytes.subarray(0, (limits.bytes ?? Infinity) + 1), limits);

/**
 * What both must say. The words of `json` are the parser's own, and an undecided value may be another one where each has its own enclosure (of a
 * cosine) or its own comparisons (of the vertices of a region); all other words are compared letter by letter.
 */
function essence({ verdict, code = null, message = null, claim, words, sha256: digest = null, vertices = null, simplices = null }) {
  const sentences = verdict === "verified" ? (words ?? claim.join("; ")) : null;
  const comparable = code === "json" ? null : message?.replace(/(sign of the (?:cosine .* compared|difference .* functional)), .*, (is not decided)/, "$1 $2");
  return { verdict, code, message: comparable, sentences, digest, vertices, simplices };
}

test("both verifiers say the same of every file", needsRust, () => {
  const folders = [...VERDICTS.keys(), "valid"].map((folder) => `tests/certificates/${folder}`);
  for (const { path, bytes, limits } of [...folders, "certificates"].flatMap(certificatesIn)) {
    const expected = askRust(rust, [path], limits).get(path);
    assert.deepEqual(essence(verifyFile(bytes, limits)), essence(expected), path);
  }
});

test("both programs print the same lines and give the same exit codes", needsRust, () => {
  const files = ["false/not-acute--cube-6", "declined/version--2", "valid/plane-square", "malformed/format--control-characters"];
  const paths = files.map((file) => join(ROOT, `tests/certificates/${file}.json`));
  const node = (...options) => outputOf(process.execPath, [join(ROOT, "crates/publish/src/report/verify-cli.mjs"), ...options]);
  for (const options of [paths, ["--json", ...paths], ["--limit-simplices", "1", ...paths]]) assert.equal(node(...options), outputOf(rust, options));
});

test("both verifiers count the same work, to the last product", needsRust, () => {
  const names = ["plane-cubic-field", "plane-reducible-field", "plane-square-triangle", "strip-of-height-sqrt-3", "slab-bcc", "solid-octahedron"];
  const all = ["certificates", "tests/certificates/valid"].flatMap(certificatesIn);
  for (const { name, path, bytes } of all.filter(({ stem }) => [...names, "z-c15-4", "square-8", "icosahedral"].includes(stem))) {
    const work = leastWork(bytes);
    for (const limits of [{ work }, { work: work - 1 }]) {
      const expected = askRust(rust, [path], limits).get(path);
      assert.equal(expected.verdict, limits.work === work ? "verified" : "declined", `${name} ${work}`);
      assert.deepEqual(essence(verify(bytes, limits)), essence(expected), name);
    }
  }
});

/** The least limit of work under which a certificate is verified. */
function leastWork(bytes) {
  let [fails, passes] = [0, 1 << 24];
  while (passes - fails > 1) {
    const work = Math.floor((fails + passes) / 2);
    if (verify(bytes, { work }).verdict === "verified") passes = work;
    else fails = work;
  }
  return passes;
}

/** Limits that bite, one set for each batch. */
const LIMITS = [{}, {}, {}, {}, { work: 2000 }, { work: 20000 }, { bisections: 3 }, { bisections: 70 }, { bisections: 0 }, { digits: 4 }, { degree: 2 }, { simplices: 12 }, { bytes: 2500 }];
const BATCH = 60;

test(`both verifiers say the same of ${MUTATIONS} changed certificates`, { ...needsRust, timeout: 1_200_000 }, () => {
  const bases = ["certificates", "tests/certificates/valid", "tests/certificates/declined"]
    .flatMap(certificatesIn)
    .filter(({ bytes }) => bytes.length < 25_000)
    .filter(({ bytes, name }) => isJson(bytes) && name.includes(process.env.ONLY ?? ""));
  const folder = mkdtempSync(join(tmpdir(), "acutile-mutations-"));
  const seen = new Map();
  try {
    for (let first = 0; first < MUTATIONS; first += BATCH) {
      const limits = LIMITS[(first / BATCH) % LIMITS.length];
      compareBatch(folder, bases, SEED + first, Math.min(BATCH, MUTATIONS - first), limits, seen);
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
  if (process.env.SHOW_CODES) console.log([...seen].sort());
  if (MUTATIONS >= 2000 && !process.env.ONLY) assert.ok(seen.size >= 50, `only ${seen.size} codes are met: ${[...seen.keys()]}`);
});

function isJson(bytes) {
  try {
    return typeof JSON.parse(new TextDecoder().decode(bytes)).witness === "object";
  } catch {
    return false;
  }
}

/** docs/format.md, "What may differ": over a field, the signs for the boundary of a region. One declines then; they never contradict one another. */
function mayDiffer(bytes, mine, other) {
  if (![mine.code, other.code].some((code) => code === "sign-undecided" || code === "work")) return false;
  const { domain, field } = JSON.parse(new TextDecoder().decode(bytes)).claim;
  return domain === "region" && field !== "Q";
}

function compareBatch(folder, bases, seed, count, limits, seen) {
  const files = Array.from({ length: count }, (_, i) => {
    const chance = new Chance(seed + i);
    const base = chance.of(bases);
    const path = join(folder, `${seed + i}.json`);
    const bytes = mutate(chance, base.bytes);
    writeFileSync(path, bytes);
    return { path, bytes, name: `seed ${seed + i}, ${base.name}, limits ${JSON.stringify(limits)}` };
  });
  const expected = askRust(rust, files.map(({ path }) => path), limits);
  for (const { path, bytes, name } of files) {
    const answer = verifyFile(bytes, limits);
    const [mine, other] = [essence(answer), essence(expected.get(path))];
    if (!mayDiffer(bytes, mine, other)) assert.deepEqual(mine, other, name);
    seen.set(answer.code ?? "verified", (seen.get(answer.code ?? "verified") ?? 0) + 1);
    rmSync(path);
  }
}
