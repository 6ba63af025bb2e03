// Fuzzing of chapter 4's queries: bytes become two shapes of any kind and their poses,
// with numbers of any size, ties and numbers that are none among them. For libFuzzer,
// which clang has: a check that fails ends the run and leaves the bytes in a file.
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "common/physics/epa.hpp"
#include "common/physics/manifold.hpp"
#include "common/physics/pair_query.hpp"

using namespace timestep;

namespace {

void check(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

// Zeros past the end
struct Bytes {
  const std::uint8_t* data;
  std::size_t size;

  std::uint8_t byte() {
    if (size == 0) return 0;
    --size;
    return *data++;
  }

  // One byte says how: a small number, of which ties are made, such a number times a
  // power of two, or any bits at all
  Real number() {
    const std::uint8_t how = byte();
    const Real small = Real(std::int8_t(byte())) / 16;
    if (how < 160) return small;
    if (how < 250) return std::ldexp(small, std::int8_t(byte()) / 2);
    std::array<std::uint8_t, sizeof(std::uint64_t)> bits{};
    for (std::uint8_t& b : bits) b = byte();
    return std::bit_cast<double>(bits);
  }
  Real length() { return std::abs(number()); }
  Vec3 vector() {
    const Real x = number(), y = number();
    return {x, y, number()};
  }
  Vec3 lengths() { return glm::abs(vector()); }
  Vec3 direction() {
    const Vec3 d = unit_or_zero(vector());
    return std::isfinite(glm::dot(d, d)) && d != Vec3(0) ? d : Vec3(0, 0, 1);
  }
};

using Points = std::array<Vec3, 12>;

Shape shape_from(Bytes& bytes, Points& points) {
  switch (bytes.byte() % 8) {
    case 0:
      return Sphere{bytes.length()};
    case 1:
      return Box{bytes.lengths()};
    case 2:
      return Ellipsoid{bytes.lengths()};
    case 3:
      return Capsule{bytes.length(), bytes.length()};
    case 4:
      return Cylinder{bytes.length(), bytes.length()};
    case 5:
      return Cone{bytes.length(), bytes.length()};
    case 6:
      return HalfSpace{bytes.direction(), bytes.number()};
    default:
      break;
  }
  const std::size_t count = 1 + bytes.byte() % points.size();
  for (std::size_t i = 0; i < count; ++i) points[i] = bytes.vector();
  return hull_shape(std::span(points).first(count));
}

Pose pose_from(Bytes& bytes) {
  Pose pose{bytes.vector()};
  if (bytes.byte() % 2 == 0) return pose;
  const Real w = bytes.number();
  const Quat q(w, bytes.vector());
  const Real length = glm::length(q);
  if (length > Real(1e-100) && length < Real(1e100)) pose.orientation = q / length;
  return pose;
}

Real gap_along(const Convex& a, const Pose& pose_a, const Convex& b, const Pose& pose_b,
               const Vec3& n) {
  std::uint32_t hint_a = 0, hint_b = 0;
  const Vec3 on_a = direction_in_world(
      pose_a, a.core_support(a.shape, direction_in_body(pose_a, n), hint_a));
  const Vec3 on_b = direction_in_world(
      pose_b, b.core_support(b.shape, direction_in_body(pose_b, -n), hint_b));
  const Vec3 between = pose_b.position - pose_a.position;
  return glm::dot(n, between) + glm::dot(n, on_b) - glm::dot(n, on_a)
         - (a.radius + b.radius);
}

void check_numbers(const Separation& s, Real size) {
  check(std::isfinite(s.distance), "the distance is no number");
  check(std::abs(glm::length(s.normal) - 1) < Real(1e-12), "the normal is no unit");
  check(s.error >= 0, "the error is negative or no number");
  const Vec3 left = s.on_b - s.on_a - s.distance * s.normal;
  check(glm::length(left) <= Real(1e-12) * size, "the witness points are elsewhere");
}

// Of pairs that GJK and EPA answer
void check_query(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b,
                 const Separation& s, Real size) {
  const Convex body_a = convex(a), body_b = convex(b);
  const Real within = 64 * (s.error + std::numeric_limits<Real>::epsilon() * size);
  check(gap_along(body_a, pose_a, body_b, pose_b, s.normal) >= s.distance - within,
        "the normal's own gap is less than the distance");
  const Separation other = separation(b, pose_b, a, pose_a);
  check(std::abs(other.distance - s.distance) <= within + 64 * other.error,
        "the other way round it is another distance");
  if (std::abs(s.distance) > within + Real(1e-9) * size)
    check(intersect(body_a, pose_a, body_b, pose_b) == (s.distance < 0),
          "whether they meet is not what the distance says");
}

void check_pair(const Shape& a, const Pose& pose_a, const Shape& b,
                const Pose& pose_b) {
  const bool has_plane =
      std::holds_alternative<HalfSpace>(a) || std::holds_alternative<HalfSpace>(b);
  const Convex body_a = convex(a), body_b = convex(b);
  const Real size = body_a.reach + body_b.reach + body_a.radius + body_b.radius
                    + glm::length(pose_a.position) + glm::length(pose_b.position);
  for (const PairMethod& method : pair_methods()) {
    const Separation s = method.query(a, pose_a, b, pose_b);
    check(!std::isnan(s.distance), "the distance is NaN");
    const bool is_answer = s.reason != Reason::out_of_range
                           && s.reason != Reason::unbounded
                           && s.reason != Reason::no_answer;
    if (!is_answer || !(size < Real(1e100))) continue;
    const Real scale = size + std::abs(s.distance) + std::numeric_limits<Real>::min();
    check_numbers(s, scale);
    if (method.name != "gjk_epa" || has_plane) continue;
    check_query(a, pose_a, b, pose_b, s, scale);
    const Manifold manifold = contact_manifold(a, pose_a, b, pose_b, s, 0);
    check(manifold.count <= 4, "there are too many contacts");
    check(s.distance > s.error || manifold.count > 0 || s.distance > 0,
          "shapes that overlap have no contact");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes{data, size};
  Points points_a, points_b;
  const Shape a = shape_from(bytes, points_a), b = shape_from(bytes, points_b);
  const Pose pose_a = pose_from(bytes), pose_b = pose_from(bytes);
  check_pair(a, pose_a, b, pose_b);
  return 0;
}
