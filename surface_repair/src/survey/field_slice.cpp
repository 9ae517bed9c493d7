// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the field on a plane through a model.

#include <Eigen/SVD>

#include "survey/model_survey.h"
#include "survey/survey_fields.h"

#include <algorithm>

namespace pcl::repair {

namespace {

/** A grid across the shortest extent of the model, through its middle. */
FieldSlice
placeSlice(const ModelSurvey& survey, std::size_t columns)
{
  FieldSlice slice;
  Eigen::AlignedBox3d box;
  for (const Position& position : survey.model.positions)
    box.extend(position);
  if (box.isEmpty() || columns < 2)
    return slice;
  Eigen::Index thin = 0;
  Eigen::Index wide = 0;
  box.sizes().minCoeff(&thin);
  box.sizes().maxCoeff(&wide);
  if (thin == wide)
    wide = (thin + 1) % 3;
  const Eigen::Index tall = 3 - thin - wide;
  const double step = box.sizes()[wide] / static_cast<double>(columns - 1);
  slice.columns = columns;
  slice.rows =
      std::max<std::size_t>(2, static_cast<std::size_t>(box.sizes()[tall] / step) + 1);
  slice.across = step * Eigen::Vector3d::Unit(wide);
  slice.up = step * Eigen::Vector3d::Unit(tall);
  slice.corner = box.min();
  slice.corner[thin] = box.center()[thin];

  return slice;
}

/** Greatest |H n| over all unit n: the greatest singular value. */
double
greatestTension(const Tension& tension)
{
  return Eigen::JacobiSVD<Eigen::Matrix3d>(tension).singularValues()[0];
}

} // namespace

FieldSlice
sliceField(const ModelSurvey& survey,
           const FieldParameters& parameters,
           std::size_t columns,
           const ccaa::LoopContext& context)
{
  const IslandSources islands = islandSources(survey, parameters, context);
  FieldSlice slice = placeSlice(survey, columns);
  if (slice.columns == 0)
    return slice;
  FieldQuery query;
  query.falloff.near = islands.sources.spacing;
  query.falloff.far =
      parameters.far > 0.0
          ? parameters.far
          : std::max(parameters.room * islands.median_gap, 8.0 * slice.across.norm());
  query.falloff.exponent = parameters.falloff_exponent;
  std::vector<FieldQuery> queries;
  for (std::size_t row = 0; row < slice.rows; ++row)
    for (std::size_t column = 0; column < slice.columns; ++column) {
      query.position = slice.corner + static_cast<double>(column) * slice.across +
                       static_cast<double>(row) * slice.up;
      queries.push_back(query);
    }
  const IndicatorField field(islands.sources, parameters.interpolation);
  for (const Tension& tension : field.tensionAt(queries, context))
    slice.tension.push_back(greatestTension(tension));
  return slice;
}

} // namespace pcl::repair
