// Opens report pages in headless Chromium and uses them as a reader does.
// ACUTILE is the program (default: target/release or target/debug), CHROMIUM the browser, SCREENSHOTS a folder for pictures.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { directory, expect, fitsInWidth, launch, otherPicture, picture, ROOT, saved, screenshot, setControl as set, visit as open, write as writePage } from "./common.mjs";
import { Tiling } from "./geometry.mjs";

let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());

const write = (name, ...inputs) => writePage(name, 0, ...inputs);

// Opens a page under its own security policy, and waits for the view where there is one.
const visit = (path, use, { from = browser, ...options } = {}) => open(from, path, async (page) => {
  await page.locator(".stage.live .legend li, html.still, html:not(.js)").first().waitFor({ state: "attached" });
  await use(page);
}, { bypassCSP: false, ...options });

async function drag(page, dx, dy) {
  const box = await page.locator("canvas").boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + dx, box.y + box.height / 2 + dy, { steps: 4 });
  await page.mouse.up();
}

// The text of every cell of a table of the chosen simplex.
const rows = (page, caption) => page.locator(`.picked table:has(caption:text-is("${caption}")) tbody tr`)
  .evaluateAll((rows) => rows.map((row) => [...row.cells].map((cell) => cell.querySelector("math")?.getAttribute("alttext") ?? cell.textContent)));

// Compares what is shown of simplex `index` with the certificate.
async function compare(page, tiling, index) {
  await set(page, "chosen", String(index));
  const space = tiling.dimension === 3;
  await expect(page.locator(".picked h3")).toHaveText(new RegExp(`^(Tetrahedron|Triangle) ${index}$`));
  const corners = await rows(page, "Corners");
  corners.forEach(([, , , coordinates], i) => {
    const exact = tiling.corner(tiling.witness.simplices[index][i]);
    const shown = coordinates.slice(1, -1).split(", ").map((text) => tiling.field.parse(text));
    assert.ok(exact.every((x, k) => tiling.field.equal(x, shown[k])), `corner ${i} of simplex ${index}`);
  });
  const edges = await rows(page, space ? "Edges and the dihedral angles at them" : "Sides and the angles opposite to them");
  assert.equal(edges.length, space ? 6 : 3);
  for (const [name, square, cosine, decimal, degrees] of edges) {
    const [a, b] = [...name].map((letter) => "ABCD".indexOf(letter));
    const others = [0, 1, 2, 3].slice(0, tiling.dimension + 1).filter((k) => k !== a && k !== b);
    assert.ok(tiling.field.equal(tiling.squaredLength(index, a, b), tiling.field.parse(square)), `edge ${name} of ${index}: ${square}`);
    const angle = space ? tiling.dihedral(index, a, b, ...others) : tiling.planeAngle(index, others[0], a, b);
    assert.ok(tiling.isCosine(cosine, angle), `angle at ${name} of ${index}: ${cosine}`);
    assert.ok(!tiling.isCosine(cosine.startsWith("-") ? "√(1/97)" : `-${cosine === "0" ? "√(1/97)" : cosine}`, angle), "not of the other sign");
    const value = tiling.field.double(angle.n) / Math.sqrt(tiling.field.double(angle.d));
    assert.ok(Math.abs(parseFloat(decimal) - value) < 1e-5, `${decimal} is about ${value}`);
    assert.ok(Math.abs(parseFloat(degrees) - Math.acos(value) * 180 / Math.PI) < 1e-3, `${degrees} is about that angle`);
  }
}

const SHOWN = { sigma: 172, a15: 46, slab: 56, "square-8": 8 };
for (const [name, simplices] of Object.entries(SHOWN)) {
  test(`${name}: the view, exact data, verification`, async () => {
    const certificate = readFileSync(join(ROOT, "certificates", `${name}.json`), "utf8");
    const tiling = new Tiling(certificate);
    assert.equal(tiling.witness.simplices.length, simplices);
    await visit(write(name, name), async (page) => {
      const seen = [await picture(page)];
      const look = async (what) => {
        seen.push(await otherPicture(page, seen, what));
      };
      await drag(page, 90, 40);
      await look("dragging");
      await set(page, "explode", "70");
      await look("exploding");
      const axis = page.locator("[name=axis]");
      await axis.waitFor({ state: "hidden" });
      await set(page, "cut", "55");
      await axis.waitFor({ state: "visible" });
      await look("cutting");
      await set(page, "axis", "1");
      await look("another axis");
      await set(page, "cut", "100");
      await axis.waitFor({ state: "hidden" });
      await set(page, "explode", "0");
      for (const colour of name === "a15" ? ["type"] : ["angle", "type"]) {
        await set(page, "colour", colour);
        await look(`colour by ${colour}`);
      }
      if (name !== "square-8") {
        await set(page, "cells", "2");
        await look("more cells");
        await set(page, "cells", "1");
      }
      for (const index of [0, 1, Math.floor(simplices / 2), simplices - 1]) await compare(page, tiling, index);
      await screenshot(page, name);

      const file = await saved(page, () => page.getByRole("button", { name: "Download certificate" }).click());
      assert.equal(file.bytes.toString(), certificate, "the certificate is that of the catalogue");
      const text = (await saved(page, () => page.getByRole("button", { name: "Mesh, VTK" }).click())).bytes.toString();
      assert.match(text, new RegExp(`CELLS ${simplices} `));
      const points = Number(/POINTS (\d+) /.exec(text)[1]);
      const indices = text.split("\n").filter((line) => new RegExp(`^${tiling.dimension + 1}( \\d+){${tiling.dimension + 1}}$`).test(line));
      assert.equal(indices.length, simplices);
      assert.ok(indices.every((line) => line.split(" ").slice(1).every((k) => Number(k) < points)));

      await page.getByRole("button", { name: "Verify in this browser" }).click();
      const verdict = page.locator(".verdict.good, .verdict.bad");
      await verdict.waitFor();
      const words = await verdict.textContent();
      assert.match(words, /^Verified in this browser in \d/, words);
      assert.match(words, new RegExp(`${simplices} simplices`));
      console.log(`${name}: ${words.slice(0, 45)}, ${readFileSync(join(directory, `${name}.html`)).length} bytes`);
    });
  });
}

test("a click chooses what is under it", async () => {
  await visit(write("click", "cube-corner"), async (page) => {
    const box = await page.locator("canvas").boundingBox();
    await page.mouse.click(box.x + 5, box.y + 5);
    await page.locator(".picked").waitFor({ state: "hidden" });
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    await expect(page.locator(".picked h3")).toHaveText("Tetrahedron 0");
    // The corner of a cube: three right angles at its edges, three of cosine √(1/3) at the others.
    const cosines = (await rows(page, "Edges and the dihedral angles at them")).map((row) => row[2]).sort();
    assert.deepEqual(cosines, ["0", "0", "0", "√(1/3)", "√(1/3)", "√(1/3)"]);
  });
});

test("a changed certificate is not verified", async () => {
  const path = write("changed", "a15");
  const html = readFileSync(path, "utf8");
  const element = /(<script type="application\/json" id="data">)(.*?)(<\/script>)/s;
  const data = JSON.parse(element.exec(html)[2]);
  const certificate = data.tilings[0].certificate, start = certificate.indexOf('"witness"');
  data.tilings[0].certificate = certificate.slice(0, start) + certificate.slice(start).replace(/\[2,1,1\]/, "[2,1,2]");
  assert.notEqual(data.tilings[0].certificate, certificate);
  writeFileSync(path, html.replace(element, (_, head, __, end) => head + JSON.stringify(data).replaceAll("<", "\\u003c") + end));
  await visit(path, async (page) => {
    await page.getByRole("button", { name: "Verify in this browser" }).click();
    await expect(page.locator(".verdict.good, .verdict.bad")).toHaveText(/^Not verified: rejected \[[a-z-]+\] /);
  });
});

test("without workers the check runs in the page itself", async () => {
  await visit(write("alone", "bcc"), async (page) => {
    await page.getByRole("button", { name: "Verify in this browser" }).click();
    await page.locator(".verdict.good").waitFor();
  }, { script: "delete window.Worker" });
});

test("keyboard", async () => {
  await visit(write("keys", "a15"), async (page) => {
    for (let k = 0; k < 20 && (await page.evaluate(() => document.activeElement.tagName)) !== "CANVAS"; k++) await page.keyboard.press("Tab");
    await expect(page.locator("canvas"), "Tab reaches the view").toBeFocused();
    let last = await picture(page);
    for (const key of ["ArrowLeft", "ArrowDown", "+", "-", "0", "n"]) {
      await page.keyboard.press(key);
      last = await otherPicture(page, [last], key);
    }
    await expect(page.locator(".picked h3")).toHaveText("Tetrahedron 0");
    await page.keyboard.press("p");
    await expect(page.locator(".picked h3")).toHaveText("Tetrahedron 45");
    await page.keyboard.press("Escape");
    await page.locator(".picked").waitFor({ state: "hidden" });
    await page.getByRole("button", { name: "Verify in this browser" }).focus();
    await page.keyboard.press("Enter");
    await page.locator(".verdict.good").waitFor();
  });
});

test("everything that is used has a name", async () => {
  await visit(write("names", "a15", "square-8"), async (page) => {
    const nameless = await page.evaluate(() => [...document.querySelectorAll("button, input, select, canvas, a, svg[role=img], [role=region]")]
      .filter((node) => !(node.ariaLabel || node.textContent.trim() || node.labels?.[0]?.textContent.trim())).map((node) => node.outerHTML.slice(0, 80)));
    assert.deepEqual(nameless, []);
    assert.equal(await page.locator("html").getAttribute("lang"), "en");
  });
});

test("light and dark", async () => {
  const path = write("dark", "a15");
  const brightness = (page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).slice(0, 3).reduce((s, x) => s + Number(x), 0) / 3);
  const isDark = (page) => expect.poll(() => brightness(page)).toBeLessThan(60);
  const isLight = (page) => expect.poll(() => brightness(page)).toBeGreaterThan(200);
  await visit(path, async (page) => {
    await isDark(page);
    await screenshot(page, "dark");
    await page.getByRole("button", { name: /light and dark/ }).click();
    await isLight(page);
  }, { colorScheme: "dark" });
  await visit(path, async (page) => {
    await isLight(page);
    await page.getByRole("button", { name: /light and dark/ }).click();
    await isDark(page);
  });
});

for (const width of [320, 390]) {
  test(`a phone, ${width} pixels wide`, async () => {
    await visit(write(`phone-${width}`, "sigma", "slab"), async (page) => {
      await set(page, "chosen", "5");
      await fitsInWidth(page);
      // The sheet with the exact data covers the lower part of the screen.
      await page.locator("canvas").evaluate((node) => node.scrollIntoView({ block: "start" }));
      const before = await picture(page);
      await drag(page, 60, 0);
      await otherPicture(page, [before], "dragging");
      await screenshot(page, `phone-${width}`);
    }, { viewport: { width, height: 800 }, isMobile: true, hasTouch: true, ...(width === 390 ? { deviceScaleFactor: 2 } : {}) });
  });
}

test("print", async () => {
  await visit(write("print", "a15"), async (page) => {
    await page.locator("canvas").waitFor();
    const pdf = await page.pdf({ format: "A4" });
    assert.equal(pdf.subarray(0, 5).toString(), "%PDF-");
    const pages = pdf.toString("latin1").match(/\/Type \/Page\b/g).length;
    assert.ok(pages >= 1 && pages <= 6, `${pages} pages`);
    if (process.env.SCREENSHOTS) writeFileSync(join(process.env.SCREENSHOTS, "print.pdf"), pdf);
    await page.emulateMedia({ media: "print" });
    await page.locator(".controls").waitFor({ state: "hidden" });
    await page.locator("canvas").waitFor({ state: "visible" });
  }, { colorScheme: "dark" });
});

test("without JavaScript there are picture, text and tables", async () => {
  await visit(write("still", "a15", "slab"), async (page) => {
    await expect(page.locator("article")).toHaveCount(2);
    for (const what of ["svg.picture >> nth=1", "svg.histogram >> nth=1", "text=All dihedral angles are acute. >> nth=1", "table >> nth=1"]) {
      await page.locator(what).waitFor({ state: "visible" });
    }
    await expect(page.locator("button:visible")).toHaveCount(0);
    await page.locator("text=Without JavaScript").waitFor({ state: "visible" });
    await screenshot(page, "still");
  }, { javaScriptEnabled: false });
});

test("without WebGL there is a still picture, and the check runs", async () => {
  const plain = await launch(["--disable-3d-apis"]);
  await visit(write("flat", "a15"), async (page) => {
    await page.locator("text=This browser cannot show the view that turns").waitFor({ state: "visible" });
    await page.locator("svg.picture").waitFor({ state: "visible" });
    await page.getByRole("button", { name: "Verify in this browser" }).click();
    await page.locator(".verdict.good").waitFor();
  }, { from: plain });
  await plain.close();
});

test("several tilings on a page", async () => {
  await visit(write("several", "sigma", "equilateral", "two-corners"), async (page) => {
    const shown = page.locator("article:visible h2");
    await expect(shown).toHaveText("sigma");
    const before = await picture(page);
    await page.getByRole("link", { name: "equilateral" }).click();
    await expect(shown).toHaveText("equilateral");
    await otherPicture(page, [before], "another tiling");
    await compare(page, new Tiling(readFileSync(join(ROOT, "certificates/equilateral.json"), "utf8")), 1);
    await page.goBack();
    await expect(shown).toHaveText("sigma");
  });
});

test("a hostile name is text", async () => {
  const name = `</script><script>alert(1)</script><img src=x onerror=alert(2)>"'{{data}}`;
  const file = join(directory, "hostile.json");
  writeFileSync(file, JSON.stringify({
    format: "acutile-tiling", version: 1, name, description: "<!--<svg onload=alert(3)> ]]>", dimension: 2,
    lattice: { vectors: [[1, 0], ["1/2", "sqrt(3)/2"]] }, vertices: [[0, 0]],
    simplices: [[0, [0, 1, 0], [0, 0, 1]], [[0, 1, 0], [0, 1, 1], [0, 0, 1]]],
  }));
  await visit(write("hostile", file), async (page) => {
    await expect(page.locator(".description")).toContainText(name);
    await expect(page.locator("article img, article script, svg[onload]")).toHaveCount(0);
    await set(page, "chosen", "0");
    await expect(page.locator(".picked h3")).toHaveText("Triangle 0");
  });
});
