// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reads OFF.
#include "cloud_assembler.h"
#include "polygon_builder.h"
#include "readers.h"
#include "text_scanner.h"

#include <algorithm>

namespace app {
namespace {

using Numbers = std::vector<double>;

class OffParser {
public:
  OffParser(const InputFile& file, Model& model) : scanner_(file.bytes()), model_(model)
  {}

  void
  run()
  {
    readHeader();
    readVertices();
    readFaces();
    std::vector<FieldArray> arrays;
    if (has_normals_)
      arrays.push_back(std::move(normals_));
    if (has_colours_)
      arrays.push_back(std::move(colours_));
    positions_.assemble(arrays, model_.mesh.cloud);
  }

private:
  /** Next line that is neither empty nor a comment; a comment behind it is cut off. */
  bool
  nextDataLine(std::string_view& line)
  {
    while (scanner_.nextLine(line)) {
      line = line.substr(0, line.find('#'));
      if (!isBlank(line))
        return true;
    }
    return false;
  }

  static bool
  isBlank(std::string_view line)
  {
    return std::all_of(line.begin(), line.end(), TextScanner::isSpace);
  }

  static bool
  parseLine(std::string_view line, Numbers& numbers)
  {
    TextScanner words(line);
    std::string_view word;
    numbers.clear();
    while (words.nextWord(word))
      if (!parseNumber(word, numbers.emplace_back()))
        return false;
    return true;
  }

  /** "OFF" with letters before it for what else a vertex has. Some files go on with the
   * counts without a space, others have no keyword at all. */
  void
  readKeyword(std::string_view& line)
  {
    while (TextScanner::isSpace(line.front()))
      line.remove_prefix(1);
    const std::size_t off = line.substr(0, 6).find("OFF");
    const bool is_bare = line.front() >= '0' && line.front() <= '9';
    if (is_bare && off == std::string_view::npos)
      return;
    std::string_view letters = line.substr(0, off);
    const bool has_texture = letters.substr(0, 2) == "ST";
    letters.remove_prefix(has_texture ? 2 : 0);
    const bool is_known =
        letters.empty() || letters == "C" || letters == "N" || letters == "CN";
    if (off == std::string_view::npos || !is_known)
      throw Failure("it does not begin with OFF, COFF, NOFF or CNOFF");
    has_colours_ = letters.find('C') != std::string_view::npos;
    has_normals_ = letters.find('N') != std::string_view::npos;
    if (has_texture)
      model_.warnings.push_back("texture coordinates are not taken over");
    line.remove_prefix(off + 3);
  }

  /** The keyword and the counts, which may stand on the same line. */
  void
  readHeader()
  {
    std::string_view line;
    if (!nextDataLine(line))
      throw Failure("it is not OFF");
    readKeyword(line);
    Numbers counts;
    if (isBlank(line) && !nextDataLine(line))
      throw Failure("its counts are missing");
    if (!parseLine(line, counts) || counts.size() < 2)
      throw Failure("its counts are missing (a binary OFF?)");
    const auto most = static_cast<double>(scanner_.remaining());
    // A vertex takes at least "0 0 0", a face "3 0 1 2".
    if (!(counts[0] >= 0 && counts[0] <= most / 5 && counts[1] >= 0 &&
          counts[1] <= most / 2))
      throw Failure("it is too short for the counts in its header (truncated?)");
    vertices_ = static_cast<std::size_t>(counts[0]);
    faces_ = static_cast<std::size_t>(counts[1]);
  }

  void
  readVertices()
  {
    const std::size_t needed = 3U + (has_normals_ ? 3U : 0U) + (has_colours_ ? 3U : 0U);
    std::string_view line;
    Numbers numbers;
    for (std::size_t i = 0; i < vertices_; ++i) {
      if (!nextDataLine(line) || !parseLine(line, numbers) || numbers.size() < needed)
        throw Failure("its vertex " + std::to_string(i) + " of " +
                      std::to_string(vertices_) + " is damaged or cut off");
      TextScanner words(line);
      for (int axis = 0; axis < 3; ++axis)
        positions_.add(words.word());
      for (std::size_t axis = 3; has_normals_ && axis < 6; ++axis)
        normals_.append(static_cast<float>(numbers[axis]));
      if (has_colours_)
        addColour(line, numbers);
    }
  }

  /** Whole numbers up to 255, or, where any has a point, shares up to 1. */
  void
  addColour(std::string_view line, const Numbers& numbers)
  {
    const std::size_t first = has_normals_ ? 6 : 3;
    TextScanner words(line);
    std::string_view word;
    bool has_point = false;
    for (std::size_t i = 0; words.nextWord(word); ++i)
      has_point = has_point || (i >= first && word.find('.') != std::string_view::npos);
    appendColour(colours_, &numbers[first], has_point ? 255.0 : 1.0);
  }

  void
  readFaces()
  {
    PolygonBuilder builder(model_.mesh.polygons);
    std::string_view line;
    for (std::size_t i = 0; i < faces_; ++i)
      if (!nextDataLine(line) || !readFace(line, builder))
        throw Failure("its face " + std::to_string(i) + " of " +
                      std::to_string(faces_) + " is damaged or cut off");
    builder.finish(model_.warnings);
  }

  bool
  readFace(std::string_view line, PolygonBuilder& builder)
  {
    TextScanner words(line);
    std::size_t count = 0;
    if (!nextNumber(words, count) || count > line.size())
      return false;
    corners_.resize(count);
    for (std::int64_t& corner : corners_)
      if (!nextNumber(words, corner))
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
  TextPositions positions_;
  FieldArray normals_ = normalArray({});
  FieldArray colours_ = colourArray();
  std::vector<std::int64_t> corners_;
};

} // namespace

void
readOff(const InputFile& file, Model& model)
{
  OffParser(file, model).run();
}

} // namespace app
