// Chapter 6's exact rolling and tipping: Newton's and Euler's equations put together
// from the motions that they give, and numbers by other ways. They are double whatever
// the precision of the rest; u (k_u) is its unit round-off.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/glm.hpp>

#include "common/physics/exact_rolling.hpp"
#include "common/physics/exact_tipping.hpp"
#include "tests/catch.hpp"

using namespace timestep::exact;
using glm::dvec2;

namespace {

constexpr double k_u = 1.1102230246251565e-16;
constexpr double k_pi = std::numbers::pi;

}  // namespace

TEST_CASE("a ball on a slope obeys Newton, Euler and Coulomb") {
  for (const double angle : {0.0, 1e-9, 0.5, 1.5}) {
    for (const double k : {1e-6, 0.4, 0.5, 2.0 / 3, 1.0}) {
      for (const double mu : {0.0, 0.05, 0.15, 0.8, 100.0}) {
        const BallOnIncline ball{angle, 0.3, k, mu, 9.81};
        const auto [linear, angular] = acceleration(ball);
        INFO("angle " << angle << " k " << k << " mu " << mu);

        // Friction, a unit of mass: what keeps the centre back is what turns the ball
        const double friction = k * 0.3 * angular;
        const double down = 9.81 * std::sin(angle);
        CHECK(linear == Approx(down - friction).margin(8 * k_u * 9.81));
        const double most = mu * 9.81 * std::cos(angle);
        const double slips = linear - 0.3 * angular;
        CHECK(friction <= most + 8 * k_u * 9.81);
        if (rolls(ball))
          CHECK(slips == Approx(0).margin(8 * k_u * 9.81));
        else
          CHECK((slips > 0 && friction == Approx(most).epsilon(8 * k_u)));
      }
    }
  }

  // At the least mu that rolls, rolling and slipping are one
  BallOnIncline ball{0.7, 0.1, 0.4, 0, 9.81};
  ball.mu = rolling_friction_needed(ball) * (1 - 1e-12);
  const auto slips = acceleration(ball);
  CHECK(!rolls(ball));
  ball.mu = rolling_friction_needed(ball);
  CHECK(rolls(ball));
  CHECK(slips.linear == Approx(acceleration(ball).linear).epsilon(1e-11));
  CHECK(slips.angular == Approx(acceleration(ball).angular).epsilon(1e-11));
}

TEST_CASE("a ball leaves a ball where nothing presses any more") {
  for (const double k : {0.0, 0.4, 2.0 / 3, 1.0}) {
    for (const double scale : {1e-6, 1.0, 1e6}) {
      const BallOnBall ball{scale, 0.1 * scale, k, 9.81};
      const double path = 1.1 * scale;
      const double cosine = cos_leaving_angle(ball);
      const double v = leaving_speed(ball);
      INFO("k " << k << " scale " << scale);

      // What it fell is motion and spin; gravity alone holds it on the circle there,
      // with speed to spare after and too little before
      CHECK((1 + k) * v * v / 2
            == Approx(9.81 * path * (1 - cosine)).epsilon(16 * k_u));
      CHECK(v * v / path == Approx(9.81 * cosine).epsilon(16 * k_u));
    }
  }
  CHECK(cos_leaving_angle({1, 0.1, 0, 9.81}) == Approx(2.0 / 3).epsilon(4 * k_u));
  CHECK(cos_leaving_angle({1, 0.1, 0.4, 9.81}) == Approx(10.0 / 17).epsilon(4 * k_u));
}

TEST_CASE("a ball in a bowl swings as a pendulum of its own length") {
  // By mpmath's elliptic functions at 40 digits; a phase of n rad is known to a few n u
  const auto check = [](const BallInBowl& ball, double theta0, double t, double theta,
                        double rate, double period) {
    const double phase = 8 * k_u * (1 + bowl_frequency(ball) * t);
    const Coordinate now = ball_in_bowl(ball, theta0, t);
    CHECK(now.x == Approx(theta).margin(phase * theta0));
    CHECK(now.v == Approx(rate).margin(phase * theta0 * bowl_frequency(ball)));
    CHECK(bowl_period(ball, theta0) == Approx(period).epsilon(8 * k_u));
  };
  check({2, 0.2, 1, 9.81}, 1.5, 100, -1.178131988211438331, 1.3038144114377214651,
        4.4227364563879082618);
  check({1e-3, 1e-4, 0.4, 9.81}, 0.5, 10, 0.026572763720489826949,
        -43.597214732108373805, 0.072337135040967638642);
  check({1e3, 1, 0.4, 1.62}, 1e-6, 1000, -8.6597706231999010549e-7,
        -1.7019761199169650082e-8, 184.61590902492534227);
  CHECK(ball_in_bowl({2, 0.2, 0.4, 9.81}, 0, 7).x == 0);
}

TEST_CASE("a box that is pulled under balls shares the force with them") {
  for (const double mu : {0.0, 0.1, 0.4}) {
    for (const int balls : {0, 1, 25, 1000}) {
      const BoxUnderBalls scene{10, 0.5, balls, 150, mu, 9.81};
      const auto [box, ball] = accelerations(scene);
      INFO("mu " << mu << " balls " << balls);

      // All that is not friction moves something, or friction holds it
      const double moved = 10 * box + balls * 0.5 * ball;
      const double left = 150 - ground_friction(scene);
      CHECK(moved == Approx(std::max(left, 0.0)).margin(16 * k_u * 150));

      // Each ball's centre is moved by what turns it, and its lowest point by the box
      const double spin = (ball - box) / 0.2;
      CHECK(0.4 * 0.2 * spin == Approx(-ball).margin(8 * k_u * box));
    }
  }
}

TEST_CASE("tipping takes the time that the integral of 1 / omega says") {
  // From `from` on by an angle, with omega0 = 1: by quadrature, and again by elliptic
  // integrals, at 40 digits (mpmath)
  struct Tip {
    double from, by, time;
  };
  for (const auto& [from, by, time] :
       {Tip{0.1, 0.2, 1.7656216270550939711}, Tip{1e-8, 1, 19.134970531611029275},
        Tip{1e-150, 3, 347.39634994983335739}, Tip{1, 1e-12, 1.5416842126570499559e-6},
        Tip{2, 1.1, 1.6706979164332933289}, Tip{3, 0.14, 1.5615090687743060005},
        Tip{0.5, 1e-300, 2.0424640231511977543e-150},
        Tip{1.5707963267948966, 1.5, 1.8039931870514905041}}) {
    INFO("from " << from << " by " << by);
    // How far from hanging is rounded as the angle is
    const double tolerance = 8 * k_u * (1 + 1 / (k_pi - from));
    CHECK(tipping_time(1, from, by) == Approx(time).epsilon(tolerance));
    CHECK(tipping_time(50, from, by) == Approx(time / 50).epsilon(tolerance));
  }
  CHECK(tipping_time(1, 0.3, 0) == 0);
  CHECK(std::isinf(tipping_time(1, 0, 0.3)));
  CHECK(std::isinf(tipping_time(1, 1e-200, 0.3)));

  // To hanging: a quarter of a pendulum's period
  CHECK(tipping_time(1, 2, k_pi - 2)
        == Approx(bowl_period({2, 1, 0, 1}, k_pi - 2) / 4).epsilon(16 * k_u));
}

TEST_CASE("falling rods obey Newton and Euler about their centre") {
  for (const double theta0 : {0.0, 1e-9, 0.1, 1.0}) {
    for (const double fraction : {0.0, 1e-9, 0.3, 0.7, 1.0}) {
      for (const double length : {1e-6, 2.0}) {
        const FallingRod rod{3, length, 9.81, theta0};
        const double theta = theta0 + fraction * (k_pi / 2 - theta0);
        const double s = std::sin(theta), c = std::cos(theta);
        const double l = length / 2, inertia = 3 * length * length / 12;
        const double weight = 3 * 9.81;
        INFO("theta0 " << theta0 << " theta " << theta << " length " << length);

        // The centre is (l s, l c) off the end that stays; friction points along x
        const RodMotion rough = rod_on_rough_floor(rod, theta);
        const double w2 = rough.omega * rough.omega;
        const double tolerance = 32 * k_u * weight;
        CHECK(rough.friction
              == Approx(3 * l * (c * rough.alpha - s * w2)).margin(tolerance));
        CHECK(rough.normal
              == Approx(weight - 3 * l * (s * rough.alpha + c * w2)).margin(tolerance));
        CHECK(rough.normal * l * s - rough.friction * l * c
              == Approx(inertia * rough.alpha).margin(tolerance * l));
        CHECK(4 * inertia * w2 / 2
              == Approx(weight * l * (std::cos(theta0) - c)).margin(tolerance * l));

        // Without friction the centre is l c high and falls straight
        const RodMotion smooth = rod_on_smooth_floor(rod, theta);
        const double v2 = smooth.omega * smooth.omega;
        CHECK(smooth.friction == 0);
        CHECK(
            smooth.normal
            == Approx(weight - 3 * l * (s * smooth.alpha + c * v2)).margin(tolerance));
        CHECK(smooth.normal * l * s
              == Approx(inertia * smooth.alpha).margin(tolerance * l));
        CHECK((inertia + 3 * l * l * s * s) * v2 / 2
              == Approx(weight * l * (std::cos(theta0) - c)).margin(tolerance * l));

        // It presses all the way down; the other one's floor need not pull either
        CHECK(smooth.normal > 0);
        CHECK(rough.normal >= 0);
      }
    }
  }
}

TEST_CASE("a rod that starts all but level keeps all digits of its fall") {
  // omega² = 3 g / L (cos theta0 - cos theta), which as written would keep none here
  const FallingRod rod{1, 1e-3, 9.81, 1.5};
  const double by = 1.5000001 - 1.5;
  CHECK(rod_on_rough_floor(rod, 1.5000001).omega
        == Approx(std::sqrt(3 * 9.81 / 1e-3 * std::sin(1.5 + by / 2) * by))
               .epsilon(1e-14));

  // By elliptic integrals at 40 digits (mpmath), from the same doubles
  CHECK(rod_time(rod, 1.5000001) == Approx(3.69130136835378873e-6).epsilon(16 * k_u));
  CHECK(rod_time({1, 2, 9.81, 1e-6}, 1.5)
        == Approx(5.51622428828347633).epsilon(16 * k_u));
  CHECK(std::isinf(rod_time({1, 2, 9.81, 0}, 1)));
}

TEST_CASE("an upright rod's floor needs most friction at 9/11, and none at 2/3") {
  const FallingRod rod{1, 1, 9.81, 0};
  constexpr UprightRod k_upright;
  const auto needed = [&](double cosine) {
    const RodMotion at = rod_on_rough_floor(rod, std::acos(cosine));
    return at.friction / at.normal;
  };
  CHECK(k_upright.mu_needed == Approx(15 * std::sqrt(10.0) / 128).epsilon(2 * k_u));
  CHECK(needed(k_upright.cos_most_needed)
        == Approx(k_upright.mu_needed).epsilon(32 * k_u));
  for (int i = 1; i <= 100; ++i) {
    const double cosine = 2.0 / 3 + i / 301.0;
    CHECK(needed(cosine) <= k_upright.mu_needed * (1 + 32 * k_u));
    CHECK(needed(cosine) > 0);
    CHECK(needed(2.0 / 3 - i / 301.0) < 0);
  }
  CHECK(needed(k_upright.cos_friction_reverses) == Approx(0).margin(32 * k_u));
  CHECK(rod_on_rough_floor(rod, std::acos(k_upright.cos_normal_zero)).normal
        == Approx(0).margin(1e-28));
}

TEST_CASE("Painlevé's rod is lifted by what the floor does to its end") {
  for (const double theta : {0.0, 0.3, 0.6, 1.1, 1.4, k_pi / 2}) {
    for (const double mu : {0.0, 0.5, 1.2, 1.5, 10.0}) {
      for (const double omega : {0.0, 2.0, -6.0, 30.0}) {
        const PainleveRod rod{2, 0.5, 9.81, theta, omega, mu};
        const auto [p, b, state, normal] = painleve(rod);
        INFO("theta " << theta << " mu " << mu << " omega " << omega);

        // The end leads: it is `arm` off the centre, ahead and down. A normal force of
        // 1 with the friction mu against the slip moves it as a force at a point does
        const dvec2 arm = 0.5 * dvec2(std::cos(theta), -std::sin(theta));
        const dvec2 force(-mu, 1);
        const double alpha = (arm.x * force.y - arm.y * force.x) / (2 * 1.0 / 12);
        CHECK(p == Approx(force.y / 2 + alpha * arm.x).margin(16 * k_u * (1 + mu)));
        CHECK(b == Approx(-9.81 - omega * omega * arm.y).margin(16 * k_u * 500));

        // A force that serves leaves the end at rest, and pushes
        if (state == Painleve::slides) {
          CHECK(normal > 0);
          CHECK(b + p * normal == Approx(0).margin(8 * k_u * 9.81));
        }
        CHECK((state == Painleve::slides) == (p > 0 && b < 0));
        CHECK((state == Painleve::inconsistent) == (p <= 0 && b < 0));
        CHECK((state == Painleve::indeterminate) == (p < 0 && b >= 0));
        if (state == Painleve::parts) CHECK(normal == 0);
      }
    }
    if (theta == 0.0) continue;
    const double critical = painleve_friction(theta);
    CHECK(critical >= 4.0 / 3 * (1 - 4 * k_u));
    CHECK(painleve({1, 0.5, 9.81, theta, 0, critical}).p
          == Approx(0).margin(16 * k_u * 4));
  }
  CHECK(painleve_friction(std::atan(2.0)) == Approx(4.0 / 3).epsilon(4 * k_u));
  CHECK(std::isinf(painleve_friction(0)));
}

TEST_CASE("a rocking block keeps its angular momentum about the corner that hits") {
  for (const double width : {1e-6, 0.1, 0.5, 1.0, 1.4}) {
    const RockingBlock block{width, 1, 9.81};
    const double square = width * width + 1;
    INFO("half width " << width);

    // Turning about one lower corner the centre moves across its radius; about the
    // other corner that counts only as far as it is at right angles to that one's
    // radius
    const double inertia = square / 3;
    const double crossing = (1 - width * width);
    CHECK(rate_ratio(block)
          == Approx((inertia + crossing) / (inertia + square)).margin(8 * k_u));
    CHECK(block_angle(block) == Approx(std::atan(width)).epsilon(4 * k_u));

    // Energy from rest to the floor and up again
    const double alpha = block_angle(block);
    const double p2 = 3 * 9.81 / (4 * std::sqrt(square));
    for (const double part : {0.01, 0.5, 0.999}) {
      const double theta0 = part * alpha;
      const double rate = impact_rate(block, theta0);
      const double fall = std::cos(alpha - theta0) - std::cos(alpha);
      CHECK(rate * rate == Approx(2 * p2 * fall).margin(16 * k_u));
      const double tilt = next_tilt(block, theta0);
      const double rise = std::cos(alpha - tilt) - std::cos(alpha);
      CHECK(rise == Approx(std::pow(rate_ratio(block), 2) * fall).margin(16 * k_u));
      CHECK(tilt <= theta0);
    }
  }
}

TEST_CASE("a rocking block's times and tilts at their limits") {
  // By elliptic integrals and by quadrature at 40 digits (mpmath): hardly tilted, all
  // but toppling, a needle, and a block wider than high. Close to toppling the time is
  // known as well as how close it is
  struct Rock {
    RockingBlock block;
    double theta0, time, rate, tilt, tolerance;
  };
  for (const auto& [block, theta0, time, rate, tilt, tolerance] :
       {Rock{{0.1, 0.4, 9.81},
             1e-9,
             0.0000214968251417925375,
             0.0000930369944464534616,
             8.31314878612272713e-10,
             16 * k_u},
        Rock{{0.1, 0.4, 9.81},
             0.2449,
             2.06855280661827097,
             1.03227307526234043,
             0.144571970206957888,
             1e-12},
        Rock{{1e-3, 1, 9.81},
             5e-4,
             0.485519864931002973,
             0.00234906773287587493,
             0.000499997750008640594,
             64 * k_u},
        Rock{{1, 0.5, 1.62},
             1,
             2.92980339056792872,
             1.09040975590389079,
             0.0246188870566699941,
             64 * k_u}}) {
    INFO("theta0 " << theta0);
    CHECK(quarter_time(block, theta0) == Approx(time).epsilon(tolerance));
    CHECK(impact_rate(block, theta0) == Approx(rate).epsilon(64 * k_u));
    CHECK(next_tilt(block, theta0) == Approx(tilt).epsilon(64 * k_u));
  }
  CHECK(next_tilt({0.1, 0.4, 9.81}, 0) == 0);

  // Slender blocks: sin x = x, off by less than a sixth of alpha²
  const RockingBlock slender{1e-3, 1, 9.81};
  for (const double part : {1e-12, 0.1, 0.9}) {
    const double theta0 = part * block_angle(slender);
    CHECK(slender_quarter_time(slender, theta0)
          == Approx(quarter_time(slender, theta0)).epsilon(2e-7));
  }

  // At sqrt(2) times its height it stops dead; wider, it would leap
  CHECK(rate_ratio({std::sqrt(2.0), 1, 9.81}) == Approx(0).margin(4 * k_u));
  CHECK(rate_ratio({1.5, 1, 9.81}) < 0);
}
