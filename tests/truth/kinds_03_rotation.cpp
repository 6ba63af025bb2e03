// The kinds of chapter 3 about methods that turn a body, computed through the code in
// common/physics.
#include <algorithm>
#include <array>
#include <cmath>

#include "tests/truth/inputs.hpp"
#include "tests/truth/rotation_fields.hpp"
#include "tests/truth/rotation_runs.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using truth::Json;
using truth::Kind;

Json rotation_steps(const Json& inputs) {
  const RotationRun run = rotation_run(inputs);
  Rotation now = run.start;
  double worst = 0;
  for (long long i = 0; i < run.n; ++i) {
    advance(run, now);
    const double error = truth::energy_ratio(inputs, place_of(now)) - 1;
    worst = std::max(worst, std::abs(error));
  }
  Json fields = truth::rotation_fields(inputs, place_of(now));
  fields["energy_relative_error_max"] = worst;
  return fields;
}

Json rotation_order(const Json& inputs) {
  std::vector<double> errors;
  for (const long long n : truth::ladder(inputs)) {
    const Rotation end = end_of(rotation_order_run(inputs, n));
    errors.push_back(truth::attitude_error(inputs, place_of(end)));
  }
  Json fields = truth::rotation_order_fields(inputs, errors);
  fields["theoretical_order"] = rotation_method_of(inputs).order;
  return fields;
}

// The first steps after which the energy has doubled, and has halved; as many steps as
// the energy stays a number
Json gyro_steps(const Json& inputs) {
  const RotationRun run = gyro_run(inputs);
  Json doubled, halved;
  Rotation now = run.start;
  long long done = 0;
  for (; done < run.n; ++done) {
    Rotation next = now;
    advance(run, next);
    const double ratio = truth::energy_ratio(inputs, place_of(next));
    if (!std::isfinite(ratio)) break;
    now = next;
    if (doubled.is_null() && ratio >= 2) doubled = done + 1;
    if (halved.is_null() && ratio <= 0.5) halved = done + 1;
  }
  Json fields = truth::gyro_fields(inputs, place_of(now));
  fields["steps_done"] = done;
  fields["first_step_with_double_energy"] = doubled;
  fields["first_step_with_half_energy"] = halved;
  return fields;
}

Json listing3_error(const Json& inputs) {
  return truth::listing3_fields(inputs, place_of(end_of(listing3_run(inputs))));
}

Json quaternion_drift(const Json& inputs) {
  RotationRun run = quaternion_drift_run(inputs);
  Json fields = truth::quaternion_drift_fields(inputs, place_of(end_of(run)));
  run.n = 1;
  fields.update(truth::turned_by_steps(inputs, place_of(end_of(run))));
  return fields;
}

}  // namespace

std::span<const Kind> truth_kinds_03_rotation() {
  static constexpr std::array<Kind, 5> kinds{{
      {"rotation_steps", rotation_steps},
      {"rotation_order", rotation_order},
      {"gyro_steps", gyro_steps},
      {"listing3_error", listing3_error},
      {"quaternion_drift", quaternion_drift},
  }};
  return kinds;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
