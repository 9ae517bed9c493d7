// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how cases of repair_shapes.h are made.

#pragma once

#include "random_source.h"
#include "repair_shapes.h"

#include <cmath>
#include <functional>
#include <string>
#include <utility>

namespace pcl::ccaa::test {

constexpr Topology SPHERE{1, 2, 0};

using MakeShape = std::function<Shape()>;

inline Shape
sphere()
{
  return icosphere(4);
}

inline DamagedModel
damagedModel(Shape truth, const Topology& whole, const PieceOf& piece_of)
{
  DamagedModel model;
  model.damaged = inPieces(truth, piece_of);
  model.wound = model.damaged.triangles;
  model.whole = whole;
  model.truth = std::move(truth);
  return model;
}

inline RepairCase
makeCase(const std::string& name,
         const MakeShape& make_shape,
         const Topology& whole,
         const PieceOf& piece_of)
{
  return {name, [=] { return damagedModel(make_shape(), whole, piece_of); }};
}

/** \brief The case, changed in some way when it is made. */
inline RepairCase
changed(const RepairCase& given, const std::function<void(DamagedModel&)>& change)
{
  return {given.name, [=] {
            DamagedModel model = given.make();
            change(model);
            return model;
          }};
}

inline std::string
percent(double share)
{
  return std::to_string(std::lround(100.0 * share)) + "Percent";
}

} // namespace pcl::ccaa::test
