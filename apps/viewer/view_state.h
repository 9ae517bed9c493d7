// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the viewer shows, and the keys that change it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace app {

/** \brief What can be shown or hidden in every stage. */
enum class Layer : std::uint8_t { SURFACE, INNER_SIDE, EDGES, LINES, NORMALS, POINTS };

constexpr std::size_t LAYERS = 6;

enum class Command : std::uint8_t {
  NONE,
  NEXT_STAGE,
  PREVIOUS_STAGE,
  GO_TO_STAGE,
  TOGGLE_LAYER,
  THICKER,
  THINNER,
  FIT_VIEW,
  OPPOSITE_VIEW,
  SCREENSHOT,
  NEXT_DECISION,
  PREVIOUS_DECISION,
  CHOOSE_HERE,
  ACCEPT,
  REJECT,
  CHANGE_CAP,
  UNDO,
  SAVE,
  HELP,
  QUIT
};

/** \brief What a key asks for. */
struct Action {
  Command command = Command::NONE;
  std::size_t stage = 0; /**< from 0, for GO_TO_STAGE */
  Layer layer = Layer::SURFACE;
};

/** \brief What a key asks for, by its X name such as "n", "Right" or "plus". */
Action
actionOf(const std::string& key_symbol);

/** \brief A key and what it does. */
struct KeyHelp {
  std::string key;
  std::string meaning;
};

/** \brief The keys of the layers, in their order. */
const std::array<KeyHelp, LAYERS>&
layerKeys();

/** \brief All other keys, for the help. */
const std::vector<KeyHelp>&
otherKeys();

/** \brief The keys by which decisions are made, for the help. */
const std::vector<KeyHelp>&
decisionKeys();

/** \brief The stage and the layers that are shown. Edges and normals are hidden at
 * first: they would hide the rest. */
class ViewState {
public:
  explicit ViewState(std::size_t stages) : stages_(stages)
  {
    visible_.fill(true);
    visible_[static_cast<std::size_t>(Layer::EDGES)] = false;
    visible_[static_cast<std::size_t>(Layer::NORMALS)] = false;
  }

  /** \brief Do what an action asks for, as far as it is a matter of this state.
   * \return whether the picture is another one now */
  bool
  apply(const Action& action);

  std::size_t
  stage() const
  {
    return stage_;
  }

  bool
  shows(Layer layer) const
  {
    return visible_[static_cast<std::size_t>(layer)];
  }

  /** \brief Whether the keys are listed. */
  bool
  help() const
  {
    return help_;
  }

  /** \brief Factor for the widths of lines and dots. */
  double
  thickness() const
  {
    return thickness_;
  }

  bool
  quits() const
  {
    return quits_;
  }

private:
  bool
  goTo(std::size_t stage);

  std::size_t stages_;
  std::size_t stage_ = 0;
  std::array<bool, LAYERS> visible_{};
  double thickness_ = 1.0;
  bool help_ = true;
  bool quits_ = false;
};

} // namespace app
