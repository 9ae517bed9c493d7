// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the enclosing-sphere rule for the outer side (thesis 4.48).
#include <Eigen/Geometry>

#include "mesh/corners.h"
#include "mesh/outward_votes.h"

#include <algorithm>
#include <cmath>

namespace pcl::ccaa {
namespace {

/** \brief Bounds of the number of cells along an edge of the cube of directions; 64
 * makes 24 576 directions, some 1.4 degrees apart. */
constexpr int FEWEST_CELLS = 8;
constexpr int MOST_CELLS = 64;

/** \brief Triangles for each cell, so that the map costs less than reading the mesh. */
constexpr double TRIANGLES_PER_CELL = 16.0;

/** \brief A triangle seen more edge-on than this says nothing. */
constexpr double LEAST_COSINE = 1e-3;

/** \brief The triangle met last by the half-line from the centre. */
struct Outermost {
  float squared_distance = -1.0f;
  pcl::index_t triangle = -1;

  /** \brief Farther wins; the lower triangle breaks a tie, whatever came first. */
  void
  meet(const Outermost& other)
  {
    if (other.squared_distance > squared_distance ||
        (other.squared_distance == squared_distance && other.triangle < triangle))
      *this = other;
  }
};

/** \brief The triangles that the enclosing sphere sees, one for each direction from the
 * centre. */
class OutermostMap {
public:
  OutermostMap(const Position& centre, int cells_along)
  : centre_(centre)
  , cells_along_(cells_along)
  , squared_cell_angle_(4.0 / (cells_along * cells_along))
  , cells_(static_cast<std::size_t>(6 * cells_along * cells_along))
  {}

  void
  enter(pcl::index_t index, const Position& a, const Position& b, const Position& c)
  {
    const Eigen::Vector3d u = a - centre_, v = b - centre_, w = c - centre_;
    const Eigen::Vector3d middle = (u + v + w) / 3.0;
    const double reach = std::max({(u - middle).squaredNorm(),
                                   (v - middle).squaredNorm(),
                                   (w - middle).squaredNorm()});
    const double cell = squared_cell_angle_ * middle.squaredNorm();
    if (!std::isfinite(reach))
      return;
    meet(index, middle);
    if (reach > cell)
      enterLarge(index, u, v - u, w - u, std::sqrt(reach / cell));
  }

  void
  merge(const OutermostMap& other)
  {
    for (std::size_t i = 0; i < cells_.size(); ++i)
      cells_[i].meet(other.cells_[i]);
  }

  const Position&
  centre() const
  {
    return centre_;
  }
  const std::vector<Outermost>&
  cells() const
  {
    return cells_;
  }

private:
  /** \brief Points all over a triangle that covers several cells. */
  void
  enterLarge(pcl::index_t index,
             const Eigen::Vector3d& corner,
             const Eigen::Vector3d& first_edge,
             const Eigen::Vector3d& second_edge,
             double cells_across)
  {
    const int steps = static_cast<int>(
        std::min<double>(2 * cells_along_, std::ceil(2.0 * cells_across)));
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j)
        meet(index, corner + (i * first_edge + j * second_edge) / steps);
  }

  void
  meet(pcl::index_t index, const Eigen::Vector3d& ray)
  {
    const auto squared_distance = static_cast<float>(ray.squaredNorm());
    if (squared_distance > 0.0f)
      cells_[cellOf(ray)].meet({squared_distance, index});
  }

  /** \brief The cell of the cube around the centre that a ray leaves by. */
  std::size_t
  cellOf(const Eigen::Vector3d& ray) const
  {
    Eigen::Index axis = 0;
    const double largest = ray.cwiseAbs().maxCoeff(&axis);
    const int side = 2 * static_cast<int>(axis) + (ray[axis] > 0.0 ? 1 : 0);
    const int column = cellAlong(ray[(axis + 1) % 3] / largest);
    const int row = cellAlong(ray[(axis + 2) % 3] / largest);
    return static_cast<std::size_t>((side * cells_along_ + row) * cells_along_ +
                                    column);
  }

  int
  cellAlong(double coordinate) const
  {
    const double cell = (coordinate + 1.0) * 0.5 * cells_along_;
    return std::min(cells_along_ - 1, static_cast<int>(cell));
  }

  Position centre_;
  int cells_along_;
  double squared_cell_angle_;
  std::vector<Outermost> cells_;
};

/** \brief Middle of the box around the vertices in use. Any point well inside serves
 * the rule: the last triangle on a half-line is left outward from wherever it starts.
 */
Position
findCentre(const WoundMesh& mesh, int threads)
{
  const LoopContext context{threads};
  using Box = Eigen::AlignedBox3d;
  std::vector<Box> boxes(context.blockCount(mesh.triangles.size()));
  forEachBlock(mesh.triangles.size(),
               context,
               [&](std::size_t block, std::size_t begin, std::size_t end) {
                 for (std::size_t i = begin; i < end; ++i)
                   for (const pcl::index_t vertex : mesh.triangles[i]) {
                     const Position position = mesh.positions[vertex];
                     if (position.allFinite())
                       boxes[block].extend(position);
                   }
               });
  Box box;
  for (const Box& part : boxes)
    box.extend(part);
  return box.isEmpty() ? Position::Zero() : Position(box.center());
}

int
cellsFor(std::size_t triangles)
{
  const double cells = static_cast<double>(triangles) / TRIANGLES_PER_CELL;
  const int along = static_cast<int>(std::sqrt(cells / 6.0));
  return std::clamp(along, FEWEST_CELLS, MOST_CELLS);
}

OutermostMap
drawOutermost(const WoundMesh& mesh, const LoopContext& context)
{
  std::vector<OutermostMap> maps(
      static_cast<std::size_t>(context.threads),
      OutermostMap(findCentre(mesh, context.threads), cellsFor(mesh.triangles.size())));
  forEachBlock(mesh.triangles.size(),
               context,
               [&](std::size_t, std::size_t begin, std::size_t end) {
                 OutermostMap& map = maps[static_cast<std::size_t>(threadIndex())];
                 for (std::size_t i = begin; i < end; ++i) {
                   const Triangle& triangle = mesh.triangles[i];
                   map.enter(static_cast<pcl::index_t>(i),
                             mesh.positions[triangle[0]],
                             mesh.positions[triangle[1]],
                             mesh.positions[triangle[2]]);
                 }
               });
  for (std::size_t i = 1; i < maps.size(); ++i)
    maps.front().merge(maps[i]);
  return maps.front();
}

} // namespace

std::vector<SideVotes>
collectEnclosingSphere(const WoundMesh& mesh, const LoopContext& context)
{
  const OutermostMap map = drawOutermost(mesh, context);
  std::vector<SideVotes> votes(mesh.winding.components().size());
  for (const Outermost& cell : map.cells()) {
    if (cell.triangle < 0)
      continue;
    const auto index = static_cast<std::size_t>(cell.triangle);
    const Corners c = cornersOf(mesh.triangles[index], mesh.positions);
    const Eigen::Vector3d ray =
        ((c[0] + c[1] + c[2]) / 3.0 - map.centre()).normalized();
    const double cosine = unitNormal(c).dot(ray);
    if (std::abs(cosine) > LEAST_COSINE)
      votes[mesh.winding.componentOf(index)].add(mesh.winding.sign(index) * cosine);
  }
  return votes;
}

} // namespace pcl::ccaa
