// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the dynamic programme behind the least-weight filling.

#include "filling/triangulation_table.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace pcl::repair {

namespace {

/** Twice the area by the square of the longest side, below which a triangle has no
 * normal, and what it weighs besides, by that side: more than some folds, so that
 * points on a line get other triangles where there are others; less than a sharp one,
 * since a crack has none. */
constexpr double LEAST_SINE = 1e-9;
constexpr double FLAT_WEIGHT = 3.0;
/** Of folds by 180 degrees: 1 + cos is taken as this. */
constexpr double SHARPEST = 1e-3;

/** Of a fold between unit normals: tan^2 of half its angle. A triangle without a normal
 * folds at 90 degrees, an edge without one (NaN) not at all. */
double
foldBetween(const Direction& a, const Direction& b)
{
  const double cosine = a.dot(b);
  if (!(cosine < 1.0))
    return 0.0;
  return (1.0 - cosine) / std::max(1.0 + cosine, SHARPEST);
}

} // namespace

TriangulationTable::TriangulationTable(const BoundaryCurve& polygon,
                                       const std::vector<Diagonal>* diagonals,
                                       const FillingWeights& weights,
                                       const FillingLimits& limits)
: polygon_(polygon), weights_(weights), limits_(limits)
{
  makeCells(diagonals);
  columns_.resize(polygon_.size());
  fillRows();
}

void
TriangulationTable::fillRows()
{
  for (std::size_t i = polygon_.size() - 1; i-- > 0;) {
    fillRow(i);
    if (!ccaa::spend(limits_.control, std::exchange(work_, 0)))
      return;
  }
  collect();
}

void
TriangulationTable::makeCells(const std::vector<Diagonal>* diagonals)
{
  const std::size_t n = polygon_.size();
  std::size_t next = 0; // of the diagonals
  for (std::size_t i = 0; i + 1 < n; ++i) {
    row_begin_.push_back(column_of_.size());
    column_of_.push_back(i + 1);
    if (diagonals == nullptr)
      for (std::size_t j = i + 2; j < n - (i == 0 ? 1 : 0); ++j)
        column_of_.push_back(j);
    else
      for (; next < diagonals->size() && (*diagonals)[next].first == i; ++next)
        column_of_.push_back((*diagonals)[next].second);
    if (i == 0 && n > 2)
      column_of_.push_back(n - 1);
  }
  row_begin_.push_back(column_of_.size());
  cells_.resize(column_of_.size());
}

void
TriangulationTable::fillRow(std::size_t i)
{
  for (std::size_t c = row_begin_[i]; c < row_begin_[i + 1]; ++c) {
    const std::size_t j = column_of_[c];
    Cell& cell = cells_[c];
    cell.length = (polygon_.points[j] - polygon_.points[i]).norm();
    if (j == i + 1) {
      cell.weight = 0.0;
      cell.normal = polygon_.normals[i];
    }
    else if (isClosing(i, j) || !limits_.joined || !limits_.joined(i, j))
      fillCell(i, j, cell);
    if (cell.weight < std::numeric_limits<double>::infinity())
      columns_[j].push_back({i, c});
  }
}

void
TriangulationTable::avoid(const Triangles& obstructed)
{
  triangles_.clear();
  std::vector<std::size_t> first_end(polygon_.size(), NONE); // of those from a point on
  for (const Triangle& triangle : obstructed) {
    std::size_t& end = first_end[static_cast<std::size_t>(triangle.front())];
    end = std::min(end, static_cast<std::size_t>(triangle.back()));
  }
  for (std::size_t i = polygon_.size() - 1; i-- > 0;) {
    first_end[i] = std::min(first_end[i], first_end[i + 1]);
    for (std::size_t c = row_begin_[i]; c < row_begin_[i + 1]; ++c) {
      Cell& cell = cells_[c];
      if (column_of_[c] < first_end[i] || cell.apex == NONE)
        continue;
      cell.weight = std::numeric_limits<double>::infinity();
      cell.apex = NONE;
      fillCell(i, column_of_[c], cell);
    }
    if (!ccaa::spend(limits_.control, std::exchange(work_, 0)))
      return;
  }
  collect();
}

/** Of the triangle (i, m, j), with the best triangulations behind its other edges. */
TriangulationTable::Weighed
TriangulationTable::weigh(std::size_t i,
                          std::size_t j,
                          const Cell& cell,
                          const Candidate& candidate) const
{
  const Cell& left = cells_[candidate.left];
  const Cell& right = cells_[candidate.right];
  // The polygon runs i, m, j with the surface on the left, the triangle the other way.
  const Position& from = polygon_.points[i];
  const Eigen::Vector3d doubled =
      (polygon_.points[j] - from).cross(polygon_.points[candidate.apex] - from);
  const double area = doubled.norm();
  const double longest = std::max({cell.length, left.length, right.length});
  Weighed result;
  result.weight = left.weight + right.weight;
  if (area > LEAST_SINE * longest * longest)
    result.normal = doubled / area;
  else
    result.weight += FLAT_WEIGHT * longest;
  result.weight += weighEdge(left, result.normal) + weighEdge(right, result.normal);
  if (isClosing(i, j))
    result.weight +=
        cell.length * weights_.fold * foldBetween(result.normal, polygon_.normals[j]);
  return result;
}

/** Of the edge that closes a cell, with a triangle of this normal on its other side. */
double
TriangulationTable::weighEdge(const Cell& cell, const Direction& normal) const
{
  return cell.length *
         (weights_.length + weights_.fold * foldBetween(normal, cell.normal));
}

void
TriangulationTable::fillCell(std::size_t i, std::size_t j, Cell& cell)
{
  candidates_.clear();
  work_ += columns_[j].size() + 1;
  std::size_t row = row_begin_[i];
  for (auto entry = columns_[j].rbegin(); entry != columns_[j].rend(); ++entry) {
    const std::size_t m = entry->point;
    while (column_of_[row] < m)
      ++row;
    if (column_of_[row] != m)
      continue;
    const Cell& left = cells_[row];
    const Cell& right = cells_[entry->cell];
    const double weight =
        left.weight + right.weight +
        (left.length * weights_.length + right.length * weights_.length);
    if (weight < std::numeric_limits<double>::infinity())
      candidates_.push_back({weight, false, m, row, entry->cell});
  }
  acceptLightest(i, j, cell);
}

/** Of those that are left; null where none is. Only what its edges do not make too
 * heavy is weighed with its folds. */
TriangulationTable::Candidate*
TriangulationTable::lightest(std::size_t i, std::size_t j, const Cell& cell)
{
  const auto is_lighter = [](const Candidate& a, const Candidate& b) {
    return std::tie(a.weight, a.apex) < std::tie(b.weight, b.apex);
  };
  const auto first =
      std::min_element(candidates_.begin(), candidates_.end(), is_lighter);
  if (first == candidates_.end() ||
      first->weight == std::numeric_limits<double>::infinity())
    return nullptr;
  Candidate* best = nullptr;
  const auto consider = [&](Candidate& candidate) {
    if (best != nullptr && !is_lighter(candidate, *best))
      return;
    if (!std::exchange(candidate.is_weighed, true))
      candidate.weight = weigh(i, j, cell, candidate).weight;
    if (best == nullptr || is_lighter(candidate, *best))
      best = &candidate;
  };
  consider(*first);
  for (Candidate& candidate : candidates_)
    consider(candidate);
  return best;
}

/** The lightest candidate with nothing in its way: few are asked, as asking is dear,
 * and none where something is in the way of the diagonal that all of them have. */
void
TriangulationTable::acceptLightest(std::size_t i, std::size_t j, Cell& cell)
{
  bool is_first = true;
  while (Candidate* const candidate = lightest(i, j, cell)) {
    if (!limits_.obstructed || !limits_.obstructed(i, candidate->apex, j)) {
      const Weighed weighed = weigh(i, j, cell, *candidate);
      cell.weight = weighed.weight;
      cell.normal = weighed.normal;
      cell.apex = candidate->apex;
      return;
    }
    if (std::exchange(is_first, false) && !isClosing(i, j) && limits_.crossed &&
        limits_.crossed(i, j))
      return;
    candidate->weight = std::numeric_limits<double>::infinity();
  }
}

void
TriangulationTable::collect()
{
  const std::size_t n = polygon_.size();
  std::vector<Diagonal> open{{0, n - 1}};
  if (cells_[cellAt(0, n - 1)].apex == NONE)
    return;
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (j == i + 1)
      continue;
    const std::size_t m = cells_[cellAt(i, j)].apex;
    triangles_.push_back({static_cast<pcl::index_t>(j),
                          static_cast<pcl::index_t>(m),
                          static_cast<pcl::index_t>(i)});
    open.push_back({m, j});
    open.push_back({i, m});
  }
}

std::size_t
TriangulationTable::cellAt(std::size_t i, std::size_t j) const
{
  const auto begin = column_of_.begin() + static_cast<std::ptrdiff_t>(row_begin_[i]);
  const auto end = column_of_.begin() + static_cast<std::ptrdiff_t>(row_begin_[i + 1]);
  return static_cast<std::size_t>(std::lower_bound(begin, end, j) - column_of_.begin());
}

} // namespace pcl::repair
