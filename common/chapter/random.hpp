/// @file
/// Random numbers that are the same on every machine: the standard fixes the bits of
/// the generator but not of its distributions, so the one distribution here is ours.
#pragma once

#include <cstdint>
#include <random>

namespace timestep {

class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}

  /// Evenly distributed in [low, high).
  double uniform(double low, double high) {
    const double unit = static_cast<double>(generator_() >> 11) * 0x1p-53;
    return low + (high - low) * unit;
  }

 private:
  std::mt19937_64 generator_;
};

}  // namespace timestep
