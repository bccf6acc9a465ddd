// Elements of the document. Text from files goes into the document as text, never as markup.

function element(name, attributes = {}, ...children) {
  const node = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.append(...children);
  return node;
}

// A table that scrolls where it is too wide; the first cell of each row is its heading.
const table = (caption, head, rows) => element("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": caption },
  element("table", {}, element("caption", {}, caption),
    element("thead", {}, element("tr", {}, ...head.map((text) => element("th", { scope: "col" }, text)))),
    element("tbody", {}, ...rows.map((row) => element("tr", {}, ...row.map((cell, k) =>
      element(k ? "td" : "th", k ? {} : { scope: "row" }, cell)))))));
