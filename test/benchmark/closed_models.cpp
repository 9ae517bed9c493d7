// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: closed surfaces to be damaged, from files or made to order.
#include "closed_models.h"

#include <pcl/memory.h>

#include <Eigen/Geometry>

#include "icadm/model_reading.h"
#include "io/model_io.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <stdexcept>
#include <utility>

namespace bench {
namespace {

using pcl::repair::Position;
using pcl::repair::Positions;
using pcl::repair::Triangles;

ClosedModel
finished(std::string name, Positions positions, Triangles triangles)
{
  ClosedModel model;
  model.name = std::move(name);
  model.positions = std::move(positions);
  model.triangles = std::move(triangles);
  model.adjacency.build(model.triangles, model.positions.size());
  Eigen::AlignedBox3d box;
  for (const Position& position : model.positions)
    box.extend(position);
  model.diagonal = box.diagonal().norm();
  for (const auto& triangle : model.triangles)
    model.area += areaOf(triangle, model.positions);
  return model;
}

/** \brief A lattice closed in both directions, bent by `place`. */
ClosedModel
madeTorus()
{
  constexpr int AROUND = 160;
  constexpr int ACROSS = 60;
  Positions positions;
  Triangles triangles;
  for (int i = 0; i < AROUND; ++i)
    for (int j = 0; j < ACROSS; ++j) {
      const double u = 2 * M_PI * i / AROUND;
      const double v = 2 * M_PI * j / ACROSS;
      const double radius = 1 + 0.35 * std::cos(v);
      positions.emplace_back(
          radius * std::cos(u), radius * std::sin(u), 0.35 * std::sin(v));
      const int a = i * ACROSS + j;
      const int b = (i + 1) % AROUND * ACROSS + j;
      const int c = (i + 1) % AROUND * ACROSS + (j + 1) % ACROSS;
      const int d = i * ACROSS + (j + 1) % ACROSS;
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  return finished("torus", positions, triangles);
}

/** \brief The surface of the cube [-1, 1]^3 as a lattice; `shape` moves its vertices.
 */
ClosedModel
madeBox(const std::string& name, const std::function<Position(const Position&)>& shape)
{
  constexpr int DIVISIONS = 48;
  Positions positions;
  Triangles triangles;
  std::map<std::array<int, 3>, int> made;
  const auto vertex = [&](int axis, int side, int u, int v) {
    std::array<int, 3> place{};
    const auto at = static_cast<std::size_t>(axis);
    place[at] = side;
    place[(at + 1) % 3] = u;
    place[(at + 2) % 3] = v;
    const auto entry = made.emplace(place, static_cast<int>(positions.size()));
    if (entry.second)
      positions.push_back(
          shape(Position(place[0], place[1], place[2]) * (2.0 / DIVISIONS) -
                Position::Ones()));
    return entry.first->second;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int u = 0; u < DIVISIONS; ++u)
      for (int v = 0; v < DIVISIONS; ++v)
        for (const int side : {0, DIVISIONS}) {
          const int a = vertex(axis, side, u, v);
          const int b = vertex(axis, side, u + 1, v);
          const int c = vertex(axis, side, u + 1, v + 1);
          const int d = vertex(axis, side, u, v + 1);
          triangles.push_back(side == 0 ? std::array<int, 3>{a, c, b}
                                        : std::array<int, 3>{a, b, c});
          triangles.push_back(side == 0 ? std::array<int, 3>{a, d, c}
                                        : std::array<int, 3>{a, c, d});
        }
  return finished(name, positions, triangles);
}

} // namespace

double
areaOf(const pcl::repair::Triangle& triangle, const Positions& positions)
{
  const Position& a = positions[static_cast<std::size_t>(triangle[0])];
  const Position& b = positions[static_cast<std::size_t>(triangle[1])];
  const Position& c = positions[static_cast<std::size_t>(triangle[2])];
  return 0.5 * (b - a).cross(c - a).norm();
}

std::string
sharedFile(const std::string& name)
{
  const char* folder = std::getenv("PSR_SHARED_DATA");
  return std::string(folder != nullptr ? folder : PSR_SHARED_DATA_DIR) + "/" + name;
}

ClosedModel
readClosedModel(const std::string& name)
{
  app::Model file;
  if (!app::readMesh(sharedFile(name), file).ok())
    throw std::runtime_error("cannot read " + sharedFile(name));
  auto read = pcl::repair::readModel(
      pcl::make_shared<pcl::PolygonMesh>(file.mesh), nullptr, pcl::ccaa::LoopContext());
  if (read.model.islands.size() != 1 || !read.model.islands[0].closed)
    throw std::runtime_error(name + " is not closed");
  return finished(name, read.model.positions, read.model.triangles);
}

std::vector<ClosedModel>
madeModels()
{
  std::vector<ClosedModel> models;
  models.push_back(
      madeBox("sphere", [](const Position& p) { return Position(p.normalized()); }));
  models.push_back(madeTorus());
  models.push_back(madeBox("cube", [](const Position& p) { return p; }));
  return models;
}

pcl::PolygonMesh::Ptr
damagedMesh(const ClosedModel& model, const std::vector<char>& removed)
{
  auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  pcl::PCLPointCloud2& cloud = mesh->cloud;
  const char* const names[] = {"x", "y", "z"};
  for (std::uint32_t i = 0; i < 3; ++i) {
    pcl::PCLPointField field;
    field.name = names[i];
    field.offset = i * static_cast<std::uint32_t>(sizeof(double));
    field.datatype = pcl::PCLPointField::FLOAT64;
    field.count = 1;
    cloud.fields.push_back(field);
  }
  cloud.point_step = 3 * sizeof(double);
  cloud.width = static_cast<std::uint32_t>(model.positions.size());
  cloud.height = 1;
  cloud.row_step = cloud.width * cloud.point_step;
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(model.positions.data());
  cloud.data.assign(bytes, bytes + cloud.row_step);
  for (std::size_t t = 0; t < removed.size(); ++t) {
    if (removed[t] != 0)
      continue;
    mesh->polygons.emplace_back();
    mesh->polygons.back().vertices.assign(model.triangles[t].begin(),
                                          model.triangles[t].end());
  }
  return mesh;
}

const std::vector<std::string>&
closedFiles()
{
  static const std::vector<std::string> files = {"horse/horse.ply",
                                                 "armadillo/armadillo.ply",
                                                 "rocker_arm/rockerArm.ply",
                                                 "cad_daratech/daratech.ply",
                                                 "lordquas/lordquas.ply",
                                                 "fandisk/fandisk_large.ply",
                                                 "igea/igea.ply",
                                                 "skull/skull.ply",
                                                 "femur/femur.ply",
                                                 "woman/human_woman.ply"};
  return files;
}

} // namespace bench
