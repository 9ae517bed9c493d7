// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a user's decisions about a repair, as a JSON file.
#pragma once

#include <pcl/surface_repair/decisions.h>

#include "output_file.h"
#include "words.h"

#include <memory>
#include <string>

namespace app {

using DecisionsPtr = std::shared_ptr<const pcl::repair::Decisions>;

constexpr Word<pcl::repair::Cap> CAPS[] = {{"auto", pcl::repair::Cap::AUTO},
                                           {"smooth", pcl::repair::Cap::SMOOTH},
                                           {"flat", pcl::repair::Cap::FLAT}};

/** \brief What a user decided, from the text of a file. Throws an exception with one
 * sentence for a text that is none, or that says what cannot be. */
DecisionsPtr
parseDecisions(const std::string& text);

/** \brief Read what a user decided. Fails with one sentence for a file that is none, or
 * that says what cannot be. Whether it fits a mesh is for the repair to say. */
Status
readDecisions(const std::string& path, DecisionsPtr& decisions);

/** \brief The same, but a file that is not there yet says nothing. */
Status
readDecisionsIfAny(const std::string& path, DecisionsPtr& decisions);

/** \brief A loop and what is decided about it, in a line or two. */
std::string
tellLoop(std::size_t number, const pcl::repair::LoopDecision& loop);

/** \brief The same of a junction. */
std::string
tellJunction(std::size_t number, const pcl::repair::JunctionDecision& junction);

/** \brief Proposals for a user to change, as a file has them.
 * \param[in] input name of the mesh, for people */
std::string
decisionsText(const std::string& input, const pcl::repair::Decisions& decisions);

/** \brief Write proposals for a user to change into an opened file.
 * \param[in] input name of the mesh, for people */
void
writeDecisions(const std::string& input,
               const pcl::repair::Decisions& decisions,
               OutputFile& file);

} // namespace app
