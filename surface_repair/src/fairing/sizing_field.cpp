// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how long the edges of a patch should be.

#include "fairing/sizing_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::repair {

namespace {

/** Operations of a sweep for each triangle. */
constexpr std::size_t SWEEP_WORK = 3;

/** Inner vertices take the mean of the logarithms around, weighted by 1 / length. */
class LogarithmSweeps {
public:
  LogarithmSweeps(const Patch& patch, std::vector<double>& logarithms)
  : patch_(patch)
  , logarithms_(logarithms)
  , weights_(logarithms.size())
  , moments_(logarithms.size())
  {}

  /** \return the greatest change */
  double
  sweep()
  {
    std::fill(weights_.begin(), weights_.end(), 0.0);
    std::fill(moments_.begin(), moments_.end(), 0.0);
    for (const Triangle& triangle : patch_.triangles)
      for (std::size_t c = 0; c < 3; ++c)
        add(static_cast<std::size_t>(triangle[c]),
            static_cast<std::size_t>(triangle[(c + 1) % 3]));
    double change = 0.0;
    for (std::size_t v = patch_.rim.size(); v < logarithms_.size(); ++v) {
      if (!(weights_[v] > 0.0))
        continue;
      const double mean = moments_[v] / weights_[v];
      change = std::max(change, std::abs(mean - logarithms_[v]));
      logarithms_[v] = mean;
    }
    return change;
  }

private:
  void
  add(std::size_t a, std::size_t b)
  {
    const double length = (patch_.positions[a] - patch_.positions[b]).norm();
    if (!(length > 0.0))
      return;
    weights_[a] += 1.0 / length;
    moments_[a] += logarithms_[b] / length;
    weights_[b] += 1.0 / length;
    moments_[b] += logarithms_[a] / length;
  }

  const Patch& patch_;
  std::vector<double>& logarithms_;
  std::vector<double> weights_;
  std::vector<double> moments_;
};

/** Every vertex of the rim takes half from its neighbours on the rim. */
std::vector<double>
smoothedAlongRim(const Patch& patch, const std::vector<double>& lengths)
{
  std::vector<double> sums(lengths.size(), 0.0);
  std::vector<double> counts(lengths.size(), 0.0);
  const std::size_t rim = patch.rim.size();
  for (const Triangle& triangle : patch.triangles)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto a = static_cast<std::size_t>(triangle[c]);
      const auto b = static_cast<std::size_t>(triangle[(c + 1) % 3]);
      if (a >= rim || b >= rim ||
          (patch.positions[a] - patch.positions[b]).norm() > lengths[a] + lengths[b])
        continue;
      sums[a] += lengths[b];
      sums[b] += lengths[a];
      counts[a] += 1.0;
      counts[b] += 1.0;
    }
  std::vector<double> smooth = lengths;
  for (std::size_t v = 0; v < rim; ++v)
    if (counts[v] > 0.0)
      smooth[v] = 0.5 * (lengths[v] + sums[v] / counts[v]);
  return smooth;
}

} // namespace

double
meanEdgeLength(const IncompleteModel& model, pcl::index_t vertex)
{
  const Position& place = model.positions[static_cast<std::size_t>(vertex)];
  double sum = 0.0;
  std::size_t count = 0;
  for (const auto* t = model.adjacency.begin(vertex); t != model.adjacency.end(vertex);
       ++t)
    for (const pcl::index_t corner : model.triangles[static_cast<std::size_t>(*t)])
      if (corner != vertex) {
        sum += (model.positions[static_cast<std::size_t>(corner)] - place).norm();
        ++count;
      }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

void
interpolateLengths(const Patch& patch,
                   std::size_t sweeps,
                   std::vector<double>& lengths,
                   ccaa::RunControl* control)
{
  std::vector<double> logarithms(lengths.size());
  std::transform(lengths.begin(), lengths.end(), logarithms.begin(), [](double length) {
    return std::log(length);
  });
  LogarithmSweeps averaging(patch, logarithms);
  for (std::size_t i = 0; i < sweeps; ++i)
    if (averaging.sweep() < 1e-3 ||
        !ccaa::spend(control, SWEEP_WORK * patch.triangles.size()))
      break;
  for (std::size_t v = patch.rim.size(); v < lengths.size(); ++v)
    lengths[v] = std::exp(logarithms[v]);
}

std::vector<double>
sizingField(const IncompleteModel& model,
            const Patch& patch,
            std::size_t sweeps,
            ccaa::RunControl* control)
{
  std::vector<double> lengths(patch.positions.size(), 0.0);
  double logarithm = 0.0, count = 0.0;
  for (std::size_t v = 0; v < patch.rim.size(); ++v) {
    lengths[v] = meanEdgeLength(model, patch.rim[v]);
    if (!(lengths[v] > 0.0))
      continue;
    logarithm += std::log(lengths[v]);
    count += 1.0;
  }
  const double middle = count > 0.0 ? std::exp(logarithm / count)
                                    : std::numeric_limits<double>::infinity();
  for (double& length : lengths)
    if (!(length > 0.0))
      length = middle;
  if (count > 0.0) {
    lengths = smoothedAlongRim(patch, lengths);
    interpolateLengths(patch, sweeps, lengths, control);
  }
  return lengths;
}

} // namespace pcl::repair
