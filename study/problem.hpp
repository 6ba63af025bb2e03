/// @file
/// What the study measures: scenes of the chapters, each with the number that is its
/// error and with what is varied.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

namespace timestep::study {

/// A parameter of the scene that is varied for these methods; for all if none is named.
struct Axis {
  std::string parameter;
  std::vector<double> values;
  std::vector<std::string> methods{};
};

/// A scene, the metric that is its error, and what is varied in it.
struct Problem {
  std::string name, chapter, scene;
  std::string metric;       ///< its size at the end of the run is the error
  std::string known{};      ///< metric that it should equal; empty: it should be 0
  std::string exact;        ///< what the error is measured from, for the reader
  double frame = 1.0 / 60;  ///< [s] of the scene for which cost is given
  double duration = 0;      ///< of the run [s]
  std::vector<std::string> methods{};        ///< empty: all of the scene
  std::vector<double> dts;                   ///< steps [s], the longest first
  std::vector<Axis> axes{};                  ///< varied independently of each other
  std::map<std::string, double> settings{};  ///< other than the scene's defaults
  bool quick = false;                        ///< part of the quick study
};

/// All of them, chapter by chapter.
const std::vector<Problem>& problems();

/// Those that have one of these names, or show a scene of that name; all if there is
/// none. Throws InputError, with the nearest names, for a name that is neither.
std::vector<const Problem*> chosen_problems(std::span<const std::string> names);

/// The problems of each chapter; `problems` joins them.
std::vector<Problem> particle_problems();  // chapter 1
std::vector<Problem> verlet_problems();    // chapter 2
std::vector<Problem> rotation_problems();  // chapter 3
std::vector<Problem> contact_problems();   // chapters 4 and 5
std::vector<Problem> impact_problems();    // chapter 6: few bodies
std::vector<Problem> stack_problems();     // chapter 6: bodies on bodies

/// `count` steps, each half as long as the one before it.
std::vector<double> halved(double longest, int count);

}  // namespace timestep::study
