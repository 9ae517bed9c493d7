// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a second try where triangles stood in the way of others.
#include <pcl/surface_ccaa/projection/mending.h>
#include <pcl/surface_ccaa/projection/new_islands.h>
#include <pcl/surface_ccaa/projection/surface_growth.h>

#include <algorithm>
#include <array>

namespace pcl {
namespace ccaa {
namespace {

constexpr int TRIES = 3;
/** Open points beyond which a group is left as it is: growth would take too long for
 * the little that it can win. */
constexpr std::size_t LARGEST_GROUP = 2000;

void
makeUnique(std::vector<pcl::index_t>& numbers)
{
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/** How much is wrong around the first vertices of a mesh: boundary edges, three for an
 * unused point, ten for one where fans touch. */
std::size_t
countFlaws(const Triangles& triangles, std::size_t open_points)
{
  using Edge = std::array<pcl::index_t, 2>;
  const auto is_open = [&](pcl::index_t v) {
    return static_cast<std::size_t>(v) < open_points;
  };
  std::vector<Edge> edges;
  std::vector<std::size_t> used(open_points, 0), borders(open_points, 0);
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      if (is_open(t[i]))
        used[static_cast<std::size_t>(t[i])] = 1;
      if (is_open(t[i]) || is_open(t[(i + 1) % 3]))
        edges.push_back({t[i], t[(i + 1) % 3]});
    }
  std::sort(edges.begin(), edges.end());
  std::size_t flaws = 0;
  for (const Edge& edge : edges)
    if (!std::binary_search(edges.begin(), edges.end(), Edge{edge[1], edge[0]})) {
      ++flaws;
      if (is_open(edge[0]))
        ++borders[static_cast<std::size_t>(edge[0])];
    }
  for (std::size_t v = 0; v < open_points; ++v)
    flaws += (used[v] == 0 ? 3 : 0) + (borders[v] > 1 ? 10 : 0);
  return flaws;
}

} // namespace

bool
Mending::run(const std::vector<pcl::index_t>& obstructed, RunControl* control)
{
  number_in_open_.assign(surface_.vertexCount(), -1);
  for (std::size_t i = 0; i < open_.open_points; ++i)
    number_in_open_[static_cast<std::size_t>(vertices_[i])] =
        static_cast<pcl::index_t>(i);
  std::vector<pcl::index_t> points;
  for (const pcl::index_t point : obstructed)
    points.push_back(vertices_[static_cast<std::size_t>(point)]);
  std::vector<std::vector<pcl::index_t>> all = groups(points);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (control != nullptr &&
        !control->report("mending",
                         static_cast<double>(i) / static_cast<double>(all.size())))
      return false;
    for (int tries = 0; tries < TRIES && !mend(all[i], control); ++tries) {
    }
  }
  return control == nullptr || !control->cancelled();
}

/** Points connected by triangles among them. */
std::vector<std::vector<pcl::index_t>>
Mending::groups(const std::vector<pcl::index_t>& points) const
{
  std::vector<pcl::index_t> waiting = points;
  makeUnique(waiting);
  std::vector<std::uint8_t> taken(waiting.size(), 0);
  std::vector<std::vector<pcl::index_t>> all;
  for (std::size_t seed = 0; seed < waiting.size(); ++seed) {
    if (taken[seed] != 0)
      continue;
    taken[seed] = 1;
    std::vector<pcl::index_t> group{waiting[seed]};
    for (std::size_t i = 0; i < group.size(); ++i)
      surface_.forTrianglesAt(group[i], [&](pcl::index_t t) {
        for (const pcl::index_t corner : surface_[t]) {
          const auto place = std::lower_bound(waiting.begin(), waiting.end(), corner);
          if (place == waiting.end() || *place != corner)
            continue;
          std::uint8_t& mark = taken[static_cast<std::size_t>(place - waiting.begin())];
          if (mark == 0)
            group.push_back(corner);
          mark = 1;
        }
      });
    makeUnique(group);
    all.push_back(std::move(group));
  }
  return all;
}

/** One try. \return whether there is nothing left to try; else \a points has grown by
 * a ring */
bool
Mending::mend(std::vector<pcl::index_t>& points, RunControl* control)
{
  const std::vector<pcl::index_t> removed = removableAt(points);
  std::vector<pcl::index_t> open = points;
  for (const pcl::index_t t : removed)
    open.insert(open.end(), surface_[t].begin(), surface_[t].end());
  addUnusedNear(points, open);
  makeUnique(open);
  if (open.size() > LARGEST_GROUP)
    return true;
  std::vector<pcl::index_t> vertices;
  const std::size_t flaws =
      countFlaws(surface_.openAt(open, {}, vertices).rim, open.size());
  OpenSurface gap = surface_.openAt(open, removed, vertices);
  findNeighborsDirectly(gap, parameters_.neighbors);
  for (const pcl::index_t t : removed)
    surface_.remove(t); // nearby triangles are asked for life
  Attempt best{flaws, {}};
  for (const double smooth_fold : {parameters_.smooth_fold, M_PI}) {
    CompletionParameters parameters = parameters_;
    parameters.smooth_fold = smooth_fold;
    Attempt attempt = growAnew(gap, parameters, control);
    if (attempt.flaws < best.flaws)
      best = std::move(attempt);
    if (best.flaws == 0)
      break;
  }
  for (const pcl::index_t t : removed)
    surface_.restore(t);
  if (control != nullptr && control->cancelled())
    return true;
  if (best.flaws < flaws)
    replace(removed, best.made, vertices);
  points = open;
  return best.flaws == 0;
}

Mending::Attempt
Mending::growAnew(const OpenSurface& gap,
                  const CompletionParameters& parameters,
                  RunControl* control) const
{
  SurfaceGrowth growth(gap, parameters, &nearby_);
  if (!growth.run(control))
    return {};
  Attempt attempt;
  attempt.made = lastingTriangles(
      growth.surface().triangles(), gap.rim.size(), gap.positions, rule_);
  Triangles all = gap.rim;
  all.insert(all.end(), attempt.made.begin(), attempt.made.end());
  attempt.flaws = countFlaws(all, gap.open_points);
  return attempt;
}

std::vector<pcl::index_t>
Mending::removableAt(const std::vector<pcl::index_t>& points) const
{
  std::vector<pcl::index_t> found = surface_.trianglesAt(points);
  if (parameters_.keep_given)
    found.erase(std::remove_if(found.begin(),
                               found.end(),
                               [&](pcl::index_t t) { return surface_.isGiven(t); }),
                found.end());
  return found;
}

void
Mending::addUnusedNear(const std::vector<pcl::index_t>& points,
                       std::vector<pcl::index_t>& open) const
{
  for (const pcl::index_t point : points) {
    const pcl::index_t number = number_in_open_[static_cast<std::size_t>(point)];
    if (number < 0)
      continue;
    for (unsigned int j = 0; j < open_.neighbors.count(number); ++j) {
      const pcl::index_t near =
          vertices_[static_cast<std::size_t>(open_.neighbors.row(number)[j])];
      bool used = false;
      surface_.forTrianglesAt(near, [&](pcl::index_t) { used = true; });
      if (!used)
        open.push_back(near);
    }
  }
}

void
Mending::replace(const std::vector<pcl::index_t>& removed,
                 const Triangles& added,
                 const std::vector<pcl::index_t>& vertices)
{
  for (const pcl::index_t t : removed) {
    surface_.remove(t);
    replaced_given_ += surface_.isGiven(t);
  }
  for (Triangle triangle : added) {
    for (pcl::index_t& corner : triangle)
      corner = vertices[static_cast<std::size_t>(corner)];
    surface_.add(triangle);
  }
}

} // namespace ccaa
} // namespace pcl
