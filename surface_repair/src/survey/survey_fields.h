// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the fields of a survey, and what they are made of.

#pragma once

#include <pcl/surface_repair/field/free_point_field.h>
#include <pcl/surface_repair/field/shielding.h>
#include <pcl/surface_repair/model_survey.h>

#include <memory>
#include <vector>

namespace pcl {
namespace repair {

/** \brief What is built once for all fields of a survey; null where it is not needed.
 */
struct SurveyGuides {
  std::unique_ptr<Shield> surface;
  std::unique_ptr<FreePointField> free_points;
};

/** \brief The sources of step ICM3 -> ICM2, and the boundaries they stand for. */
struct IslandSources {
  SourceSet sources;
  double median_gap = 0.0; /**< median distance to another island; 0: there is none */
};

IslandSources
islandSources(const ModelSurvey& survey, const FieldParameters& parameters);

/** \brief Surface and free points as obstacles and guides (full mode needs both, the
 * tracker the surface, the perturbation the free points). */
SurveyGuides
makeGuides(const ModelSurvey& survey,
           const FieldParameters& parameters,
           double median_gap);

/** \brief Lines between islands. */
SurveyedField
surveyIslands(const ModelSurvey& survey,
              const SurveyParameters& parameters,
              const IslandSources& islands,
              const SurveyGuides& guides,
              const ccaa::LoopContext& context);

/** \brief Bridges among the lines between islands, and the contours they make. */
SurveyedBridges
joinIslands(const ModelSurvey& survey,
            const SurveyParameters& parameters,
            const IslandSources& islands);

/** \brief Lines across one hole. */
SurveyedField
surveyHole(const ModelSurvey& survey,
           std::size_t loop,
           const SurveyParameters& parameters,
           const SurveyGuides& guides,
           const ccaa::LoopContext& context);

} // namespace repair
} // namespace pcl
