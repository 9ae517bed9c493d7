// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which algorithm of a chain has made which triangle.
#pragma once

#include <pcl/types.h>

#include "mesh/block_loop.h"
#include "mesh/triangle.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::ccaa {

/** \brief For each triangle the number of the algorithm in the chain that made it: 0
 * the first start algorithm, ..., the last the base algorithm. */
using TriangleLabels = std::vector<std::uint8_t>;

/** \brief Whether `result` begins with the triangles of `given`, in their order.
 * Winding and first corner may differ. \param[in] kept numbers
 * of the given ones to be looked for, ascending; null: all */
bool
keepsTriangles(const Triangles& given,
               const std::vector<pcl::index_t>* kept,
               const Triangles& result,
               const LoopContext& context);

/** \brief Only the items with these numbers. */
template <typename Item>
std::vector<Item>
pickItems(const std::vector<Item>& items, const std::vector<pcl::index_t>& numbers)
{
  std::vector<Item> picked;
  picked.reserve(numbers.size());
  for (const pcl::index_t number : numbers)
    picked.push_back(items[static_cast<std::size_t>(number)]);
  return picked;
}

/** \brief The labels of what a filter has left.
 *
 * One pass when the filter keeps the order, as UmbrellaFilter does; else triangles are
 * looked up. Winding and first corner may differ.
 * \return nothing when one of the survivors was not given, or was given less often */
std::optional<TriangleLabels>
labelsOfSurvivors(const Triangles& given,
                  const TriangleLabels& labels,
                  const Triangles& survivors);

/** \brief Put the triangles that are not there yet behind those that are, each once.
 * \param[in] made winding and first corner do not tell them apart
 * \param[in] label of the new ones */
void
appendNewTriangles(const Triangles& made,
                   std::uint8_t label,
                   Triangles& triangles,
                   TriangleLabels& labels);

} // namespace pcl::ccaa
