// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the factorisation of a large sparse matrix, which can be
// left in the middle.

#pragma once

#include <Eigen/SparseCore>

#include "fairing/surface_laplacian.h"
#include "run/run_control.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief Some columns of numbers, such as coordinates of points. */
using Columns = Eigen::MatrixXd;

/** \brief P A P^T = L D L^T of a symmetric matrix, in an order of minimum degree.
 *
 * Row after row (the up-looking method: T. A. Davis, Direct Methods for Sparse Linear
 * Systems, 2006, 4.7), so that it can be left after any of them; the same numbers as
 * Eigen::SimplicialLDLT finds, which cannot be left. The order is sought anew only
 * where the places of the entries have changed. Cost for a surface of n vertices: n^1.5
 * multiplications, n log n numbers. Not to be used from several threads. */
class SparseFactorisation {
public:
  /** \param[in] matrix symmetric, of which the lower half is looked at
   * \param[in,out] control told the work, may be null
   * \return false when cancelled or where there is none; then nothing can be solved */
  bool
  factorise(const SparseMatrix& matrix, ccaa::RunControl* control = nullptr);

  /** \param[in] sides right sides, as many rows as the matrix that was factorised last
   * \return the solutions; worth nothing after cancelling */
  Columns
  solve(const Columns& sides, ccaa::RunControl* control = nullptr) const;

private:
  using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

  bool
  isAnalysed(const SparseMatrix& matrix);
  void
  findOrder(const SparseMatrix& matrix);
  bool
  countEntries(const SparseMatrix& upper, ccaa::RunControl* control);
  bool
  computeRows(const SparseMatrix& upper, ccaa::RunControl* control);
  int
  findRow(const SparseMatrix& upper, int row);
  std::size_t
  eliminate(int column, int row, double& pivot);

  Permutation order_, back_;
  std::vector<int> known_starts_, known_rows_; /**< entries that were analysed last */
  std::vector<int> parent_;         /**< of a column in the elimination tree */
  std::vector<std::size_t> starts_; /**< of the columns of L; one more */
  std::vector<std::size_t> ends_;   /**< of what is there of each */
  std::vector<int> rows_;           /**< of the entries below the diagonal */
  std::vector<double> values_;      /**< of the same */
  std::vector<double> pivots_;      /**< D */
  std::vector<double> row_values_;  /**< of the row that is computed */
  std::vector<int> reached_;        /**< its columns, in order, at the end */
  std::vector<int> seen_in_;        /**< of a column: the last row */
};

} // namespace pcl::repair
