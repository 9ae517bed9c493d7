// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: writes inspection layers for other programs to open.
#pragma once

#include <pcl/surface_ccaa/global_shift.h>

#include "inspection.h"
#include "io/output_folder.h"

namespace app {

/** \brief A picture of some layers, as the bytes of a PNG file. */
struct InspectionPicture {
  std::string name; /**< of the file */
  std::string bytes;
};

/** \brief All names that files of an inspection can have. */
const std::vector<std::string>&
inspectionNames();

/** \brief Write the layers that hold something as .vtk or .pcd, the pictures, and
 * legend.txt, which explains them. Files of an earlier run that have no successor are
 * dropped. Layers are less the shift, which the legend tells. Errors are kept in the
 * folder's status. */
void
writeInspection(const std::vector<InspectionLayer>& layers,
                const std::vector<InspectionPicture>& pictures,
                const pcl::GlobalShift& shift,
                OutputFolder& folder);

} // namespace app
