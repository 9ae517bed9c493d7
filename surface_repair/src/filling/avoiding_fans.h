// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: fans around inner points that go around what is in the way.

#pragma once

#include "filling/filling_method.h"

namespace pcl::repair {

/** \brief Fans around inner points that go around what stands in the hole.
 *
 * An inner point from which the whole boundary can be reached freely closes it; of such
 * points beside and above the centre that with the least area is taken. Where there is
 * none, the one that sees most: what it does not see is closed from points of its own,
 * in the same way. For what no triangulation of the boundary's own points closes. Cost:
 * at most MOST_QUESTIONS to the task's `obstructed`. */
class AvoidingFans : public FillingMethod {
public:
  const char*
  name() const override
  {
    return "fan";
  }

  std::size_t
  simpleEdges() const override
  {
    return 64;
  }

  Filling
  close(const FillingTask& task) const override;
};

} // namespace pcl::repair
