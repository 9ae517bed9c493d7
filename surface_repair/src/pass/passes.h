// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: classify, bridge and close, and look again.

#pragma once

#include "pass/hole_closing.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::repair {

/** \brief One pass: the holes that were listed, and what came of it. */
struct Pass {
  HoleList holes;
  ClosedHoles closed;
  bool finished = false; /**< nothing is left that should be closed */
  const RepairParameters* parameters = nullptr; /**< that it went by */
};

/** \brief What a repair works on, and what it goes by. */
struct Course {
  const RepairParameters& parameters;
  const std::vector<RepairParameters>& rounds;
  const CloudFrame& frame;
  const ccaa::LoopContext& context;
  ModelSurvey& survey;
  RegionMemory& memory;
  RepairLog& log;
  RepairReport& report;
  std::size_t& input_vertices;
};

/** \brief A course on one thread, with a budget of its own. */
struct BoundedCourse {
  /** \param[in] whole must outlive the part, as well as \a run
   * \param[in,out] run told the work, may be null \param[in] most_work operations */
  BoundedCourse(const Course& whole, ccaa::RunControl* run, std::uint64_t most_work);

  ccaa::RunControl control;
  const ccaa::LoopContext context{1, &control};
  const Course course;
};

/** \brief What is done first, and, where all is to be closed, what once nothing more
 * can be joined: then each boundary is closed by itself. \param[in] diagonal of the
 * input, in shares of which lengths are wanted */
std::vector<RepairParameters>
roundsFor(const RepairParameters& wanted, double diagonal);

/** \brief Gap over which islands may be joined at all. \param[in] parameters of a
 * round, with lengths in units of the cloud */
double
longestJoin(const RepairParameters& parameters);

/** \brief All boundaries, and which of them are to be closed. \param[in] over_samples
 * loops that samples link are one hole */
HoleList
holesOf(const ModelSurvey& survey,
        const RepairParameters& parameters,
        bool over_samples = false);

/** \brief Classify and bridge as the last pass, unless nothing has changed since. */
void
look(const Pass& last, const Course& course);

/** \brief The model with what a pass closed, if anything, in order for the next look.
 */
void
takeClosed(Pass& pass, const Course& course);

/** \brief The passes of one round, or of two where all is to be closed. \return the
 * last pass; what it closed may be part of the model that has not been looked at */
Pass
closeRounds(const Course& course, bool over_samples = false);

} // namespace pcl::repair
