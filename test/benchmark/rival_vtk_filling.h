// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: VTK's hole filling as a rival.
#pragma once

#include "support/shapes.h"

namespace bench {

/** \brief vtkFillHolesFilter for holes of any size; empty without VTK. */
pcl::ccaa::test::Shape
fillByVtk(const pcl::ccaa::test::Shape& shape);

} // namespace bench
