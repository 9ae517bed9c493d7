// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: numpy arrays and what PCL has for them.
#include "arrays.h"

#include "io/point_columns.h"
#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <tuple>
#include <utility>

namespace app::python {
namespace {

namespace py = pybind11;

/** Name, bytes into the point, PCL's number of the type, and how many numbers. */
using FieldTuple = std::tuple<std::string, pcl::uindex_t, std::uint8_t, pcl::uindex_t>;

std::shared_ptr<pcl::PCLPointCloud2>
makeCloud(pcl::uindex_t points,
          pcl::uindex_t step,
          const std::vector<FieldTuple>& fields)
{
  auto cloud = std::make_shared<pcl::PCLPointCloud2>();
  cloud->width = points;
  cloud->height = 1;
  cloud->point_step = step;
  cloud->row_step = step * points;
  for (const auto& [name, offset, type, count] : fields) {
    cloud->fields.emplace_back();
    cloud->fields.back().name = name;
    cloud->fields.back().offset = offset;
    cloud->fields.back().datatype = type;
    cloud->fields.back().count = count;
  }
  cloud->data.resize(std::size_t{step} * points);
  return cloud;
}

} // namespace

pcl::ccaa::PolygonView
viewOf(const CornerArray& corners)
{
  return {corners.data(),
          static_cast<std::size_t>(corners.shape(0)),
          static_cast<std::size_t>(corners.shape(1))};
}

std::vector<pcl::Vertices>
toPolygons(const CornerArray& corners, int threads)
{
  const auto row = corners.unchecked<2>();
  const py::ssize_t count = row.shape(0);
  std::vector<pcl::Vertices> polygons(static_cast<std::size_t>(count));
#pragma omp parallel for num_threads(threads)
  for (py::ssize_t i = 0; i < count; ++i)
    polygons[static_cast<std::size_t>(i)].vertices.assign(
        row.data(i, 0), row.data(i, 0) + row.shape(1));
  return polygons;
}

CornerArray
toArray(const std::vector<pcl::Vertices>& triangles, int threads)
{
  const auto count = static_cast<py::ssize_t>(triangles.size());
  CornerArray corners({count, py::ssize_t{3}});
  std::int32_t* const first = corners.mutable_data();
#pragma omp parallel for num_threads(threads)
  for (py::ssize_t i = 0; i < count; ++i)
    std::copy_n(
        triangles[static_cast<std::size_t>(i)].vertices.begin(), 3, first + 3 * i);
  return corners;
}

CornerArray
toArray(pcl::ccaa::Triangles triangles)
{
  using pcl::ccaa::Triangles;
  auto owned = std::make_unique<Triangles>(std::move(triangles));
  const auto count = static_cast<py::ssize_t>(owned->size());
  const std::int32_t* const first = owned->empty() ? nullptr : owned->front().data();
  const py::capsule owner(owned.get(),
                          [](void* held) { delete static_cast<Triangles*>(held); });
  owned.release();
  return CornerArray({count, py::ssize_t{3}}, first, owner);
}

pcl::ccaa::PointArray
floatsOf(const pcl::PCLPointCloud2& cloud, const std::string& first_field)
{
  const auto* const field = findField(cloud, first_field, pcl::PCLPointField::FLOAT32);
  if (field == nullptr || cloud.data.empty())
    return {};
  return {reinterpret_cast<const float*>(cloud.data.data() + field->offset),
          cloud.point_step / sizeof(float),
          pointCount(cloud)};
}

void
addCloud(py::module_& module)
{
  using Cloud = pcl::PCLPointCloud2;
  py::class_<Cloud, std::shared_ptr<Cloud>>(
      module, "Cloud", "Points with all their fields, as PCL has them.")
      .def(py::init(&makeCloud))
      .def_property_readonly("size",
                             [](const Cloud& cloud) { return pointCount(cloud); })
      .def_property_readonly("data", [](const py::object& self) {
        auto& data = self.cast<Cloud&>().data;
        return py::array_t<std::uint8_t>(
            static_cast<py::ssize_t>(data.size()), data.data(), self);
      });
}

} // namespace app::python
