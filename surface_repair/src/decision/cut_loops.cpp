// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the part of a mesh, and where it was cut from the rest.
#include "decision/cut_loops.h"

#include "boundary/extraction.h"
#include "decision/loop_wishes.h"
#include "icadm/model_reading.h"

namespace pcl::repair {

std::shared_ptr<const Decisions>
leaveCutsOpen(const pcl::PolygonMesh::ConstPtr& mesh,
              const std::function<bool(pcl::index_t, pcl::index_t)>& is_boundary)
{
  const IncompleteModel model = readModel(mesh, nullptr, {}, {}).model;
  auto decisions = std::make_shared<Decisions>();
  for (const BoundaryLoop& loop : extractBoundaries(model)) {
    bool is_cut = false;
    for (std::size_t k = 0; k < loop.vertices.size() && !is_cut; ++k) {
      const auto pointAt = [&](std::size_t i) {
        return model.point_of_vertex[static_cast<std::size_t>(loop.vertices[i])];
      };
      is_cut = !is_boundary(pointAt(k), pointAt(loop.curve.next(k)));
    }
    if (!is_cut)
      continue;
    decisions->loops.emplace_back();
    decisions->loops.back().key = keyOf(model, loop);
    decisions->loops.back().wish = LoopWish::LEAVE_OPEN;
  }
  if (decisions->loops.empty())
    return nullptr;
  decisions->mesh = fingerprintOf(*mesh);
  decisions->settles_doubts = false;
  return decisions;
}

} // namespace pcl::repair
