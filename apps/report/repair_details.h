// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what reports on a model and on its repair have in common.
#pragma once

#include <pcl/surface_repair/repair_parameters.h>
#include <pcl/surface_repair/repair_report.h>

#include "cli/run_facts.h"
#include "mesh/surface_topology.h"
#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace app {

const char*
nameOf(pcl::repair::IcmClass icm_class);

nlohmann::json
describePosition(const Eigen::Vector3d& position);

nlohmann::json
describeReading(const pcl::repair::ReadingReport& reading);

nlohmann::json
describeParameters(const pcl::repair::RepairParameters& method);

/** \brief Add what tells the outer side of an island to its description. */
void
addSide(const pcl::repair::IslandSide& side, nlohmann::json& island);

/** \brief Add the class of a boundary loop, and what speaks for it. */
void
addClass(const pcl::repair::LoopClass& loop_class, nlohmann::json& loop);

/** \brief The verdict about a junction, and what speaks for and against it; angles in
 * degrees. */
void
addJunction(pcl::repair::JunctionVerdict verdict,
            double confidence,
            const pcl::repair::JunctionEvidence& evidence,
            nlohmann::json& junction);

/** \brief Keys `pieces`, `boundary_loops`, `euler_characteristic`, `genus`,
 * `watertight` of a report. */
nlohmann::json
describeTopology(const pcl::ccaa::SurfaceTopology& topology);

/** \brief Such as "watertight: yes, genus 0, Euler characteristic 2". */
std::string
summarizeTopology(bool is_watertight, std::optional<long> genus, long characteristic);

inline std::string
summarizeTopology(const pcl::ccaa::SurfaceTopology& topology)
{
  return summarizeTopology(
      topology.isWatertight(), topology.genus, topology.euler_characteristic);
}

/** \brief An index as a number for people: -1 for none. */
inline std::int32_t
indexOrMinusOne(std::size_t index)
{
  return index == pcl::repair::NONE ? -1 : static_cast<std::int32_t>(index);
}

/** \brief "3 fan, 1 completion": how often each name comes up, in the order of first
 * appearance. */
class Tally {
public:
  void
  add(const std::string& name, std::size_t times = 1);

  std::string
  text() const;

  /** \brief The same for names that are nouns: "3 holes, 1 island rim". */
  std::string
  nouns() const;

private:
  std::vector<std::pair<std::string, std::size_t>> counts_;
};

} // namespace app
