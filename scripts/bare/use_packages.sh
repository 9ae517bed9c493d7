#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: what check_packages.sh runs on the bare system.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

step() {
  echo
  echo "== $*"
}

install() {
  apt-get install -y -qq --no-install-recommends -o Dir::Log::Terminal= "$@" >/dev/null
}

# A sphere that was not seen from above.
sphere() {
  awk 'BEGIN {
    n = 2000
    for (i = 0; i < n; ++i) {
      z = 1 - (2 * i + 1) / n
      r = sqrt(1 - z * z)
      if (z < 0.95) print r * cos(2.39996323 * i), r * sin(2.39996323 * i), z
    }
  }'
}

step "the programs"
apt-get update -qq
install ./libpclsurfacerepair[0-9]*.deb ./pclsurfacerepair-tools_*.deb xvfb xauth
mapfile -t programs < <(dpkg -L pclsurfacerepair-tools | sed -n 's|^/usr/bin/||p')
for program in "${programs[@]}"; do
  "$program" --version
done
sphere >sphere.xyz
pcl_ccaa_reconstruct sphere.xyz sphere.ply
pcl_repair_holes sphere.ply whole.ply --report repair.json
pcl_mesh_quality whole.ply
pcl_damage_cloud whole.ply damaged.ply --spheres 2
pcl_render_mesh damaged.ply damaged.png --size 300x200
head -c 8 damaged.png | grep -q PNG

step "the Python package"
install ./python3-pcl-surface-repair_*.deb
python3 - <<'END'
import numpy as np
import pclsurfacerepair as psr
_, report = psr.repair(psr.reconstruct(np.loadtxt("sphere.xyz")))
print(report.verdict)
assert report.complete
END

step "a user's program, with pkg-config and with CMake"
install ./libpclsurfacerepair-dev_*.deb ./libpclsurfacerepair-doc_*.deb g++ make cmake \
  pkg-config
cp -r /usr/share/doc/PclSurfaceRepair/test/consumer consumer
make -C consumer CXXFLAGS=-O1
consumer/repair_scan
cmake -S consumer -B consumer/build -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build consumer/build --target repair_scan
consumer/build/repair_scan

step "nothing stays behind"
mapfile -t installed < <(dpkg-query -f '${Package}\n' -W '*pclsurfacerepair*' python3-pcl-surface-repair)
mapfile -t files < <(dpkg -L "${installed[@]}" | sort -u)
apt-get purge -y -qq -o Dir::Log::Terminal= "${installed[@]}" >/dev/null
for file in "${files[@]}"; do
  if [[ -f $file ]]; then
    echo "left behind: $file" >&2
    exit 1
  fi
done
echo "The packages install, work, and go."
