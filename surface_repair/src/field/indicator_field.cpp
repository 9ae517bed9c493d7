// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the tensor field whose force lines are the bridges (4.43).
#include "field/indicator_field.h"

#include "field/field_kernel.h"
#include "field/passages.h"
#include "field/query_bunch.h"
#include "field/source_blocks.h"

#include <algorithm>
#include <cmath>

namespace pcl::repair {
namespace {

/** \brief Queries a thread takes at once. */
constexpr std::size_t QUERY_BLOCK = 256;
/** Operations for the tension at a place. */
constexpr std::uint64_t QUERY_WORK = 2000;

/** \brief A source nearer than this share of L_2 is the point itself. */
constexpr double SAME_PLACE = 1e-12;

/** \brief What a thread works with. */
struct Workspace {
  BunchCandidates candidates;
  std::vector<std::uint32_t> selected; /**< the blocks a query needs */
  Passages passages;                   /**< to their sources */
};

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
  Surroundings around; /**< empty: light mode */
  const field_kernel::Kernel& kernel = field_kernel::bestKernel();

  Implementation(const SourceSet& set,
                 double k_i,
                 const Surroundings& surroundings,
                 double coarse_distance)
  : sources(set), blocks(set, coarse_distance), interpolation(k_i), around(surroundings)
  {}

  /** \brief Answer the queries of one bunch: one search serves them all. */
  void
  answer(const FieldQuery* first,
         const FieldQuery* last,
         Tension* tensions,
         Workspace& space) const;
  Tension
  sum(const FieldQuery& query, Workspace& space) const;
  field_kernel::Task
  taskFor(const FieldQuery& query) const;
};

field_kernel::Task
IndicatorField::Implementation::taskFor(const FieldQuery& query) const
{
  const double scale = blocks.scale();
  const Position x = blocks.toFrame(query.position);
  field_kernel::Task task;
  task.blocks = blocks.rows();
  task.far = query.falloff.far * scale;
  task.inverse_width = inverseWidth(query.falloff, scale);
  task.exponent = query.falloff.exponent;
  task.least_squared = std::pow(SAME_PLACE * task.far, 2);
  task.half_interpolation = 0.5 * interpolation;
  for (int k = 0; k < 3; ++k)
    task.position[k] = x[k];
  task.effective = query.effective.has_value();
  task.coarse = around.empty() && !task.effective;
  if (query.effective) {
    for (int k = 0; k < 3; ++k)
      task.tangent[k] = query.effective->tangent[k];
    task.arc = query.effective->arc;
    task.threshold = query.effective->threshold;
    task.length = sources.curves[query.effective->curve].length;
  }
  return task;
}

Tension
IndicatorField::Implementation::sum(const FieldQuery& query, Workspace& space) const
{
  Eigen::Matrix<double, 3, 3, Eigen::RowMajor> tension = Tension::Zero();
  const field_kernel::Candidates candidates = space.candidates.view();
  if (!canBeAnswered(query) || candidates.count == 0)
    return tension;
  field_kernel::Task task = taskFor(query);
  space.selected.resize(field_kernel::LANES * candidates.count);
  task.count = kernel.select(candidates, task, space.selected.data());
  task.list = space.selected.data();
  space.selected.resize(task.count);
  if (!around.empty()) {
    space.passages.find(blocks, space.selected, query, around);
    task.ratios = space.passages.ratios().data();
    task.deltas = space.passages.deltas().data();
  }
  kernel.sum(task, tension.data());
  return tension;
}

void
IndicatorField::Implementation::answer(const FieldQuery* first,
                                       const FieldQuery* last,
                                       Tension* tensions,
                                       Workspace& space) const
{
  space.candidates.find(blocks, first, last);
  for (const FieldQuery* query = first; query != last; ++query)
    tensions[query - first] = sum(*query, space);
}

IndicatorField::IndicatorField(const SourceSet& sources,
                               double interpolation,
                               const FreePointField* free_points,
                               const Shield* shield,
                               double coarse_distance)
: implementation_(std::make_unique<Implementation>(
      sources,
      interpolation,
      Surroundings{free_points, shield, sources.spacing},
      coarse_distance))
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
  // Kept by each thread: trackers ask point by point, and memory and searches cost more
  // than sums.
  thread_local Workspace space;
  space.candidates.findAlong(implementation_->blocks, query);
  return implementation_->sum(query, space);
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
          implementation_->answer(
              &queries[i], &queries[i] + count, &tensions[i], space);
          i += count;
          if (!ccaa::spend(context.control, QUERY_WORK * count))
            break;
        }
      });
  return tensions;
}

} // namespace pcl::repair
