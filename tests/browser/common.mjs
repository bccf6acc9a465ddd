// What the tests of pages share: the program, the browser, a page that is opened, accessibility.
// ACUTILE is the program (default: target/release or target/debug), CHROMIUM the browser, SCREENSHOTS a folder for pictures.
// SLOW=10 makes pages ten times slower, to find tests and pages that count on a machine without other work.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chromium, expect as patient } from "@playwright/test";

export const ROOT = fileURLToPath(new URL("../../", import.meta.url));
const first = (paths) => paths.find((path) => path && existsSync(path));
const ACUTILE = first([process.env.ACUTILE, join(ROOT, "target/release/acutile"), join(ROOT, "target/debug/acutile")]);
const CHROMIUM = first([process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"]);
const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
export const directory = mkdtempSync(join(tmpdir(), "acutile-pages-"));

// Milliseconds. A busy machine takes its time, so nothing is read only once after an action: `expect` waits until a page shows it.
const PATIENCE = 120000;
export const expect = patient.configure({ timeout: PATIENCE });

// Graphics in software, so that a machine without a graphics card draws, too.
const SOFTWARE = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
export const launch = (graphics = SOFTWARE) => chromium.launch({ executablePath: CHROMIUM, args: ["--no-sandbox", ...graphics], timeout: PATIENCE });

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

// What chromium says of its graphics in software.
const OF_GRAPHICS = /GPU stall|GL Driver Message|Automatic fallback to software/;

// Opens a page; it complains of nothing and loads nothing: a page of the site loads its own files.
// `script` runs before the page's own. Graphics in software take most of the time, so that a pixel of the screen is four of the page.
export async function visit(browser, path, use, { script, hash = "", ofSite = false, ...options } = {}) {
  const session = await browser.newContext({ viewport: { width: 1200, height: 900 }, deviceScaleFactor: process.env.SCREENSHOTS ? 1 : 0.5, acceptDownloads: true, bypassCSP: true, ...options });
  if (script) await session.addInitScript(script);
  const page = await session.newPage();
  page.setDefaultTimeout(PATIENCE);
  if (process.env.SLOW) await (await session.newCDPSession(page)).send("Emulation.setCPUThrottlingRate", { rate: Number(process.env.SLOW) });
  const complaints = [], requests = [], url = pathToFileURL(path).href;
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && complaints.push(`${message.text()} ${message.location().url}`));
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("dialog", (dialog) => { complaints.push(`dialog: ${dialog.message()}`); dialog.dismiss(); });
  page.on("request", (request) => requests.push(request.url()));
  await page.goto(url + hash);
  await use(page);
  assert.deepEqual(complaints.filter((text) => !OF_GRAPHICS.test(text)), [], "nothing complains");
  const loaded = requests.filter((other) => other.split("#")[0] !== url && !(ofSite ? /^(file|blob|data):/ : /^(blob|data):/).test(other));
  assert.deepEqual(loaded, [], "nothing is loaded");
  await session.close();
}

// No violations of the rules of accessibility in the page, or in the elements of a selector.
export async function noViolations(page, within) {
  if (!await page.evaluate(() => "axe" in window)) await page.evaluate(AXE);
  const { violations } = await page.evaluate((within) => axe.run(within ?? document, { preload: false, resultTypes: ["violations"] }), within);
  assert.deepEqual(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html.slice(0, 160))]), [], page.url());
}

// The view has its first triangles.
export const ready = (page) => page.locator(".stage.live .legend li").first().waitFor();

// Chooses a tiling on a page of several, and waits for the view to go there.
export async function chooseTiling(page, index) {
  await page.locator(`.chooser a[href="#tiling-${index}"]`).click();
  await page.locator(`#tiling-${index} .stage.live`).waitFor({ state: "attached" });
}

// Nothing moves any more, and the picture is drawn with outlines and shadows.
export const settled = (page) => page.locator(".stage.live canvas[data-rested]").waitFor();

// The view when nothing moves any more, read in the same moment.
export async function picture(page) {
  const resting = await page.waitForFunction(() => document.querySelector(".stage.live canvas[data-rested]")?.toDataURL(), null, { polling: 50 });
  return resting.jsonValue();
}

// The address, which the page writes when nothing moves any more.
export async function addressOf(page) {
  await settled(page);
  return page.evaluate(() => location.hash);
}

// The picture as soon as it is none of these; fails where it stays.
export async function otherPicture(page, seen, what) {
  let now;
  await expect.poll(async () => seen.includes(now = await picture(page)), { message: `${what} changes the picture` }).toBe(false);
  return now;
}

export async function fitsInWidth(page) {
  const overflow = () => page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  await expect.poll(overflow, { message: `${page.url()}: pixels that it is too wide` }).toBeLessThanOrEqual(0);
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
