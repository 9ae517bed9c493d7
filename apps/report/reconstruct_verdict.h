// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how a reconstruction went.
#pragma once

#include "cli/reconstruct_run.h"

#include <string>

namespace app {

/** \brief Why a result is not complete, a sentence; empty: it is. */
std::string
tellIncomplete(const ReconstructSettings& settings, const ReconstructResult& result);

/** \brief What to do where noise has torn the surface, or made handles; part of
 * tellIncomplete() where that says anything. */
std::string
adviceFor(const ReconstructSettings& settings, const ReconstructResult& result);

/** \brief What came out, such as "watertight, in doubt (1 THIN_NECK)". */
std::string
tellVerdict(const ReconstructSettings& settings, const ReconstructResult& result);

} // namespace app
