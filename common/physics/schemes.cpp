#include "common/physics/schemes.hpp"

#include <algorithm>
#include <array>

#include "common/physics/euler.hpp"
#include "common/physics/implicit.hpp"
#include "common/physics/runge_kutta.hpp"
#include "common/physics/verlet.hpp"
#include "common/physics/verlet_drag.hpp"
#include "common/physics/yoshida.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

// A method of chapter 1's form, which needs no stages
template <Integrator step>
void plain(State& state, std::span<State>, const Acceleration& acceleration, Real t,
           Real dt) {
  step(state, acceleration, t, dt);
}

constexpr std::array<Scheme, 18> k_schemes{{
    {.name = "explicit_euler",
     .summary = "position with the old velocity",
     .step = plain<explicit_euler>,
     .evaluations = 1,
     .order = 1},
    {.name = "semi_implicit_euler",
     .summary = "position with the new velocity",
     .step = plain<semi_implicit_euler>,
     .evaluations = 1,
     .order = 1,
     .symplectic = true},
    {.name = "modified_euler",
     .summary = "explicit Euler with the term a dt²/2",
     .step = plain<modified_euler>,
     .evaluations = 1,
     .order = 1},
    {.name = "stormer_verlet",
     .summary = "position from the last two positions",
     .step = stormer_verlet,
     .evaluations = 1,
     .order = 2,
     .symplectic = true,
     .reversible = true,
     .stages = 1,
     .start = stormer_start,
     .read = half_kick},
    {.name = "velocity_verlet",
     .summary = "half a kick, a drift, half a kick",
     .step = plain<velocity_verlet>,
     .evaluations = 1,
     .order = 2,
     .symplectic = true,
     .reversible = true,
     .start = evaluate},
    {.name = "leapfrog",
     .summary = "velocities half a step behind the positions",
     .step = plain<kick_drift>,
     .evaluations = 1,
     .order = 2,
     .symplectic = true,
     .reversible = true,
     .start = leapfrog_start,
     .read = half_kick},
    {.name = "midpoint",
     .summary = "a step with the rates half-way",
     .step = midpoint,
     .evaluations = 2,
     .order = 2,
     .stages = 1},
    {.name = "rk4",
     .summary = "the classical Runge-Kutta method",
     .step = rk4,
     .evaluations = 4,
     .order = 4,
     .stages = 3},
    {.name = "position_verlet",
     .summary = "half a drift, a kick, half a drift",
     .step = plain<position_verlet>,
     .evaluations = 1,
     .order = 2,
     .symplectic = true,
     .reversible = true},
    {.name = "semi_implicit_euler_drift_kick",
     .summary = "position first, then velocity",
     .step = plain<semi_implicit_euler_drift_kick>,
     .evaluations = 1,
     .order = 1,
     .symplectic = true},
    {.name = "heun",
     .summary = "the mean of the rates at both ends",
     .step = heun,
     .evaluations = 2,
     .order = 2,
     .stages = 1},
    {.name = "yoshida4_kdk",
     .summary = "three velocity Verlets, the middle one back",
     .step = plain<yoshida4_kdk>,
     .evaluations = 3,
     .order = 4,
     .symplectic = true,
     .reversible = true,
     .start = evaluate},
    {.name = "yoshida4_dkd",
     .summary = "three position Verlets, the middle one back",
     .step = plain<yoshida4_dkd>,
     .evaluations = 3,
     .order = 4,
     .symplectic = true,
     .reversible = true},
    {.name = "dopri5",
     .summary = "Dormand and Prince, fifth order, fixed step",
     .step = dopri5,
     .evaluations = 6,
     .order = 5,
     .stages = 7,
     .start = evaluate},
    {.name = "implicit_euler",
     .summary = "the rates at the end",
     .step = plain<implicit_euler>,
     .evaluations = 0,
     .order = 1},
    {.name = "implicit_midpoint",
     .summary = "the rates in the middle, solved for",
     .step = plain<implicit_midpoint>,
     .evaluations = 0,
     .order = 2,
     .symplectic = true,
     .reversible = true},
    {.name = "implicit_trapezoid",
     .summary = "the mean of the rates at both ends, solved for",
     .step = plain<implicit_trapezoid>,
     .evaluations = 0,
     .order = 2,
     .reversible = true},
    {.name = "stormer_verlet_naive_start",
     .summary = "Störmer-Verlet, started at x - v dt",
     .step = stormer_verlet,
     .evaluations = 1,
     .order = 1,
     .symplectic = true,
     .stages = 1,
     .start = stormer_naive_start,
     .read = half_kick},
}};

constexpr std::array<Scheme, 5> k_drag_schemes{{
    {.name = "verlet_lagged",
     .summary = "velocity Verlet, drag from the velocity at the start",
     .step = verlet_lagged,
     .evaluations = 2,
     .order = 1,
     .stages = 1},
    {.name = "verlet_half",
     .summary = "velocity Verlet, drag from the velocity half-way",
     .step = plain<verlet_half>,
     .evaluations = 2,
     .order = 1},
    {.name = "verlet_predicted",
     .summary = "velocity Verlet, drag from a predicted velocity",
     .step = verlet_predicted,
     .evaluations = 2,
     .order = 2,
     .stages = 1},
    {.name = "verlet_implicit",
     .summary = "velocity Verlet, drag from the velocity at the end",
     .step = plain<verlet_implicit>,
     .evaluations = 0,
     .order = 2},
    {.name = "semi_implicit_implicit_drag",
     .summary = "semi-implicit Euler, drag from the new velocity",
     .step = plain<semi_implicit_implicit_drag>,
     .evaluations = 0,
     .order = 1},
}};

}  // namespace

std::span<const Scheme> schemes() {
  return k_schemes;
}

std::span<const Scheme> drag_schemes() {
  return k_drag_schemes;
}

const Scheme* find_scheme(std::string_view name) {
  for (const std::span<const Scheme> list : {schemes(), drag_schemes()}) {
    const auto found = std::ranges::find(list, name, &Scheme::name);
    if (found != list.end()) return &*found;
  }
  return nullptr;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
