// The site of the catalogue: search, filters, sorting, neighbours, the page that verifies what is dropped; every kind of page without violations.

import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { directory, expect, fitsInWidth, launch, noViolations, ROOT, run, screenshot, settled, visit as open } from "./common.mjs";

const site = join(directory, "site");
let browser;
before(async () => {
  run(0, "gallery", "-o", site);
  browser = await launch();
});
after(() => browser?.close());

// A page of the site, which loads other files of it.
const visit = (path, use, options) => open(browser, path, use, { ofSite: true, ...options });

test("search and filters", async () => {
  await visit(join(site, "index.html"), async (page) => {
    const cards = page.locator(".cards li:visible b"), shown = () => cards.allTextContents();
    const all = (await shown()).length;
    assert.ok(all > 30);
    await page.getByLabel("Search").fill("sommerville");
    await expect.poll(async () => (await shown()).filter((name) => !/^(sommerville-\d|bcc)$/.test(name))).toEqual([]);
    await expect(page.locator("output")).toHaveText(`${(await shown()).length} tilings`);
    await page.getByLabel("Search").fill("");
    await page.getByLabel("TCP").check();
    await expect.poll(async () => (await shown()).includes("sigma") && !(await shown()).includes("bcc")).toBe(true);
    await expect(page.locator(".group:visible")).toHaveCount(1);
    await page.getByLabel("TCP").uncheck();
    await expect(cards).toHaveCount(all);
  });
});

test("a click on a heading sorts, a second one the other way", async () => {
  await visit(join(site, "index.html"), async (page) => {
    const heading = page.locator(".figures th").nth(3), numbers = async () => (await page.locator(".figures tbody tr").evaluateAll((rows) => rows.map((row) => parseFloat(row.cells[3].textContent)))).filter((x) => !Number.isNaN(x));
    const before = (await numbers()).toSorted((a, b) => a - b);
    assert.ok(new Set(before).size > 5);
    await heading.getByRole("button").click();
    await expect.poll(numbers).toEqual(before);
    await expect(heading).toHaveAttribute("aria-sort", "ascending");
    await heading.getByRole("button").click();
    await expect.poll(numbers).toEqual(before.toReversed());
    assert.ok(await page.locator(".figures svg.spark").count() > 30);
  });
});

test("a tiling leads to its neighbours", async () => {
  await visit(join(site, "tilings/sigma.html"), async (page) => {
    await page.locator(".links a").last().click();
    await expect(page.locator("article h2")).not.toHaveText("sigma");
    await page.locator(".links a", { hasText: "sigma" }).click();
    await expect(page.locator("article h2")).toHaveText("sigma");
  });
});

// Drops files on the page as a browser does.
const dropFiles = (page, files) => page.evaluate((files) => {
  const data = new DataTransfer();
  for (const [name, content] of files) data.items.add(new File([typeof content === "string" ? content : Uint8Array.from(content)], name));
  window.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
}, files);

test("families and systems of patches have pages", async () => {
  await visit(join(site, "theorems.html"), async (page) => {
    const names = await page.locator(".theorem h2 a").allTextContents();
    assert.equal(names.length, 12);
    await page.getByRole("link", { name: "c14-all" }).click();
    await settled(page);
    await expect(page.locator(".choice input[type=range]")).toHaveCount(3);
    await page.getByRole("link", { name: "All tilings" }).click();
    await expect(page.locator("h1.title")).toHaveText("Families");
  });
});

test("the proof has formulas in MathML", async () => {
  await visit(join(site, "docs/soundness.html"), async (page) => {
    const formulas = await page.locator("math").evaluateAll((nodes) => nodes.map((node) => node.getAttribute("alttext")));
    assert.ok(formulas.includes("det S_j > 0") || formulas.includes("s_f h_f > 0"), formulas.slice(0, 40).join(" | "));
    // Hardly an underscore is left beside a letter in the running text.
    const text = await page.locator(".document p").evaluateAll((nodes) => nodes.map((node) => {
      const copy = node.cloneNode(true);
      copy.querySelectorAll("math, code").forEach((inner) => inner.remove());
      return copy.textContent;
    }).join("\n"));
    const left = text.match(/\S*[A-Za-z]_\S+/g) ?? [];
    assert.ok(left.length * 50 < formulas.length, left.join(" "));
  });
});

test("certificates in CBOR are verified, too", async () => {
  const cbor = (name) => {
    const file = join(directory, `${name}.cbor`);
    run(0, "convert", join(ROOT, `certificates/${name}.json`), file);
    return [...readFileSync(file)];
  };
  const names = ["sigma", "square-14", "slab", "cube-5", "a15-all", "kagome-all"], files = names.map((name) => [`${name}.cbor`, cbor(name)]);
  const sigma = files[0][1];
  // 24 and 25 bytes: the version 2 as an integer of one byte, in two.
  const version = sigma.indexOf(2, 10);
  const wrong = [["short.cbor", sigma.slice(0, 500)], ["long.cbor", [...sigma, 0]], ["padded.cbor", [...sigma.slice(0, version), 0x18, ...sigma.slice(version)]], ["float.cbor", [0x85, 0xf9, 0, 0]]];
  await visit(join(site, "verify.html"), async (page) => {
    await dropFiles(page, [...files, ...wrong]);
    await expect(page.locator(".results .good, .results .bad")).toHaveCount(files.length + wrong.length);
    const answers = Object.fromEntries(await page.locator(".results section").evaluateAll((boxes) => boxes.map((box) => [box.querySelector("h2").textContent, box.textContent.slice(box.querySelector("h2").textContent.length)])));
    for (const name of names) {
      const sha256 = createHash("sha256").update(readFileSync(join(directory, `${name}.cbor`))).digest("hex");
      assert.match(answers[`${name}.cbor`], new RegExp(`^Verified in .*SHA-256 ${sha256}$`));
    }
    assert.match(answers["short.cbor"], /^Not verified: malformed \[cbor\]/);
    assert.match(answers["long.cbor"], /^Not verified: malformed \[cbor\]/);
    assert.match(answers["padded.cbor"], /^Not verified: malformed \[canonical\]/);
    assert.match(answers["float.cbor"], /^Not verified: malformed \[cbor\]/);
  });
});

test("what is dropped is verified without a network", async () => {
  const sigma = readFileSync(join(ROOT, "certificates/sigma.json"), "utf8"), family = readFileSync(join(ROOT, "certificates/a15-all.json"), "utf8");
  const wrong = sigma.replace('"maximum",1,[[1,0],25]]', '"maximum",1,[[4,0],25]]');
  await visit(join(site, "verify.html"), async (page) => {
    await page.context().setOffline(true);
    await dropFiles(page, [["valid.json", sigma], ["family.json", family], ["false.json", wrong], ["malformed.json", sigma.slice(0, 900)], ["empty.json", ""], ["<b>.json", "{}"]]);
    await expect(page.locator(".results .good, .results .bad")).toHaveCount(6);
    const answers = Object.fromEntries(await page.locator(".results section").evaluateAll((boxes) => boxes.map((box) => [box.querySelector("h2").textContent, box.textContent.slice(box.querySelector("h2").textContent.length)])));
    assert.match(answers["valid.json"], /^Verified in .*30 vertices, 172 simplices.*three-space is tiled face to face by 172 tetrahedra/);
    assert.match(answers["family.json"], /^Verified in .*for every t in \(2\/5, 16\/5\)/);
    assert.match(answers["false.json"], /^Not verified: rejected \[angle-bound\]/);
    assert.match(answers["malformed.json"], /^Not verified: malformed \[json\]/);
    assert.match(answers["empty.json"], /^Not verified: malformed \[json\]/);
    assert.match(answers["<b>.json"], /^Not verified: malformed /);
    await noViolations(page);
  });
});

// Opens pages of the site one after the other, in one context: to make a context for each takes longer than to look at most pages.
async function visitEach(paths, width, use) {
  await visit(join(site, paths[0]), async (page) => {
    for (const path of paths) {
      await page.goto(pathToFileURL(join(site, path)).href);
      await use(page, path);
      await noViolations(page);
      await fitsInWidth(page);
    }
  }, { viewport: { width, height: 844 } });
}

test("every document fits on a telephone, and the keyboard reaches what scrolls", async () => {
  const documents = readdirSync(join(site, "docs")).filter((name) => name.endsWith(".html"));
  assert.ok(documents.length > 20);
  await visitEach(documents.map((name) => join("docs", name)), 390, async () => {});
});

const PAGES = ["index.html", "tilings/sigma.html", "tilings/square-8.html", "tilings/slab-all.html", "tilings/kagome-all.html", "theorems.html", "records.html",
  "verify.html", "paper.html"];
// The documents at 390 pixels are above.
for (const [width, paths] of [[1280, [...PAGES, "docs/index.html", "docs/soundness.html"]], [390, PAGES]]) {
  test(`pages of every kind at ${width} pixels`, async () => {
    await visitEach(paths, width, async (page, path) => {
      if (path.startsWith("tilings/")) await settled(page);
      await screenshot(page, `site-${path.replaceAll("/", "-")}-${width}`);
      if (path === "index.html" && width === 390) {
        const places = await page.locator(".cards li").evaluateAll((cards) => cards.slice(0, 2).map((card) => card.getBoundingClientRect().top));
        assert.equal(places[0], places[1], "two columns");
      }
    });
  });
}
