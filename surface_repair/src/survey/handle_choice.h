// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: handles that bridges make, counted before anything is
// filled.

#pragma once

#include "survey/model_survey.h"

#include <vector>

namespace pcl::repair {

/** \brief What closing all contours would make of islands and bridges. */
struct BridgedTopology {
  std::size_t pieces = 0;
  long handles = 0; /**< beyond those that the islands have */
  long in_gaps = 0; /**< of them, those of the new surface alone: in a gap whose
                         boundaries bridges connect */
};

/** \brief Count pieces and handles: with I islands in P pieces, N boundaries, B bridges
 * that pass C contours, bridges add P - I - (C - B - N) / 2 handles (Euler). The
 * surface in G gaps has G - (C - B + N) / 2 of its own; the others lead through several
 * gaps. \param[in] joined bridges and contours of boundaries of the survey */
BridgedTopology
bridgedTopology(const ModelSurvey& survey, const SurveyedBridges& joined);

/** \brief Whether a junction may make a handle on its own evidence: it is straight, or
 * sure. */
bool
carriesHandle(const JunctionEvidence& evidence);

/** \brief Whether it may without a doubt: a far bent one has to be surer. */
bool
surelyCarriesHandle(const JunctionEvidence& evidence);

/** \brief Give up bridges that make a handle, those of narrow strips and then of the
 * most bent junction first, until none is left that evidence does not carry: at a true
 * handle that was cut through the surfaces go on straight. A handle that lies in one
 * gap as a whole has no evidence at all: there the least likely junctions give way,
 * too.
 *
 * No piece falls apart. Cost: some dozen extractions of contours for each handle.
 * \param[in,out] joined bridges and contours of boundaries of the survey
 * \param[in,out] control told the work, may be null */
void
dropHandles(const ModelSurvey& survey,
            const BoundaryEdges& boundaries,
            SurveyedBridges& joined,
            ccaa::RunControl* control = nullptr);

} // namespace pcl::repair
