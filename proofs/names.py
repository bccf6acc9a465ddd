#!/usr/bin/env python3
"""Each row of the table in README.md names a lemma of docs/soundness.md and one of the theory: both exist."""
import pathlib, re, sys

here = pathlib.Path(__file__).resolve().parent
text = (here.parent / "docs/soundness.md").read_text()
rows = re.findall(r"^\| ((?:Lemma|Theorem) [0-9]+'?) \| `(\w+)` \| (\w+\.v) \|$", (here / "README.md").read_text(), re.M)
wrong = [] if len(rows) >= 10 else ["the table has fewer than ten rows"]
for lemma, name, file in rows:
    if not re.search(r"\*\*" + re.escape(lemma) + r"(?![0-9'])", text):
        wrong.append(f"docs/soundness.md has no {lemma}")
    if not re.search(r"^(?:Lemma|Theorem) " + name + r"\b", (here / "theories" / file).read_text(), re.M):
        wrong.append(f"{file} has no {name}")
print("\n".join(wrong) or f"{len(rows)} names found")
sys.exit(bool(wrong))
