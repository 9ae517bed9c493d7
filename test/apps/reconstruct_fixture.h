// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: running pcl_ccaa_reconstruct in tests.
#pragma once

#include <gtest/gtest.h>

#include "app_runner.h"
#include "support/mesh_asserts.h"
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace app_test {

namespace test = pcl::ccaa::test;

/** \brief Files go to a folder of the test. */
class ReconstructApp : public testing::Test {
protected:
  RunResult
  reconstruct(const std::string& input,
              const std::string& output,
              const std::vector<std::string>& options = {})
  {
    return runApp(
        "pcl_ccaa_reconstruct", {folder_.path(input), folder_.path(output)}, options);
  }

  /** Done, with the message of what was not as the reason. */
  static testing::AssertionResult
  hasMeshed(const RunResult& result)
  {
    if (result.exit_code == 0)
      return testing::AssertionSuccess();
    return testing::AssertionFailure() << result.exit_code << ": " << result.errors;
  }

  nlohmann::json
  report()
  {
    return nlohmann::json::parse(readFile(folder_.path("report.json")));
  }

  TemporaryFolder folder_;
};

} // namespace app_test
