// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: all steps of a run tile by tile in one process.
#include "out_of_core/tile_run.h"

#include "cli/cli.h"
#include "out_of_core/shards.h"
#include "out_of_core/step_file.h"
#include "run/threads.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <filesystem>
#include <mutex>
#include <thread>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace app {
namespace {

/** Large blocks go back to the system as soon as they are freed: glibc would keep those
 * of up to 32 MB, and the largest of ten tiles would take 632 MB, now 562, for 7 % more
 * time.
 */
void
returnLargeBlocks()
{
#ifdef __GLIBC__
  constexpr int LARGE_BLOCK = 1 << 22; // bytes
  mallopt(M_MMAP_THRESHOLD, LARGE_BLOCK);
#endif
}

/** Freed memory goes back to the system before a tile takes its own: cutting 100
 * million points leaves 104 MB, and meshing a hundred tiles, one after the other, up to
 * 130 MB.
 */
void
releaseFreed()
{
#ifdef __GLIBC__
  // With another allocator in place of glibc's (jemalloc, a sanitizer's) the first call
  // sets glibc's up, and two first calls at once crash.
  static std::mutex one_at_a_time;
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  malloc_trim(0);
#endif
}

using Tell = std::function<bool(const char*, double)>;

/** A step of all tiles, and its share of the time, about. */
struct Phase {
  const char* name;
  double weight;
  std::function<void(std::size_t tile, const StepRun& run)> work; /**< empty: once */
  std::function<void()> once;
  std::function<std::vector<std::uint64_t>()> points = {}; /**< empty: the tiles' own */
};

class TileRun {
public:
  TileRun(const TilePlan& plan,
          std::uint64_t memory,
          unsigned int threads,
          const Tell& tell)
  : tiles_(plan.tiling.tiles.size())
  , tell_(tell)
  , memory_(memory)
  , threads_(static_cast<unsigned int>(pcl::ccaa::resolveThreads(threads)))
  {
    for (const pcl::ccaa::Tile& tile : plan.tiling.tiles)
      own_points_.push_back(tile.count);
  }

  void
  run(const std::vector<Phase>& phases)
  {
    double sum = 0.0, done = 0.0;
    for (const Phase& phase : phases)
      sum += phase.weight;
    for (const Phase& phase : phases) {
      if (!tell_(phase.name, done / sum))
        throw Failure(stopped_by_signal);
      if (phase.once)
        phase.once();
      else
        runAll(phase, done / sum, phase.weight / sum);
      done += phase.weight;
    }
  }

private:
  /** Tiles at a time that the memory is enough for. */
  std::uint64_t
  workersFor(const Phase& phase) const
  {
    std::uint64_t most = 1;
    for (const std::uint64_t points : phase.points ? phase.points() : own_points_)
      most = std::max(most, points);
    const std::uint64_t fit = std::max<std::uint64_t>(1, memory_ / (most * TILE_BYTES));
    return std::min({fit, std::uint64_t{threads_}, std::max<std::uint64_t>(1, tiles_)});
  }

  void
  runAll(const Phase& phase, double before, double share)
  {
    const std::uint64_t count = workersFor(phase);
    std::atomic<std::size_t> next{0}, finished{0};
    std::atomic<bool> stop{false};
    std::vector<std::atomic<bool>> is_done(tiles_);
    std::exception_ptr problem;
    std::mutex mutex;
    const auto work = [&] {
      StepRun run;
      run.progress = [&](const std::string&, double) { return !stop.load(); };
      run.wait = [&](std::size_t tile) {
        while (!is_done[tile] && !stop)
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (stop)
          throw Failure(stopped_by_signal);
      };
      try {
        for (std::size_t tile = next++; tile < tiles_ && !stop; tile = next++) {
          releaseFreed();
          const std::uint64_t beside = std::min<std::uint64_t>(count, tiles_ - tile);
          run.threads = static_cast<unsigned int>(threads_ / beside);
          phase.work(tile, run);
          is_done[tile] = true;
          ++finished;
        }
      }
      catch (...) {
        const std::lock_guard<std::mutex> lock(mutex);
        if (!problem)
          problem = std::current_exception();
        stop = true;
      }
    };
    std::vector<std::thread> workers;
    for (std::uint64_t i = 0; i < count; ++i)
      workers.emplace_back(work);
    bool is_stopped = false;
    while (finished < tiles_ && !stop) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      const double part = double(finished) / double(std::max<std::size_t>(tiles_, 1));
      if (!tell_(phase.name, before + share * part)) {
        is_stopped = true;
        stop = true;
      }
    }
    for (std::thread& worker : workers)
      worker.join();
    if (is_stopped)
      throw Failure(stopped_by_signal);
    if (problem)
      std::rethrow_exception(problem);
  }

  std::size_t tiles_;
  std::vector<std::uint64_t> own_points_;
  const Tell& tell_;
  std::uint64_t memory_;
  unsigned int threads_;
};

/** What later steps have made of it is on disk, too. */
void
removeAll(const TilePlan& plan, const char* step)
{
  for (std::size_t tile = 0; tile < plan.tiling.tiles.size(); ++tile)
    std::filesystem::remove(plan.file(tile, step));
}

} // namespace

void
runTiles(const TilePlan& plan,
         std::uint64_t memory,
         unsigned int threads,
         bool keeps,
         const std::function<bool(const char*, double)>& tell)
{
  const std::size_t tiles = plan.tiling.tiles.size();
  const auto forTile = [&](auto step) {
    return
        [&plan, step](std::size_t tile, const StepRun& run) { step(plan, tile, run); };
  };
  const auto forPart = [&](auto step) {
    return [&plan, step](std::size_t tile, const StepRun&) { step(plan, tile); };
  };
  const auto wind = [&](std::size_t tile, const StepRun& run) {
    windTile(plan, tile, run);
    if (!keeps)
      for (const char* step : {MESH_STEP, JOIN_STEP})
        std::filesystem::remove(plan.file(tile, step));
  };
  std::vector<Phase> phases = {{"outer side", 1, {}, [&] { decideAllSides(plan); }}};
  if (plan.repairs()) {
    phases.push_back({"holes", 1, {}, [&] { findHoles(plan); }});
    phases.push_back(
        {"repair", 30, forTile(repairTile), {}, [&] { return repairPoints(plan); }});
    phases.push_back({"repair", 0, {}, [&] { numberRepairs(plan); }});
  }
  if (keeps) {
    phases.push_back({"shards", 4, forPart(writeShard), {}});
    phases.push_back({"index", 1, {}, [&] {
                        removeAll(plan, PIECES_STEP);
                        writeIndex(plan);
                      }});
  }
  const std::vector<Phase> before = {
      {"meshing tiles", 80, forTile(meshTile), {}},
      {"joining tiles", 2, forPart(joinTile), {}},
      {"disputes", 1, {}, [&] { groupAllDisputes(plan); }},
      {"closing seams", 5, forTile(closeTile), {}},
      {"winding", 6, wind, {}},
      {"winding", 0, {}, [&] {
         removeAll(plan, MESH_STEP);
         removeAll(plan, JOIN_STEP);
       }}};
  bool is_wound = tiles > 0;
  for (std::size_t tile = 0; tile < tiles; ++tile)
    is_wound = is_wound &&
               (hasShard(plan, tile) || isDone(plan.file(tile, PIECES_STEP), plan.key));
  if (!is_wound)
    phases.insert(phases.begin(), before.begin(), before.end());
  returnLargeBlocks();
  TileRun(plan, memory, threads, tell).run(phases);
}

} // namespace app
