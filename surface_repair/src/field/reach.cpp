// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how far field and trust reach, derived from the data
// (4.45).
#include "field/reach.h"

#include "field/labelled_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pcl::repair {
namespace {

/** \brief L_2 is no less than this many spacings, or single sources would show. */
constexpr double LEAST_REACH = 4.0;

/** \brief R_2 by the distance between islands (4.45). */
constexpr double SHARE_OF_GAP = 0.5;

} // namespace

struct GapFinder::Implementation {
  LabelledTree tree;
};

GapFinder::GapFinder(const SourceSet& sources)
: implementation_(std::make_unique<Implementation>())
{
  Positions positions;
  std::vector<std::size_t> islands;
  for (const SourceCurve& curve : sources.curves)
    for (const FieldSource& source : curve.sources) {
      positions.push_back(source.position);
      islands.push_back(curve.island);
    }
  implementation_->tree = LabelledTree(std::move(positions), std::move(islands));
}

GapFinder::~GapFinder() = default;

GapFinder::GapFinder(GapFinder&&) noexcept = default;

double
GapFinder::gapAt(const Position& position, std::size_t silent_island) const
{
  return implementation_->tree.distanceToOther(position, silent_island);
}

Falloff
sourceFalloff(double spacing, double gap, double exponent, double room)
{
  Falloff falloff;
  falloff.near = spacing;
  falloff.far = std::isfinite(gap) ? std::max(room * gap, LEAST_REACH * spacing) : 0.0;
  falloff.exponent = exponent;
  return falloff;
}

Falloff
freePointFalloff(double spacing, double gap, double exponent)
{
  Falloff falloff;
  falloff.near = spacing;
  falloff.far = std::isfinite(gap) ? std::max(SHARE_OF_GAP * gap, spacing) : spacing;
  falloff.exponent = exponent;
  return falloff;
}

double
meanSpacing(const Positions& points)
{
  if (points.size() < 2)
    return 0.0;
  std::vector<std::size_t> own(points.size());
  std::iota(own.begin(), own.end(), std::size_t(0));
  const LabelledTree tree(points, own);
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
    sum += tree.distanceToOther(points[i], i);
  return sum / static_cast<double>(points.size());
}

std::vector<double>
gapsAlong(const SourceCurve& curve, const GapFinder& gaps)
{
  std::vector<double> all;
  for (const FieldSource& source : curve.sources)
    all.push_back(gaps.gapAt(source.position, curve.island));
  return all;
}

} // namespace pcl::repair
