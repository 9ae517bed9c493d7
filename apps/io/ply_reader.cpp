// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reads PLY, ASCII and binary of both byte orders.
#include "ply_reader.h"

#include "ply_header.h"
#include "point_columns.h"
#include "point_table.h"
#include "polygon_builder.h"

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
    if (is_text_) {
      std::string_view word;
      return scanner_.nextWord(word) && parseNumber(word, value);
    }
    const std::size_t bytes = scalarSize(type);
    if (scanner_.remaining() < bytes)
      return false;
    value = loadScalarAs<T>(scanner_.position(), type, swapped_);
    scanner_.skip(bytes);
    return true;
  }

  /** A word straight into the \a point, bytes into the \a record. */
  bool
  readInto(const Slot& slot, std::uint8_t* point, char* record)
  {
    if (is_text_) {
      std::string_view word;
      return scanner_.nextWord(word) &&
             decodeWord(word, slot.target_type, point + slot.target_offset);
    }
    const std::size_t bytes = scalarSize(slot.source_type);
    if (scanner_.remaining() < bytes)
      return false;
    std::copy_n(scanner_.position(), bytes, record + slot.source_offset);
    scanner_.skip(bytes);
    return true;
  }

  bool
  skip(ScalarType type, std::size_t count)
  {
    if (!is_text_) {
      const std::size_t bytes = scalarSize(type);
      if (count > scanner_.remaining() / bytes)
        return false;
      scanner_.skip(count * bytes);
      return true;
    }
    std::string_view word;
    for (std::size_t i = 0; i < count; ++i)
      if (!scanner_.nextWord(word))
        return false;
    return true;
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
    if (property.isList() && !readCount(property, count))
      return false;
    return skip(property.type, count);
  }

private:
  TextScanner& scanner_;
  bool is_text_;
  bool swapped_;
};

class PlyParser {
public:
  PlyParser(const InputFile& file, Contents contents, Model& model)
  : scanner_(file.begin(), file.end()), contents_(contents), model_(model)
  {}

  Status
  run()
  {
    Status status = readPlyHeader(scanner_, header_);
    model_.remarks = header_.remarks;
    const std::size_t wanted = wantedElements();
    bool has_vertices = false;
    for (std::size_t i = 0; status.ok() && i < wanted; ++i) {
      const PlyElement& element = header_.elements[i];
      if (has_vertices && element.name == "vertex")
        return Status::error("it has two elements 'vertex'");
      status = readElement(element);
      has_vertices = has_vertices || element.name == "vertex";
    }
    if (status.ok() && !has_vertices)
      return Status::error("it has no vertices");
    return status;
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

  Status
  readElement(const PlyElement& element)
  {
    if (element.name == "vertex")
      return readVertices(element);
    if (element.name == "camera" && element.rows == 1)
      return readCamera(element);
    const bool wants_faces = contents_ == Contents::POINTS_AND_POLYGONS;
    if (wants_faces && (element.name == "face" || element.name == "tristrips"))
      return readFaces(element);
    return skipElement(element);
  }

  Status
  truncated(const PlyElement& element, std::size_t row) const
  {
    return Status::error("its " + element.name + " " + std::to_string(row) + " of " +
                         std::to_string(element.rows) + " is damaged or cut off");
  }

  Status
  skipElement(const PlyElement& element)
  {
    ValueReader values(scanner_, header_.format);
    // Rows without properties take no bytes: nothing to step over, however many.
    const std::size_t rows = element.properties.empty() ? 0 : element.rows;
    for (std::size_t row = 0; row < rows; ++row)
      for (const PlyProperty& property : element.properties)
        if (!values.skipProperty(property))
          return truncated(element, row);
    return {};
  }

  /** All but lists; "diffuse_red" is what old programs call "red". */
  static std::vector<SourceColumn>
  columnsOf(const PlyElement& element)
  {
    const auto& properties = element.properties;
    const bool has_red =
        std::any_of(properties.begin(), properties.end(), [](const auto& property) {
          return property.name == "red";
        });
    std::vector<SourceColumn> columns;
    for (const PlyProperty& property : properties) {
      std::string name = property.name;
      if (!has_red &&
          (name == "diffuse_red" || name == "diffuse_green" || name == "diffuse_blue"))
        name = name.substr(std::string("diffuse_").size());
      if (!property.isList())
        columns.push_back({name, property.type, 1});
    }
    return columns;
  }

  /** Rows of different lengths: a cloud cannot hold their lists. */
  Status
  readRowsWithLists(const PlyElement& element, const TablePlan& plan)
  {
    model_.warnings.push_back("lists of numbers at vertices are not taken over");
    pcl::PCLPointCloud2& cloud = model_.mesh.cloud;
    ValueReader values(scanner_, header_.format);
    std::string record(plan.source_stride, '\0');
    for (std::size_t row = 0; row < element.rows; ++row) {
      std::uint8_t* const point = cloud.data.data() + row * plan.point_step;
      auto slot = plan.slots.begin();
      for (const PlyProperty& property : element.properties) {
        const bool good = property.isList()
                              ? values.skipProperty(property)
                              : values.readInto(*slot, point, record.data());
        if (!good)
          return truncated(element, row);
        slot += property.isList() ? 0 : 1;
      }
      if (header_.format != PlyFormat::ASCII)
        decodeRecord(
            plan, record.data(), header_.format == PlyFormat::BINARY_BIG, point);
    }
    return {};
  }

  Status
  readVertices(const PlyElement& element)
  {
    std::vector<SourceColumn> columns = columnsOf(element);
    const bool has_list = columns.size() < element.properties.size();
    if (header_.format == PlyFormat::ASCII && !has_list)
      widenForText(scanner_, element.rows, columns);
    TablePlan plan;
    Status status = planTable(columns, Naming::PLY, plan);
    pcl::PCLPointCloud2& cloud = model_.mesh.cloud;
    if (status.ok())
      status = allocateCloud(plan, element.rows, cloud);
    if (!status.ok())
      return status;
    if (has_list)
      return readRowsWithLists(element, plan);
    if (header_.format == PlyFormat::ASCII)
      return decodeText(plan, scanner_, cloud);
    if (element.rows > scanner_.remaining() / plan.source_stride)
      return truncated(element, scanner_.remaining() / plan.source_stride);
    decodeBinary(
        plan, scanner_.position(), header_.format == PlyFormat::BINARY_BIG, cloud);
    scanner_.skip(element.rows * plan.source_stride);
    return {};
  }

  /** PCL writes the sensor's place as an element of its own. */
  Status
  readCamera(const PlyElement& element)
  {
    ValueReader values(scanner_, header_.format);
    std::map<std::string, double> numbers;
    for (const PlyProperty& property : element.properties) {
      double value = 0;
      if (property.isList() ? !values.skipProperty(property)
                            : !values.read(property.type, value))
        return truncated(element, 0);
      numbers[property.name] = value;
    }
    placeCamera(numbers);
    organise(numbers["viewportx"], numbers["viewporty"]);
    return {};
  }

  /** PCL's size of the picture is that of an organised cloud. */
  void
  organise(double columns, double rows)
  {
    pcl::PCLPointCloud2& cloud = model_.mesh.cloud;
    constexpr double most = 1e6;
    if (!(columns >= 1 && columns <= most && rows >= 1 && rows <= most))
      return;
    const auto width = static_cast<std::uint64_t>(columns);
    const auto height = static_cast<std::uint64_t>(rows);
    if (width * height != pointCount(cloud))
      return;
    cloud.width = static_cast<pcl::uindex_t>(width);
    cloud.height = static_cast<pcl::uindex_t>(height);
    cloud.row_step = cloud.width * cloud.point_step;
  }

  void
  placeCamera(const std::map<std::string, double>& numbers)
  {
    const auto take = [&](const std::string& name, double& value) {
      const auto found = numbers.find(name);
      if (found != numbers.end())
        value = found->second;
      return found != numbers.end();
    };
    Viewpoint& viewpoint = model_.viewpoint;
    Eigen::Matrix3d axes;
    bool has_place = true;
    bool has_axes = true;
    for (int i = 0; i < 3; ++i) {
      const std::string name(1, "xyz"[i]);
      has_place = take("view_p" + name, viewpoint.position[i]) && has_place;
      for (int k = 0; k < 3; ++k)
        has_axes = take(name + "_axis" + "xyz"[k], axes(i, k)) && has_axes;
    }
    if (has_axes && axes.allFinite() && axes.isUnitary(1e-3))
      viewpoint.orientation =
          Eigen::Quaternionf(axes.cast<float>().eval()).normalized();
    // PCL writes the origin when it knows no better.
    viewpoint.may_be_origin = has_place && viewpoint.position.isZero(0);
    viewpoint.known =
        has_place && viewpoint.position.allFinite() && !viewpoint.may_be_origin;
  }

  static bool
  isIndexList(const PlyProperty& property)
  {
    const bool is_real = property.type == pcl::PCLPointField::FLOAT32 ||
                         property.type == pcl::PCLPointField::FLOAT64;
    return property.isList() && !is_real &&
           (property.name == "vertex_indices" || property.name == "vertex_index");
  }

  void
  warnAboutFaceProperties(const PlyElement& element)
  {
    std::string names;
    for (const PlyProperty& property : element.properties)
      if (!isIndexList(property))
        names += (names.empty() ? "" : ", ") + property.name;
    if (!names.empty())
      model_.warnings.push_back("the faces' properties (" + names +
                                ") are not taken over");
  }

  Status
  readFaces(const PlyElement& element)
  {
    const auto& properties = element.properties;
    if (element.rows > 0 &&
        std::none_of(properties.begin(), properties.end(), isIndexList))
      return Status::error("its faces have no list of vertex indices");
    warnAboutFaceProperties(element);
    ValueReader values(scanner_, header_.format);
    PolygonBuilder builder(model_.mesh.polygons);
    // Faces of fewer corners than three take less room, but are not kept.
    constexpr std::size_t least_bytes = 4;
    builder.reserve(std::min(element.rows, scanner_.remaining() / least_bytes));
    std::vector<std::int64_t> corners;
    for (std::size_t row = 0; row < element.rows; ++row) {
      if (!readFace(properties, values, corners))
        return truncated(element, row);
      if (element.name == "face")
        builder.addPolygon(corners);
      else
        builder.addStrip(corners);
    }
    return builder.finish(model_.warnings);
  }

  static bool
  readFace(const std::vector<PlyProperty>& properties,
           ValueReader& values,
           std::vector<std::int64_t>& corners)
  {
    for (const PlyProperty& property : properties) {
      if (!isIndexList(property)) {
        if (!values.skipProperty(property))
          return false;
        continue;
      }
      std::size_t count = 0;
      if (!values.readCount(property, count))
        return false;
      corners.resize(count);
      for (std::int64_t& corner : corners)
        if (!values.read(property.type, corner))
          return false;
    }
    return true;
  }

  TextScanner scanner_;
  Contents contents_;
  Model& model_;
  PlyHeader header_;
};

} // namespace

Status
readPly(const InputFile& file, Contents contents, Model& model)
{
  return PlyParser(file, contents, model).run();
}

} // namespace app
