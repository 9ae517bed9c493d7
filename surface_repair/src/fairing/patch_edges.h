// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a patch whose edges can be split and flipped.

#pragma once

#include "filling/patch.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <vector>

namespace pcl::repair {

/** \brief The sides of a patch's triangles, and which of them lie against each other.
 *
 * Side 3 t + c runs from corner c of triangle t to the next one. What has no side
 * against it, or more than one, is a border: it is neither split nor flipped. All that
 * changes the patch's triangles has to go through here.
 */
class PatchEdges {
public:
  static constexpr std::uint32_t BORDER = 0xffffffffu;

  /** \brief A side seen from its triangle (a, b, c) and the one beyond, (b, a, d). */
  struct Pair {
    std::size_t a, b, c, d;
  };

  /** \brief \param[in,out] patch outlives this; no other vertex comes in meanwhile */
  PatchEdges(const IncompleteModel& model, Patch& patch);

  std::size_t
  count() const
  {
    return across_.size();
  }
  bool
  isInner(std::size_t side) const
  {
    return across_[side] != BORDER;
  }
  /** \brief Of the two sides of an inner edge the one that speaks for it. */
  bool
  speaks(std::size_t side) const
  {
    return isInner(side) && side < across_[side];
  }
  std::size_t
  from(std::size_t side) const
  {
    return corner(side / 3, side % 3);
  }
  std::size_t
  to(std::size_t side) const
  {
    return corner(side / 3, (side + 1) % 3);
  }
  /** \brief The side against an inner one. */
  std::size_t
  across(std::size_t side) const
  {
    return across_[side];
  }
  /** \brief The four vertices around an inner side. */
  Pair
  pairAt(std::size_t side) const;

  /** \brief Whether two vertices are the ends of an edge of the patch. */
  bool
  areJoined(std::size_t a, std::size_t b) const
  {
    return edges_.count(key(a, b)) != 0;
  }
  /** \brief Whether two vertices of the rim are the ends of an edge of the model. */
  bool
  areJoinedInModel(std::size_t a, std::size_t b) const;

  /** \brief Put a new vertex on an inner edge. \return its number */
  std::size_t
  split(std::size_t side, const Position& place);

  /** \brief Sides of some triangles with none of these beyond. */
  std::vector<std::size_t>
  borderOf(const std::vector<std::size_t>& disc) const;

  /** \brief Replace triangles that make a disc without an inner vertex by those
   * between its border and a new vertex. \return its number */
  std::size_t
  star(std::vector<std::size_t> disc, const Position& place);

  /** \brief Replace inner edge a-b by c-d; the caller has seen to it that it is not
   * there yet. */
  void
  flip(std::size_t side);

private:
  static std::uint64_t
  key(std::size_t a, std::size_t b);
  std::size_t
  corner(std::size_t triangle, std::size_t place) const
  {
    return static_cast<std::size_t>(patch_.triangles[triangle][place]);
  }
  void
  setTriangle(std::size_t triangle,
              const std::array<std::size_t, 3>& corners,
              const std::array<std::uint32_t, 3>& beyond);

  const IncompleteModel& model_;
  Patch& patch_;
  std::vector<std::uint32_t> across_;
  std::unordered_set<std::uint64_t> edges_; /**< for look-up only: has no order */
};

} // namespace pcl::repair
