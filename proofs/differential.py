#!/usr/bin/env python3
"""The extracted checker against acutile-verify, on files and on random mutations.

usage: differential.py VERIFY COQ_CHECK [--mutations N] [--seed S] FILE|FOLDER...

A file is a disagreement when one program accepts it and the other rejects it (exit
codes 0 and 1). An answer "declined" (3) is compatible with everything: the programs
have different limits. Dimension 2 is declined by the extracted checker. Files whose
name sets a limit of acutile-verify are checked under its default limits here.
Exit code 1 if there is a disagreement, or if nothing was accepted or rejected.
"""
import collections, json, pathlib, random, subprocess, sys, tempfile


def answer(program, path):
    try:
        return subprocess.run([program, str(path)], capture_output=True, timeout=120).returncode
    except subprocess.TimeoutExpired:
        return 3


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


def mutate(certificate, rng):
    """One field changed, or two of a kind exchanged."""
    paths = [p for p in leaves(certificate) if p[0] in ("claim", "witness")]
    path = rng.choice(paths)
    holder = certificate
    for key in path[:-1]:
        holder = holder[key]
    old = holder[path[-1]]
    if isinstance(old, int):
        holder[path[-1]] = old + rng.choice([-2, -1, 1, 2])
    elif old and old.lstrip("-")[:1].isdigit():
        p, _, q = old.partition("/")
        choices = [str(int(p) + rng.choice([-1, 1])) + ("/" + q if q else ""), "0", "-" + old.lstrip("-"), old.lstrip("-")]
        holder[path[-1]] = rng.choice(choices)
    else:
        holder[path[-1]] = rng.choice(["acute", "nonobtuse", "Delaunay", "weakly Delaunay", "space", "Q"])
    simplices = certificate["witness"]["simplices"]
    if rng.random() < 0.2 and simplices and len(simplices[0]) > 1:
        row = rng.choice(simplices)
        i, j = rng.sample(range(len(row)), 2)
        row[i], row[j] = row[j], row[i]


def main():
    arguments, options = [], {"--mutations": 0, "--seed": 1}
    words = iter(sys.argv[1:])
    for word in words:
        if word in options:
            options[word] = int(next(words))
        else:
            arguments.append(word)
    if len(arguments) < 3:
        sys.exit(__doc__)
    verify, coq, *places = arguments
    files = sorted(f for p in map(pathlib.Path, places) for f in ([p] if p.is_file() else p.rglob("*.json")))
    tally, bad = collections.Counter(), []

    def compare(path, name):
        pair = answer(verify, path), answer(coq, path)
        tally[pair] += 1
        if set(pair) == {0, 1} or not set(pair) <= {0, 1, 2, 3}:
            bad.append((name, pair))
            print("DISAGREE", name, pair, flush=True)
        return pair

    good = [f for f in files if compare(f, f) == (0, 0)]
    rng = random.Random(options["--seed"])
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "mutant.json"
        for k in range(options["--mutations"] if good else 0):
            certificate = json.loads(rng.choice(good).read_text())
            mutate(certificate, rng)
            text = canonical(certificate) + "\n"
            path.write_text(text)
            before = len(bad)
            compare(path, f"mutation {k}")
            if len(bad) > before:
                pathlib.Path(f"disagreement-{k}.json").write_text(text)
    for (v, c), n in sorted(tally.items()):
        print(f"acutile-verify {v}, extracted checker {c}: {n} files")
    accepted, rejected = tally[(0, 0)], tally[(1, 1)]
    print(f"{len(files)} files, {options['--mutations']} mutations, {len(bad)} disagreements")
    sys.exit(1 if bad or not accepted or not rejected else 0)


main()
