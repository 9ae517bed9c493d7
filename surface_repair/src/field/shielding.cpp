// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: whether the surface stands between two points (E4.43-6).
#include "field/shielding.h"

#include "mesh/box_tree.h"
#include "mesh/intersection.h"

#include <vector>

namespace pcl::repair {
namespace {

/** Operations for a triangle, in each of two steps. */
constexpr std::uint64_t SHIELD_WORK = 5;

/** \brief Box of a triangle that has an area; else empty, so that it is left out. */
ccaa::Box
boxOf(const ccaa::Corners& corners)
{
  return ccaa::isCollinear(corners) ? ccaa::Box() : ccaa::boxOf(corners);
}

} // namespace

struct Shield::Implementation {
  ccaa::BoxTree tree;
  std::vector<ccaa::Corners> triangles; /**< by place in the tree */
};

Shield::Shield(const IncompleteModel& model, int threads, ccaa::RunControl* control)
: implementation_(std::make_unique<Implementation>())
{
  std::vector<ccaa::Box> boxes;
  boxes.reserve(model.triangles.size());
  ccaa::WorkCount work(control);
  for (const Triangle& triangle : model.triangles) {
    boxes.push_back(boxOf(ccaa::cornersOf(triangle, model.positions)));
    work.add(SHIELD_WORK);
  }
  const std::vector<pcl::index_t> order =
      ccaa::neighboringOrder(boxes, threads, control);
  for (const pcl::index_t i : order) {
    implementation_->triangles.push_back(
        ccaa::cornersOf(model.triangles[static_cast<std::size_t>(i)], model.positions));
    work.add(SHIELD_WORK);
  }
  implementation_->tree =
      ccaa::BoxTree(order.size(), {threads}, [&](std::size_t place) {
        return ccaa::boxOf(implementation_->triangles[place]);
      });
}

Shield::~Shield() = default;

bool
Shield::crosses(const Position& a, const Position& b, double tolerance) const
{
  const Eigen::Vector3d way = b - a;
  const double length = way.norm();
  if (!(length > 2.0 * tolerance) || !(length > 0.0))
    return false;
  const Eigen::Vector3d margin = way * (tolerance / length);
  const Position begin = a + margin, end = b - margin;
  const std::vector<ccaa::Corners>& triangles = implementation_->triangles;
  return implementation_->tree.anyAlong(begin, end, [&](pcl::index_t place) {
    return ccaa::segmentMeetsTriangle(
        begin, end, triangles[static_cast<std::size_t>(place)]);
  });
}

} // namespace pcl::repair
