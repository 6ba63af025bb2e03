// Boost.Odeint on chapter 2's problems, on the fastest state that it takes: std::array.
#include <boost/numeric/odeint.hpp>
#include <boost/numeric/odeint/stepper/velocity_verlet.hpp>

#include "study/peers/systems.hpp"

namespace timestep::study {
namespace {

namespace odeint = boost::numeric::odeint;

// Runge-Kutta steppers see x and v as one vector
template <std::size_t n, class Stepper>
class FirstOrder {
 public:
  FirstOrder(System<n> system, double dt) : system_(std::move(system)), dt_(dt) {
    std::ranges::copy(system_.x, y_.begin());
    std::ranges::copy(system_.v, y_.begin() + n);
  }
  void step(double t) {
    const auto rates = [this](const auto& y, auto& dydt, double) {
      std::array<double, n> x{}, a{};
      std::copy_n(y.begin(), n, x.begin());
      system_.acceleration(x, a);
      std::copy_n(y.begin() + n, n, dydt.begin());
      std::ranges::copy(a, dydt.begin() + n);
    };
    stepper_.do_step(rates, y_, t, dt_);
  }
  std::array<double, n> x() const { return half(0); }
  std::array<double, n> v() const { return half(n); }

 private:
  std::array<double, n> half(std::size_t from) const {
    std::array<double, n> part{};
    std::copy_n(y_.begin() + static_cast<std::ptrdiff_t>(from), n, part.begin());
    return part;
  }

  System<n> system_;
  double dt_;
  Stepper stepper_{};
  std::array<double, 2 * n> y_{};
};

// Symplectic steppers see x and v apart; velocity Verlet also shows v to the force
template <std::size_t n, class Stepper>
class SecondOrder {
 public:
  SecondOrder(System<n> system, double dt) : system_(std::move(system)), dt_(dt) {}
  void step(double t) {
    using Half = std::array<double, n>;
    const auto symplectic = [this](const Half& x, Half& a) {
      system_.acceleration(x, a);
    };
    const auto verlet = [this](const Half& x, const Half&, Half& a, double) {
      system_.acceleration(x, a);
    };
    std::pair<Half&, Half&> y(system_.x, system_.v);
    if constexpr (std::is_same_v<Stepper, odeint::velocity_verlet<Half>>)
      stepper_.do_step(verlet, y, t, dt_);
    else
      stepper_.do_step(symplectic, y, t, dt_);
  }
  const std::array<double, n>& x() const { return system_.x; }
  const std::array<double, n>& v() const { return system_.v; }

 private:
  System<n> system_;
  double dt_;
  Stepper stepper_{};
};

template <std::size_t n>
using Half = std::array<double, n>;
template <std::size_t n>
using Whole = std::array<double, 2 * n>;

template <std::size_t n>
using SymplecticEuler = SecondOrder<n, odeint::symplectic_euler<Half<n>>>;
template <std::size_t n>
using Verlet = SecondOrder<n, odeint::velocity_verlet<Half<n>>>;
template <std::size_t n>
using Mclachlan = SecondOrder<n, odeint::symplectic_rkn_sb3a_mclachlan<Half<n>>>;
template <std::size_t n>
using RungeKutta4 = FirstOrder<n, odeint::runge_kutta4<Whole<n>>>;
template <std::size_t n>
using DormandPrince = FirstOrder<n, odeint::runge_kutta_dopri5<Whole<n>>>;

template <template <std::size_t> class Stepper>
Peer peer(const std::string& name) {
  return {.method = "odeint " + name,
          .precision = "double",
          .start = [](const auto& s) { return start_system<Stepper>(s); }};
}

}  // namespace

std::vector<Peer> peers_of_odeint() {
  return {peer<SymplecticEuler>("symplectic_euler"), peer<Verlet>("velocity_verlet"),
          peer<RungeKutta4>("rk4"), peer<DormandPrince>("dopri5"),
          peer<Mclachlan>("mclachlan")};
}

}  // namespace timestep::study
