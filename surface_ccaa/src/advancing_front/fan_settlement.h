// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: one fan for every point in the end.
#pragma once

#include "advancing_front/partial_surface.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::ccaa {

/** \brief Triangles in fans. */
using Fans = std::vector<std::vector<pcl::index_t>>;

/** \brief Triangles at a vertex, those together that are connected by edges at the
 * vertex: each fan ascending, the fans by their lowest ones. \param[in] waiting their
 * numbers \param[in] triangleOf the corners of a number */
template <typename Index, typename TriangleOf>
Fans
fansOf(std::vector<pcl::index_t> waiting, Index vertex, const TriangleOf& triangleOf)
{
  const auto shareEdge = [&](pcl::index_t a, pcl::index_t b) {
    const auto& one = triangleOf(a);
    const auto& other = triangleOf(b);
    return std::any_of(one.begin(), one.end(), [&](Index corner) {
      return corner != vertex &&
             std::find(other.begin(), other.end(), corner) != other.end();
    });
  };
  std::sort(waiting.begin(), waiting.end());
  Fans fans;
  while (!waiting.empty()) {
    std::vector<pcl::index_t> fan{waiting.front()};
    waiting.erase(waiting.begin());
    for (std::size_t i = 0; i < fan.size(); ++i)
      for (std::size_t j = 0; j < waiting.size();)
        if (shareEdge(fan[i], waiting[j])) {
          fan.push_back(waiting[j]);
          waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(j));
        }
        else
          ++j;
    std::sort(fan.begin(), fan.end());
    fans.push_back(std::move(fan));
  }
  return fans;
}

/** \brief Take triangles away until every one of some points has a single fan (C3.4-2):
 * the fan
 * with given triangles stays, else the one with the most triangles, else the one with
 * the earliest (row 3 of table T3.4-1, for points where two stretches of front were
 * left touching each other).
 *
 * \param[in] points whose fans may be several; points of removed triangles are looked
 * at as well
 * \param[in] keep_given never take a given triangle; the given mesh must then have a
 * single fan at each point \param[in,out] control told the work, may be null; after
 * cancelling some points may have several
 * \param[in] whole flags of the points all triangles of which are there: the others
 * are not looked at, and of given fans one that reaches one of these stays; null: all
 * are
 * \return the triangles taken away */
std::vector<pcl::index_t>
settleFans(PartialSurface& surface,
           const std::vector<pcl::index_t>& points,
           bool keep_given,
           RunControl* control = nullptr,
           const std::vector<std::uint8_t>* whole = nullptr);

} // namespace pcl::ccaa
