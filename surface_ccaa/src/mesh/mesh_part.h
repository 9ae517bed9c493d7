// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: labelling a range of triangles with components and turns.
#pragma once

#include "mesh/label_sets.h"
#include "mesh/winding.h"
#include "run/threads.h"

#include <cstddef>
#include <vector>

namespace pcl::ccaa {

/** \brief Two states on both sides of a border between parts that are the same. */
struct BorderEdge {
  pcl::index_t lower_triangle;
  pcl::index_t state;  /**< in the part of the higher triangle */
  pcl::index_t change; /**< 1 when the lower triangle's state has to be turned */
};

/** \brief A range of triangles one thread labels on its own.
 *
 * Triangles are taken in ascending order, each gets the label of a lower neighbour, or
 * a new one when it has none; labels that meet are joined. Unlike a walk from neighbour
 * to neighbour this reads memory in order, which is what the time goes into.
 */
class MeshPart {
public:
  MeshPart(std::size_t begin, std::size_t end) : begin_(begin), end_(end) {}

  void
  label(const Triangles& triangles,
        const TriangleAdjacency& adjacency,
        const CutEdges& cut,
        std::vector<pcl::index_t>& state,
        RunControl& control)
  {
    for (std::size_t i = begin_; i < end_; ++i) {
      state[i] = labelOne(i, triangles, adjacency, cut, state);
      WoundComponent& label = labels[static_cast<std::size_t>(state[i] >> 1)];
      ++label.triangles;
      label.turned += static_cast<std::size_t>(state[i] & 1);
      if ((i - begin_) % POLL_INTERVAL != 0)
        continue;
      if (threadIndex() == 0)
        control.report("orientation",
                       static_cast<double>(i - begin_) /
                           static_cast<double>(end_ - begin_));
      if (control.cancelled())
        return;
    }
  }

  std::size_t
  begin() const
  {
    return begin_;
  }
  std::size_t
  end() const
  {
    return end_;
  }

  LabelSets sets;
  std::vector<WoundComponent> labels;
  std::vector<BorderEdge> border;

private:
  static constexpr pcl::index_t NO_STATE = -1;

  /** \brief Triangles between two looks at the run control; about a millisecond. */
  static constexpr std::size_t POLL_INTERVAL = 65536;

  pcl::index_t
  labelOne(std::size_t index,
           const Triangles& triangles,
           const TriangleAdjacency& adjacency,
           const CutEdges& cut,
           const std::vector<pcl::index_t>& state)
  {
    const auto current = static_cast<pcl::index_t>(index);
    const Triangle& triangle = triangles[index];
    const std::size_t first_border = border.size();
    pcl::index_t own = NO_STATE;
    bool closed = true;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const pcl::index_t other = adjacency.across(current, static_cast<int>(corner));
      closed = closed && other >= 0;
      if (other < 0 || other > current ||
          (!cut.empty() && (cut[index] >> corner & 1) != 0))
        continue;
      const auto lower = static_cast<std::size_t>(other);
      const pcl::index_t change = runsAlong(
          triangles[lower], triangle[corner], triangle[corner == 2 ? 0 : corner + 1]);
      if (lower < begin_)
        border.push_back({other, 0, change});
      else
        own = meet(own, state[lower] ^ change);
    }
    if (own == NO_STATE)
      own = addLabel(current);
    for (std::size_t i = first_border; i < border.size(); ++i)
      border[i].state = own;
    WoundComponent& label = labels[static_cast<std::size_t>(own >> 1)];
    label.closed = label.closed && closed;
    return own;
  }

  /** \brief The state a triangle has after another neighbour wants this one. */
  pcl::index_t
  meet(pcl::index_t own, pcl::index_t wanted)
  {
    if (own == NO_STATE || own == wanted)
      return wanted;
    if (!sets.join(own, wanted))
      labels[static_cast<std::size_t>(own >> 1)].one_sided = true;
    return sets.find(own);
  }

  pcl::index_t
  addLabel(pcl::index_t first_triangle)
  {
    labels.emplace_back();
    labels.back().first_triangle = first_triangle;
    return sets.add();
  }

  std::size_t begin_;
  std::size_t end_;
};

} // namespace pcl::ccaa
