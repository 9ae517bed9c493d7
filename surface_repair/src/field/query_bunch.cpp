// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: neighbouring field queries that share a search.
#include "field/query_bunch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cassert>
#include <limits>

namespace pcl::repair {
namespace {

/** \brief Most queries of a bunch. */
constexpr std::size_t BUNCH_SIZE = 32;

/** \brief A bunch is no wider than this share of L_2, or its search finds too much. */
constexpr double BUNCH_WIDTH = 0.75;

/** \brief Radius of the search for a line, in L_2; it is made anew once it is so many
 * times what a query needs. */
constexpr double ALONG = 1.5;
constexpr double TOO_WIDE = 4.0;

/** \brief Whether the same sources count for both, apart from L_2. */
bool
heedAlike(const FieldQuery& a, const FieldQuery& b)
{
  return a.silent_island == b.silent_island &&
         a.effective.has_value() == b.effective.has_value() &&
         (!a.effective || a.effective->curve == b.effective->curve);
}

} // namespace

bool
canBeAnswered(const FieldQuery& query)
{
  return query.falloff.far > 0.0 && query.position.allFinite();
}

std::size_t
bunchFrom(const FieldQuery* first, const FieldQuery* last)
{
  Eigen::AlignedBox3d box(first->position);
  double far = first->falloff.far;
  std::size_t count = 1;
  for (; first + count != last && count < BUNCH_SIZE; ++count) {
    const FieldQuery& query = first[count];
    box.extend(query.position);
    far = std::min(far, query.falloff.far);
    if (!canBeAnswered(query) || !heedAlike(*first, query) ||
        !(box.diagonal().norm() <= BUNCH_WIDTH * far))
      break;
  }
  return count;
}

void
BunchCandidates::find(const SourceBlocks& blocks,
                      const FieldQuery* first,
                      const FieldQuery* last)
{
  Eigen::AlignedBox3d box;
  double far = 0.0;
  for (const FieldQuery* query = first; query != last; ++query)
    if (canBeAnswered(*query)) {
      box.extend(query->position);
      far = std::max(far, query->falloff.far);
    }
  if (box.isEmpty())
    return;
  search(blocks,
         {blocks.toFrame(box.center()),
          (far + 0.5 * box.diagonal().norm()) * blocks.scale()},
         *first);
}

void
BunchCandidates::findAlong(const SourceBlocks& blocks, const FieldQuery& query)
{
  if (!canBeAnswered(query))
    return;
  const Position place = blocks.toFrame(query.position);
  const double far = query.falloff.far * blocks.scale();
  if (known_blocks_ != blocks.number() || !heedAlike(known_query_, query) ||
      (place - known_place_.center).norm() + far > known_place_.radius ||
      known_place_.radius > TOO_WIDE * far)
    search(blocks, {place, ALONG * far}, query);
}

void
BunchCandidates::search(const SourceBlocks& blocks,
                        const Ball& place,
                        const FieldQuery& query)
{
  known_blocks_ = blocks.number();
  known_query_ = query;
  known_place_ = place;
  blocks.near(place, found_);
  gather(blocks, query);
}

void
BunchCandidates::gather(const SourceBlocks& blocks, const FieldQuery& query)
{
  assert((!query.effective || query.effective->curve < blocks.curveCount()) &&
         "no curve of the sources");
  groups_.clear();
  for (std::vector<double>& row : center_)
    row.clear();
  radius_.clear();
  blocks_.clear();
  for (const std::uint32_t number : found_) {
    const SourceBlocks::Group& group = blocks.group(number);
    const std::uint32_t first = group.blocks.begin;
    const bool silent =
        query.silent_island != NONE && blocks.island(first) == query.silent_island;
    if (!silent &&
        (!query.effective || query.effective->curve == blocks.curveOf(first)))
      add(blocks, group);
  }
}

void
BunchCandidates::add(const SourceBlocks& blocks, const SourceBlocks::Group& group)
{
  const Position& center = group.ball.center;
  groups_.push_back({{center[0], center[1], center[2]},
                     group.ball.radius,
                     group.coarse_from,
                     group.coarse});
  for (std::uint32_t b = group.blocks.begin; b < group.blocks.end; ++b) {
    const Ball& ball = blocks.ball(b);
    for (std::size_t k = 0; k < 3; ++k)
      center_[k].push_back(ball.center[static_cast<Eigen::Index>(k)]);
    radius_.push_back(ball.radius);
    blocks_.push_back(b);
  }
  while (blocks_.size() % field_kernel::LANES != 0) {
    for (std::vector<double>& row : center_)
      row.push_back(std::numeric_limits<double>::infinity());
    radius_.push_back(0.0);
    blocks_.push_back(0);
  }
}

field_kernel::Candidates
BunchCandidates::view() const
{
  return {groups_.data(),
          groups_.size(),
          {center_[0].data(), center_[1].data(), center_[2].data()},
          radius_.data(),
          blocks_.data()};
}

} // namespace pcl::repair
