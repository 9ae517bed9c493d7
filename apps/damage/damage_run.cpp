// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: decides which points pcl_damage_cloud takes out, and parts
// them.
#include "damage_run.h"

#include "damage_patches.h"
#include "io/point_columns.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace app {
namespace {

void
markRegions(const DamageSettings& settings,
            const Points& points,
            RandomNumbers& random,
            std::vector<char>& removed)
{
  const RegionMaker maker(points, settings.absolute, settings.shift);
  for (const std::string& text : settings.spheres) {
    Sphere sphere;
    maker.parseSphere(text, sphere);
    markSphere(sphere, points, removed);
  }
  for (const std::string& text : settings.slabs) {
    Slab slab;
    maker.parseSlab(text, slab);
    markSlab(slab, points, removed);
  }
  for (unsigned int i = 0; i < settings.random_spheres; ++i)
    markSphere(maker.randomSphere(settings.sphere_size, random), points, removed);
  for (unsigned int i = 0; i < settings.random_slabs; ++i)
    markSlab(maker.randomSlab(settings.slab_size, random), points, removed);
}

void
markPatches(const DamageSettings& settings,
            const pcl::PolygonMesh& mesh,
            const Points& points,
            RandomNumbers& random,
            std::vector<char>& removed)
{
  if (settings.random_patches == 0)
    return;
  const auto neighbors = makeNeighbors(mesh, points);
  const double share = settings.patch_size * static_cast<double>(points.size());
  const auto size = static_cast<std::size_t>(std::max(1.0, std::round(share)));
  for (unsigned int i = 0; i < settings.random_patches; ++i)
    growPatch(*neighbors, size, random, removed);
}

/** A random choice of the removed points, each as likely as the other. */
std::vector<char>
chooseKept(const std::vector<char>& removed, double share, RandomNumbers& random)
{
  std::vector<std::size_t> candidates;
  for (std::size_t i = 0; i < removed.size(); ++i)
    if (removed[i] != 0)
      candidates.push_back(i);
  const auto count = static_cast<std::size_t>(
      std::round(share * static_cast<double>(candidates.size())));
  std::vector<char> kept(removed.size(), 0);
  for (std::size_t i = 0; i < count; ++i) {
    std::swap(candidates[i], candidates[i + random.below(candidates.size() - i)]);
    kept[candidates[i]] = 1;
  }
  return kept;
}

void
writeCoordinate(double value, const pcl::PCLPointField& field, std::uint8_t* point)
{
  const auto single = static_cast<float>(value);
  if (field.datatype == pcl::PCLPointField::FLOAT64)
    std::memcpy(point + field.offset, &value, sizeof(value));
  else
    std::memcpy(point + field.offset, &single, sizeof(single));
}

/** Moves the kept points of \a cloud. */
void
addNoise(const Damage& damage,
         const pcl::GlobalShift& shift,
         RandomNumbers& random,
         pcl::PCLPointCloud2& cloud)
{
  const char* const names[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    const pcl::PCLPointField& field = *findField(cloud, names[axis]);
    for (std::size_t i = 0; i < damage.kept.size(); ++i) {
      if (damage.kept[i] == 0)
        continue;
      const double step = damage.deviation * random.normal();
      if (step != 0.0)
        writeCoordinate(double{damage.points[i][axis]} + step + shift.offset()[axis],
                        field,
                        cloud.data.data() + i * cloud.point_step);
    }
  }
}

void
takeCloud(const pcl::PCLPointCloud2& cloud,
          const std::vector<char>& wanted,
          pcl::PCLPointCloud2& part)
{
  const auto count = std::count(wanted.begin(), wanted.end(), 1);
  part.header = cloud.header;
  part.fields = cloud.fields;
  part.is_bigendian = cloud.is_bigendian;
  part.is_dense = cloud.is_dense;
  part.point_step = cloud.point_step;
  part.data.clear();
  part.data.reserve(static_cast<std::size_t>(count) * cloud.point_step);
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (wanted[i] != 0)
      part.data.insert(
          part.data.end(), pointAt(cloud, i), pointAt(cloud, i) + cloud.point_step);
  // A whole organised cloud stays organised.
  const bool is_whole = part.data.size() == cloud.data.size();
  part.width = is_whole ? cloud.width : static_cast<pcl::uindex_t>(count);
  part.height = is_whole ? cloud.height : 1;
  part.row_step = part.width * part.point_step;
}

bool
hasFlagged(const pcl::Vertices& polygon, const std::vector<char>& flags, char flag)
{
  return std::any_of(
      polygon.vertices.begin(), polygon.vertices.end(), [&](pcl::index_t corner) {
        return flags[static_cast<std::size_t>(corner)] == flag;
      });
}

/** The points of \a mesh with a flag, in order and with all fields, and of the
 * polygons given those whose corners all have one. */
pcl::PolygonMesh
takePoints(const pcl::PolygonMesh& mesh,
           const std::vector<char>& wanted,
           const std::vector<pcl::Vertices>& polygons)
{
  pcl::PolygonMesh part;
  part.header = mesh.header;
  takeCloud(mesh.cloud, wanted, part.cloud);
  std::vector<pcl::index_t> new_index(wanted.size(), 0);
  pcl::index_t next = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (wanted[i] != 0)
      new_index[i] = next++;
  for (const pcl::Vertices& polygon : polygons) {
    if (hasFlagged(polygon, wanted, 0))
      continue;
    part.polygons.push_back(polygon);
    for (pcl::index_t& corner : part.polygons.back().vertices)
      corner = new_index[static_cast<std::size_t>(corner)];
  }
  return part;
}

/** Sort the polygons into those that touch no flagged point and the others. */
void
splitPolygons(const std::vector<pcl::Vertices>& polygons,
              const std::vector<char>& flagged,
              std::vector<pcl::Vertices>& untouched,
              std::vector<pcl::Vertices>& touched)
{
  for (const pcl::Vertices& polygon : polygons)
    (hasFlagged(polygon, flagged, 1) ? touched : untouched).push_back(polygon);
}

/** The part that was taken out, unmoved, with the rim its triangles end at. */
pcl::PolygonMesh
takeRemoved(const pcl::PolygonMesh& mesh,
            const std::vector<char>& removed,
            const std::vector<pcl::Vertices>& touched)
{
  std::vector<char> wanted = removed;
  for (const pcl::Vertices& polygon : touched)
    for (const pcl::index_t corner : polygon.vertices)
      wanted[static_cast<std::size_t>(corner)] = 1;
  return takePoints(mesh, wanted, touched);
}

} // namespace

void
planDamage(const DamageSettings& settings,
           const pcl::PolygonMesh& mesh,
           RandomNumbers& random,
           Damage& damage)
{
  damage.points = readPositions(mesh.cloud, settings.shift);
  damage.removed.assign(damage.points.size(), 0);
  markRegions(settings, damage.points, random, damage.removed);
  markPatches(settings, mesh, damage.points, random, damage.removed);
  damage.kept = chooseKept(damage.removed, settings.keep, random);
  const auto lost = std::count(damage.removed.begin(), damage.removed.end(), 1);
  if (static_cast<std::size_t>(lost) == damage.points.size())
    throw Failure("the regions hold every point; nothing would be left");
  if (settings.noise > 0)
    damage.deviation = settings.noise * meanSpacing(damage.points);
}

std::vector<DamagePart>
makeParts(const DamageSettings& settings,
          const Damage& damage,
          RandomNumbers& random,
          pcl::PolygonMesh& mesh)
{
  std::vector<DamagePart> parts;
  std::vector<pcl::Vertices> untouched;
  std::vector<pcl::Vertices> touched;
  splitPolygons(mesh.polygons, damage.removed, untouched, touched);
  if (!settings.removed.empty())
    parts.push_back({settings.removed, takeRemoved(mesh, damage.removed, touched)});
  addNoise(damage, settings.shift, random, mesh.cloud);
  if (!settings.free_points.empty())
    parts.push_back({settings.free_points, takePoints(mesh, damage.kept, {})});
  std::vector<char> left(damage.removed.size());
  for (std::size_t i = 0; i < left.size(); ++i)
    left[i] = damage.removed[i] == 0 || damage.kept[i] != 0 ? 1 : 0;
  parts.push_back({settings.output, takePoints(mesh, left, untouched)});
  return parts;
}

} // namespace app
