// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the nearest position of another kind.
#include "field/labelled_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl::repair {
namespace {

/** Positions of a leaf: they are looked at one by one. */
constexpr std::size_t LEAF_SIZE = 8;

} // namespace

LabelledTree::LabelledTree(Positions positions, std::vector<std::size_t> labels)
: positions_(std::move(positions)), labels_(std::move(labels))
{
  std::vector<std::size_t> order(positions_.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  nodes_.emplace_back();
  nodes_.front().end = order.size();
  for (std::size_t node = 0; node < nodes_.size(); ++node)
    build(node, order);
  const Positions old_positions = positions_;
  const std::vector<std::size_t> old_labels = labels_;
  for (std::size_t i = 0; i < order.size(); ++i) {
    positions_[i] = old_positions[order[i]];
    labels_[i] = old_labels[order[i]];
  }
}

void
LabelledTree::build(std::size_t index, std::vector<std::size_t>& order)
{
  Node node = nodes_[index];
  if (node.begin == node.end)
    return;
  const std::size_t label = labels_[order[node.begin]];
  bool alike = true;
  for (std::size_t i = node.begin; i < node.end; ++i) {
    node.box.extend(positions_[order[i]]);
    alike = alike && labels_[order[i]] == label;
  }
  node.label = alike ? label : NONE;
  if (node.end - node.begin > LEAF_SIZE) {
    int axis = 0;
    node.box.sizes().maxCoeff(&axis);
    const std::size_t middle = (node.begin + node.end) / 2;
    const auto at = [&](std::size_t i) {
      return order.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::nth_element(
        at(node.begin), at(middle), at(node.end), [&](std::size_t a, std::size_t b) {
          return std::make_pair(positions_[a][axis], a) <
                 std::make_pair(positions_[b][axis], b);
        });
    node.children = nodes_.size();
    Node half;
    half.begin = node.begin;
    half.end = middle;
    nodes_.push_back(half);
    half.begin = middle;
    half.end = node.end;
    nodes_.push_back(half);
  }
  nodes_[index] = node;
}

void
LabelledTree::descend(const Node& node,
                      const Position& position,
                      std::size_t label,
                      double& squared) const
{
  if (node.label == label && label != NONE)
    return;
  if (!(node.box.squaredExteriorDistance(position) < squared))
    return;
  if (node.children == 0) {
    for (std::size_t i = node.begin; i < node.end; ++i)
      if (label == NONE || labels_[i] != label)
        squared = std::min(squared, (positions_[i] - position).squaredNorm());
    return;
  }
  const Node* first = &nodes_[node.children];
  const Node* second = first + 1;
  if (second->box.squaredExteriorDistance(position) <
      first->box.squaredExteriorDistance(position))
    std::swap(first, second);
  descend(*first, position, label, squared);
  descend(*second, position, label, squared);
}

double
LabelledTree::distanceToOther(const Position& position, std::size_t label) const
{
  double squared = std::numeric_limits<double>::infinity();
  if (!positions_.empty() && position.allFinite())
    descend(nodes_.front(), position, label, squared);
  return std::sqrt(squared);
}

} // namespace pcl::repair
