// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the steps of a reconstruction tile by tile.
#include "out_of_core/tile_steps.h"

#include "cli/cli.h"
#include "cli/repair_run.h"
#include "out_of_core/step_file.h"
#include "out_of_core/tile_cloud.h"

#include <algorithm>
#include <utility>

namespace app {
namespace {

using pcl::ccaa::Position;
using pcl::ccaa::Tile;
using pcl::ccaa::WideIndex;
using pcl::ccaa::WideTriangle;

/** The chain on one tile. */
ReconstructResult
reconstructTile(const TilePlan& plan,
                std::size_t tile,
                TileCloud& cloud,
                const StepRun& run)
{
  ReconstructSettings settings = settingsOf(plan);
  settings.threads = run.threads;
  ReconstructResult result;
  result.model.mesh.cloud = cloud.take();
  result.model.shift = pcl::GlobalShift(plan.corners[tile]);
  result.model.viewpoint = plan.viewpoint;
  if (cloud.wide().size() >= 3)
    runReconstruction(settings, run.progress, result);
  if (result.chain.cancelled)
    throw Failure(stopped_by_signal);
  return result;
}

/** Sorts the triangles that a tile may keep into those of which seams have to know and
 * the others. */
class MeshSorter {
public:
  MeshSorter(const TilePlan& plan,
             std::size_t tile,
             const TileCloud& cloud,
             const pcl::ccaa::PointView& positions)
  : own_(plan.tiling.tiles[tile])
  , wide_(cloud.wide())
  , halos_(cloud.halos())
  , positions_(positions)
  {
    const auto others = pcl::ccaa::TilesAround::border(plan.tiling, tile);
    const auto sight = pcl::ccaa::TilesAround::sight(plan.tiling, tile);
    for (std::size_t i = 0; i < wide_.size(); ++i) {
      const Position position = positions[i];
      const double halo = halos_[i];
      is_border_.push_back(others.isNear(position, halo));
      is_sighted_.push_back(is_border_.back() && sight.isNear(position, halo));
      is_seen_.push_back(own_.sees(position, halo));
      if (halo > 0.0 && is_sighted_.back())
        addAround(i);
    }
  }

  void
  add(const pcl::Indices& corners)
  {
    if (hasAny(is_seen_, corners, false))
      return;
    triangles_.push_back({corners[0], corners[1], corners[2]});
    if (hasAny(is_sighted_, corners, true))
      noteFarCorners(triangles_.back());
  }

  TileMesh
  take()
  {
    addAroundFarCorners();
    TileMesh mesh;
    std::vector<bool> is_told = is_border_;
    for (const Triangle& triangle : triangles_) {
      const WideTriangle wide{wide_[std::size_t(triangle[0])],
                              wide_[std::size_t(triangle[1])],
                              wide_[std::size_t(triangle[2])]};
      const bool is_inner = std::all_of(wide.begin(),
                                        wide.end(),
                                        [&](WideIndex i) { return own_.owns(i); }) &&
                            !hasAny(is_border_, triangle, true) && !isLong(triangle);
      if (!is_inner) {
        mesh.border.triangles.push_back(wide);
        for (const pcl::index_t corner : triangle)
          is_told[static_cast<std::size_t>(corner)] = true;
      }
      else
        mesh.inner.push_back({static_cast<std::uint32_t>(wide[0] - own_.first),
                              static_cast<std::uint32_t>(wide[1] - own_.first),
                              static_cast<std::uint32_t>(wide[2] - own_.first)});
    }
    for (std::size_t i = 0; i < wide_.size(); ++i)
      if (is_told[i])
        mesh.border.points.push_back({wide_[i], positions_[i], halos_[i]});
    return mesh;
  }

private:
  using Triangle = pcl::ccaa::Triangle;

  template <typename Corners>
  static bool
  hasAny(const std::vector<bool>& flags, const Corners& corners, bool value)
  {
    return std::any_of(corners.begin(), corners.end(), [&](pcl::index_t corner) {
      return flags[static_cast<std::size_t>(corner)] == value;
    });
  }

  Position
  at(pcl::index_t i) const
  {
    return positions_[static_cast<std::size_t>(i)];
  }

  /** Such a triangle may reach from within the tile to where others meet it. */
  bool
  isLong(const Triangle& triangle) const
  {
    return pcl::ccaa::longestEdge({at(triangle[0]), at(triangle[1]), at(triangle[2])}) >
           Tile::LONGEST * own_.halo;
  }

  /** What seams have to know around a point that may be disputed. */
  void
  addAround(std::size_t i)
  {
    const pcl::ccaa::Box around = pcl::ccaa::widened(
        pcl::ccaa::Box(positions_[i]), Tile::TOLD * std::max(own_.halo, halos_[i]));
    if (around.intersects(own_.box))
      around_far_.push_back(around);
  }

  /** A triangle that is too long to be believed, or of sparse points, is disputed at
   * its other corners, too, however far they are from where tiles meet. */
  void
  noteFarCorners(const Triangle& triangle)
  {
    const bool is_long = isLong(triangle);
    for (const pcl::index_t corner : triangle) {
      const auto i = static_cast<std::size_t>(corner);
      if (!is_sighted_[i] && (is_long || halos_[i] > 0.0))
        addAround(i);
    }
  }

  /** What is around them may be made anew as around others. */
  void
  addAroundFarCorners()
  {
    const pcl::ccaa::BoxTree tree(around_far_);
    for (std::size_t i = 0; i < wide_.size() && !around_far_.empty(); ++i)
      if (!is_border_[i])
        is_border_[i] = tree.anyMeeting(pcl::ccaa::Box(positions_[i]),
                                        [](pcl::index_t) { return true; });
  }

  const Tile& own_;
  const std::vector<WideIndex>& wide_;
  const std::vector<double>& halos_;
  pcl::ccaa::PointView positions_;
  std::vector<bool> is_border_, is_sighted_, is_seen_;
  pcl::ccaa::Triangles triangles_;
  std::vector<pcl::ccaa::Box> around_far_;
};

/** What is in doubt in a tile, but for places farther out than its triangles count. */
pcl::ccaa::TileDoubts
doubtsOf(const Tile& tile, const TileCloud& cloud, const ReconstructResult& result)
{
  using pcl::ccaa::PlacedCount;
  const pcl::ccaa::PointView points = pcl::ccaa::positionView(result.model.mesh.cloud);
  auto [handles, thin, touching, necks] = result.chain.doubts;
  const auto isUnseen = [&](pcl::index_t point) {
    return !tile.sees(points[point], cloud.halos()[static_cast<std::size_t>(point)]);
  };
  necks.erase(std::remove_if(necks.begin(), necks.end(), isUnseen), necks.end());
  touching.erase(std::remove_if(touching.begin(),
                                touching.end(),
                                [&](const auto& pair) { return isUnseen(pair[0]); }),
                 touching.end());
  const auto first = [](const pcl::Indices& places) {
    return places.empty() ? pcl::UNAVAILABLE : places.front();
  };
  return {PlacedCount::at(handles, points, first(thin)),
          PlacedCount::at(touching.size(),
                          points,
                          touching.empty() ? pcl::UNAVAILABLE : touching.front()[0]),
          PlacedCount::at(necks.size(), points, first(necks)),
          result.start.points,
          result.usedPlaces()};
}

} // namespace

void
meshTile(const TilePlan& plan, std::size_t tile, const StepRun& run)
{
  if (isDone(plan.file(tile, MESH_STEP), plan.key))
    return;
  TileCloud cloud(plan, tile);
  const ReconstructResult result = reconstructTile(plan, tile, cloud, run);
  MeshSorter sorter(
      plan, tile, cloud, pcl::ccaa::positionView(result.model.mesh.cloud));
  for (const pcl::Vertices& polygon : result.model.mesh.polygons)
    sorter.add(polygon.vertices);
  TileMesh mesh = sorter.take();
  mesh.doubts = doubtsOf(plan.tiling.tiles[tile], cloud, result);
  writeMesh(plan, tile, std::move(mesh));
}

} // namespace app
