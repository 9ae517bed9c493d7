// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a user decides about boundary loops and junctions.

#include <pcl/surface_repair/decisions.h>

#include "decision/mesh_fingerprint.h"
#include "mesh/cloud_access.h"

#include <cstring>

namespace pcl::repair {

namespace {

/** FNV-1a over the bytes of values, eight at a time. */
class Checksum {
public:
  void
  add(std::uint64_t value)
  {
    sum_ = (sum_ ^ value) * 0x100000001b3ULL;
    sum_ ^= sum_ >> 29;
  }

  void
  add(double value)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    add(bits);
  }

  std::uint64_t
  sum() const
  {
    return sum_;
  }

private:
  std::uint64_t sum_ = 0xcbf29ce484222325ULL;
};

} // namespace

MeshFingerprint
fingerprintOf(const pcl::PolygonMesh& mesh)
{
  return fingerprintOf(ccaa::MeshView(mesh));
}

MeshFingerprint
fingerprintOf(const ccaa::MeshView& mesh)
{
  Checksum checksum;
  const ccaa::PointView points = ccaa::positionView(*mesh.cloud);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const double coordinate : Position(points[i]))
      checksum.add(coordinate);
  for (std::size_t i = 0; i < mesh.polygons.size(); ++i) {
    const ccaa::PolygonView::Corners corners = mesh.polygons[i];
    checksum.add(std::uint64_t{corners.size()});
    for (const pcl::index_t corner : corners)
      checksum.add(static_cast<std::uint64_t>(corner));
  }
  return {points.size(), mesh.polygons.size(), checksum.sum()};
}

} // namespace pcl::repair
