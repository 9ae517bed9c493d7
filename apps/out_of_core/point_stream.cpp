// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the points of many files in portions.
#include "out_of_core/point_stream.h"

#include "io/merge.h"
#include "io/model_io.h"
#include "io/point_columns.h"
#include "io/readers.h"
#include "io/wording.h"
#include <sys/mman.h>

#include <algorithm>
#include <filesystem>
#include <limits>

namespace app {
namespace {

/** Points that are decoded at a time. */
constexpr std::size_t PORTION = std::size_t{1} << 18;

/** One file whose points can be had in portions, or all at once. */
class PointFile {
public:
  explicit PointFile(const std::string& path)
  {
    const FileFormat format = formatOfPath(path);
    require(file_.open(path));
    try {
      in_portions_ =
          (format == FileFormat::PLY && findPlyRecords(file_, records_, head_)) ||
          (format == FileFormat::PCD && findPcdRecords(file_, records_, head_));
    }
    catch (const Failure& failure) {
      throw Failure("cannot read '" + path + "': " + failure.what());
    }
    if (!in_portions_) {
      head_ = {};
      require(readCloud(path, head_));
      whole_ = std::move(head_.mesh.cloud);
      head_.mesh.cloud = whole_;
      head_.mesh.cloud.data.clear();
      head_.mesh.cloud.width = 0;
    }
    bytes_ = file_.size();
  }

  std::uint64_t
  points() const
  {
    return in_portions_ ? records_.left : pointCount(whole_);
  }
  std::uint64_t
  bytes() const
  {
    return bytes_;
  }
  Model&
  head()
  {
    return head_;
  }

  /** \return false behind the last point */
  bool
  next(pcl::PCLPointCloud2& portion)
  {
    if (in_portions_) {
      if (records_.left == 0)
        return false;
      records_.decode(PORTION, portion);
      dropBehind();
      return true;
    }
    portion = std::move(whole_);
    whole_ = {};
    return pointCount(portion) > 0;
  }

private:
  /** The pages of a mapped file that have been read count as memory of the process. */
  void
  dropBehind()
  {
    constexpr std::size_t PAGE = 4096;
    const auto offset =
        static_cast<std::size_t>(records_.rows.position() - file_.begin()) / PAGE *
        PAGE;
    if (file_.isMapped() && offset > dropped_)
      madvise(const_cast<char*>(file_.begin()) + dropped_,
              offset - dropped_,
              MADV_DONTNEED);
    dropped_ = offset;
  }

  InputFile file_;
  Model head_;
  PointRecords records_;
  pcl::PCLPointCloud2 whole_;
  bool in_portions_ = false;
  std::uint64_t bytes_ = 0;
  std::size_t dropped_ = 0;
};

/** Names and types of the fields, one after the other. */
std::string
fieldsOf(const pcl::PCLPointCloud2& cloud)
{
  std::string text;
  for (const pcl::PCLPointField& field : cloud.fields)
    text += field.name + " " + std::to_string(field.datatype) + "\n";
  return text;
}

} // namespace

StreamHead
readHeads(const std::vector<std::string>& paths)
{
  StreamHead head;
  std::vector<NamedModel> parts;
  for (const std::string& path : paths) {
    if (isStandardStream(path))
      throw Failure("standard input cannot be read tile by tile; give it a file name");
    PointFile file(path);
    for (const TileInput& other : head.inputs)
      if (std::filesystem::equivalent(other.path, path))
        throw Failure("'" + path + "' is given twice");
    if (file.points() > std::numeric_limits<std::uint32_t>::max())
      throw Failure("'" + path + "' has more than 2^32 points; split it");
    TileInput input;
    input.path = path;
    input.bytes = file.bytes();
    input.points = file.points();
    input.changed = std::filesystem::last_write_time(path).time_since_epoch().count();
    head.inputs.push_back(input);
    parts.push_back({path, std::move(file.head())});
    head.viewpoints.push_back(parts.back().model.viewpoint);
  }
  // The first one gives the order of the fields: not that of the first file.
  std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
    return fieldsOf(a.model.mesh.cloud) < fieldsOf(b.model.mesh.cloud);
  });
  Model whole;
  mergeModels(parts, whole);
  head.layout = std::move(whole.mesh.cloud);
  head.viewpoint = whole.viewpoint;
  head.warnings = std::move(whole.warnings);
  return head;
}

bool
streamPoints(StreamHead& head, const TakePortion& take)
{
  for (std::size_t i = 0; i < head.inputs.size(); ++i) {
    TileInput& input = head.inputs[i];
    PointFile file(input.path);
    pcl::PCLPointCloud2 portion;
    PointSource first;
    first.file = static_cast<std::uint32_t>(i);
    while (file.next(portion)) {
      const auto points = static_cast<std::uint32_t>(pointCount(portion));
      input.hash = hashOf(input.hash, portion.data.data(), portion.data.size());
      conformTo(head.layout, head.viewpoints[i], portion);
      if (!take(portion, first))
        return false;
      first.point += points;
    }
    input.points = first.point;
  }
  for (std::size_t i = 0; i < head.inputs.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (head.inputs[i].hash == head.inputs[j].hash && head.inputs[i].points > 0)
        head.warnings.push_back("'" + head.inputs[i].path +
                                "' has the same points as '" + head.inputs[j].path +
                                "'");
  return true;
}

} // namespace app
