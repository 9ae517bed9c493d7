// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the Laplacian of a triangle mesh.

#include "fairing/surface_laplacian.h"

#include <Eigen/Geometry>

#include "mesh/corners.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace pcl::repair {

namespace {

using ccaa::Corners;

/** Weights of edges: negative ones would let the surface curl up where its triangles
 * are not Delaunay, and every round would make it worse. */
constexpr double LEAST_WEIGHT = 0.05;
constexpr double LARGEST_WEIGHT = 50.0;
/** Of about one degree: a thinner sliver weighs no more. */
constexpr double LARGEST_COTANGENT = 50.0;
/** Of a vertex, in squares of the longest edge there. */
constexpr double LEAST_AREA = 0.01;

std::array<double, 3>
cotangentsOf(const Corners& corners)
{
  const double area = ccaa::areaNormal(corners).norm();
  std::array<double, 3> cotangents;
  for (std::size_t c = 0; c < 3; ++c) {
    const Eigen::Vector3d u = corners[(c + 1) % 3] - corners[c];
    const Eigen::Vector3d v = corners[(c + 2) % 3] - corners[c];
    const double least = (u.squaredNorm() + v.squaredNorm()) * 1e-9;
    const double value = area > 0.0 || least > 0.0
                             ? u.dot(v) / std::max(area, std::max(least, 1e-300))
                             : 0.0;
    cotangents[c] = std::clamp(value, -LARGEST_COTANGENT, LARGEST_COTANGENT);
  }
  return cotangents;
}

/** A triangle's area by corners: that of the Voronoi cells, or halves and quarters
 * where an angle is obtuse. */
std::array<double, 3>
cellAreas(const Corners& corners, const std::array<double, 3>& cotangents)
{
  const double area = 0.5 * ccaa::areaNormal(corners).norm();
  for (std::size_t c = 0; c < 3; ++c)
    if (cotangents[c] < 0.0) {
      std::array<double, 3> areas{0.25 * area, 0.25 * area, 0.25 * area};
      areas[c] = 0.5 * area;
      return areas;
    }
  std::array<double, 3> areas{};
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t i = (c + 1) % 3, j = (c + 2) % 3;
    const double part = (corners[i] - corners[j]).squaredNorm() * cotangents[c] / 8.0;
    areas[i] += part;
    areas[j] += part;
  }
  return areas;
}

double
longestEdge(const Corners& corners)
{
  return std::max({(corners[1] - corners[0]).norm(),
                   (corners[2] - corners[1]).norm(),
                   (corners[0] - corners[2]).norm()});
}

using Triplets = std::vector<Eigen::Triplet<double>>;

void
addTriangle(const ccaa::Triangle& triangle,
            const std::array<double, 3>& cotangents,
            Triplets& triplets)
{
  for (std::size_t c = 0; c < 3; ++c) {
    const int i = triangle[(c + 1) % 3], j = triangle[(c + 2) % 3];
    const double weight = 0.5 * cotangents[c];
    triplets.emplace_back(i, j, weight);
    triplets.emplace_back(j, i, weight);
    triplets.emplace_back(i, i, -weight);
    triplets.emplace_back(j, j, -weight);
  }
}

/** Keep the weights of edges within bounds and the sums of rows zero. */
void
boundWeights(SparseMatrix& stiffness)
{
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(stiffness.cols());
  for (Eigen::Index column = 0; column < stiffness.cols(); ++column)
    for (SparseMatrix::InnerIterator entry(stiffness, column); entry; ++entry)
      if (entry.row() != column) {
        entry.valueRef() = std::clamp(entry.value(), LEAST_WEIGHT, LARGEST_WEIGHT);
        sums[column] += entry.value();
      }
  for (Eigen::Index column = 0; column < stiffness.cols(); ++column)
    for (SparseMatrix::InnerIterator entry(stiffness, column); entry; ++entry)
      if (entry.row() == column)
        entry.valueRef() = -sums[column];
}

} // namespace

SurfaceLaplacian
surfaceLaplacian(const ccaa::Triangles& triangles, const ccaa::Positions& positions)
{
  const auto size = static_cast<Eigen::Index>(positions.size());
  SurfaceLaplacian laplacian;
  laplacian.mass = Eigen::VectorXd::Zero(size);
  Eigen::VectorXd least = Eigen::VectorXd::Zero(size);
  Triplets triplets;
  triplets.reserve(12 * triangles.size());
  for (const ccaa::Triangle& triangle : triangles) {
    const Corners corners = ccaa::cornersOf(triangle, positions);
    const std::array<double, 3> cotangents = cotangentsOf(corners);
    const std::array<double, 3> areas = cellAreas(corners, cotangents);
    const double longest = longestEdge(corners);
    for (std::size_t c = 0; c < 3; ++c) {
      laplacian.mass[triangle[c]] += areas[c];
      least[triangle[c]] = std::max(least[triangle[c]], LEAST_AREA * longest * longest);
    }
    addTriangle(triangle, cotangents, triplets);
  }
  laplacian.stiffness.resize(size, size);
  laplacian.stiffness.setFromTriplets(triplets.begin(), triplets.end());
  boundWeights(laplacian.stiffness);
  laplacian.mass = laplacian.mass.cwiseMax(least);
  return laplacian;
}

std::vector<Eigen::Vector3d>
areaNormals(const ccaa::Triangles& triangles, const ccaa::Positions& positions)
{
  std::vector<Eigen::Vector3d> normals(positions.size(), Eigen::Vector3d::Zero());
  for (const ccaa::Triangle& triangle : triangles) {
    const Eigen::Vector3d normal =
        ccaa::areaNormal(ccaa::cornersOf(triangle, positions));
    for (const pcl::index_t corner : triangle)
      normals[static_cast<std::size_t>(corner)] += normal;
  }
  for (Eigen::Vector3d& normal : normals)
    normal.normalize();
  return normals;
}

} // namespace pcl::repair
