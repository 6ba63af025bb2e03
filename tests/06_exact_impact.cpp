// Chapter 6's exact impacts of two bodies: the laws' own conditions on random bodies,
// the numbers of tests/truth, and simple bodies that can be done by hand. They are
// double whatever the precision of the rest; u (k_u) is its unit round-off.
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <string>

#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

#include "common/physics/exact_impact.hpp"
#include "tests/catch.hpp"

using namespace timestep::exact;
using glm::dmat3;
using glm::dquat;
using glm::dvec2;
using glm::dvec3;

namespace {

using Json = nlohmann::json;
using Law = Impulse (*)(const Body&, const Body&, const Touch&);

constexpr double k_u = 1.1102230246251565e-16;

struct Meeting {
  Body a, b;
  Touch touch;
};

dmat3 outer_inertia(const dmat3& R, const dvec3& inverse_moments) {
  const auto& k = inverse_moments;
  return dmat3(k.x * R[0], k.y * R[1], k.z * R[2]) * glm::transpose(R);
}

Body box(double mass, const dvec3& size, const dquat& q) {
  const dvec3 s = size * size;
  const dvec3 moments = mass / 12 * dvec3(s.y + s.z, s.z + s.x, s.x + s.y);
  return {.inverse_mass = 1 / mass,
          .inverse_inertia = outer_inertia(glm::mat3_cast(q), 1.0 / moments),
          .position = dvec3(0),
          .velocity = dvec3(0),
          .angular_velocity = dvec3(0)};
}

constexpr Body k_ground{0, dmat3(0), dvec3(0), dvec3(0), dvec3(0)};

// Boxes up to 8 times as long as wide, of masses over six decades, one in five static,
// that meet anywhere within 2 m and close
class Meetings {
 public:
  Meeting next() {
    Meeting m{body(), body(), {vector(2), direction(), 0, 0}};
    if (random_() % 5 == 0) m.a = k_ground;
    if (relative_velocity(m.a, m.b, m.touch)[0] == 0) return next();
    if (glm::dot(relative_velocity(m.a, m.b, m.touch), m.touch.normal) > 0)
      m.touch.normal = -m.touch.normal;
    m.touch.restitution = std::array{0.0, 0.3, 0.9, 1.0}[random_() % 4];
    m.touch.mu = std::array{0.0, 0.1, 0.5, 1.0, 5.0, 1e6}[random_() % 6];
    return m;
  }

 private:
  double number(double most) {
    return most * (2 * double(random_()) / double(std::mt19937::max()) - 1);
  }
  dvec3 vector(double most) { return {number(most), number(most), number(most)}; }
  dvec3 direction() { return glm::normalize(vector(1) + dvec3(1e-3, 0, 0)); }
  Body body() {
    const dvec3 size = glm::exp2(vector(1.5));
    const dquat q{number(1), number(1), number(1), 0.1 + number(1)};
    Body made = box(std::pow(10, number(3)), size, glm::normalize(q));
    made.position = vector(1);
    made.velocity = vector(3);
    made.angular_velocity = vector(5);
    return made;
  }

  std::mt19937 random_{6};
};

dmat3 crossing(const dvec3& r) {
  return {0, r.z, -r.y, -r.z, 0, r.x, r.y, -r.x, 0};
}

dmat3 k_of(const Meeting& m) {
  dmat3 K(m.a.inverse_mass + m.b.inverse_mass);
  for (const Body& body : {m.a, m.b}) {
    const dmat3 r = crossing(m.touch.point - body.position);
    K -= r * body.inverse_inertia * r;
  }
  return K;
}

double size_of(const dmat3& K) {
  return std::sqrt(glm::dot(K[0], K[0]) + glm::dot(K[1], K[1]) + glm::dot(K[2], K[2]));
}

double energy(const Body& body) {
  if (body.inverse_mass == 0) return 0;
  const dvec3& w = body.angular_velocity;
  return (glm::dot(body.velocity, body.velocity) / body.inverse_mass
          + glm::dot(w, glm::inverse(body.inverse_inertia) * w))
         / 2;
}

double energy(const Meeting& m) {
  return energy(m.a) + energy(m.b);
}

Meeting after(const Meeting& m, const dvec3& j) {
  return {pushed(m.a, -j, m.touch.point), pushed(m.b, j, m.touch.point), m.touch};
}

// What a law's impulse does, and to how many digits K lets it be known: a relative
// error of 64 u in K changes K^-1 by its condition number times that
struct Outcome {
  dvec3 before, after;  // relative velocities
  double normal_before, normal_after, j_normal;
  dvec3 j_slip, slip;     // friction and slip after
  double tolerance;       // of velocities [m/s]
  double cone_tolerance;  // of friction: j_normal is known to 16 u of all of j [N s]
  double condition;

  Outcome(const Meeting& m, const dvec3& j)
      : before(relative_velocity(m.a, m.b, m.touch)), after(before + k_of(m) * j) {
    const dvec3& n = m.touch.normal;
    const dmat3 K = k_of(m);
    normal_before = glm::dot(before, n);
    normal_after = glm::dot(after, n);
    j_normal = glm::dot(j, n);
    j_slip = j - j_normal * n;
    slip = after - normal_after * n;
    cone_tolerance = 16 * k_u * (1 + m.touch.mu) * glm::length(j);
    condition = size_of(K) * size_of(glm::inverse(K));
    tolerance =
        64 * k_u * condition * (glm::length(before) + size_of(K) * glm::length(j));
  }
};

Body body_of(const Json& j) {
  const auto vec = [&](const char* name) {
    return dvec3(j.at(name)[0], j.at(name)[1], j.at(name)[2]);
  };
  if (j.at("mass").is_null()) return k_ground;
  const Json& q = j.at("q");
  const dmat3 R = glm::mat3_cast(glm::normalize(dquat(q[0], q[1], q[2], q[3])));
  return {1 / j.at("mass").get<double>(), outer_inertia(R, 1.0 / vec("inertia")),
          vec("position"), vec("velocity"), vec("omega")};
}

void check_same(const dvec3& got, const Json& expected) {
  const dvec3 want(expected[0], expected[1], expected[2]);
  CHECK(glm::distance(got, want) <= 1e-12 * (1 + glm::length(want)));
}

}  // namespace

TEST_CASE("impacts of two bodies are those of the truth file") {
  std::ifstream file(TIMESTEP_TRUTH "/truth_public.json");
  const Json document = Json::parse(file);
  int cases = 0;
  for (const Json& test : document.at("cases")) {
    if (test.at("kind") != "two_body_impulse") continue;
    const Json& in = test.at("inputs");
    const Json& expected = test.at("expected");
    const dvec3 n(in.at("normal")[0], in.at("normal")[1], in.at("normal")[2]);
    const dvec3 point(in.at("point")[0], in.at("point")[1], in.at("point")[2]);
    const Meeting m{body_of(in.at("A")),
                    body_of(in.at("B")),
                    {point, glm::normalize(n), in.at("restitution"), in.at("mu")}};
    const std::string name = in.at("law");
    const Law law = name == "frictionless"          ? frictionless
                    : name == "sequential_friction" ? sequential_friction
                                                    : coupled_friction;
    const Impulse impulse = law(m.a, m.b, m.touch);
    const Meeting end = after(m, impulse.j);
    INFO(test.at("id"));
    check_same(impulse.j, expected.at("impulse_on_B"));
    check_same(end.a.velocity, expected.at("vA"));
    check_same(end.a.angular_velocity, expected.at("wA"));
    check_same(end.b.velocity, expected.at("vB"));
    check_same(end.b.angular_velocity, expected.at("wB"));
    const double left = expected.at("kinetic_energy_after");
    CHECK(energy(end) == Approx(left).epsilon(1e-12));
    const char* const mode = impulse.slip == Slip::frictionless ? "frictionless"
                             : impulse.slip == Slip::sticks     ? "stick"
                                                                : "slide";
    CHECK(expected.at("mode") == mode);
    ++cases;
  }
  CHECK(cases == 24);
}

TEST_CASE("without friction an impact loses what its formula says") {
  Meetings meetings;
  for (int i = 0; i < 2000; ++i) {
    const Meeting m = meetings.next();
    const Impulse impulse = frictionless(m.a, m.b, m.touch);
    const Outcome out(m, impulse.j);
    const double e = m.touch.restitution;
    INFO(i);
    CHECK(std::abs(out.normal_after + e * out.normal_before) <= out.tolerance);
    CHECK(glm::length(out.j_slip) <= 8 * k_u * out.j_normal);

    // Energies add up over roundings of all that moves
    const double k = glm::dot(m.touch.normal, k_of(m) * m.touch.normal);
    const double loss = (1 - e * e) * out.normal_before * out.normal_before / (2 * k);
    const double most = energy(m) + out.j_normal * out.j_normal * k;
    CHECK(energy(m) - energy(after(m, impulse.j))
          == Approx(loss).margin(64 * k_u * out.condition * most));
  }
}

TEST_CASE("coupled friction keeps Newton's restitution and Coulomb's law at once") {
  Meetings meetings;
  int stuck = 0, gained = 0;
  for (int i = 0; i < 4000; ++i) {
    const Meeting m = meetings.next();
    const Impulse impulse = coupled_friction(m.a, m.b, m.touch);
    const Outcome out(m, impulse.j);
    INFO(i);
    CHECK(out.j_normal > 0);
    CHECK(std::abs(out.normal_after + m.touch.restitution * out.normal_before)
          <= out.tolerance);

    // Friction stops the slip within the cone, or is on the cone against the slip
    const double friction = glm::length(out.j_slip);
    const double most = m.touch.mu * out.j_normal;
    CHECK(friction <= most + out.cone_tolerance);
    if (impulse.slip == Slip::sticks) {
      CHECK(glm::length(out.slip) <= out.tolerance);
      ++stuck;
    } else {
      CHECK(friction >= most - out.cone_tolerance);
      if (most > 0) {
        const dvec3 along = out.j_slip / friction;
        CHECK(glm::length(out.slip - glm::dot(out.slip, along) * along)
              <= out.tolerance);
        CHECK(glm::dot(out.slip, along) <= out.tolerance);
      }
    }
    gained += energy(after(m, impulse.j)) > energy(m) * (1 + 1e-9);
  }
  CHECK(stuck > 500);
  CHECK(gained > 0);
}

TEST_CASE("Poisson's restitution never gains energy, and bodies part") {
  Meetings meetings;
  for (int i = 0; i < 4000; ++i) {
    const Meeting m = meetings.next();
    const Impulse impulse = poisson(m.a, m.b, m.touch);
    const Outcome out(m, impulse.j);
    INFO(i);

    // Rounding changes the energy by as much as it changes the velocities, and by what
    // adding it up rounds
    CHECK(energy(after(m, impulse.j))
          <= energy(m) * (1 + 32 * k_u) + out.tolerance * glm::length(impulse.j));
    CHECK(out.normal_after >= -out.tolerance);
    CHECK(glm::length(out.j_slip) <= m.touch.mu * out.j_normal + out.cone_tolerance);

    // The normal impulse is that of compression and e of it, or more
    const Touch plastic{m.touch.point, m.touch.normal, 0, m.touch.mu};
    const dvec3 compression = coupled_friction(m.a, m.b, plastic).j;
    const double least =
        (1 + m.touch.restitution) * glm::dot(compression, m.touch.normal);
    CHECK(out.j_normal >= least - 32 * k_u * glm::length(impulse.j));
    if (m.touch.restitution == 0)
      CHECK(glm::distance(impulse.j, compression)
            <= 8 * k_u * glm::length(compression));
    if (m.touch.mu == 0) {
      const dvec3 smooth = frictionless(m.a, m.b, m.touch).j;
      CHECK(glm::distance(impulse.j, smooth) <= 64 * k_u * glm::length(smooth));
    }
  }
}

TEST_CASE(
    "one pass of sequential friction is Coulomb's, but may leave bodies closing") {
  Meetings meetings;
  int closing = 0;
  for (int i = 0; i < 2000; ++i) {
    const Meeting m = meetings.next();
    const Impulse impulse = sequential_friction(m.a, m.b, m.touch);
    const Outcome out(m, impulse.j);
    const Outcome smooth(m, frictionless(m.a, m.b, m.touch).j);
    INFO(i);
    CHECK(out.j_normal
          == Approx(smooth.j_normal).margin(16 * k_u * glm::length(impulse.j)));
    CHECK(glm::length(out.j_slip) <= m.touch.mu * out.j_normal + out.cone_tolerance);

    // Along the slip that the first impulse left it stops at most
    const double speed = glm::length(smooth.slip);
    if (speed > 0) {
      const double left = glm::dot(out.after, smooth.slip / speed);
      CHECK(left >= -out.tolerance);
      if (impulse.slip == Slip::sticks) CHECK(left <= out.tolerance);
    }
    closing += out.normal_after < -0.1;
  }
  CHECK(closing > 0);
}

TEST_CASE("impacts conserve momentum, and swapping the bodies changes nothing") {
  Meetings meetings;
  for (int i = 0; i < 500; ++i) {
    const Meeting m = meetings.next();
    Touch back = m.touch;
    back.normal = -back.normal;
    INFO(i);
    for (const Law law :
         {frictionless, sequential_friction, coupled_friction, poisson}) {
      const dvec3 j = law(m.a, m.b, m.touch).j;
      const Outcome out(m, j);
      const dvec3 swapped = law(m.b, m.a, back).j;

      // 1 + mu^2 at most enlarges what rounding does to the normal impulse, unless
      // friction stops the slip before
      CHECK(glm::distance(j, -swapped) <= 4096 * k_u * out.condition * glm::length(j));
      if (m.a.inverse_mass == 0) continue;
      const Meeting end = after(m, j);
      const dvec3 momentum =
          m.a.velocity / m.a.inverse_mass + m.b.velocity / m.b.inverse_mass;
      const dvec3 then =
          end.a.velocity / m.a.inverse_mass + end.b.velocity / m.b.inverse_mass;
      CHECK(glm::distance(momentum, then)
            <= 16 * k_u
                   * (glm::length(m.a.velocity) / m.a.inverse_mass
                      + glm::length(m.b.velocity) / m.b.inverse_mass + glm::length(j)));
    }
  }
}

TEST_CASE("a rod shows how Newton's restitution gains energy and Poisson's does not") {
  // 1 kg, 1 m, at 45 degrees: K = (5/2, -3/2; -3/2, 5/2), v = (3/5, -1). By hand:
  // Newton sticks, K j = (-3/5, 2). Poisson sticks in compression with c = (0, 2/5),
  // and then slides with (1/5, 2/5)
  const double s = std::sqrt(0.125);
  Body rod = box(1, {1, 0, 0}, glm::angleAxis(std::numbers::pi / 4, dvec3(0, 0, 1)));
  rod.inverse_inertia = dmat3(12);
  rod.velocity = {0.6, -1, 0};
  const Meeting m{k_ground, rod, {{-s, -s, 0}, {0, 1, 0}, 1, 0.5}};
  CHECK(energy(m) == Approx(0.68).epsilon(8 * k_u));

  const Impulse newton = coupled_friction(m.a, m.b, m.touch);
  CHECK(newton.slip == Slip::sticks);
  CHECK(glm::distance(newton.j, {0.375, 1.025, 0}) <= 16 * k_u);
  CHECK(energy(after(m, newton.j)) == Approx(0.7925).epsilon(32 * k_u));

  const Impulse kind = poisson(m.a, m.b, m.touch);
  CHECK(kind.slip == Slip::slides);
  CHECK(glm::distance(kind.j, {0.2, 0.8, 0}) <= 16 * k_u);
  CHECK(energy(after(m, kind.j)) == Approx(0.61).epsilon(32 * k_u));
  CHECK(Outcome(m, kind.j).normal_after == Approx(0.7).epsilon(32 * k_u));
}

TEST_CASE(
    "where friction presses a rod down, it jams: the impulses exist all the same") {
  // Painlevé's rod slides on the end that leads, at atan 2 to the floor: beyond mu =
  // 4/3 friction turns it into the floor faster than the normal impulse lifts it
  const double half = 0.5;
  const dvec3 end{half / std::sqrt(5.0), -half * 2 / std::sqrt(5.0), 0};
  for (const double mu : {1.0, 1.3, 1.34, 2.0, 50.0}) {
    for (const double down : {1.0, 1e-3, 1e-9}) {
      for (const double e : {0.0, 0.5, 1.0}) {
        Body rod = k_ground;
        rod.inverse_mass = 1;
        rod.inverse_inertia = dmat3(12);
        rod.velocity = {4, -down, 0};
        const Meeting m{k_ground, rod, {end, {0, 1, 0}, e, mu}};
        const Outcome newton(m, coupled_friction(m.a, m.b, m.touch).j);
        const Impulse impulse = poisson(m.a, m.b, m.touch);
        const Outcome out(m, impulse.j);
        INFO("mu " << mu << " down " << down << " e " << e);
        CHECK(newton.normal_after == Approx(e * down).margin(newton.tolerance));
        CHECK(out.normal_after >= -out.tolerance);
        CHECK(energy(after(m, impulse.j))
              <= energy(m) + out.tolerance * glm::length(impulse.j));

        // Below 4/3 a light touch has a light impulse, (1 + e) down / (1.6 - 1.2 mu),
        // that takes 3.4 mu - 1.2 of that from the slip; above, none does but what
        // stops the slip
        const double speed = glm::length(newton.slip);
        if (mu < 1.31 && down < 0.1) CHECK(speed > 4 - 162 * down);
        if (mu > 4.0 / 3 && e == 0) CHECK(speed <= newton.tolerance);
      }
    }
  }
}

TEST_CASE("bodies that part or rest on each other feel no impulse") {
  Body ball = box(2, dvec3(1), {1, 0, 0, 0});
  for (const double up : {0.0, 1.0}) {
    ball.velocity = {3, up, 0};
    const Touch touch{{0, -0.5, 0}, {0, 1, 0}, 0.5, 0.5};
    for (const Law law :
         {frictionless, sequential_friction, coupled_friction, poisson}) {
      CHECK(law(k_ground, ball, touch).j == dvec3(0));
      CHECK(law(k_ground, ball, touch).slip == Slip::parts);
    }
  }
}

TEST_CASE("slight friction, slight impacts and heavy ones have their impulses") {
  Meetings meetings;
  for (int i = 0; i < 200; ++i) {
    const Meeting m = meetings.next();
    for (const double mu : {1e-300, 1e-90, 1e-8, 1e300}) {
      for (const double scale : {1e-290, 1e-20, 1.0, 1e20, 1e290}) {
        Meeting scaled = m;
        for (Body* body : {&scaled.a, &scaled.b}) {
          body->velocity *= scale;
          body->angular_velocity *= scale;
        }
        scaled.touch.mu = mu;
        INFO(i << " mu " << mu << " scale " << scale);

        // Impulses grow with velocities; without friction or all but, they are alike
        const dvec3 smooth = frictionless(m.a, m.b, m.touch).j;
        for (const Law law : {coupled_friction, poisson}) {
          const dvec3 j = law(scaled.a, scaled.b, scaled.touch).j / scale;
          CHECK(std::isfinite(glm::length(j)));
          if (mu > 1e-8) continue;
          const double condition = Outcome(m, smooth).condition;
          CHECK(glm::distance(j, smooth)
                <= (64 * k_u + 4 * mu) * condition * glm::length(smooth));
        }
      }
    }
  }
}

TEST_CASE("a ball bounces by every law as by its own formula") {
  const dvec3 down{0, 0, -0.25};
  for (const double k : {0.4, 2.0 / 3, 1e-6}) {
    for (const double mu : {0.0, 0.05, 0.2, 5.0, 1e9}) {
      for (const double e : {0.0, 0.6, 1.0}) {
        const Ball ball{.mass = 3, .radius = 0.25, .k = k, .mu = mu, .g = 0};
        const BallMotion before{{}, {2, -1, -3}, {7, 40, -9}};
        const auto [impulse, end] = bounced(ball, e, before);
        const double I = k * 3 * 0.0625;
        const Body body{1.0 / 3, dmat3(1 / I), dvec3(0), before.v, before.omega};
        const Touch touch{down, {0, 0, 1}, e, mu};
        INFO("k " << k << " mu " << mu << " e " << e);
        for (const Law law : {sequential_friction, coupled_friction, poisson}) {
          const dvec3 j = law(k_ground, body, touch).j;
          CHECK(glm::distance(j, impulse.j) <= 64 * k_u * glm::length(j));
          const Body then = pushed(body, impulse.j, down);
          CHECK(glm::distance(then.velocity, end.v) <= 16 * k_u * 10);
          CHECK(glm::distance(then.angular_velocity, end.omega)
                <= 16 * k_u * (50 + glm::length(impulse.j) * 0.25 / I));
        }
        CHECK(end.v.z == Approx(3 * e).margin(8 * k_u));
        CHECK(end.omega.z == -9);
        if (impulse.slip == Slip::sticks)
          CHECK(glm::length(slip(ball, end)) <= 64 * k_u * 20);
      }
    }
  }
}

TEST_CASE("a box that falls on its corner obeys the general laws") {
  for (const double tilt : {0.0, 0.1, -0.4, 0.7, 1.5, 2.0, -3.0}) {
    for (const dvec2& size : {dvec2(1, 1), {1e-3, 2e-3}, {1000, 1}}) {
      for (const double e : {0.0, 0.5, 1.0}) {
        const FallingBox falling{2, size.x, size.y, tilt, 3};
        const dvec2 arm = lowest_corner(falling);
        Body body = box(2, {size, 1}, {1, 0, 0, 0});
        body.inverse_inertia =
            dmat3(12 / (2 * (size.x * size.x + size.y * size.y)));  // about z alone
        body.velocity = {0, -3, 0};
        const Touch touch{{arm, 0}, {0, 1, 0}, e, 1e9};
        INFO("tilt " << tilt << " width " << size.x << " e " << e);

        // No corner is lower
        for (const double x : {-size.x, size.x})
          for (const double y : {-size.y, size.y})
            CHECK((std::sin(tilt) * x + std::cos(tilt) * y) / 2
                  >= arm.y - 8 * k_u * (size.x + size.y));

        const auto smooth = corner_bounces(falling, e);
        const dvec3 j = frictionless(k_ground, body, touch).j;
        CHECK(glm::distance(j, dvec3(smooth.impulse, 0)) <= 32 * k_u * j.y);
        const Body rebound = pushed(body, j, touch.point);
        const double spin = glm::length(j) / glm::length(size);
        CHECK(rebound.angular_velocity.z
              == Approx(smooth.omega).margin(64 * k_u * spin));
        CHECK(smooth.v.y + smooth.omega * arm.x == Approx(3 * e).margin(64 * k_u * 3));
        if (e > 0) continue;

        const auto catches = corner_catches(falling);
        const dvec3 stop = coupled_friction(k_ground, body, touch).j;
        CHECK(glm::distance(stop, dvec3(catches.impulse, 0)) <= 256 * k_u * stop.y);
        const dvec2 corner = catches.v + catches.omega * dvec2(-arm.y, arm.x);
        CHECK(glm::length(corner) <= 16 * k_u * 3);
      }
    }
  }
}

TEST_CASE("discs meet when they touch, and bounce along the line of centres") {
  Meetings random;
  int hits = 0;
  std::mt19937 bits(7);
  const auto number = [&] {
    return 2 * double(bits()) / double(std::mt19937::max()) - 1;
  };
  for (int i = 0; i < 2000; ++i) {
    const double scale = std::pow(10, 6 * number());
    const dvec2 far = scale * dvec2{number(), number()};
    const Disc a{std::pow(10, 3 * number()), scale * (0.4 + 0.1 * number()), far,
                 scale * dvec2{number(), number()}};
    const Disc b{std::pow(10, 3 * number()), scale * (0.4 + 0.1 * number()),
                 far + scale * dvec2{2 + number(), number()},
                 scale * dvec2{number(), number()}};
    const double e = i % 3 / 2.0;
    const auto impact = disc_impact(a, b, e);
    const dvec2 x = b.x - a.x;
    const dvec2 v = b.v - a.v;
    INFO(i);

    // The nearest that they come
    const double nearest_time = -glm::dot(x, v) / glm::dot(v, v);
    const double nearest = glm::length(x + v * nearest_time);
    const double reach = a.radius + b.radius;
    CHECK(impact.has_value() == (nearest_time > 0 && nearest < reach));
    if (!impact) continue;
    ++hits;
    const auto& [time, normal, impulse, one, other] = *impact;
    CHECK(time <= nearest_time);
    CHECK(glm::distance(one.x, other.x) == Approx(reach).epsilon(64 * k_u));
    CHECK(glm::distance(other.x - one.x, reach * normal) <= 64 * k_u * scale);
    CHECK(glm::dot(other.v - one.v, normal)
          == Approx(-e * glm::dot(v, normal)).margin(64 * k_u * glm::length(v)));
    const dvec2 momentum = a.mass * a.v + b.mass * b.v;
    CHECK(glm::distance(one.mass * one.v + other.mass * other.v, momentum)
          <= 16 * k_u * (a.mass + b.mass) * 2 * scale);
    CHECK(impulse > 0);
  }
  CHECK(hits > 200);
}

TEST_CASE("discs that graze, that overlap and that part") {
  const Disc rest{1, 0.5, {0, 0}, {0, 0}};
  const auto from = [](double aside) { return Disc{1, 0.5, {-1e3, aside}, {1, 0}}; };
  for (const double e : {1e-3, 1e-9, 1e-13}) {
    // Passing `in` inside its reach a disc touches before it is abreast
    const double in = 1 - (1 - e);
    const double ahead = std::sqrt(in * (2 - in));
    const auto impact = disc_impact(from(1 - in), rest, 1);
    REQUIRE(impact);
    CHECK(1000 - impact->time == Approx(ahead).margin(4 * k_u * 1000));
    CHECK(impact->normal.x == Approx(ahead).margin(4 * k_u * 1000));
    CHECK(!disc_impact(from(1 + in), rest, 1));
  }
  const Disc inside{1, 0.5, {-0.25, 0}, {1, 0}};
  const auto at_once = disc_impact(inside, rest, 0.5);
  REQUIRE(at_once);
  CHECK(at_once->time == 0);
  CHECK(at_once->impulse == 0.75);
  const auto swapped = disc_impact(rest, inside, 0.5);
  REQUIRE(swapped);
  CHECK((swapped->time == 0 && swapped->impulse == 0.75));
  CHECK(!disc_impact({1, 0.5, {-0.25, 0}, {-1, 0}}, rest, 1));
  CHECK(!disc_impact(rest, rest, 1));
}
