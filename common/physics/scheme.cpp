#include "common/physics/scheme.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

Real time(const Integration& integration) {
  return static_cast<Real>(integration.steps) * integration.dt;
}

}  // namespace

Integration begin(const Scheme& scheme, const Acceleration& acceleration,
                  const State& start, Real dt) {
  Integration all{.scheme = scheme,
                  .acceleration = acceleration,
                  .dt = dt,
                  .state = start,
                  .stages = std::vector<State>(scheme.stages, start)};
  if (scheme.start) scheme.start(all.state, all.stages, acceleration, 0, dt);
  return all;
}

void advance(Integration& integration) {
  integration.scheme.step(integration.state, integration.stages,
                          integration.acceleration, time(integration), integration.dt);
  ++integration.steps;
}

State read(const Integration& integration) {
  State now = integration.state;
  if (!integration.scheme.read) return now;
  std::vector<State> stages = integration.stages;
  integration.scheme.read(now, stages, integration.acceleration, time(integration),
                          integration.dt);
  return now;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
