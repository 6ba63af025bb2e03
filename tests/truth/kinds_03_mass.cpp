// The kinds of chapter 3 about mass properties, computed through the code in
// common/physics.
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "common/graphics/input_error.hpp"
#include "common/physics/mesh_mass.hpp"
#include "tests/truth/inputs.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using truth::Json;
using truth::Kind;

Json json(const Vec3& v) {
  return {double(v.x), double(v.y), double(v.z)};
}

Json json(const Mat3& m) {
  return {json(m[0]), json(m[1]), json(m[2])};
}

struct Solid {
  MassProperties properties;
  Real volume;
};

Solid box_or_ellipsoid(const Json& inputs, const std::string& shape, Real mass) {
  if (shape == "box") {
    const Vec3 size(truth::vector(inputs, "size"));
    return {solid_box(mass, size), box_volume(size)};
  }
  const Vec3 semi_axes(truth::vector(inputs, "semi_axes"));
  return {solid_ellipsoid(mass, semi_axes), ellipsoid_volume(semi_axes)};
}

// Those of one size, or of two
Solid turned_solid(const Json& inputs, const std::string& shape, Real mass) {
  const auto length = [&](const char* name) {
    return Real(truth::not_negative(inputs, name));
  };
  if (shape == "rod") return {thin_rod(mass, length("length")), 0};
  if (shape == "torus") {
    const Real R = length("major_radius"), r = length("minor_radius");
    return {solid_torus(mass, R, r), torus_volume(R, r)};
  }
  if (shape == "hollow_cylinder") {
    const Real a = length("inner_radius"), b = length("outer_radius");
    const Real h = length("height");
    return {hollow_cylinder(mass, a, b, h), hollow_cylinder_volume(a, b, h)};
  }
  const Real r = length("radius");
  if (shape == "sphere") return {solid_sphere(mass, r), sphere_volume(r)};
  if (shape == "sphere_shell") return {spherical_shell(mass, r), sphere_volume(r)};
  const Real h = length("height");
  if (shape == "cylinder") return {solid_cylinder(mass, r, h), cylinder_volume(r, h)};
  if (shape == "capsule") return {solid_capsule(mass, r, h), capsule_volume(r, h)};
  if (shape == "cone") return {solid_cone(mass, r, h), cone_volume(r, h)};
  throw truth::NotCovered("shape: " + shape);
}

Json inertia_primitive(const Json& inputs) {
  const std::string shape = inputs.at("shape");
  const Real mass = Real(truth::positive(inputs, "mass"));
  const auto [properties, volume] = shape == "box" || shape == "ellipsoid"
                                        ? box_or_ellipsoid(inputs, shape, mass)
                                        : turned_solid(inputs, shape, mass);
  const Mat3& I = properties.inertia;
  return {{"volume", double(volume)},
          {"center_of_mass", json(properties.centre_of_mass)},
          {"inertia_diag_about_com", json(Vec3(I[0][0], I[1][1], I[2][2]))}};
}

std::array<double, 3> three(const Json& list, const char* name) {
  const glm::dvec3 v = truth::vector({{name, list}}, name);
  return {v.x, v.y, v.z};
}

std::vector<Vec3> vertices_of(const Json& inputs) {
  std::vector<Vec3> vertices;
  for (const Json& vertex : inputs.at("vertices")) {
    const auto [x, y, z] = three(vertex, "vertices");
    vertices.emplace_back(Real(x), Real(y), Real(z));
  }
  return vertices;
}

std::vector<Triangle> triangles_of(const Json& inputs) {
  const auto vertices = static_cast<double>(inputs.at("vertices").size());
  if (inputs.at("triangles").empty()) throw InputError("triangles: there are none");
  std::vector<Triangle> triangles;
  for (const Json& corners : inputs.at("triangles")) {
    Triangle& triangle = triangles.emplace_back();
    const auto indices = three(corners, "triangles");
    for (std::size_t k = 0; k < 3; ++k) {
      const double index = indices[k];
      if (!(index >= 0 && index < vertices) || index != std::floor(index))
        throw InputError("triangles: must be indices of vertices");
      triangle[k] = static_cast<std::uint32_t>(index);
    }
  }
  return triangles;
}

Json mesh_mass_properties(const Json& inputs) {
  const std::vector<Vec3> vertices = vertices_of(inputs);
  const std::vector<Triangle> triangles = triangles_of(inputs);
  const Real density = Real(truth::positive(inputs, "density"));
  const Real volume = mesh_volume(vertices, triangles);
  if (!(volume > 0)) throw truth::NotCovered("no volume in this precision");

  const MassProperties body = mesh_mass(density, vertices, triangles);
  return {{"volume", double(volume)},
          {"mass", double(body.mass)},
          {"center_of_mass", json(body.centre_of_mass)},
          {"inertia_about_com", json(body.inertia)},
          {"inertia_about_origin", json(inertia_about(body, Vec3(0)))},
          {"principal_moments", json(principal_axes(body.inertia).moments)},
          {"surface_area", double(surface_area(vertices, triangles))}};
}

}  // namespace

std::span<const Kind> truth_kinds_03_mass() {
  static constexpr std::array<Kind, 2> kinds{{
      {"inertia_primitive", inertia_primitive},
      {"mesh_mass_properties", mesh_mass_properties},
  }};
  return kinds;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
