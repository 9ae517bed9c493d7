// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: closes small gaps that the growth could not.
#pragma once

#include "advancing_front/growing_surface.h"
#include "advancing_front/triangle_trial.h"
#include "run/run_control.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl::ccaa {

/** \brief The triangulation of a front loop that folds least.
 *
 * Growth judges one triangle at a time and can paint itself into a corner. For a whole
 * loop the best set of triangles is found by dynamic programming over all of them
 * (Barequet and Sharir 1995): least largest fold first, least area second (Liepa 2003).
 * Where its triangles cross the surface or would overfill an edge, such take no part in
 * a second search: most loops have nothing in the way, and to ask for each triangle
 * that may be of use takes most of the time. Cost O(n^3) for n edges, so loops are
 * limited. */
class LoopClosure {
public:
  LoopClosure(GrowingSurface& surface, TriangleTrial& trial)
  : surface_(surface), trial_(trial)
  {}

  /** \brief What became of a loop. */
  enum class Outcome {
    CLOSED,
    UNSUPPORTED, /**< the samples along it are too far from each other */
    OBSTRUCTED   /**< it would be closed, were there not other triangles in the way */
  };

  /** \brief Close the loop that an edge of the front belongs to, or leave the surface
   * as it was. */
  Outcome
  close(FrontIndex edge);

  /** \brief Corners of the loop last looked at, against its direction. */
  const std::vector<pcl::index_t>&
  corners() const
  {
    return corners_;
  }

  /** \brief Operations that it took: a weight for each pair of corners and each corner
   * between them, and a look at what is in the way for some. */
  std::uint64_t
  work() const
  {
    return corners_.size() * corners_.size() * corners_.size();
  }

private:
  /** Worst fold as a negative cosine, -1 is flat; ties by area. */
  struct Weight {
    double fold = std::numeric_limits<double>::infinity();
    double area = std::numeric_limits<double>::infinity();

    bool
    operator<(const Weight& other) const
    {
      return fold != other.fold ? fold < other.fold : area < other.area;
    }
  };

  struct Cell {
    Weight weight;
    int apex = -1;
  };

  Cell&
  cell(std::size_t i, std::size_t j)
  {
    return cells_[i * corners_.size() + j];
  }

  bool
  readLoop(FrontIndex edge);
  bool
  triangulate(bool obstructions_count);
  void
  fillCell(std::size_t i, std::size_t j);
  Weight
  weigh(std::size_t i, std::size_t m, std::size_t j);
  bool
  isFree(std::size_t i, std::size_t j);
  bool
  takesDiagonal(std::size_t i, std::size_t j) const;
  Position
  normalAcross(std::size_t i, std::size_t j);
  void
  listTriangles(std::size_t i, std::size_t j, Triangles& patch);
  bool
  isSupported(const Triangles& patch) const;
  double
  largestRoom() const;
  double
  room(const Triangles& patch) const;
  double
  distanceToLoop(const Position& position) const;
  bool
  isSimple(const Triangles& patch) const;
  void
  apply(std::size_t i, std::size_t j);

  GrowingSurface& surface_;
  TriangleTrial& trial_;
  std::vector<pcl::index_t> corners_; /**< the loop against its direction */
  Positions behind_;                  /**< normals of the triangles on the loop edges */
  std::vector<Cell> cells_;
  bool obstructions_count_ = true;
};

/** \brief Close all loops of a surface's front that can be closed.
 * \param[in,out] control told the work, may be null
 * \return open points, ascending, on loops that the samples support but other triangles
 * obstruct, or where several fans meet; nothing of use after cancelling */
std::vector<pcl::index_t>
closeLoops(GrowingSurface& surface, TriangleTrial& trial, RunControl* control);

} // namespace pcl::ccaa
