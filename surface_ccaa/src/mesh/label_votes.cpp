// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: joins labels of which votes tell whether they are the same.
#include "mesh/label_votes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace pcl::ccaa {
namespace {

std::size_t
at(pcl::index_t label)
{
  return static_cast<std::size_t>(label);
}

/** What is told between sets, of their lowest labels: each two once, ascending. */
std::vector<LabelVote>
betweenSets(std::vector<LabelVote> votes, LabelSets& sets)
{
  std::size_t count = 0;
  for (const LabelVote& vote : votes) {
    const pcl::index_t one = sets.find(2 * vote.labels[0]);
    const pcl::index_t other = sets.find(2 * vote.labels[1]);
    if (one / 2 != other / 2)
      votes[count++] = {{std::min(one, other) / 2, std::max(one, other) / 2},
                        (one ^ other) % 2 != 0 ? -vote.votes : vote.votes};
  }
  votes.resize(count);
  std::stable_sort(votes.begin(), votes.end(), [](const auto& a, const auto& b) {
    return a.labels < b.labels;
  });
  count = 0;
  for (const LabelVote& vote : votes)
    if (count > 0 && votes[count - 1].labels == vote.labels)
      votes[count - 1].votes += vote.votes;
    else
      votes[count++] = vote;
  votes.resize(count);
  return votes;
}

void
join(const LabelVote& vote, LabelSets& sets)
{
  sets.join(2 * vote.labels[0], 2 * vote.labels[1] + (vote.votes < 0.0 ? 1 : 0));
}

/** All at the same time. */
void
joinEachWithClearest(const std::vector<LabelVote>& votes, LabelSets& sets)
{
  constexpr std::size_t NONE = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> clearest(sets.size(), NONE);
  for (std::size_t i = 0; i < votes.size(); ++i)
    for (const pcl::index_t label : votes[i].labels)
      if (std::size_t& most = clearest[at(label)];
          most == NONE || std::abs(votes[i].votes) > std::abs(votes[most].votes))
        most = i;
  for (std::size_t i = 0; i < votes.size(); ++i)
    if (clearest[at(votes[i].labels[0])] == i || clearest[at(votes[i].labels[1])] == i)
      join(votes[i], sets);
}

/** Operations for joining two sets, or finding that this is no longer to be done. */
constexpr std::uint64_t CONTRACTING_WORK = 100;

/** Joins two sets at a time. */
class VoteContraction {
public:
  /** \param[in] votes as betweenSets() returns them */
  VoteContraction(const std::vector<LabelVote>& votes, LabelSets& sets)
  : sets_(sets), beside_(sets.size())
  {
    votes_.reserve(votes.size());
    for (const LabelVote& vote : votes)
      add(vote.labels[0], vote.labels[1], vote.votes);
  }

  void
  run(RunControl* control)
  {
    while (!clearest_.empty() && spend(control, CONTRACTING_WORK)) {
      const Proposal top = clearest_.top();
      clearest_.pop();
      auto [one, other] = top.labels;
      const auto now = votes_.find(pairOf(one, other));
      if (now == votes_.end() || now->second != top.votes)
        continue; // one of them is gone, or more is told of them
      votes_.erase(now);
      join(top, sets_);
      if (beside_[at(one)].size() < beside_[at(other)].size())
        std::swap(one, other);
      takeOver(one, other, top.votes < 0.0);
    }
  }

private:
  struct Proposal : LabelVote {
    bool
    operator<(const Proposal& other) const
    {
      return std::make_tuple(std::abs(votes), other.labels) <
             std::make_tuple(std::abs(other.votes), labels);
    }
  };

  static std::uint64_t
  pairOf(pcl::index_t one, pcl::index_t other)
  {
    return static_cast<std::uint64_t>(std::min(one, other)) << 32 |
           static_cast<std::uint64_t>(std::max(one, other));
  }

  void
  add(pcl::index_t one, pcl::index_t other, double votes)
  {
    double& sum = votes_.emplace(pairOf(one, other), 0.0).first->second;
    sum += votes;
    beside_[at(one)].push_back(other);
    beside_[at(other)].push_back(one);
    clearest_.push({{{std::min(one, other), std::max(one, other)}, sum}});
  }

  /** What is told of a set that goes is told of the one that stays. */
  void
  takeOver(pcl::index_t stays, pcl::index_t goes, bool is_turned)
  {
    for (const pcl::index_t next : std::exchange(beside_[at(goes)], {})) {
      const auto told = votes_.find(pairOf(goes, next));
      if (told == votes_.end())
        continue;
      const double votes = told->second;
      votes_.erase(told);
      add(stays, next, is_turned ? -votes : votes);
    }
  }

  LabelSets& sets_;
  std::unordered_map<std::uint64_t, double> votes_; /**< between two */
  std::vector<std::vector<pcl::index_t>> beside_;   /**< of each, some of them gone */
  std::priority_queue<Proposal> clearest_;
};

} // namespace

void
joinClearest(std::vector<LabelVote> votes, LabelSets& sets, RunControl* control)
{
  votes = betweenSets(std::move(votes), sets);
  joinEachWithClearest(votes, sets);
  VoteContraction(betweenSets(std::move(votes), sets), sets).run(control);
}

} // namespace pcl::ccaa
