// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: decisions about loops, found again in each pass.

#pragma once

#include <pcl/surface_repair/decisions.h>

#include "boundary/boundary_loop.h"

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace pcl::repair {

/** \brief By what a loop is known again. */
LoopKey
keyOf(const IncompleteModel& model, const BoundaryLoop& loop);

/** \brief The loops of the input, what is wanted of them, and which must not be joined.
 *
 * Loops change while a model is repaired. One that is still as it was in the input is
 * known by its key; another one by the points that it has from loops of the input. */
class LoopWishes {
public:
  /** \brief Nothing is known and nothing is wanted. */
  LoopWishes() = default;

  /** \brief The loops of the input, as the method finds them. */
  LoopWishes(const IncompleteModel& model, const BoundaryLoops& loops);

  /** \brief Take decisions about them. \return what does not fit, without a full stop;
   * empty if all does */
  std::string
  take(const Decisions& decisions);

  /** \brief The loop of the input that a loop of a later pass still is, or NONE. */
  std::size_t
  inputLoop(const IncompleteModel& model, const BoundaryLoop& loop) const;

  LoopWish
  wishFor(std::size_t input_loop) const;

  /** \brief Cap::AUTO where nothing is wanted. */
  Cap
  capFor(std::size_t input_loop) const;

  /** \brief Whether bridges between some loops may not be built at all. */
  bool
  keepApart() const
  {
    return !apart_.empty() || !islands_apart_.empty() || leaves_open_;
  }

  /** \brief Pairs of loops of the input that are not to be joined, ascending. */
  const std::set<std::pair<std::size_t, std::size_t>>&
  apart() const
  {
    return apart_;
  }

  /** \brief Pairs of loops of the input that are to be joined, ascending. */
  const std::set<std::pair<std::size_t, std::size_t>>&
  joined() const
  {
    return joined_;
  }

  /** \brief Whether the user wants two loops of the input joined. */
  bool
  mustJoin(const IncompleteModel& model,
           const BoundaryLoop& first,
           const BoundaryLoop& second) const;

  /** \brief Whether bridges between two loops, of this pass, may be built. Cost: linear
   * in their edges. */
  bool
  mayJoin(const IncompleteModel& model,
          const BoundaryLoop& first,
          const BoundaryLoop& second) const;

private:
  struct Entry {
    LoopKey key;
    std::size_t island = 0;
    LoopWish wish = LoopWish::AUTO;
    Cap cap = Cap::AUTO;
  };
  using Pair = std::pair<std::size_t, std::size_t>;

  std::size_t
  find(const LoopKey& key) const;
  std::string
  takeJunctions(const Decisions& decisions, const std::vector<std::size_t>& places);
  std::set<std::size_t>
  inputLoopsIn(const IncompleteModel& model, const BoundaryLoop& loop) const;
  bool
  areApart(std::size_t first, std::size_t second) const;

  std::vector<Entry> loops_;                          /**< of the input */
  std::multimap<Pair, std::size_t> place_of_;         /**< of lowest point and edges */
  std::multimap<pcl::index_t, std::size_t> loops_at_; /**< of a point of the cloud */
  std::set<Pair> joined_;                             /**< loops, the lower one first */
  std::set<Pair> apart_;                              /**< loops, the lower one first */
  std::set<Pair> islands_apart_;                      /**< the lower one first */
  bool leaves_open_ = false; /**< some loop must stay as it is */
};

} // namespace pcl::repair
