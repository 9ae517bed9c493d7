// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the factorisation of a large sparse matrix, which can be
// left in the middle.

#include "fairing/sparse_factorisation.h"

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace pcl::repair {

namespace {

/** Operations to put an entry in order, and multiplications in an operation. */
constexpr std::uint64_t ORDERING_WORK = 10;
constexpr std::uint64_t MULTIPLICATIONS = 5;

} // namespace

bool
SparseFactorisation::factorise(const SparseMatrix& matrix, ccaa::RunControl* control)
{
  pivots_.clear();
  const bool is_analysed = isAnalysed(matrix);
  const auto entries = static_cast<std::uint64_t>(matrix.nonZeros());
  if (ccaa::spend(control, entries) && !is_analysed)
    findOrder(matrix);
  if (!ccaa::spend(control, (is_analysed ? 1 : ORDERING_WORK) * entries)) {
    known_starts_.clear();
    return false;
  }
  SparseMatrix upper(matrix.rows(), matrix.cols());
  upper.selfadjointView<Eigen::Upper>() =
      matrix.selfadjointView<Eigen::Lower>().twistedBy(order_);
  if ((is_analysed || countEntries(upper, control)) && computeRows(upper, control))
    return true;
  known_starts_.clear();
  pivots_.clear();
  return false;
}

/** Whether the order of the last matrix serves. */
bool
SparseFactorisation::isAnalysed(const SparseMatrix& matrix)
{
  const int* const starts = matrix.outerIndexPtr();
  const int* const rows = matrix.innerIndexPtr();
  std::vector<int> new_starts(starts, starts + matrix.outerSize() + 1);
  std::vector<int> new_rows(rows, rows + matrix.nonZeros());
  if (new_starts == known_starts_ && new_rows == known_rows_)
    return true;
  known_starts_.swap(new_starts);
  known_rows_.swap(new_rows);
  return false;
}

void
SparseFactorisation::findOrder(const SparseMatrix& matrix)
{
  const SparseMatrix both = matrix.selfadjointView<Eigen::Lower>();
  Eigen::AMDOrdering<int>()(both, back_);
  order_ = back_.inverse();
}

/** The elimination tree, and from it how many entries each column of L has. */
bool
SparseFactorisation::countEntries(const SparseMatrix& upper, ccaa::RunControl* control)
{
  const auto size = static_cast<std::size_t>(upper.cols());
  parent_.assign(size, -1);
  seen_in_.assign(size, -1);
  std::vector<std::size_t> counts(size, 0);
  ccaa::WorkCount work(control);
  for (int row = 0; row < static_cast<int>(size); ++row) {
    const auto own = static_cast<std::size_t>(row);
    seen_in_[own] = row;
    for (SparseMatrix::InnerIterator entry(upper, row); entry; ++entry) {
      auto column = static_cast<std::size_t>(entry.row());
      for (; column < own && seen_in_[column] != row;
           column = static_cast<std::size_t>(parent_[column])) {
        if (parent_[column] < 0)
          parent_[column] = row;
        ++counts[column];
        seen_in_[column] = row;
        if (!work.add(1))
          return false;
      }
    }
  }
  starts_.assign(size + 1, 0);
  for (std::size_t k = 0; k < size; ++k)
    starts_[k + 1] = starts_[k] + counts[k];
  return true;
}

bool
SparseFactorisation::computeRows(const SparseMatrix& upper, ccaa::RunControl* control)
{
  const auto size = static_cast<std::size_t>(upper.cols());
  rows_.resize(starts_.back());
  values_.resize(starts_.back());
  pivots_.assign(size, 0.0);
  ends_.assign(starts_.begin(), starts_.end() - 1);
  row_values_.assign(size, 0.0);
  reached_.resize(size);
  seen_in_.assign(size, -1);
  ccaa::WorkCount work(control);
  for (int row = 0; row < static_cast<int>(size); ++row) {
    const auto own = static_cast<std::size_t>(row);
    std::size_t multiplications = MULTIPLICATIONS;
    const int first = findRow(upper, row);
    double pivot = std::exchange(row_values_[own], 0.0);
    for (auto k = static_cast<std::size_t>(first); k < size; ++k)
      multiplications += eliminate(reached_[k], row, pivot);
    pivots_[own] = pivot;
    if (pivot == 0.0 || !work.add(multiplications / MULTIPLICATIONS))
      return false;
  }
  return true;
}

/** The columns in which a row of L has entries: what can be reached in the elimination
 * tree from the entries of the matrix, each before its parent.
 * \return place of the first of them in reached_ */
int
SparseFactorisation::findRow(const SparseMatrix& upper, int row)
{
  auto first = static_cast<std::size_t>(reached_.size());
  seen_in_[static_cast<std::size_t>(row)] = row;
  for (SparseMatrix::InnerIterator entry(upper, row); entry; ++entry) {
    auto column = static_cast<std::size_t>(entry.row());
    if (column > static_cast<std::size_t>(row))
      continue;
    row_values_[column] += entry.value();
    std::size_t steps = 0;
    for (; seen_in_[column] != row;
         column = static_cast<std::size_t>(parent_[column])) {
      reached_[steps++] = static_cast<int>(column);
      seen_in_[column] = row;
    }
    while (steps > 0)
      reached_[--first] = reached_[--steps];
  }
  return static_cast<int>(first);
}

/** Take a multiple of an earlier row from one, and add an entry to L.
 * \return multiplications */
std::size_t
SparseFactorisation::eliminate(int column, int row, double& pivot)
{
  const auto at = static_cast<std::size_t>(column);
  const double value = std::exchange(row_values_[at], 0.0);
  const std::size_t end = ends_[at];
  for (std::size_t p = starts_[at]; p < end; ++p)
    row_values_[static_cast<std::size_t>(rows_[p])] -= values_[p] * value;
  const double factor = value / pivots_[at];
  pivot -= factor * value;
  rows_[end] = row;
  values_[end] = factor;
  ++ends_[at];
  return end - starts_[at] + 1;
}

Columns
SparseFactorisation::solve(const Columns& sides, ccaa::RunControl* control) const
{
  Columns solution = order_ * sides;
  ccaa::WorkCount work(control);
  const std::size_t size = pivots_.size();
  for (Eigen::Index c = 0; c < solution.cols(); ++c) {
    double* const x = solution.col(c).data();
    for (std::size_t k = 0; k < size; ++k) {
      for (std::size_t p = starts_[k]; p < starts_[k + 1]; ++p)
        x[rows_[p]] -= x[k] * values_[p];
      work.add((starts_[k + 1] - starts_[k]) / MULTIPLICATIONS + 1);
    }
    for (std::size_t k = 0; k < size; ++k)
      x[k] *= 1.0 / pivots_[k];
    for (std::size_t k = size; k-- > 0;) {
      for (std::size_t p = starts_[k]; p < starts_[k + 1]; ++p)
        x[k] -= values_[p] * x[rows_[p]];
      if (!work.add((starts_[k + 1] - starts_[k]) / MULTIPLICATIONS + 1))
        return solution;
    }
  }
  return back_ * solution;
}

} // namespace pcl::repair
