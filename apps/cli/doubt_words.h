// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what there is to say of doubts about a reconstruction.
#pragma once

#include <pcl/surface_ccaa/reconstruction_report.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace app {

/** \brief How often a reconstruction is in doubt (pcl::TopologyDoubts), and where one
 * such place is, such as "at 1 2 3"; empty: not told. */
struct DoubtCounts {
  std::uint64_t handles = 0;
  std::uint64_t touching_pieces = 0;
  std::uint64_t thin_necks = 0;
  std::string handle_at, touching_at, neck_at;
};

DoubtCounts
countsOf(const pcl::TopologyDoubts& doubts);

/** \brief Places of a cloud without a triangle if they are more than those with one,
 * else 0: then what came out is no surface of the cloud. */
std::size_t
mostlyUnused(std::size_t places, std::size_t used);

/** \brief What there is to say of so many. */
std::string
tellUnused(std::size_t unused);

/** \brief Add what each kind of doubt is called, with its number, to a list of what a
 * repair has told. */
void
listDoubts(const DoubtCounts& doubts, std::string& list);

/** \brief What there is to say of the first kind of doubt that there is; empty: none.
 * \param[in] at_most before numbers that may be too high */
std::string
tellDoubts(const DoubtCounts& doubts, const std::string& at_most = "");

} // namespace app
