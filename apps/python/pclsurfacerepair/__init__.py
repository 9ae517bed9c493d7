# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: the Python package.
"""Triangle meshes from point clouds, and meshes made whole, over numpy arrays.

    import numpy as np
    import pclsurfacerepair as psr
    mesh = psr.reconstruct(np.loadtxt("scan.xyz")[:, :3])
    whole, report = psr.repair(mesh)
    print(report.verdict)

All functions release the interpreter's lock, give the same result for any number of threads, and
stop at Ctrl-C (KeyboardInterrupt). They share these arguments:

threads    number of threads, 0 (the default): all
progress   None; True for a bar of tqdm; a bar such as tqdm.tqdm(total=100); or a function that
           is called with the name of the stage and the share of it that is done, 0 to 1, and may
           return False: then Cancelled is raised
viewpoint  (x, y, z) where the sensor stood, in units of the points; outer sides are what it sees
up         (x, y, z) where the outer side looks, (0, 0, 1) for a terrain; of any length
origin_as_viewpoint
           whether the origin counts as the sensor's place where nothing else tells and all points
           lie before it; default False

Options are those of the C++ classes, by their names: see options(). A wrong value is a ValueError
or TypeError that names it, lack of memory a MemoryError; what the libraries warn of is a
RuntimeWarning. Arrays must not be changed by other threads during a call.
"""
from __future__ import annotations

import difflib
import json
import os
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core, _options
from ._core import Cancelled, __version__
from ._mesh import Mesh, PointLayout, Report, as_triples

if TYPE_CHECKING:
    from typing import Unpack

    from ._options import (ClassifyBoundariesOptions, CleanOptions, ReconstructOptions,
                           RepairOptions, UmbrellaFilterOptions)

__all__ = ["Boundary", "Cancelled", "Mesh", "Report", "__version__", "classify_boundaries",
           "clean", "mesh_quality", "options", "propose_decisions", "reconstruct", "repair",
           "umbrella_filter"]

Tell = Callable[[str, float], bool | None]
Progress = None | bool | Tell | Any
Place = None | Sequence[float]


class Boundary(Report):
    """A boundary loop: `points` (K,) int32 along it, the surface on the left; `class` (as key:
    hole, island rim, outer border, undecided), `confidence` 0 to 1, `length` in units of the
    points, `island`, and the evidence D, turning, area_ratio, faced."""


def options(function: str) -> dict[str, tuple[Any, str]]:
    """Default and description of all options of a function, such as "repair"."""
    known = _core.defaults()
    if function not in known:
        raise ValueError(f"options of {', '.join(known)} are known, not of {function!r}")
    return {name: (value, _options.ABOUT[function][name])
            for name, value in known[function].items()}


def _check(function: str, given: dict[str, Any]) -> dict[str, Any]:
    known = _options.ABOUT[function]
    for name in given:
        if name not in known:
            near = difflib.get_close_matches(name, known, 3)
            raise TypeError(f"{function}() has no option '{name}'" +
                            (f"; perhaps {' or '.join(near)} is meant" if near else "") +
                            f" (see pclsurfacerepair.options('{function}'))")
    return given


def _tell(progress: Progress) -> Tell | None:
    """What a run calls; a bar runs from 0 to its total once a stage."""
    if progress is None or progress is False:
        return None
    bar: Any = progress
    if progress is True:
        from tqdm.auto import tqdm
        bar = tqdm(total=100, bar_format="{desc} {percentage:3.0f}%|{bar}| {elapsed}")
    if not hasattr(bar, "update"):
        return bar

    def update(stage: str, share: float) -> None:
        if hasattr(bar, "set_description"):
            bar.set_description(stage, refresh=False)
        bar.update(share * (bar.total or 1) - bar.n)
    return update


def _run(threads: int, progress: Progress, **arguments: Any) -> dict[str, Any]:
    """What the module takes beside arrays and options."""
    if not isinstance(threads, int) or threads < 0:
        raise ValueError(f"threads must be a whole number of at least 0, not {threads!r}")
    return {"threads": threads, "progress": _tell(progress), **arguments}


def _cloud(points: NDArray, attributes: dict[str, NDArray]) -> tuple[_core.Cloud, PointLayout]:
    layout = PointLayout({"points": points, **attributes})
    return layout.pack(), layout


def _points(points: ArrayLike | Mesh, normals: ArrayLike | None, colors: ArrayLike | None,
            viewpoints: ArrayLike | None, attributes: dict[str, ArrayLike] | None) -> Mesh:
    """A cloud of its own, with all that belongs to it."""
    given = points if isinstance(points, Mesh) else Mesh(points)
    told = {"normals": normals, "colors": colors, "viewpoints": viewpoints}
    return Mesh(given.points, attributes={
        **given.attributes, **{name: values for name, values in told.items() if values is not None},
        **(attributes or {})})


def _free(points: ArrayLike | Mesh | None) -> _core.Cloud | None:
    if points is None:
        return None
    cloud = points if isinstance(points, Mesh) else Mesh(as_triples("free_points", points))
    return _cloud(cloud.points, cloud.attributes)[0]


def _decisions(decisions: Any) -> str | None:
    """The text of decisions: a dictionary, or the name of a file."""
    if decisions is None:
        return None
    if isinstance(decisions, dict):
        return json.dumps(decisions)
    with open(os.fspath(decisions), encoding="utf-8") as file:
        return file.read()


def _report(text: str) -> Any:
    return json.loads(text, object_hook=Report)


def clean(points: ArrayLike | Mesh, normals: ArrayLike | None = None,
          colors: ArrayLike | None = None, threads: int = 0, progress: Progress = None, *,
          viewpoints: ArrayLike | None = None, attributes: dict[str, ArrayLike] | None = None,
          **options: Unpack[CleanOptions]) -> tuple[Mesh, Report]:
    """Make one even layer of points of scans that overlap and disagree.

    Arguments as for reconstruct(). Gives a Mesh without triangles, for reconstruct(), and a report:
    how many points were `outliers`, how far apart they are now (`spacing`), how far they were
    `moved` by patches of which `radius`. Numbers with a fraction, normals and colours of a point are
    mixed from those it is made of; whole numbers and viewpoints are those of the nearest. Fewer than
    24 points stay as they are. Cost: about 10 us a point.
    """
    given = _points(points, normals, colors, viewpoints, attributes)
    cloud, layout = _cloud(given.points, given.attributes)
    cloud, text = _core.clean(cloud, _run(threads, progress), _check("clean", dict(options)))
    arrays = layout.unpack(cloud)
    report = _report(text)
    return Mesh(arrays.pop("points"), None, arrays, None, report), report


def reconstruct(points: ArrayLike | Mesh, normals: ArrayLike | None = None,
                colors: ArrayLike | None = None, viewpoint: Place = None, threads: int = 0,
                progress: Progress = None, *, viewpoints: ArrayLike | None = None,
                attributes: dict[str, ArrayLike] | None = None, up: Place = None,
                origin_as_viewpoint: bool = False, until: str = "base",
                compute_normals: bool = False, **options: Unpack[ReconstructOptions]) -> Mesh:
    """Connect the points of a cloud with triangles; needs neither normals nor options.

    points           (N, 3) float32 or float64, in any unit; map coordinates need float64; or a
                     Mesh, whose attributes are taken as well
    normals          (N, 3), outward, of any length, NaN where unknown; they tell the outer side
    colors           (N, 3) or (N, 4) uint8; kept
    viewpoints       (N, 3) where the sensor of each point stood
    attributes       others, one row a point; kept
    until            last stage: "start" (raw triangles), "filter" (correct ones) or "base"
    compute_normals  make normals of the surface, (N, 3) float32, NaN at points without triangles;
                     given normals stay

    The result's points are the array that was given; points that no triangle could be trusted
    with stay free points. Its `report` has `complete`, `verdict`, `what_is_missing` and `doubts`,
    of which a later repair knows nothing. Cost: about 2 us a point.
    """
    if until not in ("start", "filter", "base"):
        raise ValueError(f"until must be 'start', 'filter' or 'base', not {until!r}")
    mesh = _points(points, normals, colors, viewpoints, attributes)
    told = {name: np.asarray(mesh.attributes[name], np.float32)
            for name in ("normals", "viewpoints") if name in mesh.attributes}
    if "normals" in told:
        told.pop("viewpoints", None)  # normals tell more
    cloud, _ = _cloud(mesh.points, told)
    mesh.triangles, mesh.labels, made, report = _core.reconstruct(
        cloud,
        _run(threads, progress, viewpoint=viewpoint, up=up, until=until,
             origin_as_viewpoint=origin_as_viewpoint, compute_normals=compute_normals),
        _check("reconstruct", dict(options)))
    if made is not None:
        mesh.attributes.setdefault("normals", made)
    mesh.report = _report(report)
    return mesh


def repair(mesh: Any, free_points: ArrayLike | Mesh | None = None, *, decisions: Any = None,
           viewpoint: Place = None, up: Place = None, origin_as_viewpoint: bool = False,
           threads: int = 0, progress: Progress = None,
           **options: Unpack[RepairOptions]) -> tuple[Mesh, Report]:
    """Join the islands of a mesh and close its holes.

    mesh         a Mesh, (points, triangles), or a mesh of trimesh, PyVista or Open3D
    free_points  (K, 3) samples of the missing regions, or a Mesh of them with attributes; points
                 of the mesh without a triangle count, too
    decisions    what propose_decisions() gave, changed, or the name of such a file; of the same
                 mesh

    Points and triangles of the input come first, in order and bit for bit; new points follow,
    with all attributes. The report says what was done about each boundary and why what is open
    stayed so: `complete`, `verdict`, `what_is_missing`, `holes`, `junctions`, `before`, `after`;
    doc/apps.md explains the keys. Cost: about 2 us a triangle and 30 us a boundary edge.
    """
    given = Mesh.of(mesh)
    cloud, layout = _cloud(given.points, given.attributes)
    cloud, triangles, labels, text = _core.repair(
        cloud, given.triangles, _free(free_points),
        _run(threads, progress, viewpoint=viewpoint, up=up, decisions=_decisions(decisions),
             origin_as_viewpoint=origin_as_viewpoint),
        _check("repair", dict(options)))
    arrays = layout.unpack(cloud)
    report = _report(text)
    return Mesh(arrays.pop("points"), triangles, arrays, labels, report), report


def propose_decisions(mesh: Any, free_points: ArrayLike | Mesh | None = None, *,
                      viewpoint: Place = None, up: Place = None,
                      origin_as_viewpoint: bool = False, threads: int = 0,
                      progress: Progress = None, **options: Unpack[RepairOptions]) -> dict:
    """What repair() would decide about each loop and junction, to be changed and given back.

    The dictionary is what `pcl_repair_holes --dry-run --decisions` writes: in `loops` the key
    `decision` (close, leave open, auto) and `cap` (smooth, flat, auto), in `junctions` the key
    `decision` (join, do not join). Arguments as for repair().
    """
    given = Mesh.of(mesh)
    return json.loads(_core.propose_decisions(
        _cloud(given.points, given.attributes)[0], given.triangles, _free(free_points),
        _run(threads, progress, viewpoint=viewpoint, up=up, decisions=None,
             origin_as_viewpoint=origin_as_viewpoint),
        _check("repair", dict(options))))


def umbrella_filter(mesh: Any, *, viewpoint: Place = None, up: Place = None,
                    origin_as_viewpoint: bool = False, threads: int = 0,
                    progress: Progress = None,
                    **options: Unpack[UmbrellaFilterOptions]) -> tuple[Mesh, NDArray]:
    """Keep only the triangles that are a correct surface, all wound outward.

    mesh  as for repair(); no edge keeps more than two triangles, no point more than one fan

    Gives the mesh, with the same points and attributes, and the roles of its points, (N,) uint8:
    0 free, 1 boundary, 2 internal. Cost: about 0.25 us a point.
    """
    given = Mesh.of(mesh)
    triangles, roles, report = _core.umbrella_filter(
        _cloud(given.points, given.attributes)[0], given.triangles,
        _run(threads, progress, viewpoint=viewpoint, up=up,
             origin_as_viewpoint=origin_as_viewpoint),
        _check("umbrella_filter", dict(options)))
    return Mesh(given.points, triangles, given.attributes, None, _report(report)), roles


def classify_boundaries(mesh: Any, *, threads: int = 0, progress: Progress = None,
                        **options: Unpack[ClassifyBoundariesOptions]) -> list[Boundary]:
    """Tell of each boundary loop whether it is a hole, the rim of an island or a border.

    mesh  as for repair(); it may be any mesh, and is not changed

    Loops are in the order of their first triangle; a closed mesh has none. Cost: about 0.6 us a
    triangle and 3 us a boundary edge.
    """
    given = Mesh.of(mesh)
    points, reports = _core.classify_boundaries(
        _cloud(given.points, {})[0], given.triangles,
        _run(threads, progress),
        _check("classify_boundaries", dict(options)))
    return [Boundary(report, points=loop) for loop, report in zip(points, json.loads(reports))]


def mesh_quality(mesh: Any, *, self_intersections: bool = True, threads: int = 0,
                 progress: Progress = None) -> Report:
    """Everything that can be counted and measured about a mesh, be it sound or not.

    mesh                as for repair()
    self_intersections  whether to look for triangles that cross each other, which takes longest

    Lengths, areas and volumes are in units of the points, angles in degrees; doc/apps.md explains
    the keys.
    """
    given = Mesh.of(mesh)
    return _report(_core.mesh_quality(
        _cloud(given.points, {})[0], given.triangles,
        _run(threads, progress, self_intersections=self_intersections)))


def _list_options() -> None:
    """Put the options into the docstrings, with the C++ headers' words."""
    for name, function in (("clean", clean), ("reconstruct", reconstruct), ("repair", repair),
                           ("umbrella_filter", umbrella_filter),
                           ("classify_boundaries", classify_boundaries)):
        lines = (f"    {option} = {value!r}: {about}"
                 for option, (value, about) in options(name).items())
        function.__doc__ = f"{function.__doc__}\n    Options:\n\n" + "\n".join(lines)


_list_options()
