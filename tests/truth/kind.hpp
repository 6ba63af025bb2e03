/// @file
/// How the truth runner asks the engine: a kind of case is a function from a case's
/// inputs to what the engine computes for them.
#pragma once

#include <span>
#include <stdexcept>
#include <string_view>

#include <nlohmann/json.hpp>

#include "common/physics/precision.hpp"

namespace timestep::truth {

using Json = nlohmann::json;

/// What the engine computed, under the names of the case's `expected`.
/// `single_tolerance` has, by field, the error that single precision may cause, derived
/// from the case's conditioning and the unit round-off u = 2^-24; a field that is
/// missing there is computed in double (or bit-exactly) and keeps the case's own
/// tolerance.
struct Computed {
  Json fields = Json::object();
  Json single_tolerance = Json::object();
};

/// Thrown by a kind for a case that the engine does not cover, such as another method.
struct NotCovered : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Thrown by a kind for a case that names the other precision: its library answers.
struct OtherPrecision : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Kind {
  std::string_view name;
  Computed (*compute)(const Json& inputs);
};

}  // namespace timestep::truth

// The kinds that each chapter brings, from the library of either precision
namespace timestep {
namespace single_precision {
std::span<const truth::Kind> truth_kinds_01();
}
namespace double_precision {
std::span<const truth::Kind> truth_kinds_01();
}
}  // namespace timestep
