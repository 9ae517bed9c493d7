// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how often the outer side of islands is found.

#include "orientation_table.h"

#include <pcl/surface_ccaa/umbrella_filter.h>

#include "boundary/extraction.h"
#include "closed_models.h"
#include "damage/random_numbers.h"
#include "icadm/model_reading.h"
#include "orientation/island_orientation.h"

#include <cmath>
#include <iomanip>
#include <ostream>
#include <string>
#include <vector>

namespace bench {

namespace {

using pcl::repair::IncompleteModel;
using pcl::repair::IslandSide;
using pcl::repair::Position;
using pcl::repair::SideRule;

enum class CutKind { SLABS, RINGS };

/** Five slabs or eight spherical shells, of a thickness in shares of the diagonal. */
struct Cut {
  CutKind kind;
  double thickness;
};

const std::vector<Cut> cuts = {{CutKind::SLABS, 0.01},
                               {CutKind::SLABS, 0.03},
                               {CutKind::SLABS, 0.06},
                               {CutKind::RINGS, 0.005},
                               {CutKind::RINGS, 0.02},
                               {CutKind::RINGS, 0.05}};

Position
randomPlace(const ClosedModel& model, app::RandomNumbers& random)
{
  return model.positions[random.below(model.positions.size())];
}

/** How deep in the damage a place is, for one slab or shell: removed below 0. */
struct Damage {
  CutKind kind;
  Position place;
  Position direction; /**< of a slab */
  double radius;      /**< of a shell */

  double
  distance(const Position& position) const
  {
    return kind == CutKind::SLABS ? std::abs(direction.dot(position - place))
                                  : std::abs((position - place).norm() - radius);
  }
};

std::vector<Damage>
chooseDamages(const ClosedModel& model, const Cut& cut, app::RandomNumbers& random)
{
  std::vector<Damage> damages(cut.kind == CutKind::SLABS ? 5 : 8);
  for (Damage& damage : damages) {
    damage.kind = cut.kind;
    damage.place = randomPlace(model, random);
    const double x = random.normal();
    const double y = random.normal();
    damage.direction = Position(x, y, random.normal()).normalized();
    damage.radius = (0.04 + 0.12 * random.uniform()) * model.diagonal;
  }
  return damages;
}

std::vector<char>
removedBy(const std::vector<Damage>& damages,
          const ClosedModel& model,
          double thickness)
{
  std::vector<char> removed;
  for (const pcl::repair::Triangle& triangle : model.triangles) {
    Position center = Position::Zero();
    for (const pcl::index_t corner : triangle)
      center += model.positions[static_cast<std::size_t>(corner)] / 3.0;
    bool is_removed = false;
    for (const Damage& damage : damages)
      is_removed |= damage.distance(center) < 0.5 * thickness * model.diagonal;
    removed.push_back(is_removed ? 1 : 0);
  }
  return removed;
}

/** Some closed models come wound inward. */
bool
isWoundOutward(const ClosedModel& model)
{
  double volume = 0.0;
  for (const pcl::repair::Triangle& t : model.triangles)
    volume += model.positions[static_cast<std::size_t>(t[0])]
                  .cross(model.positions[static_cast<std::size_t>(t[1])])
                  .dot(model.positions[static_cast<std::size_t>(t[2])]);
  return volume > 0.0;
}

/** What is left of a model, as the filter leaves it: without bow-ties and crumbs. */
IncompleteModel
filtered(const ClosedModel& model, const std::vector<char>& removed)
{
  pcl::UmbrellaFilter filter;
  filter.setInputMesh(damagedMesh(model, removed));
  filter.setConsistentOrientation(false);
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  filter.process(*mesh);
  return pcl::repair::readModel(mesh, nullptr, {}).model;
}

struct Counts {
  std::size_t islands = 0;
  std::size_t right = 0;
  std::size_t undecided = 0;

  void
  add(const Counts& other)
  {
    islands += other.islands;
    right += other.right;
    undecided += other.undecided;
  }
};

/** Turn islands at random, orient them, and count. */
Counts
orientOnce(IncompleteModel model, bool outward, app::RandomNumbers& random)
{
  std::vector<IslandSide> turned(model.islands.size());
  for (IslandSide& side : turned)
    side.flipped = random.below(2) == 1;
  turnIslands(model, turned);
  const std::vector<IslandSide> sides =
      orientIslands(model, extractBoundaries(model), {}, pcl::repair::DEFAULT_ROOM, {});
  Counts counts;
  counts.islands = sides.size();
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (sides[i].rule == SideRule::UNDECIDED)
      ++counts.undecided;
    else if ((sides[i].flipped == turned[i].flipped) == outward)
      ++counts.right;
  return counts;
}

void
printRow(std::ostream& out, const std::string& name, const Counts& counts)
{
  const std::size_t wrong = counts.islands - counts.right - counts.undecided;
  out << std::left << std::setw(34) << name << std::right << std::setw(8)
      << counts.islands << std::setw(8) << counts.right << std::setw(8) << wrong
      << std::setw(10) << counts.undecided << std::setw(9) << std::fixed
      << std::setprecision(2)
      << 100.0 * static_cast<double>(counts.right) /
             static_cast<double>(std::max<std::size_t>(counts.islands, 1))
      << "\n"
      << std::flush;
}

std::string
nameOf(const Cut& cut)
{
  const std::string kind = cut.kind == CutKind::SLABS ? "slabs " : "rings ";
  std::string percent = std::to_string(100.0 * cut.thickness);
  return kind + percent.substr(0, 3) + " %";
}

} // namespace

void
printOrientationTable(std::ostream& out, std::uint64_t rounds)
{
  out << std::left << std::setw(34) << "orientation" << std::right << std::setw(8)
      << "islands" << std::setw(8) << "right" << std::setw(8) << "wrong"
      << std::setw(10) << "undecided" << std::setw(9) << "% right"
      << "\n";
  Counts all;
  std::vector<Counts> of_cut(cuts.size());
  std::vector<ClosedModel> models = madeModels();
  for (const std::string& file : closedFiles())
    models.push_back(readClosedModel(file));
  for (const ClosedModel& model : models) {
    Counts of_model;
    for (std::size_t c = 0; c < cuts.size(); ++c)
      for (std::uint64_t round = 0; round < rounds; ++round) {
        app::RandomNumbers random(1000 * round + c);
        const std::vector<Damage> damages = chooseDamages(model, cuts[c], random);
        const Counts counts =
            orientOnce(filtered(model, removedBy(damages, model, cuts[c].thickness)),
                       isWoundOutward(model),
                       random);
        of_model.add(counts);
        of_cut[c].add(counts);
        all.add(counts);
      }
    printRow(out, model.name, of_model);
  }
  for (std::size_t c = 0; c < cuts.size(); ++c)
    printRow(out, nameOf(cuts[c]), of_cut[c]);
  printRow(out, "all", all);
}

} // namespace bench
