// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: seeded scenes of several objects as one sensor sees them.
#pragma once

#include <pcl/Vertices.h>

#include "mesh/triangle.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace ccaa {
namespace test {

/** \brief What a sensor has measured. */
struct SingleView {
  Positions points;
  Position sensor = Position::Zero();
};

/** \brief Spheres and boxes above a piece of uneven floor, seen through a raster of
 * rays from one place: each ray gives its nearest hit, with noise of a tenth of the
 * spacing. What lies behind is not there, so that the objects are islands. Turned and
 * moved at random; the sensor is 5 to 8 units away, objects are 0.3 to 0.9 in size.
 * \param[in] rays along each side of the raster */
SingleView
singleView(std::uint64_t seed, std::size_t rays = 120);

/** \brief The same in the frame of its sensor, which is the origin. */
SingleView
inSensorFrame(SingleView view);

/** \brief Share of the triangles that show their front to a place. */
double
facingShare(const std::vector<pcl::Vertices>& triangles,
            const Positions& points,
            const Position& place);

} // namespace test
} // namespace ccaa
} // namespace pcl
