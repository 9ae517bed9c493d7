// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: triangle by triangle, the best supported one first.
#pragma once

#include <pcl/surface_ccaa/reconstruction_parameters.h>

#include "advancing_front/empty_ball.h"
#include "advancing_front/growing_surface.h"
#include "advancing_front/nearby_triangles.h"
#include "advancing_front/open_surface.h"
#include "advancing_front/triangle_trial.h"
#include "run/run_control.h"

#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

namespace pcl::ccaa {

/** \brief Lets a surface grow into the gaps from its front, and from seeds where there
 * is no surface yet.
 *
 * Every front edge proposes one triangle: of the open points around it the one that
 * finds its place in the fans of all three corners (see fitsFans()) and whose smallest
 * empty ball is smallest. The best proposal of all becomes part of the surface, unless
 * it crosses it. Proposals go in three tiers: smooth continuations first, then folds,
 * and last triangles that would make two stretches of front touch, because these may
 * join what only passes close by, like the two sides of a thin plate.
 *
 * Loops that are left are closed as a whole where possible (see LoopClosure).
 *
 * Serial, because each triangle decides about the next. Cost O(k^2) a triangle. */
class SurfaceGrowth {
public:
  /** \brief All must outlive the object.
   * \param[in] open with neighbors and complete spacings
   * \param[in] nearby what else must not be crossed, or null */
  SurfaceGrowth(const OpenSurface& open,
                const CompletionParameters& parameters,
                const NearbyTriangles* nearby = nullptr);

  /** \brief Grow until nothing more can be added.
   * \param[in,out] control told the work, may be null
   * \return false when cancelled */
  bool
  run(RunControl* control);

  const GrowingSurface&
  surface() const
  {
    return surface_;
  }

  /** \brief Of the last run, see closeLoops(). */
  const std::vector<pcl::index_t>&
  obstructedPoints() const
  {
    return obstructed_;
  }

private:
  /** How good a triangle on a front edge would be; smaller is better. */
  struct Grade {
    int tier = 0; /**< 0 smooth, 1 folded; makes fronts touch: 2 folded, 3 smooth */
    double cost = 0.0;

    bool
    operator<(const Grade& other) const
    {
      return tier != other.tier ? tier < other.tier : cost < other.cost;
    }
  };

  struct Proposal {
    Grade grade;
    FrontIndex edge;
    pcl::index_t apex;

    /** For a queue that gives its greatest element first. */
    bool
    operator<(const Proposal& other) const
    {
      if (other.grade < grade || grade < other.grade)
        return other.grade < grade;
      return edge != other.edge ? edge > other.edge : apex > other.apex;
    }
  };

  /** A triangle that an edge may propose. Smooth ones are estimated by their
   * circumradius, which their smallest empty ball cannot be smaller than. */
  struct Candidate {
    Grade grade;
    pcl::index_t apex = 0;

    bool
    operator<(const Candidate& other) const
    {
      if (grade < other.grade || other.grade < grade)
        return grade < other.grade;
      return apex < other.apex;
    }
  };

  bool
  growFront(RunControl* control);
  bool
  growFromSeeds(RunControl* control, double thickness);
  void
  take(const Proposal& proposal);
  void
  proposeNew();
  void
  propose(FrontIndex edge);
  void
  listCandidates(FrontIndex edge);
  bool
  examine(FrontIndex edge, Candidate& candidate) const;
  void
  collectWitnesses(FrontIndex edge);
  void
  witness(pcl::index_t vertex);
  bool
  estimate(const FrontEdge& edge, const Position& behind, Candidate& candidate) const;
  bool
  isEmpty(EmptyBall& ball, const Triangle& corners) const;
  bool
  isStitched(const FrontEdge& edge, pcl::index_t apex) const;
  bool
  isAdmissible(const FrontEdge& edge, pcl::index_t apex) const;
  bool
  isCurtain(const Triangle& corners, const Position& normal) const;
  bool
  agreesWithNormal(pcl::index_t vertex, const Position& normal) const;
  bool
  plantSeed(pcl::index_t vertex);
  void
  addSeed(Triangle seed);

  const OpenSurface& open_;
  CompletionParameters parameters_;
  double cos_smooth_, cos_largest_;
  GrowingSurface surface_;
  TriangleTrial trial_;
  std::priority_queue<Proposal> proposals_;
  std::vector<std::uint8_t> has_proposal_; /**< of a front edge: one is in the queue */
  /** Apexes that would cross the surface, by front edge; final, as nothing is removed.
   */
  std::vector<std::pair<FrontIndex, pcl::index_t>> banned_;
  FrontIndex unproposed_ = 0; /**< front edges from here on have not been asked */
  std::vector<pcl::index_t> witnesses_;
  std::vector<std::uint32_t> seen_; /**< of a vertex: the last call that met it */
  std::uint32_t call_ = 0;
  std::vector<Candidate> candidates_;
  std::vector<pcl::index_t> obstructed_;
};

} // namespace pcl::ccaa
