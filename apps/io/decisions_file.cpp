// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a user's decisions about a repair, as a JSON file.
#include "decisions_file.h"

#include <pcl/surface_repair/repair_report.h>

#include "input_file.h"
#include "model_io.h"
#include "wording.h"
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <map>

namespace app {
namespace {

using Json = nlohmann::ordered_json;
using pcl::OpenReason;
using pcl::repair::Decisions;
using pcl::repair::JunctionDecision;
using pcl::repair::LoopDecision;
using pcl::repair::LoopWish;

constexpr const char* FORMAT = "decisions of pcl_repair_holes";
constexpr const char* JOIN = "join";
constexpr const char* DO_NOT_JOIN = "do not join";

constexpr Word<LoopWish> WISHES[] = {{"close", LoopWish::CLOSE},
                                     {"leave open", LoopWish::LEAVE_OPEN},
                                     {"auto", LoopWish::AUTO}};

template <typename Value, std::size_t Size>
Json
allWords(const Word<Value> (&words)[Size])
{
  Json list = Json::array();
  for (const Word<Value>& word : words)
    list.push_back(word.word);
  return list;
}

template <typename Value, std::size_t Size>
Value
valueOf(const Word<Value> (&words)[Size], const Json& entry, const char* key)
{
  const std::string text = entry.at(key).get<std::string>();
  for (const Word<Value>& word : words)
    if (text == word.word)
      return word.value;
  throw Failure("'" + text + "' is no " + key + " of a boundary loop; there are " +
                allWords(words).dump());
}

const char*
reasonOf(const LoopDecision& loop)
{
  if (loop.joined)
    return "bridges join it to others";
  return loop.reason == OpenReason::NONE ? "it can be closed" : describe(loop.reason);
}

Json
describeLoop(std::size_t number, const LoopDecision& loop)
{
  const pcl::repair::Position& center = loop.key.center;
  return {{"loop", number},
          {"decision", wordFor(WISHES, loop.wish)},
          {"cap", wordFor(CAPS, loop.cap)},
          {"class", describe(loop.found)},
          {"confidence", loop.confidence},
          {"reason", reasonOf(loop)},
          {"edges", loop.key.edges},
          {"length", loop.length},
          {"island", loop.island},
          {"point", loop.key.point},
          {"center", {center.x(), center.y(), center.z()}}};
}

Json
describeJunction(std::size_t number, const JunctionDecision& junction)
{
  return {{"junction", number},
          {"decision", junction.join ? JOIN : DO_NOT_JOIN},
          {"loops", {junction.first_loop, junction.second_loop}},
          {"confidence", junction.confidence},
          {"reason", describe(junction.verdict)},
          {"bridges", junction.bridges},
          {"shortest_bridge", junction.shortest},
          {"quality", junction.quality}};
}

LoopDecision
takeLoop(const Json& entry)
{
  LoopDecision loop;
  loop.wish = valueOf(WISHES, entry, "decision");
  loop.cap = valueOf(CAPS, entry, "cap");
  entry.at("edges").get_to(loop.key.edges);
  entry.at("point").get_to(loop.key.point);
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    entry.at("center").at(static_cast<std::size_t>(axis)).get_to(loop.key.center[axis]);
  return loop;
}

JunctionDecision
takeJunction(const Json& entry, const std::map<std::size_t, std::size_t>& index_of)
{
  JunctionDecision junction;
  const std::string text = entry.at("decision").get<std::string>();
  if (text != JOIN && text != DO_NOT_JOIN)
    throw Failure("'" + text + "' is no decision about a junction; there are \"" +
                  JOIN + "\" and \"" + DO_NOT_JOIN + "\"");
  junction.join = text == JOIN;
  const auto loop = [&](std::size_t end) {
    const auto number = entry.at("loops").at(end).get<std::size_t>();
    const auto found = index_of.find(number);
    if (found == index_of.end())
      throw Failure("a junction refers to loop " + std::to_string(number) +
                    ", which is not listed");
    return found->second;
  };
  junction.first_loop = loop(0);
  junction.second_loop = loop(1);
  return junction;
}

/** \brief Throws what nlohmann::json does, and Failure. */
Decisions
takeDecisions(const Json& document)
{
  if (!document.is_object() || document.value("format", "") != FORMAT)
    throw Failure("it is no file of decisions");
  Decisions decisions;
  const Json& mesh = document.at("mesh");
  mesh.at("points").get_to(decisions.mesh.points);
  mesh.at("polygons").get_to(decisions.mesh.polygons);
  decisions.mesh.checksum =
      std::strtoull(mesh.at("checksum").get<std::string>().c_str(), nullptr, 16);
  std::map<std::size_t, std::size_t> index_of;
  for (const Json& entry : document.at("loops")) {
    index_of.emplace(entry.at("loop").get<std::size_t>(), decisions.loops.size());
    decisions.loops.push_back(takeLoop(entry));
  }
  for (const Json& entry : document.at("junctions"))
    decisions.junctions.push_back(takeJunction(entry, index_of));
  return decisions;
}

} // namespace

DecisionsPtr
parseDecisions(const std::string& text)
{
  return std::make_shared<const Decisions>(takeDecisions(Json::parse(text)));
}

Status
readDecisions(const std::string& path, DecisionsPtr& decisions)
{
  InputFile file;
  const Status status = file.open(path);
  if (!status.ok())
    return status;
  try {
    decisions = parseDecisions({file.begin(), file.end()});
  }
  catch (const std::exception& error) {
    return Status::error(nameForPeople(path) + ": " + error.what());
  }
  return {};
}

Status
readDecisionsIfAny(const std::string& path, DecisionsPtr& decisions)
{
  std::error_code ignored;
  if (path.empty() || isStandardStream(path) || !std::filesystem::exists(path, ignored))
    return {};
  return readDecisions(path, decisions);
}

std::string
tellLoop(std::size_t number, const LoopDecision& loop)
{
  return "Loop " + std::to_string(number) + ": " + wordFor(WISHES, loop.wish) +
         ", cap " + wordFor(CAPS, loop.cap) + ". It is of class " +
         describe(loop.found) + ", of " + plural(loop.key.edges, "edge") + "; " +
         reasonOf(loop) + ".";
}

std::string
tellJunction(std::size_t number, const JunctionDecision& junction)
{
  return "Junction J" + std::to_string(number) + " of loops " +
         std::to_string(junction.first_loop) + " and " +
         std::to_string(junction.second_loop) + ": " +
         (junction.join ? JOIN : DO_NOT_JOIN) +
         ". By evidence: " + describe(junction.verdict) + "; " +
         plural(junction.bridges, "bridge") + ".";
}

std::string
decisionsText(const std::string& input, const Decisions& decisions)
{
  const std::string checksum =
      formatted("%016llx", static_cast<unsigned long long>(decisions.mesh.checksum));
  Json document = {{"format", FORMAT},
                   {"mesh",
                    {{"file", input},
                     {"points", decisions.mesh.points},
                     {"polygons", decisions.mesh.polygons},
                     {"checksum", checksum}}},
                   {"choices",
                    {{"loop", allWords(WISHES)},
                     {"cap", allWords(CAPS)},
                     {"junction", {JOIN, DO_NOT_JOIN}}}}};
  Json loops = Json::array();
  for (std::size_t k = 0; k < decisions.loops.size(); ++k)
    loops.push_back(describeLoop(k, decisions.loops[k]));
  Json junctions = Json::array();
  for (std::size_t k = 0; k < decisions.junctions.size(); ++k)
    junctions.push_back(describeJunction(k, decisions.junctions[k]));
  document["loops"] = std::move(loops);
  document["junctions"] = std::move(junctions);
  // File names need not be valid UTF-8.
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void
writeDecisions(const std::string& input, const Decisions& decisions, OutputFile& file)
{
  file.text(decisionsText(input, decisions));
}

} // namespace app
