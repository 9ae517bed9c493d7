// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a patch whose edges can be split and flipped.

#include "fairing/patch_edges.h"

#include "icadm/model_assembly.h"

#include <algorithm>
#include <map>
#include <utility>

namespace pcl::repair {

PatchEdges::PatchEdges(const IncompleteModel& model, Patch& patch)
: model_(model), patch_(patch), across_(3 * patch.triangles.size(), BORDER)
{
  std::vector<std::pair<std::uint64_t, std::uint32_t>> sides;
  sides.reserve(across_.size());
  for (std::size_t side = 0; side < across_.size(); ++side)
    sides.emplace_back(key(from(side), to(side)), static_cast<std::uint32_t>(side));
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0, next = 0; i < sides.size(); i = next) {
    while (next < sides.size() && sides[next].first == sides[i].first)
      ++next;
    edges_.insert(sides[i].first);
    const std::uint32_t one = sides[i].second;
    const std::uint32_t other = sides[next - 1].second;
    if (next - i != 2 || from(one) != to(other))
      continue;
    across_[one] = other;
    across_[other] = one;
    const Pair pair = pairAt(one);
    if (pair.c == pair.d) // twice the same triangle
      across_[one] = across_[other] = BORDER;
  }
}

std::uint64_t
PatchEdges::key(std::size_t a, std::size_t b)
{
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 |
         static_cast<std::uint64_t>(std::max(a, b));
}

PatchEdges::Pair
PatchEdges::pairAt(std::size_t side) const
{
  const std::size_t other = across_[side];
  return {from(side),
          to(side),
          corner(side / 3, (side + 2) % 3),
          corner(other / 3, (other + 2) % 3)};
}

bool
PatchEdges::areJoinedInModel(std::size_t a, std::size_t b) const
{
  if (a >= patch_.rim.size() || b >= patch_.rim.size())
    return false;
  return repair::areJoined(model_, patch_.rim[a], patch_.rim[b]);
}

void
PatchEdges::setTriangle(std::size_t triangle,
                        const std::array<std::size_t, 3>& corners,
                        const std::array<std::uint32_t, 3>& beyond)
{
  for (std::size_t c = 0; c < 3; ++c) {
    patch_.triangles[triangle][c] = static_cast<pcl::index_t>(corners[c]);
    across_[3 * triangle + c] = beyond[c];
    if (beyond[c] != BORDER)
      across_[beyond[c]] = static_cast<std::uint32_t>(3 * triangle + c);
  }
}

std::size_t
PatchEdges::split(std::size_t side, const Position& place)
{
  const auto [a, b, c, d] = pairAt(side);
  const std::size_t other = across_[side];
  const std::size_t one = side / 3, two = other / 3, three = count() / 3;
  const std::size_t four = three + 1, middle = patch_.positions.size();
  const std::uint32_t bc = across_[3 * one + (side + 1) % 3];
  const std::uint32_t ca = across_[3 * one + (side + 2) % 3];
  const std::uint32_t ad = across_[3 * two + (other + 1) % 3];
  const std::uint32_t db = across_[3 * two + (other + 2) % 3];
  patch_.positions.push_back(place);
  patch_.free_point.push_back(NONE);
  patch_.triangles.resize(four + 1);
  patch_.hole.push_back(patch_.hole[one]);
  patch_.hole.push_back(patch_.hole[two]);
  across_.resize(3 * (four + 1), BORDER);
  const auto sideOf = [](std::size_t triangle, std::size_t corner) {
    return static_cast<std::uint32_t>(3 * triangle + corner);
  };
  setTriangle(one, {a, middle, c}, {sideOf(two, 0), sideOf(three, 2), ca});
  setTriangle(two, {middle, a, d}, {sideOf(one, 0), ad, sideOf(four, 1)});
  setTriangle(three, {middle, b, c}, {sideOf(four, 0), bc, sideOf(one, 1)});
  setTriangle(four, {b, middle, d}, {sideOf(three, 0), sideOf(two, 2), db});
  edges_.erase(key(a, b));
  for (const std::size_t end : {a, b, c, d})
    edges_.insert(key(middle, end));
  return middle;
}

std::vector<std::size_t>
PatchEdges::borderOf(const std::vector<std::size_t>& disc) const
{
  std::vector<std::size_t> border;
  for (const std::size_t triangle : disc)
    for (std::size_t side = 3 * triangle; side < 3 * triangle + 3; ++side)
      if (!isInner(side) ||
          std::find(disc.begin(), disc.end(), across_[side] / 3) == disc.end())
        border.push_back(side);
  return border;
}

std::size_t
PatchEdges::star(std::vector<std::size_t> disc, const Position& place)
{
  struct Spoke {
    std::size_t from, to;
    std::uint32_t beyond;
  };
  std::vector<Spoke> spokes;
  for (const std::size_t side : borderOf(disc))
    spokes.push_back({from(side), to(side), across_[side]});
  for (const std::size_t triangle : disc)
    for (std::size_t side = 3 * triangle; side < 3 * triangle + 3; ++side)
      edges_.erase(key(from(side), to(side)));
  const std::size_t middle = patch_.positions.size(), hole = patch_.hole[disc.front()];
  patch_.positions.push_back(place);
  patch_.free_point.push_back(NONE);
  while (disc.size() < spokes.size()) {
    disc.push_back(patch_.triangles.size());
    patch_.triangles.push_back({});
    patch_.hole.push_back(hole);
  }
  across_.resize(3 * patch_.triangles.size(), BORDER);
  std::map<std::size_t, std::size_t> from_spoke, to_spoke; // of vertices: triangles
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    from_spoke[spokes[i].from] = disc[i];
    to_spoke[spokes[i].to] = disc[i];
  }
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    const Spoke& spoke = spokes[i];
    setTriangle(disc[i],
                {spoke.from, spoke.to, middle},
                {spoke.beyond,
                 static_cast<std::uint32_t>(3 * from_spoke.at(spoke.to) + 2),
                 static_cast<std::uint32_t>(3 * to_spoke.at(spoke.from) + 1)});
    edges_.insert(key(spoke.from, spoke.to));
    edges_.insert(key(spoke.from, middle));
  }
  return middle;
}

void
PatchEdges::flip(std::size_t side)
{
  const auto [a, b, c, d] = pairAt(side);
  const std::size_t other = across_[side];
  const std::size_t one = side / 3, two = other / 3;
  const std::uint32_t bc = across_[3 * one + (side + 1) % 3];
  const std::uint32_t ca = across_[3 * one + (side + 2) % 3];
  const std::uint32_t ad = across_[3 * two + (other + 1) % 3];
  const std::uint32_t db = across_[3 * two + (other + 2) % 3];
  setTriangle(one, {a, d, c}, {ad, static_cast<std::uint32_t>(3 * two + 2), ca});
  setTriangle(two, {d, b, c}, {db, bc, static_cast<std::uint32_t>(3 * one + 1)});
  edges_.erase(key(a, b));
  edges_.insert(key(c, d));
}

} // namespace pcl::repair
