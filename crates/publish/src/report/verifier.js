// The verifier for browsers: re-checks a certificate from its bytes, in exact arithmetic.
//
// A second opinion on crates/format1/src/verifier (Rust). Both follow docs/format.md and answer with the same verdict and code; neither is a
// translation of the other. Here every predicate is made of the normals of a simplex's facets and of squared lengths (radius: the
// formulas of Heron and Crelle; Delaunay: barycentric coordinates of the corner behind), facets are compared by their sorted
// corners, reductions go through a table of the powers of a, and cosines through other series. The values whose signs are asked
// are the same elements of Z[a], so the same signs are decided.
//
// One module without imports, for a page, a worker or Node; nothing but the language, TextDecoder and TextEncoder is used. Only
// BigInt decides; a Number is an index, a count, a byte, or an entry of a shift below 2^33. No text of a certificate becomes the key of an object,
// and nothing recurses on what it reads. The report page embeds this file, so it never holds the end of a script element.

/** Inclusive upper bounds; the same as those of `acutile-verify`. */
const DEFAULT_LIMITS = Object.freeze({
  bytes: 33554432,
  simplices: 1000000,
  digits: 1000,
  degree: 32,
  bisections: 512,
  work: 30000000,
});

const SIGNS = 64n; // the work for all signs is this many times that for each product
const U64_MAX = 2n ** 64n - 1n;

/** The verdict of every code, in the order of docs/format.md. */
const CODES = new Map(
  `declined too-many-bytes; malformed json, format; declined version; malformed canonical, dimension, statements, tcp-domain,
  delaunay-domain, gram-shape, gram-asymmetric, prism-dimension, region-dimension, domain-vertex-length, face-count, face-length, face-vertices, face-repeated,
  unused-domain-vertex, no-simplices; declined too-many-simplices; malformed vertex-length, simplex-length, corner-length,
  vertex-range, shift-range, unused-vertex, mates-length, mate-row-length, mate-length, mate-range, mate-shift-range, number;
  declined too-many-digits; malformed polynomial; declined degree; malformed root-order; rejected root-signs;
  malformed root-derivative, coefficients, angle-range, ratio-range; declined common-denominator, work, sign-undecided;
  rejected gram-not-positive, face-not-facet, face-not-convex, faces-not-closed, vertex-outside, orientation, mate-not-mutual,
  mate-corners, mate-side, boundary-facet, volume-sum, boundary-meets, covering, not-acute, not-nonobtuse, angle-not-below, angle-not-above;
  declined angle-undecided; rejected ratio-not-below, not-delaunay, not-weakly-delaunay, edge-valence, triangle-valence;
  declined machine`
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

// ---- The entrance -------------------------------------------------------------------------------------------------------

/**
 * Checks everything that a certificate claims. The first check that fails gives the answer. Throws for nothing that `text` may hold.
 *
 * @param {string|Uint8Array} text the certificate; a string stands for its bytes in UTF-8
 * @param {object} [limits] some of the members of DEFAULT_LIMITS, integers from 0 to 2^53 - 1
 * @returns {{verdict: string, code: ?string, message: ?string, claim: string[], vertices: ?number, simplices: ?number,
 *   sha256: ?string}} verdict: verified, rejected, malformed or declined. Verified: claim, a sentence for
 *   the tiling and one for each further statement, the counts up to translations and the digest of the bytes. Else code and message.
 */
function verify(text, limits = {}) {
  const bounds = completed(limits);
  try {
    const bytes = bytesOf(text, bounds);
    return verified(checked(bytes, bounds), bytes);
  } catch (error) {
    return refused(error);
  }
}

function checked(bytes, limits) {
  const certificate = readCertificate(bytes);
  checkShape(certificate, limits);
  checkGeometry(readTiling(certificate, limits));
  return certificate;
}

function verified(certificate, bytes) {
  return {
    verdict: "verified",
    code: null,
    message: null,
    claim: sentences(certificate),
    vertices: certificate.witness.vertices.length,
    simplices: certificate.witness.simplices.length,
    sha256: sha256(bytes),
  };
}

/** A RangeError is the engine's: a number, an array or a stack that it cannot hold. Nothing is proved then. */
function refused(error) {
  const beyond = error instanceof RangeError;
  if (!beyond && !(error instanceof Refusal)) throw error;
  const code = beyond ? "machine" : error.code;
  const message = beyond ? `the JavaScript engine gives up: ${error.message}` : error.message;
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

function bytesOf(text, limits) {
  if (typeof text !== "string" && !(text instanceof Uint8Array)) throw new TypeError("verify: a string or a Uint8Array");
  checkSize(text.length, limits);
  if (typeof text !== "string") return text;
  if (/\p{Surrogate}/u.test(text)) refuse("json", "a surrogate stands alone, so the text has no bytes in UTF-8");
  const bytes = new TextEncoder().encode(text);
  checkSize(bytes.length, limits);
  return bytes;
}

function checkSize(found, limits) {
  if (found > limits.bytes) refuse("too-many-bytes", `at least ${found} bytes, more than the limit of ${limits.bytes}`);
}

// ---- SHA-256 (FIPS 180-4); crypto.subtle is missing on pages from files ----------------------------------------------------------

/** The fractional bits of the square (m = 2) and cube (m = 3) roots of the first primes, by integer roots. */
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

/** @returns {string} 64 hexadecimal digits */
function sha256(bytes) {
  const whole = bytes.length - (bytes.length % 64);
  const rest = new Uint8Array(bytes.length - whole < 56 ? 64 : 128);
  rest.set(bytes.subarray(whole));
  rest[bytes.length - whole] = 0x80;
  const bits = BigInt(bytes.length) * 8n;
  for (let i = 0; i < 8; i++) rest[rest.length - 1 - i] = Number((bits >> BigInt(8 * i)) & 255n);
  const state = Int32Array.from(FIRST_STATE);
  const schedule = new Int32Array(64);
  for (let at = 0; at < whole; at += 64) digestBlock(state, schedule, bytes, at);
  for (let at = 0; at < rest.length; at += 64) digestBlock(state, schedule, rest, at);
  return Array.from(state, (word) => (word >>> 0).toString(16).padStart(8, "0")).join("");
}

function digestBlock(state, w, bytes, at) {
  const turn = (x, n) => (x >>> n) | (x << (32 - n));
  for (let t = 0; t < 16; t++, at += 4) w[t] = (bytes[at] << 24) | (bytes[at + 1] << 16) | (bytes[at + 2] << 8) | bytes[at + 3];
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

// ---- JSON, read by the grammar and never into general objects -------------------------------------------------------------------------

const UTF8 = new TextDecoder("utf-8", { fatal: true, ignoreBOM: true });
const ascii = (character) => character.charCodeAt(0);
const [QUOTE, BACKSLASH, COMMA, COLON, MINUS, ZERO, NINE] = [...'"\\,:-09'].map(ascii);
const [ARRAY, ARRAY_END, OBJECT, OBJECT_END] = [..."[]{}"].map(ascii);
const ESCAPES = new Map([...'"\\/bfnrt'].map((character, i) => [ascii(character), '"\\/\b\f\n\r\t'[i]]));

class JsonReader {
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 0;
  }

  fail(what) {
    refuse("json", `${what} at byte ${this.at}`);
  }

  /** Skips space. The next byte, or -1. */
  next() {
    for (; this.at < this.bytes.length; this.at++) {
      const byte = this.bytes[this.at];
      if (byte !== 0x20 && byte !== 0x0a && byte !== 0x0d && byte !== 0x09) return byte;
    }
    return -1;
  }

  take(byte, what = `${JSON.stringify(String.fromCharCode(byte))} expected`) {
    if (this.next() !== byte) this.fail(what);
    this.at++;
  }

  end() {
    if (this.next() !== -1) this.fail("something follows the document");
  }

  word(letters) {
    this.next();
    for (const letter of letters) if (this.bytes[this.at++] !== ascii(letter)) this.fail("a value expected");
  }

  /** The items of an array or object one after the other, until its end; `read` is called for each. */
  items(open, close, read) {
    this.take(open);
    if (this.next() !== close) {
      read();
      while (this.next() !== close) {
        this.take(COMMA, "a comma or the end expected");
        read();
      }
    }
    this.at++;
  }

  list(read) {
    const list = [];
    this.items(ARRAY, ARRAY_END, () => list.push(read()));
    return list;
  }

  pair(read) {
    const list = this.list(read);
    if (list.length !== 2) this.fail("a pair expected, not the list that ends");
    return list;
  }

  /** A string with its escapes resolved: valid UTF-8, no control characters, no surrogate alone. */
  text() {
    this.take(QUOTE, "a string expected");
    let text = "";
    for (let from = this.at; ; from = this.at) {
      this.skipPlain();
      text += this.decoded(from, this.at);
      if (this.bytes[this.at++] === QUOTE) return text;
      text += this.escape();
    }
  }

  /** To the next quote or backslash. */
  skipPlain() {
    for (let byte; (byte = this.bytes[this.at]) !== QUOTE && byte !== BACKSLASH; this.at++) {
      if (byte === undefined) this.fail("the end of a string is missing");
      if (byte < 0x20) this.fail("a control character in a string");
    }
  }

  decoded(from, to) {
    const part = this.bytes.subarray(from, to);
    if (to - from < 24 && part.every((byte) => byte < 0x80)) return String.fromCharCode(...part);
    try {
      return UTF8.decode(part);
    } catch {
      return this.fail("no UTF-8 in the string that ends");
    }
  }

  /** What follows a backslash. */
  escape() {
    const plain = ESCAPES.get(this.bytes[this.at]);
    if (plain !== undefined) {
      this.at++;
      return plain;
    }
    const unit = this.unit();
    if (unit < 0xd800 || unit > 0xdfff) return String.fromCharCode(unit);
    if (unit > 0xdbff || this.bytes[this.at++] !== BACKSLASH) this.fail("a surrogate stands alone");
    const low = this.unit();
    if (low < 0xdc00 || low > 0xdfff) this.fail("a surrogate stands alone");
    return String.fromCharCode(unit, low);
  }

  /** `uXXXX` */
  unit() {
    const digits = String.fromCharCode(...this.bytes.subarray(this.at, this.at + 5));
    if (!/^u[0-9a-fA-F]{4}$/.test(digits)) this.fail("no escape of JSON");
    this.at += 5;
    return parseInt(digits.slice(1), 16);
  }

  /** The text of a number. */
  numeral() {
    this.next();
    const from = this.at;
    const digits = () => {
      const start = this.at;
      while (this.bytes[this.at] >= ZERO && this.bytes[this.at] <= NINE) this.at++;
      if (this.at === start) this.fail("a digit expected");
    };
    if (this.bytes[this.at] === MINUS) this.at++;
    if (this.bytes[this.at] === ZERO) this.at++;
    else digits();
    const whole = this.at;
    if (this.bytes[this.at] >= ZERO && this.bytes[this.at] <= NINE) this.fail("a leading zero");
    if (this.bytes[this.at] === ascii(".")) this.at++, digits();
    if ((this.bytes[this.at] | 0x20) === ascii("e")) {
      this.at++;
      if (this.bytes[this.at] === ascii("+") || this.bytes[this.at] === MINUS) this.at++;
      digits();
    }
    return { from, isInteger: whole === this.at };
  }

  /** An integer from `least` to `most`: a Number where that is exact, a BigInt elsewhere. Not -0, 1.0 or 1e0. */
  integer(least, most) {
    const { from, isInteger } = this.numeral();
    if (!isInteger || this.at - from > 20) this.fail("a smaller integer expected, not the number that ends");
    const text = String.fromCharCode(...this.bytes.subarray(from, this.at));
    const value = BigInt(text);
    if (text === "-0" || value < least || value > most) this.fail("an integer out of range, which ends");
    return Number.isSafeInteger(Number(value)) ? Number(value) : value;
  }

  /**
   * The members of an object, by name, in any order; or in an array, in this order. Each is there once.
   * Unknown ones are skipped if the record is `open`.
   */
  record(names, readers, open = false) {
    const values = new Array(names.length).fill(undefined);
    let count = 0;
    const read = (i) => {
      if (i >= names.length || values[i] !== undefined) this.fail("a member too many");
      values[i] = readers[i]();
      count++;
    };
    if (this.next() === ARRAY) this.items(ARRAY, ARRAY_END, () => read(count));
    else this.items(OBJECT, OBJECT_END, () => this.member(names, read, open));
    if (count !== names.length) this.fail("a member is missing in the object that ends");
    return values;
  }

  member(names, read, open) {
    const name = this.text();
    this.take(COLON);
    const i = names.indexOf(name);
    if (i >= 0) read(i);
    else if (open) this.skip();
    else this.fail("an unknown member");
  }

  /** One of some names alone, `"name"` or `{"name":null}`, or `{"name":value}` for those with a reader. */
  variant(names, readers) {
    const isAlone = this.next() !== OBJECT;
    if (!isAlone) this.at++;
    const kind = names.indexOf(this.text());
    if (kind < 0 || (isAlone && readers[kind])) this.fail("an unknown name");
    let value = null;
    if (!isAlone) {
      this.take(COLON);
      if (readers[kind]) value = readers[kind]();
      else this.word("null");
      this.take(OBJECT_END);
    }
    return { kind, value };
  }

  /** Any value; nested as deeply as it likes. */
  skip() {
    const open = new Stack();
    do {
      let isOpened = false;
      const byte = this.next();
      if (byte === ARRAY || byte === OBJECT) {
        open.push(byte);
        this.at++;
        isOpened = true;
      } else this.skipFlat(byte);
      this.skipEnds(open, isOpened);
    } while (open.size > 0);
  }

  /** After a value or an opening bracket: closes what ends here; else goes on to the next value. */
  skipEnds(open, isOpened) {
    for (let isFresh = isOpened; open.size > 0; isFresh = false) {
      const end = open.top() === ARRAY ? ARRAY_END : OBJECT_END;
      if (this.next() === end) {
        this.at++;
        open.size--;
        continue;
      }
      if (!isFresh) this.take(COMMA, "a comma or the end expected");
      if (end === OBJECT_END) {
        this.next();
        this.skipText();
        this.take(COLON);
      }
      return;
    }
  }

  skipFlat(byte) {
    if (byte === QUOTE) this.skipText();
    else if (byte === ascii("n")) this.word("null");
    else if (byte === ascii("t")) this.word("true");
    else if (byte === ascii("f")) this.word("false");
    else this.numeral();
  }

  /** A string whose characters nobody asks for. */
  skipText() {
    this.take(QUOTE, "a string expected");
    for (;;) {
      this.skipPlain();
      if (this.bytes[this.at++] === QUOTE) return;
      if (ESCAPES.has(this.bytes[this.at])) this.at++;
      else this.unit();
    }
  }
}

/** Bytes; as deep as a file is long, at a byte each. */
class Stack {
  constructor() {
    this.bytes = new Uint8Array(64);
    this.size = 0;
  }

  push(byte) {
    if (this.size === this.bytes.length) {
      const wider = new Uint8Array(2 * this.size);
      wider.set(this.bytes);
      this.bytes = wider;
    }
    this.bytes[this.size++] = byte;
  }

  top() {
    return this.bytes[this.size - 1];
  }
}

// ---- The certificate: from bytes to data, and back -----------------------------------------------------------------------------

const FORMAT = "acutile-certificate";
const STATEMENTS = [
  "face-to-face tiling",
  "acute",
  "nonobtuse",
  "all dihedral angles below",
  "all dihedral angles above",
  "all radius-edge ratios below",
  "Delaunay",
  "weakly Delaunay",
  "TCP",
];
const [TILING, ACUTE, NONOBTUSE, BELOW, ABOVE, RATIO, DELAUNAY, WEAKLY, TCP] = STATEMENTS.keys();
const DOMAINS = ["space", "slab", "prism", "solid", "region"];
const [SPACE, SLAB, PRISM, SOLID, REGION] = DOMAINS.keys();

/**
 * The data of a certificate. A number is a text, or a list of texts that does not hold just one. The field is null for Q. Statements
 * and domain have a `kind`, an index of the lists above, and a `value`.
 */
function readCertificate(bytes) {
  checkHeader(bytes);
  const json = new JsonReader(bytes);
  const text = () => json.text();
  const natural = () => json.integer(0n, U64_MAX);
  const entry = () => json.integer(-(2n ** 63n), 2n ** 63n - 1n);
  const number = () => (json.next() === ARRAY ? alone(json.list(text)) : json.text());
  const numbers = () => json.list(() => json.list(number));
  const entries = () => json.list(() => json.list(() => json.list(entry)));
  const polytope = () => named(["vertices", "faces"], [numbers, () => json.list(() => json.list(natural))]);
  const field = () => named(["polynomial", "root"], [() => json.list(text), () => json.pair(text)]);
  const named = (names, readers) => asObject(names, json.record(names, readers));
  const claim = () =>
    named(
      ["dimension", "field", "gram", "domain", "statements"],
      [
        natural,
        () => json.variant(["Q", "Q(a)"], [null, field]).value,
        numbers,
        () => json.variant(DOMAINS, [null, polytope, polytope, polytope, null]),
        () => json.list(() => json.variant(STATEMENTS, STATEMENTS.map((_, kind) => (isBound(kind) ? text : null)))),
      ],
    );
  const witness = () => named(["vertices", "simplices", "mates"], [numbers, entries, entries]);
  const certificate = named(["format", "version", "claim", "witness"], [text, natural, claim, witness]);
  json.end();
  checkCanonical(bytes, certificate);
  return certificate;
}

const isBound = (kind) => kind === BELOW || kind === ABOVE || kind === RATIO;
const alone = (list) => (list.length === 1 ? list[0] : list);

/** For names from this file only. */
function asObject(names, values) {
  return Object.fromEntries(names.map((name, i) => [name, values[i]]));
}

/** Format and version, before the rest, whose shape another version may change; but the whole file is JSON. */
function checkHeader(bytes) {
  const json = new JsonReader(bytes);
  const readers = [() => json.text(), () => json.integer(0n, U64_MAX)];
  const [format, version] = json.record(["format", "version"], readers, true);
  json.end();
  if (format !== FORMAT) refuse("format", `the format is ${quoted(excerpt(format))}, not "${FORMAT}"`);
  if (version !== 1) refuse("version", `version ${version} is unknown; this program knows 1`);
}

/** An object to be written: its members in order. */
class Members {
  constructor(...members) {
    this.members = members;
  }
}

function checkCanonical(bytes, { claim, witness }) {
  const { field, domain } = claim;
  const polytope = () => new Members(["vertices", domain.value.vertices], ["faces", domain.value.faces]);
  const theClaim = new Members(
    ["dimension", claim.dimension],
    ["field", field ? new Members(["Q(a)", new Members(["polynomial", field.polynomial], ["root", field.root])]) : "Q"],
    ["gram", claim.gram],
    ["domain", domain.value ? new Members([DOMAINS[domain.kind], polytope()]) : DOMAINS[domain.kind]],
    ["statements", claim.statements.map(({ kind, value }) => (value === null ? STATEMENTS[kind] : new Members([STATEMENTS[kind], value])))],
  );
  const theWitness = new Members(["vertices", witness.vertices], ["simplices", witness.simplices], ["mates", witness.mates]);
  const comparison = new Comparison(bytes);
  comparison.value(new Members(["format", FORMAT], ["version", 1], ["claim", theClaim], ["witness", theWitness]), 0);
  comparison.write("\n");
  if (comparison.at !== bytes.length) comparison.fail();
}

/** Writes the canonical bytes, and compares each with the one that is there. */
class Comparison {
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 0;
  }

  fail() {
    refuse("canonical", `not in canonical form: the first wrong byte is at offset ${this.at}`);
  }

  /** ASCII */
  write(text) {
    for (let i = 0; i < text.length; i++, this.at++) if (this.bytes[this.at] !== text.charCodeAt(i)) this.fail();
  }

  writeEncoded(text) {
    for (const byte of new TextEncoder().encode(text)) {
      if (this.bytes[this.at] !== byte) this.fail();
      this.at++;
    }
  }

  /** `depth` arrays and objects are open around the value; the outer three have their items on lines. */
  value(value, depth) {
    if (Array.isArray(value)) this.group("[", "]", value, depth, (item) => this.value(item, depth + 1));
    else if (value instanceof Members) this.group("{", "}", value.members, depth, (member) => this.member(member, depth + 1));
    else if (typeof value === "string") this.string(value);
    else this.write(String(value));
  }

  group(open, close, items, depth, write) {
    const line = depth < 3 ? "\n" : "";
    this.write(open);
    for (let i = 0; i < items.length; i++) {
      this.write(i > 0 ? "," + line : line);
      write(items[i]);
    }
    this.write(line + close);
  }

  member([name, value], depth) {
    this.string(name);
    this.write(":");
    this.value(value, depth);
  }

  /** Only quotes, backslashes and control characters are escaped, the short way where there is one. */
  string(text) {
    this.write('"');
    const escaped = text.replace(/["\\\u0000-\u001f]/g, escapedInJson);
    if (/^[\u0020-\u007f]*$/.test(escaped)) this.write(escaped);
    else this.writeEncoded(escaped);
    this.write('"');
  }
}

const SHORT_ESCAPES = new Map([...ESCAPES].map(([letter, character]) => [character, "\\" + String.fromCharCode(letter)]));

function escapedInJson(character) {
  return SHORT_ESCAPES.get(character) ?? "\\u" + character.charCodeAt(0).toString(16).padStart(4, "0");
}

// ---- Lengths, ranges, order --------------------------------------------------------------------------------------------------

const FAR = 2 ** 31;

/** r: the lattice is spanned by the first r vectors of the basis. */
function rankOf({ dimension, domain }) {
  return new Map([[SPACE, dimension], [SLAB, dimension - 1], [PRISM, 1], [SOLID, 0], [REGION, 0]]).get(domain.kind);
}

function checkShape({ claim, witness }, limits) {
  checkClaim(claim);
  if (claim.domain.value) checkPolytope(claim.domain.value, claim.dimension - rankOf(claim));
  checkWitness(claim, witness, limits);
}

function checkClaim({ dimension, gram, domain, statements }) {
  if (dimension !== 2 && dimension !== 3) refuse("dimension", `dimension ${dimension}; it must be 2 or 3`);
  if (statements[0]?.kind !== TILING) refuse("statements", `the first statement must be "${STATEMENTS[TILING]}"`);
  const late = statements.findIndex(({ kind }, i) => i > 0 && kind <= statements[i - 1].kind);
  if (late > 0) refuse("statements", `statement ${late} is out of order or repeats the one before it`);
  const isThreeSpace = dimension === 3 && domain.kind === SPACE;
  if (statements.at(-1).kind === TCP && !isThreeSpace) refuse("tcp-domain", '"TCP" is stated of all of three-space only');
  const isDelaunay = statements.some(({ kind }) => kind === DELAUNAY || kind === WEAKLY);
  if (isDelaunay && domain.kind === REGION) refuse("delaunay-domain", "Delaunay is not stated of a region, which need not be convex");
  const isSquare = gram.length === dimension && gram.every((row) => row.length === dimension);
  if (!isSquare) refuse("gram-shape", "the Gram matrix is not square of the dimension's size");
  gram.forEach((row, i) => row.slice(0, i).forEach((entry, j) => checkSameText(entry, gram[j][i], i, j)));
  if (domain.kind === PRISM && dimension !== 3) refuse("prism-dimension", "a prism has dimension 3");
  if (domain.kind === REGION && dimension !== 3) refuse("region-dimension", "a region has dimension 3");
}

function checkSameText(entry, opposite, i, j) {
  const [x, y] = [entry, opposite].map((number) => [number].flat());
  const isSame = x.length === y.length && x.every((text, k) => text === y[k]);
  if (!isSame) refuse("gram-asymmetric", `gram[${i}][${j}] is not the same text as gram[${j}][${i}]`);
}

/** Vertices, faces and their vertices in range, and all used; k is the dimension. */
function checkPolytope({ vertices, faces }, k) {
  vertices.forEach((vertex, w) => {
    if (vertex.length !== k) refuse("domain-vertex-length", `vertex ${w} of the domain has ${vertex.length} coordinates, not ${k}`);
  });
  if (faces.length <= k) refuse("face-count", `the domain has ${faces.length} faces, fewer than ${k + 1}`);
  faces.forEach(({ length }, f) => {
    const fits = k === 3 ? length >= 3 : length === k;
    if (!fits) refuse("face-length", `face ${f} of the domain has ${length} vertices`);
  });
  faces.forEach((face, f) => checkFaceVertices(face, f, vertices.length));
  checkFacesDistinct(faces);
  const used = new Set(faces.flat());
  const unused = vertices.findIndex((_, w) => !used.has(w));
  if (unused >= 0) refuse("unused-domain-vertex", `vertex ${unused} of the domain is in no face`);
}

function checkFaceVertices(face, f, count) {
  const seen = new Set();
  for (const w of face) {
    const fits = isIndex(w, count) && !seen.has(w);
    if (!fits) refuse("face-vertices", `vertex ${w} of face ${f} of the domain does not exist or is there twice`);
    seen.add(w);
  }
}

function checkFacesDistinct(faces) {
  const seen = new Set();
  faces.forEach((face, f) => {
    const sorted = [...face].sort((v, w) => v - w).join();
    if (seen.has(sorted)) refuse("face-repeated", `face ${f} of the domain is the same as another`);
    seen.add(sorted);
  });
}

const isIndex = (value, count) => typeof value === "number" && value >= 0 && value < count;

/** The first entry of a shift that is not between -2^31 and 2^31. */
const farEntry = (shift) => shift.find((entry) => typeof entry === "bigint" || entry <= -FAR || entry >= FAR);

function checkWitness(claim, { vertices, simplices, mates }, limits) {
  const [d, r] = [claim.dimension, rankOf(claim)];
  if (simplices.length === 0) refuse("no-simplices", "there are no simplices");
  const isMany = simplices.length > limits.simplices;
  if (isMany) refuse("too-many-simplices", `${simplices.length} simplices, more than the limit of ${limits.simplices}`);
  vertices.forEach(({ length }, v) => {
    if (length !== d) refuse("vertex-length", `vertex ${v} has ${length} coordinates, not ${d}`);
  });
  const used = new Uint8Array(vertices.length);
  simplices.forEach((corners, s) => {
    if (corners.length !== d + 1) refuse("simplex-length", `simplex ${s} has ${corners.length} corners, not ${d + 1}`);
    corners.forEach((corner, i) => checkCorner(corner, `corner ${i} of simplex ${s}`, r, vertices.length));
    corners.forEach(([v]) => (used[v] = 1));
  });
  if (used.indexOf(0) >= 0) refuse("unused-vertex", `vertex ${used.indexOf(0)} is no corner of any simplex`);
  if (mates.length !== simplices.length) refuse("mates-length", `${mates.length} rows of mates for ${simplices.length} simplices`);
  const sizes = { simplices: simplices.length, corners: d + 1, r, faces: claim.domain.value?.faces.length, isRegion: claim.domain.kind === REGION };
  mates.forEach((row, s) => {
    if (row.length !== d + 1) refuse("mate-row-length", `simplex ${s} has ${row.length} mates, not ${d + 1}`);
    row.forEach((mate, i) => checkMate(mate, facetName(s, i), sizes));
  });
}

function checkCorner(corner, name, r, vertices) {
  if (corner.length !== 1 + r) refuse("corner-length", `${name} has ${corner.length} entries, not ${1 + r}`);
  if (!isIndex(corner[0], vertices)) refuse("vertex-range", `${name} is at vertex ${corner[0]}; there are ${vertices} vertices`);
  const far = farEntry(corner.slice(1));
  if (far !== undefined) refuse("shift-range", `${name} is shifted by ${far}, not between -2^31 and 2^31`);
}

/** `faces` is undefined where the domain has no polytope. */
function checkMate(mate, name, { simplices, corners, r, faces, isRegion }) {
  if (mate.length === 0 && isRegion) return;
  const isFace = mate.length === 1 && faces !== undefined;
  if (!isFace && mate.length !== 2 + r) refuse("mate-length", `the mate of ${name} has ${mate.length} entries, not ${2 + r}`);
  const exists = isFace ? isIndex(mate[0], faces) : isIndex(mate[0], simplices) && isIndex(mate[1], corners);
  if (!exists) refuse("mate-range", `the mate of ${name}, ${bracketed(mate)}, does not exist`);
  const far = farEntry(mate.slice(2));
  if (far !== undefined) refuse("mate-shift-range", `the mate of ${name} is shifted by ${far}, not between -2^31 and 2^31`);
}

const facetName = (s, i) => `facet ${i} of simplex ${s}`;
const bracketed = (items) => `[${items.join(", ")}]`;

// ---- Rational numbers [p, q], q > 0, in lowest terms ----------------------------------------------------------------------------

const sign = (x) => (x > 0n ? 1 : x < 0n ? -1 : 0);
const size = (x) => (x < 0n ? -x : x);
const isInteger = (text) => /^(0|-?[1-9][0-9]*)$/.test(text);

function gcd(x, y) {
  for ([x, y] = [size(x), size(y)]; y > 0n; ) [x, y] = [y, x % y];
  return x;
}

/** `p` or `p/q`; the digits are counted before anything is done with them. */
function rational(text, place, limits) {
  const wrong = (reason) => refuse("number", `${place()}: ${quoted(excerpt(text))}: ${reason}`);
  const digits = text.replace(/[^0-9]+/g, "").length;
  if (digits > limits.digits) refuse("too-many-digits", `${place()}: ${digits} digits, more than the limit of ${limits.digits}`);
  const slash = text.indexOf("/");
  const parts = slash < 0 ? [text, "1"] : [text.slice(0, slash), text.slice(slash + 1)];
  if (!parts.every(isInteger)) wrong("not an integer in decimal notation");
  const [p, q] = parts.map(BigInt);
  if (q <= 0n) wrong("the denominator is not positive");
  if ((q === 1n) !== slash < 0) wrong("a denominator of 1 is not written");
  if (slash >= 0 && gcd(p, q) !== 1n) wrong("not in lowest terms");
  return [p, q];
}

/** The least b with |x| < 2^b. */
function bits(x) {
  const hex = size(x).toString(16);
  return x === 0n ? 0 : 4 * hex.length + 28 - Math.clz32(parseInt(hex[0], 16));
}

const WORD = 2n ** 63n;
const words = (x) => (-WORD < x && x < WORD ? 1 : Math.floor(bits(x) / 64) + 1);
const wordsOfAll = (integers) => integers.reduce((most, x) => Math.max(most, words(x)), 1);

// ---- The ring Z[a] ----------------------------------------------------------------------------------------------------------
//
// Elements are the coefficients of 1, a, a², …, fewer than the degree n or as many, the last one not zero; zero is empty. Over Q n is 1.
// Equal coefficients mean equal values; an enclosure that excludes zero shows a sign. Where neither holds nothing is said.

const ZERO_ELEMENT = [];
const ONE = [1n];

function trimmed(x) {
  while (x.length > 0 && x[x.length - 1] === 0n) x.pop();
  return x;
}

const integer = (value) => trimmed([value]);
const negated = (x) => x.map((c) => -c);
const scaled = (x, factor) => trimmed(x.map((c) => c * factor));

function sum(x, y) {
  const [long, short] = x.length < y.length ? [y, x] : [x, y];
  return trimmed(long.map((c, k) => (k < short.length ? c + short[k] : c)));
}

const difference = (x, y) => sum(x, negated(y));
const total = (elements) => elements.reduce(sum, ZERO_ELEMENT);

class Ring {
  /** @param {?bigint[]} modulus monic, of degree 2 or more; null over Q */
  constructor(modulus, ladder, budget) {
    Object.assign(this, { modulus, ladder, budget, degree: modulus ? modulus.length - 1 : 1 });
    this.powers = null;
  }

  times(x, y) {
    return this.dot([x], [y]);
  }

  /** x_1 y_1 + x_2 y_2 + … */
  dot(xs, ys) {
    const product = new Array(2 * this.degree - 1).fill(0n);
    xs.forEach((x, i) => convolve(product, x, ys[i]));
    return this.reduced(product);
  }

  /** a^(n+k) is row k of a table, made when it is first needed. */
  reduced(product) {
    const n = this.degree;
    const low = product.slice(0, n);
    for (let k = n; k < product.length; k++) {
      if (product[k] === 0n) continue;
      this.powers ??= powersFrom(this.modulus);
      this.powers[k - n].forEach((c, i) => (low[i] += product[k] * c));
    }
    return trimmed(low);
  }

  /** -1, 0 or 1; undefined where it is not decided. */
  sign(x) {
    if (x.length === 0) return 0;
    if (x.length === 1) return sign(x[0]);
    for (const enclosure of this.ladder) {
      const found = enclosure.sign(x, this.budget);
      if (found !== undefined) return found;
    }
    return undefined;
  }
}

function convolve(product, x, y) {
  for (let i = 0; i < x.length; i++) for (let j = 0; j < y.length; j++) product[i + j] += x[i] * y[j];
}

/** a^n, …, a^(2n-2) by coefficients: a^n = -(c_0 + … + c_(n-1) a^(n-1)), and a times a row is the row moved up, its top replaced. */
function powersFrom(modulus) {
  const n = modulus.length - 1;
  const first = modulus.slice(0, n).map((c) => -c);
  const rows = [first];
  for (let k = 1; k < n - 1; k++) {
    const last = rows[k - 1];
    rows.push(first.map((c, i) => c * last[n - 1] + (i > 0 ? last[i - 1] : 0n)));
  }
  return rows;
}

/** What something may cost altogether; counted before it is done. */
class Budget {
  constructor(work, of) {
    Object.assign(this, { spent: 0n, limit: BigInt(work) * SIGNS, of });
  }

  spend(cost) {
    this.spent += cost;
    if (this.spent > this.limit) refuse("work", `${this.spent} word products ${this.of}, more than the limit of ${this.limit}`);
  }
}

/** The root lies in [low, high] / unit, unit > 0. */
class Enclosure {
  constructor(low, high, unit) {
    Object.assign(this, { low, high, unit, words: BigInt(wordsOfAll([low, high, unit])) });
  }

  /** The strict sign of f(x) for all x of the interval, if Horner's rule in intervals shows it; times unit^m, m the degree of f. */
  sign(f, budget) {
    const count = BigInt(f.length);
    budget.spend(count * count * this.words * (BigInt(wordsOfAll(f)) + this.words));
    let [least, most] = [f.at(-1), f.at(-1)];
    let power = 1n;
    for (let k = f.length - 2; k >= 0; k--) {
      power *= this.unit;
      [least, most] = this.hull(least, most);
      least += f[k] * power;
      most += f[k] * power;
    }
    return least > 0n ? 1 : most < 0n ? -1 : undefined;
  }

  /** The least and the greatest product of a number from [least, most] and one from [low, high]. */
  hull(least, most) {
    const { low, high } = this;
    if (low >= 0n) return [least * (least < 0n ? high : low), most * (most < 0n ? low : high)];
    if (high <= 0n) return [most * (most < 0n ? high : low), least * (least < 0n ? low : high)];
    const [a, b, c, d] = [least * high, most * low, least * low, most * high];
    return [a < b ? a : b, c > d ? c : d];
  }

  /** The half with the root of p, which rises or falls through it; the middle alone if p is zero there. */
  halved(p, rise, budget) {
    const middle = this.low + this.high;
    const unit = 2n * this.unit;
    const half = new Enclosure(middle, middle, unit);
    const found = half.sign(p, budget);
    if (found === undefined) return half;
    return found === rise ? new Enclosure(2n * this.low, middle, unit) : new Enclosure(middle, 2n * this.high, unit);
  }
}

/** Checks that p has one root in the interval, and encloses it after 64, 128, 256, … halvings and after the last. */
function ladder(p, [[lowP, lowQ], [highP, highQ]], bisections, budget) {
  let enclosure = new Enclosure(lowP * highQ, highP * lowQ, lowQ * highQ);
  const { low, high, unit } = enclosure;
  if (low >= high) refuse("root-order", "the root's interval does not rise");
  const at = (end) => new Enclosure(end, end, unit).sign(p, budget);
  const ends = [at(low), at(high)];
  if (ends[0] === undefined || ends[1] !== -ends[0]) {
    refuse("root-signs", "the field's polynomial does not have opposite signs at the ends of the root's interval");
  }
  const slope = enclosure.sign(p.slice(1).map((c, k) => c * BigInt(k + 1)), budget);
  if (slope === undefined) {
    refuse("root-derivative", "the derivative of the field's polynomial is not shown to keep its sign on the root's interval");
  }
  const rise = at(high);
  const rungs = [];
  for (let step = 1; step <= bisections; step++) {
    enclosure = enclosure.halved(p, rise, budget);
    const isRung = step >= 64 && (step & (step - 1)) === 0;
    if (isRung || step === bisections) rungs.push(enclosure);
  }
  return rungs;
}

// ---- The numbers of a certificate in one ring -----------------------------------------------------------------------------------

/**
 * Coordinates are multiplied by one positive integer, `scale`, and the Gram matrix by another, `gramScale`; every condition is
 * homogeneous in both, so no sign changes.
 */
function readTiling(certificate, limits) {
  const { claim, witness } = certificate;
  const polytope = claim.domain.value;
  const ring = readField(claim.field, limits);
  const read = (tables) => readTables(tables, ring.degree, limits);
  const [[gram], gramScale] = read([["gram", claim.gram]]);
  const [[vertices, corners], scale] = read([["vertices", witness.vertices], ["domain", polytope ? polytope.vertices : []]]);
  const tiling = {
    ...{ certificate, ring, gram, gramScale, vertices, scale },
    ...{ dimension: claim.dimension, rank: rankOf(claim), simplices: witness.simplices, mates: witness.mates },
    polytope: polytope && { vertices: corners, faces: polytope.faces, k: claim.dimension - rankOf(claim) },
    bounds: readBounds(claim.statements, limits),
    work: limits.work,
  };
  checkWork(tiling, limits);
  return { ...tiling, determinantOfGram: determinant(ring, gram), dualGram: adjugate(ring, gram) };
}

function readField(field, limits) {
  if (!field) return new Ring(null, [], null);
  const p = readPolynomial(field.polynomial, limits);
  const root = field.root.map((text, i) => rational(text, () => `root[${i}]`, limits));
  const budget = new Budget(limits.work, "for the signs");
  return new Ring(p, ladder(p, root, limits.bisections, budget), budget);
}

function readPolynomial(texts, limits) {
  const wrong = (reason) => refuse("polynomial", `the field's polynomial: ${reason}`);
  const degree = texts.length - 1;
  if (degree < 2) wrong("its degree is less than two");
  if (degree > limits.degree) refuse("degree", `the field has degree ${degree}, more than the limit of ${limits.degree}`);
  if (texts[degree] !== "1") wrong("it is not monic");
  return texts.map((text, k) => {
    const [p, q] = rational(text, () => `polynomial[${k}]`, limits);
    return q === 1n ? p : wrong("a coefficient is not an integer");
  });
}

/** All rows of some tables, by the least positive integer that makes them integral; and that integer. */
function readTables(tables, degree, limits) {
  let common = 1n;
  const rationals = tables.map(([name, table]) =>
    table.map((line, i) =>
      line.map((number, j) => {
        const coefficients = readNumber(number, () => `${name}[${i}][${j}]`, degree, limits);
        for (const [, q] of coefficients) common = widened(common, q, name, limits);
        return coefficients;
      }),
    ),
  );
  const integral = (coefficients) => trimmed(coefficients.map(([p, q]) => p * (common / q)));
  return [rationals.map((table) => table.map((line) => line.map(integral))), common];
}

function readNumber(number, place, degree, limits) {
  const wrong = (reason) => refuse("coefficients", `${place()}: coefficients: ${reason}`);
  const texts = typeof number === "string" ? [number] : number;
  if (texts.length === 0) wrong("there is none");
  if (texts.length > degree) wrong("there are more than the degree of the field");
  const coefficients = texts.map((text) => rational(text, place, limits));
  if (texts.length > 1 && coefficients.at(-1)[0] === 0n) wrong("the last one is zero");
  return coefficients;
}

/** The least common multiple, while it has no more digits than allowed. */
function widened(common, q, name, limits) {
  if (common % q === 0n) return common;
  const wider = (common / gcd(common, q)) * q;
  const isLong = wider.toString().length > limits.digits;
  return isLong ? refuse("common-denominator", `${name}: the common denominator has more than ${limits.digits} digits`) : wider;
}

/** By kind of statement: its text, and its value. */
function readBounds(statements, limits) {
  const bounds = new Map();
  for (const { kind, value: text } of statements.filter(({ kind }) => isBound(kind))) {
    const value = rational(text, () => STATEMENTS[kind], limits);
    checkBound(kind, text, value);
    bounds.set(kind, { text, value });
  }
  return bounds;
}

function checkBound(kind, text, [p, q]) {
  if (kind === RATIO) {
    if (p <= 0n) refuse("ratio-range", `a ratio of ${text}; it must be positive`);
    return;
  }
  const fits = kind === BELOW ? p > 0n && p <= 180n * q : p >= 0n && p < 180n * q;
  if (!fits) refuse("angle-range", `an angle bound of ${text} degrees, out of the range from 0 to 180`);
}

/** (simplices + I W + F V) n² words²: see docs/format.md. */
function checkWork(tiling, limits) {
  const { vertices: corners, faces } = tiling.polytope ?? { vertices: [], faces: [] };
  const incidences = faces.reduce((count, face) => count + BigInt(face.length), 0n);
  const domain = incidences * BigInt(corners.length) + BigInt(faces.length) * BigInt(tiling.vertices.length);
  const exact = productCost(tiling) * (domain + BigInt(tiling.simplices.length));
  const found = exact > U64_MAX ? U64_MAX : exact;
  if (found > BigInt(limits.work)) refuse("work", `${found} word products for each product, more than the limit of ${limits.work}`);
}

/** n² words² */
function productCost({ ring, gram, vertices, scale, polytope, bounds }) {
  const n = BigInt(ring.degree);
  const numbers = [gram, vertices, polytope ? polytope.vertices : []].flatMap((table) => table.map((line) => line.reduce(wordsOfMore, 1)));
  const modulus = ring.degree * (ring.modulus ?? []).reduce((most, c) => Math.max(most, bits(c)), 0);
  const others = [wordsOfAll([scale, ...(bounds.get(RATIO)?.value ?? [])]), Math.floor(modulus / 64) + 1];
  const w = BigInt(numbers.concat(others).reduce((most, words) => Math.max(most, words)));
  return n * n * w * w;
}

const wordsOfMore = (most, x) => Math.max(most, wordsOfAll(x));

// ---- Vectors, covectors, values in words ----------------------------------------------------------------------------------------

const vectorBetween = (from, to) => to.map((x, k) => difference(x, from[k]));

/** The covector n with n · x = det(rows…, x), for k - 1 rows of k. */
function normal(ring, rows) {
  if (rows.length === 0) return [ONE];
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
const pairing = (ring, x, m, y) => ring.dot(x, m.map((line) => ring.dot(line, y)));

/** The sign of `value`, decided; `of` names it, and `scale` is the positive integer by which it is too large. */
function signOf(tiling, value, scale, of) {
  const found = tiling.ring.sign(value);
  if (found !== undefined) return found;
  return refuse("sign-undecided", `the sign of the ${of()}, ${shown(value, scale())}, is not decided by the bisections allowed`);
}

/** An element divided by a positive integer, as an expression in a. */
function shown(value, scale) {
  return polynomialInWords(value.map((c) => ratioText(c, scale)));
}

function ratioText(p, q) {
  const common = gcd(p, q);
  return q === common ? `${p / common}` : `${p / common}/${q / common}`;
}

function polynomialInWords(texts) {
  let words = "";
  texts.forEach((text, k) => {
    if (text === "0") return;
    const isMinus = text.startsWith("-");
    const size = isMinus ? text.slice(1) : text;
    const power = k === 1 ? "a" : `a^${k}`;
    words += words === "" ? (isMinus ? "-" : "") : isMinus ? " - " : " + ";
    words += k === 0 ? size : size === "1" ? power : `${size} ${power}`;
  });
  return words || "0";
}

/** A simplex's corner, or its translate, in coordinates that are N times too large. */
function pointOf(tiling, [v, ...shift], by) {
  const point = [...tiling.vertices[v]];
  shift.forEach((s, k) => {
    const steps = BigInt(by ? s + by[k] : s);
    if (steps !== 0n) point[k] = sum(point[k], integer(steps * tiling.scale));
  });
  return point;
}

/**
 * The points of a simplex and the normals of its facets: the i-th is det E times the gradient of the i-th barycentric coordinate. With y_0,
 * …, y_(D-1) the other points in their order, (-1)^(D-i) det(y_1 - y_0, …, y_(D-1) - y_0, x - y_0) is that coordinate times det E.
 */
function simplexOf(tiling, s) {
  const points = tiling.simplices[s].map((corner) => pointOf(tiling, corner));
  const normals = points.map((_, i) => {
    const [origin, ...others] = points.filter((_, j) => j !== i);
    const covector = normal(tiling.ring, others.map((point) => vectorBetween(origin, point)));
    return (points.length - 1 - i) % 2 === 0 ? covector : covector.map(negated);
  });
  return { points, normals };
}

/** det E times the i-th barycentric coordinate of x. */
function barycentric({ ring }, { points, normals }, i, x) {
  return ring.dot(normals[i], vectorBetween(points[i === 0 ? 1 : 0], x));
}

/** det E = det(x_1 - x_0, …, x_D - x_0), N^D times too large: the first barycentric coordinate is one at x_0. */
const determinantOf = (tiling, simplex) => barycentric(tiling, simplex, 0, simplex.points[0]);

/** The square of a vector's length, d N² times too large. */
const square = ({ ring, gram }, x) => pairing(ring, x, gram, x);

const factorial = (n) => (n < 2n ? 1n : n * factorial(n - 1n));
const power = (base, exponent) => base ** BigInt(exponent);

/** The pairs (i, j), i < j, of facets or corners: by j, then by i. */
const pairs = (dimension) => [...Array(dimension + 1).keys()].flatMap((j) => [...Array(j).keys()].map((i) => [i, j]));

// ---- The hypotheses of the theorem in docs/soundness.md, in the order of docs/format.md -----------------------------------------------

function checkGeometry(tiling) {
  checkGram(tiling);
  checkDomain(tiling);
  checkOrientation(tiling);
  checkMates(tiling);
  checkBoundary(tiling);
  checkVolume(tiling);
  checkRegion(tiling);
  checkAcute(tiling);
  checkNonobtuse(tiling);
  checkAngles(tiling, BELOW);
  checkAngles(tiling, ABOVE);
  checkRadius(tiling);
  checkPowers(tiling, DELAUNAY);
  checkPowers(tiling, WEAKLY);
  checkClosePacked(tiling);
}

const domainOf = (tiling) => tiling.certificate.claim.domain.kind;
const claims = (tiling, kind) => tiling.certificate.claim.statements.some((statement) => statement.kind === kind);

/** G is positive definite: its leading principal minors are positive. */
function checkGram(tiling) {
  for (let order = 1; order <= tiling.dimension; order++) {
    const minor = determinant(tiling.ring, tiling.gram.slice(0, order).map((line) => line.slice(0, order)));
    const scale = () => power(tiling.gramScale, order);
    if (signOf(tiling, minor, scale, () => `leading principal minor ${order} of the Gram matrix`) > 0) continue;
    refuse("gram-not-positive", `the Gram matrix is not positive definite: its leading principal minor ${order} is ${shown(minor, scale())}`);
  }
}

/** det E > 0 */
function checkOrientation(tiling) {
  const scale = () => power(tiling.scale, tiling.dimension);
  tiling.determinants = tiling.simplices.map((_, s) => {
    const value = determinantOf(tiling, simplexOf(tiling, s));
    if (signOf(tiling, value, scale, () => `determinant of simplex ${s}`) > 0) return value;
    return refuse("orientation", `simplex ${s} has the determinant ${shown(value, scale())}, not a positive one`);
  });
}

/** Σ det E = D! vol P, in units of the basis's parallelepiped; D! for space. A region has no volume but this sum. */
function checkVolume(tiling) {
  const { dimension, polytope, scale } = tiling;
  if (domainOf(tiling) === REGION) return;
  const [d, k] = [BigInt(dimension), BigInt(polytope ? polytope.k : 0)];
  const found = total(tiling.determinants);
  const volume = polytope ? volumeOf(tiling, polytope.planes.map((plane) => innerSide(tiling, plane))) : ONE;
  const expected = scaled(volume, (factorial(d) / factorial(k)) * scale ** (d - k));
  const cell = () => factorial(d) * scale ** d;
  const excess = difference(found, expected);
  if (signOf(tiling, excess, cell, () => "sum of the volumes, minus that of the domain") === 0) return;
  const [is, should] = [found, expected].map((value) => shown(value, cell()));
  const domain = should === "1" ? "" : `; the domain has ${should}`;
  refuse("volume-sum", `the volumes of the simplices sum to ${is} times the cell${domain}`);
}

// ---- The domain --------------------------------------------------------------------------------------------------------------
//
// h_f(x) = det(w_1 - w_0, …, w_(k-1) - w_0, x - w_0) = n · x - n · w_0 for a face f with the vertices w_0, w_1, …

function checkDomain(tiling) {
  const { ring, polytope } = tiling;
  if (!polytope) return;
  polytope.planes = polytope.faces.map((face, f) => {
    const [origin, ...others] = face.slice(0, polytope.k).map((w) => polytope.vertices[w]);
    const covector = normal(ring, others.map((point) => vectorBetween(origin, point)));
    return { f, face, members: new Set(face), covector, level: ring.dot(covector, origin) };
  });
  polytope.planes.forEach((plane) => checkFacet(tiling, plane));
  if (polytope.k === 3) polytope.planes.forEach((plane) => checkPolygon(tiling, plane));
  checkClosed(polytope);
  polytope.planes.forEach((plane) => checkInside(tiling, plane));
}

/** h_f of a point of the polytope or of the tiling, N^k times too large. */
function height({ ring, polytope }, plane, point) {
  return difference(ring.dot(plane.covector, point.slice(-polytope.k)), plane.level);
}

function sideOfPoint(tiling, plane, point) {
  const of = () => `side of a point with respect to face ${plane.f}`;
  return signOf(tiling, height(tiling, plane, point), () => power(tiling.scale, tiling.polytope.k), of);
}

const heightShown = (tiling, plane, point) => shown(height(tiling, plane, point), power(tiling.scale, tiling.polytope.k));

/** s_f: the sign of h_f at the first vertex that is not one of f; zero where there is none. */
function innerSide(tiling, plane) {
  const { vertices } = tiling.polytope;
  const other = vertices.findIndex((_, w) => !plane.members.has(w));
  return other < 0 ? 0 : sideOfPoint(tiling, plane, vertices[other]);
}

/** h_f is zero at the vertices of f and has one strict sign at the others, of which there is one. */
function checkFacet(tiling, plane) {
  const inner = innerSide(tiling, plane);
  tiling.polytope.vertices.forEach((point, w) => {
    const expected = plane.members.has(w) ? 0 : inner;
    if (inner !== 0 && sideOfPoint(tiling, plane, point) === expected) return;
    const value = heightShown(tiling, plane, point);
    refuse("face-not-facet", `face ${plane.f} is no facet of the domain: vertex ${w} of the domain has the determinant ${value}`);
  });
}

/** The vertices that follow one another, cyclically. */
const sidesOf = (face) => face.map((p, i) => [p, face[(i + 1) % face.length]]);

/** For sides p q and every other vertex t, the cross product of q - p and t - p is a positive multiple of the normal. */
function checkPolygon(tiling, { f, face, covector }) {
  const { ring, polytope } = tiling;
  for (const [p, q] of sidesOf(face)) {
    const [side, ...diagonals] = [q, ...face.filter((t) => t !== p && t !== q)].map((t) => [
      t,
      vectorBetween(polytope.vertices[p], polytope.vertices[t]),
    ]);
    for (const [t, diagonal] of diagonals) {
      const turn = ring.dot(normal(ring, [side[1], diagonal]), covector);
      if (signOf(tiling, turn, () => tiling.scale ** 4n, () => `turn at vertex ${q} of face ${f}`) > 0) continue;
      const line = `vertex ${t} is not on the inner side of the line through ${p} and ${q}`;
      refuse("face-not-convex", `face ${f} of the domain is no convex polygon: ${line}`);
    }
  }
}

/** Every ridge (k = 1: the empty set, 2: a vertex, 3: a side) is in two faces. */
function checkClosed({ faces, k }) {
  const ridgesOf = [(_) => [[]], (face) => face.map((w) => [w]), sidesOf][k - 1];
  const counts = new Map();
  for (const ridge of faces.flatMap(ridgesOf).map((ridge) => ridge.sort((p, q) => p - q))) {
    const entry = counts.get(ridge.join()) ?? { ridge, count: 0 };
    counts.set(ridge.join(), { ridge, count: entry.count + 1 });
  }
  const open = [...counts.values()].filter(({ count }) => count !== 2).sort((x, y) => byEntries(x.ridge, y.ridge));
  if (open.length === 0) return;
  const [{ ridge, count }] = open;
  refuse("faces-not-closed", `the ridge of the domain with the vertices ${bracketed(ridge)} is in ${count} faces, not in 2`);
}

/** Lists of the same length by their first different entries. */
function byEntries(x, y) {
  const k = x.findIndex((entry, i) => entry !== y[i]);
  return k < 0 ? 0 : x[k] - y[k];
}

/** s_f h_f >= 0 at every vertex of the tiling. */
function checkInside(tiling, plane) {
  const inner = innerSide(tiling, plane);
  tiling.vertices.forEach((point, v) => {
    const side = sideOfPoint(tiling, plane, point);
    if (side === 0 || side === inner) return;
    const value = heightShown(tiling, plane, point);
    refuse("vertex-outside", `vertex ${v} is outside of face ${plane.f} of the domain: the determinant is ${value}`);
  });
}

/** A facet whose mate is `[f]` lies in the plane of face f. */
function checkBoundary(tiling) {
  tiling.mates.forEach((row, s) =>
    row.forEach((mate, i) => {
      if (mate.length !== 1) return;
      const plane = tiling.polytope.planes[mate[0]];
      for (const [v] of facetOf(tiling, s, i)) {
        const point = tiling.vertices[v];
        if (sideOfPoint(tiling, plane, point) === 0) continue;
        const where = `${facetName(s, i)} does not lie in face ${plane.f} of the domain`;
        refuse("boundary-facet", `${where}: a corner has the determinant ${heightShown(tiling, plane, point)}, not 0`);
      }
    }),
  );
}

/**
 * k! vol P, N^k times too large: the pyramids from the origin over the faces, counted by s_f. The sum over closed faces of
 * s_f det(w_i - w_0, …, o - w_0) does not depend on o; at the origin it is that of -s_f det(w_i, …, w_0).
 */
function volumeOf({ ring, polytope }, sides) {
  const at = (w) => polytope.vertices[w];
  const pyramids = ({ face: [apex, ...others] }) => {
    if (polytope.k === 1) return at(apex)[0];
    const bases = polytope.k === 2 ? [others] : others.slice(1).map((w, i) => [others[i], w]);
    return total(bases.map((base) => determinant(ring, [...base, apex].map(at))));
  };
  return total(polytope.planes.map((plane, f) => (sides[f] < 0 ? pyramids(plane) : negated(pyramids(plane)))));
}

// ---- Mates: by names of corners alone --------------------------------------------------------------------------------------------

const facetOf = (tiling, s, i) => tiling.simplices[s].filter((_, j) => j !== i);
const moved = ([v, ...shift], by) => [v, ...shift.map((entry, k) => entry + by[k])];

function checkMates(tiling) {
  const eachMate = (check) =>
    tiling.mates.forEach((row, s) => row.forEach((mate, i) => mate.length > 1 && check(s, i, mate[0], mate[1], mate.slice(2), mate)));
  eachMate((s, i, t, j, shift) => {
    const back = tiling.mates[t][j];
    const isBack = back.length === 2 + tiling.rank && back[0] === s && back[1] === i && shift.every((entry, k) => back[2 + k] === -entry);
    if (!isBack) refuse("mate-not-mutual", `the mate of ${facetName(s, i)} has ${bracketed(back)} for its mate`);
  });
  eachMate((s, i, t, j, shift, mate) => {
    const [mine, theirs] = [sortedFacet(tiling, s, i), sortedFacet(tiling, t, j)];
    const isSame = mine.corners.every((corner, k) => byEntries(corner, moved(theirs.corners[k], shift)) === 0);
    const both = `${facetName(s, i)} and its mate ${bracketed(mate)} have`;
    if (!isSame) refuse("mate-corners", `${both} different corners, for one ${bracketed(missing(tiling, s, i, t, j, shift))}`);
    if (mine.side === theirs.side) refuse("mate-side", `${both} their simplices on the same side`);
  });
}

/** The corners by vertex and then by shift, an order that translations keep; and (-1)^i times the sign of the sorting permutation. */
function sortedFacet(tiling, s, i) {
  const corners = facetOf(tiling, s, i);
  const inversions = pairs(corners.length - 1).filter(([k, l]) => byEntries(corners[k], corners[l]) > 0).length;
  return { corners: corners.sort(byEntries), side: (i + inversions) % 2 };
}

/** The first corner behind that is none of the facet's; there is one, for simplices that are not flat have different corners. */
function missing(tiling, s, i, t, j, shift) {
  const mine = facetOf(tiling, s, i);
  const isThere = (corner) => mine.some((own) => byEntries(own, moved(corner, shift)) === 0);
  return facetOf(tiling, t, j).find((corner) => !isThere(corner));
}

// ---- The region of a mesh ------------------------------------------------------------------------------------------------------
//
// Its boundary does not meet itself, and nothing is outside of it. The verifier in Rust separates triangles by functionals and sends rays
// along (1, ε, ε²); here edges are cut with triangles, and the rays go along (1, ε², ε). The covering number that a ray finds is that at its
// beginning, whatever its direction.

function checkRegion(tiling) {
  if (domainOf(tiling) !== REGION) return;
  const triangles = boundaryOf(tiling);
  const extents = extentsOf(tiling, triangles);
  checkBoundaryApart(tiling, triangles, extents);
  checkCovering(tiling, triangles, extents);
}

/** The facets with the mate `[]`: their vertices turn so that the normal (b - a) × (c - a) points out, as det E > 0. */
function boundaryOf(tiling) {
  return tiling.mates.flatMap((row, s) =>
    row.flatMap((mate, i) => {
      if (mate.length > 0) return [];
      const [a, b, c] = facetOf(tiling, s, i).map(([v]) => v);
      const corners = i % 2 === 0 ? [a, b, c] : [a, c, b];
      return [{ s, i, corners, normal: normalOf(tiling, corners) }];
    }),
  );
}

const between = ({ vertices }, v, w) => vectorBetween(vertices[v], vertices[w]);
const normalOf = (tiling, [a, b, c]) => normal(tiling.ring, [between(tiling, a, b), between(tiling, a, c)]);
const signInBoundary = (tiling, value, of = "position of two facets in the boundary, scaled") => signOf(tiling, value, () => 1n, () => of);

/** x_i, x_j + x_k and x_j - x_k. */
const FUNCTIONALS = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 1, 1], [1, 0, 1], [1, 1, 0], [0, 1, -1], [1, 0, -1], [1, -1, 0]];

/**
 * Of each triangle the least and the greatest rank of its corners along each functional, where equal values have equal ranks.
 * Triangles of which one ends before the other begins have a plane between them.
 */
function extentsOf(tiling, triangles) {
  const used = [...new Set(triangles.flatMap(({ corners }) => corners))].sort((v, w) => v - w);
  const ranks = FUNCTIONALS.map((functional) => {
    const values = new Map(used.map((v) => [v, total(tiling.vertices[v].map((x, k) => scaled(x, BigInt(functional[k]))))]));
    const of = () => "difference of two vertices along a functional";
    const compare = (v, w) => signOf(tiling, difference(values.get(v), values.get(w)), () => tiling.scale, of);
    const rank = new Map();
    [...used].sort(compare).forEach((v, at, order) => rank.set(v, at === 0 ? 0 : rank.get(order[at - 1]) - Math.min(0, compare(order[at - 1], v))));
    return rank;
  });
  return triangles.map(({ corners }) =>
    ranks.map((rank) => {
      const own = corners.map((v) => rank.get(v));
      return { begin: Math.min(...own), end: Math.max(...own) };
    }),
  );
}

const pairCost = (tiling) => 64n * productCost(tiling);
const overlap = (p, q) => p.begin <= q.end && q.begin <= p.end;

/** Any two triangles meet in the convex hull of the corners that they share, and these are not three. */
function checkBoundaryApart(tiling, triangles, extents) {
  const budget = new Budget(tiling.work, "for the facets in the boundary");
  const cost = pairCost(tiling);
  eachClosePair(extents, budget.limit, (t, u) => {
    budget.spend(cost);
    const [f, g] = [triangles[t], triangles[u]];
    const shared = f.corners.filter((v) => g.corners.includes(v));
    if (meetInShared(tiling, f, g, shared)) return;
    const [first, second] = [f, g].sort((x, y) => x.s - y.s || x.i - y.i).map(({ s, i }) => facetName(s, i));
    const count = ["no corner", "one corner"][shared.length] ?? `${shared.length} corners`;
    refuse("boundary-meets", `${first} and ${second} in the boundary have ${count} in common and meet elsewhere`);
  });
}

/** Calls `visit` for the pairs that overlap along all functionals, in the order of the one along which the fewest do. */
function eachClosePair(extents, limit, visit) {
  const counts = FUNCTIONALS.map((_, f) => overlapsAlong(extents.map((extent) => extent[f])));
  const best = counts.indexOf(counts.reduce((least, count) => Math.min(least, count)));
  const isMuch = BigInt(counts[best]) > limit;
  if (isMuch) refuse("work", `${counts[best]} word products for the pairs of facets in the boundary, more than the limit of ${limit}`);
  let open = [];
  const order = [...extents.keys()].sort((t, u) => extents[t][best].begin - extents[u][best].begin);
  for (const t of order) {
    open = open.filter((u) => extents[u][best].end >= extents[t][best].begin);
    open.filter((u) => extents[u].every((extent, f) => overlap(extent, extents[t][f]))).forEach((u) => visit(u, t));
    open.push(t);
  }
}

/** How many pairs of intervals overlap: with each that begins, those that have begun and not ended. */
function overlapsAlong(intervals) {
  const begins = intervals.map(({ begin }) => begin).sort((x, y) => x - y);
  const ends = intervals.map(({ end }) => end).sort((x, y) => x - y);
  let [count, ended] = [0, 0];
  begins.forEach((begin, at) => {
    while (ends[ended] < begin) ended++;
    count += at - ended;
  });
  return count;
}

/**
 * None shared: an end of what two triangles have in common lies on an edge of one of them; so no edge of either may meet the other. One: only the
 * edges opposite to it need be looked at, for beyond another common point the ray from the corner leaves one triangle there, inside of the other.
 * Two: the triangles are in different planes, or on different sides of their edge.
 */
function meetInShared(tiling, f, g, shared) {
  if (shared.length === 3) return false;
  if (shared.length === 2) return isUnfolded(tiling, f, g, shared);
  const edges = ({ corners }) => sidesOf(corners).filter((edge) => !edge.includes(shared[0]));
  return !edges(f).some((edge) => cuts(tiling, edge, g)) && !edges(g).some((edge) => cuts(tiling, edge, f));
}

function isUnfolded(tiling, f, g, [b, c]) {
  const [p, q] = [f, g].map(({ corners }) => corners.find((v) => v !== b && v !== c));
  const [n, m] = [p, q].map((v) => normalOf(tiling, [b, c, v]));
  const isOnePlane = signInBoundary(tiling, tiling.ring.dot(n, between(tiling, b, q))) === 0;
  return !isOnePlane || signInBoundary(tiling, tiling.ring.dot(n, m)) < 0;
}

/** Whether a segment, with its ends, meets a triangle, with its boundary. */
function cuts(tiling, [p, q], { corners, normal: n }) {
  const { ring } = tiling;
  const sides = [p, q].map((v) => signInBoundary(tiling, ring.dot(n, between(tiling, corners[0], v))));
  if (sides[0] === sides[1]) return sides[0] === 0 && cutsInPlane(tiling, [p, q], corners, n);
  // The line meets the plane in one point, of the segment; it is in the triangle if the line does not pass two sides in different senses.
  const along = between(tiling, p, q);
  const senses = sidesOf(corners).map(([v, w]) => {
    const across = normal(ring, [between(tiling, p, v), between(tiling, p, w)]);
    return signInBoundary(tiling, ring.dot(along, across));
  });
  return !(senses.includes(1) && senses.includes(-1));
}

/** In the plane with the normal n, a line separates them: strictly the triangle from a side's line, or from the segment's. */
function cutsInPlane(tiling, [p, q], corners, n) {
  const turn = (u, v, w) => signInBoundary(tiling, tiling.ring.dot(normalOf(tiling, [u, v, w]), n));
  const isBeyond = ([v, w]) => turn(v, w, p) < 0 && turn(v, w, q) < 0;
  if (sidesOf(corners).some(isBeyond)) return false;
  const [first, ...others] = corners.map((v) => turn(p, q, v));
  return first === 0 || others.some((side) => side !== first);
}

/** N = 0 directly outside of the first triangle of each class, where two are joined at an edge that no third one has. */
function checkCovering(tiling, triangles, extents) {
  const budget = new Budget(tiling.work, "for the facets in the boundary");
  const cost = pairCost(tiling);
  const passing = (start) => (count, triangle) => {
    budget.spend(cost);
    return count + crossing(tiling, start, triangle);
  };
  for (const first of firstOfClasses(triangles)) {
    budget.spend(BigInt(triangles.length));
    const start = triangles[first];
    const isBehind = raySign(tiling, start.normal) < 0;
    const ahead = triangles.filter((_, t) => mayBeAhead(extents[first], extents[t]));
    const outside = ahead.reduce(passing(start), isBehind ? -1 : 0);
    if (outside === 0) continue;
    const where = `directly outside of ${facetName(start.s, start.i)} in the boundary`;
    refuse("covering", `${where} the covering number is ${outside}, not 0`);
  }
}

/** Not where all of the other triangle is behind the first, or beside it. */
const mayBeAhead = (first, other) => other[0].end >= first[0].begin && overlap(other[1], first[1]) && overlap(other[2], first[2]);

/** Classes as trees of parents; the root is the first of its class. */
function firstOfClasses(triangles) {
  const parents = [...triangles.keys()];
  const root = (t) => {
    while (parents[t] !== t) [parents[t], t] = [parents[parents[t]], parents[t]];
    return t;
  };
  const around = new Map();
  triangles.forEach(({ corners }, t) =>
    sidesOf(corners).forEach(([v, w]) => {
      const edge = v < w ? `${v},${w}` : `${w},${v}`;
      if (!around.has(edge)) around.set(edge, []);
      around.get(edge).push(t);
    }),
  );
  for (const [t, u, ...others] of around.values()) {
    if (u === undefined || others.length > 0) continue;
    const [x, y] = [root(t), root(u)];
    parents[Math.max(x, y)] = Math.min(x, y);
  }
  return parents.filter((parent, t) => parent === t);
}

/**
 * How the ray from the centroid m of `start` along d = (1, ε², ε) passes a triangle: 1 if it leaves the region there, -1 if it enters, 0 if it
 * misses it. With A = a - m, …: it meets the triangle where d · (A × B), d · (B × C), d · (C × A) have the sign of det(A, B, C), not zero; and
 * that is the sign of d · n. All is 3 N times too large.
 */
function crossing(tiling, start, { corners, normal: n }) {
  const { ring, vertices } = tiling;
  const centre = [0, 1, 2].map((k) => total(start.corners.map((v) => vertices[v][k])));
  const away = corners.map((v) => vectorBetween(centre, vertices[v].map((x) => scaled(x, 3n))));
  const side = signInBoundary(tiling, ring.dot(n, away[0]), "side of a centroid with respect to a facet in the boundary");
  const isMet = side !== 0 && sidesOf(away).every((pair) => raySign(tiling, normal(ring, pair)) === side);
  return isMet ? side : 0;
}

/** The sign of d · w for d = (1, ε², ε) and all small ε > 0. */
function raySign(tiling, [x, y, z]) {
  for (const entry of [x, z, y]) {
    const found = signInBoundary(tiling, entry, "direction of a facet in the boundary, scaled");
    if (found !== 0) return found;
  }
  return 0;
}

// ---- Angles ------------------------------------------------------------------------------------------------------------------

/** Calls `check` with two facets of every simplex and the products of all its normals, det M g_i · g_j = n_i · adj(G) n_j. */
function eachAngle(tiling, check) {
  tiling.simplices.forEach((_, s) => {
    const { normals } = simplexOf(tiling, s);
    const product = (i, j) => pairing(tiling.ring, normals[i], tiling.dualGram, normals[j]);
    pairs(tiling.dimension).forEach(([i, j]) => check(s, i, j, product));
  });
}

const angleName = (s, i, j) => `the angle of facets ${i} and ${j} of simplex ${s}`;

/** cos θ = -g_i · g_j / (|g_i| |g_j|), which has the sign of -n_i · adj(G) n_j. */
function eachProduct(tiling, judge) {
  const scale = () => power(tiling.gramScale, tiling.dimension - 1) * power(tiling.scale, 2 * tiling.dimension - 2);
  eachAngle(tiling, (s, i, j, product) => {
    const value = product(i, j);
    const found = signOf(tiling, value, scale, () => `product of the normals of facets ${i} and ${j} of simplex ${s}`);
    judge(found, angleName(s, i, j), () => shown(value, scale()));
  });
}

function checkAcute(tiling) {
  if (!claims(tiling, ACUTE)) return;
  eachProduct(tiling, (found, name, value) => {
    if (found < 0) return;
    refuse("not-acute", `${name} is not acute: their scaled normals have the product ${value()}, not a negative one`);
  });
}

function checkNonobtuse(tiling) {
  if (!claims(tiling, NONOBTUSE)) return;
  eachProduct(tiling, (found, name, value) => {
    if (found <= 0) return;
    refuse("not-nonobtuse", `${name} is obtuse: their scaled normals have the positive product ${value()}`);
  });
}

/**
 * θ < Q where cos θ > cos Q, for BELOW; θ > Q where cos θ < cos Q, for ABOVE. With cos Q from low to high, it is proved at the far end and
 * disproved at the near one.
 */
function checkAngles(tiling, kind) {
  if (!tiling.bounds.has(kind)) return;
  const { text, value } = tiling.bounds.get(kind);
  const [low, high, unit] = cosine(value);
  const [wanted, far, near, refusal] = kind === BELOW ? [1, high, low, "angle-not-below"] : [-1, low, high, "angle-not-above"];
  eachAngle(tiling, (s, i, j, product) => {
    const of = () => `cosine of facets ${i} and ${j} of simplex ${s}, compared`;
    const [x, y] = [negated(product(i, j)), tiling.ring.times(product(i, i), product(j, j))];
    if (compareWithRoot(tiling, x, y, far, unit, of) === wanted) return;
    const isOpen = compareWithRoot(tiling, x, y, near, unit, of) === wanted;
    if (isOpen) refuse("angle-undecided", `${angleName(s, i, j)} is too near to ${text} degrees to be decided`);
    refuse(refusal, `${angleName(s, i, j)} is not ${STATEMENTS[kind].split(" ").at(-1)} ${text} degrees`);
  });
}

/** The sign of x - (p/q) sqrt(y) for y, q > 0: of different signs the terms decide; else it is that of ±(q² x² - p² y). */
function compareWithRoot(tiling, x, y, p, q, of) {
  const one = () => 1n;
  const [left, right] = [signOf(tiling, x, one, of), sign(p)];
  if (left !== right || left === 0) return Math.sign(left - right);
  const squares = difference(scaled(tiling.ring.times(x, x), q * q), scaled(y, p * p));
  return left * signOf(tiling, squares, one, of);
}

const BITS = 192n;
const UNIT = 1n << BITS;
const GUARD = 64n;

/**
 * [low, high, unit]: cos Q° lies in [low, high] / unit, for Q from 0 to 180; exact where it is rational (Niven), else of width 2 / 2^128.
 * In units of 2^-192 the errors are less than 2^13 for π, hence 2^13 + 1 for the angle, 1 for its square, and 200 for the series.
 */
function cosine([p, q]) {
  const exact = [[0n, 2n], [60n, 1n], [90n, 0n], [120n, -1n], [180n, -2n]].find(([degrees]) => degrees * q === p);
  if (exact) return [exact[1], exact[1], 2n];
  const angle = (p * PI) / (q * 180n);
  const value = cosineSeries((angle * angle) >> BITS);
  const error = 1n << 20n;
  return [(value - error) >> GUARD, ((value + error) >> GUARD) + 1n, 1n << (BITS - GUARD)];
}

/**
 * cos sqrt(x) = 1 - x/2! + x²/4! - … for 0 <= x < 10. A term's error is at most that of the one before, times x / ((2k-1) 2k), plus one for
 * rounding down: less than 2 everywhere. There are fewer than 64 terms; what is left out after a term of zero is less than 4.
 */
function cosineSeries(x) {
  let value = 0n;
  for (let [term, k] = [UNIT, 1n]; term !== 0n; k++) {
    value += term;
    term = -((term * x) / ((2n * k - 1n) * 2n * k)) / UNIT;
  }
  return value;
}

/** π = 48 arctan(1/18) + 32 arctan(1/57) - 20 arctan(1/239) (Gauss); each arctangent's error is less than 50 units. */
const PI = 48n * arctangentOfInverse(18n) + 32n * arctangentOfInverse(57n) - 20n * arctangentOfInverse(239n);

/** arctan(1/n) = 1/n - 1/(3 n³) + …: at most 24 terms that are not zero, each with an error less than 2, and the rest less than 1. */
function arctangentOfInverse(n) {
  let value = 0n;
  for (let [k, power] = [1n, UNIT / n]; power !== 0n; k += 2n, power = -power / (n * n)) value += power / k;
  return value;
}

// ---- Radius and Delaunay -----------------------------------------------------------------------------------------------------------

/** R² < (p/q)² l² for all edges: q² (4 det M R²) - 4 p² det M l² < 0, where 4 det M R² comes from the edges alone. */
function checkRadius(tiling) {
  if (!tiling.bounds.has(RATIO)) return;
  const { ring, dimension, determinantOfGram } = tiling;
  const { text, value: [p, q] } = tiling.bounds.get(RATIO);
  tiling.simplices.forEach((_, s) => {
    const { points } = simplexOf(tiling, s);
    const lengths = pairs(dimension).map(([i, j]) => square(tiling, vectorBetween(points[i], points[j])));
    const radius = scaled(dimension === 2 ? heron(ring, lengths) : crelle(ring, lengths), q * q);
    const volume = ring.times(ring.times(tiling.determinants[s], tiling.determinants[s]), determinantOfGram);
    const bound = scaled(volume, 4n * p * p);
    pairs(dimension).forEach(([i, j], e) => {
      const excess = difference(radius, ring.times(bound, lengths[e]));
      if (signOf(tiling, excess, () => 1n, () => `radius less edge ${i} ${j} of simplex ${s}, scaled`) < 0) return;
      refuse("ratio-not-below", `the circumradius of simplex ${s} is not below ${text} times the edge from corner ${i} to ${j}`);
    });
  });
}

/** R = a b c / (4 K), and 4 K² = det M: 4 det M R² = a² b² c². */
const heron = (ring, [first, second, third]) => ring.times(ring.times(first, second), third);

/**
 * 6 V R is the area of the triangle whose sides are the three products of opposite edges (Crelle), and 36 V² = det M. So 16 det M R² is
 * 2 (A B + B C + C A) - A² - B² - C² = 4 A B - (A + B - C)² for the squares A, B, C of the products.
 */
function crelle(ring, [l01, l02, l12, l03, l13, l23]) {
  const [x, y, z] = [ring.times(l01, l23), ring.times(l02, l13), ring.times(l03, l12)];
  const rest = difference(sum(x, y), z);
  const sixteenfold = difference(scaled(ring.times(x, y), 4n), ring.times(rest, rest));
  return sixteenfold.map((c) => c / 4n);
}

/**
 * The power of the corner w behind each facet with respect to the circumsphere, times det E: π(x) = |x - w|² - Σ λ_i(x) |x_i - w|² vanishes at
 * all x_i, and so π(w) det E = -Σ det E λ_i(w) |x_i - w|². A facet and its mate have one value (docs/soundness.md, section 6).
 */
function checkPowers(tiling, kind) {
  if (!claims(tiling, kind)) return;
  const scale = () => tiling.gramScale * power(tiling.scale, tiling.dimension + 2);
  tiling.simplices.forEach((_, s) => {
    const simplex = simplexOf(tiling, s);
    tiling.mates[s].forEach(([t, j, ...shift], i) => {
      if (j === undefined || t < s || (t === s && j < i)) return; // The first facet of a pair of mates speaks for both.
      const behind = pointOf(tiling, tiling.simplices[t][j], shift);
      const weights = simplex.points.map((_, k) => barycentric(tiling, simplex, k, behind));
      const squares = simplex.points.map((point) => square(tiling, vectorBetween(behind, point)));
      const value = negated(tiling.ring.dot(weights, squares));
      const found = signOf(tiling, value, scale, () => `power of the corner behind ${facetName(s, i)}`);
      judgePower(kind, found, `the corner behind ${facetName(s, i)} has the scaled power`, () => shown(value, scale()));
    });
  });
}

function judgePower(kind, found, name, value) {
  if (kind === DELAUNAY && found <= 0) refuse("not-delaunay", `${name} ${value()} and is not outside of the circumsphere`);
  if (kind === WEAKLY && found < 0) refuse("not-weakly-delaunay", `${name} ${value()} and is inside of the circumsphere`);
}

// ---- TCP: edges counted by names ---------------------------------------------------------------------------------------------------

/** [v, w, shift from v to w], the ends sorted: the same for translates, and for no other edges. */
function edgeForm(x, y) {
  const [[v, ...from], [w, ...to]] = byEntries(x, y) <= 0 ? [x, y] : [y, x];
  return [v, w, ...to.map((entry, k) => entry - from[k])];
}

function checkClosePacked(tiling) {
  if (!claims(tiling, TCP)) return;
  const edges = new Map();
  for (const corners of tiling.simplices) {
    for (const [i, j] of pairs(3)) {
      const form = edgeForm(corners[i], corners[j]);
      const entry = edges.get(form.join()) ?? { form, valence: 0 };
      entry.valence++;
      edges.set(form.join(), entry);
    }
  }
  const wrong = [...edges.values()].filter(({ valence }) => valence !== 5 && valence !== 6);
  const first = wrong.reduce((least, edge) => (least && byEntries(least.form, edge.form) < 0 ? least : edge), undefined);
  if (first) refuseEdge(first);
  const isSix = (x, y) => edges.get(edgeForm(x, y).join()).valence === 6;
  tiling.simplices.forEach((corners, s) =>
    corners.forEach((_, i) => {
      const [x, y, z] = facetOf(tiling, s, i);
      const sixes = [isSix(x, y), isSix(y, z), isSix(z, x)].filter(Boolean);
      if (sixes.length > 1) refuse("triangle-valence", `${facetName(s, i)} has two edges that are in 6 tetrahedra`);
    }),
  );
}

function refuseEdge({ form: [v, w, ...shift], valence }) {
  refuse("edge-valence", `the edge between the vertices ${v} and ${w}, shifted by ${bracketed(shift)}, is in ${valence} tetrahedra`);
}

// ---- Words for what is proved ------------------------------------------------------------------------------------------------------

/** The claim: the tiling, and each further statement. */
function sentences({ claim, witness }) {
  const isPlane = claim.dimension === 2;
  const count = witness.simplices.length;
  const simplices = isPlane ? (count === 1 ? "triangle" : "triangles") : count === 1 ? "tetrahedron" : "tetrahedra";
  const how = isPlane ? "edge to edge" : "face to face";
  const gram = ` the Gram matrix ${bracketed(claim.gram.map(rowInWords))}`;
  const tiling = `${domainInWords(claim)} is tiled ${how} by ${count} ${simplices}`;
  const where = `${boundaryInWords(claim, witness)}${latticeInWords(claim)}${gram}${fieldInWords(claim)}`;
  return [tiling + where, ...claim.statements.slice(1).map(statementInWords)];
}

const rowInWords = (numbers) => bracketed(numbers.map((number) => polynomialInWords([number].flat())));

function domainInWords(claim) {
  const { dimension, domain } = claim;
  const index = dimension - 2;
  if (domain.kind === SPACE) return ["the plane", "three-space"][index];
  if (domain.kind === REGION) return "a bounded region of three-space";
  const names = new Map([[SLAB, ["strip", "slab"]], [PRISM, ["", "prism"]], [SOLID, ["polygon", "polyhedron"]]]);
  const last = Array.from({ length: dimension - rankOf(claim) }, (_, i) => `x_${rankOf(claim) + 1 + i}`);
  const hull = domain.value.vertices.map(rowInWords).join(", ");
  return `the ${names.get(domain.kind)[index]} of the points whose coordinates ${bracketed(last)} lie in the convex hull of ${hull}`;
}

/** Of a region, whose boundary nothing else describes. */
function boundaryInWords({ domain }, { mates }) {
  if (domain.kind !== REGION) return "";
  const count = mates.flat().filter((mate) => mate.length === 0).length;
  return `, whose union it is, and its boundary by ${count} triangles, which meet in common vertices and edges only`;
}

function latticeInWords(claim) {
  if (claim.domain.kind === SPACE) return " and their translates under the lattice whose basis has";
  return [
    ", in the basis with",
    " and their translates by the integer multiples of the first vector of the basis with",
    " and their translates under the lattice of the first two vectors of the basis with",
  ][rankOf(claim)];
}

function fieldInWords({ field }) {
  if (!field) return "";
  return `, where a is the root of ${polynomialInWords(field.polynomial)} between ${field.root[0]} and ${field.root[1]}`;
}

function statementInWords({ kind, value }) {
  return {
    [ACUTE]: () => "all dihedral angles are acute",
    [NONOBTUSE]: () => "no dihedral angle is obtuse",
    [BELOW]: () => `all dihedral angles are below ${decimal(value)} degrees`,
    [ABOVE]: () => `all dihedral angles are above ${decimal(value)} degrees`,
    [RATIO]: () => `every circumradius is below ${decimal(value)} times the shortest edge of its simplex`,
    [DELAUNAY]: () => "it is the Delaunay triangulation of its vertices",
    [WEAKLY]: () => "it is a Delaunay triangulation of its vertices",
    [TCP]: () =>
      "it is tetrahedrally close packed: every edge is in 5 or 6 tetrahedra, and no triangle has two edges that are in 6",
  }[kind]();
}

/** A rational that is not negative, as a decimal where that is exact and of at most 18 places. */
function decimal(text) {
  const [p, q] = text.split("/").map(BigInt);
  const places = q === undefined ? 0 : Array.from({ length: 18 }, (_, i) => i + 1).find((m) => 10n ** BigInt(m) % q === 0n);
  if (!places) return text;
  const digits = ((p * 10n ** BigInt(places)) / q).toString().padStart(places + 1, "0");
  return `${digits.slice(0, -places)}.${digits.slice(-places)}`;
}

// ---- Text from a file, for people ---------------------------------------------------------------------------------------------------

/** The beginning of a text, so that no message is as long as the file. */
function excerpt(text) {
  const characters = [...text.slice(0, 402)];
  return characters.length > 200 ? `${characters.slice(0, 200).join("")}…` : text;
}

/** Whatever is not printable is escaped, so no text can forge a line. */
function oneLine(text) {
  const short = new Map([["\0", "\\0"], ["\t", "\\t"], ["\n", "\\n"], ["\r", "\\r"]]);
  const escaped = (character) => short.get(character) ?? `\\u{${character.codePointAt(0).toString(16)}}`;
  return text.replace(/(?! )[\p{C}\p{Z}\p{Grapheme_Extend}]/gu, escaped);
}

const quoted = (text) => `"${oneLine(text.replace(/["\\]/g, "\\$&"))}"`;

export { verify, sha256, oneLine, DEFAULT_LIMITS };
