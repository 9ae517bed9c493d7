// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: all options of a repair.

#pragma once

#include <pcl/surface_ccaa/side_settings.h>
#include <pcl/memory.h>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace pcl {
struct PointXYZ;
namespace search {
template <typename PointT>
class Search;
}
namespace repair {

/** \brief A limit in units of the cloud, or as a share of the diagonal of the bounding
 * box of all triangles. */
struct Extent {
  Extent() = default;
  /** \param[in] limit at least 0; 0: no limit
   * \param[in] in_diagonals 0.05 is 5 % of the diagonal; else units of the cloud */
  Extent(double limit, bool in_diagonals = false)
  : value(limit), of_diagonal(in_diagonals)
  {}

  bool
  limits() const
  {
    return value > 0.0;
  }
  /** \brief In units of the cloud. */
  double
  length(double diagonal) const
  {
    return of_diagonal ? value * diagonal : value;
  }

  double value = 0.0;
  bool of_diagonal = false;
};

/** \brief Edges up to which a hole is simple for the thesis' filling method (4.7). */
constexpr std::size_t SIMPLE_HOLE_EDGES = 12;

/** \brief Islands of fewer triangles carry little orientation and few bridges. */
constexpr std::size_t CRUMB_TRIANGLES = 30;

/** \brief Which islands are too small: those below any of the limits. */
struct SmallIslands {
  /** \brief Fewer than so many. Set it against crumbs of strays. */
  std::size_t triangles = 0;
  /** \brief Less than that, squared units of the cloud. Set it where the size of real
   * parts is known. */
  double area = 0.0;
  /** \brief Less than that of all islands' area, 0 to 1. Set it where no size is known.
   */
  double share_of_all_area = 0.0;

  bool
  any() const
  {
    return triangles > 0 || area > 0.0 || share_of_all_area > 0.0;
  }
};

/** \brief When a rule decides about the side of an island. */
struct OrientationParameters {
  /** \brief What is told about the outer side; goes before the other rules. */
  ccaa::SideHints sides;
  /** \brief Balance of the votes, 0 to 1, from which given normals agree with each
   * other. Default 0.5: three of four. Viewpoints and up are clear from
   * ccaa::VOTE_MARGIN on. Set it lower where normals are noisy but right on the whole.
   */
  double agreement = 0.5;
  /** \brief Balance from which free sight makes a standard island. Default 0.3. Set
   * it higher where islands are turned wrongly by what is seen through gaps. */
  double clear_sight = 0.3;
  /** \brief Share of the ways of the better side that must be free for that, 0 to 1:
   * what is seen through a gap errs easily. Default 0.5. Set it lower for islands
   * within others. */
  double least_sight = 0.5;
  /** \brief Balance of the field integral, 0 to 1, from which it decides alone.
   * Default 0.5. Set it lower where islands stay undecided beside their neighbours. */
  double clear_field = 0.5;
  /** \brief Balance from which field and sight together decide, 0 to 2. Default 0.2.
   * Set it higher where a wrong side costs more than an open question. */
  double decided_from = 0.2;
  /** \brief k of r = k d (4.48): a way closer than this times the mean free-point
   * spacing to a free point is not free. Default 1. Set it lower where strays
   * block the sight. */
  double sight_clearance = 1.0;
};

/** \brief When a class of a boundary counts as decided. */
struct ClassificationParameters {
  /** \brief Least confidence of a class that is not UNDECIDED, 0 to 1. Set it higher
   * where a wrong class costs more than an open question. */
  double decided_from = 0.4;
  /** \brief Share of a rim that must be faced by other islands before it is an
   * ISLAND_RIM and no OUTER_BORDER, 0 to 1. Set it lower where islands lie side by side
   * and their rims count as outer borders. */
  double faced_from = 0.25;
};

/** \brief Light (M1): distances as they are, nothing shields. Full (M2): free points
 * shorten ways (4.424) and the surface shields (E4.43-6). Set it to full where free
 * points or thin walls lie between islands. */
enum class FieldMode : std::uint8_t { LIGHT, FULL };

/** \brief Any search of PCL. Its header takes long to compile, hence not here. */
using PointSearchPtr = pcl::shared_ptr<pcl::search::Search<pcl::PointXYZ>>;

/** \brief L_2 by the gap to be crossed: the sources straight ahead keep
 * (1 - 1 / 2.5)^2.5 = 0.28 of their strength, and a good arc of the other boundary is
 * within reach. */
constexpr double DEFAULT_ROOM = 2.5;

/** \brief Default of k_t: free points are as trustworthy as not (4.424): one of them
 * halves the length of what passes close by. */
constexpr double DEFAULT_TRUST = 0.5;

/** \brief The method's parameters; 0 stands for "from the data" where it says so. */
struct FieldParameters {
  FieldMode mode = FieldMode::LIGHT;
  double interpolation =
      0.0; /**< k_i, at least 0. Set it to 1 for ragged boundaries. */
  double falloff_exponent = 2.5; /**< chi, above 0. Set it to 1.7 for long wide gaps. */
  /** \brief L_1; 0: the mean source spacing. Set it to some five edges where boundaries
   * are torn. */
  double near = 0.0;
  /** \brief L_2; 0: `room` times the gap at each place. Set it where all gaps are
   * alike.
   */
  double far = 0.0;
  /** \brief Gaps that L_2 spans, above 1: at an origin the gap before it, along a line
   * the gap that is left to the nearest target, if that is less. Of the thesis is only
   * the first, with which a line that comes to a closely sampled ring may turn away at
   * the last moment, because the far side of the ring repels. Set it lower where lines
   * leave narrow gaps for wide ones, higher where they lose their targets. */
  double room = DEFAULT_ROOM;
  /** \brief Eight sources that are further away than so many radii of their stretch of
   * boundary count as one, in light mode between islands; 0: all count for themselves.
   * Set it higher where force lines have to be exact. */
  double coarse_distance = 8.0;
  /** \brief R_1; 0: mean free-point spacing. Set it higher where they lie in clusters.
   */
  double free_point_near = 0.0;
  /** \brief R_2; 0: half the mean gap. Set it higher where bridges pass by free points,
   * lower where a cluster beside the gap pulls them. */
  double free_point_far = 0.0;
  /** \brief gamma, above 0. Set it higher where the nearest free points should rule. */
  double free_point_exponent = 1.0;
  /** \brief k_t of the free points, in [0, 1). Set it higher for exact samples, lower
   * for noisy ones. */
  double trust = DEFAULT_TRUST;
  /** \brief For the neighbourhoods of free points; null: search::KdTree. */
  PointSearchPtr search;
};

/** \brief How exactly a force line is followed, and how far. */
struct TrackerParameters {
  /** \brief Greatest error of one step, in L_1. Default 0.03. Set it higher for speed.
   */
  double tolerance = 0.03;
  /** \brief Distance in L_1 at which a boundary captures a line, which then goes on
   * straight. Nearer than that the single sources show. Default 2. Set it higher
   * where lines waver before ragged boundaries. */
  double capture_distance = 2.0;
  /** \brief Greatest length of a line in L_2. Default 2. Set it higher where lines end
   * on the way round free points. */
  double greatest_length = 2.0;
  /** \brief Clearness below which a normal counts as undetermined (4.44), 0 to 1.
   * Default 0.05. Set it higher where bridges are twisted. */
  double least_clearness = 0.05;
};

/** \brief How far free points pull a line. */
struct PerturbationParameters {
  /** \brief k_t of the free points, in [0, 1): 0 leaves the line where it is. */
  double trust = 0.5;
  /** \brief Half height of the cylinder around the normal line, in R_2, above 0: free
   * points further off the line are those of another sheet. Default 1. Set it lower
   * where two sheets lie close together. */
  double half_height = 1.0;
  /** \brief k of E4.6-4: weight of the supporting points, at least 0. Default 1.
   * Set it lower where a bridge should follow its free points more closely. */
  double support_weight = 1.0;
  /** \brief Weight of the pole that the unperturbed point itself is, at least 0.
   * Default 1, the tension of a free point of trust 0.5. With 0 (E4.6-3 to the letter)
   * one free point, however little trusted and however far aside within R_2, pulls the
   * line all the way. Set it to 0 to compare with the thesis. */
  double own_weight = 1.0;
};

/** \brief When a junction is believed. */
struct JunctionParameters {
  /** \brief false: every pair that a line connects is joined. Set it false where
   * all islands are one object. */
  bool judge = true;
  /** \brief Least log odds of what is joined. Default 0.5: in doubt it is left open.
   * Set it lower where one object stays in pieces, higher where objects are glued. */
  double joined_from = 0.5;
  /** \brief Log odds below which two boundaries are different objects for sure; of a
   * junction that is joined a line by itself with less is not believed. Set it lower to
   * be asked about more of them. */
  double different_below = -2.0;
};

struct Decisions;

/** \brief Everything about a survey that can be set. */
struct SurveyParameters {
  FieldParameters field;
  OrientationParameters orientation;
  ClassificationParameters classification;
  TrackerParameters tracker;
  JunctionParameters junction;
  PerturbationParameters perturbation; /**< its trust is that of the field */
  /** \brief See countHoles(). Set it higher to close larger holes undivided. */
  std::size_t simple_edges = SIMPLE_HOLE_EDGES;
  /** \brief T of a hole (4.5), in lengths of its boundary. Set it lower for long narrow
   * holes. */
  double hole_threshold = 0.25;
  /** \brief Least arc length between bridges, in lengths of the bridge. Set it lower
   * for curved gaps, higher for ragged boundaries. */
  double bridge_spacing = 0.5;
  /** \brief Least arc length between origins, in gaps. Set it lower where a short
   * boundary gets too few lines. */
  double line_spacing = 0.25;
  /** \brief Longer bridges between islands are not built; 0: no limit. Set it where
   * separate objects lie near each other. */
  Extent greatest_bridge = {};
  SmallIslands dropped = {}; /**< islands that are left out on reading */
  std::shared_ptr<const Decisions> decisions = {}; /**< of the user, or null */
  /** \brief Lines and bridges of step ICM3 -> ICM2. Set it false to look at holes only.
   */
  bool trace_between_islands = true;
  /** \brief Lines within each complex hole. Set it false to look at islands only. */
  bool trace_in_holes = true;
};

/** \brief How holes are closed. Set it to fan to compare with the thesis, to completion
 * where free points lie dense. */
enum class FillingChoice : std::uint8_t {
  AUTOMATIC,      /**< COMPLETION where a hole holds enough free points, else
                       MINIMUM_WEIGHT */
  FAN,            /**< from the centroid (4.7), the thesis' baseline */
  MINIMUM_WEIGHT, /**< least largest fold, then least area */
  COMPLETION      /**< base algorithm of surface_ccaa with the free points */
};

/** \brief Which boundaries are closed. Set it to all for a closed model, to nothing
 * where only islands are to be joined. */
enum class CloseChoice : std::uint8_t {
  NOTHING, /**< only what joins islands */
  HOLES,   /**< what is a hole for sure */
  ALL /**< also outer borders, mouths of tubes, undecided loops and rims of islands,
           once nothing more can be joined */
};

/** \brief The shape of a patch. */
enum class Cap : std::uint8_t {
  AUTO, /**< flat over a large plane rim that the surface meets steeply, else smooth */
  SMOOTH, /**< goes on as the surface around does */
  FLAT    /**< in the plane of its rim, at which a fold may stay */
};

/** \brief How simple holes are closed, and which. */
struct FillingParameters {
  FillingChoice choice = FillingChoice::AUTOMATIC;
  /** \brief Edges up to which a hole is simple; 0: as many as the method says. Set it
   * together with that of the survey. */
  std::size_t simple_edges = 0;
  /** \brief Loops of more edges are left open; 0: no limit. Set it where large holes
   * are real. */
  std::size_t greatest_hole = 0;
  /** \brief Longer loops are left open; 0: no limit. Set it where a length tells
   * which holes are real. */
  Extent greatest_length = {};
  CloseChoice close = CloseChoice::HOLES;
  /** \brief Of patches about which no decision says more. Set it to flat for objects
   * that stood on something, or were cut off. */
  Cap cap = Cap::AUTO;
};

/** \brief How small new triangles become. */
struct RefinementParameters {
  /** \brief Edge length wanted, in those of the surface around: above 0. Default 1.
   * Set it higher for fewer triangles. */
  double edge_length = 1.0;
  /** \brief Greatest number of new vertices in a patch: beyond it triangles stay as
   * large as they are then. Default 1 million. Set it lower where memory is short. */
  std::size_t greatest_number = 1000000;
};

/** \brief How new vertices move to a smooth surface. */
struct RelaxationParameters {
  /** \brief k_t of the free points, in [0, 1): 0 and they do not count.
   * Default 0.5. */
  double trust = 0.5;
  /** \brief Free points count within so many edge lengths of the patch, above 0.
   * Default 3. Set it higher where the patch has yet to come near them. */
  double reach = 3.0;
  /** \brief Times that the surface is solved anew on what came out before, at least 1;
   * fewer are done where one would make the surface worse, or has changed next to
   * nothing. Default 6. Set it lower for speed. */
  std::size_t rounds = 6;
};

/** \brief Everything about a repair that can be set. */
struct RepairParameters {
  SurveyParameters survey; /**< sides, classes, field, lines, bridges */
  FillingParameters filling;
  /** \brief false: only holes are closed. Set it false where islands are objects. */
  bool join_islands = true;
  /** \brief Discs of fewer triangles wait until the other islands are joined, and are
   * laid into the patches that cover them. Not where islands are not to be joined, nor
   * with decisions of the user. 0: none wait. Set it to 0 where small islands are as
   * good as large ones. */
  std::size_t crumb_triangles = CRUMB_TRIANGLES;
  /** \brief A surface without any boundary is wanted: CloseChoice::ALL, and whatever
   * stays open is a shortfall. Set it for printing and for volumes. */
  bool watertight = false;
  /** \brief Share of the area, 0 to 1, above which new triangles that little supports
   * leave the topology in doubt (DoubtReason::UNSUPPORTED); of a surface with handles
   * a quarter of it does. 1: never. Default 0.2. Set it lower where inventions harm. */
  double greatest_unsupported = 0.2;
  /** \brief Make patches as dense as what is around. Set it false where few triangles
   * matter more than a smooth patch. */
  bool refine = true;
  /** \brief Fair them; only when refined. Set it false to do that by other means. */
  bool relax = true;
  RefinementParameters refinement;
  RelaxationParameters relaxation; /**< its trust is that of the field */

  /** \brief Whether all boundaries are to be closed. */
  bool
  closesAll() const
  {
    return watertight || filling.close == CloseChoice::ALL;
  }
};

} // namespace repair
} // namespace pcl
