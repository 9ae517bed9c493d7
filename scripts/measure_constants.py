#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: what half and twice a tuning constant do to the results.
#
# usage: measure_constants.py CLOSED_MESH CLOSED_MESH MESH...     PLY
#
# Builds a copy of the sources in build/constants in which constants can be scaled. With one
# after the other at half and at twice its value it reconstructs the points of the two closed
# meshes, repairs these after damage of three kinds, and repairs the other meshes as they are.
# Each constant gets a row of doc/constants.csv (rows that are there are kept): file, name,
# value, the results that differ with half and with twice of it, of how many results.

import csv
import os
import re
import subprocess
import sys

import make_constants

TABLE = "doc/constants.csv"
TREE = "build/constants"
BIN = f"{TREE}/build/release/bin"
LOOK_UP = """#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>
#include <type_traits>
namespace psr_constants {
template <typename T> T scaled(const char* key, T value) {
  const char* const one = std::getenv("PSR_CONSTANT");
  if (one == nullptr || std::strcmp(one, key) != 0)
    return value;
  const double factor = std::atof(std::getenv("PSR_FACTOR"));
  if constexpr (std::is_integral_v<T>)
    return value == 1 && factor < 1 ? T{1} : static_cast<T>(std::llround(factor * value));
  else
    return static_cast<T>(factor * value);
}
}
"""


DEFINITION = r"(inline |static )?constexpr ((?!std::array)[\w:]+(?: int)?)\s+(%s) = ?([^;{}]*);"
PROGRAMS = ("pcl_repair_holes", "pcl_ccaa_reconstruct", "pcl_damage_cloud")
DAMAGES = (("slabs", 2, "slab", 0.06),
           ("spheres", 5, "sphere", 0.08),
           ("patches", 5, "patch", 0.03))


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def write_if_new(path, text):
    if not os.path.exists(path) or read(path) != text:
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)


def looked_up(path, names):
    """The text of a file in which these constants are looked up."""
    def change(found):
        keyword, kind, name, value = found.groups()
        return (f"{'inline ' if keyword else ''}static const {kind} {name} = "
                f'psr_constants::scaled<{kind}>("{path}:{name}", {value});')
    return re.sub(DEFINITION % "|".join(names), change, read(path)) if names else read(path)


def build(keys):
    """The programs; constants that the compiler needs to know stay as they are.
    \return keys of the others"""
    paths = {path for path, _ in keys}
    sizes = "".join(re.findall(r"std::array<[^;()]*>|\[[A-Z_]+\]", "".join(map(read, paths))))
    keys = [(path, name) for path, name in keys
            if re.search(DEFINITION % name, read(path)) and not re.search(rf"\b{name}\b", sizes)]
    os.makedirs(TREE, exist_ok=True)
    if not os.path.exists(f"{TREE}/CMakeLists.txt"):
        subprocess.check_call(f"git archive HEAD | tar x -m -C {TREE}", shell=True)
    write_if_new(f"{TREE}/scaled.h", LOOK_UP)
    subprocess.check_call(["cmake", "--preset", "release", "-DPSR_BUILD_TESTS=OFF",
                           f"-DCMAKE_CXX_FLAGS=-include {os.path.abspath(TREE)}/scaled.h -w"],
                          cwd=TREE, stdout=subprocess.DEVNULL)
    while True:
        for path in paths:
            write_if_new(f"{TREE}/{path}", looked_up(path, [n for p, n in keys if p == path]))
        told = subprocess.run(["cmake", "--build", "--preset", "release", "--target", *PROGRAMS,
                               "--", "-k", "0"],
                              cwd=TREE, stdout=subprocess.PIPE, text=True, check=False)
        if told.returncode == 0:
            return keys
        needed = re.findall(r"‘(?:\w+::)*(?:\{anonymous\}::)?([A-Z][A-Z0-9_]+)’", told.stdout)
        if not any(name in needed for _, name in keys):
            sys.exit("\n".join(re.findall(r".* error: .*", told.stdout)))
        keys = [key for key in keys if key[1] not in needed]


def run(program, options, key="", factor=1.0):
    env = dict(os.environ, PSR_CONSTANT=key, PSR_FACTOR=str(factor))
    subprocess.run([f"{BIN}/{program}", *options, "--quiet", "--force"], env=env, check=False,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=600)


def result(task, key="", factor=1.0):
    """The bytes of the output; none where there is none."""
    program, path = task
    out = f"{TREE}/out.ply"
    if os.path.exists(out):
        os.remove(out)
    run(program, [path, out, "--threads", "1"], key, factor)
    with open(out if os.path.exists(out) else os.devnull, "rb") as mesh:
        return mesh.read()


def tasks_of(closed_mesh):
    """What is done with it: program and input."""
    yield "pcl_ccaa_reconstruct", closed_mesh
    for damages, count, damage, size in DAMAGES:
        path = f"{TREE}/{os.path.basename(closed_mesh)}-{damage}.ply"
        run("pcl_damage_cloud",
            [closed_mesh, path, f"--{damages}", str(count), f"--{damage}-size", str(size)])
        yield "pcl_repair_holes", path


def main():
    meshes = [os.path.abspath(mesh) for mesh in sys.argv[1:]]
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    values = {(path, name): value for room in make_constants.rooms()
              for path, name, value, _ in make_constants.constants_in(room)
              if not name.endswith("_WORK")}
    keys = build(list(values))
    tasks = [task for mesh in meshes[:2] for task in tasks_of(mesh)]
    tasks += [("pcl_repair_holes", mesh) for mesh in meshes[2:]]
    plain = [result(task) for task in tasks]
    known = make_constants.measured()
    for path, name in keys:
        row = [os.path.basename(path), name, values[path, name]]
        if tuple(row) in known:
            continue
        for factor in (0.5, 2.0):
            row.append(sum(result(task, f"{path}:{name}", factor) != before
                           for task, before in zip(tasks, plain)))
        with open(TABLE, "a", encoding="utf-8", newline="") as out:
            csv.writer(out, lineterminator="\n").writerow([*row, len(tasks)])


if __name__ == "__main__":
    main()
