#!/usr/bin/env python3
"""Writes the certificates of this folder: `python3 make.py`, needs Python 3 alone.

A second implementation, which shares no code with the program. It writes canonical JSON from
docs/format.md, finds Delaunay tetrahedra by trying all quadruples of near points, and computes
exact bounds in number fields. README.md says what each file is for.
"""
import os
import sys

from source.check import code_of
from source.check_family import codes_of
from source.contracted import CONTRACTED_FALSE, CONTRACTED_VALID
from source.encode import to_json
from source.declined import DECLINED
from source.declined_families import DECLINED_FAMILIES, FALSE_BUT_DECLINED as UNSEEN
from source.factors import FACTORS_DECLINED, FACTORS_FALSE, FACTORS_MALFORMED, FACTORS_VALID
from source.false import FALSE
from source.false_families import FALSE_FAMILIES
from source.false_patches import DECLINED_PATCHES, FALSE_PATCHES, MALFORMED_PATCHES
from source.malformed import MALFORMED
from source.malformed_families import MALFORMED_FAMILIES
from source.patch_systems import PATCHES_DECLINED, PATCHES_FALSE, PATCHES_MALFORMED, PATCHES_VALID
from source.valid import VALID
from source.valid_families import VALID_FAMILIES
from source.valid_patches import VALID_PATCHES

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


def check_families(folder, files):
    """
    Families in many points: valid ones are true in all of them, false ones have the fault in some of them. Of those
    whose signs are undecided all but the last ones are true.
    """
    for name, content in files.items():
        data = content if isinstance(content, bytes) else to_json(content)
        codes = codes_of(data) if b'"kind":"family"' in data else {code_of(data)}
        code = name.split("--")[0]
        is_true = folder == "valid" or (code == "sign-undecided" and name not in FALSE_BUT_DECLINED)
        is_right = codes == {None} if is_true else code in codes or name in FALSE_BUT_DECLINED
        if not is_right and "--limit-" not in name:
            print(f"{folder}/{name}: {codes}")


FOLDERS = {
    "valid": {**VALID, **PATCHES_VALID, **CONTRACTED_VALID}, "malformed": {**MALFORMED, **PATCHES_MALFORMED},
    "false": {**FALSE, **PATCHES_FALSE, **CONTRACTED_FALSE}, "declined": {**DECLINED, **PATCHES_DECLINED}}
FAMILIES = {
    "valid": {**VALID_FAMILIES, **FACTORS_VALID}, "malformed": {**MALFORMED_FAMILIES, **FACTORS_MALFORMED},
    "false": {**FALSE_FAMILIES, **FACTORS_FALSE}, "declined": {**DECLINED_FAMILIES, **FACTORS_DECLINED}}
FALSE_BUT_DECLINED = {**UNSEEN, **FACTORS_DECLINED}
PATCHES = {"valid": VALID_PATCHES, "malformed": MALFORMED_PATCHES, "false": FALSE_PATCHES, "declined": DECLINED_PATCHES}

if __name__ == "__main__":
    for folder, files in FOLDERS.items():
        if "--check" not in sys.argv:
            write(folder, {**files, **FAMILIES[folder], **PATCHES[folder]})
        elif folder in sys.argv or len(sys.argv) == 2:
            check(folder, files)
            check_families(folder, FAMILIES[folder])
