// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: cuts clouds of any size into tiles.
#include "out_of_core/partition.h"

#include "cli/run_facts.h"
#include "io/point_columns.h"
#include "mesh/box_tree.h"
#include "mesh/morton_code.h"
#include "mesh/radix_sort.h"
#include "out_of_core/point_sharing.h"
#include "out_of_core/point_spacing.h"
#include "out_of_core/point_stream.h"
#include "out_of_core/tile_points.h"
#include "run/threads.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

namespace app {
namespace {

namespace fs = std::filesystem;
using pcl::ccaa::Position;

/** The spacing of a tile: that of its points, at this quantile. */
constexpr double QUANTILE = 0.9;
/** Bits of a whole number that floats hold exactly, beside its sign. */
constexpr int EXACT_BITS = 24;

class Partition {
public:
  Partition(const std::vector<std::string>& paths,
            const std::string& folder,
            std::uint64_t most_points,
            const std::string& settings,
            unsigned int threads,
            const std::function<bool(double)>& goes_on)
  : threads_(pcl::ccaa::resolveThreads(threads))
  , goes_on_(goes_on)
  , head_(readHeads(paths))
  {
    plan_.folder = folder;
    plan_.settings = settings;
    plan_.most_points = most_points;
    plan_.layout = head_.layout;
    plan_.viewpoint = head_.viewpoint;
    view_ = recordView(plan_);
    for (const TileInput& input : head_.inputs)
      announced_ += input.points;
  }

  /** The plan that is there already, if it is that of the same run. */
  std::optional<TilePlan>
  made() const
  {
    std::error_code error;
    if (!fs::exists(plan_.file(PLAN_FILE), error))
      return std::nullopt;
    TilePlan made = readPlan(plan_.folder);
    const bool is_same =
        made.settings == plan_.settings && made.most_points == plan_.most_points &&
        std::is_permutation(made.inputs.begin(),
                            made.inputs.end(),
                            head_.inputs.begin(),
                            head_.inputs.end(),
                            [](const TileInput& a, const TileInput& b) {
                              return a.path == b.path && a.bytes == b.bytes &&
                                     a.changed == b.changed;
                            });
    if (!is_same)
      throw Failure("the folder '" + plan_.folder +
                    "' holds tiles of other inputs or other parameters; use another "
                    "one, or remove it");
    placeInputs(made, head_.inputs);
    return made;
  }

  TilePlan
  run()
  {
    const fs::path scratch = fs::path(plan_.folder) / "cutting";
    fs::remove_all(scratch);
    fs::create_directories(scratch);
    TileBuckets buckets(scratch.string(),
                        plan_.layout.point_step,
                        view_,
                        PointSharing::mostInBucket(plan_.most_points));
    if (!stream(buckets))
      return {};
    makeKey();
    plan_.nowhere = writeNowhere(buckets);
    PointSharing sharing(buckets, plan_.most_points);
    for (std::size_t i = 0; i < sharing.tiles(); ++i) {
      if (!goes_on_(0.5 + 0.5 * double(i) / double(sharing.tiles())))
        return {};
      if (const std::vector<char> entries = sharing.take(i, view_); !entries.empty())
        addTile(entries, buckets.entryBytes());
    }
    lendHalos();
    placeTiles();
    fs::remove_all(scratch);
    plan_.inputs = head_.inputs;
    placeInputs(plan_, plan_.inputs);
    plan_.warnings = head_.warnings;
    writePlan(plan_);
    return std::move(plan_);
  }

private:
  bool
  stream(TileBuckets& buckets)
  {
    std::uint64_t done = 0;
    return streamPoints(head_, [&](const auto& portion, PointSource source) {
      const std::size_t points = pointCount(portion);
      for (std::size_t i = 0; i < points; ++i, ++source.point)
        buckets.add(pointAt(portion, i), source);
      done += points;
      return goes_on_(0.5 * double(done) /
                      double(std::max<std::uint64_t>(announced_, 1)));
    });
  }

  /** Of what was read, in whatever order. */
  void
  makeKey()
  {
    std::vector<std::string> hashes;
    for (const TileInput& input : head_.inputs)
      hashes.push_back(input.hash);
    std::sort(hashes.begin(), hashes.end());
    std::string text = version() + plan_.settings + std::to_string(plan_.most_points);
    for (const std::string& hash : hashes)
      text += hash;
    plan_.key = hashOf("", text.data(), text.size());
  }

  std::uint64_t
  writeNowhere(TileBuckets& buckets)
  {
    std::vector<char> records;
    std::vector<PointSource> sources = buckets.takeNowhere(records);
    StepWriter file(plan_.file(NOWHERE_FILE), plan_.key);
    file.putAll(sources);
    file.putAll(records);
    file.commit();
    return sources.size();
  }

  /** Sort the points of a tile, write them, and measure their spacing. */
  void
  addTile(const std::vector<char>& entries, std::size_t entry)
  {
    pcl::ccaa::Tile tile;
    const std::vector<pcl::ccaa::CodedPoint> order = orderOf(entries, entry, tile.box);
    std::vector<char> records(order.size() * step());
    std::vector<PointSource> sources(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      const char* const from = &entries[std::size_t(order[i].point_index) * entry];
      std::memcpy(&records[i * step()], from, step());
      std::memcpy(&sources[i], from + step(), sizeof(PointSource));
    }
    const std::size_t number = plan_.tiling.tiles.size();
    tile.count = order.size();
    const std::vector<SparsePoint> sparse = measureHalos(records, tile);
    for (const SparsePoint& one : sparse) {
      const double halo = one.halo;
      widest_ = std::max(widest_, halo);
      tile.sparse.extend(pcl::ccaa::widened(
          pcl::ccaa::Box(positionAt(records, one.point * step())), halo));
    }
    TilePoints::write(plan_, plan_.file(number, POINTS_STEP), records, sources, sparse);
    plan_.tiling.tiles.push_back(tile);
  }

  /** A tile with too few points to measure takes the halo of the nearest one that has
   * any, the first of several. */
  void
  lendHalos()
  {
    std::vector<pcl::ccaa::Tile> measured;
    for (const pcl::ccaa::Tile& tile : plan_.tiling.tiles)
      if (tile.halo > 0.0)
        measured.push_back(tile);
    for (pcl::ccaa::Tile& tile : plan_.tiling.tiles)
      if (tile.halo == 0.0 && !measured.empty())
        tile.halo = std::min_element(measured.begin(),
                                     measured.end(),
                                     [&](const auto& a, const auto& b) {
                                       return tile.distance(a) < tile.distance(b);
                                     })
                        ->halo;
  }

  std::size_t
  step() const
  {
    return plan_.layout.point_step;
  }

  Position
  positionAt(const std::vector<char>& bytes, std::size_t at) const
  {
    return view_.tripleAt(reinterpret_cast<const std::uint8_t*>(&bytes[at]));
  }

  /** Along a curve, where that does not tell by their bytes: only points that are the
   * same in everything can change places with the order of the input. */
  std::vector<pcl::ccaa::CodedPoint>
  orderOf(const std::vector<char>& entries,
          std::size_t entry,
          pcl::ccaa::Box& box) const
  {
    using pcl::ccaa::CodedPoint;
    const std::size_t count = entries.size() / entry;
    for (std::size_t i = 0; i < count; ++i)
      box.extend(positionAt(entries, i * entry));
    const double size = std::max(box.sizes().maxCoeff(), 1e-300);
    std::vector<CodedPoint> order(count), spare(count);
    for (std::size_t i = 0; i < count; ++i)
      order[i] = {pcl::ccaa::mortonCode(Eigen::Vector3d(
                      (positionAt(entries, i * entry) - box.min()) / size)),
                  static_cast<pcl::index_t>(i)};
    pcl::ccaa::radixSort(
        order.data(), spare.data(), count, pcl::ccaa::MORTON_BITS, threads_);
    const auto isBefore = [&](const CodedPoint& a, const CodedPoint& b) {
      const char* const one = &entries[std::size_t(a.point_index) * entry];
      const char* const other = &entries[std::size_t(b.point_index) * entry];
      if (const int difference = std::memcmp(one, other, step()); difference != 0)
        return difference < 0;
      PointSource first, second;
      std::memcpy(&first, one + step(), sizeof(first));
      std::memcpy(&second, other + step(), sizeof(second));
      return first < second;
    };
    for (auto begin = order.begin(); begin != order.end();) {
      const auto end = std::find_if(
          begin, order.end(), [&](const auto& a) { return a.code != begin->code; });
      std::sort(begin, end, isBefore);
      begin = end;
    }
    return order;
  }

  /** \param[in,out] tile gets its halo, none where all points are in one place
   * \return its sparse points, ascending */
  std::vector<SparsePoint>
  measureHalos(const std::vector<char>& records, pcl::ccaa::Tile& tile) const
  {
    using pcl::ccaa::Tile;
    const std::vector<float> spacings = spacingsIn(records, tile);
    std::vector<float> order;
    std::copy_if(spacings.begin(),
                 spacings.end(),
                 std::back_inserter(order),
                 [](float s) { return s > 0.0F; });
    if (order.empty())
      return {};
    const auto place = order.begin() +
                       static_cast<std::ptrdiff_t>(QUANTILE * double(order.size() - 1));
    std::nth_element(order.begin(), place, order.end());
    tile.halo = Tile::SPACINGS * double(*place);
    const double widest =
        std::max(tile.halo, Tile::WIDEST * tile.box.sizes().maxCoeff());
    std::vector<SparsePoint> sparse;
    for (std::size_t i = 0; i < spacings.size(); ++i)
      if (const double halo = Tile::SPACINGS * double(spacings[i]);
          halo >= Tile::SPARSE * tile.halo)
        sparse.push_back({static_cast<std::uint32_t>(i),
                          static_cast<float>(std::min(halo, widest))});
    return sparse;
  }

  std::vector<float>
  spacingsIn(const std::vector<char>& records, const pcl::ccaa::Tile& tile) const
  {
    pcl::ccaa::RankedPoints points;
    points.coordinates.resize(tile.count);
    for (std::size_t i = 0; i < tile.count; ++i)
      Eigen::Map<Eigen::Vector3f>(points.coordinates[i].data()) =
          (positionAt(records, i * step()) - tile.box.center()).cast<float>();
    return spacingsOf(points, threads_);
  }

  /** The first point of each tile, and a lattice on which doubles are exact floats. */
  void
  placeTiles()
  {
    Eigen::AlignedBox3d whole;
    double extent = 0.0;
    pcl::ccaa::WideIndex first = 0;
    for (pcl::ccaa::Tile& tile : plan_.tiling.tiles) {
      tile.first = first;
      first += tile.count;
      whole.extend(tile.box);
      extent = std::max(extent,
                        tile.box.sizes().maxCoeff() + 2 * std::max(tile.halo, widest_));
    }
    if (!whole.isEmpty())
      plan_.origin = whole.center();
    if (hasDoublePositions(plan_.layout) && extent > 0.0)
      plan_.step = std::ldexp(1.0, std::ilogb(extent) - EXACT_BITS); // of half of it
    for (const pcl::ccaa::Tile& tile : plan_.tiling.tiles)
      plan_.corners.push_back(plan_.step > 0.0
                                  ? pcl::ccaa::roundedTo(plan_.step, tile.box.center())
                                  : Position::Zero());
  }

  int threads_;
  const std::function<bool(double)>& goes_on_;
  StreamHead head_;
  TilePlan plan_;
  pcl::ccaa::PointView view_; /**< of positions in records */
  std::uint64_t announced_ = 0;
  double widest_ = 0.0; /**< halo of a sparse point */
};

} // namespace

TilePlan
partition(const std::vector<std::string>& paths,
          const std::string& folder,
          std::uint64_t most_points,
          const std::string& settings,
          unsigned int threads,
          const std::function<bool(double)>& goes_on)
{
  Partition partition(paths, folder, most_points, settings, threads, goes_on);
  if (auto made = partition.made())
    return std::move(*made);
  return partition.run();
}

} // namespace app
