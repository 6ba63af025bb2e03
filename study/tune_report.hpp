/// @file
/// What a search found, in words and as JSON.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "study/tune.hpp"

namespace timestep::study {

/// The answer, how sure it is, how to run and to copy it, and what was tried, of that
/// at most `rows` lines. `unit` is that of the problem's metric.
std::string report(const Problem& problem, const Wish& wish, const Outcome& outcome,
                   const std::string& unit, std::size_t rows);

/// The same with everything that was tried.
nlohmann::ordered_json report_json(const Problem& problem, const Wish& wish,
                                   const Outcome& outcome, const std::string& unit);

}  // namespace timestep::study
