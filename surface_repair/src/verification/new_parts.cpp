// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what is new in a repaired model, part by part.

#include "verification/new_parts.h"

#include "boundary/boundary_loop.h"
#include "field/float_tree.h"
#include "mesh/corners.h"

#include <algorithm>
#include <set>

namespace pcl::repair {

namespace {

/** Length of the mean normal of what is flat: where something stood, or was cut off. */
constexpr double FLAT = 0.999;
/** Measured vertices that support what is new. */
constexpr std::size_t FEWEST_SAMPLES = 4;
/** Confidence of a junction up to which it supports nothing, and from which all. */
constexpr double UNSURE = 0.5;
constexpr double SURE = 0.75;

/** How little the junctions tell of what lies between loops, 0 to 1. */
double
doubtOfJunctions(const std::vector<RepairJunction>& junctions)
{
  double weakest = 1.0;
  for (const RepairJunction& junction : junctions)
    if (junction.verdict == JunctionVerdict::JOINED)
      weakest = std::min(weakest, junction.confidence);
  return std::clamp((SURE - weakest) / (SURE - UNSURE), 0.0, 1.0);
}

class NewParts {
public:
  NewParts(const RepairedModel& repaired,
           const RepairReport& report,
           std::size_t crumb_triangles)
  : model_(repaired.model)
  , report_(report)
  , input_triangles_(repaired.input_triangles)
  , doubt_of_junctions_(doubtOfJunctions(report.junctions))
  , is_new_(model_.triangles.size(), true)
  {
    std::fill_n(is_new_.begin(), input_triangles_, false);
    addCrumbs(crumb_triangles);
  }

  /** By lowest triangle. */
  std::vector<NewPart>
  list() const
  {
    std::vector<NewPart> list;
    std::vector<bool> is_seen(is_new_.size(), false);
    for (std::size_t t = 0; t < is_new_.size(); ++t) {
      if (!is_new_[t] || is_seen[t])
        continue;
      std::vector<std::size_t> triangles = connectedWith(t, is_new_.size(), is_seen);
      std::sort(triangles.begin(), triangles.end());
      list.push_back(partOf(triangles));
      list.back().piece = model_.island_of[t];
    }
    return list;
  }

private:
  /** Crumbs within a patch are part of it: they do not make it an annulus. */
  void
  addCrumbs(std::size_t crumb_triangles)
  {
    std::vector<bool> is_seen(is_new_.size(), false);
    for (std::size_t t = input_triangles_; t < is_new_.size(); ++t)
      for (int corner = 0; corner < 3; ++corner) {
        const pcl::index_t across =
            model_.adjacency.across(static_cast<pcl::index_t>(t), corner);
        if (across < 0 || is_new_[static_cast<std::size_t>(across)])
          continue;
        const std::vector<std::size_t> island =
            connectedWith(static_cast<std::size_t>(across), crumb_triangles, is_seen);
        for (const std::size_t triangle : island) {
          is_seen[triangle] = false;
          is_new_[triangle] = island.size() < crumb_triangles;
        }
      }
  }

  /** Triangles that edges connect with one and that are new like it, or are not: all
   * that there are, or as many as are enough. */
  std::vector<std::size_t>
  connectedWith(std::size_t first, std::size_t enough, std::vector<bool>& is_seen) const
  {
    std::vector<std::size_t> found{first};
    is_seen[first] = true;
    for (std::size_t i = 0; i < found.size() && found.size() < enough; ++i)
      for (int corner = 0; corner < 3; ++corner) {
        const std::size_t other = likeAcross(found[i], corner);
        if (other == NONE || is_seen[other])
          continue;
        is_seen[other] = true;
        found.push_back(other);
      }
    return found;
  }

  /** The triangle beyond an edge of one, if it is new like that one, or is not; or
   * NONE. */
  std::size_t
  likeAcross(std::size_t triangle, int corner) const
  {
    const pcl::index_t other =
        model_.adjacency.across(static_cast<pcl::index_t>(triangle), corner);
    return other >= 0 && is_new_[static_cast<std::size_t>(other)] == is_new_[triangle]
               ? static_cast<std::size_t>(other)
               : NONE;
  }

  /** Of a triangle, 0 to 1: how little tells of what it stands for. */
  double
  doubtOf(std::size_t triangle) const
  {
    if (report_.hole_of[triangle] == NONE)
      return 0.0;
    const RepairedHole& hole = report_.holes[report_.hole_of[triangle]];
    const bool joins =
        hole.islands.size() > 1 ||
        std::any_of(hole.bridges.begin(), hole.bridges.end(), [&](std::size_t bridge) {
          return !report_.bridges[bridge].within_hole;
        });
    if (report_.origins[triangle] == TriangleOrigin::COMPLETION ||
        (joins && hole.bridges.empty() && hole.free_points >= FEWEST_SAMPLES))
      return 0.0;
    return joins && !hole.bridges.empty() ? doubt_of_junctions_ : 1.0;
  }

  NewPart
  partOf(const std::vector<std::size_t>& triangles) const
  {
    NewPart part;
    std::set<pcl::index_t> vertices;
    std::set<pcl::index_t> rim;
    for (const std::size_t number : triangles) {
      const Triangle& triangle = model_.triangles[number];
      const ccaa::Corners corners = ccaa::cornersOf(triangle, model_.positions);
      const Eigen::Vector3d normal = 0.5 * ccaa::areaNormal(corners);
      const double area = normal.norm();
      part.area += area;
      part.unsupported += doubtOf(number) * area;
      part.out += normal;
      part.center += area / 3.0 * (corners[0] + corners[1] + corners[2]);
      vertices.insert(triangle.begin(), triangle.end());
      for (int i = 0; i < 3; ++i) {
        if (likeAcross(number, i) != NONE)
          continue;
        const auto from = static_cast<std::size_t>(i);
        const std::size_t to = (from + 1) % 3;
        part.rim += (corners[to] - corners[from]).norm();
        rim.insert(triangle[from]);
      }
    }
    part.center /= part.area;
    if (part.out.norm() > FLAT * part.area)
      part.unsupported = 0.0;
    // Each triangle has three edges, and all but those of the rim have two triangles:
    // with as many edges as vertices on it, V - E + F is V - R / 2 - F / 2.
    part.is_disc = 2 * vertices.size() == triangles.size() + rim.size() + 2;
    part.point = lowestPoint(model_, {rim.begin(), rim.end()});
    findFarthestCrumb(triangles, rim, part);
    return part;
  }

  void
  findFarthestCrumb(const std::vector<std::size_t>& triangles,
                    const std::set<pcl::index_t>& rim,
                    NewPart& part) const
  {
    std::set<pcl::index_t> crumbs;
    for (const std::size_t number : triangles)
      if (number < input_triangles_)
        crumbs.insert(model_.triangles[number].begin(), model_.triangles[number].end());
    if (crumbs.empty() || rim.empty())
      return;
    const auto at = [&](pcl::index_t vertex) -> const Position& {
      return model_.positions[static_cast<std::size_t>(vertex)];
    };
    Positions places;
    for (const pcl::index_t vertex : rim)
      places.push_back(at(vertex));
    const FloatTree tree(places);
    for (const pcl::index_t vertex : crumbs) {
      const auto nearest =
          static_cast<std::size_t>(tree.nearest(at(vertex), 1).front());
      const double gap = (places[nearest] - at(vertex)).norm();
      if (gap <= part.crumb_gap)
        continue;
      part.crumb_gap = gap;
      part.crumb = model_.point_of_vertex[static_cast<std::size_t>(vertex)];
    }
  }

  const IncompleteModel& model_;
  const RepairReport& report_;
  std::size_t input_triangles_;
  double doubt_of_junctions_;
  std::vector<bool> is_new_; /**< of each triangle: it is, or a crumb */
};

} // namespace

std::vector<NewPart>
newParts(const RepairedModel& repaired,
         const RepairReport& report,
         std::size_t crumb_triangles)
{
  return NewParts(repaired, report, crumb_triangles).list();
}

} // namespace pcl::repair
