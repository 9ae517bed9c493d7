// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: clouds of any size, written point by point.
#include "streamed_clouds.h"

#include <Eigen/Geometry>

#include "support/random_source.h"

#include <cmath>
#include <fstream>
#include <stdexcept>

namespace bench {
namespace {

using pcl::ccaa::test::RandomSource;

/** Houses stand 40 units apart, so streets are 20 wide. */
constexpr double PITCH = 40.0;
constexpr int HOUSES = 5;
constexpr double FARTHEST = 60.0;
constexpr double SENSOR_HEIGHT = 2.0;

/** Binary floats behind a head. */
class FloatFile {
public:
  FloatFile(const std::string& path, const std::string& head)
  : path_(path), file_(path, std::ios::binary)
  {
    file_ << head;
  }

  void
  put(const Eigen::Vector3d& point)
  {
    const Eigen::Vector3f single = point.cast<float>();
    file_.write(reinterpret_cast<const char*>(single.data()), sizeof(single));
  }

  void
  finish()
  {
    if (!file_.flush())
      throw std::runtime_error("cannot write '" + path_ + "'");
  }

private:
  std::string path_;
  std::ofstream file_;
};

Eigen::Vector3d
randomDirection(RandomSource& random, double lowest, double highest)
{
  const double z = random.uniform(lowest, highest);
  const double angle = random.uniform(0.0, 2.0 * M_PI);
  const double across = std::sqrt(1.0 - z * z);
  return {across * std::cos(angle), across * std::sin(angle), z};
}

Eigen::AlignedBox3d
house(int i, int j)
{
  const Eigen::Vector3d low(PITCH * i, PITCH * j, -1.0);
  return {low, low + Eigen::Vector3d(20.0, 20.0, 9.0 + (7 * i + 3 * j) % 10)};
}

/** Distance along a ray at which it enters a box; infinite where it does not. */
double
distanceTo(const Eigen::AlignedBox3d& box,
           const Eigen::Vector3d& from,
           const Eigen::Vector3d& along)
{
  double enter = 0.0, leave = std::numeric_limits<double>::infinity();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double a = (box.min()[axis] - from[axis]) / along[axis];
    const double b = (box.max()[axis] - from[axis]) / along[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter < leave ? enter : std::numeric_limits<double>::infinity();
}

/** Distance to what a ray meets first: a house or the ground. */
double
distanceToCity(const Eigen::Vector3d& from, const Eigen::Vector3d& along)
{
  double nearest =
      along.z() < 0.0 ? -from.z() / along.z() : std::numeric_limits<double>::infinity();
  for (int i = 0; i < HOUSES; ++i)
    for (int j = 0; j < HOUSES; ++j)
      nearest = std::min(nearest, distanceTo(house(i, j), from, along));
  return nearest;
}

constexpr double BUMPY_AREA = 15.2;

} // namespace

void
writeBumpy(const std::string& path,
           std::uint64_t points,
           std::uint64_t seed,
           double shift,
           double noise)
{
  const double deviation = noise * std::sqrt(BUMPY_AREA / double(points));
  FloatFile file(path,
                 "ply\nformat binary_little_endian 1.0\nelement vertex " +
                     std::to_string(points) +
                     "\nproperty float x\nproperty float y\nproperty float z\n"
                     "end_header\n");
  RandomSource random(seed);
  for (std::uint64_t i = 0; i < points; ++i) {
    const Eigen::Vector3d d = randomDirection(random, -1.0, 1.0);
    const double bumps =
        std::sin(15.0 * d.x()) * std::sin(12.0 * d.y()) * std::sin(12.0 * d.z());
    Eigen::Vector3d point = (1.0 + 0.1 * bumps) * d + Eigen::Vector3d(shift, 0.0, 0.0);
    for (Eigen::Index axis = 0; noise > 0.0 && axis < 3; ++axis)
      point[axis] += deviation * random.normal();
    file.put(point);
  }
  file.finish();
}

std::vector<std::string>
writeCity(const std::string& folder,
          std::uint64_t points,
          std::uint64_t seed,
          std::size_t scans)
{
  std::vector<std::string> names;
  RandomSource random(seed);
  for (std::size_t scan = 0; scan < scans; ++scan) {
    // On the crossings of streets, one after the other.
    const Eigen::Vector3d from(PITCH * double(scan % (HOUSES - 1)) + 30.0,
                               PITCH * double(scan / (HOUSES - 1) % (HOUSES - 1)) +
                                   30.0,
                               SENSOR_HEIGHT);
    const std::string count = std::to_string(points / scans);
    names.push_back(folder + "/scan_" + std::to_string(scan) + ".pcd");
    FloatFile file(names.back(),
                   "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
                   "WIDTH " +
                       count + "\nHEIGHT 1\nVIEWPOINT " + std::to_string(from.x()) +
                       " " + std::to_string(from.y()) + " " + std::to_string(from.z()) +
                       " 1 0 0 0\nPOINTS " + count + "\nDATA binary\n");
    for (std::uint64_t i = 0; i < points / scans;) {
      const Eigen::Vector3d along = randomDirection(random, -1.0, std::sin(M_PI / 3.0));
      const double distance = distanceToCity(from, along);
      if (distance > FARTHEST)
        continue;
      file.put(from + distance * along);
      ++i;
    }
    file.finish();
  }
  return names;
}

} // namespace bench
