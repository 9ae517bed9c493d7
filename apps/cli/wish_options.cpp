// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what users want closed and joined, on the command line.
#include "wish_options.h"

#include <cmath>
#include <cstdlib>
#include <utility>

namespace app {
namespace {

namespace po = boost::program_options;
using pcl::repair::Cap;
using pcl::repair::CloseChoice;
using pcl::repair::Extent;
using pcl::repair::RepairParameters;
using pcl::repair::SmallIslands;

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

/** \brief A length such as 12.5, or 5% of the diagonal. */
Status
takeExtent(const Arguments& arguments, const std::string& name, Extent& extent)
{
  const std::string text = takeText(arguments, name);
  if (arguments.count(name) == 0)
    return {};
  double number = 0.0;
  std::string unit;
  if (!splitNumber(text, number, unit) || (!unit.empty() && unit != "%"))
    return Status::error("--" + name +
                         " must be a length in units of the cloud, or a share of the "
                         "bounding box' diagonal such as 5%, not '" +
                         text + "'");
  extent = unit.empty() ? Extent(number) : Extent(number / 100.0, true);
  return {};
}

Status
takeClose(const Arguments& arguments, CloseChoice& choice)
{
  const std::string text = takeText(arguments, "close");
  for (const auto& [name, named] :
       {std::pair<const char*, CloseChoice>{"all", CloseChoice::ALL},
        {"holes", CloseChoice::HOLES},
        {"none", CloseChoice::NOTHING}})
    if (text == name) {
      choice = named;
      return {};
    }
  return Status::error("--close must be all, holes or none, not '" + text + "'");
}

/** \brief Islands below 50 (triangles), 0.5% (of the area of all) or 2.5u2 (squared
 * units of the cloud). */
Status
takeDroppedIslands(const Arguments& arguments, SmallIslands& small)
{
  if (arguments.count("drop-islands") == 0)
    return {};
  const std::string text = takeText(arguments, "drop-islands");
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
    return Status::error("--drop-islands must be a number of triangles such as 50, a "
                         "share of the whole area such as 0.5%, or an area in squared "
                         "units of the cloud such as 2.5u2, not '" +
                         text + "'");
  return {};
}

Status
takeCap(const Arguments& arguments, Cap& cap)
{
  const std::string text = takeText(arguments, "cap");
  for (const auto& [name, named] : {std::pair<const char*, Cap>{"auto", Cap::AUTO},
                                    {"smooth", Cap::SMOOTH},
                                    {"flat", Cap::FLAT}})
    if (text == name) {
      cap = named;
      return {};
    }
  return Status::error("--cap must be smooth, flat or auto, not '" + text + "'");
}

/** \brief A surface without a boundary leaves nothing open. */
Status
checkWatertight(const Arguments& arguments)
{
  if (arguments.count("watertight") == 0)
    return {};
  const bool closes_less =
      !arguments["close"].defaulted() && takeText(arguments, "close") != "all";
  const bool limits = arguments.count("greatest-hole-length") != 0 ||
                      !arguments["greatest-hole"].defaulted();
  if (closes_less || limits)
    return Status::error(
        "--watertight closes all that can be closed; it does not go "
        "with " +
        std::string(closes_less ? "--close holes or none" : "a greatest hole"));
  return {};
}

} // namespace

void
addWishOptions(CommandLine& command_line)
{
  auto add = command_line.addOptions();
  add("close",
      po::value<std::string>()->default_value("holes"),
      "holes: what is a hole for sure; all: also outer borders, mouths of tubes, "
      "undecided boundaries and rims that nothing joins; none: only join islands");
  add("watertight",
      "close all that can be closed; exit code 2 where anything stays open");
  add("cap",
      po::value<std::string>()->default_value("auto"),
      "smooth: patches go on as the surface around does; flat: they lie in the plane "
      "of "
      "their rim; auto: flat over a large plane rim that the surface meets steeply, as "
      "at the base of a bust");
  add("drop-islands",
      po::value<std::string>(),
      "leave out islands of fewer triangles (50), or of less area: 0.5% of the whole, "
      "or 2.5u2, squared units of the cloud; their points stay, but draw nothing");
  add("greatest-hole",
      po::value<long long>()->default_value(0),
      "holes of more edges are left open, 0: no limit");
  add("greatest-hole-length",
      po::value<std::string>(),
      "longer holes are left open: units of the cloud, or 5% of the bounding box' "
      "diagonal");
  add("greatest-bridge",
      po::value<std::string>(),
      "islands are not joined over a longer way: units as above");
}

Status
takeWishes(const Arguments& arguments, RepairParameters& method)
{
  unsigned int greatest_hole = 0;
  Status status = takeClose(arguments, method.darning.close);
  if (status.ok())
    status = takeCap(arguments, method.darning.cap);
  if (status.ok())
    status = takeDroppedIslands(arguments, method.survey.dropped);
  if (status.ok())
    status = takeCount(arguments, "greatest-hole", 0, 1000000000, greatest_hole);
  method.darning.greatest_hole = greatest_hole;
  if (status.ok())
    status =
        takeExtent(arguments, "greatest-hole-length", method.darning.greatest_length);
  if (status.ok())
    status = takeExtent(arguments, "greatest-bridge", method.survey.greatest_bridge);
  if (status.ok())
    status = checkWatertight(arguments);
  method.watertight = arguments.count("watertight") != 0;
  if (method.watertight)
    method.darning.close = CloseChoice::ALL;
  return status;
}

} // namespace app
