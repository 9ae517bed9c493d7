// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: fuzz target, reading of mesh files, and writing what was
// read.
#include "io/model_io.h"
#include "requirement.h"
#include "temporary_file.h"

#include <cstdint>

namespace {

using fuzz::require;

void
checkIndices(const app::Model& model)
{
  const auto points = std::size_t{model.mesh.cloud.width} * model.mesh.cloud.height;
  require(model.mesh.cloud.data.size() == points * model.mesh.cloud.point_step,
          "the cloud has the bytes it says");
  for (const auto& polygon : model.mesh.polygons)
    for (const auto corner : polygon.vertices)
      require(corner >= 0 && static_cast<std::size_t>(corner) < points,
              "corners are points");
}

/** What is written as PLY is read as it was. */
void
checkRoundTrip(const app::Model& model)
{
  const fuzz::TemporaryFile place("_copy.ply");
  app::Warnings warnings;
  {
    app::OutputFile output;
    require(output.open(place.path()).ok(), "a copy can be opened");
    app::writeMesh(place.path(), model.mesh, {}, output, warnings);
    require(output.commit().ok(), "a copy can be written");
  }
  app::Model copy;
  const app::Status status = app::readMesh(place.path(), copy);
  if (!status.ok())
    std::fprintf(stderr, "%s\n", status.message().c_str());
  require(status.ok(), "what we write can be read");
  require(copy.mesh.polygons.size() == model.mesh.polygons.size(), "all polygons");
  for (std::size_t i = 0; i < copy.mesh.polygons.size(); ++i)
    require(copy.mesh.polygons[i].vertices == model.mesh.polygons[i].vertices,
            "the same polygons");
  require(copy.mesh.cloud.width == model.mesh.cloud.width * model.mesh.cloud.height,
          "all points");
}

} // namespace

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const auto* bytes = reinterpret_cast<const char*>(data);
  app::FileFormat format = app::formatOfBytes({bytes, size});
  if (format == app::FileFormat::UNKNOWN) // as that of binary STL
    format = app::FileFormat::STL;
  app::Model model;
  if (!app::parseMesh(format, bytes, size, model).ok())
    return 0;
  checkIndices(model);
  checkRoundTrip(model);
  return 0;
}
