// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reads legacy VTK polygon data.
#include "vtk_reader.h"

#include "cloud_assembler.h"
#include "point_table.h"
#include "polygon_builder.h"
#include "remarks.h"
#include "vtk_cells.h"
#include "vtk_values.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

using Field = pcl::PCLPointField;

class VtkParser {
public:
  VtkParser(const InputFile& file, Model& model)
  : scanner_(file.begin(), file.end()), model_(model), builder_(model.mesh.polygons)
  {}

  Status
  run()
  {
    Status status = readPreamble();
    std::string_view line;
    while (status.ok() && scanner_.nextLine(line)) {
      TextScanner words(line.data(), line.data() + line.size());
      std::string_view keyword;
      if (words.nextWord(keyword) && !readSection(inCapitals(keyword), words))
        status = Status::error("its section '" + std::string(keyword.substr(0, 40)) +
                               "' is damaged, cut off or not known");
    }
    if (status.ok() && positions_.empty())
      return Status::error("it holds no points");
    if (status.ok() && !addSurfaceCells(cells_, cell_types_, builder_, model_.warnings))
      return Status::error("its cells and their types do not fit together");
    if (status.ok())
      status = builder_.finish(model_.warnings);
    return status.ok() ? assembleCloud(positions_, is_wide_, arrays_, model_.mesh.cloud)
                       : status;
  }

private:
  Status
  readPreamble()
  {
    std::string_view line;
    std::string_view word;
    if (!scanner_.nextLine(line) || line.substr(0, 5) != "# vtk")
      return Status::error(
          "it does not begin with '# vtk' (only legacy files are read)");
    scanner_.nextLine(line);
    keepTitle(line);
    scanner_.nextWord(word);
    is_binary_ = inCapitals(word) == "BINARY";
    if (!is_binary_ && inCapitals(word) != "ASCII")
      return Status::error("it is neither ASCII nor BINARY");
    scanner_.nextWord(word);
    const bool is_dataset = inCapitals(word) == "DATASET" && scanner_.nextWord(word);
    const std::string kind = is_dataset ? inCapitals(word) : "";
    if (kind != "POLYDATA" && kind != "UNSTRUCTURED_GRID")
      return Status::error("its DATASET is neither POLYDATA nor UNSTRUCTURED_GRID");
    scanner_.nextLine(line);
    return {};
  }

  /** VTK writes "vtk output" for want of a title. */
  void
  keepTitle(std::string_view title)
  {
    Remarks kept;
    addComment(title, kept);
    if (!kept.comments.empty() && kept.comments[0] != "vtk output")
      model_.remarks.title = kept.comments[0];
  }

  /** VTK does not mind how its keywords are written. */
  static std::string
  inCapitals(std::string_view word)
  {
    std::string capitals(word);
    for (char& c : capitals)
      c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
    return capitals;
  }

  static bool
  nextCount(TextScanner& words, std::size_t& count)
  {
    std::string_view word;
    return words.nextWord(word) && parseNumber(word, count);
  }

  static bool
  nextType(TextScanner& words, ScalarType& type)
  {
    std::string_view word;
    if (!words.nextWord(word))
      return false;
    type = vtkType(word);
    return type != 0;
  }

  bool
  readSection(const std::string& keyword, TextScanner& words)
  {
    if (keyword == "POINTS")
      return readPoints(words);
    if (keyword == "POLYGONS" || keyword == "TRIANGLE_STRIPS" || keyword == "LINES" ||
        keyword == "VERTICES" || keyword == "CELLS")
      return readCells(keyword, words);
    if (keyword == "POINT_DATA" || keyword == "CELL_DATA") {
      is_point_data_ = keyword == "POINT_DATA";
      return nextCount(words, data_rows_);
    }
    if (keyword == "CELL_TYPES") {
      std::size_t rows = 0;
      return nextCount(words, rows) &&
             VtkValues(scanner_, is_binary_).read(Field::INT32, rows, cell_types_);
    }
    if (keyword == "METADATA")
      return skipMetadata();
    if (keyword == "FIELD")
      return readFieldData(words);
    if (keyword == "LOOKUP_TABLE")
      return skipLookupTable(words);
    return readAttribute(keyword, words);
  }

  bool
  readPoints(TextScanner& words)
  {
    std::size_t count = 0;
    ScalarType type = 0;
    if (!nextCount(words, count) || !nextType(words, type) ||
        count > scanner_.remaining())
      return false;
    std::vector<SourceColumn> columns{{"x", type, 1}, {"y", type, 1}, {"z", type, 1}};
    if (!is_binary_)
      widenForText(scanner_, count, columns);
    type = columns.front().type;
    is_wide_ = type != Field::FLOAT32 && scalarSize(type) >= sizeof(float);
    return VtkValues(scanner_, is_binary_).read(type, 3 * count, positions_);
  }

  /** Since VTK 9: where each cell begins, then all corners. */
  bool
  readOffsets(std::size_t offsets,
              std::size_t corners,
              std::vector<std::int64_t>& cells)
  {
    std::vector<std::int64_t> starts;
    std::vector<std::int64_t> indices;
    if (!readNamedArray("OFFSETS", offsets, starts) ||
        !readNamedArray("CONNECTIVITY", corners, indices))
      return false;
    for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
      const std::int64_t first = starts[i];
      const std::int64_t last = starts[i + 1];
      if (first < 0 || last < first || last > static_cast<std::int64_t>(indices.size()))
        return false;
      cells.push_back(last - first);
      cells.insert(cells.end(), indices.begin() + first, indices.begin() + last);
    }
    return true;
  }

  bool
  readNamedArray(std::string_view name,
                 std::size_t count,
                 std::vector<std::int64_t>& to)
  {
    std::string_view line;
    std::string_view word;
    scanner_.nextWord(word);
    scanner_.nextLine(line);
    TextScanner words(line.data(), line.data() + line.size());
    ScalarType type = 0;
    return word == name && nextType(words, type) &&
           VtkValues(scanner_, is_binary_).read(type, count, to);
  }

  /** Whether this word is the next one; it stays there. */
  bool
  comes(std::string_view expected) const
  {
    TextScanner ahead = scanner_;
    std::string_view word;
    return ahead.nextWord(word) && word == expected;
  }

  bool
  readCells(std::string_view keyword, TextScanner& words)
  {
    std::size_t rows = 0;
    std::size_t size = 0;
    std::vector<std::int64_t> cells;
    if (!nextCount(words, rows) || !nextCount(words, size))
      return false;
    const bool good =
        comes("OFFSETS")
            ? readOffsets(rows, size, cells)
            : VtkValues(scanner_, is_binary_).read(Field::INT32, size, cells);
    if (!good)
      return false;
    if (keyword == "LINES" && rows > 0)
      model_.warnings.push_back("lines are not taken over");
    if (keyword == "LINES" || keyword == "VERTICES")
      return true;
    if (keyword == "CELLS") {
      cells_ = std::move(cells);
      return true;
    }
    std::vector<std::int64_t> corners;
    for (std::size_t at = 0; at < cells.size();) {
      const std::int64_t count = cells[at++];
      if (count < 0 || count > static_cast<std::int64_t>(cells.size() - at))
        return false;
      const auto first = cells.begin() + static_cast<std::ptrdiff_t>(at);
      corners.assign(first, first + count);
      at += static_cast<std::size_t>(count);
      keyword == "POLYGONS" ? builder_.addPolygon(corners) : builder_.addStrip(corners);
    }
    return true;
  }

  /** Names, units and the like; ends with an empty line. */
  bool
  skipMetadata()
  {
    std::string_view line;
    while (scanner_.nextLine(line) && !line.empty()) {
    }
    return true;
  }

  bool
  skipLookupTable(TextScanner& words)
  {
    std::string_view name;
    std::size_t entries = 0;
    words.nextWord(name);
    if (!nextCount(words, entries))
      return true; // only the name of a table
    FieldArray ignored{
        "", std::uint8_t(is_binary_ ? Field::UINT8 : Field::FLOAT32), 4, {}};
    return readArray(entries, ignored);
  }

  bool
  readArray(std::size_t rows, FieldArray& array)
  {
    return array.count > 0 && array.count <= 1000 && rows <= scanner_.remaining() &&
           VtkValues(scanner_, is_binary_)
               .readBytes(array.type, rows * array.count, array.bytes);
  }

  bool
  readFieldData(TextScanner& words)
  {
    std::string_view word;
    std::size_t arrays = 0;
    words.nextWord(word);
    if (!nextCount(words, arrays))
      return false;
    for (std::size_t i = 0; i < arrays; ++i) {
      std::string_view line;
      std::string_view name;
      do
        if (!scanner_.nextWord(name))
          return false;
      while (name == "METADATA" && skipMetadata());
      scanner_.nextLine(line);
      TextScanner rest(line.data(), line.data() + line.size());
      FieldArray array;
      std::size_t rows = 0;
      array.name = name;
      if (!nextCount(rest, array.count) || !nextCount(rest, rows) ||
          !nextType(rest, array.type) || !readArray(rows, array))
        return false;
      keep(array, false);
    }
    return true;
  }

  bool
  readAttribute(std::string_view keyword, TextScanner& words)
  {
    FieldArray array;
    std::string_view name;
    words.nextWord(name);
    array.name = name;
    array.count = keyword == "TENSORS" ? 9 : 3;
    if (keyword == "COLOR_SCALARS") {
      array.type = is_binary_ ? Field::UINT8 : Field::FLOAT32;
      return nextCount(words, array.count) && readArray(data_rows_, array) &&
             keep(array, true);
    }
    if (keyword == "TEXTURE_COORDINATES" && !nextCount(words, array.count))
      return false;
    const bool is_known = keyword == "SCALARS" || keyword == "VECTORS" ||
                          keyword == "NORMALS" || keyword == "TENSORS" ||
                          keyword == "TEXTURE_COORDINATES";
    if (!is_known || !nextType(words, array.type))
      return false;
    if (keyword == "SCALARS") {
      if (!nextCount(words, array.count))
        array.count = 1;
      std::string_view line;
      if (comes("LOOKUP_TABLE"))
        scanner_.nextLine(line);
    }
    if (keyword == "NORMALS")
      array.name = "normal";
    return readArray(data_rows_, array) &&
           keep(array, keyword == "SCALARS" && array.type == Field::UINT8);
  }

  /** Three bytes, or shares of ASCII COLOR_SCALARS, are a colour; the rest goes on as
   * it is. Data of cells is not kept. */
  bool
  keep(FieldArray& array, bool may_be_colour)
  {
    if (!is_point_data_)
      return true;
    const bool is_bytes = array.type == Field::UINT8;
    if (!may_be_colour || array.count < 3 || array.count > 4 ||
        (!is_bytes && array.type != Field::FLOAT32)) {
      arrays_.push_back(std::move(array));
      return true;
    }
    FieldArray colours{"rgb", Field::FLOAT32, 1, {}};
    const std::size_t size = scalarSize(array.type);
    for (std::size_t at = 0; at < array.bytes.size(); at += size * array.count) {
      unsigned parts[3];
      for (std::size_t i = 0; i < 3; ++i) {
        const auto part =
            loadScalarAs<double>(&array.bytes[at + i * size], array.type, false);
        const double byte = is_bytes ? part : part * 255;
        parts[i] =
            byte > 0 ? static_cast<unsigned>(std::lround(std::min(byte, 255.0))) : 0;
      }
      appendColour(colours, parts[0], parts[1], parts[2]);
    }
    arrays_.push_back(std::move(colours));
    return true;
  }

  TextScanner scanner_;
  Model& model_;
  PolygonBuilder builder_;
  bool is_binary_ = false;
  bool is_point_data_ = false;
  std::size_t data_rows_ = 0;
  std::vector<double> positions_;
  bool is_wide_ = false; // positions that floats do not hold
  std::vector<FieldArray> arrays_;
  std::vector<std::int64_t> cells_;      // of an unstructured grid
  std::vector<std::int64_t> cell_types_; // of the same
};

} // namespace

Status
readVtk(const InputFile& file, Model& model)
{
  return VtkParser(file, model).run();
}

} // namespace app
