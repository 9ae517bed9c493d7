// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the column beside a picture that explains its colours.
#pragma once

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include "inspect/inspection.h"

#include <string>
#include <vector>

namespace app {

/** \brief A short word and what it stands for. */
struct LegendNote {
  std::string key;
  std::string meaning;
  bool pale = false;
};

/** \brief What the column says. */
struct Legend {
  std::string title;
  std::string text; /**< below the title; empty: none */
  std::vector<LegendEntry> entries;
  std::vector<LegendNote> notes; /**< at the lower end */
};

/** \brief Width of the column for a picture of this height, in pixels. */
int
legendWidth(int height);

/** \brief Height of letters that can be read in a picture of this height, in pixels. */
int
letterHeight(int height);

/** \brief Text whose upper left corner is at a place in pixels. */
vtkSmartPointer<vtkTextActor>
makeText(const std::string& text, int left, int top, int size);

/** \brief The column, to be shown at the left of a picture of this size. */
vtkSmartPointer<vtkRenderer>
makeLegend(const Legend& legend, int width, int height);

} // namespace app
