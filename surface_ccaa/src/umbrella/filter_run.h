// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the working data and the steps of one umbrella filter run.
#pragma once

#include <pcl/surface_ccaa/umbrella_filter.h>
#include <pcl/Vertices.h>

#include "mesh/block_loop.h"
#include "mesh/mesh_view.h"
#include "mesh/orientation.h"
#include "mesh/point_chains.h"
#include "mesh/point_view.h"
#include "mesh/vertex_adjacency.h"
#include "umbrella/twist_cut.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::ccaa {

/** \brief What a run is asked to do. */
struct FilterSettings {
  std::size_t minimum_internal_points = 10;
  bool consistent_orientation = true;
  TwistLimits twist_limits;
  SideHints sides;
  int threads = 1;
};

/** \brief The parts of the cloud that are looked at; empty where it has none. */
struct FilterViews {
  PointView points;
  PointView normals;
  PointView viewpoints;
};

/** \brief How a run has ended. */
enum class FilterOutcome : std::uint8_t { DONE, CANCELLED, TOO_MANY_TRIANGLES };

/** \brief One run of the umbrella filter, from polygons to polygons. */
class FilterRun {
public:
  FilterRun(const FilterViews& views,
            const FilterSettings& settings,
            const ProgressCallback& progress)
  : views_(views), settings_(settings), control_(progress)
  {}

  /** \brief First step. The polygons are not looked at afterwards. */
  void
  read(const PolygonView& polygons);

  /** \brief All that follows but writing. */
  FilterOutcome
  filter();

  /** \brief After DONE, once: see handOut(). \return false when cancelled */
  bool
  write(TriangleHandoff* handoff, std::vector<pcl::Vertices>& polygons);

  /** \brief After DONE: the role of every point. */
  std::vector<PointRole>
  pointRoles();

  /** \brief After all else: the adjacency of the triangles. */
  VertexAdjacency
  takeAdjacency()
  {
    return {std::move(adjacency_), std::move(point_of_vertex_)};
  }

  const UmbrellaReport&
  report() const
  {
    return report_;
  }

  /** \brief After DONE, with consistent orientation. */
  const SideTally&
  sideTally() const
  {
    return tally_;
  }

private:
  void
  buildAdjacency();
  void
  repairEdges();
  void
  eliminate();
  void
  dropDeleted();
  void
  orient();
  OrientationReport
  windOutward(bool only_if_two_sided);
  bool
  cutTwistedRegions();

  LoopContext
  stage(const char* name)
  {
    return {settings_.threads, &control_, name, BLOCK_SIZE};
  }

  FilterViews views_;
  FilterSettings settings_;
  RunControl control_;

  Triangles triangles_; /**< corners are vertices */
  std::vector<pcl::index_t> point_of_vertex_;
  Positions positions_; /**< of vertices */
  TriangleAdjacency adjacency_;
  AliveFlags alive_;
  std::vector<Fan> fans_;
  UmbrellaReport report_;
  SideTally tally_;
};

} // namespace pcl::ccaa
