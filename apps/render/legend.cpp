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
constexpr std::size_t SMALL_LETTERS_PER_LINE = 29;

/** \brief The text with line ends in place of some spaces, so many letters a line. */
std::string
wrap(const std::string& text, std::size_t letters)
{
  std::istringstream words(text);
  std::string wrapped;
  std::size_t length = 0;
  for (std::string word; words >> word; length += word.size() + 1) {
    const bool fits = length + word.size() <= letters;
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

/** \brief Writes from the upper end of the column downwards. */
class LegendColumn {
public:
  LegendColumn(vtkRenderer& renderer, int height)
  : renderer_(renderer)
  , letter_(letterHeight(height))
  , top_(height - letterHeight(height))
  {}

  void
  addTitle(const std::string& title)
  {
    const std::string wrapped = wrap(title, LETTERS_PER_LINE);
    const auto heading = makeText(wrapped, letter_, top_, letter_);
    heading->GetTextProperty()->BoldOn();
    renderer_.AddActor2D(heading);
    top_ -= letter_ * (3 + 6 * linesOf(wrapped)) / 5;
  }

  void
  addText(const std::string& text)
  {
    const std::string wrapped = wrap(text, SMALL_LETTERS_PER_LINE);
    renderer_.AddActor2D(makeText(wrapped, letter_, top_, small()));
    top_ -= small() * (4 + 6 * linesOf(wrapped)) / 5;
  }

  void
  addGap()
  {
    top_ -= letter_;
  }

  void
  addEntry(const LegendEntry& entry)
  {
    const std::string text = wrap(entry.meaning, LETTERS_PER_LINE);
    renderer_.AddActor2D(makeSquare(FRAME, letter_ - 1, top_ + 1, letter_ + 2));
    renderer_.AddActor2D(makeSquare(entry.color, letter_, top_, letter_));
    renderer_.AddActor2D(makeText(text, letter_ * 5 / 2, top_, letter_));
    top_ -= letter_ * (3 + 6 * linesOf(text)) / 5;
  }

  /** \brief The lines end at the lower end of the column; the first ones are left out
   * where they would run into what is above. */
  void
  addNotes(const std::vector<LegendNote>& notes)
  {
    const int line = small() * 23 / 20;
    const int room = std::max(0, (top_ - letter_) / line);
    const int count = std::min(static_cast<int>(notes.size()), room);
    int top = letter_ + line * count;
    for (auto note = notes.end() - count; note != notes.end(); ++note) {
      for (const auto& [text, left] :
           {std::pair{note->key, letter_}, std::pair{note->meaning, letter_ * 4}}) {
        const auto words = makeText(text, left, top, small());
        if (note->pale)
          words->GetTextProperty()->SetColor(0.65, 0.65, 0.65);
        renderer_.AddActor2D(words);
      }
      top -= line;
    }
  }

private:
  int
  small() const
  {
    return std::max(letter_ * 4 / 5, 10);
  }

  vtkRenderer& renderer_;
  int letter_;
  int top_;
};

} // namespace

int
letterHeight(int height)
{
  return std::max(height / 45, 11);
}

int
legendWidth(int height)
{
  return 15 * letterHeight(height);
}

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

vtkSmartPointer<vtkRenderer>
makeLegend(const Legend& legend, int width, int height)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->SetViewport(
      0.0, 0.0, static_cast<double>(legendWidth(height)) / width, 1.0);
  LegendColumn column(*renderer, height);
  column.addTitle(legend.title);
  if (!legend.text.empty())
    column.addText(legend.text);
  column.addGap();
  for (const LegendEntry& entry : legend.entries)
    column.addEntry(entry);
  column.addNotes(legend.notes);
  return renderer;
}

} // namespace app
