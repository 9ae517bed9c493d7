// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: Ctrl-C at any moment leaves whole files or none.
#include "repair_fixture.h"
#include "support/random_source.h"

namespace app_test {
namespace {

/** Larger models, so that there is time to be interrupted in. */
class Interrupted : public RepairApp {
protected:
  void
  SetUp() override
  {
    const auto holed =
        test::toPolygonMesh(test::withoutTriangles(test::icosphere(6), {0, 1, 2, 3}));
    save(folder_.path("a.ply"), holed);
    save(folder_.path("b.ply"), holed);
    save(folder_.path("cloud.pcd"), colouredCloud(40000));
    before_ = folder_.names();
  }

  /** Every file that came has its own name and reads as a mesh of many triangles. */
  void
  expectWholeFiles(const std::filesystem::path& place)
  {
    for (const auto& entry : std::filesystem::directory_iterator(place)) {
      const std::string name = entry.path().filename().string();
      EXPECT_EQ(std::string::npos, name.find(".part-")) << name;
      if (entry.is_directory()) {
        expectWholeFiles(entry.path());
        continue;
      }
      if (entry.path().extension() == ".ply") {
        EXPECT_GT(loadMesh(entry.path().string()).mesh.polygons.size(), 50000U) << name;
      }
    }
  }

  void
  removeResults()
  {
    for (const std::string& name : folder_.names())
      if (!std::binary_search(before_.begin(), before_.end(), name))
        std::filesystem::remove_all(folder_.path(name));
  }

  /** Runs the program again and again, each time with SIGINT at another moment. */
  void
  interruptAtRandom(const std::string& program,
                    const std::vector<std::string>& arguments)
  {
    pcl::ccaa::test::RandomSource random(11);
    for (int round = 0; round < 5; ++round) {
      const int delay = static_cast<int>(5 + random.below(180));
      SCOPED_TRACE("after " + std::to_string(delay) + " ms");
      const RunResult result = runAndInterrupt(program, arguments, delay);
      // It was through before the signal, or -1: killed before it listened.
      EXPECT_TRUE(result.exit_code == 130 || result.exit_code == 0 ||
                  result.exit_code == -1)
          << result.exit_code << result.errors;
      if (result.exit_code == 130) {
        EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
      }
      expectWholeFiles(folder_.path("."));
      if (!result.output.empty()) {
        writeFile(folder_.path("streamed.ply"), result.output);
        expectWholeFiles(folder_.path("."));
      }
      removeResults();
    }
  }

  std::vector<std::string> before_;
};

TEST_F(Interrupted, ManyInputs)
{
  interruptAtRandom("pcl_repair_holes",
                    {folder_.path("a.ply"),
                     folder_.path("b.ply"),
                     "--output-folder",
                     folder_.path("out"),
                     "--report",
                     folder_.path("report.json"),
                     "--quiet"});
}

TEST_F(Interrupted, StandardOutput)
{
  interruptAtRandom("pcl_repair_holes", {folder_.path("a.ply"), "-", "--quiet"});
}

TEST_F(Interrupted, OneOutputAndItsReport)
{
  interruptAtRandom("pcl_ccaa_reconstruct",
                    {folder_.path("cloud.pcd"),
                     folder_.path("out.ply"),
                     "--report",
                     folder_.path("report.json"),
                     "--quiet"});
}

TEST_F(Interrupted, WhileStandardInputIsWaitedFor)
{
  // The first signal may come before the program listens.
  const std::string fifo = folder_.path("fifo");
  const std::string output = folder_.path("out.ply");
  const RunResult result = runInShell(
      "mkfifo " + fifo + "; exec 3<> " + fifo + "; pcl_repair_holes - " + output +
      " <&3 & sleep 0.1; while kill -INT $! 2> /dev/null; do sleep 0.4; done; wait $!");
  EXPECT_EQ(130, result.exit_code) << result.errors;
  EXPECT_FALSE(std::filesystem::exists(output));
}

} // namespace
} // namespace app_test
