// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the gaps of a surface, and how it grows into them.
#pragma once

#include <pcl/surface_ccaa/reconstruction_parameters.h>

#include "advancing_front/nearby_triangles.h"
#include "advancing_front/new_islands.h"
#include "advancing_front/open_surface.h"
#include "advancing_front/partial_surface.h"
#include "mesh/block_loop.h"

#include <functional>
#include <vector>

namespace pcl::ccaa {

/** \brief Puts open vertices into an order that is coherent in space and fills in their
 * nearest among themselves: row i of the table, k places, belongs to the i-th vertex of
 * the new order; entries are places in that order, nearest first, -1 where there are no
 * more. Returns false when cancelled. */
using NeighborSearch = std::function<bool(
    std::vector<pcl::index_t>& open, unsigned int k, std::vector<pcl::index_t>& table)>;

/** \brief What is open in a surface, as one open surface. */
struct Gap {
  std::vector<pcl::index_t> open;     /**< its open points in the whole */
  std::vector<pcl::index_t> vertices; /**< all of its vertices in the whole */
  OpenSurface surface;                /**< with neighbors and spacings */
};

/** \brief The gap of a surface, without points that are scattered in space (see
 * findScatteredPoints()). Those that happen to have flat neighborhoods show when the
 * others are gone.
 * \param[in,out] surface is told the spacing of points without triangles
 * \param[in] open points as \a search has ordered them \param[in] table of these
 * \param[in] usual_spacing of the given triangles
 * \param[in,out] control told the work, may be null
 * \return nothing of use after cancelling */
Gap
openGap(PartialSurface& surface,
        std::vector<pcl::index_t> open,
        std::vector<pcl::index_t> table,
        double usual_spacing,
        unsigned int k,
        const NeighborSearch& search,
        RunControl* control);

/** \brief Grow into a gap (see SurfaceGrowth), all its regions at the same time: these
 * know nothing of each other.
 * \param[in,out] surface gets the new triangles whose component is large enough
 * \param[in] context stage "growth"
 * \return obstructed points of the whole; nothing of use after cancelling */
std::vector<pcl::index_t>
growInto(const Gap& gap,
         const NearbyTriangles& nearby,
         const CompletionParameters& parameters,
         const ComponentRule& rule,
         const LoopContext& context,
         PartialSurface& surface);

/** \brief New triangles are tested against those around them when they are made; among
 * long ones, as between outliers, that may have missed another new one. The later one
 * goes. */
void
dropCrossings(PartialSurface& surface,
              const PointView& points,
              const LoopContext& context);

/** \brief Close the loops between some points (see closeLoops()).
 * \param[in] open these, ascending \param[in] grown tells the spacing at its points, as
 * before growth: new edges are long where something is missing
 * \param[in] nearby what must not be crossed
 * \param[in,out] control told the work, may be null
 * \return whether there are new triangles */
bool
closeBetween(const std::vector<pcl::index_t>& open,
             const Gap& grown,
             const NearbyTriangles& nearby,
             const CompletionParameters& parameters,
             PartialSurface& surface,
             RunControl* control);

/** \brief The open points, and the corners of triangles that went or came. */
std::vector<pcl::index_t>
touchedVertices(const PartialSurface& surface,
                const std::vector<pcl::index_t>& open,
                RunControl* control);

} // namespace pcl::ccaa
