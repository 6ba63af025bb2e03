// Chapters 1 to 3: points and rotating bodies, none of which touches another.
#include <numbers>

#include "study/problem.hpp"

namespace timestep::study {
namespace {

const char* const k_closed_form = "closed form";

// What Dormand and Prince's method holds its own estimate of the error to
Axis tolerances() {
  return {"tolerance", {1e-3, 1e-6, 1e-9, 1e-12}, {"dormand_prince"}};
}

}  // namespace

std::vector<Problem> particle_problems() {
  return {{.name = "projectile",
           .chapter = "01-particles",
           .scene = "projectile",
           .metric = "position_error_max",
           .exact = "closed form with drag that grows with the speed",
           .duration = 2.4,
           .dts = halved(0.4, 8),
           .settings = {{"linear_drag", 0.25}},
           .quick = true},
          {.name = "spring",
           .chapter = "01-particles",
           .scene = "spring",
           .metric = "position_error_max",
           .exact = k_closed_form,
           .duration = 10,
           .dts = halved(0.25, 8)},
          {.name = "fountain",
           .chapter = "01-particles",
           .scene = "fountain",
           .metric = "position_error_max",
           .exact = k_closed_form,
           .duration = 3,
           .dts = halved(1.0 / 15, 6),
           .settings = {{"particles", 1000}}},
          {.name = "frame-drops",
           .chapter = "01-particles",
           .scene = "frame-drops",
           .metric = "position_error_max",
           .exact = k_closed_form,
           .duration = 4,
           .dts = halved(1.0 / 30, 5)},
          {.name = "clock",
           .chapter = "01-particles",
           .scene = "clock",
           .metric = "clock_error",
           .exact = "steps times dt",
           .duration = 600,
           .dts = halved(1.0 / 15, 5)}};
}

namespace {

Problem rope_problem() {
  return {
      .name = "rope",
      .chapter = "02-verlet",
      .scene = "rope",
      .metric = "stretch_max",
      .exact = "a rope that keeps its length",
      .duration = 4,
      .dts = halved(1.0 / 30, 8),
      .axes = {{"iterations", {1, 4, 10, 40}, {"distance_constraints"}},
               {"stiffness",
                {1e3, 1e4, 1e5, 1e6},
                {"semi_implicit_euler", "velocity_verlet", "rk4", "implicit_euler"}}}};
}

}  // namespace

std::vector<Problem> verlet_problems() {
  const double year = 2 * std::numbers::pi;
  return {{.name = "oscillator",
           .chapter = "02-verlet",
           .scene = "oscillator",
           .metric = "state_error_max",
           .exact = k_closed_form,
           .duration = 60,
           .dts = halved(2, 8),
           .axes = {tolerances()},
           .quick = true},
          {.name = "damped-oscillator",
           .chapter = "02-verlet",
           .scene = "damped-oscillator",
           .metric = "state_error_max",
           .exact = k_closed_form,
           .duration = 8,
           .dts = halved(0.5, 7),
           .axes = {tolerances()}},
          {.name = "stiff-spring",
           .chapter = "02-verlet",
           .scene = "stiff-spring",
           .metric = "state_error_max",
           .exact = k_closed_form,
           .duration = 1,
           .dts = halved(1.0 / 30, 8),
           .axes = {tolerances()}},
          {.name = "pendulum",
           .chapter = "02-verlet",
           .scene = "pendulum",
           .metric = "state_error_max",
           .exact = "elliptic functions",
           .duration = 12,
           .dts = halved(0.1, 7),
           .axes = {tolerances()}},
          {.name = "orbit",
           .chapter = "02-verlet",
           .scene = "orbit",
           .metric = "position_error_max",
           .exact = "Kepler's equation",
           .duration = 10 * year,
           .dts = halved(0.25, 8),
           .axes = {tolerances()},
           .quick = true},
          {.name = "double-pendulum",
           .chapter = "02-verlet",
           .scene = "double-pendulum",
           .metric = "state_error_max",
           .exact = "Dormand and Prince's method at a tolerance of 1e-13",
           .duration = 4,
           .dts = halved(1.0 / 30, 7),
           .axes = {tolerances()}},
          rope_problem()};
}

namespace {

Problem rotation_problem(const char* scene, const char* metric, const char* exact,
                         double duration, double longest) {
  return {.name = scene,
          .chapter = "03-rigid-bodies",
          .scene = scene,
          .metric = metric,
          .exact = exact,
          .duration = duration,
          .dts = halved(longest, 6)};
}

}  // namespace

std::vector<Problem> rotation_problems() {
  const char* const attitude = "attitude_error_max";
  std::vector<Problem> all{
      rotation_problem("thrown-wrench", attitude, "elliptic functions", 0.6, 1.0 / 30),
      rotation_problem("torque-free", attitude, "elliptic functions", 10, 1.0 / 15),
      rotation_problem("dzhanibekov", attitude, "elliptic functions", 12, 1.0 / 15),
      rotation_problem("symmetric-top", attitude, k_closed_form, 5, 1.0 / 15),
      rotation_problem("heavy-top", attitude, "elliptic functions", 5, 1.0 / 60),
      rotation_problem("cue-strike", "position_error", k_closed_form, 0.8, 1.0 / 30),
      rotation_problem("spin-up", "angle_error", k_closed_form, 5, 1.0 / 15)};
  all[1].quick = true;
  return all;
}

}  // namespace timestep::study
