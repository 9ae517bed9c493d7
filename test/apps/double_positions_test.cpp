// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: positions in double precision in each format.
#include <gtest/gtest.h>

#include "app_runner.h"
#include "io/model_io.h"
#include "io/point_columns.h"
#include "mesh/cloud_access.h"
#include "model_samples.h"
#include "support/clouds.h"

#include <cstdlib>

namespace app_test {
namespace {

namespace test = pcl::ccaa::test;
using pcl::ccaa::Position;
using pcl::ccaa::Positions;

class DoubleRoundTrip : public testing::TestWithParam<std::string> {
protected:
  Positions
  comeBack(const Positions& positions)
  {
    const std::string path = folder_.path("cloud" + GetParam());
    pcl::PolygonMesh mesh;
    mesh.cloud = test::toDoubleCloud(positions);
    if (app::isCloudOutput(app::Target(path)))
      save(path, mesh.cloud);
    else
      save(path, mesh);
    const app::Model model = loadCloud(path);
    EXPECT_TRUE(app::hasDoublePositions(model.mesh.cloud));
    return pcl::ccaa::copyPositions(pcl::ccaa::positionView(model.mesh.cloud))
        .positions;
  }

  TemporaryFolder folder_;
};

TEST_P(DoubleRoundTrip, KeepsMapCoordinatesBitForBit)
{
  const Positions positions = test::shifted(
      test::bumpySphere(200), Position(596648.123456, 5420315.654, 251.5));
  EXPECT_EQ(positions, comeBack(positions));
}

TEST_P(DoubleRoundTrip, KeepsSmallDoublesBitForBit)
{
  const Positions positions = test::bumpySphere(200);
  EXPECT_EQ(positions, comeBack(positions));
}

INSTANTIATE_TEST_SUITE_P(
    Formats,
    DoubleRoundTrip,
    testing::Values(".ply", ".pcd", ".xyz", ".obj", ".off", ".vtk"),
    [](const auto& tested) { return tested.param.substr(1); });

/** A text format with three points; the first one's x is to be put in. */
struct TextFormat {
  std::string ending;
  std::string before;
  std::string after;
};

class DecimalText : public testing::TestWithParam<TextFormat> {
protected:
  app::Model
  withNumber(const std::string& number)
  {
    const std::string path = folder_.path("text" + GetParam().ending);
    writeFile(path, GetParam().before + number + GetParam().after);
    return loadCloud(path);
  }

  TemporaryFolder folder_;
};

TEST_P(DecimalText, WithManyDigitsBecomesTheNearestDouble)
{
  for (const char* number : {"596648.12", "5420315.654321", "-0.1234567891234"})
    EXPECT_EQ(std::strtod(number, nullptr),
              valueOf(withNumber(number).mesh.cloud, 0, "x"));
}

TEST_P(DecimalText, WithFewDigitsBecomesAFloat)
{
  for (const char* number : {"0.1", "12.3456", "596648.125", "1e-7", "7.00000000000"})
    EXPECT_FALSE(app::hasDoublePositions(withNumber(number).mesh.cloud)) << number;
}

TEST_P(DecimalText, WithTheDigitsOfAFloatBecomesThatFloat)
{
  for (const char* number : {"12.3456793", "1234.567871", "0.100000001"})
    EXPECT_FALSE(app::hasDoublePositions(withNumber(number).mesh.cloud)) << number;
}

INSTANTIATE_TEST_SUITE_P(
    Formats,
    DecimalText,
    testing::Values(
        TextFormat{".xyz", "", " 2 3\n4 5 6\n7 8 9\n"},
        TextFormat{".obj", "v ", " 2 3\nv 4 5 6\nv 7 8 9\n"},
        TextFormat{".off", "OFF\n3 0 0\n", " 2 3\n4 5 6\n7 8 9\n"},
        TextFormat{".ply",
                   "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                   "property float y\nproperty float z\nend_header\n",
                   " 2 3\n4 5 6\n7 8 9\n"},
        TextFormat{".pcd",
                   "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 3\nDATA ascii\n",
                   " 2 3\n4 5 6\n7 8 9\n"},
        TextFormat{".vtk",
                   "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\n"
                   "POINTS 3 float\n",
                   " 2 3\n4 5 6\n7 8 9\n"}),
    [](const auto& tested) { return tested.param.ending.substr(1); });

} // namespace
} // namespace app_test
