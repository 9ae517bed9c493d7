// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: options of the methods, for every program that runs them.
#pragma once

#include <pcl/surface_repair/repair_parameters.h>

#include "command_line.h"
#include "io/decisions_file.h"

namespace app {

constexpr Word<pcl::repair::FieldMode> FIELD_MODES[] = {
    {"light", pcl::repair::FieldMode::LIGHT}, {"full", pcl::repair::FieldMode::FULL}};

constexpr Word<pcl::repair::FillingChoice> FILLING_CHOICES[] = {
    {"automatic", pcl::repair::FillingChoice::AUTOMATIC},
    {"fan", pcl::repair::FillingChoice::FAN},
    {"minimum-weight", pcl::repair::FillingChoice::MINIMUM_WEIGHT},
    {"completion", pcl::repair::FillingChoice::COMPLETION}};

constexpr Word<pcl::repair::CloseChoice> CLOSE_CHOICES[] = {
    {"all", pcl::repair::CloseChoice::ALL},
    {"holes", pcl::repair::CloseChoice::HOLES},
    {"none", pcl::repair::CloseChoice::NOTHING}};

/** \brief Add --viewpoint and --up. */
void
addSideOptions(CommandLine& command_line, pcl::ccaa::SideHints& told);

/** \brief Add the options of what is to be closed and joined. */
void
addWishOptions(CommandLine& command_line, pcl::repair::RepairParameters& method);

/** \brief Add these, and all other options of a repair. */
void
addMethodOptions(CommandLine& command_line, pcl::repair::RepairParameters& method);

} // namespace app
