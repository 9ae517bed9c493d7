// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reads OFF.
#include "off_reader.h"

#include "cloud_assembler.h"
#include "polygon_builder.h"
#include "text_scanner.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

/** "3 0 1 2"; faces of fewer corners are not kept. */
constexpr std::size_t least_face_bytes = 7;

class OffParser {
public:
  OffParser(const InputFile& file, Model& model)
  : scanner_(file.begin(), file.end()), model_(model)
  {}

  Status
  run()
  {
    Status status = readHeader();
    if (status.ok())
      status = readVertices();
    if (status.ok())
      status = readFaces();
    if (!status.ok())
      return status;
    std::vector<FieldArray> arrays;
    if (has_normals_)
      arrays.push_back(std::move(normals_));
    if (has_colours_)
      arrays.push_back(std::move(colours_));
    return assembleCloud(positions_, is_wide_, arrays, model_.mesh.cloud);
  }

private:
  /** Next line that is neither empty nor a comment; a comment behind it is cut off. */
  bool
  nextDataLine(std::string_view& line)
  {
    while (scanner_.nextLine(line)) {
      line = line.substr(0, line.find('#'));
      if (!std::all_of(line.begin(), line.end(), TextScanner::isSpace))
        return true;
    }
    return false;
  }

  static bool
  parseLine(std::string_view line, std::vector<double>& numbers)
  {
    TextScanner words(line.data(), line.data() + line.size());
    std::string_view word;
    numbers.clear();
    while (words.nextWord(word)) {
      double value = 0;
      if (!parseNumber(word, value))
        return false;
      numbers.push_back(value);
    }
    return true;
  }

  /** "OFF" with letters before it for what else a vertex has. Some files go on with the
   * counts without a space, others have no keyword at all. */
  Status
  readKeyword(std::string_view& line)
  {
    while (!line.empty() && TextScanner::isSpace(line.front()))
      line.remove_prefix(1);
    const std::size_t off = line.substr(0, 6).find("OFF");
    const bool is_bare = line.front() >= '0' && line.front() <= '9';
    if (is_bare && off == std::string_view::npos)
      return {};
    const std::string_view letters = line.substr(0, off);
    const bool is_known = letters.empty() || letters == "C" || letters == "N" ||
                          letters == "CN" || letters == "ST" || letters == "STC" ||
                          letters == "STN" || letters == "STCN";
    if (off == std::string_view::npos || !is_known)
      return Status::error("it does not begin with OFF, COFF, NOFF or CNOFF");
    has_colours_ = letters.find('C') != std::string_view::npos;
    has_normals_ = letters.find('N') != std::string_view::npos;
    if (letters.substr(0, 2) == "ST")
      model_.warnings.push_back("texture coordinates are not taken over");
    line.remove_prefix(off + 3);
    return {};
  }

  /** The keyword and the counts, which may stand on the same line. */
  Status
  readHeader()
  {
    std::string_view line;
    if (!nextDataLine(line))
      return Status::error("it is not OFF");
    const Status status = readKeyword(line);
    if (!status.ok())
      return status;
    if (std::all_of(line.begin(), line.end(), TextScanner::isSpace) &&
        !nextDataLine(line))
      return Status::error("its counts are missing");
    std::vector<double> counts;
    if (!parseLine(line, counts) || counts.size() < 2)
      return Status::error("its counts are missing (a binary OFF?)");
    const auto most = static_cast<double>(scanner_.remaining());
    // A vertex takes at least "0 0 0", a face "3 0 1 2".
    if (!(counts[0] >= 0 && counts[0] <= most / 5 && counts[1] >= 0 &&
          counts[1] <= most / 2))
      return Status::error("it is too short for the counts in its header (truncated?)");
    vertices_ = static_cast<std::size_t>(counts[0]);
    faces_ = static_cast<std::size_t>(counts[1]);
    return {};
  }

  Status
  readVertices()
  {
    const std::size_t needed = 3U + (has_normals_ ? 3U : 0U) + (has_colours_ ? 3U : 0U);
    std::string_view line;
    std::vector<double> numbers;
    for (std::size_t i = 0; i < vertices_; ++i) {
      if (!nextDataLine(line) || !parseLine(line, numbers) || numbers.size() < needed)
        return Status::error("its vertex " + std::to_string(i) + " of " +
                             std::to_string(vertices_) + " is damaged or cut off");
      positions_.insert(positions_.end(), numbers.begin(), numbers.begin() + 3);
      if (!is_wide_)
        lookForDigits(line, numbers);
      if (has_normals_)
        for (std::size_t axis = 3; axis < 6; ++axis)
          normals_.append(static_cast<float>(numbers[axis]));
      if (has_colours_)
        addColour(line, numbers);
    }
    return {};
  }

  void
  lookForDigits(std::string_view line, const std::vector<double>& numbers)
  {
    TextScanner words(line.data(), line.data() + line.size());
    std::string_view word;
    for (std::size_t axis = 0; axis < 3 && words.nextWord(word); ++axis)
      is_wide_ = is_wide_ || needsDouble(word, numbers[axis]);
  }

  /** Whole numbers up to 255, or, where any has a point, shares up to 1. */
  void
  addColour(std::string_view line, const std::vector<double>& numbers)
  {
    const std::size_t first = has_normals_ ? 6 : 3;
    TextScanner words(line.data(), line.data() + line.size());
    std::string_view word;
    bool has_point = false;
    for (std::size_t i = 0; words.nextWord(word); ++i)
      has_point = has_point || (i >= first && word.find('.') != std::string_view::npos);
    unsigned parts[3];
    for (std::size_t i = 0; i < 3; ++i) {
      const double part = numbers[first + i] * (has_point ? 255.0 : 1.0);
      const double bounded = part > 0 ? std::min(part, 255.0) : 0.0;
      parts[i] = static_cast<unsigned>(std::lround(bounded));
    }
    appendColour(colours_, parts[0], parts[1], parts[2]);
  }

  Status
  readFaces()
  {
    PolygonBuilder builder(model_.mesh.polygons);
    builder.reserve(std::min(faces_, scanner_.remaining() / least_face_bytes));
    std::string_view line;
    for (std::size_t i = 0; i < faces_; ++i)
      if (!nextDataLine(line) || !readFace(line, builder))
        return Status::error("its face " + std::to_string(i) + " of " +
                             std::to_string(faces_) + " is damaged or cut off");
    return builder.finish(model_.warnings);
  }

  bool
  readFace(std::string_view line, PolygonBuilder& builder)
  {
    TextScanner words(line.data(), line.data() + line.size());
    std::string_view word;
    std::uint64_t count = 0;
    if (!words.nextWord(word) || !parseNumber(word, count) || count > line.size())
      return false;
    corners_.resize(static_cast<std::size_t>(count));
    for (std::int64_t& corner : corners_)
      if (!words.nextWord(word) || !parseNumber(word, corner))
        return false;
    builder.addPolygon(corners_);
    return true;
  }

  TextScanner scanner_;
  Model& model_;
  bool has_colours_ = false;
  bool has_normals_ = false;
  std::size_t vertices_ = 0;
  std::size_t faces_ = 0;
  std::vector<double> positions_;
  bool is_wide_ = false; // some position has more digits than a float
  FieldArray normals_{"normal", pcl::PCLPointField::FLOAT32, 3, {}};
  FieldArray colours_{"rgb", pcl::PCLPointField::FLOAT32, 1, {}};
  std::vector<std::int64_t> corners_;
};

} // namespace

Status
readOff(const InputFile& file, Model& model)
{
  return OffParser(file, model).run();
}

} // namespace app
