// The same planet in the GNU Scientific Library. Its steppers also estimate their
// error, and its rk4 does so by a second and a third step of half the length.
#include <array>
#include <memory>
#include <string>

#include <gsl/gsl_odeiv2.h>

#include "bench/kepler.hpp"

namespace timestep::inline TIMESTEP_PRECISION::bench {
namespace {

using Six = std::array<double, 6>;
using Step = std::unique_ptr<gsl_odeiv2_step, decltype(&gsl_odeiv2_step_free)>;

int rates(double, const double* y, double* dydt, void*) {
  const Vec3 a = gravity_towards_origin(1, {y[0], y[1], y[2]});
  dydt[0] = y[3];
  dydt[1] = y[4];
  dydt[2] = y[5];
  dydt[3] = a.x;
  dydt[4] = a.y;
  dydt[5] = a.z;
  return 0;
}

struct Planet {
  Step stepper;
  Six y{k_pericentre, 0, 0, 0, k_speed, 0};
  Six error{}, before{}, after{};

  explicit Planet(const gsl_odeiv2_step_type* type)
      : stepper(gsl_odeiv2_step_alloc(type, 6), gsl_odeiv2_step_free) {
    rates(0, y.data(), after.data(), nullptr);
  }
  void step(double t) {
    const gsl_odeiv2_system system{rates, nullptr, 6, nullptr};
    before = after;
    gsl_odeiv2_step_apply(stepper.get(), t, k_dt, y.data(), error.data(), before.data(),
                          after.data(), &system);
  }
  Vec3 x() const { return {y[0], y[1], y[2]}; }
  Vec3 v() const { return {y[3], y[4], y[5]}; }
};

void add(const gsl_odeiv2_step_type* type) {
  benchmark::RegisterBenchmark(("kepler/" + std::string(type->name) + "/GSL").c_str(),
                               [type](benchmark::State& run) {
                                 measure_orbit(run, [type] { return Planet(type); });
                               });
}

}  // namespace

void add_kepler_with_gsl() {
  for (const auto* type :
       {gsl_odeiv2_step_rk4, gsl_odeiv2_step_rkf45, gsl_odeiv2_step_rk8pd})
    add(type);
}

}  // namespace timestep::inline TIMESTEP_PRECISION::bench
