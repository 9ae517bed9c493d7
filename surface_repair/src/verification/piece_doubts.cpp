// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: pieces of a result that may belong together.

#include "verification/piece_doubts.h"

#include "field/float_tree.h"
#include "mesh/contacts.h"
#include "mesh/sort_unique.h"
#include "survey/handle_choice.h"
#include "verification/junction_doubts.h"

#include <cmath>
#include <limits>
#include <set>

namespace pcl::repair {

namespace {

/** Distance between what is new of two pieces in the extent of the smaller one. */
constexpr double STRAY_GAP = 0.5;

/** A piece of the result. */
struct Piece {
  std::size_t triangles = 0;
  bool is_open = false;
  bool is_bent = false;                   /**< a junction within carries no handle */
  std::vector<pcl::index_t> new_vertices; /**< of new triangles, ascending */
  ccaa::Box box;                          /**< of these */
  ccaa::Box whole;
};

/** Pieces of which islands were joined around a bend, on odds that are not sure. */
void
markBent(const IncompleteModel& model,
         const RepairReport& report,
         std::vector<Piece>& pieces)
{
  std::set<pcl::index_t> bent;
  for (const RepairJunction& junction : report.junctions)
    if (junction.verdict == JunctionVerdict::JOINED &&
        junction.islands[0] != junction.islands[1] && !carriesHandle(junction.evidence))
      bent.insert(junction.points.begin(), junction.points.end());
  visitPieces(model, bent, [&](pcl::index_t, std::size_t piece) {
    pieces[piece].is_bent = true;
  });
}

std::vector<Piece>
piecesOf(const RepairedModel& repaired, const RepairReport& report)
{
  const IncompleteModel& model = repaired.model;
  std::vector<Piece> pieces(model.island_of.count);
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    const Triangle& triangle = model.triangles[t];
    Piece& piece = pieces[model.island_of[t]];
    ++piece.triangles;
    const bool is_new = t >= repaired.input_triangles;
    for (int corner = 0; corner < 3; ++corner) {
      const pcl::index_t vertex = triangle[static_cast<std::size_t>(corner)];
      piece.whole.extend(model.positions[static_cast<std::size_t>(vertex)]);
      if (is_new)
        piece.new_vertices.push_back(vertex);
      if (model.adjacency.across(static_cast<pcl::index_t>(t), corner) < 0)
        piece.is_open = true;
    }
  }
  markBent(model, report, pieces);
  for (Piece& piece : pieces) {
    ccaa::sortUnique(piece.new_vertices);
    for (const pcl::index_t vertex : piece.new_vertices)
      piece.box.extend(model.positions[static_cast<std::size_t>(vertex)]);
  }
  return pieces;
}

/** How near what is new of two pieces comes, and where on the second one. */
struct Approach {
  double gap = std::numeric_limits<double>::infinity();
  Position place = Position::Zero();
};

/** \return infinite where that is more than a limit */
Approach
approachWithin(double limit,
               const Piece& first,
               const Piece& second,
               const IncompleteModel& model)
{
  Approach nearest;
  const ccaa::Box near = ccaa::widened(first.box, limit);
  if (!near.intersects(second.box))
    return nearest;
  Positions places;
  for (const pcl::index_t vertex : first.new_vertices)
    places.push_back(model.positions[static_cast<std::size_t>(vertex)]);
  const FloatTree tree(places);
  for (const pcl::index_t vertex : second.new_vertices) {
    const Position& from = model.positions[static_cast<std::size_t>(vertex)];
    if (!near.contains(from))
      continue;
    const auto found = static_cast<std::size_t>(tree.nearest(from, 1).front());
    const double gap = (places[found] - from).norm();
    if (gap <= limit && gap < nearest.gap)
      nearest = {gap, from};
  }
  return nearest;
}

/** The point on a rim of what is new that is nearest to a place. */
pcl::index_t
rimPointNear(const Position& place, const Piece& piece, const IncompleteModel& model)
{
  double least = std::numeric_limits<double>::infinity();
  pcl::index_t point = pcl::UNAVAILABLE;
  for (const pcl::index_t vertex : piece.new_vertices) {
    const auto v = static_cast<std::size_t>(vertex);
    const double distance = (model.positions[v] - place).squaredNorm();
    if (model.point_of_vertex[v] == pcl::UNAVAILABLE || distance >= least)
      continue;
    least = distance;
    point = model.point_of_vertex[v];
  }
  return point;
}

bool
mayBelongTogether(const Piece& smaller, const Piece& larger)
{
  return smaller.is_bent && !smaller.is_open && !larger.is_open &&
         !larger.new_vertices.empty();
}

/** By points of both. */
std::vector<RepairDoubt>
touchingPieces(const std::vector<Piece>& pieces, const IncompleteModel& model)
{
  const auto pieceAt = [&](pcl::index_t vertex) -> const Piece& {
    const auto triangle = static_cast<std::size_t>(*model.adjacency.begin(vertex));
    return pieces[model.island_of[triangle]];
  };
  const auto pointOf = [&](pcl::index_t vertex) {
    return model.point_of_vertex[static_cast<std::size_t>(vertex)];
  };
  std::vector<RepairDoubt> touching;
  for (const auto& [vertex, other] :
       ccaa::pieceContacts(model.triangles, model.adjacency, model.positions, {})) {
    const Piece& one = pieceAt(vertex);
    const Piece& two = pieceAt(other);
    if ((!one.new_vertices.empty() || !two.new_vertices.empty()) && !one.is_open &&
        !two.is_open)
      touching.push_back(
          {DoubtReason::UNJOINED, inOrder(pointOf(vertex), pointOf(other)), 0.0});
  }
  return touching;
}

/** By the points on rims of what is new that are nearest. */
std::vector<RepairDoubt>
strayPieces(const std::vector<Piece>& pieces, const IncompleteModel& model)
{
  std::vector<RepairDoubt> stray;
  for (const Piece& smaller : pieces)
    for (const Piece& larger : pieces) {
      if (larger.triangles <= smaller.triangles || !mayBelongTogether(smaller, larger))
        continue;
      const double extent = smaller.whole.diagonal().norm();
      const Approach nearest =
          approachWithin(STRAY_GAP * extent, smaller, larger, model);
      if (std::isfinite(nearest.gap))
        stray.push_back({DoubtReason::UNJOINED,
                         inOrder(rimPointNear(nearest.place, smaller, model),
                                 rimPointNear(nearest.place, larger, model)),
                         nearest.gap / extent});
    }
  return stray;
}

} // namespace

std::vector<RepairDoubt>
doubtfulPieces(const RepairedModel& repaired,
               const RepairReport& report,
               const SurveyParameters& parameters)
{
  if (report.after.pieces < 2)
    return {};
  const std::vector<Piece> pieces = piecesOf(repaired, report);
  std::vector<RepairDoubt> doubts = touchingPieces(pieces, repaired.model);
  if (areSettled(parameters.decisions.get()))
    return doubts;
  const std::vector<RepairDoubt> stray = strayPieces(pieces, repaired.model);
  doubts.insert(doubts.end(), stray.begin(), stray.end());
  return doubts;
}

} // namespace pcl::repair
