#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: installs the missing Debian packages, and only those.
#
# usage: install_dependencies.sh [demo|python|test|workflow|benchmark|package|--update]   (default: test)
#   demo       what it takes to build and run the programs
#   python     that, and what the Python package and pip take
#   test       that, and what the tests, the format check and the sanitizers need
#   workflow   that, and Snakemake and Slurm, which the tests of the tile workflow need
#   benchmark  that of test, and CGAL and Open3D as competitors
#   package    what it takes to build the programs, the site and the Debian packages
#   --update   installs nothing, renews apt's lists of packages

set -euo pipefail

packages=(build-essential cmake ninja-build ccache libpcl-dev libeigen3-dev
          libflann-dev libboost-program-options-dev nlohmann-json3-dev
          libnanoflann-dev xvfb xauth)
python_packages=(pybind11-dev python3-dev python3-numpy python3-pip python3-venv)
test_packages=("${python_packages[@]}" python3-pytest python3-tqdm mypy clang-format libgtest-dev clang lld libclang-rt-14-dev libomp-dev llvm doxygen
               man-db pkgconf dpkg-dev file pcl-tools xdotool)
package_packages=("${python_packages[@]}" doxygen dpkg-dev file lintian)
# Some 90 packages, and minutes until they are set up.
workflow_packages=(snakemake slurm-wlm munge)
benchmark_packages=(libcgal-dev libopen3d-dev)

as_root=()
if ((EUID != 0)); then
  as_root=(sudo)
fi

# Mirrors fail now and then: try again before giving up.
retry() {
  local attempt
  for attempt in 1 2 3; do
    "$@" </dev/null && return 0
    echo "attempt $attempt failed: $*" >&2
    sleep $((5 * attempt))
  done
  return 1
}

purpose=${1:-test}
case $purpose in
  demo) ;;
  python) packages+=("${python_packages[@]}") ;;
  test) packages+=("${test_packages[@]}") ;;
  workflow) packages+=("${test_packages[@]}" "${workflow_packages[@]}") ;;
  benchmark) packages+=("${test_packages[@]}" "${benchmark_packages[@]}") ;;
  package) packages+=("${package_packages[@]}") ;;
  --update)
    retry "${as_root[@]}" apt-get update -qq
    exit
    ;;
  *)
    echo "install_dependencies.sh: unknown purpose '$purpose'" >&2
    exit 1
    ;;
esac

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  [[ $status == installed ]] || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
  exit 0
fi

echo "Installing: ${missing[*]}"
retry "${as_root[@]}" apt-get update -qq
retry "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
