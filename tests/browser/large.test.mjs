// A mesh with many different tetrahedra: the page is small, soon ready, and answers its reader all the time.
// LARGE is the number of cubes along each side (6 n³ tetrahedra); 26 gives 105,456. The time of the browser depends on who else uses the machine.

import assert from "node:assert/strict";
import { statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { directory, launch, noViolations, ready, setControl, visit, write } from "./common.mjs";

const N = Number(process.env.LARGE ?? 8);
let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());

// Vertices of a grid, moved by a sequence that looks like chance, and six tetrahedra for each cube.
function mesh(n) {
  let state = 7;
  const chance = () => { state = (state * 48271) % 2147483647; return state / 2147483647 - 0.5; };
  const grid = [...Array(n + 1).keys()], cubes = [...Array(n).keys()];
  const points = grid.flatMap((i) => grid.flatMap((j) => grid.map((k) => [i, j, k].map((c) => c + 0.2 * chance()))));
  const number = ([i, j, k]) => (i * (n + 1) + j) * (n + 1) + k, orders = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
  const rows = cubes.flatMap((i) => cubes.flatMap((j) => cubes.flatMap((k) => orders.map((order, index) => {
    const at = [i, j, k], row = [number(at)];
    for (const axis of order) { at[axis]++; row.push(number(at)); }
    return index < 3 ? row : [row[0], row[1], row[3], row[2]];
  }))));
  return ["# vtk DataFile Version 3.0", "mesh", "ASCII", "DATASET UNSTRUCTURED_GRID", `POINTS ${points.length} double`, ...points.map((p) => p.join(" ")),
    `CELLS ${rows.length} ${5 * rows.length}`, ...rows.map((row) => `4 ${row.join(" ")}`), `CELL_TYPES ${rows.length}`, ...rows.map(() => 10), ""].join("\n");
}

const OBSERVE = () => {
  window.long = [];
  new PerformanceObserver((list) => list.getEntries().forEach(({ duration }) => window.long.push(Math.round(duration)))).observe({ type: "longtask", buffered: true });
};

test(`${6 * N ** 3} tetrahedra`, async () => {
  const file = join(directory, "large.vtk");
  writeFileSync(file, mesh(N));
  const path = write("large", 0, file), size = statSync(path).size;
  assert.ok(size < 8e6, `${size} bytes`);
  await visit(browser, path, async (page) => {
    const start = Date.now();
    await ready(page);
    const seconds = (Date.now() - start) / 1000;
    const tasks = async (what, use) => {
      await page.evaluate(() => { window.long = []; });
      await use();
      await page.waitForTimeout(600);
      const long = await page.evaluate(() => window.long);
      console.log(`${what}: tasks of ${long.join(", ") || "less than 50"} ms`);
      return long;
    };
    await page.waitForTimeout(600);
    const first = await page.evaluate(() => window.long);
    console.log(`${size} bytes, ready in ${seconds} s, tasks of ${first.join(", ")} ms`);
    const box = await page.locator("canvas").boundingBox(), middle = [box.x + box.width / 2, box.y + box.height / 2];
    const all = [
      first,
      await tasks("cut", () => setControl(page, "cut", "55")),
      await tasks("turn", async () => { await page.mouse.move(...middle); await page.mouse.down(); await page.mouse.move(middle[0] + 80, middle[1] + 30, { steps: 5 }); await page.mouse.up(); }),
      await tasks("choose", () => page.mouse.click(...middle)),
      await tasks("table", () => page.locator("details.later summary").click()),
      await tasks("verify", async () => { await page.getByRole("button", { name: "Verify in this browser" }).click(); await page.locator(".verdict.good, .verdict.bad").waitFor({ timeout: 240000 }); }),
    ].flat();
    assert.match(await page.locator(".verdict[role=status]").textContent(), /agree with what is verified/);
    assert.ok(all.every((duration) => duration < 500), `tasks of ${all.join(", ")} ms; 200 are wanted on a machine without other work`);
    assert.match(await page.locator(".picked h3").textContent(), /^Tetrahedron \d+$/);
    // The six edges of the chosen one: squared lengths are exact fractions, angles are called rounded.
    const rows = await page.locator(".picked tbody").last().locator("tr").allTextContents();
    assert.equal(rows.length, 6);
    assert.ok(rows.every((row) => /\d+\/\d+about \d+\.\d{6}°$/.test(row)), rows[0]);
    assert.ok(await page.locator("tbody[data-rows] tr").count() > 0);
    assert.equal(await page.locator("label:visible", { hasText: "Cells" }).count(), 0, "no control without a meaning");
    await noViolations(page);
  }, { script: OBSERVE });
});
