#!/usr/bin/env python3
"""Checkers of certificates against each other, on files and on random mutations.

usage: differential.py [--mutations N] [--seed S] [--also COMMAND] VERIFY COQ_CHECK FILE|FOLDER...

VERIFY is a command that verifies certificates in JSON (`acutile verify`), COQ_CHECK the
extracted checker, COMMAND any further one. Each takes files and prints one line for each;
words of a command are separated by spaces. A file is a disagreement if one program accepts it
and another one refuses it: rejected, malformed. "declined" agrees with everything, because the
limits differ; the share of files that one accepts and another declines is bounded: at most one
in a hundred, and regions do not count, which COQ_CHECK always declines.
Exit code 1 if there is a disagreement, if nothing was accepted or refused, or if too many files
were declined by one program alone.
"""
import collections, json, pathlib, random, shlex, subprocess, sys, tempfile

WORDS = {"verified": "accepted", "proved": "accepted", "rejected": "refused", "malformed": "refused", "declined": "declined"}


def answers(program, paths, seconds):
    """The verdict on each file: one process for all of them."""
    try:
        run = subprocess.run(program + [str(p) for p in paths], capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        if len(paths) == 1:
            return ["declined"]
        half = len(paths) // 2
        return answers(program, paths[:half], seconds) + answers(program, paths[half:], seconds)
    lines = run.stdout.splitlines()
    if len(lines) != len(paths):
        sys.exit(f"{program[0]}: {len(lines)} lines for {len(paths)} files: {run.stderr[-300:]}")
    return [WORDS.get(line.split(": ", 1)[1].split()[0].rstrip(":"), line) for line in lines]


def canonical(value, depth=0):
    """The one JSON text of a certificate (docs/format.md)."""
    if isinstance(value, str):
        return json.dumps(value)
    if isinstance(value, int):
        return str(value) if abs(value) < 1 << 53 else f'"{value}"'
    inner = depth + 1
    if isinstance(value, dict):
        items, ends = [json.dumps(k) + ":" + canonical(v, inner) for k, v in value.items()], "{}"
    else:
        items, ends = [canonical(v, inner) for v in value], "[]"
    line = "\n" if inner <= 3 and items else ""
    return ends[0] + line + ("," + line).join(items) + line + ends[1]


def leaves(value, path=()):
    if isinstance(value, (dict, list)):
        for key in value if isinstance(value, dict) else range(len(value)):
            yield from leaves(value[key], path + (key,))
    else:
        yield path


STATEMENTS = ["acute", "nonobtuse", "Delaunay", "weakly Delaunay", "TCP"]
RELATIONS = ["less than", "at most", "maximum", "more than", "at least", "minimum"]


def entry(old, rng):
    """Another value of the same kind."""
    if isinstance(old, int):
        return rng.choice([old - 2, old - 1, old + 1, old + 2, -old, 0])
    if old.lstrip("-").isdigit():
        return int(old) + rng.choice([-1, 1])
    if old in RELATIONS:
        return rng.choice(RELATIONS)
    if old.endswith("angle"):
        return rng.choice(["largest dihedral angle", "smallest dihedral angle"])
    return rng.choice(STATEMENTS + ["space", "Q"])


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


def mutate(certificate, rng):
    """One entry changed; or two items of a row exchanged; or a simplex left out, or there twice."""
    claim, witness = certificate["claim"], certificate["witness"]
    simplices = witness["simplices"]
    shape = claim["dimension"], rank(claim)
    kind = rng.random()
    if kind < 0.7:
        # the claim is small beside the witness: half of the changes are there
        part = rng.choice([claim, witness])
        path = rng.choice(list(leaves(part)))
        holder = part
        for key in path[:-1]:
            holder = holder[key]
        holder[path[-1]] = entry(holder[path[-1]], rng)
    elif kind < 0.9:
        domain = claim["domain"]
        faces = domain[1]["faces"] if isinstance(domain, list) and domain[0] != "region" else []
        row = rng.choice([rng.choice(simplices), witness["vertices"], claim["statements"], faces])
        if len(row) > 1:
            i, j = rng.sample(range(len(row)), 2)
            row[i], row[j] = row[j], row[i]
    else:
        i = rng.randrange(len(simplices))
        simplices.insert(rng.randrange(len(simplices) + 1), simplices[i]) if kind < 0.95 else simplices.pop(i)
    # most changes of corners break their order: put it right, so that more than that is tested
    if rng.random() < 0.8:
        witness["simplices"] = [tidy(row, *shape) for row in simplices]


def options(words):
    arguments, chosen = [], {"--mutations": "0", "--seed": "1", "--also": ""}
    words = iter(words)
    for word in words:
        if word in chosen:
            chosen[word] = next(words)
        else:
            arguments.append(word)
    if len(arguments) < 3:
        sys.exit(__doc__)
    commands = [shlex.split(words) for words in arguments[:2] + [chosen["--also"]] if words]
    return commands, arguments[2:], int(chosen["--mutations"]), int(chosen["--seed"])


class Comparison:
    def __init__(self, programs):
        self.programs, self.tally, self.bad, self.alone = programs, collections.Counter(), [], []

    def compare(self, paths, seconds):
        """The verdicts on each file; disagreements are kept."""
        columns = [answers(program, paths, seconds) for program in self.programs]
        for path, row in zip(paths, zip(*columns)):
            self.tally[row] += 1
            if {"accepted", "refused"} <= set(row) or not set(row) <= set(WORDS.values()):
                self.bad.append(path)
                print("DISAGREE", path, *row, flush=True)
            elif {"accepted", "declined"} <= set(row) and '"region"' not in path.read_text():
                self.alone.append(path)
                print("declined by one alone:", path, *row, flush=True)
        return list(zip(*columns))


def main():
    commands, places, mutations, seed = options(sys.argv[1:])
    files = sorted(f for p in map(pathlib.Path, places) for f in ([p] if p.is_file() else p.rglob("*.json")))
    comparison = Comparison(commands)
    good = [f for f in files if set(comparison.compare([f], 600)[0]) == {"accepted"}]
    small = [f for f in good if f.stat().st_size < 12000]
    rng = random.Random(seed)
    with tempfile.TemporaryDirectory() as folder:
        for start in range(0, mutations if small else 0, 250):
            paths = [pathlib.Path(folder) / f"mutation-{start + k}.json" for k in range(min(250, mutations - start))]
            for path in paths:
                certificate = json.loads(rng.choice(small).read_text())
                mutate(certificate, rng)
                path.write_text(canonical(certificate) + "\n")
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
