// A second way to the numbers that a page shows: exact arithmetic in Q(a) on BigInt, dihedral angles from inner products of edges.
// It shares nothing with the page or with acutile.

export class Rational {
  constructor(p, q = 1n) {
    const g = gcd(p < 0n ? -p : p, q) || 1n;
    [this.p, this.q] = [p / g, q / g];
  }
  static of(text) {
    const [p, q = "1"] = text.split("/");
    return new Rational(BigInt(p), BigInt(q));
  }
  plus(o) { return new Rational(this.p * o.q + o.p * this.q, this.q * o.q); }
  times(o) { return new Rational(this.p * o.p, this.q * o.q); }
  get double() { return Number(this.p) / Number(this.q); }
}

const gcd = (a, b) => (b === 0n ? a : gcd(b, a % b));
const ZERO = new Rational(0n);

// Arithmetic modulo a monic polynomial; elements are arrays of its degree's length.
export class Field {
  constructor(data) {
    const isField = data !== "Q";
    this.modulus = isField ? data.polynomial.map((c) => new Rational(BigInt(c))) : [ZERO, new Rational(1n)];
    this.degree = this.modulus.length - 1;
    this.root = isField ? this.bisect([data.root.low, data.root.high].map((end) => Number(end) / Number(data.root.denominator))) : 0;
  }
  bisect([low, high]) {
    const value = (x) => this.modulus.reduceRight((sum, c) => sum * x + c.double, 0);
    for (let k = 0; k < 200; k++) {
      const middle = (low + high) / 2;
      if (value(low) * value(middle) > 0) low = middle;
      else high = middle;
    }
    return low;
  }
  // A number as a certificate writes it, over a denominator.
  of(number, denominator = 1) {
    const c = [number].flat().map((x) => new Rational(BigInt(x), BigInt(denominator)));
    return Array.from({ length: this.degree }, (_, k) => c[k] ?? ZERO);
  }
  // `1/2 - 3/4 a + a^2`, as a page writes it.
  parse(text) {
    const coefficients = Array(this.degree).fill(ZERO);
    const terms = text.replaceAll(" - ", " + -").split(" + ");
    for (const term of terms) {
      const match = /^(-?)(\d+(?:\/\d+)?)?\s*(a(?:\^(\d+))?)?$/.exec(term);
      if (!match || term === "") throw new Error(`not a number: ${text}`);
      const [, sign, size = "1", a, power = "1"] = match;
      const k = a ? Number(power) : 0;
      coefficients[k] = coefficients[k].plus(Rational.of(sign + size));
    }
    return coefficients;
  }
  plus(x, y) { return x.map((c, k) => c.plus(y[k])); }
  minus(x, y) { return x.map((c, k) => c.plus(y[k].times(new Rational(-1n)))); }
  times(x, y) {
    const product = Array(2 * this.degree - 1).fill(ZERO);
    x.forEach((c, i) => y.forEach((d, j) => { product[i + j] = product[i + j].plus(c.times(d)); }));
    while (product.length > this.degree) {
      const lead = product.pop(), start = product.length - this.degree;
      for (let k = 0; k < this.degree; k++) {
        product[start + k] = product[start + k].plus(lead.times(this.modulus[k]).times(new Rational(-1n)));
      }
    }
    return product;
  }
  equal(x, y) { return x.every((c, k) => c.p === y[k].p && c.q === y[k].q); }
  double(x) { return x.reduceRight((sum, c) => sum * this.root + c.double, 0); }
}

// A certificate's simplices.
export class Tiling {
  constructor(text) {
    const { claim, witness } = JSON.parse(text);
    Object.assign(this, { claim, witness, field: new Field(claim.field), dimension: claim.dimension });
    const upper = claim.gram.map((row) => row.map((x) => this.field.of(x)));
    this.gram = upper.map((row, i) => upper.map((_, j) => (i <= j ? row[j - i] : upper[j][i - j])));
  }
  corner(corner) {
    const [vertex, ...shift] = [corner].flat();
    return this.witness.vertices[vertex].map((x, k) => this.field.plus(this.field.of(x, this.witness.denominator), this.field.of(shift[k] ?? 0)));
  }
  corners(simplex) {
    return this.witness.simplices[simplex].slice(0, this.dimension + 1).map((corner) => this.corner(corner));
  }
  dot(x, y) {
    const { field } = this;
    let sum = field.of(0);
    x.forEach((a, i) => y.forEach((b, j) => { sum = field.plus(sum, field.times(field.times(a, b), this.gram[i][j])); }));
    return sum;
  }
  difference(x, y) { return x.map((c, k) => this.field.minus(c, y[k])); }
  squaredLength(simplex, i, j) {
    const corners = this.corners(simplex);
    const edge = this.difference(corners[j], corners[i]);
    return this.dot(edge, edge);
  }
  // The angle at the edge AB between C and D: numerator n and product d of its cosine n / √d.
  // With u = AB, v = AC, w = AD the parts of v and w orthogonal to u have the inner product (v·w - (u·v)(u·w)/(u·u)).
  dihedral(simplex, a, b, c, d) {
    const corners = this.corners(simplex), { field } = this;
    const [u, v, w] = [b, c, d].map((k) => this.difference(corners[k], corners[a]));
    const part = (x, y) => field.minus(field.times(this.dot(x, y), this.dot(u, u)), field.times(this.dot(u, x), this.dot(u, y)));
    return { n: part(v, w), d: field.times(part(v, v), part(w, w)) };
  }
  // The angle of a triangle at A: cos = v·w / √((v·v)(w·w)).
  planeAngle(simplex, a, b, c) {
    const corners = this.corners(simplex);
    const [v, w] = [b, c].map((k) => this.difference(corners[k], corners[a]));
    return { n: this.dot(v, w), d: this.field.times(this.dot(v, v), this.dot(w, w)) };
  }
  // Whether `text` (`√(5/12)`, `-2/7`, `√(1/2 + 1/4 a)`) is n / √d: its square times d is n², and its sign is that of n.
  isCosine(text, { n, d }) {
    const { field } = this, negative = text.startsWith("-") && text.includes("√") ? -1 : 1;
    const body = negative < 0 ? text.slice(1) : text;
    const inside = body.startsWith("√") ? field.parse(body.slice(1).replace(/^\((.*)\)$/, "$1")) : null;
    const plain = inside ? null : field.parse(body);
    const square = inside ?? field.times(plain, plain);
    const sign = inside ? negative : Math.sign(field.double(plain));
    const zero = field.equal(n, field.of(0));
    return field.equal(field.times(square, d), field.times(n, n)) && (zero || sign === Math.sign(field.double(n)));
  }
}
