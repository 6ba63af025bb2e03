/// @file
/// The numbers of a run as JSON. Doubles are written with the digits that read back to
/// the same bits; JSON has no word for what is not finite, so such a number is written
/// as one of the strings "nan", "inf" and "-inf". Keys stand in a fixed order, and all
/// but `cost` is the same, bit for bit, whenever the same options are run again.
#pragma once

#include <span>
#include <string>

#include "common/chapter/runner.hpp"

namespace timestep {

/// What results.json holds: chapter, scene, method, precision, preset, mesh,
/// fix_winding, dt, duration, steps, time, parameters, state (an array of bodies),
/// metrics (name: value and unit), notices (only if a scene has any), failed (step,
/// time, what; only if a number ceased to be finite or a step could not be taken) and
/// cost.
///
/// With several methods, `method` names them with commas between, and every name inside
/// state, metrics, failed and cost has its method before it, as in "verlet/energy";
/// cost then has the sums under the plain names as well.
std::string results_json(const Plan& plan, std::span<const Lane> lanes);

/// "method/" if several run, else nothing: what goes before a name of this lane.
std::string lane_prefix(std::span<const Lane> lanes, const Lane& lane);

}  // namespace timestep
