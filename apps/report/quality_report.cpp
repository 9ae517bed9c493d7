// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the facts about a mesh as a table and as JSON.
#include "quality_report.h"

#include "io/wording.h"
#include "repair_details.h"
#include <nlohmann/json.hpp>

#include <algorithm>
#include <numeric>
#include <sstream>

namespace app {
namespace {

using nlohmann::json;
using pcl::ccaa::MeshFacts;

constexpr std::size_t shown_loops = 10;
constexpr std::size_t bar_width = 40;

template <typename T>
json
orNull(const std::optional<T>& value)
{
  return value ? json(*value) : json();
}

json
describeLoops(const MeshFacts& facts)
{
  json loops = json::array();
  for (const auto& loop : facts.boundary_loops)
    loops.push_back({{"edges", loop.edges}, {"length", loop.length}});
  return loops;
}

bool
isConsistent(const MeshFacts& facts)
{
  return facts.misoriented_edges == 0 && facts.non_manifold_edges == 0;
}

void
addRow(std::ostringstream& text, const std::string& name, const std::string& value)
{
  text << "  " << name << std::string(name.size() < 24 ? 24 - name.size() : 1, ' ')
       << value << '\n';
}

template <typename T>
std::string
toText(const T& value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string
percent(const MeshFacts& facts, std::size_t count)
{
  return formatted("%zu (%.2f %%)", count, 100 * facts.shareOfVertices(count));
}

std::string
listLoops(const MeshFacts& facts)
{
  std::ostringstream text;
  text << facts.boundary_loops.size();
  const std::size_t shown = std::min(shown_loops, facts.boundary_loops.size());
  for (std::size_t i = 0; i < shown; ++i)
    text << (i == 0 ? ": " : ", ") << facts.boundary_loops[i].edges;
  if (shown > 0)
    text << (shown < facts.boundary_loops.size() ? ", ... edges" : " edges");
  return text.str();
}

std::string
tellWinding(const MeshFacts& facts)
{
  if (!facts.orientable)
    return "one-sided, cannot be wound consistently";
  return isConsistent(facts) ? "consistent"
                             : "not consistent, " + toText(facts.misoriented_edges) +
                                   " edges run the same way twice";
}

void
addTopology(std::ostringstream& text, const MeshFacts& facts)
{
  addRow(text, "components", toText(facts.components));
  addRow(text, "edges", toText(facts.edges));
  addRow(text, "boundary edges", toText(facts.boundary_edges));
  addRow(text, "boundary loops", listLoops(facts));
  addRow(text, "non-manifold edges", toText(facts.non_manifold_edges));
  addRow(text, "non-manifold points", toText(facts.non_manifold_vertices));
  addRow(text, "winding", tellWinding(facts));
  addRow(text, "Euler characteristic", toText(facts.euler_characteristic));
  addRow(text, "watertight", facts.isWatertight() ? "yes" : "no");
  addRow(text, "genus", facts.genus ? toText(*facts.genus) : "- (not manifold)");
}

void
addShape(std::ostringstream& text, const MeshFacts& facts)
{
  addRow(text, "area", toText(facts.area));
  addRow(text, "volume", facts.volume ? toText(*facts.volume) : "- (not closed)");
  addRow(text,
         "self-intersecting pairs",
         facts.self_intersections ? toText(*facts.self_intersections)
                                  : "not looked for");
  addRow(text, "smallest angle", toText(facts.smallest_angle) + " degrees");
}

template <std::size_t Bins>
void
addHistogram(std::ostringstream& text,
             const std::string& title,
             const std::array<std::size_t, Bins>& bins,
             std::size_t degrees)
{
  const std::size_t all = std::accumulate(bins.begin(), bins.end(), std::size_t{0});
  const std::size_t most = *std::max_element(bins.begin(), bins.end());
  if (all == 0)
    return;
  text << "  " << title << '\n';
  for (std::size_t i = 0; i < Bins; ++i) {
    const double share = static_cast<double>(bins[i]) / static_cast<double>(all);
    text << formatted("    %3zu - %3zu  %6.2f %%  ",
                      i * degrees,
                      (i + 1) * degrees,
                      100 * share)
         << std::string(bins[i] * bar_width / most, '#') << '\n';
  }
}

} // namespace

json
describeFacts(const MeshFacts& facts)
{
  return {{"vertices", facts.vertices},
          {"used_vertices", facts.used_vertices},
          {"internal_vertices", facts.internal_vertices},
          {"boundary_vertices", facts.boundary_vertices},
          {"free_vertices", facts.free_vertices},
          {"triangles", facts.triangles},
          {"invalid_triangles", facts.invalid_triangles},
          {"non_finite_triangles", facts.non_finite_triangles},
          {"degenerate_triangles", facts.degenerate_triangles},
          {"components", facts.components},
          {"edges", facts.edges},
          {"boundary_edges", facts.boundary_edges},
          {"boundary_loops", describeLoops(facts)},
          {"non_manifold_edges", facts.non_manifold_edges},
          {"non_manifold_vertices", facts.non_manifold_vertices},
          {"misoriented_edges", facts.misoriented_edges},
          {"consistently_wound", isConsistent(facts)},
          {"orientable", facts.orientable},
          {"closed", facts.isClosedManifold()},
          {"watertight", facts.isWatertight()},
          {"euler_characteristic", facts.euler_characteristic},
          {"genus", orNull(facts.genus)},
          {"area", facts.area},
          {"volume", orNull(facts.volume)},
          {"self_intersections", orNull(facts.self_intersections)},
          {"smallest_angle_degrees", facts.smallest_angle},
          {"minimum_angle_histogram", facts.minimum_angles},
          {"angle_histogram", facts.angles}};
}

std::string
summarizeFacts(const MeshFacts& facts)
{
  const bool is_manifold =
      facts.non_manifold_edges == 0 && facts.non_manifold_vertices == 0;
  std::string text = facts.triangles == 0       ? "no triangles"
                     : facts.isClosedManifold() ? "closed manifold"
                     : is_manifold              ? "open manifold"
                                                : "not manifold";
  const auto tell = [&](std::size_t count, const char* word) {
    text += ", " + toText(count) + " " + word + (count == 1 ? "" : "s");
  };
  tell(facts.triangles, "triangle");
  tell(facts.components, "component");
  tell(facts.boundary_loops.size(), "boundary loop");
  if (!isConsistent(facts))
    text += ", not wound alike";
  if (facts.self_intersections.value_or(0) > 0)
    tell(*facts.self_intersections, "self-intersection");
  return text + ", " +
         summarizeTopology(
             facts.isWatertight(), facts.genus, facts.euler_characteristic);
}

std::string
tabulateFacts(const MeshFacts& facts)
{
  std::ostringstream text;
  addRow(text, "points", toText(facts.vertices));
  addRow(text, "  used", percent(facts, facts.used_vertices));
  addRow(text, "  internal", percent(facts, facts.internal_vertices));
  addRow(text, "  boundary", percent(facts, facts.boundary_vertices));
  addRow(text, "  free", percent(facts, facts.free_vertices));
  addRow(text, "triangles", toText(facts.triangles));
  addRow(text, "  degenerate", toText(facts.degenerate_triangles));
  addRow(text, "  not finite", toText(facts.non_finite_triangles));
  addRow(text, "invalid triangles", toText(facts.invalid_triangles));
  addTopology(text, facts);
  addShape(text, facts);
  addHistogram(
      text, "smallest angle of each triangle, degrees", facts.minimum_angles, 5);
  addHistogram(text, "all angles, degrees", facts.angles, 10);
  return text.str();
}

} // namespace app
