// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: generated scenes of several objects, and what a sensor sees
// of them.
#pragma once

#include "shapes.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::ccaa::test {

/** \brief Closed bodies that do not touch. */
struct Scene {
  std::vector<Shape> objects;
};

/** \brief 2 to 5 warped, stretched and turned spheres, boxes and rings around the
 * origin, within 2 units of it; some stand close to each other. */
Scene
randomScene(std::uint64_t seed);

/** \brief How a scene is seen. */
struct ViewSettings {
  Position sensor = Position(0.0, 0.0, 8.0); /**< it looks at the origin */
  std::size_t pixels = 180;                  /**< of the longer side of the view */
  double noise = 0.1;        /**< deviation along the ray, in distances of pixels */
  double longest_edge = 4.0; /**< of a triangle, in distances of pixels */
  std::size_t spots = 3;     /**< round places without measurement */
  std::uint64_t seed = 1;
};

/** \brief A range map of a scene: a triangle between neighbouring pixels, where its
 * edges are short enough. Every vertex has a triangle; all face the sensor. */
Shape
rangeMap(const Scene& scene, const ViewSettings& settings);

/** \brief All objects as one shape, one after the other. */
Shape
asShape(const Scene& scene);

} // namespace pcl::ccaa::test
