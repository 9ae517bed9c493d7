# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: runs from Python: threads, progress, Ctrl-C, the interpreter's lock.
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
from conftest import sphere

import pclsurfacerepair as psr


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_any_number_of_threads_gives_the_same_bits(threads):
    mesh = psr.reconstruct(sphere(20000), threads=threads)
    whole, _ = psr.repair(mesh, threads=threads)
    expected, _ = psr.repair(psr.reconstruct(sphere(20000)))
    assert whole.points.tobytes() == expected.points.tobytes()
    assert np.array_equal(whole.triangles, expected.triangles)


def test_other_threads_of_python_go_on_during_a_run():
    counted = []
    finished = threading.Event()

    def count():
        while not finished.wait(0.001):
            counted.append(1)
    counter = threading.Thread(target=count)
    counter.start()
    before = len(counted)
    psr.reconstruct(sphere(100000), threads=1)
    during = len(counted) - before
    finished.set()
    counter.join()
    assert during > 20


def test_several_threads_of_python_may_run_at_once():
    results = [None] * 3

    def work(number):
        results[number] = psr.repair(psr.reconstruct(sphere(5000), threads=1), threads=1)[0]
    workers = [threading.Thread(target=work, args=[number]) for number in range(len(results))]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert len({result.points.tobytes() for result in results}) == 1


@pytest.mark.parametrize("function", ["reconstruct", "repair", "umbrella_filter",
                                      "classify_boundaries", "mesh_quality", "propose_decisions"])
def test_progress_tells_stages_and_shares(function):
    mesh = psr.reconstruct(sphere(20000))
    told = []
    getattr(psr, function)(mesh.points if function == "reconstruct" else mesh,
                           progress=lambda stage, share: told.append((stage, share)))
    assert told and all(stage and 0 <= share <= 1 for stage, share in told)


def test_a_bar_is_moved_and_named():
    class Bar:
        total, n, names = 100, 0.0, set()

        def update(self, amount):
            self.n += amount

        def set_description(self, name, refresh):
            self.names.add(name)
    bar = Bar()
    psr.reconstruct(sphere(), progress=bar)
    assert bar.n == pytest.approx(100) and len(bar.names) > 2


def test_a_bar_of_tqdm_will_do(capsys):
    tqdm = pytest.importorskip("tqdm")
    psr.reconstruct(sphere(), progress=tqdm.tqdm(total=1))
    psr.reconstruct(sphere(), progress=True)
    assert "base" in capsys.readouterr().err


def test_false_from_progress_cancels():
    with pytest.raises(psr.Cancelled, match="returned False during 'start"):
        psr.reconstruct(sphere(), progress=lambda stage, share: False)


def test_what_progress_raises_comes_out_of_the_run():
    def progress(stage, share):
        raise LookupError(stage)
    with pytest.raises(LookupError, match="reading"):
        psr.repair(psr.reconstruct(sphere()), progress=progress)


def test_nothing_is_printed_below_python(capfd):
    with pytest.raises(ValueError):
        psr.reconstruct(np.zeros((2, 3)))
    assert capfd.readouterr() == ("", "")


def test_ctrl_c_stops_a_run_soon():
    code = """
import numpy as np, pclsurfacerepair as psr, time
points = np.random.default_rng(1).random((3_000_000, 3)).astype(np.float32)
print("begun", flush=True)
try:
    psr.reconstruct(points)
except KeyboardInterrupt:
    print("stopped", time.monotonic(), flush=True)
"""
    process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "begun\n"
    time.sleep(1.5)
    process.send_signal(signal.SIGINT)
    pressed = time.monotonic()
    word, moment = process.stdout.readline().split()
    assert word == "stopped" and float(moment) - pressed < 3
    assert process.wait() == 0
