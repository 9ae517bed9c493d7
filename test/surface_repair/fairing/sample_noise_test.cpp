// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the noise of samples.
#include <gtest/gtest.h>

#include "fairing/sample_noise.h"
#include "support/random_source.h"
#include "support/shapes.h"

namespace pcl::repair::test {
namespace {

/** A curved sheet of spacing 1 of which every vertex is a sample, off by a normal
 * deviation. */
Patch
samplesOfASheet(double deviation)
{
  const ccaa::test::Shape sheet = ccaa::test::grid(30, 30);
  ccaa::test::RandomSource random(1);
  Patch patch;
  patch.triangles = sheet.triangles;
  patch.hole.assign(patch.triangles.size(), 0);
  for (const Position& p : sheet.vertices) {
    patch.free_point.push_back(patch.positions.size());
    patch.positions.emplace_back(
        p.x(), p.y(), 0.01 * p.x() * p.x() + deviation * random.normal());
  }
  return patch;
}

TEST(NoiseOfSamples, IsTheirDeviationFromACurvedSheet)
{
  EXPECT_NEAR(0.1, noiseOfSamples(samplesOfASheet(0.1)).deviation, 0.01);
}

TEST(NoiseOfSamples, IsAShareOfTheEdgesLessItsError)
{
  const SampleNoise noise = noiseOfSamples(samplesOfASheet(0.1));
  EXPECT_LT(noise.share, noise.deviation); // no edge is shorter than 1
  EXPECT_GT(noise.share, 0.7 * noise.deviation);
}

TEST(NoiseOfSamples, IsNoneWhereTheyAreExact)
{
  EXPECT_LT(noiseOfSamples(samplesOfASheet(0.0)).deviation,
            1e-5); // a quadric over the normal is none over z
}

TEST(NoiseOfSamples, IsNoneWithoutSamples)
{
  Patch patch = samplesOfASheet(0.1);
  patch.free_point.assign(patch.positions.size(), NONE);
  EXPECT_EQ(0.0, noiseOfSamples(patch).deviation);
  EXPECT_EQ(0.0, noiseOfSamples(patch).share);
}

} // namespace
} // namespace pcl::repair::test
