/// @file
/// Numbers as text: read strictly, written so that they read back to the same bits.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace timestep {

/// A finite number: `-2`, `1e-3`, or a fraction of two such as `1/60`. The whole text
/// must be the number. Nothing for anything else: words, NaN, infinity, overflow, x/0.
std::optional<double> parse_number(std::string_view text);

/// A whole number from `minimum` to `maximum`; nothing for anything else.
std::optional<int> parse_integer(std::string_view text, int minimum, int maximum);

/// The shortest text that reads back to the same bits; nan, inf, -inf as such.
std::string exact_text(double value);

/// Six significant digits where they are exact, as in 1e+06; else as `exact_text`.
std::string plain_text(double value);

/// Four significant digits, for the reader's eye.
std::string short_text(double value);

/// A time step as people say it: `1/60 s` where that is exact, else `0.01 s`.
std::string step_text(double dt);

}  // namespace timestep
