// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how much a patch is bent, and would be.

#include "fairing/patch_bending.h"

#include "mesh/corners.h"

#include <algorithm>

namespace pcl::repair {

namespace {

/** What an edge between two triangles adds to the total absolute mean curvature. */
double
bendingAt(const Position& a,
          const Position& b,
          const Direction& one,
          const Direction& other)
{
  return (a - b).norm() * ccaa::angleBetween(one, other);
}

} // namespace

PatchBending::PatchBending(const IncompleteModel& model,
                           const Patch& patch,
                           const PatchEdges& edges)
: patch_(patch), edges_(edges)
{
  for (std::size_t side = 0; side < edges_.count(); ++side)
    if (!edges_.isInner(side))
      noteRim(model, edges_.from(side), edges_.to(side));
}

void
PatchBending::noteRim(const IncompleteModel& model, std::size_t from, std::size_t to)
{
  if (from >= patch_.rim.size() || to >= patch_.rim.size())
    return;
  const pcl::index_t start = patch_.rim[to]; // the model runs the other way
  const auto& adjacency = model.adjacency;
  for (const auto* t = adjacency.begin(start); t != adjacency.end(start); ++t) {
    const Triangle& triangle = model.triangles[static_cast<std::size_t>(*t)];
    for (std::size_t c = 0; c < 3; ++c)
      if (triangle[c] == start && triangle[(c + 1) % 3] == patch_.rim[from])
        beyond_rim_[{from, to}] =
            ccaa::unitNormal(ccaa::cornersOf(triangle, model.positions));
  }
}

void
PatchBending::note(std::size_t triangle)
{
  normals_.resize(std::max(normals_.size(), triangle + 1));
  normals_[triangle] =
      ccaa::unitNormal(ccaa::cornersOf(patch_.triangles[triangle], patch_.positions));
}

double
PatchBending::of(const std::vector<std::size_t>& triangles) const
{
  double inner = 0.0, border = 0.0;
  for (const std::size_t t : triangles)
    for (std::size_t side = 3 * t; side < 3 * t + 3; ++side) {
      const bool is_inner =
          edges_.isInner(side) &&
          std::find(triangles.begin(), triangles.end(), edges_.across(side) / 3) !=
              triangles.end();
      (is_inner ? inner : border) += bendingAt(
          at(edges_.from(side)), at(edges_.to(side)), normals_[t], normalBeyond(side));
    }
  return 0.5 * inner + border;
}

double
PatchBending::ofStar(const std::vector<std::size_t>& disc, const Position& point) const
{
  double sum = 0.0;
  const std::vector<std::size_t> border = edges_.borderOf(disc);
  Directions normals;
  for (const std::size_t side : border) {
    const Position &from = at(edges_.from(side)), &to = at(edges_.to(side));
    normals.push_back(ccaa::unitNormal({from, to, point}));
    sum += bendingAt(from, to, normals.back(), normalBeyond(side));
  }
  for (std::size_t i = 0; i < border.size(); ++i)
    for (std::size_t k = 0; k < border.size(); ++k)
      if (edges_.to(border[i]) == edges_.from(border[k]))
        sum += bendingAt(at(edges_.to(border[i])), point, normals[i], normals[k]);
  return sum;
}

/** The normal beyond a side; zero where nothing is. */
Direction
PatchBending::normalBeyond(std::size_t side) const
{
  if (edges_.isInner(side))
    return normals_[edges_.across(side) / 3];
  const auto known = beyond_rim_.find({edges_.from(side), edges_.to(side)});
  return known == beyond_rim_.end() ? Direction(Direction::Zero()) : known->second;
}

double
PatchBending::ofFlipped(std::size_t side) const
{
  const auto [a, b, c, d] = edges_.pairAt(side);
  const std::size_t beyond = edges_.across(side), one = side / 3, two = beyond / 3;
  const Direction at_a = ccaa::unitNormal({at(a), at(d), at(c)});
  const Direction at_b = ccaa::unitNormal({at(d), at(b), at(c)});
  const auto normalAt = [&](std::size_t triangle, std::size_t corner) {
    return normalBeyond(3 * triangle + corner % 3);
  };
  return bendingAt(at(c), at(d), at_a, at_b) +
         bendingAt(at(b), at(c), at_b, normalAt(one, side + 1)) +
         bendingAt(at(c), at(a), at_a, normalAt(one, side + 2)) +
         bendingAt(at(a), at(d), at_a, normalAt(two, beyond + 1)) +
         bendingAt(at(d), at(b), at_b, normalAt(two, beyond + 2));
}

} // namespace pcl::repair
