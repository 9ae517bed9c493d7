// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the growing greedy mesh and its three-part test
// (thesis 3.3).
#include "greedy/edge_compatibility.h"

#include "greedy/slot_match.h"

#include <cassert>
#include <cmath>

namespace pcl::ccaa {
namespace {

/** An edge leaving a point: single precision, of which the differences of coordinates
 * have no more anyway. */
struct Direction {
  float x, y, z;
  double squared_length;
};

struct Vector {
  double x, y, z;
};

Vector
between(const Coordinates& from, const Coordinates& to)
{
  // Differences of floats of like size are exact in double: no loss far from the
  // origin.
  return {double(to[0]) - double(from[0]),
          double(to[1]) - double(from[1]),
          double(to[2]) - double(from[2])};
}

double
dot(const Vector& a, const Vector& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

float
product(const Direction& u, const Direction& v)
{
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

Direction
towards(const Coordinates& from, const Coordinates& to)
{
  Direction d{to[0] - from[0], to[1] - from[1], to[2] - from[2], 0};
  d.squared_length = product(d, d);
  return d;
}

/** Whether the angle between two directions is under the limit, without root or acos,
 * and without branches: the answers are as good as random. Squares are compared in
 * double, where they cannot underflow. */
bool
isSharper(const Direction& u, const Direction& v, const AngleLimit& limit)
{
  const double along = product(u, v);
  const bool ahead = along > 0;
  const bool narrow =
      along * along > limit.squared_cosine * u.squared_length * v.squared_length;
  return ahead && narrow;
}

/** How two apexes lie to an edge ab and to each other. */
enum class ApexPair { ACROSS, FIRST_INSIDE, SECOND_INSIDE, SIDE_BY_SIDE };

/** Whether r, given by its products with base ab and apex q, lies inside triangle abq
 * once it is laid into its plane. */
bool
isInside(double base, double along_q, double height_q, double along_r, double rq)
{
  const double t = (rq - along_r * along_q / base) / height_q;
  const double s = (along_r - t * along_q) / base;
  return t > 0 && s > 0 && s + t < 1;
}

ApexPair
classify(const Coordinates& a,
         const Coordinates& b,
         const Coordinates& first,
         const Coordinates& second)
{
  const Vector base = between(a, b), p = between(a, first), q = between(a, second);
  const double length = dot(base, base);
  const double along_p = dot(p, base), along_q = dot(q, base), product = dot(p, q);
  const double height_p = dot(p, p) - along_p * along_p / length;
  const double height_q = dot(q, q) - along_q * along_q / length;
  if (product - along_p * along_q / length <= 0 || height_p <= 0 || height_q <= 0)
    return ApexPair::ACROSS;
  if (isInside(length, along_q, height_q, along_p, product))
    return ApexPair::FIRST_INSIDE;
  if (isInside(length, along_p, height_p, along_q, product))
    return ApexPair::SECOND_INSIDE;
  return ApexPair::SIDE_BY_SIDE;
}

} // namespace

AngleLimit
AngleLimit::fromRadians(double angle)
{
  const double cosine = std::cos(angle);
  return {cosine * cosine};
}

JoinedEdges::JoinedEdges(const RankedPoints& points, const LoopContext& context)
: coordinates_(points.coordinates)
, rows_(points.size())
, triangle_counts_(points.size())
{
  forEachBlock(rows_.size(), context, [&](auto, auto begin, auto end) {
    for (std::size_t i = begin; i < end; ++i) {
      rows_[i].neighbors.fill(NeighborRows::NONE);
      triangle_counts_[i] = 0;
    }
  });
}

unsigned int
JoinedEdges::slotOf(index_t rank, index_t neighbor) const
{
  const std::uint32_t match =
      matchSixteen(rows_[static_cast<std::size_t>(rank)].neighbors.data(), neighbor);
  return match == 0 ? SLOTS : static_cast<unsigned int>(__builtin_ctz(match));
}

unsigned int
JoinedEdges::degree(index_t rank) const
{
  return slotOf(rank, NeighborRows::NONE);
}

bool
JoinedEdges::isClosed(index_t rank) const
{
  const unsigned int edges = degree(rank);
  const std::uint32_t twos = 0xAAAAAAAAu;
  const std::uint32_t wanted = edges == SLOTS ? twos : twos & ((1u << 2 * edges) - 1u);
  return edges >= 3 && triangle_counts_[static_cast<std::size_t>(rank)] == wanted;
}

JoinedEdges::Apexes
JoinedEdges::commonNeighbors(index_t a, index_t b) const
{
  Apexes apexes;
  const Row& row = rows_[static_cast<std::size_t>(a)];
  for (unsigned int slot = 0; slot < SLOTS && row.neighbors[slot] != NeighborRows::NONE;
       ++slot) {
    const unsigned int slot_at_b = slotOf(b, row.neighbors[slot]);
    if (slot_at_b < SLOTS)
      apexes.apex[apexes.count++] = {row.neighbors[slot], slot, slot_at_b};
  }
  return apexes;
}

/** Rule 2. Two apexes joined across the edge mean that the edge crosses theirs:
 * refused. An apex inside the triangle of another one on the same side is no crossing
 * but a point with three edges; then the outer triangle is not one of the surface and
 * is left out. */
bool
JoinedEdges::crossesOrShadows(index_t a, index_t b, Apexes& apexes) const
{
  const auto place = [this](index_t rank) -> const Coordinates& {
    return coordinates_[static_cast<std::size_t>(rank)];
  };
  std::uint32_t shadowed = 0;
  for (unsigned int i = 0; i < apexes.count; ++i)
    for (unsigned int j = i + 1; j < apexes.count; ++j) {
      const index_t c = apexes.apex[i].rank, d = apexes.apex[j].rank;
      if (!areJoined(c, d))
        continue;
      switch (classify(place(a), place(b), place(c), place(d))) {
      case ApexPair::FIRST_INSIDE:
        shadowed |= 1u << j;
        break;
      case ApexPair::SECOND_INSIDE:
        shadowed |= 1u << i;
        break;
      default:
        return true;
      }
    }
  unsigned int kept = 0;
  for (unsigned int i = 0; i < apexes.count; ++i)
    if ((shadowed >> i & 1u) == 0)
      apexes.apex[kept++] = apexes.apex[i];
  apexes.count = kept;
  return false;
}

/** Rule 1. */
bool
JoinedEdges::overfills(index_t a, index_t b, const Apexes& apexes) const
{
  if (apexes.count > 2 || isFull(a) || isFull(b))
    return true;
  for (const Apex& c : apexes)
    if (trianglesAt(a, c.slot_at_a) >= 2 || trianglesAt(b, c.slot_at_b) >= 2)
      return true;
  return false;
}

bool
JoinedEdges::hasSmallAngleAt(index_t at, index_t end, const AngleLimit& limit) const
{
  const Coordinates& place = coordinates_[static_cast<std::size_t>(at)];
  const Direction edge = towards(place, coordinates_[static_cast<std::size_t>(end)]);
  bool small = false;
  for (const index_t other : rows_[static_cast<std::size_t>(at)].neighbors) {
    if (other == NeighborRows::NONE)
      break;
    const Coordinates& beside = coordinates_[static_cast<std::size_t>(other)];
    small |= isSharper(edge, towards(place, beside), limit);
  }
  return small;
}

/** Rule 3: at both ends against every edge there, and at the apexes. */
bool
JoinedEdges::hasSmallAngle(index_t a,
                           index_t b,
                           const Apexes& apexes,
                           const AngleLimit& limit) const
{
  if (hasSmallAngleAt(a, b, limit) || hasSmallAngleAt(b, a, limit))
    return true;
  const Coordinates& from = coordinates_[static_cast<std::size_t>(a)];
  const Coordinates& to = coordinates_[static_cast<std::size_t>(b)];
  for (const Apex& apex : apexes) {
    const Coordinates& c = coordinates_[static_cast<std::size_t>(apex.rank)];
    if (isSharper(towards(c, from), towards(c, to), limit))
      return true;
  }
  return false;
}

void
JoinedEdges::addSlot(index_t rank, index_t neighbor, unsigned int triangles)
{
  const unsigned int slot = degree(rank);
  assert(slot < SLOTS && "rule 1 keeps rows from running over");
  rows_[static_cast<std::size_t>(rank)].neighbors[slot] = neighbor;
  triangle_counts_[static_cast<std::size_t>(rank)] |= triangles << (2 * slot);
}

EdgeVerdict
JoinedEdges::join(index_t a, index_t b, const AngleLimit& limit, Triangles& triangles)
{
  if (areJoined(a, b))
    return EdgeVerdict::PRESENT;
  Apexes apexes = commonNeighbors(a, b);
  if (apexes.count > 1 && crossesOrShadows(a, b, apexes))
    return EdgeVerdict::TETRAHEDRON;
  if (overfills(a, b, apexes))
    return EdgeVerdict::OVERFULL;
  if (hasSmallAngle(a, b, apexes, limit))
    return EdgeVerdict::SMALL_ANGLE;
  addSlot(a, b, apexes.count);
  addSlot(b, a, apexes.count);
  for (const Apex& c : apexes) {
    countTriangle(a, c.slot_at_a);
    countTriangle(b, c.slot_at_b);
    countTriangle(c.rank, slotOf(c.rank, a));
    countTriangle(c.rank, slotOf(c.rank, b));
    triangles.push_back({a, b, c.rank});
  }
  return EdgeVerdict::JOINED;
}

} // namespace pcl::ccaa
