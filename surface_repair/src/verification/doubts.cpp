// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: where another topology is as likely as the repaired one.

#include "verification/doubts.h"

#include "boundary/classification.h"
#include "field/float_tree.h"
#include "mesh/corners.h"
#include "verification/junction_doubts.h"
#include "verification/new_parts.h"
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
/** Part of the limit that holds for a surface with handles: it may have lost more. */
constexpr double LIMIT_WITH_HANDLES = 0.25;
/** Distance of a crumb from the rim of the patch that took it in, in the rim's length:
 * within a disc there is none above 1 / 2 pi. */
constexpr double FAR_CRUMB = 0.3;

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
  for (const NewPart& part : newParts(repaired, report, parameters.crumb_triangles)) {
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
  const auto is_body = [&] {
    return report.after.boundary_loops == 0 ||
           isSeenFromAllSides(facingOf(repaired.model, repaired.input_triangles));
  };
  const double limit =
      parameters.greatest_unsupported >= 1.0 || report.after.genus.value_or(0) <= 0
          ? parameters.greatest_unsupported
          : LIMIT_WITH_HANDLES * parameters.greatest_unsupported;
  if (share > limit && !parameters.closesAll() && is_body())
    doubts.push_back({DoubtReason::UNSUPPORTED, {-1, -1}, share});
  return doubts;
}

} // namespace pcl::repair
