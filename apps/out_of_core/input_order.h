// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the points of all tiles in the order of the input.
#pragma once

#include "io/status.h"
#include "out_of_core/tile_plan.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace app {

/** \brief Puts records into the order of the input, a window of it at a time, by files
 * in a folder of the plan's. Throws a Failure where these cannot be written. */
class InputOrder {
public:
  /** \brief Points that are put in order at a time. */
  static constexpr std::uint64_t WINDOW = std::uint64_t{1} << 22;

  explicit InputOrder(const TilePlan& plan)
  : plan_(plan)
  , scratch_(plan.file("merging"))
  , entry_bytes_(sizeof(std::uint32_t) + plan.layout.point_step)
  {
    windows_ = (plan.points() + WINDOW - 1) / WINDOW;
    std::filesystem::remove_all(scratch_);
    std::filesystem::create_directories(scratch_);
  }
  ~InputOrder()
  {
    std::error_code error;
    std::filesystem::remove_all(scratch_, error);
  }
  InputOrder(const InputOrder&) = delete;
  InputOrder&
  operator=(const InputOrder&) = delete;

  /** \brief The number of a point in the merged file. */
  std::uint64_t
  placeOf(PointSource source) const
  {
    return plan_.inputs[source.file].first + source.point;
  }

  /** \brief Sort records into the files of their windows. */
  template <typename RecordAt, typename SourceAt>
  void
  add(std::size_t count, const RecordAt& record_at, const SourceAt& source_at)
  {
    std::map<std::uint64_t, std::vector<char>> waiting;
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint64_t place = placeOf(source_at(i));
      const auto within = static_cast<std::uint32_t>(place % WINDOW);
      const auto* number = reinterpret_cast<const char*>(&within);
      const auto* record = reinterpret_cast<const char*>(record_at(i));
      std::vector<char>& bytes = waiting[place / WINDOW];
      bytes.insert(bytes.end(), number, number + sizeof(within));
      bytes.insert(bytes.end(), record, record + plan_.layout.point_step);
    }
    for (const auto& [window, bytes] : waiting) {
      std::ofstream file(pathOf(window), std::ios::binary | std::ios::app);
      if (!file.write(bytes.data(), static_cast<std::streamsize>(bytes.size())) ||
          !file.flush())
        throw Failure("cannot write '" + pathOf(window) + "': " + std::strerror(errno));
    }
  }

  /** \brief Calls use(cloud) for all windows, ascending; their files are removed. */
  template <typename Use>
  void
  takeWindows(const Use& use) const
  {
    for (std::uint64_t window = 0; window < windows_; ++window) {
      std::ifstream file(pathOf(window), std::ios::binary);
      const auto bytes =
          static_cast<std::size_t>(std::filesystem::file_size(pathOf(window)));
      std::vector<char> entries(bytes);
      if (!file.read(entries.data(), static_cast<std::streamsize>(bytes)))
        throw Failure("cannot read '" + pathOf(window) + "': " + std::strerror(errno));
      pcl::PCLPointCloud2 cloud = plan_.layout;
      cloud.width = static_cast<pcl::uindex_t>(bytes / entry_bytes_);
      cloud.data.resize(cloud.width * cloud.point_step);
      for (std::size_t at = 0; at < bytes; at += entry_bytes_) {
        std::uint32_t within = 0;
        std::memcpy(&within, &entries[at], sizeof(within));
        std::memcpy(&cloud.data[within * cloud.point_step],
                    &entries[at + sizeof(within)],
                    cloud.point_step);
      }
      file.close();
      std::filesystem::remove(pathOf(window));
      use(cloud);
    }
  }

private:
  std::string
  pathOf(std::uint64_t window) const
  {
    return (scratch_ / std::to_string(window)).string();
  }

  const TilePlan& plan_;
  std::filesystem::path scratch_;
  std::size_t entry_bytes_;
  std::uint64_t windows_ = 0;
};

} // namespace app
