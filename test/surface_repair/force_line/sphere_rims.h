// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the rims of two caps of a sphere, for tests of force lines.

#pragma once

#include "field/source_sampling.h"
#include "force_line/line_origins.h"

#include <cmath>
#include <utility>
#include <vector>

namespace pcl::repair::test {

constexpr double TWO_PI = 6.28318530717958647692;

/** \brief The rim at height z of the part of the unit sphere that lies above it (or
 * below it), with the surface on its left. */
inline BoundaryCurve
sphereRim(double z, bool is_above, std::size_t count, double phase = 0.0)
{
  BoundaryCurve rim;
  const double radius = std::sqrt(1.0 - z * z);
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = (is_above ? TWO_PI : -TWO_PI) *
                         (static_cast<double>(k) + phase) / static_cast<double>(count);
    rim.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  for (std::size_t k = 0; k < count; ++k) {
    const Direction along = rim.edge(k).normalized();
    const Position middle = rim.points[k] + rim.points[rim.next(k)];
    rim.normals.push_back((middle - middle.dot(along) * along).normalized());
  }
  return rim;
}

/** \brief The same boundary of an island that is wound the other way round. */
inline BoundaryCurve
turned(const BoundaryCurve& curve)
{
  BoundaryCurve other;
  other.points.assign(curve.points.rbegin(), curve.points.rend());
  for (std::size_t k = 0; k < curve.size(); ++k)
    other.normals.push_back(-curve.normals[(2 * curve.size() - 2 - k) % curve.size()]);
  return other;
}

/** \brief Curves of islands 0, 1, ... with the field they make. */
struct Islands {
  explicit Islands(const std::vector<BoundaryCurve>& curves)
  : sources(sample(curves)), field(sources), targets(numbered(curves))
  {}

  static SourceSet
  sample(const std::vector<BoundaryCurve>& curves)
  {
    std::vector<SourceCurve> sampled;
    for (std::size_t k = 0; k < curves.size(); ++k) {
      sampled.push_back(sampleSources(curves[k]));
      sampled.back().island = k;
      sampled.back().loop = k;
    }
    return gatherSources(std::move(sampled));
  }

  static std::vector<TargetCurve>
  numbered(const std::vector<BoundaryCurve>& curves)
  {
    std::vector<TargetCurve> targets;
    for (std::size_t k = 0; k < curves.size(); ++k)
      targets.push_back({curves[k], k});
    return targets;
  }

  /** \brief Origins on one island's boundary. */
  std::vector<LineOrigin>
  originsOn(std::size_t island) const
  {
    std::vector<LineOrigin> chosen;
    for (const PossibleOrigin& origin :
         originsBetweenIslands(field, targets, Reach(), ccaa::LoopContext()))
      if (origin.origin.query.silent_island == island)
        chosen.push_back(origin.origin);
    return chosen;
  }

  SourceSet sources;
  IndicatorField field;
  BoundaryEdges targets;
};

} // namespace pcl::repair::test
