// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: shapes with a hole and a patch in it, for tests.
#include "fairing_samples.h"

#include "icadm/model_assembly.h"
#include "support/mesh_asserts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace pcl::repair::test {
namespace {

using Edge = std::pair<pcl::index_t, pcl::index_t>;
using Loop = std::vector<pcl::index_t>;

std::set<Edge>
sidesOf(const Triangles& triangles)
{
  std::set<Edge> sides;
  for (const Triangle& triangle : triangles)
    for (std::size_t c = 0; c < 3; ++c)
      sides.emplace(triangle[c], triangle[(c + 1) % 3]);
  return sides;
}

/** The border of a disc, in the direction of its triangles. */
Loop
borderOf(const Triangles& disc)
{
  const std::set<Edge> sides = sidesOf(disc);
  std::map<pcl::index_t, pcl::index_t> next;
  for (const Edge& side : sides)
    if (sides.count({side.second, side.first}) == 0)
      next[side.first] = side.second;
  Loop loop;
  for (pcl::index_t v = next.begin()->first; loop.size() < next.size(); v = next[v])
    loop.push_back(v);
  return loop;
}

/** The shape without some triangles as a model, and where its vertices went. */
IncompleteModel
modelOf(const ccaa::test::Shape& shape,
        const Triangles& kept,
        std::vector<pcl::index_t>& number)
{
  number.assign(shape.vertices.size(), -1);
  Positions positions;
  Triangles triangles = kept;
  for (Triangle& triangle : triangles)
    for (pcl::index_t& corner : triangle) {
      pcl::index_t& there = number[static_cast<std::size_t>(corner)];
      if (there < 0) {
        there = static_cast<pcl::index_t>(positions.size());
        positions.push_back(shape.vertices[static_cast<std::size_t>(corner)]);
      }
      corner = there;
    }
  return assembleModel(std::move(triangles), std::move(positions), {});
}

/** The hole with its rim as the patch's vertices, in the direction of new triangles. */
PatchedHole
cut(const ccaa::test::Shape& shape, const std::function<bool(const Position&)>& isLost)
{
  Triangles kept, lost;
  for (const Triangle& triangle : shape.triangles) {
    const bool gone =
        std::all_of(triangle.begin(), triangle.end(), [&](pcl::index_t corner) {
          return isLost(shape.vertices[static_cast<std::size_t>(corner)]);
        });
    (gone ? lost : kept).push_back(triangle);
  }
  PatchedHole hole;
  std::vector<pcl::index_t> number;
  hole.model = modelOf(shape, kept, number);
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] < 0)
      hole.lost.push_back(shape.vertices[v]);
  for (const pcl::index_t vertex : borderOf(lost)) {
    hole.patch.rim.push_back(number[static_cast<std::size_t>(vertex)]);
    hole.patch.positions.push_back(shape.vertices[static_cast<std::size_t>(vertex)]);
  }
  return hole;
}

void
complete(Patch& patch)
{
  patch.free_point.assign(patch.positions.size(), NONE);
  patch.hole.assign(patch.triangles.size(), 0);
}

} // namespace

PatchedHole
withFan(const ccaa::test::Shape& shape,
        const std::function<bool(const Position&)>& isLost)
{
  PatchedHole hole = cut(shape, isLost);
  Patch& patch = hole.patch;
  const auto size = static_cast<pcl::index_t>(patch.rim.size());
  Position centroid = Position::Zero();
  for (const Position& position : patch.positions)
    centroid += position / static_cast<double>(size);
  patch.positions.push_back(centroid);
  for (pcl::index_t k = 0; k < size; ++k)
    patch.triangles.push_back({k, (k + 1) % size, size});
  complete(patch);
  return hole;
}

PatchedHole
withStrip(const ccaa::test::Shape& shape,
          const std::function<bool(const Position&)>& isLost)
{
  PatchedHole hole = cut(shape, isLost);
  Patch& patch = hole.patch;
  pcl::index_t low = 0, high = static_cast<pcl::index_t>(patch.rim.size()) - 1;
  while (high - low > 1) {
    patch.triangles.push_back({high, low, low + 1});
    ++low;
    if (high - low > 1) {
      patch.triangles.push_back({high - 1, high, low});
      --high;
    }
  }
  complete(patch);
  return hole;
}

PatchedHole
cappedSphere(int subdivisions, double angle)
{
  const double height = std::cos(angle);
  return withFan(ccaa::test::icosphere(subdivisions),
                 [&](const Position& p) { return p.z() > height; });
}

PatchedHole
holedPlane(int n, double radius)
{
  ccaa::test::Shape plane = ccaa::test::grid(2 * n + 1, 2 * n + 1);
  plane = ccaa::test::translated(plane, {-double(n), -double(n), 0.0});
  return withFan(plane, [&](const Position& p) { return p.norm() < radius; });
}

::testing::AssertionResult
isSound(const PatchedHole& hole)
{
  Triangles all = hole.model.triangles;
  const std::size_t before = ccaa::test::countBoundaryEdges(all);
  const auto first = static_cast<pcl::index_t>(hole.model.positions.size());
  const auto rim = static_cast<pcl::index_t>(hole.patch.rim.size());
  for (Triangle triangle : hole.patch.triangles) {
    for (pcl::index_t& corner : triangle)
      corner = corner < rim ? hole.patch.rim[static_cast<std::size_t>(corner)]
                            : first + corner - rim;
    all.push_back(triangle);
  }
  const std::size_t vertices =
      hole.model.positions.size() + hole.patch.positions.size() - hole.patch.rim.size();
  if (before - ccaa::test::countBoundaryEdges(all) != hole.patch.rim.size())
    return ::testing::AssertionFailure() << "the hole is not closed";
  if (const auto manifold = ccaa::test::isIcadm(all, vertices); !manifold)
    return manifold;
  return ccaa::test::isConsistentlyWound(all);
}

long
eulerCharacteristic(const Patch& patch)
{
  std::set<Edge> edges;
  for (const Edge& side : sidesOf(patch.triangles))
    edges.insert(std::minmax(side.first, side.second));
  return static_cast<long>(patch.positions.size()) - static_cast<long>(edges.size()) +
         static_cast<long>(patch.triangles.size());
}

double
largestOf(const Patch& patch, const std::function<double(const Position&)>& distance)
{
  double largest = 0.0;
  for (const Position& position : patch.positions)
    largest = std::max(largest, distance(position));
  return largest;
}

} // namespace pcl::repair::test
