// The view as a picture, as an address, in a frame of another page, on the whole screen.

// What an address says of a view: `#view=INDEX;key:value;…`.
const NUMBERS = ["turn", "pan", "zoom"], CONTROLS = ["shape", "colour", "others", "cells", "explode", "cut", "axis"];

function addressOf(view, index) {
  const short = (x) => String(Number(x.toFixed(4)));
  const numbers = NUMBERS.map((name) => `${name}:${[view[name]].flat().map(short).join(",")}`);
  const controls = CONTROLS.filter((name) => !view.control[name].closest("label").hidden).map((name) => `${name}:${view.control[name].value}`);
  const { data } = view.tiling, choice = data.steps ? [`at:${data.steps.join()}`] : data.choice ? [`over:${[data.choices.findIndex(({ name }) => name === data.choice.name), ...(data.choice.word ?? [])].join()}`] : [];
  const chosen = view.chosen >= 0 ? [`chosen:${view.chosen}`] : [];
  return `#view=${[index, ...choice, ...numbers, ...controls, ...chosen].join(";")}`;
}

// The parts of an address, `null` for one of another kind. Unknown parts and values that are no numbers are left out.
function partsOf(hash) {
  // Programs that pass addresses on may write a semicolon as %3B. What is no character of ASCII belongs to another kind.
  const match = /^#view=(\d+)((?:;[a-z]+:[-a-z0-9.,]+|;embed)*)$/.exec(hash.replace(/%[0-7][0-9a-f]/gi, decodeURIComponent));
  if (!match) return null;
  const parts = new Map(match[2].split(";").filter(Boolean).map((part) => part.split(":")));
  return { index: Number(match[1]), isEmbedded: parts.has("embed"), parts };
}

// Sets the member of a family, or the tiling of a system of patches, as an address says; false if the reader goes on meanwhile.
async function applyChoice(view, parts) {
  const { data } = view.tiling, numbers = (name) => parts.get(name)?.split(",").map(Number) ?? [];
  const steps = numbers("at"), [place, ...word] = numbers("over");
  const isStep = (x, k) => Number.isInteger(x) && x >= data.parameters[k].first && x <= data.parameters[k].last;
  if (data.steps?.length === steps.length && steps.every(isStep)) view.applySteps(steps);
  const choice = data.choices?.[place];
  if (!choice) return true;
  const isWord = word.length > 0 && word.length <= 24 && word.every((k) => data.system.tiles[k]) && agrees(data.system, word);
  return choice.word && !isWord ? true : view.replace(builtFrom(data, choice.word ? { ...choice, word } : choice));
}

// Sets the view as an address says.
async function applyAddress(view, parts) {
  if (!await applyChoice(view, parts)) return;
  for (const name of CONTROLS) {
    const control = view.control[name], value = parts.get(name);
    if (value === undefined || control.closest("label").hidden) continue;
    const isKnown = control.options ? [...control.options].some((option) => option.value === value && !option.disabled) : Number.isFinite(Number(value));
    if (isKnown) control.value = value;
    if (name === "cut") view.showAxis();
  }
  view.showColours();
  if (view.tiling.data.defects) view.tiling.others = view.control.others.value;
  for (const name of NUMBERS) {
    const numbers = parts.get(name)?.split(",").map(Number), length = [view[name]].flat().length;
    if (numbers?.length === length && numbers.every(Number.isFinite)) view[name] = name === "zoom" ? Math.min(Math.max(numbers[0], 0.3), 2000) : numbers;
  }
  const chosen = Number(parts.get("chosen") ?? -1);
  if (Number.isInteger(chosen) && chosen >= 0 && chosen < view.items() * view.cells() ** view.tiling.r) view.choose(chosen);
  view.rebuild();
}

// The page's own address with this view in it.
const pageAddress = (view, index) => location.href.replace(/#.*$/, "") + addressOf(view, index);

// A text for the reader to copy: into the clipboard where that is allowed, and shown in a field in any case.
function offerText(view, label, text) {
  const field = element("input", { type: "text", readonly: "", value: text, "aria-label": label });
  view.panel.querySelector(".offered").replaceChildren(element("label", {}, `${label} `, field));
  field.select();
  navigator.clipboard?.writeText(text).catch(() => {});
}

const escapeAttribute = (text) => text.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;");

const SHARE = {
  png: async (view, stem) => {
    if (!await view.made()) return;
    // While it moves, the picture has no outlines and shadows.
    view.settle();
    view.canvas.toBlob((blob) => download(`${stem}.png`, "image/png", blob));
  },
  link: (view, stem, index) => offerText(view, "Address of this view", pageAddress(view, index)),
  embed: (view, stem, index) => offerText(view, "Code for a frame in another page",
    `<iframe src="${escapeAttribute(pageAddress(view, index))};embed" title="${escapeAttribute(view.tiling.data.name)}" width="640" height="480" loading="lazy" allowfullscreen></iframe>`),
  screen: (view) => {
    const stage = view.panel.closest(".stage");
    if (document.fullscreenElement) document.exitFullscreen();
    else stage.requestFullscreen?.();
  },
};
