// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how the time of a repair grows with its input.

#include <pcl/surface_repair/force_line_hole_repair.h>

#include "measuring.h"
#include "mesh/polygon_access.h"
#include "mesh/triangle_adjacency.h"
#include "repair_time_table.h"
#include "repair_trial.h"
#include "support/random_source.h"

#include <cmath>
#include <iomanip>
#include <ostream>
#include <utility>
#include <vector>

namespace bench {
namespace {

using namespace pcl::ccaa::test;
using pcl::ccaa::Position;

Positions
randomPlaces(const Shape& shape, std::size_t count)
{
  RandomSource random(1);
  Positions places;
  for (std::size_t i = 0; i < count; ++i)
    places.push_back(shape.vertices[random.below(shape.vertices.size())]);
  return places;
}

PieceOf
withoutBalls(const Positions& middles, double radius)
{
  return [middles, radius](const Position& p) {
    for (const Position& middle : middles)
      if ((p - middle).norm() < radius)
        return -1;
    return 0;
  };
}

double
boundaryLength(const pcl::RepairReport& report)
{
  double length = 0.0;
  for (const auto& loop : report.loops)
    length += loop.length;
  return length;
}

} // namespace

void
printRepairGrowth(std::ostream& out, std::size_t repeats)
{
  const Shape whole = readShared("armadillo/armadillo.ply");
  TrialSettings settings;
  settings.repeats = repeats;
  const double without = runTrial(whole, settings).seconds;
  out << "Armadillo with more and more holes, one thread; undamaged: " << std::fixed
      << std::setprecision(3) << without << " s\n"
      << "  holes  boundary length        s  s without the undamaged  exponent\n";
  const double diagonal = diagonalOf(whole);
  double first_length = 0.0;
  double first_seconds = 0.0;
  for (const std::size_t count : {5U, 10U, 20U, 40U, 80U}) {
    const Shape damaged =
        inPieces(whole, withoutBalls(randomPlaces(whole, count), 0.012 * diagonal));
    const RepairTrial trial = runTrial(damaged, settings);
    const double length = boundaryLength(trial.report) / diagonal;
    const double seconds = trial.seconds - without;
    out << std::setw(7) << count << std::setprecision(3) << std::setw(17) << length
        << std::setw(9) << trial.seconds << std::setw(25) << seconds;
    if (first_length > 0.0)
      out << std::setprecision(2) << std::setw(10)
          << std::log(seconds / first_seconds) / std::log(length / first_length);
    else {
      first_length = length;
      first_seconds = seconds;
    }
    out << std::endl;
  }
}

void
printLargeRepair(std::ostream& out, std::size_t repeats)
{
  Shape whole = torus(2500, 1000);
  const Positions middles = randomPlaces(whole, 10);
  const PieceOf pieces = withoutBalls(middles, 0.02);
  Shape damaged{std::move(whole.vertices), {}};
  for (const auto& triangle : whole.triangles)
    if (pieces(damaged.vertices[static_cast<std::size_t>(triangle[0])]) == 0)
      damaged.triangles.push_back(triangle);
  const auto mesh = meshOf(withoutFreeVertices(damaged));
  std::vector<double> reading;
  std::vector<double> repairing;
  std::size_t closed = 0;
  for (std::size_t i = 0; i < repeats; ++i) {
    reading.push_back(secondsOf([&] {
      const Triangles triangles = pcl::ccaa::fanTriangles(mesh->polygons);
      pcl::ccaa::TriangleAdjacency adjacency;
      adjacency.build(triangles, std::size_t{mesh->cloud.width});
    }));
    pcl::ForceLineHoleRepair repair;
    repair.setInputMesh(mesh);
    repair.setNumberOfThreads(1);
    pcl::PolygonMesh output;
    repairing.push_back(secondsOf([&] { repair.process(output); }));
    closed = repair.getReport().holes.size() - repair.getReport().shortfalls;
    if (i == 0)
      for (const auto& [step, seconds] : repair.getReport().seconds)
        out << "  " << step << " " << std::fixed << std::setprecision(2) << seconds
            << " s\n";
  }
  out << mesh->polygons.size() << " triangles, " << closed
      << " holes closed, one thread: adjacency alone " << median(reading)
      << " s, repair " << median(repairing) << " s, ratio "
      << median(repairing) / median(reading) << std::endl;
}

} // namespace bench
