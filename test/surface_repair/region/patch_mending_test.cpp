// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of patches that are filled anew in parts.

#include <gtest/gtest.h>

#include "patch/patch_assembly.h"
#include "region/patch_mending.h"
#include "support/repair_fixture.h"
#include "surface_repair/boundary/boundary_models.h"

#include <map>

namespace pcl::repair::test {
namespace {

/** A sphere of which the cap above a height is a patch. */
struct CappedSphere {
  IncompleteModel model;
  Patch patch;
};

/** \param[in] others more bodies of the model */
CappedSphere
cappedSphere(const Shape& others)
{
  const Shape sphere = icosphere(4);
  const auto is_of_cap = [&](const Triangle& triangle) {
    return std::any_of(triangle.begin(), triangle.end(), [&](pcl::index_t corner) {
      return sphere.vertices[static_cast<std::size_t>(corner)].z() > 0.4;
    });
  };
  const std::size_t corners = sphere.vertices.size();
  std::vector<bool> is_given(corners, false);
  std::vector<std::size_t> cap;
  for (std::size_t t = 0; t < sphere.triangles.size(); ++t)
    if (is_of_cap(sphere.triangles[t]))
      cap.push_back(t);
    else
      for (const pcl::index_t corner : sphere.triangles[t])
        is_given[static_cast<std::size_t>(corner)] = true;
  CappedSphere found;
  found.model =
      modelOf(joined(withoutFreeVertices(withoutTriangles(sphere, cap)), others));
  std::map<pcl::index_t, pcl::index_t> in_patch;
  for (const bool of_rim : {true, false})
    for (const std::size_t t : cap)
      for (const pcl::index_t corner : sphere.triangles[t]) {
        const auto v = static_cast<std::size_t>(corner);
        if (is_given[v] != of_rim ||
            !in_patch
                 .emplace(corner,
                          static_cast<pcl::index_t>(found.patch.positions.size()))
                 .second)
          continue;
        found.patch.positions.push_back(sphere.vertices[v]);
        const Positions& places = found.model.positions;
        if (of_rim)
          found.patch.rim.push_back(static_cast<pcl::index_t>(
              std::find(places.begin(), places.end(), sphere.vertices[v]) -
              places.begin()));
      }
  for (const std::size_t t : cap) {
    Triangle triangle = sphere.triangles[t];
    for (pcl::index_t& corner : triangle)
      corner = in_patch.at(corner);
    found.patch.triangles.push_back(triangle);
  }
  found.patch.free_point.assign(found.patch.positions.size(), NONE);
  found.patch.hole.assign(cap.size(), 0);
  return found;
}

SurfaceObstacle
wholeModel(const CappedSphere& capped)
{
  ccaa::Box box;
  for (const Position& position : capped.model.positions)
    box.extend(position);
  return SurfaceObstacle(capped.model, {box});
}

bool
mend(CappedSphere& capped)
{
  const RepairParameters parameters;
  return mendPatch(withinPart(capped.model, parameters, CloudFrame()),
                   wholeModel(capped),
                   ccaa::LoopContext(),
                   capped.patch);
}

bool
isFreeIn(const CappedSphere& capped)
{
  return obstructedTriangles(capped.patch, wholeModel(capped)).empty();
}

/** A small body on the surface of the unit sphere. */
Shape
ballAt(const Position& place, double radius)
{
  return translated(scaled(icosphere(0), radius), place);
}

TEST(PatchMending, FillsAnewWhatRunsIntoSomething)
{
  CappedSphere capped = cappedSphere(joined(ballAt(Position(0.0, 0.0, 1.02), 0.04),
                                            ballAt(Position(0.6, 0.0, 0.82), 0.04)));
  const std::size_t rim = capped.patch.rim.size();
  ASSERT_TRUE(fitsModel(capped.model, capped.patch));
  ASSERT_FALSE(isFreeIn(capped));
  ASSERT_TRUE(mend(capped));
  EXPECT_TRUE(isFreeIn(capped));
  EXPECT_TRUE(fitsModel(capped.model, capped.patch));
  EXPECT_EQ(rim, capped.patch.rim.size());
}

TEST(PatchMending, KeepsWhatIsFarFromThat)
{
  CappedSphere capped = cappedSphere(ballAt(Position(0.0, 0.0, 1.02), 0.04));
  const Triangles before = capped.patch.triangles;
  ASSERT_TRUE(mend(capped));
  const auto rim = static_cast<pcl::index_t>(capped.patch.rim.size());
  const auto at_rim = [rim](const Triangle& triangle) {
    return std::any_of(triangle.begin(), triangle.end(), [rim](pcl::index_t corner) {
      return corner < rim;
    });
  };
  const Triangles& now = capped.patch.triangles;
  EXPECT_EQ(std::count_if(before.begin(), before.end(), at_rim),
            std::count_if(now.begin(), now.end(), at_rim));
}

TEST(PatchMending, LeavesAPatchThatIsFreeAsItIs)
{
  CappedSphere capped = cappedSphere({});
  const Positions positions = capped.patch.positions;
  EXPECT_TRUE(mend(capped));
  EXPECT_EQ(positions, capped.patch.positions);
}

TEST(PatchMending, LeavesAPatchThatIsWrongAsAWhole)
{
  CappedSphere capped = cappedSphere(
      translated(without(icosphere(4), [](const Position& p) { return p.z() > 0.0; }),
                 Position(0.0, 0.0, 1.2)));
  const Triangles triangles = capped.patch.triangles;
  EXPECT_FALSE(mend(capped));
  EXPECT_EQ(triangles, capped.patch.triangles);
}

} // namespace
} // namespace pcl::repair::test
