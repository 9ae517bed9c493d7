// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tracing force lines through the indicator field
// (4.41, 4.44).

#include "force_line/force_line_tracker.h"

#include "field/shielding.h"
#include "force_line/line_shape.h"
#include "force_line/line_state.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::repair {

namespace {

/** A force that the sum's rounding could have made is none: relative to one source. */
constexpr double NO_FORCE = 1e-12;

/** Steps after which a line that is still short counts as too long: it circles. */
constexpr int MOST_STEPS = 1000;
/** Operations for a line. */
constexpr std::uint64_t TRACING_WORK = 10000;

/** Reach in L_1 below which a boundary is single sources rather than a curve. */
constexpr double LEAST_REACH = 4.0;

/** Share of the way to the nearest target that one step may take, so that the inner
 * points of a step stay on this side of the boundary. */
constexpr double STEP_SHARE = 0.5;

/** First step to be tried, in L_1: beside its own boundary a line bends. */
constexpr double FIRST_STEP = 0.3;
/** Growth of a step to the next one. */
constexpr double MOST_GROWTH = 5.0;
/** Where the field ends is told to so many L_1. */
constexpr double LAST_PIECE = 0.1;

/** The tracing of one line. */
class Trace {
public:
  Trace(const IndicatorField& field,
        const BoundaryEdges& targets,
        const TrackerParameters& parameters,
        const Shield* obstacle,
        const LineOrigin& origin)
  : field_(field)
  , targets_(targets)
  , parameters_(parameters)
  , obstacle_(obstacle)
  , origin_(origin)
  , query_(origin.query)
  {}

  ForceLine
  run();

private:
  struct Step {
    Position end;
    LineState state;
    BoundaryEncounter nearest; /**< target to the end */
    double error = 0.0;
  };

  LineEnd
  begin();
  LineEnd
  follow();
  bool
  advance();
  Step
  tryStep(double length) const;
  std::optional<BoundaryEncounter>
  nearestTarget(const Position& a,
                const Position& b,
                double within,
                const BoundaryPoint& guess = {}) const;
  LineEnd
  arrive();
  void
  add(const Position& position, const LineState& state);
  double
  reachOver(double gap) const;
  LineState
  evaluate(const Position& position,
           const LineState& before,
           BoundaryEncounter& nearest) const;

  bool
  crossesSurface(const Position& a, const Position& b, double tolerance) const
  {
    return obstacle_ != nullptr && obstacle_->crosses(a, b, tolerance);
  }
  double
  near() const
  {
    return query_.falloff.near;
  }
  double
  captureDistance() const
  {
    return parameters_.capture_distance * near();
  }

  const IndicatorField& field_;
  const BoundaryEdges& targets_;
  const TrackerParameters& parameters_;
  const Shield* obstacle_;
  const LineOrigin& origin_;
  FieldQuery query_;
  ForceLine line_;
  std::vector<bool> undetermined_; /**< of the points of the line */
  Position position_ = Position::Zero();
  LineState state_;
  BoundaryEncounter nearest_; /**< target to position_ */
  double step_ = 0.0;         /**< length to try next */
};

/** \param[in,out] nearest target to a place close by, and to this one */
LineState
Trace::evaluate(const Position& position,
                const LineState& before,
                BoundaryEncounter& nearest) const
{
  constexpr double anywhere = std::numeric_limits<double>::infinity();
  nearest = *nearestTarget(position, position, anywhere, nearest.point);
  FieldQuery query = query_;
  query.position = position;
  query.falloff.far = reachOver(nearest.distance);
  return stateAt(field_.tensionAt(query), before, parameters_.least_clearness);
}

/** L_2 shrinks with the gap that is left. Near a boundary its own straight piece should
 * count: since s fades out along it, the piece's force falls like the distance to it,
 * and what lies across the target's whole region would win. */
double
Trace::reachOver(double gap) const
{
  return std::min(query_.falloff.far,
                  std::max(origin_.room * gap, LEAST_REACH * near()));
}

void
Trace::add(const Position& position, const LineState& state)
{
  if (!line_.points.empty())
    line_.length += (position - line_.points.back()).norm();
  line_.points.push_back(position);
  line_.normals.push_back(state.normal);
  line_.tensions.push_back(state.tension);
  undetermined_.push_back(state.undetermined);
  position_ = position;
  state_ = state;
}

std::optional<BoundaryEncounter>
Trace::nearestTarget(const Position& a,
                     const Position& b,
                     double within,
                     const BoundaryPoint& guess) const
{
  const auto is_target = [this](std::size_t curve) {
    return targets_.curves()[curve].island != query_.silent_island;
  };
  if (!query_.effective)
    return targets_.closest(a, b, within, is_target, {}, guess);
  const EffectiveCharge& hole = *query_.effective;
  return targets_.closestFurtherAlong(
      a, b, within, hole.curve, hole.arc, hole.threshold, guess);
}

/** One step of the method of Bogacki and Shampine; the state at the end is the first of
 * the next step. */
Trace::Step
Trace::tryStep(double length) const
{
  const Direction& first = state_.direction;
  Step step;
  step.nearest = nearest_;
  const LineState second =
      evaluate(position_ + 0.5 * length * first, state_, step.nearest);
  const LineState third =
      evaluate(position_ + 0.75 * length * second.direction, second, step.nearest);
  step.end =
      position_ +
      length / 9.0 * (2.0 * first + 3.0 * second.direction + 4.0 * third.direction);
  step.state = evaluate(step.end, third, step.nearest);
  step.error = length / 72.0 *
               (5.0 * first - 6.0 * second.direction - 8.0 * third.direction +
                9.0 * step.state.direction)
                   .norm();
  return step;
}

/** Make one step of the greatest length whose error is allowed. A length that follows
 * on one which erred too much, and that does not, grows no more before the next step.
 * \return false when the field ends. */
bool
Trace::advance()
{
  const double allowed = parameters_.tolerance * near();
  const double shortest = 1e-3 * near();
  double growth = MOST_GROWTH;
  for (;; growth = 1.0) {
    const double length =
        std::min(step_, std::max(STEP_SHARE * nearest_.distance, shortest));
    const Step step = tryStep(length);
    const bool field_ends = step.state.direction.isZero();
    const double fit = 0.9 * std::cbrt(allowed / std::max(step.error, 1e-9 * allowed));
    step_ = length * std::clamp(fit, 0.2, growth);
    if (!field_ends && (step.error <= allowed || length <= shortest)) {
      nearest_ = step.nearest;
      add(step.end, step.state);
      return true;
    }
    if (length <= (field_ends ? LAST_PIECE * near() : shortest))
      return false;
    step_ = std::max(field_ends ? 0.5 * length : step_, shortest);
  }
}

LineEnd
Trace::begin()
{
  query_.position = origin_.point.position;
  const OriginForce origin =
      forceAtOrigin(origin_.tangent, origin_.normal, field_.tensionAt(query_));
  LineState state;
  state.tension = origin.force.norm();
  state.normal = origin.normal;
  if (state.tension > NO_FORCE)
    state.direction = origin.force / state.tension;
  add(origin_.point.position, state);
  if (!(state.tension > NO_FORCE))
    return LineEnd::NO_FIELD;
  if (origin.outward <= 0.0)
    return LineEnd::REPELLED;
  step_ = std::min(query_.falloff.far, FIRST_STEP * near());
  return LineEnd::BRIDGE;
}

/** Go on until a boundary captures the line or it comes to nothing. */
LineEnd
Trace::follow()
{
  const double far = query_.falloff.far;
  const double greatest = parameters_.greatest_length * far;
  const auto first = nearestTarget(position_, position_, far);
  if (!first)
    return LineEnd::OUT_OF_REACH;
  nearest_ = *first;
  for (int count = 0; count < MOST_STEPS && line_.length <= greatest; ++count) {
    if (nearest_.distance > far)
      return LineEnd::OUT_OF_REACH;
    if (nearest_.distance <= captureDistance())
      return arrive();
    const Position from = position_;
    if (!advance())
      return LineEnd::OUT_OF_REACH;
    if (crossesSurface(from, position_, count == 0 ? 0.5 * near() : 0.0))
      return LineEnd::CROSSES_SURFACE;
  }
  return LineEnd::TOO_LONG;
}

/** The last piece, straight on to the boundary. */
LineEnd
Trace::arrive()
{
  const Position ahead = position_ + 2.0 * captureDistance() * state_.direction;
  line_.target =
      nearestTarget(position_, ahead, 2.0 * captureDistance(), nearest_.point)->point;
  const Position from = position_;
  const Direction along = (line_.target.position - from).normalized();
  const BoundaryCurve& curve = targets_.curves()[line_.target.curve].curve;
  const Direction& normal = curve.normals[line_.target.edge];
  LineState state = state_;
  const Direction across = normalAtTarget(along, curve, line_.target.edge);
  if (!across.isZero())
    state.normal = across;
  const bool wrong_side = normal.dot(state_.normal) <= 0.0;
  add(line_.target.position, state);
  if (wrong_side)
    return LineEnd::WRONG_SIDE;
  return crossesSurface(from, position_, 0.5 * near()) ? LineEnd::CROSSES_SURFACE
                                                       : LineEnd::BRIDGE;
}

ForceLine
Trace::run()
{
  line_.origin = origin_.point;
  line_.end = begin();
  if (line_.end == LineEnd::BRIDGE)
    line_.end = follow();
  completeNormals(line_, undetermined_);
  line_.quality = meanTension(line_);
  return std::move(line_);
}

} // namespace

ForceLineTracker::ForceLineTracker(const IndicatorField& field,
                                   const BoundaryEdges& targets,
                                   const TrackerParameters& parameters,
                                   const Shield* obstacle)
: field_(field), targets_(targets), parameters_(parameters), obstacle_(obstacle)
{}

ForceLine
ForceLineTracker::track(const LineOrigin& origin) const
{
  return Trace(field_, targets_, parameters_, obstacle_, origin).run();
}

std::vector<ForceLine>
ForceLineTracker::track(const std::vector<LineOrigin>& origins,
                        const ccaa::LoopContext& context) const
{
  std::vector<ForceLine> lines(origins.size());
  ccaa::LoopContext small_blocks = context;
  small_blocks.block_size = 16;
  ccaa::forEachBlock(origins.size(),
                     small_blocks,
                     [&](std::size_t, std::size_t begin, std::size_t end) {
                       for (std::size_t i = begin; i < end; ++i) {
                         lines[i] = track(origins[i]);
                         if (!ccaa::spend(context.control, TRACING_WORK))
                           break;
                       }
                     });
  return lines;
}

} // namespace pcl::repair
