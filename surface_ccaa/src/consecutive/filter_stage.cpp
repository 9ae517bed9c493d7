// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: running the filter of a chain.
#include "consecutive/filter_stage.h"

#include "consecutive/stage_polygons.h"

#include <utility>

namespace pcl {
namespace ccaa {
namespace {

/** \brief From the filter itself if it is ours and knows. */
std::vector<PointRole>
rolesAfter(const MeshProcessing* filter,
           const std::vector<pcl::Vertices>& polygons,
           const ChainRun& run)
{
  const auto* umbrella = dynamic_cast<const UmbrellaFilter*>(filter);
  if (umbrella != nullptr && umbrella->getPointRoles().size() == run.point_count)
    return umbrella->getPointRoles();
  return findPointRoles(polygons, run.point_count, run.loop());
}

} // namespace

bool
applyFilter(ChainMesh& given,
            MeshProcessing* filter,
            const ChainRun& run,
            ChainMesh& left)
{
  if (filter == nullptr)
    left = std::move(given);
  else {
    left.mesh = std::make_shared<PolygonMesh>();
    const AtEnd restore([filter, own_mesh = filter->getInputMesh()] {
      filter->setInputMesh(own_mesh);
    });
    filter->setInputMesh(given.mesh);
    filter->process(*left.mesh);
    if (run.control.cancelled())
      return true;
    if (!areTriangles(left.mesh->polygons, run.point_count, run.loop()))
      return false;
    auto labels =
        labelsOfSurvivors(given.mesh->polygons, given.labels, left.mesh->polygons);
    if (!labels)
      return false;
    left.labels = std::move(*labels);
  }
  left.roles = rolesAfter(filter, left.mesh->polygons, run);
  if (filter != nullptr)
    std::swap(left.mesh->cloud, given.mesh->cloud);
  return true;
}

bool
leftOneSided(const MeshProcessing* filter)
{
  const auto* umbrella = dynamic_cast<const UmbrellaFilter*>(filter);
  return umbrella != nullptr && umbrella->getReport().one_sided_components > 0;
}

} // namespace ccaa
} // namespace pcl
