// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: looks at pictures in tests.
#include "pictures.h"

#include <Eigen/Core>

#include <vtkImageData.h>
#include <vtkPNGReader.h>
#include <vtkSmartPointer.h>

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <functional>

namespace app_test {
namespace {

std::size_t
countPixels(const Picture& picture,
            Columns columns,
            const std::function<bool(const app::Rgb&)>& counts)
{
  const int last = columns.last == 0 ? picture.width : columns.last;
  std::size_t count = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = columns.first; x < last; ++x)
      count += counts(picture.pixels[static_cast<std::size_t>(y * picture.width + x)])
                   ? 1
                   : 0;
  return count;
}

Eigen::Vector3d
toVector(const app::Rgb& color)
{
  return {static_cast<double>(color[0]),
          static_cast<double>(color[1]),
          static_cast<double>(color[2])};
}

} // namespace

Picture
decodePng(const std::string& bytes)
{
  Picture picture;
  if (bytes.substr(0, 4) != "\x89PNG")
    return picture;
  const auto reader = vtkSmartPointer<vtkPNGReader>::New();
  reader->SetMemoryBuffer(bytes.data());
  reader->SetMemoryBufferLength(static_cast<vtkIdType>(bytes.size()));
  reader->Update();
  vtkImageData& image = *reader->GetOutput();
  picture.width = image.GetDimensions()[0];
  picture.height = image.GetDimensions()[1];
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const auto* pixel = static_cast<const unsigned char*>(
          image.GetScalarPointer(x, picture.height - 1 - y, 0));
      picture.pixels.push_back({pixel[0], pixel[1], pixel[2]});
    }
  return picture;
}

Picture
grabScreen()
{
  Picture picture;
  Display* const display = XOpenDisplay(nullptr);
  if (display == nullptr)
    return picture;
  const int screen = DefaultScreen(display);
  picture.width = DisplayWidth(display, screen);
  picture.height = DisplayHeight(display, screen);
  XImage* const image = XGetImage(display,
                                  RootWindow(display, screen),
                                  0,
                                  0,
                                  static_cast<unsigned int>(picture.width),
                                  static_cast<unsigned int>(picture.height),
                                  AllPlanes,
                                  ZPixmap);
  for (int y = 0; image != nullptr && y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const unsigned long pixel = XGetPixel(image, x, y);
      picture.pixels.push_back({static_cast<std::uint8_t>(pixel >> 16),
                                static_cast<std::uint8_t>(pixel >> 8),
                                static_cast<std::uint8_t>(pixel)});
    }
  if (image != nullptr)
    XDestroyImage(image);
  else
    picture = {};
  XCloseDisplay(display);
  return picture;
}

std::size_t
countColor(const Picture& picture, const app::Rgb& color, Columns columns)
{
  return countPixels(
      picture, columns, [&](const app::Rgb& pixel) { return pixel == color; });
}

std::size_t
countShaded(const Picture& picture, const app::Rgb& color, Columns columns)
{
  constexpr double difference = 0.08; // between directions in the space of colours
  const Eigen::Vector3d wanted = toVector(color).normalized();
  const double dim = 0.25 * toVector(color).norm();
  return countPixels(picture, columns, [&](const app::Rgb& pixel) {
    const Eigen::Vector3d seen = toVector(pixel);
    return seen.norm() > dim && (seen.normalized() - wanted).norm() < difference;
  });
}

} // namespace app_test
