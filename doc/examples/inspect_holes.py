#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: example, the holes of a mesh, of which only the small are closed.
"""usage: inspect_holes.py POINTS.xyz GREATEST_LENGTH     lines of x y z; units of the points"""
import sys

import numpy as np
import pclsurfacerepair as psr


def main(source, greatest):
    mesh = psr.reconstruct(np.loadtxt(source, usecols=(0, 1, 2)))
    for loop in psr.classify_boundaries(mesh):
        center = mesh.points[loop.points].mean(axis=0).round(3)
        print(f"{loop['class']} ({loop.confidence:.2f}): {loop.edges} edges, "
              f"length {loop.length:.3g}, around {center}")
    decisions = psr.propose_decisions(mesh)
    for loop in decisions["loops"]:
        loop["decision"] = "close" if loop["length"] <= greatest else "leave open"
    whole, report = psr.repair(mesh, decisions=decisions)
    print(f"{report.triangles.new} new triangles, {report.verdict}")
    quality = psr.mesh_quality(whole)
    print(f"area {quality.area:.4g}, smallest angle {quality.smallest_angle_degrees:.1f} degrees")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], float(sys.argv[2])) if len(sys.argv) == 3 else __doc__)
