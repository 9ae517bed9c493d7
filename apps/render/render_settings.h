// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how a picture of a mesh is taken.
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>

namespace app {

/** \brief What the colours of a picture tell. */
enum class Coloring {
  NONE,      /**< one colour for front faces, another for back faces */
  ROLE,      /**< that, and free points as blue dots, boundary points as red ones */
  COMPONENT, /**< each connected component in a colour of its own */
  RGB        /**< the colours of the points */
};

/** \brief Camera and style. Directions need no unit length. */
struct RenderSettings {
  int width = 1200;                       /**< pixels */
  int height = 900;                       /**< pixels */
  Eigen::Vector3d view = {0.0, 0.0, 1.0}; /**< from the object towards the camera */
  Eigen::Vector3d up = {0.0, 1.0, 0.0};   /**< what points up in the picture */
  std::optional<Eigen::Vector3d> focus; /**< centre of the picture, else the object's */
  double zoom = 1.0;                    /**< 1 shows the whole object */
  bool edges = false;                   /**< draw the edges of all triangles */
  bool boundaries = true;               /**< draw boundary edges red */
  double point_size = 2.0;              /**< of the dots that show points, pixels */
  Coloring coloring = Coloring::NONE;
  std::string new_since; /**< file with an earlier state of the mesh; empty: none */
};

} // namespace app
