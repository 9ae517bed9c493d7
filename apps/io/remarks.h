// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the lines of a file that are for people.
#pragma once

#include "input_file.h"
#include "model.h"
#include "output_file.h"

#include <string>
#include <string_view>
#include <vector>

namespace app {

/** \brief The mark that our own writers leave at the beginning of the file, which is
 * not handed on. */
constexpr std::string_view our_mark = "PclSurfaceRepair";

/** \brief Whether a file with these first bytes has our mark where our writers put it.
 */
bool
carriesOurMark(std::string_view beginning);

/** \brief Add a comment without our own mark, if there is more to it. */
void
addComment(std::string_view text, std::vector<std::string>& lines);

/** \brief Of a text format with comment lines (# or //) at its beginning, behind
 * \a lines_before others: keep those that name units. The rest tells of the file itself
 * and goes stale. */
void
readUnitComments(const InputFile& file, std::size_t lines_before, Remarks& remarks);

/** \brief All of them as comments behind our mark, for formats that know nothing else.
 */
std::vector<std::string>
asComments(const Remarks& remarks);

/** \brief Write these, each on a line behind "# ". */
void
writeComments(const Remarks& remarks, OutputFile& file);

/** \brief One line that begins with our mark, for formats with room for a title alone.
 */
std::string
asTitle(const Remarks& remarks);

/** \brief The units that a remark names ("units mm", "unit: inch", "scale in metres" is
 * none); empty if no remark does. */
std::string
namedUnits(const Remarks& remarks);

} // namespace app
