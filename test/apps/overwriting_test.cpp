// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: scans are not written over by mistake.
#include "io/overwriting.h"
#include "io/remarks.h"
#include "repair_fixture.h"

namespace app_test {
namespace {

const char* const scan_points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

std::string
scanHeader(const std::string& comment = "")
{
  return "ply\nformat ascii 1.0\n" + comment +
         "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
}

/** \brief A file of another program, and whether it must stay. */
struct ForeignFile {
  const char* test;
  const char* name;
  std::string bytes;
  bool must_stay;
};

class Replaceable : public testing::TestWithParam<ForeignFile> {};

TEST_P(Replaceable, UnlessItHoldsPointsWithoutTriangles)
{
  const TemporaryFolder folder;
  writeFile(folder.path(GetParam().name), GetParam().bytes);
  EXPECT_NE(GetParam().must_stay,
            app::checkReplaceable(folder.path(GetParam().name)).ok());
}

INSTANTIATE_TEST_SUITE_P(
    Formats,
    Replaceable,
    testing::Values(
        ForeignFile{"Ply", "a.ply", scanHeader() + "end_header\n" + scan_points, true},
        ForeignFile{"PlyWithoutFaces",
                    "a.ply",
                    scanHeader() +
                        "element face 0\nproperty list uchar int "
                        "vertex_indices\nend_header\n" +
                        scan_points,
                    true},
        ForeignFile{"PlyWithFaces",
                    "a.ply",
                    scanHeader() +
                        "element face 1\nproperty list uchar int "
                        "vertex_indices\nend_header\n" +
                        scan_points + "3 0 1 2\n",
                    false},
        ForeignFile{"DamagedPly", "a.ply", "ply\nformat ascii 1.0\nelement", true},
        ForeignFile{"Pcd",
                    "a.pcd",
                    "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nDATA ascii\n0 0 0\n",
                    true},
        ForeignFile{"Xyz", "a.xyz", scan_points, true},
        ForeignFile{"TextOfAnyName", "a.asc", "//X Y Z\n1.5;2;3\n", true},
        ForeignFile{"TextWithHeading", "a.csv", "x,y,z\n1,2,3\n", true},
        ForeignFile{"CountedText", "a.pts", "1\n0 0 0\n", true},
        ForeignFile{"Las", "a.las", "LASF\0\0\0", true},
        ForeignFile{"Obj", "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", true},
        ForeignFile{
            "ObjWithFaces", "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", false},
        ForeignFile{"Off", "a.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", true},
        ForeignFile{"OffWithFaces",
                    "a.off",
                    "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                    false},
        ForeignFile{"Vtk",
                    "a.vtk",
                    "# vtk DataFile Version 3.0\nscan\nASCII\nDATASET POLYDATA\n"
                    "POINTS 1 float\n0 0 0\n",
                    true},
        ForeignFile{
            "Report", "a.json", "{\n  \"N\": 3,\n  \"list\": [1, 2, 3]\n}\n", false},
        ForeignFile{"ReportCalledText", "a.txt", "{\n  \"N\": 3\n}\n", false},
        ForeignFile{"Words", "a.txt", "one two three\n", false},
        ForeignFile{"Nothing", "a.ply", "", false}),
    [](const auto& test) { return test.param.test; });

/** What our own writers wrote, in one format. */
class OwnCloud : public testing::TestWithParam<std::string> {
protected:
  /** \return the first bytes of the file */
  std::string
  write(const std::string& name, const app::Remarks& remarks)
  {
    app::OutputFile file;
    app::Warnings warnings;
    EXPECT_TRUE(file.open(folder_.path(name)).ok());
    const app::Target target(folder_.path(name));
    pcl::PolygonMesh points;
    points.cloud = colouredCloud(9);
    if (app::isMeshOutput(target))
      app::writeMesh(target, points, {{}, {}, remarks}, file, warnings);
    else
      app::writeCloud(target, points.cloud, {{}, {}, remarks}, file);
    EXPECT_TRUE(file.commit().ok());
    return readFile(folder_.path(name)).substr(0, 400);
  }

  TemporaryFolder folder_;
};

TEST_P(OwnCloud, IsReplaceable)
{
  write("a" + GetParam(), {});
  EXPECT_TRUE(app::checkReplaceable(folder_.path("a" + GetParam())).ok());
}

TEST_P(OwnCloud, HasItsMarkOnceAfterRoundTrips)
{
  app::Remarks remarks;
  remarks.comments = {"units mm"};
  const std::string first = write("a" + GetParam(), remarks);
  const std::string second =
      write("b" + GetParam(), loadCloud(folder_.path("a" + GetParam())).remarks);
  EXPECT_EQ(first, second);
  const std::string mark(app::our_mark);
  const std::size_t place = second.find(mark);
  ASSERT_NE(std::string::npos, place) << second;
  EXPECT_EQ(std::string::npos, second.find(mark, place + 1)) << second;
}

INSTANTIATE_TEST_SUITE_P(
    Formats,
    OwnCloud,
    testing::Values(".ply", ".vtk", ".obj", ".off", ".pcd", ".xyz"),
    [](const auto& test) { return test.param.substr(1); });

/** \brief Three scans of another program, and what a command did to them. */
class Scans : public RepairApp {
protected:
  void
  SetUp() override
  {
    for (const char* name : {"a.ply", "b.ply", "c.ply"})
      writeFile(folder_.path(name), scanHeader() + "end_header\n" + scan_points);
    save(folder_.path("mesh.ply"), colouredSphere());
    before_ = readFile(folder_.path("c.ply"));
  }

  /** Run in the folder of the scans; the last one must still be there. */
  RunResult
  run(const std::string& command)
  {
    const RunResult result = runInShell("cd " + folder_.path("") + "; " + command);
    EXPECT_EQ(before_, readFile(folder_.path("c.ply")));
    return result;
  }

  std::string before_;
};

TEST_F(Scans, TheLastOfThoseToBeMergedIsNotTakenForTheOutput)
{
  for (const char* options : {"a.ply b.ply c.ply --merge",
                              "a.ply c.ply --merge",
                              "a.ply b.ply c.ply --merge --dry-run",
                              "a.ply b.ply c.ply",
                              "a.ply c.ply"}) {
    const RunResult result = run(std::string("pcl_ccaa_reconstruct ") + options);
    EXPECT_EQ(1, result.exit_code) << options;
    EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
  }
}

TEST_F(Scans, AreMergedIntoTheNamedOutput)
{
  const RunResult result =
      run("pcl_ccaa_reconstruct a.ply b.ply c.ply --merge -o out.ply");
  ASSERT_NE(1, result.exit_code) << result.errors;
  EXPECT_EQ(12U, app::pointCount(loadMesh(folder_.path("out.ply")).mesh.cloud));
}

TEST_F(Scans, AreNotReplacedByAnyOutput)
{
  for (const char* command :
       {"pcl_ccaa_reconstruct a.ply -o c.ply",
        "pcl_ccaa_reconstruct a.ply c.ply --dry-run",
        "pcl_ccaa_reconstruct a.ply out.ply --report c.ply",
        "pcl_ccaa_reconstruct a.ply --dry-run --report c.ply",
        "pcl_repair_holes mesh.ply c.ply",
        "pcl_repair_holes mesh.ply c.ply --dry-run",
        "pcl_repair_holes mesh.ply out.ply --bridges c.ply",
        "pcl_repair_holes mesh.ply out.ply --report c.ply",
        "pcl_damage_cloud a.ply c.ply --patches 1",
        "pcl_damage_cloud a.ply out.ply --patches 1 --removed c.ply",
        "pcl_damage_cloud a.ply out.ply --patches 1 --free-points c.ply",
        "pcl_mesh_quality mesh.ply --report c.ply",
        "pcl_render_mesh mesh.ply out.png --report c.ply"}) {
    const RunResult result = run(command);
    EXPECT_EQ(1, result.exit_code) << command;
    EXPECT_NE(std::string::npos, result.errors.find("--force")) << result.errors;
    EXPECT_FALSE(std::filesystem::exists(folder_.path("out.ply"))) << command;
  }
}

TEST_F(Scans, InAFolderOfOutputsAreNotReplaced)
{
  for (const char* command :
       {"mkdir -p in; cp a.ply in/c.ply; pcl_ccaa_reconstruct in/c.ply "
        "--output-folder .",
        "pcl_ccaa_reconstruct in/c.ply --output-folder . --dry-run",
        "cp c.ply loops.vtk; pcl_repair_holes mesh.ply --inspect . --no-pictures"}) {
    const RunResult result = run(command);
    EXPECT_EQ(1, result.exit_code) << command;
    EXPECT_NE(std::string::npos, result.errors.find("--force")) << result.errors;
  }
  EXPECT_EQ(before_, readFile(folder_.path("loops.vtk")));
}

TEST_F(Scans, AreReplacedByForce)
{
  EXPECT_NE(1, run("pcl_ccaa_reconstruct a.ply b.ply --force").exit_code);
  EXPECT_NE(before_, readFile(folder_.path("b.ply")));
}

TEST_F(Scans, OurOwnCloudsAreReplacedWithoutForce)
{
  const std::string damage = "pcl_damage_cloud mesh.ply out.ply --patches 1 --keep 0.5 "
                             "--removed removed.pcd --free-points free.xyz";
  EXPECT_EQ(0, run(damage).exit_code);
  EXPECT_EQ(0, run(damage).exit_code);
}

} // namespace
} // namespace app_test
