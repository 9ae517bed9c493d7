// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests that all instruction sets give the same bits.
#include <gtest/gtest.h>

#include "field/field_kernel.h"
#include "support/random_source.h"

#include <array>
#include <limits>
#include <numeric>
#include <vector>

namespace pcl::repair::test {
namespace {

using namespace field_kernel;
using TensionValues = std::array<double, 9>;

/** \brief The kernels this processor can run. */
std::vector<const Kernel*>
kernels()
{
  std::vector<const Kernel*> found = {&BASELINE_KERNEL};
#ifdef PCL_REPAIR_HAS_X86_KERNELS
  if (__builtin_cpu_supports("avx2"))
    found.push_back(&AVX2_KERNEL);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
    found.push_back(&AVX512_KERNEL);
#endif
  return found;
}

/** \brief Eleven blocks of random numbers, so that no kernel has only whole groups. */
class FieldKernel : public ::testing::Test {
protected:
  static constexpr std::size_t BLOCKS = 11;

  FieldKernel() : values_(BLOCKS * ROWS * LANES), list_(BLOCKS), shares_(BLOCKS * LANES)
  {
    ccaa::test::RandomSource random(1);
    for (double& value : values_)
      value = random.uniform(-1.0, 1.0);
    for (double& share : shares_)
      share = random.uniform();
    std::iota(list_.begin(), list_.end(), 0u);
    task_.blocks = values_.data();
    task_.list = list_.data();
    task_.count = BLOCKS;
    task_.far = 1.5;
    task_.inverse_width = 0.8;
    task_.length = 2.0;
    task_.tangent[1] = 1.0;
  }

  void
  expectTheSameBits() const
  {
    TensionValues expected;
    BASELINE_KERNEL.sum(task_, expected.data());
    for (const Kernel* kernel : kernels()) {
      TensionValues tension;
      kernel->sum(task_, tension.data());
      EXPECT_EQ(tension, expected) << "exponent " << task_.exponent;
    }
  }

  Task task_;
  std::vector<double> values_;
  std::vector<std::uint32_t> list_;
  std::vector<double> shares_;
};

TEST_F(FieldKernel, GivesTheSameBitsForAnyExponent)
{
  for (const double exponent : {0.4, 0.5, 1.0, 1.7, 2.0, 2.5, 3.14})
    for (const double interpolation : {0.0, 0.35}) {
      task_.exponent = exponent;
      task_.half_interpolation = interpolation;
      expectTheSameBits();
    }
}

TEST_F(FieldKernel, GivesTheSameBitsWithEffectiveCharges)
{
  task_.effective = true;
  task_.threshold = 0.1;
  expectTheSameBits();
}

TEST_F(FieldKernel, GivesTheSameBitsInFullMode)
{
  task_.ratios = task_.deltas = shares_.data();
  for (const bool effective : {false, true}) {
    task_.effective = effective;
    expectTheSameBits();
  }
}

TEST_F(FieldKernel, SelectsTheSameBlocksOfGroupsThatAreNear)
{
  const std::vector<double> radii(16, 0.2);
  std::vector<std::uint32_t> blocks(16);
  std::iota(blocks.begin(), blocks.end(), 100u);
  const double never = std::numeric_limits<double>::infinity();
  const CandidateGroup groups[] = {{{0, 0, 0}, 2.0, never, 0},
                                   {{0, 0, 0}, 2.0, never, 0}};
  const Candidates candidates{groups,
                              2,
                              {&values_[0], &values_[16], &values_[32]},
                              radii.data(),
                              blocks.data()};
  task_.far = 0.6;
  task_.coarse = true;
  std::vector<std::uint32_t> expected(16);
  expected.resize(BASELINE_KERNEL.select(candidates, task_, expected.data()));
  EXPECT_FALSE(expected.empty());
  for (const Kernel* kernel : kernels()) {
    std::vector<std::uint32_t> list(16);
    list.resize(kernel->select(candidates, task_, list.data()));
    EXPECT_EQ(list, expected);
  }
}

TEST_F(FieldKernel, SelectsTheCoarseBlockOfAGroupThatIsFarOnlyWhereThatIsAllowed)
{
  const std::vector<double> centers(8, 1.0), radii(8, 0.2);
  std::vector<std::uint32_t> blocks(8);
  std::iota(blocks.begin(), blocks.end(), 0u);
  const CandidateGroup group = {{1, 1, 1}, 0.3, 1.5, 77};
  const Candidates candidates{&group,
                              1,
                              {centers.data(), centers.data(), centers.data()},
                              radii.data(),
                              blocks.data()};
  for (const Kernel* kernel : kernels())
    for (const bool coarse : {false, true}) {
      task_.far = 2.0;
      task_.coarse = coarse;
      std::vector<std::uint32_t> list(8);
      list.resize(kernel->select(candidates, task_, list.data()));
      EXPECT_EQ(list, coarse ? std::vector<std::uint32_t>{77} : blocks);
    }
}

} // namespace
} // namespace pcl::repair::test
