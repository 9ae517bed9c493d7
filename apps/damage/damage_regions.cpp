// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: spheres and slabs inside which points are taken away.
#include "damage_regions.h"

#include "io/text_scanner.h"

#include <algorithm>
#include <limits>

namespace app {
namespace {

/** Numbers between commas, exactly \a count of them and all finite. */
bool
parseList(const std::string& text, std::size_t count, std::vector<double>& numbers)
{
  std::string words = text;
  std::replace(words.begin(), words.end(), ',', ' ');
  TextScanner scanner(words);
  std::string_view word;
  while (scanner.nextWord(word)) {
    double value = 0;
    if (!parseNumber(word, value) || !std::isfinite(value))
      return false;
    numbers.push_back(value);
  }
  return numbers.size() == count;
}

} // namespace

RegionMaker::RegionMaker(const Points& points,
                         bool absolute,
                         const pcl::GlobalShift& shift)
: points_(points), absolute_(absolute), shift_(shift.offset())
{
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite()) {
      box_.extend(points[i].cast<double>());
      finite_.push_back(i);
    }
}

void
RegionMaker::parseSphere(const std::string& text, Sphere& sphere) const
{
  std::vector<double> numbers;
  if (!parseList(text, 4, numbers) || numbers[3] <= 0)
    throw Failure("--sphere wants x,y,z,r with a positive r, not '" + text + "'");
  const Eigen::Vector3d place(numbers[0], numbers[1], numbers[2]);
  if (absolute_)
    sphere.center = place - shift_;
  else
    sphere.center = box_.min() + place.cwiseProduct(box_.sizes());
  sphere.radius = numbers[3] * (absolute_ ? 1.0 : box_.diagonal().norm());
}

void
RegionMaker::parseSlab(const std::string& text, Slab& slab) const
{
  std::vector<double> numbers;
  const bool good = parseList(text, 5, numbers);
  const Eigen::Vector3d normal =
      good ? Eigen::Vector3d(numbers[0], numbers[1], numbers[2])
           : Eigen::Vector3d(0, 0, 0);
  const double length = normal.norm();
  if (!good || !(length > 0) || numbers[4] <= 0)
    throw Failure("--slab wants nx,ny,nz,offset,thickness with a normal that is not "
                  "zero and a positive thickness, not '" +
                  text + "'");
  if (absolute_)
    slab = {normal / length, numbers[3] - normal.dot(shift_) / length, numbers[4] / 2};
  else
    slab = slabInShares(normal / length, numbers[3], numbers[4]);
}

Slab
RegionMaker::slabInShares(const Eigen::Vector3d& normal,
                          double offset,
                          double thickness) const
{
  double lowest = std::numeric_limits<double>::max();
  double highest = std::numeric_limits<double>::lowest();
  for (const std::size_t i : finite_) {
    const double height = normal.dot(points_[i].cast<double>());
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  const double extent = highest - lowest;
  return {normal, lowest + offset * extent, thickness * extent / 2};
}

Sphere
RegionMaker::randomSphere(double size, RandomNumbers& random) const
{
  const std::size_t center = finite_[random.below(finite_.size())];
  return {points_[center].cast<double>(), size * box_.diagonal().norm()};
}

Slab
RegionMaker::randomSlab(double size, RandomNumbers& random) const
{
  Eigen::Vector3d normal;
  do
    for (int axis = 0; axis < 3; ++axis)
      normal[axis] = random.normal();
  while (normal.norm() < 1e-6);
  const double offset = 0.1 + 0.8 * random.uniform();
  return slabInShares(normal.normalized(), offset, size);
}

void
markSphere(const Sphere& sphere, const Points& points, std::vector<char>& removed)
{
  for (std::size_t i = 0; i < points.size(); ++i)
    if ((points[i].cast<double>() - sphere.center).norm() < sphere.radius)
      removed[i] = 1;
}

void
markSlab(const Slab& slab, const Points& points, std::vector<char>& removed)
{
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double height = slab.normal.dot(points[i].cast<double>());
    if (points[i].allFinite() && std::abs(height - slab.middle) <= slab.half_thickness)
      removed[i] = 1;
  }
}

} // namespace app
