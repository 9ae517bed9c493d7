// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the greedy start on ranked points (thesis 3.3).
#include "greedy/greedy_triangulation.h"

#include "greedy/block_schedule.h"
#include "greedy/candidate_edges.h"
#include "greedy/edge_certificate.h"
#include "greedy/edge_compatibility.h"
#include "greedy/length_buckets.h"
#include "greedy/waiting_edges.h"
#include "mesh/block_loop.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <vector>

namespace pcl::ccaa {
namespace {

/** What one task did; added up afterwards. */
struct EdgeCounts {
  std::array<std::size_t, 5> by_verdict{};

  void
  operator+=(const EdgeCounts& other)
  {
    for (std::size_t v = 0; v < by_verdict.size(); ++v)
      by_verdict[v] += other.by_verdict[v];
  }
};

std::size_t
lowestRank(const Triangle& triangle)
{
  return static_cast<std::size_t>(std::min({triangle[0], triangle[1], triangle[2]}));
}

/** Counting sort of the triangles of a block by their lowest ranks.
 * \param[in] first first rank of the block
 * \param[out] sorted as many places as there are triangles */
void
sortByLowestRank(const Triangles& triangles, std::size_t first, Triangle* sorted)
{
  std::array<std::uint32_t, BlockSchedule::BLOCK + 1> place{};
  for (const Triangle& triangle : triangles)
    ++place[lowestRank(triangle) - first + 1];
  for (std::size_t rank = 0; rank < BlockSchedule::BLOCK; ++rank)
    place[rank + 1] += place[rank];
  for (const Triangle& triangle : triangles)
    sorted[place[lowestRank(triangle) - first]++] = triangle;
}

/** One run of the greedy start. */
class Run {
public:
  Run(const RankedPoints& points,
      const NeighborRows& neighbors,
      const ScanLines& lines,
      const GreedyParameters& parameters,
      int threads,
      RunControl& control)
  : points_(points)
  , neighbors_(neighbors)
  , parameters_(parameters)
  , reach_in_lines_(reachInLines(lines, parameters.length_factor))
  , threads_(threads)
  , control_(control)
  , schedule_(points.size())
  , votes_(points.size())
  , joined_(points, {threads})
  , limits_{AngleLimit::fromRadians(parameters.certified_minimum_angle),
            AngleLimit::fromRadians(parameters.certified_minimum_angle),
            AngleLimit::fromRadians(parameters.minimum_angle)}
  {}

  /** The method: vote, add the certified edges, then try what is left. */
  bool
  execute()
  {
    if (!vote())
      return false;
    const CandidateEdges candidates(points_, neighbors_, votes_);
    if (parameters_.certificates && !certifiedPass(candidates))
      return false;
    if (!parameters_.certificates || parameters_.second_pass)
      return plainPass(candidates);
    return true;
  }

  /** All triangles in the order of their lowest ranks: whoever works on the mesh finds
   * neighbors near each other in memory. */
  Triangles
  takeTriangles()
  {
    // The first level of the first pass left a part for each block; the rest is little.
    std::vector<Triangles> of_block(
        std::make_move_iterator(made_.begin()),
        std::make_move_iterator(made_.begin() +
                                std::ptrdiff_t(schedule_.blockCount())));
    for (std::size_t part = schedule_.blockCount(); part < made_.size(); ++part)
      for (const Triangle& triangle : made_[part])
        of_block[lowestRank(triangle) >> BlockSchedule::BLOCK_BITS].push_back(triangle);
    std::vector<std::size_t> starts(1, 0);
    for (const Triangles& block : of_block)
      starts.push_back(starts.back() + block.size());
    Triangles all(starts.back());
    forEachBlock(of_block.size(),
                 loop("second pass", 1),
                 [&](std::size_t block, std::size_t, std::size_t) {
                   sortByLowestRank(of_block[block],
                                    schedule_.begin(0, block),
                                    all.data() + starts[block]);
                 });
    return all;
  }

  const EdgeCounts&
  counts() const
  {
    return counts_;
  }

private:
  LoopContext
  loop(const char* stage, std::size_t block_size) const
  {
    return {threads_, &control_, stage, block_size};
  }

  bool
  vote()
  {
    return forEachBlock(points_.size(),
                        loop("edges", BlockSchedule::BLOCK),
                        [&](std::size_t, std::size_t first, std::size_t last) {
                          voteFor(first, last);
                        });
  }

  double
  reachAt(std::size_t rank) const
  {
    return reach_in_lines_ > parameters_.length_factor &&
                   isInLine(points_, neighbors_, static_cast<index_t>(rank))
               ? reach_in_lines_
               : parameters_.length_factor;
  }

  /** For ranks in a row whose edges may be equally long at a time. */
  void
  voteFor(std::size_t first, std::size_t last)
  {
    while (first < last) {
      const double reach = reachAt(first);
      std::size_t end = first + 1;
      while (end < last && reachAt(end) == reach)
        ++end;
      certifyEdges(
          points_, neighbors_, static_cast<float>(reach), first, end, &votes_[first]);
      first = end;
    }
  }

  /** No edge has been added before, so an insertion touches only points that edges of
   * its level or lower ones join to it: groups of the level can find and insert their
   * edges at the same time. */
  bool
  certifiedPass(const CandidateEdges& candidates)
  {
    const char* stage = "edges";
    WaitingEdges waiting(schedule_);
    const bool done = level(stage, 0, [&](std::size_t block, EdgeQueue& queue) {
      queue.by_standing.front().reserve(4 * BlockSchedule::BLOCK); // 3 a point and some
      const auto add = [&](const CandidateEdge& edge, EdgeStanding standing) {
        const unsigned int level = BlockSchedule::levelOf(edge.a, edge.b);
        if (level == 0)
          queue.add(edge, standing);
        else
          waiting.add(block, edge, level, standing);
      };
      for (std::size_t r = schedule_.begin(0, block); r < schedule_.end(0, block); ++r)
        candidates.forCertified(static_cast<index_t>(r), add);
      waiting.close(block);
    });
    return done && insertWaiting(stage, 1, waiting);
  }

  /** All candidates between points whose umbrella is open. They are found before the
   * first of them is added: an answer that changed on the way would depend on the
   * schedule. */
  bool
  plainPass(const CandidateEdges& candidates)
  {
    const char* stage = "second pass";
    WaitingEdges waiting(schedule_);
    std::vector<char> open(points_.size());
    const auto settle = [&](std::size_t, std::size_t first, std::size_t last) {
      for (std::size_t rank = first; rank < last; ++rank)
        open[rank] = !joined_.isClosed(static_cast<index_t>(rank));
    };
    const auto find = [&](std::size_t block, std::size_t first, std::size_t last) {
      for (std::size_t rank = first; rank < last; ++rank)
        if (open[rank])
          findPlain(candidates, open, static_cast<index_t>(rank), block, waiting);
      waiting.close(block);
    };
    const LoopContext blocks = loop(stage, BlockSchedule::BLOCK);
    return forEachBlock(points_.size(), blocks, settle) &&
           forEachBlock(points_.size(), blocks, find) &&
           insertWaiting(stage, 0, waiting);
  }

  void
  findPlain(const CandidateEdges& candidates,
            const std::vector<char>& open,
            index_t a,
            std::size_t block,
            WaitingEdges& waiting) const
  {
    candidates.forPlain(
        a,
        [&](index_t b) {
          return open[static_cast<std::size_t>(b)] && !joined_.areJoined(a, b);
        },
        [&](const CandidateEdge& edge, EdgeStanding standing) {
          waiting.add(block, edge, levelOfInsertion(edge), standing);
        });
  }

  /** The lowest level with a group that holds all points an insertion touches: the ends
   * and whoever is joined to both, which may lie in another block than they. */
  unsigned int
  levelOfInsertion(const CandidateEdge& edge) const
  {
    unsigned int level = BlockSchedule::levelOf(edge.a, edge.b);
    joined_.forCommonNeighbors(edge.a, edge.b, [&](index_t c) {
      level = std::max(level, BlockSchedule::levelOf(edge.a, c));
    });
    return level;
  }

  /** Insert what waits, from a level upwards. */
  bool
  insertWaiting(const char* stage, unsigned int from, const WaitingEdges& waiting)
  {
    bool done = true;
    for (unsigned int l = from; done && l < schedule_.levels(); ++l)
      done = level(stage, l, [&](std::size_t group, EdgeQueue& queue) {
        waiting.collect(l, group, queue);
      });
    return done;
  }

  /** Work off the groups of one level; fill(group, queue) names the edges of a group.
   */
  template <typename Fill>
  bool
  level(const char* stage, unsigned int l, Fill fill)
  {
    const std::size_t groups = schedule_.groupCount(l);
    std::vector<Triangles> made(groups);
    std::vector<EdgeCounts> counts(groups);
    const bool done = forEachBlock(
        groups, loop(stage, 1), [&](std::size_t group, std::size_t, std::size_t) {
          EdgeQueue queue;
          fill(group, queue);
          insert(queue, made[group], counts[group]);
        });
    for (const EdgeCounts& part : counts)
      counts_ += part;
    std::move(made.begin(), made.end(), std::back_inserter(made_));
    return done;
  }

  /** Shortest first within each standing. */
  void
  insert(EdgeQueue& queue, Triangles& made, EdgeCounts& counts)
  {
    LengthBuckets buckets;
    for (std::size_t s = 0; s < queue.by_standing.size(); ++s) {
      buckets.sort(queue.by_standing[s]);
      for (const CandidateEdge& edge : queue.by_standing[s]) {
        const EdgeVerdict verdict = joined_.join(edge.a, edge.b, limits_[s], made);
        ++counts.by_verdict[static_cast<std::size_t>(verdict)];
      }
    }
  }

  const RankedPoints& points_;
  const NeighborRows& neighbors_;
  const GreedyParameters& parameters_;
  const double reach_in_lines_; /**< longest edge in local spacings */
  const int threads_;
  RunControl& control_;
  const BlockSchedule schedule_;
  std::vector<EdgeVotes> votes_;
  JoinedEdges joined_;
  const std::array<AngleLimit, 3> limits_; /**< by EdgeStanding */
  std::vector<Triangles> made_;
  EdgeCounts counts_;
};

} // namespace

Triangles
greedyTriangulation(const RankedPoints& points,
                    const NeighborRows& neighbors,
                    const ScanLines& lines,
                    const GreedyParameters& parameters,
                    int threads,
                    RunControl& control,
                    GreedyReport& report)
{
  Run run(points, neighbors, lines, parameters, threads, control);
  if (!run.execute())
    return {};
  const auto count = [&run](EdgeVerdict verdict) {
    return run.counts().by_verdict[static_cast<std::size_t>(verdict)];
  };
  report.joined_edges = count(EdgeVerdict::JOINED);
  report.refused_overfull = count(EdgeVerdict::OVERFULL);
  report.refused_tetrahedron = count(EdgeVerdict::TETRAHEDRON);
  report.refused_angle = count(EdgeVerdict::SMALL_ANGLE);
  report.candidate_edges = report.joined_edges + report.refused_overfull +
                           report.refused_tetrahedron + report.refused_angle;
  Triangles triangles = run.takeTriangles();
  if (control.cancelled())
    return {};
  report.triangles = triangles.size();
  return triangles;
}

} // namespace pcl::ccaa
