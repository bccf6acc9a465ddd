// What the tests of pages share: the program, the browser, a page that is opened, accessibility.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

export const ROOT = fileURLToPath(new URL("../../", import.meta.url));
const first = (paths) => paths.find((path) => path && existsSync(path));
const ACUTILE = first([process.env.ACUTILE, join(ROOT, "target/release/acutile"), join(ROOT, "target/debug/acutile")]);
const CHROMIUM = first([process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"]);
const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
export const directory = mkdtempSync(join(tmpdir(), "acutile-pages-"));

export const launch = () => chromium.launch({ executablePath: CHROMIUM, args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"] });

// Runs the program, which ends with this status.
export function run(status, ...words) {
  const answer = spawnSync(ACUTILE, words, { encoding: "utf8", maxBuffer: 1 << 28 });
  assert.equal(answer.status, status, answer.stderr);
  return answer;
}

// Writes the page of these inputs.
export function write(name, status, ...inputs) {
  const path = join(directory, `${name}.html`);
  run(status, "report", ...inputs, "-o", path);
  return path;
}

// Opens a page; nothing is loaded from a network, and no error occurs. `script` runs before the page's own.
export async function visit(browser, path, use, { script, hash = "", ...options } = {}) {
  const session = await browser.newContext({ viewport: { width: 1200, height: 900 }, acceptDownloads: true, bypassCSP: true, ...options });
  if (script) await session.addInitScript(script);
  const page = await session.newPage();
  // A busy machine draws for some time.
  page.setDefaultTimeout(120000);
  const errors = [], requests = [];
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("request", (request) => requests.push(request.url()));
  await page.goto(pathToFileURL(path).href + hash);
  await use(page);
  assert.deepEqual(errors, []);
  assert.deepEqual(requests.filter((url) => !/^(file|blob|data):/.test(url)), [], "nothing comes from a network");
  await session.close();
}

export async function noViolations(page) {
  await page.evaluate(AXE);
  const { violations } = await page.evaluate(() => axe.run());
  assert.deepEqual(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html.slice(0, 160))]), []);
}

// The view has its first triangles.
export const ready = (page) => page.locator(".stage.live .legend li").first().waitFor();

// Nothing moves any more, and the picture is drawn with outlines and shadows.
export const settled = (page) => page.locator(".stage.live canvas[data-rested]").waitFor({ timeout: 60000 });

export async function fitsInWidth(page) {
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.ok(overflow <= 0, `${page.url()} is ${overflow} pixels too wide`);
}

export async function screenshot(page, name) {
  if (!process.env.SCREENSHOTS) return;
  mkdirSync(process.env.SCREENSHOTS, { recursive: true });
  await page.screenshot({ path: join(process.env.SCREENSHOTS, `${name}.png`), fullPage: true });
}

export async function saved(page, click) {
  const [file] = await Promise.all([page.waitForEvent("download"), click()]);
  return { name: file.suggestedFilename(), bytes: readFileSync(await file.path()) };
}

export const setControl = (page, name, value) => page.locator(`[name=${name}]`).evaluate((node, value) => {
  node.value = value;
  node.dispatchEvent(new Event("input", { bubbles: true }));
}, value);
