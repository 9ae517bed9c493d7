// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a table of how many boundary loops are classified right.
#include "classification_truth.h"

#include <iomanip>
#include <ostream>

namespace bench {
namespace {

using pcl::repair::BoundaryClass;

/** Bodies with holes. */
const std::vector<std::string> enclosing_files = {"bunny/bun_zipper.ply",
                                                  "bunny/bun_zipper_res2.ply",
                                                  "bunny/bun_zipper_res3.ply",
                                                  "holes/StanfordBunny_pymeshfix.ply",
                                                  "holes/elephant-with-holes.ply",
                                                  "holes/plane_holes.ply"};
/** Surfaces with an outer rim. */
const std::vector<std::string> open_files = {"holes/holes.ply",
                                             "holes/building_patch.ply",
                                             "holes/many_small_holes.ply",
                                             "range_maps/lato000.ply",
                                             "range_maps/lato180.ply",
                                             "rs1_scene/rs1_normals.ply"};

bool
isRight(BoundaryClass found, LoopTruth truth)
{
  switch (found) {
  case BoundaryClass::HOLE:
    return truth == LoopTruth::HOLE;
  case BoundaryClass::ISLAND_RIM:
    return truth == LoopTruth::ISLAND_RIM || truth == LoopTruth::RIM;
  case BoundaryClass::OUTER_BORDER:
    return truth == LoopTruth::OUTER_BORDER || truth == LoopTruth::RIM;
  case BoundaryClass::UNDECIDED:
    break;
  }
  return false;
}

void
printRow(std::ostream& out, const std::string& name, const TruthCounts& counts)
{
  const std::size_t all = counts.holes + counts.rims;
  const double share =
      all == 0 ? 0
               : 100.0 * static_cast<double>(counts.right) / static_cast<double>(all);
  out << std::left << std::setw(34) << name << std::right << std::setw(8)
      << counts.holes << std::setw(8) << counts.rims << std::setw(8) << counts.right
      << std::setw(8) << counts.wrong << std::setw(10) << counts.undecided
      << std::setw(9) << std::fixed << std::setprecision(2) << share << std::setw(12)
      << counts.wrong_by_sign << "\n"
      << std::flush;
}

TruthCounts
judged(const TruthCase& truth)
{
  return compare(truth, pcl::repair::classifyBoundaries(truth.model, truth.loops));
}

TruthCounts
damagedRow(std::ostream& out, const ClosedModel& model, std::uint64_t rounds)
{
  TruthCounts sum;
  for (std::uint64_t seed = 1; seed <= rounds; ++seed) {
    DamageOptions options;
    options.seed = seed;
    sum.add(judged(damagedCase(model, damageModel(model, options))));
  }
  printRow(out, model.name + " (damaged)", sum);
  return sum;
}

} // namespace

void
TruthCounts::add(const TruthCounts& other)
{
  holes += other.holes;
  rims += other.rims;
  right += other.right;
  wrong += other.wrong;
  undecided += other.undecided;
  wrong_by_sign += other.wrong_by_sign;
}

TruthCounts
compare(const TruthCase& truth, const std::vector<pcl::repair::LoopClass>& classes)
{
  TruthCounts counts;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    if (truth.truth[i] == LoopTruth::UNCLEAR)
      continue;
    const bool hole = truth.truth[i] == LoopTruth::HOLE;
    ++(hole ? counts.holes : counts.rims);
    const BoundaryClass found = classes[i].boundary_class;
    if (found == BoundaryClass::UNDECIDED)
      ++counts.undecided;
    else
      ++(isRight(found, truth.truth[i]) ? counts.right : counts.wrong);
    if ((classes[i].evidence.integral.value > 0) != hole)
      ++counts.wrong_by_sign;
  }
  return counts;
}

void
printClassificationTable(std::ostream& out, std::uint64_t rounds)
{
  out << "loops of                             holes    rims   right   wrong undecided"
         "  right %  wrong by D\n";
  TruthCounts all;
  for (const ClosedModel& model : madeModels())
    all.add(damagedRow(out, model, rounds));
  for (const std::string& file : closedFiles())
    all.add(damagedRow(out, readClosedModel(file), rounds));
  const auto add_file = [&](const std::string& file, const TruthCase& truth) {
    const TruthCounts counts = judged(truth);
    printRow(out, file, counts);
    all.add(counts);
  };
  for (const std::string& file : enclosing_files)
    add_file(file, enclosingCase(file));
  add_file("bust/Laurana50k.ply", enclosingCase("bust/Laurana50k.ply", 1));
  for (const std::string& file : open_files)
    add_file(file, openCase(file));
  printRow(out, "all", all);
}

} // namespace bench
