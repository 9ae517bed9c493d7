// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: edges of a coarse patch are flipped where it runs through
// itself.

#include "fairing/crossing_flips.h"

#include "fairing/patch_bending.h"
#include "mesh/box_tree.h"
#include "mesh/intersection.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pcl::repair {

namespace {

/** Rounds over what runs into something. Five were the most that flipped anything. */
constexpr int MOST_ROUNDS = 10;
/** Of a length: what bends less by that is as good. */
constexpr double SAME_BENDING = 1e-9;
/** Boxes that are looked at in an operation. */
constexpr std::size_t LOOKED_AT_ONCE = 4;

class CrossingFlips {
public:
  CrossingFlips(const IncompleteModel& model,
                std::vector<std::size_t> crossing,
                const std::function<bool(const ccaa::Corners&)>& obstructed,
                Patch& patch,
                ccaa::RunControl* control)
  : crossing_(std::move(crossing))
  , obstructed_(obstructed)
  , patch_(patch)
  , control_(control)
  , edges_(model, patch)
  , bending_(model, patch, edges_)
  {
    for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
      bending_.note(t);
      boxes_.push_back(ccaa::boxOf(cornersAt(t)));
    }
  }

  void
  run()
  {
    for (int round = 0; round < MOST_ROUNDS && flipOnce(); ++round) {
      std::sort(crossing_.begin(), crossing_.end());
      crossing_.erase(std::unique(crossing_.begin(), crossing_.end()), crossing_.end());
    }
  }

private:
  bool
  flipOnce();
  bool
  isBetterFlipped(std::size_t side) const;
  std::size_t
  meetings(const ccaa::Corners& corners, const std::array<std::size_t, 2>& old) const;

  ccaa::Corners
  cornersAt(std::size_t triangle) const
  {
    return ccaa::cornersOf(patch_.triangles[triangle], patch_.positions);
  }

  std::vector<std::size_t> crossing_; /**< triangles that may run into something */
  const std::function<bool(const ccaa::Corners&)>& obstructed_;
  Patch& patch_;
  ccaa::RunControl* control_;
  PatchEdges edges_;
  PatchBending bending_;
  std::vector<ccaa::Box> boxes_; /**< of the triangles */
};

/** \return whether anything was flipped */
bool
CrossingFlips::flipOnce()
{
  bool has_flipped = false;
  for (std::size_t i = 0; i < crossing_.size(); ++i)
    for (std::size_t side = 3 * crossing_[i]; side < 3 * crossing_[i] + 3; ++side) {
      if (!edges_.isInner(side) || !isBetterFlipped(side))
        continue;
      const std::size_t beyond = edges_.across(side) / 3;
      edges_.flip(side);
      for (const std::size_t triangle : {side / 3, beyond}) {
        bending_.note(triangle);
        boxes_[triangle] = ccaa::boxOf(cornersAt(triangle));
      }
      crossing_.push_back(beyond);
      has_flipped = true;
    }
  return has_flipped;
}

bool
CrossingFlips::isBetterFlipped(std::size_t side) const
{
  const auto [a, b, c, d] = edges_.pairAt(side);
  const auto at = [&](std::size_t vertex) { return patch_.positions[vertex]; };
  const ccaa::Corners one = {at(d), at(c), at(b)};
  const ccaa::Corners other = {at(c), at(d), at(a)};
  if (c == d || edges_.areJoined(c, d) || edges_.areJoinedInModel(c, d) ||
      ccaa::isCollinear(one) || ccaa::isCollinear(other))
    return false;
  const std::array<std::size_t, 2> pair = {side / 3, edges_.across(side) / 3};
  const std::size_t now =
      meetings(cornersAt(pair[0]), pair) + meetings(cornersAt(pair[1]), pair);
  if (now == 0)
    return false;
  const std::size_t then = meetings(one, pair) + meetings(other, pair);
  return then < now ||
         (then == now && bending_.ofFlipped(side) <
                             bending_.of({pair[0], pair[1]}) * (1.0 - SAME_BENDING));
}

/** Triangles that one runs into, those that it replaces left out; the model is one. */
std::size_t
CrossingFlips::meetings(const ccaa::Corners& corners,
                        const std::array<std::size_t, 2>& old) const
{
  if (!ccaa::spend(control_, boxes_.size() / LOOKED_AT_ONCE))
    return 0;
  const ccaa::Box box = ccaa::boxOf(corners);
  std::size_t count = obstructed_(corners) ? 1 : 0;
  for (std::size_t t = 0; t < boxes_.size(); ++t)
    if (boxes_[t].intersects(box) && t != old[0] && t != old[1] &&
        ccaa::trianglesMeet(corners, cornersAt(t)))
      ++count;
  return count;
}

} // namespace

void
flipCrossings(const IncompleteModel& model,
              std::vector<std::size_t> crossing,
              const std::function<bool(const ccaa::Corners&)>& obstructed,
              Patch& patch,
              ccaa::RunControl* control)
{
  if (!crossing.empty())
    CrossingFlips(model, std::move(crossing), obstructed, patch, control).run();
}

} // namespace pcl::repair
