// Certificates in CBOR for the second verifier, which reads JSON: the same certificate in JSON, and afterwards the comparison of its
// digest with that of the bytes that were given. So a mistake here cannot let another certificate pass.

class CborError extends Error {}

// The items of docs/format.md: integers, texts, arrays. Every other one is an error.
class CborReader {
  constructor(bytes) {
    [this.bytes, this.at] = [bytes, 0];
  }

  fail(wanted) {
    throw new CborError(`at offset ${this.at}: expected ${wanted}`);
  }

  take(count) {
    if (this.at + count > this.bytes.length) this.fail(`${count} further bytes`);
    return this.bytes.subarray(this.at, this.at += count);
  }

  // The number in a head, which may be in the bytes after it.
  size(small) {
    if (small < 24) return BigInt(small);
    if (small > 27) this.fail("a definite length");
    return this.take(1 << (small - 24)).reduce((sum, byte) => sum * 256n + BigInt(byte), 0n);
  }

  item(depth = 0) {
    if (depth > 100) this.fail("fewer nested arrays");
    const [head] = this.take(1), major = head >> 5, size = this.size(head & 31);
    if (major === 0) return size;
    if (major === 1) return -1n - size;
    if (major === 3) return new TextDecoder("utf-8", { fatal: true }).decode(this.take(Number(size)));
    if (major === 4) {
      if (size > BigInt(this.bytes.length - this.at)) this.fail(`${size} items`);
      return Array.from({ length: Number(size) }, () => this.item(depth + 1));
    }
    if (major === 6 && (size === 2n || size === 3n)) return this.long(size === 3n);
    return this.fail("an integer, a text or an array");
  }

  // An integer that is too long for a head.
  long(isNegative) {
    const [head] = this.take(1);
    if (head >> 5 !== 2) this.fail("a byte string");
    const digits = Array.from(this.take(Number(this.size(head & 31))), (byte) => byte.toString(16).padStart(2, "0")).join("");
    return isNegative ? -1n - BigInt(`0x0${digits}`) : BigInt(`0x0${digits}`);
  }
}

// Records are arrays in CBOR. A shape makes an object of one; anything else stays as it is, and the verifier refuses it.
const recordOf = (names, shapes = {}) => (value) => {
  if (!Array.isArray(value) || value.length !== names.length) throw new CborError(`expected a record of ${names.join(", ")}`);
  return Object.fromEntries(names.map((name, k) => [name, (shapes[name] ?? ((x) => x))(value[k])]));
};
const listOf = (shape) => (value) => (Array.isArray(value) ? value.map(shape) : value);
const unlessText = (shape) => (value) => (typeof value === "string" ? value : shape(value));

const FIELD = unlessText(recordOf(["polynomial", "root"], { root: recordOf(["low", "high", "denominator"]) }));
const POLYTOPE = recordOf(["denominator", "vertices", "faces"]);
const DOMAIN = unlessText((value) => (Array.isArray(value) && Array.isArray(value[1]) ? [value[0], POLYTOPE(value[1]), ...value.slice(2)] : value));
const SHAPES = {
  tiling: {
    claim: recordOf(["dimension", "field", "gram", "domain", "statements"], { field: FIELD, domain: DOMAIN }),
    witness: recordOf(["denominator", "vertices", "boundary", "simplices"]),
  },
  family: {
    claim: recordOf(["dimension", "field", "parameters", "gram", "domain", "statements"],
      { field: FIELD, domain: DOMAIN, parameters: listOf(recordOf(["name", "low", "high"])) }),
    witness: recordOf(["denominator", "vertices", "boundary", "tree", "simplices"]),
  },
  patches: {
    claim: recordOf(["field", "gram", "rank", "tiles", "statements"], { field: FIELD, tiles: listOf(recordOf(["denominator", "vertices", "classes"])) }),
    witness: listOf(recordOf(["denominator", "offsets", "vertices", "pyramids", "simplices"])),
  },
};

// A value as canonical JSON: large integers as texts, and line feeds in the outer three levels.
function canonical(value, depth = 0) {
  if (typeof value === "bigint") return value > -(2n ** 53n) && value < 2n ** 53n ? `${value}` : `"${value}"`;
  if (typeof value === "string") return JSON.stringify(value);
  const isArray = Array.isArray(value), line = depth < 3 ? "\n" : "";
  const items = isArray ? value.map((item) => canonical(item, depth + 1)) : Object.entries(value).map(([name, item]) => `${JSON.stringify(name)}:${canonical(item, depth + 1)}`);
  const [open, close] = isArray ? "[]" : "{}";
  return items.length ? open + line + items.join(`,${line}`) + line + close : open + close;
}

// The certificate in JSON.
function jsonOfCbor(bytes) {
  const reader = new CborReader(bytes), tree = reader.item();
  if (reader.at !== bytes.length) reader.fail("the end");
  const kind = Array.isArray(tree) ? tree[2] : undefined, shapes = Object.hasOwn(SHAPES, kind) ? SHAPES[kind] : {};
  return `${canonical(recordOf(["format", "version", "kind", "claim", "witness"], shapes)(tree))}\n`;
}

const refusedCbor = (code, message) => ({ verdict: "malformed", code, message, claim: [], vertices: null, simplices: null, sha256: null });

// The answer to a certificate in either encoding.
function verifyEither(bytes) {
  // An array of CBOR begins so, and no text in UTF-8.
  if (bytes[0] >> 5 !== 4) return verify(bytes);
  let json;
  try {
    json = jsonOfCbor(bytes);
  } catch (error) {
    if (error instanceof CborError || error instanceof TypeError) return refusedCbor("cbor", error.message);
    throw error;
  }
  const answer = verify(json);
  if (answer.verdict === "verified" && answer.sha256 !== sha256(bytes)) {
    return refusedCbor("canonical", "the file is not the deterministic encoding of its certificate: the digests differ");
  }
  return answer;
}
