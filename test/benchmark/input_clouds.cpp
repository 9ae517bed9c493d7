// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: clouds for benchmarks, from files or made to order.
#include "input_clouds.h"

#include <pcl/common/point_tests.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/conversions.h>

#include "cloud_damage.h"
#include "support/single_view.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace bench {
namespace {

std::vector<std::string>
parts(const std::string& word)
{
  std::vector<std::string> all;
  std::istringstream stream(word);
  for (std::string part; std::getline(stream, part, ':');)
    all.push_back(part);
  return all;
}

bool
endsWith(const std::string& word, const std::string& end)
{
  return word.size() >= end.size() &&
         word.compare(word.size() - end.size(), end.size(), end) == 0;
}

Cloud::Ptr
readCloud(const std::string& file)
{
  Cloud all;
  const int status = endsWith(file, ".pcd") ? pcl::io::loadPCDFile(file, all)
                                            : pcl::io::loadPLYFile(file, all);
  if (status < 0)
    throw std::runtime_error("cannot read " + file);
  Cloud::Ptr finite(new Cloud);
  std::copy_if(all.begin(),
               all.end(),
               std::back_inserter(finite->points),
               [](const pcl::PointXYZ& p) { return pcl::isFinite(p); });
  finite->width = static_cast<std::uint32_t>(finite->points.size());
  finite->height = 1;
  return finite;
}

Cloud::Ptr
bumpySphere(std::size_t size)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  Cloud::Ptr cloud(new Cloud);
  cloud->reserve(size);
  for (std::size_t i = 0; i < size; ++i) {
    Eigen::Vector3d p(normal(random), normal(random), normal(random));
    p.normalize();
    p *= 1 + 0.05 * std::sin(9 * p.x()) * std::sin(8 * p.y() + 1);
    cloud->push_back({float(p.x()), float(p.y()), float(p.z())});
  }
  return cloud;
}

Cloud::Ptr
sampleMesh(const std::string& file, std::size_t size, double noise)
{
  pcl::PolygonMesh mesh;
  if (pcl::io::loadPLYFile(file, mesh) < 0 || mesh.polygons.empty())
    throw std::runtime_error("no triangles in " + file);
  Cloud vertices;
  pcl::fromPCLPointCloud2(mesh.cloud, vertices);
  const auto corner = [&](const pcl::Vertices& polygon, int c) -> Eigen::Vector3d {
    return vertices[polygon.vertices[static_cast<std::size_t>(c)]]
        .getVector3fMap()
        .cast<double>();
  };
  std::vector<double> area_up_to;
  double area = 0;
  for (const pcl::Vertices& t : mesh.polygons) {
    const Eigen::Vector3d a = corner(t, 0), b = corner(t, 1), c = corner(t, 2);
    area_up_to.push_back(area += 0.5 * (b - a).cross(c - a).norm());
  }
  const double deviation = noise * std::sqrt(area / double(size));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  Cloud::Ptr cloud(new Cloud);
  cloud->reserve(size);
  for (std::size_t i = 0; i < size; ++i) {
    const auto found = std::lower_bound(
        area_up_to.begin(), area_up_to.end() - 1, uniform(random) * area);
    const pcl::Vertices& t =
        mesh.polygons[static_cast<std::size_t>(found - area_up_to.begin())];
    const double s = std::sqrt(uniform(random)), r = uniform(random);
    Eigen::Vector3d p =
        (1 - s) * corner(t, 0) + s * (1 - r) * corner(t, 1) + s * r * corner(t, 2);
    p += deviation * Eigen::Vector3d(normal(random), normal(random), normal(random));
    cloud->push_back({float(p.x()), float(p.y()), float(p.z())});
  }
  return cloud;
}

/** A number of a word, which must lie between two others. */
double
numberIn(const std::string& text, double lowest, double highest)
{
  const double number = std::stod(text);
  if (!(number >= lowest && number <= highest))
    throw std::invalid_argument("out of range: " + text);
  return number;
}

/** The words that take a file and do something to its points; null for others. */
Cloud::Ptr
makeDamagedCloud(const std::vector<std::string>& part)
{
  const bool one_number = part.size() == 3;
  Cloud::Ptr cloud;
  if (one_number && part[0] == "noisy") {
    cloud = readCloud(part[1]);
    addNoise(*cloud, numberIn(part[2], 0, 100));
  }
  else if (part.size() == 4 && part[0] == "thinned") {
    cloud =
        std::make_shared<Cloud>(thinOut(*readCloud(part[1]), numberIn(part[2], 0, 1)));
    addNoise(*cloud, numberIn(part[3], 0, 100));
  }
  else if (one_number && part[0] == "outliers") {
    cloud = readCloud(part[1]);
    addOutliers(*cloud, numberIn(part[2], 0, 100));
  }
  else if (one_number && part[0] == "graded") {
    cloud = std::make_shared<Cloud>(
        gradeDensity(*readCloud(part[1]), numberIn(part[2], 1, 1e9)));
  }
  return cloud;
}

} // namespace

Cloud::Ptr
makeCloud(const std::string& word)
{
  const std::vector<std::string> part = parts(word);
  if (part.size() == 2 && part[0] == "bumpy")
    return bumpySphere(std::stoul(part[1]));
  if (part.size() == 2 && part[0] == "office")
    return cloudOf(pcl::ccaa::test::officeFrame(std::stoul(part[1])).points);
  if (part.size() == 2 && part[0] == "aerial")
    return cloudOf(pcl::ccaa::test::aerialView(std::stoul(part[1])).points);
  if (part.size() == 4 && part[0] == "sample")
    return sampleMesh(part[1], std::stoul(part[2]), std::stod(part[3]));
  const Cloud::Ptr damaged = makeDamagedCloud(part);
  return damaged ? damaged : readCloud(word);
}

Cloud::Ptr
cloudOf(const pcl::ccaa::Positions& points)
{
  const Cloud::Ptr cloud(new Cloud);
  for (const pcl::ccaa::Position& point : points)
    cloud->emplace_back(static_cast<float>(point.x()),
                        static_cast<float>(point.y()),
                        static_cast<float>(point.z()));
  return cloud;
}

std::string
referenceFile(const std::string& word)
{
  const std::vector<std::string> part = parts(word);
  for (const std::string& file : part)
    if (endsWith(file, ".ply"))
      return file;
  return "";
}

std::string
shortName(const std::string& word)
{
  std::string name;
  for (const std::string& part : parts(word))
    name += (name.empty() ? "" : ":") + part.substr(part.find_last_of('/') + 1);
  return name;
}

} // namespace bench
