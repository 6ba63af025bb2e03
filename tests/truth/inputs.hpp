/// @file
/// A truth case's inputs, read with care: what is missing, of another type or out of
/// range is an InputError that names it.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "tests/truth/kind.hpp"

namespace timestep::truth {

double number(const Json& inputs, const char* name);
double positive(const Json& inputs, const char* name);
double not_negative(const Json& inputs, const char* name);

/// From `least` to `most`, both of them included.
double between(const Json& inputs, const char* name, double least, double most);

/// A whole number of things to list, from 1 to 10000.
int count(const Json& inputs, const char* name);

/// Three numbers.
glm::dvec3 vector(const Json& inputs, const char* name);

/// A list of 1 to 10000 numbers.
std::vector<double> numbers(const Json& inputs, const char* name);
std::vector<double> positive_numbers(const Json& inputs, const char* name);

/// The number n of steps, which all the time of a case depends on.
long long steps(const Json& inputs);

/// A list of numbers of steps, each at least 1.
std::vector<long long> ladder(const Json& inputs);

}  // namespace timestep::truth
