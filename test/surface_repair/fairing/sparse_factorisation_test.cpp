// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the sparse factorisation.
#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>

#include "fairing/sparse_factorisation.h"
#include "support/random_source.h"

namespace pcl::repair {
namespace {

using ccaa::test::RandomSource;

/** The square of a Laplacian of a grid with random weights and fixed borders. */
SparseMatrix
gridMatrix(int columns, std::uint64_t seed)
{
  RandomSource random(seed);
  std::vector<Eigen::Triplet<double>> entries;
  const auto join = [&](int a, int b) {
    const double weight = 0.5 + random.uniform();
    entries.emplace_back(a, b, -weight);
    entries.emplace_back(b, a, -weight);
    entries.emplace_back(a, a, weight);
    entries.emplace_back(b, b, weight);
  };
  for (int i = 0; i < columns; ++i)
    for (int k = 0; k < columns; ++k) {
      entries.emplace_back(i * columns + k, i * columns + k, 0.01);
      if (k + 1 < columns)
        join(i * columns + k, i * columns + k + 1);
      if (i + 1 < columns)
        join(i * columns + k, (i + 1) * columns + k);
    }
  SparseMatrix laplacian(columns * columns, columns * columns);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian.transpose() * laplacian;
}

Columns
randomSides(Eigen::Index rows, std::uint64_t seed)
{
  RandomSource random(seed);
  return Columns::NullaryExpr(rows, 3, [&] { return random.uniform() - 0.5; });
}

TEST(SparseFactorisation, SolvesWhatEigenSolves)
{
  SparseFactorisation own;
  for (const int columns : {1, 2, 7, 20, 20, 60}) {
    const SparseMatrix matrix =
        gridMatrix(columns, static_cast<std::uint64_t>(columns));
    const Columns sides = randomSides(matrix.rows(), 5);
    const Eigen::SimplicialLDLT<SparseMatrix> other(matrix);
    ASSERT_TRUE(own.factorise(matrix));
    const Columns expected = other.solve(sides), found = own.solve(sides);
    EXPECT_LE((found - expected).norm(), 1e-12 * expected.norm()) << columns;
    EXPECT_LE((matrix * found - sides).norm(), 1e-9 * sides.norm()) << columns;
  }
}

TEST(SparseFactorisation, KeepsTheOrderWhereOnlyNumbersChange)
{
  const SparseMatrix first = gridMatrix(20, 1), second = gridMatrix(20, 2);
  const Columns sides = randomSides(first.rows(), 3);
  SparseFactorisation both, one;
  ASSERT_TRUE(both.factorise(first) && both.factorise(second) && one.factorise(second));
  EXPECT_EQ(one.solve(sides), both.solve(sides));
}

TEST(SparseFactorisation, HasNoneOfASingularMatrix)
{
  SparseFactorisation factorisation;
  EXPECT_FALSE(factorisation.factorise(SparseMatrix(3, 3)));
  EXPECT_TRUE(factorisation.factorise(gridMatrix(5, 1)));
}

TEST(SparseFactorisation, TellsItsWorkInSmallParts)
{
  std::uint64_t before = 0;
  for (const int columns : {40, 80, 160}) {
    ccaa::RunControl control;
    SparseFactorisation factorisation;
    const SparseMatrix matrix = gridMatrix(columns, 1);
    ASSERT_TRUE(factorisation.factorise(matrix, &control));
    factorisation.solve(randomSides(matrix.rows(), 1), &control);
    EXPECT_GT(control.work(), 4 * before);
    before = control.work();
    EXPECT_LE(control.longestUnasked(),
              ccaa::RunControl::PATIENCE + 10 * matrix.nonZeros());
  }
}

TEST(SparseFactorisation, IsLeftInTheMiddleAndCanBeDoneAfterwards)
{
  const SparseMatrix matrix = gridMatrix(150, 1);
  const Columns sides = randomSides(matrix.rows(), 1);
  SparseFactorisation whole, left;
  ccaa::RunControl unhurried;
  ASSERT_TRUE(whole.factorise(matrix, &unhurried));
  for (const std::uint64_t part : {50, 10, 4, 2}) {
    ccaa::RunControl control(nullptr, unhurried.work() / part);
    EXPECT_FALSE(left.factorise(matrix, &control)) << part;
    EXPECT_LT(control.work(), unhurried.work()) << part;
  }
  ASSERT_TRUE(left.factorise(matrix));
  EXPECT_EQ(whole.solve(sides), left.solve(sides));
}

} // namespace
} // namespace pcl::repair
