// Numbers that can be checked by hand: levers of whole metres, a box of 1 m x 2 m x 3 m
// along the world's axes and turned, and bats.
#include "chapters/03-rigid-bodies/exercises/3_1_off_centre.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "tests/exercise.hpp"

using namespace timestep;

namespace {

constexpr double k_u = std::numeric_limits<double>::epsilon() / 2;

constexpr Real k_mass = 2;
const Vec3 k_size{1, 2, 3};
const Vec3 k_moments{13.0 / 6, 10.0 / 6, 5.0 / 6};

const std::string k_alpha =
    "angular acceleration [rad/s²] of a box of 2 kg and 1 m x 2 m x 3 m under a "
    "torque ";

// A torque is rounded a dozen times to u, and the smallest moment makes most of that
Real tolerance(const Vec3& tau) {
  return 16 * k_u * glm::length(tau) / k_moments.z;
}

}  // namespace

TEST_CASE("a force has a torque about the centre of mass") {
  expect("torque [N m] of a force (0, 5, 0) N at (4, 2, 2) m about (1, 2, 2) m",
         torque({0, 5, 0}, {4, 2, 2}, {1, 2, 2}), {0, 0, 15}, 0);
  expect("torque [N m] of a force (1, 2, 3) N at (3, 3, 3) m about (1, 2, 7) m",
         torque({1, 2, 3}, {3, 3, 3}, {1, 2, 7}), {11, -10, 3}, 0);
  expect("torque [N m] of a force (2, 4, -2) N that points at the centre",
         torque({2, 4, -2}, {3, 6, 0}, {2, 4, 1}), {0, 0, 0}, 0);
}

TEST_CASE("a box along the world's axes has three different moments") {
  const Vec3 tau{13, 5, 5};
  const Vec3 alpha = angular_acceleration(k_mass, k_size, {1, 0, 0, 0}, tau);
  expect(k_alpha + "(13, 5, 5) N m", alpha, {6, 3, 6}, tolerance(tau));
}

TEST_CASE("the moments turn with the box") {
  // A third of a turn about (1, 1, 1) takes the box's x axis to y, y to z, and z to x
  const Quat third(0.5, 0.5, 0.5, 0.5);
  const Vec3 tau{5, 13, 5};
  const Vec3 alpha = angular_acceleration(k_mass, k_size, third, tau);
  expect(k_alpha + "(5, 13, 5) N m, with the box's x, y, z along y, z, x", alpha,
         {6, 6, 3}, tolerance(tau));
}

TEST_CASE("a box that stands askew answers about other axes than it is asked") {
  // Turned by an angle about z, the tensor mixes the x and the y moment: this torque
  // makes the box turn about x alone
  const Real angle = std::numbers::pi / 6;
  const Real c = std::cos(angle), s = std::sin(angle);
  const Quat q(std::cos(angle / 2), 0, 0, std::sin(angle / 2));
  const Vec3 tau{c * c * k_moments.x + s * s * k_moments.y,
                 c * s * (k_moments.x - k_moments.y), 0};
  const Vec3 alpha = angular_acceleration(k_mass, k_size, q, tau);
  expect(k_alpha
             + fmt::format("({:.4f}, {:.4f}, 0) N m, with the box turned by 30 degrees "
                           "about z",
                           tau.x, tau.y),
         alpha, {1, 0, 0}, tolerance(tau));
}

TEST_CASE("hit a bat so that the hand feels nothing") {
  expect("where [m] to hit a thin bat of 1.5 m", sweet_spot({1.5, 0, 0.1}), 0.25,
         4 * k_u);
  expect("where [m] to hit a bat of 3 m x 1 m x 0.1 m", sweet_spot({3, 1, 0.1}),
         5.0 / 9, 4 * k_u);
  expect("where [m] to hit a cube of 1 m", sweet_spot({1, 1, 1}), 1.0 / 3, 4 * k_u);
}
