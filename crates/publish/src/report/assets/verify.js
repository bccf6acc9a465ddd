// After the second verifier has run, the page compares its own words with what is verified.

// The words of the page that a verified certificate decides: [element, whether they say what is verified, what that is].
function decidedWords(article, answer, certificate, generator) {
  const statements = certificate.claim.statements, sentences = [...article.querySelectorAll("[data-sentence]")];
  const words = sentences.map((node, k) => {
    const text = node.textContent.trim(), clause = text[0].toLowerCase() + text.slice(1).replace(/\.$/, "");
    const verified = answer.claim[k] ?? "nothing";
    if (k === 0) return [node, clause === openingSentence(certificate), verified];
    return [node, k < statements.length && saysStatement(clause, statements[k], certificate.claim, generator), verified];
  });
  const values = [...article.querySelectorAll("[data-verified]")].map((node) => {
    const value = String(answer[node.dataset.verified]);
    return [node, node.textContent.trim() === value, value];
  });
  return { decided: [...words, ...values], missing: Math.max(0, statements.length - sentences.length) };
}

// Marks the words that differ, and says how many do. A second check forgets the marks of the first.
function markDifferences(article, answer, certificate, generator) {
  article.querySelectorAll(".correction").forEach((node) => node.remove());
  article.querySelectorAll("mark.differs").forEach((node) => node.replaceWith(...node.childNodes));
  const { decided, missing } = decidedWords(article, answer, certificate, generator);
  const differing = decided.filter(([, agrees]) => !agrees);
  for (const [node, , verified] of differing) {
    const mark = element("mark", { class: "differs" }, ...node.childNodes);
    node.append(mark, element("span", { class: "correction" }, ` Verified: ${verified}`));
  }
  return differing.length + missing;
}

async function verifyAndTell({ certificate, sha256, generator }, article) {
  const button = article.querySelector('[data-action="verify"]'), verdict = article.querySelector(".verdict[role=status]");
  const tell = (kind, ...content) => { verdict.className = `verdict ${kind}`; verdict.replaceChildren(...content); };
  button.disabled = true;
  tell("busy", "Checking …");
  const start = performance.now();
  try {
    const answer = await recheck(certificate);
    const seconds = `${((performance.now() - start) / 1000).toFixed(2)} s`;
    if (answer.verdict !== "verified") {
      tell("bad", element("b", {}, `Not verified: ${answer.verdict}`), ` [${answer.code}] ${answer.message} (${seconds})`);
    } else {
      const differences = markDifferences(article, answer, JSON.parse(certificate), generator);
      const known = answer.sha256 === sha256;
      tell(known && !differences ? "good" : "bad", ...wordsOf(answer, seconds, differences, known));
    }
  } catch (error) {
    tell("bad", element("b", {}, "The check could not run: "), String(error.message ?? error));
  }
  button.disabled = false;
}

function wordsOf(answer, seconds, differences, isKnown) {
  const head = isKnown ? `Verified in this browser in ${seconds}.` : "Verified another certificate";
  const digest = isKnown ? "SHA-256 as above" : `with the SHA-256 ${answer.sha256}`;
  const compared = differences
    ? element("p", {}, element("b", {}, `This page says ${differences === 1 ? "one thing" : `${differences} things`} differently`), "; marked above.")
    : element("p", {}, "The page's sentences, counts and SHA-256 agree with what is verified.");
  return [
    element("b", {}, head), ` ${counted(answer.vertices, "vertex", "vertices")}, ${counted(answer.simplices, "simplex", "simplices")}, ${digest}.`, compared,
    element("details", {}, element("summary", {}, "The claim as the second verifier reads it"),
      element("ul", {}, ...answer.claim.map((sentence) => element("li", {}, sentence)))),
  ];
}
