#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: what it costs to call the libraries from Python.
"""usage: python_overhead.py PROGRAMS [POINTS [RUNS]]      with the package in PYTHONPATH

Prints medians: seconds of a call in Python, of the C++ call within it, and of the steps that the C++
program tells of the same cloud; then the share by which Python is above either.
"""
import json
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import pclsurfacerepair as psr


def sphere(points):
    k = np.arange(points)
    z = 1 - (2 * k + 1) / points
    r = np.sqrt(1 - z * z)
    a = 2.39996323 * k
    return np.c_[r * np.cos(a), r * np.sin(a), z][z < 0.99].astype(np.float32)


def write_pcd(path, points):
    with open(path, "wb") as file:
        file.write((f"VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
                    f"WIDTH {len(points)}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n"
                    f"POINTS {len(points)}\nDATA binary\n").encode())
        points.tofile(file)


def program_seconds(folder, program, source, target):
    report = folder / "report.json"
    subprocess.run([program, source, target, "--quiet", "--report", report], check=True)
    return json.loads(report.read_text())["seconds"]


def timed(function, *arguments):
    begin = time.perf_counter()
    result = function(*arguments)
    return time.perf_counter() - begin, result


def one_round(folder, programs, points):
    """Seconds of (Python, C++ call within it, steps of the C++ program) of both functions."""
    mesh_file = folder / "mesh.ply"
    by_program = program_seconds(folder, programs / "pcl_ccaa_reconstruct", folder / "cloud.pcd",
                                 mesh_file)
    seconds, mesh = timed(psr.reconstruct, points)
    yield "reconstruct", seconds, mesh.report.call_seconds, by_program
    by_program = program_seconds(folder, programs / "pcl_repair_holes", mesh_file,
                                 folder / "whole.ply")
    seconds, (_, report) = timed(psr.repair, mesh)
    yield "repair", seconds, report.call_seconds, by_program


def main(programs, points=1_000_000, runs=7):
    cloud = sphere(int(points))
    rows = {"reconstruct": [], "repair": []}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        write_pcd(folder / "cloud.pcd", cloud)
        for _ in range(int(runs)):
            for function, *seconds in one_round(folder, Path(programs), cloud):
                rows[function].append(seconds)
    print("              Python   C++ call  C++ program  over it  over the program")
    for function, seconds in rows.items():
        own = statistics.median(row[0] / row[1] - 1 for row in seconds)
        other = statistics.median(row[0] / row[2] - 1 for row in seconds)
        medians = [statistics.median(column) for column in zip(*seconds)]
        print(f"{function:12} {medians[0]:7.3f} {medians[1]:10.3f} {medians[2]:12.3f} "
              f"{own:8.1%} {other:17.1%}")


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]) if len(sys.argv) > 1 else __doc__)
