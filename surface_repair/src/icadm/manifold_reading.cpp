// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: brings a mesh that is no ICADM there, cut at its faults.
#include "icadm/manifold_reading.h"

#include "icadm/edge_sheets.h"
#include "icadm/model_assembly.h"
#include "icadm/vertex_numbers.h"
#include "mesh/cloud_access.h"
#include "mesh/islands.h"
#include "mesh/orientation.h"
#include "mesh/sort_unique.h"
#include "umbrella/twist_cut.h"

#include <algorithm>
#include <utility>

namespace pcl::repair {
namespace {

/** \brief Turn islands back whose given windings mostly agree.
 * \return how many triangles differ from the input now */
std::size_t
keepGivenSides(const Triangles& given,
               ccaa::TriangleAdjacency& adjacency,
               Triangles& triangles)
{
  const ccaa::Islands islands = ccaa::labelIslands(adjacency);
  std::vector<std::size_t> sizes(islands.count, 0);
  std::vector<std::size_t> votes(islands.count, 0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    ++sizes[islands[t]];
    votes[islands[t]] += triangles[t] != given[t] ? 1 : 0;
  }
  std::size_t reversed = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto against = static_cast<double>(votes[islands[t]]);
    const auto all = static_cast<double>(sizes[islands[t]]);
    if (2.0 * against - all >= ccaa::VOTE_MARGIN * all)
      adjacency.turn(static_cast<pcl::index_t>(t), triangles);
    reversed += triangles[t] != given[t] ? 1 : 0;
  }
  return reversed;
}

/** \brief Triangles that are there already, with the same corners in any order; only
 * where the adjacency shows a fault can there be any. */
std::vector<pcl::index_t>
repeatedTriangles(const Triangles& triangles, const ccaa::TriangleAdjacency& adjacency)
{
  std::vector<std::pair<Triangle, pcl::index_t>> sorted;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    Triangle corners = triangles[t];
    const ccaa::Fan fan = adjacency.fan(corners[0]);
    if (fan != ccaa::Fan::SEVERAL && fan != ccaa::Fan::OVERFULL)
      continue;
    std::sort(corners.begin(), corners.end());
    sorted.emplace_back(corners, static_cast<pcl::index_t>(t));
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<pcl::index_t> repeated;
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i].first == sorted[i - 1].first)
      repeated.push_back(sorted[i].second);
  return repeated;
}

/** \brief One run of bringToManifold(). */
class ManifoldReading {
public:
  ManifoldReading(ccaa::PolygonTriangles& mesh,
                  ccaa::TriangleAdjacency& adjacency,
                  const pcl::PCLPointCloud2& cloud,
                  const ccaa::LoopContext& context,
                  ReadingReport& report)
  : mesh_(mesh)
  , adjacency_(adjacency)
  , cloud_(cloud)
  , context_(context)
  , report_(report)
  {}

  void
  run()
  {
    if (!isManifold(adjacency_))
      cut();
    if (context_.cancelled() || isConsistentlyWound(mesh_.triangles, adjacency_))
      return;
    removeTwists();
    if (!context_.cancelled())
      windAlike();
  }

private:
  void
  cut()
  {
    const auto repeated = repeatedTriangles(mesh_.triangles, adjacency_);
    report_.repeated_triangles = repeated.size();
    if (!repeated.empty())
      remove(repeated);
    report_.overfull_edges = adjacency_.overfullEdges().size();
    separate();
  }

  /** \brief Give sheets and fans vertices of their own. */
  void
  separate()
  {
    if (context_.cancelled() || isManifold(adjacency_))
      return;
    PointFans split = cutAtFaults(mesh_.triangles, adjacency_, positions());
    mesh_.triangles = std::move(split.triangles);
    for (const pcl::index_t vertex : split.vertices)
      mesh_.point_of_vertex.push_back(
          pcl::index_t(mesh_.point_of_vertex[static_cast<std::size_t>(vertex)]));
    report_.separated_fans += split.vertices.size();
    buildAdjacency();
    if (!context_.cancelled() && !isManifold(adjacency_))
      report_.problem = "the mesh could not be cut where it is no manifold";
  }

  void
  removeTwists()
  {
    for (;;) {
      const auto twists = ccaa::findTwists(
          mesh_.triangles, adjacency_, positions(), ccaa::TwistLimits(), context_);
      if (twists.empty() || context_.cancelled())
        return;
      report_.twist_triangles += twists.size();
      remove(twists);
      separate();
    }
  }

  void
  remove(const std::vector<pcl::index_t>& triangles)
  {
    ccaa::AliveFlags alive(mesh_.triangles.size(), 1);
    for (const pcl::index_t triangle : triangles)
      alive[static_cast<std::size_t>(triangle)] = 0;
    mesh_.triangles = ccaa::liveTriangles(mesh_.triangles, alive, context_);
    renumber(numberWithoutGaps(mesh_.point_of_vertex.size(), mesh_.triangles),
             mesh_.point_of_vertex);
    buildAdjacency();
  }

  void
  windAlike()
  {
    const Positions normals =
        entriesOf(ccaa::normalView(cloud_), mesh_.point_of_vertex);
    const Positions viewpoints =
        entriesOf(ccaa::viewpointView(cloud_), mesh_.point_of_vertex);
    ccaa::OrientationHints hints;
    hints.normals = normals;
    hints.viewpoints = viewpoints;
    hints.threads = context_.threads;
    ccaa::RunControl unwatched;
    const Triangles given = mesh_.triangles;
    ccaa::orientTriangles(mesh_.triangles,
                          adjacency_,
                          positions(),
                          hints,
                          context_.control != nullptr ? *context_.control : unwatched);
    if (!context_.cancelled())
      report_.reversed_triangles = keepGivenSides(given, adjacency_, mesh_.triangles);
  }

  Positions
  positions() const
  {
    return entriesOf(ccaa::positionView(cloud_), mesh_.point_of_vertex);
  }

  void
  buildAdjacency()
  {
    adjacency_.build(mesh_.triangles,
                     mesh_.point_of_vertex.size(),
                     context_.threads,
                     context_.control);
  }

  ccaa::PolygonTriangles& mesh_;
  ccaa::TriangleAdjacency& adjacency_;
  const pcl::PCLPointCloud2& cloud_;
  const ccaa::LoopContext& context_;
  ReadingReport& report_;
};

} // namespace

void
bringToManifold(ccaa::PolygonTriangles& mesh,
                ccaa::TriangleAdjacency& adjacency,
                const pcl::PCLPointCloud2& cloud,
                const ccaa::LoopContext& context,
                ReadingReport& report)
{
  ManifoldReading(mesh, adjacency, cloud, context, report).run();
}

Positions
entriesOf(const ccaa::PointView& view, const std::vector<pcl::index_t>& point_of_vertex)
{
  Positions entries;
  if (view.empty())
    return entries;
  entries.reserve(point_of_vertex.size());
  for (const pcl::index_t point_index : point_of_vertex)
    entries.push_back(view[point_index]);
  return entries;
}

} // namespace pcl::repair
