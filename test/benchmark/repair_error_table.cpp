// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how near the repaired surface comes to the lost one.
#include "repair_error_table.h"

#include <Eigen/Geometry>

#include "boundary/extraction.h"
#include "icadm/model_reading.h"
#include "measuring.h"
#include "mesh/surface_topology.h"
#include "repair_trial.h"
#include "rival_hole_filling.h"
#include "support/completion_shapes.h"
#include "support/random_source.h"
#include "survey/model_survey.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <ostream>

namespace bench {
namespace {

using namespace pcl::ccaa::test;
using pcl::ccaa::Position;

/** \brief The box cut into thirds along x and y and into halves along z: 18 cells,
 * slabs of a share of its sides between them. */
PieceOf
fiveSlabs(const Shape& shape, double share)
{
  Eigen::AlignedBox3d box;
  for (const Position& position : shape.vertices)
    box.extend(position);
  return [box, share](const Position& p) {
    const Position place = (p - box.min()).cwiseQuotient(box.sizes());
    int piece = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const int parts = axis == 2 ? 2 : 3;
      const double cell = place[axis] * parts;
      const int below = static_cast<int>(std::lround(cell)); // the nearest cut
      const bool is_cut = below > 0 && below < parts;
      if (is_cut &&
          std::abs(place[axis] - static_cast<double>(below) / parts) < 0.5 * share)
        return -1;
      piece = piece * 3 + std::clamp(static_cast<int>(cell), 0, parts - 1);
    }
    return piece;
  };
}

/** \brief A share of the vertices that have no triangle any more. */
Positions
lostPoints(const Shape& whole, const Triangles& kept, double share)
{
  std::vector<char> used(whole.vertices.size(), 0);
  for (const auto& triangle : kept)
    for (const pcl::index_t corner : triangle)
      used[static_cast<std::size_t>(corner)] = 1;
  RandomSource random(1);
  Positions points;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i] == 0 && random.uniform() < share)
      points.push_back(whole.vertices[i]);
  return points;
}

void
printBunnyRow(std::ostream& out,
              const Shape& bunny,
              double share,
              double free_share,
              std::size_t repeats)
{
  const Shape kept = inPieces(bunny, fiveSlabs(bunny, share), true);
  const Shape lost = lostPart(bunny, kept.triangles);
  TrialSettings settings;
  settings.repeats = repeats;
  settings.free_points = lostPoints(bunny, kept.triangles, free_share);
  const Shape damaged = withoutFreeVertices(kept);
  const RepairTrial trial = runTrial(damaged, settings);
  const Topology found = topologyOf(trial.result.triangles);
  const std::size_t before = countIntersections(roundedToFloat(damaged));
  out << std::setw(6) << std::lround(100 * share) << " %" << std::setw(8)
      << std::lround(100 * free_share) << " %" << std::setw(9)
      << trial.report.islands.size() << std::setw(10) << std::setprecision(4)
      << meanDistance(lost, trial.result, diagonalOf(bunny)) << std::setw(9)
      << std::setprecision(3) << trial.seconds << std::setw(6) << found.components
      << std::setw(6) << found.characteristic << std::setw(9) << found.borders
      << std::setw(10) << trial.report.shortfalls << std::setw(8)
      << countIntersections(trial.result) - before << std::endl;
}

/** \brief For each edge its two triangles; of a closed surface. */
std::vector<std::array<std::size_t, 2>>
trianglePairs(const Triangles& triangles)
{
  std::vector<std::array<std::size_t, 3>> sides; // both ends, the triangle
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = static_cast<std::size_t>(triangles[t][k]);
      const auto b = static_cast<std::size_t>(triangles[t][(k + 1) % 3]);
      sides.push_back({std::min(a, b), std::max(a, b), t});
    }
  std::sort(sides.begin(), sides.end());
  std::vector<std::array<std::size_t, 2>> pairs;
  for (std::size_t i = 1; i < sides.size(); i += 2)
    pairs.push_back({sides[i - 1][2], sides[i][2]});
  return pairs;
}

/** \brief All triangles with a corner within a distance of a place taken away, as many
 * as make a hole of so many edges. */
Shape
withHole(const Shape& whole, const Position& place, long edges)
{
  std::vector<double> nearest; // corner of each triangle
  for (const auto& triangle : whole.triangles) {
    double distance = std::numeric_limits<double>::infinity();
    for (const pcl::index_t corner : triangle)
      distance = std::min(
          distance, (whole.vertices[static_cast<std::size_t>(corner)] - place).norm());
    nearest.push_back(distance);
  }
  const auto pairs = trianglePairs(whole.triangles);
  double radius = 0.0;
  const double step = 0.002 * diagonalOf(whole);
  long border = 0;
  while (border < edges && radius < 200 * step) {
    radius += step;
    border = std::count_if(pairs.begin(), pairs.end(), [&](const auto& pair) {
      return (nearest[pair[0]] < radius) != (nearest[pair[1]] < radius);
    });
  }
  Shape rest{whole.vertices, {}};
  for (std::size_t t = 0; t < nearest.size(); ++t)
    if (nearest[t] >= radius)
      rest.triangles.push_back(whole.triangles[t]);
  return rest;
}

/** \brief CGAL's result for the longest loop, as one surface. */
Shape
filledByCgal(const Shape& damaged, double& seconds)
{
  const auto model = pcl::repair::readModel(meshOf(damaged), nullptr, {}).model;
  std::vector<pcl::index_t> longest;
  for (const auto& loop : pcl::repair::extractBoundaries(model))
    if (loop.vertices.size() > longest.size())
      longest = loop.vertices;
  std::reverse(longest.begin(), longest.end());
  const HoleFilling filling =
      refineAndFairHole(model.triangles, model.positions, longest);
  seconds = filling.seconds;
  Shape filled{model.positions, model.triangles};
  filled.vertices.insert(
      filled.vertices.end(), filling.added.begin(), filling.added.end());
  filled.triangles.insert(
      filled.triangles.end(), filling.triangles.begin(), filling.triangles.end());
  return filled;
}

struct CurvedPlace {
  const char* name;
  Shape whole;
  Position middle;
};

/** \brief A ring and a scanned head. */
std::vector<CurvedPlace>
curvedPlaces()
{
  std::vector<CurvedPlace> places{
      {"torus, outside", torus(1000, 600, 1.0, 0.6), Position(1.6, 0, 0)},
      {"torus, inside", torus(1000, 600, 1.0, 0.6), Position(0.4, 0, 0)},
      {"sphere", icosphere(7), Position(0.3, 0.4, 0.86)}};
  Shape igea = readShared("igea/igea.ply");
  const Position nose =
      *std::max_element(igea.vertices.begin(),
                        igea.vertices.end(),
                        [](const auto& a, const auto& b) { return a.z() < b.z(); });
  places.push_back({"igea", std::move(igea), nose});
  return places;
}

} // namespace

void
printRepairedBunny(std::ostream& out, std::size_t repeats)
{
  const Shape bunny = readShared("bunny/bun_zipper.ply");
  out << "Bunny cut by five slabs, one thread: mean distance of the lost surface to "
         "the "
         "result in % of the diagonal\n"
      << "    slab    free  islands  distance        s parts    chi  borders left open "
         "crossings\n"
      << std::fixed;
  for (const double free_share : {0.0, 0.05})
    for (const double share : {0.03, 0.06, 0.1})
      printBunnyRow(out, bunny, share, free_share, repeats);
}

void
printRepairedSphere(std::ostream& out)
{
  const Shape sphere = icosphere(5);
  out << "Sphere in four pieces, gaps of 8 % of its size: mean distance of the lost "
         "surface to the result in % of the diagonal\n"
      << std::fixed << std::setprecision(4);
  std::vector<double> distances;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Shape damaged = inPieces(sphere, cells(4, 0.16, seed), true);
    const Shape lost = lostPart(sphere, damaged.triangles);
    const RepairTrial trial = runTrial(withoutFreeVertices(damaged), {});
    distances.push_back(meanDistance(lost, trial.result, diagonalOf(sphere)));
    out << "  seed " << seed << ": " << distances.back() << "\n";
  }
  out << "  median: " << median(distances) << "\n";
}

void
printCurvedHoles(std::ostream& out, std::size_t repeats)
{
  out << "One hole of about 600 edges: mean distance of the lost surface to the result "
         "in % of the diagonal\n"
      << "  surface           edges     ours     CGAL  ratio   ours s   CGAL s\n"
      << std::fixed;
  for (const CurvedPlace& place : curvedPlaces()) {
    const Shape kept = withHole(place.whole, place.middle, 600);
    const Shape damaged = withoutFreeVertices(kept);
    const double diagonal = diagonalOf(place.whole);
    const Shape lost = lostPart(place.whole, kept.triangles);
    TrialSettings settings;
    settings.repeats = repeats;
    const RepairTrial trial = runTrial(damaged, settings);
    std::size_t edges = 0;
    for (const auto& hole : trial.report.holes)
      edges = std::max(edges, hole.edges);
    double seconds = 0.0;
    const Shape rival = filledByCgal(damaged, seconds);
    const double ours = meanDistance(lost, trial.result, diagonal);
    const double theirs = hasHoleFilling() ? meanDistance(lost, rival, diagonal) : 0.0;
    out << "  " << std::left << std::setw(16) << place.name << std::right
        << std::setw(7) << edges << std::setprecision(5) << std::setw(9) << ours
        << std::setw(9) << theirs << std::setprecision(2) << std::setw(7)
        << (theirs > 0.0 ? ours / theirs : 0.0) << std::setprecision(3) << std::setw(9)
        << trial.seconds << std::setw(9) << seconds << std::endl;
  }
}

} // namespace bench
