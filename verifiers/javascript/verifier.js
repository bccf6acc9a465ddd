// The verifier for browsers: checks a certificate of format 2 from its JSON, in exact arithmetic.
//
// It is a second opinion on the kernel in Rust. Both follow docs/format.md and docs/soundness.md; neither is a translation of the other.
// Here a facet is named by the text of its corners, valences are counted at the end, angles and Delaunay come from the normals of the
// facets, radii from the formulas of Heron and Crelle, and boundary facets are compared by cutting edges with triangles. In a family the
// numbers are polynomials; each condition is shown in each leaf, by Bernstein coefficients from blossoms, or else tried in points.
//
// The module has no imports and uses only the language, TextDecoder and TextEncoder. Only BigInt decides about numbers. A Number is an
// index, a count, an entry of a shift, or an integer of the certificate below 2^53. The report page embeds this file, so no end of a
// script element occurs in it. It leaves out CBOR as input: it reads JSON, and writes CBOR only for the digest.

/**
 * Inclusive upper bounds. A certificate beyond one is declined, never accepted. `bytes` counts those of the JSON, `bits` those of an integer.
 * `work` counts sides of points with respect to faces, comparisons of two boxes in a region, and Bernstein coefficients of a family.
 */
const DEFAULT_LIMITS = Object.freeze({ bytes: 67108864, simplices: 1000000, bits: 4096, degree: 8, work: 200000000 });

/** The verdict of every code, in the order of docs/format.md. */
const CODES = new Map(
  `declined encoding, too-many-bytes; malformed json, canonical, format; declined version, kind; malformed dimension, polynomial;
  declined degree, too-many-digits; malformed root-order; rejected root-signs; malformed root-derivative, parameters, parameter-name,
  box-exchanged, box-empty, tree; declined tree-size; malformed exponent, terms; rejected gram-not-positive;
  malformed family-domain, prism-dimension, region-rank, denominator, face-count, face-length, face-vertices, face-repeated, unused-domain-vertex;
  rejected face-not-facet, face-not-convex, faces-not-closed; malformed statements, bound-range, statement-domain;
  rejected denominator-domain, vertex-outside; malformed unused-parameter, boundary-domain, no-simplices; declined too-many-simplices;
  malformed vertex-range, shift-range, corner-order, sixes, boundary-repeated; rejected boundary-meets, facet-side, triangle-valence,
  edge-valence, orientation, covering, not-acute, not-nonobtuse, plane-crossed, angle-bound, ratio-bound, not-delaunay, not-weakly-delaunay,
  open-facet, boundary-open; malformed unused-vertex; rejected volume-sum, not-attained, none-inside; declined sign-undecided, work;
  malformed rank; rejected gram-blocks; malformed tile-count, side-count; rejected tile-order; malformed pyramid; rejected pyramid-side,
  wall-pattern, wall-reversal; declined corner-angle; rejected side-classes, missing-join`
    .split(";")
    .flatMap((part) => {
      const [verdict, ...codes] = part.trim().split(/,?\s+/);
      return codes.map((code) => [code, verdict]);
    }),
);

class Refusal extends Error {
  constructor(code, message) {
    super(message);
    this.code = code;
  }
}

function refuse(code, message) {
  throw new Refusal(code, message);
}

// ---- The entrance ----------------------------------------------------------------------------------------------------------------

/**
 * Checks everything that a certificate claims. The first check that fails gives the answer. No content of `text` makes it throw.
 *
 * @param {string|Uint8Array} text the certificate in JSON; a string stands for its bytes in UTF-8
 * @param {object} [limits] some of the members of DEFAULT_LIMITS, integers from 0 to 2^53 - 1
 * @returns {{verdict: string, code: ?string, message: ?string, claim: string[], vertices: ?number, simplices: ?number,
 *   sha256: ?string}} `verdict` is verified, rejected, malformed or declined. If it is verified: `claim` has a sentence for each
 *   statement, and `sha256` is the digest of the certificate's CBOR. Otherwise `code` and `message` say why not.
 */
function verify(text, limits = {}) {
  const bounds = completed(limits);
  try {
    const tree = parsed(text, bounds);
    return verified(checked(tree, bounds), tree);
  } catch (error) {
    return refused(error);
  }
}

function checked(tree, limits) {
  const reader = new Reader(limits);
  const [, , kind, claim, witness] = reader.record(tree, ["format", "version", "kind", "claim", "witness"], "the certificate");
  const isFamily = reader.text(kind, "kind") === "family";
  if (kind === "patches") return checkedSystem(reader, claim, witness);
  if (!isFamily && kind !== "tiling") refuse("kind", `the kind ${quoted(kind)} is unknown; this program knows "tiling", "family" and "patches"`);
  const claimNames = ["dimension", "field", ...(isFamily ? ["parameters"] : []), "gram", "domain", "statements"];
  const witnessNames = ["denominator", "vertices", "boundary", ...(isFamily ? ["tree"] : []), "simplices"];
  // `record` demands these names in this order.
  reader.record(claim, claimNames, "the claim");
  reader.record(witness, witnessNames, "the witness");
  const tiling = readClaim(reader, claim, witness.tree);
  checkWitness(reader, tiling, witness);
  return tiling;
}

function verified(tiling, tree) {
  return {
    verdict: "verified",
    code: null,
    message: null,
    claim: tiling.patches ? sentencesOfSystem(tiling) : sentences(tiling),
    vertices: tiling.vertices.length,
    simplices: tiling.rows.length,
    sha256: digestOfCbor(tree),
  };
}

/** A RangeError or InternalError is the engine's: a number or a stack that is too large for it. Nothing is proved then. */
function refused(error) {
  const isEngine = error instanceof RangeError || error.name === "InternalError";
  if (!isEngine && !(error instanceof Refusal)) throw error;
  const code = isEngine ? "work" : error.code;
  const message = isEngine ? `the JavaScript engine gives up: ${error.message}` : error.message;
  return { verdict: CODES.get(code), code, message, claim: [], vertices: null, simplices: null, sha256: null };
}

function completed(limits) {
  const all = new Map(Object.entries(DEFAULT_LIMITS));
  for (const [name, value] of Object.entries(limits ?? {})) {
    const fits = all.has(name) && Number.isSafeInteger(value) && value >= 0;
    if (!fits) throw new TypeError(`limits: ${name} = ${String(value)}`);
    all.set(name, value);
  }
  return Object.fromEntries(all);
}

// ---- SHA-256 (FIPS 180-4) of the CBOR encoding; crypto.subtle is missing on pages from files ----------------------------------------

/** The first 32 fractional bits of the square (m = 2) or cube (m = 3) roots of the first primes. */
function rootBits(count, m) {
  const words = [];
  for (let p = 2; words.length < count; p++) {
    let isPrime = true;
    for (let q = 2; q * q <= p; q++) isPrime &&= p % q !== 0;
    if (isPrime) words.push(Number(BigInt.asUintN(32, integerRoot(BigInt(p) << BigInt(32 * m), BigInt(m)))) | 0);
  }
  return words;
}

/** The largest r with r^m <= x, for x < 2^(40 m). */
function integerRoot(x, m) {
  let root = 0n;
  for (let bit = 1n << 40n; bit > 0n; bit >>= 1n) if ((root + bit) ** m <= x) root += bit;
  return root;
}

const ROUND_WORDS = rootBits(64, 3);
const FIRST_STATE = rootBits(8, 2);

class Sha256 {
  constructor() {
    this.state = Int32Array.from(FIRST_STATE);
    this.block = new Uint8Array(64);
    this.schedule = new Int32Array(64);
    this.length = 0;
  }

  push(byte) {
    this.block[this.length % 64] = byte;
    this.length++;
    if (this.length % 64 === 0) this.mix();
  }

  /** @returns {string} 64 hexadecimal digits */
  finish() {
    const bits = BigInt(this.length) * 8n;
    this.push(0x80);
    while (this.length % 64 !== 56) this.push(0);
    for (let i = 7n; i >= 0n; i--) this.push(Number((bits >> (8n * i)) & 255n));
    return Array.from(this.state, (word) => (word >>> 0).toString(16).padStart(8, "0")).join("");
  }

  mix() {
    const { state, block, schedule: w } = this;
    const turn = (x, n) => (x >>> n) | (x << (32 - n));
    for (let t = 0; t < 16; t++) w[t] = (block[4 * t] << 24) | (block[4 * t + 1] << 16) | (block[4 * t + 2] << 8) | block[4 * t + 3];
    for (let t = 16; t < 64; t++) {
      const [x, y] = [w[t - 15], w[t - 2]];
      w[t] = w[t - 16] + (turn(x, 7) ^ turn(x, 18) ^ (x >>> 3)) + w[t - 7] + (turn(y, 17) ^ turn(y, 19) ^ (y >>> 10));
    }
    let [a, b, c, d, e, f, g, h] = state;
    for (let t = 0; t < 64; t++) {
      const first = (h + (turn(e, 6) ^ turn(e, 11) ^ turn(e, 25)) + ((e & f) ^ (~e & g)) + ROUND_WORDS[t] + w[t]) | 0;
      const second = ((turn(a, 2) ^ turn(a, 13) ^ turn(a, 22)) + ((a & b) ^ (a & c) ^ (b & c))) | 0;
      [h, g, f, e, d, c, b, a] = [g, f, e, (d + first) | 0, c, b, a, (first + second) | 0];
    }
    [a, b, c, d, e, f, g, h].forEach((word, i) => (state[i] += word));
  }
}

function sha256(bytes) {
  const digest = new Sha256();
  for (const byte of bytes) digest.push(byte);
  return digest.finish();
}

function digestOfCbor(tree) {
  const digest = new Sha256();
  writeCbor(tree, (byte) => digest.push(byte));
  return digest.finish();
}

/** RFC 8949, section 4.2.1. An object is the array of its values; a string of decimal digits is an integer. */
function writeCbor(value, push) {
  if (typeof value === "number" || isDecimal(value)) writeInteger(BigInt(value), push);
  else if (typeof value === "string") writeBytes(3, new TextEncoder().encode(value), push);
  else {
    const items = Object.values(value);
    writeHead(4, BigInt(items.length), push);
    for (const item of items) writeCbor(item, push);
  }
}

function writeBytes(major, bytes, push) {
  writeHead(major, BigInt(bytes.length), push);
  bytes.forEach(push);
}

function writeInteger(x, push) {
  const [isNegative, size] = x < 0n ? [1, -1n - x] : [0, x];
  if (size < 1n << 64n) return writeHead(isNegative, size, push);
  push(0xc2 + isNegative);
  const hex = size.toString(16);
  const digits = hex.padStart(hex.length + (hex.length % 2), "0");
  writeBytes(2, Uint8Array.from(digits.match(/../g), (pair) => parseInt(pair, 16)), push);
}

/** The head of an item: its major type and an argument in the fewest bytes. */
function writeHead(major, argument, push) {
  if (argument < 24n) return push(32 * major + Number(argument));
  const order = [8n, 16n, 32n, 64n].findIndex((bits) => argument < 1n << bits);
  push(32 * major + 24 + order);
  for (let i = (1 << order) - 1; i >= 0; i--) push(Number((argument >> BigInt(8 * i)) & 255n));
}

// ---- JSON: the engine parses, and its result is printed again and compared ----------------------------------------------------------------

const FORMAT = "acutile-certificate";
const VERSION = 2;
const DEPTH = 80; // A tree of halvings is at most 64 deep, other values are at most 10.

const isDecimal = (value) => typeof value === "string" && /^-?[1-9][0-9]*$/.test(value);

function parsed(input, limits) {
  const text = textOf(input, limits);
  let tree;
  try {
    tree = JSON.parse(text);
  } catch (error) {
    if (!(error instanceof SyntaxError)) throw error;
    refuse("json", "the file is not JSON");
  }
  checkHeader(tree);
  const canonical = new Canonical(text);
  canonical.value(tree, 0);
  canonical.expect("\n");
  if (canonical.at !== text.length) canonical.fail();
  return tree;
}

function textOf(input, limits) {
  if (typeof input !== "string" && !(input instanceof Uint8Array)) throw new TypeError("verify: a string or a Uint8Array");
  const isLong = input.length > limits.bytes;
  if (isLong) refuse("too-many-bytes", `at least ${input.length} bytes, more than the limit of ${limits.bytes}`);
  if (typeof input === "string") return input; // Another character than ASCII is refused by Canonical.
  const isCbor = input[0] >> 5 === 4; // An array of CBOR begins so, and no text in UTF-8.
  if (isCbor) refuse("encoding", "the certificate is in CBOR; `acutile convert F.cbor F.json` writes it as JSON");
  try {
    return new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(input);
  } catch {
    return refuse("json", "the file is not in UTF-8");
  }
}

/** Format and version come first: another version may have another shape. */
function checkHeader(tree) {
  const isObject = typeof tree === "object" && tree !== null && !Array.isArray(tree);
  const isHeader = isObject && Object.hasOwn(tree, "format") && Object.hasOwn(tree, "version");
  if (!isHeader || typeof tree.format !== "string") refuse("json", "not an object with a format and a version");
  if (tree.format !== FORMAT) refuse("format", `the format is ${quoted(tree.format)}, not "${FORMAT}"`);
  if (isDecimal(tree.version) && tree.version.length < 16) refuse("canonical", "the version is written as a text");
  if (!Number.isInteger(tree.version) && !isDecimal(tree.version)) refuse("json", "the version is not an integer");
  if (tree.version !== VERSION) refuse("version", `version ${tree.version} is unknown; this program knows ${VERSION}`);
}

/** Prints a value in the one canonical form and compares each piece with the text. */
class Canonical {
  constructor(text) {
    this.text = text;
    this.at = 0;
  }

  fail() {
    refuse("canonical", `not in canonical form: the first wrong character is at offset ${this.at}`);
  }

  expect(piece) {
    if (!this.text.startsWith(piece, this.at)) this.fail();
    this.at += piece.length;
  }

  /** `depth` arrays and objects are open around the value; the outer three have their items on lines. */
  value(value, depth) {
    if (typeof value === "number") this.number(value);
    else if (typeof value === "string") this.string(value);
    else if (typeof value === "boolean" || value === null) refuse("json", `${value} before offset ${this.at} is no value of the grammar`);
    else if (depth === DEPTH) refuse("json", `brackets are nested too deeply at offset ${this.at}`);
    else if (Array.isArray(value)) this.group("[", "]", value, depth, (item) => this.value(item, depth + 1));
    else this.group("{", "}", Object.entries(value), depth, (member) => this.member(member, depth + 1));
  }

  number(value) {
    if (!Number.isInteger(value)) refuse("json", `a number that is no integer at offset ${this.at}`);
    if (!Number.isSafeInteger(value)) this.fail();
    this.expect(String(value));
  }

  string(value) {
    if (!/^[ -~]*$/.test(value)) refuse("json", `a text with a character that is not printable ASCII at offset ${this.at}`);
    this.expect(JSON.stringify(value));
  }

  member([name, value], depth) {
    this.string(name);
    this.expect(":");
    this.value(value, depth);
  }

  group(open, close, items, depth, write) {
    const line = depth < 3 && items.length > 0 ? "\n" : "";
    this.expect(open);
    items.forEach((item, i) => {
      this.expect(i > 0 ? "," + line : line);
      write(item);
    });
    this.expect(line + close);
  }
}

// ---- The items of the grammar ----------------------------------------------------------------------------------------------------

class Reader {
  constructor(limits) {
    this.limits = limits;
    this.degree = 1; // of the field, once it is known
    this.family = null; // `{ring, used}`, once the parameters are known
  }

  fail(place, wanted) {
    refuse("json", `${place}: expected ${wanted}`);
  }

  /** The values of an object with exactly these members. */
  record(value, names, place) {
    const isObject = typeof value === "object" && !Array.isArray(value);
    const found = isObject ? Object.keys(value) : [];
    const isSame = found.length === names.length && names.every((name) => found.includes(name));
    if (!isSame) this.fail(place, `an object with the members ${names.join(", ")}`);
    if (found.some((name, i) => name !== names[i])) refuse("canonical", `${place}: the members are in another order`);
    return Object.values(value);
  }

  array(value, place, length = value.length) {
    if (!Array.isArray(value) || value.length !== length) this.fail(place, length === undefined ? "an array" : `an array of ${length}`);
    return value;
  }

  text(value, place) {
    if (typeof value !== "string" || isDecimal(value)) this.fail(place, "a text");
    return value;
  }

  /** A Number below 2^53 in absolute value, a BigInt beyond. */
  integer(value, place) {
    if (typeof value === "number") return value;
    if (!isDecimal(value)) this.fail(place, "an integer");
    // 10^(n-1) > 2^(3n-3): a number of n digits has at least 3n - 2 bits. So no long text is converted.
    if (3 * value.replace("-", "").length - 2 > this.limits.bits) this.long(place);
    const integer = BigInt(value);
    if (size(integer) < 1n << 53n) refuse("canonical", `${place}: ${value} is written as a text`);
    return integer;
  }

  /** As a BigInt within the limit. */
  big(value, place) {
    const integer = BigInt(this.integer(value, place));
    if (size(integer) >> BigInt(this.limits.bits) > 0n) this.long(place);
    return integer;
  }

  long(place) {
    refuse("too-many-digits", `${place}: an integer of more than ${this.limits.bits} bits`);
  }

  bigs(values, place, length) {
    return this.array(values, place, length).map((value, i) => this.big(value, `${place}[${i}]`));
  }

  positive(value, place, code) {
    const integer = this.big(value, place);
    if (integer <= 0n) refuse(code, `${place}: the denominator ${integer} is not positive`);
    return integer;
  }

  /** An element of Z[a] by its coefficients. */
  number(value, place) {
    return this.degree === 1 ? [this.big(value, place)] : this.bigs(value, place, this.degree);
  }

  /** A number; in a family a polynomial. */
  value(value, place) {
    return this.family ? this.polynomial(value, place) : this.number(value, place);
  }

  values(values, place, length) {
    return this.array(values, place, length).map((value, i) => this.value(value, `${place}[${i}]`));
  }

  /** Terms by their exponents, in ascending order, none of them zero. */
  polynomial(trees, place) {
    const { ring, used } = this.family;
    const rows = this.array(trees, place).map((tree) => {
      const [coefficient, ...exponents] = this.array(tree, place, 1 + ring.names.length);
      const c = this.number(coefficient, place);
      const powers = exponents.map((exponent) => this.integer(exponent, place));
      const wrong = powers.find((exponent) => !isIndex(exponent, EXPONENTS));
      if (wrong !== undefined) refuse("exponent", `${place}: a polynomial of too high degree; the exponent ${wrong} is not from 0 to ${EXPONENTS - 1}`);
      if (isZero(c)) refuse("terms", `${place}: a coefficient is zero`);
      powers.forEach((exponent, k) => exponent > 0 && used.add(k));
      return [powers, c];
    });
    if (rows.some(([powers], i) => i > 0 && byEntries(rows[i - 1][0], powers) >= 0)) refuse("terms", `${place}: the terms are not in order`);
    return new Polynomial(ring, new Map(rows.map(([powers, c]) => [keyOf(powers), c])));
  }

  /** A corner as [vertex, shift…]. */
  corner(value, place, { rank, vertices }) {
    const entries = Array.isArray(value) ? value.map((entry) => this.integer(entry, place)) : [this.integer(value, place)];
    const isShifted = Array.isArray(value);
    if (isShifted && entries.length !== 1 + rank) this.fail(place, `a vertex, or an array of ${1 + rank}`);
    const [v, ...shift] = entries;
    if (!isIndex(v, vertices.length)) refuse("vertex-range", `${place}: vertex ${v} does not exist; there are ${vertices.length} vertices`);
    const far = shift.find((entry) => !(entry > -FAR && entry < FAR));
    if (far !== undefined) refuse("shift-range", `${place}: the shift ${far} is not between -2^29 and 2^29`);
    if (isShifted && shift.every((entry) => entry === 0)) refuse("canonical", `${place}: a shift of zero is written`);
    return isShifted ? entries : [v, ...new Array(rank).fill(0)];
  }
}

const FAR = 2 ** 29;
const EXPONENTS = 16;
const isIndex = (value, count) => typeof value === "number" && value >= 0 && value < count;
const size = (x) => (x < 0n ? -x : x);
const sign = (x) => (x > 0n ? 1 : x < 0n ? -1 : 0);

function gcd(x, y) {
  for ([x, y] = [size(x), size(y)]; y > 0n; ) [x, y] = [y, x % y];
  return x;
}

/** No integer beyond 1 divides all of these. */
function checkPrimitive(integers, place) {
  let common = 0n;
  for (const integer of integers) {
    common = gcd(common, integer);
    if (common === 1n) return;
  }
  refuse("canonical", `${place}: all integers are divisible by ${common}`);
}

/** All coefficients of values in nested arrays. */
function* integersOf(values) {
  for (const x of values) {
    if (typeof x === "bigint") yield x;
    else yield* integersOf(x instanceof Polynomial ? x.terms.values() : x);
  }
}

// ---- The ring Z[a] ----------------------------------------------------------------------------------------------------------
//
// Elements are the coefficients of 1, a, …, a^(n-1); over Q n is 1. Equal coefficients mean equal values; an enclosure of a that
// excludes zero shows a sign. Where neither holds the verifier declines.

// A value is an element, or in a family a polynomial with such coefficients.

const plus = (x, y) => (Array.isArray(x) ? x.map((c, k) => c + y[k]) : x.ring.sum([x, y]));
const minus = (x, y) => (Array.isArray(x) ? x.map((c, k) => c - y[k]) : x.ring.sum([x, negated(y)]));
const negated = (x) => scaled(x, -1n);
const scaled = (x, factor) => (Array.isArray(x) ? x.map((c) => c * factor) : x.map((c) => scaled(c, factor)));
const isZero = (x) => x.every((c) => c === 0n);

class Ring {
  /** @param {?bigint[]} polynomial monic, of degree 2 or more; null over Q */
  constructor(polynomial = null, rungs = []) {
    this.degree = polynomial ? polynomial.length - 1 : 1;
    this.powers = polynomial ? powersFrom(polynomial) : [];
    this.rungs = rungs;
    this.zero = new Array(this.degree).fill(0n);
  }

  integer(c) {
    return this.zero.map((zero, k) => (k === 0 ? c : zero));
  }

  sum(elements) {
    return elements.reduce(plus, this.zero);
  }

  times(x, y) {
    return this.dot([x], [y]);
  }

  /** x_1 y_1 + x_2 y_2 + … */
  dot(xs, ys) {
    const n = this.degree;
    const product = new Array(2 * n - 1).fill(0n);
    xs.forEach((x, m) => {
      for (let i = 0; i < n; i++) for (let j = 0; j < n; j++) product[i + j] += x[i] * ys[m][j];
    });
    const low = product.slice(0, n);
    this.powers.forEach((power, k) => power.forEach((c, i) => (low[i] += product[n + k] * c)));
    return low;
  }

  /** -1, 0 or 1; undefined where it is not decided. */
  sign(x) {
    if (x.every((c, k) => k === 0 || c === 0n)) return sign(x[0]);
    for (const rung of this.rungs) {
      const [least, most] = rung.range(x);
      if (least > 0n || most < 0n) return least > 0n ? 1 : -1;
    }
    return undefined;
  }

  /** Integers below and above `factor` x. */
  bounds(x, factor) {
    if (this.degree === 1) return [x[0] * factor, x[0] * factor];
    const [least, most, unit] = this.rungs[0].range(x);
    return [floor(least * factor, unit), -floor(-most * factor, unit)];
  }
}

const floor = (p, q) => p / q - (p % q < 0n ? 1n : 0n); // for q > 0

/** a^n, …, a^(2n-2) by coefficients: a^n = -(c_0 + … + c_(n-1) a^(n-1)), and a times a row is the row moved up, its top replaced. */
function powersFrom(polynomial) {
  const n = polynomial.length - 1;
  const first = polynomial.slice(0, n).map((c) => -c);
  const rows = [first];
  for (let k = 1; k < n - 1; k++) {
    const last = rows[k - 1];
    rows.push(first.map((c, i) => c * last[n - 1] + (i > 0 ? last[i - 1] : 0n)));
  }
  return rows;
}

/** The root lies in [low, high] / unit, unit > 0. */
class Enclosure {
  constructor(low, high, unit) {
    Object.assign(this, { low, high, unit });
  }

  /** [least, most, u]: f takes values in [least, most] / u on the interval, by Horner's rule in intervals. */
  range(f) {
    let [least, most] = [f.at(-1), f.at(-1)];
    let power = 1n;
    for (let k = f.length - 2; k >= 0; k--) {
      power *= this.unit;
      const ends = [least * this.low, least * this.high, most * this.low, most * this.high];
      least = ends.reduce((x, y) => (y < x ? y : x)) + f[k] * power;
      most = ends.reduce((x, y) => (y > x ? y : x)) + f[k] * power;
    }
    return [least, most, power];
  }

  /** The half with the root of p, which has the sign `rise` at the upper end; the middle alone if p is zero there. */
  halved(p, rise) {
    const [middle, unit] = [this.low + this.high, 2n * this.unit];
    const there = new Enclosure(middle, middle, unit);
    const found = sign(there.range(p)[0]);
    if (found === 0) return there;
    return found === rise ? new Enclosure(2n * this.low, middle, unit) : new Enclosure(middle, 2n * this.high, unit);
  }
}

/** Checks that p has exactly one root in the interval, and encloses it after 64, 128, 256 and 512 halvings. */
function rungsFrom(p, low, high, unit) {
  let enclosure = new Enclosure(low, high, unit);
  const [atLow, rise] = [low, high].map((end) => sign(new Enclosure(end, end, unit).range(p)[0]));
  if (atLow * rise !== -1) refuse("root-signs", "the polynomial does not have opposite signs at the ends of the root's interval");
  const [least, most] = enclosure.range(p.slice(1).map((c, k) => c * BigInt(k + 1)));
  const isMonotone = least > 0n || most < 0n;
  if (!isMonotone) refuse("root-derivative", "the polynomial's derivative is not shown to keep its sign on the root's interval");
  const rungs = [];
  for (let step = 1; step <= 512; step++) {
    enclosure = enclosure.halved(p, rise);
    if ([64, 128, 256, 512].includes(step)) rungs.push(enclosure);
  }
  return rungs;
}

// ---- Families: polynomials over a box ------------------------------------------------------------------------------------------------

class Polynomial {
  /** @param {Map<bigint, bigint[]>} terms coefficients, none of them zero, by the keys of their exponents */
  constructor(ring, terms) {
    Object.assign(this, { ring, terms });
  }

  /** For a change of coefficients that keeps zero apart. */
  map(change) {
    return new Polynomial(this.ring, new Map([...this.terms].map(([key, c]) => [key, change(c)]).filter(([, c]) => !isZero(c))));
  }
}

/** Keys of products are sums of keys: no exponent of a product reaches 2^16. */
const keyOf = (exponents) => exponents.reduceRight((key, exponent) => (key << 16n) + BigInt(exponent), 0n);
const exponentsOf = (key, count) => Array.from({ length: count }, (_, k) => Number((key >> BigInt(16 * k)) & 65535n));

class PolynomialRing {
  constructor(numbers, names) {
    Object.assign(this, { numbers, names, zero: new Polynomial(this, new Map()) });
  }

  integer(c) {
    return this.lifted(this.numbers.integer(c));
  }

  lifted(x) {
    return Array.isArray(x) ? new Polynomial(this, new Map(isZero(x) ? [] : [[0n, x]])) : x;
  }

  sum(values) {
    const total = new Map();
    for (const { terms } of values) for (const [key, c] of terms) total.set(key, total.has(key) ? plus(total.get(key), c) : c);
    return new Polynomial(this, total).map((c) => c);
  }

  times(x, y) {
    return this.dot([x], [y]);
  }

  dot(xs, ys) {
    const total = new Map();
    xs.forEach((x, m) => {
      for (const [key, c] of this.lifted(x).terms) {
        for (const [other, d] of this.lifted(ys[m]).terms) {
          const product = this.numbers.times(c, d);
          total.set(key + other, total.has(key + other) ? plus(total.get(key + other), product) : product);
        }
      }
    });
    return new Polynomial(this, total).map((c) => c);
  }
}

/**
 * Where a condition is to hold. A tiling has one place, without parameters; a family has the leaves of its tree. Each answers whether it is
 * shown that a value is positive, at least zero, or zero. If it is not, the place's `points` decide, where a condition is true or false.
 */
class Numbers {
  constructor(tiling) {
    this.tiling = tiling;
    this.points = [this];
    this.words = "";
  }

  positive(value, of, scale) {
    return signOf(this.tiling, value, of, scale) > 0;
  }

  atLeastZero(value, of, scale) {
    return signOf(this.tiling, value, of, scale) >= 0;
  }

  zero(value, of, scale) {
    return signOf(this.tiling, value, of, scale) === 0;
  }

  shown(value, scale) {
    return shown(value, scale);
  }
}

/** A product of intervals, some of them points: a leaf, or a point of one. */
class Box {
  /** @param sides for each parameter `{low, high, unit, closed}`: elements over a positive integer, and which of the ends belong to the box */
  constructor(tiling, sides) {
    Object.assign(this, { tiling, sides, matrices: new Map() });
  }

  /** By the Bernstein coefficients: the smallest faces of the closed box that meet the box itself have a positive one, and none is negative. */
  positive(value, of) {
    const { shape, signs } = this.signs(value, of);
    if (signs.some((found) => found < 0)) return false;
    const steps = shape.map((_, k) => shape.slice(k + 1).reduce((x, y) => x * y, 1));
    const hasEnd = (k) => shape[k] > 1 && this.sides[k].closed.includes(true);
    const axes = [...shape.keys()].sort((k, l) => Number(hasEnd(l)) - Number(hasEnd(k))); // those with a chosen end first
    const isShown = (i, at) => {
      if (i === axes.length) return signs[at] > 0;
      const k = axes[i];
      const next = (index) => isShown(i + 1, at + index * steps[k]);
      if (hasEnd(k)) return [0, shape[k] - 1].every((index, end) => !this.sides[k].closed[end] || next(index));
      return Array.from({ length: shape[k] }, (_, index) => index).some(next);
    };
    return isShown(0, 0);
  }

  atLeastZero(value, of) {
    return this.signs(value, of).signs.every((found) => found >= 0);
  }

  zero(value, of) {
    return this.signs(value, of).signs.every((found) => found === 0);
  }

  /** The signs of the Bernstein coefficients, the last axis fastest. */
  signs(value, of) {
    const { shape, entries } = this.bernstein(value);
    return { shape, signs: entries.map((x) => signOf({ ring: this.tiling.ring.numbers }, x, () => `Bernstein coefficient of the ${of()}`)) };
  }

  bernstein({ terms }) {
    const { work } = this.tiling;
    const rows = [...terms].map(([key, c]) => [exponentsOf(key, this.sides.length), c]);
    const sizes = this.sides.map((_, k) => 1 + Math.max(0, ...rows.map(([exponents]) => exponents[k])));
    const count = sizes.reduce((x, y) => x * y, 1);
    work.spend(count);
    let entries = new Array(count).fill(this.tiling.ring.numbers.zero);
    for (const [exponents, c] of rows) entries[exponents.reduce((at, exponent, k) => at * sizes[k] + exponent, 0)] = c;
    const shape = [...sizes];
    this.sides.forEach((side, k) => {
      if (sizes[k] === 1) return;
      entries = this.changed(entries, shape, k, this.matrix(k, sizes[k] - 1));
      shape[k] = side.isPoint ? 1 : sizes[k];
    });
    return { shape, entries };
  }

  /** The tensor with its lines along axis k multiplied by a matrix. */
  changed(entries, shape, k, matrix) {
    const step = shape.slice(k + 1).reduce((x, y) => x * y, 1);
    const size = shape[k];
    const lines = entries.length / size;
    const result = new Array(lines * matrix.length);
    for (let n = 0; n < lines; n++) {
      const [outer, inner] = [Math.floor(n / step), n % step];
      const line = Array.from({ length: size }, (_, i) => entries[(outer * size + i) * step + inner]);
      matrix.forEach((row, i) => (result[(outer * matrix.length + i) * step + inner] = this.tiling.ring.numbers.dot(row, line)));
    }
    return result;
  }

  /**
   * Bernstein coefficient k of x^i in degree n is its blossom at n - k times the low end and k times the high end: the mean of the products of
   * i of these. Here for ends over `unit`, times n! unit^n. A point has only one coefficient.
   */
  matrix(axis, n) {
    const name = `${axis} ${n}`;
    if (!this.matrices.has(name)) {
      const { low, high, unit, isPoint } = this.sides[axis];
      const { numbers } = this.tiling.ring;
      const powers = [low, high].map((end) => {
        const list = [numbers.integer(1n)];
        while (list.length <= n) list.push(numbers.times(list.at(-1), end));
        return list;
      });
      const entry = (k, i) => {
        const products = Array.from({ length: i + 1 }, (_, j) => scaled(numbers.times(powers[1][j], powers[0][i - j]), binomial(k, j) * binomial(n - k, i - j)));
        return scaled(numbers.sum(products), factorial(BigInt(i)) * factorial(BigInt(n - i)) * unit ** BigInt(n - i));
      };
      const indices = Array.from({ length: n + 1 }, (_, i) => i);
      this.matrices.set(name, (isPoint ? [0] : indices).map((k) => indices.map((i) => entry(k, i))));
    }
    return this.matrices.get(name);
  }

  /** The middle, and the corners that belong to the box, with the middle of an interval where neither end does. */
  get points() {
    return pointsOf(this);
  }

  get words() {
    return this.sides.map((side, k) => sideInWords(side, this.tiling.ring.names[k])).join(", ");
  }

  /** In a point a number; else nothing that is short. */
  shown(value, scale = 1n) {
    if (!this.sides.every(({ isPoint }) => isPoint)) return "a polynomial";
    const { numbers } = this.tiling.ring;
    const degrees = this.sides.map((_, k) => Math.max(0, ...[...value.terms.keys()].map((key) => exponentsOf(key, this.sides.length)[k])));
    const factor = degrees.reduce((x, n, k) => x * (n === 0 ? 1n : factorial(BigInt(n)) * this.sides[k].unit ** BigInt(n)), 1n);
    return shown(this.bernstein(value).entries[0] ?? numbers.zero, scale * factor);
  }
}

function* pointsOf({ tiling, sides }) {
  const middles = sides.map(({ low, high, unit }) => pointSide(plus(low, high), 2n * unit));
  yield new Box(tiling, middles);
  const choices = sides.map(({ low, high, unit, closed }, k) => {
    const ends = [low, high].filter((_, end) => closed[end]).map((end) => pointSide(end, unit));
    return ends.length > 0 ? ends : [middles[k]];
  });
  const corner = new Array(sides.length);
  function* corners(k) {
    if (k === sides.length) return yield new Box(tiling, [...corner]);
    for (corner[k] of choices[k]) yield* corners(k + 1);
  }
  yield* corners(0);
}

const pointSide = (value, unit) => ({ low: value, high: value, unit, closed: [true, true], isPoint: true });

const binomial = (n, k) => (k < 0 || k > n ? 0n : factorial(BigInt(n)) / factorial(BigInt(k)) / factorial(BigInt(n - k)));

function sideInWords({ low, high, unit, closed, isPoint }, name) {
  if (isPoint) return `${name} = ${shown(low, unit)}`;
  return `${name} in ${closed[0] ? "[" : "("}${shown(low, unit)}, ${shown(high, unit)}${closed[1] ? "]" : ")"}`;
}

/** Refuses unless a condition on a place holds in all places. `say` gives the words for a point where it does not. */
function demand({ places }, condition, code, say) {
  for (const place of places) {
    if (condition(place)) continue;
    let tried = 0;
    for (const point of place.points) {
      if (!condition(point)) refuse(code, (point.words && `for ${point.words}: `) + say(point));
      if (++tried === POINTS) break;
    }
    refuse("sign-undecided", `for ${place.words} it is not decided whether ${code} holds: ${say(place)}`);
  }
}

const POINTS = 1000;

const holdsEverywhere = ({ places }, condition) => places.every(condition);

/** The sign of `value`; `of` names it, and the number meant is `value` over the positive integer `scale`. */
function signOf({ ring }, value, of, scale = 1n) {
  const found = ring.sign(value);
  if (found !== undefined) return found;
  return refuse("sign-undecided", `the sign of the ${of()}, ${shown(value, scale)}, is not decided by 512 bisections`);
}

/** An element over a positive integer, as an expression in a; a polynomial in its parameters, too. */
function shown(value, scale = 1n) {
  if (value instanceof Polynomial) return shownPolynomial(value, scale);
  const terms = value.flatMap((c, k) => (c === 0n ? [] : [ratio(c, scale) + (["", " a"][k] ?? ` a^${k}`)]));
  return terms.join(" + ").replaceAll("+ -", "- ") || "0";
}

function shownPolynomial({ ring, terms }, scale) {
  const words = [...terms].map(([key, c]) => {
    const powers = exponentsOf(key, ring.names.length).map((exponent, k) => ["", ` ${ring.names[k]}`][exponent] ?? ` ${ring.names[k]}^${exponent}`);
    const coefficient = shown(c, scale);
    return (/ [+-] /.test(coefficient) ? `(${coefficient})` : coefficient) + powers.join("");
  });
  return words.join(" + ").replaceAll("+ -", "- ") || "0";
}

function ratio(p, q) {
  const common = gcd(p, q);
  return q === common ? `${p / common}` : `${p / common}/${q / common}`;
}

// ---- The claim ---------------------------------------------------------------------------------------------------------------

const STATEMENTS = [
  "face-to-face tiling",
  "acute",
  "nonobtuse",
  "largest dihedral angle",
  "smallest dihedral angle",
  "squared radius-edge ratio",
  "uncrossed plane",
  "Delaunay",
  "weakly Delaunay",
  "locally Delaunay",
  "locally weakly Delaunay",
  "not Delaunay",
  "TCP",
];
const RELATIONS = ["less than", "at most", "maximum", "more than", "at least", "minimum"];
const [TILING, , , LARGEST, SMALLEST, RATIO, PLANE, DELAUNAY, WEAKLY, LOCALLY, LOCALLY_WEAKLY, NOT_DELAUNAY, TCP] = STATEMENTS.keys();
const CODIMENSIONS = new Map([["slab", 1], ["prism", 2], ["solid", undefined]]);

/** The tiling so far: everything that the claim says, checked. Of a family, `halvings` is the tree of its witness. */
function readClaim(reader, claim, halvings) {
  const dimension = reader.integer(claim.dimension, "dimension");
  if (dimension !== 2 && dimension !== 3) refuse("dimension", `dimension ${dimension}; it must be 2 or 3`);
  const { ring, root } = readField(reader, claim.field);
  const tiling = { dimension, ring, numbers: ring, root, work: new Work(reader.limits.work), sides: null };
  if (claim.parameters) readParameters(reader, tiling, claim.parameters, halvings);
  else tiling.places = [new Numbers(tiling)];
  tiling.gram = readGram(reader, tiling, claim.gram);
  Object.assign(tiling, readDomain(reader, tiling, claim.domain));
  tiling.statements = readStatements(reader, tiling, claim.statements);
  return Object.assign(tiling, { determinantOfGram: determinant(tiling.ring, tiling.gram), dualGram: adjugate(tiling.ring, tiling.gram) });
}

/** Makes the tiling one of polynomials, whose places are the leaves of the tree. */
function readParameters(reader, tiling, trees, halvings) {
  const count = reader.array(trees, "parameters").length;
  if (count < 1 || count > PARAMETERS) refuse("parameters", `${count} parameters; there must be from 1 to ${PARAMETERS}`);
  const parameters = trees.map((tree, k) => readParameter(reader, tiling, tree, `parameter ${k}`));
  const names = parameters.map(({ name }) => name);
  if (new Set(names).size < count) refuse("parameter-name", "two parameters have the same name");
  if (reader.degree > 1 && names.includes("a")) refuse("parameter-name", "a parameter is named a, like the root of the field");
  const leaves = [];
  readTree(reader, halvings, parameters, 0, leaves);
  tiling.ring = new PolynomialRing(tiling.numbers, names);
  tiling.sides = parameters;
  tiling.places = leaves.map((sides) => new Box(tiling, sides));
  reader.family = { ring: tiling.ring, used: new Set() };
}

const PARAMETERS = 64;
const HALVINGS = 64;
const LEAVES = 4096;

/** A side of the box, with its name. */
function readParameter(reader, tiling, tree, place) {
  const [nameTree, ...endTrees] = reader.record(tree, ["name", "low", "high"], place);
  const name = reader.text(nameTree, `the name of ${place}`);
  if (!/^[a-z][a-z0-9_]{0,15}$/.test(name)) refuse("parameter-name", `${place}: the name ${quoted(name)} is not like a_1`);
  const ends = endTrees.map((end) => {
    const [kind, fraction] = reader.array(end, place, 2);
    if (kind !== "closed" && kind !== "open") reader.fail(place, '"closed" or "open"');
    const [p, q] = reader.array(fraction, place, 2);
    const [numerator, denominator] = [reader.number(p, place), reader.positive(q, place, "denominator")];
    checkPrimitive([...numerator, denominator], place);
    return { isClosed: kind === "closed", numerator, denominator };
  });
  const [low, high] = ends.map(({ numerator }, i) => scaled(numerator, ends[1 - i].denominator));
  const width = signOf({ ring: tiling.numbers }, minus(high, low), () => `width of ${place}`);
  if (width < 0) refuse("box-exchanged", `${place}: the ends of ${name} are exchanged`);
  if (width === 0) refuse("box-empty", `${place}: the ends of ${name} are equal`);
  return { name, low, high, unit: ends[0].denominator * ends[1].denominator, closed: ends.map(({ isClosed }) => isClosed) };
}

/** Adds the boxes of all leaves. An end in the middle belongs to both halves. */
function readTree(reader, tree, sides, depth, leaves) {
  if (reader.array(tree, "tree").length === 0) {
    if (leaves.push(sides) > LEAVES) refuse("tree-size", `the tree has more than ${LEAVES} leaves`);
    return;
  }
  if (depth === HALVINGS) refuse("tree-size", `the tree has a path of more than ${HALVINGS} halvings`);
  const [axisTree, ...halves] = reader.array(tree, "tree", 3);
  const axis = reader.integer(axisTree, "an axis of the tree");
  if (!isIndex(axis, sides.length)) refuse("tree", `the tree halves along the parameter ${axis}, which does not exist`);
  const { low, high, unit, closed } = sides[axis];
  const [from, middle, to] = [scaled(low, 2n), plus(low, high), scaled(high, 2n)];
  const ends = [[from, middle, [closed[0], true]], [middle, to, [true, closed[1]]]];
  halves.forEach((half, i) => {
    const [low, high, closed] = ends[i];
    readTree(reader, half, sides.with(axis, { low, high, unit: 2n * unit, closed }), depth + 1, leaves);
  });
}

/** Counts steps whose number is not bounded by the size of the certificate. */
class Work {
  constructor(limit) {
    Object.assign(this, { spent: 0, limit });
  }

  spend(cost) {
    this.spent += cost;
    if (this.spent > this.limit) refuse("work", `it needs more than ${this.limit} comparisons or Bernstein coefficients`);
  }
}

function readField(reader, tree) {
  if (tree === "Q") return { ring: new Ring(), root: null };
  const [polynomialTree, rootTree] = reader.record(tree, ["polynomial", "root"], "field");
  const degree = reader.array(polynomialTree, "polynomial").length - 1;
  if (degree < 2) refuse("polynomial", "the degree of the field's polynomial is less than two");
  if (degree > reader.limits.degree) refuse("degree", `the field has degree ${degree}, more than the limit of ${reader.limits.degree}`);
  const polynomial = reader.bigs(polynomialTree, "polynomial");
  if (polynomial[degree] !== 1n) refuse("polynomial", "the field's polynomial is not monic");
  const names = ["low", "high", "denominator"];
  const [low, high, unit] = reader.record(rootTree, names, "root").map((value, i) => reader.big(value, `root ${names[i]}`));
  if (unit <= 0n || low >= high) refuse("root-order", `the root's interval from ${low} to ${high} over ${unit} does not rise`);
  checkPrimitive([low, high, unit], "root");
  reader.degree = degree;
  return { ring: new Ring(polynomial, rungsFrom(polynomial, low, high, unit)), root: { polynomial, low, high, unit } };
}

/** The whole matrix, from its upper triangle; positive definite, that is, its leading principal minors are positive. */
function readGram(reader, tiling, tree) {
  const { dimension, ring } = tiling;
  const rows = reader.array(tree, "gram", dimension).map((row, i) => reader.values(row, `gram[${i}]`, dimension - i));
  checkPrimitive(integersOf(rows), "gram");
  const gram = rows.map((row, i) => rows.map((_, j) => (i <= j ? row[j - i] : rows[j][i - j])));
  for (let order = 1; order <= dimension; order++) {
    const minor = determinant(ring, gram.slice(0, order).map((row) => row.slice(0, order)));
    const name = `leading principal minor ${order} of the Gram matrix`;
    demand(tiling, (at) => at.positive(minor, () => name), "gram-not-positive", (at) => `the ${name} is ${at.shown(minor)}, not positive`);
  }
  return gram;
}

/** `kind`, the rank of the lattice, and the polytope where there is one. */
function readDomain(reader, tiling, tree) {
  const { dimension } = tiling;
  if (tree === "space") return { kind: "space", rank: dimension, polytope: null };
  const [kind, value] = reader.array(tree, "domain", 2);
  if (kind === "region" && tiling.sides) refuse("family-domain", "a family has a domain with a boundary that it states, not a region");
  if (kind === "region") {
    const rank = reader.integer(value, "the region's rank");
    const fits = rank >= 0 && rank <= dimension;
    if (!fits) refuse("region-rank", `the rank ${rank} of the lattice is not from 0 to ${dimension}`);
    return { kind, rank, polytope: null };
  }
  if (!CODIMENSIONS.has(kind)) reader.fail("domain", "space, slab, prism, solid or region");
  if (kind === "prism" && dimension !== 3) refuse("prism-dimension", "a prism has dimension 3");
  const k = CODIMENSIONS.get(kind) ?? dimension;
  return { kind, rank: dimension - k, polytope: readPolytope(reader, tiling, value, k) };
}

function readStatements(reader, { dimension, kind, numbers, sides }, trees) {
  const statements = reader.array(trees, "statements").map((tree, i) => readStatement(reader, { ring: numbers, dimension }, tree, `statement ${i}`));
  if (statements[0]?.kind !== TILING) refuse("statements", `the first statement is not "${STATEMENTS[TILING]}"`);
  const rankOf = ({ kind, relation, normal = [], offset = [] }) => [kind * RELATIONS.length + (relation ?? 0), ...normal, ...offset];
  const late = statements.findIndex((statement, i) => i > 0 && byEntries(rankOf(statements[i - 1]), rankOf(statement)) >= 0);
  if (late > 0) refuse("statements", `statement ${late} is out of order or repeats the one before it`);
  for (const statement of statements) {
    const name = STATEMENTS[statement.kind];
    const isMisplaced = {
      [DELAUNAY]: kind === "region",
      [WEAKLY]: kind === "region",
      [LOCALLY]: kind !== "region",
      [LOCALLY_WEAKLY]: kind !== "region",
      [PLANE]: sides !== null,
      [NOT_DELAUNAY]: sides === undefined,
      [TCP]: kind !== "space" || dimension !== 3,
    }[statement.kind];
    if (isMisplaced) refuse("statement-domain", `"${name}" is not stated of this domain`);
  }
  return statements;
}

const isBound = (kind) => kind === LARGEST || kind === SMALLEST || kind === RATIO;

/** [normal, [offset, denominator]]: the plane normal · x = offset / denominator. Its integers have one form. */
function readPlane(reader, { dimension }, tree, place) {
  const [, normalTree, offsetTree] = reader.array(tree, place, 3);
  const normal = reader.bigs(normalTree, `the normal of ${place}`, dimension);
  checkPrimitive(normal, place);
  if (normal.find((c) => c !== 0n) < 0n) refuse("canonical", `${place}: the first entry of the normal is negative`);
  if (normal.some((c) => size(c) >= 1n << 29n)) refuse("bound-range", `${place}: an entry of the normal is too large`);
  const [p, q] = reader.array(offsetTree, place, 2);
  const offset = [reader.big(p, place), reader.positive(q, place, "bound-range")];
  checkPrimitive(offset, place);
  return { normal, offset };
}

/** `kind` and `relation` are indices of the lists above; a bound has a fraction [p, q], that of an angle also the sign of its cosine. */
function readStatement(reader, tiling, tree, place) {
  const isAlone = typeof tree === "string";
  const kind = STATEMENTS.indexOf(isAlone ? tree : reader.array(tree, place)[0]);
  if (kind < 0 || isAlone === (isBound(kind) || kind === PLANE)) refuse("statements", `${place} is unknown`);
  if (isAlone) return { kind };
  if (kind === PLANE) return { kind, ...readPlane(reader, tiling, tree, place) };
  const [, relationTree, ...rest] = reader.array(tree, place, kind === RATIO ? 3 : 4);
  const relation = RELATIONS.indexOf(reader.text(relationTree, `the relation of ${place}`));
  if (relation < 0) refuse("statements", `${place} has an unknown relation`);
  const sign = kind === RATIO ? 1 : reader.integer(rest[0], `the sign of ${place}`);
  const [p, q] = reader.array(rest.at(-1), place, 2);
  const fraction = [reader.number(p, place), reader.positive(q, place, "bound-range")];
  checkBound(tiling, kind, sign, fraction, place);
  return { kind, relation, sign, fraction };
}

/** A squared cosine is from 0 to 1, and 0 exactly if the sign is 0; a ratio is positive. */
function checkBound(tiling, kind, sign, [p, q], place) {
  checkPrimitive([...p, q], place);
  const isSign = [-1, 0, 1].includes(sign);
  const found = signOf(tiling, p, () => `bound of ${place}`, q);
  const isSmall = kind === RATIO || signOf(tiling, minus(p, tiling.ring.integer(q)), () => `bound of ${place} less 1`, q) <= 0;
  const fits = isSign && isSmall && found === Math.abs(sign);
  if (!fits) refuse("bound-range", `${place}: the sign ${sign} and the number ${shown(p, q)} are no bound`);
}

// ---- Vectors and covectors -------------------------------------------------------------------------------------------------------

const vectorBetween = (from, to) => to.map((x, k) => minus(x, from[k]));

/** The covector n with n · x = det(rows…, x), for k - 1 rows of k. */
function normal(ring, rows) {
  if (rows.length === 0) return [ring.integer(1n)];
  const [[x0, x1, x2], y] = rows;
  if (rows.length === 1) return [negated(x1), x0];
  const minor = (a, b, c, d) => ring.dot([a, negated(b)], [d, c]);
  return [minor(x1, x2, y[1], y[2]), minor(x2, x0, y[2], y[0]), minor(x0, x1, y[0], y[1])];
}

const determinant = (ring, rows) => ring.dot(normal(ring, rows.slice(0, -1)), rows.at(-1));

/** Of a symmetric matrix of order 2 or 3: its rows are the normals of the other rows in cyclic order. */
function adjugate(ring, rows) {
  if (rows.length === 2) return [[rows[1][1], negated(rows[0][1])], [negated(rows[1][0]), rows[0][0]]];
  return rows.map((_, i) => normal(ring, [rows[(i + 1) % 3], rows[(i + 2) % 3]]));
}

/** x · m y */
const pairing = (ring, x, m, y) => ring.dot(x, m.map((row) => ring.dot(row, y)));

/** The pairs (i, j), i < j, of numbers up to n. */
const pairs = (n) => Array.from({ length: n + 1 }, (_, j) => Array.from({ length: j }, (_, i) => [i, j])).flat();

const factorial = (n) => (n < 2n ? 1n : n * factorial(n - 1n));

/** Lists by their first different entries. */
function byEntries(x, y) {
  const k = x.findIndex((entry, i) => entry !== y[i]);
  return k < 0 ? 0 : x[k] - y[k];
}

/** The items that follow one another, cyclically. */
const sidesOf = (list) => list.map((p, i) => [p, list[(i + 1) % list.length]]);

// ---- The polytope of a domain (docs/soundness.md, section 3) -----------------------------------------------------------------------------
//
// h_f(x) = det(w_1 - w_0, …, w_(k-1) - w_0, x - w_0) = n · x - n · w_0 for a face f with the vertices w_0, w_1, …

function readPolytope(reader, { ring, work, places }, tree, k) {
  const [denominatorTree, vertexTrees, faceTrees] = reader.record(tree, ["denominator", "vertices", "faces"], "the polytope");
  const denominator = reader.positive(denominatorTree, "the polytope's denominator", "denominator");
  const vertices = reader.array(vertexTrees, "the polytope's vertices").map((row, w) => reader.values(row, `polytope vertex ${w}`, k));
  checkPrimitive(integersOf([denominator, vertices]), "the polytope");
  const faces = reader.array(faceTrees, "faces").map((face, f) => reader.array(face, `face ${f}`).map((w) => reader.integer(w, `face ${f}`)));
  checkIncidences(vertices, faces, k);
  const polytope = { ring, work, places, k, denominator, vertices, faces };
  polytope.planes = planesOf(polytope);
  polytope.planes.forEach((plane) => checkFacet(polytope, plane));
  if (k === 3) polytope.planes.forEach((plane) => checkPolygon(polytope, plane));
  checkClosed(polytope);
  return polytope;
}

function checkIncidences(vertices, faces, k) {
  if (faces.length <= k) refuse("face-count", `the domain has ${faces.length} faces, fewer than ${k + 1}`);
  const odd = faces.findIndex(({ length }) => !(k === 3 ? length >= 3 : length === k));
  if (odd >= 0) refuse("face-length", `face ${odd} of the domain has ${faces[odd].length} vertices`);
  const isWrong = (face) => face.some((w) => !isIndex(w, vertices.length)) || new Set(face).size < face.length;
  const wrong = faces.findIndex(isWrong);
  if (wrong >= 0) refuse("face-vertices", `a vertex of face ${wrong} of the domain does not exist or is there twice`);
  const names = new Set(faces.map((face) => [...face].sort((v, w) => v - w).join()));
  if (names.size < faces.length) refuse("face-repeated", "two faces of the domain have the same vertices");
  const used = new Set(faces.flat());
  const unused = vertices.findIndex((_, w) => !used.has(w));
  if (unused >= 0) refuse("unused-domain-vertex", `vertex ${unused} of the domain is in no face`);
}

function planesOf({ ring, vertices, faces, k }) {
  return faces.map((face, f) => {
    const [origin, ...others] = face.slice(0, k).map((w) => vertices[w]);
    const covector = normal(ring, others.map((point) => vectorBetween(origin, point)));
    return { f, face, members: new Set(face), covector, level: ring.dot(covector, origin) };
  });
}

/** h_f of a point. */
const height = ({ ring, k }, plane, point) => minus(ring.dot(plane.covector, point.slice(-k)), plane.level);

const sideOf = (plane) => () => `side of a point with respect to face ${plane.f}`;

/** h_f is zero at the vertices of f, and at the others, of which there is one, it has one strict sign s_f: that at the first one, in a point. */
function checkFacet(polytope, plane) {
  const heights = polytope.vertices.map((point) => height(polytope, plane, point));
  const other = heights.findIndex((_, w) => !plane.members.has(w));
  if (other < 0) refuse("face-not-facet", `face ${plane.f} is no facet: it has all vertices of the domain`);
  const [somewhere] = polytope.places[0].points;
  plane.inner = somewhere.positive(heights[other], sideOf(plane)) ? 1 : -1;
  heights.forEach((value, w) => {
    polytope.work.spend(1);
    const inward = scaled(value, BigInt(plane.inner));
    const isRight = (at) => (plane.members.has(w) ? at.zero(value, sideOf(plane)) : at.positive(inward, sideOf(plane)));
    demand(polytope, isRight, "face-not-facet", (at) => `face ${plane.f} is no facet: domain vertex ${w} has the determinant ${at.shown(value)}`);
  });
}

/** For sides p q, every other vertex t, and a vertex o that is not in the face, det(q - p, t - p, o - p) has the sign of h_f at o. */
function checkPolygon(polytope, { f, face, members, inner }) {
  const { ring, vertices, work } = polytope;
  const beyond = vertices.find((_, w) => !members.has(w));
  for (const [p, q] of sidesOf(face)) {
    for (const t of face.filter((t) => t !== p && t !== q)) {
      work.spend(1);
      const rows = [vertices[q], vertices[t], beyond].map((point) => vectorBetween(vertices[p], point));
      const turn = scaled(determinant(ring, rows), BigInt(inner));
      const say = () => `face ${f}: vertex ${t} is not on the inner side of the line through ${p} and ${q}`;
      demand(polytope, (at) => at.positive(turn, () => `turn at vertex ${q} of face ${f}`), "face-not-convex", say);
    }
  }
}

/** Every ridge (k = 1: the empty set, 2: a vertex, 3: a side) is in two faces. */
function checkClosed({ faces, k }) {
  const ridgesOf = [() => [""], (face) => face, (face) => sidesOf(face).map((side) => side.sort((p, q) => p - q).join())][k - 1];
  const counts = new Map();
  for (const ridge of faces.flatMap(ridgesOf)) counts.set(ridge, (counts.get(ridge) ?? 0) + 1);
  const open = [...counts].find(([, count]) => count !== 2);
  if (open) refuse("faces-not-closed", `the ridge of the domain with the vertices [${open[0]}] is in ${open[1]} faces, not in 2`);
}

/** The polytope in units of the witness's denominator. */
function rescaled(polytope, denominator) {
  const isDivisor = denominator % polytope.denominator === 0n;
  if (!isDivisor) refuse("denominator-domain", `the polytope's denominator ${polytope.denominator} does not divide ${denominator}`);
  const factor = denominator / polytope.denominator;
  const larger = { ...polytope, vertices: polytope.vertices.map((vertex) => vertex.map((x) => scaled(x, factor))) };
  larger.planes = planesOf(larger).map((plane, f) => ({ ...plane, inner: polytope.planes[f].inner }));
  return larger;
}

/** The faces that contain a vertex of the tiling, which is on the inner side of all others: s_f h_f >= 0. */
function facesAt(polytope, point, v) {
  return polytope.planes.filter((plane) => {
    polytope.work.spend(1);
    const value = height(polytope, plane, point);
    const inward = scaled(value, BigInt(plane.inner));
    const say = (at) => `vertex ${v} is beyond face ${plane.f}: the determinant is ${at.shown(value)}`;
    demand(polytope, (at) => at.atLeastZero(inward, sideOf(plane)), "vertex-outside", say);
    return holdsEverywhere(polytope, (at) => at.zero(value, sideOf(plane)));
  });
}

/**
 * k! vol P: the pyramids from the origin over the faces, counted by s_f. The sum over closed faces of
 * s_f det(w_i - w_0, …, o - w_0) does not depend on o; at the origin it is that of -s_f det(w_i, …, w_0).
 */
function volumeOf({ ring, vertices, k, planes }) {
  const pyramids = ([apex, ...others]) => {
    if (k === 1) return vertices[apex][0];
    const bases = k === 2 ? [others] : others.slice(1).map((w, i) => [others[i], w]);
    return ring.sum(bases.map((base) => determinant(ring, [...base, apex].map((w) => vertices[w]))));
  };
  return ring.sum(planes.map(({ face, inner }) => scaled(pyramids(face), BigInt(-inner))));
}

// ---- The witness -----------------------------------------------------------------------------------------------------------------

function checkWitness(reader, tiling, witness) {
  tiling.denominator = reader.positive(witness.denominator, "the witness's denominator", "denominator");
  if (tiling.polytope) tiling.polytope = rescaled(tiling.polytope, tiling.denominator);
  readVertices(reader, tiling, witness.vertices);
  const unused = reader.family ? tiling.ring.names.find((_, k) => !reader.family.used.has(k)) : undefined;
  if (unused !== undefined) refuse("unused-parameter", `the parameter ${unused} occurs nowhere`);
  tiling.open = new Map(); // the facets that wait for their mates, by name
  tiling.boundary = readBoundary(reader, tiling, witness.boundary);
  checkBoundaryApart(tiling);
  const rows = reader.array(witness.simplices, "simplices");
  if (rows.length === 0) refuse("no-simplices", "there are no simplices");
  const isMany = rows.length > reader.limits.simplices;
  if (isMany) refuse("too-many-simplices", `${rows.length} simplices, more than the limit of ${reader.limits.simplices}`);
  Object.assign(tiling, { rows: [], edges: new Map(), total: tiling.ring.zero, attained: new Map(), inside: { found: new Set(), depths: [] } });
  rows.forEach((row, s) => checkRow(reader, tiling, row, s));
  checkCovering(tiling);
  checkEnd(tiling);
}

function readVertices(reader, tiling, trees) {
  const { dimension, denominator, polytope } = tiling;
  const rows = reader.array(trees, "vertices");
  tiling.faces = [];
  tiling.vertices = rows.map((row, v) => {
    const point = reader.values(row, `vertex ${v}`, dimension);
    if (polytope) tiling.faces.push(new Set(facesAt(polytope, point, v)));
    return point;
  });
  checkPrimitive(integersOf([denominator, tiling.vertices]), "vertices");
}

/** A corner's point, in units of 1 / denominator. */
function pointOf({ ring, vertices, denominator }, [v, ...shift]) {
  return vertices[v].map((x, k) => (shift[k] ? plus(x, ring.integer(BigInt(shift[k]) * denominator)) : x));
}

const moved = ([v, ...shift], by, factor = 1) => [v, ...shift.map((entry, k) => entry + factor * by[k])];
const isUnshifted = ([, ...shift]) => shift.every((entry) => entry === 0);
const facetName = (s, i) => `the facet opposite to sorted corner ${i} of simplex ${s}`;

/** [name, base]: sorted corners have the same name as their translates; `base` is the shift of the first one. */
function nameOf(facet) {
  const base = facet[0].slice(1);
  return [facet.map((corner) => moved(corner, base, -1)).join(), base];
}

/** Listed facets wait from the beginning, on the side that a mate would have. */
function readBoundary(reader, tiling, trees) {
  const isRegion = tiling.kind === "region";
  const facets = reader.array(trees, "boundary");
  if (facets.length > 0 !== isRegion) refuse("boundary-domain", "boundary facets are listed for a region, and only for a region");
  return facets.map((tree, f) => {
    const corners = reader.array(tree, `boundary facet ${f}`, tiling.dimension).map((corner) => reader.corner(corner, `boundary facet ${f}`, tiling));
    const [first, ...others] = corners;
    const isLeast = tiling.dimension === 2 || others.every((corner) => byEntries(first, corner) < 0);
    const isOrdered = isUnshifted(first) && isLeast && byEntries(corners.at(-2), corners.at(-1)) !== 0;
    if (!isOrdered) refuse("corner-order", `the corners of boundary facet ${f} are not in order`);
    const [name] = nameOf([...corners].sort(byEntries));
    if (tiling.open.has(name)) refuse("boundary-repeated", `boundary facet ${f} is listed before`);
    const isSorted = byEntries(corners.at(-2), corners.at(-1)) < 0;
    tiling.open.set(name, { side: isSorted ? 1 : 0, listed: f });
    return surfaceOf(tiling, f, corners);
  });
}

function checkRow(reader, tiling, tree, s) {
  const corners = readRow(reader, tiling, tree, s);
  const mates = closeFacets(tiling, corners, s);
  if (tiling.statements.at(-1).kind === TCP) countEdges(reader, tiling, corners, tree.at(-1), s);
  const simplex = simplexOf(tiling, corners, s);
  const unit = tiling.denominator ** BigInt(tiling.dimension);
  const isPositive = (at) => at.positive(simplex.determinant, () => `determinant of simplex ${s}`, unit);
  demand(tiling, isPositive, "orientation", (at) => `simplex ${s} has the determinant ${at.shown(simplex.determinant)}, not a positive one`);
  tiling.statements.forEach((statement, i) => judge(tiling, simplex, mates, statement, i));
  for (const statement of tiling.statements) if (statement.kind === PLANE) judgePlane(tiling, corners, statement, s);
  tiling.total = plus(tiling.total, simplex.determinant);
  tiling.rows.push(corners);
}

/** The corners as they are listed: sorted, but the last two stand in the order of a positive determinant. */
function readRow(reader, tiling, tree, s) {
  const { dimension, statements } = tiling;
  const isTcp = statements.at(-1).kind === TCP;
  const row = reader.array(tree, `simplex ${s}`, dimension + 1 + Number(isTcp));
  const corners = row.slice(0, dimension + 1).map((corner, i) => reader.corner(corner, `corner ${i} of simplex ${s}`, tiling));
  const sorted = [...corners].sort(byEntries);
  const isOrdered =
    isUnshifted(corners[0]) &&
    corners.slice(0, -2).every((corner, i) => corner === sorted[i]) &&
    sorted.every((corner, i) => i === 0 || byEntries(sorted[i - 1], corner) < 0);
  if (!isOrdered) refuse("corner-order", `the corners of simplex ${s} are not in order`);
  const sixes = isTcp ? reader.integer(row.at(-1), `simplex ${s}`) : 0;
  if (!isIndex(sixes, 64)) refuse("sixes", `simplex ${s}: ${sixes} is not from 0 to 63`);
  return corners;
}

/**
 * The first facet with a name opens, the second closes it, and it must be on the other side. A facet in a face of the polytope has no mate.
 * Returns the corners opposite to this simplex in the mates that are simplices.
 */
function closeFacets(tiling, corners, s) {
  const sorted = [...corners].sort(byEntries);
  const isOdd = Number(sorted.at(-1) !== corners.at(-1));
  const mates = [];
  sorted.forEach((apex, i) => {
    const facet = sorted.filter((corner) => corner !== apex);
    if (isInFace(tiling, facet)) return;
    const [name, base] = nameOf(facet);
    const side = isOdd ^ (i % 2);
    const other = tiling.open.get(name);
    if (other === undefined) {
      tiling.open.set(name, { side, apex: moved(apex, base, -1), where: facetName(s, i) });
      return;
    }
    if (other.side === side) refuse("facet-side", `${facetName(s, i)} and its mate are on the same side`);
    tiling.open.delete(name);
    if (other.apex) mates.push({ i, apex: moved(other.apex, base) });
  });
  return mates;
}

/** All corners are in one face of the polytope. */
function isInFace({ polytope, faces }, facet) {
  return polytope !== null && [...faces[facet[0][0]]].some((plane) => facet.every(([v]) => faces[v].has(plane)));
}

/** The end: nothing is verified before. */
function checkEnd(tiling) {
  const entries = [...tiling.open.values()];
  const open = entries.find(({ apex }) => apex);
  if (open) refuse("open-facet", `${open.where} has no mate`);
  if (entries.length > 0) refuse("boundary-open", `boundary facet ${entries[0].listed} is a facet of no simplex`);
  const used = new Set(tiling.rows.flatMap((corners) => corners.map(([v]) => v)));
  const unused = tiling.vertices.findIndex((_, v) => !used.has(v));
  if (unused >= 0) refuse("unused-vertex", `vertex ${unused} is no corner of any simplex`);
  checkVolume(tiling);
  checkValences(tiling);
  tiling.statements.forEach((statement, i) => checkAttained(tiling, statement, i));
}

/** Some simplex attains a bound that is said to be exact, in each place. */
function checkAttained(tiling, statement, i) {
  if (statement.kind === NOT_DELAUNAY) {
    const { found, depths } = tiling.inside;
    const isInside = (at) => found.has(at) || depths.some(([depth, of]) => at.positive(depth, of));
    demand(tiling, isInside, "none-inside", () => "no vertex is found inside of a circumsphere");
  }
  if (!EXACT.includes(statement.relation)) return;
  const found = tiling.attained.get(i);
  const attains = (at) => tiling.rows.some((corners, s) => isAttained(at, comparisons(tiling, simplexOf(tiling, corners, s), statement), statement));
  demand(tiling, (at) => found.has(at) || attains(at), "not-attained", () => `statement ${i}: no simplex attains the bound`);
}

/** Σ det E = D! vol P, in units of the basis's parallelepiped; D! for space. Nothing states the volume of a region. */
function checkVolume(tiling) {
  const { ring, kind, polytope, denominator } = tiling;
  if (kind === "region") return;
  const [d, k] = [BigInt(tiling.dimension), BigInt(polytope ? polytope.k : 0)];
  const volume = polytope ? volumeOf(polytope) : ring.integer(1n);
  const expected = scaled(volume, (factorial(d) / factorial(k)) * denominator ** (d - k));
  const cell = factorial(d) * denominator ** d;
  const rest = minus(tiling.total, expected);
  const say = (at) => `the volumes of the simplices sum to ${at.shown(tiling.total, cell)} times the cell, those of the domain to ${at.shown(expected, cell)}`;
  demand(tiling, (at) => at.zero(rest, () => "sum of the volumes, minus that of the domain", cell), "volume-sum", say);
}

// ---- TCP -----------------------------------------------------------------------------------------------------------------------

const SORTED_EDGES = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];

/** A tetrahedron has no edge of valence 6, one, or two opposite ones, if no triangle has two; edges are counted by name. */
function countEdges(reader, { edges }, corners, sixes, s) {
  const sorted = [...corners].sort(byEntries);
  const six = SORTED_EDGES.filter((_, p) => (sixes >> p) & 1);
  const isAllowed = six.length < 2 || (six.length === 2 && new Set(six.flat()).size === 4);
  if (!isAllowed) refuse("triangle-valence", `a triangle of simplex ${s} has two edges that are in 6`);
  for (const edge of SORTED_EDGES) {
    const [name] = nameOf(edge.map((i) => sorted[i]));
    const stated = six.includes(edge) ? 6 : 5;
    const entry = edges.get(name) ?? { stated, found: 0 };
    if (entry.stated !== stated) refuse("edge-valence", `simplex ${s} states the valence ${stated} of an edge, another one ${entry.stated}`);
    entry.found++;
    edges.set(name, entry);
  }
}

/** In a tiling of space the valence of an edge is the number of its names in rows (docs/soundness.md, Lemma 5). */
function checkValences({ edges }) {
  for (const [name, { stated, found }] of edges) {
    if (found !== stated) refuse("edge-valence", `the edge ${name} is in ${found} tetrahedra, not in ${stated}`);
  }
}

// ---- Statements about simplices -----------------------------------------------------------------------------------------------------

/**
 * The normal of the facet opposite to corner i is det E times the gradient of the i-th barycentric coordinate. With y_0, …, y_(D-1) the other
 * points in their order, (-1)^(D-i) det(y_1 - y_0, …, y_(D-1) - y_0, x - y_0) is that coordinate times det E.
 */
class Simplex {
  constructor(tiling, points, s) {
    const { ring, dimension } = tiling;
    const normals = points.map((_, i) => {
      const [origin, ...others] = points.filter((_, j) => j !== i);
      const covector = normal(ring, others.map((point) => vectorBetween(origin, point)));
      return (dimension - i) % 2 === 0 ? covector : covector.map(negated);
    });
    Object.assign(this, { tiling, s, points, normals, determinant: null, dual: null, squares: null });
    this.determinant = this.barycentric(0, points[0]);
  }

  /** det E times the i-th barycentric coordinate of x. */
  barycentric(i, x) {
    return this.tiling.ring.dot(this.normals[i], vectorBetween(this.points[i === 0 ? 1 : 0], x));
  }

  /** det M g_i · g_j = n_i · adj(G) n_j for the gradients g of the barycentric coordinates. */
  product(i, j) {
    const { ring, dualGram } = this.tiling;
    this.dual ??= this.normals.map((covector) => dualGram.map((row) => ring.dot(row, covector)));
    return ring.dot(this.normals[i], this.dual[j]);
  }

  /** The squares of the edges, in the order of `pairs`. */
  lengths() {
    this.squares ??= pairs(this.tiling.dimension).map(([i, j]) => square(this.tiling, vectorBetween(this.points[i], this.points[j])));
    return this.squares;
  }

  /** [numerator, factor]: R² is the numerator over `factor` det M. */
  radius() {
    const { ring, dimension } = this.tiling;
    return dimension === 2 ? [heron(ring, this.lengths()), 4n] : [crelle(ring, this.lengths()), 16n];
  }

  /** det M for the Gram matrix M of the edges from a corner. */
  gramDeterminant() {
    const { ring, determinantOfGram } = this.tiling;
    return ring.times(ring.times(this.determinant, this.determinant), determinantOfGram);
  }

  /**
   * The power of w with respect to the circumsphere, times det E: π(x) = |x - w|² - Σ λ_i(x) |x_i - w|² vanishes at all x_i, so
   * π(w) det E = -Σ det E λ_i(w) |x_i - w|².
   */
  power(w) {
    const weights = this.points.map((_, i) => this.barycentric(i, w));
    const squares = this.points.map((point) => square(this.tiling, vectorBetween(w, point)));
    return negated(this.tiling.ring.dot(weights, squares));
  }
}

const simplexOf = (tiling, corners, s) => new Simplex(tiling, corners.map((corner) => pointOf(tiling, corner)), s);

const square = ({ ring, gram }, x) => pairing(ring, x, gram, x);

/** R = a b c / (4 K), and 4 K² = det M: 4 det M R² = a² b² c². */
const heron = (ring, [first, second, third]) => ring.times(ring.times(first, second), third);

/**
 * 6 V R is the area of the triangle whose sides are the three products of opposite edges (Crelle), and 36 V² = det M. So 16 det M R² is
 * 2 (A B + B C + C A) - A² - B² - C² = 4 A B - (A + B - C)² for the squares A, B, C of the products.
 */
function crelle(ring, [l01, l02, l12, l03, l13, l23]) {
  const [x, y, z] = [ring.times(l01, l23), ring.times(l02, l13), ring.times(l03, l12)];
  const rest = minus(plus(x, y), z);
  return minus(scaled(ring.times(x, y), 4n), ring.times(rest, rest));
}

const EXACT = ["maximum", "minimum"].map((name) => RELATIONS.indexOf(name));
const STRICT = ["less than", "more than"].map((name) => RELATIONS.indexOf(name));

/** Checks a statement about a single simplex, if it is one. */
function judge(tiling, simplex, mates, statement, index) {
  const { kind } = statement;
  if (isBound(kind)) return judgeBound(tiling, simplex, statement, index);
  const name = STATEMENTS[kind];
  if (name === "acute") judgeAngles(tiling, simplex, "positive", "not-acute");
  if (name === "nonobtuse") judgeAngles(tiling, simplex, "atLeastZero", "not-nonobtuse");
  if (kind === DELAUNAY || kind === LOCALLY) judgePowers(tiling, simplex, mates, "positive", "not-delaunay");
  if (kind === WEAKLY || kind === LOCALLY_WEAKLY) judgePowers(tiling, simplex, mates, "atLeastZero", "not-weakly-delaunay");
  if (kind === NOT_DELAUNAY) seekInside(tiling, simplex, mates);
}

/** Not Delaunay: keeps the powers of mates' corners until one is negative in each place. */
function seekInside(tiling, simplex, mates) {
  const { inside } = tiling;
  for (const { i, apex } of mates) {
    if (inside.found.size === tiling.places.length) return;
    const depth = negated(simplex.power(pointOf(tiling, apex)));
    const of = () => `power of the corner beyond ${facetName(simplex.s, i)}, negated`;
    for (const place of tiling.places) if (place.positive(depth, of)) inside.found.add(place);
    inside.depths.push([depth, of]);
  }
}

/** cos θ = -g_i · g_j / (|g_i| |g_j|) has the sign of -n_i · adj(G) n_j. `test` is a method of places. */
function judgeAngles(tiling, simplex, test, code) {
  for (const [i, j] of pairs(tiling.dimension)) {
    const cosine = negated(simplex.product(i, j));
    const of = () => `product of normals ${i} and ${j} of simplex ${simplex.s}, negated`;
    demand(tiling, (at) => at[test](cosine, of), code, (at) => `the ${of()}, is ${at.shown(cosine)}`);
  }
}

/**
 * The translates of the plane by the lattice are those where h(x) = (q c · x - p) / (q g) is an integer. A simplex crosses none if
 * its corners have their h between two successive integers. Without a lattice vector off the plane, g = 0, no two signs are opposite.
 */
function judgePlane(tiling, corners, { normal, offset: [p, q] }, s) {
  const { ring, denominator, rank } = tiling;
  const step = normal.slice(0, rank).reduce(gcd, 0n);
  const signAt = (height, k) => signOf(tiling, minus(height, ring.integer(k)), () => `height of a corner of simplex ${s} over a plane`);
  const heights = corners.map((corner) => {
    const terms = pointOf(tiling, corner).map((x, k) => scaled(x, normal[k] * q));
    return minus(ring.sum(terms), ring.integer(p * denominator));
  });
  const unit = q * denominator * step;
  const ends = heights.map((height) => {
    if (step === 0n) {
      const side = BigInt(signAt(height, 0n));
      return [side < 0n ? side : 0n, side > 0n ? side : 0n];
    }
    const floor = floorOf((k) => signAt(height, k * unit) < 0);
    return [floor, signAt(height, floor * unit) === 0 ? floor : floor + 1n];
  });
  const least = ends.reduce((x, [low]) => (low < x ? low : x), ends[0][0]);
  const most = ends.reduce((x, [, high]) => (high > x ? high : x), ends[0][1]);
  if (most - least > 1n) refuse("plane-crossed", `simplex ${s} crosses the plane ${planeInWords(normal, [p, q])} or a translate of it`);
}

/** The largest integer that is not above a number, by halving. */
function floorOf(isAbove) {
  let [low, high] = [-1n, 1n];
  while (isAbove(low)) low *= 2n;
  while (!isAbove(high)) high *= 2n;
  while (high - low > 1n) {
    const middle = (low + high) >> 1n;
    [low, high] = isAbove(middle) ? [low, middle] : [middle, high];
  }
  return low;
}

const planeInWords = (normal, [p, q]) => `(${normal.join(", ")}) · x = ${ratio(p, q)}`;

function judgePowers(tiling, simplex, mates, test, code) {
  for (const { i, apex } of mates) {
    const value = simplex.power(pointOf(tiling, apex));
    const of = () => `power of the corner beyond ${facetName(simplex.s, i)}`;
    demand(tiling, (at) => at[test](value, of), code, (at) => `the ${of()} with respect to the circumsphere is ${at.shown(value)}`);
  }
}

function judgeBound(tiling, simplex, statement, index) {
  const { kind, relation } = statement;
  const found = comparisons(tiling, simplex, statement);
  const test = STRICT.includes(relation) ? "positive" : "atLeastZero";
  const isUpper = relation < RELATIONS.indexOf("more than");
  const where = kind === RATIO ? "edges" : "angles";
  const say = () => `simplex ${simplex.s} does not fulfil statement ${index}, by its ${where}`;
  demand(tiling, (at) => (isUpper ? isBelow : isAbove)(at, found, kind, test), kind === RATIO ? "ratio-bound" : "angle-bound", say);
  if (!EXACT.includes(relation)) return;
  const attained = tiling.attained.get(index) ?? new Set();
  tiling.attained.set(index, attained);
  if (attained.size === tiling.places.length) return;
  for (const place of tiling.places) if (!attained.has(place) && isAttained(place, found, statement)) attained.add(place);
}

/** The largest quantity is less than a bound if all are, the smallest one if some is. */
const isBelow = (at, found, kind, test) => (kind === SMALLEST ? found.some((x) => x.below(at, test)) : found.every((x) => x.below(at, test)));
const isAbove = (at, found, kind, test) => (kind === SMALLEST ? found.every((x) => x.above(at, test)) : found.some((x) => x.above(at, test)));
const isAttained = (at, found, { kind }) => isBelow(at, found, kind, "atLeastZero") && isAbove(at, found, kind, "atLeastZero");

/** Each angle, or the ratio for each edge, beside the bound. */
function comparisons(tiling, simplex, statement) {
  const compare = statement.kind === RATIO ? ratioBeside : angleBeside;
  return pairs(tiling.dimension).map(([i, j], e) => compare(tiling, simplex, statement, i, j, e));
}

/** θ and arccos(c), with cos θ = x / √y and c = s √(p/q): θ is less where the cosine is more, by its sign or by its square. */
function angleBeside({ ring }, simplex, { sign: s, fraction: [p, q] }, i, j) {
  const of = () => `cosine of facets ${i} and ${j} of simplex ${simplex.s}, compared`;
  const x = negated(simplex.product(i, j));
  let excess = null;
  const squares = () => {
    const y = ring.times(simplex.product(i, i), simplex.product(j, j));
    return (excess ??= minus(scaled(ring.times(x, x), q), ring.times(p, y)));
  };
  /** Whether ±cos θ > ±c, or >= */
  const isMore = (at, test, way) => {
    const cosine = way > 0 ? x : negated(x);
    if (s === 0) return at[test](cosine, of);
    const isNotNegative = at.atLeastZero(cosine, of);
    if (s * way > 0) return isNotNegative && at[test](squares(), of);
    return isNotNegative || at[test](negated(squares()), of);
  };
  return { below: (at, test) => isMore(at, test, 1), above: (at, test) => isMore(at, test, -1) };
}

/** R² / l² and p/q for one edge; the shortest edge has the greatest quotient. */
function ratioBeside({ ring }, simplex, { fraction: [p, q] }, i, j, e) {
  const of = () => `radius less edge ${i} ${j} of simplex ${simplex.s}`;
  const [radius, factor] = simplex.radius();
  const bound = scaled(ring.times(ring.times(p, simplex.gramDeterminant()), simplex.lengths()[e]), factor);
  const excess = minus(scaled(radius, q), bound);
  return { below: (at, test) => at[test](negated(excess), of), above: (at, test) => at[test](excess, of) };
}

// ---- The boundary of a region --------------------------------------------------------------------------------------------------------
//
// X: any two boundary facets, also translates, meet in the hull of their common corners. W: no tile is directly outside of one.

/** A boundary facet with its points, and a covector that is positive outside. */
function surfaceOf(tiling, f, corners) {
  const points = corners.map((corner) => pointOf(tiling, corner));
  const left = normal(tiling.ring, points.slice(1).map((point) => vectorBetween(points[0], point)));
  const outward = tiling.dimension === 2 ? left.map(negated) : left;
  return { f, corners, points, outward };
}

const signInBoundary = (tiling, value) => signOf(tiling, value, () => "position of two boundary facets");

function checkBoundaryApart(tiling) {
  const { boundary } = tiling;
  const boxes = boundary.map(({ points }) => boxOf(tiling, points));
  eachOverlap(tiling, boxes, boxes, (f, g, shift) => {
    const isOther = f < g || (f === g && shift.find((entry) => entry !== 0n) > 0n);
    if (!isOther) return;
    tiling.work.spend(10);
    const other = surfaceOf(tiling, g, movedFar(boundary[g].corners, shift));
    if (meetInShared(tiling, boundary[f], other)) return;
    refuse("boundary-meets", `boundary facets ${f} and ${g}, moved by [${shift}], meet outside of their common corners`);
  });
}

/** The least and the greatest coordinates, in units of 1 / (denominator · GRAIN), rounded outwards. */
function boxOf({ ring, dimension }, points) {
  const bounds = points.map((point) => point.map((x) => ring.bounds(x, GRAIN)));
  const extreme = (end, isBetter) =>
    Array.from({ length: dimension }, (_, k) => bounds.map((bound) => bound[k][end]).reduce((x, y) => (isBetter(y, x) ? y : x)));
  return { low: extreme(0, (x, y) => x < y), high: extreme(1, (x, y) => x > y) };
}

const GRAIN = 1n << 20n;

/**
 * Calls `visit(a, b, shift)` for all first boxes and all translates of second boxes that overlap: a sweep along the last coordinate. The
 * entries of the shift are BigInt: vertices of one region may be any number of cells apart.
 */
function eachOverlap(tiling, first, second, visit) {
  const { rank, dimension, denominator, work } = tiling;
  const step = denominator * GRAIN;
  const axes = Array.from({ length: rank }, (_, k) => k);
  const homes = (boxes) =>
    boxes.map((box, index) => {
      const cell = axes.map((k) => floor(box.low[k], step));
      return translated({ ...box, index, cell }, axes.map((k) => -cell[k]), step);
    });
  const queries = homes(first);
  const reach = axes.map((k) => queries.reduce((most, { high }) => (high[k] > most ? high[k] : most), 0n));
  const copies = homes(second).flatMap((box) => {
    let shifts = [[]];
    for (const k of axes) {
      const [from, to] = [-floor(box.high[k], step), floor(reach[k] - box.low[k], step)];
      work.spend(Number(to - from + 1n) * shifts.length);
      shifts = shifts.flatMap((shift) => Array.from({ length: Number(to - from + 1n) }, (_, i) => [...shift, from + BigInt(i)]));
    }
    return shifts.map((shift) => ({ ...translated(box, shift, step), shift, isCopy: true }));
  });
  const last = dimension - 1;
  const open = [[], []];
  for (const box of [...queries, ...copies].sort((x, y) => sign(x.low[last] - y.low[last]))) {
    const [own, others] = box.isCopy ? [1, 0] : [0, 1];
    open[own].push(box);
    work.spend(open[others].length);
    open[others] = open[others].filter((other) => other.high[last] >= box.low[last]);
    for (const other of open[others].filter((other) => overlap(box, other))) {
      const [query, copy] = box.isCopy ? [other, box] : [box, other];
      visit(query.index, copy.index, copy.shift.map((s, k) => s - copy.cell[k] + query.cell[k]));
    }
  }
}

const movedFar = (corners, by) => corners.map(([v, ...shift]) => [v, ...shift.map((entry, k) => BigInt(entry) + by[k])]);

function translated(box, shift, step) {
  const move = (ends) => ends.map((x, k) => (k < shift.length ? x + shift[k] * step : x));
  return { ...box, low: move(box.low), high: move(box.high) };
}

const overlap = (x, y) => x.low.every((low, k) => low <= y.high[k] && y.low[k] <= x.high[k]);

/**
 * None shared: where two facets meet, an edge of one meets the other. One: only the edges opposite to it need be examined, for beyond another
 * common point the ray from the corner leaves one facet there, inside of the other. Two: the facets are in different planes, or on
 * different sides of their edge.
 */
function meetInShared(tiling, f, g) {
  const names = [f, g].map(({ corners }) => corners.map((corner) => corner.join()));
  const shared = f.points.filter((_, i) => names[1].includes(names[0][i]));
  const mine = f.points.filter((_, i) => !names[1].includes(names[0][i]));
  const theirs = g.points.filter((_, i) => !names[0].includes(names[1][i]));
  if (mine.length === 0) return false;
  if (tiling.dimension === 2) return shared.length === 0 ? !segmentsMeet(tiling, f.points, g.points) : areApart(tiling, shared, mine[0], theirs[0]);
  if (shared.length === 2) return areApart(tiling, shared, mine[0], theirs[0]);
  const edges = (points, rest) => (shared.length === 0 ? sidesOf(points) : [rest]);
  return !edges(f.points, mine).some((edge) => cuts(tiling, edge, g)) && !edges(g.points, theirs).some((edge) => cuts(tiling, edge, f));
}

/** Facets that share all corners but p of one and q of the other: not in one line or plane, or on different sides. */
function areApart(tiling, shared, p, q) {
  const { ring } = tiling;
  const vectors = [...shared.slice(1), p, q].map((x) => vectorBetween(shared[0], x));
  const [n, m] = vectors.slice(-2).map((x) => normal(ring, [...vectors.slice(0, -2), x]));
  const isFlat = signInBoundary(tiling, ring.dot(n, vectors.at(-1))) === 0;
  return !isFlat || signInBoundary(tiling, ring.dot(n, m)) < 0;
}

/** Whether two segments of the plane, with their ends, meet. */
function segmentsMeet(tiling, [p, q], [u, v]) {
  const { ring } = tiling;
  const turn = (x, y, z) => signInBoundary(tiling, determinant(ring, [vectorBetween(x, y), vectorBetween(x, z)]));
  const sides = [turn(p, q, u), turn(p, q, v), turn(u, v, p), turn(u, v, q)];
  if (sides.some((side) => side !== 0)) return sides[0] * sides[1] <= 0 && sides[2] * sides[3] <= 0;
  // On one line they meet if an end of one is in the other: the vectors to the other's ends are opposite, or one is zero.
  const isBetween = (x, y, z) => signInBoundary(tiling, ring.dot(vectorBetween(x, y), vectorBetween(x, z))) <= 0;
  return isBetween(u, p, q) || isBetween(v, p, q) || isBetween(p, u, v);
}

/** Whether a segment, with its ends, meets a triangle, with its boundary. */
function cuts(tiling, [p, q], { points, outward: n }) {
  const { ring } = tiling;
  const sides = [p, q].map((x) => signInBoundary(tiling, ring.dot(n, vectorBetween(points[0], x))));
  if (sides[0] === sides[1]) return sides[0] === 0 && cutsInPlane(tiling, [p, q], points, n);
  // The line meets the plane in one point, of the segment; it is in the triangle if the line does not pass two sides in different senses.
  const along = vectorBetween(p, q);
  const senses = sidesOf(points).map((side) => {
    const across = normal(ring, side.map((x) => vectorBetween(p, x)));
    return signInBoundary(tiling, ring.dot(along, across));
  });
  return !(senses.includes(1) && senses.includes(-1));
}

/** In the plane with the normal n, a line separates them: strictly the triangle from a side's line, or from the segment's. */
function cutsInPlane(tiling, [p, q], points, n) {
  const { ring } = tiling;
  const turn = (u, v, w) => signInBoundary(tiling, ring.dot(normal(ring, [v, w].map((x) => vectorBetween(u, x))), n));
  const isBeyond = ([v, w]) => turn(v, w, p) < 0 && turn(v, w, q) < 0;
  if (sidesOf(points).some(isBeyond)) return false;
  const [first, ...others] = points.map((x) => turn(p, q, x));
  return first === 0 || others.some((side) => side !== first);
}

/**
 * No tile contains the point x = m + ε o + ε² e_1 + ε³ e_2 + … for small ε > 0, where m is the centroid of a boundary facet and o points out.
 * x is directly outside of the facet and in no plane of a facet. A value of the barycentric coordinate at x, a polynomial in ε, has the sign of
 * its first coefficient that is not zero.
 */
function checkCovering(tiling) {
  const { boundary, rows, dimension } = tiling;
  if (boundary.length === 0) return;
  const centres = boundary.map(({ points }) => centreBox(tiling, points));
  const boxes = rows.map((corners) => boxOf(tiling, corners.map((corner) => pointOf(tiling, corner))));
  eachOverlap(tiling, centres, boxes, (f, s, shift) => {
    tiling.work.spend(10);
    const simplex = simplexOf(tiling, movedFar(rows[s], shift), s);
    const isOutside = simplex.normals.some((covector, i) => {
      const origin = simplex.points[i === 0 ? 1 : 0];
      const offset = boundary[f].points.reduce((sum, point) => sum.map((x, k) => plus(x, minus(point[k], origin[k]))), origin.map(() => tiling.ring.zero));
      return firstSign(tiling, [tiling.ring.dot(covector, offset), tiling.ring.dot(covector, boundary[f].outward), ...covector]) < 0;
    });
    if (!isOutside) refuse("covering", `simplex ${s}, moved by [${shift}], is directly outside of boundary facet ${f}`);
  });
}

function centreBox(tiling, points) {
  const { ring, dimension } = tiling;
  const sums = Array.from({ length: dimension }, (_, k) => ring.bounds(ring.sum(points.map((point) => point[k])), GRAIN));
  const count = BigInt(dimension);
  return { low: sums.map(([low]) => floor(low, count)), high: sums.map(([, high]) => -floor(-high, count)) };
}

function firstSign(tiling, values) {
  for (const value of values) {
    const found = signInBoundary(tiling, value);
    if (found !== 0) return found;
  }
  return 0;
}

// ---- Systems of patches (docs/format.md, docs/soundness.md, section 10) -----------------------------------------------------------------
//
// A point that is computed across a wall is divided by the square of the wall's length. It is `{x, weight}`: the coordinates times a positive
// number, in units of 1 / unit for the common denominator `unit` of all patches.

function checkedSystem(reader, claim, witness) {
  const [field, gram, rankTree, tiles, statements] = reader.record(claim, ["field", "gram", "rank", "tiles", "statements"], "the claim");
  const rank = reader.integer(rankTree, "the rank");
  if (rank !== 1 && rank !== 2) refuse("rank", `the rank ${rank} is not 1 or 2`);
  const { ring, root } = readField(reader, field);
  const system = { dimension: 3, kind: "space", rank, ring, numbers: ring, root, work: new Work(reader.limits.work), attained: new Map() };
  system.places = [new Numbers(system)];
  system.gram = readGram(reader, system, gram);
  checkBlocks(system);
  Object.assign(system, { determinantOfGram: determinant(ring, system.gram), dualGram: adjugate(ring, system.gram) });
  if (reader.array(tiles, "tiles").length === 0) refuse("tile-count", "there is no tile");
  system.statements = readStatements(reader, system, statements);
  if (reader.array(witness, "the witness").length !== tiles.length) refuse("tile-count", `${witness.length} patches for ${tiles.length} tiles`);
  system.patches = tiles.map((tile, i) => readPatch(reader, system, { field, gram }, tile, witness[i], i));
  system.unit = system.patches.reduce((common, { tiling }) => (common / gcd(common, tiling.denominator)) * tiling.denominator, 1n);
  system.rows = system.patches.flatMap(({ rows }) => rows);
  system.vertices = system.patches.flatMap(({ tiling }) => tiling.vertices);
  system.sides = system.patches.flatMap((patch) => patch.classes.map((label, number) => sideOfTile(system, patch, number, label)));
  checkWalls(system);
  const corners = rank === 1 ? checkTurns(system) : null;
  system.joins = joinsOf(system);
  judgeCells(system);
  judgeLocally(system);
  if (system.statements.at(-1).kind === TCP) checkSystemValences(system, corners);
  system.statements.forEach(({ relation }, i) => {
    if (EXACT.includes(relation) && system.attained.get(i).size === 0) refuse("not-attained", `statement ${i}: no cell of a piece attains the bound`);
  });
  return system;
}

/** The lattice and the base are orthogonal. */
function checkBlocks(system) {
  const { gram, rank } = system;
  for (let i = 0; i < rank; i++) {
    for (let j = rank; j < 3; j++) {
      const say = (at) => `the product of the basis vectors ${i + 1} and ${j + 1} is ${at.shown(gram[i][j])}, not 0`;
      demand(system, (at) => at.zero(gram[i][j], () => "product of basis vectors"), "gram-blocks", say);
    }
  }
}

/** A tile and its patch; the prism or slab with the piece and the fans is checked as a tiling. */
function readPatch(reader, system, metric, tileTree, tree, i) {
  const { rank } = system;
  const [denominator, vertices, classTrees] = reader.record(tileTree, ["denominator", "vertices", "classes"], `tile ${i}`);
  const count = reader.array(vertices, `tile ${i}`).length;
  const classes = reader.array(classTrees, `tile ${i}`, count).map((label) => reader.big(label, `tile ${i}`));
  const isCounted = rank === 1 ? count >= 3 : count === 2;
  if (!isCounted) refuse("side-count", `tile ${i} has ${count} vertices`);
  const names = ["denominator", "offsets", "vertices", "pyramids", "simplices"];
  const [unit, offsetTrees, vertexTrees, pyramidTrees, rowTrees] = reader.record(tree, names, `patch ${i}`);
  if (reader.array(rowTrees, `patch ${i}`).length === 0) refuse("no-simplices", `patch ${i} has no simplex`);
  const pyramids = reader.array(pyramidTrees, `patch ${i}`).map((pyramid, p) => readPyramid(reader, rank, pyramid, `pyramid ${p} of patch ${i}`));
  const faces = classes.map((_, side) => (rank === 1 ? [side, (side + 1) % count] : [side]));
  const domain = [rank === 1 ? "prism" : "slab", { denominator, vertices, faces }];
  const own = new Reader(reader.limits);
  const tiling = readClaim(own, { dimension: 3, ...metric, domain, statements: [STATEMENTS[TILING]] });
  checkWitness(own, tiling, { denominator: unit, vertices: vertexTrees, boundary: [], simplices: [...rowTrees, ...pyramids.flatMap(fanTrees)] });
  const offsets = reader.array(offsetTrees, `patch ${i}`, count).map((offset) => reader.values(offset, `an offset of patch ${i}`, rank));
  const patch = { i, tiling, classes, offsets, pyramids, corners: tiling.polytope.vertices, rows: tiling.rows.slice(0, rowTrees.length) };
  pyramids.forEach((pyramid, p) => (pyramid.side = sideOfPyramid(patch, pyramid, p)));
  checkTileOrder(system, patch);
  return patch;
}

function readPyramid(reader, rank, tree, place) {
  const [apexTree, polygonTree] = reader.array(tree, place, 2);
  const anyVertex = { rank, vertices: { length: Infinity } }; // The rows of the fans show whether it exists.
  const [apex, ...polygon] = [apexTree, ...reader.array(polygonTree, place)].map((corner) => reader.corner(corner, place, anyVertex));
  const isPolygon = polygon.length >= 3 && isUnshifted(polygon[0]) && new Set([apex, ...polygon].map(String)).size === polygon.length + 1;
  if (!isPolygon) refuse("pyramid", `${place} is not an apex and a polygon that begins with the shift zero`);
  return { apex, polygon };
}

/** The rows of the tetrahedra over a triangulation of the polygon, as if (h_0, h_i, h_(i+1), apex) were positive. */
function fanTrees({ apex, polygon }) {
  return polygon.slice(2).map((corner, i) => {
    const order = [polygon[0], polygon[i + 1], corner, apex];
    const inversions = pairs(3).filter(([j, k]) => byEntries(order[j], order[k]) > 0).length;
    const row = [...order].sort(byEntries);
    if (inversions % 2 === 1) row.push(...row.splice(2).reverse());
    const base = row[0].slice(1);
    return row.map((x) => moved(x, base, -1)).map((x) => (isUnshifted(x) ? x[0] : x));
  });
}

/** The numbers of the sides that contain all these corners. */
function sidesWith({ tiling }, corners) {
  const [first, ...others] = corners.map(([v]) => [...tiling.faces[v]].map(({ f }) => f));
  return first.filter((f) => others.every((faces) => faces.includes(f)));
}

function sideOfPyramid(patch, { apex, polygon }, p) {
  const sides = sidesWith(patch, polygon);
  const isOver = sidesWith(patch, [apex]).length === 0 && sides.length === 1;
  if (!isOver) refuse("pyramid-side", `the polygon of pyramid ${p} of patch ${patch.i} is not in one side, or its apex is in a side`);
  return sides[0];
}

function checkTileOrder(system, { corners, i }) {
  const { ring } = system;
  const turn = system.rank === 2 ? minus(corners[1][0], corners[0][0]) : determinant(ring, [1, 2].map((w) => vectorBetween(corners[0], corners[w])));
  const say = () => `the vertices of tile ${i} are not ${system.rank === 1 ? "counterclockwise" : "in increasing order"}`;
  demand(system, (at) => at.positive(turn, () => "turn of a tile"), "tile-order", say);
}

// Walls.

/** A side in the common unit: its beginning w, its vector u, the vector v with ⟨u, v⟩ = 0 and det(u, v) = ⟨u, u⟩, and this length. */
function sideOfTile(system, patch, number, label) {
  const { ring, gram, rank, unit } = system;
  const factor = unit / patch.tiling.denominator;
  const corner = (w) => patch.corners[w % patch.corners.length].map((x) => scaled(x, factor));
  const side = { system, patch, number, label: String(label), factor, start: corner(number), length: ring.integer(1n) };
  side.offset = patch.offsets[number].map((x) => scaled(x, factor));
  if (rank === 1) {
    side.along = vectorBetween(side.start, corner(number + 1));
    const dual = [gram[1], gram[2]].map((row) => ring.dot(row.slice(1), side.along));
    side.across = [negated(dual[1]), dual[0]];
    side.length = ring.dot(dual, side.along);
    side.dual = dual;
  }
  return side;
}

/** The wall coordinates of a corner, [f…, X, Y] or [f…, Y]; those that the tile beyond the wall gives it, if the side is turned. */
function wallCoordinates({ system, patch, factor, offset, start, along, dual, length }, corner, isTurned) {
  const { ring, rank } = system;
  const point = pointOf(patch.tiling, corner).map((x) => scaled(x, factor));
  const fibre = point.slice(0, rank).map((x, k) => minus(x, offset[k]));
  const base = vectorBetween(start, point.slice(rank));
  if (rank === 2) return [...fibre, base[0]];
  const [x, y] = [ring.dot(dual, base), determinant(ring, [along, base])];
  return [...fibre, ...(isTurned ? [minus(length, x), negated(y)] : [x, y])];
}

/**
 * A list of corners in a side, in cyclic order: its text is the same for translates under the lattice, in each sense, and from each beginning.
 * `base` is the translation, and `places` the corners' own texts. Entries of the lattice change the constant coefficients of f alone.
 */
function outlineOf(side, corners, isTurned) {
  const { rank, unit } = side.system;
  const points = corners.map((corner) => wallCoordinates(side, corner, isTurned));
  const cells = points.map((point) => point.slice(0, rank).map((x) => floor(x[0], unit)));
  const base = cells.reduce((least, cell) => (isBefore(cell, least) ? cell : least));
  const places = points.map((point) =>
    point.slice(0, 2).map((x, k) => (k < rank ? x.map((c, i) => (i === 0 ? c - base[k] * unit : c)) : x)).join(" ; "),
  );
  const beginnings = places.flatMap((_, i) => {
    const turned = [...places.slice(i), ...places.slice(0, i)];
    return [turned, [turned[0], ...turned.slice(1).reverse()]].map((list) => list.join(" | "));
  });
  return { text: beginnings.sort()[0], base, places };
}

function isBefore(x, y) {
  const k = x.findIndex((entry, i) => entry !== y[i]);
  return k >= 0 && x[k] < y[k];
}

/** All polygons in a side, by their texts: triangles of the piece with their tetrahedra, and polygons of pyramids. */
function patternOf(side, isTurned) {
  const { patch, number } = side;
  const pattern = new Map();
  const add = (corners, kind, more) => {
    const outline = outlineOf(side, corners, isTurned);
    pattern.set(`${kind} ${outline.text}`, { corners, ...outline, ...more });
  };
  patch.pyramids.forEach((pyramid) => pyramid.side === number && add(pyramid.polygon, "pyramid", { apex: pyramid.apex, pyramid }));
  for (const row of patch.rows) {
    for (const apex of row) {
      const facet = row.filter((corner) => corner !== apex);
      if (sidesWith(patch, facet).includes(number)) add(facet, "triangle", { apex, row });
    }
  }
  return pattern;
}

const sameTexts = (one, other) => one.size === other.size && [...one.keys()].every((text) => other.has(text));

/** All sides of a class look like its first one, and turned sides too. */
function checkWalls(system) {
  const first = new Map();
  for (const side of system.sides) {
    side.seen = patternOf(side, false);
    side.beyond = system.rank === 1 ? patternOf(side, true) : side.seen;
    system.work.spend(side.seen.size);
    if (!first.has(side.label)) first.set(side.label, side);
    const wall = first.get(side.label);
    const name = `side ${side.number} of tile ${side.patch.i}`;
    const isSame = sameTexts(side.seen, wall.seen) && side.length.every((c, k) => c === wall.length[k]);
    if (!isSame) refuse("wall-pattern", `the pattern of ${name} is not that of class ${side.label}`);
    if (!sameTexts(side.beyond, wall.seen)) refuse("wall-reversal", `turned round, the pattern of ${name} is not that of class ${side.label}`);
  }
}

// Corners of tiles.

const WHOLE = 60;

/** The angles of all tiles, as multiples of 1 / whole of a turn; the offsets follow them. */
function checkTurns(system) {
  const turns = system.patches.map((patch) => patch.corners.map((_, i) => turnAt(system, patch, i)));
  const whole = turns.flat().reduce((common, [, n]) => (common / Number(gcd(BigInt(common), BigInt(n)))) * n, 1);
  if (whole > WHOLE) refuse("corner-angle", `the angles of the tiles are multiples of 1/${whole} of a turn, not of 1/${WHOLE} or more`);
  const angles = turns.map((row) => row.map(([a, n]) => (a * whole) / n));
  const steps = system.patches.flatMap(({ offsets, tiling, i }) =>
    offsets.map((offset, k) => {
      const [constant, ...others] = scaled(minus(offsets.at(k - 1)[0], offset[0]), BigInt(whole));
      const isWhole = isZero(others) && constant % tiling.denominator === 0n;
      if (!isWhole) refuse("side-classes", `at corner ${k} of tile ${i} the offsets do not differ by a multiple of 1/${whole}`);
      return [constant / tiling.denominator, BigInt(angles[i][k])];
    }),
  );
  const candidates = Array.from({ length: whole }, (_, n) => BigInt(n));
  const isConsistent = candidates.some((n) => steps.every(([step, a]) => (step - a * n) % BigInt(whole) === 0n));
  if (!isConsistent) refuse("side-classes", "the offsets do not close around the vertices of a mosaic");
  return { angles, whole };
}

/** [a, n]: the angle at a corner of a tile is a / n of a turn, in lowest terms. */
function turnAt(system, { corners, i }, k) {
  const { ring, gram } = system;
  const [to, from] = [k + 1, k - 1 + corners.length].map((w) => vectorBetween(corners[k], corners[w % corners.length]));
  const metric = [gram[1], gram[2]].map((row) => row.slice(1));
  const area = determinant(ring, metric);
  // ⟨to, from⟩ and det(to, from), times √area, are a complex number with this argument.
  const z = [pairing(ring, to, metric, from), determinant(ring, [to, from])];
  const signAt = (x) => signOf(system, x, () => `angle at corner ${k} of tile ${i}`);
  let [power, turns] = [z, 0];
  for (let n = 1; n <= WHOLE; n++) {
    if (signAt(power[1]) === 0 && signAt(power[0]) > 0) return [turns, n];
    const product = [minus(ring.times(power[0], z[0]), ring.times(area, ring.times(power[1], z[1]))), ring.dot(power, [z[1], z[0]])];
    if (signAt(power[1]) < 0 && signAt(product[1]) >= 0) turns++;
    power = product;
  }
  return refuse("corner-angle", `the angle at corner ${k} of tile ${i} is no multiple of 1/${WHOLE} of a turn or of a greater part`);
}

// Cells: those of the pieces, and those around the axes of joins.

/** A corner of a patch as a point. */
function tilePoint({ ring, unit }, { tiling }, corner) {
  const factor = unit / tiling.denominator;
  return { x: pointOf(tiling, corner).map((x) => scaled(x, factor)), weight: ring.integer(1n) };
}

/** A corner of the tile that meets this side with `other`, in the coordinates of this side's tile; `shift` moves it in the lattice. */
function pointBeyond(side, other, corner, shift) {
  const { ring, rank, unit } = side.system;
  const there = wallCoordinates(other, corner, rank === 1);
  const fibre = there.slice(0, rank).map((f, k) => plus(plus(f, side.offset[k]), ring.integer(shift[k] * unit)));
  if (rank === 2) return { x: [...fibre, plus(there[2], side.start[0])], weight: ring.integer(1n) };
  // ⟨u, u⟩ b = X u + Y v
  const base = side.start.map((w, k) => plus(ring.times(w, side.length), ring.dot([there[1], there[2]], [side.along[k], side.across[k]])));
  return { x: [...fibre.map((f) => ring.times(f, side.length)), ...base], weight: side.length };
}

/** The coordinates of some points, all times one positive number. */
function commonCoordinates({ ring }, points) {
  const weights = new Map(points.map(({ weight }) => [String(weight), weight]));
  return points.map(({ x, weight }) => {
    const factors = [...weights].filter(([text]) => text !== String(weight)).map(([, other]) => other);
    return factors.reduce((vector, factor) => vector.map((entry) => ring.times(entry, factor)), x);
  });
}

const canMeet = (side, other) => side.label === other.label && (side.system.rank === 1 || side.number !== other.number);

/** Calls `visit` for each polygon of two sides that can meet, in both orders, and the vector that moves the other tile. */
function eachMeeting({ sides, work }, visit) {
  for (const side of sides) {
    for (const other of sides.filter((other) => canMeet(side, other))) {
      work.spend(side.seen.size);
      for (const [text, mine] of side.seen) {
        const theirs = other.beyond.get(text);
        visit(side, other, mine, theirs, mine.base.map((entry, k) => entry - theirs.base[k]));
      }
    }
  }
}

function joinsOf(system) {
  const joins = [];
  eachMeeting(system, (side, other, mine, theirs, shift) => {
    if (!mine.pyramid) return;
    const l = tilePoint(system, side.patch, mine.apex);
    const m = pointBeyond(side, other, theirs.apex, shift);
    const polygon = mine.corners.map((corner) => tilePoint(system, side.patch, corner));
    const cells = sidesOf(polygon).map(([h, next]) => [m, h, next, l]);
    const join = { side, other, mine, theirs, polygon, l, m, cells };
    join.simplices = cells.map((cell) => new Simplex(system, commonCoordinates(system, cell), joins.length));
    for (const { determinant } of join.simplices) {
      const say = () => `the axis between the apexes over side ${side.number} of tile ${side.patch.i} and side ${other.number} of tile ${other.patch.i} does not cross their polygon`;
      demand(system, (at) => at.positive(determinant, () => "determinant of a cell of a join"), "missing-join", say);
    }
    joins.push(join);
  });
  return joins;
}

/** Statements about single cells. Only a cell of a piece shows that a bound is attained. */
function judgeCells(system) {
  const pieces = system.patches.flatMap((patch) => patch.rows.map((row) => row.map((corner) => tilePoint(system, patch, corner).x)));
  pieces.forEach((points, s) => {
    const simplex = new Simplex(system, points, s);
    system.statements.forEach((statement, i) => judge(system, simplex, [], statement, i));
  });
  const apart = { ...system, attained: new Map() };
  for (const { simplices } of system.joins) {
    for (const simplex of simplices) system.statements.forEach((statement, i) => judge(apart, simplex, [], statement, i));
  }
}

/** Delaunay: at each facet that two cells can have in common. */
function judgeLocally(system) {
  for (const { kind } of system.statements) {
    if (kind !== DELAUNAY && kind !== WEAKLY) continue;
    const [test, code] = kind === DELAUNAY ? ["positive", "not-delaunay"] : ["atLeastZero", "not-weakly-delaunay"];
    const judgePair = (cell, point, name) => {
      const [w, ...corners] = commonCoordinates(system, [point, ...cell]);
      const power = new Simplex(system, corners, 0).power(w);
      const say = () => `the corner beyond a facet of a cell ${name} is not outside of the circumsphere`;
      demand(system, (at) => at[test](power, () => `power of a corner beyond a cell ${name}`), code, say);
    };
    eachNeighbour(system, judgePair);
  }
}

/** Calls `visit` for a cell, the opposite corner of one with a common facet, and words for the place. */
function eachNeighbour(system, visit) {
  for (const { polygon, cells } of system.joins) cells.forEach((cell, i) => visit(cell, polygon[(i + 2) % polygon.length], "of a join"));
  eachMeeting(system, (side, other, mine, theirs, shift) => {
    if (mine.pyramid) return;
    const cell = mine.row.map((corner) => tilePoint(system, side.patch, corner));
    visit(cell, pointBeyond(side, other, theirs.apex, shift), `at side ${side.number} of tile ${side.patch.i}`);
  });
  for (const patch of system.patches) {
    for (const [one, other] of innerFacets(system, patch)) {
      const shift = one.base.map((entry, k) => BigInt(entry - other.base[k]));
      for (const { cell } of one.cells) for (const { point } of other.cells) visit(cell, movedPoint(system, point, shift), `in patch ${patch.i}`);
    }
  }
}

function movedPoint({ ring, unit }, { x, weight }, shift) {
  return { x: x.map((entry, k) => (k < shift.length ? plus(entry, scaled(weight, shift[k] * unit)) : entry)), weight };
}

/** Facets inside of a tile, with the cells that can be on each side, and their opposite corners. Facets inside of pyramids are none. */
function innerFacets(system, patch) {
  const groups = new Map();
  const add = (facet, cells) => {
    const [name, base] = nameOf([...facet].sort(byEntries));
    groups.set(name, [...(groups.get(name) ?? []), { base, cells }]);
  };
  const point = (corner) => tilePoint(system, patch, corner);
  for (const row of patch.rows) {
    for (const apex of row) {
      const facet = row.filter((corner) => corner !== apex);
      if (sidesWith(patch, facet).length === 0) add(facet, [{ cell: row.map(point), point: point(apex) }]);
    }
  }
  for (const pyramid of patch.pyramids) {
    const joins = system.joins.filter(({ mine }) => mine.pyramid === pyramid);
    sidesOf(pyramid.polygon).forEach(([h, next], i) => add([h, next, pyramid.apex], joins.map(({ cells, m }) => ({ cell: cells[i], point: m }))));
  }
  return groups.values();
}

// TCP.

/** For each edge of a patch: its cells in the piece, the pyramids that have it at their apex, and those that have it in their polygon. */
function edgesOfPatch(patch) {
  const edges = new Map();
  const count = (corners, member) => {
    const [name] = nameOf([...corners].sort(byEntries));
    const edge = edges.get(name) ?? { corners, rows: 0, spokes: 0, rims: 0 };
    edge[member]++;
    edges.set(name, edge);
  };
  for (const row of patch.rows) for (const [i, j] of pairs(3)) count([row[i], row[j]], "rows");
  for (const { apex, polygon } of patch.pyramids) {
    polygon.forEach((corner) => count([apex, corner], "spokes"));
    sidesOf(polygon).forEach((edge) => count(edge, "rims"));
  }
  return edges;
}

function checkSystemValences(system, corners) {
  for (const patch of system.patches) patch.edges = edgesOfPatch(patch);
  const walls = valencesInWalls(system);
  for (const patch of system.patches) {
    for (const edge of patch.edges.values()) {
      const found = valencesOf(system, patch, edge, walls, corners);
      const wrong = found.find((valence) => valence !== 5 && valence !== 6);
      if (wrong !== undefined) refuse("edge-valence", `an edge of patch ${patch.i} can be in ${wrong} tetrahedra, not in 5 or 6`);
      edge.isSix = found.includes(6);
    }
  }
  checkTriangles(system);
}

/** For each edge of each wall the numbers of cells that the pieces of the first and of the second side can have there. */
function valencesInWalls({ sides, rank }) {
  const walls = new Map();
  const add = (name, member, rows) => {
    const wall = walls.get(name) ?? { first: new Set(), second: new Set() };
    wall[member].add(rows);
    walls.set(name, wall);
  };
  for (const side of sides) {
    for (const { corners, rows } of side.patch.edges.values()) {
      if (sidesWith(side.patch, corners).join() !== String(side.number)) continue;
      if (rank === 1 || side.number === 1) add(nameInWall(side, corners, false), "first", rows);
      if (rank === 1 || side.number === 0) add(nameInWall(side, corners, true), "second", rows);
    }
  }
  return walls;
}

const nameInWall = (side, corners, isTurned) => `${side.label} / ${outlineOf(side, corners, isTurned).text}`;

/** All valences that an edge can have. */
function valencesOf(system, patch, { corners, rows, spokes, rims }, walls, turns) {
  const [first, second] = sidesWith(patch, corners);
  if (first === undefined) return [rows + 2 * spokes];
  if (second !== undefined) return [cornerValence(patch, first, second, 2 * rows + rims, turns)];
  const side = system.sides.find((side) => side.patch === patch && side.number === first);
  const wall = walls.get(nameInWall(side, corners, false));
  return [...wall.first].flatMap((x) => [...wall.second].map((y) => x + y + rims));
}

/** Over a corner of a tile with the angle a / whole of a turn, half of the cells are 12 a / whole. Then all tiles together have six. */
function cornerValence({ corners, i }, first, second, halves, { angles, whole }) {
  const k = [first, second].find((side) => [first, second].includes((side - 1 + corners.length) % corners.length));
  const isShare = halves * whole === 12 * angles[i][k];
  if (!isShare) refuse("edge-valence", `over corner ${k} of tile ${i} there are ${halves} / 2 tetrahedra, not its share of 6`);
  return 6;
}

/** No triangle has two edges that can be in 6 tetrahedra. */
function checkTriangles(system) {
  const isSix = (patch, corners) => patch.edges.get(nameOf([...corners].sort(byEntries))[0]).isSix;
  for (const patch of system.patches) {
    const triangles = patch.rows.flatMap((row) => row.map((apex) => row.filter((corner) => corner !== apex)));
    for (const { apex, polygon } of patch.pyramids) triangles.push(...sidesOf(polygon).map((edge) => [apex, ...edge]));
    for (const [p, q, r] of triangles) {
      const sixes = [[p, q], [p, r], [q, r]].filter((edge) => isSix(patch, edge)).length;
      if (sixes > 1) refuse("triangle-valence", `a triangle of patch ${patch.i} can have two edges that are in 6`);
    }
  }
  for (const { side, other, mine, theirs } of system.joins) {
    const valence = mine.corners.length;
    if (valence !== 5 && valence !== 6) refuse("edge-valence", `the axis of a join is in ${valence} tetrahedra, not in 5 or 6`);
    mine.corners.forEach((corner, i) => {
      const beyond = theirs.corners[theirs.places.indexOf(mine.places[i])];
      const spokes = [isSix(side.patch, [mine.apex, corner]), isSix(other.patch, [theirs.apex, beyond]), valence === 6];
      if (spokes.filter(Boolean).length > 1) refuse("triangle-valence", "a triangle at the axis of a join can have two edges that are in 6");
    });
  }
}

function sentencesOfSystem({ rank, patches, rows, gram, root, statements }) {
  const base = ["", "edge-to-edge tiling of the plane by polygons", "tiling of the line by segments"][rank];
  const metric = `in a basis with inner products proportional to ${bracketed(gram.map((row) => bracketed(row.map((x) => shown(x)))))}`;
  const field = root ? `, where a is the root of ${shown(root.polynomial)} between ${ratio(root.low, root.unit)} and ${ratio(root.high, root.unit)}` : "";
  const tiles = patches.map(({ tiling }) => bracketed(tiling.polytope.vertices.map((point) => bracketed(point.map((x) => shown(x, tiling.denominator))))));
  const first = `over every ${base} with the vertices ${tiles.join(" or ")} whose sides have the stated classes, ${patches.length} patches with ${rows.length} tetrahedra and the joins between them tile three-space face to face, ${metric}${field}`;
  return [first, ...statements.slice(1).map(statementInWords)];
}

// ---- Words for the claim -------------------------------------------------------------------------------------------------------------

/** The claim: the tiling, and each further statement. */
function sentences(tiling) {
  const { dimension, rows, gram, root } = tiling;
  const simplices = ["triangle", "tetrahedron"][dimension - 2];
  const plural = ["triangles", "tetrahedra"][dimension - 2];
  const how = ["edge to edge", "face to face"][dimension - 2];
  const count = `${rows.length} ${rows.length === 1 ? simplices : plural}`;
  const metric = `in a basis with inner products proportional to ${bracketed(gram.map((row) => bracketed(row.map((x) => shown(x)))))}`;
  const field = root ? `, where a is the root of ${shown(root.polynomial)} between ${ratio(root.low, root.unit)} and ${ratio(root.high, root.unit)}` : "";
  const every = tiling.sides ? `for every ${tiling.sides.map((side) => sideInWords(side, side.name)).join(", ")}: ` : "";
  const first = `${every}${domainInWords(tiling)} is tiled ${how} by ${count}${latticeInWords(tiling)}, ${metric}${field}`;
  return [first, ...tiling.statements.slice(1).map(statementInWords)];
}

const bracketed = (items) => `[${items.join(", ")}]`;

function domainInWords({ dimension, kind, rank, polytope, boundary, denominator }) {
  const index = dimension - 2;
  if (kind === "space") return ["the plane", "three-space"][index];
  if (kind === "region") return `a region with ${boundary.length} boundary ${["edges", "triangles"][index]} up to translations`;
  const name = { slab: ["strip", "slab"], prism: ["", "prism"], solid: ["polygon", "polyhedron"] }[kind][index];
  const last = Array.from({ length: dimension - rank }, (_, i) => `x_${rank + 1 + i}`);
  const hull = polytope.vertices.map((point) => bracketed(point.map((x) => shown(x, denominator)))).join(", ");
  return `the ${name} of the points whose coordinates ${bracketed(last)} lie in the convex hull of ${hull}`;
}

function latticeInWords({ rank, dimension }) {
  if (rank === 0) return "";
  if (rank === dimension) return " and their translates under the lattice of the basis";
  return ` and their translates under the lattice of the first ${["vector", "two vectors"][rank - 1]} of the basis`;
}

function statementInWords({ kind, relation, sign: s, fraction, normal, offset }) {
  if (kind === PLANE) return `no simplex crosses ${planeInWords(normal, offset)} or a translate of it by the lattice`;
  if (!isBound(kind)) return PLAIN_WORDS[STATEMENTS[kind]];
  const number = shown(fraction[0], fraction[1]);
  const cosine = s === 0 ? "0" : `${s < 0 ? "-" : ""}√(${number})`;
  const bound = kind === RATIO ? number : `arccos(${cosine})`;
  const quantity = {
    [LARGEST]: "the largest dihedral angle",
    [SMALLEST]: "the smallest dihedral angle",
    [RATIO]: "the squared quotient of circumradius and shortest edge",
  }[kind];
  const name = RELATIONS[relation];
  const words = { maximum: "at most", minimum: "at least" }[name] ?? name;
  return `${quantity} of every simplex is ${words} ${bound}${words === name ? "" : ", and equal to it for some simplex"}`;
}

const PLAIN_WORDS = {
  acute: "all dihedral angles are acute",
  nonobtuse: "no dihedral angle is obtuse",
  Delaunay: "it is the Delaunay triangulation of its vertices",
  "weakly Delaunay": "it is a Delaunay triangulation of its vertices",
  "locally Delaunay": "beyond every facet with a mate, the mate's other corner is outside of the circumsphere",
  "locally weakly Delaunay": "beyond every facet with a mate, the mate's other corner is not inside of the circumsphere",
  "not Delaunay": "it is no Delaunay triangulation of its vertices: one of them is inside of the circumsphere of a simplex",
  TCP: "it is tetrahedrally close packed: every edge is in 5 or 6 tetrahedra, and no triangle has two edges that are in 6",
};

/** Whatever is not printable is escaped, so no text can forge a line. */
function oneLine(text) {
  const escaped = (character) => `\\u{${character.codePointAt(0).toString(16)}}`;
  return text.replace(/(?! )[\p{C}\p{Z}\p{Grapheme_Extend}]/gu, escaped);
}

/** The beginning of a text, in quotes. */
const quoted = (text) => `"${oneLine([...text.slice(0, 80)].join("").replace(/["\\]/g, "\\$&"))}"`;

export { verify, sha256, oneLine, DEFAULT_LIMITS };
