// The exact data of a chosen simplex. Text from the certificate goes into the document as text, never as markup.

function element(name, attributes = {}, ...children) {
  const node = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.append(...children);
  return node;
}

// A fraction of integers in lowest terms.
function fraction(p, q) {
  const divisor = (a, b) => (b === 0n ? a : divisor(b, a % b));
  const common = divisor(p < 0n ? -p : p, q);
  return q === common ? `${p / common}` : `${p / common}/${q / common}`;
}

// A coordinate of the certificate over its denominator, moved by an integer: `1/2 + 3/4 a`.
function exact(number, denominator, shift) {
  const integers = [number].flat().map(BigInt), q = BigInt(denominator);
  integers[0] += BigInt(shift) * q;
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

// Bounds as one decimal where they agree in all digits, else the digits that they share and dots.
function decimal([low, high]) {
  if (low === high) return low.includes(".") ? low.replace(/\.?0+$/, "") : low;
  let k = 0;
  while (k < low.length && low[k] === high[k]) k++;
  return k > low.indexOf(".") + 2 && k > 3 ? `${low.slice(0, k)}…` : `${low} to ${high}`;
}

const table = (caption, head, rows) => element("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": caption },
  element("table", {}, element("caption", {}, caption),
    element("thead", {}, element("tr", {}, ...head.map((text) => element("th", { scope: "col" }, text)))),
    element("tbody", {}, ...rows.map((row) => element("tr", {}, ...row.map((cell, k) =>
      element(k ? "td" : "th", k ? {} : { scope: "row" }, cell)))))));

// What is shown of simplex `cell`; `shift` says which translate was chosen.
function details(tiling, cell, shift) {
  const { data, certificate, D } = tiling;
  const word = D === 2 ? "Triangle" : "Tetrahedron";
  const name = (i) => "ABCD"[i];
  const corners = cell.corners.map(([v, ...s], i) => {
    const coordinates = certificate.witness.vertices[v].map((x, k) => exact(x, certificate.witness.denominator, s[k] ?? 0)).join(", ");
    return [name(i), s.some((x) => x) ? `${v} + (${s.join(", ")})` : `${v}`, data.typeNames[data.types[v]], `(${coordinates})`];
  });
  const pairs = [];
  for (let i = 0; i <= D; i++) for (let j = i + 1; j <= D; j++) pairs.push([i, j]);
  const opposite = ([i, j]) => pairs.findIndex(([k, l]) => ![i, j].includes(k) && ![i, j].includes(l));
  const angle = (pair) => data.angles[cell.angles[pair]];
  const angleCells = (a) => [a.cosine, decimal(a.decimals), a.name && !a.name.startsWith("arccos") ? `${a.name}°` : `${decimal(a.degrees)}°`];
  const square = (pair) => data.numbers[cell.edges[pair]][0];
  const edges = D === 3
    ? table("Edges and the dihedral angles at them", ["edge", "squared length", "cosine", "decimal", "degrees"],
      pairs.map((pair, k) => [pair.map(name).join(""), square(k), ...angleCells(angle(opposite(pair)))]))
    : table("Sides and the angles opposite to them", ["side", "squared length", "cosine", "decimal", "degrees"],
      pairs.map((pair, k) => {
        const corner = [0, 1, 2].find((i) => !pair.includes(i));
        const at = pairs.findIndex(([i, j]) => i !== corner && j !== corner);
        // The angle at a corner lies between the sides opposite to the two others.
        return [pair.map(name).join(""), square(k), ...angleCells(angle(at))];
      }));
  const moved = shift.map((s, k) => s + cell.moved[k]);
  const [volume, approximate] = data.numbers[cell.volume];
  const basis = data.basis, cellVolume = D === 2 ? basis[0][0] * basis[1][1] : basis[0][0] * basis[1][1] * basis[2][2];
  const where = moved.some((x) => x) ? ` The chosen one is its translate by (${moved.slice(0, tiling.r).join(", ")}).` : "";
  return [
    element("h3", {}, `${word} ${cell.index}`),
    element("p", {}, `Congruence class ${cell.class}. ${D === 2 ? "Area" : "Volume"}: `, element("b", {}, volume),
      ` of the basis' ${D === 2 ? "parallelogram" : "parallelepiped"}, about ${(approximate * cellVolume).toPrecision(8)}.${where}`),
    element("div", { class: "pair" },
      table("Corners", ["corner", "vertex", "type", "coordinates in the basis"], corners), edges),
  ];
}

