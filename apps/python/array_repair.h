// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a repair whose triangles come from an array and go into
// one.
#pragma once

#include <pcl/surface_repair/force_line_hole_repair.h>

#include "mesh/block_loop.h"
#include "mesh/mesh_view.h"
#include "mesh/triangle.h"

#include <utility>
#include <vector>

namespace app::python {

/** \brief A ForceLineHoleRepair of a mesh that has only its points from PCL: neither
 * what goes in nor what comes out needs a block of memory for each triangle. */
class ArrayRepair : public pcl::ForceLineHoleRepair {
public:
  /** \brief \param[in] polygons of the input mesh; what they look at must outlive this
   */
  explicit ArrayRepair(const pcl::ccaa::PolygonView& polygons) : polygons_(polygons) {}

  /** \brief The triangles of the result of process(), which has no polygons. */
  pcl::ccaa::Triangles
  takeTriangles()
  {
    return std::move(triangles_);
  }

private:
  pcl::ccaa::MeshView
  inputView() const override
  {
    return {input_mesh_->cloud, polygons_};
  }

  void
  writeTriangles(pcl::ccaa::Triangles& triangles,
                 const std::vector<pcl::index_t>& point_of_vertex,
                 const pcl::ccaa::LoopContext& context,
                 pcl::PolygonMesh&) override
  {
    const auto number = [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        for (pcl::index_t& corner : triangles[i])
          corner = point_of_vertex[static_cast<std::size_t>(corner)];
    };
    forEachBlock(triangles.size(), context, number);
    triangles_ = std::move(triangles);
  }

  pcl::ccaa::PolygonView polygons_;
  pcl::ccaa::Triangles triangles_;
};

} // namespace app::python
