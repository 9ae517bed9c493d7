// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: puts a layer of an inspection together.
#pragma once

#include "inspection.h"
#include "io/cloud_assembler.h"

#include <type_traits>

namespace app {

/** \brief Collects points with a colour and some values each, and cells along
 * them. */
class LayerBuilder {
public:
  /** \param[in] fields names of the values of the points, in order */
  LayerBuilder(std::string name,
               std::string title,
               const std::vector<std::string>& fields = {});

  /** \brief A point with a value for each field: a direction, a real number, a
   * whole one, or an index, which is -1 for none. \return index of the point */
  template <typename... Values>
  pcl::index_t
  addPoint(const Eigen::Vector3d& position, const Rgb& color, const Values&... values)
  {
    [[maybe_unused]] auto field = fields_.begin() + 1;
    (put(*field++, values), ...);
    return addPlace(position, color);
  }

  /** \brief A line along points, which \a add adds by their numbers. */
  template <typename Add>
  void
  addCurve(std::size_t points, bool closed, const Add& add)
  {
    const auto first = static_cast<pcl::index_t>(positions_.size() / 3);
    for (std::size_t k = 0; k < points; ++k)
      add(k);
    addLine(first, points, closed);
  }

  /** \brief A line along points that were added one after the other. */
  void
  addLine(pcl::index_t first, std::size_t points, bool closed);

  void
  addFace(const std::vector<pcl::index_t>& corners);

  void
  addLegend(const Rgb& color, const std::string& meaning);

  /** \brief The same with the number of what has this colour. */
  void
  addLegend(const Rgb& color, const std::string& meaning, std::size_t count);

  /** \param[in] columns what the fields mean, for people */
  InspectionLayer
  finish(const std::string& columns);

private:
  pcl::index_t
  addPlace(const Eigen::Vector3d& position, const Rgb& color);

  static void
  put(FieldArray& field, const Eigen::Vector3d& direction);

  template <typename Value, typename = std::enable_if_t<!std::is_class_v<Value>>>
  static void
  put(FieldArray& field, Value value)
  {
    if constexpr (std::is_floating_point_v<Value>) {
      field.type = pcl::PCLPointField::FLOAT32;
      field.append(static_cast<float>(value));
    }
    else {
      field.type = pcl::PCLPointField::INT32;
      field.append(static_cast<std::int32_t>(value)); // -1 for NONE
    }
  }

  InspectionLayer layer_;
  std::vector<float> positions_;
  std::vector<FieldArray> fields_; // the first one is the colour
};

} // namespace app
