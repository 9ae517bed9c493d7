// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which algorithm of a chain has made which triangle.
#include "consecutive/provenance.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace pcl::ccaa {
namespace {

/** \brief The same for all ways to write a triangle: its corners in ascending order. */
Triangle
cornerSet(Triangle sorted)
{
  if (sorted[0] > sorted[1])
    std::swap(sorted[0], sorted[1]);
  if (sorted[1] > sorted[2])
    std::swap(sorted[1], sorted[2]);
  if (sorted[0] > sorted[1])
    std::swap(sorted[0], sorted[1]);
  return sorted;
}

bool
hasSameCorners(const Triangle& first, const Triangle& second)
{
  // Mostly nothing was turned, or the second and third corner were exchanged.
  if (first[0] == second[0])
    return (first[1] == second[1] && first[2] == second[2]) ||
           (first[1] == second[2] && first[2] == second[1]);
  return cornerSet(first) == cornerSet(second);
}

struct CornerSetHash {
  std::size_t
  operator()(const Triangle& corners) const
  {
    std::uint64_t hash = 0;
    for (const pcl::index_t corner : corners)
      hash = (hash ^ static_cast<std::uint32_t>(corner)) * 0x9e3779b97f4a7c15U +
             (hash >> 29);
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }
};

/** \brief For a filter that keeps the order: each survivor is looked for behind the one
 * before. \return fewer labels than survivors when one was not found there */
TriangleLabels
labelsInOrder(const Triangles& given,
              const TriangleLabels& labels,
              const Triangles& survivors)
{
  TriangleLabels found;
  found.reserve(survivors.size());
  std::size_t place = 0;
  for (const Triangle& survivor : survivors) {
    while (place < given.size() && !hasSameCorners(given[place], survivor))
      ++place;
    if (place == given.size())
      break;
    found.push_back(labels[place++]);
  }
  return found;
}

/** \brief For a filter that gives another order. */
std::optional<TriangleLabels>
labelsByLookup(const Triangles& given,
               const TriangleLabels& labels,
               const Triangles& survivors)
{
  // Of several equal triangles the last label is the next one to be taken.
  std::unordered_map<Triangle, TriangleLabels, CornerSetHash> labels_of;
  for (std::size_t i = given.size(); i-- > 0;)
    labels_of[cornerSet(given[i])].push_back(labels[i]);
  TriangleLabels found;
  found.reserve(survivors.size());
  for (const Triangle& survivor : survivors) {
    const auto place = labels_of.find(cornerSet(survivor));
    if (place == labels_of.end() || place->second.empty())
      return std::nullopt;
    found.push_back(place->second.back());
    place->second.pop_back();
  }
  return found;
}

/** \brief Ascending, and below a count. */
bool
areNumbersOf(const std::vector<pcl::index_t>& numbers, std::size_t count)
{
  pcl::index_t last = -1;
  for (const pcl::index_t number : numbers) {
    if (number <= last || static_cast<std::size_t>(number) >= count)
      return false;
    last = number;
  }
  return true;
}

} // namespace

bool
keepsTriangles(const Triangles& given,
               const std::vector<pcl::index_t>* kept,
               const Triangles& result,
               const LoopContext& context)
{
  const std::size_t count = kept != nullptr ? kept->size() : given.size();
  if (result.size() < count || (kept != nullptr && !areNumbersOf(*kept, given.size())))
    return false;
  std::vector<std::uint8_t> same(context.blockCount(count), 0);
  const auto compare = [&](std::size_t block, std::size_t begin, std::size_t end) {
    bool all = true;
    for (std::size_t i = begin; i < end; ++i) {
      const auto number = kept != nullptr ? static_cast<std::size_t>((*kept)[i]) : i;
      all = all && hasSameCorners(given[number], result[i]);
    }
    same[block] = all ? 1 : 0;
  };
  return forEachBlock(count, context, compare) &&
         std::find(same.begin(), same.end(), 0) == same.end();
}

std::optional<TriangleLabels>
labelsOfSurvivors(const Triangles& given,
                  const TriangleLabels& labels,
                  const Triangles& survivors)
{
  TriangleLabels found = labelsInOrder(given, labels, survivors);
  if (found.size() == survivors.size())
    return found;
  return labelsByLookup(given, labels, survivors);
}

void
appendNewTriangles(const Triangles& made,
                   std::uint8_t label,
                   Triangles& triangles,
                   TriangleLabels& labels)
{
  std::unordered_set<Triangle, CornerSetHash> known(triangles.size() + made.size());
  for (const Triangle& triangle : triangles)
    known.insert(cornerSet(triangle));
  for (const Triangle& triangle : made)
    if (known.insert(cornerSet(triangle)).second) {
      triangles.push_back(triangle);
      labels.push_back(label);
    }
}

} // namespace pcl::ccaa
