// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the functions that the Python package calls.
#include <pcl/surface_ccaa/global_shift.h>
#include <pcl/surface_repair/boundary_classifier.h>
#include <pcl/surface_repair/decisions.h>

#include "array_chain.h"
#include "array_repair.h"
#include "arrays.h"
#include "call.h"
#include "io/decisions_file.h"
#include "mesh/cloud_access.h"
#include "mesh/mesh_facts.h"
#include "mesh/polygon_access.h"
#include "options.h"
#include "report/hole_report.h"
#include "report/quality_report.h"
#include "report/reconstruct_report.h"
#include "report/repair_details.h"
#include "report/verdict.h"
#include "run/run_control.h"
#include "run/threads.h"
#include <nlohmann/json.hpp>

#include <memory>
#include <utility>

namespace app::python {
namespace {

namespace py = pybind11;
using nlohmann::json;
using CloudPtr = std::shared_ptr<pcl::PCLPointCloud2>;

/** \brief What all functions are given: dictionaries of arguments and options. */
struct Request {
  py::dict arguments; /**< viewpoint, up, origin_as_viewpoint, threads, progress, ... */
  py::dict options;

  unsigned int
  threads() const
  {
    return arguments["threads"].cast<unsigned int>();
  }
  int
  resolvedThreads() const
  {
    return pcl::ccaa::resolveThreads(threads());
  }
  Call
  call() const
  {
    return Call(arguments["progress"], options);
  }
};

/** \brief The points of \a cloud become those of the mesh; it is empty afterwards. */
std::shared_ptr<pcl::PolygonMesh>
withPoints(const CloudPtr& cloud)
{
  auto mesh = std::make_shared<pcl::PolygonMesh>();
  mesh->cloud = std::move(*cloud);
  return mesh;
}

std::shared_ptr<pcl::PolygonMesh>
makeMesh(const CloudPtr& cloud, const CornerArray& corners, const Request& request)
{
  auto mesh = withPoints(cloud);
  mesh->polygons = toPolygons(corners, request.resolvedThreads());
  return mesh;
}

py::object
normalsToArray(const pcl::PointCloud<pcl::Normal>::Ptr& normals)
{
  if (normals == nullptr)
    return py::none();
  py::array_t<float> array({static_cast<py::ssize_t>(normals->size()), py::ssize_t{3}});
  float* target = array.mutable_data();
  for (const pcl::Normal& normal : *normals)
    target = std::copy(normal.normal, normal.normal + 3, target);
  return std::move(array);
}

/** \brief (cloud, report); the cloud that was given is empty then. */
py::tuple
clean(const CloudPtr& cloud, const py::dict& arguments, const py::dict& options)
{
  const Request request{arguments, options};
  Call call = request.call();
  CleanParameters parameters;
  take(options, parameters);
  Model model;
  model.mesh.cloud = std::move(*cloud);
  model.shift = pcl::GlobalShift::of(model.mesh.cloud);
  CleanReport report;
  call.run([&] {
    const auto callback = call.callback();
    const auto goes_on = [&](double share) { return callback("cleaning", share); };
    report = cleanCloud(parameters, request.threads(), goes_on, model);
  });
  *cloud = std::move(model.mesh.cloud);
  return py::make_tuple(cloud, describeCleaning(report).dump());
}

/** \brief (triangles, labels, normals or None, report) */
py::tuple
reconstruct(const CloudPtr& cloud, const py::dict& arguments, const py::dict& options)
{
  const Request request{arguments, options};
  Call call = request.call();
  ChainTask task;
  take(options, task.options);
  task.until = arguments["until"].cast<std::string>();
  task.sides = sidesFrom(arguments);
  task.normals = arguments["compute_normals"].cast<bool>();
  task.threads = request.threads();
  task.progress = call.callback();
  ReconstructResult result;
  result.model.mesh.cloud = std::move(*cloud);
  call.run([&] { runChain(task, result); });
  return py::make_tuple(toArray(result.model.mesh.polygons, request.resolvedThreads()),
                        toBytes(result.labels),
                        normalsToArray(result.normals),
                        reportOf(task, result, call.seconds()));
}

/** \brief A repair with all that is set. */
std::unique_ptr<ArrayRepair>
makeRepair(const std::shared_ptr<pcl::PolygonMesh>& points,
           const CornerArray& corners,
           const CloudPtr& free_points,
           const Request& request,
           Call& call)
{
  pcl::repair::RepairParameters method;
  take(request.options, method);
  method.survey.orientation.sides = sidesFrom(request.arguments);
  const py::object decisions = request.arguments["decisions"];
  if (!decisions.is_none())
    method.survey.decisions = parseDecisions(decisions.cast<std::string>());
  auto repair = std::make_unique<ArrayRepair>(viewOf(corners));
  repair->setInputMesh(points);
  repair->setFreePoints(free_points);
  repair->setParameters(method);
  repair->setNumberOfThreads(request.threads());
  repair->setProgressCallback(call.callback());
  return repair;
}

/** \brief (cloud, triangles, origins, report); the cloud that was given is empty then.
 */
py::tuple
repair(const CloudPtr& cloud,
       const CornerArray& corners,
       const CloudPtr& free_points,
       const py::dict& arguments,
       const py::dict& options)
{
  const Request request{arguments, options};
  Call call = request.call();
  const auto mesh = withPoints(cloud);
  const auto repair = makeRepair(mesh, corners, free_points, request, call);
  call.run([&] { repair->process(*mesh); });
  const pcl::RepairReport& found = repair->getReport();
  json report = describeRepair(found);
  report["parameters"] = describeParameters(repair->getParameters());
  report["verdict"] = tellSurface(surfaceFacts(found));
  report["what_is_missing"] = tellShortfalls(found, *mesh);
  report["global_shift"] = found.reading.global_shift;
  report["call_seconds"] = call.seconds();
  *cloud = std::move(mesh->cloud);
  return py::make_tuple(
      cloud, toArray(repair->takeTriangles()), toBytes(found.origins), report.dump());
}

/** \brief What a repair would decide, as the text of a file of decisions. */
std::string
proposeDecisions(const CloudPtr& cloud,
                 const CornerArray& corners,
                 const CloudPtr& free_points,
                 const py::dict& arguments,
                 const py::dict& options)
{
  const Request request{arguments, options};
  Call call = request.call();
  const auto repair =
      makeRepair(withPoints(cloud), corners, free_points, request, call);
  pcl::repair::Decisions decisions;
  call.run([&] { decisions = repair->proposeDecisions(); });
  return decisionsText("mesh from Python", decisions);
}

/** \brief (triangles, roles of the points, report) */
py::tuple
umbrellaFilter(const CloudPtr& cloud,
               const CornerArray& corners,
               const py::dict& arguments,
               const py::dict& options)
{
  const Request request{arguments, options};
  Call call = request.call();
  const auto mesh = makeMesh(cloud, corners, request);
  pcl::UmbrellaFilter filter;
  take(options, filter);
  filter.setSideHints(sidesFrom(arguments));
  filter.setNumberOfThreads(request.threads());
  filter.setProgressCallback(call.callback());
  filter.setInputMesh(mesh);
  call.run([&] { filter.process(*mesh); });
  json report = describeFilter(filter.getReport());
  report["outer_side_by"] = describe(filter.getSideTally());
  return py::make_tuple(toArray(mesh->polygons, request.resolvedThreads()),
                        toBytes(filter.getPointRoles()),
                        report.dump());
}

/** \brief (points of each loop, report about each loop) */
py::tuple
classifyBoundaries(const CloudPtr& cloud,
                   const CornerArray& corners,
                   const py::dict& arguments,
                   const py::dict& options)
{
  const Request request{arguments, options};
  Call call = request.call();
  pcl::BoundaryClassifier classifier;
  take(options, classifier);
  classifier.setNumberOfThreads(request.threads());
  classifier.setProgressCallback(call.callback());
  classifier.setInputMesh(makeMesh(cloud, corners, request));
  std::vector<pcl::ClassifiedBoundary> boundaries;
  call.run([&] { classifier.classify(boundaries); });
  json reports = json::array();
  py::list points;
  for (const pcl::ClassifiedBoundary& boundary : boundaries) {
    reports.push_back({{"island", boundary.island},
                       {"length", boundary.length},
                       {"edges", boundary.vertices.size()}});
    addClass({boundary.boundary_class,
              boundary.confidence,
              boundary.evidence,
              boundary.faced},
             reports.back());
    points.append(py::array_t<std::int32_t>(
        static_cast<py::ssize_t>(boundary.vertices.size()), boundary.vertices.data()));
  }
  return py::make_tuple(points, reports.dump());
}

std::string
meshQuality(const CloudPtr& cloud,
            const CornerArray& corners,
            const py::dict& arguments)
{
  const Request request{arguments, {}};
  Call call = request.call();
  pcl::ccaa::MeshFactsOptions options;
  options.self_intersections = arguments["self_intersections"].cast<bool>();
  options.threads = request.resolvedThreads();
  pcl::ccaa::MeshFacts facts;
  call.run([&] {
    const auto shift = pcl::GlobalShift::of(*cloud);
    pcl::ccaa::RunControl control(call.callback());
    facts = measureMesh(pcl::ccaa::fanTriangles(viewOf(corners)),
                        pcl::ccaa::positionView(*cloud).relativeTo(shift.offset()),
                        options,
                        control);
  });
  json report = describeFacts(facts);
  report["verdict"] = summarizeFacts(facts);
  return report.dump();
}

} // namespace

PYBIND11_MODULE(_core, module)
{
  module.doc() = "What the package pclsurfacerepair calls of the C++ libraries.";
  module.attr("__version__") = version();
  addCancelled(module);
  addCloud(module);
  py::register_exception_translator([](std::exception_ptr problem) {
    try {
      std::rethrow_exception(problem);
    }
    catch (const Failure& failure) {
      PyErr_SetString(PyExc_ValueError, failure.what());
    }
    catch (const json::exception& failure) {
      PyErr_SetString(PyExc_ValueError, failure.what());
    }
  });
  module.def("defaults", &defaults);
  module.def("clean", &clean);
  module.def("reconstruct", &reconstruct);
  module.def("repair", &repair);
  module.def("propose_decisions", &proposeDecisions);
  module.def("umbrella_filter", &umbrellaFilter);
  module.def("classify_boundaries", &classifyBoundaries);
  module.def("mesh_quality", &meshQuality);
}

} // namespace app::python
