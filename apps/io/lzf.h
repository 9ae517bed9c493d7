// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: unpacks the LZF compression of PCD files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace app {

/** \brief Unpack LZF data into \a output, whose size is the expected one.
 *
 * An own decoder, because PCL's ties the apps to all of its input library and VTK; the
 * format is a stream of literal runs (control byte below 32) and copies from up to 8
 * KiB back. Every read and write is checked against its bounds. \return false when the
 * data is damaged or of another size. */
bool
unpackLzf(const char* input, std::size_t input_size, std::vector<char>& output);

/** \brief How many bytes \a input unpacks to.
 * \return false when it is damaged. */
bool
measureLzf(const char* input, std::size_t input_size, std::size_t& output_size);

} // namespace app
