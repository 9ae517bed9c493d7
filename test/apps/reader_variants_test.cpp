// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: files as other programs write them, one oddity each.
#include <gtest/gtest.h>

#include "app_runner.h"
#include "io/model_io.h"
#include "io/point_columns.h"
#include "model_samples.h"

#include <cmath>
#include <string>

namespace app_test {
namespace {

using app::FileFormat;

/** \a bytes read as a mesh; fails the test when they cannot be read. */
app::Model
meshOf(FileFormat format, const std::string& bytes)
{
  app::Model model;
  const auto status = app::parseMesh(format, bytes.data(), bytes.size(), model);
  EXPECT_TRUE(status.ok()) << status.message();
  return model;
}

app::Model
cloudOf(FileFormat format, const std::string& bytes)
{
  app::Model model;
  const auto status = app::parseCloud(format, bytes.data(), bytes.size(), model);
  EXPECT_TRUE(status.ok()) << status.message();
  return model;
}

/** Whether the mesh is the one triangle 0 1 2 over three points at (0 0 0), (1 0 0)
 * and (0 1 0). */
void
expectTriangle(const app::Model& model)
{
  ASSERT_EQ(3U, app::pointCount(model.mesh.cloud));
  EXPECT_EQ(1, valueOf(model.mesh.cloud, 1, "x"));
  EXPECT_EQ(1, valueOf(model.mesh.cloud, 2, "y"));
  ASSERT_EQ(1U, model.mesh.polygons.size());
  EXPECT_EQ((pcl::Indices{0, 1, 2}), model.mesh.polygons[0].vertices);
}

/** The three numbers of the packed colour of a point. */
std::vector<int>
colourOf(const app::Model& model, std::size_t point)
{
  std::size_t offset = 0;
  if (!app::findColour(model.mesh.cloud, offset))
    return {};
  const std::uint8_t* const bytes = app::pointAt(model.mesh.cloud, point) + offset;
  return {bytes[2], bytes[1], bytes[0]};
}

/** A variant of the same triangle. */
struct Variant {
  const char* name;
  FileFormat format;
  std::string bytes;
};

class TriangleVariant : public testing::TestWithParam<Variant> {};

TEST_P(TriangleVariant, IsRead)
{
  expectTriangle(meshOf(GetParam().format, GetParam().bytes));
}

const std::string ply_points = "element vertex 3\nproperty float x\nproperty float y\n"
                               "property float z\n";

INSTANTIATE_TEST_SUITE_P(
    Formats,
    TriangleVariant,
    testing::Values(
        Variant{"PlyFacesBeforeVertices",
                FileFormat::PLY,
                "ply\nformat ascii 1.0\nelement face 1\n"
                "property list uchar int vertex_indices\n" +
                    ply_points + "end_header\n3 0 1 2\n0 0 0\n1 0 0\n0 1 0\n"},
        Variant{"PlyListsAtVertices",
                FileFormat::PLY,
                "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                "property list uchar int neighbours\nproperty float y\n"
                "property float z\nelement face 1\n"
                "property list uchar int vertex_indices\nend_header\n"
                "0 2 1 2 0 0\n1 0 0 0\n0 1 7 1 0\n3 0 1 2\n"},
        Variant{"PlyRowsOverSeveralLines",
                FileFormat::PLY,
                "ply\nformat ascii 1.0\n" + ply_points +
                    "element face 1\nproperty list uchar int vertex_indices\n"
                    "end_header\n0 0\n0 1 0 0 0\n1\n0 3 0\n1 2\n"},
        Variant{"PlyOldMacLineEnds",
                FileFormat::PLY,
                "ply\rformat ascii 1.0\relement vertex 3\rproperty float x\r"
                "property float y\rproperty float z\relement face 1\r"
                "property list uchar int vertex_indices\rend_header\r"
                "0 0 0\r1 0 0\r0 1 0\r3 0 1 2\r"},
        Variant{"ObjContinuedLine",
                FileFormat::OBJ,
                "v 0 0 0\nv 1 0 \\\n0\nv 0 1 0\nf 1 \\\r\n  2 \\\r\n 3\n"},
        Variant{"ObjCommentBehindNumbers",
                FileFormat::OBJ,
                "v 0 0 0 # origin\nv 1 0 0\nv 0 1 0\nf 1 2 3 # the face\n"},
        Variant{"ObjByteOrderMark",
                FileFormat::OBJ,
                "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
        Variant{"ObjFacesBeforeVerticesInGroups",
                FileFormat::OBJ,
                "g \xC3\xA4\nf 1/7/9 2/8/9 3/9/9\ns off\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"},
        Variant{"OffCountsBehindTheKeyword",
                FileFormat::OFF,
                "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
        Variant{"OffCountsStuckToTheKeyword",
                FileFormat::OFF,
                "OFF3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
        Variant{"OffWithoutAKeyword",
                FileFormat::OFF,
                "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
        Variant{"OffWithTexture",
                FileFormat::OFF,
                "STOFF\n3 1 0\n0 0 0 .1 .2\n1 0 0 0 0\n0 1 0 1 1\n3 0 1 2\n"},
        Variant{"StlInCapitals",
                FileFormat::STL,
                "  SOLID A\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\n"
                "VERTEX 1 0 0\nVERTEX 0 1 0\nENDLOOP\nENDFACET\nENDSOLID A\n"},
        Variant{"VtkInSmallLetters",
                FileFormat::VTK,
                "# vtk DataFile Version 2.0\nx\nascii\ndataset polydata\n"
                "points 3 float\n0 0 0 1 0 0 0 1 0\npolygons 1 4\n3 0 1 2\n"},
        Variant{"VtkUnstructuredGrid",
                FileFormat::VTK,
                "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                "POINTS 3 double\n0 0 0 1 0 0 0 1 0\nCELLS 3 11\n2 0 1\n3 0 1 2\n"
                "3 0 1 2\nCELL_TYPES 3\n3\n5\n22\n"},
        Variant{"VtkUnstructuredGridOfVtk9",
                FileFormat::VTK,
                "# vtk DataFile Version 5.1\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                "POINTS 3 float\n0 0 0 1 0 0 0 1 0\nCELLS 2 3\n"
                "OFFSETS vtktypeint64\n0 3\nCONNECTIVITY vtktypeint64\n0 1 2\n"
                "CELL_TYPES 1\n5\n"}),
    [](const auto& test) { return test.param.name; });

TEST(PlyVariants, BinaryListsAtVerticesAreSteppedOver)
{
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\n"
      "property list uchar short neighbours\nproperty float x\nproperty double y\n"
      "property float z\nend_header\n";
  const auto append = [&](auto value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  for (int i = 0; i < 3; ++i) {
    append(static_cast<std::uint8_t>(i));
    for (int k = 0; k < i; ++k)
      append(std::int16_t{-1});
    append(static_cast<float>(i));
    append(0.5 * i);
    append(7.0F);
  }
  const app::Model model = cloudOf(FileFormat::PLY, bytes);
  EXPECT_EQ(2, valueOf(model.mesh.cloud, 2, "x"));
  EXPECT_EQ(1, valueOf(model.mesh.cloud, 2, "y"));
  EXPECT_EQ(7, valueOf(model.mesh.cloud, 0, "z"));
  EXPECT_EQ(1U, model.warnings.size());
}

TEST(PlyVariants, DiffuseColoursAreColours)
{
  const app::Model model = cloudOf(
      FileFormat::PLY,
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nproperty uchar diffuse_red\nproperty uchar diffuse_green\n"
      "property uchar diffuse_blue\nend_header\n1 2 3 255 128 7\n");
  EXPECT_EQ((std::vector<int>{255, 128, 7}), colourOf(model, 0));
}

TEST(PlyVariants, TwoVertexElementsAreRefused)
{
  const std::string bytes = "ply\nformat ascii 1.0\nelement vertex 1\n"
                            "property float x\nproperty float y\nproperty float z\n"
                            "element vertex 1\nproperty float x\nproperty float y\n"
                            "property float z\nend_header\n1 2 3\n4 5 6\n";
  app::Model model;
  EXPECT_FALSE(
      app::parseCloud(FileFormat::PLY, bytes.data(), bytes.size(), model).ok());
}

TEST(PcdVariants, OldFilesWithoutWidth)
{
  const app::Model model =
      cloudOf(FileFormat::PCD,
              "# .PCD v.5\nVERSION .5\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n"
              "POINTS 2\nDATA ascii\n1 2 3\n4 5 6\n");
  EXPECT_EQ(2U, model.mesh.cloud.width);
  EXPECT_EQ(1U, model.mesh.cloud.height);
}

TEST(PcdVariants, WindowsLineEndsBeforeBinaryData)
{
  std::string bytes = "# .PCD v0.7\r\nFIELDS x y z\r\nSIZE 4 4 4\r\nTYPE F F F\r\n"
                      "WIDTH 1\r\nHEIGHT 1\r\nPOINTS 1\r\nDATA binary\r\n";
  for (const float value : {1.0F, 2.0F, 3.0F})
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  EXPECT_EQ(3, valueOf(cloudOf(FileFormat::PCD, bytes).mesh.cloud, 0, "z"));
}

TEST(PcdVariants, MoreNumbersThanFieldsAreToldOf)
{
  const app::Model model =
      cloudOf(FileFormat::PCD,
              "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\n"
              "DATA ascii\n1 2 3 99\n4 5 6 99\n");
  EXPECT_EQ(1U, model.warnings.size());
}

TEST(PcdVariants, AllSpellingsOfNoNumberAreRead)
{
  const app::Model model =
      cloudOf(FileFormat::PCD,
              "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 3\nHEIGHT 1\n"
              "DATA ascii\nnan NaN -nan(ind)\n1.#QNAN -1.#IND inf\n-Infinity "
              "1.#INF 1e999\n");
  for (std::size_t point = 0; point < 3; ++point)
    for (const char* axis : {"x", "y", "z"})
      EXPECT_FALSE(std::isfinite(valueOf(model.mesh.cloud, point, axis)))
          << point << axis;
}

TEST(ObjVariants, ColoursMayBeBytes)
{
  const app::Model bytes =
      meshOf(FileFormat::OBJ, "v 0 0 0 255 0 1\nv 1 0 0 0 0 0\nv 0 1 0 7 8 9\n");
  EXPECT_EQ((std::vector<int>{255, 0, 1}), colourOf(bytes, 0));
  const app::Model shares =
      meshOf(FileFormat::OBJ, "v 0 0 0 1 0 0.5\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\n");
  EXPECT_EQ((std::vector<int>{255, 0, 128}), colourOf(shares, 0));
}

TEST(ObjVariants, ColoursOfSomeVerticesAreToldOf)
{
  const app::Model model =
      meshOf(FileFormat::OBJ, "v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_TRUE(colourOf(model, 0).empty());
  EXPECT_EQ(1U, model.warnings.size());
}

TEST(OffVariants, NormalsAndColoursTogether)
{
  const app::Model model =
      meshOf(FileFormat::OFF,
             "CNOFF\n3 1 0\n0 0 0 0 0 1 .5 0 1 1\n1 0 0 0 0 1 0 0 0 1\n"
             "0 1 0 0 0 1 0 0 0 1\n3 0 1 2\n");
  EXPECT_EQ(1, valueOf(model.mesh.cloud, 2, "normal_z"));
  EXPECT_EQ((std::vector<int>{128, 0, 255}), colourOf(model, 0));
}

TEST(StlVariants, BinaryThatBeginsWithSolidAndHasATail)
{
  const TemporaryFolder folder;
  save(folder.path("a.stl"), colouredSphere());
  std::string bytes = readFile(folder.path("a.stl"));
  bytes.replace(0, 5, "solid");
  EXPECT_EQ(320U, meshOf(FileFormat::STL, bytes).mesh.polygons.size());
  EXPECT_EQ(
      320U,
      meshOf(FileFormat::STL, bytes + std::string(16, '\0')).mesh.polygons.size());
}

TEST(StlVariants, SeveralSolidsBecomeOneMesh)
{
  const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                            "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
  const std::string solid = "solid a b\n" + facet + "endsolid a b\n";
  const app::Model model = meshOf(FileFormat::STL, solid + solid);
  EXPECT_EQ(2U, model.mesh.polygons.size());
  EXPECT_EQ(3U, app::pointCount(model.mesh.cloud));
}

TEST(VtkVariants, CellsThatAreNoSurfaceAreToldOf)
{
  const app::Model model =
      meshOf(FileFormat::VTK,
             "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
             "POINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\nCELLS 3 15\n4 0 1 2 3\n"
             "4 0 1 2 3\n4 0 1 2 3\nCELL_TYPES 3\n10\n8\n6\n");
  ASSERT_EQ(3U, model.mesh.polygons.size()); // one rectangle, two of the strip
  EXPECT_EQ((pcl::Indices{0, 1, 3, 2}), model.mesh.polygons[0].vertices);
  EXPECT_EQ(1U, model.warnings.size());
}

TEST(VtkVariants, CellsWithoutTypesAreRefused)
{
  const std::string bytes =
      "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
      "POINTS 3 float\n0 0 0 1 0 0 0 1 0\nCELLS 1 4\n3 0 1 2\n";
  app::Model model;
  EXPECT_FALSE(app::parseMesh(FileFormat::VTK, bytes.data(), bytes.size(), model).ok());
}

TEST(VtkVariants, AnArrayWithTheNameOfPaddingIsLeftOut)
{
  const app::Model model =
      meshOf(FileFormat::VTK,
             "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n"
             "POINTS 1 float\n1 2 3\nPOINT_DATA 1\nFIELD f 1\n_ 4 1 double\n"
             "7 7 7 7\n");
  EXPECT_EQ(1, valueOf(model.mesh.cloud, 0, "x"));
  EXPECT_EQ(3U, model.mesh.cloud.fields.size());
}

TEST(OffVariants, NoPointsAtAllAreAnEmptyMesh)
{
  EXPECT_EQ(0U, app::pointCount(meshOf(FileFormat::OFF, "OFF\n0 0 0\n").mesh.cloud));
}

TEST(VtkVariants, LinesAreToldOf)
{
  const app::Model model =
      meshOf(FileFormat::VTK,
             "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n"
             "POINTS 2 float\n0 0 0 1 0 0\nLINES 1 3\n2 0 1\n");
  EXPECT_EQ(1U, model.warnings.size());
}

} // namespace
} // namespace app_test
