// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the surface among the cells of an unstructured VTK grid.
#include "vtk_cells.h"

#include "wording.h"

#include <utility>

namespace app {
namespace {

/** VTK's numbers of the kinds of cells that matter here. */
enum CellType : std::int64_t {
  EMPTY = 0,
  POLY_LINE = 4, // up to here points and lines
  TRIANGLE = 5,
  TRIANGLE_STRIP = 6,
  POLYGON = 7,
  PIXEL = 8, // a rectangle whose corners go by rows
  QUAD = 9
};

/** \return false for a cell that is no surface. */
bool
addCell(std::int64_t type, std::vector<std::int64_t>& corners, PolygonBuilder& builder)
{
  if (type == TRIANGLE_STRIP) {
    builder.addStrip(corners);
    return true;
  }
  if (type == PIXEL && corners.size() == 4)
    std::swap(corners[2], corners[3]);
  const bool is_polygon =
      type == TRIANGLE || type == POLYGON || type == QUAD || type == PIXEL;
  if (is_polygon)
    builder.addPolygon(corners);
  return is_polygon || (type >= EMPTY && type <= POLY_LINE);
}

} // namespace

bool
addSurfaceCells(const std::vector<std::int64_t>& cells,
                const std::vector<std::int64_t>& types,
                PolygonBuilder& builder,
                Warnings& warnings)
{
  std::size_t others = 0;
  std::size_t cell = 0;
  std::vector<std::int64_t> corners;
  for (std::size_t at = 0; at < cells.size(); ++cell) {
    const std::int64_t count = cells[at++];
    if (cell >= types.size() || count < 0 ||
        count > static_cast<std::int64_t>(cells.size() - at))
      return false;
    const auto first = cells.begin() + static_cast<std::ptrdiff_t>(at);
    corners.assign(first, first + count);
    at += static_cast<std::size_t>(count);
    others += addCell(types[cell], corners, builder) ? 0 : 1;
  }
  if (others > 0)
    warnings.push_back(plural(others, "cell") +
                       " left out: only flat polygons are read");
  return cell == types.size();
}

} // namespace app
