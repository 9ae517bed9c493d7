// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: exact tests of two shapes in space.
#include "mesh/exact_sign.h"
#include "mesh/intersection.h"

#include <algorithm>

namespace pcl::ccaa {
namespace {

using Signs = std::array<int, 3>;

/** \brief Whether c, which is on the line through a and b, lies between them. */
bool
liesBetween(const Position& a, const Position& b, const Position& c, int dropped)
{
  for (int i = 1; i < 3; ++i) {
    const int k = (dropped + i) % 3;
    if (c[k] < std::min(a[k], b[k]) || c[k] > std::max(a[k], b[k]))
      return false;
  }
  return true;
}

/** \brief Whether two closed segments of one plane meet. */
bool
segmentsMeetInPlane(const Position& p,
                    const Position& q,
                    const Position& a,
                    const Position& b,
                    int dropped)
{
  const int pa = turnInPlane(p, q, a, dropped), pb = turnInPlane(p, q, b, dropped);
  const int ap = turnInPlane(a, b, p, dropped), aq = turnInPlane(a, b, q, dropped);
  if (pa * pb < 0 && ap * aq < 0)
    return true;
  return (pa == 0 && liesBetween(p, q, a, dropped)) ||
         (pb == 0 && liesBetween(p, q, b, dropped)) ||
         (ap == 0 && liesBetween(a, b, p, dropped)) ||
         (aq == 0 && liesBetween(a, b, q, dropped));
}

/** \brief Whether no two of the signs are opposite. */
bool
agree(const Signs& signs)
{
  const auto range = std::minmax_element(signs.begin(), signs.end());
  return *range.first * *range.second >= 0;
}

bool
triangleContainsInPlane(const Corners& t, const Position& p, int dropped)
{
  return agree({turnInPlane(t[0], t[1], p, dropped),
                turnInPlane(t[1], t[2], p, dropped),
                turnInPlane(t[2], t[0], p, dropped)});
}

/** \brief The segment lies in the plane of the triangle. */
bool
segmentMeetsTriangleInPlane(const Position& p, const Position& q, const Corners& t)
{
  const int dropped = droppableAxis(t[0], t[1], t[2]);
  return triangleContainsInPlane(t, p, dropped) ||
         segmentsMeetInPlane(p, q, t[0], t[1], dropped) ||
         segmentsMeetInPlane(p, q, t[1], t[2], dropped) ||
         segmentsMeetInPlane(p, q, t[2], t[0], dropped);
}

/** \brief segmentMeetsTriangle() once the sides of p and q are known. */
bool
segmentMeets(
    const Position& p, const Position& q, int side_p, int side_q, const Corners& t)
{
  if (side_p * side_q > 0)
    return false;
  if (side_p == 0 && side_q == 0)
    return segmentMeetsTriangleInPlane(p, q, t);
  const int first = sideOfPlane(p, q, t[0], t[1]), next = sideOfPlane(p, q, t[1], t[2]);
  return first * next >= 0 && agree({first, next, sideOfPlane(p, q, t[2], t[0])});
}

Signs
sidesOf(const Corners& plane, const Corners& points)
{
  const ExactPlane exact(plane[0], plane[1], plane[2]);
  return {exact.sideOf(points[0]), exact.sideOf(points[1]), exact.sideOf(points[2])};
}

bool
anEdgeMeets(const Corners& edges, const Signs& sides, const Corners& triangle)
{
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    if (segmentMeets(edges[i], edges[next], sides[i], sides[next], triangle))
      return true;
  }
  return false;
}

/** \brief Whether all are strictly on one side. */
bool
isApart(const Signs& sides)
{
  return sides[0] != 0 && sides[0] == sides[1] && sides[1] == sides[2];
}

/** \brief Triangles without a common corner: where they meet, an edge of one of them
 * meets the other. */
bool
separateTrianglesMeet(const Corners& s, const Corners& t)
{
  const Signs of_t = sidesOf(s, t);
  if (isApart(of_t))
    return false;
  const Signs of_s = sidesOf(t, s);
  return !isApart(of_s) && (anEdgeMeets(t, of_t, s) || anEdgeMeets(s, of_s, t));
}

/** \brief s and t begin with a common corner: nothing else of one that is on one side
 * of the other's plane can meet the other. */
bool
farEdgesMeet(const Corners& s, const Corners& t)
{
  const ExactPlane of_t(t[0], t[1], t[2]);
  const int s1 = of_t.sideOf(s[1]), s2 = of_t.sideOf(s[2]);
  if (s1 * s2 > 0)
    return false;
  const ExactPlane of_s(s[0], s[1], s[2]);
  const int t1 = of_s.sideOf(t[1]), t2 = of_s.sideOf(t[2]);
  return t1 * t2 <= 0 &&
         (segmentMeets(s[1], s[2], s1, s2, t) || segmentMeets(t[1], t[2], t1, t2, s));
}

/** \brief s and t begin with a common edge. */
bool
foldOnto(const Corners& s, const Corners& t)
{
  if (sideOfPlane(s[0], s[1], s[2], t[2]) != 0)
    return false;
  const int dropped = droppableAxis(s[0], s[1], s[2]);
  return turnInPlane(s[0], s[1], s[2], dropped) ==
         turnInPlane(s[0], s[1], t[2], dropped);
}

/** \brief Bring the common corners to the front of both, in the same order.
 * \return how many there are */
std::size_t
alignCommonCorners(Corners& s, Corners& t)
{
  std::size_t common = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = common; j < 3; ++j)
      if (s[i] == t[j]) {
        std::swap(s[i], s[common]);
        std::swap(t[j], t[common]);
        ++common;
        break;
      }
  return common;
}

} // namespace

bool
isCollinear(const Corners& triangle)
{
  return droppableAxis(triangle[0], triangle[1], triangle[2]) < 0;
}

bool
segmentMeetsTriangle(const Position& p, const Position& q, const Corners& triangle)
{
  const ExactPlane plane(triangle[0], triangle[1], triangle[2]);
  return segmentMeets(p, q, plane.sideOf(p), plane.sideOf(q), triangle);
}

bool
trianglesMeet(const Corners& first, const Corners& second)
{
  Corners s = first, t = second;
  switch (alignCommonCorners(s, t)) {
  case 0:
    return separateTrianglesMeet(s, t);
  case 1:
    return farEdgesMeet(s, t);
  case 2:
    return foldOnto(s, t);
  default:
    return true;
  }
}

} // namespace pcl::ccaa
