#include "common/physics/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "common/physics/mass_properties.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

constexpr Real k_infinity = std::numeric_limits<Real>::infinity();

// So many vertices are sooner looked through than climbed
constexpr std::size_t k_few = 96;

// The point of a circle about the z axis farthest along (x, y), the middle in a tie. By
// hypot: r sqrt(1 - z^2) of a unit direction loses half the digits next to the axis
Vec3 support_of_circle(Real radius, Real z, const Vec3& direction) {
  const Real across = std::hypot(direction.x, direction.y);
  if (!(across > 0)) return {0, 0, z};
  return {radius * (direction.x / across), radius * (direction.y / across), z};
}

Vec3 support_of_segment(Real height, const Vec3& direction) {
  return {0, 0, direction.z >= 0 ? height / 2 : -height / 2};
}

std::uint32_t highest_of_all(std::span<const Vec3> vertices, const Vec3& direction) {
  std::uint32_t best = 0;
  Real highest = glm::dot(vertices[0], direction);
  for (std::uint32_t i = 1; i < vertices.size(); ++i) {
    const Real height = glm::dot(vertices[i], direction);
    best = height > highest ? i : best;
    highest = std::max(highest, height);
  }
  return best;
}

template <class S>
Vec3 core_support(const void* shape, const Vec3& direction, std::uint32_t& hint) {
  const S& s = *static_cast<const S*>(shape);
  if constexpr (std::is_same_v<S, HullShape>) {
    hint = support_vertex(s, direction, hint);
    return s.vertices[hint];
  } else if constexpr (std::is_same_v<S, Capsule>) {
    return support_of_segment(s.height, direction);
  } else if constexpr (std::is_same_v<S, Sphere> || std::is_same_v<S, HalfSpace>) {
    return Vec3(0);
  } else {
    return support(s, direction);
  }
}

// Of lengths; NaN if one of them is not finite
Real greatest(const Vec3& lengths) {
  const Real sum = lengths.x + lengths.y + lengths.z;
  return std::max({lengths.x, lengths.y, lengths.z}) + 0 * sum;
}

Real reach(const Sphere&) {
  return 0;
}
Real reach(const HalfSpace&) {
  return 0;
}
Real reach(const Box& box) {
  const Vec3& h = box.half_extents;
  return length_of(h);
}
Real reach(const Ellipsoid& ellipsoid) {
  return greatest(ellipsoid.semi_axes);
}
Real reach(const Capsule& capsule) {
  return capsule.height / 2;
}
Real reach(const Cylinder& cylinder) {
  return std::hypot(cylinder.radius, cylinder.height / 2);
}
Real reach(const Cone& cone) {
  return greatest({cone.radius, cone.height, 0});
}
Real reach(const HullShape& hull) {
  return hull.reach;
}

}  // namespace

Real length_of(const Vec3& v) {
  return std::hypot(v.x, v.y, v.z) + 0 * (v.x + v.y + v.z);
}

Vec3 unit_or_zero(const Vec3& v) {
  // In units of the largest number, so that squares neither overflow nor vanish
  const Real size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return size > 0 ? glm::normalize(v / size) : Vec3(0);
}

Vec3 any_perpendicular(const Vec3& unit) {
  const Vec3 a = glm::abs(unit);
  const Vec3 axis = a.x <= a.y && a.x <= a.z ? Vec3(1, 0, 0)
                    : a.y <= a.z             ? Vec3(0, 1, 0)
                                             : Vec3(0, 0, 1);
  return glm::normalize(glm::cross(unit, axis));
}

HullShape hull_shape(std::span<const Vec3> vertices) {
  Real reach = 0;
  for (const Vec3& v : vertices) {
    const Real distance = length_of(v);
    if (distance > reach || std::isnan(distance)) reach = distance;
  }
  return {.vertices = vertices, .reach = reach};
}

Vec3 support(const Sphere& sphere, const Vec3& direction) {
  return sphere.radius * unit_or_zero(direction);
}

Vec3 support(const Box& box, const Vec3& direction) {
  const Vec3& h = box.half_extents;
  return {direction.x >= 0 ? h.x : -h.x, direction.y >= 0 ? h.y : -h.y,
          direction.z >= 0 ? h.z : -h.z};
}

Vec3 support(const Ellipsoid& ellipsoid, const Vec3& direction) {
  // A ball stretched by the semi-axes: the normal that it had before
  return ellipsoid.semi_axes * unit_or_zero(ellipsoid.semi_axes * direction);
}

Vec3 support(const Capsule& capsule, const Vec3& direction) {
  return support_of_segment(capsule.height, direction)
         + capsule.radius * unit_or_zero(direction);
}

Vec3 support(const Cylinder& cylinder, const Vec3& direction) {
  const Real half = cylinder.height / 2;
  return support_of_circle(cylinder.radius, direction.z >= 0 ? half : -half, direction);
}

Vec3 support(const Cone& cone, const Vec3& direction) {
  const Real across = std::hypot(direction.x, direction.y);
  if (cone.height * direction.z >= cone.radius * across) return {0, 0, cone.height};
  return support_of_circle(cone.radius, 0, direction);
}

Vec3 support(const HullShape& hull, const Vec3& direction) {
  return hull.vertices[support_vertex(hull, direction, 0)];
}

std::size_t direction_cell(const Vec3& direction) {
  const Vec3 size = glm::abs(direction);
  const Real most = std::max({size.x, size.y, size.z});
  if (!(most > 0)) return 0;
  const auto along = [&](Real d) {
    const Real cell = (d / most + 1) * (Real(k_cells) / 2);
    return cell < k_cells ? std::size_t(cell) : k_cells - 1;
  };
  return (along(direction.x) * k_cells + along(direction.y)) * k_cells
         + along(direction.z);
}

Vec3 middle_of_cell(std::size_t cell) {
  const std::size_t row = cell / k_cells;
  const std::size_t x = row / k_cells, y = row % k_cells, z = cell % k_cells;
  const Vec3 along(x, y, z);
  return (along + Real(0.5)) * (Real(2) / k_cells) - Real(1);
}

std::uint32_t support_vertex(const HullShape& hull, const Vec3& direction,
                             std::uint32_t start) {
  if (hull.neighbours.empty() || hull.vertices.size() <= k_few)
    return highest_of_all(hull.vertices, direction);

  // From the higher of two vertices
  std::uint32_t top = start < hull.vertices.size() ? start : 0;
  Real height = glm::dot(hull.vertices[top], direction);
  if (!hull.starts.empty()) {
    const std::uint32_t other = hull.starts[direction_cell(direction)];
    const Real other_height = glm::dot(hull.vertices[other], direction);
    if (other_height > height) top = other;
    height = std::max(height, other_height);
  }
  for (std::uint32_t from = top;; from = top) {
    // To the highest neighbour. Heights only grow, so no vertex comes twice
    for (std::uint32_t i = hull.first_neighbour[from];
         i < hull.first_neighbour[from + 1]; ++i) {
      const Real other = glm::dot(hull.vertices[hull.neighbours[i]], direction);
      if (other > height) top = hull.neighbours[i];
      height = std::max(height, other);
    }
    if (top == from) return top;
  }
}

Convex convex(const Shape& shape) {
  return std::visit(
      []<class S>(const S& s) {
        Real radius = 0;
        if constexpr (std::is_same_v<S, Sphere> || std::is_same_v<S, Capsule>)
          radius = s.radius;
        return Convex{&s, core_support<S>, radius, reach(s)};
      },
      shape);
}

Bounds bounds(const Shape& shape, const Pose& pose) {
  if (std::holds_alternative<HalfSpace>(shape))
    return {Vec3(-k_infinity), Vec3(k_infinity)};
  const Convex body = convex(shape);
  Bounds box{};
  std::uint32_t hint = 0;
  for (int i = 0; i < 3; ++i) {
    Vec3 axis(0);
    axis[i] = 1;
    const Vec3 up = direction_in_body(pose, axis);
    const Vec3 high = body.core_support(body.shape, up, hint);
    const Vec3 low = body.core_support(body.shape, -up, hint);
    box.high[i] = point_in_world(pose, high)[i] + body.radius;
    box.low[i] = point_in_world(pose, low)[i] - body.radius;
  }
  return box;
}

Real volume(const Shape& shape) {
  struct Volume {
    Real operator()(const Sphere& s) const { return sphere_volume(s.radius); }
    Real operator()(const Box& s) const { return box_volume(Real(2) * s.half_extents); }
    Real operator()(const Ellipsoid& s) const { return ellipsoid_volume(s.semi_axes); }
    Real operator()(const Capsule& s) const {
      return capsule_volume(s.radius, s.height);
    }
    Real operator()(const Cylinder& s) const {
      return cylinder_volume(s.radius, s.height);
    }
    Real operator()(const Cone& s) const { return cone_volume(s.radius, s.height); }
    Real operator()(const HalfSpace&) const { return k_infinity; }
    Real operator()(const HullShape& s) const { return s.volume; }
  };
  return std::visit(Volume{}, shape);
}

}  // namespace timestep::inline TIMESTEP_PRECISION
