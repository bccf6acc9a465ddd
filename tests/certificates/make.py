#!/usr/bin/env python3
"""Writes the certificates of this folder: `python3 make.py`, needs Python 3 alone.

A second implementation, which shares no code with the program. It writes canonical JSON from
docs/format.md, finds Delaunay tetrahedra by trying all quadruples of near points, and computes
exact bounds in number fields. README.md says what each file is for.
"""
import os
import sys

from source.check import code_of
from source.encode import to_json
from source.declined import DECLINED
from source.false import FALSE
from source.malformed import MALFORMED
from source.patches import PATCHES_DECLINED, PATCHES_FALSE, PATCHES_MALFORMED, PATCHES_VALID
from source.valid import VALID

HERE = os.path.dirname(os.path.abspath(__file__))


def write(folder, files):
    path = os.path.join(HERE, folder)
    os.makedirs(path, exist_ok=True)
    for name in os.listdir(path):
        os.remove(os.path.join(path, name))
    for name, content in files.items():
        with open(os.path.join(path, name + ".json"), "wb") as file:
            file.write(content if isinstance(content, bytes) else to_json(content))


def check(folder, files):
    """Compares the slow checker's answers with the names; files with a limit, and patches, are left out."""
    for name, content in files.items():
        data = content if isinstance(content, bytes) else to_json(content)
        code, expected = code_of(data), None if folder == "valid" else name.split("--")[0]
        is_checked = "--limit-" not in name and b'"kind":"patches"' not in data
        if code != expected and is_checked:
            print(f"{folder}/{name}: {code}")


FOLDERS = {
    "valid": {**VALID, **PATCHES_VALID}, "malformed": {**MALFORMED, **PATCHES_MALFORMED},
    "false": {**FALSE, **PATCHES_FALSE}, "declined": {**DECLINED, **PATCHES_DECLINED}}

if __name__ == "__main__":
    for folder, files in FOLDERS.items():
        if "--check" not in sys.argv:
            write(folder, files)
        elif folder in sys.argv or len(sys.argv) == 2:
            check(folder, files)
