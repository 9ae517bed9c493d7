// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the classes of incomplete models (D4.1-4).

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace repair {

enum class IcmClass : std::uint8_t {
  ICM1, /**< one region; simple holes only, or none */
  ICM2, /**< one region, at least one complex hole */
  ICM3  /**< several islands */
};

/** \brief The counts that decide the class. */
struct IcmCounts {
  std::size_t islands = 0;
  std::size_t simple_holes = 0;
  std::size_t complex_holes = 0;
};

/** \brief Edges up to which a hole is simple for the thesis' darning method (4.7). */
constexpr std::size_t SIMPLE_HOLE_EDGES = 12;

IcmClass
classOf(const IcmCounts& counts);

/** \brief Count holes by their number of edges.
 * \param[in] hole_edges of each hole \param[in] simple_edges at most so many: simple */
IcmCounts
countHoles(std::size_t islands,
           const std::vector<std::size_t>& hole_edges,
           std::size_t simple_edges = SIMPLE_HOLE_EDGES);

} // namespace repair
} // namespace pcl
