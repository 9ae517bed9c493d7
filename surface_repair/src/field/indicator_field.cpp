// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the tensor field whose force lines are the bridges (4.43).
#include <pcl/surface_repair/field/free_point_field.h>
#include <pcl/surface_repair/field/indicator_field.h>
#include <pcl/surface_repair/field/shielding.h>

#include "field_kernel.h"
#include "source_blocks.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace repair {
namespace {

/** \brief Queries that share a search, and blocks of queries a thread takes at once. */
constexpr std::size_t BUNCH_SIZE = 32;
constexpr std::size_t QUERY_BLOCK = 256;

/** \brief A bunch is no wider than this share of L_2, or its search finds too much. */
constexpr double BUNCH_WIDTH = 0.25;

/** \brief A source nearer than this share of L_2 is the point itself. */
constexpr double SAME_PLACE = 1e-12;

/** \brief What a thread works with. */
struct Workspace {
  std::vector<std::uint32_t> candidates; /**< blocks that a bunch may need */
  std::vector<std::uint32_t> selected;   /**< those that a query needs */
};

bool
canBeAnswered(const FieldQuery& query)
{
  return query.falloff.far > 0.0 && query.position.allFinite();
}

/** \brief 1 / (far - near) of the falloff; of a step, so much that all is 1 or 0. */
double
inverseWidth(const Falloff& falloff, double scale)
{
  const double width = (falloff.far - falloff.near) * scale;
  return width > 1e-200 ? 1.0 / width : 1e200;
}

} // namespace

struct IndicatorField::Implementation {
  SourceSet sources;
  SourceBlocks blocks;
  double interpolation;
  field_kernel::Sum sum = field_kernel::bestSum();

  Implementation(const SourceSet& set, double k_i)
  : sources(set), blocks(set), interpolation(k_i)
  {}

  void
  evaluate(const FieldQuery* first,
           const FieldQuery* last,
           Tension* tensions,
           Workspace& space) const;
  Tension
  answer(const FieldQuery& query, Workspace& space) const;
  void
  select(const FieldQuery& query, Workspace& space) const;
  field_kernel::Task
  taskFor(const FieldQuery& query, const Workspace& space) const;
};

void
IndicatorField::Implementation::select(const FieldQuery& query, Workspace& space) const
{
  const Position x = blocks.toFrame(query.position);
  const double far = query.falloff.far * blocks.scale();
  SourceBlocks::Range range{0, static_cast<std::uint32_t>(blocks.size())};
  if (query.effective)
    range = blocks.curve(query.effective->curve);
  space.selected.clear();
  for (const std::uint32_t b : space.candidates) {
    const Ball& ball = blocks.ball(b);
    const double reach = far + ball.radius;
    if (b >= range.begin && b < range.end && blocks.island(b) != query.silent_island &&
        (ball.center - x).squaredNorm() < reach * reach)
      space.selected.push_back(b);
  }
}

field_kernel::Task
IndicatorField::Implementation::taskFor(const FieldQuery& query,
                                        const Workspace& space) const
{
  const double scale = blocks.scale();
  const Position x = blocks.toFrame(query.position);
  field_kernel::Task task;
  task.blocks = blocks.rows();
  task.list = space.selected.data();
  task.count = space.selected.size();
  task.far = query.falloff.far * scale;
  task.inverse_width = inverseWidth(query.falloff, scale);
  task.exponent = query.falloff.exponent;
  task.least_squared = std::pow(SAME_PLACE * task.far, 2);
  task.half_interpolation = 0.5 * interpolation;
  task.effective = query.effective.has_value();
  for (int k = 0; k < 3; ++k) {
    task.position[k] = x[k];
    if (query.effective)
      task.tangent[k] = query.effective->tangent[k];
  }
  if (query.effective) {
    task.arc = query.effective->arc;
    task.threshold = query.effective->threshold;
    task.length = sources.curves[query.effective->curve].length;
  }
  return task;
}

Tension
IndicatorField::Implementation::answer(const FieldQuery& query, Workspace& space) const
{
  Eigen::Matrix<double, 3, 3, Eigen::RowMajor> tension = Tension::Zero();
  select(query, space);
  if (canBeAnswered(query) && !space.selected.empty())
    sum(taskFor(query, space), tension.data());
  return tension;
}

/** The queries are those of one bunch: one search serves them all. */
void
IndicatorField::Implementation::evaluate(const FieldQuery* first,
                                         const FieldQuery* last,
                                         Tension* tensions,
                                         Workspace& space) const
{
  Eigen::AlignedBox3d box;
  double far = 0.0;
  for (const FieldQuery* query = first; query != last; ++query)
    if (canBeAnswered(*query)) {
      box.extend(query->position);
      far = std::max(far, query->falloff.far);
    }
  space.candidates.clear();
  if (!box.isEmpty())
    blocks.near({blocks.toFrame(box.center()),
                 (far + 0.5 * box.diagonal().norm()) * blocks.scale()},
                space.candidates);
  for (const FieldQuery* query = first; query != last; ++query)
    tensions[query - first] = answer(*query, space);
}

namespace {

/** \brief Number of queries from the first on that lie so close together that one
 * search may serve them. */
std::size_t
bunchFrom(const FieldQuery* first, const FieldQuery* last)
{
  Eigen::AlignedBox3d box;
  double far = first->falloff.far;
  std::size_t count = 0;
  for (; first + count != last && count < BUNCH_SIZE; ++count) {
    const FieldQuery& query = first[count];
    box.extend(query.position);
    far = std::min(far, query.falloff.far);
    if (count > 0 && !(box.diagonal().norm() <= BUNCH_WIDTH * far))
      break;
  }
  return count;
}

} // namespace

IndicatorField::IndicatorField(const SourceSet& sources,
                               double interpolation,
                               const FreePointField* /*free_points*/,
                               const Shield* /*shield*/)
: implementation_(std::make_unique<Implementation>(sources, interpolation))
{}

IndicatorField::~IndicatorField() = default;

IndicatorField::IndicatorField(IndicatorField&&) noexcept = default;

const SourceSet&
IndicatorField::sources() const
{
  return implementation_->sources;
}

Tension
IndicatorField::tensionAt(const FieldQuery& query) const
{
  Tension tension;
  Workspace space;
  implementation_->evaluate(&query, &query + 1, &tension, space);
  return tension;
}

std::vector<Tension>
IndicatorField::tensionAt(const std::vector<FieldQuery>& queries,
                          const ccaa::LoopContext& context) const
{
  std::vector<Tension> tensions(queries.size(), Tension::Zero());
  ccaa::LoopContext blocks = context;
  blocks.block_size = std::min(context.block_size, QUERY_BLOCK);
  ccaa::forEachBlock(
      queries.size(), blocks, [&](std::size_t, std::size_t begin, std::size_t end) {
        Workspace space;
        for (std::size_t i = begin; i < end;) {
          const std::size_t count = bunchFrom(&queries[i], queries.data() + end);
          implementation_->evaluate(
              &queries[i], &queries[i] + count, &tensions[i], space);
          i += count;
        }
      });
  return tensions;
}

} // namespace repair
} // namespace pcl
