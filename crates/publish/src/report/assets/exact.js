// Numbers of a certificate, exactly: coordinates, squared lengths and volumes by integers over one denominator, modulo the field's polynomial.

// A fraction of integers in lowest terms.
function fraction(p, q) {
  const divisor = (a, b) => (b === 0n ? a : divisor(b, a % b));
  const common = divisor(p < 0n ? -p : p, q);
  return q === common ? `${p / common}` : `${p / common}/${q / common}`;
}

// Integer coefficients over a denominator as text: `1/2 + 3/4 a`.
function quotient(integers, q) {
  const coefficients = integers.map((c) => fraction(c, q));
  let text = "";
  coefficients.forEach((c, k) => {
    if (c === "0" && !(coefficients.length === 1)) return;
    const minus = c.startsWith("-"), size = minus ? c.slice(1) : c;
    text += text === "" ? (minus ? "-" : "") : (minus ? " - " : " + ");
    text += k === 0 ? size : (size === "1" ? "" : `${size} `) + (k === 1 ? "a" : `a^${k}`);
  });
  return text || "0";
}

const integersOf = (number) => [number].flat().map(BigInt);

// A coordinate of the certificate over its denominator, moved by an integer.
function exact(number, denominator, shift) {
  const integers = integersOf(number), q = BigInt(denominator);
  integers[0] += BigInt(shift) * q;
  return quotient(integers, q);
}

// Sums and products of integers with coefficients, as the certificate's field has them.
function fieldOf({ claim }) {
  const modulus = claim.field === "Q" ? [0n, 1n] : claim.field.polynomial.map(BigInt), degree = modulus.length - 1;
  const plus = (x, y, s = 1n) => x.map((c, k) => c + s * y[k]);
  const times = (x, y) => {
    const product = Array(2 * degree - 1).fill(0n);
    x.forEach((c, i) => y.forEach((d, j) => { product[i + j] += c * d; }));
    while (product.length > degree) {
      const lead = product.pop(), start = product.length - degree;
      for (let k = 0; k < degree; k++) product[start + k] -= lead * modulus[k];
    }
    return product;
  };
  return { plus, times, zero: Array(degree).fill(0n) };
}

// The corners of a simplex as integers over the certificate's denominator.
function integerCorners({ certificate: { witness } }, { corners }) {
  const q = BigInt(witness.denominator);
  return corners.map(([v, ...shift]) => witness.vertices[v].map((x, k) => {
    const [first, ...rest] = integersOf(x);
    return [first + BigInt(shift[k] ?? 0) * q, ...rest];
  }));
}

// The squared distance of two corners of a simplex.
function squaredLength(tiling, cell, i, j) {
  const { claim: { gram }, witness: { denominator } } = tiling.certificate, field = fieldOf(tiling.certificate);
  const corners = integerCorners(tiling, cell), d = corners[i].map((x, k) => field.plus(x, corners[j][k], -1n));
  let sum = field.zero;
  d.forEach((x, k) => d.forEach((y, l) => {
    const entry = integersOf(gram[Math.min(k, l)][Math.abs(k - l)]);
    sum = field.plus(sum, field.times(entry, field.times(x, y)));
  }));
  return quotient(sum, BigInt(denominator) ** 2n);
}

// The volume of a simplex in units of the basis' parallelepiped.
function volumeOf(tiling, cell) {
  const field = fieldOf(tiling.certificate), { D } = tiling, corners = integerCorners(tiling, cell);
  const rows = corners.slice(1).map((corner) => corner.map((x, k) => field.plus(x, corners[0][k], -1n)));
  const { plus, times } = field, minor = (i, j, k, l) => plus(times(rows[i][k], rows[j][l]), times(rows[i][l], rows[j][k]), -1n);
  const determinant = D === 2 ? minor(0, 1, 0, 1)
    : [[0, 1, 2], [1, 2, 0], [2, 0, 1]].reduce((sum, [k, l, m]) => plus(sum, times(rows[0][k], minor(1, 2, l, m))), field.zero);
  return quotient(determinant, BigInt(tiling.certificate.witness.denominator) ** BigInt(D) * (D === 2 ? 2n : 6n));
}
