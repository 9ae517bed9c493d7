# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: the Python package gives what the programs give, bit for bit.
import json

import numpy as np
import pytest
from conftest import read_ply, run, sphere, terrain, triples, write_ply

import pclsurfacerepair as psr


def assert_same(mesh, path):
    vertices, triangles, labels = read_ply(path)
    assert mesh.points.tobytes() == triples(vertices).astype(mesh.points.dtype).tobytes()
    assert np.array_equal(mesh.triangles, triangles)
    if labels is not None:
        assert np.array_equal(mesh.labels, labels)


def normals_of(cloud):
    return (cloud / np.linalg.norm(cloud, axis=1, keepdims=True)).astype(np.float32)


CLOUDS = {"floats": sphere(), "map coordinates": terrain(),
          "doubles": sphere(dtype=np.float64), "coarse floats": terrain().astype(np.float32)}


@pytest.mark.parametrize("name", CLOUDS)
@pytest.mark.parametrize("until", ["start", "filter", "base"])
def test_reconstruct_gives_what_the_program_gives(tmp_path, name, until):
    file = write_ply(tmp_path / "cloud.ply", CLOUDS[name])
    run("pcl_ccaa_reconstruct", file, tmp_path / "mesh.ply", "--labels", "--until", until)
    assert_same(psr.reconstruct(CLOUDS[name], until=until), tmp_path / "mesh.ply")


def test_clean_gives_what_the_program_gives(tmp_path):
    cloud = sphere(9000) + np.random.default_rng(3).normal(0, 0.01, (8775, 3)).astype(np.float32)
    file = write_ply(tmp_path / "cloud.ply", cloud, normals=normals_of(cloud))
    run("pcl_ccaa_reconstruct", file, tmp_path / "mesh.ply", "--clean", "--labels", "--report",
        tmp_path / "report.json")
    clean, report = psr.clean(cloud, normals_of(cloud))
    assert report == json.loads((tmp_path / "report.json").read_text())["cleaning"]
    assert_same(psr.reconstruct(clean), tmp_path / "mesh.ply")


def test_reconstruct_asks_normals_as_the_program_does(tmp_path):
    cloud = sphere()
    inward = -normals_of(cloud)
    file = write_ply(tmp_path / "cloud.ply", cloud, normals=inward)
    run("pcl_ccaa_reconstruct", file, tmp_path / "mesh.ply")
    assert_same(psr.reconstruct(cloud, inward), tmp_path / "mesh.ply")


def test_reconstruct_takes_viewpoint_and_options_as_the_program_does(tmp_path):
    cloud = terrain()
    place = cloud.mean(axis=0) - [0, 0, 500]
    file = write_ply(tmp_path / "cloud.ply", cloud)
    run("pcl_ccaa_reconstruct", file, tmp_path / "mesh.ply", "--neighbors", 9, "--max-length", 2,
        "--viewpoint=" + ",".join(repr(float(x)) for x in place))
    mesh = psr.reconstruct(cloud, viewpoint=place, start_neighbors=9, length_factor=2.0)
    assert_same(mesh, tmp_path / "mesh.ply")


def test_reconstruct_makes_the_normals_of_the_program(tmp_path):
    file = write_ply(tmp_path / "cloud.ply", sphere())
    run("pcl_ccaa_reconstruct", file, tmp_path / "mesh.ply", "--normals")
    made = triples(read_ply(tmp_path / "mesh.ply")[0], ["nx", "ny", "nz"])
    assert psr.reconstruct(sphere(), compute_normals=True).normals.tobytes() == made.tobytes()


@pytest.mark.parametrize("name", CLOUDS)
def test_repair_gives_what_the_program_gives(tmp_path, name):
    mesh = psr.reconstruct(CLOUDS[name])
    file = write_ply(tmp_path / "mesh.ply", mesh.points, mesh.triangles)
    run("pcl_repair_holes", file, tmp_path / "whole.ply", "--labels", "--report",
        tmp_path / "report.json", "--close", "all")
    whole, report = psr.repair(mesh, close="all")
    assert_same(whole, tmp_path / "whole.ply")
    told = json.loads((tmp_path / "report.json").read_text())
    assert [dict(hole) for hole in report.holes] == told["holes"]


def test_repair_mixes_colours_and_normals_as_the_program_does(tmp_path):
    cloud = sphere()
    colors = (127.5 * (cloud + 1)).astype(np.uint8)
    mesh = psr.reconstruct(cloud, normals_of(cloud), colors)
    file = write_ply(tmp_path / "mesh.ply", cloud, mesh.triangles, mesh.normals, colors)
    run("pcl_repair_holes", file, tmp_path / "whole.ply")
    vertices, _, _ = read_ply(tmp_path / "whole.ply")
    whole, _ = psr.repair(mesh)
    assert np.array_equal(whole.colors, triples(vertices, ["red", "green", "blue"]))
    assert whole.normals.tobytes() == triples(vertices, ["nx", "ny", "nz"]).tobytes()


def test_repair_takes_free_points_and_options_as_the_program_does(tmp_path):
    lost = np.float32([[0, 0, 1], [0.1, 0, 0.995], [0, 0.1, 0.995]])
    mesh = psr.reconstruct(sphere())
    file = write_ply(tmp_path / "mesh.ply", mesh.points, mesh.triangles)
    free = write_ply(tmp_path / "free.ply", lost)
    run("pcl_repair_holes", file, tmp_path / "whole.ply", "--free-points", free, "--trust", 0.8,
        "--filling", "completion", "--edge-length", 2)
    whole, _ = psr.repair(mesh, lost, trust=0.8, filling="completion", edge_length=2.0)
    assert_same(whole, tmp_path / "whole.ply")


def test_decisions_are_those_of_the_program_and_go_both_ways(tmp_path):
    mesh = psr.reconstruct(sphere(holes=2))
    file = write_ply(tmp_path / "mesh.ply", mesh.points, mesh.triangles)
    run("pcl_repair_holes", file, "--dry-run", "--decisions", tmp_path / "decisions.json")
    told = json.loads((tmp_path / "decisions.json").read_text())
    told["mesh"].pop("file")
    proposed = psr.propose_decisions(mesh)
    assert {**proposed, "mesh": {**proposed["mesh"], "file": None}} == \
        {**told, "mesh": {**told["mesh"], "file": None}}
    proposed["loops"][0]["decision"] = "leave open"
    (tmp_path / "decisions.json").write_text(json.dumps(proposed))
    run("pcl_repair_holes", file, tmp_path / "whole.ply", "--decisions", tmp_path / "decisions.json")
    for decisions in (proposed, tmp_path / "decisions.json"):
        assert_same(psr.repair(mesh, decisions=decisions)[0], tmp_path / "whole.ply")


def test_mesh_quality_is_the_report_of_the_program(tmp_path):
    mesh = psr.reconstruct(terrain())
    file = write_ply(tmp_path / "mesh.ply", mesh.points, mesh.triangles)
    run("pcl_mesh_quality", file, "--report", tmp_path / "report.json")
    told = json.loads((tmp_path / "report.json").read_text())
    found = psr.mesh_quality(mesh)
    assert {key: value for key, value in found.items() if key in told} == \
        {key: value for key, value in told.items() if key in found}


def test_a_real_scan_is_repaired_as_the_program_does(tmp_path, bunny):
    file = write_ply(tmp_path / "bunny.ply", *bunny)
    run("pcl_repair_holes", file, tmp_path / "whole.ply", "--labels")
    assert_same(psr.repair(bunny)[0], tmp_path / "whole.ply")


def test_classes_of_boundaries_are_those_of_the_repair():
    mesh = psr.reconstruct(sphere(holes=2))
    loops = psr.classify_boundaries(mesh)
    _, report = psr.repair(mesh)
    assert [loop["class"] for loop in loops] == [loop["class"] for loop in report.loops]
    assert [loop.D for loop in loops] == [loop.D for loop in report.loops]


def test_the_filter_gives_what_the_chain_keeps_of_raw_triangles():
    raw = psr.reconstruct(sphere(), until="start")
    filtered, roles = psr.umbrella_filter(raw)
    chain = psr.reconstruct(sphere(), until="filter")
    assert {*map(frozenset, filtered.triangles.tolist())} == \
        {*map(frozenset, chain.triangles.tolist())}
    assert np.bincount(roles, minlength=3).sum() == len(raw.points)
