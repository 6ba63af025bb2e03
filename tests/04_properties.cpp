// What holds for any two shapes, whatever chapter 4 says of them: for every
// combination, sizes over eight decades, needles, slabs and all between. 2,000 pairs a
// combination, or as many as TIMESTEP_PAIRS says. Compiled for each precision; u (k_u)
// is the unit round-off of the one at hand.
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "common/physics/convex_hull.hpp"
#include "common/physics/pair_query.hpp"
#include "tests/catch.hpp"
#include "tests/shape_pairs.hpp"

using namespace timestep;

namespace {

int pairs_per_combination() {
  const char* wanted = std::getenv("TIMESTEP_PAIRS");
  return wanted == nullptr ? 2000 : std::atoi(wanted);
}

// A half-space is one kind more
constexpr int k_kinds = k_shape_kinds + 1;

std::string name_of_kind(int kind) {
  return kind < k_shape_kinds ? k_shape_names[std::size_t(kind)] : "half-space";
}

Separation query(const Pair& p) {
  return separation(p.a, p.pose_a, p.b, p.pose_b);
}

// Deep in each other, far apart, or almost touching
Pair random_pair(Random& random, int kind_a, int kind_b) {
  const double size_a = random.log_between(1e-4, 1e4);
  double size_b = random.log_between(1e-4, 1e4);
  if (random.bits() % 2 == 0) size_b = size_a * random.log_between(0.1, 10);
  Pair p;
  p.a = random_shape(random, kind_a, size_a, p.points[0]);
  if (kind_b < k_shape_kinds)
    p.b = random_shape(random, kind_b, size_b, p.points[1]);
  else
    p.b = HalfSpace{random.direction(), Real(random.between(-size_a, size_a))};
  p.pose_a.orientation = random.turn();
  const double span = kind_b < k_shape_kinds ? size_a + size_b : size_a;
  p.pose_b = some_pose(random, p.pose_a, 1.5 * span);
  if (random.bits() % 2 == 0) {
    const double least = kind_b < k_shape_kinds ? std::min(size_a, size_b) : size_a;
    const Separation s = query(p);
    const double gap = random.between(-1, 1) * random.log_between(1e-12, 1) * least;
    p.pose_b.position += (Real(gap) - s.distance) * s.normal;
  }
  return p;
}

// The numbers that a pair's answer is computed from [m]
double size_of(const Pair& p) {
  const auto reach = [](const Shape& shape) {
    const auto* plane = std::get_if<HalfSpace>(&shape);
    if (plane != nullptr) return double(std::abs(plane->offset));
    return double(convex(shape).reach + convex(shape).radius);
  };
  return reach(p.a) + reach(p.b) + double(glm::length(p.pose_b.position));
}

// By how much a point of a shape's frame is outside of it, along the worst of the
// normals that bound the shape
double outside(const Shape& shape, const Vec3& point) {
  struct Outside {
    glm::dvec3 p;

    double round(double across, double radius, double height) const {
      return std::max(across - radius, std::abs(p.z) - height / 2);
    }
    double operator()(const Sphere& s) const {
      return glm::length(p) - double(s.radius);
    }
    double operator()(const Box& s) const {
      const glm::dvec3 beyond = glm::abs(p) - glm::dvec3(s.half_extents);
      return std::max({beyond.x, beyond.y, beyond.z});
    }
    double operator()(const Ellipsoid& s) const {
      const glm::dvec3 axes(s.semi_axes);
      return (glm::length(p / axes) - 1) * std::min({axes.x, axes.y, axes.z});
    }
    double operator()(const Capsule& s) const {
      const double half = double(s.height) / 2;
      return glm::distance(p, {0, 0, std::clamp(p.z, -half, half)}) - double(s.radius);
    }
    double operator()(const Cylinder& s) const {
      return round(std::hypot(p.x, p.y), double(s.radius), double(s.height));
    }
    double operator()(const Cone& s) const {
      const double r = double(s.radius), h = double(s.height);
      const double beyond_side = h * std::hypot(p.x, p.y) + r * p.z - r * h;
      return std::max(beyond_side / std::hypot(r, h), -p.z);
    }
    double operator()(const HalfSpace& s) const {
      return glm::dot(glm::dvec3(s.normal), p) - double(s.offset);
    }
    double operator()(const HullShape& s) const {
      const std::array lone{Vec3(p)};
      const Shape hull = s, vertex = hull_shape(lone);
      return double(separation(hull, {}, vertex, {}).distance);
    }
  };
  return std::visit(Outside{glm::dvec3(point)}, shape);
}

// How high a shape is along a direction
double height(const Shape& shape, const Pose& pose, const Vec3& normal) {
  const Convex body = convex(shape);
  std::uint32_t vertex = 0;
  const Vec3 d = direction_in_body(pose, normal);
  const Vec3 top = point_in_world(pose, body.core_support(body.shape, d, vertex));
  return double(glm::dot(normal, top) + body.radius);
}

// A and B have the same part in it: two answers, each within its own error
void check_symmetry(const Pair& p, const Separation& s) {
  const Separation other = separation(p.b, p.pose_b, p.a, p.pose_a);
  REQUIRE(std::abs(double(other.distance - s.distance))
          <= double(s.error + other.error));
}

// Where the world's origin is has none, but for the rounding of two positions and two
// turns in numbers of the pair's size
void check_motion(const Pair& p, const Separation& s, double size, Random& random) {
  const Pose move{Real(size) * random.in_cube(), random.turn()};
  Pair moved = p;
  for (Pose* pose : {&moved.pose_a, &moved.pose_b})
    *pose = {point_in_world(move, pose->position),
             glm::normalize(move.orientation * pose->orientation)};
  const Separation other = query(moved);
  REQUIRE(std::abs(double(other.distance - s.distance))
          <= double(s.error + other.error) + 64 * k_u * size);
}

// The witness points are that far from each other, in their shapes, and as far out as
// these reach along the normal, up to the error and a few roundings. Across a gap d,
// two points may be d + error apart and out of line by sqrt(2 d error), before each is
// moved half of that way
void check_witness(const Pair& p, const Separation& s, double size) {
  const Real radii = convex(p.a).radius + convex(p.b).radius;
  const double gap = std::max(double(s.distance + radii), 0.0);
  const double sideways = std::sqrt(2 * gap * double(s.error));
  const double within = double(s.error) + 64 * k_u * size + sideways / 2;
  const Vec3 left = s.on_b - s.on_a - s.distance * s.normal;
  REQUIRE(double(glm::length(left)) <= 32 * k_u * size);
  REQUIRE(outside(p.a, point_in_body(p.pose_a, s.on_a)) <= within);
  REQUIRE(outside(p.b, point_in_body(p.pose_b, s.on_b)) <= within);
  const double below_a =
      height(p.a, p.pose_a, s.normal) - double(glm::dot(s.normal, s.on_a));
  REQUIRE(std::abs(below_a) <= within);
  if (std::holds_alternative<HalfSpace>(p.b)) return;
  const double below_b =
      height(p.b, p.pose_b, -s.normal) - double(glm::dot(-s.normal, s.on_b));
  REQUIRE(std::abs(below_b) <= within);
}

// A little more than the depth takes them apart, a little less does not. Along another
// direction than the best, by the error, less could be enough
bool check_depth(const Pair& p, const Separation& s) {
  if (double(s.distance) > -1e3 * double(s.error)) return false;
  Pair apart = p, still = p;
  apart.pose_b.position -= Real(1.01) * s.distance * s.normal;
  still.pose_b.position -= Real(0.99) * s.distance * s.normal;
  REQUIRE(query(apart).distance > 0);
  REQUIRE(query(still).distance < 0);
  return true;
}

struct Counts {
  int separated = 0, overlapping = 0, close = 0, deep = 0, at_limit = 0;
};

void check_combination(int kind_a, int kind_b, Counts& counts) {
  Random random(unsigned(100 * kind_a + kind_b));
  const int pairs = pairs_per_combination();
  for (int i = 0; i < pairs; ++i) {
    const Pair p = random_pair(random, kind_a, kind_b);
    const Separation s = query(p);
    const double size = size_of(p);
    INFO(name_of_kind(kind_a) << " and " << name_of_kind(kind_b) << ", pair " << i
                              << ": " << name_of(s.reason) << " " << double(s.distance)
                              << " +- " << double(s.error));
    REQUIRE(std::isfinite(s.distance));
    REQUIRE(double(glm::length(s.normal)) == Approx(1).margin(8 * k_u));
    check_symmetry(p, s);
    check_motion(p, s, size, random);
    check_witness(p, s, size);
    counts.deep += check_depth(p, s);
    counts.separated += contact_of(s) == Contact::separated;
    counts.overlapping += contact_of(s) == Contact::penetrating;
    counts.close += std::abs(double(s.distance)) < 1e-6 * size;
    counts.at_limit += s.reason == Reason::iteration_limit;
  }
}

}  // namespace

TEST_CASE("what holds for any pair holds for each combination of shapes") {
  const int pairs = pairs_per_combination();
  for (int a = 0; a < k_shape_kinds; ++a)
    for (int b = a; b < k_kinds; ++b) {
      Counts counts;
      check_combination(a, b, counts);
      INFO(name_of_kind(a) << " and " << name_of_kind(b));
      CHECK(counts.separated > pairs / 10);
      CHECK(counts.overlapping > pairs / 10);
      CHECK(counts.deep > pairs / 20);
      CHECK(counts.close > pairs / 20);
      CHECK(counts.at_limit < pairs / 10);
    }
}

namespace {

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

}  // namespace

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

    // In needles that are a millionth as thick as long some directions are known worse
    // than `error` says, and so are the directions that are tried
    INFO(i << " " << name_of(s.reason) << " " << double(s.error));
    const double within = (k_single ? 1 : 16) * double(s.error);
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

TEST_CASE("separating axes agree on boxes and hulls of any size") {
  Random random(4);
  const int pairs = pairs_per_combination();
  int overlapping = 0;
  for (int i = 0; i < pairs; ++i) {
    Pair p = random_pair(random, i % 2 == 0 ? 1 : 6, i % 2 == 0 ? 1 : 6);
    std::array<ConvexHull, 2> hulls;
    if (i % 2 == 1) {
      hulls = {convex_hull(p.points[0]).hull, convex_hull(p.points[1]).hull};
      if (hulls[0].vertices.empty() || hulls[1].vertices.empty()) continue;
      p.a = hull_shape(hulls[0]);
      p.b = hull_shape(hulls[1]);
    }
    const PairMethod& sat_method = pair_methods()[2];
    REQUIRE(sat_method.takes(p.a, p.b));
    const Separation by_axes = sat_method.query(p.a, p.pose_a, p.b, p.pose_b);
    const Separation s = query(p);
    INFO(i << " " << name_of(s.reason) << " " << double(s.distance) << " "
           << double(by_axes.distance));

    // Of separated shapes the best axis tells but a lower bound
    const double within = 4 * double(s.error + by_axes.error);
    REQUIRE(by_axes.distance <= double(s.distance) + within);
    if (double(s.distance) > within) continue;
    ++overlapping;
    REQUIRE(std::abs(double(by_axes.distance - s.distance)) <= within);
  }
  CHECK(overlapping > pairs / 5);
}
