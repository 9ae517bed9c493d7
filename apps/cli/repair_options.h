// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the command line of pcl_repair_holes.
#pragma once

#include <pcl/surface_repair/repair_parameters.h>

#include "cli.h"
#include "output_format.h"

#include <string>
#include <vector>

namespace app {

/** \brief What the user asked pcl_repair_holes for. */
struct RepairSettings {
  std::string input;
  std::string output;                      /**< empty: none */
  std::vector<std::string> inputs;         /**< of a run over many; else empty */
  std::string output_folder;               /**< for their results */
  FileFormat format = FileFormat::UNKNOWN; /**< where no name tells it */
  bool dry_run = false;
  std::string bridges;     /**< empty: none */
  std::string inspect;     /**< folder; empty: none */
  std::string free_points; /**< empty: none */
  std::string report;      /**< empty: none */
  std::string decisions;   /**< file; empty: none */
  bool pictures = true;
  bool quiet = false;
  bool labels = false; /**< as a face property */
  unsigned int threads = 0;
  pcl::repair::RepairParameters method;

  Target
  target() const
  {
    return makeTarget(output, format);
  }

  /** \brief For what is found without a repair. A dry run looks for no bridges that a
   * repair would not build. */
  pcl::repair::SurveyParameters
  surveyParameters() const
  {
    pcl::repair::SurveyParameters parameters = method.survey;
    parameters.trace_between_islands = !dry_run || method.join_islands;
    return parameters;
  }

  /** \brief Whether a repaired mesh is asked for. */
  bool
  repairs() const
  {
    return !dry_run && !output.empty();
  }

  /** \brief Whether it is asked for what was found. */
  bool
  surveys() const
  {
    return dry_run || !inspect.empty();
  }
};

/** \brief As it is written on the command line. */
const char*
nameOf(pcl::repair::DarningChoice choice);

/** \brief What --help says besides the options. */
Usage
repairUsage();

/** \brief Add the names of files, and the options of the run and of the method with the
 * defaults of the library. */
void
addRepairOptions(CommandLine& command_line);

/** \brief Add the options of the method alone. */
void
addMethodOptions(CommandLine& command_line);

/** \brief Take these; fails with one sentence for a value out of range. */
Status
takeMethod(const Arguments& arguments, pcl::repair::RepairParameters& method);

/** \brief Take the settings; fails with one sentence for a value out of range or when
 * nothing is asked for. */
Status
takeRepairSettings(const Arguments& arguments, RepairSettings& settings);

/** \brief Read the file of decisions: there has to be one for a repair, there may be
 * one for a dry run, which writes it anew. */
Status
takeDecisions(RepairSettings& settings);

} // namespace app
