// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: given and new triangles while a surface is completed.
#include "advancing_front/partial_surface.h"

#include "mesh/sort_unique.h"

#include <algorithm>
#include <cstdint>

namespace pcl::ccaa {
namespace {

/** Operations for a point that is open, in each of the steps that make it so. */
constexpr std::uint64_t OPENING_WORK = 20;

Position
finiteOrZero(const Position& direction)
{
  return direction.allFinite() ? direction : Position::Zero();
}

} // namespace

PartialSurface::PartialSurface(const Triangles& given,
                               const TriangleAdjacency& adjacency,
                               const PointView& points,
                               const OrientationHints& hints)
: given_(given)
, adjacency_(adjacency)
, points_(points)
, hints_(hints)
, alive_given_(given.size(), 1)
{}

bool
PartialSurface::isAlive(pcl::index_t triangle) const
{
  const auto t = static_cast<std::size_t>(triangle);
  return isGiven(triangle) ? alive_given_[t] != 0
                           : alive_added_[t - alive_given_.size()] != 0;
}

const Triangle&
PartialSurface::operator[](pcl::index_t triangle) const
{
  const auto t = static_cast<std::size_t>(triangle);
  return isGiven(triangle) ? given_[t] : added_[t - alive_given_.size()];
}

std::vector<pcl::index_t>
PartialSurface::trianglesAt(const std::vector<pcl::index_t>& vertices) const
{
  std::vector<pcl::index_t> found;
  for (const pcl::index_t vertex : vertices)
    forTrianglesAt(vertex, [&](pcl::index_t t) { found.push_back(t); });
  sortUnique(found);
  return found;
}

void
PartialSurface::remove(pcl::index_t triangle)
{
  const auto t = static_cast<std::size_t>(triangle);
  if (isGiven(triangle))
    alive_given_[t] = 0;
  else
    alive_added_[t - alive_given_.size()] = 0;
}

void
PartialSurface::add(const Triangle& triangle)
{
  if (first_added_.empty())
    first_added_.assign(vertexCount(), NO_CORNER);
  added_.push_back(triangle);
  alive_added_.push_back(1);
  for (const pcl::index_t vertex : triangle) {
    pcl::index_t& first = first_added_[static_cast<std::size_t>(vertex)];
    next_added_.push_back(first);
    first = static_cast<pcl::index_t>(next_added_.size()) - 1;
  }
}

OpenSurface
PartialSurface::openAt(const std::vector<pcl::index_t>& open,
                       const std::vector<pcl::index_t>& removed,
                       std::vector<pcl::index_t>& vertices,
                       RunControl* control) const
{
  OpenSurface surface;
  surface.open_points = open.size();
  surface.removed = removed;
  surface.largest_room = largest_room_;
  for (const pcl::index_t t : trianglesAt(open))
    if (!std::binary_search(removed.begin(), removed.end(), t))
      surface.rim.push_back((*this)[t]);
  if (!spend(control, OPENING_WORK * open.size()))
    return {};
  vertices = open;
  numberRim(surface.rim, vertices);
  if (!spend(control, OPENING_WORK * open.size()))
    return {};
  WorkCount work(control);
  surface.positions.reserve(vertices.size());
  for (const pcl::index_t vertex : vertices)
    surface.positions.push_back(points_[vertex]);
  for (const pcl::index_t vertex : open) {
    surface.spacings.push_back(spacingAt(vertex));
    if (!work.add(OPENING_WORK))
      return {};
  }
  for (const pcl::index_t vertex : open) {
    work.add(1);
    if (!hints_.normals.empty())
      surface.normals.push_back(finiteOrZero(hints_.normals[vertex]));
    surface.outward.push_back(outwardAt(vertex, points_, hints_));
  }
  return surface;
}

std::vector<pcl::index_t>
PartialSurface::verticesAround(std::vector<pcl::index_t> vertices, int edges) const
{
  for (int i = 0; i < edges; ++i) {
    for (const pcl::index_t t : trianglesAt(vertices))
      vertices.insert(vertices.end(), (*this)[t].begin(), (*this)[t].end());
    sortUnique(vertices);
  }
  return vertices;
}

bool
PartialSurface::isBorder(pcl::index_t vertex) const
{
  std::vector<pcl::index_t> ends;
  forTrianglesAt(vertex, [&](pcl::index_t t) {
    for (const pcl::index_t corner : (*this)[t])
      if (corner != vertex)
        ends.push_back(corner);
  });
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 0; i < ends.size(); i += 2)
    if (i + 1 == ends.size() || ends[i] != ends[i + 1])
      return true;
  return false;
}

void
PartialSurface::noteSpacing(pcl::index_t vertex, double spacing)
{
  noted_spacings_.resize(vertexCount(), 0.0f);
  noted_spacings_[static_cast<std::size_t>(vertex)] = static_cast<float>(spacing);
}

double
PartialSurface::spacingAt(pcl::index_t vertex) const
{
  std::vector<double> lengths;
  for (const auto* t = adjacency_.begin(vertex); t != adjacency_.end(vertex); ++t)
    for (const pcl::index_t corner : given_[static_cast<std::size_t>(*t)])
      if (corner != vertex)
        lengths.push_back((points_[corner] - points_[vertex]).norm());
  if (lengths.empty())
    return noted_spacings_.empty()
               ? 0.0
               : static_cast<double>(noted_spacings_[static_cast<std::size_t>(vertex)]);
  std::sort(lengths.begin(), lengths.end());
  const std::size_t half = (lengths.size() + 1) / 2;
  double sum = 0.0;
  for (std::size_t i = 0; i < half; ++i)
    sum += lengths[i];
  return sum / static_cast<double>(half);
}

} // namespace pcl::ccaa
