// Contacts between bodies, and the five ways out of a penetration.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "common/physics/mass_properties.hpp"
#include "common/physics/world.hpp"
#include "tests/catch.hpp"

using namespace timestep;

namespace {

constexpr Real k_u = std::numeric_limits<Real>::epsilon() / 2;

RigidBody box(Real mass, const Vec3& half, const Vec3& position) {
  RigidBody body = body_with_mass(mass, solid_box(mass, Real(2) * half).inertia);
  body.position = position;
  return body;
}

// Random numbers whose sequence the standard fixes
struct Random {
  std::mt19937 bits{5};
  Real operator()(Real low, Real high) {
    return low + (high - low) * Real(bits()) / Real(std::mt19937::max());
  }
  Vec3 vector(Real size) {
    return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)};
  }
};

std::vector<PointContact> contacts_of(std::span<const RigidBody> bodies,
                                      std::span<const Collider> colliders,
                                      Real margin) {
  ContactSearch search;
  std::vector<PointContact> contacts;
  find_contacts(bodies, colliders, margin, 0, Real(0.01), search, contacts);
  return contacts;
}

std::vector<Collider> with_ids(std::vector<Collider> colliders) {
  for (std::uint32_t i = 0; i < colliders.size(); ++i)
    colliders[i].body = colliders[i].id = i;
  return colliders;
}

// A feather in a ball: masses 1:1000, 0.1 m deep, along x
struct Pair {
  std::vector<RigidBody> bodies{box(1, Vec3(Real(0.5)), {0, 0, 0}),
                                box(1000, Vec3(Real(0.5)), {Real(0.9), 0, 0})};
  std::vector<Collider> colliders =
      with_ids({{.shape = Box{Vec3(Real(0.5))}}, {.shape = Box{Vec3(Real(0.5))}}});
};

// A box in three planes at once, 5, 10 and 20 mm deep, turned a little
struct Corner {
  std::vector<RigidBody> bodies;
  std::vector<Collider> colliders;
  Corner() {
    const Vec3 half(Real(0.5));
    bodies = {{}, {}, {}, box(1, half, {Real(0.48), Real(0.495), Real(0.49)})};
    bodies[3].orientation = rotation_by({Real(0.003), Real(0.002), Real(-0.004)});
    colliders = with_ids({{.shape = HalfSpace{{1, 0, 0}, 0}},
                          {.shape = HalfSpace{{0, 1, 0}, 0}},
                          {.shape = HalfSpace{{0, 0, 1}, 0}},
                          {.shape = Box{half}}});
  }
};

Real deepest(std::span<const PointContact> contacts) {
  return std::ranges::max_element(contacts, {}, &PointContact::depth)->depth;
}

}  // namespace

TEST_CASE("a box on another touches it in four points") {
  const std::vector bodies{box(1, Vec3(1), {0, 0, 0}), box(2, Vec3(1), {0, 2, 0})};
  auto colliders = with_ids({{.shape = Box{Vec3(1)}}, {.shape = Box{Vec3(1)}}});
  colliders[0].friction = Real(0.25);
  colliders[1].friction = 1;
  colliders[1].restitution = Real(0.5);
  const auto contacts = contacts_of(bodies, colliders, Real(0.01));
  REQUIRE(contacts.size() == 4);
  for (const PointContact& c : contacts) {
    CHECK(c.a == 0);
    CHECK(c.b == 1);
    CHECK(c.normal == Vec3(0, 1, 0));
    CHECK(std::abs(c.depth) <= 8 * k_u);  // of positions up to 2 m
    CHECK(c.friction == Real(0.5));
    CHECK(c.restitution == Real(0.5));
  }
}

TEST_CASE("pairs are those that all pairs of boxes give, in order") {
  Random random;
  std::vector<RigidBody> bodies;
  std::vector<Collider> colliders;
  for (int i = 0; i < 200; ++i) {
    const Vec3 half(random(Real(0.1), 1), random(Real(0.1), 1), random(Real(0.1), 1));
    bodies.push_back(box(1, half, random.vector(6)));
    if (i % 5 == 0) bodies.back().inverse_mass = 0;
    colliders.push_back({.shape = Box{half}});
  }
  bodies.emplace_back();
  colliders.push_back({.shape = HalfSpace{{0, 1, 0}, -3}});
  colliders = with_ids(colliders);
  ContactSearch search;
  std::vector<PointContact> contacts;
  find_contacts(bodies, colliders, 0, 0, Real(0.01), search, contacts);

  std::size_t found = 0;
  for (std::uint32_t i = 0; i < colliders.size(); ++i) {
    for (std::uint32_t k = i + 1; k < colliders.size(); ++k) {
      const Bounds &a = search.boxes[i], &b = search.boxes[k];
      const bool apart = glm::any(glm::lessThan(a.high, b.low))
                         || glm::any(glm::lessThan(b.high, a.low));
      if (apart || (bodies[i].inverse_mass == 0 && bodies[k].inverse_mass == 0))
        continue;
      REQUIRE(found < search.pairs.size());
      CHECK(search.pairs[found].a == i);
      CHECK(search.pairs[found].b == k);
      ++found;
    }
  }
  CHECK(found == search.pairs.size());
  CHECK(found > 100);
}

TEST_CASE("what is faster than the margin is found before it arrives") {
  std::vector bodies{box(1, Vec3(1), {0, 0, 0}), box(1, Vec3(1), {0, Real(2.5), 0})};
  const auto colliders = with_ids({{.shape = Box{Vec3(1)}}, {.shape = Box{Vec3(1)}}});
  CHECK(contacts_of(bodies, colliders, Real(0.1)).empty());
  bodies[1].velocity = {0, -60, 0};
  const auto contacts = contacts_of(bodies, colliders, Real(0.1));
  REQUIRE(contacts.size() == 4);
  CHECK(contacts[0].depth == Real(-0.5));
}

TEST_CASE("a contact has the impulse of the same feature, or of the nearest left") {
  const auto point = [](std::uint64_t feature, Real x, Real impulse) {
    PointContact c{};
    c.collider_a = 1;
    c.collider_b = 2;
    c.feature = feature;
    c.position = {x, 0, 0};
    c.impulse = {0, impulse, 0};
    return c;
  };
  const std::vector before{point(7, 0, 1), point(8, 1, 2), point(9, 2, 3)};
  std::vector now{point(8, Real(0.001), 0), point(5, Real(0.002), 0),
                  point(6, Real(0.003), 0), point(4, Real(2.2), 0)};
  auto other = point(7, 0, 0);
  other.collider_b = 3;
  now.push_back(other);
  carry_impulses(before, Real(0.01), now);
  CHECK(now[0].impulse.y == 2);  // as it is named, wherever it is
  CHECK(now[1].impulse.y == 1);  // the nearest
  CHECK(now[2].impulse.y == 0);  // that is taken
  CHECK(now[3].impulse.y == 0);  // too far away
  CHECK(now[4].impulse.y == 0);  // another pair
}

TEST_CASE("Formula 4 shares a penetration by mass") {
  Pair pair;
  const auto before = pair.bodies;
  auto contacts = contacts_of(pair.bodies, pair.colliders, 0);
  REQUIRE(contacts.size() == 4);
  PenetrationRoom room;
  linear_projection(pair.bodies, contacts, {.iterations = 1, .slop = 0, .beta = 1},
                    Real(0.01), room);
  const Real depth = Real(0.1),
             moved_a = before[0].position.x - pair.bodies[0].position.x;
  const Real moved_b = pair.bodies[1].position.x - before[1].position.x;

  // Positions of 1 m are rounded after each of a few operations
  CHECK(std::abs(moved_a - depth * 1000 / 1001) <= 8 * k_u);
  CHECK(std::abs(moved_b - depth * 1 / 1001) <= 8 * k_u);
  CHECK(deepest(contacts) <= 8 * k_u);
}

TEST_CASE("no way out moves the centre of mass") {
  for (const PenetrationMethod& method : penetration_methods()) {
    INFO(method.name);
    Pair pair;
    auto contacts = contacts_of(pair.bodies, pair.colliders, 0);
    PenetrationRoom room;
    for (int i = 0; i < 50; ++i) {
      method.step(pair.bodies, contacts, {}, Real(0.01), room);
      const RigidBody &a = pair.bodies[0], &b = pair.bodies[1];

      // Sums of 1001 kg m and 1001 kg m/s; 50 steps of at most 20 iterations over four
      // contacts, with four roundings each, as random as a walk: sqrt(16000) = 127
      const Real p = a.velocity.x + 1000 * b.velocity.x;
      const Real x = a.position.x + 1000 * b.position.x;
      CHECK(std::abs(p) <= 127 * 1001 * k_u);
      CHECK(std::abs(x - 900) <= 127 * 1001 * k_u);
    }
  }
}

TEST_CASE("the worst first leaves less than epsilon, even in a corner") {
  Corner corner;
  auto contacts = contacts_of(corner.bodies, corner.colliders, Real(0.05));
  REQUIRE(contacts.size() >= 9);
  CHECK(deepest(contacts) > Real(0.01));
  const PenetrationSettings settings{.iterations = 1000, .epsilon = Real(1e-4)};
  PenetrationRoom room;
  worst_first_projection(corner.bodies, contacts, settings, Real(0.01), room);
  CHECK(deepest(contacts) <= settings.epsilon);

  // As found anew: the turn of 0.02 rad or less is the same to second order, over an
  // arm of 0.9 m
  const auto found = contacts_of(corner.bodies, corner.colliders, Real(0.05));
  CHECK(deepest(found) <= settings.epsilon + Real(0.02 * 0.02 * 0.9));
}

TEST_CASE("positions converge to the slop") {
  const PenetrationSettings settings{.iterations = 200, .slop = Real(1e-3)};
  for (const char* name : {"linear_projection", "ngs"}) {
    INFO(name);
    Corner corner;
    auto contacts = contacts_of(corner.bodies, corner.colliders, Real(0.05));
    PenetrationRoom room;
    find_penetration_method(name)->step(corner.bodies, contacts, settings, Real(0.01),
                                        room);

    // A share of 0.2 a sweep: 0.8^200 is nothing, so what is left is that a contact's
    // way out is another's way in. Formula 4 does not turn, and so cannot disturb the
    // others at all here: its planes are at right angles
    CHECK(deepest(contacts) <= settings.slop + Real(1e-6));
  }
}

TEST_CASE("Baumgarte leaves a velocity, split impulses and positions leave none") {
  for (const PenetrationMethod& method : penetration_methods()) {
    INFO(method.name);
    Corner corner;
    auto contacts = contacts_of(corner.bodies, corner.colliders, Real(0.05));
    PenetrationRoom room;
    method.step(corner.bodies, contacts, {}, Real(0.01), room);
    const Real speed = glm::length(corner.bodies[3].velocity);
    if (method.name == "baumgarte")
      CHECK(speed > Real(0.1));  // 0.2 of 5 mm and more in 10 ms
    else
      CHECK(speed == 0);
  }
}

TEST_CASE("the two bodies of a contact are alike to every way out") {
  for (const PenetrationMethod& method : penetration_methods()) {
    INFO(method.name);
    Corner corner, mirrored;
    auto contacts = contacts_of(corner.bodies, corner.colliders, Real(0.05));
    auto swapped = contacts;
    for (PointContact& c : swapped) {
      std::swap(c.a, c.b);
      c.normal = -c.normal;
    }
    PenetrationRoom room;
    method.step(corner.bodies, contacts, {}, Real(0.01), room);
    method.step(mirrored.bodies, swapped, {}, Real(0.01), room);
    const RigidBody &one = corner.bodies[3], &other = mirrored.bodies[3];

    // 20 sweeps over up to 12 contacts, 8 roundings each of a metre or a metre a second
    CHECK(glm::length(one.position - other.position) <= 20 * 12 * 8 * k_u);
    CHECK(glm::length(one.velocity - other.velocity) <= 20 * 12 * 8 * k_u);
  }
}
