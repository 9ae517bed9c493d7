// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a slice through the field and the surface, coloured.
#include <Eigen/Geometry>

#include "io/wording.h"
#include "layer_builder.h"

#include <algorithm>

namespace app {
namespace {

using pcl::repair::FieldSlice;
using pcl::repair::IncompleteModel;

/** \brief The tension drawn as strongest: that of the 2 % nearest to a source is beyond
 * what can be told apart. 1 where there is no field. */
double
strongTension(const FieldSlice& slice)
{
  std::vector<double> tensions;
  for (const double tension : slice.tension)
    if (tension > 0.0)
      tensions.push_back(tension);
  if (tensions.empty())
    return 1.0;
  std::sort(tensions.begin(), tensions.end());
  return tensions[(tensions.size() - 1) * 98 / 100];
}

void
addTensionLegend(double strong, LayerBuilder& builder)
{
  constexpr int steps = 4;
  for (int i = steps; i >= 0; --i) {
    const double share = static_cast<double>(i) / steps;
    builder.addLegend(
        colorOfTension(share),
        formatted("|H| %.3g%s", share * strong, i == steps ? " or more" : ""));
  }
}

/** \brief Where the surface's edges pass through a plane: at most two points of a
 * triangle, because a corner on the plane counts as above it. */
std::vector<Eigen::Vector3d>
cut(const IncompleteModel& model,
    const pcl::repair::Triangle& triangle,
    const Eigen::Hyperplane<double, 3>& plane)
{
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto corner = [&](std::size_t k) {
      return model.positions[static_cast<std::size_t>(triangle[k % 3])];
    };
    const double from = plane.signedDistance(corner(i));
    const double to = plane.signedDistance(corner(i + 1));
    if ((from < 0.0) != (to < 0.0))
      points.emplace_back(corner(i) + from / (from - to) * (corner(i + 1) - corner(i)));
  }
  return points;
}

} // namespace

InspectionLayer
showSlice(const FieldSlice& slice)
{
  LayerBuilder builder(
      "slice.vtk", "Tension |H| on a plane through the model", {"tension"});
  const double strong = strongTension(slice);
  for (std::size_t row = 0; row < slice.rows; ++row)
    for (std::size_t column = 0; column < slice.columns; ++column) {
      const double tension = slice.tension[row * slice.columns + column];
      builder.addPoint(slice.corner + static_cast<double>(column) * slice.across +
                           static_cast<double>(row) * slice.up,
                       colorOfTension(tension / strong),
                       tension);
    }
  for (std::size_t row = 1; row < slice.rows; ++row)
    for (std::size_t column = 1; column < slice.columns; ++column) {
      const auto index = static_cast<pcl::index_t>(row * slice.columns + column);
      const auto below = index - static_cast<pcl::index_t>(slice.columns);
      builder.addFace({below - 1, below, index, index - 1});
    }
  addTensionLegend(strong, builder);
  return builder.finish("tension: greatest |H n| over all n");
}

InspectionLayer
showSection(const pcl::repair::ModelSurvey& survey, const FieldSlice& slice)
{
  LayerBuilder builder("section.vtk", "The surface where slice.vtk cuts it");
  const Eigen::Hyperplane<double, 3> plane(slice.across.cross(slice.up).normalized(),
                                           slice.corner);
  for (const auto& triangle : survey.model.triangles) {
    const auto points = cut(survey.model, triangle, plane);
    if (points.size() != 2)
      continue;
    const auto first = builder.addPoint(points[0], SECTION_BLACK);
    builder.addPoint(points[1], SECTION_BLACK);
    builder.addLine(first, 2, false);
  }
  builder.addLegend(SECTION_BLACK, "surface");
  return builder.finish("");
}

} // namespace app
