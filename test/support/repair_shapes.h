// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: damaged surfaces, and what has to come of them.
#pragma once

#include "mesh_topology.h"
#include "shapes.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl::ccaa::test {

/** \brief A damaged surface with the truth about its repair. */
struct DamagedModel {
  Shape damaged;         /**< an ICADM; its islands may be wound inward */
  Triangles wound;       /**< its triangles, wound as they have to be afterwards */
  Topology whole;        /**< of the repaired surface */
  Positions free_points; /**< a cloud of its own */
  Shape truth;           /**< the surface as it was */
  bool clear = true;     /**< every border can be told from a hole */
};

/** \brief A damaged surface that is made when it is needed. */
struct RepairCase {
  std::string name; /**< letters and digits */
  std::function<DamagedModel()> make;
};

/** \brief The number of the piece that a place belongs to; below 0: it is lost. */
using PieceOf = std::function<int(const Position&)>;

/** \brief The triangles whose corners belong to the same piece, as an ICADM; lost
 * vertices go, unless they are to stay as free points. */
Shape
inPieces(const Shape& shape, const PieceOf& piece_of, bool keep_lost_points = false);

/** \brief The shape without the vertices that have no triangle. */
Shape
withoutFreeVertices(const Shape& shape);

/** \brief Voronoi cells of `count` places spread evenly over the directions from the
 * origin, turned at random, with gaps between them. */
PieceOf
cells(std::size_t count, double gap, std::uint64_t seed);

/** \brief The sphere, its edges up to `factor` times as long at one pole as at the
 * other; its triangles keep their angles. */
Shape
gradedSphere(int subdivisions, double factor);

/** \brief Closed, genus 2: a frame with a bar across, rounded; 5 * 3 * 1 squares of
 * side 1 around the origin, `divisions` of its edges along each. */
Shape
frame(int divisions);

/** \brief Open, x^2 - y^2 over a square of side 2 with its middle at the origin. */
Shape
saddle(int divisions);

/** \brief Closed surfaces in several pieces, by size of the gaps. */
std::vector<RepairCase>
casesInPieces(std::uint64_t seed);

/** \brief Holes, and gaps shaped like rings, in closed surfaces. */
std::vector<RepairCase>
casesWithHoles(std::uint64_t seed);

/** \brief Surfaces with a border that stays open. */
std::vector<RepairCase>
openCases(std::uint64_t seed);

/** \brief Unusual scale, place, density and order. */
std::vector<RepairCase>
unusualCases(std::uint64_t seed);

/** \brief A sphere in four pieces with good and bad free points. */
std::vector<RepairCase>
casesWithFreePoints(std::uint64_t seed);

/** \brief All of these. */
std::vector<RepairCase>
allRepairCases(std::uint64_t seed);

/** \brief Random damage to a random shape: balls, slabs and single triangles taken
 * away, islands turned, order mixed, lost points left over with noise. What comes out
 * right is not known; `whole` is that of the damaged surface. */
DamagedModel
randomlyDamaged(std::uint64_t seed);

} // namespace pcl::ccaa::test
