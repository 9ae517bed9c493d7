// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: fuzz target, repair of a damaged mesh.
#include <pcl/console/print.h>
#include <pcl/surface_repair/force_line_hole_repair.h>

#include "damaged_mesh.h"
#include "mesh/cloud_access.h"
#include "mesh/intersection.h"
#include "requirement.h"
#include "support/mesh_asserts.h"

#include <algorithm>

namespace {

using pcl::ccaa::Triangles;
using namespace pcl::ccaa::test;
using fuzz::require;

constexpr double TRUSTS[] = {0.5, 0.0, 0.99, 0.8};
constexpr std::size_t LIMITS[] = {0, 0, 3, 20};

void
chooseParameters(fuzz::Bytes& bytes, pcl::ForceLineHoleRepair& repair)
{
  using pcl::repair::FillingChoice;
  repair.setMode(bytes.flag() ? pcl::repair::FieldMode::FULL
                              : pcl::repair::FieldMode::LIGHT);
  repair.setFillingMethod(static_cast<FillingChoice>(bytes.below(4)));
  repair.setJoinIslands(bytes.below(4) != 3);
  repair.setRefinement(bytes.below(4) != 3);
  repair.setFairing(bytes.below(4) != 3);
  repair.setTrust(TRUSTS[bytes.below(4)]);
  repair.setInterpolation(bytes.flag() ? 0.0 : 20.0);
  repair.setSimpleHoleEdges(LIMITS[bytes.below(4)]);
  repair.setGreatestHole(LIMITS[bytes.below(4)]);
}

std::size_t
countIntersections(const Triangles& triangles, const pcl::PCLPointCloud2& cloud)
{
  pcl::ccaa::RunControl control;
  return pcl::ccaa::findSelfIntersections(
             triangles, pcl::ccaa::positionView(cloud), 1, control)
      .pairs.size();
}

/** The points of the input come first in the output, byte for byte. */
bool
startsWith(const pcl::PCLPointCloud2& whole, const pcl::PCLPointCloud2& start)
{
  return whole.point_step == start.point_step &&
         whole.data.size() >= start.data.size() &&
         std::equal(start.data.begin(), start.data.end(), whole.data.begin());
}

void
checkResult(const pcl::PolygonMesh& input,
            const pcl::PolygonMesh& output,
            const pcl::RepairReport& report)
{
  const Triangles before = toTriangles(input.polygons);
  const Triangles after = toTriangles(output.polygons);
  const auto vertices = std::size_t{output.cloud.width} * output.cloud.height;
  require(isIcadm(after, vertices), "the result is an incomplete correct model");
  const pcl::repair::ReadingReport& reading = report.reading;
  const bool one_sided =
      std::any_of(report.islands.begin(), report.islands.end(), [](const auto& island) {
        return island.one_sided;
      });
  if (!one_sided)
    require(isConsistentlyWound(after), "neighbours are wound alike");
  require(startsWith(output.cloud, input.cloud), "the points of the input stay");
  require(report.origins.size() == after.size(), "each triangle has an origin");
  if (reading.twist_triangles + reading.repeated_triangles + reading.invalid_polygons >
      0)
    return;
  require(report.input_triangles == before.size() && after.size() >= before.size(),
          "the triangles of the input are as many as they were");
  if (reading.separated_fans == 0) // else some have a copy of their point
    require(isSubsetOf(before, after), "the triangles of the input stay");
  require(countIntersections(after, output.cloud) <=
              countIntersections(before, input.cloud),
          "no intersections are added");
}

} // namespace

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  fuzz::Bytes bytes(data, size);
  pcl::ForceLineHoleRepair repair;
  chooseParameters(bytes, repair);
  const auto input =
      pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(fuzz::damagedMesh(bytes)));
  repair.setInputMesh(input);
  repair.setNumberOfThreads(1);
  pcl::PolygonMesh output;
  repair.process(output);
  if (!output.polygons.empty())
    checkResult(*input, output, repair.getReport());
  return 0;
}
