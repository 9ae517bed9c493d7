# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: the Python of pages and examples runs.
import json
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from conftest import sphere

DOC = Path(__file__).resolve().parents[2] / "doc"


@pytest.fixture
def scan(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    np.savetxt("scan.xyz", sphere(1500))
    return "scan.xyz"


def test_the_code_of_the_page_runs_from_top_to_bottom(scan, capsys):
    blocks = re.findall(r"^```python\n(.*?)^```", (DOC / "python.md").read_text(), re.S | re.M)
    names = {}
    for block in blocks:
        exec(block, names)
    assert len(blocks) >= 5 and names["report"].complete
    assert "watertight, 1 piece" in capsys.readouterr().out


@pytest.mark.parametrize("example, argument, line", [
    ("reconstruct", "mesh.obj", "mesh.obj: watertight, 1 piece"),
    ("inspect_holes", "9", "watertight, 1 piece"),
    ("inspect_holes", "1", "0 new triangles, 1 border open")])
def test_examples_say_what_they_did(scan, example, argument, line):
    done = subprocess.run([sys.executable, DOC / "examples" / f"{example}.py", scan, argument],
                          capture_output=True, text=True)
    assert done.returncode == 0 and line in done.stdout, done


def test_the_notebook_is_that_of_the_page():
    subprocess.run([sys.executable, DOC.parent / "scripts" / "make_notebook.py", "--check"], check=True)


def test_the_cells_of_the_notebook_run(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "agg")
    notebook = json.loads((DOC / "examples" / "python.ipynb").read_text())
    names = {}
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            exec("".join(cell["source"]), names)
    assert names["report"].complete
