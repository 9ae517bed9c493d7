// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the viewer shows, and the keys that change it.
#include "viewer/view_state.h"

#include <algorithm>
#include <map>

namespace app {
namespace {

constexpr double THICKNESS_STEP = 1.25;
constexpr double GREATEST_THICKNESS = 5.0;
constexpr double LEAST_THICKNESS = 0.25;

const std::map<std::string, Command>&
commandKeys()
{
  static const std::map<std::string, Command> keys{
      {"n", Command::NEXT_STAGE},
      {"Right", Command::NEXT_STAGE},
      {"space", Command::NEXT_STAGE},
      {"Next", Command::NEXT_STAGE},
      {"b", Command::PREVIOUS_STAGE},
      {"Left", Command::PREVIOUS_STAGE},
      {"BackSpace", Command::PREVIOUS_STAGE},
      {"Prior", Command::PREVIOUS_STAGE},
      {"plus", Command::THICKER},
      {"KP_Add", Command::THICKER},
      {"minus", Command::THINNER},
      {"KP_Subtract", Command::THINNER},
      {"r", Command::FIT_VIEW},
      {"o", Command::OPPOSITE_VIEW},
      {"j", Command::SCREENSHOT},
      {"period", Command::NEXT_DECISION},
      {"comma", Command::PREVIOUS_DECISION},
      {"k", Command::CHOOSE_HERE},
      {"a", Command::ACCEPT},
      {"x", Command::REJECT},
      {"c", Command::CHANGE_CAP},
      {"v", Command::SHOW_RESULT},
      {"u", Command::UNDO},
      {"w", Command::SAVE},
      {"y", Command::SAVE_MESH},
      {"f", Command::OPEN_FILE},
      {"h", Command::HELP},
      {"q", Command::QUIT},
      {"Escape", Command::QUIT}};
  return keys;
}

} // namespace

Action
actionOf(const std::string& key_symbol)
{
  // Capitals do the same: the caps lock must not make the keys dead.
  std::string key = key_symbol;
  if (key.size() == 1 && key[0] >= 'A' && key[0] <= 'Z')
    key[0] = static_cast<char>(key[0] - 'A' + 'a');
  const std::string digit = key.substr(0, 3) == "KP_" ? key.substr(3) : key;
  if (digit.size() == 1 && digit[0] >= '1' && digit[0] <= '9') {
    return {Command::GO_TO_STAGE, static_cast<std::size_t>(digit[0] - '1'), {}};
  }
  for (std::size_t i = 0; i < LAYERS; ++i)
    if (LAYER_KEYS[i].key == key)
      return {Command::TOGGLE_LAYER, 0, static_cast<Layer>(i)};
  const auto found = commandKeys().find(key);
  return {found == commandKeys().end() ? Command::NONE : found->second, 0, {}};
}

bool
ViewState::goTo(std::size_t stage)
{
  if (stage >= stages_ || stage == stage_)
    return false;
  stage_ = stage;
  return true;
}

bool
ViewState::apply(const Action& action)
{
  bool& layer = visible_[static_cast<std::size_t>(action.layer)];
  switch (action.command) {
  case Command::NEXT_STAGE:
    return goTo(stage_ + 1);
  case Command::PREVIOUS_STAGE:
    return stage_ > 0 && goTo(stage_ - 1);
  case Command::GO_TO_STAGE:
    return goTo(action.stage);
  case Command::TOGGLE_LAYER:
    layer = !layer;
    return true;
  case Command::THICKER:
    thickness_ = std::min(thickness_ * THICKNESS_STEP, GREATEST_THICKNESS);
    return true;
  case Command::THINNER:
    thickness_ = std::max(thickness_ / THICKNESS_STEP, LEAST_THICKNESS);
    return true;
  case Command::HELP:
    help_ = !help_;
    return true;
  case Command::QUIT:
    quits_ = true;
    return false;
  default: // no matter of this state
    return false;
  }
}

} // namespace app
