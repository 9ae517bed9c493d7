#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: the tile workflow makes the files that one process makes.
#
# usage: tile_workflow.sh CASE SOURCE PROGRAMS SCRATCH [OPTION OF SNAKEMAKE...]
#   undisturbed  nothing happens
#   worker       a worker is killed: its tile is done again, in the same run
#   job          a job of a scheduler is killed with all its processes: the same
#   machine      all is killed: a second run does no finished step again

set -euo pipefail
check=$1
source=$2
programs=$3
scratch=$4
options=("${@:5}")
if ((${#options[@]} == 0)); then
  options=(--cores 2)
  # One step at a time: no other one is killed with it.
  [[ $check != machine ]] || options=(--cores 1)
fi
if ! command -v snakemake >/dev/null; then
  echo 'skipped: Snakemake is not installed (scripts/install_dependencies.sh workflow)'
  exit 0
fi

rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch"
# Keeps the caches of Snakemake in the folder of the test.
export XDG_CACHE_HOME=$scratch/cache LC_ALL=C

# A sphere with waves, 30,000 points in a spiral less some: a hole at the corner of eight
# tiles, and one within a tile.
awk 'BEGIN {
  count = 30000
  for (i = 0; i < count; ++i) {
    z = 1 - 2 * (i + 0.5) / count
    r = sqrt(1 - z * z)
    x = r * cos(2.399963229728653 * i)
    y = r * sin(2.399963229728653 * i)
    radius = 1 + 0.1 * sin(5 * x) * sin(4 * y) * sin(6 * z)
    if (x > 0.99 || x * 0.5 + y * 0.6 + z * 0.62 > 0.996)
      continue
    lines[left++] = sprintf("%.6f %.6f %.6f", radius * x, radius * y, radius * z)
  }
  printf "ply\nformat ascii 1.0\nelement vertex %d\n", left
  print "property float x\nproperty float y\nproperty float z\nend_header"
  for (i = 0; i < left; ++i)
    print lines[i]
}' >cloud.ply

"$programs/pcl_ccaa_reconstruct" cloud.ply expected.ply --tiles=5000 --repair \
  --tile-folder=expected --quiet

# Writes down what is run. While 'killed' is not there, the meshing of one tile dies in
# the middle, in some cases with all processes of its group.
cat >tiles_program <<END
#!/usr/bin/env bash
[[ \$1 == cut && -e \$2/plan.json ]] || echo "\$1 \$3" >>"$scratch/steps"
if [[ "\$1 \$3" == 'mesh 000003' && $check != undisturbed ]] && mkdir "$scratch/killed" 2>/dev/null; then
  "$programs/pcl_ccaa_tiles" "\$@" &
  sleep 0.02
  kill -KILL \$! || true
  touch "\$2/.000003.mesh.part-1"
  [[ $check == worker ]] || kill -KILL 0
  exit 137
fi
exec "$programs/pcl_ccaa_tiles" "\$@"
END
chmod +x tiles_program

workflow() {
  snakemake --snakefile "$source/scripts/tiles/Snakefile" "${options[@]}" "$@" --config \
    inputs=cloud.ply folder=tiles tiles="${most_points:-5000}" output=mesh.ply options=--repair program="$scratch/tiles_program"
}

if [[ $check == machine ]]; then
  export -f workflow
  export source scratch
  setsid --wait bash -c 'options=("$@"); workflow' all "${options[@]}" \
    >first.log 2>&1 && { echo 'the first run was not killed' >&2; exit 1; }
  workflow --unlock >unlock.log 2>&1
fi
workflow --rerun-incomplete --rerun-triggers mtime >run.log 2>&1 || { cat run.log; exit 1; }

sums() {
  (cd "$1" && sha256sum -- *.ply index.json)
}
diff <(sums expected) <(sums tiles)
cmp expected.ply mesh.ply
# What is no longer needed is gone.
diff <(ls expected | grep -v '\.joined$') <(ls -A tiles | grep -vxE 'neighbors|seams|regions')

tiles=$("$programs/pcl_ccaa_tiles" count tiles)
((tiles > 4)) || { echo "only $tiles tiles" >&2; exit 1; }
again=$(sort steps | uniq -d)
case $check in
  undisturbed) [[ -z $again ]] ;;
  *) [[ $again == 'mesh 000003' ]] ;;
esac || { echo "done again: $again" >&2; exit 1; }

if [[ $check == undisturbed ]]; then
  cp steps steps_before
  workflow >again.log 2>&1
  cmp steps_before steps
  # Other parameters in the same folder are refused.
  most_points=4000 workflow >refused.log 2>&1 && exit 1
  grep -q 'other parameters' refused.log
  cmp steps_before steps
  diff <(sums expected) <(sums tiles)
fi
