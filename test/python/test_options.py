# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: all public options of the C++ classes can be set from Python.
import re
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import sphere

import pclsurfacerepair as psr
from pclsurfacerepair import _core

TOP = Path(__file__).resolve().parents[2]
HEADERS = "\n".join(re.sub(r"/\*.*?\*/|//[^\n]*", "", path.read_text(), flags=re.S)
                    for folder in ("surface_ccaa", "surface_repair")
                    for path in sorted((TOP / folder).glob("include/pcl/*/*.h")))
# Not options: what functions take as arguments, parts of a chain, what another member settles,
# and the two halves of a length that is one option.
NO_OPTION = {"sides", "search", "decisions", "value", "of_diagonal"}
STRUCTS = [name for name in re.findall(r"struct (\w+Parameters) {", HEADERS)] + ["SmallIslands"]
OPTIONS = {name for function in _core.defaults() for name in psr.options(function)}


def body_of(kind, name):
    return re.search(rf"{kind} {name}\b[^;{{]*{{(.*?)^}};", HEADERS, re.S | re.M)[1]


def members_of(struct):
    """Names at the end of declarations with a default, or of a nested struct."""
    return re.findall(r"^  [\w:<>, ]+? (\w+)(?: =[^;]*)?;", body_of("struct", struct), re.M)


@pytest.mark.parametrize("struct", STRUCTS)
def test_every_member_of_an_options_struct_can_be_set(struct):
    members = members_of(struct)
    assert members
    nested = {"start", "base", "filling"} | {
        name for other in STRUCTS for name in re.findall(rf"{other} (\w+)", HEADERS)}
    for name in set(members) - NO_OPTION - nested:
        # "choice" is called as what is chosen; a name of two structs has that of its own first.
        found = name == "choice" and "filling" in OPTIONS or \
            any(option == name or option.endswith("_" + name) for option in OPTIONS)
        assert found, f"{struct}::{name}"


@pytest.mark.parametrize("name", ["UmbrellaFilter", "BoundaryClassifier"])
def test_every_setter_of_a_class_without_a_struct_can_be_called(name):
    for setter in re.findall(r"\bset(\w+)\((?!const)", body_of("class", name)):
        snake = re.sub(r"(?<!^)(?=[A-Z])", "_", setter).lower()
        assert any(option.endswith(snake) for option in OPTIONS), setter


def other_than(value):
    """A value of the same kind that changes something, or at least is another one."""
    if isinstance(value, bool):
        return not value
    if isinstance(value, str):
        return {"light": "full", "automatic": "fan", "holes": "all", "auto": "flat"}[value]
    return value + 1 if isinstance(value, int) else value * 0.9 + 0.01


@pytest.mark.parametrize("function", _core.defaults())
def test_every_option_is_taken_by_its_function(function):
    mesh = psr.reconstruct(sphere(400))
    given = mesh.points if function in ("clean", "reconstruct") else mesh
    for name, (value, about) in psr.options(function).items():
        assert about, f"{function}: {name} has no description"
        getattr(psr, function)(given, **{name: other_than(value)})


def test_an_option_reaches_the_run():
    _, report = psr.repair(psr.reconstruct(sphere(400)), interpolation=3.5, greatest_bridge="5%",
                           close="all", filling_greatest_length=7.5, dropped_triangles=3)
    told = report.parameters
    assert (told.interpolation, told.greatest_bridge, told.close, told.greatest_hole_length,
            told.drop_islands.triangles) == (3.5, "5%", "all", 7.5, 3)


def test_docstrings_list_all_options():
    for function in _core.defaults():
        for name in psr.options(function):
            assert f"\n    {name} = " in getattr(psr, function).__doc__


def test_types_are_sound_and_know_the_options(tmp_path):
    pytest.importorskip("mypy")
    (tmp_path / "user.py").write_text(
        "import numpy as np\nimport pclsurfacerepair as psr\n"
        "mesh = psr.reconstruct(np.zeros((3, 3)), length_factor=2.5)\n"
        "psr.repair(mesh, close='most')\npsr.repair(mesh, trusts=1.0)\n")
    done = subprocess.run(
        [sys.executable, "-m", "mypy", "--config-file", TOP / "pyproject.toml", "--cache-dir",
         tmp_path / "cache", Path(psr.__file__).parent, tmp_path / "user.py"],
        capture_output=True, text=True)
    errors = [line for line in done.stdout.splitlines() if ": error:" in line]
    assert len(errors) == 2 and "nothing" in errors[0] and "trusts" in errors[1], done


def test_an_unknown_option_is_told_with_those_of_similar_names():
    with pytest.raises(TypeError, match="no option 'trusts'; perhaps trust"):
        psr.repair(psr.reconstruct(sphere(400)), trusts=0.5)


@pytest.mark.parametrize("options, error, message", [
    ({"trust": "much"}, TypeError, "trust='much' needs a number"),
    ({"trust": float("nan")}, ValueError, "trust=nan needs to be finite"),
    ({"trust": 1.5}, ValueError, r"ForceLineHoleRepair.*trust.*out of range.*'trust': 1.5"),
    ({"close": "most"}, ValueError, "close='most' needs one of 'nothing', 'holes', 'all'"),
    ({"greatest_hole": -1}, TypeError, "greatest_hole=-1 needs a whole number"),
    ({"greatest_bridge": "5"}, ValueError, "greatest_bridge='5' needs a length, or a share"),
    ({"up": (0, 0, 0)}, ValueError, "up must not be zero"),
    ({"viewpoint": (1, 2)}, TypeError, r"viewpoint=\(1, 2\) needs three numbers"),
    ({"threads": -1}, ValueError, "threads must be a whole number"),
    ({"decisions": {"format": "other"}}, ValueError, "no file of decisions")])
def test_bad_values_are_told_by_name_and_value(options, error, message):
    with pytest.raises(error, match=message):
        psr.repair(psr.reconstruct(sphere(400)), **options)
