// The simplices of one cell side by side, and which of their facets lie in the boundary of the cell. Doubles, for pictures only.

// The tiling `data` (see crates/publish/src/report/data.rs) ready for drawing. Each simplex is moved by a lattice vector, so that its centroid
// lies in the cell. `ids` has the corners of the simplices as numbers of placed vertices, `positions` their Cartesian coordinates.
async function prepare(data) {
  const certificate = data.certificate ? JSON.parse(data.certificate) : null;
  await breathe();
  if (data.kind === "family") setMember(data, certificate, data.steps);
  if (data.kind === "patches" && !data.choice) {
    data.choices = choicesOf(data, certificate);
    data = builtFrom(data, data.choices[0]);
  }
  const D = data.dimension, r = data.rank, rows = data.rows ?? certificate.witness.simplices;
  const cartesian = (x) => [0, 1, 2].map((i) => x.reduce((sum, c, k) => sum + c * (data.basis[k][i] ?? 0), 0));
  const tiling = { data, certificate, rows, cartesian, D, r, count: rows.length, bounds: {} };
  await placeRows(tiling);
  await findOuter(tiling);
  if (data.defects) linkDefects(tiling);
  return tiling;
}

// A corner of a row: the vertex, and the lattice vector by which it is moved.
const cornerOf = (tiling, corner) =>
  (Array.isArray(corner) && corner.length > 1 ? corner : [[corner].flat()[0], ...Array(tiling.r).fill(0)]);

// Fills `ids`, `moved`, `placements` and `positions`.
async function placeRows(tiling) {
  const { D, r, rows, count, data } = tiling, numbers = new Map(), placements = [];
  tiling.ids = new Uint32Array(count * (D + 1));
  tiling.moved = new Int32Array(count * D);
  // Vertices with small moves have numbers as names, which are quicker to find than texts.
  const name = (v, shift) => (shift.every((s) => s >= -32 && s < 32) ? shift.reduce((code, s) => 64 * code + s + 32, v) : [v, ...shift].join());
  const placed = (v, shift) => {
    const key = name(v, shift);
    let id = numbers.get(key);
    if (id === undefined) {
      numbers.set(key, id = numbers.size);
      placements.push([v, ...shift]);
    }
    return id;
  };
  await inPortions(count, (index) => {
    const corners = rows[index].slice(0, D + 1).map((corner) => cornerOf(tiling, corner));
    const moved = Array.from({ length: r }, (_, k) => {
      const sum = corners.reduce((s, corner) => s + data.points[corner[0]][k] + corner[k + 1], 0);
      return -Math.floor(sum / (D + 1) + 1e-9);
    });
    tiling.moved.set(moved, index * D);
    corners.forEach(([v, ...shift], i) => { tiling.ids[index * (D + 1) + i] = placed(v, shift.map((s, k) => s + moved[k])); });
  });
  tiling.placements = placements;
  placeVertices(tiling);
}

// Fills `positions`: where the placed vertices are.
function placeVertices(tiling) {
  const { placements, data } = tiling;
  tiling.positions = new Float64Array(3 * placements.length);
  placements.forEach(([v, ...shift], id) => tiling.positions.set(tiling.cartesian(data.points[v].map((x, k) => x + (shift[k] ?? 0))), 3 * id));
}

// Sets a bit of `outer` for each facet that no other simplex of the cell has; in the plane all triangles are seen.
async function findOuter(tiling) {
  const { D, ids, count } = tiling, vertices = tiling.positions.length / 3;
  tiling.outer = new Uint8Array(count).fill(D === 2 ? 8 : 0);
  if (D === 2) return;
  const open = new Map(), isSmall = vertices ** 3 < Number.MAX_SAFE_INTEGER;
  await inPortions(count, (index) => {
    for (let k = 0; k < 4; k++) {
      const facet = [0, 1, 2, 3].filter((i) => i !== k).map((i) => ids[4 * index + i]).sort((a, b) => a - b);
      const key = isSmall ? (facet[0] * vertices + facet[1]) * vertices + facet[2] : facet.join();
      if (!open.delete(key)) open.set(key, 4 * index + k);
    }
  });
  for (const facet of open.values()) tiling.outer[facet >> 2] |= 1 << (facet & 3);
}

// The Cartesian corners of a simplex.
function pointsOf(tiling, index) {
  const { ids, positions: p, D } = tiling;
  return Array.from({ length: D + 1 }, (_, i) => {
    const at = 3 * ids[index * (D + 1) + i];
    return [p[at], p[at + 1], p[at + 2]];
  });
}

// All that is known of a simplex. `corners` are as the certificate has them.
function cellOf(tiling, index) {
  const { D, data } = tiling, pairs = D * (D + 1) / 2, cell = data.cells?.[index];
  const corners = tiling.rows[index].slice(0, D + 1).map((corner) => cornerOf(tiling, corner));
  const moved = Array.from(tiling.moved.subarray(index * D, (index + 1) * D));
  const place = { index, corners, moved, points: pointsOf(tiling, index) };
  return cell ? { ...place, class: cell[0], volume: cell[1], edges: cell.slice(2, 2 + pairs), angles: cell.slice(2 + pairs) } : place;
}

// The translates of a cell: n in each direction of the lattice.
function translates(tiling, n) {
  let shifts = [[]];
  for (let k = 0; k < tiling.D; k++) {
    const steps = k < tiling.r ? n : 1;
    shifts = shifts.flatMap((s) => Array.from({ length: steps }, (_, i) => [...s, i]));
  }
  return shifts;
}

// The box around n cells in each direction, and a ball around them, close to the smallest one (M. Badoiu, K. Clarkson 2003: again and
// again a step, each shorter, toward the point that is farthest).
function boundsOf(tiling, n) {
  return tiling.bounds[n] ??= ballAround(translates(tiling, n).map(tiling.cartesian), tiling.positions);
}

function ballAround(offsets, positions) {
  const low = [Infinity, Infinity, Infinity], high = low.map((x) => -x);
  const each = (visit) => {
    for (const o of offsets) for (let i = 0; i < positions.length; i += 3) visit(positions[i] + o[0], positions[i + 1] + o[1], positions[i + 2] + o[2]);
  };
  each((...p) => p.forEach((x, k) => { low[k] = Math.min(low[k], x); high[k] = Math.max(high[k], x); }));
  let centre = mean([low, high]), radius = 0;
  // Many points are walked through less often; the ball is then a little larger.
  const steps = offsets.length * positions.length > 3e5 ? 4 : 40;
  for (let step = 2; step <= steps; step++) {
    let most = -1, far = centre;
    each((x, y, z) => {
      const square = (x - centre[0]) ** 2 + (y - centre[1]) ** 2 + (z - centre[2]) ** 2;
      if (square > most) [most, far] = [square, [x, y, z]];
    });
    radius = Math.sqrt(Math.max(most, 0));
    if (step < steps) centre = add(centre, add(far, centre, -1), 1 / step);
  }
  return { low, high, centre, radius };
}
