// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which regions could not be closed where nothing has changed
// since.

#pragma once

#include "repair/region_closing.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace pcl {
namespace repair {

/** \brief Whether all holes of a region stayed open. */
bool
allFailed(const std::vector<HoleOutcome>& holes);

/** \brief Regions of which no hole could be closed. Closing is determined by a region
 * and by what is around it: where both are as they were, it fails again. */
class RegionMemory {
public:
  /** \brief What decides how a region is closed, with all its surroundings. */
  struct Key {
    std::vector<std::array<double, 3>> points; /**< of boundaries and samples */
    std::vector<std::size_t> numbers;          /**< how they belong together */
    std::uint64_t surroundings = 0;

    bool
    operator<(const Key& other) const;
  };

  /** \param[in] box around all that its closing looks at */
  static Key
  keyOf(const Region& region,
        const IncompleteModel& model,
        const SurfaceObstacle& obstacle,
        const ccaa::Box& box);

  /** \brief How the holes of such a region failed; null: they did not. */
  const std::vector<HoleOutcome>*
  find(const Key& key) const;

  void
  remember(Key key, const std::vector<HoleOutcome>& holes)
  {
    failed_.emplace(std::move(key), holes);
  }

  bool
  empty() const
  {
    return failed_.empty();
  }

private:
  std::map<Key, std::vector<HoleOutcome>> failed_;
};

} // namespace repair
} // namespace pcl
