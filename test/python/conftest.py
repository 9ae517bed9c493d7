# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: what the tests of the Python package share.
"""Clouds, PLY files, and the C++ programs whose results are compared with."""
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

PROGRAMS = Path(os.environ.get("PSR_PROGRAMS", "build/release/bin"))
SHARED_DATA = Path(__file__).resolve().parents[3] / "shared" / "data"
PLY_TYPES = {"float": "f4", "double": "f8", "uchar": "u1", "int": "i4", "uint": "u4",
             "float32": "f4", "float64": "f8", "uint8": "u1", "int32": "i4"}


def sphere(points=4000, holes=1, dtype=np.float32):
    """Points of a unit sphere, without up to two caps."""
    k = np.arange(points)
    z = 1 - (2 * k + 1) / points
    r = np.sqrt(1 - z * z)
    a = 2.39996323 * k
    cloud = np.c_[r * np.cos(a), r * np.sin(a), z]
    kept = ((z < 0.95) | (holes < 1)) & ((z > -0.95) | (holes < 2))
    return cloud[kept].astype(dtype)


def terrain(points=80):
    """A hilly square of about 100 metres in map coordinates."""
    x, y = np.meshgrid(np.linspace(0, 100, points), np.linspace(0, 100, points))
    jitter = np.random.default_rng(1).uniform(-0.2, 0.2, (3, points * points))
    z = 5 * np.sin(x / 20) * np.cos(y / 15)
    return (np.c_[x.ravel(), y.ravel(), z.ravel()] + jitter.T
            + [461234.5, 5481234.25, 312.125])


def write_ply(path, points, triangles=None, normals=None, colors=None):
    kind = "double" if points.dtype == np.float64 else "float"
    columns = [(name, kind, points[:, i]) for i, name in enumerate("xyz")]
    if normals is not None:
        columns += [(name, "float", normals[:, i]) for i, name in enumerate(["nx", "ny", "nz"])]
    if colors is not None:
        columns += [(name, "uchar", colors[:, i]) for i, name in enumerate(["red", "green", "blue"])]
    table = np.empty(len(points), [(name, PLY_TYPES[kind]) for name, kind, _ in columns])
    for name, _, values in columns:
        table[name] = values
    lines = ["ply", "format binary_little_endian 1.0", f"element vertex {len(points)}"]
    lines += [f"property {kind} {name}" for name, kind, _ in columns]
    faces = np.empty(0 if triangles is None else len(triangles), [("n", "u1"), ("v", "i4", 3)])
    if triangles is not None:
        faces["n"], faces["v"] = 3, triangles
        lines += [f"element face {len(faces)}", "property list uchar int vertex_indices"]
    with open(path, "wb") as file:
        file.write(("\n".join(lines) + "\nend_header\n").encode())
        table.tofile(file)
        faces.tofile(file)
    return path


def read_ply(path):
    """Vertices as a table, triangles, and the labels of the faces, if there are any."""
    data = Path(path).read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    elements = []
    for words in (line.split() for line in data[:end].decode().splitlines()):
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property" and words[1] == "list":
            elements[-1][2].extend([("n", PLY_TYPES[words[2]]), ("v", PLY_TYPES[words[3]], 3)])
        elif words[0] == "property":
            elements[-1][2].append((words[2], PLY_TYPES[words[1]]))
    tables = {}
    for name, count, columns in elements:
        tables[name] = np.frombuffer(data, columns, count, end)
        end += tables[name].nbytes
    faces = tables["face"]
    labels = [faces[name] for name in faces.dtype.names if name not in ("n", "v")]
    return tables["vertex"], faces["v"], labels[0] if labels else None


def triples(table, names="xyz"):
    return np.stack([table[name] for name in names], axis=1)


def run(program, *arguments):
    """Run a program; 2 says that something was left open."""
    done = subprocess.run([PROGRAMS / program, *map(str, arguments), "--quiet"],
                          capture_output=True, text=True)
    assert done.returncode in (0, 2), done.stderr


@pytest.fixture
def bunny():
    """Points and triangles of a scan with five holes and free points."""
    file = SHARED_DATA / "bunny" / "bun_zipper.ply"
    if not file.exists():
        pytest.skip(f"no {file.name} in the shared data")
    vertices, triangles, _ = read_ply(file)
    return triples(vertices), triangles
