// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: decisions that are made while looking at them.
#pragma once

#include <pcl/surface_repair/decisions.h>

#include <cstddef>
#include <string>
#include <vector>

namespace app {

/** \brief One loop or junction after the other is chosen, accepted, rejected, and taken
 * back again. Knows nothing of windows. */
class DecisionEditor {
public:
  explicit DecisionEditor(pcl::repair::Decisions decisions)
  : decisions_(std::move(decisions)), saved_(decisions_)
  {}

  const pcl::repair::Decisions&
  decisions() const
  {
    return decisions_;
  }

  /** \brief Loops, then junctions. */
  std::size_t
  size() const
  {
    return decisions_.loops.size() + decisions_.junctions.size();
  }

  /** \brief The one that is chosen; of no meaning where there is none. */
  std::size_t
  chosen() const
  {
    return chosen_;
  }

  /** \brief Numbers of the loops that are chosen: one, or both of a junction. */
  std::vector<std::size_t>
  chosenLoops() const;

  /** \brief Choose the one so many places on, round and round. */
  void
  chooseNext(int places = 1);
  void
  choosePrevious()
  {
    chooseNext(-1);
  }

  /** \brief Choose this one. \param[in] number below size() */
  void
  choose(std::size_t number)
  {
    chosen_ = number;
  }

  /** \brief Close the loop, or join the junction. */
  void
  accept()
  {
    decide(true);
  }

  /** \brief Leave the loop open, or do not join the junction. */
  void
  reject()
  {
    decide(false);
  }

  /** \brief Flat, smooth, automatic, one after the other; of a loop only. */
  void
  changeCap();

  /** \brief Take back the last change, and choose what it was about. \return false
   * where there is none */
  bool
  undo();

  /** \brief Changes that undo() can take back. */
  std::size_t
  steps() const
  {
    return steps_.size();
  }

  /** \brief Loops and junctions about which something else is decided than at the start
   * or when it was saved last. Cost: linear. */
  std::size_t
  unsaved() const;
  void
  setSaved()
  {
    saved_ = decisions_;
  }

  /** \brief What is chosen, and what is decided about it, in a line or two. */
  std::string
  tell() const;

private:
  struct Step {
    std::size_t chosen;
    pcl::repair::Decisions before;
  };

  bool
  isLoop() const
  {
    return chosen_ < decisions_.loops.size();
  }
  pcl::repair::JunctionDecision&
  junction()
  {
    return decisions_.junctions[chosen_ - decisions_.loops.size()];
  }
  void
  decide(bool yes);
  void
  remember();

  pcl::repair::Decisions decisions_;
  pcl::repair::Decisions saved_;
  std::size_t chosen_ = 0;
  std::vector<Step> steps_;
};

} // namespace app
