/// @file
/// Numbers as unevaluated sums of two doubles, 106 bits: for expected values that are
/// differences of nearly equal numbers.
#pragma once

#include <cmath>

namespace timestep::truth {

struct Pair {
  double high, low;
};

inline Pair sum(const Pair& a, const Pair& b) {
  const double high = a.high + b.high;
  const double b_back = high - a.high;
  const double lost = (a.high - (high - b_back)) + (b.high - b_back);
  const double low = lost + (a.low + b.low);
  return {high + low, low - ((high + low) - high)};
}

inline Pair difference(const Pair& a, const Pair& b) {
  return sum(a, {-b.high, -b.low});
}

inline Pair product(const Pair& a, double b) {
  const double high = a.high * b;
  return {high, std::fma(a.high, b, -high) + a.low * b};
}

inline double quotient(const Pair& a, const Pair& b) {
  const double q = (a.high + a.low) / b.high;
  const double rest = std::fma(-q, b.high, a.high) + (a.low - q * b.low);
  return q + rest / b.high;
}

}  // namespace timestep::truth
