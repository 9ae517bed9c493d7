// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a repair found and did.

#include <pcl/surface_repair/repair_report.h>

namespace pcl {

const char*
describe(OpenReason reason)
{
  switch (reason) {
  case OpenReason::NONE:
    return "it is closed";
  case OpenReason::OUTER_BORDER:
    return "it is the outer border of an open surface";
  case OpenReason::TUBE_MOUTH:
    return "it is the mouth of an open tube";
  case OpenReason::DIFFERENT_OBJECTS:
    return "what lies beyond it is another object";
  case OpenReason::DEPTH_JUMP:
    return "the sensor would see a surface across it edge-on";
  case OpenReason::SEEN_EMPTY:
    return "the sensor has seen that nothing is there";
  case OpenReason::FIN:
    return "its small island hangs on an edge that is whole without it";
  case OpenReason::NOT_JOINED:
    return "no bridge joins its island to another one";
  case OpenReason::UNDECIDED:
    return "it is not clear whether it is a hole or a border";
  case OpenReason::ONE_SIDED:
    return "its island has no two sides";
  case OpenReason::TOO_LARGE:
    return "it is larger than what is to be closed";
  case OpenReason::NO_FILLING:
    return "no filling method closes it";
  case OpenReason::NOT_MANIFOLD:
    return "closing it would give an edge three triangles";
  case OpenReason::INTERSECTION:
    return "closing it would run through the surface";
  case OpenReason::TOO_COSTLY:
    return "closing it would take more work than its size is worth";
  case OpenReason::PIERCED:
    return "the surface runs through its boundary";
  case OpenReason::NOT_WANTED:
    return "it was not to be closed or joined";
  }
  return "";
}

const char*
describe(DoubtReason reason)
{
  switch (reason) {
  case DoubtReason::TUNNEL:
    return "two holes that were closed may be the mouths of a tunnel";
  case DoubtReason::LONG_GAP:
    return "two boundaries were joined over a long gap on evidence that hardly "
           "decides, or since there is no better partner";
  case DoubtReason::PARTED:
    return "two boundaries that belong together by evidence came out in two pieces";
  case DoubtReason::UNJOINED:
    return "two parts that were closed apart may belong together";
  case DoubtReason::THIN_NECK:
    return "the surface narrows to a few edges and widens again, where bodies may "
           "touch";
  case DoubtReason::UNSUPPORTED:
    return "so much of the surface is new that more may be lost than can be told";
  }
  return "";
}

const char*
nameOf(DoubtReason reason)
{
  switch (reason) {
  case DoubtReason::TUNNEL:
    return "TUNNEL";
  case DoubtReason::LONG_GAP:
    return "LONG_GAP";
  case DoubtReason::PARTED:
    return "PARTED";
  case DoubtReason::UNJOINED:
    return "UNJOINED";
  case DoubtReason::THIN_NECK:
    return "THIN_NECK";
  case DoubtReason::UNSUPPORTED:
    return "UNSUPPORTED";
  }
  return "";
}

const char*
nameOf(OpenReason reason)
{
  switch (reason) {
  case OpenReason::NONE:
    return "NONE";
  case OpenReason::OUTER_BORDER:
    return "OUTER_BORDER";
  case OpenReason::TUBE_MOUTH:
    return "TUBE_MOUTH";
  case OpenReason::DIFFERENT_OBJECTS:
    return "DIFFERENT_OBJECTS";
  case OpenReason::DEPTH_JUMP:
    return "DEPTH_JUMP";
  case OpenReason::SEEN_EMPTY:
    return "SEEN_EMPTY";
  case OpenReason::FIN:
    return "FIN";
  case OpenReason::NOT_JOINED:
    return "NOT_JOINED";
  case OpenReason::UNDECIDED:
    return "UNDECIDED";
  case OpenReason::ONE_SIDED:
    return "ONE_SIDED";
  case OpenReason::TOO_LARGE:
    return "TOO_LARGE";
  case OpenReason::NO_FILLING:
    return "NO_FILLING";
  case OpenReason::NOT_MANIFOLD:
    return "NOT_MANIFOLD";
  case OpenReason::INTERSECTION:
    return "INTERSECTION";
  case OpenReason::TOO_COSTLY:
    return "TOO_COSTLY";
  case OpenReason::PIERCED:
    return "PIERCED";
  case OpenReason::NOT_WANTED:
    return "NOT_WANTED";
  }
  return "";
}

bool
isShortfall(OpenReason reason)
{
  switch (reason) {
  case OpenReason::NONE:
  case OpenReason::OUTER_BORDER:
  case OpenReason::TUBE_MOUTH:
  case OpenReason::DIFFERENT_OBJECTS:
  case OpenReason::DEPTH_JUMP:
  case OpenReason::SEEN_EMPTY:
  case OpenReason::FIN:
  case OpenReason::TOO_LARGE:
  case OpenReason::NOT_WANTED:
    return false;
  default:
    return true;
  }
}

const char*
describe(TriangleOrigin origin)
{
  switch (origin) {
  case TriangleOrigin::INPUT:
    return "input";
  case TriangleOrigin::FAN:
    return "fan";
  case TriangleOrigin::MINIMUM_WEIGHT:
    return "minimum weight";
  case TriangleOrigin::COMPLETION:
    return "completion";
  }
  return "";
}

} // namespace pcl
