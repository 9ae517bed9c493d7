// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how free points shorten what passes near them (4.424).
#include "field/free_point_field.h"

#include "field/float_tree.h"
#include "field/tension_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::repair {
namespace {

/** \brief Parts to R_2 in which a segment is measured, and bounds of their number. */
constexpr double PARTS_TO_FAR = 1.5;
constexpr double FEWEST_PARTS = 3.0;
constexpr double MOST_PARTS = 64.0;

} // namespace

struct FreePointField::Implementation {
  Positions points;
  Falloff falloff;
  double tension; /**< G(0) */
  FloatTree tree;
  TensionGrid grid;
};

FreePointField::FreePointField(Positions points,
                               const Falloff& falloff,
                               double trust,
                               PointSearchPtr search)
: implementation_(std::make_unique<Implementation>())
{
  implementation_->points = std::move(points);
  implementation_->falloff = falloff;
  implementation_->tension = trustedTension(trust);
  implementation_->tree = FloatTree(implementation_->points, std::move(search));
  implementation_->grid =
      TensionGrid(implementation_->points, falloff, implementation_->tension);
}

FreePointField::~FreePointField() = default;

const Positions&
FreePointField::points() const
{
  return implementation_->points;
}

const Falloff&
FreePointField::falloff() const
{
  return implementation_->falloff;
}

double
FreePointField::tensionAt(const Position& position) const
{
  double sum = 0.0;
  for (const pcl::index_t i : within(position, falloff().far)) {
    const Position& point = points()[static_cast<std::size_t>(i)];
    sum += falloff()((point - position).norm());
  }
  return implementation_->tension * sum; // E4.45-2
}

double
FreePointField::lengthRatio(const Position& a, const Position& b) const
{
  const double parts = PARTS_TO_FAR * (b - a).norm() / falloff().far;
  if (!(falloff().far > 0.0))
    return 1.0;
  return implementation_->grid.meanShrink(
      a, b, static_cast<int>(std::clamp(parts, FEWEST_PARTS, MOST_PARTS)));
}

std::vector<pcl::index_t>
FreePointField::within(const Position& center, double radius) const
{
  std::vector<pcl::index_t> found;
  implementation_->tree.near(center, radius, found);
  const auto isFar = [&](pcl::index_t i) {
    return !((points()[static_cast<std::size_t>(i)] - center).norm() <= radius);
  };
  found.erase(std::remove_if(found.begin(), found.end(), isFar), found.end());
  return found;
}

std::vector<pcl::index_t>
FreePointField::nearest(const Position& center, std::size_t number) const
{
  return implementation_->tree.nearest(center, number);
}

} // namespace pcl::repair
