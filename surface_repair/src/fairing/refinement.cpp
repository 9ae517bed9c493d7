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

namespace pcl {
namespace repair {

namespace {

/** Halves nearer to the sizing field than the whole was: sqrt(2). */
constexpr double LONGEST = 1.4142135623730951;
constexpr std::size_t MOST_PASSES = 64;
constexpr std::size_t FIRST_SWEEPS = 200;
constexpr std::size_t SWEEPS_A_PASS = 4;
constexpr std::size_t SPACING_PASSES = 5;

class Refinement {
public:
  Refinement(const IncompleteModel& model,
             const RefinementParameters& parameters,
             Patch& patch,
             bool keeps_shape)
  : parameters_(parameters)
  , patch_(patch)
  , keeps_shape_(keeps_shape)
  , edges_(model, patch)
  , lengths_(sizingField(model, patch, FIRST_SWEEPS))
  , given_(patch.positions.size())
  {}

  void
  run()
  {
    splitChords();
    for (std::size_t pass = 0; pass < MOST_PASSES; ++pass) {
      flipToDelaunay(patch_, edges_, keeps_shape_);
      if (!splitLongEdges())
        break;
      interpolateLengths(patch_, SWEEPS_A_PASS, lengths_);
      flipToDelaunay(patch_, edges_, keeps_shape_);
      spaceVertices(given_, lengths_, patch_, keeps_shape_);
    }
    for (std::size_t pass = 0; pass < SPACING_PASSES && hasNewVertices(); ++pass) {
      spaceVertices(given_, lengths_, patch_, keeps_shape_);
      flipToDelaunay(patch_, edges_, keeps_shape_);
    }
  }

private:
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

  /** The length of an edge over the sizing field. */
  double
  relativeLength(std::size_t side) const
  {
    const std::size_t a = edges_.from(side), b = edges_.to(side);
    const double wanted = 0.5 * (lengths_[a] + lengths_[b]) * parameters_.edge_length;
    return (patch_.positions[a] - patch_.positions[b]).norm() / wanted;
  }

  /** The longest first; each triangle once. \return whether there was one */
  bool
  splitLongEdges()
  {
    std::vector<std::pair<double, std::size_t>> found;
    for (std::size_t side = 0; side < edges_.count(); ++side)
      if (edges_.speaks(side) && relativeLength(side) > LONGEST)
        found.emplace_back(-relativeLength(side), side);
    std::sort(found.begin(), found.end());
    std::vector<char> touched(edges_.count() / 3 + 2 * found.size(), 0);
    bool any = false;
    for (const auto& [length, side] : found) {
      const std::size_t one = side / 3, other = edges_.across(side) / 3;
      if (isFull() || touched[one] != 0 || touched[other] != 0)
        continue;
      touched[one] = touched[other] = 1;
      for (const std::size_t born : {edges_.count() / 3, edges_.count() / 3 + 1})
        touched[born] = 1;
      split(side);
      any = true;
    }
    return any;
  }

  void
  split(std::size_t side)
  {
    const std::size_t a = edges_.from(side), b = edges_.to(side);
    edges_.split(side, 0.5 * (patch_.positions[a] + patch_.positions[b]));
    lengths_.push_back(std::sqrt(lengths_[a] * lengths_[b]));
  }

  const RefinementParameters& parameters_;
  Patch& patch_;
  bool keeps_shape_;
  PatchEdges edges_;
  std::vector<double> lengths_;
  std::size_t given_; /**< vertices that were there before */
};

} // namespace

void
refinePatch(const IncompleteModel& model,
            const RefinementParameters& parameters,
            Patch& patch,
            bool keeps_shape)
{
  if (patch.triangles.empty() || patch.rim.empty())
    return;
  Refinement(model, parameters, patch, keeps_shape).run();
}

} // namespace repair
} // namespace pcl
