// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: time and memory of a piece of work.
#include "measuring.h"

#include <malloc.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string>

namespace bench {
namespace {

/** A line of /proc/self/status in bytes, 0 where there is none. */
std::size_t
processBytes(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == key + ":") {
      std::size_t kilobytes = 0;
      status >> kilobytes;
      return 1024 * kilobytes;
    }
  return 0;
}

/** What earlier work left in the heap would hide what this work takes. */
void
resetPeak()
{
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
}

} // namespace

double
secondsOf(const std::function<void()>& work)
{
  const double begin = wallSeconds();
  work();
  return wallSeconds() - begin;
}

double
wallSeconds()
{
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

double
ownSeconds()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double
median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[values.size() / 2];
}

std::size_t
bytesOf(const pcl::PolygonMesh& mesh)
{
  return mesh.cloud.data.capacity() +
         mesh.polygons.capacity() * (sizeof(pcl::Vertices) + 32);
}

double
peakBytesOf(const std::function<void()>& work)
{
  resetPeak();
  const std::size_t before = processBytes("VmRSS");
  work();
  return double(processBytes("VmHWM")) - double(before);
}

} // namespace bench
