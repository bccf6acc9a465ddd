// Tables that are too long to stand in the page: their rows are made when a reader opens them, some at a time.

const ROWS = 500;

// Fills the table of an opened element with its first rows.
function buildTable(details, data) {
  const body = details.querySelector?.("tbody[data-rows]");
  if (!details.open || !body || body.rows.length) return;
  const { witness } = JSON.parse(data.certificate), { vertices, denominator } = witness;
  const row = (v) => element("tr", {}, element("th", { scope: "row" }, String(v)),
    ...vertices[v].map((x) => element("td", {}, exact(x, denominator, 0))));
  const more = element("button", { type: "button" });
  const grow = () => {
    const start = body.rows.length, end = Math.min(start + ROWS, vertices.length);
    for (let v = start; v < end; v++) body.append(row(v));
    more.textContent = `Next ${Math.min(ROWS, vertices.length - end)} of ${vertices.length}`;
    more.hidden = end === vertices.length;
  };
  more.addEventListener("click", grow);
  body.closest(".scroll").after(more);
  grow();
}
