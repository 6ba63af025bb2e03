#include "common/physics/impulse.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/physics/penetration.hpp"
#include "common/physics/shapes.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

// r x as a matrix
Mat3 cross_matrix(const Vec3& r) {
  return {0, r.z, -r.y, -r.z, 0, r.x, r.y, -r.x, 0};
}

Mat3 velocity_per_impulse(const RigidBody& body, const Vec3& arm) {
  const Mat3 r = cross_matrix(arm);
  return Mat3(body.inverse_mass) - r * world_inverse_inertia(body) * r;
}

Vec3 tangential(const Vec3& v, const Vec3& n) {
  return v - glm::dot(v, n) * n;
}

Vec3 frictionless(const RigidBody& a, const RigidBody& b, const Impact& impact) {
  return normal_impulse(a, b, impact) * impact.normal;
}

Vec3 sequential_friction(const RigidBody& a, const RigidBody& b, const Impact& impact) {
  const Vec3& n = impact.normal;
  const Real j = normal_impulse(a, b, impact);
  const Mat3 K = velocity_per_impulse(a, b, impact.point);
  const Vec3 v = relative_velocity(a, b, impact.point) + j * (K * n);

  // Against the slip that is left
  const Vec3 slip = tangential(v, n), along = unit_or_zero(slip);
  if (j == 0 || along == Vec3(0)) return j * n;
  const Vec3 wanted = -slip / glm::dot(along, K * along);
  return j * n + in_cone(wanted, impact.friction, j);
}

using Vec2 = glm::vec<2, Real>;
using Mat2 = glm::mat<2, 2, Real>;

// An impact in its contact basis: x along the normal
struct Local {
  Mat3 basis, K;
  Vec3 v;
  Real friction;
};

Local local(const RigidBody& a, const RigidBody& b, const Impact& impact) {
  const Mat3 basis = contact_basis(impact.normal);
  const Mat3 K = velocity_per_impulse(a, b, impact.point);
  return {basis, glm::transpose(basis) * K * basis,
          relative_velocity(a, b, impact.point) * basis, impact.friction};
}

// The friction impulse of size `most` that leaves the least energy: t with
// (K + s) t = -v for some s > 0. Newton's steps on 1 / |t| come to s from below.
// Source: J. Moré, D. Sorensen, Computing a trust region step, 1983.
Vec2 sliding_friction(const Mat2& K, const Vec2& v, Real most) {
  Vec2 t(0);
  Real s = 0;
  constexpr int k_most_steps = 50;
  for (int i = 0; i < k_most_steps && most > 0; ++i) {
    const Mat2 inverse = glm::inverse(K + Mat2(s));
    t = -(inverse * v);
    const Real size = glm::length(t), slope = glm::dot(t, inverse * t);
    const Real change = size * size / slope * (size - most) / most;
    if (!(change > 0) || s + change == s) break;
    s += change;
  }
  const Real size = glm::length(t);
  return size > 0 ? most / size * t : t;
}

// (6.5) A normal impulse with the friction that resists slip as much as it may
Vec3 with_friction(const Local& at, Real normal) {
  const Mat2 K(at.K[1][1], at.K[1][2], at.K[2][1], at.K[2][2]);
  const Vec2 v(at.v.y + at.K[0][1] * normal, at.v.z + at.K[0][2] * normal);
  const Vec2 holding = -(glm::inverse(K) * v);
  const Real most = at.friction * normal;
  const Vec2 t = glm::length(holding) <= most ? holding : sliding_friction(K, v, most);
  return {normal, t.x, t.y};
}

// The least normal impulse, `least` or more, that with its friction leaves a parting
// speed of `wanted`: by doubling, then halving. More of it always parts faster in the
// end, since friction resists slip
Vec3 until_parting(const Local& at, Real wanted, Real least) {
  const auto falls_short = [&](Real normal) {
    return at.v.x + (at.K * with_friction(at, normal)).x < wanted;
  };
  const Real helped = at.K[0][0] + at.friction * std::hypot(at.K[0][1], at.K[0][2]);
  constexpr Real k_a_little_less = 1 - 8 * std::numeric_limits<Real>::epsilon();
  Real low = std::max(least, k_a_little_less * (wanted - at.v.x) / helped);
  if (!falls_short(low)) return with_friction(at, low);
  Real high = 2 * low;
  for (; falls_short(high) && std::isfinite(high); high *= 2) low = high;
  for (Real middle = (low + high) / 2; low < middle && middle < high;
       middle = (low + high) / 2)
    (falls_short(middle) ? low : high) = middle;
  return with_friction(at, high);
}

// Newton's restitution and Coulomb's friction at once: what ends all slip, if friction
// can; else against the slip that is left
Vec3 coupled(const Local& at, Real restitution) {
  const Real wanted = -restitution * at.v.x;
  const Vec3 holding = glm::inverse(at.K) * (Vec3(wanted, 0, 0) - at.v);
  const bool holds = std::hypot(holding.y, holding.z) <= at.friction * holding.x;
  return holds ? holding : until_parting(at, wanted, 0);
}

Vec3 coupled_friction(const RigidBody& a, const RigidBody& b, const Impact& impact) {
  const Local at = local(a, b, impact);
  return at.v.x < 0 ? at.basis * coupled(at, impact.restitution) : Vec3(0);
}

// (6.15) Compression until nothing closes any more, then restitution: a normal impulse
// `restitution` times as large, or what it takes if friction makes that close again
Vec3 poisson(const RigidBody& a, const RigidBody& b, const Impact& impact) {
  Local at = local(a, b, impact);
  if (at.v.x >= 0) return Vec3(0);
  const Vec3 compression = coupled(at, 0);
  at.v += at.K * compression;
  at.v.x = 0;
  const Vec3 expansion = until_parting(at, 0, impact.restitution * compression.x);
  return at.basis * (compression + expansion);
}

}  // namespace

Vec3 relative_velocity(const RigidBody& a, const RigidBody& b, const Vec3& point) {
  return velocity_at(b, point) - velocity_at(a, point);
}

Mat3 velocity_per_impulse(const RigidBody& a, const RigidBody& b, const Vec3& point) {
  return velocity_per_impulse(a, point - a.position)
         + velocity_per_impulse(b, point - b.position);
}

Real effective_mass(const RigidBody& a, const RigidBody& b, const Vec3& point,
                    const Vec3& along) {
  return 1
         / (inverse_effective_mass(a, point - a.position, along)
            + inverse_effective_mass(b, point - b.position, along));
}

Real normal_impulse(const RigidBody& a, const RigidBody& b, const Impact& impact) {
  // (6.4) The change that restitution asks for
  const Real closing = -glm::dot(relative_velocity(a, b, impact.point), impact.normal);
  if (closing <= 0) return 0;
  const Real change = (1 + impact.restitution) * closing;
  return change * effective_mass(a, b, impact.point, impact.normal);
}

Vec3 in_cone(const Vec3& wanted, Real friction, Real normal_impulse) {
  const Real most = friction * normal_impulse, size = glm::length(wanted);
  return size <= most ? wanted : most / size * wanted;
}

Mat3 contact_basis(const Vec3& normal) {
  const Vec3 side = any_perpendicular(normal);
  return {normal, side, glm::cross(normal, side)};
}

Vec3 in_pyramid(const Vec3& wanted, Real friction, Real normal_impulse,
                const Mat3& basis) {
  const Real most = friction * normal_impulse;
  return std::clamp(glm::dot(wanted, basis[1]), -most, most) * basis[1]
         + std::clamp(glm::dot(wanted, basis[2]), -most, most) * basis[2];
}

void apply_impulse(RigidBody& a, RigidBody& b, const Vec3& point, const Vec3& impulse) {
  a.velocity -= a.inverse_mass * impulse;
  b.velocity += b.inverse_mass * impulse;
  a.angular_velocity -=
      world_inverse_inertia(a) * glm::cross(point - a.position, impulse);
  b.angular_velocity +=
      world_inverse_inertia(b) * glm::cross(point - b.position, impulse);
}

std::span<const ImpactLaw> impact_laws() {
  static constexpr std::array<ImpactLaw, 4> k_laws{{
      {"frictionless", "Newton's restitution", frictionless},
      {"sequential_friction", "Newton's restitution, then friction, once",
       sequential_friction},
      {"coupled_friction", "Newton's restitution and Coulomb's friction at once",
       coupled_friction},
      {"poisson", "Poisson's restitution and Coulomb's friction", poisson},
  }};
  return k_laws;
}

const ImpactLaw* find_impact_law(std::string_view name) {
  for (const ImpactLaw& law : impact_laws())
    if (law.name == name) return &law;
  return nullptr;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
