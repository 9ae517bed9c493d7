// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how the time of a repair grows.
#include "repair_time_table.h"

#include <pcl/surface_ccaa/consecutive_reconstruction.h>
#include <pcl/surface_repair/force_line_hole_repair.h>

#include "default_clouds.h"
#include "input_clouds.h"
#include "measuring.h"
#include "repair_trial.h"
#include "survey/model_survey.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iomanip>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bench {
namespace {

using namespace pcl::ccaa::test;

/** A torus with holes in rows: all triangles at the points of a lattice that are within
 * so many of its steps of their middles are lost. */
Shape
torusWithHoles(int around, int across, int columns, int rows, double steps)
{
  const Shape whole = torus(around, across);
  const auto from_middle = [](int at, int count, int holes) {
    const int apart = count / holes;
    return at % apart - apart / 2;
  };
  const auto is_lost = [&](pcl::index_t vertex) {
    const double i = from_middle(static_cast<int>(vertex) % around, around, columns);
    const double j = from_middle(static_cast<int>(vertex) / around, across, rows);
    return i * i + j * j < steps * steps;
  };
  Shape damaged{whole.vertices, {}};
  for (const auto& triangle : whole.triangles)
    if (!std::any_of(triangle.begin(), triangle.end(), is_lost))
      damaged.triangles.push_back(triangle);
  return withoutFreeVertices(damaged);
}

/** Median seconds of a repair; its report is that of the last one. */
double
secondsToRepair(const pcl::PolygonMesh::ConstPtr& mesh,
                unsigned int threads,
                std::size_t repeats,
                pcl::RepairReport& report)
{
  std::vector<double> seconds;
  for (std::size_t i = 0; i < repeats; ++i) {
    pcl::ForceLineHoleRepair repair;
    repair.setInputMesh(mesh);
    repair.setNumberOfThreads(threads);
    pcl::PolygonMesh output;
    seconds.push_back(secondsOf([&] { repair.process(output); }));
    report = repair.getReport();
  }
  return median(seconds);
}

/** The longest time in which a repair has not asked whether it is to go on. */
struct LongestGap {
  double seconds = 0.0;
  std::string stages; /**< before and after it */
};

/** \param[in] work that tells a callback its progress \param[in] now seconds of some
 * clock */
LongestGap
longestGap(const std::function<void(const pcl::ccaa::ProgressCallback&)>& work,
           const std::function<double()>& now)
{
  LongestGap longest;
  std::string stage = "begin";
  double last = now();
  const auto note = [&](const std::string& next) {
    const double seconds = now() - last;
    if (seconds > longest.seconds)
      longest = {seconds, stage == next ? stage : stage + " to " + next};
    stage = next;
    last = now();
  };
  work([&](const std::string& next, double) {
    note(next);
    return true;
  });
  note("end");
  return longest;
}

/** A reconstruction, or a repair, that tells its progress. */
template <typename Run>
void
runWatched(Run& run, unsigned int threads, const pcl::ccaa::ProgressCallback& told)
{
  run.setNumberOfThreads(threads);
  run.setProgressCallback(told);
}

/** One more row, with the exponent of time against what grows; the first has none. */
void
printExponent(std::ostream& out, double before, double now, double ratio)
{
  if (before > 0.0)
    out << std::setprecision(2) << std::setw(10)
        << std::log(now / before) / std::log(ratio);
  out << std::endl;
}

/** Scans that have triangles, in the shared data. */
const std::array<std::string, 3> RANGE_MAPS = {
    "rs1_scene/rs1_normals.ply", "range_maps/lato000.ply", "range_maps/lato180.ply"};

/** The mesh that is to be repaired. */
pcl::PolygonMesh::Ptr
scanOf(const std::string& word)
{
  if (std::find(RANGE_MAPS.begin(), RANGE_MAPS.end(), word) != RANGE_MAPS.end())
    return meshOf(readShared(word));
  pcl::ConsecutiveReconstruction<pcl::PointXYZ> chain;
  chain.setInputCloud(makeCloud(word));
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  chain.reconstruct(*mesh);
  return mesh;
}

/** All that printScans() repairs. */
std::vector<std::string>
scans()
{
  std::vector<std::string> words(RANGE_MAPS.begin(), RANGE_MAPS.end());
  for (const std::string& word : cloudList("scenes"))
    if (word.find("range_maps") == std::string::npos)
      words.push_back(word);
  words.insert(words.end(), {"aerial:1", "office:1"});
  return words;
}

} // namespace

void
printScans(std::ostream& out, std::size_t repeats)
{
  out << "Repair of scans\n"
         "scan                          triangles   edges  closed    open"
         "  s, one thread  s, two threads  ratio\n";
  for (const std::string& word : scans())
    try {
      const pcl::PolygonMesh::Ptr mesh = scanOf(word);
      pcl::RepairReport report;
      const double one = secondsToRepair(mesh, 1, repeats, report);
      const double two = secondsToRepair(mesh, 2, repeats, report);
      std::size_t edges = 0, open = 0;
      for (const pcl::RepairedLoop& loop : report.loops)
        edges += loop.edges;
      for (const pcl::RepairedHole& hole : report.holes)
        open += hole.open == pcl::OpenReason::NONE ? 0 : 1;
      out << std::left << std::setw(28) << shortName(word) << std::right
          << std::setw(11) << mesh->polygons.size() << std::setw(8) << edges
          << std::setw(8) << report.holes.size() - open << std::setw(8) << open
          << std::fixed << std::setprecision(2) << std::setw(15) << one << std::setw(16)
          << two << std::setw(7) << one / two << std::endl;
    }
    catch (const std::runtime_error& problem) {
      out << problem.what() << "\n";
    }
}

void
printGaps(std::ostream& out)
{
  using Told = pcl::ccaa::ProgressCallback;
  out << "Longest time between two calls of the progress callback, ms\n"
         "input                       what            threads      ms  in\n";
  const auto print = [&](const std::string& name, const char* what, const auto& work) {
    for (const unsigned int threads : {1U, 2U}) {
      const LongestGap gap = longestGap([&](const Told& told) { work(threads, told); },
                                        threads == 1 ? ownSeconds : wallSeconds);
      out << std::left << std::setw(28) << name << std::setw(14) << what << std::right
          << std::setw(9) << threads << std::fixed << std::setprecision(0)
          << std::setw(8) << 1e3 * gap.seconds << "  " << gap.stages << std::endl;
    }
  };
  const auto print_repair = [&](const std::string& name,
                                const pcl::PolygonMesh::Ptr& mesh) {
    print(name, "repair", [&](unsigned int threads, const Told& told) {
      pcl::ForceLineHoleRepair repair;
      repair.setInputMesh(mesh);
      runWatched(repair, threads, told);
      pcl::PolygonMesh output;
      repair.process(output);
    });
  };
  print_repair("one hole, 2 M triangles",
               meshOf(torusWithHoles(1000, 1000, 1, 1, 294.0)));
  print_repair("10 000 holes, 4 M triangles",
               meshOf(torusWithHoles(2000, 1000, 100, 100, 3.2)));
  for (const std::string& word : scans())
    try {
      if (std::find(RANGE_MAPS.begin(), RANGE_MAPS.end(), word) == RANGE_MAPS.end()) {
        const Cloud::Ptr cloud = makeCloud(word);
        print(shortName(word), "reconstruction", [&](auto threads, const Told& told) {
          pcl::ConsecutiveReconstruction<pcl::PointXYZ> chain;
          chain.setInputCloud(cloud);
          runWatched(chain, threads, told);
          pcl::PolygonMesh mesh;
          chain.reconstruct(mesh);
        });
      }
      print_repair(shortName(word), scanOf(word));
    }
    catch (const std::runtime_error& problem) {
      out << problem.what() << "\n";
    }
}

void
printManyHoles(std::ostream& out, std::size_t repeats)
{
  out << "A torus of 4 million triangles with more and more round holes\n"
         "  holes  edges of one  s, one thread  s, two threads  ratio  exponent\n";
  double before = 0.0;
  for (const int rows : {10, 32, 100}) {
    const auto mesh = meshOf(torusWithHoles(2000, 1000, rows, rows, 3.2));
    pcl::RepairReport report;
    const double one = secondsToRepair(mesh, 1, repeats, report);
    const double two = secondsToRepair(mesh, 2, repeats, report);
    out << std::fixed << std::setprecision(2) << std::setw(7) << report.holes.size()
        << std::setw(14) << report.holes.front().edges << std::setw(15) << one
        << std::setw(16) << two << std::setw(7) << one / two;
    printExponent(out, before, one, 10.0);
    before = one;
  }
}

void
printLongHoles(std::ostream& out, std::size_t repeats)
{
  out << "A torus of 2 million triangles with one hole that is longer and longer\n"
         "  edges  new triangles        s  exponent\n";
  double before = 0.0;
  double edges_before = 1.0;
  for (const double steps : {37.0, 74.0, 147.0, 294.0}) {
    const auto mesh = meshOf(torusWithHoles(1000, 1000, 1, 1, steps));
    pcl::RepairReport report;
    const double seconds = secondsToRepair(mesh, 1, repeats, report);
    const auto edges = static_cast<double>(report.loops.front().edges);
    out << std::fixed << std::setprecision(2) << std::setw(7)
        << report.loops.front().edges << std::setw(15) << report.new_triangles
        << std::setw(9) << seconds;
    printExponent(out, before, seconds, edges / edges_before);
    before = seconds;
    edges_before = edges;
  }
}

} // namespace bench
