// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how noisy the samples are that a patch has grown over.

#include "fairing/sample_noise.h"

#include <Eigen/Dense>

#include "fairing/vertex_triangles.h"
#include "mesh/corners.h"
#include "mesh/quantile.h"
#include "mesh/sort_unique.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::repair {

namespace {

/** Neighbours that a quadric needs, three more than it has coefficients. */
constexpr std::size_t FEWEST_AROUND = 9;
/** Variance of the quadric at the sample in that of a neighbour, at most: more is
 * extrapolation. */
constexpr double MOST_LEVERAGE = 3.0;
/** Standard error of a deviation by the median of one value, in itself. */
constexpr double ERROR_OF_MEDIAN = 1.17;

/** Compares the samples of a patch with what is around. */
class NoiseSearch {
public:
  explicit NoiseSearch(const Patch& patch)
  : patch_(patch), triangles_(patch.triangles, patch.positions.size())
  {}

  SampleNoise
  run() const
  {
    std::vector<double> deviations, shares;
    for (std::size_t v = 0; v < patch_.positions.size(); ++v) {
      if (patch_.free_point[v] == NONE)
        continue;
      const double edge = meanEdgeAt(v), deviation = deviationAt(v, edge);
      if (deviation < 0.0)
        continue;
      deviations.push_back(deviation);
      shares.push_back(deviation / edge);
    }
    if (deviations.empty())
      return {};
    const double error =
        ERROR_OF_MEDIAN / std::sqrt(static_cast<double>(deviations.size()));
    return {ccaa::deviationOf(std::move(deviations)),
            ccaa::deviationOf(std::move(shares)) * std::max(0.0, 1.0 - error)};
  }

private:
  using Terms = Eigen::Matrix<double, 6, 1>; /**< of a quadric over a plane */

  double
  deviationAt(std::size_t sample, double edge) const;
  double
  meanEdgeAt(std::size_t vertex) const;
  Eigen::Vector3d
  normalAt(std::size_t vertex) const;
  std::vector<std::size_t>
  measuredAround(std::size_t vertex) const;
  void
  addRing(std::vector<std::size_t>& vertices) const;

  const Patch& patch_;
  const VertexTriangles triangles_;
};

/** Distance of a sample from the quadric through those around it, divided by what it
 * would be by their noise besides its own. \return below 0 where there is
 * none */
double
NoiseSearch::deviationAt(std::size_t sample, double edge) const
{
  const std::vector<std::size_t> around = measuredAround(sample);
  const Eigen::Vector3d normal = normalAt(sample);
  if (around.size() < FEWEST_AROUND || normal.isZero())
    return -1.0;
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  Eigen::Matrix<double, 6, 6> squares = Eigen::Matrix<double, 6, 6>::Zero();
  Terms heights = Terms::Zero();
  for (const std::size_t other : around) {
    const Position place = (patch_.positions[other] - patch_.positions[sample]) / edge;
    const double x = place.dot(u), y = place.dot(v);
    Terms terms;
    terms << 1.0, x, y, x * x, x * y, y * y;
    squares += terms * terms.transpose();
    heights += place.dot(normal) * terms;
  }
  const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> solver(squares);
  const double leverage = solver.solve(Terms::Unit(0))[0];
  const double height = std::abs(solver.solve(heights)[0]);
  const bool is_determined =
      leverage > 0.0 && leverage < MOST_LEVERAGE && std::isfinite(height);
  return is_determined ? edge * height / std::sqrt(1.0 + leverage) : -1.0;
}

double
NoiseSearch::meanEdgeAt(std::size_t vertex) const
{
  std::vector<std::size_t> ring{vertex};
  addRing(ring);
  double sum = 0.0;
  for (const std::size_t other : ring)
    sum += (patch_.positions[other] - patch_.positions[vertex]).norm();
  return sum / static_cast<double>(ring.size() - 1);
}

Eigen::Vector3d
NoiseSearch::normalAt(std::size_t vertex) const
{
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (const auto* t = triangles_.begin(vertex); t != triangles_.end(vertex); ++t)
    normal += ccaa::areaNormal(ccaa::cornersOf(patch_.triangles[*t], patch_.positions));
  return normal.stableNormalized();
}

/** Samples and vertices of the rim within two rings. */
std::vector<std::size_t>
NoiseSearch::measuredAround(std::size_t vertex) const
{
  std::vector<std::size_t> around{vertex};
  addRing(around);
  addRing(around);
  const auto is_none = [&](std::size_t other) {
    return other == vertex ||
           (other >= patch_.rim.size() && patch_.free_point[other] == NONE);
  };
  around.erase(std::remove_if(around.begin(), around.end(), is_none), around.end());
  return around;
}

/** And the vertices of all triangles at them; ascending. */
void
NoiseSearch::addRing(std::vector<std::size_t>& vertices) const
{
  std::vector<std::size_t> wider = vertices;
  for (const std::size_t vertex : vertices)
    for (const auto* t = triangles_.begin(vertex); t != triangles_.end(vertex); ++t)
      for (const pcl::index_t corner : patch_.triangles[*t])
        wider.push_back(static_cast<std::size_t>(corner));
  ccaa::sortUnique(wider);
  vertices = std::move(wider);
}

} // namespace

SampleNoise
noiseOfSamples(const Patch& patch)
{
  return NoiseSearch(patch).run();
}

} // namespace pcl::repair
