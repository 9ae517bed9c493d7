// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of patches over samples with noise.

#include <gtest/gtest.h>

#include "support/random_source.h"
#include "support/repair_shapes.h"
#include "surface_repair/boundary/boundary_models.h"
#include "surface_repair/region/closing_site.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace pcl::repair {
namespace {

using namespace ccaa::test;
using test::Site;

constexpr std::size_t SAMPLES = 60; // 0.2 apart

/** A sphere without its cap, but for samples of it that are off by a normal deviation;
 * closed. */
ClosedRegion
closedCap(double deviation, double trust)
{
  Shape shape = withoutFreeVertices(
      test::without(icosphere(4), [](const Position& p) { return p.z() > 0.7; }));
  RandomSource random(1);
  for (std::size_t i = 0; i < SAMPLES; ++i) { // the lowest first, a spiral
    const double z = 0.7 + 0.3 * (static_cast<double>(i) + 0.5) / SAMPLES;
    const double turn = 2.39996 * static_cast<double>(i), across = std::sqrt(1 - z * z);
    const Position place(across * std::cos(turn), across * std::sin(turn), z);
    shape.vertices.push_back((1.0 + deviation * random.normal()) * place);
  }
  RepairParameters parameters;
  parameters.survey.field.trust = trust;
  const Site site(shape, parameters);
  Region region = site.regions.at(0);
  region.samples.resize(SAMPLES);
  std::iota(region.samples.begin(), region.samples.end(), std::size_t(0));
  ClosedRegion closed = site.close(region);
  EXPECT_EQ(OpenReason::NONE, closed.holes.at(0).open);
  return closed;
}

/** Root mean square of the vertices within. */
double
distanceFromSphere(const Patch& patch)
{
  double sum = 0.0;
  for (std::size_t v = patch.rim.size(); v < patch.positions.size(); ++v)
    sum += std::pow(patch.positions[v].norm() - 1.0, 2);
  return std::sqrt(sum /
                   static_cast<double>(patch.positions.size() - patch.rim.size()));
}

std::ptrdiff_t
heldSamples(const Patch& patch)
{
  return std::count_if(patch.free_point.begin(),
                       patch.free_point.end(),
                       [](std::size_t point) { return point != NONE; });
}

TEST(PatchGrowth, AveragesSamplesWithNoise)
{
  const ClosedRegion closed = closedCap(0.15, 0.5);
  EXPECT_EQ(0, heldSamples(closed.patch));
  EXPECT_LT(distanceFromSphere(closed.patch),
            0.5 * distanceFromSphere(closedCap(0.15, 0.99).patch));
}

TEST(PatchGrowth, HoldsExactSamples)
{
  EXPECT_GT(heldSamples(closedCap(0.0, 0.5).patch), 50);
}

TEST(PatchGrowth, HoldsSamplesWithNoiseThatAreTrusted)
{
  EXPECT_GT(heldSamples(closedCap(0.1, 0.99).patch), 50);
}

TEST(PatchGrowth, HoldsSamplesOfLittleNoiseByTrust)
{
  EXPECT_GT(heldSamples(closedCap(0.02, 0.5).patch), 50);
  EXPECT_EQ(0, heldSamples(closedCap(0.02, 0.05).patch));
}

} // namespace
} // namespace pcl::repair
