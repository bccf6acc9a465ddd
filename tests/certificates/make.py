#!/usr/bin/env python3
"""Writes the certificates of this folder: `python3 make.py`, needs Python 3 alone.

A second implementation, which shares no code with the program. It writes canonical JSON from
docs/format.md, finds Delaunay tetrahedra by trying all quadruples of near points, and computes
exact bounds in number fields. README.md says what each file is for.
"""
import os

from source.encode import to_json
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


if __name__ == "__main__":
    for folder, files in (("valid", VALID),):
        write(folder, files)
