// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reads PLY, ASCII and binary of both byte orders.
#include "ply_camera.h"
#include "ply_header.h"
#include "point_table.h"
#include "polygon_builder.h"
#include "readers.h"
#include "wording.h"

#include <algorithm>
#include <map>

namespace app {
namespace {

/** Takes single numbers out of the data, whatever their form. */
class ValueReader {
public:
  ValueReader(TextScanner& scanner, PlyFormat format)
  : scanner_(scanner)
  , is_text_(format == PlyFormat::ASCII)
  , swapped_(format == PlyFormat::BINARY_BIG)
  {}

  template <typename T>
  bool
  read(ScalarType type, T& value)
  {
    if (is_text_)
      return nextNumber(scanner_, value);
    const std::size_t bytes = scalarSize(type);
    if (scanner_.remaining() < bytes)
      return false;
    value = loadScalarAs<T>(scanner_.position(), type, swapped_);
    scanner_.skip(bytes);
    return true;
  }

  bool
  skip(ScalarType type, std::size_t count)
  {
    const std::size_t bytes = scalarSize(type);
    if (is_text_)
      while (count > 0 && !scanner_.word().empty())
        --count;
    else if (count <= scanner_.remaining() / bytes) {
      scanner_.skip(count * bytes);
      count = 0;
    }
    return count == 0;
  }

  /** Length of a list; lists longer than the rest of the file are refused. */
  bool
  readCount(const PlyProperty& property, std::size_t& count)
  {
    std::int64_t value = 0;
    if (!read(property.count_type, value) || value < 0)
      return false;
    const std::size_t bytes = is_text_ ? 1 : scalarSize(property.type);
    count = static_cast<std::size_t>(value);
    return count <= scanner_.remaining() / bytes;
  }

  bool
  skipProperty(const PlyProperty& property)
  {
    std::size_t count = 1;
    return (!property.isList() || readCount(property, count)) &&
           skip(property.type, count);
  }

private:
  TextScanner& scanner_;
  bool is_text_;
  bool swapped_;
};

bool
isIndexList(const PlyProperty& property)
{
  const bool is_real = property.type == pcl::PCLPointField::FLOAT32 ||
                       property.type == pcl::PCLPointField::FLOAT64;
  return property.isList() && !is_real &&
         (property.name == "vertex_indices" || property.name == "vertex_index");
}

class PlyParser {
public:
  /** \param[out] found the records of the vertices, which are only stepped over then;
   * null: they are read */
  PlyParser(const InputFile& file,
            Contents contents,
            Model& model,
            PointRecords* found = nullptr)
  : scanner_(file.bytes())
  , contents_(contents)
  , model_(model)
  , found_(found)
  , header_(readPlyHeader(scanner_))
  , values_(scanner_, header_.format)
  {}

  void
  run()
  {
    model_.remarks = header_.remarks;
    header_.elements.resize(wantedElements());
    bool has_vertices = false;
    for (const PlyElement& element : header_.elements) {
      if (has_vertices && element.name == "vertex")
        throw Failure("it has two elements 'vertex'");
      readElement(element);
      has_vertices = has_vertices || element.name == "vertex";
    }
    if (!has_vertices)
      throw Failure("it has no vertices");
  }

private:
  /** How many elements have to be gone through to have read all that is wanted. */
  std::size_t
  wantedElements() const
  {
    std::size_t wanted = header_.elements.size();
    const auto is_point_element = [](const PlyElement& element) {
      return element.name == "vertex" || element.name == "camera";
    };
    while (contents_ == Contents::POINTS && wanted > 0 &&
           !is_point_element(header_.elements[wanted - 1]))
      --wanted;
    return wanted;
  }

  void
  readElement(const PlyElement& element)
  {
    const bool wants_faces = contents_ == Contents::POINTS_AND_POLYGONS;
    if (element.name == "vertex")
      readVertices(element);
    else if (element.name == "camera" && element.rows == 1)
      readCamera(element);
    else if (wants_faces && (element.name == "face" || element.name == "tristrips"))
      readFaces(element);
    else
      skipElement(element);
  }

  static void
  check(bool good, const PlyElement& element, std::size_t row)
  {
    if (!good)
      throw Failure("its " + element.name + " " + std::to_string(row) + " of " +
                    std::to_string(element.rows) + " is damaged or cut off");
  }

  void
  skipElement(const PlyElement& element)
  {
    // Rows without properties take no bytes: nothing to step over, however many.
    const std::size_t rows = element.properties.empty() ? 0 : element.rows;
    for (std::size_t row = 0; row < rows; ++row)
      for (const PlyProperty& property : element.properties)
        check(values_.skipProperty(property), element, row);
  }

  /** All but lists; "diffuse_red" is what old programs call "red". */
  static std::vector<SourceColumn>
  columnsOf(const PlyElement& element)
  {
    const std::string diffuse = "diffuse_";
    const auto& properties = element.properties;
    const bool has_red =
        std::any_of(properties.begin(), properties.end(), [](const auto& property) {
          return property.name == "red";
        });
    std::vector<SourceColumn> columns;
    for (const PlyProperty& property : properties) {
      std::string name = property.name;
      if (!has_red && (name == diffuse + "red" || name == diffuse + "green" ||
                       name == diffuse + "blue"))
        name = name.substr(diffuse.size());
      if (!property.isList())
        columns.push_back({name, property.type, 1});
    }
    return columns;
  }

  /** The rows without their lists, which a cloud cannot hold. */
  std::string
  rowsWithoutLists(const PlyElement& element)
  {
    model_.warnings.push_back("lists of numbers at vertices are not taken over");
    std::string rows;
    for (std::size_t row = 0; row < element.rows; ++row)
      for (const PlyProperty& property : element.properties) {
        const char* const first = scanner_.position();
        check(values_.skipProperty(property), element, row);
        if (!property.isList())
          rows.append(first, scanner_.position());
      }
    return rows;
  }

  void
  readVertices(const PlyElement& element)
  {
    std::vector<SourceColumn> columns = columnsOf(element);
    std::string copy;
    TextScanner rows = scanner_;
    const bool has_list = columns.size() < element.properties.size();
    if (has_list) {
      copy = rowsWithoutLists(element);
      rows = TextScanner(copy);
    }
    PointRecords records;
    records.is_text = header_.format == PlyFormat::ASCII;
    records.swapped = header_.format == PlyFormat::BINARY_BIG;
    if (records.is_text)
      widenForText(rows, element.rows, columns);
    records.plan = planTable(columns, Naming::PLY);
    records.rows = rows;
    records.left = element.rows;
    const std::size_t most = rows.remaining() / records.plan.source_stride;
    check(records.is_text || element.rows <= most, element, most);
    if (found_ != nullptr && !has_list) {
      *found_ = records;
      allocateCloud(records.plan, 0, model_.mesh.cloud);
      if (records.is_text)
        return skipElement(element);
      return scanner_.skip(element.rows * records.plan.source_stride);
    }
    records.decode(element.rows, model_.mesh.cloud);
    if (!has_list)
      scanner_ = records.rows;
  }

  /** PCL writes the sensor's place as an element of its own. */
  void
  readCamera(const PlyElement& element)
  {
    std::map<std::string, double> numbers;
    for (const PlyProperty& property : element.properties)
      check(property.isList() ? values_.skipProperty(property)
                              : values_.read(property.type, numbers[property.name]),
            element,
            0);
    takeCamera(numbers, model_);
  }

  void
  warnAboutFaceProperties(const PlyElement& element)
  {
    std::string names;
    for (const PlyProperty& property : element.properties)
      if (!isIndexList(property))
        addToList(names, property.name);
    if (!names.empty())
      model_.warnings.push_back("the faces' properties (" + names +
                                ") are not taken over");
  }

  void
  readFaces(const PlyElement& element)
  {
    const auto& properties = element.properties;
    if (element.rows > 0 &&
        std::none_of(properties.begin(), properties.end(), isIndexList))
      throw Failure("its faces have no list of vertex indices");
    warnAboutFaceProperties(element);
    PolygonBuilder builder(model_.mesh.polygons);
    // Faces of fewer corners than three take less room, but are not kept.
    constexpr std::size_t least_bytes = 4;
    model_.mesh.polygons.reserve(
        std::min(element.rows, scanner_.remaining() / least_bytes));
    std::vector<std::int64_t> corners;
    for (std::size_t row = 0; row < element.rows; ++row) {
      check(readFace(properties, corners), element, row);
      if (element.name == "face")
        builder.addPolygon(corners);
      else
        builder.addStrip(corners);
    }
    builder.finish(model_.warnings);
  }

  bool
  readFace(const std::vector<PlyProperty>& properties,
           std::vector<std::int64_t>& corners)
  {
    for (const PlyProperty& property : properties) {
      std::size_t count = 0;
      if (!isIndexList(property) ? !values_.skipProperty(property)
                                 : !values_.readCount(property, count))
        return false;
      if (!isIndexList(property))
        continue;
      corners.resize(count);
      for (std::int64_t& corner : corners)
        if (!values_.read(property.type, corner))
          return false;
    }
    return true;
  }

  TextScanner scanner_;
  Contents contents_;
  Model& model_;
  PointRecords* found_;
  PlyHeader header_;
  ValueReader values_;
};

} // namespace

void
readPly(const InputFile& file, Contents contents, Model& model)
{
  PlyParser(file, contents, model).run();
}

bool
findPlyRecords(const InputFile& file, PointRecords& records, Model& head)
{
  PlyParser(file, Contents::POINTS, head, &records).run();
  return !records.plan.slots.empty();
}

} // namespace app
