// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what reports on a model and on its repair have in common.
#include "repair_details.h"

#include "cli/method_options.h"
#include "io/wording.h"
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace app {

using nlohmann::json;
using pcl::repair::IcmClass;
using pcl::repair::ReadingReport;

const char*
nameOf(IcmClass icm_class)
{
  switch (icm_class) {
  case IcmClass::ICM1:
    return "ICM1";
  case IcmClass::ICM2:
    return "ICM2";
  case IcmClass::ICM3:
    return "ICM3";
  }
  return "unknown";
}

json
describePosition(const Eigen::Vector3d& position)
{
  return {position.x(), position.y(), position.z()};
}

json
describeReading(const ReadingReport& reading)
{
  return {{"input_polygons", reading.input_polygons},
          {"invalid_polygons", reading.invalid_polygons},
          {"non_finite_points", reading.non_finite_points},
          {"points_on_vertices", reading.points_on_vertices},
          {"repeated_triangles", reading.repeated_triangles},
          {"overfull_edges", reading.overfull_edges},
          {"separated_fans", reading.separated_fans},
          {"twist_triangles", reading.twist_triangles},
          {"reversed_triangles", reading.reversed_triangles},
          {"dropped_islands", reading.dropped_islands},
          {"dropped_triangles", reading.dropped_triangles}};
}

namespace {

/** \brief As on the command line; null: no limit. */
json
describeExtent(const pcl::repair::Extent& extent)
{
  if (!extent.limits())
    return nullptr;
  if (!extent.of_diagonal)
    return extent.value;
  std::ostringstream text;
  text << extent.value * 100.0 << '%';
  return text.str();
}

} // namespace

json
describeParameters(const pcl::repair::RepairParameters& method)
{
  const auto& field = method.survey.field;
  return {{"mode", wordFor(FIELD_MODES, field.mode)},
          {"interpolation", field.interpolation},
          {"falloff_exponent", field.falloff_exponent},
          {"near", field.near},
          {"far", field.far},
          {"room", field.room},
          {"coarse_distance", field.coarse_distance},
          {"free_point_near", field.free_point_near},
          {"free_point_far", field.free_point_far},
          {"free_point_exponent", field.free_point_exponent},
          {"trust", field.trust},
          {"simple_edges", method.survey.simple_edges},
          {"hole_threshold", method.survey.hole_threshold},
          {"bridge_spacing", method.survey.bridge_spacing},
          {"line_spacing", method.survey.line_spacing},
          {"filling", wordFor(FILLING_CHOICES, method.filling.choice)},
          {"filling_simple_edges", method.filling.simple_edges},
          {"greatest_hole", method.filling.greatest_hole},
          {"greatest_hole_length", describeExtent(method.filling.greatest_length)},
          {"greatest_bridge", describeExtent(method.survey.greatest_bridge)},
          {"close", wordFor(CLOSE_CHOICES, method.filling.close)},
          {"watertight", method.watertight},
          {"cap", wordFor(CAPS, method.filling.cap)},
          {"drop_islands",
           {{"triangles", method.survey.dropped.triangles},
            {"area", method.survey.dropped.area},
            {"share_of_all_area", method.survey.dropped.share_of_all_area}}},
          {"join_islands", method.join_islands},
          {"crumbs", method.crumb_triangles},
          {"greatest_unsupported", method.greatest_unsupported},
          {"refine", method.refine},
          {"edge_length", method.refinement.edge_length},
          {"fair", method.refine && method.relax}};
}

void
addSide(const pcl::repair::IslandSide& side, json& island)
{
  island["rule"] = describe(side.rule);
  island["flipped"] = side.flipped;
  island["confidence"] = side.confidence;
}

void
addClass(const pcl::repair::LoopClass& loop_class, json& loop)
{
  loop["class"] = describe(loop_class.boundary_class);
  loop["confidence"] = loop_class.confidence;
  loop["D"] = loop_class.evidence.integral.value;
  loop["D_relative"] = loop_class.evidence.integral.relative();
  loop["turning"] = loop_class.evidence.turning;
  loop["area_ratio"] = loop_class.evidence.area_ratio;
  loop["faced"] = loop_class.faced;
}

void
addJunction(pcl::repair::JunctionVerdict verdict,
            double confidence,
            const pcl::repair::JunctionEvidence& evidence,
            json& junction)
{
  constexpr double DEGREES = 180.0 / M_PI;
  junction["verdict"] = describe(verdict);
  junction["confidence"] = confidence;
  junction["turn"] = DEGREES * evidence.turn;
  junction["fold"] = DEGREES * evidence.fold;
  junction["gap"] = evidence.gap;
  junction["gap_edges"] = evidence.gap_edges;
  junction["gap_share"] = evidence.gap_share;
  junction["seen_empty"] =
      evidence.has_sight ? json(evidence.seen_empty) : json(nullptr);
  junction["along_ray"] = evidence.has_sight ? json(evidence.along_ray) : json(nullptr);
}

nlohmann::json
describeTopology(const pcl::ccaa::SurfaceTopology& topology)
{
  return {{"pieces", topology.pieces},
          {"boundary_loops", topology.boundary_loops},
          {"euler_characteristic", topology.euler_characteristic},
          {"genus", topology.genus ? nlohmann::json(*topology.genus) : nullptr},
          {"watertight", topology.isWatertight()}};
}

std::string
summarizeTopology(bool is_watertight, std::optional<long> genus, long characteristic)
{
  std::string text = is_watertight ? "watertight: yes" : "watertight: no";
  if (genus)
    text += ", genus " + std::to_string(*genus);
  return text + ", Euler characteristic " + std::to_string(characteristic);
}

void
Tally::add(const std::string& name, std::size_t times)
{
  for (auto& [known, count] : counts_)
    if (known == name) {
      count += times;
      return;
    }
  counts_.emplace_back(name, times);
}

std::string
Tally::text() const
{
  std::string text;
  for (const auto& [name, count] : counts_)
    addToList(text, std::to_string(count) + " " + name);
  return text;
}

std::string
Tally::nouns() const
{
  std::string text;
  for (const auto& [name, count] : counts_)
    addToList(text, plural(count, name));
  return text;
}

} // namespace app
