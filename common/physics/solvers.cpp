#include "common/physics/solvers.hpp"

#include <array>

#include "common/physics/contact_phases.hpp"
#include "common/physics/lcp.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

// (6.11) So many sweeps; more where something bounces, and again for what those bounces
// lead to
void resolve_velocities(const SolverStep& step, int sweeps, bool bounces, Real h) {
  const SolverSettings& settings = step.settings;
  const int of_impact = sweeps + settings.impact_iterations;
  for (int i = 0; i < (bounces ? of_impact : sweeps); ++i)
    sweep(step.room, settings.use_pyramid);
  for (int round = 1; bounces && round < settings.impact_rounds; ++round) {
    bounces = bounce_on(step.room, settings, h);
    for (int i = 0; bounces && i < of_impact; ++i)
      sweep(step.room, settings.use_pyramid);
  }
}

// A step with contacts that do not give: out of penetrations first; then the impulses
// that `start` sets, and sweeps, half-way through
void with_hard_contacts(const SolverStep& step, void (*start)(SolverRoom& room)) {
  SolverRoom& room = step.room;
  const Real dt = step.dt;
  step.out_of_penetration.step(step.bodies, step.contacts, step.penetration, dt,
                               step.penetration_room);
  prepare(step.bodies, step.contacts, step.settings, room);
  const bool bounces = look_ahead(room, step.settings, {}, dt);
  move(room.bodies, dt / 2);
  accelerate(room.bodies, dt);
  start(room);
  resolve_velocities(step, step.settings.iterations, bounces, dt);
  move(room.bodies, dt / 2);
  correct_for_time(room, dt);
  finish(room, dt, step.bodies, step.contacts);
}

}  // namespace

void sequential_impulses(const SolverStep& step) {
  with_hard_contacts(step, warm_start);
}

void substeps(const SolverStep& step) {
  const SolverSettings& settings = step.settings;
  SolverRoom& room = step.room;
  const Real h = step.dt / Real(settings.substeps);
  const SoftCoefficients soft =
      soft_contact(settings.contact_frequency / h, settings.damping_ratio, h);

  prepare(step.bodies, step.contacts, settings, room);
  bool keeps_impulses = false;
  for (int i = 0; i < settings.substeps; ++i) {
    const bool bounces = look_ahead(room, settings, soft, h);
    move(room.bodies, h / 2);
    if (keeps_impulses) {
      accelerate_again(room.bodies, h);
    } else {
      accelerate(room.bodies, h);
      warm_start(room);
    }
    keeps_impulses = !bounces;
    resolve_velocities(step, 1, bounces, h);
    move(room.bodies, h / 2);
    correct_for_time(room, h);
    relax(room.rows);
    sweep(room, settings.use_pyramid);
  }
  finish(room, step.dt, step.bodies, step.contacts);
}

void direct(const SolverStep& step) {
  with_hard_contacts(step, [](SolverRoom& room) {
    if (!solve_directly(room)) warm_start(room);
  });
}

std::span<const Solver> solvers() {
  static constexpr std::array<Solver, 4> k_solvers{{
      {"worst_first", "impacts one by one, the fastest first: the thesis's",
       worst_first},
      {"sequential_impulses", "sweeps with accumulated impulses, warm started",
       sequential_impulses},
      {"substeps", "short steps with soft contacts, one sweep each", substeps},
      {"lcp", "all at once, by Lemke's method: small scenes", direct},
  }};
  return k_solvers;
}

const Solver* find_solver(std::string_view name) {
  for (const Solver& solver : solvers())
    if (solver.name == name) return &solver;
  return nullptr;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
