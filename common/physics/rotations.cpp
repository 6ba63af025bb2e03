#include "common/physics/rotations.hpp"

#include <algorithm>
#include <array>

#include "common/physics/gyroscopic.hpp"
#include "common/physics/rotation_momentum.hpp"
#include "common/physics/rotation_runge_kutta.hpp"
#include "common/physics/rotor_splitting.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

constexpr std::array<RotationMethod, 16> k_methods{{
    {.name = "listing_3",
     .summary = "the thesis: no gyroscopic term, add and normalise",
     .step = listing_3,
     .evaluations = 1,
     .order = 0,
     .keeps_energy = true},
    {.name = "constant_omega",
     .summary = "no gyroscopic term, exponential map",
     .step = constant_omega,
     .evaluations = 1,
     .order = 0,
     .keeps_energy = true},
    {.name = "explicit_gyroscopic",
     .summary = "gyroscopic term at the start of the step",
     .step = explicit_gyroscopic,
     .evaluations = 1,
     .order = 1},
    {.name = "implicit_gyroscopic",
     .summary = "gyroscopic term at the end, one Newton step: Bullet, Box3D",
     .step = implicit_gyroscopic,
     .evaluations = 1,
     .order = 1},
    {.name = "explicit_rescaled_L",
     .summary = "gyroscopic term at the start, |L| put back: Jolt",
     .step = explicit_rescaled,
     .evaluations = 1,
     .order = 1},
    {.name = "momentum",
     .summary = "keep L, turn with the velocity at the start",
     .step = momentum,
     .evaluations = 1,
     .order = 1,
     .keeps_momentum = true},
    {.name = "buss_second_order",
     .summary = "keep L, turn with the velocity expected half-way",
     .step = buss_second_order,
     .evaluations = 3,
     .order = 2,
     .keeps_momentum = true},
    {.name = "buss",
     .summary = "the same, with Buss's term for the turning axis",
     .step = buss,
     .evaluations = 3,
     .order = 2,
     .keeps_momentum = true},
    {.name = "explicit_midpoint_su2",
     .summary = "midpoint method, exponential map",
     .step = explicit_midpoint_su2,
     .evaluations = 2,
     .order = 2},
    {.name = "lie_midpoint",
     .summary = "keep L, turn with the velocity half-way through the turn",
     .step = lie_midpoint,
     .evaluations = 2,
     .order = 2,
     .keeps_momentum = true,
     .reversible = true},
    {.name = "splitting",
     .summary = "keep L, turn about one principal axis after the other",
     .step = splitting,
     .evaluations = 2,
     .order = 2,
     .keeps_momentum = true,
     .reversible = true,
     .symplectic = true},
    {.name = "discrete_moser_veselov",
     .summary = "a discrete body that keeps L and the energy",
     .step = discrete_moser_veselov,
     .evaluations = 2,
     .order = 2,
     .keeps_momentum = true,
     .keeps_energy = true,
     .reversible = true,
     .symplectic = true},
    {.name = "rotor_splitting",
     .summary = "keep L, turn as a ball does, then by what two axes differ from it",
     .step = rotor_splitting,
     .evaluations = 2,
     .order = 2,
     .keeps_momentum = true,
     .reversible = true,
     .symplectic = true},
    {.name = "rotor_splitting_4",
     .summary = "five of these, one of them backwards",
     .step = rotor_splitting_4,
     .evaluations = 10,
     .order = 4,
     .keeps_momentum = true,
     .reversible = true,
     .symplectic = true},
    {.name = "rk4",
     .summary = "Runge-Kutta on orientation and velocity",
     .step = rk4,
     .evaluations = 4,
     .order = 4},
    {.name = "rkmk4",
     .summary = "Runge-Kutta on the turn of the step, keeps L",
     .step = rkmk4,
     .evaluations = 4,
     .order = 4,
     .keeps_momentum = true},
}};

}  // namespace

std::span<const RotationMethod> rotation_methods() {
  return k_methods;
}

const RotationMethod* find_rotation_method(std::string_view name) {
  const auto found = std::ranges::find(rotation_methods(), name, &RotationMethod::name);
  return found == rotation_methods().end() ? nullptr : &*found;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
