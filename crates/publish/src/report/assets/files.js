// Downloads: the certificate as it is, and the simplices that the view shows as a mesh in doubles.

function download(name, type, content) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

// A file name without anything that a system may refuse.
const fileStem = (name) => name.replace(/\.json$/, "").replace(/[^A-Za-z0-9._-]+/g, "-").replace(/^[-.]+/, "") || "tiling";

// The vertices of all simplices of n cells in each direction, each once, and the simplices by their numbers.
function meshOf(tiling, n) {
  const numbers = new Map(), vertices = [], simplices = [];
  for (const shift of translates(tiling, n)) {
    for (let index = 0; index < tiling.count; index++) {
      const { corners, moved, points } = cellOf(tiling, index);
      simplices.push(corners.map(([v, ...s], i) => {
        const key = [v, ...s.map((x, k) => x + moved[k] + shift[k])].join();
        if (!numbers.has(key)) {
          numbers.set(key, vertices.length);
          vertices.push(add(points[i], tiling.cartesian(shift)));
        }
        return numbers.get(key);
      }));
    }
  }
  return { vertices, simplices };
}

// VTK legacy file, ASCII, an unstructured grid; cell data: the congruence class.
function vtkText(tiling, n) {
  const { vertices, simplices } = meshOf(tiling, n), corners = tiling.D + 1;
  const classOf = (index) => tiling.data.cells?.[index][0] ?? 0;
  // The title is one line of at most 256 characters.
  const title = fileStem(tiling.data.name).slice(0, 100);
  const classes = simplices.map((_, i) => classOf(i % tiling.count));
  return [
    "# vtk DataFile Version 3.0", `${title}, coordinates rounded to doubles`, "ASCII", "DATASET UNSTRUCTURED_GRID",
    `POINTS ${vertices.length} double`, ...vertices.map((p) => p.join(" ")),
    `CELLS ${simplices.length} ${simplices.length * (corners + 1)}`, ...simplices.map((s) => [corners, ...s].join(" ")),
    `CELL_TYPES ${simplices.length}`, ...simplices.map(() => (corners === 4 ? 10 : 5)),
    `CELL_DATA ${simplices.length}`, "SCALARS class int 1", "LOOKUP_TABLE default", ...classes, "",
  ].join("\n");
}

// Wavefront OBJ: the facets of every simplex, each simplex an object.
function objText(tiling, n) {
  const { vertices, simplices } = meshOf(tiling, n);
  const faces = tiling.D === 2 ? [[0, 1, 2]] : [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];
  return [
    `# ${fileStem(tiling.data.name)}, coordinates rounded to doubles`, ...vertices.map((p) => `v ${p.join(" ")}`),
    ...simplices.flatMap((s, i) => [`o simplex-${i}`, ...faces.map((f) => `f ${f.map((k) => s[k] + 1).join(" ")}`)]), "",
  ].join("\n");
}

