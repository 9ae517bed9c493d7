// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a chain of algorithms, applied to a cloud (thesis 3.1).
#pragma once

#include <pcl/surface_ccaa/impl/cloud_runs.h>
#include <pcl/PolygonMesh.h>

#include "consecutive/chain_run.h"
#include "consecutive/filter_stage.h"

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::ccaa {

/** \brief One application of a chain: start algorithms, each with the filter behind it,
 * then the base algorithm. */
class Chain {
public:
  Chain(const ChainInput& input, ChainOutput& result);

  /** \brief Scheme S2 of the thesis: start, filter, base; then normals if wanted.
   * \param[in,out] mesh its cloud is there and stays; its polygons are the result
   * \return false after an error, which has been told, and after cancelling */
  bool
  apply(PolygonMesh& mesh);

  /** \brief The base algorithm without the rest; its time goes to the report. */
  bool
  applyBaseAlone();

  bool
  cancelled() const
  {
    return run_.control.cancelled();
  }

  /** \brief Present part, for messages. */
  const std::string&
  stage() const
  {
    return run_.stage;
  }

private:
  bool
  hasValidParts() const;
  bool
  selectPoints();
  template <typename Body>
  bool
  runStage(const std::string& name,
           double weight,
           const StageSettings& settings,
           double& seconds,
           const Body& body);
  bool
  applyStart(std::size_t number);
  bool
  construct(std::size_t number, Triangles& made);
  bool
  constructFrom(std::size_t number, Triangles& made);
  ChainMesh
  joined(std::size_t number, Triangles made) const;
  bool
  filterTriangles(ChainMesh& given, ChainMesh& left);
  void
  takeSides(const StageSettings& settings);
  bool
  applyBase();
  bool
  runBase(ChainMesh* partial, double weight, Triangles& triangles);
  bool
  complete(ChainMesh* partial, ChainPart& completion, Triangles& triangles) const;
  void
  computeNormals();

  const ChainInput& input_;
  ChainOutput& result_;
  ConsecutiveReport& report_;
  FilterPart filter_;
  ChainRun run_;
  StageClock clock_; /**< of all of it */
};

} // namespace pcl::ccaa
