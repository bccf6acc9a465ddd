// Systems of patches: a piece alone, or the pieces put together on a tiling of the base. Doubles, for pictures only; docs/format.md defines
// tiles, offsets, pyramids and joins.

const NEAR = 1e-5;
const turned = ([x, y], [c, s]) => [c * x - s * y, s * x + c * y];
const less = (p, q) => p.map((x, k) => x - q[k]);
const isNear = (x, y) => Math.abs(x - y) < NEAR;

// The numbers of a certificate as doubles. Cartesian coordinates have the base first for polygons, so that the fibre is upright.
function systemOf({ claim, witness }, generator) {
  const number = (denominator) => (x) => doubleOf(x, generator) / Number(denominator), rank = claim.rank;
  const rows = basisOf(claim.gram.map((row) => row.map(number(1)))).map(([x, y, z]) => (rank === 1 ? [y, z, x] : [x, y, z]));
  const cartesian = (x) => [0, 1, 2].map((i) => x.reduce((sum, c, k) => sum + c * rows[k][i], 0));
  const tiles = claim.tiles.map(({ denominator, vertices, classes }, k) => {
    const patch = witness[k], inBase = vertices.map((point) => point.map(number(denominator)));
    return {
      classes, inBase, simplices: patch.simplices, pyramids: patch.pyramids,
      corners: inBase.map((point) => cartesian([...Array(rank).fill(0), ...point])),
      offsets: patch.offsets.map((x) => x.map(number(patch.denominator))), vertices: patch.vertices.map((x) => x.map(number(patch.denominator))),
    };
  });
  return { rank, rows, cartesian, tiles };
}

// How tile `k` can be laid on a polygon of the same shape: the corner of the polygon on which its corner 0 lies; -1 for another shape.
function fit({ corners }, polygon, scale) {
  const n = polygon.length, distance = (p, q) => Math.hypot(...less(p, q));
  if (corners.length !== n) return -1;
  return polygon.findIndex((_, start) => corners.every((p, i) => corners.every((q, j) =>
    isNear(distance(p, q), scale * distance(polygon[(start + i) % n], polygon[(start + j) % n])))));
}

// The tiles of a mosaic with the tile of the system on each, or null if some polygon has no tile.
function laidOut(system, { lattice, tiles }) {
  const side = Math.hypot(...less(system.tiles[0].corners[1], system.tiles[0].corners[0])), scale = side / Math.hypot(...less(tiles[0][1], tiles[0][0]));
  const laid = tiles.map((polygon) => {
    const kind = system.tiles.findIndex((tile) => fit(tile, polygon, scale) >= 0);
    if (kind < 0) return null;
    const start = fit(system.tiles[kind], polygon, scale), n = polygon.length;
    return { kind, polygon: polygon.map((_, i) => polygon[(start + i) % n].map((x) => scale * x)) };
  });
  return laid.includes(null) ? null : { lattice: lattice.map((v) => v.map((x) => scale * x)), laid };
}

// Coordinates in a basis of the plane.
function inLattice([[a, b], [c, d]], [x, y]) {
  const determinant = a * d - b * c;
  return [(x * d - y * c) / determinant, (a * y - b * x) / determinant];
}

// For each side of each tile the tile on the other side, its side, and its translate.
function neighbours({ lattice, laid }) {
  const sides = laid.flatMap(({ polygon }, tile) => polygon.map((p, side) => {
    const q = polygon[(side + 1) % polygon.length];
    return { tile, side, middle: inLattice(lattice, [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2]) };
  }));
  const found = laid.map(() => []);
  for (const one of sides) {
    const other = sides.find((two) => two !== one && less(one.middle, two.middle).every((x) => isNear(x, Math.round(x))));
    if (other) found[one.tile][one.side] = { ...other, shift: less(one.middle, other.middle).map(Math.round) };
  }
  return found;
}

// The height of each tile over the base in units of the period, and by how much the two lattice vectors rise; null if classes do not agree.
function heights(system, layout) {
  const beside = neighbours(layout), known = new Map([["0,0,0", 0]]), queue = [[0, 0, 0]];
  const tileOf = (tile) => system.tiles[layout.laid[tile].kind];
  for (const node of queue) {
    const [tile, ...cell] = node, height = known.get(node.join());
    for (const [side, other] of beside[tile].entries()) {
      if (!other || tileOf(tile).classes[side] !== tileOf(other.tile).classes[other.side]) return null;
      const next = [other.tile, cell[0] + other.shift[0], cell[1] + other.shift[1]];
      if (known.has(next.join()) || Math.max(...next.slice(1).map(Math.abs)) > 2) continue;
      known.set(next.join(), height + tileOf(tile).offsets[side][0] - tileOf(other.tile).offsets[other.side][0]);
      queue.push(next);
    }
  }
  const rises = [known.get("0,1,0"), known.get("0,0,1")];
  const own = layout.laid.map((_, tile) => {
    const [, ...cell] = queue.find((node) => node[0] === tile) ?? [];
    return known.get([tile, ...cell].join()) - cell[0] * rises[0] - cell[1] * rises[1];
  });
  return [...rises, ...own].every(Number.isFinite) ? { rises, own } : null;
}

// A mosaic of polygons as copies of patches: for each the tile and a function that places its points, and three lattice vectors.
function placedOnPlane(system, mosaic) {
  const layout = laidOut(system, mosaic), found = layout && heights(system, layout);
  if (!found) return null;
  const period = system.cartesian([1, 0, 0]);
  const copies = layout.laid.map(({ kind, polygon }, k) => {
    const { corners } = system.tiles[kind], [u, v] = [less(corners[1], corners[0]), less(polygon[1], polygon[0])];
    const size = u[0] ** 2 + u[1] ** 2, turn = [(u[0] * v[0] + u[1] * v[1]) / size, (u[0] * v[1] - u[1] * v[0]) / size];
    const place = (x) => {
      const p = system.cartesian(x), [a, b] = turned([p[0] - corners[0][0], p[1] - corners[0][1]], turn);
      return [polygon[0][0] + a, polygon[0][1] + b, p[2] + found.own[k] * period[2]];
    };
    return { kind, place };
  });
  return { copies, basis: [period, ...layout.lattice.map(([x, y], k) => [x, y, found.rises[k] * period[2]])] };
}

// The same for a word of segments, repeated for ever.
function placedOnLine(system, word) {
  let at = [0, 0, 0];
  const copies = word.map((kind, k) => {
    const { inBase: [[low], [high]], offsets: [, upper] } = system.tiles[kind], next = system.tiles[word[(k + 1) % word.length]];
    const from = at;
    at = [at[0] + upper[0] - next.offsets[0][0], at[1] + upper[1] - next.offsets[0][1], at[2] + high - low];
    return { kind, place: (x) => system.cartesian([x[0] + from[0], x[1] + from[1], x[2] + from[2] - low]) };
  });
  return { copies, basis: [system.cartesian([1, 0, 0]), system.cartesian([0, 1, 0]), system.cartesian(at)] };
}

const agrees = (system, word) => word.every((kind, k) => system.tiles[kind].classes[1] === system.tiles[word[(k + 1) % word.length]].classes[0]);

// The tiling that placed copies make: points and rows as a certificate has them, and for each row its piece, or -1 for a join.
function assembled(system, { copies, basis }) {
  const determinant = dot(basis[0], cross(basis[1], basis[2]));
  const coordinates = (p) => [[1, 2], [2, 0], [0, 1]].map(([i, j]) => dot(p, cross(basis[i], basis[j])) / determinant);
  const points = [], rows = [], pieces = [];
  const cornerAt = (x) => {
    const whole = x.map((c) => Math.floor(c + NEAR)), rest = less(x, whole);
    let v = points.findIndex((p) => less(p, rest).every((c) => isNear(c, 0)));
    if (v < 0) v = points.push(rest) - 1;
    return [v, ...whole];
  };
  const open = [];
  copies.forEach(({ kind, place }) => {
    const { vertices, simplices, pyramids } = system.tiles[kind];
    const corners = vertices.map((x) => cornerAt(coordinates(place(x)))), fibre = [...Array(3).keys()].slice(0, system.rank);
    const moved = (corner) => {
      const [v, ...s] = [corner].flat(), [id, ...shift] = corners[v];
      fibre.forEach((k) => { shift[k] += s[k] ?? 0; });
      return [id, ...shift];
    };
    for (const row of simplices) { rows.push(row.slice(0, 4).map(moved)); pieces.push(kind); }
    for (const [apex, polygon] of pyramids) {
      open.push({ apex: moved(apex), polygon: polygon.map(moved) });
    }
  });
  for (const row of joins(open)) { rows.push(row); pieces.push(-1); }
  return { points, rows, pieces, basis, rank: 3 };
}

// The tetrahedra of the joins: two pyramids over one polygon, up to a translation, give those around the segment of their apexes.
function joins(pyramids) {
  const waiting = new Map(), rows = [];
  for (const { apex, polygon } of pyramids) {
    const first = polygon.reduce((least, corner) => (compare(corner, least) < 0 ? corner : least));
    const back = ([v, ...s]) => [v, ...s.map((x, k) => x - first[k + 1])], name = polygon.map(back).map(String).sort().join(";");
    const other = waiting.get(name);
    waiting.set(name, { apex: back(apex) });
    if (!other) continue;
    waiting.delete(name);
    polygon.forEach((corner, i) => rows.push([back(apex), back(corner), back(polygon[(i + 1) % polygon.length]), other.apex]));
  }
  return rows;
}

// By vertex, then by the translation, so that translates of a polygon have corresponding first corners.
const compare = (a, b) => { const k = a.findIndex((x, i) => x !== b[i]); return k < 0 ? 0 : a[k] - b[k]; };

// `piece over tile 1, letter +`
const pieceName = ({ letters }, k) => `piece over tile ${k}${letters[k] ? `, letter ${letters[k]}` : ""}`;

// What a reader can choose: the pieces, then mosaics that the tiles fit, or words.
function choicesOf(data, certificate) {
  const system = data.system ??= systemOf(certificate, data.generator);
  const pieces = system.tiles.map((_, k) => ({ name: `the ${pieceName(data, k)}`, piece: k }));
  if (system.rank === 2) return [{ name: "a word of tiles", word: system.tiles.map((_, k) => k) }, ...pieces];
  const fitting = (data.mosaics ?? []).filter((mosaic) => placedOnPlane(system, mosaic));
  return [...fitting.map((mosaic) => ({ name: mosaic.name, mosaic })), ...pieces];
}

// The data of the chosen piece or tiling.
function builtFrom(data, choice) {
  const { system } = data;
  if (choice.word) return { ...data, ...assembled(system, placedOnLine(system, choice.word)), choice };
  if (choice.mosaic) return { ...data, ...assembled(system, placedOnPlane(system, choice.mosaic)), choice };
  const { vertices, simplices } = system.tiles[choice.piece];
  return { ...data, points: vertices, rows: simplices, basis: system.rows, rank: system.rank, pieces: simplices.map(() => choice.piece), choice };
}

const pieceWords = ({ pieces }, index) => (pieces[index] < 0 ? "In a join of two pyramids." : `In the piece over tile ${pieces[index]}.`);

const PIECE_COLOURS = [...TYPE_COLOURS.slice(0, 7)], JOIN_COLOUR = "#bbbbbb";

COLOURINGS.piece = ({ data }) => {
  const { pieces, system } = data, count = system.tiles.length, hex = (k) => PIECE_COLOURS[k % 7], used = new Set(pieces);
  return {
    palette: [...system.tiles.map((_, k) => rgb(hex(k))).slice(0, 63), rgb(JOIN_COLOUR)],
    of: (index) => Array(4).fill(pieces[index] < 0 ? Math.min(count, 63) : pieces[index] % 63),
    legend: [...system.tiles.map((_, k) => [hex(k), pieceName(data, k), k]).filter(([, , k]) => used.has(k)), ...(used.has(-1) ? [[JOIN_COLOUR, "joins between pieces"]] : [])],
  };
};

// The choice of a tiling or piece; words have a field of their own.
function patchControls(view) {
  const { data } = view.tiling, { system, choices, choice } = data;
  const select = element("select", { name: "mosaic" }, ...choices.map(({ name }, k) => element("option", { value: k }, name)));
  select.value = choices.findIndex(({ name }) => name === choice.name);
  const letters = system.tiles.map((_, k) => data.letters[k] ?? String(k)), spoken = element("p", { class: "values" });
  const field = element("input", { type: "text", name: "word", maxlength: "24", spellcheck: "false", value: (choice.word ?? system.tiles.map((_, k) => k)).map((k) => letters[k]).join("") });
  const wordLabel = element("label", {}, `Word of ${letters.join(", ")}, repeated for ever`, field);
  const change = () => {
    const wanted = choices[select.value], word = [...field.value].map((letter) => letters.indexOf(letter));
    const isWord = word.length > 0 && !word.includes(-1) && agrees(system, word);
    wordLabel.hidden = !wanted.word;
    field.toggleAttribute("aria-invalid", Boolean(wanted.word) && !isWord);
    if (wanted.word && !isWord) {
      view.coming = null;
      view.redraw();
      spoken.textContent = `Expected a word of the letters ${letters.join(", ")}, in which classes of ends agree.`;
    } else view.replace(builtFrom(data, wanted.word ? { ...wanted, word } : wanted));
  };
  select.addEventListener("input", change);
  field.addEventListener("input", change);
  wordLabel.hidden = !choice.word;
  spoken.textContent = `${view.tiling.count} tetrahedra${choice.piece === undefined ? " in a cell" : ""}. ${memberWords(view.tiling)}`.replace(" at this point", "");
  const note = element("p", { class: "hint" }, "The theorem holds over every tiling that these tiles make. Picture and values here are computed in doubles from the certificate.");
  return [element("label", {}, "Tiling or piece", select), wordLabel, spoken, note];
}
