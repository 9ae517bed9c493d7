// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: looks at pictures in tests.
#pragma once

#include "inspect/inspection_colors.h"

#include <string>
#include <vector>

namespace app_test {

/** \brief Red, green and blue of pixels, row by row. */
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<app::Rgb> pixels;
};

/** \brief A picture from the bytes of a PNG file; without pixels if they are none. */
Picture
decodePng(const std::string& bytes);

/** \brief What is to be seen on the X display named in $DISPLAY, in its windows. */
Picture
grabScreen();

/** \brief Columns of a picture, the last one excluded; 0: to the right end. */
struct Columns {
  int first = 0;
  int last = 0;
};

/** \brief Pixels of exactly this colour, as lines, dots and legends have it. */
std::size_t
countColor(const Picture& picture, const app::Rgb& color, Columns columns = {});

/** \brief Pixels of this colour under any light that is not too dim. */
std::size_t
countShaded(const Picture& picture, const app::Rgb& color, Columns columns = {});

} // namespace app_test
