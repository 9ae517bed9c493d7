// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: table T3.4-1 applied until every point has one chain.
#include "umbrella/chain_elimination.h"

#include "mesh/sort_unique.h"
#include "umbrella/chain_case.h"

namespace pcl::ccaa {
namespace {

using Worklist = std::vector<pcl::index_t>;

/** Few enough points that also a short worklist keeps several threads busy. */
constexpr std::size_t WORKLIST_BLOCK = 512;

Fan
fanOf(ChainCase row)
{
  switch (row) {
  case ChainCase::NO_CHAIN:
    return Fan::NONE;
  case ChainCase::ONE_CLOSED:
    return Fan::CLOSED;
  case ChainCase::ONE_OPEN:
    return Fan::OPEN;
  default:
    return Fan::SEVERAL;
  }
}

/** \brief Append the triangles of all chains but one. */
void
rejectChains(const PointChains& chains,
             std::optional<std::size_t> survivor,
             std::vector<pcl::index_t>& rejected)
{
  for (std::size_t place = 0; place < chains.chains().size(); ++place) {
    if (survivor == place)
      continue;
    const FanChain& chain = chains.chains()[place];
    const auto first =
        chains.triangles().begin() + static_cast<std::ptrdiff_t>(chain.first);
    rejected.insert(
        rejected.end(), first, first + static_cast<std::ptrdiff_t>(chain.size));
  }
}

/** \brief The vertices that have to be looked at: all with more than one chain. */
Worklist
suspectVertices(const std::vector<Fan>& fans, const LoopContext& context)
{
  std::vector<Worklist> parts(context.blockCount(fans.size()));
  forEachBlock(
      fans.size(), context, [&](std::size_t block, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          if (fans[i] == Fan::SEVERAL || fans[i] == Fan::OVERFULL)
            parts[block].push_back(static_cast<pcl::index_t>(i));
      });
  return joinBlocks(parts);
}

/** \brief Delete triangles; some may be named more than once.
 * \return the corners they had, each once, ascending */
Worklist
deleteTriangles(const Triangles& triangles,
                const std::vector<pcl::index_t>& rejected,
                AliveFlags& alive,
                std::size_t& deleted)
{
  Worklist corners;
  for (const auto item : rejected) {
    const auto triangle = static_cast<std::size_t>(item);
    if (alive[triangle] == 0)
      continue;
    alive[triangle] = 0;
    ++deleted;
    corners.insert(
        corners.end(), triangles[triangle].begin(), triangles[triangle].end());
  }
  sortUnique(corners);
  return corners;
}

} // namespace

std::size_t
eliminateChains(const Triangles& triangles,
                const TriangleAdjacency& adjacency,
                const Positions& positions,
                const LoopContext& context,
                AliveFlags& alive,
                std::vector<Fan>& fans)
{
  LoopContext round = context;
  round.block_size = WORKLIST_BLOCK;
  std::size_t deleted = 0;
  Worklist worklist = suspectVertices(fans, context);
  while (!worklist.empty() && !context.cancelled()) {
    std::vector<std::vector<pcl::index_t>> rejected(round.blockCount(worklist.size()));
    const auto examine = [&](std::size_t block, std::size_t begin, std::size_t end) {
      PointChains chains;
      for (std::size_t i = begin; i < end; ++i) {
        const auto vertex = worklist[i];
        chains.find(triangles, adjacency, vertex, &alive);
        fans[static_cast<std::size_t>(vertex)] = fanOf(classifyChains(chains));
        if (chains.chains().size() > 1)
          rejectChains(chains,
                       survivingChain(chains, triangles, positions, vertex),
                       rejected[block]);
      }
    };
    forEachBlock(worklist.size(), round, examine);
    worklist = deleteTriangles(triangles, joinBlocks(rejected), alive, deleted);
  }
  return deleted;
}

} // namespace pcl::ccaa
