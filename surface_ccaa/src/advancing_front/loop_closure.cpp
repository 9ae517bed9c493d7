// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: closes small gaps that the growth could not.
#include "advancing_front/loop_closure.h"

#include "advancing_front/spacing.h"
#include "advancing_front/tuning.h"
#include "mesh/corners.h"
#include "mesh/quantile.h"
#include "mesh/sort_unique.h"

#include <algorithm>
#include <utility>

namespace pcl::ccaa {

namespace {

/** Whether two stretches of front touch at a vertex. */
bool
hasSeveralFans(const Front& front, pcl::index_t vertex)
{
  std::size_t fans = 0;
  front.forEdgesFrom(vertex, [&](FrontIndex) { ++fans; });
  return fans > 1;
}

} // namespace

LoopClosure::Outcome
LoopClosure::close(FrontIndex edge)
{
  if (!readLoop(edge))
    return Outcome::UNSUPPORTED;
  const std::size_t last = corners_.size() - 1;
  for (const bool obstructions_count : {false, true}) {
    Triangles patch;
    if (triangulate(obstructions_count))
      listTriangles(0, last, patch);
    if (patch.empty() || !isSupported(patch))
      return obstructions_count ? Outcome::OBSTRUCTED : Outcome::UNSUPPORTED;
    if ((obstructions_count || isFree(0, last)) && isSimple(patch)) {
      apply(0, last);
      return Outcome::CLOSED;
    }
  }
  return Outcome::OBSTRUCTED;
}

/** Either every triangle is, or the gap as a whole has little room. */
bool
LoopClosure::isSupported(const Triangles& patch) const
{
  return std::all_of(patch.begin(),
                     patch.end(),
                     [&](const Triangle& t) { return trial_.isSupported(t); }) ||
         room(patch) <= largestRoom();
}

double
LoopClosure::largestRoom() const
{
  return corners_.size() <= tuning::SMALL_LOOP ? tuning::LARGEST_ROOM_OF_SMALL_LOOP
                                               : trial_.largestRoom();
}

/** How far from the edges of the loop a patch gets, in spacings: the radius of the
 * largest disc without samples, as far as centroids and the middles of edges tell. */
double
LoopClosure::room(const Triangles& patch) const
{
  std::vector<double> spacings;
  for (const pcl::index_t corner : corners_)
    spacings.push_back(trial_.spacing(corner));
  double room = 0.0;
  for (const Triangle& triangle : patch) {
    const Corners c = trial_.cornersOf(triangle);
    room = std::max(room, distanceToLoop((c[0] + c[1] + c[2]) / 3.0));
    for (std::size_t i = 0; i < 3; ++i)
      room = std::max(room, distanceToLoop(0.5 * (c[i] + c[(i + 1) % 3])));
  }
  return room / medianOf(std::move(spacings));
}

double
LoopClosure::distanceToLoop(const Position& position) const
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Position& a = surface_.position(corners_[i]);
    const Position& b = surface_.position(corners_[(i + 1) % corners_.size()]);
    const double along =
        std::clamp((position - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    least = std::min(least, (a + along * (b - a) - position).norm());
  }
  return least;
}

/** New triangles run through the front edges backwards, so that is the order in which
 * the corners are listed: behind_[i] lies on the edge from corner i + 1 to corner i. */
bool
LoopClosure::readLoop(FrontIndex edge)
{
  corners_.clear();
  behind_.clear();
  FrontIndex i = edge;
  do {
    const FrontEdge& e = surface_.front()[i];
    corners_.push_back(e.to);
    behind_.push_back(unitNormal(trial_.cornersOf({e.from, e.to, e.apex})));
    i = e.previous;
  }
  while (i != edge && i != FrontEdge::NONE && corners_.size() <= tuning::LONGEST_LOOP);
  return i == edge && corners_.size() >= 3 &&
         std::all_of(corners_.begin(), corners_.end(), [&](pcl::index_t corner) {
           return trial_.isOpenPoint(corner);
         });
}

bool
LoopClosure::triangulate(bool obstructions_count)
{
  obstructions_count_ = obstructions_count;
  const std::size_t n = corners_.size();
  cells_.assign(n * n, {});
  for (std::size_t i = 0; i + 1 < n; ++i)
    cell(i, i + 1).weight = {-1.0, 0.0};
  for (std::size_t span = 2; span < n; ++span)
    for (std::size_t i = 0; i + span < n; ++i)
      fillCell(i, i + span);
  return cell(0, n - 1).apex >= 0;
}

/** What crosses the surface is found only for what would be better. */
void
LoopClosure::fillCell(std::size_t i, std::size_t j)
{
  if (obstructions_count_ && !takesDiagonal(i, j))
    return;
  Cell& best = cell(i, j);
  for (std::size_t m = i + 1; m < j; ++m) {
    const Weight weight = weigh(i, m, j);
    if (weight < best.weight &&
        !(obstructions_count_ &&
          trial_.crossesSurface({corners_[i], corners_[m], corners_[j]}))) {
      best.weight = weight;
      best.apex = static_cast<int>(m);
    }
  }
}

/** Whether nothing is in the way of what a cell stands for. */
bool
LoopClosure::isFree(std::size_t i, std::size_t j)
{
  if (j == i + 1)
    return true;
  const auto m = static_cast<std::size_t>(cell(i, j).apex);
  return takesDiagonal(i, j) &&
         !trial_.crossesSurface({corners_[i], corners_[m], corners_[j]}) &&
         isFree(i, m) && isFree(m, j);
}

/** Whether a diagonal is no edge of the surface yet. */
bool
LoopClosure::takesDiagonal(std::size_t i, std::size_t j) const
{
  return (i == 0 && j + 1 == corners_.size()) ||
         (corners_[i] != corners_[j] && !surface_.hasEdge(corners_[i], corners_[j]));
}

LoopClosure::Weight
LoopClosure::weigh(std::size_t i, std::size_t m, std::size_t j)
{
  const Weight &left = cell(i, m).weight, &right = cell(m, j).weight;
  if (!(left.fold <= 1.0) || !(right.fold <= 1.0))
    return {};
  const Triangle triangle{corners_[i], corners_[m], corners_[j]};
  const Position area = areaNormal(trial_.cornersOf(triangle));
  const Position normal = area.normalized();
  Weight weight{std::max(left.fold, right.fold),
                left.area + right.area + 0.5 * area.norm()};
  weight.fold = std::max(weight.fold, -normal.dot(normalAcross(i, m)));
  weight.fold = std::max(weight.fold, -normal.dot(normalAcross(m, j)));
  if (i == 0 && j + 1 == corners_.size())
    weight.fold = std::max(weight.fold, -normal.dot(behind_.back()));
  return weight;
}

Position
LoopClosure::normalAcross(std::size_t i, std::size_t j)
{
  if (j == i + 1)
    return behind_[i];
  const auto m = static_cast<std::size_t>(cell(i, j).apex);
  return unitNormal(trial_.cornersOf({corners_[i], corners_[m], corners_[j]}));
}

void
LoopClosure::listTriangles(std::size_t i, std::size_t j, Triangles& patch)
{
  if (j == i + 1)
    return;
  const auto m = static_cast<std::size_t>(cell(i, j).apex);
  patch.push_back({corners_[i], corners_[m], corners_[j]});
  listTriangles(i, m, patch);
  listTriangles(m, j, patch);
}

/** A loop that passes a vertex twice might give the same edge twice. */
bool
LoopClosure::isSimple(const Triangles& patch) const
{
  std::vector<std::array<pcl::index_t, 2>> edges;
  for (const Triangle& t : patch)
    for (std::size_t i = 0; i < 3; ++i)
      edges.push_back({t[i], t[(i + 1) % 3]});
  std::sort(edges.begin(), edges.end());
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end())
    return false;
  for (std::size_t i = 0; i < patch.size(); ++i)
    for (std::size_t j = i + 1; j < patch.size(); ++j)
      if (trianglesMeet(trial_.cornersOf(patch[i]), trial_.cornersOf(patch[j])))
        return false;
  return true;
}

/** The front holds the edge from corner i to corner j; the triangle behind it in the
 * patch advances it, the rest follows on the two new edges. */
void
LoopClosure::apply(std::size_t i, std::size_t j)
{
  if (j == i + 1)
    return;
  const auto m = static_cast<std::size_t>(cell(i, j).apex);
  surface_.advance(surface_.front().find(corners_[i], corners_[j]), corners_[m]);
  apply(i, m);
  apply(m, j);
}

std::vector<pcl::index_t>
closeLoops(GrowingSurface& surface, TriangleTrial& trial, RunControl* control)
{
  LoopClosure closure(surface, trial);
  const Front& front = surface.front();
  std::vector<pcl::index_t> obstructed;
  for (pcl::index_t vertex = 0; trial.isOpenPoint(vertex); ++vertex)
    if (hasSeveralFans(front, vertex)) // also if each of them is closed now
      obstructed.push_back(vertex);
  std::vector<std::uint8_t> seen(front.size(), 0);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto edge = static_cast<FrontIndex>(i);
    if (!front[edge].alive || seen[i] != 0)
      continue;
    for (FrontIndex j = edge;
         j != FrontEdge::NONE && seen[static_cast<std::size_t>(j)] == 0;
         j = front[j].next)
      seen[static_cast<std::size_t>(j)] = 1;
    const LoopClosure::Outcome outcome = closure.close(edge);
    if (!spend(control, closure.work()))
      break;
    if (outcome == LoopClosure::Outcome::OBSTRUCTED)
      obstructed.insert(
          obstructed.end(), closure.corners().begin(), closure.corners().end());
  }
  sortUnique(obstructed);
  return obstructed;
}

} // namespace pcl::ccaa
