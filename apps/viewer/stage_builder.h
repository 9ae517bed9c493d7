// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: puts a stage of the viewer together.
#pragma once

#include <vtkPolyData.h>

#include "viewer/stages.h"

namespace app {

/** \brief Widths of lines and dots, in pixels of a picture 900 high. */
constexpr double THICK = 4.0;
constexpr double DOT = 3.5;
constexpr double SMALL_DOT = 2.0;
constexpr double MEDIUM = 2.5;
constexpr double THIN = 1.2;

/** \brief Adds what is to be drawn, with its legend. What is empty is left out. */
class StageBuilder {
public:
  StageBuilder(std::string name, std::string title, std::string text);

  /** \brief Faces, which the legend counts as \a meaning; empty: it is silent. */
  void
  addSurface(vtkPolyData* faces, const Rgb& outer, const std::string& meaning);

  /** \brief Faces whose colour the legend explains by itself. */
  void
  addSurface(vtkPolyData* faces, const Rgb& outer, const Rgb& inner);

  /** \brief Lines or dots in one colour, counted. */
  void
  addMarks(Layer layer,
           vtkPolyData* marks,
           const Rgb& color,
           double size,
           const std::string& meaning);

  /** \brief Lines or dots with a colour each. */
  void
  addColored(Layer layer, vtkPolyData* marks, double size);

  /** \brief An inspection layer with its legend. */
  void
  addLayer(Layer layer, const InspectionLayer& content, double size);

  void
  addLegend(Layer layer, const Rgb& color, const std::string& meaning);

  /** \brief Say why there is nothing to see, in place of what happens here. */
  void
  setText(const std::string& text);

  Stage
  finish();

private:
  Stage stage_;
};

} // namespace app
