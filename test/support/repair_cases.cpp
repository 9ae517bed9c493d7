// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the cases of repair_shapes.h.
#include "repair_case_making.h"

#include <cmath>

namespace pcl::ccaa::test {
namespace {

constexpr Topology DISC{1, 1, 1};

double
angleFromPole(const Position& p)
{
  return std::acos(p.z() / p.norm());
}

/** \brief Winds some of the islands inward. */
RepairCase
flipped(const RepairCase& given, const std::vector<std::size_t>& islands)
{
  return changed(given, [islands](DamagedModel& model) {
    Triangles& triangles = model.damaged.triangles;
    const std::vector<std::size_t> component = componentOfTriangles(triangles);
    for (std::size_t t = 0; t < component.size(); ++t)
      for (const std::size_t island : islands)
        if (component[t] == island)
          std::swap(triangles[t][1], triangles[t][2]);
  });
}

/** \brief Both sides of a plane through the origin, `gap` apart. */
PieceOf
halves(const Position& normal, double gap)
{
  return [normal, gap](const Position& p) {
    const double height = normal.dot(p);
    return std::abs(height) < 0.5 * gap ? -1 : height > 0.0 ? 1 : 0;
  };
}

/** \brief A torus around z in three tubes. */
PieceOf
tubes(double half_angle, double turn)
{
  return [half_angle, turn](const Position& p) {
    const double third = 2.0 * M_PI / 3.0;
    const double angle = std::atan2(p.y(), p.x()) + 4.0 * M_PI + turn;
    const double within = std::fmod(angle, third);
    if (within < half_angle || within > third - half_angle)
      return -1;
    return static_cast<int>(angle / third) % 3;
  };
}

/** \brief The frame without slabs across its three short bars and, `more`, across the
 * four parts of its long ones. */
PieceOf
frameInTubes(double gap, bool more)
{
  return [gap, more](const Position& p) {
    if (std::abs(p.y()) < 0.5 * gap)
      return -1;
    const int half = p.y() > 0.0 ? 1 : 0;
    if (!more)
      return half;
    const double from_cut = std::abs(std::abs(p.x()) - 1.0);
    if (from_cut < 0.5 * gap)
      return -1;
    return half + 2 * (p.x() < -1.0 ? 0 : p.x() < 1.0 ? 1 : 2);
  };
}

/** \brief Inside, lost, outside: by a distance from somewhere. */
int
ringPiece(double distance, double from, double to)
{
  return distance < from ? 0 : distance < to ? -1 : 1;
}

PieceOf
withoutBall(const Position& middle, double radius)
{
  return [middle, radius](const Position& p) {
    return (p - middle).norm() < radius ? -1 : 0;
  };
}

Shape
wheel()
{
  return torus(96, 40);
}

Shape
genusTwo()
{
  return frame(8);
}

Shape
nested()
{
  return nestedSpheres(4);
}

Shape
centredCube()
{
  return translated(cube(24, 2.0), Position(-1, -1, -1));
}

Shape
hills()
{
  return terrain(50, 50, 1.0);
}

Shape
pass()
{
  return saddle(40);
}

Shape
pipe()
{
  return cylinder(64, 60, 1.0, 6.0);
}

Shape
flatSphere()
{
  Shape shape = icosphere(5);
  for (Position& p : shape.vertices)
    p.z() /= 16.0;
  return shape;
}

/** \brief Discs around three places in a wide hole at the pole. */
int
pieceInPolarHole(const Position& p, double turn)
{
  if (angleFromPole(p) > 1.15)
    return 3;
  for (int i = 0; i < 3; ++i) {
    const double angle = turn + 2.0 * M_PI * i / 3.0;
    const double polar = 0.6;
    const Position middle(std::sin(polar) * std::cos(angle),
                          std::sin(polar) * std::sin(angle),
                          std::cos(polar));
    if ((p - middle).norm() < 0.3)
      return i;
  }
  return -1;
}

} // namespace

std::vector<RepairCase>
casesInPieces(std::uint64_t seed)
{
  RandomSource random(seed);
  const double turn = random.uniform(0.0, 2.0);
  std::vector<RepairCase> cases;
  for (const std::size_t count : {2U, 4U, 9U})
    for (const double gap : {0.03, 0.1, 0.2})
      cases.push_back(
          makeCase("SphereIn" + std::to_string(count) + "Gap" + percent(gap),
                   sphere,
                   SPHERE,
                   cells(count, 2.0 * gap, seed)));
  cases.push_back(flipped(
      makeCase("SphereIn4TwoFlipped", sphere, SPHERE, cells(4, 0.16, seed)), {0, 2}));
  for (const double half_angle : {0.06, 0.12, 0.2})
    cases.push_back(makeCase("TorusInThreeTubesGap" + percent(half_angle),
                             wheel,
                             {1, 0, 0},
                             tubes(half_angle, turn)));
  for (const double gap : {0.25, 0.5}) {
    cases.push_back(makeCase("GenusTwoInTwoGap" + percent(gap),
                             genusTwo,
                             {1, -2, 0},
                             frameInTubes(gap, false)));
    cases.push_back(makeCase("GenusTwoInSixGap" + percent(gap),
                             genusTwo,
                             {1, -2, 0},
                             frameInTubes(gap, true)));
  }
  const Position across(std::cos(turn), std::sin(turn), 0.0);
  for (const double gap : {0.14, 0.25})
    cases.push_back(makeCase(
        "FlatSphereHalvedGap" + percent(gap), flatSphere, SPHERE, halves(across, gap)));
  cases.push_back(
      makeCase("NestedSpheresInPieces", nested, {2, 4, 0}, [](const Position& p) {
        if (p.cwiseAbs().minCoeff() < 0.06)
          return -1;
        return (p.x() > 0 ? 1 : 0) + (p.y() > 0 ? 2 : 0) + (p.z() > 0 ? 4 : 0);
      }));
  return cases;
}

std::vector<RepairCase>
casesWithHoles(std::uint64_t seed)
{
  RandomSource random(seed);
  const double turn = random.uniform(0.0, 2.0);
  const auto polarRing = [](double from, double to) {
    return
        [from, to](const Position& p) { return ringPiece(angleFromPole(p), from, to); };
  };
  std::vector<RepairCase> cases;
  cases.push_back(
      makeCase("SmallCapInPolarHole", sphere, SPHERE, polarRing(0.25, 0.6)));
  cases.push_back(makeCase("WideCapInPolarHole", sphere, SPHERE, polarRing(0.6, 0.85)));
  cases.push_back(
      flipped(makeCase("ThreeIslandsInOneHole",
                       sphere,
                       SPHERE,
                       [turn](const Position& p) { return pieceInPolarHole(p, turn); }),
              {0}));
  for (const double width : {0.08, 0.15})
    cases.push_back(makeCase("FlatSphereRing" + percent(width),
                             flatSphere,
                             SPHERE,
                             [width](const Position& p) {
                               const double radius = std::hypot(p.x(), p.y());
                               const int piece = ringPiece(radius, 0.4, 0.4 + width);
                               return piece == 0 && p.z() < 0.0 ? 2 : piece;
                             }));
  cases.push_back(
      makeCase("NestedSpheresWithHoles", nested, {2, 4, 0}, [](const Position& p) {
        return std::abs(p.z()) > 0.85 * p.norm() ? -1 : 0;
      }));
  const Position corner(1, 1, 1);
  for (const double radius : {0.3, 0.6})
    cases.push_back(makeCase("CubeWithoutCorner" + percent(radius),
                             centredCube,
                             SPHERE,
                             withoutBall(corner, radius)));
  cases.push_back(
      makeCase("CubeWithoutEdge", centredCube, SPHERE, [](const Position& p) {
        const double aside = std::max(1.0 - p.x(), 1.0 - p.y());
        return std::abs(p.z()) < 0.7 && aside < 0.3 ? -1 : 0;
      }));
  for (const double half_angle : {0.1, 0.25})
    cases.push_back(makeCase("HandleCutGap" + percent(half_angle),
                             wheel,
                             {1, 0, 0},
                             [half_angle](const Position& p) {
                               const double angle = std::atan2(p.y(), p.x());
                               return std::abs(angle) < half_angle ? -1 : 0;
                             }));
  cases.push_back(makeCase("MouthOfAHandle",
                           genusTwo,
                           {1, -2, 0},
                           withoutBall(Position(0.0, 0.55, 0.0), 0.62)));
  return cases;
}

std::vector<RepairCase>
openCases(std::uint64_t seed)
{
  RandomSource random(seed);
  const double x = random.uniform(20.0, 30.0);
  const double y = random.uniform(20.0, 30.0);
  std::vector<RepairCase> cases;
  for (const double width : {3.0, 6.0})
    cases.push_back(makeCase("TerrainWithRingGap" + std::to_string(std::lround(width)),
                             hills,
                             DISC,
                             [x, y, width](const Position& p) {
                               const double radius = std::hypot(p.x() - x, p.y() - y);
                               return ringPiece(radius, 6.0, 6.0 + width);
                             }));
  cases.push_back(
      makeCase("SaddleWithHole", pass, DISC, withoutBall(Position::Zero(), 0.35)));
  cases.push_back(makeCase("SaddleWithRingGap", pass, DISC, [](const Position& p) {
    return ringPiece(std::hypot(p.x(), p.y()), 0.35, 0.55);
  }));
  const PieceOf all = [](const Position&) { return 0; };
  const auto unclear = [](DamagedModel& model) { model.clear = false; };
  cases.push_back(changed(
      makeCase("PipeWithHole", pipe, {1, 0, 2}, withoutBall(Position(1, 0, 3), 0.5)),
      unclear));
  cases.push_back(changed(makeCase("Pipe", pipe, {1, 0, 2}, all), unclear));
  cases.push_back(
      changed(makeCase(
                  "Moebius", [] { return moebiusBand(40); }, {1, 0, 1}, all),
              unclear));
  cases.push_back(makeCase("ClosedSphere", sphere, SPHERE, all));
  return cases;
}

} // namespace pcl::ccaa::test
