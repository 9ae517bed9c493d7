// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a few indices out of many.
#include <gtest/gtest.h>

#include "mesh/index_set.h"

#include <map>
#include <random>

namespace pcl::ccaa {
namespace {

TEST(IndexSet, IsEmptyAtFirst)
{
  const IndexSet set;
  EXPECT_EQ(set.size(), 0u);
  EXPECT_EQ(set.placeOf(0), -1);
  EXPECT_FALSE(set.contains(-1));
}

TEST(IndexSet, NumbersIndicesAsTheyCame)
{
  const IndexSet set({7, 3, 7, 1 << 30, 3});
  EXPECT_EQ(set.items(), (std::vector<pcl::index_t>{7, 3, 1 << 30}));
  EXPECT_EQ(set.placeOf(1 << 30), 2);
  EXPECT_EQ(set.placeOf(8), -1);
}

/** Multiples of a power of two all want the same slots. */
TEST(IndexSet, AgreesWithAMapForSpreadAndForCrowdedIndices)
{
  for (const pcl::index_t stride : {1, 64, 1 << 16}) {
    std::mt19937 random(5);
    IndexSet set;
    std::map<pcl::index_t, pcl::index_t> places;
    for (int i = 0; i < 5000; ++i) {
      const auto item = static_cast<pcl::index_t>(random() % 3000) * stride;
      const bool is_new =
          places.emplace(item, static_cast<pcl::index_t>(places.size())).second;
      ASSERT_EQ(set.insert(item), is_new) << item;
    }
    for (pcl::index_t item = 0; item < 3000; ++item) {
      const auto place = places.find(item * stride);
      ASSERT_EQ(set.placeOf(item * stride), place == places.end() ? -1 : place->second);
    }
  }
}

} // namespace
} // namespace pcl::ccaa
