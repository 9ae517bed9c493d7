// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the viewer shows, and the keys that change it.
#pragma once

#include "render/stage_builder.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace app {

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
  SHOW_RESULT,
  UNDO,
  SAVE,
  SAVE_MESH,
  OPEN_FILE,
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
  const char* key;
  const char* meaning;
};

/** \brief The keys of the layers, in their order. */
constexpr std::array<KeyHelp, LAYERS> LAYER_KEYS{{{"s", "surface"},
                                                  {"i", "inner side"},
                                                  {"e", "edges"},
                                                  {"l", "lines"},
                                                  {"m", "normals"},
                                                  {"p", "points"}}};

/** \brief All other keys, for the help. */
constexpr std::array<KeyHelp, 9> OTHER_KEYS{{{"n b", "next stage, back"},
                                             {"1-9", "go to a stage"},
                                             {"+ -", "thicker, thinner"},
                                             {"r", "see the whole model"},
                                             {"o", "from the other side"},
                                             {"j", "screenshot"},
                                             {"f", "open a file"},
                                             {"h", "hide or show keys"},
                                             {"q", "quit"}}};

/** \brief The keys by which decisions are made, for the help. */
constexpr std::array<KeyHelp, 8> DECISION_KEYS{{{". ,", "next, previous"},
                                                {"click k", "what is at the mouse"},
                                                {"a", "close, join"},
                                                {"x", "leave open, apart"},
                                                {"c", "flat or smooth"},
                                                {"v", "result here"},
                                                {"u", "undo"},
                                                {"w y", "save decisions, mesh"}}};

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
