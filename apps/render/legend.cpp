// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the column beside a picture that explains its colours.
#include "render/legend.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <sstream>

namespace app {
namespace {

constexpr Rgb FRAME{150, 150, 150};
constexpr std::size_t LETTERS_PER_LINE = 22;

/** \brief Pixels that can be read, also in a small picture. */
int
letterHeight(int picture_height)
{
  return std::max(picture_height / 45, 11);
}

/** \brief The text with line ends in place of some spaces. */
std::string
wrap(const std::string& text)
{
  std::istringstream words(text);
  std::string wrapped;
  std::size_t length = 0;
  for (std::string word; words >> word; length += word.size() + 1) {
    const bool fits = length + word.size() <= LETTERS_PER_LINE;
    if (!wrapped.empty())
      wrapped += fits ? " " : "\n";
    if (!fits)
      length = 0;
    wrapped += word;
  }
  return wrapped;
}

int
linesOf(const std::string& text)
{
  return 1 + static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

/** \brief Text whose upper left corner is at a place in pixels. */
vtkSmartPointer<vtkTextActor>
makeText(const std::string& text, int left, int top, int size)
{
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetInput(text.c_str());
  actor->SetPosition(left, top);
  vtkTextProperty* const property = actor->GetTextProperty();
  property->SetFontFamilyToArial();
  property->SetFontSize(size);
  property->SetColor(0.1, 0.1, 0.1);
  property->SetVerticalJustificationToTop();
  return actor;
}

/** \brief A filled square whose upper left corner is at a place in pixels. */
vtkSmartPointer<vtkActor2D>
makeSquare(const Rgb& color, int left, int top, int side)
{
  const auto points = vtkSmartPointer<vtkPoints>::New();
  for (const auto& [x, y] :
       {std::pair{0, 0}, std::pair{side, 0}, std::pair{side, side}, std::pair{0, side}})
    points->InsertNextPoint(left + x, top - side + y, 0.0);
  const auto square = vtkSmartPointer<vtkPolyData>::New();
  square->SetPoints(points);
  square->SetPolys(vtkSmartPointer<vtkCellArray>::New());
  const vtkIdType corners[] = {0, 1, 2, 3};
  square->GetPolys()->InsertNextCell(4, corners);
  const auto mapper = vtkSmartPointer<vtkPolyDataMapper2D>::New();
  mapper->SetInputData(square);
  auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  return actor;
}

} // namespace

int
legendWidth(int height)
{
  return 15 * letterHeight(height);
}

vtkSmartPointer<vtkRenderer>
makeLegend(const Legend& legend, int width, int height)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->SetViewport(
      0.0, 0.0, static_cast<double>(legendWidth(height)) / width, 1.0);
  const int letter = letterHeight(height);
  const int left = letter;
  int top = height - letter;
  const std::string title = wrap(legend.title);
  const auto heading = makeText(title, left, top, letter);
  heading->GetTextProperty()->BoldOn();
  renderer->AddActor2D(heading);
  top -= letter * (3 + 6 * linesOf(title)) / 5 + letter;
  for (const LegendEntry& entry : legend.entries) {
    const std::string text = wrap(entry.meaning);
    renderer->AddActor2D(makeSquare(FRAME, left - 1, top + 1, letter + 2));
    renderer->AddActor2D(makeSquare(entry.color, left, top, letter));
    renderer->AddActor2D(makeText(text, left + letter * 3 / 2, top, letter));
    top -= letter * (4 + 6 * linesOf(text)) / 5;
  }
  return renderer;
}

} // namespace app
