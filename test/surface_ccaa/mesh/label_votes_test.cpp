// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: labels that are joined as votes tell.
#include <gtest/gtest.h>

#include "mesh/label_votes.h"
#include "support/random_source.h"

#include <algorithm>
#include <cmath>

namespace pcl::ccaa::test {
namespace {

/** Whether each label is turned against the first one, of those that are joined. */
std::vector<bool>
turnedBy(std::vector<LabelVote> votes, std::size_t count)
{
  LabelSets sets;
  for (std::size_t i = 0; i < count; ++i)
    sets.add();
  joinClearest(std::move(votes), sets);
  std::vector<bool> turned;
  for (std::size_t i = 0; i < count; ++i) {
    const index_t state = sets.find(2 * static_cast<index_t>(i));
    EXPECT_LT(state, 2) << i << " is not joined";
    turned.push_back((state & 1) != 0);
  }
  return turned;
}

TEST(LabelVotes, TurnLabelsAsTheyTell)
{
  EXPECT_EQ(turnedBy({{{0, 1}, 2.0}, {{2, 0}, -1.0}, {{2, 3}, -1.0}}, 4),
            (std::vector<bool>{false, false, true, false}));
}

TEST(LabelVotes, OfNothingLabelsAreAlike)
{
  EXPECT_EQ(turnedBy({{{0, 1}, 0.0}}, 2), (std::vector<bool>{false, false}));
}

TEST(LabelVotes, ThoseOfTheSameTwoLabelsAddUp)
{
  EXPECT_EQ(turnedBy({{{0, 1}, 2.0}, {{1, 0}, -1.5}, {{0, 1}, -1.5}}, 2),
            (std::vector<bool>{false, true}));
}

TEST(LabelVotes, TheClearerOnesCount)
{
  EXPECT_EQ(turnedBy({{{0, 1}, 3.0}, {{1, 2}, 2.0}, {{0, 2}, -1.0}}, 3),
            (std::vector<bool>{false, false, false}));
}

/** Two triples that are clear in themselves: one vote between them is clearer than each
 * of two others, but not than both. */
TEST(LabelVotes, ThoseBetweenSetsThatHaveGrownAddUp)
{
  EXPECT_EQ(turnedBy({{{0, 1}, 9.0},
                      {{1, 2}, 9.0},
                      {{3, 4}, 9.0},
                      {{4, 5}, 9.0},
                      {{0, 3}, 3.0},
                      {{1, 4}, -2.0},
                      {{2, 5}, -2.0}},
                     6),
            (std::vector<bool>{false, false, false, true, true, true}));
}

/** A lattice of labels of which some are turned, with votes between neighbors of which
 * a share is wrong. */
struct Lattice {
  static constexpr index_t SIDE = 40;
  std::vector<bool> turned;
  std::vector<LabelVote> votes;

  Lattice(std::uint64_t seed, double wrong)
  {
    RandomSource random(seed);
    for (index_t i = 0; i < SIDE * SIDE; ++i)
      turned.push_back(i > 0 && random.uniform() < 0.5);
    for (index_t y = 0; y < SIDE; ++y)
      for (index_t x = 0; x < SIDE; ++x) {
        const index_t i = y * SIDE + x;
        for (const index_t other :
             {x + 1 < SIDE ? i + 1 : i, (i + SIDE) % (SIDE * SIDE)})
          if (other != i) {
            const bool agree = turned[std::size_t(i)] == turned[std::size_t(other)];
            const double weight = std::floor(random.uniform(1.0, 20.0));
            votes.push_back(
                {{i, other}, agree == (random.uniform() > wrong) ? weight : -weight});
          }
      }
  }

  /** Sum of the votes that do not suit. */
  double
  disappointed(const std::vector<bool>& by) const
  {
    double sum = 0.0;
    for (const LabelVote& vote : votes)
      if (const bool agree =
              by[std::size_t(vote.labels[0])] == by[std::size_t(vote.labels[1])];
          agree != (vote.votes > 0.0))
        sum += std::abs(vote.votes);
    return sum;
  }
};

/** If the clearest vote came first, whatever the others tell, it would be 1.5 to 1.8.
 */
TEST(LabelVotes, HardlyMoreAreDisappointedThanThatAreWrong)
{
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Lattice lattice(seed, 0.05);
    EXPECT_LT(lattice.disappointed(turnedBy(lattice.votes, lattice.turned.size())),
              1.3 * lattice.disappointed(lattice.turned))
        << seed;
  }
}

TEST(LabelVotes, TellTheSameInAnyOrder)
{
  Lattice lattice(1, 0.2);
  const std::vector<bool> found = turnedBy(lattice.votes, lattice.turned.size());
  std::reverse(lattice.votes.begin(), lattice.votes.end());
  for (LabelVote& vote : lattice.votes)
    std::swap(vote.labels[0], vote.labels[1]);
  EXPECT_EQ(turnedBy(lattice.votes, lattice.turned.size()), found);
}

} // namespace
} // namespace pcl::ccaa::test
