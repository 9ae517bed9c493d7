#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: the page about Python as a notebook, with pictures.
"""usage: make_notebook.py [--check]

Writes doc/examples/python.ipynb: text and code of doc/python.md from its first mesh on, a scan to work
on, and a picture of each mesh as it is made. --check only says whether the notebook is up to date.
"""
import json
import re
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[1]
NOTEBOOK = TOP / "doc/examples/python.ipynb"
SCAN = """import numpy as np
k = np.arange(4000)                          # a ball without its top, in place of a scan
z = 1 - (2 * k + 1) / len(k)
r, turn = np.sqrt(1 - z * z), 2.39996323 * k
ball = np.c_[r * np.cos(turn), r * np.sin(turn), z][z < 0.95]
np.savetxt("scan.xyz", ball)"""
SHOW = """def show(mesh):
    \"\"\"A picture; needs matplotlib (python3-matplotlib).\"\"\"
    try:
        from matplotlib import pyplot
    except ImportError:
        return print(mesh)
    axes = pyplot.figure(figsize=(4, 4)).add_subplot(projection="3d")
    axes.plot_trisurf(*mesh.points.T, triangles=mesh.triangles, edgecolor="black", linewidth=0.1)
    axes.set_box_aspect(np.ptp(mesh.points, axis=0))
    axes.view_init(50, 20)
    axes.set_axis_off()
    pyplot.show()"""


def cell(kind, text, number):
    more = {"execution_count": None, "outputs": []} if kind == "code" else {}
    return {"cell_type": kind, "id": f"cell-{number}", "metadata": {},
            "source": text.strip("\n").splitlines(keepends=True), **more}


def cells():
    page = (TOP / "doc/python.md").read_text(encoding="utf-8")
    yield "markdown", "# From Python\n\nMade from [the page](../python.md) by `scripts/make_notebook.py`."
    yield "code", SCAN
    yield "code", SHOW
    page = page[page.index("## The first mesh"):page.index("## Arrays from other readers")]
    page = re.sub(r"\]\((?!http)", "](../", page)  # the notebook lies one folder deeper
    for i, part in enumerate(re.split(r"^```python\n(.*?)^```$", page, flags=re.M | re.S)):
        if i % 2 == 0:
            yield "markdown", part
        else:
            yield "code", part
            made = [name for name in ("whole", "mesh") if re.search(rf"^{name}\b.*=", part, re.M)]
            if made:
                yield "code", f"show({made[0]})"


def main(check):
    notebook = {"cells": [cell(*one, number) for number, one in enumerate(cells())
                          if one[1].strip()],
                "metadata": {"kernelspec": {"display_name": "Python 3", "language": "python",
                                            "name": "python3"}},
                "nbformat": 4, "nbformat_minor": 5}
    text = json.dumps(notebook, indent=1) + "\n"
    if check:
        return 0 if NOTEBOOK.read_text(encoding="utf-8") == text else "renew it: scripts/make_notebook.py"
    NOTEBOOK.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main("--check" in sys.argv[1:]))
