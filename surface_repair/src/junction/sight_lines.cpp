// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what sensors have seen to be empty.

#include "junction/sight_lines.h"

#include "mesh/corners.h"
#include "mesh/quantile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace pcl::repair {

namespace {

/** Positions of sensors that are told apart; of more, sight says nothing. */
constexpr std::size_t MOST_SENSORS = 256;
/** Side of a cell in median angular spacings. */
constexpr double CELL = 2.0;
/** Depths are told apart from here, in cells. */
constexpr double CLEARANCE = 2.0;
/** Cells along half a side of the cube are fewer than this. */
constexpr std::int64_t MOST_CELLS = std::int64_t{1} << 28;

using SensorKey = std::array<double, 3>;

/** The vertices that each sensor has measured. */
std::map<SensorKey, std::vector<std::size_t>>
groupBySensor(const IncompleteModel& model)
{
  std::map<SensorKey, std::vector<std::size_t>> groups;
  for (std::size_t v = 0; v < model.viewpoints.size(); ++v) {
    const Position& sensor = model.viewpoints[v];
    if (sensor.allFinite() && sensor != model.positions[v])
      groups[{sensor.x(), sensor.y(), sensor.z()}].push_back(v);
    if (groups.size() > MOST_SENSORS)
      return {};
  }
  return groups;
}

/** Median angle at the sensor between the ends of edges; 0 where there is none. */
double
angularSpacing(const IncompleteModel& model,
               const std::vector<std::size_t>& vertices,
               const Position& sensor)
{
  std::vector<double> angles;
  for (const std::size_t vertex : vertices) {
    const pcl::index_t triangle =
        *model.adjacency.begin(static_cast<pcl::index_t>(vertex));
    for (const pcl::index_t corner :
         model.triangles[static_cast<std::size_t>(triangle)]) {
      if (static_cast<std::size_t>(corner) == vertex)
        continue;
      const Position a = model.positions[vertex] - sensor;
      const Position b = model.positions[static_cast<std::size_t>(corner)] - sensor;
      angles.push_back(ccaa::angleBetween(a, b));
    }
  }
  return ccaa::medianOf(std::move(angles));
}

} // namespace

std::uint64_t
SightLines::Place::key() const
{
  const auto number = [](std::int64_t cell) {
    return static_cast<std::uint64_t>(cell + MOST_CELLS);
  };
  return (side << 60) | (number(row) << 30) | number(column);
}

SightLines::Place
SightLines::placeOf(const Position& ray, double cell)
{
  Eigen::Index axis = 0;
  const double most = ray.cwiseAbs().maxCoeff(&axis);
  const auto along = [&](Eigen::Index other) {
    return static_cast<std::int64_t>(
        std::floor(ray[(axis + other) % 3] / (most * cell)));
  };
  const auto side = static_cast<std::uint64_t>(2 * axis + (ray[axis] < 0.0 ? 1 : 0));
  return {side, along(1), along(2)};
}

SightLines::SightLines(const IncompleteModel& model)
{
  for (const auto& [key, vertices] : groupBySensor(model)) {
    View view;
    view.sensor = {key[0], key[1], key[2]};
    view.cell = std::max(CELL * angularSpacing(model, vertices, view.sensor),
                         1.0 / static_cast<double>(MOST_CELLS - 1));
    for (const std::size_t vertex : vertices) {
      const Position ray = model.positions[vertex] - view.sensor;
      const double depth = ray.norm();
      const auto [cell, is_new] =
          view.nearest.emplace(placeOf(ray, view.cell).key(), depth);
      if (!is_new)
        cell->second = std::min(cell->second, depth);
    }
    views_.push_back(std::move(view));
  }
}

bool
SightLines::looksThrough(const View& view, const Position& place)
{
  const Position ray = place - view.sensor;
  const double depth = ray.norm();
  if (!(depth > 0.0))
    return false;
  const Place middle = placeOf(ray, view.cell);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::int64_t row = -1; row <= 1; ++row)
    for (std::int64_t column = -1; column <= 1; ++column) {
      const Place around{middle.side, middle.row + row, middle.column + column};
      const auto found = view.nearest.find(around.key());
      if (found != view.nearest.end())
        nearest = std::min(nearest, found->second);
    }
  return std::isfinite(nearest) && nearest > depth * (1.0 + CLEARANCE * view.cell);
}

double
SightLines::seenEmpty(const Positions& places) const
{
  if (places.empty())
    return 0.0;
  const auto empty_ones =
      std::count_if(places.begin(), places.end(), [&](const Position& place) {
        return std::any_of(views_.begin(), views_.end(), [&](const View& view) {
          return looksThrough(view, place);
        });
      });
  return static_cast<double>(empty_ones) / static_cast<double>(places.size());
}

double
SightLines::alongRay(const Position& begin, const Position& end) const
{
  const Position chord = (end - begin).normalized();
  double least = views_.empty() ? 0.0 : 1.0;
  for (const View& view : views_)
    least = std::min(
        least, std::abs(chord.dot((0.5 * (begin + end) - view.sensor).normalized())));
  return least;
}

} // namespace pcl::repair
