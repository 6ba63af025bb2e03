// The same planet in Boost.Odeint, on the fastest state that it takes: std::array.
#include <array>
#include <string>
#include <utility>

#include <boost/numeric/odeint.hpp>
#include <boost/numeric/odeint/stepper/velocity_verlet.hpp>

#include "bench/kepler.hpp"

namespace timestep::inline TIMESTEP_PRECISION::bench {
namespace {

namespace odeint = boost::numeric::odeint;
using Three = std::array<double, 3>;
using Six = std::array<double, 6>;

Three gravity(const Three& x) {
  const Vec3 a = gravity_towards_origin(1, {x[0], x[1], x[2]});
  return {a.x, a.y, a.z};
}

// Runge-Kutta steppers see x and v as one vector of six
template <typename Stepper>
struct FirstOrder {
  Stepper stepper;
  Six y{k_pericentre, 0, 0, 0, k_speed, 0};

  void step(double t) {
    const auto rates = [](const Six& at, Six& dydt, double) {
      const Three a = gravity({at[0], at[1], at[2]});
      dydt = {at[3], at[4], at[5], a[0], a[1], a[2]};
    };
    stepper.do_step(rates, y, t, k_dt);
  }
  Vec3 x() const { return {y[0], y[1], y[2]}; }
  Vec3 v() const { return {y[3], y[4], y[5]}; }
};

// Symplectic steppers see x and v apart; velocity Verlet also shows v to the force
template <typename Stepper>
struct SecondOrder {
  Stepper stepper;
  std::pair<Three, Three> y{{k_pericentre, 0, 0}, {0, k_speed, 0}};

  void step(double t) {
    const auto symplectic = [](const Three& x, Three& a) { a = gravity(x); };
    const auto verlet = [](const Three& x, const Three&, Three& a, double) {
      a = gravity(x);
    };
    if constexpr (std::is_same_v<Stepper, odeint::velocity_verlet<Three>>)
      stepper.do_step(verlet, y, t, k_dt);
    else
      stepper.do_step(symplectic, y, t, k_dt);
  }
  Vec3 x() const { return {y.first[0], y.first[1], y.first[2]}; }
  Vec3 v() const { return {y.second[0], y.second[1], y.second[2]}; }
};

template <typename Orbit>
void add(const std::string& stepper) {
  benchmark::RegisterBenchmark(
      ("kepler/" + stepper + "/Odeint").c_str(),
      [](benchmark::State& run) { measure_orbit(run, [] { return Orbit{}; }); });
}

}  // namespace

void add_kepler_with_odeint() {
  add<SecondOrder<odeint::symplectic_euler<Three>>>("symplectic_euler");
  add<SecondOrder<odeint::velocity_verlet<Three>>>("velocity_verlet");
  add<SecondOrder<odeint::symplectic_rkn_sb3a_mclachlan<Three>>>(
      "symplectic_rkn_sb3a_mclachlan");
  add<FirstOrder<odeint::runge_kutta4<Six>>>("runge_kutta4");
  add<FirstOrder<odeint::runge_kutta4_classic<Six>>>("runge_kutta4_classic");
  add<FirstOrder<odeint::runge_kutta_dopri5<Six>>>("runge_kutta_dopri5");
}

}  // namespace timestep::inline TIMESTEP_PRECISION::bench
