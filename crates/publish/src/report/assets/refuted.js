// A refuted tiling in the view: defects in red, their facets darker, the rest as edges; and what is said of a chosen simplex.

const DEFECT_COLOURS = ["#c6ced8", "#d62728", "#8b0000", "#f2b8b5", "#111111"];
const [SOUND, DEFECT, FACET, PALE, POINT] = [0, 1, 2, 3, 4];

// Which defects each drawn simplex has, and which facets lie in defects.
function linkDefects(tiling) {
  const place = new Map(tiling.data.ids.map((id, index) => [id, index]));
  for (const cell of tiling.cells) [cell.id, cell.defects, cell.marked] = [tiling.data.ids[cell.index], [], new Map()];
  tiling.data.defects.forEach((defect, number) => {
    for (const id of defect.simplices) tiling.cells[place.get(id)].defects.push(number);
    for (const [id, opposite] of defect.facets) {
      const { marked } = tiling.cells[place.get(id)];
      marked.set(opposite, [...(marked.get(opposite) ?? []), number]);
    }
  });
  tiling.defect = null;
  tiling.others = "edges";
  tiling.presence = (cell, facet) => presence(tiling, cell, facet);
  tiling.mark = (list) => tiling.cells.length && putMarkers(tiling, list, 0.008 * bounds(tiling, 1).radius);
  const seen = new Map();
  const key = (cell, facet) => cell.corners.map(([v, ...s], i) => (i === facet ? null : [v, ...s.map((x, k) => x + cell.moved[k])].join()))
    .filter((text) => text !== null).sort().join(";");
  for (const cell of tiling.cells) for (let k = 0; k <= tiling.D; k++) seen.set(key(cell, k), (seen.get(key(cell, k)) ?? 0) + 1);
  for (const cell of tiling.cells) cell.outer = [0, 1, 2, 3].map((k) => tiling.D === 2 || seen.get(key(cell, k)) === 1);
}

const isIn = (tiling, defects) => defects.length > 0 && (tiling.defect === null || defects.includes(tiling.defect));

// How a simplex or one of its facets is drawn: whole, by its edges, or not at all.
function presence(tiling, cell, facet) {
  if (isIn(tiling, cell.defects)) return 0;
  if (tiling.others === "hidden" || (tiling.others === "edges" && facet !== undefined && facet < 4 && !cell.outer[facet])) return NOT_DRAWN;
  return tiling.others === "edges" ? EDGES_ONLY : 0;
}

COLOURINGS.defect = (tiling) => ({
  palette: DEFECT_COLOURS.map(rgb),
  of: (cell, facet) => {
    const ink = isIn(tiling, cell.marked.get(facet) ?? []) ? FACET : isIn(tiling, cell.defects) ? DEFECT : cell.defects.length ? PALE : SOUND;
    return Array(4).fill(ink);
  },
  legend: [
    [DEFECT_COLOURS[DEFECT], "defect"], ...(tiling.data.defects.some((defect) => defect.facets.length) ? [[DEFECT_COLOURS[FACET], "facet of a defect"]] : []),
    ...(tiling.data.defects.some((defect) => defect.point) ? [[DEFECT_COLOURS[POINT], "point in a defect"]] : []),
    ...(tiling.defect === null ? [] : [[DEFECT_COLOURS[PALE], "other defects"]]), [DEFECT_COLOURS[SOUND], "no defect found"],
  ],
});

// Small octahedra at the points that show defects.
function putMarkers(tiling, list, size) {
  tiling.data.defects.forEach(({ point, simplices }, number) => {
    if (!point || !isIn(tiling, [number])) return;
    const owner = Math.max(0, tiling.data.ids.indexOf(simplices[0]));
    const move = tiling.cells[owner].moved, p = tiling.cartesian(point.map((x, k) => x + move[k]));
    for (const [x, y, z] of [0, 1, 2, 3, 4, 5, 6, 7].map((bits) => [0, 1, 2].map((k) => (bits >> k & 1 ? 1 : -1)))) {
      const ends = [[x, 0, 0], [0, y, 0], [0, 0, z]].map((d, i) => ({ p: add(p, d, size), b: UNIT[i] }));
      list.put(ends, unit([x, y, z]), p, Array(4).fill(POINT), 3, owner, 0);
    }
  });
}

// A ball around the simplices of a defect.
function ballOf(tiling, number) {
  const points = tiling.cells.filter((cell) => cell.defects.includes(number)).flatMap((cell) => cell.points);
  if (points.length === 0) return null;
  const centre = mean(points);
  return { centre, radius: Math.max(...points.map((p) => Math.hypot(...add(p, centre, -1)))) };
}

// What is shown of a simplex: the text of its defects as the list has it.
function defectDetails(tiling, cell, article) {
  const name = tiling.data.names[cell.id] ?? `${tiling.D === 2 ? "triangle" : "tetrahedron"} ${cell.id}`;
  const about = cell.defects.slice(0, 8).map((number) => {
    const copy = article.querySelector(`[data-defect="${number}"]`).closest("li").cloneNode(true);
    const button = copy.querySelector("button");
    button.replaceWith(element("p", {}, button.textContent));
    return element("div", { class: "about" }, ...copy.childNodes);
  });
  const words = cell.defects.length ? `In ${cell.defects.length} of the listed defects.` : "In none of the listed defects.";
  return [element("h3", {}, name[0].toUpperCase() + name.slice(1)), element("p", {}, words), ...about];
}
