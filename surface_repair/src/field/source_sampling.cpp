// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: resampling boundaries to field sources (4.46).
#include "field/source_sampling.h"

#include "field/curve_walk.h"
#include "mesh/box_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::repair {
namespace {

/** \brief Fewest sources of a boundary: less do not show its shape. */
constexpr std::size_t FEWEST_SOURCES = 8;

/** \brief A mean direction shorter than this says nothing: the curve turns back within
 * the window. */
constexpr double LEAST_MEAN = 1e-6;

std::size_t
sourceCount(const BoundaryCurve& curve, double length, double spacing)
{
  const auto edges = static_cast<double>(curve.size());
  const double wanted = spacing > 0.0 ? std::round(length / spacing) : edges;
  return std::max(FEWEST_SOURCES, static_cast<std::size_t>(wanted));
}

/** \brief The part of a direction across the tangent, unit; null where there is none.
 */
Direction
across(const Eigen::Vector3d& direction, const Direction& tangent)
{
  const Eigen::Vector3d part = direction - tangent * tangent.dot(direction);
  const double norm = part.norm();
  return norm > LEAST_MEAN ? Direction(part / norm) : Direction(Direction::Zero());
}

/** \brief Tangent of the curve smoothed by a window: the integral of tau over it is the
 * chord. */
Direction
tangentAt(const BoundaryCurve& curve, const CurveWalk& walk, double arc, double window)
{
  const Eigen::Vector3d chord =
      walk.positionAt(arc + 0.5 * window) - walk.positionAt(arc - 0.5 * window);
  if (chord.norm() > LEAST_MEAN * window)
    return chord.normalized();
  return curve.edge(walk.edgeAt(arc)).normalized();
}

/** \brief Normal of the smoothed curve, the edge's own or, at the worst, any across the
 * tangent. */
Direction
normalAt(const BoundaryCurve& curve,
         const CurveWalk& walk,
         const FieldSource& source,
         double window)
{
  const Eigen::Vector3d mean = (walk.normalIntegral(source.arc + 0.5 * window) -
                                walk.normalIntegral(source.arc - 0.5 * window)) /
                               window;
  Direction normal = across(mean, source.tangent);
  const Direction& of_edge = curve.normals[walk.edgeAt(source.arc)];
  if (normal.isZero() && of_edge.allFinite())
    normal = across(of_edge, source.tangent);
  return normal.isZero() ? Direction(source.tangent.unitOrthogonal()) : normal;
}

Eigen::AlignedBox3d
boxOf(const BoundaryCurve& curve)
{
  Eigen::AlignedBox3d box;
  for (const Position& point : curve.points)
    box.extend(point);
  return box;
}

/** \brief A loop as C4.46-1 sees it. */
struct LoopExtent {
  Eigen::AlignedBox3d box;
  double size = 0.0; /**< effective size */
};

std::vector<LoopExtent>
extentsOf(const BoundaryLoops& loops)
{
  std::vector<LoopExtent> extents;
  for (const BoundaryLoop& loop : loops) {
    const Eigen::AlignedBox3d box = boxOf(loop.curve);
    extents.push_back({box, box.isEmpty() ? 0.0 : box.diagonal().norm()});
  }
  return extents;
}

/** \brief The points of a curve, for asking whether one lies within a distance. */
class NearbyPoints {
public:
  explicit NearbyPoints(const Positions& points)
  : points_(points), tree_(std::vector<ccaa::Box>(points.begin(), points.end()))
  {}

  bool
  anyWithin(const Position& center, double distance) const
  {
    const Eigen::Vector3d half = Eigen::Vector3d::Constant(distance);
    return tree_.anyMeeting(ccaa::Box(center - half, center + half), [&](index_t i) {
      return (points_[static_cast<std::size_t>(i)] - center).norm() <= distance;
    });
  }

private:
  const Positions& points_;
  ccaa::BoxTree tree_;
};

bool
comesWithin(const BoundaryCurve& first, const BoundaryCurve& second, double distance)
{
  const NearbyPoints points(second.points);
  return std::any_of(
      first.points.begin(), first.points.end(), [&](const Position& point) {
        return points.anyWithin(point, distance);
      });
}

/** \brief C4.46-1: the smallest island near the hole is no larger than the hole
 * exactly if any of them is. */
bool
countsAsSource(std::size_t hole,
               const BoundaryLoops& loops,
               const std::vector<bool>& is_hole,
               const std::vector<LoopExtent>& extents,
               double reach,
               double least_hole)
{
  for (std::size_t rim = 0; rim < loops.size(); ++rim)
    if (!is_hole[rim] && loops[rim].island != loops[hole].island &&
        least_hole * extents[rim].size <= extents[hole].size &&
        !extents[rim].box.isEmpty() &&
        extents[rim].box.exteriorDistance(extents[hole].box) <= reach &&
        comesWithin(loops[rim].curve, loops[hole].curve, reach))
      return true;
  return false;
}

} // namespace

SourceCurve
sampleSources(const BoundaryCurve& curve, double spacing)
{
  SourceCurve result;
  const CurveWalk walk(curve);
  result.length = walk.length();
  if (!(result.length > 0.0))
    return result;
  const std::size_t count = sourceCount(curve, result.length, spacing);
  result.spacing = result.length / static_cast<double>(count);
  result.sources.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    FieldSource& source = result.sources[k];
    source.arc = static_cast<double>(k) * result.spacing;
    source.position = walk.positionAt(source.arc);
    source.tangent = tangentAt(curve, walk, source.arc, result.spacing);
    source.normal = normalAt(curve, walk, source, result.spacing);
  }
  return result;
}

std::vector<bool>
areIslandSources(const BoundaryLoops& loops,
                 const std::vector<bool>& is_hole,
                 double reach,
                 double least_hole)
{
  const std::vector<LoopExtent> extents = extentsOf(loops);
  std::vector<bool> are_sources;
  for (std::size_t i = 0; i < loops.size(); ++i)
    are_sources.push_back(
        !is_hole[i] || countsAsSource(i, loops, is_hole, extents, reach, least_hole));
  return are_sources;
}

SourceSet
gatherSources(std::vector<SourceCurve> curves)
{
  SourceSet set;
  set.curves = std::move(curves);
  double length = 0.0;
  for (const SourceCurve& curve : set.curves)
    length += curve.length;
  const std::size_t count = set.size();
  if (count == 0)
    return set;
  set.spacing = length / static_cast<double>(count);
  for (SourceCurve& curve : set.curves)
    for (FieldSource& source : curve.sources)
      source.charge = curve.spacing / set.spacing;
  return set;
}

} // namespace pcl::repair
