// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what is drawn of one step of the method.
#pragma once

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "inspect/inspection.h"

#include <cstdint>
#include <string>
#include <vector>

namespace app {

/** \brief What can be shown or hidden in every stage. */
enum class Layer : std::uint8_t { SURFACE, INNER_SIDE, EDGES, LINES, NORMALS, POINTS };

constexpr std::size_t LAYERS = 6;

/** \brief Something that is drawn. */
struct StagePart {
  Layer layer = Layer::SURFACE; /**< by which it is shown or hidden */
  vtkSmartPointer<vtkActor> actor;
  double size = 0.0; /**< of lines and dots: pixels of a picture 900 high */
};

/** \brief An entry of the legend, which is there as long as its layer is shown. */
struct StageColor {
  Layer layer = Layer::SURFACE;
  LegendEntry entry;
};

/** \brief One step of the method, and what it left. */
struct Stage {
  std::string name;  /**< one word, for the command line */
  std::string title; /**< for people */
  std::string text;  /**< what happens here, or why there is nothing to see */
  std::vector<StageColor> legend;
  std::vector<StagePart> parts;
};

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

  /** \brief Something made elsewhere. */
  void
  addActor(Layer layer, const vtkSmartPointer<vtkActor>& actor)
  {
    stage_.parts.push_back({layer, actor, 0.0});
  }

  /** \brief Say why there is nothing to see, in place of what happens here. */
  void
  setText(const std::string& text);

  Stage
  finish();

private:
  Stage stage_;
};

} // namespace app
