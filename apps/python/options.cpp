// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: options of the Python functions and the C++ values behind
// them.
#include "options.h"

#include "generated_options.h"
#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace app::python {
namespace {

namespace py = pybind11;
using pcl::repair::Extent;

std::string
quoted(const char* name, const py::handle& value)
{
  return std::string(name) + "=" + py::repr(value).cast<std::string>() + " needs ";
}

template <typename Value>
Value
castTo(const char* kind, const char* name, const py::handle& value)
{
  try {
    return value.cast<Value>();
  }
  catch (const py::cast_error&) {
    throw py::type_error(quoted(name, value) + kind);
  }
}

void
set(const char* name, const py::handle& value, bool& target)
{
  target = castTo<bool>("True or False", name, value);
}

void
set(const char* name, const py::handle& value, double& target)
{
  const auto number = castTo<double>("a number", name, value);
  if (!std::isfinite(number))
    throw py::value_error(quoted(name, value) + "to be finite");
  target = number;
}

template <typename Count, std::enable_if_t<std::is_unsigned_v<Count>, int> = 0>
void
set(const char* name, const py::handle& value, Count& target)
{
  target = castTo<Count>("a whole number of at least 0", name, value);
}

/** A length in units of the cloud, or "5%" of the diagonal of the bounding box. */
void
set(const char* name, const py::handle& value, Extent& target)
{
  if (!py::isinstance<py::str>(value)) {
    double length = 0.0;
    set(name, value, length);
    target = Extent(length);
    return;
  }
  const auto text = value.cast<std::string>();
  char* end = nullptr;
  const double share = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || std::string(end) != "%" || !std::isfinite(share))
    throw py::value_error(quoted(name, value) + "a length, or a share such as '5%'");
  target = Extent(share / 100.0, true);
}

template <typename Enum, std::enable_if_t<std::is_enum_v<Enum>, int> = 0>
void
set(const char* name, const py::handle& value, Enum& target)
{
  const auto text = castTo<std::string>("a word", name, value);
  std::string all;
  for (const auto& [word, meaning] : wordsOf(target)) {
    if (text == word) {
      target = meaning;
      return;
    }
    all += (all.empty() ? "'" : ", '") + std::string(word) + "'";
  }
  throw py::value_error(quoted(name, value) + "one of " + all);
}

template <typename Value>
py::object
toPython(const Value& value)
{
  if constexpr (std::is_enum_v<Value>) {
    for (const auto& [word, meaning] : wordsOf(value))
      if (meaning == value)
        return py::str(word);
    return py::none();
  }
  else if constexpr (std::is_same_v<Value, Extent>)
    return value.of_diagonal
               ? py::object(py::str(std::to_string(value.value * 100) + "%"))
               : py::object(py::float_(value.value));
  else
    return py::cast(value);
}

auto
setter(const py::dict& given)
{
  return [&given](const char* name, auto& value) {
    if (given.contains(name))
      set(name, given[name], value);
  };
}

} // namespace

void
take(const py::dict& given, CleanParameters& parameters)
{
  visitCleanOptions(parameters, setter(given));
}

void
take(const py::dict& given, ReconstructOptions& options)
{
  visitReconstructOptions(options.start, options.filter, options.base, setter(given));
}

void
take(const py::dict& given, pcl::UmbrellaFilter& filter)
{
  visitUmbrellaFilterOptions(filter, setter(given));
}

void
take(const py::dict& given, pcl::BoundaryClassifier& classifier)
{
  visitClassifyBoundariesOptions(classifier, setter(given));
}

void
take(const py::dict& given, pcl::repair::RepairParameters& method)
{
  visitRepairOptions(method, setter(given));
}

pcl::ccaa::SideHints
sidesFrom(const py::dict& given)
{
  const auto place = [&given](const char* name) -> std::optional<Eigen::Vector3d> {
    const py::object value = given[name];
    if (value.is_none())
      return std::nullopt;
    const auto numbers = castTo<std::array<double, 3>>("three numbers", name, value);
    const Eigen::Vector3d position(numbers[0], numbers[1], numbers[2]);
    if (!position.allFinite())
      throw py::value_error(quoted(name, value) + "to be finite");
    return position;
  };
  pcl::ccaa::SideHints sides;
  sides.told_viewpoint = place("viewpoint");
  sides.up = place("up");
  if (sides.up && sides.up->isZero())
    throw py::value_error("up must not be zero: it tells a direction");
  sides.try_origin = given["origin_as_viewpoint"].cast<bool>();
  return sides;
}

py::dict
defaults()
{
  py::dict all;
  py::dict of_function;
  const auto collect = [&of_function](const char* name, auto& value) {
    of_function[name] = toPython(value);
  };
  const auto store = [&](const char* function) {
    all[function] = std::exchange(of_function, py::dict());
  };
  CleanParameters cleaning;
  visitCleanOptions(cleaning, collect);
  store("clean");
  ReconstructOptions chain;
  visitReconstructOptions(chain.start, chain.filter, chain.base, collect);
  store("reconstruct");
  pcl::UmbrellaFilter filter;
  visitUmbrellaFilterOptions(filter, collect);
  store("umbrella_filter");
  pcl::BoundaryClassifier classifier;
  visitClassifyBoundariesOptions(classifier, collect);
  store("classify_boundaries");
  pcl::repair::RepairParameters method;
  visitRepairOptions(method, collect);
  store("repair");
  return all;
}

} // namespace app::python
