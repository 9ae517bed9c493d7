#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: example, from points in a text file to a whole mesh.
"""usage: reconstruct.py POINTS.xyz MESH.obj       lines of x y z, whatever follows"""
import sys

import numpy as np
import pclsurfacerepair as psr


def write_obj(path, mesh):
    with open(path, "w", encoding="ascii") as file:
        np.savetxt(file, mesh.points, "v %.9g %.9g %.9g")
        np.savetxt(file, mesh.triangles + 1, "f %d %d %d")


def main(source, target):
    points = np.loadtxt(source, usecols=(0, 1, 2))
    mesh = psr.reconstruct(points)
    print(f"{source}: {len(points)} points, {len(mesh.triangles)} triangles, "
          f"outer side by {mesh.report.outer_side_by}")
    whole, report = psr.repair(mesh)
    write_obj(target, whole)
    print(f"{target}: {report.verdict}")
    if not report.complete:
        print(report.what_is_missing, file=sys.stderr)
    return 0 if report.complete else 2


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]) if len(sys.argv) == 3 else __doc__)
