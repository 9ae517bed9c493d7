// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the chain of algorithms on arrays of points.
#include "array_chain.h"

#include <pcl/surface_ccaa/impl/cloud_runs.h>
#include <pcl/surface_ccaa/impl/point_blocks.h>
#include <pcl/PolygonMesh.h>

#include "arrays.h"
#include "io/point_columns.h"
#include "mesh/side_hints.h"
#include "report/reconstruct_report.h"
#include "report/reconstruct_verdict.h"
#include <nlohmann/json.hpp>

#include <memory>
#include <numeric>

namespace app::python {
namespace {

using pcl::ccaa::PointArray;

/** What a chain tells its parts. */
struct PartSettings : pcl::ccaa::RunSettings, pcl::ccaa::SideSettings {
  void
  setSideTally(const pcl::ccaa::SideTally& tally)
  {
    side_tally_ = tally;
  }
};

/** \brief Common to both parts: they work on arrays in place. */
class ArrayPart : public pcl::ccaa::ChainPart {
public:
  explicit ArrayPart(const PointArray& points) : points_(points) {}

  pcl::ccaa::StageSettings
  settings() const override
  {
    return pcl::ccaa::StageSettings::of(settings_.get());
  }
  bool
  takesHandoff() const override
  {
    return true;
  }

protected:
  /** \brief Take over what every run is given. */
  void
  fill(const pcl::IndicesPtr& selection,
       pcl::ccaa::StageOutput& made,
       pcl::ccaa::CloudInput& input) const
  {
    input.handoff = &made.handoff;
    input.points = points_;
    input.selection = selection;
    input.threads = settings_->getNumberOfThreads();
    input.progress = settings_->getProgressCallback();
  }

  static void
  check(const std::string& error)
  {
    if (!error.empty())
      throw Failure(error);
  }

  PointArray points_;
  std::shared_ptr<PartSettings> settings_ = std::make_shared<PartSettings>();
};

/** \brief GreedyStart. */
class StartPart : public ArrayPart {
public:
  StartPart(const PointArray& points,
            const pcl::ccaa::GreedyParameters& parameters,
            pcl::ccaa::GreedyReport& report)
  : ArrayPart(points), parameters_(parameters), report_(report)
  {}

  bool
  completes() const override
  {
    return false;
  }
  const std::vector<pcl::index_t>*
  keptTriangles() const override
  {
    return nullptr;
  }

  bool
  construct(const pcl::ccaa::ChainSelection& chosen,
            pcl::ccaa::StageOutput& made) override
  {
    pcl::ccaa::CloudInput input;
    fill(chosen.chosen, made, input);
    pcl::ccaa::PointBlocks blocks;
    pcl::ccaa::TreeSearch search;
    search.blocks = &blocks;
    search.hold = [&](const pcl::IndicesPtr& held) {
      blocks.build(points_, *held, static_cast<int>(input.threads));
    };
    check(runGreedyStart(input, search, parameters_, report_, made.polygons));
    return false;
  }

  void
  complete(const pcl::PolygonMeshConstPtr&,
           const pcl::IndicesPtr&,
           pcl::ccaa::StageOutput&) override
  {}

private:
  const pcl::ccaa::GreedyParameters& parameters_;
  pcl::ccaa::GreedyReport& report_;
};

/** \brief ProjectionCompletion. */
class BasePart : public ArrayPart {
public:
  BasePart(const pcl::PCLPointCloud2& cloud,
           const pcl::ccaa::CompletionParameters& parameters)
  : ArrayPart(floatsOf(cloud, "x"))
  , normals_(floatsOf(cloud, "normal_x"))
  , viewpoints_(floatsOf(cloud, "vp_x"))
  , parameters_(parameters)
  {}

  bool
  completes() const override
  {
    return true;
  }
  const std::vector<pcl::index_t>*
  keptTriangles() const override
  {
    return parameters_.keep_given ? nullptr : &kept_;
  }
  pcl::TopologyDoubts
  topologyDoubts() const override
  {
    return report_.doubts;
  }

  bool
  construct(const pcl::ccaa::ChainSelection&, pcl::ccaa::StageOutput&) override
  {
    return false;
  }

  void
  complete(const pcl::PolygonMeshConstPtr&,
           const pcl::IndicesPtr& usable,
           pcl::ccaa::StageOutput& made) override
  {
    pcl::ccaa::CompletionInput input;
    fill(usable, made, input);
    input.normals = normals_;
    input.viewpoints = viewpoints_;
    input.sides = settings_->getSideHints();
    pcl::ccaa::CompletionOutput output = runCompletion(input, parameters_, report_);
    check(output.error);
    kept_ = std::move(output.kept);
    settings_->setSideTally(report_.sides);
  }

private:
  PointArray normals_;
  PointArray viewpoints_;
  const pcl::ccaa::CompletionParameters& parameters_;
  std::vector<pcl::index_t> kept_;
  pcl::ccaa::CompletionReport report_;
};

/** As the program would be told. */
ReconstructSettings
settingsOf(const ChainTask& task)
{
  ReconstructSettings settings;
  settings.until = task.until;
  settings.threads = task.threads;
  settings.neighbors = task.options.start.neighbors;
  settings.minimum_angle =
      ReconstructSettings::degrees(task.options.start.minimum_angle);
  settings.certified_minimum_angle =
      ReconstructSettings::degrees(task.options.start.certified_minimum_angle);
  settings.length_factor = task.options.start.length_factor;
  settings.plain = !task.options.start.certificates;
  settings.minimum_internal_points = task.options.filter.getMinimumInternalPoints();
  return settings;
}

} // namespace

void
runChain(ChainTask& task, ReconstructResult& result)
{
  pcl::PolygonMesh& mesh = result.model.mesh;
  const auto shift = pcl::GlobalShift::of(mesh.cloud);
  result.model.shift = shift;
  if (!shift.isNone() || hasDoublePositions(mesh.cloud))
    shift.toLocal(pcl::PCLPointCloud2(std::move(mesh.cloud)), mesh.cloud);
  pcl::ccaa::ChainInput input;
  input.points = floatsOf(mesh.cloud, "x");
  input.selection = std::make_shared<pcl::Indices>(input.points.size);
  std::iota(input.selection->begin(), input.selection->end(), 0);
  input.threads = task.threads;
  input.progress = task.progress;
  input.has_viewpoints = floatsOf(mesh.cloud, "vp_x").size > 0;
  input.sides = relativeTo(shift.offset(), task.sides);
  input.sides.guess_plane = true;
  input.starts = {
      std::make_shared<StartPart>(input.points, task.options.start, result.start)};
  if (task.until != "start")
    input.filter = &task.options.filter;
  if (task.until == "base")
    input.base = std::make_shared<BasePart>(mesh.cloud, task.options.base);
  input.compute_normals = task.normals;
  pcl::ccaa::ChainOutput output;
  runChain(input, true, mesh, output);
  result.filter = task.options.filter.getReport();
  result.chain = output.report;
  result.labels = std::move(output.labels);
  result.normals = output.normals;
  result.sides = output.sides;
  countTopology(settingsOf(task), result);
}

std::string
reportOf(const ChainTask& task, ReconstructResult& result, double seconds)
{
  const ReconstructSettings settings = settingsOf(task);
  result.stages = stageTimes(settings, result);
  nlohmann::json report = describeRun(settings, result, {});
  result.model.mesh.cloud = {}; // which is near the origin; the points are the caller's
  report["verdict"] = tellVerdict(settings, result);
  report["what_is_missing"] = tellIncomplete(settings, result);
  report["complete"] = report["what_is_missing"].get_ref<std::string&>().empty();
  report["call_seconds"] = seconds;
  return report.dump();
}

} // namespace app::python
