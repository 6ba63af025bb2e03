// Chapter 3's exact motions: tops without torque and with weight, and the cue ball.
// They are double whatever the precision of the rest; u is its unit round-off.
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "common/physics/exact_cue_ball.hpp"
#include "common/physics/exact_elliptic.hpp"
#include "common/physics/exact_free_top.hpp"
#include "common/physics/exact_heavy_top.hpp"
#include "common/physics/exact_pendulum.hpp"
#include "tests/catch.hpp"

using namespace timestep::exact;
using glm::dquat;
using glm::dvec3;

namespace {

constexpr double k_pi = std::numbers::pi;
constexpr double k_u = 1.1102230246251565e-16;

// A rate is known to a few roundings, and so is the angle that it turns through
double angle_tolerance(double angle) {
  return 32 * k_u * (1 + std::abs(angle));
}

dquat about_x(double angle) {
  return {std::cos(angle / 2), std::sin(angle / 2), 0, 0};
}

void check_same(const Turning& got, const Turning& want, double tolerance) {
  CHECK(angle_between(got.q, want.q) <= tolerance);
  CHECK(glm::distance(got.omega, want.omega)
        <= tolerance * (1 + glm::length(want.omega)));
}

// An independent motion: the Taylor series of omega, of the world's up as the body sees
// it and of q, in long double. A body of moments I whose centre of mass is `weight` / m
// g up its third axis from the pivot.
//
// Where no difference of moments is more than twice the third moment, and `rate` is no
// less than |omega| and the frequency of swinging, the terms fall at least as
// (4 rate h)^k: 24 of them at rate h = 1/24 leave 6^-24 = 2e-19 of each step, as much
// as a step rounds where long double has 64 bits.
class Series {
 public:
  Series(const dvec3& I, double weight, const Turning& start) : weight_(weight) {
    moments_ = {I.x, I.y, I.z};
    const dvec3 up = glm::conjugate(start.q) * dvec3(0, 0, 1);
    y_ = {start.omega.x, start.omega.y, start.omega.z, up.x,      up.y,
          up.z,          start.q.w,     start.q.x,     start.q.y, start.q.z};
  }

  Turning after(double t, double rate) {
    const int n = 1 + int(24 * rate * std::abs(t));
    for (int i = 0; i < n; ++i) step(static_cast<long double>(t) / n);
    const auto number = [&](std::size_t i) { return double(y_[i]); };
    return {{number(6), number(7), number(8), number(9)},
            {number(0), number(1), number(2)}};
  }

 private:
  static constexpr std::size_t k_terms = 24;
  using Terms = std::array<long double, k_terms + 1>;

  // The k-th term of a product
  static long double of(const Terms& a, const Terms& b, std::size_t k) {
    long double sum = 0;
    for (std::size_t i = 0; i <= k; ++i) sum += a[i] * b[k - i];
    return sum;
  }

  void step(long double h) {
    std::array<Terms, 10> s{};
    for (std::size_t i = 0; i < 10; ++i) s[i][0] = y_[i];
    const auto& [x, y, z, ux, uy, uz, qw, qx, qy, qz] = s;
    for (std::size_t k = 0; k < k_terms; ++k) {
      const std::array<long double, 10> rate{
          ((moments_[1] - moments_[2]) * of(y, z, k) + weight_ * uy[k]) / moments_[0],
          ((moments_[2] - moments_[0]) * of(z, x, k) - weight_ * ux[k]) / moments_[1],
          (moments_[0] - moments_[1]) * of(x, y, k) / moments_[2],
          of(uy, z, k) - of(uz, y, k),
          of(uz, x, k) - of(ux, z, k),
          of(ux, y, k) - of(uy, x, k),
          -(of(qx, x, k) + of(qy, y, k) + of(qz, z, k)) / 2,
          (of(qw, x, k) + of(qy, z, k) - of(qz, y, k)) / 2,
          (of(qw, y, k) + of(qz, x, k) - of(qx, z, k)) / 2,
          (of(qw, z, k) + of(qx, y, k) - of(qy, x, k)) / 2};
      for (std::size_t i = 0; i < 10; ++i)
        s[i][k + 1] = h * rate[i] / static_cast<long double>(k + 1);
    }
    for (std::size_t i = 0; i < 10; ++i) {
      y_[i] = 0;
      for (std::size_t k = k_terms + 1; k-- > 0;) y_[i] += s[i][k];
    }
  }

  std::array<long double, 3> moments_{};
  long double weight_;
  std::array<long double, 10> y_{};
};

const dquat k_tilted = glm::normalize(dquat(0.5, -0.5, 0.1, 0.3));

// (3.29) The free symmetric top: about the axis in the body, and about L in the world
Turning symmetric_top(double I1, double I3, const Turning& start, double t) {
  const dvec3 L = start.q * (dvec3(I1, I1, I3) * start.omega);
  const double angle = glm::length(L) / I1 * t;
  const double own = (1 - I3 / I1) * start.omega.z * t;
  const dquat about_momentum(std::cos(angle / 2),
                             std::sin(angle / 2) * L / (1e-300 + glm::length(L)));
  return {about_momentum * start.q * about_z(own),
          glm::conjugate(about_z(own)) * start.omega};
}

constexpr HeavyTop k_top{.I1 = 0.05, .I3 = 0.01, .mass = 1, .g = 9.81, .l = 0.2};

Turning heavy_turning(const HeavyTop& top, const HeavyTopStart& start, double t) {
  return turning(heavy_top(top, start, t), start.omega3);
}

constexpr Ball k_ball{.mass = 0.17, .radius = 0.028575, .k = 0.4, .mu = 0.2, .g = 9.81};

}  // namespace

TEST_CASE("angles between attitudes and between vectors, small and large") {
  // Two products of quaternions of length 1: each number a sum of four products, 4 u,
  // each quaternion 8 u; an angle is twice as large, and rounds in 3 operations itself
  constexpr double k_tolerance = 2 * (8 + 8) * k_u + 3 * 3 * k_u;
  for (const double angle : {0.0, 1e-9, 1.0, 3.0}) {
    const dquat turned = k_tilted * about_z(angle);
    CHECK(std::abs(angle_between(k_tilted, turned) - angle) <= k_tolerance);
    CHECK(std::abs(angle_between(k_tilted, -turned) - angle) <= k_tolerance);
    const dvec3 a(1, 0, 0);
    const dvec3 b(2 * std::cos(angle), 2 * std::sin(angle), 0);
    CHECK(std::abs(angle_between(a, b) - angle) <= k_tolerance);
  }
  CHECK(angle_between(dvec3(0), dvec3(1, 0, 0)) == 0);
}

TEST_CASE("Carlson's integrals have their published values") {
  // Carlson (1995), section 3
  CHECK(carlson_rc(0, 0.25) == Approx(k_pi).epsilon(4 * k_u));
  CHECK(carlson_rc(2.25, 2) == Approx(std::log(2.0)).epsilon(4 * k_u));
  CHECK(carlson_rf(1, 2, 0) == Approx(1.3110287771461).epsilon(1e-13));
  CHECK(carlson_rj(0, 1, 2, 3) == Approx(0.77688623778582).epsilon(1e-13));
  CHECK(carlson_rj(2, 3, 4, 5) == Approx(0.14297579667157).epsilon(1e-13));

  // R_C where its two arguments meet, and R_J where two of its own do
  for (const double e : {1e-3, 1e-8, 1e-15, 0.0, -1e-15, -1e-8})
    CHECK(carlson_rc(1, 1 + e) == Approx(1 - e / 3 + e * e / 5).epsilon(1e-9));
  CHECK(carlson_rj(2, 2, 2, 2) == Approx(std::pow(2, -1.5)).epsilon(4 * k_u));

  // R_J by R_C where two arguments are equal (NIST 19.20.8); at most a digit cancels
  for (int i = 0; i < 20; ++i) {
    const double p = 3 * std::pow(1.3, i);
    CHECK(carlson_rj(1, 2, 2, p)
          == Approx(3 / (p - 2) * (carlson_rc(1, 2) - carlson_rc(1, p)))
                 .epsilon(32 * k_u));
  }
  CHECK(carlson_rj(0, 1, 1, std::numeric_limits<double>::infinity()) == 0);
}

TEST_CASE("the parts of the third kind are the integrals that they say") {
  // Simpson's rule: 4000 panels of a smooth function of two quarters leave less than
  // 1e-11 where its fastest scale, 1 / sqrt(1 - n), is still 50 panels
  for (const double m1 : {1.0, 0.7, 0.1, 1e-3}) {
    const Elliptic elliptic{1 - m1, m1};
    for (const double n1 : {0.2, 1.0, 3.0, 400.0}) {
      const double w = 2.7 * elliptic.quarter();
      const int panels = 4000;
      double sine = 0, cosine = 0;
      for (int i = 0; i <= panels; ++i) {
        const Jacobi at = elliptic.jacobi(w * i / panels);
        const double weight = i == 0 || i == panels ? 1 : i % 2 == 1 ? 4 : 2;
        const double below = at.cn * at.cn + n1 * at.sn * at.sn;
        sine += weight * at.sn * at.sn / below;
        cosine += weight * at.cn * at.cn / below;
      }
      INFO("m1 " << m1 << " n1 " << n1);
      CHECK(elliptic.sine_part(n1, w)
            == Approx(sine * w / panels / 3).epsilon(1e-9).margin(1e-11));
      CHECK(elliptic.cosine_part(n1, w)
            == Approx(cosine * w / panels / 3).epsilon(1e-9).margin(1e-11));
    }
  }
}

TEST_CASE("free tops turn as the tables say") {
  // I = (1, 2, 2.5), omega = (0.4, 1, 0.8): the numbers of tests/truth, 17 digits
  const dvec3 I{1, 2, 2.5};
  const Turning start{{1, 0, 0, 0}, {0.4, 1, 0.8}};
  const Turning soon = free_top(I, start, 0.5);
  check_same(soon,
             {{0.9450226807924361, 0.0721865382162352, 0.2559369154007558,
               0.19030904293642975},
              {0.19939550262703815, 1.0864447295183342, 0.7374326092425744}},
             angle_tolerance(0.7));
  check_same(free_top(I, start, 5),
             {{0.7715773115629998, -0.605063836969635, 0.18432224261079316,
               -0.0677607286835418},
              {-0.6909675969458696, -0.72377183556441, 0.9454887498131958}},
             angle_tolerance(7));
  CHECK(angle_between(free_top(I, start, 100).q,
                      {0.4581603824572835, -0.591260027834574, 0.0009510606873969974,
                       -0.6637015435534435})
        <= angle_tolerance(140));

  const FreeTopMotion motion = free_top_motion(I, start.omega);
  CHECK(motion.period == Approx(11.530427938270273).epsilon(8 * k_u));
  CHECK(motion.m == Approx(0.5636363636363636).epsilon(8 * k_u));
  CHECK(motion.circulating_axis == 2);
}

TEST_CASE("free tops agree with an independent integration in every order of moments") {
  const dvec3 omega{0.9, -1.1, 0.7};
  for (const dvec3& I : {dvec3(1, 2, 2.5),
                         {1, 2.5, 2},
                         {2, 1, 2.5},
                         {2, 2.5, 1},
                         {2.5, 1, 2},
                         {2.5, 2, 1},
                         {1, 1.8, 1.8},
                         {1.8, 1, 1},
                         {1, 1, 1.8},
                         {1.8, 1, 1.8},
                         {1, 1, 1}}) {
    for (const dvec3& signs : {dvec3(1, 1, 1), {-1, 1, 1}, {1, -1, -1}, {-1, -1, -1}}) {
      for (const double t : {0.7, 20.0, -3.0}) {
        const Turning start{k_tilted, signs * omega};
        INFO(I.x << ' ' << I.y << ' ' << I.z << " t " << t);
        check_same(free_top(I, start, t), Series(I, 0, start).after(t, 1.7),
                   angle_tolerance(2 * 1.7 * t));
      }
    }
  }
}

TEST_CASE("free tops keep L and energy at every time") {
  // Neither depends on how well the phase is known: 1e9 s are as good as one
  for (const dvec3& I : {dvec3(1, 2, 2.5), {2e-6, 1, 1.000001}, {3, 3.5, 1e-3}}) {
    for (const dvec3& omega : {dvec3(0.9, -1.1, 0.7), {1e-7, 3, 0}, {5, 1e-3, 1e-3}}) {
      const dvec3 L = k_tilted * (I * omega);
      const double energy = glm::dot(omega, I * omega);
      for (const double t : {0.0, 1e-9, 1.0, -77.0, 1e4, 1e9}) {
        const Turning now = free_top(I, {k_tilted, omega}, t);
        INFO(I.x << ' ' << omega.x << " t " << t);
        CHECK(glm::distance(now.q * (I * now.omega), L) <= 32 * k_u * glm::length(L));
        CHECK(glm::dot(now.omega, I * now.omega) == Approx(energy).epsilon(32 * k_u));
        CHECK(glm::length(now.q) == Approx(1).epsilon(8 * k_u));
      }
    }
  }
}

TEST_CASE("free tops go on from where they came, and back") {
  const dvec3 I{2.5, 1, 2};
  for (const dvec3& omega : {dvec3(1, -2, 0.5), {3, 0.1, 0.2}, {0, 1, 0.01}}) {
    const Turning start{k_tilted, omega};
    const double rate = glm::length(omega);
    for (const double t : {0.3, 4.0, 30.0}) {
      // What the first half rounds, the second half enlarges by what a change of omega
      // changes: at most in proportion to the angle
      const Turning whole = free_top(I, start, 2 * t);
      const Turning halves = free_top(I, free_top(I, start, t), t);
      const double tolerance = angle_tolerance(2 * rate * t) * (1 + 2 * rate * t);
      INFO(omega.x << " t " << t);
      check_same(halves, whole, tolerance);
      check_same(free_top(I, whole, -2 * t), start, tolerance);
    }

    const double period = free_top_motion(I, omega).period;
    const Turning later = free_top(I, start, 3 * period);
    CHECK(glm::distance(later.omega, omega)
          <= rate * angle_tolerance(3 * rate * period));
  }
}

TEST_CASE("free symmetric tops are the limit of asymmetric ones, and spheres theirs") {
  const dvec3 omega{0.4, -0.9, 2};
  for (const double t : {0.5, 10.0}) {
    const Turning start{k_tilted, omega};
    const double angle = 3 * t;
    const Turning disc = symmetric_top(1, 1.8, start, t);
    check_same(free_top({1, 1, 1.8}, start, t), disc, angle_tolerance(angle));

    // A moment changed by e changes the angle by no more than 2 e of it
    for (const double e : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
      INFO("e " << e << " t " << t);
      const double tolerance = angle_tolerance(angle) + 2 * e * angle;
      check_same(free_top({1, 1 + e, 1.8}, start, t), disc, tolerance);
      check_same(free_top({1, 1 - e, 1.8}, start, t), disc, tolerance);
      check_same(free_top({1, 1 + e, 1 + 2 * e}, start, t),
                 free_top({1, 1, 1}, start, t), tolerance);
    }

    // A sphere's omega stays
    const Turning sphere = free_top({1, 1, 1}, start, t);
    CHECK(sphere.omega == omega);
    check_same(sphere, symmetric_top(1, 1, start, t), angle_tolerance(angle));
  }
}

TEST_CASE("free tops that spin about a principal axis go on so, or not at all") {
  for (const dvec3& I : {dvec3(1, 2, 2.5), {2, 1, 1}, {1, 1, 1}}) {
    for (const dvec3& omega : {dvec3(3, 0, 0), {0, -3, 0}, {0, 0, 3}, {0, 0, 0}}) {
      const Turning now = free_top(I, {k_tilted, omega}, 7);
      CHECK(now.omega == omega);
      const dvec3 half = 3.5 * omega;
      const double s = std::sin(glm::length(half)) / (1e-300 + glm::length(half));
      CHECK(
          angle_between(now.q, k_tilted * dquat(std::cos(glm::length(half)), s * half))
          <= angle_tolerance(21));
    }
  }

  // Beside a stable axis omega circles it, however small the circle
  for (const double e : {1e-3, 1e-9, 1e-50}) {
    const Turning now = free_top({1, 2, 2.5}, {{1, 0, 0, 0}, {e, 0, 4}}, 0.6);
    const double lambda = 4 * std::sqrt(0.5 * 1.5 / 2);
    CHECK(now.omega.x == Approx(e * std::cos(0.6 * lambda)).epsilon(4 * e * e + 1e-14));
  }
}

TEST_CASE("on the separatrix a free top goes to its middle axis and stays") {
  // I1 (I2 - I1) omega1² = I3 (I3 - I2) omega3² without rounding
  const dvec3 I{1, 2, 2.25}, omega{0.75, 0, 1};
  const double lambda = std::sqrt(1.25 * 0.25 / 2);
  const FreeTopMotion motion = free_top_motion(I, omega);
  CHECK(motion.m == Approx(1).epsilon(4 * k_u));
  CHECK(std::isinf(motion.period));
  for (const double t : {0.5, 10.0, -40.0, 2000.0}) {
    const Turning now = free_top(I, {k_tilted, omega}, t);

    // Below 1e-150 it is as good as there
    CHECK(glm::length(now.q) == Approx(1).epsilon(8 * k_u));
    const double left = 1 / std::cosh(lambda * t);
    CHECK(now.omega.x == Approx(0.75 * left).epsilon(1e-13).margin(1e-150));
    CHECK(now.omega.z == Approx(left).epsilon(1e-13).margin(1e-150));
    if (std::abs(t) < 20)
      check_same(now, Series(I, 0, {k_tilted, omega}).after(t, 1.3),
                 angle_tolerance(1.3 * t) * std::cosh(lambda * t));

    // Next to it, what differs at first grows as cosh
    for (const double e : {1e-12, -1e-12})
      if (std::abs(t) < 20)
        check_same(
            free_top(I, {k_tilted, {0.75, 0, 1 + e}}, t), now,
            (std::abs(e) + angle_tolerance(1.3 * t)) * 4 * std::cosh(lambda * t));
  }
}

TEST_CASE("free tops know on which side of the separatrix they are") {
  // As above but that 0.75 * 1.1 is rounded: what that differs by at first is 1e5 times
  // as much after 30 s, and so are the roundings of the series
  const dvec3 I{1, 2, 2.25};
  constexpr double k_long = std::numeric_limits<long double>::epsilon();
  for (const double rate : {1.1, -0.7, 1.3}) {
    const Turning start{k_tilted, {0.75 * rate, 0, rate}};
    const double growth = std::cosh(std::sqrt(1.25 * 0.25 / 2) * rate * 30);
    check_same(free_top(I, start, 30), Series(I, 0, start).after(30, 1.7),
               angle_tolerance(1.7 * 30) + 8 * k_long * growth);
  }
}

TEST_CASE("a book flips at the intervals of the tables") {
  // I = (1, 2, 2.5), 5 rad/s about the middle axis, eps about the first
  const dvec3 I{1, 2, 2.5};
  const std::array<std::array<double, 2>, 4> table{{{0.1, 4.557080307807958},
                                                    {0.01, 6.617115743088258},
                                                    {1e-3, 8.676618927137815},
                                                    {1e-5, 12.795608477382727}}};
  for (const auto& [eps, interval] : table) {
    const dvec3 omega{eps, 5, 0};
    CHECK(flip_interval(I, omega) == Approx(interval).epsilon(16 * k_u));

    // Every flip leads to the mirror image, the tenth as well
    for (const int flips : {1, 2, 10}) {
      const Turning now = free_top(I, {k_tilted, omega}, flips * interval);
      const double sign = flips % 2 == 0 ? 1 : -1;

      // The 17th digit of 10 intervals, and the rate 5 sqrt(1/5) at which eps grows
      const double late = 4 * k_u * flips * interval * 5 * std::sqrt(0.2);
      CHECK(now.omega.y == Approx(5 * sign).epsilon(angle_tolerance(50 * flips)));
      CHECK(now.omega.x == Approx(eps).margin(5 * late));
    }
  }
  CHECK(std::isinf(flip_interval(I, {0, 5, 0})));
  CHECK(std::isinf(flip_interval({1, 1, 1}, {1, 2, 3})));
}

TEST_CASE("heavy tops precess steadily at the rates of the tables") {
  const auto rates = steady_precession(k_top, 0.5, 200);
  REQUIRE(rates);
  CHECK(rates->slow == Approx(1.003074685997938).epsilon(8 * k_u));
  CHECK(rates->fast == Approx(44.57668240698403).epsilon(8 * k_u));
  CHECK(least_steady_spin(k_top, 0.5) == Approx(58.68248437871238).epsilon(8 * k_u));
  CHECK(least_steady_spin(k_top, 0) == Approx(62.64183905346331).epsilon(8 * k_u));
  CHECK(least_steady_spin(k_top, 2) == 0);
  CHECK_FALSE(steady_precession(k_top, 0.5, 58.6));

  // Let go at those rates, it keeps them: pull, what is left of them, is round-off
  for (const double theta : {0.3, 1.5, 2.5}) {
    for (const double omega3 : {70.0, -200.0}) {
      const auto steady = steady_precession(k_top, theta, omega3);
      REQUIRE(steady);
      for (const double rate : {steady->slow, steady->fast}) {
        const HeavyTopAngles now = heavy_top(k_top, {theta, rate, omega3}, 3);
        const double tolerance = angle_tolerance(3 * (200 + std::abs(rate)));
        CHECK(now.theta == Approx(theta).margin(tolerance));
        CHECK(now.phi == Approx(3 * rate).margin(tolerance));
      }
    }
  }
}

TEST_CASE("heavy tops agree with an independent integration from every start") {
  const double weight = k_top.mass * k_top.g * k_top.l;
  const dvec3 I{k_top.I1, k_top.I1, k_top.I3};
  for (const double theta : {1e-4, 0.5, 1.6, 3.0, k_pi}) {
    for (const double phi_rate : {0.0, 9.0, -4.0}) {
      for (const double omega3 : {0.0, 20.0, -70.0}) {
        const HeavyTopStart start{theta, phi_rate, omega3};
        const Turning first = heavy_turning(k_top, start, 0);
        CHECK(angle_between(first.q, about_x(theta)) <= 4 * k_u);
        for (const double t : {0.3, -0.4}) {
          // A weak top leaves upright as exp(6.3 t), a hundredfold in 0.73 s
          const double rate = std::abs(omega3) + std::abs(phi_rate) + 20;
          const double tolerance = angle_tolerance(rate * t) * std::cosh(6.3 * t);
          INFO(theta << ' ' << phi_rate << ' ' << omega3 << " t " << t);
          check_same(heavy_turning(k_top, start, t),
                     Series(I, weight, first).after(t, rate), tolerance);
        }
      }
    }
  }
}

TEST_CASE("heavy tops keep energy and the upright part of L, between their two tilts") {
  for (const HeavyTopStart& start : {HeavyTopStart{0.5, 0, 60},
                                     {0.5, 9, 60},
                                     {2, -4, 80},
                                     {1e-3, 0, 50},
                                     {1.2, 0, 2440}}) {
    const auto energy = [&](const HeavyTopAngles& at) {
      const double across = at.phi_rate * std::sin(at.theta);
      return k_top.I1 / 2 * (at.theta_rate * at.theta_rate + across * across)
             + k_top.mass * k_top.g * k_top.l * std::cos(at.theta);
    };
    const auto upright = [&](const HeavyTopAngles& at) {
      const double s = std::sin(at.theta);
      return k_top.I1 * at.phi_rate * s * s
             + k_top.I3 * start.omega3 * std::cos(at.theta);
    };
    const auto [least, most, period] = nutation(k_top, start);
    const HeavyTopAngles first = heavy_top(k_top, start, 0);
    for (const double t : {0.1, 0.7, 33.3, 1e4}) {
      const HeavyTopAngles now = heavy_top(k_top, start, t);
      CHECK(energy(now) == Approx(energy(first)).epsilon(64 * k_u));
      CHECK(upright(now) == Approx(upright(first)).epsilon(64 * k_u));

      // However many turns psi counts, q and omega tell the same
      const Turning turned = turning(now, start.omega3);
      const dvec3 L = dvec3(k_top.I1, k_top.I1, k_top.I3) * turned.omega;
      CHECK((turned.q * L).z == Approx(upright(first)).epsilon(64 * k_u));
      CHECK(now.theta >= least * (1 - 8 * k_u));
      CHECK(now.theta <= most * (1 + 8 * k_u));
    }

    // Half a period leads from one tilt to the other
    const double other = start.theta == least ? most : least;
    CHECK(heavy_top(k_top, start, period / 2).theta == Approx(other).epsilon(16 * k_u));
    CHECK(heavy_top(k_top, start, period).theta
          == Approx(start.theta).epsilon(angle_tolerance(20 * period) / start.theta));
  }
}

TEST_CASE("a heavy top without spin is a pendulum, through hanging and on") {
  const double omega0 = std::sqrt(k_top.mass * k_top.g * k_top.l / k_top.I1);
  for (const double theta : {0.01, 1.0, 3.0}) {
    for (const double t : {0.2, 0.9, 5.0}) {
      const Coordinate swing = pendulum({k_pi - theta, 0}, omega0, t);
      const Turning now = heavy_turning(k_top, {theta, 0, 0}, t);

      // Started 0.01 rad from the top, the 16th digit of pi is 4e-14 of that
      const double tolerance = angle_tolerance(20 * t) + 1e-13;
      CHECK(angle_between(now.q, about_x(k_pi - swing.x)) <= tolerance);
      CHECK(now.omega.z == 0);
      CHECK(std::hypot(now.omega.x, now.omega.y)
            == Approx(std::abs(swing.v)).margin(omega0 * tolerance));
    }
    CHECK(nutation(k_top, {theta, 0, 0}).period
          == Approx(pendulum_period({k_pi - theta, 0}, omega0) / 2).epsilon(1e-13));
  }
}

TEST_CASE("heavy tops that just miss hanging keep their digits there") {
  // y is (Lz + I3 omega3) / I1 (1 - cos theta), what keeps it from hanging
  for (const double theta : {0.4, 1.0, 2.0}) {
    for (const double omega3 : {0.0, 20.0, -50.0}) {
      for (const double y : {1e-7, -1e-5, 0.0}) {
        const double above = 1 - std::cos(theta);
        const double a = k_top.I3 / k_top.I1 * omega3;
        const HeavyTopStart start{theta, (y - a) / above, omega3};
        const HeavyTopAngles low =
            heavy_top(k_top, start, nutation(k_top, start).period / 2);
        const Turning now = turning(low, omega3);

        // By energy; y itself is a difference, but the speed does not depend on it
        const double across = start.phi_rate * std::sin(theta);
        const double fall = std::cos(theta) - std::cos(low.theta);
        const double speed = std::sqrt(
            across * across + 2 * k_top.mass * k_top.g * k_top.l / k_top.I1 * fall);
        INFO(theta << ' ' << omega3 << ' ' << y);
        CHECK(std::hypot(now.omega.x, now.omega.y)
              == Approx(speed).epsilon(angle_tolerance(50)));
        CHECK(low.theta == Approx(k_pi).margin(1e-4));
        CHECK(std::isfinite(low.theta_rate));
      }
    }
  }
}

TEST_CASE("heavy tops: no weight, asleep, hanging, at rest") {
  // Without weight it is a free symmetric top
  HeavyTop light = k_top;
  light.l = 0;
  const HeavyTopStart start{0.5, 9, 60};
  check_same(
      heavy_turning(light, start, 1.3),
      free_top({k_top.I1, k_top.I1, k_top.I3}, heavy_turning(light, start, 0), 1.3),
      angle_tolerance(90));

  // Upright or hanging it spins on, however slowly
  for (const double theta : {0.0, k_pi}) {
    for (const double omega3 : {0.0, 10.0, 62.6, 100.0}) {
      for (const double phi_rate : {0.0, 3.0}) {
        const Turning now = heavy_turning(k_top, {theta, phi_rate, omega3}, 2);
        CHECK(angle_between(now.q, about_x(theta) * about_z(2 * omega3))
              <= angle_tolerance(2 * omega3) * 4);
        CHECK(glm::distance(now.omega, {0, 0, omega3}) <= 1e-14 * (1 + phi_rate));
      }
    }
  }

  const HeavyTop nothing{.I1 = 1, .I3 = 1, .mass = 1, .g = 0, .l = 1};
  const HeavyTopAngles rest = heavy_top(nothing, {1, 0, 0}, 5);
  CHECK(rest.theta == Approx(1).epsilon(4 * k_u));
  CHECK(rest.phi == 0);
  CHECK(rest.psi == 0);
  CHECK_FALSE(steady_precession(nothing, 1, 0));
}

TEST_CASE("exact tops answer with numbers at the ends of the range of a double") {
  for (const double scale : {1e-120, 1.0, 1e120}) {
    for (const dvec3& omega : {dvec3(1e-300, 1, 0),
                               {1e-160, 1, 1e-160},
                               {1, 1e-30, 0},
                               {5e-324, 5e-324, 5e-324},
                               {1, 1, 1e-300}}) {
      for (const double t : {1e-300, 1.0, 2000.0, 1e30}) {
        const Turning now = free_top({1, 2, 2.5}, {k_tilted, scale * omega}, t / scale);
        CHECK(glm::length(now.q) == Approx(1).epsilon(8 * k_u));
        CHECK(std::isfinite(glm::length(now.omega / scale)));
      }
    }
  }
  for (const double theta : {1e-300, 1e-160, 1e-9}) {
    for (const double rate : {0.0, 1e-300, 1e3}) {
      const Turning now = heavy_turning(k_top, {theta, rate, -rate}, 2);
      CHECK(glm::length(now.q) == Approx(1).epsilon(8 * k_u));
      CHECK(std::isfinite(glm::length(now.omega)));
    }
  }
}

TEST_CASE("a struck ball slides, then rolls, at the speeds of the tables") {
  // Struck in the middle it keeps 5/7 of its speed
  const BallMotion middle = struck(k_ball, 0.3, 0, 0);
  const double rolling = time_until_rolling(k_ball, middle);
  CHECK(middle.v.x == Approx(1.764705882352941).epsilon(4 * k_u));
  CHECK(rolling == Approx(0.2569835273558964).epsilon(8 * k_u));
  CHECK(slide_then_roll(k_ball, middle, rolling).v.x
        == Approx(1.2605042016806722).epsilon(8 * k_u));
  CHECK(slide_then_roll(k_ball, struck(k_ball, 0.3, 0.02, 0), 1).v.x
        == Approx(2.1427468625245374).epsilon(8 * k_u));

  // At 2 r / 5 it rolls at once
  CHECK(rolling_height(k_ball) == Approx(0.01143).epsilon(4 * k_u));
  const BallMotion natural = struck(k_ball, 0.3, rolling_height(k_ball), 0);
  CHECK(slide_then_roll(k_ball, natural, 1).v.x
        == Approx(natural.v.x).epsilon(8 * k_u));
}

TEST_CASE(
    "a sliding ball curves with constant friction and keeps what friction cannot") {
  const BallMotion start{{0, 0, 0.028575}, {2, 0.5, 0}, {60, -30, 80}};
  const double rolling = time_until_rolling(k_ball, start);
  const dvec3 before = slip(k_ball, start);
  const double r = k_ball.radius;
  for (const double part : {0.0, 0.1, 0.5, 0.999, 1.0, 1.5}) {
    const double t = part * rolling;
    const BallMotion now = slide_then_roll(k_ball, start, t);

    // The slip shrinks in its own direction, and the spin about the vertical stays
    const double left = std::max(0.0, 1 - part);
    CHECK(glm::distance(slip(k_ball, now), left * before) <= 1e-14 * 4);
    CHECK(now.omega.z == start.omega.z);

    // So does angular momentum about the table
    CHECK(now.v.x + k_ball.k * r * now.omega.y
          == Approx(start.v.x + k_ball.k * r * start.omega.y).epsilon(1e-14));
    CHECK(now.v.y - k_ball.k * r * now.omega.x
          == Approx(start.v.y - k_ball.k * r * start.omega.x).margin(1e-14));

    // Friction is mu g while it slides; the place is the integral of the velocity
    const double sliding = std::min(t, rolling);
    CHECK(glm::distance(now.v, start.v)
          == Approx(k_ball.mu * k_ball.g * sliding).margin(1e-14));
    const dvec3 slid = (start.v + now.v) / 2.0 * sliding + now.v * (t - sliding);
    CHECK(glm::distance(now.x, start.x + slid) <= 1e-14);
  }
}

TEST_CASE("balls without friction, and balls that roll or rest already") {
  Ball ice = k_ball;
  ice.mu = 0;
  const BallMotion start = struck(ice, 0.3, 0.01, 0.01);
  CHECK(std::isinf(time_until_rolling(ice, start)));
  const BallMotion later = slide_then_roll(ice, start, 2);
  CHECK(later.v == start.v);
  CHECK(later.omega == start.omega);
  CHECK(later.x.x == Approx(2 * start.v.x).epsilon(4 * k_u));

  const BallMotion rest = struck(k_ball, 0, 0.01, 0.01);
  CHECK(time_until_rolling(k_ball, rest) == 0);
  CHECK(slide_then_roll(k_ball, rest, 5).x == rest.x);
  const BallMotion rolls{{0, 0, 0.5}, {0, 2, 0}, {-4, 0, 7}};
  const Ball half{.mass = 1, .radius = 0.5, .k = 0.4, .mu = 1, .g = 10};
  CHECK(slide_then_roll(half, rolls, 3).x == dvec3(0, 6, 0.5));

  // Side strikes leave a spin about the vertical, to the right for the left
  CHECK(struck(k_ball, 0.3, 0, 0.01).omega.z < 0);
}
