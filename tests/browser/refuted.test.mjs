// Pages of refuted tilings: the list of defects and the picture find each other, and no reader is shut out.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const ROOT = fileURLToPath(new URL("../../", import.meta.url));
const ACUTILE = process.env.ACUTILE ?? join(ROOT, "target/release/acutile");
const CHROMIUM = process.env.CHROMIUM ?? "/usr/bin/chromium";
const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const directory = mkdtempSync(join(tmpdir(), "acutile-refuted-"));
let browser;
before(async () => {
  browser = await chromium.launch({ executablePath: CHROMIUM, args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"] });
});
after(() => browser?.close());

function write(command, name, status, ...inputs) {
  const path = join(directory, `${name}.html`), option = command === "report" ? "-o" : "--report";
  const answer = spawnSync(ACUTILE, [command, ...inputs, option, path], { encoding: "utf8" });
  assert.equal(answer.status, status, answer.stderr);
  return path;
}

async function visit(path, use, viewport = { width: 1280, height: 900 }) {
  const session = await browser.newContext({ viewport, bypassCSP: true, isMobile: viewport.width < 500, hasTouch: viewport.width < 500 });
  const page = await session.newPage(), errors = [];
  page.on("pageerror", (error) => errors.push(error.message));
  await page.goto(pathToFileURL(path).href);
  await use(page);
  assert.deepEqual(errors, []);
  await session.close();
}

async function noViolations(page) {
  await page.evaluate(AXE);
  const { violations } = await page.evaluate(() => axe.run());
  assert.deepEqual(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html.slice(0, 120))]), []);
}

const mesh = (name) => join(ROOT, "tests/meshes/cases", name);

test("a defect in the list moves the picture, and a click in the picture finds the defect", async () => {
  await visit(write("report", "overlap", 1, mesh("random_tets.msh")), async (page) => {
    assert.equal(await page.locator("[data-defect]").count(), 6);
    const picture = async () => { await page.waitForTimeout(200); return (await page.locator("canvas").screenshot()).toString("base64"); };
    const whole = await picture();
    await page.locator('[data-defect="3"]').click();
    assert.equal(await page.locator("[data-defect][aria-current]").getAttribute("data-defect"), "3");
    assert.notEqual(await picture(), whole);
    await page.getByRole("button", { name: "All defects" }).click();
    assert.equal(await page.locator("[data-defect][aria-current]").count(), 0);
    assert.equal(await picture(), whole);
    const box = await page.locator("canvas").boundingBox();
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    const heading = await page.locator(".picked h3").textContent();
    const chosen = await page.locator("[data-defect][aria-current]").textContent();
    assert.ok(chosen.includes(heading.toLowerCase()), `${chosen} has ${heading}`);
    await noViolations(page);
  });
});

for (const width of [1280, 390]) {
  test(`no violations at ${width} pixels, and nothing sticks out`, async () => {
    const path = write("certify", `mixed-${width}`, 1, mesh("folded.msh"), "bcc", mesh("three_on_a_facet.msh"));
    await visit(path, async (page) => {
      assert.equal(await page.locator("article").count(), 3);
      for (const index of [0, 1, 2]) {
        await page.locator(`.chooser a[href="#tiling-${index}"]`).click();
        await page.waitForTimeout(200);
        await noViolations(page);
        const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
        assert.ok(overflow <= 0, `${overflow} pixels too wide`);
      }
    }, { width, height: 844 });
  });
}
