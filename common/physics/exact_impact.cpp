#include "common/physics/exact_impact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace timestep::exact {
namespace {

// [r] of r x a = [r] a
glm::dmat3 cross_matrix(const glm::dvec3& r) {
  return {0, r.z, -r.y, -r.z, 0, r.x, r.y, -r.x, 0};
}

// What an impulse at the point changes of the body's velocity there
glm::dmat3 mobility(const Body& body, const glm::dvec3& point) {
  const glm::dmat3 r = cross_matrix(point - body.position);
  return glm::dmat3(body.inverse_mass) - r * body.inverse_inertia * r;
}

glm::dvec3 velocity_at(const Body& body, const glm::dvec3& point) {
  return body.velocity + glm::cross(body.angular_velocity, point - body.position);
}

// K and the relative velocity in a frame whose x is the normal, and in units of
// `speed`, so that no square leaves the range of a double
struct Local {
  glm::dmat3 world_from_local, K;
  glm::dvec3 v;
  double mu, speed;

  Local(const Body& a, const Body& b, const Touch& touch)
      : world_from_local(basis(touch.normal)),
        K(glm::transpose(world_from_local)
          * (mobility(a, touch.point) + mobility(b, touch.point)) * world_from_local),
        v(relative_velocity(a, b, touch) * world_from_local),
        mu(touch.mu),
        speed(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)})) {
    if (speed > 0) v /= speed;
  }

  // The first tangent is normal to the axis that the normal has least of
  static glm::dmat3 basis(const glm::dvec3& n) {
    const glm::dvec3 size = glm::abs(n);
    glm::dvec3 axis{0, 0, 1};
    if (size.x <= size.y && size.x <= size.z)
      axis = {1, 0, 0};
    else if (size.y <= size.z)
      axis = {0, 1, 0};
    const glm::dvec3 t = glm::normalize(glm::cross(n, axis));
    return {n, t, glm::cross(n, t)};
  }

  Impulse world(const Impulse& local) const {
    return {speed * (world_from_local * local.j), local.slip};
  }
};

// The t that minimises t·K t / 2 + t·v where |t| = most, if less would still slip:
// (K + s) t = -v with an s > 0. By Newton on 1 / |t|, which is all but linear in s,
// from below. Source: Moré and Sorensen, Computing a trust region step (1983).
glm::dvec2 on_the_rim(const glm::dmat2& K, const glm::dvec2& v, double most) {
  // Next to no friction: K is nothing beside s
  constexpr double k_slight = 1e-60;
  if (!(most > k_slight * glm::length(glm::inverse(K) * v)))
    return -most * glm::normalize(v);

  double s = 0;
  for (int i = 0;; ++i) {
    const glm::dmat2 inverse = glm::inverse(K + glm::dmat2(s));
    const glm::dvec2 t = -(inverse * v);
    const double length = glm::length(t);
    const double change =
        length * length / glm::dot(t, inverse * t) * (length - most) / most;
    if (i == 100 || !(change > 0) || s + change == s) return t * (most / length);
    s += change;
  }
}

// A normal impulse, and the friction that leaves the least energy with it
Impulse with_friction(const Local& at, double normal) {
  const glm::dmat2 K{at.K[1][1], at.K[1][2], at.K[2][1], at.K[2][2]};
  const glm::dvec2 v{at.v.y + at.K[0][1] * normal, at.v.z + at.K[0][2] * normal};
  const glm::dvec2 stop = -(glm::inverse(K) * v);
  const double most = at.mu * normal;
  if (glm::length(stop) <= most) return {{normal, stop.x, stop.y}, Slip::sticks};
  const glm::dvec2 t = on_the_rim(K, v, most);
  return {{normal, t.x, t.y}, Slip::slides};
}

// A normal impulse of `least` or more that with its friction leaves the normal speed
// `wanted` or more. There is one, as the speed grows without bound in the end: K is
// positive, and friction opposes the slip, so there n·K j > -t·K j >= 0.
Impulse until_normal_speed(const Local& at, double wanted, double least) {
  const auto falls_short = [&](double normal) {
    return at.v.x + (at.K * with_friction(at, normal).j).x < wanted;
  };

  // No smaller one can do, even if friction helps; then double it
  const double helped = at.K[0][0] + at.mu * std::hypot(at.K[0][1], at.K[0][2]);
  double low = std::max({least, (wanted - at.v.x) / helped * (1 - 1e-12),
                         std::numeric_limits<double>::min()});
  if (!falls_short(low)) return with_friction(at, low);
  double high = 2 * low;
  for (; falls_short(high); high *= 2) low = high;

  // Halve the interval until no number is left in it
  for (double middle = (low + high) / 2; low < middle && middle < high;
       middle = (low + high) / 2)
    (falls_short(middle) ? low : high) = middle;
  return with_friction(at, high);
}

// Newton's restitution and Coulomb's friction on bodies that close
Impulse coupled(const Local& at, double e) {
  const double wanted = -e * at.v.x;
  const glm::dvec3 j = glm::inverse(at.K) * (glm::dvec3(wanted, 0, 0) - at.v);
  if (std::hypot(j.y, j.z) <= at.mu * j.x) return {j, Slip::sticks};
  return until_normal_speed(at, wanted, 0);
}

glm::dvec2 turned(const glm::dvec2& at, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * at.x - s * at.y, s * at.x + c * at.y};
}

double inertia(const FallingBox& box) {
  return box.mass * (box.width * box.width + box.height * box.height) / 12;
}

}  // namespace

glm::dvec3 relative_velocity(const Body& a, const Body& b, const Touch& touch) {
  return velocity_at(b, touch.point) - velocity_at(a, touch.point);
}

Impulse frictionless(const Body& a, const Body& b, const Touch& touch) {
  const Local at(a, b, touch);
  if (at.v.x >= 0) return {glm::dvec3(0), Slip::parts};
  const double normal = -(1 + touch.restitution) * at.v.x / at.K[0][0];
  return at.world({{normal, 0, 0}, Slip::frictionless});
}

Impulse sequential_friction(const Body& a, const Body& b, const Touch& touch) {
  const Local at(a, b, touch);
  if (at.v.x >= 0) return {glm::dvec3(0), Slip::parts};
  const double normal = -(1 + touch.restitution) * at.v.x / at.K[0][0];

  // The slip that the normal impulse leaves, and what would stop it
  const glm::dvec3 v = at.v + at.K[0] * normal;
  const double speed = std::hypot(v.y, v.z);
  if (speed == 0) return at.world({{normal, 0, 0}, Slip::sticks});
  const glm::dvec3 along = glm::dvec3(0, v.y, v.z) / speed;
  const double stop = speed / glm::dot(along, at.K * along);
  const double most = at.mu * normal;
  const glm::dvec3 j = glm::dvec3(normal, 0, 0) - std::min(stop, most) * along;
  return at.world({j, stop <= most ? Slip::sticks : Slip::slides});
}

Impulse coupled_friction(const Body& a, const Body& b, const Touch& touch) {
  const Local at(a, b, touch);
  if (at.v.x >= 0) return {glm::dvec3(0), Slip::parts};
  return at.world(coupled(at, touch.restitution));
}

Impulse poisson(const Body& a, const Body& b, const Touch& touch) {
  const Local at(a, b, touch);
  if (at.v.x >= 0) return {glm::dvec3(0), Slip::parts};
  const auto compression = coupled(at, 0);
  if (touch.restitution == 0) return at.world(compression);

  // Then no normal speed is left, and e of the normal impulse comes back
  Local there = at;
  there.v = at.v + at.K * compression.j;
  there.v.x = 0;
  const auto expansion =
      until_normal_speed(there, 0, touch.restitution * compression.j.x);
  return at.world({compression.j + expansion.j, expansion.slip});
}

Body pushed(Body body, const glm::dvec3& j, const glm::dvec3& point) {
  body.velocity += body.inverse_mass * j;
  body.angular_velocity += body.inverse_inertia * glm::cross(point - body.position, j);
  return body;
}

BallBounce bounced(const Ball& ball, double restitution, const BallMotion& before) {
  if (before.v.z >= 0) return {{glm::dvec3(0), Slip::parts}, before};

  // What stops the slip, or as much of it as friction can
  const double normal = -(1 + restitution) * ball.mass * before.v.z;
  const glm::dvec3 stop = -ball.mass * ball.k / (1 + ball.k) * slip(ball, before);
  const double needed = glm::length(stop);
  const double most = ball.mu * normal;
  const bool sticks = needed <= most;
  const glm::dvec3 j =
      (sticks ? stop : stop * (most / needed)) + glm::dvec3(0, 0, normal);

  BallMotion after = before;
  after.v += j / ball.mass;
  after.omega += glm::dvec3(j.y, -j.x, 0) / (ball.k * ball.mass * ball.radius);
  return {{j, sticks ? Slip::sticks : Slip::slides}, after};
}

std::optional<DiscImpact> disc_impact(const Disc& first, const Disc& second, double e) {
  const glm::dvec2 x = second.x - first.x;
  const glm::dvec2 v = second.v - first.v;
  const double reach = first.radius + second.radius;
  const double closing = -glm::dot(x, v);
  if (!(closing > 0)) return {};

  // |x + v t| = reach, by the smaller root; it misses by how far it passes the centre
  const double distance = glm::length(x);
  const double speed = glm::length(v);
  const double passes = std::abs(x.x * v.y - x.y * v.x);
  const double square = (speed * reach - passes) * (speed * reach + passes);
  if (distance > reach && !(square > 0)) return {};
  const double gap = std::max(distance - reach, 0.0) * (distance + reach);
  const double time = gap == 0 ? 0 : gap / (closing + std::sqrt(square));

  const glm::dvec2 normal = glm::normalize(x + v * time);
  const double impulse =
      -(1 + e) * glm::dot(v, normal) / (1 / first.mass + 1 / second.mass);

  DiscImpact impact{time, normal, impulse, first, second};
  impact.first.x += first.v * time;
  impact.second.x += second.v * time;
  impact.first.v -= impulse / first.mass * normal;
  impact.second.v += impulse / second.mass * normal;
  return impact;
}

glm::dvec2 lowest_corner(const FallingBox& box) {
  const double w = box.width / 2;
  const double h = box.height / 2;
  glm::dvec2 lowest = turned({-w, -h}, box.tilt);
  for (const glm::dvec2& corner :
       std::array<glm::dvec2, 3>{{{w, -h}, {w, h}, {-w, h}}}) {
    const glm::dvec2 other = turned(corner, box.tilt);
    if (other.y < lowest.y) lowest = other;
  }
  return lowest;
}

BoxImpact corner_bounces(const FallingBox& box, double e) {
  const double arm = lowest_corner(box).x;
  const double k = 1 / box.mass + arm * arm / inertia(box);
  const double j = (1 + e) * box.speed / k;
  return {arm * j / inertia(box), {0, j / box.mass - box.speed}, {0, j}};
}

BoxImpact corner_catches(const FallingBox& box) {
  // Angular momentum about the corner stays
  const glm::dvec2 arm = lowest_corner(box);
  const double about_corner = inertia(box) + box.mass * glm::dot(arm, arm);
  const double omega = box.mass * arm.x * box.speed / about_corner;
  const glm::dvec2 v = omega * glm::dvec2(arm.y, -arm.x);
  return {omega, v, box.mass * (v + glm::dvec2(0, box.speed))};
}

}  // namespace timestep::exact
