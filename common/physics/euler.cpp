#include "common/physics/euler.hpp"

#include <array>
#include <cstddef>

namespace timestep::inline TIMESTEP_PRECISION {

void explicit_euler(State& state, const Acceleration& acceleration, Real t, Real dt) {
  auto& [x, v, a] = state;
  acceleration(x, v, t, a);

  // (1.3) The old velocity moves the position
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] += v[i] * dt;
    v[i] += a[i] * dt;
  }
}

void semi_implicit_euler(State& state, const Acceleration& acceleration, Real t,
                         Real dt) {
  auto& [x, v, a] = state;
  acceleration(x, v, t, a);

  // (1.4) The new velocity moves the position
  for (std::size_t i = 0; i < x.size(); ++i) {
    v[i] += a[i] * dt;
    x[i] += v[i] * dt;
  }
}

void modified_euler(State& state, const Acceleration& acceleration, Real t, Real dt) {
  auto& [x, v, a] = state;
  acceleration(x, v, t, a);

  // (1.5) The old velocity moves the position, and so does the acceleration
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] += v[i] * dt + a[i] * dt * dt / 2;
    v[i] += a[i] * dt;
  }
}

std::span<const NamedIntegrator> euler_methods() {
  static constexpr std::array<NamedIntegrator, 3> methods{{
      {"explicit_euler", explicit_euler, 1},
      {"semi_implicit_euler", semi_implicit_euler, 1},
      {"modified_euler", modified_euler, 1},
  }};
  return methods;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
