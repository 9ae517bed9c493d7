// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: cases of repair_shapes.h with unusual input, or with free
// points.
#include "repair_case_making.h"

namespace pcl::ccaa::test {

std::vector<RepairCase>
unusualCases(std::uint64_t seed)
{
  const PieceOf four = cells(4, 0.16, seed);
  const auto moved = [&](const std::string& name, double scale, double shift) {
    return changed(makeCase(name, sphere, SPHERE, four), [=](DamagedModel& model) {
      for (Shape* shape : {&model.damaged, &model.truth})
        *shape =
            translated(scaled(*shape, scale), Position(shift, -shift, 0.5 * shift));
    });
  };
  std::vector<RepairCase> cases{moved("TinySphereInFour", 1e-4, 0.0),
                                moved("HugeSphereInFour", 1e6, 0.0),
                                moved("FarSphereInFour", 100.0, 1e5)};
  for (const double gap : {0.1, 0.3})
    cases.push_back(makeCase(
        "GradedSphereInFourGap" + percent(0.5 * gap),
        [] { return gradedSphere(5, 20.0); },
        SPHERE,
        cells(4, gap, seed)));
  cases.push_back(changed(makeCase("ShuffledSphereInFour", sphere, SPHERE, four),
                          [seed](DamagedModel& model) {
                            model.damaged = shuffled(model.damaged, seed);
                            model.wound = model.damaged.triangles;
                          }));
  return cases;
}

std::vector<RepairCase>
casesWithFreePoints(std::uint64_t seed)
{
  const PieceOf pieces = cells(4, 0.3, seed);
  using Choose = std::function<Positions(const Positions&, RandomSource&)>;
  const auto with = [&](const std::string& name, const Choose& choose) {
    return changed(makeCase("FreePoints" + name, sphere, SPHERE, pieces),
                   [=](DamagedModel& model) {
                     Positions lost;
                     for (const Position& p : model.truth.vertices)
                       if (pieces(p) < 0)
                         lost.push_back(p);
                     RandomSource random(seed);
                     model.free_points = choose(lost, random);
                   });
  };
  const auto fifth = [](const std::function<Position(Position, RandomSource&)>& move) {
    return [move](const Positions& lost, RandomSource& random) {
      Positions chosen;
      for (const Position& p : lost)
        if (random.uniform() < 0.2)
          chosen.push_back(move(p, random));
      return chosen;
    };
  };
  return {
      with("OnTheSurface", fifth([](Position p, RandomSource&) { return p; })),
      with("AllLostOnes", [](const Positions& lost, RandomSource&) { return lost; }),
      with("Noisy", fifth([](Position p, RandomSource& random) -> Position {
             return (1.0 + 0.02 * random.normal()) * p;
           })),
      with("FarAway", fifth([](Position p, RandomSource&) -> Position {
             return 5.0 * p + Position(20.0, 0.0, 0.0);
           })),
      with("SingleOutlier",
           [](const Positions& lost, RandomSource&) -> Positions {
             return {1.4 * lost[lost.size() / 2]};
           }),
      changed(with("OnTheInput", fifth([](Position p, RandomSource&) { return p; })),
              [](DamagedModel& model) {
                model.free_points.assign(model.damaged.vertices.begin(),
                                         model.damaged.vertices.begin() + 40);
              })};
}

} // namespace pcl::ccaa::test
