// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: consecutive reconstruction beside the field, and the table
// of the thesis. Nothing passes or fails.
#include <pcl/console/print.h>

#include "comparison.h"
#include "default_clouds.h"
#include "reconstruction.h"
#include "speedup_table.h"

#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr const char* HELP =
    R"(bench_ccaa [options] [CLOUD | list:NAME]...

CLOUD  FILE.ply, FILE.pcd, bumpy:N, office:SEED, aerial:SEED,
       sample:FILE:N:NOISE, noisy:FILE:SIGMA,
       thinned:FILE:SHARE:SIGMA, outliers:FILE:SHARE or graded:FILE:FACTOR
       (explained in input_clouds.h)
NAME   bunny, closed, igea or scenes: files below the folder PSR_SHARED_DATA
       (explained in default_clouds.h); without any cloud the first three

--repeats R    runs of each method, which take turns; the median counts (5)
--no-rivals    ours alone
--no-table     leave out the table of the thesis (T3.5-1)
--memory       print peak memory only; without any cloud of bumpy:5000000

Times are microseconds per point, search and normals included, file access
excluded, on one thread where nothing else is said; ratio is against ours.
used: points with a triangle. boundary, n-man, misor: edges with one triangle,
with more than two, with two that run the same way. cross: pairs of triangles
that meet where they should not. mean, max: distance of the triangles from the
reference mesh; far: triangles farther than 1.2 % from it; miss.: distance of
the reference from the result. Percentages are of the reference's diagonal.
)";

struct Settings {
  bench::ComparisonSettings comparison;
  bool help = false;
  bool table = true;
  bool memory = false;
  std::vector<std::string> clouds;
};

void
addClouds(const std::string& word, std::vector<std::string>& clouds)
{
  const std::string list = "list:";
  if (word.compare(0, list.size(), list) != 0) {
    clouds.push_back(word);
    return;
  }
  for (const std::string& cloud : bench::cloudList(word.substr(list.size())))
    clouds.push_back(cloud);
}

Settings
parse(int argc, char** argv)
{
  Settings settings;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--help")
      settings.help = true;
    else if (word == "--repeats" && i + 1 < argc)
      settings.comparison.repeats = std::stoul(argv[++i]);
    else if (word == "--no-rivals")
      settings.comparison.rivals = false;
    else if (word == "--no-table")
      settings.table = false;
    else if (word == "--memory")
      settings.memory = true;
    else if (word.compare(0, 1, "-") == 0)
      throw std::invalid_argument("unknown option " + word + ", see --help");
    else
      addClouds(word, settings.clouds);
  }
  if (settings.comparison.repeats == 0)
    throw std::invalid_argument("--repeats must be 1 or more");
  return settings;
}

void
printMemory(std::vector<std::string> clouds)
{
  if (clouds.empty())
    clouds = {"bumpy:5000000"};
  std::printf("peak memory above cloud and result, bytes/point\n");
  for (const std::string& word : clouds) {
    const bench::Cloud::Ptr cloud = bench::makeCloud(word);
    std::printf("  %-40s %9zu points %6.0f\n",
                bench::shortName(word).c_str(),
                cloud->size(),
                bench::peakBytesPerPoint(cloud));
    std::fflush(stdout);
  }
}

void
printTable(const Settings& settings)
{
  bench::printSpeedupHeadings();
  for (const std::string& word : settings.clouds)
    bench::printSpeedup(
        bench::shortName(word),
        bench::measureSpeedup(bench::makeCloud(word), settings.comparison.repeats));
}

void
run(Settings settings)
{
  if (settings.memory) {
    printMemory(settings.clouds);
    return;
  }
  if (settings.clouds.empty())
    for (const char* list : {"list:bunny", "list:closed", "list:igea"})
      addClouds(list, settings.clouds);
  if (settings.clouds.empty())
    throw std::runtime_error("no clouds: name some, or set PSR_SHARED_DATA");
  for (const std::string& word : settings.clouds)
    bench::print(bench::compare(word, settings.comparison));
  if (settings.table)
    printTable(settings);
}

} // namespace

int
main(int argc, char** argv)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ERROR);
  try {
    const Settings settings = parse(argc, argv);
    if (settings.help)
      std::printf("%s", HELP);
    else
      run(settings);
  }
  catch (const std::exception& problem) {
    std::fprintf(stderr, "bench_ccaa: %s\n", problem.what());
    return 1;
  }
}
