"""Ctrl-C in a long proof, and other threads beside it."""

import signal
import subprocess
import sys
import threading
import time

import acutile

# A shell starts programs in the background with Ctrl-C ignored, and Python leaves that so.
LONG = """
import signal
signal.signal(signal.SIGINT, signal.default_int_handler)
import acutile, numpy as np
n = 70
i, j, k = np.meshgrid(*[np.arange(n)] * 3, indexing="ij")
base = (i * (n + 1) + j) * (n + 1) + k
step = np.array([(n + 1) ** 2, n + 1, 1])
grid = np.stack(np.meshgrid(*[np.arange(n + 1.0)] * 3, indexing="ij"), -1).reshape(-1, 3)
import itertools
cells = []
for order in itertools.permutations(range(3)):
    path = np.cumsum([0] + [step[a] for a in order])
    cell = base.reshape(-1, 1) + path
    if np.linalg.det(np.diff(grid[cell[0]], axis=0)) < 0:
        cell = cell[:, [0, 1, 3, 2]]
    cells.append(cell)
print("ready", flush=True)
acutile.certify(grid, np.concatenate(cells))
print("ended", flush=True)
"""


def test_ctrl_c_ends_a_long_proof():
    process = subprocess.Popen(
        [sys.executable, "-c", LONG], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    assert process.stdout.readline() == "ready\n"
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    output, errors = process.communicate(timeout=120)
    assert "ended" not in output
    assert "KeyboardInterrupt" in errors


def test_other_threads_run_during_a_proof():
    ticks = []
    stop = threading.Event()

    def tick():
        while not stop.wait(0.001):
            ticks.append(time.monotonic())

    thread = threading.Thread(target=tick)
    thread.start()
    begin = time.monotonic()
    acutile.certify("square-14")
    end = time.monotonic()
    stop.set()
    thread.join()
    assert any(begin < t < end for t in ticks)
