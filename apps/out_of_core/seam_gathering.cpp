// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what surrounds the places that a tile has to close.
#include "out_of_core/seam_gathering.h"

#include "mesh/sort_unique.h"

#include <algorithm>
#include <utility>

namespace app {
namespace {

using pcl::ccaa::cornersInOrder;
using pcl::ccaa::WideIndex;
using pcl::ccaa::WideTriangle;

/** What a seam has to know around a dispute, in reaches; twice that for the corners of
 * the triangles there. */
constexpr double AROUND = 4.0;
/** Up to where given triangles may be made anew. */
constexpr double NEAR = 1.5;

pcl::ccaa::Box
boxAround(const PlacedDispute& dispute, double reaches)
{
  const Eigen::Vector3d position(dispute.position.data());
  return pcl::ccaa::widened(pcl::ccaa::Box(position), reaches * dispute.reach);
}

} // namespace

std::vector<ClosedTile>
readAllClosed(const TilePlan& plan, const std::set<std::size_t>& closers)
{
  std::vector<ClosedTile> all;
  for (const std::size_t closer : closers) {
    all.push_back(readClosed(plan, closer));
    pcl::ccaa::sortUnique(all.back().removed);
  }
  return all;
}

std::vector<WideTriangle>
trianglesAfter(const TilePlan& plan,
               std::size_t tile,
               const std::vector<ClosedTile>& closed)
{
  std::vector<WideTriangle> triangles = readJoined(plan, tile).triangles;
  for (const ClosedTile& one : closed) {
    const auto isRemoved = [&](const WideTriangle& triangle) {
      return std::binary_search(
          one.removed.begin(), one.removed.end(), cornersInOrder(triangle));
    };
    triangles.erase(std::remove_if(triangles.begin(), triangles.end(), isRemoved),
                    triangles.end());
    for (const WideTriangle& triangle : one.added)
      if (plan.tiling.tiles[tile].owns(cornersInOrder(triangle).front()))
        triangles.push_back(triangle);
  }
  return triangles;
}

SeamGathering::SeamGathering(const TilePlan& plan, std::size_t tile)
: plan_(plan), tile_(tile)
{
  const AllDisputes all = readDisputes(plan);
  const std::vector<std::size_t> around = plan.tiling.neighborsOf(tile);
  for (std::size_t g = 0; g < all.groups.size(); ++g) {
    const DisputeGroup& group = all.groups[g];
    if (group.tile != tile)
      continue;
    disputes_.insert(disputes_.end(),
                     all.disputes.begin() + static_cast<std::ptrdiff_t>(group.begin),
                     all.disputes.begin() + static_cast<std::ptrdiff_t>(group.end));
    group_of_.resize(disputes_.size(), surroundings_.size());
    surroundings_.emplace_back();
    for (std::size_t part = group.whole;
         part < all.groups.size() && all.groups[part].whole == group.whole;
         ++part) {
      const DisputeGroup& other = all.groups[part];
      if (std::count(around.begin(), around.end(), other.tile) == 0)
        continue;
      if (part < g)
        earlier_.insert(other.tile);
      for (std::size_t d = other.begin; d < other.end; ++d)
        of_others_.insert(all.disputes[d].index);
    }
  }
  std::vector<pcl::ccaa::Box> boxes;
  for (const PlacedDispute& dispute : disputes_)
    boxes.push_back(boxAround(dispute, 2.0 * AROUND));
  tree_ = pcl::ccaa::BoxTree(boxes);
  findParts();
  if (!earlier_.empty()) // whose triangles are longer than others
    parts_.insert(around.begin(), around.end());
}

/** Tiles of disputes, and those around these whose own points may be near one. */
void
SeamGathering::findParts()
{
  std::map<std::size_t, std::vector<const PlacedDispute*>> by_owner;
  for (const PlacedDispute& dispute : disputes_)
    by_owner[plan_.tiling.ownerOf(dispute.index)].push_back(&dispute);
  for (const auto& [owner, disputes] : by_owner) {
    parts_.insert(owner);
    for (const std::size_t part : plan_.tiling.neighborsOf(owner))
      if (std::any_of(disputes.begin(), disputes.end(), [&](const PlacedDispute* d) {
            return plan_.tiling.tiles[part].distance(
                       Eigen::Vector3d(d->position.data())) <= 2.0 * AROUND * d->reach;
          }))
        parts_.insert(part);
  }
}

/** By group, as far as the distance is below twice AROUND. */
std::map<std::size_t, SeamGathering::Nearness>
SeamGathering::nearness(const Eigen::Vector3d& position) const
{
  std::map<std::size_t, Nearness> by_group;
  tree_.forEachMeeting(pcl::ccaa::Box(position), [&](pcl::index_t i) {
    const PlacedDispute& dispute = disputes_[std::size_t(i)];
    const double distance =
        (Eigen::Vector3d(dispute.position.data()) - position).norm();
    if (distance >= 2.0 * AROUND * dispute.reach)
      return;
    Nearness& nearness =
        by_group.emplace(group_of_[std::size_t(i)], Nearness{2.0 * AROUND})
            .first->second;
    nearness.in_reaches = std::min(nearness.in_reaches, distance / dispute.reach);
    nearness.room = std::max(nearness.room, dispute.room - distance);
    nearness.is_refused = nearness.is_refused || distance <= 0.5 * dispute.room;
  });
  return by_group;
}

void
SeamGathering::addPoint(const pcl::ccaa::BorderPoint& point)
{
  for (const auto& [group, nearness] : nearness(point.position)) {
    Known& known = known_[point.index];
    known.position = point.position;
    if (nearness.in_reaches > AROUND)
      continue;
    known.groups.push_back(group);
    surroundings_[group].near.emplace(point.index, nearness);
  }
}

/** None where a corner is not known: it is that of a short triangle far from all.
 * \param[in] own points of the tile that has the triangle */
std::vector<std::size_t>
SeamGathering::groupsPassed(const WideTriangle& triangle,
                            const pcl::ccaa::BorderPoints& own) const
{
  std::vector<std::size_t> groups;
  pcl::ccaa::Box box;
  for (const WideIndex corner : triangle) {
    const auto known = known_.find(corner);
    const auto place =
        known == known_.end() ? pcl::ccaa::findPoint(own, corner) : own.end();
    if (known == known_.end() && place == own.end())
      return groups;
    box.extend(place == own.end() ? known->second.position : place->position);
  }
  tree_.forEachMeeting(box, [&](pcl::index_t i) {
    if (boxAround(disputes_[std::size_t(i)], AROUND).intersects(box))
      groups.push_back(group_of_[std::size_t(i)]);
  });
  pcl::ccaa::sortUnique(groups);
  return groups;
}

void
SeamGathering::addTriangle(const Passing& passing)
{
  std::set<std::size_t> groups(passing.groups.begin(), passing.groups.end());
  std::vector<Known*> corners;
  for (const WideIndex corner : passing.triangle)
    if (const auto known = known_.find(corner); known != known_.end()) {
      corners.push_back(&known->second);
      groups.insert(known->second.groups.begin(), known->second.groups.end());
    }
  if (corners.size() < 3) {
    for (Known* const corner : corners)
      corner->lacks = true;
    return;
  }
  for (const std::size_t group : groups)
    surroundings_[group].triangles.push_back(passing.triangle);
}

void
SeamGathering::read()
{
  for (const std::size_t part : parts_)
    for (const pcl::ccaa::BorderPoint& point : readOwnBorderPoints(plan_, part))
      addPoint(point);
  const auto isNear = [this](WideIndex corner) {
    const auto known = known_.find(corner);
    return known != known_.end() && !known->second.groups.empty();
  };
  const std::vector<ClosedTile> before = readAllClosed(plan_, earlier_);
  std::vector<WideIndex> corners;
  for (const ClosedTile& closed : before)
    for (const WideTriangle& triangle : closed.added)
      corners.insert(corners.end(), triangle.begin(), triangle.end());
  addCorners(std::exchange(corners, {}));
  std::vector<Passing> near;
  for (const std::size_t part : parts_) {
    const pcl::ccaa::BorderPoints points = readOwnBorderPoints(plan_, part);
    for (const WideTriangle& triangle : trianglesAfter(plan_, part, before)) {
      std::vector<std::size_t> groups = groupsPassed(triangle, points);
      if (groups.empty() && std::none_of(triangle.begin(), triangle.end(), isNear))
        continue;
      near.push_back({triangle, std::move(groups)});
      corners.insert(corners.end(), triangle.begin(), triangle.end());
    }
  }
  addCorners(std::move(corners));
  for (const Passing& passing : near)
    addTriangle(passing);
}

/** Of triangles that reach from what is near a group to farther than others. */
void
SeamGathering::addCorners(std::vector<WideIndex> missing)
{
  missing.erase(
      std::remove_if(missing.begin(),
                     missing.end(),
                     [&](WideIndex corner) { return known_.count(corner) > 0; }),
      missing.end());
  pcl::ccaa::sortUnique(missing);
  for (const std::size_t part : parts_)
    if (!missing.empty())
      for (const pcl::ccaa::BorderPoint& point : readOwnBorderPoints(plan_, part))
        if (std::binary_search(missing.begin(), missing.end(), point.index))
          known_[point.index].position = point.position;
}

pcl::ccaa::Seam
SeamGathering::gather(std::size_t group, std::vector<WideIndex>& wide) const
{
  const Surroundings& around = surroundings_[group];
  std::set<WideIndex> used, with_triangle;
  for (const auto& [index, nearness] : around.near)
    used.insert(index);
  for (const WideTriangle& triangle : around.triangles)
    with_triangle.insert(triangle.begin(), triangle.end());
  used.insert(with_triangle.begin(), with_triangle.end());
  wide.assign(used.begin(), used.end());
  pcl::ccaa::Seam seam;
  for (const WideIndex index : wide) {
    seam.points.push_back(
        (known_.at(index).position - plan_.corners[tile_]).cast<float>());
    const auto near = around.near.find(index);
    const Nearness nearness =
        near == around.near.end() ? Nearness{2.0 * AROUND} : near->second;
    const bool is_disputed = nearness.in_reaches == 0.0 ||
                             (nearness.is_refused && of_others_.count(index) > 0);
    const bool is_free = nearness.in_reaches <= 1.0 && with_triangle.count(index) == 0;
    seam.is_open.push_back(is_disputed || is_free ? 1 : 0);
    seam.is_near.push_back(nearness.in_reaches <= NEAR ? 1 : 0);
    seam.is_whole.push_back(near != around.near.end() && !known_.at(index).lacks ? 1
                                                                                 : 0);
    seam.room.push_back(static_cast<float>(nearness.room));
  }
  for (const WideTriangle& triangle : around.triangles) {
    seam.tile_of.push_back(plan_.tiling.ownerOf(cornersInOrder(triangle).front()));
    seam.given.emplace_back();
    for (std::size_t i = 0; i < 3; ++i)
      seam.given.back()[i] = static_cast<pcl::index_t>(
          std::lower_bound(wide.begin(), wide.end(), triangle[i]) - wide.begin());
  }
  return seam;
}

} // namespace app
