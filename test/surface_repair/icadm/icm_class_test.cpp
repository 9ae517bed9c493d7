// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the classes of incomplete models.
#include <gtest/gtest.h>

#include "icadm/icm_class.h"

namespace pcl::repair {
namespace {

TEST(IcmClass, OneRegionWithoutHolesIsTheFirstClass)
{
  EXPECT_EQ(IcmClass::ICM1, classOf(countHoles(1, {})));
}

TEST(IcmClass, OneRegionWithSimpleHolesIsTheFirstClass)
{
  EXPECT_EQ(IcmClass::ICM1, classOf(countHoles(1, {3, 12})));
}

TEST(IcmClass, OneComplexHoleMakesTheSecondClass)
{
  EXPECT_EQ(IcmClass::ICM2, classOf(countHoles(1, {3, 13})));
}

TEST(IcmClass, SeveralIslandsMakeTheThirdClassWhateverTheHoles)
{
  EXPECT_EQ(IcmClass::ICM3, classOf(countHoles(2, {3})));
  EXPECT_EQ(IcmClass::ICM3, classOf(countHoles(2, {100})));
}

TEST(IcmClass, CountsHolesOnBothSidesOfTheLimit)
{
  const IcmCounts counts = countHoles(2, {3, 5, 6, 7}, 5);
  EXPECT_EQ(2u, counts.islands);
  EXPECT_EQ(2u, counts.simple_holes);
  EXPECT_EQ(2u, counts.complex_holes);
}

} // namespace
} // namespace pcl::repair
