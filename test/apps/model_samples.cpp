// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: small clouds and meshes with all kinds of fields, for
// tests.
#include "model_samples.h"

#include <gtest/gtest.h>

#include "io/cloud_assembler.h"
#include "io/model_io.h"
#include "io/point_columns.h"
#include "support/clouds.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace app_test {

namespace test = pcl::ccaa::test;
using Field = pcl::PCLPointField;

namespace {

pcl::PCLPointCloud2
withFields(const pcl::ccaa::Positions& points)
{
  std::vector<float> positions;
  app::FieldArray colour{"rgb", Field::FLOAT32, 1, {}};
  app::FieldArray normal{"normal", Field::FLOAT32, 3, {}};
  app::FieldArray intensity{"intensity", Field::FLOAT32, 1, {}};
  app::FieldArray label{"label", Field::INT32, 1, {}};
  unsigned number = 0;
  for (const pcl::ccaa::Position& point : points) {
    for (int axis = 0; axis < 3; ++axis) {
      positions.push_back(static_cast<float>(point[axis]));
      normal.append(static_cast<float>(point[axis] / point.norm()));
    }
    app::appendColour(colour, number % 256, 7 * number % 256, 255 - number % 256);
    intensity.append(0.1F * static_cast<float>(number));
    label.append(static_cast<std::int32_t>(1000003 * (number % 2000)));
    ++number;
  }
  pcl::PCLPointCloud2 cloud;
  app::assembleCloud(positions, {colour, normal, intensity, label}, cloud);
  return cloud;
}

void
commit(app::OutputFile& file)
{
  const app::Status status = file.commit();
  ASSERT_TRUE(status.ok()) << status.message();
}

} // namespace

pcl::PolygonMesh
colouredSphere()
{
  const test::Shape shape = test::icosphere(2);
  pcl::PolygonMesh mesh;
  mesh.cloud = withFields(shape.vertices);
  mesh.polygons = test::toPolygons(shape.triangles);
  return mesh;
}

pcl::PCLPointCloud2
colouredCloud(std::size_t points, std::uint64_t seed)
{
  return withFields(test::bumpySphere(points, seed));
}

pcl::PolygonMesh
helix()
{
  test::Shape points;
  for (int i = 0; i < 500; ++i)
    points.vertices.emplace_back(std::cos(0.04 * i), std::sin(0.04 * i), 0.006 * i);
  return test::toPolygonMesh(points);
}

pcl::PolygonMesh
spheresThatTouch(std::size_t count, double gap)
{
  const test::Shape sphere{test::fibonacciSphere(count), {}};
  return test::toPolygonMesh(
      test::joined(sphere, test::translated(sphere, {2.0 + gap, 0.0, 0.0})));
}

double
valueOf(const pcl::PCLPointCloud2& cloud, std::size_t point, const std::string& field)
{
  const Field* const found = app::findField(cloud, field);
  if (!found)
    return std::numeric_limits<double>::quiet_NaN();
  return app::loadScalarAs<double>(
      app::pointAt(cloud, point) + found->offset, found->datatype, false);
}

void
expectSameField(const pcl::PCLPointCloud2& expected,
                const pcl::PCLPointCloud2& actual,
                const std::string& field)
{
  const Field* const first = app::findField(expected, field);
  const Field* const second = app::findField(actual, field);
  ASSERT_TRUE(first && second) << field;
  ASSERT_EQ(app::scalarSize(first->datatype), app::scalarSize(second->datatype))
      << field;
  ASSERT_EQ(app::pointCount(expected), app::pointCount(actual));
  const std::size_t bytes = app::scalarSize(first->datatype);
  for (std::size_t i = 0; i < app::pointCount(expected); ++i)
    ASSERT_EQ(0,
              std::memcmp(app::pointAt(expected, i) + first->offset,
                          app::pointAt(actual, i) + second->offset,
                          bytes))
        << field << " of point " << i;
}

void
expectSamePolygons(const pcl::PolygonMesh& expected, const pcl::PolygonMesh& actual)
{
  ASSERT_EQ(expected.polygons.size(), actual.polygons.size());
  for (std::size_t i = 0; i < expected.polygons.size(); ++i)
    ASSERT_EQ(expected.polygons[i].vertices, actual.polygons[i].vertices) << i;
}

void
save(const std::string& path, const pcl::PolygonMesh& mesh)
{
  app::OutputFile file;
  app::Warnings warnings;
  const app::Status status = file.open(path);
  ASSERT_TRUE(status.ok()) << status.message();
  app::writeMesh(path, mesh, {}, file, warnings);
  commit(file);
}

void
save(const std::string& path, const pcl::PCLPointCloud2& cloud)
{
  app::OutputFile file;
  const app::Status status = file.open(path);
  ASSERT_TRUE(status.ok()) << status.message();
  app::writeCloud(path, cloud, {}, file);
  commit(file);
}

app::Model
loadMesh(const std::string& path)
{
  app::Model model;
  const app::Status status = app::readMesh(path, model);
  EXPECT_TRUE(status.ok()) << status.message();
  return model;
}

app::Model
loadCloud(const std::string& path)
{
  app::Model model;
  const app::Status status = app::readCloud(path, model);
  EXPECT_TRUE(status.ok()) << status.message();
  return model;
}

} // namespace app_test
