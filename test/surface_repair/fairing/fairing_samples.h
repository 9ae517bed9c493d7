// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: shapes with a hole and a patch in it, for tests.
#pragma once

#include <gtest/gtest.h>

#include "filling/patch.h"
#include "support/shapes.h"

#include <functional>

namespace pcl::repair::test {

/** \brief A model with one hole, and a patch that closes it. */
struct PatchedHole {
  IncompleteModel model;
  Patch patch;
  Positions lost; /**< vertices of the shape that the model has not */
};

/** \brief Remove the triangles whose vertices all are taken, a disc, and close the hole
 * with a fan from the centroid of its rim. */
PatchedHole
withFan(const ccaa::test::Shape& shape,
        const std::function<bool(const Position&)>& isLost);

/** \brief The same, with a strip that zigzags across and has no vertex within. */
PatchedHole
withStrip(const ccaa::test::Shape& shape,
          const std::function<bool(const Position&)>& isLost);

/** \brief A sphere of radius 1 without the cap above z = cos(angle), closed by a fan.
 */
PatchedHole
cappedSphere(int subdivisions, double angle);

/** \brief A square grid of 2 n + 1 points each way, spacing 1 around the origin,
 * without the disc of a radius, closed by a fan. */
PatchedHole
holedPlane(int n, double radius);

/** \brief Model and patch together are what a patch has to be: every edge has two
 * triangles that run through it in opposite directions, apart from the model's own
 * borders, and every vertex one fan. */
::testing::AssertionResult
isSound(const PatchedHole& hole);

/** \brief Vertices - edges + triangles of the patch. */
long
eulerCharacteristic(const Patch& patch);

/** \brief The largest distance of the patch's vertices from a surface. */
double
largestOf(const Patch& patch, const std::function<double(const Position&)>& distance);

} // namespace pcl::repair::test
