// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the clouds that benchmarks run on when none is named.
#include "default_clouds.h"

#include <cstdlib>
#include <filesystem>
#include <map>
#include <stdexcept>

namespace bench {
namespace {

/** What makeCloud() makes of a file: the words before and after its name. */
struct Recipe {
  std::string kind;
  std::string file;
  std::string numbers;
};

const std::map<std::string, std::vector<Recipe>> lists = {
    {"bunny", {{"", "bunny/bun_zipper.ply", ""}}},
    {"closed",
     {{"", "armadillo/armadillo.ply", ""},
      {"", "igea/igea.ply", ""},
      {"", "horse/horse.ply", ""},
      {"", "rocker_arm/rockerArm.ply", ""},
      {"", "skull/skull.ply", ""},
      {"", "lordquas/lordquas.ply", ""},
      {"", "cad_daratech/daratech.ply", ""},
      {"", "fandisk/fandisk_large.ply", ""}}},
    {"igea",
     {{"noisy:", "igea/igea.ply", ":0.1"},
      {"noisy:", "igea/igea.ply", ":0.3"},
      {"thinned:", "igea/igea.ply", ":0.5:0.3"},
      {"outliers:", "igea/igea.ply", ":0.02"},
      {"outliers:", "igea/igea.ply", ":0.1"},
      {"graded:", "igea/igea.ply", ":20"}}},
    {"scenes",
     {{"", "bunny_scans/bunny_scans_registered.ply", ""},
      {"", "pcl_scenes/table_scene_lms400.ply", ""},
      {"", "building/building.ply", ""},
      {"", "rgbd_room/fragment_002.ply", ""},
      {"", "range_maps/lato000.ply", ""},
      {"", "range_maps/lato180.ply", ""},
      {"", "aerial/b9_training.ply", ""},
      {"", "aerial/samp53.ply", ""}}}};

std::string
dataFolder()
{
  const char* folder = std::getenv("PSR_SHARED_DATA");
  return folder != nullptr ? folder : PSR_SHARED_DATA_DIR;
}

} // namespace

std::vector<std::string>
cloudList(const std::string& name)
{
  const auto list = lists.find(name);
  if (list == lists.end())
    throw std::invalid_argument("no list of clouds called " + name);
  std::vector<std::string> words;
  for (const Recipe& recipe : list->second) {
    const std::string file = dataFolder() + "/" + recipe.file;
    if (std::filesystem::exists(file))
      words.push_back(recipe.kind + file + recipe.numbers);
  }
  return words;
}

} // namespace bench
