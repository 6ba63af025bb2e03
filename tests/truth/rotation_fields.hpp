/// @file
/// What truth cases expect of a body that turns without torque, as a function of where
/// it ends: computed in double, so that it adds no rounding to the run's own. A place
/// here is an orientation w, x, y, z in x, and an angular velocity (body frame) in v.
#pragma once

#include <glm/gtc/quaternion.hpp>

#include "tests/truth/fields.hpp"

namespace timestep::truth {

/// Four numbers w, x, y, z.
glm::dquat quaternion(const Json& inputs, const char* name);

Json rotation_fields(const Json& inputs, const Place& end);
Json listing3_fields(const Json& inputs, const Place& end);
Json gyro_fields(const Json& inputs, const Place& end);
Json quaternion_drift_fields(const Json& inputs, const Place& end);

/// What the first step of a quaternion_drift case, from q = 1, says of all of them.
Json turned_by_steps(const Json& inputs, const Place& first);

/// (3.36) The angle [rad] from the exact attitude of a rotation_order case.
double attitude_error(const Json& inputs, const Place& end);

/// From the attitude errors at each step of the ladder.
Json rotation_order_fields(const Json& inputs, const std::vector<double>& errors);

/// (3.15) The energy over that of the start.
double energy_ratio(const Json& inputs, const Place& at);

}  // namespace timestep::truth
