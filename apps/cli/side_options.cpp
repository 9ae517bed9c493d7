// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what user and file tell about the outer side.
#include "side_options.h"

#include "mesh/cloud_access.h"
#include "number_list.h"

namespace app {

using pcl::ccaa::OutwardRule;
using pcl::ccaa::SideHints;

void
addSideOptions(CommandLine& command_line)
{
  const auto place = [] { return boost::program_options::value<std::string>(); };
  command_line.addOptions()(
      "viewpoint",
      place(),
      "X,Y,Z: where the sensor stood, units of the cloud; the outer side is what it "
      "sees. Goes before normals and viewpoints of the input")(
      "up",
      place(),
      "X,Y,Z: where the outer side looks, 0,0,1 for a terrain; goes before normals and "
      "viewpoints of the input");
}

Status
takeSides(const Arguments& arguments, SideHints& told)
{
  Status status;
  for (const auto& [option, place] :
       {std::pair{"viewpoint", &told.told_viewpoint}, std::pair{"up", &told.up}})
    if (status.ok() && arguments.count(option) > 0)
      status = parsePlace(
          option, takeText(arguments, option), place->emplace(Eigen::Vector3d::Zero()));
  if (status.ok() && told.up && told.up->norm() < 1e-12)
    return Status::error("--up must not be zero");
  return status;
}

SideHints
sidesOf(SideHints told, const Viewpoint& viewpoint)
{
  if (viewpoint.known)
    told.viewpoint = viewpoint.position;
  told.try_origin = viewpoint.may_be_origin;
  return told;
}

std::string
outerSideBy(const SideHints& told, const Model& model)
{
  if (told.told_viewpoint)
    return describe(OutwardRule::TOLD_VIEWPOINT);
  if (told.up)
    return describe(OutwardRule::UP);
  if (!pcl::ccaa::normalView(model.mesh.cloud).empty())
    return "normals";
  if (!pcl::ccaa::viewpointView(model.mesh.cloud).empty())
    return "viewpoints of points";
  const Eigen::Vector3d offset = model.shift.offset();
  SideHints hints = relativeTo(offset, sidesOf(told, model.viewpoint));
  takeOrigin(hints, pcl::ccaa::positionView(model.mesh.cloud).relativeTo(offset));
  if (hints.viewpoint_is_origin)
    return describe(OutwardRule::ORIGIN);
  return hints.viewpoint ? "the viewpoint" : "the shape";
}

void
noteViewpoint(const SideHints& told,
              const pcl::ccaa::SideTally& tally,
              Viewpoint& viewpoint)
{
  viewpoint.is_origin = tally[OutwardRule::ORIGIN] > 0;
  if (!told.told_viewpoint)
    return;
  viewpoint.known = true;
  viewpoint.position = *told.told_viewpoint;
}

} // namespace app
