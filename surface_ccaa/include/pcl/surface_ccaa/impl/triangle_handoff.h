// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a chain and its own algorithms hand to each other.
#pragma once

#include <pcl/types.h>

#include <array>
#include <memory>
#include <vector>

namespace pcl::ccaa {

struct VertexAdjacency;
using TriangleList = std::vector<std::array<index_t, 3>>;

/** \brief Triangles of cloud indices in place of polygons, of which each is a block of
 * memory of its own. */
struct TriangleHandoff {
  const TriangleList* given = nullptr; /**< in place of those of the mesh */
  TriangleList made;                   /**< in place of those of the output */
  /** \brief Of what is given, to be taken over, then of what is made; null: unknown. */
  std::shared_ptr<VertexAdjacency> adjacency;
};

/** \brief Base of the algorithms that can take part. */
class TakesHandoff {
public:
  /** \brief For a chain. \param[in] handoff null: none; must outlive the run */
  void
  setHandoff(TriangleHandoff* handoff)
  {
    handoff_ = handoff;
  }

protected:
  ~TakesHandoff() = default;
  TriangleHandoff* handoff_ = nullptr;
};

/** \brief Lends a handoff to an algorithm for one run. */
class LentHandoff {
public:
  /** \param[in] algorithm null: to none */
  LentHandoff(TakesHandoff* algorithm, TriangleHandoff& handoff) : algorithm_(algorithm)
  {
    if (algorithm_ != nullptr)
      algorithm_->setHandoff(&handoff);
  }
  ~LentHandoff()
  {
    if (algorithm_ != nullptr)
      algorithm_->setHandoff(nullptr);
  }
  LentHandoff(const LentHandoff&) = delete;
  LentHandoff&
  operator=(const LentHandoff&) = delete;

private:
  TakesHandoff* algorithm_;
};

} // namespace pcl::ccaa
