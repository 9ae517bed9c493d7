// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: table of what start and filter cost, beside the field.
#include <pcl/console/print.h>
#include <pcl/search/kdtree.h>
#include <pcl/surface_ccaa/block_search.h>
#include <pcl/surface_ccaa/greedy_start.h>
#include <pcl/surface_ccaa/umbrella_filter.h>

#include "input_clouds.h"
#include "measuring.h"
#include "rivals.h"

#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr const char* HELP =
    "usage: bench_surface_ccaa [--repeats R] [--no-rivals] CLOUD...\n"
    "\n"
    "CLOUD is FILE.ply, FILE.pcd, bumpy:N, sample:FILE.ply:N:NOISE or another of the\n"
    "words of input_clouds.h. Prints microseconds per point, search included and file\n"
    "access excluded, the median of R interleaved runs (default 5). Nothing passes or\n"
    "fails.\n";

using bench::Cloud;
using bench::median;
using bench::secondsOf;
using Search = pcl::search::Search<pcl::PointXYZ>;

struct Settings {
  std::size_t repeats = 5;
  bool rivals = true;
  bool help = false;
  std::vector<std::string> clouds;
};

/** Seconds of one run of start and filter, stage by stage. */
struct StageTimes {
  double search = 0;
  double start = 0; /**< search included */
  double filter = 0;

  double
  total() const
  {
    return start + filter;
  }
};

struct Result {
  pcl::PolygonMesh::Ptr mesh;
  pcl::UmbrellaReport report;
  StageTimes times;
};

Result
startAndFilter(const Cloud::Ptr& cloud, const Search::Ptr& search, unsigned int threads)
{
  Result result;
  pcl::GreedyStart<pcl::PointXYZ> start;
  start.setInputCloud(cloud);
  start.setSearchMethod(search);
  start.setNumberOfThreads(threads);
  pcl::PolygonMesh::Ptr raw(new pcl::PolygonMesh);
  result.times.start = secondsOf([&] { start.reconstruct(*raw); });
  result.times.search = start.getReport().search_seconds;
  pcl::UmbrellaFilter filter;
  filter.setInputMesh(raw);
  filter.setNumberOfThreads(threads);
  result.mesh.reset(new pcl::PolygonMesh);
  result.times.filter = secondsOf([&] { filter.process(*result.mesh); });
  result.report = filter.getReport();
  return result;
}

/** Peak memory of a run above what was there before it and above its result. */
double
peakBytesPerPoint(const Cloud::Ptr& cloud)
{
  Result result;
  const double bytes = bench::peakBytesOf([&] {
    result = startAndFilter(
        cloud, std::make_shared<pcl::search::BlockSearch<pcl::PointXYZ>>(), 0);
  });
  return (bytes - double(bench::bytesOf(*result.mesh))) / double(cloud->size());
}

/** One way to run start and filter, timed over all repeats. */
struct Variant {
  std::string name;
  Search::Ptr search;
  unsigned int threads;
  std::vector<StageTimes> runs;

  double
  medianOf(double (*part)(const StageTimes&)) const
  {
    std::vector<double> values;
    for (const StageTimes& run : runs)
      values.push_back(part(run));
    return median(values);
  }
};

struct Rival {
  bench::Method method;
  std::vector<double> seconds;
  std::size_t found = 0;
};

std::vector<Rival>
rivalsFor(const Cloud::Ptr& cloud)
{
  std::vector<Rival> rivals;
  for (bench::Method& method : bench::rivalsFor(cloud))
    rivals.push_back({std::move(method), {}});
  return rivals;
}

void
printVariants(const std::vector<Variant>& variants, double micro)
{
  std::printf(
      "  %-26s %8s %8s %8s %8s\n", "us/point", "k-NN", "start", "filter", "all");
  for (const Variant& v : variants)
    std::printf("  %-26s %8.3f %8.3f %8.3f %8.3f\n",
                v.name.c_str(),
                micro * v.medianOf([](const StageTimes& t) { return t.search; }),
                micro * v.medianOf([](const StageTimes& t) { return t.start; }),
                micro * v.medianOf([](const StageTimes& t) { return t.filter; }),
                micro * v.medianOf([](const StageTimes& t) { return t.total(); }));
}

void
printRatios(const std::vector<Variant>& variants,
            const std::vector<Rival>& rivals,
            double micro)
{
  const auto total = [&](std::size_t v) {
    return variants[v].medianOf([](const StageTimes& t) { return t.total(); });
  };
  std::printf("  all threads against one: %.2fx (block search), %.2fx (KdTree)\n",
              total(0) / total(1),
              total(2) / total(3));
  for (const Rival& rival : rivals)
    std::printf("  %-26s %35.3f   %zu triangles: %.2fx ours with block search, %.2fx "
                "with KdTree\n",
                rival.method.name.c_str(),
                micro * median(rival.seconds),
                rival.found,
                median(rival.seconds) / total(0),
                median(rival.seconds) / total(2));
}

void
benchmark(const std::string& word, const Settings& settings)
{
  const Cloud::Ptr cloud = bench::makeCloud(word);
  using Blocks = pcl::search::BlockSearch<pcl::PointXYZ>;
  using KdTree = pcl::search::KdTree<pcl::PointXYZ>;
  const auto kdtree = [] { return std::make_shared<KdTree>(false); };
  std::vector<Variant> variants = {
      {"block search, 1 thread", std::make_shared<Blocks>(), 1, {}},
      {"block search, all threads", std::make_shared<Blocks>(), 0, {}},
      {"PCL KdTree, 1 thread", kdtree(), 1, {}},
      {"PCL KdTree, all threads", kdtree(), 0, {}}};
  std::vector<Rival> rivals = settings.rivals ? rivalsFor(cloud) : std::vector<Rival>();
  const double bytes = peakBytesPerPoint(cloud);
  pcl::UmbrellaReport report;
  for (std::size_t r = 0; r < settings.repeats; ++r) {
    for (Variant& variant : variants) {
      const Result result = startAndFilter(cloud, variant.search, variant.threads);
      variant.runs.push_back(result.times);
      report = result.report;
    }
    for (Rival& rival : rivals) {
      const bench::Reconstruction result = rival.method.run();
      rival.seconds.push_back(result.seconds);
      rival.found = result.triangles.size();
    }
  }
  const double points = double(cloud->size());
  std::printf("%s: N %zu, k %.4f, internal share %.4f, %zu triangles in %zu regions, "
              "peak %.0f bytes/point\n",
              bench::shortName(word).c_str(),
              cloud->size(),
              double(report.internal_points + report.boundary_points) / points,
              double(report.internal_points) / points,
              report.output_triangles,
              report.components,
              bytes);
  printVariants(variants, 1e6 / points);
  printRatios(variants, rivals, 1e6 / points);
  std::fflush(stdout);
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
      settings.repeats = std::stoul(argv[++i]);
    else if (word == "--no-rivals")
      settings.rivals = false;
    else if (word[0] == '-')
      throw std::invalid_argument("unknown option " + word);
    else
      settings.clouds.push_back(word);
  }
  if (settings.clouds.empty() && !settings.help)
    throw std::invalid_argument("no cloud is given, see --help");
  return settings;
}

} // namespace

int
main(int argc, char** argv)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ERROR);
  try {
    const Settings settings = parse(argc, argv);
    if (settings.help) {
      std::printf("%s", HELP);
      return 0;
    }
    for (const std::string& word : settings.clouds)
      benchmark(word, settings);
  }
  catch (const std::exception& problem) {
    std::fprintf(stderr, "bench_surface_ccaa: %s\n", problem.what());
    return 1;
  }
}
