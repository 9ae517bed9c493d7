// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: takes triangles away from a closed surface, by a seed.
#include "seeded_damage.h"

#include "damage/random_numbers.h"

#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace bench {
namespace {

using pcl::repair::Position;

constexpr double FAR = std::numeric_limits<double>::infinity();

/** \brief Distances of vertices along the edges, as far as a limit. */
std::vector<double>
distancesFrom(const ClosedModel& model, std::size_t start, double limit)
{
  using Entry = std::pair<double, std::size_t>;
  std::vector<double> distances(model.positions.size(), FAR);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  distances[start] = 0;
  queue.emplace(0, start);
  while (!queue.empty()) {
    const auto [distance, vertex] = queue.top();
    queue.pop();
    if (distance > distances[vertex])
      continue;
    const auto index = static_cast<pcl::index_t>(vertex);
    for (const auto* t = model.adjacency.begin(index); t != model.adjacency.end(index);
         ++t)
      for (const pcl::index_t corner : model.triangles[static_cast<std::size_t>(*t)]) {
        const auto other = static_cast<std::size_t>(corner);
        const double reached =
            distance + (model.positions[other] - model.positions[vertex]).norm();
        if (reached > limit || reached >= distances[other])
          continue;
        distances[other] = reached;
        queue.emplace(reached, other);
      }
  }
  return distances;
}

/** \brief One patch of damage after the other. */
class Damage {
public:
  Damage(const ClosedModel& model, const DamageOptions& options)
  : model_(model)
  , options_(options)
  , random_(options.seed)
  , removed_(model.triangles.size(), 0)
  {}

  std::vector<char>
  run()
  {
    for (int i = 0; i < options_.patches; ++i) {
      const double share =
          options_.smallest *
          std::pow(options_.largest / options_.smallest, random_.uniform());
      addPatch(static_cast<DamageKind>(random_.below(DAMAGE_KINDS)),
               share * model_.diagonal);
    }
    return std::move(removed_);
  }

private:
  void
  addPatch(DamageKind kind, double radius)
  {
    const std::size_t start = random_.below(model_.positions.size());
    if (kind == DamageKind::BALL)
      removeWhere([&](const Position& p) {
        return (p - model_.positions[start]).norm() < radius;
      });
    else if (kind == DamageKind::CUT)
      cut(radius);
    else
      removeDisc(start, radius, kind);
  }

  /** At least the triangles at the start go, however small the radius. */
  void
  removeDisc(std::size_t start, double radius, DamageKind kind)
  {
    const auto distances = distancesFrom(model_, start, 2 * radius);
    const double keep_within =
        kind == DamageKind::RING ? radius * (0.15 + 0.6 * random_.uniform()) : 0;
    for (std::size_t t = 0; t < removed_.size(); ++t) {
      double distance = 0; // mean over the corners
      for (const pcl::index_t corner : model_.triangles[t])
        distance += distances[static_cast<std::size_t>(corner)] / 3;
      double chance = distance < radius && distance >= keep_within ? 1 : 0;
      if (kind == DamageKind::RAGGED && chance > 0 && distance > radius * 2 / 3)
        chance = 0.6;
      if (chance > 0 && random_.uniform() < chance)
        removed_[t] = 1;
    }
  }

  void
  cut(double depth)
  {
    Position normal(random_.normal(), random_.normal(), random_.normal());
    normal.normalize();
    double highest = -FAR;
    for (const Position& position : model_.positions)
      highest = std::max(highest, normal.dot(position));
    removeWhere([&](const Position& p) { return normal.dot(p) > highest - depth; });
  }

  /** \brief Remove triangles by their centroid. */
  void
  removeWhere(const std::function<bool(const Position&)>& condition)
  {
    for (std::size_t t = 0; t < removed_.size(); ++t) {
      Position sum = Position::Zero();
      for (const pcl::index_t corner : model_.triangles[t])
        sum += model_.positions[static_cast<std::size_t>(corner)];
      if (condition(sum / 3))
        removed_[t] = 1;
    }
  }

  const ClosedModel& model_;
  const DamageOptions& options_;
  app::RandomNumbers random_;
  std::vector<char> removed_;
};

} // namespace

std::vector<char>
damageModel(const ClosedModel& model, const DamageOptions& options)
{
  return Damage(model, options).run();
}

} // namespace bench
