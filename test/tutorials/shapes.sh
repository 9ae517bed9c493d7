# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: small clouds and meshes for the tests of tutorials.

# A closed, bumpy body of the size of the Bunny in the tutorials, as an OBJ cloud.
# make_cloud POINTS FILE.obj
make_cloud() {
  awk -v n="$1" 'BEGIN {
    for (i = 0; i < n; ++i) {
      z = 1 - (2 * i + 1) / n
      turn = 2.399963229728653 * i # the golden angle: points spread evenly
      r = sqrt(1 - z * z)
      size = 0.85 + 0.1 * sin(3 * turn) * r * r * r + 0.05 * cos(5 * z)
      printf "v %.6f %.6f %.6f\n", size * r * cos(turn), size * z, size * r * sin(turn)
    }
  }' >"$2"
}

# make_frame POINTS FILE.pcd
make_frame() {
  make_cloud "$1" cloud.obj
  awk -v points="$1" 'BEGIN { print "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1"
      print "WIDTH", points "\nHEIGHT 1\nPOINTS", points "\nDATA ascii" }
    /^v / { print $2, $3, $4 }' cloud.obj >"$2"
}
