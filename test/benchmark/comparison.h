// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: ours and the field on one cloud, timed and judged.
#pragma once

#include "judgement.h"
#include "reconstruction.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace bench {

/** \brief One method on one cloud. */
struct Entrant {
  Method method;
  std::vector<double> runs; /**< seconds of each */
  pcl::ccaa::Triangles triangles;
  Judgement judgement;
};

/** \brief All methods on one cloud. */
struct Comparison {
  std::string name;
  Cloud::Ptr cloud;
  std::shared_ptr<const ReferenceMesh> reference; /**< may be null */
  Entrant ours;                                   /**< on one thread */
  Entrant ours_on_two;                            /**< on two threads; not judged */
  std::vector<Entrant> rivals; /**< each on as many threads as it takes */
};

/** \brief How to compare. */
struct ComparisonSettings {
  std::size_t repeats = 5; /**< at least 1; methods take turns */
  bool rivals = true;
};

/** \brief Run and judge all methods on the cloud that a word names (see makeCloud()).
 */
Comparison
compare(const std::string& word, const ComparisonSettings& settings);

/** \brief Print a line of headings and a line for each method. */
void
print(const Comparison& comparison);

} // namespace bench
