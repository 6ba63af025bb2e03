/// @file
/// Problems of chapter 2 as other libraries get them: a system of differential
/// equations, and what is exact.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>

#include "common/physics/exact.hpp"
#include "common/physics/exact_orbit.hpp"
#include "study/peers/peers.hpp"

namespace timestep::study {

/// Of n coordinates: their accelerations, the start, and the error of x and v at a
/// time, as the scene's metric has it.
template <std::size_t n>
struct System {
  using Half = std::array<double, n>;
  std::function<void(const Half& x, Half& a)> acceleration;
  Half x{}, v{};
  std::function<double(double t, const Half& x, const Half& v)> error;
};

/// The distance in the phase plane, in amplitudes.
inline System<1> oscillator_system(const std::map<std::string, double>& p) {
  const double k = p.at("stiffness") / p.at("mass"), omega = std::sqrt(k);
  const exact::Coordinate start{p.at("stretch"), p.at("speed")};
  const double amplitude = std::hypot(start.x, start.v / omega);
  return {[k](const auto& x, auto& a) { a[0] = -k * x[0]; },
          {start.x},
          {start.v},
          [=](double t, const auto& x, const auto& v) {
            const exact::Coordinate now = exact::oscillator(start, omega, 0, t);
            return std::hypot(x[0] - now.x, (v[0] - now.v) / omega) / amplitude;
          }};
}

/// The distance from the planet's place, in semi-major axes.
inline System<3> orbit_system(const std::map<std::string, double>& p) {
  const double mu = p.at("gm"), axis = p.at("semi_major_axis");
  const double e = p.at("eccentricity");
  const exact::Motion start = exact::orbit(mu, axis, e, 0);
  return {[mu](const auto& x, auto& a) {
            const double r2 = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
            const double scale = -mu / (r2 * std::sqrt(r2));
            for (std::size_t i = 0; i < 3; ++i) a[i] = scale * x[i];
          },
          {start.x.x, start.x.y, start.x.z},
          {start.v.x, start.v.y, start.v.z},
          [=](double t, const auto& x, const auto&) {
            const glm::dvec3 now = exact::orbit(mu, axis, e, t).x;
            return glm::distance(now, glm::dvec3(x[0], x[1], x[2])) / axis;
          }};
}

/// A stepper at work on a system. `Stepper(system, dt)` has step(t), x() and v(), and
/// calls the system's acceleration.
template <std::size_t n, class Stepper>
class SystemRun : public PeerRun {
 public:
  SystemRun(const System<n>& system, double dt, auto... more)
      : system_(system), dt_(dt), stepper_(counted(system, *calls_), dt, more...) {}

  void step() override { stepper_.step(static_cast<double>(steps_++) * dt_); }
  void observe() override {
    const double t = static_cast<double>(steps_) * dt_;
    error_ = std::max(error_, system_.error(t, stepper_.x(), stepper_.v()));
    if (!std::isfinite(stepper_.x()[0])) error_ = stepper_.x()[0];
  }
  double error() const override { return error_; }
  long long evaluations() const override { return *calls_; }
  long long bodies() const override { return 1; }

 private:
  static System<n> counted(System<n> system, long long& calls) {
    system.acceleration = [a = system.acceleration, &calls](const auto& x, auto& out) {
      ++calls;
      a(x, out);
    };
    return system;
  }

  System<n> system_;
  double dt_;
  std::unique_ptr<long long> calls_ = std::make_unique<long long>(0);
  Stepper stepper_;
  long long steps_ = 0;
  double error_ = 0;
};

/// Of either scene by either width of a stepper; null for other problems.
template <template <std::size_t> class Stepper>
std::unique_ptr<PeerRun> start_system(const PeerSetup& setup, auto... more) {
  const Problem& problem = *setup.problem;
  const auto start = [&]<std::size_t n>(const System<n>& system) {
    return std::make_unique<SystemRun<n, Stepper<n>>>(system, setup.dt, more...);
  };
  if (problem.scene == "oscillator" && problem.metric == "state_error_max")
    return start(oscillator_system(setup.parameters));
  if (problem.scene == "orbit" && problem.metric == "position_error_max")
    return start(orbit_system(setup.parameters));
  return nullptr;
}

}  // namespace timestep::study
