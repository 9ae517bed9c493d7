#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: clouds of shapes that are known, for the gallery.
#
# usage: make_shape.sh NAME >CLOUD.xyz
#
# body      a bumpy body in three pieces, as an occluded scan leaves it
# cube      a cube without one of its corners
# knot      a trefoil knot of a thin tube, whose strands pass close to each other
# layers    two scans of a bumpy body that are noisy, and registered badly
# moebius   a band with one side only
# roll      a rolled sheet, its layers five spacings apart
# statue    a body that is dense in front and sparse behind
# wall      both sides of a wall that is half as thick as its points are far apart
#
# The same points everywhere: the random numbers are made here.

set -euo pipefail

awk -v name="${1:?}" '
  function random() { seed = (seed * 16807) % 2147483647; return seed / 2147483647 }
  # Nearly normal, of deviation 1.
  function noise(    sum, i) { for (i = 0; i < 12; ++i) sum += random(); return sum - 6 }
  function put(x, y, z) { printf "%.5f %.5f %.5f\n", x, y, z }

  # The point i of n that lie evenly on a bumpy body, pushed outward.
  function bumpy(i, n, push,    turn, r, size) {
    bz = 1 - (2 * i + 1) / n
    turn = 2.399963229728653 * i # the golden angle
    r = sqrt(1 - bz * bz)
    size = push + 0.85 + 0.1 * sin(3 * turn) * r * r * r + 0.05 * cos(5 * bz)
    bx = size * r * cos(turn)
    by = size * r * sin(turn)
    bz *= size
  }

  function body(    i) {
    for (i = 0; i < 16000; ++i) {
      bumpy(i, 16000, 0)
      if (!(bx - 0.4 * by > -0.25 && bx - 0.4 * by < -0.1) && !(bz > 0.3 && bz < 0.38))
        put(bx, bz, by)
    }
  }

  function layers(    i) {
    for (i = 0; i < 9000; ++i) {
      bumpy(i, 9000, 0.006 * noise())
      put(bx, bz, by)
      bumpy(i + 0.5, 9000, 0.006 * noise())
      put(bx + 0.02, bz + 0.01, by)
    }
  }

  function statue(    i) {
    for (i = 0; i < 40000; ++i) {
      bumpy(i, 40000, 0)
      if (random() < 0.03 + 0.97 * (by > 0 ? by : 0) ^ 2)
        put(bx, bz, by)
    }
  }

  function cube(    n, i, j, k, u, v) {
    n = 44
    for (i = 0; i <= n; ++i)
      for (j = 0; j <= n; ++j)
        for (k = 0; k <= n; ++k) {
          u = (i % n == 0) + (j % n == 0) + (k % n == 0)
          if (u > 0 && i + j + k < 2.35 * n) put(i / n, j / n, k / n)
        }
  }

  function knot(    i, j, n, m, t, x, y, z, tx, ty, tz, l, nx, ny, nz, bx, by, bz, a) {
    n = 620
    m = 26
    for (i = 0; i < n; ++i) {
      t = 6.283185307179586 * i / n
      x = sin(t) + 2 * sin(2 * t)
      y = cos(t) - 2 * cos(2 * t)
      z = -0.75 * sin(3 * t)
      tx = cos(t) + 4 * cos(2 * t)
      ty = -sin(t) + 4 * sin(2 * t)
      tz = -2.25 * cos(3 * t)
      l = sqrt(tx * tx + ty * ty + tz * tz)
      tx /= l; ty /= l; tz /= l
      l = sqrt(tx * tx + ty * ty)
      nx = ty / l; ny = -tx / l; nz = 0
      bx = ty * nz - tz * ny; by = tz * nx - tx * nz; bz = tx * ny - ty * nx
      for (j = 0; j < m; ++j) {
        a = 6.283185307179586 * (j + i % 2 / 2) / m
        put(x + 0.4 * (cos(a) * nx + sin(a) * bx), y + 0.4 * (cos(a) * ny + sin(a) * by),
            z + 0.4 * (cos(a) * nz + sin(a) * bz))
      }
    }
  }

  function moebius(    i, j, t, s) {
    for (i = 0; i < 360; ++i)
      for (j = 0; j <= 30; ++j) {
        t = 6.283185307179586 * (i + j % 2 / 2) / 360
        s = j / 30 - 0.5
        put((1.5 + s * cos(t / 2)) * cos(t), (1.5 + s * cos(t / 2)) * sin(t), s * sin(t / 2))
      }
  }

  function roll(    i, j, t, step) {
    step = 0.02
    for (t = 4; t < 20; t += step / (0.016 * t))
      for (j = 0; j <= 60; ++j)
        put(0.016 * t * cos(t), step * (j + i++ % 7 / 14), 0.016 * t * sin(t))
  }

  function wall(    i, j, k) {
    for (i = 0; i <= 90; ++i)
      for (j = 0; j <= 60; ++j)
        for (k = 0; k < 2; ++k)
          put(i / 60 + 0.002 * noise(), j / 60 + 0.002 * noise(), k / 120 + 0.0008 * noise())
  }

  BEGIN {
    seed = 1
    if (name == "body") body()
    else if (name == "cube") cube()
    else if (name == "knot") knot()
    else if (name == "layers") layers()
    else if (name == "moebius") moebius()
    else if (name == "roll") roll()
    else if (name == "statue") statue()
    else if (name == "wall") wall()
    else { print "make_shape.sh: no shape " name >"/dev/stderr"; exit 1 }
  }'
