// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a patch that grows over samples of the missing surface.

#include "fairing/sample_growth.h"

#include "fairing/coarse_patch.h"
#include "fairing/triangle_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::repair {

namespace {

/** What is taken at most. */
constexpr std::size_t MOST_SAMPLES = 4000;
/** Triangles near a sample that may make room for it. */
constexpr std::size_t NEAREST = 12;
/** Triangles that may go for one sample. */
constexpr std::size_t MOST_OPENED = 40;
/** Flips after one sample. */
constexpr std::size_t MOST_FLIPS = 200;
/** Of a length: what bends less by that is as good. */
constexpr double LEAST_GAIN = 1e-9;
/** Operations for a sample besides. */
constexpr std::size_t TAKING_WORK = 5000;

class SampleGrowth {
public:
  SampleGrowth(const Positions& points, CoarsePatch& coarse)
  : points_(points), coarse_(coarse), edges_(coarse.edges), bending_(coarse.bending)
  {}

  /** What finds no room waits until others are in. */
  void
  run(std::vector<std::size_t> samples)
  {
    for (std::size_t before = samples.size() + 1; samples.size() < before;) {
      before = samples.size();
      const auto rest = std::remove_if(
          samples.begin(), samples.end(), [&](auto sample) { return take(sample); });
      samples.erase(rest, samples.end());
    }
  }

private:
  /** Triangles that a sample could replace. */
  struct Disc {
    std::vector<std::size_t> triangles;
    double bending = 0.0; /**< that would come in */
  };

  bool
  take(std::size_t sample);
  std::vector<std::size_t>
  nearestTo(const Position& point) const;
  Disc
  discOf(std::vector<std::size_t> triangles, const Position& point) const;
  Disc
  bestDisc(std::size_t first, const Position& point) const;
  bool
  mayJoin(std::size_t side,
          const std::vector<std::size_t>& border,
          const std::vector<std::size_t>& disc) const;
  bool
  openToward(const Position& point, std::vector<std::size_t>& disc) const;
  void
  flipAround(std::vector<std::size_t> triangles);
  bool
  mayFlip(std::size_t side) const;
  bool
  hasRoom(std::size_t from,
          std::size_t to,
          const Position& apex,
          const std::vector<std::size_t>& old) const;

  const Positions& points_;
  CoarsePatch& coarse_;
  PatchEdges& edges_;
  PatchBending& bending_;
};

/** \return whether the sample is a vertex now */
bool
SampleGrowth::take(std::size_t sample)
{
  if (!ccaa::spend(coarse_.control, TAKING_WORK + coarse_.boxes.size()))
    return false;
  const Position& point = points_[sample];
  std::vector<Disc> discs;
  for (const std::size_t t : nearestTo(point)) {
    const bool is_known = std::any_of(discs.begin(), discs.end(), [t](const Disc& one) {
      return std::find(one.triangles.begin(), one.triangles.end(), t) !=
             one.triangles.end();
    });
    if (!is_known)
      discs.push_back(bestDisc(t, point));
  }
  std::stable_sort(discs.begin(), discs.end(), [](const Disc& a, const Disc& b) {
    return a.bending < b.bending;
  });
  const auto disc = std::find_if(discs.begin(), discs.end(), [&](Disc& one) {
    return openToward(point, one.triangles);
  });
  if (disc == discs.end())
    return false;
  std::vector<std::size_t> changed = disc->triangles;
  coarse_.patch.free_point[edges_.star(disc->triangles, point)] = sample;
  for (std::size_t born = coarse_.boxes.size(); born < coarse_.patch.triangles.size();
       ++born)
    changed.push_back(born);
  for (const std::size_t triangle : changed)
    coarse_.note(triangle);
  flipAround(std::move(changed));
  return true;
}

/** The nearest triangles, nearest first, the lower number among equals. */
std::vector<std::size_t>
SampleGrowth::nearestTo(const Position& point) const
{
  std::vector<std::pair<double, std::size_t>> found; // ascending
  const std::vector<ccaa::Box>& boxes = coarse_.boxes;
  for (std::size_t t = 0; t < boxes.size(); ++t) {
    const bool is_full = found.size() == NEAREST;
    if (is_full && boxes[t].exteriorDistance(point) > found.back().first)
      continue;
    const std::pair<double, std::size_t> place(
        nearestPlace(point, coarse_.cornersAt(t)).distance, t);
    if (is_full && !(place < found.back()))
      continue;
    if (is_full)
      found.pop_back();
    found.insert(std::upper_bound(found.begin(), found.end(), place), place);
  }
  std::vector<std::size_t> nearest;
  for (const auto& [distance, triangle] : found)
    nearest.push_back(triangle);
  return nearest;
}

SampleGrowth::Disc
SampleGrowth::discOf(std::vector<std::size_t> triangles, const Position& point) const
{
  const double bending = bending_.ofStar(triangles, point) - bending_.of(triangles);
  return {std::move(triangles), bending};
}

/** Grown from a triangle as long as the surface becomes less bent by it. */
SampleGrowth::Disc
SampleGrowth::bestDisc(std::size_t first, const Position& point) const
{
  Disc best = discOf({first}, point);
  for (bool grows = true; grows && best.triangles.size() < MOST_OPENED;) {
    grows = false;
    const std::vector<std::size_t> disc = best.triangles;
    const std::vector<std::size_t> border = edges_.borderOf(disc);
    for (const std::size_t side : border) {
      if (!mayJoin(side, border, disc))
        continue;
      std::vector<std::size_t> wider = disc;
      wider.push_back(edges_.across(side) / 3);
      Disc more = discOf(std::move(wider), point);
      if (!(more.bending < best.bending - LEAST_GAIN * std::abs(best.bending)))
        continue;
      best = std::move(more);
      grows = true;
    }
  }
  return best;
}

/** Whether what lies beyond a side of the border may join a disc: its third corner
 * becomes one more of the border. */
bool
SampleGrowth::mayJoin(std::size_t side,
                      const std::vector<std::size_t>& border,
                      const std::vector<std::size_t>& disc) const
{
  if (!edges_.isInner(side))
    return false;
  const std::size_t beyond = edges_.across(side), next = beyond / 3;
  const std::size_t apex = edges_.from(3 * next + (beyond + 2) % 3);
  return coarse_.patch.hole[next] == coarse_.patch.hole[disc.front()] &&
         std::none_of(border.begin(), border.end(), [&](std::size_t other) {
           return edges_.from(other) == apex;
         });
}

/** Let a disc grow over the sides that a point cannot be joined with, as something is
 * in between. \return whether it can be joined with all in the end */
bool
SampleGrowth::openToward(const Position& point, std::vector<std::size_t>& disc) const
{
  while (disc.size() < MOST_OPENED) {
    const std::vector<std::size_t> border = edges_.borderOf(disc);
    const auto hidden = std::find_if(border.begin(), border.end(), [&](auto side) {
      return !hasRoom(edges_.from(side), edges_.to(side), point, disc);
    });
    if (hidden == border.end())
      return true;
    if (!mayJoin(*hidden, border, disc))
      return false;
    disc.push_back(edges_.across(*hidden) / 3);
  }
  return false;
}

void
SampleGrowth::flipAround(std::vector<std::size_t> triangles)
{
  std::size_t left = MOST_FLIPS;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t side = 3 * triangles[i]; side < 3 * triangles[i] + 3; ++side) {
      if (left == 0 || !edges_.isInner(side) || !mayFlip(side))
        continue;
      triangles.push_back(side / 3);
      triangles.push_back(coarse_.flip(side));
      --left;
    }
}

/** Whether the surface is less bent by it, and runs into nothing. */
bool
SampleGrowth::mayFlip(std::size_t side) const
{
  if (!coarse_.canFlip(side))
    return false;
  const auto [a, b, c, d] = edges_.pairAt(side);
  const std::vector<std::size_t> pair = {side / 3, edges_.across(side) / 3};
  return bending_.ofFlipped(side) < bending_.of(pair) * (1.0 - LEAST_GAIN) &&
         coarse_.meetings({coarse_.at(d), coarse_.at(c), coarse_.at(a)}, pair, 1) ==
             0 &&
         coarse_.meetings({coarse_.at(d), coarse_.at(c), coarse_.at(b)}, pair, 1) == 0;
}

/** Whether a triangle runs into nothing, those that it replaces left out. */
bool
SampleGrowth::hasRoom(std::size_t from,
                      std::size_t to,
                      const Position& apex,
                      const std::vector<std::size_t>& old) const
{
  const ccaa::Corners corners = {coarse_.at(from), coarse_.at(to), apex};
  return !ccaa::isCollinear(corners) && coarse_.meetings(corners, old, 1) == 0;
}

} // namespace

void
growOver(const IncompleteModel& model,
         const std::vector<std::size_t>& samples,
         const std::function<bool(const ccaa::Corners&)>& obstructed,
         Patch& patch,
         ccaa::RunControl* control)
{
  const std::size_t step = (samples.size() + MOST_SAMPLES - 1) / MOST_SAMPLES;
  std::vector<std::size_t> taken;
  for (std::size_t i = 0; i < samples.size(); i += step)
    taken.push_back(samples[i]);
  if (patch.triangles.empty() || taken.empty())
    return;
  CoarsePatch coarse(model, obstructed, patch, control);
  SampleGrowth(model.free_points, coarse).run(std::move(taken));
}

} // namespace pcl::repair
