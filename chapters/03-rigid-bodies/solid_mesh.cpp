#include "chapters/03-rigid-bodies/solid_mesh.hpp"

#include <cmath>

#include <fmt/format.h>

#include "common/graphics/input_error.hpp"
#include "common/graphics/resource_manager.hpp"
#include "common/physics/mesh_mass.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_03 {
namespace {

std::vector<Vec3> vertices_of(const MeshData& mesh) {
  return {mesh.positions.begin(), mesh.positions.end()};
}

// Whether the normals point to the side from which the triangles are seen
bool normals_agree(const MeshData& mesh) {
  float sum = 0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const glm::vec3& a = mesh.positions[i];
    const glm::vec3 face = glm::cross(mesh.positions[j] - a, mesh.positions[k] - a);
    sum += glm::dot(face, mesh.normals[i] + mesh.normals[j] + mesh.normals[k]);
  }
  return sum >= 0;
}

void turn_inside_out(MeshData& mesh) {
  mesh.triangles = flipped(mesh.triangles);
  if (mesh.normals.empty() || normals_agree(mesh)) return;
  for (glm::vec3& normal : mesh.normals) normal = -normal;
}

void refuse_faults(const std::string& name, const MeshData& mesh) {
  const std::string fault = mesh_fault(vertices_of(mesh), mesh.triangles);
  if (fault.empty()) return;
  const bool turn_helps = fault.starts_with("inside out");
  throw InputError(
      fmt::format("{}: {}{}", name, fault, turn_helps ? "; try --fix-winding" : ""));
}

// What moving a body divides by its mass and moments must be a number
void refuse_extremes(const std::string& name, Real mass, const Vec3& moments) {
  if (std::isnormal(mass) && std::isnormal(moments.x) && std::isnormal(moments.z)
      && moments.x > 0)
    return;
  throw InputError(fmt::format(
      "{}: {:.3g} kg with a least moment of {:.3g} kg m²: too small, large or thin",
      name, mass, moments.x));
}

// From the file's frame to the body's
void move_to_body(MeshData& mesh, const Vec3& centre, const Quat& file_from_body) {
  const Quat body_from_file = glm::conjugate(file_from_body);
  for (glm::vec3& p : mesh.positions) p = body_from_file * (Vec3(p) - centre);
  for (glm::vec3& n : mesh.normals) n = body_from_file * Vec3(n);
}

}  // namespace

SolidMesh load_solid(const std::filesystem::path& file, double density,
                     bool fix_winding) {
  const std::filesystem::path found = find_asset("meshes", file);
  const std::string name = "mesh " + found.string();
  MeshData mesh = load_mesh(found);
  SolidMesh solid{};
  if (fix_winding && mesh_volume(vertices_of(mesh), mesh.triangles) < 0) {
    turn_inside_out(mesh);
    solid.notices.push_back(name + ": was inside out, its triangles are turned");
  }
  refuse_faults(name, mesh);

  // (3.10), (3.11)
  solid.properties = mesh_mass(Real(density), vertices_of(mesh), mesh.triangles);
  const auto [moments, A] = principal_axes(solid.properties.inertia);
  refuse_extremes(name, solid.properties.mass, moments);
  solid.moments = moments;
  solid.file_from_body = glm::normalize(glm::quat_cast(A));
  move_to_body(mesh, solid.properties.centre_of_mass, solid.file_from_body);
  solid.mesh = std::make_shared<const MeshData>(std::move(mesh));
  return solid;
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_03
