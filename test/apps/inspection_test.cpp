// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: layers of an inspection, from surveys made by hand.
#include <gtest/gtest.h>

#include "app_runner.h"
#include "inspect/inspection.h"
#include "io/output_folder.h"
#include "io/point_columns.h"
#include "model_samples.h"

namespace app_test {
namespace {

using pcl::repair::BoundaryClass;
using pcl::repair::ForceLine;
using pcl::repair::LineEnd;
using pcl::repair::ModelSurvey;
using pcl::repair::Position;

/** A triangle whose rim is its only loop. */
ModelSurvey
triangleSurvey()
{
  ModelSurvey survey;
  survey.model.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 1}};
  survey.model.triangles = {{0, 1, 2}};
  survey.model.island_of = {{0}, 1};
  survey.model.islands.resize(1);
  survey.model.normals.assign(3, Eigen::Vector3d::UnitZ());
  survey.sides.resize(1);
  survey.loops.resize(1);
  survey.loops[0].island = 0;
  survey.loops[0].curve.points = survey.model.positions;
  survey.classes.resize(1);
  survey.spacing = 1.0;
  return survey;
}

ForceLine
straightLine(LineEnd end, double quality)
{
  ForceLine line;
  line.end = end;
  line.quality = quality;
  line.length = 4.0;
  for (int k = 0; k <= 4; ++k) {
    line.points.emplace_back(k, 0, 0);
    line.normals.emplace_back(Eigen::Vector3d::UnitZ());
    line.tensions.push_back(quality);
  }
  return line;
}

TEST(Inspection, LoopsAreClosedLinesInTheColourOfTheirClass)
{
  ModelSurvey survey = triangleSurvey();
  survey.classes[0].boundary_class = BoundaryClass::HOLE;
  const app::InspectionLayer hole = app::showLoops(survey);
  ASSERT_EQ(1U, hole.lines.size());
  EXPECT_EQ((pcl::Indices{0, 1, 2, 0}), hole.lines[0].vertices);
  ASSERT_EQ(1U, hole.legend.size());
  EXPECT_EQ("hole (1)", hole.legend[0].meaning);
  survey.classes[0].boundary_class = BoundaryClass::ISLAND_RIM;
  const app::InspectionLayer rim = app::showLoops(survey);
  EXPECT_EQ(1, valueOf(rim.cloud, 0, "class"));
  EXPECT_NE(hole.legend[0].color, rim.legend[0].color);
}

TEST(Inspection, IslandsThatWereTurnedRoundAreDarker)
{
  ModelSurvey survey = triangleSurvey();
  const auto kept = app::showIslands(survey).legend.at(0);
  survey.sides[0].flipped = true;
  const auto flipped = app::showIslands(survey).legend.at(0);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LT(flipped.color[i], kept.color[i]);
  EXPECT_NE(std::string::npos, flipped.meaning.find("turned round"));
}

TEST(Inspection, OnlyBridgesGiveLinePoints)
{
  ModelSurvey survey = triangleSurvey();
  survey.between_islands.lines = {straightLine(LineEnd::TOO_LONG, 1.0),
                                  straightLine(LineEnd::BRIDGE, 2.0)};
  EXPECT_EQ(2U, app::showLines(survey).lines.size());
  const app::InspectionLayer points = app::showLinePoints(survey);
  EXPECT_EQ(5U, app::pointCount(points.cloud));
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(2, valueOf(points.cloud, i, "curvature"));
    EXPECT_EQ(1, valueOf(points.cloud, i, "line"));
    EXPECT_EQ(1, valueOf(points.cloud, i, "normal_z"));
  }
}

TEST(Inspection, LinesWithoutLengthAreLeftOut)
{
  ModelSurvey survey = triangleSurvey();
  ForceLine point;
  point.end = LineEnd::REPELLED;
  point.points = {Position::Zero()};
  survey.between_islands.lines = {point, ForceLine()};
  EXPECT_EQ(0U, app::showLines(survey).lines.size());
  EXPECT_EQ(0U, app::pointCount(app::showLineNormals(survey).cloud));
}

TEST(Inspection, TheSectionIsWhereThePlaneCutsTheTriangles)
{
  pcl::repair::FieldSlice slice;
  slice.corner = Position(0, 0, 0.5); // the plane z = 0.5
  const app::InspectionLayer section = app::showSection(triangleSurvey(), slice);
  ASSERT_EQ(2U, app::pointCount(section.cloud));
  EXPECT_EQ(1U, section.lines.size());
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_FLOAT_EQ(0.5F, static_cast<float>(valueOf(section.cloud, i, "z")));
    EXPECT_FLOAT_EQ(0.5F, static_cast<float>(valueOf(section.cloud, i, "y")));
  }
}

TEST(Inspection, TheSliceIsWhiteWhereThereIsNoTension)
{
  pcl::repair::FieldSlice slice;
  slice.columns = 2;
  slice.rows = 2;
  slice.tension = {0.0, 1.0, 2.0, 0.0};
  const app::InspectionLayer layer = app::showSlice(slice);
  ASSERT_EQ(1U, layer.faces.size());
  EXPECT_EQ((pcl::Indices{0, 1, 3, 2}), layer.faces[0].vertices);
  EXPECT_EQ(2, valueOf(layer.cloud, 2, "tension"));
  std::size_t offset = 0;
  ASSERT_TRUE(app::findColour(layer.cloud, offset));
  EXPECT_EQ(255, app::pointAt(layer.cloud, 0)[offset]);
  EXPECT_GT(255, app::pointAt(layer.cloud, 2)[offset]);
}

TEST(OutputFolder, LeavesNeitherFilesNorFolderWithoutCommit)
{
  const TemporaryFolder place;
  {
    app::OutputFolder folder;
    ASSERT_TRUE(folder.open(place.path("out")).ok());
    folder.add("a.txt").text("half");
    EXPECT_TRUE(folder.status().ok());
  }
  EXPECT_TRUE(place.names().empty());
}

TEST(OutputFolder, FilesAppearTogetherWithCommit)
{
  const TemporaryFolder place;
  app::OutputFolder folder;
  ASSERT_TRUE(folder.open(place.path("out")).ok());
  folder.add("a.txt").text("a");
  folder.addElsewhere(place.path("b.txt")).text("b");
  EXPECT_EQ(std::string(), readFile(place.path("b.txt")));
  ASSERT_TRUE(folder.commit().ok());
  EXPECT_EQ("a", readFile(place.path("out/a.txt")));
  EXPECT_EQ("b", readFile(place.path("b.txt")));
}

TEST(OutputFolder, KeepsAFolderThatWasThere)
{
  const TemporaryFolder place;
  std::filesystem::create_directory(place.path("out"));
  {
    app::OutputFolder folder;
    ASSERT_TRUE(folder.open(place.path("out")).ok());
    folder.add("a.txt").text("half");
  }
  EXPECT_EQ(std::vector<std::string>{"out"}, place.names());
}

TEST(OutputFolder, RefusesAFileInPlaceOfAFolder)
{
  const TemporaryFolder place;
  writeFile(place.path("file"), "x");
  EXPECT_FALSE(app::OutputFolder::check(place.path("file")).ok());
  EXPECT_FALSE(app::OutputFolder::check(place.path("missing/out")).ok());
  EXPECT_TRUE(app::OutputFolder::check(place.path("out")).ok());
  EXPECT_TRUE(app::OutputFolder::check(place.path("out/")).ok());
}

} // namespace
} // namespace app_test
