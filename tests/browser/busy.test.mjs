// A reader who is quicker than a busy machine: what is put off does not come in the way of what the reader wants next.

import assert from "node:assert/strict";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { chooseTiling, expect, launch, ROOT, saved, setControl, settled, visit as open, write } from "./common.mjs";

let browser, path;
before(async () => {
  path = write("busy", 1, "kagome-all", "sigma", join(ROOT, "tests/meshes/cases/random_tets.msh"));
  browser = await launch();
});
after(() => browser?.close());

// From `hold("pauses")` to `release()` nothing happens that the page puts off until it is free, and after `hold("addresses")` it hears of
// no other address. The page looks at the clock after each 128 simplices, and pauses if it has worked for long: for a clock that leaps at
// every look it pauses each time.
const HOLD = `{
  const wait = window.setTimeout, listen = window.addEventListener, now = performance.now.bind(performance), held = {};
  let leap = 0;
  const later = (kind, act) => (held[kind] ? held[kind].push(act) : act());
  window.setTimeout = (act, time) => (time === undefined ? wait(() => later("pauses", act)) : wait(act, time));
  window.addEventListener = (type, act, ...rest) =>
    listen.call(window, type, type === "hashchange" ? (event) => later("addresses", () => act(event)) : act, ...rest);
  performance.now = () => now() + (leap += 1000);
  window.hold = (kind) => { held[kind] ??= []; };
  window.release = async () => {
    for (const kind of Object.keys(held)) {
      const acts = held[kind];
      delete held[kind];
      acts.forEach((act) => act());
    }
    // What comes late has come now.
    for (let k = 0; k < 50; k++) await new Promise((resolve) => { wait(resolve); });
  };
}`;
const visit = (use, { script = "", ...options } = {}) => open(browser, path, use, { script: HOLD + script, ...options });

// Does this while the page is busy.
async function meanwhile(page, act, kind = "pauses") {
  await page.evaluate((kind) => window.hold(kind), kind);
  await act();
  await page.evaluate(() => window.release());
}

const word = (page) => page.getByLabel(/^Word of z, \+, -/);
const shown = (page) => page.locator("canvas").getAttribute("aria-label").then((label) => /^View of ([^.]*)/.exec(label)[1]);
const solid = (page) => page.locator("[data-solid=stl]").evaluate((button) => button.click());
const stl = async (page) => (await saved(page, () => solid(page))).bytes;
// Asks for an address, and waits until the page has heard of it.
const goTo = (page, hash) => page.evaluate((hash) => new Promise((resolve) => {
  window.addEventListener("hashchange", resolve, { once: true });
  location.hash = hash;
}), hash);

test("a word that is still being laid does not take the place of another tiling", async () => {
  await visit(async (page) => {
    await settled(page);
    await meanwhile(page, async () => {
      await word(page).fill("++--");
      await page.locator('.chooser a[href="#tiling-1"]').click();
    });
    for (const [index, name] of [[1, "sigma"], [0, "kagome-all"], [1, "sigma"]]) {
      await chooseTiling(page, index);
      assert.equal(await shown(page), name);
    }
  });
});

test("a word that is no word stays as it is typed", async () => {
  await visit(async (page) => {
    await settled(page);
    await meanwhile(page, async () => {
      await word(page).fill("+");
      await word(page).fill("zx");
    });
    await expect(word(page)).toHaveValue("zx");
    await expect(page.locator(".values")).toHaveText(/^Expected a word/);
    await settled(page);
  });
});

test("the reader may go on in the picture before it is another one", async () => {
  await visit(async (page) => {
    await settled(page);
    await meanwhile(page, async () => {
      await word(page).fill("+");
      await page.locator("canvas").focus();
    });
    await expect(page.locator(".values")).toHaveText(/^34 tetrahedra/);
    await expect(page.locator("canvas")).toBeFocused();
  });
});

test("of two addresses the second one counts", async () => {
  await visit(async (page) => {
    await settled(page);
    const before = await word(page).inputValue();
    await meanwhile(page, async () => {
      await goTo(page, "#view=0;over:0,1");
      await goTo(page, "#view=0;zoom:3");
    });
    await settled(page);
    await expect(word(page)).toHaveValue(before);
    assert.equal(await page.evaluate(() => location.hash), "#view=0;zoom:3", "the reader has changed nothing since");
  });
});

test("a click on another tiling is not lost while the picture comes to rest", async () => {
  await visit(async (page) => {
    await settled(page);
    await meanwhile(page, async () => {
      await page.evaluate(() => {
        document.querySelector("canvas").dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft" }));
        document.querySelector('.chooser a[href="#tiling-1"]').click();
      });
      await settled(page);
    }, "addresses");
    await expect(page.locator("article:visible h2")).toHaveText("sigma");
  });
});

test("a defect that is chosen before there is a view", async () => {
  await visit(async (page) => {
    await page.locator('[data-defect="3"]').click();
    await expect(page.locator("article:visible")).toHaveCount(1);
    await page.evaluate(() => window.release());
    await expect(page.locator("[data-defect][aria-current]")).toHaveAttribute("data-defect", "3");
  }, { script: 'window.hold("pauses");', hash: "#tiling-2" });
});

test("a file is what the controls say, not what is still shown", async () => {
  await visit(async (page) => {
    await settled(page);
    const whole = await stl(page);
    const cut = (await saved(page, () => meanwhile(page, async () => {
      await setControl(page, "cut", "50");
      await solid(page);
    }))).bytes;
    await settled(page);
    assert.ok(cut.equals(await stl(page)) && !cut.equals(whole));
    await setControl(page, "cut", "100");
    // Apart and together again before the first is drawn.
    await meanwhile(page, async () => {
      await setControl(page, "explode", "50");
      await setControl(page, "explode", "0");
    });
    await settled(page);
    assert.ok(whole.equals(await stl(page)));
  }, { hash: "#tiling-1" });
});

test("a picture that is saved has outlines and shadows, though it moves", async () => {
  await visit(async (page) => {
    await settled(page);
    const png = page.locator("[data-share=png]"), save = () => png.evaluate((button) => button.click());
    const moving = await saved(page, () => page.locator("canvas").evaluate((canvas) => {
      canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft" }));
      document.querySelector("[data-share=png]").click();
    }));
    await settled(page);
    assert.ok(moving.bytes.equals((await saved(page, save)).bytes));
  });
});

test("a click finds what is drawn after a change of cells", async () => {
  await visit(async (page) => {
    await settled(page);
    const click = () => page.locator("canvas").click({ position: { x: 250, y: 230 } }), chosen = page.locator("article:visible .picked h3");
    await meanwhile(page, async () => {
      await setControl(page, "cells", "2");
      await click();
    });
    await settled(page);
    const first = await chosen.textContent();
    await click();
    await settled(page);
    await expect(chosen).toHaveText(first);
  }, { hash: "#tiling-1" });
});

test("an address that is none", async () => {
  await visit(async (page) => {
    await settled(page);
    assert.equal(await shown(page), "kagome-all");
  }, { hash: "#%" });
});
