# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: builds the wheel with CMake and Python's own library alone.
"""What pip asks of a project (PEP 517). A wheel holds the libraries; PCL is that of the system.

Settings: build-dir, the folder that CMake builds in, for who builds again (else one that goes),
and cmake-args, what else CMake is told.
"""
import base64
import hashlib
import os
import re
import shlex
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import tomllib
import zipfile
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]


def _project():
    project = tomllib.loads((TOP / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    lists = (TOP / "CMakeLists.txt").read_text(encoding="utf-8")
    return project | {"version": re.search(r"^  VERSION ([0-9.]+)$", lists, re.M)[1]}


def _stem(project):
    return f"{project['name']}-{project['version']}"


def _metadata(project):
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {project['version']}",
             f"Summary: {project['description']}", f"License: {project['license']['text']}",
             f"Requires-Python: {project['requires-python']}",
             *(f"Requires-Dist: {name}" for name in project["dependencies"]),
             "Description-Content-Type: text/markdown", "",
             (TOP / project["readme"]).read_text(encoding="utf-8")]
    return "\n".join(lines)


def _build(folder, arguments):
    """The package, whole; our libraries become part of its module."""
    subprocess.run(["cmake", "-S", TOP, "-B", folder, "-DCMAKE_BUILD_TYPE=Release",
                    "-DBUILD_SHARED_LIBS=OFF", "-DPSR_UNITY_BUILD=ON", "-DPSR_BUILD_APPS=OFF",
                    "-DPSR_BUILD_TESTS=OFF", "-DPSR_BUILD_EXAMPLES=OFF",
                    "-DPSR_BUILD_PYTHON=REQUIRED", "-DPSR_WARNINGS_AS_ERRORS=OFF",
                    "-DCMAKE_SKIP_RPATH=ON", "-DCMAKE_MODULE_LINKER_FLAGS=-s",
                    f"-DPython_EXECUTABLE={sys.executable}", *arguments], check=True)
    subprocess.run(["cmake", "--build", folder, "--target", "pclsurfacerepair_python",
                    "--parallel", str(os.cpu_count())], check=True)
    return Path(folder) / "python" / "pclsurfacerepair"


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """Without it pip would build a wheel to look into it, and then another one."""
    project = _project()
    info = Path(metadata_directory) / f"{_stem(project)}.dist-info"
    info.mkdir()
    (info / "METADATA").write_text(_metadata(project), encoding="utf-8")
    return info.name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    project = _project()
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = re.sub("[-.]", "_", sysconfig.get_platform())
    tag = f"{python}-{python}-{platform}"
    info = f"{_stem(project)}.dist-info"
    name = f"{_stem(project)}-{tag}.whl"
    settings = config_settings or {}
    with tempfile.TemporaryDirectory() as folder:
        package = _build(settings.get("build-dir", folder),
                         shlex.split(settings.get("cmake-args", "")))
        files = {f"pclsurfacerepair/{file.name}": file.read_bytes()
                 for file in sorted(package.iterdir()) if file.is_file()}
    files[f"{info}/METADATA"] = _metadata(project).encode()
    files[f"{info}/WHEEL"] = (f"Wheel-Version: 1.0\nGenerator: {project['name']}\n"
                              f"Root-Is-Purelib: false\nTag: {tag}\n").encode()
    files[f"{info}/LICENSE"] = (TOP / "LICENSE").read_bytes()
    record = "".join(
        f"{path},sha256={base64.urlsafe_b64encode(hashlib.sha256(data).digest()).decode().rstrip('=')}"
        f",{len(data)}\n" for path, data in files.items())
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    with zipfile.ZipFile(Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, data in files.items():
            wheel.writestr(path, data)
    return name


def build_sdist(sdist_directory, config_settings=None):
    project = _project()
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=TOP, check=True, capture_output=True)
    name = f"{_stem(project)}.tar.gz"
    with tempfile.TemporaryDirectory() as folder, \
            tarfile.open(Path(sdist_directory) / name, "w:gz", format=tarfile.PAX_FORMAT) as archive:
        about = Path(folder) / "PKG-INFO"
        about.write_text(_metadata(project), encoding="utf-8")
        archive.add(about, f"{_stem(project)}/PKG-INFO")
        for path in filter(None, listed.stdout.decode().split("\0")):
            archive.add(TOP / path, f"{_stem(project)}/{path}")
    return name
