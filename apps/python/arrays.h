// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: numpy arrays and what PCL has for them.
#pragma once

#include <pcl/surface_ccaa/impl/point_array.h>
#include <pcl/PCLPointCloud2.h>
#include <pcl/Vertices.h>

#include "mesh/mesh_view.h"
#include "mesh/triangle.h"
#include <pybind11/numpy.h>

#include <cstdint>
#include <string>
#include <vector>

namespace app::python {

/** \brief A row of corners for each polygon; of C order. */
using CornerArray = pybind11::array_t<std::int32_t, pybind11::array::c_style>;

/** \brief The polygons of an array in place. */
pcl::ccaa::PolygonView
viewOf(const CornerArray& corners);

/** \param[in] threads at least 1 */
std::vector<pcl::Vertices>
toPolygons(const CornerArray& corners, int threads);

/** \brief (M, 3); all polygons are triangles. \param[in] threads at least 1 */
CornerArray
toArray(const std::vector<pcl::Vertices>& triangles, int threads);

/** \brief (M, 3), in the memory of the triangles. */
CornerArray
toArray(pcl::ccaa::Triangles triangles);

/** \brief One byte an item, whatever small enumeration or number it is. */
template <typename Item>
pybind11::array_t<std::uint8_t>
toBytes(const std::vector<Item>& items)
{
  static_assert(sizeof(Item) == 1, "copied byte by byte");
  return pybind11::array_t<std::uint8_t>(
      static_cast<pybind11::ssize_t>(items.size()),
      reinterpret_cast<const std::uint8_t*>(items.data()));
}

/** \brief Three floats in a row of each point, in place; empty where there is no field
 * of that name. */
pcl::ccaa::PointArray
floatsOf(const pcl::PCLPointCloud2& cloud, const std::string& first_field);

/** \brief Bind a raw cloud as the class Cloud, whose `data` is the memory of its
 * points. */
void
addCloud(pybind11::module_& module);

} // namespace app::python
