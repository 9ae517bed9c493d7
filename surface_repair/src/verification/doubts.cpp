// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: where another topology is as likely as the repaired one.

#include "verification/doubts.h"

#include "boundary/classification.h"
#include "field/float_tree.h"
#include "mesh/corners.h"
#include "verification/junction_doubts.h"
#include "verification/piece_doubts.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace pcl::repair {

namespace {

/** Area of the tube between two rims, in that of their caps, up to which either may be
 * meant. The tunnels that caps have closed in damaged machine parts have 0.4 to 1.35.
 */
constexpr double MOST_OF_CAPS = 1.4;
/** Cosine between what looks in opposite directions. */
constexpr double OPPOSITE = 0.8;
/** Length of the mean normal of what is flat: where something stood, or was cut off. */
constexpr double FLAT = 0.999;
/** Measured vertices that support what is new. */
constexpr std::size_t FEWEST_SAMPLES = 4;
/** Part of the limit that holds for a surface with handles: it may have lost more. */
constexpr double LIMIT_WITH_HANDLES = 0.25;
/** Distance of a crumb from the rim of the patch that took it in, in the rim's length:
 * within a disc there is none above 1 / 2 pi. */
constexpr double FAR_CRUMB = 0.3;
/** Confidence of a junction up to which it supports nothing, and from which all. */
constexpr double UNSURE = 0.5;
constexpr double SURE = 0.75;

/** New triangles that hang together, with crumbs among them. */
struct NewPart {
  std::size_t piece = 0;
  double area = 0.0;
  Eigen::Vector3d out = Eigen::Vector3d::Zero(); /**< sum of normals times area */
  Position center = Position::Zero();            /**< of area */
  double rim = 0.0;                              /**< its length */
  pcl::index_t point = pcl::UNAVAILABLE;         /**< the lowest on its rim */
  double unsupported = 0.0;                      /**< area */
  double crumb_gap = 0.0;                        /**< from the rim, most of all */
  pcl::index_t crumb = pcl::UNAVAILABLE;         /**< a point of that one */
  bool is_disc = false;
};

/** How little the junctions tell of what lies between loops, 0 to 1. */
double
doubtOfJunctions(const std::vector<RepairJunction>& junctions)
{
  double weakest = 1.0;
  for (const RepairJunction& junction : junctions)
    if (junction.verdict == JunctionVerdict::JOINED)
      weakest = std::min(weakest, junction.confidence);
  return std::clamp((SURE - weakest) / (SURE - UNSURE), 0.0, 1.0);
}

class NewParts {
public:
  NewParts(const RepairedModel& repaired,
           const RepairReport& report,
           std::size_t crumb_triangles)
  : model_(repaired.model)
  , report_(report)
  , input_triangles_(repaired.input_triangles)
  , doubt_of_junctions_(doubtOfJunctions(report.junctions))
  , is_new_(model_.triangles.size(), true)
  {
    std::fill_n(is_new_.begin(), input_triangles_, false);
    addCrumbs(crumb_triangles);
  }

  /** By lowest triangle. */
  std::vector<NewPart>
  list() const
  {
    std::vector<NewPart> list;
    std::vector<bool> is_seen(is_new_.size(), false);
    for (std::size_t t = 0; t < is_new_.size(); ++t) {
      if (!is_new_[t] || is_seen[t])
        continue;
      std::vector<std::size_t> triangles = connectedWith(t, is_new_.size(), is_seen);
      std::sort(triangles.begin(), triangles.end());
      list.push_back(partOf(triangles));
      list.back().piece = model_.island_of[t];
    }
    return list;
  }

private:
  /** Crumbs within a patch are part of it: they do not make it an annulus. */
  void
  addCrumbs(std::size_t crumb_triangles)
  {
    std::vector<bool> is_seen(is_new_.size(), false);
    for (std::size_t t = input_triangles_; t < is_new_.size(); ++t)
      for (int corner = 0; corner < 3; ++corner) {
        const pcl::index_t across =
            model_.adjacency.across(static_cast<pcl::index_t>(t), corner);
        if (across < 0 || is_new_[static_cast<std::size_t>(across)])
          continue;
        const std::vector<std::size_t> island =
            connectedWith(static_cast<std::size_t>(across), crumb_triangles, is_seen);
        for (const std::size_t triangle : island) {
          is_seen[triangle] = false;
          is_new_[triangle] = island.size() < crumb_triangles;
        }
      }
  }

  /** Triangles that edges connect with one and that are new like it, or are not: all
   * that there are, or as many as are enough. */
  std::vector<std::size_t>
  connectedWith(std::size_t first, std::size_t enough, std::vector<bool>& is_seen) const
  {
    std::vector<std::size_t> found{first};
    is_seen[first] = true;
    for (std::size_t i = 0; i < found.size() && found.size() < enough; ++i)
      for (int corner = 0; corner < 3; ++corner) {
        const std::size_t other = likeAcross(found[i], corner);
        if (other == NONE || is_seen[other])
          continue;
        is_seen[other] = true;
        found.push_back(other);
      }
    return found;
  }

  /** The triangle beyond an edge of one, if it is new like that one, or is not; or
   * NONE. */
  std::size_t
  likeAcross(std::size_t triangle, int corner) const
  {
    const pcl::index_t other =
        model_.adjacency.across(static_cast<pcl::index_t>(triangle), corner);
    return other >= 0 && is_new_[static_cast<std::size_t>(other)] == is_new_[triangle]
               ? static_cast<std::size_t>(other)
               : NONE;
  }

  /** Of a triangle, 0 to 1: how little tells of what it stands for. */
  double
  doubtOf(std::size_t triangle) const
  {
    if (report_.hole_of[triangle] == NONE)
      return 0.0;
    const RepairedHole& hole = report_.holes[report_.hole_of[triangle]];
    const bool joins =
        hole.islands.size() > 1 ||
        std::any_of(hole.bridges.begin(), hole.bridges.end(), [&](std::size_t bridge) {
          return !report_.bridges[bridge].within_hole;
        });
    if (report_.origins[triangle] == TriangleOrigin::COMPLETION ||
        (joins && hole.bridges.empty() && hole.free_points >= FEWEST_SAMPLES))
      return 0.0;
    return joins && !hole.bridges.empty() ? doubt_of_junctions_ : 1.0;
  }

  NewPart
  partOf(const std::vector<std::size_t>& triangles) const
  {
    NewPart part;
    std::set<pcl::index_t> vertices;
    std::set<pcl::index_t> rim;
    for (const std::size_t number : triangles) {
      const Triangle& triangle = model_.triangles[number];
      const ccaa::Corners corners = ccaa::cornersOf(triangle, model_.positions);
      const Eigen::Vector3d normal = 0.5 * ccaa::areaNormal(corners);
      const double area = normal.norm();
      part.area += area;
      part.unsupported += doubtOf(number) * area;
      part.out += normal;
      part.center += area / 3.0 * (corners[0] + corners[1] + corners[2]);
      vertices.insert(triangle.begin(), triangle.end());
      for (int i = 0; i < 3; ++i) {
        if (likeAcross(number, i) != NONE)
          continue;
        const auto from = static_cast<std::size_t>(i);
        const std::size_t to = (from + 1) % 3;
        part.rim += (corners[to] - corners[from]).norm();
        rim.insert(triangle[from]);
      }
    }
    part.center /= part.area;
    if (part.out.norm() > FLAT * part.area)
      part.unsupported = 0.0;
    // Each triangle has three edges, and all but those of the rim have two triangles:
    // with as many edges as vertices on it, V - E + F is V - R / 2 - F / 2.
    part.is_disc = 2 * vertices.size() == triangles.size() + rim.size() + 2;
    part.point = lowestPoint(model_, {rim.begin(), rim.end()});
    findFarthestCrumb(triangles, rim, part);
    return part;
  }

  void
  findFarthestCrumb(const std::vector<std::size_t>& triangles,
                    const std::set<pcl::index_t>& rim,
                    NewPart& part) const
  {
    std::set<pcl::index_t> crumbs;
    for (const std::size_t number : triangles)
      if (number < input_triangles_)
        crumbs.insert(model_.triangles[number].begin(), model_.triangles[number].end());
    if (crumbs.empty() || rim.empty())
      return;
    const auto at = [&](pcl::index_t vertex) -> const Position& {
      return model_.positions[static_cast<std::size_t>(vertex)];
    };
    Positions places;
    for (const pcl::index_t vertex : rim)
      places.push_back(at(vertex));
    const FloatTree tree(places);
    for (const pcl::index_t vertex : crumbs) {
      const auto nearest =
          static_cast<std::size_t>(tree.nearest(at(vertex), 1).front());
      const double gap = (places[nearest] - at(vertex)).norm();
      if (gap <= part.crumb_gap)
        continue;
      part.crumb_gap = gap;
      part.crumb = model_.point_of_vertex[static_cast<std::size_t>(vertex)];
    }
  }

  const IncompleteModel& model_;
  const RepairReport& report_;
  std::size_t input_triangles_;
  double doubt_of_junctions_;
  std::vector<bool> is_new_; /**< of each triangle: it is, or a crumb */
};

double
areaOf(const IncompleteModel& model)
{
  double area = 0.0;
  for (const Triangle& triangle : model.triangles)
    area += 0.5 * ccaa::areaNormal(ccaa::cornersOf(triangle, model.positions)).norm();
  return std::max(area, std::numeric_limits<double>::min());
}

/** Area of the tube between the rims of two caps in that of the caps, where they lie on
 * opposite sides of a body; else more than the most. */
double
tubeOverCaps(const NewPart& first, const NewPart& second)
{
  const Eigen::Vector3d way = second.center - first.center;
  const double distance = way.norm();
  const Eigen::Vector3d out = first.out.normalized();
  const Eigen::Vector3d other_out = second.out.normalized();
  if (first.piece != second.piece || out.dot(other_out) > -OPPOSITE ||
      out.dot(way) > -OPPOSITE * distance || other_out.dot(way) < OPPOSITE * distance)
    return 2.0 * MOST_OF_CAPS;
  return 0.5 * (first.rim + second.rim) * distance / (first.area + second.area);
}

/** By their points, ascending. */
std::vector<RepairDoubt>
tunnelsOf(const std::vector<NewPart>& caps, const std::set<PointPair>& apart)
{
  Positions centers;
  for (const NewPart& cap : caps)
    centers.push_back(cap.center);
  const FloatTree tree(centers);
  std::map<PointPair, double> ratios;
  std::vector<pcl::index_t> near;
  for (const NewPart& cap : caps) {
    // One of the two reaches at least as far for its size as both together.
    tree.near(cap.center, 2.0 * MOST_OF_CAPS * cap.area / cap.rim, near);
    for (const pcl::index_t found : near) {
      const NewPart& other = caps[static_cast<std::size_t>(found)];
      const double ratio = tubeOverCaps(cap, other);
      if (ratio <= MOST_OF_CAPS)
        ratios[inOrder(cap.point, other.point)] = ratio;
    }
  }
  std::vector<RepairDoubt> tunnels;
  for (const auto& [points, ratio] : ratios)
    if (apart.count(points) == 0)
      tunnels.push_back({DoubtReason::TUNNEL, points, ratio});
  return tunnels;
}

} // namespace

std::vector<RepairDoubt>
doubtsAbout(const RepairedModel& repaired,
            const RepairReport& report,
            const RepairParameters& parameters)
{
  std::vector<NewPart> caps;
  std::vector<RepairDoubt> far_crumbs;
  double unsupported = 0.0;
  for (const NewPart& part :
       NewParts(repaired, report, parameters.crumb_triangles).list()) {
    unsupported += part.unsupported;
    if (part.crumb_gap > FAR_CRUMB * part.rim)
      far_crumbs.push_back({DoubtReason::LONG_GAP,
                            inOrder(part.point, part.crumb),
                            M_PI * part.crumb_gap / part.rim});
    if (part.is_disc && part.area > 0.0)
      caps.push_back(part);
  }
  std::vector<RepairDoubt> doubts =
      tunnelsOf(caps, decidedLoops(parameters.survey.decisions.get(), false));
  const std::vector<RepairDoubt> weak = weakJunctions(report, parameters.survey);
  doubts.insert(doubts.end(), weak.begin(), weak.end());
  doubts.insert(doubts.end(), far_crumbs.begin(), far_crumbs.end());
  const std::vector<RepairDoubt> parted =
      partedJunctions(repaired.model, report, parameters.survey);
  doubts.insert(doubts.end(), parted.begin(), parted.end());
  for (const auto& more : {unjoinedMouths(report, parameters.survey),
                           doubtfulPieces(repaired, report, parameters.survey),
                           newNecks(repaired, parameters.survey)})
    doubts.insert(doubts.end(), more.begin(), more.end());
  const double share = unsupported / areaOf(repaired.model);
  const bool is_asked_for =
      parameters.watertight || parameters.filling.close == CloseChoice::ALL;
  const auto is_body = [&] {
    return report.after.boundary_loops == 0 ||
           isSeenFromAllSides(facingOf(repaired.model, repaired.input_triangles));
  };
  const double limit =
      parameters.greatest_unsupported >= 1.0 || report.after.genus.value_or(0) <= 0
          ? parameters.greatest_unsupported
          : LIMIT_WITH_HANDLES * parameters.greatest_unsupported;
  if (share > limit && !is_asked_for && is_body())
    doubts.push_back({DoubtReason::UNSUPPORTED, {-1, -1}, share});
  return doubts;
}

} // namespace pcl::repair
