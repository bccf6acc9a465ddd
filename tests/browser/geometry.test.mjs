// The page's own geometry and mesh files, without a browser: sections, cut volumes, meshes.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const ROOT = fileURLToPath(new URL("../../", import.meta.url));
const ACUTILE = [process.env.ACUTILE, join(ROOT, "target/release/acutile"), join(ROOT, "target/debug/acutile")].find((path) => path && existsSync(path));
const source = ["vectors", "geometry", "polygons", "files"].map((name) => readFileSync(join(ROOT, `crates/publish/src/report/assets/${name}.js`), "utf8")).join("\n");
const page = new Function(`${source}; return { prepare, triangles, boundsOf, meshOf, vtkText, objText, fileStem, FLOATS };`)();

async function tiling(name) {
  const html = execFileSync(ACUTILE, ["report", name], { encoding: "utf8", maxBuffer: 1 << 26 });
  return page.prepare(JSON.parse(/id="data">(.*?)<\/script>/s.exec(html)[1]).tilings[0]);
}

// Area of a triangle, and the volume under it as seen from the origin (divergence theorem), of triangle i of a list.
function measure({ floats, bytes }, i) {
  const [a, b, c] = [0, 1, 2].map((k) => [...floats.subarray((3 * i + k) * page.FLOATS, (3 * i + k) * page.FLOATS + 3)]);
  const normal = [...floats.subarray(3 * i * page.FLOATS + 3, 3 * i * page.FLOATS + 6)];
  const u = b.map((x, k) => x - a[k]), v = c.map((x, k) => x - a[k]);
  const area = Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
  return { area, volume: area * (normal[0] * a[0] + normal[1] * a[1] + normal[2] * a[2]) / 3, facet: bytes[24 * i + 4] };
}

const sum = (list, of) => Array.from({ length: list.owners.length }, (_, i) => of(measure(list, i))).reduce((s, x) => s + x, 0);
const near = (x, y, what) => assert.ok(Math.abs(x - y) < 1e-5 * Math.max(1, Math.abs(y)), `${what}: found ${x}, expected ${y}`);
const none = () => [0, 0, 0, 0];

// The cube of six tetrahedra has side 1: cut at x = c it leaves the volume c and a section of area 1.
test("the cube, cut", async () => {
  const cube = await tiling("cube-6");
  for (const c of [0.25, 0.5, 0.9]) {
    for (const n of [[1, 0, 0], [0, 1, 0], [0, 0, 1]]) {
      const list = await page.triangles(cube, 1, { n, c }, none);
      near(sum(list, ({ volume }) => volume), c, "volume");
      near(sum(list, ({ area, facet }) => (facet === 4 ? area : 0)), 1, "section");
    }
  }
});

// Wherever the plane is, its two sides make up the cell. The Gram matrix of σ is diagonal, 2 + √3, 2 + √3, 1, so the cell's volume is 2 + √3.
test("sigma, cut from both sides", async () => {
  const sigma = await tiling("sigma"), { low, high } = page.boundsOf(sigma, 1);
  const volume = 2 + Math.sqrt(3);
  near(sum(await page.triangles(sigma, 1, null, none), ({ volume }) => volume), volume, "whole");
  for (const t of [0.1, 0.37, 0.62, 0.95]) {
    for (const k of [0, 1, 2]) {
      const c = low[k] + t * (high[k] - low[k]);
      const half = async (s) => sum(await page.triangles(sigma, 1, { n: [0, 1, 2].map((i) => (i === k ? s : 0)), c: s * c }, none), ({ volume }) => volume);
      near(await half(1) + await half(-1), volume, `at ${t} of axis ${k}`);
    }
  }
});

test("the square, cut", async () => {
  const list = await page.triangles(await tiling("square-8"), 1, { n: [0, 1, 0], c: 0.3 }, none);
  near(sum(list, ({ area }) => area), 0.3, "area");
});

test("meshes have the volume of the cells, positively oriented, and every vertex once", async () => {
  for (const [name, n, volume] of [["sigma", 1, 2 + Math.sqrt(3)], ["a15", 2, 8], ["slab", 2, 4 * 14.2 * Math.sqrt(36 * 36 - 18 * 18)]]) {
    const { vertices, simplices } = page.meshOf(await tiling(name), n);
    const volumes = simplices.map((s) => {
      const [u, v, w] = [1, 2, 3].map((k) => vertices[s[k]].map((x, i) => x - vertices[s[0]][i]));
      return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0])) / 6;
    });
    assert.ok(volumes.every((x) => x > 0), name);
    near(volumes.reduce((s, x) => s + x, 0), volume, name);
    const places = new Set(vertices.map((p) => p.map((x) => x.toFixed(6)).join()));
    assert.equal(places.size, vertices.length, name);
  }
});

test("mesh files", async () => {
  const cube = await tiling("cube-6");
  const lines = page.vtkText(cube, 1).split("\n");
  assert.equal(lines[4], "POINTS 8 double");
  assert.equal(lines[13], "CELLS 6 30");
  const text = page.objText(cube, 1);
  assert.equal(text.match(/^v /gm).length, 8);
  assert.equal(text.match(/^f /gm).length, 24);
  assert.equal(page.fileStem("a/b\nc <x>.json"), "a-b-c-x-");
});
