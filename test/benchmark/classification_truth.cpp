// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: boundary loops of which it is known what they bound.
#include "classification_truth.h"

#include <pcl/memory.h>

#include <Eigen/Geometry>

#include "boundary/extraction.h"
#include "icadm/model_reading.h"
#include "io/model_io.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace bench {
namespace {

using pcl::repair::BoundaryLoop;
using pcl::repair::IncompleteModel;
using pcl::repair::Triangle;
using pcl::repair::Triangles;

TruthCase
readCase(const pcl::PolygonMesh::Ptr& mesh)
{
  TruthCase result;
  result.model = pcl::repair::readModel(mesh, nullptr, pcl::ccaa::LoopContext()).model;
  result.loops = pcl::repair::extractBoundaries(result.model);
  result.truth.assign(result.loops.size(), LoopTruth::UNCLEAR);
  return result;
}

Triangle
inPoints(const IncompleteModel& model, std::size_t triangle)
{
  Triangle corners = model.triangles[triangle];
  for (pcl::index_t& corner : corners)
    corner = model.point_of_vertex[static_cast<std::size_t>(corner)];
  return corners;
}

/** \brief The parts of a closed model that are missing in what was read of it. */
class MissingParts {
public:
  MissingParts(const ClosedModel& whole, const IncompleteModel& read)
  : whole_(whole), part_of_(whole.triangles.size(), MISSING)
  {
    std::size_t place = 0;
    for (std::size_t t = 0; t < read.triangles.size(); ++t) {
      while (whole.triangles[place] != inPoints(read, t))
        ++place;
      place_of_.push_back(static_cast<pcl::index_t>(place));
      part_of_[place++] = PRESENT;
    }
    for (std::size_t t = 0; t < part_of_.size(); ++t)
      if (part_of_[t] == MISSING)
        label(static_cast<pcl::index_t>(t));
  }

  struct Part {
    double area = 0;
    long euler_characteristic = 0;
    std::vector<std::size_t> loops;
  };

  std::vector<Part>&
  parts()
  {
    return parts_;
  }

  /** \brief The part on the other side of an edge of the boundary. */
  std::size_t
  partBeyond(const BoundaryLoop& loop, const IncompleteModel& read) const
  {
    const auto t = static_cast<std::size_t>(loop.triangles[0]);
    const pcl::index_t place = place_of_[t];
    for (int corner = 0; corner < 3; ++corner)
      if (read.adjacency.across(loop.triangles[0], corner) < 0 &&
          read.triangles[t][static_cast<std::size_t>(corner)] == loop.vertices[0])
        return static_cast<std::size_t>(
            part_of_[static_cast<std::size_t>(whole_.adjacency.across(place, corner))]);
    throw std::logic_error("a loop must begin at an edge of its first triangle");
  }

private:
  static constexpr pcl::index_t PRESENT = -1;
  static constexpr pcl::index_t MISSING = -2;

  void
  label(pcl::index_t seed)
  {
    const auto number = static_cast<pcl::index_t>(parts_.size());
    std::vector<pcl::index_t> stack{seed};
    std::vector<pcl::index_t> vertices;
    part_of_[static_cast<std::size_t>(seed)] = number;
    Part part;
    long edge_ends = 0;
    while (!stack.empty()) {
      const pcl::index_t t = stack.back();
      stack.pop_back();
      const Triangle& triangle = whole_.triangles[static_cast<std::size_t>(t)];
      part.area += areaOf(triangle, whole_.positions);
      ++part.euler_characteristic;
      vertices.insert(vertices.end(), triangle.begin(), triangle.end());
      for (int corner = 0; corner < 3; ++corner) {
        const pcl::index_t other = whole_.adjacency.across(t, corner);
        pcl::index_t& state = part_of_[static_cast<std::size_t>(other)];
        if (state == MISSING) {
          state = number;
          stack.push_back(other);
        }
        edge_ends += state == number ? 1 : 2; // an edge inside is seen twice
      }
    }
    std::sort(vertices.begin(), vertices.end());
    const auto end = std::unique(vertices.begin(), vertices.end());
    part.euler_characteristic += end - vertices.begin() - edge_ends / 2;
    parts_.push_back(part);
  }

  const ClosedModel& whole_;
  std::vector<pcl::index_t> part_of_;  /**< of each triangle of the whole */
  std::vector<pcl::index_t> place_of_; /**< in the whole, of each triangle read */
  std::vector<Part> parts_;
};

std::size_t
largestIsland(const IncompleteModel& model)
{
  const auto less = [](const auto& a, const auto& b) { return a.area < b.area; };
  return static_cast<std::size_t>(
      std::max_element(model.islands.begin(), model.islands.end(), less) -
      model.islands.begin());
}

/** \brief How flat each island is: length of the sum of its triangles' vector areas
 * over its area; 1 for a flat one, 1/2 for half a sphere. */
std::vector<double>
flatnessOf(const IncompleteModel& model)
{
  std::vector<Eigen::Vector3d> sums(model.islands.size(), Eigen::Vector3d::Zero());
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    const auto at = [&](std::size_t corner) {
      return model.positions[static_cast<std::size_t>(model.triangles[t][corner])];
    };
    sums[model.island_of[t]] += 0.5 * (at(1) - at(0)).cross(at(2) - at(0));
  }
  std::vector<double> flatness;
  for (std::size_t i = 0; i < sums.size(); ++i)
    flatness.push_back(sums[i].norm() / model.islands[i].area);
  return flatness;
}

std::vector<std::size_t>
loopsOfIslands(const TruthCase& truth)
{
  std::vector<std::size_t> counts(truth.model.islands.size(), 0);
  for (const BoundaryLoop& loop : truth.loops)
    ++counts[loop.island];
  return counts;
}

/** \brief Whether a missing part is a disc around islands that are discs. */
bool
isHoleOf(const MissingParts::Part& part,
         std::size_t main_island,
         const TruthCase& truth,
         const std::vector<std::size_t>& loop_counts)
{
  const auto loops = static_cast<long>(part.loops.size());
  if (part.euler_characteristic != 2 - loops)
    return false;
  long main_loops = 0;
  for (const std::size_t loop : part.loops) {
    const std::size_t island = truth.loops[loop].island;
    if (island == main_island)
      ++main_loops;
    else if (loop_counts[island] != 1)
      return false;
  }
  return main_loops == 1;
}

} // namespace

TruthCase
damagedCase(const ClosedModel& model, const std::vector<char>& removed)
{
  constexpr double FLAT = 0.6;
  TruthCase truth = readCase(damagedMesh(model, removed));
  if (truth.model.islands.empty())
    return truth;
  MissingParts missing(model, truth.model);
  for (std::size_t i = 0; i < truth.loops.size(); ++i)
    missing.parts()[missing.partBeyond(truth.loops[i], truth.model)].loops.push_back(i);
  const std::size_t main_island = largestIsland(truth.model);
  const auto loop_counts = loopsOfIslands(truth);
  const auto flatness = flatnessOf(truth.model);
  for (const auto& part : missing.parts()) {
    double area = part.area;
    for (const std::size_t loop : part.loops)
      if (truth.loops[loop].island != main_island)
        area += truth.model.islands[truth.loops[loop].island].area;
    if (!isHoleOf(part, main_island, truth, loop_counts) || area > 0.5 * model.area)
      continue;
    for (const std::size_t loop : part.loops) {
      const std::size_t island = truth.loops[loop].island;
      if (island == main_island)
        truth.truth[loop] = LoopTruth::HOLE;
      else if (flatness[island] > FLAT)
        truth.truth[loop] = LoopTruth::ISLAND_RIM;
    }
  }
  return truth;
}

namespace {

TruthCase
readFile(const std::string& file)
{
  app::Model model;
  const app::Status status = app::readMesh(sharedFile(file), model);
  if (!status.ok())
    throw std::runtime_error(status.message());
  return readCase(pcl::make_shared<pcl::PolygonMesh>(std::move(model.mesh)));
}

/** \brief Loops of an island, the longest first. */
std::vector<std::size_t>
loopsOf(const TruthCase& truth, std::size_t island)
{
  std::vector<std::size_t> loops;
  for (std::size_t i = 0; i < truth.loops.size(); ++i)
    if (truth.loops[i].island == island)
      loops.push_back(i);
  std::stable_sort(loops.begin(), loops.end(), [&](std::size_t a, std::size_t b) {
    return truth.loops[a].length > truth.loops[b].length;
  });
  return loops;
}

} // namespace

TruthCase
openCase(const std::string& file)
{
  TruthCase truth = readFile(file);
  for (std::size_t island = 0; island < truth.model.islands.size(); ++island) {
    const auto loops = loopsOf(truth, island);
    if (loops.empty() || (loops.size() > 1 && truth.loops[loops[1]].length >
                                                  0.5 * truth.loops[loops[0]].length))
      continue;
    for (const std::size_t loop : loops)
      truth.truth[loop] = LoopTruth::HOLE;
    truth.truth[loops[0]] =
        truth.model.islands.size() == 1 ? LoopTruth::OUTER_BORDER : LoopTruth::RIM;
  }
  return truth;
}

TruthCase
enclosingCase(const std::string& file, std::size_t except)
{
  TruthCase truth = readFile(file);
  const auto loops = loopsOf(truth, largestIsland(truth.model));
  for (std::size_t i = except; i < loops.size(); ++i)
    truth.truth[loops[i]] = LoopTruth::HOLE;
  return truth;
}

} // namespace bench
