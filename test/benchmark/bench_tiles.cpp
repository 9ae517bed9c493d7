// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: clouds cut into tiles against the same at once.
#include "streamed_clouds.h"
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace {

constexpr const char* HELP =
    "usage: bench_tiles PROGRAMS FOLDER [PART...] [--tiles N] [--large N] [--small N]\n"
    "                   [--seeds N]\n"
    "       bench_tiles make WHAT POINTS PATH\n"
    "\n"
    "  PROGRAMS  folder with pcl_ccaa_reconstruct and pcl_mesh_quality\n"
    "  FOLDER    for clouds and meshes; some 200 bytes for each point of --large\n"
    "  scale     us/point and memory of --large points in tiles (10 M), of a tenth of\n"
    "            it, and of --small points at once (5 M), one thread\n"
    "  same      --small points in tiles and at once: what the meshes are, and the "
    "open\n"
    "            edges of --seeds such clouds (1): how many a cloud has is chance\n"
    "  noise     --small points with noise of 0.2 to 0.5 spacings, at once and in "
    "tiles\n"
    "  shift     --small points, and these moved by half a tile\n"
    "  workers   --small points in tiles on one and on two threads\n"
    "  city      --small points of a city block, 16 scans\n"
    "  make      only write a cloud: bumpy, or city (PATH is a folder)\n";

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Settings {
  std::string programs, folder;
  std::vector<std::string> parts;
  std::uint64_t tiles = 4000000, large = 10000000, small = 5000000, seeds = 1;
};

/** One run of a program. */
struct Run {
  double processor_seconds = 0.0, wall_seconds = 0.0;
  double peak_bytes = 0.0;
  double disk_bytes = 0.0; ///< most in the folder beside what was there before
  Json report;
};

double
sizeOf(const std::string& folder)
{
  double sum = 0.0;
  std::error_code gone; // a file or a folder may go while this looks
  for (fs::recursive_directory_iterator entry(folder, gone), end; entry != end;
       entry.increment(gone)) {
    const std::uintmax_t size =
        entry->is_regular_file(gone) ? entry->file_size(gone) : 0;
    sum += gone ? 0.0 : double(size);
  }
  return sum;
}

Run
run(const Settings& settings,
    const std::string& program,
    std::vector<std::string> arguments)
{
  const std::string report = settings.folder + "/report.json";
  arguments.insert(arguments.begin(), settings.programs + "/" + program);
  arguments.insert(arguments.end(), {"--report", report, "--quiet"});
  std::vector<char*> words;
  for (std::string& word : arguments)
    words.push_back(word.data());
  words.push_back(nullptr);
  const double before = sizeOf(settings.folder);
  const auto begin = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0) {
    execv(words.front(), words.data());
    _exit(127);
  }
  Run result;
  int status = 0;
  rusage usage{};
  while (wait4(child, &status, WNOHANG, &usage) == 0) {
    result.disk_bytes = std::max(result.disk_bytes, sizeOf(settings.folder) - before);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
  result.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const auto seconds = [](const timeval& time) {
    return double(time.tv_sec) + 1e-6 * double(time.tv_usec);
  };
  result.processor_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  result.peak_bytes = 1024.0 * double(usage.ru_maxrss);
  if (!WIFEXITED(status) || WEXITSTATUS(status) > 2 || WEXITSTATUS(status) == 1)
    throw std::runtime_error(program + " failed");
  std::ifstream(report) >> result.report;
  return result;
}

/** Of a cloud, in tiles or (tiles 0) at once. */
Run
reconstruct(const Settings& settings,
            const std::vector<std::string>& clouds,
            const std::string& mesh,
            std::uint64_t tiles,
            unsigned int threads)
{
  std::vector<std::string> arguments = clouds;
  arguments.insert(arguments.end(),
                   {"-o", mesh, "--merge", "--threads", std::to_string(threads)});
  if (tiles > 0)
    arguments.push_back("--tiles=" + std::to_string(tiles));
  return run(settings, "pcl_ccaa_reconstruct", arguments);
}

std::string
bumpy(const Settings& settings,
      std::uint64_t points,
      double shift = 0.0,
      std::uint64_t seed = 1,
      double noise = 0.0)
{
  std::string path = settings.folder + "/bumpy_" + std::to_string(points) +
                     (seed > 1 ? "_" + std::to_string(seed) : "") +
                     (shift > 0.0 ? "_moved" : "") +
                     (noise > 0.0 ? "_" + std::to_string(noise) : "") + ".ply";
  if (!fs::exists(path))
    bench::writeBumpy(path, points, seed, shift, noise);
  return path;
}

void
tell(const char* what, std::uint64_t points, const Run& made)
{
  std::printf("%-14s %10zu points  %6.2f us/point  %7.1f s wall  %5.2f GiB  "
              "disk %5.2f GiB\n",
              what,
              std::size_t(points),
              1e6 * made.processor_seconds / double(points),
              made.wall_seconds,
              made.peak_bytes / double(1u << 30),
              made.disk_bytes / double(1u << 30));
  std::fflush(stdout);
}

/** What pcl_mesh_quality finds. */
Json
judge(const Settings& settings, const char* what, const std::string& mesh)
{
  Json facts = run(settings, "pcl_mesh_quality", {mesh}).report;
  std::printf("%s:", what);
  for (const char* fact : {"boundary_edges",
                           "components",
                           "euler_characteristic",
                           "free_vertices",
                           "non_manifold_edges",
                           "non_manifold_vertices",
                           "misoriented_edges",
                           "self_intersections"})
    std::printf(" %s %s", fact, facts[fact].dump().c_str());
  // what the Euler characteristic is where each opening is closed by a disc
  std::printf(" closed_characteristic %ld\n",
              long(facts["euler_characteristic"]) +
                  long(facts["boundary_loops"].size()));
  return facts;
}

void
scale(const Settings& settings)
{
  const std::string mesh = settings.folder + "/mesh.ply";
  const auto in_tiles = [&](std::uint64_t points) {
    const Run made =
        reconstruct(settings, {bumpy(settings, points)}, mesh, settings.tiles, 1);
    tell("in tiles", points, made);
    return made.processor_seconds / double(points);
  };
  const Run at_once =
      reconstruct(settings, {bumpy(settings, settings.small)}, mesh, 0, 1);
  tell("at once", settings.small, at_once);
  const double lower = in_tiles(settings.large / 10);
  const double upper = in_tiles(settings.large);
  std::printf("in tiles / at once %.2f, growth %.2f\n",
              upper * double(settings.small) / at_once.processor_seconds,
              upper / lower);
}

void
same(const Settings& settings)
{
  const std::string mesh = settings.folder + "/mesh.ply";
  double sums[] = {0.0, 0.0};
  for (std::uint64_t seed = 1; seed <= settings.seeds; ++seed)
    for (const bool in_tiles : {false, true}) {
      const char* what = in_tiles ? "in tiles" : "at once";
      const std::string cloud = bumpy(settings, settings.small, 0.0, seed);
      const Run made =
          reconstruct(settings, {cloud}, mesh, in_tiles ? settings.tiles : 0, 1);
      tell(what, settings.small, made);
      if (in_tiles)
        std::printf("seams: %s\n", made.report["seams"].dump().c_str());
      sums[in_tiles ? 1 : 0] += double(judge(settings, what, mesh)["boundary_edges"]);
    }
  std::printf("open edges: %.0f and %.0f, ratio %.3f\n",
              sums[0],
              sums[1],
              sums[1] > 0 ? sums[1] / sums[0] : 1.0);
}

void
noise(const Settings& settings)
{
  const std::string mesh = settings.folder + "/mesh.ply";
  for (const double noise : {0.2, 0.35, 0.5})
    for (const std::uint64_t tiles : {std::uint64_t{0}, settings.tiles}) {
      const std::string cloud = bumpy(settings, settings.small, 0.0, 1, noise);
      const std::string what =
          (tiles > 0 ? "in tiles " : "at once ") + std::to_string(noise).substr(0, 4);
      tell(
          what.c_str(), settings.small, reconstruct(settings, {cloud}, mesh, tiles, 1));
      judge(settings, what.c_str(), mesh);
    }
}

void
shift(const Settings& settings)
{
  const std::string mesh = settings.folder + "/mesh.ply";
  for (const double by : {0.0, 0.25}) {
    const std::string cloud = bumpy(settings, settings.small, by);
    const Run made = reconstruct(settings, {cloud}, mesh, settings.tiles, 1);
    std::printf("moved by %.2f: %zu open edges, %zu triangles, %zu tiles\n",
                by,
                std::size_t(made.report["open_edges"]),
                std::size_t(made.report["triangles"]),
                made.report["shards"].size());
  }
}

void
workers(const Settings& settings)
{
  const std::string cloud = bumpy(settings, settings.small);
  const std::string mesh = settings.folder + "/mesh.ply";
  const Run one = reconstruct(settings, {cloud}, mesh, settings.tiles, 1);
  const Run two = reconstruct(settings, {cloud}, mesh, settings.tiles, 2);
  tell("one thread", settings.small, one);
  tell("two threads", settings.small, two);
  std::printf("two threads %.2f times as fast\n", one.wall_seconds / two.wall_seconds);
}

void
city(const Settings& settings)
{
  const std::string folder = settings.folder + "/city";
  fs::create_directories(folder);
  const auto scans = bench::writeCity(folder, settings.small, 1, 16);
  const std::string mesh = settings.folder + "/city.ply";
  tell("at once", settings.small, reconstruct(settings, scans, mesh, 0, 1));
  judge(settings, "at once", mesh);
  const Run made = reconstruct(settings, scans, mesh, settings.tiles, 1);
  tell("in tiles", settings.small, made);
  std::printf("seams: %s\n", made.report["seams"].dump().c_str());
  judge(settings, "in tiles", mesh);
}

Settings
readSettings(const std::vector<std::string>& words)
{
  Settings settings;
  settings.programs = words.at(0);
  settings.folder = words.at(1);
  const std::map<std::string, std::uint64_t*> counts = {{"--tiles", &settings.tiles},
                                                        {"--large", &settings.large},
                                                        {"--small", &settings.small},
                                                        {"--seeds", &settings.seeds}};
  for (std::size_t i = 2; i < words.size(); ++i) {
    const auto count = counts.find(words[i]);
    if (count == counts.end())
      settings.parts.push_back(words[i]);
    else if (++i == words.size())
      throw std::runtime_error(count->first + " needs a number");
    else
      *count->second = std::stoull(words[i]);
  }
  fs::create_directories(settings.folder);
  return settings;
}

void
runAll(const std::vector<std::string>& words)
{
  if (words.front() == "make") {
    const std::uint64_t points = std::stoull(words.at(2));
    if (words.at(1) == "bumpy")
      bench::writeBumpy(words.at(3), points, 1);
    else
      bench::writeCity(words.at(3), points, 1, 16);
    return;
  }
  const Settings settings = readSettings(words);
  const std::vector<std::pair<std::string, void (*)(const Settings&)>> parts = {
      {"scale", scale},
      {"same", same},
      {"noise", noise},
      {"shift", shift},
      {"workers", workers},
      {"city", city}};
  for (const auto& [name, part] : parts)
    if (settings.parts.empty() ||
        std::count(settings.parts.begin(), settings.parts.end(), name) > 0) {
      std::printf("%s\n", name.c_str());
      part(settings);
    }
}

} // namespace

int
main(int argc, char** argv)
{
  const std::vector<std::string> words(argv + 1, argv + argc);
  const bool help = !words.empty() && words.front() == "--help";
  if (help || words.size() < 2 || (words.front() == "make" && words.size() != 4)) {
    std::fputs(HELP, help ? stdout : stderr);
    return help ? 0 : 1;
  }
  try {
    runAll(words);
  }
  catch (const std::exception& problem) {
    std::fprintf(stderr, "bench_tiles: %s\n", problem.what());
    return 1;
  }
  return 0;
}
