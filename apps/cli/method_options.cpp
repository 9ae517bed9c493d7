// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: options of the methods, for every program that runs them.
#include "method_options.h"

#include "number_list.h"

#include <cmath>
#include <cstdlib>
#include <limits>

namespace app {
namespace {

using pcl::repair::CloseChoice;
using pcl::repair::Extent;
using pcl::repair::FieldParameters;
using pcl::repair::FillingChoice;
using pcl::repair::RepairParameters;
using pcl::repair::SmallIslands;

constexpr double LARGEST = 1e30; // of lengths, which have the units of the cloud
constexpr double BELOW_ONE = 1.0 - std::numeric_limits<double>::epsilon();
constexpr double ABOVE_ZERO = 1e-6; // least value of what has to be above 0
constexpr long long MOST_EDGES = 1000000000;

/** \brief A number, and what follows it. \return false where there is no number of at
 * least 0 */
bool
splitNumber(const std::string& text, double& number, std::string& unit)
{
  char* end = nullptr;
  number = std::strtod(text.c_str(), &end);
  unit = end;
  return end != text.c_str() && std::isfinite(number) && number >= 0.0;
}

/** \brief An option with a length such as 12.5, or 5% of the diagonal. */
void
addExtent(CommandLine& line,
          const std::string& name,
          Extent& extent,
          const std::string& help,
          const std::string& use)
{
  line.options().parsed(name, [&extent, name](const std::string& text) {
    double number = 0.0;
    std::string unit;
    if (!splitNumber(text, number, unit) || (!unit.empty() && unit != "%"))
      throw Failure("--" + name +
                    " must be a length in units of the cloud, or a share of the "
                    "bounding box' diagonal such as 5%, not '" +
                    text + "'");
    extent = unit.empty() ? Extent(number) : Extent(number / 100.0, true);
  })(help, use);
}

/** \brief Islands below 50 (triangles), 0.5% (of the area of all) or 2.5u2 (squared
 * units of the cloud). */
void
takeDroppedIslands(const std::string& text, SmallIslands& small)
{
  double number = 0.0;
  std::string unit;
  const bool is_number = splitNumber(text, number, unit);
  const bool is_count = unit.empty() && std::floor(number) == number && number < 1e15;
  if (is_number && is_count)
    small.triangles = static_cast<std::size_t>(number);
  else if (is_number && unit == "%")
    small.share_of_all_area = number / 100.0;
  else if (is_number && unit == "u2")
    small.area = number;
  else
    throw Failure("--drop-islands must be a number of triangles such as 50, a share of "
                  "the whole area such as 0.5%, or an area in squared units of the "
                  "cloud such as 2.5u2, not '" +
                  text + "'");
}

/** \brief A surface without a boundary leaves nothing open. */
void
checkWatertight(const CommandLine& line, RepairParameters& method)
{
  if (!method.watertight)
    return;
  const bool closes_less =
      line.given("close") && method.filling.close != CloseChoice::ALL;
  if (closes_less || line.given("greatest-hole-length") || line.given("greatest-hole"))
    throw Failure(
        std::string(
            "--watertight closes all that can be closed; it does not go with ") +
        (closes_less ? "--close holes or none" : "a greatest hole"));
  method.filling.close = CloseChoice::ALL;
}

void
addFillingOptions(CommandLine& line, RepairParameters& method)
{
  OptionGroup& options = line.method();
  options.choice("filling", method.filling.choice, FILLING_CHOICES)(
      "how simple holes are closed: fan (from the centroid), minimum-weight, "
      "completion (base algorithm, with free points as vertices), or automatic: "
      "completion where a hole holds enough free points, else minimum-weight",
      "as fan to compare with the thesis, as completion where free points lie dense");
  options.real("edge-length", method.refinement.edge_length, ABOVE_ZERO, 1e6)(
      "edges of new triangles, in those of the surface around, above 0",
      "above 1 for fewer triangles");
  options.flag("no-refine", method.refine, false)(
      "do not make new triangles as small as those around; not fair either",
      "where few triangles matter more than a smooth patch");
  options.flag("no-fair", method.relax, false)(
      "do not move new vertices to a smooth surface",
      "to see the bare patch, or to fair it by other means");
  options.flag("pure",
               [&method] {
                 method.filling.choice = FillingChoice::FAN;
                 method.refine = false;
                 method.crumb_triangles = 0;
               })("the thesis alone: --filling fan --no-refine --crumbs 0",
                  "to compare with the thesis");
}

void
addFieldOptions(OptionGroup& options, FieldParameters& field)
{
  options.real("interpolation", field.interpolation, 0.0, 1000.0)(
      "k_i: how much more a boundary counts for places straight ahead of it, 0 or "
      "more",
      "at 1 for ragged boundaries");
  options.real("falloff-exponent", field.falloff_exponent, ABOVE_ZERO, 100.0)(
      "chi: how fast the field falls off with distance, above 0",
      "at 1.7 for long wide gaps");
  options.real("near", field.near, 0.0, LARGEST)(
      "L1: distance up to which it does not, units of the cloud; 0: the mean spacing "
      "of boundary points",
      "at some five edges where boundaries are torn");
  options.real("far", field.far, 0.0, LARGEST)(
      "L2: distance from which there is no field; 0: --room times the gap at each "
      "place",
      "where all gaps are alike");
  options.real("room", field.room, 1.0 + ABOVE_ZERO, 1e6)(
      "gaps that L2 spans, above 1",
      "lower where lines leave narrow gaps for wide ones, higher where they lose their "
      "targets");
  options.real("coarse-distance", field.coarse_distance, 0.0, LARGEST)(
      "eight sources of the field further away than so many radii of their stretch of "
      "boundary count as one; 0: all count for themselves",
      "higher where force lines have to be exact");
  options.real("free-point-near", field.free_point_near, 0.0, LARGEST)(
      "R1: the same as L1 for the influence of a free point; 0: their mean spacing",
      "where free points lie in clusters");
  options.real("free-point-far", field.free_point_far, 0.0, LARGEST)(
      "R2: the same as L2 for it; 0: half the mean gap",
      "greater where bridges pass by free points, less where a cluster beside the gap "
      "pulls them");
  options.real("free-point-exponent", field.free_point_exponent, ABOVE_ZERO, 100.0)(
      "gamma: how fast it falls off, above 0",
      "higher where the nearest free points should rule");
  options.real("trust", field.trust, 0.0, BELOW_ONE)(
      "k_t: how far free points are to be trusted, 0 to less than 1",
      "higher for exact samples, lower for noisy ones");
}

void
addSurveyOptions(OptionGroup& options, pcl::repair::SurveyParameters& survey)
{
  options.choice("mode", survey.field.mode, FIELD_MODES)(
      "light: distances as they are; full: free points shorten ways and the surface "
      "stands in the way (slower)",
      "as full where free points or thin walls lie between islands");
  addFieldOptions(options, survey.field);
  options.count("simple-edges", survey.simple_edges, 0, MOST_EDGES)(
      "holes of up to so many edges are simple: they are closed without being divided",
      "higher to close larger holes undivided");
  options.real("hole-threshold", survey.hole_threshold, ABOVE_ZERO, 0.5)(
      "T: within a hole no line ends nearer to its origin than this share of the "
      "boundary's length, above 0 to 0.5",
      "lower for long narrow holes");
  options.real("line-spacing", survey.line_spacing, ABOVE_ZERO, 1e6)(
      "least distance between the origins of force lines, in gaps, above 0",
      "lower where a short boundary gets too few lines");
  options.real("bridge-spacing", survey.bridge_spacing, ABOVE_ZERO, 1e6)(
      "least distance between bridges, in lengths of the bridge, above 0",
      "lower for curved gaps, higher for ragged boundaries");
}

/** \brief What some options say about more than their own value. */
void
settle(const CommandLine& line, RepairParameters& method)
{
  if (line.given("simple-edges"))
    method.filling.simple_edges = method.survey.simple_edges;
  method.relax = method.relax && method.refine;
}

} // namespace

void
addSideOptions(CommandLine& command_line, pcl::ccaa::SideHints& told)
{
  const auto add = [&](const std::string& name,
                       auto& place,
                       const std::string& help,
                       const std::string& use) {
    command_line.options().parsed(name, [&place, name](const std::string& text) {
      return parsePlace(name, text, place.emplace(Eigen::Vector3d::Zero()));
    })(help, use);
  };
  add("viewpoint",
      told.told_viewpoint,
      "X,Y,Z: where the sensor stood, units of the cloud; the outer side is what it "
      "sees. Goes before normals and viewpoints of the input",
      "for open surfaces without normals");
  add("up",
      told.up,
      "X,Y,Z: where the outer side looks; goes before normals and viewpoints of the "
      "input",
      "for terrain and floors: 0,0,1");
  command_line.then([&told] {
    if (told.up && told.up->norm() < 1e-12)
      throw Failure("--up must not be zero");
  });
}

void
addWishOptions(CommandLine& command_line, RepairParameters& method)
{
  OptionGroup& options = command_line.options();
  options.choice("close", method.filling.close, CLOSE_CHOICES)(
      "holes: what is a hole for sure; all: also outer borders, mouths of tubes, "
      "undecided boundaries and rims that nothing joins; none: only join islands",
      "as all for a closed model, as none where only islands are to be joined");
  options.flag("watertight", method.watertight)(
      "close all that can be closed; exit code 2 where anything stays open",
      "for printing and for volumes");
  options.choice("cap", method.filling.cap, CAPS)(
      "smooth: patches go on as the surface around does; flat: they lie in the plane "
      "of their rim; auto: flat over a large plane rim that the surface meets steeply, "
      "as at the base of a bust",
      "as flat for objects that stood on something, or were cut off");
  options.parsed("drop-islands",
                 [&method](const std::string& text) {
                   return takeDroppedIslands(text, method.survey.dropped);
                 })(
      "leave out islands of fewer triangles (50), or of less area: 0.5% of the whole, "
      "or 2.5u2, squared units of the cloud; their points stay, but draw nothing",
      "against crumbs of strays");
  options.count("greatest-hole", method.filling.greatest_hole, 0, MOST_EDGES)(
      "holes of more edges are left open, 0: no limit", "where large holes are real");
  addExtent(command_line,
            "greatest-hole-length",
            method.filling.greatest_length,
            "longer holes are left open: units of the cloud, or 5% of the bounding "
            "box' diagonal",
            "where a length tells which holes are real");
  addExtent(command_line,
            "greatest-bridge",
            method.survey.greatest_bridge,
            "islands are not joined over a longer way: units as above",
            "where separate objects lie near each other");
  command_line.then([&] { return checkWatertight(command_line, method); });
}

void
addMethodOptions(CommandLine& command_line, RepairParameters& method)
{
  addSideOptions(command_line, method.survey.orientation.sides);
  command_line.options().flag("no-join", method.join_islands, false)(
      "leave islands apart", "where each island is an object");
  command_line.options().count("crumbs", method.crumb_triangles, 0, MOST_EDGES)(
      "islands of fewer triangles wait until the others are joined, and are laid into "
      "the patches that cover them; 0: none wait, nor do any with decisions",
      "at 0 where small islands are as good as large ones");
  command_line.options().real(
      "greatest-unsupported", method.greatest_unsupported, 0.0, 1.0)(
      "share of the surface above which what is new, and little supports, leaves the "
      "result in doubt (exit code 2); 1: never",
      "lower where invented surface does harm");
  addWishOptions(command_line, method);
  addFillingOptions(command_line, method);
  addSurveyOptions(command_line.method(), method.survey);
  command_line.then([&] { return settle(command_line, method); });
}

} // namespace app
