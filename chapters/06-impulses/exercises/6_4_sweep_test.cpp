// A sweep by hand, then stacks whose impulses are the weights above, from cold and from
// wrong starts.
#include "chapters/06-impulses/exercises/6_4_sweep.hpp"

#include <vector>

#include "tests/exercise.hpp"

using namespace timestep;

namespace {

constexpr Real k_g = 9.81, k_dt = 1.0 / 60;

// Bodies of so many kg that have fallen for a step, with impulses to start from
struct Stack {
  std::vector<Real> inverse_masses{0}, velocities{0}, impulses;

  Stack(const std::vector<Real>& masses, Real start) : impulses(masses.size(), start) {
    for (const Real m : masses) {
      inverse_masses.push_back(1 / m);
      velocities.push_back(-k_g * k_dt);
    }
    for (std::size_t i = 0; i < impulses.size(); ++i) {
      velocities[i] -= inverse_masses[i] * start;
      velocities[i + 1] += inverse_masses[i + 1] * start;
    }
  }
};

// After so many sweeps each contact carries the weight above, to a share of 1e-9
void expect_weights(const char* what, Stack stack, int sweeps) {
  for (int i = 0; i < sweeps; ++i)
    sweep(stack.inverse_masses, stack.velocities, stack.impulses);
  Real weight = 0;
  for (std::size_t i = stack.impulses.size(); i-- > 0;) {
    weight += k_g * k_dt / stack.inverse_masses[i + 1];
    expect(fmt::format("{}, impulse [N s] of contact {}", what, i), stack.impulses[i],
           weight, 1e-9 * weight);
  }
}

}  // namespace

TEST_CASE("two boxes, one sweep") {
  // 1 kg each: the ground stops the lower one, and takes half of what then closes above
  Stack stack({1, 1}, 0);
  sweep(stack.inverse_masses, stack.velocities, stack.impulses);
  const Real J = k_g * k_dt;
  expect("impulse [N s] of the ground", stack.impulses[0], J, 1e-15);
  expect("impulse [N s] between the boxes", stack.impulses[1], J / 2, 1e-15);
  expect("velocity [m/s] of the lower box", stack.velocities[1], -J / 2, 1e-15);
  expect("velocity [m/s] of the upper box", stack.velocities[2], -J / 2, 1e-15);
}

TEST_CASE("from nothing to the weights") {
  // Equal boxes: the slowest share falls by cos² (π / 2 n) a sweep, for four by 0.85,
  // for ten by 0.976: 150 and 1,000 sweeps leave 1e-10
  expect_weights("four boxes", Stack({1, 1, 1, 1}, 0), 150);
  expect_weights("ten boxes", Stack(std::vector<Real>(10, 1), 0), 1000);
}

TEST_CASE("from too much, what was given is taken back") {
  expect_weights("one box", Stack({1}, 5), 1);
  expect_weights("four boxes", Stack({1, 1, 1, 1}, 5), 250);
}

TEST_CASE("a contact never pulls") {
  // The upper box flies off; whatever the contact had before ends with it
  Stack stack({1, 1}, 0.1);
  stack.velocities[2] = 3;
  for (int i = 0; i < 100; ++i)
    sweep(stack.inverse_masses, stack.velocities, stack.impulses);
  expect("impulse [N s] between the boxes", stack.impulses[1], 0, 0);
  expect("velocity [m/s] of the lower box", stack.velocities[1], 0, 1e-12);
  expect("velocity [m/s] of the upper box", stack.velocities[2], 3 - 0.1, 1e-12);
}

TEST_CASE("a wall on the ground") {
  // Its mass is infinite, and nothing may divide by 0
  Stack stack({1, 1}, 0);
  stack.inverse_masses[1] = 0;
  stack.velocities[1] = 0;
  sweep(stack.inverse_masses, stack.velocities, stack.impulses);
  expect("impulse [N s] of the ground on the wall", stack.impulses[0], 0, 0);
  expect("velocity [m/s] of the box on the wall", stack.velocities[2], 0, 1e-15);
}
