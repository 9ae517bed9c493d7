#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: pip makes a wheel without network, and the wheel works.
#
# usage: check_wheel.sh [PYTHON]      result: build/wheel/*.whl; ccache knows what the release
#                                     preset has compiled with the same options

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
python=${1:-/usr/bin/python3}
wheels=$PWD/build/wheel

scripts/install_dependencies.sh python
export CMAKE_GENERATOR=Ninja PIP_NO_INDEX=1 PIP_DISABLE_PIP_VERSION_CHECK=1
rm -rf "$wheels"/*.whl "$wheels/venv"
"$python" -m pip wheel . --no-deps --wheel-dir "$wheels" \
  --config-settings "build-dir=$PWD/build/wheel-objects" \
  --config-settings "cmake-args=-DPSR_WARNINGS_AS_ERRORS=ON"
"$python" -m venv --system-site-packages "$wheels/venv"
"$wheels/venv/bin/pip" install --quiet "$wheels"/pclsurfacerepair-*.whl
cd "$wheels"
env -u PYTHONPATH "$wheels/venv/bin/python" - <<'END'
from pathlib import Path

import numpy as np
import pclsurfacerepair as psr

package = Path(psr.__file__).parent
assert "venv" in package.parts, package
for name in ("py.typed", "_core.pyi", "_options.py"):
    assert (package / name).exists(), f"the wheel lacks {name}"
k = np.arange(2000)
z = 1 - (2 * k + 1) / 2000
r = np.sqrt(1 - z * z)
points = np.c_[r * np.cos(2.39996323 * k), r * np.sin(2.39996323 * k), z][z < 0.95]
assert psr.repair(psr.reconstruct(points))[1].verdict == "watertight, 1 piece"
try:
    psr.reconstruct(points[:2])
except ValueError as error:
    assert "2 usable points" in str(error), error
END
echo "Wheel: $(ls "$wheels"/*.whl)"
