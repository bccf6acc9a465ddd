#!/usr/bin/env python3
"""Checkers of certificates against each other, on files and on random mutations.

usage: differential.py [--mutations N] [--seed S] [--also COMMAND] VERIFY COQ_CHECK FILE|FOLDER...

VERIFY is acutile-verify, COQ_CHECK the extracted checker, COMMAND any further one that
prints lines as acutile-verify does (its words are separated by spaces). A file is a
disagreement when one program accepts it and another refuses it: rejected, malformed.
"declined" agrees with everything, for the limits differ; what one accepts and another
declines is listed, and the share of it is bounded: at most one file in a hundred.
Files whose name sets a limit of acutile-verify are checked under its default limits.
Exit code 1 if there is a disagreement, if nothing was accepted or refused, or if too
much was declined by one program alone.
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
    """The one byte string of a certificate (docs/format.md)."""
    if isinstance(value, str):
        return json.dumps(value)
    if isinstance(value, int):
        return str(value)
    inner = depth + 1
    if isinstance(value, dict):
        items, ends = [json.dumps(k) + ":" + canonical(v, inner) for k, v in value.items()], "{}"
    else:
        items, ends = [canonical(v, inner) for v in value], "[]"
    line = "\n" if inner <= 3 else ""
    return ends[0] + line + ("," + line).join(items) + line + ends[1]


def leaves(value, path=()):
    if isinstance(value, (dict, list)):
        for key in value if isinstance(value, dict) else range(len(value)):
            yield from leaves(value[key], path + (key,))
    else:
        yield path


def entry(old, rng):
    """Another value of the same kind."""
    if isinstance(old, int):
        return old + rng.choice([-2, -1, 1, 2])
    if old and old.lstrip("-")[:1].isdigit():
        p, _, q = old.partition("/")
        return rng.choice([str(int(p) + rng.choice([-1, 1])) + ("/" + q if q else ""), "0", "-" + old.lstrip("-"), old.lstrip("-")])
    return rng.choice(["acute", "nonobtuse", "Delaunay", "weakly Delaunay", "TCP", "space", "Q"])


def mutate(certificate, rng):
    """One entry changed; or two corners, mates or faces exchanged; or a simplex left out, or there twice."""
    kind = rng.random()
    simplices, mates = certificate["witness"]["simplices"], certificate["witness"]["mates"]
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
        faces = [] if isinstance(domain, str) else next(iter(domain.values()))["faces"]
        row = rng.choice([rng.choice(simplices), rng.choice(mates), certificate["witness"]["vertices"], faces])
        if len(row) > 1:
            i, j = rng.sample(range(len(row)), 2)
            row[i], row[j] = row[j], row[i]
    else:
        i = rng.randrange(len(simplices))
        for rows in (simplices, mates):
            rows.insert(rng.randrange(len(rows) + 1), rows[i]) if kind < 0.95 else rows.pop(i)


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
    return arguments, int(chosen["--mutations"]), int(chosen["--seed"]), shlex.split(chosen["--also"])


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
            elif {"accepted", "declined"} <= set(row):
                self.alone.append(path)
                print("declined by one alone:", path, *row, flush=True)
        return list(zip(*columns))


def main():
    (verify, coq, *places), mutations, seed, also = options(sys.argv[1:])
    files = sorted(f for p in map(pathlib.Path, places) for f in ([p] if p.is_file() else p.rglob("*.json")))
    comparison = Comparison([[verify], [coq]] + ([also] if also else []))
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
