#!/usr/bin/env python3
"""Checkers of certificates against each other, on files and on random mutations.

usage: differential.py [--mutations N] [--seed S] [--also COMMAND]... VERIFY COQ_CHECK FILE|FOLDER...

The files are certificates in JSON. VERIFY is acutile-verify and COQ_CHECK the extracted checker, which get each of
them in CBOR; COMMAND is any further one that reads JSON and prints lines as acutile-verify does (its words are
separated by spaces). A file is a disagreement when one program accepts it and another refuses it: rejected,
malformed; or when two print different digests of its CBOR. "declined" agrees with everything, for the limits differ; what one accepts and another declines is
listed, and the share of it is bounded: at most one file in a hundred, without patches and families, of which
COQ_CHECK declines some. Systems of patches are not mutated here; tests/browser/verifier.test.mjs does that.
A file that has no CBOR is not shown to these two. Files whose name sets a limit are checked under the default limits.
Exit code 1 if there is a disagreement, if nothing was accepted or refused, or if too much was declined by one
program alone.
"""
import collections, importlib.util, json, pathlib, random, re, shlex, subprocess, sys, tempfile

sys.dont_write_bytecode = True
spec = importlib.util.spec_from_file_location("verify", pathlib.Path(__file__).parents[1] / "verifiers/python/verify.py")
encodings = importlib.util.module_from_spec(spec)
spec.loader.exec_module(encodings)

NONE = "no CBOR"
WORDS = {"verified": "accepted", "proved": "accepted", "rejected": "refused", "malformed": "refused", "declined": "declined"}


def answers(program, paths, seconds):
    """The verdict on each file, and the digest that stands beside it: one process for all of them."""
    try:
        run = subprocess.run(program + [str(p) for p in paths], capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        if len(paths) == 1:
            return [("declined", None)]
        half = len(paths) // 2
        return answers(program, paths[:half], seconds) + answers(program, paths[half:], seconds)
    lines = run.stdout.splitlines()
    if len(lines) != len(paths):
        sys.exit(f"{program[0]}: {len(lines)} lines for {len(paths)} files: {run.stderr[-300:]}")
    digests = [re.search("sha256 ([0-9a-f]{64})", line) for line in lines]
    return [(WORDS.get(line.split(": ", 1)[1].split()[0].rstrip(":"), line), found and found[1]) for line, found in zip(lines, digests)]


def cbor_of(path):
    """The file's CBOR beside it; None if its text is not that of a certificate."""
    try:
        data = encodings.cbor(encodings.read_json(path.read_bytes()))
    except encodings.Refusal:
        return None
    document = json.loads(path.read_bytes())
    records = [None]
    if isinstance(document, dict):
        claim, witness = document.get("claim"), document.get("witness")
        listed = [claim.get(name) for name in ("parameters", "tiles")] if isinstance(claim, dict) else []
        is_list = document.get("kind") == "patches" and isinstance(witness, list)
        listed += [witness] if is_list else []
        records = [document, claim] + ([] if is_list else [witness])
        records += [record for records in listed if isinstance(records, list) for record in records]
    return data if all(isinstance(record, dict) for record in records) and has_names(document) else None


NAMES = [["format", "version", "kind", "claim", "witness"], ["dimension", "field", "gram", "domain", "statements"],
         ["dimension", "field", "parameters", "gram", "domain", "statements"], ["name", "low", "high"],
         ["denominator", "vertices", "boundary", "simplices"], ["denominator", "vertices", "faces"],
         ["denominator", "vertices", "boundary", "tree", "simplices"], ["field", "gram", "rank", "tiles", "statements"],
         ["denominator", "vertices", "classes"], ["denominator", "offsets", "vertices", "pyramids", "simplices"],
         ["polynomial", "root"], ["low", "high", "denominator"]]


def has_names(value):
    """CBOR has no names, so those of the grammar are needed to write it."""
    if isinstance(value, dict):
        return list(value) in NAMES and all(map(has_names, value.values()))
    return not isinstance(value, list) or all(map(has_names, value))


def canonical(value):
    """The one text of a certificate (docs/format.md)."""
    return "".join(encodings.printed(value, 0)) + "\n"


def leaves(value, path=()):
    if isinstance(value, (dict, list)):
        for key in value if isinstance(value, dict) else range(len(value)):
            yield from leaves(value[key], path + (key,))
    else:
        yield path


def entry(old, rng):
    """Another value of the same kind."""
    if isinstance(old, int):
        new = rng.choice([old - 2, old - 1, old + 1, old + 2, -old, 0])
        return new if abs(new) < 2 ** 53 else str(new)
    if old.lstrip("-").isdigit():
        return str(int(old) + rng.choice([-1, 1]))
    if old in ("closed", "open"):
        return "open" if old == "closed" else "closed"
    if old.endswith("angle"):
        return rng.choice(["largest dihedral angle", "smallest dihedral angle"])
    return rng.choice(["acute", "nonobtuse", "Delaunay", "weakly Delaunay", "not Delaunay", "TCP", "space", "Q", "at most", "maximum", "minimum", "less than"])


def tidy(row, dimension, rank):
    """The row with its corners in the canonical order. The last two stay exchanged if they were."""
    corners, rest = row[: dimension + 1], row[dimension + 1 :]
    corners = [(c, [0] * rank) if isinstance(c, int) else (c[0], c[1:]) for c in corners]
    was_exchanged = corners[-2] > corners[-1]
    corners.sort()
    origin = corners[0][1]
    corners = [(v, [a - b for a, b in zip(shift, origin)]) for v, shift in corners]
    if was_exchanged:
        corners[-2:] = corners[:-3:-1]
    return [[v] + shift if any(shift) else v for v, shift in corners] + rest


def rank(claim):
    name, dimension = claim["domain"], claim["dimension"]
    if isinstance(name, str):
        return dimension
    return {"slab": dimension - 1, "prism": 1, "solid": 0}.get(name[0], name[1])


# COQ_CHECK needs more than half a second of a processor for each: together most of its time for all small files.
SLOW = {"c14-all", "c14-best", "dodecahedron-470", "prism-533", "slab-best", "tetrahedron-543", "z-best", "z-c15-32434", "z-c15-33344",
        "z-c15-4", "family-plane-of-degree-8", "plane-field-of-degree-7", "plane-field-of-degree-8", "space-field-of-degree-8",
        "space-coordinates-of-53-bits", "region-coordinates-of-53-bits", "region-coordinates-of-53-bits-all-figures",
        "strip-of-height-2-to-1-8"}


def original(files, rng):
    """One of the files. A slow one is taken a tenth as often as another one."""
    path = rng.choice(files)
    return path if path.stem not in SLOW or rng.random() < 0.1 else original(files, rng)


def mutate(certificate, rng):
    """One entry changed; or two corners, coordinates or faces exchanged; or a row left out, or there twice."""
    kind = rng.random()
    witness, shape = certificate["witness"], (certificate["claim"]["dimension"], rank(certificate["claim"]))
    simplices, boundary = witness["simplices"], witness["boundary"]
    if kind < 0.7:
        # the claim is small beside the witness: half of the changes are there
        part = rng.choice(["claim", "witness"])
        path = (part,) + rng.choice(list(leaves(certificate[part])))
        holder = certificate
        for key in path[:-1]:
            holder = holder[key]
        holder[path[-1]] = entry(holder[path[-1]], rng)
    elif kind < 0.9:
        domain = certificate["claim"]["domain"]
        polytope = domain[1] if isinstance(domain, list) and isinstance(domain[1], dict) else {"faces": [[]]}
        row = rng.choice([rng.choice(simplices), rng.choice(boundary or [[]]), witness["vertices"], polytope["faces"], rng.choice(polytope["faces"])])
        if len(row) > 1:
            i, j = rng.sample(range(len(row)), 2)
            row[i], row[j] = row[j], row[i]
    else:
        rows = rng.choice([simplices, simplices, boundary or simplices])
        i = rng.randrange(len(rows))
        rows.insert(rng.randrange(len(rows) + 1), rows[i]) if kind < 0.95 else rows.pop(i)
    if "tree" in witness and rng.random() < 0.2:
        witness["tree"] = rng.choice([[], [0, [], []], [0, witness["tree"], []], [0, [], [0, [], []]]])
    # most changes of corners break their order; put it right, so that the later checks are tested
    if rng.random() < 0.8:
        witness["simplices"] = [tidy(row, *shape) for row in simplices]


def options(words):
    arguments, chosen, also = [], {"--mutations": "0", "--seed": "1"}, []
    words = iter(words)
    for word in words:
        if word == "--also":
            also.append(shlex.split(next(words)))
        elif word in chosen:
            chosen[word] = next(words)
        else:
            arguments.append(word)
    if len(arguments) < 3:
        sys.exit(__doc__)
    return arguments, int(chosen["--mutations"]), int(chosen["--seed"]), also


class Comparison:
    """The programs, of which the first two read CBOR."""

    def __init__(self, programs):
        self.programs, self.tally, self.bad, self.alone = programs, collections.Counter(), [], []

    def compare(self, paths, seconds):
        """The verdicts on each file; disagreements are kept."""
        columns = self.of_cbor(paths, seconds) + [answers(program, paths, seconds) for program in self.programs[2:]]
        rows = []
        for path, found in zip(paths, zip(*columns)):
            row, digests = zip(*found)
            rows.append(row)
            self.tally[row] += 1
            if {"accepted", "refused"} <= set(row) or not set(row) <= {NONE, *WORDS.values()} or len({*digests} - {None}) > 1:
                self.bad.append(path)
                print("DISAGREE", path, *row, *digests, flush=True)
            elif {"accepted", "declined"} <= set(row) and not is_beyond_coq(path):
                self.alone.append(path)
                print("declined by one alone:", path, *row, flush=True)
        return rows

    def of_cbor(self, paths, seconds):
        with tempfile.TemporaryDirectory() as folder:
            encoded = {}
            for n, path in enumerate(paths):
                data = cbor_of(path)
                if data is not None:
                    encoded[path] = pathlib.Path(folder) / f"{n}.cbor"
                    encoded[path].write_bytes(data)
            found = [answers(program, list(encoded.values()), seconds) if encoded else [] for program in self.programs[:2]]
        return [[dict(zip(encoded, column)).get(path, (NONE, None)) for path in paths] for column in found]


def is_beyond_coq(path):
    """Families, which may need a finer tree in Coq, and systems of patches."""
    return '"kind":"family"' in path.read_text(errors="replace") or is_system(path)


def is_system(path):
    return '"kind":"patches"' in path.read_text(errors="replace")


def is_accepted(row):
    return "accepted" in row and "refused" not in row


def main():
    (verify, coq, *places), mutations, seed, also = options(sys.argv[1:])
    files = sorted(f for p in map(pathlib.Path, places) for f in ([p] if p.is_file() else p.rglob("*.json")))
    comparison = Comparison([[verify], [coq], *also])
    batches = [files[start:start + 100] for start in range(0, len(files), 100)]
    good = [f for batch in batches for f, row in zip(batch, comparison.compare(batch, 900)) if is_accepted(row)]
    small = [f for f in good if f.stat().st_size < 12000 and not is_system(f)]
    rng = random.Random(seed)
    with tempfile.TemporaryDirectory() as folder:
        for start in range(0, mutations if small else 0, 250):
            paths = [pathlib.Path(folder) / f"mutation-{start + k}.json" for k in range(min(250, mutations - start))]
            for path in paths:
                certificate = json.loads(original(small, rng).read_text())
                mutate(certificate, rng)
                path.write_text(canonical(certificate))
            before = len(comparison.bad)
            comparison.compare(paths, 900)
            for path in comparison.bad[before:]:
                pathlib.Path(f"disagreement-{path.name}").write_text(path.read_text())
            for path in paths:
                path.unlink()
    for row, n in sorted(comparison.tally.items()):
        print(f"{n:6} files: " + ", ".join(row))
    accepted, refused = (sum(n for row, n in comparison.tally.items() if set(row) == {w}) for w in ("accepted", "refused"))
    total = sum(comparison.tally.values())
    print(f"{len(files)} files, {mutations} mutations, {len(comparison.bad)} disagreements, {len(comparison.alone)} declined by one alone")
    sys.exit(1 if comparison.bad or not accepted or not refused or 100 * len(comparison.alone) > total else 0)


main()
