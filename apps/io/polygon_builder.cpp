// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: collects polygons whose indices come from a file.
#include "polygon_builder.h"

#include "wording.h"

#include <limits>

namespace app {

void
PolygonBuilder::addPolygon(const std::vector<std::int64_t>& corners)
{
  if (corners.size() < 3) {
    ++short_faces_;
    return;
  }
  pcl::Vertices polygon;
  polygon.vertices.reserve(corners.size());
  for (const std::int64_t corner : corners) {
    if (corner < 0 || corner > std::numeric_limits<pcl::index_t>::max())
      throw Failure("a face refers to vertex " + std::to_string(corner) +
                    ", which does not exist");
    polygon.vertices.push_back(static_cast<pcl::index_t>(corner));
  }
  polygons_.push_back(std::move(polygon));
}

void
PolygonBuilder::addStrip(const std::vector<std::int64_t>& corners)
{
  std::size_t start = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i] == -1)
      start = i + 1;
    if (corners[i] == -1 || i < start + 2)
      continue;
    const bool odd = (i - start) % 2 == 1;
    addPolygon(
        {corners[odd ? i - 1 : i - 2], corners[odd ? i - 2 : i - 1], corners[i]});
  }
}

void
PolygonBuilder::finish(Warnings& warnings) const
{
  if (short_faces_ > 0)
    warnings.push_back(plural(short_faces_, "face") +
                       " with fewer than three corners left out");
}

void
checkPolygonIndices(const std::vector<pcl::Vertices>& polygons, std::size_t vertices)
{
  for (const pcl::Vertices& polygon : polygons)
    for (const pcl::index_t corner : polygon.vertices)
      if (corner < 0 || static_cast<std::size_t>(corner) >= vertices)
        throw Failure("a face refers to vertex " + std::to_string(corner) +
                      ", but there are only " + std::to_string(vertices));
}

} // namespace app
