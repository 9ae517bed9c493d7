// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: points that lie in lines, as the profiles of a scanner.
#include "greedy/scan_lines.h"

#include <Eigen/Eigenvalues>

#include "mesh/quantile.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace pcl::ccaa {
namespace {

using Offset = Eigen::Vector3d;

/** Nearest neighbors of a point that lie in a line with it where it is in one. */
constexpr unsigned int IN_LINE = 10;
/** Of them those that tell the spacing. */
constexpr unsigned int NEAREST = 6;
/** Largest variance across a line in that along it: of 40 scans and models at most 11 %
 * of the points have less, of lines seven spacings apart with noise of half a spacing
 * nearly all, with noise of a whole one 40 %. */
constexpr double FLATTEST = 0.1;
/** Least share of points in lines at which these are the way the cloud was taken, and
 * not its wires and edges. */
constexpr double LEAST_SHARE = 0.25;
/** Neighbors off the line with which a point sees the next: some on either side. */
constexpr unsigned int LEAST_BESIDE = 6;
/** Largest share of these that may see less. */
constexpr double MOST_BLIND = 0.1;
/** Least share of these with lines on both sides: of six lines beside each other. A
 * coil of three turns, or a few wires, are no surface. */
constexpr double LEAST_BETWEEN = 0.6;
/** Squared sine of the angle to a line from which on a neighbor is off it: 30 degrees.
 */
constexpr double OFF_LINE = 0.25;
constexpr std::size_t ASKED = 1000;

/** The neighbors of a point, nearest first. */
struct Row {
  const index_t* ranks;
  unsigned int count;
};

Offset
offsetTo(const RankedPoints& points, index_t from, index_t to)
{
  const auto vector = [&](index_t rank) {
    return Eigen::Map<const Eigen::Vector3f>(
               points.coordinates[static_cast<std::size_t>(rank)].data())
        .cast<double>();
  };
  return vector(to) - vector(from);
}

/** The direction of the line that a point and those around it lie in, if they do. */
std::optional<Offset>
lineAt(const RankedPoints& points, index_t rank, const Row& row)
{
  if (row.count < IN_LINE)
    return std::nullopt;
  Offset mean = Offset::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  for (unsigned int j = 0; j < IN_LINE; ++j) {
    const Offset offset = offsetTo(points, rank, row.ranks[j]);
    mean += offset / (IN_LINE + 1.0);
    products += offset * offset.transpose();
  }
  products -= (IN_LINE + 1.0) * mean * mean.transpose();
  // The sum of the variances and that of their products in pairs tell without any
  // roots of nearly all points of a surface that they are in no line.
  const double sum = products.trace();
  const double pairs = 0.5 * (sum * sum - products.squaredNorm());
  constexpr double line_sum = 1.0 + 2.0 * FLATTEST;
  if (pairs * line_sum * line_sum > FLATTEST * (2.0 + FLATTEST) * sum * sum)
    return std::nullopt;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(products);
  const auto& variances = solver.eigenvalues();
  if (variances[1] > FLATTEST * variances[2])
    return std::nullopt;
  return solver.eigenvectors().col(2);
}

/** What a point in a line sees of the next ones. */
struct Beside {
  unsigned int count = 0;     /**< neighbors off the line */
  bool on_both_sides = false; /**< of the line */
  double gap = 0.0;           /**< distance of the first in spacings along the line */
};

Beside
lookBeside(const RankedPoints& points, index_t rank, const Row& row, const Offset& line)
{
  double sum = 0.0;
  Beside beside;
  Offset first = Offset::Zero();
  for (unsigned int j = 0; j < row.count; ++j) {
    const Offset offset = offsetTo(points, rank, row.ranks[j]);
    const Offset across = offset - offset.dot(line) * line;
    if (j < NEAREST)
      sum += offset.squaredNorm();
    else if (across.squaredNorm() > OFF_LINE * offset.squaredNorm()) {
      if (beside.count++ == 0) {
        first = across;
        beside.gap = std::sqrt(offset.squaredNorm() / (sum / NEAREST));
      }
      beside.on_both_sides = beside.on_both_sides || across.dot(first) < 0.0;
    }
  }
  return beside;
}

/** Times the distance of the next line that an edge may be long where points lie in
 * lines. */
constexpr double NEXT_LINE = 1.5;

} // namespace

bool
isInLine(const RankedPoints& points, const NeighborRows& neighbors, index_t rank)
{
  return lineAt(points, rank, {neighbors.row(rank), neighbors.count(rank)}).has_value();
}

ScanLines
findScanLines(const RankedPoints& points, const NeighborRows& neighbors)
{
  return findScanLines(points, [&](index_t rank) {
    const index_t* const row = neighbors.row(rank);
    return std::vector<index_t>(row, row + neighbors.count(rank));
  });
}

ScanLines
findScanLines(const RankedPoints& points,
              const std::function<std::vector<index_t>(index_t)>& neighborsOf)
{
  const std::size_t step = std::max<std::size_t>(1, points.size() / ASKED);
  std::size_t asked = 0, in_lines = 0, blind = 0, between = 0;
  std::vector<double> gaps;
  for (std::size_t r = 0; r < points.size(); r += step, ++asked) {
    const auto rank = static_cast<index_t>(r);
    const std::vector<index_t> near = neighborsOf(rank);
    const Row row{near.data(), static_cast<unsigned int>(near.size())};
    if (const auto line = lineAt(points, rank, row)) {
      const Beside beside = lookBeside(points, rank, row, *line);
      ++in_lines;
      blind += beside.count < LEAST_BESIDE;
      between += beside.on_both_sides;
      if (beside.count > 0)
        gaps.push_back(beside.gap);
    }
  }
  const auto is_share = [](std::size_t part, double share, std::size_t whole) {
    return static_cast<double>(part) > share * static_cast<double>(whole);
  };
  if (!is_share(in_lines, LEAST_SHARE, asked))
    return {};
  ScanLines lines;
  lines.is_blind = is_share(blind, MOST_BLIND, in_lines);
  if (is_share(between, LEAST_BETWEEN, in_lines))
    lines.gap = medianOf(std::move(gaps));
  return lines;
}

double
reachInLines(const ScanLines& lines, double length_factor)
{
  return std::max(length_factor, NEXT_LINE * lines.gap);
}

} // namespace pcl::ccaa
