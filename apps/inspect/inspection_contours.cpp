// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the holes of a repair as coloured lines.
#include "io/point_columns.h"
#include "layer_builder.h"

#include <algorithm>
#include <map>
#include <utility>

namespace app {
namespace {

using pcl::OpenReason;
using pcl::TriangleOrigin;

/** \brief An edge as one triangle passes it. */
struct DirectedEdge {
  std::size_t patch = 0; /**< number of a hole; NONE for the given triangles */
  pcl::index_t from = -1;
  pcl::index_t to = -1;

  std::pair<pcl::index_t, pcl::index_t>
  ends() const
  {
    return std::minmax(from, to);
  }
};

std::vector<DirectedEdge>
edgesOf(const pcl::RepairReport& report, const pcl::PolygonMesh& mesh)
{
  std::vector<DirectedEdge> edges;
  for (std::size_t t = 0; t < mesh.polygons.size(); ++t) {
    const auto& corners = mesh.polygons[t].vertices;
    for (std::size_t k = 0; k < corners.size(); ++k)
      edges.push_back(
          {report.hole_of[t], corners[k], corners[(k + 1) % corners.size()]});
  }
  return edges;
}

/** \brief The edges that one triangle alone passes, of all or of its patch. */
template <typename Key>
std::vector<DirectedEdge>
singleEdges(std::vector<DirectedEdge> edges, const Key& key)
{
  std::sort(edges.begin(), edges.end(), [&](const auto& a, const auto& b) {
    return key(a) < key(b);
  });
  std::vector<DirectedEdge> single;
  for (auto edge = edges.begin(); edge != edges.end();) {
    const auto next = std::find_if(
        edge, edges.end(), [&](const auto& other) { return key(other) != key(*edge); });
    if (next - edge == 1)
      single.push_back(*edge);
    edge = next;
  }
  return single;
}

/** \brief How a hole ended: the reason, or the method by which it was closed. */
using HoleEnd = std::pair<OpenReason, TriangleOrigin>;

HoleEnd
endOf(const pcl::RepairedHole& hole)
{
  for (const TriangleOrigin origin : {TriangleOrigin::FAN, TriangleOrigin::COMPLETION})
    if (hole.filling == describe(origin))
      return {hole.open, origin};
  return {hole.open, TriangleOrigin::MINIMUM_WEIGHT};
}

Rgb
colorOfEnd(const HoleEnd& end)
{
  return end.first == OpenReason::NONE ? colorOf(end.second) : colorOf(end.first);
}

/** \brief Draws edges of the mesh. */
class ContourBuilder {
public:
  ContourBuilder(const pcl::PolygonMesh& mesh, const pcl::GlobalShift& shift)
  : builder_("contours.vtk", "Holes after bridging", {"hole"})
  , positions_(readPositions(mesh.cloud, shift))
  {}

  void
  add(const DirectedEdge& edge, const Rgb& color, std::size_t hole)
  {
    const pcl::index_t first = builder_.addPoint(positionOf(edge.from), color, hole);
    builder_.addPoint(positionOf(edge.to), color, hole);
    builder_.addLine(first, 2, false);
  }

  LayerBuilder&
  layer()
  {
    return builder_;
  }

private:
  Eigen::Vector3d
  positionOf(pcl::index_t point) const
  {
    return positions_[static_cast<std::size_t>(point)].cast<double>();
  }

  LayerBuilder builder_;
  std::vector<Eigen::Vector3f> positions_;
};

void
addClosed(const pcl::RepairReport& report,
          std::vector<DirectedEdge> edges,
          ContourBuilder& contours)
{
  const auto is_given = [](const DirectedEdge& edge) {
    return edge.patch == pcl::repair::NONE;
  };
  edges.erase(std::remove_if(edges.begin(), edges.end(), is_given), edges.end());
  const auto key = [](const DirectedEdge& edge) {
    return std::pair(edge.patch, edge.ends());
  };
  for (const DirectedEdge& edge : singleEdges(std::move(edges), key))
    contours.add(edge, colorOfEnd(endOf(report.holes[edge.patch])), edge.patch);
}

/** \brief Follow the boundary from the point of each open hole. */
void
addOpen(const pcl::RepairReport& report,
        std::vector<DirectedEdge> edges,
        ContourBuilder& contours)
{
  std::map<pcl::index_t, DirectedEdge> next;
  for (const DirectedEdge& edge :
       singleEdges(std::move(edges), [](const auto& e) { return e.ends(); }))
    next[edge.from] = edge;
  for (std::size_t i = 0; i < report.holes.size(); ++i) {
    const pcl::RepairedHole& hole = report.holes[i];
    if (hole.open == OpenReason::NONE)
      continue;
    // Each edge is taken once, so this ends in any mesh.
    for (auto at = next.find(hole.point); at != next.end();) {
      const DirectedEdge edge = at->second;
      contours.add(edge, colorOfEnd(endOf(hole)), i);
      next.erase(at);
      at = next.find(edge.to);
    }
  }
}

void
addContourLegend(const pcl::RepairReport& report, LayerBuilder& layer)
{
  std::map<HoleEnd, std::size_t> counts;
  for (const pcl::RepairedHole& hole : report.holes)
    ++counts[endOf(hole)];
  for (const auto& [end, count] : counts) {
    const std::string what = end.first == OpenReason::NONE
                                 ? std::string("closed by ") + describe(end.second)
                                 : std::string("open: ") + describe(end.first);
    layer.addLegend(colorOfEnd(end), what, count);
  }
}

} // namespace

InspectionLayer
showContours(const pcl::RepairReport& report, const pcl::PolygonMesh& mesh)
{
  const std::vector<DirectedEdge> edges = edgesOf(report, mesh);
  ContourBuilder contours(mesh, pcl::GlobalShift(report.reading.global_shift));
  addClosed(report, edges, contours);
  addOpen(report, edges, contours);
  addContourLegend(report, contours.layer());
  return contours.layer().finish("hole: number, as in the report");
}

} // namespace app
