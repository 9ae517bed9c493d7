// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the facts about a mesh as a table and as JSON.
#pragma once

#include "mesh/mesh_facts.h"
#include <nlohmann/json_fwd.hpp>

#include <string>

namespace app {

/** \brief All facts; the keys are explained in doc/apps.md. */
nlohmann::json
describeFacts(const pcl::ccaa::MeshFacts& facts);

/** \brief Whether the mesh is sound, in one line without an end. */
std::string
summarizeFacts(const pcl::ccaa::MeshFacts& facts);

/** \brief All facts, a line each, for people. */
std::string
tabulateFacts(const pcl::ccaa::MeshFacts& facts);

} // namespace app
