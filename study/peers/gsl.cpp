// The GNU Scientific Library on chapter 2's problems. Its steppers also estimate their
// error, and its rk4 does so by a second and a third step of half the length.
#include <gsl/gsl_odeiv2.h>

#include "study/peers/systems.hpp"

namespace timestep::study {
namespace {

template <std::size_t n>
class Gsl {
 public:
  Gsl(System<n> system, double dt, const gsl_odeiv2_step_type* type)
      : system_(std::move(system)),
        dt_(dt),
        stepper_(gsl_odeiv2_step_alloc(type, 2 * n), gsl_odeiv2_step_free) {
    std::ranges::copy(system_.x, y_.begin());
    std::ranges::copy(system_.v, y_.begin() + n);
    rates(0, y_.data(), after_.data(), &system_);
  }
  void step(double t) {
    const gsl_odeiv2_system whole{rates, nullptr, 2 * n, &system_};
    before_ = after_;
    gsl_odeiv2_step_apply(stepper_.get(), t, dt_, y_.data(), error_.data(),
                          before_.data(), after_.data(), &whole);
  }
  std::array<double, n> x() const { return half(y_.data()); }
  std::array<double, n> v() const { return half(y_.data() + n); }

 private:
  static std::array<double, n> half(const double* from) {
    std::array<double, n> part{};
    std::copy_n(from, n, part.begin());
    return part;
  }
  static int rates(double, const double* y, double* dydt, void* system) {
    std::array<double, n> a{};
    static_cast<const System<n>*>(system)->acceleration(half(y), a);
    std::copy_n(y + n, n, dydt);
    std::ranges::copy(a, dydt + n);
    return 0;
  }

  System<n> system_;
  double dt_;
  std::unique_ptr<gsl_odeiv2_step, decltype(&gsl_odeiv2_step_free)> stepper_;
  std::array<double, 2 * n> y_{}, error_{}, before_{}, after_{};
};

}  // namespace

std::vector<Peer> peers_of_gsl() {
  std::vector<Peer> all;
  for (const auto* type :
       {gsl_odeiv2_step_rk4, gsl_odeiv2_step_rkf45, gsl_odeiv2_step_rk8pd})
    all.push_back({.method = std::string("gsl ") + type->name,
                   .precision = "double",
                   .start = [type](const PeerSetup& setup) {
                     return start_system<Gsl>(setup, type);
                   }});
  return all;
}

}  // namespace timestep::study
