// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: units and viewpoints go from the input to the output.
#include <pcl/io/ply_io.h>

#include "io/model_io.h"
#include "io/remarks.h"
#include "repair_fixture.h"

namespace app_test {
namespace {

/** A tetrahedron without one side; \a remarks are lines of the header. */
std::string
openTetrahedron(const std::string& remarks)
{
  return "ply\nformat ascii 1.0\n" + remarks +
         "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 3\nproperty list uchar int vertex_indices\nend_header\n"
         "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n";
}

const char* const cloud_seen_from_afar =
    "# .PCD v0.7\n# units: mm\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n"
    "WIDTH 2\nHEIGHT 3\nVIEWPOINT 1 2 -3 0.5 0.5 -0.5 0.5\nPOINTS 6\nDATA ascii\n"
    "0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n";

std::string
unitsNamed(const std::string& comment)
{
  app::Remarks remarks;
  app::addComment(comment, remarks.comments);
  return app::namedUnits(remarks);
}

TEST(Units, AreKnownInUsualWords)
{
  EXPECT_EQ("mm", unitsNamed("units mm"));
  EXPECT_EQ("mm", unitsNamed("Unit: mm"));
  EXPECT_EQ("inch", unitsNamed("length_units=inch"));
  EXPECT_EQ("metres", unitsNamed("all units are metres"));
  EXPECT_EQ("", unitsNamed("a unit sphere"));
  EXPECT_EQ("", unitsNamed("in unity"));
  EXPECT_EQ("", unitsNamed("units"));
}

TEST_F(RepairApp, KeepsCommentsOfPlyAndTellsUnits)
{
  writeFile(folder_.path("in.ply"),
            openTetrahedron("comment units mm\nobj_info scanner 7\ncomment by hand\n"));
  const RunResult result = runApp(
      "pcl_repair_holes",
      {folder_.path("in.ply"), folder_.path("out.ply"), "--report", "-", "--quiet"});
  ASSERT_EQ(0, result.exit_code) << result.errors;
  EXPECT_EQ("mm", nlohmann::json::parse(result.output).at("units"));
  const auto header = readFile(folder_.path("out.ply")).substr(0, 200);
  for (const char* line : {"\ncomment units mm\n",
                           "\nobj_info scanner 7\n",
                           "\ncomment by hand\n",
                           "\ncomment PclSurfaceRepair\n"})
    EXPECT_NE(std::string::npos, header.find(line)) << header;
}

TEST(Remarks, OurOwnMarkDoesNotPileUp)
{
  const TemporaryFolder folder;
  save(folder.path("a.ply"), colouredSphere());
  EXPECT_TRUE(loadMesh(folder.path("a.ply")).remarks.comments.empty());
}

/** Writes remarks in one format and reads them back. */
class RemarksRoundTrip : public testing::TestWithParam<std::string> {};

TEST_P(RemarksRoundTrip, KeepsUnits)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("a" + GetParam());
  app::Remarks remarks;
  remarks.comments = {"units mm"};
  app::OutputFile file;
  app::Warnings warnings;
  ASSERT_TRUE(file.open(path).ok());
  if (GetParam() == ".pcd" || GetParam() == ".xyz")
    app::writeCloud(path, colouredCloud(9), {{}, {}, remarks}, file);
  else
    app::writeMesh(path, colouredSphere(), {{}, {}, remarks}, file, warnings);
  ASSERT_TRUE(file.commit().ok());
  EXPECT_EQ("mm", app::namedUnits(loadCloud(path).remarks));
}

INSTANTIATE_TEST_SUITE_P(
    Formats,
    RemarksRoundTrip,
    testing::Values(".ply", ".vtk", ".obj", ".off", ".pcd", ".xyz"),
    [](const auto& test) { return test.param.substr(1); });

/** A cloud with a viewpoint, written to the file \a name. */
std::string
damagedCopy(const TemporaryFolder& folder, const std::string& name)
{
  writeFile(folder.path("in.pcd"), cloud_seen_from_afar);
  // Nothing lies in the sphere: the copy is the input, and the exit code 2.
  EXPECT_EQ(2,
            runApp("pcl_damage_cloud",
                   {folder.path("in.pcd"),
                    folder.path(name),
                    "--absolute",
                    "--sphere",
                    "9,9,9,0.1"})
                .exit_code);
  return folder.path(name);
}

TEST(Viewpoint, GoesFromPcdToPcdAndPly)
{
  const TemporaryFolder folder;
  for (const char* name : {"out.pcd", "out.ply"}) {
    const app::Model model = loadCloud(damagedCopy(folder, name));
    EXPECT_TRUE(model.viewpoint.known) << name;
    EXPECT_EQ(Eigen::Vector3d(1, 2, -3), model.viewpoint.position) << name;
    EXPECT_TRUE(model.viewpoint.orientation.isApprox(
        Eigen::Quaternionf(0.5F, 0.5F, -0.5F, 0.5F), 1e-6F))
        << name;
    EXPECT_EQ(3U, model.mesh.cloud.height) << name;
  }
}

TEST(Viewpoint, InPlyIsReadAsPclWritesIt)
{
  const TemporaryFolder folder;
  const Eigen::Quaternionf orientation(0.5F, 0.5F, -0.5F, 0.5F);
  pcl::PLYWriter().writeBinary(folder.path("a.ply"),
                               colouredCloud(6),
                               Eigen::Vector4f(1, 2, -3, 0),
                               orientation,
                               true);
  const app::Model model = loadCloud(folder.path("a.ply"));
  EXPECT_TRUE(model.viewpoint.known);
  EXPECT_EQ(Eigen::Vector3d(1, 2, -3), model.viewpoint.position);
  EXPECT_TRUE(model.viewpoint.orientation.isApprox(orientation, 1e-6F));
}

TEST(Viewpoint, DoesNotKeepPclFromReadingTheMeshBehindIt)
{
  const TemporaryFolder folder;
  const pcl::PolygonMesh mesh = colouredSphere();
  app::FileExtras extras;
  extras.viewpoint.position = Eigen::Vector3d(1, 2, 3);
  app::OutputFile file;
  app::Warnings warnings;
  const std::string path = folder.path("a.ply");
  ASSERT_TRUE(file.open(path).ok());
  app::writeMesh(path, mesh, extras, file, warnings);
  ASSERT_TRUE(file.commit().ok());
  pcl::PolygonMesh read;
  ASSERT_EQ(0, pcl::io::loadPLYFile(path, read));
  expectSamePolygons(mesh, read);
  expectSameField(mesh.cloud, read.cloud, "z");
}

TEST(Viewpoint, BehindTheVerticesIsReadForACloudToo)
{
  const TemporaryFolder folder;
  writeFile(folder.path("a.ply"),
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
            "property float y\nproperty float z\nelement camera 1\n"
            "property float view_px\nproperty float view_py\nproperty float view_pz\n"
            "end_header\n1 2 3\n7 8 9\n");
  const app::Model model = loadCloud(folder.path("a.ply"));
  EXPECT_TRUE(model.viewpoint.known);
  EXPECT_EQ(Eigen::Vector3d(7, 8, 9), model.viewpoint.position);
}

TEST(Title, OfVtkStays)
{
  const TemporaryFolder folder;
  writeFile(folder.path("a.vtk"),
            "# vtk DataFile Version 3.0\nhip joint, mm\nASCII\nDATASET POLYDATA\n"
            "POINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n");
  EXPECT_EQ("hip joint, mm", loadMesh(folder.path("a.vtk")).remarks.title);
}

} // namespace
} // namespace app_test
