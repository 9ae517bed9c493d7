// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: unpacks the LZF data of compressed PCD files.
#pragma once

#include <cstddef>

namespace app {

/** \brief Unpack LZF data: runs of bytes (control byte below 32), and copies from up to
 * 8 KiB back. Every read and write is checked against its bounds.
 *
 * An own decoder, because liblzf and PCL's need the memory of the whole output before
 * they can say that the data is damaged, and three bytes may stand for 264.
 * \param[out] output of \a output_size bytes; null: only look whether it would fit
 * \return false when the data is damaged or of another size */
bool
unpackLzf(const char* input,
          std::size_t input_size,
          char* output,
          std::size_t output_size);

} // namespace app
