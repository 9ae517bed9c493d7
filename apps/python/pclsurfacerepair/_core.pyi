from typing import Any

import numpy as np

__version__: str

class Cancelled(RuntimeError): ...

class Cloud:
    size: int
    data: np.ndarray
    def __init__(self, points: int, step: int, fields: list[tuple[str, int, int, int]]) -> None: ...

def defaults() -> dict[str, dict[str, bool | int | float | str]]: ...
def clean(
    cloud: Cloud, arguments: dict[str, Any], options: dict[str, Any]
) -> tuple[Cloud, str]: ...
def reconstruct(
    cloud: Cloud, arguments: dict[str, Any], options: dict[str, Any]
) -> tuple[np.ndarray, np.ndarray, np.ndarray | None, str]: ...
def repair(
    cloud: Cloud,
    corners: np.ndarray,
    free_points: Cloud | None,
    arguments: dict[str, Any],
    options: dict[str, Any],
) -> tuple[Cloud, np.ndarray, np.ndarray, str]: ...
def propose_decisions(
    cloud: Cloud,
    corners: np.ndarray,
    free_points: Cloud | None,
    arguments: dict[str, Any],
    options: dict[str, Any],
) -> str: ...
def umbrella_filter(
    cloud: Cloud, corners: np.ndarray, arguments: dict[str, Any], options: dict[str, Any]
) -> tuple[np.ndarray, np.ndarray, str]: ...
def classify_boundaries(
    cloud: Cloud, corners: np.ndarray, arguments: dict[str, Any], options: dict[str, Any]
) -> tuple[list[np.ndarray], str]: ...
def mesh_quality(cloud: Cloud, corners: np.ndarray, arguments: dict[str, Any]) -> str: ...
