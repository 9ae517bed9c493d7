// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: puts an inspection layer together, point by point.
#include "layer_builder.h"

#include <utility>

namespace app {

using Field = pcl::PCLPointField;

LayerBuilder::LayerBuilder(std::string name, std::string title)
{
  layer_.name = std::move(name);
  layer_.title = std::move(title);
  fields_.push_back(colourArray());
}

pcl::index_t
LayerBuilder::addPoint(const Eigen::Vector3d& position, const Rgb& color)
{
  for (int axis = 0; axis < 3; ++axis)
    positions_.push_back(static_cast<float>(position[axis]));
  appendColour(fields_.front(), color[0], color[1], color[2]);
  return static_cast<pcl::index_t>(positions_.size() / 3 - 1);
}

FieldArray&
LayerBuilder::wholeField(const std::string& name)
{
  fields_.push_back({name, Field::INT32, 1, {}});
  return fields_.back();
}

FieldArray&
LayerBuilder::realField(const std::string& name, std::size_t count)
{
  fields_.push_back({name, Field::FLOAT32, count, {}});
  return fields_.back();
}

void
LayerBuilder::addLine(pcl::index_t first, std::size_t points, bool closed)
{
  pcl::Vertices line;
  for (std::size_t k = 0; k < points; ++k)
    line.vertices.push_back(first + static_cast<pcl::index_t>(k));
  if (closed)
    line.vertices.push_back(first);
  layer_.lines.push_back(std::move(line));
}

void
LayerBuilder::addFace(const std::vector<pcl::index_t>& corners)
{
  layer_.faces.emplace_back();
  layer_.faces.back().vertices = corners;
}

void
LayerBuilder::addLegend(const Rgb& color, const std::string& meaning)
{
  layer_.legend.push_back({color, meaning});
}

InspectionLayer
LayerBuilder::finish(const std::string& columns)
{
  layer_.columns = columns;
  assembleCloud(positions_, {fields_.begin(), fields_.end()}, layer_.cloud);
  return std::move(layer_);
}

void
appendDirection(FieldArray& field, const Eigen::Vector3d& direction)
{
  for (int axis = 0; axis < 3; ++axis)
    field.append(static_cast<float>(direction[axis]));
}

std::int32_t
indexOrMinusOne(std::size_t index)
{
  return index == pcl::repair::NONE ? -1 : static_cast<std::int32_t>(index);
}

} // namespace app
