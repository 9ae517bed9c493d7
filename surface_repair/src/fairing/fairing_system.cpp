// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the linear system of a fair surface.

#include "fairing/fairing_system.h"

#include <Eigen/SparseCholesky>

#include <cmath>
#include <numeric>

namespace pcl {
namespace repair {

namespace {

using Triplet = Eigen::Triplet<double>;
using Coordinates = Eigen::Matrix<double, Eigen::Dynamic, 3>;
using Solver = Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower>;

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

  Coordinates
  targets() const
  {
    Coordinates targets(static_cast<Eigen::Index>(targets_.size()), 3);
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
    if (surface.whole[v] == 0)
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

} // namespace

bool
FairingSolver::factorise(const SparseMatrix& matrix)
{
  const int* const starts = matrix.outerIndexPtr();
  const int* const rows = matrix.innerIndexPtr();
  std::vector<int> new_starts(starts, starts + matrix.outerSize() + 1);
  std::vector<int> new_rows(rows, rows + matrix.nonZeros());
  if (new_starts != starts_ || new_rows != rows_) {
    solver_.analyzePattern(matrix);
    starts_.swap(new_starts);
    rows_.swap(new_rows);
  }
  solver_.factorize(matrix);
  return solver_.info() == Eigen::Success;
}

Positions
fairPositions(const JoinedSurface& surface,
              const FairingTask& task,
              FairingSolver& solver)
{
  const Unknowns unknowns(task.fixed);
  if (unknowns.count == 0)
    return {};
  Residuals residuals(surface, unknowns);
  addBending(surface, task, residuals);
  addPulls(surface, task, residuals);
  const SparseMatrix matrix = residuals.matrix();
  if (!solver.factorise(SparseMatrix(matrix.transpose() * matrix)))
    return {};
  const Coordinates solution =
      solver.solve(Coordinates(matrix.transpose() * residuals.targets()));
  if (!solution.allFinite())
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
harmonicValues(const JoinedSurface& surface, const std::vector<double>& values)
{
  const Triangles patch(surface.triangles.begin(),
                        surface.triangles.begin() +
                            static_cast<std::ptrdiff_t>(surface.patch_triangles));
  const SurfaceLaplacian laplacian = surfaceLaplacian(patch, surface.positions);
  const auto rim = static_cast<Eigen::Index>(values.size());
  const auto inner = static_cast<Eigen::Index>(surface.patch_vertices) - rim;
  const Eigen::VectorXd known = Eigen::Map<const Eigen::VectorXd>(values.data(), rim);
  const SparseMatrix matrix = -laplacian.stiffness.block(rim, rim, inner, inner);
  const SparseMatrix border = laplacian.stiffness.block(rim, 0, inner, rim);
  const Solver solver(matrix);
  const double mean = known.size() > 0 ? known.mean() : 0.0;
  std::vector<double> all(surface.patch_vertices, mean);
  std::copy(values.begin(), values.end(), all.begin());
  if (inner == 0 || solver.info() != Eigen::Success)
    return all;
  const Eigen::VectorXd solution = solver.solve(border * known);
  const double low = known.minCoeff(), high = known.maxCoeff();
  for (Eigen::Index i = 0; i < inner; ++i)
    if (std::isfinite(solution[i]))
      all[static_cast<std::size_t>(rim + i)] = std::clamp(solution[i], low, high);
  return all;
}

} // namespace repair
} // namespace pcl
