// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a surface of which parts are taken out and filled anew.

#pragma once

#include "filling/patch.h"
#include "icadm/incomplete_model.h"
#include "mesh/box_tree.h"

#include <cstddef>
#include <map>
#include <unordered_map>
#include <vector>

namespace pcl::repair {

/** \brief Part of a surface as a model of its own. */
struct ModelPart {
  std::vector<std::size_t> triangles; /**< of the whole, ascending */
  std::vector<bool> is_new;           /**< of these: they fill a hole */
  std::vector<pcl::index_t> vertices; /**< of the whole, for each of the part */
  std::unordered_map<pcl::index_t, pcl::index_t>
      number_of; /**< in the part, of the whole's */
  IncompleteModel model;

  /** \brief Of one of its triangles. \param[in] triangle as the whole numbers it */
  std::size_t
  placeOf(std::size_t triangle) const;
};

/** \brief Triangles that are to go, and what comes in their place. */
struct Replacement {
  std::vector<std::size_t> gone; /**< of the whole */
  Patch patch;                   /**< its rim is numbered as the whole */
};

/** \brief Triangles that come and go after holes were closed. */
class GrowingSurface {
public:
  /** \param[in] of_hole the hole of each triangle, NONE for those of the input
   * \param[in,out] control here and below: told the work, may be null */
  GrowingSurface(const IncompleteModel& model,
                 const std::vector<std::size_t>& of_hole,
                 ccaa::RunControl* control = nullptr);

  /** \brief Triangles that are there and whose box meets another one, ascending. */
  std::vector<std::size_t>
  near(const ccaa::Box& box, ccaa::RunControl* control = nullptr) const;

  /** \brief Those of them that close holes. */
  std::vector<std::size_t>
  patchesNear(const ccaa::Box& box, ccaa::RunControl* control = nullptr) const;

  /** \brief Some triangles, ascending, as a model; of no use after cancelling.
   * \param[in] others in place of some of these, at the same places */
  ModelPart
  part(std::vector<std::size_t> chosen,
       ccaa::RunControl* control = nullptr,
       const std::map<std::size_t, Triangle>& others = {}) const;

  /** \brief Triangles of holes that run through some triangles. */
  std::vector<std::size_t>
  meeting(const std::vector<std::size_t>& some,
          ccaa::RunControl* control = nullptr) const;

  /** \brief Take triangles away and add a patch. \param[in] of_hole that it closes
   * \return around all of them */
  ccaa::Box
  replace(const Replacement& replacement, std::size_t of_hole);

  /** \brief Take triangles away. \return around all of them */
  ccaa::Box
  remove(const std::vector<std::size_t>& some);

  /** \brief Boxes of the triangles that have gone. */
  std::vector<ccaa::Box>
  gone() const;

  /** \brief Triangles have gone. */
  bool
  hasChanged() const;

  pcl::index_t
  pointOf(pcl::index_t vertex) const
  {
    return point_of_vertex[static_cast<std::size_t>(vertex)];
  }

  Triangles triangles;
  Positions positions;
  std::vector<pcl::index_t> point_of_vertex; /**< of the cloud */
  std::vector<std::size_t> hole;             /**< of each triangle */
  std::vector<bool> is_there;                /**< of each triangle */

private:
  template <typename Counts>
  std::vector<std::size_t>
  meetingBox(const ccaa::Box& box,
             const Counts& counts,
             ccaa::RunControl* control) const;
  void
  buildTree(ccaa::RunControl* control);

  std::size_t in_tree_ = 0;
  ccaa::BoxTree tree_;
};

/** \brief A patch in place of triangles of a part. \param[in] is_gone of the part's
 * triangles \param[in] left the rest of the part, of which the rim of the patch is */
Replacement
replacementIn(const ModelPart& part,
              const std::vector<bool>& is_gone,
              const ModelPart& left,
              Patch patch);

} // namespace pcl::repair
