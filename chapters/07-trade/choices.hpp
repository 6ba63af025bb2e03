/// @file
/// What is chosen, as plain data: for each scene its wish, and three ways to run it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "common/physics/precision.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_07 {

/// Values of some of the earlier scene's parameters, by name.
using Settings = std::map<std::string, double>;

/// One way to run a scene: with which method, in how many steps, set how.
struct Option {
  std::string name;     ///< of the choice: too_cheap, good_enough, costly
  std::string method;   ///< of the earlier scene
  int steps_per_frame;  ///< its steps in one step of this chapter's scene
  Settings settings;    ///< that differ from the other choices'
};

/// What is good enough: the size of an earlier scene's metric stays below the limit.
struct Wish {
  std::string metric;
  double limit;  ///< in the metric's unit
};

/// A scene of an earlier chapter, and what there is to choose.
struct Trade {
  std::string name, summary;     ///< of this chapter's scene
  std::string chapter, earlier;  ///< where the scene is from: "06-impulses", "stack"
  double frame, duration;        ///< [s]
  Settings settings;             ///< of all choices
  std::vector<std::string> parameters;  ///< of the earlier scene, offered here too
  std::vector<Wish> wishes;             ///< all of which are to be met
  std::vector<Option> options;
};

/// Every trade, in the order of the chapter's scenes.
const std::vector<Trade>& trades();

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_07
