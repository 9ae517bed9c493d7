// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: seeded scenes of several objects as one sensor sees them.
#pragma once

#include <pcl/Vertices.h>

#include "mesh/triangle.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::ccaa::test {

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

/** \brief A frame of a depth camera in a room of 6 by 5 by 2.6 metres with 30 pieces of
 * furniture and things: depths in steps that grow with their square (26 mm at 3 m),
 * none beyond 4.5 m, none at half of the edges where depth jumps, and round spots
 * without any. Of 640 by 480 rays some 260 000 return. The sensor is the origin. */
SingleView
officeFrame(std::uint64_t seed, std::size_t columns = 640);

/** \brief What a laser scanner in an aeroplane measures: hilly ground, houses with flat
 * roofs, and trees whose crowns return points from anywhere within, two points a square
 * metre. \param[in] side of the square tile, in metres */
SingleView
aerialView(std::uint64_t seed, double side = 140.0);

/** \brief The same in the frame of its sensor, which is the origin. */
SingleView
inSensorFrame(SingleView view);

/** \brief Share of the triangles that show their front to a place. */
double
facingShare(const std::vector<pcl::Vertices>& triangles,
            const Positions& points,
            const Position& place);

} // namespace pcl::ccaa::test
