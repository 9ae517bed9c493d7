// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: algorithms that do as a test tells them, for chains.
#pragma once

#include <pcl/surface/processing.h>
#include <pcl/surface_ccaa/mesh_completion.h>
#include <pcl/point_types.h>

#include "run/run_control.h"

#include <functional>
#include <utility>
#include <vector>

namespace pcl::ccaa::test {

using Cloud = pcl::PointCloud<PointXYZ>;
using Polygons = std::vector<Vertices>;

inline Vertices
polygon(const Indices& corners)
{
  Vertices vertices;
  vertices.vertices = corners;
  return vertices;
}

/** \brief A class as those of PCL are: not a RunSettings. Gives what a function makes
 * of the cloud and indices that it got. */
class ScriptedStart : public MeshConstruction<PointXYZ> {
public:
  using Script = std::function<Polygons(const Cloud&, const Indices&)>;

  explicit ScriptedStart(Script script) : script_(std::move(script))
  {
    check_tree_ = false;
  }

  int runs = 0;

protected:
  void
  performReconstruction(PolygonMesh& output) override
  {
    performReconstruction(output.polygons);
  }

  void
  performReconstruction(Polygons& polygons) override
  {
    ++runs;
    polygons = script_(*input_, *indices_);
  }

private:
  Script script_;
};

/** \brief A completion whose new triangles, or whole result, a function makes. Without
 * a function it adds nothing. */
class ScriptedCompletion : public MeshCompletion<PointXYZ> {
public:
  using Script = std::function<void(Polygons&, const Cloud&)>;

  explicit ScriptedCompletion(Script script = {}) : script_(std::move(script)) {}

  void
  setScript(Script script)
  {
    script_ = std::move(script);
  }

  std::size_t given_triangles = 0;
  std::size_t given_points = 0; /**< of the partial mesh's cloud */
  unsigned int given_threads = 0;
  const void* given_tree = nullptr;
  Indices given_indices;
  bool may_replace = false; /**< whether it tells what it has kept */
  std::vector<index_t> kept;

  const std::vector<index_t>*
  keptTriangles() const override
  {
    return may_replace ? &kept : nullptr;
  }

protected:
  void
  performReconstruction(PolygonMesh& output) override
  {
    performReconstruction(output.polygons);
  }

  void
  performReconstruction(Polygons& polygons) override
  {
    polygons = partial_mesh_ ? partial_mesh_->polygons : Polygons();
    given_triangles = polygons.size();
    given_points =
        partial_mesh_ ? partial_mesh_->cloud.width * partial_mesh_->cloud.height : 0;
    given_threads = threads_;
    given_tree = tree_.get();
    given_indices = *indices_;
    RunControl control(progress_);
    if (!control.report("filling", 0.25) || !control.report("filling", 1))
      polygons.clear();
    else if (script_)
      script_(polygons, *input_);
  }

private:
  Script script_;
};

/** \brief A filter that returns what a function makes of the triangles. */
class ScriptedFilter : public MeshProcessing {
public:
  using Script = std::function<void(PolygonMesh&)>;

  explicit ScriptedFilter(Script script) : script_(std::move(script)) {}

protected:
  void
  performProcessing(PolygonMesh& output) override
  {
    output = *input_mesh_;
    script_(output);
  }

private:
  Script script_;
};

} // namespace pcl::ccaa::test
