// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: fuzz target, the umbrella filter on any polygons.
#include <pcl/console/print.h>
#include <pcl/surface_ccaa/umbrella_filter.h>

#include "damaged_mesh.h"
#include "requirement.h"
#include "support/mesh_asserts.h"

namespace {

using pcl::ccaa::Triangles;
using namespace pcl::ccaa::test;
using fuzz::require;

/** Corners that no point belongs to, and polygons that are no triangles. */
void
addWrongPolygons(fuzz::Bytes& bytes, pcl::PolygonMesh& mesh)
{
  for (std::size_t i = bytes.below(4); i > 0; --i) {
    pcl::Vertices polygon;
    for (std::size_t k = bytes.below(6); k > 0; --k)
      polygon.vertices.push_back(static_cast<pcl::index_t>(bytes.below(60)) - 2);
    mesh.polygons.push_back(std::move(polygon));
  }
}

} // namespace

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  fuzz::Bytes bytes(data, size);
  const auto input = pcl::make_shared<pcl::PolygonMesh>();
  pcl::PolygonMesh wrong;
  addWrongPolygons(bytes, wrong);
  *input = toPolygonMesh(fuzz::damagedMesh(bytes));
  const Triangles given = toTriangles(input->polygons);
  input->polygons.insert(
      input->polygons.end(), wrong.polygons.begin(), wrong.polygons.end());

  pcl::UmbrellaFilter filter;
  filter.setInputMesh(input);
  filter.setNumberOfThreads(1);
  pcl::PolygonMesh output;
  filter.process(output);
  const Triangles kept = toTriangles(output.polygons);
  require(isIcadm(kept, std::size_t{output.cloud.width} * output.cloud.height),
          "what is kept is an incomplete correct model");
  if (filter.getReport().one_sided_components == 0)
    require(isConsistentlyWound(kept), "neighbours are wound alike");
  require(sameCloud(input->cloud, output.cloud), "the cloud stays");
  if (wrong.polygons.empty())
    require(isSubsetOf(kept, given), "nothing is made up");
  return 0;
}
