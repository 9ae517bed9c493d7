// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: fuzz target, cloud to surface.
#include <pcl/console/print.h>
#include <pcl/surface_ccaa/consecutive_reconstruction.h>

#include "damaged_mesh.h"
#include "requirement.h"
#include "support/clouds.h"
#include "support/mesh_asserts.h"

#include <cmath>
#include <cstring>

namespace {

using pcl::ccaa::Positions;
using pcl::ccaa::Triangles;
using namespace pcl::ccaa::test;
using fuzz::require;

/** More points say nothing new and take long. */
constexpr std::size_t MOST_POINTS = 300;

/** A float of any bits. */
double
rawFloat(fuzz::Bytes& bytes)
{
  std::uint8_t word[sizeof(float)];
  for (std::uint8_t& part : word)
    part = bytes.byte();
  float value = 0.0F;
  std::memcpy(&value, word, sizeof(value));
  return static_cast<double>(value);
}

/** Floats as the bytes are, or places on a coarse grid. */
Positions
loosePoints(fuzz::Bytes& bytes)
{
  const bool raw = bytes.flag();
  Positions points;
  while (!bytes.empty() && points.size() < MOST_POINTS) {
    pcl::ccaa::Position point;
    for (double& coordinate : point)
      coordinate = raw ? rawFloat(bytes) : bytes.coarse();
    points.push_back(point);
  }
  return points;
}

/** Every point, every second or every third. */
pcl::Indices
everyNth(std::size_t step, std::size_t points)
{
  pcl::Indices indices;
  for (std::size_t i = 0; i < points; i += step)
    indices.push_back(static_cast<pcl::index_t>(i));
  return indices;
}

} // namespace

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  fuzz::Bytes bytes(data, size);
  const std::size_t step = bytes.below(4);
  const Positions points =
      bytes.flag() ? loosePoints(bytes) : fuzz::damagedMesh(bytes).vertices;
  const auto cloud = toCloud(points);

  pcl::ConsecutiveReconstruction<pcl::PointXYZ> reconstruction;
  reconstruction.setInputCloud(cloud);
  if (step > 0)
    reconstruction.setIndices(
        pcl::make_shared<pcl::Indices>(everyNth(step, points.size())));
  reconstruction.setNumberOfThreads(1);
  std::vector<pcl::Vertices> polygons;
  reconstruction.reconstruct(polygons);
  const Triangles triangles = toTriangles(polygons);
  require(isIcadm(triangles, points.size()), "the result is a correct surface");
  require(isConsistentlyWound(triangles), "neighbours are wound alike");
  for (const auto& triangle : triangles)
    for (const pcl::index_t corner : triangle)
      require((*cloud)[static_cast<std::size_t>(corner)].getVector3fMap().allFinite(),
              "corners are finite");
  return 0;
}
