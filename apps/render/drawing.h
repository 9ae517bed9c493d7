// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what all pictures are put together from.
#pragma once

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <vector>

namespace app {

/** \brief Red, green, blue, 0 to 1. */
using Color = std::array<double, 3>;

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
