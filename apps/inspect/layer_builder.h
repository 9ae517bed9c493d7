// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: puts an inspection layer together, point by point.
#pragma once

#include "inspection.h"
#include "io/cloud_assembler.h"

#include <deque>

namespace app {

/** \brief Collects points with a colour each and with fields, and cells along them.
 * Every field that was asked for needs one value a point. */
class LayerBuilder {
public:
  LayerBuilder(std::string name, std::string title);

  /** \return index of the point */
  pcl::index_t
  addPoint(const Eigen::Vector3d& position, const Rgb& color);

  /** \brief A field of one whole number a point. */
  FieldArray&
  wholeField(const std::string& name);

  /** \brief A field of one real number a point, or, for the name "normal", of three. */
  FieldArray&
  realField(const std::string& name, std::size_t count = 1);

  /** \brief A line along points that were added one after the other. */
  void
  addLine(pcl::index_t first, std::size_t points, bool closed);

  void
  addFace(const std::vector<pcl::index_t>& corners);

  void
  addLegend(const Rgb& color, const std::string& meaning);

  InspectionLayer
  finish(const std::string& columns);

private:
  InspectionLayer layer_;
  std::vector<float> positions_;
  std::deque<FieldArray> fields_; // stay where they are when more come
};

/** \brief Append the three numbers of a direction. */
void
appendDirection(FieldArray& field, const Eigen::Vector3d& direction);

/** \brief An index as a number for people: -1 for none. */
std::int32_t
indexOrMinusOne(std::size_t index);

} // namespace app
