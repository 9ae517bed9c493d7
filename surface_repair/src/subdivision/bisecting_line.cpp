// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a force line made to fit between two vertices of a hole.

#include "subdivision/bisecting_line.h"

#include "field/shielding.h"
#include "force_line/force_line_tracker.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::repair {

namespace {

/** Edges of the contour on each side of a vertex that say how closely it is sampled. */
constexpr std::size_t SPACING_WINDOW = 4;
/** Share of its edges by which the larger part of a hole is smaller than the hole. */
constexpr double LEAST_REDUCTION = 0.05;
/** A bridge may have edges so many times as long as those of the contour. */
constexpr double LONGEST_EDGES = 1.5;
/** In spacings: what bridges and the contour keep apart. */
constexpr double CLEARANCE = 0.5;
/** Distance from the contour by distance from the end, where that asks for less. */
constexpr double LEAST_SLOPE = 0.3;
/** In spacings: steps in which a line is followed to the contour, and how near to it
 * the line ends. */
constexpr double CUT_STEP = 0.5;
constexpr double CUT_DISTANCE = 0.75;

ForceLine
stretchOf(const ForceLine& line, std::size_t first, std::size_t last)
{
  const auto begin = static_cast<std::ptrdiff_t>(first);
  const auto end = static_cast<std::ptrdiff_t>(last + 1);
  ForceLine stretch = line;
  stretch.points.assign(line.points.begin() + begin, line.points.begin() + end);
  stretch.normals.assign(line.normals.begin() + begin, line.normals.begin() + end);
  stretch.tensions.assign(line.tensions.begin() + begin, line.tensions.begin() + end);
  stretch.length = 0.0;
  for (std::size_t k = 1; k < stretch.points.size(); ++k)
    stretch.length += (stretch.points[k] - stretch.points[k - 1]).norm();
  return stretch;
}

} // namespace

LineFitter::LineFitter(const HolePolygon& hole,
                       const BoundaryEdges& contour,
                       const PerturbationParameters& perturbation,
                       const SubdivisionGuides& guides)
: hole_(hole)
, contour_(contour)
, perturbation_(perturbation)
, guides_(guides)
, mean_spacing_(contour.lengthOf(0) / static_cast<double>(hole.size()))
{}

std::optional<BisectingLine>
LineFitter::fit(const ForceLine& line) const
{
  if (line.end != LineEnd::BRIDGE || !(line.length > 0.0))
    return std::nullopt;
  BisectingLine fitted;
  ForceLine way = cutToContour(line, fitted);
  const auto edges = edgesFor(way, fitted.from, fitted.to);
  if (!edges)
    return std::nullopt;
  way = resampled(way, way.length / static_cast<double>(*edges));
  if (guides_.free_points != nullptr)
    way = perturbed(way, *guides_.free_points, perturbation_);
  shiftEnds(way, fitted.from, fitted.to);
  fitted.points = std::move(way.points);
  fitted.normals = std::move(way.normals);
  fitted.quality = line.quality;
  if (fitted.edges() != *edges || !keepsClear(fitted))
    return std::nullopt;
  fitted.merit = meritOf(fitted);
  return fitted;
}

/** The stretch of the line, around its middle, that is clear of the contour, and the
 * vertices where it comes near: the line itself may end deep in a notch. */
ForceLine
LineFitter::cutToContour(const ForceLine& line, BisectingLine& ends) const
{
  ends.from = nearestVertex(line.origin);
  ends.to = nearestVertex(line.target);
  ForceLine even = resampled(line, CUT_STEP * mean_spacing_);
  const std::size_t middle = even.points.size() / 2;
  const auto vertexNear = [&](std::size_t k) -> std::optional<std::size_t> {
    const Position& place = even.points[k];
    const auto met = contour_.closest(place, place, CUT_DISTANCE * mean_spacing_);
    if (!met)
      return std::nullopt;
    return nearestVertex(met->point);
  };
  if (even.points.size() < 4 || vertexNear(middle))
    return line;
  std::size_t first = middle, last = middle;
  for (std::optional<std::size_t> met; first > 0 && !met;)
    if ((met = vertexNear(--first)))
      ends.from = *met;
  for (std::optional<std::size_t> met; last + 1 < even.points.size() && !met;)
    if ((met = vertexNear(++last)))
      ends.to = *met;
  return stretchOf(even, first, last);
}

std::size_t
LineFitter::nearestVertex(const BoundaryPoint& point) const
{
  return point.share <= 0.5 ? point.edge : hole_.curve.next(point.edge);
}

double
LineFitter::spacingAround(std::size_t vertex) const
{
  const std::size_t n = hole_.size();
  const std::size_t window = std::min(SPACING_WINDOW, n / 2);
  double length = 0.0;
  for (std::size_t step = 0; step < 2 * window; ++step)
    length += hole_.curve.edge((vertex + n + step - window) % n).norm();
  return length / static_cast<double>(2 * window);
}

/** As many edges as the spacing at both ends suggests; fewer where both parts are to be
 * smaller than the hole; none where that would make them too long. */
std::optional<std::size_t>
LineFitter::edgesFor(const ForceLine& line, std::size_t from, std::size_t to) const
{
  const std::size_t n = hole_.size();
  const std::size_t ahead = (to + n - from) % n;
  const std::size_t shorter = std::min(ahead, n - ahead);
  if (shorter < 2) // the same vertex, or neighbours
    return std::nullopt;
  const double wanted = 2.0 * line.length / (spacingAround(from) + spacingAround(to));
  const auto reduction =
      static_cast<std::size_t>(std::ceil(LEAST_REDUCTION * static_cast<double>(n)));
  if (shorter <= reduction)
    return std::nullopt;
  const auto most = static_cast<double>(shorter - reduction);
  if (!(wanted <= LONGEST_EDGES * most))
    return std::nullopt;
  const double edges = wanted < 1.5 ? 1.0 : std::round(std::min(wanted, most));
  return static_cast<std::size_t>(edges);
}

/** Let the line end at vertices, to the bit: the shift is linear along the line, so
 * that its shape stays (as C4.6-1 has it for free points). */
void
LineFitter::shiftEnds(ForceLine& line, std::size_t from, std::size_t to) const
{
  const Position first = hole_.curve.points[from];
  const Position last = hole_.curve.points[to];
  const Eigen::Vector3d at_begin = first - line.points.front();
  const Eigen::Vector3d at_end = last - line.points.back();
  const auto pieces = static_cast<double>(line.points.size() - 1);
  for (std::size_t k = 1; k + 1 < line.points.size(); ++k) {
    const double share = static_cast<double>(k) / pieces;
    line.points[k] += (1.0 - share) * at_begin + share * at_end;
  }
  line.points.front() = first;
  line.points.back() = last;
  bringNormalsAcross(line);
}

bool
LineFitter::keepsClear(const BisectingLine& line) const
{
  for (std::size_t k = 0; k < line.edges(); ++k) {
    const Position& a = line.points[k];
    const Position& b = line.points[k + 1];
    if (!a.allFinite() || !b.allFinite() || !((b - a).norm() > 0.0) ||
        comesNear(line, a, b))
      return false;
    // At its ends a bridge touches the surface that it belongs to.
    const bool at_end = k == 0 || k + 1 == line.edges();
    const double tolerance = at_end ? CLEARANCE * mean_spacing_ : 0.0;
    if (guides_.surface != nullptr && guides_.surface->crosses(a, b, tolerance))
      return false;
  }
  return true;
}

/** Whether a piece of the line is nearer to the contour than the clearance; towards its
 * ends it may be, as long as the angle between the two is not too sharp. */
bool
LineFitter::comesNear(const BisectingLine& line,
                      const Position& a,
                      const Position& b) const
{
  const auto not_at_ends = [&](std::size_t, std::size_t edge) {
    const std::size_t next = hole_.curve.next(edge);
    return edge != line.from && next != line.from && edge != line.to && next != line.to;
  };
  const auto met = contour_.closest(a, b, CLEARANCE * mean_spacing_, {}, not_at_ends);
  if (!met)
    return false;
  const Position place = a + met->along * (b - a);
  const double from_end = std::min((place - line.points.front()).norm(),
                                   (place - line.points.back()).norm());
  return met->distance < LEAST_SLOPE * from_end;
}

/** High where the field is strong for the length of the line (it grows with L_2, which
 * grows with the gap), and where the line is short for what it cuts off. */
double
LineFitter::meritOf(const BisectingLine& line) const
{
  double length = 0.0;
  for (std::size_t k = 0; k < line.edges(); ++k)
    length += (line.points[k + 1] - line.points[k]).norm();
  const double apart =
      contour_.arcBetween(0,
                          contour_.arcAt({0, line.from, 0.0, Position::Zero()}),
                          contour_.arcAt({0, line.to, 0.0, Position::Zero()}));
  return line.quality * apart / (length * length);
}

} // namespace pcl::repair
