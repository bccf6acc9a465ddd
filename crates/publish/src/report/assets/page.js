// The page: which tiling is shown, the buttons, theme and print.

const root = document.documentElement;

// The actions of an article's buttons.
const ACTIONS = {
  verify: ({ data, article }) => verifyAndTell(data, article),
  certificate: ({ data, stem }) => download(`${stem}.json`, "application/json", data.certificate),
  vtk: async ({ mesh, stem }) => download(`${stem}.vtk`, "text/plain", vtkText(...await mesh())),
  obj: async ({ mesh, stem }) => download(`${stem}.obj`, "text/plain", objText(...await mesh())),
  all: async ({ view }) => (await view())?.chooseDefect(null),
};

// The files of the view itself.
const SOLIDS = {
  stl: ["model/stl", stlBytes],
  glb: ["model/gltf-binary", glbBytes],
  "3mf": ["model/3mf", threeMfBytes],
};

class Page {
  constructor() {
    this.articles = [...document.querySelectorAll("main > article")];
    this.prepared = this.articles.map(() => null);
    this.view = null;
    this.turns = 0;
    this.articles.forEach((article, index) => {
      article.addEventListener("click", (event) => this.act(event, index));
      article.addEventListener("toggle", (event) => buildTable(event.target, this.tilings[index]), true);
    });
    window.addEventListener("hashchange", () => { this.shown = Promise.all([this.shown, this.follow()]); });
    listenToTheme(this);
    listenToPrint(this);
    this.shown = this.start();
  }

  // Read when they are needed first: before, the page is drawn.
  get tilings() {
    return this.read ??= JSON.parse(document.getElementById("data").textContent).tilings;
  }

  // Each step that takes long has a task of its own, so that the page answers between them.
  async start() {
    this.follow();
    await painted();
    this.view = await this.viewOrNote();
    await this.follow();
  }

  async viewOrNote() {
    // The card sleeps again when its last context is gone.
    const release = await wakeCard();
    try {
      const view = new View(document.getElementById("view").content.firstElementChild.cloneNode(true));
      await view.renderer.link();
      view.rested = () => this.remember();
      view.replaced = (tiling, article) => { this.prepared[this.articles.indexOf(article)] = tiling; };
      view.panel.addEventListener("click", (event) => this.share(event));
      return view;
    } catch (error) {
      root.classList.add("still");
      for (const article of this.articles) {
        article.querySelector(".stage").append(element("p", { class: "note" },
          `This browser cannot show the view that turns (${error.message}); above is a still picture. Everything else works.`));
      }
      return null;
    } finally {
      release();
    }
  }

  tiling(index) {
    return this.prepared[index] ??= prepare(this.tilings[index]);
  }

  // The view when it shows this article; null where there is no view, and where the reader has gone on meanwhile.
  async viewOf(article) {
    await this.shown;
    return this.view?.article === article ? this.view : null;
  }

  // The tiling of an article and how many cells are shown in each direction, when they are what the controls say.
  async meshOf(index) {
    const { view } = this, isShown = view?.article === this.articles[index] && await view.made();
    return isShown ? [view.tiling, view.cells()] : [await this.tiling(index), 1];
  }

  // Shows what the address asks for.
  follow() {
    this.hash = location.hash;
    const address = partsOf(location.hash);
    root.classList.toggle("embedded", address?.isEmbedded ?? false);
    const named = this.articles.findIndex((article) => `#${article.id}` === location.hash);
    const index = Math.min(Math.max(address?.index ?? named, 0), this.articles.length - 1);
    return this.select(index, address?.parts);
  }

  async select(index, parts) {
    const turn = ++this.turns;
    this.articles.forEach((article, k) => { article.hidden = k !== index; });
    document.querySelectorAll(".chooser a").forEach((link, k) => {
      if (k === index) link.setAttribute("aria-current", "true");
      else link.removeAttribute("aria-current");
    });
    this.index = index;
    this.address = null;
    if (!this.view) return;
    const tiling = await this.tiling(index);
    if (turn !== this.turns) return;
    document.querySelectorAll(".stage.live").forEach((stage) => stage.classList.remove("live"));
    this.articles[index].querySelector(".stage").classList.add("live");
    this.view.show(tiling, this.articles[index]);
    if (parts) await applyAddress(this.view, parts);
    if (turn === this.turns) this.address = addressOf(this.view, index);
  }

  // The address follows the view as soon as the reader has changed it. An address that the reader asks for and that the browser has not
  // announced yet stays.
  remember() {
    if (this.address === null || location.hash !== this.hash) return;
    const address = addressOf(this.view, this.index);
    if (address === this.address) return;
    this.address = address;
    history.replaceState(history.state, "", address + (root.classList.contains("embedded") ? ";embed" : ""));
    this.hash = location.hash;
  }

  async act(event, index) {
    const action = event.target.closest("[data-action]")?.dataset.action;
    const defect = event.target.closest("[data-defect]")?.dataset.defect;
    const choice = event.target.closest("[data-choose]")?.dataset.choose;
    const data = this.tilings[index], article = this.articles[index], view = () => this.viewOf(article);
    ACTIONS[action]?.({ data, article, stem: fileStem(data.name), view, mesh: () => this.meshOf(index) });
    if (defect) (await view())?.chooseDefect(Number(defect));
    if (choice) (await view())?.choose(Number(choice));
  }

  // A file is what the controls say, so it waits for a picture that is being made.
  async share(event) {
    const { share, solid } = event.target.closest("button")?.dataset ?? {}, { view } = this, stem = fileStem(view.tiling.data.name);
    if (share) SHARE[share](view, stem, this.index);
    if (!solid || !await view.made()) return;
    const [type, bytes] = SOLIDS[solid];
    download(`${stem}.${solid}`, type, bytes(view));
  }
}

function listenToTheme(page) {
  const preference = matchMedia("(prefers-color-scheme: dark)"), redraw = () => page.view?.redraw();
  preference.addEventListener("change", redraw);
  document.querySelector('[data-action="theme"]').addEventListener("click", () => {
    const dark = root.dataset.theme ? root.dataset.theme === "dark" : preference.matches;
    root.dataset.theme = dark ? "light" : "dark";
    redraw();
  });
}

// Tables are open on paper, and the view is drawn once more.
function listenToPrint(page) {
  let opened = [];
  window.addEventListener("beforeprint", () => {
    opened = [...document.querySelectorAll("details.long:not([open])")];
    opened.forEach((node) => { node.open = true; });
    page.view?.paint(true);
  });
  window.addEventListener("afterprint", () => opened.forEach((node) => { node.open = false; }));
}

new Page();
