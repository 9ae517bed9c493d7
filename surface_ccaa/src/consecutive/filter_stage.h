// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the filter of a chain.
#pragma once

#include <pcl/surface/processing.h>
#include <pcl/surface_ccaa/umbrella_filter.h>

#include "consecutive/chain_run.h"

namespace pcl::ccaa {

/** \brief The filter of a chain: ours, another, or none. */
class FilterPart {
public:
  /** \param[in] filter null: nothing is left out */
  explicit FilterPart(MeshProcessing* filter)
  : filter_(filter), umbrella_(dynamic_cast<UmbrellaFilter*>(filter))
  {}

  StageSettings
  settings() const
  {
    return StageSettings::of(filter_);
  }

  /** \brief Filter the triangles of a chain.
   * \param[in,out] given its cloud goes to `left`, untouched; it is still here after a
   * failure \param[out] left what the filter leaves
   * \return false when it returned anything that it was not given */
  bool
  apply(ChainMesh& given, const ChainRun& run, ChainMesh& left) const;

  /** \brief Whether the last run left a region without any consistent winding, to which
   * no triangle can be added with the right one. Only UmbrellaFilter tells. */
  bool
  leftOneSided() const
  {
    return umbrella_ != nullptr && umbrella_->getReport().one_sided_components > 0;
  }

private:
  bool
  process(ChainMesh& given, const ChainRun& run, ChainMesh& left) const;
  std::vector<PointRole>
  rolesAfter(const ChainMesh& left, const ChainRun& run) const;

  MeshProcessing* filter_;
  UmbrellaFilter* umbrella_;
};

} // namespace pcl::ccaa
