// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: counts that tell the topology of a mesh.
#include "mesh_topology.h"

#include "edge_sets.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace pcl::ccaa::test {
namespace {

/** The roots of all elements, numbered by their first element. */
std::vector<std::size_t>
numbersOf(Sets& sets, std::size_t count)
{
  std::vector<std::size_t> numbers(count);
  std::map<std::size_t, std::size_t> number_of;
  for (std::size_t i = 0; i < count; ++i)
    numbers[i] = number_of.emplace(sets.find(i), number_of.size()).first->second;
  return numbers;
}

/** Connected parts of the edges that have one triangle. */
std::size_t
countBorders(const std::map<Edge, std::vector<std::size_t>>& triangles_of)
{
  std::map<index_t, std::size_t> number_of;
  std::vector<Edge> border;
  for (const auto& [edge, triangles] : triangles_of) {
    if (triangles.size() != 1)
      continue;
    border.push_back(edge);
    for (const index_t vertex : {edge.first, edge.second})
      number_of.emplace(vertex, number_of.size());
  }
  Sets sets(number_of.size());
  for (const Edge& edge : border)
    sets.join(number_of[edge.first], number_of[edge.second]);
  std::set<std::size_t> roots;
  for (std::size_t i = 0; i < number_of.size(); ++i)
    roots.insert(sets.find(i));
  return roots.size();
}

/** The triangles at one vertex that are not in its largest fan. */
void
markSmallFans(const Triangles& triangles,
              const std::vector<std::size_t>& around,
              std::vector<char>& marked)
{
  std::map<Edge, std::size_t> first_with;
  Sets fans(around.size());
  for (std::size_t i = 0; i < around.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [found, is_new] =
          first_with.emplace(edgeOf(triangles[around[i]], k), i);
      if (!is_new)
        fans.join(found->second, i);
    }
  std::map<std::size_t, std::size_t> sizes;
  for (std::size_t i = 0; i < around.size(); ++i)
    ++sizes[fans.find(i)];
  const auto largest =
      std::max_element(sizes.begin(), sizes.end(), [](const auto& a, const auto& b) {
        return a.second < b.second;
      });
  for (std::size_t i = 0; i < around.size(); ++i)
    if (fans.find(i) != largest->first)
      marked[around[i]] = 1;
}

/** \return whether there was any. */
bool
takeAway(const std::vector<char>& marked, Triangles& triangles)
{
  Triangles rest;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (marked[t] == 0)
      rest.push_back(triangles[t]);
  const bool changed = rest.size() < triangles.size();
  triangles = std::move(rest);
  return changed;
}

bool
takeSmallFans(Triangles& triangles)
{
  std::map<index_t, std::vector<std::size_t>> around;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (const index_t corner : triangles[t])
      around[corner].push_back(t);
  std::vector<char> marked(triangles.size(), 0);
  for (const auto& [vertex, fan] : around)
    markSmallFans(triangles, fan, marked);
  return takeAway(marked, triangles);
}

bool
takeSmallComponents(std::size_t fewest, Triangles& triangles)
{
  const std::vector<std::size_t> component = componentOfTriangles(triangles);
  std::map<std::size_t, std::size_t> sizes;
  for (const std::size_t c : component)
    ++sizes[c];
  std::vector<char> marked(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    marked[t] = sizes[component[t]] < fewest ? 1 : 0;
  return takeAway(marked, triangles);
}

/** The lowest corner first, the winding kept. */
Triangle
turned(Triangle triangle)
{
  std::rotate(triangle.begin(),
              std::min_element(triangle.begin(), triangle.end()),
              triangle.end());
  return triangle;
}

} // namespace

std::vector<std::size_t>
componentOfTriangles(const Triangles& triangles)
{
  Sets sets(triangles.size());
  for (const auto& [edge, both] : trianglesOfEdges(triangles))
    for (const std::size_t t : both)
      sets.join(both.front(), t);
  return numbersOf(sets, triangles.size());
}

Topology
topologyOf(const Triangles& triangles)
{
  Topology topology;
  std::set<index_t> vertices;
  for (const Triangle& triangle : triangles)
    vertices.insert(triangle.begin(), triangle.end());
  const auto triangles_of = trianglesOfEdges(triangles);
  topology.characteristic = static_cast<long>(vertices.size()) -
                            static_cast<long>(triangles_of.size()) +
                            static_cast<long>(triangles.size());
  topology.borders = countBorders(triangles_of);
  for (const std::size_t component : componentOfTriangles(triangles))
    topology.components = std::max(topology.components, component + 1);
  return topology;
}

Triangles
manifoldPart(Triangles triangles, std::size_t fewest)
{
  bool changed = true;
  while (changed) {
    changed = takeSmallFans(triangles);
    changed = takeSmallComponents(fewest, triangles) || changed;
  }
  return triangles;
}

std::size_t
countMissing(const Triangles& part, const Triangles& whole)
{
  std::vector<Triangle> sorted;
  sorted.reserve(whole.size());
  for (const Triangle& triangle : whole)
    sorted.push_back(turned(triangle));
  std::sort(sorted.begin(), sorted.end());
  return static_cast<std::size_t>(
      std::count_if(part.begin(), part.end(), [&](const Triangle& triangle) {
        return !std::binary_search(sorted.begin(), sorted.end(), turned(triangle));
      }));
}

} // namespace pcl::ccaa::test
