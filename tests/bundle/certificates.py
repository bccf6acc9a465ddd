"""python3 tests/bundle/certificates.py ACUTILE_VERIFY [MUTATIONS]: crates/publish/src/bundle/verify.py against the certificates of the
tests, whose verdicts are known, those in certificates/ if there is a third argument `all`, and against acutile-verify on
certificates that are changed at random."""

import copy
import importlib.util
import json
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).parents[2]
sys.dont_write_bytecode = True
spec = importlib.util.spec_from_file_location("verify", ROOT / "crates/publish/src/bundle/verify.py")
verify = importlib.util.module_from_spec(spec)
spec.loader.exec_module(verify)

# What verify.py says it does not check, by the codes of docs/format.md.
NOTATION = {"canonical", "statements", "number", "coefficients", "shift-range", "mate-shift-range", "angle-range"}
# Limits that it has not, or that are not these. A square's circumcircle is decided where the kernel does not: over the
# reducible polynomial its own multiple of the power is the zero polynomial.
WITHOUT_LIMIT = {"too-many-bytes", "too-many-simplices", "too-many-digits", "work"}
DECIDED = {"sign-undecided--no-bisections--limit-bisections-0", "sign-undecided--square-claimed-delaunay",
           "sign-undecided--square-claimed-weakly-delaunay"}


def said(path):
    """Verdict and code; nothing but these ever leaves verify.py."""
    line, code = verify.verdict(path)
    verdict = re.match(r"(verified|rejected|malformed|declined)(?:: .*| \[([a-z-]+)\] .*)", line)
    assert verdict, f"{path}: {line}"
    assert code == {"verified": 0, "rejected": 1, "malformed": 2, "declined": 3}[verdict[1]], path
    return verdict[1], verdict[2]


def files(folder):
    found = sorted((ROOT / folder).glob("*.json"))
    assert found, folder
    return found


def is_region(path):
    return '"domain":"region"' in path.read_text()


def check_known():
    for path in files("tests/certificates/valid"):
        expected = ("declined", "region") if is_region(path) else ("verified", None)
        assert said(path) == expected, (path, said(path))
    for path in files("tests/certificates/false"):
        expected = ("declined", "region") if is_region(path) else ("rejected", path.stem.split("--")[0])
        assert said(path) == expected, (path, said(path))
    for path in files("tests/certificates/malformed"):
        verdict, _ = said(path)
        assert verdict != "verified" or path.stem.split("--")[0] in NOTATION, path
    for path in files("tests/certificates/declined"):
        verdict, _ = said(path)
        assert verdict != "verified" or path.stem.split("--")[0] in WITHOUT_LIMIT or path.stem in DECIDED, path


def places(data, at=()):
    """Every place of a JSON document."""
    yield at
    inner = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else []
    for key, value in inner:
        yield from places(value, at + (key,))


def mutated(data, chance):
    data = copy.deepcopy(data)
    at = chance.choice([place for place in places(data) if len(place) > 1])
    parent = data
    for key in at[:-1]:
        parent = parent[key]
    old = parent[at[-1]]
    odd = [None, True, 1.5, -1, 10**30, "x", "1/0", "-0", [], {}, [[]], {"slab": 3}, "Delaunay", ["1", "1"]]
    if type(old) is int and chance.random() < 0.8:
        parent[at[-1]] = old + chance.choice([-1, 1])
    elif isinstance(old, str) and re.fullmatch(r"-?[0-9]+(/[0-9]+)?", old) and chance.random() < 0.8:
        top = int(old.split("/")[0]) + chance.choice([-1, 1])
        parent[at[-1]] = "/".join([str(top)] + old.split("/")[1:])
    elif isinstance(parent, list) and chance.random() < 0.5:
        other = chance.randrange(len(parent))
        parent[at[-1]], parent[other] = parent[other], parent[at[-1]]
    else:
        parent[at[-1]] = chance.choice(odd)
    return data


def written(certificate):
    """In the canonical notation, if the shape is that of a certificate."""
    lines = []
    def write(value, depth, before, after):
        is_open = depth < 3 and isinstance(value, (dict, list)) and value
        if not is_open:
            lines.append(before + json.dumps(value, separators=(",", ":")) + after)
            return
        lines.append(before + ("{" if isinstance(value, dict) else "["))
        members = [(json.dumps(k) + ":", v) for k, v in value.items()] if isinstance(value, dict) else [("", v) for v in value]
        for n, (name, member) in enumerate(members):
            write(member, depth + 1, name, "," if n + 1 < len(members) else "")
        lines.append(("}" if isinstance(value, dict) else "]") + after)
    write(certificate, 0, "", "")
    return "\n".join(lines) + "\n"


def check_mutations(program, count, seed):
    chance = random.Random(seed)
    originals = [p for p in files("tests/certificates/valid") if not is_region(p) and p.stat().st_size < 4000]
    for path in originals:
        assert written(json.loads(path.read_text())) == path.read_text(), path
    tally = {}
    with tempfile.TemporaryDirectory() as folder:
        paths = []
        for n in range(count):
            path = Path(folder) / f"{n}.json"
            path.write_text(written(mutated(json.loads(chance.choice(originals).read_text()), chance)))
            paths.append(path)
        output = subprocess.run([program, "--json", *paths], capture_output=True, text=True).stdout
        answers = [json.loads(line) for line in output.splitlines()]
        assert len(answers) == count
        for path, answer in zip(paths, answers):
            here, code = said(path)
            there = answer["verdict"]
            tally[there, here] = tally.get((there, here), 0) + 1
            is_same = here == there and (code == answer.get("code") or there != "rejected")
            # Which defect of a malformed one is found first is not fixed here.
            is_malformed = there == "malformed" and (here != "verified" or answer["code"] in NOTATION)
            assert is_same or is_malformed, (here, code, answer, path.read_text())
    assert tally.get(("rejected", "rejected"), 0) > count // 10, tally
    print(f"{count} mutations, (acutile-verify, verify.py): {tally}")


def main(program, count="400", *rest):
    check_known()
    check_mutations(program, int(count), 1)
    for path in files("certificates") if "all" in rest else []:
        assert said(path) == ("verified", None), path
    print("verify.py agrees")


main(*sys.argv[1:])
