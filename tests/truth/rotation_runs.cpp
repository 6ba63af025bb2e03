#include "tests/truth/rotation_runs.hpp"

#include <array>
#include <string>
#include <utility>

#include "common/graphics/input_error.hpp"
#include "common/physics/gyroscopic.hpp"
#include "common/physics/rotations.hpp"
#include "tests/truth/inputs.hpp"
#include "tests/truth/rotation_fields.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

using truth::Json;
using truth::Place;

namespace {

Vec3 inertia(const Json& inputs) {
  const Vec3 I(truth::vector(inputs, "inertia"));
  if (!(std::min({I.x, I.y, I.z}) > 0)) throw InputError("inertia: must be above 0");
  return I;
}

Rotation start(const Json& inputs) {
  return {Quat(truth::quaternion(inputs, "q0")),
          Vec3(truth::vector(inputs, "omega_body0"))};
}

// Newton's method has converged long before
constexpr int k_converged = 20;

constexpr std::array<RotationMethod, 4> k_gyro_schemes{{
    {.name = "explicit",
     .summary = "(3.17)",
     .step = [](Rotation& r, const Vec3& I, const Torque&, Real,
                Real dt) { r.omega += dt * euler_equations(r.omega, I, Vec3(0)); },
     .evaluations = 0,
     .order = 1},
    {.name = "implicit_one_newton",
     .summary = "(3.18)",
     .step = [](Rotation& r, const Vec3& I, const Torque&, Real,
                Real dt) { r.omega = implicit_gyroscopic_velocity(r.omega, I, dt, 1); },
     .evaluations = 0,
     .order = 1},
    {.name = "implicit_converged",
     .summary = "(3.18), solved",
     .step =
         [](Rotation& r, const Vec3& I, const Torque&, Real, Real dt) {
           r.omega = implicit_gyroscopic_velocity(r.omega, I, dt, k_converged);
         },
     .evaluations = 0,
     .order = 1},
    {.name = "explicit_rescaled_L",
     .summary = "(3.20)",
     .step = [](Rotation& r, const Vec3& I, const Torque&, Real,
                Real dt) { r.omega = rescaled_velocity(r.omega, I, dt); },
     .evaluations = 0,
     .order = 1},
}};

}  // namespace

RotationMethod rotation_method_of(const Json& inputs) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 8> renamed{{
      {"listing3_constant_world_omega", "constant_omega"},
      {"euler_keep_L", "momentum"},
      {"explicit_gyro_quat_euler", "explicit_gyroscopic"},
      {"catto_implicit_gyro", "implicit_gyroscopic"},
      {"rk4_quaternion", "rk4"},
      {"splitting_12321", "splitting"},
      {"lie_midpoint_implicit", "lie_midpoint"},
      {"buss_augmented_second_order", "buss"},
  }};
  auto name = inputs.at("method").get<std::string>();
  for (const auto& [theirs, ours] : renamed)
    if (name == theirs) name = ours;
  const RotationMethod* method = find_rotation_method(name);
  if (!method) throw truth::NotCovered("method " + name);
  return *method;
}

RotationRun rotation_run(const Json& inputs) {
  return {.method = rotation_method_of(inputs),
          .I = inertia(inputs),
          .start = start(inputs),
          .dt = Real(truth::number(inputs, "dt")),
          .n = truth::steps(inputs)};
}

RotationRun rotation_order_run(const Json& inputs, long long n) {
  return {.method = rotation_method_of(inputs),
          .I = inertia(inputs),
          .start = start(inputs),
          .dt = Real(truth::positive(inputs, "T") / static_cast<double>(n)),
          .n = n};
}

RotationRun listing3_run(const Json& inputs) {
  return {.method = *find_rotation_method("constant_omega"),
          .I = inertia(inputs),
          .start = start(inputs),
          .dt = Real(truth::number(inputs, "t")),
          .n = 1};
}

RotationRun gyro_run(const Json& inputs) {
  const auto name = inputs.at("scheme").get<std::string>();
  for (const RotationMethod& method : k_gyro_schemes)
    if (method.name == name)
      return {.method = method,
              .I = inertia(inputs),
              .start = {.omega = Vec3(truth::vector(inputs, "omega_body0"))},
              .dt = Real(truth::number(inputs, "dt")),
              .n = truth::steps(inputs)};
  throw truth::NotCovered("scheme " + name);
}

RotationRun quaternion_drift_run(const Json& inputs) {
  const RotationMethod drift{
      .name = "add_and_normalise",
      .summary = "(3.4)",
      .step = [](Rotation& r, const Vec3&, const Torque&, Real,
                 Real dt) { r.q = add_and_normalise(r.q, r.omega, dt); },
      .evaluations = 0,
      .order = 2};
  return {.method = drift,
          .I = Vec3(1),
          .start = {.omega = Vec3(truth::vector(inputs, "omega"))},
          .dt = Real(truth::number(inputs, "dt")),
          .n = truth::steps(inputs)};
}

void advance(const RotationRun& run, Rotation& r) {
  static const Torque none = [](const Quat&, Real) { return Vec3(0); };
  try {
    run.method.step(r, run.I, none, 0, run.dt);
  } catch (const Unsolved& refused) {
    throw truth::NotCovered(refused.what());
  }
}

Rotation end_of(const RotationRun& run) {
  Rotation r = run.start;
  for (long long i = 0; i < run.n; ++i) advance(run, r);
  return r;
}

Place place_of(const Rotation& r) {
  return {{r.q.w, r.q.x, r.q.y, r.q.z}, {r.omega.x, r.omega.y, r.omega.z}};
}

Rotation rotation_of(const Place& place) {
  const auto x = [&](std::size_t i) { return Real(place.x[i]); };
  const auto v = [&](std::size_t i) { return Real(place.v[i]); };
  return {Quat(x(0), x(1), x(2), x(3)), Vec3(v(0), v(1), v(2))};
}

}  // namespace timestep::inline TIMESTEP_PRECISION
