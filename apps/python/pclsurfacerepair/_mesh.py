# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: meshes and reports as Python has them.
"""Meshes over numpy arrays, and the way of their points to PCL and back."""
from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core

# PCL's numbers of the types that every version of it mixes or copies number by number; what
# has another type travels byte by byte.
_PCL_TYPES = {"i1": 1, "u1": 2, "i2": 3, "u2": 4, "i4": 5, "u4": 6, "f4": 7, "f8": 8}
# PCL's names of what has three numbers here.
_TRIPLES = {"points": "xyz", "normals": ("normal_x", "normal_y", "normal_z"),
            "viewpoints": ("vp_x", "vp_y", "vp_z")}


class Report(dict):
    """What was found and done: the programs' JSON report. Keys are attributes, too."""

    def __getattr__(self, name: str) -> Any:
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"Report has no '{name}'; it has {', '.join(self)}") from None


class Mesh:
    """A triangle mesh, or a cloud where it has no triangles. Arrays are kept as they are given,
    without a copy, where their types are the ones named here.

    points      (N, 3) float32 or float64, in any unit; float64 for map coordinates
    triangles   (M, 3) int32, point indices; outward is to the left of their edges
    attributes  by name, one row a point: normals (N, 3) float, colors (N, 3) or (N, 4) uint8,
                viewpoints (N, 3) float (where the sensor of each point stood), and any others
                of numbers, (N,) or (N, k). All of them are kept; points that a repair adds get
                theirs from the boundary around.
    labels      (M,) uint8 or None. Of reconstruct(): 0 start, 1 base; of repair(): 0 input, 1 fan,
                2 minimum weight, 3 completion
    report      what the run that made it tells, or None
    """

    points: NDArray
    triangles: NDArray
    attributes: dict[str, NDArray]
    labels: NDArray | None
    report: Report | None

    def __init__(self, points: ArrayLike, triangles: ArrayLike | None = None,
                 attributes: Mapping[str, ArrayLike | None] | None = None,
                 labels: NDArray | None = None, report: Report | None = None) -> None:
        self.points = as_triples("points", points)
        self.triangles = _as_corners(np.empty((0, 3), np.int32) if triangles is None
                                     else triangles)
        self.attributes = {name: _as_attribute(name, values, len(self.points))
                           for name, values in (attributes or {}).items() if values is not None}
        self.labels = labels
        self.report = report

    def __repr__(self) -> str:
        names = ", ".join(self.attributes) or "none"
        return f"Mesh({len(self.points)} points, {len(self.triangles)} triangles, attributes: {names})"

    @property
    def normals(self) -> NDArray | None:
        """(N, 3), or None."""
        return self.attributes.get("normals")

    @property
    def colors(self) -> NDArray | None:
        """(N, 3) or (N, 4), or None."""
        return self.attributes.get("colors")

    def to_trimesh(self) -> Any:
        """As a trimesh.Trimesh with colours and all attributes; vertices stay in order."""
        import trimesh
        return trimesh.Trimesh(self.points, self.triangles, vertex_colors=self.colors,
                               vertex_attributes=self.attributes, process=False)

    def to_pyvista(self) -> Any:
        """As a pyvista.PolyData with all attributes as point data."""
        import pyvista
        threes = np.full((len(self.triangles), 1), 3, self.triangles.dtype)
        poly = pyvista.PolyData(np.ascontiguousarray(self.points),
                                np.hstack([threes, self.triangles]).ravel())
        for name, values in self.attributes.items():
            poly.point_data[name] = values
        return poly

    def to_open3d(self) -> Any:
        """As an open3d.geometry.TriangleMesh with normals and colours."""
        import open3d
        mesh = open3d.geometry.TriangleMesh(
            open3d.utility.Vector3dVector(np.asarray(self.points, np.float64)),
            open3d.utility.Vector3iVector(self.triangles))
        if self.normals is not None:
            mesh.vertex_normals = open3d.utility.Vector3dVector(
                np.asarray(self.normals, np.float64))
        if self.colors is not None:
            scale = 255 if self.colors.dtype == np.uint8 else 1
            mesh.vertex_colors = open3d.utility.Vector3dVector(self.colors[:, :3] / scale)
        return mesh

    @classmethod
    def of(cls, other: Any) -> Mesh:
        """A Mesh as it is; of Open3D a Mesh with normals and colours, of trimesh and PyVista with
        all attributes of vertices; of anything else that is a pair, points and triangles."""
        package = type(other).__module__.split(".")[0]
        if isinstance(other, cls):
            return other
        if package == "trimesh":
            colors = other.visual.vertex_colors if other.visual.kind == "vertex" else None
            return cls(np.asarray(other.vertices), np.asarray(other.faces),
                       {"colors": colors, **other.vertex_attributes})
        if package == "pyvista":
            flat = other.triangulate()
            return cls(np.asarray(flat.points), flat.faces.reshape(-1, 4)[:, 1:],
                       {name: np.asarray(flat.point_data[name]) for name in flat.point_data})
        if package == "open3d":
            def array(values: Any) -> NDArray | None:
                return np.asarray(values) if len(values) else None
            is_mesh = hasattr(other, "triangles")
            return cls(np.asarray(other.vertices if is_mesh else other.points),
                       np.asarray(other.triangles) if is_mesh else None,
                       {"normals": array(other.vertex_normals if is_mesh else other.normals),
                        "colors": array(other.vertex_colors if is_mesh else other.colors)})
        try:
            points, triangles = other
        except (TypeError, ValueError):
            raise TypeError(f"a mesh is needed: Mesh, (points, triangles), or one of trimesh, "
                            f"PyVista or Open3D, not {type(other).__name__}") from None
        return cls(points, triangles)


def as_triples(name: str, values: ArrayLike) -> NDArray:
    """(N, 3), float32 or float64; other numbers become float64."""
    array = np.asarray(values)
    if array.ndim != 2 or array.shape[1] != 3 or array.dtype.kind not in "fiu":
        raise ValueError(f"{name} must be numbers of shape (N, 3), "
                         f"not {array.dtype} of shape {array.shape}")
    return array if array.dtype in (np.float32, np.float64) else array.astype(np.float64)


def _as_corners(values: ArrayLike) -> NDArray:
    array = np.asarray(values)
    if array.ndim != 2 or array.shape[1] < 3 or array.dtype.kind not in "iu":
        raise ValueError(f"triangles must be whole numbers of shape (M, 3), "
                         f"not {array.dtype} of shape {array.shape}")
    limits = np.iinfo(np.int32)
    if array.dtype.itemsize > 2 and array.dtype != np.int32 and array.size and (
            array.max() > limits.max or array.min() < limits.min):
        raise ValueError(f"triangles must name points below {limits.max}, not {array.max()}")
    return np.ascontiguousarray(array, np.int32)


def _as_attribute(name: str, values: ArrayLike, points: int) -> NDArray:
    array = as_triples(name, values) if name in _TRIPLES else np.asarray(values)
    if array.ndim not in (1, 2) or len(array) != points or array.dtype.kind not in "fiub":
        raise ValueError(f"attribute '{name}' must be numbers, a row for each of {points} points, "
                         f"not {array.dtype} of shape {array.shape}")
    return array if array.dtype.isnative else array.astype(array.dtype.newbyteorder("="))


def _is_packed(name: str, array: NDArray) -> bool:
    return name == "colors" and array.dtype == np.uint8 and array.shape[1:] in ((3,), (4,))


class PointLayout:
    """How arrays lie side by side in the points of a cloud of PCL."""

    def __init__(self, arrays: dict[str, NDArray]) -> None:
        self.arrays = arrays
        self.offsets: dict[str, int] = {}
        self.fields: list[tuple[str, int, int, int]] = []
        self.step = 0
        for name, array in arrays.items():
            self._add(name, array)
        self.step += -self.step % max(4, *(min(a.itemsize, 8) for a in arrays.values()))

    def _add(self, name: str, array: NDArray) -> None:
        kind, size = array.dtype.str[1:], array.itemsize
        fields, count = [f"attribute {name}"], int(np.prod(array.shape[1:]))  # no name of PCL's
        if name in _TRIPLES:
            fields, count = list(_TRIPLES[name]), 1
        elif _is_packed(name, array):
            fields, count, kind, size = ["rgba" if count == 4 else "rgb"], 1, "f4", 4
        self.step += -self.step % size
        self.offsets[name] = self.step
        for field in fields:
            known = kind in _PCL_TYPES
            self.fields.append((field, self.step, _PCL_TYPES.get(kind, 2),
                                count if known else count * size))
            self.step += count * size

    def _view(self, cloud: _core.Cloud, name: str) -> tuple[NDArray, Any]:
        """An array in the memory of a cloud, which it keeps alive, and where its columns are."""
        array = self.arrays[name]
        if _is_packed(name, array):  # blue, green, red, alpha
            packed: NDArray = np.ndarray((cloud.size, 4), np.uint8, cloud.data,
                                         self.offsets[name], (self.step, 1))
            return packed, slice(2, None, -1) if array.shape[1] == 3 else [2, 1, 0, 3]
        shape = (cloud.size, *array.shape[1:])
        strides = (self.step, array.itemsize)[:len(shape)]
        return np.ndarray(shape, array.dtype, cloud.data, self.offsets[name], strides), \
            slice(None)

    def pack(self) -> _core.Cloud:
        """A cloud of all arrays: the only copy that a run takes of its input."""
        cloud = _core.Cloud(len(self.arrays["points"]), self.step, self.fields)
        for name, array in self.arrays.items():
            target, columns = self._view(cloud, name)
            target[(..., columns) if array.ndim == 2 else ...] = array
        return cloud

    def unpack(self, cloud: _core.Cloud) -> dict[str, NDArray]:
        """The arrays of a cloud that was packed, and has got more points since."""
        views = {name: self._view(cloud, name) for name in self.arrays}
        return {name: view[..., columns] if view.ndim == 2 else view
                for name, (view, columns) in views.items()}
