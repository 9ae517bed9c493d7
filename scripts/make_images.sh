#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: renews the pictures under doc/images from the demo's mesh.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/demo.sh
render=build/release/bin/pcl_render_mesh
mesh=build/demo/bunny.ply
images=doc/images

mkdir -p "$images"
"$render" build/demo/bunny_cloud.obj "$images/bunny_cloud.png" --size 600x480 --point-size 1.5
"$render" "$mesh" "$images/bunny_mesh.png" --size 600x480
"$render" "$mesh" "$images/bunny_detail.png" --size 600x480 --zoom 6 --edges \
  --focus=-0.45,0.45,0.5
