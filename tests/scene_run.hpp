/// @file
/// Scenes as a program would drive them.
#pragma once

#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/chapter/scene.hpp"
#include "common/graphics/input_error.hpp"

namespace timestep {

/// The scenes of the chapter that is tested, which each test file defines.
std::vector<Scene> tested_scenes();

inline Scene scene_of(const std::string& name) {
  for (const Scene& scene : tested_scenes())
    if (scene.name == name) return scene;
  throw InputError("no scene " + name);
}

/// New values of some parameters, by name.
using Changes = std::map<std::string, double>;

/// The scene's own step and parameters, but for some.
inline Setup setup_of(const Scene& scene, const std::string& method,
                      const Changes& changes = {}) {
  Setup setup;
  setup.method = method;
  setup.dt = scene.dt;
  setup.duration = scene.duration;
  for (const Parameter& p : scene.parameters) setup.parameters[p.name] = p.value;
  for (const auto& [name, value] : changes) setup.parameters.at(name) = value;
  return setup;
}

/// Observes a simulation that has just started, and so many steps of it.
inline void run(Simulation& simulation, long long steps) {
  simulation.observe();
  for (long long i = 0; i < steps; ++i) {
    simulation.step();
    simulation.observe();
  }
}

/// What it has become after `seconds`, a whole number of steps.
inline std::unique_ptr<Simulation> run_for(const Scene& scene, const Setup& setup,
                                           double seconds) {
  std::unique_ptr<Simulation> simulation = scene.start(setup);
  run(*simulation, std::llround(seconds / setup.dt));
  return simulation;
}

/// The same of a scene by its name, with steps of dt [s].
inline std::unique_ptr<Simulation> run(const std::string& name,
                                       const std::string& method, double dt,
                                       double seconds, const Changes& changes = {}) {
  const Scene scene = scene_of(name);
  Setup setup = setup_of(scene, method, changes);
  setup.dt = dt;
  return run_for(scene, setup, seconds);
}

inline double metric(const Simulation& simulation, const std::string& name) {
  for (const Metric& m : simulation.metrics())
    if (m.name == name) return m.value;
  throw InputError("no metric " + name);
}

}  // namespace timestep
