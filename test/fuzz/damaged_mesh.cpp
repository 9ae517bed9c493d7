// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: meshes out of the bytes a fuzzer makes up.
#include "damaged_mesh.h"

#include <limits>
#include <utility>

namespace fuzz {
namespace {

using pcl::ccaa::Position;
using pcl::ccaa::Triangle;
using pcl::ccaa::Triangles;
using namespace pcl::ccaa::test;

/** More would only make a run slower. */
constexpr std::size_t MOST_EDITS = 200;

Shape
smallShape(Bytes& bytes)
{
  switch (bytes.below(14)) {
  case 0:
    return icosphere(1);
  case 1:
    return icosphere(2);
  case 2:
    return torus(9, 6);
  case 3:
    return torus(12, 7);
  case 4:
    return cube(3, 2.0);
  case 5:
    return cylinder(9, 5);
  case 6:
    return scaled(grid(6, 6), 0.3);
  case 7:
    return scaled(terrain(10, 8), 0.2);
  case 8:
    return scaled(thinPlate(6, 6), 0.3);
  case 9:
    return nestedSpheres(1);
  case 10:
    return moebiusBand(9);
  case 11:
    return joined(icosphere(1), translated(icosphere(1), Position(1.5, 0.5, 0)));
  case 12:
    return joined(joined(bowTie(), threeOnEdge()), twoFansAtApex());
  default:
    return {};
  }
}

pcl::index_t
anyVertex(Bytes& bytes, const Shape& shape)
{
  return static_cast<pcl::index_t>(bytes.below(shape.vertices.size()));
}

Position
anyPlace(Bytes& bytes)
{
  const double x = bytes.coarse();
  const double y = bytes.coarse();
  return {x, y, bytes.coarse()};
}

void
cutBall(Bytes& bytes, Shape& shape)
{
  const Position middle = shape.vertices[bytes.below(shape.vertices.size())];
  const double radius = bytes.byte() / 128.0;
  Triangles kept;
  for (const Triangle& triangle : shape.triangles) {
    bool inside = false;
    for (const pcl::index_t corner : triangle)
      inside |=
          (shape.vertices[static_cast<std::size_t>(corner)] - middle).norm() < radius;
    if (!inside)
      kept.push_back(triangle);
  }
  shape.triangles = std::move(kept);
}

void
editTriangle(Bytes& bytes, Shape& shape)
{
  const std::size_t t = bytes.below(shape.triangles.size());
  switch (bytes.below(4)) {
  case 0:
    shape.triangles.erase(shape.triangles.begin() + static_cast<std::ptrdiff_t>(t));
    return;
  case 1:
    std::swap(shape.triangles[t][0], shape.triangles[t][1]);
    return;
  case 2:
    shape.triangles.push_back(shape.triangles[t]);
    return;
  default:
    shape.triangles[t][bytes.below(3)] = anyVertex(bytes, shape);
  }
}

void
spoilVertex(Bytes& bytes, Position& vertex)
{
  constexpr double values[] = {0.0,
                               std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity(),
                               3e38,
                               1e-38,
                               1e6};
  const std::size_t axis = bytes.below(3);
  vertex[static_cast<Eigen::Index>(axis)] = values[bytes.below(6)];
}

void
editVertex(Bytes& bytes, Shape& shape)
{
  Position& vertex = shape.vertices[bytes.below(shape.vertices.size())];
  switch (bytes.below(3)) {
  case 0:
    vertex += 0.3 * anyPlace(bytes);
    return;
  case 1:
    vertex = shape.vertices[bytes.below(shape.vertices.size())];
    return;
  default:
    spoilVertex(bytes, vertex);
  }
}

} // namespace

Shape
damagedMesh(Bytes& bytes)
{
  Shape shape = smallShape(bytes);
  for (std::size_t i = 0; i < MOST_EDITS && !bytes.empty(); ++i) {
    const std::size_t kind = bytes.below(8);
    if (kind == 0 || shape.vertices.empty())
      shape.vertices.push_back(anyPlace(bytes));
    else if (kind == 1)
      cutBall(bytes, shape);
    else if (kind == 2)
      editVertex(bytes, shape);
    else if (kind == 3)
      shape.triangles.push_back(
          {anyVertex(bytes, shape), anyVertex(bytes, shape), anyVertex(bytes, shape)});
    else if (!shape.triangles.empty())
      editTriangle(bytes, shape);
  }
  return shape;
}

} // namespace fuzz
