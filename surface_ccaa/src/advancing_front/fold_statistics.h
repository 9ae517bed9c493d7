// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how sharply the edges of a mesh fold.
#pragma once

#include <Eigen/Geometry>

#include "advancing_front/tuning.h"
#include "mesh/block_loop.h"
#include "mesh/corners.h"
#include "mesh/islands.h"
#include "mesh/point_view.h"
#include "mesh/triangle.h"
#include "mesh/triangle_adjacency.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace pcl::ccaa {

/** \brief How the folds of some edges are spread: the fold of an edge is the angle
 * between the normals of its two triangles, 0 where they lie flat. */
class FoldStatistics {
public:
  /** Classes of equal width in the cosine: no acos for every edge. */
  static constexpr std::size_t CLASSES = 250;

  void
  add(std::size_t fold_class)
  {
    ++counts_[fold_class];
    ++total_;
  }

  /** \brief Lowest class that at most a share of all folds exceed. */
  std::size_t
  exceededBy(double share) const
  {
    std::size_t above = total_, fold_class = 0;
    for (; fold_class + 1 < CLASSES; ++fold_class) {
      above -= counts_[fold_class];
      if (static_cast<double>(above) <= share * static_cast<double>(total_))
        break;
    }
    return fold_class;
  }

  std::size_t
  total() const
  {
    return total_;
  }

  /** \brief Median fold in radians. */
  double
  median() const
  {
    const auto fold_class = static_cast<double>(exceededBy(0.5));
    return std::acos(1.0 - 2.0 * fold_class / static_cast<double>(CLASSES));
  }

  /** \param[in] cosine of the fold */
  static std::size_t
  classOf(double cosine)
  {
    const double share = std::max(0.0, 0.5 * (1.0 - cosine));
    return std::min(CLASSES - 1,
                    static_cast<std::size_t>(share * static_cast<double>(CLASSES)));
  }

private:
  std::array<std::size_t, CLASSES> counts_{};
  std::size_t total_ = 0;
};

/** \brief Class of the fold of every edge of a consistently wound mesh. */
class EdgeFolds {
public:
  static constexpr std::uint8_t NO_FOLD = 255; /**< the edge is a border */

  EdgeFolds(const Triangles& triangles,
            const TriangleAdjacency& adjacency,
            const PointView& points,
            const LoopContext& context)
  : classes_(3 * triangles.size(), NO_FOLD)
  {
    std::vector<Eigen::Vector3f> normals(triangles.size());
    forEachBlock(triangles.size(), context, [&](auto, auto begin, auto end) {
      for (std::size_t t = begin; t < end; ++t)
        normals[t] = unitNormal(cornersOf(triangles[t], points)).cast<float>();
    });
    forEachBlock(triangles.size(), context, [&](auto, auto begin, auto end) {
      for (std::size_t t = begin; t < end; ++t)
        for (int corner = 0; corner < 3; ++corner) {
          const index_t other = adjacency.across(static_cast<index_t>(t), corner);
          if (other < 0)
            continue;
          const float cosine = normals[t].dot(normals[static_cast<std::size_t>(other)]);
          classes_[3 * t + static_cast<std::size_t>(corner)] =
              static_cast<std::uint8_t>(
                  FoldStatistics::classOf(static_cast<double>(cosine)));
        }
    });
  }

  /** \brief Class of the edge from a corner to the next. */
  std::uint8_t
  operator()(std::size_t triangle, std::size_t corner) const
  {
    return classes_[3 * triangle + corner];
  }

  /** \brief Count the edges of a triangle. */
  void
  addTo(FoldStatistics& statistics, std::size_t triangle) const
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
      if ((*this)(triangle, corner) != NO_FOLD)
        statistics.add((*this)(triangle, corner));
  }

private:
  std::vector<std::uint8_t> classes_;
};

/** \brief The folds of the edges of each island. */
inline std::vector<FoldStatistics>
foldsByIsland(const EdgeFolds& folds, const Islands& islands)
{
  std::vector<FoldStatistics> statistics(islands.count);
  for (std::size_t t = 0; t < islands.of_triangle.size(); ++t)
    folds.addTo(statistics[islands[t]], t);
  return statistics;
}

/** \brief Median fold from which on an island counts as crumpled. */
inline double
crumpledFold(double trusted_median)
{
  return std::max(tuning::CRUMPLED_FOLD, tuning::CRUMPLED_RATIO * trusted_median);
}

/** \brief The same for a piece that grew by itself. */
inline double
crumpledFoldOfGrowth(double trusted_median)
{
  return std::max(tuning::CRUMPLED_GROWTH,
                  tuning::CRUMPLED_GROWTH_RATIO * trusted_median);
}

/** \brief The island with the most edges. */
inline std::size_t
largestIsland(const std::vector<FoldStatistics>& statistics)
{
  const auto largest = std::max_element(
      statistics.begin(), statistics.end(), [](const auto& one, const auto& other) {
        return one.total() < other.total();
      });
  return static_cast<std::size_t>(largest - statistics.begin());
}

} // namespace pcl::ccaa
