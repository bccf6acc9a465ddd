"""python-flint: the test of a tetrahedron over FLINT's rationals, from Python.   rationals.py DIRECTORY

Python itself takes a part of the time, which the same text on its doubles shows.
"""

import sys
import time
from pathlib import Path

from flint import fmpq

MOST = 500


def is_acute(p):
    e = [[x - y for x, y in zip(q, p[0])] for q in p[1:]]

    def cross(a, b):
        return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

    def dot(a, b):
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]

    a, b, c = cross(e[1], e[2]), cross(e[2], e[0]), cross(e[0], e[1])
    ab, ac, bc = dot(a, b), dot(a, c), dot(b, c)
    return (
        dot(e[0], a) > 0
        and ab < 0 and ac < 0 and bc < 0
        and dot(a, a) + ab + ac > 0 and ab + dot(b, b) + bc > 0 and ac + bc + dot(c, c) > 0
    )


def seconds(rows):
    best, count = 1e300, 0
    for _ in range(3):
        start = time.process_time()
        count = sum(is_acute(row) for row in rows)
        best = min(best, time.process_time() - start)
    return best, count


def corners(words, number):
    values = [number(*(int(part) for part in word.split("/"))) for word in words]
    return [values[i : i + 3] for i in range(0, 12, 3)]


for name in ("rational-128", "rational-256"):
    lines = Path(sys.argv[1], name).read_text().splitlines()[1 : 1 + MOST]
    for program, number in (("python-flint fmpq", lambda p, q=1: fmpq(p, q)), ("doubles in Python, no proof", lambda p, q=1: p / q)):
        time_taken, count = seconds([corners(line.split(), number) for line in lines])
        print(f"@peer\t{program}\t{name}\t{len(lines)}\t{count}\t{time_taken * 1e9 / len(lines):.6g}\tns each", flush=True)
