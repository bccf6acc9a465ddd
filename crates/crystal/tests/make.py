#!/usr/bin/env python3
"""Writes settings.tsv: the groups of gemmi's tables, for the tests of Hall symbols and settings.

Each line has the number, the extended Hermann-Mauguin symbol, the Hall symbol, the number of operations and
a hash of them that does not depend on their order. Needs gemmi (0.7).
"""
import gemmi

MODULUS = 1 << 63


def code(operation):
    value = 0
    for entry in [e // 24 for row in operation.rot for e in row] + [t % 24 for t in operation.tran]:
        value = (value * 1000003 + entry + 7) % MODULUS
    return value


with open(__file__.replace("make.py", "settings.tsv"), "w") as table:
    for group in gemmi.spacegroup_table():
        operations = list(gemmi.symops_from_hall(group.hall))
        total = sum(code(operation) for operation in operations) % MODULUS
        table.write(f"{group.number}\t{group.xhm()}\t{group.hall}\t{len(operations)}\t{total}\n")
