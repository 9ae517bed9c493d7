// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: numbering vertices by their first appearance.
#include "mesh/vertex_numbering.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <utility>

namespace pcl::ccaa {
namespace {

/** Triangles ahead whose points are fetched: their places in memory are random. */
constexpr std::size_t LOOK_AHEAD = 16;

inline void
prefetch(const void* address)
{
#if defined(__GNUC__) || defined(__clang__)
  __builtin_prefetch(address, 1);
#else
  (void)address;
#endif
}

/** \brief Fetch what belongs to the points of a triangle some way ahead. */
template <typename Item>
inline void
lookAhead(const Triangles& triangles,
          std::size_t current,
          std::size_t end,
          const std::vector<Item>& of_points)
{
  if (current + LOOK_AHEAD < end)
    for (const auto point : triangles[current + LOOK_AHEAD])
      prefetch(&of_points[static_cast<std::size_t>(point)]);
}

/** \brief Numbering by several threads at once.
 *
 * Every point has a ticket. First each block of triangles claims the points it holds,
 * and the lowest block wins, which is where the point appears first. Then it is known
 * how many points each block has won, so each can number its own, beginning where the
 * blocks before it end. */
class ParallelNumbering {
public:
  ParallelNumbering(std::size_t point_count,
                    const LoopContext& context,
                    Triangles& triangles)
  : context_(context)
  , triangles_(triangles)
  , tickets_(point_count)
  , won_(context.blockCount(triangles.size()))
  {}

  std::vector<pcl::index_t>
  run()
  {
    const std::size_t count = triangles_.size();
    const auto claim_block =
        [this](std::size_t block, std::size_t begin, std::size_t end) {
          claim(static_cast<Ticket>(block), begin, end);
        };
    if (!forEachBlock(count, context_, claim_block))
      return {};
    std::vector<pcl::index_t> starts;
    pcl::index_t total = 0;
    for (const auto& won : won_) {
      starts.push_back(total);
      total += won.load(std::memory_order_relaxed);
    }
    point_of_vertex_.resize(static_cast<std::size_t>(total));
    const auto number_block =
        [&](std::size_t block, std::size_t begin, std::size_t end) {
          number(static_cast<Ticket>(block), starts[block], begin, end);
        };
    const auto translate_block = [this](std::size_t,
                                        std::size_t begin,
                                        std::size_t end) { translate(begin, end); };
    if (!forEachBlock(count, context_, number_block) ||
        !forEachBlock(count, context_, translate_block))
      return {};
    return std::move(point_of_vertex_);
  }

private:
  /** 0: nobody's; from FIRST_CLAIM downwards: claimed by block 0, 1 and so on; with
   * NUMBERED: the number. So a claim wins when it is the higher ticket. */
  using Ticket = std::uint32_t;
  static constexpr Ticket NUMBERED = 0x80000000u;
  static constexpr Ticket FIRST_CLAIM = NUMBERED - 1u;

  std::atomic<Ticket>&
  ticketOf(pcl::index_t point)
  {
    return tickets_[static_cast<std::size_t>(point)];
  }

  void
  claim(Ticket block, std::size_t begin, std::size_t end)
  {
    const Ticket claim = FIRST_CLAIM - block;
    pcl::index_t won = 0;
    for (std::size_t i = begin; i < end; ++i) {
      lookAhead(triangles_, i, end, tickets_);
      for (const auto point : triangles_[i]) {
        auto& ticket = ticketOf(point);
        Ticket holder = ticket.load(std::memory_order_relaxed);
        while (holder < claim && !ticket.compare_exchange_weak(
                                     holder, claim, std::memory_order_relaxed)) {
        }
        if (holder >= claim)
          continue;
        ++won;
        if (holder != 0)
          won_[FIRST_CLAIM - holder].fetch_sub(1, std::memory_order_relaxed);
      }
    }
    won_[block].fetch_add(won, std::memory_order_relaxed);
  }

  void
  number(Ticket block, pcl::index_t next, std::size_t begin, std::size_t end)
  {
    const Ticket claim = FIRST_CLAIM - block;
    for (std::size_t i = begin; i < end; ++i) {
      lookAhead(triangles_, i, end, tickets_);
      for (auto& corner : triangles_[i]) {
        auto& ticket = ticketOf(corner);
        Ticket holder = ticket.load(std::memory_order_relaxed);
        if (holder == claim) {
          point_of_vertex_[static_cast<std::size_t>(next)] = corner;
          holder = NUMBERED | static_cast<Ticket>(next++);
          ticket.store(holder, std::memory_order_relaxed);
        }
        // an earlier block may not have come to its points yet: left to translate()
        corner = (holder & NUMBERED) != 0 ? static_cast<pcl::index_t>(holder ^ NUMBERED)
                                          : ~corner;
      }
    }
  }

  void
  translate(std::size_t begin, std::size_t end)
  {
    for (std::size_t i = begin; i < end; ++i)
      for (auto& corner : triangles_[i])
        if (corner < 0)
          corner = static_cast<pcl::index_t>(
              ticketOf(~corner).load(std::memory_order_relaxed) ^ NUMBERED);
  }

  const LoopContext& context_;
  Triangles& triangles_;
  std::vector<std::atomic<Ticket>> tickets_;
  std::vector<std::atomic<pcl::index_t>> won_;
  std::vector<pcl::index_t> point_of_vertex_;
};

/** \brief The plain way, which does with one pass what threads need three for. */
std::vector<pcl::index_t>
numberInOrder(std::size_t point_count, const LoopContext& context, Triangles& triangles)
{
  std::vector<pcl::index_t> vertex_of_point(point_count, -1);
  std::vector<pcl::index_t> point_of_vertex;
  point_of_vertex.reserve(std::min(point_count, 3 * triangles.size()));
  const auto number = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      lookAhead(triangles, i, end, vertex_of_point);
      for (auto& corner : triangles[i]) {
        auto& vertex = vertex_of_point[static_cast<std::size_t>(corner)];
        if (vertex < 0) {
          vertex = static_cast<pcl::index_t>(point_of_vertex.size());
          point_of_vertex.push_back(corner);
        }
        corner = vertex;
      }
    }
  };
  forEachBlock(triangles.size(), context, number);
  return point_of_vertex;
}

} // namespace

std::vector<pcl::index_t>
numberVertices(std::size_t point_count,
               const LoopContext& context,
               Triangles& triangles)
{
  return context.threads > 1 ? ParallelNumbering(point_count, context, triangles).run()
                             : numberInOrder(point_count, context, triangles);
}

} // namespace pcl::ccaa
