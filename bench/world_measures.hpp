/// @file
/// What is measured of scenes, whoever moves them: in double, by the true shapes.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "bench/world_scenes.hpp"

namespace timestep::world_bench {

/// What may be asked of a library; otherwise it does as it does by default.
struct Settings {
  double dt = 1.0 / 60;
  int iterations = 0;           ///< of its solver in a step; 0: its own
  std::optional<double> erp{};  ///< the share of a penetration that a step takes out
};

/// A scene in a library. Either may throw, if the library gives up.
struct Simulation {
  std::function<void()> step;                  ///< of the settings' dt
  std::function<std::vector<State>()> states;  ///< of all bodies, as the scene has them
};

/// A library, or one of its solvers.
struct Engine {
  std::string name;  ///< METHOD/PRECISION
  std::function<Simulation(const Scene&, const Settings&)> make;
  bool is_for_few = false;  ///< it takes far too long for many contacts
  bool has_erp = false;     ///< it heeds the settings' erp
};

/// Kinetic and potential [J], from the plane y = 0.
double energy(const Scene& scene, std::span<const State> states);

/// Of bodies that overlap: how deep the worst pair is [m], and the sum of all squared
/// depths [m²]. By the separating axis test, or closed forms.
struct Overlaps {
  double worst = 0, sum_of_squares = 0;
};
Overlaps overlaps(const Scene& scene, std::span<const State> states);

/// A mean over time, and the processor time that it took to get there [s]. Without a
/// number if the library gave up or the mean is not finite.
struct Outcome {
  double mean;
  double seconds;
};

/// The mean of `measure`, asked after every step or every 10 ms, over the simulated
/// duration [s].
Outcome mean_over_time(
    const Engine& engine, const Scene& scene, const Settings& settings, double duration,
    const std::function<double(double t, std::span<const State>)>& measure);

}  // namespace timestep::world_bench
