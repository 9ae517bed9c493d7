// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: meshes side by side, for one picture.
#include "mesh_row.h"

#include <pcl/io/ply_io.h>
#include <pcl/conversions.h>

#include "mesh/turn_between.h"

#include <stdexcept>

namespace bench {

MeshRow::MeshRow(const pcl::ccaa::Position& view,
                 const pcl::ccaa::Positions& positions,
                 const pcl::ccaa::Triangles& triangles)
: turn_(pcl::ccaa::turnBetween(view, pcl::ccaa::Position::UnitZ()))
{
  for (const pcl::ccaa::Position& position : positions)
    box_.extend(turn_ * position);
  add(positions, triangles);
}

void
MeshRow::add(const pcl::ccaa::Positions& positions,
             const pcl::ccaa::Triangles& triangles)
{
  const auto first = static_cast<pcl::index_t>(cloud_.size());
  const auto step = static_cast<float>(1.1 * box_.sizes().x() * places_);
  for (const pcl::ccaa::Position& position : positions) {
    const Eigen::Vector3f at = (turn_ * position).cast<float>();
    cloud_.emplace_back(at.x() + step, at.y(), at.z());
  }
  for (const pcl::ccaa::Triangle& t : triangles) {
    polygons_.emplace_back();
    for (const pcl::index_t corner : t)
      polygons_.back().vertices.push_back(
          static_cast<pcl::Indices::value_type>(first + corner));
  }
  ++places_;
}

void
MeshRow::write(const std::string& file) const
{
  pcl::PolygonMesh mesh;
  pcl::toPCLPointCloud2(cloud_, mesh.cloud);
  mesh.polygons = polygons_;
  if (pcl::io::savePLYFileBinary(file, mesh) < 0)
    throw std::runtime_error("cannot write " + file);
}

} // namespace bench
