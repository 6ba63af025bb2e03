/// @file
/// What truth cases expect of a run, as a function of where it ends: computed in
/// double, so that it adds no rounding to the run's own.
#pragma once

#include <vector>

#include "tests/truth/kind.hpp"

namespace timestep::truth {

/// Coordinates and their rates.
struct Place {
  std::vector<double> x, v;
};

/// A place as the sum of two, of which the second holds the digits that the first
/// lacks.
struct FinePlace {
  Place high, low;
};

Place rounded(const FinePlace& place);

Json constant_acceleration_fields(const Json& inputs, const Place& end);
Json oscillator_fields(const Json& inputs, const Place& end);
Json damped_oscillator_fields(const Json& inputs, const Place& end);
Json pendulum_fields(const Json& inputs, const Place& end);
Json kepler_fields(const Json& inputs, const Place& end);

/// From the error of theta and omega at each step of the ladder.
Json convergence_fields(const Json& inputs, const std::vector<Place>& errors);

/// omega [rad/s] of an oscillator without its damper.
double frequency(const Json& inputs);

double oscillator_energy(const Json& inputs, const Place& at);

/// Relative to the start, about GM = 1.
double kepler_energy_error(const Json& inputs, const Place& at);

/// Of the ellipse about GM = a = 1: 0 <= e < 1.
double eccentricity(const Json& inputs);

}  // namespace timestep::truth
