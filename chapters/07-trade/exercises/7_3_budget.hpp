/// @file
/// Exercise 7.3, challenge: What a frame can pay
#pragma once

#include <cstddef>
#include <span>

#include "common/physics/real.hpp"

namespace timestep {

/// A method as it was measured: its cost, and its error by (7.1).
struct Offer {
  Real cost;             ///< of one step [µs]
  Real order, constant;  ///< error = constant dt^order, both above 0, dt in s
  Real longest_step;     ///< [s]; it explodes with longer ones
};

/// A method, as its index, and into how many equal steps it divides the frame.
/// `steps` is 0 if no offer serves.
struct Deal {
  std::size_t offer = 0;
  int steps = 0;
};

/// Of all deals whose error is at most `error` and whose steps in a frame of `frame`
/// [s] cost at most `budget` [µs] together, the cheapest; of equally cheap ones that of
/// the smallest error.
Deal best_deal(std::span<const Offer> offers, Real frame, Real error, Real budget);

}  // namespace timestep
