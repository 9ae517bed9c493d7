// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: taking vertices without a triangle out of a mesh.

#pragma once

#include <pcl/pcl_base.h>
#include <pcl/types.h>

#include "mesh/triangle.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief Number the vertices that triangles have anew, in their order.
 * \param[in,out] triangles get the new numbers
 * \return for each vertex there was its number now, UNAVAILABLE where it has none */
inline std::vector<pcl::index_t>
numberWithoutGaps(std::size_t vertices, ccaa::Triangles& triangles)
{
  std::vector<pcl::index_t> number(vertices, pcl::UNAVAILABLE);
  for (const ccaa::Triangle& triangle : triangles)
    for (const pcl::index_t corner : triangle)
      number[static_cast<std::size_t>(corner)] = 0;
  pcl::index_t next = 0;
  for (pcl::index_t& entry : number)
    if (entry != pcl::UNAVAILABLE)
      entry = next++;
  for (ccaa::Triangle& triangle : triangles)
    for (pcl::index_t& corner : triangle)
      corner = number[static_cast<std::size_t>(corner)];
  return number;
}

/** \brief Bring entries, one a vertex, to the places of new numbers. */
template <typename T>
void
renumber(const std::vector<pcl::index_t>& number, std::vector<T>& entries)
{
  std::size_t left = 0;
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] != pcl::UNAVAILABLE)
      entries[left++] = entries[v];
  entries.resize(left);
}

} // namespace pcl::repair
