// Chapter 4's GJK and EPA: against exact pairs, against every direction that there is,
// and what must hold for any pair. Compiled for each precision; u (k_u) is the unit
// round-off of the one at hand.
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <new>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "common/physics/epa.hpp"
#include "tests/catch.hpp"
#include "tests/shape_pairs.hpp"

using namespace timestep;

namespace {

int allocations = 0;

}  // namespace

// Memory by hand is what these functions are for; inlined, gcc takes them for a mistake
// NOLINTBEGIN(cppcoreguidelines-no-malloc, cppcoreguidelines-owning-memory)
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
// NOLINTEND(cppcoreguidelines-no-malloc, cppcoreguidelines-owning-memory)

namespace {

using Json = nlohmann::json;

constexpr Real k_nan = std::numeric_limits<Real>::quiet_NaN();
constexpr Real k_infinity = std::numeric_limits<Real>::infinity();

struct Pair {
  Shape a, b;
  Pose pose_a, pose_b;
  std::array<std::vector<Vec3>, 2> points;
};

Separation separation_of(const Pair& p) {
  return separation(convex(p.a), p.pose_a, convex(p.b), p.pose_b);
}

Separation swapped_of(const Pair& p) {
  return swapped(separation(convex(p.b), p.pose_b, convex(p.a), p.pose_a));
}

// Vertices about the first of them, which is the position: what they have in common
// costs no digits then. First the coordinates are rounded to Real
std::vector<Vec3> read_points(const Json& shape, Pose& pose, double& largest) {
  std::vector<Vec3> points;
  for (const Json& v : shape.at("vertices")) {
    const glm::dvec3 exact(v[0].get<double>(), v[1].get<double>(), v[2].get<double>());
    for (int i = 0; i < 3; ++i) largest = std::max(largest, std::abs(exact[i]));
    points.emplace_back(exact);
  }
  pose.position = points[0];
  for (Vec3& p : points) p -= pose.position;
  return points;
}

std::vector<ExactVec3> placed(std::span<const Vec3> points, const Pose& pose,
                              const Vec3& from) {
  std::vector<ExactVec3> all;
  for (const Vec3& p : points) all.push_back(place(pose, from, p));
  return all;
}

// Clouds of one to eight points, boxes among them, some squeezed to needles and slabs
std::vector<Vec3> some_points(Random& random, double size) {
  const double thin = random.log_between(k_single ? 1e-3 : 1e-8, 1);
  const glm::dvec3 squeezes[] = {{1, 1, 1}, {1, 1, thin}, {1, thin, thin}};
  const Vec3 scale(size * squeezes[random.bits() % 3]);
  std::vector<Vec3> points;
  if (random.bits() % 3 == 0) {
    for (int i = 0; i < 8; ++i)
      points.push_back(scale * Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    return points;
  }
  const std::size_t count = 1 + random.bits() % 8;
  while (points.size() < count) points.push_back(scale * random.in_cube());
  return points;
}

// Turned anyhow, along the same axes, or nearly so
Pose some_pose(Random& random, const Pose& other, double reach) {
  Pose pose{Real(reach * random.between(0, 1)) * random.direction(), random.turn()};
  const auto kind = random.bits() % 4;
  if (kind == 0) pose.orientation = other.orientation;
  if (kind == 1)
    pose.orientation =
        glm::normalize(other.orientation + Real(1e-7) * pose.orientation);
  return pose;
}

// Moves B until the shapes are a given distance apart
void bring_to(Pair& pair, double distance) {
  const Separation s = separation_of(pair);
  pair.pose_b.position += (Real(distance) - s.distance) * s.normal;
}

}  // namespace

TEST_CASE("exact pairs of polyhedra are answered right") {
  std::ifstream file(TIMESTEP_TRUTH "/geometry_public.json");
  const Json document = Json::parse(file);
  REQUIRE(document.at("cases").size() > 100);
  for (const Json& test : document.at("cases")) {
    INFO(test.at("id").get<std::string>());
    Pair pair;
    double largest = 0;
    const Json& inputs = test.at("inputs");
    pair.points = {read_points(inputs.at("A"), pair.pose_a, largest),
                   read_points(inputs.at("B"), pair.pose_b, largest)};
    pair.a = hull_shape(pair.points[0]);
    pair.b = hull_shape(pair.points[1]);
    const Separation s = separation_of(pair);

    // A coordinate rounded to float moves by u of itself, a point by sqrt(3) of that,
    // and there are two shapes; then the error of the query itself
    const Json& expected = test.at("expected");
    const double exact = expected.at("signed_distance").get<double>();
    const double rounded =
        k_single ? 2 * std::sqrt(3) * k_u * largest + double(s.error) : 0;
    const double within = rounded + test.at("tol").at("abs").get<double>()
                          + test.at("tol").at("rel").get<double>() * std::abs(exact);
    CHECK(std::abs(double(s.distance) - exact) <= within);

    // A direction is as good as the overlap along it: ties are of one worth
    const auto a = placed(pair.points[0], pair.pose_a, pair.pose_a.position);
    const auto b = placed(pair.points[1], pair.pose_b, pair.pose_a.position);
    CHECK(double(overlap(a, b, ExactVec3(s.normal))) <= -exact + within);
    const char* const names[] = {"separated", "touching", "penetrating"};
    if (std::abs(exact) > rounded || !k_single)
      CHECK(names[int(contact_of(s))] == expected.at("state"));
    const Vec3 left = s.on_b - s.on_a - s.distance * s.normal;
    CHECK(double(glm::length(left)) <= within + 8 * k_u * largest);
  }
}

TEST_CASE("small hulls have the distance that trying every direction finds") {
  Random random(1);
  int states[3] = {};
  for (int i = 0; i < 6000; ++i) {
    const double size_a = random.log_between(1e-2, 1e2);
    const double size_b =
        random.bits() % 2 == 0 ? size_a : random.log_between(1e-2, 1e2);
    Pair pair;
    pair.points = {some_points(random, size_a), some_points(random, size_b)};
    pair.pose_a.orientation = random.turn();
    pair.pose_b = some_pose(random, pair.pose_a, 1.7 * (size_a + size_b));
    pair.a = hull_shape(pair.points[0]);
    pair.b = hull_shape(pair.points[1]);
    const double nearness[] = {1, 1, 1e-3, 1e-6, 1e-9, 0};
    const double near = nearness[random.bits() % 6];
    if (near < 1)
      bring_to(pair, random.between(-near, near) * std::max(size_a, size_b));

    // From A's position: there the query's own error counts alone
    const auto a = placed(pair.points[0], pair.pose_a, pair.pose_a.position);
    const auto b = placed(pair.points[1], pair.pose_b, pair.pose_a.position);
    const double exact = brute_force_distance(a, b);
    if (!std::isfinite(exact)) continue;
    const Separation s = separation_of(pair);
    const double found = -double(overlap(a, b, ExactVec3(s.normal)));

    // In needles of needles some directions are known worse than `error` says, and so
    // are the directions that are tried
    INFO(i << " " << name_of(s.reason) << " " << double(s.error));
    const double within = (k_single ? 4 : 64) * double(s.error);
    REQUIRE(double(s.distance) >= exact - within);
    REQUIRE(double(s.distance) <= std::max(exact, found) + within);
    REQUIRE(found >= exact - within);
    if (exact > within) REQUIRE(contact_of(s) == Contact::separated);
    if (exact < -within) REQUIRE(contact_of(s) == Contact::penetrating);
    ++states[int(contact_of(s))];
  }
  CHECK(states[int(Contact::separated)] > 1000);
  CHECK(states[int(Contact::touching)] > 500);
  CHECK(states[int(Contact::penetrating)] > 500);
}

TEST_CASE("what holds for any pair holds for each combination of shapes") {
  Random random(2);
  int separated = 0, deep = 0, at_limit = 0;
  for (int n = 0; n < 100 * k_shape_kinds * k_shape_kinds; ++n) {
    const double size_a =
        random.log_between(k_single ? 1e-2 : 1e-4, k_single ? 1e2 : 1e4);
    const double size_b = size_a * random.log_between(1e-2, 1e2);
    Pair p;
    p.a = random_shape(random, n % k_shape_kinds, size_a, p.points[0]);
    p.b = random_shape(random, n / k_shape_kinds % k_shape_kinds, size_b, p.points[1]);
    p.pose_a.orientation = random.turn();
    p.pose_b = some_pose(random, p.pose_a, 1.5 * (size_a + size_b));
    const Separation s = separation_of(p);
    const double size = size_a + size_b + double(glm::length(p.pose_b.position));
    INFO(n << " " << k_shape_names[p.a.index() == 7 ? 6 : p.a.index()] << " "
           << k_shape_names[p.b.index() == 7 ? 6 : p.b.index()] << " "
           << name_of(s.reason));
    REQUIRE(std::isfinite(s.distance));
    REQUIRE(double(glm::length(s.normal)) == Approx(1).margin(8 * k_u));
    if (s.reason == Reason::iteration_limit) ++at_limit;

    // A and B have the same part in it, and where the world's origin is has none
    const double within =
        s.reason == Reason::iteration_limit ? 1e-3 * size : 4 * double(s.error);
    REQUIRE(double(swapped_of(p).distance)
            == Approx(double(s.distance)).margin(within));
    const Pose move{Real(size) * random.in_cube(), random.turn()};
    Pair moved = p;
    for (Pose* pose : {&moved.pose_a, &moved.pose_b})
      *pose = {point_in_world(move, pose->position),
               glm::normalize(move.orientation * pose->orientation)};
    REQUIRE(double(separation_of(moved).distance)
            == Approx(double(s.distance)).margin(within + 64 * k_u * size));

    // The witness points are that far from each other, and on their shapes: exactly at
    // the planes that the normal is for
    const Vec3 left = s.on_b - s.on_a - s.distance * s.normal;
    REQUIRE(double(glm::length(left)) <= 32 * k_u * size);
    const auto height = [&](const Shape& shape, const Pose& pose, const Vec3& normal) {
      const Convex body = convex(shape);
      std::uint32_t vertex = 0;
      const Vec3 d = direction_in_body(pose, normal);
      const Vec3 top = point_in_world(pose, body.core_support(body.shape, d, vertex));
      return double(glm::dot(normal, top) + body.radius);
    };
    const double above_a =
        double(glm::dot(s.normal, s.on_a)) - height(p.a, p.pose_a, s.normal);
    const double above_b =
        double(glm::dot(-s.normal, s.on_b)) - height(p.b, p.pose_b, -s.normal);
    REQUIRE(std::abs(above_a) <= within + 32 * k_u * size);
    REQUIRE(std::abs(above_b) <= within + 32 * k_u * size);

    // A little more than the depth takes them apart, a little less does not
    if (s.distance > 0) ++separated;
    if (double(s.distance) > -1e3 * double(s.error)) continue;
    ++deep;
    Pair apart = p, still = p;
    apart.pose_b.position -= Real(1.01) * s.distance * s.normal;
    still.pose_b.position -= Real(0.99) * s.distance * s.normal;
    REQUIRE(separation_of(apart).distance > 0);
    REQUIRE(separation_of(still).distance < 0);
  }
  CHECK(separated > 1000);
  CHECK(deep > 1000);
  CHECK(at_limit < 100);
}

TEST_CASE("flat, touching and coincident shapes have an answer") {
  const std::array point{Vec3(0)};
  const std::array segment{Vec3(-1, 0, 0), Vec3(1, 0, 0)};
  const std::array triangle{Vec3(-1, -1, 0), Vec3(2, -1, 0), Vec3(-1, 2, 0)};
  const Pose here, turned{Vec3(0), Quat(glm::normalize(glm::dquat(1, 0, 0, 1)))};
  const auto distance = [](const HullShape& a, const Pose& pose_a, const HullShape& b,
                           const Pose& pose_b) {
    const Shape shape_a = a, shape_b = b;
    const Separation s = separation(convex(shape_a), pose_a, convex(shape_b), pose_b);
    CHECK(double(glm::length(s.normal)) == Approx(1).margin(8 * k_u));
    CHECK(double(glm::length(s.on_b - s.on_a - s.distance * s.normal)) <= 16 * k_u);
    return double(s.distance);
  };
  const HullShape p = hull_shape(point), l = hull_shape(segment),
                  t = hull_shape(triangle);
  const double rounding = 16 * k_u;
  CHECK(distance(p, here, p, here) == 0);
  CHECK(distance(p, here, p, {{3, 4, 0}}) == 5);
  CHECK(std::abs(distance(l, here, l, here)) <= rounding);
  CHECK(std::abs(distance(l, here, l, turned)) <= rounding);
  CHECK(distance(l, here, l, {{3, 0, 0}}) == Approx(1).margin(rounding));
  CHECK(std::abs(distance(t, here, t, here)) <= rounding);
  CHECK(std::abs(distance(t, here, t, turned)) <= rounding);
  CHECK(std::abs(distance(p, here, t, here)) <= rounding);
  CHECK(distance(t, here, t, {{0, 0, Real(1e-3)}}) == Approx(1e-3).margin(rounding));

  // Boxes: the same one, face to face, edge to edge and corner to corner
  const Shape box = Box{{1, 1, 1}};
  const auto boxes = [&](const Vec3& at) {
    return separation(convex(box), here, convex(box), {at});
  };
  CHECK(boxes({0, 0, 0}).distance == -2);
  for (const Vec3& at :
       {Vec3(2, 0, 0), Vec3(2, Real(0.5), 1), Vec3(2, 2, 0), Vec3(2, 2, 2)}) {
    CHECK(std::abs(double(boxes(at).distance)) <= rounding);
    CHECK(contact_of(boxes(at)) == Contact::touching);
  }
}

TEST_CASE("a unit of length twice as long changes no bit but the exponent") {
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    Pair pair;
    pair.a = random_shape(random, 6, 1, pair.points[0]);
    pair.b = random_shape(random, 6, 1, pair.points[1]);
    pair.pose_a.orientation = random.turn();
    pair.pose_b = some_pose(random, pair.pose_a, 2);
    const Separation s = separation_of(pair);
    for (const int exponent : k_single ? std::array{-60, 60} : std::array{-400, 400}) {
      const Real scale = std::ldexp(Real(1), exponent);
      Pair scaled = pair;
      for (auto& points : scaled.points)
        for (Vec3& p : points) p *= scale;
      scaled.a = hull_shape(scaled.points[0]);
      scaled.b = hull_shape(scaled.points[1]);
      scaled.pose_b.position *= scale;
      const Separation other = separation_of(scaled);
      REQUIRE(other.distance == scale * s.distance);
      REQUIRE(other.normal == s.normal);
      REQUIRE(other.iterations == s.iterations);
    }
  }
}

TEST_CASE("input that is not finite or too large has a reason, not an answer") {
  const Shape box = Box{{1, 1, 1}};
  const auto reason = [&](const Shape& shape, const Pose& pose) {
    const Separation s = separation(convex(box), {}, convex(shape), pose);
    CHECK(s.distance == 0);
    CHECK(!intersect(convex(box), {}, convex(shape), pose));
    return s.reason;
  };
  constexpr Real huge = std::numeric_limits<Real>::max();
  CHECK(reason(box, {{k_nan, 0, 0}}) == Reason::out_of_range);
  CHECK(reason(box, {{0, k_infinity, 0}}) == Reason::out_of_range);
  CHECK(reason(box, {Vec3(0), {k_nan, 0, 0, 0}}) == Reason::out_of_range);
  CHECK(reason(Box{{k_infinity, 1, 1}}, {}) == Reason::out_of_range);
  CHECK(reason(Sphere{k_nan}, {}) == Reason::out_of_range);
  CHECK(reason(box, {{huge, huge, huge}}) == Reason::out_of_range);

  // Almost too large, almost nothing, and nothing
  const Shape great = Box{Vec3(huge / 8)}, least = Box{Vec3(huge > 0 ? 1 / huge : 0)};
  CHECK(std::isfinite(separation(convex(great), {}, convex(great), {}).distance));
  CHECK(std::isfinite(separation(convex(least), {}, convex(least), {}).distance));
  const Shape nothing = Sphere{0};
  CHECK(separation(convex(nothing), {}, convex(nothing), {}).distance == 0);
}

TEST_CASE("whether shapes meet is known sooner than how far apart they are") {
  Random random(6);
  int meeting = 0;
  for (int i = 0; i < 3000; ++i) {
    Pair p;
    p.a = random_shape(random, i % k_shape_kinds, 1, p.points[0]);
    p.b = random_shape(random, i / k_shape_kinds % k_shape_kinds, 1, p.points[1]);
    p.pose_a.orientation = random.turn();
    p.pose_b = some_pose(random, p.pose_a, 3);
    const Separation s = separation_of(p);
    if (contact_of(s) == Contact::touching) continue;
    INFO(i);
    REQUIRE(intersect(convex(p.a), p.pose_a, convex(p.b), p.pose_b)
            == (s.distance < 0));
    meeting += s.distance < 0;
  }
  CHECK(meeting > 500);
  CHECK(meeting < 2500);
}

TEST_CASE("a warm start finds the same distance with fewer support points") {
  Random random(8);
  int cold = 0, warm = 0;
  for (int i = 0; i < 300; ++i) {
    Pair p;
    p.a = random_shape(random, 6, 1, p.points[0]);
    p.b = random_shape(random, 6, 1, p.points[1]);
    p.pose_b = some_pose(random, p.pose_a, 1);
    bring_to(p, 0.5);
    const Vec3 velocity = Real(0.01) * random.direction();
    GjkCache cache;
    for (int frame = 0; frame < 60; ++frame) {
      const Separation afresh = separation_of(p);
      const Separation again =
          separation(convex(p.a), p.pose_a, convex(p.b), p.pose_b, &cache);
      const double within = 4 * double(afresh.error);
      REQUIRE(double(again.distance) == Approx(double(afresh.distance)).margin(within));
      if (frame > 0 && afresh.distance > 0) {
        cold += afresh.iterations;
        warm += again.iterations;
      }
      p.pose_b.position += velocity;
    }
  }
  CHECK(warm < 0.4 * cold);
}

TEST_CASE("no query allocates") {
  Random random(9);
  for (int i = 0; i < 200; ++i) {
    Pair p;
    p.a = random_shape(random, i % k_shape_kinds, 1, p.points[0]);
    p.b = random_shape(random, i / k_shape_kinds % k_shape_kinds, 1, p.points[1]);
    p.pose_b = some_pose(random, p.pose_a, 1.5);
    GjkCache cache;
    const int before = allocations;
    separation(convex(p.a), p.pose_a, convex(p.b), p.pose_b, &cache);
    intersect(convex(p.a), p.pose_a, convex(p.b), p.pose_b);
    REQUIRE(allocations == before);
  }
}
