#!/usr/bin/env python3
"""Writes the CIF files of this folder: prototype parameters from the literature, and the list of
symmetry operations from gemmi (M. Wojdyr, J. Open Source Softw. 7 (2022) 4200), a program that
shares nothing with ours.

    python3 -m venv ENV && ENV/bin/pip install gemmi==0.7.5
    ENV/bin/python tests/cif/make.py

It also counts the atoms of each cell, with gemmi's own expansion of the sites on the special
positions that the fractions meant here lie on, and stops where a count is not that of the literature.
"""
from fractions import Fraction
from pathlib import Path

import gemmi

HERE = Path(__file__).parent

# name: (source, group, extended symbol, cell, sites, atoms in a cell)
# Sites: label, x, y, z as written.
STRUCTURES = {
    "a15": (
        "Cr3Si: B. Boren, Ark. Kemi Mineral. Geol. 11A (1933) 1-28; Strukturbericht A15",
        "P m -3 n", (4.564, 4.564, 4.564, 90, 90, 90),
        [("Si1", "0", "0", "0"), ("Cr1", "0.25", "0", "0.5")], 8),
    "sigma": (
        "FeCr, the sigma phase: structure by G. Bergman, D. P. Shoemaker, Acta Cryst. 7 (1954) 857-865; refined parameters of "
        "the AFLOW library's sigma_tP30_136_bf2ij, origin at a site; Strukturbericht D8_b",
        "P 42/m n m", (8.7966, 8.7966, 4.5582, 90, 90, 90),
        [("M1", "0", "0", "0"), ("M2", "0.39864", "0.39864", "0"), ("M3", "0.46349", "0.13122", "0"),
         ("M4", "0.73933", "0.06609", "0"), ("M5", "0.18267", "0.18267", "0.25202")], 30),
    "c15": (
        "MgCu2: J. B. Friauf, J. Am. Chem. Soc. 49 (1927) 3107-3114; Strukturbericht C15, origin at -3m",
        "F d -3 m:2", (7.034, 7.034, 7.034, 90, 90, 90),
        [("Mg1", "0.125", "0.125", "0.125"), ("Cu1", "0.5", "0.5", "0.5")], 24),
    "c14": (
        "MgZn2: structure by J. B. Friauf, Phys. Rev. 29 (1927) 34-40; refined parameters of the AFLOW library's "
        "AB2_hP12_194_f_ah; Strukturbericht C14. Thirds are written with five decimals: read with --snap 3",
        "P 63/m m c", (5.223, 5.223, 8.566, 90, 90, 120),
        [("Mg1", "0.33333", "0.66667", "0.06286"), ("Zn1", "0", "0", "0"), ("Zn2", "0.83048", "0.66096", "0.25")], 12),
    "z": (
        "Zr4Al3: C. G. Wilson, D. K. Thomas, F. J. Spooner, Acta Cryst. 13 (1960) 56-57; P6/mmm after K. Cenzual et "
        "al. (1991), the AFLOW library's A3B4_hP7_191_f_de. Thirds are written with four decimals: read with --snap 3",
        "P 6/m m m", (5.433, 5.433, 5.390, 90, 90, 120),
        [("Al1", "0.5", "0", "0"), ("Zr1", "0.3333", "0.6667", "0.5"), ("Zr2", "0", "0", "0.25")], 7),
    "mu": (
        "Co7Mo6: J. B. Forsyth, L. M. d'Alte da Veiga, Acta Cryst. 15 (1962) 543-546 (COD 2310288); type Fe7W6, "
        "Strukturbericht D8_5. Sixths are written with four decimals: read with --snap 6",
        "R -3 m:H", (4.762, 4.762, 25.615, 90, 90, 120),
        [("Co1", "0", "0", "0"), ("Mo1", "0", "0", "0.1655"), ("Mo2", "0", "0", "0.3483"),
         ("Mo3", "0", "0", "0.4518"), ("Co2", "0.8333", "0.1667", "0.2562")], 39),
    "diamond": (
        "C: W. H. Bragg, W. L. Bragg, Proc. R. Soc. A 89 (1913) 277-291; Strukturbericht A4",
        "F d -3 m:1", (3.567, 3.567, 3.567, 90, 90, 90), [("C1", "0", "0", "0")], 8),
    "bcc": (
        "W: W. P. Davey, Phys. Rev. 26 (1925) 736-738; Strukturbericht A2",
        "I m -3 m", (3.165, 3.165, 3.165, 90, 90, 90), [("W1", "0", "0", "0")], 2),
    "fcc": (
        "Cu: W. L. Bragg, Phil. Mag. 28 (1914) 355-360; Strukturbericht A1",
        "F m -3 m", (3.615, 3.615, 3.615, 90, 90, 90), [("Cu1", "0", "0", "0")], 4),
    "monoclinic": (
        "Monoclinic sulfur's cell angle with made-up positions, for an angle whose cosine is irrational",
        "P 1 21/c 1", (6.1, 7.3, 8.9, 90, "97.5(1)", 90),
        [("A1", "0.123", "0.217", "0.371"), ("A2", "0.611", "0.047", "0.155")], 8),
    "triclinic": (
        "Made-up positions in a triclinic cell, three angles whose cosines are irrational",
        "P -1", ("5.12(3)", 6.34, 7.01, 81.3, 77.7, 68.9),
        [("A1", "0.11", "0.23", "0.37"), ("A2", "0.62", "0.71", "0.04"), ("A3", "0", "0", "0.5")], 5),
}


def meant(text):
    """The sixth that a rounded decimal means, else the decimal."""
    text = text.split("(")[0]
    value = Fraction(text)
    if "." in text:
        unit = Fraction(1, 10 ** len(text.split(".")[1]))
        near = Fraction(round(value * 6), 6)
        if abs(near - value) < unit:
            return near
    return value


def atoms(group, sites):
    """The number of different images modulo 1, in exact fractions."""
    places = set()
    for _, *position in sites:
        x = [meant(text) for text in position]
        for operation in group.operations():
            image = []
            for row, shift in zip(operation.rot, operation.tran):
                entry = sum(Fraction(r, gemmi.Op.DEN) * c for r, c in zip(row, x)) + Fraction(shift, gemmi.Op.DEN)
                image.append(entry % 1)
            places.add(tuple(image))
    return len(places)


def wrapped(text, width=100):
    lines, line = [], "#"
    for word in text.split():
        if len(line) + 1 + len(word) > width:
            lines.append(line)
            line = "#"
        line += " " + word
    return "\n".join(lines + [line])


def cif(name, source, symbol, cell, sites, expected):
    group = gemmi.SpaceGroup(symbol)
    found = atoms(group, sites)
    assert found == expected, (name, found, expected)
    lines = [wrapped(source), f"data_{name}", f"_space_group_name_H-M_alt '{group.hm}'", f"_space_group_IT_number {group.number}"]
    tags = ["length_a", "length_b", "length_c", "angle_alpha", "angle_beta", "angle_gamma"]
    lines += [f"_cell_{tag} {value}" for tag, value in zip(tags, cell)]
    lines += ["loop_", "_space_group_symop_operation_xyz"]
    lines += [f"'{operation.triplet()}'" for operation in group.operations()]
    lines += ["loop_", "_atom_site_label", "_atom_site_fract_x", "_atom_site_fract_y", "_atom_site_fract_z"]
    lines += [" ".join(site) for site in sites]
    (HERE / f"{name}.cif").write_text("\n".join(lines) + "\n")


for name, structure in STRUCTURES.items():
    cif(name, *structure)
