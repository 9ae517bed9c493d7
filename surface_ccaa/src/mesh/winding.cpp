// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: components of a mesh and the winding that suits each.
#include "mesh/winding.h"

#include "mesh/block_loop.h"
#include "mesh/label_sets.h"
#include "mesh/mesh_part.h"

#include <algorithm>

namespace pcl::ccaa {
namespace {

/** \brief Below so many triangles a part of its own costs more than it gains. */
constexpr std::size_t SMALLEST_PART = 20000;

std::vector<MeshPart>
cutIntoParts(std::size_t triangles, int threads)
{
  const std::size_t most = std::max<std::size_t>(1, triangles / SMALLEST_PART);
  const std::size_t count = std::min(most, static_cast<std::size_t>(threads));
  std::vector<MeshPart> parts;
  for (std::size_t i = 0; i < count; ++i)
    parts.emplace_back(triangles * i / count, triangles * (i + 1) / count);
  return parts;
}

/** \brief Puts the labels of all parts together over the edges between the parts. */
class PartMerger {
public:
  explicit PartMerger(const std::vector<MeshPart>& parts) : parts_(parts)
  {
    for (const MeshPart& part : parts) {
      shifts_.push_back(sets_.append(part.sets));
      labels_.insert(labels_.end(), part.labels.begin(), part.labels.end());
    }
  }

  void
  joinBorders(const std::vector<pcl::index_t>& state)
  {
    for (std::size_t part = 0; part < parts_.size(); ++part)
      for (const BorderEdge& edge : parts_[part].border) {
        const auto lower = static_cast<std::size_t>(edge.lower_triangle);
        const pcl::index_t own = edge.state + shifts_[part];
        const pcl::index_t other =
            (state[lower] + shifts_[partOf(lower)]) ^ edge.change;
        if (!sets_.join(own, other))
          labels_[static_cast<std::size_t>(own >> 1)].one_sided = true;
      }
  }

  /** \brief Components of the whole mesh; afterwards newState() may be asked. */
  std::vector<WoundComponent>
  merged()
  {
    std::vector<WoundComponent> components;
    states_.resize(labels_.size());
    for (std::size_t i = 0; i < labels_.size(); ++i) {
      const pcl::index_t link = sets_.link(i);
      const auto parent = static_cast<std::size_t>(link >> 1);
      if (parent == i) {
        states_[i] = 2 * static_cast<pcl::index_t>(components.size());
        components.push_back(labels_[i]);
        continue;
      }
      states_[i] = states_[parent] ^ (link & 1);
      add(labels_[i],
          (states_[i] & 1) != 0,
          components[static_cast<std::size_t>(states_[i] >> 1)]);
    }
    return components;
  }

  pcl::index_t
  newState(std::size_t part, pcl::index_t state) const
  {
    const auto label = static_cast<std::size_t>((state + shifts_[part]) >> 1);
    return states_[label] ^ (state & 1);
  }

private:
  std::size_t
  partOf(std::size_t triangle) const
  {
    std::size_t part = 0;
    while (triangle >= parts_[part].end())
      ++part;
    return part;
  }

  static void
  add(const WoundComponent& piece, bool turned, WoundComponent& sum)
  {
    sum.triangles += piece.triangles;
    sum.turned += turned ? piece.triangles - piece.turned : piece.turned;
    sum.closed = sum.closed && piece.closed;
    sum.one_sided = sum.one_sided || piece.one_sided;
  }

  const std::vector<MeshPart>& parts_;
  LabelSets sets_;
  std::vector<pcl::index_t> shifts_;
  std::vector<WoundComponent> labels_;
  std::vector<pcl::index_t> states_; /**< of each label */
};

} // namespace

bool
Winding::find(const Triangles& triangles,
              const TriangleAdjacency& adjacency,
              int threads,
              RunControl& control,
              const CutEdges& cut)
{
  state_.resize(triangles.size());
  std::vector<MeshPart> parts = cutIntoParts(triangles.size(), threads);
  const auto count = static_cast<int>(parts.size());
#pragma omp parallel for schedule(static, 1) num_threads(count) if (count > 1)
  for (int i = 0; i < count; ++i)
    parts[static_cast<std::size_t>(i)].label(
        triangles, adjacency, cut, state_, control);
  if (control.cancelled())
    return false;
  PartMerger merger(parts);
  merger.joinBorders(state_);
  components_ = merger.merged();
#pragma omp parallel for schedule(static, 1) num_threads(count) if (count > 1)
  for (int i = 0; i < count; ++i) {
    const auto index = static_cast<std::size_t>(i);
    for (std::size_t t = parts[index].begin(); t < parts[index].end(); ++t)
      state_[t] = merger.newState(index, state_[t]);
  }
  return true;
}

std::vector<std::uint8_t>
findDisagreements(const Triangles& triangles,
                  const TriangleAdjacency& adjacency,
                  const LoopContext& context)
{
  std::vector<std::uint8_t> disagrees(triangles.size(), 0);
  forEachBlock(triangles.size(), context, [&](auto, auto begin, auto end) {
    for (std::size_t t = begin; t < end; ++t)
      for (int corner = 0; corner < 3; ++corner)
        if (disagreesAcross(triangles, adjacency, static_cast<pcl::index_t>(t), corner))
          disagrees[t] = 1;
  });
  return disagrees;
}

} // namespace pcl::ccaa
