// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what may be known about the outer side of a surface, and
// what told it in the end.
#include "mesh/side_hints.h"

#include <Eigen/Geometry>

#include "mesh/turn_between.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace pcl::ccaa {
namespace {

// What a sensor can have measured: each of these turns down bodies that were measured
// all around, models around the origin, or ground that is seen edge-on.

/** Cosine of half the opening of a sensor's view, 45 degrees. */
constexpr double COS_HALF_VIEW = 0.7071067811865476;
/** Of the points from a sensor, in diagonals of the cloud. */
constexpr double LEAST_DISTANCE = 0.05;
constexpr double LARGEST_DISTANCE = 30.0;
/** Share of the points that may lie behind others. */
constexpr double LARGEST_HIDDEN_SHARE = 0.25;
/** Points to a cell of directions, in which the nearest hides the others. */
constexpr double POINTS_PER_CELL = 4.0;
/** A point is hidden by one that is nearer by this share of the cloud's depth. */
constexpr double HIDING_DEPTH = 0.1;

/** Calls use(point) for the chosen points that are finite. */
template <typename Use>
void
forFinite(const PointView& points, const Indices* chosen, Use use)
{
  const std::size_t count = chosen != nullptr ? chosen->size() : points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Position point = chosen != nullptr ? points[(*chosen)[i]] : points[i];
    if (point.allFinite())
      use(point);
  }
}

/** The chosen points as the origin sees them: two places on a plane across the mean
 * direction at distance 1, and the depth. Empty where some lie to the side. */
Positions
seenFromOrigin(const PointView& points, const Indices* chosen)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::AlignedBox3d box;
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0.0;
  forFinite(points, chosen, [&](const Position& point) {
    const double distance = point.norm();
    sum += distance > 0.0 ? Eigen::Vector3d(point / distance) : point;
    box.extend(point);
    nearest = std::min(nearest, distance);
    farthest = std::max(farthest, distance);
  });
  if (box.isEmpty() || sum.isZero(0.0) ||
      nearest < LEAST_DISTANCE * box.diagonal().norm() ||
      farthest > LARGEST_DISTANCE * box.diagonal().norm())
    return {};
  const Eigen::Quaterniond turn = turnBetween(sum, Position::UnitZ());
  bool aside = false;
  Positions seen;
  forFinite(points, chosen, [&](const Position& point) {
    const Position at = turn * point;
    aside = aside || at.z() < COS_HALF_VIEW * at.norm();
    seen.emplace_back(at.x() / at.z(), at.y() / at.z(), at.z());
  });
  return aside ? Positions() : seen;
}

/** Share of the places that lie behind others, seen in cells of a few points. */
double
hiddenShare(const Positions& seen)
{
  Eigen::AlignedBox3d box;
  for (const Position& at : seen)
    box.extend(at);
  const Position size = box.sizes();
  const double cells = static_cast<double>(seen.size()) / POINTS_PER_CELL;
  const double step = std::sqrt(std::max(size.x() * size.y(), 1e-300) / cells);
  const auto cellAlong = [&](double length) {
    return static_cast<std::size_t>(std::clamp(length / step, 0.0, cells));
  };
  const std::size_t columns = cellAlong(size.x()) + 1;
  const std::size_t rows = cellAlong(size.y()) + 1;
  const auto cellOf = [&](const Position& at) {
    return std::min(cellAlong(at.y() - box.min().y()), rows - 1) * columns +
           std::min(cellAlong(at.x() - box.min().x()), columns - 1);
  };
  std::vector<double> nearest(columns * rows, std::numeric_limits<double>::infinity());
  for (const Position& at : seen)
    nearest[cellOf(at)] = std::min(nearest[cellOf(at)], at.z());
  const auto hidden = std::count_if(seen.begin(), seen.end(), [&](const Position& at) {
    return at.z() > nearest[cellOf(at)] + HIDING_DEPTH * size.z();
  });
  return static_cast<double>(hidden) / static_cast<double>(seen.size());
}

std::string
percent(std::size_t part, std::size_t whole)
{
  return std::to_string((200 * part + whole) / (2 * whole)) + " %";
}

} // namespace

const char*
describe(OutwardRule rule)
{
  switch (rule) {
  case OutwardRule::TOLD_VIEWPOINT:
    return "the viewpoint told";
  case OutwardRule::UP:
    return "the up direction told";
  case OutwardRule::NORMALS:
    return "given normals";
  case OutwardRule::VIEWPOINT:
    return "sensor position";
  case OutwardRule::ORIGIN:
    return "the origin taken as sensor position";
  case OutwardRule::VOLUME:
    return "enclosed volume";
  case OutwardRule::PLANE:
    return "guessed: up from the dominant plane";
  case OutwardRule::ENCLOSING_SPHERE:
    return "free sight";
  case OutwardRule::BULGE:
    return "bulge";
  case OutwardRule::UNDECIDED:
    return "undecided";
  case OutwardRule::ONE_SIDED:
    return "one-sided";
  }
  return "unknown";
}

std::string
describe(const SideTally& tally)
{
  const std::size_t all =
      std::accumulate(tally.triangles.begin(), tally.triangles.end(), std::size_t{0});
  std::vector<std::size_t> rules;
  for (std::size_t i = 0; i < OUTWARD_RULES; ++i)
    if (tally.triangles[i] > 0)
      rules.push_back(i);
  std::stable_sort(rules.begin(), rules.end(), [&](std::size_t a, std::size_t b) {
    return tally.triangles[a] > tally.triangles[b];
  });
  std::string text;
  for (const std::size_t i : rules) {
    const auto rule = static_cast<OutwardRule>(i);
    text += text.empty() ? "" : ", ";
    if (rule == OutwardRule::PLANE && tally.guessed_axis >= 0)
      text += std::string("guessed: up (+") + "xyz"[tally.guessed_axis] +
              ") from the dominant plane";
    else
      text += describe(rule);
    if (rules.size() > 1)
      text += " (" + percent(tally.triangles[i], all) + ")";
  }
  return text;
}

bool
liesBeforeOrigin(const PointView& points, const Indices* chosen)
{
  const Positions seen = seenFromOrigin(points, chosen);
  return !seen.empty() && hiddenShare(seen) <= LARGEST_HIDDEN_SHARE;
}

SideHints
relativeTo(const Position& offset, SideHints hints)
{
  if (hints.told_viewpoint)
    *hints.told_viewpoint -= offset;
  if (hints.viewpoint)
    *hints.viewpoint -= offset;
  hints.try_origin = hints.try_origin && offset.isZero(0.0);
  return hints;
}

void
takeOrigin(SideHints& hints, const PointView& points, const Indices* chosen)
{
  const bool is_told = hints.told_viewpoint || hints.up || hints.viewpoint;
  if (!hints.try_origin || is_told || !liesBeforeOrigin(points, chosen))
    return;
  hints.viewpoint = Position::Zero();
  hints.viewpoint_is_origin = true;
}

} // namespace pcl::ccaa
