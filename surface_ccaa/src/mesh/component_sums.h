// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: sums over the triangles of each component, in parallel.
#pragma once

#include "mesh/block_loop.h"
#include "mesh/winding.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::ccaa {

/** \brief One flag for each component. */
using ComponentFlags = std::vector<unsigned char>;

/** \brief Part of the list of triangles, all of one component. */
struct ComponentPiece {
  std::size_t component;
  std::size_t begin;
  std::size_t end;
};

/** \brief Triangles listed component by component, ascending in each. */
inline std::vector<pcl::index_t>
sortByComponent(const Winding& winding, std::size_t triangles)
{
  const auto& components = winding.components();
  std::vector<std::size_t> next(components.size(), 0);
  for (std::size_t i = 1; i < components.size(); ++i)
    next[i] = next[i - 1] + components[i - 1].triangles;
  std::vector<pcl::index_t> sorted(triangles);
  for (std::size_t i = 0; i < sorted.size(); ++i)
    sorted[next[winding.componentOf(i)]++] = static_cast<pcl::index_t>(i);
  return sorted;
}

/** \brief That list cut into pieces of at most 8192 triangles, wanted components only.
 */
inline std::vector<ComponentPiece>
cutIntoPieces(const Winding& winding, const ComponentFlags& wanted)
{
  /** Triangles: enough for a task, and the same for any number of threads. */
  constexpr std::size_t PIECE_SIZE = 8192;
  std::vector<ComponentPiece> pieces;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const std::size_t end = begin + winding.components()[i].triangles;
    for (std::size_t at = begin; wanted[i] != 0 && at < end; at += PIECE_SIZE)
      pieces.push_back({i, at, std::min(at + PIECE_SIZE, end)});
    begin = end;
  }
  return pieces;
}

/** \brief For each wanted component the sum of what addTriangle(component, triangle,
 * sum) adds over its triangles; Sum has add(const Sum&). The order of additions depends
 * on the mesh only, so the last bit is the same for any number of threads. */
template <typename Sum, typename AddTriangle>
std::vector<Sum>
sumByComponent(const Winding& winding,
               std::size_t triangles,
               const ComponentFlags& wanted,
               const LoopContext& context,
               const AddTriangle& addTriangle)
{
  std::vector<Sum> sums(wanted.size());
  const std::vector<ComponentPiece> pieces = cutIntoPieces(winding, wanted);
  if (pieces.empty())
    return sums;
  const std::vector<pcl::index_t> sorted = sortByComponent(winding, triangles);
  std::vector<Sum> parts(pieces.size());
  LoopContext piecewise = context;
  piecewise.block_size = 1;
  const auto sumPiece = [&](std::size_t, std::size_t i, std::size_t) {
    Sum sum;
    for (std::size_t at = pieces[i].begin; at < pieces[i].end; ++at)
      addTriangle(pieces[i].component, static_cast<std::size_t>(sorted[at]), sum);
    parts[i] = sum;
  };
  forEachBlock(pieces.size(), piecewise, sumPiece);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    sums[pieces[i].component].add(parts[i]);
  return sums;
}

} // namespace pcl::ccaa
