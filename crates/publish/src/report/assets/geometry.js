// The tiling as polygons: placing simplices, cutting them by a plane, the triangles to draw. Doubles, for pictures only.

// The tiling `data` (see crates/publish/src/report/data.rs) ready for drawing: every simplex with Cartesian corners, moved so that its centroid lies
// in the cell, and `moved`, the lattice vector by which it was moved.
function prepare(data) {
  const certificate = data.certificate ? JSON.parse(data.certificate) : null;
  const D = data.dimension, r = data.rank;
  const cartesian = (x) => [0, 1, 2].map((i) => x.reduce((sum, c, k) => sum + c * (data.basis[k][i] ?? 0), 0));
  const cells = (data.cells ?? data.rows).map((cell, index) => {
    const row = data.rows ? cell : certificate.witness.simplices[index].slice(0, D + 1);
    const corners = row.map((corner) => (Array.isArray(corner) && corner.length > 1 ? corner : [[corner].flat()[0], ...Array(r).fill(0)]));
    const points = corners.map(([v, ...shift]) => data.points[v].map((x, k) => x + (shift[k] ?? 0)));
    const moved = Array.from({ length: D }, (_, k) =>
      k < r ? -Math.floor(points.reduce((sum, p) => sum + p[k], 0) / (D + 1) + 1e-9) : 0);
    const pairs = D * (D + 1) / 2;
    const place = { index, corners, moved, points: points.map((p) => cartesian(p.map((x, k) => x + moved[k]))) };
    return data.rows ? place : { ...place, class: cell[0], volume: cell[1], edges: cell.slice(2, 2 + pairs), angles: cell.slice(2 + pairs) };
  });
  const largest = data.rows ? null : cells.map((cell) => Math.max(...cell.angles.map((a) => data.angles[a].approximate)));
  const tiling = { data, certificate, cells, largest, cartesian, D, r };
  if (data.defects) linkDefects(tiling);
  return tiling;
}

const add = (a, b, s = 1) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => { const n = Math.hypot(...a) || 1; return [a[0] / n, a[1] / n, a[2] / n]; };
const mean = (points) => points.reduce((s, p) => add(s, p, 1 / points.length), [0, 0, 0]);

// The translates of a cell: n in each direction of the lattice.
function translates(tiling, n) {
  let shifts = [[]];
  for (let k = 0; k < tiling.D; k++) {
    const steps = k < tiling.r ? n : 1;
    shifts = shifts.flatMap((s) => Array.from({ length: steps }, (_, i) => [...s, i]));
  }
  return shifts;
}

// A convex polygon, corners with position p and barycentric coordinates b, on the side n · p <= c of a plane.
function clip(polygon, plane) {
  const kept = [];
  polygon.forEach((a, i) => {
    const b = polygon[(i + 1) % polygon.length];
    const s = dot(plane.n, a.p) - plane.c, t = dot(plane.n, b.p) - plane.c;
    if (s <= 0) kept.push(a);
    if ((s < 0 && t > 0) || (s > 0 && t < 0)) kept.push(between(a, b, s / (s - t)));
  });
  return kept;
}

const between = (a, b, t) => ({
  p: a.p.map((x, k) => x + t * (b.p[k] - x)),
  b: a.b.map((x, k) => x + t * (b.b[k] - x)),
});

// Where a plane cuts a tetrahedron: a convex polygon, empty if it does not.
function section(corners, plane) {
  const side = corners.map((a) => dot(plane.n, a.p) - plane.c);
  const points = [];
  for (let i = 0; i < 4; i++) {
    for (let j = 0; j < 4; j++) {
      if (side[i] <= 0 && side[j] > 0) points.push(between(corners[i], corners[j], side[i] / (side[i] - side[j])));
    }
  }
  const centre = mean(points.map((q) => q.p));
  const u = unit(Math.abs(plane.n[0]) < 0.9 ? cross(plane.n, [1, 0, 0]) : cross(plane.n, [0, 1, 0]));
  const v = cross(plane.n, u);
  const turn = (q) => { const d = add(q.p, centre, -1); return Math.atan2(dot(d, v), dot(d, u)); };
  return points.sort((a, b) => turn(a) - turn(b));
}

// Numbers for each corner of a triangle to draw: position 3, normal 3, centroid of its simplex 3, barycentric coordinates 4, and bytes:
// colour at the four corners of the simplex 4, which facet the triangle lies in (4 for a section), whether only its edges are drawn, and the simplex in a separate array.
const FLOATS = 13;
// A simplex is drawn whole (0), by its edges, or not at all.
const EDGES_ONLY = 1, NOT_DRAWN = 2;

// A growing list of triangles.
class Triangles {
  constructor() {
    this.count = 0;
    this.grow(1024);
  }

  grow(room) {
    const copy = (Kind, length, old) => { const fresh = new Kind(length); if (old) fresh.set(old); return fresh; };
    this.room = room;
    this.floats = copy(Float32Array, room * 3 * FLOATS, this.floats);
    this.bytes = copy(Uint8Array, room * 3 * 8, this.bytes);
    this.owners = copy(Uint32Array, room, this.owners);
  }

  // Adds a convex polygon as a fan.
  put(polygon, normal, centroid, ink, facet, owner, presence) {
    for (let i = 2; i < polygon.length; i++) {
      if (this.count === this.room) this.grow(2 * this.room);
      [0, i - 1, i].forEach((k, corner) => {
        const at = 3 * this.count + corner, { floats, bytes } = this, { p, b } = polygon[k];
        floats.set(p, at * FLOATS);
        floats.set(normal, at * FLOATS + 3);
        floats.set(centroid, at * FLOATS + 6);
        floats.set(b, at * FLOATS + 9);
        bytes.set(ink, at * 8);
        bytes[at * 8 + 4] = facet;
        bytes[at * 8 + 5] = presence;
      });
      this.owners[this.count++] = owner;
    }
  }

  done() {
    const { count } = this;
    return { floats: this.floats.subarray(0, count * 3 * FLOATS), bytes: this.bytes.subarray(0, count * 24), owners: this.owners.subarray(0, count) };
  }
}

// All triangles to draw. `colours(cell)` gives four indices into the palette, `plane` may be null.
function triangles(tiling, n, plane, colours) {
  const list = new Triangles();
  translates(tiling, n).forEach((shift, copy) => {
    const offset = tiling.cartesian(shift);
    for (const cell of tiling.cells) {
      const corners = cell.points.map((p, i) => ({ p: add(p, offset), b: UNIT[i] }));
      if ((tiling.presence?.(cell) ?? 0) === NOT_DRAWN) continue;
      const outside = plane ? corners.filter(({ p }) => dot(plane.n, p) > plane.c).length : 0;
      if (outside === corners.length) continue;
      const centroid = mean(corners.map(({ p }) => p)), owner = copy * tiling.cells.length + cell.index;
      for (const [polygon, normal, facet] of facets(corners, tiling.D, centroid)) {
        const how = tiling.presence?.(cell, facet) ?? 0;
        if (how !== NOT_DRAWN) list.put(outside ? clip(polygon, plane) : polygon, normal, centroid, colours(cell, facet), facet, owner, how);
      }
      if (outside && tiling.D === 3) list.put(section(corners, plane), plane.n, centroid, colours(cell, 4), 4, owner, tiling.presence?.(cell, 4) ?? 0);
    }
  });
  tiling.mark?.(list);
  return list.done();
}

const UNIT = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]];

// The facets of a tetrahedron with outward normals; a triangle of the plane is its own only one.
function facets(corners, D, centroid) {
  if (D === 2) return [[corners, [0, 0, 1], 3]];
  return [0, 1, 2, 3].map((k) => {
    const polygon = corners.filter((_, i) => i !== k);
    let normal = unit(cross(add(polygon[1].p, polygon[0].p, -1), add(polygon[2].p, polygon[0].p, -1)));
    if (dot(normal, add(polygon[0].p, centroid, -1)) < 0) normal = normal.map((x) => -x);
    return [polygon, normal, k];
  });
}

// The box around all simplices of n cells in each direction, and a ball around them, close to the smallest one (M. Badoiu, K. Clarkson
// 2003: again and again a step, each shorter, toward the point that is farthest).
function bounds(tiling, n) {
  const points = translates(tiling, n).flatMap((shift) => {
    const offset = tiling.cartesian(shift);
    return tiling.cells.flatMap((cell) => cell.points.map((p) => add(p, offset)));
  });
  const extreme = (f, start) => points.reduce((e, p) => e.map((x, k) => f(x, p[k])), [start, start, start]);
  const low = extreme(Math.min, Infinity), high = extreme(Math.max, -Infinity);
  const square = (a, b) => (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 + (a[2] - b[2]) ** 2;
  let centre = mean([low, high]), farthest;
  for (let step = 2; step < 40; step++) {
    farthest = points.reduce((far, p) => (square(p, centre) > square(far, centre) ? p : far), points[0]);
    centre = add(centre, add(farthest, centre, -1), 1 / step);
  }
  const radius = Math.sqrt(points.reduce((most, p) => Math.max(most, square(p, centre)), 0));
  return { low, high, centre, radius };
}

