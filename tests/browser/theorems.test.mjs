// Pages of families and of systems of patches: sliders move the vertices, pieces make the tilings of the catalogue, the claim is compared.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { addressOf, chooseTiling, expect, fitsInWidth, launch, noViolations, otherPicture, picture, ROOT, saved, screenshot, setControl, settled, visit, write } from "./common.mjs";

let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());

// The smallest and the largest angle that the page shows.
const anglesShown = async (page) => [...(await page.locator(".values").textContent()).matchAll(/(\d+\.\d+)°/g)].map(([, x]) => Number(x));
const near = (x, y, digits = 2e-3) => Math.abs(x - y) < digits;
// Waits until the angles are as this function wants them.
const anglesBecome = (page, isRight, message) => expect.poll(async () => {
  const angles = await anglesShown(page);
  return isRight(angles) || angles;
}, { message }).toBe(true);

// Points, cells and their number in a VTK file.
function mesh(text) {
  const lines = text.split("\n"), points = Number(/POINTS (\d+)/.exec(text)[1]), cells = Number(/CELLS (\d+)/.exec(text)[1]);
  const start = lines.findIndex((line) => line.startsWith("POINTS")) + 1, rows = lines.findIndex((line) => line.startsWith("CELLS")) + 1;
  return { points: lines.slice(start, start + points).map((line) => line.split(" ").map(Number)), cells: lines.slice(rows, rows + cells).map((line) => line.split(" ").slice(1).map(Number)) };
}

const volume = ({ points, cells }) => cells.reduce((sum, cell) => {
  const [a, b, c, d] = cell.map((k) => points[k]), [u, v, w] = [b, c, d].map((p) => p.map((x, k) => x - a[k]));
  return sum + Math.abs(u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0])) / 6;
}, 0);

// Verifies in the browser, and waits for this answer.
const verify = async (page, answer) => {
  const article = page.locator("article:visible");
  await article.getByRole("button", { name: "Verify in this browser" }).click();
  await expect(article.locator(".verdict[role=status]")).toHaveText(answer);
};

test("A15, stretched: the slider moves the vertices, and the angles are those of the paper at t = 1", async () => {
  await visit(browser, write("a15-all", 0, "a15-all"), async (page) => {
    await settled(page);
    const slider = page.getByRole("slider", { name: "t in (2/5, 16/5)" });
    // t runs from 2/5 to 16/5 in 200 steps: the middle is 9/5.
    await expect(slider).toHaveValue("100");
    await expect(page.locator(".choice output")).toHaveText("1.80000");
    const before = await picture(page), middle = await anglesShown(page);
    // Both ends are open, so they are no points of the box.
    assert.deepEqual([await slider.getAttribute("min"), await slider.getAttribute("max")], ["1", "199"]);
    await slider.focus();
    await page.keyboard.press("Home");
    await expect(page.locator(".choice output")).toHaveText("0.414000");
    await otherPicture(page, [before], "another parameter");
    await expect.poll(() => anglesShown(page)).not.toEqual(middle);
    // 43 steps of 14/1000 from 2/5 are 1.002; Table 1 has A15 at t = 1 from 53.13 to 78.46 degrees.
    await setControl(page, "parameter-0", "43");
    await anglesBecome(page, ([low, high]) => near(low, 53.13, 0.1) && near(high, 78.46, 0.1));
    await noViolations(page);
  });
});

test("Z, stretched: near the ends of the proved interval the largest angle comes near 90 degrees", async () => {
  await visit(browser, write("z-all", 0, "z-all"), async (page) => {
    await settled(page);
    for (const step of ["1", "199"]) {
      await setControl(page, "parameter-0", step);
      await expect(page.locator("[name=parameter-0]")).toHaveValue(step);
      // docs/families.md: right angles at both ends, t = 1/2 and t = 3.
      await anglesBecome(page, ([, high]) => high > 88.5 && high < 90);
    }
    // The volume of the cell: a² c √3/2 with G = [[2, 1, 0], [1, 2, 0], [0, 0, 2t]]: √(6 t).
    await setControl(page, "parameter-0", "100");
    const { bytes } = await saved(page, () => page.getByRole("button", { name: "Mesh, VTK" }).click());
    assert.ok(near(volume(mesh(bytes.toString())), Math.sqrt(6 * 1.75), 1e-9));
    await verify(page, /agree with what is verified/);
  });
});

test("a chosen tetrahedron follows the slider, and the address keeps the point", async () => {
  const path = write("slab-all", 0, "slab-all");
  let address;
  await visit(browser, path, async (page) => {
    await settled(page);
    await setControl(page, "chosen", "5");
    const row = () => page.locator(".picked tbody").last().locator("tr").first().textContent();
    const first = await row();
    assert.match(first, /^AB\d+\.\d{6}about \d+\.\d{6}°$/);
    await setControl(page, "parameter-0", "20");
    await expect.poll(row).not.toBe(first);
    // The corner 1 of the certificate is (1/3, 1/3, z1).
    await expect(page.locator('.picked math[alttext="z1"]').first()).toBeAttached();
    address = await addressOf(page);
    assert.match(address, /;at:20,100,100;/);
    await noViolations(page);
  });
  await visit(browser, path, async (page) => {
    await settled(page);
    await expect(page.locator("[name=parameter-0]")).toHaveValue("20");
    await expect(page.locator(".picked h3")).toHaveText("Tetrahedron 5");
  }, { hash: address });
  // Values beyond the box, and others that are none, change nothing.
  await visit(browser, path, async (page) => {
    for (const hash of ["#view=0;at:0,100,100", "#view=0;at:500,1,1", "#view=0;at:x", "#view=0;over:1"]) {
      await page.evaluate((hash) => { location.hash = hash; }, hash);
      await page.reload();
      await settled(page);
      await expect(page.locator("[name=parameter-0]"), hash).toHaveValue("100");
    }
  });
});

test("families of the plane, and with irrational ends", async () => {
  await visit(browser, write("plane-families", 0, "triangle-tiling-all", "two-corners-all"), async (page) => {
    await settled(page);
    // x = y = 1/2: G = [[1/2, 1/4], [1/4, 3/4]]; the cosine of the angle at the origin is (1/4)/√(3/8).
    const third = Math.acos(0.25 / Math.sqrt(3 / 8)) * 180 / Math.PI;
    await anglesBecome(page, (angles) => angles.every((x) => x < 90) && (angles.some((x) => near(x, third)) || (angles[0] < third && third < angles[1])), `${third} degrees`);
    await verify(page, /agree with what is verified/);
    await chooseTiling(page, 1);
    await settled(page);
    await expect.poll(async () => Number(await page.locator(".choice output:visible").textContent())).toBeCloseTo((Math.SQRT2 - 1) / 6, 6);
  });
});

// The catalogue has these tilings with these numbers of tetrahedra: Z, A15, H, sigma.
const MOSAICS = { "triangles, 3⁶": 40, "squares, 4⁴": 46, "rows, 3³.4²": 86, "snub square, 3².4.3.4": 172 };

test("pieces over squares and triangles make Z, A15, H and sigma", async () => {
  await visit(browser, write("square-triangle-all", 0, "square-triangle-all"), async (page) => {
    await settled(page);
    const names = await page.getByLabel("Tiling or piece").locator("option").allTextContents();
    assert.equal(names.length, 10, "eight tilings and two pieces");
    for (const [name, count] of Object.entries(MOSAICS)) {
      await page.locator("[name=mosaic]").selectOption({ label: name });
      await page.locator(".values", { hasText: `${count} tetrahedra in a cell` }).waitFor();
      // arccos(1/5), and for triangles alone arccos(√(1/20)).
      await anglesBecome(page, ([, high]) => near(high, name.startsWith("triangles") ? 77.079 : 78.463), name);
    }
    await settled(page);
    await expect(page.locator(".legend li")).toHaveText(["piece over tile 0", "piece over tile 1", "joins between pieces"]);
    const { bytes } = await saved(page, () => page.getByRole("button", { name: "Mesh, VTK" }).click());
    // The cell of sigma: two squares and four triangles of side 1, and the period 1.
    assert.ok(near(volume(mesh(bytes.toString())), 2 + Math.sqrt(3), 1e-9));
    await setControl(page, "chosen", "0");
    await expect(page.locator(".picked")).toHaveText(/In the piece over tile \d/);
    await noViolations(page);
    await page.locator("[name=mosaic]").selectOption({ label: "the piece over tile 1" });
    await page.locator(".values", { hasText: "34 tetrahedra." }).waitFor();
    await settled(page);
    await expect(page.locator("[name=colour] option:not([disabled])"), "one piece has one colour only").toHaveCount(1);
    await page.locator("[name=colour]").waitFor({ state: "hidden" });
    await verify(page, /agree with what is verified/);
  });
});

test("inflated tilings have the numbers of the catalogue", async () => {
  const expected = { "triangles, inflated once": "square-triangle-inflated-3", "squares, inflated once": "square-triangle-inflated-4", "3.4.6.4 with cut hexagons": "square-triangle-3464" };
  await visit(browser, write("inflated", 0, "square-triangle-all"), async (page) => {
    await settled(page);
    for (const [name, entry] of Object.entries(expected)) {
      const { witness } = JSON.parse(readFileSync(join(ROOT, `certificates/${entry}.json`), "utf8"));
      await page.locator("[name=mosaic]").selectOption({ label: name });
      await page.locator(".values", { hasText: `${witness.simplices.length} tetrahedra in a cell` }).waitFor();
    }
  });
});

test("words of kagome layers make Laves phases and Z", async () => {
  await visit(browser, write("kagome-all", 0, "kagome-all"), async (page) => {
    await settled(page);
    const field = page.getByLabel(/^Word of z, \+, -/), counts = { z: 40, "+": 34, "z+": 74, "+-": 68, "++--": 136 };
    for (const [word, count] of Object.entries(counts)) {
      await field.fill(word);
      await page.locator(".values", { hasText: `${count} tetrahedra in a cell` }).waitFor();
      await expect(field).toHaveValue(word);
    }
    await expect(page.locator(".legend li")).toHaveText(["piece over tile 1, letter +", "piece over tile 2, letter -", "joins between pieces"]);
    await field.fill("zx");
    await page.locator(".values", { hasText: "Expected a word of the letters z, +, -" }).waitFor();
    await noViolations(page);
    await field.fill("+");
    await page.locator(".values", { hasText: "34 tetrahedra in a cell" }).waitFor();
    assert.match(await addressOf(page), /;over:0,1;/);
    await page.reload();
    await page.locator(".values", { hasText: "34 tetrahedra in a cell" }).waitFor();
    await verify(page, /agree with what is verified/);
  });
});

test("a number that somebody changed is marked", async () => {
  for (const [name, from, to, marked] of [
    ["a15-all", "t in (2/5, 16/5)", "t in (1/5, 16/5)", 1],
    ["square-triangle-all", "copies of 2 convex polygons", "copies of 3 convex polygons", 1],
    ["kagome-all", "arccos(√(1/20)) = 77.0790", "arccos(√(1/20)) = 76.0790", 1],
  ]) {
    const path = write(`forged-${name}`, 0, name), html = readFileSync(path, "utf8"), start = html.indexOf("data-sentence");
    const forged = html.slice(0, start) + html.slice(start).replace(from, to);
    assert.notEqual(forged, html, name);
    writeFileSync(path, forged);
    await visit(browser, path, async (page) => {
      await verify(page, /This page says one thing differently/);
      await expect(page.locator("mark.differs")).toHaveCount(marked);
    });
  }
});

const names = ["goldberg-1-all", "goldberg-1-nonobtuse", "goldberg-2-all", "triangle-tiling-all", "two-corners-all", "slab-all", "slab-stretch-all", "z-all", "a15-all", "c14-all", "square-triangle-all", "kagome-all"];
let all;
for (const width of [1280, 390]) {
  test(`no violations at ${width} pixels, and nothing sticks out`, async () => {
    all ??= write("all", 0, ...names);
    await visit(browser, all, async (page) => {
      for (const index of names.keys()) {
        await chooseTiling(page, index);
        await settled(page);
        await page.locator(`#tiling-${index} details.long`).evaluateAll((nodes) => nodes.forEach((node) => { node.open = true; }));
        await noViolations(page, index ? "article:not([hidden])" : undefined);
        await fitsInWidth(page);
        await screenshot(page, `${names[index]}-${width}`);
      }
    }, { viewport: { width, height: 844 }, isMobile: width < 500, hasTouch: width < 500 });
  });
}
