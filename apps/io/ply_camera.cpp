// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the sensor's place in PLY files, as PCL writes it.
#include "ply_camera.h"

#include "cloud_normals.h"
#include "point_columns.h"

namespace app {
namespace {

/** One number of the camera, in the order in which PCL reads them. */
struct CameraNumber {
  std::string name;
  const char* type;
  double value;
};

/** The axes are the rows of the rotation. PCL reads floats; of places that floats do
 * not hold it would read nonsense. */
std::vector<CameraNumber>
numbersOf(const Viewpoint& viewpoint, std::size_t width, std::size_t height)
{
  const Eigen::Matrix3f axes = viewpoint.orientation.toRotationMatrix();
  const char* const real = needsDouble(viewpoint) ? "double" : "float";
  const std::string letters = "xyz";
  std::vector<CameraNumber> numbers;
  for (std::size_t i = 0; i < 3; ++i)
    numbers.push_back({std::string("view_p") + letters[i],
                       real,
                       viewpoint.position[static_cast<Eigen::Index>(i)]});
  for (std::size_t i = 0; i < 9; ++i)
    numbers.push_back({letters.substr(i / 3, 1) + "_axis" + letters[i % 3],
                       "float",
                       double{axes(static_cast<Eigen::Index>(i / 3),
                                   static_cast<Eigen::Index>(i % 3))}});
  numbers.push_back({"viewportx", "int", static_cast<double>(width)});
  numbers.push_back({"viewporty", "int", static_cast<double>(height)});
  return numbers;
}

void
organise(double columns, double rows, pcl::PCLPointCloud2& cloud)
{
  constexpr double most = 1e6;
  if (!(columns >= 1 && columns <= most && rows >= 1 && rows <= most))
    return;
  const auto width = static_cast<std::uint64_t>(columns);
  const auto height = static_cast<std::uint64_t>(rows);
  if (width * height != pointCount(cloud))
    return;
  cloud.width = static_cast<pcl::uindex_t>(width);
  cloud.height = static_cast<pcl::uindex_t>(height);
  cloud.row_step = cloud.width * cloud.point_step;
}

} // namespace

void
takeCamera(std::map<std::string, double>& numbers, Model& model)
{
  Viewpoint& viewpoint = model.viewpoint;
  const auto has = [&](const std::string& name) { return numbers.count(name) != 0; };
  Eigen::Matrix3d axes;
  bool has_place = true;
  bool has_axes = true;
  for (int i = 0; i < 3; ++i) {
    const std::string letter(1, "xyz"[i]);
    has_place = has_place && has("view_p" + letter);
    viewpoint.position[i] = numbers["view_p" + letter];
    for (int k = 0; k < 3; ++k) {
      const std::string name = letter + "_axis" + "xyz"[k];
      has_axes = has_axes && has(name);
      axes(i, k) = numbers[name];
    }
  }
  if (has_axes && axes.allFinite() && axes.isUnitary(1e-3))
    viewpoint.orientation = Eigen::Quaternionf(axes.cast<float>().eval()).normalized();
  // PCL writes the origin when it knows no better.
  viewpoint.may_be_origin = has_place && viewpoint.position.isZero(0);
  viewpoint.known =
      has_place && viewpoint.position.allFinite() && !viewpoint.may_be_origin;
  organise(numbers["viewportx"], numbers["viewporty"], model.mesh.cloud);
}

void
announceCamera(const Viewpoint& viewpoint, OutputFile& file)
{
  file.text("element camera 1\n");
  for (const CameraNumber& number : numbersOf(viewpoint, 0, 0))
    file.text("property " + std::string(number.type) + " " + number.name + "\n");
}

void
writeCamera(const Viewpoint& viewpoint,
            const pcl::PCLPointCloud2& cloud,
            OutputFile& file)
{
  const auto write = [&](auto value) { file.write(&value, sizeof(value)); };
  for (const CameraNumber& number : numbersOf(viewpoint, cloud.width, cloud.height)) {
    const std::string type = number.type;
    if (type == "int")
      write(static_cast<std::int32_t>(number.value));
    else if (type == "double")
      write(number.value);
    else
      write(static_cast<float>(number.value));
  }
}

} // namespace app
