#!/usr/bin/env python3
"""Compares every number in an appendix with the certificate.

    tests/appendix/check.py DIR            DIR is what `acutile appendix -o DIR` wrote
    tests/appendix/check.py DIR --mutate N change N digits, one at a time: each must be found

Reads the tables in the TeX sources (the comments `% acutile:…` say where they are; they hold no
numbers but the digest) and computes the same from DIR/anc/NAME.json in fractions, by other formulas
than the program: edges from coordinates, angles from Cramer's rule for the Gram matrix of edges, orbits by
refining colours. Where DIR has a compiled main.pdf and pdftotext is installed, all decimals of the sources
must be in the PDF as often. Python's standard library only.
"""
import itertools, random, re, shutil, subprocess, sys
from collections import Counter
from fractions import Fraction as F
from pathlib import Path

from exact import Wrong, cosine, largest, must, sign_of_difference, smallest
from formulas import rows_of, shift, source
from referee import Referee
from tables import Check
from tiling import Certificate, determinant


def check_pdf(directory, names):
    """The decimals of the sources are in the PDF as often."""
    pdf = directory / "main.pdf"
    if not pdf.exists() or not shutil.which("pdftotext"):
        return "no PDF"
    text = subprocess.run(["pdftotext", "-layout", str(pdf), "-"], capture_output=True, text=True, check=True).stdout
    found = Counter(re.findall(r"\d+\.\d{6}\b", text))
    sources = "".join(source(directory / f"tiling-{name}.tex") for name in names)
    expected = Counter(re.findall(r"\\acutiledecimal\{-?(\d+\.\d{6})\}", sources))
    for decimal, count in expected.items():
        must(found[decimal] == count, f"main.pdf has {decimal} {found[decimal]} times, expected {count}")
    for digest in re.findall(r"\\small ([0-9a-f]{32})\\\\ ([0-9a-f]{32})", sources):
        must(all(half in text for half in digest), f"main.pdf has no {digest}")
    return f"{sum(expected.values())} decimals in main.pdf"


def check_overview(directory, names):
    """Angles and ratios of the table: minima rounded down, maxima up, to the digits printed."""
    lines = (directory / "overview.tex").read_text().split("\n")
    rows = rows_of(lines, next(n for n, line in enumerate(lines) if line.startswith("% acutile:table")))
    must(len(rows) == len(names), "the overview has other rows")
    order = re.findall(r"\\input\{tiling-(.*?)\}", (directory / "appendix.tex").read_text())
    for name, row in zip(order, rows):
        c = Certificate(directory / "anc" / f"{name}.json")
        must(int(row[1]) == len(c.simplices), f"{name}: number of simplices")
        squares, ratios, seen = [], [], set()
        for s in range(len(c.simplices)):
            key = tuple(c.edges(s).values())
            if key in seen:
                continue
            seen.add(key)
            n = c.normals(s)
            own = []
            for i, j in itertools.combinations(range(c.d + 1), 2):
                square = n[i][j] * n[i][j] / (n[i][i] * n[j][j])
                own.append(-square if n[i][j].sign() > 0 else square)
            squares.append(own)
            l = [c.edges(s)[0, i] for i in range(1, c.d + 1)]
            m = c.inner(s)
            top = sum((l[i] * l[j] * n[i + 1][j + 1] for i in range(c.d) for j in range(c.d)), c.k.of("0"))
            shortest = smallest(list(c.edges(s).values()))
            ratios.append(top / (4 * determinant(m)) / shortest)
        cells = [F(re.search(r"\{([\d.]+)\}", x).group(1)) for x in row[2:]]
        step = F(1, 1000)
        low, high = smallest(ratios), largest(ratios)
        within = lambda x, lo, hi: (x - lo * lo).sign() >= 0 >= (x - hi * hi).sign()
        must(within(low, cells[0], cells[0] + step) and within(high, cells[1] - step, cells[1]), f"{name}: ratios")
        # smallest angles have the largest cosines
        small, large = [largest(x) for x in squares], [smallest(x) for x in squares]
        step = F(1, 100)
        for value, low, high in [(largest(small), cells[2], cells[2] + step), (smallest(small), cells[3] - step, cells[3]),
                                 (largest(large), cells[4], cells[4] + step), (smallest(large), cells[5] - step, cells[5])]:
            ok = sign_of_difference(value, cosine(low)[1]) <= 0 <= sign_of_difference(value, cosine(high)[0])
            must(ok, f"{name}: angles {float(low)} to {float(high)}")


def data_lines(text):
    """The places of digits in the data of marked tables and in the bounds of the theorem."""
    places, offset, inside = [], 0, False
    lines = text.split("\n")
    single = 0
    for line in lines:
        match = re.match(r"% acutile:(table )?(\S+)", line)
        if match:
            inside, single = bool(match.group(1)) and "wait", 0 if match.group(1) else {"volume": 4}.get(match.group(2), 1)
        elif inside == "wait" and line in ("\\endlastfoot", "\\midrule") and not (line == "\\midrule" and "longtable" in kind):
            inside = True
        elif inside == "wait":
            if line.startswith(("\\begin{longtable}", "\\begin{center}")):
                kind = line
        elif inside is True and line.startswith(("\\end{", "\\bottomrule")):
            inside = False
        elif line.startswith("\\item "):
            places += [offset + i for i, c in enumerate(line) if c.isdigit()]
        elif inside is True or single:
            single -= bool(single)
            if not line.startswith(("\\end{", "which", "\\[ \\acutilefit{$\\begin{aligned}")):
                places += [offset + i for i, c in enumerate(line) if c.isdigit()]
        offset += len(line) + 1
    return places


IMAGE = re.compile(r"\$T_\{(\d+)\}\$ & \d+ & \$(?:\\gamma_\{(\d+)\})?T_\{(\d+)\}(?:\^\{([^}]*)\})?\$ &.*")
ORIGIN = re.compile(r"(\d+) &.*& (?:\$\\gamma_\{(\d+)\}\$, )?\$c_(\d)\$ of \$T_\{(\d+)\}\$ \\\\\*?")


def stays_true(check, line):
    """Whether a changed row says another true thing, by coordinates: a tile with symmetries is several images of its
    representative, and a vertex is a corner of several images. The sums of the corners are compared, without names of points."""
    p = Referee(check.texts(("tiling",))["tiling"]).p
    total = lambda points: [sum(x, p.zero) for x in zip(*points)]
    image, origin = IMAGE.fullmatch(re.sub(r" \\\\\*?$", "", line)), ORIGIN.fullmatch(line)
    if image:
        s, isometry, tile = int(image[1]), int(image[2] or 0), int(image[3])
        if isometry >= len(p.maps) or tile not in p.tiles:
            return False
        by = shift(image[4], p.rank) + [0] * (p.d - p.rank)
        found = total(p.apply(isometry, p.point(c)) for c in p.tiles[tile])
        expected = total(p.point(c) for c in check.c.simplices[s])
        return all(x + (p.d + 1) * k == y for x, k, y in zip(found, by, expected))
    if origin:
        v, isometry, c, tile = int(origin[1]), int(origin[2] or 0), int(origin[3]), int(origin[4])
        if isometry >= len(p.maps) or tile not in p.tiles or c > p.d or v >= len(p.vertices):
            return False
        apart = [x - y for x, y in zip(p.apply(isometry, p.point(p.tiles[tile][c])), p.point([v] + [0] * p.rank))]
        return all(len(x.c) == 1 and x.c[0].denominator == 1 and (k < p.rank or x.c[0] == 0) for k, x in enumerate(apart))
    return False


def repeating(text):
    """The places in the two columns of which several entries may be true."""
    image = r"& \$(?:\\gamma_\{\d+\})?T_\{\d+\}(?:\^\{[^}]*\})?\$ &|(?:\$\\gamma_\{\d+\}\$, )?\$c_\d\$ of \$T_\{\d+\}\$"
    return [place for found in re.finditer(image, text) for place in range(*found.span()) if text[place].isdigit()]


def mutate(directory, names, count, seed=1):
    """Every changed digit must be found, unless the row is true still; half of the changes are in the columns where it can be."""
    random.seed(seed)
    missed, tried, true_still, found_there = [], 0, 0, 0
    for name in names:
        check = Check(directory, name)
        texts = check.texts()
        if sum(map(len, texts.values())) > 150_000:
            continue
        check.run(texts)
        places = [(kind, place) for kind, text in texts.items() for place in data_lines(text)]
        there = [(kind, place) for kind, text in texts.items() for place in repeating(text)]
        chosen = random.sample(places, min(count, len(places))) + random.sample(there, min(count, len(there)))
        for kind, place in chosen:
            text = texts[kind]
            digit = random.choice([d for d in "123456789" if d != text[place]])
            changed = text[:place] + digit + text[place + 1:]
            tried += 1
            try:
                check.run({kind: changed})
            except (Wrong, ValueError, AttributeError, IndexError, KeyError, TypeError, StopIteration, ZeroDivisionError):
                found_there += (kind, place) in there
                continue
            line = changed[changed.rfind("\n", 0, place) + 1:changed.find("\n", place)]
            if (kind, place) in there and stays_true(check, line):
                true_still += 1
            else:
                missed.append((name, kind, text[max(0, place - 60):place] + "»" + digit + "«" + text[place + 1:place + 40]))
    for name, kind, place in missed:
        print(f"{name}, {kind}: a changed digit is not found: {place!r}")
    print(f"{tried} changed digits, {len(missed)} not found, {true_still} in rows that are true still; {found_there} found in their columns")
    return not missed and tried > 0 and found_there > true_still


def main():
    directory = Path(sys.argv[1])
    names = sorted(p.name[len("tiling-"):-len(".tex")] for p in directory.glob("tiling-*.tex"))
    must(names, "no tilings")
    if "--mutate" in sys.argv:
        sys.exit(0 if mutate(directory, names, int(sys.argv[sys.argv.index("--mutate") + 1])) else 1)
    wrong, counts = 0, Counter()
    for name in names:
        check = Check(directory, name)
        try:
            check.run(check.texts())
        except Wrong as error:
            wrong += 1
            print(f"{name}: {error}")
        counts.update(check.counts)
    try:
        check_overview(directory, names)
        pdf = check_pdf(directory, names)
    except Wrong as error:
        wrong, pdf = wrong + 1, str(error)
        print(error)
    print(f"{len(names)} tilings, {counts['numbers']} numbers and {counts['enclosures']} enclosures compared; {pdf}; {wrong} wrong")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
