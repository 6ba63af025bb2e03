/// @file
/// The panel beside the picture: everything that the command line can choose, live.
#pragma once

#include <map>
#include <set>
#include <string>

#include "common/chapter/plan.hpp"
#include "common/chapter/session.hpp"

namespace timestep {

/// Where the panel's controls stand.
struct Controls {
  const Chapter* chapter = nullptr;
  Precision precision = Precision::double_bits;
  std::string scene;
  std::set<std::string> methods{};
  std::string preset;           ///< empty if none
  double dt = 0, duration = 0;  ///< [s]
  std::map<std::string, double> parameters;
  std::filesystem::path mesh;  ///< empty if none
  bool fix_winding = false;
  std::string metric;  ///< drawn over time; empty if none
  double speed = 1;    ///< simulated seconds a second
  bool paused = false;
};

/// What the user wants done beyond moving a control.
struct Wishes {
  bool restart = false, step = false, back = false, pause = false;
};

/// The controls as a plan has them.
Controls controls_for(const Plan& plan);

/// The choice that the controls stand for.
Choice choice_of(const Controls& controls);

/// Draws the panel with Dear ImGui and takes in what the user does to it.
Wishes draw_panel(Controls& controls, Session& session);

}  // namespace timestep
