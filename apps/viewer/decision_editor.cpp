// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: decisions that are made while looking at them.
#include "viewer/decision_editor.h"

#include "io/decisions_file.h"

#include <utility>

namespace app {

using pcl::repair::Cap;
using pcl::repair::LoopWish;

std::vector<std::size_t>
DecisionEditor::chosenLoops() const
{
  if (size() == 0)
    return {};
  if (isLoop())
    return {chosen_};
  const auto& junction = decisions_.junctions[chosen_ - decisions_.loops.size()];
  return {junction.first_loop, junction.second_loop};
}

void
DecisionEditor::chooseNext(int places)
{
  const auto count = static_cast<std::ptrdiff_t>(size());
  const std::ptrdiff_t next = static_cast<std::ptrdiff_t>(chosen_) + places + count;
  if (count > 0)
    chosen_ = static_cast<std::size_t>(next % count);
}

void
DecisionEditor::remember()
{
  steps_.push_back({chosen_, decisions_});
}

void
DecisionEditor::decide(bool yes)
{
  if (size() == 0)
    return;
  remember();
  if (isLoop())
    decisions_.loops[chosen_].wish = yes ? LoopWish::CLOSE : LoopWish::LEAVE_OPEN;
  else
    junction().join = yes;
}

void
DecisionEditor::changeCap()
{
  if (size() == 0 || !isLoop())
    return;
  remember();
  Cap& cap = decisions_.loops[chosen_].cap;
  cap = cap == Cap::AUTO ? Cap::FLAT : cap == Cap::FLAT ? Cap::SMOOTH : Cap::AUTO;
}

bool
DecisionEditor::undo()
{
  if (steps_.empty())
    return false;
  chosen_ = steps_.back().chosen;
  decisions_ = std::move(steps_.back().before);
  steps_.pop_back();
  return true;
}

std::size_t
DecisionEditor::unsaved() const
{
  std::size_t count = 0;
  for (std::size_t k = 0; k < decisions_.loops.size(); ++k) {
    const auto& now = decisions_.loops[k];
    const auto& before = saved_.loops[k];
    count += now.wish != before.wish || now.cap != before.cap ? 1 : 0;
  }
  for (std::size_t k = 0; k < decisions_.junctions.size(); ++k)
    count += decisions_.junctions[k].join != saved_.junctions[k].join ? 1 : 0;
  return count;
}

std::string
DecisionEditor::tell() const
{
  if (size() == 0)
    return "There is nothing to decide.";
  if (isLoop())
    return tellLoop(chosen_, decisions_.loops[chosen_]);
  const std::size_t number = chosen_ - decisions_.loops.size();
  return tellJunction(number, decisions_.junctions[number]);
}

} // namespace app
