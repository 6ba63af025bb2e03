#include "tests/truth/moving_frame.hpp"

#include <algorithm>
#include <cmath>

#include "common/physics/schemes.hpp"
#include "tests/truth/inputs.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

using truth::Json;

namespace {

// The acceleration in a frame that starts from a place with a velocity
Acceleration seen_from(const State& frame, const Acceleration& acceleration) {
  return [&frame, &acceleration, x_here = frame.x, v_here = frame.v](
             auto x, auto v, Real t, auto a) mutable {
    for (std::size_t i = 0; i < x.size(); ++i) {
      x_here[i] = frame.x[i] + (frame.v[i] * t + x[i]);
      v_here[i] = frame.v[i] + v[i];
    }
    acceleration(x_here, v_here, t, a);
  };
}

// Moves as much of `low` into `high` as that can hold, after a move of `high` by `way`
void carry(Real& high, Real& low, Real way) {
  const Real sum = high + way;
  const Real back = sum - high;
  low += (high - (sum - back)) + (way - back);
  high = sum + low;
  low -= high - sum;
}

// A new frame for the next step, from where the last one led
void change_frame(State& frame, Integration& now) {
  const Real dt = now.dt;
  for (std::size_t i = 0; i < frame.x.size(); ++i) {
    Real& x = now.state.x[i];
    Real& v = now.state.v[i];
    const Real x_before = x;
    const Real v_before = v;
    const Real way = frame.v[i] * dt;
    x += std::fma(frame.v[i], dt, -way);
    carry(frame.x[i], x, way);
    v = 0;
    carry(frame.v[i], v, v_before);

    // Places of a step ago, as seen from it
    for (State& stage : now.stages)
      stage.x[i] = std::fma(v_before - v, dt, stage.x[i] - x_before) + x;
  }
  now.steps = 0;
}

}  // namespace

FineEnd fine_end_of(const Run& run) {
  State frame = run.start;
  State at_rest = frame;
  std::ranges::fill(at_rest.x, Real(0));
  std::ranges::fill(at_rest.v, Real(0));
  Integration now =
      begin(run.scheme, seen_from(frame, run.acceleration), at_rest, run.dt);
  for (long long i = 0; i < run.n; ++i) {
    advance(now);
    change_frame(frame, now);
  }
  return {{place_of(frame), place_of(read(now))},
          {place_of(frame), place_of(now.state)}};
}

#if defined(TIMESTEP_DOUBLE)
truth::FinePlace convergence_reference(const Json& inputs) {
  const long long most = std::ranges::max(truth::ladder(inputs));
  const long long n = std::max(4096LL, 4 * most);
  return fine_end_of(convergence_run(inputs, *find_scheme("dopri5"), n)).now;
}
#endif

}  // namespace timestep::inline TIMESTEP_PRECISION
