// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: where tests find their input files.
#pragma once

#include "shapes.h"

#include <string>

namespace pcl::ccaa::test {

/** \brief Path of a real scan such as "bunny/bun_zipper.ply" in the folder named by the
 * environment variable PSR_SHARED_DATA, else in `../shared/data` beside the source
 * tree. Empty when it is not there: real scans are no part of the repository, such
 * tests are skipped (see SKIP_WITHOUT_DATA). */
std::string
sharedData(const std::string& name);

/** \brief Path of a generated input under test/data of the source tree. */
std::string
testData(const std::string& name);

/** \brief A PLY mesh or cloud as a Shape. \return false when it cannot be read. */
bool
readShape(const std::string& path, Shape& shape);

} // namespace pcl::ccaa::test

/** \brief Leaves the test as skipped when a path from sharedData() is empty. */
#define SKIP_WITHOUT_DATA(path)                                                        \
  if ((path).empty())                                                                  \
  GTEST_SKIP()                                                                         \
      << "no shared data here: set PSR_SHARED_DATA to the folder of test models"
