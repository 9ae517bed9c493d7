// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: holes of which it is told early that nothing closes them.

#include "region/hopeless_holes.h"

#include "icadm/model_assembly.h"
#include "mesh/corners.h"

#include <map>

namespace pcl::repair {

namespace {

/** Triangles of the fill of a hole that run through the surface, and share of all that
 * run into something, above both of which it is hopeless: of 100 such holes of nine
 * scans and damaged models none was closed, of others with up to 27 through the surface
 * some, and such whose fill runs through itself only. */
constexpr std::size_t MOST_THROUGH_SURFACE = 32;
constexpr double MOST_IN_THE_WAY = 0.125;

struct Count {
  std::size_t triangles = 0;
  std::size_t obstructed = 0;
  std::size_t through_surface = 0; /**< not counted any further once there are many */
};

} // namespace

OpenReason
crossedEdges(const HolePolygon& hole,
             const IncompleteModel& model,
             const SurfaceObstacle& obstacle,
             ccaa::RunControl* control)
{
  const auto given = static_cast<pcl::index_t>(model.positions.size());
  const auto is_given = [&](std::size_t from, std::size_t to) {
    const pcl::index_t a = hole.vertices[from], b = hole.vertices[to];
    return a < given && b < given && areJoined(model, a, b);
  };
  return crossedEdges(hole.curve, is_given, obstacle, control);
}

std::vector<std::size_t>
hopelessHoles(const Patch& patch,
              const SurfaceObstacle& obstacle,
              ccaa::RunControl* control)
{
  std::vector<std::size_t> hopeless;
  const std::vector<std::size_t> obstructed =
      obstructedTriangles(patch, obstacle, control);
  if (obstructed.size() <= MOST_THROUGH_SURFACE)
    return hopeless;
  std::map<std::size_t, Count> counts; // of holes
  for (const std::size_t hole : patch.hole)
    ++counts[hole].triangles;
  for (const std::size_t t : obstructed) {
    Count& count = counts[patch.hole[t]];
    ++count.obstructed;
    if (count.through_surface <= MOST_THROUGH_SURFACE &&
        obstacle.meets(ccaa::cornersOf(patch.triangles[t], patch.positions), control))
      ++count.through_surface;
  }
  for (const auto& [hole, count] : counts)
    if (count.through_surface > MOST_THROUGH_SURFACE &&
        static_cast<double>(count.obstructed) >
            MOST_IN_THE_WAY * static_cast<double>(count.triangles))
      hopeless.push_back(hole);
  return hopeless;
}

} // namespace pcl::repair
