// Prints the bits that the physics ends with, so that builds can be compared: every
// method under every force, and the exact motions. Compiled once for each precision.
#include <cstdio>
#include <cstring>

#include "common/physics/euler.hpp"
#include "common/physics/exact.hpp"
#include "common/physics/forces.hpp"
#include "common/physics/particle.hpp"
#include "common/physics/rounding.hpp"

using namespace timestep;

namespace {

template <class Number>
void print(const char* what, Number value) {
  unsigned char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  std::printf("%s ", what);
  for (const unsigned char byte : bytes) std::printf("%02x", unsigned{byte});
  std::printf("\n");
}

// A cloud of particles on springs, in gravity and both kinds of drag, for 1,000 steps.
void print_cloud(const NamedIntegrator& method) {
  constexpr std::size_t n = 64;
  State cloud = particles(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto s = Real(i) / Real(n);
    put(cloud.x, i, {s, 2 - s, s * s});
    put(cloud.v, i, {1 - s, s / 3, Real(0.1) * s});
  }
  const Acceleration acceleration = [](auto x, auto v, Real t, auto a) {
    for (std::size_t i = 0; i < x.size() / 3; ++i) {
      const Real m = 1 + Real(i) / 7;
      const Vec3 force =
          weight(m, {0, Real(-9.81), 0}) + spring(m * 30, at(x, i), {t / 10, 0, 0})
          + linear_drag(Real(0.3), at(v, i)) + quadratic_drag(Real(0.02), at(v, i));
      put(a, i, newton(force, 1 / m));
    }
  };
  for (int i = 0; i < 1000; ++i) {
    method.step(cloud, acceleration, Real(i) / 60, Real(1) / 60);
    for (Real& v : cloud.v) v *= damping_factor(Real(0.9), Real(1) / 60);
  }
  for (const Real x : cloud.x) print(method.name.data(), x);
  for (const Real v : cloud.v) print(method.name.data(), v);
}

}  // namespace

int main() {
  for (const NamedIntegrator& method : euler_methods()) print_cloud(method);
  print("clock", accumulated_time(Real(1) / 60, 100'000));
  for (int i = 0; i < 50; ++i) {
    const double t = 0.1 * i;
    const auto m =
        exact::quadratic_drag({{0, 1, 0}, {20, 25, -5}}, {0, -9.81, 0}, 0.05, t);
    const auto l = exact::linear_drag({{0, 1, 0}, {20, 25, -5}}, {0, -9.81, 0}, 0.3, t);
    print("quadratic", m.x.x + m.x.y + m.v.x + m.v.y);
    print("linear", l.x.x + l.x.y + l.v.x + l.v.y);
    print("oscillator", exact::oscillator({1, 2}, 3, 0.1 * i, t).x);
  }
  return 0;
}
