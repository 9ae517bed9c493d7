// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how near refined and relaxed patches come to what was lost.
#include "fairing_table.h"

#include "fairing/refinement.h"
#include "fairing/relaxation.h"
#include "icadm/model_assembly.h"
#include "measuring.h"
#include "mesh_distance.h"
#include "rival_hole_filling.h"
#include "single_hole.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <ostream>
#include <utility>
#include <vector>

namespace bench {
namespace {

using pcl::repair::IncompleteModel;
using pcl::repair::NONE;
using pcl::repair::Patch;
using pcl::repair::Triangle;

struct Kind {
  const char* model;
  std::size_t edges;
  double stretch;
};

/** A boundary of so many edges must fit on the model. */
const std::vector<Kind> KINDS = {{"igea/igea.ply", 600, 1},
                                 {"igea/igea.ply", 600, 4},
                                 {"igea/igea.ply", 300, 1},
                                 {"armadillo/armadillo.ply", 150, 1},
                                 {"horse/horse.ply", 200, 1},
                                 {"rocker_arm/rockerArm.ply", 200, 1},
                                 {"lordquas/lordquas.ply", 200, 1},
                                 {"fandisk/fandisk_large.ply", 150, 1}};

/** The model without vertices that have lost all their triangles; `number` tells where
 * the others went. */
IncompleteModel
modelOf(const SingleHole& hole, std::vector<pcl::index_t>& number)
{
  number.assign(hole.positions.size(), -1);
  pcl::repair::Triangles triangles = hole.triangles;
  pcl::repair::Positions positions;
  for (Triangle& triangle : triangles)
    for (pcl::index_t& corner : triangle) {
      pcl::index_t& there = number[static_cast<std::size_t>(corner)];
      if (there < 0) {
        there = static_cast<pcl::index_t>(positions.size());
        positions.push_back(hole.positions[static_cast<std::size_t>(corner)]);
      }
      corner = there;
    }
  return pcl::repair::assembleModel(std::move(triangles), std::move(positions), {});
}

Patch
patchOf(const SingleHole& hole,
        const HoleFilling& filling,
        const std::vector<pcl::index_t>& number)
{
  Patch patch;
  std::vector<pcl::index_t> place(hole.positions.size(), -1);
  for (const pcl::index_t vertex : hole.loop) {
    place[static_cast<std::size_t>(vertex)] =
        static_cast<pcl::index_t>(patch.rim.size());
    patch.rim.push_back(number[static_cast<std::size_t>(vertex)]);
    patch.positions.push_back(hole.positions[static_cast<std::size_t>(vertex)]);
  }
  for (Triangle triangle : filling.triangles) {
    for (pcl::index_t& corner : triangle)
      corner = place[static_cast<std::size_t>(corner)];
    patch.triangles.push_back(triangle);
  }
  patch.free_point.assign(patch.positions.size(), NONE);
  patch.hole.assign(patch.triangles.size(), 0);
  return patch;
}

/** What came of one hole. */
struct Outcome {
  double error = 0; /**< per cent of the diagonal */
  double seconds = 0;
};

double
errorOf(const ClosedModel& model,
        const SingleHole& hole,
        const pcl::repair::Triangles& triangles,
        const pcl::repair::Positions& positions)
{
  const MeshDistance distance(triangles, positions);
  const Deviation deviation = measureDeviation(
      hole.lost, model.positions, distance, std::numeric_limits<double>::infinity());
  return 100 * deviation.mean / model.diagonal;
}

Outcome
ours(const ClosedModel& model, const SingleHole& hole)
{
  std::vector<pcl::index_t> number;
  const IncompleteModel incomplete = modelOf(hole, number);
  const HoleFilling filling = triangulateHole(hole.positions, hole.loop);
  Patch patch = patchOf(hole, filling, number);
  Outcome outcome;
  outcome.seconds = filling.seconds + secondsOf([&] {
                      pcl::repair::refinePatch(incomplete, {}, patch);
                      pcl::repair::relaxPatch(incomplete, {}, {}, patch);
                    });
  outcome.error = errorOf(model, hole, patch.triangles, patch.positions);
  return outcome;
}

Outcome
rival(const ClosedModel& model, const SingleHole& hole)
{
  const HoleFilling filling =
      refineAndFairHole(hole.triangles, hole.positions, hole.loop);
  pcl::repair::Positions positions = hole.positions;
  positions.insert(positions.end(), filling.added.begin(), filling.added.end());
  return {errorOf(model, hole, filling.triangles, positions), filling.seconds};
}

/** Errors below are those of rounding, in % of the diagonal. */
constexpr double EXACT = 1e-4;

/** Ratios of all rows. */
struct Summary {
  double logarithms = 0;
  double worst = 0;
  std::size_t count = 0;
};

void
printRow(std::ostream& out,
         const ClosedModel& model,
         const SingleHole& hole,
         Summary& summary)
{
  const Outcome own = ours(model, hole);
  const Outcome other = rival(model, hole);
  const double ratio = own.error / other.error;
  if (std::max(own.error, other.error) >
      EXACT) { // of two that are right none is better
    summary.logarithms += std::log(ratio);
    summary.worst = std::max(summary.worst, ratio);
    ++summary.count;
  }
  out << "| " << model.name << " | " << hole.loop.size() << " | " << std::fixed
      << std::setprecision(4) << own.error << " | " << other.error << " | "
      << std::setprecision(2) << ratio << " | " << own.seconds << " | " << other.seconds
      << " |" << std::endl;
}

void
printKind(std::ostream& out,
          const ClosedModel& model,
          const Kind& kind,
          std::uint64_t places,
          Summary& summary)
{
  // Spread over the list of triangles, and so over the model.
  for (std::uint64_t place = 0; place < places; ++place) {
    const std::size_t centre = model.triangles.size() * (2 * place + 1) / (2 * places);
    const auto hole =
        cutHole(model, {static_cast<pcl::index_t>(centre), kind.edges, kind.stretch});
    if (hole)
      printRow(out, model, *hole, summary);
  }
}

} // namespace

void
printFairingTable(std::ostream& out, std::uint64_t places)
{
  if (!hasHoleFilling()) {
    out << "Built without CGAL: no table of fairing.\n";
    return;
  }
  out << "| model | edges | error % | CGAL % | ratio | s | CGAL s |\n"
      << "|---|---|---|---|---|---|---|\n";
  Summary summary;
  for (const Kind& kind : KINDS)
    printKind(out, readClosedModel(kind.model), kind, places, summary);
  for (const ClosedModel& model : madeModels())
    printKind(out, model, {"", 120, 1}, places, summary);
  if (summary.count > 0)
    out << "\ngeometric mean of the ratios " << std::fixed << std::setprecision(2)
        << std::exp(summary.logarithms / static_cast<double>(summary.count))
        << ", worst " << summary.worst << " of " << summary.count << "\n";
}

} // namespace bench
