// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: from votes and field integrals to sides (4.48).

#include "orientation/side_decision.h"

#include <algorithm>
#include <cmath>

namespace pcl::repair {

namespace {

/** What the field says about two islands: above 0, their windings fit each other. */
struct Neighbour {
  std::size_t island = 0;
  double attraction = 0.0;
  double magnitude = 0.0;
};

class Decision {
public:
  Decision(const SideEvidence& evidence,
           const OrientationParameters& parameters,
           std::vector<IslandSide>& sides);

  void
  run();

private:
  static constexpr std::size_t STANDARD = 0; /**< group of the islands decided before */
  static constexpr std::size_t NO_GROUP = NONE;

  void
  join(std::size_t island, std::size_t group);
  void
  hear(std::size_t speaker, std::size_t listener, const Neighbour& pair);
  std::size_t
  strongest() const;
  std::size_t
  largestLeft() const;
  std::size_t
  clearest() const;
  double
  together(std::size_t island) const;
  void
  decide(std::size_t island, const IslandSide& side);
  void
  turnGroups();

  double
  sign(std::size_t island) const
  {
    return sides_[island].flipped ? -1.0 : 1.0;
  }

  const SideEvidence& evidence_;
  const OrientationParameters& parameters_;
  std::vector<IslandSide>& sides_;
  std::vector<std::vector<Neighbour>> neighbours_;
  std::vector<std::size_t> group_;
  std::size_t groups_ = 1;
  std::vector<ccaa::SideVotes>
      field_; /**< integrals with the islands that are in a group */
};

Decision::Decision(const SideEvidence& evidence,
                   const OrientationParameters& parameters,
                   std::vector<IslandSide>& sides)
: evidence_(evidence)
, parameters_(parameters)
, sides_(sides)
, neighbours_(sides.size())
, group_(sides.size(), NO_GROUP)
, field_(sides.size())
{
  for (const PairIntegral& pair : evidence.pairs) {
    neighbours_[pair.base].push_back({pair.source, pair.attraction, pair.magnitude});
    neighbours_[pair.source].push_back({pair.base, pair.attraction, pair.magnitude});
  }
}

/** An island that is in a group speaks to its neighbours. */
void
Decision::join(std::size_t island, std::size_t group)
{
  group_[island] = group;
  if (sides_[island].rule == SideRule::ONE_SIDED)
    return; // its boundary has no direction, so it says nothing about others
  for (const Neighbour& neighbour : neighbours_[island])
    hear(island, neighbour.island, neighbour);
}

/** Add what the field of one island says about another. */
void
Decision::hear(std::size_t speaker, std::size_t listener, const Neighbour& pair)
{
  field_[listener].add({pair.attraction, pair.magnitude}, sign(speaker));
}

/** Of the islands about which the field is clear, the one with the greatest integral.
 */
std::size_t
Decision::strongest() const
{
  std::size_t best = NONE;
  double greatest = 0.0;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const double strength = std::abs(field_[i].sum);
    if (group_[i] == NO_GROUP && strength > greatest &&
        std::abs(field_[i].balance()) >= parameters_.clear_field) {
      greatest = strength;
      best = i;
    }
  }
  return best;
}

/** Field and sight together, -2 (turn) to 2 (keep). */
double
Decision::together(std::size_t island) const
{
  const FreeSight& sight = evidence_.sight[island];
  return field_[island].balance() +
         evidence_.sight_trust * sight.weight() * sight.votes.balance();
}

std::size_t
Decision::clearest() const
{
  std::size_t best = NONE;
  double greatest = 0.0;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const double clear = std::abs(together(i));
    if (group_[i] == NO_GROUP && clear > greatest &&
        clear >= parameters_.decided_from) {
      greatest = clear;
      best = i;
    }
  }
  return best;
}

void
Decision::decide(std::size_t island, const IslandSide& side)
{
  sides_[island] = side;
  join(island, groups_ - 1);
}

std::size_t
Decision::largestLeft() const
{
  std::size_t best = NONE;
  for (std::size_t i = 0; i < sides_.size(); ++i)
    if (group_[i] == NO_GROUP &&
        (best == NONE || evidence_.areas[i] > evidence_.areas[best]))
      best = i;
  return best;
}

/** A group without a standard island is turned as a whole if free sight says so. */
void
Decision::turnGroups()
{
  std::vector<ccaa::SideVotes> votes(groups_);
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const FreeSight& sight = evidence_.sight[i];
    votes[group_[i]].add(sight.votes, sign(i) * sight.weight());
  }
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const double balance = evidence_.sight_trust * votes[group_[i]].balance();
    if (group_[i] == STANDARD || std::abs(balance) < parameters_.decided_from)
      continue;
    if (balance < 0.0)
      sides_[i].flipped = !sides_[i].flipped;
    if (sides_[i].rule == SideRule::UNDECIDED)
      sides_[i] = {SideRule::FREE_SIGHT, sides_[i].flipped, std::abs(balance)};
  }
}

void
Decision::run()
{
  for (std::size_t i = 0; i < sides_.size(); ++i)
    if (sides_[i].rule != SideRule::UNDECIDED)
      join(i, STANDARD);
  for (;;) {
    if (const std::size_t next = strongest(); next != NONE) {
      const double balance = field_[next].balance();
      decide(next, {SideRule::FIELD, balance < 0.0, std::abs(balance)});
    }
    else if (const std::size_t unclear = clearest(); unclear != NONE) {
      const double both = together(unclear);
      const bool by_field = std::abs(field_[unclear].balance()) > 0.5 * std::abs(both);
      decide(unclear,
             {by_field ? SideRule::FIELD : SideRule::FREE_SIGHT,
              both < 0.0,
              std::min(1.0, std::abs(both))});
    }
    else if (const std::size_t largest = largestLeft(); largest != NONE)
      join(largest, groups_++);
    else
      break;
  }
  turnGroups();
}

} // namespace

void
decideByField(const SideEvidence& evidence,
              const OrientationParameters& parameters,
              std::vector<IslandSide>& sides)
{
  Decision(evidence, parameters, sides).run();
}

} // namespace pcl::repair
