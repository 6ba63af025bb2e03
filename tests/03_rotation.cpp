// Chapter 3's methods for rotation: their orders, what they keep, and where they stop.
// Compiled for each precision; u (k_u) is the unit round-off of the one at hand.
#include <array>
#include <cmath>
#include <numbers>

#include "common/physics/exact_free_top.hpp"
#include "common/physics/gyroscopic.hpp"
#include "common/physics/rotation_momentum.hpp"
#include "tests/rotation_run.hpp"

using namespace timestep;

namespace {

// Angle and angular velocity together
double distance(const Rotation& a, const exact::Turning& b) {
  return std::hypot(exact::angle_between(b.q, glm::dquat(a.q)),
                    glm::length(glm::dvec3(a.omega) - b.omega));
}

exact::Turning exactly(const Rotation& start, const Vec3& I, double t) {
  return exact::free_top(glm::dvec3(I), in_double(start), t);
}

// The power of the step with which the error at T = 2 falls from n to n_finer steps
double slope(const RotationMethod& method, const Torque& torque,
             const exact::Turning& end, int n, int n_finer) {
  const auto error = [&](int steps) {
    return distance(
        turned(method, tumbling(), asymmetric(), torque, 2.0 / steps, steps), end);
  };
  return std::log(error(n) / error(n_finer)) / std::log(double(n_finer) / n);
}

// How often a step turns the body
int turns_in_a_step(const RotationMethod& method) {
  if (method.name == "splitting") return 5;
  if (method.name == "rotor_splitting") return 4;
  return method.name == "rotor_splitting_4" ? 20 : 1;
}

void check_order(const RotationMethod& method, const Torque& torque,
                 const exact::Turning& end) {
  // The next power of the step changes a slope by some 0.02 in double. In single the
  // steps are so long that errors stay ten times above rounding, and it shows more: the
  // most accurate method takes one radian in a step
  const auto [n, n_finer] = !k_single                            ? std::pair{128, 512}
                            : method.name == "rotor_splitting_4" ? std::pair{2, 4}
                            : method.order == 4                  ? std::pair{10, 20}
                            : method.order == 2                  ? std::pair{20, 80}
                                                                 : std::pair{64, 256};
  INFO(method.name);
  const double observed = slope(method, torque, end, n, n_finer);
  if (k_single && method.order == 4)
    CHECK(observed > 3.6);
  else
    CHECK(observed == Approx(method.order).margin(k_single ? 0.08 : 0.06));
}

}  // namespace

TEST_CASE("every method turns a free body with its order") {
  const exact::Turning end = exactly(tumbling(), asymmetric(), 2);
  for (const RotationMethod& method : rotation_methods())
    check_order(method, no_torque, end);
}

TEST_CASE("every method keeps its order under a torque of attitude and time") {
  // The reference: RK4 with steps so short that its error is below 1e-14; in single,
  // 3e-6
  const int n = k_single ? 256 : 8192;
  const exact::Turning end = in_double(turned(
      rotation_method("rk4"), tumbling(), asymmetric(), stirred_compass, 2.0 / n, n));
  for (const RotationMethod& method : rotation_methods())
    check_order(method, stirred_compass, end);
}

TEST_CASE("a method calls the torque as often as it says") {
  for (const RotationMethod& method : rotation_methods()) {
    int calls = 0;
    const Torque counted = [&](const Quat& q, Real t) {
      ++calls;
      return compass(q, t);
    };
    turned(method, tumbling(), asymmetric(), counted, 0.01, 10);
    INFO(method.name);
    CHECK(calls == 10 * method.evaluations);
  }
}

TEST_CASE("the methods that keep momentum or energy do, and no others") {
  // Steps of 0.6 rad show what is not kept. A step rounds L and q, and so the world's
  // L, up to 16 times, five times as often in the splitting's five turns; energy is a
  // square, and moments of 1 to 2.5 count roundings of L up to 2.5 times in omega. In
  // single rounding hides that the most accurate method does not keep the energy
  constexpr int n = 200;
  for (const RotationMethod& method : rotation_methods()) {
    const Drift d = drift(method, tumbling(), asymmetric(), 0.6 / 1.34, n);
    const double bound = n * 16 * k_u * turns_in_a_step(method);
    INFO(method.name << ": energy " << d.energy << ", momentum " << d.momentum);
    if (method.keeps_momentum)
      CHECK(d.momentum <= bound);
    else
      CHECK_FALSE(d.momentum <= (k_single ? 0.5 : 10) * bound);
    if (method.keeps_energy)
      CHECK(d.energy <= 2 * 2.5 * bound);
    else if (!k_single || method.name != "rotor_splitting_4")
      CHECK_FALSE(d.energy <= (k_single ? 0.5 : 10) * bound);
  }

  // What misleads: without the gyroscopic term |L| is kept, too, and only L's direction
  // is wrong
  const Drift d = drift(rotation_method("listing_3"), tumbling(), asymmetric(), 0.1, n);
  CHECK(d.momentum_length <= n * 16 * k_u);
  CHECK(d.momentum > 0.1);
}

TEST_CASE("a step back undoes a step of the reversible methods alone") {
  for (const RotationMethod& method : rotation_methods()) {
    const double dt = 0.6 / 1.34;
    Rotation r = turned(method, tumbling(), asymmetric(), stirred_compass, dt, 1);
    method.step(r, asymmetric(), stirred_compass, Real(dt), Real(-dt));
    const double off = distance(r, in_double(tumbling()));

    // Some 16 roundings of numbers near 1 in each turn of a step, each way. What others
    // leave is the error of their order
    INFO(method.name << " is off by " << off);
    if (method.reversible)
      CHECK(off <= 2 * turns_in_a_step(method) * 16 * k_u);
    else
      CHECK(off > 1e-4);
  }
}

namespace {

// A change of attitude (the angle xi, body frame) and of L (rho, body frame)
struct Tangent {
  glm::dvec3 xi, rho;
};

// How a step of dt in the field of a compass changes a small change, by differences
Tangent carried(const RotationMethod& method, double dt, const Tangent& change) {
  const double h = std::cbrt(k_u);  // rounding u / h and curvature h² are alike
  const auto end = [&](double share) {
    const glm::dvec3 L =
        glm::dvec3(asymmetric() * tumbling().omega) + share * change.rho;
    const Rotation start{tumbling().q * rotation_by(Vec3(share * change.xi)),
                         Vec3(L) / asymmetric()};
    return turned(method, start, asymmetric(), compass, dt, 1);
  };
  const Rotation ahead = end(h), behind = end(-h);
  const glm::dquat turn = glm::conjugate(glm::dquat(behind.q)) * glm::dquat(ahead.q);
  const Vec3 rho = asymmetric() * (ahead.omega - behind.omega);
  return {glm::dvec3(turn.x, turn.y, turn.z) / h, glm::dvec3(rho) / (2 * h)};
}

// The area of phase space that two changes span, where the momentum is L
double area(const glm::dvec3& L, const Tangent& a, const Tangent& b) {
  return glm::dot(b.rho, a.xi) - glm::dot(a.rho, b.xi)
         + glm::dot(L, glm::cross(a.xi, b.xi));
}

}  // namespace

TEST_CASE("the symplectic methods keep all areas of phase space, others do not") {
  std::array<Tangent, 6> units{};
  for (std::size_t i = 0; i < 3; ++i)
    units[i].xi[int(i)] = units[i + 3].rho[int(i)] = 1;
  for (const RotationMethod& method : rotation_methods()) {
    constexpr double dt = 0.3;
    const Rotation end = turned(method, tumbling(), asymmetric(), compass, dt, 1);
    double worst = 0;
    for (const Tangent& a : units)
      for (const Tangent& b : units) {
        const double before = area(glm::dvec3(asymmetric() * tumbling().omega), a, b);
        const double after = area(glm::dvec3(asymmetric() * end.omega),
                                  carried(method, dt, a), carried(method, dt, b));
        worst = std::max(worst, std::abs(after - before));
      }

    // Derivatives are off by some 20 (h² + 2 u / h) of numbers up to 3
    const double bound = 60 * 3 * std::pow(k_u, 2.0 / 3);
    // In single that hides what RK4 and the Lie midpoint do: 1e-4 to 1e-3
    INFO(method.name << " changes areas by " << worst);
    if (method.symplectic)
      CHECK(worst <= bound);
    else if (!k_single || (method.order < 4 && !method.reversible))
      CHECK(worst > 2 * bound);
  }
}

TEST_CASE("identities of the gyroscopic updates") {
  const Vec3 I = asymmetric(), omega = Vec3(3, -2, 1);
  constexpr Real dt = Real(0.05);
  const auto energy = [&](const Vec3& w) { return energy_of({.omega = w}, I); };
  const auto L2 = [&](const Vec3& w) { return 2 * energy_of({.omega = w}, I * I); };
  const auto turning = [&](const Vec3& w) {
    return double(dt) * dt * glm::dot(glm::cross(w, I * w), glm::cross(w, I * w));
  };

  // Numbers up to 35 and their squares' sums, from some 16 roundings
  const double bound = 16 * k_u * 35;
  const Vec3 alpha = euler_equations(omega, I, Vec3(0));
  const Vec3 w = omega + dt * alpha;
  CHECK(energy(w) - energy(omega)
        == Approx(double(dt) * dt * energy(alpha)).margin(bound));
  CHECK(L2(w) - L2(omega) == Approx(turning(omega)).margin(bound));

  // Solved for the end: the signs turn round
  const Vec3 v = implicit_gyroscopic_velocity(omega, I, dt, 10);
  CHECK(energy(v) - energy(omega) == Approx(-energy(v - omega)).margin(bound));
  CHECK(L2(v) - L2(omega) == Approx(-turning(v)).margin(bound));

  // And with |L| put back, it is as it was
  CHECK(L2(rescaled_velocity(omega, I, dt)) == Approx(L2(omega)).margin(bound));
}

TEST_CASE("over a million steps energy and momentum stay where the geometry is kept") {
  constexpr int n = 1'000'000, few = 10'000;
  for (const char* name : {"lie_midpoint", "splitting", "discrete_moser_veselov"}) {
    const RotationMethod& method = rotation_method(name);
    const Drift first = drift(method, tumbling(), asymmetric(), 1.0 / 60, few);
    const Drift all = drift(method, tumbling(), asymmetric(), 1.0 / 60, n);

    // Roundings go up and down: 16 a turn add up to four times the root of their number
    const double turns = method.name == "splitting" ? 5.0 * n : n;
    const double rounding = 4 * std::sqrt(16 * turns) * k_u;
    INFO(name << ": energy " << all.energy << ", momentum " << all.momentum);
    CHECK(all.momentum <= rounding);
    CHECK(all.energy <= 1.01 * first.energy + 2 * rounding);
  }

  // Of others the energy goes its way: ten times as far in a hundred times the steps
  const RotationMethod& buss = rotation_method("buss");
  CHECK(drift(buss, tumbling(), asymmetric(), 1.0 / 60, n).energy
        > 10 * drift(buss, tumbling(), asymmetric(), 1.0 / 60, few).energy);
}

TEST_CASE("an orientation stays of length one over ten million steps") {
  Rotation r = tumbling();
  double worst = 0;
  for (int i = 0; i < 10'000'000; ++i) {
    momentum(r, asymmetric(), no_torque, 0, Real(1) / 60);
    worst = std::max(worst, std::abs(glm::length(glm::dquat(r.q)) - 1));
  }

  // Four squares, three sums, root, quotient and product: each step starts anew
  CHECK(worst <= 6 * k_u);
}

TEST_CASE("a body that flips flips 21 times in a minute") {
  // Every 2.89858 s; by 60 s the 21st flip is 0.6 s old and the 22nd 2.3 s off
  for (const char* name :
       {"implicit_gyroscopic", "explicit_midpoint_su2", "lie_midpoint", "splitting",
        "discrete_moser_veselov", "rk4"}) {
    Rotation r{.omega = {Real(0.1), 10, Real(0.1)}};
    int flips = 0;
    for (int i = 0; i < 3600; ++i) {
      const Real before = r.omega.y;
      rotation_method(name).step(r, asymmetric(), no_torque, 0, Real(1) / 60);
      if ((before > 0) != (r.omega.y > 0)) ++flips;
    }
    INFO(name);
    CHECK(flips == 21);
  }
}

TEST_CASE("at 60 Hz a free top is where it should be after 100 s") {
  const exact::Turning end = exactly(tumbling(), asymmetric(), 100);
  const auto off = [&](const char* name) {
    const Rotation r = turned(rotation_method(name), tumbling(), asymmetric(),
                              no_torque, 1.0 / 60, 6000);
    return exact::angle_between(end.q, glm::dquat(r.q));
  };

  // 4 roundings of omega a step go on as an angle: at random, each for 100 s. dt rounds
  // 1/60 and so the 134 rad
  const double rounding = k_u * (4 * 1.34 * std::sqrt(6000.0) * 100 / 2 + 134);
  CHECK(off("rk4") <= 1e-6 + rounding);
  CHECK(off("splitting") <= 1e-2);
}

TEST_CASE("a sphere, or a cube, turns about one axis at its angular velocity") {
  // By dt |omega|, but for the methods that put something simpler in place of (3.3)
  const auto turn = [](std::string_view name, double z) {
    if (name == "listing_3" || name.ends_with("t_gyroscopic"))
      return 2 * std::atan(z / 2);
    if (name == "discrete_moser_veselov") return std::asin(z);
    if (name == "rk4")
      return 2
             * std::atan2(z / 2 - z * z * z / 48, 1 - z * z / 8 + z * z * z * z / 384);
    return z;
  };
  constexpr int n = 100;
  for (const RotationMethod& method : rotation_methods())
    for (const double z : {1e-3, 0.1, 0.9}) {
      // Only the splitting turns about one axis after another even then
      const bool splits = method.name == "splitting";
      const Vec3 axis =
          splits ? Vec3(0, 1, 0) : Vec3(Real(0.48), Real(-0.6), Real(0.64));
      const Rotation start{tumbling().q, Real(2) * axis};
      const Rotation end = turned(method, start, Vec3(3), no_torque, z / 2, n);
      const double angle = n * turn(method.name, double(Real(z / 2)) * 2);
      const glm::dquat expected =
          glm::dquat(start.q)
          * glm::angleAxis(angle, glm::normalize(glm::dvec3(start.omega)));

      // 16 roundings a step of q and of omega, which goes on turning: n²/2 z
      INFO(method.name << " z " << z);
      const double bound = 16 * k_u * (n + z * n * n / 2);
      CHECK(exact::angle_between(expected, glm::dquat(end.q)) <= bound);
      CHECK(glm::length(end.omega - start.omega) <= 2 * 16 * k_u * n);
    }
}

TEST_CASE("a spin on a principal axis stays there") {
  for (const RotationMethod& method : rotation_methods()) {
    for (int axis = 0; axis < 3; ++axis) {
      Rotation start = tumbling();
      start.omega = Vec3(0);
      start.omega[axis] = 7;
      Rotation r = turned(method, start, asymmetric(), no_torque, 0.1, 1000);

      // Listing 3 goes through the world's frame and back, and so rounds all components
      INFO(method.name << " axis " << axis);
      const bool through_world = method.name == "listing_3";
      CHECK(r.omega[axis] == Approx(7).margin(1000 * 8 * k_u * 7));
      r.omega[axis] = 0;
      CHECK(glm::length(r.omega) <= (through_world ? 1000 * 8 * k_u * 7 : 0));
    }
  }
}

TEST_CASE("a body at rest stays, bit for bit") {
  for (const RotationMethod& method : rotation_methods()) {
    const Rotation start{Quat(Real(0.5), Real(-0.5), Real(0.5), Real(0.5)), Vec3(0)};
    INFO(method.name);
    CHECK(same_bits(turned(method, start, asymmetric(), no_torque, 0.1, 1000), start));

    // Where the length of q rounds off 1, normalising moves it by u, and no further
    const Rotation at_rest{tumbling().q, Vec3(0)};
    const Rotation end = turned(method, at_rest, asymmetric(), no_torque, 0.1, 10'000);
    CHECK(exact::angle_between(glm::dquat(end.q), glm::dquat(at_rest.q)) <= 8 * k_u);
    CHECK(end.omega == Vec3(0));
  }
}

TEST_CASE("a step of any length ends in a rotation, or is refused") {
  constexpr std::array<double, 9> lengths{1e-6, 0.1, 0.5, 1, 2, 3, 3.1416, 6.2832, 10};
  const std::array<Vec3, 5> shapes{Vec3(1), asymmetric(), Vec3(Real(1e-6), 1, 1),
                                   Vec3(1, 1, 2), Vec3(1, 1, Real(0.25))};
  for (const RotationMethod& method : rotation_methods())
    for (const Vec3& I : shapes)
      for (const double z : lengths) {
        INFO(method.name << ' ' << I.x << ' ' << I.z << " |omega| dt " << z);
        Rotation r{tumbling().q, {Real(0.48), Real(0.6), Real(0.64)}};
        bool refused = false;
        try {
          method.step(r, I, no_torque, 0, Real(z));
        } catch (const Unsolved&) {
          refused = true;
        }
        const bool may_refuse = (method.name == "discrete_moser_veselov" && z >= 1)
                                || (method.name == "lie_midpoint" && z > 2);
        CHECK((refused ? may_refuse : is_finite(r)));
      }
}

TEST_CASE("the discrete body refuses steps of more than a radian about an axis") {
  // a b = |omega| dt / 2 with a² + b² = 1 has a root up to 1/2: a turn of 90 degrees
  const RotationMethod& method = rotation_method("discrete_moser_veselov");
  for (const Vec3& I : {Vec3(1), asymmetric()})
    for (int axis = 0; axis < 3; ++axis) {
      Rotation start{.omega = Vec3(0)};
      start.omega[axis] = 1;
      Rotation r = start;
      CHECK_NOTHROW(method.step(r, I, no_torque, 0, Real(0.999)));
      CHECK(is_finite(r));
      r = start;
      CHECK_THROWS_AS(method.step(r, I, no_torque, 0, Real(1.001)), Unsolved);
    }
}

TEST_CASE("needles and plates of a million to one turn on, and keep what is kept") {
  const std::array<Vec3, 4> shapes{Vec3(Real(1e-6), 1, Real(1.0000005)),
                                   Vec3(1, Real(1e-6), 1), Vec3(1, 1, 2),
                                   Vec3(Real(0.5), Real(0.500001), 1)};
  for (const RotationMethod& method : rotation_methods()) {
    if (!method.keeps_momentum) continue;
    for (const Vec3& I : shapes)
      for (const double z : {1e-8, 1e-3, 0.3}) {
        // Roundings of L as in a million steps' test, here in the worst case
        const double bound = 100 * 5 * 16 * k_u;
        INFO(method.name << ' ' << I.x << ' ' << I.y << ' ' << I.z << " z " << z);
        Rotation start{tumbling().q, {Real(0.48), Real(0.6), Real(0.64)}};
        CHECK(drift(method, start, I, z, 100).momentum <= bound);
      }
  }
}

TEST_CASE("only ratios of inertia and torque matter, to the last bit") {
  constexpr Real scale = Real(1LL << 40);
  const Torque torque = [](const Quat& q, Real t) { return stirred_compass(q, t); };
  const Torque scaled = [](const Quat& q, Real t) {
    return scale * stirred_compass(q, t);
  };
  for (const RotationMethod& method : rotation_methods()) {
    const Rotation a = turned(method, tumbling(), asymmetric(), torque, 0.05, 200);
    const Rotation b =
        turned(method, tumbling(), scale * asymmetric(), scaled, 0.05, 200);
    INFO(method.name);
    CHECK(same_bits(a, b));
  }
}
