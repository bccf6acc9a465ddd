#!/usr/bin/env python3
"""No file of the development uses a word that leaves something open, or a hypothesis outside of a section.

usage: words.py FILE.v...

Comments and texts are left out; blanks and line breaks between words make no difference. Print Assumptions and coqchk
find the same faults by other means (check.sh). Extraction has a folder of its own; files that `acutile export --coq`
writes are checked as well (certificates.sh).
"""
import re, sys

FORBIDDEN = (r"Admitted|admit|give_up|Axioms?|Parameters?|Conjectures?|Module|Primitive|Load|Declare\s+ML|bypass_check|"
             r"Checking|Definitional\s+UIP|Drop|Redirect|"
             # these add axioms, or fool the count of sections
             r"Admit|Declare\s+Instance|Succeed|Fail|Reset|Back|BackTo|"
             # these change the extracted program, write files, and run other programs or other parts of Coq
             r"Extract|Extraction|Cd|Universes|Add\s+(?:Rec\s+)?(?:LoadPath|ML)|native_\w+")
HYPOTHESIS = r"Variables?|Hypothes[ei]s|Context"


def code(text):
    """The text without comments, which nest, and without texts in quotes, which hide the signs of comments; and whether one is open."""
    kept, depth, i = [], 0, 0
    while i < len(text):
        if text[i] == '"':
            i = text.find('"', i + 1) + 1
            if not i:
                return "".join(kept), True
            kept.append(" " if depth else '""')
        elif text.startswith("(*", i):
            depth, i = depth + 1, i + 2
        elif depth and text.startswith("*)", i):
            depth, i = depth - 1, i + 2
            kept.append(" ")
        else:
            kept.append(text[i] if not depth else " ")
            i += 1
    return "".join(kept), depth > 0


def word(names):
    return re.compile(rf"(?<![\w'])(?:{names})(?![\w'])")


def faults(text):
    text, is_open = code(text)
    if is_open:
        yield "an open comment or text"
    for found in word(FORBIDDEN).finditer(text):
        yield "a forbidden word: " + " ".join(found[0].split())
    depth = 0
    for sentence in re.split(r"\.(?=\s|$)", text):
        words = sentence.split()
        if depth < 1 and word(HYPOTHESIS).search(sentence):
            yield "a hypothesis outside of a section: " + " ".join(words)
        if words[-2:-1] == ["Section"]:
            depth += 1
        elif words[:1] == ["End"] or words[-2:-1] == ["End"]:
            depth -= 1
    if depth:
        yield "an open section"


wrong = [f"{path}: {fault}" for path in sys.argv[1:] for fault in faults(open(path, encoding="utf-8").read())]
print("\n".join(wrong) or f"{len(sys.argv) - 1} files: no such word", file=sys.stderr if wrong else sys.stdout)
sys.exit(bool(wrong) or len(sys.argv) < 2)
