// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: parts of a cloud or mesh, with all fields.
#include "model_subset.h"

#include "point_columns.h"

#include <algorithm>

namespace app {
namespace {

void
takeCloud(const pcl::PCLPointCloud2& cloud,
          const std::vector<char>& wanted,
          pcl::PCLPointCloud2& part)
{
  const auto count = std::count(wanted.begin(), wanted.end(), 1);
  part.header = cloud.header;
  part.fields = cloud.fields;
  part.is_bigendian = cloud.is_bigendian;
  part.is_dense = cloud.is_dense;
  part.point_step = cloud.point_step;
  part.data.clear();
  part.data.reserve(static_cast<std::size_t>(count) * cloud.point_step);
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (wanted[i] != 0)
      part.data.insert(
          part.data.end(), pointAt(cloud, i), pointAt(cloud, i) + cloud.point_step);
  // A whole organised cloud stays organised.
  const bool is_whole = part.data.size() == cloud.data.size();
  part.width = is_whole ? cloud.width : static_cast<pcl::uindex_t>(count);
  part.height = is_whole ? cloud.height : 1;
  part.row_step = part.width * part.point_step;
}

bool
hasFlagged(const pcl::Vertices& polygon, const std::vector<char>& flags, char flag)
{
  return std::any_of(
      polygon.vertices.begin(), polygon.vertices.end(), [&](pcl::index_t corner) {
        return flags[static_cast<std::size_t>(corner)] == flag;
      });
}

} // namespace

pcl::PolygonMesh
takePoints(const pcl::PolygonMesh& mesh,
           const std::vector<char>& wanted,
           const std::vector<pcl::Vertices>& polygons)
{
  pcl::PolygonMesh part;
  part.header = mesh.header;
  takeCloud(mesh.cloud, wanted, part.cloud);
  std::vector<pcl::index_t> new_index(wanted.size(), 0);
  pcl::index_t next = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (wanted[i] != 0)
      new_index[i] = next++;
  for (const pcl::Vertices& polygon : polygons) {
    if (hasFlagged(polygon, wanted, 0))
      continue;
    part.polygons.push_back(polygon);
    for (pcl::index_t& corner : part.polygons.back().vertices)
      corner = new_index[static_cast<std::size_t>(corner)];
  }
  return part;
}

void
splitPolygons(const std::vector<pcl::Vertices>& polygons,
              const std::vector<char>& flagged,
              std::vector<pcl::Vertices>& untouched,
              std::vector<pcl::Vertices>& touched)
{
  for (const pcl::Vertices& polygon : polygons)
    (hasFlagged(polygon, flagged, 1) ? touched : untouched).push_back(polygon);
}

} // namespace app
