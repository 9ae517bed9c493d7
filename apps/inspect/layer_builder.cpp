// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: puts a layer of an inspection together.
#include "layer_builder.h"

#include <utility>

namespace app {

static_assert(static_cast<std::int32_t>(pcl::repair::NONE) == -1, "as it is written");

LayerBuilder::LayerBuilder(std::string name,
                           std::string title,
                           const std::vector<std::string>& fields)
: fields_{colourArray()}
{
  layer_.name = std::move(name);
  layer_.title = std::move(title);
  for (const std::string& field : fields)
    fields_.push_back({field, pcl::PCLPointField::FLOAT32, 1, {}});
}

pcl::index_t
LayerBuilder::addPlace(const Eigen::Vector3d& position, const Rgb& color)
{
  for (const double coordinate : position)
    positions_.push_back(static_cast<float>(coordinate));
  appendColour(fields_.front(), color[0], color[1], color[2]);
  return static_cast<pcl::index_t>(positions_.size() / 3 - 1);
}

void
LayerBuilder::put(FieldArray& field, const Eigen::Vector3d& direction)
{
  field.type = pcl::PCLPointField::FLOAT32;
  field.count = 3;
  for (const double share : direction)
    field.append(static_cast<float>(share));
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
  layer_.faces.emplace_back().vertices = corners;
}

void
LayerBuilder::addLegend(const Rgb& color, const std::string& meaning)
{
  layer_.legend.push_back({color, meaning});
}

void
LayerBuilder::addLegend(const Rgb& color, const std::string& meaning, std::size_t count)
{
  addLegend(color, meaning + " (" + std::to_string(count) + ")");
}

InspectionLayer
LayerBuilder::finish(const std::string& columns)
{
  layer_.columns = columns;
  assembleCloud(positions_, fields_, layer_.cloud);
  return std::move(layer_);
}

} // namespace app
