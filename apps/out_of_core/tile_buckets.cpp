// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: records of points on disk, by the cell they lie in.
#include "out_of_core/tile_buckets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

namespace app {
namespace {

using pcl::ccaa::cellOf;
using pcl::ccaa::GridCell;
using pcl::ccaa::Position;

/** Bytes that wait in memory until they are appended to the files of their leaves. */
constexpr std::size_t MOST_WAITING = std::size_t{64} << 20;

/** The number of the octant of a cell in which a position of it lies. */
std::size_t
octantOf(const GridCell& cell, const Position& position)
{
  const auto [x, y, z] = childOf(cell, position).at;
  return static_cast<std::size_t>((x & 1) + 2 * (y & 1) + 4 * (z & 1));
}

[[noreturn]] void
failToWrite(const std::string& path)
{
  throw Failure("cannot write '" + path + "': " + std::strerror(errno));
}

} // namespace

std::size_t
TileBuckets::CellHash::operator()(const GridCell& cell) const
{
  auto hash = static_cast<std::size_t>(cell.level);
  for (const std::int64_t x : cell.at)
    hash = (hash ^ static_cast<std::size_t>(x)) * 0x9e3779b97f4a7c15ULL;
  return hash ^ (hash >> 29);
}

TileBuckets::TileBuckets(std::string folder,
                         std::size_t record_bytes,
                         const pcl::ccaa::PointView& records,
                         std::uint64_t most_points)
: folder_(std::move(folder))
, record_bytes_(record_bytes)
, records_(records)
, most_points_(most_points)
, last_(leaves_.end())
, entry_(entryBytes())
{}

void
TileBuckets::add(const std::uint8_t* record, PointSource source)
{
  std::memcpy(entry_.data(), record, record_bytes_);
  std::memcpy(entry_.data() + record_bytes_, &source, sizeof(source));
  const Position position = records_.tripleAt(record);
  if (position.allFinite() && position.cwiseAbs().maxCoeff() < pcl::ccaa::WORLD_EDGE)
    append(entry_.data(), position);
  else
    nowhere_.insert(nowhere_.end(), entry_.begin(), entry_.end());
}

void
TileBuckets::append(const char* entry, const Position& position)
{
  if (last_ == leaves_.end() || last_->first.isWhole() ||
      !(cellOf(position, last_->first.level) == last_->first))
    last_ = leafAt(position);
  Leaf& leaf = last_->second;
  leaf.waiting.insert(leaf.waiting.end(), entry, entry + entryBytes());
  pcl::ccaa::CountedBox& octant = leaf.octants[octantOf(last_->first, position)];
  octant.box.extend(position);
  octant.count += 1.0;
  waiting_ += entryBytes();
  if (++leaf.count > most_points_ && last_->first.canSplit())
    split(last_);
  else if (waiting_ > MOST_WAITING)
    flushAll();
}

/** The leaf that there is, or a new one. */
TileBuckets::Leaves::iterator
TileBuckets::leafAt(const Position& position)
{
  for (const auto& [level, count] : levels_) {
    const GridCell cell =
        level == GridCell::WHOLE ? GridCell() : cellOf(position, level);
    if (const auto leaf = leaves_.find(cell); leaf != leaves_.end())
      return leaf;
  }
  GridCell cell;
  while (split_.count(cell) > 0)
    cell = childOf(cell, position);
  ++levels_[cell.level];
  Leaf leaf;
  leaf.path = folder_ + "/" + std::to_string(cell.level);
  for (const std::int64_t x : cell.at)
    leaf.path += "_" + std::to_string(x);
  return leaves_.emplace(cell, std::move(leaf)).first;
}

/** Into its children; where one child has all points, into its children at once. */
void
TileBuckets::split(Leaves::iterator leaf)
{
  const std::vector<char> entries = readLeaf(leaf->second);
  waiting_ -= leaf->second.waiting.size();
  GridCell cell = leaf->first;
  std::filesystem::remove(leaf->second.path);
  if (--levels_[cell.level] == 0)
    levels_.erase(cell.level);
  leaves_.erase(leaf);
  last_ = leaves_.end();
  const auto positionAt = [&](std::size_t at) {
    return records_.tripleAt(reinterpret_cast<const std::uint8_t*>(&entries[at]));
  };
  Eigen::AlignedBox3d box;
  for (std::size_t at = 0; at < entries.size(); at += entryBytes())
    box.extend(positionAt(at));
  do
    split_.insert(cell);
  while (childOf(cell, box.min()) == childOf(cell, box.max()) &&
         (cell = childOf(cell, box.min())).canSplit());
  for (std::size_t at = 0; at < entries.size(); at += entryBytes())
    append(&entries[at], positionAt(at));
}

void
TileBuckets::flush(Leaf& leaf)
{
  if (leaf.waiting.empty())
    return;
  std::ofstream file(leaf.path, std::ios::binary | std::ios::app);
  if (!file.write(leaf.waiting.data(),
                  static_cast<std::streamsize>(leaf.waiting.size())) ||
      !file.flush())
    failToWrite(leaf.path);
  waiting_ -= leaf.waiting.size();
  leaf.waiting = std::vector<char>(); // {} would keep the memory
}

void
TileBuckets::flushAll()
{
  for (auto& [cell, leaf] : leaves_)
    flush(leaf);
}

std::vector<TileBuckets::Part>
TileBuckets::parts() const
{
  std::vector<Part> parts;
  for (const auto& [cell, leaf] : leaves_) {
    pcl::ccaa::Box box;
    for (const pcl::ccaa::CountedBox& octant : leaf.octants)
      box.extend(octant.box);
    parts.push_back({cell, box, leaf.octants});
  }
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
    return a.cell < b.cell;
  });
  return parts;
}

std::vector<char>
TileBuckets::readLeaf(const Leaf& leaf) const
{
  std::vector<char> entries(leaf.count * entryBytes());
  const std::size_t on_disk = entries.size() - leaf.waiting.size();
  if (on_disk > 0) {
    std::ifstream file(leaf.path, std::ios::binary);
    if (!file.read(entries.data(), static_cast<std::streamsize>(on_disk)))
      throw Failure("cannot read '" + leaf.path + "': " + std::strerror(errno));
  }
  std::copy(leaf.waiting.begin(),
            leaf.waiting.end(),
            entries.begin() + static_cast<std::ptrdiff_t>(on_disk));
  return entries;
}

std::vector<char>
TileBuckets::read(const GridCell& cell) const
{
  return readLeaf(leaves_.at(cell));
}

void
TileBuckets::drop(const GridCell& cell)
{
  Leaf& leaf = leaves_.at(cell);
  std::filesystem::remove(leaf.path);
  waiting_ -= leaf.waiting.size();
  leaf.waiting = std::vector<char>(); // {} would keep the memory
}

std::vector<PointSource>
TileBuckets::takeNowhere(std::vector<char>& records)
{
  std::vector<PointSource> sources(nowhere_.size() / entryBytes());
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const char* const entry = &nowhere_[i * entryBytes()];
    records.insert(records.end(), entry, entry + record_bytes_);
    std::memcpy(&sources[i], entry + record_bytes_, sizeof(PointSource));
  }
  return sources;
}

} // namespace app
