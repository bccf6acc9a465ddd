// The view as a solid: STL for printers, 3MF and GLB with colours. Coordinates are doubles, rounded to what each format has.

// The triangles that the view shows: three points each, moved apart as in the view, and a colour.
function shownTriangles(view) {
  const { floats, bytes, owners } = view.mesh, { palette } = view.colouring, { explode, centre } = view.camera();
  const found = [];
  for (let i = 0; i < owners.length; i++) {
    if (bytes[24 * i + 5] === EDGES_ONLY) continue;
    const corners = [0, 1, 2].map((k) => {
      const f = floats.subarray((3 * i + k) * FLOATS, (3 * i + k) * FLOATS + 9);
      return [0, 1, 2].map((j) => Math.fround(f[j] + explode * (f[6 + j] - centre[j])));
    });
    // Triangles without area come from cuts through corners; readers of solids refuse them.
    if (new Set(corners.map((p) => p.join())).size === 3) found.push({ corners, colour: palette[bytes[24 * i]] });
  }
  return found;
}

// Each point once, and the triangles by their numbers.
function indexed(shown) {
  const numbers = new Map(), points = [];
  const number = (p) => {
    const key = p.join();
    if (!numbers.has(key)) numbers.set(key, points.push(p) - 1);
    return numbers.get(key);
  };
  return { points, rows: shown.map(({ corners }) => corners.map(number)) };
}

// STL, binary: a header of 80 bytes, the count, and 50 bytes for each triangle.
function stlBytes(view) {
  const shown = shownTriangles(view), bytes = new DataView(new ArrayBuffer(84 + 50 * shown.length));
  [...`${fileStem(view.tiling.data.name).slice(0, 60)}, rounded`].forEach((c, k) => bytes.setUint8(k, c.charCodeAt(0)));
  bytes.setUint32(80, shown.length, true);
  shown.forEach(({ corners: [a, b, c] }, i) => {
    const normal = unit(cross(add(b, a, -1), add(c, a, -1)));
    [normal, a, b, c].flat().forEach((x, k) => bytes.setFloat32(84 + 50 * i + 4 * k, x, true));
  });
  return bytes.buffer;
}

// glTF 2.0 in one file: points with normals and colours, three for each triangle, because facets are flat.
function glbBytes(view) {
  const shown = shownTriangles(view), count = 3 * shown.length;
  const floats = new Float32Array(9 * count), low = [Infinity, Infinity, Infinity], high = low.map((x) => -x);
  shown.forEach(({ corners: [a, b, c], colour }, i) => {
    const normal = unit(cross(add(b, a, -1), add(c, a, -1)));
    [a, b, c].forEach((p, k) => {
      floats.set(p, 9 * i + 3 * k);
      floats.set(normal, 3 * count + 9 * i + 3 * k);
      floats.set(colour.map(linear), 6 * count + 9 * i + 3 * k);
      p.forEach((x, j) => { low[j] = Math.min(low[j], x); high[j] = Math.max(high[j], x); });
    });
  });
  const part = (k) => ({ buffer: 0, byteOffset: 12 * count * k, byteLength: 12 * count, target: 34962 });
  const list = (k, more = {}) => ({ bufferView: k, componentType: 5126, count, type: "VEC3", ...more });
  return glbOf({
    asset: { version: "2.0", generator: "acutile" }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0, name: view.tiling.data.name }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 1, COLOR_0: 2 }, material: 0 }] }],
    materials: [{ pbrMetallicRoughness: { metallicFactor: 0, roughnessFactor: 0.8 }, doubleSided: true }],
    accessors: [list(0, { min: low, max: high }), list(1), list(2)], bufferViews: [0, 1, 2].map(part), buffers: [{ byteLength: 36 * count }],
  }, new Uint8Array(floats.buffer));
}

// A colour of the screen as the intensity of light (IEC 61966-2-1), which glTF wants.
const linear = (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);

// The container of glTF: a header, the description, the numbers.
function glbOf(description, numbers) {
  const text = new TextEncoder().encode(JSON.stringify(description)), padded = Math.ceil(text.length / 4) * 4;
  const bytes = new Uint8Array(28 + padded + numbers.length).fill(32, 20, 20 + padded), head = new DataView(bytes.buffer);
  const word = (at, ...values) => values.forEach((x, k) => head.setUint32(at + 4 * k, x, true));
  word(0, 0x46546c67, 2, bytes.length, padded, 0x4e4f534a);
  bytes.set(text, 20);
  word(20 + padded, numbers.length, 0x004e4942);
  bytes.set(numbers, 28 + padded);
  return bytes.buffer;
}

// 3MF, core specification 1.3: an archive with one model, a colour for each triangle.
function threeMfBytes(view) {
  const shown = shownTriangles(view), { points, rows } = indexed(shown);
  const colours = [...new Set(shown.map(({ colour }) => hexOf(colour)))], place = new Map(colours.map((hex, k) => [hex, k]));
  const model = [
    '<?xml version="1.0" encoding="UTF-8"?>',
    '<model unit="millimeter" xml:lang="en" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources><basematerials id="1">',
    ...colours.map((hex, k) => `<base name="colour ${k}" displaycolor="${hex.toUpperCase()}FF"/>`),
    '</basematerials><object id="2" type="model" pid="1" pindex="0"><mesh><vertices>',
    ...points.map(([x, y, z]) => `<vertex x="${x}" y="${y}" z="${z}"/>`), "</vertices><triangles>",
    ...rows.map(([a, b, c], i) => `<triangle v1="${a}" v2="${b}" v3="${c}" pid="1" p1="${place.get(hexOf(shown[i].colour))}"/>`),
    '</triangles></mesh></object></resources><build><item objectid="2"/></build></model>',
  ].join("\n");
  return archive([
    ["[Content_Types].xml", '<?xml version="1.0" encoding="UTF-8"?>\n<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>'],
    ["_rels/.rels", '<?xml version="1.0" encoding="UTF-8"?>\n<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>'],
    ["3D/3dmodel.model", model],
  ]);
}
