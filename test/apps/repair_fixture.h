// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: running pcl_repair_holes in tests.
#pragma once

#include <gtest/gtest.h>

#include "app_runner.h"
#include "model_samples.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace app_test {

namespace test = pcl::ccaa::test;

/** \brief Files go to a folder of the test; inspections to the folder "found" in it. */
class RepairApp : public testing::Test {
protected:
  RunResult
  inspect(const std::string& input, const std::vector<std::string>& options = {})
  {
    return runApp("pcl_repair_holes",
                  {folder_.path(input), "--inspect", folder_.path("found")},
                  options);
  }

  /** Without pictures, which take longest. */
  RunResult
  inspectQuickly(const std::string& input, std::vector<std::string> options = {})
  {
    options.emplace_back("--no-pictures");
    return inspect(input, options);
  }

  /** Names of the files of an inspection, sorted. */
  std::vector<std::string>
  found() const
  {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path("found")))
      names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }

  std::string
  foundFile(const std::string& name) const
  {
    return folder_.path("found/" + name);
  }

  nlohmann::json
  report() const
  {
    return nlohmann::json::parse(readFile(folder_.path("report.json")));
  }

  TemporaryFolder folder_;
};

/** \brief A sphere cut into two caps by a belt without triangles, whose vertices stay
 * as free points: two islands, each with a rim. */
inline pcl::PolygonMesh
twoCaps()
{
  const test::Shape sphere = test::icosphere(4);
  std::vector<std::size_t> belt;
  for (std::size_t t = 0; t < sphere.triangles.size(); ++t) {
    double height = 0.0;
    for (const pcl::index_t corner : sphere.triangles[t])
      height += sphere.vertices[static_cast<std::size_t>(corner)].z() / 3.0;
    if (std::abs(height) < 0.35)
      belt.push_back(t);
  }
  return test::toPolygonMesh(test::withoutTriangles(sphere, belt));
}

} // namespace app_test
