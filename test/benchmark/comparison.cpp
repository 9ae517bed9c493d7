// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: ours and the field on one cloud, timed and judged.
#include "comparison.h"

#include "measuring.h"
#include "rivals.h"

#include <cstdio>
#include <utility>

namespace bench {
namespace {

void
runOnce(Entrant& entrant)
{
  Reconstruction result = entrant.method.run();
  entrant.runs.push_back(result.seconds);
  entrant.triangles = std::move(result.triangles);
}

double
microsecondsPerPoint(const Entrant& entrant, const Comparison& comparison)
{
  return median(entrant.runs) * 1e6 / double(comparison.cloud->size());
}

void
printTopology(const pcl::ccaa::MeshFacts& facts)
{
  std::printf(" %9.3f %8zu %6zu %6zu %6zu %7zu %5zu",
              100 * facts.shareOfVertices(facts.used_vertices),
              facts.boundary_edges,
              facts.boundary_loops.size(),
              facts.non_manifold_edges,
              facts.misoriented_edges,
              facts.self_intersections.value_or(0),
              facts.components);
  if (facts.genus)
    std::printf(" %5ld", *facts.genus);
  else
    std::printf(" %5s", "-");
}

void
printDistances(const Judgement& judgement, const ReferenceMesh* reference)
{
  if (reference == nullptr || !judgement.deviation || !judgement.missing)
    return;
  const double percent = 100 / reference->diagonal;
  std::printf(" %9.4f %8.3f %6zu %9.4f %8.3f",
              percent * judgement.deviation->mean,
              percent * judgement.deviation->largest,
              judgement.deviation->far_triangles,
              percent * judgement.missing->mean,
              percent * judgement.missing->largest);
}

void
printRow(const Entrant& entrant, const Comparison& comparison)
{
  std::printf("  %-22s %8.3f %6.2f",
              entrant.method.name.c_str(),
              microsecondsPerPoint(entrant, comparison),
              median(entrant.runs) / median(comparison.ours.runs));
  printTopology(entrant.judgement.facts);
  printDistances(entrant.judgement, comparison.reference.get());
  std::printf("\n");
}

/** What a right result would have. */
void
printReference(const ReferenceMesh& reference)
{
  std::printf("  reference: %zu triangles, %zu boundary edges in %zu loops, components "
              "%zu, genus ",
              reference.facts.triangles,
              reference.facts.boundary_edges,
              reference.facts.boundary_loops.size(),
              reference.facts.components);
  if (reference.facts.genus)
    std::printf("%ld\n", *reference.facts.genus);
  else
    std::printf("-\n");
}

void
printHeadings(bool with_distances)
{
  std::printf("  %-22s %8s %6s %9s %8s %6s %6s %6s %7s %5s %5s",
              "",
              "us/point",
              "ratio",
              "used %",
              "boundary",
              "loops",
              "n-man",
              "misor",
              "cross",
              "comps",
              "genus");
  if (with_distances)
    std::printf(" %9s %8s %6s %9s %8s", "mean %", "max %", "far", "miss. %", "max %");
  std::printf("\n");
}

} // namespace

Comparison
compare(const std::string& word, const ComparisonSettings& settings)
{
  Comparison comparison;
  const Cloud::Ptr cloud = makeCloud(word);
  comparison.name = shortName(word);
  comparison.cloud = cloud;
  comparison.ours.method = {"ours", [=] { return reconstruct(cloud, 1); }};
  comparison.ours_on_two.method = {"", [=] { return reconstruct(cloud, 2); }};
  if (settings.rivals)
    for (Method& method : rivalsFor(cloud))
      comparison.rivals.push_back({std::move(method), {}, {}, {}});
  for (std::size_t r = 0; r < settings.repeats; ++r) {
    runOnce(comparison.ours);
    runOnce(comparison.ours_on_two);
    for (Entrant& rival : comparison.rivals)
      runOnce(rival);
  }
  comparison.reference = readReference(referenceFile(word));
  const ReferenceMesh* const reference = comparison.reference.get();
  comparison.ours.judgement = judge(*cloud, comparison.ours.triangles, reference);
  for (Entrant& rival : comparison.rivals)
    rival.judgement = judge(*cloud, rival.triangles, reference);
  return comparison;
}

void
print(const Comparison& comparison)
{
  const double two = median(comparison.ours_on_two.runs);
  std::printf("%s: N %zu; 2 threads %.3f us/point, %.2f times as fast as 1, %s\n",
              comparison.name.c_str(),
              comparison.cloud->size(),
              microsecondsPerPoint(comparison.ours_on_two, comparison),
              two > 0 ? median(comparison.ours.runs) / two : 0,
              comparison.ours.triangles == comparison.ours_on_two.triangles
                  ? "same result"
                  : "ANOTHER RESULT");
  if (comparison.reference)
    printReference(*comparison.reference);
  printHeadings(comparison.reference != nullptr);
  printRow(comparison.ours, comparison);
  for (const Entrant& rival : comparison.rivals)
    printRow(rival, comparison);
  std::fflush(stdout);
}

} // namespace bench
