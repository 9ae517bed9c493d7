// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: facts and orientation of real scans, against known figures.
#include <gtest/gtest.h>

#include "mesh/mesh_facts.h"
#include "mesh/orientation.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"
#include "support/shared_data.h"

#include <cctype>
#include <optional>
#include <string>
#include <vector>

namespace pcl::ccaa::test {
namespace {

/** \brief Figures published with the test models. */
struct RealMesh {
  const char* file;
  std::vector<std::size_t> longest_loops;
  std::size_t loops;
  std::size_t free_points;
  std::size_t non_manifold_edges;
  std::size_t self_intersections;
  std::optional<long> genus;
};

const RealMesh REAL_MESHES[] = {
    {"bunny/bun_zipper.ply", {80, 42, 40, 39, 22}, 5, 1113, 0, 0, 0},
    {"bunny/bun_zipper_res2.ply", {38, 26, 26, 22, 11}, 5, 25, 150, 97, {}},
    {"rocker_arm/rockerArm.ply", {}, 0, 0, 0, 0, 1},
    {"cad_daratech/daratech.ply", {}, 0, 0, 0, 0, 7},
    {"fandisk/fandisk_large.ply", {}, 0, 0, 0, 0, 0},
    {"holes/elephant-with-holes.ply", {78, 41, 38, 35, 35, 32}, 106, 0, 0, 0, 3},
    {"holes/holes.ply", {136, 36, 32, 28, 28, 28}, 7, 0, 0, 0, 0},
    {"holes/building_patch.ply", {432, 13, 7, 5, 5, 3}, 14, 0, 0, 7, {}},
    {"holes/StanfordBunny_pymeshfix.ply", {90, 59, 58, 55, 26, 1}, 70, 0, 132, 5, {}},
    {"bust/Laurana50k.ply", {293, 3, 3, 3}, 4, 2735, 0, 0, 0},
};

class RealMeshes : public ::testing::TestWithParam<RealMesh> {};

TEST_P(RealMeshes, HaveTheFactsPublishedWithThem)
{
  const RealMesh& mesh = GetParam();
  const std::string path = sharedData(mesh.file);
  SKIP_WITHOUT_DATA(path);
  Shape shape;
  ASSERT_TRUE(readShape(path, shape));
  MeshFactsOptions options;
  options.self_intersections = shape.triangles.size() < 35000;
  RunControl control;
  const MeshFacts facts =
      measureMesh(shape.triangles, shape.vertices, options, control);
  EXPECT_EQ(facts.boundary_loops.size(), mesh.loops);
  for (std::size_t i = 0; i < mesh.longest_loops.size(); ++i)
    EXPECT_EQ(facts.boundary_loops[i].edges, mesh.longest_loops[i]);
  EXPECT_EQ(facts.components, 1u);
  EXPECT_EQ(facts.free_vertices, mesh.free_points);
  EXPECT_EQ(facts.non_manifold_edges, mesh.non_manifold_edges);
  EXPECT_EQ(facts.misoriented_edges, 0u);
  EXPECT_EQ(facts.genus, mesh.genus);
  if (options.self_intersections) {
    EXPECT_EQ(facts.self_intersections, mesh.self_intersections);
  }
}

/** \brief A file name as a test name. */
std::string
testName(std::string name)
{
  for (char& letter : name)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0)
      letter = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(,
                         RealMeshes,
                         ::testing::ValuesIn(REAL_MESHES),
                         [](const auto& mesh) { return testName(mesh.param.file); });

/** \brief Scans of one piece whose published winding is outward. */
class RealScans : public ::testing::TestWithParam<const char*> {};

TEST_P(RealScans, AreWoundOutwardWhateverTheyWereBefore)
{
  const std::string path = sharedData(GetParam());
  SKIP_WITHOUT_DATA(path);
  Shape shape;
  ASSERT_TRUE(readShape(path, shape));
  const Triangles published = shape.triangles;
  shape.triangles = randomlyReversed(shape.triangles, 2);
  TriangleAdjacency adjacency;
  adjacency.build(shape.triangles, shape.vertices.size());
  RunControl control;
  orientTriangles(shape.triangles, adjacency, shape.vertices, {}, control);
  EXPECT_TRUE(sameTriangles(published, shape.triangles));
}

INSTANTIATE_TEST_SUITE_P(,
                         RealScans,
                         ::testing::Values("bunny/bun_zipper.ply",
                                           "armadillo/armadillo.ply",
                                           "cad_daratech/daratech.ply",
                                           "holes/holes.ply",
                                           "holes/building_patch.ply",
                                           "bust/Laurana50k.ply"),
                         [](const auto& scan) { return testName(scan.param); });

} // namespace
} // namespace pcl::ccaa::test
