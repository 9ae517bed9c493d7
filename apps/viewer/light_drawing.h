// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what is drawn of large parts while something happens.
#pragma once

#include <vtkActor.h>
#include <vtkMapper.h>
#include <vtkSmartPointer.h>

#include <map>
#include <utility>
#include <vector>

namespace app {

/** \brief Draws surfaces and dots coarsely that are too many to be drawn many times a
 * second, and else in slices, between which drawing can stop (VTK's AbortCheckEvent).
 * Both are made when they are needed first, and kept: some 20 bytes a triangle. */
class LightDrawing {
public:
  /** \brief Draw an actor coarsely from now on, if it is large. Cost, the first time:
   * linear in its triangles or dots. \return whether it is large */
  bool
  lighten(vtkActor& actor);

  /** \brief Draw all actors in full again. */
  void
  restore();

private:
  using MapperPtr = vtkSmartPointer<vtkMapper>;

  struct Mappers {
    MapperPtr coarse;
    MapperPtr sliced;
  };

  std::map<vtkDataObject*, Mappers> mappers_;           /**< of what is drawn */
  std::vector<std::pair<vtkActor*, MapperPtr>> sliced_; /**< of actors drawn coarsely */
};

} // namespace app
