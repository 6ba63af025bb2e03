#include "tests/truth/geom_pairs.hpp"

#include "common/graphics/input_error.hpp"
#include "tests/truth/inputs.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using chapter_04::PlacedPair;
using chapter_04::PlacedShape;
using truth::Json;

Real length(const Json& inputs, const char* name) {
  return Real(truth::not_negative(inputs, name));
}

Pose pose(const Json& inputs, const char* position, const char* orientation) {
  const Vec3 at(truth::vector(inputs, position));
  if (orientation == nullptr) return {at};
  const Json& q = inputs.at(orientation);
  if (!q.is_array() || q.size() != 4) throw InputError("q: must be four numbers");
  const glm::dquat turn(q[0].get<double>(), q[1].get<double>(), q[2].get<double>(),
                        q[3].get<double>());
  if (!(glm::length(turn) > 0)) throw InputError("q: must not be zero");
  return {at, Quat(glm::normalize(turn))};
}

PlacedShape placed(const Shape& shape, const Pose& pose) {
  return {shape, pose, {}, {}};
}

PlacedShape sphere(const Json& inputs, const char* radius, const char* centre) {
  return placed(Sphere{length(inputs, radius)}, pose(inputs, centre, nullptr));
}

PlacedShape box(const Json& inputs, const char* orientation) {
  const Vec3 half_extents(truth::vector(inputs, "half_extents"));
  return placed(Box{half_extents}, pose(inputs, "box_center", orientation));
}

PlacedShape cylinder(const Json& inputs) {
  const Real radius = length(inputs, "cyl_radius");
  return placed(Cylinder{radius, 2 * length(inputs, "half_length")},
                pose(inputs, "cyl_center", "cyl_q"));
}

PlacedShape capsule(const Json& inputs, const char* from, const char* to,
                    const char* radius) {
  return chapter_04::placed_capsule(truth::vector(inputs, from),
                                    truth::vector(inputs, to),
                                    truth::not_negative(inputs, radius));
}

// Beside a plane; the cone's centre is half way up
PlacedShape any_shape(const Json& inputs) {
  const std::string name = inputs.at("shape");
  Pose at = pose(inputs, "center", "q");
  if (name == "box")
    return placed(Box{Vec3(truth::vector(inputs, "half_extents"))}, at);
  if (name == "ellipsoid")
    return placed(Ellipsoid{Vec3(truth::vector(inputs, "semi_axes"))}, at);
  const Real radius = length(inputs, "radius");
  if (name == "sphere") return placed(Sphere{radius}, at);
  const Real half = length(inputs, "half_length");
  if (name == "capsule") return placed(Capsule{radius, 2 * half}, at);
  if (name == "cylinder") return placed(Cylinder{radius, 2 * half}, at);
  if (name != "cone") throw truth::NotCovered("shape: " + name);
  at.position = point_in_world(at, {0, 0, -half});
  return placed(Cone{radius, 2 * half}, at);
}

PlacedShape plane(const Json& inputs) {
  const glm::dvec3 normal = truth::vector(inputs, "plane_normal");
  const double size = glm::length(normal);
  if (!(size > 0)) throw InputError("plane_normal: must not be zero");
  return placed(
      HalfSpace{Vec3(normal / size), Real(truth::number(inputs, "plane_offset"))}, {});
}

}  // namespace

PlacedPair pair_of(const std::string& kind, const Json& inputs) {
  if (kind == "geom_sphere_sphere")
    return {sphere(inputs, "radius_a", "center_a"),
            sphere(inputs, "radius_b", "center_b")};
  if (kind == "geom_sphere_box")
    return {sphere(inputs, "sphere_radius", "sphere_center"), box(inputs, "box_q")};
  if (kind == "geom_capsule_capsule")
    return {capsule(inputs, "a0", "a1", "radius_a"),
            capsule(inputs, "b0", "b1", "radius_b")};
  if (kind == "geom_capsule_box")
    return {capsule(inputs, "a0", "a1", "radius"), box(inputs, nullptr)};
  if (kind == "geom_plane") return {any_shape(inputs), plane(inputs)};
  if (kind == "geom_sphere_cylinder")
    return {sphere(inputs, "sphere_radius", "sphere_center"), cylinder(inputs)};
  if (kind == "geom_cylinder_box") return {cylinder(inputs), box(inputs, "box_q")};
  return chapter_04::read_pair(kind, inputs);
}

}  // namespace timestep::inline TIMESTEP_PRECISION
