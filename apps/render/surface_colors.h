// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the colours of the two sides of a surface.
#pragma once

#include "inspect/inspection_colors.h"
#include "render/drawing.h"

#include <cmath>

namespace app {

/** \brief Pale, so that lines and coloured parts stand out. */
constexpr Rgb OUTER_SIDE_PALE{230, 230, 224};
constexpr Rgb INNER_SIDE_PALE{158, 148, 138};

/** \brief The inner side where the outer one is coloured. */
constexpr Rgb INNER_SIDE_DARK{89, 89, 97};

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

} // namespace app
