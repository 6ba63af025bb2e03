// Every case of the truth files, in both precisions, through the same function as
// bin/truth.
#include <algorithm>
#include <array>

#include "tests/catch.hpp"
#include "tests/truth/runner.hpp"

using namespace timestep::truth;

namespace {

const std::filesystem::path k_folder = TIMESTEP_TRUTH;

constexpr std::array k_covered{"constant_acceleration_steps",
                               "linear_drag_projectile",
                               "quadratic_drag_fall",
                               "oscillator_steps",
                               "growth_factor",
                               "time_accumulation",
                               "float_spacing",
                               "free_fall_float32",
                               "oscillator_invariant",
                               "stability_limit",
                               "damped_oscillator_steps",
                               "pendulum_exact",
                               "pendulum_steps",
                               "convergence_order",
                               "kepler_exact",
                               "kepler_steps",
                               "double_pendulum_reference",
                               "spring_two_body",
                               "asymmetric_top_free",
                               "symmetric_top_free",
                               "flip_period",
                               "heavy_top_steady",
                               "heavy_top_motion",
                               "cue_strike",
                               "inertia_primitive",
                               "mesh_mass_properties",
                               "rotation_steps",
                               "rotation_order",
                               "gyro_steps",
                               "listing3_error",
                               "quaternion_drift",
                               "geom_sphere_sphere",
                               "geom_sphere_box",
                               "geom_capsule_capsule",
                               "geom_capsule_box",
                               "geom_plane",
                               "geom_sphere_cylinder",
                               "geom_cylinder_box",
                               "convex_pair",
                               "shape_pair",
                               "bouncing_ball",
                               "stacked_drop",
                               "newton_cradle",
                               "simultaneous_line_impact",
                               "penalty_bounce",
                               "disc_collision",
                               "sphere_bounce",
                               "slide_to_roll",
                               "box_edge_catch",
                               "incline_block",
                               "incline_box_regime",
                               "rolling_incline",
                               "friction_cone_vs_pyramid",
                               "book_overhang",
                               "sphere_leaves_sphere",
                               "ball_in_bowl",
                               "simbenchmark_rolling",
                               "falling_rod",
                               "falling_rod_frictionless",
                               "painleve_rod",
                               "rocking_block",
                               "two_body_impulse",
                               "baumgarte_resting",
                               "soft_contact_coefficients",
                               "pgs_stack"};

// All cases pass; of the kinds above none is left out but as many as are told.
void check(Precision precision, int left_out) {
  const Report report =
      run_cases({k_folder / "truth_public.json", k_folder / "geometry_public.json",
                 k_folder / "robustness_public.json"},
                "", precision);
  for (const Outcome& outcome : report.outcomes) {
    INFO(outcome.id << ": " << outcome.failure);
    CHECK(outcome.pass);
    CHECK(outcome.fields_not_computed == 0);
  }
  int not_covered = 0;
  for (const char* kind : k_covered) {
    INFO(kind);
    const auto found =
        std::ranges::find(report.kinds, kind, &std::pair<std::string, Tally>::first);
    REQUIRE(found != report.kinds.end());
    CHECK(found->second.passed > 0);
    not_covered += found->second.not_covered;
  }
  CHECK(not_covered == left_out);
}

}  // namespace

TEST_CASE("truth files pass in double") {
  check(Precision::double_bits, 0);
}

// Three oscillators that blow up leave the range of a float.
TEST_CASE("truth files pass in single with derived tolerances") {
  check(Precision::single_bits, 3);
}
