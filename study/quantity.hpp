/// @file
/// Numbers with units, as people type them: `1mm`, `0.1%`, `2deg`, `50us`.
#pragma once

#include <string>
#include <string_view>

namespace timestep::study {

/// A positive number in `unit`, from text with a unit of the same kind, or none. Throws
/// InputError, in one line that begins with `option` and says which units fit, for
/// anything else. `unit` is as metrics have it: m, rad, m/s, s, J, sizes, none, …; or
/// us.
double parse_quantity(std::string_view option, std::string_view text,
                      std::string_view unit);

/// The same for the eye: four digits, with a prefix where the unit takes one (`1.2
/// mm`).
std::string quantity_text(double value, std::string_view unit);

}  // namespace timestep::study
