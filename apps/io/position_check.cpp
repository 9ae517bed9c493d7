// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: are the positions of a cloud fit for work?
#include "position_check.h"

#include "mesh/cloud_access.h"
#include "mesh/cloud_extent.h"
#include "point_columns.h"
#include "wording.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace app {

std::string
placeText(const Eigen::Vector3d& place, const char* separator)
{
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::digits10);
  text << place.x() << separator << place.y() << separator << place.z();
  return text.str();
}

std::string
placeIn(const pcl::PCLPointCloud2& cloud, const Eigen::Vector3d& place)
{
  return hasDoublePositions(cloud)
             ? placeText(place, " ")
             : formatted("%g %g %g", place.x(), place.y(), place.z());
}

namespace {

/** What single precision has cost the positions of the file. */
void
warnAboutFloats(Model& model)
{
  const auto view = pcl::ccaa::positionView(model.mesh.cloud);
  const pcl::ccaa::CloudExtent extent = pcl::ccaa::measureExtent(view);
  if (!(extent.side > 0) || !(extent.floatRounding() > 0.01 * extent.spacing))
    return;
  const double step = 2 * extent.floatRounding();
  const auto decimals = static_cast<int>(std::max(0.0, std::floor(-std::log10(step))));
  std::ostringstream text;
  text.precision(2);
  text << "the file holds its positions in single precision, which so far from the "
          "origin steps by "
       << step << " units (" << decimals << (decimals == 1 ? " decimal" : " decimals")
       << "), where points are some " << extent.spacing
       << " apart: write it in double precision";
  model.warnings.push_back(text.str());
}

} // namespace

void
checkPositions(Model& model)
{
  constexpr double most = std::numeric_limits<float>::max();
  const auto view = pcl::ccaa::positionView(model.mesh.cloud);
  model.mesh.cloud.is_dense = true;
  for (std::size_t i = 0; i < view.size(); ++i) {
    const pcl::ccaa::Position position = view[i];
    if (!position.allFinite())
      model.mesh.cloud.is_dense = false;
    else if (!(position.cwiseAbs().maxCoeff() <= most))
      throw Failure("its point " + std::to_string(i) +
                    " is too far away: " + placeText(position, " "));
  }
  model.shift = pcl::GlobalShift::of(model.mesh.cloud);
  if (!hasDoublePositions(model.mesh.cloud))
    warnAboutFloats(model);
}

void
noteShift(Model& model)
{
  if (!model.shift.isNone())
    model.warnings.push_back("large coordinates: worked on less a global shift of " +
                             placeText(model.shift.offset()));
}

std::size_t
countUsablePoints(const pcl::PCLPointCloud2& cloud, std::size_t enough)
{
  const auto view = pcl::ccaa::positionView(cloud);
  pcl::ccaa::Positions different;
  for (std::size_t i = 0; i < view.size() && different.size() < enough; ++i) {
    const pcl::ccaa::Position position = view[i];
    if (position.allFinite() &&
        std::find(different.begin(), different.end(), position) == different.end())
      different.push_back(position);
  }
  return different.size();
}

void
requireTrianglePoints(const pcl::PCLPointCloud2& cloud, const std::string& name)
{
  const std::size_t usable = countUsablePoints(cloud, 3);
  if (usable < 3)
    throw Failure(name +
                  ": of at least three points needed (finite, at different "
                  "places) there " +
                  (usable == 1 ? "is " : "are ") + std::to_string(usable));
}

} // namespace app
