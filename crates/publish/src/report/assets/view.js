// The view of one tiling in its article: controls, camera, choice. There is one canvas; it moves to the tiling that is shown.

const MOST_SIMPLICES = 30000;
// Milliseconds without a movement after which the picture is drawn with outlines and soft shadows.
const REST = 120;

class View {
  constructor(panel) {
    this.panel = panel;
    this.canvas = panel.querySelector("canvas");
    this.renderer = new Renderer(this.canvas);
    this.control = Object.fromEntries([...panel.querySelectorAll("[name]")].map((node) => [node.name, node]));
    this.legend = panel.querySelector(".legend");
    this.listen();
    new ResizeObserver(() => this.resize()).observe(this.canvas);
  }

  show(tiling, article) {
    this.coming = null;
    this.tiling = tiling;
    this.article = article;
    this.mesh = this.colouring = this.focus = null;
    const stage = article.querySelector(".stage");
    // Whoever moves it takes the focus from it.
    if (this.panel.parentElement !== stage) stage.append(this.panel);
    this.showControls();
    this.showChoice();
    if (tiling.data.defects) [tiling.defect, tiling.others] = [null, "edges"];
    this.chosen = -1;
    this.choose(-1);
    this.reset();
  }

  // Controls without a meaning for this tiling are not there.
  showControls() {
    const { tiling, control } = this, { data } = tiling, plane = tiling.D === 2, refuted = Boolean(data.defects);
    const simplex = plane ? "triangle" : "tetrahedron";
    this.panel.classList.toggle("plane", plane);
    this.canvas.setAttribute("aria-label", `View of ${data.name}. ${plane ? "Arrow keys move" : "Arrow keys turn"}, plus and minus zoom, 0 resets, n and p choose the next and previous ${simplex}.`);
    this.panel.querySelector(".hint").textContent = `Drag to ${plane ? "move" : "turn"}, pinch or scroll to zoom, click a ${simplex} for its data. Keys: arrows, + − 0, n p.`;
    const show = (name, isShown) => { control[name].closest("label").hidden = !isShown; };
    for (const option of control.colour.options) option.hidden = option.disabled = !hasColouring(data, option.value);
    control.colour.value = [...control.colour.options].find((option) => !option.disabled)?.value ?? "angle";
    for (const option of control.cells.options) {
      option.hidden = option.disabled = tiling.count * option.value ** tiling.r > MOST_SIMPLICES && option.value > 1;
    }
    for (const option of control.axis.options) option.hidden = option.disabled = plane && option.value === "2";
    show("others", refuted);
    show("cells", !refuted && tiling.r > 0 && [...control.cells.options].some((option) => !option.disabled && option.value > 1));
    show("chosen", !refuted && tiling.count > 1);
    show("explode", tiling.count > 1 && tiling.count <= MOST_SIMPLICES);
    show("shape", Boolean(data.foam));
    control.shape.value = "simplices";
    this.showColours();
    control.cells.value = plane && tiling.count < 12 && tiling.r > 0 ? "3" : "1";
    control.others.value = "edges";
    control.chosen.max = tiling.count - 1;
    control.chosen.value = "";
    for (const name of ["explode", "cut"]) control[name].value = control[name].defaultValue;
    control.axis.value = "0";
    this.showAxis();
  }

  // Across which axis is a question only where something is cut.
  showAxis() {
    this.control.axis.closest("label").hidden = !this.isCut();
  }

  isCut() {
    return Number(this.control.cut.value) < Number(this.control.cut.max);
  }

  // Sliders of a family, or the choice of a tiling for a system of patches.
  showChoice() {
    const form = this.panel.querySelector(".choice"), controls = { family: familyControls, patches: patchControls }[this.tiling.data.kind];
    form.hidden = !controls;
    form.replaceChildren(...(controls?.(this) ?? []));
  }

  // The vertices have moved: the picture is made anew, and so are the values of a chosen simplex.
  renew() {
    if (this.chosen >= 0) this.choose(this.chosen);
    this.rebuild();
  }

  // Another tiling takes the place of this one; false if the reader wants something else before it is prepared. The reader goes on in
  // the same control.
  async replace(data) {
    delete this.canvas.dataset.rested;
    const coming = this.coming = prepare(data), tiling = await coming;
    if (coming !== this.coming) return false;
    const { activeElement } = document, { selectionStart } = activeElement;
    this.replaced?.(tiling, this.article);
    this.show(tiling, this.article);
    const control = this.panel.querySelector(`.choice [name="${activeElement.name}"]`);
    control?.focus();
    if (selectionStart >= 0) control?.setSelectionRange?.(selectionStart, selectionStart);
    return true;
  }

  // The foam has one colouring, and so have defects.
  showColours() {
    const usable = [...this.control.colour.options].filter((option) => !option.disabled);
    this.control.colour.closest("label").hidden = this.tiling.data.defects || this.isFoam() || usable.length < 2;
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

  // Whether cells of the foam are drawn and chosen, not simplices.
  isFoam() {
    return this.control.shape.value === "foam";
  }

  // How many there are to choose from in one cell of the lattice.
  items() {
    return this.isFoam() ? this.tiling.data.foam.length : this.tiling.count;
  }

  cells() {
    return Number(this.control.cells.value);
  }

  plane({ low, high }) {
    if (!this.isCut()) return null;
    const cut = Number(this.control.cut.value);
    const k = Number(this.control.axis.value);
    return { n: [0, 1, 2].map((i) => (i === k ? 1 : 0)), c: low[k] + (high[k] - low[k]) * (cut / 100) };
  }

  isApart() {
    return Number(this.control.explode.value) > 0;
  }

  // The triangles are to be made anew: after a change of tiling, cells, cut or colours. One making at a time is enough.
  rebuild() {
    this.stale = true;
    delete this.canvas.dataset.rested;
    this.making ??= this.makeAll();
  }

  async makeAll() {
    try {
      await null;
      while (this.stale) await this.make();
    } finally {
      this.making = null;
    }
    this.redraw();
  }

  // Waits until the triangles are what the controls say; false if the reader goes on to another article meanwhile.
  async made() {
    const { article } = this;
    while (this.coming || this.making) await (this.coming ?? this.making);
    return article === this.article;
  }

  async make() {
    this.stale = false;
    this.madeApart = this.isApart();
    const { tiling } = this, n = this.cells(), bounds = boundsOf(tiling, n);
    const isFoam = this.isFoam(), colouring = COLOURINGS[tiling.data.defects ? "defect" : isFoam ? "foam" : this.control.colour.value](tiling);
    const plane = this.plane(bounds), mesh = await (isFoam ? foamTriangles(tiling, n, plane, colouring.of) : triangles(tiling, n, plane, colouring.of, this.madeApart));
    if (tiling !== this.tiling) return;
    this.centre = this.focus?.centre ?? bounds.centre;
    this.scale = (tiling.D === 2 ? 0.97 : 0.94) / bounds.radius;
    [this.mesh, this.colouring] = [mesh, colouring];
    this.renderer.upload(mesh);
    this.legend.replaceChildren(...colouring.legend.slice(0, 24).map(([hex, text]) => {
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
    this.redraw();
  }

  redraw() {
    this.frame ??= requestAnimationFrame(() => { this.frame = null; this.paint(false); });
    clearTimeout(this.rest);
    delete this.canvas.dataset.rested;
    this.rest = setTimeout(() => this.settle(), REST);
  }

  // Nothing moves any more: the picture with outlines and shadows. A frame that a busy browser still owes would paint over it.
  settle() {
    clearTimeout(this.rest);
    cancelAnimationFrame(this.frame);
    this.frame = null;
    this.paint(true);
    this.rested?.();
    if (this.mesh && !this.making && !this.coming) this.canvas.dataset.rested = "";
  }

  camera() {
    return {
      turn: this.turn, centre: this.centre, scale: this.scale, zoom: this.zoom, pan: this.pan,
      explode: Number(this.control.explode.value) / 100, flat: this.tiling.D === 2,
    };
  }

  paint(isFine) {
    if (!this.mesh) return;
    // Shadows and outlines of single edges would hide them. Nothing is behind these but the page, so they have the colour of its text.
    const hasEdges = this.tiling.others === "edges";
    const ink = hasEdges ? getComputedStyle(this.panel).color.match(/\d+/g).slice(0, 3).map((x) => x / 255) : [0.08, 0.08, 0.1];
    this.renderer.draw(this.camera(), this.colouring.palette, ink, this.chosen, isFine && !hasEdges);
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
    const { tiling } = this, panel = this.article.querySelector(".picked"), items = this.items(), index = owner % items;
    this.chosen = owner;
    panel.hidden = owner < 0;
    if (owner >= 0 && tiling.data.defects) return this.chooseInRefuted(panel, index);
    if (owner >= 0) {
      const shift = translates(tiling, this.cells())[Math.floor(owner / items)] ?? [];
      const content = this.isFoam() ? foamDetails(tiling, index) : (tiling.data.kind ? roundedDetails : details)(tiling, cellOf(tiling, index), shift);
      panel.replaceChildren(this.closeButton(), ...content);
      panel.scrollTop = 0;
      this.control.chosen.value = index;
    }
    this.panel.querySelector(".spoken").textContent = owner < 0 ? "" : this.isFoam() ? panel.querySelector("h3").textContent :
      `${panel.querySelector("h3").textContent}, largest angle ${largestAngle(tiling, index).toFixed(2)} degrees`;
    this.redraw();
  }

  closeButton() {
    const button = element("button", { type: "button", class: "close", "aria-label": "Close" }, "×");
    button.addEventListener("click", () => { this.choose(-1); this.canvas.focus({ preventScroll: true }); });
    return button;
  }

  // A simplex of a refuted tiling; its first defect becomes the chosen one.
  chooseInRefuted(panel, index) {
    const defects = this.tiling.defectsOf[index];
    panel.replaceChildren(this.closeButton(), ...defectDetails(this.tiling, index, this.article));
    this.panel.querySelector(".spoken").textContent = panel.textContent;
    if (defects.length && !defects.includes(this.tiling.defect)) this.chooseDefect(defects[0], false);
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
      const all = boundsOf(this.tiling, this.cells());
      this.choose(-1);
      this.reset();
      this.focus = number === null ? null : ballOf(this.tiling, number);
      if (this.focus) this.magnify(Math.max(1, 0.4 * all.radius / Math.max(this.focus.radius, 1e-9 * all.radius)));
    }
    this.rebuild();
  }

  listen() {
    listenToPointers(this);
    listenToWheel(this);
    listenToKeys(this);
    for (const name of ["cells", "cut", "axis", "colour", "shape"]) {
      this.control[name].addEventListener("input", () => {
        if (name === "cells" || name === "shape") this.choose(-1);
        if (name === "shape") this.showColours();
        if (name === "cut") this.showAxis();
        this.rebuild();
      });
    }
    this.control.others.addEventListener("input", () => {
      this.tiling.others = this.control.others.value;
      this.rebuild();
    });
    this.control.explode.addEventListener("input", () => (this.isApart() === this.madeApart ? this.redraw() : this.rebuild()));
    this.control.chosen.addEventListener("input", () => {
      const index = this.control.chosen.valueAsNumber;
      if (Number.isInteger(index) && index >= 0 && index < this.items()) this.choose(index);
    });
    const acts = { in: () => this.magnify(1.25), out: () => this.magnify(0.8), reset: () => this.reset() };
    for (const button of this.panel.querySelectorAll("[data-view]")) button.addEventListener("click", acts[button.dataset.view]);
  }

  // Chooses what is under the pointer. After a change of cells or shape the old picture has other numbers than the new one.
  async click(event) {
    const box = this.canvas.getBoundingClientRect();
    const [x, y] = [2 * (event.clientX - box.left) / box.width - 1, 1 - 2 * (event.clientY - box.top) / box.height];
    if (await this.made()) this.choose(this.renderer.pick(this.camera(), x, y));
  }
}

// Whether a tiling's data suffice for a way to colour.
function hasColouring(data, name) {
  if (name === "class") return Boolean(data.cells) && data.palette.length > 0;
  if (name === "type") return Boolean(data.typeNames?.length);
  if (name === "piece") return new Set(data.pieces).size > 1;
  return true;
}
