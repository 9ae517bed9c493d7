// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what given normals and sensor positions say about sides.

#include "orientation/given_sides.h"

#include "mesh/corners.h"

namespace pcl {
namespace repair {

namespace {

const Position&
cornerOf(const Positions& list, const Triangle& triangle, std::size_t corner)
{
  return list[static_cast<std::size_t>(triangle[corner])];
}

/** Let every triangle vote with its area vector against a direction it looks up. */
template <typename DirectionOf>
std::vector<SideVotes>
votesAgainst(const IncompleteModel& model, const DirectionOf& directionOf)
{
  std::vector<SideVotes> votes(model.islands.size());
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    const Eigen::Vector3d direction = directionOf(model.triangles[t]);
    const double length = direction.norm();
    if (length > 0.0 && std::isfinite(length))
      votes[model.island_of[t]].add(
          ccaa::areaNormal(ccaa::cornersOf(model.triangles[t], model.positions))
              .dot(direction) /
          length);
  }
  return votes;
}

} // namespace

std::vector<SideVotes>
votesOfNormals(const IncompleteModel& model)
{
  if (model.given_normals.empty())
    return std::vector<SideVotes>(model.islands.size());
  return votesAgainst(model, [&](const Triangle& triangle) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Eigen::Vector3d& normal = cornerOf(model.given_normals, triangle, corner);
      if (normal.allFinite() && !normal.isZero(0.0))
        sum += normal.normalized();
    }
    return sum;
  });
}

std::vector<SideVotes>
votesOfUp(const IncompleteModel& model, const Direction& up)
{
  return votesAgainst(model, [&](const Triangle&) { return up; });
}

std::vector<SideVotes>
votesOfViewpoints(const IncompleteModel& model)
{
  if (model.viewpoints.empty())
    return std::vector<SideVotes>(model.islands.size());
  return votesAgainst(model, [&](const Triangle& triangle) {
    return Eigen::Vector3d(cornerOf(model.viewpoints, triangle, 0) -
                           cornerOf(model.positions, triangle, 0));
  });
}

} // namespace repair
} // namespace pcl
