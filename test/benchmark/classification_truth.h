// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: boundary loops of which it is known what they bound.
#pragma once

#include "boundary/boundary_loop.h"
#include "boundary/classification.h"
#include "icadm/incomplete_model.h"
#include "seeded_damage.h"

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace bench {

/** \brief What a loop bounds. */
enum class LoopTruth : std::uint8_t {
  UNCLEAR, /**< not counted */
  HOLE,
  ISLAND_RIM,
  OUTER_BORDER,
  RIM /**< either of the two */
};

/** \brief A model and the truth about its loops. */
struct TruthCase {
  pcl::repair::IncompleteModel model;
  pcl::repair::BoundaryLoops loops;
  std::vector<LoopTruth> truth; /**< one a loop */
};

/** \brief A closed model without some triangles, read as any mesh is.
 *
 * The truth comes from what was taken away. Each connected missing part that is a disc,
 * or a disc around islands that are discs themselves, has one loop on the largest
 * island: a HOLE, as long as what is missing is smaller than what is there. The
 * islands in it have ISLAND_RIMs where they are nearly flat. Everything else (a part
 * that connects two sides of the surface, half the model missing) is UNCLEAR. */
TruthCase
damagedCase(const ClosedModel& model, const std::vector<char>& removed);

/** \brief Of an open surface, such as a scan, whose longest loops are its rims: the
 * longest loop of each island is a RIM (an OUTER_BORDER where there is one island
 * only), the others are HOLEs. An island whose second loop has more than half the
 * length of the longest one is UNCLEAR as a whole. */
TruthCase
openCase(const std::string& file);

/** \brief Of a surface that encloses something: all loops of the largest island are
 * HOLEs, the others UNCLEAR. \param[in] except so many longest loops are UNCLEAR */
TruthCase
enclosingCase(const std::string& file, std::size_t except = 0);

/** \brief How a classification compares with the truth. */
struct TruthCounts {
  std::size_t holes = 0;
  std::size_t rims = 0;
  std::size_t right = 0;
  std::size_t wrong = 0;
  std::size_t undecided = 0;
  std::size_t wrong_by_sign = 0; /**< by the sign of D alone, as in the thesis */

  void
  add(const TruthCounts& other);
};

TruthCounts
compare(const TruthCase& truth, const std::vector<pcl::repair::LoopClass>& classes);

/** \brief Classify the loops of all closed models under seeded damage and of all files
 * whose truth is clear, and print a row for each.
 * \param[in] rounds of damage for each closed model */
void
printClassificationTable(std::ostream& out, std::uint64_t rounds);

} // namespace bench
