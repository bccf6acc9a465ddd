// Files, pictures and addresses of the view, and the comparison of a page's words with the verified claim.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { inflateSync } from "node:zlib";
import { addressOf, chooseTiling, directory, expect, launch, noViolations, picture, ready, saved, setControl, settled, visit, write } from "./common.mjs";

let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());

const openShare = (page) => page.locator(".share summary").click();

// The points of a binary STL, three for each triangle.
function pointsOfStl(bytes) {
  const count = bytes.readUInt32LE(80);
  assert.equal(bytes.length, 84 + 50 * count);
  return Array.from({ length: count }, (_, i) => [1, 2, 3].map((k) => [0, 1, 2].map((j) => bytes.readFloatLE(84 + 50 * i + 12 * k + 4 * j)).join()));
}

// The six-fold volume that triangles enclose; positive if they are counterclockwise for who looks from outside.
function enclosed(triangles) {
  return triangles.reduce((sum, corners) => {
    const [[a, b, c], [d, e, f], [g, h, i]] = corners.map((p) => p.split(",").map(Number));
    return sum + a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
  }, 0);
}

// Each edge of a closed surface is in as many triangles in one direction as in the other.
function isClosed(triangles) {
  const edges = new Map();
  for (const corners of triangles) {
    corners.forEach((p, k) => {
      const q = corners[(k + 1) % 3], [key, sign] = p < q ? [`${p};${q}`, 1] : [`${q};${p}`, -1];
      edges.set(key, (edges.get(key) ?? 0) + sign);
    });
  }
  return [...edges.values()].every((sum) => sum === 0);
}

test("STL, 3MF and GLB have the same closed surface", async () => {
  await visit(browser, write("solids", 0, "a15"), async (page) => {
    await ready(page);
    await openShare(page);
    const stl = await saved(page, () => page.getByRole("button", { name: "Solid, STL" }).click());
    const triangles = pointsOfStl(stl.bytes);
    assert.ok(isClosed(triangles));
    // The cell of A15 is a cube of side 1 up to the choice of the 46 tetrahedra; the volume is that of the cube.
    assert.ok(Math.abs(enclosed(triangles) / 6 - 1) < 1e-5, `${enclosed(triangles) / 6}`);

    const glb = (await saved(page, () => page.getByRole("button", { name: "Solid, GLB" }).click())).bytes;
    assert.deepEqual([glb.readUInt32LE(0), glb.readUInt32LE(4), glb.readUInt32LE(8)], [0x46546c67, 2, glb.length]);
    const length = glb.readUInt32LE(12), json = JSON.parse(glb.subarray(20, 20 + length).toString());
    assert.equal(json.accessors[0].count, 3 * triangles.length);
    assert.equal(json.buffers[0].byteLength, glb.readUInt32LE(20 + length));

    const { bytes } = await saved(page, () => page.getByRole("button", { name: "Solid, 3MF" }).click());
    assert.equal(bytes.readUInt32LE(0), 0x04034b50);
    const text = bytes.toString("latin1");
    assert.equal(text.match(/<triangle /g).length, triangles.length);
    assert.equal(text.match(/<vertex /g).length, new Set(triangles.flat()).size);
    if (process.env.SOLIDS) {
      for (const [name, content] of [["a15.stl", stl.bytes], ["a15.glb", glb], ["a15.3mf", bytes]]) writeFileSync(join(process.env.SOLIDS, name), content);
    }
  });
});

test("simplices that stand apart are closed each, and a cut surface is drawn", async () => {
  await visit(browser, write("apart", 0, "bcc"), async (page) => {
    await ready(page);
    await openShare(page);
    const button = page.getByRole("button", { name: "Solid, STL" });
    await setControl(page, "explode", "50");
    await settled(page);
    const apart = pointsOfStl((await saved(page, () => button.click())).bytes);
    // Twelve tetrahedra in the cube of bcc, which has two lattice points.
    assert.equal(apart.length, 6 * 4);
    assert.ok(isClosed(apart));
    await setControl(page, "explode", "0");
    await setControl(page, "cut", "50");
    await settled(page);
    const cut = pointsOfStl((await saved(page, () => button.click())).bytes);
    const whole = enclosed(apart);
    assert.ok(enclosed(cut) > 0 && enclosed(cut) < whole, "a part of the volume is left");
  });
});

// The colours of a PNG with eight bits for each, as its rows with their filters.
function rowsOfPng(bytes) {
  assert.equal(bytes.subarray(1, 4).toString(), "PNG");
  const parts = [];
  for (let at = 8; at < bytes.length; at += 12 + bytes.readUInt32BE(at)) {
    if (bytes.subarray(at + 4, at + 8).toString() === "IDAT") parts.push(bytes.subarray(at + 8, at + 8 + bytes.readUInt32BE(at)));
  }
  return { width: bytes.readUInt32BE(16), height: bytes.readUInt32BE(20), data: inflateSync(Buffer.concat(parts)) };
}

test("the view as a picture", async () => {
  await visit(browser, write("png", 0, "sigma"), async (page) => {
    await ready(page);
    await settled(page);
    await openShare(page);
    const { name, bytes } = await saved(page, () => page.getByRole("button", { name: "Picture, PNG" }).click());
    assert.equal(name, "sigma.png");
    const { width, height, data } = rowsOfPng(bytes);
    assert.deepEqual([width, height], await page.locator("canvas").evaluate((node) => [node.width, node.height]));
    assert.ok(new Set(data).size > 50, "it is not empty");
    // The screen of a busy machine shows an earlier picture for a while.
    await expect.poll(async () => new Set(rowsOfPng(await page.locator("canvas").screenshot()).data).size, { message: "nor is the screen" }).toBeGreaterThan(50);
  });
});

test("a frame that comes late does not paint over the finished picture", async () => {
  const late = `window.requestAnimationFrame = (draw) => setTimeout(() => { draw(performance.now()); window.lastFrame = performance.now(); }, 1500);
    window.cancelAnimationFrame = clearTimeout;`;
  await visit(browser, write("late", 0, "a15"), async (page) => {
    await ready(page);
    await page.locator("canvas").focus();
    await page.keyboard.press("ArrowLeft");
    const finished = await picture(page), frames = await page.evaluate(() => window.lastFrame ?? 0);
    // A second frame is asked for and comes: all that were asked for before have come, or never will.
    await page.evaluate(() => new Promise((resolve) => { requestAnimationFrame(resolve); }));
    assert.ok(await page.evaluate(() => window.lastFrame) > frames, "late frames do come");
    assert.equal(await picture(page), finished);
  }, { script: late });
});

test("an address brings back the view, and a frame shows nothing else", async () => {
  const path = write("address", 0, "a15", "sigma");
  let address;
  const state = (page) => page.evaluate(() => [...document.querySelectorAll(".view [name]")].map((node) => node.value).join());
  // The picture in 32 times 32 places: an address has four digits of each number.
  const smallPicture = async (page) => {
    await settled(page);
    return page.locator("canvas").evaluate((node) => {
      const small = new OffscreenCanvas(32, 32).getContext("2d");
      small.drawImage(node, 0, 0, 32, 32);
      return [...small.getImageData(0, 0, 32, 32).data];
    });
  };
  let controls, image;
  await visit(browser, path, async (page) => {
    await chooseTiling(page, 1);
    await settled(page);
    await setControl(page, "cut", "60");
    await setControl(page, "axis", "2");
    await setControl(page, "colour", "type");
    await page.locator("canvas").focus();
    for (const key of ["ArrowLeft", "ArrowUp", "+"]) await page.keyboard.press(key);
    image = await smallPicture(page);
    controls = await state(page);
    address = await addressOf(page);
    assert.match(address, /^#view=1;/);
    await openShare(page);
    await page.getByRole("button", { name: "Embed" }).click();
    await expect(page.locator(".offered input")).toHaveValue(/^<iframe src="file:[^"]*#view=1;[^"]*;embed" title="sigma"/);
  });
  await visit(browser, path, async (page) => {
    await ready(page);
    await expect(page.locator("article:visible h2")).toHaveText("sigma");
    await expect.poll(() => state(page)).toBe(controls);
    const again = await smallPicture(page);
    assert.ok(again.every((x, k) => Math.abs(x - image[k]) < 24), "the same picture");
    assert.ok(new Set(again).size > 20, "which is not empty");
  }, { hash: address });
  await visit(browser, path, async (page) => {
    await ready(page);
    await page.locator("canvas").waitFor({ state: "visible" });
    for (const hidden of ["header.top", "footer", ".claim >> nth=1", ".controls"]) await page.locator(hidden).waitFor({ state: "hidden" });
  }, { hash: `${address};embed` });
  // Parts that are unknown or no numbers change nothing.
  await visit(browser, path, (page) => ready(page), { hash: "#view=7;zoom:x;turn:1,2;cells:99;nonsense:1" });
});

test("a number that somebody changed in the page is marked", async () => {
  const path = write("forged", 0, "sigma"), html = readFileSync(path, "utf8");
  const forged = html.replace("arccos(1/5) = 78.4630", "arccos(1/5) = 77.4630").replace(">172</span> tetrahedra", ">173</span> tetrahedra");
  assert.notEqual(forged, html);
  writeFileSync(path, forged);
  await visit(browser, path, async (page) => {
    await page.getByRole("button", { name: "Verify in this browser" }).click();
    await page.locator(".verdict.bad").waitFor();
    await expect(page.locator("mark.differs")).toHaveText(["All dihedral angles are at most arccos(1/5) = 77.4630... degrees, attained.", "173"]);
    await expect(page.locator(".verdict[role=status]")).toHaveText(/This page says 2 things differently/);
    await noViolations(page);
  });
});

test("untouched pages say what is verified", async () => {
  const names = ["sigma", "slab", "square-8", "regular", "icosahedral", "goldberg-3", "cube-corner", "square-prism"];
  await visit(browser, write("all", 0, ...names), async (page) => {
    for (const index of names.keys()) {
      await chooseTiling(page, index);
      const article = page.locator(`#tiling-${index}`);
      await article.getByRole("button", { name: "Verify in this browser" }).click();
      await expect(article.locator(".verdict[role=status]"), names[index]).toHaveText(/agree with what is verified/);
    }
  });
});

// A false maximum, and a corner of a family that is one cell too high.
const FALSE = [["sigma", '"maximum",1,[[1,0],25]]', '"maximum",1,[[4,0],25]]', "angle-bound"], ["a15-all", "[3,-1,-1,-1]", "[3,-1,-1,0]", "not-acute"]];
for (const [name, right, wrong, code] of FALSE) test(`a certificate of ${name} that the kernel refuses has a page that says so`, async () => {
  const file = join(directory, "false.json"), certificate = readFileSync(new URL(`../../certificates/${name}.json`, import.meta.url), "utf8");
  writeFileSync(file, certificate.replace(right, wrong));
  const path = write("refused", 1, file);
  assert.ok(!readFileSync(path, "utf8").includes("confirmed by the kernel"));
  await visit(browser, path, async (page) => {
    await ready(page);
    await expect(page.locator(".claim h3").first()).toHaveText("Not proved");
    await expect(page.locator(".claim .verdict").first()).toHaveText(new RegExp(`rejected \\[${code}\\] simplex 0`));
    await page.getByRole("button", { name: "Verify in this browser" }).click();
    await expect(page.locator(".verdict[role=status].bad")).toHaveText(new RegExp(`^Not verified: rejected \\[${code}\\]`));
    await noViolations(page);
  });
});

test("the foam of A15: dodecahedra and cells with 14 faces fill the cell", async () => {
  await visit(browser, write("foam", 0, "a15"), async (page) => {
    await ready(page);
    await setControl(page, "shape", "foam");
    await settled(page);
    // D. Weaire, R. Phelan 1994: two cells with 12 faces and six with 14 in the cube of A15.
    await expect(page.locator(".legend li")).toHaveText(["12 faces: 2 in a cell", "14 faces: 6 in a cell"]);
    await openShare(page);
    const stl = pointsOfStl((await saved(page, () => page.getByRole("button", { name: "Solid, STL" }).click())).bytes);
    assert.ok(Math.abs(enclosed(stl) / 6 - 1) < 1e-5, "their volumes add up to that of the cube");
    await setControl(page, "chosen", "0");
    await expect(page.locator(".picked h3")).toHaveText("Foam cell of vertex 0");
    await expect(page.locator(".picked")).toHaveText(/1[24] faces/);
    await noViolations(page);
  });
});
