// Chapter 6's exact bounces, rows of balls, sliding and piles: what each law says of
// its own solution, and numbers by other ways. They are double whatever the precision
// of the rest; u (k_u) is its unit round-off.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "common/physics/exact_bounce.hpp"
#include "common/physics/exact_sliding.hpp"
#include "tests/catch.hpp"

using namespace timestep::exact;
using glm::dvec2;

namespace {

constexpr double k_u = 1.1102230246251565e-16;
constexpr double k_pi = std::numbers::pi;

using Numbers = std::vector<double>;

double momentum(const Numbers& m, const Numbers& v) {
  double sum = 0;
  for (std::size_t i = 0; i < m.size(); ++i) sum += m[i] * v[i];
  return sum;
}

double energy(const Numbers& m, const Numbers& v) {
  double sum = 0;
  for (std::size_t i = 0; i < m.size(); ++i) sum += m[i] * v[i] * v[i] / 2;
  return sum;
}

// Rows of 2 to 9 balls, of masses over 2 `decades` decades
class Rows {
 public:
  explicit Rows(double decades) : decades_(decades) {}

  std::size_t length() { return 2 + random_() % 8; }
  Numbers masses(std::size_t n) {
    Numbers m(n);
    for (double& each : m) each = std::pow(10, decades_ * number());
    return m;
  }
  Numbers velocities(std::size_t n) {
    Numbers v(n);
    for (double& each : v) each = random_() % 4 == 0 ? 0 : number();
    return v;
  }

 private:
  double number() { return 2 * double(random_()) / double(std::mt19937::max()) - 1; }

  double decades_;
  std::mt19937 random_{6};
};

}  // namespace

TEST_CASE("a ball's impacts follow from each other") {
  for (const double e : {0.0, 1e-9, 0.5, 0.999, 1 - 1e-12, 1.0}) {
    for (const double height : {1e-6, 1.0, 1e6}) {
      const BouncingBall ball{height, e, 9.81};
      const double first = std::sqrt(2 * height / 9.81);
      long double time = first, flight = 2 * first, path = height;
      INFO("e " << e << " height " << height);
      for (int n = 1; n <= 200; ++n) {
        // The flight between impacts takes e of the one before, and e^2 of its height;
        // sums of 200 terms of one sign round no more than each of them
        const double speed = rebound_speed(ball, n);
        CHECK(impact_time(ball, n) == Approx(double(time)).epsilon(512 * k_u));
        CHECK(apex_height(ball, n)
              == Approx(speed * speed / (2 * 9.81)).epsilon(512 * k_u).margin(1e-300));
        flight *= e;
        time += flight;
        path += 2 * apex_height(ball, n);
      }

      // All the rest is e^200 of it
      if (e > 0.6) continue;
      CHECK(rest_time(ball) == Approx(double(time)).epsilon(8 * k_u));
      CHECK(total_distance(ball) == Approx(double(path)).epsilon(8 * k_u));
    }
  }

  // The 9999 powers added up with 30 digits (mpmath)
  const BouncingBall long_lived{2, 0.9999, 9.81};
  CHECK(impact_time(long_lived, 10000)
        == Approx(8072.41885765999254).epsilon(16 * k_u));
  CHECK(std::isinf(rest_time({1, 1, 9.81})));
  CHECK(std::isinf(total_distance({1, 1, 9.81})));
}

TEST_CASE("a ball flies from impact to impact and then lies") {
  for (const double e : {0.0, 0.01, 0.5, 0.9, 0.999, 1.0}) {
    const BouncingBall ball{2, e, 9.81};
    const double first = impact_time(ball, 1);
    INFO("e " << e);
    CHECK(bouncing_ball(ball, 0).x == 2);
    for (const double part : {0.1, 0.5, 0.99})
      CHECK(bouncing_ball(ball, part * first).x
            == Approx(2 * (1 - part * part)).margin(16 * k_u));
    for (const int n : {1, 2, 3, 10, 50}) {
      const double speed = rebound_speed(ball, n);
      const double from = impact_time(ball, n);
      const double flight = 2 * speed / 9.81;
      if (flight < 1e-6 * from) break;

      // Times are known to 64 u of what has passed, heights to the speed times that
      for (const double part : {0.01, 0.25, 0.5, 0.99}) {
        const auto [x, v] = bouncing_ball(ball, from + part * flight);
        CHECK(v == Approx(speed * (1 - 2 * part)).margin(9.81 * 64 * k_u * from));
        CHECK(x
              == Approx(4 * part * (1 - part) * apex_height(ball, n))
                     .margin(speed * 64 * k_u * from));
      }
    }
    if (e < 1) CHECK(bouncing_ball(ball, rest_time(ball)).x == 0);
    if (e < 1) CHECK(bouncing_ball(ball, 1e9).v == 0);
  }
  // No height is no flight; and late times, up to the very last, have an answer
  for (const double e : {0.5, 1.0}) CHECK(bouncing_ball({0, e, 9.81}, 1).x == 0);
  CHECK(std::isfinite(bouncing_ball({2, 1, 9.81}, 1e12).x));
  for (const double e : {0.01, 0.5, 0.999}) {
    const BouncingBall ball{2, e, 9.81};
    const Coordinate last = bouncing_ball(ball, std::nextafter(rest_time(ball), 0.0));
    CHECK(last.x == Approx(0).margin(1e-12));
  }
}

TEST_CASE(
    "equal balls with e = 1 trade places, one impact for each pair out of order") {
  Rows rows(1);
  for (int i = 0; i < 300; ++i) {
    const std::size_t n = rows.length();
    const Numbers v = rows.velocities(n);
    int out_of_order = 0;
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = a + 1; b < n; ++b) out_of_order += v[a] > v[b];
    Numbers sorted = v;
    std::ranges::sort(sorted);
    const PairImpacts end = pair_impacts(Numbers(n, 0.7), v, 1);
    INFO(i);
    CHECK(end.impacts == out_of_order);
    for (std::size_t a = 0; a < n; ++a)
      CHECK(end.velocities[a] == Approx(sorted[a]).margin(64 * k_u));
  }
}

TEST_CASE("impacts of two at a time keep momentum, part all pairs and gain nothing") {
  Rows rows(2);
  for (int i = 0; i < 300; ++i) {
    const Numbers m = rows.masses(rows.length());
    const Numbers v = rows.velocities(m.size());
    const double e = std::array{1.0, 0.9, 0.5}[std::size_t(i) % 3];
    const auto [end, impacts] = pair_impacts(m, v, e);

    // Each impact rounds the momentum of two balls, none of them faster than all the
    // energy could make it
    double most = 0;
    for (const double each : m) most += std::sqrt(2 * energy(m, v) * each);
    INFO(i << ", " << impacts << " impacts");
    CHECK(momentum(m, end)
          == Approx(momentum(m, v)).margin(8 * k_u * (1 + impacts) * most));
    CHECK(energy(m, end) <= energy(m, v) * (1 + 16 * k_u * (1 + impacts)));
    if (e == 1)
      CHECK(energy(m, end) == Approx(energy(m, v)).epsilon(16 * k_u * (1 + impacts)));
    for (std::size_t a = 1; a < m.size(); ++a) CHECK(end[a] >= end[a - 1] - 128 * k_u);

    // Seen in a mirror it is the same: each impact may enlarge what the last one
    // rounded
    Numbers back(v.rbegin(), v.rend());
    for (double& each : back) each = -each;
    const auto mirrored = pair_impacts(Numbers(m.rbegin(), m.rend()), back, e);
    if (impacts > 20) continue;
    CHECK(mirrored.impacts == impacts);
    for (std::size_t a = 0; a < m.size(); ++a)
      CHECK(mirrored.velocities[m.size() - 1 - a] == Approx(-end[a]).margin(1e-12));
  }

  // By hand: two balls; and three that meet three times
  const auto two = pair_impacts(Numbers{1, 3}, Numbers{2, -2}, 0.5);
  CHECK(two.velocities == Numbers{-2.5, -0.5});
  const auto three = pair_impacts(Numbers{1, 1, 1}, Numbers{1, 0, 0}, 0.5);
  CHECK(three.velocities == Numbers{0.203125, 0.234375, 0.5625});
  CHECK(three.impacts == 3);
}

TEST_CASE("soft balls stick together after ever more impacts") {
  // Below e = 7 - 4 sqrt(3) three balls never part; each round of two impacts leaves a
  // fixed share of their differences, so round-off ends it
  const double limit = 7 - 4 * std::sqrt(3.0);
  CHECK(pair_impacts(Numbers{1, 1, 1}, Numbers{1, 0, -1}, limit + 1e-3).impacts < 200);
  for (const double e : {0.0, 0.02, 0.9 * limit}) {
    const auto end = pair_impacts(Numbers{1, 1, 1}, Numbers{1, 0, -0.5}, e);
    INFO("e " << e);
    for (const double v : end.velocities) CHECK(v == Approx(1.0 / 6).margin(512 * k_u));
  }
}

TEST_CASE("a row that acts at once parts each pair at its share of the closing speed") {
  for (const double decades : {0.0, 1.0, 6.0}) {
    Rows rows(decades);
    for (int i = 0; i < 300; ++i) {
      const Numbers m = rows.masses(rows.length());
      const Numbers v = rows.velocities(m.size());
      const double e = std::array{0.0, 0.5, 1.0}[std::size_t(i) % 3];
      const auto [end, impulses] = row_impact(m, v, e);
      double most = 0;
      for (const double each : m) most += each;
      INFO(decades << ' ' << i);
      CHECK(momentum(m, end) == Approx(momentum(m, v)).margin(32 * k_u * most * 2));
      CHECK(energy(m, end) <= energy(m, v) * (1 + 64 * k_u));
      for (std::size_t a = 0; a + 1 < m.size(); ++a) {
        // What the pair is pushed by, each known to a few u
        const double pushed = impulses[a] * (1 / m[a] + 1 / m[a + 1]);
        const double closing = v[a] - v[a + 1];
        const double parting = end[a + 1] - end[a];
        const double law = e * std::max(closing, 0.0);
        const double tolerance = 32 * k_u * (pushed + 2);
        CHECK(impulses[a] >= 0);

        if (closing >= 0) CHECK(parting == Approx(law).margin(tolerance));
        if (closing < 0) CHECK(impulses[a] == 0);
      }
    }
  }
}

TEST_CASE("rows that act at once, by hand") {
  // One ball into four: all four go on together
  const auto cradle = row_impact(Numbers(5, 1), Numbers{1, 0, 0, 0, 0}, 1);
  const Numbers after{-0.6, 0.4, 0.4, 0.4, 0.4};
  for (std::size_t i = 0; i < 5; ++i)
    CHECK(cradle.velocities[i] == Approx(after[i]).epsilon(8 * k_u));

  // A pair that parts takes no part, even if its neighbours then make it close
  const auto pressed = row_impact(Numbers{1, 1, 1, 1}, Numbers{10, 0, 1, -9}, 0);
  CHECK(pressed.velocities == Numbers{5, 5, -4, -4});
  CHECK(pressed.impulses == Numbers{5, 0, 5});
  const auto apart = row_impact(Numbers{1, 1, 1}, Numbers{1, 0, 5}, 1);
  CHECK(apart.velocities == Numbers{0, 1, 5});
  CHECK(apart.impulses == Numbers{1, 0});
  CHECK(row_impact(Numbers{2}, Numbers{3}, 1).velocities == Numbers{3});
}

TEST_CASE("a dropped stack throws its top ball up") {
  // A light ball on a heavy one: three times the speed, nine times the height
  for (const double light : {1e-3, 1e-9, 1e-15}) {
    const Numbers v = dropped_stack(Numbers{1, light}, 2, 1);
    CHECK(v[1] == Approx(6).epsilon(2 * light + 4 * k_u));
    CHECK(momentum({1, light}, v) == Approx(2 - 2 * light).epsilon(8 * k_u));
  }

  // Each ball that bounces off a much heavier one leaves with e v + (1 + e) u
  for (const double e : {0.0, 0.5, 1.0}) {
    const Numbers v = dropped_stack(Numbers{1e40, 1e20, 1, 1e-20}, 1, e);
    double speed = e;
    for (std::size_t i = 1; i < 4; ++i) {
      speed = speed + e * (speed + 1);
      CHECK(v[i] == Approx(speed).margin(16 * k_u * (1 + speed)));
    }
  }
  CHECK(dropped_stack(Numbers{3}, 2, 0.5) == Numbers{1});
}

TEST_CASE("a penalty contact is the oscillator it is made of") {
  const double m = 2, k = 800, omega = 20, v = 3;
  for (const double zeta :
       {0.0, 1e-9, 0.1, 0.9, 1 - 1e-9, 1 - 1e-15, 1.0, 1 + 1e-15, 1 + 1e-9, 1.5, 1e4}) {
    const PenaltyContact contact{m, k, 2 * zeta * omega * m};
    const auto at = [&](double t) {
      return oscillator({0, v}, omega, zeta * omega, t);
    };
    const double turning = penalty_turning_time(contact);
    INFO("zeta " << zeta);

    // Near the turning point the speed grows with omega^2 depth a second
    CHECK(at(turning).v == Approx(0).margin(64 * k_u * v * (1 + zeta)));
    CHECK(penalty_depth(contact, v)
          == Approx(at(turning).x).epsilon(64 * k_u * (1 + zeta)));

    // Where the force is gone: k x = -c v, and fast through that with zeta
    const auto bounce = penalty_bounce(contact);
    const Coordinate end = at(bounce.time);
    CHECK(end.v == Approx(-bounce.restitution * v).margin(64 * k_u * v * (1 + zeta)));
    CHECK(k * end.x + contact.c * end.v
          == Approx(0).margin(64 * k_u * v * contact.mass * omega * (1 + zeta * zeta)));

    const auto sticky = sticky_penalty_bounce(contact);
    CHECK(sticky.restitution <= bounce.restitution);
    if (zeta >= 1) {
      CHECK((std::isinf(sticky.time) && sticky.restitution == 0));
    } else {
      // Close to critical its frequency is all but gone, and so is what is left
      const double margin = 64 * k_u * v * sticky.time * omega;
      CHECK(at(sticky.time).x * omega == Approx(0).margin(margin));
      CHECK(at(sticky.time).v == Approx(-sticky.restitution * v).margin(margin));
    }
  }
  CHECK(penalty_bounce({m, k, 0}).time == Approx(k_pi / omega).epsilon(4 * k_u));
  CHECK(penalty_bounce({m, k, 0}).restitution == 1);
  CHECK(penalty_bounce({m, k, 2 * omega * m}).time
        == Approx(2 / omega).epsilon(4 * k_u));
}

TEST_CASE("what slides on an incline does the work that friction and gravity do") {
  for (const double angle : {0.0, 1e-6, 0.2, 0.5, 1.2, k_pi / 2}) {
    for (const double mu : {0.0, 0.3, 5.0}) {
      const Incline incline{angle, 1.2 * mu, mu, 9.81};
      for (const double v0 : {-4.0, 0.0, 3.0}) {
        double path = 0, last_x = 0;
        INFO("angle " << angle << " mu " << mu << " v0 " << v0);

        // Up to where it turns and from there on the way is the distance
        const double stops = stop_time(incline, v0);
        std::vector<double> times{0.1, 0.5, 1.0, 5.0};
        if (std::isfinite(stops)) times.push_back(stops);
        std::ranges::sort(times);
        for (const double t : times) {
          const auto [x, v] = on_incline(incline, v0, t);
          path += std::abs(x - last_x);
          last_x = x;
          const double friction = mu * std::cos(angle) * path;
          const double work = 9.81 * (std::sin(angle) * x - friction);
          CHECK((v * v - v0 * v0) / 2
                == Approx(work).margin(64 * k_u * 9.81 * (1 + mu) * (path + 1)));
        }

        // It stays where it stops unless the slope is steeper than static friction
        // bears
        const bool steep = angle > threshold_angle(1.2 * mu);
        CHECK(slides_from_rest(incline) == steep);
        if (std::isfinite(stops) || v0 == 0)
          CHECK((on_incline(incline, v0, 100).v == 0) == !steep);
      }
    }
  }
  CHECK(std::isinf(stop_time({0, 0, 0, 9.81}, 3)));
  CHECK(stop_time({0.1, 0.5, 0.4, 9.81}, 0) == 0);
}

TEST_CASE("what slides askew on a slope obeys Newton and Coulomb") {
  // Of what changes at a rate by friction b < 30 m/s², whose direction turns at w < 10
  // /s above 1 m/s and with w' < 800 /s², differences over 2h miss h² / 6 b (w² + w');
  // of some metres they round by 64 u / h
  constexpr double k_h = 1e-4, k_close = 4500 * k_h * k_h + 64 * k_u / k_h;
  for (const double mu : {0.0, 0.2, 0.5, 0.9, 3.0}) {
    for (const double angle : {0.05, 0.5, 1.2}) {
      for (const dvec2 v0 : {dvec2(3, 2), dvec2(-2, 1), dvec2(0, -4)}) {
        INFO("mu " << mu << " angle " << angle << " v0 " << v0.x << " " << v0.y);
        const Incline incline{angle, mu, mu, 9.81};
        const auto at = [&](double t) { return across_incline(incline, v0, t); };
        CHECK(glm::length(at(0).x) <= 8 * k_u);
        CHECK(glm::distance(at(0).v, v0) <= 16 * k_u);
        for (const double t : {0.01, 0.1, 0.12, 0.3}) {
          const SlopeMotion now = at(t);
          if (glm::length(at(t + k_h).v) == 0 || glm::length(now.v) < 1) continue;
          const dvec2 v = (at(t + k_h).x - at(t - k_h).x) / (2 * k_h);
          const dvec2 change = (at(t + k_h).v - at(t - k_h).v) / (2 * k_h);
          const dvec2 friction = -mu * 9.81 * std::cos(angle) * glm::normalize(now.v);
          const dvec2 newton = dvec2(9.81 * std::sin(angle), 0) + friction;
          CHECK(glm::distance(v, now.v) <= k_close);
          CHECK(glm::distance(change, newton) <= k_close);
        }
      }
    }
  }

  // It ends at rest if the slope is not too steep; level, where the cone says
  const Incline rough{0.3, 0.6, 0.6, 9.81}, level{0, 0.6, 0.6, 9.81};
  CHECK(across_incline(rough, {3, 2}, 60).v == dvec2(0));
  CHECK(across_incline(rough, {3, 2}, 60).x == across_incline(rough, {3, 2}, 90).x);
  const Stop stop = cone_stop({3, 2}, 0.6, 9.81);
  CHECK(glm::distance(across_incline(level, {3, 2}, 60).x, stop.x) <= 8 * k_u);
  CHECK(glm::distance(across_incline({1e-9, 0.6, 0.6, 9.81}, {3, 2}, 60).x, stop.x)
        <= 1e-8);
}

TEST_CASE("a box slides or tips, by which side the pressure leaves first") {
  for (const dvec2& size : {dvec2(1, 1), {0.5, 2}, {2, 0.5}, {1e-6, 1e3}}) {
    for (const double mu : {0.0, 0.3, 0.9, 50.0}) {
      const BoxOnIncline box{size.x, size.y, mu};

      // Tipping: the pressure is under the lower edge. Sliding: friction is mu N
      CHECK(pressure_centre(box, tip_angle(box))
            == Approx(size.x / 2).epsilon(8 * k_u));
      CHECK(std::tan(slide_angle(box)) == Approx(mu).epsilon(64 * k_u));
      CHECK((tip_angle(box) < slide_angle(box)) == (size.x / size.y < mu));
    }
  }
}

TEST_CASE("the cone stops straight ahead, the pyramid sooner and off the line") {
  const double g = 9.81;
  for (const double mu : {0.05, 0.4, 5.0}) {
    for (const dvec2& v : {dvec2(3, 3), {4, -1}, {-2e-6, 5}, {0, 2}, {0, 0}}) {
      const Stop cone = cone_stop(v, mu, g);
      const Stop pyramid = pyramid_stop(v, mu, g);
      const double speed = glm::length(v);
      INFO("mu " << mu << " v " << v.x << ' ' << v.y);

      // The way takes all the energy, in the velocity's direction; the impulse all of
      // it
      CHECK(mu * g * glm::length(cone.x) == Approx(speed * speed / 2).epsilon(8 * k_u));
      CHECK(cone.x.x * v.y - cone.x.y * v.x
            == Approx(0).margin(8 * k_u * glm::length(cone.x) * speed));
      CHECK(mu * g * cone.time == Approx(speed).epsilon(8 * k_u));
      CHECK(mu * g * (std::abs(pyramid.x.x) + std::abs(pyramid.x.y))
            == Approx(speed * speed / 2).epsilon(8 * k_u));
      CHECK(pyramid.time <= cone.time * (1 + 4 * k_u));
      CHECK(pyramid.time >= cone.time / std::sqrt(2.0) * (1 - 4 * k_u));
    }
  }
  CHECK(std::isinf(cone_stop({1, -1}, 0, g).time));
  CHECK(pyramid_stop({1, 0}, 0, g).x
        == dvec2(std::numeric_limits<double>::infinity(), 0));
}

TEST_CASE("overhanging blocks balance, each pile of them on the edge below") {
  const int n = 40;
  double place = 0, sum = 0;  // of the top block's middle, from the top down
  for (int i = 1; i <= n; ++i) {
    sum += place;  // middles of the top i blocks
    const double edge = sum / i;
    place -= overhang(2, i);

    // The next block's right end is under their centre of mass
    CHECK(place + 1 == Approx(edge).margin(8 * k_u * n));
  }
  CHECK(overhang_of_all(2, n) == Approx(-place).epsilon(8 * k_u));

  // Half of the millionth harmonic number (mpmath)
  CHECK(overhang_of_all(1, 1000000) == Approx(14.392726722865724 / 2).epsilon(1e-14));
}

TEST_CASE("a pile's impulses hold every block, and sweeps approach them as they say") {
  const Numbers masses{1, 100, 1e-3, 7};
  const Numbers x = resting_impulses(masses, 9.81, 0.01);
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const double above = i + 1 < x.size() ? x[i + 1] : 0;
    CHECK(x[i] - above == Approx(masses[i] * 9.81 * 0.01).margin(8 * k_u * x[0]));
  }

  // Gauss-Seidel on n unit masses: the error of the impulse under each in turn becomes
  // the mean of its neighbours' (the floor's has one); its decay settles at the factor
  for (const int n : {1, 2, 3, 10, 30}) {
    Numbers error(std::size_t(n) + 1, 1);
    error[std::size_t(n)] = 0;
    double last = 1, ratio = 0;
    for (int sweep = 0; sweep < 40 * n + 2; ++sweep) {
      for (std::size_t i = 0; i < std::size_t(n); ++i)
        error[i] = i == 0 ? error[1] : (error[i - 1] + error[i + 1]) / 2;
      ratio = error[0] / last;
      last = error[0];
    }
    INFO(n);
    CHECK(sweep_factor(n) == Approx(n == 1 ? 0 : ratio).margin(1e-9));
  }
}
