// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: seeded point sets for tests and benchmarks.
#include "clouds.h"

#include <pcl/conversions.h>

#include "mesh/cloud_access.h"
#include "random_source.h"
#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace pcl::ccaa::test {

namespace {

/** \brief Place i of `count` on a spiral of evenly spread unit directions; fractional
 * places lie in between. */
Position
spiralDirection(double place, std::size_t count)
{
  const double z = 1.0 - 2.0 * (place + 0.5) / static_cast<double>(count);
  const double ring = std::sqrt(std::max(0.0, 1.0 - z * z));
  const double turn = M_PI * (3.0 - std::sqrt(5.0)) * place;
  return {ring * std::cos(turn), ring * std::sin(turn), z};
}

/** \brief A unit direction moved by at most `share` of the spacing of `count` points.
 */
Position
jittered(const Position& direction,
         std::size_t count,
         double share,
         RandomSource& random)
{
  const double reach = share * std::sqrt(4.0 * M_PI / static_cast<double>(count));
  const Position shift(random.uniform(-reach, reach),
                       random.uniform(-reach, reach),
                       random.uniform(-reach, reach));
  return (direction + shift).normalized();
}

/** \brief `rows` rows of points in the unit parameter square, each cell's point
 * jittered. */
template <typename Surface>
Positions
jitteredLattice(int columns, int rows, RandomSource& random, Surface surface)
{
  Positions points;
  points.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const double u = (x + 0.5 + random.uniform(-0.3, 0.3)) / columns;
      const double v = (y + 0.5 + random.uniform(-0.3, 0.3)) / rows;
      points.push_back(surface(u, v));
    }
  return points;
}

/** \brief Columns of a lattice of about `count` cells that are square on a strip
 * `ratio` times as wide as high. */
int
columnsFor(std::size_t count, double ratio)
{
  return std::max(3, static_cast<int>(std::sqrt(static_cast<double>(count) * ratio)));
}

} // namespace

Positions
fibonacciSphere(std::size_t count, double radius)
{
  Positions points(count);
  for (std::size_t i = 0; i < count; ++i)
    points[i] = radius * spiralDirection(static_cast<double>(i), count);
  return points;
}

Positions
noisySphere(std::size_t count, double deviation, std::uint64_t seed)
{
  RandomSource random(seed);
  Positions points = fibonacciSphere(count);
  for (Position& point : points)
    point *= 1.0 + deviation * random.normal();
  return points;
}

Positions
bumpySphere(std::size_t count, std::uint64_t seed)
{
  RandomSource random(seed);
  Positions points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Position u = spiralDirection(static_cast<double>(i), count);
    const Position direction = jittered(u, count, 0.3, random);
    const double bump = std::sin(7.0 * direction.x()) * std::sin(6.0 * direction.y()) +
                        0.5 * std::sin(11.0 * direction.z());
    points[i] = direction * (1.0 + 0.06 * bump);
  }
  random.shuffle(points);
  return points;
}

Positions
torusCloud(std::size_t count,
           double major_radius,
           double minor_radius,
           std::uint64_t seed)
{
  RandomSource random(seed);
  const int columns = columnsFor(count, major_radius / minor_radius);
  const int rows = std::max(3, static_cast<int>(count) / columns);
  return jitteredLattice(columns, rows, random, [&](double u, double v) {
    const double ring = major_radius + minor_radius * std::cos(2.0 * M_PI * v);
    return Position(ring * std::cos(2.0 * M_PI * u),
                    ring * std::sin(2.0 * M_PI * u),
                    minor_radius * std::sin(2.0 * M_PI * v));
  });
}

Positions
cubeCloud(int divisions)
{
  return cube(divisions).vertices;
}

Positions
thinPlateCloud(int columns, double thickness, std::uint64_t seed)
{
  RandomSource random(seed);
  Positions points;
  for (const double height : {0.0, thickness}) {
    const Positions sheet =
        jitteredLattice(columns, columns, random, [&](double u, double v) {
          return Position(u, v, height);
        });
    points.insert(points.end(), sheet.begin(), sheet.end());
  }
  return points;
}

Positions
terrainCloud(int columns, std::uint64_t seed)
{
  RandomSource random(seed);
  return jitteredLattice(columns, columns, random, [&](double u, double v) {
    const double x = u * columns, y = v * columns;
    return Position(x, y, 2.0 * std::sin(0.21 * x) * std::cos(0.17 * y));
  });
}

Positions
terrainLines(int lines, int points_a_line, double gap, std::uint64_t seed)
{
  RandomSource random(seed);
  Positions points;
  for (int line = 0; line < lines; ++line) {
    const double begin = random.uniform();
    for (int i = 0; i < points_a_line; ++i) {
      const double x = begin + i, y = gap * line;
      points.emplace_back(x, y, gap * std::sin(0.1 * x / gap) * std::cos(0.3 * line));
    }
  }
  return points;
}

Positions
sphereLines(std::size_t count, double gap)
{
  const double spacing = std::sqrt(4.0 * M_PI / (static_cast<double>(count) * gap));
  Positions points;
  const int lines = static_cast<int>(M_PI / (gap * spacing));
  for (int line = 0; line < lines; ++line) {
    const double polar = M_PI * (line + 0.5) / lines;
    const int around =
        std::max(3, static_cast<int>(2 * M_PI * std::sin(polar) / spacing));
    for (int i = 0; i < around; ++i) {
      const double azimuth = 2 * M_PI * (i + 0.37 * line) / around;
      points.emplace_back(std::sin(polar) * std::cos(azimuth),
                          std::sin(polar) * std::sin(azimuth),
                          std::cos(polar));
    }
  }
  return points;
}

Positions
cylinderCloud(std::size_t count, std::uint64_t seed)
{
  RandomSource random(seed);
  const int columns = columnsFor(count, M_PI);
  const int rows = std::max(3, static_cast<int>(count) / columns);
  return jitteredLattice(columns, rows, random, [&](double u, double v) {
    return Position(std::cos(2.0 * M_PI * u), std::sin(2.0 * M_PI * u), 2.0 * v);
  });
}

Positions
lineCloud(int count)
{
  Positions line;
  for (int i = 0; i < count; ++i)
    line.push_back({0.25 * i, 0.5 * i, 0.125 * i});
  return line;
}

Positions
withNonFinite(Positions points, std::size_t count, std::uint64_t seed)
{
  RandomSource random(seed);
  std::vector<std::size_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  random.shuffle(order);
  for (std::size_t i = 0; i < std::min(count, order.size()); ++i) {
    Position& point = points[order[i]];
    if (i % 2 == 0)
      point.setConstant(std::numeric_limits<double>::quiet_NaN());
    else
      point.y() = std::numeric_limits<double>::infinity();
  }
  return points;
}

Positions
withDuplicates(const Positions& points, int copies)
{
  Positions all;
  for (int i = 0; i < copies; ++i)
    all.insert(all.end(), points.begin(), points.end());
  return all;
}

Positions
scaled(Positions points, double factor)
{
  for (Position& point : points)
    point *= factor;
  return points;
}

Positions
shifted(Positions points, const Position& shift)
{
  for (Position& point : points)
    point += shift;
  return points;
}

Positions
shuffled(Positions points, std::uint64_t seed)
{
  RandomSource(seed).shuffle(points);
  return points;
}

Positions
withNoise(Positions points, double deviation, std::uint64_t seed)
{
  RandomSource random(seed);
  for (Position& point : points)
    for (int k = 0; k < 3; ++k)
      point[k] += deviation * random.normal();
  return points;
}

pcl::PointCloud<pcl::PointXYZ>::Ptr
toCloud(const Positions& points)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  cloud->resize(points.size());
  cloud->is_dense = true;
  for (std::size_t i = 0; i < points.size(); ++i) {
    (*cloud)[i].getVector3fMap() = points[i].cast<float>();
    cloud->is_dense = cloud->is_dense && points[i].allFinite();
  }
  return cloud;
}

bool
sameBytes(const pcl::PointCloud<pcl::PointXYZ>& one,
          const pcl::PointCloud<pcl::PointXYZ>& other)
{
  return one.size() == other.size() && std::memcmp(one.points.data(),
                                                   other.points.data(),
                                                   one.size() * sizeof(PointXYZ)) == 0;
}

pcl::PCLPointCloud2
toRawCloud(const Positions& points)
{
  pcl::PCLPointCloud2 raw;
  pcl::toPCLPointCloud2(*toCloud(points), raw);
  return raw;
}

pcl::PCLPointCloud2
toDoubleCloud(const Positions& points)
{
  pcl::PCLPointCloud2 cloud;
  for (const char* name : {"x", "y", "z"}) {
    pcl::PCLPointField field;
    field.name = name;
    field.offset = cloud.point_step;
    field.datatype = pcl::PCLPointField::FLOAT64;
    field.count = 1;
    cloud.fields.push_back(field);
    cloud.point_step += sizeof(double);
  }
  cloud.height = 1;
  std::vector<NewVertex> vertices;
  for (const Position& point : points)
    vertices.push_back({point, {}});
  appendVertices(cloud, vertices);
  return cloud;
}

Positions
onGrid(Positions points)
{
  constexpr double steps = 65536.0;
  for (Position& point : points)
    point = (point * steps).array().round().matrix() / steps;
  return points;
}

} // namespace pcl::ccaa::test
