/// @file
/// A scene moved twice, with one ingredient of the physics and without it: what it
/// costs and which error its absence causes. Source: chapter 7.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace timestep::study {

/// A scene under way.
struct Motion {
  std::function<void()> step;
  std::function<double()> error;  ///< of what it is now, in the comparison's unit
};

/// What is modelled, in a word or two, and how it starts: each time the same.
struct Model {
  std::string name;
  std::function<Motion()> start;
};

/// A row of the table.
struct Comparison {
  std::string ingredient, scene{};
  bool matters = false;      ///< whether the scene requires the ingredient
  std::string metric, unit;  ///< of the error
  std::string exact;         ///< what the error is measured from
  double dt = 1.0 / 60;      ///< [s]
  int steps = 60;            ///< after which the error is taken
  int bodies = 1;            ///< that a step moves, or pairs that it asks about
  Model with, without;
};

/// After all steps.
inline double error_of(const Comparison& comparison, const Model& model) {
  const Motion motion = model.start();
  for (int i = 0; i < comparison.steps; ++i) motion.step();
  return motion.error();
}

}  // namespace timestep::study
