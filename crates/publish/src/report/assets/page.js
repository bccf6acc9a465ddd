// The page: which tiling is shown, the view and its controls, the check in the browser, theme and print.

const read = (id) => JSON.parse(document.getElementById(id).textContent);
const { tilings } = read("data");
const root = document.documentElement;
root.classList.add("js");

const MOST_SIMPLICES = 30000;

// The view of one tiling in its article. There is one canvas; it moves with the view to the tiling that is shown.
class View {
  constructor(template) {
    this.panel = template;
    this.canvas = template.querySelector("canvas");
    this.renderer = new Renderer(this.canvas);
    this.control = Object.fromEntries([...template.querySelectorAll("[name]")].map((node) => [node.name, node]));
    this.legend = template.querySelector(".legend");
    this.listen();
    new ResizeObserver(() => this.resize()).observe(this.canvas);
  }

  show(tiling, article) {
    this.tiling = tiling;
    this.article = article;
    article.querySelector(".stage").append(this.panel);
    const plane = tiling.D === 2;
    this.panel.classList.toggle("plane", plane);
    this.canvas.setAttribute("aria-label", `View of ${tiling.data.name}. ${plane ? "Arrow keys move" : "Arrow keys turn"}, plus and minus zoom, 0 resets, n and p choose the next and previous ${plane ? "triangle" : "tetrahedron"}.`);
    this.panel.querySelector(".hint").textContent = `Drag to ${plane ? "move" : "turn"}, pinch or scroll to zoom, click a ${plane ? "triangle" : "tetrahedron"} for its exact data. Keys: arrows, + − 0, n p.`;
    const refuted = Boolean(tiling.data.defects);
    const show = (name, isShown) => { this.control[name].closest("label").hidden = !isShown; };
    show("colour", !refuted);
    show("others", refuted);
    show("cells", !refuted && tiling.r > 0);
    show("chosen", !refuted);
    for (const option of this.control.cells.options) {
      option.disabled = tiling.cells.length * option.value ** tiling.r > MOST_SIMPLICES || (tiling.r === 0 && option.value > 1);
    }
    for (const option of this.control.axis.options) option.hidden = option.disabled = plane && option.value === "2";
    this.control.cells.value = plane && tiling.cells.length < 12 && tiling.r > 0 ? "3" : "1";
    this.control.others.value = "edges";
    if (refuted) [tiling.defect, tiling.others] = [null, "edges"];
    this.focus = null;
    this.control.chosen.max = tiling.cells.length - 1;
    this.control.chosen.value = "";
    for (const name of ["explode", "cut"]) this.control[name].value = this.control[name].defaultValue;
    this.control.axis.value = "0";
    this.chosen = -1;
    this.choose(-1);
    this.reset();
    this.rebuild();
  }

  // The camera as in the still picture: toward the viewer, right, up.
  reset() {
    const right = [0.8480, 0.5300, 0], up = [-0.2488, 0.3981, 0.8830], toward = [0.4680, -0.7488, 0.4695];
    this.turn = this.tiling.D === 2 ? [1, 0, 0, 0, 1, 0, 0, 0, 1] : [0, 1, 2].flatMap((k) => [right[k], up[k], toward[k]]);
    this.zoom = 1;
    this.pan = [0, 0];
    this.focus = null;
    this.rebuild();
  }

  cells() {
    return Number(this.control.cells.value);
  }

  plane({ low, high }) {
    const cut = Number(this.control.cut.value);
    if (cut >= 100) return null;
    const k = Number(this.control.axis.value);
    return { n: [0, 1, 2].map((i) => (i === k ? 1 : 0)), c: low[k] + (high[k] - low[k]) * (cut / 100) };
  }

  // The triangles are to be made anew: after a change of tiling, cells, cut or colours. Once for each picture is enough.
  rebuild() {
    this.stale = true;
    this.redraw();
  }

  make() {
    this.stale = false;
    const { tiling } = this, n = this.cells(), all = (tiling.bounds ??= {})[n] ??= bounds(tiling, n);
    this.centre = this.focus?.centre ?? all.centre;
    this.scale = (tiling.D === 2 ? 0.97 : 0.94) / all.radius;
    this.colouring = COLOURINGS[tiling.data.defects ? "defect" : this.control.colour.value](tiling);
    this.renderer.upload(triangles(tiling, n, this.plane(all), this.colouring.of));
    this.legend.replaceChildren(...this.colouring.legend.slice(0, 24).map(([hex, text]) => {
      const swatch = element("span", { class: "swatch" });
      swatch.style.background = hex;
      return element("li", {}, swatch, text);
    }));
  }

  resize() {
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const [w, h] = [this.canvas.clientWidth, this.canvas.clientHeight].map((x) => Math.max(1, Math.round(x * ratio)));
    if (w === this.canvas.width && h === this.canvas.height) return;
    [this.canvas.width, this.canvas.height] = [w, h];
    if (this.tiling) this.paint();
  }

  redraw() {
    this.frame ??= requestAnimationFrame(() => { this.frame = null; this.paint(); });
  }

  camera() {
    return {
      turn: this.turn, centre: this.centre, scale: this.scale, zoom: this.zoom, pan: this.pan,
      explode: Number(this.control.explode.value) / 100, flat: this.tiling.D === 2,
    };
  }

  paint() {
    if (this.stale) this.make();
    this.renderer.draw(this.camera(), this.colouring.palette, [0.08, 0.08, 0.1], this.chosen);
  }

  rotate(dx, dy) {
    if (this.tiling.D === 2) {
      this.pan = [this.pan[0] + dx, this.pan[1] - dy];
    } else {
      // New rows from old ones: about the vertical of the screen, then about its horizontal.
      const [c, s, d, t] = [Math.cos(2 * dx), Math.sin(2 * dx), Math.cos(2 * dy), Math.sin(2 * dy)];
      const turned = [];
      for (let k = 0; k < 9; k += 3) {
        const [x, y, z] = this.turn.slice(k, k + 3), u = c * x + s * z, w = c * z - s * x;
        turned.push(u, d * y - t * w, t * y + d * w);
      }
      this.turn = turned;
    }
    this.redraw();
  }

  magnify(factor) {
    this.zoom = Math.min(Math.max(this.zoom * factor, 0.3), this.tiling.data.defects ? 2000 : 20);
    this.redraw();
  }

  // Chooses simplex `owner` of copy and cell, or none for -1.
  choose(owner) {
    const panel = this.article.querySelector(".picked"), count = this.tiling.cells.length;
    this.chosen = owner;
    panel.hidden = owner < 0;
    if (owner >= 0 && this.tiling.data.defects) return this.chooseInRefuted(panel, this.tiling.cells[owner % count]);
    if (owner >= 0) {
      const shift = translates(this.tiling, this.cells())[Math.floor(owner / count)] ?? [];
      panel.replaceChildren(this.closeButton(), ...details(this.tiling, this.tiling.cells[owner % count], shift));
      this.control.chosen.value = owner % count;
    }
    const cell = this.tiling.cells[owner % count];
    this.panel.querySelector(".spoken").textContent = owner < 0 ? "" :
      `${panel.querySelector("h3").textContent}, class ${cell.class}, largest angle ${this.tiling.largest[cell.index].toFixed(2)} degrees`;
    this.redraw();
  }

  closeButton() {
    const button = element("button", { type: "button", class: "close", "aria-label": "Close" }, "×");
    button.addEventListener("click", () => { this.choose(-1); this.canvas.focus({ preventScroll: true }); });
    return button;
  }

  // A simplex of a refuted tiling; its first defect becomes the chosen one.
  chooseInRefuted(panel, cell) {
    panel.replaceChildren(this.closeButton(), ...defectDetails(this.tiling, cell, this.article));
    this.panel.querySelector(".spoken").textContent = panel.textContent;
    if (cell.defects.length && !cell.defects.includes(this.tiling.defect)) this.chooseDefect(cell.defects[0], false);
    this.redraw();
  }

  // Shows one defect, or all of them for null. The camera goes to it unless the choice came from the picture.
  chooseDefect(number, move = true) {
    this.tiling.defect = number;
    for (const button of this.article.querySelectorAll("[data-defect]")) {
      const isChosen = button.dataset.defect === String(number);
      button.toggleAttribute("aria-current", isChosen);
      const list = button.closest(".list");
      if (isChosen && !move) list.scrollTop += button.getBoundingClientRect().top - list.getBoundingClientRect().top;
    }
    if (move) {
      const n = this.cells(), all = (this.tiling.bounds ??= {})[n] ??= bounds(this.tiling, n);
      this.choose(-1);
      this.reset();
      this.focus = number === null ? null : ballOf(this.tiling, number);
      if (this.focus) this.magnify(Math.max(1, 0.4 * all.radius / Math.max(this.focus.radius, 1e-9 * all.radius)));
    }
    this.rebuild();
  }

  listen() {
    this.listenToPointers();
    this.canvas.addEventListener("keydown", (event) => this.key(event));
    this.canvas.addEventListener("wheel", (event) => {
      // A page scrolls past the view unless it is in use.
      if (document.activeElement !== this.canvas && !event.ctrlKey) return;
      event.preventDefault();
      this.magnify(Math.exp(-event.deltaY * 0.0015));
    }, { passive: false });
    for (const name of ["cells", "cut", "axis", "colour"]) {
      this.control[name].addEventListener("input", () => {
        if (name === "cells") this.choose(-1);
        this.rebuild();
      });
    }
    this.control.others.addEventListener("input", () => {
      this.tiling.others = this.control.others.value;
      this.rebuild();
    });
    this.control.explode.addEventListener("input", () => this.redraw());
    this.control.chosen.addEventListener("input", () => {
      const index = this.control.chosen.valueAsNumber;
      if (Number.isInteger(index) && index >= 0 && index < this.tiling.cells.length) this.choose(index);
    });
    for (const button of this.panel.querySelectorAll("[data-view]")) {
      button.addEventListener("click", () => this.act(button.dataset.view));
    }
  }

  // One finger or the mouse turns, two fingers zoom, and what hardly moved was a click.
  listenToPointers() {
    const { canvas } = this, fingers = new Map();
    let travelled = 0, spread = 0;
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      fingers.set(event.pointerId, [event.clientX, event.clientY]);
      if (fingers.size === 1) travelled = 0;
      spread = 0;
    });
    canvas.addEventListener("pointermove", (event) => {
      const old = fingers.get(event.pointerId);
      if (!old) return;
      fingers.set(event.pointerId, [event.clientX, event.clientY]);
      const [dx, dy] = [event.clientX - old[0], event.clientY - old[1]];
      const size = Math.min(canvas.clientWidth, canvas.clientHeight) / 2;
      travelled += Math.hypot(dx, dy);
      if (fingers.size === 1) this.rotate(dx / size, dy / size);
      if (fingers.size === 2) {
        const [a, b] = [...fingers.values()], now = Math.hypot(a[0] - b[0], a[1] - b[1]);
        if (spread) this.magnify(now / spread);
        spread = now;
      }
    });
    const release = (event) => {
      if (event.type === "pointerup" && fingers.size === 1 && travelled < 5) this.click(event);
      fingers.delete(event.pointerId);
      spread = 0;
    };
    canvas.addEventListener("pointerup", release);
    canvas.addEventListener("pointercancel", release);
  }

  click(event) {
    const box = this.canvas.getBoundingClientRect();
    const [x, y] = [2 * (event.clientX - box.left) / box.width - 1, 1 - 2 * (event.clientY - box.top) / box.height];
    if (this.stale) this.paint();
    this.choose(this.renderer.pick(this.camera(), x, y));
  }

  act(name) {
    if (name === "in") this.magnify(1.25);
    if (name === "out") this.magnify(0.8);
    if (name === "reset") this.reset();
  }

  key(event) {
    const turns = { ArrowLeft: [-0.06, 0], ArrowRight: [0.06, 0], ArrowUp: [0, -0.06], ArrowDown: [0, 0.06] };
    const count = this.tiling.cells.length;
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (turns[event.key]) this.rotate(...turns[event.key]);
    else if (event.key === "+" || event.key === "=") this.magnify(1.25);
    else if (event.key === "-") this.magnify(0.8);
    else if (event.key === "0") this.reset();
    else if (event.key === "n") this.choose((this.chosen + 1) % count);
    else if (event.key === "p") this.choose((Math.max(this.chosen, 0) + count - 1) % count);
    else if (event.key === "Escape") this.choose(-1);
    else return;
    event.preventDefault();
  }
}

// Runs the verifier on a certificate, in a worker where there is one, else here.
function recheck(certificate) {
  const source = read("verifier");
  const url = (text) => URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
  const here = async () => (await import(url(source))).verify(certificate);
  return new Promise((resolve, reject) => {
    let worker;
    const instead = () => { worker?.terminate(); here().then(resolve, reject); };
    try {
      const listen = `\nonmessage = async (e) => { try { postMessage({ answer: await verify(e.data) }); }
        catch (error) { postMessage({ failure: String(error) }); } };\n`;
      worker = new Worker(url(source + listen), { type: "module" });
    } catch {
      return instead();
    }
    worker.onerror = instead;
    worker.onmessage = ({ data }) => {
      worker.terminate();
      if (data.failure) reject(new Error(data.failure));
      else resolve(data.answer);
    };
    worker.postMessage(certificate);
  });
}

async function verifyAndTell(tiling, article) {
  const button = article.querySelector('[data-action="verify"]'), verdict = article.querySelector(".verdict");
  const tell = (kind, ...content) => { verdict.className = `verdict ${kind}`; verdict.replaceChildren(...content); };
  button.disabled = true;
  tell("busy", "Checking …");
  const start = performance.now();
  try {
    const answer = await recheck(tiling.data.certificate);
    const seconds = `${((performance.now() - start) / 1000).toFixed(2)} s`;
    if (answer.verdict !== "verified") {
      tell("bad", element("b", {}, `Not verified: ${answer.verdict}`), ` [${answer.code}] ${answer.message} (${seconds})`);
    } else if (answer.sha256 !== tiling.data.sha256) {
      tell("bad", element("b", {}, "Verified another certificate"), ` with the SHA-256 ${answer.sha256}`);
    } else {
      tell("good", element("b", {}, `Verified in this browser in ${seconds}.`),
        ` ${answer.vertices} ${answer.vertices === 1 ? "vertex" : "vertices"}, ${answer.simplices} ${answer.simplices === 1 ? "simplex" : "simplices"}, SHA-256 as above. The claim:`,
        element("ul", {}, ...answer.claim.map((sentence) => element("li", {}, sentence))));
    }
  } catch (error) {
    tell("bad", element("b", {}, "The check could not run: "), String(error.message ?? error));
  }
  button.disabled = false;
}

function start() {
  const prepared = tilings.map(() => null);
  const articles = tilings.map((_, index) => document.getElementById(`tiling-${index}`));
  const tilingOf = (index) => (prepared[index] ??= prepare(tilings[index]));
  let view = null;
  try {
    view = new View(document.getElementById("view").content.firstElementChild.cloneNode(true));
  } catch (error) {
    for (const article of articles) {
      article.querySelector(".stage").append(element("p", { class: "note" },
        `This browser cannot show the view that turns (${error.message}); above is a still picture. Everything else works.`));
    }
  }
  const select = (index) => {
    articles.forEach((article, k) => { article.hidden = k !== index; });
    document.querySelectorAll(".chooser a").forEach((link, k) => {
      if (k === index) link.setAttribute("aria-current", "true");
      else link.removeAttribute("aria-current");
    });
    if (!view) return;
    document.querySelectorAll(".stage.live").forEach((stage) => stage.classList.remove("live"));
    articles[index].querySelector(".stage").classList.add("live");
    view.show(tilingOf(index), articles[index]);
  };
  const wanted = () => Math.max(0, articles.findIndex((article) => `#${article.id}` === location.hash));
  window.addEventListener("hashchange", () => select(wanted()));
  articles.forEach((article, index) => article.addEventListener("click", (event) => {
    const action = event.target.closest("[data-action]")?.dataset.action;
    const defect = event.target.closest("[data-defect]")?.dataset.defect;
    if (defect) view?.chooseDefect(Number(defect));
    if (action === "all") view?.chooseDefect(null);
    if (!action) return;
    const tiling = tilingOf(index), stem = fileStem(tiling.data.name), n = view?.cells() ?? 1;
    if (action === "verify") verifyAndTell(tiling, article);
    if (action === "certificate") download(`${stem}.json`, "application/json", tiling.data.certificate);
    if (action === "vtk") download(`${stem}.vtk`, "text/plain", vtkText(tiling, n));
    if (action === "obj") download(`${stem}.obj`, "text/plain", objText(tiling, n));
  }));
  document.querySelector('[data-action="theme"]').addEventListener("click", () => {
    const dark = root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
    root.dataset.theme = dark ? "light" : "dark";
  });
  let opened = [];
  window.addEventListener("beforeprint", () => {
    opened = [...document.querySelectorAll("details:not([open])")];
    opened.forEach((node) => { node.open = true; });
    view?.paint();
  });
  window.addEventListener("afterprint", () => opened.forEach((node) => { node.open = false; }));
  select(wanted());
}

start();
