# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: what becomes of arrays: no copies, nothing lost, bad ones refused.
import subprocess
import sys

import numpy as np
import pytest
from conftest import sphere, terrain

import pclsurfacerepair as psr

# Memory that a run has taken when it first tells of its progress: the indices of the points and
# PCL's cloud, which any run in C++ has. A further copy of the points would be 12 bytes each.
MEMORY = """
import numpy as np, pclsurfacerepair as psr, tracemalloc
points = np.random.default_rng(1).random((4_000_000, 3), np.float32)
points = np.asfortranarray(points) if {turned} else points
psr.reconstruct(points[:1000].copy())
def resident():
    return int(open("/proc/self/statm").read().split()[1]) * 4096
before = resident()
tracemalloc.start()
seen = []
def progress(stage, share):
    seen.append((resident() - before, tracemalloc.get_traced_memory()[1]))
    return False
try:
    psr.reconstruct(points, progress=progress, threads=1)
except psr.Cancelled:
    print(seen[0][0] / len(points), seen[0][1] / len(points))
"""


@pytest.mark.parametrize("turned", [False, True])
def test_points_are_not_copied_but_into_the_cloud_of_the_run(turned):
    done = subprocess.run([sys.executable, "-c", MEMORY.format(turned=turned)], check=True,
                          capture_output=True, text=True)
    resident, numpy = map(float, done.stdout.split())
    assert resident < 12 + 4 + 4  # bytes a point: cloud, indices, and less than half a copy
    assert numpy < 0.1  # what numpy itself has got


# The same of a repair: 6 bytes a triangle for the points, and none for a copy of the triangles.
REPAIR_MEMORY = """
import numpy as np, pclsurfacerepair as psr
x, y = np.meshgrid(np.arange(1000), np.arange(1000))
points = np.stack([x, y, 0 * x], -1).reshape(-1, 3).astype(np.float32)
corner = (1000 * y + x)[:-1, :-1].reshape(-1, 1)
triangles = np.vstack([corner + [0, 1, 1001], corner + [0, 1001, 1000]]).astype(np.int32)
def resident():
    return int(open("/proc/self/statm").read().split()[1]) * 4096
before = resident()
seen = []
def progress(stage, share):
    seen.append(resident() - before)
    return False
try:
    psr.repair((points, triangles), progress=progress, threads=1)
except psr.Cancelled:
    print(seen[0] / len(triangles))
"""


def test_triangles_are_read_where_they_are():
    done = subprocess.run([sys.executable, "-c", REPAIR_MEMORY], check=True, capture_output=True,
                          text=True)
    assert float(done.stdout) < 6 + 6  # less than half a copy


def test_triangles_of_a_repaired_mesh_outlive_it():
    whole, report = psr.repair(psr.reconstruct(sphere()))
    triangles, copy = whole.triangles, whole.triangles.copy()
    del whole, report
    psr.repair(psr.reconstruct(sphere(holes=2)))
    assert np.array_equal(triangles, copy) and triangles.flags.writeable


def test_quads_are_repaired_as_their_triangles():
    corner = (20 * np.arange(19)[:, None] + np.arange(19)).reshape(-1, 1)
    corner = np.delete(corner, [170, 171, 200], axis=0)
    y, x = np.divmod(np.arange(400), 20)
    points = np.stack([x, y, np.sin(0.2 * x)], -1).astype(np.float32)
    fans = np.stack([corner + [0, 1, 21], corner + [0, 21, 20]], axis=1).reshape(-1, 3)
    whole, report = psr.repair((points, corner + [0, 1, 21, 20]))
    expected, _ = psr.repair((points, fans))
    assert len(whole.triangles) > len(fans) and report.complete
    assert np.array_equal(whole.triangles, expected.triangles)
    assert whole.points.tobytes() == expected.points.tobytes()


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_the_points_of_a_mesh_are_the_array_that_was_given(dtype):
    cloud = sphere(dtype=dtype)
    assert psr.reconstruct(cloud).points is cloud


def test_the_input_is_not_changed():
    cloud = terrain()
    before = cloud.copy()
    mesh = psr.reconstruct(cloud)
    triangles = mesh.triangles.copy()
    psr.repair(mesh)
    psr.umbrella_filter(mesh)
    assert np.array_equal(cloud, before) and np.array_equal(mesh.triangles, triangles)


def test_arrays_of_a_repaired_mesh_share_the_memory_of_one_cloud():
    mesh = psr.reconstruct(sphere(), colors=np.zeros((len(sphere()), 3), np.uint8))
    whole, _ = psr.repair(mesh)
    assert np.may_share_memory(whole.points, whole.colors) and whole.points.flags.writeable


@pytest.mark.parametrize("values", [
    np.arange(6).astype(kind).reshape(shape) for shape in [(6,), (6, 1), (3, 2)]
    for kind in ["i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8", "f2", "?", ">f4"]],
    ids=lambda values: f"{values.dtype}-{values.ndim}")
def test_attributes_of_any_type_come_back_bit_for_bit(values):
    cloud = sphere()
    column = np.resize(values, (len(cloud), *values.shape[1:]))
    whole, report = psr.repair(psr.reconstruct(cloud, attributes={"x": column}))
    kept = whole.attributes["x"]
    assert report.new_vertices > 0 and kept.shape == (len(whole.points), *values.shape[1:])
    assert kept.dtype == column.dtype.newbyteorder("=")
    assert np.array_equal(kept[:len(cloud)], column) and np.isin(kept, column).all() \
        or column.dtype.kind == "f"


def test_colours_with_alpha_come_back_in_order():
    cloud = sphere()
    colors = np.random.default_rng(1).integers(0, 255, (len(cloud), 4), np.uint8)
    whole, _ = psr.repair(psr.reconstruct(cloud, colors=colors))
    assert np.array_equal(whole.colors[:len(cloud)], colors)


def test_map_coordinates_stay_as_they_are_and_new_ones_are_near_them():
    cloud = terrain()
    cloud = cloud[np.linalg.norm(cloud - cloud.mean(axis=0), axis=1) > 12]
    whole, report = psr.repair(psr.reconstruct(cloud))
    assert report.new_vertices > 0 and report.global_shift[0] > 4e5
    assert whole.points[:len(cloud)].tobytes() == cloud.tobytes()
    new = whole.points[len(cloud):]
    assert (new > cloud.min(axis=0) - 1).all() and (new < cloud.max(axis=0) + 1).all()
    assert len(np.unique(new[:, 0] % 1)) > len(new) // 2


@pytest.mark.parametrize("layout", ["rows of a table", "every second", "by columns", "list"])
def test_the_layout_of_points_changes_nothing(layout):
    cloud = sphere(1000)
    table = np.zeros(len(cloud), [("xyz", "f4", 3), ("intensity", "u1")])
    table["xyz"] = cloud
    points = {"rows of a table": table["xyz"], "every second": np.repeat(cloud, 2, axis=0)[::2],
              "by columns": np.asfortranarray(cloud), "list": cloud.tolist()}[layout]
    assert np.array_equal(psr.reconstruct(points).triangles, psr.reconstruct(cloud).triangles)


def test_points_that_are_not_finite_stay_free():
    cloud = sphere()
    cloud[7] = np.nan
    mesh = psr.reconstruct(cloud)
    assert not (mesh.triangles == 7).any() and mesh.report.usable_points == len(cloud) - 1


def test_what_a_reconstruction_leaves_in_doubt_is_told():
    ball = sphere(2000, holes=0)
    two = np.concatenate([ball, ball + np.array([2.055, 0, 0], ball.dtype)])
    report = psr.reconstruct(two).report
    assert not report.complete and "TOUCHING_PIECES" in report.verdict
    first, second = report.doubts[0].points
    assert first < 2000 <= second and f"one is at point {first})" in report.what_is_missing


@pytest.mark.parametrize("make, message", [
    (lambda: psr.reconstruct(np.zeros((5, 2))), r"points must be numbers of shape \(N, 3\)"),
    (lambda: psr.reconstruct([["a"] * 3]), "points must be numbers"),
    (lambda: psr.reconstruct(sphere(), sphere()[:5]), "attribute 'normals' must be numbers"),
    (lambda: psr.reconstruct(sphere(), until="end"), "until must be 'start'"),
    (lambda: psr.reconstruct(np.zeros((2, 3))), "ConsecutiveReconstruction.*2 usable points"),
    (lambda: psr.reconstruct(np.zeros((0, 3))), "0 usable points"),
    (lambda: psr.repair(psr.Mesh(sphere())), "ForceLineHoleRepair.*no polygons"),
    (lambda: psr.repair((sphere(), [[0, 1, 1 << 40]])), "triangles must name points below"),
    (lambda: psr.repair((sphere(), [[0.5, 1, 2]])), "triangles must be whole numbers"),
    (lambda: psr.options("mend"), "not of 'mend'")])
def test_bad_input_is_a_value_error(make, message):
    with pytest.raises(ValueError, match=message):
        make()


def test_what_is_no_mesh_is_a_type_error():
    with pytest.raises(TypeError, match="a mesh is needed.*not int"):
        psr.repair(5)


def test_warnings_of_the_libraries_are_warnings_of_python():
    with pytest.warns(RuntimeWarning, match="left out invalid polygons"):
        psr.umbrella_filter((sphere(), [[0, 1, 1 << 20]]))


def test_the_keys_of_a_report_are_attributes():
    report = psr.mesh_quality(psr.reconstruct(sphere()))
    assert report.boundary_loops[0].edges == report["boundary_loops"][0]["edges"]
    with pytest.raises(AttributeError, match="no 'depth'"):
        report.depth


# Meshes of other packages, where they are installed.

@pytest.fixture
def coloured():
    cloud = sphere(500)
    return psr.reconstruct(cloud, cloud, (127 * (cloud + 1)).astype(np.uint8))


@pytest.mark.parametrize("package", ["trimesh", "pyvista", "open3d"])
def test_meshes_of_other_packages_go_there_and_back(coloured, package):
    pytest.importorskip(package)
    back = psr.Mesh.of(getattr(coloured, f"to_{package}")())
    assert np.array_equal(back.triangles, coloured.triangles)
    assert np.allclose(back.points, coloured.points, atol=1e-6)
    assert np.allclose(back.normals, coloured.normals, atol=1e-6)
    scale = 1 if back.colors.dtype == np.uint8 else 255
    assert np.allclose(back.colors[:, :3] * scale, coloured.colors, atol=1)
    assert psr.repair(getattr(coloured, f"to_{package}")())[1].complete
