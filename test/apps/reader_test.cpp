// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the readers make of the variants of each format.
#include <gtest/gtest.h>

#include "app_runner.h"
#include "io/model_io.h"
#include "io/point_columns.h"
#include "model_samples.h"

#include <algorithm>
#include <cstring>

namespace app_test {
namespace {

/** Writes \a bytes to a file and reads it as a cloud. */
app::Model
cloudFrom(const std::string& name, const std::string& bytes)
{
  const TemporaryFolder folder;
  writeFile(folder.path(name), bytes);
  return loadCloud(folder.path(name));
}

app::Model
meshFrom(const std::string& name, const std::string& bytes)
{
  const TemporaryFolder folder;
  writeFile(folder.path(name), bytes);
  return loadMesh(folder.path(name));
}

template <typename T>
std::string
bigEndian(T value)
{
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

TEST(PlyReader, ReadsBigEndianWithExtraPropertiesAndQuads)
{
  std::string bytes = "ply\nformat binary_big_endian 1.0\ncomment made by hand\n"
                      "element vertex 4\nproperty uchar quality\nproperty float x\n"
                      "property float y\nproperty double z\nproperty short level\n"
                      "element face 1\nproperty list uchar uint vertex_index\n"
                      "property float area\nend_header\n";
  for (int i = 0; i < 4; ++i) {
    bytes += static_cast<char>(i);
    bytes += bigEndian(0.5F + static_cast<float>(i)) + bigEndian(-1.0F);
    bytes += bigEndian(2.25) + bigEndian(static_cast<std::int16_t>(-300 - i));
  }
  bytes += '\4';
  for (std::uint32_t i = 0; i < 4; ++i)
    bytes += bigEndian(i);
  bytes += bigEndian(1.5F);
  const app::Model model = meshFrom("a.ply", bytes);
  ASSERT_EQ(4U, app::pointCount(model.mesh.cloud));
  EXPECT_EQ(3.5, valueOf(model.mesh.cloud, 3, "x"));
  EXPECT_EQ(2.25, valueOf(model.mesh.cloud, 3, "z"));
  EXPECT_EQ(3, valueOf(model.mesh.cloud, 3, "quality"));
  EXPECT_EQ(-303, valueOf(model.mesh.cloud, 3, "level"));
  ASSERT_EQ(1U, model.mesh.polygons.size());
  EXPECT_EQ((pcl::Indices{0, 1, 2, 3}), model.mesh.polygons[0].vertices);
  EXPECT_EQ(1U, model.warnings.size()); // the area of the face
}

TEST(PlyReader, ReadsAsciiWithWindowsLineEndsAndElementsBetween)
{
  const app::Model model = meshFrom(
      "a.ply",
      "ply\r\nformat ascii 1.0\r\nobj_info none\r\nelement range_grid 2\r\n"
      "property list uchar int vertex_indices\r\nelement vertex 3\r\n"
      "property float x\r\nproperty float y\r\nproperty float z\r\n"
      "property uchar red\r\nproperty uchar green\r\nproperty uchar blue\r\n"
      "element face 1\r\nproperty list uchar int vertex_indices\r\nend_header\r\n"
      "1 0\r\n0\r\n0 0 0 255 128 1\r\n1 0 0 0 0 0\r\n0 1 0 9 8 7\r\n3 0 1 2\r\n");
  ASSERT_EQ(1U, model.mesh.polygons.size());
  std::size_t colour = 0;
  ASSERT_TRUE(app::findColour(model.mesh.cloud, colour));
  EXPECT_EQ(255, app::pointAt(model.mesh.cloud, 0)[colour + 2]);
  EXPECT_EQ(128, app::pointAt(model.mesh.cloud, 0)[colour + 1]);
  EXPECT_EQ(7, app::pointAt(model.mesh.cloud, 2)[colour]);
}

TEST(PlyReader, TurnsStripsIntoTrianglesOfOneSide)
{
  const app::Model model =
      meshFrom("a.ply",
               "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
               "property float y\nproperty float z\nelement tristrips 1\n"
               "property list int int vertex_indices\nend_header\n"
               "0 0 0\n1 0 0\n0 1 0\n1 1 0\n8 0 1 2 3 -1 0 2 1\n");
  ASSERT_EQ(3U, model.mesh.polygons.size());
  EXPECT_EQ((pcl::Indices{0, 1, 2}), model.mesh.polygons[0].vertices);
  EXPECT_EQ((pcl::Indices{2, 1, 3}), model.mesh.polygons[1].vertices);
  EXPECT_EQ((pcl::Indices{0, 2, 1}), model.mesh.polygons[2].vertices);
}

TEST(PlyReader, TakesOnlyThePointsOfAMeshForACloud)
{
  // The face would be out of range, but nobody asked for faces.
  const app::Model model =
      cloudFrom("a.ply",
                "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                "property float y\nproperty float z\nelement face 1\n"
                "property list uchar int vertex_indices\nend_header\n1 2 3\n3 7 8 9\n");
  EXPECT_EQ(1U, app::pointCount(model.mesh.cloud));
  EXPECT_TRUE(model.mesh.polygons.empty());
}

TEST(PlyReader, ShiftsWhereSinglePrecisionWouldLoseTheShape)
{
  std::string bytes = "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\n"
                      "property double y\nproperty double z\nend_header\n";
  const char* const corners[] = {"0 0 0\n", "0.1 0 0\n", "0 0.1 0\n", "0.1 0.1 0\n"};
  std::string near = bytes;
  for (const char* corner : corners) {
    near += corner;
    bytes += "5994678" + std::string(corner);
  }
  EXPECT_TRUE(cloudFrom("near.ply", near).shift.isNone());
  const app::Model far = cloudFrom("far.ply", bytes);
  EXPECT_EQ(Eigen::Vector3d(59946780.0625, 0.0625, 0), far.shift.offset());
  EXPECT_TRUE(far.warnings.empty());
}

TEST(PcdReader, KeepsOrganisedSizeViewpointAndPaddedFields)
{
  const app::Model model =
      cloudFrom("a.pcd",
                "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z _ t\nSIZE 8 8 8 1 8\n"
                "TYPE F F F U U\nCOUNT 1 1 1 2 1\nWIDTH 2\nHEIGHT 3\n"
                "VIEWPOINT 1 2 3 0 1 0 0\nPOINTS 6\nDATA ascii\n"
                "0.5 0 0 1 1 18446744073709551615\n1 0 0 1 1 2\n2 0 0 1 1 3\n"
                "nan nan nan 0 0 4\n4 0 0 0 0 5\n5 0 0 0 0 6\n");
  EXPECT_EQ(2U, model.mesh.cloud.width);
  EXPECT_EQ(3U, model.mesh.cloud.height);
  EXPECT_FALSE(model.mesh.cloud.is_dense);
  ASSERT_EQ(4U, model.mesh.cloud.fields.size());
  EXPECT_EQ(0.5, valueOf(model.mesh.cloud, 0, "x"));
  const auto* const time = app::findField(model.mesh.cloud, "t");
  ASSERT_TRUE(time);
  const auto exact = app::loadScalar<std::uint64_t>(
      app::pointAt(model.mesh.cloud, 0) + time->offset, false);
  EXPECT_EQ(18446744073709551615U, exact);
  EXPECT_TRUE(model.viewpoint.known);
  EXPECT_EQ(Eigen::Vector3d(1, 2, 3), model.viewpoint.position);
}

TEST(XyzReader, ReadsSpacesCommasAndComments)
{
  const app::Model model = cloudFrom(
      "a.xyz", "# made by hand\n1 2 3\n\n4,5,6\r\n  7;8;9\n// the end\n+1e1\t-2.5 .5");
  ASSERT_EQ(4U, app::pointCount(model.mesh.cloud));
  EXPECT_EQ(9, valueOf(model.mesh.cloud, 2, "z"));
  EXPECT_EQ(10, valueOf(model.mesh.cloud, 3, "x"));
}

TEST(XyzReader, TellsColoursFromNormals)
{
  const app::Model colours = cloudFrom("a.xyz", "0 0 0 255 0 9\n1 0 0 3 4 5\n");
  std::size_t offset = 0;
  ASSERT_TRUE(app::findColour(colours.mesh.cloud, offset));
  EXPECT_EQ(9, app::pointAt(colours.mesh.cloud, 0)[offset]);
  const app::Model normals = cloudFrom("a.xyz", "0 0 0 0 0 1\n1 0 0 0 0.6 0.8\n");
  EXPECT_TRUE(app::findNormal(normals.mesh.cloud, offset));
}

TEST(XyzReader, ReadsPtsWithCountAndIntensity)
{
  const app::Model model =
      cloudFrom("a.pts", "2\n0 0 0 -1203 255 128 0\n1 0 0 17 1 2 3\n");
  ASSERT_EQ(2U, app::pointCount(model.mesh.cloud));
  EXPECT_EQ(-1203, valueOf(model.mesh.cloud, 0, "intensity"));
  std::size_t offset = 0;
  EXPECT_TRUE(app::findColour(model.mesh.cloud, offset));
}

TEST(XyzReader, NamesFieldsByTheHeading)
{
  const app::Model model = cloudFrom(
      "a.csv", "\"X\",\"Y\",\"Z\",GpsTime,class\n1,2,3,1234567890.123456,4\n");
  EXPECT_DOUBLE_EQ(1234567890.123456, valueOf(model.mesh.cloud, 0, "GpsTime"));
  EXPECT_EQ(4, valueOf(model.mesh.cloud, 0, "class"));
}

TEST(ObjReader, ReadsNegativeIndicesNormalsAndQuads)
{
  const app::Model model =
      meshFrom("a.obj",
               "mtllib none.mtl\no thing\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
               "vn 0 0 1\nvt 0 0\nusemtl stone\nf 1/1/1 2/1/1 -2//-1 4//1\n");
  ASSERT_EQ(1U, model.mesh.polygons.size());
  EXPECT_EQ((pcl::Indices{0, 1, 2, 3}), model.mesh.polygons[0].vertices);
  EXPECT_EQ(1, valueOf(model.mesh.cloud, 3, "normal_z"));
}

TEST(OffReader, ReadsCommentsAndColours)
{
  const app::Model model =
      meshFrom("a.off",
               "COFF # with colours\n# a comment\n3 1 0\n0 0 0 255 0 7 255\n"
               "1 0 0 1 2 3 255\n0 1 0 0 0 0 255\n3 0 1 2 200 200 200\n");
  ASSERT_EQ(1U, model.mesh.polygons.size());
  std::size_t offset = 0;
  ASSERT_TRUE(app::findColour(model.mesh.cloud, offset));
  EXPECT_EQ(7, app::pointAt(model.mesh.cloud, 0)[offset]);
}

TEST(StlReader, MergesEqualCornersOfAsciiFiles)
{
  const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                            "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
  const app::Model model = meshFrom("a.stl",
                                    "solid vertex box\n" + facet +
                                        "facet normal 0 0 1\nouter loop\nvertex 1 0 0\n"
                                        "vertex 1 1 0\nvertex -0.0 1 0\nendloop\n"
                                        "endfacet\nendsolid vertex box\n");
  EXPECT_EQ(2U, model.mesh.polygons.size());
  EXPECT_EQ(4U, app::pointCount(model.mesh.cloud));
}

TEST(VtkReader, ReadsOffsetsOfVtk9)
{
  const app::Model model = meshFrom(
      "a.vtk",
      "# vtk DataFile Version 5.1\nvtk output\nASCII\nDATASET POLYDATA\n"
      "POINTS 4 float\n0 0 0 1 0 0 1 1 0\n0 1 0\n\nMETADATA\nINFORMATION 0\n\n"
      "POLYGONS 3 6\nOFFSETS vtktypeint64\n0 3 6\nCONNECTIVITY vtktypeint64\n"
      "0 1 2 0 2 3\nCELL_DATA 2\nSCALARS origin int\nLOOKUP_TABLE default\n7 8\n"
      "POINT_DATA 4\nSCALARS height double 1\nLOOKUP_TABLE default\n1 2 3 4\n"
      "FIELD FieldData 1\nlabel 1 4 int\n5 6 7 8\n");
  ASSERT_EQ(2U, model.mesh.polygons.size());
  EXPECT_EQ((pcl::Indices{0, 2, 3}), model.mesh.polygons[1].vertices);
  EXPECT_EQ(4, valueOf(model.mesh.cloud, 3, "height"));
  EXPECT_EQ(8, valueOf(model.mesh.cloud, 3, "label"));
}

} // namespace
} // namespace app_test
