// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: fillings of neighbouring holes as one patch.

#include "patch/patch_assembly.h"

#include "icadm/model_assembly.h"
#include "mesh/corners.h"
#include "mesh/sort_unique.h"

#include <algorithm>
#include <map>

namespace pcl::repair {

namespace {

/** Numbers the vertices of a patch: those of the model first. */
class PatchNumbering {
public:
  PatchNumbering(const std::vector<FilledPart>& parts,
                 std::size_t model_vertices,
                 const CreaseVertices& creases)
  {
    for (const FilledPart& part : parts)
      for (std::size_t k = 0; k < part.polygon.size(); ++k)
        position_of_.emplace(part.polygon.vertices[k], part.polygon.curve.points[k]);
    for (const auto& [vertex, position] : position_of_) {
      number_of_.emplace(vertex, static_cast<pcl::index_t>(patch_.positions.size()));
      patch_.positions.push_back(position);
      if (static_cast<std::size_t>(vertex) < model_vertices)
        patch_.rim.push_back(vertex);
    }
    patch_.free_point.assign(patch_.positions.size(), NONE);
    if (!creases.empty())
      for (const FilledPart& part : parts)
        addCreases(part.polygon, creases);
  }

  void
  add(const FilledPart& part)
  {
    const std::size_t edges = part.polygon.size();
    const std::size_t first_inner = patch_.positions.size();
    for (const Triangle& triangle : part.filling.triangles) {
      Triangle numbered{};
      for (std::size_t c = 0; c < 3; ++c) {
        const auto corner = static_cast<std::size_t>(triangle[c]);
        numbered[c] = corner < edges
                          ? number_of_.at(part.polygon.vertices[corner])
                          : static_cast<pcl::index_t>(first_inner + corner - edges);
      }
      patch_.triangles.push_back(numbered);
      patch_.hole.push_back(part.hole);
    }
    const Filling& filling = part.filling;
    patch_.positions.insert(
        patch_.positions.end(), filling.inner.begin(), filling.inner.end());
    patch_.free_point.insert(
        patch_.free_point.end(), filling.free_point.begin(), filling.free_point.end());
  }

  Patch
  finish()
  {
    return std::move(patch_);
  }

private:
  void
  addCreases(const HolePolygon& polygon, const CreaseVertices& creases)
  {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const pcl::index_t from = polygon.vertices[k];
      const pcl::index_t to = polygon.vertices[polygon.curve.next(k)];
      const auto one = creases.find(from), other = creases.find(to);
      if (one != creases.end() && other != creases.end() &&
          one->second == other->second)
        patch_.addCrease(static_cast<std::size_t>(number_of_.at(from)),
                         static_cast<std::size_t>(number_of_.at(to)));
    }
  }

  std::map<pcl::index_t, Position> position_of_; /**< ascending: the model's first */
  std::map<pcl::index_t, pcl::index_t> number_of_;
  Patch patch_;
};

/** The triangles of a model at the rim of a patch, in the numbers of the patch where
 * it has the vertex, others after these. */
Triangles
trianglesAround(const IncompleteModel& model, const Patch& patch)
{
  std::map<pcl::index_t, pcl::index_t> number_of;
  std::vector<pcl::index_t> around;
  for (std::size_t v = 0; v < patch.rim.size(); ++v) {
    number_of.emplace(patch.rim[v], static_cast<pcl::index_t>(v));
    around.insert(around.end(),
                  model.adjacency.begin(patch.rim[v]),
                  model.adjacency.end(patch.rim[v]));
  }
  ccaa::sortUnique(around);
  auto next = static_cast<pcl::index_t>(patch.positions.size());
  Triangles triangles;
  for (const pcl::index_t t : around) {
    Triangle triangle = model.triangles[static_cast<std::size_t>(t)];
    for (pcl::index_t& corner : triangle) {
      const auto [entry, is_new] = number_of.emplace(corner, next);
      next += is_new ? 1 : 0;
      corner = entry->second;
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

/** The nearest place that floats at an origin can hold. Through memory: GCC 12 takes a
 * vector of doubles that became floats and doubles again for the doubles that they
 * were. */
Position
nearestFloats(Position place, const Position& origin)
{
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double there =
        origin[axis] == 0.0 ? place[axis] : place[axis] + origin[axis]; // keeps -0
    volatile const float held = static_cast<float>(there);
    place[axis] = static_cast<double>(held) - origin[axis];
  }
  return place;
}

} // namespace

Patch
assemblePatch(const std::vector<FilledPart>& parts,
              std::size_t model_vertices,
              const CreaseVertices& creases)
{
  PatchNumbering numbering(parts, model_vertices, creases);
  for (const FilledPart& part : parts)
    numbering.add(part);
  return numbering.finish();
}

Patch
withoutHoles(const Patch& patch, const std::set<std::size_t>& holes)
{
  std::vector<bool> is_kept;
  for (const std::size_t hole : patch.hole)
    is_kept.push_back(holes.count(hole) == 0);
  return keepTriangles(patch, is_kept);
}

bool
fitsModel(const IncompleteModel& model, const Patch& patch)
{
  Triangles together = trianglesAround(model, patch);
  pcl::index_t vertices = static_cast<pcl::index_t>(patch.positions.size());
  for (const Triangle& triangle : together)
    vertices =
        std::max(vertices, *std::max_element(triangle.begin(), triangle.end()) + 1);
  together.insert(together.end(), patch.triangles.begin(), patch.triangles.end());
  ccaa::TriangleAdjacency adjacency;
  adjacency.build(together, static_cast<std::size_t>(vertices));
  const auto may_be_pinched = [&](std::size_t v) {
    return v < patch.rim.size() &&
           model.adjacency.fan(patch.rim[v]) == ccaa::Fan::SEVERAL;
  };
  for (std::size_t v = 0; v < patch.positions.size(); ++v) {
    const ccaa::Fan fan = adjacency.fan(static_cast<pcl::index_t>(v));
    if (fan == ccaa::Fan::OVERFULL || (fan == ccaa::Fan::SEVERAL && !may_be_pinched(v)))
      return false;
  }
  return adjacency.overfullEdges().empty() && isConsistentlyWound(together, adjacency);
}

void
roundToFloats(const Position& origin, Patch& patch)
{
  for (std::size_t v = patch.rim.size(); v < patch.positions.size(); ++v)
    patch.positions[v] = nearestFloats(patch.positions[v], origin);
}

void
addFill(const FilledPart& part, FillArea& fill)
{
  const auto place = [&](pcl::index_t corner) {
    const auto c = static_cast<std::size_t>(corner);
    return c < part.polygon.size() ? part.polygon.curve.points[c]
                                   : part.filling.inner[c - part.polygon.size()];
  };
  for (const Triangle& t : part.filling.triangles) {
    const Eigen::Vector3d normal =
        ccaa::areaNormal({place(t[0]), place(t[1]), place(t[2])});
    fill.vector += normal;
    fill.size += normal.norm();
  }
}

} // namespace pcl::repair
