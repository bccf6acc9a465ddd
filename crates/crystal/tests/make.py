#!/usr/bin/env python3
"""Writes settings.tsv and changes.tsv: groups of gemmi, for the tests of Hall symbols and settings.

Each line of settings.tsv has the number, the extended Hermann-Mauguin symbol, the Hall symbol, the number of
operations and a hash of them that does not depend on their order. Each line of changes.tsv has a Hall symbol with a
change of basis, the number of operations and the hash; or "none" where the new basis vectors are no
lattice vectors, or a rotation is not integral. Needs gemmi (0.7).
"""
import itertools
from fractions import Fraction

import gemmi

MODULUS = 1 << 63


def code(operation):
    value = 0
    for entry in [e // 24 for row in operation.rot for e in row] + [t % 24 for t in operation.tran]:
        value = (value * 1000003 + entry + 7) % MODULUS
    return value


def line(hall):
    operations = list(gemmi.symops_from_hall(hall))
    total = sum(code(operation) for operation in operations) % MODULUS
    return f"{len(operations)}\t{total}"


BASES = ["P 2yb", "-C 2yc", "P 31 2\"", "R 3", "-R 3 2\"", "F 4d 2 3 -1d", "-I 4 2 3", "-P 4n 2 3", "P 4w 2c", "A 2 -2ac"]
CHANGES = ["y,z,x", "z,x,y", "-y,x,z", "x-y,x+y,z", "1/2*x-1/2*y,1/2*x+1/2*y,z", "x+1/4,y-1/8,z", "x,y+z,z",
           "-x+y+z,x-y+z,x+y-z", "1/2*y+1/2*z,1/2*x+1/2*z,1/2*x+1/2*y", "2/3*x-1/3*y-1/3*z,1/3*x+1/3*y-2/3*z,1/3*x+1/3*y+1/3*z",
           "x-z,y-z,x+y+z", "2*x,y,z", "1/2*x,y,z", "x,y,z-1/12"]


def is_consistent(base, change):
    matrix = [[Fraction(e, 24) for e in row] for row in gemmi.Op(change).rot]
    (a, b, c), (d, e, f), (g, h, i) = matrix
    det = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    cofactors = [[e * i - f * h, c * h - b * i, b * f - c * e], [f * g - d * i, a * i - c * g, c * d - a * f],
                 [d * h - e * g, b * g - a * h, a * e - b * d]]
    inverse = [[x / det for x in row] for row in cofactors]
    operations = gemmi.symops_from_hall(base)
    centrings = {tuple(Fraction(t % 24, 24) for t in vector) for vector in operations.cen_ops}
    if any(tuple(inverse[k][j] % 1 for k in range(3)) not in centrings for j in range(3)):
        return False

    def times(p, q):
        return [[sum(p[r][k] * q[k][s] for k in range(3)) for s in range(3)] for r in range(3)]

    rotations = [[[Fraction(x, 24) for x in row] for row in op.rot] for op in operations.sym_ops]
    images = [times(times(matrix, rotation), inverse) for rotation in rotations]
    return all(x.denominator == 1 for image in images for row in image for x in row)


def write(name, lines):
    with open(__file__.replace("make.py", name), "w") as table:
        table.writelines(text + "\n" for text in lines)


write("settings.tsv", (f"{g.number}\t{g.xhm()}\t{g.hall}\t{line(g.hall)}" for g in gemmi.spacegroup_table()))
write("changes.tsv", (f"{base} ({change})\t{line(f'{base} ({change})') if is_consistent(base, change) else 'none'}"
                      for base, change in itertools.product(BASES, CHANGES)))
