// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what there is to say of doubts about a reconstruction.
#include "doubt_words.h"

#include "io/wording.h"

namespace app {

DoubtCounts
countsOf(const pcl::TopologyDoubts& doubts)
{
  DoubtCounts counts;
  counts.handles = doubts.handles;
  counts.touching_pieces = doubts.touching_pieces.size();
  counts.thin_necks = doubts.thin_necks.size();
  return counts;
}

std::size_t
mostlyUnused(std::size_t places, std::size_t used)
{
  return places > 2 * used ? places - used : 0;
}

std::string
tellUnused(std::size_t unused)
{
  return plural(unused, "point") +
         " got no triangle, more than got one: the cloud shows a surface in small parts"
         " alone, or scatters by more than the distance of its points";
}

void
listDoubts(const DoubtCounts& doubts, std::string& list)
{
  const auto add = [&](std::uint64_t count, const char* name) {
    if (count > 0)
      addToList(list, std::to_string(count) + name);
  };
  add(doubts.handles, " THIN_HANDLE");
  add(doubts.touching_pieces, " TOUCHING_PIECES");
  // A repair tells again of those beside what it has made.
  if (list.find(" THIN_NECK") == std::string::npos)
    add(doubts.thin_necks, " THIN_NECK");
}

std::string
tellDoubts(const DoubtCounts& doubts, const std::string& at_most)
{
  const auto whereOne = [](const std::string& place) {
    return place.empty() ? "" : " (one is " + place + ")";
  };
  if (doubts.handles > 0)
    return "the surface has " + at_most + plural(doubts.handles, "handle") +
           " and places so thin, or so close to others, that some may be tunnels that "
           "nobody scanned" +
           whereOne(doubts.handle_at);
  if (doubts.touching_pieces > 0)
    return "closed pieces, or ends of one, come as near to others as points lie "
           "apart, at " +
           at_most + plural(doubts.touching_pieces, "place") +
           ": they may be one body, of which a thin neck was cut" +
           whereOne(doubts.touching_at);
  if (doubts.thin_necks > 0)
    return "the surface is narrow between two wide parts, at " + at_most +
           plural(doubts.thin_necks, "place") +
           ": what a neck joins there may be bodies that touch" +
           whereOne(doubts.neck_at);
  return "";
}

} // namespace app
