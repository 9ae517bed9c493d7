// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reads Wavefront OBJ.
#include "cloud_assembler.h"
#include "polygon_builder.h"
#include "readers.h"
#include "text_scanner.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

class ObjParser {
public:
  explicit ObjParser(Model& model) : model_(model), polygons_(model.mesh.polygons) {}

  void
  run(const InputFile& file)
  {
    TextScanner scanner(file.bytes());
    std::string_view line;
    for (std::size_t number = 1; scanner.nextLine(line); ++number) {
      const std::size_t first = number;
      std::string joined;
      while (!line.empty() && line.back() == '\\') {
        joined += std::string(line.substr(0, line.size() - 1)) + " ";
        ++number;
        if (!scanner.nextLine(line))
          line = {};
      }
      if (!joined.empty())
        line = joined += line;
      if (!readLine(line.substr(0, line.find('#'))))
        throw Failure("line " + std::to_string(first) +
                      " is not what OBJ allows there");
    }
    if (positions_.empty())
      throw Failure("it holds no vertices");
    finish();
  }

private:
  bool
  readLine(std::string_view line)
  {
    TextScanner words(line);
    const std::string_view keyword = words.word();
    if (keyword == "v")
      return readVertex(words);
    if (keyword == "vn")
      return readVector(words, normals_);
    if (keyword == "f" || keyword == "fo")
      return readFace(words);
    has_texture_ = has_texture_ || keyword == "vt";
    // Garbage has to be told from the many keywords that do not matter here.
    return std::all_of(
        keyword.begin(), keyword.end(), [](char c) { return c >= ' ' && c <= '~'; });
  }

  static bool
  readVector(TextScanner& words, std::vector<float>& vectors)
  {
    float vector[3];
    for (float& value : vector)
      if (!nextNumber(words, value))
        return false;
    vectors.insert(vectors.end(), vector, vector + 3);
    return true;
  }

  /** "v x y z", "v x y z w", "v x y z r g b" */
  bool
  readVertex(TextScanner& words)
  {
    for (int axis = 0; axis < 3; ++axis)
      if (!positions_.add(words.word()))
        return false;
    std::vector<float> rest;
    std::string_view word;
    while (words.nextWord(word))
      if (!parseNumber(word, rest.emplace_back()))
        return false;
    if (rest.size() >= 3)
      colours_.insert(colours_.end(), rest.begin(), rest.begin() + 3);
    return true;
  }

  /** OBJ counts from 1, or backwards from the last one with negative numbers. */
  static bool
  parseIndex(std::string_view word, std::size_t count, std::int64_t& index)
  {
    if (!parseNumber(word, index) || index == 0)
      return false;
    index = index > 0 ? index - 1 : index + static_cast<std::int64_t>(count);
    return index >= 0;
  }

  bool
  readFace(TextScanner& words)
  {
    std::string_view word;
    corners_.clear();
    while (words.nextWord(word)) {
      const std::size_t slash = word.find('/');
      std::int64_t corner = 0;
      if (!parseIndex(word.substr(0, slash), positions_.points(), corner))
        return false;
      corners_.push_back(corner);
      const std::size_t last = word.rfind('/');
      if (last == slash || last + 1 == word.size())
        continue;
      std::int64_t normal = 0;
      if (!parseIndex(word.substr(last + 1), normals_.size() / 3, normal))
        return false;
      normal_of_corner_.emplace_back(corner, normal);
    }
    polygons_.addPolygon(corners_);
    return true;
  }

  /** The normal of each vertex: the one its first corner names; where no face names
   * any, the normal of the same number. Empty if some vertex has none. */
  std::vector<float>
  vertexNormals() const
  {
    const std::size_t vertices = positions_.points();
    const std::size_t normals = normals_.size() / 3;
    std::vector<std::size_t> chosen(vertices, normals);
    if (normals == vertices)
      for (std::size_t i = 0; i < vertices; ++i)
        chosen[i] = i;
    for (auto named = normal_of_corner_.rbegin(); named != normal_of_corner_.rend();
         ++named)
      if (static_cast<std::size_t>(named->first) < vertices)
        chosen[static_cast<std::size_t>(named->first)] =
            static_cast<std::size_t>(named->second);
    std::vector<float> result;
    for (const std::size_t normal : chosen) {
      if (normal >= normals)
        return {};
      const auto first = normals_.begin() + static_cast<std::ptrdiff_t>(3 * normal);
      result.insert(result.end(), first, first + 3);
    }
    return result;
  }

  /** Shares of one, or, in files of some programs, whole numbers up to 255. */
  FieldArray
  packedColours() const
  {
    const bool are_bytes =
        std::any_of(colours_.begin(), colours_.end(), [](float c) { return c > 1; }) &&
        std::all_of(colours_.begin(), colours_.end(), [](float c) {
          return c >= 0 && c <= 255 && c == std::trunc(c);
        });
    const double unit = are_bytes ? 255.0 : 1.0;
    FieldArray packed = colourArray();
    for (std::size_t i = 0; i + 2 < colours_.size(); i += 3)
      appendColour(packed, &colours_[i], 255.0 / unit);
    return packed;
  }

  void
  finish()
  {
    std::vector<FieldArray> arrays;
    const std::vector<float> normals = vertexNormals();
    if (!normals.empty())
      arrays.push_back(normalArray(normals));
    else if (!normals_.empty())
      model_.warnings.push_back("the normals are not taken over: some vertex has none");
    if (has_texture_)
      model_.warnings.push_back("texture coordinates are not taken over");
    if (colours_.size() == 3 * positions_.points())
      arrays.push_back(packedColours());
    else if (!colours_.empty())
      model_.warnings.push_back("the colours are not taken over: some vertex has none");
    polygons_.finish(model_.warnings);
    positions_.assemble(arrays, model_.mesh.cloud);
  }

  Model& model_;
  PolygonBuilder polygons_;
  TextPositions positions_;
  std::vector<float> normals_;
  std::vector<float> colours_;
  std::vector<std::int64_t> corners_;
  std::vector<std::pair<std::int64_t, std::int64_t>> normal_of_corner_;
  bool has_texture_ = false;
};

} // namespace

void
readObj(const InputFile& file, Model& model)
{
  ObjParser(model).run(file);
}

} // namespace app
