// A refuted tiling in the view: defects in red, their facets darker, the rest as edges; and what is said of a chosen simplex.

const DEFECT_COLOURS = ["#c6ced8", "#d62728", "#8b0000", "#f2b8b5", "#111111"];
const [SOUND, DEFECT, FACET, PALE, POINT] = [0, 1, 2, 3, 4];

// Which defects each drawn simplex has, and which facets lie in defects.
function linkDefects(tiling) {
  const { data } = tiling, place = tiling.place = new Map(data.ids.map((id, index) => [id, index]));
  tiling.defectsOf = Array.from({ length: tiling.count }, () => []);
  tiling.marked = new Map();
  data.defects.forEach((defect, number) => {
    for (const id of defect.simplices) tiling.defectsOf[place.get(id)].push(number);
    for (const [id, opposite] of defect.facets) {
      const key = 4 * place.get(id) + opposite;
      tiling.marked.set(key, [...(tiling.marked.get(key) ?? []), number]);
    }
  });
  tiling.defect = null;
  tiling.others = "edges";
  tiling.presence = (index, facet) => presence(tiling, index, facet);
  tiling.mark = (list) => tiling.count && putMarkers(tiling, list, 0.008 * boundsOf(tiling, 1).radius);
}

const isIn = (tiling, defects) => defects.length > 0 && (tiling.defect === null || defects.includes(tiling.defect));

// How a simplex or one of its facets is drawn: whole, by its edges, or not at all.
function presence(tiling, index, facet) {
  if (isIn(tiling, tiling.defectsOf[index])) return 0;
  const isInner = facet !== undefined && facet < 4 && !(tiling.outer[index] >> facet & 1);
  if (tiling.others === "hidden" || (tiling.others === "edges" && isInner)) return NOT_DRAWN;
  return tiling.others === "edges" ? EDGES_ONLY : 0;
}

COLOURINGS.defect = (tiling) => ({
  palette: DEFECT_COLOURS.map(rgb),
  of: (index, facet) => {
    const defects = tiling.defectsOf[index];
    const ink = isIn(tiling, tiling.marked.get(4 * index + facet) ?? []) ? FACET : isIn(tiling, defects) ? DEFECT : defects.length ? PALE : SOUND;
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
    const owner = tiling.place.get(simplices[0]) ?? 0;
    const { moved: move } = cellOf(tiling, owner), p = tiling.cartesian(point.map((x, k) => x + move[k]));
    for (const [x, y, z] of [0, 1, 2, 3, 4, 5, 6, 7].map((bits) => [0, 1, 2].map((k) => (bits >> k & 1 ? 1 : -1)))) {
      const ends = [[x, 0, 0], [0, y, 0], [0, 0, z]].map((d, i) => ({ p: add(p, d, size), b: UNIT[i] }));
      list.put(ends, unit([x, y, z]), p, Array(4).fill(POINT), 3, owner, 0);
    }
  });
}

// A ball around the simplices of a defect.
function ballOf(tiling, number) {
  const points = tiling.data.defects[number].simplices.flatMap((id) => pointsOf(tiling, tiling.place.get(id)));
  if (points.length === 0) return null;
  const centre = mean(points);
  return { centre, radius: Math.max(...points.map((p) => Math.hypot(...add(p, centre, -1)))) };
}

// What is shown of a simplex: the text of its defects as the list has it.
function defectDetails(tiling, index, article) {
  const id = tiling.data.ids[index], defects = tiling.defectsOf[index];
  const name = tiling.data.names[id] ?? `${tiling.D === 2 ? "triangle" : "tetrahedron"} ${id}`;
  const about = defects.slice(0, 8).map((number) => {
    const copy = article.querySelector(`[data-defect="${number}"]`).closest("li").cloneNode(true);
    const button = copy.querySelector("button");
    button.replaceWith(element("p", {}, button.textContent));
    return element("div", { class: "about" }, ...copy.childNodes);
  });
  const words = defects.length ? `In ${defects.length} of the listed defects.` : "In none of the listed defects.";
  return [element("h3", {}, name[0].toUpperCase() + name.slice(1)), element("p", {}, words), ...about];
}
