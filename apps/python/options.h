// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: options of the Python functions and the C++ values behind
// them.
#pragma once

#include <pcl/surface_ccaa/reconstruction_parameters.h>
#include <pcl/surface_ccaa/side_settings.h>
#include <pcl/surface_ccaa/umbrella_filter.h>
#include <pcl/surface_repair/boundary_classifier.h>
#include <pcl/surface_repair/repair_parameters.h>

#include "clean/clean_cloud.h"
#include <pybind11/pybind11.h>

namespace app::python {

/** \brief All options of pcl_surface's reconstruct(). */
struct ReconstructOptions {
  ReconstructOptions()
  {
    base.keep_given = false; // as in a chain: the start has a right of mistake
  }

  pcl::ccaa::GreedyParameters start;
  pcl::UmbrellaFilter filter;
  pcl::ccaa::CompletionParameters base;
};

/** \brief Set the options that a dictionary names.
 * Throws TypeError for a value of another kind, ValueError for a word that is none or a
 * number that is not finite. Names have been looked at. */
void
take(const pybind11::dict& given, CleanParameters& parameters);
void
take(const pybind11::dict& given, ReconstructOptions& options);
void
take(const pybind11::dict& given, pcl::UmbrellaFilter& filter);
void
take(const pybind11::dict& given, pcl::BoundaryClassifier& classifier);
void
take(const pybind11::dict& given, pcl::repair::RepairParameters& method);

/** \brief What the keys viewpoint, up and origin_as_viewpoint tell. */
pcl::ccaa::SideHints
sidesFrom(const pybind11::dict& given);

/** \brief The defaults of all options, by function and name. */
pybind11::dict
defaults();

} // namespace app::python
