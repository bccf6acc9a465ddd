// The first sentences about families and systems of patches, made anew from the certificate.

// `(3, 9/2]`
function sideWords([lowKind, [p, q]], [highKind, [r, s]]) {
  const value = (number, denominator) => quotient(integersOf(number), BigInt(denominator));
  return `${lowKind === "open" ? "(" : "["}${value(p, q)}, ${value(r, s)}${highKind === "open" ? ")" : "]"}`;
}

// `3/4*c2^2 - x + 1`, the highest powers first; coefficients that are irrational in brackets.
function polynomialText(terms, denominator, names) {
  let text = "";
  for (const [number, ...exponents] of terms.toReversed()) {
    const integers = integersOf(number), isRational = integers.slice(1).every((c) => c === 0n), minus = isRational && integers[0] < 0n;
    const powers = exponents.map((e, k) => (e === 0 ? "" : e === 1 ? names[k] : `${names[k]}^${e}`)).filter(Boolean).join("*");
    const size = isRational ? fraction(minus ? -integers[0] : integers[0], BigInt(denominator)) : `(${inProducts(integers, BigInt(denominator))})`;
    text += text === "" ? (minus ? "-" : "") : (minus ? " - " : " + ");
    text += powers === "" ? size : size === "1" ? powers : `${size}*${powers}`;
  }
  return text || "0";
}

// `1/2+3/4*a^2`
function inProducts(integers, denominator) {
  return integers.reduce((text, c, k) => {
    if (c === 0n) return text;
    const sign = text !== "" && c > 0n ? "+" : "", power = k === 0 ? "" : k === 1 ? "*a" : `*a^${k}`;
    return `${text}${sign}${fraction(c, denominator)}${power}`;
  }, "");
}

function sentenceOfFamily(certificate) {
  const { claim } = certificate, names = claim.parameters.map(({ name }) => name);
  const sides = claim.parameters.map(({ name, low, high }) => `${name} in ${sideWords(low, high)}`);
  return `for all ${sides.join(", ")}: ${firstSentence(certificate, (terms, q = 1) => polynomialText(terms, q, names))}`;
}

function sentenceOfPatches({ claim: { rank, tiles } }) {
  const counted = (n, name) => (n === 1 ? `one ${name}` : `${n} ${name}s`), sides = tiles.map(({ vertices }) => vertices.length).join(", ");
  const base = rank === 1 ? `edge-to-edge tiling of the plane by moved and turned copies of ${counted(tiles.length, "convex polygon")} (sides: ${sides})`
    : `division of the line into moved copies of ${counted(tiles.length, "segment")}`;
  const classes = new Set(tiles.flatMap((tile) => tile.classes));
  const meet = classes.size > 1 ? " in which sides of one class meet" : "";
  return `over every ${base}${meet}, periodic or not, the patches build a tiling of three-space, face to face`;
}

// The first sentence of a certificate of any kind.
function openingSentence(certificate) {
  const kinds = { family: sentenceOfFamily, patches: sentenceOfPatches };
  return (kinds[certificate.kind] ?? firstSentence)(certificate);
}
