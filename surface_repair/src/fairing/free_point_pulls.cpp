// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which free points draw a patch, where and how strongly.

#include "fairing/free_point_pulls.h"

#include <Eigen/Geometry>

#include "fairing/triangle_search.h"
#include "mesh/box_tree.h"
#include "mesh/corners.h"
#include "mesh/quantile.h"
#include "mesh/sort_unique.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace pcl::repair {

namespace {

/** Weight of a free point of trust one half that is exact, in 1 / edge length squared.
 */
constexpr double FULL_WEIGHT = 100.0;
/** Noise that halves the weight, in edge lengths. */
constexpr double HALVING_NOISE = 0.05;
/** Neighbours that a point is compared with, at least. */
constexpr std::size_t FEWEST_NEIGHBOURS = 4;
/** A point stands out from here on, in scales of its neighbours. */
constexpr double OUTSTANDING = 5.0;
/** The least such scale, in edge lengths. */
constexpr double LEAST_SCALE = 0.1;

std::vector<ccaa::Corners>
patchCorners(const JoinedSurface& surface)
{
  std::vector<ccaa::Corners> corners;
  corners.reserve(surface.patch_triangles);
  for (std::size_t t = 0; t < surface.patch_triangles; ++t)
    corners.push_back(ccaa::cornersOf(surface.triangles[t], surface.positions));
  return corners;
}

double
meanEdge(const std::vector<ccaa::Corners>& triangles)
{
  double sum = 0.0;
  for (const ccaa::Corners& corners : triangles)
    for (std::size_t c = 0; c < 3; ++c)
      sum += (corners[(c + 1) % 3] - corners[c]).norm();
  return triangles.empty() ? 0.0 : sum / (3.0 * static_cast<double>(triangles.size()));
}

/** What a point differs by, in edge lengths. */
struct Comparison {
  double difference = 0.0; /**< of its offset */
  double scale = 0.0;      /**< usual difference around */
  bool alone = false;      /**< without neighbours to compare with */
};

/** Compares the offsets of points close together. */
class Neighbourhoods {
public:
  explicit Neighbourhoods(const std::vector<AttachedPoint>& attached)
  : attached_(attached)
  {
    std::vector<ccaa::Box> boxes;
    for (const AttachedPoint& one : attached) {
      boxes.emplace_back(one.pull.target);
      all_.extend(one.pull.target);
    }
    tree_ = ccaa::BoxTree(boxes);
    spacing_ = all_.diagonal().norm() / std::sqrt(static_cast<double>(boxes.size()));
  }

  /** How a point compares with its neighbours, or with the patch if it has none. */
  Comparison
  compare(std::size_t index)
  {
    gather(index);
    const AttachedPoint& own = attached_[index];
    if (offsets_.size() < FEWEST_NEIGHBOURS)
      return {std::abs(own.offset) / own.edge, LEAST_SCALE, true};
    const double middle = ccaa::medianOf(offsets_);
    for (double& offset : offsets_)
      offset = std::abs(offset - middle);
    const double scale = ccaa::deviationOf(offsets_) / own.edge;
    return {
        std::abs(own.offset - middle) / own.edge, std::max(scale, LEAST_SCALE), false};
  }

private:
  void
  gather(std::size_t index)
  {
    const Position& centre = attached_[index].pull.target;
    const double widest = all_.diagonal().norm();
    double radius = std::max(spacing_, attached_[index].edge);
    do {
      offsets_.clear();
      const Position reach = Position::Constant(radius);
      const ccaa::Box around(centre - reach, centre + reach);
      tree_.forEachMeeting(around, [&](pcl::index_t other) {
        if (static_cast<std::size_t>(other) != index)
          offsets_.push_back(attached_[static_cast<std::size_t>(other)].offset);
      });
      radius *= 1.5;
    }
    while (offsets_.size() < FEWEST_NEIGHBOURS && radius < 0.5 * widest);
  }

  const std::vector<AttachedPoint>& attached_;
  ccaa::Box all_;
  ccaa::BoxTree tree_;
  double spacing_ = 0.0;
  std::vector<double> offsets_;
};

/** The usual difference of points from their neighbours, in edge lengths: noise, as far
 * as the patch is what they are samples of. */
double
noiseOf(const std::vector<Comparison>& comparisons)
{
  std::vector<double> differences;
  for (const Comparison& one : comparisons)
    if (!one.alone)
      differences.push_back(one.difference);
  return ccaa::deviationOf(std::move(differences));
}

} // namespace

std::vector<Pull>
FreePointPulls::weighted(const std::vector<AttachedPoint>& attached) const
{
  Neighbourhoods neighbourhoods(attached);
  std::vector<Comparison> comparisons;
  for (std::size_t i = 0; i < attached.size(); ++i)
    comparisons.push_back(neighbourhoods.compare(i));
  const double seen = noiseOf(comparisons);
  std::vector<Pull> pulls;
  for (std::size_t i = 0; i < attached.size(); ++i) {
    const Comparison& one = comparisons[i];
    const double t = one.difference / (OUTSTANDING * one.scale);
    const double robust = 1.0 / ((1.0 + t * t) * (1.0 + t * t));
    const double noise =
        std::max(one.alone ? one.difference : seen, noise_ / attached[i].edge);
    const double n = noise / HALVING_NOISE;
    Pull pull = attached[i].pull;
    pull.weight = trust_ * FULL_WEIGHT * robust / (1.0 + n * n) /
                  (attached[i].edge * attached[i].edge);
    pulls.push_back(pull);
  }
  return pulls;
}

FreePointPulls::FreePointPulls(const IncompleteModel& model,
                               const Positions& free_points,
                               const RelaxationParameters& parameters,
                               const Patch& patch,
                               const JoinedSurface& surface,
                               double noise)
: trust_(parameters.trust / (1.0 - parameters.trust))
, reach_(parameters.reach)
, noise_(noise / surface.size)
{
  if (!(parameters.trust > 0.0) || free_points.empty())
    return;
  ccaa::Box around;
  for (std::size_t v = 0; v < surface.patch_vertices; ++v)
    around.extend(surface.positions[v]);
  // The patch may grow into the box by its own size, which is 1.
  const Position margin = Position::Constant(0.5);
  around = ccaa::Box(around.min() - margin, around.max() + margin);
  const std::unordered_set<std::size_t> vertices(patch.free_point.begin(),
                                                 patch.free_point.end());
  for (std::size_t i = 0; i < free_points.size(); ++i) {
    const Position place = (free_points[i] - surface.centre) / surface.size;
    if (around.contains(place) && vertices.count(i) == 0)
      points_.push_back(place);
  }
  if (!points_.empty())
    gatherModel(model, patch.rim, surface, around);
}

/** Outward from the rim: looking at all triangles for every patch would be too much. */
void
FreePointPulls::gatherModel(const IncompleteModel& model,
                            const std::vector<pcl::index_t>& rim,
                            const JoinedSurface& surface,
                            const ccaa::Box& around)
{
  const ccaa::Box in_cloud(surface.centre + surface.size * around.min(),
                           surface.centre + surface.size * around.max());
  std::vector<pcl::index_t> reached;
  for (const pcl::index_t vertex : rim)
    reached.insert(
        reached.end(), model.adjacency.begin(vertex), model.adjacency.end(vertex));
  ccaa::sortUnique(reached);
  std::unordered_set<pcl::index_t> known(reached.begin(), reached.end());
  for (std::size_t i = 0; i < reached.size(); ++i) {
    ccaa::Corners corners = ccaa::cornersOf(
        model.triangles[static_cast<std::size_t>(reached[i])], model.positions);
    if (!in_cloud.intersects(ccaa::boxOf(corners)))
      continue;
    for (Position& corner : corners)
      corner = (corner - surface.centre) / surface.size;
    model_triangles_.push_back(corners);
    for (int corner = 0; corner < 3; ++corner) {
      const pcl::index_t next = model.adjacency.across(reached[i], corner);
      if (next >= 0 && known.insert(next).second)
        reached.push_back(next);
    }
  }
}

std::vector<Pull>
FreePointPulls::attach(const JoinedSurface& surface) const
{
  if (points_.empty())
    return {};
  const std::vector<ccaa::Corners> corners = patchCorners(surface);
  const double reach = reach_ * meanEdge(corners);
  const TriangleSearch patch(corners), model(model_triangles_);
  std::vector<AttachedPoint> attached;
  for (const Position& point : points_) {
    const TrianglePlace place = patch.nearest(point, reach);
    if (!place.found() || model.nearest(point, place.distance).found())
      continue;
    const ccaa::Corners& there = corners[place.triangle];
    const Position foot = place.barycentric[0] * there[0] +
                          place.barycentric[1] * there[1] +
                          place.barycentric[2] * there[2];
    AttachedPoint one;
    one.pull = {place.triangle, place.barycentric, point, 0.0};
    one.offset =
        std::copysign(place.distance, (point - foot).dot(ccaa::areaNormal(there)));
    one.edge = meanEdge({there});
    attached.push_back(one);
  }
  return weighted(attached);
}

} // namespace pcl::repair
