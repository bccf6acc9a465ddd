// The page: which tiling is shown, the buttons, theme and print.

const root = document.documentElement;

// The actions of an article's buttons.
const ACTIONS = {
  verify: ({ data, article }) => verifyAndTell(data, article),
  certificate: ({ data, stem }) => download(`${stem}.json`, "application/json", data.certificate),
  vtk: async ({ tiling, stem, view }) => download(`${stem}.vtk`, "text/plain", vtkText(await tiling(), view?.cells() ?? 1)),
  obj: async ({ tiling, stem, view }) => download(`${stem}.obj`, "text/plain", objText(await tiling(), view?.cells() ?? 1)),
  all: ({ view }) => view?.chooseDefect(null),
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
    this.articles.forEach((article, index) => {
      article.addEventListener("click", (event) => this.act(event, index));
      article.addEventListener("toggle", (event) => buildTable(event.target, this.tilings[index]), true);
    });
    window.addEventListener("hashchange", () => this.follow());
    listenToTheme();
    listenToPrint(this);
    this.start();
  }

  // Read when they are needed first: before, the page is drawn.
  get tilings() {
    return this.read ??= JSON.parse(document.getElementById("data").textContent).tilings;
  }

  // Each step that takes long has a task of its own, so that the page answers between them.
  async start() {
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
      view.replaced = (tiling) => { this.prepared[this.index] = tiling; };
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

  // Shows what the address asks for.
  follow() {
    const address = partsOf(location.hash);
    root.classList.toggle("embedded", address?.isEmbedded ?? false);
    const named = this.articles.findIndex((article) => `#${article.id}` === location.hash);
    const index = Math.min(Math.max(address?.index ?? named, 0), this.articles.length - 1);
    return this.select(index, address?.parts);
  }

  async select(index, parts) {
    this.articles.forEach((article, k) => { article.hidden = k !== index; });
    document.querySelectorAll(".chooser a").forEach((link, k) => {
      if (k === index) link.setAttribute("aria-current", "true");
      else link.removeAttribute("aria-current");
    });
    this.index = index;
    this.address = null;
    if (!this.view) return;
    const tiling = await this.tiling(index);
    if (index !== this.index) return;
    document.querySelectorAll(".stage.live").forEach((stage) => stage.classList.remove("live"));
    this.articles[index].querySelector(".stage").classList.add("live");
    this.view.show(tiling, this.articles[index]);
    if (parts) await applyAddress(this.view, parts);
    this.address = addressOf(this.view, index);
  }

  // The address follows the view as soon as the reader has changed it.
  remember() {
    if (this.address === null) return;
    const address = addressOf(this.view, this.index);
    if (address === this.address) return;
    this.address = address;
    history.replaceState(history.state, "", address + (root.classList.contains("embedded") ? ";embed" : ""));
  }

  act(event, index) {
    const action = event.target.closest("[data-action]")?.dataset.action;
    const defect = event.target.closest("[data-defect]")?.dataset.defect;
    const choice = event.target.closest("[data-choose]")?.dataset.choose;
    if (defect) this.view?.chooseDefect(Number(defect));
    if (choice && this.view?.mesh) this.view.choose(Number(choice));
    const data = this.tilings[index];
    ACTIONS[action]?.({ data, article: this.articles[index], stem: fileStem(data.name), view: this.view, tiling: () => this.tiling(index) });
  }

  share(event) {
    const { share, solid } = event.target.closest("button")?.dataset ?? {}, stem = fileStem(this.view.tiling.data.name);
    if (share) SHARE[share](this.view, stem, this.index);
    if (!solid || !this.view.mesh) return;
    const [type, bytes] = SOLIDS[solid];
    download(`${stem}.${solid}`, type, bytes(this.view));
  }
}

function listenToTheme() {
  document.querySelector('[data-action="theme"]').addEventListener("click", () => {
    const dark = root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
    root.dataset.theme = dark ? "light" : "dark";
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
