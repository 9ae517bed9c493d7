// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: neighbouring field queries that share a search.
#pragma once

#include "field/field_kernel.h"
#include "field/indicator_field.h"
#include "field/source_blocks.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::repair {

/** \brief Whether a query can have an answer other than zero. */
bool
canBeAnswered(const FieldQuery& query);

/** \brief Number of queries from the first on that lie so close together, and agree so
 * far in what counts, that one search may serve them; at least 1. */
std::size_t
bunchFrom(const FieldQuery* first, const FieldQuery* last);

/** \brief The blocks that the queries of a bunch may need. Reused from bunch to bunch
 * by one thread. */
class BunchCandidates {
public:
  /** \brief Find the blocks for the queries [first, last) of one bunch, of those that
   * can be answered. */
  void
  find(const SourceBlocks& blocks, const FieldQuery* first, const FieldQuery* last);

  /** \brief Find the blocks for a query of a line that asks point by point: around
   * it, too, so that a search serves the next ones. */
  void
  findAlong(const SourceBlocks& blocks, const FieldQuery& query);

  /** \brief As the kernel reads them; valid until the next find(). */
  field_kernel::Candidates
  view() const;

private:
  void
  search(const SourceBlocks& blocks, const Ball& place, const FieldQuery& query);
  void
  gather(const SourceBlocks& blocks, const FieldQuery& query);
  void
  add(const SourceBlocks& blocks, const SourceBlocks::Group& group);

  std::uint64_t known_blocks_ = 0; /**< by their number; 0: none */
  FieldQuery known_query_;         /**< what was heeded around known_place_ */
  Ball known_place_;
  std::vector<std::uint32_t> found_;
  std::vector<field_kernel::CandidateGroup> groups_;
  std::array<std::vector<double>, 3> center_; /**< of the blocks of these, and so on */
  std::vector<double> radius_;
  std::vector<std::uint32_t> blocks_;
};

} // namespace pcl::repair
