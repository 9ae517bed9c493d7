// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: changes to one surface that are tried side by side.

#pragma once

#include "mesh/block_loop.h"
#include "mesh/box_tree.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <optional>
#include <vector>

namespace pcl::repair {

/** \brief Tries that are looked at together at most, for each thread: more than one, so
 * that few wait for one that takes long. */
constexpr std::size_t TRIES_OF_A_THREAD = 16;

/** \brief Changes to a surface, as if each was tried after the one before was made:
 * some that come next are tried on all threads, then made in order up to the first that
 * has looked where something has changed since, which is tried again. The fewer of them
 * are, the more come next. The same for any number of threads, as far as a try depends
 * on nothing beyond where it looked.
 * \param[in] tryOut(i, context) what change i would be, with a box `seen` where it
 * looked; from several threads, so it changes nothing
 * \param[in] make(i, what it would be) makes it, \return the box of what has changed */
template <typename TryOut, typename Make>
void
makeInTurn(std::size_t count,
           const ccaa::LoopContext& context,
           const TryOut& tryOut,
           const Make& make)
{
  using Try = decltype(tryOut(std::size_t{0}, context));
  ccaa::RunControl part(context.control); // tells no stages
  const auto threads = static_cast<std::size_t>(context.threads);
  const std::size_t most = threads > 1 ? TRIES_OF_A_THREAD * threads : 1;
  std::size_t together = threads, tried_to = 0;
  const ccaa::LoopContext within{count > 1 ? 1 : context.threads, &part};
  std::vector<std::optional<Try>> tries(count);
  std::vector<std::exception_ptr> thrown(count); // none may leave a thread
  for (std::size_t turn = 0; turn < count && !part.cancelled();) {
    const std::size_t end = std::min(count, turn + together);
    tried_to = std::max(tried_to, end);
    const auto try_one = [&](std::size_t k, std::size_t, std::size_t) {
      const std::size_t i = turn + k;
      try {
        if (!tries[i])
          tries[i] = tryOut(i, within);
      }
      catch (...) {
        thrown[i] = std::current_exception();
      }
    };
    ccaa::forEachBlock(
        end - turn, ccaa::LoopContext{context.threads, &part, "", 1}, try_one);
    bool has_wasted = false;
    for (; turn < end && tries[turn] && !part.cancelled(); ++turn) {
      const ccaa::Box changed = make(turn, *tries[turn]);
      for (std::size_t later = turn + 1; later < tried_to; ++later)
        if (tries[later] && tries[later]->seen.intersects(changed)) {
          tries[later].reset();
          has_wasted = true;
        }
    }
    together = has_wasted ? threads : std::min(2 * together, most);
    for (const std::exception_ptr& exception : thrown)
      if (exception)
        std::rethrow_exception(exception);
  }
}

} // namespace pcl::repair
