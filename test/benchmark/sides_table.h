// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how much of a scene from one side faces the sensor.
#pragma once

#include <cstdint>
#include <iosfwd>

namespace bench {

/** \brief Generated and real scenes seen from one place: triangles, the share of them
 * that faces the sensor after filter, base and repair, and what told it. */
void
printSides(std::ostream& out, std::uint64_t seeds);

} // namespace bench
