// The ways to colour simplices.

const rgb = (hex) => [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16) / 255);
// Colours of vertex types: blue, orange, green, purple, yellow, vermilion, dark blue, grey.
const TYPE_COLOURS = ["#56b4e9", "#e69f00", "#009e73", "#cc79a7", "#f0e442", "#d55e00", "#0072b2", "#bbbbbb"];
// Viridis (S. van der Walt, N. Smith), at nine places; without its darkest part, on which edges would not show.
const VIRIDIS = ["#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c", "#28ae80", "#5ec962", "#addc30", "#fde725"].map(rgb);

function viridis(t) {
  const x = 1 + Math.min(Math.max(t, 0), 1) * 7, k = Math.min(Math.floor(x), 7);
  return VIRIDIS[k].map((c, i) => c + (x - k) * (VIRIDIS[k + 1][i] - c));
}

// The angles between the facets opposite to corners i and j, in degrees, rounded: [i, j, degrees].
function roundedAngles(points, D) {
  const pairs = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]].filter((pair) => Math.max(...pair) <= D);
  const degrees = (u, v) => Math.atan2(Math.hypot(...cross(u, v)), dot(u, v)) * 180 / Math.PI;
  if (D === 2) {
    return pairs.map(([i, j]) => {
      const at = points[3 - i - j];
      return [i, j, degrees(add(points[i], at, -1), add(points[j], at, -1))];
    });
  }
  const normals = facets(points.map((p) => ({ p })), D, mean(points)).map(([, normal]) => normal);
  return pairs.map(([i, j]) => [i, j, 180 - degrees(normals[i], normals[j])]);
}

// The largest angle of a simplex in degrees, rounded.
function largestAngle(tiling, index) {
  const { data, D } = tiling;
  if (!data.cells) return Math.max(...roundedAngles(pointsOf(tiling, index), D).map(([, , x]) => x));
  return Math.max(...data.cells[index].slice(-D * (D + 1) / 2).map((a) => data.angles[a].approximate));
}

// The least and the greatest of these over all simplices.
function rangeOfAngles(tiling) {
  if (tiling.data.range) return tiling.data.range;
  if (tiling.range) return tiling.range;
  let [low, high] = [Infinity, -Infinity];
  for (let index = 0; index < tiling.count; index++) {
    const x = largestAngle(tiling, index);
    [low, high] = [Math.min(low, x), Math.max(high, x)];
  }
  return tiling.range = [low, high];
}

const hexOf = (c) => "#" + c.map((x) => Math.round(255 * x).toString(16).padStart(2, "0")).join("");

// The ways to colour: a palette of at most 64 colours, the four indices for a simplex, a legend.
const COLOURINGS = {
  class: (tiling) => ({
    palette: tiling.data.palette.slice(0, 63).map(rgb),
    of: (index) => Array(4).fill(tiling.data.cells[index][0] % 63),
    legend: tiling.data.palette.map((hex, k) => [hex, `class ${k}`]),
  }),
  angle: (tiling) => {
    const [low, high] = rangeOfAngles(tiling), isOne = high - low < 1e-9;
    const place = (x) => (isOne ? 0.5 : (x - low) / (high - low));
    const steps = Array.from({ length: 64 }, (_, k) => viridis(k / 63));
    const marks = isOne ? [low] : [0, 0.25, 0.5, 0.75, 1].map((t) => low + t * (high - low));
    return {
      palette: steps,
      of: (index) => Array(4).fill(Math.min(63, Math.max(0, Math.round(63 * place(largestAngle(tiling, index)))))),
      legend: marks.map((x) => [hexOf(viridis(place(x))), `${x.toFixed(2)}°`]),
    };
  },
  type: (tiling) => ({
    palette: tiling.data.typeNames.map((_, k) => rgb(TYPE_COLOURS[k % 8])).slice(0, 64),
    of: (index) => [0, 1, 2, 3].map((i) => {
      const corner = tiling.rows[index][i];
      return i <= tiling.D ? tiling.data.types[[corner].flat()[0]] % 64 : 0;
    }),
    legend: tiling.data.typeNames.map((name, k) => [TYPE_COLOURS[k % 8], name]),
  }),
};
