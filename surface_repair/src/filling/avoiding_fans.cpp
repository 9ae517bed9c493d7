// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: fans around inner points that go around what is in the way.

#include "filling/avoiding_fans.h"

#include "mesh/intersection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace pcl::repair {

namespace {

/** Where inner points are looked for, in mean distances of the boundary from its
 * centre: along the normal, */
constexpr std::array<double, 11> HEIGHTS = {
    0.0, 0.1, -0.1, 0.25, -0.25, 0.5, -0.5, 0.9, -0.9, 1.4, -1.4};
/** and across it, */
constexpr std::array<double, 4> SHIFTS = {0.0, 0.25, 0.5, 0.75};
/** into so many directions. */
constexpr int DIRECTIONS = 8;
/** Fans one within the other. */
constexpr int DEPTH = 4;
/** Triangles of one hole that are asked for: at most, and for each of its edges. The
 * 581 holes that fans close in ten scans need up to 6222, and 236 for each; failures
 * use all. */
constexpr std::size_t MOST_QUESTIONS = 7500, QUESTIONS_AN_EDGE = 250;

using Loop = std::vector<pcl::index_t>;

/** A point, and the edges of a loop that it cannot reach. */
struct Fan {
  Position centre = Position::Zero();
  std::vector<bool> is_blind;
  std::size_t blind = 0;
};

class Fans {
public:
  explicit Fans(const FillingTask& task)
  : task_(task)
  , points_(task.polygon.points)
  , most_questions_(std::min(MOST_QUESTIONS, QUESTIONS_AN_EDGE * task.polygon.size()))
  {}

  /** \brief Close a loop. \return whether it could be */
  bool
  close(const Loop& loop, int depth);

  Filling
  filling() const
  {
    Filling filling;
    filling.inner.assign(points_.begin() +
                             static_cast<std::ptrdiff_t>(task_.polygon.size()),
                         points_.end());
    filling.free_point.assign(filling.inner.size(), NONE);
    filling.triangles = triangles_;
    return filling;
  }

private:
  const Position&
  at(pcl::index_t point) const
  {
    return points_[static_cast<std::size_t>(point)];
  }

  Position
  centreOf(const Loop& loop) const;
  Positions
  placesFor(const Loop& loop) const;
  bool
  isFree(const ccaa::Corners& corners);
  std::optional<Fan>
  bestFan(const Loop& loop);
  bool
  look(const Loop& loop,
       std::size_t most_blind,
       std::vector<std::size_t>& order,
       Fan& fan);
  bool
  add(const Loop& loop, const Fan& fan);
  bool
  closeRest(const Loop& loop, const Fan& fan, int depth);

  const FillingTask& task_;
  Positions points_;
  Triangles triangles_;
  std::size_t questions_ = 0, most_questions_;
};

/** Of mass of the loop as a wire. */
Position
Fans::centreOf(const Loop& loop) const
{
  double length = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  const Position& origin = at(loop.front());
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Position &p = at(loop[k]), &q = at(loop[(k + 1) % loop.size()]);
    length += (q - p).norm();
    moment += (q - p).norm() * (0.5 * (p + q) - origin);
  }
  return length > 0.0 ? Position(origin + moment / length) : origin;
}

/** Around the centre, those first that make the least area. */
Positions
Fans::placesFor(const Loop& loop) const
{
  const Position centre = centreOf(loop);
  double radius = 0.0;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Eigen::Vector3d p = at(loop[k]) - centre;
    radius += p.norm() / static_cast<double>(loop.size());
    normal += p.cross(at(loop[(k + 1) % loop.size()]) - centre);
  }
  normal = normal.norm() > 0.0 ? normal.normalized().eval() : Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  std::vector<std::pair<double, Position>> places;
  for (const double height : HEIGHTS)
    for (const double shift : SHIFTS)
      for (int d = 0; d < (shift > 0.0 ? DIRECTIONS : 1); ++d) {
        const double angle = 2.0 * M_PI * d / DIRECTIONS;
        const Position place =
            centre + radius * (height * normal +
                               shift * (std::cos(angle) * u + std::sin(angle) * v));
        double area = 0.0;
        for (std::size_t k = 0; k < loop.size(); ++k)
          area += (at(loop[k]) - place)
                      .cross(at(loop[(k + 1) % loop.size()]) - place)
                      .norm();
        places.emplace_back(area, place);
      }
  std::stable_sort(places.begin(), places.end(), [](const auto& a, const auto& b) {
    return a.first < b.first;
  });
  Positions sorted;
  for (const auto& [area, place] : places)
    sorted.push_back(place);
  return sorted;
}

bool
Fans::isFree(const ccaa::Corners& corners)
{
  ++questions_;
  return !ccaa::isCollinear(corners) && !task_.obstructed(corners) &&
         std::none_of(triangles_.begin(), triangles_.end(), [&](const Triangle& t) {
           return ccaa::trianglesMeet(corners, ccaa::cornersOf(t, points_));
         });
}

/** What a fan sees. \param[in,out] order of the edges: those that were not seen last
 * come first \return false as soon as it is blind for more than a number */
bool
Fans::look(const Loop& loop,
           std::size_t most_blind,
           std::vector<std::size_t>& order,
           Fan& fan)
{
  fan.is_blind.assign(loop.size(), false);
  for (auto next = order.begin(); next != order.end(); ++next) {
    const std::size_t k = *next;
    const ccaa::Corners corners{
        at(loop[(k + 1) % loop.size()]), at(loop[k]), fan.centre};
    if (isFree(corners))
      continue;
    fan.is_blind[k] = true;
    std::rotate(order.begin(), next, next + 1);
    if (++fan.blind > most_blind)
      return false;
  }
  return true;
}

/** The first of those that see most: all but one of 839 fans that have closed holes
 * were that one, and each saw more than half of its loop. */
std::optional<Fan>
Fans::bestFan(const Loop& loop)
{
  std::optional<Fan> best;
  std::vector<std::size_t> order(loop.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (const Position& place : placesFor(loop)) {
    if (questions_ > most_questions_ || (best && best->blind == 0))
      break;
    Fan fan;
    fan.centre = place;
    if (look(loop, best ? best->blind - 1 : loop.size() / 2, order, fan))
      best = std::move(fan);
  }
  return best;
}

/** \return false where its triangles meet each other */
bool
Fans::add(const Loop& loop, const Fan& fan)
{
  const auto centre = static_cast<pcl::index_t>(points_.size());
  points_.push_back(fan.centre);
  const std::size_t before = triangles_.size();
  for (std::size_t k = 0; k < loop.size(); ++k) {
    if (fan.is_blind[k])
      continue;
    const Triangle triangle{loop[(k + 1) % loop.size()], loop[k], centre};
    const ccaa::Corners corners = ccaa::cornersOf(triangle, points_);
    for (std::size_t t = before; t < triangles_.size(); ++t)
      if (ccaa::trianglesMeet(corners, ccaa::cornersOf(triangles_[t], points_)))
        return false;
    triangles_.push_back(triangle);
  }
  return true;
}

/** What the last fan does not see. */
bool
Fans::closeRest(const Loop& loop, const Fan& fan, int depth)
{
  const auto centre = static_cast<pcl::index_t>(points_.size() - 1);
  const std::size_t n = loop.size();
  for (std::size_t first = 0; first < n; ++first) {
    if (!fan.is_blind[first] || fan.is_blind[(first + n - 1) % n])
      continue;
    Loop rest{centre, loop[first]};
    for (std::size_t k = first; fan.is_blind[k]; k = (k + 1) % n)
      rest.push_back(loop[(k + 1) % n]);
    if (!close(rest, depth))
      return false;
  }
  return true;
}

bool
Fans::close(const Loop& loop, int depth)
{
  const std::optional<Fan> fan = bestFan(loop);
  return fan && (fan->blind == 0 || depth > 0) && add(loop, *fan) &&
         closeRest(loop, *fan, depth - 1);
}

} // namespace

Filling
AvoidingFans::close(const FillingTask& task) const
{
  Fans fans(task);
  Loop loop(task.polygon.size());
  for (std::size_t k = 0; k < loop.size(); ++k)
    loop[k] = static_cast<pcl::index_t>(k);
  if (loop.size() >= 3 && fans.close(loop, DEPTH))
    return fans.filling();
  Filling none;
  none.problem = "no inner points see the whole boundary";
  return none;
}

} // namespace pcl::repair
