// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: files whose bytes are in memory, and formats told by bytes.
#include <gtest/gtest.h>

#include "app_runner.h"
#include "io/model_io.h"
#include "io/point_columns.h"
#include "model_samples.h"

namespace app_test {
namespace {

using app::FileFormat;

/** Format of the file that \a name tells our writers to write. */
FileFormat
writtenAndTold(const std::string& name)
{
  const TemporaryFolder folder;
  if (name == "a.pcd" || name == "a.xyz")
    save(folder.path(name), colouredCloud(30));
  else
    save(folder.path(name), colouredSphere());
  return app::formatOfBytes(readFile(folder.path(name)));
}

TEST(FormatOfBytes, KnowsWhatWeWrite)
{
  for (const char* name : {"a.ply", "a.pcd", "a.vtk", "a.obj", "a.stl"})
    EXPECT_EQ(app::formatOfPath(name), writtenAndTold(name)) << name;
}

TEST(FormatOfBytes, KnowsUsualBeginnings)
{
  EXPECT_EQ(FileFormat::PCD, app::formatOfBytes("VERSION .7\nFIELDS x y z\n"));
  EXPECT_EQ(FileFormat::OFF, app::formatOfBytes("# made by hand\nOFF\n3 1 0\n"));
  EXPECT_EQ(FileFormat::OBJ, app::formatOfBytes("\xEF\xBB\xBF# x\r\n\r\nv 0 0 0\n"));
  EXPECT_EQ(FileFormat::STL, app::formatOfBytes("solid box\nfacet normal 0 0 1\n"));
  EXPECT_EQ(FileFormat::XYZ, app::formatOfBytes("# x y z\n0.5,1,2\n"));
  EXPECT_EQ(FileFormat::UNKNOWN, app::formatOfBytes("Dear reader,\n"));
  EXPECT_EQ(FileFormat::UNKNOWN, app::formatOfBytes(""));
}

TEST(ParseFromMemory, GivesWhatTheFileGives)
{
  const TemporaryFolder folder;
  const pcl::PolygonMesh mesh = colouredSphere();
  save(folder.path("a.ply"), mesh);
  const std::string bytes = readFile(folder.path("a.ply"));
  app::Model model;
  const auto status =
      app::parseMesh(FileFormat::PLY, bytes.data(), bytes.size(), model);
  ASSERT_TRUE(status.ok()) << status.message();
  expectSamePolygons(mesh, model.mesh);
  expectSameField(mesh.cloud, model.mesh.cloud, "label");
}

TEST(ParseFromMemory, RefusesNothingAndGarbage)
{
  for (const std::string bytes : {"", "x", "ply\n"}) {
    app::Model model;
    EXPECT_FALSE(
        app::parseMesh(FileFormat::PLY, bytes.data(), bytes.size(), model).ok());
    EXPECT_FALSE(
        app::parseCloud(FileFormat::PCD, bytes.data(), bytes.size(), model).ok());
  }
}

TEST(ParseFromMemory, StepsOverAByteOrderMark)
{
  const std::string bytes = "\xEF\xBB\xBFOFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  app::Model model;
  EXPECT_TRUE(app::parseMesh(FileFormat::OFF, bytes.data(), bytes.size(), model).ok());
  EXPECT_EQ(1U, model.mesh.polygons.size());
}

} // namespace
} // namespace app_test
