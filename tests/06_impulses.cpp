// Impacts of two bodies by every law, soft contacts, and the direct solver.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "common/physics/lcp.hpp"
#include "common/physics/mass_properties.hpp"
#include "common/physics/world.hpp"
#include "tests/catch.hpp"

using namespace timestep;

namespace {

constexpr Real k_u = std::numeric_limits<Real>::epsilon() / 2;

// Random numbers whose sequence the standard fixes
struct Random {
  std::mt19937 bits{6};
  Real operator()(Real low, Real high) {
    return low + (high - low) * Real(bits()) / Real(std::mt19937::max());
  }
  Vec3 vector() { return {(*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1)}; }
};

// Masses from 0.1 to 10 kg, boxes of 0.2 to 2 m
RigidBody random_body(Random& random) {
  const Real mass = std::pow(Real(10), random(-1, 1));
  const Vec3 size(random(Real(0.2), 2), random(Real(0.2), 2), random(Real(0.2), 2));
  RigidBody body = body_with_mass(mass, solid_box(mass, size).inertia);
  body.position = random.vector();
  body.orientation = rotation_by(Real(3) * random.vector());
  body.velocity = Real(3) * random.vector();
  body.angular_velocity = Real(3) * random.vector();
  return body;
}

// Two bodies that close at a random point
struct Meeting {
  RigidBody a, b;
  Impact impact;
};

Meeting random_meeting(Random& random) {
  Meeting m{random_body(random), random_body(random), {}};
  if (random(0, 1) < Real(0.2)) m.a = RigidBody{};
  m.impact = {.point = random.vector(),
              .normal = glm::normalize(random.vector()),
              .restitution = random(0, 1),
              .friction = random(0, Real(1.5))};
  const Vec3 v = relative_velocity(m.a, m.b, m.impact.point);
  if (glm::dot(v, m.impact.normal) > 0) m.impact.normal = -m.impact.normal;
  return m;
}

glm::dvec3 momentum(const Meeting& m) {
  return mass_of(m.a) * glm::dvec3(m.a.velocity)
         + mass_of(m.b) * glm::dvec3(m.b.velocity);
}

glm::dvec3 spin(const Meeting& m) {
  const glm::dvec3 origin(0);
  return angular_momentum_about(m.a, origin) + angular_momentum_about(m.b, origin);
}

double energy(const Meeting& m) {
  return kinetic_energy(m.a) + kinetic_energy(m.b);
}

Meeting after(Meeting m, const Vec3& impulse) {
  apply_impulse(m.a, m.b, m.impact.point, impulse);
  return m;
}

// What a rounding of each number may come to: moments of inertia of a box of 10 kg from
// 0.2 to 2 m answer to velocities and impulses of some 100 kg m/s over arms of 2 m
constexpr Real k_roundings = 64, k_momentum = 200;

// Kane's rod: 1 m, 1 kg, at 45 degrees, sideways over a floor that it hits at 1 m/s
Meeting kanes_rod() {
  const Real eighth = Real(0.39269908169872414);  // pi / 8: half of 45 degrees
  RigidBody rod = body_with_mass(1, solid_box(1, {1, 0, 0}).inertia);
  rod.inverse_inertia = {1000, 12, 12};
  rod.orientation = {std::cos(eighth), 0, 0, std::sin(eighth)};
  rod.velocity = {Real(0.6), -1, 0};
  const Real arm = std::sqrt(Real(0.125));
  rod.position = {0, arm, 0};
  return {RigidBody{}, rod, {{-arm, 0, 0}, {0, 1, 0}, 1, Real(0.5)}};
}

}  // namespace

TEST_CASE("impacts keep momentum and angular momentum") {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const Meeting before = random_meeting(random);
    if (before.a.inverse_mass == 0) continue;
    for (const ImpactLaw& law : impact_laws()) {
      INFO(law.name);
      const Vec3 J = law.impulse(before.a, before.b, before.impact);
      const Meeting then = after(before, J);
      const Real size = k_momentum + glm::length(J);
      CHECK(glm::length(momentum(then) - momentum(before)) <= k_roundings * k_u * size);

      // A needle's inverse inertia is up to 100 times another's, so its turn rounds
      // more
      CHECK(glm::length(spin(then) - spin(before)) <= 100 * k_roundings * k_u * size);
    }
  }
}

TEST_CASE("without friction an impact takes (1 - e²) v² / 2k") {
  Random random;
  const ImpactLaw& law = *find_impact_law("frictionless");
  for (int i = 0; i < 1000; ++i) {
    const Meeting before = random_meeting(random);
    const auto& [point, n, e, friction] = before.impact;
    const Real v = glm::dot(relative_velocity(before.a, before.b, point), n);
    const Real mass = effective_mass(before.a, before.b, point, n);
    const Meeting then = after(before, law.impulse(before.a, before.b, before.impact));
    const double lost = energy(before) - energy(then);
    const double slack = 100 * k_roundings * double(k_u)
                         * (energy(before) + energy(then) + double(mass * v * v));
    CHECK(std::abs(lost - double((1 - e * e) * v * v * mass / 2)) <= slack);
    CHECK(lost >= -slack);
  }
}

TEST_CASE("Coulomb's bound holds in every law") {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const Meeting m = random_meeting(random);
    for (const ImpactLaw& law : impact_laws()) {
      INFO(law.name);
      const Vec3 J = law.impulse(m.a, m.b, m.impact);
      const Real j_n = glm::dot(J, m.impact.normal);
      const Real j_t = glm::length(J - j_n * m.impact.normal);
      CHECK(j_n >= 0);
      CHECK(j_t <= m.impact.friction * j_n + k_roundings * k_u * glm::length(J));
    }
  }
}

TEST_CASE("swapping the bodies of an impact changes nothing") {
  Random random;
  for (int i = 0; i < 300; ++i) {
    const Meeting m = random_meeting(random);
    Impact other = m.impact;
    other.normal = -other.normal;
    for (const ImpactLaw& law : impact_laws()) {
      INFO(law.name);
      const Vec3 J = law.impulse(m.a, m.b, m.impact);
      const Vec3 K = law.impulse(m.b, m.a, other);

      // Where it sticks the inverse of K is as sensitive as K's eigenvalues are apart:
      // here up to 1000
      CHECK(glm::length(J + K) <= 1000 * k_roundings * k_u * (glm::length(J) + 1));
    }
  }
}

TEST_CASE("Newton's restitution gains energy on Kane's rod, Poisson's does not") {
  const Meeting rod = kanes_rod();
  const auto energy_by = [&](const char* law) {
    return energy(after(rod, find_impact_law(law)->impulse(rod.a, rod.b, rod.impact)));
  };
  CHECK(energy(rod) == Approx(0.68).margin(64 * double(k_u)));
  CHECK(energy_by("coupled_friction") == Approx(0.7925).margin(64 * double(k_u)));
  CHECK(energy_by("poisson") < Real(0.68));
}

TEST_CASE("one pass of a game's solver can leave bodies closing, both at once cannot") {
  Random random;
  int left_closing = 0;
  for (int i = 0; i < 1000; ++i) {
    const Meeting m = random_meeting(random);
    const Real closing =
        -glm::dot(relative_velocity(m.a, m.b, m.impact.point), m.impact.normal);
    const auto parting_by = [&](const char* law) {
      const Meeting then = after(m, find_impact_law(law)->impulse(m.a, m.b, m.impact));
      return glm::dot(relative_velocity(then.a, then.b, m.impact.point),
                      m.impact.normal);
    };
    left_closing += parting_by("sequential_friction") < -closing / 10 ? 1 : 0;

    // The impulse is found to its last bits; K, of numbers up to 1000 1/kg, answers
    CHECK(std::abs(parting_by("coupled_friction") - m.impact.restitution * closing)
          <= 1000 * k_roundings * k_u * (1 + closing));
  }
  CHECK(left_closing > 0);
}

TEST_CASE("Poisson's restitution never gains energy") {
  Random random;
  const ImpactLaw& poisson = *find_impact_law("poisson");
  const ImpactLaw& newton = *find_impact_law("coupled_friction");
  int gains = 0;
  for (int i = 0; i < 3000; ++i) {
    const Meeting m = random_meeting(random);
    const auto gain = [&](const ImpactLaw& law) {
      return energy(after(m, law.impulse(m.a, m.b, m.impact))) - energy(m);
    };
    const Real slack = 100 * k_roundings * k_u * k_momentum;
    CHECK(gain(poisson) <= slack);
    gains += gain(newton) > slack ? 1 : 0;
  }
  CHECK(gains > 0);
}

TEST_CASE("in a pyramid friction is sqrt 2 too strong on the diagonal") {
  const Mat3 basis = contact_basis({0, 1, 0});
  const Vec3 diagonal = Real(10) * (basis[1] + basis[2]);
  const Real ratio = glm::length(in_pyramid(diagonal, Real(0.5), 2, basis))
                     / glm::length(in_cone(diagonal, Real(0.5), 2));
  CHECK(std::abs(ratio - std::sqrt(Real(2))) <= 8 * k_u);
}

TEST_CASE("a soft contact is a damped spring by implicit Euler") {
  const Real h = Real(1) / 240, hertz = 30, zeta = Real(0.7), mass = 3;
  const SoftCoefficients soft = soft_contact(hertz, zeta, h);
  const auto [k, c] = spring_damper(hertz, zeta, mass);

  // v' = v - h (k (s + h v') + c v') / mass, and the impulse that this is
  const Real s = Real(-0.02), v = Real(0.3);
  const Real implicit = (mass * v - h * k * s) / (mass + h * c + h * h * k);
  const Real impulse = -soft.mass_scale * mass * (v + soft.bias_rate * s);
  CHECK(std::abs(v + impulse / mass - implicit) <= 16 * k_u);
  CHECK(std::abs(soft.mass_scale + soft.impulse_scale - 1) <= 4 * k_u);

  // A second pass over the same row changes nothing: it knows what it has let go
  const Real again = -soft.mass_scale * mass * (implicit + soft.bias_rate * s)
                     - soft.impulse_scale * impulse;
  CHECK(std::abs(again) <= 32 * k_u * mass);
}

TEST_CASE("Lemke's method solves what it is given") {
  // w = z - 1: z = 1. w = z + 1: z = 0. Both in one problem, and one that has none:
  // w = -z - 1
  CHECK(lemke({{1}, {-1}}, 10)[0] == Approx(1.0).margin(1e-9));
  const auto both = lemke({{1, 0, 0, 1}, {-1, 1}}, 10);
  REQUIRE(both.size() == 2);
  CHECK(both[0] == Approx(1.0).margin(1e-9));
  CHECK(both[1] == 0.0);
  CHECK(lemke({{-1}, {-1}}, 10).empty());

  // Random positive definite problems have one solution each
  Random random;
  for (int i = 0; i < 100; ++i) {
    const std::size_t m = 12;
    std::vector<double> A(m * m), M(m * m, 0.0), q(m);
    for (double& a : A) a = double(random(-1, 1));
    for (double& each : q) each = double(random(-1, 1));
    for (std::size_t r = 0; r < m; ++r) {
      for (std::size_t c = 0; c < m; ++c)
        for (std::size_t k = 0; k < m; ++k) M[r * m + c] += A[r * m + k] * A[c * m + k];
      M[r * m + r] += 0.1;
    }
    const auto z = lemke({M, q}, 1000);
    REQUIRE(z.size() == m);
    for (std::size_t r = 0; r < m; ++r) {
      double w = q[r];
      for (std::size_t c = 0; c < m; ++c) w += M[r * m + c] * z[c];

      // The crumbs that keep rows from tying are 2e-12 of |q|; z is up to 1 / 0.1 of
      // that
      CHECK(z[r] >= 0);
      CHECK(w >= -1e-9);
      CHECK(std::abs(w * z[r]) <= 1e-8);
    }
  }
}
