// The index of the site: search and filters, and columns that sort the table.

document.documentElement.classList.add("js");

// Shows the cards that have all words of the search and the chosen properties; groups without a card are hidden.
function filter(form) {
  const words = form.search.value.toLowerCase().split(/\s+/).filter(Boolean);
  const wanted = [...form.querySelectorAll("input[type=checkbox]:checked")].map((box) => box.value);
  let shown = 0;
  for (const card of document.querySelectorAll(".cards li")) {
    const text = card.textContent.toLowerCase(), has = card.dataset.has.split(" ");
    card.hidden = !(words.every((word) => text.includes(word)) && wanted.every((property) => has.includes(property)));
    if (!card.hidden) shown++;
  }
  for (const group of document.querySelectorAll(".group")) group.hidden = !group.querySelector(".cards li:not([hidden])");
  form.querySelector("output").textContent = shown === 1 ? "1 tiling" : `${shown} tilings`;
}

// Sorts the rows of a table by a column: numbers by value, names by letters; a second time the other way.
function sort(button) {
  const heading = button.closest("th"), table = heading.closest("table"), column = heading.cellIndex;
  const isDescending = heading.getAttribute("aria-sort") === "ascending";
  for (const other of table.querySelectorAll("th[aria-sort]")) other.removeAttribute("aria-sort");
  heading.setAttribute("aria-sort", isDescending ? "descending" : "ascending");
  const value = (row) => row.cells[column].textContent.trim();
  const compare = (a, b) => {
    const [x, y] = [value(a), value(b)], [p, q] = [parseFloat(x), parseFloat(y)];
    if (Number.isNaN(p) || Number.isNaN(q)) return Number.isNaN(p) - Number.isNaN(q) || x.localeCompare(y, "en", { numeric: true });
    return p - q;
  };
  const rows = [...table.tBodies[0].rows].sort((a, b) => (isDescending ? compare(b, a) : compare(a, b)));
  table.tBodies[0].append(...rows);
}

const form = document.querySelector(".filter");
if (form) {
  form.addEventListener("input", () => filter(form));
  form.addEventListener("submit", (event) => event.preventDefault());
  filter(form);
}
for (const button of document.querySelectorAll("th button")) button.addEventListener("click", () => sort(button));
