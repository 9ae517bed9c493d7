#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: the shards of a run tile by tile in one file, unconnected.
#
# usage: join_shards.py TILE_FOLDER OUTPUT.ply
import json
import sys
from pathlib import Path

import numpy as np

SIZES = {"float": "<f4", "double": "<f8", "int": "<i4", "uint": "<u4", "uchar": "u1"}


def read(path):
    """Positions and triangles of a shard."""
    head, body = path.read_bytes().split(b"end_header\n", 1)
    lines = [line.split() for line in head.decode().splitlines()]
    counts = {line[1]: int(line[2]) for line in lines if line[0] == "element"}
    row = np.dtype([(line[2], SIZES[line[1]]) for line in lines
                    if line[0] == "property" and line[1] != "list"])
    vertices = np.frombuffer(body, row, counts["vertex"])
    face = np.dtype([("count", "u1"), ("corners", "<i4", 3)])
    faces = np.frombuffer(body, face, counts["face"], vertices.nbytes)["corners"]
    return np.stack([vertices[axis] for axis in "xyz"], 1).astype("<f4"), faces


folder, output = Path(sys.argv[1]), sys.argv[2]
shards = [read(folder / shard["file"])
          for shard in json.loads((folder / "index.json").read_text())["shards"]]
first = np.cumsum([0] + [len(points) for points, _ in shards])
faces = np.concatenate([corners + start for (_, corners), start in zip(shards, first)])
table = np.empty(len(faces), [("count", "u1"), ("corners", "<i4", 3)])
table["count"], table["corners"] = 3, faces
with open(output, "wb") as file:
    file.write(f"ply\nformat binary_little_endian 1.0\nelement vertex {first[-1]}\n"
               "property float x\nproperty float y\nproperty float z\n"
               f"element face {len(faces)}\nproperty list uchar int vertex_indices\n"
               "end_header\n".encode())
    file.write(np.concatenate([points for points, _ in shards]).tobytes())
    file.write(table.tobytes())
