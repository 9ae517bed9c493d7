// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what all steps of a run tile by tile know.
#include "out_of_core/tile_plan.h"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/nil_generator.hpp>
#include <boost/uuid/string_generator.hpp>
#include <boost/uuid/uuid_io.hpp>

#include "io/output_file.h"
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace app {
namespace {

using Json = nlohmann::json;

template <typename Vector>
Json
toJson(const Vector& vector)
{
  return {vector[0], vector[1], vector[2]};
}

Eigen::Vector3d
vectorOf(const Json& json)
{
  return Eigen::Vector3d(json.at(0).get<double>(), json.at(1), json.at(2));
}

std::optional<Eigen::Vector3d>
optionalVector(const Json& json)
{
  return json.is_null() ? std::nullopt : std::make_optional(vectorOf(json));
}

Json
optionalJson(const std::optional<Eigen::Vector3d>& vector)
{
  return vector ? toJson(*vector) : Json();
}

/** Null for an empty box. */
Json
boxJson(const pcl::ccaa::Box& box)
{
  return box.isEmpty() ? Json() : Json{toJson(box.min()), toJson(box.max())};
}

Json
describeFields(const pcl::PCLPointCloud2& layout)
{
  Json fields;
  for (const pcl::PCLPointField& field : layout.fields)
    fields.push_back({field.name, field.offset, field.datatype, field.count});
  return fields;
}

pcl::PCLPointCloud2
layoutOf(const Json& fields, std::uint32_t point_step)
{
  pcl::PCLPointCloud2 layout;
  for (const Json& json : fields) {
    pcl::PCLPointField field;
    field.name = json.at(0);
    field.offset = json.at(1);
    field.datatype = json.at(2);
    field.count = json.at(3);
    layout.fields.push_back(field);
  }
  layout.point_step = point_step;
  layout.height = 1;
  return layout;
}

Json
listTiles(const TilePlan& plan)
{
  Json tiles = Json::array();
  for (std::size_t i = 0; i < plan.tiling.tiles.size(); ++i) {
    const pcl::ccaa::Tile& tile = plan.tiling.tiles[i];
    tiles.push_back({{"min", toJson(tile.box.min())},
                     {"max", toJson(tile.box.max())},
                     {"first", tile.first},
                     {"points", tile.count},
                     {"halo", tile.halo},
                     {"sparse", boxJson(tile.sparse)},
                     {"corner", toJson(plan.corners[i])}});
  }
  return tiles;
}

void
readTiles(const Json& tiles, TilePlan& plan)
{
  for (const Json& json : tiles) {
    pcl::ccaa::Tile tile;
    tile.box = {vectorOf(json.at("min")), vectorOf(json.at("max"))};
    tile.first = json.at("first");
    tile.count = json.at("points");
    tile.halo = json.at("halo");
    if (const Json& sparse = json.at("sparse"); !sparse.is_null())
      tile.sparse = {vectorOf(sparse.at(0)), vectorOf(sparse.at(1))};
    plan.tiling.tiles.push_back(tile);
    plan.corners.push_back(vectorOf(json.at("corner")));
  }
}

TilePlan
planOf(const Json& json)
{
  TilePlan plan;
  plan.key = json.at("key");
  plan.settings = json.at("settings").dump();
  plan.most_points = json.at("most_points");
  for (const Json& input : json.at("inputs"))
    plan.inputs.push_back({input.at("path"),
                           input.at("bytes"),
                           input.at("points"),
                           input.at("hash"),
                           input.at("changed")});
  placeInputs(plan, plan.inputs);
  plan.layout = layoutOf(json.at("fields"), json.at("point_step"));
  if (const auto place = optionalVector(json.at("viewpoint"))) {
    plan.viewpoint.known = true;
    plan.viewpoint.position = *place;
  }
  plan.warnings = json.at("warnings").get<Warnings>();
  plan.step = json.at("step");
  plan.origin = vectorOf(json.at("origin"));
  plan.nowhere = json.at("nowhere");
  readTiles(json.at("tiles"), plan);
  return plan;
}

} // namespace

std::uint64_t
TilePlan::points() const
{
  std::uint64_t sum = nowhere;
  for (const pcl::ccaa::Tile& tile : tiling.tiles)
    sum += tile.count;
  return sum;
}

bool
TilePlan::repairs() const
{
  return settingsOf(*this).repair;
}

std::string
TilePlan::file(std::size_t tile, const char* step_name) const
{
  std::string number = std::to_string(tile);
  number.insert(0, number.size() < 6 ? 6 - number.size() : 0, '0');
  return (std::filesystem::path(folder) / (number + "." + step_name)).string();
}

std::string
TilePlan::file(const char* name) const
{
  return (std::filesystem::path(folder) / name).string();
}

void
placeInputs(TilePlan& plan, const std::vector<TileInput>& order)
{
  std::uint64_t first = 0;
  for (const TileInput& next : order)
    for (TileInput& input : plan.inputs)
      if (input.path == next.path) {
        input.first = first;
        first += input.points;
      }
}

void
writePlan(const TilePlan& plan)
{
  Json inputs = Json::array();
  for (const TileInput& input : plan.inputs)
    inputs.push_back({{"path", input.path},
                      {"bytes", input.bytes},
                      {"points", input.points},
                      {"hash", input.hash},
                      {"changed", input.changed}});
  const Json json = {
      {"key", plan.key},
      {"version", version()},
      {"settings", Json::parse(plan.settings)},
      {"most_points", plan.most_points},
      {"inputs", inputs},
      {"fields", describeFields(plan.layout)},
      {"point_step", plan.layout.point_step},
      {"viewpoint", plan.viewpoint.known ? toJson(plan.viewpoint.position) : Json()},
      {"warnings", plan.warnings},
      {"step", plan.step},
      {"origin", toJson(plan.origin)},
      {"nowhere", plan.nowhere},
      {"tiles", listTiles(plan)}};
  OutputFile file;
  require(file.open(plan.file(PLAN_FILE)));
  file.text(json.dump(1) + "\n");
  require(file.commit());
}

TilePlan
readPlan(const std::string& folder)
{
  const std::string path = (std::filesystem::path(folder) / PLAN_FILE).string();
  std::ifstream stream(path);
  if (!stream)
    throw Failure("'" + path + "' is not there: the cloud has not been cut into tiles");
  try {
    const Json json = Json::parse(stream);
    if (json.at("version") != version())
      throw Failure("'" + path + "' was made by version " +
                    json.at("version").get<std::string>() + ", this is " + version());
    TilePlan plan = planOf(json);
    plan.folder = folder;
    return plan;
  }
  catch (const Json::exception& problem) {
    throw Failure("'" + path + "' is damaged: " + problem.what());
  }
}

std::string
settingsText(const ReconstructSettings& settings)
{
  Json json = {{"neighbors", settings.neighbors},
               {"min_region", settings.minimum_internal_points},
               {"min_angle", settings.minimum_angle},
               {"certified_angle", settings.certified_minimum_angle},
               {"max_length", settings.length_factor},
               {"plain", settings.plain},
               {"viewpoint", optionalJson(settings.sides.told_viewpoint)},
               {"up", optionalJson(settings.sides.up)}};
  if (settings.repair)
    json["repair"] = {
        {"close", settings.method.filling.close},
        {"watertight", settings.method.watertight},
        {"cap", settings.method.filling.cap},
        {"greatest_hole", settings.method.filling.greatest_hole},
        {"greatest_length", settings.method.filling.greatest_length.value},
        {"greatest_bridge", settings.method.survey.greatest_bridge.value}};
  return json.dump();
}

ReconstructSettings
settingsOf(const TilePlan& plan)
{
  const Json json = Json::parse(plan.settings);
  ReconstructSettings settings;
  settings.neighbors = json.at("neighbors");
  settings.minimum_internal_points = json.at("min_region");
  settings.minimum_angle = json.at("min_angle");
  settings.certified_minimum_angle = json.at("certified_angle");
  settings.length_factor = json.at("max_length");
  settings.plain = json.at("plain");
  settings.sides.told_viewpoint = optionalVector(json.at("viewpoint"));
  settings.sides.up = optionalVector(json.at("up"));
  settings.repair = json.contains("repair");
  if (!settings.repair)
    return settings;
  const Json& repair = json["repair"];
  settings.method.filling.close = repair.at("close");
  settings.method.watertight = repair.at("watertight");
  settings.method.filling.cap = repair.at("cap");
  settings.method.filling.greatest_hole = repair.at("greatest_hole");
  settings.method.filling.greatest_length.value = repair.at("greatest_length");
  settings.method.survey.greatest_bridge.value = repair.at("greatest_bridge");
  return settings;
}

std::string
hashOf(const std::string& before, const void* bytes, std::size_t count)
{
  const boost::uuids::uuid space = before.empty()
                                       ? boost::uuids::nil_uuid()
                                       : boost::uuids::string_generator()(before);
  return to_string(boost::uuids::name_generator_sha1(space)(bytes, count));
}

} // namespace app
