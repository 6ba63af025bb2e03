// Rigid bodies without torque, by every method of chapter 3: what a step costs, and
// how far off it leads.
#include "bench/rotation.hpp"

#include <limits>

#include "common/physics/gyroscopic.hpp"
#include "common/physics/rigid_body.hpp"
#include "common/physics/rotation_momentum.hpp"
#include "common/physics/rotation_runge_kutta.hpp"
#include "common/physics/rotor_splitting.hpp"

namespace timestep::inline TIMESTEP_PRECISION::bench {
namespace {

constexpr bool k_single = std::numeric_limits<Real>::digits == 24;

template <typename Method>
struct Bodies {
  Method method;
  std::vector<RigidBody> all;

  Bodies(const Method& turned_by, std::span<const glm::dvec3> spins)
      : method(turned_by) {
    for (const glm::dvec3& spin : spins)
      all.push_back({.angular_velocity = spin,
                     .inverse_mass = 1,
                     .inverse_inertia = 1.0 / k_inertia});
  }
  // Inlined to the bottom, as by itself in a file that has one method: all of them in
  // one are more than GCC allows for
  [[gnu::flatten]] void step() {
    for (RigidBody& body : all) integrate(body, method, Real(1) / k_steps_a_second);
  }
  exact::Turning first() const {
    const auto [q, omega] = rotation_of(all[0]);
    return {glm::dquat(q), glm::dvec3(omega)};
  }
};

void add(const std::string& name, const auto& method) {
  const std::string precision = k_single ? "/single" : "/double";
  add_bodies(name + precision, [method](std::span<const glm::dvec3> spins) {
    return Bodies(method, spins);
  });
}

}  // namespace

void add_rotation() {
  add("listing_3", [](auto&&... a) { listing_3(a...); });
  add("constant_omega", [](auto&&... a) { constant_omega(a...); });
  add("explicit_gyroscopic", [](auto&&... a) { explicit_gyroscopic(a...); });
  add("implicit_gyroscopic", [](auto&&... a) { implicit_gyroscopic(a...); });
  add("explicit_rescaled_L", [](auto&&... a) { explicit_rescaled(a...); });
  add("momentum", [](auto&&... a) { momentum(a...); });
  add("buss_second_order", [](auto&&... a) { buss_second_order(a...); });
  add("buss", [](auto&&... a) { buss(a...); });
  add("explicit_midpoint_su2", [](auto&&... a) { explicit_midpoint_su2(a...); });
  add("lie_midpoint", [](auto&&... a) { lie_midpoint(a...); });
  add("splitting", [](auto&&... a) { splitting(a...); });
  add("discrete_moser_veselov", [](auto&&... a) { discrete_moser_veselov(a...); });
  add("rotor_splitting", [](auto&&... a) { rotor_splitting(a...); });
  add("rotor_splitting_4", [](auto&&... a) { rotor_splitting_4(a...); });
  add("rk4", [](auto&&... a) { rk4(a...); });
  add("rkmk4", [](auto&&... a) { rkmk4(a...); });
}

}  // namespace timestep::inline TIMESTEP_PRECISION::bench
