// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reads legacy VTK polygon data.
#include "cloud_assembler.h"
#include "point_table.h"
#include "polygon_builder.h"
#include "readers.h"
#include "remarks.h"
#include "vtk_values.h"

namespace app {
namespace {

using Field = pcl::PCLPointField;

class VtkParser {
public:
  VtkParser(const InputFile& file, Model& model)
  : scanner_(file.bytes()), model_(model), builder_(model.mesh.polygons)
  {}

  void
  run()
  {
    readPreamble();
    std::string_view line;
    while (scanner_.nextLine(line)) {
      TextScanner words(line);
      const std::string_view keyword = words.word();
      if (!keyword.empty() && !readSection(inCapitals(keyword), words))
        throw Failure("its section '" + std::string(keyword.substr(0, 40)) +
                      "' is damaged, cut off or not known");
    }
    if (positions_.empty())
      throw Failure("it holds no points");
    if (!addSurfaceCells(cells_, cell_types_, builder_, model_.warnings))
      throw Failure("its cells and their types do not fit together");
    builder_.finish(model_.warnings);
    assembleCloud(positions_, is_wide_, arrays_, model_.mesh.cloud);
  }

private:
  void
  readPreamble()
  {
    std::string_view line;
    if (!scanner_.nextLine(line) || line.substr(0, 5) != "# vtk")
      throw Failure("it does not begin with '# vtk' (only legacy files are read)");
    scanner_.nextLine(line);
    keepTitle(line);
    const std::string coding = inCapitals(scanner_.word());
    is_binary_ = coding == "BINARY";
    if (!is_binary_ && coding != "ASCII")
      throw Failure("it is neither ASCII nor BINARY");
    const bool is_dataset = inCapitals(scanner_.word()) == "DATASET";
    const std::string kind = is_dataset ? inCapitals(scanner_.word()) : "";
    if (kind != "POLYDATA" && kind != "UNSTRUCTURED_GRID")
      throw Failure("its DATASET is neither POLYDATA nor UNSTRUCTURED_GRID");
    scanner_.nextLine(line);
  }

  /** VTK writes "vtk output" for want of a title. */
  void
  keepTitle(std::string_view title)
  {
    std::vector<std::string> kept;
    addComment(title, kept);
    if (!kept.empty() && kept[0] != "vtk output")
      model_.remarks.title = kept[0];
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
  nextType(TextScanner& words, ScalarType& type)
  {
    type = vtkType(words.word());
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
      return nextNumber(words, data_rows_);
    }
    if (keyword == "CELL_TYPES") {
      std::size_t rows = 0;
      return nextNumber(words, rows) &&
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
    if (!nextNumber(words, count) || !nextType(words, type) ||
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
    const bool is_named = scanner_.word() == name;
    scanner_.nextLine(line);
    TextScanner words(line);
    ScalarType type = 0;
    return is_named && nextType(words, type) &&
           VtkValues(scanner_, is_binary_).read(type, count, to);
  }

  /** Whether this word is the next one; it stays there. */
  bool
  comes(std::string_view expected) const
  {
    return TextScanner(scanner_).word() == expected;
  }

  bool
  readCells(std::string_view keyword, TextScanner& words)
  {
    std::size_t rows = 0;
    std::size_t size = 0;
    std::vector<std::int64_t> cells;
    if (!nextNumber(words, rows) || !nextNumber(words, size))
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
    std::size_t entries = 0;
    words.word(); // its name
    if (!nextNumber(words, entries))
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
    std::size_t arrays = 0;
    words.word(); // its name
    if (!nextNumber(words, arrays))
      return false;
    for (std::size_t i = 0; i < arrays; ++i) {
      std::string_view line;
      std::string_view name;
      do
        if (!scanner_.nextWord(name))
          return false;
      while (name == "METADATA" && skipMetadata());
      scanner_.nextLine(line);
      TextScanner rest(line);
      FieldArray array;
      std::size_t rows = 0;
      array.name = name;
      if (!nextNumber(rest, array.count) || !nextNumber(rest, rows) ||
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
    array.name = words.word();
    array.count = keyword == "TENSORS" ? 9 : 3;
    if (keyword == "COLOR_SCALARS") {
      array.type = is_binary_ ? Field::UINT8 : Field::FLOAT32;
      return nextNumber(words, array.count) && readArray(data_rows_, array) &&
             keep(array, true);
    }
    if (keyword == "TEXTURE_COORDINATES" && !nextNumber(words, array.count))
      return false;
    const bool is_known = keyword == "SCALARS" || keyword == "VECTORS" ||
                          keyword == "NORMALS" || keyword == "TENSORS" ||
                          keyword == "TEXTURE_COORDINATES";
    if (!is_known || !nextType(words, array.type))
      return false;
    if (keyword == "SCALARS") {
      if (!nextNumber(words, array.count))
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
    FieldArray colours = colourArray();
    const std::size_t size = scalarSize(array.type);
    for (std::size_t at = 0; at < array.bytes.size(); at += size * array.count) {
      double parts[3];
      for (std::size_t i = 0; i < 3; ++i)
        parts[i] = loadScalarAs<double>(&array.bytes[at + i * size], array.type, false);
      appendColour(colours, parts, is_bytes ? 1.0 : 255.0);
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

void
readVtk(const InputFile& file, Model& model)
{
  VtkParser(file, model).run();
}

} // namespace app
