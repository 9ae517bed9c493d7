// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the filter of a chain.
#include "consecutive/filter_stage.h"

#include "consecutive/stage_polygons.h"
#include "mesh/polygon_access.h"

#include <algorithm>
#include <typeinfo>
#include <utility>

namespace pcl::ccaa {
namespace {

/** Whether one algorithm has made all there is. */
bool
areAlike(const TriangleLabels& labels)
{
  return !labels.empty() &&
         std::equal(labels.begin() + 1, labels.end(), labels.begin());
}

} // namespace

bool
FilterPart::apply(ChainMesh& given, const ChainRun& run, ChainMesh& left) const
{
  if (filter_ == nullptr)
    left = std::move(given);
  else if (!process(given, run, left))
    return run.control.cancelled();
  left.roles = rolesAfter(left, run);
  if (filter_ != nullptr)
    std::swap(left.mesh->cloud, given.mesh->cloud);
  return true;
}

/** \return whether what is left is some of what was given */
bool
FilterPart::process(ChainMesh& given, const ChainRun& run, ChainMesh& left) const
{
  left.mesh = std::make_shared<PolygonMesh>();
  const AtEnd restore(
      [this, own_mesh = filter_->getInputMesh()] { filter_->setInputMesh(own_mesh); });
  // Who derives from our filter may do more with the polygons.
  const bool hands = umbrella_ != nullptr && typeid(*filter_) == typeid(UmbrellaFilter);
  TriangleHandoff handoff{&given.triangles, {}, {}};
  const LentHandoff lent(hands ? umbrella_ : nullptr, handoff);
  if (!hands)
    writePolygons(given.triangles, run.loop(), given.mesh->polygons);
  filter_->setInputMesh(given.mesh);
  filter_->process(*left.mesh);
  if (run.control.cancelled())
    return false;
  left.adjacency = std::move(handoff.adjacency);
  if (hands)
    left.triangles = std::move(handoff.made);
  else if (auto read = readTriangles(left.mesh->polygons, run.point_count, run.loop()))
    left.triangles = std::move(*read);
  else
    return false;
  if (hands && areAlike(given.labels)) {
    left.labels.assign(left.triangles.size(), given.labels.front());
    return true;
  }
  auto labels = labelsOfSurvivors(given.triangles, given.labels, left.triangles);
  if (labels)
    left.labels = std::move(*labels);
  return labels.has_value();
}

/** From the filter itself if it is ours and knows. */
std::vector<PointRole>
FilterPart::rolesAfter(const ChainMesh& left, const ChainRun& run) const
{
  if (umbrella_ != nullptr && umbrella_->getPointRoles().size() == run.point_count)
    return umbrella_->getPointRoles();
  return findPointRoles(left.triangles, run.point_count, run.loop());
}

} // namespace pcl::ccaa
