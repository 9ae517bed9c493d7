// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a normal for each vertex of a mesh.
#include "mesh/vertex_normals.h"

#include <Eigen/Geometry>

#include "mesh/uninitialized.h"

#include <array>
#include <cmath>
#include <limits>

namespace pcl::ccaa {
namespace {

/** \brief What a triangle gives to its corners. */
struct Contribution {
  std::array<float, 3> normal; /**< of length 1, or 0: the triangle does not count */
  std::array<float, 3> angles; /**< at its corners, in radians */
};

Contribution
contributionOf(const Triangle& triangle, const PointView& positions)
{
  const Position a = positions[triangle[0]];
  const Position b = positions[triangle[1]];
  const Position c = positions[triangle[2]];
  const Position ab = b - a;
  const Position bc = c - b;
  const Position ca = a - c;
  const Position cross = ab.cross(bc);
  const double area = cross.norm(); // of the parallelogram
  if (!(area > 0) || !std::isfinite(area))
    return {};
  // The turn from side to side is the outer angle; its cosine has the other sign.
  return {{static_cast<float>(cross.x() / area),
           static_cast<float>(cross.y() / area),
           static_cast<float>(cross.z() / area)},
          {static_cast<float>(std::atan2(area, -ca.dot(ab))),
           static_cast<float>(std::atan2(area, -ab.dot(bc))),
           static_cast<float>(std::atan2(area, -bc.dot(ca)))}};
}

void
normalize(Eigen::Vector3f& sum)
{
  /** Angles of one radian cancel out to some 1e-7; real normals add up to far more. */
  constexpr float NOTHING = 1e-5f;
  const float length = sum.norm();
  if (length > NOTHING)
    sum /= length;
  else
    sum.setConstant(std::numeric_limits<float>::quiet_NaN());
}

} // namespace

std::vector<Eigen::Vector3f>
vertexNormals(const Triangles& triangles,
              const PointView& positions,
              const LoopContext& context)
{
  UninitializedVector<Contribution> contributions(triangles.size());
  const auto compute = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      contributions[i] = contributionOf(triangles[i], positions);
  };
  forEachBlock(triangles.size(), context, compute);
  std::vector<Eigen::Vector3f> normals(positions.size(), Eigen::Vector3f::Zero());
  const auto add =
      [&](std::size_t first, std::size_t last, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto vertex = static_cast<std::size_t>(triangles[i][corner]);
            if (vertex >= first && vertex < last)
              normals[vertex] +=
                  contributions[i].angles[corner] *
                  Eigen::Map<const Eigen::Vector3f>(contributions[i].normal.data());
          }
      };
  forEachRange(normals.size(), triangles.size(), context, add);
  const auto finish = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      normalize(normals[i]);
  };
  forEachBlock(normals.size(), context, finish);
  return normals;
}

} // namespace pcl::ccaa
