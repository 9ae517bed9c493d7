// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the mesh of a run tile by tile as files for others.
#include "out_of_core/shards.h"

#include "io/ply_camera.h"
#include "io/ply_header.h"
#include "io/point_columns.h"
#include "io/writers.h"
#include "out_of_core/input_order.h"
#include "out_of_core/repair_files.h"
#include "out_of_core/step_file.h"
#include "out_of_core/tile_points.h"
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <limits>

namespace app {
namespace {

namespace fs = std::filesystem;
using pcl::ccaa::WideIndex;

/** Appends records with the number of each. */
class ShardCloud {
public:
  explicit ShardCloud(const TilePlan& plan) : record_bytes_(plan.layout.point_step)
  {
    cloud = plan.layout;
    pcl::PCLPointField field;
    field.name = "vertex_id";
    while (findField(cloud, field.name))
      field.name += '_'; // the points have one of their own
    field.offset = cloud.point_step;
    field.datatype = pcl::PCLPointField::FLOAT64;
    field.count = 1;
    cloud.fields.push_back(field);
    cloud.point_step += sizeof(double);
  }

  void
  add(const std::uint8_t* record, WideIndex index)
  {
    const auto id = static_cast<double>(index);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(&id);
    cloud.data.insert(cloud.data.end(), record, record + record_bytes_);
    cloud.data.insert(cloud.data.end(), bytes, bytes + sizeof(id));
    ++cloud.width;
    cloud.row_step = cloud.width * cloud.point_step;
  }

  pcl::PCLPointCloud2 cloud;

private:
  std::size_t record_bytes_;
};

constexpr std::size_t FACE_BYTES = 1 + sizeof(CoreTriangle);

/** The remark of a shard that tells its run. */
std::string
keyRemark(const TilePlan& plan)
{
  return "run " + plan.key;
}

/** The head of a shard, which has to be whole and of this run.
 * \param[in,out] scanner stands behind it then */
PlyHeader
readShardHead(const TilePlan& plan,
              const std::string& path,
              const InputFile& file,
              TextScanner& scanner)
{
  PlyHeader header;
  try {
    header = readPlyHeader(scanner);
  }
  catch (const Failure& failure) {
    throw Failure("'" + path + "' is damaged: " + failure.what());
  }
  const std::vector<std::string>& infos = header.remarks.infos;
  if (std::find(infos.begin(), infos.end(), keyRemark(plan)) == infos.end())
    failAsForeign(path);
  std::size_t bytes = 0;
  for (const PlyElement& element : header.elements)
    for (const PlyProperty& property : element.properties)
      bytes +=
          element.rows * (property.isList() ? FACE_BYTES : scalarSize(property.type));
  if (bytes != static_cast<std::size_t>(file.end() - scanner.position()))
    throw Failure("'" + path + "' is cut off");
  return header;
}

/** A shard as writeShard() wrote it. */
TileSurface
readShard(const TilePlan& plan, std::size_t tile)
{
  const std::string path = plan.file(tile, SHARD_STEP);
  InputFile file;
  require(file.open(path));
  TextScanner scanner(file.bytes());
  const PlyHeader header = readShardHead(plan, path, file, scanner);
  std::size_t record = 0;
  for (const PlyProperty& property : header.elements.front().properties)
    record += scalarSize(property.type);
  const std::size_t own = plan.tiling.tiles[tile].count;
  TileSurface surface;
  for (std::size_t i = own; i < header.elements.front().rows; ++i) {
    double id = 0.0;
    std::memcpy(&id, scanner.position() + (i + 1) * record - sizeof(id), sizeof(id));
    surface.foreign.push_back(static_cast<WideIndex>(id));
  }
  surface.triangles.resize(header.elements.back().rows);
  const char* face = file.end() - surface.triangles.size() * FACE_BYTES;
  for (CoreTriangle& triangle : surface.triangles) {
    std::memcpy(triangle.data(), face + 1, sizeof(triangle));
    face += FACE_BYTES;
  }
  return surface;
}

/** The final triangles of a tile. */
TileSurface
finalSurface(const TilePlan& plan, std::size_t tile)
{
  return fs::exists(plan.file(tile, SHARD_STEP)) ? readShard(plan, tile)
                                                 : readRepairedSurface(plan, tile);
}

void
addNowhere(const TilePlan& plan, InputOrder& order)
{
  StepReader reader(plan.file(NOWHERE_FILE), plan.key);
  const auto sources = reader.getAll<PointSource>();
  const auto records = reader.getAll<char>();
  order.add(
      sources.size(),
      [&](std::size_t i) { return &records[i * plan.layout.point_step]; },
      [&](std::size_t i) { return sources[i]; });
}

/** The first of the corners of a tile that a repair has made. */
std::vector<WideIndex>::const_iterator
firstNew(const TilePlan& plan, const TileSurface& surface)
{
  return std::lower_bound(
      surface.foreign.begin(), surface.foreign.end(), plan.pointsInTiles());
}

/** The triangles of a tile in places of the merged file. */
void
writeFaces(const TilePlan& plan,
           std::size_t tile,
           const InputOrder& order,
           PlyParts& parts)
{
  const TileSurface surface = finalSurface(plan, tile);
  std::vector<std::uint32_t> places;
  {
    const TilePoints points(plan, tile);
    for (std::size_t i = 0; i < points.size(); ++i)
      places.push_back(static_cast<std::uint32_t>(order.placeOf(points.source(i))));
  }
  const auto first_new = firstNew(plan, surface);
  forPoints(plan,
            surface.foreign.begin(),
            first_new,
            [&](auto, const TilePoints& points, std::size_t i) {
              places.push_back(
                  static_cast<std::uint32_t>(order.placeOf(points.source(i))));
            });
  for (auto vertex = first_new; vertex != surface.foreign.end(); ++vertex)
    places.push_back(static_cast<std::uint32_t>(*vertex + plan.nowhere));
  for (const CoreTriangle& triangle : surface.triangles) {
    const CoreTriangle corners{
        places[triangle[0]], places[triangle[1]], places[triangle[2]]};
    parts.faceBytes(corners.data(), corners.size());
  }
}

/** The points that repairing a tile has made. */
pcl::PCLPointCloud2
newVertices(const TilePlan& plan, std::size_t tile)
{
  const std::vector<char> records = readStayingPatches(plan, tile).records;
  pcl::PCLPointCloud2 cloud = plan.layout;
  cloud.data.assign(records.begin(), records.end());
  cloud.width = static_cast<pcl::uindex_t>(records.size() / cloud.point_step);
  cloud.height = 1;
  cloud.row_step = cloud.width * cloud.point_step;
  return cloud;
}

FileExtras
extrasOf(const TilePlan& plan)
{
  FileExtras extras;
  extras.viewpoint = plan.viewpoint;
  return extras;
}

} // namespace

bool
hasShard(const TilePlan& plan, std::size_t tile)
{
  const std::string path = plan.file(tile, SHARD_STEP);
  if (!fs::exists(path))
    return false;
  InputFile file;
  require(file.open(path));
  TextScanner scanner(file.bytes());
  readShardHead(plan, path, file, scanner);
  return true;
}

void
writeShard(const TilePlan& plan, std::size_t tile)
{
  const std::string path = plan.file(tile, SHARD_STEP);
  if (hasShard(plan, tile))
    return;
  const TileSurface surface = readRepairedSurface(plan, tile);
  ShardCloud shard(plan);
  const pcl::ccaa::Tile& own = plan.tiling.tiles[tile];
  {
    const TilePoints points(plan, tile);
    shard.cloud.data.reserve(points.size() * shard.cloud.point_step);
    for (std::size_t i = 0; i < points.size(); ++i)
      shard.add(points.record(i), own.first + i);
  }
  std::size_t next = 0;
  const auto first_new = firstNew(plan, surface);
  forPoints(plan,
            surface.foreign.begin(),
            first_new,
            [&](auto, const TilePoints& points, std::size_t i) {
              shard.add(points.record(i), surface.foreign[next++]);
            });
  if (first_new != surface.foreign.end()) {
    const std::vector<char> records = readStayingPatches(plan, tile).records;
    const char* record = records.data();
    for (auto vertex = first_new; vertex != surface.foreign.end(); ++vertex) {
      shard.add(reinterpret_cast<const std::uint8_t*>(record), *vertex);
      record += plan.layout.point_step;
    }
  }
  OutputFile file;
  require(file.open(path));
  PlyCounts counts;
  counts.vertices = shard.cloud.width;
  counts.faces = surface.triangles.size();
  FileExtras extras = extrasOf(plan);
  extras.remarks.infos.push_back(keyRemark(plan));
  PlyParts parts(shard.cloud, counts, extras, file);
  parts.points(shard.cloud);
  if (plan.viewpoint.isTold())
    writeCamera(plan.viewpoint, shard.cloud, file);
  for (const CoreTriangle& triangle : surface.triangles)
    parts.faceBytes(triangle.data(), triangle.size());
  require(file.commit());
}

std::size_t
countTriangles(const TilePlan& plan, std::size_t tile)
{
  const std::string path = plan.file(tile, SHARD_STEP);
  InputFile file;
  if (!fs::exists(path))
    return readRepairedSurface(plan, tile).triangles.size();
  require(file.open(path));
  TextScanner scanner(file.bytes());
  return readShardHead(plan, path, file, scanner).elements.back().rows;
}

std::uint64_t
countTriangles(const TilePlan& plan)
{
  std::uint64_t count = 0;
  for (std::size_t tile = 0; tile < plan.tiling.tiles.size(); ++tile)
    count += countTriangles(plan, tile);
  return count;
}

void
mergeTiles(const TilePlan& plan, std::uint64_t triangles, bool keeps, OutputFile& file)
{
  InputOrder order(plan);
  PlyCounts counts;
  counts.vertices = plan.points();
  if (plan.repairs())
    counts.vertices += readNumbers(plan).sum.vertices;
  if (counts.vertices > std::numeric_limits<std::uint32_t>::max())
    throw Failure("a PLY file numbers 2^32 points at most; the shards in '" +
                  plan.folder + "' hold the whole");
  counts.faces = triangles;
  for (std::size_t tile = 0; tile < plan.tiling.tiles.size(); ++tile) {
    const TilePoints points(plan, tile);
    order.add(
        points.size(),
        [&](std::size_t i) { return points.record(i); },
        [&](std::size_t i) { return points.source(i); });
  }
  addNowhere(plan, order);
  PlyParts parts(plan.layout, counts, extrasOf(plan), file);
  order.takeWindows([&](const pcl::PCLPointCloud2& cloud) { parts.points(cloud); });
  if (plan.repairs())
    for (std::size_t tile = 0; tile < plan.tiling.tiles.size(); ++tile)
      parts.points(newVertices(plan, tile));
  if (plan.viewpoint.isTold())
    writeCamera(plan.viewpoint, plan.layout, file);
  for (std::size_t tile = 0; tile < plan.tiling.tiles.size(); ++tile) {
    writeFaces(plan, tile, order, parts);
    if (!keeps)
      fs::remove(plan.file(tile, PIECES_STEP));
  }
}

} // namespace app
