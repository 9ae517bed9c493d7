// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: closes what is open where tiles disagreed.
#include "tiles/seam.h"

#include <pcl/surface_ccaa/impl/cloud_runs.h>

#include "advancing_front/fan_settlement.h"
#include "mesh/block_loop.h"
#include "mesh/box_tree.h"
#include "mesh/intersection.h"
#include "mesh/winding.h"
#include "tiles/facing.h"
#include "tiles/seam_settlement.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl::ccaa {
namespace {

/** Times that a ring of triangles around what could not be closed is taken away. */
constexpr int RINGS = 2;

/** What one try makes of a seam. */
struct Attempt {
  Triangles given;                   /**< that stay */
  std::vector<pcl::index_t> removed; /**< of the seam's, ascending */
  Triangles hidden;                  /**< given ones that stay, too, but that the base
                                          algorithm does not see */
  std::vector<std::uint8_t> is_open;
  Triangles added;
  std::vector<pcl::index_t> flawed; /**< open points that are free or on a boundary */
  std::size_t flaws = 0;            /**< free ones, and boundary edges */
  std::string error;
};

/** One run. */
class SeamClosing {
public:
  SeamClosing(const Seam& seam,
              const CompletionParameters& parameters,
              int threads,
              const ProgressCallback& progress)
  : seam_(seam), parameters_(parameters), threads_(threads), progress_(progress)
  {
    parameters_.keep_given = true;
  }

  SeamFilling
  run()
  {
    given_ = seam_.given;
    const Winding pieces = wind();
    turnAsMade(seam_, pieces, given_);
    Attempt best = widen();
    if (!best.flawed.empty() && turnToFace(seam_, pieces, given_)) {
      Attempt faced = widen();
      if (faced.error.empty() && faced.flaws < best.flaws)
        best = std::move(faced);
    }
    return {std::move(best.added), std::move(best.removed), std::move(best.error)};
  }

private:
  Attempt
  widen() const
  {
    Attempt best = attempt(std::vector<std::uint8_t>(seam_.given.size(), 0));
    for (int ring = 0; ring < RINGS && !best.flawed.empty(); ++ring) {
      Attempt wider = attempt(aroundFlaws(best));
      if (wider.error.empty() && wider.flaws < best.flaws)
        best = std::move(wider);
    }
    return best;
  }

  /** \param[in] goes flags of given triangles that are to be made anew */
  Attempt
  attempt(const std::vector<std::uint8_t>& goes) const
  {
    Attempt result;
    SettledSeam settled = settleSeam(seam_, goes, is_twisted_, threads_);
    for (const pcl::index_t t : settled.shown)
      result.given.push_back(given_[static_cast<std::size_t>(t)]);
    for (const pcl::index_t t : settled.hidden)
      result.hidden.push_back(given_[static_cast<std::size_t>(t)]);
    result.removed = std::move(settled.removed);
    result.is_open = std::move(settled.is_open);
    complete(result);
    keepClear(result);
    findFlaws(result);
    return result;
  }

  /** All triangles of a piece alike, whichever way. Those of a one-sided piece that
   * cannot be are twisted: by one thread, as others would find other ones. */
  Winding
  wind()
  {
    TriangleAdjacency adjacency;
    adjacency.build(given_, seam_.points.size(), threads_);
    Winding winding;
    RunControl control;
    winding.find(given_, adjacency, 1, control);
    for (std::size_t t = 0; t < given_.size(); ++t)
      if (winding.isTurned(t))
        adjacency.turn(static_cast<pcl::index_t>(t), given_);
    is_twisted_ = findDisagreements(given_, adjacency, {threads_});
    return winding;
  }

  void
  complete(Attempt& result) const
  {
    PolygonMesh frozen;
    for (const Triangle& triangle : result.given) {
      frozen.polygons.emplace_back();
      frozen.polygons.back().vertices.assign(triangle.begin(), triangle.end());
    }
    CompletionInput input;
    input.points = {seam_.points.front().data(), 3, seam_.points.size()};
    input.selection = std::make_shared<Indices>(seam_.points.size());
    std::iota(input.selection->begin(), input.selection->end(), 0);
    input.threads = static_cast<unsigned int>(threads_);
    input.progress = progress_;
    input.partial_mesh = &frozen;
    const auto cut_points = std::make_shared<Indices>();
    for (std::size_t v = 0; v < result.is_open.size(); ++v)
      if (result.is_open[v] == 0)
        cut_points->push_back(static_cast<pcl::index_t>(v));
    input.cut_points = cut_points;
    CompletionReport report;
    const CompletionOutput output = runCompletion(input, parameters_, report);
    result.error = output.error;
    for (std::size_t t = result.given.size(); t < output.polygons.size(); ++t) {
      const Indices& corners = output.polygons[t].vertices;
      result.added.push_back({corners[0], corners[1], corners[2]});
    }
  }

  /** All of a triangle lies as near to a corner as its edges there are long. */
  bool
  isInRoom(const Triangle& triangle) const
  {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto at = [&](std::size_t corner) {
        return static_cast<std::size_t>(triangle[corner % 3]);
      };
      const Eigen::Vector3f& corner = seam_.points[at(i)];
      if (std::max((seam_.points[at(i + 1)] - corner).norm(),
                   (seam_.points[at(i + 2)] - corner).norm()) <= seam_.room[at(i)])
        return true;
    }
    return false;
  }

  Corners
  cornersAt(const Triangle& triangle) const
  {
    return cornersOf(triangle, PointView(seam_.points));
  }

  /** What leaves the room could meet what closes another group. What meets a triangle
   * that the base algorithm did not see goes as well. */
  void
  keepClear(Attempt& result) const
  {
    std::vector<Box> boxes;
    for (const Triangle& triangle : result.hidden)
      boxes.push_back(boxOf(cornersAt(triangle)));
    const BoxTree hidden(boxes);
    const auto meetsHidden = [&](const Corners& corners) {
      return hidden.anyMeeting(corners, [&](pcl::index_t t) {
        return trianglesMeet(corners, cornersAt(result.hidden[std::size_t(t)]));
      });
    };
    std::vector<pcl::index_t> outside, corners;
    for (std::size_t t = 0; t < result.added.size(); ++t)
      if (!isInRoom(result.added[t]) || meetsHidden(cornersAt(result.added[t]))) {
        outside.push_back(static_cast<pcl::index_t>(t));
        corners.insert(corners.end(), result.added[t].begin(), result.added[t].end());
      }
    if (outside.empty())
      return;
    TriangleAdjacency adjacency;
    adjacency.build(result.given, seam_.points.size(), threads_);
    const PointView points(seam_.points);
    PartialSurface surface(result.given, adjacency, points, OrientationHints());
    for (const Triangle& triangle : result.added)
      surface.add(triangle);
    const auto first = static_cast<pcl::index_t>(result.given.size());
    for (const pcl::index_t t : outside)
      surface.remove(first + t);
    settleFans(surface, corners, true);
    Triangles staying;
    for (std::size_t t = 0; t < result.added.size(); ++t)
      if (surface.isAlive(first + static_cast<pcl::index_t>(t)))
        staying.push_back(result.added[t]);
    result.added = std::move(staying);
  }

  void
  findFlaws(Attempt& result) const
  {
    Triangles all = result.given;
    all.insert(all.end(), result.added.begin(), result.added.end());
    TriangleAdjacency adjacency;
    adjacency.build(all, seam_.points.size(), threads_);
    for (std::size_t v = 0; v < seam_.points.size(); ++v)
      if (result.is_open[v] != 0 && adjacency.fans()[v] != Fan::CLOSED) {
        result.flawed.push_back(static_cast<pcl::index_t>(v));
        result.flaws += adjacency.fans()[v] == Fan::NONE ? 1 : 0;
      }
    for (std::size_t t = 0; t < all.size(); ++t)
      for (int corner = 0; corner < 3; ++corner)
        if (adjacency.across(static_cast<pcl::index_t>(t), corner) < 0)
          ++result.flaws;
  }

  /** Given triangles at a flaw, and those that are gone already around it. */
  std::vector<std::uint8_t>
  aroundFlaws(const Attempt& result) const
  {
    std::vector<std::uint8_t> is_flawed(seam_.points.size(), 0);
    for (const pcl::index_t v : result.flawed)
      is_flawed[static_cast<std::size_t>(v)] = 1;
    std::vector<std::uint8_t> goes(seam_.given.size(), 0);
    for (const pcl::index_t t : result.removed)
      goes[static_cast<std::size_t>(t)] = 1;
    for (std::size_t t = 0; t < goes.size(); ++t) {
      const Triangle& corners = seam_.given[t];
      if (allCorners(corners, seam_.is_near) && anyCorner(corners, is_flawed))
        goes[t] = 1;
    }
    return goes;
  }

  const Seam& seam_;
  Triangles given_;                      /**< the seam's, each piece wound alike */
  std::vector<std::uint8_t> is_twisted_; /**< flags of those that cannot be */
  CompletionParameters parameters_;
  int threads_;
  const ProgressCallback& progress_;
};

} // namespace

SeamFilling
closeSeam(const Seam& seam,
          const CompletionParameters& parameters,
          int threads,
          const ProgressCallback& progress)
{
  if (seam.points.size() < 3)
    return {};
  return SeamClosing(seam, parameters, threads, progress).run();
}

} // namespace pcl::ccaa
