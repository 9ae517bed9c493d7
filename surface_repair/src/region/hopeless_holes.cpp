// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: holes of which it is told early that nothing closes them.

#include "region/hopeless_holes.h"

#include "icadm/model_assembly.h"
#include "mesh/corners.h"

#include <algorithm>
#include <map>
#include <optional>

namespace pcl::repair {

namespace {

/** Triangles of the fill of a hole that run through the surface, and share of all that
 * run into something, above both of which it is hopeless: of 100 such holes of nine
 * scans and damaged models none was closed, of others with up to 27 through the surface
 * some, and such whose fill runs through itself only. */
constexpr std::size_t MOST_THROUGH_SURFACE = 32;
constexpr double MOST_IN_THE_WAY = 0.125;

/** Triangles of a fill that are looked at first: of a hopeless one some run through the
 * surface, of most others none. */
constexpr std::size_t FIRST_LOOKED_AT = 64;

class HopelessHoles {
public:
  HopelessHoles(const Patch& patch,
                const SurfaceObstacle& obstacle,
                ccaa::RunControl* control)
  : patch_(patch), obstacle_(obstacle), control_(control)
  {}

  std::vector<std::size_t>
  find()
  {
    std::map<std::size_t, std::vector<std::size_t>> fills; // of holes: triangles
    for (std::size_t t = 0; t < patch_.triangles.size(); ++t)
      fills[patch_.hole[t]].push_back(t);
    std::vector<std::size_t> hopeless;
    for (const auto& [hole, fill] : fills)
      if (fill.size() > MOST_THROUGH_SURFACE && isHopeless(fill))
        hopeless.push_back(hole);
    return hopeless;
  }

private:
  bool
  isHopeless(const std::vector<std::size_t>& fill)
  {
    const auto most =
        static_cast<std::size_t>(MOST_IN_THE_WAY * static_cast<double>(fill.size()));
    if (throughSurface(fill, fill.size() / FIRST_LOOKED_AT + 1, 0) == 0)
      return false;
    const std::size_t through =
        throughSurface(fill, 1, std::max(most, MOST_THROUGH_SURFACE));
    return through > MOST_THROUGH_SURFACE && (through > most || inTheWay(fill) > most);
  }

  /** Of every so many triangles those that run through the surface, as soon as they
   * are more than enough. */
  std::size_t
  throughSurface(const std::vector<std::size_t>& fill,
                 std::size_t step,
                 std::size_t enough) const
  {
    std::size_t through = 0;
    for (std::size_t i = 0; i < fill.size() && through <= enough; i += step)
      if (obstacle_.meets(ccaa::cornersOf(patch_.triangles[fill[i]], patch_.positions),
                          control_))
        ++through;
    return through;
  }

  std::size_t
  inTheWay(const std::vector<std::size_t>& fill)
  {
    if (!obstructed_)
      obstructed_ = obstructedTriangles(patch_, obstacle_, control_);
    return static_cast<std::size_t>(
        std::count_if(fill.begin(), fill.end(), [&](std::size_t t) {
          return std::binary_search(obstructed_->begin(), obstructed_->end(), t);
        }));
  }

  const Patch& patch_;
  const SurfaceObstacle& obstacle_;
  ccaa::RunControl* control_;
  std::optional<std::vector<std::size_t>> obstructed_; /**< once asked for */
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
  return HopelessHoles(patch, obstacle, control).find();
}

} // namespace pcl::repair
