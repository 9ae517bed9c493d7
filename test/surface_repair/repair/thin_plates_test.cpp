// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of plates that are cut in two and whose rims come
// back.

#include "support/completion_shapes.h"
#include "support/repair_fixture.h"
#include "surface_repair/boundary/boundary_models.h"

#include <algorithm>
#include <cmath>

namespace pcl::repair {
namespace {

using namespace test;

Positions
newPositions(const Repaired& result)
{
  const Positions all =
      ccaa::copyPositions(ccaa::positionView(result.output.cloud)).positions;
  return {all.begin() + static_cast<std::ptrdiff_t>(pointsOf(result.input)), all.end()};
}

TEST(ThinPlate, IsTheBoxThatItWas)
{
  for (const double tilt : {0.0, 0.7}) {
    const Repaired result = repaired(
        withoutFreeVertices(test::without(box(40, 20, 2), [tilt](const Position& p) {
          return std::abs(p.x() - 20.0 + tilt * (p.y() - 10.0)) < 3.0;
        })));
    EXPECT_TRUE(result.report.complete());
    for (const Position& p : newPositions(result)) {
      const double off = std::min({std::abs(p.y()),
                                   std::abs(p.y() - 20.0),
                                   std::abs(p.z()),
                                   std::abs(p.z() - 2.0)});
      EXPECT_LT(off, 1e-4) << p.transpose();
    }
  }
}

/** Points of the lost rim have vertices as near as there are elsewhere on the rim. */
TEST(ThinPlate, GetsItsRoundRimBack)
{
  const double edge = 0.05;
  for (const double flatness : {0.05, 0.1}) {
    Shape shape = icosphere(5);
    for (Position& p : shape.vertices)
      p.z() *= flatness;
    const auto isLost = [](const Position& p) { return std::abs(p.x() - 0.1) < 0.2; };
    const Repaired result =
        repaired(withoutFreeVertices(test::without(std::move(shape), isLost)));
    EXPECT_TRUE(result.report.complete());
    const Positions found = newPositions(result);
    for (int degree = 0; degree < 360; ++degree) {
      const double angle = M_PI * degree / 180.0;
      const Position rim(std::cos(angle), std::sin(angle), 0.0);
      if (!isLost(rim))
        continue;
      const bool has_near =
          std::any_of(found.begin(), found.end(), [&](const Position& p) {
            return (p - rim).norm() < edge;
          });
      EXPECT_TRUE(has_near) << degree << " degrees, flatness " << flatness;
    }
  }
}

} // namespace
} // namespace pcl::repair
