// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: collects polygons whose indices come from a file.
#pragma once

#include <pcl/Vertices.h>

#include "status.h"

#include <cstdint>
#include <vector>

namespace app {

/** \brief Takes corner lists as files give them: out of range, too short or as strips.
 *
 * The vertex count may be known only at the end of the file, so the range is checked by
 * checkPolygonIndices() afterwards; here only what does not fit PCL's index type fails.
 */
class PolygonBuilder {
public:
  explicit PolygonBuilder(std::vector<pcl::Vertices>& polygons) : polygons_(polygons) {}

  void
  reserve(std::size_t polygons)
  {
    polygons_.reserve(polygons_.size() + polygons);
  }

  /** \brief Add one face; faces with fewer than three corners are counted, not kept. */
  void
  addPolygon(const std::vector<std::int64_t>& corners);

  /** \brief Add the triangles of a strip, every second one turned round; -1 restarts.
   */
  void
  addStrip(const std::vector<std::int64_t>& corners);

  /** \brief Report what was dropped; fails if an index was negative or beyond range. */
  Status
  finish(Warnings& warnings) const;

private:
  std::vector<pcl::Vertices>& polygons_;
  std::size_t short_faces_ = 0;
  bool has_bad_index_ = false;
  std::int64_t bad_index_ = 0;
};

/** \brief Fails for the first polygon with a corner that is not below \a vertices. */
Status
checkPolygonIndices(const std::vector<pcl::Vertices>& polygons, std::size_t vertices);

} // namespace app
