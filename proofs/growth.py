#!/usr/bin/env python3
"""The cost of the extracted checker on supercells of A15, with all statements.

usage: growth.py ACUTILE ACUTILE_VERIFY COQ_CHECK [N...]

Writes the N x N x N supercells, 46 N^3 tetrahedra each (N = 2 4 6 8 10 without numbers), and prints a table in Markdown:
seconds of the processor, and the growth from one size to the next one, per doubling of the number of tetrahedra. The
claim that COQ_CHECK prints must be the one that ACUTILE_VERIFY prints, byte for byte. Exit code 1 if a certificate is
not proved or if a claim differs; no time decides.
"""
import math, pathlib, resource, subprocess, sys, tempfile


def supercell(acutile, n, folder):
    tiling, certificate = folder / f"{n}.json", folder / f"{n}.cbor"
    subprocess.run([acutile, "export", "a15", "--supercell", f"{n},{n},{n}", "-o", tiling], check=True)
    required = ["--require", "tiling,acute,delaunay,tcp", "--format", "cbor"]
    subprocess.run([acutile, "certify", tiling, *required, "-o", certificate], check=True, stdout=subprocess.DEVNULL)
    return certificate


def seconds(program, certificate):
    """Processor time, the least of three runs if they are short, and what the program printed."""
    best, runs = math.inf, 0
    while runs < 3 and (runs == 0 or best < 2):
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        run = subprocess.run([program, "--print-claim", certificate], capture_output=True)
        best = min(best, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before)
        runs += 1
        if run.returncode != 0:
            sys.exit(f"{certificate}: exit code {run.returncode}: {run.stdout.decode()[-200:]}")
    return best, run.stdout


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    acutile, verify, check = sys.argv[1:4]
    table = []
    with tempfile.TemporaryDirectory() as name:
        for n in map(int, sys.argv[4:] or [2, 4, 6, 8, 10]):
            certificate = supercell(acutile, n, pathlib.Path(name))
            time, claim = seconds(check, certificate)
            theirs = subprocess.run([verify, "--print-claim", certificate], capture_output=True, check=True).stdout
            if claim != theirs:
                sys.exit(f"{n}: the claims differ:\n{claim.decode()}\n{theirs.decode()}")
            table.append((46 * n ** 3, time))
    print("| tetrahedra | seconds | growth per doubling |\n|---|---|---|")
    for (t, s), before in zip(table, [None] + table):
        growth = f"{2 ** (math.log(s / before[1]) / math.log(t / before[0])):.2f}" if before else ""
        print(f"| {t:,} | {s:.2f} | {growth} |")
    (t, s), (last, end) = table[0], table[-1]
    if len(table) > 1:
        print(f"over all sizes {2 ** (math.log(end / s) / math.log(last / t)):.2f} per doubling")


main()
