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

/// Thrown by a kind for a case that the engine does not cover, such as another method.
struct NotCovered : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Thrown by a kind for a case that names the other precision: its library answers.
struct OtherPrecision : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A kind of case, and from a case's inputs an object with numbers, lists of them, or
/// words, under the names of the case's `expected`.
struct Kind {
  std::string_view name;
  Json (*compute)(const Json& inputs);

  /// Of a kind whose answers cannot be compared field by field, such as one of several
  /// right directions: {"expected", "tol"} as they are to be compared with what was
  /// computed.
  Json (*restate)(const Json& test, const Json& computed) = nullptr;
};

}  // namespace timestep::truth

// The kinds that each chapter brings, from the library of either precision
namespace timestep {
namespace single_precision {
std::span<const truth::Kind> truth_kinds_01();
std::span<const truth::Kind> truth_kinds_02();
std::span<const truth::Kind> truth_kinds_02_motions();
std::span<const truth::Kind> truth_kinds_03_exact();
std::span<const truth::Kind> truth_kinds_03_mass();
std::span<const truth::Kind> truth_kinds_03_rotation();
std::span<const truth::Kind> truth_kinds_04();
std::span<const truth::Kind> truth_kinds_06();
std::span<const truth::Kind> truth_kinds_06_exact();
std::span<const truth::Kind> truth_kinds_06_motions();
}  // namespace single_precision
namespace double_precision {
std::span<const truth::Kind> truth_kinds_01();
std::span<const truth::Kind> truth_kinds_02();
std::span<const truth::Kind> truth_kinds_02_motions();
std::span<const truth::Kind> truth_kinds_03_exact();
std::span<const truth::Kind> truth_kinds_03_mass();
std::span<const truth::Kind> truth_kinds_03_rotation();
std::span<const truth::Kind> truth_kinds_04();
std::span<const truth::Kind> truth_kinds_06();
std::span<const truth::Kind> truth_kinds_06_exact();
std::span<const truth::Kind> truth_kinds_06_motions();
}  // namespace double_precision
}  // namespace timestep

namespace timestep::truth {

/// By kind, the errors that single precision may cause in a case's fields, in their
/// shape: derived from the case's conditioning and the unit round-off u = 2^-24. What
/// is missing there is computed in double (or bit-exactly) and keeps the case's own
/// tolerance.
std::span<const Kind> single_tolerances();
std::span<const Kind> single_tolerances_03_mass();
std::span<const Kind> single_tolerances_03_rotation();
std::span<const Kind> single_tolerances_06();

}  // namespace timestep::truth
