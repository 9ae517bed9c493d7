// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the working data of one run of a chain.
#include "consecutive/chain_run.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace pcl::ccaa {
namespace {

bool
isFinite(const float* xyz)
{
  return std::isfinite(xyz[0]) && std::isfinite(xyz[1]) && std::isfinite(xyz[2]);
}

/** \brief All points of a cloud, in order. */
bool
isIdentity(const Indices& indices, std::size_t point_count)
{
  if (indices.size() != point_count)
    return false;
  index_t next = 0;
  return std::all_of(indices.begin(), indices.end(), [&next](index_t index) {
    return index == next++;
  });
}

/** \brief Let no corner of the triangles from `first` on be free. */
void
markConnected(const Triangles& triangles,
              std::size_t first,
              std::vector<PointRole>& roles)
{
  for (std::size_t i = first; i < triangles.size(); ++i)
    for (const index_t corner : triangles[i])
      if (roles[static_cast<std::size_t>(corner)] == PointRole::FREE)
        roles[static_cast<std::size_t>(corner)] = PointRole::BOUNDARY;
}

} // namespace

std::string
startName(std::size_t number)
{
  return number == 0 ? "start" : "start " + std::to_string(number + 1);
}

ChainPoints
selectUsablePoints(const PointArray& points,
                   const IndicesPtr& indices,
                   const LoopContext& context)
{
  std::vector<std::size_t> bad(context.blockCount(indices->size()), 0);
  const auto count = [&](std::size_t block, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      bad[block] += isFinite(points[(*indices)[i]]) ? 0 : 1;
  };
  forEachBlock(indices->size(), context, count);
  ChainPoints selected;
  selected.skipped = std::accumulate(bad.begin(), bad.end(), std::size_t{0});
  selected.is_selection = !isIdentity(*indices, points.size);
  selected.usable = indices;
  if (selected.skipped == 0)
    return selected;
  selected.usable = std::make_shared<Indices>();
  selected.usable->reserve(indices->size() - selected.skipped);
  std::copy_if(indices->begin(),
               indices->end(),
               std::back_inserter(*selected.usable),
               [&](index_t index) { return isFinite(points[index]); });
  return selected;
}

IndicesPtr
selectOpenPoints(const ChainRun& run)
{
  const auto open = std::make_shared<Indices>();
  std::copy_if(run.points.usable->begin(),
               run.points.usable->end(),
               std::back_inserter(*open),
               [&](index_t index) {
                 return run.current.roles[static_cast<std::size_t>(index)] !=
                        PointRole::INTERNAL;
               });
  return open;
}

std::size_t
countInternalPoints(const std::vector<PointRole>& roles)
{
  return static_cast<std::size_t>(
      std::count(roles.begin(), roles.end(), PointRole::INTERNAL));
}

std::size_t
countConnectedPoints(const std::vector<PointRole>& roles)
{
  return roles.size() - static_cast<std::size_t>(
                            std::count(roles.begin(), roles.end(), PointRole::FREE));
}

void
keepOnly(const std::vector<index_t>* kept, ChainMesh& chain)
{
  if (kept == nullptr)
    return;
  chain.triangles = pickItems(chain.triangles, *kept);
  chain.labels = pickItems(chain.labels, *kept);
}

void
takeOver(Triangles triangles,
         const std::vector<index_t>* kept,
         std::uint8_t label,
         ChainMesh& chain)
{
  if (kept != nullptr) {
    chain.labels = pickItems(chain.labels, *kept);
    std::fill(chain.roles.begin(), chain.roles.end(), PointRole::FREE);
    markConnected(triangles, 0, chain.roles);
  }
  else
    markConnected(triangles, chain.labels.size(), chain.roles);
  chain.triangles = std::move(triangles);
  chain.labels.resize(chain.triangles.size(), label);
}

} // namespace pcl::ccaa
