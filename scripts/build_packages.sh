#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: builds the Debian packages into build/packages.
#
# The documentation site goes into the package of the documentation.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/install_dependencies.sh package
scripts/build_docs.sh
cmake --preset release -DPSR_BUILD_TESTS=OFF
cmake --build --preset release --target apps pclsurfacerepair_python
rm -rf build/packages
cpack --config build/release/CPackConfig.cmake -G DEB -B "$PWD/build/packages"
rm -rf build/packages/_CPack_Packages
if command -v lintian >/dev/null; then
  lintian --allow-root build/packages/*.deb
fi
echo
echo "Packages: $PWD/build/packages"
ls build/packages
