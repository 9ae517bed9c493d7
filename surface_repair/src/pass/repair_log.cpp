// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: writes down what a repair finds and does.

#include "pass/repair_log.h"

#include "boundary/loop_evidence.h"
#include "mesh/surface_topology.h"

#include <algorithm>
#include <utility>

namespace pcl::repair {

TriangleOrigin
originOf(const std::string& filling)
{
  for (const TriangleOrigin origin : {TriangleOrigin::FAN, TriangleOrigin::COMPLETION})
    if (filling == describe(origin))
      return origin;
  return TriangleOrigin::MINIMUM_WEIGHT;
}

void
RepairLog::countSeconds(const std::string& step, double seconds)
{
  auto& all = report_.seconds;
  const auto entry = std::find_if(
      all.begin(), all.end(), [&](const auto& e) { return e.first == step; });
  if (entry == all.end())
    all.emplace_back(step, seconds);
  else
    entry->second += seconds;
}

void
RepairLog::noteLook()
{
  for (const auto& [stage, seconds] : survey_.seconds)
    countSeconds(pass_ == 0 ? stage : "looking again", seconds);
}

void
RepairLog::noteInput()
{
  const IncompleteModel& model = survey_.model;
  report_.input_triangles = model.triangles.size();
  report_.free_points = model.free_points.size();
  report_.counts_before = survey_.counts;
  report_.class_before = survey_.icm_class;
  report_.before =
      ccaa::topologyOf(model.triangles, model.adjacency, model.island_of.count, {});
  for (std::size_t i = 0; i < model.islands.size(); ++i) {
    const Island& island = model.islands[i];
    report_.islands.push_back({island.triangles,
                               island.area,
                               island.closed,
                               island.one_sided,
                               survey_.sides[i]});
  }
  for (std::size_t k = 0; k < survey_.loops.size(); ++k) {
    const BoundaryLoop& loop = survey_.loops[k];
    report_.loops.push_back({loop.island,
                             loop.vertices.size(),
                             loop.length,
                             pointOf(loop.vertices.front()),
                             survey_.classes[k]});
  }
  report_.origins.assign(model.triangles.size(), TriangleOrigin::INPUT);
  report_.hole_of.assign(model.triangles.size(), NONE);
}

void
RepairLog::beginPass()
{
  entry_of_bridge_.assign(survey_.joined.bridges.size(), NONE);
  ++pass_;
  noteJunctions();
}

void
RepairLog::noteJunctions()
{
  const SurveyedBridges& joined = survey_.joined;
  for (const Junction& junction : joined.junctions) {
    RepairJunction entry;
    entry.pass = pass_;
    for (std::size_t side = 0; side < 2; ++side) {
      const BoundaryLoop& loop = survey_.loops[joined.loops[junction.curves[side]]];
      entry.points[side] = lowestPoint(survey_.model, loop.vertices);
      entry.islands[side] = loop.island;
    }
    entry.lines = junction.lines.size();
    entry.evidence = junction.evidence;
    entry.verdict = junction.verdict;
    entry.confidence = junction.confidence;
    const auto isTube = [&](std::size_t curve) {
      return isMouth(survey_.classes[joined.loops[curve]].evidence);
    };
    entry.between_mouths = isTube(junction.curves[0]) && isTube(junction.curves[1]);
    report_.junctions.push_back(entry);
  }
}

pcl::index_t
RepairLog::pointOf(pcl::index_t vertex) const
{
  const auto& points = survey_.model.point_of_vertex;
  const auto place = static_cast<std::size_t>(vertex);
  return place < points.size() ? points[place] : pcl::UNAVAILABLE;
}

std::size_t
RepairLog::add(const OpenHole& hole, const HoleOutcome& outcome)
{
  RepairedHole entry;
  entry.edges = hole.polygon.size();
  entry.length = lengthOf(hole.polygon.curve);
  entry.open = outcome.open;
  entry.filling = outcome.filling;
  entry.tries = outcome.tries;
  for (const pcl::index_t vertex : hole.polygon.vertices) {
    if (static_cast<std::size_t>(vertex) >= survey_.model.positions.size())
      continue;
    if (entry.point == pcl::UNAVAILABLE)
      entry.point = pointOf(vertex);
    const pcl::index_t triangle = *survey_.model.adjacency.begin(vertex);
    entry.islands.push_back(
        survey_.model.island_of[static_cast<std::size_t>(triangle)]);
  }
  std::sort(entry.islands.begin(), entry.islands.end());
  entry.islands.erase(std::unique(entry.islands.begin(), entry.islands.end()),
                      entry.islands.end());
  reportBridges(hole, outcome, entry);
  report_.holes.push_back(std::move(entry));
  return report_.holes.size() - 1;
}

void
RepairLog::reportBridges(const OpenHole& hole,
                         const HoleOutcome& outcome,
                         RepairedHole& entry)
{
  for (const std::size_t bridge : hole.bridges)
    entry.bridges.push_back(bridgeEntry(bridge));
  for (const DividingBridge& bridge : outcome.bridges) {
    RepairBridge built;
    built.begin = pointOf(bridge.vertices.front());
    built.end = pointOf(bridge.vertices.back());
    built.begin_island = built.end_island =
        entry.islands.empty() ? NONE : entry.islands.front();
    built.points = bridge.points;
    built.normals = bridge.normals;
    built.quality = bridge.quality;
    built.within_hole = true;
    entry.bridges.push_back(report_.bridges.size());
    report_.bridges.push_back(std::move(built));
  }
}

/** The place of a bridge between islands in the report; two holes pass each. */
std::size_t
RepairLog::bridgeEntry(std::size_t bridge)
{
  std::size_t& entry = entry_of_bridge_[bridge];
  if (entry != NONE)
    return entry;
  const Bridge& built = survey_.joined.bridges[bridge];
  const auto loop = [&](const BoundaryPoint& end) -> const BoundaryLoop& {
    return survey_.loops[survey_.joined.loops[end.curve]];
  };
  entry = report_.bridges.size();
  report_.bridges.push_back({pointOf(loop(built.begin).vertices[built.begin.edge]),
                             pointOf(loop(built.end).vertices[built.end.edge]),
                             loop(built.begin).island,
                             loop(built.end).island,
                             built.points,
                             built.normals,
                             built.quality,
                             false});
  return entry;
}

/** Those of the input come first, and fill no hole. */
void
RepairLog::leaveOut(std::size_t triangles)
{
  const auto count = static_cast<std::ptrdiff_t>(triangles);
  report_.hole_of.erase(report_.hole_of.begin(), report_.hole_of.begin() + count);
  report_.origins.erase(report_.origins.begin(), report_.origins.begin() + count);
}

void
RepairLog::takeIn(std::size_t triangles)
{
  report_.hole_of.insert(report_.hole_of.begin(), triangles, NONE);
  report_.origins.insert(report_.origins.begin(), triangles, TriangleOrigin::INPUT);
}

void
RepairLog::addTriangle(std::size_t hole)
{
  RepairedHole& entry = report_.holes[hole];
  ++entry.triangles;
  report_.hole_of.push_back(hole);
  report_.origins.push_back(originOf(entry.filling));
}

} // namespace pcl::repair
