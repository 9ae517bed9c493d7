// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: fuzz target, reading of cloud files, and writing what was
// read.
#include "io/model_io.h"
#include "mesh/cloud_access.h"
#include "requirement.h"
#include "temporary_file.h"

#include <cstdint>

namespace {

using fuzz::require;

/** The same number, or neither is one. */
bool
same(double one, double other)
{
  return one == other || (one != one && other != other);
}

/** What is written as PCD is read with the same positions. */
void
checkRoundTrip(const app::Model& model)
{
  const fuzz::TemporaryFile place("_copy.pcd");
  {
    app::OutputFile output;
    require(output.open(place.path()).ok(), "a copy can be opened");
    app::FileExtras extras;
    extras.viewpoint = model.viewpoint;
    app::writeCloud(place.path(), model.mesh.cloud, extras, output);
    require(output.commit().ok(), "a copy can be written");
  }
  app::Model copy;
  const app::Status status = app::readCloud(place.path(), copy);
  if (!status.ok())
    std::fprintf(stderr, "%s\n", status.message().c_str());
  require(status.ok(), "what we write can be read");
  const auto before = pcl::ccaa::positionView(model.mesh.cloud);
  const auto after = pcl::ccaa::positionView(copy.mesh.cloud);
  require(before.size() == after.size(), "all points");
  for (std::size_t i = 0; i < before.size(); ++i)
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      require(same(before[i][axis], after[i][axis]), "the same places");
}

} // namespace

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const auto* bytes = reinterpret_cast<const char*>(data);
  app::FileFormat format = app::formatOfBytes({bytes, size});
  if (format == app::FileFormat::UNKNOWN) // plain text has no mark
    format = app::FileFormat::XYZ;
  app::Model model;
  if (!app::parseCloud(format, bytes, size, model).ok())
    return 0;
  const auto points = std::size_t{model.mesh.cloud.width} * model.mesh.cloud.height;
  require(model.mesh.cloud.data.size() == points * model.mesh.cloud.point_step,
          "the cloud has the bytes it says");
  checkRoundTrip(model);
  return 0;
}
