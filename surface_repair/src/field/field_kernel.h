// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the border between the indicator field and its kernels.
#pragma once

#include <cstddef>
#include <cstdint>

#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
#define PCL_REPAIR_HAS_X86_KERNELS
#endif

namespace pcl::repair::field_kernel {

/** Sources of a block. Sums are kept in so many lanes whatever the instruction set, so
 * that every machine adds in the same order. */
constexpr int LANES = 8;

/** What is kept of the sources of a block: a row of LANES values each. */
enum Row : int {
  X, /**< position, in the frame of the blocks */
  Y,
  Z,
  TANGENT_X, /**< h tau; 0 in lanes past the end of a curve */
  TANGENT_Y,
  TANGENT_Z,
  INVERSE_CHARGE, /**< 1 / h; 0 for no charge */
  NORMAL_X,       /**< n / h; 0 for no charge */
  NORMAL_Y,
  NORMAL_Z,
  ARC,
  ROWS
};

/** Plain data only: the other side is compiled for several instruction sets. Lengths
 * are in the frame of the blocks, but for arcs. */
struct Task {
  const double* blocks = nullptr;      /**< ROWS * LANES values each */
  const std::uint32_t* list = nullptr; /**< the blocks to add up, in this order */
  std::size_t count = 0;               /**< of the list */
  const double* ratios = nullptr; /**< effective by true length, LANES for each of the
                                       list; null: light mode */
  const double* deltas = nullptr; /**< likewise, 0 where the surface is in the way */
  double position[3] = {};
  double far = 0.0;                /**< L_2 */
  double inverse_width = 0.0;      /**< 1 / (L_2 - L_1) */
  double exponent = 1.0;           /**< chi */
  double least_squared = 0.0;      /**< squared distance up to which nothing counts */
  double half_interpolation = 0.0; /**< k_i / 2 */
  bool coarse = false;             /**< whether coarse blocks may be among the list */
  bool effective = false;          /**< E4.5-1; only then are the next ones used */
  double tangent[3] = {};          /**< tau_X */
  double arc = 0.0, threshold = -1.0; /**< of the origin; T */
  double length = 0.0;                /**< of the curve */
};

/** LANES blocks, and the ball around all of them. */
struct CandidateGroup {
  double center[3];
  double radius;
  double coarse_from; /**< distance of the centre from which the coarse block does */
  std::uint32_t coarse;
};

/** Blocks that a point may need, as the balls around them. */
struct Candidates {
  const CandidateGroup* groups = nullptr;
  std::size_t count = 0;        /**< of the groups */
  const double* center[3] = {}; /**< of LANES blocks for each: fill up with infinity */
  const double* radius = nullptr;
  const std::uint32_t* blocks = nullptr;
};

struct Kernel {
  /** \param[out] tension nine values, row by row */
  void (*sum)(const Task& task, double* tension);

  /** The candidates with a source within L_2 of the point, and perhaps a few more, in
   * order; of a group that is far enough its coarse block instead.
   * \param[out] list room for all of them \return how many */
  std::size_t (*select)(const Candidates& candidates,
                        const Task& task,
                        std::uint32_t* list);
};

extern const Kernel BASELINE_KERNEL;
extern const Kernel AVX2_KERNEL;
extern const Kernel AVX512_KERNEL;

/** The fastest kernel of this processor. */
const Kernel&
bestKernel();

} // namespace pcl::repair::field_kernel
