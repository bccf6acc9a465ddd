// Files that are dropped or chosen, one after the other, each with the verifier's answer.

document.documentElement.classList.add("js");
const zone = document.querySelector(".dropzone"), results = document.querySelector(".results");

// A larger file cannot be a certificate within the verifier's limits, and reading it would take all memory.
const MOST_BYTES = 1 << 28;

function answerWords(answer, seconds) {
  if (answer.verdict !== "verified") return [element("p", {}, element("b", {}, `Not verified: ${answer.verdict}`), ` [${answer.code}] ${answer.message}`)];
  return [
    element("p", {}, element("b", {}, `Verified in ${seconds.toFixed(2)} s`), `: ${counted(answer.vertices, "vertex", "vertices")}, ${counted(answer.simplices, "simplex", "simplices")}.`),
    element("ul", {}, ...answer.claim.map((sentence) => element("li", {}, sentence))),
    element("p", {}, "SHA-256 ", element("code", {}, answer.sha256)),
  ];
}

async function answerFor(file) {
  const box = element("section", { class: "verdict busy" }, element("h2", {}, file.name), element("p", {}, "Checking …"));
  results.prepend(box);
  const start = performance.now();
  try {
    if (file.size > MOST_BYTES) throw new Error(`${file.size} bytes are more than a certificate may have`);
    const answer = await recheck(new Uint8Array(await file.arrayBuffer()), "verifyEither");
    box.className = `verdict ${answer.verdict === "verified" ? "good" : "bad"}`;
    box.replaceChildren(box.firstChild, ...answerWords(answer, (performance.now() - start) / 1000));
  } catch (error) {
    box.className = "verdict bad";
    box.replaceChildren(box.firstChild, element("p", {}, element("b", {}, "The check could not run: "), String(error.message ?? error)));
  }
}

async function answerAll(files) {
  for (const file of files) await answerFor(file);
}

window.addEventListener("dragover", (event) => { event.preventDefault(); zone.classList.add("over"); });
window.addEventListener("dragleave", () => zone.classList.remove("over"));
window.addEventListener("drop", (event) => {
  event.preventDefault();
  zone.classList.remove("over");
  answerAll([...event.dataTransfer.files]);
});
zone.querySelector("input").addEventListener("change", (event) => answerAll([...event.target.files]));
