// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which given triangles of a seam stay.
#include "tiles/seam_settlement.h"

#include "advancing_front/fan_settlement.h"
#include "mesh/block_loop.h"
#include "mesh/polygon_access.h"

#include <algorithm>
#include <utility>

namespace pcl::ccaa {
namespace {

/** One run. */
class SeamSettlement {
public:
  SeamSettlement(const Seam& seam, int threads) : seam_(seam), threads_(threads)
  {
    result_.is_open = seam.is_open;
  }

  SettledSeam
  run(const std::vector<std::uint8_t>& goes,
      const std::vector<std::uint8_t>& is_twisted)
  {
    TriangleAdjacency adjacency;
    adjacency.build(seam_.given, seam_.points.size(), threads_);
    const PointView points(seam_.points);
    PartialSurface surface(seam_.given, adjacency, points, OrientationHints());
    std::vector<pcl::index_t> looked_at;
    for (std::size_t v = 0; v < seam_.points.size(); ++v)
      if (const Fan fan = adjacency.fans()[v];
          fan == Fan::SEVERAL || fan == Fan::OVERFULL)
        looked_at.push_back(static_cast<pcl::index_t>(v));
    for (std::size_t t = 0; t < goes.size(); ++t)
      if (goes[t] != 0 || is_twisted[t] != 0) {
        surface.remove(static_cast<pcl::index_t>(t));
        looked_at.insert(looked_at.end(), seam_.given[t].begin(), seam_.given[t].end());
        if (goes[t] != 0)
          open(seam_.given[t]);
      }
    settleFans(surface, looked_at, false, nullptr, &seam_.is_whole);
    const std::vector<pcl::index_t> gone = goneFrom(surface);
    keepAtRim(gone);
    hideAtRim(surface);
    for (std::size_t t = 0; t < seam_.given.size(); ++t)
      if (const auto i = static_cast<pcl::index_t>(t); surface.isAlive(i))
        result_.shown.push_back(i);
      else if (!std::binary_search(result_.removed.begin(), result_.removed.end(), i))
        result_.hidden.push_back(i);
    return std::move(result_);
  }

private:
  const Triangle&
  at(pcl::index_t t) const
  {
    return seam_.given[static_cast<std::size_t>(t)];
  }

  void
  open(const Triangle& triangle)
  {
    for (const pcl::index_t corner : triangle)
      result_.is_open[static_cast<std::size_t>(corner)] = 1;
  }

  std::vector<pcl::index_t>
  goneFrom(const PartialSurface& surface) const
  {
    std::vector<pcl::index_t> gone;
    for (std::size_t t = 0; t < seam_.given.size(); ++t)
      if (!surface.isAlive(static_cast<pcl::index_t>(t)))
        gone.push_back(static_cast<pcl::index_t>(t));
    return gone;
  }

  /** Where not all triangles of a point are given, the rest may look like several fans:
   * what is not shown to the base algorithm for that stays, and nothing grows from it.
   */
  void
  hideAtRim(PartialSurface& surface)
  {
    std::vector<pcl::index_t> rim;
    for (std::size_t v = 0; v < seam_.points.size(); ++v)
      if (seam_.is_whole[v] == 0)
        rim.push_back(static_cast<pcl::index_t>(v));
    for (const pcl::index_t t : settleFans(surface, rim, false))
      for (const pcl::index_t corner : at(t))
        result_.is_open[static_cast<std::size_t>(corner)] = 0;
  }

  /** Of what is gone, triangles at the rim stay: what is left there could be several
   * fans, of which one is not given. So do those at points where that leaves several.
   */
  void
  keepAtRim(const std::vector<pcl::index_t>& gone)
  {
    const std::vector<std::uint8_t> is_open = result_.is_open;
    std::vector<std::uint8_t> is_fixed(seam_.points.size(), 0);
    do {
      result_.is_open = is_open;
      result_.removed.clear();
      removeForGood(gone, is_fixed);
    }
    while (result_.removed.size() < gone.size() && fixSplitFans(is_fixed));
  }

  /** Those connected with open points by others of them; their corners are open. */
  void
  removeForGood(std::vector<pcl::index_t> gone,
                const std::vector<std::uint8_t>& is_fixed)
  {
    const auto goesForGood = [&](pcl::index_t t) {
      return anyCorner(at(t), seam_.is_open) ||
             (anyCorner(at(t), result_.is_open) && allCorners(at(t), seam_.is_whole) &&
              !anyCorner(at(t), is_fixed));
    };
    for (auto more = gone.end(); !gone.empty(); gone.erase(more, gone.end())) {
      more = std::stable_partition(
          gone.begin(), gone.end(), [&](pcl::index_t t) { return !goesForGood(t); });
      if (more == gone.end())
        break;
      result_.removed.insert(result_.removed.end(), more, gone.end());
      for (auto t = more; t != gone.end(); ++t)
        open(at(*t));
    }
    std::sort(result_.removed.begin(), result_.removed.end());
  }

  /** Flags points at which the removal leaves several fans, but for disputes, at which
   * there may have been several. \return whether there are more of them now */
  bool
  fixSplitFans(std::vector<std::uint8_t>& is_fixed) const
  {
    AliveFlags stays(seam_.given.size(), 1);
    for (const pcl::index_t t : result_.removed)
      stays[static_cast<std::size_t>(t)] = 0;
    TriangleAdjacency adjacency;
    adjacency.build(
        liveTriangles(seam_.given, stays, {threads_}), seam_.points.size(), threads_);
    bool any = false;
    for (const pcl::index_t t : result_.removed)
      for (const pcl::index_t corner : at(t)) {
        const auto v = static_cast<std::size_t>(corner);
        if (adjacency.fan(corner) != Fan::SEVERAL || seam_.is_open[v] != 0 ||
            is_fixed[v] != 0)
          continue;
        is_fixed[v] = 1;
        any = true;
      }
    return any;
  }

  const Seam& seam_;
  int threads_;
  SettledSeam result_;
};

} // namespace

SettledSeam
settleSeam(const Seam& seam,
           const std::vector<std::uint8_t>& goes,
           const std::vector<std::uint8_t>& is_twisted,
           int threads)
{
  return SeamSettlement(seam, threads).run(goes, is_twisted);
}

} // namespace pcl::ccaa
