// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the command line of pcl_repair_holes.
#pragma once

#include "file_names.h"
#include "method_options.h"

#include <string>

namespace app {

/** \brief What the user asked pcl_repair_holes for. */
struct RepairSettings {
  FileNames files;
  bool dry_run = false;
  std::string bridges;     /**< empty: none */
  std::string inspect;     /**< folder; empty: none */
  std::string free_points; /**< empty: none */
  std::string decisions;   /**< file; empty: none */
  bool pictures = true;
  bool quiet = false;
  bool labels = false; /**< as a face property */
  unsigned int threads = 0;
  pcl::repair::RepairParameters method;

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
    return !dry_run && !files.output.empty();
  }

  /** \brief Whether it is asked for what was found. */
  bool
  surveys() const
  {
    return dry_run || !inspect.empty();
  }
};

/** \brief What --help says besides the options. */
Usage
repairUsage();

/** \brief Add all options but those of the pictures. */
void
addRepairOptions(CommandLine& command_line, RepairSettings& settings);

/** \brief Read the file of decisions: there has to be one for a repair, there may be
 * one for a dry run, which writes it anew. */
void
takeDecisions(RepairSettings& settings);

} // namespace app
