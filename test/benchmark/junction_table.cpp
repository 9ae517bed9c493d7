// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how well junctions are told, and the weights behind it.

#include "junction_table.h"

#include <Eigen/Cholesky>

#include "closed_models.h"
#include "io/cloud_normals.h"
#include "mesh_distance.h"
#include "support/random_source.h"
#include "support/scanned_scene.h"
#include "survey/model_survey.h"

#include <array>
#include <cmath>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace bench {
namespace {

using pcl::ccaa::Position;
using pcl::ccaa::test::RandomSource;
using pcl::ccaa::test::Scene;
using pcl::ccaa::test::Shape;
using pcl::repair::ForceLine;
using pcl::repair::Junction;
using pcl::repair::JunctionParameters;
using pcl::repair::ModelSurvey;

/** A line may be this far from the true surface, in its lengths. */
constexpr double OFF_SURFACE = 0.2;

struct JudgedScene {
  Scene truth;
  Shape seen;
  std::string kind;
  app::Viewpoint viewpoint; /**< of a range map */
};

JudgedScene
rangeMapOf(std::uint64_t seed)
{
  RandomSource random(seed);
  JudgedScene scene;
  scene.truth = pcl::ccaa::test::randomScene(seed);
  pcl::ccaa::test::ViewSettings view;
  view.sensor = Position(0.0, 0.0, random.uniform(5.0, 20.0));
  view.pixels = static_cast<std::size_t>(60.0 * std::pow(4.0, random.uniform()));
  view.noise = random.uniform(0.0, 0.3);
  view.spots = random.below(6);
  view.seed = seed;
  scene.seen = rangeMap(scene.truth, view);
  scene.kind = "range maps";
  scene.viewpoint.known = true;
  scene.viewpoint.position = view.sensor;
  return scene;
}

/** Each object without one to four slabs, and now and then a ball. */
JudgedScene
damaged(Scene truth, const char* kind, std::uint64_t seed)
{
  RandomSource random(seed);
  JudgedScene scene;
  scene.kind = kind;
  scene.truth = std::move(truth);
  for (const Shape& object : scene.truth.objects) {
    Eigen::AlignedBox3d box;
    for (const Position& vertex : object.vertices)
      box.extend(vertex);
    const double size = box.diagonal().norm();
    Shape rest = object;
    for (std::size_t cut = 1 + random.below(4); cut > 0; --cut) {
      const Position place = object.vertices[random.below(object.vertices.size())];
      const Position normal =
          Position(random.normal(), random.normal(), random.normal()).normalized();
      const double half = 0.01 * std::pow(7.0, random.uniform()) * size;
      const bool is_ball = random.below(4) == 0;
      const auto is_lost = [&](pcl::index_t corner) {
        const Position off = object.vertices[static_cast<std::size_t>(corner)] - place;
        return is_ball ? off.norm() < 3.0 * half : std::abs(normal.dot(off)) < half;
      };
      pcl::ccaa::Triangles left;
      for (const pcl::ccaa::Triangle& t : rest.triangles)
        if (!is_lost(t[0]) && !is_lost(t[1]) && !is_lost(t[2]))
          left.push_back(t);
      rest.triangles = std::move(left);
    }
    scene.seen = joined(scene.seen, rest);
  }
  return scene;
}

Scene
terrainOf(std::uint64_t seed)
{
  RandomSource random(seed);
  const auto side = static_cast<int>(20 + random.below(80));
  return {{pcl::ccaa::test::terrain(side, side, random.uniform(0.0, 0.1) * side)}};
}

/** Which object a place is on, and how far lines are from it. */
class SceneTruth {
public:
  explicit SceneTruth(const Scene& scene)
  {
    for (const Shape& object : scene.objects)
      objects_.emplace_back(object.triangles, object.vertices);
  }

  bool
  isTrue(const ForceLine& line) const
  {
    const std::size_t object = objectAt(line.points.front());
    if (object != objectAt(line.points.back()))
      return false;
    const double limit = OFF_SURFACE * line.length;
    double farthest = 0.0;
    for (const Position& point : line.points)
      farthest = std::max(farthest, objects_[object](point));
    return farthest <= limit;
  }

private:
  std::size_t
  objectAt(const Position& place) const
  {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < objects_.size(); ++i)
      if (objects_[i](place) < objects_[nearest](place))
        nearest = i;
    return nearest;
  }

  std::vector<MeshDistance> objects_;
};

struct Sample {
  Junction junction;
  bool is_true = false;
  std::string kind;
  std::uint64_t seed = 0;
};

void
addSamples(const JudgedScene& scene, std::uint64_t seed, std::vector<Sample>& samples)
{
  ClosedModel model;
  model.positions = scene.seen.vertices;
  model.triangles = scene.seen.triangles;
  pcl::repair::SurveyParameters parameters;
  parameters.trace_in_holes = false;
  parameters.junction.judge = false;
  const std::vector<char> nothing(model.triangles.size(), 0);
  const pcl::PolygonMesh::Ptr mesh = damagedMesh(model, nothing);
  app::appendViewpoint(scene.viewpoint, mesh->cloud);
  const ModelSurvey survey = surveyModel(mesh, nullptr, parameters, {});
  const SceneTruth truth(scene.truth);
  std::map<std::array<std::size_t, 2>, std::array<std::size_t, 2>> votes;
  for (const ForceLine& line : survey.between_islands.lines)
    if (line.end == pcl::repair::LineEnd::BRIDGE) {
      const auto [low, high] = std::minmax(line.origin.curve, line.target.curve);
      ++votes[{low, high}][truth.isTrue(line) ? 1 : 0];
    }
  for (const Junction& junction : survey.joined.junctions) {
    const std::array<std::size_t, 2>& vote = votes[junction.curves];
    samples.push_back({junction, vote[1] > vote[0], scene.kind, seed});
  }
}

/** How much a junction counts that is none. */
constexpr double WRONG_WEIGHT = 4.0;
constexpr int ROUNDS = 40;
/** Keeps the weights of terms that hardly occur small. */
constexpr double RIDGE = 0.3;

using Weights = Eigen::Matrix<double, 7, 1>;

Weights
featuresOf(const Junction& junction)
{
  Weights features;
  features[0] = 1.0;
  const auto terms = junction.evidence.terms();
  for (std::size_t k = 0; k < terms.size(); ++k)
    features[static_cast<Eigen::Index>(k) + 1] = -terms[k];
  return features;
}

/** Logistic regression by Newton's method on the samples of even seeds. */
Weights
fitWeights(const std::vector<Sample>& samples)
{
  using Hessian = Eigen::Matrix<double, 7, 7>;
  Weights weights = Weights::Zero();
  for (int round = 0; round < ROUNDS; ++round) {
    Hessian hessian = RIDGE * Hessian::Identity();
    Weights gradient = -RIDGE * weights;
    gradient[0] = 0.0;
    for (const Sample& sample : samples) {
      if (sample.seed % 2 != 0)
        continue;
      const Weights x = featuresOf(sample.junction);
      const double likely = 1.0 / (1.0 + std::exp(-weights.dot(x)));
      const double counts = sample.is_true ? 1.0 : WRONG_WEIGHT;
      gradient += counts * ((sample.is_true ? 1.0 : 0.0) - likely) * x;
      hessian += counts * likely * (1.0 - likely) * x * x.transpose();
    }
    weights += hessian.ldlt().solve(gradient);
  }
  return weights;
}

void
printRow(std::ostream& out, const char* kind, const std::vector<Sample>& samples)
{
  std::array<std::array<std::size_t, 2>, 2> counts{}; // by truth and log odds
  for (const Sample& sample : samples)
    if (sample.seed % 2 != 0 && sample.kind == kind)
      ++counts[sample.is_true ? 1 : 0]
              [sample.junction.evidence.logOdds() >=
                       oddsThatJoin(sample.junction.evidence, JunctionParameters())
                   ? 1
                   : 0];
  out << "| " << kind << " | " << counts[1][0] + counts[1][1] << " | " << counts[1][1]
      << " | " << counts[0][0] + counts[0][1] << " | " << counts[0][0] << " |\n";
}

} // namespace

void
printJunctionTable(std::ostream& out, std::uint64_t seeds)
{
  std::vector<Sample> samples;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    addSamples(rangeMapOf(seed), seed, samples);
    addSamples(
        damaged(pcl::ccaa::test::randomScene(seed), "bodies", seed), seed, samples);
    addSamples(damaged(terrainOf(seed), "terrains", seed), seed, samples);
  }
  out << "weights fitted to even seeds (even, turn, fold, wide, wide for a body, seen "
         "empty, depth): "
      << fitWeights(samples).transpose() << "\n\n"
      << "| odd seeds | true | joined | false | left open "
         "|\n|---|---:|---:|---:|---:|\n";
  for (const char* kind : {"range maps", "bodies", "terrains"})
    printRow(out, kind, samples);
}

} // namespace bench
