// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the fields of a survey, and what they are made of.

#pragma once

#include "survey/model_survey.h"

#include <memory>
#include <vector>

namespace pcl::repair {

/** \brief The sources of step ICM3 -> ICM2, and the boundaries they stand for. */
struct IslandSources {
  SourceSet sources;
  double median_gap = 0.0; /**< median distance to another island; 0: there is none */
  std::vector<std::size_t> ahead; /**< see SurveyedBridges */
};

IslandSources
islandSources(const ModelSurvey& survey,
              const FieldParameters& parameters,
              const ccaa::LoopContext& context);

/** \brief Surface and free points as obstacles and guides (full mode needs both, the
 * tracker the surface, the perturbation the free points).
 * \param[in] with_surface false leaves it out: its tree takes long */
std::shared_ptr<const SurveyGuides>
makeGuides(const ModelSurvey& survey,
           const FieldParameters& parameters,
           double median_gap,
           bool with_surface,
           const ccaa::LoopContext& context);

Reach
reachOf(const FieldParameters& parameters);

/** \brief The boundaries that a set of sources stands for. */
BoundaryEdges
targetsOf(const SourceSet& sources, const BoundaryLoops& loops);

/** \brief The field in the mode that is asked for. */
IndicatorField
makeField(const SourceSet& sources,
          const FieldParameters& parameters,
          const SurveyGuides& guides);

/** \brief Where lines run, and between what. */
struct LineField {
  const IndicatorField& field;
  const BoundaryEdges& targets;
  const SurveyGuides& guides;
};

/** \brief Trace lines and resample them; free points pull those that arrived. */
std::vector<ForceLine>
traceLines(const LineField& place,
           const std::vector<LineOrigin>& origins,
           const SurveyParameters& parameters,
           const ccaa::LoopContext& context);

/** \brief Lines between islands, bridges among them, and the contours they make:
 * fills in `between_islands` and `joined` of the survey. Where an island has lost the
 * only bridge it had (C4.47-3), more lines are traced there. */
void
joinIslands(const IslandSources& islands,
            const SurveyParameters& parameters,
            const ccaa::LoopContext& context,
            ModelSurvey& survey);

/** \brief Lines across one hole. */
SurveyedField
surveyHole(const ModelSurvey& survey,
           std::size_t loop,
           const SurveyParameters& parameters,
           const ccaa::LoopContext& context);

} // namespace pcl::repair
