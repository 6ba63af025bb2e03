#include "chapters/05-penetration/least_motion.hpp"

#include <cmath>
#include <numbers>

namespace timestep::inline TIMESTEP_PRECISION::chapter_05 {
namespace {

// Where a growing function crosses zero
double zero_of(const auto& f, double low, double high) {
  constexpr int k_halvings = 200;
  for (int i = 0; i < k_halvings; ++i) {
    const double middle = (low + high) / 2;
    (f(middle) < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

// How far the lower edge is below the middle, and its arm
double below(const Plank& plank, double tilt) {
  return (plank.length * std::sin(tilt) + plank.thickness * std::cos(tilt)) / 2;
}
double arm(const Plank& plank, double tilt) {
  return (plank.length * std::cos(tilt) - plank.thickness * std::sin(tilt)) / 2;
}

}  // namespace

double plank_depth(const Plank& plank, const PlankPlace& place) {
  return below(plank, place.tilt) - place.height;
}

PlankPlace plank_out(const Plank& plank, const PlankPlace& place) {
  if (plank_depth(plank, place) <= 0) return place;

  // The ground's push p [kg m] lifts by p / m and turns by p arm / I
  const auto too_upright = [&](double tilt) {
    const double push = plank.mass * (below(plank, tilt) - place.height);
    return tilt - place.tilt + push * arm(plank, tilt) / plank.inertia;
  };
  const double tilt = zero_of(too_upright, 0, place.tilt);
  return {below(plank, tilt), tilt};
}

Parting ball_off_bar(const BallOnBar& pair) {
  // The push p [kg m] that parts them along the normal of a bar that has turned, and
  // its arm about the bar's middle
  const double inverse_masses = 1 / pair.ball_mass + 1 / pair.bar_mass;
  const auto push = [&](double turn) {
    const double apart = pair.above * std::cos(turn) - pair.along * std::sin(turn);
    return (pair.half + pair.radius - apart) / inverse_masses;
  };
  const auto arm = [&](double turn) {
    return pair.along * std::cos(turn) + pair.above * std::sin(turn);
  };
  const auto too_far = [&](double turn) {
    return turn + push(turn) * arm(turn) / pair.bar_inertia;
  };
  const double quarter = std::numbers::pi / 2;
  const double turn = zero_of(too_far, -quarter, quarter);
  return {turn, push(turn) / pair.ball_mass, push(turn) / pair.bar_mass};
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_05
