// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the contours of all holes from boundaries and bridges
// (4.47).

#include "hole/hole_contour.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace pcl::repair {

namespace {

/** A supporting point: one end of a bridge. */
struct Support {
  BoundaryPoint point;
  std::size_t curve = NONE; /**< of the point */
  double arc = 0.0;         /**< of the point */
  std::size_t bridge = NONE;
  bool is_end = false;

  bool
  operator<(const Support& other) const
  {
    return std::tie(curve, arc, bridge, is_end) <
           std::tie(other.curve, other.arc, other.bridge, other.is_end);
  }
};

class Extraction {
public:
  Extraction(const BoundaryEdges& boundaries, const std::vector<Bridge>& bridges)
  : boundaries_(boundaries), bridges_(bridges), kept_(bridges.size(), true)
  {}

  ContourExtraction
  run();

private:
  void
  listSupports();
  bool
  dropCoincident();
  void
  linkSupports();
  void
  walkAll();
  HoleContour
  walkFrom(std::size_t support);
  std::vector<std::size_t>
  passedTwice(const HoleContour& contour) const;
  void
  drop(std::size_t bridge);
  void
  addLoneBoundaries();

  const BoundaryEdges& boundaries_;
  const std::vector<Bridge>& bridges_;
  std::vector<bool> kept_;                       /**< of the bridges */
  std::vector<Support> supports_;                /**< by curve and arc */
  std::vector<std::array<std::size_t, 2>> ends_; /**< of a bridge: its supports */
  std::vector<std::size_t> next_, before_; /**< of a support: along its boundary */
  std::vector<bool> used_; /**< of a support: the section that ends there is used */
  std::vector<HoleContour> contours_;
};

void
Extraction::listSupports()
{
  supports_.clear();
  for (std::size_t b = 0; b < bridges_.size(); ++b) {
    if (!kept_[b])
      continue;
    for (const bool is_end : {false, true}) {
      const BoundaryPoint& point = is_end ? bridges_[b].end : bridges_[b].begin;
      supports_.push_back({point, point.curve, boundaries_.arcAt(point), b, is_end});
    }
  }
  std::sort(supports_.begin(), supports_.end());
  ends_.assign(bridges_.size(), {NONE, NONE});
  for (std::size_t i = 0; i < supports_.size(); ++i)
    ends_[supports_[i].bridge][supports_[i].is_end ? 1 : 0] = i;
}

/** C4.47-2: of two bridges at one point the later one goes. */
bool
Extraction::dropCoincident()
{
  bool dropped = false;
  for (std::size_t i = 1; i < supports_.size(); ++i) {
    const Support& before = supports_[i - 1];
    const Support& support = supports_[i];
    if (before.curve != support.curve || before.arc < support.arc)
      continue;
    kept_[std::max(before.bridge, support.bridge)] = false;
    dropped = true;
  }
  return dropped;
}

/** Supports of a boundary follow each other in positive direction, all around. */
void
Extraction::linkSupports()
{
  next_.resize(supports_.size());
  before_.resize(supports_.size());
  for (std::size_t first = 0, end = 0; first < supports_.size(); first = end) {
    while (end < supports_.size() && supports_[end].curve == supports_[first].curve)
      ++end;
    for (std::size_t i = first; i < end; ++i) {
      next_[i] = i + 1 < end ? i + 1 : first;
      before_[next_[i]] = i;
    }
  }
}

HoleContour
Extraction::walkFrom(std::size_t support)
{
  HoleContour contour;
  std::size_t here = support;
  do {
    const Support& from = supports_[here];
    const std::size_t across = ends_[from.bridge][from.is_end ? 0 : 1];
    const std::size_t next = next_[across];
    contour.steps.push_back(
        {from.bridge, from.is_end, {supports_[across].point, supports_[next].point}});
    used_[next] = true;
    here = next;
  }
  while (here != support);
  return contour;
}

/** C4.47-3: bridges that a contour passes on both sides. */
std::vector<std::size_t>
Extraction::passedTwice(const HoleContour& contour) const
{
  std::vector<std::size_t> passed;
  for (const ContourStep& step : contour.steps)
    passed.push_back(step.bridge);
  std::sort(passed.begin(), passed.end());
  std::vector<std::size_t> twice;
  for (std::size_t i = 1; i < passed.size(); ++i)
    if (passed[i] == passed[i - 1])
      twice.push_back(passed[i]);
  return twice;
}

/** Its supports go from their boundaries. */
void
Extraction::drop(std::size_t bridge)
{
  kept_[bridge] = false;
  for (const std::size_t support : ends_[bridge]) {
    next_[before_[support]] = next_[support];
    before_[next_[support]] = before_[support];
    used_[support] = true; // nothing begins there
  }
}

/** Without a bridge that a contour passes twice, the other contours are as they were:
 * only that one is walked again. */
void
Extraction::walkAll()
{
  used_.assign(supports_.size(), false);
  for (std::size_t i = 0; i < supports_.size(); ++i)
    while (!used_[i]) {
      HoleContour contour = walkFrom(i);
      const std::vector<std::size_t> twice = passedTwice(contour);
      if (twice.empty()) {
        contours_.push_back(std::move(contour));
        break;
      }
      for (const ContourStep& step : contour.steps)
        used_[ends_[step.bridge][step.backward ? 1 : 0]] = false;
      for (const std::size_t bridge : twice)
        drop(bridge);
    }
}

void
Extraction::addLoneBoundaries()
{
  std::vector<bool> has_bridge(boundaries_.curves().size(), false);
  for (const Support& support : supports_)
    if (kept_[support.bridge])
      has_bridge[support.curve] = true;
  for (std::size_t curve = 0; curve < has_bridge.size(); ++curve)
    if (!has_bridge[curve]) {
      const BoundaryPoint first = boundaries_.pointAt(curve, 0.0);
      contours_.push_back({{{NONE, false, {first, first}}}});
    }
}

ContourExtraction
Extraction::run()
{
  do
    listSupports();
  while (dropCoincident());
  linkSupports();
  walkAll();
  addLoneBoundaries();
  ContourExtraction result;
  result.contours = std::move(contours_);
  for (std::size_t b = 0; b < kept_.size(); ++b)
    if (!kept_[b])
      result.removed_bridges.push_back(b);
  return result;
}

/** Collects a closed curve point by point. */
class CurveBuilder {
public:
  void
  add(const Position& point, const Direction& normal_after)
  {
    if (!curve_.points.empty() && curve_.points.back() == point) {
      curve_.normals.back() = normal_after;
      return;
    }
    curve_.points.push_back(point);
    curve_.normals.push_back(normal_after);
  }

  BoundaryCurve
  finish()
  {
    if (curve_.points.size() > 1 && curve_.points.front() == curve_.points.back()) {
      curve_.points.pop_back();
      curve_.normals.pop_back();
    }
    return std::move(curve_);
  }

private:
  BoundaryCurve curve_;
};

void
addBridge(const Bridge& bridge, bool backward, CurveBuilder& builder)
{
  const std::size_t count = bridge.points.size();
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const std::size_t here = backward ? count - 1 - i : i;
    const std::size_t next = backward ? here - 1 : here + 1;
    builder.add(bridge.points[here],
                (bridge.normals[here] + bridge.normals[next]).normalized());
  }
}

void
addSection(const BoundarySection& section,
           const BoundaryEdges& boundaries,
           CurveBuilder& builder)
{
  const BoundaryPoint& from = section.from;
  const BoundaryPoint& to = section.to;
  const BoundaryCurve& curve = boundaries.curves()[from.curve].curve;
  std::size_t vertices = (to.edge + curve.size() - from.edge) % curve.size();
  if (vertices == 0 && to.share <= from.share)
    vertices = curve.size();
  builder.add(from.position, curve.normals[from.edge]);
  for (std::size_t i = 1; i <= vertices; ++i) {
    const std::size_t vertex = (from.edge + i) % curve.size();
    builder.add(curve.points[vertex], curve.normals[vertex]);
  }
  builder.add(to.position, curve.normals[to.edge]);
}

} // namespace

ContourExtraction
extractContours(const BoundaryEdges& boundaries, const std::vector<Bridge>& bridges)
{
  return Extraction(boundaries, bridges).run();
}

BoundaryCurve
curveOf(const HoleContour& contour,
        const BoundaryEdges& boundaries,
        const std::vector<Bridge>& bridges)
{
  CurveBuilder builder;
  for (const ContourStep& step : contour.steps) {
    if (step.bridge != NONE)
      addBridge(bridges[step.bridge], step.backward, builder);
    addSection(step.section, boundaries, builder);
  }
  return builder.finish();
}

} // namespace pcl::repair
