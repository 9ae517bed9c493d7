#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: installs what is missing, builds everything, runs the tests.
#
# usage: run_tests.sh [PRESET]     a preset of CMakePresets.json (default: release)

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
preset=${1:-release}

scripts/install_dependencies.sh test
scripts/check_format.sh
cmake --preset "$preset"
cmake --build --preset "$preset"
ctest --preset "$preset" -j "$(nproc)"
