#!/usr/bin/env python3
"""Replaces each `check_*` of the kernel by success, one at a time, builds the
verifier, and demands that some file of tests/certificates then gets a wrong
answer. Works on a copy; `python3 tests/sabotage.py`, some minutes. With names of
checks only these: `python3 tests/sabotage.py check_inside check_boundary`.
"""
import glob
import os
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
CHECK = re.compile(r"fn (check_\w+)[^{;]*-> Result<\(\), Refusal> \{")


def build(tree):
    command = ["cargo", "build", "--quiet", "--package", "acutile-format1"]
    environment = dict(os.environ, CARGO_TARGET_DIR=os.path.join(ROOT, "target", "sabotage"), RUSTFLAGS="-Awarnings")
    subprocess.run(command, cwd=tree, env=environment, check=True)
    return os.path.join(ROOT, "target", "sabotage", "debug", "acutile-verify")


def wrong_answers(program):
    """The files that do not get the answer that their names demand."""
    wrong = []
    for path in sorted(glob.glob(os.path.join(ROOT, "tests", "certificates", "*", "*.json"))):
        folder, name = path.split(os.sep)[-2:]
        name = name.removesuffix(".json")
        expected = ": verified: " if folder == "valid" else f" [{name.split('--')[0]}] "
        limit = re.search(r"--limit-(\w+)-(\d+)$", name)
        options = [f"--limit-{limit[1]}", limit[2]] if limit else []
        answer = subprocess.run([program, *options, path], capture_output=True, text=True, timeout=600).stdout
        if expected not in answer:
            wrong.append((f"{folder}/{name}", "verified" if ": verified: " in answer else "other"))
    return wrong


def main():
    failures, chosen = [], sys.argv[1:]
    with tempfile.TemporaryDirectory() as tree:
        for part in ("Cargo.toml", "Cargo.lock", "src", "crates", "benches", "tests/main.rs"):
            source, target = os.path.join(ROOT, part), os.path.join(tree, part)
            if os.path.isdir(source):
                shutil.copytree(source, target)
            elif os.path.exists(source):
                os.makedirs(os.path.dirname(target), exist_ok=True)
                shutil.copy(source, target)
        assert not wrong_answers(build(tree)), "the kernel itself answers wrongly"
        count = 0
        for path in sorted(glob.glob(os.path.join(tree, "crates", "format1", "src", "verifier", "*.rs"))):
            with open(path) as file:
                text = file.read()
            for match in CHECK.finditer(text):
                if chosen and match[1] not in chosen:
                    continue
                count += 1
                with open(path, "w") as file:
                    file.write(text[:match.end()] + " return Ok(());" + text[match.end():])
                wrong = wrong_answers(build(tree))
                accepted = sum(answer == "verified" for _, answer in wrong)
                print(f"{match[1]}: {len(wrong)} wrong answers, {accepted} of them acceptances", flush=True)
                if not wrong:
                    failures.append(match[1])
            with open(path, "w") as file:
                file.write(text)
    print(f"{count} checks; without effect: {failures or 'none'}")
    return 1 if failures or count < (len(chosen) or 42) else 0


if __name__ == "__main__":
    sys.exit(main())
