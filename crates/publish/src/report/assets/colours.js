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

// The three ways to colour: a palette of at most 64 colours, the four indices for a simplex, a legend.
const COLOURINGS = {
  class: (tiling) => ({
    palette: tiling.data.palette.slice(0, 63).map(rgb),
    of: (cell) => Array(4).fill(cell.class % 63),
    legend: tiling.data.palette.map((hex, k) => [hex, `class ${k}`]),
  }),
  angle: (tiling) => {
    const low = Math.min(...tiling.largest), high = Math.max(...tiling.largest);
    const place = (x) => (high - low < 1e-9 ? 0.5 : (x - low) / (high - low));
    const steps = Array.from({ length: 64 }, (_, k) => viridis(k / 63));
    const marks = high - low < 1e-9 ? [low] : [0, 0.25, 0.5, 0.75, 1].map((t) => low + t * (high - low));
    const hex = (c) => "#" + c.map((x) => Math.round(255 * x).toString(16).padStart(2, "0")).join("");
    return {
      palette: steps,
      of: (cell) => Array(4).fill(Math.round(63 * place(tiling.largest[cell.index]))),
      legend: marks.map((x) => [hex(viridis(place(x))), `${x.toFixed(2)}°`]),
    };
  },
  type: (tiling) => ({
    palette: tiling.data.typeNames.map((_, k) => rgb(TYPE_COLOURS[k % 8])).slice(0, 64),
    of: (cell) => [0, 1, 2, 3].map((i) => (cell.corners[i] ? tiling.data.types[cell.corners[i][0]] % 64 : 0)),
    legend: tiling.data.typeNames.map((name, k) => [TYPE_COLOURS[k % 8], name]),
  }),
};

