// The triangles to draw: facets in the boundary, or of every simplex where they stand apart, cut by a plane, and where the plane cuts.

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
const UNIT = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]];

// A growing list of triangles.
class Triangles {
  constructor() {
    this.count = 0;
    this.grow(1024);
  }

  grow(capacity) {
    const copy = (Kind, length, old) => { const fresh = new Kind(length); if (old) fresh.set(old); return fresh; };
    this.capacity = capacity;
    this.floats = copy(Float32Array, capacity * 3 * FLOATS, this.floats);
    this.bytes = copy(Uint8Array, capacity * 3 * 8, this.bytes);
    this.owners = copy(Uint32Array, capacity, this.owners);
  }

  // Adds a convex polygon as a fan.
  put(polygon, normal, centroid, ink, facet, owner, presence) {
    for (let i = 2; i < polygon.length; i++) {
      if (this.count === this.capacity) this.grow(2 * this.capacity);
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

// How many corners of a simplex, moved by `offset`, lie beyond the plane.
function beyond(tiling, index, offset, { n, c }) {
  const { ids, positions: p, D } = tiling, limit = c - dot(n, offset);
  let count = 0;
  for (let i = index * (D + 1); i < (index + 1) * (D + 1); i++) {
    const at = 3 * ids[i];
    if (n[0] * p[at] + n[1] * p[at + 1] + n[2] * p[at + 2] > limit) count++;
  }
  return count;
}

// The triangles of n cells in each direction. `colours(index, facet)` gives four indices into the palette, `plane` may be null.
// All facets are drawn where simplices stand apart, else those in the boundary of a cell.
async function triangles(tiling, n, plane, colours, isApart) {
  const list = new Triangles(), offsets = translates(tiling, n).map(tiling.cartesian), { count } = tiling;
  const all = isApart || tiling.presence ? 15 : 0;
  await inPortions(count * offsets.length, (owner) => {
    const index = owner % count, offset = offsets[Math.floor(owner / count)];
    const outside = plane ? beyond(tiling, index, offset, plane) : 0, drawn = all || tiling.outer[index];
    if (outside === tiling.D + 1 || (drawn === 0 && outside === 0)) return;
    putSimplex(list, tiling, { index, owner, offset, drawn }, outside ? plane : null, colours);
  });
  tiling.mark?.(list);
  return list.done();
}

// The facets of a simplex whose bits are set in `drawn`, on one side of the plane, and where the plane cuts it.
function putSimplex(list, tiling, { index, owner, offset, drawn }, plane, colours) {
  const presence = (facet) => tiling.presence?.(index, facet) ?? 0;
  if (presence() === NOT_DRAWN) return;
  const corners = pointsOf(tiling, index).map((p, i) => ({ p: add(p, offset), b: UNIT[i] }));
  const centroid = mean(corners.map(({ p }) => p));
  for (const [polygon, normal, facet] of facets(corners, tiling.D, centroid)) {
    const how = presence(facet);
    if (how !== NOT_DRAWN && drawn >> facet & 1) {
      list.put(plane ? clip(polygon, plane) : polygon, normal, centroid, colours(index, facet), facet, owner, how);
    }
  }
  if (plane && tiling.D === 3) list.put(section(corners, plane), plane.n, centroid, colours(index, 4), 4, owner, presence(4));
}

// The facets of a tetrahedron with outward normals; a triangle of the plane is its own only one.
function facets(corners, D, centroid) {
  if (D === 2) return [[corners, [0, 0, 1], 3]];
  return [0, 1, 2, 3].map((k) => {
    const polygon = corners.filter((_, i) => i !== k);
    let normal = unit(cross(add(polygon[1].p, polygon[0].p, -1), add(polygon[2].p, polygon[0].p, -1)));
    if (dot(normal, add(polygon[0].p, centroid, -1)) < 0) {
      normal = normal.map((x) => -x);
      // Counterclockwise for who looks at it from outside, which printers of solids need.
      [polygon[1], polygon[2]] = [polygon[2], polygon[1]];
    }
    return [polygon, normal, k];
  });
}
