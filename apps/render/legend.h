// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the column beside a picture that explains its colours.
#pragma once

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "common/inspection.h"

#include <string>
#include <vector>

namespace app {

/** \brief What the column says. */
struct Legend {
  std::string title;
  std::vector<LegendEntry> entries;
};

/** \brief Width of the column for a picture of this height, in pixels. */
int
legendWidth(int height);

/** \brief The column, to be shown at the left of a picture of this size. */
vtkSmartPointer<vtkRenderer>
makeLegend(const Legend& legend, int width, int height);

} // namespace app
