// Chapter 4's GJK and EPA: against exact pairs, on flat and touching shapes, on input
// that is none, and how they go about it. Compiled for each precision; u (k_u) is the
// unit round-off of the one at hand.
#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "common/physics/epa.hpp"
#include "tests/allocations.hpp"
#include "tests/catch.hpp"
#include "tests/shape_pairs.hpp"

using namespace timestep;

namespace {

using Json = nlohmann::json;

constexpr Real k_nan = std::numeric_limits<Real>::quiet_NaN();
constexpr Real k_infinity = std::numeric_limits<Real>::infinity();

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
  CHECK(reason(Ellipsoid{{1, k_nan, 1}}, {}) == Reason::out_of_range);
  CHECK(reason(Cone{k_nan, 1}, {}) == Reason::out_of_range);
  CHECK(reason(box, {{0, k_nan, k_nan}}) == Reason::out_of_range);
  const std::array nowhere{Vec3(0, k_nan, k_nan), Vec3(1, 0, 0)};
  CHECK(reason(hull_shape(nowhere), {}) == Reason::out_of_range);
  CHECK(reason(Cylinder{1, k_nan}, {}) == Reason::out_of_range);
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
