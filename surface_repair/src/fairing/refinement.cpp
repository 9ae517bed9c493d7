// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: new vertices until a patch is as dense as what is around.

#include "fairing/refinement.h"

#include "fairing/edge_flips.h"
#include "fairing/patch_edges.h"
#include "fairing/sizing_field.h"
#include "fairing/vertex_spacing.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::repair {

namespace {

/** Halves nearer to the sizing field than the whole was: sqrt(2). */
constexpr double LONGEST = 1.4142135623730951;
/** Bound of the passes, each of which halves what is too long. */
constexpr std::size_t MOST_PASSES = 32;
/** Part of the vertices by which the last pass adds fewer. The edges that are left are
 * hardly too long, and where borders are narrow there are always some. */
constexpr double LAST_SHARE = 0.01;
/** Edges are not halved where a corner of their triangles is as near to the middle, in
 * wanted lengths, unless they are this much too long: what crowds has room nowhere. */
constexpr double CROWDED = 0.35;
constexpr double FAR_TOO_LONG = 2.0;
/** Sweeps that carry wanted lengths from the rim into the patch, and those that carry
 * them on to the vertices of a pass. */
constexpr std::size_t FIRST_SWEEPS = 200;
constexpr std::size_t SWEEPS_A_PASS = 4;
/** Times that vertices are spaced and edges flipped once no edge is halved any more. */
constexpr std::size_t SPACING_PASSES = 5;
/** Operations of a pass for each triangle, but for lengths, flips and spacing. */
constexpr std::size_t PASS_WORK = 3;

class Refinement {
public:
  Refinement(const IncompleteModel& model,
             const RefinementParameters& parameters,
             Patch& patch,
             bool keeps_shape,
             ccaa::RunControl* control)
  : parameters_(parameters)
  , patch_(patch)
  , keeps_shape_(keeps_shape)
  , control_(control)
  , edges_(model, patch)
  , lengths_(sizingField(model, patch, FIRST_SWEEPS, control))
  , given_(patch.positions.size())
  {}

  void
  run()
  {
    splitChords();
    for (std::size_t pass = 0; pass < MOST_PASSES && spendPass(); ++pass) {
      flip();
      const std::size_t before = patch_.positions.size();
      splitLongEdges();
      if (patch_.positions.size() == before)
        break;
      interpolateLengths(patch_, SWEEPS_A_PASS, lengths_, control_);
      flip();
      spaceVertices(given_, lengths_, patch_, keeps_shape_, control_);
      if (static_cast<double>(patch_.positions.size() - before) <
          LAST_SHARE * static_cast<double>(before))
        break;
    }
    for (std::size_t pass = 0; pass < SPACING_PASSES && hasNewVertices() && spendPass();
         ++pass) {
      spaceVertices(given_, lengths_, patch_, keeps_shape_, control_);
      flip();
    }
  }

private:
  bool
  spendPass()
  {
    return ccaa::spend(control_, PASS_WORK * patch_.triangles.size());
  }

  void
  flip()
  {
    flipToDelaunay(patch_, edges_, keeps_shape_, control_);
  }

  bool
  hasNewVertices() const
  {
    return patch_.positions.size() > given_;
  }
  bool
  isFull() const
  {
    return patch_.positions.size() - given_ >= parameters_.greatest_number;
  }

  /** Edges within the patch that the model has too must go, however short. */
  void
  splitChords()
  {
    const std::size_t sides = edges_.count();
    for (std::size_t side = 0; side < sides; ++side)
      if (edges_.speaks(side) &&
          edges_.areJoinedInModel(edges_.from(side), edges_.to(side)))
        split(side);
  }

  double
  lengthOf(std::size_t side) const
  {
    return (patch_.positions[edges_.from(side)] - patch_.positions[edges_.to(side)])
        .norm();
  }

  /** By the sizing field, or else by the border of the triangles at the edge: that
   * stays, and no vertex beside it would make the edge shorter. */
  double
  wantedLength(std::size_t side) const
  {
    double wanted = 0.5 * (lengths_[edges_.from(side)] + lengths_[edges_.to(side)]) *
                    parameters_.edge_length;
    for (const std::size_t triangle : {side / 3, edges_.across(side) / 3})
      for (std::size_t other = 3 * triangle; other < 3 * triangle + 3; ++other)
        if (!edges_.isInner(other))
          wanted = std::max(wanted, lengthOf(other));
    return wanted;
  }

  bool
  isTooLong(double length, double wanted, std::size_t side) const
  {
    if (!(length > LONGEST * wanted))
      return false;
    const PatchEdges::Pair pair = edges_.pairAt(side);
    const Position middle = 0.5 * (patch_.positions[pair.a] + patch_.positions[pair.b]);
    const auto is_near = [&](std::size_t apex) {
      return (patch_.positions[apex] - middle).norm() < CROWDED * wanted;
    };
    return length > FAR_TOO_LONG * wanted || (!is_near(pair.c) && !is_near(pair.d));
  }

  /** The longest for what is wanted first; each triangle once. */
  void
  splitLongEdges()
  {
    std::vector<std::pair<double, std::size_t>> found;
    for (std::size_t side = 0; side < edges_.count(); ++side) {
      if (!edges_.speaks(side))
        continue;
      const double length = lengthOf(side), wanted = wantedLength(side);
      if (isTooLong(length, wanted, side))
        found.emplace_back(-length / wanted, side);
    }
    std::sort(found.begin(), found.end());
    std::vector<char> touched(edges_.count() / 3 + 2 * found.size(), 0);
    for (const auto& [length, side] : found) {
      const std::size_t one = side / 3, other = edges_.across(side) / 3;
      if (isFull() || touched[one] != 0 || touched[other] != 0)
        continue;
      touched[one] = touched[other] = 1;
      for (const std::size_t born : {edges_.count() / 3, edges_.count() / 3 + 1})
        touched[born] = 1;
      split(side);
    }
  }

  void
  split(std::size_t side)
  {
    const std::size_t a = edges_.from(side), b = edges_.to(side);
    const std::size_t middle =
        edges_.split(side, 0.5 * (patch_.positions[a] + patch_.positions[b]));
    if (patch_.isCrease(a, b)) {
      patch_.creases.erase({std::min(a, b), std::max(a, b)});
      patch_.addCrease(a, middle);
      patch_.addCrease(middle, b);
    }
    lengths_.push_back(std::sqrt(lengths_[a] * lengths_[b]));
  }

  const RefinementParameters& parameters_;
  Patch& patch_;
  bool keeps_shape_;
  ccaa::RunControl* control_;
  PatchEdges edges_;
  std::vector<double> lengths_;
  std::size_t given_; /**< vertices that were there before */
};

} // namespace

void
refinePatch(const IncompleteModel& model,
            const RefinementParameters& parameters,
            Patch& patch,
            bool keeps_shape,
            ccaa::RunControl* control)
{
  if (patch.triangles.empty() || patch.rim.empty())
    return;
  Refinement(model, parameters, patch, keeps_shape, control).run();
}

} // namespace pcl::repair
