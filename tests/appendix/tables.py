"""One check for each marked table of an appendix."""
import hashlib, itertools, re
from collections import Counter
from fractions import Fraction as F

from exact import SLACK, El, check_cosine_interval, check_degrees, must
from reasons import check_reason
from referee import Referee
from formulas import Reader, corner, interval, mate, math, number, rows_of, shift, source
from tiling import Certificate

WHOLE_LIMIT = 300  # larger tilings are not made from their representatives: Python takes too long
SITE_LIMIT = 20_000  # images of vertices, for the same reason


class Check:
    def __init__(self, directory, name, certificate=None):
        self.name = name
        self.directory = directory
        self.c = certificate or Certificate(directory / "anc" / f"{name}.json")
        self.k = self.c.k
        self.counts = Counter()
        self.classes = None

    def texts(self, files=("tiling", "tables")):
        return {kind: source(self.directory / f"{kind}-{self.name}.tex") for kind in files}

    def run(self, texts):
        self.seen = set()
        for kind, text in texts.items():
            lines = text.split("\n")
            for n, line in enumerate(lines):
                match = re.match(r"% acutile:(?:table )?(\S+)\s*(.*)$", line)
                if match:
                    handler = getattr(self, "check_" + match.group(1).replace("-", "_"))
                    handler(lines, n, match.group(2).split(" ")[1:])
                    self.seen.add(f"{kind}:{match.group(1)}")
        if "tiling" in texts:
            must(self.seen >= {"tiling:gram", "tiling:orbits", "tiling:pairing", "tiling:sha256"}, f"tables are missing: {self.seen}")
            self.check_theorem(texts["tiling"])
            self.check_whole(texts["tiling"])
        if "tables" in texts:
            must(self.seen >= {"tables:vertices", "tables:simplices", "tables:mates"}, "tables of the supplement are missing")

    def equal(self, found, expected, what):
        self.counts["numbers"] += 1
        must(found == expected, f"{what}: found {found if not isinstance(found, El) else found.c}, "
                                f"expected {expected if not isinstance(expected, El) else expected.c}")

    def matrix(self, text):
        inner = re.search(r"\\begin\{pmatrix\}(.*)\\end\{pmatrix\}", text).group(1)
        return [[number(self.k, x) for x in row.split("&")] for row in inner.split("\\\\")]

    def check_gram(self, lines, n, _):
        for i, (found, expected) in enumerate(zip(self.matrix(lines[n + 1]), self.c.gram)):
            for j in range(self.c.d):
                self.equal(found[j], expected[j], f"gram[{i}][{j}]")

    def check_theorem(self, text):
        """Every bound of the claim is an item, in order, and no other item has a number."""
        head = text[:text.index("\\end{acutiletheorem}")]
        items = [item for item in head.split("\\item ")[1:] if "$" in item]
        planes = [item for item in items if item.startswith("no tile crosses ")]
        items = [item for item in items if item not in planes]
        bounds = [statement for statement in self.c.claim["statements"] if isinstance(statement, list)]
        stated = [(normal, F(*map(int, offset))) for name, normal, offset in (b for b in bounds if b[0] == "uncrossed plane")]
        self.equal([self.plane(item) for item in planes], stated, "the theorem's planes")
        bounds = [statement for statement in bounds if statement[0] != "uncrossed plane"]
        self.equal(len(items), len(bounds), "the theorem's number of bounds")
        for item, (quantity, relation, *bound) in zip(items, bounds):
            words, value = re.fullmatch(r"(.*?) (?:some |)\$(.*)\$[;.]\s*", item.split("\n")[0]).groups()
            self.equal(words, self.words(quantity, relation), f"the theorem's words on {quantity}")
            sign, (numerator, denominator) = bound if len(bound) == 2 else (1, *bound)
            square = self.k.of(numerator) * F(sign, int(denominator))
            self.check_bound("ratio" in quantity, value, square, f"the theorem's {relation} of the {quantity}")

    def plane(self, item):
        """The normal and the offset of `no tile crosses $2x_1-x_3=1/2$ …`."""
        terms, offset = re.match(r"no tile crosses \$(.*)=(.*?)\$", item).groups()
        found = re.findall(r"([+-]?)(\d*)x_(\d)", terms)
        self.equal("".join(sign + factor + "x_" + k for sign, factor, k in found), terms, "the theorem's plane")
        normal = [0] * self.c.d
        for sign, factor, k in found:
            normal[int(k) - 1] = int(sign + (factor or "1"))
        return normal, F(offset)

    def check_whole(self, text):
        """The referee's tiles, made from the printed representatives, are those of the certificate."""
        if len(self.c.simplices) > WHOLE_LIMIT:
            return
        referee = Referee(text)
        referee.run()
        expected = {referee.name([tuple(c) for c in corners]) for corners in self.c.simplices}
        must(set(referee.all) == expected, "the printed tiling has other tiles")
        self.counts["tiles"] += len(expected)

    def words(self, quantity, relation):
        angle = "angle" if self.c.d == 2 else "dihedral angle"
        which = quantity.split(" ")[0]
        name = "quotient of circumradius and shortest edge of a tile" if which == "squared" else f"{which} {angle}"
        extreme = {("largest", "maximum"): f"the {name} is", ("smallest", "minimum"): f"the {name} is",
                   ("largest", "minimum"): f"the least among the {name}s of the tiles is",
                   ("smallest", "maximum"): f"the greatest among the {name}s of the tiles is",
                   ("squared", "maximum"): f"the largest {name} is", ("squared", "minimum"): f"the least {name} is"}
        other = f"each {name} is {relation}" if which == "squared" else f"the {name} of each is {relation}"
        return extreme.get((which, relation), other)

    def check_bound(self, is_ratio, text, square, what):
        """An angle as an arc cosine or in degrees, a ratio as a root, or an enclosure of either."""
        self.counts["numbers"] += 1
        enclosed = re.fullmatch(r"(?:\\theta\^\\circ\$ with \$\\theta|\\sigma)\\in(.*)", text)
        degrees, arc = re.fullmatch(r"(.*)\^\\circ", text), re.fullmatch(r"\\arccos\((.*)\)", text)
        if enclosed and is_ratio:
            low, high = interval(self.k, enclosed.group(1))
            must(0 < low < high, f"{what}: an enclosure that decides nothing")
            must((square - low * low).sign() >= 0 >= (square - high * high).sign(), f"{what}: not in its enclosure")
            near = (low + SLACK) ** 2, (high - SLACK) ** 2
            must((square - near[0]).sign() <= 0 <= (square - near[1]).sign(), f"{what}: far from an end of its enclosure")
        elif enclosed:
            check_degrees(square, *interval(self.k, enclosed.group(1)), what)
        elif degrees:
            check_degrees(square, *interval(self.k, degrees.group(1)), what)
        else:
            reader = Reader(self.k, text if is_ratio else arc.group(1))
            value = reader.sum()
            reader.end()
            self.equal(value.signed_square(), square, what)

    def class_of(self):
        if self.classes is None:
            number, memo = {}, {}
            self.classes = []
            for s in range(len(self.c.simplices)):
                edges = tuple(self.c.edges(s).values())
                if edges not in memo:
                    memo[edges] = number.setdefault(self.c.form(s), len(number))
                self.classes.append(memo[edges])
        return self.classes

    def check_vertices(self, lines, n, _):
        rows = rows_of(lines, n)
        self.equal([int(row[0]) for row in rows], list(range(len(self.c.vertices))), "the list of vertices")
        for v, row in enumerate(rows):
            for i in range(self.c.d):
                self.equal(number(self.k, math(row[1 + i])), self.c.vertices[v][i], f"vertex {v}, x_{i + 1}")
            self.check_origin(row[-1], v)
        self.check_stars(rows)
        if len(rows[0]) > self.c.d + 3:
            self.check_sites([row[-2] for row in rows])

    def check_sites(self, cells):
        """Wyckoff letters, `6c`: images have the same one, and the multiplicities are those of the orbits in a cell, for one
        quotient of the cells. The letters themselves are compared with the literature in the tests of the program."""
        sites = [re.fullmatch(r"(\d+)([a-zA-Z])", cell) for cell in cells]
        must(all(sites), f"no Wyckoff letter: {cells}")
        referee = self.read_section()
        maps = range(len(referee.p.maps))
        if len(cells) * len(maps) > SITE_LIMIT:
            return
        start = [0] * self.c.rank
        quotients, letters = set(), {}
        for v, site in enumerate(sites):
            orbit = {referee.corner_image(m, (v, *start))[0] for m in maps}
            quotients.add(F(int(site[1]), len(orbit)))
            self.equal({cells[w] for w in orbit}, {cells[v]}, f"vertex {v}, the sites of its images")
            letters.setdefault(site[2], set()).add(site[1])
        self.equal(len(quotients), 1, "the quotient of the cells")
        must(all(len(found) == 1 for found in letters.values()), f"a letter with two multiplicities: {letters}")

    def check_stars(self, rows):
        """The neighbours of a vertex: different corners at the other ends of its edges."""
        if self.c.d != 3:
            return
        if not hasattr(self, "neighbours"):
            self.neighbours = {}
            for corners in self.c.simplices:
                for a, b in itertools.permutations(corners, 2):
                    self.neighbours.setdefault(a[0], set()).add((b[0], *[y - x for x, y in zip(a[1:], b[1:])]))
        for row in rows:
            found = int(re.search(r"\d+", row[1 + self.c.d]).group(0))
            self.equal(found, len(self.neighbours[int(row[0])]), f"vertex {row[0]}, neighbours")

    def check_orbits(self, lines, n, _):
        """Corners and classes; the referee checks the rest of the row."""
        classes = self.class_of()
        for row in rows_of(lines, n):
            s = int(re.fullmatch(r"\$T_\{(\d+)\}\$", row[1]).group(1))
            self.equal(int(row[0]), classes[s], f"T{s}, class")
            self.equal([corner(math(x), self.c.rank) for x in row[2:3 + self.c.d]], self.c.simplices[s], f"T{s}, corners")

    def check_simplices(self, lines, n, _):
        rows, classes = rows_of(lines, n), self.class_of()
        self.equal(len(rows), len(self.c.simplices), "the list of simplices")
        for s, row in enumerate(rows):
            self.equal(row[0], f"$T_{{{s}}}$", "a row's name")
            self.equal(int(row[1]), classes[s], f"T{s}, class")
            self.check_image(math(row[2]), s)
            self.equal(number(self.k, math(row[3])), self.c.det(s), f"T{s}, determinant")
            self.equal([corner(math(x), self.c.rank) for x in row[4:]], self.c.simplices[s], f"T{s}, corners")

    def check_image(self, text, s):
        """A tile is the image of a representative, under an isometry as it is printed in the section."""
        match = re.fullmatch(r"(?:\\gamma_\{(\d+)\})?T_\{(\d+)\}(?:\^\{(.*)\})?", text)
        must(match, f"T{s}: no image: {text}")
        found = self.image(match.group(1), match.group(2), shift(match.group(3), self.c.rank))
        self.equal(sorted(map(list, found)), sorted(self.c.simplices[s]), f"T{s}, as an image")

    def check_origin(self, text, v):
        """A vertex is a corner of an image of a representative, up to the lattice."""
        match = re.fullmatch(r"(?:\$\\gamma_\{(\d+)\}\$, )?\$c_(\d)\$ of \$T_\{(\d+)\}\$", text)
        must(match, f"vertex {v}: no corner: {text}")
        found = self.image(match.group(1), match.group(3))[int(match.group(2))]
        self.equal(found[0], v, f"vertex {v}, as a corner")

    def image(self, isometry, tile, by=None):
        """The corners of an image. The referee reads isometries and representatives in the section."""
        referee, tile, isometry = self.read_section(), int(tile), int(isometry or 0)
        must(tile in referee.p.tiles, f"T{tile} is no representative")
        must(isometry < len(referee.p.maps), f"γ{isometry} is not in the list of isometries")
        return referee.image(isometry, tile, by)

    def read_section(self):
        if not hasattr(self, "referee"):
            self.referee = Referee(self.texts(("tiling",))["tiling"])
        return self.referee

    def mate_rows(self, lines, n):
        rows = rows_of(lines, n)
        for row in rows:
            s = int(re.fullmatch(r"\$T_\{(\d+)\}\$", row[0]).group(1))
            self.equal([mate(math(x), self.c.rank) for x in row[1:]], self.c.mates[s], f"T{s}, facets")
        return [row[0] for row in rows]

    def check_mates(self, lines, n, _):
        self.equal(self.mate_rows(lines, n), [f"$T_{{{s}}}$" for s in range(len(self.c.simplices))], "the pairing")

    def check_pairing(self, lines, n, _):
        """The corner on the other side, from the certificate's tiles."""
        for row in rows_of(lines, n):
            s, i = int(re.fullmatch(r"\$T_\{(\d+)\}\$", row[0]).group(1)), int(row[1])
            mate = self.c.mates[s][i]
            if len(mate) <= 1:
                must("partial" in row[2], f"T{s}, facet {i}: in the boundary")
                continue
            apex = self.c.simplices[mate[0]][mate[1]]
            expected = [apex[0]] + [a + b for a, b in zip(apex[1:], mate[2:])]
            self.equal(corner(math(row[2]), self.c.rank), expected, f"T{s}, facet {i}: the corner on the other side")

    def check_valences(self, lines, n, _):
        """Tetrahedra around each edge, counted over the certificate's list."""
        counts = Counter()
        name = lambda a, b: (a[0], b[0], *[y - x for x, y in zip(a[1:], b[1:])])
        for corners in self.c.simplices:
            for a, b in itertools.combinations(sorted(corners), 2):
                counts[name(a, b)] += 1
        for row in rows_of(lines, n):
            s = int(re.fullmatch(r"\$T_\{(\d+)\}\$", row[0]).group(1))
            for (i, j), cell in zip(self.pairs(), row[1:]):
                a, b = sorted((self.c.simplices[s][i], self.c.simplices[s][j]))
                self.equal(int(cell), counts[name(a, b)], f"T{s}, edge {i}{j}")

    def check_root(self, lines, n, _):
        """The values of the polynomial at the ends; the derivative by Horner's rule."""
        low, at_low, _, high, at_high, _, least, greatest = re.fullmatch(
            r"\$p\((.*?)\)=(.*?)([<>])0\$, \$p\((.*?)\)=(.*?)([<>])0\$, and \$p'\(x\)\\in\[(.*?),(.*?)\]\$ for.*", lines[n + 1]).groups()
        a, b = F(low), F(high)
        self.equal((F(at_low), F(at_high)), (self.k.at(self.k.p, a), self.k.at(self.k.p, b)), "the values at the ends")
        must(F(at_low) * F(at_high) < 0 < F(least) * F(greatest), "the root is not shown")
        lo = hi = F(0)
        for k in range(len(self.k.p) - 1, 0, -1):
            ends = [lo * a, lo * b, hi * a, hi * b]
            lo, hi = min(ends) + k * self.k.p[k], max(ends) + k * self.k.p[k]
        self.equal((F(least), F(greatest)), (lo, hi), "the derivative")

    def of_the_referee(self, *_):
        """The referee reads it."""

    check_group = check_stabilisers = check_boundary = check_volume = check_delaunay = of_the_referee
    check_boundary_facets = check_pairs = check_outside = of_the_referee

    def check_edges(self, lines, n, arguments):
        kind = int(arguments[0])
        first = self.class_of().index(kind)
        head = lines[n - 1]
        match = re.search(r"\\acutileparagraph\{Class (\d+)\.\} \$(\d+)\$ \w+ in \$(\d+)\$ orbits?, (?:each )?of volume \$(.*?)\$ cells; the first is \$T_\{(\d+)\}\$", head)
        must(match, f"class {kind}: no heading")
        self.equal([int(match.group(i)) for i in (1, 2, 5)], [kind, self.class_of().count(kind), first], f"class {kind}, heading")
        factorial = 2 if self.c.d == 2 else 6
        self.equal(number(self.k, match.group(4)) * factorial, self.c.det(first), f"class {kind}, volume")
        found = re.findall(r"l_\{(\d)(\d)\}=([^$]*)\$", lines[n + 1])
        expected = self.c.edges(first)
        self.equal([(int(i), int(j)) for i, j, _ in found], list(expected), f"class {kind}, edges")
        for i, j, text in found:
            self.equal(number(self.k, text), expected[int(i), int(j)], f"class {kind}, l_{i}{j}")
        self.first, self.kind = first, kind

    def check_matrices(self, lines, n, _):
        """Q = 2 λ M exactly, and N the bordered cofactors of Q over ν, as said."""
        match = re.fullmatch(r"With \$\\lambda=(.*?)\$(?:, and the cofactors divided by \$(.*?)\$)?:", lines[n - 1])
        must(match, f"class {self.kind}: no λ")
        factor = number(self.k, match.group(1))
        divisor = number(self.k, match.group(2) or "1")
        must(factor.sign() > 0 and divisor.sign() > 0, "a factor that is not positive")
        q = [[x * factor * 2 for x in row] for row in self.c.inner(self.first)]
        power = factor * 2 if self.c.d == 2 else factor * factor * 4
        self.N = [[x * power / divisor for x in row] for row in self.c.normals(self.first)]
        text = lines[n + 1]
        if "pmatrix" in text:
            blocks = re.findall(r"([QN])=(\\begin\{pmatrix\}.*?\\end\{pmatrix\})", text + lines[n + 2])
            self.equal([name for name, _ in blocks], ["Q", "N"], "the matrices")
            for (name, block), expected in zip(blocks, (q, self.N)):
                for i, row in enumerate(self.matrix(block)):
                    for j, x in enumerate(row):
                        self.equal(x, expected[i][j], f"class {self.kind}, {name}[{i}][{j}]")
        else:
            found = re.findall(r"\$([qN])_\{(\d)(\d)\}=([^$]*)\$", text)
            self.equal(len(found), self.c.d * (self.c.d + 1) // 2 + self.c.d + 1, "the entries")
            for name, i, j, text in found:
                i, j = int(i), int(j)
                self.equal(number(self.k, text), q[i - 1][j - 1] if name == "q" else self.N[i][j], f"class {self.kind}, {name}_{i}{j}")

    def sign_cell(self, cell, pair):
        match = re.fullmatch(r"\$N_\{(\d)(\d)\}=(.*?)([<>]0)?\$", cell)
        must(match, f"no sign: {cell}")
        i, j = int(match.group(1)), int(match.group(2))
        self.equal((i, j), pair, "the facets of a row")
        value = number(self.k, match.group(3))
        self.equal(value, self.N[i][j], f"class {self.kind}, N_{i}{j}")
        self.equal({None: 0, "<0": -1, ">0": 1}[match.group(4)], value.sign(), f"class {self.kind}, sign of N_{i}{j}")
        return value

    def check_reason(self, text, value):
        check_reason(self.k, text, value)
        self.counts["numbers"] += 1

    def pairs(self):
        return list(itertools.combinations(range(self.c.d + 1), 2))

    def facet_pairs(self):
        """The facets at each angle, in the order of the edges 01, 02, …"""
        return self.pairs()[::-1]

    def edge_cell(self, cell, pair):
        others = "".join(str(k) for k in range(self.c.d + 1) if k not in pair)
        self.equal(math(cell), others, "the edge of a row")

    def check_signs(self, lines, n, arguments):
        self.equal(int(arguments[0]), self.kind, "a table's class")
        rows = rows_of(lines, n)
        self.equal(len(rows), len(self.pairs()), "the number of angles")
        for row, pair in zip(rows, self.facet_pairs()):
            self.edge_cell(row[0], pair)
            value = self.sign_cell(row[1], pair)
            if len(row) > 2 and row[2]:
                self.check_reason(math(row[2]), value)

    def check_angles(self, lines, n, arguments):
        self.equal(int(arguments[0]), self.kind, "a table's class")
        rows = rows_of(lines, n)
        self.equal(len(rows), len(self.pairs()), "the number of angles")
        normals = self.c.normals(self.first)
        for row, pair in zip(rows, self.facet_pairs()):
            i, j = pair
            self.edge_cell(row[0], pair)
            if len(row) == 5:
                self.sign_cell(row[1], pair)
            exact, bounds, degrees = map(math, row[-3:])
            product = normals[i][j]
            square = product * product / (normals[i][i] * normals[j][j])
            square = -square if product.sign() > 0 else square
            what = f"class {self.kind}, facets {i}, {j}"
            quotient = f"-N_{{{i}{j}}}/\\sqrt{{N_{{{i}{i}}}N_{{{j}{j}}}}}"
            if exact.startswith(("N", "-N")):
                self.equal(exact, quotient, what)
            else:
                reader = Reader(self.k, exact)
                value = reader.sum()
                reader.end()
                self.equal(value.signed_square(), square, f"{what}, cosine")
            check_cosine_interval(square, *interval(self.k, bounds), what)
            check_degrees(square, *interval(self.k, degrees), what)
            self.counts["enclosures"] += 2

    def check_sha256(self, lines, n, arguments):
        digest = hashlib.sha256(self.c.cbor).hexdigest()
        self.equal(arguments[0], digest, "the digest")
        printed = re.search(r"\\small (\w+)\\\\ (\w+)\\end", lines[n + 1])
        self.equal(printed.group(1) + printed.group(2), digest, "the printed digest")
