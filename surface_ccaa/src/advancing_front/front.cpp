// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the directed boundary edges from which a surface grows.
#include "advancing_front/front.h"

namespace pcl::ccaa {

void
Front::addTriangle(const Triangle& triangle)
{
  const auto first = static_cast<FrontIndex>(edges_.size());
  for (std::size_t i = 0; i < 3; ++i)
    insert(triangle[i], triangle[(i + 1) % 3], triangle[(i + 2) % 3]);
  for (FrontIndex i = 0; i < 3; ++i)
    link(first + i, first + (i + 1) % 3);
  for (FrontIndex i = 0; i < 3; ++i)
    cancelWithOpposite(first + i);
}

void
Front::advance(FrontIndex i, pcl::index_t apex)
{
  const FrontEdge old = edge(i);
  remove(i);
  const FrontIndex first = insert(old.from, apex, old.to);
  const FrontIndex second = insert(apex, old.to, old.from);
  link(old.previous, first);
  link(first, second);
  link(second, old.next);
  cancelWithOpposite(first);
  cancelWithOpposite(second);
}

FrontIndex
Front::find(pcl::index_t from, pcl::index_t to) const
{
  FrontIndex i = firstAt(from);
  while (i != FrontEdge::NONE && (*this)[i].to != to)
    i = (*this)[i].next_there;
  return i;
}

FrontIndex
Front::insert(pcl::index_t from, pcl::index_t to, pcl::index_t apex)
{
  const auto i = static_cast<FrontIndex>(edges_.size());
  FrontEdge made;
  made.from = from;
  made.to = to;
  made.apex = apex;
  made.next_there = firstAt(from);
  made.alive = true;
  edges_.push_back(made);
  first_at_[static_cast<std::size_t>(from)] = i;
  return i;
}

void
Front::remove(FrontIndex i)
{
  edge(i).alive = false;
  FrontIndex* place = &first_at_[static_cast<std::size_t>(edge(i).from)];
  while (*place != i)
    place = &edge(*place).next_there;
  *place = edge(i).next_there;
}

void
Front::link(FrontIndex before, FrontIndex after)
{
  edge(before).next = after;
  edge(after).previous = before;
}

void
Front::cancelWithOpposite(FrontIndex i)
{
  const FrontIndex opposite = find(edge(i).to, edge(i).from);
  if (opposite == FrontEdge::NONE)
    return;
  const FrontEdge one = edge(i), other = edge(opposite);
  if (one.previous != opposite) // else the fan at one.from has closed
    link(one.previous, other.next);
  if (one.next != opposite) // else the fan at one.to has closed
    link(other.previous, one.next);
  remove(i);
  remove(opposite);
}

} // namespace pcl::ccaa
