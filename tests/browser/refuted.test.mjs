// Pages of refuted tilings: the list of defects and the picture find each other, and no reader is shut out.

import { join } from "node:path";
import { after, before, test } from "node:test";
import { chooseTiling, directory, expect, fitsInWidth, launch, noViolations, otherPicture, picture, ROOT, run, settled, visit, write } from "./common.mjs";

let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());

const mesh = (name) => join(ROOT, "tests/meshes/cases", name);

test("a defect in the list moves the picture, and a click in the picture finds the defect", async () => {
  await visit(browser, write("overlap", 1, mesh("random_tets.msh")), async (page) => {
    await expect(page.locator("[data-defect]")).toHaveCount(6);
    const whole = await picture(page), chosen = page.locator("[data-defect][aria-current]");
    await page.locator('[data-defect="3"]').click();
    await expect(chosen).toHaveAttribute("data-defect", "3");
    await otherPicture(page, [whole], "a chosen defect");
    await page.getByRole("button", { name: "All defects" }).click();
    await expect(chosen).toHaveCount(0);
    await expect.poll(() => picture(page)).toBe(whole);
    const box = await page.locator("canvas").boundingBox();
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    await expect(chosen).toHaveCount(1);
    await expect(chosen).toContainText((await page.locator(".picked h3").textContent()).toLowerCase());
    await noViolations(page);
  });
});

test("single edges are seen on dark paper, and on light", async () => {
  // Pixels that are nearly white and hardly transparent: no defect is so light.
  const light = async (page) => {
    await settled(page);
    return page.locator("canvas").evaluate((canvas) => {
      const flat = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d");
      flat.drawImage(canvas, 0, 0);
      const { data } = flat.getImageData(0, 0, canvas.width, canvas.height);
      return Array.from({ length: data.length / 4 }, (_, k) => data.subarray(4 * k, 4 * k + 4)).filter((pixel) => Math.min(...pixel) > 180).length;
    });
  };
  await visit(browser, write("edges", 1, mesh("random_tets.msh")), async (page) => {
    await page.locator('[data-defect="0"]').click();
    await expect.poll(() => light(page)).toBeGreaterThan(20);
    await page.emulateMedia({ colorScheme: "light" });
    await expect.poll(() => light(page)).toBe(0);
    await page.getByRole("button", { name: /light and dark/ }).click();
    await expect.poll(() => light(page)).toBeGreaterThan(20);
  }, { colorScheme: "dark" });
});

let mixed;
for (const width of [1280, 390]) {
  test(`no violations at ${width} pixels, and nothing sticks out`, async () => {
    if (!mixed) run(1, "certify", mesh("folded.msh"), "bcc", mesh("three_on_a_facet.msh"), "--report", mixed = join(directory, "mixed.html"));
    await visit(browser, mixed, async (page) => {
      await expect(page.locator("article")).toHaveCount(3);
      for (const index of [0, 1, 2]) {
        await chooseTiling(page, index);
        await settled(page);
        await noViolations(page, index ? "article:not([hidden])" : undefined);
        await fitsInWidth(page);
      }
    }, { viewport: { width, height: 844 }, isMobile: width < 500, hasTouch: width < 500 });
  });
}
