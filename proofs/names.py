#!/usr/bin/env python3
"""docs/soundness.md and the development tell the same proof; docs/trust.md counts lines.

- Every note "*(Coq: File.v, `name`, …; File.v, …)*" of docs/soundness.md names lemmas that exist.
- Every lemma, theorem and corollary there has such a note, or is named in proofs/README.md
  under "Without a counterpart".
- Every "`path` (N lines" of docs/trust.md and proofs/README.md is true.
- Every theorem that section 16 of docs/lower-bound.md names exists, and check.sh looks at its axioms.
- proofs/README.md counts the certificates of the catalogue that CI proves (.ci/proofs) and those that it does not.
"""
import pathlib, re, sys

here = pathlib.Path(__file__).resolve().parent
root = here.parent
soundness = (root / "docs/soundness.md").read_text()
readme = (here / "README.md").read_text()


def theory(file):
    path = here / "theories" / file
    return path.read_text() if path.exists() else ""


def notes():
    """What is wrong with the notes, and how many names they have."""
    wrong, names = [], 0
    for part in (p for note in re.findall(r"\*\(Coq: (.*?)\)\*", soundness) for p in note.split("; ")):
        match = re.fullmatch(r"(?:in the plane )?(\w+\.v)((?:, `\w+`)+)", part)
        for name in re.findall(r"`(\w+)`", match[2]) if match else []:
            names += 1
            if not re.search(r"^(?:Lemma|Theorem) " + name + r"\b", theory(match[1]), re.M):
                wrong.append(f"{match[1]} has no {name}")
        if not match:
            wrong.append(f"docs/soundness.md: not a note: {part}")
    return wrong, names


def heads():
    """Which lemmas have no note and are not said to have none, and how many lemmas there are."""
    section = re.search(r"^## Without a counterpart\n(.*?)(?:^## |\Z)", readme, re.M | re.S)
    without = set(re.findall(r"^- (.*?):", section[1], re.M)) if section else set()
    found = re.findall(r"^\*\*((?:Lemma|Theorem|Corollary) ?[^*]*?)\.?\*\*\s*(.*?)(?=^\*\*|^## |\Z)", soundness, re.M | re.S)
    wrong = [f"docs/soundness.md: no counterpart of {head}, and proofs/README.md does not say so"
             for head, text in found if "*(Coq: " not in text.split("\n\n")[0] and head not in without]
    wrong += [f"proofs/README.md: docs/soundness.md has no {head}" for head in without - {head for head, _ in found}]
    return wrong, len(found)


def counts():
    """Which counts of lines are not true, and how many there are."""
    wrong, n = [], 0
    for document in (root / "docs/trust.md", here / "README.md"):
        for path, lines in re.findall(r"`([\w./-]+)` \(([\d,]+) lines", document.read_text()):
            n += 1
            places = [p for p in (root / path, here / "theories" / path, here / "extraction" / path, root / "crates/publish/src/report" / path) if p.is_file()]
            true = len(places[0].read_text().splitlines()) if places else None
            if true != int(lines.replace(",", "")):
                wrong.append(f"{document.name}: {path} has {true} lines, not {lines}")
    return wrong, n


def bounds():
    """Which theorems of the table of docs/lower-bound.md do not exist or are not checked, and how many there are."""
    wrong, n = [], 0
    section = re.search(r"^## 16\. What Coq proves\n(.*?)^## ", (root / "docs/lower-bound.md").read_text(), re.M | re.S)[1]
    checked = set(re.search(r'^bounds="(.*?)"', (here / "check.sh").read_text(), re.M | re.S)[1].split())
    for file, names in re.findall(r"(\w+)\.v((?:, `\w+`)+)", section):
        text = (here / "lower-bound" / f"{file}.v").read_text()
        for name in re.findall(r"`(\w+)`", names):
            n += 1
            if not re.search(r"^(?:Lemma|Theorem) " + name + r"\b", text, re.M):
                wrong.append(f"docs/lower-bound.md: {file}.v has no {name}")
            elif f"{file}.{name}" not in checked:
                wrong.append(f"check.sh does not look at {file}.{name}")
    return wrong, n


def catalogue():
    """What is wrong with the counts of certificates."""
    slow = re.search(r"minutes='/\((.*?)\)", (root / ".ci/proofs").read_text())[1].split("|")
    files = {path.stem: path.read_text() for path in (root / "certificates").glob("*.json")}
    systems = {name for name, text in files.items() if '"kind":"patches"' in text} - set(slow)
    proved = set(files) - set(slow)
    true = (f"{len(proved)} of the {len(files)} certificates", f"and {len(systems)} are systems of patches",
            f"\n{len(slow)} take some minutes")
    return [f"proofs/README.md does not say: {words.strip()}" for words in true if words not in readme]


(a, names), (b, lemmas), (c, lines), (d, theorems) = notes(), heads(), counts(), bounds()
wrong = a + b + c + d + catalogue()
if lemmas < 12 or names < 20 or lines < 5 or theorems < 20:
    wrong.append("too little was found to be checked")
print("\n".join(wrong) or "all true:", f"{lemmas} lemmas, {names} names, {lines} counts of lines, {theorems} theorems on lower bounds")
sys.exit(bool(wrong))
