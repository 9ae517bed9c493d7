// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: whether samples tell the surface that was lost.

#include "region/sample_evidence.h"

#include "field/float_tree.h"
#include "mesh/corners.h"

#include <algorithm>
#include <map>
#include <utility>

namespace pcl::repair {

namespace {

// What samples have to be like: webs over the stray points of depth jumps made up 11 to
// 18 % of the area of range maps before.

/** Longest edge between samples of one surface, in their median spacing. */
constexpr double LONGEST_AT_SAMPLES = 3.0;
/** Share of the area at samples that longer edges may have. */
constexpr double MOST_EMPTY = 0.2;
/** Share of the length of edges at samples that may be sharper than a right angle: 0.09
 * at most on 66 lost limbs, hands and noise among them, 0.12 at least on most strays.
 */
constexpr double MOST_FOLDED = 0.1;
/** Spacing of the sparsest tenth of samples, in that of the densest tenth. */
constexpr double MOST_UNEVEN = 4.0;
/** The same where they cover the surface by their own spacing: hands are sampled more
 * densely than arms. 5.8 at most on those limbs, 7.5 at least on most strays. */
constexpr double MOST_UNEVEN_COVERED = 6.0;
/** Share of the area that edges longer than by their own spacing may have then: 0.33 at
 * most on such limbs, 0.47 on a range map's strays. */
constexpr double MOST_EMPTY_OF_OWN = 0.4;
/** Share of a rim that they come close to. */
constexpr double LEAST_NEAR = 0.5;

/** Distances of samples to their third neighbours among them. */
std::vector<double>
spacingsOf(const Positions& samples, const FloatTree& tree)
{
  std::vector<double> spacings;
  for (const Position& sample : samples) {
    const auto nearest = tree.nearest(sample, SPACING_NEIGHBOUR + 1);
    spacings.push_back(
        (samples[static_cast<std::size_t>(nearest.back())] - sample).norm());
  }
  return spacings;
}

/** Share of the area at samples that triangles with longer edges have.
 * \param[in] spacing_at a sample; of those of a triangle the largest counts */
template <typename SpacingAt>
double
emptyShare(const Patch& patch, const SpacingAt& spacing_at)
{
  double area = 0.0, empty = 0.0;
  for (const Triangle& triangle : patch.triangles) {
    double spacing = 0.0;
    for (const pcl::index_t corner : triangle)
      if (const std::size_t sample = patch.free_point[static_cast<std::size_t>(corner)];
          sample != NONE)
        spacing = std::max(spacing, spacing_at(sample));
    if (spacing == 0.0)
      continue;
    const ccaa::Corners corners = ccaa::cornersOf(triangle, patch.positions);
    const double own = ccaa::areaNormal(corners).norm();
    area += own;
    const double longest = LONGEST_AT_SAMPLES * spacing;
    if ((corners[1] - corners[0]).norm() > longest ||
        (corners[2] - corners[1]).norm() > longest ||
        (corners[0] - corners[2]).norm() > longest)
      empty += own;
  }
  return area > 0.0 ? empty / area : 0.0;
}

/** Share of the length of inner edges at samples where the patch is folded sharper than
 * by a right angle. */
double
foldedShare(const Patch& patch)
{
  std::map<std::pair<pcl::index_t, pcl::index_t>, Eigen::Vector3d> normals; // by side
  double length = 0.0, folded = 0.0;
  for (const Triangle& triangle : patch.triangles) {
    const Eigen::Vector3d normal =
        ccaa::unitNormal(ccaa::cornersOf(triangle, patch.positions));
    for (std::size_t c = 0; c < 3; ++c) {
      const pcl::index_t from = triangle[c], to = triangle[(c + 1) % 3];
      const auto a = static_cast<std::size_t>(from), b = static_cast<std::size_t>(to);
      if (patch.free_point[a] == NONE && patch.free_point[b] == NONE)
        continue;
      const auto beyond = normals.find({to, from});
      normals.emplace(std::make_pair(from, to), normal);
      if (beyond == normals.end())
        continue;
      const double own = (patch.positions[a] - patch.positions[b]).norm();
      length += own;
      folded += normal.dot(beyond->second) < 0.0 ? own : 0.0;
    }
  }
  return length > 0.0 ? folded / length : 0.0;
}

/** Share of the vertices of the rim that have a sample so near. */
double
nearShare(const Patch& patch,
          const Positions& samples,
          const FloatTree& tree,
          double near)
{
  const auto count = std::count_if(
      patch.positions.begin(),
      patch.positions.begin() + static_cast<std::ptrdiff_t>(patch.rim.size()),
      [&](const Position& vertex) {
        const auto nearest = static_cast<std::size_t>(tree.nearest(vertex, 1).front());
        return (samples[nearest] - vertex).norm() <= near;
      });
  return static_cast<double>(count) / static_cast<double>(patch.rim.size());
}

} // namespace

bool
samplesDescribe(const Positions& free_points,
                const std::vector<std::size_t>& places,
                const Patch& patch)
{
  Positions samples;
  for (const std::size_t place : places)
    samples.push_back(free_points[place]);
  const FloatTree tree(samples);
  std::vector<double> spacings = spacingsOf(samples, tree);
  std::map<std::size_t, double> own; // of a free point
  for (std::size_t i = 0; i < places.size(); ++i)
    own[places[i]] = spacings[i];
  std::sort(spacings.begin(), spacings.end());
  const double median = spacings[spacings.size() / 2];
  if (emptyShare(patch, [median](std::size_t) { return median; }) <= MOST_EMPTY)
    return true;
  const double sparse = spacings[spacings.size() * 9 / 10];
  const double dense = spacings[spacings.size() / 10];
  const auto own_spacing = [&own](std::size_t sample) { return own.at(sample); };
  const double most_uneven = emptyShare(patch, own_spacing) <= MOST_EMPTY_OF_OWN
                                 ? MOST_UNEVEN_COVERED
                                 : MOST_UNEVEN;
  return sparse <= most_uneven * dense && foldedShare(patch) <= MOST_FOLDED &&
         nearShare(patch, samples, tree, LONGEST_AT_SAMPLES * median) >= LEAST_NEAR;
}

} // namespace pcl::repair
