// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: are the positions of a cloud fit for work?
#include "position_check.h"

#include <Eigen/Geometry>

#include "point_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace app {

void
checkPositions(Model& model)
{
  Eigen::AlignedBox3f box;
  std::size_t finite = 0;
  const auto positions = readPositions(model.mesh.cloud);
  for (const Eigen::Vector3f& position : positions)
    if (position.allFinite()) {
      box.extend(position);
      ++finite;
    }
  model.mesh.cloud.is_dense = finite == positions.size();
  if (finite < 3)
    return;
  const double farthest =
      std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  const double side = box.sizes().cast<double>().maxCoeff();
  const double spacing = side / std::sqrt(static_cast<double>(finite));
  const double step = farthest * std::numeric_limits<float>::epsilon() / 2;
  if (!(step > 0.01 * spacing) || side == 0)
    return;
  std::ostringstream text;
  text.precision(2);
  text << "the points lie so far from the origin that single precision rounds them by "
          "up "
          "to "
       << step << " units, where they are some " << spacing
       << " apart; move them near the origin first";
  model.warnings.push_back(text.str());
}

std::size_t
countUsablePoints(const pcl::PCLPointCloud2& cloud, std::size_t enough)
{
  std::vector<Eigen::Vector3f> different;
  for (const Eigen::Vector3f& position : readPositions(cloud)) {
    if (different.size() >= enough)
      break;
    if (position.allFinite() &&
        std::find(different.begin(), different.end(), position) == different.end())
      different.push_back(position);
  }
  return different.size();
}

Status
requireTrianglePoints(const pcl::PCLPointCloud2& cloud, const std::string& name)
{
  const std::size_t usable = countUsablePoints(cloud, 3);
  if (usable >= 3)
    return {};
  return Status::error(name +
                       ": of at least three points needed (finite, at different "
                       "places) there " +
                       (usable == 1 ? "is " : "are ") + std::to_string(usable));
}

} // namespace app
