// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: polygons as files give them.
#pragma once

#include <pcl/Vertices.h>

#include "status.h"

#include <cstdint>
#include <vector>

namespace app {

/** \brief Takes corner lists as files give them: too short, or as strips. Throws a
 * Failure for a corner that does not fit PCL's index type; whether there is such a
 * point may be known only at the end of the file, see checkPolygonIndices(). */
class PolygonBuilder {
public:
  explicit PolygonBuilder(std::vector<pcl::Vertices>& polygons) : polygons_(polygons) {}

  /** \brief Add one face; faces with fewer than three corners are counted, not kept. */
  void
  addPolygon(const std::vector<std::int64_t>& corners);

  /** \brief Add the triangles of a strip, every second one turned round; -1 restarts.
   */
  void
  addStrip(const std::vector<std::int64_t>& corners);

  /** \brief Tell what was left out. */
  void
  finish(Warnings& warnings) const;

private:
  std::vector<pcl::Vertices>& polygons_;
  std::size_t short_faces_ = 0;
};

/** \brief Fails for the first polygon with a corner that is not below \a vertices. */
void
checkPolygonIndices(const std::vector<pcl::Vertices>& polygons, std::size_t vertices);

} // namespace app
