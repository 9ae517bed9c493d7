// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a shape with all that its regions are closed by.

#pragma once

#include <gtest/gtest.h>

#include "listing/hole_list.h"
#include "patch/patch_assembly.h"
#include "region/filling_choice.h"
#include "region/region_closing.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"

#include <set>
#include <utility>
#include <vector>

namespace pcl::repair::test {

using namespace ccaa::test;

/** A shape with all that its regions are closed by; things can be put in the way. */
struct Site {
  explicit Site(const Shape& shape, RepairParameters wanted = {})
  : parameters(std::move(wanted))
  {
    parameters.survey.trace_in_holes = false;
    parameters.survey.simple_edges = simpleEdges(parameters.filling);
    survey = surveyModel(pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(shape)),
                         nullptr,
                         parameters.survey,
                         {});
    obstacle = SurfaceObstacle(survey.model,
                               {{Position::Constant(-99.0), Position::Constant(99.0)}});
    const HoleList list = listHoles(survey, parameters.filling);
    for (const std::vector<std::size_t>& holes : list.regions) {
      regions.emplace_back();
      regions.back().bridge_vertices = list.bridge_vertices;
      for (const std::size_t hole : holes)
        regions.back().holes.push_back(list.holes[hole].polygon);
    }
  }

  /** A small upright triangle, wide across x. */
  void
  putSpike(const Position& middle, double height, double width = 0.01)
  {
    const Position up(0.0, 0.0, 0.5 * height), across(width, 0.0, 0.0);
    obstacle.add({middle - up, middle + up, middle + up + across}, {{0, 1, 2}});
  }

  ClosedRegion
  close(const Region& region, ccaa::RunControl* control = nullptr) const
  {
    const SurveyGuides none;
    return closeRegion(
        {survey.model, none, parameters, {}}, region, obstacle, {1, control});
  }

  ClosedRegion
  close() const
  {
    return close(regions.at(0));
  }

  RepairParameters parameters;
  ModelSurvey survey;
  SurfaceObstacle obstacle{IncompleteModel(), {}};
  std::vector<Region> regions;
};

inline Position
centreOf(const HolePolygon& hole)
{
  Position sum = Position::Zero();
  for (const Position& point : hole.curve.points)
    sum += point / static_cast<double>(hole.size());
  return sum;
}

/** What holds whatever was in the way. */
inline void
expectSound(const Site& site, const ClosedRegion& closed)
{
  EXPECT_TRUE(fitsModel(site.survey.model, closed.patch));
  EXPECT_TRUE(obstructedTriangles(closed.patch, site.obstacle).empty());
  const std::set<std::size_t> made(closed.patch.hole.begin(), closed.patch.hole.end());
  for (std::size_t h = 0; h < closed.holes.size(); ++h) {
    EXPECT_EQ(closed.holes[h].open == OpenReason::NONE, made.count(h) > 0);
    EXPECT_EQ(closed.holes[h].open == OpenReason::NONE,
              !closed.holes[h].filling.empty());
  }
}

} // namespace pcl::repair::test
