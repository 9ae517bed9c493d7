// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the linear system of a fair surface.

#include "fairing/fairing_system.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace pcl::repair {

namespace {

using Triplet = Eigen::Triplet<double>;

/** Columns of a product that are computed in one go. */
constexpr Eigen::Index COLUMNS_AT_ONCE = 1024;
/** Operations to add a row to a system, and for an entry of a product. */
constexpr std::uint64_t ROW_WORK = 50;
constexpr std::uint64_t ENTRY_WORK = 10;

/** Number of each vertex among those that move; -1 for the others. */
struct Unknowns {
  std::vector<int> number;
  int count = 0;

  explicit Unknowns(const std::vector<char>& fixed) : number(fixed.size(), -1)
  {
    for (std::size_t v = 0; v < fixed.size(); ++v)
      if (fixed[v] == 0)
        number[v] = count++;
  }
};

/** Residuals A y - b of a least squares problem, a row each. */
class Residuals {
public:
  Residuals(const JoinedSurface& surface, const Unknowns& unknowns)
  : surface_(surface), unknowns_(unknowns)
  {}

  /** \brief Begin a row whose sum is to be `target`. */
  void
  begin(const Eigen::Vector3d& target)
  {
    targets_.push_back(target);
  }

  /** \brief Add a multiple of a vertex's position to the row begun last. */
  void
  add(std::size_t vertex, double factor)
  {
    const int unknown = unknowns_.number[vertex];
    if (unknown >= 0)
      triplets_.emplace_back(static_cast<int>(targets_.size()) - 1, unknown, factor);
    else
      targets_.back() -= factor * surface_.positions[vertex];
  }

  SparseMatrix
  matrix() const
  {
    SparseMatrix matrix(static_cast<Eigen::Index>(targets_.size()), unknowns_.count);
    matrix.setFromTriplets(triplets_.begin(), triplets_.end());
    return matrix;
  }

  Columns
  targets() const
  {
    Columns targets(static_cast<Eigen::Index>(targets_.size()), 3);
    for (std::size_t i = 0; i < targets_.size(); ++i)
      targets.row(static_cast<Eigen::Index>(i)) = targets_[i].transpose();
    return targets;
  }

private:
  const JoinedSurface& surface_;
  const Unknowns& unknowns_;
  std::vector<Triplet> triplets_;
  std::vector<Eigen::Vector3d> targets_;
};

/** A row for each vertex of the patch that has triangles all around. */
void
addBending(const JoinedSurface& surface, const FairingTask& task, Residuals& residuals)
{
  const SurfaceLaplacian laplacian =
      surfaceLaplacian(surface.triangles, surface.positions);
  std::vector<Eigen::Vector3d> normals;
  if (!task.curvatures.empty())
    normals = areaNormals(surface.triangles, surface.positions);
  for (std::size_t v = 0; v < surface.patch_vertices; ++v) {
    if (surface.whole[v] == 0 || task.hinges[v] != 0)
      continue;
    const auto column = static_cast<Eigen::Index>(v);
    const double root = std::sqrt(laplacian.mass[column]);
    Eigen::Vector3d target = Eigen::Vector3d::Zero();
    if (!task.curvatures.empty())
      target = -root * task.curvatures[v] * normals[v];
    residuals.begin(target);
    for (SparseMatrix::InnerIterator entry(laplacian.stiffness, column); entry; ++entry)
      residuals.add(static_cast<std::size_t>(entry.row()), entry.value() / root);
  }
}

void
addPulls(const JoinedSurface& surface, const FairingTask& task, Residuals& residuals)
{
  for (const Pull& pull : task.pulls) {
    const double root = std::sqrt(pull.weight);
    residuals.begin(root * pull.target);
    for (std::size_t c = 0; c < 3; ++c)
      residuals.add(static_cast<std::size_t>(surface.triangles[pull.triangle][c]),
                    root * pull.barycentric[static_cast<Eigen::Index>(c)]);
  }
}

/** A^T A, some columns after the other. */
SparseMatrix
squareOf(const SparseMatrix& matrix, ccaa::RunControl* control)
{
  const SparseMatrix transposed = matrix.transpose();
  SparseMatrix square(matrix.cols(), matrix.cols());
  for (Eigen::Index first = 0; first < matrix.cols(); first += COLUMNS_AT_ONCE) {
    const Eigen::Index count = std::min(COLUMNS_AT_ONCE, matrix.cols() - first);
    const SparseMatrix part = transposed * matrix.middleCols(first, count);
    if (!ccaa::spend(control, ENTRY_WORK * static_cast<std::uint64_t>(part.nonZeros())))
      return square;
    for (Eigen::Index column = 0; column < count; ++column) {
      square.startVec(first + column);
      for (SparseMatrix::InnerIterator entry(part, column); entry; ++entry)
        square.insertBack(entry.row(), first + column) = entry.value();
    }
  }
  square.finalize();
  return square;
}

} // namespace

Positions
fairPositions(const JoinedSurface& surface,
              const FairingTask& task,
              SparseFactorisation& solver,
              ccaa::RunControl* control)
{
  const Unknowns unknowns(task.fixed);
  if (unknowns.count == 0)
    return {};
  Residuals residuals(surface, unknowns);
  addBending(surface, task, residuals);
  addPulls(surface, task, residuals);
  if (!ccaa::spend(control, ROW_WORK * surface.patch_vertices))
    return {};
  const SparseMatrix matrix = residuals.matrix();
  ccaa::spend(control, ROW_WORK * surface.patch_vertices);
  if (!solver.factorise(squareOf(matrix, control), control))
    return {};
  const Columns solution =
      solver.solve(matrix.transpose() * residuals.targets(), control);
  if (ccaa::isCancelled(control) || !solution.allFinite())
    return {};
  Positions positions(surface.positions.begin(),
                      surface.positions.begin() +
                          static_cast<std::ptrdiff_t>(surface.patch_vertices));
  for (std::size_t v = 0; v < positions.size(); ++v)
    if (unknowns.number[v] >= 0)
      positions[v] = solution.row(unknowns.number[v]).transpose();
  return positions;
}

std::vector<double>
harmonicValues(const JoinedSurface& surface,
               const std::vector<double>& values,
               ccaa::RunControl* control)
{
  const Triangles patch(surface.triangles.begin(),
                        surface.triangles.begin() +
                            static_cast<std::ptrdiff_t>(surface.patch_triangles));
  const SurfaceLaplacian laplacian = surfaceLaplacian(patch, surface.positions);
  ccaa::spend(control, ROW_WORK * surface.patch_vertices);
  const auto rim = static_cast<Eigen::Index>(values.size());
  const auto inner = static_cast<Eigen::Index>(surface.patch_vertices) - rim;
  const Eigen::VectorXd known = Eigen::Map<const Eigen::VectorXd>(values.data(), rim);
  const SparseMatrix matrix = -laplacian.stiffness.block(rim, rim, inner, inner);
  const SparseMatrix border = laplacian.stiffness.block(rim, 0, inner, rim);
  const double mean = known.size() > 0 ? known.mean() : 0.0;
  std::vector<double> all(surface.patch_vertices, mean);
  std::copy(values.begin(), values.end(), all.begin());
  SparseFactorisation solver;
  if (inner == 0 || !solver.factorise(matrix, control))
    return all;
  const Eigen::VectorXd solution = solver.solve(border * known, control);
  const double low = known.minCoeff(), high = known.maxCoeff();
  for (Eigen::Index i = 0; i < inner; ++i)
    if (std::isfinite(solution[i]))
      all[static_cast<std::size_t>(rim + i)] = std::clamp(solution[i], low, high);
  return all;
}

} // namespace pcl::repair
