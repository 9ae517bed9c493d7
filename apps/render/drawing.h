// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what all pictures are put together from.
#pragma once

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include "inspect/inspection_colors.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace app {

/** \brief Red, green, blue, 0 to 1. */
using Color = std::array<double, 3>;

/** \brief Pale, so that lines and coloured parts stand out. */
constexpr Rgb OUTER_SIDE_PALE{230, 230, 224};
constexpr Rgb INNER_SIDE_PALE{158, 148, 138};

/** \brief The inner side where the outer one is coloured. */
constexpr Rgb INNER_SIDE_DARK{89, 89, 97};

/** \brief Of edges that are drawn on faces: dark grey. */
constexpr Color MESH_EDGE{0.15, 0.20, 0.28};

constexpr Color
toColor(const Rgb& color)
{
  return {color[0] / 255.0, color[1] / 255.0, color[2] / 255.0};
}

inline Rgb
toRgb(const Color& color)
{
  Rgb bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<std::uint8_t>(std::lround(255.0 * color[i]));
  return bytes;
}

/** \brief Faces in one colour, with another for their back, flat shaded: smoothing
 * would hide a triangle that sticks out. */
vtkSmartPointer<vtkActor>
makeFaces(vtkPolyData* part, const Color& front, const Color& back);

/** \brief Faces without dark shadows, in which lines and colours would be lost. */
void
brighten(vtkActor& faces);

/** \brief Lines or dots of so many pixels, unlit, so that their colour is the same
 * everywhere. */
vtkSmartPointer<vtkActor>
makeMarks(vtkPolyData* part, const Color& color, double size);

/** \brief Draw \a part, which has a colour per point, in place of the actor's own. */
void
showColors(vtkPolyData* part, vtkActor& actor);

/** \brief A white renderer with a key light from above the camera, softened from the
 * sides and behind. */
vtkSmartPointer<vtkRenderer>
makeRenderer();

/** \brief Draws pictures of one size off-screen. Making one takes longer than many a
 * picture. Needs a display (see display.h), which has to outlive it. */
class Painter {
public:
  Painter(int width, int height);

  /** \brief A picture as the bytes of a PNG file; empty when none could be taken. Each
   * renderer fills its viewport. */
  std::string
  draw(const std::vector<vtkSmartPointer<vtkRenderer>>& renderers);

private:
  vtkSmartPointer<vtkRenderWindow> window_;
};

/** \brief The same for a single picture. */
std::string
drawPng(const std::vector<vtkSmartPointer<vtkRenderer>>& renderers,
        int width,
        int height);

/** \brief What a window shows, drawn anew, as the bytes of a PNG file; empty when no
 * picture could be taken. */
std::string
encodePng(vtkRenderWindow& window);

} // namespace app
