// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reconstructing tile by tile in tests.
#pragma once

#include "io/point_columns.h"
#include "mesh/mesh_facts.h"
#include "model_samples.h"
#include "reconstruct_fixture.h"
#include "support/clouds.h"
#include "support/raw_clouds.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace app_test {

/** \brief The points of a cloud from one to before another. */
inline pcl::PCLPointCloud2
partOf(const pcl::PCLPointCloud2& cloud, std::size_t begin, std::size_t end)
{
  pcl::PCLPointCloud2 part = cloud;
  const auto at = [&](std::size_t point) {
    return cloud.data.begin() + static_cast<std::ptrdiff_t>(point * cloud.point_step);
  };
  part.data.assign(at(begin), at(end));
  part.width = static_cast<pcl::uindex_t>(end - begin);
  part.height = 1;
  part.row_step = part.width * part.point_step;
  return part;
}

inline pcl::ccaa::Positions
positionsOf(const pcl::PCLPointCloud2& cloud)
{
  pcl::ccaa::Positions positions;
  for (std::size_t i = 0; i < app::pointCount(cloud); ++i)
    positions.emplace_back(
        valueOf(cloud, i, "x"), valueOf(cloud, i, "y"), valueOf(cloud, i, "z"));
  return positions;
}

/** \brief What every mesh has to be. */
inline pcl::ccaa::MeshFacts
expectSound(const pcl::PolygonMesh& mesh)
{
  const auto triangles = test::toTriangles(mesh.polygons);
  const auto positions = positionsOf(mesh.cloud);
  EXPECT_TRUE(test::isIcadm(triangles, positions.size()));
  EXPECT_TRUE(test::isConsistentlyWound(triangles));
  pcl::ccaa::RunControl control;
  const auto facts = pcl::ccaa::measureMesh(triangles, positions, {}, control);
  EXPECT_EQ(0U, *facts.self_intersections);
  return facts;
}

/** \brief Small tiles: 1000 points each, so that a few thousand points have several
 * cuts. */
class TiledApp : public ReconstructApp {
protected:
  using Files = std::map<std::string, std::string>;

  /** Names are those of files in the folder of the test. */
  RunResult
  tiled(const std::vector<std::string>& inputs,
        const std::string& output,
        const std::vector<std::string>& options = {})
  {
    std::vector<std::string> arguments{"--merge"};
    if (std::none_of(options.begin(), options.end(), [](const std::string& option) {
          return option.rfind("--tiles", 0) == 0;
        }))
      arguments.push_back("--tiles=1000");
    for (const std::string& input : inputs)
      arguments.push_back(folder_.path(input));
    if (!output.empty())
      arguments.insert(arguments.end(), {"-o", folder_.path(output)});
    arguments.insert(arguments.end(), options.begin(), options.end());
    return runApp("pcl_ccaa_reconstruct", arguments);
  }

  /** The same into a folder of tiles that stays. */
  template <typename Cloud>
  RunResult
  tiledOf(const Cloud& cloud, const std::vector<std::string>& options = {})
  {
    save(folder_.path("in.ply"), cloud);
    return tiled({"in.ply"}, "out.ply", options);
  }

  RunResult
  intoFolder(const std::vector<std::string>& inputs,
             const std::string& tiles,
             std::vector<std::string> options = {})
  {
    options.insert(options.end(), {"--tile-folder", folder_.path(tiles)});
    return tiled(inputs, "", options);
  }

  /** One step of pcl_ccaa_tiles. */
  RunResult
  step(const std::string& name,
       const std::string& tiles,
       const std::vector<std::string>& rest = {})
  {
    std::vector<std::string> arguments{name, folder_.path(tiles)};
    arguments.insert(arguments.end(), rest.begin(), rest.end());
    return runApp("pcl_ccaa_tiles", arguments);
  }

  /** All steps after the cut, the tiles from the last to the first. \param[in]
   * before_shards steps of a repair, of which 'repair' is for each tile */
  void
  doSteps(const std::string& tiles, const std::vector<std::string>& before_shards)
  {
    std::vector<std::string> names{
        "mesh", "join", "disputes", "close", "wind", "sides"};
    names.insert(names.end(), before_shards.begin(), before_shards.end());
    names.insert(names.end(), {"shard", "index"});
    const int count = std::stoi(step("count", tiles).output);
    ASSERT_GE(count, 4);
    for (const std::string& name : names) {
      if (name == "disputes" || name == "sides" || name == "holes" ||
          name == "numbers" || name == "index") {
        ASSERT_TRUE(hasMeshed(step(name, tiles))) << name;
        continue;
      }
      for (int tile = count - 1; tile >= 0; --tile)
        ASSERT_TRUE(hasMeshed(step(name, tiles, {std::to_string(tile)}))) << name;
    }
  }

  /** Shards and index of a folder of tiles. */
  Files
  shardsIn(const std::string& tiles)
  {
    Files shards;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path(tiles)))
      if (const std::string name = entry.path().filename().string();
          entry.path().extension() == ".ply" || name == "index.json")
        shards[name] = readFile(entry.path().string());
    return shards;
  }

  /** Names of files that are not whole. */
  std::vector<std::string>
  partsIn(const std::string& tiles)
  {
    std::vector<std::string> parts;
    if (std::filesystem::exists(folder_.path(tiles)))
      for (const auto& entry : std::filesystem::directory_iterator(folder_.path(tiles)))
        if (const std::string name = entry.path().filename().string();
            name.find(".part-") != std::string::npos)
          parts.push_back(name);
    return parts;
  }

  /** A clear error: one line, exit code 1, nothing at the output. */
  void
  expectRefused(const RunResult& result, const std::string& part_of_message)
  {
    EXPECT_EQ(1, result.exit_code) << result.output;
    EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
    EXPECT_NE(std::string::npos, result.errors.find(part_of_message)) << result.errors;
    EXPECT_FALSE(std::filesystem::exists(folder_.path("out.ply")));
    EXPECT_FALSE(std::filesystem::exists(folder_.path("out.ply.tiles")));
  }
};

} // namespace app_test
